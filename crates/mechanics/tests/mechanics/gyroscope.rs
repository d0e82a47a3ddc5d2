use std::f64::consts::{PI, TAU};

use dalembert_mechanics::{
    Vector,
    rigid::{self, gyroscope, numerical_rate},
};
use nalgebra::{Matrix3, Rotation3, Unit, Vector3};
use proptest::prelude::*;

use crate::close::{ROUNDING, all_close, close, found};

#[test]
fn couple_of_a_level_rotor_is_the_product_of_the_textbook() {
    // Meriam & Kraige, sample problem 7/8: 40 kg·m² at 5000 rpm, 12.85 m/s on 400 m.
    let (axial, spin, rate) = (40.0, 5000.0 * TAU / 60.0, 12.85 / 400.0);
    let couple = gyroscope::couple(axial, 25.0, spin, Vector3::x(), Vector3::z() * rate);
    all_close(couple.components(), [0.0, axial * spin * rate, 0.0], ROUNDING);
    close(gyroscope::right_angled_couple(axial, spin, rate), 672.824_426_647, 1e-9);
    close(gyroscope::precession_rate(couple.y, axial, spin), rate, ROUNDING);
}

#[test]
fn an_oblique_axle_adds_the_part_of_the_transverse_moment() {
    let (axial, transverse, spin, rate): (f64, f64, f64, f64) = (2.0, 1.2, 50.0, 4.0);
    for degrees in [10.0_f64, 60.0, 90.0, 135.0] {
        let (sin, cos) = degrees.to_radians().sin_cos();
        let precession = Vector3::new(cos, 0.0, sin) * rate;
        let couple = gyroscope::couple(axial, transverse, spin, Vector3::x(), precession);
        let closed = axial * spin * rate * sin + (axial - transverse) * rate * rate * sin * cos;
        all_close(couple.components(), [0.0, closed, 0.0], 1e-14 * 400.0);
    }
}

#[test]
fn blades_along_the_precession_double_the_couple_and_across_it_leave_none() {
    let (inertia, spin, rate) = (4.0, 100.0, 0.5);
    let normal = |angle: f64| gyroscope::blades_couple_normal(inertia, inertia, spin, rate, angle);
    close(normal(0.0), -400.0, ROUNDING);
    assert!(normal(PI / 2.0).abs() < 400.0 * ROUNDING);
    close(gyroscope::blades_couple_precession(inertia, spin, rate, PI / 4.0), 200.0, ROUNDING);
    close(gyroscope::blades_couple_spin(inertia, rate, PI / 4.0), -0.5, ROUNDING);
}

proptest! {
    /// The closed couple is the rate of change of the whole tensor turned with the rotor, times its angular velocity.
    #[test]
    fn couple_is_the_rate_of_the_turned_momentum(
        axial in 0.1..5.0_f64,
        share in 0.5..3.0_f64,
        spin in -40.0..40.0_f64,
        [u, v, w] in prop::array::uniform3(-1.0..1.0_f64),
        [x, y, z] in prop::array::uniform3(-3.0..3.0_f64),
    ) {
        let direction = Vector3::new(u, v, w);
        prop_assume!(direction.norm() > 0.1);
        let axle = direction.normalize();
        let precession = Vector3::new(x, y, z);
        prop_assume!(precession.norm() > 0.1);
        let transverse = axial * share;
        let tensor = gyroscope::symmetric_tensor(axial, transverse, axle);
        let momentum_at = |t: f64| gyroscope::momentum_at(&tensor, spin, axle, precession, t);
        let momentum = gyroscope::momentum(axial, transverse, spin, axle, precession);
        prop_assert!((momentum_at(0.0) - momentum).norm() < 1e-13 * (1.0 + momentum.norm()));
        let rate = found(numerical_rate(momentum_at, TAU / (spin.abs() + precession.norm())));
        let couple = gyroscope::couple(axial, transverse, spin, axle, precession);
        let size = momentum.norm() * (spin.abs() + precession.norm());
        prop_assert!((rate - couple).norm() < 1e-10 * size, "{rate} and {couple}");
    }

    /// The three parts of the couple on two blades are the rate of the turned momentum.
    #[test]
    fn blades_couple_is_the_rate_of_the_turned_momentum(
        along in 0.1..2.0_f64,
        across in 2.0..4.0_f64,
        part in 0.01..0.99_f64,
        spin in -40.0..40.0_f64,
        rate in -2.0..2.0_f64,
        angle in -7.0..7.0_f64,
    ) {
        let axial = across - along + part * 2.0 * along;
        let tensor = Matrix3::from_diagonal(&Vector3::new(axial, along, across));
        let tensor = rigid::turned(&tensor, &Rotation3::from_axis_angle(&Vector3::x_axis(), angle));
        let precession = Vector3::y() * rate;
        let momentum_at = |t: f64| gyroscope::momentum_at(&tensor, spin, Vector3::x(), precession, t);
        let fastest = 2.0 * spin.abs() + rate.abs() + 0.1;
        let expected = found(numerical_rate(momentum_at, TAU / fastest));
        let difference = across - along;
        let couple = Vector3::new(
            gyroscope::blades_couple_spin(difference, rate, angle),
            gyroscope::blades_couple_precession(difference, spin, rate, angle),
            gyroscope::blades_couple_normal(axial, difference, spin, rate, angle),
        );
        let size = axial * fastest * fastest;
        prop_assert!((expected - couple).norm() < 1e-10 * size, "{expected} and {couple}");
    }

    /// The forces of the bearings hold the rotor, whatever the couple: their sum, and their moments about G.
    #[test]
    fn bearing_forces_balance(
        [u, v, w] in prop::array::uniform3(-1.0..1.0_f64),
        [x, y, z] in prop::array::uniform3(-100.0..100.0_f64),
        [p, q, r] in prop::array::uniform3(-100.0..100.0_f64),
        behind in 0.1..2.0_f64,
        ahead in 0.1..2.0_f64,
    ) {
        prop_assume!(Vector3::new(u, v, w).norm() > 0.1);
        let axle = Unit::new_normalize(Vector3::new(u, v, w)).into_inner();
        // Both across the axle: along it bearings exert no couple, and the thrust is another matter.
        let reject = |a: Vector3<f64>| a - axle * Vector::dot(a, axle);
        let (force, couple) = (reject(Vector3::new(x, y, z)), reject(Vector3::new(p, q, r)));
        let front = gyroscope::bearing_ahead(force, couple, axle, behind, ahead);
        let rear = force - front;
        let moment = Vector::cross(axle, front * ahead - rear * behind);
        prop_assert!((moment - couple).norm() < 1e-12 * (couple.norm() + force.norm() * 4.0));
    }
}
