//! Optima: none is worse than what a scan of the range finds, and limits are kept.

use dalembert_core::{Answer, Entry, Solution, SolveError, Stop};

use crate::unknowns::{Pair, examine_pairs};

/// Intervals of a scan.
const SCAN: usize = 64;
/// The share of an answer by which an optimum may be worse than the best of a scan.
const CLOSE: f64 = 1e-6;

/// In the first case of each analysis chooses an input, from 0.7 to 1.5 times its value, so that an answer which follows it
/// is least, then largest, then least while it stays above the value in the middle of the range: none is worse than the
/// best of 65 points, and the limit is kept. Returns the number of optima; analyses without such a pair of numbers have none.
pub fn an_optimum_is_no_worse_than_a_scan(entries: &[&'static Entry], times: usize) -> usize {
    examine_pairs(entries, |pair| {
        let (input, name) = (&pair.input.path, pair.answer.name.to_string());
        let mut evaluate = pair
            .entry
            .prepare(&pair.record, &[input], &[&name])
            .unwrap_or_else(|err| panic!("{}: {err}", pair.entry.about.id));
        let [from, to] = pair.ends();
        let points: Vec<f64> = (0..=SCAN).map(|n| from + (to - from) * n as f64 / SCAN as f64).collect();
        let mut values = vec![f64::NAN; points.len()];
        evaluate.sweep(&points, &mut values, &Stop::new()).expect("nobody stops it");
        // What is refused at some points has its optimum beside one of them, where it is hard to find.
        if values.iter().any(|value| !value.is_finite()) {
            return Vec::new();
        }
        let least = values.iter().copied().fold(f64::INFINITY, f64::min);
        let largest = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let limit = values[SCAN / 2];
        let searches =
            [("minimum", None, least), ("maximum", None, largest), ("minimum", Some(limit), limit)];
        // One of the three for each analysis, others for its neighbours in the alphabet; all where more is asked for.
        let first = pair.entry.about.id.bytes().map(usize::from).sum::<usize>() % searches.len();
        let chosen = searches.into_iter().cycle().skip(first).take(times.min(searches.len()));
        let examined = chosen.map(|(goal, bound, best)| {
            let si =
                optimum(pair, goal, bound).map_err(|why| format!("{goal} of {name} over {input}: {why}"))?;
            let worse = if goal == "minimum" { si - best } else { best - si };
            let is_kept = bound.is_none_or(|bound| si >= bound);
            if worse > CLOSE * best.abs() || !is_kept {
                return Err(format!("{goal} {bound:?} of {name} over {input}: {si} after {best}"));
            }
            Ok(())
        });
        examined.collect()
    })
}

/// The answer at its optimum.
fn optimum(pair: &Pair, goal: &str, bound: Option<f64>) -> Result<f64, String> {
    let Pair { entry, answer, .. } = pair;
    let shape = entry.shape();
    let mut draft = pair.with_unknown()?;
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
