//! Balancing of rigid rotors, and of engines in [`reciprocating`].
//!
//! An unbalance is `U = m r` at an angle `θ` in a plane at the position `z` along the shaft; its components are
//! `m r cos θ` and `m r sin θ`, kg·m. Components along x and y obey the same equations, one direction at a time.
//! Weights in place of masses (N·m) change nothing: gravity cancels. Positions count from any origin.
//! Equation numbers: Riul, *Dinâmica das Máquinas*, Unit II.
//!
//! ```
//! use std::f64::consts::{FRAC_PI_2, PI};
//!
//! use dalembert_mechanics::balance::{
//!     component_x, component_y, correction_mass, marked_direction, single_plane_correction,
//! };
//!
//! // A disc with 2 kg at 0.15 m and 0°, and 1 kg at 0.4 m and 90°: unbalances of 0.3 and 0.4 kg·m, together 0.5 kg·m.
//! let masses = [(2.0, 0.15, 0.0), (1.0, 0.4, FRAC_PI_2)];
//! let x = single_plane_correction(masses.map(|(mass, radius, angle)| component_x(mass, radius, angle)));
//! let y = single_plane_correction(masses.map(|(mass, radius, angle)| component_y(mass, radius, angle)));
//! // The correction at 0.25 m: 2 kg, opposite to the resultant.
//! assert!((correction_mass(x, y, 0.25) - 2.0).abs() < 1e-14);
//! assert!((marked_direction(x, y) - (PI + 4_f64.atan2(3.0))).abs() < 1e-14);
//! ```

use std::f64::consts::TAU;

use crate::Real;

pub mod influence;
pub mod linkage;
pub mod locomotive;
pub mod minimax;
mod phasor;
mod planes;
pub mod reciprocating;
pub mod spread;
mod two_plane;
mod unknowns;
pub mod without_phase;

pub use phasor::{Phasor, two_plane_weights};
pub use planes::{
    UnbalanceKind, balance_planes, equivalent_in_first, equivalent_in_second, kind, least_correction,
};
pub use two_plane::{BalanceError, PlaneUnbalance, TwoPlaneBalance, balance_two_planes};
pub use unknowns::{PartlyKnown, RotorMass, UnknownsError, Vanishing, balance_unknowns};

/// Component of an unbalance along x, `m r cos θ`, kg·m.
#[inline(always)]
pub fn component_x<S: Real>(mass: S, radius: S, angle: S) -> S {
    mass * radius * angle.cos()
}

/// Component of an unbalance along y, `m r sin θ`, kg·m.
#[inline(always)]
pub fn component_y<S: Real>(mass: S, radius: S, angle: S) -> S {
    mass * radius * angle.sin()
}

/// Magnitude from components, `U = √(U_x² + U_y²)`. Eqs. 11, 16.
#[inline(always)]
pub fn magnitude<S: Real>(x: S, y: S) -> S {
    (x.powi(2) + y.powi(2)).sqrt()
}

/// Direction from components, `θ = atan2(U_y, U_x)`, rad in `(−π, π]`. Eqs. 11, 19.
#[inline(always)]
pub fn direction<S: Real>(x: S, y: S) -> S {
    y.atan2(x)
}

/// Direction from components as it is marked on a rotor, rad in `[0, 2π)`. A component that is rounding beside the
/// other counts as none: what lies on the axis neither jumps by a turn nor to just below one.
#[inline(always)]
pub fn marked_direction<S: Real>(x: S, y: S) -> S {
    if y.holds_with(x, |y, x| y.abs() <= 1e-14 * x.abs()) {
        direction(x, S::from(0.0))
    } else if y.holds(|y| y < 0.0) {
        direction(x, y) + TAU
    } else {
        direction(x, y)
    }
}

/// An angle as it is marked on a rotor: whole turns taken away, rad in `[0, 2π)`.
#[inline(always)]
pub fn marked_angle<S: Real>(angle: S) -> S {
    let turns = (angle.value() / TAU).floor();
    if turns == 0.0 { angle } else { angle - TAU * turns }
}

/// The same of an angle that a numerical method found: what lies within rounding of the mark lies on it.
pub fn marked_angle_found(angle: f64) -> f64 {
    let angle = marked_angle(angle);
    if angle < 1e-12 || TAU - angle < 1e-12 { 0.0 } else { angle }
}

