//! Inertia tensors about the centre of mass in axes of any direction, and rates of change by differences: a second
//! way to what the closed formulas say.

use dalembert_numerics::differentiation::derivative;
use nalgebra::{Matrix3, Rotation3, Vector3};

/// Data that do not describe a body or a motion.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum RigidError {
    /// A direction without length, or not finite.
    #[error("the direction of the axis has no length, or is not finite; give any vector along the axis")]
    Direction,
    /// A quantity is NaN or infinite.
    #[error("a quantity of the body or of its motion is not finite")]
    NotFinite,
}

/// Inertia tensor about G of a slender rod along `direction` (any length), `m L²/12 (1 − u uᵀ)`, kg·m².
///
/// # Errors
/// [`RigidError`].
pub fn rod_tensor(mass: f64, length: f64, direction: Vector3<f64>) -> Result<Matrix3<f64>, RigidError> {
    let u = unit(direction)?;
    finite(super::rod_inertia(mass, length) * (Matrix3::identity() - u * u.transpose()))
}

/// Inertia tensor about G of a thin disc with its axis along `axis` (any length), `m r²/4 (1 + u uᵀ)`, kg·m².
///
/// # Errors
/// [`RigidError`].
pub fn disc_tensor(mass: f64, radius: f64, axis: Vector3<f64>) -> Result<Matrix3<f64>, RigidError> {
    let u = unit(axis)?;
    finite(super::disc_diametral_inertia(mass, radius) * (Matrix3::identity() + u * u.transpose()))
}

/// Tensor of a body that was turned by `rotation`, in the axes that stayed: `R I Rᵀ`.
pub fn turned(tensor: &Matrix3<f64>, rotation: &Rotation3<f64>) -> Matrix3<f64> {
    rotation.matrix() * tensor * rotation.matrix().transpose()
}

/// Rate of change at `t = 0` of a vector that is known at every time, by central differences of eighth order.
///
/// `period` is the time in s over which the vector changes noticeably, such as `2π/ω`; the steps are 1/100 of it.
/// For a vector that turns with that period the result is good to about twelve digits.
///
/// # Errors
/// [`RigidError::NotFinite`] also when the period is not positive.
pub fn numerical_rate(vector: impl Fn(f64) -> Vector3<f64>, period: f64) -> Result<Vector3<f64>, RigidError> {
    if !(period.is_finite() && period > 0.0) {
        return Err(RigidError::NotFinite);
    }
    let rate = derivative(vector, 0.0, period / 100.0);
    if rate.iter().all(|x| x.is_finite()) { Ok(rate) } else { Err(RigidError::NotFinite) }
}

/// A vector of any length and size, made a unit vector.
pub(super) fn unit(direction: Vector3<f64>) -> Result<Vector3<f64>, RigidError> {
    // Scaled first, so that the square of a component neither overflows nor vanishes.
    let largest = direction.amax();
    if direction.iter().all(|x| x.is_finite()) && largest > 0.0 {
        Ok((direction / largest).normalize())
    } else {
        Err(RigidError::Direction)
    }
}

fn finite(tensor: Matrix3<f64>) -> Result<Matrix3<f64>, RigidError> {
    if tensor.iter().all(|x| x.is_finite()) { Ok(tensor) } else { Err(RigidError::NotFinite) }
}
