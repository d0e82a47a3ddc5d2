//! Elimination that tells which equations say something new.

use nalgebra::DMatrix;

use super::{LinalgError, SparseMatrix};

/// A pivot below this part of the largest entry of the scaled matrix counts as zero.
const NEGLIGIBLE: f64 = 1e-10;

/// `P A Q = L U` with the largest entry left as the next pivot (Golub & Van Loan, Matrix Computations, 4th ed.,
/// §3.4.8), of a matrix with any number of rows and columns. Zeros take neither room nor time.
///
/// Rows are first scaled to a largest entry of 1. What remains below 10⁻¹⁰ of the first pivot is taken as zero:
/// so many rows depend on the others, and so many columns are left to choose.
#[derive(Debug, Clone)]
pub struct Elimination {
    /// The pivots, in order.
    pivots: Vec<f64>,
    /// L below its unit diagonal, of the scaled matrix: of each column the places of its rows and their entries.
    lower: Lists,
    /// U above its diagonal: of each place of a column the places of its rows and their entries.
    upper: Lists,
    scale: Vec<f64>,
    /// The row and the column of A that stand in each place.
    rows: Vec<usize>,
    columns: Vec<usize>,
}

/// Lists of entries with their numbers, one after the other.
#[derive(Debug, Clone, Default)]
struct Lists {
    entries: Vec<(usize, f64)>,
    ends: Vec<usize>,
}

impl Lists {
    fn list(&self, number: usize) -> &[(usize, f64)] {
        let from = if number == 0 { 0 } else { self.ends[number - 1] };
        &self.entries[from..self.ends[number]]
    }
}

/// An order of rows or columns while it is changed: what stands in each place, and where each stands.
struct Order {
    at: Vec<usize>,
    place_of: Vec<usize>,
}

impl Order {
    fn new(count: usize) -> Self {
        Self { at: (0..count).collect(), place_of: (0..count).collect() }
    }

    fn swap(&mut self, a: usize, b: usize) {
        self.at.swap(a, b);
        (self.place_of[self.at[a]], self.place_of[self.at[b]]) = (a, b);
    }
}

impl Elimination {
    /// Factors a matrix.
    ///
    /// # Errors
    /// `NotFinite`.
    pub fn new(a: &DMatrix<f64>) -> Result<Self, LinalgError> {
        Self::of_sparse(&SparseMatrix::from(a))
    }

