//! Candidate answers: the results that common mistakes would give, each with how common the mistake is.
//!
//! The prior of a mistake is its weight beside those of the others, 1 for the commonest. It ranks mistakes that give the
//! same number, and decides which of them are tried before chance hits become likely.

use std::f64::consts::{FRAC_1_SQRT_2, PI, SQRT_2, TAU};

use dalembert_units::{Dim, Kind};

use super::{
    Change, Mistake, Place,
    inputs::{inputs, units_of},
    problem::problems,
    steps::{LONGEST_TRACE, node_of, scalar, steps},
    tries::{Candidate, Tries},
    wrong::Wrong,
};
use crate::{
    Entry, Record, Solution, Stop, Text,
    cases::{self, ComparisonRule},
    reevaluate::{Edit, Reevaluation},
    trace::{Id, Number},
    vary,
};

/// Printed values of these inputs that the catalogue disputes: name of the answer, value, and reason.
pub(super) fn disputed(entry: &Entry, record: &Record) -> Vec<(String, String, Text)> {
    let all = cases::cases(entry).unwrap_or_default();
    let of_these = all.iter().filter(|case| case.record(entry).is_ok_and(|known| known == *record));
    let expected = of_these.flat_map(|case| &case.expect);
    expected
        .filter_map(|expected| match &expected.how {
            ComparisonRule::Disputed { why, .. } => {
                Some((expected.answer.clone(), expected.printed.clone(), why.clone()))
            }
            _ => None,
        })
        .collect()
}

