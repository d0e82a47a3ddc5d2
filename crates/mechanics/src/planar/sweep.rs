//! A driven mechanism compiled for many positions: a cycle of an engine, a curve of a coupler, a plot.
//!
//! The positions are followed as [`System::follow`] does it, with velocities, accelerations and every reaction, but
//! on the [plan](super::plan) of the mechanism, and many parts of the way side by side in the registers of the
//! machine. Where the plan does not lead on, near a dead centre or a limit, or does not serve, with friction or
//! redundant joints, the general way takes over; the results are the same.

#![expect(clippy::inline_always, reason = "what is not inlined is not compiled for the widest registers")]

use super::{
    Load, PlanarError, Pose, State, System,
    plan::{Core, Layout, Order, Work},
};
use crate::lanes::{Lanes, Numbers, WIDTH, widest};

/// The largest move of one step, in parts of the size of the mechanism.
const STEP: f64 = 0.2;
/// The smallest step, in parts of the way between two positions.
const SMALLEST: f64 = 1e-3;
/// A correction above this part of the step is a jump.
const JUMP: f64 = 0.1;
/// A correction below this part of the step stays on the smooth path, even where two branches cross.
const SMOOTH: f64 = 2e-3;
/// Rounds of Newton's method for a step.
const ROUNDS: usize = 8;
/// Joints are closed to this part of the size of the mechanism, or at least to the second.
const CLOSED: f64 = 4.0 * f64::EPSILON;
const ALMOST: f64 = 1e-13;
/// A position whose equations are nearer to singular than this is left to the general way.
const SINGULAR: f64 = 1e-9;
/// So many equations that are not explicit are eliminated as a full matrix at most.
const MOST_LOOPS: usize = 12;
/// Shorter sweeps are not divided.
const UNDIVIDED: usize = 4 * WIDTH;

/// Positions that a mechanism takes, one for each value of the driver, with what it is like there.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Swept {
    /// How many bodies there are.
    bodies: usize,
    /// How many equations there are.
    equations: usize,
    positions: Vec<[f64; 3]>,
    velocities: Vec<[f64; 3]>,
    accelerations: Vec<[f64; 3]>,
    multipliers: Vec<f64>,
    efforts: Vec<f64>,
    reached: usize,
}

/// A mechanism and its plan for the values of one of its drivers.
#[derive(Debug, Clone)]
pub struct Sweep<'a> {
    system: &'a System,
    /// Where it begins.
    positions: Vec<[f64; 3]>,
    driver: usize,
    /// The value of the driver there.
    value: f64,
    plan: Option<Plan>,
}

#[derive(Debug, Clone)]
struct Plan {
    layout: Layout,
    /// What is left of the rows that are not explicit: places and numbers of kept coordinates.
    loops: Vec<Vec<(usize, usize)>>,
    masses: Vec<f64>,
    start: Vec<f64>,
    one: Station<f64>,
    many: Station<Lanes>,
}

/// The numbers of one position, or of several side by side.
#[derive(Debug, Clone)]
struct Station<S> {
    order: Order<S>,
    core: Core<S>,
    work: Work<S>,
    /// The value of the driver and the kept coordinates …
    value: S,
    kept: Vec<S>,
    /// … and those from which a step began.
    before: Vec<S>,
    /// How the scaled coordinates change with the value of the driver: first and second derivative, and of the kept
    /// ones the third about.
    first: Vec<S>,
    second: Vec<S>,
    third: Vec<S>,
    /// The largest first derivative.
    fast: S,
    /// The last diagonal of the factored matrix: its sign tells the branch.
    side: S,
    right: Vec<S>,
    inner: Vec<S>,
    velocities: Vec<[S; 3]>,
    accelerations: Vec<S>,
    forces: Vec<[S; 3]>,
    balance: Vec<S>,
    multipliers: Vec<S>,
    effort: S,
}

