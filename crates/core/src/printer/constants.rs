//! Exact forms of the numbers in formulas: `3π / 2`, `√3 / 2` and `1 / 6` in place of fifteen digits.

use std::f64::consts::PI;

use dalembert_units::{self as units, Style};

/// Largest denominator of a rational number.
const LARGEST: u32 = 4096;
/// Largest factor and denominator beside π or a root.
const LARGEST_BESIDE: u32 = 48;
/// Relative difference by which a constant may be off: it is the rounded result of a few operations.
const ROUNDING: f64 = 1e-15;
/// Digits of a number that is written as it is.
const SHORT: usize = 7;

/// `factor √root π^power / denominator`, all of them at least 1 but for the power.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Constant {
    factor: u32,
    root: u32,
    power: u8,
    pub(super) denominator: u32,
}

impl Constant {
    /// The form of a positive number that is not written in a few digits.
    pub(super) fn of(value: f64) -> Option<Self> {
        if !value.is_normal() || value <= 0.0 || is_short(value) {
            return None;
        }
        let of_power = |power: u8| {
            let largest = if power == 0 { LARGEST } else { LARGEST_BESIDE };
            let (factor, denominator) = ratio(value / PI.powi(power.into()), largest)?;
            (factor <= largest).then_some(Self { factor, root: 1, power, denominator })
        };
        [1, 2, 3, 4, 0].into_iter().find_map(of_power).or_else(|| Self::with_root(value))
    }

    /// `factor √root / denominator`.
    fn with_root(value: f64) -> Option<Self> {
        let (square, under) = ratio(value * value, LARGEST_BESIDE * LARGEST_BESIDE)?;
        // The root of the denominator is drawn out: √(3/4) = √3 / 2, and √(1/2) = √2 / 2.
        let (outside, inside) = drawn_out(square.checked_mul(under)?);
        let shared = gcd(outside, under);
        let form = Self { factor: outside / shared, root: inside, power: 0, denominator: under / shared };
        let limits = form.factor <= LARGEST_BESIDE && form.root <= LARGEST_BESIDE;
        (limits && form.denominator <= LARGEST_BESIDE).then_some(form)
    }

    /// `3π`, `1`, or `2 √3` with the sign of multiplication between them.
    pub(super) fn numerator(self, style: Style, times: &str) -> String {
        let Self { factor, root, power, .. } = self;
        let symbol = match (root, power, style.ascii) {
            (1, 0, _) => return factor.to_string(),
            (1, 1, false) => "π".to_owned(),
            (1, 1, true) => "pi".to_owned(),
            (1, _, false) => format!("π{}", units::superscript(power.into())),
            (1, _, true) => format!("pi^{power}"),
            (_, _, false) => format!("√{root}"),
            (_, _, true) => format!("sqrt({root})"),
        };
        match (factor, root, style.ascii) {
            (1, ..) => symbol,
            (_, 1, false) => format!("{factor}{symbol}"),
            (_, 1, true) => format!("{factor} {symbol}"),
            _ => format!("{factor}{times}{symbol}"),
        }
    }
}

/// Returns true if a number of a formula has a factor before π or a root: `2π`, `2 √3`.
pub(super) fn has_factor(number: &str) -> bool {
    let rest = number.trim_start_matches(|c: char| c.is_ascii_digit());
    let rest_begins = |start| rest.trim_start_matches([' ', '×', '*']).starts_with(start);
    rest.len() < number.len() && ["π", "√", "pi", "sqrt("].into_iter().any(rest_begins)
}

/// Returns true if a number has few digits.
fn is_short(value: f64) -> bool {
    let digits = format!("{value:e}");
    digits.split('e').next().unwrap_or_default().len() <= SHORT + 1
}

/// The whole numbers of which a positive number is the ratio, with a denominator up to a limit: a convergent of its
/// continued fraction.
fn ratio(value: f64, largest: u32) -> Option<(u32, u32)> {
    let ([mut above, mut factor], [mut below, mut denominator]) = ([0.0, 1.0], [1.0, 0.0]);
    let mut rest = value;
    loop {
        let whole = rest.floor();
        (above, factor) = (factor, whole * factor + above);
        (below, denominator) = (denominator, whole * denominator + below);
        if denominator > f64::from(largest) || factor > f64::from(u32::MAX) {
            return None;
        }
        if (factor / denominator / value - 1.0).abs() <= ROUNDING {
            return Some((factor as u32, denominator as u32));
        }
        rest = (rest - whole).recip();
    }
}

/// `outside² inside`, of which a number is the product, with the largest square.
fn drawn_out(number: u32) -> (u32, u32) {
    let outside = (1..=number.isqrt()).rev().find(|root| number.is_multiple_of(root * root)).unwrap_or(1);
    (outside, number / (outside * outside))
}

fn gcd(a: u32, b: u32) -> u32 {
    if b == 0 { a } else { gcd(b, a % b) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn constants_have_their_exact_form() {
        let ascii = Style { ascii: true, ..Style::default() };
        for (value, numerator, in_ascii, denominator) in [
            (PI, "π", "pi", 1),
            (2.0 * PI, "2π", "2 pi", 1),
            (3.0 * PI, "3π", "3 pi", 1),
            (PI / 2.0, "π", "pi", 2),
            (PI * PI * 4.0, "4π²", "4 pi^2", 1),
            (PI.powi(3) / 8.0, "π³", "pi^3", 8),
            (1.0 / 6.0, "1", "1", 6),
            (11.0 / 3072.0, "11", "11", 3072),
            ((PI / 6.0).cos(), "√3", "sqrt(3)", 2),
            (0.5f64.sqrt(), "√2", "sqrt(2)", 2),
            (12f64.sqrt(), "2 √3", "2 sqrt(3)", 1),
            (6f64.sqrt(), "√6", "sqrt(6)", 1),
        ] {
            let form = Constant::of(value).unwrap_or_else(|| panic!("{value} has no form"));
            assert_eq!(form.numerator(Style::default(), " "), numerator, "{value}");
            assert_eq!((form.numerator(ascii, " "), form.denominator), (in_ascii.to_owned(), denominator));
        }
        // Short numbers, and numbers that are nothing else, stay as they are.
        for value in [
            0.0,
            1.0,
            0.5,
            48.0,
            1.875,
            0.0625,
            9.806_65,
            1.875_104_068_711_961,
            4.888_123_762_813_26,
            1e-300,
        ] {
            assert_eq!(Constant::of(value), None, "{value}");
        }
    }
}
