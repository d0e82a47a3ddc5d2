//! Tests of `vibration::crankshaft`.

use std::f64::consts::PI;

use dalembert_mechanics::vibration::crankshaft::*;
use itertools::Itertools as _;

/// Firing angles of an even firing order.
fn angles(order: &[usize], cycle: f64) -> Vec<f64> {
    let mut angles = vec![0.0; order.len()];
    for (at, cylinder) in order.iter().enumerate() {
        angles[cylinder - 1] = cycle * at as f64 / order.len() as f64;
    }
    angles
}

#[test]
fn a_straight_shaft_is_left_of_a_throw_without_webs() {
    // Webs so wide that they do not bend: journal and pin of one diameter are a round shaft of that length.
    let throw = CrankThrow {
        journal_length: 0.06,
        journal_diameter: 0.08,
        journal_bore: None,
        pin_length: 0.05,
        pin_diameter: 0.08,
        pin_bore: None,
        web_thickness: 0.02,
        web_width: 1e6,
        radius: 0.07,
    };
    let shaft = |length: f64| 80e9 * PI * 0.08f64.powi(4) / (32.0 * length);
    let close = |ours: f64, wanted: f64| assert!((ours / wanted - 1.0).abs() < 1e-12, "{ours} {wanted}");
    close(throw.carter().stiffness(80e9), shaft(0.06 + 0.016 + 0.0375));
    close(throw.ker_wilson().stiffness(80e9), shaft(0.06 + 0.05 + 0.064));
}

#[test]
fn major_orders_of_six_cylinders() {
    let four = angles(&[1, 5, 3, 6, 2, 4], 4.0 * PI);
    let two = angles(&[1, 5, 3, 6, 2, 4], 2.0 * PI);
    let major = |angles: &[f64], step: f64| {
        (1..=24).map(|n| step * f64::from(n)).filter(|n| is_major(*n, angles)).collect::<Vec<_>>()
    };
    assert_eq!(major(&four, 0.5), [3.0, 6.0, 9.0, 12.0]);
    assert_eq!(major(&two, 1.0), [6.0, 12.0, 18.0, 24.0]);
}

#[test]
fn minor_orders_of_a_straight_mode() {
    // Amplitudes 5, 3, 1, −1, −3, −5: only the differences between the halves count at order 1½.
    let angles = angles(&[1, 5, 3, 6, 2, 4], 4.0 * PI);
    let amplitudes = [5.0, 3.0, 1.0, -1.0, -3.0, -5.0];
    let [x, y] = phase_vectors(1.5, amplitudes.into_iter().zip_eq(angles));
    // Firing at 0, 480, 240, 600, 120, 360°: signs + + + − − −.
    assert!((x - 18.0).abs() < 1e-12 && y.abs() < 1e-12);
}
