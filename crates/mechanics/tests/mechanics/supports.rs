//! Reactions of supports: they balance, they do not depend on the axes, and what cannot be reported is refused by name.

use dalembert_mechanics::rigid::{
    Axis, RigidError,
    supports::{ReactionUnknown, SupportError, Supports, Wrench},
};
use itertools::Itertools as _;
use nalgebra::{Rotation3, Vector3};
use proptest::prelude::*;

use crate::close::{close, found};

fn force(at: [f64; 3], along: [f64; 3]) -> ReactionUnknown {
    ReactionUnknown::Force { at: at.into(), along: along.into() }
}

const X: [f64; 3] = [1.0, 0.0, 0.0];
const Y: [f64; 3] = [0.0, 1.0, 0.0];
const Z: [f64; 3] = [0.0, 0.0, 1.0];

/// A shaft along x with a bearing at 0 that takes the axial force, and one at `length`.
fn shaft(length: f64) -> Vec<ReactionUnknown> {
    let (a, b) = ([0.0; 3], [length, 0.0, 0.0]);
    vec![force(a, X), force(a, Y), force(a, Z), force(b, Y), force(b, Z)]
}

#[test]
fn a_weight_between_two_bearings_is_shared_by_the_lever() {
    let supports = found(Supports::new(shaft(4.0)));
    assert_eq!(supports.degrees_of_freedom(), 1);
    let weight = Wrench::force_at(Vector3::new(0.0, 0.0, -100.0), Vector3::new(1.0, 0.0, 0.0));
    let x = found(supports.reactions(&weight));
    close(x[2], 75.0, 1e-14);
    close(x[4], 25.0, 1e-14);
    assert!(x[0] == 0.0 && x[1] == 0.0 && x[3] == 0.0);
}

#[test]
fn what_the_bearings_leave_free_is_named() {
    let supports = found(Supports::new(shaft(4.0)));
    // Beside the axis the weight turns the shaft.
    let weight = Wrench::force_at(Vector3::new(0.0, 0.0, -100.0), Vector3::new(1.0, 0.5, 0.0));
    assert_eq!(supports.reactions(&weight), Err(SupportError::Mechanism { turning: true, axis: Axis::X }));
    assert!(!supports.hold_against(Vector3::x()));
    assert!(supports.hold_against(Vector3::y()));
    let sliding = found(Supports::new(shaft(4.0)[1..].to_vec()));
    let push = Wrench::force_at(Vector3::x(), Vector3::zeros());
    assert_eq!(sliding.reactions(&push), Err(SupportError::Mechanism { turning: false, axis: Axis::X }));
    assert_eq!(sliding.degrees_of_freedom(), 2);
}

#[test]
fn two_axial_bearings_are_indeterminate_and_only_the_axial_forces_take_part() {
    let mut unknowns = shaft(4.0);
    unknowns.push(force([4.0, 0.0, 0.0], X));
    let refused = Supports::new(unknowns).expect_err("one equation for two forces");
    assert_eq!(refused, SupportError::Indeterminate { missing: 1, unknowns: vec![0, 5] });
}

#[test]
fn three_bearings_are_indeterminate_however_far_apart() {
    for length in [1e-9, 1.0, 1e9] {
        let mut unknowns = shaft(length);
        unknowns.push(force([length / 2.0, 0.0, 0.0], Z));
        let refused = Supports::new(unknowns).expect_err("three forces of one plane");
        assert_eq!(refused, SupportError::Indeterminate { missing: 1, unknowns: vec![2, 4, 5] });
    }
}

#[test]
fn numbers_that_are_not_finite_are_refused() {
    let refused = Supports::new(vec![force([f64::NAN, 0.0, 0.0], Z)]).expect_err("NaN");
    assert_eq!(refused, SupportError::Data(RigidError::NotFinite));
}

fn vector() -> impl Strategy<Value = Vector3<f64>> {
    prop::array::uniform3(-1.0..1.0f64).prop_map(Vector3::from)
}

proptest! {
    /// A ball-and-socket, a bearing and a wire anywhere: the six equations balance, and in other axes the forces
    /// are the same ones turned.
    #[test]
    fn six_equations_balance_in_any_axes(
        a in vector(), b in vector(), c in vector(), shaft in vector(), wire in vector(),
        load in vector(), at in vector(), couple in vector(), turn in vector(), by in vector(), size in -6.0..6.0f64,
    ) {
        prop_assume!(shaft.norm() > 0.2 && wire.norm() > 0.2 && turn.norm() > 0.1);
        let shaft = shaft.normalize();
        let near = if shaft.z.abs() > 0.7 { Vector3::x() } else { Vector3::z() };
        let first = shaft.cross(&near).normalize();
        let scale = 10f64.powf(size);
        let unknowns: Vec<ReactionUnknown> = [X, Y, Z]
            .map(|axis| ReactionUnknown::Force { at: a * scale, along: axis.into() })
            .into_iter()
            .chain([first, shaft.cross(&first)].map(|along| ReactionUnknown::Force { at: b * scale, along }))
            .chain([ReactionUnknown::Force { at: c * scale, along: wire.normalize() }])
            .collect();
        let load = Wrench::force_at(load, at * scale) + Wrench::couple(couple * scale);
        let Ok(supports) = Supports::new(unknowns.clone()) else { return Ok(()) };
        let Ok(x) = supports.reactions(&load) else { return Ok(()) };
        let sum = unknowns.iter().zip_eq(&x).fold(load, |sum, (unknown, x)| {
            let one = unknown.wrench();
            sum + Wrench { force: one.force * *x, moment: one.moment * *x }
        });
        let most = x.iter().fold(1.0f64, |most, x| most.max(x.abs()));
        prop_assert!(sum.force.norm() < 1e-12 * most, "{sum:?} of {most}");
        prop_assert!(sum.moment.norm() < 1e-12 * most * scale * 3.0, "{sum:?} of {most}");
        // The same in axes that were turned and moved.
        let rotation = Rotation3::new(turn);
        let there = |point: Vector3<f64>| rotation * (point + by * scale);
        let moved: Vec<ReactionUnknown> = unknowns
            .iter()
            .map(|unknown| match unknown {
                ReactionUnknown::Force { at, along } => ReactionUnknown::Force { at: there(*at), along: rotation * along },
                ReactionUnknown::Couple { about } => ReactionUnknown::Couple { about: rotation * about },
            })
            .collect();
        let force = rotation * load.force;
        let moment = rotation * load.moment + (rotation * (by * scale)).cross(&force);
        let again = found(found(Supports::new(moved)).reactions(&Wrench { force, moment }));
        // Nearly dependent supports lose the digits that their condition costs.
        if most < 1e3 {
            for (p, q) in x.iter().zip_eq(&again) {
                prop_assert!((p - q).abs() < 1e-8 * most, "{x:?} and {again:?}");
            }
        }
    }
}
