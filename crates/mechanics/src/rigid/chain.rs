//! A chain of joints with prescribed motion: each turns about an axis of the frame before it. Orientation, angular
//! velocity and acceleration of every frame, velocity and acceleration of every point.
//!
//! Beer & Johnston, *Vector Mechanics for Engineers: Dynamics*, ch. 15 (motion about a fixed point, general motion);
//! Meriam & Kraige, *Dynamics*, §7/4–7/6.

use nalgebra::{Rotation3, Unit, Vector3};

use super::{RigidError, acceleration_of_point, velocity_of_point};
use crate::{Real, Vector};

/// A vector turned by `angle` about the unit vector `axis` (Rodrigues):
/// `v cos θ + (e × v) sin θ + e (e · v)(1 − cos θ)`.
///
/// The same with `−θ` gives the components in axes that have turned by `θ`.
#[inline]
pub fn turned_about<V: Vector>(axis: V, angle: V::Scalar, vector: V) -> V {
    let (sin, cos) = (angle.sin(), angle.cos());
    vector * cos + axis.cross(vector) * sin + axis * (axis.dot(vector) * (-cos + 1.0))
}

/// Angular acceleration of a frame that turns about `axis` (a unit vector of the frame before it) at `rate`, with
/// that frame turning at `omega`: `α = α_before + θ̈ e + Ω × θ̇ e`.
#[inline]
pub fn next_acceleration<V: Vector>(
    alpha_before: V,
    omega_before: V,
    axis: V,
    rate: V::Scalar,
    acceleration: V::Scalar,
) -> V {
    alpha_before + axis * acceleration + omega_before.cross(axis * rate)
}

/// A joint of the chain: a turn about an axis of the frame before it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ChainJoint {
    /// A vector of any length along the axis, in the frame before it (and, alike, in the frame after it).
    pub axis: Vector3<f64>,
    /// Angle θ from the frame before to the one after, rad.
    pub angle: f64,
    /// θ̇, rad/s.
    pub rate: f64,
    /// θ̈, rad/s².
    pub acceleration: f64,
    /// Origin of the frame after it, in the frame before it, m.
    pub offset: Vector3<f64>,
}

/// A frame of the chain at one moment; all vectors have their components in the fixed axes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ChainFrame {
    /// Takes components in this frame to components in the fixed axes.
    pub rotation: Rotation3<f64>,
    /// Angular velocity ω, rad/s.
    pub angular_velocity: Vector3<f64>,
    /// Angular acceleration α, rad/s².
    pub angular_acceleration: Vector3<f64>,
    /// Place of the origin, m.
    pub origin: Vector3<f64>,
    /// Velocity of the origin, m/s.
    pub velocity: Vector3<f64>,
    /// Acceleration of the origin, m/s².
    pub acceleration: Vector3<f64>,
}

/// A point carried by a frame, in the fixed axes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PointMotion {
    /// Place, m.
    pub place: Vector3<f64>,
    /// Velocity, m/s.
    pub velocity: Vector3<f64>,
    /// Acceleration, m/s².
    pub acceleration: Vector3<f64>,
}

impl ChainJoint {
    /// The joint a time `t` (s) later, or earlier, with its acceleration kept.
    #[must_use]
    pub fn after(mut self, t: f64) -> Self {
        self.angle += (self.rate + self.acceleration * t / 2.0) * t;
        self.rate += self.acceleration * t;
        self
    }
}

impl ChainFrame {
    /// The fixed frame.
    pub fn fixed() -> Self {
        let zero = Vector3::zeros();
        Self {
            rotation: Rotation3::identity(),
            angular_velocity: zero,
            angular_acceleration: zero,
            origin: zero,
            velocity: zero,
            acceleration: zero,
        }
    }

    /// The frame after `joint`.
    ///
    /// # Errors
    /// [`RigidError::Direction`] for an axis without length, [`RigidError::NotFinite`].
    pub fn next(&self, joint: &ChainJoint) -> Result<ChainFrame, RigidError> {
        let local = super::tensor::unit(joint.axis)?;
        let axis = self.rotation * local;
        let origin = self.point(joint.offset);
        let frame = ChainFrame {
            rotation: self.rotation * Rotation3::from_axis_angle(&Unit::new_unchecked(local), joint.angle),
            angular_velocity: self.angular_velocity + axis * joint.rate,
            angular_acceleration: next_acceleration(
                self.angular_acceleration,
                self.angular_velocity,
                axis,
                joint.rate,
                joint.acceleration,
            ),
            origin: origin.place,
            velocity: origin.velocity,
            acceleration: origin.acceleration,
        };
        let vectors = [frame.angular_acceleration, frame.origin, frame.velocity, frame.acceleration];
        let finite = vectors.iter().flatten().chain(frame.rotation.matrix().iter()).all(|x| x.is_finite());
        if finite { Ok(frame) } else { Err(RigidError::NotFinite) }
    }

    /// The motion of the point `at` (m, in the axes of this frame) that the frame carries.
    pub fn point(&self, at: Vector3<f64>) -> PointMotion {
        let arm = self.rotation * at;
        PointMotion {
            place: self.origin + arm,
            velocity: velocity_of_point(self.velocity, self.angular_velocity, arm),
            acceleration: acceleration_of_point(
                self.acceleration,
                self.angular_velocity,
                self.angular_acceleration,
                arm,
            ),
        }
    }
}

/// All frames of the chain: the fixed one first, then the one after each joint.
///
/// # Errors
/// [`RigidError::Direction`] for an axis without length, [`RigidError::NotFinite`].
pub fn frames(joints: &[ChainJoint]) -> Result<Vec<ChainFrame>, RigidError> {
    let mut all = vec![ChainFrame::fixed()];
    for joint in joints {
        let next = all[all.len() - 1].next(joint)?;
        all.push(next);
    }
    Ok(all)
}

/// A time in s over which the orientation of a chain changes noticeably, for
/// [`numerical_rate`](super::numerical_rate): a turn at the sum of all rates, or with the accelerations from rest.
pub fn period(joints: &[ChainJoint]) -> f64 {
    let rate: f64 = joints.iter().map(|joint| joint.rate.abs()).sum();
    let acceleration: f64 = joints.iter().map(|joint| joint.acceleration.abs()).sum();
    let turn = std::f64::consts::TAU;
    let period = (turn / rate).min((turn / acceleration).sqrt());
    if period.is_finite() { period } else { 1.0 }
}
