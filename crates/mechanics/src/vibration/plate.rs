//! Free vibration of thin plates and membranes: circles, and rectangles with two opposite edges simply supported.
//!
//! Kirchhoff's plate `D ∇⁴w = ρ h ω² w` and the membrane `T ∇²w = −μ ω² w`. A. W. Leissa, *Vibration of Plates*,
//! NASA SP-160 (1969), chapters 2 and 4.

use crate::beam::dynamic_stiffness::{
    BeamError,
    spans::{Span, SpanJoint, SpanShape, Spans},
};
use dalembert_numerics::roots;
use dalembert_numerics::{bessel, gauss_legendre};

/// Support condition of an edge.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Edge {
    /// Nothing.
    Free,
    /// The deflection is held.
    Simple,
    /// Deflection and slope are held.
    Clamped,
}

/// A round body with one edge.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Round {
    /// A membrane, held at its edge.
    Membrane,
    /// A plate.
    Plate {
        /// Support condition of the edge.
        edge: Edge,
        /// Poisson's ratio.
        poisson: f64,
    },
}

/// A vibration of a round body: `W(ρ) cos nθ` with `ρ` from 0 at the centre to 1 at the edge.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RoundMode {
    /// Plate or membrane that vibrates.
    pub body: Round,
    /// Nodal diameters `n`.
    pub diameters: usize,
    /// Number of the root with that many diameters, from 1.
    pub place: usize,
    /// `λ`: wave number times radius.
    pub root: f64,
    /// The share of `I_n(λρ)/I_n(λ)`; zero for a membrane.
    share: f64,
    /// The largest deflection of the sum with these shares.
    scale: f64,
}

impl Round {
    /// The first `count` vibrations, by ascending `λ`; those of a free plate as a whole are not among them.
    pub fn modes(self, count: usize) -> Vec<RoundMode> {
        let mut found: Vec<(f64, usize, usize)> = Vec::new();
        // λ grows with the diameters, but for the free plate, whose rigid motions are left out.
        for diameters in 0..200 {
            let roots = self.roots(diameters, count);
            let highest = found.get(count - 1).map_or(f64::INFINITY, |last| last.0);
            if diameters > 2 && roots.first().is_none_or(|root| *root > highest) {
                break;
            }
            found.extend((1..).zip(roots).map(|(place, root)| (root, diameters, place)));
            found.sort_by(|a, b| a.0.total_cmp(&b.0));
            found.truncate(count);
        }
        found.into_iter().map(|(root, diameters, place)| self.mode(diameters, place, root)).collect()
    }

    /// The frequency equation of so many diameters: what it leaves, bounded.
    pub fn residual(self, diameters: usize, root: f64) -> f64 {
        let Round::Plate { edge, poisson } = self else { return bessel::j(diameters, root) };
        let [j, i] = parts(diameters, root, poisson);
        match edge {
            Edge::Clamped => (j[0] * i[1] - i[0] * j[1]) / root,
            Edge::Simple => (j[0] * i[2] - i[0] * j[2]) / root.powi(2),
            Edge::Free => (j[2] * i[3] - i[2] * j[3]) / root.powi(5),
        }
    }

    fn roots(self, diameters: usize, count: usize) -> Vec<f64> {
        let n = diameters as f64;
        let from = match self {
            Round::Membrane => n + 0.5,
            // The turning of a free plate about a diameter is a root at zero.
            Round::Plate { edge: Edge::Free, .. } if diameters < 2 => 1.0,
            Round::Plate { .. } => 0.5 * n + 0.5,
        };
        bessel::zeros(|x| self.residual(diameters, x), from, count)
    }

    fn mode(self, diameters: usize, place: usize, root: f64) -> RoundMode {
        let share = match self {
            Round::Membrane => 0.0,
            Round::Plate { edge, poisson } => {
                let [j, i] = parts(diameters, root, poisson);
                match edge {
                    Edge::Clamped | Edge::Simple => -j[0],
                    Edge::Free => -j[2] / i[2] * i[0],
                }
            }
        };
        let mut mode = RoundMode { body: self, diameters, place, root, share, scale: 1.0 };
        let values = (0..=200u16).map(|n| mode.deflection(f64::from(n) / 200.0));
        mode.scale = values.fold(0.0f64, |a, b| if b.abs() > a.abs() { b } else { a });
        mode
    }
}

