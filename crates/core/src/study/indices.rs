//! Sobol' indices of answers: the shares of their variance that inputs have, from base samples in their order.
//!
//! A base sample is `d + 2` points of `d` independent inputs (A. Saltelli et al., *Comput. Phys. Commun.* 181, 2010,
//! 259–270): `A` and `B` are drawn apart, and `ABᵢ` is `A` with the input `i` of `B`. So `B` and `ABᵢ` have the input
//! `i` alone in common, and `A` and `ABᵢ` all others. With the correlation coefficient `ρ` of the answer over a pair of
//! points, both of one mean and variance,
//!
//! `Sᵢ = ρ(B, ABᵢ)` is the first-order index, and `S_Tᵢ = 1 − ρ(A, ABᵢ)` the total index.
//!
//! These are the estimators of M. J. W. Jansen, *Comput. Phys. Commun.* 117 (1999) 35–43, over the variance of the same
//! pairs, which makes them asymptotically efficient (A. Janon et al., *ESAIM Probab. Stat.* 18, 2014, 342–364).

use serde::Serialize;

/// Points of a base sample beside those of the inputs: `A` and `B`, which are independent.
pub(super) const INDEPENDENT: usize = 2;
/// Standard normal number of a two-sided interval of 95 %.
pub(super) const TWO_SIDED_95: f64 = 1.959_963_984_540_054;
/// Base samples whose sums are taken together.
const BLOCK: u64 = 4096;

/// Sobol' indices of an answer.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct SobolIndices {
    /// Base samples whose points all have the answer.
    pub samples: u64,
    /// Base samples that are left out, since a point of them has no answer.
    pub left_out: u64,
    /// Of each input; none where the answer is constant.
    pub inputs: Vec<SobolIndex>,
}

/// Shares of an input in the variance of an answer.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct SobolIndex {
    /// First-order index: the share by which the variance falls on average where this input is known.
    pub first_order: Estimate,
    /// Total index: the share that is left on average where all other inputs are known.
    pub total: Estimate,
}

/// Estimate with its 95 % confidence interval, asymptotically normal by the delta method. It is that of random samples;
/// those of a Latin hypercube or the Sobol' sequence lie closer.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Estimate {
    /// Estimate.
    pub value: f64,
    /// Ends of the interval.
    pub interval: [f64; 2],
}

/// Sums over the base samples of an answer.
#[derive(Clone, Debug, Default)]
pub(super) struct IndexSums {
    samples: u64,
    left_out: u64,
    /// The first value: sums are taken about it.
    centre: Option<f64>,
    /// Of each input: the pairs `B` and `ABᵢ`, and `A` and `ABᵢ`.
    inputs: Vec<[PairSums; 2]>,
}

/// Sums of powers and products of `s = (u + v)/2` and the square of `(u − v)/2` over pairs `u`, `v`, those of the present
/// block apart.
#[derive(Clone, Copy, Debug, Default)]
struct PairSums {
    all: [f64; 8],
    block: [f64; 8],
}

impl IndexSums {
    pub(super) fn new(inputs: usize) -> Self {
        Self { inputs: vec![[PairSums::default(); 2]; inputs], ..Self::default() }
    }

    /// Takes the values of the answer at the points of a base sample: at `A`, `B`, and each `ABᵢ`.
    pub(super) fn take(&mut self, values: &[f64]) {
        let (Some([a, b]), Some(mixed)) = (values.first_chunk::<INDEPENDENT>(), values.get(INDEPENDENT..))
        else {
            return;
        };
        if !values.iter().all(|value| value.is_finite()) {
            self.left_out += 1;
            return;
        }
        self.samples += 1;
        let centre = *self.centre.get_or_insert(*a);
        let is_whole_block = self.samples.is_multiple_of(BLOCK);
        for ([of_first, of_total], mixed) in self.inputs.iter_mut().zip(mixed) {
            of_first.take(b - centre, mixed - centre);
            of_total.take(a - centre, mixed - centre);
            if is_whole_block {
                of_first.end_block();
                of_total.end_block();
            }
        }
    }

    pub(super) fn indices(mut self) -> SobolIndices {
        let count = self.samples as f64;
        let of_input = |[of_first, of_total]: &mut [PairSums; 2]| {
            let (first, total) = (of_first.correlation(count)?, of_total.correlation(count)?);
            let [low, high] = total.interval;
            let total = Estimate { value: 1.0 - total.value, interval: [1.0 - high, 1.0 - low] };
            Some(SobolIndex { first_order: first, total })
        };
        let inputs: Option<Vec<SobolIndex>> = self.inputs.iter_mut().map(of_input).collect();
        SobolIndices { samples: self.samples, left_out: self.left_out, inputs: inputs.unwrap_or_default() }
    }
}

impl PairSums {
    fn take(&mut self, u: f64, v: f64) {
        let (s, d) = (f64::midpoint(u, v), (u - v) / 2.0);
        let (s2, d2) = (s * s, d * d);
        for (sum, term) in self.block.iter_mut().zip([s, s2, s2 * s, s2 * s2, d2, d2 * d2, s * d2, s2 * d2]) {
            *sum += term;
        }
    }

    fn end_block(&mut self) {
        for (sum, block) in self.all.iter_mut().zip(&mut self.block) {
            *sum += std::mem::take(block);
        }
    }

    /// The correlation coefficient `ρ = (P − Q)/(P + Q)` of so many pairs of equal means and variances, with the
    /// variance `P` of `s` and the mean square `Q` of `d`; `None` where the values are one.
    ///
    /// Its variance is that of the mean of `((1 − ρ) s² − (1 + ρ) d²)/(P + Q)`, `s` about its mean.
    fn correlation(&mut self, count: f64) -> Option<Estimate> {
        self.end_block();
        let [s, s2, s3, s4, d2, d4, sd2, s2d2] = self.all.map(|sum| sum / count);
        let p = s2 - s * s;
        let sum = p + d2;
        if !(sum > 0.0 && sum.is_finite()) {
            return None;
        }
        let correlation = (p - d2) / sum;
        let fourth = s4 - 4.0 * s * s3 + 6.0 * s * s * s2 - 3.0 * s.powi(4);
        let mixed = s2d2 - 2.0 * s * sd2 + s * s * d2;
        let (less, more) = (1.0 - correlation, 1.0 + correlation);
        let variance = (less * less * fourth - 2.0 * less * more * mixed + more * more * d4) / (sum * sum);
        let half = TWO_SIDED_95 * (variance.max(0.0) / count).sqrt();
        Some(Estimate { value: correlation, interval: [correlation - half, correlation + half] })
    }
}
