//! Damping and natural frequency from two or three measured numbers.
//!
//! Frequencies in rad/s, amplitudes in m. Each follows from the formulas of Rao, *Mechanical Vibrations*, 5th ed.,
//! §2.6, §3.4 and §3.7, solved for what is sought.

use crate::Real;

/// Damping ratio from the frequency of the free vibration `ω_d = ω_n √(1 − ζ²)` and that of the peak under a force
/// `ω_p = ω_n √(1 − 2ζ²)`: `ζ = √((ω_d² − ω_p²)/(2ω_d² − ω_p²))`, for `ω_p ≤ ω_d`.
#[inline]
pub fn damping_ratio_from_free_and_forced<S: Real>(damped_frequency: S, peak_frequency: S) -> S {
    ((damped_frequency.powi(2) - peak_frequency.powi(2))
        / (damped_frequency.powi(2) * 2.0 - peak_frequency.powi(2)))
    .sqrt()
}

/// Damping ratio of an unbalanced machine from its amplitude at the natural frequency, `m₀e/(2ζm)`, and far above it,
/// `m₀e/m`: `ζ = X_∞/(2X)`.
#[inline]
pub fn damping_ratio_from_resonance_and_far<S: Real>(resonant_amplitude: S, far_amplitude: S) -> S {
    far_amplitude / (resonant_amplitude * 2.0)
}

/// Damping ratio from the amplitude under a force at the natural frequency over that at `r = ω/ω_n`, `q = X_n/X`:
/// `ζ = |1 − r²|/(2√(q² − r²))`, for `q > r`.
#[inline]
pub fn damping_ratio_from_force_ratio<S: Real>(amplitude_ratio: S, frequency_ratio: S) -> S {
    (S::from(1.0) - frequency_ratio.powi(2)).abs()
        / ((amplitude_ratio.powi(2) - frequency_ratio.powi(2)).sqrt() * 2.0)
}

/// Damping ratio from the amplitude under an unbalance at the natural frequency over that at `r = ω/ω_n`,
/// `q = X_n/X`: `ζ = |1 − r²|/(2√(q²r⁴ − r²))`, for `q r > 1`.
#[inline]
pub fn damping_ratio_from_unbalance_ratio<S: Real>(amplitude_ratio: S, frequency_ratio: S) -> S {
    (S::from(1.0) - frequency_ratio.powi(2)).abs()
        / ((amplitude_ratio.powi(2) * frequency_ratio.powi(4) - frequency_ratio.powi(2)).sqrt() * 2.0)
}

/// Natural frequency of an unbalanced machine from its amplitudes at two speeds, each as a multiple `Λ` of `m₀e/m`:
/// with `g = ω²(1/Λ² − 1)`, `ω_n⁴ = (g₁ − g₂)/(1/ω₁² − 1/ω₂²)`.
///
/// At every speed `ω_n⁴ − 2ω_n²ω² + 4ζ²ω_n²ω² = ω⁴(1/Λ² − 1)`; over `ω²`, the terms in the middle are alike.
#[inline]
pub fn natural_frequency_from_two_speeds<S: Real>(speeds: [S; 2], magnifications: [S; 2]) -> S {
    let one = S::from(1.0);
    ((excess(speeds[0], magnifications[0]) - excess(speeds[1], magnifications[1]))
        / (one / speeds[0].powi(2) - one / speeds[1].powi(2)))
    .root(4)
}

/// Damping ratio of an unbalanced machine of known natural frequency from its amplitude at one speed:
/// `ζ = √((2ω_n² + ω²(1/Λ² − 1) − ω_n⁴/ω²)/(4ω_n²))`.
#[inline]
pub fn damping_ratio_from_speed<S: Real>(natural_frequency: S, speed: S, magnification: S) -> S {
    ((natural_frequency.powi(2) * 2.0 + excess(speed, magnification)
        - natural_frequency.powi(4) / speed.powi(2))
        / (natural_frequency.powi(2) * 4.0))
        .sqrt()
}

fn excess<S: Real>(speed: S, magnification: S) -> S {
    speed.powi(2) * (S::from(1.0) / magnification.powi(2) - 1.0)
}
