//! Chains of joints against differences, printed angular velocities and other ways to the same vectors.

use dalembert_mechanics::rigid::{
    RigidError,
    chain::{self, ChainJoint, frames, turned_about},
    numerical_rate,
};
use nalgebra::{Matrix3, Rotation3, Unit, Vector3};
use proptest::prelude::*;

use crate::close::found;

fn joint(axis: [f64; 3], angle: f64, rate: f64, acceleration: f64, offset: [f64; 3]) -> ChainJoint {
    ChainJoint { axis: axis.into(), angle, rate, acceleration, offset: offset.into() }
}

fn near(ours: Vector3<f64>, other: Vector3<f64>, scale: f64) {
    assert!((ours - other).norm() <= scale, "{ours:?} is not {other:?} to {scale:e}");
}

#[test]
fn a_motor_on_a_tilted_axis() {
    // Meriam & Kraige, sample problem 7/2: 60 rpm about an axis 30° above y, 120 rpm about z.
    let turn = std::f64::consts::PI / 30.0;
    let all = found(frames(&[
        joint([0.0, 3f64.sqrt(), 1.0], 0.0, 60.0 * turn, 0.0, [0.0; 3]),
        joint([0.0, 0.0, 1.0], 0.0, 120.0 * turn, 0.0, [0.0; 3]),
    ]));
    near(all[2].angular_velocity, Vector3::new(0.0, 5.44, 15.71), 0.005);
    near(all[2].angular_acceleration, Vector3::new(68.4, 0.0, 0.0), 0.05);
}

#[test]
fn an_axis_without_length_is_refused() {
    assert_eq!(frames(&[joint([0.0; 3], 0.0, 1.0, 0.0, [0.0; 3])]), Err(RigidError::Direction));
    assert_eq!(
        frames(&[
            joint([1.0, 0.0, 0.0], 0.0, 1e300, 0.0, [0.0; 3]),
            joint([0.0, 1.0, 0.0], 0.0, 1e300, 0.0, [0.0; 3])
        ]),
        Err(RigidError::NotFinite)
    );
}

fn any_joint() -> impl Strategy<Value = ChainJoint> {
    let axis = prop::array::uniform3(-1.0..1.0f64).prop_filter("length", |v| v.iter().any(|x| x.abs() > 0.1));
    let offset = prop::array::uniform3(-1.0..1.0f64);
    (axis, -3.0..3.0f64, -5.0..5.0f64, -5.0..5.0f64, offset)
        .prop_map(|(axis, angle, rate, acceleration, offset)| joint(axis, angle, rate, acceleration, offset))
}

proptest! {
    #[test]
    fn every_rate_is_a_difference_quotient(joints in prop::collection::vec(any_joint(), 1..5), at in prop::array::uniform3(-1.0..1.0f64)) {
        let at = Vector3::from(at);
        let all = |t: f64| found(frames(&joints.iter().map(|joint| joint.after(t)).collect::<Vec<_>>()));
        let end = |t: f64| *all(t).last().expect("there is a fixed frame");
        let (now, period) = (end(0.0), chain::period(&joints));
        let speed = std::f64::consts::TAU / period;
        let point = now.point(at);
        near(point.velocity, found(numerical_rate(|t| end(t).point(at).place, period)), 1e-10 * 6.0 * speed);
        near(
            point.acceleration,
            found(numerical_rate(|t| end(t).point(at).velocity, period)),
            1e-10 * 6.0 * speed.powi(2),
        );
        near(
            now.angular_acceleration,
            found(numerical_rate(|t| end(t).angular_velocity, period)),
            1e-10 * speed.powi(2),
        );
        // Poisson: ė = ω × e for every axis of the frame.
        for n in 0..3 {
            let axis = |t: f64| -> Vector3<f64> { end(t).rotation.matrix().column(n).into_owned() };
            near(now.angular_velocity.cross(&axis(0.0)), found(numerical_rate(axis, period)), 1e-10 * speed);
        }
    }

    #[test]
    fn rotations_stay_orthonormal(joints in prop::collection::vec(any_joint(), 1..8)) {
        let end = *found(frames(&joints)).last().expect("there is a fixed frame");
        let rotation = end.rotation.matrix();
        prop_assert!((rotation.transpose() * rotation - Matrix3::identity()).amax() < 1e-14);
    }

    #[test]
    fn the_formula_of_rodrigues_is_the_rotation_and_goes_back(axis in prop::array::uniform3(-1.0..1.0f64), angle in -7.0..7.0f64, vector in prop::array::uniform3(-9.0..9.0f64)) {
        let axis = Vector3::from(axis);
        prop_assume!(axis.norm() > 0.1);
        let (axis, vector) = (axis.normalize(), Vector3::from(vector));
        let turned = turned_about(axis, angle, vector);
        near(turned, Rotation3::from_axis_angle(&Unit::new_unchecked(axis), angle) * vector, 1e-14 * 20.0);
        near(turned_about(axis, -angle, turned), vector, 1e-14 * 20.0);
    }

    #[test]
    fn the_steps_of_a_turn_may_be_split(axis in prop::array::uniform3(0.1..1.0f64), whole in -3.0..3.0f64, share in 0.0..1.0f64, rate in -5.0..5.0f64) {
        // Two joints about one axis are one joint with the sum of their angles and rates.
        let one = found(frames(&[joint(axis, whole, rate, 0.0, [0.0; 3])]));
        let two = found(frames(&[
            joint(axis, whole * share, rate * share, 0.0, [0.0; 3]),
            joint(axis, whole * (1.0 - share), rate * (1.0 - share), 0.0, [0.0; 3]),
        ]));
        near(two[2].angular_velocity, one[1].angular_velocity, 1e-14 * 10.0);
        near(two[2].angular_acceleration, Vector3::zeros(), 1e-14 * 50.0);
        prop_assert!((two[2].rotation.matrix() - one[1].rotation.matrix()).amax() < 1e-14);
    }
}
