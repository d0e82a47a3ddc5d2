//! The text as typed: what is refused at once, and the pieces that units and numbers share.

use std::{borrow::Cow, ops::Range};

use super::ReadError;
use crate::{decimal, table};

/// Maximum nesting depth of brackets, roots, powers and signs.
pub(crate) const DEPTH: usize = 32;

/// The bytes of `text` without the white space around it, when it is short and holds nothing invisible.
pub(crate) fn guard(text: &str, limit: usize) -> Result<Range<usize>, ReadError> {
    let trimmed = text.trim();
    let start = text.len() - text.trim_start().len();
    if trimmed.len() > limit && trimmed.chars().nth(limit).is_some() {
        return Err(ReadError::TooLong { limit });
    }
    let suspect = trimmed.bytes().any(|byte| !(0x20..0x7f).contains(&byte));
    let control = if suspect { trimmed.char_indices().find(|&(_, c)| is_invisible(c)) } else { None };
    match control {
        Some((at, c)) => {
            Err(ReadError::Control { code: c.into(), span: start + at..start + at + c.len_utf8() })
        }
        None => Ok(start..start + trimmed.len()),
    }
}

/// A place in the text typed, and where the part to read ends.
#[derive(Clone, Copy)]
pub(crate) struct Cursor<'t> {
    pub(crate) text: &'t str,
    pub(crate) at: usize,
    pub(crate) end: usize,
}

impl<'t> Cursor<'t> {
    pub(crate) fn new(text: &'t str, range: Range<usize>) -> Self {
        Self { text, at: range.start, end: range.end }
    }

