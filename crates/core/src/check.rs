//! A user's answer beside ours: right, near, or wrong, and then which mistake gives it.
//!
//! [`compare`] is quick and says how near an answer is. [`causes`] computes what the mistakes that people make would
//! give: edits of the worked solution, other data, other options; and says which of them, or which two together, give
//! exactly what was answered. The number of candidates and of digits bounds what is named: a cause is only possible
//! where a number without a cause would meet one of the candidates that are as likely in more than 2 % of all cases.

mod candidates;
mod common;
mod digits;
mod inputs;
mod mistake;
mod pairs;
mod problem;
mod products;
mod ranking;
mod search;
mod slip;
mod steps;
mod tries;
mod ways;
mod weight;
mod words;
mod wrong;

use std::f64::consts::TAU;

use dalembert_units::{self as units, Dim, Kind, Quantity, ReadError};

pub use self::{
    common::{common_errors, declared_errors},
    mistake::{Cause, Change, Mistake, Place},
    search::{Causes, causes},
};
use crate::{Answer, AnswerValue, Arg, Solution, Text, cases, reading};

/// Answers that are farther off than this share of ours are not right, however few their digits.
pub const TOLERANCE: f64 = 0.005;

/// Result of comparing a user's answer with the computed one.
#[derive(Clone, Debug, PartialEq)]
pub enum Verdict {
    /// It is ours to every digit that was given.
    Right,
    /// It is within [`TOLERANCE`], but its last digits are not ours: something was rounded on the way.
    RoundedEarly(f64),
    /// It fits ours, but with so few digits it fits much else as well.
    TooFewDigits,
    /// It is another number.
    Wrong,
    /// It cannot be read, and why.
    Unread(Text),
}

/// Compares a typed answer with ours. A number alone is in the unit that ours is shown in.
pub fn compare(answer: &Answer, typed: &str) -> Verdict {
    let Some(computed) = answer.si() else {
        let typed = &in_signs(typed);
        return match cases::agrees(answer, typed) {
            Some(true) => Verdict::Right,
            Some(false) => Verdict::Wrong,
            None => Verdict::Unread(Text::new("write it as in `{example}`").with("example", example(answer))),
        };
    };
    let typed = match read(answer, typed) {
        Ok(typed) => typed,
        Err(why) => return Verdict::Unread(why),
    };
    let computed = if computed.abs() <= answer.noise { 0.0 } else { computed };
    let off = difference(typed.si, computed, answer.dim());
    let size = computed.abs();
    let to_the_digits = off <= half_a_place(&typed) + 1e-12 * size;
    match (to_the_digits, off <= TOLERANCE * size) {
        (true, true) => Verdict::Right,
        (false, true) => Verdict::RoundedEarly(off / size),
        (true, false) if size > 0.0 && typed.si != 0.0 => Verdict::TooFewDigits,
        _ => Verdict::Wrong,
    }
}

/// A set as it is typed on a keyboard, with the signs that it is printed with, and without the symbol or name of the
/// quantity: `>= 440 mm`, `d >= 440 mm`, `440 mm <= d`, `2 m <= d <= 3 m`.
fn in_signs(typed: &str) -> String {
    let typed = typed.replace(">=", "≥").replace("<=", "≤").replace('>', "≥").replace('<', "≤");
    typed.split(" or ").map(part_in_signs).collect::<Vec<_>>().join(" or ")
}

/// An interval of a set in signs.
fn part_in_signs(part: &str) -> String {
    let is_name = |text: &str| text.chars().next().is_some_and(char::is_alphabetic);
    let sign = if part.contains('≤') { '≤' } else { '≥' };
    let ends: Vec<&str> = part.split(sign).map(str::trim).collect();
    match (&ends[..], sign) {
        ([name, end], _) if is_name(name) => format!("{sign} {end}"),
        ([end, name], '≤') if is_name(name) => format!("≥ {end}"),
        ([end, name], _) if is_name(name) => format!("≤ {end}"),
        ([from, name, to], '≤') if is_name(name) => format!("{from} … {to}"),
        ([to, name, from], _) if is_name(name) => format!("{from} … {to}"),
        _ => part.to_owned(),
    }
}

/// The user's answers beside the problem's: each with its verdict.
pub fn compare_all(solution: &Solution, typed: &[(String, String)]) -> Vec<(String, Verdict)> {
    let compared = typed.iter().filter(|(_, text)| !text.trim().is_empty()).filter_map(|(name, text)| {
        let answer = solution.answer(name)?;
        Some((name.clone(), compare(answer, text)))
    });
    compared.collect()
}