impl System {
    /// Compiles the mechanism, closed in some positions, for the values of one of its drivers.
    ///
    /// # Errors
    /// `UnderDriven`, `OverDriven`, `DeadCentre`; `NotFinite`.
    pub fn sweep(&self, positions: &[[f64; 3]], driver: usize) -> Result<Sweep<'_>, PlanarError> {
        let elimination = self.factored(positions)?;
        let is_plain = elimination.dependent_rows().is_empty()
            && !self.mechanism.loads.iter().any(|load| matches!(load, Load::Friction { .. }));
        let plan = if is_plain { Plan::new(self, positions) } else { None };
        let value = self.value(&self.mechanism.drivers[driver].measure, positions);
        Ok(Sweep { system: self, positions: positions.to_vec(), driver, value, plan })
    }
}

impl Sweep<'_> {
    /// Takes the driver to each value in turn, from the positions that the mechanism was compiled in, at the
    /// velocities and accelerations of the drivers, the others held.
    ///
    /// # Errors
    /// As for [`System::follow`] and [`System::dynamics`]: what ended the sweep, of which the first
    /// [`reached`](Swept::reached) positions stand.
    pub fn over(&mut self, values: &[f64], swept: &mut Swept) -> Result<(), PlanarError> {
        swept.make_room(self.system, values.len());
        let mut done = 0;
        let mut here = self.positions.clone();
        if let Some(plan) = &mut self.plan {
            done = plan.over(self.system, (self.driver, self.value), values, swept);
            if done > 0 {
                here = swept.positions(done - 1).to_vec();
            }
        }
        swept.reached = done;
        let mut held: Vec<f64> = self.system.mechanism.drivers.iter().map(|driver| driver.value).collect();
        for &value in &values[done..] {
            held[self.driver] = value;
            here = self.system.follow(&here, &held)?.positions;
            let (state, dynamics) = self.system.solved(&here)?;
            swept.put(&state, &dynamics.multipliers, dynamics.efforts[self.driver]);
        }
        Ok(())
    }
}

impl Swept {
    /// How many positions were reached.
    pub fn reached(&self) -> usize {
        self.reached
    }

    /// The positions of all bodies at a value.
    pub fn positions(&self, n: usize) -> &[[f64; 3]] {
        &self.positions[n * self.bodies..(n + 1) * self.bodies]
    }

    /// Positions, velocities and accelerations at a value.
    pub fn state(&self, n: usize) -> State {
        let of = |columns: &[[f64; 3]]| columns[n * self.bodies..(n + 1) * self.bodies].to_vec();
        State {
            positions: of(&self.positions),
            velocities: of(&self.velocities),
            accelerations: of(&self.accelerations),
        }
    }

    /// The multiplier of each equation at a value, in the order of [`System::equations`], by Newton and Euler.
    pub fn multipliers(&self, n: usize) -> &[f64] {
        &self.multipliers[n * self.equations..(n + 1) * self.equations]
    }

    /// The effort of the driver that is swept, by virtual power.
    pub fn effort(&self, n: usize) -> f64 {
        self.efforts[n]
    }

    fn make_room(&mut self, system: &System, count: usize) {
        (self.bodies, self.equations) = (system.mechanism.bodies.len(), system.equations.len());
        for of_bodies in [&mut self.positions, &mut self.velocities, &mut self.accelerations] {
            of_bodies.resize(count * self.bodies, [0.0; 3]);
        }
        self.multipliers.resize(count * self.equations, 0.0);
        self.efforts.resize(count, 0.0);
        self.reached = 0;
    }

    fn put(&mut self, state: &State, multipliers: &[f64], effort: f64) {
        let n = self.reached;
        let bodies = n * self.bodies..(n + 1) * self.bodies;
        self.positions[bodies.clone()].copy_from_slice(&state.positions);
        self.velocities[bodies.clone()].copy_from_slice(&state.velocities);
        self.accelerations[bodies].copy_from_slice(&state.accelerations);
        self.multipliers[n * self.equations..(n + 1) * self.equations].copy_from_slice(multipliers);
        self.efforts[n] = effort;
        self.reached += 1;
    }
}

