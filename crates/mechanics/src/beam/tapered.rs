//! Bending vibration of a beam whose width and depth change linearly along it, by Rayleigh and Ritz.
//!
//! In units of the left end: lengths over the length `L`, `A(ξ) = b h` and `I(ξ) = b h³` with `b` and `h` one at the
//! left end; then `λ = ρ A₀ ω² L⁴/(E I₀) = β⁴`. A round section is `b = h`. Euler–Bernoulli.
//!
//! The shapes are polynomials that satisfy what the supports ask of the deflection; with each term more the `λ` fall
//! towards the exact ones, never below (Rao, *Mechanical Vibrations*, 5th ed., §8.8).

use nalgebra::{DMatrix, DVector};

use dalembert_numerics::{
    gauss_legendre,
    linalg::{self, LinalgError},
    roots,
};

/// A tapered beam.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tapered {
    /// Width at the right end over that at the left, zero or more.
    pub width: f64,
    /// Depth at the right end over that at the left, zero or more.
    pub depth: f64,
    /// Supports of the two ends; an end without depth or width is free.
    pub supports: [EndSupport; 2],
}

/// Support condition of an end.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EndSupport {
    /// Nothing.
    Free,
    /// The deflection is held.
    Pinned,
    /// Deflection and rotation are held.
    Clamped,
}

/// A shape: `ξ^a (1 − ξ)^b Σ c_j P_j(2ξ − 1)`.
#[derive(Clone, Debug, PartialEq)]
pub struct RitzShape {
    pub(super) powers: [i32; 2],
    pub(super) coefficients: Vec<f64>,
}

/// `λ` and shapes with a number of terms.
#[derive(Clone, Debug, PartialEq)]
pub struct Ritz {
    /// The lowest `λ` above zero, ascending.
    pub lambdas: Vec<f64>,
    /// Their shapes, largest deflection one.
    pub shapes: Vec<RitzShape>,
}

impl EndSupport {
    fn power(self) -> i32 {
        match self {
            EndSupport::Free => 0,
            EndSupport::Pinned => 1,
            EndSupport::Clamped => 2,
        }
    }
}

impl Tapered {
    fn width_at(&self, xi: f64) -> f64 {
        1.0 + (self.width - 1.0) * xi
    }

    fn depth_at(&self, xi: f64) -> f64 {
        1.0 + (self.depth - 1.0) * xi
    }

    /// Area over that of the left end.
    pub fn area(&self, xi: f64) -> f64 {
        self.width_at(xi) * self.depth_at(xi)
    }

    /// Second moment over that of the left end.
    pub fn second_moment(&self, xi: f64) -> f64 {
        self.width_at(xi) * self.depth_at(xi).powi(3)
    }

    /// Motions of the beam as a whole that nothing holds.
    pub fn rigid_motions(&self) -> usize {
        rigid_motions(self.supports)
    }

    /// The first `count` frequencies and shapes with so many terms; `terms` is at least `count` and the motions as a
    /// whole together.
    ///
    /// # Errors
    /// Those of the eigenproblem.
    pub fn ritz(&self, terms: usize, count: usize) -> Result<Ritz, LinalgError> {
        let powers = self.supports.map(EndSupport::power);
        let mut stiffness = DMatrix::zeros(terms, terms);
        let mut mass = DMatrix::zeros(terms, terms);
        // Exact for products of second derivatives, second moment included.
        for (xi, weight) in gauss_legendre::legendre(terms + 6) {
            let basis = basis(powers, terms, xi);
            let (bending, inertia) = (weight * self.second_moment(xi), weight * self.area(xi));
            for i in 0..terms {
                for j in 0..=i {
                    stiffness[(i, j)] += bending * basis[i][2] * basis[j][2];
                    mass[(i, j)] += inertia * basis[i][0] * basis[j][0];
                }
            }
        }
        stiffness.fill_upper_triangle_with_lower_triangle();
        mass.fill_upper_triangle_with_lower_triangle();
        // The largest 1/(λ + σ) instead of the smallest λ: rounding is then small beside the low ones. A beam that can
        // move as a whole needs the σ.
        let shift = if self.rigid_motions() == 0 { 0.0 } else { 1.0 };
        let (values, vectors) = generalised(&mass, &(&stiffness + &mass * shift))?;
        let chosen = self.rigid_motions()..(self.rigid_motions() + count).min(terms);
        let shapes = chosen.clone().map(|n| {
            let coefficients: Vec<f64> = vectors.column(terms - 1 - n).iter().copied().collect();
            RitzShape { powers, coefficients }.scaled()
        });
        let lambdas = chosen.clone().map(|n| 1.0 / values[terms - 1 - n] - shift);
        Ok(Ritz { lambdas: lambdas.collect(), shapes: shapes.collect() })
    }

