//! Ranges that the data of variants are drawn from.
//!
//! An author declares them under `[vary]` of a case or a problem file, by the paths of inputs:
//!
//! | text | values |
//! |---|---|
//! | `30 kg .. 60 kg : 5 kg` | 30 kg, 35 kg, …, 60 kg |
//! | `30 .. 60 kg` | from 30 kg to 60 kg, of two or three significant digits |
//! | `30 kg; 45 kg; 60 kg` | these |
//!
//! Without that every number varies by ± 30 %, rounded to as many significant digits as it was written with, two or three.
//! What is a constant of the problem rather than a datum stays: gravity, moduli of elasticity, Poisson's ratio and
//! densities, angles that are multiples of 15°, whole pure numbers, zero, defaults, and inputs with tolerances. Equal
//! numbers of the rows of a list stay equal.

use std::collections::BTreeMap;

use dalembert_core::{
    Draft, FieldError, Measure, Record, Shape, Text, gravity, nearest, split_tolerance,
    vary::{self, VariedInput},
};
use dalembert_units::{self as units, Kind, Style, Unit};

use crate::Exercise;

/// Share by which a number varies to either side where no range is declared.
const SHARE: f64 = 0.3;
/// The most values of a range.
const MOST_VALUES: usize = 10_000;
/// Style of the texts of inputs.
const TYPED: Style = Style { digits: 12, decimal: units::Decimal::Point, ascii: true };

/// An input that varies, or several rows of a list that are equal.
#[derive(Clone, Debug)]
pub struct Range {
    /// Paths of the inputs.
    pub paths: Vec<String>,
    /// Label of the input.
    pub label: Text,
    /// Symbol in formulas; may be empty.
    pub symbol: &'static str,
    /// Value in the problem itself, in SI.
    pub before: f64,
    /// Values: the text of each, and its number in SI.
    pub values: Vec<(String, f64)>,
    /// Unit of the values.
    pub unit: Unit,
}

/// Value of an input of a variant.
#[derive(Clone, Debug, PartialEq)]
pub struct Datum {
    /// Paths of the inputs.
    pub paths: Vec<String>,
    /// Label of the input.
    pub label: Text,
    /// Symbol in formulas; may be empty.
    pub symbol: &'static str,
    /// Value in the problem itself, in SI.
    pub before: f64,
    /// Value, in SI.
    pub si: f64,
    /// Text of the value.
    pub typed: String,
    /// Unit of the value.
    pub unit: Unit,
}

impl Range {
    /// The datum with the value of a place.
    pub(crate) fn datum(&self, at: usize) -> Datum {
        let (typed, si) = self.values[at].clone();
        Datum {
            paths: self.paths.clone(),
            label: self.label.clone(),
            symbol: self.symbol,
            before: self.before,
            si,
            typed,
            unit: self.unit.clone(),
        }
    }
}

/// Ranges of an exercise: those that its author declared, else the usual ones.
///
/// # Errors
/// Every range that cannot be read, by its input.
pub fn ranges(exercise: &Exercise) -> Result<Vec<Range>, Vec<FieldError>> {
    let inputs = vary::inputs(&exercise.record);
    let declared = &exercise.statement.vary;
    if declared.is_empty() {
        return Ok(usual(exercise, &inputs));
    }
    let (mut found, mut errors) = (Vec::new(), Vec::new());
    for (path, text) in declared {
        let read = match inputs.iter().find(|input| input.path == *path) {
            Some(input) => {
                declared_values(input, text).map(|(values, unit)| Range { unit, ..range(input, values) })
            }
            None => Err(unknown(path, &inputs)),
        };
        match read {
            Ok(range) => found.push(range),
            Err(why) => errors.push(FieldError::new(path.as_str(), why)),
        }
    }
    if errors.is_empty() { Ok(found) } else { Err(errors) }
}

fn unknown(path: &str, inputs: &[VariedInput]) -> Text {
    match nearest(path, inputs.iter().map(|input| input.path.as_str())) {
        Some(near) => Text::new("no input `{path}` is a number; did you mean `{near}`?")
            .with("path", path)
            .with("near", near),
        None => Text::new("no input `{path}` is a number; write one of {known}")
            .with("path", path)
            .with("known", inputs.iter().map(|input| input.path.clone()).collect::<Vec<_>>().join(", ")),
    }
}

fn range(input: &VariedInput, values: Vec<(String, f64)>) -> Range {
    Range {
        paths: vec![input.path.clone()],
        label: input.label.clone(),
        symbol: input.symbol,
        before: input.si,
        values,
        unit: input.unit.clone(),
    }
}

