//! SIMD: formulas over [`Real`] evaluated for sixteen samples at once.
//!
//! A formula over [`Real`] takes a [`SimdVector`] as it takes an `f64`. [`widest`] compiles the loop over the samples
//! for the widest registers of the processor as well (AVX-512 or AVX2, chosen at run time); every function in the loop
//! has to be inlined for that. No multiplication is fused with an addition, so the results are bit for bit the same on
//! every machine.
//!
//! Conditions see the first lane alone ([`Real::value`]): only formulas without conditions may be evaluated so.

#![expect(clippy::inline_always, reason = "what is not inlined is not compiled for the widest registers")]

use std::{
    f64::consts::{FRAC_2_PI, LN_2, SQRT_2},
    ops::{Add, Div, Mul, Neg, Sub},
};

use faer::traits::pulp::{Arch, NullaryFnOnce};

use crate::Real;

/// The number of lanes: more than one register has, so that latencies overlap.
pub const WIDTH: usize = 16;

/// The largest angle of sine and cosine, rad; beyond it they are NaN.
pub const LARGEST_ANGLE: f64 = 1e6;

/// A SIMD vector of `f64`, aligned to a cache line: a load across two lines takes twice the time.
///
/// Sine, cosine and logarithm are polynomials without conditions, each with its maximum error stated. The other
/// functions are those of the standard library, lane by lane.
#[derive(Debug, Clone, Copy, PartialEq)]
#[repr(align(64))]
pub struct SimdVector(pub [f64; WIDTH]);

/// A scalar (`f64`) or a [`SimdVector`], for code that is written once for both.
pub trait SimdReal: Real {
    /// The number of lanes.
    const COUNT: usize;
    /// A value whose lanes are given by their index.
    fn of(number: impl Fn(usize) -> f64) -> Self;
    /// The value of a lane.
    fn lane(&self, place: usize) -> f64;
    /// A function applied to each lane.
    #[must_use]
    fn each(self, f: impl Fn(f64) -> f64) -> Self;
    /// A function of two values applied lane by lane.
    #[must_use]
    fn with(self, other: Self, f: impl Fn(f64, f64) -> f64) -> Self;
}

impl SimdReal for f64 {
    const COUNT: usize = 1;
    #[inline(always)]
    fn of(number: impl Fn(usize) -> f64) -> Self {
        number(0)
    }
    #[inline(always)]
    fn lane(&self, _: usize) -> f64 {
        *self
    }
    #[inline(always)]
    fn each(self, f: impl Fn(f64) -> f64) -> Self {
        f(self)
    }
    #[inline(always)]
    fn with(self, other: Self, f: impl Fn(f64, f64) -> f64) -> Self {
        f(self, other)
    }
}

impl SimdReal for SimdVector {
    const COUNT: usize = WIDTH;
    #[inline(always)]
    fn of(number: impl Fn(usize) -> f64) -> Self {
        Self::of(number)
    }
    #[inline(always)]
    fn lane(&self, place: usize) -> f64 {
        self.0[place]
    }
    #[inline(always)]
    fn each(self, f: impl Fn(f64) -> f64) -> Self {
        self.map(f)
    }
    #[inline(always)]
    fn with(self, other: Self, f: impl Fn(f64, f64) -> f64) -> Self {
        Self::of(
            #[inline(always)]
            |lane| f(self.0[lane], other.0[lane]),
        )
    }
}

/// Numbers that follow from one by formulas without conditions.
pub trait Formula<const N: usize> {
    /// The numbers at `x`. Mark it `#[inline(always)]`: what is not inlined is not compiled for the widest registers.
    fn at<S: Real>(&self, x: S) -> [S; N];
}

/// A formula at each of many values, a column for each of the numbers it gives.
///
/// # Panics
/// Unless each column is as long as there are values.
pub fn over<const N: usize>(values: &[f64], formula: &impl Formula<N>, mut columns: [&mut [f64]; N]) {
    assert!(columns.iter().all(|column| column.len() == values.len()), "a place for each value");
    let rest = values.len() % WIDTH;
    let whole = values.len() - rest;
    let (values, last) = values.split_at(whole);
    widest(
        #[inline(always)]
        || {
            for (n, values) in values.as_chunks::<WIDTH>().0.iter().enumerate() {
                for (column, numbers) in columns.iter_mut().zip(formula.at(SimdVector(*values))) {
                    column[n * WIDTH..(n + 1) * WIDTH].copy_from_slice(&numbers.0);
                }
            }
            if rest > 0 {
                let found = formula.at(SimdVector::of(|lane| last[lane.min(rest - 1)]));
                for (column, numbers) in columns.iter_mut().zip(found) {
                    column[whole..].copy_from_slice(&numbers.0[..rest]);
                }
            }
        },
    );
}

