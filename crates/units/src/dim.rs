//! Exponents of the base dimensions of mechanics.

use std::{fmt, ops};

use crate::write::superscript;

/// Exponents of length, mass, time and plane angle.
///
/// The angle is a dimension of its own so that `Hz`, `rpm` and `rad/s` cannot be confused with `1/s`
/// when they are typed, and so that N·m/rad is distinguished from N·m. Formulas ignore it ([`Dim::agrees`]):
/// `v = ω r` is a length over a time.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Dim {
    /// Exponent of the metre.
    pub length: i8,
    /// Exponent of the kilogram.
    pub mass: i8,
    /// Exponent of the second.
    pub time: i8,
    /// Exponent of the radian.
    pub angle: i8,
}

impl Dim {
    /// A pure number.
    pub const NONE: Dim = Dim::new(0, 0, 0, 0);
    /// The metre.
    pub const LENGTH: Dim = Dim::new(1, 0, 0, 0);
    /// The kilogram.
    pub const MASS: Dim = Dim::new(0, 1, 0, 0);
    /// The second.
    pub const TIME: Dim = Dim::new(0, 0, 1, 0);
    /// The radian.
    pub const ANGLE: Dim = Dim::new(0, 0, 0, 1);

    /// The dimension m^`length` · kg^`mass` · s^`time` · rad^`angle`.
    #[must_use]
    pub const fn new(length: i8, mass: i8, time: i8, angle: i8) -> Self {
        Self { length, mass, time, angle }
    }

    /// This dimension to the power `n`. Exponents saturate at the ends of `i8`.
    #[must_use]
    pub const fn powi(self, n: i8) -> Self {
        Self::new(
            self.length.saturating_mul(n),
            self.mass.saturating_mul(n),
            self.time.saturating_mul(n),
            self.angle.saturating_mul(n),
        )
    }

    /// The `n`-th root, when the exponents of length, mass and time are multiples of `n`.
    ///
    /// The angle is no physical dimension: its exponent is rounded towards zero, so that
    /// √(k/m) has a root whether or not somebody wrote the radians.
    #[must_use]
    pub const fn root(self, n: u8) -> Option<Self> {
        if n == 0 || n > 127 {
            return None;
        }
        let n = n as i8;
        if self.length % n != 0 || self.mass % n != 0 || self.time % n != 0 {
            return None;
        }
        Some(Self::new(self.length / n, self.mass / n, self.time / n, self.angle / n))
    }

    /// This dimension to a power that need not be whole, when the exponents of length, mass and time stay whole; the
    /// exponent of the angle is rounded towards zero.
    #[must_use]
    pub fn powf(self, exponent: f64) -> Option<Self> {
        let whole = |n: i8| {
            let power = f64::from(n) * exponent;
            let rounded = power.round();
            ((power - rounded).abs() < 1e-9 && rounded.abs() <= f64::from(i8::MAX)).then_some(rounded as i8)
        };
        let angle = (f64::from(self.angle) * exponent).trunc() as i8;
        Some(Self::new(whole(self.length)?, whole(self.mass)?, whole(self.time)?, angle))
    }

    /// Returns true if two quantities may be compared or added: all exponents but that of the angle are equal.
    #[must_use]
    pub const fn agrees(self, other: Dim) -> bool {
        self.length == other.length && self.mass == other.mass && self.time == other.time
    }
}

impl ops::Mul for Dim {
    type Output = Dim;

    fn mul(self, other: Dim) -> Dim {
        Dim::new(
            self.length.saturating_add(other.length),
            self.mass.saturating_add(other.mass),
            self.time.saturating_add(other.time),
            self.angle.saturating_add(other.angle),
        )
    }
}

impl ops::Div for Dim {
    type Output = Dim;

    fn div(self, other: Dim) -> Dim {
        Dim::new(
            self.length.saturating_sub(other.length),
            self.mass.saturating_sub(other.mass),
            self.time.saturating_sub(other.time),
            self.angle.saturating_sub(other.angle),
        )
    }
}

/// `m·kg·s⁻²`, and `1` for a pure number.
impl fmt::Display for Dim {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let parts = [("m", self.length), ("kg", self.mass), ("s", self.time), ("rad", self.angle)];
        let mut product = "";
        for (symbol, power) in parts {
            if power != 0 {
                write!(f, "{product}{symbol}")?;
                product = "·";
            }
            if power != 0 && power != 1 {
                f.write_str(&superscript(power.into()))?;
            }
        }
        if product.is_empty() { f.write_str("1") } else { Ok(()) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const FORCE: Dim = Dim::new(1, 1, -2, 0);

    #[test]
    fn products_powers_and_roots() {
        assert_eq!(FORCE * Dim::LENGTH, Dim::new(2, 1, -2, 0));
        assert_eq!(FORCE / FORCE, Dim::NONE);
        assert_eq!(FORCE.powi(-2), Dim::new(-2, -2, 4, 0));
        assert_eq!(Dim::new(2, 4, -2, 1).root(2), Some(Dim::new(1, 2, -1, 0)));
        assert_eq!(Dim::new(2, 4, -2, -3).root(2), Some(Dim::new(1, 2, -1, -1)));
        assert_eq!(FORCE.root(2), None);
        assert_eq!(FORCE.root(0), None);
        assert_eq!(Dim::NONE.root(200), None);
    }

    #[test]
    fn powers_that_are_not_whole() {
        assert_eq!(Dim::new(2, 4, -2, 1).powf(0.5), Some(Dim::new(1, 2, -1, 0)));
        assert_eq!(Dim::new(3, 0, -3, -3).powf(1.0 / 3.0), Some(Dim::new(1, 0, -1, -1)));
        assert_eq!(Dim::new(1, 0, -1, 0).powf(-3.0), Some(Dim::new(-3, 0, 3, 0)));
        assert_eq!(FORCE.powf(0.0), Some(Dim::NONE));
        assert_eq!(FORCE.powf(0.5), None);
        assert_eq!(Dim::LENGTH.powf(1.0 / 3.0), None);
        assert_eq!(Dim::LENGTH.powf(1e-9), None);
        assert_eq!(Dim::LENGTH.powf(127.0), Some(Dim::LENGTH.powi(127)));
        assert_eq!(Dim::LENGTH.powf(128.0), None);
        assert_eq!(Dim::LENGTH.powf(f64::NAN), None);
    }

    #[test]
    fn exponents_saturate() {
        assert_eq!(Dim::LENGTH.powi(127) * Dim::LENGTH, Dim::LENGTH.powi(127));
        assert_eq!(Dim::TIME.powi(-128) / Dim::TIME, Dim::TIME.powi(-128));
        assert_eq!(Dim::LENGTH.powi(100).powi(100).length, 127);
    }

    #[test]
    fn the_angle_does_not_separate() {
        assert!(Dim::new(0, 0, -1, 1).agrees(Dim::new(0, 0, -1, 0)));
        assert!(!Dim::LENGTH.agrees(Dim::TIME));
    }

    #[test]
    fn written() {
        assert_eq!(FORCE.to_string(), "m·kg·s⁻²");
        assert_eq!(Dim::NONE.to_string(), "1");
        assert_eq!(Dim::new(0, 0, -1, 1).to_string(), "s⁻¹·rad");
    }
}
