//! Free vibration of a uniform beam on any supports, by its exact dynamic stiffness.
//!
//! All is in units of the beam: lengths over its length `L`, forces over `EI/L²`, masses over its whole mass
//! `m̄ L`; then `λ = m̄ ω² L⁴/(EI) = β⁴`. The differential equations are Timoshenko's, with an axial force and an
//! elastic foundation; without shear and rotary inertia they are those of Euler and Bernoulli.
//!
//! Between the stations the beam is cut into segments so short that nothing overflows and nothing cancels. The
//! number of frequencies below a trial one is counted exactly (W. H. Wittrick and F. W. Williams, *Q. J. Mech. Appl.
//! Math.* 24, 1971, pp. 263–284), and bisected: no root is missed, double ones included.
// Long because the matrix, its count of roots and the shapes are one method, read together.

use nalgebra::{Matrix2, Matrix4, Vector2, Vector4};

pub use self::search::Search;
use dalembert_numerics::{gauss_legendre, roots};

pub mod frame;
pub mod spans;

mod search;

/// Largest angles of the wave in a segment, rad; a segment clamped at both ends vibrates first at 4.73. The second
/// one serves where the first one cuts the beam so that a part of it resonates by itself.
const SEGMENTS: [f64; 2] = [1.5, 1.13];

/// Largest wave angle over the whole beam.
const MOST_WAVES: f64 = 500.0;

/// A uniform beam.
#[derive(Clone, Debug, PartialEq)]
pub struct Beam {
    /// Shear flexibility `EI/(κ G A L²)`; zero for Euler–Bernoulli.
    pub shear: f64,
    /// Rotary inertia of the sections `I/(A L²)`; zero for Euler–Bernoulli.
    pub rotary: f64,
    /// Axial force `N L²/(EI)`, tension positive.
    pub axial: f64,
    /// Stiffness of the foundation for each length, `k L⁴/(EI)`.
    pub foundation: f64,
    /// Supports and lumped elements of the beam, positions ascending from 0 to 1; both ends are among them.
    pub stations: Vec<BeamStation>,
}

/// Support and lumped elements at a point of the beam.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct BeamStation {
    /// Position along the beam as a fraction of its length, 0 to 1.
    pub at: f64,
    /// True if the deflection is zero (support).
    pub held: bool,
    /// True if the rotation is zero (clamp).
    pub clamped: bool,
    /// Spring to the ground, `k L³/(EI)`.
    pub spring: f64,
    /// Rotation spring to the ground, `k L/(EI)`.
    pub turning_spring: f64,
    /// Mass, over that of the beam.
    pub mass: f64,
    /// Moment of inertia, over the mass of the beam times `L²`.
    pub inertia: f64,
}

/// Reason for which no frequencies are found.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum BeamError {
    /// A number is not finite or out of its range, or the stations do not go from 0 to 1.
    #[error("a number of the beam is not finite or out of its range")]
    OutOfRange,
    /// The compression is beyond the buckling load.
    #[error("the beam buckles under its axial load; write a smaller compression")]
    Buckled,
    /// The waves are too short for the length of the beam.
    #[error("the beam is too slender or too strongly stretched: its waves are {0:e} times shorter than it")]
    TooSlender(f64),
    /// No root in the range of numbers.
    #[error("the search for the frequencies did not converge")]
    NotConverged,
}

/// Positions in a segment at which the shape is examined, as fractions of its length.
const EIGHTHS: [f64; 8] = [0.0, 0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875];

/// The shape of a vibration, largest deflection one.
#[derive(Clone, Debug, PartialEq)]
pub struct BeamShape {
    beam: Beam,
    lambda: f64,
    /// Start of each segment, as a fraction of the length, and the state vector there.
    starts: Vec<(f64, Vector4<f64>)>,
}

/// The state of a section.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SectionState {
    /// Deflection.
    pub deflection: f64,
    /// Rotation.
    pub rotation: f64,
    /// Transverse force.
    pub force: f64,
    /// Bending moment.
    pub moment: f64,
}