/// Values of a declared range, and their unit.
fn declared_values(input: &VariedInput, text: &str) -> Result<(Vec<(String, f64)>, Unit), Text> {
    const FORM: &str = "write a range as in `30 kg .. 60 kg : 5 kg`, or values as in `30 kg; 45 kg`";
    let kind = input.measure.kind();
    let read = |text: &str, unit: &Unit| {
        units::read_quantity(text, unit, kind).map_err(|why| Text::verbatim(why.to_string()))
    };
    let (values, unit) = if let Some((from, rest)) = text.split_once("..") {
        let (to, step) = match rest.split_once(':') {
            Some((to, step)) => (to, Some(step)),
            None => (rest, None),
        };
        let to = read(to, &input.unit)?;
        let unit = to.unit.clone();
        let [from, to] = [unit.value(read(from, &unit)?.si), unit.value(to.si)];
        let numbers = match step {
            Some(step) => {
                let step = unit.value(read(step, &unit)?.si);
                let count = ((to - from) / step + 1e-9).floor();
                if !(step > 0.0 && count >= 1.0 && count < MOST_VALUES as f64) {
                    return Err(Text::new(
                        "the step {step} does not lead from {from} to {to} in 1 to 10000 steps",
                    )
                    .with("step", units::write_number(step, TYPED))
                    .with("from", units::write_number(from, TYPED))
                    .with("to", units::write_number(to, TYPED)));
                }
                (0..=count as usize).map(|n| from + n as f64 * step).collect()
            }
            None if 0.0 < from && from < to => rounded_between(from, to, digits_of(from).max(digits_of(to))),
            None => return Err(FORM.into()),
        };
        (numbers, unit)
    } else {
        let read: Vec<_> = text.split(';').map(|one| read(one, &input.unit)).collect::<Result<_, _>>()?;
        let Some(first) = read.first() else { return Err(FORM.into()) };
        let unit = first.unit.clone();
        (read.iter().map(|one| unit.value(one.si)).collect(), unit)
    };
    let values = permitted(input, values, &unit);
    if values.is_empty() {
        return Err(Text::new("no value of the range {text} is permitted for this input").with("text", text));
    }
    Ok((values, unit))
}

/// Numbers of a unit as texts with their values, as far as the input may take them.
fn permitted(input: &VariedInput, numbers: Vec<f64>, unit: &Unit) -> Vec<(String, f64)> {
    let written = |number: f64| {
        let text = format!("{} {}", units::write_number(number, TYPED), unit.ascii()).trim_end().to_owned();
        let si = units::read_quantity(&text, unit, input.measure.kind()).ok()?.si;
        input.permits(si).then_some((text, si))
    };
    numbers.into_iter().filter_map(written).take(MOST_VALUES).collect()
}

fn usual(exercise: &Exercise, inputs: &[VariedInput]) -> Vec<Range> {
    let shape = exercise.entry.shape();
    let fixed = fixed_leaves(&exercise.record, &exercise.draft, &shape);
    // Equal rows of a list, by their paths without rows.
    let mut groups: BTreeMap<(String, u64), usize> = BTreeMap::new();
    let mut found: Vec<Range> = Vec::new();
    for input in inputs {
        let is_within_fixed = fixed.iter().any(|path| dalembert_core::is_within(&input.path, path));
        if is_within_fixed || is_constant(input) {
            continue;
        }
        let key = (without_rows(&input.path), input.si.to_bits());
        if let Some(known) = groups.get(&key) {
            found[*known].paths.push(input.path.clone());
            continue;
        }
        let number = input.unit.value(input.si);
        let numbers =
            rounded_between((1.0 - SHARE) * number.abs(), (1.0 + SHARE) * number.abs(), digits_of(number));
        let numbers = numbers.into_iter().map(|size| size.copysign(number)).collect();
        let values = permitted(input, numbers, &input.unit);
        if values.len() > 1 {
            groups.insert(key, found.len());
            found.push(range(input, values));
        }
    }
    found
}

/// A path without the numbers of its rows.
fn without_rows(path: &str) -> String {
    let mut parts = path.split('[');
    let first = parts.next().unwrap_or_default().to_owned();
    parts.fold(first, |path, part| path + "[" + part.split_once(']').map_or(part, |(_, rest)| rest))
}

