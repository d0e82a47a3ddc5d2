//! Tests of `vibration::piecewise`.

use std::f64::consts::TAU;

use dalembert_mechanics::vibration::piecewise::*;

const SPRINGS: [TwoSlopes; 4] = [
    TwoSlopes { first: 200.0, corner: 0.75, second: 0.0 },
    TwoSlopes { first: 0.0, corner: 0.2, second: 50.0 },
    TwoSlopes { first: 30.0, corner: 0.1, second: 400.0 },
    TwoSlopes { first: 40.0, corner: 0.5, second: 40.0 },
];

/// Thomson's saturating spring: V(0.75) + 150·(y − 0.75) = ½·0.5·20².
#[test]
fn a_saturating_spring_turns_where_the_energy_is_spent() {
    assert!((SPRINGS[0].amplitude(100.0) - (0.75 + 43.75 / 150.0)).abs() < 1e-15);
}

/// The displacement by pieces obeys `m ẍ = −F(x)`, and conserves energy.
#[test]
fn the_pieces_join_to_a_motion() {
    let mass = 2.0;
    for spring in SPRINGS {
        for amplitude in [0.3, 0.76, 2.0] {
            let period = spring.period(mass, amplitude);
            let x = |t: f64| spring.displacement(mass, amplitude, t);
            assert!((x(period / 4.0) - amplitude).abs() < 1e-12 * amplitude);
            for n in 1..100 {
                let (t, h) = (period * f64::from(n) / 97.3, 1e-5 * period);
                let speed = (x(t + h) - x(t - h)) / (2.0 * h);
                let energy = mass * speed * speed / 2.0 + spring.energy(x(t));
                let off = energy / spring.energy(amplitude) - 1.0;
                assert!(off.abs() < 1e-7, "{spring:?}, amplitude {amplitude}, t/T = {}: {off:e}", t / period);
            }
        }
    }
}

#[test]
fn equal_slopes_are_the_linear_spring() {
    let spring = SPRINGS[3];
    for amplitude in [0.1, 0.5, 5.0] {
        let linear = TAU * (2.0f64 / 40.0).sqrt();
        assert!((spring.period(2.0, amplitude) / linear - 1.0).abs() < 1e-13);
    }
}
