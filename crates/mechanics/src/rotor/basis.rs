//! A few shapes of one plane that hold the lowest modes of a rotor at any speed.
//!
//! The first shapes are the answers of the shaft on its mean bearings to the loads that rotation and the bearings can
//! put on it; the Ritz modes in their space are the coordinates. How much a mode is still off is reported by its residual
//! in the full equations, and where that is too much the shapes that would take the residual away are added: some
//! rounds of them make ten digits. With all shapes the space is the full model. Since the modes of many speeds share
//! their shapes, the fewest shapes that hold them all are taken in the end: an eigenproblem costs their number cubed.
//!
//! Shapes are measured by their strain energy, in whose share a natural frequency errs.

use nalgebra::{Complex, DMatrix, DVector};

use super::{Assembled, Plane, RotorError, assembled::Bending, plane, stiffness::Node};
use dalembert_numerics::linalg::{self, LinalgError};

/// Below this share of the largest modal mass of shapes of unit energy a shape counts as massless: its frequency
/// would be millions of times the lowest.
const MASSLESS: f64 = 1e-14;

/// A pivot of the stiffness below this share of its diagonal entry tells so few digits that some mass is added first.
const FIRM: f64 = 1e-11;

/// A static energy below zero by less than this share of what was added up is rounding.
const NEGATIVE: f64 = 1e-11;

/// Ritz modes of one plane.
pub(super) struct Basis {
    /// Orthonormal in the mass matrix, a column each.
    pub(super) vectors: DMatrix<f64>,
    /// Natural frequencies of the Ritz modes on the mean bearings, shift included, rad/s, ascending.
    pub(super) frequencies: Vec<f64>,
    /// Shift σ, s⁻²: `K + σ M` is factored where K alone is ill-conditioned.
    pub(super) shift: f64,
    /// True if the supports leave a rigid-body motion.
    pub(super) free: bool,
    /// Stiffness of the shaft without its bearings.
    pub(super) shaft: DMatrix<f64>,
    pub(super) gyroscopic: DMatrix<f64>,
    pub(super) viscous: DMatrix<f64>,
    pub(super) hysteretic: DMatrix<f64>,
    /// The mean stiffness of each bearing, by node.
    mean: Vec<(usize, f64)>,
    factors: plane::PlaneFactors,
    /// The shapes before they became Ritz modes, orthonormal in the stiffness.
    shapes: Vec<DVector<f64>>,
    /// The stiffness times each of them.
    weighted: Vec<DVector<f64>>,
}

impl Basis {
    /// The shapes for a rotor, bearings taken at a speed.
    ///
    /// # Errors
    /// `Buckled` where the stiffness is not positive.
    pub(super) fn new(rotor: &Assembled, speed: f64) -> Result<Self, RotorError> {
        let mean: Vec<(usize, f64)> = rotor
            .bearings(speed)
            .map(|(node, here)| (node, 0.5 * (here.stiffness[0][0] + here.stiffness[1][1])))
            .map(|(node, k)| (node, k.max(0.0)))
            .collect();
        let (shift, factors) = supported(rotor, &mean)?;
        let mut basis = Self {
            vectors: DMatrix::zeros(0, 0),
            frequencies: Vec::new(),
            shift,
            free: rotor.is_free(&mean),
            shaft: DMatrix::zeros(0, 0),
            gyroscopic: DMatrix::zeros(0, 0),
            viscous: DMatrix::zeros(0, 0),
            hysteretic: DMatrix::zeros(0, 0),
            mean,
            factors,
            shapes: Vec::new(),
            weighted: Vec::new(),
        };
        let size = 2 * rotor.nodes();
        let unit = |freedom: usize| DVector::from_fn(size, |n, _| f64::from(u8::from(n == freedom)));
        let bearings = rotor.bearings(speed).map(|(node, _)| unit(2 * node));
        let discs = rotor
            .discs
            .iter()
            .filter(|&&node| !rotor.fixed.contains(&(2 * node + 1)))
            .map(|&node| unit(2 * node + 1));
        let length = rotor.positions.last().copied().unwrap_or(1.0);
        let level = DVector::from_fn(size, |n, _| if n % 2 == 0 { 1.0 } else { 0.0 });
        let tilted =
            DVector::from_fn(size, |n, _| if n % 2 == 0 { rotor.positions[n / 2] } else { 1.0 } / length);
        let rigid = [level, tilted].map(|shape| rotor.mass.times(&shape));
        let loads: Vec<DVector<f64>> = bearings.chain(discs).chain(rigid).collect();
        let answers = loads.iter().map(|load| basis.factors.solve(load));
        let answers = answers.map(|shape| &shape / basis.energy(rotor, &shape).sqrt()).collect();
        if basis.improve(rotor, answers, 1e-14)? { Ok(basis) } else { Err(RotorError::Rigid) }
    }

    /// The number of shapes.
    pub(super) fn len(&self) -> usize {
        self.shapes.len()
    }

