//! The cones of a free body of revolution, in section and in space.

use std::f64::consts::{FRAC_PI_2, TAU};

use dalembert_core::{Drawing, Exhibit, Ink, Sketch};
use dalembert_mechanics::rigid::torque_free;
use nalgebra::{Rotation3, Vector3};

use super::{AxisymmetricInertia, FreeAxisymmetric, angles};
use crate::shared::{
    flat,
    scene::{self, Scene},
};

impl FreeAxisymmetric {
    /// The plane of axis, angular velocity and angular momentum: H to the right.
    pub(super) fn cones_in_section(&self, ratio: f64, omega: Vector3<f64>) -> Drawing {
        let (theta, beta) = angles(ratio, omega);
        let [axial, transverse] = self.letters();
        let at = |angle: f64, length: f64| (length * angle.cos(), length * angle.sin());
        let (origin, velocity) = ((0.0, 0.0), theta - beta);
        let title = if ratio < 1.0 {
            "Body cone (about z) and space cone (about H) in section: direct precession"
        } else {
            "Body cone (about z) and space cone (about H) in section: retrograde precession"
        };
        let mut sketch = Sketch::new(title);
        sketch
            .line("", origin, at(theta, 1.3), Ink::Faint)
            .label(flat::letters(&["z", axial]), at(theta, 1.3))
            .line("", origin, at(theta + FRAC_PI_2, 0.4), Ink::Faint)
            .label(transverse, at(theta + FRAC_PI_2, 0.4))
            .bars([origin, at(velocity, 1.0), at(theta + beta, 1.0), origin])
            .curve([at(velocity, 1.0), at(-velocity, 1.0), origin], Ink::Motion)
            .force("H_G", origin, (1.45, 0.0))
            .vector("ω", origin, at(velocity, 1.2), Ink::Result)
            .mass_centre("G", origin);
        let mut arc = |from: f64, to: f64, radius: f64, name: &'static str| {
            if (to - from).abs() > 1e-3 {
                let (low, high) = (from.min(to), from.max(to));
                sketch
                    .arc(origin, radius, (low, high), Ink::Faint)
                    .label(name, at(f64::midpoint(from, to), radius));
            }
        };
        arc(0.0, theta, 0.75, "θ");
        arc(velocity, theta, 0.5, "β");
        sketch.finish()
    }

    /// The letters of what is given about the axis, and across it.
    fn letters(&self) -> [&'static str; 2] {
        match self.inertia {
            AxisymmetricInertia::Moments { .. } => ["I_a", "I_t"],
            AxisymmetricInertia::Gyration { .. } => ["m, k_a", "k_t"],
            AxisymmetricInertia::Shape { .. } => ["m", ""],
            AxisymmetricInertia::Ratio { .. } => ["", ""],
        }
    }
}

/// One precession: the body cone rolls on the space cone, the angular velocity along their common line.
pub(super) fn rolling_cones(ratio: f64, omega: Vector3<f64>) -> Exhibit {
    let (theta, beta) = angles(ratio, omega);
    let precession = torque_free::precession(ratio, omega.z, omega.xy().norm());
    let spin = torque_free::spin(ratio, omega.z.abs());
    let about = |axis, angle| Rotation3::from_axis_angle(&axis, angle);
    scene::animation("The body cone rolls on the space cone", 6.0, |part| {
        let nodes = about(Vector3::z_axis(), TAU * part) * about(Vector3::x_axis(), theta);
        let turn = nodes * about(Vector3::z_axis(), TAU * part * spin / precession);
        let (axis, line) = (nodes * Vector3::z(), nodes * Vector3::new(0.0, beta.sin(), beta.cos()));
        let mut scene = Scene::new();
        let space = (theta - beta).abs();
        scene.cone(Vector3::zeros(), Vector3::z() * space.cos(), space.sin(), Ink::Motion);
        scene.cone(Vector3::zeros(), axis * beta.cos(), beta.sin(), Ink::Body);
        scene.disc(axis * beta.cos(), turn.matrix(), beta.sin(), Ink::Body);
        scene.arrow(Vector3::zeros(), Vector3::z() * 1.4, Ink::Force, "H_G");
        scene.arrow(Vector3::zeros(), line * 1.25, Ink::Result, "ω");
        scene.arrow(Vector3::zeros(), axis * 1.3, Ink::Faint, "z");
        scene
    })
}
