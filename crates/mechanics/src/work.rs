//! Virtual work and virtual power with d'Alembert's inertia loads.
//!
//! `Σ Fᵢ·Vᵢ + Σ Tⱼ·ωⱼ + Σ (−m a_G)·V_G + Σ (−I_G α)·ω = 0` for the velocities of any motion that the joints allow
//! (Riul, *Dinâmica das Máquinas*, Unit II, eqs. 1–5). Forces in N, couples in N·m, velocities in m/s and rad/s,
//! powers in W. With virtual displacements in place of velocities the same products are virtual works in J.

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
