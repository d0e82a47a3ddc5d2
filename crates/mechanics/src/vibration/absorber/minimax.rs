//! The tuning and damping that make the highest peak of the main system least, also where it is damped itself.

use nalgebra::{DMatrix, DVector};

use super::{
    DampedAbsorber, least_peak_damping, least_peak_root, least_peak_tuning, viscous_damping,
    viscous_fixed_point,
};
use dalembert_numerics::linalg;

/// Reason for which no absorber minimises the peak.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum AbsorberError {
    /// The mass ratio or the damping ratio is not in its range.
    #[error(
        "the mass ratio {mass_ratio} is not between 1e-6 and 1e6, or the damping ratio {damping} not in [0, 1)"
    )]
    Range {
        /// Given mass ratio.
        mass_ratio: f64,
        /// Given damping ratio of the main system.
        damping: f64,
    },
    /// The main system is so damped that no two peaks are to be balanced.
    #[error(
        "a main system with damping ratio {damping} has no resonant peaks that this absorber could balance"
    )]
    NoPeaks {
        /// Given damping ratio of the main system.
        damping: f64,
    },
}

/// The least peak, and the absorber that has it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LeastPeak {
    /// Tuning and damping.
    pub absorber: DampedAbsorber,
    /// The least possible largest magnification.
    pub height: f64,
}

/// Tuning and damping of the least peak: two peaks of one height, where no change of both lowers both.
///
/// Newton's method on the four equations (two level points, equal heights, opposed gradients), led from the closed
/// solution of the undamped main system by raising its damping in small steps.
///
/// # Errors
/// [`AbsorberError`].
pub fn least_peak(mass_ratio: f64, main_damping: f64) -> Result<LeastPeak, AbsorberError> {
    check(mass_ratio, main_damping)?;
    let none = AbsorberError::NoPeaks { damping: main_damping };
    let root = least_peak_root(mass_ratio);
    let tuning = least_peak_tuning(root);
    let damping = tuning * least_peak_damping(mass_ratio, root);
    let start = DampedAbsorber { mass_ratio, main_damping: 0.0, tuning, damping };
    let peaks = start.peaks();
    let [lower, upper] = peaks[..] else { return Err(none) };
    let at =
        |x: &[f64], zeta: f64| DampedAbsorber { mass_ratio, main_damping: zeta, tuning: x[2], damping: x[3] };
    let residual = |x: &[f64], zeta: f64| {
        let absorber = at(x, zeta);
        let [p, q] = [absorber.slopes(x[0]), absorber.slopes(x[1])];
        vec![p.square, q.square, p.height - q.height, p.tuning * q.damping - q.tuning * p.damping]
    };
    let first = vec![lower.ratio.powi(2), upper.ratio.powi(2), tuning, damping];
    let found = follow(first, main_damping, mass_ratio, residual).ok_or(none)?;
    let absorber = at(&found, main_damping);
    let [p, q] = [absorber.slopes(found[0]), absorber.slopes(found[1])];
    // Opposed: what lowers one peak raises the other.
    if p.tuning * q.tuning + p.damping * q.damping > 0.0 {
        return Err(none);
    }
    settled(absorber, found[0], none)
}

/// Damping of the least peak of an untuned viscous absorber.
///
/// # Errors
/// [`AbsorberError`].
pub fn least_peak_viscous(mass_ratio: f64, main_damping: f64) -> Result<LeastPeak, AbsorberError> {
    check(mass_ratio, main_damping)?;
    let none = AbsorberError::NoPeaks { damping: main_damping };
    let at =
        |x: &[f64], zeta: f64| DampedAbsorber { mass_ratio, main_damping: zeta, tuning: 0.0, damping: x[1] };
    let residual = |x: &[f64], zeta: f64| {
        let p = at(x, zeta).slopes(x[0]);
        vec![p.square, p.damping]
    };
    let first = vec![viscous_fixed_point(mass_ratio).powi(2), viscous_damping(mass_ratio)];
    let found = follow(first, main_damping, mass_ratio, residual).ok_or(none)?;
    settled(at(&found, main_damping), found[0], none)
}

fn check(mass_ratio: f64, damping: f64) -> Result<(), AbsorberError> {
    if (1e-6..=1e6).contains(&mass_ratio) && (0.0..1.0).contains(&damping) {
        Ok(())
    } else {
        Err(AbsorberError::Range { mass_ratio, damping })
    }
}

