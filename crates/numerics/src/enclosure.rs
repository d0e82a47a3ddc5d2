//! Interval arithmetic with outward rounding: enclosures of what formulas give for every number of an interval, and of
//! their derivatives.
//!
//! Sums, products, quotients and square roots are rounded to nearest and then moved outwards to the next number; the
//! functions of the standard library are moved outwards by [`ULPS`] units in the last place, twice the largest error that
//! the libraries of the usual systems state. An enclosure says whether the formula is defined for all of the interval:
//! where it is not, it holds for the part where it is. R. E. Moore, R. B. Kearfott and M. J. Cloud, *Introduction to
//! Interval Analysis* (SIAM, 2009), ch. 2, 5 and 6.
//!
//! ```
//! use dalembert_numerics::enclosure::Enclosure;
//!
//! // Natural frequency √(k/m) of a stiffness from 900 to 1600 N/m and a mass from 1 to 4 kg: from 15 to 40 rad/s.
//! let (stiffness, mass) = (Enclosure::new(900.0, 1600.0), Enclosure::new(1.0, 4.0));
//! let frequency = (stiffness / mass).sqrt();
//! assert!(frequency.is_defined && frequency.contains(15.0) && frequency.contains(40.0));
//! assert!(frequency.low > 15.0 - 1e-13 && frequency.high < 40.0 + 1e-13);
//! // The formula has no value for a part of these numbers.
//! assert!(!Enclosure::new(-1.0, 4.0).sqrt().is_defined);
//! ```

mod jet;

use std::{
    f64::consts::{FRAC_PI_2, PI, TAU},
    ops::{Add, Div, Mul, Neg, Sub},
};

pub use self::jet::Jet;

/// Units in the last place by which functions of the standard library are moved outwards.
pub const ULPS: f64 = 4.0;

/// Numbers from `low` to `high`; none where `low > high`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Enclosure {
    /// Lower end.
    pub low: f64,
    /// Upper end.
    pub high: f64,
    /// True where the formula has a value for every number that it was taken of.
    pub is_defined: bool,
}

impl Enclosure {
    /// All numbers.
    pub const ALL: Self = Self { low: f64::NEG_INFINITY, high: f64::INFINITY, is_defined: true };
    /// All numbers or none: of a formula that is not defined everywhere.
    pub const UNDEFINED: Self = Self { is_defined: false, ..Self::ALL };
    /// No number.
    pub const NONE: Self = Self { low: f64::INFINITY, high: f64::NEG_INFINITY, is_defined: false };
    const ZERO: Self = Self { low: 0.0, high: 0.0, is_defined: true };

    /// The numbers between two.
    pub fn new(low: f64, high: f64) -> Self {
        if low.is_nan() || high.is_nan() { Self::UNDEFINED } else { Self { low, high, is_defined: true } }
    }

    /// One number.
    pub fn point(x: f64) -> Self {
        Self::new(x, x)
    }

    /// Returns true if there is no number in it.
    pub fn is_none(self) -> bool {
        self.low > self.high
    }

    /// Returns true if it holds a number.
    pub fn contains(self, x: f64) -> bool {
        self.low <= x && x <= self.high
    }

    /// The numbers from the least to the largest of both.
    #[must_use]
    pub fn hull(self, other: Self) -> Self {
        Self {
            low: self.low.min(other.low),
            high: self.high.max(other.high),
            is_defined: self.is_defined && other.is_defined,
        }
    }

    fn within(self, [low, high]: [f64; 2]) -> Self {
        Self { low: self.low.max(low), high: self.high.min(high), ..self }
    }

    fn defined_if(self, condition: bool) -> Self {
        Self { is_defined: self.is_defined && condition, ..self }
    }

    /// One unit in the last place outwards.
    fn rounded(low: f64, high: f64, is_defined: bool) -> Self {
        if low.is_nan() || high.is_nan() {
            return Self { is_defined, ..Self::ALL };
        }
        Self { low: low.next_down(), high: high.next_up(), is_defined }
    }

    /// [`ULPS`] units in the last place outwards.
    fn widened(low: f64, high: f64, is_defined: bool) -> Self {
        let by = |x: f64| if x.is_finite() { ULPS * f64::EPSILON * x.abs() + f64::MIN_POSITIVE } else { 0.0 };
        Self::rounded(low - by(low), high + by(high), is_defined)
    }

    /// An ascending function of the standard library.
    fn ascending(self, function: impl Fn(f64) -> f64) -> Self {
        if self.is_none() {
            self
        } else {
            Self::widened(function(self.low), function(self.high), self.is_defined)
        }
    }

