//! Natural frequencies, damping and whirl of a rotor at a speed.

use std::f64::consts::TAU;

use nalgebra::{Complex, DMatrix, DVector};

use super::{
    Assembled, BearingSupport, Coefficients, RotorError,
    basis::Basis,
    response::Orbit,
    stiffness::{Node, Powers, Stiffness},
};
use dalembert_numerics::linalg;

/// Relative error of the square of a natural frequency below which it counts as exact.
pub const EXACT: f64 = 1e-10;

/// Loss of modal energy allowed when shapes are condensed, as a multiple of that error: shapes of one mode carry most
/// of the loss of another.
const CONDENSED: f64 = 10.0;

/// A motion whose frequency is below this share of the size of its eigenvalue (ζ > 0.954) counts as overdamped: a real
/// eigenvalue. Internal damping gives such motions a slow turn with the spin, which is no vibration.
const SWING: f64 = 0.3;

/// A mode of free vibration `Re(shape · e^{λt})` with `Im λ > 0`.
#[derive(Debug, Clone, PartialEq)]
pub struct WhirlMode {
    /// The eigenvalue, s⁻¹.
    pub lambda: Complex<f64>,
    /// Deflection and slope of every node, in the plane of `x` and then of `y`.
    pub shape: Vec<[Complex<f64>; 4]>,
    /// The mode in the coordinates of the reduced model, of unit length.
    pub(super) coordinates: DVector<Complex<f64>>,
}

/// Direction of whirl of a mode.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum WhirlDirection {
    /// With the spin, at every node.
    Forward,
    /// Against the spin, at every node.
    Backward,
    /// With the spin at some nodes, against it at others.
    Mixed,
    /// Neither: every node moves along a straight line.
    Planar,
}

/// The modes of a rotor at a speed.
#[derive(Debug, Clone, PartialEq)]
pub struct Spectrum {
    /// Speed, rad/s.
    pub speed: f64,
    /// The lowest modes that oscillate, by damped frequency.
    pub modes: Vec<WhirlMode>,
    /// Real parts of the eigenvalues no larger than the largest of those that hardly oscillate, s⁻¹: overdamped
    /// motions, back or away.
    pub overdamped: Vec<f64>,
}

/// A rotor in the coordinates of a few shapes, as many as its lowest modes need.
pub struct ReducedRotor<'a> {
    pub(super) rotor: &'a Assembled,
    basis: Basis,
    pub(super) count: usize,
    cancelled: &'a dyn Fn() -> bool,
}

impl WhirlMode {
    /// Damped natural frequency `ω_d = Im λ`, rad/s.
    pub fn frequency(&self) -> f64 {
        self.lambda.im
    }

    /// Logarithmic decrement `δ = −2π Re λ/Im λ`.
    pub fn log_decrement(&self) -> f64 {
        -TAU * self.lambda.re / self.lambda.im
    }

    /// The orbit of a node.
    pub fn orbit(&self, node: usize) -> Orbit {
        Orbit::of(self.shape[node][0], self.shape[node][2])
    }

    /// Direction of whirl; nodes with negligible motion do not count.
    pub fn direction(&self) -> WhirlDirection {
        let orbits: Vec<Orbit> = (0..self.shape.len()).map(|node| self.orbit(node)).collect();
        let largest = orbits.iter().fold(0.0, |size: f64, orbit| size.max(orbit.major));
        let turning = |sign: f64| {
            orbits.iter().any(|orbit| orbit.major > 1e-4 * largest && sign * orbit.minor > 1e-6 * orbit.major)
        };
        match (turning(1.0), turning(-1.0)) {
            (true, false) => WhirlDirection::Forward,
            (false, true) => WhirlDirection::Backward,
            (true, true) => WhirlDirection::Mixed,
            (false, false) => WhirlDirection::Planar,
        }
    }

    /// Modal assurance criterion of two modes of the same reduced model: 1 for the same shape, 0 for an unrelated one.
    pub(super) fn assurance(&self, other: &WhirlMode) -> f64 {
        self.coordinates.dotc(&other.coordinates).norm_sqr()
    }
}

impl<'a> ReducedRotor<'a> {
    /// Takes shapes until the `count` lowest modes at each of the speeds are exact to ten digits.
    ///
    /// # Errors
    /// `Buckled` where the rotor is statically unstable; `Linalg`.
    pub fn new(rotor: &'a Assembled, count: usize, speeds: &[f64]) -> Result<Self, RotorError> {
        Self::to_within(rotor, count, speeds, EXACT, &|| false)
    }

