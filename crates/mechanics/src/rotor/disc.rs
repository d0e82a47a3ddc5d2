//! Mass and moments of inertia of discs. Diameters and width in m, density in kg/m³.

use std::f64::consts::PI;

use crate::Real;

/// Mass of a flat disc, `m = ρ π (D² − d²) h/4`: outer diameter `D`, bore `d`, width `h`.
#[inline]
pub fn mass<S: Real>(density: S, outer: S, bore: S, width: S) -> S {
    density * (outer.powi(2) - bore.powi(2)) * width * PI / 4.0
}

/// Moment of inertia of a flat disc about its axis, `I_p = m (D² + d²)/8`.
#[inline]
pub fn polar<S: Real>(mass: S, outer: S, bore: S) -> S {
    mass * (outer.powi(2) + bore.powi(2)) / 8.0
}

/// Moment of inertia of a flat disc about a diameter through its centre, `I_d = I_p/2 + m h²/12`.
#[inline]
pub fn diametral<S: Real>(mass: S, polar: S, width: S) -> S {
    polar / 2.0 + mass * width.powi(2) / 12.0
}
