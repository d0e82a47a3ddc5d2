//! The elimination of a layout's equations in an order chosen once.

#![expect(clippy::inline_always, reason = "what is not inlined is not compiled for the widest registers")]

use super::Layout;
use dalembert_numerics::simd::SimdReal;

/// A pivot must have this part of the largest entry of its row when it is chosen …
const CHOSEN: f64 = 0.3;
/// … and may fall to this part before another order is searched for.
const KEPT: f64 = 0.03;
/// Below this part it multiplies errors so much that a step must not go there.
const LOST: f64 = 0.01;
/// Below this part of what it was when it was chosen, a pivot tells of a singular position nearby.
const LOW: f64 = 0.05;
/// Below this part of it, it may vanish within a step.
const FALLS: f64 = 0.5;
/// A row whose entries have fallen to this part of what they were follows from the others.
const FOLLOWS: f64 = 1e-8;

/// An order of elimination, and the numbers of one position or of several side by side.
#[derive(Debug, Clone)]
pub(in super::super) struct Order<S = f64> {
    pivots: Vec<Pivot>,
    removals: Vec<Removal>,
    /// Places: what is changed, and by what.
    updates: Vec<(u32, u32)>,
    /// Entries to the right of each pivot: place and column.
    others: Vec<(u32, u32)>,
    /// The first pivot that is not of an explicit coordinate.
    first_loop: usize,
    /// The columns that are left free.
    pub(in super::super) free: Vec<usize>,
    /// Rows that follow from the others, with their places.
    dropped: Vec<(usize, Vec<usize>)>,
    /// The Jacobian, overwritten by the elimination.
    jacobian: Vec<S>,
    inverses: Vec<S>,
    /// The entries to the right of each pivot over it, with the sign changed.
    ratios: Vec<S>,
}

/// The conditioning of the constraint Jacobian in a position, eliminated in a given order of pivots.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(in super::super) enum Conditioning {
    Regular,
    /// The position is close to one in which an equation follows from the others: all that is left of a row is small,
    /// rather than its pivot alone.
    NearSingular,
    /// A pivot is so small in its row that the order is of no use, where another would be.
    Singular,
}

#[derive(Debug, Clone, Copy)]
struct Pivot {
    row: usize,
    column: usize,
    place: usize,
    /// Value at the time of the choice.
    chosen: f64,
    /// End of its removals; they begin where those of the pivot before end.
    removals: usize,
    /// Begin and end of its others.
    others: [usize; 2],
}

/// The column of a pivot is taken out of a row.
#[derive(Debug, Clone, Copy)]
struct Removal {
    row: usize,
    place: usize,
    /// End of its updates.
    updates: usize,
}

/// An entry of a row while the order is made.
#[derive(Debug, Clone, Copy)]
struct Entry {
    column: usize,
    place: usize,
    value: f64,
}

impl Order {
    /// Chooses an order for the Jacobian of a position.
    pub(in super::super) fn new(layout: &Layout, jacobian: &[f64], columns: usize) -> Self {
        let sizes: Vec<f64> = layout
            .rows
            .iter()
            .map(|row| row.iter().fold(0.0, |most: f64, (_, place)| most.max(jacobian[*place].abs())))
            .collect();
        let (mut maker, mut rows, mut of_column) = Maker::of_explicit(layout, jacobian, columns);
        let mut left = layout.loops.clone();
        while !left.is_empty() {
            let mut best: Option<(usize, usize, usize, f64)> = None;
            left.retain(|&row| {
                let most = largest(&rows[row]);
                if most <= FOLLOWS * sizes[row] {
                    let places = rows[row].iter().map(|entry| entry.place).collect();
                    maker.order.dropped.push((row, places));
                    for entry in &rows[row] {
                        of_column[entry.column].retain(|other| *other != row);
                    }
                    return false;
                }
                for entry in &rows[row] {
                    let part = entry.value.abs() / most;
                    let cost = (rows[row].len() - 1) * (of_column[entry.column].len() - 1);
                    let better = best.is_none_or(|(_, _, least, biggest)| {
                        cost < least || (cost == least && part > biggest)
                    });
                    if part >= CHOSEN && better {
                        best = Some((row, entry.column, cost, part));
                    }
                }
                true
            });
            let Some((row, column, ..)) = best else { break };
            left.retain(|other| *other != row);
            maker.pivot(&mut rows, &mut of_column, row, column);
        }
        maker.done(columns)
    }

