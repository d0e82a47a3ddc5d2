//! Sweep of a driven mechanism through many positions: a cycle of an engine, a curve of a coupler, a plot.
//!
//! The positions are followed as [`Model::continue_to`] does it, with velocities, accelerations and every reaction, but
//! on a fixed elimination ([`Station`]), and many parts of the sweep in the lanes of SIMD vectors. Where that does not
//! lead on, near a dead centre or a limit position, or does not serve, with friction or redundant joints, the general
//! continuation takes over; the results are the same.

mod history;
mod station;

use self::station::{Path, Station};
use super::{
    Model, PlanarError, PlanarLoad, PlanarState,
    elimination::PivotOrder,
    layout::{EquationLayout, Position},
    tolerances::{MIN_DIVIDED, SWEEP_PASSED_RESIDUAL, SWEEP_RESIDUAL},
};
use dalembert_numerics::{
    givens::ordering,
    simd::{SimdVector, WIDTH},
};

/// The states of a mechanism, one for each value of the driver.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct SweepResult {
    /// The number of bodies.
    bodies: usize,
    /// The number of equations.
    equations: usize,
    /// For each value: positions, velocities, and accelerations of all bodies, the multipliers, and the effort.
    records: Vec<f64>,
    reached: usize,
}

/// A mechanism compiled for the values of one of its drivers.
#[derive(Debug, Clone)]
pub struct Sweep<'a> {
    model: &'a Model,
    /// The positions from which it begins.
    positions: Vec<[f64; 3]>,
    driver: usize,
    /// The value of the driver there.
    value: f64,
    fixed: Option<FixedElimination>,
}

/// The model of a mechanism whose loops are eliminated in one way throughout, and its working data.
#[derive(Debug, Clone)]
struct FixedElimination {
    layout: EquationLayout,
    /// The elimination of the explicit coordinates.
    order: PivotOrder,
    /// The tree coordinates from which a sweep begins.
    start: Vec<f64>,
    one: Station<f64>,
    many: Station<SimdVector>,
}

impl Model {
    /// Compiles the mechanism, closed in some positions, for the values of one of its drivers.
    ///
    /// # Errors
    /// `UnderDriven`, `OverDriven`, `DeadCentre`; `NotFinite`.
    pub fn sweep(&self, positions: &[[f64; 3]], driver: usize) -> Result<Sweep<'_>, PlanarError> {
        let elimination = self.factored(positions)?;
        let is_plain = elimination.dependent_rows().is_empty()
            && !self.mechanism.loads.iter().any(|load| matches!(load, PlanarLoad::Friction { .. }));
        let fixed = if is_plain { FixedElimination::new(self, positions) } else { None };
        let value = self.value(&self.mechanism.drivers[driver].measure, positions);
        Ok(Sweep { model: self, positions: positions.to_vec(), driver, value, fixed })
    }
}

impl Sweep<'_> {
    /// Takes the driver to each value in turn, from the positions that the mechanism was compiled in, at the
    /// velocities and accelerations of the drivers, the others held.
    ///
    /// # Errors
    /// As for [`Model::continue_to`] and [`Model::inverse_dynamics`]: what ended the sweep, of which the first
    /// [`reached`](SweepResult::reached) positions stand.
    pub fn over(&mut self, values: &[f64], result: &mut SweepResult) -> Result<(), PlanarError> {
        result.make_room(self.model, values.len());
        let mut done = 0;
        let mut here = self.positions.clone();
        if let Some(fixed) = &mut self.fixed {
            done = fixed.over(self.model, (self.driver, self.value), values, result);
            if done > 0 {
                here = result.positions(done - 1).to_vec();
            }
        }
        result.reached = done;
        let mut driver_values = self.model.driver_values();
        for &value in &values[done..] {
            driver_values[self.driver] = value;
            here = self.model.continue_to(&here, &driver_values)?.positions;
            let (state, dynamics) = self.model.kinetostatics(&here)?;
            result.put(&state, &dynamics.multipliers, dynamics.efforts[self.driver]);
        }
        Ok(())
    }
}

impl SweepResult {
    /// The number of positions that were reached.
    pub fn reached(&self) -> usize {
        self.reached
    }

    /// The positions of all bodies at a value.
    pub fn positions(&self, n: usize) -> &[[f64; 3]] {
        self.triples(n, 0)
    }

    /// Positions, velocities and accelerations at a value.
    pub fn state(&self, n: usize) -> PlanarState {
        let [positions, velocities, accelerations] = [0, 1, 2].map(|which| self.triples(n, which).to_vec());
        PlanarState { positions, velocities, accelerations }
    }

