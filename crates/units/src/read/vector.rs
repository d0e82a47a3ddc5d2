//! Reading vectors: `(300; 200) m/s`, `300; 200; 0 m/s`, `(300 i + 200 j) m/s`, `80 lbf @ 330 deg`.

use std::{f64::consts::FRAC_PI_2, ops::Range};

use super::{
    Amount, QuantityReader, ReadError, check_range, example, kinds, read,
    scan::{guard, starts_symbol},
    si, units,
};
use crate::{Kind, Unit, VectorQuantity};

/// The longest text of a vector, in characters.
const LIMIT: usize = 600;

/// Reads a vector of `len` components, 2 or 3, and their unit: `(300; 200) m/s`.
///
/// Components are set apart by `;`, by commas as in `(300, 200) m/s`, or written along i, j and k: `(300 i + 200 j) m/s`.
/// The unit stands after the brackets, after the last component, or after each of them. Where three components are
/// asked, two are enough: the third is zero. A lone zero is the zero vector. A vector in the plane of x and y may be
/// written by its magnitude and its angle, counter-clockwise from x: `80 lbf @ 330 deg`, `80 lbf ∠ 330°`.
///
/// # Errors
/// As [`read_quantity`](crate::read_quantity) for each component, and another number of components.
pub fn read_vector(text: &str, default: &Unit, kind: Kind, len: usize) -> Result<VectorQuantity, ReadError> {
    let range = guard(text, LIMIT)?;
    if range.is_empty() {
        return Err(ReadError::Empty { example: components_example(default, len) });
    }
    if let Some(at) = text[range.clone()].find(['@', '∠']) {
        return polar(text, range.clone(), range.start + at, default, kind);
    }
    let (inner, mut rest) = brackets(text, range.clone()).unwrap_or((range.clone(), range.end..range.end));
    let (mut readings, written) = if let Some(parts) = components(text, inner.clone(), default)? {
        parts
    } else {
        // One component alone: the zero vector, or too little.
        let lone = read(text, range.clone(), default);
        let zero =
            |reading: &QuantityReader| si(reading.amount, reading.unit.as_ref().unwrap_or(default)).0 == 0.0;
        match (lone, between_commas(text, &range, inner.clone(), len)?) {
            (Ok(reading), _) if zero(&reading) => {
                rest = range.end..range.end;
                (vec![Some(reading)], len)
            }
            (_, Some(parts)) => readings_of(text, parts, default)?,
            (Ok(_), None) => return Err(wrong_count(1, default, len, range)),
            (Err(error), None) => return Err(error),
        }
    };
    if written > len || written < 2 {
        return Err(wrong_count(written, default, len, inner));
    }
    let unit = common_unit(&mut readings, text, rest, &range, components_example(default, len))?;
    let mut si_values = [0.0; 3];
    let mut last_place = 0.0_f64;
    for (place, reading) in si_values.iter_mut().zip(&mut readings) {
        let Some(reading) = reading else { continue };
        if reading.unit.is_none() {
            reading.unit.clone_from(&unit);
        }
        kinds::check_component(reading, text, range.clone(), default, kind)?;
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

/// `80 lbf @ 330 deg`: a magnitude, and the angle from x, counter-clockwise. `at` is where the mark stands.
fn polar(
    text: &str,
    range: Range<usize>,
    at: usize,
    default: &Unit,
    kind: Kind,
) -> Result<VectorQuantity, ReadError> {
    let mark = if text[at..].starts_with('@') { 1 } else { '∠'.len_utf8() };
    let (size, angle) = (trimmed(text, range.start..at), trimmed(text, at + mark..range.end));
    for (part, expected) in [(&size, "a magnitude"), (&angle, "an angle")] {
        if part.is_empty() {
            let whole = text[range.clone()].to_owned();
            return Err(ReadError::Unfinished { text: whole, expected, span: part.clone() });
        }
    }
    let magnitude = read(text, size.clone(), default)?;
    kinds::check_component(&magnitude, text, range.clone(), default, kind)?;
    let degree = units::unit("deg")?;
    let direction = read(text, angle.clone(), &degree)?;
    kinds::check(&direction, text, angle.clone(), &degree, Kind::Angle)?;
    let turned = si(direction.amount, direction.unit.as_ref().unwrap_or(&degree)).0;
    if direction.unit.as_ref().is_none_or(|unit| unit.text.is_empty()) && turned != 0.0 {
        let whole = &text[range.clone()];
        let readings = [format!("{whole} deg"), format!("{whole} rad")];
        return Err(ReadError::Ambiguous { text: whole.to_owned(), readings, span: range });
    }
    check_range(direction.amount, turned, &text[angle.clone()], angle)?;
    let unit = magnitude.unit.unwrap_or_else(|| default.clone());
    let (length, last_place) = si(magnitude.amount, &unit);
    check_range(magnitude.amount, length, &text[size.clone()], size)?;
    let [x, y] = direction_of(turned);
    Ok(VectorQuantity { si: [length * x, length * y, 0.0], len: 2, unit, last_place })
}

/// A part of a text without the white space around it.
fn trimmed(text: &str, part: Range<usize>) -> Range<usize> {
    let piece = &text[part.clone()];
    let start = part.start + piece.len() - piece.trim_start().len();
    start..start + piece.trim().len()
}

/// Cosine and sine of an angle, exact at right angles.
fn direction_of(angle: f64) -> [f64; 2] {
    let quarters = (angle / FRAC_PI_2).round();
    if (angle - quarters * FRAC_PI_2).abs() > 4.0 * f64::EPSILON * angle.abs() {
        return [angle.cos(), angle.sin()];
    }
    match quarters.rem_euclid(4.0) {
        0.0 => [1.0, 0.0],
        1.0 => [0.0, 1.0],
        2.0 => [-1.0, 0.0],
        _ => [0.0, -1.0],
    }
}

/// The components, a missing one along i, j or k as `None`, and how many were written.
type Components<'t> = (Vec<Option<QuantityReader<'t>>>, usize);

/// Range inside the brackets that open the text, and range after them.
fn brackets(text: &str, range: Range<usize>) -> Option<(Range<usize>, Range<usize>)> {
    let part = &text[range.clone()];
    let closing = match part.chars().next()? {
        '(' => ')',
        '[' => ']',
        '{' => '}',
        _ => return None,
    };
    let mut depth = 0;
    for (at, c) in part.char_indices() {
        match c {
            '(' | '[' | '{' => depth += 1,
            ')' | ']' | '}' => depth -= 1,
            _ => {}
        }
        if depth == 0 {
            let inner = range.start + 1..range.start + at;
            let inside = &text[inner.clone()];
            let commas = inside.contains(',') && !is_along_axes(part);
            let vector = c == closing && (inside.contains(';') || commas || is_along_axes(inside));
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
        return readings_of(text, split(text, inner, |c, _| c == ';'), default).map(Some);
    }
    if is_along_axes(&text[inner.clone()]) {
        return along_axes(text, inner, default).map(Some);
    }
    Ok(None)
}

fn readings_of<'t>(
    text: &'t str,
    parts: Vec<Range<usize>>,
    default: &Unit,
) -> Result<Components<'t>, ReadError> {
    let written = parts.len();
    let mut readings = Vec::new();
    // One more than there can be is enough to see that there are too many.
    for part in parts.into_iter().take(4) {
        if part.is_empty() {
            let text = text.trim().to_owned();
            return Err(ReadError::Unfinished { text, expected: "a component", span: part });
        }
        readings.push(Some(read(text, part, default)?));
    }
    Ok((readings, written.min(4)))
}

