//! The closed forms that a worked solution writes: free motions from a unit start, and responses to unit loads.
//!
//! `ω` is the natural frequency without damping, `ω_d = ω√(1 − ζ²)` the damped one, both in rad/s; `s₁ < s₂` are the
//! rates of decay of an overdamped motion, 1/s. Rao, *Mechanical Vibrations*, 5th ed., §2.6 and ch. 4.

use crate::Real;

/// Free motion from a unit displacement at rest, `ζ < 1`: `e^(−ζωt)(cos ω_d t + ζω/ω_d sin ω_d t)`.
#[inline]
pub fn release_underdamped<S: Real>(natural: S, ratio: S, damped: S, time: S) -> S {
    (-(ratio * natural * time)).exp()
        * ((damped * time).cos() + ratio * natural / damped * (damped * time).sin())
}

/// Response to a unit impulse for each unit of mass, `ζ < 1`: `e^(−ζωt) sin(ω_d t)/ω_d`, s.
#[inline]
pub fn impulse_underdamped<S: Real>(natural: S, ratio: S, damped: S, time: S) -> S {
    (-(ratio * natural * time)).exp() * (damped * time).sin() / damped
}

/// Free motion from a unit displacement at rest, `ζ = 0`: `cos ωt`.
#[inline]
pub fn release_undamped<S: Real>(natural: S, time: S) -> S {
    (natural * time).cos()
}

/// Response to a unit impulse for each unit of mass, `ζ = 0`: `sin(ωt)/ω`, s.
#[inline]
pub fn impulse_undamped<S: Real>(natural: S, time: S) -> S {
    (natural * time).sin() / natural
}

/// Free motion from a unit displacement at rest, `ζ = 1`: `e^(−ωt)(1 + ωt)`.
#[inline]
pub fn release_critical<S: Real>(natural: S, time: S) -> S {
    (-(natural * time)).exp() * (natural * time + 1.0)
}

/// Response to a unit impulse for each unit of mass, `ζ = 1`: `t e^(−ωt)`, s.
#[inline]
pub fn impulse_critical<S: Real>(natural: S, time: S) -> S {
    time * (-(natural * time)).exp()
}

/// Slower rate of decay of an overdamped motion, `s₁ = ω/(ζ + √(ζ² − 1))`, 1/s, written so that nothing cancels.
#[inline]
pub fn slow_rate<S: Real>(natural: S, ratio: S) -> S {
    natural / (ratio + (ratio.powi(2) - 1.0).sqrt())
}

/// Faster rate of decay of an overdamped motion, `s₂ = ω(ζ + √(ζ² − 1))`, 1/s.
#[inline]
pub fn fast_rate<S: Real>(natural: S, ratio: S) -> S {
    natural * (ratio + (ratio.powi(2) - 1.0).sqrt())
}

/// Free motion from a unit displacement at rest, `ζ > 1`: `(s₂e^(−s₁t) − s₁e^(−s₂t))/(s₂ − s₁)`.
#[inline]
pub fn release_overdamped<S: Real>(slow: S, fast: S, time: S) -> S {
    (fast * (-(slow * time)).exp() - slow * (-(fast * time)).exp()) / (fast - slow)
}

/// Response to a unit impulse for each unit of mass, `ζ > 1`: `(e^(−s₁t) − e^(−s₂t))/(s₂ − s₁)`, s.
#[inline]
pub fn impulse_overdamped<S: Real>(slow: S, fast: S, time: S) -> S {
    ((-(slow * time)).exp() - (-(fast * time)).exp()) / (fast - slow)
}

/// Response to a ramp of one static displacement a second, from the free motions `g` and `h`:
/// `t − 2ζ(1 − g)/ω − h`, s.
#[inline]
pub fn ramp<S: Real>(natural: S, ratio: S, time: S, release: S, impulse: S) -> S {
    time - ratio * (S::from(1.0) - release) * 2.0 / natural - impulse
}

/// Response to `sin Ωt` from rest, from the free motions `g` and `h` and the frequency ratio `r = Ω/ω`:
/// `((1 − r²)(sin Ωt − Ωh) − 2ζr(cos Ωt − g))/((1 − r²)² + (2ζr)²)`; not at resonance without damping.
#[inline]
pub fn sine<S: Real>(frequency: S, frequency_ratio: S, ratio: S, time: S, release: S, impulse: S) -> S {
    let detuning = S::from(1.0) - frequency_ratio.powi(2);
    (detuning * ((frequency * time).sin() - frequency * impulse)
        - ratio * frequency_ratio * 2.0 * ((frequency * time).cos() - release))
        / (detuning.powi(2) + (ratio * frequency_ratio * 2.0).powi(2))
}

/// The same without damping: `(sin Ωt − Ωh)/(1 − r²)`; Rao, 5th ed., §4.5.
#[inline]
pub fn sine_undamped<S: Real>(frequency: S, frequency_ratio: S, time: S, impulse: S) -> S {
    ((frequency * time).sin() - frequency * impulse) / (S::from(1.0) - frequency_ratio.powi(2))
}

/// Response to `e^(−t/τ)` from rest, from the free motions `g` and `h`:
/// `(e^(−t/τ) − g + h/τ)/(1 − 2ζ/(ωτ) + 1/(ωτ)²)`.
#[inline]
pub fn exponential<S: Real>(constant: S, natural: S, ratio: S, time: S, release: S, impulse: S) -> S {
    ((-(time / constant)).exp() - release + impulse / constant)
        / (S::from(1.0) - ratio * 2.0 / (natural * constant) + S::from(1.0) / (natural * constant).powi(2))
}

/// Response to `cos Ωt` from rest, from the free motions `g` and `h` and the frequency ratio `r = Ω/ω`:
/// `((1 − r²)(cos Ωt − g) + 2ζr(sin Ωt − Ωh))/((1 − r²)² + (2ζr)²)`; not at resonance without damping.
#[inline]
pub fn cosine<S: Real>(frequency: S, frequency_ratio: S, ratio: S, time: S, release: S, impulse: S) -> S {
    let detuning = S::from(1.0) - frequency_ratio.powi(2);
    (detuning * ((frequency * time).cos() - release)
        + ratio * frequency_ratio * 2.0 * ((frequency * time).sin() - frequency * impulse))
        / (detuning.powi(2) + (ratio * frequency_ratio * 2.0).powi(2))
}

/// Response to `t²/2` from rest, from the free motions `g` and `h`:
/// `t²/2 − 2ζ(t − h)/ω + (4ζ² − 1)(1 − g)/ω²`, s².
#[inline]
pub fn parabola<S: Real>(natural: S, ratio: S, time: S, release: S, impulse: S) -> S {
    time.powi(2) / 2.0 - ratio * (time - impulse) * 2.0 / natural
        + (ratio.powi(2) * 4.0 - 1.0) * (S::from(1.0) - release) / natural.powi(2)
}
