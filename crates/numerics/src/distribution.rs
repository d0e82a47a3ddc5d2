//! Probability distributions by their quantile functions.
//!
//! ```
//! use dalembert_numerics::distribution::{Distribution, normal_cumulative};
//!
//! // A shaft of 25 mm with a standard deviation of 0.01 mm: 97.5 % of all are below the mean and 1.96 deviations.
//! let diameter = Distribution::normal(25.0, 0.01).expect("the deviation is above zero");
//! assert!((diameter.quantile(0.975) - 25.019_599_639_845_4).abs() < 1e-12);
//! assert!((normal_cumulative(1.959_963_984_540_054) - 0.975).abs() < 1e-15);
//! // A triangle from 0 to 2 with its peak at 2: the share below x is x²/4.
//! let triangle = Distribution::triangular(0.0, 2.0, 2.0).expect("the ends ascend");
//! assert!((triangle.quantile(0.25) - 1.0).abs() < 1e-15);
//! ```

use std::f64::consts::FRAC_1_SQRT_2;

use crate::{
    Real,
    simd::{SimdVector, WIDTH, widest},
};

/// A distribution of a number.
#[derive(Clone, Debug, PartialEq)]
pub enum Distribution {
    /// The same density between two ends.
    Uniform {
        /// Least value.
        from: f64,
        /// Largest value.
        to: f64,
    },
    /// Normal.
    Normal {
        /// Mean.
        mean: f64,
        /// Standard deviation.
        deviation: f64,
    },
    /// Triangular.
    Triangular {
        /// Least value.
        from: f64,
        /// Most probable value.
        mode: f64,
        /// Largest value.
        to: f64,
    },
    /// Lognormal: the logarithm is normal.
    Lognormal {
        /// Mean of the logarithm.
        mean: f64,
        /// Standard deviation of the logarithm.
        deviation: f64,
    },
    /// Measured values, ascending, with straight lines between them in the cumulative distribution.
    Data(Vec<f64>),
}

impl Distribution {
    /// Uniform between two ends; `None` unless they ascend.
    pub fn uniform(from: f64, to: f64) -> Option<Self> {
        (from < to && (to - from).is_finite()).then_some(Self::Uniform { from, to })
    }

    /// Normal; `None` unless the numbers are finite and the standard deviation above zero.
    pub fn normal(mean: f64, deviation: f64) -> Option<Self> {
        (mean.is_finite() && deviation.is_finite() && deviation > 0.0)
            .then_some(Self::Normal { mean, deviation })
    }

    /// Triangular with its peak between two ends; `None` unless they ascend.
    pub fn triangular(from: f64, mode: f64, to: f64) -> Option<Self> {
        (from < to && (from..=to).contains(&mode) && (to - from).is_finite()).then_some(Self::Triangular {
            from,
            mode,
            to,
        })
    }

    /// Lognormal by the mean `m` and the standard deviation `s` of the number itself, whose logarithm has the variance
    /// `σ² = ln(1 + s²/m²)` and the mean `ln m − σ²/2`; `None` unless both are above zero.
    pub fn lognormal(mean: f64, deviation: f64) -> Option<Self> {
        let variance = (deviation / mean).powi(2).ln_1p();
        (mean > 0.0 && deviation > 0.0 && variance.is_finite() && mean.is_finite())
            .then(|| Self::Lognormal { mean: mean.ln() - variance / 2.0, deviation: variance.sqrt() })
    }

    /// Measured values; `None` unless there are two finite ones.
    pub fn of_data(mut values: Vec<f64>) -> Option<Self> {
        values.sort_by(f64::total_cmp);
        (values.len() >= 2 && values.iter().all(|value| value.is_finite())).then_some(Self::Data(values))
    }