/// Does the work of a closure with the widest registers of the machine, as far as it is inlined: mark the closure and
/// what it calls `#[inline(always)]`.
#[inline(always)]
pub fn widest<R>(work: impl FnMut() -> R) -> R {
    // A closure that pulp calls by value goes through a shim, which need not be inlined.
    struct Inlined<F>(F);
    impl<R, F: FnMut() -> R> NullaryFnOnce for Inlined<F> {
        type Output = R;
        #[inline(always)]
        fn call(mut self) -> R {
            (self.0)()
        }
    }
    Arch::new().dispatch(Inlined(work))
}

impl SimdVector {
    /// One number for each place.
    #[inline(always)]
    pub fn of(number: impl Fn(usize) -> f64) -> Self {
        // A loop: the functions of arrays that call a closure are not always inlined.
        let mut numbers = [0.0; WIDTH];
        for (lane, place) in numbers.iter_mut().enumerate() {
            *place = number(lane);
        }
        Self(numbers)
    }

    #[inline(always)]
    fn map(self, f: impl Fn(f64) -> f64) -> Self {
        Self::of(
            #[inline(always)]
            |lane| f(self.0[lane]),
        )
    }
}

impl From<f64> for SimdVector {
    #[inline(always)]
    fn from(x: f64) -> Self {
        Self([x; WIDTH])
    }
}

macro_rules! lane_by_lane {
    ($($trait:ident $method:ident $op:tt),*) => {$(
        impl $trait for SimdVector {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                self.with(other, |a, b| a $op b)
            }
        }
        impl $trait<f64> for SimdVector {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: f64) -> Self {
                self.map(|a| a $op other)
            }
        }
    )*};
}

lane_by_lane!(Add add +, Sub sub -, Mul mul *, Div div /);

impl Neg for SimdVector {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        self.map(|x| -x)
    }
}

impl Real for SimdVector {
    #[inline(always)]
    fn value(self) -> f64 {
        self.0[0]
    }
    #[inline(always)]
    fn powi(self, n: i8) -> Self {
        match n {
            2 => self * self,
            _ => self.map(|x| x.powi(n.into())),
        }
    }
    #[inline(always)]
    fn root(self, n: u8) -> Self {
        match n {
            2 => self.map(f64::sqrt),
            _ => self.map(|x| Real::root(x, n)),
        }
    }
    #[inline(always)]
    fn abs(self) -> Self {
        self.map(f64::abs)
    }
    /// To within 2·10⁻¹⁶, for angles up to [`LARGEST_ANGLE`].
    #[inline(always)]
    fn sin(self) -> Self {
        self.map(sin)
    }
    /// To within 2·10⁻¹⁶, for angles up to [`LARGEST_ANGLE`].
    #[inline(always)]
    fn cos(self) -> Self {
        self.map(cos)
    }
    fn tan(self) -> Self {
        self.map(f64::tan)
    }
    fn asin(self) -> Self {
        self.map(f64::asin)
    }
    fn acos(self) -> Self {
        self.map(f64::acos)
    }
    fn atan2(self, x: Self) -> Self {
        self.with(x, f64::atan2)
    }
    fn exp(self) -> Self {
        self.map(f64::exp)
    }
    /// To within 3·10⁻¹⁶ of its size or of 1, whichever is larger, for normal numbers; of others, NaN.
    #[inline(always)]
    fn ln(self) -> Self {
        self.map(ln)
    }
    fn log10(self) -> Self {
        self.map(f64::log10)
    }
    fn sinh(self) -> Self {
        self.map(f64::sinh)
    }
    fn cosh(self) -> Self {
        self.map(f64::cosh)
    }
    fn tanh(self) -> Self {
        self.map(f64::tanh)
    }
    fn pow(self, exponent: Self) -> Self {
        self.with(exponent, f64::powf)
    }
    #[inline(always)]
    fn min(self, other: Self) -> Self {
        self.with(other, f64::min)
    }
    #[inline(always)]
    fn max(self, other: Self) -> Self {
        self.with(other, f64::max)
    }
    #[inline(always)]
    fn sum(terms: impl IntoIterator<Item = Self>) -> Self {
        // A loop: what `reduce` calls is not always inlined.
        let mut terms = terms.into_iter();
        let Some(mut sum) = terms.next() else { return Self::from(0.0) };
        for term in terms {
            sum = sum + term;
        }
        sum
    }
}

