//! Minimax balancing: the weights that minimise the largest reading, each weight within a limit.

use nalgebra::{Complex, DMatrix};

use super::influence::{InfluenceError, least_squares, residuals};
use dalembert_numerics::linalg::LinalgError;

/// Weights whose largest reading is least.
#[derive(Debug, Clone, PartialEq)]
pub struct MinMax {
    /// The weight of each plane.
    pub weights: Vec<Complex<f64>>,
    /// Predicted readings of the sensors, one per sensor.
    pub residuals: Vec<Complex<f64>>,
    /// The largest of them.
    pub largest: f64,
    /// No permitted weights can bring the largest reading below this: the proof that `largest` is the least.
    pub bound: f64,
}

/// Relative optimality gap: excess of the largest reading over the proved lower bound, over its magnitude before
/// balancing.
const GAP: f64 = 3e-10;
/// A centre counts as reached when Newton's decrement is below this; rounding keeps the last one above 10⁻⁶.
const CENTRED: f64 = 1e-4;
/// The most steps in all; a hundred or so suffice.
const MOST_STEPS: usize = 400;
/// Full steps to the last centre, where rounding may hide it: they double the digits each.
const FULL_STEPS: usize = 6;
/// Steps about the last centre while the bound is not yet near enough.
const LAST_STEPS: usize = 40;

/// The weights that make `max |Vᵢ + (α W)ᵢ|` least, with `|W| ≤ limit` in every plane.
///
/// A second-order cone problem. Its logarithmic barrier is followed by damped Newton steps, which never leave the
/// permitted weights; the barrier's own multipliers give a lower bound on the largest reading, so that the result
/// carries its proof (Boyd and Vandenberghe, Convex Optimization, §11.3 and §11.6).
///
/// # Errors
/// `TooFewReadings`; `Linalg`: `NotFinite`, `NotConverged`.
pub fn min_max(
    alpha: &DMatrix<Complex<f64>>,
    readings: &[Complex<f64>],
    limit: Option<f64>,
) -> Result<MinMax, InfluenceError> {
    min_max_within(alpha, readings, limit, GAP)
}

/// As [`min_max`], but only so near to the bound that the largest reading lies above it by `gap` of its size before
/// balancing, or by what [`min_max`] itself leaves where that is more.
///
/// # Errors
/// As [`min_max`].
pub fn min_max_within(
    alpha: &DMatrix<Complex<f64>>,
    readings: &[Complex<f64>],
    limit: Option<f64>,
    gap: f64,
) -> Result<MinMax, InfluenceError> {
    let (rows, planes) = alpha.shape();
    if rows < planes {
        return Err(InfluenceError::TooFewReadings { readings: rows, planes });
    }
    let size = readings.iter().map(|v| v.norm()).fold(0.0, f64::max);
    let effect = alpha.iter().map(|a| a.norm()).fold(0.0, f64::max);
    if !(size.is_finite() && effect.is_finite() && size > 0.0 && effect > 0.0) {
        return Err(LinalgError::NotFinite.into());
    }
    // In units of the largest reading and the largest effect.
    let unit = size / effect;
    let scaled = alpha / Complex::from(effect);
    let from: Vec<Complex<f64>> = readings.iter().map(|v| v / size).collect();
    let problem = Barrier {
        alpha: &scaled,
        readings: &from,
        limit: limit.map(|limit| limit / unit),
        gap: gap.max(GAP),
    };
    let (weights, bound) = problem.solve().ok_or(LinalgError::NotConverged)?;
    let weights: Vec<Complex<f64>> = weights.into_iter().map(|w| w * unit).collect();
    let residuals = residuals(alpha, readings, &weights);
    let largest = residuals.iter().map(|r| r.norm()).fold(0.0, f64::max);
    Ok(MinMax { weights, residuals, largest, bound: bound * size })
}

struct Barrier<'a> {
    alpha: &'a DMatrix<Complex<f64>>,
    readings: &'a [Complex<f64>],
    limit: Option<f64>,
    gap: f64,
}