    /// The value below which a share of all lies, for shares strictly between 0 and 1.
    pub fn quantile(&self, share: f64) -> f64 {
        match self {
            Self::Uniform { from, to } => from + (to - from) * share,
            Self::Normal { mean, deviation } => mean + deviation * normal_quantile(share),
            Self::Lognormal { mean, deviation } => (mean + deviation * normal_quantile(share)).exp(),
            Self::Triangular { from, mode, to } => {
                let width = to - from;
                if share * width < mode - from {
                    from + (share * width * (mode - from)).sqrt()
                } else {
                    to - ((1.0 - share) * width * (to - mode)).sqrt()
                }
            }
            Self::Data(values) => quantile_of_sorted(values, share),
        }
    }

    /// The [`quantile`](Self::quantile) of many shares in place, bit for bit.
    pub fn quantiles(&self, shares: &mut [f64]) {
        match self {
            Self::Normal { mean, deviation } => {
                normal_quantiles(shares);
                for score in shares {
                    *score = mean + deviation * *score;
                }
            }
            Self::Lognormal { mean, deviation } => {
                normal_quantiles(shares);
                for score in shares {
                    *score = (mean + deviation * *score).exp();
                }
            }
            _ => {
                for share in shares {
                    *share = self.quantile(*share);
                }
            }
        }
    }
}

/// The value below which a share of ascending values lies, as [`quantile_of_ranks`] has it. Of no values 0.
pub fn quantile_of_sorted(values: &[f64], share: f64) -> f64 {
    if values.is_empty() { 0.0 } else { quantile_of_ranks(values.len(), share, |rank| values[rank]) }
}

/// The value below which a share of so many values lies, from the values of the two [ranks](ranks_about) about it, with a
/// straight line between them: definition 7 of R. J. Hyndman and Y. Fan, *Am. Stat.* 50 (1996).
pub fn quantile_of_ranks(count: usize, share: f64, value: impl Fn(usize) -> f64) -> f64 {
    let [below, above] = ranks_about(count, share);
    let (low, high) = (value(below), value(above));
    low + (high - low) * (share * count.saturating_sub(1) as f64 - below as f64)
}

/// The ranks in ascending order, counted from 0, of the two values that a quantile of so many values lies between.
pub fn ranks_about(count: usize, share: f64) -> [usize; 2] {
    let last = count.saturating_sub(1);
    let below = ((share * last as f64) as usize).min(last);
    [below, (below + 1).min(last)]
}

/// The standard normal number below which a share lies, for shares strictly between 0 and 1, to within 2·10⁻¹⁵.
///
/// Rational approximations of M. J. Wichura, *Algorithm AS 241: The Percentage Points of the Normal Distribution*,
/// Appl. Stat. 37 (1988), routine PPND16.
pub fn normal_quantile(share: f64) -> f64 {
    if is_central(share) {
        return central_quantile(share);
    }
    let r = tail_root(share);
    let size = if r <= FAR { quotient(&TAIL, r - 1.6) } else { quotient(&FAR_TAIL, r - FAR) };
    size.copysign(share - 0.5)
}

/// The [`normal_quantile`] of many shares in place, bit for bit.
pub fn normal_quantiles(shares: &mut [f64]) {
    widest(
        #[inline(always)]
        || {
            for block in shares.chunks_mut(QUANTILES) {
                // The tails, one after the other, so that no SIMD vector is computed for a few of its lanes.
                let (mut tails, mut places, mut count) = ([0.5; QUANTILES], [0; QUANTILES], 0);
                for (place, share) in block.iter().enumerate() {
                    (tails[count], places[count]) = (*share, place);
                    count += usize::from(!is_central(*share));
                }
                let (whole, rest) = block.as_chunks_mut::<WIDTH>();
                for shares in whole {
                    *shares = central_quantile(SimdVector(*shares)).0;
                }
                for share in rest {
                    *share = central_quantile(*share);
                }
                let places = places[..count].chunks(WIDTH);
                for (places, tails) in places.zip(tails.as_chunks::<WIDTH>().0) {
                    let root = tail_root(SimdVector(*tails));
                    let sizes = quotient(&TAIL, root - 1.6);
                    for (lane, place) in places.iter().enumerate() {
                        block[*place] = if root.0[lane] <= FAR {
                            sizes.0[lane].copysign(tails[lane] - 0.5)
                        } else {
                            normal_quantile(tails[lane])
                        };
                    }
                }
            }
        },
    );
}

