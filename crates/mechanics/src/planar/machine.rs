//! A mechanism as a problem of motion: the state is what its plan keeps of the positions, and the velocities in the
//! columns that the plan leaves free; all other velocities follow from these.

mod friction;

pub(super) use self::friction::NOISE;
use super::{
    Contact, PlanarError, State, System,
    friction::Friction,
    plan::{Conditioning, Layout, Order, Work},
    vectors::body_that_moves_most,
};
use dalembert_numerics::ode::Problem;

/// Joints are closed to this part of the size of the mechanism, its rounding; near a singular position, where to
/// correct what is rounding alone would move the mechanism far, to the second …
const CLOSED: f64 = 2.0 * f64::EPSILON;
const CLOSED_WHERE_SINGULAR: f64 = 32.0 * f64::EPSILON;
/// … or, if so many rounds of Newton's method do not come to it, at least to this part.
const ROUNDS: usize = 6;
const ALMOST: f64 = 1e-12;
/// A correction of a step beyond this part of the size, or beyond so many times its tolerance, would be a jump.
const JUMP: f64 = 1e-5;
const JUMPS: f64 = 100.0;
/// Rounding error of positions and velocities near a singular position, relative to the square of the pivot ratio.
/// Along a row of loops it adds up; so much of it for each, and at most the second, is let through: shorter steps would
/// only come closer.
const ROUNDING: f64 = 4.0;
const MOST_WHERE_SINGULAR: f64 = 1e-9;
/// Below this part of what it was, a pivot leaves too little of a moment that is shown.
const UNSAFE: f64 = 0.01;
/// Step, as a fraction of the size, at which the Jacobian is evaluated to extrapolate where its rows vanish.
const AHEAD: f64 = 1e-5;
/// The tolerance of a step that went where the order of elimination is of no use.
const NOTHING: f64 = 1e-60;
/// Orders of elimination that are remembered.
const REMEMBERED: usize = 16;
/// A diagonal of the reduced masses below this part of what it began with has lost its inertia.
const MASSLESS: f64 = 1e-13;

pub(super) struct Machine<'a> {
    system: &'a System,
    layout: Layout,
    orders: Vec<Order>,
    /// The order in use.
    now: usize,
    work: Work,
    /// The kept coordinates that the work stands for.
    set: Vec<f64>,
    /// True once the Jacobian of the work arrays is eliminated.
    eliminated: bool,
    masses: Vec<f64>,
    /// Velocities of the bodies and the ground.
    velocities: Vec<[f64; 3]>,
    forces: Vec<[f64; 3]>,
    right: Vec<f64>,
    held: Vec<f64>,
    scaled: Vec<f64>,
    motions: Vec<Vec<f64>>,
    reduced: Vec<f64>,
    driving: Vec<f64>,
    multipliers: Vec<f64>,
    frictions: Vec<Friction>,
    /// Contact state of each joint with friction, until one of its margins is used up.
    contacts: Vec<Contact>,
    /// Reason for which the last rates are not finite, if friction is the cause.
    jammed: Option<PlanarError>,
    /// True if the work of non-conservative loads and of drivers is integrated.
    pub(super) has_work: bool,
    tolerance: f64,
    /// Worst conditioning of the pivot orders since the last step.
    conditioning: Conditioning,
    /// The smallest part of what it was to which a pivot has fallen since the last step.
    weakest: f64,
    /// The fastest free velocity so far.
    fastest: f64,
    cancelled: &'a dyn Fn() -> bool,
}

