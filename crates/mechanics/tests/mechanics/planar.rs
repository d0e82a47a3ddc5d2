//! Plane mechanisms held against published cases, closed forms, and against themselves: virtual power against
//! Newton and Euler, loops that stay closed, branches that stay the same.

use itertools::Itertools as _;
use std::f64::consts::{FRAC_PI_2, TAU};

use dalembert_mechanics::balance::linkage::{Follower, LinkInertia, Linkage};
use dalembert_mechanics::planar::{
    BodyPoint, Driver, Effort, Model, PlanarBody, PlanarError, PlanarJoint, PlanarLoad, PlanarMechanism,
    PlanarState, Pose, RelativeCoordinate, Stability,
};
use dalembert_mechanics::slider_crank::{Branch, CrankMotion, SliderCrank};
use proptest::prelude::*;

use crate::{
    close::{ROUNDING, close, found, printed},
    jet::Jet,
};

/// A driver of the angle of a body.
pub(crate) fn turning(body: usize, value: f64, velocity: f64, acceleration: f64) -> Driver {
    Driver {
        measure: RelativeCoordinate::Angle { of: Some(body), against: None },
        value,
        velocity,
        acceleration,
    }
}

/// The ends of a bar along its own x axis, with its centre of mass so far from the first.
pub(crate) fn ends(body: usize, length: f64, centre: f64) -> [BodyPoint; 2] {
    [BodyPoint::body(body, [-centre, 0.0]), BodyPoint::body(body, [length - centre, 0.0])]
}

/// Crank 0, coupler 1 and rocker 2 between the pivots (0, 0) and (d, 0); centres of mass in the middle.
pub(crate) fn four_bar([a, b, c, d]: [f64; 4], bodies: [PlanarBody; 3], driver: Driver) -> PlanarMechanism {
    let ([o, p], [q, r], [s, t]) = (ends(0, a, a / 2.0), ends(1, b, b / 2.0), ends(2, c, c / 2.0));
    PlanarMechanism {
        bodies: bodies.to_vec(),
        joints: vec![
            PlanarJoint::Pin { a: BodyPoint::ground([0.0, 0.0]), b: o },
            PlanarJoint::Pin { a: p, b: q },
            PlanarJoint::Pin { a: r, b: t },
            PlanarJoint::Pin { a: BodyPoint::ground([d, 0.0]), b: s },
        ],
        drivers: vec![driver],
        ..PlanarMechanism::default()
    }
}

/// The bars of a four-bar drawn at about these angles.
pub(crate) fn drawn([a, b, c, d]: [f64; 4], [crank, coupler, rocker]: [f64; 3]) -> [[f64; 3]; 3] {
    let (p, t) = ([a * crank.cos(), a * crank.sin()], [d + c * rocker.cos(), c * rocker.sin()]);
    [
        [p[0] / 2.0, p[1] / 2.0, crank],
        [p[0] + b * coupler.cos() / 2.0, p[1] + b * coupler.sin() / 2.0, coupler],
        [f64::midpoint(d, t[0]), t[1] / 2.0, rocker],
    ]
}

/// Joints of a crank 0, rod 1 and piston 2 that slides along the x axis, from the ends of crank and rod.
pub(crate) fn slider_crank_joints([o, p]: [BodyPoint; 2], [q, s]: [BodyPoint; 2]) -> Vec<PlanarJoint> {
    let piston = BodyPoint::body(2, [0.0, 0.0]);
    vec![
        PlanarJoint::Pin { a: BodyPoint::ground([0.0, 0.0]), b: o },
        PlanarJoint::Pin { a: p, b: q },
        PlanarJoint::Pin { a: s, b: piston },
        PlanarJoint::Slider {
            guide: BodyPoint::ground([0.0, 0.0]),
            direction: 0.0,
            slides: piston,
            angle: 0.0,
        },
    ]
}

