//! Tests of `rotor::overhung`.

use dalembert_mechanics::rotor::overhung::*;

use crate::close::close;

/// The tip goes down by `(F L³/3 + M L²/2)/(EI)` and turns by `(F L²/2 + M L)/(EI)`.
#[test]
fn the_stiffness_of_a_cantilever_undoes_its_flexibility() {
    let (young, second_moment, length): (f64, f64, f64) = (207e9, 3.1e-8, 0.43);
    let [k11, k12, k22] = cantilever(young, second_moment, length);
    let bending = young * second_moment;
    for [force, moment] in [[130.0, -21.0], [-40.0, 17.0]] {
        let deflection = (force * length.powi(3) / 3.0 + moment * length.powi(2) / 2.0) / bending;
        let slope = (force * length.powi(2) / 2.0 + moment * length) / bending;
        close(k11 * deflection + k12 * slope, force, 1e-12);
        close(k12 * deflection + k22 * slope, moment, 1e-12);
    }
}

/// `(k₁₁ − m ω²)(k₂₂ − J ω²) = k₁₂²`, for a long and for a thin disc.
#[test]
fn the_disc_whirls_where_inertia_takes_all_the_stiffness() {
    let [k11, k12, k22]: [f64; 3] = cantilever(207e9, 3.1e-8, 0.43);
    let mass = 7.0;
    for inertia in [0.31, -0.24] {
        let (half, delta) = (half_sum(k11, k22, mass, inertia), determinant(k11, k12, k22));
        let lower: f64 = lower_square(mass, inertia, half, delta);
        let upper = upper_square(mass, inertia, half, delta);
        assert!(lower > 0.0 && (upper > lower) == (inertia > 0.0) && (upper > 0.0) == (inertia > 0.0));
        for square in [lower, upper] {
            close((k11 - mass * square) * (k22 - inertia * square), k12 * k12, 1e-11);
        }
    }
}
