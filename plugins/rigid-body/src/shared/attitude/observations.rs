//! Attitude from weighted directions: Davenport's q-method.

use dalembert_core::{Inputs, Refusal, Text, Worksheet};
use dalembert_mechanics::{Real, Vector};
use dalembert_numerics::linalg;
use nalgebra::{DMatrix, Matrix3, Matrix4, Vector3, Vector4};

use super::rotations::{by_parameters, check_length, matrix, row_steps, rows};

/// A direction that was seen in both frames.
#[derive(Clone, Debug, Inputs)]
pub struct VectorObservation {
    /// Direction in N, of any length.
    #[input("v_N", "1")]
    pub fixed: Vector3<f64>,
    /// Direction in B, of any length.
    #[input("v_B", "1")]
    pub body: Vector3<f64>,
    /// Weight.
    #[input("w", "1", positive, default = "1")]
    pub weight: f64,
}

/// Two largest eigenvalues that are nearer to each other than this part of the weights leave a rotation open.
const OPEN: f64 = 1e-9;

/// The rows of `[BN]` of the least sum of weighted squares.
pub(super) fn by_observations<W: Worksheet>(
    observations: &[VectorObservation],
    _given: &[VectorObservationGiven<W>],
    place: Option<usize>,
    sheet: W,
) -> Result<[W::Vec; 3], Refusal> {
    let mut profile = Matrix3::zeros();
    let mut total = 0.0;
    for observation in observations {
        for vector in [observation.fixed, observation.body] {
            check_length(vector, "one of the directions has no length: write any vector along it")?;
        }
        profile +=
            observation.body.normalize() * observation.fixed.normalize().transpose() * observation.weight;
        total += observation.weight;
    }
    let k = davenport(&profile) / total;
    let eigen = linalg::symmetric_eigen(&DMatrix::from_fn(4, 4, |n, m| k[(n, m)]))
        .map_err(|error| Refusal::because(Text::new("{error}").with("error", error)))?;
    if eigen.values[3] - eigen.values[2] <= OPEN {
        return Err(Refusal::because(
            "the directions are all parallel and leave the rotation about them open: write at least two that are not",
        ));
    }
    let sign = if eigen.vectors[(0, 3)] < 0.0 { -1.0 } else { 1.0 };
    let at = |n: usize| eigen.vectors[(n, 3)] * sign;
    let symbol = |symbol: &'static str| dalembert_core::Symbol::from(symbol).row(place.unwrap_or(0));
    let scalar = sheet.numerical(
        symbol("β̂_s"),
        "1",
        at(0),
        "Scalar Euler parameter: the eigenvector of the largest eigenvalue of Davenport's matrix",
    );
    let vector = sheet.numerical_vector(
        symbol("β̂_v"),
        "1",
        Vector3::new(at(1), at(2), at(3)),
        "Vector part: the rest of the eigenvector",
    );
    let why = |_| "Row of the direction cosine matrix of these Euler parameters".into();
    let rows = row_steps::<W>(rows(by_parameters(scalar, vector.components())), place, why, sheet);
    sheet.verify(|| {
        // Of the best attitude the rotation leaves the profile symmetric: [BN]ᵀ B = ([BN]ᵀ B)ᵀ.
        let stretch = matrix(rows).transpose() * profile / total;
        sheet.check_zeros(
            "the gain of any small further rotation, which is zero at the best attitude",
            (stretch - stretch.transpose()).iter().copied(),
            1.0,
        );
        let found = Vector4::new(scalar.value(), vector.value().x, vector.value().y, vector.value().z);
        sheet.check_zeros(
            "Davenport's matrix times the Euler parameters, less the eigenvalue times them",
            (k * found - found * eigen.values[3]).iter().copied(),
            1.0,
        );
    });
    Ok(rows)
}

/// Davenport's matrix of `Σ w v_B v_Nᵀ`, scalar part first.
fn davenport(profile: &Matrix3<f64>) -> Matrix4<f64> {
    let trace = profile.trace();
    let z = Vector3::new(
        profile[(1, 2)] - profile[(2, 1)],
        profile[(2, 0)] - profile[(0, 2)],
        profile[(0, 1)] - profile[(1, 0)],
    );
    let s = profile + profile.transpose() - Matrix3::identity() * trace;
    Matrix4::from_fn(|n, m| match (n, m) {
        (0, 0) => trace,
        (0, k) | (k, 0) => z[k - 1],
        (n, m) => s[(n - 1, m - 1)],
    })
}
