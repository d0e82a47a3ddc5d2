//! Sine, cosine, their inverses and the natural logarithm by polynomials without conditions, so that SIMD evaluates them
//! for many samples at once; outside of the range of the polynomials, the functions of the standard library.
//!
//! [`Real`](crate::Real) takes them for scalars as for SIMD vectors: a formula gives the same number, bit for bit, either
//! way and on every machine.
//!
//! ```
//! use std::f64::consts::PI;
//!
//! use dalembert_numerics::elementary::{LARGEST_ANGLE, asin, atan2, ln, sin};
//!
//! assert!((sin(PI / 6.0) - 0.5).abs() < 2e-16);
//! // The angle of a direction in the second quadrant.
//! assert!((atan2(1.0, -1.0) - 0.75 * PI).abs() < 2e-15);
//! // Logarithmic decrement of an amplitude that falls to a half.
//! assert!((ln(2.0) - 0.693_147_180_559_945_3).abs() < 3e-16);
//! // Beyond the polynomials, the standard library; outside of the domain, no number.
//! assert_eq!(sin(2.0 * LARGEST_ANGLE), (2.0 * LARGEST_ANGLE).sin());
//! assert!(asin(1.1).is_nan());
//! ```

use std::f64::consts::{FRAC_2_PI, FRAC_PI_4, LN_2, SQRT_2};

/// The largest angle whose sine and cosine are polynomials, rad.
pub const LARGEST_ANGLE: f64 = 1e6;

/// `sin x`, to within 2·10⁻¹⁶.
#[inline]
pub fn sin(x: f64) -> f64 {
    if is_angle(x) { sin_polynomial(x) } else { x.sin() }
}

/// `cos x`, to within 2·10⁻¹⁶.
#[inline]
pub fn cos(x: f64) -> f64 {
    if is_angle(x) { cos_polynomial(x) } else { x.cos() }
}

/// `arcsin x`, to within 5·10⁻¹⁶ of its size; NaN unless `|x| ≤ 1`.
#[inline(always)]
pub fn asin(x: f64) -> f64 {
    atan2_polynomial(x, ((1.0 - x) * (1.0 + x)).sqrt())
}

/// `arccos x`, to within 5·10⁻¹⁶ of its size; NaN unless `|x| ≤ 1`.
#[inline(always)]
pub fn acos(x: f64) -> f64 {
    atan2_polynomial(((1.0 - x) * (1.0 + x)).sqrt(), x)
}

/// The angle of the direction `(x, y)`, in `(−π, π]`, to within 5·10⁻¹⁶ of its size.
#[inline]
pub fn atan2(y: f64, x: f64) -> f64 {
    if is_length(y.abs().max(x.abs())) { atan2_polynomial(y, x) } else { y.atan2(x) }
}

/// `ln x`, to within 3·10⁻¹⁶ of its size or of 1, whichever is larger.
#[inline]
pub fn ln(x: f64) -> f64 {
    if is_normal(x) { ln_polynomial(x) } else { x.ln() }
}

/// Returns true if sine and cosine of an angle are polynomials.
#[inline(always)]
pub(crate) fn is_angle(x: f64) -> bool {
    x.abs() <= LARGEST_ANGLE
}

/// Returns true if a direction whose longer component has this size is a polynomial: sums and quotients of its components
/// are then numbers with all digits.
#[inline(always)]
pub(crate) fn is_length(size: f64) -> bool {
    (f64::MIN_POSITIVE..1e300).contains(&size)
}

/// Returns true if the logarithm of a number is a polynomial.
#[inline(always)]
pub(crate) fn is_normal(x: f64) -> bool {
    (f64::MIN_POSITIVE..f64::INFINITY).contains(&x)
}

/// `sin x` for [angles of the polynomials](is_angle).
#[inline(always)]
pub(crate) fn sin_polynomial(x: f64) -> f64 {
    let (rest, quarters) = quarter(x);
    turned(sin_near_zero(rest), cos_near_zero(rest), quarters)
}

/// `cos x` for [angles of the polynomials](is_angle).
#[inline(always)]
pub(crate) fn cos_polynomial(x: f64) -> f64 {
    let (rest, quarters) = quarter(x);
    turned(cos_near_zero(rest), -sin_near_zero(rest), quarters)
}

