//! Optimum: the values of the unknowns with which an answer is least or largest, while others keep their limits, at every
//! end of the tolerances. Of two such answers the Pareto front, by minimising the first at limits of the second.

use dalembert_numerics::optimisation::{self, FEASIBLE};
use itertools::Itertools as _;

use super::{
    Determined, DeterminedInput, ReachedAnswer, column, equals, fault, listed, search::Variable, solved,
    with_determined,
};
use crate::{
    Answer, Axis, Cell, Column, Exhibit, Goal, Plot, Record, Refusal, Series, Sheet, SolveError, Stop,
    TableExhibit, Term, Text, Worksheet,
    definitions::{GivenAnswer, Plan},
    intern::fixed,
    tolerances::Corners,
    vary::{Perturbed, VariedInput},
};

/// The most combinations of choices that are tried, with and without other unknowns.
const MOST_COMBINATIONS: [usize; 2] = [200, 100_000];
/// The most optima or choices that are shown.
const SHOWN: usize = 12;
/// Points of a Pareto front, with its ends.
const FRONT: usize = 15;
/// The share of the wanted answer by which a search without derivatives may improve it.
const CONFIRMED: f64 = 1e-6;
/// The share of a range by which a value lies at its end.
const AT_END: f64 = 1e-9;

/// Search for an optimum.
#[derive(Clone, Debug, PartialEq)]
pub struct Optimum {
    /// The local optima, or the choices, the best first; of two wanted answers the Pareto front, by the first of them.
    pub candidates: Vec<Candidate>,
    /// Place of the one that is worked out.
    pub chosen: usize,
    /// True for each unknown that is one of several values.
    choices: Vec<bool>,
    /// Number of local searches.
    pub starts: usize,
    /// Number of those that ended at the best optimum.
    pub ended: usize,
    /// Number of points that were evaluated.
    pub evaluations: usize,
    /// Result of a search without derivatives; `None` where an unknown is a choice, and of a front.
    pub confirmed: Option<Confirmation>,
}

/// Improvement of the wanted answer by a search without derivatives from the optimum, in SI.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Confirmation {
    /// Wanted answer: its worst value within the tolerances.
    pub found: f64,
    /// Improvement.
    pub gain: f64,
    /// Difference that counts as a large one.
    pub scale: f64,
}

/// Values of the unknowns that may be the best.
#[derive(Clone, Debug, PartialEq)]
pub struct Candidate {
    /// The unknowns, in SI.
    pub x: Vec<f64>,
    /// The answers of the requirements, in SI.
    pub answers: Vec<f64>,
    /// Least and largest value of each within the tolerances.
    pub covered: Vec<[f64; 2]>,
    /// Largest share by which a limit is exceeded; none is where it is negative or rounding.
    violation: f64,
    starts: usize,
}

impl Candidate {
    /// Returns true if every limit is kept.
    pub fn is_feasible(&self) -> bool {
        self.violation <= FEASIBLE
    }
}

/// A problem whose optimum is sought.
pub(super) struct Setting<'s> {
    /// The problem at a point where it has answers.
    pub(super) begin: Record,
    pub(super) plan: &'s Plan,
    pub(super) inputs: Vec<VariedInput>,
    pub(super) variables: Vec<Variable>,
    pub(super) givens: &'s [GivenAnswer],
    pub(super) answers: Vec<Answer>,
}

/// Places of the one or two answers that are to be least or largest; `None` where there is none.
///
/// # Errors
/// A third one.
pub(super) fn objectives(givens: &[GivenAnswer]) -> Result<Option<Objectives>, SolveError> {
    let all: Vec<usize> = givens.iter().positions(|given| given.goal.is_extreme()).collect();
    match all[..] {
        [] => Ok(None),
        [one] => Ok(Some(Objectives::One(one))),
        [first, second] => Ok(Some(Objectives::Two(first, second))),
        [_, _, third, ..] => Err(fault(
            format!("{}.value", givens[third].path),
            "at most two answers can be the least or the largest: give a limit here, as in < 100 MPa",
        )),
    }
}

/// Places of the answers that are to be least or largest.
#[derive(Clone, Copy, Debug)]
pub(super) enum Objectives {
    One(usize),
    Two(usize, usize),
}

/// The answers at every combination of the tolerances, the first without them.
type Rows<'e> = dyn FnMut(&[f64]) -> Result<Vec<Vec<f64>>, Refusal> + 'e;

