//! A wrong answer, and how near another number comes to it.

use std::f64::consts::LN_10;

use dalembert_units::Unit;

use super::{Verdict, ambiguous_zeros, compare, difference, half_a_place, read};
use crate::{Answer, Solution};

/// Share of the numbers that a person may have come to by accident which lie within [`NEAR`] of ours.
const SHARE_NEAR: f64 = 0.5;
/// Relative distance of the near ones.
const NEAR: f64 = 0.2;
/// The others are spread evenly over the logarithm, within this factor of ours either way.
const FACTOR: f64 = 10.0;
/// Decades that a number is spread evenly over where ours is zero, which says nothing of its size.
const DECADES: f64 = 6.0;

/// Share of the mistakes that we do not know which change a number in a simple ratio: half of it, two thirds, three times.
const SHARE_SIMPLE: f64 = 0.3;
/// Ratios of whole numbers up to here are simple.
const SIMPLE: u32 = 12;
/// Sum over all fractions p/q in lowest terms of (p q)^−3/2, ζ(3/2)²/ζ(3), one among them.
const SUM_OF_SIMPLE: f64 = 5.68;

/// Digits of a whole number that ends in zeros, such as 45 000.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Digits {
    /// Every zero is a digit.
    AsWritten,
    /// The zeros at the end may only say how large it is.
    Sure,
}

/// A wrong answer.
pub(super) struct Wrong<'s> {
    pub(super) name: &'s str,
    pub(super) answer: &'s Answer,
    /// Ours and the user's, in SI.
    pub(super) computed: f64,
    pub(super) answered: f64,
    /// The unit that was typed.
    pub(super) unit: Unit,
    /// Tolerance of the comparison, in SI: half of the last place of the user's answer, within the general tolerance.
    pub(super) within: f64,
}

impl<'s> Wrong<'s> {
    /// An answer that differs from ours in the digits that were given.
    pub(super) fn of(solution: &'s Solution, name: &'s str, text: &str, digits: Digits) -> Option<Self> {
        let answer = solution.answer(name)?;
        let is_wrong = matches!(compare(answer, text), Verdict::Wrong | Verdict::RoundedEarly(_));
        if text.trim().is_empty() || !is_wrong {
            return None;
        }
        let mut typed = read(answer, text).ok()?;
        if digits == Digits::AsWritten {
            typed.last_place /= ambiguous_zeros(text);
        }
        // What agrees with everything says nothing.
        let within = half_a_place(&typed).min(super::TOLERANCE * typed.si.abs());
        Some(Self { name, answer, computed: answer.si()?, answered: typed.si, unit: typed.unit, within })
    }

    pub(super) fn is(&self, value: f64) -> bool {
        difference(self.answered, value, self.answer.dim()) <= self.within + 1e-12 * self.answered.abs()
    }

    /// The same for a value that was computed from numbers that the user rounded.
    pub(super) fn nearly(&self, value: f64) -> bool {
        self.is(value)
            || difference(self.answered, value, self.answer.dim()) <= super::TOLERANCE * self.answered.abs()
    }

    /// Relative distance of the user's answer from a value, in tolerances of its digits.
    pub(super) fn distance(&self, value: f64) -> f64 {
        difference(self.answered, value, self.answer.dim()) / self.within.max(1e-300)
    }

    /// Probability that a number without a cause agrees with a value to the digits that were given. Such numbers lie within
    /// a factor of ten of ours, half of them near it.
    pub(super) fn accident(&self, value: f64) -> f64 {
        if self.answered == 0.0 || value == 0.0 {
            return 1.0;
        }
        let width = 2.0 * self.within / self.answered.abs();
        if self.computed == 0.0 {
            return (width / (DECADES * LN_10)).min(1.0);
        }
        let ratio = (value / self.computed).abs();
        let near = if (ratio - 1.0).abs() <= NEAR { SHARE_NEAR / (2.0 * NEAR) } else { 0.0 };
        // Beyond the factor there are fewer, but there are some.
        let far = (1.0 - SHARE_NEAR) / (2.0 * FACTOR.ln())
            * if ratio.ln().abs() <= FACTOR.ln() { 1.0 } else { 0.2 };
        (width * (near + far)).min(1.0)
    }

    /// Probability that a mistake we do not know leads to a value: data are round numbers, so that many of the wrong ones are
    /// in a simple ratio p/q to ours, the less often the larger p q is.
    pub(super) fn by_unknown(&self, value: f64) -> f64 {
        let ratio = (value / self.computed).abs();
        let is_it = |p: u32, q: u32| (ratio * f64::from(q) - f64::from(p)).abs() <= 1e-9 * f64::from(p);
        let over = |q: u32| (1..=SIMPLE).filter(move |p| *p != q).find(|p| is_it(*p, q));
        let simple = (1..=SIMPLE).find_map(|q| Some(q * over(q)?));
        let simple = simple.map_or(0.0, |pq| SHARE_SIMPLE / SUM_OF_SIMPLE * f64::from(pq).powf(-1.5));
        self.accident(value).max(simple)
    }
}

/// True if two computed numbers are one, within rounding.
pub(super) fn is_near(one: f64, other: f64) -> bool {
    (one - other).abs() <= 1e-9 * other.abs()
}

/// True if a value is ours, within rounding.
pub(super) fn is_computed(one: &Wrong<'_>, value: f64) -> bool {
    difference(value, one.computed, one.answer.dim()) <= 1e-9 * one.computed.abs().max(1e-300)
}
