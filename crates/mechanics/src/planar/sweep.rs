//! A driven mechanism compiled for many positions: a cycle of an engine, a curve of a coupler, a plot.
//!
//! The positions are followed as [`System::continue_to`] does it, with velocities, accelerations and every reaction, but
//! on the [plan](super::plan) of the mechanism, and many parts of the way side by side in the registers of the
//! machine. Where the plan does not lead on, near a dead centre or a limit, or does not serve, with friction or
//! redundant joints, the general way takes over; the results are the same.

mod past;
mod station;

use self::station::{CLOSED, PASSED, Path, Station};
use super::{
    Load, PlanarError, State, System,
    plan::{self, Layout, Order, Work},
};
use dalembert_numerics::simd::{SimdVector, WIDTH};

/// So many equations that are not explicit are eliminated as a full matrix at most.
const MOST_LOOPS: usize = 12;
/// Shorter sweeps are not divided.
const UNDIVIDED: usize = 4 * WIDTH;

/// Positions that a mechanism takes, one for each value of the driver, with what it is like there.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct SweepResult {
    /// Number of bodies.
    bodies: usize,
    /// Number of equations.
    equations: usize,
    /// For each value: positions, velocities, and accelerations of all bodies, the multipliers, and the effort.
    records: Vec<f64>,
    reached: usize,
}

/// A mechanism and its plan for the values of one of its drivers.
#[derive(Debug, Clone)]
pub struct Sweep<'a> {
    system: &'a System,
    /// Initial positions.
    positions: Vec<[f64; 3]>,
    driver: usize,
    /// The value of the driver there.
    value: f64,
    plan: Option<Plan>,
}

#[derive(Debug, Clone)]
struct Plan {
    layout: Layout,
    /// Remainder of the rows that are not explicit: places and numbers of the kept coordinates.
    loops: Vec<Vec<(usize, usize)>>,
    masses: Vec<f64>,
    start: Vec<f64>,
    one: Station<f64>,
    many: Station<SimdVector>,
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
    /// As for [`System::continue_to`] and [`System::dynamics`]: what ended the sweep, of which the first
    /// [`reached`](SweepResult::reached) positions stand.
    pub fn over(&mut self, values: &[f64], swept: &mut SweepResult) -> Result<(), PlanarError> {
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
            here = self.system.continue_to(&here, &held)?.positions;
            let (state, dynamics) = self.system.solved(&here)?;
            swept.put(&state, &dynamics.multipliers, dynamics.efforts[self.driver]);
        }
        Ok(())
    }
}

impl SweepResult {
    /// Number of positions reached.
    pub fn reached(&self) -> usize {
        self.reached
    }

    /// The positions of all bodies at a value.
    pub fn positions(&self, n: usize) -> &[[f64; 3]] {
        self.triples(n, 0)
    }

    /// Positions, velocities and accelerations at a value.
    pub fn state(&self, n: usize) -> State {
        let [positions, velocities, accelerations] = [0, 1, 2].map(|which| self.triples(n, which).to_vec());
        State { positions, velocities, accelerations }
    }

    /// The multiplier of each equation at a value, in the order of [`System::equations`], by Newton and Euler.
    pub fn multipliers(&self, n: usize) -> &[f64] {
        &self.record(n)[9 * self.bodies..][..self.equations]
    }

    /// The effort of the driver that is swept, by virtual power.
    pub fn effort(&self, n: usize) -> f64 {
        self.record(n)[9 * self.bodies + self.equations]
    }

    /// Number of values in a record.
    fn length(bodies: usize, equations: usize) -> usize {
        9 * bodies + equations + 1
    }

    fn record(&self, n: usize) -> &[f64] {
        let length = Self::length(self.bodies, self.equations);
        &self.records[n * length..][..length]
    }

    fn record_mut(&mut self, n: usize) -> &mut [f64] {
        let length = Self::length(self.bodies, self.equations);
        &mut self.records[n * length..][..length]
    }

