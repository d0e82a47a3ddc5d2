//! Sensitivity analysis: effect of small changes of the inputs on an answer.

use dalembert_units::Unit;

use crate::{
    Entry, Record, Refusal, SolveError, Stop, Text,
    definitions::Tolerance,
    vary::{self, Perturbed, VariedInput},
};

/// The step of the derivative, as a share of the input: the error of a central difference is then about 10⁻⁸.
const STEP: f64 = 1e-4;
/// One-sided changes that differ by so much of the larger one are a kink.
const KINK: f64 = 0.3;

/// The tolerance of an input that none is given for, in its [steps](VariedInput::step).
pub const USUAL: f64 = 1.0;

/// Sensitivity of one answer to all inputs.
#[derive(Clone, Debug)]
pub struct Sensitivity {
    /// The name of the answer.
    pub answer: String,
    /// Value at the nominal inputs, in SI.
    pub value: f64,
    /// Influences, one for each input, in the order of the form.
    pub influences: Vec<InputInfluence>,
    /// Combined effect of all tolerances.
    pub spread: Spread,
}

/// Effect of one input on one answer.
#[derive(Clone, Debug)]
pub struct InputInfluence {
    /// The input.
    pub input: VariedInput,
    /// The tolerance that was given for it, in SI.
    pub tolerance: f64,
    /// The answer with the input a [step](VariedInput::step) smaller and a step larger, in SI; NaN where there is none.
    pub sides: [f64; 2],
    /// The answer with the input at both ends of its tolerance.
    pub at_tolerance: [f64; 2],
    /// The derivative of the answer by the input, in SI; NaN where there is none.
    pub derivative: f64,
    /// Reason for which there is no answer at one of these values.
    pub refused: Option<Text>,
}

/// Combined effect of the tolerances of all inputs on an answer, in SI.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spread {
    /// The least and the largest answer that ends of tolerances give together.
    pub worst: [f64; 2],
    /// To either side, where they are independent of each other: `√(Σ Δ²)`.
    pub likely: f64,
}

/// The sensitivity of an answer to every number among the inputs. `tolerances` are in SI, by the paths of their inputs;
/// `usual` is that of every other one, in its [steps](VariedInput::step).
///
/// # Errors
/// Why the problem as given has no answer, or none of that name.
pub fn sensitivity(
    entry: &Entry,
    record: &Record,
    answer: &str,
    (tolerances, usual): (&[(String, f64)], f64),
    stop: &Stop,
) -> Result<Sensitivity, SolveError> {
    let mut again = Perturbed::new(entry, record, vary::inputs(record), vec![answer.to_owned()])?;
    if again.answers.is_empty() {
        return Err(Refusal::because("this answer is not a scalar").into());
    }
    let value = again.with(&[], stop)?[0];
    let mut influences = Vec::new();
    for (at, input) in again.inputs.clone().into_iter().enumerate() {
        let tolerance = tolerance(&input, tolerances, usual);
        let mut changed =
            |by: f64| -> Result<f64, Refusal> { Ok(again.with(&[(at, input.si + by)], stop)?[0]) };
        let mut both = |by: f64| -> Result<[f64; 2], Refusal> { Ok([changed(-by)?, changed(by)?]) };
        let sides = both(input.step())?;
        let at_tolerance = both(tolerance)?;
        let small = STEP * if input.si == 0.0 { input.unit.factor } else { input.si.abs() };
        let [before, after] = both(small)?;
        let derivative = sided([before, value, after], small);
        let missing = [-input.step(), input.step(), -tolerance, tolerance]
            .into_iter()
            .zip(sides.into_iter().chain(at_tolerance))
            .find(|(_, value)| value.is_nan());
        let refused =
            missing.and_then(|(by, _)| vary::why_not(entry, record, (&input, input.si + by), answer, stop));
        influences.push(InputInfluence { input, tolerance, sides, at_tolerance, derivative, refused });
    }
    let spread = together(&mut again, value, &influences, stop)?;
    Ok(Sensitivity { answer: answer.to_owned(), value, influences, spread })
}