impl Setting<'_> {
    /// The problem with the best values of its unknowns.
    pub(super) fn determine(
        self,
        objectives: Objectives,
        corners: &Corners<'_>,
        perturbed: &mut Perturbed,
        stop: &Stop,
    ) -> Result<Record, SolveError> {
        let mut evaluate = |x: &[f64]| {
            corners.changes(x).map(|changes| perturbed.with(&changes, stop)).collect::<Result<Vec<_>, _>>()
        };
        let count = corners.count();
        let optimum = match objectives {
            Objectives::One(one) => self.search(&mut evaluate, self.givens, (one, count), stop)?,
            Objectives::Two(first, second) => self.front(&mut evaluate, [first, second], count, stop)?,
        };
        let Some(best) = optimum.candidates.get(optimum.chosen).cloned() else {
            return Err(Refusal::because(
                "the problem has no answer at any of the starts of the search: write narrower ranges, as in ? 1 kg .. 100 kg",
            )
            .into());
        };
        if !best.is_feasible() {
            return Err(self.out_of_reach(&best).into());
        }
        for (n, input) in self.inputs.iter().enumerate() {
            let values = [0.1, 0.37, 0.9].map(|share| {
                let mut x = best.x.clone();
                x[n] = self.variables[n].value(share);
                evaluate(&x)
            });
            let values = values.into_iter().collect::<Result<Vec<_>, _>>()?;
            if self.variables[n].choices.len() != 1 && values.iter().all(|rows| *rows == values[0]) {
                let why =
                    Text::new("{unknown} has no influence on the answers that something is required of");
                let why = why.with_text("unknown", input.label.clone());
                return Err(fault(self.plan.error_path(&input.path), why));
            }
        }
        let record = solved(&self.begin, self.plan, &self.inputs, &best.x)?;
        let unknowns = self.inputs.iter().zip(&self.variables).map(|(input, variable)| DeterminedInput {
            name: input.path.clone(),
            label: input.label.clone(),
            symbol: input.symbol,
            unit: input.unit.clone(),
            range: variable.range,
            uncertainty: None,
        });
        let givens =
            self.givens.iter().zip(&self.answers).zip(&best.answers).map(|((given, answer), reached)| {
                ReachedAnswer {
                    name: answer.name.to_string(),
                    label: answer.title(),
                    goal: given.goal,
                    unit: self.unit(given, answer),
                    given: if given.goal.is_extreme() { *reached } else { given.si },
                    reached: *reached,
                }
            });
        let determined = Determined {
            unknowns: unknowns.collect(),
            givens: givens.collect(),
            solutions: vec![best.x],
            points: optimum.starts,
            record: Record { plan: None, ..record.clone() },
            inverse: None,
            optimum: Some(optimum),
        };
        Ok(with_determined(record, determined))
    }

    fn unit(&self, given: &GivenAnswer, answer: &Answer) -> dalembert_units::Unit {
        if given.goal.is_extreme() { answer.unit.clone() } else { given.unit.clone() }
    }

    /// The Pareto front of two answers: the first is made best at even limits of the second, from its value where the first
    /// alone is wanted to its own best. What is worked out is the compromise nearest to the best of both.
    fn front(
        &self,
        evaluate: &mut Rows<'_>,
        [first, second]: [usize; 2],
        corners: usize,
        stop: &Stop,
    ) -> Result<Optimum, SolveError> {
        // The givens with a limit in place of one of the two; one without end is none.
        let limited = |at: usize, si: f64| {
            let mut givens = self.givens.to_vec();
            let is_upper = givens[at].goal == Goal::Minimum;
            (givens[at].goal, givens[at].si) = (if is_upper { Goal::AtMost } else { Goal::AtLeast }, si);
            givens
        };
        let mut front = self.search(evaluate, &limited(second, f64::INFINITY), (first, corners), stop)?;
        let other = self.search(evaluate, &limited(first, f64::INFINITY), (second, corners), stop)?;
        front.confirmed = None;
        let sign = [first, second].map(|at| sign(self.givens[at].goal));
        let worst = |candidate: &Candidate| {
            let of = |n: usize, at: usize| {
                candidate.covered[at].map(|si| sign[n] * si).into_iter().fold(f64::MIN, f64::max)
            };
            [of(0, first), of(1, second)]
        };
        let (Some(from), Some(to)) = (front.candidates.first().cloned(), other.candidates.into_iter().next())
        else {
            return Ok(front);
        };
        front.candidates = vec![from.clone()];
        if !from.is_feasible() {
            return Ok(front);
        }
        let ends = [worst(&from)[1], worst(&to)[1]];
        for n in 1..FRONT {
            stop.report(n, FRONT);
            let limit = ends[0] + (ends[1] - ends[0]) * n as f64 / (FRONT - 1) as f64;
            let found = self.search(evaluate, &limited(second, sign[1] * limit), (first, corners), stop)?;
            front.starts += found.starts;
            front.evaluations += found.evaluations;
            front.candidates.extend(found.candidates.into_iter().next().filter(Candidate::is_feasible));
        }
        let all = front.candidates.clone();
        let is_better = |a: &Candidate, b: &Candidate| {
            let (a, b) = (worst(a), worst(b));
            a[0] <= b[0] && a[1] <= b[1] && a != b
        };
        front.candidates.retain(|one| !all.iter().any(|other| is_better(other, one)));
        front.candidates.sort_by(|a, b| worst(a)[0].total_cmp(&worst(b)[0]));
        front.candidates.dedup_by(|a, b| worst(a) == worst(b));
        let points: Vec<[f64; 2]> = front.candidates.iter().map(worst).collect();
        let (least, most) = (points[0], points[points.len() - 1]);
        let distance = |point: &[f64; 2]| {
            let share = |n: usize, best: f64, worst: f64| {
                if worst == best { 0.0 } else { (point[n] - best) / (worst - best) }
            };
            share(0, least[0], most[0]).hypot(share(1, most[1], least[1]))
        };
        let nearest = points.iter().enumerate().min_by(|a, b| distance(a.1).total_cmp(&distance(b.1)));
        front.chosen = nearest.map_or(0, |(at, _)| at);
        Ok(front)
    }

    /// Searches every combination of the choices for the best values of the other unknowns.
    fn search(
        &self,
        evaluate: &mut Rows<'_>,
        givens: &[GivenAnswer],
        (objective, corners): (usize, usize),
        stop: &Stop,
    ) -> Result<Optimum, SolveError> {
        let is_choice = |variable: &Variable| !variable.choices.is_empty();
        let ranged: Vec<usize> = self.variables.iter().positions(|variable| !is_choice(variable)).collect();
        let chosen: Vec<usize> = self.variables.iter().positions(is_choice).collect();
        let count = chosen.iter().map(|at| self.variables[*at].choices.len() as f64).product::<f64>();
        let most = MOST_COMBINATIONS[usize::from(ranged.is_empty())];
        if count > most as f64 {
            let why = Text::new("{count} combinations of choices: at most {most} are tried; leave some out");
            let path = self.plan.error_path(&self.inputs[chosen[0]].path);
            return Err(fault(path, why.with("count", count).with("most", most)));
        }
        let combinations = chosen
            .iter()
            .map(|at| self.variables[*at].choices.iter().copied())
            .multi_cartesian_product()
            .map(Some)
            .pad_using(1, |_| None);
        let mut optimum = Optimum {
            candidates: Vec::new(),
            chosen: 0,
            choices: self.variables.iter().map(is_choice).collect(),
            starts: 0,
            ended: 0,
            evaluations: 0,
            confirmed: None,
        };
        let mut confirmations = Vec::new();
        for (n, combination) in combinations.enumerate() {
            if count > 1.0 {
                stop.report(n, count as usize);
            }
            let mut x = vec![0.0; self.variables.len()];
            for (at, value) in chosen.iter().zip(combination.iter().flatten()) {
                x[*at] = *value;
            }
            let mut stopped = None;
            let mut with = |shares: &[f64]| {
                for (at, share) in ranged.iter().zip(shares) {
                    x[*at] = self.variables[*at].value(*share);
                }
                match evaluate(&x) {
                    Ok(rows) => Some((x.clone(), rows)),
                    Err(refusal) => {
                        stopped = Some(refusal);
                        None
                    }
                }
            };
            let found = if ranged.is_empty() {
                optimum.evaluations += 1;
                Vec::from_iter(with(&[]).map(|(x, rows)| (x, rows, 1)))
            } else {
                let start: Option<Vec<f64>> = ranged
                    .iter()
                    .map(|at| self.variables[*at].start.map(|start| self.variables[*at].share(start)))
                    .collect();
                let mut values = |shares: &[f64]| self.values(givens, &with(shares)?.1, objective);
                let minimum = optimisation::minimise(&mut values, ranged.len(), corners, start.as_slice());
                optimum.starts += minimum.starts;
                optimum.evaluations += minimum.evaluations;
                confirmations.push((minimum.gain, minimum.scale));
                let kept = if chosen.is_empty() { SHOWN } else { 1 };
                let optima = minimum.optima.into_iter().take(kept);
                optima
                    .filter_map(|optimum| with(&optimum.x).map(|(x, rows)| (x, rows, optimum.starts)))
                    .collect()
            };
            if let Some(refusal) = stopped {
                return Err(refusal.into());
            }
            for (x, rows, starts) in found {
                optimum.candidates.extend(self.candidate(givens, x, &rows, starts, objective));
            }
        }
        let sign = sign(givens[objective].goal);
        optimum.candidates.sort_by(|a, b| {
            let merit = |candidate: &Candidate| {
                let wanted = candidate.covered[objective].map(|si| sign * si);
                [if candidate.is_feasible() { 0.0 } else { candidate.violation }, wanted[0].max(wanted[1])]
            };
            let (a, b) = (merit(a), merit(b));
            a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1]))
        });
        if let Some(best) = optimum.candidates.first() {
            optimum.ended = best.starts;
            if let ([(gain, scale)], true) = (&confirmations[..], chosen.is_empty()) {
                let [least, largest] = best.covered[objective];
                let found = if sign > 0.0 { largest } else { least };
                optimum.confirmed = Some(Confirmation { found, gain: *gain, scale: *scale });
            }
        }
        optimum.candidates.truncate(SHOWN);
        Ok(optimum)
    }

    /// Values that the search makes least: the wanted answer at every corner, then by how much limits are exceeded.
    fn values(&self, givens: &[GivenAnswer], rows: &[Vec<f64>], objective: usize) -> Option<Vec<f64>> {
        let sign_of = sign(givens[objective].goal);
        let mut values: Vec<f64> = rows.iter().map(|row| sign_of * row[objective]).collect();
        for (n, (given, answer)) in givens.iter().zip(&self.answers).enumerate() {
            let size = [given.si.abs(), answer.si().map_or(0.0, f64::abs), 1.0];
            let size = size.into_iter().find(|size| *size > 0.0).unwrap_or(1.0);
            let difference = |row: &Vec<f64>| sign(given.goal) * (row[n] - given.si) / size;
            // A limit is kept to the last bit: what counts as met does not exceed it.
            let excess = |row: &Vec<f64>| difference(row) + FEASIBLE;
            match given.goal {
                Goal::Minimum | Goal::Maximum => {}
                Goal::AtMost | Goal::AtLeast if given.si.is_infinite() => {}
                Goal::AtMost | Goal::AtLeast => values.extend(rows.iter().map(excess)),
                Goal::Value => values.extend([difference(&rows[0]), -difference(&rows[0])]),
            }
        }
        values.iter().all(|value| value.is_finite()).then_some(values)
    }

    fn candidate(
        &self,
        givens: &[GivenAnswer],
        x: Vec<f64>,
        rows: &[Vec<f64>],
        starts: usize,
        objective: usize,
    ) -> Option<Candidate> {
        let values = self.values(givens, rows, objective)?;
        let covered = (0..self.givens.len()).map(|n| {
            let of = rows.iter().map(|row| row[n]);
            [of.clone().fold(f64::INFINITY, f64::min), of.fold(f64::NEG_INFINITY, f64::max)]
        });
        let violation = values[rows.len()..].iter().copied().fold(f64::NEG_INFINITY, f64::max);
        Some(Candidate { x, answers: rows[0].clone(), covered: covered.collect(), violation, starts })
    }

    /// Refusal where no values of the unknowns keep all limits.
    fn out_of_reach(&self, nearest: &Candidate) -> Refusal {
        let at = self.inputs.iter().zip(&nearest.x);
        let at = at.map(|(input, si)| equals(input.label.clone(), *si, &input.unit));
        let limits = self.givens.iter().zip(&self.answers).zip(&nearest.covered);
        let limits =
            limits.filter(|((given, _), _)| !given.goal.is_extreme()).map(|((given, answer), covered)| {
                let worst = if given.goal == Goal::AtLeast { covered[0] } else { covered[1] };
                let limit = wanted(answer.title(), given.goal, given.si, &given.unit);
                let found = Text::quantity(worst, fixed(&given.unit));
                Text::new("{limit} (found: {found})").with_text("limit", limit).with_text("found", found)
            });
        let text = Text::new(
            "no values of the unknowns in their ranges meet every requirement; the nearest: {limits}, with {at}",
        );
        Refusal::because(text.with_text("limits", listed(limits)).with_text("at", listed(at)))
    }
}

