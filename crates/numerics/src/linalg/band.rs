//! Banded matrices: factorisation and products of symmetric and complex ones.

use nalgebra::{Complex, DMatrix};

use super::{LinalgError, MOST_BANDED, exact::Sum, not_above, shape};

/// The most stored entries of a banded matrix.
const MOST_ENTRIES: usize = 8_000_000;

/// A symmetric matrix with entries on the diagonal and `width` places beside it.
#[derive(Debug, Clone, PartialEq)]
pub struct SymmetricBand {
    size: usize,
    width: usize,
    /// The lower part by rows, `width + 1` numbers each, the diagonal last.
    entries: Vec<f64>,
}

/// A complex matrix with entries on the diagonal, `lower` places below and `upper` places above it.
#[derive(Debug, Clone, PartialEq)]
pub struct ComplexBand {
    size: usize,
    lower: usize,
    upper: usize,
    /// By rows, from `lower` before the diagonal to `upper + lower` after it: room for exchanged rows.
    entries: Vec<Complex<f64>>,
}

impl SymmetricBand {
    /// A matrix of zeros.
    ///
    /// # Errors
    /// `Shape` without rows; `TooLarge` above [`MOST_BANDED`] rows or eight million entries.
    pub fn zeros(size: usize, width: usize) -> Result<Self, LinalgError> {
        let entries = storage(size, width)?;
        Ok(Self { size, width, entries: vec![0.0; entries] })
    }

    /// A diagonal matrix.
    ///
    /// # Errors
    /// As for [`zeros`](Self::zeros).
    pub fn diagonal(entries: &[f64]) -> Result<Self, LinalgError> {
        storage(entries.len(), 0)?;
        Ok(Self { size: entries.len(), width: 0, entries: entries.to_vec() })
    }

    /// The band of a full symmetric matrix; of its lower part, if it is not symmetric.
    ///
    /// # Errors
    /// `Shape` unless square; as for [`zeros`](Self::zeros).
    pub fn of(a: &DMatrix<f64>) -> Result<Self, LinalgError> {
        super::square(a)?;
        let width = (0..a.ncols())
            .filter_map(|column| {
                (column..a.nrows()).rev().find(|&row| a[(row, column)] != 0.0).map(|row| row - column)
            })
            .max()
            .unwrap_or(0);
        let mut band = Self::zeros(a.nrows(), width)?;
        for row in 0..a.nrows() {
            for column in row.saturating_sub(width)..=row {
                band.add(row, column, a[(row, column)]);
            }
        }
        Ok(band)
    }

    /// Rows.
    pub fn size(&self) -> usize {
        self.size
    }

    /// Places beside the diagonal.
    pub fn width(&self) -> usize {
        self.width
    }

    /// The entry, zero outside the band.
    pub fn get(&self, row: usize, column: usize) -> f64 {
        let (row, column) = (row.max(column), row.min(column));
        if row - column > self.width { 0.0 } else { self.entries[self.at(row, column)] }
    }

    /// Adds to the entry and to its mirror image.
    ///
    /// # Panics
    /// Outside the band.
    pub fn add(&mut self, row: usize, column: usize, value: f64) {
        let (row, column) = (row.max(column), row.min(column));
        assert!(row < self.size && row - column <= self.width, "({row}, {column}) lies outside the band");
        let at = self.at(row, column);
        self.entries[at] += value;
    }

    /// `y = A x`.
    ///
    /// # Panics
    /// Unless x and y have as many entries as the matrix has rows.
    pub fn multiply(&self, x: &[f64], y: &mut [f64]) {
        assert!(x.len() == self.size && y.len() == self.size, "the vectors do not fit the band");
        let w = self.width;
        if w == 0 {
            for ((y, a), x) in y.iter_mut().zip(&self.entries).zip(x) {
                *y = a * x;
            }
            return;
        }
        for row in 0..self.size {
            let (first, entries) = self.row(row);
            let (left, diagonal) = entries.split_at(row - first);
            let mut sum = diagonal[0] * x[row];
            for ((a, x_left), y_left) in left.iter().zip(&x[first..row]).zip(&mut y[first..row]) {
                sum += a * x_left;
                *y_left += a * x[row];
            }
            y[row] = sum;
        }
    }

    /// The entries of a row up to the diagonal, and the column of the first.
    pub(super) fn row(&self, row: usize) -> (usize, &[f64]) {
        let first = row.saturating_sub(self.width);
        let end = (row + 1) * (self.width + 1);
        (first, &self.entries[end - 1 - (row - first)..end])
    }