    /// Rayleigh's quotient with the bending moments that hold the inertia forces of a shape in balance, in place of
    /// those of its curvature (R. Grammel): it needs no derivative of the shape and is a second method to its `λ`.
    ///
    /// # Errors
    /// Those of the least squares for what the supports leave open.
    pub fn moment_quotient(&self, shape: &RitzShape) -> Result<f64, LinalgError> {
        let points = gauss_legendre::legendre(2 * shape.coefficients.len() + 10);
        let inner = gauss_legendre::legendre(shape.coefficients.len() / 2 + 5);
        let inertia: Vec<f64> =
            points.iter().map(|(xi, weight)| weight * self.area(*xi) * shape.deflection(*xi)).collect();
        // The moment that the part to the right of ξ leaves, nothing else holding it.
        let hanging = |xi: f64| {
            let rest = 1.0 - xi;
            let part = |&(t, weight): &(f64, f64)| {
                let s = xi + rest * t;
                rest * weight * (s - xi) * self.area(s) * shape.deflection(s)
            };
            inner.iter().map(part).sum::<f64>()
        };
        let moments: Vec<f64> = points.iter().map(|(xi, _)| hanging(*xi)).collect();
        let whole = [-inertia.iter().sum::<f64>(), hanging(0.0)];
        let stations = moments.iter().zip(&points).map(|(moment, &(xi, weight))| {
            let share = (weight / self.second_moment(xi)).sqrt();
            MomentStation { xi, moment: *moment, share }
        });
        let energy = least_complementary_energy(self.supports, whole, &stations.collect::<Vec<_>>())?;
        let kinetic: f64 =
            inertia.iter().zip(&points).map(|(force, (xi, _))| force * shape.deflection(*xi)).sum();
        Ok(kinetic / energy)
    }
}

impl RitzShape {
    /// Deflection at `ξ`, 0 to 1.
    pub fn deflection(&self, xi: f64) -> f64 {
        let x = 2.0 * xi - 1.0;
        let (mut before, mut here, mut sum) = (0.0, 1.0, 0.0);
        for (j, c) in self.coefficients.iter().enumerate() {
            let odd = 2.0 * j as f64 + 1.0;
            sum += c * odd.sqrt() * here;
            (before, here) = (here, (odd * x * here - j as f64 * before) / (j as f64 + 1.0));
        }
        xi.powi(self.powers[0]) * (1.0 - xi).powi(self.powers[1]) * sum
    }

    /// Points between the ends that stay at rest, ascending.
    pub fn nodes(&self) -> Vec<f64> {
        let parts = 20 * self.coefficients.len();
        let at = |n: usize| n as f64 / parts as f64;
        let samples: Vec<(f64, f64)> =
            (1..parts).map(|n| (at(n), self.deflection(at(n)))).filter(|(_, w)| w.abs() > 1e-9).collect();
        samples.windows(2).filter_map(|pair| roots::crossing(pair, |xi| self.deflection(xi))).collect()
    }

    pub(super) fn scaled(mut self) -> Self {
        let crest = (0..=400u16)
            .map(|n| self.deflection(f64::from(n) / 400.0))
            .fold(0.0f64, |a, b| if b.abs() > a.abs() { b } else { a });
        self.coefficients.iter_mut().for_each(|c| *c /= crest);
        self
    }
}

/// Motions of a beam as a whole that the supports of its ends leave.
pub(super) fn rigid_motions(supports: [EndSupport; 2]) -> usize {
    let held: i32 = supports.into_iter().map(EndSupport::power).sum();
    2usize.saturating_sub(held as usize)
}

/// A station of the integral over the complementary energy of a beam.
pub(super) struct MomentStation {
    /// Place from 0 to 1.
    pub(super) xi: f64,
    /// Moment there of the loads to its right, nothing else holding them.
    pub(super) moment: f64,
    /// Square root of its share in the integral over the second moment of area.
    pub(super) share: f64,
}

