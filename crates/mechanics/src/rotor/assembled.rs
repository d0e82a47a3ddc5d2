//! The matrices of a whole rotor.

use std::ops::{Add, AddAssign, Mul, Sub, SubAssign};

use nalgebra::{DVector, Matrix2};

use super::{BearingSupport, Coefficients, Plane, Rotor, RotorError, SupportType, element};

/// An element by its deformations: an assembled matrix has lost the small difference between a rigid motion and a
/// slight bend, soft supports under a fine mesh leave nothing else.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Bending {
    length: f64,
    /// On deflection and slope of one end against the other, [`element::deformations`].
    matrix: Matrix2<f64>,
    /// Factors of the matrix in the stiffness, in `Hᵥ` and in `Hₕ`.
    pub(super) direct: f64,
    pub(super) viscous: f64,
    pub(super) hysteretic: f64,
}

/// The matrices of a rotor in one plane, and its supports.
#[derive(Debug, Clone, PartialEq)]
pub struct Assembled {
    /// Mass of shaft and discs.
    pub mass: Plane,
    /// Polar inertia of shaft and discs: `Ω G` couples the planes.
    pub gyroscopic: Plane,
    /// Stiffness of the shaft, its tension included, without bearings.
    pub stiffness: Plane,
    /// Internal viscous damping `Hᵥ`; `Ω Hᵥ` is circulatory too.
    pub viscous: Plane,
    /// Circulatory matrix `Hₕ` of internal hysteretic damping.
    pub hysteretic: Plane,
    /// The bending of every element.
    pub(super) bending: Vec<Bending>,
    /// Stiffness of the tension alone, if there is one.
    pub(super) tension: Option<Plane>,
    /// Supports of the shaft.
    pub supports: Vec<BearingSupport>,
    /// Degrees of freedom of a plane that do not move.
    pub fixed: Vec<usize>,
    /// Nodes that carry a disc.
    pub(super) discs: Vec<usize>,
    /// Distances of the nodes from the left end, m.
    pub positions: Vec<f64>,
    /// True if there is a matrix of internal damping.
    pub(super) internal: bool,
}

impl Assembled {
    /// Adds up elements, discs and supports.
    ///
    /// # Errors
    /// `Value` and `Node`.
    pub fn new(rotor: &Rotor) -> Result<Self, RotorError> {
        let nodes = rotor.nodes();
        if rotor.elements.is_empty() {
            return Err(RotorError::Value { what: "the number of elements", value: 0.0 });
        }
        let at = |node: usize| {
            if node < nodes { Ok(node) } else { Err(RotorError::Node { node, last: nodes - 1 }) }
        };
        let zeros = Plane::zeros(nodes);
        let mut all = Self {
            mass: zeros.clone(),
            gyroscopic: zeros.clone(),
            stiffness: zeros.clone(),
            viscous: zeros.clone(),
            hysteretic: zeros.clone(),
            bending: Vec::with_capacity(rotor.elements.len()),
            tension: (rotor.tension != 0.0).then_some(zeros),
            supports: rotor.supports.clone(),
            fixed: Vec::new(),
            discs: rotor.discs.iter().map(|disc| disc.node).collect(),
            positions: rotor.positions(),
            internal: false,
        };
        for (n, element) in rotor.elements.iter().enumerate() {
            let matrices = element::matrices(element, rotor.theory)?;
            let (viscous, loss) = (element.material.viscous_damping, element.material.loss_factor);
            let phase = loss.hypot(1.0);
            all.mass.add(n, &matrices.mass, 1.0);
            all.gyroscopic.add(n, &matrices.gyroscopic, 1.0);
            all.stiffness.add(n, &matrices.elastic, (1.0 + loss) / phase);
            all.stiffness.add(n, &matrices.geometric, rotor.tension);
            if let Some(tension) = &mut all.tension {
                tension.add(n, &matrices.geometric, rotor.tension);
            }
            all.bending.push(Bending {
                length: element.length,
                matrix: matrices.bending,
                direct: (1.0 + loss) / phase,
                viscous,
                hysteretic: loss / phase,
            });
            all.viscous.add(n, &matrices.elastic, viscous);
            all.hysteretic.add(n, &matrices.elastic, loss / phase);
            all.internal |= viscous != 0.0 || loss != 0.0;
        }
        for disc in &rotor.discs {
            let block = at(disc.node)?;
            all.mass.diagonal[block][(0, 0)] += disc.mass;
            all.mass.diagonal[block][(1, 1)] += disc.diametral;
            all.gyroscopic.diagonal[block][(1, 1)] += disc.polar;
        }
        for support in &rotor.supports {
            let node = at(support.node)?;
            match support.hold {
                SupportType::Bearing(_) => {}
                SupportType::Pinned => all.fixed.push(2 * node),
                SupportType::Clamped => all.fixed.extend([2 * node, 2 * node + 1]),
            }
        }
        all.fixed.sort_unstable();
        all.fixed.dedup();
        for &freedom in &all.fixed {
            let own = all.stiffness.diagonal[freedom / 2][(freedom % 2, freedom % 2)];
            all.stiffness.fix(freedom, own);
            let planes = [&mut all.mass, &mut all.gyroscopic, &mut all.viscous, &mut all.hysteretic];
            for plane in planes.into_iter().chain(&mut all.tension) {
                plane.fix(freedom, 0.0);
            }
        }
        let wild = [&all.mass, &all.stiffness, &all.viscous, &all.hysteretic]
            .into_iter()
            .flat_map(|plane| plane.diagonal.iter().flatten())
            .copied()
            .find(|x| !x.is_finite());
        match wild {
            Some(value) => Err(RotorError::Value { what: "a matrix of the rotor", value }),
            None => Ok(all),
        }
    }