    /// `x·A x` with twice the digits, and the same with every term made positive: what rounding is measured by.
    pub fn energy(&self, x: &[f64]) -> (f64, f64) {
        let (mut total, mut size) = (Sum::default(), 0.0);
        for row in 0..self.size {
            let (first, entries) = self.row(row);
            let (left, diagonal) = entries.split_at(row - first);
            let mut sum = Sum::default();
            for (a, x) in left.iter().zip(&x[first..row]) {
                sum.add_product(2.0 * a, *x);
            }
            sum.add_product(diagonal[0], x[row]);
            let (high, low) = sum.parts();
            total.add_product(high, x[row]);
            total.add_product(low, x[row]);
            size += diagonal[0].abs() * x[row] * x[row];
        }
        (total.value(), size)
    }

    pub(super) fn entries(&self) -> &[f64] {
        &self.entries
    }

    /// `D A D / divisor` for a diagonal D.
    pub(super) fn scaled(&self, scale: &[f64], divisor: f64) -> Self {
        let mut scaled = self.clone();
        for row in 0..self.size {
            for column in row.saturating_sub(self.width)..=row {
                let at = self.at(row, column);
                scaled.entries[at] *= scale[row] * scale[column] / divisor;
            }
        }
        scaled
    }

    pub(super) fn diagonal_of(&self, row: usize) -> f64 {
        self.entries[(row + 1) * (self.width + 1) - 1]
    }

    fn at(&self, row: usize, column: usize) -> usize {
        (row + 1) * (self.width + 1) - 1 - (row - column)
    }
}

/// `A = L D Lᵀ` of a symmetric band, without exchange of rows.
pub(super) struct Factors {
    /// L below its unit diagonal; on the diagonal 1/D.
    band: SymmetricBand,
    /// Number of negative entries of D, the number of negative eigenvalues of A (Sylvester's law of inertia).
    pub(super) negative: usize,
    /// The first row whose pivot is not clearly positive.
    pub(super) doubtful: Option<usize>,
}

impl Factors {
    /// The factors of `K − σ M`.
    pub(super) fn of(k: &SymmetricBand, m: &SymmetricBand, shift: f64) -> Self {
        let (size, width) = (k.size, k.width.max(m.width));
        let mut band = SymmetricBand { size, width, entries: vec![0.0; size * (width + 1)] };
        for row in 0..size {
            for (matrix, factor) in [(k, 1.0), (m, -shift)] {
                if factor != 0.0 {
                    let (first, entries) = matrix.row(row);
                    let at = band.at(row, first);
                    for (sum, a) in band.entries[at..].iter_mut().zip(entries) {
                        *sum += factor * a;
                    }
                }
            }
        }
        let rounding = f64::EPSILON * 8.0 * (size as f64 + 10.0);
        let (mut negative, mut doubtful) = (0, None);
        for row in 0..size {
            let first = row.saturating_sub(width);
            let start = row * (width + 1);
            let (above, here) = band.entries.split_at_mut(start);
            // `here[c]` is column `row − width + c`.
            let shift = |column: usize| column + width - row;
            for column in first..row {
                let other = &above[column * (width + 1)..(column + 1) * (width + 1)];
                let from = first.max(column.saturating_sub(width));
                let mut sum = here[shift(column)];
                for inner in from..column {
                    sum -= here[shift(inner)] * other[inner + width - column];
                }
                here[shift(column)] = sum;
            }
            let diagonal = here[width];
            let mut pivot = diagonal;
            for column in first..row {
                let u = here[shift(column)];
                let l = u * above[(column + 1) * (width + 1) - 1];
                pivot -= u * l;
                here[shift(column)] = l;
            }
            let smallest = rounding * diagonal.abs().max(f64::MIN_POSITIVE / f64::EPSILON);
            if pivot <= smallest {
                doubtful.get_or_insert(row);
            }
            if pivot.abs() < smallest {
                pivot = if pivot < 0.0 { -smallest } else { smallest };
            }
            negative += usize::from(pivot < 0.0);
            here[width] = 1.0 / pivot;
        }
        Self { band, negative, doubtful }
    }

    /// Solves in place.
    pub(super) fn solve(&self, x: &mut [f64]) {
        let (size, width) = (self.band.size, self.band.width);
        if width == 1 {
            let rows = self.band.entries.as_chunks::<2>().0;
            let mut before = 0.0;
            for (x, [l, _]) in x.iter_mut().zip(rows) {
                before = *x - l * before;
                *x = before;
            }
            let (mut after, mut l_after) = (0.0, 0.0);
            for (x, [l, reciprocal]) in x.iter_mut().zip(rows).rev() {
                after = *x * reciprocal - l_after * after;
                l_after = *l;
                *x = after;
            }
            return;
        }
        for row in 0..size {
            let (first, entries) = self.band.row(row);
            let sum: f64 = entries.iter().zip(&x[first..row]).map(|(l, x)| l * x).sum();
            x[row] -= sum;
        }
        for (row, x) in x.iter_mut().enumerate() {
            *x *= self.band.diagonal_of(row);
        }
        for row in (0..size).rev() {
            let (first, entries) = self.band.row(row);
            let (left, here) = x.split_at_mut(row);
            for (x, l) in left[first..].iter_mut().zip(entries) {
                *x -= l * here[0];
            }
        }
    }
}

