//! Tests of `vibration::swing`.

use std::f64::consts::PI;

use dalembert_mechanics::vibration::swing::*;

const GRAVITY: f64 = 9.81;

/// The period of a compound pendulum.
fn period(gyration: f64, distance: f64) -> f64 {
    2.0 * PI * ((gyration.powi(2) + distance.powi(2)) / (GRAVITY * distance)).sqrt()
}

#[test]
fn the_centre_between_two_points_is_found_again() {
    let lambda = |distance| reduced_length(GRAVITY, period(0.2, distance));
    assert!((centre_between(0.45, lambda(0.3), lambda(0.15)) - 0.3).abs() < 1e-13);
    assert!((centre_beyond(0.18, lambda(0.3), lambda(0.12)) - 0.3).abs() < 1e-13);
}

#[test]
fn a_ring_on_wires_at_its_own_radius_swings_like_a_pendulum_of_their_length() {
    let (mass, radius, length) = (3.0, 0.25f64, 1.2f64);
    let period = 2.0 * PI * (length / GRAVITY).sqrt();
    let inertia = on_wires(mass * GRAVITY, radius, radius, length, period);
    assert!((inertia - mass * radius * radius).abs() < 1e-14);
}

#[test]
fn a_cylinder_in_a_hollow_rail() {
    // κ² = ρ²/2 for a solid cylinder: T = 2π√(3 (R − ρ)/(2 g)).
    let (journal, rails) = (0.02, 0.5);
    let period = 2.0 * PI * (1.5 * (rails - journal) / GRAVITY).sqrt();
    let square = on_hollow_rails(GRAVITY, journal, rails, period);
    assert!((square / (journal * journal) - 0.5).abs() < 1e-13);
}
