//! Complex least squares of one mode with residuals.

use nalgebra::{Complex, DMatrix, DVector};

use super::{
    DampingModel, MeasuredResponse, ModalError, ResponsePoint, beyond_rounding, check, circle_fit,
    minimise::minimise,
};
use dalembert_numerics::linalg;

/// Representation of the other modes (residual terms).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Residuals {
    /// Nothing.
    None,
    /// A constant receptance `R`, for the modes above.
    Stiffness,
    /// `R − S/ω²`, for the modes above and below.
    StiffnessAndMass,
}

/// A mode by complex least squares.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ModalFit {
    /// Natural frequency, rad/s.
    pub natural_frequency: f64,
    /// Damping ratio `ζ` with viscous, loss factor `η` with hysteretic damping.
    pub damping: f64,
    /// Modal constant `A`, 1/kg; negative where force and motion are in antiphase.
    pub modal_constant: f64,
    /// Stiffness residual `R`, m/N; zero where there is none.
    pub stiffness_residual: f64,
    /// Mass residual `S`, 1/kg; zero where there is none.
    pub mass_residual: f64,
    /// Root mean square of the differences between fitted and measured response, over the largest measured one.
    pub misfit: f64,
    /// The slopes of the sum of squares: zero but for rounding.
    pub slopes: [f64; 5],
}

/// The mode whose response is nearest to the measured one, by least squares of the complex differences in the plane
/// of what was measured.
///
/// # Errors
/// All of [`ModalError`].
pub fn modal_fit(
    points: &[ResponsePoint],
    response: MeasuredResponse,
    model: DampingModel,
    residuals: Residuals,
) -> Result<ModalFit, ModalError> {
    check(points, if residuals == Residuals::StiffnessAndMass { 4 } else { 3 })?;
    let start = circle_fit(points, response, model)?;
    let reference = start.natural_frequency;
    let order = response.order();
    let largest = points.iter().map(|point| point.1.norm()).fold(0.0, f64::max);
    if !largest.is_normal() {
        return Err(ModalError::NotAMode);
    }
    // Everything in units of the natural frequency of the circle and of the largest response.
    let unit = largest / reference.powi(order);
    let measured: Vec<(f64, f64, Complex<f64>)> = points
        .iter()
        .map(|point| {
            let x = point.0 / reference;
            (x, x.powi(order), response.receptance(*point) / unit)
        })
        .collect();
    let with = match residuals {
        Residuals::None => [0.0, 0.0],
        Residuals::Stiffness => [1.0, 0.0],
        Residuals::StiffnessAndMass => [1.0, 1.0],
    };
    let denominator = |x: f64, p: f64, g: f64| match model {
        DampingModel::Viscous => (Complex::new(p - x * x, g * x), Complex::new(0.0, x)),
        DampingModel::Hysteretic => (Complex::new(p - x * x, g), Complex::new(0.0, 1.0)),
    };
    let rows = |&[p, g, a, r, s]: &[f64; 5]| -> Vec<(f64, [f64; 5])> {
        let mut rows = Vec::with_capacity(2 * measured.len());
        for (x, weight, value) in &measured {
            let (d, d_g) = denominator(*x, p, g);
            let one = Complex::new(1.0, 0.0) / d;
            let of_s = Complex::new(-with[1] / (x * x), 0.0);
            let off = (a * one + r * with[0] + of_s * s - value) * *weight;
            let slopes = [-a * one * one, -a * one * one * d_g, one, Complex::new(with[0], 0.0), of_s]
                .map(|z| z * *weight);
            rows.push((off.re, slopes.map(|z| z.re)));
            rows.push((off.im, slopes.map(|z| z.im)));
        }
        // An unknown that is left out is held at zero.
        for (n, kept) in with.iter().enumerate() {
            if *kept == 0.0 {
                let mut row = [0.0; 5];
                row[3 + n] = 1.0;
                rows.push(([r, s][n], row));
            }
        }
        rows
    };
    // With the frequency and the damping of the circle, the constants follow from linear least squares.
    let g = match model {
        DampingModel::Viscous => 2.0 * start.damping,
        DampingModel::Hysteretic => start.damping,
    };
    let linear = rows(&[1.0, g, 0.0, 0.0, 0.0]);
    let a = DMatrix::from_fn(linear.len(), 3, |i, j| linear[i].1[2 + j]);
    let b = DVector::from_fn(linear.len(), |i, _| -linear[i].0);
    let constants = linalg::least_squares(&a, &b)?.x;
    let minimum = minimise([1.0, g, constants[0], constants[1], constants[2]], 1.0, rows)?;
    let [p, g, a, r, s] = minimum.parameters;
    if !(p > 0.0 && g > 0.0 && a != 0.0) {
        return Err(ModalError::NotAMode);
    }
    let fit = ModalFit {
        natural_frequency: p.sqrt() * reference,
        damping: match model {
            DampingModel::Viscous => g / (2.0 * p.sqrt()),
            DampingModel::Hysteretic => g / p,
        },
        modal_constant: a * unit * reference.powi(2),
        stiffness_residual: r * unit * with[0],
        mass_residual: s * unit * reference.powi(2) * with[1],
        misfit: beyond_rounding((minimum.squares / points.len() as f64).sqrt()),
        slopes: minimum.slopes,
    };
    let numbers =
        [fit.natural_frequency, fit.damping, fit.modal_constant, fit.stiffness_residual, fit.mass_residual];
    if numbers.iter().all(|x| x.is_finite()) { Ok(fit) } else { Err(ModalError::NotAMode) }
}

impl ModalFit {
    /// The fitted receptance at a frequency, m/N.
    #[must_use]
    pub fn receptance(&self, model: DampingModel, frequency: f64) -> Complex<f64> {
        let natural = self.natural_frequency;
        let loss = match model {
            DampingModel::Viscous => 2.0 * self.damping * natural * frequency,
            DampingModel::Hysteretic => self.damping * natural.powi(2),
        };
        self.modal_constant / Complex::new(natural.powi(2) - frequency.powi(2), loss)
            + self.stiffness_residual
            - self.mass_residual / frequency.powi(2)
    }
}
