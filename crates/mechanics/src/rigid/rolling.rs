//! Discs, hoops and cones that roll on a level plane without slip.
//!
//! The disc: `θ` is the angle of its plane to the floor. The axes 123 have 1 horizontal in the plane of the disc, 2 in
//! that plane upwards from the contact to the centre, and 3 along the axis of the disc; they precess about the vertical
//! with `φ̇` and tilt with `θ̇`, but do not take part in the spin `ψ̇` about 3. The angular velocity of the disc is then
//! `ω₁ = θ̇`, `ω₂ = φ̇ sin θ`, `ω₃ = φ̇ cos θ + ψ̇`. Source of the equations: E. J. Routh, *Advanced Part of a Treatise on
//! the Dynamics of a System of Rigid Bodies*, ch. V; P. Appell, *Traité de mécanique rationnelle*, vol. 2.

mod motion;

pub use self::motion::{Ended, Limits, Moment, Rolled, Rolling, RollingError, roll};
use crate::Real;

/// `φ̇²` of a disc that rolls steadily, with its centre on a circle of radius `a`:
/// `m g r cos θ/(sin θ ((I_a + m r²) a/r + I_t cos θ))`.
#[inline]
pub fn steady_precession_squared<S: Real>(
    mass: S,
    radius: S,
    [axial, transverse]: [S; 2],
    gravity: S,
    inclination: S,
    centre_radius: S,
) -> S {
    let (sin, cos) = (inclination.sin(), inclination.cos());
    mass * gravity * radius * cos
        / (sin * ((axial + mass * radius.powi(2)) * (centre_radius / radius) + transverse * cos))
}

/// Radius of the circle of the centre of a disc that rolls steadily with a precession `φ̇` at an angle:
/// `a = r cos θ (m g r/(φ̇² sin θ) − I_t)/(I_a + m r²)`; negative where the centre is on the far side of the axis.
#[inline]
pub fn steady_centre_radius<S: Real>(
    mass: S,
    radius: S,
    [axial, transverse]: [S; 2],
    gravity: S,
    inclination: S,
    precession: S,
) -> S {
    let (sin, cos) = (inclination.sin(), inclination.cos());
    radius * cos * (mass * gravity * radius / (precession.powi(2) * sin) - transverse)
        / (axial + mass * radius.powi(2))
}

/// Derivatives of `ω₂` and `ω₃` with respect to the tilt of a rolling disc: `dω₂/dθ = (I_a/I_t) ω₃ − ω₂ cot θ` and
/// `dω₃/dθ = m r² ω₂/(I_a + m r²)`.
#[inline]
pub fn tilting_slopes<S: Real>(
    mass: S,
    radius: S,
    [axial, transverse]: [S; 2],
    inclination: S,
    [second, third]: [S; 2],
) -> [S; 2] {
    [
        axial / transverse * third - second * inclination.cos() / inclination.sin(),
        mass * radius.powi(2) * second / (axial + mass * radius.powi(2)),
    ]
}

/// `K` of the small oscillations `ε̈ + K ε = 0` of the inclination about a steady motion with `ω₂` and `ω₃` and their
/// [`tilting_slopes`]: stable when positive.
#[inline]
pub fn tilting_stiffness<S: Real>(
    mass: S,
    radius: S,
    [axial, transverse]: [S; 2],
    gravity: S,
    inclination: S,
    [second, third]: [S; 2],
    [second_slope, third_slope]: [S; 2],
) -> S {
    let (sin, cos) = (inclination.sin(), inclination.cos());
    ((axial + mass * radius.powi(2)) * (second_slope * third + second * third_slope)
        - transverse * second * second_slope * cos / sin * 2.0
        + transverse * second.powi(2) / sin.powi(2)
        - mass * gravity * radius * sin)
        / (transverse + mass * radius.powi(2))
}

/// Least speed at which an upright disc of the moments of inertia `[I_a, I_t]` rolls on straight:
/// `v² = m g r³ I_t/(I_a (I_a + m r²))`.
#[inline]
pub fn least_rolling_speed<S: Real>(mass: S, radius: S, [axial, transverse]: [S; 2], gravity: S) -> S {
    radius * (mass * gravity * radius * transverse / (axial * (axial + mass * radius.powi(2)))).sqrt()
}

/// Least spin about its vertical diameter with which an upright disc stays on the spot: `Ω² = m g r/(I_t + m r²)`.
#[inline]
pub fn least_upright_spin<S: Real>(mass: S, radius: S, transverse: S, gravity: S) -> S {
    (mass * gravity * radius / (transverse + mass * radius.powi(2))).sqrt()
}

/// Angular velocity of a cone of half-angle `α` that rolls about its apex with a precession: `ω = φ̇ cot α`, along the line
/// of contact. L. D. Landau, E. M. Lifshitz, *Mechanics*, 3rd ed., §32, problem 7.
#[inline]
pub fn cone_angular_velocity<S: Real>(precession: S, half_angle: S) -> S {
    precession * half_angle.cos() / half_angle.sin()
}

/// Kinetic energy of a uniform cone that rolls so: `3 m h² φ̇² (1 + 5 cos² α)/40`. Landau & Lifshitz, the same place.
#[inline]
pub fn cone_energy<S: Real>(mass: S, height: S, precession: S, half_angle: S) -> S {
    mass * height.powi(2) * precession.powi(2) * 3.0 * (half_angle.cos().powi(2) * 5.0 + 1.0) / 40.0
}
