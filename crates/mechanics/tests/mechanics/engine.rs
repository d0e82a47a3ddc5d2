use std::f64::consts::{PI, TAU};

use dalembert_mechanics::{
    balance::reciprocating::harmonic_by_series,
    slider_crank::{
        CrankMotion,
        cycle::TorqueCycle,
        engine::{EngineCylinder, PistonFormula},
        equivalent,
        gas::{self, Diagram},
        piston::{self, harmonics, two_term},
    },
};
use proptest::prelude::*;

use crate::close::{ROUNDING, close, found, printed};

fn engine() -> EngineCylinder {
    EngineCylinder {
        crank: 0.075,
        rod: 0.225,
        offset: 0.0,
        model: PistonFormula::Exact,
        reciprocating: 2.4,
        rod_mass: 1.6,
        rod_centre: 0.075,
        rod_inertia: 0.01225,
        gravity: [9.81, 0.0],
        friction: 0.0,
    }
}

#[test]
fn two_terms_are_the_printed_ones() {
    // Khurmi & Gupta, ex. 15.4: 0.3 m, 1.5 m, 180 rpm, 40°.
    let (crank, ratio, angle, speed) = (0.3, 5.0, 40f64.to_radians(), 6.0 * PI);
    printed(two_term::velocity(crank, ratio, angle, speed), 4.19, 2);
    printed(two_term::acceleration(crank, ratio, angle, speed, None), 85.36, 2);
    printed(two_term::zero_acceleration(ratio).to_degrees(), 79.27, 2);
}

#[test]
fn harmonics_approach_the_exact_motion() {
    let (crank, rod, angle): (f64, f64, f64) = (0.04, 0.12, 0.8);
    let amplitudes: Vec<f64> = (1..=16).map(|half| harmonic_by_series(crank / rod, 2 * half)).collect();
    let obliquity = piston::obliquity(rod / crank, angle);
    let exact = piston::displacement(crank, rod / crank, angle, obliquity);
    close(harmonics::displacement(crank, &amplitudes, angle), exact, ROUNDING);
    let velocity = piston::arm(crank, angle, obliquity) * 100.0;
    close(harmonics::velocity(crank, &amplitudes, angle, 100.0), velocity, ROUNDING);
}

#[test]
fn offset_dead_centres_are_where_the_piston_turns() {
    let engine = EngineCylinder { offset: 0.02, ..engine() };
    for angle in engine.dead_centres() {
        let motion = engine.motion(CrankMotion { angle, speed: 1.0, acceleration: 0.0 });
        assert!(motion.velocity.abs() < 1e-15, "{motion:?}");
    }
    let [outer, inner] = engine.dead_centres();
    let at = |angle| engine.motion(CrankMotion { angle, speed: 1.0, acceleration: 0.0 }).displacement;
    assert!(at(outer).abs() < 1e-15);
    close(at(inner), engine.stroke(), ROUNDING);
}

#[test]
fn two_masses_move_like_the_rod() {
    // Khurmi & Gupta, ex. 15.18.
    let other = equivalent::conjugate_distance(0.11, 0.1);
    printed(other, 0.121, 3);
    let [near, far] = [equivalent::share(2.0, 0.1, other), equivalent::share(2.0, other, 0.1)];
    close(near + far, 2.0, ROUNDING);
    close(near * 0.01 + far * other * other, 2.0 * 0.0121, ROUNDING);
    printed(-equivalent::missing_inertia(2.0, 0.11, 0.1, 0.15) * 23_000.0, 133.4, 1);
}

#[test]
fn expansions_do_the_work_of_their_mean_pressure() {
    for exponent in [1.0, 1.3] {
        let (admission, exhaust, cut_off, clearance) = (9e5, 1e5, 0.3, 0.05);
        let diagram = Diagram::Expansion { admission, exhaust, cut_off, clearance, exponent };
        let parts = 20_000;
        let sum: f64 = (0..parts)
            .map(|k| (f64::from(k) + 0.5) / f64::from(parts))
            .map(|x| diagram.pressure(0.0, x, true) - diagram.pressure(PI, x, false))
            .sum();
        let closed = if exponent == 1.0 {
            gas::mean_pressure_hyperbolic(admission, cut_off, Some(clearance), exhaust)
        } else {
            gas::mean_pressure(admission, cut_off, Some(clearance), exponent, exhaust)
        };
        close(sum / f64::from(parts), closed, 1e-8);
    }
}

#[test]
fn a_diagram_over_the_angle_repeats() {
    let rows = vec![[0.1, 2.0], [1.0, 5.0], [9.0, 1.0]];
    let diagram = Diagram::Angle { rows, turns: 2 };
    close(diagram.pressure(0.55, 0.0, true), 3.5, ROUNDING);
    close(diagram.pressure(0.55 - 2.0 * TAU, 0.0, true), 3.5, ROUNDING);
    // Between the last row and the first one of the next cycle.
    let middle = f64::midpoint(9.0, 0.1 + 2.0 * TAU);
    close(diagram.pressure(middle, 0.0, true), 1.5, ROUNDING);
}

