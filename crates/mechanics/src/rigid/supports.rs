//! Reactions of the supports of one rigid body, from the six equations of d'Alembert.
//!
//! Each support is so many unknown forces and couples of known direction; whether the six equations tell them is
//! settled by count and by rank, not by the names of the supports.

use nalgebra::{DMatrix, Vector3};

use super::{Axis, RigidError};
use dalembert_numerics::linalg::Elimination;

/// A force and the moment of a system of forces about the origin of the axes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Wrench {
    /// Sum of the forces, N.
    pub force: Vector3<f64>,
    /// Moment about the origin, N·m.
    pub moment: Vector3<f64>,
}

/// One unknown of the supports.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ReactionUnknown {
    /// A force along a direction.
    Force {
        /// The point that it acts on, m.
        at: Vector3<f64>,
        /// The direction in which it is positive; the unknown is in N when it has unit length.
        along: Vector3<f64>,
    },
    /// A couple about a direction, N·m.
    Couple {
        /// The direction about which it is positive.
        about: Vector3<f64>,
    },
}

/// Reason for which the six equations do not determine the reactions.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum SupportError {
    /// Some unknowns balance among themselves: only the stiffness of body and supports tells how they share a load.
    #[error(
        "the supports are statically indeterminate: {} of the unknowns can balance among themselves", .unknowns.len()
    )]
    Indeterminate {
        /// Number of missing equations.
        missing: usize,
        /// The unknowns that take part, counted from 0.
        unknowns: Vec<usize>,
    },
    /// The supports leave a motion free, and the body would take it up.
    #[error("the supports leave the body free to {} {axis:?}", if *.turning { "turn about" } else { "move along" })]
    Mechanism {
        /// True if the free motion is a rotation, false if it is a translation.
        turning: bool,
        /// The axis nearest to the motion.
        axis: Axis,
    },
    /// A number is not finite, or a direction has no length.
    #[error(transparent)]
    Data(#[from] RigidError),
}

/// The unknowns of one body with its supports, ready for any load.
#[derive(Debug, Clone)]
pub struct Supports {
    unknowns: Vec<ReactionUnknown>,
    /// A length of the problem, which brings moments to the size of forces.
    length: f64,
    matrix: Elimination,
    /// Motions that no unknown works in, orthonormal: translation, and rotation times `length`.
    free: Vec<[f64; 6]>,
}

impl Wrench {
    /// No force and no moment.
    pub fn zero() -> Self {
        Self { force: Vector3::zeros(), moment: Vector3::zeros() }
    }

    /// A force at a point.
    pub fn force_at(force: Vector3<f64>, at: Vector3<f64>) -> Self {
        Self { force, moment: at.cross(&force) }
    }

    /// A couple.
    pub fn couple(moment: Vector3<f64>) -> Self {
        Self { force: Vector3::zeros(), moment }
    }

    /// The moment about another point, `M_A = M_O − r_A × F`, N·m.
    pub fn moment_about(&self, point: Vector3<f64>) -> Vector3<f64> {
        self.moment - point.cross(&self.force)
    }
}

impl std::ops::Add for Wrench {
    type Output = Wrench;
    fn add(self, other: Wrench) -> Wrench {
        Wrench { force: self.force + other.force, moment: self.moment + other.moment }
    }
}

impl std::ops::Neg for Wrench {
    type Output = Wrench;
    fn neg(self) -> Wrench {
        Wrench { force: -self.force, moment: -self.moment }
    }
}

impl ReactionUnknown {
    /// Wrench of a unit value of this unknown.
    pub fn wrench(&self) -> Wrench {
        match *self {
            ReactionUnknown::Force { at, along } => Wrench::force_at(along, at),
            ReactionUnknown::Couple { about } => Wrench::couple(about),
        }
    }
}

impl Supports {
    /// Counts the unknowns against the six equations.
    ///
    /// # Errors
    /// [`SupportError::Indeterminate`] when unknowns balance among themselves; [`SupportError::Data`].
    pub fn new(unknowns: Vec<ReactionUnknown>) -> Result<Self, SupportError> {
        let finite = |of: Wrench| of.force.iter().chain(of.moment.iter()).all(|x| x.is_finite());
        if !unknowns.iter().all(|unknown| finite(unknown.wrench())) {
            return Err(RigidError::NotFinite.into());
        }
        let length = unknowns.iter().fold(0.0f64, |length, unknown| match unknown {
            ReactionUnknown::Force { at, .. } => length.max(at.amax()),
            ReactionUnknown::Couple { .. } => length,
        });
        let length = if length > 0.0 { length } else { 1.0 };
        let columns: Vec<[f64; 6]> = unknowns.iter().map(|unknown| column(unknown, length)).collect();
        let entries = DMatrix::from_fn(6, columns.len(), |row, place| columns[place][row]);
        let matrix = Elimination::new(&entries).map_err(|_| RigidError::NotFinite)?;
        let missing = columns.len() - matrix.rank();
        if missing > 0 {
            let balancing = matrix.null_space().map_err(|_| RigidError::NotFinite)?;
            let takes_part = |place: &usize| balancing.iter().any(|x| x[*place].abs() > 1e-9);
            let unknowns = (0..columns.len()).filter(takes_part).collect();
            return Err(SupportError::Indeterminate { missing, unknowns });
        }
        let motions = Elimination::new(&entries.transpose()).map_err(|_| RigidError::NotFinite)?;
        let free = orthonormal(&motions.null_space().map_err(|_| RigidError::NotFinite)?);
        Ok(Self { unknowns, length, matrix, free })
    }

