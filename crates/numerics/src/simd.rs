//! SIMD: formulas over [`Real`] evaluated for sixteen samples at once.
//!
//! A formula over [`Real`] takes a [`SimdVector`] as it takes an `f64`. [`widest`] compiles the loop over the samples
//! for the widest registers of the processor as well (AVX-512 or AVX2, chosen at run time); every function in the loop
//! has to be inlined for that. No multiplication is fused with an addition, so the results are bit for bit the same on
//! every machine.
//!
//! A condition that is asked by [`Real::holds`] is true or false for all lanes at once. Where the lanes differ they
//! *diverge*, and what follows holds for the first lane alone, as it does after a [`Real::value`] of different lanes.
//! [`converged`] gives the result of a formula only if its lanes did not diverge.
//!
//! ```
//! use dalembert_numerics::{
//!     Real,
//!     simd::{Formula, over},
//! };
//!
//! /// Magnification of an undamped mass on a spring, 1/|1 − r²|.
//! struct Magnification;
//!
//! impl Formula<1> for Magnification {
//!     #[inline(always)]
//!     fn at<S: Real>(&self, ratio: S) -> [S; 1] {
//!         [S::from(1.0) / (S::from(1.0) - ratio.powi(2)).abs()]
//!     }
//! }
//!
//! let ratios: Vec<f64> = (0..100).map(|n| 0.05 + 0.1 * f64::from(n)).collect();
//! let mut column = vec![0.0; ratios.len()];
//! over(&ratios, &Magnification, [&mut column]);
//! let one_by_one: Vec<f64> = ratios.iter().map(|&ratio| Magnification.at(ratio)[0]).collect();
//! assert_eq!(column, one_by_one);
//! ```

#![expect(
    clippy::redundant_closure,
    clippy::redundant_closure_for_method_calls,
    reason = "a path to a function in place of a closure is called, not inlined"
)]

mod space;

use std::{
    cell::Cell,
    ops::{Add, Div, Mul, Neg, Sub},
};

use faer::traits::pulp::{Arch, NullaryFnOnce};

pub use self::space::SimdVector3;
use crate::{Real, elementary};

/// The number of lanes: more than one register has, so that latencies overlap.
pub const WIDTH: usize = 16;

/// A SIMD vector of `f64`, aligned to a cache line: a load across two lines takes twice the time.
///
/// Each lane is what the same formula gives for `f64`, bit for bit. Sine, cosine, their inverses
/// and the logarithm are [polynomials](elementary) in SIMD registers; the other functions are those of the standard library, lane by lane.
#[derive(Debug, Clone, Copy, PartialEq)]
#[repr(align(64))]
pub struct SimdVector(pub [f64; WIDTH]);

/// A closure that is inlined wherever it is called, as SIMD needs it; a path to a function in its place would not be.
macro_rules! inlined {
    ($closure:expr) => {
        #[inline(always)]
        $closure
    };
}

thread_local! {
    /// True if lanes have diverged since [`converged`] began.
    static DIVERGED: Cell<bool> = const { Cell::new(false) };
}

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

/// Sums of terms over the rows of columns of one length.
///
/// Each lane adds up the rows of its place in blocks of [`WIDTH`], then the lanes are added in their order: the sums are the
/// same to the last bit on every machine.
///
/// # Panics
/// Unless the columns are of one length.
pub fn sums<const N: usize, const K: usize>(
    columns: [&[f64]; N],
    terms: impl Fn([SimdVector; N]) -> [SimdVector; K],
) -> [f64; K] {
    let rows = columns.first().map_or(0, |column| column.len());
    assert!(columns.iter().all(|column| column.len() == rows), "columns of one length");
    let (blocks, rest) = (rows / WIDTH, rows % WIDTH);
    let mut sums = [SimdVector::from(0.0); K];
    widest(
        #[inline(always)]
        || {
            // Loops over numbers: the functions of iterators are not always inlined.
            let mut block = [SimdVector::from(0.0); N];
            for n in 0..blocks {
                for k in 0..N {
                    block[k] = SimdVector(columns[k].as_chunks().0[n]);
                }
                let terms = terms(block);
                for k in 0..K {
                    sums[k] = sums[k] + terms[k];
                }
            }
            for k in 0..N {
                block[k].0[..rest].copy_from_slice(columns[k].as_chunks::<WIDTH>().1);
            }
            let terms = terms(block);
            for k in 0..K {
                for lane in 0..rest {
                    sums[k].0[lane] += terms[k].0[lane];
                }
            }
        },
    );
    sums.map(|sum| sum.0.into_iter().sum())
}

