//! Balancing without phase: the sizes of the vibration alone, with a trial weight at several angles.
//!
//! With the trial weight at the angle `θ` a sensor reads `S = |V| |1 + z e^{iθ}|`, `z` being the effect of the weight
//! at angle 0 over the vibration without it. Three angles tell `z`, and more than three how well it is known.

use nalgebra::{Complex, DMatrix, DVector};

use crate::linalg::{self, LinalgError};

/// What the sizes tell of the effect of a trial weight.
#[derive(Debug, Clone, PartialEq)]
pub struct Effect {
    /// The effect `z` that makes the squares of what is left of the sizes least.
    pub best: Complex<f64>,
    /// The effect from the squares of the sizes, which are linear in it.
    pub linear: Complex<f64>,
    /// `|z|²` from the mean of the squares of the sizes; it is negative where no vibration has such sizes.
    pub mean_square: f64,
    /// What the best effect leaves of each size, over the first size.
    pub left: Vec<f64>,
    /// The slope of the sum of squares at the best effect, over the size of its terms: zero at the least.
    pub slope: f64,
}

/// The effect of a trial weight from sizes of the vibration, `(angle, size over the size without weight)`.
///
/// # Errors
/// `Shape` for fewer than three runs; `Singular` where the angles lie in fewer than three directions; `NotConverged`.
pub fn effect(runs: &[(f64, f64)]) -> Result<Effect, LinalgError> {
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
    let slopes = |z: Complex<f64>| {
        DMatrix::from_fn(runs.len(), 2, |row, column| {
            let turn = Complex::cis(runs[row].0);
            let sum = z * turn + 1.0;
            let toward = [turn, turn * Complex::I][column];
            if sum.norm() == 0.0 { 0.0 } else { (sum.conj() * toward).re / sum.norm() }
        })
    };
    // Gauss and Newton, each step halved until the squares fall.
    let mut z = linear;
    let mut now = left(z);
    for _ in 0..200 {
        let step = linalg::least_squares(&slopes(z), &-&now)?.x;
        let step = Complex::new(step[0], step[1]);
        let mut share = 1.0;
        while share > 1e-12 && left(z + step * share).norm_squared() > now.norm_squared() {
            share /= 2.0;
        }
        if share > 1e-12 {
            z += step * share;
            now = left(z);
        }
        if share <= 1e-12 || step.norm() <= 1e-15 * z.norm() {
            break;
        }
    }
    let slopes = slopes(z);
    let slope = slopes.tr_mul(&now).amax() / slopes.abs().tr_mul(&squares.map(f64::sqrt)).amax();
    Ok(Effect { best: z, linear, mean_square: solved[0] - 1.0, left: now.iter().copied().collect(), slope })
}