    /// The same, exact to within a share of the squares of the natural frequencies. Whatever is found of this model is
    /// given up once `cancelled` reports it.
    ///
    /// # Errors
    /// Those of [`Self::new`]; `Stopped`.
    pub fn to_within(
        rotor: &'a Assembled,
        count: usize,
        speeds: &[f64],
        share: f64,
        cancelled: &'a dyn Fn() -> bool,
    ) -> Result<Self, RotorError> {
        let middle = speeds.iter().sum::<f64>() / speeds.len().max(1) as f64;
        let mut reduced = Self { rotor, basis: Basis::new(rotor, middle)?, count, cancelled };
        let mut found = Vec::new();
        let mut overdamps = false;
        for &speed in speeds {
            let mut spectrum = reduced.modes(speed)?;
            // A round leaves a small part of the error; more than a few mean that rounding is the limit.
            for _ in 0..10 {
                let mut answers = Vec::new();
                let mut worst = 0.0f64;
                for mode in &spectrum.modes {
                    let residual = Stiffness::new(rotor, mode.lambda, speed).times(&mode.shape);
                    let (error, shapes) = reduced.basis.error(rotor, mode.lambda, &mode.shape, &residual);
                    if error > share {
                        worst = worst.max(error);
                        answers.extend(shapes);
                    }
                }
                // Directions are rough while the error is large: only the main ones are worth a shape.
                let least = (0.05 * share).max(1e-3 * worst);
                if answers.is_empty() || !reduced.basis.improve(rotor, answers, least)? {
                    break;
                }
                spectrum = reduced.modes(speed)?;
            }
            overdamps |= !spectrum.overdamped.is_empty();
            found.extend(spectrum.modes.into_iter().map(|mode| mode.shape));
        }
        // Bearings that change with speed may ask for other shapes between these speeds, and overdamped motions,
        // back or away, have shapes that no mode holds.
        let steady = !reduced.basis.free && rotor.supports.iter().all(BearingSupport::is_constant);
        if steady && !overdamps && !found.is_empty() {
            reduced.basis.condense(rotor, &found, CONDENSED * share)?;
        }
        Ok(reduced)
    }

    /// The number of shapes in each plane.
    pub fn shapes(&self) -> usize {
        self.basis.len()
    }

    /// The lowest modes at a speed.
    ///
    /// # Errors
    /// `Linalg`, `Stopped`.
    pub fn modes(&self, speed: f64) -> Result<Spectrum, RotorError> {
        self.lowest(speed, self.count)
    }

