//! A body on which no moment acts: its angular momentum stays, and it turns about its centre of mass for ever.
//!
//! For a body of revolution everything follows from the ratio `r = I_a/I_t` of its moments of inertia, axial over
//! transverse, and the angular velocities `ω_a` along the axis and `ω_t` across it: axis and angular velocity keep their
//! angles to `H_G`, and the body cone rolls on the space cone. Beer & Johnston, *Vector Mechanics for Engineers:
//! Dynamics*, §18.3. Three different moments: [`FreeBody`].

use nalgebra::{Rotation3, Unit, Vector3};

use crate::Real;

mod triaxial;

pub use triaxial::{FreeBody, FreeBodyError, Polhode};

/// Angle between the axis and `H_G`, `tan θ = ω_t/(r ω_a)`.
#[inline]
pub fn nutation<S: Real>(ratio: S, axial: S, transverse: S) -> S {
    transverse.atan2(ratio * axial)
}

/// Angle between the axis and the angular velocity, `tan β = ω_t/ω_a`.
#[inline]
pub fn velocity_angle<S: Real>(axial: S, transverse: S) -> S {
    transverse.atan2(axial)
}

/// Precession about `H_G`, `φ̇ = H_G/I_t = √((r ω_a)² + ω_t²)`.
#[inline]
pub fn precession<S: Real>(ratio: S, axial: S, transverse: S) -> S {
    ((ratio * axial).powi(2) + transverse.powi(2)).sqrt()
}

/// Spin about the axis, `ψ̇ = (1 − r) ω_a`.
#[inline]
pub fn spin<S: Real>(ratio: S, axial: S) -> S {
    (S::from(1.0) - ratio) * axial
}

/// Angular velocity of a free body of revolution about its z axis, in axes fixed in it, from that at the start.
pub fn axisymmetric_velocity(ratio: f64, start: Vector3<f64>, time: f64) -> Vector3<f64> {
    Rotation3::from_axis_angle(&Vector3::z_axis(), (ratio - 1.0) * start.z * time) * start
}

/// Rotation of a free body of revolution since the start, from body axes to fixed axes that agreed with them: a
/// rotation by `φ̇ t` about `H_G` after one by `ψ̇ t` about the axis.
pub fn axisymmetric_attitude(ratio: f64, start: Vector3<f64>, time: f64) -> Rotation3<f64> {
    // H_G/I_t: its size is the precession.
    let momentum = Vector3::new(start.x, start.y, ratio * start.z);
    let spin = Rotation3::from_axis_angle(&Vector3::z_axis(), (1.0 - ratio) * start.z * time);
    match Unit::try_new(momentum, 0.0) {
        Some(along) => Rotation3::from_axis_angle(&along, momentum.norm() * time) * spin,
        None => spin,
    }
}
