//! Mass, damping and stiffness of one degree of freedom from a measured receptance `H = |X/F₀|`.
//!
//! Everything follows from one identity. With the peak `H_p` at `ω_p`, at every frequency
//! `1/H² = 1/H_p² + m²(ω² − ω_p²)²`: a parabola over `ω²`. It is `1/H² = (k − m ω²)² + (c ω)²` (Rao, *Mechanical
//! Vibrations*, 5th ed., §3.4) with the square completed, and holds exactly wherever there is a peak.
//!
//! Receptances in m/N, frequencies in rad/s, mass in kg, damping in N·s/m, stiffness in N/m.
//!
//! ```
//! use dalembert_mechanics::{
//!     identification::{FitError, fit_receptance},
//!     sdof::receptance,
//! };
//!
//! // The receptance of 2 kg, 8 N·s/m and 800 N/m at four frequencies gives all three back.
//! let points = [5.0, 15.0, 20.0, 30.0].map(|frequency| (frequency, receptance(800.0, 2.0, 8.0, frequency)));
//! let fit = fit_receptance(&points)?;
//! assert!((fit.mass - 2.0).abs() < 1e-10 && (fit.stiffness - 800.0).abs() < 1e-8);
//! assert!((fit.damping - 8.0).abs() < 1e-8);
//! // Two points do not determine three unknowns.
//! assert!(matches!(fit_receptance(&points[..2]), Err(FitError::Undetermined(_))));
//! # Ok::<(), FitError>(())
//! ```

mod few_points;
pub mod modal;

pub use few_points::{
    damping_ratio_from_force_ratio, damping_ratio_from_free_and_forced, damping_ratio_from_resonance_and_far,
    damping_ratio_from_speed, damping_ratio_from_unbalance_ratio, natural_frequency_from_two_speeds,
};

use nalgebra::{DMatrix, DVector};

use crate::Real;
use dalembert_numerics::linalg::{self, LinalgError};

/// Mass from the peak and one other point of the response, exact:
/// `m = √(1/H² − 1/H_p²)/|ω_p² − ω²|`, kg. The static value is the point at `ω = 0`.
#[inline]
pub fn mass_from_peak_and_point<S: Real>(
    peak_receptance: S,
    peak_frequency: S,
    receptance: S,
    frequency: S,
) -> S {
    (S::from(1.0) / receptance.powi(2) - S::from(1.0) / peak_receptance.powi(2)).sqrt()
        / (peak_frequency.powi(2) - frequency.powi(2)).abs()
}

/// Mass from the peak and the two half-power frequencies, exact: `m = 2/(H_p (ω₂² − ω₁²))`, kg.
#[inline]
pub fn mass_from_half_power<S: Real>(peak_receptance: S, lower: S, upper: S) -> S {
    S::from(2.0) / (peak_receptance * (upper.powi(2) - lower.powi(2)))
}

/// Frequency of the peak between its half-power frequencies, exact: `ω_p = √((ω₁² + ω₂²)/2)`, rad/s.
#[inline]
pub fn peak_between_half_power<S: Real>(lower: S, upper: S) -> S {
    ((lower.powi(2) + upper.powi(2)) / 2.0).sqrt()
}

/// Stiffness from mass and peak, exact: `k = √(1/H_p² + m²ω_p⁴)`, N/m.
#[inline]
pub fn stiffness_from_mass_and_peak<S: Real>(mass: S, peak_receptance: S, peak_frequency: S) -> S {
    (S::from(1.0) / peak_receptance.powi(2) + mass.powi(2) * peak_frequency.powi(4)).sqrt()
}

/// Damping from mass, stiffness and peak, exact: `c = √(2m/(k + m ω_p²))/H_p`, N·s/m. It is
/// `c² = 2m(k − m ω_p²)` without the cancellation.
#[inline]
pub fn damping_from_mass_and_peak<S: Real>(
    mass: S,
    stiffness: S,
    peak_receptance: S,
    peak_frequency: S,
) -> S {
    (mass * 2.0 / (stiffness + mass * peak_frequency.powi(2))).sqrt() / peak_receptance
}

/// One degree of freedom that a measured response was fitted with.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fit {
    /// Mass, kg.
    pub mass: f64,
    /// Damping, N·s/m.
    pub damping: f64,
    /// Stiffness, N/m.
    pub stiffness: f64,
    /// Root mean square of the relative differences between fitted and measured `1/H²`.
    pub misfit: f64,
    /// The normal equations of the fit, each over its largest term: zero but for rounding.
    pub normal_equations: [f64; 3],
}

/// Reason for which a measured response has no such fit.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum FitError {
    /// A frequency is negative, a receptance is not positive, or one is not finite.
    #[error("the point at {frequency} rad/s with {receptance} m/N is none of a receptance")]
    Point {
        /// Frequency of the point.
        frequency: f64,
        /// Receptance at the point.
        receptance: f64,
    },
    /// The least squares give a stiffness or a mass whose square is not positive.
    #[error("the points are not those of a mass on a spring")]
    NotAnOscillator,
    /// The least squares give a damping whose square is negative.
    #[error("the points rise higher than any damping lets them")]
    NegativeDamping,
    /// Fewer than three different frequencies, or numbers beyond all range.
    #[error("the points do not fix the three unknowns: {0}")]
    Undetermined(#[from] LinalgError),
}

