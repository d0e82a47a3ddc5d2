//! Propagation of the uncertainty of the readings to the correction weights, by Monte Carlo.
//!
//! Every number is drawn from its own place: seed, sample and number. So samples may be shared out among any number
//! of threads and are the same to the last bit.

use std::{f64::consts::PI, thread};

use dalembert_numerics::random::normal_pair;
use nalgebra::{Complex, DMatrix};

use super::{
    influence::{TrialRun, influence_coefficients, residuals},
    minimax::min_max_within,
};
mod two_plane;

pub use two_plane::{SEED, Statistics, two_plane_statistics};

/// Optimality gap of a minimax solution in each sample, over the uncertainty of the readings: a difference that a range
/// cannot show need not be resolved.
const SAMPLE_GAP: f64 = 1e-3;

/// Standard uncertainties of a reading.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ReadingSpread {
    /// Of the amplitude, over the amplitude.
    pub amplitude: f64,
    /// Of the phase, rad.
    pub phase: f64,
}

/// Source of the influence coefficients: trial runs or known values.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Influence<'a> {
    /// Runs with trial weights, which stay on or not.
    Runs(&'a [TrialRun], bool),
    /// Known coefficients, a row for each reading, as uncertain as a reading.
    Known(&'a DMatrix<Complex<f64>>),
}

/// Criterion by which the weights of a sample are chosen, the same as for the nominal weights.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Choice<'a> {
    /// Least squares, with the importance of each reading; 1 where it is left out.
    LeastSquares(&'a [f64]),
    /// The largest reading as small as possible, each weight within the limit.
    MinMax(Option<f64>),
}

/// A job of field balancing as it was measured.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Measurement<'a> {
    /// The readings without weights.
    pub first: &'a [Complex<f64>],
    /// The source of the influence coefficients.
    pub influence: Influence<'a>,
    /// Criterion by which the weights are chosen.
    pub choice: Choice<'a>,
    /// The uncertainty of each reading.
    pub spread: ReadingSpread,
}

/// Ranges that hold 95 % of the samples.
#[derive(Debug, Clone, PartialEq)]
pub struct Ranges {
    /// Size of the weight in each plane. It begins at zero where the given weight cannot be distinguished from none:
    /// noise alone makes weights that are larger than it. The given weight always lies in it.
    pub sizes: Vec<[f64; 2]>,
    /// Range of the angle, rad, unwrapped about the angle of the given weights; a whole revolution where the range of
    /// the magnitude begins at zero.
    pub angles: Vec<[f64; 2]>,
    /// 95th percentile of the magnitude of each residual reading with the given weights.
    pub residuals: Vec<f64>,
}

/// The ranges of the weights and of the readings that `weights` leave, from `samples` jobs that
/// might as well have been measured. `None` where a sample has no answer or a number is not finite.
pub fn ranges(
    measured: &Measurement<'_>,
    weights: &[Complex<f64>],
    samples: usize,
    threads: usize,
) -> Option<Ranges> {
    const SEED: u64 = 0x0b41_a9ce;
    let (planes, readings) = (weights.len(), measured.first.len());
    let width = 2 * planes + readings;
    let mut drawn = vec![0.0; samples * width];
    let share = samples.div_ceil(threads.max(1)).max(1);
    let good = thread::scope(|scope| {
        let workers: Vec<_> = drawn
            .chunks_mut(share * width)
            .enumerate()
            .map(|(n, part)| {
                let mut work = move || {
                    part.chunks_mut(width)
                        .zip(n * share..)
                        .try_for_each(|(row, sample)| one_sample(measured, weights, SEED, sample as u64, row))
                };
                if threads > 1 { Err(scope.spawn(work)) } else { Ok(work()) }
            })
            .collect();
        workers
            .into_iter()
            .all(|done| done.unwrap_or_else(|worker| worker.join().unwrap_or_default()).is_some())
    });
    if !good || samples == 0 || drawn.iter().any(|x| !x.is_finite()) {
        return None;
    }
    let column = |at: usize| {
        let mut all: Vec<f64> = drawn.iter().skip(at).step_by(width).copied().collect();
        all.sort_unstable_by(f64::total_cmp);
        move |share: f64| all[((samples as f64 * share) as usize).min(samples - 1)]
    };
    // Intervals of equal probability beyond both ends, JCGM 101:2008, §7.7.
    let middle = |at: usize| {
        let column = column(at);
        [column(0.025), column(0.975)]
    };
    let of_plane = |(plane, weight): (usize, &Complex<f64>)| {
        let [low, high] = middle(plane);
        if weight.norm() < low {
            // Of the intervals that hold 95 %, one with the estimate in it; nothing is known of its angle.
            return ([0.0, column(plane)(0.95)], [weight.arg() - PI, weight.arg() + PI]);
        }
        // An interval that also reaches to the estimate, as that of a weight at its limit must, holds no less.
        let [back, on] = middle(planes + plane);
        ([low, high.max(weight.norm())], [back.min(0.0), on.max(0.0)].map(|turn| turn + weight.arg()))
    };
    let (sizes, angles) = weights.iter().enumerate().map(of_plane).unzip();
    let ranges = Ranges {
        sizes,
        angles,
        residuals: (0..readings).map(|row| column(2 * planes + row)(0.95)).collect(),
    };
    ranges.sizes.iter().flatten().all(|size| size.is_finite()).then_some(ranges)
}

