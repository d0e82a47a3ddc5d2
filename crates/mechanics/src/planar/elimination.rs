//! Elimination of the Jacobian in an order of pivots that is selected once and serves in many positions.
//!
//! The columns of the explicit coordinates are eliminated first, at no cost in accuracy; in the loop equations pivots
//! are selected for few operations among those that are large in their row (H. M. Markowitz; I. S. Duff, A. M. Erisman,
//! J. K. Reid, *Direct Methods for Sparse Matrices*, ch. 7 and 9). A [`PivotOrder`] is the list of operations; the
//! numbers of a position are [`LuFactors`].

use super::{
    layout::EquationLayout,
    tolerances::{
        DEPENDENT_ROW, FALLING_PIVOT, INDEPENDENT_ROW, MIN_KEPT_PIVOT, MIN_PIVOT_OF_STEP, MIN_SELECTED_PIVOT,
        NEAR_SINGULAR_PIVOT,
    },
};
use dalembert_numerics::simd::SimdReal;

/// An order of pivots, with the operations that it takes on the places of the flat array.
#[derive(Debug, Clone)]
pub(super) struct PivotOrder {
    pivots: Vec<Pivot>,
    removals: Vec<Removal>,
    /// Places: of the entry that is changed, and of that by which it is.
    updates: Vec<(u32, u32)>,
    /// The entries to the right of each pivot: place and column.
    others: Vec<(u32, u32)>,
    /// The places of the Jacobian and, behind them, of the entries that fill in: what is constant in each, the entries
    /// that the elimination leaves so and the factors of its removals; zero in the others.
    constants: Vec<f64>,
    /// The places that are taken from the Jacobian.
    taken: Vec<u32>,
    /// The entries that a constant begins and the elimination goes on with: place and constant.
    begun: Vec<(u32, f64)>,
    /// The ratios that are not constant: place of the entry, and numbers of the ratio and the pivot.
    varying_ratios: Vec<[u32; 3]>,
    /// The number of explicit coordinates, whose pivots come first.
    first_loop: usize,
    /// The columns without a pivot: the independent velocities.
    pub(super) independent: Vec<usize>,
    /// Rows that follow from the others, with their places.
    dependent: Vec<(usize, Vec<usize>)>,
}

/// The Jacobian of a position, or of several in the lanes of `S`, eliminated in a [`PivotOrder`].
#[derive(Debug, Clone)]
pub(super) struct LuFactors<S = f64> {
    /// The Jacobian, overwritten by the elimination.
    jacobian: Vec<S>,
    /// One over each pivot.
    inverses: Vec<S>,
    /// The entries to the right of each pivot over it, with the sign changed.
    ratios: Vec<S>,
}

/// The conditioning of the constraint Jacobian in a position, eliminated in a given order of pivots.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Conditioning {
    Regular,
    /// The position is close to one in which an equation follows from the others: all that is left of a row is small,
    /// rather than its pivot alone.
    NearSingular,
    /// A pivot is so small in its row that this order is of no use, where another would be.
    Degenerate,
}

#[derive(Debug, Clone, Copy)]
struct Pivot {
    row: usize,
    column: usize,
    place: usize,
    /// The value when it was selected.
    selected: f64,
    /// End of its removals, which begin where those of the pivot before end.
    removals: usize,
    /// Begin and end of the entries to its right.
    others: [usize; 2],
}

/// The elimination of the column of a pivot from a row.
#[derive(Debug, Clone, Copy)]
struct Removal {
    row: usize,
    place: usize,
    /// The multiple of the pivot's row that is taken from this one, where it is the same in every position.
    constant: Option<f64>,
    /// End of its updates.
    updates: usize,
}

/// An entry of a row while the order is selected.
#[derive(Debug, Clone, Copy)]
struct Entry {
    column: usize,
    place: usize,
    value: f64,
    /// True if it has this value in every position.
    is_constant: bool,
}

