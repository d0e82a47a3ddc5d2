//! Benchmark of the plain reading of a solve beside the hand-written loop.
//!
//! Prints `name<TAB>figure<TAB>goal`, a row a line; `cargo xtask bench` makes a table of them.

use std::{hint::black_box, time::Instant};

use dalembert_core::{
    About, Analysis, Draft, Entry, Inputs, Lift, Plain, Refusal, Source, Stop, Worksheet, cases, find,
    register, worksheet::FieldPath,
};
use dalembert_mechanics::{Real, sdof};
use dalembert_plugins as _;

const POINTS: usize = 1_000_000;
const ROUNDS: usize = 15;

/// A machine with a rotating unbalance, reduced to its amplitude: what is measured is the machinery around it.
#[derive(Clone, Debug, Inputs)]
struct Fan {
    /// Mass.
    #[input("m", "kg", positive)]
    mass: f64,
    /// Unbalance.
    #[input("m₀e", "kg*m", positive)]
    unbalance: f64,
    /// Stiffness.
    #[input("k", "N/m", positive)]
    stiffness: f64,
    /// Damping ratio.
    #[input("ζ", "1", nonnegative)]
    ratio: f64,
    /// Speed.
    #[input("ω", "rad/s", positive)]
    speed: f64,
}

static NOTES: Source =
    Source { short: "Rao", full: "S. S. Rao, Mechanical Vibrations, 5th ed., Prentice Hall, 2011" };

register!(Fan);

impl Analysis for Fan {
    const ABOUT: About = About {
        id: "bench/fan",
        title: "Fan",
        summary: "The amplitude of an unbalanced machine.",
        topic: "",
        main: &[],
        keywords: "",
        sources: &[&NOTES],
        cases: "",
    };

    fn solve<W: Worksheet>(&self, given: &FanGiven<W>, sheet: W) -> Result<(), Refusal> {
        let natural = sheet.step(
            "ωₙ",
            "rad/s",
            sdof::natural_frequency(given.stiffness, given.mass),
            ("Natural frequency", NOTES.at("§2.2")),
        );
        let ratio = sheet.step("r", "1", sdof::frequency_ratio(given.speed, natural), "Frequency ratio");
        if self.ratio == 0.0 && ratio.value() == 1.0 {
            return Err(Refusal::because("the amplitude grows without bound"));
        }
        let amplitude = sheet.step(
            "X",
            "mm",
            given.unbalance / given.mass * sdof::unbalance_magnification(ratio, given.ratio),
            ("Steady amplitude", NOTES.at("§3.7")),
        );
        let c = sheet.step(
            "c",
            "N*s/m",
            sdof::damping_from_ratio(given.ratio, given.stiffness, given.mass),
            "Damping coefficient",
        );
        sheet.check(
            "amplitude from the dynamic stiffness",
            sdof::unbalance_amplitude(given.unbalance, given.stiffness, given.mass, c, given.speed),
            amplitude,
        );
        sheet.answer("amplitude", "Amplitude", amplitude);
        Ok(())
    }
}

fn main() {
    let speeds: Vec<f64> = (0..POINTS).map(|n| 50.0 + n as f64 * 1e-4).collect();
    reduced(&speeds);
    whole(&speeds);
}