impl Plan {
    fn new(system: &System, positions: &[[f64; 3]]) -> Option<Self> {
        let layout = Layout::new(system);
        let columns = 3 * positions.len();
        let mut work: Work<f64> = layout.work(system);
        let scaled = |&column: &usize| {
            let value = positions[column / 3][column % 3];
            if column % 3 == 2 { value * system.length } else { value }
        };
        let start: Vec<f64> = layout.kept.iter().map(scaled).collect();
        if layout.loops().len() != start.len() || start.len() > MOST_LOOPS {
            return None;
        }
        layout.set(&start, &mut work);
        layout.measure(&mut work);
        let (_, left) = Order::<f64>::of_explicit(&layout, &work.slopes, columns);
        let number = |column: usize| layout.kept.iter().position(|kept| *kept == column);
        let mut loops = Vec::new();
        for row in left {
            let row: Option<Vec<(usize, usize)>> =
                row.into_iter().map(|(place, column)| Some((place, number(column)?))).collect();
            loops.push(row?);
        }
        let slopes = work.slopes;
        Some(Self {
            one: Station::new(system, &layout, &slopes),
            many: Station::new(system, &layout, &slopes),
            masses: system.scaled_masses(),
            layout,
            loops,
            start,
        })
    }

    /// How many positions could be had.
    fn over(
        &mut self,
        system: &System,
        (driver, from): (usize, f64),
        values: &[f64],
        swept: &mut Swept,
    ) -> usize {
        let Self { layout, loops, masses, start, one, many } = self;
        let way = Way { system, layout, loops, masses, row: system.first_driver() + driver, driver };
        if !one.begin(&way, from, |number, _| start[number]) {
            return 0;
        }
        if values.len() >= UNDIVIDED {
            let part = values.len().div_ceil(WIDTH);
            let first = |lane: usize| (lane * part).min(values.len() - 1);
            let mut anchors = vec![[0.0; WIDTH]; start.len()];
            let reached = (0..WIDTH).all(|lane| {
                let reached = one.reach(&way, values[first(lane)]);
                for (anchor, kept) in anchors.iter_mut().zip(&one.kept) {
                    anchor[lane] = *kept;
                }
                reached
            });
            let at = |lane: usize, step: usize| (first(lane) + step).min(values.len() - 1);
            let value = |step: usize| Lanes::of(|lane| values[at(lane, step)]);
            let mut steps = 0..part;
            let swept_all = reached
                && many.begin(&way, value(0), |number, lane| anchors[number][lane])
                && steps.all(|step| {
                    let good = many.reach(&way, value(step)) && many.load(&way);
                    if good {
                        many.store(&way, swept, |lane| at(lane, step));
                    }
                    good
                });
            if swept_all {
                return values.len();
            }
            one.begin(&way, from, |number, _| start[number]);
        }
        for (n, value) in values.iter().enumerate() {
            if !(one.reach(&way, *value) && one.load(&way)) {
                return n;
            }
            one.store(&way, swept, |_| n);
        }
        values.len()
    }
}

/// What does not change on the way.
#[derive(Clone, Copy)]
struct Way<'a> {
    system: &'a System,
    layout: &'a Layout,
    loops: &'a [Vec<(usize, usize)>],
    masses: &'a [f64],
    /// The equation of the driver that is swept, and the driver.
    row: usize,
    driver: usize,
}

impl<S: Numbers> Station<S> {
    fn new(system: &System, layout: &Layout, slopes: &[f64]) -> Self {
        let (bodies, rows) = (system.mechanism.bodies.len(), system.equations.len());
        let (columns, kept) = (3 * bodies, layout.kept.len());
        let zero = S::from(0.0);
        Self {
            order: Order::of_explicit(layout, slopes, columns).0,
            core: Core::new(kept),
            work: layout.work(system),
            value: zero,
            kept: vec![zero; kept],
            before: vec![zero; kept],
            first: vec![zero; columns],
            second: vec![zero; columns],
            third: vec![zero; kept],
            fast: zero,
            side: zero,
            right: vec![zero; rows],
            inner: vec![zero; kept],
            velocities: vec![[zero; 3]; bodies + 1],
            accelerations: vec![zero; columns],
            forces: vec![[zero; 3]; bodies],
            balance: vec![zero; columns],
            multipliers: vec![zero; rows],
            effort: zero,
        }
    }

