//! Drawings of a free body.

use std::f64::consts::FRAC_PI_2;

use dalembert_core::{Axis, Exhibit, Ink, Plot, Series};
use dalembert_mechanics::{Vector as _, rigid::torque_free::FreeBody};
use nalgebra::{Matrix3, Vector3};

use crate::shared::scene::{self, Scene};

/// Two periods, or some turns of a rotation that has none.
pub(super) fn shown_time(body: &FreeBody, start: Vector3<f64>) -> f64 {
    let turns = 8.0 * FRAC_PI_2 / start.norm();
    if body.period().is_finite() { 2.0 * body.period() } else { 2.0 * turns }
}

pub(super) fn components(body: &FreeBody, shown: f64) -> Plot {
    let along = |axis: usize| {
        (0..=240)
            .map(|n| shown * f64::from(n) / 240.0)
            .map(|t| (t, body.velocity(t)[axis]))
            .collect::<Vec<_>>()
    };
    let plot = Plot::new(
        "Angular velocity in principal axes",
        Axis::linear("time", "s"),
        Axis::linear("angular velocity", "rad/s"),
        [("ω_x", "velocity.x"), ("ω_y", "velocity.y"), ("ω_z", "velocity.z")]
            .into_iter()
            .enumerate()
            .map(|(n, (name, answer))| Series::line(name, along(n)).of(answer))
            .collect(),
    )
    .over("instant");
    match body.first_flip() {
        Some(flip) if flip <= shown => plot.mark("first flip", (flip, 0.0)),
        _ => plot,
    }
}

/// The tip of the angular velocity on the plane normal to the angular momentum.
pub(super) fn herpolhode(body: &FreeBody, inertia: Vector3<f64>, start: Vector3<f64>, shown: f64) -> Plot {
    let frame = fixed_frame(inertia, start);
    let points = (0..=400)
        .map(|n| shown * f64::from(n) / 400.0)
        .map(|t| frame.transpose() * (body.attitude(t) * body.velocity(t)))
        .map(|omega| (omega.x, omega.y))
        .collect();
    Plot::new(
        "Herpolhode: the tip of the angular velocity, seen along the angular momentum",
        Axis::linear("normal to H", "rad/s"),
        Axis::linear("normal to H and to the first", "rad/s"),
        vec![Series::line("herpolhode", points)],
    )
    .equal()
}

/// Fixed axes with the third along the angular momentum; it is what all of the animation is drawn in.
fn fixed_frame(inertia: Vector3<f64>, start: Vector3<f64>) -> Matrix3<f64> {
    let momentum = inertia.component_mul(&start).normalize();
    let away = if momentum.x.abs() < 0.9 { Vector3::x() } else { Vector3::y() };
    let first = (away - momentum * momentum.dot(away)).normalize();
    Matrix3::from_columns(&[first, momentum.cross(first), momentum])
}

/// The inertia ellipsoid rolls on the plane normal to the angular momentum; the polhode is drawn on it.
pub(super) fn poinsot(
    body: &FreeBody,
    (inertia, names): (Vector3<f64>, [&'static str; 3]),
    start: Vector3<f64>,
    shown: f64,
) -> Exhibit {
    let frame = fixed_frame(inertia, start);
    // The ellipsoid ω·I ω = 2T, its longest semi-axis one unit.
    let energy = start.dot(inertia.component_mul(&start));
    let half = inertia.map(|moment| (energy / moment).sqrt());
    let unit = half.amax();
    let polhode: Vec<Vector3<f64>> =
        (0..=80).map(|n| body.velocity(shown * f64::from(n) / 160.0) / unit).collect();
    let plane = energy / inertia.component_mul(&start).norm() / unit;
    scene::animation("Poinsot: the inertia ellipsoid rolls on the plane normal to H", 8.0, |part| {
        let t = shown / 2.0 * part;
        let turn = frame.transpose() * body.attitude(t).matrix();
        let mut scene = Scene::new();
        scene.floor(Vector3::z() * plane, 0.7);
        scene.ellipsoid(Vector3::zeros(), &turn, half / unit, Ink::Body);
        scene.axes(Vector3::zeros(), &turn, 1.2, names);
        scene.line(polhode.iter().map(|point| turn * point), Ink::Motion);
        scene.arrow(Vector3::zeros(), Vector3::z() * 1.2, Ink::Force, "H");
        let omega = if part == 0.0 { "ω₀" } else { "ω" };
        scene.arrow(Vector3::zeros(), turn * body.velocity(t) / unit, Ink::Result, omega);
        scene
    })
}
