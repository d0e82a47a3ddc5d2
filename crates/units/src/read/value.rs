//! Values of an expression while it is computed.

use super::scan::Literal;
use crate::{Dim, scale::Scale};

/// Number of quantities with units in a product.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Quantities {
    /// One at most.
    One,
    /// A number came after a unit: the unit of that number, if one follows, is another.
    Begun,
    /// Two or more.
    Several,
}

/// A value on the way: `number` of a unit made of `symbols`.
pub(super) struct Value<'t> {
    pub(super) number: f64,
    /// The number as written, as long as nothing but units came to it.
    pub(super) literal: Option<Literal<'t>>,
    pub(super) scale: Scale,
    /// The symbols of the unit with their powers, in the order in which they came.
    pub(super) symbols: Vec<(&'static str, i8)>,
    /// A number was written, not a unit alone.
    pub(super) written: bool,
    /// A unit was written, even if it cancelled out.
    pub(super) has_unit: bool,
    /// Quantities with units that were multiplied or divided.
    pub(super) quantities: Quantities,
    /// The exponent of the angle that angular velocities among those quantities brought: it drops out of `m e ω²`.
    pub(super) rate: i8,
    /// A unit stands behind an operator or alone, where a formula would have a name.
    pub(super) ambiguous: bool,
}

impl<'t> Value<'t> {
    pub(super) fn number(number: f64) -> Self {
        Value {
            number,
            literal: None,
            scale: Scale::ONE,
            symbols: Vec::new(),
            written: true,
            has_unit: false,
            quantities: Quantities::One,
            rate: 0,
            ambiguous: false,
        }
    }

    pub(super) fn times(self, other: &Value<'t>) -> Value<'t> {
        // A literal stays one while it meets units alone.
        let literal = match (self.written, other.written) {
            (true, false) => self.literal,
            (false, true) => other.literal,
            _ => None,
        };
        let rate = self.rate_with(other, 1);
        let quantities = self.quantities_with(other);
        let mut symbols = self.symbols;
        other.symbols.iter().for_each(|&(symbol, n)| merge(&mut symbols, symbol, n));
        Value {
            number: self.number * other.number,
            literal,
            scale: self.scale.times(other.scale),
            symbols,
            written: self.written || other.written,
            has_unit: self.has_unit || other.has_unit,
            quantities,
            rate,
            ambiguous: self.ambiguous || other.ambiguous,
        }
    }

    pub(super) fn over(self, other: &Value<'t>) -> Value<'t> {
        let literal = if other.written { None } else { self.literal };
        let rate = self.rate_with(other, -1);
        let quantities = self.quantities_with(other);
        let mut symbols = self.symbols;
        other.symbols.iter().for_each(|&(symbol, n)| merge(&mut symbols, symbol, n.saturating_neg()));
        Value {
            number: self.number / other.number,
            literal,
            scale: self.scale.over(other.scale),
            symbols,
            written: self.written || other.written,
            has_unit: self.has_unit || other.has_unit,
            quantities,
            rate,
            ambiguous: self.ambiguous || other.ambiguous,
        }
    }

    fn quantities_with(&self, other: &Value) -> Quantities {
        use Quantities::{Begun, One, Several};
        let both = self.has_unit && other.has_unit;
        match (self.quantities, other.quantities) {
            (Several, _) | (_, Several) => Several,
            (Begun, _) if both => Several,
            _ if both && self.written && other.written => Several,
            (Begun, _) => Begun,
            _ if self.written && self.has_unit && other.written && !other.has_unit => Begun,
            _ => One,
        }
    }

    /// The angle brought by angular velocities when `other` multiplies (`sign` 1) or divides (−1).
    fn rate_with(&self, other: &Value, sign: i8) -> i8 {
        let of = |value: &Value| match value.scale.dim {
            Dim { length: 0, mass: 0, time, angle } if time != 0 => angle,
            _ => value.rate,
        };
        of(self).saturating_add(of(other).saturating_mul(sign))
    }

    /// This value to a whole power.
    pub(super) fn unit_powi(mut self, n: i8) -> Self {
        self.scale = self.scale.powi(n);
        self.symbols.iter_mut().for_each(|(_, power)| *power = power.saturating_mul(n));
        self.symbols.retain(|&(_, power)| power != 0);
        self.rate = self.rate.saturating_mul(n);
        self
    }

    pub(super) fn negated(self) -> Value<'t> {
        let literal = self.literal.map(Literal::negated);
        Value { number: -self.number, literal, ..self }
    }
}

fn merge(symbols: &mut Vec<(&'static str, i8)>, symbol: &'static str, n: i8) {
    match symbols.iter_mut().find(|(other, _)| *other == symbol) {
        Some((_, power)) => *power = power.saturating_add(n),
        None => symbols.push((symbol, n)),
    }
    symbols.retain(|&(_, power)| power != 0);
}

/// `N*m^2/(rad*s)`.
pub(crate) fn compose(symbols: &[(&str, i8)]) -> String {
    let product = |sign: i8| {
        let parts: Vec<_> = symbols
            .iter()
            .filter(|(_, n)| n.signum() == sign)
            .map(|(symbol, n)| match n.unsigned_abs() {
                1 => (*symbol).to_owned(),
                n => format!("{symbol}^{n}"),
            })
            .collect();
        (parts.len(), parts.join("*"))
    };
    let (above, below) = (product(1), product(-1));
    match (above, below) {
        ((_, above), (0, _)) => above,
        ((0, _), (1, below)) => format!("1/{below}"),
        ((0, _), (_, below)) => format!("1/({below})"),
        ((_, above), (1, below)) => format!("{above}/{below}"),
        ((_, above), (_, below)) => format!("{above}/({below})"),
    }
}