/// 1 where less is better.
fn sign(goal: Goal) -> f64 {
    if matches!(goal, Goal::Maximum | Goal::AtLeast) { -1.0 } else { 1.0 }
}

/// A requirement in words.
pub(super) fn wanted(answer: Text, goal: Goal, si: f64, unit: &dalembert_units::Unit) -> Text {
    let text = match goal {
        Goal::Value => return equals(answer, si, unit),
        Goal::AtMost => Text::new("{answer} ≤ {value}"),
        Goal::AtLeast => Text::new("{answer} ≥ {value}"),
        Goal::Minimum => return Text::new("{answer} as small as possible").with_text("answer", answer),
        Goal::Maximum => return Text::new("{answer} as large as possible").with_text("answer", answer),
    };
    text.with_text("answer", answer).with_quantity("value", si, fixed(unit))
}

impl Confirmation {
    /// Improvement as a share of the answer, or of its scale where that is smaller.
    fn share(&self) -> f64 {
        let size = self.found.abs();
        let size = if size > 1e-6 * self.scale { size.min(self.scale) } else { self.scale };
        self.gain / size
    }
}

impl Optimum {
    /// Compares the optimum with what a search without derivatives finds from there, says which ends of ranges it lies at,
    /// and shows the others.
    pub(super) fn conclude(&self, determined: &Determined, sheet: &Sheet<'_>) {
        let [wanted, _] = objectives_of(determined);
        if let (Some(confirmation), Some(wanted)) = (self.confirmed, wanted) {
            let what = Text::new("a search without derivatives finds no better {answer}");
            let what = what.with_text("answer", determined.givens[wanted].label.clone());
            sheet.check_residual(what, Term::from(confirmation.share()), 1.0, CONFIRMED);
        }
        let best = &self.candidates[self.chosen];
        for ((unknown, si), is_choice) in determined.unknowns.iter().zip(&best.x).zip(&self.choices) {
            let width = AT_END * (unknown.range[1] - unknown.range[0]);
            let end = unknown.range.iter().find(|end| (**end - si).abs() <= width);
            if let (Some(end), false) = (end, is_choice) {
                let text = Text::new(
                    "{unknown} lies at the end of its range, {end}: beyond it may be a better value",
                );
                let text = text.with_text("unknown", unknown.label.clone());
                let text = text.with_quantity("end", *end, fixed(&unknown.unit));
                sheet.warn(|| text);
            }
        }
        let shown = self.plot(determined).map(Exhibit::Plot).into_iter();
        let shown = shown.chain(self.table(determined).map(Exhibit::Table));
        shown.for_each(|exhibit| sheet.show(|| exhibit));
    }

