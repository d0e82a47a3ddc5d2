//! A mechanism at one position, or at several side by side.

#![expect(clippy::inline_always, reason = "what is not inlined is not compiled for the widest registers")]

use super::super::{
    System,
    continuation::{JUMP, SMOOTH, STEP},
    plan::{Core, Layout, Order, Work},
};
use super::{SweepResult, past::Past};
use dalembert_numerics::simd::{SimdReal, widest};

/// The smallest step, in parts of the way between two positions.
const SMALLEST: f64 = 1e-3;
/// Rounds of Newton's method for a step.
const ROUNDS: usize = 8;
/// Joints are closed to this part of the size of the mechanism, or at least to the second.
pub(super) const CLOSED: f64 = 4.0 * f64::EPSILON;
const ALMOST: f64 = 1e-13;
/// … and to this part where the way only leads past.
pub(super) const PASSED: f64 = 1e-5;
/// A position whose equations are nearer to singular than this is left to the general way.
const SINGULAR: f64 = 1e-9;

/// Constants of the path.
#[derive(Clone, Copy)]
pub(super) struct Path<'a> {
    pub(super) system: &'a System,
    pub(super) layout: &'a Layout,
    pub(super) loops: &'a [Vec<(usize, usize)>],
    pub(super) masses: &'a [f64],
    /// The equation of the driver that is swept, and the driver.
    pub(super) row: usize,
    pub(super) driver: usize,
}

