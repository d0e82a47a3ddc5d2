//! Mistakes that give the digits of an answer, as causes: those that cannot be distinguished are one, and the likeliest comes first.

use std::{cmp::Ordering, collections::BTreeSet};

use dalembert_units::Dim;

use super::{
    Cause, Change, Mistake, Place, difference,
    steps::node_of,
    wrong::{Wrong, is_near},
};
use crate::{Solution, trace::Id};

/// A cause is named only where random numbers would meet so few of the candidates that are as likely.
pub(super) const NAMED: f64 = 0.02;
/// It is listed as possible up to here.
pub(super) const POSSIBLE: f64 = 0.5;
/// So many other mistakes are listed with the first that gives their number.
pub(super) const EQUIVALENTS: usize = 2;
/// A cause is named only if it is so likely beside all others that give the digits, known and unknown.
const LIKELY: f64 = 0.9;
/// In so many of a thousand wrong answers there is a mistake that we do not know.
pub(super) const UNKNOWN: f64 = 100.0;

/// Values that were tried, each counted once.
#[derive(Default)]
pub(super) struct Values {
    values: BTreeSet<(bool, i64)>,
    /// Expected number of chance hits.
    pub(super) accidents: f64,
}

impl Values {
    /// Counts a value, unless it is nothing or was tried before; values that agree to nine digits are one. True if it was counted.
    pub(super) fn count(&mut self, one: &Wrong<'_>, value: f64) -> bool {
        if value == 0.0 {
            return false;
        }
        let key = (value < 0.0, (value.abs().ln() * 1e9).round() as i64);
        let is_known = (-1..=1).any(|off| self.values.contains(&(key.0, key.1.saturating_add(off))));
        if !is_known {
            self.values.insert(key);
            self.accidents += one.accident(value);
        }
        !is_known
    }
}

/// Mistakes that give the digits of the answer.
pub(super) struct Hit {
    pub(super) cause: Cause,
    /// Number of the user's other wrong answers that they give as well.
    pub(super) others: usize,
    pub(super) prior: f64,
    /// The number that they give; NaN where it is the user's own or a book's.
    pub(super) value: f64,
    /// In so many of a thousand wrong answers an unknown mistake leads to the digits of this number.
    pub(super) unknown: f64,
}

impl Hit {
    /// Order of causes: named before possible, those that explain more answers first, then the likelier.
    fn rank(&self, other: &Hit) -> Ordering {
        (other.cause.is_named, other.others)
            .cmp(&(self.cause.is_named, self.others))
            .then(other.prior.total_cmp(&self.prior))
    }

    /// True if the number of another hit is this one.
    fn is_of(&self, other: &Hit) -> bool {
        is_near(self.value, other.value) && self.others == other.others
    }
}

fn places(mistakes: &[Mistake]) -> Vec<&Place> {
    mistakes.iter().map(|one| &one.place).collect()
}

/// True if two causes are the same mistakes at other places before the finished answer, or other mistakes at the same.
fn are_alike(one: &Cause, other: &Cause) -> bool {
    // A number that is so many times too large may be so for any reason.
    let operation = |mistake: &Mistake| match mistake.operation() {
        "power-of-ten" | "unit" | "half" | "degrees" => "factor",
        other => other,
    };
    let operations = |cause: &Cause| cause.mistakes.iter().map(operation).collect::<Vec<_>>();
    let here = places(&other.mistakes);
    let is_last = |places: &[&Place]| places.contains(&&Place::Answer);
    let is_elsewhere = |all: &Vec<Mistake>| !is_last(&places(all)) && places(all) != here;
    let is_the_same = !is_last(&here) && operations(one) == operations(other);
    is_the_same && one.all_mistakes().all(is_elsewhere) || places(&one.mistakes) == here
}

/// True if two causes are the sign of one step and of another, of which the first is enough.
fn are_signs_of_steps(one: &Cause, other: &Cause) -> bool {
    let is_sign = |cause: &Cause| matches!(&cause.mistakes[..], [only] if only.change == Change::Sign && matches!(only.place, Place::Step(..)));
    is_sign(one) && is_sign(other)
}

/// True if a mistake with the finished answer is one with the step that holds it.
fn is_of_last_step(answer: &Hit, step: &Hit, node: Option<Id>, solution: &Solution) -> bool {
    match (&answer.cause.mistakes[..], &step.cause.mistakes[..]) {
        ([answer], [step]) => {
            let is_last = matches!(step.place, Place::Step(at, _) if Some(solution.steps[at].result) == node);
            answer.place == Place::Answer && is_last && answer.change == step.change
        }
        _ => false,
    }
}

