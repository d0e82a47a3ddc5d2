//! Linear algebra that always comes back: the only place that calls a decomposition of the library.
//!
//! Several decompositions of the library never return on NaN or infinity, one never returns on a harmless
//! permutation matrix, and a nearly singular system is solved without a word. Here every matrix is checked to be
//! finite and scaled, every iteration has a limit, every result is held against its own equation, and what has no
//! answer is refused by name. Everywhere else clippy bans the raw calls.
//!
//! ```
//! use dalembert_numerics::linalg::{LinalgError, solve, symmetric_eigen};
//! use nalgebra::{DMatrix, DVector};
//!
//! // Principal stresses of σx = 50, σy = −30 and τxy = 30 MPa: 10 ± √(40² + 30²), the larger one along (3, 1)/√10.
//! let stress = DMatrix::from_row_slice(2, 2, &[50.0, 30.0, 30.0, -30.0]);
//! let principal = symmetric_eigen(&stress)?;
//! assert!((principal.values[0] + 40.0).abs() < 1e-12 && (principal.values[1] - 60.0).abs() < 1e-12);
//! assert!((principal.vectors[(0, 1)] / principal.vectors[(1, 1)] - 3.0).abs() < 1e-12);
//! // Two equations that say the same are refused.
//! let dependent = DMatrix::from_row_slice(2, 2, &[1.0, 2.0, 2.0, 4.0]);
//! let refused = solve(&dependent, &DVector::from_vec(vec![3.0, 6.0]));
//! assert!(matches!(refused, Err(LinalgError::Singular { .. })));
//! # Ok::<(), LinalgError>(())
//! ```

mod band;
mod complex;
mod divide;
mod elimination;
mod exact;
mod lowest;
mod nonsymmetric;
mod pencil;
mod sparse;
mod tridiagonal;

use faer::{MatMut, MatRef};
use nalgebra::{DMatrix, DVector};

pub use self::{
    band::{ComplexBand, SymmetricBand},
    complex::{ComplexLu, solve_complex},
    elimination::Elimination,
    lowest::lowest_modes,
    nonsymmetric::{ComplexEigen, complex_eigen, complex_eigenvalues},
    pencil::{generalised_eigen, generalised_eigenvalues},
    sparse::SparseMatrix,
};

/// Below this reciprocal condition number of the scaled matrix a system counts as singular: fewer than three
/// digits of its solution would be right.
pub const SINGULAR: f64 = 1e-13;

/// The most unknowns of a full matrix.
pub const MOST_DENSE: usize = 5_000;

/// The most unknowns of a banded matrix.
pub const MOST_BANDED: usize = 1_000_000;

/// Reason for which a decomposition or solution is refused.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum LinalgError {
    /// An entry of the input, or of the result, is NaN or infinite.
    #[error("a number is not finite; every entry must be, and no result may overflow")]
    NotFinite,
    /// The sizes do not fit each other or the problem.
    #[error("a {rows} by {columns} matrix does not fit; the problem needs {wanted}")]
    Shape {
        /// Rows of the offending matrix.
        rows: usize,
        /// Columns of the offending matrix.
        columns: usize,
        /// Required shape.
        wanted: &'static str,
    },
    /// The matrix of a symmetric problem is not symmetric.
    #[error(
        "the matrix is not symmetric: the entries ({row}, {column}) and ({column}, {row}) differ by {difference:e} \
         of the largest"
    )]
    NotSymmetric {
        /// The row of the largest difference, counted from 1.
        row: usize,
        /// Column of that entry, counted from 1.
        column: usize,
        /// The largest difference across the diagonal over the largest entry.
        difference: f64,
    },
    /// The mass matrix, or a stiffness matrix that must not be unstable, has a direction without energy.
    #[error("the {matrix} matrix is not positive definite: its leading block of {row} rows is not")]
    NotPositiveDefinite {
        /// Name of the matrix.
        matrix: &'static str,
        /// Rows of the first leading block that is not positive definite.
        row: usize,
    },
    /// More than is taken on.
    #[error("{size} {what} are more than the limit of {limit}")]
    TooLarge {
        /// Quantity that exceeds its limit.
        what: &'static str,
        /// Requested size.
        size: usize,
        /// The limit.
        limit: usize,
    },
    /// The equations do not determine the unknowns.
    #[error("the equations are singular: reciprocal condition number {reciprocal_condition:e}")]
    Singular {
        /// `1/cond₂` of the scaled matrix; zero when exactly singular.
        reciprocal_condition: f64,
    },
    /// The iteration reached its limit, or its result does not satisfy the equation.
    #[error("the iteration did not converge")]
    NotConverged,
}