    /// The share by which the square of a natural frequency is still off, from the residual of its mode in the full
    /// equations; and the shapes that would take the residual away, each with its part of that share as energy.
    pub(super) fn error(
        &self,
        rotor: &Assembled,
        lambda: Complex<f64>,
        shape: &[Node],
        residual: &[Node],
    ) -> (f64, [DVector<f64>; 4]) {
        let shapes = parts(shape);
        let elastic: f64 = shapes.iter().map(|part| self.energy(rotor, part)).sum();
        let kinetic: f64 = shapes.iter().map(|part| part.dot(&rotor.mass.times(part))).sum();
        // Mass that was added is no energy of the mode.
        let whole = if self.shift > 0.0 { elastic.min(lambda.norm_sqr() * kinetic) } else { elastic };
        let loads = parts(residual);
        let answers = loads.each_ref().map(|load| self.factors.solve(load));
        let off: f64 = loads.iter().zip(&answers).map(|(load, answer)| load.dot(answer)).sum();
        (off / whole, answers.map(|answer| answer / whole.sqrt()))
    }

    /// Adds what is new of some shapes and makes new Ritz modes; false where nothing was. Always the shape of which
    /// most is new goes next, until the energy left of each is below `least`: so the shapes remain few.
    pub(super) fn improve(
        &mut self,
        rotor: &Assembled,
        mut answers: Vec<DVector<f64>>,
        least: f64,
    ) -> Result<bool, RotorError> {
        let before = self.len();
        answers.retain(|answer| answer.iter().all(|x| x.is_finite()));
        let mut parted = 0;
        loop {
            for answer in &mut answers {
                self.part_from(parted, answer);
            }
            parted = self.len();
            let energies = answers.iter().map(|answer| self.energy(rotor, answer));
            let Some((most, energy)) = energies.enumerate().max_by(|a, b| a.1.total_cmp(&b.1)) else { break };
            if energy < least || parted == self.factors.size() {
                break;
            }
            let mut shape = answers.swap_remove(most);
            self.part_from(0, &mut shape);
            let weighted = self.stiffness_times(rotor, &shape);
            let size = shape.dot(&weighted).sqrt();
            if size > 0.0 && size.is_finite() {
                self.shapes.push(shape / size);
                self.weighted.push(weighted / size);
            }
        }
        let new = self.len() > before;
        if new {
            self.ritz(rotor)?;
        }
        Ok(new)
    }

    /// Takes the fewest shapes that hold some modes, up to a share of their energy, in place of all.
    pub(super) fn condense(
        &mut self,
        rotor: &Assembled,
        modes: &[Vec<Node>],
        share: f64,
    ) -> Result<(), RotorError> {
        let shapes = modes.iter().flat_map(|mode| {
            let parts = parts(mode);
            let whole: f64 = parts.iter().map(|part| self.energy(rotor, part)).sum();
            parts.map(|part| part / whole.sqrt())
        });
        let shapes = shapes.collect();
        self.shapes.clear();
        self.weighted.clear();
        if self.improve(rotor, shapes, share)? { Ok(()) } else { Err(RotorError::Rigid) }
    }

    /// Leaves of a shape what is new against the shapes from the `first` on.
    fn part_from(&self, first: usize, shape: &mut DVector<f64>) {
        for (other, weighted) in self.shapes.iter().zip(&self.weighted).skip(first) {
            let share = weighted.dot(shape);
            shape.axpy(-share, other, 1.0);
        }
    }

    /// The stiffness on the mean bearings, shift included, times a shape.
    fn stiffness_times(&self, rotor: &Assembled, shape: &DVector<f64>) -> DVector<f64> {
        let mut force = rotor.shaft_times(shape);
        for &(node, k) in &self.mean {
            force[2 * node] += k * shape[2 * node];
        }
        if self.shift > 0.0 {
            force.axpy(self.shift, &rotor.mass.times(shape), 1.0);
        }
        force
    }

    /// Twice the strain energy of a shape on the mean bearings.
    fn energy(&self, rotor: &Assembled, shape: &DVector<f64>) -> f64 {
        shape.dot(&self.stiffness_times(rotor, shape)).max(0.0)
    }

    /// Makes Ritz modes of the shapes; what has next to no mass has none.
    fn ritz(&mut self, rotor: &Assembled) -> Result<(), RotorError> {
        let shapes = DMatrix::from_columns(&self.shapes);
        let mass = project(&rotor.mass, &shapes);
        let scale = mass.amax();
        if !(scale > 0.0 && scale.is_finite()) {
            return Err(RotorError::Rigid);
        }
        let eigen = linalg::symmetric_eigen(&(mass / scale))?;
        let largest = eigen.values.max();
        // Largest first: the lowest frequencies.
        let order: Vec<usize> =
            (0..self.len()).rev().filter(|&n| eigen.values[n] > MASSLESS * largest).collect();
        if order.is_empty() {
            return Err(RotorError::Rigid);
        }
        self.vectors = shapes * eigen.vectors.select_columns(&order);
        orthonormal(&mut self.vectors, &rotor.mass);
        let images = self.images(|shape| self.stiffness_times(rotor, shape));
        self.frequencies =
            (0..order.len()).map(|n| self.vectors.column(n).dot(&images.column(n)).sqrt()).collect();
        self.shaft = self.vectors.tr_mul(&self.images(|shape| rotor.shaft_times(shape)));
        self.gyroscopic = project(&rotor.gyroscopic, &self.vectors);
        if rotor.internal {
            let bent = |factor: fn(&Bending) -> f64| {
                let times = |shape: &DVector<f64>| {
                    DVector::from_vec(rotor.bent(shape.as_slice(), 0.0, |of, force| factor(of) * force))
                };
                self.vectors.tr_mul(&self.images(times))
            };
            (self.viscous, self.hysteretic) = (bent(|of| of.viscous), bent(|of| of.hysteretic));
        }
        Ok(())
    }

