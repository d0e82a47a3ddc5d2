//! Arithmetic with units: `2*pi*50 rad/s`, `1/2 in`, `5 ft + 3 in`, `sqrt(2) m`.
//!
//! sum = product (± product)…, product = signed (×÷ signed)…, signed = − signed | power,
//! power = atom ^ signed, atom = number | π | √ atom | ( sum ) | unit symbol.

use std::ops::Range;

use super::{
    Amount, QuantityReader, ReadError, kinds,
    scan::{
        Cursor, DEPTH, is_product, is_quotient, starts_symbol, superscript_digit, takes_digit,
        vulgar_fraction,
    },
    units::{POWER, power, symbol, two_readings},
    value::{Quantities, Value, compose},
};
use crate::{Unit, UnitMeaning, decimal, scale::Scale, table};

/// The value of the whole text from the cursor on.
pub(super) fn evaluate(cursor: Cursor<'_>) -> Result<QuantityReader<'_>, ReadError> {
    if let Some(angle) = sexagesimal(cursor) {
        return Ok(angle);
    }
    let mut reader = Reader { cursor, pi: false };
    let value = reader.sum(0)?;
    if !reader.cursor.rest().is_empty() {
        return Err(reader.cursor.unexpected("an operator or a unit"));
    }
    let (text, span) = (cursor.rest(), cursor.at..cursor.end);
    if !value.written {
        return Err(number_missing(text, span));
    }
    if value.scale.sense == UnitMeaning::Level && (value.literal.is_none() || *value.symbols != [("dB", 1)]) {
        return Err(ReadError::Alone { symbol: "dB".into(), after: "a plain number", example: "20 dB" });
    }
    let steep = value.symbols.iter().any(|(_, n)| n.unsigned_abs() > POWER);
    if steep || !value.scale.is_sane() {
        return Err(ReadError::Exponent { text: text.into(), limit: POWER, span });
    }
    let unit = value.has_unit.then(|| {
        let text = compose(&value.symbols);
        Unit::new(value.scale, text.into())
    });
    let amount = value.literal.map_or(Amount::Computed(value.number), Amount::Literal);
    let combined = (value.quantities == Quantities::Several).then_some(value.rate);
    Ok(QuantityReader { amount, unit, pi: reader.pi, combined })
}

struct Reader<'t> {
    cursor: Cursor<'t>,
    /// π was written.
    pi: bool,
}