    /// Table of the local optima, or of the choices; `None` where there is one alone.
    fn table(&self, determined: &Determined) -> Option<TableExhibit> {
        if self.candidates.len() < 2 {
            return None;
        }
        let unknowns = determined.unknowns.iter().map(|one| (one.label.clone(), &one.unit));
        let answers = determined.givens.iter().map(|one| (one.label.clone(), &one.unit));
        let columns = unknowns.chain(answers).map(|(heading, unit)| column(heading, unit));
        let columns = columns.chain([Column { heading: "requirements".into(), unit: "" }]).collect();
        let row = |candidate: &Candidate| {
            let numbers = candidate.x.iter().chain(&candidate.answers).copied().map(Cell::Number);
            let met = if candidate.is_feasible() { "met" } else { "not met" };
            numbers.chain([Text::from(met).into()]).collect()
        };
        let title = match objectives_of(determined) {
            [Some(_), Some(_)] => {
                Text::new("Pareto front; the working is that of the compromise nearest to the best of both")
            }
            _ => Text::new("Optima and choices, the best first"),
        };
        Some(TableExhibit {
            title,
            columns,
            rows: self.candidates.iter().map(row).collect(),
            foot: Vec::new(),
        })
    }

    /// The Pareto front drawn; `None` where one answer alone is wanted.
    fn plot(&self, determined: &Determined) -> Option<Plot> {
        let [Some(first), Some(second)] = objectives_of(determined) else { return None };
        let axis = |at: usize| {
            let given = &determined.givens[at];
            Axis::linear(given.label.clone(), fixed(&given.unit))
        };
        let point = |candidate: &Candidate| (candidate.answers[first], candidate.answers[second]);
        let points: Vec<(f64, f64)> = self.candidates.iter().map(point).collect();
        let worked = points[self.chosen];
        let front = Series::line(Text::new("Pareto front"), points);
        let plot = Plot::new(Text::new("Pareto front"), axis(first), axis(second), vec![front]);
        Some(plot.mark(Text::new("worked out"), worked))
    }
}

/// Places of the wanted answers.
fn objectives_of(determined: &Determined) -> [Option<usize>; 2] {
    let mut all = determined.givens.iter().positions(|given| given.goal.is_extreme());
    [all.next(), all.next()]
}