/// The parts between commas, which are decimal marks too: `(1, 1, 2)`, `(1,1,2)`, and `(1,1, 2)` where two are asked.
fn between_commas(
    text: &str,
    range: &Range<usize>,
    inner: Range<usize>,
    len: usize,
) -> Result<Option<Vec<Range<usize>>>, ReadError> {
    if !text[inner.clone()].contains(',') {
        return Ok(None);
    }
    let all = split(text, inner.clone(), |c, _| c == ',');
    let is_spaced = |before: &str| text[inner.start + before.len() + 1..].starts_with(char::is_whitespace);
    let spaced = split(text, inner.clone(), |c, before| c == ',' && is_spaced(before));
    let fits = |parts: &[Range<usize>]| (2..=len).contains(&parts.len());
    Ok(match (all.len(), spaced.len()) {
        (a, b) if a == b => Some(all),
        // `1,5 m` is a number.
        (_, 1) if inner == *range => None,
        (_, 1) => Some(all),
        _ if fits(&all) && fits(&spaced) => {
            let joined = |parts: &[Range<usize>]| {
                let parts: Vec<_> = parts.iter().map(|part| &text[part.clone()]).collect();
                format!(
                    "{}{}{}",
                    &text[range.start..inner.start],
                    parts.join("; "),
                    &text[inner.end..range.end]
                )
            };
            let readings = [joined(&all), joined(&spaced)];
            return Err(ReadError::Ambiguous {
                text: text[range.clone()].into(),
                readings,
                span: range.clone(),
            });
        }
        _ if fits(&all) => Some(all),
        _ => Some(spaced),
    })
}

