//! Eigenvalues and eigenvectors of real square matrices without symmetry.

use faer::{Mat, Par, linalg::solvers::DenseSolveCore};
use nalgebra::linalg::balancing::balance_parlett_reinsch;
use nalgebra::{Complex, DMatrix};

use super::{
    LinalgError, MOST_DENSE, Random, SINGULAR, finite, not_above, power_of_two_below, rounding, square, view,
};

/// Eigenvalues and right eigenvectors of a real square matrix.
#[derive(Debug, Clone, PartialEq)]
pub struct ComplexEigen {
    /// Eigenvalues, ascending by real part and then by imaginary part.
    pub values: Vec<Complex<f64>>,
    /// Eigenvectors of unit length, a column each, in the order of the values.
    pub vectors: DMatrix<Complex<f64>>,
}

impl ComplexEigen {
    /// The left eigenvectors as rows, `W V = 1`: row i times a state is the share of mode i in it.
    ///
    /// # Errors
    /// `Singular` for a matrix without a full set of eigenvectors (critical damping, two free rigid modes).
    pub fn left(&self) -> Result<DMatrix<Complex<f64>>, LinalgError> {
        one_thread();
        let n = self.values.len();
        let vectors = Mat::from_fn(n, n, |row, column| self.vectors[(row, column)]);
        #[expect(clippy::disallowed_methods, reason = "finite, of unit columns, and its condition is held")]
        let inverse = vectors.partial_piv_lu().inverse();
        let left = DMatrix::from_fn(n, n, |row, column| inverse[(row, column)]);
        let norm = |a: &DMatrix<Complex<f64>>| {
            a.column_iter().map(|column| column.iter().map(|entry| entry.norm()).sum()).fold(0.0, f64::max)
        };
        let reciprocal_condition = 1.0 / (norm(&self.vectors) * norm(&left));
        // False for what is not a number, too.
        if reciprocal_condition > SINGULAR * 1e2 {
            return Ok(left);
        }
        let reciprocal_condition = if reciprocal_condition.is_nan() { 0.0 } else { reciprocal_condition };
        Err(LinalgError::Singular { reciprocal_condition })
    }
}

/// These matrices are small: more threads would take more time, and their number would change the last digits.
fn one_thread() {
    faer::set_global_parallelism(Par::Seq);
}

/// Eigenvalues of a real square matrix, ascending by real part and then by imaginary part.
///
/// # Errors
/// `Shape`; `TooLarge` above [`MOST_DENSE`]; `NotFinite`; `NotConverged`.
pub fn complex_eigenvalues(a: &DMatrix<f64>) -> Result<Vec<Complex<f64>>, LinalgError> {
    one_thread();
    let Balanced { matrix, size, .. } = balanced(a)?;
    let n = a.nrows();
    let mut values: Vec<Complex<f64>> = {
        #[expect(clippy::disallowed_methods, reason = "finite, balanced, and limited by the library itself")]
        let values = view(&matrix).eigenvalues().map_err(|_| LinalgError::NotConverged)?;
        values.iter().map(|value| Complex::new(value.re, value.im)).collect()
    };
    // The sum of the values is the trace, that of their squares the trace of the square.
    let sum: Complex<f64> = values.iter().sum();
    let squares: Complex<f64> = values.iter().map(|value| value * value).sum();
    let trace_of_square: f64 =
        (0..n).flat_map(|i| (0..n).map(move |j| (i, j))).map(|(i, j)| matrix[(i, j)] * matrix[(j, i)]).sum();
    let norm = matrix.norm();
    let tolerance = rounding(n) * n as f64;
    if (sum - matrix.trace()).norm() > tolerance * norm
        || (squares - trace_of_square).norm() > tolerance * norm * norm
    {
        return Err(LinalgError::NotConverged);
    }
    for value in &mut values {
        *value *= size;
    }
    finite(values.iter().flat_map(|value| [&value.re, &value.im]))?;
    values.sort_by(|p, q| p.re.total_cmp(&q.re).then(p.im.total_cmp(&q.im)));
    Ok(values)
}

