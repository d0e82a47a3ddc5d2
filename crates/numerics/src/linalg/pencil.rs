//! Generalised eigenvalue problem `K φ = λ M φ` with full symmetric matrices.

use faer::{
    Accum, MatMut, MatRef, Par,
    dyn_stack::{MemBuffer, MemStack},
    linalg::{
        cholesky::llt::factor::{LltError, cholesky_in_place, cholesky_in_place_scratch},
        matmul::{
            matmul,
            triangular::{self, BlockStructure},
        },
        triangular_solve::{solve_lower_triangular_in_place, solve_upper_triangular_in_place},
    },
    reborrow::{Reborrow, ReborrowMut},
};
use nalgebra::{DMatrix, DVector};

use super::{
    LinalgError, MOST_DENSE, SymmetricEigen, below_diagonal,
    divide::{qr_algorithm, tridiagonal_eigen},
    exact::Sum,
    finite, largest, not_above, power_of_two_below, shape, square, sum_of_sizes, symmetric,
    tridiagonal::Tridiagonal,
    view, view_mut,
};

/// A mode whose value lies this far below the largest one has its value recomputed from its vector, with twice
/// the digits: the solver leaves an error of the order of the largest value in every one.
const LOW: f64 = 1e-3;

/// So many low values are recomputed at most.
const MOST_LOW: usize = 10;

/// From so many unknowns on, several threads take less time than one.
const WORTH_THREADS: usize = 400;

/// Blocks up to this size are not divided.
const UNDIVIDED: usize = 32;

/// The eigenvalues of `K φ = λ M φ`, ascending, and vectors with `φᵀ M φ = 1`.
///
/// M is reduced by Cholesky (Golub and Van Loan, 4th ed., §8.7.2), after each unknown is scaled so that
/// its mass is near one: rotations may stand beside translations. K may be singular or indefinite. The values of
/// low modes are Rayleigh quotients with twice the digits, and zero where that is all rounding: a rigid body mode.
/// Above some hundred unknowns all cores take part, and the last digits may depend on their number.
///
/// # Errors
/// `Shape` unless K and M are n by n, n ≥ 1; `TooLarge` above [`MOST_DENSE`]; `NotFinite`; `NotSymmetric`;
/// `NotPositiveDefinite` for M; `NotConverged`.
pub fn generalised_eigen(k: &DMatrix<f64>, m: &DMatrix<f64>) -> Result<SymmetricEigen, LinalgError> {
    among_threads(k.nrows(), || values_and_vectors(k, m))
}

fn values_and_vectors(k: &DMatrix<f64>, m: &DMatrix<f64>) -> Result<SymmetricEigen, LinalgError> {
    let Reduced { stiffness, mass, lower, standard, scale, size } = reduce(k, m)?;
    let n = k.nrows();
    let (mut values, mut vectors) = (vec![0.0; n], DMatrix::zeros(n, n));
    eigen(standard, &mut values, Some(view_mut(&mut vectors)))?;
    solve_upper_triangular_in_place(view(&lower).transpose(), view_mut(&mut vectors), threads(n));

    let most = largest(&values);
    let low = values.iter().take_while(|value| **value < LOW * most).count().min(MOST_LOW);
    let mut refined: Vec<(f64, usize)> =
        (0..low).map(|mode| (rayleigh(&stiffness, &mass, vectors.column(mode).as_slice()), mode)).collect();
    refined.sort_by(|p, q| p.0.total_cmp(&q.0));
    let mut order: Vec<usize> = (0..n).collect();
    for (at, (value, mode)) in refined.into_iter().enumerate() {
        values[at] = value;
        order[at] = mode;
    }
    if low > 0 {
        vectors = vectors.select_columns(&order);
    }

    residual(&stiffness, &mass, &values, &vectors)?;
    for vector in vectors.as_mut_slice().chunks_exact_mut(n) {
        for (entry, row_scale) in vector.iter_mut().zip(&scale) {
            *entry *= row_scale;
        }
    }
    let values = DVector::from_vec(values) * size;
    finite(values.iter().chain(vectors.as_slice()))?;
    Ok(SymmetricEigen { values, vectors })
}

/// The eigenvalues of `K φ = λ M φ` alone, ascending.
///
/// # Errors
/// As for [`generalised_eigen`].
pub fn generalised_eigenvalues(k: &DMatrix<f64>, m: &DMatrix<f64>) -> Result<DVector<f64>, LinalgError> {
    among_threads(k.nrows(), || {
        let Reduced { standard, size, .. } = reduce(k, m)?;
        let mut values = vec![0.0; k.nrows()];
        eigen(standard, &mut values, None)?;
        let values = DVector::from_vec(values) * size;
        finite(values.iter())?;
        Ok(values)
    })
}