impl PivotOrder {
    /// Selects an order for the Jacobian of a position, by its places, with so many columns.
    pub(super) fn new(layout: &EquationLayout, jacobian: &[f64], columns: usize) -> Self {
        let sizes: Vec<f64> = layout
            .rows
            .iter()
            .map(|row| row.iter().fold(0.0, |most: f64, (_, place)| most.max(jacobian[*place].abs())))
            .collect();
        let (mut selection, mut rows, mut of_column) = Selection::of_explicit(layout, jacobian, columns);
        let mut left = layout.loops.clone();
        while !left.is_empty() {
            let mut best: Option<(usize, usize, usize, f64)> = None;
            left.retain(|&row| {
                let most = largest(&rows[row]);
                if most <= DEPENDENT_ROW * sizes[row] {
                    let places = rows[row].iter().map(|entry| entry.place).collect();
                    selection.order.dependent.push((row, places));
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
                    if part >= MIN_SELECTED_PIVOT && better {
                        best = Some((row, entry.column, cost, part));
                    }
                }
                true
            });
            let Some((row, column, ..)) = best else { break };
            left.retain(|other| *other != row);
            selection.pivot(&mut rows, &mut of_column, row, column);
        }
        selection.done()
    }

    /// The order of the explicit coordinates alone, and what is left of the loop equations: places and columns of each.
    pub(super) fn of_explicit(
        layout: &EquationLayout,
        jacobian: &[f64],
        columns: usize,
    ) -> (Self, Vec<Vec<(usize, usize)>>) {
        let (selection, rows, _) = Selection::of_explicit(layout, jacobian, columns);
        let left = |row: &usize| rows[*row].iter().map(|entry| (entry.place, entry.column)).collect();
        let left = layout.loops.iter().map(left).collect();
        (selection.done(), left)
    }

    /// Room for the numbers of a position.
    pub(super) fn factors<S: SimdReal>(&self) -> LuFactors<S> {
        let ratio = |pivot: &Pivot| {
            let inverse = 1.0 / pivot.selected;
            let [from, to] = pivot.others;
            let others = self.others[from..to].iter();
            others.map(move |(place, _)| S::from(-self.constants[*place as usize] * inverse))
        };
        LuFactors {
            jacobian: self.constants.iter().map(|constant| S::from(*constant)).collect(),
            inverses: self.pivots.iter().map(|pivot| S::from(1.0 / pivot.selected)).collect(),
            ratios: self.pivots.iter().flat_map(ratio).collect(),
        }
    }

    /// Reports whether another order should be selected: a pivot has become small in its row, or a row that was
    /// dependent is independent.
    pub(super) fn is_weak(&self, layout: &EquationLayout, jacobian: &[f64], factors: &LuFactors) -> bool {
        (self.first_loop..self.pivots.len()).any(|index| self.is_small(factors, index, MIN_KEPT_PIVOT))
            || self.dependent.iter().any(|(row, places)| {
                let size = layout.rows[*row]
                    .iter()
                    .fold(0.0f64, |most, (_, place)| most.max(jacobian[*place].abs()));
                places.iter().any(|place| factors.jacobian[*place].abs() > INDEPENDENT_ROW * size)
            })
    }

    /// Compares a pivot with a fraction of the largest other entry of its row.
    fn is_small(&self, factors: &LuFactors, index: usize, fraction: f64) -> bool {
        let pivot = factors.jacobian[self.pivots[index].place].abs();
        self.others(index).iter().any(|(place, _)| fraction * factors.jacobian[*place as usize].abs() > pivot)
    }

    /// The conditioning of the position in this order.
    pub(super) fn conditioning(&self, factors: &LuFactors) -> Conditioning {
        let of_pivot = |index| {
            if self.is_small(factors, index, MIN_PIVOT_OF_STEP) {
                Conditioning::Degenerate
            } else if self.is_small(factors, index, MIN_SELECTED_PIVOT) {
                Conditioning::Regular
            } else {
                Conditioning::NearSingular
            }
        };
        self.fallen(factors).map(of_pivot).max().unwrap_or(Conditioning::Regular)
    }

    /// The smallest ratio of a pivot to its value when it was selected, at most 1.
    pub(super) fn smallest_pivot(&self, factors: &LuFactors) -> f64 {
        let ratios = self.pivots[self.first_loop..]
            .iter()
            .map(|pivot| (factors.jacobian[pivot.place] / pivot.selected).abs());
        ratios.fold(1.0, f64::min)
    }

    /// Reports whether a pivot has fallen so far that it may vanish within a step.
    pub(super) fn is_falling(&self, factors: &LuFactors) -> bool {
        self.pivots[self.first_loop..]
            .iter()
            .any(|pivot| factors.jacobian[pivot.place].abs() < FALLING_PIVOT * pivot.selected.abs())
    }

