//! Rigid bodies in space: moments of inertia, angular momentum about the centre of mass G and its rate of change.
//!
//! Inertias in kg·m², angular velocities in rad/s, angular momenta in kg·m²/s, moments in N·m. Axes are principal
//! axes of the body at G unless said otherwise. Equation numbers: Riul, *Dinâmica das Máquinas*, Unit II; the same
//! formulas: Beer & Johnston, *Vector Mechanics for Engineers: Dynamics*, ch. 18.
//!
//! ```
//! use dalembert_mechanics::rigid::{angular_momentum, disc_axial_inertia, disc_diametral_inertia, transport_rate};
//! use nalgebra::Vector3;
//!
//! // A disc of 4 kg and 0.2 m spins at 300 rad/s about k while its shaft turns at 2 rad/s about j:
//! // the gyroscopic moment is I ω Ω = 0.08 · 300 · 2 = 48 N·m about i.
//! let (axial, diametral) = (disc_axial_inertia(4.0, 0.2), disc_diametral_inertia(4.0, 0.2));
//! let turning = Vector3::new(0.0, 2.0, 0.0);
//! let momentum = angular_momentum([diametral, diametral, axial], turning + Vector3::new(0.0, 0.0, 300.0));
//! let moment = transport_rate(turning, momentum);
//! assert!((moment - Vector3::new(48.0, 0.0, 0.0)).norm() < 1e-12);
//! ```

use crate::{Real, Vector};

pub mod chain;
pub mod gyroscope;
mod mass_properties;
pub mod primitive;
pub mod rolling;
pub mod simulate;
pub mod supports;
mod tensor;
pub mod top;
pub mod torque_free;

pub use mass_properties::{BodyError, MassProperties, Principal};
pub use tensor::{RigidError, disc_tensor, numerical_rate, rod_tensor, turned};

/// Slender rod about an axis through its middle, normal to it: `I = m L²/12`.
#[inline]
pub fn rod_inertia<S: Real>(mass: S, length: S) -> S {
    mass * length.powi(2) / 12.0
}

/// Slender rod of length `2b` about an axis through its middle, normal to it: `I = m b²/3`.
#[inline]
pub fn rod_inertia_half_length<S: Real>(mass: S, half_length: S) -> S {
    mass * half_length.powi(2) / 3.0
}

/// Thin disc about its axis: `I = m r²/2`.
#[inline]
pub fn disc_axial_inertia<S: Real>(mass: S, radius: S) -> S {
    mass * radius.powi(2) / 2.0
}

/// Thin disc about a diameter: `I = m r²/4`.
#[inline]
pub fn disc_diametral_inertia<S: Real>(mass: S, radius: S) -> S {
    mass * radius.powi(2) / 4.0
}

/// Solid cylinder about an axis through G normal to its own: `I = m (3r² + h²)/12`.
#[inline]
pub fn cylinder_diametral_inertia<S: Real>(mass: S, radius: S, height: S) -> S {
    mass * (radius.powi(2) * 3.0 + height.powi(2)) / 12.0
}

/// Parallel axes: `I = I_G + m d²`, `d` the distance of the axis from the one through G.
#[inline]
pub fn parallel_axis<S: Real>(inertia_about_g: S, mass: S, distance: S) -> S {
    inertia_about_g + mass * distance.powi(2)
}

/// Moment of inertia of a mass with a radius of gyration, `I = m k²`.
#[inline]
pub fn moment_by_gyration<S: Real>(mass: S, radius: S) -> S {
    mass * radius.powi(2)
}

/// Angular momentum about G, `H_G = I_x ω_x i + I_y ω_y j + I_z ω_z k`, from the principal moments of inertia
/// `[I_x, I_y, I_z]` and the angular velocity of the body in the same axes. Eqs. 45–46.
#[inline]
pub fn angular_momentum<V: Vector>(inertia: [V::Scalar; 3], angular_velocity: V) -> V {
    let [inertia_x, inertia_y, inertia_z] = inertia;
    let [omega_x, omega_y, omega_z] = angular_velocity.components();
    V::from_components(inertia_x * omega_x, inertia_y * omega_y, inertia_z * omega_z)
}

/// Rate of change seen in the rotating axes, `(dH_G/dt)_rel = I_x ω̇_x i + I_y ω̇_y j + I_z ω̇_z k`, from the rates
/// of the *components* of the angular velocity in those axes. Eq. 47.
#[inline]
pub fn relative_rate<V: Vector>(inertia: [V::Scalar; 3], component_rates: V) -> V {
    angular_momentum(inertia, component_rates)
}

