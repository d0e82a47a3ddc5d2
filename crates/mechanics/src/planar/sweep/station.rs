//! Station of a sweep: the numbers of a mechanism at one position, or at several in the lanes of a SIMD vector.

use super::{SweepResult, history::History};
use crate::planar::{
    Model,
    elimination::{LuFactors, PivotOrder},
    layout::{EquationLayout, Position},
    tolerances::{
        MAX_CORRECTION, MAX_PREDICTED_STEP, MAX_SMOOTH_CORRECTION, MAX_STEP, ROUNDINGS_OF_CORRECTION,
        STALLED_RESIDUAL, SWEEP_MAX_ITERATIONS, SWEEP_MIN_PIVOT, SWEEP_MIN_STEP, SWEEP_RESIDUAL,
        SWEEP_STALLED_RESIDUAL,
    },
};
use dalembert_numerics::{
    givens::GivensQr,
    simd::{SimdReal, widest},
};

/// The immutable part of a sweep.
#[derive(Clone, Copy)]
pub(super) struct Path<'a> {
    pub(super) model: &'a Model,
    pub(super) layout: &'a EquationLayout,
    /// The elimination of the explicit coordinates.
    pub(super) order: &'a PivotOrder,
    /// The driver that is swept.
    pub(super) driver: usize,
}

impl Path<'_> {
    /// The equation of the driver that is swept.
    fn row(&self) -> usize {
        self.model.first_driver() + self.driver
    }
}

/// The numbers of one position, or of several in the lanes of `S`. Vectors are scaled, by the columns or rows of the
/// model.
#[derive(Debug, Clone)]
pub(super) struct Station<S> {
    factors: LuFactors<S>,
    loops: GivensQr<S>,
    position: Position<S>,
    /// The value of the driver, m or rad.
    value: S,
    /// The tree coordinates, m.
    pub(super) tree: Vec<S>,
    /// Those from which a step began.
    tree_before: Vec<S>,
    /// The first derivatives of the scaled coordinates by the value of the driver.
    first: Vec<S>,
    /// The second derivatives.
    second: Vec<S>,
    history: History<S>,
    /// The largest first derivative.
    largest_first: S,
    /// The sign of the determinant of the loop equations, by a product with that sign: it changes with the branch.
    sign: S,
    rhs: Vec<S>,
    /// Right-hand side and solution of the loop equations.
    loop_rhs: Vec<S>,
    /// Of the bodies and the ground.
    velocities: Vec<[S; 3]>,
    accelerations: Vec<S>,
    forces: Vec<[S; 3]>,
    /// The inertia forces less the loads, `M q̈ − Q`.
    unbalanced: Vec<S>,
    multipliers: Vec<S>,
    effort: S,
}

impl<S: SimdReal> Station<S> {
    pub(super) fn new(
        model: &Model,
        layout: &EquationLayout,
        loops: &[Vec<(usize, usize)>],
        order: &PivotOrder,
    ) -> Self {
        let (bodies, rows) = (model.mechanism.bodies.len(), model.equations.len());
        let (columns, tree) = (3 * bodies, layout.tree.len());
        let zero = S::from(0.0);
        Self {
            factors: order.factors(),
            loops: GivensQr::new(loops),
            position: layout.position(&model.equations),
            value: zero,
            tree: vec![zero; tree],
            tree_before: vec![zero; tree],
            first: vec![zero; columns],
            second: vec![zero; columns],
            history: History::new(tree),
            largest_first: zero,
            sign: zero,
            rhs: vec![zero; rows],
            loop_rhs: vec![zero; tree],
            velocities: vec![[zero; 3]; bodies + 1],
            accelerations: vec![zero; columns],
            forces: vec![[zero; 3]; bodies],
            unbalanced: vec![zero; columns],
            multipliers: vec![zero; rows],
            effort: zero,
        }
    }

    /// Begins in positions that are closed, or almost, at a value of the driver; `tree` has each tree coordinate, by
    /// its number, in each lane. False if they are not on the same branch once closed.
    pub(super) fn begin(&mut self, path: &Path, value: S, tree: impl Fn(usize, usize) -> f64) -> bool {
        for (number, coordinate) in self.tree.iter_mut().enumerate() {
            *coordinate = S::of(|lane| tree(number, lane));
        }
        self.value = value;
        self.position.constants[path.row()] = value;
        self.history.forget();
        // An almost closed position is closed nearby, or it is on another branch.
        let Some(correction) = self.close(path, SWEEP_RESIDUAL) else { return false };
        if largest(correction) > MAX_SMOOTH_CORRECTION * path.model.length {
            return false;
        }
        self.sign = self.loops.determinant()[0];
        self.derive(path);
        true
    }