/// The amplitude alone: by hand, read plain with the type known, and read plain through the registry.
fn reduced(speeds: &[f64]) {
    let fan = Fan { mass: 40.0, unbalance: 0.1, stiffness: 451_388.9, ratio: 0.06169, speed: 104.72 };
    let mut by_hand = vec![0.0; POINTS];
    let hand = time(|| amplitudes_by_hand(black_box(&fan), speeds, &mut by_hand));
    let mut direct = vec![0.0; POINTS];
    let typed = time(|| {
        let stop = Stop::new();
        let plain = Plain::new(&stop);
        let mut fan = fan.clone();
        for (speed, place) in speeds.iter().zip(&mut direct) {
            fan.speed = *speed;
            plain.clear();
            let given = fan.given(Lift { sheet: &plain, value: None, field_path: &FieldPath::TOP });
            let solved = fan.solve(&given, &plain);
            *place = solved.ok().and_then(|()| plain.answer_at(0, "amplitude".into())).unwrap_or(f64::NAN);
        }
    });
    assert_eq!(by_hand, direct, "the plain reading gives the numbers of the loop by hand, bit for bit");
    let entry = Entry::of::<Fan>();
    let mut draft = Draft::blank(&entry.shape());
    for (path, text) in [
        ("mass", "40 kg"),
        ("unbalance", "0.1 kg*m"),
        ("stiffness", "451388.9 N/m"),
        ("ratio", "0.06169"),
        ("speed", "104.72 rad/s"),
    ] {
        draft.set(&entry.shape(), path, text).expect("the fields of the fan");
    }
    let record = draft.read(&entry.shape()).expect("the values of the fan");
    let mut sweep =
        entry.prepare(&record, &["speed"], &["amplitude"]).expect("speed and amplitude are numbers");
    let mut swept = vec![0.0; POINTS];
    let registry = time(|| sweep.sweep(speeds, &mut swept, &Stop::new()).expect("nobody stops it"));
    assert_eq!(by_hand, swept, "the sweep gives the numbers of the loop by hand, bit for bit");
    row("amplitude, loop by hand", hand, "");
    row("amplitude, plain reading, type known", typed, "");
    row("amplitude, plain reading, by sweep", registry, "");
    ratio("amplitude, type known against by hand", typed / hand, 2.5);
    // A sweep may vary any input, so nothing can be taken out of its loop; by hand it would be the same.
    let inputs: Vec<f64> =
        speeds.iter().flat_map(|speed| [fan.mass, fan.unbalance, fan.stiffness, fan.ratio, *speed]).collect();
    let every = time(|| amplitudes_of_any_inputs(black_box(&inputs), &mut by_hand));
    let paths = ["mass", "unbalance", "stiffness", "ratio", "speed"];
    let mut sweep = entry.prepare(&record, &paths, &["amplitude"]).expect("they are numbers");
    let swept_every = time(|| sweep.sweep(&inputs, &mut swept, &Stop::new()).expect("nobody stops it"));
    assert_eq!(by_hand, swept, "the sweep gives the numbers of the loop by hand, bit for bit");
    row("amplitude of any inputs, loop by hand", every, "");
    row("amplitude of any inputs, by sweep", swept_every, "");
    ratio("amplitude of one input, sweep against by hand", registry / hand, 2.5);
    ratio("amplitude of any inputs, sweep against by hand", swept_every / every, 2.5);
}

fn amplitudes_of_any_inputs(inputs: &[f64], amplitudes: &mut [f64]) {
    for (inputs, place) in inputs.chunks_exact(5).zip(amplitudes) {
        let r = inputs[4] / (inputs[2] / inputs[0]).sqrt();
        *place =
            inputs[1] / inputs[0] * (r * r / ((1.0 - r * r).powi(2) + (inputs[3] * r * 2.0).powi(2)).sqrt());
    }
}

fn amplitudes_by_hand(fan: &Fan, speeds: &[f64], amplitudes: &mut [f64]) {
    for (speed, place) in speeds.iter().zip(amplitudes) {
        let natural = (fan.stiffness / fan.mass).sqrt();
        let r = speed / natural;
        *place = fan.unbalance / fan.mass
            * (r * r / ((1.0 - r * r).powi(2) + (fan.ratio * r * 2.0).powi(2)).sqrt());
    }
}

/// The first case of the rotating unbalance with every number it answers.
fn whole(speeds: &[f64]) {
    let entry = find("vibration/rotating-unbalance").expect("the rotating unbalance is registered");
    let case = cases::first(entry).expect("it has a case");
    let record = case.record(entry).expect("its inputs can be read");
    let names = [
        "stiffness",
        "natural_frequency",
        "frequency_ratio",
        "damping_ratio",
        "damping",
        "amplitude",
        "phase",
        "transmitted_force",
        "worst_speed",
    ];
    let mut by_hand = vec![0.0; POINTS * names.len()];
    let mut swept = vec![0.0; POINTS * names.len()];
    let fixed = black_box([40.0, 0.1, 1.2, 200e9, 1.3e-6, 20.3e-3]);
    let hand = time(|| answers_over_speed(fixed, speeds, &mut by_hand));
    let mut sweep = entry.prepare(&record, &["speed"], &names).expect("the answers are numbers");
    let plain = time(|| sweep.sweep(speeds, &mut swept, &Stop::new()).expect("nobody stops it"));
    assert_near(&swept, &by_hand);
    row("rotating unbalance, 9 answers over speed, loop by hand", hand, "");
    row("rotating unbalance, 9 answers over speed, by sweep", plain, "");
    ratio("rotating unbalance over speed, sweep against by hand", plain / hand, 2.5);
    let paths = [
        "mass",
        "unbalance",
        "support.cantilever.length",
        "support.cantilever.young",
        "support.cantilever.section.given.second_moment",
        "damping.largest-amplitude.amplitude",
        "speed",
    ];
    let inputs: Vec<f64> = speeds.iter().flat_map(|speed| fixed.into_iter().chain([*speed])).collect();
    let hand = time(|| answers_of_any_inputs(black_box(&inputs), &mut by_hand));
    let mut sweep = entry.prepare(&record, &paths, &names).expect("the inputs and answers are numbers");
    let plain = time(|| sweep.sweep(&inputs, &mut swept, &Stop::new()).expect("nobody stops it"));
    assert_near(&swept, &by_hand);
    row("rotating unbalance of any inputs, loop by hand", hand, "");
    row("rotating unbalance of any inputs, by sweep", plain, "");
    ratio("rotating unbalance of any inputs, sweep against by hand", plain / hand, 2.5);
}

