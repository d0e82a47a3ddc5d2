//! Plan of a study as it is written in a file: which inputs vary, and how, and which answers are wanted.

use dalembert_units::{self as units, Kind, Unit};
use serde::{Deserialize, Serialize};

use crate::{Text, reading};

/// The plan of a study.
///
/// ```toml
/// problem = "fan.toml"
/// answers = ["amplitude", "phase"]
/// samples = 100_000
/// sampling = "latin-hypercube"
///
/// [[vary]]
/// input = "speed"
/// from = "600 rpm"
/// to = "1800 rpm"
/// points = 13
///
/// [[vary]]
/// input = "mass"
/// distribution = "normal"
/// deviation = "2 %"
///
/// [[limit]]
/// answer = "amplitude"
/// above = "0.2 mm"
/// ```
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct StudyPlan {
    /// The problem: a file beside the plan, or the id of an analysis, whose first case is taken.
    pub problem: String,
    /// Names of the answers; every answer that is a number where none is named.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub answers: Vec<String>,
    /// Samples of the inputs that have a distribution, at every point of the others.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub samples: Option<u64>,
    /// Method by which the samples are drawn.
    #[serde(default)]
    pub sampling: Sampling,
    /// Seed of the samples: the same seed gives the same ones.
    #[serde(default)]
    pub seed: u64,
    /// True for Sobol' indices: every sample is then a base sample of `d + 2` points of `d` inputs, by Saltelli's scheme.
    #[serde(default, skip_serializing_if = "is_false")]
    pub sobol_indices: bool,
    /// The inputs that vary. Those without a distribution make a grid, the first one slowest.
    #[serde(default)]
    pub vary: Vec<Variation>,
    /// Correlation of inputs that have a distribution.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub correlation: Vec<Correlation>,
    /// Limits whose probability of being exceeded is asked for.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub limit: Vec<Limit>,
    /// Conditions that every point must meet, an answer above or below a value: one that does not is refused.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub condition: Vec<Limit>,
    /// Pairs of inputs over which the answers are mapped; of the first two that vary where none is named.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub map: Vec<MappedInputs>,
}

fn is_false(value: &bool) -> bool {
    !value
}

/// Method by which samples are drawn from the distributions of inputs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Sampling {
    /// Independent random samples.
    #[default]
    MonteCarlo,
    /// One sample in each of as many equally probable intervals of every input as there are samples.
    LatinHypercube,
    /// The scrambled Sobol' sequence.
    Sobol,
}

/// Variation of an input, or of several inputs by the rows of a table. Of the four ways one is written: `values`;
/// `from`, `to` and `points`; `distribution` with its parameters; `table`.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Variation {
    /// The path of the input, or the name of a definition.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub input: Option<String>,
    /// A list of values.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub values: Option<Vec<Amount>>,
    /// First value of a range, or least value of a distribution.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub from: Option<Amount>,
    /// Last value of a range, or largest value of a distribution.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub to: Option<Amount>,
    /// Number of values of a range.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub points: Option<u64>,
    /// Spacing of the values of a range.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub scale: Option<Spacing>,
    /// The distribution.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub distribution: Option<DistributionKind>,
    /// Mean of a normal or lognormal distribution; the value of the problem where it is left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub mean: Option<Amount>,
    /// Standard deviation of a normal or lognormal distribution.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub deviation: Option<Amount>,
    /// Half the width of a uniform distribution about the value of the problem.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub tolerance: Option<Amount>,
    /// Most probable value of a triangular distribution; the value of the problem where it is left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub mode: Option<Amount>,
    /// CSV or Parquet file of measured values that are drawn from.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub data: Option<String>,
    /// Heading of the column of `data`; the name of the input where it is left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub column: Option<String>,
    /// CSV or Parquet file whose headings are inputs, `mass [kg],speed [rpm]`, and whose rows are taken one after another.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub table: Option<String>,
}

/// A number in the unit of its input, or a text with a unit: `"50 rad/s"`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(untagged)]
pub enum Amount {
    /// A number alone.
    Number(f64),
    /// A number with its unit.
    Text(String),
}

impl Amount {
    /// The value in SI; a number alone is in `unit`.
    ///
    /// # Errors
    /// Why it cannot be read.
    pub fn si(&self, unit: &Unit, kind: Kind) -> Result<f64, Text> {
        match self {
            Amount::Number(number) => Ok(unit.si(*number)),
            Amount::Text(text) => units::read_quantity(text, unit, kind)
                .map(|read| read.si)
                .map_err(|error| reading::text(&error)),
        }
    }
}

/// Spacing of the values of a range.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Spacing {
    /// Equal differences.
    #[default]
    Linear,
    /// Equal ratios.
    Log,
}

/// Kind of a distribution.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum DistributionKind {
    /// The same density from `from` to `to`, or within `tolerance` of the value of the problem.
    Uniform,
    /// Normal, by `mean` and `deviation`.
    Normal,
    /// Triangular from `from` to `to`, with its peak at `mode`.
    Triangular,
    /// Lognormal, by the `mean` and the `deviation` of the quantity itself.
    Lognormal,
    /// That of the measured values in `data`, with straight lines between them.
    Data,
}

/// Correlation of two inputs that have a distribution.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Correlation {
    /// The two inputs.
    pub inputs: [String; 2],
    /// Correlation coefficient of their normal scores, between −1 and 1; of two normal inputs, their own.
    pub coefficient: f64,
}

/// Two inputs over which the answers are mapped.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct MappedInputs {
    /// The input across, and the one upwards.
    pub inputs: [String; 2],
}

/// A limit of an answer, or a condition that it must meet.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Limit {
    /// The answer.
    pub answer: String,
    /// Values above this one exceed the limit, or meet the condition.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub above: Option<Amount>,
    /// Values below this one exceed the limit, or meet the condition.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub below: Option<Amount>,
}

/// A column of a file: its heading without the unit, the unit, and its numbers.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct DataColumn {
    /// Heading.
    pub name: String,
    /// Unit in brackets behind the heading; empty where there is none.
    pub unit: String,
    /// Numbers.
    pub numbers: Vec<f64>,
}

impl DataColumn {
    /// The column of a heading such as `mass [kg]`, without numbers.
    pub fn headed(text: &str) -> Self {
        let (name, unit) = text.trim_start_matches('\u{feff}').split_once('[').unwrap_or((text, ""));
        let unit = unit.trim_end().trim_end_matches(']').trim();
        Self { name: name.trim().to_owned(), unit: unit.to_owned(), numbers: Vec::new() }
    }

    /// Heading with the unit: `mass [kg]`.
    pub fn heading(&self) -> String {
        if self.unit.is_empty() { self.name.clone() } else { format!("{} [{}]", self.name, self.unit) }
    }
}

/// Reads the columns of a file that a plan names, or says why not.
pub type ReadData<'r> = dyn Fn(&str) -> Result<Vec<DataColumn>, Text> + 'r;