impl<'t> Reader<'t> {
    fn sum(&mut self, depth: usize) -> Result<Value<'t>, ReadError> {
        self.cursor.skip_space();
        let start = self.cursor.at;
        let mut value = self.product(depth)?;
        loop {
            self.cursor.skip_space();
            let sign = match self.cursor.peek() {
                Some('+') => 1.0,
                Some('-' | '−') => -1.0,
                _ => return Ok(value),
            };
            let operator = self.cursor.at;
            self.cursor.advance();
            self.cursor.skip_space();
            let from = self.cursor.at;
            let other = self.product(depth)?;
            let span = start..self.cursor.at;
            for (part, range) in [(&value, start..from), (&other, from..self.cursor.at)] {
                if !part.written {
                    let text =
                        self.cursor.text[range.clone()].trim().trim_end_matches(['+', '-', '−']).trim_end();
                    return Err(number_missing(text, range));
                }
            }
            if value.scale.dim != other.scale.dim {
                let parts = [&self.cursor.text[start..operator], &self.cursor.text[from..self.cursor.at]];
                let sign = &self.cursor.text[operator..from];
                let repairs = kinds::sums(parts, sign.trim(), [value.scale.dim, other.scale.dim]);
                return Err(ReadError::Sum { left: value.scale.dim, right: other.scale.dim, repairs, span });
            }
            if value.scale.sense == UnitMeaning::Level || other.scale.sense == UnitMeaning::Level {
                return Err(ReadError::Alone {
                    symbol: "dB".into(),
                    after: "a plain number",
                    example: "20 dB",
                });
            }
            let ratio = other.scale.mantissa / value.scale.mantissa;
            let ten = i32::from(other.scale.ten) - i32::from(value.scale.ten);
            value.number += sign * decimal::shift(other.number * ratio, ten);
            value.literal = None;
            value.has_unit |= other.has_unit;
            if other.quantities == Quantities::Several {
                value.quantities = other.quantities;
            }
            value.ambiguous |= other.ambiguous;
            self.in_range(value.number, false, start)?;
        }
    }

    fn product(&mut self, depth: usize) -> Result<Value<'t>, ReadError> {
        self.cursor.skip_space();
        let start = self.cursor.at;
        let mut ends_in_digit = self.starts_with_digit();
        let mut value = self.signed(depth)?;
        value.ambiguous |= !value.written;
        // The unit directly behind a number goes on while units follow.
        let mut in_unit = false;
        let mut divisor: Option<Range<usize>> = None;
        loop {
            let gap = self.cursor.at;
            self.cursor.skip_space();
            let Some(next) = self.cursor.peek() else { return Ok(value) };
            let divides = is_quotient(next);
            let explicit = divides || is_product(next) || self.is_cross() || self.is_point(&value, gap);
            if explicit {
                self.cursor.advance();
                self.cursor.skip_space();
                if !divides {
                    self.refuse_ten_minus(start)?;
                }
            } else if !(starts_symbol(next) || next == '(' || next == '√' || self.starts_with_digit()) {
                return Ok(value);
            } else if self.starts_with_digit() && !self.may_multiply(ends_in_digit, &value) {
                self.refuse_gap(&value, start, gap)?;
            }
            let from = self.cursor.at;
            let behind_number = ends_in_digit && !explicit;
            ends_in_digit = self.starts_with_digit();
            let mut factor = if explicit { self.signed(depth)? } else { self.power(depth)? };
            let range = from..self.cursor.at;
            in_unit = !factor.written && (in_unit || behind_number);
            factor.ambiguous |= explicit && !factor.written && !in_unit;
            let zero = value.number == 0.0 || factor.number == 0.0;
            if divides {
                if factor.number == 0.0 {
                    let text = self.cursor.since(start).to_owned();
                    return Err(ReadError::DivisionByZero { text, span: start..self.cursor.at });
                }
                value = value.over(&factor);
                divisor = Some(range);
            } else {
                // 1/2 in is half an inch and 6/2*3 is 9; so is a number behind a sign of multiplication, as in
                // 900 N/m*(0.8 m)^2. Whatever else follows a division is not clear.
                let clear = explicit && factor.written && !value.ambiguous && !factor.ambiguous;
                match divisor.take() {
                    Some(divisor) if !clear && (value.has_unit || !(factor.has_unit || explicit)) => {
                        return Err(two_readings(self.cursor.text, start, divisor, range));
                    }
                    // From its first unit on a product is read like a unit.
                    before => {
                        let settled = factor.has_unit || (clear && value.has_unit);
                        divisor = if settled { None } else { before.map(|divisor| divisor.start..range.end) };
                    }
                }
                value = value.times(&factor);
            }
            self.in_range(value.number, !zero, start)?;
        }
    }

    fn signed(&mut self, depth: usize) -> Result<Value<'t>, ReadError> {
        self.deeper(depth)?;
        self.cursor.skip_space();
        match self.cursor.peek() {
            Some('-' | '−') => {
                self.cursor.advance();
                Ok(self.signed(depth + 1)?.negated())
            }
            Some('+') => {
                self.cursor.advance();
                self.signed(depth + 1)
            }
            _ => self.power(depth),
        }
    }

    fn power(&mut self, depth: usize) -> Result<Value<'t>, ReadError> {
        let start = self.cursor.at;
        let base = self.atom(depth)?;
        let mut ahead = self.cursor;
        ahead.skip_space();
        let exponent = if base.has_unit {
            f64::from(power(&mut self.cursor, false)?)
        } else if ahead.accept_caret() {
            self.cursor = ahead;
            let exponent = self.signed(depth + 1)?;
            if exponent.has_unit {
                let text = self.cursor.since(start).to_owned();
                return Err(ReadError::Exponent { text, limit: POWER, span: start..self.cursor.at });
            }
            exponent.number
        } else {
            self.cursor.superscript_digits().map_or(1.0, f64::from)
        };
        if exponent == 1.0 {
            return Ok(base);
        }
        let text = || self.cursor.since(start).to_owned();
        let span = start..self.cursor.at;
        if base.number == 0.0 && exponent < 0.0 {
            return Err(ReadError::DivisionByZero { text: text(), span });
        }
        let number = base.number.powf(exponent);
        if number.is_nan() {
            return Err(ReadError::NotReal { text: text(), span });
        }
        self.in_range(number, base.number != 0.0, start)?;
        let value = Value { number, literal: None, ..base };
        // Read by `units::power`, which holds it within ±12.
        Ok(if value.has_unit { value.unit_powi(exponent as i8) } else { value })
    }

    fn atom(&mut self, depth: usize) -> Result<Value<'t>, ReadError> {
        self.deeper(depth)?;
        self.cursor.skip_space();
        let start = self.cursor.at;
        match self.cursor.peek() {
            Some('(') => {
                self.cursor.advance();
                let value = self.sum(depth + 1)?;
                self.cursor.skip_space();
                if !self.cursor.accept(')') {
                    return Err(self.cursor.unexpected("a closing bracket"));
                }
                Ok(value)
            }
            Some('√') => {
                self.cursor.advance();
                let value = self.atom(depth + 1)?;
                self.root(value, start)
            }
            Some('π') => {
                self.cursor.advance();
                self.pi = true;
                Ok(Value::number(std::f64::consts::PI))
            }
            Some('0'..='9' | '.' | ',') => self.number(),
            Some(c) if let Some(fraction) = vulgar_fraction(c) => {
                self.cursor.advance();
                Ok(Value::number(fraction))
            }
            Some(c) if starts_symbol(c) => {
                let mut ahead = self.cursor;
                match ahead.symbol() {
                    Some("pi") => {
                        self.cursor = ahead;
                        self.pi = true;
                        Ok(Value::number(std::f64::consts::PI))
                    }
                    Some("sqrt" | "raiz") => {
                        ahead.skip_space();
                        self.cursor = ahead;
                        if self.cursor.peek() != Some('(') {
                            return Err(self.cursor.unexpected("an opening bracket"));
                        }
                        let value = self.atom(depth + 1)?;
                        self.root(value, start)
                    }
                    Some(text) if !text.is_empty() && is_no_number(text) => {
                        Err(not_a_number(text, start..ahead.at))
                    }
                    _ => self.unit(),
                }
            }
            _ => Err(self.cursor.unexpected("a number or a unit")),
        }
    }

    /// A number, or a whole number and a fraction: `5 1/2`, `5½`.
    fn number(&mut self) -> Result<Value<'t>, ReadError> {
        let start = self.cursor.at;
        let literal = self.cursor.literal()?;
        let number = literal.value(1.0, 0);
        self.in_range(number, !literal.is_zero(), start)?;
        let value = Value { literal: Some(literal), ..Value::number(number) };
        let mut ahead = self.cursor;
        ahead.skip_space();
        let fraction = match ahead.peek().and_then(vulgar_fraction) {
            Some(fraction) => {
                ahead.advance();
                Some(fraction)
            }
            None if ahead.at > self.cursor.at => proper_fraction(&mut ahead),
            None => None,
        };
        let Some(fraction) = fraction else { return Ok(value) };
        if !self.cursor.since(start).bytes().all(|byte| byte.is_ascii_digit()) {
            return Ok(value);
        }
        self.cursor = ahead;
        Ok(Value::number(number + fraction))
    }

    /// A unit symbol with its power; behind a number also several with hyphens, `9.81*10 N-m`.
    ///
    /// Behind an operator or at the start a name is left to formulas, where it may be that of a definition.
    fn unit(&mut self) -> Result<Value<'t>, ReadError> {
        let start = self.cursor.at;
        let behind_number = self.cursor.is_behind_number();
        let before = self.cursor.text[..start].trim_end().chars().next_back();
        let ambiguous = before.is_none_or(|c| is_product(c) || is_quotient(c) || "(+-−√".contains(c));
        if ambiguous
            && let Some(name) = { self.cursor }.symbol()
            && let Some(known) = table::lookup(name).filter(|known| known.stands_for != known.text)
        {
            let span = start..start + name.len();
            return Err(ReadError::UnknownUnit {
                symbol: name.into(),
                nearest: vec![&known.stands_for],
                span,
            });
        }
        let mut unit = self.symbol()?;
        while behind_number && self.cursor.accept_hyphen() {
            unit = unit.times(&self.symbol()?);
        }
        Ok(unit)
    }

    fn symbol(&mut self) -> Result<Value<'t>, ReadError> {
        let digit = self.cursor.peek().is_some_and(takes_digit);
        let found = symbol(&mut self.cursor)?;
        let n = power(&mut self.cursor, digit)?;
        Ok(Value {
            scale: found.scale.powi(n),
            symbols: if n == 0 { Vec::new() } else { vec![(&found.stands_for, n)] },
            written: false,
            has_unit: true,
            ..Value::number(1.0)
        })
    }

    fn root(&self, value: Value<'t>, start: usize) -> Result<Value<'t>, ReadError> {
        let span = start..self.cursor.at;
        if value.number < 0.0 {
            return Err(ReadError::NotReal { text: self.cursor.since(start).into(), span });
        }
        if !value.has_unit {
            return Ok(Value { literal: None, number: value.number.sqrt(), ..value });
        }
        let dim = value.scale.dim.root(2).ok_or(ReadError::UnevenRoot { dim: value.scale.dim, span })?;
        let si = value.number * value.scale.factor();
        let symbols = [("m", dim.length), ("kg", dim.mass), ("s", dim.time), ("rad", dim.angle)];
        Ok(Value {
            number: si.sqrt(),
            literal: None,
            scale: Scale { dim, ..Scale::ONE },
            symbols: symbols.into_iter().filter(|&(_, n)| n != 0).collect(),
            rate: value.rate / 2,
            ..value
        })
    }

    fn starts_with_digit(&self) -> bool {
        self.cursor.peek().is_some_and(|c| matches!(c, '0'..='9' | '.' | ',') || vulgar_fraction(c).is_some())
    }

    /// The `x` of `1.3 x10^-6`.
    fn is_cross(&self) -> bool {
        let rest = self.cursor.rest();
        rest.strip_prefix(['x', 'X']).is_some_and(|rest| {
            let rest = rest.trim_start().strip_prefix("10");
            rest.is_some_and(|rest| {
                rest.starts_with(['^', '*', '-', '−', '⁻'])
                    || rest.starts_with(|c| superscript_digit(c).is_some())
            })
        })
    }

    /// The point of `N.m`.
    fn is_point(&self, value: &Value, gap: usize) -> bool {
        let mut rest = self.cursor.rest().chars();
        value.has_unit
            && gap == self.cursor.at
            && rest.next() == Some('.')
            && rest.next().is_some_and(starts_symbol)
    }

    /// After `×`: 10-6 may be a power of ten whose mark is missing.
    fn refuse_ten_minus(&self, start: usize) -> Result<(), ReadError> {
        let mut ahead = self.cursor;
        if !ahead.rest().starts_with("10")
            || !self.cursor.text[..ahead.at].trim_end().ends_with(['×', 'x', 'X'])
        {
            return Ok(());
        }
        ahead.at += 2;
        if !matches!(ahead.peek(), Some('-' | '−')) || ahead.signed_digits().is_none() {
            return Ok(());
        }
        let before =
            self.cursor.text[start..self.cursor.at].trim_end().trim_end_matches(['×', 'x', 'X']).trim_end();
        let power = self.cursor.text[self.cursor.at + 2..ahead.at].replace('−', "-");
        let readings =
            [format!("{before}*10^{power}"), format!("{before}*10 - {}", power.trim_start_matches('-'))];
        Err(ReadError::Ambiguous {
            text: self.cursor.text[start..ahead.at].into(),
            readings,
            span: start..ahead.at,
        })
    }

    /// Returns true if the number here multiplies the factor before it: `2 pi 50`, and `10 1/s`.
    fn may_multiply(&self, after_digit: bool, value: &Value) -> bool {
        if !after_digit && value.written && !value.has_unit {
            return true;
        }
        // `1.5 10^3`
        let power = self.cursor.rest().strip_prefix("10").map(str::trim_start);
        let is_power = |rest: &str| {
            rest.starts_with(['^', '⁻'])
                || rest.starts_with("**")
                || rest.starts_with(|c| superscript_digit(c).is_some())
        };
        if !value.has_unit && power.is_some_and(is_power) {
            return true;
        }
        let Some(rest) = self.cursor.rest().strip_prefix('1') else { return false };
        let Some(rest) = rest.trim_start().strip_prefix(is_quotient) else { return false };
        !value.has_unit && rest.trim_start().starts_with(|c| starts_symbol(c) || c == '(')
    }

    /// `12 34 mm` and `5 ft 3 in`.
    fn refuse_gap(&self, value: &Value, start: usize, gap: usize) -> Result<(), ReadError> {
        let mut ahead = self.cursor;
        if ahead.peek().and_then(vulgar_fraction).is_some() {
            return Err(self.cursor.unexpected("an operator"));
        }
        ahead.literal()?;
        let (left, right) =
            (self.cursor.text[start..gap].trim(), &self.cursor.text[self.cursor.at..ahead.at]);
        let readings = if value.has_unit {
            let rest = ahead.rest();
            if rest.trim().is_empty() {
                return Err(self.cursor.unexpected("an operator"));
            }
            [format!("{left} + {right}{rest}"), format!("{left}*{right}{rest}")]
        } else {
            [format!("{left}{right}").replace(' ', ""), format!("{left}*{right}")]
        };
        Err(ReadError::Gap {
            text: self.cursor.text[start..ahead.at].into(),
            readings,
            span: start..ahead.at,
        })
    }

    fn deeper(&self, depth: usize) -> Result<(), ReadError> {
        if depth >= DEPTH {
            return Err(ReadError::TooDeep { limit: DEPTH, span: self.cursor.at..self.cursor.end });
        }
        Ok(())
    }

    fn in_range(&self, number: f64, zero_is_wrong: bool, start: usize) -> Result<(), ReadError> {
        if number.is_finite() && !(number == 0.0 && zero_is_wrong) {
            return Ok(());
        }
        let text = self.cursor.since(start).to_owned();
        Err(ReadError::OutOfRange { text, large: number != 0.0, span: start..self.cursor.at })
    }
}