impl<'a> Machine<'a> {
    /// A mechanism in closed positions.
    pub(super) fn new(
        system: &'a System,
        positions: &[[f64; 3]],
        tolerance: f64,
        cancelled: &'a dyn Fn() -> bool,
    ) -> Self {
        let layout = Layout::new(system);
        let work = layout.work(system);
        let (bodies, rows) = (positions.len(), system.equations.len());
        let spends = |load: &super::Load| match load {
            super::Load::Force { turns_with, .. } => turns_with.is_some(),
            super::Load::Effort { effort, .. } => !effort.is_stored(),
            super::Load::Friction { .. } => true,
        };
        let has_work = !system.mechanism.drivers.is_empty() || system.mechanism.loads.iter().any(spends);
        let mut machine = Self {
            system,
            orders: Vec::new(),
            now: 0,
            work,
            set: Vec::new(),
            eliminated: false,
            masses: system.scaled_masses(),
            velocities: vec![[0.0; 3]; bodies + 1],
            forces: vec![[0.0; 3]; bodies],
            right: vec![0.0; rows],
            held: vec![0.0; 3 * bodies],
            scaled: vec![0.0; 3 * bodies],
            motions: Vec::new(),
            reduced: Vec::new(),
            driving: Vec::new(),
            multipliers: vec![0.0; rows],
            frictions: system.frictional_joints(),
            contacts: Vec::new(),
            jammed: None,
            has_work,
            tolerance,
            conditioning: Conditioning::Regular,
            weakest: 1.0,
            fastest: 0.0,
            cancelled,
            layout,
        };
        let kept: Vec<f64> =
            machine.layout.kept.iter().map(|&column| system.scaled(column, positions)).collect();
        machine.place(&kept);
        machine.order();
        machine
    }

    /// The scaled velocities at the start that the drivers give when the free columns rest, and those that are free.
    pub(super) fn degrees_of_freedom(&mut self) -> (Vec<f64>, Vec<Vec<f64>>) {
        self.drive(0.0);
        self.eliminate();
        self.velocities(0.0, &vec![0.0; self.motions.len()]);
        (self.scaled.clone(), self.motions.clone())
    }

    /// The state of positions and velocities.
    pub(super) fn state(&self, positions: &[[f64; 3]], velocities: &[[f64; 3]], work: f64) -> Vec<f64> {
        let kept = self.layout.kept.iter().map(|&column| self.system.scaled(column, positions));
        let free = self.orders[self.now].free.iter().map(|&column| self.system.scaled(column, velocities));
        kept.chain(free).chain(self.has_work.then_some(work)).collect()
    }

    /// Positions, velocities and accelerations of a state, brought onto the joints.
    pub(super) fn full(&mut self, time: f64, state: &[f64]) -> Option<(State, f64)> {
        let mut state = state.to_vec();
        let mut rates = vec![0.0; state.len()];
        if !self.settle(time, &mut state) {
            return None;
        }
        self.rates(time, &state, &mut rates);
        let of_pose = |pose: &super::Pose<f64>| [pose.x, pose.y, pose.angle];
        let bodies = self.masses.len() / 3;
        let positions = self.work.poses[..bodies].iter().map(of_pose).collect();
        let accelerations = self.system.unscaled(&self.held);
        let velocities = self.velocities[..bodies].to_vec();
        let full = State { positions, velocities, accelerations };
        let finite = rates.iter().all(|x| x.is_finite());
        let work = if self.has_work { state[state.len() - 1] } else { 0.0 };
        finite.then_some((full, work))
    }

    /// Returns true if a state is so close to a singular position that the velocities derived from it are rounding
    /// noise.
    pub(super) fn is_singular(&mut self, time: f64, state: &[f64]) -> bool {
        self.drive(time);
        self.place(&state[..self.layout.kept.len()]);
        self.eliminate();
        let order = &self.orders[self.now];
        order.weakest() < UNSAFE && order.conditioning() == Conditioning::NearSingular
    }

    /// The kinetic energy and the energy stored in loads in the state that was last made full.
    pub(super) fn energies(&self) -> [f64; 2] {
        let length = self.system.length;
        let of_body = |(masses, v): (&[f64], &[f64; 3])| {
            let turn = v[2] * length;
            0.5 * (masses[0] * (v[0] * v[0] + v[1] * v[1]) + masses[2] * turn * turn)
        };
        let kinetic = self.masses.chunks_exact(3).zip(&self.velocities).map(of_body).sum();
        [kinetic, self.system.stored(&self.work.poses)]
    }

    /// The value of a measure and its rate, in a state that need not be settled.
    pub(super) fn measured(&mut self, measure: &super::Measure, time: f64, state: &[f64]) -> [f64; 2] {
        let mut rates = vec![0.0; state.len()];
        self.rates(time, state, &mut rates);
        let poses = &self.work.poses;
        let gradient = super::system::gradient(measure, poses);
        [gradient.value, super::system::project(measure, &gradient, &self.velocities)]
    }