/// The beam cut into segments at one `λ`: a node at each end of each.
struct Chain {
    segments: Vec<Segment>,
    nodes: Vec<Node>,
    /// Sizes of a transverse and of a rotational stiffness, for what is held.
    sizes: [f64; 2],
}

#[derive(Clone, Copy)]
struct Node {
    stiffness: Matrix2<f64>,
    held: [bool; 2],
}

#[derive(Clone, Copy)]
struct Segment {
    start: f64,
    /// `T₁₁` and `T₁₂⁻¹` of the transfer matrix.
    carry: Matrix2<f64>,
    inverse: Matrix2<f64>,
    left: Matrix2<f64>,
    right: Matrix2<f64>,
    /// `ln |det T₁₂|`.
    size: f64,
    /// Frequencies below `λ` with both ends clamped.
    clamped: usize,
}

impl Beam {
    /// The first `count` roots `β_n` above zero, ascending, each to about `1e-13`.
    ///
    /// # Errors
    /// All of [`BeamError`].
    pub fn roots(&self, count: usize) -> Result<Vec<f64>, BeamError> {
        self.check()?;
        if self.is_buckled()? {
            return Err(BeamError::Buckled);
        }
        let search = Search {
            count: |lambda: f64, angle: f64| self.count_below(lambda, angle),
            quotient: |beta: f64| Ok(self.unscaled(beta)?.rayleigh_quotient()),
            alone: 0.05,
        };
        search.roots(self.rigid_motions(), count)
    }

    /// Number of eigenvalues `λ` of the beam below this value (Wittrick–Williams count).
    ///
    /// # Errors
    /// `TooSlender`.
    pub fn count(&self, lambda: f64) -> Result<usize, BeamError> {
        self.count_below(lambda, SEGMENTS[0])
    }

    /// The same with the beam divided into segments in which no wave turns through more than this angle, rad.
    ///
    /// # Errors
    /// `TooSlender`.
    pub fn count_below(&self, lambda: f64, angle: f64) -> Result<usize, BeamError> {
        let chain = self.chain(lambda, angle)?;
        let clamped: usize = chain.segments.iter().map(|segment| segment.clamped).sum();
        Ok(clamped + chain.pivots().iter().map(negatives).sum::<usize>())
    }

    /// Motions of the beam as a whole that nothing holds: none, one or two.
    pub fn rigid_motions(&self) -> usize {
        let stations = self.stations.iter();
        let holds = stations.clone().filter(|station| station.held || station.spring > 0.0);
        let places = holds.map(|station| station.at).collect::<Vec<_>>();
        let apart = places.iter().any(|at| *at != places[0]);
        let turns = self.axial != 0.0 || self.stations.iter().any(|at| at.clamped || at.turning_spring > 0.0);
        if self.foundation > 0.0 || apart {
            return 0;
        }
        usize::from(places.is_empty()) + usize::from(!turns)
    }

    /// The compression `P L²/(EI)` at which the beam buckles, without the axial force that it has; `None` where it
    /// can move as a whole.
    ///
    /// # Errors
    /// `TooSlender`, `NotConverged`.
    pub fn buckling_load(&self) -> Result<Option<f64>, BeamError> {
        let beam = Beam { axial: 0.0, ..self.clone() };
        if beam.rigid_motions() > 0 {
            return Ok(None);
        }
        let most = self.shear_buckling_load();
        let (mut low, mut high) = (0.0, 1.0f64.min(most));
        while !beam.buckles(high)? {
            low = high;
            high *= 2.0;
        }
        for _ in 0..400 {
            if high - low <= 4.0 * f64::EPSILON * high || high < 1e-200 {
                return Ok(Some(0.5 * (low + high)));
            }
            let middle = if low == 0.0 { high / 8.0 } else { 0.5 * (low + high) };
            if beam.buckles(middle)? {
                high = middle;
            } else {
                low = middle;
            }
        }
        Err(BeamError::NotConverged)
    }

