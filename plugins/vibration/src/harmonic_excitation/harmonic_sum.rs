//! Harmonic motions added up: phasors and beats; and the work of a harmonic force on a harmonic motion.

use std::f64::consts::TAU;

use dalembert_core::{
    About, Analysis, Axis, Drawing, Exhibit, Ink, Inputs, Plot, Refusal, Series, Sketch, Text, Worksheet,
    register,
};
use dalembert_mechanics::Real;

mod work;

use crate::{
    shared::{
        letters::{letter_of_row, of_row},
        oscillator::{is_one, transient_from_rest::Wave},
    },
    sources::{RAO, THOMSON},
};

/// Inputs of a sum of harmonic motions.
#[derive(Clone, Debug, Inputs)]
pub struct HarmonicSum {
    /// Find.
    pub question: HarmonicTask,
}

/// Quantity to compute.
#[derive(Clone, Debug, Inputs)]
pub enum HarmonicTask {
    /// Sum of harmonic motions
    Sum {
        /// Written as.
        wave: Wave,
        /// Motions.
        #[input(min = 1)]
        motions: Vec<Harmonic>,
        /// Time.
        /// At which the displacement is requested.
        #[input("t", "s", nonnegative)]
        time: Option<f64>,
    },
    /// Work of a harmonic force on a harmonic motion
    Work {
        /// Amplitude of the force.
        /// The force is F₀ sin ωt.
        #[input("F₀", "N", positive)]
        force: f64,
        /// Amplitude of the motion.
        #[input("X", "m", positive, kind = "Amplitude")]
        amplitude: f64,
        /// Frequency.
        #[input("ω", "rad/s", positive)]
        frequency: f64,
        /// Phase lag of the motion.
        /// The motion is X sin (ωt − φ).
        #[input("φ", "deg")]
        lag: f64,
        /// Time.
        /// From the beginning of the force.
        #[input("t", "s", positive)]
        time: f64,
    },
}

/// One harmonic motion.
#[derive(Clone, Debug, Inputs)]
pub struct Harmonic {
    /// Amplitude.
    #[input("A", "m", positive, kind = "Amplitude")]
    pub amplitude: f64,
    /// Frequency.
    #[input("ω", "rad/s", positive)]
    pub frequency: f64,
    /// Phase.
    /// The phase added to ωt: positive for a leading motion.
    #[input("α", "deg", default = "0 deg")]
    pub phase: f64,
}

register!(HarmonicSum);