    /// So many of the lowest modes at a speed; those beyond the number that the shapes were taken for are less exact.
    pub(super) fn lowest(&self, speed: f64, count: usize) -> Result<Spectrum, RotorError> {
        if (self.cancelled)() {
            return Err(RotorError::Stopped);
        }
        if let Some(modes) = self.undamped(speed, count)? {
            return Ok(Spectrum { speed, modes, overdamped: Vec::new() });
        }
        let (stiffness, damping) = self.matrices(speed);
        let frequencies = &self.basis.frequencies;
        let m = frequencies.len();
        let coupled = (0..m).any(|i| {
            (m..2 * m).any(|j| {
                [&stiffness, &damping]
                    .into_iter()
                    .any(|matrix| matrix[(i, j)] != 0.0 || matrix[(j, i)] != 0.0)
            })
        });
        let even = coupled && alike(&stiffness) && alike(&damping);
        // Where no direction is preferred, whirls with and against the spin may have equal frequencies and their vectors
        // would be arbitrary. Seen from a frame that turns at `turn`, the ones are slower and the others faster.
        let turn = if even { 0.0613 * frequencies[0] } else { 0.0 };
        // Planes without coupling may have equal eigenvalues, whose vectors would be arbitrary: each on its own.
        let sizes = if coupled { [(0, 2 * m), (m, 0)] } else { [(0, m), (m, m)] };
        let mut values = Vec::with_capacity(4 * m);
        let mut coordinates = Vec::with_capacity(4 * m);
        for (first, size) in sizes.into_iter().filter(|(_, size)| *size > 0) {
            // In the coordinates (ω q, q̇) an undamped rotor at rest has a skew-symmetric state matrix: well scaled.
            let mut state = DMatrix::zeros(2 * size, 2 * size);
            for i in 0..size {
                state[(i, size + i)] = frequencies[i % m];
                for j in 0..size {
                    state[(size + i, j)] = -stiffness[(first + i, first + j)] / frequencies[j % m];
                    state[(size + i, size + j)] = -damping[(first + i, first + j)];
                }
            }
            if even {
                for i in 0..m {
                    for (x, y) in [(i, m + i), (2 * m + i, 3 * m + i)] {
                        state[(x, y)] += turn;
                        state[(y, x)] -= turn;
                    }
                }
            }
            let eigen = linalg::complex_eigen(&state)?;
            for (mut value, vector) in eigen.values.into_iter().zip(eigen.vectors.column_iter()) {
                if even {
                    // `y = −ix` turns with the spin.
                    let spin: f64 = (0..m).map(|i| (vector[i].conj() * vector[m + i]).im).sum();
                    value.im += turn * -spin.signum();
                }
                values.push(value);
                coordinates.push(DVector::from_fn(2 * m, |i, _| {
                    if (first..first + size).contains(&i) {
                        vector[i - first] / frequencies[i % m]
                    } else {
                        Complex::new(0.0, 0.0)
                    }
                }));
            }
        }
        let least = if self.basis.free { 1e-3 * self.basis.shift.sqrt() } else { 0.0 };
        let swings = |value: &Complex<f64>| value.im > SWING * value.norm() && value.norm() > least;
        let mut order: Vec<usize> = (0..values.len()).filter(|&n| swings(&values[n])).collect();
        order.sort_by(|&a, &b| values[a].im.total_cmp(&values[b].im));
        order.truncate(count);
        let modes: Vec<WhirlMode> = order.iter().map(|&n| self.mode(values[n], &coordinates[n])).collect();
        let largest = modes.iter().fold(0.0, |size: f64, mode| size.max(mode.lambda.norm()));
        let is_overdamped = |value: &&Complex<f64>| {
            value.im >= 0.0
                && value.im <= SWING * value.norm()
                && value.norm() <= largest
                && value.norm() > least
        };
        let mut overdamped: Vec<f64> = values.iter().filter(is_overdamped).map(|value| value.re).collect();
        overdamped.sort_by(f64::total_cmp);
        Ok(Spectrum { speed, modes, overdamped })
    }

    /// The lowest modes at a speed where nothing is damped and no bearing couples the planes; `None` elsewhere, and for a
    /// rotor that is free or unstable at rest.
    ///
    /// With `y = −iη` free whirl `e^{iωt}` obeys `(ω² − ωΩG′ − K) q = 0` with real symmetric matrices, for `q = (x, η)` and
    /// `G′ = [[0, G], [G, 0]]`; where the bearings are alike in all directions, for `q = x = ±η` and `G′ = ±G`, so that
    /// negative ω whirl against the spin. With `v = ω q` it is `[[0, K], [K, ΩG′]] (q, v) = ω diag(K, 1) (q, v)`.
    fn undamped(&self, speed: f64, count: usize) -> Result<Option<Vec<WhirlMode>>, RotorError> {
        let mut bearings = self.rotor.bearings(speed);
        let decoupled = |here: &Coefficients| {
            here.damping == [[0.0; 2]; 2] && [here.stiffness[0][1], here.stiffness[1][0]] == [0.0; 2]
        };
        if self.basis.free || self.rotor.internal || !bearings.all(|(_, here)| decoupled(&here)) {
            return Ok(None);
        }
        let alike = self.rotor.bearings(speed).all(|(_, here)| here.stiffness[0][0] == here.stiffness[1][1]);
        let (stiffness, _) = self.matrices(speed);
        let m = self.basis.frequencies.len();
        let gyroscopic = |i: usize, j: usize| {
            let of = &self.basis.gyroscopic;
            0.5 * speed * (of[(i % m, j % m)] + of[(j % m, i % m)])
        };
        // First coordinate, and number of them, of each group that is coupled.
        let circular = alike && speed != 0.0;
        let groups: &[(usize, usize)] = if circular {
            &[(0, m)]
        } else if speed != 0.0 {
            &[(0, 2 * m)]
        } else {
            &[(0, m), (m, m)]
        };
        let mut found: Vec<(f64, DVector<Complex<f64>>)> = Vec::new();
        for &(first, size) in groups {
            let coupled = |i: usize, j: usize| circular || (i < m) != (j < m);
            let part = |i: usize, j: usize| stiffness[(first + i, first + j)];
            let left = DMatrix::from_fn(2 * size, 2 * size, |i, j| match (i < size, j < size) {
                (false, false) if coupled(i - size, j - size) => gyroscopic(i - size, j - size),
                (false, false) | (true, true) => 0.0,
                _ => part(i % size, j % size),
            });
            let right = DMatrix::from_fn(2 * size, 2 * size, |i, j| match (i < size, j < size) {
                (true, true) => part(i, j),
                (false, false) if i == j => 1.0,
                _ => 0.0,
            });
            let eigen = match linalg::generalised_eigen(&left, &right) {
                Err(linalg::LinalgError::NotPositiveDefinite { .. }) => return Ok(None),
                eigen => eigen?,
            };
            for (&omega, vector) in eigen.values.iter().zip(eigen.vectors.column_iter()) {
                // Where the planes are not one, each whirl is there twice, with ω and η of either sign.
                if omega <= 0.0 && !circular {
                    continue;
                }
                let turned = Complex::new(0.0, -omega.signum());
                let coordinates = DVector::from_fn(2 * m, |i, _| match i.checked_sub(first) {
                    Some(at) if circular => vector[at % m] * if at < m { Complex::ONE } else { turned },
                    Some(at) if at < size => {
                        vector[at] * if size > m && at >= m { turned } else { Complex::ONE }
                    }
                    _ => ZERO,
                });
                found.push((omega.abs(), coordinates));
            }
        }
        found.sort_by(|a, b| a.0.total_cmp(&b.0));
        let lowest = found.iter().take(count);
        Ok(Some(
            lowest.map(|(omega, coordinates)| self.mode(Complex::new(0.0, *omega), coordinates)).collect(),
        ))
    }

