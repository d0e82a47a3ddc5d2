//! The last digit of a number, or another one, up and down.

use std::ops::Range;

/// A number of more significant digits than these was not typed to be changed in its last one.
const LONG: usize = 6;
/// Of such a number, the last of so many digits changes.
const KEPT: usize = 4;

/// A number and its unit with the last written digit changed by so many tenths: `20.3 mm` by 10 is `20.4 mm`.
///
/// A number of many digits, as a conversion of units writes it, changes in its fourth: `104.719755 rad/s` by 10 is
/// `104.819755 rad/s`.
///
/// Only the digits change; the decimal mark, an exponent and the unit stay as they are written. `None` where the text
/// is not one number, or has no room for more digits.
pub fn nudged(text: &str, tenths: i64) -> Option<String> {
    let trimmed = text.trim();
    let (negative, unsigned) = match trimmed.strip_prefix(['-', '−']) {
        Some(rest) => (true, rest),
        None => (false, trimmed.strip_prefix('+').unwrap_or(trimmed)),
    };
    let end = unsigned.find(|c: char| !c.is_ascii_digit() && c != '.' && c != ',').unwrap_or(unsigned.len());
    let (number, rest) = unsigned.split_at(end);
    // An expression has no last digit: 1/2 in, 2*pi, 3 + 4. A decimal exponent stays as it is.
    let unit = rest.trim_start();
    if unit.starts_with(['/', '+', '-', '−', '^', '(', '√'])
        || unit
            .strip_prefix(['*', '×', '·'])
            .is_some_and(|factor| !factor.trim_start().starts_with("10^") && !factor.starts_with("10⁻"))
    {
        return None;
    }
    let mark = number.find(['.', ',']);
    let (whole, decimals) = mark.map_or((number, ""), |at| (&number[..at], &number[at + 1..]));
    let mark = mark.map_or('.', |at| if number[at..].starts_with(',') { ',' } else { '.' });
    if whole.is_empty() && decimals.is_empty() || decimals.contains(['.', ',']) {
        return None;
    }
    let significant = format!("{whole}{decimals}").trim_start_matches('0').len();
    let coarse = if significant > LONG { 10_i64.checked_pow((significant - KEPT) as u32)? } else { 1 };
    // Tenths of the last digit need one decimal more.
    let (step, extra) = if tenths * coarse % 10 == 0 { (tenths * coarse / 10, "") } else { (tenths, "0") };
    let places = decimals.len() + extra.len();
    let digits: i64 = format!("{whole}{decimals}{extra}").parse().ok()?;
    if digits > 1_000_000_000_000_000 {
        return None;
    }
    let value = if negative { -digits } else { digits } + step;
    let shown = format!("{:0width$}", value.unsigned_abs(), width = places + 1);
    let (whole, decimals) = shown.split_at(shown.len() - places);
    let sign = if value < 0 { "-" } else { "" };
    let number = if places == 0 { whole.to_owned() } else { format!("{whole}{mark}{decimals}") };
    Some(format!("{sign}{number}{rest}"))
}

/// The digit that [`nudged`] changes by `10 × 10^place` tenths: its bytes in the text. `None` where the number has no
/// digit there.
pub fn digit_at(text: &str, place: u32) -> Option<Range<usize>> {
    let coarse = nudged(text, 10).and_then(|_| {
        let digits = |text: &str| text.chars().filter(char::is_ascii_digit).count();
        let begin = text.find(|c: char| c.is_ascii_digit())?;
        let number = &text[begin..];
        let end = number.find(|c: char| !c.is_ascii_digit() && c != '.' && c != ',').unwrap_or(number.len());
        let significant = digits(number[..end].trim_start_matches(['0', '.', ',']));
        let coarse = if significant > LONG { significant - KEPT } else { 0 };
        Some((begin..begin + end, coarse))
    });
    let (number, coarse) = coarse?;
    let begin = number.start;
    let mut digits = text[number].char_indices().rev().filter(|(_, c)| c.is_ascii_digit());
    digits.nth(coarse + place as usize).map(|(at, _)| begin + at..begin + at + 1)
}

#[cfg(test)]
mod tests {
    use super::*;
    use itertools::Itertools as _;

    #[test]
    fn the_last_digit_changes_and_nothing_else() {
        for (text, tenths, wanted) in [
            ("20.3 mm", 10, "20.4 mm"),
            ("20,3 mm", -10, "20,2 mm"),
            ("1000 rpm", 10, "1001 rpm"),
            ("1000 rpm", -100, "990 rpm"),
            ("1000 rpm", 1, "1000.1 rpm"),
            ("0.99", 10, "1.00"),
            ("1.00", -10, "0.99"),
            ("0.05 m", -100, "-0.05 m"),
            ("-3 N", 10, "-2 N"),
            ("1.3e-6 m^4", 10, "1.4e-6 m^4"),
            ("1.3×10^-6 m^4", 10, "1.4×10^-6 m^4"),
            ("7", 10, "8"),
            (".5", 10, "0.6"),
            ("104,719755 rad/s", 10, "104,819755 rad/s"),
            ("104.719755 rad/s", 1, "104.729755 rad/s"),
            ("0.0166666667 Hz", -10, "0.0166566667 Hz"),
            ("200000000 Pa", 100, "201000000 Pa"),
            ("1000.25 rpm", 10, "1000.26 rpm"),
        ] {
            assert_eq!(nudged(text, tenths).as_deref(), Some(wanted), "{text} by {tenths}");
        }
    }

    #[test]
    fn what_is_no_number_is_left_alone() {
        for text in ["", "abc", "1/2 in", "2*pi", "3 + 4", "1.2.3", "sqrt(2)", "99999999999999999999"] {
            assert_eq!(nudged(text, 10), None, "{text}");
        }
    }

    #[test]
    fn a_digit_is_where_it_changes() {
        for (text, place, digit) in [
            ("20.3 mm", 0, Some("3")),
            ("20.3 mm", 1, Some("0")),
            ("20.3 mm", 2, Some("2")),
            ("20.3 mm", 3, None),
            ("-1.5e-6 m^4", 1, Some("1")),
            ("104,719755 rad/s", 0, Some("7")),
            ("abc", 0, None),
        ] {
            let found = digit_at(text, place);
            assert_eq!(found.clone().map(|at| &text[at]), digit, "{text} at {place}");
            if let Some(at) = found {
                let up = nudged(text, 10 * 10_i64.pow(place)).unwrap();
                let changed = text.bytes().zip_eq(up.bytes()).position(|(a, b)| a != b);
                assert_eq!(changed, Some(at.start), "{text} becomes {up}");
            }
        }
    }

    #[test]
    fn up_and_down_comes_back() {
        for text in ["20.3 mm", "0.001 kg", "9.99", "100 N", "0.5"] {
            for tenths in [10, 100] {
                assert_eq!(nudged(&nudged(text, tenths).unwrap(), -tenths).as_deref(), Some(text));
            }
        }
    }
}