#[inline(always)]
fn sin(x: f64) -> f64 {
    let (rest, quarters) = quarter(x);
    turned(sin_near_zero(rest), cos_near_zero(rest), quarters)
}

#[inline(always)]
fn cos(x: f64) -> f64 {
    let (rest, quarters) = quarter(x);
    turned(cos_near_zero(rest), -sin_near_zero(rest), quarters)
}

/// 1.5·2⁵²: a number added to it is rounded to the nearest whole one, which stands in its last bits.
const WHOLE: f64 = 6_755_399_441_055_744.0;

/// An angle less the nearest number of quarter turns, within ±π/4, and that number in the last bits.
#[inline(always)]
fn quarter(x: f64) -> (f64, u64) {
    // π/2 in parts of 33 bits: their products with numbers of up to 20 bits are exact (Cody and Waite).
    const PARTS: [f64; 3] = [1.570_796_326_734_125_6, 6.077_100_506_303_966e-11, 2.022_266_248_711_166_5e-21];
    let marked = x * FRAC_2_PI + WHOLE;
    let quarters = marked - WHOLE;
    let rest = ((x - quarters * PARTS[0]) - quarters * PARTS[1]) - quarters * PARTS[2];
    (if x.abs() <= LARGEST_ANGLE { rest } else { f64::NAN }, marked.to_bits())
}

/// The function a number of quarter turns on, from itself and its derivative there.
#[inline(always)]
fn turned(function: f64, derivative: f64, quarters: u64) -> f64 {
    // Masks: of two values chosen by a condition the compiler would compute one alone, one lane after the other.
    let odd = (quarters & 1).wrapping_neg();
    let found = function.to_bits() & !odd | derivative.to_bits() & odd;
    f64::from_bits(found ^ (quarters & 2) << 62)
}

/// `sin x` for `|x| ≤ π/4`.
#[inline(always)]
fn sin_near_zero(x: f64) -> f64 {
    let q = x * x;
    x + x * q * polynomial(q, &SIN)
}

/// `cos x` for `|x| ≤ π/4`; the two largest terms are added without loss.
#[inline(always)]
fn cos_near_zero(x: f64) -> f64 {
    let q = x * x;
    let half = 0.5 * q;
    let two_terms = 1.0 - half;
    two_terms + (((1.0 - two_terms) - half) + q * q * polynomial(q, &COS))
}

/// `k ln 2 + 2 artanh s` with `x = 2ᵏ m`, `√½ < m ≤ √2` and `s = (m − 1)/(m + 1)`.
#[inline(always)]
fn ln(x: f64) -> f64 {
    // The exponent as a number is its bits and those of 2⁵² side by side.
    const SIDE: f64 = 4_503_599_627_370_496.0;
    let bits = x.to_bits();
    let exponent = f64::from_bits(SIDE.to_bits() | bits >> 52) - (SIDE + 1023.0);
    let mantissa = f64::from_bits(bits & ((1 << 52) - 1) | 1.0_f64.to_bits());
    let above = mantissa > SQRT_2;
    let m = if above { 0.5 * mantissa } else { mantissa };
    let k = if above { exponent + 1.0 } else { exponent };
    let s = (m - 1.0) / (m + 1.0);
    let q = s * s;
    let found = k * LN_2 + (2.0 * s + 2.0 * s * q * polynomial(q, &ARTANH));
    if (f64::MIN_POSITIVE..f64::INFINITY).contains(&x) { found } else { f64::NAN }
}

/// `c₀ + c₁ q + c₂ q² + …`
#[inline(always)]
fn polynomial<const N: usize>(q: f64, c: &[f64; N]) -> f64 {
    let mut sum = c[N - 1];
    for n in (0..N - 1).rev() {
        sum = sum * q + c[n];
    }
    sum
}

// Polynomials through the Chebyshev points of q = x²: below 2·10⁻¹⁷ of x off.

/// `(sin x/x − 1)/q` for `q ≤ (π/4)²`.
const SIN: [f64; 6] = [
    -0.16666666666666666,
    0.008333333333330948,
    -0.00019841269836758574,
    2.755731610255244e-06,
    -2.5051131845003624e-08,
    1.5918129294866608e-10,
];

