//! The motion of a slider-crank with given lengths.

use std::f64::consts::PI;

use super::{rod_acceleration, rod_angle, rod_speed, slider_acceleration, slider_position, slider_velocity};

/// A slider-crank.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SliderCrank {
    /// Length of the crank, m.
    pub crank: f64,
    /// Length of the rod, m.
    pub rod: f64,
    /// Height of the slider's line above the crank's bearing, m.
    pub offset: f64,
    /// On which side of the crank pin the slider is.
    pub branch: Branch,
}

/// The two ways to assemble a slider-crank.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Branch {
    /// The slider is ahead of the crank pin, `cos θ₃ > 0`.
    Ahead,
    /// The slider is behind the crank pin, `cos θ₃ < 0`.
    Behind,
}

/// Motion of the crank.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CrankMotion {
    /// Angle `θ₂`, rad.
    pub angle: f64,
    /// Angular velocity `ω₂`, rad/s.
    pub speed: f64,
    /// Angular acceleration `α₂`, rad/s².
    pub acceleration: f64,
}

/// Motion of the rod and of the slider.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SliderCrankMotion {
    /// Angle of the rod `θ₃`, rad.
    pub rod_angle: f64,
    /// Angular velocity of the rod `ω₃`, rad/s.
    pub rod_speed: f64,
    /// Angular acceleration of the rod `α₃`, rad/s².
    pub rod_acceleration: f64,
    /// Position of the slider, m.
    pub slider_position: f64,
    /// Velocity of the slider, m/s.
    pub slider_velocity: f64,
    /// Acceleration of the slider, m/s².
    pub slider_acceleration: f64,
}

/// Reason for which there is no motion.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum SliderCrankError {
    /// The rod does not reach from the crank pin to the slider's line.
    #[error("at the crank angle {angle} rad the rod of {rod} m has to bridge {distance} m; make it longer")]
    CannotAssemble {
        /// Crank angle, rad.
        angle: f64,
        /// Length of the rod, m.
        rod: f64,
        /// Distance of the crank pin from the slider's line, m.
        distance: f64,
    },
    /// The rod stands across the slider's line: a limit position, where the velocities are not determined.
    #[error("at the crank angle {angle} rad the rod stands across the line of the slider, a limit position")]
    LimitPosition {
        /// Crank angle, rad.
        angle: f64,
    },
    /// A length is not positive, or a number is not finite.
    #[error("crank and rod must have positive lengths, and every number must be finite")]
    NotAMechanism,
}

impl SliderCrank {
    /// Position, velocity and acceleration of rod and slider.
    ///
    /// # Errors
    /// [`SliderCrankError`].
    pub fn motion(&self, crank: CrankMotion) -> Result<SliderCrankMotion, SliderCrankError> {
        let &Self { crank: r, rod: l, offset, branch } = self;
        let CrankMotion { angle, speed, acceleration } = crank;
        let numbers = [r, l, offset, angle, speed, acceleration];
        if !(numbers.iter().all(|x| x.is_finite()) && r > 0.0 && l > 0.0) {
            return Err(SliderCrankError::NotAMechanism);
        }
        let distance = (offset - r * angle.sin()).abs();
        if distance > l {
            return Err(SliderCrankError::CannotAssemble { angle, rod: l, distance });
        }
        let ahead = rod_angle(r, l, offset, angle);
        // Near the limit position cos θ₃ ≈ √(2(1 − d/l)): below this fewer than three digits of it are right.
        if ahead.cos() < 1e-7 {
            return Err(SliderCrankError::LimitPosition { angle });
        }
        let rod_angle = match branch {
            Branch::Ahead => ahead,
            Branch::Behind => PI - ahead,
        };
        let rod_speed = rod_speed(r, l, angle, rod_angle, speed);
        let rod_acceleration = rod_acceleration(r, l, angle, rod_angle, speed, rod_speed, acceleration);
        let motion = SliderCrankMotion {
            rod_angle,
            rod_speed,
            rod_acceleration,
            slider_position: slider_position(r, l, angle, rod_angle),
            slider_velocity: slider_velocity(r, l, angle, rod_angle, speed, rod_speed),
            slider_acceleration: slider_acceleration(
                r,
                l,
                angle,
                rod_angle,
                speed,
                rod_speed,
                acceleration,
                rod_acceleration,
            ),
        };
        let found = [motion.rod_acceleration, motion.slider_velocity, motion.slider_acceleration];
        if found.iter().all(|x| x.is_finite()) { Ok(motion) } else { Err(SliderCrankError::NotAMechanism) }
    }
}
