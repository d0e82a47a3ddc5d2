//! The heavy symmetric top: a body of revolution that turns about a fixed point of its axis, under its weight.
//!
//! Precession `φ` about the vertical, nutation `θ` from the vertical to the axis, spin `ψ` about the axis. `I_a` is the
//! moment of inertia about the axis, `I_t` about a transverse axis through the fixed point, `K = m g l` the moment of
//! the weight with the axis level. `ω₃ = ψ̇ + φ̇ cos θ` never changes. H. Goldstein, *Classical Mechanics*, 2nd ed.,
//! §5-7; Beer & Johnston, *Vector Mechanics for Engineers: Dynamics*, §18.3.

use crate::Real;

mod nutation;

pub use nutation::{Attitude, Nutation, Top, TopError, Trace};

/// Angular velocity about the axis, `ω₃ = ψ̇ + φ̇ cos θ`.
#[inline]
pub fn axial_velocity<S: Real>(spin: S, precession: S, nutation: S) -> S {
    spin + precession * nutation.cos()
}

/// The discriminant of the quadratic `A φ̇² − H φ̇ + K = 0` of steady precession, `H² − 4 A K`.
#[inline]
pub fn discriminant<S: Real>(momentum: S, square: S, couple: S) -> S {
    momentum.powi(2) - square * couple * 4.0
}

/// The root of `A φ̇² − H φ̇ + K = 0` that stays finite when `A` vanishes, `φ̇ = 2K/(H + √Δ)`: the slow precession.
/// The root takes the sign of `H`: `root` is `√Δ` with that sign.
#[inline]
pub fn slow_precession<S: Real>(couple: S, momentum: S, root: S) -> S {
    couple * 2.0 / (momentum + root)
}

/// The other root of `A φ̇² − H φ̇ + K = 0`, `φ̇ = (H + √Δ)/(2A)`: the fast precession.
#[inline]
pub fn fast_precession<S: Real>(square: S, momentum: S, root: S) -> S {
    (momentum + root) / (square * 2.0)
}

/// Precession of a top that spins fast, to the first order, `φ̇ ≈ K/(I_a ψ̇)`.
#[inline]
pub fn first_order_precession<S: Real>(couple: S, axial: S, spin: S) -> S {
    couple / (axial * spin)
}

/// The spin that keeps a steady precession, `ψ̇ = ((I_t − I_a) φ̇ cos θ + K/φ̇)/I_a`.
#[inline]
pub fn spin_for<S: Real>(axial: S, transverse: S, couple: S, precession: S, nutation: S) -> S {
    ((transverse - axial) * precession * nutation.cos() + couple / precession) / axial
}

/// The least `ω₃` with which an upright top stays upright, `2 √(I_t K)/I_a`.
#[inline]
pub fn sleeping_threshold<S: Real>(axial: S, transverse: S, couple: S) -> S {
    (transverse * couple).sqrt() * 2.0 / axial
}

/// Angular frequency of small nutations about a steady precession,
/// `√(φ̇² sin²θ + (I_a ω₃/I_t − 2 φ̇ cos θ)²)`.
#[inline]
pub fn nutation_frequency<S: Real>(ratio: S, axial_velocity: S, precession: S, nutation: S) -> S {
    ((precession * nutation.sin()).powi(2)
        + (ratio * axial_velocity - precession * nutation.cos() * 2.0).powi(2))
    .sqrt()
}