impl Analysis for HarmonicSum {
    const ABOUT: About = About {
        id: "vibration/harmonic-sum",
        title: "Superposition of harmonic motions",
        topic: "Harmonic excitation",
        summary: "Phasor sum of harmonic motions, beats of two with nearly equal frequencies, and the work of a harmonic force on a harmonic motion.",
        main: &["amplitude", "phase", "largest", "beat_frequency", "work"],
        keywords: "beat beating phasor rotating vector superposition batimento fasor vetor girante soma harmônica \
                   trabalho",
        sources: &[&RAO, &THOMSON],
        cases: include_str!("../../cases/harmonic_sum.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &HarmonicSumGiven<W>, sheet: W) -> Result<(), Refusal> {
        match (&given.question, &self.question) {
            (HarmonicTaskGiven::Work { force, amplitude, frequency, lag, time }, _) => {
                work::solve([*force, *amplitude], *frequency, *lag, *time, sheet);
                Ok(())
            }
            (
                HarmonicTaskGiven::Sum { motions, time, .. },
                HarmonicTask::Sum { wave, motions: typed, .. },
            ) => sum(motions, typed, *wave, *time, sheet),
            _ => unreachable!("what is given is made from what was typed"),
        }
    }
}

/// Motions of one frequency, added up.
#[derive(Clone, Copy)]
struct Resultant<N> {
    amplitude: N,
    phase: N,
    frequency: N,
}

fn sum<W: Worksheet>(
    given: &[HarmonicGiven<W>],
    typed: &[Harmonic],
    wave: Wave,
    time: Option<W::Num>,
    sheet: W,
) -> Result<(), Refusal> {
    let groups = groups(given, sheet)?;
    match groups[..] {
        [one] => {
            sheet.answer("amplitude", "Amplitude of the sum", one.amplitude);
            sheet.answer("phase", "Phase of the sum", one.phase);
            sheet.answer("frequency", "Frequency", one.frequency);
        }
        [one, other] => beats(one, other, sheet),
        _ => {
            let largest = W::Num::sum(groups.iter().map(|group| group.amplitude));
            sheet.common_error("A_max", "the amplitudes combined as perpendicular components", || {
                W::Num::sum(groups.iter().map(|group| group.amplitude.powi(2))).sqrt()
            });
            let largest = sheet.step(
                "A_max",
                "mm",
                largest,
                "The displacement never exceeds the sum of the amplitudes",
            );
            sheet.answer("largest", "Upper bound of the displacement", largest);
        }
    }
    let half = W::Num::sum(groups.iter().map(|group| group.amplitude.powi(2))) / 2.0;
    if groups.len() > 1 {
        sheet.common_error("x_rms", "the root mean squares of the motions added", || {
            W::Num::sum(groups.iter().map(|group| group.amplitude)) / 2.0_f64.sqrt()
        });
    }
    let rms = sheet.step("x_rms", "mm", half.sqrt(), ("Root mean square over a long time", RAO.at("§1.10")));
    sheet.answer("rms", "Root mean square", rms);
    let of = |amplitude: W::Num, frequency: W::Num, phase: W::Num, time: W::Num| {
        let angle = frequency * time + phase;
        match wave {
            Wave::Sine => amplitude * angle.sin(),
            Wave::Cosine => amplitude * angle.cos(),
        }
    };
    if let Some(time) = time {
        let x =
            W::Num::sum(groups.iter().map(|group| of(group.amplitude, group.frequency, group.phase, time)));
        let x = sheet.step("x", "mm", x, "Displacement at that time");
        sheet.answer("displacement", "Displacement at that time", x);
        let direct = W::Num::sum(given.iter().map(|one| of(one.amplitude, one.frequency, one.phase, time)));
        let scale: f64 = given.iter().map(|one| one.amplitude.value()).sum();
        sheet.check_zero("sum of the individual motions at that time", direct - x, scale);
    }
    sheet.verify(|| {
        // Every motion against every other: the mean of their product is cos(α₁ − α₂)/2 where the frequencies agree.
        let same = |a: f64, b: f64| is_one(a / b);
        let mean: f64 = given
            .iter()
            .flat_map(|a| given.iter().map(move |b| (a, b)))
            .filter(|(a, b)| same(a.frequency.value(), b.frequency.value()))
            .map(|(a, b)| {
                let angle = a.phase.value() - b.phase.value();
                a.amplitude.value() * b.amplitude.value() * angle.cos() / 2.0
            })
            .sum();
        let scale: f64 = given.iter().map(|one| one.amplitude.value()).sum::<f64>().powi(2);
        sheet.check_zero(
            "mean square from the products of all pairs",
            W::Num::from(rms.value().powi(2) - mean),
            scale,
        );
    });
    let last = span(&groups.iter().map(|group| group.frequency.value()).collect::<Vec<_>>());
    sheet.show(|| Exhibit::Plot(over_time(typed, wave, last, groups.len() == 2)));
    sheet.show(|| Exhibit::Drawing(vectors(typed, groups.len() == 1)));
    Ok(())
}

/// Adds up the motions of each frequency.
fn groups<W: Worksheet>(given: &[HarmonicGiven<W>], sheet: W) -> Result<Vec<Resultant<W::Num>>, Refusal> {
    let mut groups: Vec<Vec<&HarmonicGiven<W>>> = Vec::new();
    for one in given {
        let same = |group: &&mut Vec<&HarmonicGiven<W>>| {
            group.first().is_some_and(|first| is_one(one.frequency.value() / first.frequency.value()))
        };
        match groups.iter_mut().find(same) {
            Some(group) => group.push(one),
            None => groups.push(vec![one]),
        }
    }
    let several = groups.len() > 1;
    let mut resultants = Vec::new();
    for (n, group) in groups.iter().enumerate() {
        sheet.keep_going()?;
        let frequency = group[0].frequency;
        if let [one] = group[..]
            && several
        {
            resultants.push(Resultant { amplitude: one.amplitude, phase: one.phase, frequency });
            continue;
        }
        let symbol = |base: &'static str| {
            let symbol = dalembert_core::Symbol::from(base);
            if several { symbol.row(n + 1) } else { symbol }
        };
        let part =
            |of: fn(W::Num) -> W::Num| W::Num::sum(group.iter().map(|one| one.amplitude * of(one.phase)));
        let along = sheet.step(
            symbol("R_x"),
            "mm",
            part(W::Num::cos),
            (
                "Rotating vectors of the same frequency keep their relative angles: their components add up",
                RAO.at("§1.10"),
            ),
        );
        let across = sheet.step(symbol("R_y"), "mm", part(W::Num::sin), "Transverse components");
        if group.len() > 1 {
            sheet.common_error(symbol("R"), "the amplitudes added without their phases", || {
                W::Num::sum(group.iter().map(|one| one.amplitude))
            });
            sheet.common_error(symbol("R"), "the amplitudes combined as perpendicular components", || {
                W::Num::sum(group.iter().map(|one| one.amplitude.powi(2))).sqrt()
            });
        }
        let amplitude = sheet.step(
            symbol("R"),
            "mm",
            (along.powi(2) + across.powi(2)).sqrt(),
            "Length of the resulting vector",
        );
        if group.len() > 1 {
            sheet.common_error(symbol("θ"), "the mean of the phases taken", || {
                W::Num::sum(group.iter().map(|one| one.phase)) / group.len() as f64
            });
        }
        let phase = sheet.step(symbol("θ"), "deg", across.atan2(along), "Its angle");
        resultants.push(Resultant { amplitude, phase, frequency });
    }
    Ok(resultants)
}

