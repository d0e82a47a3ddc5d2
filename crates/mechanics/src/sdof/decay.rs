//! Free decay: what successive amplitudes say of the damping.

use std::f64::consts::PI;

use crate::Real;

/// Logarithmic decrement from two amplitudes of the same sign, `n` cycles apart: `δ = ln(x₁/x₍ₙ₊₁₎)/n`.
///
/// Seven successive amplitudes span six cycles. Rao, *Mechanical Vibrations*, 5th ed., §2.6.
#[inline(always)]
pub fn logarithmic_decrement<S: Real>(amplitude_ratio: S, cycles: S) -> S {
    amplitude_ratio.ln() / cycles
}

/// Damping ratio of a decrement, exact: `ζ = δ/√((2π)² + δ²)`. Rao, 5th ed., §2.6.
#[inline(always)]
pub fn damping_ratio_from_decrement<S: Real>(decrement: S) -> S {
    decrement / ((S::from(2.0) * PI).powi(2) + decrement.powi(2)).sqrt()
}

/// Decrement of a damping ratio below one, exact: `δ = 2πζ/√(1 − ζ²)`. Rao, 5th ed., §2.6.
#[inline(always)]
pub fn decrement_from_damping_ratio<S: Real>(damping_ratio: S) -> S {
    damping_ratio * 2.0 * PI / (S::from(1.0) - damping_ratio.powi(2)).sqrt()
}

/// Undamped natural frequency from the frequency of the decaying motion: `ω_n = ω_d/√(1 − ζ²)`, rad/s.
/// Rao, 5th ed., §2.6.
#[inline(always)]
pub fn natural_frequency_from_damped<S: Real>(damped_frequency: S, damping_ratio: S) -> S {
    damped_frequency / (S::from(1.0) - damping_ratio.powi(2)).sqrt()
}
