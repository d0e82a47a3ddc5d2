//! Search for the mistakes that reproduce a user's answer, and the probability that the agreement is accidental.

use std::{collections::BTreeSet, ops::Bound};

use super::{
    Cause, Change, Mistake, Place,
    candidates::{candidates, disputed},
    steps::{node_of, rounded, scalar},
    tries::Candidate,
    wrong::{Digits, Wrong},
};
use crate::{
    AnswerValue, Entry, Record, Solution, Stop,
    reevaluate::{Edit, Reevaluation},
    trace::Number,
};

/// A cause is named only where random numbers would meet so few of the candidates that are as likely.
const NAMED: f64 = 0.02;
/// It is listed as possible up to here.
const POSSIBLE: f64 = 0.5;
/// So many other mistakes are named with the first that gives their number.
const EQUIVALENTS: usize = 2;
/// A mistake is about as common as another if its prior is at least so many times the other's.
const AS_COMMON: f64 = 0.5;
/// At most so many causes are listed for an answer.
const MOST: usize = 4;
/// So many of the likeliest mistakes are tried in pairs.
const PAIRED: usize = 600;
/// The weight of a pair of mistakes beside that of their product: seldom are two made.
const PAIR: f64 = 0.05;
/// Pairs are searched for with so few chance hits only.
const DIGITS_FOR_PAIRS: f64 = 2e-5;

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
                report(of_each(&|at, wrong| singles(at, wrong, all)));
            }
        };
        let all = candidates(entry, record, solution, &wrong, stop, &mut so_far);
        found = of_each(&|at, wrong| of_answer(at, wrong, &all, solution, stop));
    }
    found.extend(typed.iter().filter_map(|(name, text)| of_set(entry, record, solution, name, text)));
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
    let mut causes = singles(at, wrong, all);
    if !causes.iter().any(|cause| cause.is_named) {
        causes.extend(pairs(at, wrong, all, solution, stop));
    }
    if causes.is_empty() {
        causes.extend(rounding(&wrong[at], solution));
    }
    causes.sort_by_key(|cause| !cause.is_named);
    causes
}

/// Values that were tried, each counted once.
#[derive(Default)]
struct Tried {
    values: BTreeSet<(bool, i64)>,
    /// Expected number of chance hits.
    accidents: f64,
}

impl Tried {
    /// Counts a value; values that agree to nine digits are one.
    fn count(&mut self, one: &Wrong<'_>, value: f64) {
        if value == 0.0 {
            return;
        }
        let key = (value < 0.0, (value.abs().ln() * 1e9).round() as i64);
        let is_known = (-1..=1).any(|off| self.values.contains(&(key.0, key.1.saturating_add(off))));
        if !is_known {
            self.values.insert(key);
            self.accidents += one.accident(value);
        }
    }
}

/// Mistakes that give the digits of the answer.
struct Hit {
    cause: Cause,
    /// Number of the user's other wrong answers that they give as well.
    others: usize,
    prior: f64,
    /// The number that they give; NaN where it is the user's own or a book's.
    value: f64,
}

/// True if two causes are the same mistakes at other places before the finished answer.
fn are_alike(one: &Cause, other: &Cause) -> bool {
    let operations = |cause: &Cause| cause.mistakes.iter().map(Mistake::operation).collect::<Vec<_>>();
    let places = |mistakes: &[Mistake]| mistakes.iter().map(|one| one.place.clone()).collect::<Vec<_>>();
    let is_elsewhere = |all: &Vec<Mistake>| {
        let known = places(all);
        !known.contains(&Place::Answer) && known != places(&other.mistakes)
    };
    let is_last = places(&other.mistakes).contains(&Place::Answer);
    !is_last && operations(one) == operations(other) && one.all_mistakes().all(is_elsewhere)
}

/// Causes of hits, the likeliest first: the same mistake at several places that gives one number everywhere, about as
/// commonly, is one cause.
fn causes_of(mut hits: Vec<Hit>) -> Vec<Cause> {
    hits.sort_by(|a, b| {
        (b.cause.is_named, b.others).cmp(&(a.cause.is_named, a.others)).then(b.prior.total_cmp(&a.prior))
    });
    let mut found: Vec<Hit> = Vec::new();
    for hit in hits {
        let equivalent = found.iter_mut().find(|known| {
            (known.value - hit.value).abs() <= 1e-9 * hit.value.abs()
                && known.others == hit.others
                && hit.prior >= AS_COMMON * known.prior
                && known.cause.equivalents.len() < EQUIVALENTS
                && are_alike(&known.cause, &hit.cause)
        });
        match equivalent {
            Some(known) => known.cause.equivalents.push(hit.cause.mistakes),
            None => found.push(hit),
        }
    }
    found.into_iter().map(|hit| hit.cause).collect()
}

