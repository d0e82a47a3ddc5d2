//! Areas and second moments of cross-sections. Lengths in m, areas in m², second moments in m⁴.
//!
//! The formulas stand in the tables of every strength-of-materials book (Beer & Johnston, *Mechanics of
//! Materials*; Shigley, *Mechanical Engineering Design*).
//!
//! ```
//! use std::f64::consts::PI;
//!
//! use dalembert_mechanics::section::{rectangle_second_moment, round_diameter, round_second_moment, torsion};
//!
//! // A round shaft of 40 mm, I = π d⁴/64, and the diameter that has this second moment.
//! let round: f64 = round_second_moment(0.04);
//! assert!((round / (PI * 4e-8) - 1.0).abs() < 1e-14);
//! assert!((round_diameter(round) - 0.04).abs() < 1e-16);
//! // A flat of 60 × 10 mm bent over its thin side: b h³/12 = 5000 mm⁴.
//! assert!((rectangle_second_moment(0.06_f64, 0.01) - 5e-9).abs() < 1e-22);
//! // Torsion of a square of side a: J = 0.1406 a⁴.
//! assert!((torsion::rectangle(1.0, 1.0) - 0.140_577_014_955_2).abs() < 1e-12);
//! ```

use std::f64::consts::PI;

use crate::Real;

pub mod shear;
pub mod torsion;

/// Area of a round section, `A = π d²/4`.
#[inline]
pub fn round_area<S: Real>(diameter: S) -> S {
    diameter.powi(2) * PI / 4.0
}

/// Second moment of a round section about a diameter, `I = π d⁴/64`.
#[inline]
pub fn round_second_moment<S: Real>(diameter: S) -> S {
    diameter.powi(4) * PI / 64.0
}

/// Polar second moment of a round section, `J = π d⁴/32`.
#[inline]
pub fn round_polar_moment<S: Real>(diameter: S) -> S {
    diameter.powi(4) * PI / 32.0
}

/// Diameter of the round section with a second moment, `d = ⁴√(64 I/π)`, m.
#[inline]
pub fn round_diameter<S: Real>(second_moment: S) -> S {
    (second_moment * 64.0 / PI).root(4)
}

/// Area of a tube, `A = π (D² − d²)/4`, outer diameter `D`, inner `d`.
#[inline]
pub fn tube_area<S: Real>(outer: S, inner: S) -> S {
    (outer.powi(2) - inner.powi(2)) * PI / 4.0
}

/// Second moment of a tube about a diameter, `I = π (D⁴ − d⁴)/64`, outer diameter `D`, inner `d`.
#[inline]
pub fn tube_second_moment<S: Real>(outer: S, inner: S) -> S {
    (outer.powi(4) - inner.powi(4)) * PI / 64.0
}

/// Polar second moment of a tube, `J = π (D⁴ − d⁴)/32`, outer diameter `D`, inner `d`.
#[inline]
pub fn tube_polar_moment<S: Real>(outer: S, inner: S) -> S {
    (outer.powi(4) - inner.powi(4)) * PI / 32.0
}

/// Area of a rectangle, `A = b h`.
#[inline]
pub fn rectangle_area<S: Real>(width: S, height: S) -> S {
    width * height
}

/// Second moment of a rectangle about the axis through its centroid along its width, `I = b h³/12`; the height
/// `h` is measured in the plane of bending.
#[inline]
pub fn rectangle_second_moment<S: Real>(width: S, height: S) -> S {
    width * height.powi(3) / 12.0
}