    /// Stands in closed positions, given by each kept coordinate in each lane.
    fn begin(&mut self, way: &Way, value: S, kept: impl Fn(usize, usize) -> f64) -> bool {
        for (number, place) in self.kept.iter_mut().enumerate() {
            *place = S::of(|lane| kept(number, lane));
        }
        self.value = value;
        self.work.sums[way.row] = value;
        self.third.fill(S::from(0.0));
        let Some(_) = self.close(way) else { return false };
        self.side = self.core.determinant()[0];
        self.derive(way);
        true
    }

    /// Moves the driver to a value, in steps so short that the path of every body can be followed.
    fn reach(&mut self, way: &Way, value: S) -> bool {
        let (from, whole) = (self.value, value - self.value);
        let mut step = (STEP * way.system.length / largest(whole.abs() * self.fast)).min(1.0);
        let mut done = 0.0;
        while done < 1.0 {
            let end = if step >= 1.0 - done { 1.0 } else { done + step };
            let target = if end >= 1.0 { value } else { from + whole * end };
            if self.step(way, target) {
                done = end;
                step *= 2.0;
            } else {
                step /= 2.0;
                if step.is_nan() || step < SMALLEST {
                    return false;
                }
            }
        }
        true
    }

    fn step(&mut self, way: &Way, value: S) -> bool {
        let h = value - self.value;
        let from = self.value;
        self.before.copy_from_slice(&self.kept);
        for (number, &column) in way.layout.kept.iter().enumerate() {
            let cubic = self.second[column] + self.third[number] * h / 3.0;
            let change = (self.first[column] + cubic * h / 2.0) * h;
            self.kept[number] = self.kept[number] + change;
        }
        self.work.sums[way.row] = value;
        let stays = match self.close(way) {
            Some(moved) => {
                let [side, apart] = self.core.determinant();
                let (allowed, rounding) = (h.abs() * self.fast, CLOSED * way.system.length);
                let stays = (0..S::COUNT).all(|lane| {
                    let (moved, allowed) = (moved.lane(lane), allowed.lane(lane));
                    let turned = side.lane(lane) * self.side.lane(lane) <= 0.0;
                    let smooth = moved <= SMOOTH * allowed + 16.0 * rounding;
                    apart.lane(lane) > SINGULAR
                        && moved <= JUMP * allowed + 16.0 * rounding
                        && (!turned || smooth)
                });
                self.side = if stays { side } else { self.side };
                stays
            }
            None => false,
        };
        if !stays {
            self.kept.copy_from_slice(&self.before);
            return false;
        }
        self.value = value;
        for (number, &column) in way.layout.kept.iter().enumerate() {
            self.third[number] = self.second[column];
        }
        self.derive(way);
        for (number, &column) in way.layout.kept.iter().enumerate() {
            let change = self.second[column] - self.third[number];
            self.third[number] =
                change.with(value - from, |change, h| if h == 0.0 { 0.0 } else { change / h });
        }
        true
    }

    /// Newton's method on the kept coordinates; leaves the factored equations of the closed position, and gives how
    /// far it moved them.
    fn close(&mut self, way: &Way) -> Option<S> {
        widest_of::<S, _>(
            #[inline(always)]
            || self.closed(way),
        )
    }

