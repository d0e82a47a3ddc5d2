//! Benchmark of a solve: the inputs are read and solved, for the first case of every analysis.
//!
//! Prints `name<TAB>figure<TAB>goal`, a row a line; `cargo xtask bench` makes a table of them. Of an id as argument that
//! analysis alone is solved, as for a profile: `cargo bench -p dalembert-tests --bench solve -- half-car`.

use std::{hint::black_box, time::Instant};

use dalembert_core::{Stop, cases, registry};
use dalembert_plugins as _;

const ROUNDS: usize = 500;

fn main() {
    let wanted = std::env::args().skip(1).find(|word| !word.starts_with("--")).unwrap_or_default();
    for entry in registry().iter().filter(|entry| entry.about.id.contains(&wanted)) {
        let Some(case) = cases::first(entry) else { continue };
        let shape = entry.shape();
        let mut times: Vec<f64> = (0..ROUNDS)
            .map(|_| {
                let start = Instant::now();
                let record = case.draft.read(&shape).expect("the first case can be read");
                black_box(entry.solve(&record, &Stop::new()).expect("the first case has an answer"));
                start.elapsed().as_secs_f64() * 1e6
            })
            .collect();
        times.sort_by(f64::total_cmp);
        let (median, rare) = (times[ROUNDS / 2], times[ROUNDS * 99 / 100]);
        println!("solve {}\t{median:.0} µs, p99 {rare:.0} µs\t< 16000 µs", entry.about.id);
    }
}