impl Barrier<'_> {
    /// The weights, and the proved bound.
    fn solve(&self) -> Option<(Vec<Complex<f64>>, f64)> {
        let planes = self.alpha.ncols();
        let cones = self.readings.len() + if self.limit.is_some() { planes } else { 0 };
        let mut weights = vec![Complex::ZERO; planes];
        let mut top = 2.0;
        let mut sharpness = cones as f64;
        let mut steps = 0;
        loop {
            let last = 2.0 * cones as f64 <= self.gap * sharpness;
            let mut full = 0;
            loop {
                steps += 1;
                if steps > MOST_STEPS {
                    return None;
                }
                let (step, decrement) = self.newton(&weights, top, sharpness)?;
                let damping = if decrement > 0.25 { 1.0 / (1.0 + decrement) } else { 1.0 };
                for (plane, w) in weights.iter_mut().enumerate() {
                    *w += Complex::new(step[2 * plane], step[2 * plane + 1]) * damping;
                }
                top += step[2 * planes] * damping;
                full += usize::from(decrement <= 0.25);
                if decrement < if last { CENTRED } else { 0.1 } || full >= FULL_STEPS {
                    break;
                }
            }
            if last {
                return self.proved(weights, top, sharpness);
            }
            sharpness *= 8.0;
        }
    }

    /// The best of the last centre and a few steps about it: rounding moves the barrier's multipliers there, and with
    /// them the bound.
    fn proved(
        &self,
        mut weights: Vec<Complex<f64>>,
        mut top: f64,
        sharpness: f64,
    ) -> Option<(Vec<Complex<f64>>, f64)> {
        let (mut best, mut bound) = (weights.clone(), self.bound(&weights, top));
        let largest = |weights: &[Complex<f64>]| {
            let effect = |row: usize| -> Complex<f64> {
                self.alpha.row(row).iter().zip(weights).map(|(a, w)| a * w).sum()
            };
            self.readings.iter().enumerate().map(|(row, v)| (v + effect(row)).norm()).fold(0.0, f64::max)
        };
        let mut least = largest(&best);
        for _ in 0..LAST_STEPS {
            if least - bound <= 2.0 * self.gap {
                break;
            }
            let (step, decrement) = self.newton(&weights, top, sharpness)?;
            let damping = 1.0 / (1.0 + decrement);
            for (plane, w) in weights.iter_mut().enumerate() {
                *w += Complex::new(step[2 * plane], step[2 * plane + 1]) * damping;
            }
            top += step[2 * weights.len()] * damping;
            bound = bound.max(self.bound(&weights, top));
            if largest(&weights) < least {
                least = largest(&weights);
                best.clone_from(&weights);
            }
        }
        Some((best, bound))
    }

    /// The step of Newton's method on `s τ − Σ ln(τ² − |r|²) − Σ ln(L² − |W|²)`, and its decrement.
    fn newton(&self, weights: &[Complex<f64>], top: f64, sharpness: f64) -> Option<(Vec<f64>, f64)> {
        let planes = weights.len();
        let n = 2 * planes + 1;
        let (mut gradient, mut hessian) = (vec![0.0; n], DMatrix::<f64>::zeros(n, n));
        gradient[n - 1] = sharpness;
        let mut slope = vec![0.0; n];
        for (row, r) in residuals(self.alpha, self.readings, weights).into_iter().enumerate() {
            let room = (top - r.norm()) * (top + r.norm());
            if room.is_nan() || room <= 0.0 {
                return None;
            }
            for plane in 0..planes {
                let pull = self.alpha[(row, plane)].conj() * r;
                (slope[2 * plane], slope[2 * plane + 1]) = (-2.0 * pull.re, -2.0 * pull.im);
            }
            slope[n - 1] = 2.0 * top;
            add_barrier(&mut gradient, &mut hessian, &slope, room);
            hessian[(n - 1, n - 1)] -= 2.0 / room;
            for p in 0..planes {
                for q in 0..planes {
                    let product = self.alpha[(row, p)].conj() * self.alpha[(row, q)] * (2.0 / room);
                    hessian[(2 * p, 2 * q)] += product.re;
                    hessian[(2 * p + 1, 2 * q + 1)] += product.re;
                    hessian[(2 * p, 2 * q + 1)] -= product.im;
                    hessian[(2 * p + 1, 2 * q)] += product.im;
                }
            }
        }
        if let Some(limit) = self.limit {
            for (plane, w) in weights.iter().enumerate() {
                let room = (limit - w.norm()) * (limit + w.norm());
                if room.is_nan() || room <= 0.0 {
                    return None;
                }
                slope.fill(0.0);
                (slope[2 * plane], slope[2 * plane + 1]) = (-2.0 * w.re, -2.0 * w.im);
                add_barrier(&mut gradient, &mut hessian, &slope, room);
                hessian[(2 * plane, 2 * plane)] += 2.0 / room;
                hessian[(2 * plane + 1, 2 * plane + 1)] += 2.0 / room;
            }
        }
        let downhill: Vec<f64> = gradient.iter().map(|g| -g).collect();
        let step = cholesky_solve(hessian, downhill.clone())?;
        let decrement = step.iter().zip(&downhill).map(|(s, d)| s * d).sum::<f64>().max(0.0).sqrt();
        decrement.is_finite().then_some((step, decrement))
    }

    /// For any `y` with `Σ |yᵢ| ≤ 1` and permitted weights, `max |r| ≥ Re Σ ȳᵢ rᵢ ≥ Re Σ ȳᵢ Vᵢ − Σ L |Σ ȳᵢ αᵢⱼ|`.
    /// Without a limit the best weights are also the best of those within twice their size, a convex problem
    /// having no other optimum.
    fn bound(&self, weights: &[Complex<f64>], top: f64) -> f64 {
        let left = residuals(self.alpha, self.readings, weights);
        let mut y: Vec<Complex<f64>> =
            left.iter().map(|r| r / ((top - r.norm()) * (top + r.norm()))).collect();
        let sum: f64 = y.iter().map(|y| y.norm()).sum();
        if sum == 0.0 {
            return 0.0;
        }
        // Planes within their limit must not pull at all; rounding is taken out of the multipliers.
        let within =
            |plane: &usize| self.limit.is_none_or(|limit| weights[*plane].norm() < 0.999_999 * limit);
        let free: Vec<usize> = (0..weights.len()).filter(within).collect();
        // Each multiplier moves in proportion to its size: those of readings that do not matter stay small.
        let squares: Vec<f64> = y.iter().map(Complex::norm_sqr).collect();
        let over: Vec<Complex<f64>> =
            y.iter().zip(&squares).map(|(y, square)| if *square > 0.0 { y / *square } else { *y }).collect();
        let cleared = least_squares(&self.alpha.select_columns(&free), &over, &squares);
        if let (false, Ok(cleared)) = (free.is_empty(), cleared) {
            y = cleared.residuals.iter().zip(&squares).map(|(r, square)| r * *square).collect();
        }
        let sum: f64 = y.iter().map(|y| y.norm()).sum();
        for y in &mut y {
            *y /= sum;
        }
        let limit = self.limit.unwrap_or_else(|| 2.0 * weights.iter().map(|w| w.norm()).fold(0.0, f64::max));
        let value: f64 = y.iter().zip(self.readings).map(|(y, v)| (y.conj() * v).re).sum();
        let pull = |plane: usize| -> f64 {
            let pull: Complex<f64> =
                y.iter().enumerate().map(|(row, y)| y.conj() * self.alpha[(row, plane)]).sum();
            pull.norm()
        };
        value - limit * (0..weights.len()).map(pull).sum::<f64>()
    }
}

