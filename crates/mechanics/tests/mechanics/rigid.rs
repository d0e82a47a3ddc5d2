use std::f64::consts::{PI, TAU};

use dalembert_mechanics::Vector;
use dalembert_mechanics::rigid::{self, Axis, RigidError, disc_tensor, numerical_rate, rod_tensor, turned};
use nalgebra::{Matrix3, Rotation3, Vector3};
use proptest::prelude::*;

use crate::close::{ROUNDING, all_close, close, found};

const I: Vector3<f64> = Vector3::new(1.0, 0.0, 0.0);
const J: Vector3<f64> = Vector3::new(0.0, 1.0, 0.0);
const K: Vector3<f64> = Vector3::new(0.0, 0.0, 1.0);

#[test]
fn disc_on_arm_of_example_3() {
    let (mass, radius) = (3.63, 0.203);
    let diametral = rigid::disc_diametral_inertia(mass, radius);
    let axial = rigid::disc_axial_inertia(mass, radius);
    let inertia = [diametral, diametral, axial];
    let (arm, spin) = (4.0 * J, 12.0 * K);
    let momentum = rigid::angular_momentum(inertia, arm + spin);
    all_close(momentum.components(), [0.0, 3.63 * radius * radius, 21.78 * radius * radius], ROUNDING);

    // The axes turn with the arm, in them the momentum is constant: dH/dt = ω₁ j × H = (m r²/2) ω₁ ω₂ i.
    let relative = rigid::relative_rate(inertia, Vector3::zeros());
    let rate = rigid::rate_of_change(relative, arm, momentum);
    all_close(rate.components(), [3.63 * radius * radius / 2.0 * 48.0, 0.0, 0.0], ROUNDING);
    all_close(rate.components(), rigid::transport_rate(arm, momentum).components(), ROUNDING);

    // The same in axes fixed in the disc: there the components of ω turn at −ω₂, ω̇ = (ω_y ω₂, −ω_x ω₂, 0).
    let euler = rigid::euler_moment(inertia, arm + spin, Vector3::new(4.0 * 12.0, 0.0, 0.0));
    all_close(euler.components(), rate.components(), ROUNDING);

    // And by turning the disc's tensor through its motion and taking differences.
    let tensor = found(disc_tensor(mass, radius, K));
    let momentum_at = |t: f64| {
        let arm_turn = Rotation3::from_axis_angle(&Vector3::y_axis(), 4.0 * t);
        let disc_turn = arm_turn * Rotation3::from_axis_angle(&Vector3::z_axis(), 12.0 * t);
        turned(&tensor, &disc_turn) * (arm + arm_turn * spin)
    };
    all_close(momentum_at(0.0).components(), momentum.components(), ROUNDING);
    let numerical = found(numerical_rate(momentum_at, TAU / 12.0));
    all_close(numerical.components(), rate.components(), 1e-11);
}

