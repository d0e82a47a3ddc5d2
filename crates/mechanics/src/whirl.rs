//! Jeffcott rotor: an unbalanced disc on a flexible shaft, and the shafts that keep it clear of its stator.
//!
//! Rotor mass `m` in kg at the stiffness `k` in N/m, unbalance `m e` in kg·m, clearance `R` in m, speeds `ω` in
//! rad/s, damping `c` in N·s/m or as the ratio `ζ`. The whirl of the undamped or viscously damped Jeffcott rotor
//! has the amplitude of [`crate::sdof::unbalance_amplitude`] (Rao, *Mechanical Vibrations*, 5th ed., §9.5).
//!
//! ```
//! use dalembert_mechanics::whirl::{WhirlError, permitted_speeds, whirl_amplitude};
//!
//! // A critical speed of 300 rad/s, the centre of mass 0.1 mm off the shaft, a clearance of 0.5 mm, no damping: the whirl
//! // reaches the clearance at ω_n √(R/(R + e)) and is within it again from ω_n √(R/(R − e)) on.
//! let speeds = permitted_speeds(300.0, 0.1e-3, 0.5e-3, 0.0)?;
//! let (below, above) = (speeds.below.expect("it is reached"), speeds.above.expect("it is left"));
//! assert!((below - 300.0 * (5.0_f64 / 6.0).sqrt()).abs() < 1e-9);
//! assert!((above - 300.0 * (5.0_f64 / 4.0).sqrt()).abs() < 1e-9);
//! assert!((whirl_amplitude(0.1e-3, above / 300.0, 0.0) - 0.5e-3).abs() < 1e-15);
//! assert!(!speeds.set.contains(300.0));
//! // Far above the critical speed the rotor turns about its centre of mass: the amplitude is the eccentricity.
//! assert!((whirl_amplitude(0.1e-3, 1e6, 0.0) - 0.1e-3).abs() < 1e-15);
//! # Ok::<(), WhirlError>(())
//! ```

use crate::Real;

mod permitted;
mod speeds;

pub use permitted::{
    LimitedBy, PermittedStiffness, StiffnessLimit, WhirlError, permitted_stiffness,
    permitted_stiffness_at_damping, worst_speed,
};
pub use speeds::{PermittedSpeeds, permitted_speeds};

/// Whirl amplitude `A = e r²/√((1 − r²)² + (2ζr)²)`, m, of a rotor whose centre of mass is `e` off the shaft, at
/// `r = ω/ω_n`. Rao, 5th ed., §9.5.
#[inline]
pub fn whirl_amplitude<S: Real>(eccentricity: S, frequency_ratio: S, damping_ratio: S) -> S {
    eccentricity * frequency_ratio.powi(2)
        / ((S::from(1.0) - frequency_ratio.powi(2)).powi(2) + (damping_ratio * frequency_ratio * 2.0).powi(2))
            .sqrt()
}

/// Below the undamped resonance at a speed: the stiffness at which the amplitude is just the clearance,
/// `k = (m − m e/R) ω²`, N/m. Negative when the eccentricity alone exceeds the clearance.
#[inline]
pub fn soft_limit_undamped<S: Real>(mass: S, unbalance: S, clearance: S, speed: S) -> S {
    (mass - unbalance / clearance) * speed.powi(2)
}

/// Above the undamped resonance at a speed: the stiffness at which the amplitude is just the clearance,
/// `k = (m + m e/R) ω²`, N/m.
#[inline]
pub fn stiff_limit_undamped<S: Real>(mass: S, unbalance: S, clearance: S, speed: S) -> S {
    (mass + unbalance / clearance) * speed.powi(2)
}