/// The numbers of one position, or of several side by side.
#[derive(Debug, Clone)]
pub(super) struct Station<S> {
    order: Order<S>,
    core: Core<S>,
    work: Work<S>,
    /// The value of the driver and the kept coordinates …
    value: S,
    pub(super) kept: Vec<S>,
    /// … and those from which a step began.
    before: Vec<S>,
    /// Derivatives of the scaled coordinates with respect to the driver: first and second.
    first: Vec<S>,
    second: Vec<S>,
    past: Past<S>,
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

impl<S: SimdReal> Station<S> {
    pub(super) fn new(
        system: &System,
        layout: &Layout,
        loops: &[Vec<(usize, usize)>],
        order: Order<S>,
    ) -> Self {
        let (bodies, rows) = (system.mechanism.bodies.len(), system.equations.len());
        let (columns, kept) = (3 * bodies, layout.kept.len());
        let zero = S::from(0.0);
        Self {
            order,
            core: Core::new(loops),
            work: layout.work(system),
            value: zero,
            kept: vec![zero; kept],
            before: vec![zero; kept],
            first: vec![zero; columns],
            second: vec![zero; columns],
            past: Past::new(kept),
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

    /// Stands in positions that are closed, or almost, given by each kept coordinate in each lane.
    pub(super) fn begin(&mut self, way: &Path, value: S, kept: impl Fn(usize, usize) -> f64) -> bool {
        for (number, place) in self.kept.iter_mut().enumerate() {
            *place = S::of(|lane| kept(number, lane));
        }
        self.value = value;
        self.work.sums[way.row] = value;
        self.past.forget();
        // What is almost closed is closed nearby, or it is on another branch.
        let Some(moved) = self.close(way, CLOSED) else { return false };
        if largest(moved) > SMOOTH * way.system.length {
            return false;
        }
        self.side = self.core.determinant()[0];
        self.derive(way);
        true
    }

    /// Moves the driver to a value, in steps so short that the path of every body can be followed, with the joints
    /// closed to a part of the size of the mechanism.
    pub(super) fn reach(&mut self, way: &Path, value: S, closed: f64) -> bool {
        let (from, whole) = (self.value, value - self.value);
        if largest(whole.abs()) == 0.0 {
            return true;
        }
        let mut step = (STEP * way.system.length / largest(whole.abs() * self.fast)).min(1.0);
        let mut done = 0.0;
        while done < 1.0 {
            let end = if step >= 1.0 - done { 1.0 } else { done + step };
            let target = if end >= 1.0 { value } else { from + whole * end };
            if self.step(way, target, closed) {
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

    fn step(&mut self, way: &Path, value: S, closed: f64) -> bool {
        let h = value - self.value;
        self.before.copy_from_slice(&self.kept);
        self.predict(way, h);
        self.work.sums[way.row] = value;
        let stays = match self.close(way, closed) {
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
        let derivatives = way.layout.kept.iter().map(|&column| [self.first[column], self.second[column]]);
        self.past.push(h, derivatives);
        self.derive(way);
        true
    }

    fn predict(&mut self, way: &Path, h: S) {
        widest_of::<S, _>(
            #[inline(always)]
            || {
                let weights = self.past.weights(h);
                for (number, &column) in way.layout.kept.iter().enumerate() {
                    let derivatives = [self.first[column], self.second[column]];
                    let change = self.past.change(number, derivatives, &weights);
                    self.kept[number] = self.kept[number] + change;
                }
            },
        );
    }

    /// Newton's method on the kept coordinates; leaves the factored equations of the closed position, and gives how
    /// far it moved them.
    fn close(&mut self, way: &Path, closed: f64) -> Option<S> {
        widest_of::<S, _>(
            #[inline(always)]
            || self.closed(way, closed),
        )
    }

    #[inline(always)]
    fn closed(&mut self, way: &Path, closed: f64) -> Option<S> {
        let length = way.system.length;
        let mut moved = S::from(0.0);
        let mut last = f64::INFINITY;
        for _ in 0..ROUNDS {
            way.layout.set(&self.kept, &mut self.work);
            way.layout.measure(&mut self.work);
            let open = largest(way.layout.open(&self.work)) / length;
            let stays = open <= ALMOST && open > 0.3 * last;
            self.order.eliminate(&self.work.jacobian);
            for (row, entries) in way.loops.iter().enumerate() {
                let row = &mut self.core.entries()[row * way.loops.len()..(row + 1) * way.loops.len()];
                row.fill(S::from(0.0));
                for &(place, number) in entries {
                    row[number] = self.order.eliminated(place);
                }
            }
            self.core.factor();
            if open <= closed || stays {
                return Some(moved);
            }
            last = open;
            for (inner, &row) in self.inner.iter_mut().zip(way.layout.loops()) {
                *inner = self.work.residuals[row];
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
    fn derive(&mut self, way: &Path) {
        widest_of::<S, _>(
            #[inline(always)]
            || self.derived(way),
        );
    }

    #[inline(always)]
    fn derived(&mut self, way: &Path) {
        self.right.fill(S::from(0.0));
        self.right[way.row] = S::from(1.0);
        solve(way, &self.order, &self.core, &mut self.inner, &mut self.right, &mut self.first);
        self.fast = S::from(0.0);
        for first in &self.first {
            self.fast = self.fast.with(first.abs(), larger);
        }
        way.system.unscale(&self.first, &mut self.velocities);
        way.layout.bend(&self.work, &self.velocities, &mut self.right);
        solve(way, &self.order, &self.core, &mut self.inner, &mut self.right, &mut self.second);
    }

    /// Velocities, accelerations and reactions. False if something is not finite.
    pub(super) fn load(&mut self, way: &Path) -> bool {
        widest_of::<S, _>(
            #[inline(always)]
            || self.loaded(way),
        )
    }

    #[inline(always)]
    fn loaded(&mut self, way: &Path) -> bool {
        let Path { system, layout, row, driver, masses, .. } = *way;
        let drivers = &system.mechanism.drivers;
        let length = system.length;
        let alone = drivers
            .iter()
            .enumerate()
            .all(|(other, of)| other == driver || (of.velocity == 0.0 && of.acceleration == 0.0));
        if alone {
            let (rate, acceleration) = (drivers[driver].velocity, drivers[driver].acceleration);
            let rates = [rate, rate, rate / length];
            // By indices: a loop over the three lists side by side is compiled so that it goes over the bodies by lanes,
            // gathering each number from where it lies.
            for body in 0..system.mechanism.bodies.len() {
                for (part, rate_of_part) in rates.into_iter().enumerate() {
                    let column = 3 * body + part;
                    self.velocities[body][part] = self.first[column] * rate_of_part;
                    self.accelerations[column] =
                        self.second[column] * (rate * rate) + self.first[column] * acceleration;
                }
            }
        } else {
            let begin = row - driver;
            self.right.fill(S::from(0.0));
            for (right, of) in self.right[begin..].iter_mut().zip(drivers) {
                *right = S::from(of.velocity);
            }
            solve(way, &self.order, &self.core, &mut self.inner, &mut self.right, &mut self.accelerations);
            system.unscale(&self.accelerations, &mut self.velocities);
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
        let mut sum = effort;
        for number in self.accelerations.iter().chain(&self.multipliers) {
            sum = sum + *number;
        }
        (0..S::COUNT).all(|lane| sum.lane(lane).is_finite())
    }

    /// Writes the position of each lane into a place among those that were swept.
    pub(super) fn store(&self, way: &Path, swept: &mut SweepResult, at: impl Fn(usize) -> usize) {
        let per_length = 1.0 / way.system.length;
        let bodies = self.forces.len();
        for lane in 0..S::COUNT {
            let (positions, rest) = swept.record_mut(at(lane)).split_at_mut(3 * bodies);
            let (velocities, rest) = rest.split_at_mut(3 * bodies);
            let (accelerations, rest) = rest.split_at_mut(3 * bodies);
            let triples = |numbers| <[f64]>::as_chunks_mut::<3>(numbers).0.iter_mut();
            for (place, pose) in triples(positions).zip(&self.work.poses) {
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
    }
}

/// Work with the widest registers, for numbers side by side.
fn widest_of<S: SimdReal, R>(mut work: impl FnMut() -> R) -> R {
    if S::COUNT > 1 { widest(work) } else { work() }
}

/// `Φ_q x = right` with the factored equations. The right sides are overwritten.
#[inline(always)]
fn solve<S: SimdReal>(
    way: &Path,
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

/// Of two numbers; the second if it is not a number.
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
