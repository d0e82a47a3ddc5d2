//! Plots and the animation of a body in motion.

use std::f64::consts::{PI, TAU};

use dalembert_core::{Axis, Exhibit, Ink, Plot, Series, Text, Worksheet};
use dalembert_mechanics::rigid::simulate::{self as follow, RotatingBody, RotationSample};
use nalgebra::{Matrix3, Vector3};

use super::Motion;
use crate::shared::{
    flat,
    scene::{self, Scene},
};

impl Motion {
    /// All figures and tables.
    pub(super) fn show<W: Worksheet>(&self, sheet: W, body: &RotatingBody, moved: &follow::RigidBodyMotion) {
        let samples = &moved.samples;
        sheet.show(|| self.animation(body, samples));
        sheet.show(|| Exhibit::Plot(self.angles(samples)));
        sheet.show(|| {
            let omega: fn(&RotationSample) -> Vector3<f64> = |sample| sample.turning.omega_body;
            Exhibit::Plot(components(
                "Angular velocity in body axes",
                ["ωₓ", "ω_y", "ω_z"],
                "omega_body",
                samples,
                omega,
            ))
        });
        sheet.show(|| {
            let omega: fn(&RotationSample) -> Vector3<f64> = |sample| sample.omega;
            Exhibit::Plot(components(
                "Angular velocity in the fixed axes",
                ["ω_X", "ω_Y", "ω_Z"],
                "omega",
                samples,
                omega,
            ))
        });
        sheet.show(|| {
            let points =
                samples.iter().map(|sample| self.axis_of(sample)).map(|axis| (axis.x, axis.y)).collect();
            let circle = (0..=72).map(|n| (TAU * f64::from(n) / 72.0).sin_cos()).map(|(sin, cos)| (cos, sin));
            let times = samples.iter().map(|sample| sample.time).collect();
            Exhibit::Plot(
                Plot::new(
                    Text::new("Trace of the axis {axis} on the unit sphere, seen from above")
                        .with("axis", self.axis.name()),
                    Axis::linear("X", "1"),
                    Axis::linear("Y", "1"),
                    vec![
                        Series::line("axis", points).of("axis.y").at(times),
                        Series::line("horizon", circle.collect()),
                    ],
                )
                .equal()
                .over_answer("duration", "axis.x"),
            )
        });
        sheet.show(|| Exhibit::Plot(energies(samples)));
        sheet.show(|| Exhibit::Plot(drifts(body, samples)));
    }

    fn axis_of(&self, sample: &RotationSample) -> Vector3<f64> {
        sample.turning.attitude * self.axis.vector()
    }

    /// Euler's angles of the followed axis: nutation, and precession and spin without jumps.
    fn angles(&self, samples: &[RotationSample]) -> Plot {
        let third = self.axis.index();
        let order = [(third + 1) % 3, (third + 2) % 3, third];
        let mut angles: Vec<[f64; 3]> = Vec::with_capacity(samples.len());
        for sample in samples {
            let rotation = sample.turning.attitude.to_rotation_matrix();
            let entry = |row: usize, column: usize| rotation[(row, order[column])];
            let nutation = entry(2, 2).clamp(-1.0, 1.0).acos();
            let upright = entry(2, 2).abs() > 1.0 - 1e-13;
            let (precession, spin) = if upright {
                // Only the sum (or the difference) is known: all of it is precession.
                (entry(1, 0).atan2(entry(0, 0)), 0.0)
            } else {
                (entry(0, 2).atan2(-entry(1, 2)), entry(2, 0).atan2(entry(2, 1)))
            };
            let on = |angle: f64, before: Option<f64>| {
                before.map_or(angle, |before| angle + TAU * ((before - angle) / TAU).round())
            };
            let before = angles.last();
            angles.push([on(precession, before.map(|b| b[0])), nutation, on(spin, before.map(|b| b[2]))]);
        }
        let line = |name: &'static str, n: usize| {
            Series::line(name, samples.iter().zip(&angles).map(|(s, angles)| (s.time, angles[n])).collect())
        };
        // A spin of many turns would hide the rest.
        let range = angles.iter().map(|angles| angles[2].abs()).fold(0.0, f64::max);
        let mut series = vec![line("φ", 0), line("θ", 1)];
        if range < 8.0 * PI {
            series.push(line("ψ", 2));
        }
        Plot::new("Euler's angles", Axis::linear("Time", "s"), Axis::linear("angle", "deg"), series)
    }

    fn animation(&self, body: &RotatingBody, samples: &[RotationSample]) -> Exhibit {
        let edges = edges(body);
        let size = edges.max().max(body.arm.norm());
        let most = |of: fn(&RotationSample) -> f64| samples.iter().map(of).fold(f64::MIN_POSITIVE, f64::max);
        let (omega, momentum) = (most(|s| s.omega.norm()), most(|s| s.momentum.norm()));
        let reach = body.arm.norm().max(size);
        let trace: Vec<Vector3<f64>> = samples.iter().map(|s| self.axis_of(s) * reach).collect();
        scene::animation("The rotating body", 6.0, |part| {
            let now = ((samples.len() - 1) as f64 * part).round() as usize;
            let sample = &samples[now];
            let rotation = sample.turning.attitude.to_rotation_matrix().into_inner();
            let mut scene = Scene::new();
            let is_on_pivot = body.arm != Vector3::zeros();
            // The fixed axes stand at the pivot, or beside a free body, whose own ones start from its centre.
            let stand = if is_on_pivot { Vector3::zeros() } else { Vector3::new(1.2, -1.2, -0.8) * reach };
            scene.axes(stand, &Matrix3::identity(), 0.6 * size, ["X", "Y", "Z"]);
            // The path of the axis in the last third of the time.
            scene.line(trace[now.saturating_sub(samples.len() / 3)..=now].iter().copied(), Ink::Faint);
            let centre = rotation * body.arm;
            scene.cuboid(centre, &rotation, edges, Ink::Body);
            if is_on_pivot {
                scene.line([Vector3::zeros(), centre], Ink::Body);
                scene.label(Vector3::zeros(), "O");
                scene.label(centre / 2.0, "r_G");
                scene.label(centre, "m");
            }
            for (axis, letter) in self.moments.letters().into_iter().enumerate() {
                let along = rotation.column(axis) * (0.7 * size);
                if axis == self.axis.index() {
                    scene.arrow(centre, along, Ink::Result, flat::letters(&[self.axis.name(), letter]));
                } else {
                    scene.arrow(centre, along, Ink::Faint, letter);
                }
            }
            scene.arrow(Vector3::zeros(), sample.omega * (1.2 * size / omega), Ink::Motion, "ω");
            scene.arrow(Vector3::zeros(), sample.momentum * (1.2 * size / momentum), Ink::Force, "H");
            scene
        })
    }
}