/// The lower stiffness at which the amplitude at a speed is just the clearance, with the damping ratio fixed:
/// `k = m ω² (1 − 2ζ² − √((m e/(m R))² − 4ζ²(1 − ζ²)))`, N/m, from `(k − m ω²)² + (c ω)² = (m e ω²/R)²` with
/// `c² = 4ζ²k m`.
#[inline]
pub fn soft_limit<S: Real>(mass: S, unbalance: S, clearance: S, speed: S, damping_ratio: S) -> S {
    mass * speed.powi(2)
        * (S::from(1.0)
            - damping_ratio.powi(2) * 2.0
            - limit_width(mass, unbalance, clearance, damping_ratio))
}

/// The upper stiffness at which the amplitude at a speed is just the clearance, with the damping ratio fixed:
/// `k = m ω² (1 − 2ζ² + √((m e/(m R))² − 4ζ²(1 − ζ²)))`, N/m. See [`soft_limit`].
#[inline]
pub fn stiff_limit<S: Real>(mass: S, unbalance: S, clearance: S, speed: S, damping_ratio: S) -> S {
    mass * speed.powi(2)
        * (S::from(1.0) - damping_ratio.powi(2) * 2.0
            + limit_width(mass, unbalance, clearance, damping_ratio))
}

/// Eccentricity whose whirl at `r = ω/ω_n` has the amplitude `R`: `e = R √((1 − r²)² + (2ζr)²)/r²`, m, the inverse of
/// [`whirl_amplitude`].
#[inline]
pub fn eccentricity_from_amplitude<S: Real>(amplitude: S, frequency_ratio: S, damping_ratio: S) -> S {
    amplitude
        * ((S::from(1.0) - frequency_ratio.powi(2)).powi(2) + (damping_ratio * frequency_ratio * 2.0).powi(2))
            .sqrt()
        / frequency_ratio.powi(2)
}

/// Below the critical speed, undamped: the speed at which the whirl reaches the amplitude `R`,
/// `ω = ω_n √(R/(R + e))`, rad/s.
#[inline]
pub fn speed_below_undamped<S: Real>(natural_frequency: S, eccentricity: S, amplitude: S) -> S {
    natural_frequency * (amplitude / (amplitude + eccentricity)).sqrt()
}

/// Above the critical speed, undamped: the speed at which the whirl is back at the amplitude `R`,
/// `ω = ω_n √(R/(R − e))`, rad/s, for `e < R`.
#[inline]
pub fn speed_above_undamped<S: Real>(natural_frequency: S, eccentricity: S, amplitude: S) -> S {
    natural_frequency * (amplitude / (amplitude - eccentricity)).sqrt()
}

/// Below the critical speed: the speed at which the whirl reaches the amplitude `R = e/μ`,
/// `ω = ω_n/√(1 − 2ζ² + √(μ² − 4ζ²(1 − ζ²)))`, rad/s.
#[inline]
pub fn speed_below<S: Real>(natural_frequency: S, share: S, damping_ratio: S) -> S {
    natural_frequency
        / (S::from(1.0) - damping_ratio.powi(2) * 2.0 + speed_width(share, damping_ratio)).sqrt()
}

/// Above the critical speed: the speed at which the whirl is back at the amplitude `R = e/μ`,
/// `ω = ω_n/√(1 − 2ζ² − √(μ² − 4ζ²(1 − ζ²)))`, rad/s, for `μ < 1`.
#[inline]
pub fn speed_above<S: Real>(natural_frequency: S, share: S, damping_ratio: S) -> S {
    natural_frequency
        / (S::from(1.0) - damping_ratio.powi(2) * 2.0 - speed_width(share, damping_ratio)).sqrt()
}

fn speed_width<S: Real>(share: S, damping_ratio: S) -> S {
    (share.powi(2) - damping_ratio.powi(2) * (S::from(1.0) - damping_ratio.powi(2)) * 4.0).sqrt()
}

fn limit_width<S: Real>(mass: S, unbalance: S, clearance: S, damping_ratio: S) -> S {
    ((unbalance / (mass * clearance)).powi(2)
        - damping_ratio.powi(2) * (S::from(1.0) - damping_ratio.powi(2)) * 4.0)
        .sqrt()
}
