//! Reading vectors: `(300; 200) m/s`, `300; 200; 0 m/s`, `(300 i + 200 j) m/s`.

use std::ops::Range;

use super::{Amount, QuantityReader, ReadError, check_range, empty, kinds, read, scan::guard, si, units};
use crate::{Kind, Unit, VectorQuantity};

/// The longest text of a vector, in characters.
const LIMIT: usize = 600;

/// Reads a vector of `len` components, 2 or 3, and their unit: `(300; 200) m/s`.
///
/// Components are set apart by `;`, or written along i, j and k: `(300 i + 200 j) m/s`. The unit stands after
/// the brackets, after the last component, or after each of them. Where three components are asked,
/// two are enough: the third is zero. A lone zero is the zero vector.
///
/// # Errors
/// As [`read_quantity`](crate::read_quantity) for each component, and another number of components.
pub fn read_vector(text: &str, default: &Unit, kind: Kind, len: usize) -> Result<VectorQuantity, ReadError> {
    let range = guard(text, LIMIT)?;
    if range.is_empty() {
        return Err(empty(default));
    }
    let (inner, rest) = brackets(text, range.clone()).unwrap_or((range.clone(), range.end..range.end));
    let (mut readings, written) = if let Some(parts) = components(text, inner.clone(), default)? {
        parts
    } else {
        // One component alone: the zero vector, or too little.
        let reading = read(text, range.clone(), default)?;
        if si(reading.amount, reading.unit.as_ref().unwrap_or(default)).0 != 0.0 {
            return Err(wrong_count(1, len, range));
        }
        (vec![Some(reading)], len)
    };
    if written > len || written < 2 {
        return Err(wrong_count(written, len, inner));
    }
    let unit = common_unit(&mut readings, text, rest, &range)?;
    let mut si_values = [0.0; 3];
    let mut last_place = 0.0_f64;
    for (place, reading) in si_values.iter_mut().zip(&mut readings) {
        let Some(reading) = reading else { continue };
        if reading.unit.is_none() {
            reading.unit.clone_from(&unit);
        }
        kinds::check(reading, text, range.clone(), default, kind)?;
        let (value, last) = si(reading.amount, reading.unit.as_ref().unwrap_or(default));
        check_range(reading.amount, value, &text[range.clone()], range.clone())?;
        *place = value;
        last_place = last_place.max(last);
    }
    let shown = unit.or_else(|| readings.into_iter().flatten().find_map(|reading| reading.unit));
    Ok(VectorQuantity {
        si: si_values,
        len: written,
        unit: shown.unwrap_or_else(|| default.clone()),
        last_place,
    })
}

/// The components, a missing one along i, j or k as `None`, and how many were written.
type Components<'t> = (Vec<Option<QuantityReader<'t>>>, usize);

/// Range inside the brackets that open the text, and range after them.
fn brackets(text: &str, range: Range<usize>) -> Option<(Range<usize>, Range<usize>)> {
    let part = &text[range.clone()];
    let closing = match part.chars().next()? {
        '(' => ')',
        '[' => ']',
        _ => return None,
    };
    let mut depth = 0;
    for (at, c) in part.char_indices() {
        match c {
            '(' | '[' => depth += 1,
            ')' | ']' => depth -= 1,
            _ => {}
        }
        if depth == 0 {
            let inner = range.start + 1..range.start + at;
            let vector =
                c == closing && (text[inner.clone()].contains(';') || is_along_axes(&text[inner.clone()]));
            return vector.then(|| (inner, range.start + at + 1..range.end));
        }
    }
    None
}

fn components<'t>(
    text: &'t str,
    inner: Range<usize>,
    default: &Unit,
) -> Result<Option<Components<'t>>, ReadError> {
    if text[inner.clone()].contains(';') {
        let mut readings = Vec::new();
        for part in split(text, inner, |c, _| c == ';') {
            if part.is_empty() {
                let text = text.trim().to_owned();
                return Err(ReadError::Unfinished { text, expected: "a component", span: part });
            }
            readings.push(Some(read(text, part, default)?));
            if readings.len() > 3 {
                break;
            }
        }
        let written = readings.len();
        return Ok(Some((readings, written)));
    }
    if is_along_axes(&text[inner.clone()]) {
        return along_axes(text, inner, default).map(Some);
    }
    Ok(None)
}

