//! Virtual work and virtual power with d'Alembert's inertia loads.
//!
//! `Σ Fᵢ·Vᵢ + Σ Tⱼ·ωⱼ + Σ (−m a_G)·V_G + Σ (−I_G α)·ω = 0` for the velocities of any motion that the joints allow
//! (Riul, *Dinâmica das Máquinas*, Unit II, eqs. 1–5). Forces in N, couples in N·m, velocities in m/s and rad/s,
//! powers in W. With virtual displacements in place of velocities the same products are virtual works in J.
//!
//! ```
//! use dalembert_mechanics::work::{couple_power, force_power, inertia_couple, inertia_force, unknown_load, weight};
//! use nalgebra::Vector3;
//!
//! // The couple that starts a horizontal bar of 3 kg and 1 m about its end with 2 rad/s²: m g L/2 + (m L²/3) α.
//! let (velocity, turning) = (Vector3::new(0.0, 0.5, 0.0), Vector3::new(0.0, 0.0, 1.0));
//! let powers = [
//!     force_power(weight(3.0, Vector3::new(0.0, -9.81, 0.0)), velocity),
//!     force_power(inertia_force(3.0, Vector3::new(0.0, 0.5 * 2.0, 0.0)), velocity),
//!     couple_power(inertia_couple(3.0 / 12.0, Vector3::new(0.0, 0.0, 2.0)), turning),
//! ];
//! let couple = unknown_load(powers, 1.0);
//! assert!((couple - (3.0 * 9.81 * 0.5 + 3.0 / 3.0 * 2.0)).abs() < 1e-12);
//! ```

use crate::{Real, Vector};

/// Power of a force, `P = F · V`, W, with the velocity of the point it acts on.
#[inline(always)]
pub fn force_power<V: Vector>(force: V, velocity: V) -> V::Scalar {
    force.dot(velocity)
}

/// Power of a couple, `P = T · ω`, W, with the angular velocity of the body it acts on.
#[inline(always)]
pub fn couple_power<V: Vector>(couple: V, angular_velocity: V) -> V::Scalar {
    couple.dot(angular_velocity)
}

/// Weight of a mass, `W = m g`, N, with the acceleration of gravity as a vector.
#[inline(always)]
pub fn weight<V: Vector>(mass: V::Scalar, gravity: V) -> V {
    gravity * mass
}

/// D'Alembert's inertia force, `F_in = −m a_G`, N, through the centre of mass.
#[inline(always)]
pub fn inertia_force<V: Vector>(mass: V::Scalar, acceleration: V) -> V {
    -(acceleration * mass)
}

/// D'Alembert's inertia couple of plane motion, `T_in = −I_G α`, N·m, with the moment of inertia in kg·m² about
/// the axis through the centre of mass normal to the plane. In space it is `−dH_G/dt`; see [`crate::rigid`].
#[inline(always)]
pub fn inertia_couple<V: Vector>(inertia: V::Scalar, angular_acceleration: V) -> V {
    -(angular_acceleration * inertia)
}

/// The one unknown force or couple that makes the powers sum to zero, `T = −Σ Pᵢ/ω`, with the velocity `ω` along
/// its own line, rad/s for a couple in N·m, m/s for a force in N. There is no answer at `ω = 0`.
#[inline(always)]
pub fn unknown_load<S: Real>(powers: impl IntoIterator<Item = S>, rate: S) -> S {
    -S::sum(powers) / rate
}
