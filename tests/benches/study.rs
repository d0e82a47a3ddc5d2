//! Benchmark of many points of an analysis: Monte Carlo studies with their statistics, as `dalembert study` carries them
//! out, and sweeps over an angle, beside NumPy and numba on the same numbers.
//!
//! Prints `name<TAB>figure<TAB>goal`, a row a line; `cargo xtask bench` makes a table of them.

use std::{f64::consts::TAU, thread, time::Instant};

use dalembert_core::{
    Entry, Locale, Record, Stop,
    file::parse,
    study::{Amount, Design, DistributionKind, Study, StudyPlan, Summary, Variation},
};
use dalembert_plugins as _;
use dalembert_study::{output::Run, points};

#[path = "../../crates/mechanics/benches/yardstick/python.rs"]
mod python;

const POINTS: usize = 1_000_000;
const ROUNDS: usize = 5;

/// A Monte Carlo study, and NumPy's script of the same samples.
struct MonteCarlo {
    name: &'static str,
    problem: &'static str,
    /// Inputs and their standard deviations.
    vary: &'static [(&'static str, &'static str)],
    answers: &'static [&'static str],
    /// Factor from the unit of the first answer to SI.
    si: f64,
    yardstick: &'static str,
    goal: &'static str,
}

const UNBALANCE: MonteCarlo = MonteCarlo {
    name: "rotating unbalance, 5 inputs",
    problem: r#"
        analysis = "vibration/rotating-unbalance"
        [inputs]
        mass = "100 kg"
        unbalance = "0.05 kg*m"
        support.stiffness.stiffness = "400 kN/m"
        damping.coefficient.coefficient = "600 N*s/m"
        speed = "60 rad/s"
    "#,
    vary: &[
        ("mass", "1 kg"),
        ("support.stiffness.stiffness", "8 kN/m"),
        ("damping.coefficient.coefficient", "60 N*s/m"),
        ("unbalance", "0.005 kg*m"),
        ("speed", "0.5 rad/s"),
    ],
    answers: &["amplitude"],
    si: 1e-3,
    yardstick: include_str!("../../crates/mechanics/benches/yardstick/unbalance.py"),
    goal: "≤ 0.27 of NumPy on one thread",
};

const TWO_PLANE: MonteCarlo = MonteCarlo {
    name: "balancing in two planes, 8 inputs",
    problem: r#"
        analysis = "balancing/two-plane"
        [inputs]
        plane_a = "100 mm"
        plane_b = "900 mm"
        correction_a.radius.radius = "100 mm"
        correction_b.radius.radius = "100 mm"
        way = "add"
        [[inputs.masses]]
        mass = "2 kg"
        radius = "100 mm"
        angle = "0.5 rad"
        position = "300 mm"
        [[inputs.masses]]
        mass = "3 kg"
        radius = "150 mm"
        angle = "2.2 rad"
        position = "700 mm"
    "#,
    vary: &[
        ("masses[1].mass", "0.02 kg"),
        ("masses[2].mass", "0.03 kg"),
        ("masses[1].radius", "1 mm"),
        ("masses[2].radius", "1 mm"),
        ("masses[1].angle", "0.01 rad"),
        ("masses[2].angle", "0.01 rad"),
        ("masses[1].position", "2 mm"),
        ("masses[2].position", "2 mm"),
    ],
    answers: &["unbalance_a", "angle_a"],
    si: 1e-3,
    yardstick: include_str!("../../crates/mechanics/benches/yardstick/two_plane.py"),
    goal: "≤ 0.23 of NumPy on one thread",
};

/// A sweep over the angle of a crank, and numba's script of the same formulas.
struct Cycle {
    name: &'static str,
    problem: &'static str,
    /// The torque is the last.
    answers: &'static [&'static str],
    yardstick: &'static str,
}

const SLIDER_CRANK: Cycle = Cycle {
    name: "slider-crank",
    problem: r#"
        analysis = "virtual-work/slider-crank"
        [inputs]
        crank = "50 mm"
        rod = "200 mm"
        angle = "0 rad"
        unknown.torque.force = "200 N"
        speed = "30 rad/s"
        acceleration = "5 rad/s^2"
        crank_mass.given = { mass = "1.2 kg", distance = "20 mm", inertia = "8e-4 kg*m^2" }
        rod_mass.given = { mass = "0.8 kg", distance = "70 mm", inertia = "3.5e-3 kg*m^2" }
        slider_mass = "0.5 kg"
        gravity = "(0; -9.81) m/s^2"
    "#,
    answers: &[
        "slider_position",
        "slider_velocity",
        "slider_acceleration",
        "rod_speed",
        "rod_acceleration",
        "torque",
    ],
    yardstick: include_str!("../../crates/mechanics/benches/yardstick/slider_crank.py"),
};

const FOUR_BAR: Cycle = Cycle {
    name: "four-bar",
    problem: r#"
        analysis = "virtual-work/four-bar"
        [inputs]
        crank = "100 mm"
        coupler = "280 mm"
        rocker = "200 mm"
        frame = "300 mm"
        closing = "open"
        angle = "0 rad"
        unknown.torque.load = "-5 N*m"
        speed = "30 rad/s"
        acceleration = "5 rad/s^2"
        crank_mass.uniform.mass = "0.5 kg"
        coupler_mass.uniform.mass = "1 kg"
        rocker_mass.uniform.mass = "0.8 kg"
        gravity = "(0; -9.81) m/s^2"
    "#,
    answers: &[
        "coupler_angle",
        "rocker_angle",
        "coupler_speed",
        "rocker_speed",
        "coupler_acceleration",
        "rocker_acceleration",
        "torque",
    ],
    yardstick: include_str!("../../crates/mechanics/benches/yardstick/four_bar.py"),
};

