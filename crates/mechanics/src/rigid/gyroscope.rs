//! Gyroscopic couples: what the bearings must do to a rotor whose carrier turns, and what the carrier feels.
//!
//! The carrier turns with the constant angular velocity Ω (the precession), the rotor spins at the rate `ω` relative
//! to it. Angular momenta in kg·m²/s, couples in N·m. The carrier feels the opposite of every couple given here.

use nalgebra::{Matrix3, Rotation3, Vector3};

use crate::{Real, Vector};

/// Angular momentum of a symmetric rotor about its centre of mass, `H = I_t Ω + (I_a ω + (I_a − I_t) (u · Ω)) u`, with
/// the unit vector `u` along the axle.
///
/// Beer & Johnston, *Dynamics*, §18.3.
#[inline]
pub fn momentum<V: Vector>(
    axial: V::Scalar,
    transverse: V::Scalar,
    spin: V::Scalar,
    axle: V,
    precession: V,
) -> V {
    precession * transverse + axle * (axial * spin + (axial - transverse) * axle.dot(precession))
}

/// Couple on a symmetric rotor in steady precession, `M = Ω × H = (I_a ω + (I_a − I_t) (u · Ω)) Ω × u`: of size
/// `I_a ω Ω sin θ + (I_a − I_t) Ω² sin θ cos θ`, with the angle θ between Ω and `u`.
#[inline]
pub fn couple<V: Vector>(
    axial: V::Scalar,
    transverse: V::Scalar,
    spin: V::Scalar,
    axle: V,
    precession: V,
) -> V {
    precession.cross(axle) * (axial * spin + (axial - transverse) * axle.dot(precession))
}

/// Gyroscopic couple of a symmetric rotor whose axle is normal to the axis of precession: `C = I_a ω Ω`.
#[inline]
pub fn right_angled_couple<S: Real>(axial: S, spin: S, precession: S) -> S {
    axial * spin * precession
}

/// Rate of the precession, normal to the axle, that a couple normal to both keeps up: `Ω = C/(I_a ω)`.
#[inline]
pub fn precession_rate<S: Real>(couple: S, axial: S, spin: S) -> S {
    couple / (axial * spin)
}

/// Force of the bearing ahead of G, on the side that the unit vector `e` along the axle points to:
/// `F_B = (M × e + a P)/(a + b)`. `P` is all that the bearings must exert normal to the axle, `M` their couple about
/// G, `a` and `b` the distances from G of the bearings behind and ahead. The other one exerts `P − F_B`.
#[inline]
pub fn bearing_ahead<V: Vector>(force: V, couple: V, axle: V, behind: V::Scalar, ahead: V::Scalar) -> V {
    (couple.cross(axle) + force * behind) / (behind + ahead)
}

/// Couple on a two-bladed rotor about the normal to spin and precession (towards `u × Ω`):
/// `−ω Ω (I_a + D cos 2x)`.
///
/// `x` is the angle of the blades from the axis of precession, which is normal to that of the spin. `I_a` is the moment
/// of inertia about the axis of spin, `D = I_c − I_b` that across the blades less that along them.
/// T. Bevan, *The Theory of Machines*, ch. 2, has the case `D = I_a`.
#[inline]
pub fn blades_couple_normal<S: Real>(axial: S, difference: S, spin: S, precession: S, angle: S) -> S {
    -(spin * precession * (axial + difference * (angle * 2.0).cos()))
}

/// Couple on a two-bladed rotor about the axis of precession, `ω Ω D sin 2x`; see [`blades_couple_normal`].
#[inline]
pub fn blades_couple_precession<S: Real>(difference: S, spin: S, precession: S, angle: S) -> S {
    spin * precession * difference * (angle * 2.0).sin()
}

/// Couple on a two-bladed rotor about its own axis, which keeps its spin constant, `−D Ω² sin 2x / 2`; see
/// [`blades_couple_normal`].
#[inline]
pub fn blades_couple_spin<S: Real>(difference: S, precession: S, angle: S) -> S {
    -(difference * precession.powi(2) * (angle * 2.0).sin() / 2.0)
}

/// Inertia tensor of a symmetric rotor about its centre of mass, `I_t 1 + (I_a − I_t) u uᵀ`, with a unit vector `u`.
pub fn symmetric_tensor(axial: f64, transverse: f64, axle: Vector3<f64>) -> Matrix3<f64> {
    Matrix3::identity() * transverse + axle * axle.transpose() * (axial - transverse)
}

/// Angular momentum at time `t` of a rotor in fixed axes, from its whole tensor turned with it: `R I Rᵀ (Ω + ω R u)`.
/// The carrier turns with the constant `precession`, the rotor about its axle `u` at the rate `spin` relative to it;
/// `tensor` and `axle` are those at time zero.
pub fn momentum_at(
    tensor: &Matrix3<f64>,
    spin: f64,
    axle: Vector3<f64>,
    precession: Vector3<f64>,
    t: f64,
) -> Vector3<f64> {
    let carrier = Rotation3::from_scaled_axis(precession * t);
    let rotor = carrier * Rotation3::from_scaled_axis(axle * (spin * t));
    super::turned(tensor, &rotor) * (precession + carrier * axle * spin)
}