    /// Another order of elimination with the state that it asks for, if the present one has become weak.
    pub(super) fn renewed(&mut self, time: f64, state: &[f64]) -> Option<Vec<f64>> {
        let kept = self.layout.kept.len();
        self.place(&state[..kept]);
        self.eliminate();
        if !self.orders[self.now].is_weak(&self.layout, &self.work.jacobian) {
            return None;
        }
        let (full, work) = self.full(time, state)?;
        self.order();
        Some(self.state(&full.positions, &full.velocities, work))
    }

    /// Takes a remembered order that suits the position, or makes one.
    fn order(&mut self) {
        for index in 0..self.orders.len() {
            self.orders[index].eliminate(&self.work.jacobian);
            if !self.orders[index].is_weak(&self.layout, &self.work.jacobian) {
                self.take(index);
                return;
            }
        }
        let order = Order::new(&self.layout, &self.work.jacobian, self.masses.len());
        if self.orders.len() == REMEMBERED {
            self.orders.remove(0);
        }
        self.orders.push(order);
        self.take(self.orders.len() - 1);
    }

    fn take(&mut self, index: usize) {
        self.now = index;
        self.eliminated = false;
        let free = self.orders[index].free.len();
        self.motions.resize_with(free, Vec::new);
        for motion in &mut self.motions {
            motion.resize(self.masses.len(), 0.0);
        }
        self.reduced.resize(free * free, 0.0);
        self.driving.resize(free, 0.0);
    }

    fn place(&mut self, kept: &[f64]) {
        if self.set != kept {
            self.layout.set(kept, &mut self.work);
            self.layout.measure(&mut self.work);
            self.set.clear();
            self.set.extend_from_slice(kept);
            self.eliminated = false;
        }
    }

    fn eliminate(&mut self) {
        if !self.eliminated {
            let order = &mut self.orders[self.now];
            order.eliminate(&self.work.jacobian);
            self.eliminated = true;
            self.conditioning = self.conditioning.max(order.conditioning());
            self.weakest = self.weakest.min(order.weakest());
        }
    }

    /// The constants of the drivers at a time.
    fn drive(&mut self, time: f64) {
        let first = self.system.first_driver();
        for (sum, driver) in self.work.sums[first..].iter_mut().zip(&self.system.mechanism.drivers) {
            let now = driver.value + time * (driver.velocity + time * driver.acceleration / 2.0);
            if *sum != now {
                *sum = now;
                self.set.clear();
            }
        }
    }

    /// Velocities of all bodies from those of the free columns.
    fn velocities(&mut self, time: f64, free: &[f64]) {
        let order = &self.orders[self.now];
        let drivers = &self.system.mechanism.drivers;
        if drivers.is_empty() {
            self.scaled.fill(0.0);
        } else {
            let first = self.system.first_driver();
            self.right.fill(0.0);
            for (right, driver) in self.right[first..].iter_mut().zip(drivers) {
                *right = driver.velocity + time * driver.acceleration;
            }
            order.solve(&mut self.right, &mut self.scaled);
        }
        for (index, (motion, rate)) in self.motions.iter_mut().zip(free).enumerate() {
            order.motion(index, motion);
            for (v, n) in self.scaled.iter_mut().zip(&*motion) {
                *v += n * rate;
            }
        }
        self.system.unscale(&self.scaled, &mut self.velocities);
    }