/// The angle of the direction `(x, y)` for [longer components of the polynomial](is_length).
///
/// Within an eighth of a turn it is `arctan u` with `u = y/x`, and beyond `tan π/8` `π/4 + arctan u` with
/// `u = (y − x)/(y + x)`; the other eighths are mirror images.
#[inline(always)]
pub(crate) fn atan2_polynomial(y: f64, x: f64) -> f64 {
    /// `tan π/8`
    const TAN: f64 = 0.414_213_562_373_095_03;
    /// Difference of π/4 from the `f64` next to it.
    const TAIL: f64 = 3.061_616_997_868_383e-17;
    let (rise, run) = (y.abs(), x.abs());
    let (is_steep, is_backwards) = (rise > run, x < 0.0);
    let (low, high) = if is_steep { (run, rise) } else { (rise, run) };
    let is_wide = low > TAN * high;
    let u = if is_wide { low - high } else { low } / if is_wide { low + high } else { high };
    let q = u * u;
    let near = u + u * q * polynomial(q, &ATAN);
    // The angle is so many eighths of a turn, and `near` added or taken away.
    let eighths = if is_wide { 1.0 } else { 0.0 };
    let eighths = if is_steep { 2.0 - eighths } else { eighths };
    let eighths = if is_backwards { 4.0 - eighths } else { eighths };
    let near = if is_steep == is_backwards { near } else { -near };
    (eighths * FRAC_PI_4 + (near + eighths * TAIL)).copysign(y)
}

/// 1.5·2⁵²: a number added to it is rounded to the nearest whole one, which stands in its last bits.
const WHOLE: f64 = 6_755_399_441_055_744.0;

