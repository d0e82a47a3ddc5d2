//! Springs and how they combine.
//!
//! ```
//! use dalembert_mechanics::spring::{helical, parallel, reflected_stiffness, series};
//!
//! // Wire of 5 mm, coils of 40 mm, ten of them, G = 80 GPa: k = G d⁴/(8 D³ n) = 9765.625 N/m.
//! let spring: f64 = helical(80e9, 5e-3, 40e-3, 10.0);
//! assert!((spring - 9765.625).abs() < 1e-9);
//! // Two of them end to end are half as stiff, side by side twice; at half of a lever's length a quarter.
//! assert!((series([spring; 2]) - spring / 2.0).abs() < 1e-9);
//! assert!((parallel([spring; 2]) - spring * 2.0).abs() < 1e-9);
//! assert!((reflected_stiffness(spring, 0.5) - spring / 4.0).abs() < 1e-9);
//! ```

use std::f64::consts::PI;

use crate::Real;

/// Axial stiffness of a bar, `k = EA/L`, N/m; Young's modulus in Pa, area in m², length in m.
#[inline]
pub fn axial<S: Real>(young: S, area: S, length: S) -> S {
    young * area / length
}

/// Axial stiffness of a round bar whose diameter grows evenly from `d₁` to `d₂`, `k = π E d₁ d₂/(4 L)`, N/m:
/// the integral of `dx/(E A)`.
#[inline]
pub fn tapered_axial<S: Real>(young: S, first_diameter: S, second_diameter: S, length: S) -> S {
    young * first_diameter * second_diameter * PI / (length * 4.0)
}

/// Torsional stiffness of a shaft, `k = GJ/L`, N·m/rad; shear modulus in Pa, polar second moment in m⁴ (of a round
/// section), length in m.
#[inline]
pub fn torsional<S: Real>(shear: S, polar_moment: S, length: S) -> S {
    shear * polar_moment / length
}

/// Torsional stiffness of a round shaft whose diameter grows evenly from `d₁` to `d₂`,
/// `k = 3 π G d₁³ d₂³/(32 L (d₁² + d₁ d₂ + d₂²))`, N·m/rad: the integral of `dx/(G J)`.
#[inline]
pub fn tapered_torsional<S: Real>(shear: S, first_diameter: S, second_diameter: S, length: S) -> S {
    let squares = first_diameter.powi(2) + first_diameter * second_diameter + second_diameter.powi(2);
    shear * first_diameter.powi(3) * second_diameter.powi(3) * (3.0 * PI) / (length * squares * 32.0)
}

/// Helical compression or extension spring, `k = G d⁴/(8 D³ n)`, N/m: wire diameter `d` and mean coil diameter `D`
/// in m, `n` active coils. Shigley, *Mechanical Engineering Design*, chapter on mechanical springs.
#[inline]
pub fn helical<S: Real>(shear: S, wire_diameter: S, coil_diameter: S, active_coils: S) -> S {
    shear * wire_diameter.powi(4) / (coil_diameter.powi(3) * active_coils * 8.0)
}

/// Helical spring twisted about its axis, `k = E d⁴/(64 D n)`, N·m/rad: the wire bends along its length `π D n`.
#[inline]
pub fn helical_torsional<S: Real>(young: S, wire_diameter: S, coil_diameter: S, active_coils: S) -> S {
    young * wire_diameter.powi(4) / (coil_diameter * active_coils * 64.0)
}

/// Spiral spring clamped at both ends, `k = E I/l`, N·m/rad, with the length `l` of its strip.
#[inline]
pub fn spiral<S: Real>(young: S, second_moment: S, length: S) -> S {
    young * second_moment / length
}

/// Semi-elliptic leaf spring of `n` leaves cut from a plate of uniform strength, loaded at its middle,
/// `k = 8 n E b t³/(3 L³)`, N/m: width `b` and thickness `t` of a leaf, span `L`, m.
#[inline]
pub fn leaf<S: Real>(young: S, leaves: S, breadth: S, thickness: S, span: S) -> S {
    leaves * young * breadth * thickness.powi(3) * 8.0 / (span.powi(3) * 3.0)
}

/// Rubber pad in shear, `k = G A/h`, N/m: bonded area `A`, thickness `h`.
#[inline]
pub fn shear_pad<S: Real>(shear: S, area: S, thickness: S) -> S {
    shear * area / thickness
}

/// Gas behind a piston, `k = n p A²/V`, N/m, from `p Vⁿ` constant: absolute pressure in Pa, volume in m³.
#[inline]
pub fn gas<S: Real>(exponent: S, pressure: S, area: S, volume: S) -> S {
    exponent * pressure * area.powi(2) / volume
}

/// Taut string or cable pushed sideways between its ends, `k = T (1/a + 1/b)`, N/m: tension `T` in N, which small
/// motions do not change; `a` and `b` from the load to the ends.
#[inline]
pub fn taut_string<S: Real>(tension: S, left: S, right: S) -> S {
    tension * (S::from(1.0) / left + S::from(1.0) / right)
}

/// Point mass on a pendulum, pushed sideways, `k = m g/l`, N/m; small angles.
#[inline]
pub fn pendulum<S: Real>(mass: S, gravity: S, length: S) -> S {
    mass * gravity / length
}

/// Body that hangs from a pivot, `k = m g l`, N·m/rad, with the distance `l` of its centre of mass below the pivot.
#[inline]
pub fn pendulum_torsional<S: Real>(mass: S, gravity: S, distance: S) -> S {
    mass * gravity * distance
}

/// Torsional stiffness of a bifilar or multifilar suspension: a body on parallel wires of length `l` at the radius `r`
/// from its axis (two, three or more), turned about that axis, `k = m g r²/l`, N·m/rad.
#[inline]
pub fn bifilar_stiffness<S: Real>(mass: S, gravity: S, radius: S, length: S) -> S {
    mass * gravity * radius.powi(2) / length
}

/// Floating body, `k = ρ g A`, N/m, with the area `A` of its waterline.
#[inline]
pub fn buoyancy<S: Real>(density: S, gravity: S, area: S) -> S {
    density * gravity * area
}

/// Liquid in a U-tube of uniform bore, `k = 2 ρ g A`, N/m.
#[inline]
pub fn u_tube<S: Real>(density: S, gravity: S, area: S) -> S {
    density * gravity * area * 2.0
}

/// A spring whose own deflection is `ratio` times that of the driving point, `k' = r² k`: lever arms
/// `a/b`, the cosine of an inclination, a gear ratio. Both store the same energy.
#[inline]
pub fn reflected_stiffness<S: Real>(stiffness: S, ratio: S) -> S {
    ratio.powi(2) * stiffness
}

/// Springs side by side, equal deflections: `k = Σ kᵢ`. Rao, *Mechanical Vibrations*, 5th ed., §1.7.
#[inline]
pub fn parallel<S: Real>(stiffnesses: impl IntoIterator<Item = S>) -> S {
    S::sum(stiffnesses)
}

/// Springs end to end, equal forces: `k = 1/Σ(1/kᵢ)`. Rao, 5th ed., §1.7.
#[inline]
pub fn series<S: Real>(stiffnesses: impl IntoIterator<Item = S>) -> S {
    S::from(1.0) / S::sum(stiffnesses.into_iter().map(|k| S::from(1.0) / k))
}