/// A slider-crank at 20 rad/s, with a rod of 3 kg and a slider of 2 kg, their weights and other loads.
pub(crate) fn slider_crank([r, l]: [f64; 2], angle: f64, loads: Vec<PlanarLoad>) -> PlanarMechanism {
    PlanarMechanism {
        bodies: vec![
            PlanarBody::default(),
            PlanarBody { mass: 3.0, inertia: 0.1 },
            PlanarBody { mass: 2.0, inertia: 0.0 },
        ],
        joints: slider_crank_joints(ends(0, r, 0.0), ends(1, l, l / 2.0)),
        drivers: vec![turning(0, angle, 20.0, 0.0)],
        loads,
        gravity: [0.0, -10.0],
    }
}

pub(crate) fn moving(mechanism: &PlanarMechanism, drawn: &[[f64; 3]]) -> (Model, PlanarState) {
    let system = found(Model::new(mechanism, drawn));
    let positions = found(system.assemble(drawn));
    let state = found(system.kinematics(&positions));
    (system, state)
}

#[test]
fn a_four_bar_with_massive_links_needs_its_torque() {
    let lengths = [0.05, 0.151, 0.111, 0.1];
    let bodies = [
        PlanarBody::default(),
        PlanarBody { mass: 0.5, inertia: 1.21e-3 },
        PlanarBody { mass: 0.4, inertia: 0.91e-3 },
    ];
    let angle = 120f64.to_radians();
    let (system, state) =
        moving(&four_bar(lengths, bodies, turning(0, angle, 95.0, 0.0)), &drawn(lengths, [angle, 0.3, 1.3]));
    close(state.velocities[1][2], 21.356205, 1e-7);
    close(state.velocities[2][2], 50.207036, 1e-7);
    close(state.accelerations[1][2], 971.46984, 1e-7);
    close(state.accelerations[2][2], -1125.3189, 1e-7);
    let dynamics = found(system.inverse_dynamics(&state));
    close(dynamics.efforts[0], -3.4640493, 1e-7);
    close(dynamics.newton_euler[0], dynamics.efforts[0], ROUNDING);
    close(dynamics.efforts[0] * 95.0, dynamics.energy_rate, ROUNDING);
}

#[test]
fn a_slider_crank_is_the_one_of_the_formulas() {
    let (r, l, angle) = (0.15, 0.2, 30f64.to_radians());
    let force =
        PlanarLoad::Force { at: BodyPoint::body(2, [0.0, 0.0]), force: [5000.0, 0.0], turns_with: None };
    let mechanism = slider_crank([r, l], angle, vec![force]);
    let (system, state) = moving(&mechanism, &[[0.0, 0.0, angle], [0.2, 0.04, -0.4], [0.3, 0.0, 0.0]]);
    let formulas = SliderCrank { crank: r, rod: l, offset: 0.0, branch: Branch::Ahead };
    let motion = found(formulas.motion(CrankMotion { angle, speed: 20.0, acceleration: 0.0 }));
    close(state.positions[2][0], motion.slider_position, ROUNDING);
    close(state.velocities[2][0], motion.slider_velocity, ROUNDING);
    close(state.accelerations[2][0], motion.slider_acceleration, ROUNDING);
    close(state.accelerations[1][2], motion.rod_acceleration, ROUNDING);
    let dynamics = found(system.inverse_dynamics(&state));
    close(dynamics.efforts[0], 672.34321, 1e-8);
    close(dynamics.newton_euler[0], dynamics.efforts[0], ROUNDING);
    let mobility = found(system.mobility(&state.positions));
    assert_eq!((mobility.counted, mobility.free, mobility.redundant), (1, 1, vec![]));
}