/// Holds what was found to the largest of all peaks.
fn settled(absorber: DampedAbsorber, square: f64, none: AbsorberError) -> Result<LeastPeak, AbsorberError> {
    let height = absorber.magnification(square.sqrt());
    let largest = absorber.largest_peak().ok_or(none)?.height;
    let good = absorber.damping > 0.0 && absorber.tuning >= 0.0 && height >= 1.0;
    if good && (largest - height).abs() <= 1e-8 * height {
        Ok(LeastPeak { absorber, height })
    } else {
        Err(none)
    }
}

/// The logarithm of the squared magnification and its derivatives at a point `u = g²`.
struct Slopes {
    height: f64,
    square: f64,
    tuning: f64,
    damping: f64,
}

impl DampedAbsorber {
    fn slopes(&self, u: f64) -> Slopes {
        let Self { mass_ratio: mu, main_damping: zeta, tuning: f, damping: gamma } = *self;
        let f2 = f * f;
        let b = 1.0 + f2 * (1.0 + mu) + 4.0 * zeta * gamma;
        let above = (f2 - u).powi(2) + 4.0 * gamma * gamma * u;
        let real = u * u - b * u + f2;
        let c = zeta + gamma * (1.0 + mu);
        let q = zeta * f2 + gamma - c * u;
        let below = real * real + 4.0 * u * q * q;
        // Derivatives of numerator and denominator over u, f and γ.
        let above_by = [4.0 * gamma * gamma - 2.0 * (f2 - u), 4.0 * f * (f2 - u), 8.0 * gamma * u];
        let real_by = [2.0 * u - b, 2.0 * f * (1.0 - (1.0 + mu) * u), -4.0 * zeta * u];
        let q_by = [-c, 2.0 * zeta * f, 1.0 - (1.0 + mu) * u];
        let by = |n: usize| {
            let own = if n == 0 { 4.0 * q * q } else { 0.0 };
            above_by[n] / above - (2.0 * real * real_by[n] + 8.0 * u * q * q_by[n] + own) / below
        };
        Slopes { height: above.ln() - below.ln(), square: by(0), tuning: by(1), damping: by(2) }
    }
}

/// Follows the zero of `residual` from no damping of the main system to `until`.
fn follow(
    first: Vec<f64>,
    until: f64,
    mass_ratio: f64,
    residual: impl Fn(&[f64], f64) -> Vec<f64>,
) -> Option<Vec<f64>> {
    let width = mass_ratio.sqrt().min(1.0);
    let steps = (until / (0.1 * width)).ceil().clamp(1.0, 200.0) as u16;
    let mut x = first;
    for n in 1..=steps {
        let zeta = until * f64::from(n) / f64::from(steps);
        x = newton(x, width, |x| residual(x, zeta))?;
    }
    Some(x)
}

fn newton(mut x: Vec<f64>, width: f64, residual: impl Fn(&[f64]) -> Vec<f64>) -> Option<Vec<f64>> {
    let size = x.len();
    let mut last = f64::INFINITY;
    for _ in 0..30 {
        let here = residual(&x);
        let mut jacobian = DMatrix::zeros(size, size);
        for column in 0..size {
            let step = 1e-6 * width * x[column];
            let [mut more, mut less] = [x.clone(), x.clone()];
            more[column] += step;
            less[column] -= step;
            let slope = residual(&more).into_iter().zip(residual(&less)).map(|(p, q)| (p - q) / (2.0 * step));
            slope.enumerate().for_each(|(row, slope)| jacobian[(row, column)] = slope);
        }
        let change = linalg::solve(&jacobian, &DVector::from_vec(here)).ok()?.x;
        let moved = change.iter().zip(&x).map(|(change, x)| (change / x).abs()).fold(0.0, f64::max);
        if moved.is_nan() || moved > 0.5 {
            return None;
        }
        x.iter_mut().zip(change.iter()).for_each(|(x, change)| *x -= change);
        // Converged, or down at the rounding.
        if moved < 1e-14 || (moved < 1e-9 * width.max(1e-2) && moved >= 0.5 * last) {
            return Some(x);
        }
        last = moved;
    }
    (last < 1e-9).then_some(x)
}