/// `30°15'20"`: degrees, minutes and seconds of arc, as an angle in degrees.
fn sexagesimal(mut cursor: Cursor<'_>) -> Option<QuantityReader<'_>> {
    let sign = if cursor.peek().is_some_and(|c| matches!(c, '-' | '−')) { -1.0 } else { 1.0 };
    if sign < 0.0 {
        cursor.advance();
    }
    let mut degrees = 0.0;
    for (marks, part) in [(['°', 'º'], 1.0), (['\'', '′'], 60.0), (['"', '″'], 3600.0)] {
        cursor.skip_space();
        degrees += cursor.literal().ok()?.value(1.0, 0) / part;
        cursor.skip_space();
        if !cursor.peek().is_some_and(|c| marks.contains(&c)) {
            return None;
        }
        cursor.advance();
        cursor.skip_space();
        if cursor.rest().is_empty() {
            let unit = super::unit("°").ok()?;
            return Some(QuantityReader {
                amount: Amount::Computed(sign * degrees),
                unit: Some(unit),
                pi: false,
                combined: None,
            });
        }
    }
    None
}

/// `1/2` where the numerator is the smaller, and the cursor behind it.
fn proper_fraction(cursor: &mut Cursor) -> Option<f64> {
    let start = cursor.at;
    let numerator = f64::from(cursor.signed_digits()?);
    if !cursor.accept('/') {
        return None;
    }
    let denominator = f64::from(cursor.signed_digits()?);
    let plain = cursor.since(start).bytes().all(|byte| byte.is_ascii_digit() || byte == b'/');
    let ended = !matches!(cursor.peek(), Some('.' | ',' | '^'));
    (plain && ended && numerator > 0.0 && numerator < denominator).then(|| numerator / denominator)
}

/// Words for what is no number, and a hexadecimal or binary one.
fn is_no_number(text: &str) -> bool {
    ["nan", "inf", "infinity", "infinite", "infinito", "∞"].iter().any(|word| text.eq_ignore_ascii_case(word))
}

pub(super) fn not_a_number(text: &str, span: Range<usize>) -> ReadError {
    ReadError::NotANumber { text: text.into(), example: "20.3".into(), span }
}

fn number_missing(text: &str, span: Range<usize>) -> ReadError {
    ReadError::NotANumber { text: text.into(), example: format!("20.3 {text}"), span }
}
