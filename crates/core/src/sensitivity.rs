//! How much each input matters: what an answer does when one of them changes a little.

use dalembert_units::Unit;

use crate::{
    Entry, Record, Refusal, SolveError, Stop, Text,
    vary::{self, Again, Input},
};

/// The change of an input that its influence is shown for.
pub const PERCENT: f64 = 0.01;
/// The step of the derivative, as a share of the input: the error of a central difference is then about 10⁻⁸.
const STEP: f64 = 1e-4;
/// One-sided changes that differ by so much of the larger one are a kink.
const KINK: f64 = 0.3;

/// What one answer does when the inputs change.
#[derive(Clone, Debug)]
pub struct Sensitivity {
    /// The name of the answer.
    pub answer: String,
    /// Its value with the inputs as they are, in SI.
    pub value: f64,
    /// Its influences, one for each input, in the order of the form.
    pub influences: Vec<Influence>,
}

/// What one answer does when one input changes.
#[derive(Clone, Debug)]
pub struct Influence {
    /// The input.
    pub input: Input,
    /// The tolerance that was given for it, as a share of its value.
    pub tolerance: f64,
    /// The answer with the input 1 % smaller and 1 % larger, in SI; NaN where there is none.
    pub one_percent: [f64; 2],
    /// The answer with the input at both ends of its tolerance.
    pub at_tolerance: [f64; 2],
    /// The derivative of the answer by the input, in SI; NaN where there is none.
    pub derivative: f64,
    /// Why there is no answer at one of these values.
    pub refused: Option<Text>,
}

/// What the tolerances of all inputs do to an answer, in SI.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spread {
    /// All at their worst ends together: `Σ |Δ|`.
    pub worst: f64,
    /// Independent of each other: `√(Σ Δ²)`.
    pub likely: f64,
}

/// The sensitivity of an answer to every number among the inputs. `tolerances` are shares of the inputs, by their
/// paths; `usual` is that of every other one.
///
/// # Errors
/// Why the problem as it stands has no answer, or none of that name.
pub fn sensitivity(
    entry: &Entry,
    record: &Record,
    answer: &str,
    (tolerances, usual): (&[(String, f64)], f64),
    stop: &Stop,
) -> Result<Sensitivity, SolveError> {
    let mut again = Again::new(entry, record, vary::inputs(record), vec![answer.to_owned()])?;
    if again.answers.is_empty() {
        return Err(Refusal::because("this answer is no single number").into());
    }
    let value = again.with(&[], stop)?[0];
    let mut influences = Vec::new();
    for (at, input) in again.inputs.clone().into_iter().enumerate() {
        let tolerance =
            tolerances.iter().find(|(path, _)| *path == input.path).map_or(usual, |(_, share)| *share);
        let mut changed = |share: f64| -> Result<f64, Refusal> {
            Ok(again.with(&[(at, input.si * (1.0 + share))], stop)?[0])
        };
        let one_percent = [changed(-PERCENT)?, changed(PERCENT)?];
        let at_tolerance = [changed(-tolerance)?, changed(tolerance)?];
        let derivative = if input.si == 0.0 {
            let step = STEP * input.unit.factor;
            let [before, after] = [again.with(&[(at, -step)], stop)?[0], again.with(&[(at, step)], stop)?[0]];
            sided([before, value, after], step)
        } else {
            let ends = [changed(-STEP)?, value, changed(STEP)?];
            sided(ends, STEP * input.si)
        };
        let missing = [(-PERCENT, one_percent[0]), (PERCENT, one_percent[1])]
            .into_iter()
            .chain([(-tolerance, at_tolerance[0]), (tolerance, at_tolerance[1])])
            .find(|(_, value)| value.is_nan());
        let refused = missing
            .and_then(|(share, _)| vary::why_not(entry, record, &input, input.si * (1.0 + share), stop));
        influences.push(Influence { input, tolerance, one_percent, at_tolerance, derivative, refused });
    }
    Ok(Sensitivity { answer: answer.to_owned(), value, influences })
}

impl Sensitivity {
    /// What all tolerances do together; an end without an answer counts as the other one.
    pub fn spread(&self) -> Spread {
        let changes = self.influences.iter().map(|one| one.within_tolerance(self.value));
        let (worst, squares) = changes.fold((0.0, 0.0), |(sum, squares), x| (sum + x, squares + x * x));
        Spread { worst, likely: squares.sqrt() }
    }
}

impl Influence {
    /// The change of the answer for 1 % more of the input, from both sides, in SI.
    pub fn change(&self, value: f64) -> f64 {
        let [less, more] = self.one_percent;
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

    /// Whether the answer goes otherwise to one side than to the other.
    pub fn has_kink(&self, value: f64) -> bool {
        let [less, more] = self.one_percent;
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
