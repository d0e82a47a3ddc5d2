//! The machine on its mounts, and its transmissibility against speed.

use dalembert_core::{Axis, Drawing, Ink, Plot, Series, Sketch, Text};
use dalembert_mechanics::sdof;

use super::{Disturbance, IsolationTask, VibrationIsolation};
use crate::shared::oscillator::plots::below;

/// Transmissibility against speed for several dampings, with the speeds of the machine shaded.
pub(super) fn over_speed(
    (natural, zeta): (f64, f64),
    required: Option<f64>,
    [lowest, highest]: [f64; 2],
) -> Plot {
    let last = (1.25 * highest).max(2.5 * natural);
    let curve = |zeta: f64| -> Vec<(f64, f64)> {
        let at = |n: u16| last * f64::from(n) / 150.0;
        (0..=150)
            .map(at)
            .map(|speed| (speed, below(sdof::transmissibility(speed / natural, zeta), 100.0)))
            .collect()
    };
    let mut series = vec![Series::line("these mounts", curve(zeta)).of("transmissibility")];
    series.extend([0.05, 0.2, 0.5].map(|zeta| {
        let line = Series::line(Text::new("ζ = {ratio}").with_quantity("ratio", zeta, "1"), curve(zeta));
        line.of("transmissibility").with("question.judge.damping.ratio.ratio", zeta)
    }));
    let plot = Plot::new(
        "Transmissibility against speed",
        Axis::linear("speed", "rpm"),
        Axis::log("transmissibility", "1"),
        series,
    );
    let plot = if highest > lowest {
        plot.band("speeds of the machine", lowest, highest, true)
    } else {
        plot.mark("speed of the machine", (lowest, sdof::transmissibility(lowest / natural, zeta)))
    };
    match required {
        Some(required) => plot.level("required", required),
        None => plot,
    }
}

impl VibrationIsolation {
    /// The machine on its mounts, with its speeds and what disturbs it.
    pub(super) fn drawing(&self) -> Drawing {
        let (spring, speeds, disturbance) = match &self.question {
            IsolationTask::Design { speeds, disturbance, .. } => ("k", Some(speeds), disturbance.as_ref()),
            IsolationTask::Judge { elasticity, speeds, disturbance, .. } => {
                (elasticity.letters(), Some(speeds), disturbance.as_ref())
            }
            IsolationTask::Shock { .. } => ("k", None, None),
        };
        let mut sketch = Sketch::new("The machine on its mounts");
        sketch
            .ground((-1.8, -1.7), (1.8, -1.7))
            .spring_and_damper((spring, "c"), (-0.9, -1.7), (-0.9, -0.6), 0.5)
            .spring_and_damper(("", ""), (0.9, -1.7), (0.9, -0.6), 0.5)
            .block(if self.block.is_some() { "m_b" } else { "" }, (-1.3, -0.6), (1.3, -0.15), Ink::Faint)
            .mass(self.mass.letter(), (-0.8, -0.15), (0.8, 0.8))
            .motion("X", (1.7, -0.4), (1.7, 0.4));
        if let Some(speeds) = speeds {
            let range = if speeds.highest.is_some() { "ω₁ ≤ ω ≤ ω₂" } else { "ω₁" };
            sketch.couple(range, (0.0, 0.8), (0.5, 2.6), Ink::Motion).force("F_T", (0.0, -1.8), (0.0, -2.4));
        } else {
            sketch.motion("A, d", (-2.0, -1.9), (-2.0, -1.2));
        }
        match disturbance {
            Some(Disturbance::Force { .. }) => sketch.force("F₀", (-0.5, 0.8), (-0.5, 1.5)),
            Some(Disturbance::Unbalance { .. }) => sketch.round("m₀e", (0.25, 0.6), 0.08, Ink::Danger),
            Some(Disturbance::Piston { .. }) => sketch.round("m₀, s", (0.25, 0.6), 0.08, Ink::Danger),
            None => &mut sketch,
        };
        sketch.finish()
    }
}