/// Inputs that keep their values whatever they are: defaults, gravity, and those with a tolerance.
fn fixed_leaves(record: &Record, draft: &Draft, shape: &Shape) -> Vec<String> {
    let mut fixed = Vec::new();
    record.leaves(&mut |path, field, _| {
        let text = match draft.at(shape, path) {
            Ok((Draft::Leaf(text), _)) => text.trim(),
            _ => "",
        };
        let is_default = field.default.is_some_and(|default| text.is_empty() || text == default.trim());
        let has_tolerance = split_tolerance(text).1.is_some();
        if is_default || has_tolerance || gravity::is_gravity(field) {
            fixed.push(path.to_owned());
        }
    });
    fixed
}

/// Returns true for a constant of nature, of a material or of the arrangement.
fn is_constant(input: &VariedInput) -> bool {
    let Measure { unit, .. } = input.measure;
    let kind = input.measure.kind();
    let is_multiple = |of: f64| {
        let ratio = input.si / of;
        (ratio - ratio.round()).abs() <= 1e-9 * ratio.abs().max(1.0)
    };
    input.si == 0.0
        || match kind {
            Kind::Acceleration => (9.5..10.2).contains(&input.si.abs()),
            Kind::Stress => input.symbol.starts_with(['E', 'G']),
            Kind::Density => true,
            Kind::Angle => is_multiple(15f64.to_radians()),
            Kind::Ratio => input.symbol.starts_with('ν') || (unit != "%" && is_multiple(1.0)),
            _ => false,
        }
}

/// Significant digits that variants of a number have: as many as it has, two or three.
fn digits_of(number: f64) -> usize {
    let text = units::write_number(number.abs(), Style { digits: 6, ..TYPED });
    let mantissa = text.split(['e', '*']).next().unwrap_or_default();
    let digits: String = mantissa.chars().filter(char::is_ascii_digit).collect();
    let digits = digits.trim_start_matches('0');
    // The noughts of 1000 are no digits.
    digits.trim_end_matches('0').len().clamp(2, 3)
}

/// Numbers of so many significant digits between two positive ones.
fn rounded_between(from: f64, to: f64, digits: usize) -> Vec<f64> {
    let bound = 10i64.pow(digits as u32);
    let mut ten = from.log10().floor() as i32 + 1 - digits as i32;
    let mut mantissa = (from / 10f64.powi(ten) - 1e-9).ceil() as i64;
    let mut found = Vec::new();
    while found.len() < MOST_VALUES {
        if mantissa >= bound {
            (mantissa, ten) = (mantissa / 10, ten + 1);
        }
        let number: f64 = format!("{mantissa}e{ten}").parse().unwrap_or(f64::INFINITY);
        if number > to * (1.0 + 1e-12) {
            break;
        }
        found.push(number);
        mantissa += 1;
    }
    found
}

/// Writes the data into the texts of inputs, and into definitions of these names.
pub(crate) fn with_data(draft: &Draft, shape: &Shape, data: &[Datum]) -> Result<Draft, FieldError> {
    let mut draft = draft.clone();
    for datum in data {
        for path in &datum.paths {
            match definition(&draft, shape, path) {
                Some(formula) => draft.set(shape, &formula, &datum.typed)?,
                None => draft.set(shape, path, &datum.typed)?,
            }
        }
    }
    Ok(draft)
}

/// Path of the formula of the definition of that name.
fn definition(draft: &Draft, shape: &Shape, name: &str) -> Option<String> {
    let Ok((Draft::Rows(rows), _)) = draft.at(shape, "let") else { return None };
    (1..=rows.len()).find_map(|row| match draft.at(shape, &format!("let[{row}].name")) {
        Ok((Draft::Leaf(known), _)) if known.trim() == name => Some(format!("let[{row}].formula")),
        _ => None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_as_round_as_the_original() {
        assert_eq!([40.0, 1000.0, 0.1, 451.389, 20.3, 1.3e-6].map(digits_of), [2, 2, 2, 3, 3, 2]);
        let forty = rounded_between(28.0, 52.0, 2);
        assert_eq!((forty.len(), forty[0], forty[24]), (25, 28.0, 52.0));
        let thousand = rounded_between(700.0, 1300.0, 2);
        assert_eq!(thousand[..3], [700.0, 710.0, 720.0]);
        assert_eq!(thousand[29..], [990.0, 1000.0, 1100.0, 1200.0, 1300.0]);
        assert_eq!(rounded_between(0.07, 0.075, 2), [0.07, 0.071, 0.072, 0.073, 0.074, 0.075]);
    }

    #[test]
    fn rows_leave_a_path() {
        assert_eq!(without_rows("masses[12].radius"), "masses[.radius");
        assert_eq!(without_rows("a[1][2]"), without_rows("a[3][4]"));
        assert_ne!(without_rows("a[1].b"), without_rows("a[1].c"));
    }
}