    /// Returns true if the beam buckles under a compression `P L²/(EI)` in place of its axial force, by the number of
    /// `λ` below zero.
    ///
    /// # Errors
    /// `TooSlender`.
    pub fn buckles(&self, load: f64) -> Result<bool, BeamError> {
        let pressed = Beam { axial: -load, ..self.clone() };
        Ok(load >= self.shear_buckling_load() || pressed.count(0.0)? > 0)
    }

    /// In shear alone a beam buckles at `κ G A`.
    fn shear_buckling_load(&self) -> f64 {
        if self.shear > 0.0 { 1.0 / self.shear } else { f64::INFINITY }
    }

    /// A function of β that is zero at the roots and nowhere jumps: the determinant of the conditions at the
    /// stations, over a positive number that keeps it of order one.
    ///
    /// # Errors
    /// `TooSlender`.
    pub fn characteristic(&self, beta: f64) -> Result<f64, BeamError> {
        let lambda = beta.powi(4);
        let chain = self.chain(lambda, SEGMENTS[0])?;
        let (mut sign, mut size) = (1.0, 0.0);
        for pivot in chain.pivots() {
            let determinant = pivot.determinant();
            sign *= determinant.signum();
            size += determinant.abs().ln();
        }
        size += chain.segments.iter().map(|segment| segment.size).sum::<f64>();
        let growth = self.squares(lambda).map_or(0.0, |squares| squares[0].max(0.0).sqrt());
        // What is held stands in the pivots by its size alone.
        for node in &chain.nodes {
            let held = |n: usize| if node.held[n] { chain.sizes[n].ln() } else { 0.0 };
            size -= held(0) + held(1);
        }
        let free = |n: usize| self.stations.iter().filter(|at| ![at.held, at.clamped][n]).count() as f64;
        let order = 3.0 * free(0) + free(1) - 4.0;
        let scaled = sign * (size - growth - order * beta.max(1e-3).ln()).exp();
        Ok(if scaled.is_finite() { scaled } else { 0.0 })
    }

    /// The shape of the vibration at a root.
    ///
    /// # Errors
    /// `TooSlender`; `NotConverged` where the shape is not a finite number.
    pub fn shape(&self, root: f64) -> Result<BeamShape, BeamError> {
        let mut shape = self.unscaled(root)?;
        let crest = shape.crest();
        let scale = if crest == 0.0 { f64::NAN } else { 1.0 / crest };
        shape.starts.iter_mut().for_each(|(_, state)| *state *= scale);
        let finite = shape.starts.iter().all(|(_, state)| state.iter().all(|x| x.is_finite()));
        if finite { Ok(shape) } else { Err(BeamError::NotConverged) }
    }

    fn unscaled(&self, root: f64) -> Result<BeamShape, BeamError> {
        let lambda = root.powi(4);
        let chain = self.chain(lambda, SEGMENTS[0])?;
        let displacements = chain.shape();
        let starts: Vec<(f64, Vector4<f64>)> = chain
            .segments
            .iter()
            .zip(displacements.windows(2))
            .map(|(segment, ends)| {
                let forces = segment.inverse * (ends[1] - segment.carry * ends[0]);
                (segment.start, Vector4::new(ends[0].x, ends[0].y, forces.x, forces.y))
            })
            .collect();
        Ok(BeamShape { beam: self.clone(), lambda, starts })
    }

    /// Stiffness at the far end seen from outside, `λ` of the tip included, and the number of frequencies below `λ`
    /// with that end clamped: what a body fixed to the end needs of the beam.
    ///
    /// # Errors
    /// All of [`BeamError`] but `Buckled`.
    pub fn tip_stiffness(&self, lambda: f64) -> Result<(Matrix2<f64>, usize), BeamError> {
        self.check()?;
        let chain = self.chain(lambda, SEGMENTS[0])?;
        let clamped: usize = chain.segments.iter().map(|segment| segment.clamped).sum();
        let mut pivots = chain.pivots();
        let tip = pivots.pop().ok_or(BeamError::OutOfRange)?;
        Ok((tip, clamped + pivots.iter().map(negatives).sum::<usize>()))
    }

