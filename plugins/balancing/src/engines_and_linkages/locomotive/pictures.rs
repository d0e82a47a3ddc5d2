//! The locomotive drawn, and its forces over a revolution and against the speed.

use std::f64::consts::TAU;

use dalembert_core::{Axis, Drawing, Ink, Plot, Series, Sketch, Text};
use dalembert_mechanics::balance::locomotive as engine;

use super::Locomotive;
use crate::shared::crank::Throw;

fn curve(of: impl Fn(f64) -> f64) -> Vec<(f64, f64)> {
    (0..=180).map(|k| TAU * f64::from(k) / 180.0).map(|angle| (angle, of(angle))).collect()
}

pub(super) fn over_a_turn(force: f64, between: f64) -> Plot {
    let x = Axis::linear("Angle of the wheels", "deg");
    let y = Axis::linear("Variation of tractive effort", "kN");
    let points = curve(|angle| engine::tractive_effort(force, angle, between));
    Plot::new(
        "Variation of tractive effort over a revolution",
        x,
        y,
        vec![Series::line("tractive effort", points)],
    )
}

pub(super) fn swaying(force: f64, apart: f64, between: f64) -> Plot {
    let x = Axis::linear("Angle of the wheels", "deg");
    let y = Axis::linear("Swaying couple", "kN*m");
    let points = curve(|angle| engine::swaying_couple(force, apart, angle, between));
    Plot::new("Swaying couple over a revolution", x, y, vec![Series::line("swaying couple", points)])
}

pub(super) fn against_speed(blow: f64, speed: f64, load: Option<f64>, limit: Option<f64>) -> Plot {
    let end = 1.3 * limit.unwrap_or(speed).max(speed);
    let points = (0..=100).map(|k| end * f64::from(k) / 100.0).map(|at| (at, blow * (at / speed).powi(2)));
    let x = Axis::linear("Speed of the wheels", "rpm");
    let y = Axis::linear("Hammer blow", "kN");
    let series = vec![Series::line("hammer blow", points.collect()).of("hammer_blow")];
    let plot = Plot::new("Hammer blow against speed", x, y, series)
        .over("running.wheel.speed")
        .mark("operating speed", (speed, blow));
    match load {
        Some(load) => plot.level("dead load", load),
        None => plot,
    }
}

impl Locomotive {
    /// Both wheels of the driving axle seen from one side, with the cranks and the balance masses at their angles, and the
    /// axle from above, with cylinders and wheels.
    pub(super) fn drawn(&self, angles: [f64; 2]) -> Drawing {
        let between = self.between;
        let mut sketch = Sketch::new("Cranks and balance masses of the driving wheels");
        sketch.size(4.5);
        for (wheel, angle) in angles.into_iter().enumerate() {
            let hub = (2.8 * wheel as f64, 0.0);
            let at = |angle: f64, radius: f64| (hub.0 + radius * angle.cos(), radius * angle.sin());
            sketch.disc("", hub, 1.0);
            for (crank, name) in [(0.0, "1"), (between, "2")] {
                sketch.motion(name, hub, at(crank, 0.5));
            }
            sketch
                .arc(hub, 0.85, (angle - 0.4, angle + 0.4), Ink::Result)
                .vector("", hub, at(angle, 0.85), Ink::Result)
                .joint("", hub)
                .caption(Text::new("wheel {n}").with("n", wheel + 1), (hub.0, -1.25));
        }
        let hub = (0.0, 0.0);
        let tip = (0.5 * between.cos(), 0.5 * between.sin());
        let masses = if self.rotating > 0.0 { "m, m_r" } else { "m" };
        sketch
            .angle("α", hub, 0.0, between)
            .line(if let Throw::Radius { .. } = self.throw { "r" } else { "S/2" }, hub, tip, Ink::Body)
            .particle("", (0.5, 0.0))
            .label(masses, (0.5, 0.0))
            .couple("ω", hub, (3.9, 4.9), Ink::Motion);
        if self.radius.is_some() {
            let end = (2.8 + 0.85 * angles[1].cos(), 0.85 * angles[1].sin());
            sketch.line("b", (2.8, 0.0), end, Ink::Result);
        }
        self.draw_axle(&mut sketch);
        sketch.finish()
    }

    /// The axle from above, below the wheels.
    fn draw_axle(&self, sketch: &mut Sketch) {
        let (middle, level) = (1.4, -2.5);
        let half = 1.3 * self.wheels / self.wheels.max(self.cylinders);
        let crank = 1.3 * self.cylinders / self.wheels.max(self.cylinders);
        sketch.link("", (middle - 1.8, level), (middle + 1.8, level));
        for side in [-1.0, 1.0] {
            let (wheel, cylinder) = (middle + side * half, middle + side * crank);
            sketch.mass("", (wheel - 0.08, level - 0.45), (wheel + 0.08, level + 0.45)).mass(
                "",
                (cylinder - 0.12, level - 0.2),
                (cylinder + 0.12, level + 0.2),
            );
        }
        sketch.dimension("a", (middle - crank, level), (middle + crank, level), -4.5).dimension(
            "w",
            (middle - half, level),
            (middle + half, level),
            4.5,
        );
    }
}
