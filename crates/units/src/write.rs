//! Writing numbers and quantities the way a worked solution does.

#[cfg(test)]
mod tests;

use std::cmp::Ordering;

use crate::{
    Kind, Unit, UnitMeaning, decimal,
    read::{
        scan::{Cursor, is_product, is_quotient, takes_digit, with_comma, with_point},
        units::power,
    },
    unit,
};

/// The mark between the whole part of a number and its decimals.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Decimal {
    /// `20.3`
    #[default]
    Point,
    /// `20,3`
    Comma,
}

impl Decimal {
    /// A text with a decimal point in its numbers as it is written with this mark.
    pub fn written(self, text: &str) -> String {
        match self {
            Decimal::Point => text.to_owned(),
            Decimal::Comma => with_comma(text),
        }
    }

    /// A text typed with this mark as it is written with a decimal point.
    pub fn to_point(self, text: &str) -> String {
        match self {
            Decimal::Point => text.to_owned(),
            Decimal::Comma => with_point(text).into_owned(),
        }
    }
}

/// Style of written numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Style {
    /// Significant digits, 1 to 17; trailing zeros are not written.
    pub digits: u8,
    /// The decimal mark.
    pub decimal: Decimal,
    /// Nothing outside ASCII: `-1.3e-6 m^4` instead of `−1.3×10⁻⁶ m⁴`.
    pub ascii: bool,
}

impl Default for Style {
    fn default() -> Self {
        Self { digits: 5, decimal: Decimal::Point, ascii: false }
    }
}

/// A number with the significant digits of `style`, rounded correctly, without trailing zeros.
///
/// A power of ten is written outside 10⁻³ ≤ |value| < 10⁵: `1.3×10⁻⁶`. What is written can be read again.
pub fn write_number(value: f64, style: Style) -> String {
    scaled(value, 1.0, 0, style)
}

/// A value in SI, written in `unit`: `451.39 kN/m`, `30°`, `12 %`.
///
/// What is written can be read again: to the digits shown, and exactly at 17 digits.
pub fn write_quantity(si: f64, unit: &Unit, style: Style) -> String {
    if unit.sense == UnitMeaning::Level && si <= 0.0 {
        // No level is zero or negative: the ratio itself can be read.
        return write_number(si, style);
    }
    with_unit(in_unit(si, unit, style), unit, style)
}

/// A vector in SI along i, j and k: `(300 i + 200 j) m/s`. Components that are zero are left out.
pub fn write_vector(si: [f64; 3], unit: &Unit, style: Style) -> String {
    let mut text = String::new();
    for (value, axis) in si.into_iter().zip(["i", "j", "k"]) {
        if value == 0.0 {
            continue;
        }
        text += match (text.is_empty(), value < 0.0, style.ascii) {
            (true, false, _) => "",
            (true, true, false) => "−",
            (true, true, true) => "-",
            (false, false, _) => " + ",
            (false, true, false) => " − ",
            (false, true, true) => " - ",
        };
        text += &in_unit(value.abs(), unit, style);
        text.push(' ');
        text += axis;
    }
    let text = if text.is_empty() { "0".into() } else { format!("({text})") };
    with_unit(text, unit, style)
}

/// Components in SI, written so that they can be typed again: `(300; 200; 0) m/s`.
pub fn write_components(si: &[f64], unit: &Unit, style: Style) -> String {
    let parts: Vec<_> = si.iter().map(|&value| in_unit(value, unit, style)).collect();
    with_unit(format!("({})", parts.join("; ")), unit, style)
}

/// The unit an engineer would show this value of that kind in: 0.0203 m in mm, 1 500 N in kN.
///
/// The largest of the usual SI units in which the number is not below 1; the SI unit itself for zero and
/// for kinds that are always shown in it.
pub fn best_unit(si: f64, kind: Kind) -> Unit {
    let usual = || kind.units().first().map_or(Unit::ONE, known);
    if si == 0.0 {
        return usual();
    }
    let ladder = kind.ladder().iter().map(known);
    // 0.01 % below counts too, so that 999.99 mm is 1 m as soon as it is written so.
    let fits = ladder.clone().rfind(|unit| si.abs() >= 0.9999 * unit.factor);
    fits.or_else(|| ladder.clone().next()).unwrap_or_else(usual)
}

/// `n` in superscript digits: `⁻²`.
pub fn superscript(n: i32) -> String {
    n.to_string()
        .chars()
        .map(|c| match c {
            '-' => '⁻',
            '1' => '¹',
            '2' => '²',
            '3' => '³',
            c => char::from_u32(u32::from('⁰') + u32::from(c) - u32::from('0')).unwrap_or(c),
        })
        .collect()
}

/// `n` in subscript digits: `₁₂`.
pub fn subscript(n: usize) -> String {
    n.to_string()
        .chars()
        .map(|c| char::from_u32(u32::from('₀') + u32::from(c) - u32::from('0')).unwrap_or(c))
        .collect()
}