    fn check(&self) -> Result<(), BeamError> {
        let positive = |x: f64| x.is_finite() && x >= 0.0;
        let numbers = [self.shear, self.rotary, self.foundation].into_iter().all(positive);
        let stations = self
            .stations
            .iter()
            .all(|at| [at.at, at.spring, at.turning_spring, at.mass, at.inertia].into_iter().all(positive));
        let ascending = self.stations.windows(2).all(|pair| pair[0].at < pair[1].at);
        let ends = match (self.stations.first(), self.stations.last()) {
            (Some(first), Some(last)) => first.at == 0.0 && last.at == 1.0,
            _ => false,
        };
        if numbers && stations && ascending && ends && self.axial.is_finite() {
            return if self.axial * self.shear <= -1.0 { Err(BeamError::Buckled) } else { Ok(()) };
        }
        Err(BeamError::OutOfRange)
    }

    /// Returns true if the axial force makes the straight beam unstable.
    fn is_buckled(&self) -> Result<bool, BeamError> {
        if self.axial >= 0.0 {
            return Ok(false);
        }
        // A little below zero, so that motions as a whole are not counted by rounding.
        let lambda = if self.rigid_motions() == 0 { 0.0 } else { -1e-6 * self.axial.abs().min(1.0) };
        Ok(self.count(lambda)? > 0)
    }

    /// The squares of the two wave numbers, `w ∝ e^{pξ}`, the larger first; `None` where they are not real.
    fn squares(&self, lambda: f64) -> Option<[f64; 2]> {
        let (half, product) = self.square_equation(lambda);
        let discriminant = half.powi(2) - product;
        (discriminant >= 0.0).then(|| {
            let far = half + discriminant.sqrt().copysign(half);
            let near = if far == 0.0 { 0.0 } else { product / far };
            [far.max(near), far.min(near)]
        })
    }

    /// Half the sum and the product of the two `p²`.
    fn square_equation(&self, lambda: f64) -> (f64, f64) {
        let stretched = 1.0 + self.axial * self.shear;
        let inertia = lambda - self.foundation;
        let sum = self.axial - stretched * self.rotary * lambda - self.shear * inertia;
        let product = -inertia * (1.0 - self.shear * self.rotary * lambda);
        (0.5 * sum / stretched, product / stretched)
    }

    /// The largest wave number, real or not.
    fn largest_wave_number(&self, lambda: f64) -> f64 {
        match self.squares(lambda) {
            Some(squares) => squares[0].abs().max(squares[1].abs()).sqrt(),
            None => self.square_equation(lambda).1.abs().sqrt().sqrt(),
        }
    }

    /// `exp(A h)` of `d(W, ψ, V, M)/dξ = A (W, ψ, V, M)`, with `V` the transverse force of shear and axial force
    /// together, over a length of at most a wave angle of [`SEGMENTS`]: the series does not cancel.
    fn transfer(&self, lambda: f64, length: f64) -> Matrix4<f64> {
        let stretched = 1.0 + self.axial * self.shear;
        let slope = [length / stretched, length * self.shear / stretched];
        let force = length * (self.foundation - lambda);
        let moment = [length * (self.axial / stretched - self.rotary * lambda), -length / stretched];
        let column = |unit: usize| {
            let mut term = [0.0; 4];
            term[unit] = 1.0;
            let mut sum = term;
            for n in 1..=30u8 {
                let part = 1.0 / f64::from(n);
                let [w, turn, v, m] = term;
                term = [
                    part * (slope[0] * turn + slope[1] * v),
                    part * length * m,
                    part * force * w,
                    part * (moment[0] * turn + moment[1] * v),
                ];
                let mut settled = true;
                for (sum, term) in sum.iter_mut().zip(term) {
                    *sum += term;
                    settled &= term.abs() <= 1e-18 * sum.abs();
                }
                // Some terms vanish where the next ones do not.
                if settled && n > 12 {
                    break;
                }
            }
            sum
        };
        let columns = [column(0), column(1), column(2), column(3)];
        Matrix4::from_fn(|row, unit| columns[unit][row])
    }

