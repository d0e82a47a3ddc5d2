//! A few shapes of one plane that hold the lowest modes of a rotor at any speed.
//!
//! The first shapes are the answers of the shaft on its mean bearings to the loads that rotation and the bearings can
//! put on it; the Ritz modes in their space are the coordinates. How much a mode is still off is told by its residual
//! in the full equations, and where that is too much the shapes that would take the residual away are added: some
//! rounds of them make ten digits. With all shapes the space is the full model.

use nalgebra::{Complex, DMatrix, DVector};

use super::{Assembled, Plane, RotorError, plane, stiffness::Node};
use crate::linalg;

/// The plane of `x` or `y`, and the real or the imaginary part.
type Part = (usize, fn(&Complex<f64>) -> f64);

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
    /// The shapes before they became Ritz modes.
    shapes: Vec<DVector<f64>>,
    /// The mass times each of them.
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
        basis.add(rotor, &loads);
        basis.ritz(rotor)?;
        Ok(basis)
    }

    /// The number of shapes.
    pub(super) fn len(&self) -> usize {
        self.shapes.len()
    }

    /// Adds the answers to loads, as far as they are new.
    fn add(&mut self, rotor: &Assembled, loads: &[DVector<f64>]) {
        for load in loads {
            let shape = self.factors.solve(load);
            let size = norm(&shape, &rotor.mass.times(&shape));
            if size > 0.0 && size.is_finite() {
                self.take(rotor, shape / size, 1e-7);
            }
        }
    }

    /// Takes what is new of a shape, if it is no smaller than that.
    fn take(&mut self, rotor: &Assembled, mut shape: DVector<f64>, least: f64) {
        for _ in 0..2 {
            for (other, weighted) in self.shapes.iter().zip(&self.weighted) {
                let share = weighted.dot(&shape);
                shape.axpy(-share, other, 1.0);
            }
        }
        let weighted = rotor.mass.times(&shape);
        let left = norm(&shape, &weighted);
        if left > least {
            self.shapes.push(shape / left);
            self.weighted.push(weighted / left);
        }
    }

    /// Makes Ritz modes of the shapes.
    fn ritz(&mut self, rotor: &Assembled) -> Result<(), RotorError> {
        if self.shapes.is_empty() {
            return Err(RotorError::Rigid);
        }
        let shapes = DMatrix::from_columns(&self.shapes);
        let stiffness = project(&self.stiffness, &shapes);
        let scale = stiffness.amax();
        let eigen = linalg::symmetric_eigen(&(stiffness / scale))?;
        self.vectors = shapes * eigen.vectors;
        self.frequencies = eigen.values.iter().map(|value| (value.max(0.0) * scale).sqrt()).collect();
        self.gyroscopic = project(&rotor.gyroscopic, &self.vectors);
        if rotor.internal {
            self.viscous = project(&rotor.viscous, &self.vectors);
            self.hysteretic = project(&rotor.hysteretic, &self.vectors);
        }
        Ok(())
    }

    /// The share by which the square of a natural frequency is still off, from the residual of its mode (of unit
    /// mass) in the full equations; and the shapes that would take the residual away.
    pub(super) fn error(&self, shape: &[Node], residual: &[Node]) -> (f64, [DVector<f64>; 4]) {
        let part = |from: &[Node], plane: usize, of: fn(&Complex<f64>) -> f64| {
            DVector::from_fn(2 * from.len(), |n, _| of(&from[n / 2][2 * plane + n % 2]))
        };
        let parts: [Part; 4] = [(0, |x| x.re), (0, |x| x.im), (1, |x| x.re), (1, |x| x.im)];
        let loads = parts.map(|(plane, of)| part(residual, plane, of));
        let answers = loads.each_ref().map(|load| self.factors.solve(load));
        let off: f64 = loads.iter().zip(&answers).map(|(load, answer)| load.dot(answer)).sum();
        let whole: f64 = parts
            .iter()
            .map(|&(plane, of)| {
                let shape = part(shape, plane, of);
                shape.dot(&self.stiffness.times(&shape))
            })
            .sum();
        (off / whole, answers)
    }

    /// Adds shapes and makes new Ritz modes; false where nothing was new. Parts of them whose square is far below
    /// the share that matters are left out.
    pub(super) fn improve(
        &mut self,
        rotor: &Assembled,
        mut answers: Vec<DVector<f64>>,
        share: f64,
    ) -> Result<bool, RotorError> {
        let before = self.len();
        let size = |shape: &DVector<f64>| norm(shape, &rotor.mass.times(shape));
        answers.sort_by(|a, b| size(b).total_cmp(&size(a)));
        for answer in answers {
            if answer.iter().all(|x| x.is_finite()) {
                self.take(rotor, answer, 0.1 * share.sqrt());
            }
        }
        if self.len() == before {
            return Ok(false);
        }
        self.ritz(rotor)?;
        Ok(true)
    }
}

fn norm(shape: &DVector<f64>, weighted: &DVector<f64>) -> f64 {
    shape.dot(weighted).max(0.0).sqrt()
}

fn project(plane: &Plane, vectors: &DMatrix<f64>) -> DMatrix<f64> {
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