/// An angle less the nearest number of quarter turns, within ±π/4, and that number in the last bits.
#[inline(always)]
fn quarter(x: f64) -> (f64, u64) {
    // π/2 in parts of 33 bits: their products with numbers of up to 20 bits are exact (Cody and Waite).
    const PARTS: [f64; 3] = [1.570_796_326_734_125_6, 6.077_100_506_303_966e-11, 2.022_266_248_795_950_6e-21];
    let marked = x * FRAC_2_PI + WHOLE;
    let quarters = marked - WHOLE;
    let rest = ((x - quarters * PARTS[0]) - quarters * PARTS[1]) - quarters * PARTS[2];
    (rest, marked.to_bits())
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

/// `ln x = k ln 2 + 2 artanh s` for [normal numbers](is_normal), with `x = 2ᵏ m`, `√½ < m ≤ √2` and `s = (m − 1)/(m + 1)`.
#[inline(always)]
pub(crate) fn ln_polynomial(x: f64) -> f64 {
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
    k * LN_2 + (2.0 * s + 2.0 * s * q * polynomial(q, &ARTANH))
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

/// `(arctan x/x − 1)/q` for `x ≤ tan π/8`.
const ATAN: [f64; 12] = [
    -0.333_333_333_333_333_3,
    0.199_999_999_999_998_04,
    -0.142_857_142_856_598_28,
    0.111_111_111_051_554_47,
    -0.090_909_087_535_008_77,
    0.076_922_963_750_321_43,
    -0.066_664_248_857_382_55,
    0.058_789_289_978_347_75,
    -0.052_304_542_706_502_44,
    0.045_515_932_206_265_49,
    -0.034_570_561_981_427_744,
    0.016_285_756_855_221_028,
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

    /// The largest error of a function over many numbers from a range, over the given size.
    fn worst([from, to]: [f64; 2], [ours, library]: [fn(f64) -> f64; 2], size: fn(f64) -> f64) -> f64 {
        const COUNT: usize = 100_003;
        let at = |n: usize| from + (to - from) * n as f64 / (COUNT - 1) as f64;
        (0..COUNT).map(at).map(|x| (ours(x) - library(x)).abs() / size(library(x))).fold(0.0, f64::max)
    }

    #[test]
    fn functions_are_those_of_the_library_to_the_errors_they_say() {
        for range in [[-1.0, 1.0], [-10.0, 10.0], [-1000.0, 1000.0], [0.9e6, 1.1e6]] {
            let functions: [(_, [fn(f64) -> f64; 2]); 2] =
                [("sin", [sin, f64::sin]), ("cos", [cos, f64::cos])];
            for (name, function) in functions {
                let off = worst(range, function, |_| 1.0);
                assert!(off <= 2e-16, "{name} on {range:?}: {off:e}");
            }
        }
        for range in [[1e-310, 1e-307], [1e-300, 1e-290], [1e-5, 0.1], [0.5, 2.0], [1.0, 1e6]] {
            let off = worst(range, [ln, f64::ln], |y| y.abs().max(1.0));
            assert!(off <= 3e-16, "ln on {range:?}: {off:e}");
        }
    }

    #[test]
    fn inverse_functions_keep_their_digits_at_every_size() {
        let inverse: [(_, [fn(f64) -> f64; 2]); 2] =
            [("asin", [asin, f64::asin]), ("acos", [acos, f64::acos])];
        for range in [[-1.0, 1.0], [-1e-5, 1e-5], [1.0 - 1e-9, 1.0], [-1.0, 1e-9 - 1.0], [0.38, 0.39]] {
            for (name, function) in inverse {
                let off = worst(range, function, |y| y.abs().max(1e-300));
                assert!(off <= 5e-16, "{name} on {range:?}: {off:e}");
            }
        }
        for turn in 0..100_003 {
            let angle = std::f64::consts::TAU * f64::from(turn) / 100_003.0 + 1e-4;
            for size in [1e-200, 1.0, 7e250] {
                let (y, x) = (size * angle.sin(), size * angle.cos());
                let (found, library) = (atan2(y, x), y.atan2(x));
                assert!((found - library).abs() <= 5e-16 * library.abs(), "{y} {x}: {found} {library}");
            }
        }
    }

    #[test]
    fn directions_along_axes_are_exact() {
        for (y, x) in [(0.0, 1.0), (-0.0, 1.0), (1.0, 1.0), (1.0, 0.0), (1.0, -0.0), (-1.0, 0.0), (1.0, -1.0)]
        {
            assert_eq!(atan2(y, x).to_bits(), y.atan2(x).to_bits(), "{y} {x}");
        }
        for (y, x) in [
            (0.0, -1.0),
            (-0.0, -1.0),
            (0.0, 0.0),
            (-0.0, -0.0),
            (0.0, -0.0),
            (3e307, 4e307),
            (4e-320, 3e-320),
        ] {
            assert_eq!(atan2(y, x).to_bits(), y.atan2(x).to_bits(), "{y} {x}");
        }
        for x in [0.0, 1.0, -1.0] {
            assert_eq!((asin(x), acos(x)), (x.asin(), x.acos()), "{x}");
        }
        for x in [1.1, -2.0, f64::NAN, f64::INFINITY] {
            assert!(asin(x).is_nan() && acos(x).is_nan(), "{x}");
        }
        assert!(atan2(f64::NAN, 1.0).is_nan() && atan2(1.0, f64::NAN).is_nan());
    }

    #[test]
    fn small_results_keep_their_digits() {
        for (x, size) in [(1e-9, 1e-9), (std::f64::consts::PI, 1.3e-16), (-1e-300, 1e-300)] {
            assert!((sin(x) - x.sin()).abs() <= 2e-16 * size, "{x}");
        }
        assert!((cos(std::f64::consts::FRAC_PI_2) - std::f64::consts::FRAC_PI_2.cos()).abs() < 1e-31);
        assert!((ln(1.0 + 1e-9) - (1.0 + 1e-9f64).ln()).abs() <= 2e-25);
    }

    #[test]
    fn ends_are_exact_and_what_has_no_answer_is_not_a_number() {
        assert_eq!((sin(0.0), cos(0.0), ln(1.0), ln(2.0)), (0.0, 1.0, 0.0, LN_2));
        assert_eq!((ln(0.0), ln(f64::INFINITY)), (f64::NEG_INFINITY, f64::INFINITY));
        for x in [f64::INFINITY, f64::NAN] {
            assert!(sin(x).is_nan() && cos(x).is_nan(), "{x}");
        }
        assert!(ln(-1.0).is_nan() && ln(f64::NAN).is_nan());
    }
}