    /// The entries that the elimination leaves of the loop equations: of each its pivot, then those to the right.
    pub(super) fn reduced_rows(&self, factors: &LuFactors) -> Vec<f64> {
        let of_pivot = |index: usize| {
            let others = self.others(index).iter().map(|(place, _)| factors.jacobian[*place as usize]);
            std::iter::once(factors.jacobian[self.pivots[index].place]).chain(others)
        };
        (self.first_loop..self.pivots.len()).flat_map(of_pivot).collect()
    }

    /// The number of steps, behind and ahead, after which a reduced row vanishes, extrapolated from its entries before
    /// and after one step.
    pub(super) fn steps_to_singularity(&self, before: &[f64], after: &[f64]) -> [f64; 2] {
        let mut from = 0;
        let mut nearest = [f64::INFINITY; 2];
        for index in self.first_loop..self.pivots.len() {
            let row = from..from + 1 + self.others(index).len();
            from = row.end;
            let change = || before[row.clone()].iter().zip(&after[row.clone()]).map(|(a, b)| (*a, b - a));
            let square: f64 = change().map(|(_, change)| change * change).sum();
            let steps = -change().map(|(a, change)| a * change).sum::<f64>() / square;
            let left = change().fold(0.0f64, |most, (a, change)| most.max((a + steps * change).abs()));
            if left < NEAR_SINGULAR_PIVOT * self.pivots[index].selected.abs() {
                let side = usize::from(steps > 0.0);
                nearest[side] = nearest[side].min(steps.abs());
            }
        }
        nearest
    }

    /// The pivots that are far below their values when they were selected.
    fn fallen<'f>(&'f self, factors: &'f LuFactors) -> impl Iterator<Item = usize> + 'f {
        (self.first_loop..self.pivots.len()).filter(|&index| {
            let Pivot { place, selected, .. } = self.pivots[index];
            factors.jacobian[place].abs() < NEAR_SINGULAR_PIVOT * selected.abs()
        })
    }

    /// Eliminates the Jacobian of a position, given by its places.
    #[inline(always)]
    pub(super) fn eliminate<S: SimdReal>(&self, jacobian: &[S], factors: &mut LuFactors<S>) {
        self.eliminate_rows(jacobian, factors);
        self.set_ratios(factors);
    }

    /// The same without the ratios that back substitution takes.
    #[inline(always)]
    pub(super) fn eliminate_rows<S: SimdReal>(&self, jacobian: &[S], factors: &mut LuFactors<S>) {
        let Self { pivots, removals, updates, first_loop, .. } = self;
        let LuFactors { jacobian: w, inverses, .. } = factors;
        for &place in &self.taken {
            w[place as usize] = jacobian[place as usize];
        }
        for &(place, constant) in &self.begun {
            w[place as usize] = S::from(constant);
        }
        let (mut removal, mut update) = (0, 0);
        for (index, (pivot, inverse)) in pivots.iter().zip(inverses).enumerate() {
            // The entries by explicit coordinates are constant.
            if index >= *first_loop {
                *inverse = S::from(1.0) / w[pivot.place];
            }
            for one in &removals[removal..pivot.removals] {
                let factor = match one.constant {
                    Some(constant) => S::from(constant),
                    None => {
                        let factor = w[one.place] * *inverse;
                        w[one.place] = factor;
                        factor
                    }
                };
                for &(target, source) in &updates[update..one.updates] {
                    w[target as usize] = w[target as usize] - factor * w[source as usize];
                }
                update = one.updates;
            }
            removal = pivot.removals;
        }
    }

    /// The ratios of the entries to the right of each pivot to it.
    #[inline(always)]
    pub(super) fn set_ratios<S: SimdReal>(&self, factors: &mut LuFactors<S>) {
        let LuFactors { jacobian: w, inverses, ratios } = factors;
        for [place, number, pivot] in self.varying_ratios.iter().map(|of| of.map(|n| n as usize)) {
            ratios[number] = -w[place] * inverses[pivot];
        }
    }

    /// A solution `x` of `Φ_q x = rhs`, zero in the independent columns: `rhs` by rows, `x` by columns. The right-hand
    /// side is overwritten.
    #[inline(always)]
    pub(super) fn solve<S: SimdReal>(&self, factors: &LuFactors<S>, rhs: &mut [S], x: &mut [S]) {
        self.reduce(factors, rhs);
        for &column in &self.independent {
            x[column] = S::from(0.0);
        }
        self.back_substitute(factors, rhs, x);
    }