/// `(cos x − 1 + q/2)/q²` for `q ≤ (π/4)²`.
const COS: [f64; 6] = [
    0.041666666666666664,
    -0.0013888888888887398,
    2.480158729876569e-05,
    -2.7557317271729793e-07,
    2.08761462684032e-09,
    -1.1382632425521717e-11,
];

/// `(artanh x/x − 1)/q` for `x ≤ (√2 − 1)/(√2 + 1)`.
const ARTANH: [f64; 7] = [
    0.3333333333333335,
    0.19999999999949752,
    0.14285714312987743,
    0.1111110556739754,
    0.09091444562630861,
    0.07665860800278021,
    0.07308224842521703,
];

#[cfg(test)]
mod tests {
    use super::*;
    use itertools::Itertools as _;

    /// The largest error of a function of lanes over many numbers from a range, over the given size.
    fn worst([from, to]: [f64; 2], [ours, library]: [fn(f64) -> f64; 2], size: fn(f64) -> f64) -> f64 {
        const COUNT: usize = 100_003;
        let at = |n: usize| from + (to - from) * n as f64 / (COUNT - 1) as f64;
        (0..COUNT).map(at).map(|x| (ours(x) - library(x)).abs() / size(library(x))).fold(0.0, f64::max)
    }

    #[test]
    fn functions_are_those_of_the_library_to_the_errors_they_say() {
        let sin: [fn(f64) -> f64; 2] = [|x| SimdVector::from(x).sin().value(), f64::sin];
        let cos: [fn(f64) -> f64; 2] = [|x| SimdVector::from(x).cos().value(), f64::cos];
        for range in [[-1.0, 1.0], [-10.0, 10.0], [-1000.0, 1000.0], [0.9e6, 1e6]] {
            for (name, function) in [("sin", sin), ("cos", cos)] {
                let off = worst(range, function, |_| 1.0);
                assert!(off <= 2e-16, "{name} on {range:?}: {off:e}");
            }
        }
        for range in [[1e-300, 1e-290], [1e-5, 0.1], [0.5, 2.0], [1.0, 1e6]] {
            let off = worst(range, [|x| SimdVector::from(x).ln().value(), f64::ln], |y| y.abs().max(1.0));
            assert!(off <= 3e-16, "ln on {range:?}: {off:e}");
        }
    }

    #[test]
    fn ends_are_exact_and_what_is_not_claimed_is_not_a_number() {
        let of = |f: fn(SimdVector) -> SimdVector, x: f64| f(SimdVector::from(x)).value();
        assert_eq!((of(Real::sin, 0.0), of(Real::cos, 0.0)), (0.0, 1.0));
        assert_eq!((of(Real::ln, 1.0), of(Real::ln, 2.0)), (0.0, LN_2));
        for x in [1.1e6, -1e300, f64::INFINITY, f64::NAN] {
            assert!(of(Real::sin, x).is_nan() && of(Real::cos, x).is_nan(), "{x}");
        }
        for x in [0.0, -1.0, 1e-310, f64::INFINITY, f64::NAN] {
            assert!(of(Real::ln, x).is_nan(), "{x}");
        }
    }

    struct DoubleAndRoot;

    impl Formula<2> for DoubleAndRoot {
        fn at<S: Real>(&self, x: S) -> [S; 2] {
            [x * 2.0, x.sqrt()]
        }
    }

    #[test]
    fn a_formula_is_read_at_every_value() {
        for count in [0, 1, WIDTH - 1, WIDTH, 3 * WIDTH + 5] {
            let values: Vec<f64> = (0..count).map(|n| 1.0 + n as f64).collect();
            let (mut double, mut root) = (vec![0.0; count], vec![0.0; count]);
            over(&values, &DoubleAndRoot, [&mut double, &mut root]);
            assert!(values.iter().zip_eq(&double).all(|(x, found)| *found == 2.0 * x), "{count}: {double:?}");
            assert!(values.iter().zip_eq(&root).all(|(x, found)| *found == x.sqrt()), "{count}: {root:?}");
        }
    }

    #[test]
    fn each_place_has_its_own_number() {
        let x = SimdVector::of(|lane| 0.1 + 0.7 * lane as f64);
        let found = (x.sin().powi(2) + x.cos().powi(2)) * x + x.powi(3) / 2.0 - x.sqrt();
        for (found, x) in found.0.iter().zip_eq(x.0) {
            assert!((found - (x + x.powi(3) / 2.0 - x.sqrt())).abs() < 1e-13 * x.powi(3).max(1.0));
        }
    }
}
