//! Plots of the free and of the forced motion, and their table.

use std::f64::consts::TAU;

use dalembert_core::{Axis, Cell, Column, Drawing, Ink, Plot, Series, Sketch, TableExhibit};
use dalembert_mechanics::vibration::duffing::{self, Duffing, DuffingResponse};

use super::{DuffingMotion, DuffingOscillator, SmallStiffness};
use crate::shared::oscillator::{motion::OscillatorMotion, plots};

/// The free motion over one period, with the cosine of the same period.
pub(super) fn free_plot(moves: OscillatorMotion, oscillator: &Duffing, amplitude: f64, period: f64) -> Plot {
    let motion = duffing::free_motion(oscillator, amplitude, period, 200);
    let cosine = motion.iter().map(|(t, _)| (*t, amplitude * (TAU * t / period).cos())).collect();
    Plot::new(
        moves.of("Displacement over one period", "Angle over one period"),
        Axis::linear("time", "s"),
        Axis::linear(moves.of("displacement", "angle"), moves.displacement_unit()),
        vec![Series::line(moves.displacement(), motion), Series::line("cosine of the same period", cosine)],
    )
}

/// Frequency of the free motion against its amplitude.
pub(super) fn backbone_plot(
    motion: OscillatorMotion,
    oscillator: &Duffing,
    amplitude: f64,
    period: f64,
) -> Plot {
    let input = motion.of("motion.free.amplitude", "motion.free-rotation.amplitude");
    let amplitudes = (1..=200).map(|n| 2.0 * amplitude * f64::from(n) / 200.0);
    let exact: Vec<_> =
        amplitudes.clone().filter_map(|a| Some((TAU / oscillator.free_period(a)?, a))).collect();
    let given = exact.iter().map(|(_, a)| *a).collect();
    let balance = amplitudes.filter_map(|a| Some((oscillator.backbone(a)?, a))).collect();
    Plot::new(
        "Backbone: frequency of the free vibration against its amplitude",
        Axis::linear("frequency", "rad/s"),
        Axis::linear("amplitude", motion.displacement_unit()),
        vec![Series::line("exact", exact).of(input).at(given), Series::line("harmonic balance", balance)],
    )
    .over_answer(input, "frequency")
    .mark("at this amplitude", (TAU / period, amplitude))
}

/// Amplitude of the forced motion against its frequency.
pub(super) fn response_plot(
    motion: OscillatorMotion,
    oscillator: &Duffing,
    force: f64,
    (at, steady): (f64, &[DuffingResponse]),
    jumps: &[(f64, f64)],
) -> Plot {
    let natural = (oscillator.stiffness / oscillator.mass).sqrt();
    let peak = oscillator.peak(force);
    let reference = peak.map_or(natural, |peak| peak.1);
    let last = 1.4 * reference.max(natural).max(at);
    let first = 0.3 * reference.min(natural).min(at);
    let largest =
        peak.map_or_else(|| steady.iter().fold(0.0, |a: f64, one| a.max(one.amplitude)), |peak| peak.0);
    // Along the amplitude the curve is single-valued on each side of the backbone.
    let amplitude = |n: u32| largest * (std::f64::consts::FRAC_PI_2 * f64::from(n) / 400.0).sin();
    let side = |side: usize| {
        let point = |n: u32| (oscillator.frequencies_of(force, amplitude(n))[side], amplitude(n));
        let inside = |(w, _): &(f64, f64)| w.is_finite() && (first..=last).contains(w);
        (1..=400).map(point).filter(inside).collect::<Vec<_>>()
    };
    let backbone = (0..=200).map(|n| largest * 1.1 * f64::from(n) / 200.0);
    let backbone = backbone
        .filter_map(|a| Some((oscillator.backbone(a)?, a)))
        .filter(|(w, _)| (first..=last).contains(w));
    let mut plot = Plot::new(
        "Amplitude against frequency",
        Axis::linear(motion.of("frequency of the force", "frequency of the torque"), "rad/s"),
        Axis::linear("amplitude", motion.displacement_unit()),
        vec![
            Series::line("below the backbone", side(0)).of("amplitude[*]"),
            Series::line("above the backbone", side(1)).of("amplitude[*]"),
            Series::line("backbone", backbone.collect()),
            Series::dots("at this frequency", steady.iter().map(|one| (at, one.amplitude)).collect())
                .of("amplitude[*]"),
        ],
    )
    .over(motion.of("motion.forced.frequency", "motion.forced-rotation.frequency"));
    for jump in jumps {
        plot = plot.mark("jump", *jump);
    }
    plot
}

/// The steady-state vibrations.
pub(super) fn table(unit: &'static str, steady: &[DuffingResponse]) -> TableExhibit {
    let row = |one: &DuffingResponse| {
        let word = if one.stable { "stable" } else { "unstable" };
        vec![Cell::from(one.amplitude), Cell::from(one.lag), Cell::from(word)]
    };
    TableExhibit {
        title: "Steady-state vibrations at this frequency".into(),
        columns: vec![
            Column { heading: "amplitude".into(), unit },
            Column { heading: "phase lag".into(), unit: "deg" },
            Column { heading: "stability".into(), unit: "" },
        ],
        rows: steady.iter().map(row).collect(),
        foot: Vec::new(),
    }
}

impl DuffingOscillator {
    /// The mass on its hardening or softening spring, the disc on its shaft, or the pendulum.
    pub(super) fn drawing(&self, motion: OscillatorMotion) -> Drawing {
        let load = match self.motion {
            DuffingMotion::Free { .. } => "x = A",
            DuffingMotion::Forced { .. } => "F cos(ω t)",
            DuffingMotion::FreeRotation { .. } => "θ = Θ",
            DuffingMotion::ForcedRotation { .. } => "T₀ cos(ω t)",
        };
        let body = self.mass.letters();
        if let SmallStiffness::Pendulum { .. } = self.stiffness {
            return Sketch::new("The pendulum")
                .axis((0.0, 0.0), (0.0, -2.0))
                .body("", [(-0.2, 0.2), (0.2, 0.1), (1.4, -1.7), (0.9, -2.0)])
                .pin("O", (0.0, 0.0))
                .mass_centre("G", (0.65, -0.95))
                .dimension("d_G", (0.0, 0.0), (0.65, -0.95), 4.0)
                .label(body, (1.2, -1.8))
                .couple(load, (0.0, 0.0), (3.6, 5.6), Ink::Motion)
                .finish();
        }
        if motion == OscillatorMotion::Rotation {
            return plots::inertia_spring_damper(load, [body, "k_t, h_t".into()]);
        }
        let mut sketch = Sketch::new("The mass on its nonlinear spring");
        sketch
            .ground((-2.6, 0.9), (-2.6, -0.7))
            .ground((-2.6, -0.7), (1.8, -0.7))
            .spring("k, h", (-2.6, 0.3), (-0.7, 0.3))
            .mass(body, (-0.7, -0.7), (0.7, 0.7));
        match self.motion {
            DuffingMotion::Forced { .. } => {
                sketch.damper("c", (-2.6, -0.3), (-0.7, -0.3)).force(load, (0.7, 0.0), (1.6, 0.0))
            }
            _ => sketch.motion(load, (0.0, 1.0), (0.9, 1.0)),
        };
        sketch.finish()
    }
}
