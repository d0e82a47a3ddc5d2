//! Viscous damping or friction? A decay record fitted with an exponential, a straight line, and both.

use std::f64::consts::PI;

use dalembert_core::{
    About, Analysis, Axis, Exhibit, Inputs, Plot, Refusal, Series, Text, Worksheet,
    exhibit::{Cell, Column, TableExhibit},
    register,
};
use dalembert_mechanics::{
    Real, sdof,
    vibration::{
        decay_fit::{self, DecayFit, DecayFitError, DecayFits},
        free::FreeMotion,
    },
};
use dalembert_numerics::quadrature::integral;

mod fitted;

use crate::{
    shared::decay::ratio_errors,
    sources::{GROVER, RAO},
};

/// A decay record, and what is known of the system.
#[derive(Clone, Debug, Inputs)]
pub struct DecayIdentification {
    /// Record.
    pub record: DecayRecord,
    /// Stiffness.
    /// For the friction force and the damping coefficient.
    #[input("k", "N/m", positive)]
    pub stiffness: Option<f64>,
    /// Natural frequency.
    /// For the coefficient of friction; taken from the record where that has times.
    #[input("ωₙ", "rad/s", positive)]
    pub natural_frequency: Option<f64>,
    /// Gravity.
    /// For the coefficient of friction of a mass on a horizontal surface.
    #[input("g", "m/s^2", positive, default = "9.81 m/s^2")]
    pub gravity: f64,
}

/// Record of the decay.
#[derive(Clone, Debug, Inputs)]
pub enum DecayRecord {
    /// Table of amplitudes
    Amplitudes {
        /// Amplitudes.
        /// At least four; a trough is half a cycle from its peak.
        #[input(table)]
        amplitudes: Vec<Peak>,
    },
    /// Samples of the motion
    Samples {
        /// Samples.
        /// In time order, at least ten per cycle.
        #[input(table)]
        samples: Vec<DecaySample>,
        /// Fraction of the range below which an extremum counts as noise.
        #[input("p", "%", positive, below = 50, default = "2 %")]
        noise: f64,
    },
}

/// A measured amplitude.
#[derive(Clone, Debug, Inputs)]
pub struct Peak {
    /// Cycles since the first amplitude.
    #[input("n", "1")]
    pub cycles: f64,
    /// Amplitude.
    #[input("X", "mm", positive)]
    pub amplitude: f64,
}

/// A sample of the motion.
#[derive(Clone, Debug, Inputs)]
pub struct DecaySample {
    /// Time.
    #[input("t", "s")]
    pub time: f64,
    /// Displacement.
    #[input("x", "mm")]
    pub displacement: f64,
}

register!(DecayIdentification);

/// The fewest amplitudes with which three parameters can be distinguished.
const FEWEST: usize = 4;