    /// Products of a matrix with the basis vectors, one per column.
    fn images(&self, times: impl Fn(&DVector<f64>) -> DVector<f64>) -> DMatrix<f64> {
        let images: Vec<DVector<f64>> =
            self.vectors.column_iter().map(|column| times(&column.into_owned())).collect();
        DMatrix::from_columns(&images)
    }
}

/// The real shapes of a complex one: real and imaginary part in the plane of `x`, and in that of `y`.
fn parts(of: &[Node]) -> [DVector<f64>; 4] {
    let part = |plane: usize, value: fn(&Complex<f64>) -> f64| {
        DVector::from_fn(2 * of.len(), |n, _| value(&of[n / 2][2 * plane + n % 2]))
    };
    [part(0, |x| x.re), part(0, |x| x.im), part(1, |x| x.re), part(1, |x| x.im)]
}

/// A matrix of one plane in the coordinates of some shapes.
pub(super) fn project(plane: &Plane, vectors: &DMatrix<f64>) -> DMatrix<f64> {
    let columns: Vec<DVector<f64>> =
        vectors.column_iter().map(|column| plane.times(&column.into_owned())).collect();
    vectors.tr_mul(&DMatrix::from_columns(&columns))
}

/// Makes columns orthonormal in the mass, each against those before it: an eigenvector of a mode with little mass has
/// lost digits that its neighbours have.
fn orthonormal(vectors: &mut DMatrix<f64>, mass: &Plane) {
    let mut weighted: Vec<DVector<f64>> = Vec::with_capacity(vectors.ncols());
    for n in 0..vectors.ncols() {
        let mut vector = vectors.column(n).into_owned();
        for _ in 0..2 {
            for (other, weighted) in weighted.iter().enumerate() {
                let share = weighted.dot(&vector);
                vector.axpy(-share, &vectors.column(other), 1.0);
            }
            let size = vector.dot(&mass.times(&vector)).sqrt();
            vector /= size;
        }
        weighted.push(mass.times(&vector));
        vectors.set_column(n, &vector);
    }
}

/// Factors of the stiffness on the mean bearings, some mass added where that has to be: soft supports or none leave so
/// little of it that rounding would decide.
fn supported(rotor: &Assembled, mean: &[(usize, f64)]) -> Result<(f64, plane::PlaneFactors), RotorError> {
    let mut stiffness = rotor.stiffness.clone();
    for &(node, k) in mean {
        stiffness.diagonal[node][(0, 0)] += k;
    }
    if let Some(factors) = stiffness.factors(FIRM) {
        return Ok((0.0, factors));
    }
    // The square of a frequency that is low for this shaft: end stiffness over the whole mass.
    let mass: f64 = rotor.mass.diagonal.iter().map(|block| block[(0, 0)]).sum();
    let softest = rotor.stiffness.diagonal.iter().map(|block| block[(0, 0)]).fold(f64::INFINITY, f64::min);
    let mut shift = softest / mass / (rotor.nodes() as f64).powi(3);
    if !(shift > 0.0 && shift.is_finite()) {
        return Err(if mass > 0.0 { RotorError::Buckled } else { RotorError::Rigid });
    }
    let factors = loop {
        if let Some(factors) = stiffness.plus(&rotor.mass, shift).factors(FIRM) {
            break factors;
        }
        shift *= 32.0;
        if !shift.is_finite() {
            return Err(LinalgError::NotConverged.into());
        }
    };
    // Only compression takes energy out of a deflection: the shape to which the rotor yields most tells whether too much.
    if rotor.tension.is_some() {
        let mut shape = DVector::from_fn(2 * rotor.nodes(), |n, _| (1.0 + 1.7 * n as f64).sin());
        for _ in 0..60 {
            shape = factors.solve(&rotor.mass.times(&shape));
            shape /= shape.amax();
        }
        let bent = rotor.bent(shape.as_slice(), 0.0, |element, force| element.direct * force);
        let bearings: f64 = mean.iter().map(|(node, k)| k * shape[2 * node].powi(2)).sum();
        let elastic = shape.dot(&DVector::from_vec(bent)) + bearings;
        let all = shape.dot(&rotor.shaft_times(&shape)) + bearings;
        if all < -NEGATIVE * (elastic + (all - elastic).abs()) {
            return Err(RotorError::Buckled);
        }
    }
    Ok((shift, factors))
}
