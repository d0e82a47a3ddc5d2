//! Plots of a measured response and of what was identified.

use std::f64::consts::TAU;

use dalembert_core::{Axis, Plot, Series};
use dalembert_mechanics::{
    identification::modal::{CircleFit, Complex, DampingModel, ModalFit},
    sdof,
};

/// Plot of the measured points with the receptance of the identified system.
pub(super) fn receptance(
    (stiffness, mass, damping): (f64, f64, f64),
    measured: Vec<(f64, f64)>,
    peak: (f64, f64),
) -> Plot {
    let last = measured.iter().fold(2.0 * peak.0, |last, point| last.max(point.0));
    let at = |n: u16| {
        let frequency = last * f64::from(n) / 500.0;
        (frequency, sdof::receptance(stiffness, mass, damping, frequency))
    };
    Plot::new(
        "Receptance against frequency",
        Axis::linear("frequency", "rad/s"),
        Axis::log("receptance", "mm/N"),
        vec![Series::line("identified", (0..=500).map(at).collect()), Series::dots("measured", measured)],
    )
    .mark("peak", peak)
}

/// The receptances that were measured, `(ω, α)`, with the fitted ones, as amplitude and phase.
pub(super) fn bode(measured: &[(f64, Complex<f64>)], fit: &ModalFit, model: DampingModel) -> [Plot; 2] {
    let fitted = fitted(measured, fit, model);
    let series = |of: &dyn Fn(Complex<f64>) -> f64| {
        let points = |all: &[(f64, Complex<f64>)]| all.iter().map(|(w, a)| (*w, of(*a))).collect();
        vec![Series::line("fitted", points(&fitted)), Series::dots("measured", points(measured))]
    };
    let amplitude = Plot::new(
        "Amplitude of the receptance",
        Axis::linear("frequency", "Hz"),
        Axis::log("receptance", "mm/N"),
        series(&|a| a.norm()),
    );
    let phase = Plot::new(
        "Phase of the receptance",
        Axis::linear("frequency", "Hz"),
        Axis::linear("phase", "deg"),
        series(&|a| a.arg()),
    );
    [amplitude, phase]
}

/// The Nyquist plane of the circle: receptances with hysteretic, mobilities with viscous damping.
pub(super) fn nyquist(
    measured: &[(f64, Complex<f64>)],
    circle: &CircleFit,
    fit: &ModalFit,
    model: DampingModel,
) -> Plot {
    let in_plane = |(frequency, receptance): &(f64, Complex<f64>)| {
        let z = match model {
            DampingModel::Viscous => receptance * Complex::new(0.0, *frequency),
            DampingModel::Hysteretic => *receptance,
        };
        (z.re, z.im)
    };
    let around = |n: u16| {
        let z = circle.circle.centre + Complex::from_polar(circle.circle.radius, TAU * f64::from(n) / 120.0);
        (z.re, z.im)
    };
    let (title, unit) = match model {
        DampingModel::Viscous => ("Nyquist plot of the mobility", "mm/(N*s)"),
        DampingModel::Hysteretic => ("Nyquist plot of the receptance", "mm/N"),
    };
    let mut plot = Plot::new(
        title,
        Axis::linear("real part", unit),
        Axis::linear("imaginary part", unit),
        vec![
            Series::line("fitted circle", (0..=120).map(around).collect()),
            Series::line("least squares", fitted(measured, fit, model).iter().map(in_plane).collect()),
            Series::dots("measured", measured.iter().map(in_plane).collect()),
        ],
    )
    .equal();
    let names = ["natural frequency", "lower half-power point", "upper half-power point"];
    for (name, z) in names.into_iter().zip(circle.marks) {
        plot = plot.mark(name, (z.re, z.im));
    }
    plot
}

/// The fitted receptances over the measured range, closer about the natural frequency.
fn fitted(measured: &[(f64, Complex<f64>)], fit: &ModalFit, model: DampingModel) -> Vec<(f64, Complex<f64>)> {
    let (first, last) = (measured[0].0, measured[measured.len() - 1].0);
    let mut all: Vec<f64> = (0..=200).map(|n| first + (last - first) * f64::from(n) / 200.0).collect();
    // Equal steps of the angle round the circle.
    all.extend((1..200).map(|n| {
        let angle = (f64::from(n) / 200.0 - 0.5) * std::f64::consts::PI;
        fit.natural_frequency * (1.0 + fit.damping * angle.tan())
    }));
    all.retain(|frequency| (first..=last).contains(frequency) && *frequency > 0.0);
    all.sort_by(f64::total_cmp);
    all.into_iter().map(|frequency| (frequency, fit.receptance(model, frequency))).collect()
}

/// The magnification of one degree of freedom, with measured points of it.
pub(super) fn magnification(damping_ratio: f64, unbalance: bool, measured: Vec<(f64, f64)>) -> Plot {
    let last = measured.iter().fold(2.5, |last: f64, point| last.max(1.1 * point.0));
    let at = |n: u16| {
        let ratio = last * f64::from(n) / 400.0;
        let height = if unbalance {
            sdof::unbalance_magnification(ratio, damping_ratio)
        } else {
            sdof::magnification(ratio, damping_ratio)
        };
        (ratio, height)
    };
    let label = if unbalance { "amplitude over m₀e/m" } else { "amplitude over static deflection" };
    Plot::new(
        "Amplitude against frequency ratio",
        Axis::linear("frequency ratio", "1"),
        Axis::linear(label, "1"),
        vec![Series::line("identified", (0..=400).map(at).collect()), Series::dots("measured", measured)],
    )
}
