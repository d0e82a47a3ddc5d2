//! Answers as a user would write them: numbers, lists, and sets such as `≤ 113.4 mm or ≥ 439.9 mm`.

use std::ops::Bound;

use dalembert_numerics::intervals::{Interval, IntervalSet};
use dalembert_units as units;

use super::number;
use crate::{Answer, Locale, Text, solution::AnswerValue};

impl Answer {
    /// The answer in words and numbers.
    pub fn shown(&self, locale: &Locale) -> String {
        let locale = &self.digits.map_or(*locale, |digits| locale.digits(digits));
        match &self.value {
            AnswerValue::Number(value, _) => {
                number(value.without_noise(self.noise), &self.unit, locale.style)
            }
            AnswerValue::Set(set, _) => set_text(set, &self.unit, locale),
            AnswerValue::List(numbers) => {
                let clean = |x: &f64| if x.abs() <= self.noise { 0.0 } else { *x };
                let numbers: Vec<f64> = numbers.iter().map(clean).collect();
                match numbers[..] {
                    [one] => units::write_quantity(one, &self.unit, locale.style),
                    _ => units::write_components(&numbers, &self.unit, locale.style),
                }
            }
        }
    }
}

/// A set of positive numbers in SI: `≤ 113.4 mm or ≥ 439.9 mm`, `every value`, `no value`.
fn set_text(set: &IntervalSet, unit: &units::Unit, locale: &Locale) -> String {
    if set.is_none() {
        return Text::new("no value").render(locale);
    }
    let shown = |si: f64| units::write_quantity(si, unit, locale.style);
    let sign =
        |strict: &'static str, (ascii, unicode): (&'static str, &'static str), bound: Bound<f64>| match bound
        {
            Bound::Excluded(_) => strict,
            _ if locale.style.ascii => ascii,
            _ => unicode,
        };
    let part = |interval: Interval| {
        // Lengths, stiffnesses and speeds begin at zero: that end is no limit.
        let lower = match interval.lower {
            Bound::Included(x) | Bound::Excluded(x) if x > 0.0 => Some(x),
            _ => None,
        };
        let upper = match interval.upper {
            Bound::Included(x) | Bound::Excluded(x) => Some(x),
            Bound::Unbounded => None,
        };
        match (lower, upper) {
            (None, None) => Text::new("every value").render(locale),
            (None, Some(x)) => format!("{} {}", sign("<", ("<=", "≤"), interval.upper), shown(x)),
            (Some(x), None) => format!("{} {}", sign(">", (">=", "≥"), interval.lower), shown(x)),
            (Some(from), Some(to)) => format!("{} … {}", shown(from), shown(to)),
        }
    };
    let or = Text::new("or").render(locale);
    set.intervals().map(part).collect::<Vec<_>>().join(&format!(" {or} "))
}
