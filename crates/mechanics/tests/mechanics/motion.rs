//! Free motions of plane mechanisms against the benchmarks of the field and against closed forms.
//!
//! Pendulum (A01), N four-bars (A02) and Andrews' squeezing mechanism (A03) of the IFToMM library of computational
//! benchmark problems; the last one with the data of E. Hairer, G. Wanner, *Solving Ordinary Differential Equations II*,
//! §VII.7, and of the test set for IVP solvers.

use dalembert_mechanics::planar::{
    BodyPoint, Driver, Effort, Event, Model, PlanarBody, PlanarError, PlanarJoint, PlanarLoad,
    PlanarMechanism, PlanarRun, RelativeCoordinate, Snapshot, Trajectory,
};
use itertools::Itertools as _;

use crate::close::{close, found};
use crate::models::{andrews, four_bars};
use crate::planar::{ends, slider_crank_joints};

fn run(duration: f64, tolerance: f64, samples: usize) -> PlanarRun<'static> {
    PlanarRun { duration, tolerance, samples, ends: &[], most_steps: 100_000, cancelled: &|| false }
}

fn angle(body: usize) -> RelativeCoordinate {
    RelativeCoordinate::Angle { of: Some(body), against: None }
}

/// A point mass on a massless bar of 1 m.
fn pendulum(start: f64) -> (Model, Vec<[f64; 3]>) {
    let mechanism = PlanarMechanism {
        bodies: vec![PlanarBody { mass: 1.0, inertia: 0.0 }],
        joints: vec![PlanarJoint::Pin {
            a: BodyPoint::ground([0.0, 0.0]),
            b: BodyPoint::body(0, [-1.0, 0.0]),
        }],
        gravity: [0.0, -9.81],
        ..PlanarMechanism::default()
    };
    let drawn = vec![[start.cos(), start.sin(), start]];
    (found(Model::new(&mechanism, &drawn)), drawn)
}

#[test]
fn the_pendulum_swings_as_the_elliptic_functions_say() {
    let (system, drawn) = pendulum(std::f64::consts::PI);
    let moved = found(system.simulate(&drawn, &[[0.0; 3]], &run(10.0, 1e-13, 11)));
    let expected = [
        (1, 0.9862917511318753, -0.1650108531255412),
        (2, -0.7935661953433217, -0.6084839304437915),
        (5, -0.9423054350437573, -0.3347543384140006),
        (10, -0.2750874625761169, -0.9614192050991252),
    ];
    for (second, x, y) in expected {
        let at = moved.samples[second].state.positions[0];
        assert!((at[0] - x).abs() < 1e-10 && (at[1] - y).abs() < 1e-10, "{at:?} after {second} s");
    }
    assert!(moved.imbalance() < 1e-10);
}

#[test]
fn a_motion_ends_where_it_is_reported_to() {
    let (system, drawn) = pendulum(std::f64::consts::PI);
    let through = [Event::Reaches(angle(0), 1.5 * std::f64::consts::PI)];
    let period = 2.3678419475762373;
    let moved =
        found(system.simulate(&drawn, &[[0.0; 3]], &PlanarRun { ends: &through, ..run(10.0, 1e-12, 101) }));
    let last = moved.samples.last().expect("a sample");
    close(last.time, period / 4.0, 1e-10);
    close(last.state.velocities[0][2], (2.0f64 * 9.81).sqrt(), 1e-10);
    assert_eq!(moved.ended, Some(0));
    let rests = [Event::Reaches(angle(0), 0.5), Event::Rests(angle(0))];
    let moved =
        found(system.simulate(&drawn, &[[0.0; 3]], &PlanarRun { ends: &rests, ..run(10.0, 1e-12, 11) }));
    assert_eq!(moved.ended, Some(1));
    close(moved.samples.last().expect("a sample").time, period / 2.0, 1e-10);
}

fn fall(n: usize, tolerance: f64) -> Trajectory {
    let (system, drawn) = four_bars(n);
    let velocities = found(system.initial_velocities(&drawn, &[(angle(0), -1.0)]));
    found(system.simulate(&drawn, &velocities, &run(10.0, tolerance, 2)))
}

