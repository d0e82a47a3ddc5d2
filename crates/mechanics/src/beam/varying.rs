//! Bending vibration of a beam whose width and depth are given at points along it, by Rayleigh and Ritz with polynomials
//! between the points (the p-version of finite elements).
//!
//! In units of the left end: lengths over the length `L`, `A(ξ) = b h` and `I(ξ) = b h³` with `b` and `h` one at the left
//! end; then `λ = ρ A₀ ω² L⁴/(E I₀) = β⁴`. A round section is `b = h`. Euler–Bernoulli.
//!
//! Deflection and slope are continuous at the points; with each term more between them the `λ` fall towards the exact ones
//! (Rao, *Mechanical Vibrations*, 5th ed., §8.8).

use nalgebra::DMatrix;

use dalembert_numerics::{gauss_legendre, linalg::LinalgError, roots};

use super::tapered::{
    EndSupport, MomentStation, basis, generalised, least_complementary_energy, rigid_motions,
};

/// Width and depth at a point of the beam.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SectionPoint {
    /// Place, 0 at the left end and 1 at the right one.
    pub place: f64,
    /// Width over that of the left end.
    pub width: f64,
    /// Depth over that of the left end.
    pub depth: f64,
}

/// Course of width and depth from point to point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Interpolation {
    /// Straight lines.
    Linear,
    /// Exponential functions: the logarithms are straight lines.
    Exponential,
}

/// A beam whose section varies.
#[derive(Clone, Debug, PartialEq)]
pub struct Varying {
    /// Points, ascending from 0 to 1.
    pub points: Vec<SectionPoint>,
    /// Course between the points.
    pub between: Interpolation,
    /// Supports of the two ends.
    pub supports: [EndSupport; 2],
}

/// A shape: in each part of the beam four cubics of its ends and polynomials that vanish there.
#[derive(Clone, Debug, PartialEq)]
pub struct VaryingShape {
    /// Ends of the parts, from 0 to 1.
    ends: Vec<f64>,
    /// Coefficients of each part.
    parts: Vec<Vec<f64>>,
}

/// `λ` and shapes with a number of terms.
#[derive(Clone, Debug, PartialEq)]
pub struct VaryingRitz {
    /// The lowest `λ` above zero, ascending.
    pub lambdas: Vec<f64>,
    /// Their shapes, largest deflection one.
    pub shapes: Vec<VaryingShape>,
}

impl Varying {
    /// Width and depth in a part, at a share of its length.
    fn dimensions(&self, part: usize, t: f64) -> (f64, f64) {
        let (from, to) = (self.points[part], self.points[part + 1]);
        let along = |a: f64, b: f64| match self.between {
            Interpolation::Linear => a + (b - a) * t,
            Interpolation::Exponential => a * (b / a).powf(t),
        };
        (along(from.width, to.width), along(from.depth, to.depth))
    }

    /// Area and second moment in a part, over those of the left end.
    fn section(&self, part: usize, t: f64) -> (f64, f64) {
        let (width, depth) = self.dimensions(part, t);
        (width * depth, width * depth.powi(3))
    }

    fn parts(&self) -> usize {
        self.points.len() - 1
    }

    fn length(&self, part: usize) -> f64 {
        self.points[part + 1].place - self.points[part].place
    }

    /// Motions of the beam as a whole that nothing holds.
    pub fn rigid_motions(&self) -> usize {
        rigid_motions(self.supports)
    }

    /// The first `count` frequencies and shapes with so many polynomials inside of each part.
    ///
    /// # Errors
    /// Those of the eigenproblem.
    pub fn ritz(&self, inside: usize, count: usize) -> Result<VaryingRitz, LinalgError> {
        // Deflection and slope of each point, then what is inside of each part.
        let points = self.points.len();
        let held = |unknown: usize| {
            let support = match unknown / 2 {
                0 => self.supports[0],
                point if point + 1 == points => self.supports[1],
                _ => EndSupport::Free,
            };
            match support {
                EndSupport::Free => false,
                EndSupport::Pinned => unknown.is_multiple_of(2),
                EndSupport::Clamped => true,
            }
        };
        let mut size = 0;
        let number: Vec<Option<usize>> = (0..2 * points + self.parts() * inside)
            .map(|unknown| {
                let free = unknown >= 2 * points || !held(unknown);
                free.then(|| {
                    size += 1;
                    size - 1
                })
            })
            .collect();
        let place = |part: usize, n: usize| {
            if n < 4 { number[2 * part + n] } else { number[2 * points + part * inside + n - 4] }
        };
        let mut stiffness = DMatrix::zeros(size, size);
        let mut mass = DMatrix::zeros(size, size);
        for part in 0..self.parts() {
            let length = self.length(part);
            for (t, weight) in gauss_legendre::legendre(inside + 10) {
                let shapes = shapes(inside, length, t);
                let (area, second_moment) = self.section(part, t);
                let (bending, inertia) = (weight * length * second_moment, weight * length * area);
                for (i, a) in shapes.iter().enumerate() {
                    for (j, b) in shapes.iter().enumerate() {
                        if let (Some(row), Some(column)) = (place(part, i), place(part, j)) {
                            stiffness[(row, column)] += bending * a[1] * b[1];
                            mass[(row, column)] += inertia * a[0] * b[0];
                        }
                    }
                }
            }
        }
        // The largest 1/(λ + σ) instead of the smallest λ, as for a linear taper.
        let shift = if self.rigid_motions() == 0 { 0.0 } else { 1.0 };
        let (values, vectors) = generalised(&mass, &(&stiffness + &mass * shift))?;
        let chosen = self.rigid_motions()..(self.rigid_motions() + count).min(size);
        let shapes = chosen.clone().map(|n| {
            let vector = vectors.column(size - 1 - n);
            let value = |part: usize, n: usize| place(part, n).map_or(0.0, |at| vector[at]);
            let parts = (0..self.parts()).map(|part| (0..4 + inside).map(|n| value(part, n)).collect());
            let ends = self.points.iter().map(|point| point.place).collect();
            VaryingShape { ends, parts: parts.collect() }.scaled()
        });
        let lambdas = chosen.clone().map(|n| 1.0 / values[size - 1 - n] - shift);
        Ok(VaryingRitz { lambdas: lambdas.collect(), shapes: shapes.collect() })
    }

