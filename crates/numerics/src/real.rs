//! The numbers that formulas are written in.

use std::ops::{Add, Div, Mul, Neg, Sub};

use nalgebra::Vector3;

use crate::elementary;

/// Arithmetic of real numbers, as formulas use it.
///
/// A formula written once over `Real` gives a number when it is read with `f64`, and writes itself down,
/// with units and dimensions, when it is read with a term of a worked solution. `S::from(2.0)` is a literal.
pub trait Real:
    Copy
    + From<f64>
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + Add<f64, Output = Self>
    + Sub<f64, Output = Self>
    + Mul<f64, Output = Self>
    + Div<f64, Output = Self>
{
    /// The number itself, in SI. For numerical methods; what is computed from it is not part of the worked solution.
    fn value(self) -> f64;
    /// Returns true if a condition holds for the number. Asked so, and not of [`value`](Real::value), SIMD can read the
    /// formulas as long as the samples have the same answer.
    fn holds(self, condition: impl Fn(f64) -> bool) -> bool {
        self.holds_with(self, |number, _| condition(number))
    }
    /// Returns true if a condition holds for two numbers.
    fn holds_with(self, other: Self, condition: impl Fn(f64, f64) -> bool) -> bool {
        condition(self.value(), other.value())
    }
    /// `xⁿ`.
    #[must_use]
    fn powi(self, n: i8) -> Self;
    /// The `n`th root, `n ≥ 2`.
    #[must_use]
    fn root(self, n: u8) -> Self;
    /// `√x`.
    #[must_use]
    fn sqrt(self) -> Self {
        self.root(2)
    }
    /// `|x|`.
    #[must_use]
    fn abs(self) -> Self;
    /// `sin x`.
    #[must_use]
    fn sin(self) -> Self;
    /// `cos x`.
    #[must_use]
    fn cos(self) -> Self;
    /// `tan x`.
    #[must_use]
    fn tan(self) -> Self;
    /// `arcsin x`.
    #[must_use]
    fn asin(self) -> Self;
    /// `arccos x`.
    #[must_use]
    fn acos(self) -> Self;
    /// The angle of the direction `(x, self)`, in `(−π, π]`.
    #[must_use]
    fn atan2(self, x: Self) -> Self;
    /// `eˣ`.
    #[must_use]
    fn exp(self) -> Self;
    /// `ln x`.
    #[must_use]
    fn ln(self) -> Self;
    /// `log₁₀ x`.
    #[must_use]
    fn log10(self) -> Self;
    /// `sinh x`.
    #[must_use]
    fn sinh(self) -> Self;
    /// `cosh x`.
    #[must_use]
    fn cosh(self) -> Self;
    /// `tanh x`.
    #[must_use]
    fn tanh(self) -> Self;
    /// `xʸ` for an exponent that is no constant of the formula; a constant one takes [`powi`](Real::powi) or
    /// [`root`](Real::root).
    #[must_use]
    fn pow(self, exponent: Self) -> Self;
    /// The smaller of two.
    #[must_use]
    fn min(self, other: Self) -> Self;
    /// The larger of two.
    #[must_use]
    fn max(self, other: Self) -> Self;
    /// The sum of all terms; zero for none. Worked solutions write it with `Σ` when it is long.
    #[must_use]
    fn sum(terms: impl IntoIterator<Item = Self>) -> Self;
}

/// A vector in space over [`Real`] numbers.
pub trait Vector:
    Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Neg<Output = Self>
    + Mul<Self::Scalar, Output = Self>
    + Div<Self::Scalar, Output = Self>
{
    /// The kind of number of its components.
    type Scalar: Real;
    /// The vector `x i + y j + z k`.
    fn from_components(x: Self::Scalar, y: Self::Scalar, z: Self::Scalar) -> Self;
    /// The components along `i`, `j` and `k`.
    fn components(self) -> [Self::Scalar; 3];
    /// The components as plain numbers, in SI.
    fn value(self) -> Vector3<f64>;
    /// Returns true if every component is zero.
    fn is_zero(self) -> bool {
        self.value() == Vector3::zeros()
    }
    /// `a · b`.
    #[must_use]
    fn dot(self, other: Self) -> Self::Scalar;
    /// `a × b`.
    #[must_use]
    fn cross(self, other: Self) -> Self;
    /// `|a|`.
    #[must_use]
    fn magnitude(self) -> Self::Scalar;
    /// The sum of all vectors; zero for none.
    #[must_use]
    fn sum(terms: impl IntoIterator<Item = Self>) -> Self;
}

impl Real for f64 {
    #[inline]
    fn value(self) -> f64 {
        self
    }
    #[inline]
    fn powi(self, n: i8) -> f64 {
        f64::powi(self, n.into())
    }
    #[inline]
    fn root(self, n: u8) -> f64 {
        match n {
            2 => f64::sqrt(self),
            3 => f64::cbrt(self),
            4 => f64::sqrt(f64::sqrt(self)),
            _ => f64::powf(self, 1.0 / f64::from(n)),
        }
    }
    #[inline]
    fn abs(self) -> f64 {
        f64::abs(self)
    }
    #[inline]
    fn sin(self) -> f64 {
        elementary::sin(self)
    }
    #[inline]
    fn cos(self) -> f64 {
        elementary::cos(self)
    }
    #[inline]
    fn tan(self) -> f64 {
        f64::tan(self)
    }
    #[inline]
    fn asin(self) -> f64 {
        elementary::asin(self)
    }
    #[inline]
    fn acos(self) -> f64 {
        elementary::acos(self)
    }
    #[inline]
    fn atan2(self, x: f64) -> f64 {
        elementary::atan2(self, x)
    }
    #[inline]
    fn exp(self) -> f64 {
        f64::exp(self)
    }
    #[inline]
    fn ln(self) -> f64 {
        elementary::ln(self)
    }
    #[inline]
    fn log10(self) -> f64 {
        f64::log10(self)
    }
    #[inline]
    fn sinh(self) -> f64 {
        f64::sinh(self)
    }
    #[inline]
    fn cosh(self) -> f64 {
        f64::cosh(self)
    }
    #[inline]
    fn tanh(self) -> f64 {
        f64::tanh(self)
    }
    #[inline]
    fn pow(self, exponent: f64) -> f64 {
        f64::powf(self, exponent)
    }
    #[inline]
    fn min(self, other: f64) -> f64 {
        f64::min(self, other)
    }
    #[inline]
    fn max(self, other: f64) -> f64 {
        f64::max(self, other)
    }
    #[inline]
    fn sum(terms: impl IntoIterator<Item = f64>) -> f64 {
        // Not from zero: the sum of one −0 is −0.
        terms.into_iter().reduce(Add::add).unwrap_or(0.0)
    }
}

impl Vector for Vector3<f64> {
    type Scalar = f64;
    #[inline]
    fn from_components(x: f64, y: f64, z: f64) -> Self {
        Vector3::new(x, y, z)
    }
    #[inline]
    fn components(self) -> [f64; 3] {
        self.into()
    }
    #[inline]
    fn value(self) -> Vector3<f64> {
        self
    }
    #[inline]
    fn dot(self, other: Self) -> f64 {
        nalgebra::Matrix::dot(&self, &other)
    }
    #[inline]
    fn cross(self, other: Self) -> Self {
        nalgebra::Matrix::cross(&self, &other)
    }
    #[inline]
    fn magnitude(self) -> f64 {
        self.norm()
    }
    #[inline]
    fn sum(terms: impl IntoIterator<Item = Self>) -> Self {
        terms.into_iter().fold(Vector3::zeros(), Add::add)
    }
}
