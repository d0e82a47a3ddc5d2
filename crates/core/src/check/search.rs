//! Which slips give what was answered, and whether that can be chance.

use dalembert_units::Unit;

use super::{
    Slip, Verdict,
    candidates::{Candidate, candidates},
    compare, difference, half_a_place, read,
};
use crate::{Answer, Entry, Record, Refusal, Solution, Stop};

/// Wrong answers lie within such a factor of ours, give or take: the natural logarithm of 20. Over this range an
/// accidental hit is spread.
const SPREAD: f64 = 3.0;
/// A slip is told only where so many tries would hit by accident less often than this.
const CHANCE: f64 = 0.05;
/// At most so many slips are told of an answer.
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
) -> Result<Vec<(String, Vec<Slip>)>, Refusal> {
    let wrong: Vec<Wrong<'_>> =
        typed.iter().filter_map(|(name, text)| Wrong::of(solution, name, text)).collect();
    if wrong.is_empty() {
        return Ok(Vec::new());
    }
    let candidates = candidates(entry, record, solution, &wrong, stop)?;
    let found =
        wrong.iter().enumerate().map(|(at, one)| (one.name.to_owned(), told(at, &wrong, &candidates)));
    Ok(found.collect())
}

/// A wrong answer.
pub(super) struct Wrong<'s> {
    pub(super) name: &'s str,
    pub(super) answer: &'s Answer,
    /// Ours and the person's, in SI.
    pub(super) ours: f64,
    pub(super) theirs: f64,
    /// The unit that was typed.
    pub(super) unit: Unit,
    /// What of theirs is not known, in SI.
    pub(super) within: f64,
}

impl<'s> Wrong<'s> {
    fn of(solution: &'s Solution, name: &'s str, text: &str) -> Option<Self> {
        let answer = solution.answer(name)?;
        if text.trim().is_empty() || compare(answer, text) != Verdict::Wrong {
            return None;
        }
        let typed = read(answer, text).ok()?;
        // What agrees with everything says nothing.
        let within = half_a_place(&typed).min(super::TOLERANCE * typed.si.abs());
        Some(Self { name, answer, ours: answer.si()?, theirs: typed.si, unit: typed.unit, within })
    }

    fn is(&self, value: f64) -> bool {
        difference(self.theirs, value, self.answer.dim()) <= self.within + 1e-12 * self.theirs.abs()
    }

    /// The same for a value that was computed from numbers that the person rounded.
    fn nearly(&self, value: f64) -> bool {
        self.is(value)
            || difference(self.theirs, value, self.answer.dim()) <= super::TOLERANCE * self.theirs.abs()
    }

    /// How probable it is that a number hits this answer by accident.
    fn accident(&self) -> f64 {
        if self.theirs == 0.0 { 1.0 } else { (2.0 * self.within / (self.theirs.abs() * SPREAD)).min(1.0) }
    }
}

fn told(at: usize, wrong: &[Wrong<'_>], candidates: &[Candidate]) -> Vec<Slip> {
    let one = &wrong[at];
    let same = |a: f64, b: f64| difference(a, b, one.answer.dim()) <= 1e-9 * b.abs().max(1e-300);
    // How many numbers were tried before.
    let mut tried: Vec<f64> = Vec::new();
    let mut hits: Vec<(usize, usize, &Candidate)> = Vec::new();
    for candidate in candidates {
        let value = candidate.values[at];
        if !value.is_finite() || same(value, one.ours) {
            continue;
        }
        if candidate.free {
            // What the person said themselves is no number that we try.
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