/// The edges of a box along the axes of the body with moments in the same proportions; of length 1 for a body without
/// an arm.
fn edges(body: &RotatingBody) -> Vector3<f64> {
    let arm = body.arm;
    let moments = body.inertia.diagonal();
    let steiner = (Vector3::repeat(arm.norm_squared()) - arm.component_mul(&arm)) * body.mass;
    let about_g = (moments - steiner) / moments.max();
    let squares = Vector3::repeat(about_g.sum()) - about_g * 2.0;
    let edges = squares.map(|square| square.max(0.0).sqrt());
    let longest = edges.max();
    let edges = if longest > 0.0 { edges / longest } else { Vector3::repeat(1.0) };
    // What is thin is still seen.
    let edges = edges.map(|edge| edge.max(0.04));
    if arm == Vector3::zeros() { edges } else { edges * (0.6 * arm.norm()) }
}

fn components(
    title: &'static str,
    names: [&'static str; 3],
    answer: &'static str,
    samples: &[RotationSample],
    of: fn(&RotationSample) -> Vector3<f64>,
) -> Plot {
    let line = |(n, name): (usize, &'static str)| {
        let points = samples.iter().map(|sample| (sample.time, of(sample)[n])).collect();
        Series::line(name, points).of(format_args!("{answer}.{}", ["x", "y", "z"][n]))
    };
    let series = names.into_iter().enumerate().map(line).collect();
    Plot::new(title, Axis::linear("Time", "s"), Axis::linear("Angular velocity", "rad/s"), series)
        .over("duration")
}

fn energies(samples: &[RotationSample]) -> Plot {
    let line = |name: &'static str, of: fn(&RotationSample) -> f64| {
        Series::line(name, samples.iter().map(|sample| (sample.time, of(sample))).collect())
    };
    let series = vec![
        line("Kinetic", |sample| sample.kinetic).of("kinetic_energy"),
        line("Potential", |sample| sample.potential),
        line("Work done", |sample| sample.work),
    ];
    Plot::new("Energy", Axis::linear("Time", "s"), Axis::linear("Energy", "J"), series).over("duration")
}

/// Plot of the relative drift of energy and angular momentum.
fn drifts(body: &RotatingBody, samples: &[RotationSample]) -> Plot {
    let left = |sample: &RotationSample| sample.kinetic + sample.potential - sample.work;
    let along = |sample: &RotationSample| {
        let off = sample.momentum - sample.impulse - samples[0].momentum;
        if body.arm == Vector3::zeros() { off.norm() } else { off.z }
    };
    let energy = samples.iter().map(|s| s.kinetic.max(s.work.abs())).fold(f64::MIN_POSITIVE, f64::max);
    let momentum = samples.iter().map(|s| s.momentum.norm()).fold(f64::MIN_POSITIVE, f64::max);
    let series = vec![
        Series::line("E", samples.iter().map(|s| (s.time, (left(s) - left(&samples[0])) / energy)).collect()),
        Series::line("H", samples.iter().map(|s| (s.time, along(s) / momentum)).collect()),
    ];
    Plot::new(
        "Drift of energy and angular momentum",
        Axis::linear("Time", "s"),
        Axis::linear("relative to the maximum", "1"),
        series,
    )
}