/// Eigenvalues of a real square matrix, ascending by real part and then by imaginary part, and unit eigenvectors.
///
/// # Errors
/// `Shape`; `TooLarge` above [`MOST_DENSE`]; `NotFinite`; `NotConverged`, also when a vector does not satisfy its
/// equation.
pub fn complex_eigen(a: &DMatrix<f64>) -> Result<ComplexEigen, LinalgError> {
    one_thread();
    let Balanced { matrix, scale, size } = balanced(a)?;
    let n = a.nrows();
    let (values, vectors) = {
        #[expect(clippy::disallowed_methods, reason = "finite, balanced, and limited by the library itself")]
        let eigen = view(&matrix).eigen().map_err(|_| LinalgError::NotConverged)?;
        let values: Vec<Complex<f64>> =
            eigen.S().column_vector().iter().map(|value| Complex::new(value.re, value.im)).collect();
        let vectors = DMatrix::from_fn(n, n, |row, column| {
            let entry = eigen.U()[(row, column)];
            Complex::new(entry.re, entry.im)
        });
        (values, vectors)
    };
    finite(values.iter().chain(vectors.iter()).flat_map(|entry| [&entry.re, &entry.im]))?;
    // Sums of all vectors with random signs: a wrong one shows in each of them.
    let norm = matrix.norm();
    let mut random = Random::new();
    for _ in 0..2 {
        let weights: Vec<f64> =
            vectors.column_iter().map(|vector| random.next().signum() / (norm * vector.norm())).collect();
        let sum = |of: &dyn Fn(usize) -> Complex<f64>| {
            let mut sum = vec![Complex::ZERO; n];
            for (at, vector) in vectors.column_iter().enumerate() {
                let weight = of(at);
                sum.iter_mut().zip(vector.iter()).for_each(|(sum, x)| *sum += x * weight);
            }
            sum
        };
        let (all, mut left) = (sum(&|at| weights[at].into()), sum(&|at| -values[at] * weights[at]));
        for (column, x) in matrix.column_iter().zip(&all) {
            left.iter_mut().zip(column.iter()).for_each(|(left, a)| *left += x * *a);
        }
        let limit = rounding(n) * 10.0 * (n as f64).sqrt();
        if norm > 0.0 && left.iter().any(|entry| entry.norm() > limit) {
            return Err(LinalgError::NotConverged);
        }
    }

    let mut order: Vec<usize> = (0..n).collect();
    order.sort_by(|&i, &j| values[i].re.total_cmp(&values[j].re).then(values[i].im.total_cmp(&values[j].im)));
    let mut sorted = vectors.select_columns(&order);
    for mut vector in sorted.column_iter_mut() {
        for (entry, scale) in vector.iter_mut().zip(&scale) {
            *entry *= *scale;
        }
        let length = vector.norm();
        vector.iter_mut().for_each(|entry| *entry /= length);
    }
    let values: Vec<Complex<f64>> = order.iter().map(|&i| values[i] * size).collect();
    finite(values.iter().chain(sorted.iter()).flat_map(|entry| [&entry.re, &entry.im]))?;
    Ok(ComplexEigen { values, vectors: sorted })
}

/// `D⁻¹ A D / size`, with rows and columns of comparable size.
struct Balanced {
    matrix: DMatrix<f64>,
    scale: Vec<f64>,
    size: f64,
}

fn balanced(a: &DMatrix<f64>) -> Result<Balanced, LinalgError> {
    square(a)?;
    not_above("unknowns of a full matrix", a.nrows(), MOST_DENSE)?;
    finite(a.iter())?;
    let mut size = power_of_two_below(a.amax());
    let mut matrix = a / size;
    let scale = balance_parlett_reinsch(&mut matrix);
    let after = power_of_two_below(matrix.amax());
    matrix /= after;
    size *= after;
    finite(matrix.iter().chain(scale.iter()))?;
    Ok(Balanced { matrix, scale: scale.iter().copied().collect(), size })
}