impl Analysis for DecayIdentification {
    const ABOUT: About = About {
        id: "vibration/decay-identification",
        title: "Viscous damping or friction from a free decay",
        topic: "Free vibration",
        summary: "Exponential, linear and combined fits to a decay record: viscous damping, Coulomb friction, and which of them is present.",
        main: &["damping_ratio", "friction_coefficient", "natural_frequency"],
        keywords: "coulomb viscous discriminate envelope exponential linear fit decay record identification \
                   identificação decaimento envoltória atrito viscoso",
        sources: &[&RAO, &GROVER],
        cases: include_str!("../../cases/decay_identification.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &DecayIdentificationGiven<W>, sheet: W) -> Result<(), Refusal> {
        let Amplitudes { points, ends } = self.amplitudes()?;
        if points.len() < FEWEST {
            return Err(Refusal::because(
                "there are fewer than four amplitudes: record more cycles, or use the logarithmic decrement",
            ));
        }
        let fits = decay_fit::fit(&points).map_err(|err| match err {
            DecayFitError::NotDecaying => Refusal::because("the amplitudes do not fall with the cycles"),
            DecayFitError::Points => Refusal::because("the amplitudes do not belong to different cycles"),
        })?;
        let natural = ends.map(|ends| period(ends, points.len(), &fits, sheet));
        let count = sheet.numerical("N", "1", points.len() as f64, "Number of amplitudes");
        sheet.answer("amplitudes", "Number of amplitudes", count);
        viscous(&fits, &points, sheet);
        friction(&fits, &points, sheet);
        both(&fits, &points, sheet);
        let verdict = verdict(&fits, sheet);
        forces(given, natural, &fits, &points, sheet);
        sheet.show(|| Exhibit::Table(side_by_side(&fits, verdict)));
        sheet.show(|| Exhibit::Plot(envelopes(&points, &fits)));
        if let DecayRecord::Samples { samples, noise } = &self.record {
            sheet.show(|| Exhibit::Plot(record_plot(samples, *noise)));
        }
        Ok(())
    }
}

/// Amplitudes of the record of a decay.
struct Amplitudes {
    /// Amplitudes over cycles.
    points: Vec<(f64, f64)>,
    /// Times of the first and of the last turning point, s, where the record has times.
    ends: Option<[f64; 2]>,
}

impl DecayIdentification {
    fn amplitudes(&self) -> Result<Amplitudes, Refusal> {
        let (samples, noise) = match &self.record {
            DecayRecord::Amplitudes { amplitudes } => {
                let points = amplitudes.iter().map(|peak| (peak.cycles, peak.amplitude)).collect();
                return Ok(Amplitudes { points, ends: None });
            }
            DecayRecord::Samples { samples, noise } => (samples, *noise),
        };
        if samples.windows(2).any(|pair| pair[1].time <= pair[0].time) {
            return Err(Refusal::because(
                "the times of the samples do not increase from row to row: sort the rows by time",
            ));
        }
        let record: Vec<(f64, f64)> =
            samples.iter().map(|sample| (sample.time, sample.displacement)).collect();
        let turning = decay_fit::turning_points(&record, noise);
        if turning.len() < FEWEST + 1 {
            return Err(Refusal::because(
                "the record has fewer than five turning points: record more cycles, or more samples per cycle",
            ));
        }
        // Half the distance from each turning point to the next: free of an offset of the record.
        let amplitude = |(n, pair): (usize, &[decay_fit::TurningPoint])| {
            (n as f64 / 2.0, (pair[0].displacement - pair[1].displacement).abs() / 2.0)
        };
        let points = turning.windows(2).enumerate().map(amplitude).collect();
        let first = turning.first().map_or(0.0, |point| point.time);
        let last = turning.last().map_or(0.0, |point| point.time);
        Ok(Amplitudes { points, ends: Some([first, last]) })
    }
}

/// Forces in newtons of the combined fit, if stiffness and frequency are known.
fn forces<W: Worksheet>(
    given: &DecayIdentificationGiven<W>,
    natural: Option<W::Num>,
    fits: &DecayFits,
    points: &[(f64, f64)],
    sheet: W,
) {
    let natural = given.natural_frequency.or(natural);
    let [zeta, offset] = of_both(fits, points, sheet);
    let size = points.iter().map(|point| point.1).fold(0.0, f64::max);
    let half = HalfCycle::of(zeta.value(), offset.value(), size);
    let alone = || offset * (fits.friction.loss / 4.0 / offset.value());
    if let Some(stiffness) = given.stiffness {
        sheet.common_error("F", "F/k of the fit with friction alone used", || stiffness * alone());
        let force = sheet.step("F", "N", stiffness * offset, ("Friction force", RAO.at("§2.9")));
        sheet.answer("friction", "Friction force", force);
        if let Some(natural) = natural {
            let of_viscous =
                || stiffness * 2.0 / natural * sdof::damping_ratio_from_decrement(fits.viscous.decrement);
            sheet.common_error("c", "the damping ratio of the viscous fit alone used", of_viscous);
            let damping = sheet.step(
                "c",
                "N*s/m",
                zeta * stiffness * 2.0 / natural,
                ("Damping coefficient: c = 2ζk/ωₙ", RAO.at("§2.6")),
            );
            sheet.answer("damping", "Damping coefficient", damping);
            sheet.verify(|| {
                let [natural, damping] = [natural, damping].map(Real::value);
                sheet.check(
                    "half-cycle: the energy released by the spring is the work of friction and damper, by quadrature",
                    W::Num::from(force.value() * half.path + damping * natural * half.squared_rate),
                    W::Num::from(stiffness.value() / 2.0 * half.squares),
                );
            });
        }
    }
    if let Some(natural) = natural {
        let of_friction = || alone() * natural.powi(2) / given.gravity;
        sheet.common_error("µ", "F/k of the fit with friction alone used", of_friction);
        let coefficient = sheet.step(
            "µ",
            "1",
            offset * natural.powi(2) / given.gravity,
            "Coefficient of friction on a horizontal surface: F = µmg and F/k = f",
        );
        sheet.answer("friction_coefficient", "Coefficient of friction", coefficient);
        sheet.verify(|| {
            let [coefficient, natural, gravity] = [coefficient, natural, given.gravity].map(Real::value);
            let taken = 2.0 * zeta.value() * natural * natural * half.squared_rate;
            sheet.check(
                "half-cycle of a mass on a level surface: its energy is the work of friction and damper",
                W::Num::from(coefficient * gravity * half.path + taken),
                W::Num::from(natural * natural / 2.0 * half.squares),
            );
        });
    }
}

/// Half a cycle with viscous damping and friction, of a mass that swings past the middle.
struct HalfCycle {
    /// Way from one turning point to the next.
    path: f64,
    /// Square of the displacement at the first one less that at the next.
    squares: f64,
    /// Integral of the squared velocity over the time, over the natural frequency.
    squared_rate: f64,
}

impl HalfCycle {
    /// About the position where spring and friction balance, the motion is the free one of viscous damping alone.
    fn of(zeta: f64, offset: f64, size: f64) -> Self {
        let start = size + 3.0 * offset;
        let across = start - offset;
        let rate = 2.0 * zeta / ((1.0 - zeta) * (1.0 + zeta)).sqrt();
        let lost = -(-rate * PI / 2.0).exp_m1();
        let path = across * (2.0 - lost);
        let fall = across * lost + 2.0 * offset;
        let squared = |angle: f64| (-rate * angle).exp() * angle.sin().powi(2);
        let squared_rate =
            integral(squared, [0.0, PI], 40) * across * across * (1.0 + rate * rate / 4.0).powi(3).sqrt();
        Self { path, squares: fall * path, squared_rate }
    }
}

/// Natural frequency from the times of the first and the last turning point.
fn period<W: Worksheet>([first, last]: [f64; 2], strokes: usize, fits: &DecayFits, sheet: W) -> W::Num {
    let strokes = strokes as f64;
    let half = (last - first) / strokes;
    let half =
        sheet.numerical("T/2", "s", half, "Mean time from one turning point of the record to the next");
    let damped = sheet.step("ω_d", "rad/s", W::Num::from(PI) / half, "Frequency of the decaying motion");
    let zeta = sdof::damping_ratio_from_decrement(fits.both.decrement);
    let zeta = sheet.numerical("ζ₀", "1", zeta, "Viscous damping ratio, from the combined fit below");
    let what = "the frequency of the decaying motion taken as the natural frequency";
    sheet.common_error("ωₙ", what, || damped);
    let natural = sheet.step(
        "ωₙ",
        "rad/s",
        sdof::natural_frequency_from_damped(damped, zeta),
        ("Natural frequency without damping, above that of the decay", RAO.at("§2.6")),
    );
    sheet.answer("damped_frequency", "Damped natural frequency", damped);
    sheet.answer("natural_frequency", "Natural frequency", natural);
    sheet.verify(|| {
        sheet.check(
            "from the first to the last turning point, every stroke is half a cycle of the damped motion",
            W::Num::from(damped.value() * last - damped.value() * first),
            W::Num::from(strokes * PI),
        );
        // The rate at which the envelope falls, from the decrement.
        let rate = fits.both.decrement * damped.value() / (2.0 * PI);
        sheet.check(
            "the natural frequency is the distance of the complex root from the origin",
            W::Num::from(natural.value()),
            W::Num::from(damped.value().hypot(rate)),
        );
    });
    natural
}

/// Holds a damping ratio to its decrement by a release from rest.
fn released<W: Worksheet>(ratio: W::Num, decrement: W::Num, sheet: W) {
    let ratio = ratio.value();
    let motion =
        FreeMotion { natural_frequency: 1.0, damping_ratio: ratio, displacement: 1.0, velocity: 0.0 };
    let period = 2.0 * PI / motion.damped_frequency();
    if let Some([left, _]) = motion.integrated(period) {
        sheet.check_sum(
            "amplitude ratio after one cycle of a release from rest with this damping ratio, by integration of the equation of motion",
            W::Num::from(left),
            W::Num::from((-decrement.value()).exp()),
            1.0,
        );
    }
}

fn viscous<W: Worksheet>(fits: &DecayFits, points: &[(f64, f64)], sheet: W) {
    let fit = &fits.viscous;
    let decrement = sheet.numerical(
        "δᵥ",
        "1",
        fit.decrement,
        (
            "Viscous damping only: X = X₀ e^(−δn) by least squares on the amplitudes; its decrement",
            RAO.at("§2.6.3"),
        ),
    );
    sheet.check_zeros(
        "viscous damping alone: the least-squares solution satisfies its normal equations",
        fit.normal_equations,
        1.0,
    );
    ratio_errors("ζᵥ", decrement, sheet);
    let ratio = sheet.step(
        "ζᵥ",
        "1",
        sdof::damping_ratio_from_decrement(decrement),
        ("Damping ratio from that decrement", RAO.at("§2.6.3")),
    );
    let scatter = sheet.numerical("εᵥ", "mm", fit.scatter, "Its rms deviation from the amplitudes");
    sheet.answer("viscous_decrement", "Viscous only: decrement", decrement);
    sheet.answer("viscous_ratio", "Viscous only: damping ratio", ratio);
    sheet.answer("viscous_scatter", "Viscous only: fit residual", scatter);
    sheet.verify(|| {
        released(ratio, decrement, sheet);
        let what = [
            "viscous damping alone: the residuals are orthogonal to the change of the exponential with its decrement",
            "viscous damping alone: rms value of the residuals",
        ];
        fitted::check(what, points, [decrement.value(), 0.0], scatter.value(), sheet);
    });
}

fn friction<W: Worksheet>(fits: &DecayFits, points: &[(f64, f64)], sheet: W) {
    let fit = &fits.friction;
    let loss = sheet.numerical(
        "ΔX",
        "mm",
        fit.loss,
        ("Friction alone: X = X₀ − ΔX n by least squares; its amplitude decrease per cycle", RAO.at("§2.9")),
    );
    sheet.check_zeros(
        "friction alone: the least-squares solution satisfies its normal equations",
        fit.normal_equations,
        1.0,
    );
    sheet.common_error("f_f", "the friction loss of a half-cycle used for a whole cycle", || loss / 2.0);
    let offset =
        sheet.step("f_f", "mm", loss / 4.0, ("Amplitude decrease per cycle: 4F/k; F/k", RAO.at("§2.9")));
    let scatter = sheet.numerical("ε_f", "mm", fit.scatter, "Its rms deviation from the amplitudes");
    sheet.answer("friction_loss", "Friction alone: amplitude decrease per cycle", loss);
    sheet.answer("friction_offset", "Friction alone: F/k", offset);
    sheet.answer("friction_scatter", "Friction alone: fit residual", scatter);
    sheet.verify(|| {
        let what = [
            "friction alone: the residuals are orthogonal to the cycles",
            "friction alone: rms value of the residuals",
        ];
        fitted::check(what, points, [0.0, loss.value()], scatter.value(), sheet);
    });
}

fn both<W: Worksheet>(fits: &DecayFits, points: &[(f64, f64)], sheet: W) {
    sheet.check_zeros(
        "both together: the least-squares solution satisfies its normal equations",
        fits.both.normal_equations,
        1.0,
    );
    let scatter = sheet.numerical(
        "ε",
        "mm",
        fits.both.scatter,
        "Combined fit by least squares: X = X₀ e^(−δn) − d (1 − e^(−δn))/δ; rms residual",
    );
    sheet.answer("both_scatter", "Combined: fit residual", scatter);
    sheet.verify(|| {
        let what = "both together: rms value of the residuals";
        fitted::check_scatter(what, points, [fits.both.decrement, fits.both.loss], scatter.value(), sheet);
    });
}

/// Damping ratio and `F/k` of the fit with both.
fn of_both<W: Worksheet>(fits: &DecayFits, points: &[(f64, f64)], sheet: W) -> [W::Num; 2] {
    let fit = &fits.both;
    let decrement = sheet.numerical("δ", "1", fit.decrement, "Combined fit: viscous decrement");
    ratio_errors("ζ", decrement, sheet);
    let ratio = sheet.step(
        "ζ",
        "1",
        sdof::damping_ratio_from_decrement(decrement),
        ("Damping ratio from that decrement", RAO.at("§2.6.3")),
    );
    let loss = sheet.numerical(
        "d",
        "mm",
        fit.loss,
        "Combined fit: amplitude decrease per cycle with friction alone",
    );
    let offset = if fit.decrement > 1e-3 {
        // tanh(δ/4) = (1 − q)/(1 + q) with q = e^(−δ/2), what viscous damping leaves in a stroke.
        let one = W::Num::from(1.0);
        let kept = sheet.step(
            "q",
            "1",
            (-(decrement / 2.0)).exp(),
            "Amplitude ratio per half-cycle due to viscous damping alone",
        );
        loss / decrement * (one - kept) / (one + kept)
    } else {
        // The next term of the series is (δ/4)²/3 of it.
        loss / 4.0
    };
    let offset = sheet.step(
        "f",
        "mm",
        offset,
        "Combined fit: F/k, which reduces the amplitude by f (1 + q) per half-cycle",
    );
    sheet.answer("decrement", "Combined: viscous decrement", decrement);
    sheet.answer("damping_ratio", "Combined: damping ratio", ratio);
    sheet.answer("offset", "Combined: F/k", offset);
    sheet.verify(|| {
        released(ratio, decrement, sheet);
        let what = "both together: the residuals are orthogonal to the changes with decrement and friction";
        fitted::check_slopes(what, points, [decrement.value(), loss.value()], sheet);
        let [decrement, loss, offset] = [decrement, loss, offset].map(Real::value);
        if decrement > 1e-3 {
            let kept = (-decrement / 2.0).exp();
            let stroke = offset * (1.0 + kept);
            sheet.check(
                "the friction losses of two successive strokes add up to the loss per cycle",
                W::Num::from(stroke * kept + stroke),
                W::Num::from(-loss * (-decrement).exp_m1() / decrement),
            );
        }
    });
    [ratio, offset]
}

/// Damping mechanism that the record shows.
#[derive(Clone, Copy, PartialEq)]
enum Verdict {
    Viscous,
    Friction,
    Both,
    Open,
}

/// The ratio of the scatters that the verdict rests on.
fn verdict<W: Worksheet>(fits: &DecayFits, sheet: W) -> Verdict {
    let size = fits.both.initial.abs();
    // Scatters below a millionth of the amplitude are rounding of the record.
    let floor = 1e-6 * size;
    let [viscous, friction, both] =
        [fits.viscous, fits.friction, fits.both].map(|fit| fit.scatter.max(floor));
    let ratio = sheet.numerical(
        "ρ",
        "1",
        viscous / friction,
        "Fit residual of the exponential over that of the straight line: below 1 indicates viscous damping, above 1 friction; a residual below one millionth of the amplitude is set to that value",
    );
    let gain = sheet.numerical(
        "ρ₂",
        "1",
        viscous.min(friction) / both,
        "Fit residual of the better single model over that of the combined model: well above 1, only the combined model explains the record",
    );
    sheet.answer("scatter_ratio", "Residual ratio, viscous over friction", ratio);
    sheet.answer("gain", "Residual ratio, best single fit over combined", gain);
    let verdict = match (ratio.value(), gain.value()) {
        (_, gain) if gain > 2.0 => Verdict::Both,
        (ratio, _) if ratio < 0.67 => Verdict::Viscous,
        (ratio, _) if ratio > 1.5 => Verdict::Friction,
        _ => Verdict::Open,
    };
    if verdict == Verdict::Open {
        sheet.warn(|| {
            Text::new(
                "the record does not distinguish viscous damping from friction: both fit it almost equally well; record more cycles, down to smaller amplitudes",
            )
        });
    }
    verdict
}

/// The three fits side by side, and the verdict.
fn side_by_side(fits: &DecayFits, verdict: Verdict) -> TableExhibit {
    let column = |heading: &'static str, unit| Column { heading: heading.into(), unit };
    let row = |name: &'static str, fit: &DecayFit, is: bool| {
        vec![
            Cell::from(name),
            Cell::Number(fit.initial),
            Cell::Number(fit.decrement),
            Cell::Number(fit.loss),
            Cell::Number(fit.scatter),
            if is { Cell::from("selected") } else { Cell::Empty },
        ]
    };
    TableExhibit {
        title: "Three fits of the decay".into(),
        columns: vec![
            column("damping", ""),
            column("first amplitude", "mm"),
            column("decrement", "1"),
            column("friction loss per cycle", "mm"),
            column("scatter", "mm"),
            column("verdict", ""),
        ],
        rows: vec![
            row("viscous", &fits.viscous, verdict == Verdict::Viscous),
            row("friction", &fits.friction, verdict == Verdict::Friction),
            row("both", &fits.both, verdict == Verdict::Both),
        ],
        foot: Vec::new(),
    }
}

