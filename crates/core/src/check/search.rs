//! Search for the mistakes that reproduce a user's answer, and the probability that the agreement is accidental.

use super::{
    Mistake,
    candidates::{Candidate, candidates},
    difference,
    wrong::Wrong,
};
use crate::{Entry, Record, Refusal, Solution, Stop};

/// A slip is reported only where so many tries would hit by accident less often than this.
const CHANCE: f64 = 0.05;
/// At most so many slips are reported an answer.
const MOST: usize = 3;

/// For each wrong answer the slips that give it, the likeliest first; none where no slip we know does, or where the
/// digits that were given are too few to tell.
///
/// # Errors
/// [`Refusal::Stopped`] alone.
pub fn slips(
    entry: &Entry,
    record: &Record,
    solution: &Solution,
    typed: &[(String, String)],
    stop: &Stop,
) -> Result<Vec<(String, Vec<Mistake>)>, Refusal> {
    let wrong: Vec<Wrong<'_>> =
        typed.iter().filter_map(|(name, text)| Wrong::of(solution, name, text)).collect();
    if wrong.is_empty() {
        return Ok(Vec::new());
    }
    let candidates = candidates(entry, record, solution, &wrong, stop)?;
    let found =
        wrong.iter().enumerate().map(|(at, one)| (one.name.to_owned(), mistakes_in(at, &wrong, &candidates)));
    Ok(found.collect())
}

fn mistakes_in(at: usize, wrong: &[Wrong<'_>], candidates: &[Candidate]) -> Vec<Mistake> {
    let one = &wrong[at];
    let same = |a: f64, b: f64| difference(a, b, one.answer.dim()) <= 1e-9 * b.abs().max(1e-300);
    // How many numbers were tried before.
    let mut tried: Vec<f64> = Vec::new();
    let mut hits: Vec<(usize, usize, &Candidate)> = Vec::new();
    for candidate in candidates {
        let value = candidate.values[at];
        if !value.is_finite() || same(value, one.computed) {
            continue;
        }
        if candidate.free {
            // What the user said themselves is no number that we try.
            if one.nearly(value) {
                hits.push((usize::MAX, 0, candidate));
            }
            continue;
        }
        // Two ways to the same number are one try.
        let rank = tried.iter().position(|before| same(value, *before)).unwrap_or(tried.len());
        if rank == tried.len() {
            tried.push(value);
        }
        if !one.is(value) {
            continue;
        }
        let also = |other: &&Wrong<'_>| {
            let place = wrong.iter().position(|known| known.name == other.name);
            candidate.shared
                && other.name != one.name
                && place.is_some_and(|place| other.is(candidate.values[place]))
        };
        let together = wrong.iter().filter(also);
        let (others, accident) =
            together.fold((0, one.accident()), |(n, chance), other| (n + 1, chance * other.accident()));
        if (rank + 1) as f64 * accident <= CHANCE {
            hits.push((others, rank, candidate));
        }
    }
    hits.sort_by_key(|(others, rank, _)| (std::cmp::Reverse(*others), *rank));
    hits.into_iter().take(MOST).map(|(_, _, candidate)| candidate.slip.clone()).collect()
}