#[test]
fn four_bars_in_a_row_pass_their_singular_positions() {
    let expected = [
        (1, -30.343944970941, -1.966934719434),
        (2, -30.179800860189, -1.506642180836),
        (10, -30.050933495986, -1.212262216525),
        (40, -30.026637417189, -1.167622108749),
    ];
    for (n, angle, velocity) in expected {
        let moved = fall(n, 1e-9);
        let last = moved.samples.last().expect("a sample");
        for body in 0..=n {
            let [.., turned] = last.state.positions[body];
            assert!((turned - angle).abs() < 1e-5, "{n}: {turned} is not {angle}");
            assert!((last.state.velocities[body][2] - velocity).abs() < 1e-4, "{n}");
        }
        let height = 9.81 * (1.5 * n as f64 + 0.5);
        assert!(moved.imbalance() < 1e-6 * height, "{n}: {:e} J", moved.imbalance());
    }
}

#[test]
fn four_bars_in_a_row_pass_their_singular_positions_at_every_tolerance() {
    for n in [1, 2, 5, 11, 12, 15, 20, 40] {
        for tolerance in [1e-11, 1e-10, 1e-9, 1e-8, 4e-7] {
            let (system, drawn) = four_bars(n);
            let velocities = found(system.initial_velocities(&drawn, &[(angle(0), -1.0)]));
            let moved = found(system.simulate(&drawn, &velocities, &run(10.0, tolerance, 241)));
            // All rods stay parallel, at every moment shown.
            for Snapshot { time, state, .. } in &moved.samples {
                for body in 1..=n {
                    let apart = (state.positions[body][2] - state.positions[0][2]).abs();
                    assert!(apart < 1e-7, "{n} four-bars at {tolerance:e}, {time} s: {apart:e} apart");
                }
            }
            // The error of the steps adds up; the rounding of positions n m away does so along the row.
            let largest = moved.samples.iter().map(|moment| moment.kinetic).fold(0.0, f64::max);
            let allowed = 30.0 * tolerance + 2e-10 * (n as f64 + 5.0);
            assert!(
                moved.imbalance() < allowed * largest,
                "{n}, {tolerance:e}: {:e}",
                moved.imbalance() / largest
            );
        }
    }
}

/// Two rods about their ends and a coupler that goes round with them have the inertia, 5/3 kg m², and the moment of
/// weight of 4 kg at half a metre.
#[test]
fn a_four_bar_of_equal_rods_swings_as_a_pendulum_through_its_singular_positions() {
    let (four_bar, drawn) = four_bars(1);
    let mechanism = PlanarMechanism {
        bodies: vec![PlanarBody { mass: 4.0, inertia: 2.0 / 3.0 }],
        joints: vec![PlanarJoint::Pin {
            a: BodyPoint::ground([0.0, 0.0]),
            b: BodyPoint::body(0, [-0.5, 0.0]),
        }],
        gravity: [0.0, -9.81],
        ..PlanarMechanism::default()
    };
    let upright = vec![[0.0, 0.5, std::f64::consts::FRAC_PI_2]];
    let pendulum = found(Model::new(&mechanism, &upright));
    let moved = |system: &Model, drawn: &[[f64; 3]]| {
        let velocities = found(system.initial_velocities(drawn, &[(angle(0), -1.0)]));
        found(system.simulate(drawn, &velocities, &run(3.0, 1e-11, 3001))).samples
    };
    for (ours, single) in moved(&four_bar, &drawn).iter().zip_eq(&moved(&pendulum, &upright)) {
        for body in 0..2 {
            let ([x, y, turned], [.., expected]) = (ours.state.positions[body], single.state.positions[0]);
            assert!((turned - expected).abs() < 1e-6, "{turned}, not {expected} after {} s", ours.time);
            let [across, up] = [body as f64 + expected.cos() / 2.0, expected.sin() / 2.0];
            assert!((x - across).abs() < 1e-6 && (y - up).abs() < 1e-6, "({x}, {y}) after {} s", ours.time);
            let (rate, expected) = (ours.state.velocities[body][2], single.state.velocities[0][2]);
            assert!((rate - expected).abs() < 1e-5, "{rate}, not {expected} after {} s", ours.time);
        }
    }
}