impl ComplexBand {
    /// A matrix of zeros.
    ///
    /// # Errors
    /// `Shape` without rows; `TooLarge` above [`MOST_BANDED`] rows or eight million stored entries.
    pub fn zeros(size: usize, lower: usize, upper: usize) -> Result<Self, LinalgError> {
        let entries = storage(size, 2 * lower + upper)?;
        Ok(Self { size, lower, upper, entries: vec![Complex::ZERO; entries] })
    }

    /// Rows.
    pub fn size(&self) -> usize {
        self.size
    }

    /// Adds to the entry.
    ///
    /// # Panics
    /// Outside the band.
    pub fn add(&mut self, row: usize, column: usize, value: Complex<f64>) {
        let inside = row.max(column) < self.size && row <= column + self.lower && column <= row + self.upper;
        assert!(inside, "({row}, {column}) lies outside the band");
        let at = self.at(row, column);
        self.entries[at] += value;
    }

    /// Solves `A x = b` in place, by Gauss elimination with exchange of rows; A is used up.
    ///
    /// # Errors
    /// `Shape`; `NotFinite`; `Singular` when a pivot is zero to rounding.
    pub fn solve(mut self, x: &mut [Complex<f64>]) -> Result<(), LinalgError> {
        if x.len() != self.size {
            return Err(LinalgError::Shape {
                rows: x.len(),
                columns: 1,
                wanted: "as many entries as the band has rows",
            });
        }
        super::finite(self.entries.iter().chain(&*x).flat_map(|entry| [&entry.re, &entry.im]))?;
        let (n, reach) = (self.size, self.lower + self.upper);
        let stride = 2 * self.lower + self.upper + 1;
        // Rows to comparable size: powers of two round nothing.
        for (row, x) in self.entries.chunks_exact_mut(stride).zip(&mut *x) {
            let size = row.iter().map(|entry| entry.re.abs().max(entry.im.abs())).fold(0.0, f64::max);
            let scale = 1.0 / super::power_of_two_below(size);
            for entry in row {
                *entry *= scale;
            }
            *x *= scale;
        }
        for pivot in 0..n {
            let last = (pivot + self.lower).min(n - 1);
            let end = (pivot + reach).min(n - 1);
            let size = |row: usize| self.entries[self.at(row, pivot)].l1_norm();
            let best = (pivot..=last).max_by(|&p, &q| size(p).total_cmp(&size(q))).unwrap_or(pivot);
            if size(best) <= f64::EPSILON * 0.1 {
                return Err(LinalgError::Singular { reciprocal_condition: 0.0 });
            }
            if best != pivot {
                for column in pivot..=end {
                    let (here, there) = (self.at(pivot, column), self.at(best, column));
                    self.entries.swap(here, there);
                }
                x.swap(pivot, best);
            }
            let from = self.at(pivot, pivot);
            let reciprocal = self.entries[from].inv();
            for row in pivot + 1..=last {
                let at = self.at(row, pivot);
                let factor = self.entries[at] * reciprocal;
                if factor == Complex::ZERO {
                    continue;
                }
                let (above, below) = self.entries.split_at_mut(at);
                let pivot_row = &above[from + 1..=from + end - pivot];
                for (entry, pivot_entry) in below[1..].iter_mut().zip(pivot_row) {
                    *entry -= factor * pivot_entry;
                }
                let eliminated = factor * x[pivot];
                x[row] -= eliminated;
            }
        }
        for row in (0..n).rev() {
            let end = (row + reach).min(n - 1);
            let from = self.at(row, row);
            let mut sum = x[row];
            for (entry, x) in self.entries[from + 1..].iter().zip(&x[row + 1..=end]) {
                sum -= entry * x;
            }
            x[row] = sum / self.entries[from];
        }
        super::finite(x.iter().flat_map(|entry| [&entry.re, &entry.im]))
    }

    fn at(&self, row: usize, column: usize) -> usize {
        row * (2 * self.lower + self.upper + 1) + column + self.lower - row
    }
}

/// Number of stored entries of a band matrix of this size and half-bandwidth.
fn storage(size: usize, width: usize) -> Result<usize, LinalgError> {
    if size == 0 {
        return Err(shape(&DMatrix::zeros(0, 0), "at least one row"));
    }
    not_above("rows of a banded matrix", size, MOST_BANDED)?;
    let entries = size.saturating_mul(width.saturating_add(1));
    not_above("entries of a banded matrix", entries, MOST_ENTRIES)?;
    Ok(entries)
}