/// Does the work as one of the threads that share it, where several do: a thread that stands outside would sleep and be
/// woken for each of the thousands of steps that are shared.
fn among_threads<T: Send>(n: usize, work: impl FnOnce() -> T + Send) -> T {
    if n < WORTH_THREADS { work() } else { rayon::scope(|_| work()) }
}

/// One thread for small matrices, as many as there are for large ones; one in a browser.
fn threads(n: usize) -> Par {
    #[cfg(not(target_family = "wasm"))]
    if n >= WORTH_THREADS {
        return Par::rayon(0);
    }
    let _ = n;
    Par::Seq
}

/// Eigenvalues of a symmetric matrix, ascending, and its vectors if they are wanted. The lower half is read.
fn eigen(a: DMatrix<f64>, values: &mut [f64], vectors: Option<MatMut<'_, f64>>) -> Result<(), LinalgError> {
    let par = threads(a.nrows());
    let reduced = Tridiagonal::of(a, par);
    values.copy_from_slice(&reduced.diagonal);
    let Some(mut vectors) = vectors else { return qr_algorithm(values, &reduced.below, None) };
    tridiagonal_eigen(values, &reduced.below, vectors.rb_mut(), par)?;
    reduced.back_transform(vectors, par);
    Ok(())
}

/// `D K D / size` and `D M D`, the Cholesky factor of the second, and `L⁻¹ K L⁻ᵀ` of the scaled ones.
///
/// Of each matrix the lower half is what counts.
struct Reduced {
    stiffness: DMatrix<f64>,
    mass: DMatrix<f64>,
    lower: DMatrix<f64>,
    standard: DMatrix<f64>,
    scale: Vec<f64>,
    size: f64,
}

fn reduce(k: &DMatrix<f64>, m: &DMatrix<f64>) -> Result<Reduced, LinalgError> {
    square(k)?;
    let n = k.nrows();
    if m.shape() != k.shape() {
        return Err(shape(m, "a mass matrix as large as the stiffness matrix"));
    }
    not_above("unknowns of a full matrix", n, MOST_DENSE)?;
    if let Some(row) = (0..n).find(|&row| m[(row, row)] <= 0.0) {
        return Err(LinalgError::NotPositiveDefinite { matrix: "mass", row: row + 1 });
    }
    let scale: Vec<f64> = (0..n).map(|row| 1.0 / power_of_two_below(m[(row, row)].sqrt())).collect();
    let scaled = |a: &DMatrix<f64>| {
        let mut entries = Vec::with_capacity(n * n);
        for (column, column_scale) in a.as_slice().chunks_exact(n).zip(&scale) {
            entries.extend(
                column.iter().zip(&scale).map(|(entry, row_scale)| (entry * row_scale) * column_scale),
            );
        }
        DMatrix::from_vec(n, n, entries)
    };
    let mut stiffness = scaled(k);
    let size = power_of_two_below(largest(stiffness.as_slice()));
    for entry in stiffness.as_mut_slice() {
        *entry *= 1.0 / size;
    }
    let mass = scaled(m);
    finite(stiffness.as_slice().iter().chain(mass.as_slice()))?;
    symmetric(k)?;
    symmetric(m)?;

    let (mut lower, par) = (mass.clone(), threads(n));
    let settings = <_>::default();
    let mut memory = MemBuffer::new(cholesky_in_place_scratch::<f64>(n, par, settings));
    #[expect(clippy::disallowed_methods, reason = "finite and scaled, and its pivots are held below")]
    cholesky_in_place(view_mut(&mut lower), <_>::default(), par, MemStack::new(&mut memory), settings)
        .map_err(|LltError::NonPositivePivot { index }| LinalgError::NotPositiveDefinite {
            matrix: "mass",
            row: index + 1,
        })?;
    // What is left of a diagonal entry after elimination: rounding alone may leave something positive.
    for row in 0..n {
        let pivot = lower[(row, row)].powi(2);
        if pivot <= f64::EPSILON * 4.0 * mass[(row, row)] {
            return Err(LinalgError::NotPositiveDefinite { matrix: "mass", row: row + 1 });
        }
    }
    let mut standard = stiffness.clone();
    congruence(view_mut(&mut standard), view(&lower), par);
    Ok(Reduced { stiffness, mass, lower, standard, scale, size })
}