    /// Forward elimination of a right-hand side.
    #[inline(always)]
    pub(super) fn reduce<S: SimdReal>(&self, factors: &LuFactors<S>, rhs: &mut [S]) {
        let mut removal = 0;
        for pivot in &self.pivots {
            let known = rhs[pivot.row];
            for one in &self.removals[removal..pivot.removals] {
                rhs[one.row] = rhs[one.row] - factors.jacobian[one.place] * known;
            }
            removal = pivot.removals;
        }
    }

    /// Back substitution: the other columns of a solution from the independent ones and the reduced right-hand side.
    #[inline(always)]
    pub(super) fn back_substitute<S: SimdReal>(&self, factors: &LuFactors<S>, rhs: &[S], x: &mut [S]) {
        for (pivot, inverse) in self.pivots.iter().zip(&factors.inverses).rev() {
            x[pivot.column] = self.in_row(factors, pivot, rhs[pivot.row] * *inverse, x);
        }
    }

    /// The null-space vector `x` of `Φ_q` with 1 in the independent column of this number and 0 in the others.
    #[inline(always)]
    pub(super) fn null_vector<S: SimdReal>(&self, factors: &LuFactors<S>, number: usize, x: &mut [S]) {
        for &column in &self.independent {
            x[column] = S::from(0.0);
        }
        x[self.independent[number]] = S::from(1.0);
        for pivot in self.pivots.iter().rev() {
            x[pivot.column] = self.in_row(factors, pivot, S::from(0.0), x);
        }
    }

    /// The multipliers `y` with `Φ_qᵀ y = g`, by rows; zero for rows that depend on others. `g`, by columns, is
    /// overwritten.
    #[inline(always)]
    pub(super) fn solve_transposed<S: SimdReal>(&self, factors: &LuFactors<S>, g: &mut [S], y: &mut [S]) {
        y.fill(S::from(0.0));
        self.reduce_transposed(factors, g, y);
        self.back_substitute_transposed(factors, y);
    }

    /// The first half of the multipliers: `g` is reduced to the columns without a pivot.
    #[inline(always)]
    pub(super) fn reduce_transposed<S: SimdReal>(&self, factors: &LuFactors<S>, g: &mut [S], y: &mut [S]) {
        for (index, pivot) in self.pivots.iter().enumerate() {
            let z = g[pivot.column] * factors.inverses[index];
            y[pivot.row] = z;
            for &(place, column) in self.others(index) {
                g[column as usize] = g[column as usize] - factors.jacobian[place as usize] * z;
            }
        }
    }

    /// The second half, with the multipliers of the rows that have no pivot in place.
    #[inline(always)]
    pub(super) fn back_substitute_transposed<S: SimdReal>(&self, factors: &LuFactors<S>, y: &mut [S]) {
        for (index, pivot) in self.pivots.iter().enumerate().rev() {
            let from = if index == 0 { 0 } else { self.pivots[index - 1].removals };
            for one in &self.removals[from..pivot.removals] {
                y[pivot.row] = y[pivot.row] - factors.jacobian[one.place] * y[one.row];
            }
        }
    }