    /// The number of nodes.
    pub fn nodes(&self) -> usize {
        self.positions.len()
    }

    /// The bearings that can move, with their coefficients at a speed.
    pub(super) fn bearings(&self, speed: f64) -> impl Iterator<Item = (usize, Coefficients)> {
        self.supports.iter().filter_map(move |support| {
            let free = !self.fixed.contains(&(2 * support.node));
            support.at(speed).filter(|_| free).map(|here| (support.node, here))
        })
    }

    /// The forces of bent elements on the degrees of freedom of a plane, each element with a factor of its own.
    pub(super) fn bent<T>(&self, x: &[T], zero: T, factor: impl Fn(&Bending, T) -> T) -> Vec<T>
    where
        T: Copy + AddAssign + SubAssign + Add<Output = T> + Sub<Output = T> + Mul<f64, Output = T>,
    {
        let mut force = vec![zero; x.len()];
        for (n, element) in self.bending.iter().enumerate() {
            let [left, tilt, right, tilt_right] = [x[2 * n], x[2 * n + 1], x[2 * n + 2], x[2 * n + 3]];
            let half = element.length / 2.0;
            let deflection = (right - left) - (tilt + tilt_right) * half;
            let slope = tilt_right - tilt;
            let matrix = &element.matrix;
            let shear = factor(element, deflection * matrix[(0, 0)] + slope * matrix[(0, 1)]);
            let moment = factor(element, deflection * matrix[(1, 0)] + slope * matrix[(1, 1)]);
            force[2 * n] -= shear;
            force[2 * n + 1] -= shear * half + moment;
            force[2 * n + 2] += shear;
            force[2 * n + 3] += moment - shear * half;
        }
        for &freedom in &self.fixed {
            force[freedom] = zero;
        }
        force
    }

    /// The stiffness of the shaft, its tension included, times a shape that leaves fixed degrees of freedom at rest.
    pub(super) fn shaft_times(&self, x: &DVector<f64>) -> DVector<f64> {
        let mut force = self.bent(x.as_slice(), 0.0, |element, force| element.direct * force);
        if let Some(tension) = &self.tension {
            for (force, more) in force.iter_mut().zip(tension.product(x.as_slice(), 0.0)) {
                *force += more;
            }
        }
        DVector::from_vec(force)
    }

    /// Returns true if the supports, with their direct stiffnesses alone, leave the shaft a rigid-body motion.
    pub(super) fn is_free(&self, mean: &[(usize, f64)]) -> bool {
        let clamped = self.fixed.iter().any(|freedom| freedom % 2 == 1);
        let pinned = self.fixed.iter().map(|freedom| freedom / 2);
        let mut held: Vec<usize> =
            mean.iter().filter(|(_, k)| *k > 0.0).map(|(node, _)| *node).chain(pinned).collect();
        held.sort_unstable();
        held.dedup();
        !clamped && (held.is_empty() || (held.len() == 1 && self.tension.is_none()))
    }
}
