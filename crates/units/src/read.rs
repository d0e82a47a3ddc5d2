//! Reading what a user types: a quantity, a vector, a unit, a count.

mod error;
mod expression;
mod kinds;
pub(crate) mod scan;
pub(crate) mod units;
mod value;
mod vector;

#[cfg(test)]
mod tests;

use std::ops::Range;

use crate::{Dim, Kind, Quantity, Unit, UnitMeaning};
use scan::{Cursor, Literal, guard, is_product};

pub use error::{Hint, ReadError, WrongKind};
pub use kinds::meant_unit;
pub use scan::{group_mark, is_invisible, thousands, vulgar_fraction, with_comma, with_point};
pub use units::unit;
pub(crate) use value::compose;
pub use vector::read_vector;

/// The longest text of a quantity, in characters.
const LIMIT: usize = 200;

/// Reads a quantity of a given kind; `default` is the unit of a number written alone.
///
/// Numbers take `.` or `,` as the decimal mark, `e-6` or `×10⁻⁶`, and arithmetic with `+ - * / ^ ( )`, `pi` and `sqrt`; the
/// angle of an angular velocity drops out of a product such as m e ω². A text has no language: `1,250`, which is 1250 in one
/// and 1.25 in another, is refused with both readings; where the language is known, [`with_point`](crate::with_point) goes
/// before. Products and quotients of units are as in [`unit()`]. A missing angle is accepted (N·m/rad for N·m, 1/s for
/// rad/s); for [`Kind::Other`] and [`Kind::Amplitude`] the dimension is that of `default`.
///
/// # Errors
/// Says what cannot be read and what to write; another kind of quantity than the one asked for is
/// refused, with what was probably meant.
///
/// ```
/// use dalembert_units::{Kind, read_quantity, unit};
/// let rpm = unit("rpm")?;
/// let speed = read_quantity("2*pi*50 rad/s", &rpm, Kind::AngularVelocity)?;
/// assert_eq!(speed.si, std::f64::consts::TAU * 50.0);
/// let speed = read_quantity("1000", &rpm, Kind::AngularVelocity)?;
/// assert!((speed.si - 104.719755).abs() < 1e-6);
/// # Ok::<(), dalembert_units::ReadError>(())
/// ```
pub fn read_quantity(text: &str, default: &Unit, kind: Kind) -> Result<Quantity, ReadError> {
    let range = guard(text, LIMIT)?;
    if range.is_empty() {
        return Err(empty(default));
    }
    kinds::refuse_feet(text, range.clone(), default, kind)?;
    let reading = read(text, range.clone(), default)?;
    kinds::check(&reading, text, range.clone(), default, kind)?;
    let quantity = finish(&reading, default, &text[range.clone()], range)?;
    // Units of several quantities would make a product such as kg·mm³/m³.
    let usual = reading.combined.is_none() || kind.units().contains(&&*quantity.unit.text);
    let field = if default.sense == UnitMeaning::Level { &Unit::ONE } else { default };
    Ok(if usual { quantity } else { Quantity { unit: field.clone(), ..quantity } })
}

/// Reads a quantity of any dimension; a number alone is a pure number.
///
/// # Errors
/// Says what cannot be read and what to write.
pub fn read_any(text: &str) -> Result<Quantity, ReadError> {
    let range = guard(text, LIMIT)?;
    if range.is_empty() {
        return Err(empty(&Unit::ONE));
    }
    finish(&read(text, range.clone(), &Unit::ONE)?, &Unit::ONE, &text[range.clone()], range)
}

/// The quantity of any dimension that a text is; `None` where it is something else. What an unknown unit may have been meant
/// as, which takes much longer to find than the rest, is not sought.
pub fn quantity_of(text: &str) -> Option<Quantity> {
    let range = guard(text, LIMIT).ok().filter(|range| !range.is_empty())?;
    let reading = read_as_written(text, range.clone(), &Unit::ONE).ok()?;
    finish(&reading, &Unit::ONE, &text[range.clone()], range).ok()
}

/// Reads a whole number, zero or more, of at most 19 digits.
///
/// # Errors
/// Anything but digits.
pub fn read_count(text: &str) -> Result<u64, ReadError> {
    let range = guard(text, LIMIT)?;
    let digits = &text[range.clone()];
    if digits.is_empty() {
        return Err(ReadError::Empty { example: "4".into() });
    }
    // `parse` alone would take a sign.
    let count = if digits.bytes().all(|byte| byte.is_ascii_digit()) { digits.parse().ok() } else { None };
    count.ok_or_else(|| ReadError::NotACount { text: digits.into(), span: range })
}

/// Result of reading a text: a number, and a unit if one was written.
struct QuantityReader<'t> {
    amount: Amount<'t>,
    unit: Option<Unit>,
    /// π was written.
    pi: bool,
    /// Several quantities with units were multiplied or divided: the exponent of the angle that angular velocities among
    /// them brought.
    combined: Option<i8>,
}

#[derive(Clone, Copy)]
enum Amount<'t> {
    Literal(Literal<'t>),
    Computed(f64),
}

/// A reading, with what was probably meant where there is none.
fn read<'t>(text: &'t str, range: Range<usize>, default: &Unit) -> Result<QuantityReader<'t>, ReadError> {
    read_as_written(text, range.clone(), default).map_err(|error| {
        let (part, _) = units::split_suffix(text, range);
        let cursor = Cursor::new(text, part);
        error.suggesting(default.dim, |span, meant| has_dim(cursor, span, meant, default))
    })
}