    /// The unknowns that balance `load`: their sum and the load together are zero. N, or N·m for couples.
    ///
    /// # Errors
    /// [`SupportError::Mechanism`] when no reaction does, because the supports leave a motion free in which the load
    /// works; [`SupportError::Data`].
    pub fn reactions(&self, load: &Wrench) -> Result<Vec<f64>, SupportError> {
        let right = components(&-*load, self.length);
        let size = right.iter().fold(0.0f64, |size, x| size.max(x.abs()));
        let mut unbalanced = [0.0; 6];
        for motion in &self.free {
            let part: f64 = motion.iter().zip(&right).map(|(a, b)| a * b).sum();
            unbalanced.iter_mut().zip(motion).for_each(|(sum, along)| *sum += part * along);
        }
        let (worst, most) = unbalanced.iter().enumerate().fold((0, 0.0f64), |(at, most), (place, x)| {
            if x.abs() > most { (place, x.abs()) } else { (at, most) }
        });
        if most > UNBALANCED * size {
            let axis = [Axis::X, Axis::Y, Axis::Z][worst % 3];
            return Err(SupportError::Mechanism { turning: worst >= 3, axis });
        }
        let x = self.matrix.solve(&right).map_err(|_| RigidError::NotFinite)?;
        let of_couple = |x: f64, unknown: &ReactionUnknown| match unknown {
            ReactionUnknown::Couple { .. } => x * self.length,
            ReactionUnknown::Force { .. } => x,
        };
        let x: Vec<f64> = x.iter().zip(&self.unknowns).map(|(x, of)| of_couple(*x, of)).collect();
        if x.iter().all(|x| x.is_finite()) { Ok(x) } else { Err(RigidError::NotFinite.into()) }
    }

    /// The unknowns, in the order of the reactions.
    pub fn unknowns(&self) -> &[ReactionUnknown] {
        &self.unknowns
    }

    /// Number of degrees of freedom that the supports leave; loads without power in any of them are balanced all the
    /// same.
    pub fn degrees_of_freedom(&self) -> usize {
        self.free.len()
    }

    /// Returns true if the supports alone can balance a couple about `axis`.
    pub fn hold_against(&self, axis: Vector3<f64>) -> bool {
        let couple = components(&Wrench::couple(axis), 1.0);
        let along = |motion: &[f64; 6]| motion.iter().zip(&couple).map(|(a, b)| a * b).sum::<f64>();
        self.free.iter().all(|motion| along(motion).abs() <= 1e-9 * axis.norm())
    }
}

/// A load whose part in the free motions is below this share of it counts as balanced.
const UNBALANCED: f64 = 1e-9;

/// The six components, with moments over `length`.
fn components(wrench: &Wrench, length: f64) -> [f64; 6] {
    let (f, m) = (wrench.force, wrench.moment / length);
    [f.x, f.y, f.z, m.x, m.y, m.z]
}

/// Column of an unknown in the six equilibrium equations; couples are divided by that length. What is rounding beside
/// the rest is taken as zero, or it would count as an equation of its own.
fn column(unknown: &ReactionUnknown, length: f64) -> [f64; 6] {
    let arm = if matches!(unknown, ReactionUnknown::Couple { .. }) { length } else { 1.0 };
    let column = components(&unknown.wrench(), length).map(|x| x * arm);
    let largest = column.iter().fold(0.0f64, |most, x| most.max(x.abs()));
    column.map(|x| if x.abs() > 1e-13 * largest { x } else { 0.0 })
}

/// Gram and Schmidt, twice for the digits.
fn orthonormal(vectors: &[Vec<f64>]) -> Vec<[f64; 6]> {
    let mut basis: Vec<[f64; 6]> = Vec::new();
    for vector in vectors {
        let mut next: [f64; 6] = std::array::from_fn(|place| vector[place]);
        for _ in 0..2 {
            for known in &basis {
                let part: f64 = known.iter().zip(&next).map(|(a, b)| a * b).sum();
                next.iter_mut().zip(known).for_each(|(x, along)| *x -= part * along);
            }
            let size = next.iter().map(|x| x * x).sum::<f64>().sqrt();
            next = next.map(|x| x / size);
        }
        basis.push(next);
    }
    basis
}
