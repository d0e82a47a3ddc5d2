//! Grading of the answers of a class: verdict, credit and probable cause of each, and statistics of the class.
//!
//! Rows name a student, an answer and a value. A value is a number with its unit, or an interval, `19.4 ± 0.1 mm`; a number
//! alone is in the unit that the answer is shown in. No value names a file.

mod reading;
mod report;
mod statistics;

use dalembert_core::{Answer, Entry, Locale, Record, Solution, Stop, Text, check::Verdict, nearest};
use dalembert_units::{self as units, Dim};

pub use self::{
    reading::{AnswerRow, MOST_ROWS, read},
    report::{csv_of, document_of, json_of},
    statistics::{AnswerStatistics, MOST_CAUSES, statistics},
};
use crate::causes::{self, CauseKind};

/// The longest value of an answer that is read, in bytes.
pub const LONGEST_VALUE: usize = 200;
/// Share of an answer that half an interval may be, in tolerances.
pub const WIDEST_INTERVAL: f64 = 10.0;

/// Result of grading an answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Outcome {
    /// Right to every digit that was given, or an interval that holds the answer.
    Right,
    /// Within the tolerance, but rounded on the way.
    RoundedEarly,
    /// It agrees to the digits that were given, which are too few.
    FewDigits,
    /// It follows from wrong answers before it.
    CarriedForward,
    /// Wrong by the sign or the unit alone.
    SignOrUnit,
    /// Wrong.
    Wrong,
    /// It cannot be read.
    Unread,
    /// It was not answered.
    NotAnswered,
}

/// Rules of grading.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rules {
    /// Tolerance, as a share of the answer.
    pub tolerance: f64,
    /// Credit for each outcome, in the order of [`Outcome::WITH_CREDIT`].
    pub weights: [f64; 5],
}

/// A graded answer.
#[derive(Clone, Debug, PartialEq)]
pub struct GradedAnswer {
    /// Student.
    pub student: String,
    /// Name of the answer.
    pub answer: String,
    /// Value as it was given.
    pub value: String,
    /// Computed answer, as it is shown.
    pub expected: String,
    /// Outcome.
    pub outcome: Outcome,
    /// Credit, from 0 to 1.
    pub credit: f64,
    /// Probable cause of a wrong answer, or why it cannot be read; empty otherwise.
    pub cause: Text,
}

impl Outcome {
    /// Outcomes that may have credit.
    pub const WITH_CREDIT: [Self; 5] =
        [Self::Right, Self::RoundedEarly, Self::FewDigits, Self::CarriedForward, Self::SignOrUnit];

    /// Every outcome.
    pub const ALL: [Self; 8] = [
        Self::Right,
        Self::RoundedEarly,
        Self::FewDigits,
        Self::CarriedForward,
        Self::SignOrUnit,
        Self::Wrong,
        Self::Unread,
        Self::NotAnswered,
    ];

    /// Key in files.
    pub const fn key(self) -> &'static str {
        match self {
            Self::Right => "right",
            Self::RoundedEarly => "rounded-early",
            Self::FewDigits => "few-digits",
            Self::CarriedForward => "carried-forward",
            Self::SignOrUnit => "sign-or-unit",
            Self::Wrong => "wrong",
            Self::Unread => "unread",
            Self::NotAnswered => "not-answered",
        }
    }

    /// Name in words.
    pub const fn label(self) -> &'static str {
        match self {
            Self::Right => "correct",
            Self::RoundedEarly => "rounded early",
            Self::FewDigits => "too few digits",
            Self::CarriedForward => "error carried forward",
            Self::SignOrUnit => "sign or unit error",
            Self::Wrong => "wrong",
            Self::Unread => "not readable",
            Self::NotAnswered => "not answered",
        }
    }
}

impl Default for Rules {
    /// 0.5 %; 1 for a right answer, 0.9 rounded early, 0.5 with too few digits, 0.8 with an error carried forward, 0.5 with
    /// a sign or unit error.
    fn default() -> Self {
        Self { tolerance: dalembert_core::check::TOLERANCE, weights: [1.0, 0.9, 0.5, 0.8, 0.5] }
    }
}