    /// The part in the domain of a function, which is not defined for the rest.
    fn in_domain(self, domain: [f64; 2]) -> Self {
        let is_inside = self.low >= domain[0] && self.high <= domain[1];
        let inside = self.within(domain).defined_if(is_inside);
        if inside.is_none() { Self::NONE } else { inside }
    }

    /// `xⁿ`
    #[must_use]
    pub fn powi(self, n: i8) -> Self {
        if self.is_none() {
            return self;
        }
        if n < 0 {
            return Self::point(1.0).defined_if(self.is_defined) / self.powi_of_size(n.unsigned_abs());
        }
        self.powi_of_size(n.unsigned_abs())
    }

    fn powi_of_size(self, n: u8) -> Self {
        let power = |x: f64| {
            let (x, mut product) = (Self::point(x), Self::point(1.0));
            for _ in 0..n {
                product = product * x;
            }
            product
        };
        if n == 0 {
            return Self::point(1.0).defined_if(self.is_defined);
        }
        let mut ends = power(self.low).hull(power(self.high));
        if n.is_multiple_of(2) {
            ends.low = ends.low.max(0.0);
            if self.contains(0.0) {
                ends.low = 0.0;
            }
        }
        ends.defined_if(self.is_defined)
    }

    /// `√x`
    #[must_use]
    pub fn sqrt(self) -> Self {
        let inside = self.in_domain([0.0, f64::INFINITY]);
        if inside.is_none() {
            return inside;
        }
        Self::rounded(inside.low.sqrt(), inside.high.sqrt(), inside.is_defined).within([0.0, f64::INFINITY])
    }

    /// The `n`th root, as [`Real::root`](crate::Real::root) has it.
    #[must_use]
    pub fn root(self, n: u8) -> Self {
        match n {
            2 => self.sqrt(),
            3 => self.ascending(f64::cbrt),
            4 => self.sqrt().sqrt(),
            _ => {
                let inside = self.in_domain([0.0, f64::INFINITY]);
                let root = (inside.ln() / Self::point(f64::from(n))).exp();
                if inside.low <= 0.0 {
                    Self { low: 0.0, is_defined: inside.is_defined, ..root }
                } else {
                    root
                }
            }
        }
    }

    /// `xʸ` for positive `x`; elsewhere nothing is known of it.
    #[must_use]
    pub fn pow(self, exponent: Self) -> Self {
        if self.low > 0.0 || self.is_none() { (exponent * self.ln()).exp() } else { Self::UNDEFINED }
    }

    /// `|x|`
    #[must_use]
    pub fn abs(self) -> Self {
        match () {
            () if self.is_none() || self.low >= 0.0 => self,
            () if self.high <= 0.0 => -self,
            () => Self { low: 0.0, high: self.high.max(-self.low), ..self },
        }
    }

    /// The smaller of two.
    #[must_use]
    pub fn min(self, other: Self) -> Self {
        self.of_both(other, f64::min)
    }

    /// The larger of two.
    #[must_use]
    pub fn max(self, other: Self) -> Self {
        self.of_both(other, f64::max)
    }

    fn of_both(self, other: Self, one: fn(f64, f64) -> f64) -> Self {
        if self.is_none() || other.is_none() {
            return Self::NONE;
        }
        let is_defined = self.is_defined && other.is_defined;
        Self { low: one(self.low, other.low), high: one(self.high, other.high), is_defined }
    }

    /// `eˣ`
    #[must_use]
    pub fn exp(self) -> Self {
        self.ascending(f64::exp).within([0.0, f64::INFINITY])
    }

    /// `ln x`
    #[must_use]
    pub fn ln(self) -> Self {
        let inside = self.in_domain([0.0, f64::INFINITY]);
        inside.ascending(f64::ln).defined_if(inside.low > 0.0)
    }

    /// `log₁₀ x`
    #[must_use]
    pub fn log10(self) -> Self {
        let inside = self.in_domain([0.0, f64::INFINITY]);
        inside.ascending(f64::log10).defined_if(inside.low > 0.0)
    }

    /// `sinh x`
    #[must_use]
    pub fn sinh(self) -> Self {
        self.ascending(f64::sinh)
    }

    /// `cosh x`
    #[must_use]
    pub fn cosh(self) -> Self {
        self.abs().ascending(f64::cosh).within([1.0, f64::INFINITY])
    }

    /// `tanh x`
    #[must_use]
    pub fn tanh(self) -> Self {
        self.ascending(f64::tanh).within([-1.0, 1.0])
    }