/// Solution of a linear system or a least-squares problem.
#[derive(Debug, Clone, PartialEq)]
pub struct Solved {
    /// The unknowns.
    pub x: DVector<f64>,
    /// Condition number `cond₂` of the scaled matrix, at least 1: about `log₁₀` of it digits are lost.
    pub condition: f64,
}

/// Eigenvalues and eigenvectors of a symmetric matrix.
#[derive(Debug, Clone, PartialEq)]
pub struct SymmetricEigen {
    /// Eigenvalues, ascending.
    pub values: DVector<f64>,
    /// Unit eigenvectors, a column each, in the order of the values.
    pub vectors: DMatrix<f64>,
}

/// Solves `A x = b` for a square `A`.
///
/// Rows and columns are first scaled to comparable size, so that the units of the unknowns and of the equations do
/// not matter; the condition number is that of the scaled matrix.
///
/// # Errors
/// `Shape` unless A is n by n and b has n entries, n ≥ 1; `NotFinite`; `Singular`; `NotConverged`.
pub fn solve(a: &DMatrix<f64>, b: &DVector<f64>) -> Result<Solved, LinalgError> {
    square(a)?;
    same_rows(a, b)?;
    finite(a.iter().chain(b.iter()))?;
    let row_scale = scale_of(a.row_iter().map(|row| row.amax()));
    let rows_scaled = DMatrix::from_diagonal(&row_scale) * a;
    let column_scale = scale_of(rows_scaled.column_iter().map(|column| column.amax()));
    let scaled = rows_scaled * DMatrix::from_diagonal(&column_scale);
    let right = b.component_mul(&row_scale);
    let condition = condition(even_columns(&even_rows(scaled.clone())))?;

    #[expect(clippy::disallowed_methods, reason = "finite, scaled and well conditioned")]
    let factors = scaled.clone().full_piv_lu();
    let solve = |right: &DVector<f64>| factors.solve(right).ok_or(LinalgError::NotConverged);
    let mut x = solve(&right)?;
    // One step of refinement takes back what rounding in the factors cost.
    x += solve(&(&right - &scaled * &x))?;
    finite(x.iter())?;

    let residual = (&right - &scaled * &x).amax();
    let size = x.amax() * scaled.nrows() as f64 + right.amax();
    if residual > 1e-13 * size {
        return Err(LinalgError::NotConverged);
    }
    x.component_mul_assign(&column_scale);
    finite(x.iter())?;
    Ok(Solved { x, condition })
}

/// The `x` that makes `|A x − b|` least, for `A` m by n with `m ≥ n` and independent columns, and `b` with m entries.
///
/// Columns are scaled; rows are not, since that would weight the observations.
///
/// # Errors
/// `Shape`; `NotFinite`; `Singular` when the columns are dependent; `NotConverged`.
pub fn least_squares(a: &DMatrix<f64>, b: &DVector<f64>) -> Result<Solved, LinalgError> {
    if a.ncols() == 0 || a.nrows() < a.ncols() {
        return Err(shape(a, "at least as many rows as columns, and one column"));
    }
    same_rows(a, b)?;
    finite(a.iter().chain(b.iter()))?;
    let column_scale = scale_of(a.column_iter().map(|column| column.amax()));
    let scaled = a * DMatrix::from_diagonal(&column_scale);
    let condition = condition(even_columns(&scaled))?;

    #[expect(clippy::disallowed_methods, reason = "finite, scaled and of full column rank")]
    let (q, r) = scaled.clone().qr().unpack();
    let solve =
        |right: &DVector<f64>| r.solve_upper_triangular(&q.tr_mul(right)).ok_or(LinalgError::NotConverged);
    let mut x = solve(b)?;
    x += solve(&(b - &scaled * &x))?;
    x.component_mul_assign(&column_scale);
    finite(x.iter())?;
    Ok(Solved { x, condition })
}

