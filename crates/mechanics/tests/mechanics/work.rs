use dalembert_mechanics::work;
use nalgebra::Vector3;
use proptest::prelude::*;

use crate::close::{ROUNDING, close};

#[test]
fn slider_crank_of_example_1() {
    let (g, k) = (Vector3::new(0.0, -10.0, 0.0), Vector3::new(0.0, 0.0, 1.0));
    let slider = Vector3::new(-500.0, 0.0, 0.0);
    let rod_centre = Vector3::new(300.0, 200.0, 0.0);
    let rod_spin = -50.0 * k;
    let load = work::force_power(Vector3::new(5000.0, 0.0, 0.0), slider);
    let weight = work::force_power(work::weight(3.0, g), rod_centre);
    let slider_inertia = work::force_power(work::inertia_force(2.0, Vector3::new(900.0, 0.0, 0.0)), slider);
    let rod_inertia =
        work::force_power(work::inertia_force(3.0, Vector3::new(900.0, -600.0, 0.0)), rod_centre);
    let rod_couple = work::couple_power(work::inertia_couple(0.1, -800.0 * k), rod_spin);
    let powers = [load, weight, slider_inertia, rod_inertia, rod_couple];
    assert_eq!(powers, [-2_500_000.0, -6_000.0, 900_000.0, -450_000.0, -4_000.0]);
    close(work::unknown_load(powers, 20.0), 103_000.0, ROUNDING);

    // What the notes print needs two slips at once; either one alone gives another number.
    let slip = |rod_inertia: f64, rod_couple: f64| {
        work::unknown_load([load, weight, slider_inertia, rod_inertia, rod_couple], 20.0)
    };
    close(slip(-45_000.0, 4_000.0), 82_350.0, ROUNDING);
    close(slip(-450_000.0, 4_000.0), 102_600.0, ROUNDING);
    close(slip(-45_000.0, -4_000.0), 82_750.0, ROUNDING);
}

fn vectors() -> impl Strategy<Value = Vector3<f64>> {
    [-10.0..10.0, -10.0..10.0, -10.0..10.0].prop_map(Vector3::from)
}

proptest! {
    #[test]
    fn power_of_the_inertia_loads_is_the_loss_of_kinetic_energy(
        velocity in vectors(), acceleration in vectors(), mass in 0.1..50.0,
    ) {
        // d/dt (m v²/2), by a central difference of the quadratic, which is exact.
        let energy = |t: f64| 0.5 * mass * (velocity + acceleration * t).norm_squared();
        let power = work::force_power(work::inertia_force(mass, acceleration), velocity);
        let rate = (energy(0.5) - energy(-0.5)) / 1.0;
        prop_assert!((power + rate).abs() <= 1e-11 * mass * 1e3);
    }

    #[test]
    fn a_force_and_its_couple_do_the_work_of_the_force_elsewhere(
        force in vectors(), arm in vectors(), velocity in vectors(), spin in vectors(),
    ) {
        let there = work::force_power(force, velocity + spin.cross(&arm));
        let here = work::force_power(force, velocity) + work::couple_power(arm.cross(&force), spin);
        prop_assert!((there - here).abs() <= 1e-10 * (1.0 + force.norm() * 500.0));
    }
}
