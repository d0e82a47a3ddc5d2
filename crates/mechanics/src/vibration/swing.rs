//! Moments of inertia from swing tests: the time of small swings, and what follows from it.
//!
//! All times are periods of small swings, s; W. T. Thomson, *Theory of Vibration with Applications*, ch. 2.

use std::f64::consts::PI;

use crate::Real;

/// Length of the simple pendulum of that period, `λ = g T²/(4π²)`, m.
#[inline]
pub fn reduced_length<S: Real>(gravity: S, period: S) -> S {
    gravity * period.powi(2) / (4.0 * PI * PI)
}

/// Distance of the centre of mass from the first of two points of suspension on one line through it:
/// `h₁ = L (L − λ₂)/(2 L − λ₁ − λ₂)` for points on both sides at the distance `L`, m.
#[inline]
pub fn centre_between<S: Real>(distance: S, first: S, second: S) -> S {
    distance * (distance - second) / (distance * 2.0 - first - second)
}

/// The same for two points on one side of the centre of mass, the second one nearer to it:
/// `h₁ = L (L + λ₂)/(2 L − λ₁ + λ₂)`, m.
#[inline]
pub fn centre_beyond<S: Real>(distance: S, first: S, second: S) -> S {
    distance * (distance + second) / (distance * 2.0 - first + second)
}

/// Moment of inertia of a body in a bifilar or trifilar suspension, `J = m g r R T²/(4π² h)`, kg·m²: wires fixed at the
/// radii `r` below and `R` above, the vertical distance `h` between the two circles, m.
#[inline]
pub fn on_wires<S: Real>(weight: S, below: S, above: S, height: S, period: S) -> S {
    weight * below * above * period.powi(2) / (height * (4.0 * PI * PI))
}

/// Square of the radius of gyration of a body whose journals roll in hollow rails, `κ² = ρ² (g T²/(4π² (R − ρ)) − 1)`,
/// m²: radius `ρ` of the journals, `R` of the rails.
#[inline]
pub fn on_hollow_rails<S: Real>(gravity: S, journal: S, rails: S, period: S) -> S {
    journal.powi(2) * (reduced_length(gravity, period) / (rails - journal) - 1.0)
}
