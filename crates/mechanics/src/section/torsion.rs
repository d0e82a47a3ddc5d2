//! Torsion of sections that are not round.

use std::f64::consts::PI;

/// Torsion constant `J` of a rectangle with sides `a` and `b`, by Saint-Venant's series:
/// `J = a b³ [1/3 − (64/π⁵)(b/a) Σ tanh(nπa/2b)/n⁵]`, `b ≤ a`, `n` odd (Timoshenko and Goodier, *Theory of
/// Elasticity*, 3rd ed., §109). To a relative `1e-12`; positive sides.
pub fn rectangle(a: f64, b: f64) -> f64 {
    let (long, short) = (a.max(b), a.min(b));
    let ratio = short / long;
    let term = |n: f64| (n * PI / (2.0 * ratio)).tanh() / n.powi(5);
    // Ascending size, so that the small terms are not lost.
    let sum: f64 = (0..400).rev().map(|n| term(f64::from(2 * n + 1))).sum();
    long * short.powi(3) * (1.0 / 3.0 - 64.0 / PI.powi(5) * ratio * sum)
}
