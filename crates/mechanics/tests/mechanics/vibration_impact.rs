//! Tests of `vibration::impact`.

use dalembert_mechanics::vibration::impact::*;

/// The series of the shapes of a rod fixed at one end, until it leaves the wall.
#[test]
fn waves_are_the_sum_of_all_shapes() {
    let series = |xi: f64, tau: f64| -> f64 {
        let term = |n: u32| {
            let beta = (f64::from(n) - 0.5) * std::f64::consts::PI;
            2.0 / beta.powi(2) * (beta * xi).sin() * (beta * tau).sin()
        };
        (1..20_000).rev().map(term).sum()
    };
    for xi in [0.0, 0.3, 0.9, 1.0] {
        for tau in [0.1, 0.45, 1.0, 1.3, 1.99] {
            assert!((series(xi, tau) - displacement(xi, tau)).abs() < 3e-5, "{xi} {tau}");
        }
    }
}

/// The waves in a free rod pushed at one end, and its motion as a rigid body with the series of the free-free modes,
/// term by term and in closed form.
#[test]
fn waves_in_a_pushed_rod_are_the_sum_of_all_modes() {
    let series = |xi: f64, tau: f64| -> f64 {
        let term = |n: u32| {
            let beta = f64::from(n) * std::f64::consts::PI;
            2.0 / beta.powi(2) * (beta * xi).cos() * (1.0 - (beta * tau).cos())
        };
        0.5 * tau * tau + (1..20_000).rev().map(term).sum::<f64>()
    };
    for xi in [0.0, 0.3, 0.9, 1.0] {
        for tau in [0.0, 0.1, 0.45, 1.0, 1.3, 1.99, 2.6, 5.2] {
            let waves = free_rod_displacement(xi, tau);
            assert!((series(xi, tau) - waves).abs() < 3e-5, "{xi} {tau}");
            assert!((free_rod_modal_displacement(xi, tau) - waves).abs() < 1e-13, "{xi} {tau}");
        }
    }
}
