//! Point masses on an elastic body without mass, by its influence coefficients `a_ij` (m/N): `x = ω² a m x`.

use nalgebra::DMatrix;

use dalembert_numerics::linalg::{self, LinalgError};

/// One round of matrix iteration.
#[derive(Clone, Debug, PartialEq)]
pub struct Round {
    /// Frequency by Rayleigh's quotient of the deflections before and after, rad/s.
    pub frequency: f64,
    /// Deflections after the round, the largest one.
    pub shape: Vec<f64>,
}

/// Natural frequencies, rad/s, ascending, by the eigenvalues of `√m a √m`.
///
/// # Errors
/// Those of [`linalg::symmetric_eigen`]; `NotFinite` where no mass can move.
pub fn frequencies(influence: &[Vec<f64>], masses: &[f64]) -> Result<Vec<f64>, LinalgError> {
    let count = masses.len();
    let matrix = DMatrix::from_fn(count, count, |i, j| masses[i].sqrt() * influence[i][j] * masses[j].sqrt());
    let eigen = linalg::symmetric_eigen(&matrix)?;
    // An eigenvalue that is zero but for rounding is that of a motion without a frequency.
    let mut found: Vec<f64> = eigen.values.iter().map(|value| value.max(0.0).sqrt().recip()).collect();
    found.sort_by(f64::total_cmp);
    match found.first() {
        Some(lowest) if lowest.is_finite() && *lowest > 0.0 => Ok(found),
        _ => Err(LinalgError::NotFinite),
    }
}

/// Matrix iteration (Stodola) from equal deflections: at most so many rounds, fewer where it no longer changes.
///
/// S. S. Rao, *Mechanical Vibrations*, 5th ed., §7.5.
pub fn matrix_iteration(influence: &[Vec<f64>], masses: &[f64], rounds: usize) -> Vec<Round> {
    let mut shape = vec![1.0; masses.len()];
    let mut found: Vec<Round> = Vec::new();
    for _ in 0..rounds {
        let deflection =
            |row: &Vec<f64>| -> f64 { row.iter().zip(masses).zip(&shape).map(|((a, m), x)| a * m * x).sum() };
        let next: Vec<f64> = influence.iter().map(deflection).collect();
        let product =
            |a: &[f64], b: &[f64]| -> f64 { masses.iter().zip(a).zip(b).map(|((m, a), b)| m * a * b).sum() };
        let frequency = (product(&shape, &next) / product(&next, &next)).sqrt();
        let largest = next.iter().fold(0.0f64, |a, b| if b.abs() > a.abs() { *b } else { a });
        shape = next.iter().map(|x| x / largest).collect();
        if !(frequency.is_finite() && shape.iter().all(|x| x.is_finite())) {
            break;
        }
        let settled =
            found.last().is_some_and(|last| (frequency - last.frequency).abs() <= 1e-15 * frequency);
        found.push(Round { frequency, shape: shape.clone() });
        if settled {
            break;
        }
    }
    found
}