/// The least and the largest of finite values; `[∞, −∞]` of none.
pub fn range(values: &[f64]) -> [f64; 2] {
    let (blocks, rest) = values.as_chunks::<WIDTH>();
    let mut least = [f64::INFINITY; WIDTH];
    let mut largest = [f64::NEG_INFINITY; WIDTH];
    widest(
        #[inline(always)]
        || {
            for block in blocks {
                for lane in 0..WIDTH {
                    // One instruction each, unlike `f64::min`, which takes care of NaN.
                    least[lane] = if block[lane] < least[lane] { block[lane] } else { least[lane] };
                    largest[lane] = if block[lane] > largest[lane] { block[lane] } else { largest[lane] };
                }
            }
        },
    );
    let all = |lanes: [f64; WIDTH]| rest.iter().copied().chain(lanes);
    [all(least).fold(f64::INFINITY, f64::min), all(largest).fold(f64::NEG_INFINITY, f64::max)]
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

/// The result of formulas whose conditions were the same for all lanes; `None` where lanes diverged.
#[inline(always)]
pub fn converged<R>(work: impl FnOnce() -> R) -> Option<R> {
    DIVERGED.set(false);
    let result = work();
    (!DIVERGED.get()).then_some(result)
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
        Self::of(inlined!(|lane| f(self.0[lane])))
    }
}

impl SimdVector {
    /// Returns true if a condition holds for every lane.
    #[inline(always)]
    fn all(self, condition: impl Fn(f64) -> bool) -> bool {
        // Without an end before the last lane, which would be a branch for each.
        let mut all = true;
        for lane in self.0 {
            all &= condition(lane);
        }
        all
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
                self.with(
                    other,
                    inlined!(|a, b| a $op b),
                )
            }
        }
        impl $trait<f64> for SimdVector {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: f64) -> Self {
                self.map(
                    inlined!(|a| a $op other),
                )
            }
        }
    )*};
}

lane_by_lane!(Add add +, Sub sub -, Mul mul *, Div div /);

impl Neg for SimdVector {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        self.map(inlined!(|x| -x))
    }
}