    /// Stiffness and damping in the coordinates of the shapes, both planes.
    pub(super) fn matrices(&self, speed: f64) -> (DMatrix<f64>, DMatrix<f64>) {
        let Basis { vectors, frequencies, shaft, gyroscopic, viscous, hysteretic, .. } = &self.basis;
        let m = frequencies.len();
        let mut stiffness = DMatrix::zeros(2 * m, 2 * m);
        let mut damping = DMatrix::zeros(2 * m, 2 * m);
        for i in 0..m {
            for j in 0..m {
                let both = 0.5 * (shaft[(i, j)] + shaft[(j, i)]);
                stiffness[(i, j)] = both;
                stiffness[(m + i, m + j)] = both;
            }
            for j in 0..m {
                let gyroscopic = speed * gyroscopic[(i, j)];
                damping[(i, m + j)] += gyroscopic;
                damping[(m + i, j)] -= gyroscopic;
                if self.rotor.internal {
                    let circulatory = speed * viscous[(i, j)] + hysteretic[(i, j)];
                    stiffness[(i, m + j)] += circulatory;
                    stiffness[(m + i, j)] -= circulatory;
                    damping[(i, j)] += viscous[(i, j)];
                    damping[(m + i, m + j)] += viscous[(i, j)];
                }
            }
        }
        for (node, here) in self.rotor.bearings(speed) {
            let row = vectors.row(2 * node);
            for p in 0..2 {
                for q in 0..2 {
                    let (k, c) = (here.stiffness[p][q], here.damping[p][q]);
                    for i in 0..m {
                        for j in 0..m {
                            let both = row[i] * row[j];
                            stiffness[(p * m + i, q * m + j)] += k * both;
                            damping[(p * m + i, q * m + j)] += c * both;
                        }
                    }
                }
            }
        }
        (stiffness, damping)
    }

    /// The shapes, orthonormal in the mass of one plane.
    pub(super) fn shapes_of_one_plane(&self) -> impl Iterator<Item = DVector<f64>> {
        self.basis.vectors.column_iter().map(nalgebra::Matrix::into_owned)
    }

    /// Natural frequencies of the shapes on the mean bearings, rad/s: units in which a stiffness is near one.
    pub(super) fn frequencies(&self) -> &[f64] {
        &self.basis.frequencies
    }

    /// Returns true if the supports leave a rigid-body motion.
    pub fn is_free(&self) -> bool {
        self.basis.free
    }

    /// Polar inertia between the planes, in the coordinates of the shapes.
    pub(super) fn gyroscopic(&self) -> &DMatrix<f64> {
        &self.basis.gyroscopic
    }

