//! Springs and how they combine.

use crate::Real;

/// Axial stiffness of a bar, `k = EA/L`, N/m; Young's modulus in Pa, area in m², length in m.
#[inline]
pub fn axial<S: Real>(young: S, area: S, length: S) -> S {
    young * area / length
}

/// Torsional stiffness of a shaft, `k = GJ/L`, N·m/rad; shear modulus in Pa, polar second moment in m⁴ (of a round
/// section), length in m.
#[inline]
pub fn torsional<S: Real>(shear: S, polar_moment: S, length: S) -> S {
    shear * polar_moment / length
}

/// Helical compression or extension spring, `k = G d⁴/(8 D³ n)`, N/m: wire diameter `d` and mean coil diameter `D`
/// in m, `n` active coils. Shigley, *Mechanical Engineering Design*, chapter on mechanical springs.
#[inline]
pub fn helical<S: Real>(shear: S, wire_diameter: S, coil_diameter: S, active_coils: S) -> S {
    shear * wire_diameter.powi(4) / (coil_diameter.powi(3) * active_coils * 8.0)
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