/// Sizes, turns and residuals of one sample.
fn one_sample(
    measured: &Measurement<'_>,
    weights: &[Complex<f64>],
    seed: u64,
    sample: u64,
    row: &mut [f64],
) -> Option<()> {
    let planes = weights.len();
    let mut place = 0;
    let mut disturb = |reading: Complex<f64>| {
        let [a, b] = normal_pair(seed, sample, place);
        place += 1;
        reading * Complex::from_polar(1.0 + measured.spread.amplitude * a, measured.spread.phase * b)
    };
    let first: Vec<Complex<f64>> = measured.first.iter().map(|v| disturb(*v)).collect();
    let alpha = match measured.influence {
        Influence::Known(alpha) => alpha.map(&mut disturb),
        Influence::Runs(runs, stay) => {
            let mut runs = runs.to_vec();
            for reading in runs.iter_mut().flat_map(|run| &mut run.readings) {
                *reading = disturb(*reading);
            }
            influence_coefficients(&first, &runs, stay).ok()?
        }
    };
    let found = match measured.choice {
        Choice::LeastSquares(importance) => normal_equations(&alpha, &first, importance)?,
        Choice::MinMax(limit) => {
            let doubt = measured.spread.amplitude.max(measured.spread.phase);
            min_max_within(&alpha, &first, limit, SAMPLE_GAP * doubt).ok()?.weights
        }
    };
    for (plane, (found, nominal)) in found.iter().zip(weights).enumerate() {
        row[plane] = found.norm();
        row[planes + plane] = if nominal.norm() > 0.0 { (found / nominal).arg() } else { found.arg() };
    }
    for (place, left) in row[2 * planes..].iter_mut().zip(residuals(&alpha, &first, weights)) {
        *place = left.norm();
    }
    Some(())
}

/// Least squares by `αᴴ g α W = −αᴴ g V`: half the digits, which is plenty for a sample.
fn normal_equations(
    alpha: &DMatrix<Complex<f64>>,
    readings: &[Complex<f64>],
    importance: &[f64],
) -> Option<Vec<Complex<f64>>> {
    let (rows, n) = alpha.shape();
    let weight = |row: usize| importance.get(row).copied().unwrap_or(1.0);
    let mut a = vec![Complex::ZERO; n * (n + 1)];
    for p in 0..n {
        for q in 0..=n {
            a[p * (n + 1) + q] = (0..rows)
                .map(|row| {
                    let right = if q < n { alpha[(row, q)] } else { -readings[row] };
                    alpha[(row, p)].conj() * right * weight(row)
                })
                .sum();
        }
    }
    // A positive definite matrix needs no exchange of rows.
    for p in 0..n {
        let pivot = a[p * (n + 1) + p];
        if pivot.norm_sqr() == 0.0 || !pivot.is_finite() {
            return None;
        }
        for row in p + 1..n {
            let factor = a[row * (n + 1) + p] / pivot;
            for q in p..=n {
                let above = a[p * (n + 1) + q];
                a[row * (n + 1) + q] -= factor * above;
            }
        }
    }
    let mut x = vec![Complex::ZERO; n];
    for p in (0..n).rev() {
        let sum: Complex<f64> = (p + 1..n).map(|q| a[p * (n + 1) + q] * x[q]).sum();
        x[p] = (a[p * (n + 1) + n] - sum) / a[p * (n + 1) + p];
    }
    Some(x)
}