/// Of a bar that hangs from a carriage at a given speed `V`, the kinetic energy is least where it turns with
/// `m a V sin(θ − γ)/(I + m a²)`.
#[test]
fn what_no_driver_moves_starts_with_the_least_kinetic_energy() {
    let (track, speed, reach) = (0.4f64, 1.7, 0.35);
    let carriage = BodyPoint::body(0, [0.0, 0.0]);
    let along = [track.cos(), track.sin()];
    let bar = PlanarBody { mass: 2.6, inertia: 0.13 };
    for turned in [-1.1f64, 0.9, 2.3] {
        let mechanism = PlanarMechanism {
            bodies: vec![PlanarBody { mass: 3.9, inertia: 0.2 }, bar],
            joints: vec![
                PlanarJoint::Slider {
                    guide: BodyPoint::ground([0.0, 0.0]),
                    direction: track,
                    slides: carriage,
                    angle: track,
                },
                PlanarJoint::Pin { a: carriage, b: BodyPoint::body(1, [-reach, 0.0]) },
            ],
            drivers: vec![Driver {
                measure: RelativeCoordinate::Component {
                    direction: along,
                    from: BodyPoint::ground([0.0, 0.0]),
                    to: carriage,
                },
                value: 0.6,
                velocity: speed,
                acceleration: 0.0,
            }],
            gravity: [0.0, -9.81],
            ..PlanarMechanism::default()
        };
        let [x, y] = along.map(|part| 0.6 * part);
        let drawn = [[x, y, track], [x + reach * turned.cos(), y + reach * turned.sin(), turned]];
        let system = found(Model::new(&mechanism, &drawn));
        let velocities = found(system.initial_velocities(&found(system.assemble(&drawn)), &[]));
        let rate =
            bar.mass * reach * speed * (turned - track).sin() / (bar.inertia + bar.mass * reach * reach);
        close(velocities[1][2], rate, 1e-11);
        close(velocities[1][0], speed * along[0] - rate * reach * turned.sin(), 1e-11);
        close(velocities[1][1], speed * along[1] + rate * reach * turned.cos(), 1e-11);
        close(velocities[0][0], speed * along[0], 1e-11);
    }
}

/// β, Θ, γ, Φ, δ, Ω, ε from the angles of the bodies.
fn relative(q: &[[f64; 3]]) -> [f64; 7] {
    let t = |body: usize| q[body][2];
    [t(0), t(1) - t(0), t(2), t(3) - t(4), t(4), t(5) - t(6), t(6)]
}

#[test]
fn andrews_mechanism_starts_with_the_published_accelerations_and_multipliers() {
    let (system, drawn) = andrews();
    let positions = found(system.assemble(&drawn));
    let solved = found(system.forward_dynamics(&positions, &[[0.0; 3]; 7]));
    assert_eq!(solved.degrees_of_freedom, 1);
    let [beta, theta, ..] = relative(&solved.state.accelerations);
    close(beta, 14222.443919954114, 1e-11);
    close(theta, -10666.832939965585, 1e-11);
    close(solved.multipliers[0], 98.56687039624109, 1e-11);
    close(solved.multipliers[1], -6.122688344255662, 1e-10);
    for multiplier in &solved.multipliers[2..6] {
        assert!(multiplier.abs() < 1e-9);
    }
}

#[test]
fn andrews_mechanism_comes_to_its_reference() {
    // Our own values in 80-bit arithmetic; those published for tolerances of 1e-14 agree to 1.4e-9.
    let positions = [
        15.8107711951537,
        -15.7563710584118,
        0.0408222401196465,
        -0.534730116342079,
        0.524409965879954,
        0.534730116342079,
        1.04808074104194,
    ];
    let velocities = [
        1139.92030225911,
        -1424.37929517754,
        11.0329119106170,
        19.2933741050293,
        0.573569914829416,
        -19.2933741050293,
        0.3231791492491,
    ];
    let (system, drawn) = andrews();
    let start = found(system.assemble(&drawn));
    for (tolerance, allowed, energy) in [(1e-12, 1e-10, 1e-11), (1e-7, 1e-5, 1e-5)] {
        let moved = found(system.simulate(&start, &[[0.0; 3]; 7], &run(0.03, tolerance, 2)));
        let last = moved.samples.last().expect("a sample");
        for (ours, expected) in relative(&last.state.positions).iter().zip_eq(positions) {
            assert!((ours - expected).abs() < allowed, "{ours} is not {expected}: {tolerance:e}");
        }
        for (ours, expected) in relative(&last.state.velocities).iter().zip_eq(velocities) {
            assert!((ours - expected).abs() < 1e4 * allowed, "{ours} is not {expected}: {tolerance:e}");
        }
        assert!(moved.imbalance() < energy, "{:e}", moved.imbalance());
    }
}