impl Rules {
    /// Reads changed weights: `rounded-early=1; sign-or-unit=0`.
    ///
    /// # Errors
    /// The part that cannot be read, and its repair.
    pub fn with_weights(mut self, text: &str) -> Result<Self, Text> {
        for part in text.split([';', ',']).map(str::trim).filter(|part| !part.is_empty()) {
            let read = part.split_once('=').and_then(|(key, weight)| {
                let at = Outcome::WITH_CREDIT.iter().position(|outcome| outcome.key() == key.trim())?;
                let weight: f64 = weight.trim().parse().ok()?;
                (0.0..=1.0).contains(&weight).then_some((at, weight))
            });
            let Some((at, weight)) = read else {
                let known = Outcome::WITH_CREDIT.map(Outcome::key).join(", ");
                let why = Text::new(
                    "{part}: write an outcome and a weight from 0 to 1, as in rounded-early=0.9; outcomes are {known}",
                );
                return Err(why.with("part", part).with("known", known));
            };
            self.weights[at] = weight;
        }
        Ok(self)
    }

    fn credit(&self, outcome: Outcome) -> f64 {
        let at = Outcome::WITH_CREDIT.iter().position(|known| *known == outcome);
        at.map_or(0.0, |at| self.weights[at])
    }
}

/// A problem as a student has it.
#[derive(Clone, Copy, Debug)]
pub struct GradedProblem<'a> {
    /// Analysis.
    pub entry: &'static Entry,
    /// Inputs.
    pub record: &'a Record,
    /// Solution.
    pub solution: &'a Solution,
    /// Names of the answers that are asked for.
    pub asked: &'a [String],
}

/// Grades the answers of one student: those that were given, in their order, then those that are missing. A search for
/// causes that is stopped names none.
pub fn grade(
    problem: &GradedProblem<'_>,
    (student, given): (&str, &[&AnswerRow]),
    rules: &Rules,
    locale: &Locale,
    stop: &Stop,
) -> Vec<GradedAnswer> {
    let mut graded: Vec<GradedAnswer> = Vec::new();
    let mut wrong: Vec<(String, String)> = Vec::new();
    for row in given {
        let is_second = graded.iter().any(|known| known.answer == row.answer);
        let found = problem.solution.answer(&row.answer);
        let (outcome, cause) = match found {
            _ if is_second => (Outcome::Unread, "answered twice: the first value counts".into()),
            None => (Outcome::Unread, no_such_answer(problem, &row.answer)),
            Some(_) if row.value.trim().is_empty() => (Outcome::NotAnswered, Text::from("")),
            Some(answer) => outcome(answer, row.value.trim(), rules.tolerance),
        };
        // An answer within its tolerance causes nothing.
        if outcome == Outcome::Wrong {
            wrong.push((row.answer.clone(), middle_of(row.value.trim())));
        }
        graded.push(GradedAnswer {
            student: student.to_owned(),
            answer: row.answer.clone(),
            value: row.value.clone(),
            expected: found.filter(|_| !is_second).map_or_else(String::new, |answer| answer.shown(locale)),
            outcome,
            credit: 0.0,
            cause,
        });
    }
    let causes = if wrong.is_empty() {
        Vec::new()
    } else {
        causes::causes(problem.entry, problem.record, problem.solution, &wrong, stop).unwrap_or_default()
    };
    for (name, cause) in causes {
        let is_it = |one: &&mut GradedAnswer| one.answer == name && one.outcome == Outcome::Wrong;
        if let Some(one) = graded.iter_mut().find(is_it) {
            one.cause = cause.text;
            one.outcome = match cause.kind {
                CauseKind::CarriedForward => Outcome::CarriedForward,
                CauseKind::SignOrUnit => Outcome::SignOrUnit,
                CauseKind::Other => Outcome::Wrong,
            };
        }
    }
    for name in
        problem.asked.iter().filter(|name| graded.iter().all(|one| one.answer != **name)).collect::<Vec<_>>()
    {
        graded.push(GradedAnswer {
            student: student.to_owned(),
            answer: name.clone(),
            value: String::new(),
            expected: problem.solution.answer(name).map_or_else(String::new, |answer| answer.shown(locale)),
            outcome: Outcome::NotAnswered,
            credit: 0.0,
            cause: Text::from(""),
        });
    }
    for one in &mut graded {
        one.credit = rules.credit(one.outcome);
    }
    graded
}

fn no_such_answer(problem: &GradedProblem<'_>, name: &str) -> Text {
    let known: Vec<String> = problem.solution.answers.iter().map(|answer| answer.name.to_string()).collect();
    let short: String = name.chars().take(60).collect();
    match nearest(name, known.iter().map(String::as_str)) {
        Some(near) => Text::new("there is no answer `{name}`; did you mean `{near}`?")
            .with("name", short)
            .with("near", near),
        None => Text::new("there is no answer `{name}`; write one of {known}")
            .with("name", short)
            .with("known", problem.asked.join(", ")),
    }
}