#[test]
fn a_roberval_balance_does_not_mind_where_its_pans_are_loaded() {
    // Two equal beams, one above the other, and two upright pans: a parallelogram with one joint too many of its kind.
    let beam = |body: usize| {
        [
            BodyPoint::body(body, [-0.25, 0.0]),
            BodyPoint::body(body, [0.0, 0.0]),
            BodyPoint::body(body, [0.25, 0.0]),
        ]
    };
    let (upper, lower) = (beam(0), beam(1));
    let pan = |body: usize| [BodyPoint::body(body, [0.0, 0.1]), BodyPoint::body(body, [0.0, -0.1])];
    let (left, right) = (pan(2), pan(3));
    let weight = |at: BodyPoint| PlanarLoad::Force { at, force: [0.0, -5.0 * 9.81], turns_with: None };
    let mechanism = PlanarMechanism {
        bodies: vec![PlanarBody::default(); 4],
        joints: vec![
            PlanarJoint::Pin { a: BodyPoint::ground([0.0, 0.1]), b: upper[1] },
            PlanarJoint::Pin { a: BodyPoint::ground([0.0, -0.1]), b: lower[1] },
            PlanarJoint::Pin { a: upper[0], b: left[0] },
            PlanarJoint::Pin { a: lower[0], b: left[1] },
            PlanarJoint::Pin { a: upper[2], b: right[0] },
            PlanarJoint::Pin { a: lower[2], b: right[1] },
        ],
        drivers: vec![turning(0, 0.2, 0.0, 0.0)],
        loads: vec![weight(BodyPoint::body(2, [-0.3, 0.1])), weight(BodyPoint::body(3, [0.1, 0.1]))],
        gravity: [0.0; 2],
    };
    let drawn = [[0.0, 0.1, 0.2], [0.0, -0.1, 0.2], [-0.25, 0.0, 0.0], [0.25, 0.0, 0.0]];
    let (system, state) = moving(&mechanism, &drawn);
    let mobility = found(system.mobility(&state.positions));
    assert_eq!((mobility.counted, mobility.free, mobility.redundant.len()), (0, 1, 1));
    let dynamics = found(system.inverse_dynamics(&state));
    assert!(dynamics.efforts[0].abs() < 1e-12 && dynamics.newton_euler[0].abs() < 1e-12);
}

#[test]
fn a_geared_five_bar_and_its_rolling_and_cord_kin() {
    let (first, second) = (70f64.to_radians(), 110f64.to_radians());
    let crank = |body| ends(body, 0.05, 0.0);
    let rod = |body| ends(body, 0.12, 0.06);
    let ([o, p], [c, q], [pr, apex], [qr, apex2]) = (crank(0), crank(1), rod(2), rod(3));
    let mechanism = PlanarMechanism {
        bodies: vec![PlanarBody::default(); 4],
        joints: vec![
            PlanarJoint::Pin { a: BodyPoint::ground([0.0, 0.0]), b: o },
            PlanarJoint::Pin { a: BodyPoint::ground([0.1, 0.0]), b: c },
            PlanarJoint::Pin { a: p, b: pr },
            PlanarJoint::Pin { a: q, b: qr },
            PlanarJoint::Pin { a: apex, b: apex2 },
            PlanarJoint::Gears { a: Some(0), b: Some(1), carrier: None, sizes: [1.0, 1.0], internal: false },
        ],
        drivers: vec![turning(0, first, 1.0, 0.0)],
        loads: vec![PlanarLoad::Force { at: apex, force: [0.0, 100.0], turns_with: None }],
        gravity: [0.0; 2],
    };
    let drawn = [[0.0, 0.0, first], [0.1, 0.0, second], [0.03, 0.1, 1.2], [0.07, 0.1, 1.9]];
    let (system, state) = moving(&mechanism, &drawn);
    let dynamics = found(system.inverse_dynamics(&state));
    close(dynamics.efforts[0], -0.37065684, 1e-7);
    close(dynamics.newton_euler[0], dynamics.efforts[0], ROUNDING);
}

