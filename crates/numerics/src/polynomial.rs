//! Roots of polynomials with real coefficients.
//!
//! ```
//! use dalembert_numerics::polynomial::{PolynomialError, roots};
//!
//! // λ² + 2 λ + 5 = 0, a damped oscillation: λ = −1 ± 2i, the one with the negative imaginary part first.
//! let found = roots(&[1.0, 2.0, 5.0])?;
//! assert!((found[0].re + 1.0).abs() < 1e-14 && (found[0].im + 2.0).abs() < 1e-14);
//! assert_eq!(found[1], found[0].conj());
//! assert_eq!(roots(&[0.0, 0.0]), Err(PolynomialError::Zero));
//! # Ok::<(), PolynomialError>(())
//! ```

use std::f64::consts::TAU;

use nalgebra::Complex;

/// Reason for which the roots are not computed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum PolynomialError {
    /// A coefficient is NaN or infinite, or a root is beyond the range of numbers.
    #[error("a coefficient or a root is not finite")]
    NotFinite,
    /// All coefficients are zero: every number is a root.
    #[error("all coefficients are zero, so every number is a root; give one that is not")]
    Zero,
    /// The iteration reached its limit.
    #[error("the iteration for the roots did not converge")]
    NotConverged,
}

/// All complex roots of `a₀ xⁿ + a₁ xⁿ⁻¹ + … + aₙ`, coefficients given from the highest power down, ascending by
/// real part and then by imaginary part. Leading zeros are skipped; a constant has no roots.
///
/// A root of multiplicity m is exact to about `ε^(1/m)`, as its coefficients allow; complex roots come in exact
/// conjugate pairs. Ehrlich–Aberth iteration from the Newton polygon (D. A. Bini, *Numerical Algorithms* 13, 1996).
///
/// # Errors
/// `NotFinite`, `Zero`, `NotConverged`.
pub fn roots(coefficients: &[f64]) -> Result<Vec<Complex<f64>>, PolynomialError> {
    if !coefficients.iter().all(|a| a.is_finite()) {
        return Err(PolynomialError::NotFinite);
    }
    let first = coefficients.iter().position(|&a| a != 0.0).ok_or(PolynomialError::Zero)?;
    let last = coefficients.iter().rposition(|&a| a != 0.0).ok_or(PolynomialError::Zero)?;
    // Ascending powers from here on, the roots at zero set aside, the largest coefficient near one.
    let largest = coefficients.iter().fold(0.0, |largest: f64, a| largest.max(a.abs()));
    let ascending: Vec<f64> = coefficients[first..=last].iter().rev().map(|a| a / largest).collect();
    let mut roots = conjugate_pairs(&ascending, aberth(&ascending)?);
    roots.extend(vec![Complex::ZERO; coefficients.len() - 1 - last]);
    if !roots.iter().all(|z| z.re.is_finite() && z.im.is_finite()) {
        return Err(PolynomialError::NotFinite);
    }
    roots.sort_by(|p, q| p.re.total_cmp(&q.re).then(p.im.total_cmp(&q.im)));
    Ok(roots)
}

/// A root and how far the true one may be from it.
type Disc = (Complex<f64>, f64);

fn aberth(a: &[f64]) -> Result<Vec<Disc>, PolynomialError> {
    let mut z = starting_points(a);
    let mut radius = vec![None; z.len()];
    for _ in 0..500 {
        for i in 0..z.len() {
            if radius[i].is_some() {
                continue;
            }
            let Evaluated { ratio, rounding } = evaluate(a, z[i]);
            if !(ratio.re.is_finite() && ratio.im.is_finite()) {
                return Err(PolynomialError::NotFinite);
            }
            let repulsion: Complex<f64> =
                (0..z.len()).filter(|&j| j != i && z[j] != z[i]).map(|j| (z[i] - z[j]).inv()).sum();
            let step = ratio / (Complex::from(1.0) - ratio * repulsion);
            if step.re.is_finite() && step.im.is_finite() {
                z[i] -= step;
            }
            if step.norm() <= 2.0 * f64::EPSILON * z[i].norm() || ratio.norm() <= rounding {
                radius[i] = Some(a.len() as f64 * rounding.max(ratio.norm()));
            }
        }
        if let Some(radii) = radius.iter().copied().collect::<Option<Vec<f64>>>() {
            return Ok(z.into_iter().zip(radii).collect());
        }
    }
    Err(PolynomialError::NotConverged)
}

