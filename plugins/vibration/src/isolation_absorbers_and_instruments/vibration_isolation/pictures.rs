//! The machine on its mounts, and its transmissibility against speed.

use dalembert_core::{Axis, Drawing, Ink, Plot, Series, Sketch, Text};
use dalembert_mechanics::sdof;

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

/// The machine on its mounts.
pub(super) fn drawing() -> Drawing {
    Sketch::new("The machine on its mounts")
        .ground((-1.6, -1.5), (1.6, -1.5))
        .spring_and_damper(("k", "c"), (-0.9, -1.5), (-0.9, -0.6), 0.4)
        .spring_and_damper(("", ""), (0.9, -1.5), (0.9, -0.6), 0.4)
        .block("", (-1.3, -0.6), (1.3, -0.2), Ink::Faint)
        .mass("m", (-0.8, -0.2), (0.8, 0.7))
        .motion("X", (1.6, -0.4), (1.6, 0.4))
        .force("F_T", (0.0, -1.6), (0.0, -2.3))
        .finish()
}