/// The tolerances that the inputs and definitions of a problem are written with, in SI, by their paths.
pub fn tolerances(record: &Record) -> Vec<(String, f64)> {
    let Some(plan) = &record.plan else { return Vec::new() };
    let inputs = vary::inputs(record);
    let of = |tolerance: &Tolerance| {
        let input = inputs.iter().find(|input| input.path == tolerance.name)?;
        Some((input.path.clone(), tolerance.width.at(input.si)))
    };
    plan.tolerances().iter().filter_map(of).collect()
}

/// The tolerance of an input among those that were given.
pub(crate) fn tolerance(input: &VariedInput, given: &[(String, f64)], usual: f64) -> f64 {
    given
        .iter()
        .find(|(path, _)| *path == input.path)
        .map_or_else(|| usual * input.step().abs(), |(_, width)| *width)
}

/// The ends that raise or lower the answer most are put together one by one, the most influential first: exact where the
/// answer runs to one side with each input, and near a peak no end is taken that leads back down.
fn together(
    again: &mut Perturbed,
    value: f64,
    all: &[InputInfluence],
    stop: &Stop,
) -> Result<Spread, Refusal> {
    let mut order: Vec<usize> = (0..all.len()).collect();
    order.sort_by(|a, b| all[*b].within_tolerance(value).total_cmp(&all[*a].within_tolerance(value)));
    let mut farthest = |sign: f64| -> Result<f64, Refusal> {
        let (mut best, mut point) = (value, Vec::new());
        for at in &order {
            let one = &all[*at];
            for end in [one.input.si - one.tolerance, one.input.si + one.tolerance] {
                let tried: Vec<(usize, f64)> =
                    point.iter().copied().filter(|(known, _)| known != at).chain([(*at, end)]).collect();
                let found = again.with(&tried, stop)?[0];
                if sign * (found - best) > 0.0 {
                    (best, point) = (found, tried);
                }
            }
        }
        Ok(best)
    };
    let worst = [farthest(-1.0)?, farthest(1.0)?];
    let squares: f64 = all.iter().map(|one| one.within_tolerance(value).powi(2)).sum();
    Ok(Spread { worst, likely: squares.sqrt() })
}

impl InputInfluence {
    /// The change of the answer for a step more of the input, from both sides, in SI.
    pub fn change(&self, value: f64) -> f64 {
        let [less, more] = self.sides;
        match (less.is_nan(), more.is_nan()) {
            (false, false) => (more - less) / 2.0,
            (true, false) => more - value,
            (false, true) => value - less,
            (true, true) => f64::NAN,
        }
    }

    /// The relative change of the answer over that of the input: `(dy/dx) x/y`.
    pub fn elasticity(&self, value: f64) -> f64 {
        if value == 0.0 { f64::NAN } else { self.derivative * self.input.si / value }
    }

    /// The largest change of the answer within the tolerance, in SI.
    pub fn within_tolerance(&self, value: f64) -> f64 {
        let changes = self.at_tolerance.map(|end| (end - value).abs());
        changes.into_iter().filter(|change| change.is_finite()).fold(0.0, f64::max)
    }

    /// Returns true if the one-sided derivatives differ.
    pub fn has_kink(&self, value: f64) -> bool {
        let [less, more] = self.sides;
        let (before, after) = (value - less, more - value);
        (before - after).abs() > KINK * before.abs().max(after.abs())
    }

    /// The unit of the derivative: that of the answer over that of the input, as it is written.
    pub fn unit(&self, answer: &Unit) -> String {
        match (answer.pretty(), self.input.unit.pretty()) {
            (of, by) if by.is_empty() => of,
            (of, by) if of.is_empty() => format!("1/{}", bracketed(&by)),
            (of, by) => format!("{of} / {}", bracketed(&by)),
        }
    }
}

fn bracketed(unit: &str) -> String {
    if unit.contains(['·', '/']) { format!("({unit})") } else { unit.to_owned() }
}

/// The derivative from the values at `−step`, 0 and `step`: from both sides, or from the one that there is.
fn sided([before, here, after]: [f64; 3], step: f64) -> f64 {
    match (before.is_nan(), after.is_nan()) {
        (false, false) => (after - before) / (2.0 * step),
        (true, false) => (after - here) / step,
        (false, true) => (here - before) / step,
        (true, true) => f64::NAN,
    }
}