fn envelopes(points: &[(f64, f64)], fits: &DecayFits) -> Plot {
    let ends = points
        .iter()
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), point| (low.min(point.0), high.max(point.0)));
    let curve = |fit: &DecayFit| {
        (0..=120u16)
            .map(|n| ends.0 + (ends.1 - ends.0) * f64::from(n) / 120.0)
            .map(|n| (n, decay_fit::amplitude(fit, n)))
            .collect::<Vec<_>>()
    };
    Plot::new(
        "Amplitudes and the three fits",
        Axis::linear("cycles", "1"),
        Axis::linear("amplitude", "mm"),
        vec![
            Series::line("viscous", curve(&fits.viscous)),
            Series::line("friction", curve(&fits.friction)),
            Series::line("both", curve(&fits.both)),
            Series::dots("measured", points.to_vec()),
        ],
    )
}

/// The record with its turning points; long records are thinned.
fn record_plot(samples: &[DecaySample], noise: f64) -> Plot {
    let record: Vec<(f64, f64)> = samples.iter().map(|sample| (sample.time, sample.displacement)).collect();
    let every = record.len().div_ceil(500).max(1);
    let turning = decay_fit::turning_points(&record, noise);
    let dots = turning.iter().take(200).map(|point| (point.time, point.displacement)).collect();
    Plot::new(
        "Record and its turning points",
        Axis::linear("time", "s"),
        Axis::linear("displacement", "mm"),
        vec![
            Series::line("x", record.into_iter().step_by(every).collect()),
            Series::dots("turning points", dots),
        ],
    )
}