/// Rate of change owed to the turning of the axes, `Ω × H_G`, with the angular velocity `Ω` of the axes (for a
/// body of revolution it need not be that of the body).
#[inline]
pub fn transport_rate<V: Vector>(axes_angular_velocity: V, angular_momentum: V) -> V {
    axes_angular_velocity.cross(angular_momentum)
}

/// Rate of change in fixed axes, `dH_G/dt = (dH_G/dt)_rel + Ω × H_G`: the moment of the external forces about G.
/// Eqs. 23, 42–44.
#[inline]
pub fn rate_of_change<V: Vector>(relative_rate: V, axes_angular_velocity: V, angular_momentum: V) -> V {
    relative_rate + axes_angular_velocity.cross(angular_momentum)
}

/// Euler's equations, `M_x = I_x ω̇_x − (I_y − I_z) ω_y ω_z` and cyclically, in principal axes fixed in the body.
#[inline]
pub fn euler_moment<V: Vector>(inertia: [V::Scalar; 3], angular_velocity: V, component_rates: V) -> V {
    let [inertia_x, inertia_y, inertia_z] = inertia;
    let [omega_x, omega_y, omega_z] = angular_velocity.components();
    let [rate_x, rate_y, rate_z] = component_rates.components();
    V::from_components(
        inertia_x * rate_x - (inertia_y - inertia_z) * omega_y * omega_z,
        inertia_y * rate_y - (inertia_z - inertia_x) * omega_z * omega_x,
        inertia_z * rate_z - (inertia_x - inertia_y) * omega_x * omega_y,
    )
}

/// Kinetic energy of rotation, `T = ω · H_G/2`, J.
#[inline]
pub fn rotational_energy<V: Vector>(angular_velocity: V, angular_momentum: V) -> V::Scalar {
    angular_velocity.dot(angular_momentum) / 2.0
}

/// Velocity of a point of a body, `V_B = V_A + ω × r`, with `r` from A to B.
#[inline]
pub fn velocity_of_point<V: Vector>(velocity: V, angular_velocity: V, arm: V) -> V {
    velocity + angular_velocity.cross(arm)
}

/// Acceleration of a point of a body, `a_B = a_A + α × r + ω × (ω × r)`, with `r` from A to B.
#[inline]
pub fn acceleration_of_point<V: Vector>(
    acceleration: V,
    angular_velocity: V,
    angular_acceleration: V,
    arm: V,
) -> V {
    acceleration + angular_acceleration.cross(arm) + angular_velocity.cross(angular_velocity.cross(arm))
}

/// Moment of a force about a point, `M = r × F`, with `r` from the point to the force.
#[inline]
pub fn moment_of_force<V: Vector>(arm: V, force: V) -> V {
    arm.cross(force)
}

/// One of the three coordinate axes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Axis {
    /// Along `i`.
    X,
    /// Along `j`.
    Y,
    /// Along `k`.
    Z,
}

/// Components in fixed axes of a vector given in axes that have turned by `angle` about the common `axis`.
///
/// About z: `(x cos θ − y sin θ) i + (x sin θ + y cos θ) j + z k`, and cyclically.
#[inline]
pub fn to_fixed_axes<V: Vector>(axis: Axis, angle: V::Scalar, vector: V) -> V {
    let [x, y, z] = vector.components();
    let (sin, cos) = (angle.sin(), angle.cos());
    match axis {
        Axis::X => V::from_components(x, y * cos - z * sin, y * sin + z * cos),
        Axis::Y => V::from_components(z * sin + x * cos, y, z * cos - x * sin),
        Axis::Z => V::from_components(x * cos - y * sin, x * sin + y * cos, z),
    }
}

/// Components in axes that have turned by `angle` about the common `axis` of a vector given in fixed axes; the
/// inverse of [`to_fixed_axes`].
#[inline]
pub fn to_rotating_axes<V: Vector>(axis: Axis, angle: V::Scalar, vector: V) -> V {
    let [x, y, z] = vector.components();
    let (sin, cos) = (angle.sin(), angle.cos());
    match axis {
        Axis::X => V::from_components(x, y * cos + z * sin, z * cos - y * sin),
        Axis::Y => V::from_components(x * cos - z * sin, y, x * sin + z * cos),
        Axis::Z => V::from_components(x * cos + y * sin, y * cos - x * sin, z),
    }
}
