//! Search for the mistakes that reproduce a user's answer, and the probability that the agreement is accidental.

use std::ops::Bound;

use dalembert_numerics::intervals::IntervalSet;

use super::{
    Cause, Change, Mistake, Place,
    candidates::{candidates, disputed},
    pairs::pairs,
    problem::solve_otherwise,
    ranking::{EQUIVALENTS, Hit, NAMED, POSSIBLE, UNKNOWN, Values, causes_of},
    steps::{node_of, rounded, scalar},
    tries::Candidate,
    wrong::{Digits, Wrong, is_computed},
};
use crate::{
    AnswerValue, Entry, Record, Solution, Stop,
    reevaluate::{Edit, Reevaluation},
    trace::Number,
};

/// At most so many causes are listed for an answer.
const MOST: usize = 4;

/// For each wrong answer, by its name, the causes that give it, the likeliest first.
pub type Causes = Vec<(String, Vec<Cause>)>;

/// For each wrong answer the causes that give it, the likeliest first; none where no mistake we know does, or where the
/// digits that were given are too few to tell. Where `stop` is given, those that were found until then.
///
/// `report`, where there is one, receives what is found on the way: after the edits of the worked solution, and where the
/// problem is solved again, after other options and after other data.
pub fn causes(
    entry: &Entry,
    record: &Record,
    solution: &Solution,
    typed: &[(String, String)],
    stop: &Stop,
    mut report: Option<&mut dyn FnMut(Causes)>,
) -> Causes {
    let read = |digits| -> Vec<Wrong<'_>> {
        typed.iter().filter_map(|(name, text)| Wrong::of(solution, name, text, digits)).collect()
    };
    // Zeros at the end of a whole number may be no digits.
    let (wrong, rough) = (read(Digits::AsWritten), read(Digits::Sure));
    let of_each = |find: &dyn Fn(usize, &[Wrong<'_>]) -> Vec<Cause>| -> Causes {
        let of_one = |at: usize| {
            let mut causes = find(at, &wrong);
            if causes.is_empty() {
                causes = find(at, &rough);
            }
            causes.truncate(MOST);
            (wrong[at].name.to_owned(), causes)
        };
        (0..wrong.len()).map(of_one).collect()
    };
    let mut found: Causes = Vec::new();
    if !wrong.is_empty() {
        let mut so_far = |all: &[Candidate]| {
            if let Some(report) = &mut report {
                report(of_each(&|at, wrong| singles(at, wrong, all, solution)));
            }
        };
        let all = candidates(entry, record, solution, &wrong, stop, &mut so_far);
        found = of_each(&|at, wrong| of_answer(at, wrong, &all, solution, stop));
    }
    found.extend(typed.iter().filter_map(|(name, text)| of_set(entry, record, (solution, name, text), stop)));
    found
}