fn main() {
    let cores = thread::available_parallelism().map_or(1, usize::from);
    for study in [&UNBALANCE, &TWO_PLANE] {
        monte_carlo(study, cores);
    }
    for cycle in [&SLIDER_CRANK, &FOUR_BAR] {
        sweep(cycle, cores);
    }
}

fn problem(text: &str) -> (&'static Entry, Record) {
    let file = parse(text).unwrap_or_else(|errors| panic!("{errors:?}"));
    let record = file.draft.read(&file.entry.shape()).unwrap_or_else(|errors| panic!("{errors:?}"));
    (file.entry, record)
}

fn monte_carlo(of: &MonteCarlo, cores: usize) {
    let yardstick = python::figures::<3>(of.yardstick);
    for threads in [1, cores] {
        let (summary, milliseconds) = summarised(of, threads);
        let found = &summary.answers[0];
        let mut beside = String::new();
        if let Some([theirs, mean, deviation]) = yardstick {
            let (our_mean, our_deviation) = (found.mean * of.si, found.deviation * of.si);
            // Two means of a million samples differ by no more than a few of their standard errors.
            let error = deviation * (2.0 / POINTS as f64).sqrt();
            assert!((our_mean - mean).abs() < 5.0 * error, "{our_mean} and {mean}");
            assert!((our_deviation / deviation - 1.0).abs() < 0.01, "{our_deviation} and {deviation}");
            beside = format!(", {:.2} of NumPy's {theirs:.0} ms", milliseconds / theirs);
        }
        println!(
            "dalembert study, {}, 1e6 samples, {threads} threads\t{milliseconds:.0} ms{beside}\t{}",
            of.name, of.goal
        );
    }
}

/// The summary, and the shortest time of a few rounds.
fn summarised(of: &MonteCarlo, threads: usize) -> (Summary, f64) {
    let (entry, record) = problem(of.problem);
    let vary = |(path, deviation): &(&str, &str)| Variation {
        input: Some((*path).to_owned()),
        distribution: Some(DistributionKind::Normal),
        deviation: Some(Amount::Text((*deviation).to_owned())),
        ..Variation::default()
    };
    let plan = StudyPlan {
        problem: entry.about.id.to_owned(),
        answers: of.answers.iter().map(|answer| (*answer).to_owned()).collect(),
        samples: Some(POINTS as u64),
        vary: of.vary.iter().map(vary).collect(),
        ..StudyPlan::default()
    };
    let design = Design::new(&plan, &record, &|_| unreachable!("the plan names no file")).expect("a plan");
    let solution = entry.solve(&record, &Stop::new()).expect("a solution");
    let study = Study::new(entry, &record, &plan, design, &solution).expect("a study");
    let (stop, locale) = (Stop::new(), Locale::english());
    let run =
        Run { study: &study, fingerprint: "", threads, locale: &locale, stop: &stop, progress: &|_| {} };
    best(|| run.summarise().expect("nobody stops it"))
}

fn sweep(of: &Cycle, cores: usize) {
    let yardstick = python::figures::<3>(of.yardstick);
    let (entry, record) = problem(of.problem);
    let angle = points::varied(&record, ["angle"]).expect("an input");
    let angles: Vec<f64> = (0..POINTS).map(|n| TAU * n as f64 / POINTS as f64).collect();
    for threads in [1, cores] {
        let (found, milliseconds) = best(|| {
            points::solve((entry, &record), &angle, of.answers, &angles, threads, &Stop::new())
                .expect("nobody stops it")
        });
        let mut beside = String::new();
        if let Some([theirs, mean, square]) = yardstick {
            let torques =
                || found.answers.chunks_exact(of.answers.len()).map(|row| row[of.answers.len() - 1]);
            let [our_mean, our_square] =
                [torques().sum::<f64>(), torques().map(|torque| torque * torque).sum()]
                    .map(|sum| sum / POINTS as f64);
            assert!((our_mean - mean).abs() < 1e-9 * square.sqrt(), "{our_mean} and {mean} N·m");
            assert!((our_square / square - 1.0).abs() < 1e-9, "{our_square} and {square} N²·m²");
            // A million points in milliseconds are one in nanoseconds.
            beside = format!(", {:.2} of numba's {theirs:.0} ms", milliseconds / theirs);
        }
        println!(
            "sweep of {}, {} answers at 1e6 angles, {threads} threads\t{milliseconds:.0} ms{beside}\t≤ 0.5 of numba on one thread",
            of.name,
            of.answers.len()
        );
    }
}

/// The result, and the shortest time of a few rounds, ms.
fn best<R>(mut work: impl FnMut() -> R) -> (R, f64) {
    let mut timed = || {
        let start = Instant::now();
        let result = work();
        (result, start.elapsed().as_secs_f64() * 1e3)
    };
    let (mut result, mut best) = timed();
    for _ in 1..ROUNDS {
        let (again, milliseconds) = timed();
        (result, best) = (again, best.min(milliseconds));
    }
    (result, best)
}
