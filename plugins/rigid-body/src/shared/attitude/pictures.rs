//! Both frames and the principal axis.

use dalembert_core::{Exhibit, Ink};
use nalgebra::{Matrix3, Rotation3, Unit, Vector3};

use super::rotations::plain_parameters;
use crate::shared::scene::{self, Scene};

/// Both frames and the principal axis, from the first attitude to the last.
pub(crate) fn frames(title: &'static str, c: &Matrix3<f64>) -> Exhibit {
    let (scalar, vector) = plain_parameters(c);
    let angle = 2.0 * vector.norm().atan2(scalar);
    let axis = vector.try_normalize(1e-9);
    scene::animation(title, 4.0, |part| {
        let turned = axis.map_or_else(Rotation3::identity, |axis| {
            Rotation3::from_axis_angle(&Unit::new_unchecked(axis), angle * part)
        });
        both(turned.matrix(), axis)
    })
}

/// Frame N, frame B along the columns of a matrix, and the principal axis.
pub(crate) fn both(body: &Matrix3<f64>, axis: Option<Vector3<f64>>) -> Scene {
    let mut scene = Scene::new();
    let origin = Vector3::zeros();
    scene.axes(origin, &Matrix3::identity(), 1.0, ["n₁", "n₂", "n₃"]);
    for (n, name) in ["b₁", "b₂", "b₃"].into_iter().enumerate() {
        scene.arrow(origin, body.column(n).into(), Ink::Motion, name);
    }
    if let Some(axis) = axis {
        scene.line([-axis * 1.2, axis * 1.2], Ink::Result);
        scene.label(axis * 1.2, "e");
    }
    scene
}