    fn chain(&self, lambda: f64, angle: f64) -> Result<Chain, BeamError> {
        let wave = self.largest_wave_number(lambda);
        if !(wave.is_finite() && wave <= MOST_WAVES) {
            return Err(BeamError::TooSlender(wave));
        }
        let size = wave.max(1.0);
        let mut chain = Chain { segments: Vec::new(), nodes: Vec::new(), sizes: [size.powi(3), size] };
        let mut left_over = Matrix2::zeros();
        for (n, station) in self.stations.iter().enumerate() {
            let own = Matrix2::new(
                station.spring - lambda * station.mass,
                0.0,
                0.0,
                station.turning_spring - lambda * station.inertia,
            );
            let mut node = Node { stiffness: left_over + own, held: [station.held, station.clamped] };
            let Some(next) = self.stations.get(n + 1) else {
                chain.nodes.push(node);
                break;
            };
            let length = next.at - station.at;
            let parts = (length * wave / angle).ceil().max(1.0);
            let segment = self.segment(lambda, length / parts);
            for part in 0..parts as usize {
                let start = station.at + length * part as f64 / parts;
                node.stiffness += segment.left;
                chain.nodes.push(node);
                chain.segments.push(Segment { start, ..segment });
                node = Node { stiffness: segment.right, held: [false, false] };
            }
            left_over = segment.right;
        }
        chain.hold();
        Ok(chain)
    }

    fn segment(&self, lambda: f64, length: f64) -> Segment {
        let transfer = self.transfer(lambda, length);
        let carry = transfer.fixed_view::<2, 2>(0, 0).into_owned();
        let flexible = transfer.fixed_view::<2, 2>(0, 2).into_owned();
        let inverse = inverse(&flexible);
        let left = symmetric(&(inverse * carry));
        let right = symmetric(&(transfer.fixed_view::<2, 2>(2, 2).into_owned() * inverse));
        // Both ends pinned, the segment has no frequency below λ but that of pure shear; what the rotations of the
        // ends then add is taken away again.
        let pure_shear = usize::from(self.shear * self.rotary * lambda > 1.0);
        let rotations = Matrix2::new(left[(1, 1)], -inverse[(1, 1)], -inverse[(1, 1)], right[(1, 1)]);
        let clamped = pure_shear.saturating_sub(negatives(&rotations));
        Segment { start: 0.0, carry, inverse, left, right, size: flexible.determinant().abs().ln(), clamped }
    }
}

impl Chain {
    /// Takes what is held out of the stiffness of each node.
    fn hold(&mut self) {
        for node in &mut self.nodes {
            for n in [0, 1] {
                if node.held[n] {
                    node.stiffness.row_mut(n).fill(0.0);
                    node.stiffness.column_mut(n).fill(0.0);
                    node.stiffness[(n, n)] = self.sizes[n];
                }
            }
        }
    }

    /// Coupling of a node with the next.
    fn coupling(&self, node: usize) -> Matrix2<f64> {
        let [here, next] = [self.nodes[node].held, self.nodes[node + 1].held];
        let inverse = &self.segments[node].inverse;
        let entry = |row: usize, column: usize| {
            if here[row] || next[column] { 0.0 } else { -inverse[(row, column)] }
        };
        Matrix2::new(entry(0, 0), entry(0, 1), entry(1, 0), entry(1, 1))
    }

    /// The pivots of the elimination from the first node on.
    fn pivots(&self) -> Vec<Matrix2<f64>> {
        let mut pivots: Vec<Matrix2<f64>> = Vec::with_capacity(self.nodes.len());
        for (n, node) in self.nodes.iter().enumerate() {
            let mut stiffness = node.stiffness;
            if let Some(pivot) = pivots.last() {
                // Written out, since this is done more often than all the rest.
                let [a, c, b, d]: [f64; 4] = flat(&self.coupling(n - 1));
                let [p, q, _, r]: [f64; 4] = flat(&inverse(pivot));
                let (pa, qa, pb, qb) = (p * a + q * c, q * a + r * c, p * b + q * d, q * b + r * d);
                let off = 0.5 * (a * pb + c * qb + b * pa + d * qa);
                stiffness -= Matrix2::new(a * pa + c * qa, off, off, b * pb + d * qb);
            }
            pivots.push(stiffness);
        }
        pivots
    }