    /// The positions (0), velocities (1) or accelerations (2) at a value.
    fn triples(&self, n: usize, which: usize) -> &[[f64; 3]] {
        &self.record(n).as_chunks().0[which * self.bodies..][..self.bodies]
    }

    fn make_room(&mut self, system: &System, count: usize) {
        (self.bodies, self.equations) = (system.mechanism.bodies.len(), system.equations.len());
        self.records.resize(count * Self::length(self.bodies, self.equations), 0.0);
        self.reached = 0;
    }

    fn put(&mut self, state: &State, multipliers: &[f64], effort: f64) {
        let of_bodies = [&state.positions, &state.velocities, &state.accelerations];
        let numbers = of_bodies.into_iter().flatten().flatten().chain(multipliers).chain([&effort]);
        for (place, number) in self.record_mut(self.reached).iter_mut().zip(numbers) {
            *place = *number;
        }
        self.reached += 1;
    }
}

impl Plan {
    fn new(system: &System, positions: &[[f64; 3]]) -> Option<Self> {
        let mut layout = Layout::new(system);
        let columns = 3 * positions.len();
        if layout.loops().len() != layout.kept.len() || layout.kept.len() > MOST_LOOPS {
            return None;
        }
        let mut work: Work<f64> = layout.work(system);
        let start: Vec<f64> = layout.kept.iter().map(|&column| system.scaled(column, positions)).collect();
        layout.set(&start, &mut work);
        layout.measure(&mut work);
        let (order, left) = Order::of_explicit(&layout, &work.jacobian, columns);
        let number = |column: usize| layout.kept.iter().position(|kept| *kept == column);
        let mut loops = Vec::new();
        for row in left {
            let row: Option<Vec<(usize, usize)>> =
                row.into_iter().map(|(place, column)| Some((place, number(column)?))).collect();
            loops.push(row?);
        }
        let [rows, kept] = plan::order(&loops);
        layout.rearrange(&rows, &kept);
        let mut renumbered = vec![0; kept.len()];
        for (new, &old) in kept.iter().enumerate() {
            renumbered[old] = new;
        }
        for (_, number) in loops.iter_mut().flatten() {
            *number = renumbered[*number];
        }
        let loops: Vec<Vec<(usize, usize)>> = rows.iter().map(|&row| loops[row].clone()).collect();
        let start = kept.iter().map(|&old| start[old]).collect();
        Some(Self {
            many: Station::new(system, &layout, &loops, order.with_numbers()),
            one: Station::new(system, &layout, &loops, order),
            masses: system.scaled_masses(),
            layout,
            loops,
            start,
        })
    }

    /// Number of positions that could be computed.
    fn over(
        &mut self,
        system: &System,
        (driver, from): (usize, f64),
        values: &[f64],
        swept: &mut SweepResult,
    ) -> usize {
        let Self { layout, loops, masses, start, one, many } = self;
        let way = Path { system, layout, loops, masses, row: system.first_driver() + driver, driver };
        if !one.begin(&way, from, |number, _| start[number]) {
            return 0;
        }
        if values.len() >= UNDIVIDED {
            let part = values.len().div_ceil(WIDTH);
            let first = |lane: usize| (lane * part).min(values.len() - 1);
            let mut anchors = vec![[0.0; WIDTH]; start.len()];
            let reached = (0..WIDTH).all(|lane| {
                let reached = one.reach(&way, values[first(lane)], PASSED);
                for (anchor, kept) in anchors.iter_mut().zip(&one.kept) {
                    anchor[lane] = *kept;
                }
                reached
            });
            let at = |lane: usize, step: usize| (first(lane) + step).min(values.len() - 1);
            let value = |step: usize| SimdVector::of(|lane| values[at(lane, step)]);
            let mut steps = 0..part;
            let swept_all = reached
                && many.begin(&way, value(0), |number, lane| anchors[number][lane])
                && steps.all(|step| {
                    let good = many.reach(&way, value(step), CLOSED) && many.load(&way);
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
            if !(one.reach(&way, *value, CLOSED) && one.load(&way)) {
                return n;
            }
            one.store(&way, swept, |_| n);
        }
        values.len()
    }
}