    /// The accelerations, to `held`; those of the free columns, to `driving`. False without inertia.
    fn accelerate(&mut self) -> f64 {
        self.layout.bend(&self.work, &self.velocities, &mut self.right);
        let first = self.system.first_driver();
        for (right, driver) in self.right[first..].iter_mut().zip(&self.system.mechanism.drivers) {
            *right += driver.acceleration;
        }
        self.orders[self.now].solve(&mut self.right, &mut self.held);
        let power = self.system.forces(&self.work.poses, &self.velocities, &mut self.forces);
        let per_length = 1.0 / self.system.length;
        for (scaled, force) in self.scaled.chunks_exact_mut(3).zip(&self.forces) {
            scaled.copy_from_slice(&[force[0], force[1], force[2] * per_length]);
        }
        let free = self.motions.len();
        for row in 0..free {
            let motion = &self.motions[row];
            let mut driving = 0.0;
            for (((n, load), mass), a) in motion.iter().zip(&self.scaled).zip(&self.masses).zip(&self.held) {
                driving += n * (load - mass * a);
            }
            self.driving[row] = driving;
            for column in 0..=row {
                let mut sum = 0.0;
                for ((a, b), mass) in motion.iter().zip(&self.motions[column]).zip(&self.masses) {
                    sum += a * b * mass;
                }
                self.reduced[row * free + column] = sum;
            }
        }
        if factor_positive(&mut self.reduced, free) {
            substitute(&self.reduced, &mut self.driving);
        } else {
            self.driving.fill(f64::NAN);
        }
        for (motion, s) in self.motions.iter().zip(&self.driving) {
            for (a, n) in self.held.iter_mut().zip(motion) {
                *a += n * s;
            }
        }
        let driven = !self.system.mechanism.drivers.is_empty();
        if driven || self.has_friction() {
            for ((g, a), mass) in self.scaled.iter_mut().zip(&self.held).zip(&self.masses) {
                *g = mass * a - *g;
            }
            self.orders[self.now].multipliers(&mut self.scaled, &mut self.multipliers);
        }
        if self.contacts.is_empty() { power } else { power + self.apply_friction() }
    }

    /// The power of the drivers, with the multipliers just found.
    fn driven_power(&self, time: f64) -> f64 {
        let drivers = &self.system.mechanism.drivers;
        let efforts = &self.multipliers[self.system.first_driver()..];
        let power = |(effort, driver): (&f64, &super::Driver)| {
            effort * (driver.velocity + time * driver.acceleration)
        };
        efforts.iter().zip(drivers).map(power).sum()
    }

    /// Error for a start from which the mechanism cannot move.
    pub(super) fn refusal(&self) -> PlanarError {
        let massless = self.motions.iter().find(|motion| {
            let inertia: f64 = motion.iter().zip(&self.masses).map(|(n, mass)| n * n * mass).sum();
            inertia == 0.0
        });
        massless.map_or(PlanarError::NotFinite, |motion| PlanarError::Massless {
            body: body_that_moves_most(motion),
        })
    }

    /// Sets the size of velocities from those of the start and from what the accelerations can make of the size of
    /// the mechanism.
    pub(super) fn begin(&mut self, state: &[f64]) {
        let kept = self.layout.kept.len();
        let mut rates = vec![0.0; state.len()];
        self.rates(0.0, state, &mut rates);
        let most = |x: &[f64]| x.iter().fold(0.0f64, |most, x| most.max(x.abs()));
        let free = kept..kept + self.motions.len();
        let fastest = most(&state[free.clone()]).max((most(&rates[free]) * self.system.length).sqrt());
        self.fastest = if fastest > 0.0 { fastest } else { self.system.length };
    }
}