    /// The order of the explicit coordinates alone, and what is left of the other rows: the places and columns of
    /// each.
    pub(in super::super) fn of_explicit(
        layout: &Layout,
        jacobian: &[f64],
        columns: usize,
    ) -> (Self, Vec<Vec<(usize, usize)>>) {
        let (maker, rows, _) = Maker::of_explicit(layout, jacobian, columns);
        let left = |row: &usize| rows[*row].iter().map(|entry| (entry.place, entry.column)).collect();
        let left = layout.loops.iter().map(left).collect();
        (maker.done(columns), left)
    }

    /// The same order for other numbers, none of them eliminated yet.
    pub(in super::super) fn with_numbers<S: SimdReal>(&self) -> Order<S> {
        let zeros = |count| vec![S::from(0.0); count];
        Order {
            pivots: self.pivots.clone(),
            removals: self.removals.clone(),
            updates: self.updates.clone(),
            others: self.others.clone(),
            first_loop: self.first_loop,
            free: self.free.clone(),
            dropped: self.dropped.clone(),
            jacobian: zeros(self.jacobian.len()),
            inverses: self.pivots.iter().map(|pivot| S::from(1.0 / pivot.chosen)).collect(),
            ratios: zeros(self.ratios.len()),
        }
    }

    /// Returns true if another pivot order should be chosen: a pivot has become small in its row, or a dropped row has
    /// become independent.
    pub(in super::super) fn is_weak(&self, layout: &Layout, jacobian: &[f64]) -> bool {
        (self.first_loop..self.pivots.len()).any(|index| self.is_small(index, KEPT))
            || self.dropped.iter().any(|(row, places)| {
                let size = layout.rows[*row]
                    .iter()
                    .fold(0.0f64, |most, (_, place)| most.max(jacobian[*place].abs()));
                places.iter().any(|place| self.jacobian[*place].abs() > 10.0 * FOLLOWS * size)
            })
    }

    /// Returns true if a pivot is below a part of the rest of its row.
    fn is_small(&self, index: usize, part: f64) -> bool {
        let pivot = self.jacobian[self.pivots[index].place].abs();
        self.others(index).iter().any(|(place, _)| part * self.jacobian[*place as usize].abs() > pivot)
    }

    /// Conditioning of the order in the position.
    pub(in super::super) fn conditioning(&self) -> Conditioning {
        let of_pivot = |index| {
            if self.is_small(index, LOST) {
                Conditioning::Singular
            } else if self.is_small(index, CHOSEN) {
                Conditioning::Regular
            } else {
                Conditioning::NearSingular
            }
        };
        self.low().map(of_pivot).max().unwrap_or(Conditioning::Regular)
    }

    /// The smallest part of what it was to which a pivot has fallen.
    pub(in super::super) fn weakest(&self) -> f64 {
        let parts = self.pivots[self.first_loop..]
            .iter()
            .map(|pivot| (self.jacobian[pivot.place] / pivot.chosen).abs());
        parts.fold(1.0, f64::min)
    }

    /// Returns true if a pivot may vanish soon.
    pub(in super::super) fn falls(&self) -> bool {
        self.pivots[self.first_loop..]
            .iter()
            .any(|pivot| self.jacobian[pivot.place].abs() < FALLS * pivot.chosen.abs())
    }

    /// Remainder of the rows that are not explicit after elimination.
    pub(in super::super) fn rows_left(&self) -> Vec<f64> {
        let of_pivot = |index: usize| {
            let others = self.others(index).iter().map(|(place, _)| self.jacobian[*place as usize]);
            std::iter::once(self.jacobian[self.pivots[index].place]).chain(others)
        };
        (self.first_loop..self.pivots.len()).flat_map(of_pivot).collect()
    }

    /// Distances, backwards and forwards and in units of that between two positions, at which a row of the remainder
    /// vanishes.
    pub(in super::super) fn vanish(&self, before: &[f64], after: &[f64]) -> [f64; 2] {
        let mut from = 0;
        let mut nearest = [f64::INFINITY; 2];
        for index in self.first_loop..self.pivots.len() {
            let row = from..from + 1 + self.others(index).len();
            from = row.end;
            let change = || before[row.clone()].iter().zip(&after[row.clone()]).map(|(a, b)| (*a, b - a));
            let square: f64 = change().map(|(_, change)| change * change).sum();
            let steps = -change().map(|(a, change)| a * change).sum::<f64>() / square;
            let left = change().fold(0.0f64, |most, (a, change)| most.max((a + steps * change).abs()));
            if left < LOW * self.pivots[index].chosen.abs() {
                let side = usize::from(steps > 0.0);
                nearest[side] = nearest[side].min(steps.abs());
            }
        }
        nearest
    }

