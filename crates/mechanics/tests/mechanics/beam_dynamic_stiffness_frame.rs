//! Tests of `beam::dynamic_stiffness::frame`.

use dalembert_mechanics::beam::dynamic_stiffness::{
    frame::*,
    spans::{Span, SpanJoint, Spans},
};
use itertools::Itertools as _;

fn member(from: usize, to: usize) -> FrameMember {
    FrameMember {
        joints: [from, to],
        hinged: [false, false],
        bending: 1.0,
        axial: 2000.0,
        mass: 1.0,
        shear: 0.0,
        rotary: 0.0,
    }
}

/// A portal with a leaning column and a mass, turned by an angle.
fn portal(angle: f64, theory: [f64; 2]) -> Frame {
    let places = [[0.0, 0.0], [0.1, 1.0], [1.3, 1.0], [1.3, -0.2]];
    let (sin, cos) = angle.sin_cos();
    let joint =
        |[x, y]: [f64; 2]| FrameJoint { at: [cos * x - sin * y, sin * x + cos * y], ..FrameJoint::default() };
    let mut joints = places.map(joint);
    joints[0].held = [true; 3];
    joints[3].held = [true, true, false];
    joints[2].mass = 0.4;
    joints[2].inertia = 0.01;
    let [shear, rotary] = theory;
    let members = [member(0, 1), member(1, 2), member(2, 3)].map(|own| FrameMember { shear, rotary, ..own });
    Frame { joints: joints.to_vec(), members: members.to_vec() }
}

#[test]
fn a_turned_frame_has_the_same_roots() {
    for theory in [[0.0; 2], [0.004, 0.001]] {
        let first = portal(0.0, theory).roots(8).unwrap();
        for angle in [0.3, 1.7, -2.4] {
            for (root, other) in first.iter().zip_eq(portal(angle, theory).roots(8).unwrap()) {
                assert!((root / other - 1.0).abs() < 1e-11, "{theory:?} {angle} {root} {other}");
            }
        }
    }
}

#[test]
fn finite_elements_come_down_to_the_roots() {
    let frame = portal(0.4, [0.0; 2]);
    let roots = frame.roots(6).unwrap();
    let mut last = [f64::INFINITY; 6];
    for parts in [2, 4, 8] {
        let lambdas = frame.finite_elements(parts, 6).unwrap();
        for ((root, lambda), last) in roots.iter().zip_eq(lambdas).zip_eq(&mut last) {
            let off = lambda.sqrt() / root.powi(2) - 1.0;
            assert!(-1e-11 < off && off < *last, "{parts} {root} {off}");
            *last = off;
        }
    }
    assert!(last.iter().all(|off| *off < 5e-4), "{last:?}");
}

#[test]
fn shapes_have_the_quotient_of_their_root_and_are_orthogonal() {
    let frame = portal(0.4, [0.004, 0.001]);
    let roots = frame.roots(6).unwrap();
    let shapes = frame.shapes(&roots).unwrap();
    for (n, (root, shape)) in roots.iter().zip_eq(&shapes).enumerate() {
        assert!((shape.rayleigh_quotient() / root.powi(4) - 1.0).abs() < 1e-11);
        for other in &shapes[..n] {
            let size = shape.inertia_product(shape) * other.inertia_product(other);
            assert!(shape.inertia_product(other).abs() < 1e-9 * size.sqrt());
        }
    }
}

/// A straight frame that stretches little has the roots of the beam; one that is divided has those of the whole.
#[test]
fn a_straight_frame_is_the_beam() {
    let joint = |x: f64, held: [bool; 3]| FrameJoint { at: [x, 0.0], held, ..FrameJoint::default() };
    let stiff = |from, to| FrameMember { axial: 1e7, ..member(from, to) };
    let frame = Frame {
        joints: vec![joint(0.0, [true; 3]), joint(0.7, [false; 3]), joint(2.0, [true, true, false])],
        members: vec![stiff(0, 1), stiff(1, 2)],
    };
    let span = |length| Span { length, bending: 1.0, mass: 1.0, axial: 0.0, foundation: 0.0 };
    let clamp = SpanJoint { held: true, clamped: true, ..SpanJoint::default() };
    let pin = SpanJoint { held: true, ..SpanJoint::default() };
    let beam = Spans { spans: vec![span(2.0)], joints: vec![clamp, pin] };
    for (root, expected) in frame.roots(4).unwrap().into_iter().zip_eq(beam.roots(4).unwrap()) {
        assert!((root / expected - 1.0).abs() < 1e-11, "{root} {expected}");
    }
    assert_eq!(frame.rigid_motions(), Ok(0));
}

#[test]
fn motions_without_deformation_are_counted() {
    let free = |x: f64, y: f64| FrameJoint { at: [x, y], ..FrameJoint::default() };
    let joints = vec![free(0.0, 0.0), free(1.0, 0.0), free(1.0, 1.0)];
    let mut frame = Frame { joints, members: vec![member(0, 1), member(1, 2)] };
    assert_eq!(frame.rigid_motions(), Ok(3));
    frame.members[1].hinged = [true, false];
    assert_eq!(frame.rigid_motions(), Ok(4));
    frame.joints[0].held = [true; 3];
    assert_eq!(frame.rigid_motions(), Ok(1));
}
