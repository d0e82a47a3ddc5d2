//! Two masses in place of a connecting rod.
//!
//! Two masses on a line through the centre of mass `G`, at the distances `a` and `b` on either side of it, move as
//! the rod does when they have its mass, its centre of mass and its moment of inertia:
//! `m_a + m_b = m`, `m_a a = m_b b`, `m_a a² + m_b b² = m k²`, so that `a b = k²`. Where both places are chosen, the
//! moment of inertia is off by `m (k² − a b)`, and a couple makes up for it. Bevan, *The Theory of Machines*, ch. 12.
//! Lengths in m, masses in kg.

use crate::Real;

/// Distance of the second mass from the centre of mass where the first is at `a`, `b = k²/a`.
#[inline]
pub fn conjugate_distance<S: Real>(radius_of_gyration: S, distance: S) -> S {
    radius_of_gyration.powi(2) / distance
}

/// The mass at the distance `a` where the other is at `b`, `m_a = m b/(a + b)`.
#[inline]
pub fn share<S: Real>(mass: S, distance: S, other: S) -> S {
    mass * other / (distance + other)
}

/// Moment of inertia that two masses at `a` and `b` have less than the rod, `ΔI = m (k² − a b)`, kg·m². Negative
/// where they have more, as with masses at the two pins of most rods.
#[inline]
pub fn missing_inertia<S: Real>(mass: S, radius_of_gyration: S, distance: S, other: S) -> S {
    mass * (radius_of_gyration.powi(2) - distance * other)
}

/// The same from the moment of inertia about the centre of mass, `ΔI = I_G − m a b`, kg·m².
#[inline]
pub fn missing_inertia_from<S: Real>(inertia: S, mass: S, distance: S, other: S) -> S {
    inertia - mass * distance * other
}

/// Length of the simple pendulum that swings like the rod about the mass at `a`, `L = (k² + a²)/a`, m.
#[inline]
pub fn pendulum_length<S: Real>(radius_of_gyration: S, distance: S) -> S {
    (radius_of_gyration.powi(2) + distance.powi(2)) / distance
}