    /// The pivots that are far below what they were.
    fn low(&self) -> impl Iterator<Item = usize> + '_ {
        (self.first_loop..self.pivots.len()).filter(|&index| {
            let Pivot { place, chosen, .. } = self.pivots[index];
            self.jacobian[place].abs() < LOW * chosen.abs()
        })
    }
}

impl<S: SimdReal> Order<S> {
    /// Eliminates the Jacobian of a position.
    #[inline(always)]
    pub(in super::super) fn eliminate(&mut self, jacobian: &[S]) {
        let Self { pivots, removals, updates, others, jacobian: w, inverses, ratios, first_loop, .. } = self;
        let (given, filled) = w.split_at_mut(jacobian.len());
        given.copy_from_slice(jacobian);
        filled.fill(S::from(0.0));
        let (mut removal, mut update) = (0, 0);
        for (index, (pivot, inverse)) in pivots.iter().zip(inverses).enumerate() {
            // The entries by explicit coordinates are constant.
            if index >= *first_loop {
                *inverse = S::from(1.0) / w[pivot.place];
            }
            for one in &removals[removal..pivot.removals] {
                let factor = w[one.place] * *inverse;
                w[one.place] = factor;
                for &(target, source) in &updates[update..one.updates] {
                    w[target as usize] = w[target as usize] - factor * w[source as usize];
                }
                update = one.updates;
            }
            removal = pivot.removals;
            let [from, to] = pivot.others;
            for (ratio, (place, _)) in ratios[from..to].iter_mut().zip(&others[from..to]) {
                *ratio = -w[*place as usize] * *inverse;
            }
        }
    }

    /// A solution for the given right sides, with zero in the free columns. The right sides are overwritten.
    #[inline(always)]
    pub(in super::super) fn solve(&self, right: &mut [S], x: &mut [S]) {
        self.reduce(right);
        for &column in &self.free {
            x[column] = S::from(0.0);
        }
        self.complete(right, x);
    }

    /// Applies the elimination to right-hand sides.
    #[inline(always)]
    pub(in super::super) fn reduce(&self, right: &mut [S]) {
        let mut removal = 0;
        for pivot in &self.pivots {
            let known = right[pivot.row];
            for one in &self.removals[removal..pivot.removals] {
                right[one.row] = right[one.row] - self.jacobian[one.place] * known;
            }
            removal = pivot.removals;
        }
    }

    /// The other columns of a solution from the free ones and the reduced right sides.
    #[inline(always)]
    pub(in super::super) fn complete(&self, right: &[S], x: &mut [S]) {
        for (pivot, inverse) in self.pivots.iter().zip(&self.inverses).rev() {
            x[pivot.column] = self.continue_to(pivot, right[pivot.row] * *inverse, x);
        }
    }

    /// The velocities that the equations leave, with 1 in one free column.
    #[inline(always)]
    pub(in super::super) fn motion(&self, free: usize, x: &mut [S]) {
        for &column in &self.free {
            x[column] = S::from(0.0);
        }
        x[self.free[free]] = S::from(1.0);
        for pivot in self.pivots.iter().rev() {
            x[pivot.column] = self.continue_to(pivot, S::from(0.0), x);
        }
    }

    /// The multipliers `y` with `Aᵀ y = g`; zero for rows that follow from others. `g` is overwritten.
    #[inline(always)]
    pub(in super::super) fn multipliers(&self, g: &mut [S], y: &mut [S]) {
        y.fill(S::from(0.0));
        self.reduce_transposed(g, y);
        self.complete_transposed(y);
    }

    /// The first half of the multipliers: `g` becomes what is left of it for the free columns.
    #[inline(always)]
    pub(in super::super) fn reduce_transposed(&self, g: &mut [S], y: &mut [S]) {
        for (index, pivot) in self.pivots.iter().enumerate() {
            let z = g[pivot.column] * self.inverses[index];
            y[pivot.row] = z;
            for &(place, column) in self.others(index) {
                g[column as usize] = g[column as usize] - self.jacobian[place as usize] * z;
            }
        }
    }

    /// The second half, with the multipliers of the rows that have no pivot in place.
    #[inline(always)]
    pub(in super::super) fn complete_transposed(&self, y: &mut [S]) {
        for (index, pivot) in self.pivots.iter().enumerate().rev() {
            let from = if index == 0 { 0 } else { self.pivots[index - 1].removals };
            for one in &self.removals[from..pivot.removals] {
                y[pivot.row] = y[pivot.row] - self.jacobian[one.place] * y[one.row];
            }
        }
    }