/// The text of a unit for the screen (`N·m²`, `°`), or in ASCII (`N*m^2`, `deg`).
pub(crate) fn unit_text(unit: &Unit, ascii: bool) -> String {
    let is_amplitude = matches!(unit.sense, UnitMeaning::Peak | UnitMeaning::PeakToPeak | UnitMeaning::Rms);
    let end = if is_amplitude { unit.text.rfind(' ').unwrap_or(0) } else { unit.text.len() };
    let mut cursor = Cursor::new(&unit.text, 0..end);
    let product = if ascii { '*' } else { '·' };
    let mut out = String::new();
    // Two factors side by side are multiplied.
    let mut after_factor = false;
    loop {
        cursor.skip_space();
        let Some(c) = cursor.peek() else { break };
        if is_quotient(c) || is_product(c) || c == '.' {
            cursor.advance();
            out.push(if is_quotient(c) { '/' } else { product });
            after_factor = false;
            continue;
        }
        if after_factor && c != ')' {
            out.push(product);
        }
        if let Some(symbol) = cursor.symbol() {
            out += &symbol_text(symbol, ascii);
            after_factor = true;
        } else {
            cursor.advance();
            out.push(c);
            after_factor = c != '(';
        }
        match power(&mut cursor, takes_digit(c)) {
            Ok(1) | Err(_) => {}
            Ok(n) if ascii => out.extend(["^", &n.to_string()]),
            Ok(n) => out += &superscript(n.into()),
        }
    }
    out += &unit.text[end..];
    out
}

fn symbol_text(symbol: &str, ascii: bool) -> String {
    let micro = symbol.strip_prefix(['µ', 'μ', 'u']);
    match (symbol, ascii, micro) {
        ("°" | "º" | "deg", true, _) => "deg".into(),
        ("°" | "º" | "deg", false, _) => "°".into(),
        ("‰", true, _) => "permil".into(),
        ("′", true, _) => "'".into(),
        ("″", true, _) => "\"".into(),
        (_, true, Some(rest)) => format!("u{rest}"),
        (_, false, Some(rest)) => format!("µ{rest}"),
        _ => symbol.into(),
    }
}

fn with_unit(mut text: String, unit: &Unit, style: Style) -> String {
    let unit = unit_text(unit, style.ascii);
    // The marks of angles stand at the number; `°/s` and every other unit do not.
    if !unit.is_empty() && !matches!(&*unit, "°" | "'" | "′" | "\"" | "″") {
        text.push(' ');
    }
    text + &unit
}

/// The number alone of a value in SI.
fn in_unit(si: f64, unit: &Unit, style: Style) -> String {
    match unit.sense {
        UnitMeaning::Level => scaled(unit.value(si), 1.0, 0, style),
        _ => scaled(si, unit.mantissa, unit.ten.into(), style),
    }
}

/// `value / (mantissa × 10^ten)` as text.
fn scaled(value: f64, mantissa: f64, ten: i32, style: Style) -> String {
    let minus = match (value < 0.0, style.ascii) {
        (false, _) => "",
        (true, true) => "-",
        (true, false) => "−",
    };
    if value == 0.0 {
        return "0".into();
    }
    if !value.is_finite() {
        // Never leaves an analysis; if it does, nobody can take it for a number.
        return if value.is_nan() { "undefined".into() } else { format!("{minus}infinite") };
    }
    let count = style.digits.clamp(1, 17).into();
    let (digits, exponent) = decimal::split(value.abs(), mantissa, ten, count);
    let digits = digits.trim_end_matches('0');
    let mark = match style.decimal {
        Decimal::Point => '.',
        Decimal::Comma => ',',
    };
    let plain = (-3..5).contains(&exponent);
    let number = place_mark(digits, if plain { exponent } else { 0 }, mark);
    match (plain, style.ascii) {
        (true, _) => format!("{minus}{number}"),
        (false, true) => format!("{minus}{number}e{exponent}"),
        (false, false) => format!("{minus}{number}×10{}", superscript(exponent)),
    }
}

/// `digits` with a decimal mark, the first of them worth 10^`exponent`.
fn place_mark(digits: &str, exponent: i32, mark: char) -> String {
    if exponent < 0 {
        let zeros = "0".repeat(exponent.unsigned_abs() as usize - 1);
        return format!("0{mark}{zeros}{digits}");
    }
    let whole = exponent as usize + 1;
    match digits.len().cmp(&whole) {
        Ordering::Greater => format!("{}{mark}{}", &digits[..whole], &digits[whole..]),
        Ordering::Equal | Ordering::Less => format!("{digits:0<whole$}"),
    }
}

fn known(text: &&'static str) -> Unit {
    unit(text).expect("the units of a kind are in the table")
}
