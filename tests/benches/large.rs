//! Benchmark of large problems: many degrees of freedom, a long table, an optimum, each as the program solves it.
//!
//! Prints `name<TAB>figure<TAB>goal`, a row a line; `cargo xtask bench` makes a table of them.

use std::{f64::consts::PI, fs, time::Instant};

use dalembert_core::{Answer, Draft, Solution, Stop, find};
use dalembert_plugins as _;

#[path = "../../crates/mechanics/benches/yardstick/python.rs"]
mod python;

/// Milliseconds of SciPy for all modes of 500 masses, and of NumPy for a text of a million rows.
const YARDSTICK: &str = "
import os; os.environ['OPENBLAS_NUM_THREADS']='1'
import io, time, numpy as np, scipy.linalg as sl
def best(f, n):
    t=[]
    for _ in range(n):
        a=time.perf_counter(); f(); t.append(time.perf_counter()-a)
    return min(t)*1e3
n=500; k=1e5*(2*np.eye(n)-np.eye(n,k=1)-np.eye(n,k=-1)); m=10*np.eye(n)
print(best(lambda: sl.eigh(k,m), 9))
text=''.join(f'{i*1e-5:.5f},{np.exp(-i*1e-6)*np.cos(i*1e-2):.9f}\\n' for i in range(10**6))
print(best(lambda: np.loadtxt(io.StringIO(text), delimiter=','), 2))
";

const ROWS: usize = 1_000_000;

fn main() {
    let yardstick: Option<[f64; 2]> = python::figures(YARDSTICK);
    let beside = |at: usize, of: &str, ours: f64| {
        yardstick.map_or(String::new(), |ms| format!(", {:.2} of {of}'s {:.0} ms", ours / ms[at], ms[at]))
    };
    let (solution, ours) = measured(9, || masses("500"));
    let name = "dalembert solve vibration/modal-analysis, 500 masses";
    println!("{name}\t{ours:.1} ms{}\t≤ 0.2 of SciPy's full solve", beside(0, "SciPy", ours));
    check(&solution, 500.0);
    let (solution, ours) = measured(2, || masses("100000"));
    let off = check(&solution, 1e5);
    println!(
        "dalembert solve vibration/modal-analysis, 100000 masses\t{ours:.0} ms, error {off:.0e}\taccepted"
    );

    let mut text = String::from("t [s],x [mm]\n");
    for n in (0..ROWS).map(|n| n as f64) {
        text += &format!("{:.5},{:.9}\n", n * 1e-5, (-n * 1e-6).exp() * (n * 1e-2).cos());
    }
    let entry = find("vibration/decay-identification").expect("an analysis");
    let shape = entry.shape();
    let mut draft = Draft::blank(&shape);
    draft.set(&shape, "record.samples.samples", &text).expect("a table");
    let before = resident();
    let (rows, ours) = measured(1, || {
        let (samples, inner) = draft.at(&shape, "record.samples.samples").expect("the table");
        let Draft::Leaf(text) = samples else { panic!("the table is a text") };
        dalembert_core::draft::read_leaf(text, &inner, "samples").expect("numbers")
    });
    let bytes = (resident() - before) as f64 / ROWS as f64;
    drop(rows);
    let name = "table of 1000000 rows of two numbers, read";
    println!("{name}\t{ours:.0} ms{}, {bytes:.0} bytes a row\t≤ 40 bytes a row", beside(1, "NumPy", ours));

    let (solution, ours) = measured(9, || {
        let mut draft = Draft::blank(&find("vibration/damped-absorber").expect("an analysis").shape());
        solved(
            "vibration/damped-absorber",
            &mut draft,
            &[
                ("main.ratio.ratio", "0.25"),
                ("absorber.given.tuning.ratio.ratio", "? 0.5 .. 1.2"),
                ("absorber.given.damping.by-absorber.ratio", "? 0.05 .. 0.6"),
            ],
            Some(("peak", "minimum")),
        )
    });
    let evaluations =
        solution.determined.as_ref().and_then(|found| found.optimum.as_ref()).map_or(0, |o| o.evaluations);
    let off = (number(&solution, "peak") / number(&solution, "best_peak") - 1.0).abs();
    assert!(off < 1e-9, "the peak is {off} off");
    println!(
        "dalembert optimise vibration/damped-absorber, two inputs\t{ours:.0} ms, {evaluations} evaluations\t"
    );
}

/// The chain of equal masses between two walls.
fn masses(count: &str) -> Solution {
    let id = "vibration/modal-analysis";
    let mut draft = Draft::blank(&find(id).expect("an analysis").shape());
    let inputs = [
        ("system.uniform.count", count),
        ("system.uniform.mass", "10 kg"),
        ("system.uniform.spring", "1e5 N/m"),
        ("system.uniform.ends", "both-fixed"),
        ("damping", "dampers"),
        ("normalisation", "largest"),
    ];
    solved(id, &mut draft, &inputs, None)
}

fn solved(id: &str, draft: &mut Draft, inputs: &[(&str, &str)], given: Option<(&str, &str)>) -> Solution {
    let entry = find(id).expect("an analysis");
    let shape = entry.shape();
    for (path, text) in inputs {
        draft.set(&shape, path, text).expect("an input");
    }
    if let Some((answer, value)) = given {
        draft.give(&shape, answer, value).expect("an answer");
    }
    let record = draft.read(&shape).expect("a problem");
    entry.solve(&record, &Stop::new()).expect("a solution")
}

/// Largest relative error of the eight frequencies, ω_j = 2√(k/m) sin(jπ/(2(n + 1))).
fn check(solution: &Solution, n: f64) -> f64 {
    let off = (1..=8).map(|j| {
        let exact = 200.0 * (f64::from(j) * PI / (2.0 * (n + 1.0))).sin();
        (number(solution, &format!("frequency[{j}]")) / exact - 1.0).abs()
    });
    let off = off.fold(0.0, f64::max);
    assert!(off < 1e-10, "the frequencies of {n} masses are {off} off");
    off
}

fn number(solution: &Solution, name: &str) -> f64 {
    solution.answer(name).and_then(Answer::si).expect("an answer")
}

/// Result, and the shortest of some rounds in milliseconds.
fn measured<T>(rounds: usize, mut work: impl FnMut() -> T) -> (T, f64) {
    let mut least = f64::INFINITY;
    let mut last = None;
    for _ in 0..rounds {
        let start = Instant::now();
        last = Some(work());
        least = least.min(start.elapsed().as_secs_f64() * 1e3);
    }
    (last.expect("a round"), least)
}

/// Bytes of memory in use.
fn resident() -> usize {
    let pages = fs::read_to_string("/proc/self/statm").unwrap_or_default();
    pages.split(' ').nth(1).and_then(|pages| pages.parse().ok()).map_or(0, |pages: usize| pages * 4096)
}