fn assert_near(ours: &[f64], theirs: &[f64]) {
    for (ours, theirs) in ours.iter().zip(theirs) {
        assert!((ours - theirs).abs() <= 1e-12 * theirs.abs(), "{ours} by sweep, {theirs} by hand");
    }
}

/// The nine answers, with all that does not depend on the speed taken out of the loop.
fn answers_over_speed(fixed: [f64; 6], speeds: &[f64], answers: &mut [f64]) {
    let machine = Machine::new(fixed);
    for (speed, row) in speeds.iter().zip(answers.chunks_exact_mut(9)) {
        row.copy_from_slice(&machine.answers(*speed));
    }
}

fn answers_of_any_inputs(inputs: &[f64], answers: &mut [f64]) {
    for (inputs, row) in inputs.chunks_exact(7).zip(answers.chunks_exact_mut(9)) {
        let &[mass, unbalance, length, young, second_moment, largest, speed] = inputs else { return };
        let machine = Machine::new([mass, unbalance, length, young, second_moment, largest]);
        row.copy_from_slice(&machine.answers(speed));
    }
}

/// Parameters that do not depend on the speed.
struct Machine {
    static_eccentricity: f64,
    stiffness: f64,
    natural: f64,
    zeta: f64,
    damping: f64,
    worst: f64,
}

impl Machine {
    #[inline]
    fn new([mass, unbalance, length, young, second_moment, largest]: [f64; 6]) -> Self {
        let stiffness = 3.0 * young * second_moment / length.powi(3);
        let natural = (stiffness / mass).sqrt();
        let peak = largest * mass / unbalance;
        let zeta = ((1.0 - (1.0 - 1.0 / peak.powi(2)).sqrt()) / 2.0).sqrt();
        Self {
            static_eccentricity: unbalance / mass,
            stiffness,
            natural,
            zeta,
            damping: 2.0 * zeta * (stiffness * mass).sqrt(),
            worst: natural / (1.0 - 2.0 * zeta.powi(2)).sqrt(),
        }
    }

    #[inline]
    fn answers(&self, speed: f64) -> [f64; 9] {
        let r = speed / self.natural;
        let amplitude = self.static_eccentricity
            * (r * r / ((1.0 - r * r).powi(2) + (2.0 * self.zeta * r).powi(2)).sqrt());
        let phase = (2.0 * self.zeta * r).atan2(1.0 - r * r);
        let force = amplitude * (self.stiffness * self.stiffness + (self.damping * speed).powi(2)).sqrt();
        [self.stiffness, self.natural, r, self.zeta, self.damping, amplitude, phase, force, self.worst]
    }
}

/// The shortest of several runs, ns a point.
fn time(mut run: impl FnMut()) -> f64 {
    let mut best = f64::INFINITY;
    for _ in 0..ROUNDS {
        let start = Instant::now();
        run();
        best = best.min(start.elapsed().as_secs_f64());
    }
    best * 1e9 / POINTS as f64
}

fn row(name: &str, nanoseconds: f64, goal: &str) {
    println!("{name}\t{nanoseconds:.2} ns\t{goal}");
}

fn ratio(name: &str, ratio: f64, goal: f64) {
    println!("{name}\t{ratio:.2} ×\t≤ {goal} ×");
}