#[test]
fn a_disc_is_rolled_by_a_crank_against_spring_and_damper() {
    let (r, l, angle) = (0.06, 0.2, 50f64.to_radians());
    let ([o, p], [q, s]) = (ends(0, r, 0.0), ends(1, l, l / 2.0));
    let centre = BodyPoint::body(2, [0.0, 0.0]);
    let floor = BodyPoint::ground([0.0, -0.15]);
    let wall = RelativeCoordinate::Distance { from: BodyPoint::ground([-0.2, 0.0]), to: centre };
    let mechanism = PlanarMechanism {
        bodies: vec![
            PlanarBody::default(),
            PlanarBody::default(),
            PlanarBody { mass: 4.0, inertia: 4.0 * 0.15 * 0.15 / 2.0 },
        ],
        joints: vec![
            PlanarJoint::Pin { a: BodyPoint::ground([0.0, 0.0]), b: o },
            PlanarJoint::Pin { a: p, b: q },
            PlanarJoint::Pin { a: s, b: centre },
            PlanarJoint::Slot { guide: floor, direction: 0.0, pin: centre, offset: 0.15 },
            PlanarJoint::Rack { guide: floor, direction: 0.0, centre, radius: 0.15 },
        ],
        drivers: vec![turning(0, angle, 8.0, 0.0)],
        loads: vec![
            PlanarLoad::Effort { measure: wall, effort: Effort::Spring { stiffness: 800.0, free: 0.1 } },
            PlanarLoad::Effort { measure: wall, effort: Effort::Damper { coefficient: 25.0 } },
        ],
        gravity: [0.0; 2],
    };
    let (system, state) = moving(&mechanism, &[[0.0, 0.0, angle], [0.1, 0.0, -0.2], [0.2, 0.0, 0.0]]);
    let dynamics = found(system.inverse_dynamics(&state));
    close(dynamics.efforts[0], -13.3168, 1e-5);
    close(dynamics.newton_euler[0], dynamics.efforts[0], ROUNDING);
    let at_the_floor = system.equations().len() - 2;
    printed(dynamics.multipliers[at_the_floor].abs(), 4.58006, 5);
}

#[test]
fn a_crank_too_short_to_turn_stops_at_its_limit() {
    // A double rocker: the crank is limited where coupler and rocker stretch out, a² + d² − 2 a d cos θ = (b + c)².
    let lengths = [0.2, 0.1, 0.12, 0.15];
    let [a, b, c, d] = lengths;
    let start = 0.8;
    let mechanism = four_bar(lengths, [PlanarBody::default(); 3], turning(0, start, 0.0, 0.0));
    let (system, state) = moving(&mechanism, &drawn(lengths, [start, -0.6, 1.0]));
    let limit = ((a * a + d * d - (b + c) * (b + c)) / (2.0 * a * d)).acos();
    match system.continue_to(&state.positions, &[2.5]) {
        Err(PlanarError::Limit { driver: 0, at }) => close(at, limit, 1e-8),
        other => panic!("{other:?}"),
    }
}

#[test]
fn what_is_wrong_is_named() {
    let lengths = [0.1, 0.1, 0.1, 0.5];
    let apart = four_bar(lengths, [PlanarBody::default(); 3], turning(0, 1.0, 0.0, 0.0));
    let system = found(Model::new(&apart, &drawn(lengths, [1.0, 0.0, 2.0])));
    assert!(matches!(
        system.assemble(&drawn(lengths, [1.0, 0.0, 2.0])),
        Err(PlanarError::DoesNotClose { residual, .. }) if residual > 0.05
    ));
    let lengths = [0.04, 0.12, 0.08, 0.1];
    let good = four_bar(lengths, [PlanarBody::default(); 3], turning(0, 1.0, 0.0, 0.0));
    let at = drawn(lengths, [1.0, 0.3, 1.2]);
    let without = PlanarMechanism { drivers: vec![], ..good.clone() };
    let (system, positions) = {
        let system = found(Model::new(&without, &at));
        let positions = found(system.assemble(&at));
        (system, positions)
    };
    assert_eq!(system.kinematics(&positions), Err(PlanarError::UnderDriven { free: 1, singular: false }));
    let mut twice = good.clone();
    let rocker = found(Model::new(&good, &positions)).value(
        &RelativeCoordinate::Angle { of: Some(2), against: None },
        &found(found(Model::new(&good, &at)).assemble(&at)),
    );
    twice.drivers.push(turning(2, rocker, 0.0, 0.0));
    let system = found(Model::new(&twice, &at));
    let positions = found(system.assemble(&at));
    assert!(matches!(system.kinematics(&positions), Err(PlanarError::OverDriven { .. })));
    let astray = PlanarMechanism {
        joints: vec![PlanarJoint::Pin { a: BodyPoint::ground([0.0; 2]), b: BodyPoint::body(7, [0.0; 2]) }],
        ..good
    };
    assert!(matches!(Model::new(&astray, &at), Err(PlanarError::NoSuchBody { body: 7, bodies: 3, .. })));
}

