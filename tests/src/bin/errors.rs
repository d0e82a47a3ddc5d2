//! The table of the corpus of student errors: `cargo xtask errors`.

use std::path::Path;

use dalembert_plugins as _;
use dalembert_tests::errors::{CorpusProblem, Solved, Tally, corpus, tally};
use itertools::zip_eq;

/// Random wrong answers of each number of digits.
const RANDOM: usize = 2000;

fn main() {
    let data = Path::new(env!("CARGO_MANIFEST_DIR")).join("data/errors");
    let words: Vec<String> = std::env::args().skip(1).collect();
    let shows = words.iter().any(|word| word == "--log");
    let digits: Vec<u8> = words.iter().filter_map(|word| word.parse().ok()).collect();
    let digits = if digits.is_empty() { vec![4, 5, 6] } else { digits };
    let varied = |place: usize| [1.07, 0.93, 1.03, 0.97][place % 4];
    for (name, folder) in [("for tuning", data.clone()), ("held back", data.join("held"))] {
        if !folder.exists() || words.iter().any(|word| word == "--tuning" && name != "for tuning") {
            continue;
        }
        let problems = corpus(&folder);
        println!("{name}: {} problems", problems.len());
        println!(
            "digits  data    kind     made  right first (with equals, named)  wrong first (named)  listed"
        );
        for digits in &digits {
            let all: [(&str, &dyn Fn(usize) -> f64); 2] = [("given", &|_| 1.0), ("varied", &varied)];
            for (data, factor) in all {
                let mut log = String::new();
                for (kind, found) in zip_eq(["singles", "pairs"], tally(&problems, *digits, factor, &mut log))
                {
                    row(*digits, data, kind, &found);
                }
                if shows && data == "given" {
                    println!("{log}");
                }
            }
        }
        if !words.iter().any(|word| word == "--no-random") {
            for digits in digits.iter().copied() {
                let (named, tried) = random(&problems, digits);
                let share = 100.0 * named as f64 / tried as f64;
                println!("random numbers, {digits} digits: {named} of {tried} named, {share:.2} %");
            }
        }
    }
}

fn row(digits: u8, data: &str, kind: &str, found: &Tally) {
    let Tally { made, right, shared, named, wrong, named_wrong, listed } = found;
    let (share, bad) = (found.right_share(), found.wrong_share());
    println!(
        "{digits:>6}  {data:7} {kind:8} {made:>4}  {right:>4} {share:5.1} % ({shared:>3}, {named:>3})  {wrong:>4} {bad:5.1} % ({named_wrong})  {listed:>4}"
    );
}

/// Random wrong numbers, log-uniform within a factor of ten of the right one, half of them within 20 %; how many of them
/// get a named cause.
fn random(problems: &[CorpusProblem], digits: u8) -> (usize, usize) {
    let (mut named, mut tried) = (0, 0);
    let mut state = 0x9e37_79b9_7f4a_7c15u64;
    let mut uniform = || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state >> 11) as f64 / (1u64 << 53) as f64
    };
    let each = RANDOM.div_ceil(problems.len());
    for problem in problems {
        let Some(solved) = Solved::new(problem, &|_| 1.0) else { continue };
        let ours =
            solved.solution.answer(&problem.answer.0).and_then(dalembert_core::Answer::si).expect("a number");
        for n in 0..each {
            let factor = if n % 2 == 0 { 0.8 + 0.4 * uniform() } else { 10f64.powf(2.0 * uniform() - 1.0) };
            let Some(typed) = solved.typed(factor * ours, digits) else { continue };
            tried += 1;
            named += usize::from(solved.causes(&typed).first().is_some_and(|first| first.is_named));
        }
    }
    (named, tried)
}
