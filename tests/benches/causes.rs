//! Benchmark of the search for the causes of wrong answers: over the corpus of student errors, the time until the first
//! cause is reported and until the search is over, with six digits.
//!
//! Prints `name<TAB>figure<TAB>goal`, a row a line; `cargo xtask bench` makes a table of them.

use std::{path::Path, time::Instant};

use dalembert_core::check::Causes;
use dalembert_plugins as _;
use dalembert_tests::errors::{Solved, corpus};

const DIGITS: u8 = 6;

fn main() {
    let problems = corpus(&Path::new(env!("CARGO_MANIFEST_DIR")).join("data/errors"));
    let (mut first, mut last) = (Vec::new(), Vec::new());
    for problem in &problems {
        let Some(solved) = Solved::new(problem, &|_| 1.0) else { continue };
        for typed in problem.errors.iter().filter_map(|error| solved.written(error, DIGITS)) {
            let begun = Instant::now();
            let mut seen = None;
            let mut report = |so_far: Causes| {
                if so_far.iter().any(|(_, causes)| !causes.is_empty()) {
                    seen.get_or_insert(begun.elapsed());
                }
            };
            let causes = solved.searched(&typed, Some(&mut report));
            let end = begun.elapsed();
            last.push(end.as_secs_f64());
            if !causes.is_empty() {
                first.push(seen.unwrap_or(end).as_secs_f64());
            }
        }
    }
    println!("wrong answer to its first cause\t{}\tmedian ≤ 200 ms", figures(&mut first));
    println!("wrong answer to the end of the search\t{}\t≤ 5 s", figures(&mut last));
}

fn figures(seconds: &mut [f64]) -> String {
    seconds.sort_by(f64::total_cmp);
    let at = |share: usize| 1e3 * seconds[(seconds.len() - 1) * share / 100];
    format!("{:.0} ms, p95 {:.0} ms, most {:.0} ms", at(50), at(95), at(100))
}