/// Shares that are taken together.
const QUANTILES: usize = 256;

#[inline(always)]
fn is_central(share: f64) -> bool {
    (share - 0.5).abs() <= 0.425
}

#[inline(always)]
fn central_quantile<S: Real>(share: S) -> S {
    let off = share - 0.5;
    let r = S::from(0.180_625) - off * off;
    off * polynomial(&CENTRE[0], r) / polynomial(&CENTRE[1], r)
}

/// `√(−ln p)` of the share `p` of the nearer tail.
#[inline(always)]
fn tail_root<S: Real>(share: S) -> S {
    (-share.min(S::from(1.0) - share).ln()).sqrt()
}

/// Beginning of the far tail, as `√(−ln p)`.
const FAR: f64 = 5.0;

#[inline(always)]
fn quotient<S: Real>([numerator, denominator]: &[[f64; 8]; 2], x: S) -> S {
    polynomial(numerator, x) / polynomial(denominator, x)
}

/// The share of standard normal numbers below a number, kept strictly between 0 and 1.
pub fn normal_cumulative(number: f64) -> f64 {
    let share = libm::erfc(-number * FRAC_1_SQRT_2) / 2.0;
    share.clamp(f64::MIN_POSITIVE, 1.0 - f64::EPSILON / 2.0)
}

/// A polynomial by its coefficients, the constant one first.
#[inline(always)]
fn polynomial<S: Real>(coefficients: &[f64; 8], x: S) -> S {
    let mut sum = S::from(coefficients[7]);
    for n in (0..7).rev() {
        sum = sum * x + coefficients[n];
    }
    sum
}

/// Numerator and denominator for shares within 0.425 of a half.
#[rustfmt::skip]
const CENTRE: [[f64; 8]; 2] = [
    [
        3.387_132_872_796_366_5, 133.141_667_891_784_38, 1_971.590_950_306_551_3, 13_731.693_765_509_46,
        45_921.953_931_549_87, 67_265.770_927_008_7, 33_430.575_583_588_13, 2_509.080_928_730_122_7,
    ],
    [
        1.0, 42.313_330_701_600_91, 687.187_007_492_057_9, 5_394.196_021_424_751,
        21_213.794_301_586_597, 39_307.895_800_092_71, 28_729.085_735_721_943, 5_226.495_278_852_854,
    ],
];

/// The same for tails down to e⁻²⁵.
#[rustfmt::skip]
const TAIL: [[f64; 8]; 2] = [
    [
        1.423_437_110_749_683_5, 4.630_337_846_156_546, 5.769_497_221_460_691, 3.647_848_324_763_204_5,
        1.270_458_252_452_368_4, 0.241_780_725_177_450_6, 0.022_723_844_989_269_184, 7.745_450_142_783_414e-4,
    ],
    [
        1.0, 2.053_191_626_637_759, 1.676_384_830_183_803_8, 0.689_767_334_985_1,
        0.148_103_976_427_480_08, 0.015_198_666_563_616_457, 5.475_938_084_995_345e-4, 1.050_750_071_644_416_9e-9,
    ],
];

/// The same beyond.
#[rustfmt::skip]
const FAR_TAIL: [[f64; 8]; 2] = [
    [
        6.657_904_643_501_103, 5.463_784_911_164_114, 1.784_826_539_917_291_3, 0.296_560_571_828_504_87,
        0.026_532_189_526_576_124, 1.242_660_947_388_078_4e-3, 2.711_555_568_743_487_6e-5, 2.010_334_399_292_288_1e-7,
    ],
    [
        1.0, 0.599_832_206_555_888, 0.136_929_880_922_735_8, 0.014_875_361_290_850_615,
        7.868_691_311_456_133e-4, 1.846_318_317_510_054_8e-5, 1.421_511_758_316_446e-7, 2.044_263_103_389_939_8e-15,
    ],
];
