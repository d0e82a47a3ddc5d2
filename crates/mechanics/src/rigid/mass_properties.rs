//! Mass, centre of mass and inertia tensor of a body: what dynamics asks of it, and all that it asks.
//!
//! The tensor is taken about the centre of mass G, in the axes of the frame in which the body is described. Its
//! diagonal holds the moments of inertia `I_x = ∫ (y² + z²) dm`, the rest the products of inertia with a minus
//! sign, `−I_xy` with `I_xy = ∫ xy dm`, so that `H_G = I ω` (Beer & Johnston, *Dynamics*, §18.1A; Riul, eq. 32).

use nalgebra::{DMatrix, Matrix3, Rotation3, Vector3};

use dalembert_numerics::linalg;

/// Moments nearer to each other than this share of the largest count as equal: their axes are then a choice.
const EQUAL: f64 = 1e-9;

/// Tolerance of the conditions on an inertia tensor, as a share of its largest moment: a thin plate meets the triangle
/// inequality exactly, a slender rod has no moment about itself.
const MISSED: f64 = 1e-9;

/// Mass (kg), centre of mass (m) and inertia tensor about the centre of mass (kg·m²) of a body, in one frame.
///
/// Also of a part that is taken away (a hole): then mass and tensor are negative.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MassProperties {
    /// Mass, kg.
    pub mass: f64,
    /// Position of the centre of mass G, m.
    pub centre: Vector3<f64>,
    /// Inertia tensor about G in the axes of the frame, kg·m²: moments of inertia on the diagonal, products of
    /// inertia with a minus sign off it.
    pub inertia: Matrix3<f64>,
}

/// Principal moments of inertia and their axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Principal {
    /// The moments in ascending order, kg·m².
    pub moments: Vector3<f64>,
    /// From principal axes to the frame: its columns are the axes, right-handed. Where moments are equal the axes
    /// lie as near to those of the frame as they can.
    pub axes: Rotation3<f64>,
}

/// Reason for which numbers are not the mass, the centre and the inertia of a body.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum BodyError {
    /// A number is NaN or infinite.
    #[error("a number of the body is not finite")]
    NotFinite,
    /// The mass is zero or negative.
    #[error("the mass is {0} kg; the holes must leave a mass that is positive")]
    Mass(f64),
    /// The tensor is not symmetric.
    #[error(
        "the inertia tensor is not symmetric; the product of inertia is the same on both sides of the diagonal"
    )]
    NotSymmetric,
    /// A moment of inertia is negative.
    #[error(
        "the moment of inertia about {axis:?} is {moment} kg·m²; no body has a negative one: check moments, products and holes"
    )]
    Negative {
        /// The axis, a unit vector.
        axis: [f64; 3],
        /// The moment about it.
        moment: f64,
    },
    /// A principal moment is larger than the sum of the other two.
    #[error(
        "the moment of inertia about {axis:?} is {moment} kg·m², more than the sum {others} of those about the other two principal axes; no body is such: check moments and products"
    )]
    Triangle {
        /// The axis, a unit vector.
        axis: [f64; 3],
        /// The moment about it.
        moment: f64,
        /// The sum of the other two.
        others: f64,
    },
    /// The body has no inertia about an axis, and its motion about that is asked for.
    #[error(
        "the body has no moment of inertia about {axis:?}: a slender rod or a particle cannot be turned about itself; give it a thickness"
    )]
    NoInertia {
        /// The axis, a unit vector.
        axis: [f64; 3],
    },
    /// A direction without length, or not finite.
    #[error("the direction of the axis has no length, or is not finite; give any vector along the axis")]
    Direction,
}

impl MassProperties {
    /// A particle.
    pub fn particle(mass: f64, at: Vector3<f64>) -> Self {
        Self { mass, centre: at, inertia: Matrix3::zeros() }
    }

    /// A body whose tensor is known about some point: `I_G = I_A − m (d² 1 − d dᵀ)`, `d` from G to A.
    pub fn from_inertia_about(
        point: Vector3<f64>,
        inertia: Matrix3<f64>,
        mass: f64,
        centre: Vector3<f64>,
    ) -> Self {
        Self { mass, centre, inertia: inertia - shift(mass, point - centre) }
    }

    /// The tensor with these moments `(I_x, I_y, I_z)` and products `(I_yz, I_zx, I_xy)`, `I_xy = ∫ xy dm`.
    pub fn tensor(moments: Vector3<f64>, products: Vector3<f64>) -> Matrix3<f64> {
        Matrix3::new(
            moments.x,
            -products.z,
            -products.y, //
            -products.z,
            moments.y,
            -products.x, //
            -products.y,
            -products.x,
            moments.z,
        )
    }

    /// The moments `(I_x, I_y, I_z)` of a tensor.
    pub fn moments(tensor: &Matrix3<f64>) -> Vector3<f64> {
        tensor.diagonal()
    }

