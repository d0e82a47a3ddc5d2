//! The response of a damped system as a sum over its poles: exact for loads that are straight from time to time.

use nalgebra::{Complex, DMatrix, DVector};

use super::modes::{ModesError, NaturalModes};
use dalembert_numerics::linalg;

/// Two roots of one mode nearer than this share of their size are taken this far apart: critical damping and rigid
/// body modes have one root twice. The sum of two is even in the distance, so its square is the error.
const APART: f64 = 1e-5;

/// A linear system as first-order equations `ż = λ z + b f`, one for each root, with `x = Σ s z`.
#[derive(Debug, Clone, PartialEq)]
pub struct Poles {
    /// The roots.
    pub roots: Vec<Complex<f64>>,
    /// Displacements for a unit of each modal state z, one column each.
    pub shapes: DMatrix<Complex<f64>>,
    /// Coefficients of the modal coordinates q in each z.
    of_position: DMatrix<Complex<f64>>,
    /// Coefficients of the modal velocities and of the modal forces in each z.
    of_velocity: DMatrix<Complex<f64>>,
    natural: DMatrix<f64>,
}

impl Poles {
    /// The poles of a system with these modes and this modal damping matrix `Φᵀ C Φ`; `duration` is the time that
    /// the roots of a rigid body mode are distinguished by.
    ///
    /// Modes that no damping couples are taken by themselves.
    ///
    /// # Errors
    /// `Linalg(Singular)` where coupled modes share one root and one shape.
    pub fn new(modes: &NaturalModes, damping: &DMatrix<f64>, duration: f64) -> Result<Self, ModesError> {
        let n = modes.squares.len();
        let mut poles = Self {
            roots: Vec::with_capacity(2 * n),
            shapes: DMatrix::zeros(n, 2 * n),
            of_position: DMatrix::zeros(2 * n, n),
            of_velocity: DMatrix::zeros(2 * n, n),
            natural: modes.shapes.clone(),
        };
        for group in groups(damping) {
            if let [mode] = group[..] {
                poles.add_alone(mode, modes.squares[mode], damping[(mode, mode)], duration);
            } else {
                poles.add_coupled(&group, &modes.squares, damping)?;
            }
        }
        Ok(poles)
    }

    /// The state of a motion: `ΦᵀM x` and `ΦᵀM ẋ` are its modal coordinates.
    pub fn state(&self, position: &DVector<f64>, velocity: &DVector<f64>) -> Vec<Complex<f64>> {
        (0..self.roots.len())
            .map(|at| along(&self.of_position, at, position) + along(&self.of_velocity, at, velocity))
            .collect()
    }

    /// b of a force on the masses.
    pub fn input(&self, force: &DVector<f64>) -> Vec<Complex<f64>> {
        let modal = self.natural.transpose() * force;
        (0..self.roots.len()).map(|at| along(&self.of_velocity, at, &modal)).collect()
    }

    /// The displacement of a mass in a state.
    pub fn displacement(&self, row: usize, state: &[Complex<f64>]) -> f64 {
        self.shapes.row(row).iter().zip(state).map(|(s, z)| (s * z).re).sum()
    }

    /// The velocity of a mass in a state, for a force of zero share `x = Σ s z` alone: `ẋ = Σ s λ z`, since `Σ s b = 0`.
    pub fn velocity(&self, row: usize, state: &[Complex<f64>]) -> f64 {
        self.shapes.row(row).iter().zip(state).zip(&self.roots).map(|((s, z), root)| (s * z * root).re).sum()
    }

    /// One mode by itself: `q̈ + g q̇ + ω² q = p`.
    fn add_alone(&mut self, mode: usize, square: f64, damping: f64, duration: f64) {
        let half = damping / 2.0;
        let size = square.sqrt().max(half.abs()).max(if duration > 0.0 { 1.0 / duration } else { 0.0 });
        let apart = half * half - square;
        let smallest = (APART * size).powi(2);
        let (first, second) = if apart.abs() < smallest {
            let offset = if apart > 0.0 {
                Complex::new(smallest.sqrt(), 0.0)
            } else {
                Complex::new(0.0, smallest.sqrt())
            };
            (offset - half, -offset - half)
        } else if apart < 0.0 {
            let frequency = (-apart).sqrt();
            (Complex::new(-half, frequency), Complex::new(-half, -frequency))
        } else {
            // The root of the larger modulus first: the other is their product over it, without cancellation.
            let far = -half - half.signum() * apart.sqrt();
            (Complex::new(square / far, 0.0), Complex::new(far, 0.0))
        };
        let scale = (second - first).inv();
        for (root, position, velocity) in [(first, second, -1.0), (second, -first, 1.0)] {
            let at = self.roots.len();
            self.roots.push(root);
            for row in 0..self.natural.nrows() {
                self.shapes[(row, at)] = self.natural[(row, mode)].into();
            }
            self.of_position[(at, mode)] = position * scale;
            self.of_velocity[(at, mode)] = scale * velocity;
        }
    }

