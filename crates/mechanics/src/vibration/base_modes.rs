//! Modes of a chain of masses on springs, as its base sees them.

use nalgebra::DMatrix;

use crate::Real;
use dalembert_numerics::linalg::{self, LinalgError};

/// A mode of a chain that stands on its base.
#[derive(Debug, Clone, PartialEq)]
pub struct BaseMode {
    /// Natural frequency, rad/s.
    pub natural: f64,
    /// Displacements of the masses, scaled to a modal mass of 1 kg: kg^(−1/2).
    pub shape: Vec<f64>,
    /// Participation `Γ = Σ mᵢφᵢ`, kg^(1/2), never negative.
    pub participation: f64,
}

/// The modes of masses in a row, each on a spring towards the one before it and the first towards the base;
/// ascending. `Σ Γφ = 1` at every mass, `Σ Γ²` is the whole mass. Chopra, *Dynamics of Structures*, §13.1.
///
/// # Errors
/// Those of the eigenvalue problem; `Shape` unless there are as many springs as masses, all positive.
pub fn base_modes(masses: &[f64], stiffnesses: &[f64]) -> Result<Vec<BaseMode>, LinalgError> {
    let n = masses.len();
    let positive = |x: &f64| *x > 0.0;
    if n == 0 || stiffnesses.len() != n || !masses.iter().chain(stiffnesses).all(positive) {
        return Err(LinalgError::Shape {
            rows: n,
            columns: stiffnesses.len(),
            wanted: "as many springs as masses, all positive",
        });
    }
    let scaled = DMatrix::from_fn(n, n, |i, j| {
        let k = match i.abs_diff(j) {
            0 => stiffnesses[i] + stiffnesses.get(i + 1).copied().unwrap_or(0.0),
            1 => -stiffnesses[i.max(j)],
            _ => 0.0,
        };
        k / (masses[i].sqrt() * masses[j].sqrt())
    });
    let eigen = linalg::symmetric_eigen(&scaled)?;
    Ok((0..n)
        .map(|mode| {
            let mut shape: Vec<f64> = (0..n).map(|i| eigen.vectors[(i, mode)] / masses[i].sqrt()).collect();
            let mut participation: f64 = masses.iter().zip(&shape).map(|(m, x)| m * x).sum();
            if participation < 0.0 {
                participation = -participation;
                shape = shape.into_iter().map(|x| -x).collect();
            }
            BaseMode { natural: eigen.values[mode].max(0.0).sqrt(), shape, participation }
        })
        .collect())
}

/// Holzer residual at a frequency: base displacement for a unit amplitude of the free end, by recursion along the
/// chain, masses and springs from the base on as for [`base_modes`], over the largest displacement on the way; zero at
/// a natural frequency.
pub fn holzer_residual(masses: &[f64], stiffnesses: &[f64], omega: f64) -> f64 {
    let (mut x, mut force, mut largest) = (1.0, 0.0, 1.0f64);
    for (mass, stiffness) in masses.iter().zip(stiffnesses).rev() {
        force += mass * omega * omega * x;
        x -= force / stiffness;
        largest = largest.max(x.abs()).max((force / stiffness).abs());
    }
    x / largest
}

/// Correlation of two modes under a broad excitation, the weight of the complete quadratic combination, for the
/// frequency ratio `r = ω₂/ω₁`: `8√(ζ₁ζ₂)(ζ₁ + rζ₂)r√r/((1 − r²)² + 4ζ₁ζ₂r(1 + r²) + 4(ζ₁² + ζ₂²)r²)`.
/// Chopra, *Dynamics of Structures*, §13.7.
#[inline]
pub fn correlation<S: Real>(ratio: S, other: S, frequency_ratio: S) -> S {
    (ratio * other).sqrt()
        * (ratio + frequency_ratio * other)
        * frequency_ratio
        * frequency_ratio.sqrt()
        * 8.0
        / ((S::from(1.0) - frequency_ratio.powi(2)).powi(2)
            + ratio * other * frequency_ratio * (frequency_ratio.powi(2) + 1.0) * 4.0
            + (ratio.powi(2) + other.powi(2)) * frequency_ratio.powi(2) * 4.0)
}