/// The value of an answer as it is typed, in SI; a number alone is in the unit that ours is shown in.
///
/// # Errors
/// Why it cannot be read.
pub fn value(answer: &Answer, typed: &str) -> Result<f64, Text> {
    read(answer, typed).map(|read| read.si)
}

/// Reads a typed answer; a number alone is in the unit that ours is shown in.
fn read(answer: &Answer, typed: &str) -> Result<Quantity, Text> {
    let quantity = |text: &str| {
        let mut read = units::read_quantity(text, &answer.unit, Kind::of(&answer.unit))?;
        read.last_place *= ambiguous_zeros(text);
        Ok(read)
    };
    let read = quantity(typed).or_else(|error| {
        let read = readings(&error, typed).iter().filter_map(|text| quantity(text).ok()).collect();
        nearest_to(answer, read).ok_or_else(|| reading::text(&error))
    })?;
    if read.si.is_finite() { Ok(read) } else { Err(Text::new("not a finite number")) }
}

/// A typed number in both of its readings, where its mark separates thousands or decimals as the country has it: `5,397 mm`.
fn readings(error: &ReadError, typed: &str) -> Vec<String> {
    let (ReadError::TwoMarks { readings, span, .. } | ReadError::Ambiguous { readings, span, .. }) = error
    else {
        return Vec::new();
    };
    let is_number = |text: &String| text.chars().all(|c| c.is_ascii_digit() || c == '.');
    let readings = readings.iter().filter(|reading| is_number(reading));
    readings.map(|reading| format!("{}{reading}{}", &typed[..span.start], &typed[span.end..])).collect()
}

/// The reading whose order of magnitude is that of ours: what was worked out settles what the mark says.
fn nearest_to(answer: &Answer, readings: Vec<Quantity>) -> Option<Quantity> {
    let orders = |read: &Quantity| (read.si / answer.si().unwrap_or(1.0)).abs().ln().abs();
    readings.into_iter().min_by(|one, other| orders(one).total_cmp(&orders(other)))
}

/// Zeros at the end of a whole number may be digits or may stand for them: what one unit of the last sure digit is.
fn ambiguous_zeros(typed: &str) -> f64 {
    let number = typed.trim().trim_start_matches(['-', '−', '+']);
    let end = number.find(|c: char| !c.is_ascii_digit()).unwrap_or(number.len());
    let (digits, rest) = number.split_at(end);
    let sure = digits.trim_end_matches('0');
    // `20` is two digits; of `22270` the last may be none.
    if sure.len() < 2 || rest.starts_with(['.', ',', 'e', 'E', '*', '×', '/', '^']) {
        return 1.0;
    }
    10f64.powi(i32::try_from(digits.len() - sure.len()).unwrap_or(0))
}

/// Half a unit in the last place that was given; an expression is taken to four digits.
fn half_a_place(typed: &Quantity) -> f64 {
    if typed.last_place > 0.0 { 0.5 * typed.last_place * (1.0 + 1e-9) } else { 0.5e-4 * typed.si.abs() }
}

/// Absolute difference of two numbers; directions are compared modulo one revolution.
fn difference(a: f64, b: f64, dim: Dim) -> f64 {
    let off = (a - b).abs();
    if dim != Dim::ANGLE {
        return off;
    }
    let off = off.rem_euclid(TAU);
    off.min(TAU - off)
}

/// Something that can be typed for an answer that is no single number, and gives nothing away: `(1; 2; 3) N·mm`.
pub fn example(answer: &Answer) -> String {
    let numbers = match &answer.value {
        AnswerValue::Set(..) => "≤ 1",
        AnswerValue::Number(..) => "(1; 2; 3)",
        AnswerValue::List(_) => "(1; 2; …)",
    };
    format!("{numbers} {}", answer.unit.pretty()).trim().to_owned()
}

impl Verdict {
    /// Message for the user.
    pub fn text(&self) -> Text {
        match self {
            Verdict::Right => Text::new("correct"),
            Verdict::RoundedEarly(off) => Text {
                template: "{off} off: rounding, or a small term missing or with the wrong sign".into(),
                args: vec![("off", Arg::Quantity(*off, "%"))],
            },
            Verdict::TooFewDigits => Text::new("agrees to the digits given; enter more digits to confirm"),
            Verdict::Wrong => Text::new("incorrect"),
            Verdict::Unread(why) => why.clone(),
        }
    }
}
