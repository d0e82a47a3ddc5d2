//! The resonance peak: where it is, how high, how wide, and what it says of the damping.
//!
//! Force-excited and unbalance-excited systems have the same peak, `1/(2ζ√(1 − ζ²))`, as a multiple of `F₀/k` and
//! of `m₀e/m`; it exists for `ζ < 1/√2` and lies at `r = √(1 − 2ζ²)` and at `r = 1/√(1 − 2ζ²)`.

use crate::Real;

/// Height of the peak, `1/(2ζ√(1 − ζ²))`, for `0 < ζ < 1/√2`: `X k/F₀` under a force, `m X/(m₀e)` under an
/// unbalance. Rao, *Mechanical Vibrations*, 5th ed., §3.4 and §3.7.
#[inline(always)]
pub fn peak_magnification<S: Real>(damping_ratio: S) -> S {
    S::from(1.0) / (damping_ratio * 2.0 * (S::from(1.0) - damping_ratio.powi(2)).sqrt())
}

/// Frequency ratio of the peak under a force, `r = √(1 − 2ζ²)`. Rao, 5th ed., §3.4.
#[inline(always)]
pub fn magnification_peak_ratio<S: Real>(damping_ratio: S) -> S {
    (S::from(1.0) - damping_ratio.powi(2) * 2.0).sqrt()
}

/// Frequency ratio of the peak under a rotating unbalance, `r = 1/√(1 − 2ζ²)`. Rao, 5th ed., §3.7.
#[inline(always)]
pub fn unbalance_peak_ratio<S: Real>(damping_ratio: S) -> S {
    S::from(1.0) / (S::from(1.0) - damping_ratio.powi(2) * 2.0).sqrt()
}

/// Natural frequency from the frequency of the peak under a force: `ω_n = ω_p/√(1 − 2ζ²)`, rad/s.
#[inline(always)]
pub fn natural_frequency_from_force_peak<S: Real>(peak_frequency: S, damping_ratio: S) -> S {
    peak_frequency / (S::from(1.0) - damping_ratio.powi(2) * 2.0).sqrt()
}

/// Damping ratio of a peak `Λ`, the root of `4Λ²ζ²(1 − ζ²) = 1` below `1/√2`:
/// `ζ = 1/√(2Λ(Λ + √((Λ − 1)(Λ + 1))))`. `None` where there is no peak, `Λ ≤ 1`.
///
/// `Λ` is `m X/(m₀e)` for an unbalance and `X k/F₀` for a force. The usual `ζ² = (1 − √(1 − 1/Λ²))/2` is the same
/// number, but loses all its digits to cancellation when the damping is light.
#[inline(always)]
pub fn damping_ratio_from_peak<S: Real>(peak: S) -> Option<S> {
    has_peak(peak).then(|| S::from(1.0) / (peak * 2.0 * (peak + ((peak - 1.0) * (peak + 1.0)).sqrt())).sqrt())
}

/// The other root of `4Λ²ζ²(1 − ζ²) = 1`, `ζ = √((1 + √(1 − 1/Λ²))/2)`, above `1/√2`, where the response has no
/// peak at all: to be shown and rejected. `None` where `Λ ≤ 1`.
#[inline(always)]
pub fn extraneous_damping_ratio_from_peak<S: Real>(peak: S) -> Option<S> {
    has_peak(peak).then(|| (((S::from(1.0) - S::from(1.0) / peak.powi(2)).sqrt() + 1.0) / 2.0).sqrt())
}

/// Damping from the receptance `H = |X/F₀|` in m/N measured at the natural frequency: `c = 1/(H ω_n)`, N·s/m.
///
/// With the frequency and height of the peak in place of those of `ω_n` it is the textbook estimate for light
/// damping; its error in `c` is of the order `ζ²`.
#[inline(always)]
pub fn damping_from_resonant_receptance<S: Real>(receptance: S, natural_frequency: S) -> S {
    S::from(1.0) / (receptance * natural_frequency)
}

/// Quality factor `Q = 1/(2ζ)`: the magnification at `r = 1`. Rao, 5th ed., §3.4.
#[inline(always)]
pub fn quality_factor<S: Real>(damping_ratio: S) -> S {
    S::from(1.0) / (damping_ratio * 2.0)
}

/// Frequency ratio below the peak where the magnification is `1/√2` of its peak, exact:
/// `r₁ = √(1 − 2ζ² − 2ζ√(1 − ζ²))`, for `ζ ≤ sin(π/8) = 0.3827`; above that there is none.
#[inline(always)]
pub fn lower_half_power_ratio<S: Real>(damping_ratio: S) -> S {
    (S::from(1.0)
        - damping_ratio.powi(2) * 2.0
        - damping_ratio * 2.0 * (S::from(1.0) - damping_ratio.powi(2)).sqrt())
    .sqrt()
}

/// Frequency ratio above the peak where the magnification is `1/√2` of its peak, exact:
/// `r₂ = √(1 − 2ζ² + 2ζ√(1 − ζ²))`, for `ζ < 1/√2`.
#[inline(always)]
pub fn upper_half_power_ratio<S: Real>(damping_ratio: S) -> S {
    (S::from(1.0) - damping_ratio.powi(2) * 2.0
        + damping_ratio * 2.0 * (S::from(1.0) - damping_ratio.powi(2)).sqrt())
    .sqrt()
}

/// Damping ratio from the two half-power frequencies of a force-excited peak, exact:
/// `ζ = sin(½ atan2(ω₂² − ω₁², ω₂² + ω₁²))`.
#[inline(always)]
pub fn damping_ratio_from_half_power<S: Real>(lower: S, upper: S) -> S {
    ((upper.powi(2) - lower.powi(2)).atan2(upper.powi(2) + lower.powi(2)) / 2.0).sin()
}

/// Damping ratio from the half-power bandwidth, for light damping: `ζ ≈ (ω₂ − ω₁)/(2ω_n)`. Rao, 5th ed., §3.4.
#[inline(always)]
pub fn damping_ratio_from_bandwidth<S: Real>(lower: S, upper: S, natural_frequency: S) -> S {
    (upper - lower) / (natural_frequency * 2.0)
}

fn has_peak<S: Real>(peak: S) -> bool {
    peak.holds(|peak| peak > 1.0)
}
