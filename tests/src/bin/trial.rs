//! `trial NAME --times N --seed S`: a trial of reliability, its outcome as JSON. `cargo xtask trust` runs it.

use std::{env, process::ExitCode};

use dalembert_tests::trials::TRIALS;
use serde_json::json;

fn main() -> ExitCode {
    let words: Vec<String> = env::args().skip(1).collect();
    let words: Vec<&str> = words.iter().map(String::as_str).collect();
    let ["--times", times, "--seed", seed] = words.get(1..).unwrap_or_default() else {
        eprintln!("usage: trial NAME --times N --seed S; names: {}", TRIALS.map(|(name, _)| name).join(" "));
        return ExitCode::from(2);
    };
    let (Some((_, run)), Ok(times), Ok(seed)) =
        (TRIALS.iter().find(|(name, _)| *name == words[0]), times.parse(), seed.parse())
    else {
        eprintln!("{words:?}: no such trial, or no number");
        return ExitCode::from(2);
    };
    let outcome = run(times, seed);
    let failed = outcome.failures.len();
    println!(
        "{}",
        json!({ "tried": outcome.tried, "failed": failed, "failures": outcome.failures, "note": outcome.note })
    );
    ExitCode::SUCCESS
}
