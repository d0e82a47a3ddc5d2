//! Enclosures of a formula and of its derivative, by automatic differentiation.

use std::{
    f64::consts::LN_10,
    ops::{Add, Div, Mul, Neg, Sub},
};

use super::Enclosure;

/// Enclosures of a formula of one variable and of its derivative.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Jet {
    /// Value.
    pub value: Enclosure,
    /// Derivative with respect to the variable; all numbers where the formula jumps.
    pub slope: Enclosure,
}

impl Jet {
    /// A number that does not depend on the variable.
    pub fn constant(x: f64) -> Self {
        Self { value: Enclosure::point(x), slope: Enclosure::ZERO }
    }

    /// The variable in an interval.
    pub fn variable([from, to]: [f64; 2]) -> Self {
        Self { value: Enclosure::new(from, to), slope: Enclosure::point(1.0) }
    }

    /// A function of it, and the derivative of the function.
    fn chain(self, value: Enclosure, derivative: Enclosure) -> Self {
        Self {
            value,
            slope: if self.slope == Enclosure::ZERO { self.slope } else { derivative * self.slope },
        }
    }

    /// `xⁿ`
    #[must_use]
    pub fn powi(self, n: i8) -> Self {
        let x = self.value;
        let derivative = match n.checked_sub(1) {
            Some(below) if n != 0 => Enclosure::point(f64::from(n)) * x.powi(below),
            Some(_) => Enclosure::ZERO,
            None => Enclosure::ALL,
        };
        self.chain(x.powi(n), derivative)
    }

    /// The `n`th root.
    #[must_use]
    pub fn root(self, n: u8) -> Self {
        let root = self.value.root(n);
        let below = Enclosure::point(f64::from(n)) * root.powi(i8::try_from(n).unwrap_or(i8::MAX) - 1);
        let derivative = if below.low <= 0.0 && below.high > 0.0 {
            Enclosure::new(1.0 / below.high.next_up(), f64::INFINITY)
        } else {
            Enclosure::point(1.0) / below
        };
        self.chain(root, derivative)
    }

    /// `xʸ`
    #[must_use]
    pub fn pow(self, exponent: Self) -> Self {
        let power = self.value.pow(exponent.value);
        if exponent.slope == Enclosure::ZERO {
            return self.chain(power, exponent.value * power / self.value);
        }
        let slope = power * (exponent.slope * self.value.ln() + exponent.value * self.slope / self.value);
        Self { value: power, slope }
    }

    /// `|x|`
    #[must_use]
    pub fn abs(self) -> Self {
        let derivative = match () {
            () if self.value.low > 0.0 => Enclosure::point(1.0),
            () if self.value.high < 0.0 => Enclosure::point(-1.0),
            () => Enclosure::new(-1.0, 1.0),
        };
        self.chain(self.value.abs(), derivative)
    }

    /// The smaller of two.
    #[must_use]
    pub fn min(self, other: Self) -> Self {
        -(-self).max(-other)
    }

    /// The larger of two.
    #[must_use]
    pub fn max(self, other: Self) -> Self {
        let slope = match () {
            () if self.value.low > other.value.high => self.slope,
            () if other.value.low > self.value.high => other.slope,
            () => self.slope.hull(other.slope),
        };
        Self { value: self.value.max(other.value), slope }
    }

    /// `sin x`
    #[must_use]
    pub fn sin(self) -> Self {
        self.chain(self.value.sin(), self.value.cos())
    }

    /// `cos x`
    #[must_use]
    pub fn cos(self) -> Self {
        self.chain(self.value.cos(), -self.value.sin())
    }

    /// `tan x`
    #[must_use]
    pub fn tan(self) -> Self {
        let tan = self.value.tan();
        self.chain(tan, Enclosure::point(1.0) + tan.powi(2))
    }

    /// `arcsin x`
    #[must_use]
    pub fn asin(self) -> Self {
        self.chain(self.value.asin(), self.inverse_of_arc())
    }

    /// `arccos x`
    #[must_use]
    pub fn acos(self) -> Self {
        self.chain(self.value.acos(), -self.inverse_of_arc())
    }

    /// `1/√(1 − x²)`
    fn inverse_of_arc(self) -> Enclosure {
        let below = (Enclosure::point(1.0) - self.value.powi(2)).sqrt();
        if below.low > 0.0 { Enclosure::point(1.0) / below } else { Enclosure::new(1.0, f64::INFINITY) }
    }

    /// `eˣ`
    #[must_use]
    pub fn exp(self) -> Self {
        let exp = self.value.exp();
        self.chain(exp, exp)
    }

    /// `ln x`
    #[must_use]
    pub fn ln(self) -> Self {
        self.chain(self.value.ln(), Enclosure::point(1.0) / self.value)
    }

    /// `log₁₀ x`
    #[must_use]
    pub fn log10(self) -> Self {
        let ten = Enclosure::new(LN_10.next_down(), LN_10.next_up());
        self.chain(self.value.log10(), Enclosure::point(1.0) / (ten * self.value))
    }

    /// `sinh x`
    #[must_use]
    pub fn sinh(self) -> Self {
        self.chain(self.value.sinh(), self.value.cosh())
    }

    /// `cosh x`
    #[must_use]
    pub fn cosh(self) -> Self {
        self.chain(self.value.cosh(), self.value.sinh())
    }

    /// `tanh x`
    #[must_use]
    pub fn tanh(self) -> Self {
        let tanh = self.value.tanh();
        self.chain(tanh, (Enclosure::point(1.0) - tanh.powi(2)).within([0.0, 1.0]))
    }

    /// The angle of the direction `(x, self)`.
    #[must_use]
    pub fn atan2(self, x: Self) -> Self {
        let value = self.value.atan2(x.value);
        if self.slope == Enclosure::ZERO && x.slope == Enclosure::ZERO {
            return Self { value, slope: Enclosure::ZERO };
        }
        if self.value.meets_cut(x.value) {
            return Self { value, slope: Enclosure::ALL };
        }
        let across = self.slope * x.value - self.value * x.slope;
        Self { value, slope: across / (self.value.powi(2) + x.value.powi(2)) }
    }
}

impl Neg for Jet {
    type Output = Self;
    fn neg(self) -> Self {
        Self { value: -self.value, slope: -self.slope }
    }
}

impl Add for Jet {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self { value: self.value + other.value, slope: self.slope + other.slope }
    }
}

impl Sub for Jet {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Jet {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let slope = self.slope * other.value + self.value * other.slope;
        Self { value: self.value * other.value, slope }
    }
}

impl Div for Jet {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let value = self.value / other.value;
        let slope = (self.slope - value * other.slope) / other.value;
        Self { value, slope }
    }
}
