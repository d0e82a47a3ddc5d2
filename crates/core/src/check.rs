//! A user's answer beside ours: right, rounded too early, or wrong, and then which usual slip gives it.
//!
//! [`compare`] is quick and says how near an answer is. [`slips`] solves the problem again with the slips that people
//! make and says which of them gives exactly what was answered.

mod candidates;
mod common;
mod search;
mod wrong;

use std::f64::consts::TAU;

use dalembert_units::{self as units, Dim, Kind, Quantity};

pub use self::{common::common_errors, search::slips};
use crate::{Answer, AnswerValue, Arg, Solution, Symbol, Text, cases, printer, reading};

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

/// Probable cause of a wrong answer.
#[derive(Clone, Debug, PartialEq)]
pub enum Mistake {
    /// It follows from the user's own answers of these names, which are wrong.
    Follows(Vec<String>),
    /// Our answer was changed at the end.
    Answer(NumberChange),
    /// It is the answer to another question, of this name.
    Other(String),
    /// An input, by its path and label, was taken otherwise.
    Input(String, Text, NumberChange),
    /// Two inputs were interchanged.
    Interchanged(Box<[(String, Text); 2]>),
    /// A step of the worked solution, by its place and symbol, came out otherwise.
    Step(usize, Symbol, NumberChange),
}

/// Change of a number by a common mistake.
#[derive(Clone, Debug, PartialEq)]
pub enum NumberChange {
    /// The other sign.
    Sign,
    /// So many times as large; as it is written.
    Times(f64, &'static str),
    /// The number was taken in another unit than it is in.
    Unit {
        /// The unit it is in.
        is: String,
        /// The unit it was taken in.
        taken: String,
    },
    /// Twice or half of a length: its diameter for its radius, or the other way round.
    Diameter,
    /// Another acceleration of gravity, in m/s².
    Gravity(f64),
    /// Left out: zero.
    LeftOut,
    /// Square in place of the number.
    Squared,
    /// Square root in place of the number.
    Rooted,
    /// One divided by it.
    Inverted,
    /// An angle from another axis or in the other direction, in degrees: this minus it.
    Complement(u16),
    /// The sign of one of the terms inside.
    TermSign,
    /// One of the terms inside is missing.
    TermLeftOut,
    /// An inner power was omitted.
    PowerLeftOut,
    /// An inner root was omitted.
    RootLeftOut,
    /// Sine and cosine.
    SineForCosine,
    /// One number was divided by where it should multiply, or the other way round.
    DividedForMultiplied,
}

/// Compares a typed answer with ours. A number alone is in the unit that ours is shown in.
pub fn compare(answer: &Answer, typed: &str) -> Verdict {
    let Some(computed) = answer.si() else {
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
    let read = units::read_quantity(typed, &answer.unit, Kind::of(&answer.unit));
    let mut read = read.map_err(|error| reading::text(&error))?;
    read.last_place *= ambiguous_zeros(typed);
    if read.si.is_finite() { Ok(read) } else { Err(Text::new("not a finite number")) }
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

impl Mistake {
    /// Description of the probable mistake, without revealing the computed number.
    pub fn text(&self, solution: &Solution) -> Text {
        let label = |name: &str| match solution.answer(name) {
            Some(answer) => answer.title(),
            None => Text::new(name.to_owned()),
        };
        match self {
            Mistake::Follows(names) => {
                let all = names.iter().map(|name| label(name)).reduce(|all, next| {
                    Text::new("{all}, {next}").with_text("all", all).with_text("next", next)
                });
                Text::new("consistent with your earlier answer to {answers} (error carried forward)")
                    .with_text("answers", all.unwrap_or_else(|| Text::from("")))
            }
            Mistake::Other(name) => {
                Text::new("this is the value of another answer: {answer}").with_text("answer", label(name))
            }
            Mistake::Answer(change) => of_answer(change),
            Mistake::Input(_, input, change) => Text::new("{input}: {change}")
                .with_text("input", input.clone())
                .with_text("change", of_input(change)),
            Mistake::Interchanged(pair) => {
                let [(_, first), (_, second)] = &**pair;
                Text::new("{first} and {second} interchanged")
                    .with_text("first", first.clone())
                    .with_text("second", second.clone())
            }
            Mistake::Step(_, symbol, change) => Text::new("computing {symbol}: {change}")
                .with("symbol", printer::symbol(symbol))
                .with_text("change", of_step(change)),
        }
    }
}

fn of_answer(change: &NumberChange) -> Text {
    match change {
        NumberChange::Sign => Text::new("sign error"),
        NumberChange::Unit { taken, is } => {
            Text::new("the number is in {taken}, not {is}").with("taken", taken).with("is", is)
        }
        NumberChange::Squared => Text::new("squared value: a square root was omitted"),
        NumberChange::Rooted => Text::new("square root of the value: a square was omitted"),
        NumberChange::Inverted => Text::new("reciprocal of the answer"),
        NumberChange::Complement(_) => Text::new("angle measured from another axis or in the opposite sense"),
        other => times(other),
    }
}

fn of_input(change: &NumberChange) -> Text {
    match change {
        NumberChange::Sign => Text::new("sign error"),
        NumberChange::Unit { taken, is } => {
            Text::new("{is} used as {taken}").with("is", is).with("taken", taken)
        }
        NumberChange::Diameter => Text::new("diameter and radius (or a whole and its half) confused"),
        NumberChange::Gravity(si) => Text::new("{gravity} used").with_quantity("gravity", *si, "m/s^2"),
        NumberChange::LeftOut => Text::new("omitted"),
        NumberChange::Complement(_) => Text::new("measured from another axis or in the opposite sense"),
        other => times(other),
    }
}

fn of_step(change: &NumberChange) -> Text {
    match change {
        NumberChange::Sign => Text::new("sign error"),
        NumberChange::TermSign => Text::new("sign error in a term"),
        NumberChange::TermLeftOut => Text::new("a term omitted"),
        NumberChange::PowerLeftOut => Text::new("an exponent omitted"),
        NumberChange::RootLeftOut => Text::new("a square root omitted"),
        NumberChange::SineForCosine => Text::new("sine and cosine interchanged"),
        NumberChange::DividedForMultiplied => Text::new("division and multiplication interchanged"),
        other => times(other),
    }
}

fn times(change: &NumberChange) -> Text {
    match change {
        NumberChange::Times(factor, written) if factor.abs() > 1.0 => {
            Text::new("{factor} times too large").with("factor", written)
        }
        NumberChange::Times(_, written) => Text::new("{factor} times too small").with("factor", written),
        _ => Text::new("different interpretation"),
    }
}

impl Verdict {
    /// Message for the user.
    pub fn text(&self) -> Text {
        match self {
            Verdict::Right => Text::new("correct"),
            Verdict::RoundedEarly(off) => Text {
                template: "close ({off} off): rounding of an intermediate result, or a small term".into(),
                args: vec![("off", Arg::Quantity(*off, "%"))],
            },
            Verdict::TooFewDigits => Text::new("agrees to the digits given; enter more digits to confirm"),
            Verdict::Wrong => Text::new("incorrect"),
            Verdict::Unread(why) => why.clone(),
        }
    }
}
