//! A wrong answer, and how near another number comes to it.

use dalembert_units::Unit;

use super::{Verdict, compare, difference, half_a_place, read};
use crate::{Answer, Solution};

/// Wrong answers lie within such a factor of ours, give or take: the natural logarithm of 20. Over this range an
/// accidental hit is spread.
const SPREAD: f64 = 3.0;

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
    pub(super) fn of(solution: &'s Solution, name: &'s str, text: &str) -> Option<Self> {
        let answer = solution.answer(name)?;
        if text.trim().is_empty() || compare(answer, text) != Verdict::Wrong {
            return None;
        }
        let typed = read(answer, text).ok()?;
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

    /// Probability that a random number agrees with this answer.
    pub(super) fn accident(&self) -> f64 {
        if self.answered == 0.0 { 1.0 } else { (2.0 * self.within / (self.answered.abs() * SPREAD)).min(1.0) }
    }
}