    #[inline(always)]
    fn closed(&mut self, way: &Way) -> Option<S> {
        let length = way.system.length;
        let mut moved = S::from(0.0);
        let mut last = f64::INFINITY;
        for _ in 0..ROUNDS {
            way.layout.set(&self.kept, &mut self.work);
            way.layout.measure(&mut self.work);
            let open = largest(way.layout.open_by(&self.work)) / length;
            let stays = open <= ALMOST && open > 0.3 * last;
            self.order.eliminate(&self.work.slopes);
            for (row, entries) in way.loops.iter().enumerate() {
                let row = &mut self.core.entries()[row * way.loops.len()..(row + 1) * way.loops.len()];
                row.fill(S::from(0.0));
                for &(place, number) in entries {
                    row[number] = self.order.eliminated(place);
                }
            }
            self.core.factor();
            if open <= CLOSED || stays {
                return Some(moved);
            }
            last = open;
            for (inner, &row) in self.inner.iter_mut().zip(way.layout.loops()) {
                *inner = self.work.gaps[row];
            }
            self.core.solve(&mut self.inner);
            let mut size = S::from(0.0);
            for (kept, change) in self.kept.iter_mut().zip(&self.inner) {
                *kept = *kept - *change;
                size = size.with(change.abs(), larger);
            }
            moved = moved + size;
            let far = largest(moved);
            if far.is_nan() || far > STEP * length {
                return None;
            }
        }
        None
    }

    /// The derivatives by the value of the driver.
    fn derive(&mut self, way: &Way) {
        widest_of::<S, _>(
            #[inline(always)]
            || self.derived(way),
        );
    }

    #[inline(always)]
    fn derived(&mut self, way: &Way) {
        self.right.fill(S::from(0.0));
        self.right[way.row] = S::from(1.0);
        solve(way, &self.order, &self.core, &mut self.inner, &mut self.right, &mut self.first);
        self.fast = self.first.iter().fold(S::from(0.0), |most, x| most.with(x.abs(), larger));
        rates(&self.first, way.system.length, &mut self.velocities);
        way.layout.bend(&self.work, &self.velocities, &mut self.right);
        solve(way, &self.order, &self.core, &mut self.inner, &mut self.right, &mut self.second);
    }

    /// Velocities, accelerations and reactions. False if something is not finite.
    fn load(&mut self, way: &Way) -> bool {
        widest_of::<S, _>(
            #[inline(always)]
            || self.loaded(way),
        )
    }

    #[inline(always)]
    fn loaded(&mut self, way: &Way) -> bool {
        let Way { system, layout, row, driver, masses, .. } = *way;
        let drivers = &system.mechanism.drivers;
        let length = system.length;
        let alone = drivers
            .iter()
            .enumerate()
            .all(|(other, of)| other == driver || (of.velocity == 0.0 && of.acceleration == 0.0));
        if alone {
            let (rate, acceleration) = (drivers[driver].velocity, drivers[driver].acceleration);
            for ((a, first), second) in self.accelerations.iter_mut().zip(&self.first).zip(&self.second) {
                *a = *second * (rate * rate) + *first * acceleration;
            }
            rates(&self.first, length, &mut self.velocities);
            for velocity in &mut self.velocities {
                *velocity = velocity.map(|x| x * rate);
            }
        } else {
            let begin = row - driver;
            self.right.fill(S::from(0.0));
            for (right, of) in self.right[begin..].iter_mut().zip(drivers) {
                *right = S::from(of.velocity);
            }
            solve(way, &self.order, &self.core, &mut self.inner, &mut self.right, &mut self.accelerations);
            rates(&self.accelerations, length, &mut self.velocities);
            layout.bend(&self.work, &self.velocities, &mut self.right);
            for (right, of) in self.right[begin..].iter_mut().zip(drivers) {
                *right = *right + of.acceleration;
            }
            solve(way, &self.order, &self.core, &mut self.inner, &mut self.right, &mut self.accelerations);
        }
        system.forces(&self.work.poses, &self.velocities, &mut self.forces);
        let per_length = 1.0 / length;
        let mut effort = S::from(0.0);
        for (body, [x, y, moment]) in self.forces.iter().enumerate() {
            for (part, force) in [*x, *y, *moment * per_length].into_iter().enumerate() {
                let column = 3 * body + part;
                let balance = self.accelerations[column] * masses[column] - force;
                self.balance[column] = balance;
                effort = effort + balance * self.first[column];
            }
        }
        self.effort = effort;
        self.order.reduce_transposed(&mut self.balance, &mut self.multipliers);
        for (inner, &column) in self.inner.iter_mut().zip(&layout.kept) {
            *inner = self.balance[column];
        }
        self.core.solve_transposed(&mut self.inner);
        for (inner, &row) in self.inner.iter().zip(layout.loops()) {
            self.multipliers[row] = *inner;
        }
        self.order.complete_transposed(&mut self.multipliers);
        let sum = self.multipliers.iter().fold(self.effort, |sum, x| sum + *x);
        (0..S::COUNT).all(|lane| sum.lane(lane).is_finite())
    }