    /// Displacements of the nodes where the stiffness is next to singular: inverse iteration.
    fn shape(&self) -> Vec<Vector2<f64>> {
        let scale = |row: usize| self.sizes[row % 2].sqrt().recip();
        let mut matrix = Banded::new(2 * self.nodes.len());
        for (n, node) in self.nodes.iter().enumerate() {
            for (i, j) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
                matrix.set(2 * n + i, 2 * n + j, node.stiffness[(i, j)] * scale(i) * scale(j));
            }
            if n + 1 < self.nodes.len() {
                let coupling = self.coupling(n);
                for (i, j) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
                    let value = coupling[(i, j)] * scale(i) * scale(j);
                    matrix.set(2 * n + i, 2 * n + 2 + j, value);
                    matrix.set(2 * n + 2 + j, 2 * n + i, value);
                }
            }
        }
        let held = |row: usize| self.nodes[row / 2].held[row % 2];
        // A start without symmetry; three rounds leave nothing of other shapes.
        let start = |row: usize| if held(row) { 0.0 } else { 1.0 + 0.3 * (row as f64).sin() };
        let mut displacements: Vec<f64> = (0..matrix.rows.len()).map(start).collect();
        matrix.factor();
        for _ in 0..3 {
            matrix.solve(&mut displacements);
            let size = displacements.iter().fold(0.0f64, |size, x| size.max(x.abs()));
            for x in &mut displacements {
                *x /= size;
            }
        }
        let free = |row: usize| if held(row) { 0.0 } else { displacements[row] * scale(row) };
        (0..self.nodes.len()).map(|n| Vector2::new(free(2 * n), free(2 * n + 1))).collect()
    }
}

/// A matrix with three diagonals on each side of the main one, and room for three more that pivoting fills.
struct Banded {
    /// Row `i` holds the columns `i − 3` to `i + 6`.
    rows: Vec<[f64; 10]>,
    /// The row exchanged with each row, and the multiples of it taken from the rows below.
    steps: Vec<(usize, [f64; 3])>,
}

impl Banded {
    fn new(size: usize) -> Self {
        Banded { rows: vec![[0.0; 10]; size], steps: Vec::new() }
    }

    fn set(&mut self, row: usize, column: usize, value: f64) {
        self.rows[row][column + 3 - row] = value;
    }

    /// Gaussian elimination with partial pivoting; a vanishing pivot is replaced by rounding.
    fn factor(&mut self) {
        let size = self.rows.len();
        for column in 0..size {
            let last = (column + 3).min(size - 1);
            let entry = |rows: &[[f64; 10]], row: usize| rows[row][column + 3 - row];
            let pivot = (column..=last)
                .max_by(|&a, &b| entry(&self.rows, a).abs().total_cmp(&entry(&self.rows, b).abs()))
                .unwrap_or(column);
            let width = 10 - 3;
            for k in 0..width {
                // Column `column + k` in both rows; beyond the band both are zero.
                let (a, b) = (3 + k, column + k + 3 - pivot);
                let upper = self.rows[column][a];
                self.rows[column][a] = self.rows[pivot][b];
                self.rows[pivot][b] = upper;
            }
            if self.rows[column][3].abs() < f64::EPSILON {
                self.rows[column][3] = f64::EPSILON.copysign(self.rows[column][3]);
            }
            let mut multiples = [0.0; 3];
            for row in column + 1..=last {
                let shift = row - column;
                let multiple = self.rows[row][3 - shift] / self.rows[column][3];
                multiples[shift - 1] = multiple;
                for k in 0..width {
                    self.rows[row][3 + k - shift] -= multiple * self.rows[column][3 + k];
                }
            }
            self.steps.push((pivot, multiples));
        }
    }