    /// The multiplier of each equation at a value, in the order of [`Model::equations`], by Newton and Euler.
    pub fn multipliers(&self, n: usize) -> &[f64] {
        &self.record(n)[9 * self.bodies..][..self.equations]
    }

    /// The effort of the driver that is swept, by virtual power.
    pub fn effort(&self, n: usize) -> f64 {
        self.record(n)[9 * self.bodies + self.equations]
    }

    /// The length of a record.
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

    fn make_room(&mut self, model: &Model, count: usize) {
        (self.bodies, self.equations) = (model.mechanism.bodies.len(), model.equations.len());
        self.records.resize(count * Self::length(self.bodies, self.equations), 0.0);
        self.reached = 0;
    }

    fn put(&mut self, state: &PlanarState, multipliers: &[f64], effort: f64) {
        let of_bodies = [&state.positions, &state.velocities, &state.accelerations];
        let numbers = of_bodies.into_iter().flatten().flatten().chain(multipliers).chain([&effort]);
        for (place, number) in self.record_mut(self.reached).iter_mut().zip(numbers) {
            *place = *number;
        }
        self.reached += 1;
    }
}

impl FixedElimination {
    /// None if the loops do not determine the tree coordinates.
    fn new(model: &Model, positions: &[[f64; 3]]) -> Option<Self> {
        let layout = &model.layout;
        if layout.loops.len() != layout.tree.len() {
            return None;
        }
        let mut position: Position = layout.position(&model.equations);
        let start = model.tree_coordinates(positions);
        layout.evaluate(&start, &mut position);
        let (order, reduced) = PivotOrder::of_explicit(layout, &position.jacobian, model.masses.len());
        let mut numbers = vec![None; model.masses.len()];
        for (number, &column) in layout.tree.iter().enumerate() {
            numbers[column] = Some(number);
        }
        let mut loops = Vec::new();
        for row in reduced {
            let row: Option<Vec<(usize, usize)>> =
                row.into_iter().map(|(place, column)| Some((place, numbers[column]?))).collect();
            loops.push(row?);
        }
        let [rows, tree] = ordering(&loops);
        let layout = layout.rearranged(&rows, &tree);
        let mut renumbered = vec![0; tree.len()];
        for (new, &old) in tree.iter().enumerate() {
            renumbered[old] = new;
        }
        for (_, number) in loops.iter_mut().flatten() {
            *number = renumbered[*number];
        }
        let loops: Vec<Vec<(usize, usize)>> = rows.iter().map(|&row| loops[row].clone()).collect();
        let start = tree.iter().map(|&old| start[old]).collect();
        Some(Self {
            many: Station::new(model, &layout, &loops, &order),
            one: Station::new(model, &layout, &loops, &order),
            layout,
            order,
            start,
        })
    }

    /// Takes the driver from a value to each of others, and gives the number of those that were reached.
    fn over(
        &mut self,
        model: &Model,
        (driver, from): (usize, f64),
        values: &[f64],
        result: &mut SweepResult,
    ) -> usize {
        let Self { layout, order, start, one, many } = self;
        let path = Path { model, layout, order, driver };
        if !one.begin(&path, from, |number, _| start[number]) {
            return 0;
        }
        if values.len() >= MIN_DIVIDED {
            let part = values.len().div_ceil(WIDTH);
            let first = |lane: usize| (lane * part).min(values.len() - 1);
            let mut anchors = vec![[0.0; WIDTH]; start.len()];
            let reached = (0..WIDTH).all(|lane| {
                let reached = one.reach(&path, values[first(lane)], SWEEP_PASSED_RESIDUAL);
                for (anchor, coordinate) in anchors.iter_mut().zip(&one.tree) {
                    anchor[lane] = *coordinate;
                }
                reached
            });
            let at = |lane: usize, step: usize| (first(lane) + step).min(values.len() - 1);
            let value = |step: usize| SimdVector::of(|lane| values[at(lane, step)]);
            let mut steps = 0..part;
            let all_reached = reached
                && many.begin(&path, value(0), |number, lane| anchors[number][lane])
                && steps.all(|step| {
                    many.reach(&path, value(step), SWEEP_RESIDUAL)
                        && many.store(&path, result, |lane| at(lane, step))
                });
            if all_reached {
                return values.len();
            }
            one.begin(&path, from, |number, _| start[number]);
        }
        for (n, value) in values.iter().enumerate() {
            if !(one.reach(&path, *value, SWEEP_RESIDUAL) && one.store(&path, result, |_| n)) {
                return n;
            }
        }
        values.len()
    }
}