/// `p/p′` at a point and the part of it that may be rounding.
struct Evaluated {
    ratio: Complex<f64>,
    rounding: f64,
}

/// Horner's scheme; outside the unit circle on the reversed polynomial, so that no power overflows.
fn evaluate(a: &[f64], z: Complex<f64>) -> Evaluated {
    let n = (a.len() - 1) as f64;
    let outside = z.norm() > 1.0;
    let w = if outside { z.inv() } else { z };
    let size = w.norm();
    let (mut p, mut derivative, mut bound) = (Complex::ZERO, Complex::ZERO, 0.0);
    let mut step = |coefficient: f64| {
        derivative = derivative * w + p;
        p = p * w + coefficient;
        bound = bound * size + coefficient.abs();
    };
    if outside {
        a.iter().copied().for_each(&mut step);
    } else {
        a.iter().rev().copied().for_each(&mut step);
    }
    // p(z) = zⁿ q(1/z), so p/p′ = z q/(n q − w q′).
    let slope = if outside { (p * n - derivative * w) * w } else { derivative };
    if p == Complex::ZERO {
        return Evaluated { ratio: Complex::ZERO, rounding: 0.0 };
    }
    // Where the slope vanishes but the value does not, any finite step leaves the spot.
    let slope = if slope == Complex::ZERO { Complex::from(bound) } else { slope };
    Evaluated { ratio: p / slope, rounding: 4.0 * (n + 1.0) * f64::EPSILON * bound / slope.norm() }
}

/// Points on circles whose radii are the slopes of the upper hull of `(i, ln |aᵢ|)`: as many points on each as
/// roots have about that modulus.
fn starting_points(a: &[f64]) -> Vec<Complex<f64>> {
    let height = |i: usize| a[i].abs().ln();
    let mut hull: Vec<usize> = Vec::new();
    for i in (0..a.len()).filter(|&i| a[i] != 0.0) {
        while let [.., p, q] = hull[..] {
            let turns_left =
                (height(q) - height(p)) * ((i - p) as f64) <= (height(i) - height(p)) * ((q - p) as f64);
            if !turns_left {
                break;
            }
            hull.pop();
        }
        hull.push(i);
    }
    hull.windows(2)
        .flat_map(|side| {
            let (low, count) = (side[0], side[1] - side[0]);
            let radius = ((height(low) - height(side[1])) / count as f64).exp();
            // An irrational turn of each circle keeps the points off the real axis and off symmetry.
            (0..count).map(move |k| {
                let angle = TAU * (k as f64 / count as f64 + 0.1123 + 0.618 * low as f64);
                Complex::from_polar(radius, angle)
            })
        })
        .collect()
}

/// Makes real what is real within its error, and pairs the rest exactly.
fn conjugate_pairs(a: &[f64], mut discs: Vec<Disc>) -> Vec<Complex<f64>> {
    let mut roots = Vec::with_capacity(a.len());
    while let Some((z, radius)) = discs.pop() {
        if z.im.abs() <= radius {
            roots.push(Complex::from(z.re));
            continue;
        }
        let partner = (0..discs.len()).min_by(|&i, &j| {
            let distance = |k: usize| (discs[k].0 - z.conj()).norm();
            distance(i).total_cmp(&distance(j))
        });
        match partner {
            Some(k) if (discs[k].0.im < 0.0) != (z.im < 0.0) => {
                let pair = (z + discs.swap_remove(k).0.conj()) / 2.0;
                roots.extend([pair, pair.conj()]);
            }
            // Without a partner on the other side it can only be a real root.
            _ => roots.push(Complex::from(z.re)),
        }
    }
    roots
}
