//! The slider-crank: crank of length `r` turning about the origin, rod of length `l`, slider on the line `y = e`.
//!
//! Crank and rod make the angles `θ₂` and `θ₃` with the x axis, both counter-clockwise and both drawn from the
//! crank's side of the link: `r cos θ₂ + l cos θ₃ = x`, `r sin θ₂ + l sin θ₃ = e`. In line, `e = 0`. Lengths in m,
//! angles in rad. The formulas of velocity and acceleration hold on either assembly branch, with the `θ₃` of that
//! branch; where the rod stands across the slider's line, `cos θ₃ = 0`, they have no answer.
//!
//! ```
//! use std::f64::consts::FRAC_PI_2;
//!
//! use dalembert_mechanics::slider_crank::{Branch, CrankMotion, SliderCrank, SliderCrankError};
//!
//! // Crank of 0.3 m across the line of the slider, rod of 0.5 m, 10 rad/s: x = √(l² − r²), v = −r ω, the rod does not turn
//! // at that moment, and a = r² ω²/√(l² − r²).
//! let linkage = SliderCrank { crank: 0.3, rod: 0.5, offset: 0.0, branch: Branch::Ahead };
//! let motion = linkage.motion(CrankMotion { angle: FRAC_PI_2, speed: 10.0, acceleration: 0.0 })?;
//! assert!((motion.slider_position - 0.4).abs() < 1e-14);
//! assert!((motion.slider_velocity + 3.0).abs() < 1e-13 && motion.rod_speed.abs() < 1e-13);
//! assert!((motion.slider_acceleration - 22.5).abs() < 1e-12);
//! # Ok::<(), SliderCrankError>(())
//! ```

use crate::Real;

pub mod cycle;
pub mod engine;
pub mod equivalent;
pub mod gas;
pub mod piston;

mod links;
mod motion;

pub use links::{Links, links};
pub use motion::{Branch, CrankMotion, SliderCrank, SliderCrankError, SliderCrankMotion};

/// Angle of the rod, `θ₃ = arcsin((e − r sin θ₂)/l)`, on the branch with the slider ahead of the crank pin. On the
/// other branch it is `π − θ₃`.
#[inline(always)]
pub fn rod_angle<S: Real>(crank: S, rod: S, offset: S, crank_angle: S) -> S {
    ((offset - crank * crank_angle.sin()) / rod).asin()
}

/// Position of the slider, `x = r cos θ₂ + l cos θ₃`, m.
#[inline(always)]
pub fn slider_position<S: Real>(crank: S, rod: S, crank_angle: S, rod_angle: S) -> S {
    crank * crank_angle.cos() + rod * rod_angle.cos()
}

/// Angular velocity of the rod, `ω₃ = −r ω₂ cos θ₂/(l cos θ₃)`, rad/s.
#[inline(always)]
pub fn rod_speed<S: Real>(crank: S, rod: S, crank_angle: S, rod_angle: S, crank_speed: S) -> S {
    -(crank * crank_speed * crank_angle.cos()) / (rod * rod_angle.cos())
}

/// Angular velocity of the rod of an in-line slider-crank from its angles alone, `ω₃ = ω₂ tan θ₃/tan θ₂`, rad/s.
///
/// In line, `r sin θ₂ = −l sin θ₃` fixes the ratio of the lengths. There is no answer at `θ₂ = 0` or `π`.
#[inline(always)]
pub fn rod_speed_in_line<S: Real>(crank_angle: S, rod_angle: S, crank_speed: S) -> S {
    crank_speed * rod_angle.tan() / crank_angle.tan()
}

/// Length of the crank of a slider-crank that gives its slider a velocity `v`:
/// `r = −v cos θ₃/(ω₂ sin(θ₂ − θ₃))`, m.
#[inline(always)]
pub fn crank_from_slider_velocity<S: Real>(
    slider_velocity: S,
    crank_angle: S,
    rod_angle: S,
    crank_speed: S,
) -> S {
    -(slider_velocity * rod_angle.cos()) / (crank_speed * (crank_angle - rod_angle).sin())
}

/// Velocity of the slider, `v = −r ω₂ sin θ₂ − l ω₃ sin θ₃`, m/s.
#[inline(always)]
pub fn slider_velocity<S: Real>(
    crank: S,
    rod: S,
    crank_angle: S,
    rod_angle: S,
    crank_speed: S,
    rod_speed: S,
) -> S {
    -(crank * crank_speed * crank_angle.sin()) - rod * rod_speed * rod_angle.sin()
}

/// Angular acceleration of the rod,
/// `α₃ = (r ω₂² sin θ₂ + l ω₃² sin θ₃ − r α₂ cos θ₂)/(l cos θ₃)`, rad/s².
#[inline(always)]
pub fn rod_acceleration<S: Real>(
    crank: S,
    rod: S,
    crank_angle: S,
    rod_angle: S,
    crank_speed: S,
    rod_speed: S,
    crank_acceleration: S,
) -> S {
    (crank * crank_speed.powi(2) * crank_angle.sin() + rod * rod_speed.powi(2) * rod_angle.sin()
        - crank * crank_acceleration * crank_angle.cos())
        / (rod * rod_angle.cos())
}

/// Acceleration of the slider,
/// `a = −r ω₂² cos θ₂ − r α₂ sin θ₂ − l ω₃² cos θ₃ − l α₃ sin θ₃`, m/s².
#[inline(always)]
#[expect(clippy::too_many_arguments, reason = "the formula has eight quantities")]
pub fn slider_acceleration<S: Real>(
    crank: S,
    rod: S,
    crank_angle: S,
    rod_angle: S,
    crank_speed: S,
    rod_speed: S,
    crank_acceleration: S,
    rod_acceleration: S,
) -> S {
    -(crank * crank_speed.powi(2) * crank_angle.cos())
        - crank * crank_acceleration * crank_angle.sin()
        - rod * rod_speed.powi(2) * rod_angle.cos()
        - rod * rod_acceleration * rod_angle.sin()
}
