//! The size and dimension of a unit while it is put together.

use crate::{Dim, UnitMeaning, decimal};

/// `mantissa × 10^ten` SI units of a dimension.
///
/// The power of ten is kept apart so that a decimal prefix can be put into the exponent of a literal.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Scale {
    pub(crate) mantissa: f64,
    pub(crate) ten: i16,
    pub(crate) dim: Dim,
    pub(crate) sense: UnitMeaning,
}

impl Scale {
    pub(crate) const ONE: Scale = Scale { mantissa: 1.0, ten: 0, dim: Dim::NONE, sense: UnitMeaning::Plain };

    pub(crate) fn times(self, other: Scale) -> Scale {
        Scale {
            mantissa: self.mantissa * other.mantissa,
            ten: self.ten.saturating_add(other.ten),
            dim: self.dim * other.dim,
            sense: self.sense.with(other.sense),
        }
    }

    pub(crate) fn over(self, other: Scale) -> Scale {
        Scale {
            mantissa: self.mantissa / other.mantissa,
            ten: self.ten.saturating_sub(other.ten),
            dim: self.dim / other.dim,
            sense: self.sense.with(other.sense),
        }
    }

    pub(crate) fn powi(self, n: i8) -> Scale {
        let power = Scale {
            mantissa: self.mantissa.powi(n.unsigned_abs().into()),
            ten: self.ten.saturating_mul(n.unsigned_abs().into()),
            dim: self.dim.powi(n.saturating_abs()),
            sense: self.sense,
        };
        if n < 0 { Scale { sense: self.sense, ..Scale::ONE.over(power) } } else { power }
    }

    /// One of this unit in SI.
    pub(crate) fn factor(self) -> f64 {
        decimal::shift(self.mantissa, self.ten.into())
    }

    /// The energy sense holds for an energy alone: W makes a power, J/m a force.
    pub(crate) fn settled(self) -> Scale {
        let energy = Dim::new(2, 1, -2, 0);
        let sense = if self.sense == UnitMeaning::Energy && self.dim != energy {
            UnitMeaning::Plain
        } else {
            self.sense
        };
        Scale { sense, ..self }
    }

    /// Small enough to compute with: what is beyond is a slip, and would lose its exponents.
    pub(crate) fn is_sane(self) -> bool {
        let Dim { length, mass, time, angle } = self.dim;
        let factor = self.factor();
        [length, mass, time, angle].iter().all(|n| n.unsigned_abs() <= 30)
            && factor.is_finite()
            && factor > 1e-300
    }
}

impl UnitMeaning {
    fn with(self, other: UnitMeaning) -> UnitMeaning {
        if self == UnitMeaning::Plain { other } else { self }
    }
}
