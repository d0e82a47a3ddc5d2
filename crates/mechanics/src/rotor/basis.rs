//! A few shapes of one plane that hold the lowest modes of a rotor at any speed.
//!
//! The first shapes are the answers of the shaft on its mean bearings to the loads that rotation and the bearings can
//! put on it; the Ritz modes in their space are the coordinates. How much a mode is still off is told by its residual
//! in the full equations, and where that is too much the shapes that would take the residual away are added: some
//! rounds of them make ten digits. With all shapes the space is the full model. Since the modes of many speeds share
//! their shapes, the fewest shapes that hold them all are taken in the end: an eigenproblem costs their number cubed.
//!
//! Shapes are measured by their strain energy, in whose share a natural frequency errs.

use nalgebra::{Complex, DMatrix, DVector};

use super::{Assembled, Plane, RotorError, plane, stiffness::Node};
use crate::linalg;

/// Below this share of the largest modal mass of shapes of unit energy a shape counts as massless: its frequency
/// would be millions of times the lowest.
const MASSLESS: f64 = 1e-14;

/// Ritz modes of one plane.
pub(super) struct Basis {
    /// Orthonormal in the mass matrix, a column each.
    pub(super) vectors: DMatrix<f64>,
    /// Natural frequencies of the Ritz modes on the mean bearings, shift included, rad/s, ascending.
    pub(super) frequencies: Vec<f64>,
    /// What was added to the stiffness as a multiple of the mass, s⁻².
    pub(super) shift: f64,
    /// The mean stiffness of each bearing that was counted, by node.
    pub(super) mean: Vec<(usize, f64)>,
    pub(super) gyroscopic: DMatrix<f64>,
    pub(super) viscous: DMatrix<f64>,
    pub(super) hysteretic: DMatrix<f64>,
    stiffness: Plane,
    factors: plane::Factors,
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
        let (stiffness, shift, factors) = supported(rotor, &mean)?;
        let mut basis = Self {
            vectors: DMatrix::zeros(0, 0),
            frequencies: Vec::new(),
            shift,
            mean,
            gyroscopic: DMatrix::zeros(0, 0),
            viscous: DMatrix::zeros(0, 0),
            hysteretic: DMatrix::zeros(0, 0),
            stiffness,
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
        let answers = answers.map(|shape| &shape / basis.energy(&shape).sqrt()).collect();
        if basis.improve(rotor, answers, 1e-14)? { Ok(basis) } else { Err(RotorError::Rigid) }
    }

    /// The number of shapes.
    pub(super) fn len(&self) -> usize {
        self.shapes.len()
    }

    /// The share by which the square of a natural frequency is still off, from the residual of its mode in the full
    /// equations; and the shapes that would take the residual away, each with its part of that share as energy.
    pub(super) fn error(&self, shape: &[Node], residual: &[Node]) -> (f64, [DVector<f64>; 4]) {
        let whole: f64 = parts(shape).iter().map(|part| self.energy(part)).sum();
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
            let energies = answers.iter().map(|answer| self.energy(answer));
            let Some((most, energy)) = energies.enumerate().max_by(|a, b| a.1.total_cmp(&b.1)) else { break };
            if energy < least || parted == self.factors.size() {
                break;
            }
            let mut shape = answers.swap_remove(most);
            self.part_from(0, &mut shape);
            let weighted = self.stiffness.times(&shape);
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
            let whole: f64 = parts.iter().map(|part| self.energy(part)).sum();
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

    /// Twice the strain energy of a shape on the mean bearings.
    fn energy(&self, shape: &DVector<f64>) -> f64 {
        shape.dot(&self.stiffness.times(shape)).max(0.0)
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
        let masses: Vec<f64> = order.iter().map(|&n| eigen.values[n] * scale).collect();
        self.vectors = shapes * eigen.vectors.select_columns(&order);
        for (mut vector, mass) in self.vectors.column_iter_mut().zip(&masses) {
            vector /= mass.sqrt();
        }
        self.frequencies = masses.iter().map(|mass| mass.sqrt().recip()).collect();
        self.gyroscopic = project(&rotor.gyroscopic, &self.vectors);
        if rotor.internal {
            self.viscous = project(&rotor.viscous, &self.vectors);
            self.hysteretic = project(&rotor.hysteretic, &self.vectors);
        }
        Ok(())
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

/// The stiffness on the mean bearings, shifted by so much mass that it is positive where the supports leave the
/// rotor free.
fn supported(rotor: &Assembled, mean: &[(usize, f64)]) -> Result<(Plane, f64, plane::Factors), RotorError> {
    let mut stiffness = rotor.stiffness.clone();
    for &(node, k) in mean {
        stiffness.diagonal[node][(0, 0)] += k;
    }
    if let Some(factors) = stiffness.factors() {
        return Ok((stiffness, 0.0, factors));
    }
    // The square of a frequency that is low for this shaft: end stiffness over the whole mass.
    let mass: f64 = rotor.mass.diagonal.iter().map(|block| block[(0, 0)]).sum();
    let softest = rotor.stiffness.diagonal.iter().map(|block| block[(0, 0)]).fold(f64::INFINITY, f64::min);
    let nodes = rotor.nodes() as f64;
    let shift = softest / mass / nodes.powi(3);
    let shifted = stiffness.plus(&rotor.mass, shift);
    match shifted.factors() {
        Some(factors) if shift > 0.0 && shift.is_finite() => Ok((shifted, shift, factors)),
        _ => Err(RotorError::Buckled),
    }
}