    /// An entry as the elimination leaves it.
    #[inline(always)]
    pub(in super::super) fn eliminated(&self, place: usize) -> S {
        self.jacobian[place]
    }

    /// Entry in the column of a pivot, by those to its right.
    #[inline(always)]
    fn continue_to(&self, pivot: &Pivot, start: S, x: &[S]) -> S {
        let [from, to] = pivot.others;
        let mut sum = start;
        for (ratio, (_, column)) in self.ratios[from..to].iter().zip(&self.others[from..to]) {
            sum = sum + *ratio * x[*column as usize];
        }
        sum
    }

    #[inline(always)]
    fn others(&self, index: usize) -> &[(u32, u32)] {
        let [from, to] = self.pivots[index].others;
        &self.others[from..to]
    }
}

struct Maker {
    order: Order,
    places: usize,
    taken: Vec<bool>,
}

impl Maker {
    /// Takes the explicit columns out of all rows: the maker, what is left of the rows, and the rows of each column.
    fn of_explicit(
        layout: &Layout,
        jacobian: &[f64],
        columns: usize,
    ) -> (Self, Vec<Vec<Entry>>, Vec<Vec<usize>>) {
        let entry = |&(column, place): &(usize, usize)| Entry { column, place, value: jacobian[place] };
        let mut rows: Vec<Vec<Entry>> =
            layout.rows.iter().map(|row| row.iter().map(entry).collect()).collect();
        let mut of_column: Vec<Vec<usize>> = vec![Vec::new(); columns];
        for (row, entries) in rows.iter().enumerate() {
            for entry in entries {
                of_column[entry.column].push(row);
            }
        }
        let order = Order {
            pivots: Vec::new(),
            removals: Vec::new(),
            updates: Vec::new(),
            others: Vec::new(),
            first_loop: layout.explicit.len(),
            free: Vec::new(),
            dropped: Vec::new(),
            jacobian: Vec::new(),
            inverses: Vec::new(),
            ratios: Vec::new(),
        };
        let mut maker = Self { order, places: layout.places, taken: vec![false; columns] };
        for &(row, column, _) in layout.explicit.iter().rev() {
            maker.pivot(&mut rows, &mut of_column, row, column);
        }
        (maker, rows, of_column)
    }

    /// The order as found, with room for its numbers.
    fn done(self, columns: usize) -> Order {
        let Self { mut order, places, taken } = self;
        order.free = (0..columns).filter(|column| !taken[*column]).collect();
        order.jacobian = vec![0.0; places];
        order.ratios = vec![0.0; order.others.len()];
        order.inverses = order.pivots.iter().map(|pivot| 1.0 / pivot.chosen).collect();
        order
    }

    /// Takes a column out of all rows but one.
    fn pivot(&mut self, rows: &mut [Vec<Entry>], of_column: &mut [Vec<usize>], row: usize, column: usize) {
        let order = &mut self.order;
        self.taken[column] = true;
        let own = std::mem::take(&mut rows[row]);
        let Some(&pivot) = own.iter().find(|entry| entry.column == column) else { return };
        for entry in &own {
            of_column[entry.column].retain(|other| *other != row);
        }
        for other in std::mem::take(&mut of_column[column]) {
            let Some(at) = rows[other].iter().position(|entry| entry.column == column) else { continue };
            let removed = rows[other].swap_remove(at);
            let factor = removed.value / pivot.value;
            for entry in own.iter().filter(|entry| entry.column != column) {
                let found = rows[other].iter().position(|target| target.column == entry.column);
                let at = found.unwrap_or_else(|| {
                    rows[other].push(Entry { column: entry.column, place: self.places, value: 0.0 });
                    of_column[entry.column].push(other);
                    self.places += 1;
                    rows[other].len() - 1
                });
                let target = &mut rows[other][at];
                target.value -= factor * entry.value;
                order.updates.push((target.place as u32, entry.place as u32));
            }
            order.removals.push(Removal { row: other, place: removed.place, updates: order.updates.len() });
        }
        let from = order.others.len();
        let right = own.iter().filter(|entry| entry.column != column);
        order.others.extend(right.map(|entry| (entry.place as u32, entry.column as u32)));
        let (removals, others) = (order.removals.len(), [from, order.others.len()]);
        let Entry { place, value: chosen, .. } = pivot;
        order.pivots.push(Pivot { row, column, place, chosen, removals, others });
    }
}

fn largest(row: &[Entry]) -> f64 {
    row.iter().fold(0.0, |most, entry| most.max(entry.value.abs()))
}
