//! One mode from a measured complex frequency response: circle fit and complex least squares.
//!
//! The receptance of one mode among others is `α(ω) = A/(ω_n² − ω² + i d) + R − S/ω²` with the modal constant `A` in
//! 1/kg (one over the mass, where force and motion are those of one mass), `d = 2ζω_nω` for viscous and `d = ηω_n²`
//! for hysteretic damping, the stiffness residual `R` in m/N of the modes above and the mass residual `S` in 1/kg of
//! those below. Mobility is `iωα`, accelerance `−ω²α`. Ewins, *Modal Testing*, 2nd ed., §4.3 and §4.4.

mod circle;
mod fit;
mod minimise;

pub use circle::{Circle, CircleFit, circle_fit, fit_circle};
pub use fit::{ModalFit, Residuals, modal_fit};

pub use nalgebra::Complex;

use dalembert_numerics::linalg::LinalgError;

/// Measured response per unit force: receptance, mobility or accelerance.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum MeasuredResponse {
    /// Displacement over force, m/N.
    Receptance,
    /// Velocity over force, m/(N·s).
    Mobility,
    /// Acceleration over force, 1/kg.
    Accelerance,
}

/// Damping model of the mode.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum DampingModel {
    /// By a force in proportion to the velocity.
    Viscous,
    /// By a force in phase with the velocity and in proportion to the displacement.
    Hysteretic,
}

/// A point of a measured complex response: frequency in rad/s, above zero, and the response there.
pub type ResponsePoint = (f64, Complex<f64>);

/// Reason for which a measured complex response has no such fit.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum ModalError {
    /// A frequency is not above zero, or a number is not finite.
    #[error("the point at {frequency} rad/s is none of a frequency response")]
    Point {
        /// Frequency of the point.
        frequency: f64,
    },
    /// Fewer points than the unknowns need.
    #[error("{have} points do not fix the unknowns; {need} different frequencies are needed")]
    TooFew {
        /// Points there are.
        have: usize,
        /// Points that are needed.
        need: usize,
    },
    /// The points lie on a straight line, or are all zero.
    #[error("the points lie on no circle")]
    NoCircle,
    /// The least squares lead to a frequency or a damping that is not positive.
    #[error("the points are not those of a damped mode")]
    NotAMode,
    /// The points do not determine the unknowns.
    #[error("the points do not fix the unknowns: {0}")]
    Undetermined(#[from] LinalgError),
}

impl MeasuredResponse {
    /// The receptance of a measured point.
    #[must_use]
    pub fn receptance(self, (frequency, value): ResponsePoint) -> Complex<f64> {
        match self {
            MeasuredResponse::Receptance => value,
            MeasuredResponse::Mobility => value / Complex::new(0.0, frequency),
            MeasuredResponse::Accelerance => -value / frequency.powi(2),
        }
    }

    /// Number of time derivatives n: `|response| = ωⁿ |receptance|`.
    fn order(self) -> i32 {
        match self {
            MeasuredResponse::Receptance => 0,
            MeasuredResponse::Mobility => 1,
            MeasuredResponse::Accelerance => 2,
        }
    }
}

fn check(points: &[ResponsePoint], need: usize) -> Result<(), ModalError> {
    let sound = |(frequency, value): &ResponsePoint| {
        frequency.is_finite() && *frequency > 0.0 && value.re.is_finite() && value.im.is_finite()
    };
    if let Some((frequency, _)) = points.iter().find(|point| !sound(point)) {
        return Err(ModalError::Point { frequency: *frequency });
    }
    if points.len() < need { Err(ModalError::TooFew { have: points.len(), need }) } else { Ok(()) }
}

/// Zero for a relative misfit that is nothing but rounding.
fn beyond_rounding(misfit: f64) -> f64 {
    if misfit < 1e-12 { 0.0 } else { misfit }
}
