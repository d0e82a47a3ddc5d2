//! Decimal digits to `f64` and back, through a unit, without losing the last bit.
//!
//! A unit's factor is `mantissa × 10^ten`. A literal's digits are multiplied by the mantissa in doubled
//! precision and the powers of ten are put together before anything is rounded. So 20.3 mm is the
//! number nearest to 0.0203, 3 in the one nearest to 0.0762, and 17 written digits bring every number back.

const EXACT: [f64; 23] = [
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18,
    1e19, 1e20, 1e21, 1e22,
];

/// `digits × mantissa × 10^ten`; infinite or zero where that is beyond `f64`.
pub(crate) fn join(digits: u64, mantissa: f64, ten: i32) -> f64 {
    if digits == 0 {
        return 0.0;
    }
    if mantissa != 1.0 {
        return Double::from(digits).times(mantissa).shift(ten).sum();
    }
    let exact = if digits < 1 << 53 { EXACT.get(ten.unsigned_abs() as usize) } else { None };
    match exact {
        Some(power) if ten < 0 => digits as f64 / power,
        Some(power) => digits as f64 * power,
        None => format!("{digits}e{ten}").parse().expect("digits and a decimal exponent are a number"),
    }
}

/// `value × 10^ten`, rounded once for |`ten`| ≤ 22.
pub(crate) fn shift(value: f64, ten: i32) -> f64 {
    Double { high: value, low: 0.0 }.shift(ten).sum()
}

/// `value / (mantissa × 10^ten)` as `count` significant digits and the power of ten of the first of them.
///
/// `value` and `mantissa` are finite and positive, `count` is 1 to 17.
pub(crate) fn split(value: f64, mantissa: f64, ten: i32, count: usize) -> (String, i32) {
    if mantissa == 1.0 {
        let text = format!("{:.*e}", count - 1, value);
        let (digits, exponent) = text.split_once('e').expect("`{:e}` writes an `e`");
        let exponent: i32 = exponent.parse().expect("`{:e}` writes a whole exponent");
        return (digits.replace('.', ""), exponent - ten);
    }
    let quotient = Double { high: value, low: 0.0 }.over(mantissa);
    let mut exponent = quotient.high.log10().floor() as i32;
    loop {
        // The estimate is at most one off; the digit count tells.
        let digits = quotient.shift(count as i32 - 1 - exponent).rounded().to_string();
        match digits.len().cmp(&count) {
            std::cmp::Ordering::Equal => return (digits, exponent - ten),
            std::cmp::Ordering::Greater => exponent += 1,
            std::cmp::Ordering::Less => exponent -= 1,
        }
    }
}

/// An unevaluated sum of two numbers: some 32 significant digits.
#[derive(Clone, Copy)]
struct Double {
    high: f64,
    low: f64,
}

impl From<u64> for Double {
    fn from(digits: u64) -> Self {
        let high = digits as f64;
        Double { high, low: (i128::from(digits) - high as i128) as f64 }
    }
}

impl Double {
    fn times(self, factor: f64) -> Self {
        let high = self.high * factor;
        let low = self.high.mul_add(factor, -high) + self.low * factor;
        Self::normal(high, low)
    }

    fn over(self, divisor: f64) -> Self {
        let high = self.high / divisor;
        let low = ((-high).mul_add(divisor, self.high) + self.low) / divisor;
        Self::normal(high, low)
    }

    fn shift(mut self, ten: i32) -> Self {
        let mut left = ten.unsigned_abs() as usize;
        while left > 0 && self.high.is_finite() && self.high != 0.0 {
            let step = left.min(EXACT.len() - 1);
            self = if ten < 0 { self.over(EXACT[step]) } else { self.times(EXACT[step]) };
            left -= step;
        }
        self
    }

    fn sum(self) -> f64 {
        self.high + self.low
    }

    fn rounded(self) -> i128 {
        let whole = self.high.floor();
        whole as i128 + ((self.high - whole) + self.low).round() as i128
    }

    /// Beyond `f64` the correction is not a number; the high part alone tells infinity.
    fn normal(high: f64, low: f64) -> Self {
        if !low.is_finite() {
            return Self { high, low: 0.0 };
        }
        let sum = high + low;
        Self { high: sum, low: if sum.is_finite() { low - (sum - high) } else { 0.0 } }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_literal_and_a_prefix_round_once() {
        assert_eq!(join(203, 1.0, -4), 0.0203);
        assert_eq!(join(3, 254.0, -4), 0.0762);
        assert_eq!(join(7, 980665.0, -5), 68.64655);
        assert_eq!(join(u64::MAX, 1.0, -30), 1.844_674_407_370_955_2e-11);
        assert_eq!(join(1, 1.0, 400), f64::INFINITY);
        assert_eq!(join(1, 3.0, 400), f64::INFINITY);
        assert_eq!(join(1, 3.0, -400), 0.0);
        assert_eq!(join(0, 3.0, 99_999), 0.0);
    }

    #[test]
    fn digits_are_rounded_correctly() {
        assert_eq!(split(0.0203, 1.0, -3, 5), ("20300".into(), 1));
        assert_eq!(split(0.0762, 254.0, -4, 16), ("3000000000000000".into(), 0));
        assert_eq!(split(2.0, 3.0, 0, 17), ("66666666666666667".into(), -1));
        assert_eq!(split(2.0, 3.0, 0, 1), ("7".into(), -1));
        assert_eq!(split(2.9999, 3.0, 0, 3), ("100".into(), 0));
        // A third of the number before 3000 is 999.999 999 999 999 848…, whose logarithm is rounded to 3.
        assert_eq!(split(2999.9999999999995, 3.0, 0, 17), ("99999999999999985".into(), 2));
    }

    #[test]
    fn seventeen_digits_bring_the_number_back() {
        let mut bits: u64 = 0x9e37_79b9_7f4a_7c15;
        for mantissa in [1.0, 254.0, 4.4482216152605, std::f64::consts::TAU / 60.0, 0.453_592_37] {
            for _ in 0..20_000 {
                bits = bits.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
                let value =
                    (1.0 + (bits >> 12) as f64 / (1u64 << 52) as f64) * 2f64.powi((bits >> 3) as i32 % 60);
                let (digits, exponent) = split(value, mantissa, -3, 17);
                assert_eq!(join(digits.parse().unwrap(), mantissa, exponent - 16 - 3), value);
            }
        }
    }
}
