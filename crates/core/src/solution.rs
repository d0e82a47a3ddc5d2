//! What a solution is made of: plain data, for a screen, a file or a test.

use dalembert_mechanics::intervals::IntervalSet;
use dalembert_units::{Dim, Unit};

use crate::{
    Cite, Exhibit, Text,
    trace::{Id, Number, Symbol, Trace},
};

/// Everything that a solve found.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Solution {
    /// The answers, in the order they were found.
    pub answers: Vec<Answer>,
    /// The worked solution.
    pub steps: Vec<Step>,
    /// Plots, tables and drawings.
    pub exhibits: Vec<Exhibit>,
    /// Independent ways to the same numbers, and how near they came.
    pub checks: Vec<Check>,
    /// Valid but doubtful.
    pub warnings: Vec<Text>,
    /// Faults of the program, never of its user: formulas whose two sides have different dimensions.
    pub defects: Vec<String>,
    /// How every number was found.
    pub trace: Trace,
}

/// An answer.
#[derive(Clone, Debug, PartialEq)]
pub struct Answer {
    /// The key in cases, files and on the command line.
    pub name: &'static str,
    /// What it is, in words.
    pub label: &'static str,
    /// What was found.
    pub value: AnswerValue,
    /// The unit it is shown in.
    pub unit: Unit,
    /// What of it is rounding alone, in SI: smaller numbers are shown as zero.
    pub noise: f64,
}

/// What an answer may be.
#[derive(Clone, Debug, PartialEq)]
pub enum AnswerValue {
    /// A number or a vector, and the node of the trace that holds it.
    Number(Number, Id),
    /// A set of numbers, and what limits each of its ends.
    Set(IntervalSet, Vec<Text>),
}

/// A line of the worked solution: `symbol = formula = substitution = result`.
#[derive(Clone, Debug, PartialEq)]
pub struct Step {
    /// How later formulas write the result.
    pub symbol: Symbol,
    /// The unit the result is shown in.
    pub unit: Unit,
    /// The formula; `None` where a numerical method found the number.
    pub formula: Option<Id>,
    /// The node that holds the result.
    pub result: Id,
    /// Why the step is taken; for a number that was found, how.
    pub why: Text,
    /// What says so.
    pub cite: Option<Cite>,
}

/// Two ways to the same number.
#[derive(Clone, Debug, PartialEq)]
pub struct Check {
    /// What is compared.
    pub what: Text,
    /// Their difference over their size.
    pub residual: f64,
    /// Whether the residual is below 10⁻⁹.
    pub passed: bool,
}

impl Solution {
    /// The answer of that name.
    pub fn answer(&self, name: &str) -> Option<&Answer> {
        self.answers.iter().find(|answer| answer.name == name)
    }
}

impl Answer {
    /// The answer as a number in SI, where it is one.
    pub fn si(&self) -> Option<f64> {
        match self.value {
            AnswerValue::Number(Number::Scalar(si), _) => Some(si),
            _ => None,
        }
    }

    /// Its dimension.
    pub fn dim(&self) -> Dim {
        self.unit.dim
    }
}