impl RoundMode {
    /// Deflection at `ρ`, largest one.
    pub fn deflection(&self, radius: f64) -> f64 {
        let n = self.diameters;
        let i = if self.share == 0.0 { 0.0 } else { self.share * self.ratio(radius, bessel::scaled_i) };
        (bessel::j(n, self.root * radius) + i) / self.scale
    }

    /// Radii of the nodal circles inside the edge.
    pub fn circles(&self) -> Vec<f64> {
        let parts = 40 * self.place;
        let at = |n: usize| n as f64 / parts as f64;
        let values: Vec<(f64, f64)> = (1..parts).map(|n| (at(n), self.deflection(at(n)))).collect();
        values.windows(2).filter_map(|pair| roots::crossing(pair, |r| self.deflection(r))).collect()
    }

    /// Strain energy over kinetic energy at unit frequency, integrated over the area: `λ⁴` of a plate, `λ²` of a
    /// membrane.
    pub fn rayleigh_quotient(&self) -> f64 {
        let n2 = (self.diameters as f64).powi(2);
        let (mut strain, mut kinetic) = (0.0, 0.0);
        for (r, weight) in gauss_legendre::points(3 + self.root as usize / 4) {
            let weight = weight * r;
            let [w, slope, curvature] = self.derivatives(r);
            kinetic += weight * w * w;
            strain += weight
                * match self.body {
                    Round::Membrane => slope * slope + n2 * w * w / (r * r),
                    Round::Plate { poisson, .. } => {
                        let across = slope / r - n2 * w / (r * r);
                        let twist = slope / r - w / (r * r);
                        (curvature + across).powi(2)
                            - 2.0 * (1.0 - poisson) * (curvature * across - n2 * twist * twist)
                    }
                };
        }
        strain / kinetic
    }

    /// `F(λρ)/I_n(λ)` for a scaled function of the second kind of growth.
    fn ratio(&self, radius: f64, function: impl Fn(usize, f64) -> f64) -> f64 {
        let decay = (self.root * (radius - 1.0)).exp();
        function(self.diameters, self.root * radius) / bessel::scaled_i(self.diameters, self.root) * decay
    }

    /// Deflection, slope and curvature along the radius.
    fn derivatives(&self, r: f64) -> [f64; 3] {
        let (n, root) = (self.diameters, self.root);
        let n2 = (n as f64).powi(2);
        let j = bessel::j(n, root * r);
        let j_slope = root * bessel::j_slope(n, root * r);
        let j_bend = -j_slope / r - (root * root - n2 / (r * r)) * j;
        let [i, i_slope] = if self.share == 0.0 {
            [0.0; 2]
        } else {
            let slope = self.ratio(r, bessel::scaled_i_slope);
            [self.ratio(r, bessel::scaled_i), root * slope].map(|x| self.share * x)
        };
        let i_bend = -i_slope / r + (root * root + n2 / (r * r)) * i;
        [j + i, j_slope + i_slope, j_bend + i_bend].map(|x| x / self.scale)
    }
}

/// Sines in both directions.
pub mod rectangular_membrane {
    use std::f64::consts::PI;

    use dalembert_numerics::gauss_legendre;

    /// Half waves along both sides of the lowest `count` vibrations; `aspect` is the first side over the second.
    pub fn patterns(aspect: f64, count: usize) -> Vec<[usize; 2]> {
        // Along the longer side come up to all of the half waves wanted.
        let square = |[m, n]: &[usize; 2]| (*m as f64).powi(2) + (*n as f64 * aspect).powi(2);
        let mut all: Vec<[usize; 2]> = (1..=count).flat_map(|m| (1..=count).map(move |n| [m, n])).collect();
        all.sort_by(|a, b| square(a).total_cmp(&square(b)));
        all.truncate(count);
        all
    }

    /// Energy of the slope of so many half waves over that of the deflection, integrated over a unit length.
    pub fn quotient(half_waves: usize) -> f64 {
        let wave = half_waves as f64 * PI;
        let slope = gauss_legendre::integral(half_waves, |x| (wave * (wave * x).cos()).powi(2));
        slope / gauss_legendre::integral(half_waves, |x| (wave * x).sin().powi(2))
    }
}

