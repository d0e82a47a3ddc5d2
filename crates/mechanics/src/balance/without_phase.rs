//! Balancing without phase: the sizes of the vibration alone, with a trial weight at several angles.
//!
//! With the trial weight at the angle `θ` a sensor reads `S = |V| |1 + z e^{iθ}|`, `z` being the effect of the weight
//! at angle 0 over the vibration without it. Three angles tell `z`, and more than three how well it is known.

use nalgebra::{Complex, DMatrix, DVector, Matrix2};

use dalembert_numerics::linalg::{self, LinalgError};

/// Effect of a trial weight as found from magnitudes alone.
#[derive(Debug, Clone, PartialEq)]
pub struct TrialEffect {
    /// The effect `z` that makes the squares of what is left of the sizes least.
    pub best: Complex<f64>,
    /// The effect from the squares of the sizes, which are linear in it.
    pub linear: Complex<f64>,
    /// `|z|²` from the mean of the squares of the sizes; it is negative where no vibration has such sizes.
    pub mean_square: f64,
    /// Residual of each magnitude for the best effect, over the first magnitude.
    pub left: Vec<f64>,
    /// The gradient of the sum of squares at the best effect, over the size of its terms: zero at the least.
    pub gradient: f64,
}

/// The effect of a trial weight from sizes of the vibration, a pair `(angle, size over the size without weight)` for
/// each run.
///
/// # Errors
/// `Shape` for fewer than three runs; `Singular` where the angles lie in fewer than three directions; `NotConverged`.
pub fn effect(runs: &[(f64, f64)]) -> Result<TrialEffect, LinalgError> {
    // S² = 1 + |z|² + 2 Re(z e^{iθ}) is linear in 1 + |z|² and z.
    let matrix = DMatrix::from_fn(runs.len(), 3, |row, column| {
        let angle = runs[row].0;
        [1.0, 2.0 * angle.cos(), -2.0 * angle.sin()][column]
    });
    let squares = DVector::from_fn(runs.len(), |row, _| runs[row].1.powi(2));
    let solved = linalg::least_squares(&matrix, &squares)?.x;
    let linear = Complex::new(solved[1], solved[2]);

    let left = |z: Complex<f64>| -> DVector<f64> {
        DVector::from_iterator(
            runs.len(),
            runs.iter().map(|(angle, size)| (z * Complex::cis(*angle) + 1.0).norm() - size),
        )
    };
    let jacobian = |z: Complex<f64>| {
        DMatrix::from_fn(runs.len(), 2, |row, column| {
            let turn = Complex::cis(runs[row].0);
            let sum = z * turn + 1.0;
            let toward = [turn, turn * Complex::I][column];
            if sum.norm() == 0.0 { 0.0 } else { (sum.conj() * toward).re / sum.norm() }
        })
    };
    let gradient = |z: Complex<f64>| jacobian(z).tr_mul(&left(z));
    // A size |w| curves across its gradient g alone: ∂²|w| = (1 − g gᵀ)/|w|.
    let hessian = |z: Complex<f64>| {
        jacobian(z).row_iter().zip(runs).fold(Matrix2::zeros(), |sum, (g, (angle, size))| {
            let far = (z * Complex::cis(*angle) + 1.0).norm();
            let along = Matrix2::from_fn(|i, j| g[i] * g[j]);
            let curved = if far == 0.0 { 0.0 } else { (far - size) / far };
            sum + along * (1.0 - curved) + Matrix2::identity() * curved
        })
    };
    // Newton's steps, or Gauss and Newton's where the sum of squares is not convex, each halved until the squares fall
    // or, where rounding hides that, their gradient does.
    let mut z = linear;
    for _ in 0..200 {
        let (squares, rest) = (left(z).norm_squared(), gradient(z));
        let curved = hessian(z);
        let [along, across, both] = [curved[(0, 0)], curved[(1, 1)], curved[(0, 1)]];
        let determinant = along * across - both * both;
        let step = if along > 0.0 && determinant > f64::EPSILON * along * across {
            [both * rest[1] - across * rest[0], both * rest[0] - along * rest[1]].map(|x| x / determinant)
        } else {
            let solved = linalg::least_squares(&jacobian(z), &-&left(z))?.x;
            [solved[0], solved[1]]
        };
        let falls = |next: &Complex<f64>| {
            let there = left(*next).norm_squared();
            there < squares * (1.0 - ROUNDING)
                || there <= squares * (1.0 + ROUNDING) && gradient(*next).norm() < rest.norm()
        };
        let shares = std::iter::successors(Some(1.0), |share| Some(share / 2.0)).take(40);
        let Some(next) = shares.map(|share| z + Complex::new(step[0], step[1]) * share).find(falls) else {
            break;
        };
        z = next;
    }
    let rest = gradient(z);
    let now = left(z);
    let gradient = rest.amax() / jacobian(z).abs().tr_mul(&squares.map(f64::sqrt)).amax();
    Ok(TrialEffect {
        best: z,
        linear,
        mean_square: solved[0] - 1.0,
        left: now.iter().copied().collect(),
        gradient,
    })
}

/// Relative rounding error of a sum of squares.
const ROUNDING: f64 = 1e-12;