/// Outcome of a value before its causes are searched for.
fn outcome(answer: &Answer, typed: &str, tolerance: f64) -> (Outcome, Text) {
    let none = || Text::from("");
    if typed.len() > LONGEST_VALUE {
        let why = Text::new("longer than {most} characters: write a number and its unit");
        return (Outcome::Unread, why.with("most", LONGEST_VALUE));
    }
    if typed.starts_with('@') {
        return (Outcome::Unread, "an answer names no file: write a number and its unit".into());
    }
    if let Some((_, width)) = interval(typed) {
        return interval_outcome(answer, &middle_of(typed), width, tolerance);
    }
    match causes::compare(answer, typed) {
        Verdict::Right => (Outcome::Right, none()),
        Verdict::Unread(why) => match unit_error(answer, typed) {
            Some(why) => (Outcome::SignOrUnit, why),
            None => (Outcome::Unread, why),
        },
        verdict => {
            let near = relative_difference(answer, typed).is_some_and(|off| off <= tolerance);
            let outcome = match verdict {
                Verdict::TooFewDigits if near => Outcome::Right,
                Verdict::TooFewDigits => Outcome::FewDigits,
                _ if near => Outcome::RoundedEarly,
                _ => Outcome::Wrong,
            };
            (outcome, none())
        }
    }
}

/// Relative difference of a value and the computed answer; of directions, modulo one revolution.
fn relative_difference(answer: &Answer, typed: &str) -> Option<f64> {
    let (computed, typed) = (answer.si()?, causes::value(answer, typed).ok()?);
    let off = (typed - computed).abs();
    let off = if answer.dim() == Dim::ANGLE {
        let off = off.rem_euclid(std::f64::consts::TAU);
        off.min(std::f64::consts::TAU - off)
    } else {
        off
    };
    Some(off / computed.abs())
}

/// The sentence where the number is right and its unit is one of another quantity.
fn unit_error(answer: &Answer, typed: &str) -> Option<Text> {
    let read = units::quantity_of(typed).filter(|read| !read.unit.dim.agrees(answer.dim()))?;
    let style = units::Style { digits: 17, ascii: true, ..units::Style::default() };
    let number = units::write_number(read.unit.value(read.si), style);
    let is_right = matches!(causes::compare(answer, &number), Verdict::Right | Verdict::RoundedEarly(_));
    let why = Text::new("the number is right, but it is in {unit}, not {wanted}");
    is_right.then(|| why.with("unit", read.unit.pretty()).with("wanted", answer.unit.pretty()))
}

/// The middle of an interval and half its width, as they are typed.
fn interval(typed: &str) -> Option<(&str, &str)> {
    ["±", "+/-"].into_iter().find_map(|sign| typed.split_once(sign))
}

/// The value that a cause is searched for: the middle of an interval, with its unit.
fn middle_of(typed: &str) -> String {
    let Some((middle, width)) = interval(typed) else { return typed.to_owned() };
    let is_bare = units::quantity_of(middle).is_some_and(|middle| middle.unit.text.is_empty());
    match units::quantity_of(width.trim()) {
        Some(read) if is_bare && !width.trim().ends_with('%') => {
            format!("{} {}", middle.trim(), read.unit.ascii())
        }
        _ => middle.trim().to_owned(),
    }
}

/// `middle` has its unit.
fn interval_outcome(answer: &Answer, middle: &str, width: &str, tolerance: f64) -> (Outcome, Text) {
    let unread = || (Outcome::Unread, Text::new("write an interval as in `19.4 ± 0.1 mm`"));
    let Some(computed) = answer.si() else { return unread() };
    let width = width.trim();
    let Some(read) = units::quantity_of(width) else { return unread() };
    let Ok(centre) = causes::value(answer, middle) else { return unread() };
    let half = if width.ends_with('%') { Ok(read.si * centre.abs()) } else { causes::value(answer, width) };
    let Ok(half) = half.map(f64::abs) else { return unread() };
    let holds = (centre - computed).abs() <= half * (1.0 + 1e-9);
    let most = WIDEST_INTERVAL * tolerance;
    if holds && half > most * centre.abs() {
        let why = Text::new("the interval is wider than ± {most}");
        return (Outcome::Wrong, why.with_quantity("most", most, "%"));
    }
    if holds {
        return (Outcome::Right, Text::from(""));
    }
    outcome(answer, middle, tolerance)
}