/// `300 i − 200 j m/s`: each term ends in an axis, or in an axis and a unit.
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
        let (at, axis) = axis_in(term).ok_or_else(|| ReadError::Unexpected {
            found: term.into(),
            expected: "a component along i, j or k",
            span: part.clone(),
        })?;
        let number = term[..at].trim_end().trim_end_matches(['*', '·']).trim_end();
        let behind = trimmed(text, part.start + at + 1..part.end);
        let mut reading = if number.is_empty() {
            QuantityReader { amount: Amount::Computed(1.0), unit: None, pi: false, combined: None }
        } else {
            read(text, part.start..part.start + number.len(), default)?
        };
        if !behind.is_empty() {
            if reading.unit.is_some() {
                let found = text[behind.clone()].into();
                return Err(ReadError::Unexpected { found, expected: "one unit", span: behind });
            }
            reading.unit = Some(units::unit_in(text, behind)?);
        }
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
    example: String,
) -> Result<Option<Unit>, ReadError> {
    let written = readings.iter().flatten().filter(|reading| reading.unit.is_some()).count();
    let count = readings.iter().flatten().count();
    let after = trimmed(text, rest);
    let mixed = || ReadError::MixedComponents { text: text[all.clone()].into(), example, span: all.clone() };
    if !after.is_empty() {
        let unit = units::unit_in(text, after)?;
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
    let mut push = |from: usize, to: usize| parts.push(trimmed(text, inner.start + from..inner.start + to));
    for (at, c) in part.char_indices() {
        match c {
            '(' | '[' | '{' => depth += 1,
            ')' | ']' | '}' => depth -= 1,
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

/// Returns true if the last word is an axis, or the last but a unit.
fn is_along_axes(text: &str) -> bool {
    let last = split(text, 0..text.len(), |c, before| matches!(c, '+' | '-' | '−') && !is_exponent(before));
    last.last().is_some_and(|part| axis_in(&text[part.clone()]).is_some())
}

/// The axis of a term, `k` in `10 k` and `10 k rad/s`, and where it stands: at the end or before a unit.
fn axis_in(term: &str) -> Option<(usize, usize)> {
    let found = |(at, c): (usize, char)| {
        let number = axis(c)?;
        let behind = &term[at + 1..];
        let alone = !term[..at].ends_with(char::is_alphabetic) && !behind.starts_with(char::is_alphanumeric);
        let unit = behind.trim_start();
        (alone && (unit.is_empty() || unit.starts_with(starts_symbol) || unit.starts_with(['(', '1'])))
            .then_some((at, number))
    };
    term.char_indices().rev().find_map(found)
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

fn wrong_count(found: usize, default: &Unit, len: usize, span: Range<usize>) -> ReadError {
    let expected = if len == 2 { "2" } else { "2 or 3" };
    ReadError::Components { found, expected, example: components_example(default, len), span }
}

/// Text of a vector in the unit of its field.
fn components_example(default: &Unit, len: usize) -> String {
    example(if len == 2 { "(3; 4)" } else { "(3; 4; 0)" }, default)
}