/// Mass of a correction from its components and the radius where it is put, `m = √(U_x² + U_y²)/r`, kg.
/// Eqs. 11, 17, 21.
#[inline(always)]
pub fn correction_mass<S: Real>(x: S, y: S, radius: S) -> S {
    magnitude(x, y) / radius
}

/// Static balancing in one plane, one component: `U_e = −Σ Uᵢ`. Eqs. 9–11.
#[inline(always)]
pub fn single_plane_correction<S: Real>(components: impl IntoIterator<Item = S>) -> S {
    -S::sum(components)
}

/// Two planes, moments about plane A, one component of the correction in plane B:
/// `U_B = −Σ Uᵢ(zᵢ − z_A)/(z_B − z_A)`. Eqs. 13–15.
///
/// Takes pairs of component and position. The planes must differ.
#[inline(always)]
pub fn correction_in_b<S: Real>(
    components_at: impl IntoIterator<Item = (S, S)>,
    plane_a: S,
    plane_b: S,
) -> S {
    -S::sum(components_at.into_iter().map(|(u, z)| u * (z - plane_a))) / (plane_b - plane_a)
}

/// Two planes, sum of forces, one component of the correction in plane A: `U_A = −(U_B + Σ Uᵢ)`. Eq. 20.
#[inline(always)]
pub fn correction_in_a<S: Real>(components: impl IntoIterator<Item = S>, correction_in_b: S) -> S {
    -(correction_in_b + S::sum(components))
}

/// The same component in plane A by moments about plane B, a second method: `U_A = −Σ Uᵢ(z_B − zᵢ)/(z_B − z_A)`.
#[inline(always)]
pub fn correction_in_a_by_moments<S: Real>(
    components_at: impl IntoIterator<Item = (S, S)>,
    plane_a: S,
    plane_b: S,
) -> S {
    -S::sum(components_at.into_iter().map(|(u, z)| u * (plane_b - z))) / (plane_b - plane_a)
}

/// One component of the resultant of unbalances, `Σ Uᵢ`, kg·m; times `ω²` it is a force in N. Eq. 12.
#[inline(always)]
pub fn resultant<S: Real>(components: impl IntoIterator<Item = S>) -> S {
    S::sum(components)
}

/// One component of the moment of unbalances about the position `z₀`, `Σ Uᵢ(zᵢ − z₀)`, kg·m²; times `ω²` it is a
/// couple in N·m. Eq. 13.
#[inline(always)]
pub fn moment<S: Real>(components_at: impl IntoIterator<Item = (S, S)>, about: S) -> S {
    S::sum(components_at.into_iter().map(|(u, z)| u * (z - about)))
}

/// Static part of the unbalances of two planes, equal in both: `(U_A + U_B)/2`, one component.
#[inline(always)]
pub fn static_part<S: Real>(in_a: S, in_b: S) -> S {
    (in_a + in_b) / 2.0
}

/// Couple part of the unbalances of two planes: `(U_A − U_B)/2` in plane A and its opposite in plane B, one
/// component.
#[inline(always)]
pub fn couple_part<S: Real>(in_a: S, in_b: S) -> S {
    (in_a - in_b) / 2.0
}

/// Rotating force of an unbalance, `F = U ω²`, N. Eq. 7.
#[inline(always)]
pub fn centrifugal_force<S: Real>(unbalance: S, speed: S) -> S {
    unbalance * speed.powi(2)
}

/// The part at the first of two places of a weight that is split between them,
/// `m₁ = m sin(θ₂ − θ)/sin(θ₂ − θ₁)`: the law of sines in the parallelogram.
#[inline(always)]
pub fn split_first<S: Real>(mass: S, angle: S, first: S, second: S) -> S {
    mass * (second - angle).sin() / (second - first).sin()
}

/// The part at the second place, `m₂ = m sin(θ − θ₁)/sin(θ₂ − θ₁)`.
#[inline(always)]
pub fn split_second<S: Real>(mass: S, angle: S, first: S, second: S) -> S {
    mass * (angle - first).sin() / (second - first).sin()
}
