//! Matrices and parameters of rotations.

use dalembert_core::{Refusal, Worksheet};
use dalembert_mechanics::{Real, Vector};
use nalgebra::{Matrix3, Rotation3, UnitQuaternion, Vector3};

/// Rows as a matrix of plain numbers.
pub(crate) fn matrix<V: Vector>(rows: [V; 3]) -> Matrix3<f64> {
    Matrix3::from_rows(&rows.map(|row| row.value().transpose()))
}

/// Elements as rows.
pub(super) fn rows<V: Vector>(elements: [[V::Scalar; 3]; 3]) -> [V; 3] {
    elements.map(|[x, y, z]| V::from_components(x, y, z))
}

/// The residual `[C][C]ᵀ − 1`.
pub(crate) fn off_rotation(c: &Matrix3<f64>) -> Matrix3<f64> {
    c * c.transpose() - Matrix3::identity()
}

/// A row of a product of matrices: a row of the one before, times the rows of the one after.
pub(crate) fn row_times<V: Vector>(row: V, rows: [V; 3]) -> V {
    let [x, y, z] = row.components();
    rows[0] * x + rows[1] * y + rows[2] * z
}

/// Components of a vector along three axes that need not be normal to each other, from their triple product.
pub(crate) fn along<V: Vector>(vector: V, [a, b, c]: [V; 3], triple: V::Scalar) -> [V::Scalar; 3] {
    [b.cross(c), c.cross(a), a.cross(b)].map(|normal| vector.dot(normal) / triple)
}

/// Elements of `[BN]` from products `2 εₙ εₘ` off the diagonal and twists `2 β₀ ε`, in the order of the axes:
/// `diagonal(n)`, `product(n, m)` and `twist(k)`.
fn built<N: Real>(
    diagonal: impl Fn(usize) -> N,
    product: impl Fn(usize, usize) -> N,
    twist: impl Fn(usize) -> N,
) -> [[N; 3]; 3] {
    std::array::from_fn(|n| {
        std::array::from_fn(|m| {
            if n == m {
                diagonal(n)
            } else if (n + 1) % 3 == m {
                product(n, m) + twist(3 - n - m)
            } else {
                product(n, m) - twist(3 - n - m)
            }
        })
    })
}

/// Elements of `[BN]` from Euler parameters.
pub(super) fn by_parameters<N: Real>(scalar: N, vector: [N; 3]) -> [[N; 3]; 3] {
    built(
        |n| {
            let [same, next, last] = [n, (n + 1) % 3, (n + 2) % 3].map(|n| vector[n].powi(2));
            scalar.powi(2) + same - next - last
        },
        |n, m| vector[n] * vector[m] * 2.0,
        |k| scalar * vector[k] * 2.0,
    )
}

/// Elements of `[BN]` from a unit vector along the principal axis and the angle.
pub(super) fn by_axis<N: Real>(axis: [N; 3], angle: N) -> [[N; 3]; 3] {
    let (sin, cos) = (angle.sin(), angle.cos());
    built(
        |n| axis[n].powi(2) * (-cos + 1.0) + cos,
        |n, m| axis[n] * axis[m] * (-cos + 1.0),
        |k| axis[k] * sin,
    )
}

/// `[u×]`, which makes the cross product.
pub(crate) fn cross_matrix(u: Vector3<f64>) -> Matrix3<f64> {
    u.cross_matrix()
}

/// The residual `[C](1 + [q×]) − (1 − [q×])` of Cayley's formula, or that with squares for modified parameters.
pub(super) fn off_cayley_formula(c: &Matrix3<f64>, q: Vector3<f64>, modified: bool) -> Matrix3<f64> {
    let (plus, minus) = (Matrix3::identity() + cross_matrix(q), Matrix3::identity() - cross_matrix(q));
    if modified { c * plus * plus - minus * minus } else { c * plus - minus }
}

/// Euler parameters of `[BN]` with β₀ ≥ 0.
pub(crate) fn plain_parameters(c: &Matrix3<f64>) -> (f64, Vector3<f64>) {
    let rotation = Rotation3::from_matrix_unchecked(c.transpose());
    let quaternion = UnitQuaternion::from_rotation_matrix(&rotation);
    let sign = if quaternion.w < 0.0 { -1.0 } else { 1.0 };
    (quaternion.w * sign, quaternion.imag() * sign)
}

/// Rows of `[BN]` from elements, as steps.
pub(super) fn row_steps<W: Worksheet>(
    rows: [W::Vec; 3],
    place: Option<usize>,
    why: impl Fn(usize) -> dalembert_core::Reason,
    sheet: W,
) -> [W::Vec; 3] {
    const SYMBOLS: [&str; 3] = ["b₁", "b₂", "b₃"];
    const PRIMED: [&str; 3] = ["b′₁", "b′₂", "b′₃"];
    std::array::from_fn(|n| match place {
        None => sheet.step_vector(SYMBOLS[n], "1", rows[n], why(n)),
        Some(place) => sheet.step_vector((PRIMED[n], place), "1", rows[n], why(n)),
    })
}

/// Rows of `[BN]` from Euler parameters.
pub(crate) fn parameter_rows<V: Vector>(scalar: V::Scalar, vector: V) -> [V; 3] {
    rows(by_parameters(scalar, vector.components()))
}

/// Refuses a vector that has no direction.
pub(super) fn check_length(vector: Vector3<f64>, message: &'static str) -> Result<(), Refusal> {
    let size = vector.norm_squared();
    if size > 0.0 && size.is_finite() { Ok(()) } else { Err(Refusal::because(message)) }
}
