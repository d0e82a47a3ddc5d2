//! Derivatives by differences.
//!
//! ```
//! use dalembert_numerics::differentiation::derivative;
//!
//! // Velocity of the harmonic motion x = 0.1 sin 3t at 0.4 s: 0.3 cos 3t.
//! let velocity = derivative(|t| 0.1 * (3.0 * t).sin(), 0.4, 0.01);
//! assert!((velocity - 0.3 * 1.2_f64.cos()).abs() < 1e-13);
//! ```

use std::ops::{Add, Div, Mul, Sub};

/// First derivative of a number or a vector at `x` by central differences of the eighth order, with four steps to either
/// side: `f′ ≈ Σ cₖ (f(x + k h) − f(x − k h))/(840 h)` with the weights 672, −168, 32, −3 (B. Fornberg, *Math. Comp.* 51,
/// 1988, pp. 699–706).
///
/// The error is `h⁸ f⁽⁹⁾/630` and the rounding of the values over `h`.
pub fn derivative<T>(f: impl Fn(f64) -> T, x: f64, step: f64) -> T
where
    T: Add<Output = T> + Sub<Output = T> + Mul<f64, Output = T> + Div<f64, Output = T>,
{
    let difference = |k: f64| f(x + k * step) - f(x - k * step);
    (difference(1.0) * 672.0 - difference(2.0) * 168.0 + difference(3.0) * 32.0 - difference(4.0) * 3.0)
        / (840.0 * step)
}