    /// Factors a matrix of which the entries different from zero are given.
    ///
    /// # Errors
    /// `NotFinite`.
    pub fn of_sparse(a: &SparseMatrix) -> Result<Self, LinalgError> {
        let (m, n) = (a.rows().len(), a.columns());
        if a.rows().iter().flatten().any(|(_, x)| !x.is_finite()) {
            return Err(LinalgError::NotFinite);
        }
        // What is left: the entries of each column, and the columns that each row has or had an entry in.
        let mut counts = vec![0; n];
        for (column, _) in a.rows().iter().flatten() {
            counts[*column] += 1;
        }
        let mut left: Vec<Vec<(usize, f64)>> = counts.into_iter().map(Vec::with_capacity).collect();
        let mut columns_of: Vec<Vec<usize>> = Vec::with_capacity(m);
        let mut scale = Vec::with_capacity(m);
        for (row, entries) in a.rows().iter().enumerate() {
            let most = entries.iter().fold(0.0, |most, (_, x)| f64::max(most, x.abs()));
            let factor = if most > 0.0 { 1.0 / most } else { 1.0 };
            for &(column, x) in entries {
                left[column].push((row, x * factor));
            }
            columns_of.push(entries.iter().map(|(column, _)| *column).collect());
            scale.push(factor);
        }
        // The largest entry of the column in each place.
        let mut largest_of: Vec<f64> = left.iter().map(|column| largest(column)).collect();
        let (mut rows, mut columns) = (Order::new(m), Order::new(n));
        let mut above: Vec<Vec<(usize, f64)>> = vec![Vec::new(); n];
        let (mut pivots, mut lower, mut upper) = (Vec::new(), Lists::default(), Lists::default());
        // Where the rows of a column stand in its list, from 1; 0 for those that it does not have.
        let mut position = vec![0; m];
        let mut first = 0.0;
        for place in 0..m.min(n) {
            let (mut most, mut at) = (0.0, place);
            for (column, &largest) in largest_of.iter().enumerate().skip(place) {
                if largest > most {
                    (most, at) = (largest, column);
                }
            }
            first = f64::max(first, most);
            if most <= NEGLIGIBLE * first {
                break;
            }
            columns.swap(place, at);
            largest_of.swap(place, at);
            let entries = std::mem::take(&mut left[columns.at[place]]);
            let largest = entries.iter().filter(|(_, x)| x.abs() >= most);
            let Some(&(row, pivot)) = largest.min_by_key(|(row, _)| rows.place_of[*row]) else { break };
            rows.swap(place, rows.place_of[row]);
            pivots.push(pivot);
            let from = lower.entries.len();
            let others = entries.iter().filter(|(other, x)| *other != row && *x != 0.0);
            lower.entries.extend(others.map(|&(other, x)| (other, x / pivot)));
            lower.ends.push(lower.entries.len());
            for column in std::mem::take(&mut columns_of[row]) {
                if columns.place_of[column] <= place {
                    continue;
                }
                let list = &mut left[column];
                for (index, (row, _)) in list.iter().enumerate() {
                    position[*row] = index + 1;
                }
                let own = position[row] - 1;
                let x = list[own].1;
                if x != 0.0 {
                    for &(other, factor) in &lower.entries[from..] {
                        if position[other] == 0 {
                            list.push((other, -factor * x));
                            columns_of[other].push(column);
                        } else {
                            list[position[other] - 1].1 -= factor * x;
                        }
                    }
                    above[column].push((place, x));
                }
                for (row, _) in &*list {
                    position[*row] = 0;
                }
                list.swap_remove(own);
                largest_of[columns.place_of[column]] = self::largest(list);
            }
        }
        // Rows by their places.
        let mut from = 0;
        let mut kept = Lists::default();
        for &end in &lower.ends {
            let begin = kept.entries.len();
            let places = lower.entries[from..end].iter().map(|&(row, x)| (rows.place_of[row], x));
            kept.entries.extend(places.filter(|(place, _)| *place < pivots.len()));
            kept.entries[begin..].sort_unstable_by_key(|(place, _)| *place);
            kept.ends.push(kept.entries.len());
            from = end;
        }
        for &column in &columns.at {
            upper.entries.append(&mut above[column]);
            upper.ends.push(upper.entries.len());
        }
        Ok(Self { pivots, lower: kept, upper, scale, rows: rows.at, columns: columns.at })
    }

    /// Rank: the number of linearly independent rows.
    pub fn rank(&self) -> usize {
        self.pivots.len()
    }

    /// The rows that are kept, the most telling first.
    pub fn independent_rows(&self) -> &[usize] {
        &self.rows[..self.rank()]
    }

    /// The rows that follow from the others.
    pub fn dependent_rows(&self) -> &[usize] {
        &self.rows[self.rank()..]
    }

    /// The columns that may be chosen freely.
    pub fn free_columns(&self) -> &[usize] {
        &self.columns[self.rank()..]
    }

    /// The last pivot over the first: how far the kept rows are from depending on each other. Zero without rows.
    pub fn smallest_pivot(&self) -> f64 {
        match (self.pivots.first(), self.pivots.last()) {
            (Some(first), Some(last)) => (last / first).abs(),
            _ => 0.0,
        }
    }

    /// The sign of the determinant of a square matrix; zero if it is singular.
    pub fn sign(&self) -> f64 {
        if self.rank() < self.rows.len() || self.rank() < self.columns.len() {
            return 0.0;
        }
        let of_pivots: f64 = self.pivots.iter().map(|pivot| pivot.signum()).product();
        of_pivots * parity(&self.rows) * parity(&self.columns)
    }

