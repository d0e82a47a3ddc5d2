//! Point masses on an elastic body without mass, by its influence coefficients `a_ij` (m/N): `x = ω² a m x`.
//!
//! `influence[i][j]` is the deflection at mass `i` under a unit force at mass `j`, for `n` masses `n` lists of `n` numbers;
//! deflections and masses stand in the same order.

use nalgebra::{DMatrix, DVectorView};

use dalembert_numerics::linalg::{self, LinalgError};

/// One round of matrix iteration.
#[derive(Clone, Debug, PartialEq)]
pub struct Round {
    /// Frequency by Rayleigh's quotient of the deflections before and after, rad/s.
    pub frequency: f64,
    /// Deflections after the round, the largest one.
    pub shape: Vec<f64>,
}

/// A natural frequency and its mode shape.
#[derive(Clone, Debug, PartialEq)]
pub struct LumpedMode {
    /// Natural frequency, rad/s; infinite for a motion without a frequency.
    pub frequency: f64,
    /// Deflections of the masses, the largest one.
    pub shape: Vec<f64>,
}

/// Natural frequencies, rad/s, ascending, by the eigenvalues of `√m a √m`.
///
/// # Errors
/// Those of [`modes`].
pub fn frequencies(influence: &[Vec<f64>], masses: &[f64]) -> Result<Vec<f64>, LinalgError> {
    Ok(modes(influence, masses)?.into_iter().map(|mode| mode.frequency).collect())
}

/// Natural frequencies, ascending, and mode shapes, by the eigenvalues and eigenvectors of `√m a √m`.
///
/// # Errors
/// Those of [`linalg::symmetric_eigen`]; `NotFinite` where no mass can move.
pub fn modes(influence: &[Vec<f64>], masses: &[f64]) -> Result<Vec<LumpedMode>, LinalgError> {
    let eigen = linalg::symmetric_eigen(&scaled(influence, masses))?;
    let mode = |(value, vector): (&f64, _)| {
        let shape = shape_of(vector, masses);
        // An eigenvalue that is zero but for rounding is that of a motion without a frequency.
        LumpedMode { frequency: value.max(0.0).sqrt().recip(), shape }
    };
    let mut found: Vec<LumpedMode> = eigen.values.iter().zip(eigen.vectors.column_iter()).map(mode).collect();
    found.sort_by(|a, b| a.frequency.total_cmp(&b.frequency));
    match found.first() {
        Some(lowest) if lowest.frequency.is_finite() && lowest.frequency > 0.0 => Ok(found),
        _ => Err(LinalgError::NotFinite),
    }
}

/// Determinant of the frequency equation, `det(ω² √m a √m − 1)`, by elimination: zero at a natural frequency.
pub fn frequency_determinant(influence: &[Vec<f64>], masses: &[f64], frequency: f64) -> f64 {
    let mut rows = scaled(influence, masses) * frequency.powi(2);
    rows -= DMatrix::identity(masses.len(), masses.len());
    let mut determinant = 1.0;
    for step in 0..masses.len() {
        let pivot = (step..masses.len())
            .max_by(|a, b| rows[(*a, step)].abs().total_cmp(&rows[(*b, step)].abs()))
            .unwrap_or(step);
        if pivot != step {
            rows.swap_rows(pivot, step);
            determinant = -determinant;
        }
        let head = rows[(step, step)];
        determinant *= head;
        if head == 0.0 {
            return 0.0;
        }
        for row in step + 1..masses.len() {
            let factor = rows[(row, step)] / head;
            for column in step + 1..masses.len() {
                rows[(row, column)] -= factor * rows[(step, column)];
            }
        }
    }
    determinant
}

/// `√m a √m`.
fn scaled(influence: &[Vec<f64>], masses: &[f64]) -> DMatrix<f64> {
    let count = masses.len();
    DMatrix::from_fn(count, count, |i, j| masses[i].sqrt() * influence[i][j] * masses[j].sqrt())
}

/// Deflections of an eigenvector of `√m a √m`, the largest one.
fn shape_of(vector: DVectorView<'_, f64>, masses: &[f64]) -> Vec<f64> {
    let deflections: Vec<f64> = vector.iter().zip(masses).map(|(u, mass)| u / mass.sqrt()).collect();
    let largest = deflections.iter().fold(0.0f64, |a, b| if b.abs() > a.abs() { *b } else { a });
    deflections.iter().map(|w| w / largest).collect()
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