    /// Moves the driver to a value, in steps so short that the path of every body can be followed, with the loops
    /// closed to a residual, of the size of the mechanism. False if no step leads on.
    pub(super) fn reach(&mut self, path: &Path, value: S, residual: f64) -> bool {
        let (from, whole) = (self.value, value - self.value);
        if largest(whole.abs()) == 0.0 {
            return true;
        }
        let max_step = if self.history.is_known() { MAX_PREDICTED_STEP } else { MAX_STEP };
        let mut step = (max_step * path.model.length / largest(whole.abs() * self.largest_first)).min(1.0);
        let mut done = 0.0;
        while done < 1.0 {
            let end = if step >= 1.0 - done { 1.0 } else { done + step };
            let target = if end >= 1.0 { value } else { from + whole * end };
            if self.step(path, target, residual) {
                done = end;
                step *= 2.0;
            } else {
                step /= 2.0;
                if step.is_nan() || step < SWEEP_MIN_STEP {
                    return false;
                }
            }
        }
        true
    }

    /// Moves the driver to a value in one step. False, in the position before, if it might leave the branch.
    fn step(&mut self, path: &Path, value: S, residual: f64) -> bool {
        let h = value - self.value;
        self.tree_before.copy_from_slice(&self.tree);
        self.predict(path, h);
        self.position.constants[path.row()] = value;
        let stays = match self.close(path, residual) {
            Some(correction) => {
                let [sign, smallest_pivot] = self.loops.determinant();
                let displacement = h.abs() * self.largest_first;
                // What rounding leaves open in a loop moves all loops that follow.
                let loops = self.tree.len() as f64;
                let rounding = ROUNDINGS_OF_CORRECTION * (SWEEP_RESIDUAL * path.model.length) * loops;
                let stays = (0..S::COUNT).all(|lane| {
                    let (correction, displacement) = (correction.lane(lane), displacement.lane(lane));
                    let sign_changes = sign.lane(lane) * self.sign.lane(lane) <= 0.0;
                    let is_smooth = correction <= MAX_SMOOTH_CORRECTION * displacement + rounding;
                    let is_far = displacement > MAX_STEP * path.model.length;
                    smallest_pivot.lane(lane) > SWEEP_MIN_PIVOT
                        && correction <= MAX_CORRECTION * displacement + rounding
                        && (!(sign_changes || is_far) || is_smooth)
                });
                self.sign = if stays { sign } else { self.sign };
                stays
            }
            None => false,
        };
        if !stays {
            self.tree.copy_from_slice(&self.tree_before);
            return false;
        }
        self.value = value;
        let derivatives = path.layout.tree.iter().map(|&column| [self.first[column], self.second[column]]);
        self.history.push(h, derivatives);
        self.derive(path);
        true
    }

    /// Predicts the tree coordinates after a step `h` of the driver.
    fn predict(&mut self, path: &Path, h: S) {
        widest_of::<S, _>(
            #[inline(always)]
            || {
                let weights = self.history.weights(h);
                for (number, &column) in path.layout.tree.iter().enumerate() {
                    let derivatives = [self.first[column], self.second[column]];
                    let change = self.history.change(number, derivatives, &weights);
                    self.tree[number] = self.tree[number] + change;
                }
            },
        );
    }

    /// Newton's method on the tree coordinates: closes the loops to a residual, of the size, and leaves their factored
    /// equations. The sum of the corrections, m; none if it does not converge.
    fn close(&mut self, path: &Path, residual: f64) -> Option<S> {
        widest_of::<S, _>(
            #[inline(always)]
            || self.closed(path, residual),
        )
    }