    /// The products `(I_yz, I_zx, I_xy)` of a tensor, `I_xy = ∫ xy dm`.
    pub fn products(tensor: &Matrix3<f64>) -> Vector3<f64> {
        -Vector3::new(tensor[(1, 2)], tensor[(2, 0)], tensor[(0, 1)])
    }

    /// The whole of several parts: `m = Σ mᵢ`, `m r_G = Σ mᵢ rᵢ`, `I_G = Σ (Iᵢ + mᵢ (dᵢ² 1 − dᵢ dᵢᵀ))`, `dᵢ` from
    /// G to the centre of mass of the part. Parts with negative mass are holes.
    ///
    /// # Errors
    /// [`BodyError::Mass`] when nothing is left, [`BodyError::NotFinite`].
    pub fn composite(parts: &[MassProperties]) -> Result<Self, BodyError> {
        let mass: f64 = parts.iter().map(|part| part.mass).sum();
        let size: f64 = parts.iter().map(|part| part.mass.abs()).sum();
        // A hole as large as the body leaves rounding alone.
        if !(mass.is_finite() && mass > 1e-12 * size) {
            return Err(if mass.is_finite() { BodyError::Mass(mass) } else { BodyError::NotFinite });
        }
        let centre = parts.iter().map(|part| part.centre * (part.mass / mass)).sum::<Vector3<f64>>();
        let inertia = parts
            .iter()
            .map(|part| part.inertia + shift(part.mass, part.centre - centre))
            .sum::<Matrix3<f64>>();
        Self { mass, centre, inertia }.finite()
    }

    /// The same body as a hole: to be taken away from another.
    #[must_use]
    pub fn taken_away(&self) -> Self {
        Self { mass: -self.mass, centre: self.centre, inertia: -self.inertia }
    }

    /// The body moved without turning.
    #[must_use]
    pub fn moved(&self, by: Vector3<f64>) -> Self {
        Self { centre: self.centre + by, ..*self }
    }

    /// The body turned about the origin of the frame: `R r_G`, `R I_G Rᵀ`.
    #[must_use]
    pub fn turned(&self, rotation: &Rotation3<f64>) -> Self {
        Self {
            mass: self.mass,
            centre: rotation * self.centre,
            inertia: super::turned(&self.inertia, rotation),
        }
    }

    /// Inertia tensor about a point A, kg·m²: `I_A = I_G + m (d² 1 − d dᵀ)`, `d` from G to A (parallel axes).
    pub fn inertia_about(&self, point: Vector3<f64>) -> Matrix3<f64> {
        self.inertia + shift(self.mass, point - self.centre)
    }

    /// Moment of inertia about the line through a point along a direction of any length, kg·m²:
    /// `I = λ · I_A λ` (Beer & Johnston, *Statics*, §9.6A).
    ///
    /// # Errors
    /// [`BodyError::Direction`].
    pub fn inertia_about_line(&self, point: Vector3<f64>, direction: Vector3<f64>) -> Result<f64, BodyError> {
        let along = super::tensor::unit(direction).map_err(|_| BodyError::Direction)?;
        Ok(along.dot(&(self.inertia_about(point) * along)))
    }

    /// Radii of gyration about the axes through G, m: `k_x = √(I_x/m)`.
    pub fn radii_of_gyration(&self) -> Vector3<f64> {
        self.inertia.diagonal().map(|moment| (moment / self.mass).max(0.0).sqrt())
    }

    /// Principal moments and axes at G.
    ///
    /// # Errors
    /// [`BodyError::NotFinite`], [`BodyError::NotSymmetric`].
    pub fn principal(&self) -> Result<Principal, BodyError> {
        Principal::of(&self.inertia)
    }

    /// Holds the numbers against what a body can be: positive mass, no negative moment of inertia about any axis,
    /// no principal moment above the sum of the other two. Rods, plates and particles pass.
    ///
    /// # Errors
    /// [`BodyError`], which names the axis.
    pub fn check(&self) -> Result<Principal, BodyError> {
        self.finite()?;
        if self.mass <= 0.0 {
            return Err(BodyError::Mass(self.mass));
        }
        let principal = self.principal()?;
        principal.check()?;
        Ok(principal)
    }

    /// As [`check`](Self::check), and a moment of inertia about every axis: what is asked of a body that couples
    /// are to turn in any direction.
    ///
    /// # Errors
    /// [`BodyError`], which names the axis.
    pub fn check_turnable(&self) -> Result<Principal, BodyError> {
        let principal = self.check()?;
        if principal.moments.x <= MISSED * principal.moments.z {
            return Err(BodyError::NoInertia { axis: principal.axis(0).into() });
        }
        Ok(principal)
    }

    fn finite(self) -> Result<Self, BodyError> {
        let finite = self.mass.is_finite() && self.centre.iter().chain(&self.inertia).all(|x| x.is_finite());
        if finite { Ok(self) } else { Err(BodyError::NotFinite) }
    }
}