proptest! {
    #[test]
    fn rod_on_shaft_of_example_4(
        mass in 0.1..50.0f64, half in 0.05..3.0f64, speed in 0.5..300.0f64, beta in 0.05..1.5f64,
    ) {
        // Principal axes: x′ along the rod, y′ across it in the plane of the shaft; ω = ω(−sin β i′ + cos β j′).
        let across = rigid::rod_inertia_half_length(mass, half);
        let spin = Vector3::new(-speed * beta.sin(), speed * beta.cos(), 0.0);
        let in_rod = rigid::angular_momentum([0.0, across, across], spin);
        // x′ makes the angle −β with x, so that y stays the shaft: ω j.
        let momentum = rigid::to_fixed_axes(Axis::Z, -beta, in_rod);
        let shaft = rigid::to_fixed_axes(Axis::Z, -beta, spin);
        all_close(shaft.components(), [0.0, speed, 0.0], ROUNDING);
        let third = mass * half * half * speed * beta.cos() / 3.0;
        all_close(momentum.components(), [third * beta.sin(), third * beta.cos(), 0.0], ROUNDING);
        let couple = rigid::transport_rate(shaft, momentum);
        let expected = -mass * half * half * speed * speed * (2.0 * beta).sin() / 6.0;
        all_close(couple.components(), [0.0, 0.0, expected], ROUNDING);

        let rod = found(rod_tensor(mass, 2.0 * half, Vector3::new(beta.cos(), -beta.sin(), 0.0)));
        all_close((rod * shaft).components(), momentum.components(), 1e-11);
        let momentum_at = |t: f64| {
            let turn = Rotation3::from_axis_angle(&Vector3::y_axis(), speed * t);
            turned(&rod, &turn) * shaft
        };
        let numerical = found(numerical_rate(momentum_at, TAU / speed));
        let scale = momentum.norm() * speed;
        prop_assert!((numerical - couple).norm() <= 1e-11 * scale);
        // By particles: two half masses at b/√3 from the middle have the rod's inertia.
        let arm = Vector3::new(beta.cos(), -beta.sin(), 0.0) * (half / 3f64.sqrt());
        let pull = Vector3::new(mass * speed * speed * arm.x, 0.0, 0.0);
        let particles = -rigid::moment_of_force(arm, pull);
        prop_assert!((particles - couple).norm() <= 1e-11 * scale);
    }

    #[test]
    fn euler_and_rotating_axes_agree(
        inertia in [0.1..5.0, 0.1..5.0, 0.1..5.0],
        spin in [-9.0..9.0, -9.0..9.0, -9.0..9.0],
        rates in [-9.0..9.0, -9.0..9.0, -9.0..9.0],
    ) {
        let (spin, rates) = (Vector3::from(spin), Vector3::from(rates));
        let momentum = rigid::angular_momentum(inertia, spin);
        let body_axes = rigid::rate_of_change(rigid::relative_rate(inertia, rates), spin, momentum);
        let euler = rigid::euler_moment(inertia, spin, rates);
        prop_assert!((body_axes - euler).norm() <= 1e-12 * 1e3);
        // The power of the moment is the rate of the energy, Σ I ω ω̇.
        let energy_rate: f64 = (0..3).map(|i| inertia[i] * spin[i] * rates[i]).sum();
        prop_assert!((euler.dot(spin) - energy_rate).abs() <= 1e-10);
        let energy: f64 = (0..3).map(|i| 0.5 * inertia[i] * spin[i] * spin[i]).sum();
        close(rigid::rotational_energy(spin, momentum), energy, ROUNDING);
    }

    #[test]
    fn turned_axes_there_and_back(v in [-9.0..9.0, -9.0..9.0, -9.0..9.0], angle in -7.0..7.0) {
        let v = Vector3::from(v);
        for (axis, unit) in
            [(Axis::X, Vector3::x_axis()), (Axis::Y, Vector3::y_axis()), (Axis::Z, Vector3::z_axis())]
        {
            let fixed = rigid::to_fixed_axes(axis, angle, v);
            let rotation = Rotation3::from_axis_angle(&unit, angle);
            all_close(fixed.components(), (rotation * v).components(), ROUNDING);
            all_close(rigid::to_rotating_axes(axis, angle, fixed).components(), v.components(), ROUNDING);
        }
    }

    #[test]
    fn motion_of_a_point_by_differences(
        arm in [-2.0..2.0, -2.0..2.0, -2.0..2.0], speed in 0.5..50.0, slow_down in -3.0..3.0,
    ) {
        // A body turning about z by θ = ω t + α t²/2 while its point A moves along x.
        let arm = Vector3::from(arm);
        let place = |t: f64| {
            let angle = speed * t + 0.5 * slow_down * t * t;
            I * (3.0 * t) + Rotation3::from_axis_angle(&Vector3::z_axis(), angle) * arm
        };
        let (spin, rate) = (speed * K, slow_down * K);
        let velocity = |t: f64| {
            let spin = spin + rate * t;
            rigid::velocity_of_point(3.0 * I, spin, place(t) - I * (3.0 * t))
        };
        let scale = 10.0 + speed * arm.norm();
        let period = TAU / (speed + 3.0);
        prop_assert!((found(numerical_rate(place, period)) - velocity(0.0)).norm() <= 1e-11 * scale);
        let acceleration = rigid::acceleration_of_point(Vector3::zeros(), spin, rate, arm);
        let numerical = found(numerical_rate(velocity, period));
        prop_assert!((numerical - acceleration).norm() <= 1e-10 * scale * (speed + 3.0));
    }
}

