//! A disc on a massless shaft: one deflection and one slope in each plane, coupled by the shaft and by gyroscopic
//! action.
//!
//! Force and moment on the shaft are `F = k₁₁ y + k₁₂ φ` and `M = k₁₂ y + k₂₂ φ`. Den Hartog, *Mechanical
//! Vibrations*, §6.6.

use crate::Real;

/// `k₁₁`, `k₁₂` and `k₂₂` of the tip of a cantilever: `12EI/L³`, `−6EI/L²`, `4EI/L`.
#[inline]
pub fn cantilever<S: Real>(young: S, second_moment: S, length: S) -> [S; 3] {
    [
        young * second_moment * 12.0 / length.powi(3),
        -(young * second_moment * 6.0) / length.powi(2),
        young * second_moment * 4.0 / length,
    ]
}

/// `p = (k₁₁ J + k₂₂ m)/2`, half of the coefficient of `ω²` in `m J ω⁴ − 2p ω² + (k₁₁k₂₂ − k₁₂²) = 0`.
#[inline]
pub fn half_sum<S: Real>(k11: S, k22: S, mass: S, inertia: S) -> S {
    (k11 * inertia + k22 * mass) / 2.0
}

/// `Δ = k₁₁k₂₂ − k₁₂²`.
#[inline]
pub fn determinant<S: Real>(k11: S, k12: S, k22: S) -> S {
    k11 * k22 - k12.powi(2)
}

/// The smaller positive root for `ω²` of `m J ω⁴ − 2p ω² + Δ = 0`, written so that it holds for any sign of `J`,
/// zero included: `ω² = Δ/(p + √(p² − mJΔ))`.
#[inline]
pub fn lower_square<S: Real>(mass: S, inertia: S, half_sum: S, determinant: S) -> S {
    determinant / (half_sum + (half_sum.powi(2) - mass * inertia * determinant).sqrt())
}

/// The larger root for `ω²`, positive for `J > 0` alone: `ω² = (p + √(p² − mJΔ))/(mJ)`.
#[inline]
pub fn upper_square<S: Real>(mass: S, inertia: S, half_sum: S, determinant: S) -> S {
    (half_sum + (half_sum.powi(2) - mass * inertia * determinant).sqrt()) / (mass * inertia)
}
