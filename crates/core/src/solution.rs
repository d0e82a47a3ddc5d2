//! Parts of a solution: plain data, for a screen, a file or a test.

use std::{
    fmt,
    ops::{Bound, Range},
    sync::Arc,
};

use dalembert_numerics::intervals::IntervalSet;
use dalembert_units::{self as units, Dim, Unit};

use crate::{
    Cite, Determined, Exhibit, Locale, ShownUnits, Text,
    path::is_within,
    reading,
    trace::{Id, Number, Op, Symbol, Trace},
};

/// Everything that a solve found.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Solution {
    /// The answers, in the order they were found.
    pub answers: Vec<Answer>,
    /// The worked solution.
    pub steps: Vec<Step>,
    /// Steps of each of several problems or configurations; empty where there is one problem alone.
    pub problems: Vec<ProblemSteps>,
    /// Errors that people commonly make in steps, as the analysis knows them.
    pub common_errors: Vec<CommonError>,
    /// Plots, tables and drawings.
    pub exhibits: Vec<Exhibit>,
    /// Independent ways to the same numbers, and how near they came.
    pub checks: Vec<Check>,
    /// Valid but doubtful.
    pub warnings: Vec<Text>,
    /// Faults of the program, never of its user: formulas whose two sides have different dimensions.
    pub defects: Vec<String>,
    /// The unknown inputs as they were found; `None` where nothing was unknown.
    pub determined: Option<Arc<Determined>>,
    /// Inputs and definitions whose value is that of a formula or was found, by path or name, with their nodes.
    pub computed: Vec<(String, Id)>,
    /// System of units that it is shown in; `None` where answers are in the units of the analysis and inputs in those
    /// that were typed.
    pub units: Option<ShownUnits>,
    /// Trace of the computation of every number.
    pub trace: Trace,
}

/// Heading of a problem or a configuration among several; none before that of the file itself where it comes first.
pub fn problem_heading(is_first: bool, name: &str) -> Option<Text> {
    match name {
        "" if is_first => None,
        "" => Some(Text::new("All problems")),
        name => Some(Text::verbatim(name)),
    }
}

/// Steps of one of several problems or configurations.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ProblemSteps {
    /// Name of the problem or configuration; empty for the problem that the others are linked to.
    pub name: &'static str,
    /// Places of the steps in the solution.
    pub steps: Range<usize>,
    /// Places of its plots, tables and drawings in the solution.
    pub exhibits: Range<usize>,
}

/// An answer.
#[derive(Clone, Debug, PartialEq)]
pub struct Answer {
    /// The key in cases, files and on the command line.
    pub name: Name,
    /// Name of the linked problem or configuration that it is of; empty where there is one problem alone.
    pub problem: &'static str,
    /// Name in words.
    pub label: &'static str,
    /// The row of the inputs that it is about, by the name the user gave it; empty where that has none.
    pub row_label: String,
    /// Computed value.
    pub value: AnswerValue,
    /// The unit it is shown in.
    pub unit: Unit,
    /// Rounding error, in SI: smaller numbers are shown as zero.
    pub noise: f64,
    /// The digits it is shown with, where the user chose them.
    pub digits: Option<u8>,
    /// True if it is a main answer: one of those that its analysis names, or the answer to a question of the user's own.
    pub is_main: bool,
    /// True if it answers a question of the user's own.
    pub asked: bool,
    /// True if that question states its unit, which no system of units changes.
    pub is_unit_asked: bool,
}

/// The key of an answer: a name and, for one of several, its place, counted from 1: `frequency[2]`, `mode[1][3]`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Name {
    /// The name without its place.
    pub base: &'static str,
    /// The place, outermost first; 0 where there is no more.
    pub rows: [u16; 2],
}

/// Value of an answer.
#[derive(Clone, Debug, PartialEq)]
pub enum AnswerValue {
    /// A number or a vector, and the node of the trace that holds it.
    Number(Number, Id),
    /// A set of numbers, and what limits each of its ends.
    Set(IntervalSet, Vec<Text>),
    /// Numbers that belong together in this order: a mode shape.
    List(Vec<f64>),
}

/// A line of the worked solution: `symbol = formula = substitution = result`.
#[derive(Clone, Debug, PartialEq)]
pub struct Step {
    /// Symbol of the result in later formulas.
    pub symbol: Symbol,
    /// The unit the result is shown in.
    pub unit: Unit,
    /// The formula; `None` where a numerical method found the number.
    pub formula: Option<Id>,
    /// The node that holds the result.
    pub result: Id,
    /// Reason of the step; for the result of a numerical method, the method.
    pub why: Text,
    /// Citation of the source that states the formula.
    pub cite: Option<Cite>,
}

/// Error that people commonly make in a step.
#[derive(Clone, Debug, PartialEq)]
pub struct CommonError {
    /// Place of the step in the solution.
    pub step: usize,
    /// The node of the wrong number.
    pub formula: Id,
    /// Name of the error, in words.
    pub what: Text,
}

