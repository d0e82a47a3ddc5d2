//! Shear coefficients `κ` of the Timoshenko beam: the shear force is `κ G A` times the mean shear angle.
//!
//! G. R. Cowper, "The shear coefficient in Timoshenko's beam theory", *J. Appl. Mech.* 33 (1966), pp. 335–340;
//! `ν` is Poisson's ratio.

use crate::Real;

/// Round section, `κ = 6(1 + ν)/(7 + 6ν)`.
#[inline]
pub fn round<S: Real>(poisson: S) -> S {
    (poisson + 1.0) * 6.0 / (poisson * 6.0 + 7.0)
}

/// Rectangle, `κ = 10(1 + ν)/(12 + 11ν)`.
#[inline]
pub fn rectangle<S: Real>(poisson: S) -> S {
    (poisson + 1.0) * 10.0 / (poisson * 11.0 + 12.0)
}

/// Tube with the ratio `m = d/D` of its diameters, `κ = 6(1 + ν)(1 + m²)²/((7 + 6ν)(1 + m²)² + (20 + 12ν)m²)`.
#[inline]
pub fn tube<S: Real>(poisson: S, ratio: S) -> S {
    let square = (ratio.powi(2) + 1.0).powi(2);
    (poisson + 1.0) * 6.0 * square
        / ((poisson * 6.0 + 7.0) * square + (poisson * 12.0 + 20.0) * ratio.powi(2))
}

/// Thin-walled round tube, `κ = 2(1 + ν)/(4 + 3ν)`.
#[inline]
pub fn thin_round_tube<S: Real>(poisson: S) -> S {
    (poisson + 1.0) * 2.0 / (poisson * 3.0 + 4.0)
}

/// Thin-walled square tube, `κ = 20(1 + ν)/(48 + 39ν)`.
#[inline]
pub fn thin_square_tube<S: Real>(poisson: S) -> S {
    (poisson + 1.0) * 20.0 / (poisson * 39.0 + 48.0)
}