/// The least `∫ M²/I dξ` of the bending moments that hold the loads in balance; `whole` are the force of all loads on the
/// beam, reversed, and their moment about the left end.
///
/// # Errors
/// Those of the least squares for what the supports leave open.
pub(super) fn least_complementary_energy(
    supports: [EndSupport; 2],
    [force, whole]: [f64; 2],
    stations: &[MomentStation],
) -> Result<f64, LinalgError> {
    // Reactions at the right end add c₀ + c₁(1 − ξ); statics at the left end may fix them.
    let (fixed, free): ([f64; 2], Vec<[f64; 2]>) = match supports {
        [_, EndSupport::Free] => ([0.0, 0.0], vec![]),
        [EndSupport::Free, _] => ([-whole - force, force], vec![]),
        [EndSupport::Pinned, EndSupport::Pinned] => ([0.0, -whole], vec![]),
        [EndSupport::Pinned, EndSupport::Clamped] => ([-whole, 0.0], vec![[1.0, -1.0]]),
        [EndSupport::Clamped, EndSupport::Pinned] => ([0.0, 0.0], vec![[0.0, 1.0]]),
        [EndSupport::Clamped, EndSupport::Clamped] => ([0.0, 0.0], vec![[1.0, 0.0], [0.0, 1.0]]),
    };
    let along = |c: [f64; 2], xi: f64| c[0] + c[1] * (1.0 - xi);
    let right = stations.iter().map(|at| (at.moment + along(fixed, at.xi)) * at.share);
    let right = DVector::from_iterator(stations.len(), right);
    if free.is_empty() {
        return Ok(right.norm_squared());
    }
    let matrix = DMatrix::from_fn(stations.len(), free.len(), |n, k| {
        -along(free[k], stations[n].xi) * stations[n].share
    });
    let open = linalg::least_squares(&matrix, &right)?.x;
    Ok((&right - matrix * open).norm_squared())
}

/// Value, first and second derivative of `ξ^a (1 − ξ)^b P_j(2ξ − 1)`, `j` from 0.
pub(super) fn basis(powers: [i32; 2], terms: usize, xi: f64) -> Vec<[f64; 3]> {
    let power = |x: f64, n: i32| if n < 0 { 0.0 } else { x.powi(n) };
    let [a, b] = powers;
    let (fa, fb) = (f64::from(a), f64::from(b));
    let left = [power(xi, a), fa * power(xi, a - 1), fa * (fa - 1.0) * power(xi, a - 2)];
    let rest = 1.0 - xi;
    let right = [power(rest, b), -fb * power(rest, b - 1), fb * (fb - 1.0) * power(rest, b - 2)];
    let product = |f: [f64; 3], g: [f64; 3]| {
        [f[0] * g[0], f[1] * g[0] + f[0] * g[1], f[2] * g[0] + 2.0 * f[1] * g[1] + f[0] * g[2]]
    };
    let ends = product(left, right);
    // Legendre polynomials of x = 2ξ − 1 and their derivatives by ξ.
    let x = [2.0 * xi - 1.0, 2.0, 0.0];
    let (mut before, mut here) = ([0.0; 3], [1.0, 0.0, 0.0]);
    (0..terms)
        .map(|j| {
            // Of unit norm over the length, so that the matrices are of even size.
            let norm = (2.0 * j as f64 + 1.0).sqrt();
            let value = product(ends, here).map(|v| norm * v);
            let j = j as f64;
            let up = product(x, here);
            let next = [0, 1, 2].map(|k| ((2.0 * j + 1.0) * up[k] - j * before[k]) / (j + 1.0));
            (before, here) = (here, next);
            value
        })
        .collect()
}

/// Eigenvalues, ascending, and vectors of `A c = μ B c` with `B` positive definite, by its Cholesky factor.
pub(super) fn generalised(
    a: &DMatrix<f64>,
    b: &DMatrix<f64>,
) -> Result<(DVector<f64>, DMatrix<f64>), LinalgError> {
    let size = b.nrows();
    let mut lower = DMatrix::zeros(size, size);
    for i in 0..size {
        for j in 0..=i {
            let known: f64 = (0..j).map(|k| lower[(i, k)] * lower[(j, k)]).sum();
            let rest: f64 = b[(i, j)] - known;
            lower[(i, j)] = if i == j { rest.sqrt() } else { rest / lower[(j, j)] };
        }
    }
    if !lower.iter().all(|x: &f64| x.is_finite()) {
        return Err(LinalgError::NotFinite);
    }
    let solve = |right: &DMatrix<f64>| lower.solve_lower_triangular(right).ok_or(LinalgError::NotConverged);
    let half = solve(a)?;
    let whole = solve(&half.transpose())?;
    let symmetric = (&whole + whole.transpose()) / 2.0;
    let eigen = linalg::symmetric_eigen(&symmetric)?;
    let vectors =
        lower.transpose().solve_upper_triangular(&eigen.vectors).ok_or(LinalgError::NotConverged)?;
    Ok((eigen.values, vectors))
}