    pub(crate) fn rest(&self) -> &'t str {
        &self.text[self.at..self.end]
    }

    pub(crate) fn peek(&self) -> Option<char> {
        self.rest().chars().next()
    }

    pub(crate) fn advance(&mut self) {
        self.at += self.peek().map_or(0, char::len_utf8);
    }

    pub(crate) fn skip_space(&mut self) {
        while self.peek().is_some_and(char::is_whitespace) {
            self.advance();
        }
    }

    /// Goes past `mark` if it is here.
    pub(crate) fn accept(&mut self, mark: char) -> bool {
        let here = self.peek() == Some(mark);
        if here {
            self.advance();
        }
        here
    }

    /// Returns true if nothing but a number stands before this place, or nothing at all.
    pub(crate) fn is_behind_number(&self) -> bool {
        let before = self.text[..self.at].trim_end().chars().next_back();
        let is_of_a_number = |c: char| {
            c.is_ascii_digit()
                || matches!(c, '.' | ',')
                || superscript_digit(c).is_some()
                || vulgar_fraction(c).is_some()
        };
        before.is_none_or(is_of_a_number)
    }

    /// Goes past a hyphen between two units, `N-m`: no blank stands beside it, and a unit follows.
    pub(crate) fn accept_hyphen(&mut self) -> bool {
        let mut rest = self.rest().chars();
        let here = matches!(rest.next(), Some('-' | '‐' | '‑')) && rest.next().is_some_and(starts_symbol);
        if here {
            self.advance();
        }
        here
    }

    /// The text from `start` to here, without white space at its end.
    pub(crate) fn since(&self, start: usize) -> &'t str {
        self.text[start..self.at].trim_end()
    }

    /// Error for the text at this position, which does not belong here.
    pub(crate) fn unexpected(&self, expected: &'static str) -> ReadError {
        if let Some(c) = self.peek() {
            return ReadError::Unexpected {
                found: c.into(),
                expected,
                span: self.at..self.at + c.len_utf8(),
            };
        }
        let text = self.text[..self.end].trim().to_owned();
        ReadError::Unfinished { text, expected, span: self.end..self.end }
    }

    /// A run of digits with at most one decimal mark, and an exponent `e-6` if one follows.
    pub(crate) fn literal(&mut self) -> Result<Literal<'t>, ReadError> {
        let start = self.at;
        let bytes = &self.text.as_bytes()[..self.end];
        let (mut digits, mut written, mut exponent) = (0u64, 0u32, 0i32);
        let (mut marks, mut any, mut long) = (0, false, false);
        while let Some(&byte) = bytes.get(self.at) {
            match byte {
                b'0'..=b'9' => {
                    any = true;
                    if written < 19 {
                        digits = digits * 10 + u64::from(byte - b'0');
                        written += u32::from(digits > 0);
                    } else {
                        long = true;
                    }
                    exponent -= i32::from(marks > 0);
                }
                b'.' | b',' => marks += 1,
                _ => match group_mark(&self.text[start..self.at], self.rest()).filter(|_| marks == 0) {
                    Some(mark) => self.at += mark - 1,
                    None => break,
                },
            }
            self.at += 1;
        }
        let text = &self.text[start..self.at];
        if !any {
            self.at = start;
            return Err(self.unexpected("a number"));
        }
        if marks > 1 {
            return Err(two_marks(text, start..self.at));
        }
        if is_thousands(text, ',') {
            let readings = [text.replace(',', ""), text.replace(',', ".")];
            return Err(ReadError::Ambiguous { text: text.into(), readings, span: start..self.at });
        }
        if let Some(b'e' | b'E') = bytes.get(self.at) {
            let mut ahead = Cursor { at: self.at + 1, ..*self };
            if let Some(power) = ahead.signed_digits() {
                self.at = ahead.at;
                exponent = exponent.saturating_add(power);
            }
        }
        Ok(Literal { negative: false, digits, exponent, long: long.then_some(text) })
    }

    /// Digits after an optional sign, held within ±99 999.
    pub(crate) fn signed_digits(&mut self) -> Option<i32> {
        let start = self.at;
        let negative = self.peek().is_some_and(|c| matches!(c, '-' | '−'));
        if negative || self.peek() == Some('+') {
            self.advance();
        }
        let first = self.at;
        let mut n = 0i32;
        while let Some(digit) = self.peek().and_then(|c| c.to_digit(10)) {
            n = (n * 10 + digit as i32).min(99_999);
            self.advance();
        }
        if self.at == first {
            self.at = start;
            return None;
        }
        Some(if negative { -n } else { n })
    }

    /// Superscript digits after an optional superscript sign, held within ±99 999.
    pub(crate) fn superscript_digits(&mut self) -> Option<i32> {
        let start = self.at;
        let negative = self.peek() == Some('⁻');
        if negative || self.peek() == Some('⁺') {
            self.advance();
        }
        let first = self.at;
        let mut n = 0i32;
        while let Some(digit) = self.peek().and_then(superscript_digit) {
            n = (n * 10 + digit).min(99_999);
            self.advance();
        }
        if self.at == first {
            self.at = start;
            return None;
        }
        Some(if negative { -n } else { n })
    }

    /// `^` or `**`, if one is here.
    pub(crate) fn accept_caret(&mut self) -> bool {
        if self.rest().starts_with("**") {
            self.at += 2;
            return true;
        }
        self.accept('^')
    }

    /// The letters of a unit symbol, if one is here: `mm`, `g0`, `g's`, `°`, `long ton`, `pound-force`.
    pub(crate) fn symbol(&mut self) -> Option<&'t str> {
        let rest = self.rest();
        let first = rest.chars().next()?;
        let len = if is_lone_symbol(first) {
            first.len_utf8()
        } else if let Some(words) = table::unit_of_two_words(rest) {
            words.len()
        } else {
            let letters = rest.find(|c: char| !(c.is_alphabetic() || c == '_')).unwrap_or(rest.len());
            let tail = match (&rest[..letters], &rest[letters..]) {
                ("g", next) if next.starts_with('0') => 1,
                ("g", next) if next.starts_with("'s") => 2,
                // Cycles, where nothing else can be meant: `8.3 c/s`.
                ("c", next @ ("/s" | "/sec" | "/min")) if self.is_behind_number() => next.len(),
                (_, next) => FORCES.iter().find(|word| next.starts_with(**word)).map_or(0, |word| word.len()),
            };
            letters + tail
        };
        if len == 0 {
            return None;
        }
        self.at += len;
        Some(&rest[..len])
    }
}

/// Ends of the names of units of force.
const FORCES: [&str; 2] = ["-force", "-força"];

/// The characters that multiply two factors.
pub(crate) fn is_product(c: char) -> bool {
    matches!(c, '*' | '·' | '⋅' | '∙' | '×')
}

/// The characters that divide.
pub(crate) fn is_quotient(c: char) -> bool {
    matches!(c, '/' | '⁄' | '∕' | '÷')
}