/// `300 i − 200 j`: each term ends in an axis.
fn along_axes<'t>(text: &'t str, inner: Range<usize>, default: &Unit) -> Result<Components<'t>, ReadError> {
    let mut readings = vec![None, None, None];
    let parts = split(text, inner, |c, before| matches!(c, '+' | '-' | '−') && !is_exponent(before));
    for (n, part) in parts.into_iter().enumerate() {
        let term = &text[part.clone()];
        let sign = text[..part.start].trim_end().ends_with(['-', '−']);
        if term.is_empty() && n == 0 {
            // A sign stands before the first term.
            continue;
        }
        let axis = term.chars().last().and_then(axis).ok_or_else(|| ReadError::Unexpected {
            found: term.into(),
            expected: "a component along i, j or k",
            span: part.clone(),
        })?;
        let number = term[..term.len() - 1].trim_end().trim_end_matches(['*', '·']).trim_end();
        let mut reading = if number.is_empty() {
            QuantityReader { amount: Amount::Computed(1.0), unit: None, pi: false }
        } else {
            read(text, part.start..part.start + number.len(), default)?
        };
        if sign {
            reading.amount = match reading.amount {
                Amount::Literal(literal) => Amount::Literal(literal.negated()),
                Amount::Computed(number) => Amount::Computed(-number),
            };
        }
        if readings[axis].is_some() {
            return Err(ReadError::Unexpected { found: term.into(), expected: "each axis once", span: part });
        }
        readings[axis] = Some(reading);
    }
    let written = if readings[2].is_some() { 3 } else { 2 };
    Ok((readings, written))
}

/// The unit that goes with every component that has none.
fn common_unit(
    readings: &mut [Option<QuantityReader>],
    text: &str,
    rest: Range<usize>,
    all: &Range<usize>,
) -> Result<Option<Unit>, ReadError> {
    let written = readings.iter().flatten().filter(|reading| reading.unit.is_some()).count();
    let count = readings.iter().flatten().count();
    let after = text[rest.clone()].trim();
    let mixed = || ReadError::MixedComponents { text: text[all.clone()].into(), span: all.clone() };
    if !after.is_empty() {
        let unit = units::unit(after)?;
        return if written == 0 { Ok(Some(unit)) } else { Err(mixed()) };
    }
    let last = readings.iter().flatten().last().and_then(|reading| reading.unit.clone());
    match written {
        0 => Ok(None),
        1 if last.is_some() => Ok(last),
        _ if written == count => Ok(None),
        _ => Err(mixed()),
    }
}

/// The parts of `inner` between the marks outside brackets, without white space around them.
fn split(text: &str, inner: Range<usize>, is_mark: impl Fn(char, &str) -> bool) -> Vec<Range<usize>> {
    let part = &text[inner.clone()];
    let mut parts = Vec::new();
    let (mut start, mut depth) = (0, 0);
    let mut push = |from: usize, to: usize| {
        let piece = &part[from..to];
        let lead = piece.len() - piece.trim_start().len();
        let begin = inner.start + from + lead;
        parts.push(begin..begin + piece.trim().len());
    };
    for (at, c) in part.char_indices() {
        match c {
            '(' | '[' => depth += 1,
            ')' | ']' => depth -= 1,
            c if depth == 0 && is_mark(c, &part[..at]) => {
                push(start, at);
                start = at + c.len_utf8();
            }
            _ => {}
        }
    }
    push(start, part.len());
    parts
}

/// Returns true if the last word is an axis.
fn is_along_axes(text: &str) -> bool {
    let mut chars = text.trim_end().chars().rev();
    let last = chars.next().and_then(axis).is_some();
    last && !chars.next().is_some_and(char::is_alphabetic)
}

fn axis(c: char) -> Option<usize> {
    match c {
        'i' => Some(0),
        'j' => Some(1),
        'k' => Some(2),
        _ => None,
    }
}

/// The sign that follows is that of an exponent: `1e-6`, `10^-6`.
fn is_exponent(before: &str) -> bool {
    let mut chars = before.chars().rev();
    match chars.next() {
        Some('^') => true,
        Some('e' | 'E') => chars.next().is_some_and(|c| c.is_ascii_digit() || matches!(c, '.' | ',')),
        _ => false,
    }
}

fn wrong_count(found: usize, len: usize, span: Range<usize>) -> ReadError {
    let (expected, example) = if len == 2 { ("2", "(3; 4) m") } else { ("2 or 3", "(3; 4; 0) m") };
    ReadError::Components { found, expected, example, span }
}