/// Two motions of different frequencies.
fn beats<W: Worksheet>(one: Resultant<W::Num>, other: Resultant<W::Num>, sheet: W) {
    let (slow, fast) =
        if one.frequency.value() < other.frequency.value() { (one, other) } else { (other, one) };
    let (large, small) =
        if one.amplitude.value() < other.amplitude.value() { (other, one) } else { (one, other) };
    let cite = || RAO.at("§1.10");
    sheet.common_error("A_max", "the amplitudes combined as perpendicular components", || {
        (large.amplitude.powi(2) + small.amplitude.powi(2)).sqrt()
    });
    let largest = sheet.step(
        "A_max",
        "mm",
        large.amplitude + small.amplitude,
        ("Maximum amplitude, when the two motions are in phase", cite()),
    );
    let least = sheet.step(
        "A_min",
        "mm",
        large.amplitude - small.amplitude,
        ("Minimum amplitude, when they are in opposite phase", cite()),
    );
    sheet.common_error("ω_b", "the mean of the two frequencies taken", || {
        (fast.frequency + slow.frequency) / 2.0
    });
    let beat = sheet.step(
        "ω_b",
        "Hz",
        fast.frequency - slow.frequency,
        ("Beat frequency: rate at which the faster vector overtakes the slower one", cite()),
    );
    sheet.common_error("T_b", "the difference of the two periods taken", || {
        W::Num::from(TAU) / slow.frequency - W::Num::from(TAU) / fast.frequency
    });
    let period = sheet.step("T_b", "s", W::Num::from(TAU) / beat, "Time between two maxima of the amplitude");
    let mean = sheet.step(
        "ω_m",
        "rad/s",
        (fast.frequency + slow.frequency) / 2.0,
        "Frequency of the oscillation within the beats",
    );
    sheet.check(
        "maximum and minimum amplitude give the mean square of the envelope",
        (largest.powi(2) + least.powi(2)) / 2.0,
        one.amplitude.powi(2) + other.amplitude.powi(2),
    );
    let turn = W::Num::from(TAU);
    sheet.check_sum(
        "from one maximum of the amplitude to the next the faster vector gains one revolution on the slower one",
        (fast.frequency - slow.frequency) * period,
        turn,
        fast.frequency.value() * period.value(),
    );
    let (a, b) = (W::Num::from(1.0), slow.frequency / fast.frequency);
    sheet.check(
        "two motions of equal amplitude equal one beating motion at the mean frequency, sin ω₁t + sin ω₂t = 2 sin ω_m t cos(ω_b t/2)",
        a.sin() + b.sin(),
        (mean / fast.frequency).sin() * (beat / fast.frequency / 2.0).cos() * 2.0,
    );
    sheet.answer("largest", "Maximum amplitude", largest);
    sheet.answer("least", "Minimum amplitude", least);
    sheet.answer("beat_frequency", "Beat frequency", beat);
    sheet.answer("beat_period", "Beat period", period);
    sheet.answer("mean_frequency", "Mean frequency", mean);
    if slow.frequency.value() < 0.7 * fast.frequency.value() {
        sheet.warn(|| {
            Text::new("the frequencies are so far apart that the sum shows no beats: the fast motion is superposed on the slow one")
        });
    }
}