impl Real for SimdVector {
    /// The number of the first lane. Lanes that are not all the same diverge.
    #[inline(always)]
    fn value(self) -> f64 {
        let first = self.0[0];
        if !self.all(|lane| lane.to_bits() == first.to_bits()) {
            DIVERGED.set(true);
        }
        first
    }
    #[inline(always)]
    fn holds_with(self, other: Self, condition: impl Fn(f64, f64) -> bool) -> bool {
        let first = condition(self.0[0], other.0[0]);
        let mut same = true;
        for lane in 1..WIDTH {
            same &= condition(self.0[lane], other.0[lane]) == first;
        }
        if !same {
            DIVERGED.set(true);
        }
        first
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
            2 => self.map(inlined!(|x| x.sqrt())),
            _ => self.map(|x| Real::root(x, n)),
        }
    }
    #[inline(always)]
    fn abs(self) -> Self {
        self.map(inlined!(|x| x.abs()))
    }
    #[inline(always)]
    fn sin(self) -> Self {
        if self.all(inlined!(|x| elementary::is_angle(x))) {
            self.map(inlined!(|x| elementary::sin_polynomial(x)))
        } else {
            self.map(inlined!(|x| elementary::sin(x)))
        }
    }
    #[inline(always)]
    fn cos(self) -> Self {
        if self.all(inlined!(|x| elementary::is_angle(x))) {
            self.map(inlined!(|x| elementary::cos_polynomial(x)))
        } else {
            self.map(inlined!(|x| elementary::cos(x)))
        }
    }
    fn tan(self) -> Self {
        self.map(f64::tan)
    }
    #[inline(always)]
    fn asin(self) -> Self {
        self.map(inlined!(|x| elementary::asin(x)))
    }
    #[inline(always)]
    fn acos(self) -> Self {
        self.map(inlined!(|x| elementary::acos(x)))
    }
    #[inline(always)]
    fn atan2(self, x: Self) -> Self {
        if self
            .with(x, inlined!(|y, x| y.abs().max(x.abs())))
            .all(inlined!(|size| elementary::is_length(size)))
        {
            self.with(x, inlined!(|y, x| elementary::atan2_polynomial(y, x)))
        } else {
            self.with(x, inlined!(|y, x| elementary::atan2(y, x)))
        }
    }
    fn exp(self) -> Self {
        self.map(f64::exp)
    }
    #[inline(always)]
    fn ln(self) -> Self {
        if self.all(inlined!(|x| elementary::is_normal(x))) {
            self.map(inlined!(|x| elementary::ln_polynomial(x)))
        } else {
            self.map(inlined!(|x| elementary::ln(x)))
        }
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
        self.with(other, inlined!(|a, b| a.min(b)))
    }
    #[inline(always)]
    fn max(self, other: Self) -> Self {
        self.with(other, inlined!(|a, b| a.max(b)))
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

#[cfg(test)]
mod tests {
    use super::*;
    use itertools::Itertools as _;

    /// Numbers of many sizes and signs, those among them where functions have no answer or another formula.
    const NUMBERS: [f64; 24] = [
        0.0,
        1e-310,
        1e-9,
        0.1,
        0.5,
        0.7,
        1.0,
        1.5,
        2.0,
        3.1,
        40.0,
        700.0,
        -1e-310,
        -1e-9,
        -0.1,
        -0.5,
        -0.7,
        -1.0,
        -1.5,
        -3.1,
        1e6,
        1.1e6,
        -1e300,
        f64::INFINITY,
    ];

    #[test]
    fn each_lane_is_the_number_of_the_scalar_formula_bit_for_bit() {
        type Formulas = (&'static str, fn(SimdVector) -> SimdVector, fn(f64) -> f64);
        macro_rules! formulas {
            ($($name:ident => $formula:expr),* $(,)?) => {[$((stringify!($name), $formula, $formula)),*]};
        }
        let formulas: [Formulas; 18] = formulas![
            square => |x| Real::powi(x, 2), cube => |x| Real::powi(x, 3), inverse => |x| Real::powi(x, -1),
            fifth => |x| Real::powi(x, 5), root => |x| Real::sqrt(x), cube_root => |x| Real::root(x, 3),
            abs => |x| Real::abs(x), sin => |x| Real::sin(x), cos => |x| Real::cos(x), tan => |x| Real::tan(x),
            asin => |x| Real::asin(x), acos => |x| Real::acos(x), exp => |x| Real::exp(x), ln => |x| Real::ln(x),
            log10 => |x| Real::log10(x), tanh => |x| Real::tanh(x),
            direction => |x| Real::atan2(x, x * 0.3 - 1.0), sum => |x| Real::sum([x, x * 0.1, x / 3.0 - x]),
        ];
        for (name, simd, scalar) in formulas {
            for numbers in NUMBERS.windows(WIDTH) {
                let x = SimdVector::of(|lane| numbers[lane]);
                for (found, x) in simd(x).0.iter().zip_eq(x.0) {
                    let expected = scalar(x);
                    assert!(
                        found.to_bits() == expected.to_bits() || found.is_nan() && expected.is_nan(),
                        "{name} of {x}: {found} and {expected}"
                    );
                }
            }
        }
    }

    #[test]
    fn lanes_converge_where_a_condition_is_the_same_for_all() {
        let (same, different) = (SimdVector::from(2.0), SimdVector::of(|lane| lane as f64));
        assert_eq!(converged(|| same.value()), Some(2.0));
        assert_eq!(converged(|| different.value()), None);
        assert_eq!(converged(|| different.holds(|x| x >= 0.0)), Some(true));
        assert_eq!(converged(|| different.holds(|x| x < 0.0)), Some(false));
        assert_eq!(converged(|| different.holds(|x| x < 15.0)), None);
        assert_eq!(converged(|| different.holds_with(same, |a, b| a > b)), None);
        assert_eq!(converged(|| (different + 3.0).holds_with(same, |a, b| a > b)), Some(true));
        // What diverged before is forgotten.
        assert_eq!(converged(|| different.value()).and(converged(|| same.value())), None);
        assert_eq!(converged(|| same.value()), Some(2.0));
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
    fn the_range_is_that_of_all_values() {
        assert_eq!(range(&[]), [f64::INFINITY, f64::NEG_INFINITY]);
        for count in [1, WIDTH - 1, WIDTH, 3 * WIDTH + 5] {
            for place in 0..count {
                let mut values = vec![0.5; count];
                (values[place], values[count - 1 - place]) = (-3.0, 4.0);
                let least = values.iter().copied().fold(f64::INFINITY, f64::min);
                assert_eq!(range(&values), [least, 4.0], "{count} {place}");
            }
        }
    }

    #[test]
    fn sums_are_those_of_all_rows() {
        for rows in [0, 1, WIDTH - 1, WIDTH, 4 * WIDTH + 3] {
            let a: Vec<f64> = (0..rows).map(|n| n as f64).collect();
            let b: Vec<f64> = (0..rows).map(|n| 2.0 - n as f64).collect();
            let [count, product, inverse] =
                sums([&a, &b], |[a, b]| [SimdVector::from(1.0), a * b, SimdVector::from(1.0) / (a + 1.0)]);
            // Whole numbers are added without rounding.
            assert_eq!(count, rows as f64);
            assert_eq!(product, a.iter().zip_eq(&b).map(|(a, b)| a * b).sum::<f64>());
            let expected: f64 = a.iter().map(|a| 1.0 / (a + 1.0)).sum();
            assert!((inverse - expected).abs() <= 1e-14 * expected, "{rows}: {inverse} {expected}");
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