    /// `arcsin x`
    #[must_use]
    pub fn asin(self) -> Self {
        self.in_domain([-1.0, 1.0]).ascending(f64::asin)
    }

    /// `arccos x`
    #[must_use]
    pub fn acos(self) -> Self {
        (-self.in_domain([-1.0, 1.0])).ascending(|x| (-x).acos())
    }

    /// `sin x`
    #[must_use]
    pub fn sin(self) -> Self {
        self.wave(f64::sin, FRAC_PI_2)
    }

    /// `cos x`
    #[must_use]
    pub fn cos(self) -> Self {
        self.wave(f64::cos, 0.0)
    }

    /// A sine wave with a crest at an angle.
    fn wave(self, function: fn(f64) -> f64, crest: f64) -> Self {
        if self.is_none() {
            return self;
        }
        let ends = [self.low, self.high].map(function);
        let mut wave =
            Self::widened(ends[0].min(ends[1]), ends[0].max(ends[1]), self.is_defined).within([-1.0, 1.0]);
        if self.may_hold(crest, TAU) {
            wave.high = 1.0;
        }
        if self.may_hold(crest + PI, TAU) {
            wave.low = -1.0;
        }
        wave
    }

    /// Returns false if no `first + k period`, `k` whole, is in the interval for certain.
    fn may_hold(self, first: f64, period: f64) -> bool {
        let turns = |x: f64| (x - first) / period;
        let slack = |turns: f64| 8.0 * f64::EPSILON * (turns.abs() + 2.0);
        let (from, to) = (turns(self.low), turns(self.high));
        let (from, to) = (from - slack(from), to + slack(to));
        // Infinite ends, and turns that are not counted any more.
        !(to - from < 1.0 && to.abs() < 1e14) || from.ceil() <= to
    }

    /// `tan x`
    #[must_use]
    pub fn tan(self) -> Self {
        if !self.is_none() && self.may_hold(FRAC_PI_2, PI) {
            Self::UNDEFINED
        } else {
            self.ascending(f64::tan)
        }
    }

    /// The angle of the direction `(x, self)`; from −π to π where it is not one to one.
    #[must_use]
    pub fn atan2(self, x: Self) -> Self {
        if self.is_none() || x.is_none() {
            return Self::NONE;
        }
        let is_defined = self.is_defined && x.is_defined;
        if self.meets_cut(x) {
            return Self { is_defined, ..Self::widened(-PI, PI, true) };
        }
        let ends = |of: Self| [of.low, of.high];
        let corners = ends(self).into_iter().flat_map(|y| ends(x).map(|x| y.atan2(x)));
        let (low, high) = corners
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), angle| (low.min(angle), high.max(angle)));
        Self::widened(low, high, is_defined)
    }

    /// Returns true if directions `(x, self)` may be opposite to the first axis, where the angle jumps, or none.
    fn meets_cut(self, x: Self) -> bool {
        self.contains(0.0) && x.low <= 0.0
    }
}

impl From<f64> for Enclosure {
    fn from(x: f64) -> Self {
        Self::point(x)
    }
}

impl Neg for Enclosure {
    type Output = Self;
    fn neg(self) -> Self {
        Self { low: -self.high, high: -self.low, ..self }
    }
}

impl Add for Enclosure {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        if self.is_none() || other.is_none() {
            return Self::NONE;
        }
        if other == Self::ZERO {
            return self;
        }
        Self::rounded(self.low + other.low, self.high + other.high, self.is_defined && other.is_defined)
    }
}

impl Sub for Enclosure {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Enclosure {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        if self.is_none() || other.is_none() {
            return Self::NONE;
        }
        let is_defined = self.is_defined && other.is_defined;
        if self == Self::ZERO || other == Self::ZERO {
            return Self::ZERO.defined_if(is_defined);
        }
        // Zero times an end without limit is zero.
        let times = |a: f64, b: f64| if a == 0.0 || b == 0.0 { 0.0 } else { a * b };
        let products = [
            times(self.low, other.low),
            times(self.low, other.high),
            times(self.high, other.low),
            times(self.high, other.high),
        ];
        let (low, high) = products
            .into_iter()
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(x), high.max(x)));
        Self::rounded(low, high, is_defined)
    }
}

impl Div for Enclosure {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        if self.is_none() || other.is_none() || other.low == 0.0 && other.high == 0.0 {
            return Self::NONE;
        }
        if other.contains(0.0) {
            return Self::UNDEFINED;
        }
        let inverse = Self::rounded(1.0 / other.high, 1.0 / other.low, other.is_defined);
        self * inverse
    }
}