    #[inline(always)]
    fn closed(&mut self, path: &Path, residual: f64) -> Option<S> {
        let length = path.model.length;
        let mut total = S::from(0.0);
        let mut last = f64::INFINITY;
        for _ in 0..SWEEP_MAX_ITERATIONS {
            path.layout.evaluate(&self.tree, &mut self.position);
            let open = largest(path.layout.largest_residual(&self.position)) / length;
            let is_stalled = open <= SWEEP_STALLED_RESIDUAL && open > STALLED_RESIDUAL * last;
            path.order.eliminate_rows(&self.position.jacobian, &mut self.factors);
            let Self { loops, factors, .. } = self;
            loops.factor(
                #[inline(always)]
                |place| factors.entry(place),
            );
            if open <= residual || is_stalled {
                path.order.set_ratios(&mut self.factors);
                return Some(total);
            }
            last = open;
            for (rhs, &row) in self.loop_rhs.iter_mut().zip(&path.layout.loops) {
                *rhs = self.position.residuals[row];
            }
            self.loops.solve(&mut self.loop_rhs);
            let mut size = S::from(0.0);
            for (coordinate, correction) in self.tree.iter_mut().zip(&self.loop_rhs) {
                *coordinate = *coordinate - *correction;
                size = size.with(correction.abs(), larger);
            }
            total = total + size;
            let far = largest(total);
            if far.is_nan() || far > MAX_STEP * length {
                return None;
            }
        }
        None
    }

    /// The derivatives of the scaled coordinates by the value of the driver, in the closed position.
    fn derive(&mut self, path: &Path) {
        widest_of::<S, _>(
            #[inline(always)]
            || self.derived(path),
        );
    }

    #[inline(always)]
    fn derived(&mut self, path: &Path) {
        self.rhs.fill(S::from(0.0));
        self.rhs[path.row()] = S::from(1.0);
        solve(path, &self.factors, &self.loops, &mut self.loop_rhs, &mut self.rhs, &mut self.first);
        self.largest_first = S::from(0.0);
        for first in &self.first {
            self.largest_first = self.largest_first.with(first.abs(), larger);
        }
        path.model.unscale(&self.first, &mut self.velocities);
        path.layout.quadratic_velocity_terms(&self.position, &self.velocities, &mut self.rhs);
        solve(path, &self.factors, &self.loops, &mut self.loop_rhs, &mut self.rhs, &mut self.second);
    }

    /// Velocities, accelerations, multipliers and effort in the closed position. False if something is not finite.
    fn balance(&mut self, path: &Path) -> bool {
        widest_of::<S, _>(
            #[inline(always)]
            || self.balanced(path),
        )
    }

    #[inline(always)]
    fn balanced(&mut self, path: &Path) -> bool {
        let Path { model, layout, order, driver, .. } = *path;
        let drivers = &model.mechanism.drivers;
        let length = model.length;
        let alone = drivers
            .iter()
            .enumerate()
            .all(|(other, of)| other == driver || (of.velocity == 0.0 && of.acceleration == 0.0));
        if alone {
            let (rate, acceleration) = (drivers[driver].velocity, drivers[driver].acceleration);
            let rates = [rate, rate, rate / length];
            // By indices: a loop over the three lists side by side is compiled so that it goes over the bodies by
            // lanes, gathering each number from where it lies.
            for body in 0..model.mechanism.bodies.len() {
                for (part, rate_of_part) in rates.into_iter().enumerate() {
                    let column = 3 * body + part;
                    self.velocities[body][part] = self.first[column] * rate_of_part;
                    self.accelerations[column] =
                        self.second[column] * (rate * rate) + self.first[column] * acceleration;
                }
            }
        } else {
            let begin = model.first_driver();
            self.rhs.fill(S::from(0.0));
            for (rhs, of) in self.rhs[begin..].iter_mut().zip(drivers) {
                *rhs = S::from(of.velocity);
            }
            solve(
                path,
                &self.factors,
                &self.loops,
                &mut self.loop_rhs,
                &mut self.rhs,
                &mut self.accelerations,
            );
            model.unscale(&self.accelerations, &mut self.velocities);
            layout.quadratic_velocity_terms(&self.position, &self.velocities, &mut self.rhs);
            for (rhs, of) in self.rhs[begin..].iter_mut().zip(drivers) {
                *rhs = *rhs + of.acceleration;
            }
            solve(
                path,
                &self.factors,
                &self.loops,
                &mut self.loop_rhs,
                &mut self.rhs,
                &mut self.accelerations,
            );
        }
        model.forces(&self.position.poses, &self.velocities, &mut self.forces);
        let per_length = 1.0 / length;
        let mut effort = S::from(0.0);
        for (body, [x, y, moment]) in self.forces.iter().enumerate() {
            for (part, force) in [*x, *y, *moment * per_length].into_iter().enumerate() {
                let column = 3 * body + part;
                let balance = self.accelerations[column] * model.masses[column] - force;
                self.unbalanced[column] = balance;
                effort = effort + balance * self.first[column];
            }
        }
        self.effort = effort;
        order.reduce_transposed(&self.factors, &mut self.unbalanced, &mut self.multipliers);
        for (rhs, &column) in self.loop_rhs.iter_mut().zip(&layout.tree) {
            *rhs = self.unbalanced[column];
        }
        self.loops.solve_transposed(&mut self.loop_rhs);
        for (multiplier, &row) in self.loop_rhs.iter().zip(&layout.loops) {
            self.multipliers[row] = *multiplier;
        }
        order.back_substitute_transposed(&self.factors, &mut self.multipliers);
        let mut sum = effort;
        for number in self.accelerations.iter().chain(&self.multipliers) {
            sum = sum + *number;
        }
        (0..S::COUNT).all(|lane| sum.lane(lane).is_finite())
    }