    /// Rayleigh's quotient with the bending moments that hold the inertia forces of a shape in balance, in place of those
    /// of its curvature (R. Grammel): a second method to its `λ`.
    ///
    /// # Errors
    /// Those of the least squares for what the supports leave open.
    pub fn moment_quotient(&self, shape: &VaryingShape) -> Result<f64, LinalgError> {
        let order = shape.parts[0].len() + 10;
        let rule = gauss_legendre::legendre(order);
        // Force and moment about ξ = 0 of the inertia forces of a stretch of a part.
        let stretch = |part: usize, from: f64| {
            let (length, start) = (self.length(part), self.points[part].place);
            rule.iter().fold([0.0; 2], |[force, moment], (t, weight)| {
                let t = from + (1.0 - from) * t;
                let own = weight * (1.0 - from) * length * self.section(part, t).0 * shape.in_part(part, t);
                [force + own, moment + own * (start + length * t)]
            })
        };
        // Those of all that lies to the right of each part.
        let mut beyond = vec![[0.0; 2]; self.parts() + 1];
        for part in (0..self.parts()).rev() {
            let own = stretch(part, 0.0);
            beyond[part] = [beyond[part + 1][0] + own[0], beyond[part + 1][1] + own[1]];
        }
        let mut stations = Vec::new();
        let mut kinetic = 0.0;
        for part in 0..self.parts() {
            let (length, start) = (self.length(part), self.points[part].place);
            for (t, weight) in &rule {
                let (area, second_moment) = self.section(part, *t);
                let xi = start + length * t;
                let rest = stretch(part, *t);
                let [force, moment] = [rest[0] + beyond[part + 1][0], rest[1] + beyond[part + 1][1]];
                kinetic += weight * length * area * shape.in_part(part, *t).powi(2);
                let share = (weight * length / second_moment).sqrt();
                stations.push(MomentStation { xi, moment: moment - xi * force, share });
            }
        }
        let energy = least_complementary_energy(self.supports, [-beyond[0][0], beyond[0][1]], &stations)?;
        Ok(kinetic / energy)
    }
}

impl VaryingShape {
    /// Deflection at `ξ`, 0 to 1.
    pub fn deflection(&self, xi: f64) -> f64 {
        let part = self.ends.partition_point(|end| *end <= xi).clamp(1, self.parts.len()) - 1;
        let (from, to) = (self.ends[part], self.ends[part + 1]);
        self.in_part(part, (xi - from) / (to - from))
    }

    fn in_part(&self, part: usize, t: f64) -> f64 {
        let coefficients = &self.parts[part];
        let length = self.ends[part + 1] - self.ends[part];
        let shapes = shapes(coefficients.len() - 4, length, t);
        shapes.iter().zip(coefficients).map(|(shape, c)| c * shape[0]).sum()
    }

    /// Points between the ends that stay at rest, ascending.
    pub fn nodes(&self) -> Vec<f64> {
        let at = |n: u16| f64::from(n) / 400.0;
        let samples: Vec<(f64, f64)> =
            (1..400).map(|n| (at(n), self.deflection(at(n)))).filter(|(_, w)| w.abs() > 1e-9).collect();
        samples.windows(2).filter_map(|pair| roots::crossing(pair, |xi| self.deflection(xi))).collect()
    }

    fn scaled(mut self) -> Self {
        let crest = (0..=400u16)
            .map(|n| self.deflection(f64::from(n) / 400.0))
            .fold(0.0f64, |a, b| if b.abs() > a.abs() { b } else { a });
        self.parts.iter_mut().flatten().for_each(|c| *c /= crest);
        self
    }
}

/// Value and second derivative (by `ξ`) of the shapes of a part: deflection and slope of its ends, then polynomials that
/// vanish there with their slopes.
fn shapes(inside: usize, length: f64, t: f64) -> Vec<[f64; 2]> {
    let bend = length.powi(-2);
    let ends = [
        [1.0 - t * t * (3.0 - 2.0 * t), (12.0 * t - 6.0) * bend],
        [length * t * (1.0 - t).powi(2), (6.0 * t - 4.0) / length],
        [t * t * (3.0 - 2.0 * t), (6.0 - 12.0 * t) * bend],
        [length * t * t * (t - 1.0), (6.0 * t - 2.0) / length],
    ];
    let inner = basis([2, 2], inside, t).into_iter().map(|[value, _, second]| [value, second * bend]);
    ends.into_iter().chain(inner).collect()
}
