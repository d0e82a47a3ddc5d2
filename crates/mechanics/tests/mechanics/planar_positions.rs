//! Positions of plane mechanisms: their scale, the guess they are found from, and those that a driver cannot leave.

use dalembert_mechanics::planar::{
    BodyPoint, Driver, Model, PlanarBody, PlanarError, PlanarJoint, PlanarMechanism, Pose, RelativeCoordinate,
};
use itertools::Itertools as _;

use crate::{
    close::{ROUNDING, close, found},
    planar::{ends, moving, slider_crank_joints, turning},
};

#[test]
fn a_larger_drawing_has_larger_lengths_and_the_same_angles() {
    let measures = |scale: f64| {
        let from = BodyPoint::body(0, [0.3 * scale, -0.2 * scale]);
        let to = BodyPoint::body(1, [-0.5 * scale, 0.4 * scale]);
        let direction = [0.6, 0.8];
        [
            RelativeCoordinate::Angle { of: Some(1), against: Some(0) },
            RelativeCoordinate::Component { direction, from, to },
            RelativeCoordinate::Along { direction, from, to },
            RelativeCoordinate::Distance { from, to },
            RelativeCoordinate::Bearing { from, to },
        ]
    };
    let value = |measure: &RelativeCoordinate, scale: f64| {
        let poses: [Pose<f64>; 2] = [[0.4, -0.7, 0.9], [1.5, 0.6, 2.3]]
            .map(|[x, y, angle]: [f64; 3]| Pose::new([x * scale, y * scale, angle]));
        measure.gradient([&poses[0], &poses[1]]).value
    };
    for (small, large) in measures(1.0).iter().zip_eq(&measures(3.7)) {
        let growth = if small.is_angle() { 1.0 } else { 3.7 };
        close(value(large, 3.7), growth * value(small, 1.0), ROUNDING);
    }
}

/// A block on an inclined line at the end of a rod: the distance of its pins makes the guess an iteration.
#[test]
fn a_guess_satisfies_the_joints_of_a_mechanism_of_any_size() {
    let (crank, line) = (0.9f64, 0.3f64);
    for scale in [1e-6, 1.0, 1e4] {
        let [arm, rod, lift] = [0.15, 0.4, 0.02].map(|length: f64| length * scale);
        let ([o, p], block) = (ends(0, 2.0 * arm, arm), BodyPoint::body(1, [0.0, 0.0]));
        let mechanism = PlanarMechanism {
            bodies: vec![PlanarBody::default(); 2],
            joints: vec![
                PlanarJoint::Pin { a: BodyPoint::ground([0.0, 0.0]), b: o },
                PlanarJoint::Slider {
                    guide: BodyPoint::ground([0.0, lift]),
                    direction: line,
                    slides: block,
                    angle: line,
                },
                PlanarJoint::Rod { from: p, to: block, length: rod },
            ],
            ..PlanarMechanism::default()
        };
        let guess = found(Model::initial_guess(&mechanism, &[crank, line], &[]));
        let ([x, y, _], [u, v, _]) = (guess.positions[0], guess.positions[1]);
        close(x, arm * crank.cos(), 1e-8);
        close(y, arm * crank.sin(), 1e-8);
        close((u - x - arm * crank.cos()).hypot(v - y - arm * crank.sin()), rod, 1e-8);
        assert!((line.cos() * (v - lift) - line.sin() * u).abs() < 1e-8 * scale);
    }
}

#[test]
fn a_slider_cannot_move_its_crank_from_a_dead_centre_but_the_crank_can() {
    let (r, l) = (0.15, 0.4);
    let drawn = [[0.0, 0.0, 0.0], [r + l / 2.0, 0.0, 0.0], [r + l, 0.0, 0.0]];
    let by = |driver: Driver| PlanarMechanism {
        bodies: vec![PlanarBody::default(); 3],
        joints: slider_crank_joints(ends(0, r, 0.0), ends(1, l, l / 2.0)),
        drivers: vec![driver],
        ..PlanarMechanism::default()
    };
    let (_, state) = moving(&by(turning(0, 0.0, 7.0, 0.0)), &drawn);
    assert!(state.velocities[2][0].abs() < 1e-13);
    close(state.velocities[1][2], -7.0 * r / l, ROUNDING);
    let pushed = by(Driver {
        measure: RelativeCoordinate::Component {
            direction: [1.0, 0.0],
            from: BodyPoint::ground([0.0, 0.0]),
            to: BodyPoint::body(2, [0.0, 0.0]),
        },
        value: r + l,
        velocity: 0.3,
        acceleration: 0.0,
    });
    let system = found(Model::new(&pushed, &drawn));
    assert_eq!(system.kinematics(&drawn), Err(PlanarError::DeadCentre { driver: 0 }));
}