/// Returns true if a unit symbol can start with this character.
pub(crate) fn starts_symbol(c: char) -> bool {
    c.is_alphabetic() || c == '_' || is_lone_symbol(c)
}

/// Returns true if a digit right after the symbol that starts with this character is its power: false for `°`.
pub(crate) fn takes_digit(c: char) -> bool {
    c.is_alphabetic() && !is_lone_symbol(c)
}

fn is_lone_symbol(c: char) -> bool {
    matches!(c, '°' | 'º' | '%' | '‰' | '\'' | '′' | '"' | '″')
}

pub(crate) fn superscript_digit(c: char) -> Option<i32> {
    "⁰¹²³⁴⁵⁶⁷⁸⁹".chars().zip(0..).find_map(|(digit, n)| (digit == c).then_some(n))
}

/// Length of the space that `rest` begins with, if it sets three digits apart from the number of one to three digits, or of
/// such groups, before it. An ordinary space does not behind a zero, nor before a fraction: `5 125/1000` is a mixed number.
pub fn group_mark(before: &str, rest: &str) -> Option<usize> {
    let mark = rest.chars().next().filter(|c| is_group_mark(*c))?.len_utf8();
    if rest.starts_with(' ') && (before.starts_with('0') || is_numerator(rest)) {
        return None;
    }
    let mut groups = before.rsplit(is_group_mark).map(str::len).peekable();
    let mut first = 0;
    while let Some(length) = groups.next() {
        if groups.peek().is_some() && length != 3 {
            return None;
        }
        first = length;
    }
    let digits = rest[mark..].bytes().take_while(u8::is_ascii_digit).count();
    ((1..=3).contains(&first) && digits == 3).then_some(mark)
}

/// Returns true if the digits that a text begins with are the numerator of a fraction.
fn is_numerator(text: &str) -> bool {
    let behind = text.trim_start_matches(|c: char| c == ' ' || c.is_ascii_digit());
    let divisor = behind.strip_prefix(is_quotient).map(str::trim_start);
    divisor.is_some_and(|divisor| divisor.starts_with(|c: char| c.is_ascii_digit()))
}

/// The value of a fraction that is one character: 0.5 of `½`.
pub fn vulgar_fraction(c: char) -> Option<f64> {
    let [above, below] = match c {
        '½' => [1.0, 2.0],
        '⅓' => [1.0, 3.0],
        '⅔' => [2.0, 3.0],
        '¼' => [1.0, 4.0],
        '¾' => [3.0, 4.0],
        '⅛' => [1.0, 8.0],
        '⅜' => [3.0, 8.0],
        '⅝' => [5.0, 8.0],
        '⅞' => [7.0, 8.0],
        _ => return None,
    };
    Some(above / below)
}

/// Control characters, those without width, and those that turn the direction of the text.
pub fn is_invisible(c: char) -> bool {
    c.is_control()
        || matches!(c, '\u{ad}' | '\u{61c}' | '\u{180e}' | '\u{200b}'..='\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2060}'..='\u{206f}' | '\u{fe00}'..='\u{fe0f}' | '\u{feff}' | '\u{fff9}'..='\u{fffb}' | '\u{e0000}'..='\u{e0fff}')
}

/// The first number of a text that may be meant as thousands, as `1,250` may: one to three digits that do not begin
/// with 0, the mark, and three digits.
pub fn thousands(text: &str, mark: char) -> Option<&str> {
    text.split(|c: char| !is_of_a_number(c)).find(|number| is_thousands(number, mark))
}

/// A text with the decimal commas of its numbers written as points: what somebody types whose language has the comma.
/// ```
/// use dalembert_units::with_point;
/// assert_eq!(with_point("(1,250; -0,5) m"), "(1.250; -0.5) m");
/// assert_eq!(with_point("1,234.5 m"), "1,234.5 m");
/// assert_eq!(with_point("atan2(1,5, −2,5)"), "atan2(1.5, −2.5)");
/// ```
pub fn with_point(text: &str) -> Cow<'_, str> {
    if !text.contains(',') {
        return text.into();
    }
    let ended = |at: usize| text[at..].find(|c: char| !is_of_a_number(c)).map_or(text.len(), |end| at + end);
    let (mut pointed, mut at) = (String::with_capacity(text.len()), 0);
    while let Some(start) = text[at..].find(is_of_a_number).map(|start| at + start) {
        // A comma behind a number ends a clause.
        let end = start + text[start..ended(start)].trim_end_matches(',').len().max(1);
        pointed.push_str(&text[at..start]);
        match text[start..end].split_once(',') {
            Some((whole, decimals))
                if !decimals.is_empty() && !whole.contains('.') && !decimals.contains(['.', ',']) =>
            {
                pointed.extend([whole, ".", decimals]);
            }
            _ => pointed.push_str(&text[start..end]),
        }
        at = end;
    }
    pointed.push_str(&text[at..]);
    pointed.into()
}

