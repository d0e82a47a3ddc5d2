//! One degree of freedom: `m ẍ + c ẋ + k x = F(t)`.
//!
//! Mass `m` in kg, damping `c` in N·s/m, stiffness `k` in N/m, every frequency and speed in rad/s. Amplitudes are
//! zero to peak. `r = ω/ω_n` is the frequency ratio, `ζ = c/(2√(k m))` the damping ratio.
//!
//! ```
//! use std::f64::consts::FRAC_PI_2;
//!
//! use dalembert_mechanics::sdof::{damping_from_ratio, natural_frequency, phase_lag, unbalance_amplitude};
//!
//! // A machine of 20 kg on 8000 N/m with ζ = 0.1 and a rotating unbalance of 0.05 kg·m.
//! let (mass, stiffness, unbalance) = (20.0, 8000.0, 0.05);
//! let damping = damping_from_ratio(0.1, stiffness, mass);
//! let natural = natural_frequency(stiffness, mass);
//! assert!((natural - 20.0).abs() < 1e-13);
//! // At resonance X = m₀e/(2 ζ m), a quarter of a turn behind the unbalance; far above it X = m₀e/m.
//! assert!((unbalance_amplitude(unbalance, stiffness, mass, damping, natural) - 0.0125).abs() < 1e-14);
//! assert!((phase_lag(stiffness, mass, damping, natural) - FRAC_PI_2).abs() < 1e-12);
//! assert!((unbalance_amplitude(unbalance, stiffness, mass, damping, 1e6) - 0.0025).abs() < 1e-11);
//! ```

use std::f64::consts::PI;

use crate::Real;

mod decay;
mod peak;

pub use decay::{
    damping_ratio_from_decrement, decrement_from_damping_ratio, logarithmic_decrement,
    natural_frequency_from_damped,
};
pub use peak::{
    damping_from_resonant_receptance, damping_ratio_from_bandwidth, damping_ratio_from_half_power,
    damping_ratio_from_peak, extraneous_damping_ratio_from_peak, lower_half_power_ratio,
    magnification_peak_ratio, natural_frequency_from_force_peak, peak_magnification, quality_factor,
    unbalance_peak_ratio, upper_half_power_ratio,
};

/// Undamped natural frequency `ω_n = √(k/m)`, rad/s. Rao, *Mechanical Vibrations*, 5th ed., §2.2.
#[inline(always)]
pub fn natural_frequency<S: Real>(stiffness: S, mass: S) -> S {
    (stiffness / mass).sqrt()
}

/// Mass that has the natural frequency `ω_n` on a stiffness: `m = k/ω_n²`, kg.
#[inline(always)]
pub fn mass_from_natural_frequency<S: Real>(stiffness: S, natural_frequency: S) -> S {
    stiffness / natural_frequency.powi(2)
}

/// Stiffness that gives a mass the natural frequency `ω_n`: `k = m ω_n²`, N/m.
#[inline(always)]
pub fn stiffness_from_natural_frequency<S: Real>(mass: S, natural_frequency: S) -> S {
    mass * natural_frequency.powi(2)
}

/// Stiffness from the static receptance `X₀/F₀` in m/N: `k = 1/H₀`, N/m.
#[inline(always)]
pub fn stiffness_from_static_receptance<S: Real>(static_receptance: S) -> S {
    S::from(1.0) / static_receptance
}

/// Critical damping `c_c = 2√(k m)`, N·s/m. Rao, 5th ed., §2.6.
#[inline(always)]
pub fn critical_damping<S: Real>(stiffness: S, mass: S) -> S {
    (stiffness * mass).sqrt() * 2.0
}

/// Damping ratio `ζ = c/(2√(k m))`. Rao, 5th ed., §2.6.
#[inline(always)]
pub fn damping_ratio<S: Real>(damping: S, stiffness: S, mass: S) -> S {
    damping / ((stiffness * mass).sqrt() * 2.0)
}

/// Damping coefficient `c = 2ζ√(k m)`, N·s/m. Rao, 5th ed., §2.6.
#[inline(always)]
pub fn damping_from_ratio<S: Real>(damping_ratio: S, stiffness: S, mass: S) -> S {
    damping_ratio * (stiffness * mass).sqrt() * 2.0
}

/// Frequency of the damped free vibration `ω_d = ω_n √(1 − ζ²)`, rad/s, for `ζ < 1`. Rao, 5th ed., §2.6.
#[inline(always)]
pub fn damped_frequency<S: Real>(natural_frequency: S, damping_ratio: S) -> S {
    natural_frequency * (S::from(1.0) - damping_ratio.powi(2)).sqrt()
}

/// Frequency ratio `r = ω/ω_n`.
#[inline(always)]
pub fn frequency_ratio<S: Real>(frequency: S, natural_frequency: S) -> S {
    frequency / natural_frequency
}

/// Angular frequency of a period: `ω = 2π/T`, rad/s.
#[inline(always)]
pub fn angular_frequency<S: Real>(period: S) -> S {
    S::from(2.0) * PI / period
}

