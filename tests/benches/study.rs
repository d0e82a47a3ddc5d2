//! Benchmark of a study: a million samples of a rotating unbalance with statistics, as `dalembert study` carries them out.
//!
//! Prints `name<TAB>figure<TAB>goal`, a row a line; `cargo xtask bench` makes a table of them.

use std::{thread, time::Instant};

use dalembert_core::{
    Draft, Locale, Stop, find,
    study::{Amount, Design, DistributionKind, Study, StudyPlan, Summary, Variation},
};
use dalembert_plugins as _;
use dalembert_study::output::Run;

#[path = "../../crates/mechanics/benches/yardstick/python.rs"]
mod python;

/// Milliseconds of NumPy for the same samples, with their mean and standard deviation.
const YARDSTICK: &str = include_str!("../../crates/mechanics/benches/yardstick/unbalance.py");
const SAMPLES: u64 = 1_000_000;
const ROUNDS: usize = 5;
const INPUTS: [(&str, &str, &str); 5] = [
    ("mass", "100 kg", "1 kg"),
    ("support.stiffness.stiffness", "400 kN/m", "8 kN/m"),
    ("damping.coefficient.coefficient", "600 N*s/m", "60 N*s/m"),
    ("unbalance", "0.05 kg*m", "0.005 kg*m"),
    ("speed", "60 rad/s", "0.5 rad/s"),
];

fn main() {
    let yardstick = python::figures::<3>(YARDSTICK);
    let cores = thread::available_parallelism().map_or(1, usize::from);
    for threads in [1, cores] {
        let (summary, milliseconds) = measured(threads);
        let of = &summary.answers[0];
        let mut beside = String::new();
        if let Some([theirs, mean, deviation]) = yardstick {
            // Two means of a million samples differ by no more than a few of their standard errors.
            let error = deviation * 1e3 * (2.0 / SAMPLES as f64).sqrt();
            assert!((of.mean - mean * 1e3).abs() < 5.0 * error, "{} mm and {mean} m", of.mean);
            assert!(
                (of.deviation / (deviation * 1e3) - 1.0).abs() < 0.01,
                "{} mm and {deviation} m",
                of.deviation
            );
            beside = format!(", {:.2} of NumPy's {theirs:.0} ms", milliseconds / theirs);
        }
        println!(
            "dalembert study, rotating unbalance, 1e6 samples of 5 inputs, {threads} threads\t{milliseconds:.0} ms{beside}\t≤ 0.27 of NumPy on one thread"
        );
    }
}

/// The summary, and the shortest time of a few rounds.
fn measured(threads: usize) -> (Summary, f64) {
    let entry = find("vibration/rotating-unbalance").expect("an analysis");
    let shape = entry.shape();
    let mut draft = Draft::blank(&shape);
    for (path, value, _) in INPUTS {
        draft.set(&shape, path, value).expect("an input");
    }
    let record = draft.read(&shape).expect("a problem");
    let vary = |(path, _, deviation): &(&str, &str, &str)| Variation {
        input: Some((*path).to_owned()),
        distribution: Some(DistributionKind::Normal),
        deviation: Some(Amount::Text((*deviation).to_owned())),
        ..Variation::default()
    };
    let plan = StudyPlan {
        problem: entry.about.id.to_owned(),
        answers: vec!["amplitude".to_owned()],
        samples: Some(SAMPLES),
        vary: INPUTS.iter().map(vary).collect(),
        ..StudyPlan::default()
    };
    let design = Design::new(&plan, &record, &|_| unreachable!("the plan names no file")).expect("a plan");
    let solution = entry.solve(&record, &Stop::new()).expect("a solution");
    let study = Study::new(entry, &record, &plan, design, &solution).expect("a study");
    let (stop, locale) = (Stop::new(), Locale::english());
    let run =
        Run { study: &study, fingerprint: "", threads, locale: &locale, stop: &stop, progress: &|_| {} };
    let mut best = f64::INFINITY;
    let mut summary = Summary::default();
    for _ in 0..ROUNDS {
        let start = Instant::now();
        summary = run.summarise().expect("nobody stops it");
        best = best.min(start.elapsed().as_secs_f64() * 1e3);
    }
    (summary, best)
}