#[test]
fn friction_in_a_guide_is_that_of_an_inclined_plane() {
    // A block pushed up a plane of 20° by a horizontal force: P = W tan(20° + φ).
    let (slope, mu, weight) = (20f64.to_radians(), 0.25f64, 120.0);
    let block = BodyPoint::body(0, [0.0, 0.0]);
    let mechanism = PlanarMechanism {
        bodies: vec![PlanarBody { mass: 12.0, inertia: 0.0 }],
        joints: vec![PlanarJoint::Slider {
            guide: BodyPoint::ground([0.0, 0.0]),
            direction: slope,
            slides: block,
            angle: slope,
        }],
        drivers: vec![Driver {
            measure: RelativeCoordinate::Component {
                direction: [1.0, 0.0],
                from: BodyPoint::ground([0.0, 0.0]),
                to: block,
            },
            value: 0.3,
            velocity: 0.1,
            acceleration: 0.0,
        }],
        loads: vec![PlanarLoad::Friction { joint: 0, coefficient: mu, radius: 0.0 }],
        gravity: [0.0, -10.0],
    };
    let (system, state) = moving(&mechanism, &[[0.3, 0.1, slope]]);
    let dynamics = found(system.inverse_dynamics(&state));
    close(dynamics.newton_euler[0], weight * (slope + mu.atan()).tan(), 1e-12);
    close(dynamics.efforts[0], dynamics.newton_euler[0], 1e-12);
    let mut steep = mechanism;
    steep.loads = vec![PlanarLoad::Friction { joint: 0, coefficient: 2.9, radius: 0.0 }];
    let (system, state) = moving(&steep, &[[0.3, 0.1, slope]]);
    assert!(matches!(system.inverse_dynamics(&state), Err(PlanarError::Jammed { joint: 0 })));
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 48, failure_persistence: None, ..ProptestConfig::default() })]

    /// Crank-rockers of any shape, with masses, a following force, a spring, and weights.
    #[test]
    fn two_methods_agree_on_random_linkages(
        a in 0.3..0.9f64, b in 1.6..2.4f64, c in 1.4..2.2f64, d in 1.6..2.3f64,
        angle in 0.0..TAU, speed in -20.0..20.0f64, acceleration in -50.0..50.0f64,
        masses in prop::array::uniform3(0.1..5.0f64), inertias in prop::array::uniform3(0.01..2.0f64),
        stiffness in 1.0..500.0f64, push in -50.0..50.0f64,
    ) {
        prop_assume!(a + b.max(c).max(d) < 0.95 * (b + c + d - b.max(c).max(d)));
        let lengths = [a, b, c, d];
        let bodies = [0, 1, 2].map(|k| PlanarBody { mass: masses[k], inertia: inertias[k] });
        let mut mechanism = four_bar(lengths, bodies, turning(0, 0.0, speed, acceleration));
        mechanism.gravity = [0.7, -9.81];
        mechanism.loads = vec![
            PlanarLoad::Force { at: BodyPoint::body(1, [0.2, 0.3]), force: [push, 12.0], turns_with: Some(2) },
            PlanarLoad::Effort {
                measure: RelativeCoordinate::Distance { from: BodyPoint::ground([0.3, 2.5]), to: BodyPoint::body(1, [0.1, 0.4]) },
                effort: Effort::Spring { stiffness, free: 0.5 },
            },
        ];
        let at = drawn(lengths, [0.0, 0.9, 1.9]);
        let system = found(Model::new(&mechanism, &at));
        let first = found(system.assemble(&at));
        let there = found(system.continue_to(&first, &[angle]));
        mechanism.drivers[0].value = angle;
        let system = found(Model::new(&mechanism, &there.positions));
        let state = found(system.kinematics(&there.positions));
        let dynamics = found(system.inverse_dynamics(&state));
        let largest = dynamics.powers.iter().fold(0.0f64, |most, load| most.max(load.generalised[0].abs()));
        prop_assert!((dynamics.efforts[0] - dynamics.newton_euler[0]).abs() <= 1e-12 * largest);
        // What the loads and the driver bring in is the rate of the kinetic energy.
        let applied: f64 = dynamics.powers.iter().filter(|load| !matches!(load.of,
            dalembert_mechanics::planar::LoadId::InertiaForce(_) | dalembert_mechanics::planar::LoadId::InertiaCouple(_)))
            .map(|load| load.power).sum();
        let size = largest * speed.abs() + dynamics.energy_rate.abs();
        prop_assert!((applied + dynamics.efforts[0] * speed - dynamics.energy_rate).abs() <= 1e-11 * size);
        // The loops are closed, and what the joints hold does not move: their forces do no work.
        let joints = system.equations().len() - 1;
        for (equation, effort) in system.equations()[..joints].iter().zip_eq(&dynamics.multipliers[..joints]) {
            let [term] = &equation.terms[..] else { panic!("a pin is two measures") };
            prop_assert!(system.value(&term.measure, &there.positions).abs() <= 1e-12);
            let power = effort * system.rate(&term.measure, &state);
            prop_assert!(power.abs() <= 1e-12 * effort.abs() * speed.abs() * 3.0, "{}", power);
        }
    }

    /// Two turns at any step bring a crank-rocker back where it was, to rounding.
    #[test]
    fn the_branch_is_the_same_after_two_turns(step in 1.0..179.0f64, crossed in any::<bool>()) {
        let lengths = [0.04, 0.12, 0.08, 0.1];
        let mechanism = four_bar(lengths, [PlanarBody::default(); 3], turning(0, 1.0, 0.0, 0.0));
        let side = if crossed { -1.0 } else { 1.0 };
        let at = drawn(lengths, [1.0, side * 0.4, side * 1.2]);
        let system = found(Model::new(&mechanism, &at));
        let first = found(system.assemble(&at));
        let (mut here, mut angle) = (first.clone(), 1.0);
        let end = 1.0 + 2.0 * TAU;
        while angle < end {
            angle = (angle + step.to_radians()).min(end);
            let followed = found(system.continue_to(&here, &[angle]));
            prop_assert!(followed.change_points.is_empty());
            here = followed.positions;
        }
        for (now, then) in here.iter().zip_eq(&first) {
            prop_assert!((now[0] - then[0]).abs() <= 1e-12 && (now[1] - then[1]).abs() <= 1e-12);
            let turns = (now[2] - then[2]) / TAU;
            prop_assert!((turns - turns.round()).abs() <= 1e-11);
        }
    }

    /// A parallelogram goes on as a parallelogram through its change points.
    #[test]
    fn a_parallelogram_stays_one(step in 7.0..120.0f64) {
        goes_through_its_change_points(step);
    }
}