    /// The full mode of some coordinates.
    pub(super) fn mode(&self, lambda: Complex<f64>, coordinates: &DVector<Complex<f64>>) -> WhirlMode {
        let m = self.basis.frequencies.len();
        let size = coordinates.iter().map(Complex::norm_sqr).sum::<f64>().sqrt();
        let coordinates = coordinates.map(|x| x / size);
        let vectors = &self.basis.vectors;
        let freedom = |row: usize, plane: usize| -> Complex<f64> {
            (0..m).map(|i| coordinates[plane * m + i] * vectors[(row, i)]).sum()
        };
        let shape = (0..self.rotor.nodes())
            .map(|node| {
                [(2 * node, 0), (2 * node + 1, 0), (2 * node, 1), (2 * node + 1, 1)]
                    .map(|(row, plane)| freedom(row, plane))
            })
            .collect();
        WhirlMode { lambda, shape, coordinates }
    }
}

/// Returns true if a matrix of both planes is isotropic, `[[A, B], [−B, A]]`: invariant under a rotation of the planes
/// about the axis.
fn alike(matrix: &DMatrix<f64>) -> bool {
    let m = matrix.nrows() / 2;
    let least = 1e-14 * matrix.amax();
    let off = |i: usize, j: usize| {
        (matrix[(i, j)] - matrix[(m + i, m + j)]).abs().max((matrix[(i, m + j)] + matrix[(m + i, j)]).abs())
    };
    (0..m).all(|i| (0..m).all(|j| off(i, j) <= least))
}

/// A mode on all equations of a rotor.
#[derive(Debug, Clone, PartialEq)]
pub struct Polished {
    /// The mode, its shape of unit mass.
    pub mode: WhirlMode,
    /// Relative rounding error of the eigenvalue.
    pub rounding: f64,
}

/// Shifts of the inverse iteration, as shares of the eigenvalue. The first is far enough for rounding not to turn modes
/// of nearly equal frequency into each other; the others serve where elimination meets a poor pivot, the last for short
/// elements on soft bearings, whose solution is found only where the equations are less singular.
const OFFSETS: [Complex<f64>; 4] =
    [Complex::new(1e-4, 0.0), Complex::new(0.0, 1e-4), Complex::new(-7e-4, 7e-4), Complex::new(-5e-3, 5e-3)];

/// A step of the eigenvalue beyond this share of it leads to another mode.
const ANOTHER: f64 = 1e-2;

/// The mode nearest to one of a reduced model on all equations of the rotor at a speed: inverse iteration for the right
/// and the left vector, and the eigenvalue that makes their bilinear form of the equations zero (two-sided Rayleigh
/// quotient), which errs by the product of their errors.
///
/// # Errors
/// `NotConverged`.
pub fn polished(rotor: &Assembled, mode: &WhirlMode, speed: f64) -> Result<Polished, RotorError> {
    let near = OFFSETS.into_iter().find_map(|offset| {
        let lambda = mode.lambda * (offset + 1.0);
        let dynamic = Stiffness::new(rotor, lambda, speed);
        let right = inverse_iteration(dynamic, rotor, lambda, speed, (mode.lambda, &mode.shape), false)?;
        let conjugate: Vec<Node> = mode.shape.iter().map(|node| node.map(|x| x.conj())).collect();
        let left = inverse_iteration(dynamic, rotor, lambda, speed, (mode.lambda, &conjugate), true)?;
        let (value, rounding) = quotient(rotor, speed, mode.lambda, &left, &right)?;
        ((value - mode.lambda).norm() < ANOTHER * mode.lambda.norm()).then_some((value, rounding, right))
    });
    let (lambda, rounding, shape) = near.ok_or(linalg::LinalgError::NotConverged)?;
    let mass = Complex::new(1.0, 0.0);
    let weighted = Stiffness::of(rotor, Powers { mass, damping: ZERO, stiffness: ZERO }, speed).times(&shape);
    let sum: f64 =
        shape.iter().flatten().zip(weighted.iter().flatten()).map(|(a, b)| (a.conj() * b).re).sum();
    let shape = shape.into_iter().map(|node| node.map(|x| x / sum.sqrt())).collect();
    Ok(Polished { mode: WhirlMode { lambda, shape, coordinates: mode.coordinates.clone() }, rounding })
}