/// Least squares over all points `(ω, H)`: `1/H² = k² + (c² − 2km)ω² + m²ω⁴` is linear in its three coefficients.
///
/// Each equation is weighted with `H²`, so that equal relative errors of the receptance weigh the same.
///
/// # Errors
/// [`FitError`] says what is wrong with the points.
pub fn fit_receptance(points: &[(f64, f64)]) -> Result<Fit, FitError> {
    if let Some(&(frequency, receptance)) =
        points.iter().find(|(w, h)| !(w.is_finite() && *w >= 0.0 && h.is_finite() && *h > 0.0))
    {
        return Err(FitError::Point { frequency, receptance });
    }
    // In units of the largest frequency and receptance, so that nothing overflows.
    let (frequency, receptance) =
        points.iter().fold((0.0f64, 0.0f64), |(w, h), point| (w.max(point.0), h.max(point.1)));
    let row = |&(w, h): &(f64, f64)| {
        let (s, weight) = ((w / frequency).powi(2), (h / receptance).powi(2));
        [weight, weight * s, weight * s * s]
    };
    let rows: Vec<[f64; 3]> = points.iter().map(row).collect();
    let a = DMatrix::from_fn(rows.len(), 3, |i, j| rows[i][j]);
    let solved = linalg::least_squares(&a, &DVector::from_element(rows.len(), 1.0))?;
    let [constant, linear, square] = [solved.x[0], solved.x[1], solved.x[2]];
    if !(constant > 0.0 && square > 0.0) {
        return Err(FitError::NotAnOscillator);
    }
    let (k, m) = (constant.sqrt(), square.sqrt());
    let damping_squared = linear + 2.0 * k * m;
    if damping_squared < -1e-12 * k * m {
        return Err(FitError::NegativeDamping);
    }
    let differences = &a * &solved.x - DVector::from_element(rows.len(), 1.0);
    let normal_equations = [0, 1, 2].map(|j| {
        let terms = rows.iter().zip(differences.iter()).map(|(row, difference)| row[j] * difference);
        let size = rows.iter().fold(0.0f64, |size, row| size.max(row[j]));
        terms.sum::<f64>() / (size * rows.len() as f64)
    });
    Ok(Fit {
        mass: m / (receptance * frequency.powi(2)),
        damping: damping_squared.max(0.0).sqrt() / (receptance * frequency),
        stiffness: k / receptance,
        misfit: (differences.norm_squared() / rows.len() as f64).sqrt(),
        normal_equations,
    })
}

/// A peak of a measured response.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MeasuredPeak {
    /// Frequency of the peak, rad/s.
    pub frequency: f64,
    /// Receptance at the peak, m/N.
    pub receptance: f64,
    /// Frequencies below and above it where the receptance is `1/√2` of the peak, rad/s; `None` on a side that
    /// was not measured far enough.
    pub half_power: [Option<f64>; 2],
}

/// The highest peak of points `(ω, H)` with ascending frequencies: the vertex of the parabola of `1/H²` over `ω²`
/// through the highest point and its neighbours. The half-power frequencies lie on straight lines of `1/H²` over
/// `ω²` between neighbouring points.
///
/// `None` when the highest point is the first or the last.
pub fn measured_peak(points: &[(f64, f64)]) -> Option<MeasuredPeak> {
    let highest = (0..points.len()).max_by(|&i, &j| points[i].1.total_cmp(&points[j].1))?;
    if highest == 0 || highest + 1 == points.len() {
        return None;
    }
    let scale = points[highest];
    // s = (ω/ω_h)² and y = (H_h/H)².
    let reduced =
        |i: usize| -> (f64, f64) { ((points[i].0 / scale.0).powi(2), (scale.1 / points[i].1).powi(2)) };
    let [(s0, y0), (s1, y1), (s2, y2)] = [highest - 1, highest, highest + 1].map(reduced);
    let (left, right) = ((y0 - y1) / (s0 - s1), (y2 - y1) / (s2 - s1));
    let curvature = (right - left) / (s2 - s0);
    let slope = left - curvature * (s0 - s1);
    let (s, y) = if curvature > 0.0 {
        (s1 - slope / (2.0 * curvature), y1 - slope.powi(2) / (4.0 * curvature))
    } else {
        (s1, y1)
    };
    // A vertex at or below zero is no response of an oscillator: the sample itself stands in.
    let (s, y) = if y > 0.0 { (s, y) } else { (s1, y1) };
    let crossing = |(i, j): (usize, usize)| {
        let ((si, yi), (sj, yj)) = (reduced(i), reduced(j));
        (yi <= 2.0 * y && yj > 2.0 * y)
            .then(|| (si + (2.0 * y - yi) / (yj - yi) * (sj - si)).sqrt() * scale.0)
    };
    let below = (1..=highest).rev().map(|i| (i, i - 1)).find_map(crossing);
    let above = (highest..points.len() - 1).map(|i| (i, i + 1)).find_map(crossing);
    Some(MeasuredPeak {
        frequency: s.sqrt() * scale.0,
        receptance: scale.1 / y.sqrt(),
        half_power: [below, above],
    })
}