    /// Solves with the factors.
    fn solve(&self, x: &mut [f64]) {
        let size = x.len();
        for (column, (pivot, multiples)) in self.steps.iter().enumerate() {
            x.swap(column, *pivot);
            for (shift, multiple) in (1..).zip(multiples).take_while(|(shift, _)| column + shift < size) {
                x[column + shift] -= multiple * x[column];
            }
        }
        for row in (0..size).rev() {
            let known: f64 =
                (1..7).filter(|k| row + k < size).map(|k| self.rows[row][3 + k] * x[row + k]).sum();
            x[row] = (x[row] - known) / self.rows[row][3];
        }
    }
}

impl BeamShape {
    /// The state at `ξ`, 0 to 1.
    pub fn state(&self, xi: f64) -> SectionState {
        let after = self.starts.partition_point(|(start, _)| *start <= xi);
        let (start, state) = self.starts[after.saturating_sub(1)];
        let here = self.beam.transfer(self.lambda, xi - start) * state;
        SectionState::from(here)
    }

    /// Points inside the beam where the deflection passes through zero, ascending; supports are not among them.
    pub fn nodes(&self) -> Vec<f64> {
        let sampled: Vec<(f64, f64)> = self
            .along(&EIGHTHS)
            .into_iter()
            .map(|(xi, _, state)| (xi, state.deflection))
            .chain([(1.0, self.state(1.0).deflection)])
            .filter(|(_, w)| w.abs() > 1e-9)
            .collect();
        let stations = &self.beam.stations;
        let free = |pair: &&[(f64, f64)]| {
            !stations.iter().any(|at| at.held && pair[0].0 <= at.at && at.at <= pair[1].0)
        };
        let crossing = |pair| roots::crossing(pair, |xi| self.state(xi).deflection);
        sampled.windows(2).filter(free).filter_map(crossing).collect()
    }

    /// Rayleigh's quotient of the shape: twice the largest strain energy, that of axial force, foundation and
    /// springs included, over twice the kinetic energy at unit frequency. At a root it is `λ`.
    pub fn rayleigh_quotient(&self) -> f64 {
        let beam = &self.beam;
        let (mut strain, mut kinetic) = (0.0, 0.0);
        let (parts, weights): (Vec<f64>, Vec<f64>) = gauss_legendre::points(1).unzip();
        for ((_, length, at), weight) in self.along(&parts).into_iter().zip(weights.iter().cycle()) {
            let weight = weight * length;
            let shear = (at.force - beam.axial * at.rotation) / (1.0 + beam.axial * beam.shear);
            let slope = at.rotation + beam.shear * shear;
            strain += weight
                * (at.moment.powi(2)
                    + beam.shear * shear.powi(2)
                    + beam.axial * slope.powi(2)
                    + beam.foundation * at.deflection.powi(2));
            kinetic += weight * (at.deflection.powi(2) + beam.rotary * at.rotation.powi(2));
        }
        for station in &beam.stations {
            let at = self.state(station.at);
            let (w, turn) = (at.deflection.powi(2), at.rotation.powi(2));
            strain += station.spring * w + station.turning_spring * turn;
            kinetic += station.mass * w + station.inertia * turn;
        }
        strain / kinetic
    }

    /// `∫ (U V + r ψ φ) dξ + Σ (μ U V + j ψ φ)` of two shapes: zero where they belong to different roots.
    pub fn inertia_product(&self, other: &BeamShape) -> f64 {
        let beam = &self.beam;
        let product = |xi: f64, mass: f64, inertia: f64| {
            let (a, b) = (self.state(xi), other.state(xi));
            mass * a.deflection * b.deflection + inertia * a.rotation * b.rotation
        };
        // No jump of the forces at a station lies inside a panel; two segments fit into one.
        let parts = self.starts.len().max(other.starts.len());
        let between = beam.stations.windows(2).map(|ends| {
            let length = ends[1].at - ends[0].at;
            let panels = (0.5 * length * parts as f64).ceil() as usize;
            length
                * gauss_legendre::integral(panels, |part| {
                    product(ends[0].at + length * part, 1.0, beam.rotary)
                })
        });
        between.sum::<f64>() + beam.stations.iter().map(|at| product(at.at, at.mass, at.inertia)).sum::<f64>()
    }

