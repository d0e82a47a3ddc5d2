//! Mechanisms swept through many positions by their plan, held against the general way position by position.

use itertools::Itertools as _;
use std::f64::consts::TAU;

use dalembert_mechanics::planar::{
    BodyPoint, Driver, Effort, Model, PlanarBody, PlanarError, PlanarJoint, PlanarLoad, PlanarMechanism,
    Profile, RelativeCoordinate, SweepResult,
};

use crate::{
    close::{close, found},
    models::{
        Driven, angles_of_drag_links, crank_rocker, drag_links, driven_slider, driven_squeezer, six_bar,
    },
};

/// Every position of a sweep against [`Model::continue_to`] and [`Model::kinetostatics`].
fn held((system, drawn): &Driven, values: &[f64], within: f64) {
    let mut swept = SweepResult::default();
    found(found(system.sweep(drawn, 0)).over(values, &mut swept));
    assert_eq!(swept.reached(), values.len());
    let mut here = drawn.clone();
    for (n, value) in values.iter().enumerate() {
        let mut held: Vec<f64> = system.mechanism().drivers.iter().map(|driver| driver.value).collect();
        held[0] = *value;
        here = found(system.continue_to(&here, &held)).positions;
        let (state, dynamics) = found(system.kinetostatics(&here));
        let ours = swept.state(n);
        for (what, [ours, general]) in [
            ("positions", [&ours.positions, &state.positions]),
            ("velocities", [&ours.velocities, &state.velocities]),
            ("accelerations", [&ours.accelerations, &state.accelerations]),
        ] {
            for part in 0..3 {
                let size = general.iter().fold(0.0f64, |most, x| most.max(x[part].abs()));
                for (a, b) in ours.iter().zip_eq(general) {
                    let off = (a[part] - b[part]).abs();
                    assert!(off <= within * size, "{what} at {value}: {a:?} for {b:?}");
                }
            }
        }
        let size = dynamics.multipliers.iter().fold(0.0f64, |most, x| most.max(x.abs()));
        for (a, b) in swept.multipliers(n).iter().zip_eq(&dynamics.multipliers) {
            assert!((a - b).abs() <= within * size, "reactions at {value}: {a} for {b}");
        }
        // Virtual power and Newton with Euler, each from the plan.
        let driver = system.equations().len() - system.mechanism().drivers.len();
        assert!((swept.effort(n) - swept.multipliers(n)[driver]).abs() <= within * size);
        assert!((swept.effort(n) - dynamics.efforts[0]).abs() <= within * size);
    }
}

fn turn(from: f64, count: usize) -> Vec<f64> {
    (0..count).map(|n| from + TAU * n as f64 / count as f64).collect()
}

#[test]
fn a_sweep_is_what_following_position_by_position_gives() {
    let rates = [30.0, 5.0];
    held(&crank_rocker(rates), &turn(0.3, 360), 1e-11);
    held(&driven_slider(rates), &turn(0.3, 90), 1e-11);
    held(&six_bar(rates), &turn(0.3, 120), 1e-11);
    held(&driven_squeezer(rates), &turn(-0.06, 100), 1e-9);
    // Few positions, far apart, and backwards with a standstill.
    held(&crank_rocker([0.0, 5.0]), &[0.3, 2.9, -4.0, -4.0, 9.0], 1e-11);
    held(&six_bar([-3.0, 0.0]), &turn(0.3, 70).into_iter().rev().collect::<Vec<_>>(), 1e-11);
}

/// Two ways through each position, and the closed form of each four-bar.
#[test]
fn chains_of_many_loops_are_swept_as_they_are_followed() {
    for (n, count) in [(8, 90), (20, 45), (100, 40)] {
        let chain = drag_links(n, [3.0, 0.5]);
        let values = turn(0.3, count);
        held(&chain, &values, 1e-10);
        let mut swept = SweepResult::default();
        found(found(chain.0.sweep(&chain.1, 0)).over(&values, &mut swept));
        for (at, value) in values.iter().enumerate() {
            for (body, angle) in angles_of_drag_links(n, *value).into_iter().enumerate() {
                let off = swept.positions(at)[body][2] - angle;
                assert!(off.abs() < 1e-11, "crank {body} of {n} at {value}: off by {off:e}");
            }
        }
    }
}

#[test]
fn the_torque_of_the_four_bar_and_the_slider_crank_are_the_known_ones() {
    // Closed forms, derived with a computer algebra system from Lagrange's equations.
    let torques =
        [-5.037504590790, 5.660819057759, -0.988805188559, -2.204232306681, 1.597334060676, 2.482987048630];
    let (system, drawn) = crank_rocker([30.0, 5.0]);
    let mut swept = SweepResult::default();
    found(found(system.sweep(&drawn, 0)).over(&turn(0.3, 6), &mut swept));
    for (n, torque) in torques.iter().enumerate() {
        close(swept.effort(n), *torque, 1e-11);
    }
}

