//! Two mistakes at once.

use super::{
    Cause,
    ranking::{Hit, NAMED, POSSIBLE, UNKNOWN, Values, causes_of},
    steps::{node_of, scalar},
    tries::Candidate,
    wrong::{Wrong, is_computed, is_near},
};
use crate::{
    Solution, Stop,
    reevaluate::{Edit, Reevaluation},
};

/// The prior of two mistakes beside the product of theirs: of a thousand wrong answers some eighty have two.
const PAIR: f64 = 2e-4;
/// Pairs are tried down to so many times the prior at which an unknown mistake is as likely.
const LEAST_LIKELY: f64 = 0.3;
/// So many pairs are tried at most, and fewer where each is read from a long trace.
const MOST_PAIRS: usize = 300_000;
/// So many operations are read at most.
const MOST_OPERATIONS: usize = 30_000_000;
/// Pairs are searched for with so few chance hits only.
const DIGITS_FOR_PAIRS: f64 = 2e-5;
/// So many other mistakes that give the number of one of two are tried in its place.
const OTHERS: usize = 12;

/// Two mistakes that give a wrong answer together, where there are digits enough to tell.
pub(super) fn pairs(
    at: usize,
    wrong: &[Wrong<'_>],
    candidates: &[Candidate],
    solution: &Solution,
    stop: &Stop,
) -> Vec<Cause> {
    let one = &wrong[at];
    let Some(node) = node_of(one) else { return Vec::new() };
    if one.answered == 0.0 || one.within / one.answered.abs() > DIGITS_FOR_PAIRS {
        return Vec::new();
    }
    let may_be_one = |candidate: &&Candidate| {
        let value = candidate.values[at];
        !candidate.is_free && !candidate.edits.is_empty() && value.is_finite() && !is_computed(one, value)
    };
    let usable: Vec<&Candidate> = candidates.iter().filter(may_be_one).collect();
    let mut tried = Values::default();
    // Of the mistakes that give one number the likeliest.
    let mut likely: Vec<&Candidate> = Vec::new();
    for candidate in &usable {
        if tried.count(one, candidate.values[at]) {
            likely.push(candidate);
        }
    }
    let mut again = Reevaluation::new(solution, &[node]);
    let most = MOST_PAIRS.min(MOST_OPERATIONS / again.len().max(1));
    let mut both = |first: &Candidate, second: &Candidate| {
        let is_same = first.edits.iter().any(|a| second.edits.iter().any(|b| a.at == b.at));
        if is_same {
            return f64::NAN;
        }
        let edits: Vec<&Edit> = first.edits.iter().chain(&second.edits).collect();
        again.with(&edits, &[Some(node)]).pop().map_or(f64::NAN, scalar)
    };
    let hit = |first: &Candidate, second: &Candidate, value: f64, accidents: f64| {
        let mistakes = vec![first.mistake.clone(), second.mistake.clone()];
        let prior = PAIR * first.prior * second.prior;
        let unknown = UNKNOWN * one.by_unknown(value);
        Hit { cause: Cause::new(mistakes, accidents <= NAMED), others: 0, prior, value, unknown }
    };
    let mut hits: Vec<Hit> = Vec::new();
    for (n, m) in in_order(&likely, one, most) {
        if stop.check().is_err() {
            break;
        }
        let (first, second) = (likely[n], likely[m]);
        let value = both(first, second);
        if !value.is_finite() || is_computed(one, value) {
            continue;
        }
        tried.count(one, value);
        if tried.accidents > POSSIBLE {
            break;
        }
        if !one.is(value) {
            continue;
        }
        // Others give the number of one of the two alone, and perhaps that of both.
        let like = |known: &Candidate| {
            let is_like = |other: &&&Candidate| is_near(other.values[at], known.values[at]);
            usable.iter().filter(is_like).take(OTHERS).copied().collect::<Vec<_>>()
        };
        for first in like(first) {
            for second in like(second) {
                let together = both(first, second);
                if is_near(together, value) {
                    hits.push(hit(first, second, together, tried.accidents));
                }
            }
        }
    }
    causes_of(one, hits, solution)
}

/// Pairs of mistakes, the likeliest first, at most so many.
fn in_order(likely: &[&Candidate], one: &Wrong<'_>, most: usize) -> Vec<(usize, usize)> {
    // Numbers far from ours are those that an unknown mistake leads to the least.
    let least = LEAST_LIKELY * UNKNOWN * one.accident(5.0 * one.computed);
    let mut all: Vec<(f64, usize, usize)> = Vec::new();
    for (n, first) in likely.iter().enumerate() {
        let rest = likely.iter().enumerate().skip(n + 1);
        let with_first = rest.map(|(m, second)| (PAIR * first.prior * second.prior, n, m));
        all.extend(with_first.take_while(|(prior, ..)| *prior >= least));
    }
    all.sort_by(|a, b| b.0.total_cmp(&a.0));
    all.truncate(most);
    all.into_iter().map(|(_, n, m)| (n, m)).collect()
}