    /// Rounding error of the deflections, relative to the largest: elimination loses the digits by which the stiffness
    /// of the shortest segment, `12EI/l³`, exceeds that of the beam.
    pub fn rounding(&self) -> f64 {
        let ends = self.starts.iter().skip(1).map(|(start, _)| *start).chain([1.0]);
        let lengths = self.starts.iter().zip(ends).map(|((start, _), end)| end - start);
        f64::EPSILON * lengths.fold(1.0, f64::min).powi(-3)
    }

    /// The states at the same parts of each segment: where, the length of the segment, and the state. Segments of one
    /// length share their transfer matrices.
    fn along(&self, parts: &[f64]) -> Vec<(f64, f64, SectionState)> {
        let mut all = Vec::with_capacity(parts.len() * self.starts.len());
        let (mut of, mut transfers) = (0.0, Vec::new());
        let ends = self.starts.iter().skip(1).map(|(start, _)| *start).chain([1.0]);
        for ((start, state), end) in self.starts.iter().zip(ends) {
            let length = end - start;
            if (length - of).abs() > 1e-12 * length {
                of = length;
                transfers = parts.iter().map(|part| self.beam.transfer(self.lambda, part * length)).collect();
            }
            let here = parts.iter().zip(&transfers);
            all.extend(
                here.map(|(part, to)| (start + part * length, length, SectionState::from(to * state))),
            );
        }
        all
    }

    /// The largest deflection, with the sign of it; where there is none but of rounding, the largest rotation.
    fn crest(&self) -> f64 {
        let deflection = |xi: f64| self.state(xi.clamp(0.0, 1.0)).deflection;
        let larger = |a: f64, b: f64| if b.abs() > a.abs() { b } else { a };
        let sampled = self.along(&EIGHTHS);
        let end = (1.0, 0.0, self.state(1.0));
        let (place, step, highest) = sampled
            .iter()
            .chain([&end])
            .map(|(xi, length, state)| (*xi, length / 8.0, state.deflection))
            .max_by(|a, b| a.2.abs().total_cmp(&b.2.abs()))
            .unwrap_or_default();
        let turned = self.starts.iter().map(|(_, state)| state[1]).fold(0.0, larger);
        if highest.abs() < 1e-9 * turned.abs() {
            return turned;
        }
        // The crest of a parabola through three points, twice, the second time through near ones.
        let mut at = place;
        let mut crest = highest;
        for step in [step, step / 30.0] {
            let (before, here, after) = (deflection(at - step), deflection(at), deflection(at + step));
            let bend = before - 2.0 * here + after;
            let shift = if bend == 0.0 { 0.0 } else { 0.5 * step * (before - after) / bend };
            at = (at + shift.clamp(-step, step)).clamp(0.0, 1.0);
            crest = larger(crest, deflection(at));
        }
        crest
    }
}

impl From<Vector4<f64>> for SectionState {
    fn from(state: Vector4<f64>) -> Self {
        SectionState { deflection: state[0], rotation: state[1], force: state[2], moment: state[3] }
    }
}

/// Negative eigenvalues of a symmetric matrix.
fn negatives(k: &Matrix2<f64>) -> usize {
    let determinant = k.determinant();
    if determinant < 0.0 { 1 } else { 2 * usize::from(k.trace() < 0.0) }
}

/// The inverse; of a singular matrix that of one next to it, which is as good as rounding can tell.
fn inverse(k: &Matrix2<f64>) -> Matrix2<f64> {
    let determinant = k.determinant();
    let least = f64::EPSILON.powi(2) * k.amax().powi(2).max(f64::MIN_POSITIVE);
    let determinant = if determinant == 0.0 { least } else { determinant };
    Matrix2::new(k[(1, 1)], -k[(0, 1)], -k[(1, 0)], k[(0, 0)]) / determinant
}

/// The entries, column by column.
fn flat(k: &Matrix2<f64>) -> [f64; 4] {
    [k[(0, 0)], k[(1, 0)], k[(0, 1)], k[(1, 1)]]
}

fn symmetric(k: &Matrix2<f64>) -> Matrix2<f64> {
    (k + k.transpose()) * 0.5
}