#[test]
fn a_sine_fluctuates_by_its_amplitude() {
    let cycle = TorqueCycle::of(|angle| 1000.0 + 583.0 * (2.0 * angle + 0.4).sin(), TAU, &[]);
    close(cycle.mean, 1000.0, ROUNDING);
    close(cycle.rms, (1e6f64 + 583.0 * 583.0 / 2.0).sqrt(), ROUNDING);
    close(cycle.fluctuation, 583.0, 1e-12);
    close(cycle.largest.1, 1583.0, ROUNDING);
    close(cycle.largest.0, PI / 4.0 - 0.2, 1e-9);
    close(cycle.least.1, 417.0, ROUNDING);
    assert_eq!(cycle.crossings.len(), 4);
}

/// Five bottoms, none of which but the first is where a part of a turn ends; the third one is the deepest.
#[test]
fn the_least_moment_is_that_of_the_deepest_bottom() {
    let deepest = 0.8 * PI;
    let moment = |angle: f64| 1000.0 - 583.0 * (5.0 * angle).cos() - 1.7 * (angle - deepest).cos();
    let cycle = TorqueCycle::of(moment, TAU, &[]);
    close(cycle.least.1, 1000.0 - 583.0 - 1.7, ROUNDING);
    close(cycle.least.0, deepest, 1e-9);
    let turned = TorqueCycle::of(|angle| -moment(angle), TAU, &[]);
    close(turned.largest.1, -(1000.0 - 583.0 - 1.7), ROUNDING);
    close(turned.largest.0, deepest, 1e-9);
}

#[test]
fn corners_are_found_where_they_are() {
    // A roof with its ridge where no part of a turn ends.
    let ridge = 1.2345;
    let roof = |angle: f64| -(angle - ridge).abs();
    let cycle = TorqueCycle::of(roof, TAU, &[ridge]);
    assert_eq!(cycle.largest, (ridge, 0.0));
}

proptest! {
    #[test]
    fn virtual_work_and_newton_and_euler_agree(
        crank in 0.02..0.5f64, slenderness in 1.2..6.0f64, lift in -0.15..0.15f64, angle in -7.0..7.0f64,
        speed in 1.0..400.0f64, acceleration in -2e4..2e4f64, gas in -2e4..2e4f64,
        reciprocating in 0.0..5.0f64, rod_mass in 0.0..5.0f64, part in 0.0..1.0f64, gyration in 0.0..0.6f64,
        along in -10.0..10.0f64, across in -10.0..10.0f64, friction in 0.0..500.0f64,
    ) {
        let rod = slenderness * crank;
        let engine = EngineCylinder {
            crank, rod, offset: lift * crank, model: PistonFormula::Exact, reciprocating, rod_mass,
            rod_centre: part * rod, rod_inertia: rod_mass * (gyration * rod).powi(2),
            gravity: [along, across], friction,
        };
        let at = CrankMotion { angle, speed, acceleration };
        let motion = engine.motion(at);
        let forces = engine.forces(at, &motion, gas);
        let reactions = found(engine.reactions(at, gas));
        let size = gas.abs() + friction
            + (reciprocating + rod_mass) * (crank * (speed * speed + acceleration.abs()) + 10.0) * slenderness;
        let reach = 1.0 / (1.0 - 1.15 / slenderness).powf(1.5);
        let same = |a: f64, b: f64| (a - b).abs() <= 1e-12 * size * reach;
        prop_assert!(same(forces.moment, reactions.moment), "{} {}", forces.moment, reactions.moment);
        let work = engine.moment_by_virtual_work(at, &motion, gas);
        prop_assert!(same(work, reactions.moment), "{} {}", work, reactions.moment);
        prop_assert!(same(forces.guide, reactions.guide), "{} {}", forces.guide, reactions.guide);
        prop_assert!(same(forces.gudgeon, -reactions.gudgeon_pin[0]));
        prop_assert!(same(forces.bearing[0], reactions.crank_pin[0]));
        prop_assert!(same(forces.bearing[1], reactions.crank_pin[1]));
    }

    #[test]
    fn inertia_works_against_the_kinetic_energy(
        slenderness in 1.02..6.0f64, angle in -4.0..4.0f64, part in 0.0..1.0f64, gyration in 0.0..0.6f64,
    ) {
        let rod = slenderness * 0.075;
        let engine = EngineCylinder {
            rod, rod_centre: part * rod, rod_inertia: 1.6 * (gyration * rod).powi(2), gravity: [0.0; 2], ..engine()
        };
        let at = CrankMotion { angle, speed: 200.0, acceleration: 0.0 };
        let moment = engine.forces(at, &engine.motion(at), 0.0).moment;
        let energy = engine.kinetic_energy(PI / 2.0, 200.0) + engine.kinetic_energy(0.0, 200.0);
        let apart = (moment - engine.inertia_moment_by_energy(angle, 200.0)).abs();
        prop_assert!(apart <= 1e-10 * energy.max(moment.abs()), "{apart:e} of {energy}");
    }
}
