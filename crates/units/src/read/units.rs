//! Products, quotients and powers of unit symbols.

use std::{borrow::Cow, ops::Range};

use super::{
    ReadError,
    scan::{Cursor, DEPTH, guard, is_product, is_quotient, starts_symbol, takes_digit},
};
use crate::{Dim, Unit, UnitMeaning, scale::Scale, table};

/// The largest power of a unit.
pub(super) const POWER: u8 = 12;

/// The longest text of a unit.
const LIMIT: usize = 100;

/// Reads a unit: `kN/mm^2`, `N·m`, `deg`, `%`; the empty text and `1` are the unit of a pure number.
///
/// A digit right after a symbol is its power. A product after a division (`N/m s`) is refused: it has
/// two readings. A unit of amplitude ends in `pp` (peak to peak), `rms` or `pk`.
///
/// # Errors
/// An unknown symbol, with the nearest known ones; a text that is no unit, or has two readings.
pub fn unit(text: &str) -> Result<Unit, ReadError> {
    unit_in(text, guard(text, LIMIT)?)
}

/// The unit in a part of a text.
pub(super) fn unit_in(text: &str, range: Range<usize>) -> Result<Unit, ReadError> {
    let (range, sense) = split_suffix(text, range);
    if range.is_empty() && sense == UnitMeaning::Plain {
        return Ok(Unit::ONE);
    }
    let mut cursor = Cursor::new(text, range);
    let unit = whole(&mut cursor).map_err(|error| error.suggesting(Dim::NONE, |_, _| false))?;
    if !cursor.rest().is_empty() {
        return Err(cursor.unexpected("a unit"));
    }
    with_suffix(unit, sense)
}

/// The unit from here to the end of the text or to a closing bracket that is not its own.
pub(super) fn whole(cursor: &mut Cursor) -> Result<Unit, ReadError> {
    let start = cursor.at;
    let mut reader = Reader { cursor: *cursor, symbols: 0, only: None, rewritten: Vec::new() };
    let scale = reader.product(0)?;
    let Reader { cursor: end, symbols, only, rewritten } = reader;
    *cursor = end;
    let typed = cursor.since(start);
    let span = start..start + typed.len();
    let text = rewrite(typed, start, &rewritten);
    if !scale.is_sane() {
        return Err(ReadError::Exponent { text: typed.into(), limit: POWER, span });
    }
    if scale.sense == UnitMeaning::Level && only != Some(&*text) {
        return Err(ReadError::Alone { symbol: "dB".into(), after: "a plain number", example: "20 dB" });
    }
    Ok(match only {
        Some(symbol) if symbol == text => Unit::new(scale, Cow::Borrowed(symbol)),
        _ if symbols == 0 => Unit::ONE,
        _ => Unit::new(scale, Cow::Owned(text.into_owned())),
    })
}

/// A unit with symbols in place of names, and `*` in place of hyphens.
fn rewrite<'t>(typed: &'t str, start: usize, rewritten: &[(Range<usize>, &str)]) -> Cow<'t, str> {
    if rewritten.is_empty() {
        return typed.into();
    }
    let (mut text, mut at) = (String::new(), 0);
    for (range, symbol) in rewritten {
        text += &typed[at..range.start - start];
        text += symbol;
        at = range.end - start;
    }
    (text + &typed[at..]).into()
}

/// Takes `pp`, `rms` or `pk` off the end of the text.
pub(super) fn split_suffix(text: &str, range: Range<usize>) -> (Range<usize>, UnitMeaning) {
    let part = &text[range.clone()];
    if !part.ends_with(['p', 's', 'k', 'S']) {
        return (range, UnitMeaning::Plain);
    }
    let Some(space) = part.rfind(char::is_whitespace) else { return (range, UnitMeaning::Plain) };
    let sense = match part[space..].trim_start() {
        "pp" | "p-p" | "pk-pk" | "peak-to-peak" => UnitMeaning::PeakToPeak,
        "rms" | "RMS" => UnitMeaning::Rms,
        "pk" | "peak" | "0-pk" | "0-p" => UnitMeaning::Peak,
        _ => return (range, UnitMeaning::Plain),
    };
    (range.start..range.start + part[..space].trim_end().len(), sense)
}

/// The unit in which the amplitude of an oscillation is written.
pub(super) fn with_suffix(unit: Unit, sense: UnitMeaning) -> Result<Unit, ReadError> {
    let (mantissa, suffix) = match sense {
        UnitMeaning::PeakToPeak => (0.5, "pp"),
        UnitMeaning::Rms => (std::f64::consts::SQRT_2, "rms"),
        UnitMeaning::Peak => (1.0, "pk"),
        UnitMeaning::Plain | UnitMeaning::Energy | UnitMeaning::Level => return Ok(unit),
    };
    if unit.text.is_empty() || unit.sense == UnitMeaning::Level {
        return Err(ReadError::Alone {
            symbol: suffix.into(),
            after: "a unit of length, velocity or acceleration",
            example: "3 mm pp",
        });
    }
    let text = format!("{} {suffix}", unit.text);
    Ok(Unit::new(Scale { mantissa: unit.mantissa * mantissa, sense, ..unit.scale() }, text.into()))
}