/// Adds the first part of `−ln q`, whose gradient is `−∇q/q`.
fn add_barrier(gradient: &mut [f64], hessian: &mut DMatrix<f64>, slope: &[f64], room: f64) {
    for (p, g) in gradient.iter_mut().enumerate() {
        *g -= slope[p] / room;
        for q in 0..slope.len() {
            hessian[(p, q)] += slope[p] / room * (slope[q] / room);
        }
    }
}

/// Solves with a small positive definite matrix, its diagonal first scaled to 1.
fn cholesky_solve(mut a: DMatrix<f64>, mut b: Vec<f64>) -> Option<Vec<f64>> {
    let n = b.len();
    let scale: Vec<f64> = (0..n).map(|p| 1.0 / a[(p, p)].sqrt()).collect();
    for p in 0..n {
        b[p] *= scale[p];
        for q in 0..n {
            a[(p, q)] *= scale[p] * scale[q];
        }
    }
    for p in 0..n {
        for q in 0..=p {
            let sum = a[(p, q)] - (0..q).map(|k| a[(p, k)] * a[(q, k)]).sum::<f64>();
            if p > q {
                a[(p, q)] = sum / a[(q, q)];
            } else if sum > 0.0 {
                a[(p, p)] = sum.sqrt();
            } else {
                return None;
            }
        }
    }
    for p in 0..n {
        let sum: f64 = (0..p).map(|k| a[(p, k)] * b[k]).sum();
        b[p] = (b[p] - sum) / a[(p, p)];
    }
    for p in (0..n).rev() {
        let sum: f64 = (p + 1..n).map(|k| a[(k, p)] * b[k]).sum();
        b[p] = (b[p] - sum) / a[(p, p)];
    }
    Some(b.into_iter().zip(scale).map(|(b, scale)| b * scale).collect())
}
