//! Common errors of an answer: the numbers that usual mistakes would give in its place.

use super::{Mistake, candidates::candidates, difference, tries::Candidate, wrong::Wrong};
use crate::{Entry, Record, Refusal, Solution, Stop};

/// Values closer to each other than this share are one.
const SAME: f64 = 1e-9;

/// For an answer that is a number at most so many values, in SI, that usual mistakes give in its place, with the mistake of
/// each, the most frequent first. A mistake that does not change the answer, or gives the value of one before it, is left out.
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
        if value.is_finite() && !is_known && !is_free {
            found.push((value, mistake));
        }
        if found.len() == most {
            break;
        }
    }
    Ok(found)
}
