//! Tests of `balance::reciprocating`.

use std::f64::consts::TAU;

use dalembert_mechanics::balance::reciprocating::*;
use itertools::Itertools as _;

#[test]
fn harmonics_are_their_series() {
    for ratio in [0.05, 0.25, 0.3, 0.5, 0.9] {
        for (found, order) in harmonics(ratio).into_iter().zip_eq([2, 4, 6]) {
            let series = harmonic_by_series(ratio, order);
            assert!(
                (found - series).abs() < 1e-12 * ratio.max(series.abs()),
                "{ratio} {order} {found} {series}"
            );
        }
    }
}

#[test]
fn the_series_begins_as_in_books() {
    let ratio: f64 = 0.01;
    let second = ratio + ratio.powi(3) / 4.0 + 15.0 * ratio.powi(5) / 128.0;
    let fourth = -(ratio.powi(3) / 4.0 + 3.0 * ratio.powi(5) / 16.0);
    assert!((harmonic_by_series(ratio, 2) - second).abs() < 1e-12 * second);
    assert!((harmonic_by_series(ratio, 4) - fourth).abs() < 1e-7 * fourth.abs());
    assert!((harmonic_by_series(ratio, 6) - 9.0 * ratio.powi(5) / 128.0).abs() < 1e-3 * ratio.powi(5));
}

#[test]
fn a_flat_crank_is_best_for_four_in_line() {
    let half = TAU / 2.0;
    let angles = best_order(&[0.0, 1.0, 2.0, 3.0], &[0.0, half, 0.0, half]);
    assert_eq!(angles, [0.0, half, half, 0.0]);
}

#[test]
fn a_straight_eight_is_balanced_in_any_unit_of_length() {
    let angles = [0.0, 1.0, 2.0, 3.0, 0.0, 1.0, 2.0, 3.0].map(|quarters| quarters * TAU / 4.0);
    for spacing in [0.11, 1.1e-7] {
        let positions: Vec<f64> = (0..8).map(|k| spacing * f64::from(k)).collect();
        let order = best_order(&positions, &angles);
        for harmonic in [1.0, 2.0] {
            for of in [f64::cos, f64::sin] {
                let arms = order.iter().zip_eq(&positions).map(|(angle, z)| z * of(harmonic * angle));
                let couple: f64 = arms.sum();
                assert!(couple.abs() < 1e-12 * spacing, "{couple:e} of order {harmonic}: {order:?}");
            }
        }
    }
}