#[test]
fn the_accelerations_of_a_motion_are_those_of_the_full_equations() {
    let (system, drawn) = andrews();
    let start = found(system.assemble(&drawn));
    let moved = found(system.simulate(&start, &[[0.0; 3]; 7], &run(0.03, 1e-9, 13)));
    for sample in &moved.samples {
        let solved = found(system.forward_dynamics(&sample.state.positions, &sample.state.velocities));
        let size = solved.state.accelerations.iter().flatten().fold(0.0f64, |most, a| most.max(a.abs()));
        for (a, b) in
            solved.state.accelerations.iter().flatten().zip_eq(sample.state.accelerations.iter().flatten())
        {
            assert!((a - b).abs() < 1e-10 * size, "{a} and {b} at {}", sample.time);
        }
    }
}

#[test]
fn drivers_do_the_work_that_a_motion_takes() {
    // A crank turned at an even speed from rest of the rest: its torque is that of the dynamics at every moment, and
    // its work closes the balance.
    let piston = BodyPoint::body(2, [0.0, 0.0]);
    let mechanism = PlanarMechanism {
        bodies: vec![
            PlanarBody { mass: 1.0, inertia: 0.01 },
            PlanarBody { mass: 2.0, inertia: 0.03 },
            PlanarBody { mass: 3.0, inertia: 0.0 },
        ],
        joints: slider_crank_joints(ends(0, 0.1, 0.05), ends(1, 0.35, 0.35 / 2.0)),
        drivers: vec![Driver { measure: angle(0), value: 0.7, velocity: 20.0, acceleration: 15.0 }],
        loads: vec![PlanarLoad::Effort {
            measure: RelativeCoordinate::Component {
                direction: [1.0, 0.0],
                from: BodyPoint::ground([0.0, 0.0]),
                to: piston,
            },
            effort: Effort::Damper { coefficient: 40.0 },
        }],
        gravity: [0.0, -9.81],
    };
    let drawn = [[0.04, 0.03, 0.7], [0.2, 0.03, -0.2], [0.4, 0.0, 0.0]];
    let system = found(Model::new(&mechanism, &drawn));
    let start = found(system.assemble(&drawn));
    let velocities = found(system.initial_velocities(&start, &[]));
    let moved = found(system.simulate(&start, &velocities, &run(0.5, 1e-10, 21)));
    for sample in &moved.samples {
        let turned = 0.7 + 20.0 * sample.time + 7.5 * sample.time * sample.time;
        close(sample.state.positions[0][2], turned, 1e-12);
        close(sample.state.velocities[0][2], 20.0 + 15.0 * sample.time, 1e-11);
    }
    let largest = moved.samples.iter().fold(0.0f64, |most, sample| most.max(sample.kinetic));
    assert!(moved.imbalance() < 1e-8 * largest, "{:e} of {largest:e}", moved.imbalance());
    assert!(moved.samples.iter().any(|sample| sample.work.abs() > 0.1 * largest));
}

#[test]
fn parallel_bars_beyond_what_is_needed_change_nothing() {
    // A parallelogram on three equal rockers, one too many: as on two whose mass and inertia are one and a half times.
    let coupler = |body: usize, x: f64| BodyPoint::body(body, [x, 0.0]);
    let swing = |rockers: &[f64], mass: f64| {
        let bodies: Vec<PlanarBody> = rockers
            .iter()
            .map(|_| PlanarBody { mass, inertia: mass / 12.0 })
            .chain([PlanarBody { mass: 2.0, inertia: 0.7 }])
            .collect();
        let last = rockers.len();
        let joints = rockers
            .iter()
            .enumerate()
            .flat_map(|(k, &x)| {
                [
                    PlanarJoint::Pin { a: BodyPoint::ground([x, 0.0]), b: BodyPoint::body(k, [-0.5, 0.0]) },
                    PlanarJoint::Pin { a: BodyPoint::body(k, [0.5, 0.0]), b: coupler(last, x) },
                ]
            })
            .collect();
        let mechanism =
            PlanarMechanism { bodies, joints, gravity: [0.0, -9.81], ..PlanarMechanism::default() };
        let start = 0.3f64;
        let drawn: Vec<[f64; 3]> = rockers
            .iter()
            .map(|x| [x + start.cos() / 2.0, start.sin() / 2.0, start])
            .chain([[start.cos(), start.sin(), 0.0]])
            .collect();
        let system = found(Model::new(&mechanism, &drawn));
        let positions = found(system.assemble(&drawn));
        let still = vec![[0.0; 3]; drawn.len()];
        let moved = found(system.simulate(&positions, &still, &run(1.0, 1e-11, 2)));
        moved.samples[1].state.positions[0][2]
    };
    close(swing(&[0.0, 0.4, 1.0], 1.0), swing(&[0.0, 1.0], 1.5), 1e-8);
}

