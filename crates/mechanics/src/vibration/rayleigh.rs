//! Rayleigh damping `C = α M + β K`: `ζ(ω) = α/(2ω) + β ω/2`.
//!
//! R. W. Clough and J. Penzien, *Dynamics of Structures*, 2nd ed., §12-6.

use crate::Real;

/// Coefficient of the mass `α = 2 ω₁ ω₂ (ζ₁ ω₂ − ζ₂ ω₁)/(ω₂² − ω₁²)`, 1/s.
#[inline]
pub fn mass_coefficient<S: Real>([first, second]: [S; 2], [zeta1, zeta2]: [S; 2]) -> S {
    first * second * (zeta1 * second - zeta2 * first) * 2.0 / (second.powi(2) - first.powi(2))
}

/// Coefficient of the stiffness `β = 2 (ζ₂ ω₂ − ζ₁ ω₁)/(ω₂² − ω₁²)`, s.
#[inline]
pub fn stiffness_coefficient<S: Real>([first, second]: [S; 2], [zeta1, zeta2]: [S; 2]) -> S {
    (zeta2 * second - zeta1 * first) * 2.0 / (second.powi(2) - first.powi(2))
}

/// Damping ratio of a mode of frequency `ω`: `ζ = α/(2ω) + β ω/2`.
#[inline]
pub fn damping_ratio<S: Real>(mass_coefficient: S, stiffness_coefficient: S, frequency: S) -> S {
    mass_coefficient / (frequency * 2.0) + stiffness_coefficient * frequency / 2.0
}