    /// Solves for velocities, accelerations, multipliers and effort, and writes each lane into the record of this
    /// index. False, with nothing written, if something is not finite.
    pub(super) fn store(
        &mut self,
        path: &Path,
        result: &mut SweepResult,
        at: impl Fn(usize) -> usize,
    ) -> bool {
        if !self.balance(path) {
            return false;
        }
        let per_length = 1.0 / path.model.length;
        let bodies = self.forces.len();
        for lane in 0..S::COUNT {
            let (positions, rest) = result.record_mut(at(lane)).split_at_mut(3 * bodies);
            let (velocities, rest) = rest.split_at_mut(3 * bodies);
            let (accelerations, rest) = rest.split_at_mut(3 * bodies);
            let triples = |numbers| <[f64]>::as_chunks_mut::<3>(numbers).0.iter_mut();
            for (place, pose) in triples(positions).zip(&self.position.poses) {
                *place = [&pose.x, &pose.y, &pose.angle].map(|number| number.lane(lane));
            }
            for (place, velocity) in triples(velocities).zip(&self.velocities) {
                *place = velocity.each_ref().map(|number| number.lane(lane));
            }
            for (place, scaled) in triples(accelerations).zip(self.accelerations.as_chunks::<3>().0) {
                let [x, y, angle] = scaled.each_ref().map(|number| number.lane(lane));
                *place = [x, y, angle * per_length];
            }
            for (place, number) in rest.iter_mut().zip(self.multipliers.iter().chain([&self.effort])) {
                *place = number.lane(lane);
            }
        }
        true
    }
}

/// Runs work in the widest registers if it is on several lanes.
fn widest_of<S: SimdReal, R>(mut work: impl FnMut() -> R) -> R {
    if S::COUNT > 1 { widest(work) } else { work() }
}

/// Solves `Φ_q x = rhs` with the factored equations: `rhs` by rows, overwritten, and `x` by columns.
#[inline(always)]
fn solve<S: SimdReal>(
    path: &Path,
    factors: &LuFactors<S>,
    loops: &GivensQr<S>,
    loop_rhs: &mut [S],
    rhs: &mut [S],
    x: &mut [S],
) {
    path.order.reduce(factors, rhs);
    for (loop_rhs, &row) in loop_rhs.iter_mut().zip(&path.layout.loops) {
        *loop_rhs = rhs[row];
    }
    loops.solve(loop_rhs);
    for (value, &column) in loop_rhs.iter().zip(&path.layout.tree) {
        x[column] = *value;
    }
    path.order.back_substitute(factors, rhs, x);
}

/// The larger of two numbers; the second if it is not a number.
#[inline(always)]
fn larger(a: f64, b: f64) -> f64 {
    if a > b { a } else { b }
}

/// The largest of numbers side by side; not a number if one is not.
#[inline(always)]
fn largest<S: SimdReal>(x: S) -> f64 {
    let worse = |most: f64, x: f64| if most.is_nan() { most } else { larger(most, x) };
    (0..S::COUNT).fold(0.0, |most, lane| worse(most, x.lane(lane)))
}