/// The single mistakes that give a wrong answer.
fn singles(at: usize, wrong: &[Wrong<'_>], candidates: &[Candidate]) -> Vec<Cause> {
    let one = &wrong[at];
    let mut tried = Tried::default();
    let mut hits: Vec<Hit> = Vec::new();
    for candidate in candidates {
        let value = candidate.values[at];
        let cause = |is_named| Cause::new(vec![candidate.mistake.clone()], is_named);
        if candidate.is_free {
            // What was said by the user or a book is no number that we try.
            let is_theirs = matches!(candidate.mistake.change, Change::Follows(_)) && one.nearly(value);
            if is_theirs || one.is(value) {
                let (others, value) = (usize::MAX, f64::NAN);
                hits.push(Hit { cause: cause(true), others, prior: candidate.prior, value });
            }
            continue;
        }
        if !value.is_finite() || is_ours(one, value) {
            continue;
        }
        tried.count(one, value);
        if !one.is(value) {
            continue;
        }
        let (others, chance) = together(candidate, at, wrong, tried.accidents);
        if chance <= POSSIBLE {
            hits.push(Hit { cause: cause(chance <= NAMED), others, prior: candidate.prior, value });
        }
    }
    causes_of(hits)
}

/// True if a value is ours, within rounding.
fn is_ours(one: &Wrong<'_>, value: f64) -> bool {
    super::difference(value, one.computed, one.answer.dim()) <= 1e-9 * one.computed.abs().max(1e-300)
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

/// Two mistakes that give a wrong answer together, where there are digits enough to tell.
fn pairs(
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
    let mut tried = Tried::default();
    let mut likely: Vec<&Candidate> = Vec::new();
    for candidate in candidates {
        let value = candidate.values[at];
        if candidate.is_free || candidate.edits.is_empty() || !value.is_finite() || is_ours(one, value) {
            continue;
        }
        let before = tried.values.len();
        tried.count(one, value);
        if tried.values.len() > before {
            likely.push(candidate);
        }
        if likely.len() == PAIRED {
            break;
        }
    }
    let mut again = Reevaluation::new(solution, &[node]);
    let mut all: Vec<(f64, usize, usize)> = Vec::new();
    for (n, first) in likely.iter().enumerate() {
        for (m, second) in likely.iter().enumerate().skip(n + 1) {
            all.push((PAIR * first.prior * second.prior, n, m));
        }
    }
    all.sort_by(|a, b| b.0.total_cmp(&a.0));
    let mut hits: Vec<Hit> = Vec::new();
    for (prior, n, m) in all {
        if stop.check().is_err() || hits.len() == 2 * MOST {
            break;
        }
        let (first, second) = (likely[n], likely[m]);
        let is_same = first.edits.iter().any(|a| second.edits.iter().any(|b| a.at == b.at));
        if is_same {
            continue;
        }
        let edits: Vec<&Edit> = first.edits.iter().chain(&second.edits).collect();
        let value = again.with(&edits, &[Some(node)]).pop().map_or(f64::NAN, scalar);
        if !value.is_finite() || is_ours(one, value) {
            continue;
        }
        tried.count(one, value);
        if tried.accidents > POSSIBLE {
            break;
        }
        if one.is(value) {
            let mistakes = vec![first.mistake.clone(), second.mistake.clone()];
            let cause = Cause::new(mistakes, tried.accidents <= NAMED);
            hits.push(Hit { cause, others: 0, prior, value });
        }
    }
    causes_of(hits)
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
            if !one.is(found) || is_ours(one, found) {
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

/// Cause of a wrong set: it is a printed one that the catalogue disputes, or one limit or one part of the right one.
fn of_set(
    entry: &Entry,
    record: &Record,
    solution: &Solution,
    name: &str,
    text: &str,
) -> Option<(String, Vec<Cause>)> {
    let answer = solution.answer(name)?;
    let AnswerValue::Set(set, _) = &answer.value else { return None };
    if super::compare(answer, text) != super::Verdict::Wrong {
        return None;
    }
    let limit = |text: &str| {
        let number = text.trim().trim_start_matches(['<', '>', '=', '≤', '≥', ' ']);
        super::read(answer, number).ok()
    };
    let typed = limit(text)?;
    let within = super::half_a_place(&typed) + 1e-12 * typed.si.abs();
    let is_typed = |si: f64| (si - typed.si).abs() <= within;
    let printed = disputed(entry, record).into_iter().find(|(answer, printed, _)| {
        answer == name && limit(printed).is_some_and(|printed| is_typed(printed.si))
    });
    let mut ends = set.intervals().flat_map(|part| [part.lower, part.upper]);
    let change = match printed {
        Some((_, _, why)) => Change::Printed(why),
        None if ends
            .any(|end| matches!(end, Bound::Included(end) | Bound::Excluded(end) if is_typed(end))) =>
        {
            Change::Branch
        }
        None => return None,
    };
    Some((name.to_owned(), vec![Cause::new(vec![Mistake::new(Place::Answer, change)], true)]))
}
