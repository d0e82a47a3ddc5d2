//! A rotor with an unbalance on a flexible shaft, and the shafts that keep it clear of its stator.
//!
//! Rotor mass `m` in kg at the stiffness `k` in N/m, unbalance `m e` in kg·m, clearance `R` in m, speeds `ω` in
//! rad/s, damping `c` in N·s/m or as the ratio `ζ`. The whirl of the undamped or viscously damped Jeffcott rotor
//! has the amplitude of [`crate::sdof::unbalance_amplitude`] (Rao, *Mechanical Vibrations*, 5th ed., §9.5).

use crate::Real;

mod permitted;

pub use permitted::{
    Limit, LimitedBy, PermittedStiffness, WhirlError, permitted_stiffness, permitted_stiffness_at_damping,
    worst_speed,
};

/// Whirl amplitude `A = e r²/√((1 − r²)² + (2ζr)²)`, m, of a rotor whose mass centre is `e` off the shaft, at
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

fn limit_width<S: Real>(mass: S, unbalance: S, clearance: S, damping_ratio: S) -> S {
    ((unbalance / (mass * clearance)).powi(2)
        - damping_ratio.powi(2) * (S::from(1.0) - damping_ratio.powi(2)) * 4.0)
        .sqrt()
}
