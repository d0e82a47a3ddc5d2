#![doc = include_str!("../README.md")]
//!
//! Physical dimensions and units: `"20.3 mm"` in, `0.0203` and a length out, and back again.
//!
//! Inside the program everything is `f64` in SI. Units exist only where a user reads or writes, and what is
//! written can be read again.

mod decimal;
mod dim;
mod kind;
mod read;
mod scale;
mod system;
mod table;
mod write;

use std::borrow::Cow;

use scale::Scale;

pub use crate::{
    dim::Dim,
    kind::Kind,
    read::{
        Hint, ReadError, WrongKind, group_mark, is_invisible, meant_unit, quantity_of, read_any, read_count,
        read_quantity, read_vector, thousands, unit, vulgar_fraction, with_comma, with_point,
    },
    system::UnitSystem,
    table::{Spelling, spellings, unit_of_two_words},
    write::{
        Decimal, Style, best_unit, subscript, superscript, write_components, write_number, write_quantity,
        write_vector,
    },
};

/// A unit as written.
#[derive(Clone, Debug, PartialEq)]
pub struct Unit {
    /// One of this unit in SI. A level (dB) has no factor: use [`Unit::si`] and [`Unit::value`].
    pub factor: f64,
    /// Dimension of the unit.
    pub dim: Dim,
    /// The text it was written as.
    pub text: Cow<'static, str>,
    /// Meaning of the unit beyond size and dimension.
    pub sense: UnitMeaning,
    /// The factor is `mantissa × 10^ten`, kept apart so that a decimal prefix can be put into the
    /// exponent of a literal: 20.3 mm is then exactly the number nearest to 0.0203.
    mantissa: f64,
    ten: i16,
}

/// Meaning of a unit beyond size and dimension.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum UnitMeaning {
    /// Nothing more.
    #[default]
    Plain,
    /// A unit of energy (J, kWh): a torque is not written in it.
    Energy,
    /// A level of an amplitude ratio: 20 log₁₀ of it, in decibels.
    Level,
    /// The peak value of an oscillation, said expressly.
    Peak,
    /// The distance from peak to peak of an oscillation: twice its amplitude.
    PeakToPeak,
    /// The root mean square of an oscillation: its amplitude over √2.
    Rms,
}

impl Unit {
    /// The unit of a pure number, written as nothing.
    pub const ONE: Unit = Unit {
        factor: 1.0,
        dim: Dim::NONE,
        text: Cow::Borrowed(""),
        sense: UnitMeaning::Plain,
        mantissa: 1.0,
        ten: 0,
    };

    /// The SI value of `value` of this unit.
    #[inline]
    pub fn si(&self, value: f64) -> f64 {
        match self.sense {
            UnitMeaning::Level => 10f64.powf(value / 20.0),
            _ => value * self.factor,
        }
    }

    /// Converts an SI value to this unit.
    #[inline]
    pub fn value(&self, si: f64) -> f64 {
        match self.sense {
            UnitMeaning::Level => 20.0 * si.log10(),
            _ => si / self.factor,
        }
    }

    /// Returns true for an SI unit or a decimal multiple of one: `rad/s` and `mrad` are, `rpm`, `deg` and `in` are not.
    pub fn is_decimal(&self) -> bool {
        self.mantissa == 1.0
    }

    /// For the screen: `N·m²`. Empty for a pure number.
    pub fn pretty(&self) -> String {
        write::unit_text(self, false)
    }

    /// In ASCII, can be typed: `N*m^2`. Empty for a pure number.
    pub fn ascii(&self) -> String {
        write::unit_text(self, true)
    }

    /// The coherent SI unit of the same quantity, in ASCII: `N` for `lbf`, `rad/s` for `rpm`, and `1` for a pure number.
    pub fn coherent(&self) -> String {
        let sense = if self.sense == UnitMeaning::Energy { UnitMeaning::Energy } else { UnitMeaning::Plain };
        let kind = Kind::of(&Unit { sense, ..self.clone() });
        let mut of_kind = kind.units().iter().filter_map(|symbol| unit(symbol).ok());
        match of_kind.find(|unit| unit.factor == 1.0 && unit.dim == self.dim && unit.sense == sense) {
            Some(unit) if !unit.text.is_empty() => unit.ascii(),
            _ if self.dim == Dim::NONE || self.sense == UnitMeaning::Level => "1".to_owned(),
            _ => {
                let powers = [
                    ("kg", self.dim.mass),
                    ("m", self.dim.length),
                    ("s", self.dim.time),
                    ("rad", self.dim.angle),
                ];
                let powers: Vec<(&str, i8)> = powers.into_iter().filter(|(_, power)| *power != 0).collect();
                read::compose(&powers)
            }
        }
    }

    /// As [`ascii`](Self::ascii) or as [`pretty`](Self::pretty).
    pub fn shown(&self, ascii: bool) -> String {
        write::unit_text(self, ascii)
    }

    fn new(scale: Scale, text: Cow<'static, str>) -> Unit {
        let scale = scale.settled();
        let Scale { mantissa, ten, dim, sense } = scale;
        Unit { factor: scale.factor(), dim, text, sense, mantissa, ten }
    }

    fn scale(&self) -> Scale {
        Scale { mantissa: self.mantissa, ten: self.ten, dim: self.dim, sense: self.sense }
    }
}

/// A number with the unit it was written in.
#[derive(Clone, Debug, PartialEq)]
pub struct Quantity {
    /// The value in SI; an amplitude as its peak value, a level as its ratio.
    pub si: f64,
    /// The unit it was written in.
    pub unit: Unit,
    /// One unit in the last written place, in SI: `1674.2 N*mm` gives 10⁻⁴. Zero for an arithmetic
    /// expression, which is exact.
    pub last_place: f64,
}

/// Two or three components with the unit they were written in.
#[derive(Clone, Debug, PartialEq)]
pub struct VectorQuantity {
    /// The components in SI; the third is zero when two were written.
    pub si: [f64; 3],
    /// Number of components written: 2 or 3.
    pub len: usize,
    /// The unit they were written in.
    pub unit: Unit,
    /// One unit in the last written place, in SI, of the component with the fewest decimals.
    pub last_place: f64,
}
