//! Products and quotients: `3 E I / L³`.

use std::f64::consts::TAU;

use super::{
    Writer,
    constants::{Constant, has_factor},
};
use crate::trace::{Id, Number, Op};

/// Whole numbers up to this are multiplied with each other.
const LARGEST: f64 = 1e6;

/// One side of a fraction.
struct Side {
    /// Product of its whole numbers.
    whole: f64,
    factors: Vec<String>,
    /// Denominator of its numbers, which belongs to the other side.
    denominator: f64,
}

impl Writer<'_> {
    /// A product without its sign, and whether it is negative.
    pub(super) fn signed_product(&self, id: Id, negative: bool) -> (String, bool) {
        self.product(id, negative, false)
    }

    /// The same, over 2π if it is to be in turns.
    pub(super) fn product(&self, id: Id, negative: bool, in_turns: bool) -> (String, bool) {
        let (mut over, mut under) = (Vec::new(), Vec::new());
        let mut negative = negative;
        self.factors(id, false, &mut negative, &mut over, &mut under);
        let turn = over.iter().position(|id| self.bare_number(*id) == Some(TAU)).filter(|_| in_turns);
        if let Some(place) = turn {
            over.remove(place);
        }
        for number in over.iter().chain(&under).filter_map(|id| self.bare_number(*id)) {
            negative ^= number < 0.0;
        }
        let alone = over.len() == 1 && under.is_empty();
        let (over, under) = (self.side(&over, alone), self.side(&under, false));
        let side = |own: &Side, other: &Side| {
            let whole = own.whole * other.denominator;
            (whole != 1.0).then(|| self.bare(whole))
        };
        let top: Vec<String> = side(&over, &under).into_iter().chain(over.factors.iter().cloned()).collect();
        let turn = (in_turns && turn.is_none()).then(|| self.bare(TAU));
        let bottom = turn.into_iter().chain(side(&under, &over)).chain(under.factors.iter().cloned());
        let bottom: Vec<String> = bottom.collect();
        let top = if top.is_empty() { "1".to_owned() } else { self.joined(&top) };
        let text = match &bottom[..] {
            [] => top,
            [one] if has_factor(one) => format!("{top} / ({one})"),
            [one] => format!("{top} / {one}"),
            many => format!("{top} / ({})", self.joined(many)),
        };
        (text, negative)
    }

    /// The factors of a side as they are written, bare numbers first, equal ones as a power.
    fn side(&self, ids: &[Id], alone: bool) -> Side {
        let (mut whole, mut denominator, mut numbers, mut factors) = (1.0, 1.0, Vec::new(), Vec::new());
        let mut powers: Vec<(Id, i8)> = Vec::new();
        for id in ids {
            match self.bare_number(*id).map(f64::abs) {
                Some(number) => match Constant::of(number) {
                    Some(constant) => {
                        let numerator = constant.numerator(self.style, self.times());
                        numbers.extend(Some(numerator).filter(|numerator| numerator != "1"));
                        denominator *= f64::from(constant.denominator);
                    }
                    None if number.fract() == 0.0 && whole * number <= LARGEST => whole *= number,
                    None => numbers.push(self.bare(number)),
                },
                None => match powers.iter_mut().find(|(known, _)| self.are_equal(*known, *id)) {
                    Some((_, power)) => *power += 1,
                    None => powers.push((*id, 1)),
                },
            }
        }
        for (id, power) in powers {
            factors.push(match power {
                1 if alone => self.alone(id),
                1 => self.factor(id),
                power => format!("{}{}", self.base(id), self.power(power)),
            });
        }
        Side { whole, factors: numbers.into_iter().chain(factors).collect(), denominator }
    }

    fn factors(&self, id: Id, divide: bool, negative: &mut bool, over: &mut Vec<Id>, under: &mut Vec<Id>) {
        match self.op(id) {
            Op::Mul(a, b) => {
                self.factors(*a, divide, negative, over, under);
                self.factors(*b, divide, negative, over, under);
            }
            Op::Div(a, b) => {
                self.factors(*a, divide, negative, over, under);
                self.factors(*b, !divide, negative, over, under);
            }
            Op::Neg(a) => {
                *negative = !*negative;
                self.factors(*a, divide, negative, over, under);
            }
            _ if divide => under.push(id),
            _ => over.push(id),
        }
    }

    /// Returns true if two numbers are one quantity, or the same function of the same.
    fn are_equal(&self, one: Id, other: Id) -> bool {
        self.op(one) == self.op(other) && self.value(one) == self.value(other)
    }

    /// The number that a formula has as such.
    fn bare_number(&self, id: Id) -> Option<f64> {
        match (self.op(id), self.value(id)) {
            (Op::Literal, Number::Scalar(value)) => Some(value),
            _ => None,
        }
    }

    /// Returns true for a product with the bare number 0, or a power of one.
    pub(super) fn is_nothing(&self, id: Id) -> bool {
        match self.op(id) {
            Op::Mul(a, b) => self.is_nothing(*a) || self.is_nothing(*b),
            Op::Div(a, _) | Op::Neg(a) | Op::Power(a, 1..) => self.is_nothing(*a),
            _ => self.bare_number(id) == Some(0.0),
        }
    }
}
