//! Optima: none is worse than what a scan of the range finds, and limits are kept.

use std::sync::Mutex;

use dalembert_core::{Answer, Draft, Entry, Solution, SolveError, Stop, vary::VariedInput};

use crate::{
    problems::{cases_of, on_all_cores},
    some,
    unknowns::pair,
};

/// Intervals of a scan.
const SCAN: usize = 64;
/// The share of an answer by which an optimum may be worse than the best of a scan.
const CLOSE: f64 = 1e-6;

/// In the first case of each analysis chooses an input, from 0.7 to 1.5 times its value, so that an answer which follows it
/// is least, then largest, then least while it stays above the value in the middle of the range: none is worse than the
/// best of 65 points, and the limit is kept. Returns the number of optima; analyses without such a pair of numbers have none.
pub fn an_optimum_is_no_worse_than_a_scan(entries: &[&'static Entry]) -> usize {
    some(entries);
    let (faults, found) = (Mutex::new(Vec::new()), Mutex::new(0));
    on_all_cores(entries, |_, entry| {
        let Some(case) = cases_of(entry).into_iter().find(|case| case.refused.is_none()) else { return };
        let record = case.record(entry).unwrap_or_else(|err| panic!("{}: {err}", entry.about.id));
        let Some((input, answer)) = pair(entry, &record) else { return };
        let name = answer.name.to_string();
        let mut evaluate = entry
            .prepare(&record, &[&input.path], &[&name])
            .unwrap_or_else(|err| panic!("{}: {err}", entry.about.id));
        let [from, to] = ends(&input);
        let points: Vec<f64> = (0..=SCAN).map(|n| from + (to - from) * n as f64 / SCAN as f64).collect();
        let mut values = vec![f64::NAN; points.len()];
        evaluate.sweep(&points, &mut values, &Stop::new()).expect("nobody stops it");
        // What is refused at some points has its optimum beside one of them, where it is hard to find.
        if values.iter().any(|value| !value.is_finite()) {
            return;
        }
        let least = values.iter().copied().fold(f64::INFINITY, f64::min);
        let largest = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let limit = values[SCAN / 2];
        for (goal, bound, best) in
            [("minimum", None, least), ("maximum", None, largest), ("minimum", Some(limit), limit)]
        {
            match optimum(entry, &case.draft, (&input, &answer), goal, bound) {
                Ok(si) => {
                    let worse = if goal == "minimum" { si - best } else { best - si };
                    let is_kept = bound.is_none_or(|bound| si >= bound);
                    if worse > CLOSE * best.abs() || !is_kept {
                        let why =
                            format!("{goal} {bound:?} of {name} over {}: {si} after {best}", input.path);
                        faults.lock().expect("no worker panics").push(format!("{}: {why}", entry.about.id));
                    }
                    *found.lock().expect("no worker panics") += 1;
                }
                Err(why) => {
                    let why = format!("{}: {goal} of {name} over {}: {why}", entry.about.id, input.path);
                    faults.lock().expect("no worker panics").push(why);
                }
            }
        }
    });
    let faults = faults.into_inner().expect("no worker panics");
    assert!(faults.is_empty(), "{}", faults.join("\n"));
    found.into_inner().expect("no worker panics")
}

fn ends(input: &VariedInput) -> [f64; 2] {
    let mut ends = [0.7, 1.5].map(|share| share * input.si);
    ends.sort_by(f64::total_cmp);
    ends
}

/// The answer at its optimum.
fn optimum(
    entry: &Entry,
    draft: &Draft,
    (input, answer): (&VariedInput, &Answer),
    goal: &str,
    bound: Option<f64>,
) -> Result<f64, String> {
    let shape = entry.shape();
    let mut draft = draft.clone();
    let unit = input.measure.own_unit();
    let [from, to] = ends(input).map(|si| unit.value(si));
    let name = unit.ascii();
    let range = format!("? {from:e} {name} .. {to:e} {name}");
    draft.set(&shape, &input.path, &range).map_err(|err| err.to_string())?;
    draft.give(&shape, &answer.name.to_string(), goal).map_err(|err| err.to_string())?;
    if let Some(bound) = bound {
        let unit = answer.unit.coherent();
        let bound = format!("> {bound:e} {}", if unit == "1" { "" } else { &unit });
        // The same answer by a question, so that one is wanted and the other limited.
        draft.ask(&shape, "limited", &answer.name.to_string()).map_err(|err| err.to_string())?;
        draft.give(&shape, "limited", &bound).map_err(|err| err.to_string())?;
    }
    let record = draft.read(&shape).map_err(|errors| SolveError::Fields(errors).to_string())?;
    let solution: Solution = entry.solve(&record, &Stop::new()).map_err(|err| err.to_string())?;
    let of_search = |words: &str| words.starts_with("a search without derivatives");
    let failed = solution.checks.iter().find(|check| !check.passed && of_search(&check.what.english()));
    if let Some(check) = failed {
        return Err(format!("{}: {}", check.what.english(), check.residual));
    }
    let found = solution.answer(&answer.name.to_string()).and_then(Answer::si);
    found.ok_or_else(|| "no number".to_owned())
}