/// Steps that end 6·10⁻⁵ and 2·10⁻⁸ rad before a change point, where rounding is enlarged as much.
#[test]
fn a_parallelogram_goes_on_from_close_to_a_change_point() {
    for step in [75.6751601112484, 51.39102925217941, 111.24503821352727] {
        goes_through_its_change_points(step);
    }
}

fn goes_through_its_change_points(step: f64) {
    let lengths = [0.3, 0.5, 0.3, 0.5];
    let mechanism = four_bar(lengths, [PlanarBody::default(); 3], turning(0, 1.0, 0.0, 0.0));
    let at = drawn(lengths, [1.0, 0.0, 1.0]);
    let system = found(Model::new(&mechanism, &at));
    let (mut here, mut angle, mut passed) = (found(system.assemble(&at)), 1.0, 0);
    while angle < 1.0 + TAU {
        angle = (angle + step.to_radians()).min(1.0 + TAU);
        let followed = found(system.continue_to(&here, &[angle]));
        passed += followed.change_points.len();
        here = followed.positions;
        assert!(here[1][2].abs() < 1e-6, "the coupler has turned to {}", here[1][2]);
    }
    assert_eq!(passed, 2);
}

#[test]
fn velocities_and_accelerations_are_derivatives_of_the_positions() {
    let lengths = [0.04, 0.12, 0.08, 0.1];
    let at = |angle: f64| {
        let mechanism = four_bar(lengths, [PlanarBody::default(); 3], turning(0, angle, 1.0, 0.0));
        moving(&mechanism, &drawn(lengths, [angle, 0.3, 1.2])).1
    };
    let h = 1e-3;
    // Five points: the error is h⁴/30 of the fifth derivative.
    let [a, b, now, c, d] = [-2.0, -1.0, 0.0, 1.0, 2.0].map(|k| at(FRAC_PI_2 / 1.5 + k * h));
    for body in 0..3 {
        for part in 0..3 {
            let q = |state: &PlanarState| state.positions[body][part];
            let slope = (q(&a) - 8.0 * q(&b) + 8.0 * q(&c) - q(&d)) / (12.0 * h);
            assert!((slope - now.velocities[body][part]).abs() < 1e-10, "{slope}");
            let bend = (-q(&a) + 16.0 * q(&b) - 30.0 * q(&now) + 16.0 * q(&c) - q(&d)) / (12.0 * h * h);
            assert!((bend - now.accelerations[body][part]).abs() < 1e-8, "{bend}");
        }
    }
}