impl Problem for Machine<'_> {
    fn rates(&mut self, time: f64, state: &[f64], rates: &mut [f64]) {
        let kept = self.layout.kept.len();
        let free = kept..kept + self.motions.len();
        self.drive(time);
        self.place(&state[..kept]);
        self.eliminate();
        self.velocities(time, &state[free.clone()]);
        for (rate, &column) in rates.iter_mut().zip(&self.layout.kept) {
            *rate = self.scaled[column];
        }
        let power = self.accelerate();
        rates[free].copy_from_slice(&self.driving);
        if self.has_work {
            rates[state.len() - 1] = power + self.driven_power(time);
        }
    }

    fn allowed(&mut self, before: &[f64], after: &[f64], allowed: &mut [f64]) {
        let kept = self.layout.kept.len();
        let free = kept..kept + self.motions.len();
        let weakest = std::mem::replace(&mut self.weakest, 1.0);
        let tolerance = match std::mem::replace(&mut self.conditioning, Conditioning::Regular) {
            Conditioning::Regular => self.tolerance,
            Conditioning::NearSingular => {
                let loops = self.layout.loops().len() as f64;
                let rounding = ROUNDING * loops * f64::EPSILON / weakest.powi(2);
                self.tolerance.max(rounding.min(MOST_WHERE_SINGULAR))
            }
            // A shorter step comes to where another order is taken.
            Conditioning::Singular => NOTHING,
        };
        allowed[..kept].fill(tolerance * self.system.length);
        let ends = before[free.clone()].iter().chain(&after[free.clone()]);
        let fastest = ends.fold(self.fastest, |most, v| most.max(v.abs()));
        allowed[free].fill(tolerance * fastest);
        if self.has_work {
            allowed[before.len() - 1] = f64::INFINITY;
        }
    }

    fn settle(&mut self, time: f64, state: &mut [f64]) -> bool {
        let kept = self.layout.kept.len();
        let length = self.system.length;
        self.drive(time);
        let mut last = f64::INFINITY;
        for round in 0..=ROUNDS {
            self.place(&state[..kept]);
            let residual = self.layout.open(&self.work);
            if residual.is_nan() {
                return false;
            }
            let stays = residual <= ALMOST * length && residual > 0.3 * last;
            if residual <= CLOSED * length || stays || round == ROUNDS {
                return residual <= ALMOST * length;
            }
            last = residual;
            self.eliminate();
            if residual <= CLOSED_WHERE_SINGULAR * length
                && self.orders[self.now].conditioning() == Conditioning::NearSingular
            {
                return true;
            }
            self.right.fill(0.0);
            for &row in self.layout.loops() {
                self.right[row] = self.work.residuals[row];
            }
            self.orders[self.now].solve(&mut self.right, &mut self.scaled);
            let mut size = 0.0f64;
            for (x, &column) in state.iter_mut().zip(&self.layout.kept) {
                *x -= self.scaled[column];
                size = size.max(self.scaled[column].abs());
            }
            if size.is_nan() || size > JUMP.max(JUMPS * self.tolerance) * length {
                return false;
            }
        }
        false
    }

    fn singular(&mut self, time: f64, state: &[f64], rates: &[f64]) -> [f64; 2] {
        let kept = self.layout.kept.len();
        let fastest = rates[..kept].iter().fold(0.0f64, |most, rate| most.max(rate.abs()));
        if !self.orders[self.now].falls() || fastest == 0.0 {
            return [f64::INFINITY; 2];
        }
        let before = self.orders[self.now].rows_left();
        let ahead = AHEAD * self.system.length / fastest;
        let moved: Vec<f64> = state.iter().zip(&rates[..kept]).map(|(x, rate)| x + ahead * rate).collect();
        self.drive(time + ahead);
        self.place(&moved);
        self.eliminate();
        let after = self.orders[self.now].rows_left();
        self.orders[self.now].vanish(&before, &after).map(|steps| steps * ahead)
    }

    fn stopped(&self) -> bool {
        (self.cancelled)()
    }
}

/// Factors a symmetric positive definite H, given in its lower triangle, in place (Cholesky); false if it is not.
fn factor_positive(h: &mut [f64], n: usize) -> bool {
    for j in 0..n {
        let diagonal = h[j * n + j];
        let mut pivot = diagonal;
        for k in 0..j {
            pivot -= h[j * n + k] * h[j * n + k];
        }
        if pivot.is_nan() || pivot <= MASSLESS * diagonal {
            return false;
        }
        let root = pivot.sqrt();
        h[j * n + j] = root;
        for i in j + 1..n {
            let mut sum = h[i * n + j];
            for k in 0..j {
                sum -= h[i * n + k] * h[j * n + k];
            }
            h[i * n + j] = sum / root;
        }
    }
    true
}

/// Solves `H x = b` with the factors of H, in place.
fn substitute(h: &[f64], x: &mut [f64]) {
    let n = x.len();
    for j in 0..n {
        for k in 0..j {
            x[j] -= h[j * n + k] * x[k];
        }
        x[j] /= h[j * n + j];
    }
    for j in (0..n).rev() {
        for k in j + 1..n {
            x[j] -= h[k * n + j] * x[k];
        }
        x[j] /= h[j * n + j];
    }
}