impl Principal {
    /// Principal moments and axes of a tensor.
    ///
    /// # Errors
    /// [`BodyError::NotFinite`], [`BodyError::NotSymmetric`].
    pub fn of(tensor: &Matrix3<f64>) -> Result<Self, BodyError> {
        let eigen = linalg::symmetric_eigen(&DMatrix::from_column_slice(3, 3, tensor.as_slice())).map_err(
            |error| match error {
                linalg::LinalgError::NotSymmetric { .. } => BodyError::NotSymmetric,
                _ => BodyError::NotFinite,
            },
        )?;
        let largest = eigen.values.amax();
        // What is left of terms that cancel.
        let moment = |n: usize| {
            let moment: f64 = eigen.values[n];
            if moment.abs() > 8.0 * f64::EPSILON * largest { moment } else { 0.0 }
        };
        let moments = Vector3::new(moment(0), moment(1), moment(2));
        let found = |n: usize| Vector3::from_iterator(eigen.vectors.column(n).iter().copied());
        let equal = |a: usize, b: usize| moments[b] - moments[a] <= EQUAL * largest;
        let [first, second, third] = match (equal(0, 1), equal(1, 2)) {
            (true, true) => [Vector3::x(), Vector3::y(), Vector3::z()],
            (true, false) => {
                let alone = pointing(found(2));
                let beside = beside(alone);
                [beside, alone.cross(&beside), alone]
            }
            (false, true) => {
                let alone = pointing(found(0));
                let beside = beside(alone);
                [alone, beside, alone.cross(&beside)]
            }
            (false, false) => {
                let (first, second) = (pointing(found(0)), pointing(found(1)));
                [first, second, first.cross(&second)]
            }
        };
        let axes = Rotation3::from_matrix_unchecked(Matrix3::from_columns(&[first, second, third]));
        Ok(Self { moments, axes })
    }

    /// The axis of a moment, a unit vector; counted from 0.
    pub fn axis(&self, n: usize) -> Vector3<f64> {
        self.axes.matrix().column(n).into()
    }

    /// The angular velocity that goes with an angular momentum, `I⁻¹ H = Σ (u · H)/I_u u`, rad/s. About an axis without
    /// moment of inertia only a body without momentum there turns, and it is taken not to.
    ///
    /// # Errors
    /// [`BodyError::NoInertia`], [`BodyError::NotFinite`].
    pub fn angular_velocity(&self, momentum: Vector3<f64>) -> Result<Vector3<f64>, BodyError> {
        let mut omega = Vector3::zeros();
        for n in 0..3 {
            let (axis, moment) = (self.axis(n), self.moments[n]);
            let along = axis.dot(&momentum);
            if moment > MISSED * self.moments.amax() {
                omega += axis * (along / moment);
            } else if along.abs() > MISSED * momentum.norm() {
                return Err(BodyError::NoInertia { axis: axis.into() });
            }
        }
        if omega.iter().all(|x| x.is_finite()) { Ok(omega) } else { Err(BodyError::NotFinite) }
    }

    /// Index of the axis of dynamic symmetry: that of the third moment where two principal moments are equal. `None`
    /// also when all three are equal.
    pub fn symmetry_axis(&self) -> Option<usize> {
        let equal = |a: usize, b: usize| self.moments[b] - self.moments[a] <= EQUAL * self.moments.amax();
        match (equal(0, 1), equal(1, 2)) {
            (true, false) => Some(2),
            (false, true) => Some(0),
            _ => None,
        }
    }

    /// Holds the moments against what a body can have.
    ///
    /// # Errors
    /// [`BodyError::Negative`], [`BodyError::Triangle`].
    pub fn check(&self) -> Result<(), BodyError> {
        let largest = self.moments.amax();
        if self.moments.x < -MISSED * largest {
            return Err(BodyError::Negative { axis: self.axis(0).into(), moment: self.moments.x });
        }
        let others = self.moments.x + self.moments.y;
        if self.moments.z - others > MISSED * largest {
            return Err(BodyError::Triangle { axis: self.axis(2).into(), moment: self.moments.z, others });
        }
        Ok(())
    }
}

/// Parallel-axis term of a mass at a distance `d`: `m (d² 1 − d dᵀ)`.
fn shift(mass: f64, d: Vector3<f64>) -> Matrix3<f64> {
    (Matrix3::from_diagonal_element(d.norm_squared()) - d * d.transpose()) * mass
}

/// Of the two directions of an axis the one whose first component that is not rounding is positive.
fn pointing(axis: Vector3<f64>) -> Vector3<f64> {
    let clean = axis.map(|x| if x.abs() > 1e-15 { x } else { 0.0 });
    match clean.iter().find(|x| x.abs() > 1e-6) {
        Some(x) if *x < 0.0 => -clean,
        _ => clean,
    }
    .normalize()
}

/// A unit vector normal to an axis, in the plane of the axis and the axis of the frame that is farthest from it.
fn beside(axis: Vector3<f64>) -> Vector3<f64> {
    let nearest = axis.abs().min();
    let far = (0..3).find(|&n| axis[n].abs() <= nearest + 1e-6).expect("one of three is the least");
    let mut along = Vector3::zeros();
    along[far] = 1.0;
    (along - axis * axis[far]).normalize()
}
