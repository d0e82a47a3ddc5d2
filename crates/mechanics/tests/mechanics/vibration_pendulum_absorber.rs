//! Tests of `vibration::pendulum_absorber`.

use dalembert_mechanics::vibration::pendulum_absorber::*;

/// A point mass of 0.3 kg at the arm 20 mm, 180 mm off the shaft, on a rotor of 0.5 kg m²; 100 rad/s.
fn rotor(held: f64) -> Pair {
    let (mass, pivot, arm, speed) = (0.3, 0.18, 0.02, 100.0f64);
    Pair {
        body: 0.5 + mass * (pivot + arm) * (pivot + arm),
        coupling: mass * arm * (pivot + arm),
        swing: mass * arm * arm,
        held,
        back: mass * pivot * arm * speed.powi(2),
    }
}

#[test]
fn order_three() {
    // With the rotor at rest the pendulums swing at three times its speed, 100 rad/s.
    let pair = rotor(0.0);
    assert!(((pair.back / pair.swing).sqrt() - 300.0).abs() < 1e-10);
    assert!((tuned_order(0.18, 0.02, 0.02f64 * 0.02) - 3.0).abs() < 1e-14);
}

#[test]
fn frequencies_make_the_determinant_vanish() {
    for held in [0.0, 100.0, 4.5e4, 1e7] {
        let pair = rotor(held);
        let frequencies = pair.frequencies();
        for frequency in frequencies {
            let square = frequency.powi(2);
            let (k, l) = (pair.held - pair.body * square, pair.back - pair.swing * square);
            let rest = k * l - (pair.coupling * square).powi(2);
            let size = (pair.held + pair.body * square) * (pair.back + pair.swing * square);
            assert!(rest.abs() <= 1e-13 * size, "{held}: {rest} of {size}");
        }
        // The antiresonance parts the two.
        assert!(frequencies[0] < 300.0 && 300.0 < frequencies[1]);
    }
}

#[test]
fn the_body_is_at_rest_at_the_tuned_frequency() {
    let [body, swing] = rotor(4.5e4).steady(12.0, 300.0);
    assert!(body.abs() < 1e-12);
    // The centrifugal force at the arm of the shaft balances the torque.
    let torque = 0.3 * 0.02 * (0.18 + 0.02) * 300.0f64.powi(2) * swing;
    assert!((torque + 12.0).abs() < 1e-9);
}
