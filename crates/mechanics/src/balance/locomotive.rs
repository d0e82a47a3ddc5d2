//! Partial balance of locomotives with two cylinders.
//!
//! The cylinders are `a` apart, the planes of the wheels `w`, both about the middle of the engine; the crank of the
//! second cylinder stands at the angle `α` from the first one. A mass at the crank of a cylinder acts with the
//! share `(w + a)/(2w)` in the wheel of its own side and `(w − a)/(2w)` in the other one; outside the wheels, `a > w`,
//! the second share is negative. Bevan, *The Theory of Machines*, ch. 14.

use crate::Real;

/// Share of a mass in the plane of the wheel on its own side, `(w + a)/(2w)`.
#[inline]
pub fn near_share<S: Real>(wheels: S, apart: S) -> S {
    (wheels + apart) / (wheels * 2.0)
}

/// Share of a mass in the plane of the wheel on the other side, `(w − a)/(2w)`.
#[inline]
pub fn far_share<S: Real>(wheels: S, apart: S) -> S {
    (wheels - apart) / (wheels * 2.0)
}

/// Amplitude over a turn of `cos θ + cos(θ + α)`, `√((1 + cos α)² + sin² α)`.
#[inline]
pub fn sum_of_cranks<S: Real>(between: S) -> S {
    ((S::from(1.0) + between.cos()).powi(2) + between.sin().powi(2)).sqrt()
}

/// Amplitude over a turn of `cos θ − cos(θ + α)`, `√((1 − cos α)² + sin² α)`.
#[inline]
pub fn crank_difference<S: Real>(between: S) -> S {
    ((S::from(1.0) - between.cos()).powi(2) + between.sin().powi(2)).sqrt()
}

/// Variation of tractive effort at the wheel's angle `θ`: `(1 − c) m r ω² (cos θ + cos(θ + α))`, N.
#[inline]
pub fn tractive_effort<S: Real>(unbalanced: S, angle: S, between: S) -> S {
    unbalanced * (angle.cos() + (angle + between).cos())
}

/// Swaying couple at the wheel's angle `θ`: `(1 − c) m r ω² (a/2)(cos θ − cos(θ + α))`, N·m.
#[inline]
pub fn swaying_couple<S: Real>(unbalanced: S, apart: S, angle: S, between: S) -> S {
    unbalanced * apart / 2.0 * (angle.cos() - (angle + between).cos())
}
