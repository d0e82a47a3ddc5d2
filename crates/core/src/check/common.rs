//! Common errors of an answer: the numbers that usual mistakes would give in its place.

use super::{
    Change, Mistake, Place,
    candidates::candidates,
    difference,
    steps::{of_common_errors, scalar},
    tries::Candidate,
    wrong::Wrong,
};
use crate::{AnswerValue, Entry, Record, Refusal, Solution, Stop, reevaluate::Reevaluation};

/// Values closer to each other than this share are one.
const SAME: f64 = 1e-9;
/// Values below this share of the answer are the rounding of what cancels.
const NOISE: f64 = 1e-12;

/// For an answer that is a number at most so many values, in SI, that usual mistakes give in its place, with the mistake of
/// each, the most frequent first. A mistake that does not change the answer, or gives the value of one before it, is left out,
/// and so are miscopied digits, which are others with every datum.
///
/// # Errors
/// [`Refusal::Stopped`] alone.
pub fn common_errors(
    entry: &Entry,
    record: &Record,
    solution: &Solution,
    (answer, most): (&str, usize),
    stop: &Stop,
) -> Result<Vec<(f64, Mistake)>, Refusal> {
    let Some((one, computed)) = solution.answer(answer).and_then(|one| Some((one, one.si()?))) else {
        return Ok(Vec::new());
    };
    let unit = one.unit.clone();
    let wrong = Wrong { name: answer, answer: one, computed, answered: computed, unit, within: 0.0 };
    let same = |a: f64, b: f64| difference(a, b, one.dim()) <= SAME * a.abs().max(b.abs());
    let all = candidates(entry, record, solution, &[wrong], stop, &mut |_| {});
    stop.check()?;
    let mut found: Vec<(f64, Mistake)> = Vec::new();
    for Candidate { mistake, values, is_free, .. } in all {
        let value = values[0];
        let is_known = same(value, computed) || found.iter().any(|(known, _)| same(*known, value));
        let is_copied = matches!(mistake.change, Change::Digit(..) | Change::Swapped(..));
        let is_noise = value != 0.0 && value.abs() <= NOISE * computed.abs();
        if value.is_finite() && !is_noise && !is_known && !is_free && !is_copied {
            found.push((value, mistake));
        }
        if found.len() == most {
            break;
        }
    }
    Ok(found)
}

/// Results of the errors that the analysis declares of its steps, in place of an answer that is a number, in SI.
pub fn declared_errors(solution: &Solution, answer: &str) -> Vec<(f64, Mistake)> {
    let Some(AnswerValue::Number(_, id)) = solution.answer(answer).map(|answer| &answer.value) else {
        return Vec::new();
    };
    let mut again = Reevaluation::new(solution, &[*id]);
    let mut found = Vec::new();
    for (place, step) in solution.steps.iter().enumerate() {
        if !again.uses(step.result) {
            continue;
        }
        for slip in of_common_errors(solution, place) {
            let value = again.with(&[&slip.edit], &[Some(*id)]).into_iter().next().map_or(f64::NAN, scalar);
            found.push((value, Mistake::new(Place::Step(place, step.symbol), slip.change)));
        }
    }
    found
}
