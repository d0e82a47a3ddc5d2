//! Bending vibration of a uniform blade that turns with its hub, by Rayleigh and Ritz.
//!
//! In units of the blade: lengths over its length `L`, forces over `EI/L²`, masses over its mass `m̄ L`; then the
//! tension is `η² (r(1 − ξ) + (1 − ξ²)/2) + η² μ (r + 1)` with `η² = m̄ Ω² L⁴/(EI)`, the radius `r` of the hub and a
//! mass `μ` at the tip. `λ = m̄ ω² L⁴/(EI)` is that of motion out of the plane of rotation; in it, `λ − η²`.
//!
//! A. D. Wright, C. E. Smith, R. W. Thresher and J. L. C. Wang, *J. Appl. Mech.* 49 (1982), pp. 197–202.

use nalgebra::DMatrix;

use super::tapered::{Ritz, RitzShape, basis, generalised};
use dalembert_numerics::{gauss_legendre, linalg::LinalgError};

/// A blade, clamped to its hub.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rotating {
    /// `η`: the speed over `√(EI/(m̄L⁴))`.
    pub speed: f64,
    /// Radius of the hub over the length.
    pub hub: f64,
    /// Mass at the tip, over that of the blade.
    pub tip: f64,
}

/// `ξ²` times a polynomial: what the clamp asks.
const POWERS: [i32; 2] = [2, 0];

impl Rotating {
    /// The tension at `ξ`.
    pub fn tension(&self, xi: f64) -> f64 {
        self.speed.powi(2) * (self.hub * (1.0 - xi) + 0.5 * (1.0 - xi * xi) + self.tip * (self.hub + 1.0))
    }

    /// The first `count` frequencies and shapes, out of the plane of rotation, with so many terms.
    ///
    /// # Errors
    /// Those of the eigenproblem.
    pub fn ritz(&self, terms: usize, count: usize) -> Result<Ritz, LinalgError> {
        let mut stiffness = DMatrix::zeros(terms, terms);
        let mut mass = DMatrix::zeros(terms, terms);
        let mut add = |xi: f64, bending: f64, tension: f64, inertia: f64| {
            let basis = basis(POWERS, terms, xi);
            for i in 0..terms {
                for j in 0..=i {
                    stiffness[(i, j)] +=
                        bending * basis[i][2] * basis[j][2] + tension * basis[i][1] * basis[j][1];
                    mass[(i, j)] += inertia * basis[i][0] * basis[j][0];
                }
            }
        };
        for (xi, weight) in gauss_legendre::legendre(terms + 4) {
            add(xi, weight, weight * self.tension(xi), weight);
        }
        add(1.0, 0.0, 0.0, self.tip);
        stiffness.fill_upper_triangle_with_lower_triangle();
        mass.fill_upper_triangle_with_lower_triangle();
        // The largest 1/λ instead of the smallest λ: rounding is then small beside the low ones.
        let (values, vectors) = generalised(&mass, &stiffness)?;
        let chosen = 0..count.min(terms);
        let lambdas = chosen.clone().map(|n| 1.0 / values[terms - 1 - n]).collect();
        let shape = |n: usize| {
            let coefficients = vectors.column(terms - 1 - n).iter().copied().collect();
            RitzShape { powers: POWERS, coefficients }.scaled()
        };
        Ok(Ritz { lambdas, shapes: chosen.map(shape).collect() })
    }

    /// `λ` from the balance of moments in place of energies: that with which the bending moment of the curvature and
    /// the moments of tension and inertia forces beyond each section differ least.
    pub fn moment_balance(&self, shape: &RitzShape) -> f64 {
        let terms = shape.coefficients.len();
        let inner = gauss_legendre::legendre(terms / 2 + 6);
        let end = shape.deflection(1.0);
        let (mut above, mut below) = (0.0, 0.0);
        for (xi, weight) in gauss_legendre::legendre(2 * terms) {
            let w = shape.deflection(xi);
            let rest = 1.0 - xi;
            let mut inertia = self.tip * rest * end;
            let mut pull = self.tip * (self.hub + 1.0) * (end - w);
            for (part, weight) in &inner {
                let s = xi + rest * part;
                let beyond = shape.deflection(s);
                inertia += rest * weight * (s - xi) * beyond;
                pull += rest * weight * (self.hub + s) * (beyond - w);
            }
            let moment = shape.curvature(xi) + self.speed.powi(2) * pull;
            above += weight * moment * inertia;
            below += weight * inertia * inertia;
        }
        above / below
    }

    /// `(λ(η) − λ(0))/η²` as the shape at rest gives it: the tension of unit speed over the kinetic energy.
    pub fn southwell(&self, at_rest: &RitzShape) -> f64 {
        let unit = Rotating { speed: 1.0, ..*self };
        let (mut tension, mut inertia) = (0.0, self.tip * at_rest.deflection(1.0).powi(2));
        for (xi, weight) in gauss_legendre::legendre(at_rest.coefficients.len() + 4) {
            tension += weight * unit.tension(xi) * at_rest.slope(xi).powi(2);
            inertia += weight * at_rest.deflection(xi).powi(2);
        }
        tension / inertia
    }
}

impl RitzShape {
    /// Slope at `ξ`.
    pub fn slope(&self, xi: f64) -> f64 {
        self.derivative(xi, 1)
    }

    /// Curvature at `ξ`.
    pub fn curvature(&self, xi: f64) -> f64 {
        self.derivative(xi, 2)
    }

    fn derivative(&self, xi: f64, order: usize) -> f64 {
        let basis = basis(self.powers, self.coefficients.len(), xi);
        self.coefficients.iter().zip(&basis).map(|(c, values)| c * values[order]).sum()
    }
}