/// Two ways to the same number.
#[derive(Clone, Debug, PartialEq)]
pub struct Check {
    /// Description of the comparison.
    pub what: Text,
    /// Their difference over their size.
    pub residual: f64,
    /// The largest residual that passes: 10⁻⁹, or what rounding explains where digits are lost by cancellation.
    pub limit: f64,
    /// True if the residual is within its limit.
    pub passed: bool,
    /// Compared nodes of the trace.
    pub sides: Sides,
}

/// The two sides of a check, by their nodes of the trace.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Sides {
    /// Two numbers of the trace.
    Both(Id, Id),
    /// A number of the trace, and one that a numerical method found, which is not in it.
    One(Id),
    /// A residual of the trace, compared with zero.
    Residual(Id),
    /// Numbers that are not in the trace.
    #[default]
    Plain,
}

impl Sides {
    pub(crate) fn of(left: Option<Id>, right: Option<Id>) -> Self {
        match (left, right) {
            (Some(left), Some(right)) => Sides::Both(left, right),
            (Some(one), None) | (None, Some(one)) => Sides::One(one),
            (None, None) => Sides::Plain,
        }
    }
}

impl Solution {
    /// Value, in SI, and unit of an input or a definition that a formula gives or that was found.
    pub fn computed_input(&self, path: &str) -> Option<(f64, &Unit)> {
        match self.computed_value(path)? {
            (Number::Scalar(si), unit) => Some((si, unit)),
            (Number::Vector(_), _) => None,
        }
    }

    /// Number or vector, in SI, and unit of an input or a definition that a formula gives or that was found.
    pub fn computed_value(&self, path: &str) -> Option<(Number, &Unit)> {
        let (_, id) = self.computed.iter().find(|(known, _)| known == path)?;
        let node = self.trace.node(*id);
        let unit = match &node.op {
            Op::Step(step) => &self.steps[*step].unit,
            Op::Given { unit, .. } => unit,
            _ => return None,
        };
        Some((node.number, unit))
    }

    /// The answer of that name.
    pub fn answer(&self, name: &str) -> Option<&Answer> {
        self.answers.iter().find(|answer| answer.name.is(name))
    }

    /// Numbers among the answers that are limits of a set among them: the largest diameter of one branch and the smallest
    /// of the other.
    pub fn limits_of(&self, set: &Answer) -> Vec<&Answer> {
        let AnswerValue::Set(intervals, _) = &set.value else { return Vec::new() };
        let ends: Vec<f64> = intervals
            .intervals()
            .flat_map(|interval| [interval.lower, interval.upper])
            .filter_map(|bound| match bound {
                Bound::Included(si) | Bound::Excluded(si) => Some(si),
                Bound::Unbounded => None,
            })
            .collect();
        let is_end = |si: f64| ends.iter().any(|end| (end - si).abs() <= 1e-12 * end.abs());
        let is_limit = |answer: &&Answer| {
            answer.si().is_some_and(is_end)
                && answer.unit.dim == set.unit.dim
                && answer.problem == set.problem
        };
        self.answers.iter().filter(is_limit).collect()
    }

    /// The numbers that a number was computed from directly; of a step, the one that its formula gives.
    pub fn operands(&self, id: Id) -> Vec<Id> {
        match self.trace.node(id).op {
            Op::Step(step) => self.steps[step].formula.into_iter().collect(),
            _ => self.trace.operands(id),
        }
    }

    /// The numbers that a number was made from, its own among them, through the steps before, ascending.
    pub fn ancestors(&self, of: Id) -> Vec<Id> {
        let mut seen = vec![false; self.trace.nodes.len()];
        let mut open = vec![of];
        while let Some(id) = open.pop() {
            if !std::mem::replace(&mut seen[id as usize], true) {
                open.extend(self.operands(id));
            }
        }
        (0..).zip(seen).filter_map(|(id, seen)| seen.then_some(id)).collect()
    }

    /// Of the answers of these names, those that no other of them was made from: in them are all the others.
    pub fn last_of<'n>(&self, names: &[&'n str]) -> Vec<&'n str> {
        let id = |name: &str| match self.answer(name)?.value {
            AnswerValue::Number(_, id) => Some(id),
            _ => None,
        };
        let made: Vec<Vec<Id>> = names
            .iter()
            .filter_map(|name| id(name))
            .map(|made| self.ancestors(made).into_iter().filter(|from| *from != made).collect())
            .collect();
        let is_last = |name: &str| id(name).is_none_or(|id| made.iter().all(|from| !from.contains(&id)));
        names.iter().copied().filter(|name| is_last(name)).collect()
    }

    /// Returns true if an answer may change with the input at a path: it depends on it, or on the result of a numerical
    /// method, which may depend on any. Nothing is solved for this, so a condition on the input is not seen.
    pub fn may_change(&self, answer: &Answer, input: &str) -> bool {
        let AnswerValue::Number(_, id) = answer.value else { return true };
        self.ancestors(id).into_iter().any(|id| match &self.trace.node(id).op {
            Op::Given { path, .. } => is_within(input, path),
            Op::Step(step) => self.steps[*step].formula.is_none(),
            _ => false,
        })
    }
}