/// True for a mistake in a step that says why an angle is another one.
fn says_which_angle(mistake: &Mistake) -> bool {
    let says = matches!(mistake.change, Change::Common(_) | Change::Quadrant | Change::AcuteAngle);
    says && matches!(mistake.place, Place::Step(..))
}

/// True if a mistake is only that an angle is another one, by whole turns that of a mistake that says why.
fn is_only_another_angle(only: &Hit, said: &Hit, one: &Wrong<'_>, solution: &Solution) -> bool {
    let ([only_one], [said_one]) = (&only.cause.mistakes[..], &said.cause.mistakes[..]) else { return false };
    let is_last =
        matches!(said_one.place, Place::Step(at, _) if Some(solution.steps[at].result) == node_of(one));
    let says_less = match &only_one.change {
        Change::Direction => only_one.place == Place::Answer || only_one.place == said_one.place,
        Change::OtherAnswer(_) => is_last && matches!(said_one.change, Change::Common(_)),
        _ => false,
    };
    says_less
        && one.answer.dim() == Dim::ANGLE
        && says_which_angle(said_one)
        && difference(only.value, said.value, Dim::ANGLE) <= 1e-9
}

/// True for an error that is declared of a step, and one of its result alone, which says less.
fn is_said_by(said: &Cause, other: &Cause) -> bool {
    match (&said.mistakes[..], &other.mistakes[..]) {
        ([said], [other]) => {
            matches!(said.change, Change::Common(_))
                && !matches!(other.change, Change::Common(_))
                && said.place == other.place
                && other.of.is_none()
        }
        _ => false,
    }
}

/// True if two mistakes were made in one step: that is as well one that we do not know.
fn is_in_one_step(cause: &Cause) -> bool {
    matches!(&cause.mistakes[..], [one, other] if one.place == other.place)
}

/// Causes of hits, the likeliest first. Hits with one number are one cause where they are the same mistake at several places,
/// or several at one place; those that read alike are listed once.
pub(super) fn causes_of(one: &Wrong<'_>, mut hits: Vec<Hit>, solution: &Solution) -> Vec<Cause> {
    let node = node_of(one);
    hits.sort_by(Hit::rank);
    let all: Vec<(usize, f64)> = hits.iter().map(|hit| (hit.others, hit.prior)).collect();
    // The step says more than the answer.
    for at in (0..hits.len()).rev() {
        let step = hits.iter().position(|step| is_of_last_step(&hits[at], step, node, solution));
        if let Some(step) = step.filter(|step| hits[*step].is_of(&hits[at])) {
            hits[step].prior += hits[at].prior;
            hits.remove(at);
        }
    }
    // So does the reason why an angle is another one.
    for at in (0..hits.len()).rev() {
        let said = hits.iter().position(|said| is_only_another_angle(&hits[at], said, one, solution));
        if let Some(said) = said {
            hits[said].prior += hits[at].prior;
            hits.remove(at);
        }
    }
    hits.sort_by(Hit::rank);
    let mut found: Vec<(Hit, Vec<String>)> = Vec::new();
    for hit in hits {
        let sentence = hit.cause.text(solution).english();
        if let Some((known, _)) = found.iter_mut().find(|(_, sentences)| sentences.contains(&sentence)) {
            known.prior += if known.is_of(&hit) { hit.prior } else { 0.0 };
            continue;
        }
        let alike =
            found.iter_mut().find(|(known, _)| known.is_of(&hit) && are_alike(&known.cause, &hit.cause));
        match alike {
            Some((known, sentences)) => {
                sentences.push(sentence);
                if is_said_by(&known.cause, &hit.cause) {
                    known.prior += hit.prior;
                } else if known.cause.equivalents.len() < EQUIVALENTS
                    && !are_signs_of_steps(&known.cause, &hit.cause)
                {
                    known.prior += hit.prior;
                    known.cause.equivalents.push(hit.cause.mistakes);
                }
            }
            None => found.push((hit, vec![sentence])),
        }
    }
    found.sort_by(|(a, _), (b, _)| a.rank(b));
    let likely = |(mut hit, _): (Hit, Vec<String>)| {
        let rivals = all.iter().filter(|(others, _)| *others == hit.others).map(|(_, prior)| prior);
        // What was said by the user or a book is no chance.
        let is_likely = hit.value.is_nan() || hit.prior >= LIKELY * (rivals.sum::<f64>() + hit.unknown);
        hit.cause.is_named &= is_likely && !is_in_one_step(&hit.cause);
        hit.cause
    };
    found.into_iter().map(likely).collect()
}