    /// A solution of `A x = b`, an entry for each column of A, with zero in the free columns. Equations that depend on
    /// others are not examined.
    ///
    /// # Errors
    /// `Shape` unless b has an entry for each row; `NotFinite`.
    pub fn solve(&self, b: &[f64]) -> Result<Vec<f64>, LinalgError> {
        if b.len() != self.rows.len() {
            return Err(LinalgError::Shape { rows: b.len(), columns: 1, wanted: "an entry for each row" });
        }
        let mut y: Vec<f64> = self.independent_rows().iter().map(|&row| b[row] * self.scale[row]).collect();
        for place in 0..y.len() {
            let known = y[place];
            for &(row, x) in self.lower.list(place) {
                y[row] -= x * known;
            }
        }
        self.back_substitute(&mut y);
        finite(self.by_column(y))
    }

    /// A solution of `Aᵀ x = b`, an entry for each row of A, with zero for the rows that depend on others.
    ///
    /// # Errors
    /// `Shape` unless b has an entry for each column; `NotFinite`.
    pub fn solve_transposed(&self, b: &[f64]) -> Result<Vec<f64>, LinalgError> {
        if b.len() != self.columns.len() {
            return Err(LinalgError::Shape { rows: b.len(), columns: 1, wanted: "an entry for each column" });
        }
        let mut y: Vec<f64> = self.columns[..self.rank()].iter().map(|&column| b[column]).collect();
        for place in 0..y.len() {
            for &(row, x) in self.upper.list(place) {
                y[place] -= x * y[row];
            }
            y[place] /= self.pivots[place];
        }
        for place in (0..y.len()).rev() {
            for &(row, x) in self.lower.list(place) {
                y[place] -= x * y[row];
            }
        }
        let mut x = vec![0.0; self.rows.len()];
        for (&row, y) in self.rows.iter().zip(y) {
            x[row] = y * self.scale[row];
        }
        finite(x)
    }

    /// Vectors that `A` takes to zero, one for each free column, with 1 there.
    ///
    /// # Errors
    /// `NotFinite`.
    pub fn null_space(&self) -> Result<Vec<Vec<f64>>, LinalgError> {
        let of_column = |free: usize| {
            let mut y = vec![0.0; self.rank()];
            for &(row, x) in self.upper.list(free) {
                y[row] = -x;
            }
            self.back_substitute(&mut y);
            let mut x = self.by_column(y);
            x[self.columns[free]] = 1.0;
            finite(x)
        };
        (self.rank()..self.columns.len()).map(of_column).collect()
    }

    /// `U x = y` in place.
    fn back_substitute(&self, y: &mut [f64]) {
        for place in (0..y.len()).rev() {
            y[place] /= self.pivots[place];
            let known = y[place];
            for &(row, x) in self.upper.list(place) {
                y[row] -= x * known;
            }
        }
    }

    /// The numbers of the places in their columns, with zero in the free ones.
    fn by_column(&self, y: Vec<f64>) -> Vec<f64> {
        let mut x = vec![0.0; self.columns.len()];
        for (&column, y) in self.columns.iter().zip(y) {
            x[column] = y;
        }
        x
    }
}

/// The largest absolute value of a list.
fn largest(list: &[(usize, f64)]) -> f64 {
    list.iter().fold(0.0, |most, (_, x)| f64::max(most, x.abs()))
}

/// 1 for an even permutation, −1 for an odd one.
fn parity(order: &[usize]) -> f64 {
    let mut seen = vec![false; order.len()];
    let mut sign = 1.0;
    for start in 0..order.len() {
        let (mut at, mut length) = (start, 0);
        while !seen[at] {
            seen[at] = true;
            at = order[at];
            length += 1;
        }
        if length > 0 && length % 2 == 0 {
            sign = -sign;
        }
    }
    sign
}

fn finite(x: Vec<f64>) -> Result<Vec<f64>, LinalgError> {
    if x.iter().all(|x| x.is_finite()) { Ok(x) } else { Err(LinalgError::NotFinite) }
}