/// Eigenvalues, ascending, and unit eigenvectors of a symmetric matrix, both halves of which are read.
///
/// # Errors
/// `Shape` unless A is n by n, n ≥ 1; `NotFinite`; `NotSymmetric` beyond rounding; `NotConverged`.
pub fn symmetric_eigen(a: &DMatrix<f64>) -> Result<SymmetricEigen, LinalgError> {
    square(a)?;
    finite(a.iter())?;
    let scale = power_of_two_below(a.amax());
    let scaled = a / scale;
    symmetric(&scaled)?;
    let symmetric = (&scaled + scaled.transpose()) / 2.0;

    #[expect(clippy::disallowed_methods, reason = "finite, scaled and with a limit")]
    let eigen = symmetric
        .clone()
        .try_symmetric_eigen(f64::EPSILON, iteration_limit(a.nrows()))
        .ok_or(LinalgError::NotConverged)?;
    finite(eigen.eigenvalues.iter().chain(eigen.eigenvectors.iter()))?;

    let mut order: Vec<usize> = (0..a.nrows()).collect();
    order.sort_by(|&i, &j| eigen.eigenvalues[i].total_cmp(&eigen.eigenvalues[j]));
    let values = DVector::from_iterator(order.len(), order.iter().map(|&i| eigen.eigenvalues[i]));
    let vectors = eigen.eigenvectors.select_columns(&order);

    let residual = (&symmetric * &vectors - &vectors * DMatrix::from_diagonal(&values)).amax();
    if residual > rounding(a.nrows()) * symmetric.amax() {
        return Err(LinalgError::NotConverged);
    }
    let values = values * scale;
    finite(values.iter())?;
    Ok(SymmetricEigen { values, vectors })
}

/// `cond₂`, or the refusal of a singular matrix.
fn condition(a: DMatrix<f64>) -> Result<f64, LinalgError> {
    let limit = iteration_limit(a.ncols());
    #[expect(clippy::disallowed_methods, reason = "finite, scaled and with a limit")]
    let svd = a.try_svd(false, false, 5.0 * f64::EPSILON, limit);
    let singular_values = svd.ok_or(LinalgError::NotConverged)?.singular_values;
    finite(singular_values.iter())?;
    let (largest, smallest) = (singular_values.max(), singular_values.min());
    let reciprocal_condition = if largest > 0.0 { smallest / largest } else { 0.0 };
    if reciprocal_condition < SINGULAR {
        return Err(LinalgError::Singular { reciprocal_condition });
    }
    Ok(1.0 / reciprocal_condition)
}

/// A reciprocal size for each row or column; powers of two, so that scaling rounds nothing.
fn scale_of(sizes: impl Iterator<Item = f64>) -> DVector<f64> {
    DVector::from_vec(sizes.map(|size| 1.0 / power_of_two_below(size)).collect())
}

/// Rows divided by their largest entries: unlike powers of two it makes the condition number a continuous
/// function of the matrix.
fn even_rows(mut a: DMatrix<f64>) -> DMatrix<f64> {
    for mut row in a.row_iter_mut() {
        let size = row.amax();
        if size > 0.0 {
            row /= size;
        }
    }
    a
}

fn even_columns(a: &DMatrix<f64>) -> DMatrix<f64> {
    even_rows(a.transpose()).transpose()
}

fn power_of_two_below(size: f64) -> f64 {
    if size == 0.0 { 1.0 } else { size.log2().floor().clamp(-1000.0, 1000.0).exp2() }
}

fn finite<'a>(numbers: impl Iterator<Item = &'a f64>) -> Result<(), LinalgError> {
    // To the end, without a way out on each, and by one comparison: so it is done many at a time.
    let all = numbers.fold(true, |all, number| all & (number.abs() <= f64::MAX));
    if all { Ok(()) } else { Err(LinalgError::NotFinite) }
}

