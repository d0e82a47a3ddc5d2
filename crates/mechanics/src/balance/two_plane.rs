//! Two-plane balancing as one linear system, with its condition and its residuals.

use nalgebra::{DMatrix, DVector};

use super::{magnitude, moment, resultant};
use dalembert_numerics::linalg::{self, LinalgError};

/// An unbalance in a plane across the shaft.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PlaneUnbalance {
    /// Position of the plane along the shaft, m, from any origin.
    pub position: f64,
    /// Components `m r cos θ` and `m r sin θ`, kg·m.
    pub components: [f64; 2],
}

/// The corrections that balance a rotor, and how well they do it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TwoPlaneBalance {
    /// Components of the correction in plane A, kg·m.
    pub in_a: [f64; 2],
    /// Components of the correction in plane B, kg·m.
    pub in_b: [f64; 2],
    /// Condition number of the equations, 1 for planes at the ends of the rotor; it grows as the planes approach
    /// each other within the length of the rotor.
    pub condition: f64,
    /// Unbalance that remains, `|Σ U|`, kg·m.
    pub residual: f64,
    /// Moment of the unbalance that remains about the middle of the rotor, `|Σ U (z − z₀)|`, kg·m².
    pub residual_moment: f64,
}

/// Reason for which no correction masses are found.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum BalanceError {
    /// Both correction planes are at the same position, as far as the numbers can tell.
    #[error("the correction planes at {a} and {b} coincide; no couple can be balanced from one plane")]
    CoincidentPlanes {
        /// Position of plane A, m.
        a: f64,
        /// Position of plane B, m.
        b: f64,
    },
    /// A position or an unbalance is NaN, infinite or beyond the range of numbers.
    #[error("a position or an unbalance is not finite")]
    NotFinite,
}

/// Corrections in two planes A and B from the equations of force and moment,
/// `U_A + U_B = −Σ Uᵢ`, `z_A U_A + z_B U_B = −Σ zᵢ Uᵢ`.
///
/// Positions are counted from the middle of the rotor in units of its half length, so that neither the origin nor
/// the unit matters to the condition.
///
/// # Errors
/// [`BalanceError`].
pub fn balance_two_planes(
    unbalances: &[PlaneUnbalance],
    [a, b]: [f64; 2],
) -> Result<TwoPlaneBalance, BalanceError> {
    let positions = || unbalances.iter().map(|u| u.position).chain([a, b]);
    let lowest = positions().fold(f64::INFINITY, f64::min);
    let highest = positions().fold(f64::NEG_INFINITY, f64::max);
    let half_length = highest / 2.0 - lowest / 2.0;
    let middle = lowest + half_length;
    if !positions().all(f64::is_finite) {
        return Err(BalanceError::NotFinite);
    }
    if half_length == 0.0 {
        return Err(BalanceError::CoincidentPlanes { a, b });
    }
    let place = |z: f64| (z - middle) / half_length;

    let matrix = DMatrix::from_row_slice(2, 2, &[1.0, 1.0, place(a), place(b)]);
    let corrections = |axis: usize| {
        let force = resultant(unbalances.iter().map(|u| u.components[axis]));
        let couple = moment(unbalances.iter().map(|u| (u.components[axis], place(u.position))), 0.0);
        linalg::solve(&matrix, &DVector::from_vec(vec![-force, -couple])).map_err(|error| match error {
            LinalgError::Singular { .. } => BalanceError::CoincidentPlanes { a, b },
            _ => BalanceError::NotFinite,
        })
    };
    let (x, y) = (corrections(0)?, corrections(1)?);
    let (in_a, in_b) = ([x.x[0], y.x[0]], [x.x[1], y.x[1]]);

    let all = || {
        let added = [(a, in_a), (b, in_b)];
        unbalances.iter().map(|u| (u.position, u.components)).chain(added)
    };
    let left = |axis: usize| resultant(all().map(|(_, u)| u[axis]));
    let left_moment = |axis: usize| moment(all().map(|(z, u)| (u[axis], z)), middle);
    let balance = TwoPlaneBalance {
        in_a,
        in_b,
        condition: x.condition,
        residual: magnitude(left(0), left(1)),
        residual_moment: magnitude(left_moment(0), left_moment(1)),
    };
    if balance.residual.is_finite() && balance.residual_moment.is_finite() {
        Ok(balance)
    } else {
        Err(BalanceError::NotFinite)
    }
}
