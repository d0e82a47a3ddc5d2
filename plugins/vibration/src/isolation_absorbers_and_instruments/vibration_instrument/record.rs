//! The record of a motion of several tones: each with its own factor and its own delay.

use std::f64::consts::{PI, TAU};

use dalembert_core::{Axis, Cell, Column, Exhibit, Plot, Refusal, Series, TableExhibit, Text, Worksheet};
use dalembert_mechanics::{Real, sdof};

use super::{Instrument, Tone, VibrationInstrument};
use crate::{
    shared::oscillator::{is_one, resisting_force},
    sources::RAO,
};

/// The most tones that are recorded.
const MOST: usize = 8;

/// Factor and delay of each tone, and how far the delays lie apart.
pub(super) fn solve<W: Worksheet>(
    instrument: &VibrationInstrument,
    tones: &[Tone],
    natural: W::Num,
    zeta: W::Num,
    sheet: W,
) -> Result<(), Refusal> {
    if tones.is_empty() || tones.len() > MOST {
        return Err(Refusal::because(
            Text::new("write at least one tone and at most {most}").with("most", MOST),
        ));
    }
    let mut delays = Vec::new();
    for (n, tone) in (1..).zip(tones) {
        let frequency =
            sheet.numerical(("ω", n), "Hz", tone.frequency, "A tone of the motion, from the table");
        let ratio = sheet.step(("r", n), "1", frequency / natural, "Its frequency ratio");
        if zeta.value() == 0.0 && is_one(ratio.value()) {
            return Err(Refusal::because(
                "without damping, the reading at the natural frequency grows without bound: there is no steady state",
            ));
        }
        let why = ("Ratio of reading to true value of this tone", RAO.at("§10.3"));
        instrument.factor_errors(("M", n).into(), ratio, zeta, sheet);
        let factor = sheet.step(("M", n), "1", instrument.factor(ratio, zeta), why);
        let other = instrument.factor_of_square(ratio, zeta);
        sheet.check("the same from the square of the frequency ratio", other, factor);
        let lag = sdof::phase_lag_from_ratios(ratio, zeta);
        let (lag, why) = match instrument.instrument {
            Instrument::Accelerometer => (lag, "Phase lag of this tone"),
            Instrument::Vibrometer => {
                (lag - PI, "Phase lag of this tone in the inverted record, as a vibrometer shows it")
            }
        };
        let lag = sheet.step(("φ", n), "deg", lag, (why, RAO.at("§10.3")));
        let delay = sheet.step(("t", n), "ms", lag / frequency, "Delay of this tone");
        sheet.answer(("tone_factor", n), "Ratio of reading to true value of tone", factor);
        sheet.answer(("tone_delay", n), "Delay of tone", delay);
        sheet.verify(|| {
            // A vibrometer shows the relative motion turned over.
            let drive = match instrument.instrument {
                Instrument::Vibrometer => -ratio.powi(2),
                Instrument::Accelerometer => W::Num::from(1.0),
            };
            let ([in_phase, across], size) = resisting_force([ratio, zeta], factor, frequency * delay);
            let what = Text::new("tone {n}: equation of relative motion with this delay, in-phase component");
            sheet.check_sum(what.with("n", n), in_phase, drive, size);
            let what = Text::new(
                "tone {n}: equation of relative motion with this delay, quadrature component (90° ahead)",
            );
            sheet.check_zero(what.with("n", n), across, size);
        });
        delays.push((factor.value(), delay));
    }
    let by_size = |a: &&(f64, W::Num), b: &&(f64, W::Num)| a.1.value().total_cmp(&b.1.value());
    if let (Some(least), Some(most)) = (delays.iter().min_by(by_size), delays.iter().max_by(by_size))
        && tones.len() > 1
    {
        let why = "Phase distortion: difference between the delays";
        let spread = sheet.step("Δt", "ms", most.1 - least.1, (why, RAO.at("§10.3")));
        sheet.answer("distortion", "Phase distortion", spread);
    }
    let recorded: Vec<(f64, f64)> = delays.iter().map(|(factor, delay)| (*factor, delay.value())).collect();
    sheet.show(|| Exhibit::Table(table(tones, &recorded)));
    sheet.show(|| Exhibit::Plot(plot(tones, &recorded)));
    Ok(())
}

fn table(tones: &[Tone], recorded: &[(f64, f64)]) -> TableExhibit {
    let column = |heading: &'static str, unit| Column { heading: heading.into(), unit };
    let row = |(tone, (factor, delay)): (&Tone, &(f64, f64))| {
        [tone.frequency, tone.amplitude, factor * tone.amplitude, *delay].map(Cell::Number).to_vec()
    };
    TableExhibit {
        title: "Harmonic components of the motion and of the record".into(),
        columns: vec![
            column("frequency", "Hz"),
            column("true", "1"),
            column("recorded", "1"),
            column("delay", "ms"),
        ],
        rows: tones.iter().zip(recorded).map(row).collect(),
        foot: Vec::new(),
    }
}

fn plot(tones: &[Tone], recorded: &[(f64, f64)]) -> Plot {
    let slowest = tones.iter().map(|tone| tone.frequency).fold(f64::INFINITY, f64::min);
    let times = || (0..=300u16).map(|n| 2.0 * TAU / slowest * f64::from(n) / 300.0);
    let truth = |t: f64| tones.iter().map(|tone| tone.amplitude * (tone.frequency * t).sin()).sum::<f64>();
    let record = |t: f64| {
        let of = |(tone, (factor, delay)): (&Tone, &(f64, f64))| {
            factor * tone.amplitude * (tone.frequency * (t - delay)).sin()
        };
        tones.iter().zip(recorded).map(of).sum::<f64>()
    };
    Plot::new(
        "Motion and record",
        Axis::linear("time", "s"),
        Axis::linear("in the unit of the table", "1"),
        vec![
            Series::line("true motion", times().map(|t| (t, truth(t))).collect()),
            Series::line("recorded motion", times().map(|t| (t, record(t))).collect()),
        ],
    )
}