impl Answer {
    /// An answer in the unit and with the digits of the analysis.
    pub(crate) fn new(name: Name, label: &'static str, value: AnswerValue, unit: Unit, noise: f64) -> Self {
        Self {
            name,
            problem: "",
            label,
            row_label: String::new(),
            value,
            unit,
            noise,
            digits: None,
            asked: false,
            is_main: false,
            is_unit_asked: false,
        }
    }

    /// The answer as a number in SI, where it is one.
    pub fn si(&self) -> Option<f64> {
        match self.value {
            AnswerValue::Number(Number::Scalar(si), _) => Some(si),
            _ => None,
        }
    }

    /// Label followed by the row label or index, behind the name of its problem among several: `Force in the joint,
    /// pin B`, `Natural frequency 2`, `fan: Amplitude`.
    pub fn title(&self) -> Text {
        if self.problem.is_empty() {
            return self.title_within();
        }
        Text::new("{problem}: {title}").with("problem", self.problem).with_text("title", self.title_within())
    }

    /// Title without the name of the problem.
    pub fn title_within(&self) -> Text {
        let places = self.name.places().map(|row| row.to_string()).collect::<Vec<_>>().join(", ");
        match (&self.row_label[..], &places[..]) {
            ("", "") => Text::from(self.label),
            ("", place) => Text::new("{label} {place}").with_text("label", self.label).with("place", place),
            (row, _) => Text::new("{label}, {row}").with_text("label", self.label).with("row", row),
        }
    }

    /// Title in the language.
    pub fn label(&self, locale: &Locale) -> String {
        self.title().render(locale)
    }

    /// Dimension of the value.
    pub fn dim(&self) -> Dim {
        self.unit.dim
    }
}

/// Display of an answer, as written in a problem file: `mm`, `mm; 6 digits`, `6 digits`.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Display {
    /// Unit; empty for that of the analysis.
    pub unit: String,
    /// Significant digits; `None` for the common setting.
    pub digits: Option<u8>,
}

impl Display {
    /// Reads a display as far as it is valid.
    pub fn of(text: &str) -> Self {
        let digits = |part: &str| part.trim().strip_suffix("digits")?.trim().parse().ok();
        match text.rsplit_once(';') {
            Some((unit, rest)) if digits(rest).is_some() => {
                Self { unit: unit.trim().to_owned(), digits: digits(rest) }
            }
            None if digits(text).is_some() => Self { unit: String::new(), digits: digits(text) },
            _ => Self { unit: text.trim().to_owned(), digits: None },
        }
    }
}

impl Display {
    /// Reads a display: an existing unit, and from 1 to 17 digits.
    pub fn read(text: &str) -> Result<Self, Text> {
        let count =
            text.rsplit(';').next().and_then(|part| part.trim().strip_suffix("digits")).map(str::trim);
        if let Some(count) = count
            && !count.parse().is_ok_and(|count: u8| (1..=17).contains(&count))
        {
            return Err(Text::new("`{count} digits`: write from 1 to 17 digits").with("count", count));
        }
        let display = Self::of(text);
        if !display.unit.is_empty() {
            units::unit(&display.unit).map_err(|err| reading::text(&err))?;
        }
        Ok(display)
    }
}

impl fmt::Display for Display {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match (self.unit.as_str(), self.digits) {
            (unit, None) => f.write_str(unit),
            ("", Some(digits)) => write!(f, "{digits} digits"),
            (unit, Some(digits)) => write!(f, "{unit}; {digits} digits"),
        }
    }
}

impl Name {
    /// Returns true if the name is written so.
    pub fn is(self, written: &str) -> bool {
        match written.strip_prefix(self.base) {
            Some("") => self.rows[0] == 0,
            Some(_) => self.to_string() == written,
            None => false,
        }
    }

    fn places(self) -> impl Iterator<Item = u16> {
        self.rows.into_iter().filter(|row| *row > 0)
    }
}

impl fmt::Display for Name {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.base)?;
        self.places().try_for_each(|row| write!(f, "[{row}]"))
    }
}

impl From<&'static str> for Name {
    fn from(base: &'static str) -> Self {
        Self { base, rows: [0; 2] }
    }
}

impl From<(&'static str, usize)> for Name {
    fn from((base, row): (&'static str, usize)) -> Self {
        Self { base, rows: [place(row), 0] }
    }
}

impl From<(&'static str, usize, usize)> for Name {
    fn from((base, row, column): (&'static str, usize, usize)) -> Self {
        Self { base, rows: [place(row), place(column)] }
    }
}

fn place(row: usize) -> u16 {
    u16::try_from(row).unwrap_or(u16::MAX)
}
