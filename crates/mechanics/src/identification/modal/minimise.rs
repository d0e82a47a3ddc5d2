//! Least squares of functions that are not linear.

use nalgebra::{DMatrix, DVector};

use super::ModalError;
use dalembert_numerics::linalg;

/// The parameters of a least sum of squares, and how level it is there.
pub(super) struct Minimum<const N: usize> {
    pub(super) parameters: [f64; N],
    /// The sum of squares.
    pub(super) squares: f64,
    /// Each derivative of the sum of squares over the largest it could be: zero but for rounding.
    pub(super) slopes: [f64; N],
}

/// Levenberg and Marquardt's method from a start. `rows` gives the residuals and their derivatives; the parameters
/// must be of comparable size, and the residuals of the size `size` or less.
pub(super) fn minimise<const N: usize>(
    start: [f64; N],
    size: f64,
    rows: impl Fn(&[f64; N]) -> Vec<(f64, [f64; N])>,
) -> Result<Minimum<N>, ModalError> {
    let squares_of =
        |rows: &[(f64, [f64; N])]| rows.iter().map(|(residual, _)| residual.powi(2)).sum::<f64>();
    let mut at = start;
    let mut here = rows(&at);
    let mut squares = squares_of(&here);
    let mut caution = 1e-3;
    for _ in 0..100 {
        if !squares.is_finite() {
            return Err(ModalError::NotAMode);
        }
        let (matrix, right, norms) = normal_equations(&here);
        let damped = &matrix + DMatrix::identity(N, N) * caution;
        let Ok(solved) = linalg::solve(&damped, &right) else {
            caution *= 8.0;
            continue;
        };
        let step: [f64; N] = std::array::from_fn(|j| solved.x[j] / norms[j]);
        let next: [f64; N] = std::array::from_fn(|j| at[j] + step[j]);
        let there = rows(&next);
        let fewer = squares_of(&there);
        let moved = (0..N).any(|j| step[j].abs() > 1e-15 * at[j].abs());
        if fewer <= squares {
            (at, here, squares) = (next, there, fewer);
            caution = (caution / 10.0).max(1e-12);
        } else {
            caution *= 8.0;
        }
        if !moved || caution > 1e8 || level(&here, size).iter().all(|slope| slope.abs() < 1e-15) {
            break;
        }
    }
    Ok(Minimum { parameters: at, squares, slopes: level(&here, size) })
}

/// The normal equations of a step, each unknown over the length of its column, and those lengths.
fn normal_equations<const N: usize>(rows: &[(f64, [f64; N])]) -> (DMatrix<f64>, DVector<f64>, [f64; N]) {
    let norms: [f64; N] = std::array::from_fn(|j| {
        rows.iter().map(|(_, row)| row[j].powi(2)).sum::<f64>().sqrt().max(f64::MIN_POSITIVE)
    });
    let product =
        |i: usize, j: usize| rows.iter().map(|(_, row)| row[i] / norms[i] * (row[j] / norms[j])).sum::<f64>();
    let matrix = DMatrix::from_fn(N, N, product);
    let right = DVector::from_fn(N, |j, _| {
        -rows.iter().map(|(residual, row)| residual * (row[j] / norms[j])).sum::<f64>()
    });
    (matrix, right, norms)
}

fn level<const N: usize>(rows: &[(f64, [f64; N])], size: f64) -> [f64; N] {
    std::array::from_fn(|j| {
        let (mut sum, mut norm) = (0.0, 0.0);
        for (residual, row) in rows {
            sum += residual * row[j];
            norm += row[j].powi(2);
        }
        sum / (norm.sqrt() * size * (rows.len() as f64).sqrt()).max(f64::MIN_POSITIVE)
    })
}