    /// The value in the column of a pivot, from those to its right.
    #[inline(always)]
    fn in_row<S: SimdReal>(&self, factors: &LuFactors<S>, pivot: &Pivot, start: S, x: &[S]) -> S {
        let [from, to] = pivot.others;
        let mut sum = start;
        for (ratio, (_, column)) in factors.ratios[from..to].iter().zip(&self.others[from..to]) {
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

impl<S: SimdReal> LuFactors<S> {
    /// An entry as the elimination leaves it.
    #[inline(always)]
    pub(super) fn entry(&self, place: usize) -> S {
        self.jacobian[place]
    }
}

/// An order of pivots while it is selected.
struct Selection {
    order: PivotOrder,
    has_pivot: Vec<bool>,
}

impl Selection {
    /// Eliminates the explicit columns: the selection so far, what is left of the rows, and the rows of each column.
    fn of_explicit(
        layout: &EquationLayout,
        jacobian: &[f64],
        columns: usize,
    ) -> (Self, Vec<Vec<Entry>>, Vec<Vec<usize>>) {
        let entry = |&(column, place): &(usize, usize)| {
            let constant = layout.constant(place);
            let value = constant.unwrap_or(jacobian[place]);
            Entry { column, place, value, is_constant: constant.is_some() }
        };
        let mut rows: Vec<Vec<Entry>> =
            layout.rows.iter().map(|row| row.iter().map(entry).collect()).collect();
        let mut of_column: Vec<Vec<usize>> = vec![Vec::new(); columns];
        for (row, entries) in rows.iter().enumerate() {
            for entry in entries {
                of_column[entry.column].push(row);
            }
        }
        let places = rows.iter().flatten();
        let taken = places.filter(|entry| !entry.is_constant).map(|entry| entry.place as u32);
        let order = PivotOrder {
            pivots: Vec::new(),
            removals: Vec::new(),
            updates: Vec::new(),
            others: Vec::new(),
            constants: (0..layout.places()).map(|place| layout.constant(place).unwrap_or(0.0)).collect(),
            taken: taken.collect(),
            begun: Vec::new(),
            varying_ratios: Vec::new(),
            first_loop: layout.explicit.len(),
            independent: Vec::new(),
            dependent: Vec::new(),
        };
        let mut selection = Self { order, has_pivot: vec![false; columns] };
        for explicit in layout.explicit.iter().rev() {
            selection.pivot(&mut rows, &mut of_column, explicit.row, explicit.column);
        }
        (selection, rows, of_column)
    }

    /// The order as selected.
    fn done(self) -> PivotOrder {
        let Self { mut order, has_pivot } = self;
        order.independent = (0..has_pivot.len()).filter(|&column| !has_pivot[column]).collect();
        order
    }

    /// Eliminates a column from all rows but its pivot's.
    fn pivot(&mut self, rows: &mut [Vec<Entry>], of_column: &mut [Vec<usize>], row: usize, column: usize) {
        let order = &mut self.order;
        self.has_pivot[column] = true;
        let own = std::mem::take(&mut rows[row]);
        let Some(&pivot) = own.iter().find(|entry| entry.column == column) else { return };
        for entry in &own {
            of_column[entry.column].retain(|other| *other != row);
        }
        let is_explicit = order.pivots.len() < order.first_loop;
        for other in std::mem::take(&mut of_column[column]) {
            let Some(at) = rows[other].iter().position(|entry| entry.column == column) else { continue };
            let removed = rows[other].swap_remove(at);
            let factor = removed.value * (1.0 / pivot.value);
            let constant = (is_explicit && removed.is_constant).then_some(factor);
            match constant {
                // What two ways to the same body leave of its origin.
                Some(0.0) => continue,
                Some(constant) => order.constants[removed.place] = constant,
                None => {}
            }
            for entry in own.iter().filter(|entry| entry.column != column) {
                let found = rows[other].iter().position(|target| target.column == entry.column);
                let at = found.unwrap_or_else(|| {
                    let place = order.constants.len();
                    rows[other].push(Entry { column: entry.column, place, value: 0.0, is_constant: true });
                    of_column[entry.column].push(other);
                    order.constants.push(0.0);
                    rows[other].len() - 1
                });
                let target = &mut rows[other][at];
                let before = target.value;
                target.value -= factor * entry.value;
                if constant.is_some() && entry.is_constant && target.is_constant {
                    order.constants[target.place] = target.value;
                    continue;
                }
                if std::mem::take(&mut target.is_constant) {
                    order.constants[target.place] = 0.0;
                    order.begun.push((target.place as u32, before));
                }
                order.updates.push((target.place as u32, entry.place as u32));
            }
            let updates = order.updates.len();
            order.removals.push(Removal { row: other, place: removed.place, constant, updates });
        }
        let from = order.others.len();
        for entry in own.iter().filter(|entry| entry.column != column) {
            if !(is_explicit && entry.is_constant) {
                let numbers = [entry.place, order.others.len(), order.pivots.len()];
                order.varying_ratios.push(numbers.map(|n| n as u32));
            }
            order.others.push((entry.place as u32, entry.column as u32));
        }
        let (removals, others) = (order.removals.len(), [from, order.others.len()]);
        let Entry { place, value: selected, .. } = pivot;
        order.pivots.push(Pivot { row, column, place, selected, removals, others });
    }
}

/// The largest entry of a row.
fn largest(row: &[Entry]) -> f64 {
    row.iter().fold(0.0, |most, entry| most.max(entry.value.abs()))
}