/// The text with a decimal comma in each of its numbers that has a decimal point: for readers whose language has commas. What
/// it makes, [`with_point`] takes back.
pub fn with_comma(text: &str) -> String {
    let digit = |byte: Option<&u8>| byte.is_some_and(u8::is_ascii_digit);
    let bytes = text.as_bytes();
    let is_decimal = |at: usize| {
        digit(bytes.get(at + 1))
            && (at == 0 || digit(bytes.get(at - 1)) || !bytes[at - 1].is_ascii_alphanumeric())
    };
    text.char_indices().map(|(at, c)| if c == '.' && is_decimal(at) { ',' } else { c }).collect()
}

/// Returns true for the spaces with which printed numbers set groups of three digits apart (ISO 80000-1), and the ordinary
/// one that is typed in their place.
fn is_group_mark(c: char) -> bool {
    matches!(c, ' ' | '\u{a0}' | '\u{2009}' | '\u{202f}')
}

fn is_of_a_number(c: char) -> bool {
    c.is_ascii_digit() || matches!(c, '.' | ',')
}

fn is_thousands(number: &str, mark: char) -> bool {
    number.split_once(mark).is_some_and(|(head, tail)| {
        let digits = |part: &str| part.bytes().all(|byte| byte.is_ascii_digit());
        (1..=3).contains(&head.len())
            && tail.len() == 3
            && !head.starts_with('0')
            && digits(head)
            && digits(tail)
    })
}

fn two_marks(text: &str, span: Range<usize>) -> ReadError {
    let is_mark = |c| matches!(c, '.' | ',');
    let first = text.find(is_mark).unwrap_or(0);
    let last = text.rfind(is_mark).unwrap_or(0);
    let default = |part: &str| part.replace(['.', ','], "");
    let kept = |at: usize| format!("{}.{}", default(&text[..at]), default(&text[at + 1..]));
    let same = text.contains('.') != text.contains(',');
    let readings = if same { [default(text), kept(first)] } else { [kept(last), kept(first)] };
    ReadError::TwoMarks { text: text.into(), readings, span }
}

/// A number as written: `±digits × 10^exponent`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Literal<'t> {
    pub(crate) negative: bool,
    digits: u64,
    exponent: i32,
    /// The digits and mark as written, where there are more than `digits` can hold.
    long: Option<&'t str>,
}

impl Literal<'_> {
    pub(crate) fn negated(self) -> Self {
        Self { negative: !self.negative, ..self }
    }

    pub(crate) fn shifted(self, ten: i32) -> Self {
        Self { exponent: self.exponent.saturating_add(ten), ..self }
    }

    /// Value of the literal times `mantissa × 10^ten`, rounded once. Zero or infinite where it is beyond `f64`.
    pub(crate) fn value(self, mantissa: f64, ten: i16) -> f64 {
        let exponent = self.exponent.saturating_add(ten.into());
        let size = match self.long {
            None => decimal::join(self.digits, mantissa, exponent),
            Some(text) => {
                let digits: String = text.chars().filter(char::is_ascii_digit).collect();
                let number = format!("{digits}e{exponent}").parse::<f64>();
                mantissa * number.expect("digits and a decimal exponent are a number")
            }
        };
        if self.negative { -size } else { size }
    }

    pub(crate) fn is_zero(self) -> bool {
        self.digits == 0
    }

    /// One unit in its last place, times `mantissa × 10^ten`; finite for a zero of any exponent.
    pub(crate) fn last_place(self, mantissa: f64, ten: i16) -> f64 {
        decimal::join(1, mantissa, self.exponent.saturating_add(ten.into())).min(f64::MAX)
    }
}
