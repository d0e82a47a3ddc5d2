//! Tests of `spring`.

use dalembert_mechanics::spring::*;

/// `1/Σ Δx/(…)` over many thin uniform slices (midpoint rule).
fn sliced(slice: impl Fn(f64) -> f64) -> f64 {
    let n = 2000;
    1.0 / (0..n).map(|i| 1.0 / (slice((f64::from(i) + 0.5) / f64::from(n)) * f64::from(n))).sum::<f64>()
}

#[test]
fn tapered_bars_are_many_thin_slices() {
    let (first, second, length) = (0.02, 0.05, 0.7);
    let diameter = |x: f64| first + (second - first) * x;
    let bar = sliced(|x| axial(200e9, dalembert_mechanics::section::round_area(diameter(x)), length));
    let shaft =
        sliced(|x| torsional(80e9, dalembert_mechanics::section::round_polar_moment(diameter(x)), length));
    assert!((tapered_axial(200e9, first, second, length) / bar - 1.0).abs() < 1e-6);
    assert!((tapered_torsional(80e9, first, second, length) / shaft - 1.0).abs() < 1e-6);
    let uniform = torsional(80e9, dalembert_mechanics::section::round_polar_moment(first), length);
    assert!((tapered_torsional(80e9, first, first, length) / uniform - 1.0).abs() < 1e-15);
}

#[test]
fn a_leaf_spring_is_a_triangular_plate() {
    // Half of it is a cantilever whose width grows evenly from its tip to n b: δ = (F/2) (L/2)³/(2 E I).
    let (young, leaves, breadth, thickness, span) = (200e9, 5.0, 0.06, 0.008, 1.1);
    let root = leaves * breadth * f64::powi(thickness, 3) / 12.0;
    let deflection = 0.5 * f64::powi(span / 2.0, 3) / (2.0 * young * root);
    assert!((leaf(young, leaves, breadth, thickness, span) * deflection - 1.0).abs() < 1e-14);
}
