//! Response before and after, relative motion, the family of dampings through the fixed points, and a sketch.

use dalembert_core::{Axis, Drawing, Ink, Plot, Series, Sketch, Text};
use dalembert_mechanics::{
    sdof,
    vibration::absorber::{DampedAbsorber as Kernel, Peak},
};

/// Points of each curve.
const POINTS: u16 = 300;

/// Magnifications above this are not drawn.
fn top(kernel: &Kernel) -> f64 {
    kernel.largest_peak().map_or(20.0, |peak| (3.0 * peak.height).clamp(5.0, 1e4))
}

fn ratios(kernel: &Kernel) -> impl Fn() -> Vec<f64> {
    let peaks = kernel.peaks();
    let first = peaks.first().map_or(1.0, |peak| peak.ratio).min(1.0);
    let last = (1.0 + 1.6 * (peaks.last().map_or(1.0, |peak| peak.ratio).max(1.0) - first)).clamp(1.6, 8.0);
    move || (0..=POINTS).map(|n| last * f64::from(n) / f64::from(POINTS)).collect()
}

/// Frequencies are shown in rpm where the natural frequency is known, else as ratios.
fn axis(natural: Option<f64>) -> (Axis, f64) {
    match natural {
        Some(natural) => (Axis::linear("frequency", "rpm"), natural),
        None => (Axis::linear("frequency ratio", "1"), 1.0),
    }
}

/// The main mass with and without the absorber.
pub(super) fn response(kernel: &Kernel, natural: Option<f64>, peak: Option<Peak>) -> Plot {
    let (axis, unit) = axis(natural);
    let highest = top(kernel);
    let drawn = |height: f64| if height <= highest { height } else { f64::INFINITY };
    let ratios = ratios(kernel);
    let curve = |of: &dyn Fn(f64) -> f64| ratios().iter().map(|&g| (g * unit, drawn(of(g)))).collect();
    let plot = Plot::new(
        "Magnification of the main system, with and without the absorber",
        axis,
        Axis::linear("magnification", "1"),
        vec![
            Series::line("with the absorber", curve(&|g| kernel.magnification(g))).of("magnification"),
            Series::line("without it", curve(&|g| sdof::magnification(g, kernel.main_damping))),
        ],
    );
    match peak {
        Some(peak) => plot.mark("peak", (peak.ratio * unit, peak.height)),
        None => plot,
    }
}

/// The absorber relative to the main mass.
pub(super) fn stroke(kernel: &Kernel, natural: Option<f64>) -> Plot {
    let (axis, unit) = axis(natural);
    let largest = kernel.largest_relative_motion().filter(|peak| peak.height < 1e4);
    let highest = largest.map_or(100.0, |peak| 1.1 * peak.height);
    let drawn = |height: f64| if height <= highest { height } else { f64::INFINITY };
    let points = ratios(kernel)().iter().map(|&g| (g * unit, drawn(kernel.relative_motion(g)))).collect();
    let plot = Plot::new(
        "Motion of the absorber relative to the main system",
        axis,
        Axis::linear("relative motion over static deflection", "1"),
        vec![Series::line("absorber", points).of("relative_motion")],
    );
    match largest {
        Some(peak) => plot.mark("largest", (peak.ratio * unit, peak.height)),
        None => plot,
    }
}

/// This damping, a third, three times it, and a locked absorber: all pass the fixed points of an undamped system.
pub(super) fn family(kernel: &Kernel) -> Plot {
    let highest = top(kernel);
    let drawn = |height: f64| if height <= highest { height } else { f64::INFINITY };
    let ratios = ratios(kernel);
    let curve = |damping: f64| {
        let other = Kernel { damping, ..*kernel };
        ratios().iter().map(|&g| (g, drawn(other.magnification(g)))).collect::<Vec<_>>()
    };
    let dampings = if kernel.damping > 0.0 {
        [1.0, 1.0 / 3.0, 3.0].map(|n| n * kernel.damping)
    } else {
        [0.0, 0.1, 0.3]
    };
    let mut series: Vec<Series> = dampings
        .iter()
        .map(|&damping| {
            let label = Text::new("γ = {ratio}").with_quantity("ratio", damping, "1");
            let line = Series::line(label, curve(damping)).of("magnification");
            line.with("absorber.given.damping.by-main.ratio", damping)
        })
        .collect();
    let locked = |g: f64| {
        let square = g * g * (1.0 + kernel.mass_ratio);
        1.0 / (1.0 - square).hypot(2.0 * kernel.main_damping * g)
    };
    series.push(Series::line("locked", ratios().iter().map(|&g| (g, drawn(locked(g)))).collect()));
    Plot::new(
        "Magnification for other values of absorber damping",
        Axis::linear("frequency ratio", "1"),
        Axis::linear("magnification", "1"),
        series,
    )
}

pub(super) fn drawing(spring: bool) -> Drawing {
    let mut sketch = Sketch::new("The main system and its damped absorber");
    sketch
        .ground((-1.5, -2.4), (1.5, -2.4))
        .spring("k", (-0.6, -2.4), (-0.6, -1.0))
        .damper("ζ", (0.6, -2.4), (0.6, -1.0))
        .mass("m", (-1.2, -1.0), (1.2, 0.2))
        .force("F₀ cos(ω t)", (-1.5, -1.0), (-1.5, 0.2))
        .damper("c_a", (0.35, 0.2), (0.35, 1.3))
        .block("m_a", (-0.6, 1.3), (0.6, 2.0), Ink::Result);
    if spring {
        sketch.spring("k_a", (-0.35, 0.2), (-0.35, 1.3));
    }
    sketch.finish()
}