/// n bars of 1 m hung in a chain from (0, 0), drawn at these angles.
fn chain(angles: &[f64], loads: Vec<PlanarLoad>) -> (PlanarMechanism, Vec<[f64; 3]>) {
    let mut mechanism = PlanarMechanism { gravity: [0.0, -9.81], loads, ..PlanarMechanism::default() };
    let (mut drawn, mut end, mut last) = (Vec::new(), [0.0, 0.0], BodyPoint::ground([0.0, 0.0]));
    for (body, &angle) in angles.iter().enumerate() {
        let [a, b] = ends(body, 1.0, 0.5);
        mechanism.bodies.push(PlanarBody { mass: 3.0, inertia: 0.25 });
        mechanism.joints.push(PlanarJoint::Pin { a: last, b: a });
        mechanism.drivers.push(turning(body, angle, 0.0, 0.0));
        drawn.push([end[0] + 0.5 * angle.cos(), end[1] + 0.5 * angle.sin(), angle]);
        end = [end[0] + angle.cos(), end[1] + angle.sin()];
        last = b;
    }
    (mechanism, drawn)
}

#[test]
fn a_chain_of_bars_hangs_where_its_weights_and_the_pull_let_it() {
    // tan θ from the vertical is the pull over the weight that hangs below the middle of each bar.
    let pull = 1.5 * 3.0 * 9.81;
    let tip = BodyPoint::body(2, [0.5, 0.0]);
    let load = PlanarLoad::Force { at: tip, force: [pull, 0.0], turns_with: None };
    let (mechanism, drawn) = chain(&[-1.2, -0.9, -0.2], vec![load]);
    let system = found(Model::new(&mechanism, &drawn));
    let here = found(system.equilibrium_near(&found(system.assemble(&drawn))));
    for (value, ratio) in here.values.iter().zip_eq([1.5 / 2.5, 1.5 / 1.5, 1.5 / 0.5f64]) {
        close(*value, ratio.atan() - FRAC_PI_2, 1e-12);
    }
    assert_eq!(here.stability, Stability::Stable);
    // The stiffness is the second difference of the potential energy.
    let energy = |row: usize, column: usize, a: f64, b: f64| {
        let mut values = here.values.clone();
        values[row] += a;
        values[column] += b;
        let there = found(system.continue_to(&here.positions, &values));
        system.potential(&there.positions).expect("weights and a force have a potential")
    };
    let h = 1e-3;
    for row in 0..3 {
        for column in 0..3 {
            let mixed = (energy(row, column, h, h) - energy(row, column, h, -h) - energy(row, column, -h, h)
                + energy(row, column, -h, -h))
                / (4.0 * h * h);
            assert!((mixed - here.stiffness[(row, column)]).abs() < 1e-4 * here.stiffness[(0, 0)].abs());
        }
    }
}