    /// Modes that the damping couples.
    fn add_coupled(
        &mut self,
        group: &[usize],
        squares: &[f64],
        damping: &DMatrix<f64>,
    ) -> Result<(), ModesError> {
        let n = group.len();
        let block = DMatrix::from_fn(n, n, |i, j| damping[(group[i], group[j])]);
        let unit = group.iter().map(|&mode| squares[mode]).fold(0.0, f64::max).sqrt().max(block.amax());
        let state = DMatrix::from_fn(2 * n, 2 * n, |row, column| match (row < n, column < n) {
            (true, true) => 0.0,
            (true, false) => {
                if row == column - n {
                    unit
                } else {
                    0.0
                }
            }
            (false, true) => {
                if row - n == column {
                    -squares[group[column]] / unit
                } else {
                    0.0
                }
            }
            (false, false) => -block[(row - n, column - n)],
        });
        let eigen = linalg::complex_eigen(&state)?;
        let left = eigen.left()?;
        for (pole, root) in eigen.values.iter().enumerate() {
            let at = self.roots.len();
            self.roots.push(*root);
            for row in 0..self.natural.nrows() {
                self.shapes[(row, at)] = group
                    .iter()
                    .enumerate()
                    .map(|(i, &mode)| eigen.vectors[(i, pole)] * self.natural[(row, mode)])
                    .sum();
            }
            for (i, &mode) in group.iter().enumerate() {
                self.of_position[(at, mode)] = left[(pole, i)];
                self.of_velocity[(at, mode)] = left[(pole, n + i)] / unit;
            }
        }
        Ok(())
    }
}

/// The state a time later, under a force `p + d t`, with b p and b d given.
pub fn advance(
    root: Complex<f64>,
    state: Complex<f64>,
    constant: Complex<f64>,
    slope: Complex<f64>,
    time: f64,
) -> Complex<f64> {
    let x = root * time;
    state * x.exp() + (constant * phi(1, x) + slope * phi(2, x) * time) * time
}

/// The state a time later, under a force `Re(f e^{iΩt})` with b f and the conjugate's b f̄ given.
pub fn advance_harmonic(
    root: Complex<f64>,
    forward: Complex<f64>,
    backward: Complex<f64>,
    frequency: f64,
    time: f64,
) -> Complex<f64> {
    let one = |amplitude: Complex<f64>, frequency: f64| {
        // ∫ e^{λ(t−s)} e^{iΩs} ds = e^{λt} t φ₁((iΩ − λ) t): no quotient of small numbers at resonance.
        let turning = Complex::new(0.0, frequency);
        let (x, y) = (root * time, turning * time);
        let integral = if x.re < 0.0 { y.exp() * phi(1, x - y) } else { x.exp() * phi(1, y - x) };
        amplitude * integral * time
    };
    (one(forward, frequency) + one(backward, -frequency)) / 2.0
}

/// `φ₁ = (eˣ − 1)/x` and `φ₂ = (eˣ − 1 − x)/x²`.
fn phi(order: u8, x: Complex<f64>) -> Complex<f64> {
    if x.norm() < 1.0 {
        let mut term = if order == 1 { Complex::ONE } else { Complex::new(0.5, 0.0) };
        let mut sum = term;
        for n in 1..22_u8 {
            term = term * x / f64::from(n + order);
            sum += term;
        }
        return sum;
    }
    let first = (x.exp() - 1.0) / x;
    if order == 1 { first } else { (first - 1.0) / x }
}

/// The modes that damping couples, together.
fn groups(damping: &DMatrix<f64>) -> Vec<Vec<usize>> {
    let n = damping.nrows();
    let limit = 1e-12 * damping.amax();
    let mut seen = vec![false; n];
    let mut groups = Vec::new();
    for first in 0..n {
        if seen[first] {
            continue;
        }
        seen[first] = true;
        let mut group = vec![first];
        let mut at = 0;
        while at < group.len() {
            for other in 0..n {
                let coupling = damping[(group[at], other)].abs().max(damping[(other, group[at])].abs());
                if !seen[other] && coupling > limit {
                    seen[other] = true;
                    group.push(other);
                }
            }
            at += 1;
        }
        group.sort_unstable();
        groups.push(group);
    }
    groups
}

fn along(matrix: &DMatrix<Complex<f64>>, row: usize, x: &DVector<f64>) -> Complex<f64> {
    matrix.row(row).iter().zip(x.iter()).map(|(a, x)| a * *x).sum()
}