/// Every candidate, the likeliest first; where `stop` is given, those that were found until then. `so_far` receives them
/// at the end of each stage but the last: what the trace gives, other options, other data as a whole; single digits take
/// longest.
pub(super) fn candidates(
    entry: &Entry,
    record: &Record,
    solution: &Solution,
    wrong: &[Wrong<'_>],
    stop: &Stop,
    so_far: &mut dyn FnMut(&[Candidate]),
) -> Vec<Candidate> {
    let mut all = Tries { wrong, found: Vec::new() };
    all.printed(entry, record);
    all.follow(solution);
    all.finished(solution, record);
    // Whatever was stopped, what was found before counts.
    let _stopped = steps(&mut all, solution, stop)
        .and_then(|()| {
            so_far(all.ranked());
            problems(&mut all, entry, record, stop)
        })
        .and_then(|()| {
            so_far(all.ranked());
            inputs(&mut all, entry, record, solution, stop, so_far)
        });
    all.ranked();
    all.found
}

impl Tries<'_, '_> {
    /// The value of one of the wrong answers alone.
    fn only(&self, at: usize, value: f64) -> Vec<f64> {
        let mut values = vec![f64::NAN; self.wrong.len()];
        values[at] = value;
        values
    }

    /// The answers changed at the end.
    fn answer(&mut self, prior: f64, change: &Change, by: impl Fn(f64, &Wrong<'_>) -> f64) {
        let values = self.wrong.iter().map(|one| by(one.computed, one)).collect();
        self.push(prior, Mistake::new(Place::Answer, change.clone()), values, false, Vec::new());
    }

    /// Mistakes with the finished answer.
    fn finished(&mut self, solution: &Solution, record: &Record) {
        self.units();
        self.answer(0.95, &Change::Sign, |x, _| -x);
        for (prior, factor, written) in [
            (0.5, 2.0, "2"),
            (0.5, 0.5, "2"),
            (0.45, TAU, "2π"),
            (0.45, 1.0 / TAU, "2π"),
            (0.25, PI, "π"),
            (0.25, 1.0 / PI, "π"),
            (0.25, 4.0, "4"),
            (0.25, 0.25, "4"),
            (0.3, SQRT_2, "√2"),
            (0.3, FRAC_1_SQRT_2, "√2"),
            (0.25, 9.81, "g"),
            (0.25, 1.0 / 9.81, "g"),
            (0.25, 10.0, "g"),
            (0.2, 3.0, "3"),
            (0.2, 1.0 / 3.0, "3"),
            (0.15, -2.0, "−2"),
            (0.15, -0.5, "−2"),
        ] {
            self.answer(prior, &Change::Times(factor, written), |x, _| factor * x);
        }
        for places in [-6i8, -5, -4, -3, -2, -1, 1, 2, 3, 4, 5, 6] {
            let factor = 10f64.powi(places.into());
            let prior = if places.abs() <= 3 { 0.5 } else { 0.2 };
            self.answer(prior, &Change::PowerOfTen(places), |x, _| factor * x);
        }
        self.answer(0.5, &Change::Squared, |x, _| x * x);
        self.answer(0.5, &Change::Rooted, |x, _| x.sqrt());
        self.answer(0.4, &Change::Inverted, |x, _| 1.0 / x);
        for turn in [0.5 * PI, PI, TAU] {
            self.angle(0.6, |x| turn - x);
            self.angle(0.5, |x| x - turn);
            self.angle(0.5, |x| x + turn);
        }
        self.ratio(0.3, &Change::Times(1e-2, "100"), |x| 0.01 * x);
        self.ratio(0.3, &Change::Times(1e2, "100"), |x| 100.0 * x);
        self.ratio(0.4, &Change::Direction, |x| 1.0 - x);
        self.others(solution);
        self.given(record);
    }

    fn angle(&mut self, prior: f64, by: impl Fn(f64) -> f64) {
        let is_angle = |one: &Wrong<'_>| one.answer.dim() == Dim::ANGLE;
        self.answer(prior, &Change::Direction, |x, one| if is_angle(one) { by(x) } else { f64::NAN });
    }

    fn ratio(&mut self, prior: f64, change: &Change, by: impl Fn(f64) -> f64) {
        let is_ratio = |one: &Wrong<'_>| one.answer.dim() == Dim::NONE;
        self.answer(prior, change, |x, one| if is_ratio(one) { by(x) } else { f64::NAN });
    }

    /// The number of another unit before the unit that was typed.
    fn units(&mut self) {
        for at in 0..self.wrong.len() {
            let one = &self.wrong[at];
            let (typed, kind, computed) = (one.unit.clone(), Kind::of(&one.answer.unit), one.computed);
            for (prior, customary) in [(0.9, false), (0.2, true)] {
                for taken in units_of(kind, &typed, customary) {
                    let change = Change::Unit { is: typed.pretty(), taken: taken.pretty() };
                    let values = self.only(at, typed.si(taken.value(computed)));
                    self.push(prior, Mistake::new(Place::Answer, change), values, false, Vec::new());
                }
            }
        }
    }

    /// Other answers and intermediate results of the problem.
    fn others(&mut self, solution: &Solution) {
        for other in &solution.answers {
            let Some(si) = other.si() else { continue };
            let name = other.name.to_string();
            let prior = 0.92;
            let value = |one: &Wrong<'_>| {
                if other.dim().agrees(one.answer.dim()) && one.name != name { si } else { f64::NAN }
            };
            let values = self.wrong.iter().map(value).collect();
            let mistake = Mistake::new(Place::Answer, Change::OtherAnswer(name.clone()));
            self.push(prior, mistake, values, false, Vec::new());
        }
        for step in &solution.steps {
            let Number::Scalar(si) = solution.trace.node(step.result).number else { continue };
            let fits = |one: &Wrong<'_>| step.unit.dim.agrees(one.answer.dim());
            let values = self.wrong.iter().map(|one| if fits(one) { si } else { f64::NAN }).collect();
            let mistake = Mistake::new(Place::Answer, Change::OtherStep(step.symbol));
            self.push(0.76, mistake.clone(), values, false, Vec::new());
            // The number of another kind of quantity, written with the unit that was asked for.
            for written in [step.unit.value(si), si] {
                let number = |one: &Wrong<'_>| if fits(one) { f64::NAN } else { one.unit.si(written) };
                let values = self.wrong.iter().map(number).collect();
                self.push(0.15, mistake.clone(), values, false, Vec::new());
            }
        }
    }

    /// Given values of the kind of an answer.
    fn given(&mut self, record: &Record) {
        for input in vary::inputs(record) {
            let fits = |one: &Wrong<'_>| input.unit.dim.agrees(one.answer.dim());
            let values = self.wrong.iter().map(|one| if fits(one) { input.si } else { f64::NAN }).collect();
            let mistake = Mistake::new(Place::Answer, Change::Given(input.path.clone(), input.label.clone()));
            self.push(0.95, mistake.clone(), values, false, Vec::new());
            let written = input.unit.value(input.si);
            let number = |one: &Wrong<'_>| if fits(one) { f64::NAN } else { one.unit.si(written) };
            let values = self.wrong.iter().map(number).collect();
            self.push(0.2, mistake, values, false, Vec::new());
        }
    }

    /// Published answers to this very problem that are disputed.
    fn printed(&mut self, entry: &Entry, record: &Record) {
        for (answer, printed, why) in disputed(entry, record) {
            let Some(at) = self.wrong.iter().position(|one| one.name == answer) else { continue };
            if let Ok(printed) = super::value(self.wrong[at].answer, &printed) {
                let mistake = Mistake::new(Place::Answer, Change::Printed(why));
                let values = self.only(at, printed);
                self.free(2.0, mistake, values);
            }
        }
    }

    /// Adds the consequences of the user's other answers (error carried forward).
    fn follow(&mut self, solution: &Solution) {
        let given: Vec<(usize, Id)> =
            self.wrong.iter().enumerate().filter_map(|(at, one)| Some((at, node_of(one)?))).collect();
        if given.len() < 2 || solution.trace.nodes.len() > LONGEST_TRACE {
            return;
        }
        for &(at, id) in &given {
            let before = solution.ancestors(id);
            let causes: Vec<&(usize, Id)> =
                given.iter().filter(|(other, cause)| *other != at && before.contains(cause)).collect();
            if causes.is_empty() {
                continue;
            }
            let edits: Vec<Edit> = causes
                .iter()
                .map(|(other, cause)| Edit::number(*cause, Number::Scalar(self.wrong[*other].answered)))
                .collect();
            let edits: Vec<&Edit> = edits.iter().collect();
            let found = Reevaluation::new(solution, &[id]).with(&edits, &[Some(id)]);
            let values = self.only(at, found.first().map_or(f64::NAN, |number| scalar(*number)));
            let names = causes.iter().map(|(other, _)| self.wrong[*other].name.to_owned()).collect();
            self.free(3.0, Mistake::new(Place::Answer, Change::Follows(names)), values);
        }
    }
}
