//! Integrals of smooth functions over a range.
//!
//! ```
//! use std::f64::consts::PI;
//!
//! use dalembert_numerics::quadrature::integral;
//!
//! // Work of the torque 3 sin θ over half a turn, in eight parts: 6 J.
//! assert!((integral(|angle| 3.0 * angle.sin(), [0.0, PI], 8) - 6.0).abs() < 1e-13);
//! // Exact for a power of nine in a single part.
//! assert!((integral(|x| x.powi(9), [0.0, 2.0], 1) - 102.4).abs() < 1e-12);
//! ```

/// Abscissae on `[−1, 1]` and weights of five points: exact for polynomials of degree nine.
const POINTS: [(f64, f64); 5] = [
    (-0.906_179_845_938_664, 0.236_926_885_056_189_1),
    (-0.538_469_310_105_683_1, 0.478_628_670_499_366_47),
    (0.0, 0.568_888_888_888_888_9),
    (0.538_469_310_105_683_1, 0.478_628_670_499_366_47),
    (0.906_179_845_938_664, 0.236_926_885_056_189_1),
];

/// The integral of a function over `[from, to]` in equal parts, by Gauss and Legendre with five points in each.
///
/// A harmonic of half a radian in a part is integrated to about `1e-14` of its amplitude.
pub fn integral(function: impl Fn(f64) -> f64, [from, to]: [f64; 2], parts: u32) -> f64 {
    let half = (to - from) / (2.0 * f64::from(parts.max(1)));
    let part = |n: u32| {
        let middle = from + half * (2.0 * f64::from(n) + 1.0);
        POINTS.map(|(x, weight)| weight * function(middle + half * x)).iter().sum::<f64>()
    };
    half * (0..parts.max(1)).map(part).sum::<f64>()
}