#[test]
fn cams_gas_and_several_drivers_are_swept_too() {
    let lift = Profile::through(&[[0.0, 0.0], [1.5, 0.01], [3.0, 0.03], [4.5, 0.012]], Some(TAU))
        .expect("the lifts ascend");
    let follower = BodyPoint::body(1, [0.0, 0.0]);
    let up = |to: BodyPoint| RelativeCoordinate::Component {
        direction: [0.0, 1.0],
        from: BodyPoint::ground([0.0, 0.0]),
        to,
    };
    let turning = |body| RelativeCoordinate::Angle { of: Some(body), against: None };
    let mut mechanism = PlanarMechanism {
        bodies: vec![
            PlanarBody { mass: 2.0, inertia: 0.01 },
            PlanarBody { mass: 0.4, inertia: 0.0 },
            PlanarBody { mass: 1.0, inertia: 0.02 },
        ],
        joints: vec![
            PlanarJoint::Pin { a: BodyPoint::ground([0.0, 0.0]), b: BodyPoint::body(0, [0.0, 0.0]) },
            PlanarJoint::Slider {
                guide: BodyPoint::ground([0.0, 0.0]),
                direction: TAU / 4.0,
                slides: follower,
                angle: 0.0,
            },
            PlanarJoint::Cam { follower: up(follower), cam: turning(0), profile: lift },
            PlanarJoint::Pin { a: BodyPoint::body(0, [0.2, 0.0]), b: BodyPoint::body(2, [-0.1, 0.0]) },
        ],
        drivers: vec![
            Driver { measure: turning(0), value: 0.4, velocity: 3.0, acceleration: 1.0 },
            Driver { measure: turning(2), value: 1.0, velocity: -2.0, acceleration: 0.5 },
        ],
        loads: vec![PlanarLoad::Effort {
            measure: RelativeCoordinate::Component {
                direction: [0.0, 1.0],
                from: BodyPoint::ground([0.0, -0.1]),
                to: follower,
            },
            effort: Effort::Gas { area: 1e-3, pressure: 2e5, column: 0.1, exponent: 1.3, ambient: 1e5 },
        }],
        gravity: [0.0, -9.81],
    };
    let drawn = [[0.0, 0.0, 0.4], [0.0, 0.002, 0.0], [0.25, 0.15, 1.0]];
    for [velocity, acceleration] in [[-2.0, 0.5], [-2.0, 0.0], [0.0, 0.5]] {
        mechanism.drivers[1] = Driver { velocity, acceleration, ..mechanism.drivers[1] };
        let system = found(Model::new(&mechanism, &drawn));
        let drawn = found(system.assemble(&drawn));
        held(&(system, drawn), &turn(0.4, 150), 1e-11);
    }
}

#[test]
fn a_sweep_ends_at_the_limit_that_following_finds() {
    // The rocker drives: it swings between two dead centres of the crank.
    let (system, drawn) = crank_rocker([0.0, 0.0]);
    let mut mechanism = system.mechanism().clone();
    mechanism.drivers[0] = Driver {
        measure: RelativeCoordinate::Angle { of: Some(2), against: None },
        value: drawn[2][2],
        velocity: 1.0,
        acceleration: 0.0,
    };
    let system = found(Model::new(&mechanism, &drawn));
    let values: Vec<f64> = (0..200).map(|n| drawn[2][2] + 0.02 * f64::from(n)).collect();
    let mut swept = SweepResult::default();
    let limit = match found(system.sweep(&drawn, 0)).over(&values, &mut swept) {
        Err(PlanarError::Limit { driver: 0, at }) => at,
        other => panic!("a rocker has its limits, not {other:?}"),
    };
    // Crank and coupler in one line: cos of the angle at the pivot of the rocker.
    let reach = |side: f64| {
        let far = 0.28 + side * 0.1;
        std::f64::consts::PI - ((0.2f64.powi(2) + 0.3f64.powi(2) - far * far) / (2.0 * 0.2 * 0.3)).acos()
    };
    let expected = reach(1.0).max(reach(-1.0));
    assert!((limit - expected).abs() < 1e-6, "{limit} for {expected}");
    let last = swept.positions(swept.reached() - 1)[2][2];
    assert!(limit - 0.02 < last && last <= limit);
}

#[test]
fn redundant_joints_and_friction_are_swept_the_general_way() {
    let (system, drawn) = driven_slider([10.0, 0.0]);
    let mut mechanism = system.mechanism().clone();
    mechanism.loads.push(PlanarLoad::Friction { joint: 3, coefficient: 0.1, radius: 0.0 });
    let rough = found(Model::new(&mechanism, &drawn));
    let mut swept = SweepResult::default();
    found(found(rough.sweep(&drawn, 0)).over(&turn(0.4, 80), &mut swept));
    let mut smooth = SweepResult::default();
    found(found(system.sweep(&drawn, 0)).over(&turn(0.4, 80), &mut smooth));
    // Friction takes power: over the turn the driver must bring in more.
    let work = |swept: &SweepResult| (0..80).map(|n| swept.effort(n)).sum::<f64>();
    assert!(work(&swept) > 1.05 * work(&smooth), "{} {}", work(&swept), work(&smooth));
}
