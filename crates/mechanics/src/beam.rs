//! Stiffness `k = F/δ` in N/m of uniform slender beams under a transverse force, at the point of the force; of
//! some, `k = M/θ` in N·m/rad under a couple at an end.
//!
//! Young's modulus `E` in Pa, second moment `I` in m⁴, lengths in m. Bending only, small deflections
//! (Euler–Bernoulli), no mass. Deflections: Beer & Johnston, *Mechanics of Materials*, and Shigley, *Mechanical
//! Engineering Design*, tables of beam deflections; the stiffnesses at the middle: Rao, *Mechanical Vibrations*.
//!
//! ```
//! use dalembert_mechanics::beam::{
//!     cantilever,
//!     dynamic_stiffness::{Beam, BeamError, BeamStation},
//! };
//!
//! // A steel cantilever of 2 m, E I = 4·10⁴ N·m² and 12 kg/m: δ = F L³/(3 E I), first frequency 3.516 √(E I/(μ L⁴)).
//! let (young, second_moment, length, mass) = (200e9, 2e-7, 2.0, 12.0);
//! assert!((cantilever(young, second_moment, length) - 1.5e4).abs() < 1e-9);
//! let clamp = BeamStation { at: 0.0, held: true, clamped: true, ..BeamStation::default() };
//! let tip = BeamStation { at: 1.0, ..BeamStation::default() };
//! let beam = Beam { shear: 0.0, rotary: 0.0, axial: 0.0, foundation: 0.0, stations: vec![clamp, tip] };
//! let root = beam.roots(1)?[0];
//! assert!((root - 1.875_104_068_711_961).abs() < 1e-11);
//! let frequency = root * root * (young * second_moment / (mass * length.powi(4))).sqrt();
//! assert!((frequency / (3.516_015_268_5 * (4e4_f64 / 192.0).sqrt()) - 1.0).abs() < 1e-9);
//! # Ok::<(), BeamError>(())
//! ```

use crate::Real;

pub mod dynamic_stiffness;
pub mod influence;
pub mod rotating;
pub mod tapered;
pub mod tip_body;
pub mod varying;

/// Cantilever, force at the distance `a` from the clamp: `k = 3EI/a³`; at the tip `a` is the length. What lies
/// beyond the force bends nothing.
#[inline]
pub fn cantilever<S: Real>(young: S, second_moment: S, distance: S) -> S {
    young * second_moment * 3.0 / distance.powi(3)
}

/// Column clamped at one end, its other end moving sideways without turning: `k = 12EI/L³`.
#[inline]
pub fn clamped_guided<S: Real>(young: S, second_moment: S, length: S) -> S {
    young * second_moment * 12.0 / length.powi(3)
}

/// Simply supported, force at the middle: `k = 48EI/L³`.
#[inline]
pub fn simply_supported_middle<S: Real>(young: S, second_moment: S, length: S) -> S {
    young * second_moment * 48.0 / length.powi(3)
}

/// Simply supported, force at the distance `a` from one support: `k = 3EIL/(a²(L − a)²)`, `0 < a < L`.
#[inline]
pub fn simply_supported<S: Real>(young: S, second_moment: S, length: S, distance: S) -> S {
    young * second_moment * length * 3.0 / (distance.powi(2) * (length - distance).powi(2))
}

/// Clamped at both ends, force at the middle: `k = 192EI/L³`.
#[inline]
pub fn clamped_clamped_middle<S: Real>(young: S, second_moment: S, length: S) -> S {
    young * second_moment * 192.0 / length.powi(3)
}

/// Clamped at both ends, force at the distance `a` from one clamp: `k = 3EIL³/(a³(L − a)³)`, `0 < a < L`.
#[inline]
pub fn clamped_clamped<S: Real>(young: S, second_moment: S, length: S, distance: S) -> S {
    young * second_moment * length.powi(3) * 3.0 / (distance.powi(3) * (length - distance).powi(3))
}

/// Clamped at one end and pinned at the other, force at the middle: `k = 768EI/(7L³)`.
#[inline]
pub fn clamped_pinned_middle<S: Real>(young: S, second_moment: S, length: S) -> S {
    young * second_moment * 768.0 / (length.powi(3) * 7.0)
}

/// Clamped at one end and pinned at the other, force at the distance `a` from the clamp:
/// `k = 12EIL³/(a³(L − a)²(4L − a))`, `0 < a < L`.
#[inline]
pub fn clamped_pinned<S: Real>(young: S, second_moment: S, length: S, distance: S) -> S {
    young * second_moment * length.powi(3) * 12.0
        / (distance.powi(3) * (length - distance).powi(2) * (length * 4.0 - distance))
}

/// Simply supported over a span `L`, force at the end of an overhang `a` beyond one support:
/// `k = 3EI/(a²(L + a))`.
#[inline]
pub fn overhang<S: Real>(young: S, second_moment: S, span: S, overhang: S) -> S {
    young * second_moment * 3.0 / (overhang.powi(2) * (span + overhang))
}

/// Cantilever turned by a couple at its tip: `k = EI/L`, N·m/rad.
#[inline]
pub fn cantilever_tip_rotation<S: Real>(young: S, second_moment: S, length: S) -> S {
    young * second_moment / length
}

/// Simply supported, turned by a couple at one end: `k = 3EI/L`, N·m/rad.
#[inline]
pub fn simply_supported_end_rotation<S: Real>(young: S, second_moment: S, length: S) -> S {
    young * second_moment * 3.0 / length
}

/// Clamped at the far end, turned by a couple at its pinned end: `k = 4EI/L`, N·m/rad.
#[inline]
pub fn clamped_pinned_end_rotation<S: Real>(young: S, second_moment: S, length: S) -> S {
    young * second_moment * 4.0 / length
}