/// Most texts are a literal and a unit; what is not goes to the arithmetic, which reads those too and
/// has the errors.
fn read_as_written<'t>(
    text: &'t str,
    range: Range<usize>,
    default: &Unit,
) -> Result<QuantityReader<'t>, ReadError> {
    let (range, suffix) = units::split_suffix(text, range);
    let cursor = Cursor::new(text, range.clone());
    let mut reading = match literal_and_unit(cursor) {
        Some(reading) => reading,
        None if is_date(&text[range.clone()]) => {
            return Err(expression::not_a_number(&text[range.clone()], range));
        }
        None => expression::evaluate(cursor)?,
    };
    if suffix != UnitMeaning::Plain {
        let unit = match reading.unit {
            Some(unit) => unit,
            // `3 rms` in a field of `mm pp` is 3 mm rms.
            None => unit(&default.text[units::split_suffix(&default.text, 0..default.text.len()).0])?,
        };
        reading.unit = Some(units::with_suffix(unit, suffix)?);
    }
    Ok(reading)
}

/// Returns true if the text has the dimension of a field once a part of it is replaced.
fn has_dim(cursor: Cursor, span: &Range<usize>, meant: &str, default: &Unit) -> bool {
    let text =
        format!("{}{meant}{}", &cursor.text[cursor.at..span.start], &cursor.text[span.end..cursor.end]);
    let found = expression::evaluate(Cursor::new(&text, 0..text.len()));
    default.dim != Dim::NONE
        && found.is_ok_and(|found| found.unit.is_some_and(|unit| unit.dim.agrees(default.dim)))
}

/// Returns true for a date such as 1970-01-01, which is no difference of three numbers.
fn is_date(text: &str) -> bool {
    let mut parts = text.split('-');
    let mut digits = |count| {
        parts.next().is_some_and(|part| part.len() == count && part.bytes().all(|b| b.is_ascii_digit()))
    };
    digits(4) && digits(2) && digits(2) && parts.next().is_none()
}

fn literal_and_unit(mut cursor: Cursor<'_>) -> Option<QuantityReader<'_>> {
    let negative = cursor.accept('-') || cursor.accept('−');
    let mut literal = cursor.literal().ok()?;
    literal.negative = negative;
    if let Some(ten) = power_of_ten(&mut cursor) {
        literal = literal.shifted(ten);
    }
    cursor.skip_space();
    let amount = Amount::Literal(literal);
    if cursor.rest().is_empty() {
        return Some(QuantityReader { amount, unit: None, pi: false, combined: None });
    }
    let unit = units::whole(&mut cursor).ok()?;
    // `5 1` is no number and its unit.
    let complete = cursor.rest().is_empty() && !unit.text.is_empty();
    complete.then_some(QuantityReader { amount, unit: Some(unit), pi: false, combined: None })
}

/// The `×10⁻⁶` of `1.3×10⁻⁶`.
fn power_of_ten(cursor: &mut Cursor) -> Option<i32> {
    let mut ahead = *cursor;
    ahead.skip_space();
    if !ahead.peek().is_some_and(|c| is_product(c) || matches!(c, 'x' | 'X')) {
        return None;
    }
    ahead.advance();
    ahead.skip_space();
    ahead.at += ahead.rest().strip_prefix("10").map(|_| 2)?;
    let ten = if ahead.accept_caret() { ahead.signed_digits() } else { ahead.superscript_digits() }?;
    let ended =
        !ahead.peek().is_some_and(|c| matches!(c, '^' | '.' | ',') || scan::superscript_digit(c).is_some());
    *cursor = ahead;
    ended.then_some(ten)
}

fn finish(
    reading: &QuantityReader,
    default: &Unit,
    text: &str,
    span: Range<usize>,
) -> Result<Quantity, ReadError> {
    let unit = reading.unit.as_ref().unwrap_or(default);
    let (si, last_place) = si(reading.amount, unit);
    check_range(reading.amount, si, text, span)?;
    Ok(Quantity { si, unit: unit.clone(), last_place })
}

/// The SI value, and one unit in its last written place.
fn si(amount: Amount, unit: &Unit) -> (f64, f64) {
    match amount {
        Amount::Literal(literal) if unit.sense == UnitMeaning::Level => {
            let ratio = unit.si(literal.value(1.0, 0));
            (ratio, ratio * std::f64::consts::LN_10 / 20.0 * literal.last_place(1.0, 0))
        }
        Amount::Literal(literal) => {
            (literal.value(unit.mantissa, unit.ten), literal.last_place(unit.mantissa, unit.ten))
        }
        Amount::Computed(number) if unit.sense == UnitMeaning::Level => (unit.si(number), 0.0),
        Amount::Computed(number) => (crate::decimal::shift(number * unit.mantissa, unit.ten.into()), 0.0),
    }
}

/// Every number that enters is finite, and none is lost below the smallest.
fn check_range(amount: Amount, si: f64, text: &str, span: Range<usize>) -> Result<(), ReadError> {
    let zero = match amount {
        Amount::Literal(literal) => literal.is_zero(),
        Amount::Computed(number) => number == 0.0,
    };
    if si.is_finite() && (si != 0.0 || zero) {
        return Ok(());
    }
    Err(ReadError::OutOfRange { text: text.into(), large: si != 0.0, span })
}

fn empty(default: &Unit) -> ReadError {
    ReadError::Empty { example: example("20.3", default) }
}

/// Text of a quantity in the unit of its field.
fn example(number: &str, default: &Unit) -> String {
    format!("{number} {}", default.ascii()).trim_end().to_owned()
}
