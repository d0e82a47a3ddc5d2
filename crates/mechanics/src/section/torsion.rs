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

#[cfg(test)]
mod tests {
    #[test]
    fn by_the_table_of_timoshenko_and_goodier() {
        for (ratio, coefficient) in [(1.0, 0.1406), (1.5, 0.196), (2.0, 0.229), (3.0, 0.263), (10.0, 0.312)] {
            assert!((super::rectangle(ratio, 1.0) / ratio - coefficient).abs() < 6e-4);
            assert!((super::rectangle(1.0, ratio) / ratio - coefficient).abs() < 6e-4);
        }
        assert!((super::rectangle(1.0, 1.0) - 0.140_577_014_955_15).abs() < 1e-12);
    }
}