#[test]
fn what_cannot_move_freely_is_named() {
    let (_, drawn) = pendulum(1.0);
    let mechanism = PlanarMechanism {
        bodies: vec![PlanarBody { mass: 1.0, inertia: 0.0 }, PlanarBody::default()],
        joints: vec![
            PlanarJoint::Pin { a: BodyPoint::ground([0.0, 0.0]), b: BodyPoint::body(0, [-1.0, 0.0]) },
            PlanarJoint::Pin { a: BodyPoint::body(0, [0.0, 0.0]), b: BodyPoint::body(1, [0.0, 0.0]) },
        ],
        gravity: [0.0, -9.81],
        ..PlanarMechanism::default()
    };
    let drawn = [drawn[0], drawn[0]];
    let still = [[0.0; 3]; 2];
    let system = found(Model::new(&mechanism, &drawn));
    assert_eq!(system.simulate(&drawn, &still, &run(1.0, 1e-8, 2)), Err(PlanarError::Massless { body: 1 }));
    assert_eq!(system.forward_dynamics(&drawn, &still), Err(PlanarError::Massless { body: 1 }));
    let (system, drawn) = pendulum(1.0);
    let twice = [(angle(0), 1.0), (angle(0), 2.0)];
    assert_eq!(system.initial_velocities(&drawn, &twice), Err(PlanarError::Rate { index: 1 }));
    let stop = PlanarRun { cancelled: &|| true, ..run(1.0, 1e-8, 2) };
    assert!(matches!(system.simulate(&drawn, &[[0.0; 3]], &stop), Err(PlanarError::Motion(_))));
}

/// A body of 2 kg whose origin or angle is driven.
fn driven_body(joints: Vec<PlanarJoint>, drivers: Vec<Driver>) -> (Model, Vec<[f64; 3]>) {
    let mechanism = PlanarMechanism {
        bodies: vec![PlanarBody { mass: 2.0, inertia: 0.1 }],
        joints,
        drivers,
        gravity: [0.0, -9.81],
        ..PlanarMechanism::default()
    };
    let drawn = vec![[0.0; 3]];
    (found(Model::new(&mechanism, &drawn)), drawn)
}

#[test]
fn a_mechanism_without_a_degree_of_freedom_follows_its_driver() {
    let pin = PlanarJoint::Pin { a: BodyPoint::ground([0.0, 0.0]), b: BodyPoint::body(0, [0.0, 0.0]) };
    let driver = Driver { measure: angle(0), value: 0.0, velocity: 1.5, acceleration: 0.5 };
    let (model, drawn) = driven_body(vec![pin], vec![driver]);
    let moved = found(model.simulate(&drawn, &[[0.0, 0.0, 1.5]], &run(2.0, 1e-9, 5)));
    for moment in &moved.samples {
        let t = moment.time;
        close(moment.state.positions[0][2], 1.5 * t + 0.25 * t * t, 1e-12);
        close(moment.state.velocities[0][2], 1.5 + 0.5 * t, 1e-12);
    }
    assert_eq!(moved.samples.len(), 5);
    assert!(moved.imbalance() < 1e-9);
}

#[test]
fn both_components_of_a_point_can_be_driven_from_zero() {
    let component = |direction| RelativeCoordinate::Component {
        direction,
        from: BodyPoint::ground([0.0, 0.0]),
        to: BodyPoint::body(0, [0.0, 0.0]),
    };
    let driver = |direction, velocity| Driver {
        measure: component(direction),
        value: 0.0,
        velocity,
        acceleration: 0.0,
    };
    let drivers = vec![driver([1.0, 0.0], 2.0), driver([0.0, 1.0], -1.0)];
    let (model, drawn) = driven_body(vec![], drivers);
    let moved = found(model.simulate(&drawn, &[[2.0, -1.0, 3.0]], &run(1.0, 1e-9, 3)));
    let last = moved.samples.last().expect("a sample");
    for (position, expected) in last.state.positions[0].iter().zip_eq([2.0, -1.0, 3.0]) {
        close(*position, expected, 1e-12);
    }
}