/// `L⁻¹ A L⁻ᵀ` in place of a symmetric A, whose lower half alone is read and written: by halves, so that half of the
/// work of two triangular solutions is spared (Golub and Van Loan, 4th ed., §8.7.2).
fn congruence(mut a: MatMut<'_, f64>, l: MatRef<'_, f64>, par: Par) {
    let n = a.nrows();
    if n <= UNDIVIDED {
        mirror(a.rb_mut());
        solve_lower_triangular_in_place(l, a.rb_mut(), par);
        solve_lower_triangular_in_place(l, a.transpose_mut(), par);
        return;
    }
    let (l11, _, l21, l22) = l.split_at(n / 2, n / 2);
    let (mut a11, _, mut a21, mut a22) = a.split_at_mut(n / 2, n / 2);
    congruence(a11.rb_mut(), l11, par);
    mirror(a11.rb_mut());
    solve_lower_triangular_in_place(l11, a21.rb_mut().transpose_mut(), par);
    matmul(a21.rb_mut(), Accum::Add, l21, a11.rb(), -0.5, par);
    let (lower, full) = (BlockStructure::TriangularLower, BlockStructure::Rectangular);
    for (left, right) in [(l21, a21.rb()), (a21.rb(), l21)] {
        let right = right.transpose();
        triangular::matmul(a22.rb_mut(), lower, Accum::Add, left, full, right, full, -1.0, par);
    }
    matmul(a21.rb_mut(), Accum::Add, l21, a11.rb(), -0.5, par);
    solve_lower_triangular_in_place(l22, a21, par);
    congruence(a22, l22, par);
}

/// Copies the lower half to the upper one.
fn mirror(mut a: MatMut<'_, f64>) {
    below_diagonal(a.nrows(), |row, column| a[(column, row)] = a[(row, column)]);
}

/// `xᵀK x / xᵀM x` with twice the digits; zero where nothing but rounding is left of the numerator.
fn rayleigh(k: &DMatrix<f64>, m: &DMatrix<f64>, x: &[f64]) -> f64 {
    let energy = |a: &DMatrix<f64>| {
        let (mut total, mut size) = (Sum::default(), 0.0);
        for (at, (column, x_column)) in a.column_iter().zip(x).enumerate() {
            let mut sum = Sum::default();
            // Half of the diagonal entry, and of all that stands below it one of the two.
            sum.add_product(column[at] / 2.0, *x_column);
            size += (column[at] / 2.0 * x_column * x_column).abs();
            for (a, x) in column.iter().zip(x).skip(at + 1) {
                sum.add_product(*a, *x);
                size += (a * x * x_column).abs();
            }
            let (high, low) = sum.parts();
            total.add_product(high, *x_column);
            total.add_product(low, *x_column);
        }
        (total.value(), size)
    };
    let ((potential, size), (kinetic, _)) = (energy(k), energy(m));
    if potential.abs() <= 4.0 * f64::EPSILON * size { 0.0 } else { potential / kinetic }
}

/// Holds `K φ − λ M φ` against the size of K and of λ M, for sums of all modes with random signs: a wrong mode
/// shows in each of them.
fn residual(
    k: &DMatrix<f64>,
    m: &DMatrix<f64>,
    values: &[f64],
    vectors: &DMatrix<f64>,
) -> Result<(), LinalgError> {
    const SUMS: usize = 2;
    let (n, par) = (values.len(), threads(values.len()));
    let norm = |a: &DMatrix<f64>| a.as_slice().chunks_exact(n).map(sum_of_sizes).fold(0.0, f64::max);
    let (k_size, m_size) = (norm(k), norm(m));
    let mut random = super::Random::new();
    let mut weights = DMatrix::zeros(n, 2 * SUMS);
    for (mode, (vector, value)) in vectors.as_slice().chunks_exact(n).zip(values).enumerate() {
        let size = (k_size + value.abs() * m_size) * largest(vector);
        for sum in 0..SUMS {
            let weight = random.next().signum() / size;
            weights[(mode, sum)] = weight;
            weights[(mode, SUMS + sum)] = weight * value;
        }
    }
    let (mut sums, mut left) = (DMatrix::zeros(n, 2 * SUMS), DMatrix::zeros(n, SUMS));
    matmul(view_mut(&mut sums), Accum::Replace, view(vectors), view(&weights), 1.0, par);
    let (steady, moving) = view(&sums).split_at_col(SUMS);
    let full = BlockStructure::Rectangular;
    for (a, sums, sign) in [(view(k), steady, 1.0), (view(m), moving, -1.0)] {
        for (half, part) in
            [(a, BlockStructure::TriangularLower), (a.transpose(), BlockStructure::StrictTriangularUpper)]
        {
            triangular::matmul(view_mut(&mut left), full, Accum::Add, half, part, sums, full, sign, par);
        }
    }
    if largest(left.as_slice()) > super::rounding(n) * (n as f64).sqrt() {
        return Err(LinalgError::NotConverged);
    }
    Ok(())
}
