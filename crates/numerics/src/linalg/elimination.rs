//! Elimination that tells which equations say something new.

use nalgebra::DMatrix;

use super::LinalgError;

/// A pivot below this part of the largest entry of the scaled matrix counts as zero.
const NEGLIGIBLE: f64 = 1e-10;

/// `P A Q = L U` with the largest entry left as the next pivot (Golub & Van Loan, Matrix Computations, 4th ed.,
/// §3.4.8), of a matrix with any number of rows and columns.
///
/// Rows are first scaled to a largest entry of 1. What remains below 10⁻¹⁰ of the first pivot is taken as zero:
/// so many rows depend on the others, and so many columns are left to choose.
#[derive(Debug, Clone)]
pub struct Elimination {
    /// L below its unit diagonal and U, of the scaled and permuted matrix.
    factors: DMatrix<f64>,
    scale: Vec<f64>,
    /// The row and the column of A that stand in each place.
    rows: Vec<usize>,
    columns: Vec<usize>,
    rank: usize,
}

impl Elimination {
    /// Factors the matrix.
    ///
    /// # Errors
    /// `NotFinite`.
    pub fn new(a: &DMatrix<f64>) -> Result<Self, LinalgError> {
        if a.iter().any(|x| !x.is_finite()) {
            return Err(LinalgError::NotFinite);
        }
        let mut f = a.clone();
        let scale: Vec<f64> = f
            .row_iter_mut()
            .map(|mut row| {
                let largest = row.amax();
                let scale = if largest > 0.0 { 1.0 / largest } else { 1.0 };
                row *= scale;
                scale
            })
            .collect();
        let (m, n) = f.shape();
        let (mut rows, mut columns): (Vec<usize>, Vec<usize>) = ((0..m).collect(), (0..n).collect());
        let (mut rank, mut first) = (0, 0.0);
        for place in 0..m.min(n) {
            let (mut largest, mut at) = (0.0, (place, place));
            for column in place..n {
                for row in place..m {
                    if f[(row, column)].abs() > largest {
                        (largest, at) = (f[(row, column)].abs(), (row, column));
                    }
                }
            }
            first = f64::max(first, largest);
            if largest <= NEGLIGIBLE * first {
                break;
            }
            f.swap_rows(place, at.0);
            f.swap_columns(place, at.1);
            rows.swap(place, at.0);
            columns.swap(place, at.1);
            rank += 1;
            let pivot = f[(place, place)];
            for row in place + 1..m {
                f[(row, place)] /= pivot;
            }
            for column in place + 1..n {
                let above = f[(place, column)];
                if above != 0.0 {
                    for row in place + 1..m {
                        f[(row, column)] -= f[(row, place)] * above;
                    }
                }
            }
        }
        Ok(Self { factors: f, scale, rows, columns, rank })
    }

    /// Rank: the number of linearly independent rows.
    pub fn rank(&self) -> usize {
        self.rank
    }

    /// The rows that are kept, the most telling first.
    pub fn independent_rows(&self) -> &[usize] {
        &self.rows[..self.rank]
    }

    /// The rows that follow from the others.
    pub fn dependent_rows(&self) -> &[usize] {
        &self.rows[self.rank..]
    }

    /// The columns that may be chosen freely.
    pub fn free_columns(&self) -> &[usize] {
        &self.columns[self.rank..]
    }

    /// The last pivot over the first: how far the kept rows are from depending on each other. Zero without rows.
    pub fn smallest_pivot(&self) -> f64 {
        match self.rank {
            0 => 0.0,
            rank => (self.factors[(rank - 1, rank - 1)] / self.factors[(0, 0)]).abs(),
        }
    }

    /// The sign of the determinant of a square matrix; zero if it is singular.
    pub fn sign(&self) -> f64 {
        if self.rank < self.rows.len() || self.rank < self.columns.len() {
            return 0.0;
        }
        let of_pivots: f64 = (0..self.rank).map(|place| self.factors[(place, place)].signum()).product();
        of_pivots * parity(&self.rows) * parity(&self.columns)
    }

    /// A solution of `A x = b`, with zero in the free columns. Equations that depend on others are not examined.
    ///
    /// # Errors
    /// `Shape` unless b has an entry for each row; `NotFinite`.
    pub fn solve(&self, b: &[f64]) -> Result<Vec<f64>, LinalgError> {
        if b.len() != self.rows.len() {
            return Err(LinalgError::Shape { rows: b.len(), columns: 1, wanted: "an entry for each row" });
        }
        let f = &self.factors;
        let mut y: Vec<f64> = self.independent_rows().iter().map(|&row| b[row] * self.scale[row]).collect();
        for place in 0..self.rank {
            let known = y[place];
            for row in place + 1..self.rank {
                y[row] -= f[(row, place)] * known;
            }
        }
        for place in (0..self.rank).rev() {
            y[place] /= f[(place, place)];
            let known = y[place];
            for row in 0..place {
                y[row] -= f[(row, place)] * known;
            }
        }
        let mut x = vec![0.0; self.columns.len()];
        for (place, y) in y.into_iter().enumerate() {
            x[self.columns[place]] = y;
        }
        finite(x)
    }

    /// A solution of `Aᵀ x = b`, with zero for the rows that depend on others.
    ///
    /// # Errors
    /// `Shape` unless b has an entry for each column; `NotFinite`.
    pub fn solve_transposed(&self, b: &[f64]) -> Result<Vec<f64>, LinalgError> {
        if b.len() != self.columns.len() {
            return Err(LinalgError::Shape { rows: b.len(), columns: 1, wanted: "an entry for each column" });
        }
        let f = &self.factors;
        let mut y: Vec<f64> = self.columns[..self.rank].iter().map(|&column| b[column]).collect();
        for place in 0..self.rank {
            for above in 0..place {
                y[place] -= f[(above, place)] * y[above];
            }
            y[place] /= f[(place, place)];
        }
        for place in (0..self.rank).rev() {
            for below in place + 1..self.rank {
                y[place] -= f[(below, place)] * y[below];
            }
        }
        let mut x = vec![0.0; self.rows.len()];
        for (place, y) in y.into_iter().enumerate() {
            let row = self.rows[place];
            x[row] = y * self.scale[row];
        }
        finite(x)
    }

    /// Vectors that `A` takes to zero, one for each free column, with 1 there.
    ///
    /// # Errors
    /// `NotFinite`.
    pub fn null_space(&self) -> Result<Vec<Vec<f64>>, LinalgError> {
        let f = &self.factors;
        let of_column = |free: usize| {
            let mut y: Vec<f64> = (0..self.rank).map(|place| -f[(place, free)]).collect();
            for place in (0..self.rank).rev() {
                y[place] /= f[(place, place)];
                let known = y[place];
                for row in 0..place {
                    y[row] -= f[(row, place)] * known;
                }
            }
            let mut x = vec![0.0; self.columns.len()];
            for (place, y) in y.into_iter().enumerate() {
                x[self.columns[place]] = y;
            }
            x[self.columns[free]] = 1.0;
            finite(x)
        };
        (self.rank..self.columns.len()).map(of_column).collect()
    }
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