/// The eigenvalue of a mode from its shape and the powers in it alone, `λ² vᴴMv + λ vᴴ(C + ΩG)v + vᴴKv = 0`, near the
/// one it is said to have.
pub fn energy_eigenvalue(rotor: &Assembled, mode: &WhirlMode, speed: f64) -> Option<Complex<f64>> {
    let [mass, damping, stiffness] = [0, 1, 2].map(|at| {
        let one = |n: usize| Complex::new(f64::from(u8::from(n == at)), 0.0);
        let powers = Powers { mass: one(0), damping: one(1), stiffness: one(2) };
        let image = Stiffness::of(rotor, powers, speed).times(&mode.shape);
        let power = mode.shape.iter().flatten().zip(image.iter().flatten()).map(|(a, b)| a.conj() * b);
        power.sum::<Complex<f64>>()
    });
    let half = damping / (mass * 2.0);
    let root = (half * half - stiffness / mass).sqrt();
    let off = |value: &Complex<f64>| (value - mode.lambda).norm();
    let [one, other] = [root - half, -root - half];
    let value = if off(&one) < off(&other) { one } else { other };
    (value.re.is_finite() && value.im.is_finite()).then_some(value)
}

const ZERO: Complex<f64> = Complex::new(0.0, 0.0);

/// Two steps towards the eigenvector whose eigenvalue is nearest to `shift`, on displacements and velocities: with
/// `q̇ = v` they are `(λ²M + λC + K) q′ = −M v − (C + λM) q`, `v′ = q + λ q′`.
fn inverse_iteration(
    dynamic: Stiffness<'_>,
    rotor: &Assembled,
    shift: Complex<f64>,
    speed: f64,
    (lambda, start): (Complex<f64>, &[Node]),
    transposed: bool,
) -> Option<Vec<Node>> {
    let one = Complex::new(1.0, 0.0);
    let side = |of| if transposed { Stiffness::transposed(of) } else { of };
    let solver = side(dynamic).solver();
    let inertia = side(Stiffness::of(rotor, Powers { mass: one, damping: ZERO, stiffness: ZERO }, speed));
    let momentum = side(Stiffness::of(rotor, Powers { mass: shift, damping: one, stiffness: ZERO }, speed));
    let mut place = start.to_vec();
    let mut velocity: Vec<Node> = start.iter().map(|node| node.map(|x| x * lambda)).collect();
    for _ in 0..2 {
        let (moving, mut right) = (inertia.times(&velocity), momentum.times(&place));
        for (right, moving) in right.iter_mut().flatten().zip(moving.iter().flatten()) {
            *right = -(*right + moving);
        }
        let next = solver.solve(&right)?;
        for (velocity, (next, place)) in
            velocity.iter_mut().flatten().zip(next.iter().flatten().zip(place.iter().flatten()))
        {
            *velocity = place + shift * next;
        }
        place = next;
        let size = place.iter().flatten().map(|x| x.norm()).fold(0.0, f64::max);
        for x in place.iter_mut().chain(&mut velocity).flatten() {
            *x /= size;
        }
    }
    place.iter().flatten().all(|x| x.re.is_finite() && x.im.is_finite()).then_some(place)
}

/// The eigenvalue near `lambda` that makes `wᵀ D(λ) v` zero, and what rounding may have changed of it: a share of the
/// sizes that were added up.
fn quotient(
    rotor: &Assembled,
    speed: f64,
    mut lambda: Complex<f64>,
    left: &[Node],
    right: &[Node],
) -> Option<(Complex<f64>, f64)> {
    let one = Complex::new(1.0, 0.0);
    let form = |powers: Powers| {
        let image = Stiffness::of(rotor, powers, speed).times(right);
        let terms = left.iter().flatten().zip(image.iter().flatten()).map(|(a, b)| a * b);
        terms.fold((ZERO, 0.0), |(sum, size), term| (sum + term, size + term.norm()))
    };
    let (mass, mass_size) = form(Powers { mass: one, damping: ZERO, stiffness: ZERO });
    let (damping, damping_size) = form(Powers { mass: ZERO, damping: one, stiffness: ZERO });
    let (stiffness, stiffness_size) = form(Powers { mass: ZERO, damping: ZERO, stiffness: one });
    let slope = |lambda: Complex<f64>| lambda * mass * 2.0 + damping;
    for _ in 0..4 {
        lambda -= (lambda * (lambda * mass + damping) + stiffness) / slope(lambda);
    }
    let size = lambda.norm();
    let all = size * (size * mass_size + damping_size) + stiffness_size;
    let rounding = f64::EPSILON * all / (slope(lambda).norm() * size);
    (lambda.re.is_finite() && lambda.im.is_finite() && rounding < ANOTHER).then_some((lambda, rounding))
}
