//! Corrections in any number of planes.

use nalgebra::{DMatrix, DVector};

use super::{BalanceError, PlaneUnbalance, balance_two_planes};
use crate::Real;
use dalembert_numerics::linalg::{self, LinalgError};

/// One component of the correction in the plane at `z`, of `n ≥ 2` planes, where the sum of squares of all
/// corrections is least:
/// `U_k = −F/n − (z_k − z̄) M/S`, with `F = Σ Uᵢ`, `z̄` the mean position of the planes, `M = Σ Uᵢ(zᵢ − z̄)` and
/// `S = Σ (z_k − z̄)²`.
///
/// The equations `Σ U_k = −F`, `Σ U_k (z_k − z̄) = −M` have orthogonal rows, so each is met by its own least
/// vector. For two planes this is the only solution.
#[inline(always)]
pub fn least_correction<S: Real>(force: S, moment: S, planes: f64, arm: S, spread: S) -> S {
    -force / planes - arm * moment / spread
}

/// Components `[x, y]` of the corrections with the least sum of squares, in the order of the planes, two or more, as
/// one linear system: `U = Aᵀλ` with `A Aᵀ λ = b`, the rows of `A` being ones and the positions.
///
/// # Errors
/// [`BalanceError`]; one plane, or none, counts as coincident planes.
pub fn balance_planes(unbalances: &[PlaneUnbalance], planes: &[f64]) -> Result<Vec<[f64; 2]>, BalanceError> {
    let coincident = || {
        let a = planes.first().copied().unwrap_or(0.0);
        BalanceError::CoincidentPlanes { a, b: planes.last().copied().unwrap_or(a) }
    };
    if let [a, b] = *planes {
        let balance = balance_two_planes(unbalances, [a, b])?;
        return Ok(vec![balance.in_a, balance.in_b]);
    }
    let low = planes.iter().copied().fold(f64::INFINITY, f64::min);
    let high = planes.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let half = high / 2.0 - low / 2.0;
    if planes.len() < 2 || half == 0.0 {
        return Err(coincident());
    }
    let place = |z: f64| (z - low) / half - 1.0;
    let mut matrix = DMatrix::zeros(2, 2);
    for z in planes.iter().map(|z| place(*z)) {
        matrix += DMatrix::from_row_slice(2, 2, &[1.0, z, z, z * z]);
    }
    let along = |axis: usize| {
        let mut right = DVector::zeros(2);
        for u in unbalances {
            right -= DVector::from_vec(vec![u.components[axis], u.components[axis] * place(u.position)]);
        }
        let solved = linalg::solve(&matrix, &right).map_err(|error| match error {
            LinalgError::Singular { .. } => coincident(),
            _ => BalanceError::NotFinite,
        })?;
        Ok(planes.iter().map(|z| solved.x[0] + solved.x[1] * place(*z)).collect::<Vec<f64>>())
    };
    Ok(along(0)?.into_iter().zip(along(1)?).map(|(x, y)| [x, y]).collect())
}

/// Equivalent unbalance of a rotor in the first of two planes, one component: `U_I = Σ Uᵢ (z_II − zᵢ)/(z_II − z_I)`.
/// ISO 21940-2: dynamic unbalance reported in two arbitrary planes.
#[inline(always)]
pub fn equivalent_in_first<S: Real>(
    components_at: impl IntoIterator<Item = (S, S)>,
    first: S,
    second: S,
) -> S {
    S::sum(components_at.into_iter().map(|(u, z)| u * (second - z))) / (second - first)
}

/// Equivalent unbalance in the second of two planes, one component: `U_II = Σ Uᵢ (zᵢ − z_I)/(z_II − z_I)`.
#[inline(always)]
pub fn equivalent_in_second<S: Real>(
    components_at: impl IntoIterator<Item = (S, S)>,
    first: S,
    second: S,
) -> S {
    S::sum(components_at.into_iter().map(|(u, z)| u * (z - first))) / (second - first)
}

/// Class of unbalance of a rigid rotor, by the names of ISO 21940-2.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum UnbalanceKind {
    /// None.
    Balanced,
    /// The principal axis is parallel to the shaft: a resultant through the centre of mass, no couple about it.
    Static,
    /// The principal axis meets the shaft, not at the centre of mass: one resultant elsewhere.
    QuasiStatic,
    /// The principal axis meets the shaft at the centre of mass: a couple without resultant.
    Couple,
    /// The principal axis and the shaft are skew: resultant and couple in different planes.
    Dynamic,
}

/// The kind of the unbalance of a rotor with its centre of mass at a position along the shaft. What is below
/// `tolerance` of the sum of all unbalances counts as zero; moments are compared with the length of the rotor.
pub fn kind(unbalances: &[PlaneUnbalance], centre_of_mass: f64, tolerance: f64) -> UnbalanceKind {
    let size = |v: [f64; 2]| v[0].hypot(v[1]);
    let sum = |weight: &dyn Fn(&PlaneUnbalance) -> f64| {
        [0, 1].map(|axis| unbalances.iter().map(|u| weight(u) * u.components[axis]).sum::<f64>())
    };
    let all: f64 = unbalances.iter().map(|u| size(u.components)).sum();
    let length = unbalances.iter().map(|u| (u.position - centre_of_mass).abs()).fold(0.0, f64::max);
    let force = sum(&|_| 1.0);
    let moment = sum(&|u| u.position - centre_of_mass);
    let without_force = size(force) <= tolerance * all;
    let without_moment = size(moment) <= tolerance * all * length;
    let cross = (force[0] * moment[1] - force[1] * moment[0]).abs();
    match (without_force, without_moment) {
        (true, true) => UnbalanceKind::Balanced,
        (true, false) => UnbalanceKind::Couple,
        (false, true) => UnbalanceKind::Static,
        (false, false) if cross <= tolerance * size(force) * all * length => UnbalanceKind::QuasiStatic,
        (false, false) => UnbalanceKind::Dynamic,
    }
}