/// At the edge of unit radius, for `J_n(λρ)` and `I_n(λρ)`, the second over `e^λ`: deflection, slope, radial moment
/// and edge force (Leissa, §2.1).
fn parts(diameters: usize, root: f64, poisson: f64) -> [[f64; 4]; 2] {
    let n2 = (diameters as f64).powi(2);
    let of = |w: f64, slope: f64, laplacian: f64| {
        [
            w,
            slope,
            laplacian * w - (1.0 - poisson) * (slope - n2 * w),
            laplacian * slope - (1.0 - poisson) * n2 * (slope - w),
        ]
    };
    let square = root * root;
    [
        of(bessel::j(diameters, root), root * bessel::j_slope(diameters, root), -square),
        of(bessel::scaled_i(diameters, root), root * bessel::scaled_i_slope(diameters, root), square),
    ]
}

/// A rectangular plate, simply supported on the two edges across `a`; `sides` are the other two.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Levy {
    /// `a` over `b`, the distance between the other two edges.
    pub aspect: f64,
    /// Support conditions of the other two edges.
    pub sides: [Edge; 2],
    /// Poisson's ratio.
    pub poisson: f64,
}

/// A vibration of such a plate: `Y(η) sin mπξ`.
#[derive(Clone, Debug, PartialEq)]
pub struct LevyMode {
    /// Half waves along `a`.
    pub half_waves: usize,
    /// Number of the root with that many, from 1.
    pub place: usize,
    /// `ω a² √(ρh/D)`.
    pub number: f64,
    /// `Y` over `η` from 0 to 1.
    pub shape: SpanShape,
}

impl Levy {
    /// The first `count` vibrations, by ascending frequency.
    ///
    /// With `w = Y(y) sin(mπx/a)` the plate is a beam under the tension `2α²` on the foundation `α⁴`, `α = mπb/a`
    /// in units of `b`; a free edge couples its deflection with its rotation by `ν α²`.
    ///
    /// # Errors
    /// Those of [`Spans::roots`].
    pub fn modes(&self, count: usize) -> Result<Vec<LevyMode>, BeamError> {
        let mut found: Vec<(f64, usize, usize, f64)> = Vec::new();
        for half_waves in 1..200 {
            let beam = self.strip(half_waves);
            // With more half waves the first root is higher.
            let first = match beam.roots(1) {
                Err(BeamError::TooSlender(_)) if found.len() == count => break,
                other => other?[0],
            };
            let number = |beta: f64| (beta * self.aspect).powi(2);
            if found.get(count - 1).is_some_and(|last| number(first) > last.0) {
                break;
            }
            let roots = beam.roots(count)?;
            found.extend((1..).zip(roots).map(|(place, beta)| (number(beta), half_waves, place, beta)));
            found.sort_by(|a, b| a.0.total_cmp(&b.0));
            found.truncate(count);
        }
        let mode = |(number, half_waves, place, beta): (f64, usize, usize, f64)| {
            let shape = self.strip(half_waves).shape(beta)?;
            Ok(LevyMode { half_waves, place, number, shape })
        };
        found.into_iter().map(mode).collect()
    }

    fn strip(&self, half_waves: usize) -> Spans {
        let alpha = (half_waves as f64 * std::f64::consts::PI / self.aspect).powi(2);
        let joint = |edge: Edge, sign: f64| SpanJoint {
            held: edge != Edge::Free,
            clamped: edge == Edge::Clamped,
            coupling: sign * self.poisson * alpha,
            ..SpanJoint::default()
        };
        Spans {
            spans: vec![Span {
                length: 1.0,
                bending: 1.0,
                mass: 1.0,
                axial: 2.0 * alpha,
                foundation: alpha * alpha,
            }],
            joints: vec![joint(self.sides[0], 1.0), joint(self.sides[1], -1.0)],
        }
    }
}

impl LevyMode {
    /// Strain energy over kinetic energy, in units of the number: `ω² a⁴ ρh/D`.
    pub fn rayleigh_quotient(&self, aspect: f64) -> f64 {
        self.shape.rayleigh_quotient() * aspect.powi(4)
    }
}