#[test]
fn inertias_by_summing_particles() {
    let n = 400;
    let points = |length: f64| (0..n).map(move |i| length * ((f64::from(i) + 0.5) / f64::from(n) - 0.5));
    // Midpoint sums of x² fall short by 1/n² of the whole.
    let rod: f64 = points(1.8).map(|x| 2.7 / f64::from(n) * x * x).sum();
    let shortfall = 1.0 - 1.0 / f64::from(n).powi(2);
    close(rod, rigid::rod_inertia(2.7, 1.8) * shortfall, ROUNDING);
    close(rigid::rod_inertia_half_length(2.7, 0.9), rigid::rod_inertia(2.7, 1.8), ROUNDING);
    // A disc in rings of radius ρ: ∫ ρ² 2πρ dρ m/(π r²); with u = ρ² the integrand is linear.
    let disc: f64 =
        (0..n).map(|i| 5.0 / f64::from(n) * 0.3f64.powi(2) * (f64::from(i) + 0.5) / f64::from(n)).sum();
    close(rigid::disc_axial_inertia(5.0, 0.3), disc, ROUNDING);
    close(2.0 * rigid::disc_diametral_inertia(5.0, 0.3), disc, ROUNDING);
    // A cylinder of no height is a disc, of no radius a rod.
    close(rigid::cylinder_diametral_inertia(5.0, 0.3, 0.0), disc / 2.0, ROUNDING);
    close(rigid::cylinder_diametral_inertia(2.7, 0.0, 1.8), rigid::rod_inertia(2.7, 1.8), ROUNDING);
    // About its end a rod has m L²/3.
    let about_end = rigid::parallel_axis(rigid::rod_inertia(2.7, 1.8), 2.7, 0.9);
    close(about_end, 2.7 * 1.8 * 1.8 / 3.0, ROUNDING);
}

#[test]
fn tensors_are_those_of_bodies() {
    for direction in
        [I, Vector3::new(1.0, 2.0, -0.5), Vector3::new(1e-300, 1e-300, 0.0), Vector3::new(1e300, 0.0, 1e300)]
    {
        let rod = found(rod_tensor(3.0, 2.0, direction));
        let disc = found(disc_tensor(3.0, 0.4, direction));
        close(rod.trace(), 2.0 * rigid::rod_inertia(3.0, 2.0), ROUNDING);
        close(disc.trace(), 4.0 * rigid::disc_diametral_inertia(3.0, 0.4), ROUNDING);
        let u = (direction / direction.amax()).normalize();
        assert!((rod * u).norm() <= 1e-14 && (disc * u - u * 0.24).norm() <= 1e-14);
        assert_eq!(rod, rod.transpose());
    }
    for none in [Vector3::zeros(), Vector3::new(f64::NAN, 1.0, 0.0), Vector3::new(f64::INFINITY, 0.0, 0.0)] {
        assert_eq!(rod_tensor(1.0, 1.0, none), Err(RigidError::Direction));
        assert_eq!(disc_tensor(1.0, 1.0, none), Err(RigidError::Direction));
    }
    assert_eq!(rod_tensor(1e300, 1e300, I), Err(RigidError::NotFinite));
    assert_eq!(turned(&Matrix3::identity(), &Rotation3::identity()), Matrix3::identity());
}

#[test]
fn numerical_rate_has_its_order() {
    let error = |period: f64| (found(numerical_rate(|t| I * t.sin(), period)).x - 1.0).abs();
    // Eighth order: twice the step, 256 times the error.
    let observed = (error(40.0) / error(20.0)).log2();
    assert!((observed - 8.0).abs() < 0.5, "{observed}");
    assert_eq!(numerical_rate(|_| I, 0.0), Err(RigidError::NotFinite));
    assert_eq!(numerical_rate(|_| I * f64::NAN, PI), Err(RigidError::NotFinite));
}