#[test]
fn a_pendulum_has_its_two_places_of_rest() {
    let (mechanism, drawn) = chain(&[0.3], vec![]);
    let system = found(Model::new(&mechanism, &drawn));
    let positions = found(system.assemble(&drawn));
    let samples = found(system.samples(&positions, [-4.0, 4.0], 100));
    let places = found(system.equilibria(&samples));
    let judged: Vec<(f64, Stability)> =
        places.iter().map(|place| (place.values[0], place.stability)).collect();
    let mgl = 3.0 * 9.81 * 0.5;
    assert_eq!(judged.len(), 2);
    close(judged[0].0, -FRAC_PI_2, 1e-12);
    close(judged[1].0, FRAC_PI_2, 1e-12);
    assert_eq!([judged[0].1, judged[1].1], [Stability::Stable, Stability::Unstable]);
    close(places[0].stiffness[(0, 0)], mgl, ROUNDING);
    close(places[1].stiffness[(0, 0)], -mgl, ROUNDING);
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 200, failure_persistence: None, ..ProptestConfig::default() })]

    /// Every measure along a motion, differentiated by jets, moves as its derivative and its bias say.
    #[test]
    fn slopes_and_biases_are_those_of_jets(
        motion in prop::array::uniform2(prop::array::uniform3(prop::array::uniform3(-3.0..3.0f64))),
        points in prop::array::uniform2(prop::array::uniform2(-2.0..2.0f64)), turn in 0.0..TAU, kind in 0..4usize,
    ) {
        let [from, to] = [BodyPoint::body(0, points[0]), BodyPoint::body(1, points[1])];
        let direction = [turn.cos(), turn.sin()];
        let measure = [
            RelativeCoordinate::Angle { of: Some(1), against: Some(0) },
            RelativeCoordinate::Component { direction, from, to },
            RelativeCoordinate::Along { direction, from, to },
            RelativeCoordinate::Distance { from, to },
        ][kind];
        // Each body: x, y, θ, each with velocity and acceleration.
        let jets = motion.map(|body| Pose::new(body.map(Jet)));
        let Jet([value, rate, acceleration]) = measure.gradient([&jets[0], &jets[1]]).value;
        prop_assume!(kind != 3 || value > 0.1);
        let part = |k: usize| motion.map(|body| body.map(|coordinate| coordinate[k]));
        let poses = part(0).map(Pose::new);
        let slope = measure.gradient([&poses[0], &poses[1]]);
        let along = |[from, to]: [[f64; 3]; 2]| -> f64 {
            slope.from.iter().zip_eq(from).chain(slope.to.iter().zip_eq(to)).map(|(a, b)| a * b).sum()
        };
        let bias = measure.bias([&poses[0], &poses[1]], part(1));
        prop_assert!((slope.value - value).abs() <= 1e-13 * (1.0 + value.abs()));
        prop_assert!((along(part(1)) - rate).abs() <= 1e-12 * (1.0 + rate.abs()));
        prop_assert!((along(part(2)) + bias - acceleration).abs() <= 1e-11 * (1.0 + acceleration.abs()));
    }
}

#[test]
fn the_joints_of_a_linkage_carry_what_the_balance_of_its_links_says() {
    let (lengths, speed) = ([0.05, 0.151, 0.111, 0.1], 95.0);
    let [a, b, c, d] = lengths;
    let bodies = [(0.2, 1e-4), (0.5, 1.21e-3), (0.4, 0.91e-3)];
    let link = |k: usize, length: f64| LinkInertia {
        mass: bodies[k].0,
        distance: length / 2.0,
        offset: 0.0,
        inertia: bodies[k].1,
    };
    let linkage = Linkage {
        crank: a,
        coupler: b,
        crank_link: link(0, a),
        coupler_link: link(1, b),
        follower: Follower::Rocker { frame: d, length: c, crossed: false, link: link(2, c) },
    };
    for angle in [0.4, 2.1, 3.9, 5.5] {
        let pose = linkage.pose(angle, speed).expect("the loop closes");
        let bodies = bodies.map(|(mass, inertia)| PlanarBody { mass, inertia });
        let mechanism = four_bar(lengths, bodies, turning(0, angle, speed, 0.0));
        let (system, state) = moving(&mechanism, &drawn(lengths, pose.angles));
        let dynamics = found(system.inverse_dynamics(&state));
        let shaking = linkage.shaking(&pose, &[]);
        let largest = dynamics.multipliers.iter().fold(0.0f64, |most, force| most.max(force.abs()));
        for (joint, force) in shaking.joints.iter().enumerate() {
            for (component, force) in force.iter().enumerate() {
                let held = dynamics.multipliers[2 * joint + component];
                assert!((force - held).abs() <= 1e-11 * largest, "joint {joint}: {force} and {held}");
            }
        }
        close(shaking.torque, dynamics.efforts[0], 1e-11);
    }
}
