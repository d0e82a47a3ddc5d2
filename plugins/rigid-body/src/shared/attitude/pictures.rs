//! Both frames and the principal axis.

use dalembert_core::{Exhibit, Ink};
use nalgebra::{Matrix3, Rotation3, Unit, Vector3};

use super::{
    description::{AttitudeInput, SingleAttitude},
    euler::{EulerSequence, unit},
    rotations::plain_parameters,
};
use crate::shared::scene::{self, Scene};

/// Both frames and the principal axis, from the first attitude to the last.
pub(crate) fn frames(title: &'static str, c: &Matrix3<f64>, attitude: &AttitudeInput) -> Exhibit {
    let (scalar, vector) = plain_parameters(c);
    let angle = 2.0 * vector.norm().atan2(scalar);
    let axis = vector.try_normalize(1e-9);
    scene::animation(title, 4.0, |part| {
        let turned = axis.map_or_else(Rotation3::identity, |axis| {
            Rotation3::from_axis_angle(&Unit::new_unchecked(axis), angle * part)
        });
        let mut scene = both(turned.matrix(), axis);
        match attitude {
            AttitudeInput::One(SingleAttitude::EulerAngles { sequence, first, second, third }) => {
                euler_arcs(*sequence, [*first, *second, *third], &mut scene);
            }
            AttitudeInput::One(SingleAttitude::PrincipalRotation { .. }) => {
                if let Some(axis) = axis {
                    scene.turn("φ", axis * 0.9, axis, 0.2, Ink::Result);
                }
            }
            _ => {}
        }
        scene
    })
}

/// The successive rotations of Euler's angles as arcs about their axes, each from the frame that the one before it left.
fn euler_arcs(sequence: EulerSequence, angles: [f64; 3], scene: &mut Scene) {
    let axes = sequence.axes();
    let mut before = Rotation3::identity();
    for (n, name) in ["α₁", "α₂", "α₃"].into_iter().enumerate() {
        let axis = before * unit(axes[n]);
        // From the axis that is turned away from: the next one of the sequence, or any other across.
        let across = if n < 2 { unit(axes[n + 1]) } else { unit((axes[n] + 1) % 3) };
        let from = before * across;
        let turn = Rotation3::from_axis_angle(&Unit::new_normalize(axis), angles[n]);
        before = turn * before;
        scene.angle(name, Vector3::zeros(), [from, turn * from], 0.65 - 0.15 * n as f64);
    }
}

/// Frame N, frame B along the columns of a matrix, and the principal axis.
pub(crate) fn both(body: &Matrix3<f64>, axis: Option<Vector3<f64>>) -> Scene {
    let mut scene = Scene::new();
    let origin = Vector3::zeros();
    scene.axes(origin, &Matrix3::identity(), 1.0, ["n₁", "n₂", "n₃"]);
    for (n, name) in ["b₁", "b₂", "b₃"].into_iter().enumerate() {
        // Shorter than those of N, so that letters stand apart where the frames nearly coincide.
        scene.arrow(origin, body.column(n) * 0.85, Ink::Motion, name);
    }
    if let Some(axis) = axis {
        scene.line([origin, axis * 1.2], Ink::Result);
        scene.label(axis * 1.2, "e");
    }
    scene
}