/// The causes of a wrong answer: a mistake, two of them, or a rounded step.
fn of_answer(
    at: usize,
    wrong: &[Wrong<'_>],
    all: &[Candidate],
    solution: &Solution,
    stop: &Stop,
) -> Vec<Cause> {
    let mut causes = singles(at, wrong, all, solution);
    if causes.is_empty() {
        causes.extend(pairs(at, wrong, all, solution, stop));
    }
    if causes.is_empty() {
        causes.extend(rounding(&wrong[at], solution));
    }
    causes.sort_by_key(|cause| !cause.is_named);
    causes
}

/// The single mistakes that give a wrong answer.
fn singles(at: usize, wrong: &[Wrong<'_>], candidates: &[Candidate], solution: &Solution) -> Vec<Cause> {
    let one = &wrong[at];
    let mut tried = Values::default();
    let mut hits: Vec<Hit> = Vec::new();
    for candidate in candidates {
        let value = candidate.values[at];
        let cause = |is_named| Cause::new(vec![candidate.mistake.clone()], is_named);
        if candidate.is_free {
            // What was said by the user or a book is no number that we try.
            let is_theirs = matches!(candidate.mistake.change, Change::Follows(_)) && one.nearly(value);
            if is_theirs || one.is(value) {
                let (others, value) = (usize::MAX, f64::NAN);
                hits.push(Hit { cause: cause(true), others, prior: candidate.prior, value, unknown: 0.0 });
            }
            continue;
        }
        if !value.is_finite() || is_computed(one, value) {
            continue;
        }
        tried.count(one, value);
        if !one.is(value) {
            continue;
        }
        let (others, chance) = together(candidate, at, wrong, tried.accidents);
        if chance <= POSSIBLE {
            let unknown = UNKNOWN * one.by_unknown(value);
            hits.push(Hit { cause: cause(chance <= NAMED), others, prior: candidate.prior, value, unknown });
        }
    }
    causes_of(one, hits, solution)
}

/// The number of other wrong answers that a mistake explains, and the expected number of chance hits left with them.
fn together(candidate: &Candidate, at: usize, wrong: &[Wrong<'_>], accidents: f64) -> (usize, f64) {
    let others = wrong.iter().enumerate().filter(|(other, one)| {
        let value = candidate.values[*other];
        *other != at && candidate.is_shared && value.is_finite() && one.is(value)
    });
    others.fold((0, accidents), |(n, chance), (other, one)| {
        (n + 1, chance * one.accident(candidate.values[other]))
    })
}

/// An intermediate result rounded to two, three or four digits that gives the answer.
fn rounding(one: &Wrong<'_>, solution: &Solution) -> Option<Cause> {
    let node = node_of(one)?;
    let off = (one.answered / one.computed - 1.0).abs();
    if off.is_nan() || off > 4.0 * super::TOLERANCE {
        return None;
    }
    let mut again = Reevaluation::new(solution, &[node]);
    let mut best: Option<(f64, Cause)> = None;
    for digits in [4u8, 3, 2] {
        for (place, step) in solution.steps.iter().enumerate() {
            let Number::Scalar(value) = solution.trace.node(step.result).number else { continue };
            if !again.uses(step.result) || step.result == node {
                continue;
            }
            let taken = rounded(value, &step.unit, digits.into());
            let edit = Edit::number(step.result, Number::Scalar(taken));
            let found = again.with(&[&edit], &[Some(node)]).pop().map_or(f64::NAN, scalar);
            if !one.is(found) || is_computed(one, found) {
                continue;
            }
            let mistake = Mistake::new(Place::Step(place, step.symbol), Change::Rounded(digits));
            let cause = Cause::new(vec![mistake.by(edit).taken(taken)], true);
            let distance = one.distance(found);
            if best.as_ref().is_none_or(|(least, _)| distance < *least) {
                best = Some((distance, cause));
            }
        }
    }
    best.map(|(_, cause)| cause)
}

/// Cause of a wrong set: it is a printed one that the catalogue disputes, one limit or one part of the right one, or that of
/// another option.
fn of_set(
    entry: &Entry,
    record: &Record,
    (solution, name, text): (&Solution, &str, &str),
    stop: &Stop,
) -> Option<(String, Vec<Cause>)> {
    let answer = solution.answer(name)?;
    let AnswerValue::Set(set, _) = &answer.value else { return None };
    if super::compare(answer, text) != super::Verdict::Wrong {
        return None;
    }
    let limit = |text: &str| {
        let text = super::in_signs(text);
        super::read(answer, text.trim().trim_start_matches(['≤', '≥', ' '])).ok()
    };
    let change = |change| vec![Mistake::new(Place::Answer, change)];
    let of = |mistakes| Some((name.to_owned(), vec![Cause::new(mistakes, true)]));
    let typed = limit(text);
    let is_typed = |si: f64| {
        typed
            .as_ref()
            .is_some_and(|typed| (si - typed.si).abs() <= super::half_a_place(typed) + 1e-12 * typed.si.abs())
    };
    let is_end = |set: &IntervalSet| {
        let mut ends = set.intervals().flat_map(|part| [part.lower, part.upper]);
        ends.any(|end| matches!(end, Bound::Included(end) | Bound::Excluded(end) if is_typed(end)))
    };
    let printed = disputed(entry, record).into_iter().find(|(answer, printed, _)| {
        answer == name && limit(printed).is_some_and(|printed| is_typed(printed.si))
    });
    if let Some((_, _, why)) = printed {
        return of(change(Change::Printed(why)));
    }
    if is_end(set) {
        return of(change(Change::Branch));
    }
    // The set, or one limit of it, with another option or count.
    let mut others = Vec::new();
    solve_otherwise(entry, record, stop, &mut |prior, mistake, other| others.push((prior, mistake, other)))
        .ok()?;
    others.sort_by(|(a, ..), (b, ..)| b.total_cmp(a));
    let mut found = others.into_iter().filter_map(|(_, mistake, other)| {
        let found = other.answer(name)?;
        let AnswerValue::Set(set, _) = &found.value else { return None };
        if super::compare(found, text) == super::Verdict::Right {
            return Some(vec![mistake]);
        }
        is_end(set).then(|| [vec![mistake], change(Change::Branch)].concat())
    });
    let first = found.next()?;
    let equivalents = found.take(EQUIVALENTS).collect();
    Some((name.to_owned(), vec![Cause { equivalents, ..Cause::new(first, true) }]))
}