/// The power of a unit where a digit may follow at once: `^2`, `**-1`, `^(2)`, `²`, and `2` as in `mm2`.
///
/// Returns 1 where there is none. `digit` says whether a plain digit may be one: not after `°`, where minutes follow.
pub(crate) fn power(cursor: &mut Cursor, digit: bool) -> Result<i8, ReadError> {
    let start = cursor.at;
    let mut ahead = *cursor;
    ahead.skip_space();
    let power = if ahead.accept_caret() {
        *cursor = ahead;
        cursor.skip_space();
        let bracket = cursor.accept('(');
        let power = cursor.signed_digits();
        let closed = !bracket || cursor.accept(')');
        match power {
            Some(power) if closed && !matches!(cursor.peek(), Some('.' | ',')) => Some(power),
            _ => {
                let text = cursor.since(start).to_owned();
                return Err(ReadError::Exponent { text, limit: POWER, span: start..cursor.at });
            }
        }
    } else if digit && cursor.peek().is_some_and(|c| c.is_ascii_digit()) {
        cursor.signed_digits()
    } else {
        cursor.superscript_digits()
    };
    match power.map(i8::try_from) {
        None => Ok(1),
        Some(Ok(n)) if n != 0 && n.unsigned_abs() <= POWER => Ok(n),
        Some(_) => {
            let text = cursor.since(start).trim_start().to_owned();
            Err(ReadError::Exponent { text, limit: POWER, span: start..cursor.at })
        }
    }
}

/// The symbol here, from the table. [`ReadError::suggesting`] names those near an unknown one.
pub(super) fn symbol(cursor: &mut Cursor) -> Result<&'static table::Symbol, ReadError> {
    let start = cursor.at;
    let text = cursor.symbol().ok_or_else(|| cursor.unexpected("a unit"))?;
    table::lookup(text).ok_or_else(|| {
        let (symbol, span) = (text.into(), start..cursor.at);
        match table::several(text) {
            [] => ReadError::UnknownUnit { symbol, nearest: Vec::new(), span },
            meant => ReadError::SeveralUnits { symbol, meant: meant.to_vec(), span },
        }
    })
}

/// `a/b c` has two readings.
///
/// `start` is where the product starts, `divisor` where its last divisor is, `factor` what follows it.
pub(super) fn two_readings(
    text: &str,
    start: usize,
    divisor: Range<usize>,
    factor: Range<usize>,
) -> ReadError {
    let part = |range: Range<usize>| text[range].trim().to_owned();
    let (whole, next) = (part(start..divisor.end), part(factor.clone()));
    let before = part(start..divisor.start);
    let readings = [format!("({whole})*{next}"), format!("{before}({}*{next})", part(divisor))];
    ReadError::Ambiguous { text: part(start..factor.end), readings, span: start..factor.end }
}

struct Reader<'t> {
    cursor: Cursor<'t>,
    symbols: usize,
    /// The symbol, as long as it is the only one.
    only: Option<&'static str>,
    /// Parts of the text that are shown as something else.
    rewritten: Vec<(Range<usize>, &'static str)>,
}

impl Reader<'_> {
    fn product(&mut self, depth: usize) -> Result<Scale, ReadError> {
        self.cursor.skip_space();
        let start = self.cursor.at;
        let mut scale = if self.cursor.peek() == Some('1') {
            self.cursor.advance();
            let mut ahead = self.cursor;
            ahead.skip_space();
            // `1/s`; `1 m` would make a slip of `51 m` another number.
            if !ahead.peek().is_none_or(|c| is_quotient(c) || c == ')') {
                return Err(ahead.unexpected("a division"));
            }
            Scale::ONE
        } else {
            self.factor(depth)?
        };
        let mut divisor: Option<Range<usize>> = None;
        loop {
            let mut ahead = self.cursor;
            ahead.skip_space();
            let Some(next) = ahead.peek() else { break };
            let divides = is_quotient(next);
            if divides || (is_product(next) && !ahead.rest().starts_with("**")) {
                ahead.advance();
            } else if next == '.' && ahead.at == self.cursor.at {
                // `N.m`
                ahead.advance();
            } else if ahead.at == self.cursor.at && ahead.accept_hyphen() {
                self.rewritten.push((self.cursor.at..ahead.at, "*"));
            } else if !(starts_symbol(next) || next == '(') {
                break;
            }
            self.cursor = ahead;
            self.cursor.skip_space();
            let from = self.cursor.at;
            let factor = self.factor(depth)?;
            let range = from..self.cursor.at;
            if divides {
                scale = scale.over(factor);
                divisor = Some(range);
            } else if let Some(divisor) = divisor {
                return Err(two_readings(self.cursor.text, start, divisor, range));
            } else {
                scale = scale.times(factor);
            }
        }
        Ok(scale)
    }

    fn factor(&mut self, depth: usize) -> Result<Scale, ReadError> {
        if depth == DEPTH {
            return Err(ReadError::TooDeep { limit: DEPTH, span: self.cursor.at..self.cursor.end });
        }
        if self.cursor.accept('(') {
            let scale = self.product(depth + 1)?;
            self.cursor.skip_space();
            if !self.cursor.accept(')') {
                return Err(self.cursor.unexpected("a closing bracket"));
            }
            return Ok(scale.powi(power(&mut self.cursor, false)?));
        }
        let digit = self.cursor.peek().is_some_and(takes_digit);
        let start = self.cursor.at;
        let symbol = symbol(&mut self.cursor)?;
        self.symbols += 1;
        self.only = (self.symbols == 1).then_some(&symbol.stands_for);
        if symbol.stands_for != symbol.text {
            self.rewritten.push((start..self.cursor.at, &symbol.stands_for));
        }
        Ok(symbol.scale.powi(power(&mut self.cursor, digit)?))
    }
}