    fn store(&self, way: &Way, swept: &mut Swept, at: impl Fn(usize) -> usize) {
        let per_length = 1.0 / way.system.length;
        for lane in 0..S::COUNT {
            let n = at(lane);
            let bodies = n * swept.bodies..(n + 1) * swept.bodies;
            let of_pose = |pose: &Pose<S>| [pose.x.lane(lane), pose.y.lane(lane), pose.angle.lane(lane)];
            for (out, pose) in swept.positions[bodies.clone()].iter_mut().zip(&self.work.poses) {
                *out = of_pose(pose);
            }
            for (out, v) in swept.velocities[bodies.clone()].iter_mut().zip(&self.velocities) {
                *out = [v[0].lane(lane), v[1].lane(lane), v[2].lane(lane)];
            }
            for (out, a) in swept.accelerations[bodies].iter_mut().zip(self.accelerations.chunks_exact(3)) {
                *out = [a[0].lane(lane), a[1].lane(lane), a[2].lane(lane) * per_length];
            }
            let rows = n * swept.equations..(n + 1) * swept.equations;
            for (out, multiplier) in swept.multipliers[rows].iter_mut().zip(&self.multipliers) {
                *out = multiplier.lane(lane);
            }
            swept.efforts[n] = self.effort.lane(lane);
        }
    }
}

/// Work with the widest registers, for numbers side by side.
fn widest_of<S: Numbers, R>(mut work: impl FnMut() -> R) -> R {
    if S::COUNT > 1 { widest(work) } else { work() }
}

/// `Φ_q x = right` with the factored equations. The right sides are overwritten.
#[inline(always)]
fn solve<S: Numbers>(
    way: &Way,
    order: &Order<S>,
    core: &Core<S>,
    inner: &mut [S],
    right: &mut [S],
    x: &mut [S],
) {
    order.reduce(right);
    for (inner, &row) in inner.iter_mut().zip(way.layout.loops()) {
        *inner = right[row];
    }
    core.solve(inner);
    for (inner, &column) in inner.iter().zip(&way.layout.kept) {
        x[column] = *inner;
    }
    order.complete(right, x);
}

/// Scaled rates as those of the bodies.
#[inline(always)]
fn rates<S: Numbers>(scaled: &[S], length: f64, of_bodies: &mut [[S; 3]]) {
    let per_length = 1.0 / length;
    for (rate, scaled) in of_bodies.iter_mut().zip(scaled.chunks_exact(3)) {
        *rate = [scaled[0], scaled[1], scaled[2] * per_length];
    }
}

/// Of two numbers; the second if it is not a number.
#[inline(always)]
fn larger(a: f64, b: f64) -> f64 {
    if a > b { a } else { b }
}

/// The largest of numbers side by side; not a number if one is not.
#[inline(always)]
fn largest<S: Numbers>(x: S) -> f64 {
    let worse = |most: f64, x: f64| if most.is_nan() { most } else { larger(most, x) };
    (0..S::COUNT).fold(0.0, |most, lane| worse(most, x.lane(lane)))
}