/// Receptance `|X/F₀| = 1/√((k − m ω²)² + (c ω)²)`, m/N. Rao, 5th ed., §3.4.
#[inline(always)]
pub fn receptance<S: Real>(stiffness: S, mass: S, damping: S, frequency: S) -> S {
    S::from(1.0) / dynamic_stiffness(stiffness, mass, damping, frequency)
}

/// Dynamic stiffness `|F₀/X| = √((k − m ω²)² + (c ω)²)`, N/m. Rao, 5th ed., §3.4.
#[inline(always)]
pub fn dynamic_stiffness<S: Real>(stiffness: S, mass: S, damping: S, frequency: S) -> S {
    ((stiffness - mass * frequency.powi(2)).powi(2) + (damping * frequency).powi(2)).sqrt()
}

/// Steady amplitude under `F₀ cos ωt`: `X = F₀/√((k − m ω²)² + (c ω)²)`, m. Rao, 5th ed., §3.4.
#[inline(always)]
pub fn forced_amplitude<S: Real>(force: S, stiffness: S, mass: S, damping: S, frequency: S) -> S {
    force / dynamic_stiffness(stiffness, mass, damping, frequency)
}

/// Angle by which the motion lags the force: `φ = atan2(c ω, k − m ω²)`, rad in `[0, π]`. Rao, 5th ed., §3.4.
#[inline(always)]
pub fn phase_lag<S: Real>(stiffness: S, mass: S, damping: S, frequency: S) -> S {
    (damping * frequency).atan2(stiffness - mass * frequency.powi(2))
}

/// Magnification `X k/F₀ = 1/√((1 − r²)² + (2ζr)²)`. Rao, 5th ed., §3.4.
#[inline(always)]
pub fn magnification<S: Real>(frequency_ratio: S, damping_ratio: S) -> S {
    S::from(1.0)
        / ((S::from(1.0) - frequency_ratio.powi(2)).powi(2) + (damping_ratio * frequency_ratio * 2.0).powi(2))
            .sqrt()
}

/// Angle by which the motion lags the force, from ratios: `φ = atan2(2ζr, 1 − r²)`, rad in `[0, π]`.
/// Rao, 5th ed., §3.4.
#[inline(always)]
pub fn phase_lag_from_ratios<S: Real>(frequency_ratio: S, damping_ratio: S) -> S {
    (damping_ratio * frequency_ratio * 2.0).atan2(S::from(1.0) - frequency_ratio.powi(2))
}

/// Steady amplitude of a machine with a rotating unbalance `m₀e` in kg·m:
/// `X = m₀e ω²/√((k − m ω²)² + (c ω)²)`, m; `m` is the whole mass. Rao, 5th ed., §3.7.
#[inline(always)]
pub fn unbalance_amplitude<S: Real>(unbalance: S, stiffness: S, mass: S, damping: S, speed: S) -> S {
    unbalance * speed.powi(2) / dynamic_stiffness(stiffness, mass, damping, speed)
}

/// Amplitude under a rotating unbalance as a multiple of `m₀e/m`:
/// `Λ = m X/(m₀e) = r²/√((1 − r²)² + (2ζr)²)`. Rao, 5th ed., §3.7.
///
/// The same number is the motion relative to a shaking base, `Z/Y` (Rao, 5th ed., §3.6).
#[inline(always)]
pub fn unbalance_magnification<S: Real>(frequency_ratio: S, damping_ratio: S) -> S {
    frequency_ratio.powi(2)
        / ((S::from(1.0) - frequency_ratio.powi(2)).powi(2) + (damping_ratio * frequency_ratio * 2.0).powi(2))
            .sqrt()
}

/// Transmissibility `√((1 + (2ζr)²)/((1 − r²)² + (2ζr)²))`: force to the ground over force on the mass, and just
/// as well motion of the mass over motion of the base. Rao, 5th ed., §3.6.
#[inline(always)]
pub fn transmissibility<S: Real>(frequency_ratio: S, damping_ratio: S) -> S {
    (((damping_ratio * frequency_ratio * 2.0).powi(2) + 1.0)
        / ((S::from(1.0) - frequency_ratio.powi(2)).powi(2)
            + (damping_ratio * frequency_ratio * 2.0).powi(2)))
    .sqrt()
}

/// Angle by which the transmitted force lags the force, or the mass lags its base:
/// `ψ = atan2(2ζr³, 1 + (4ζ² − 1) r²)`, rad in `[0, π]`. Rao, 5th ed., §3.6.
#[inline(always)]
pub fn transmissibility_phase<S: Real>(frequency_ratio: S, damping_ratio: S) -> S {
    (damping_ratio * frequency_ratio.powi(3) * 2.0)
        .atan2((damping_ratio.powi(2) * 4.0 - 1.0) * frequency_ratio.powi(2) + 1.0)
}

/// Amplitude of the force on the ground when the mass moves with amplitude `X`:
/// `F_T = X √(k² + (c ω)²)`, N. Rao, 5th ed., §3.6.
#[inline(always)]
pub fn transmitted_force<S: Real>(amplitude: S, stiffness: S, damping: S, frequency: S) -> S {
    amplitude * (stiffness.powi(2) + (damping * frequency).powi(2)).sqrt()
}