/// Time span of a plot: two beats or a few cycles.
fn span(frequencies: &[f64]) -> f64 {
    let slowest = frequencies.iter().copied().fold(f64::INFINITY, f64::min);
    let fastest = frequencies.iter().copied().fold(0.0, f64::max);
    let cycles = 3.0 * TAU / slowest;
    match frequencies {
        [a, b] => (2.0 * TAU / (a - b).abs()).max(cycles).min(60.0 * TAU / fastest),
        _ => cycles,
    }
}

fn over_time(motions: &[Harmonic], wave: Wave, last: f64, two: bool) -> Plot {
    let times = || (0..=500u16).map(|n| last * f64::from(n) / 500.0);
    let at = |t: f64| -> f64 {
        let of = |one: &Harmonic| {
            let angle = one.frequency * t + one.phase;
            one.amplitude * if wave == Wave::Sine { angle.sin() } else { angle.cos() }
        };
        motions.iter().map(of).sum()
    };
    let mut series = vec![Series::line("x", times().map(|t| (t, at(t))).collect()).of("displacement")];
    if two {
        // The length of the sum of the vectors, seen from one that turns along.
        let envelope = |t: f64| {
            let first = motions[0].frequency;
            let angle = |one: &Harmonic| (one.frequency - first) * t + one.phase;
            let along: f64 = motions.iter().map(|one| one.amplitude * angle(one).cos()).sum();
            let across: f64 = motions.iter().map(|one| one.amplitude * angle(one).sin()).sum();
            along.hypot(across)
        };
        series.push(Series::line("envelope", times().map(|t| (t, envelope(t))).collect()).with_reflection());
    }
    let (x, y) = (Axis::linear("time", "s"), Axis::linear("displacement", "mm"));
    Plot::new("Sum against time", x, y, series).over("question.sum.time")
}

fn vectors(motions: &[Harmonic], resultant: bool) -> Drawing {
    let size = motions.iter().map(|one| one.amplitude).fold(f64::MIN_POSITIVE, f64::max);
    let mut sketch = Sketch::new("Rotating vectors at the start");
    let mut tip = (0.0, 0.0);
    for (one, row) in motions.iter().zip(1..) {
        let (sin, cos) = one.phase.sin_cos();
        let length = 3.0 * one.amplitude / size;
        let next = (tip.0 + length * cos, tip.1 + length * sin);
        sketch.edge(of_row(&["A"], row), tip, next, Ink::Motion).axis(tip, (tip.0 + 1.2, tip.1)).angle(
            of_row(&["α"], row),
            tip,
            0.0,
            one.phase,
        );
        tip = next;
    }
    let letters: Vec<String> = (1..=motions.len()).map(|row| letter_of_row("ω", row)).collect();
    if resultant {
        sketch.edge("R", (0.0, 0.0), tip, Ink::Result);
    }
    sketch.couple(Text::verbatim(letters.join(", ")), (0.0, 0.0), (3.6, 5.2), Ink::Motion).finish()
}