/// The largest of the sizes.
fn largest(numbers: &[f64]) -> f64 {
    fold_sizes(numbers, |most, size| if size > most { size } else { most })
}

fn sum_of_sizes(numbers: &[f64]) -> f64 {
    fold_sizes(numbers, |sum, size| sum + size)
}

/// Folds the sizes of numbers, eight sequences beside each other: one alone would wait for each of its operations.
fn fold_sizes(numbers: &[f64], fold: impl Fn(f64, f64) -> f64) -> f64 {
    let (groups, rest) = numbers.as_chunks::<8>();
    let mut folded = [0.0; 8];
    for group in groups {
        for (folded, number) in folded.iter_mut().zip(group) {
            *folded = fold(*folded, number.abs());
        }
    }
    rest.iter().map(|number| number.abs()).chain(folded).fold(0.0, fold)
}

fn square(a: &DMatrix<f64>) -> Result<(), LinalgError> {
    if a.is_square() && !a.is_empty() { Ok(()) } else { Err(shape(a, "a square matrix")) }
}

/// Refuses a difference across the diagonal beyond rounding, and says where it is largest.
fn symmetric(a: &DMatrix<f64>) -> Result<(), LinalgError> {
    let mut worst = (0.0, 0, 0);
    below_diagonal(a.nrows(), |row, column| {
        let difference = (a[(row, column)] - a[(column, row)]).abs();
        if difference > worst.0 {
            worst = (difference, row, column);
        }
    });
    let difference = worst.0 / largest(a.as_slice()).max(f64::MIN_POSITIVE);
    if difference <= 1e-12 {
        return Ok(());
    }
    Err(LinalgError::NotSymmetric { row: worst.2 + 1, column: worst.1 + 1, difference })
}

/// Visits every row and column below the diagonal, a tile after the other: an entry and its mirror image are read
/// together, and in a large matrix one of the two is far away.
fn below_diagonal(n: usize, mut visit: impl FnMut(usize, usize)) {
    const TILE: usize = 32;
    for first_column in (0..n).step_by(TILE) {
        for first_row in (first_column..n).step_by(TILE) {
            for column in first_column..(first_column + TILE).min(n) {
                for row in first_row.max(column + 1)..(first_row + TILE).min(n) {
                    visit(row, column);
                }
            }
        }
    }
}

/// The same matrix for the other library.
fn view(a: &DMatrix<f64>) -> MatRef<'_, f64> {
    MatRef::from_column_major_slice(a.as_slice(), a.nrows(), a.ncols())
}

fn view_mut(a: &mut DMatrix<f64>) -> MatMut<'_, f64> {
    let (rows, columns) = a.shape();
    MatMut::from_column_major_slice_mut(a.as_mut_slice(), rows, columns)
}

fn not_above(what: &'static str, size: usize, limit: usize) -> Result<(), LinalgError> {
    if size <= limit { Ok(()) } else { Err(LinalgError::TooLarge { what, size, limit }) }
}

fn same_rows(a: &DMatrix<f64>, b: &DVector<f64>) -> Result<(), LinalgError> {
    if a.nrows() == b.nrows() {
        Ok(())
    } else {
        Err(shape(a, "as many rows as the right-hand side has entries"))
    }
}

fn shape(a: &DMatrix<f64>, wanted: &'static str) -> LinalgError {
    LinalgError::Shape { rows: a.nrows(), columns: a.ncols(), wanted }
}

fn iteration_limit(n: usize) -> usize {
    100 * (n + 1)
}

/// Bound of a residual by rounding, relative to the largest entry, for `n` unknowns.
fn rounding(n: usize) -> f64 {
    1e-14 * (n + 10) as f64
}

/// Numbers between −1 and 1, the same ones in every run (Marsaglia's xorshift).
struct Random(u64);

impl Random {
    fn new() -> Self {
        Self(0x9E37_79B9_7F4A_7C15)
    }

    fn next(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }
}
