use dalembert_numerics::linalg::{
    LinalgError, Solved, complex_eigenvalues, least_squares, solve, symmetric_eigen,
};
use itertools::Itertools as _;
use nalgebra::{Complex, DMatrix, DVector};
use proptest::prelude::*;

use crate::close::{close, found};

fn matrices(rows: usize, columns: usize) -> impl Strategy<Value = DMatrix<f64>> {
    prop::collection::vec(-1.0..1.0, rows * columns)
        .prop_map(move |entries| DMatrix::from_vec(rows, columns, entries))
}

fn matrix<const R: usize, const C: usize>(rows: [[f64; C]; R]) -> DMatrix<f64> {
    DMatrix::from_fn(R, C, |i, j| rows[i][j])
}

fn column<const R: usize>(entries: [f64; R]) -> DVector<f64> {
    DVector::from_column_slice(&entries)
}

fn permutation(cycle: &[usize]) -> DMatrix<f64> {
    DMatrix::from_fn(cycle.len(), cycle.len(), |i, j| f64::from(u8::from(cycle[i] == j)))
}

#[test]
fn solve_does_not_mind_the_units() {
    // [2 1; 1 3] x = [3; 5] with equations and unknowns in absurd units.
    let (rows, columns) = (column([1e-9, 1e12]), column([1e150, 1e-140]));
    let plain = matrix([[2.0, 1.0], [1.0, 3.0]]);
    let scaled = DMatrix::from_diagonal(&rows) * &plain * DMatrix::from_diagonal(&columns);
    let right = column([3.0, 5.0]).component_mul(&rows);
    let (plain, scaled) = (found(solve(&plain, &column([3.0, 5.0]))), found(solve(&scaled, &right)));
    for i in 0..2 {
        close(plain.x[i], [0.8, 1.4][i], 1e-15);
        close(scaled.x[i] * columns[i], plain.x[i], 1e-14);
    }
    assert!(scaled.condition < 5.0, "{}", scaled.condition);
    close(found(solve(&DMatrix::identity(3, 3), &column([1.0, 2.0, 3.0]))).condition, 1.0, 1e-14);
}

#[test]
fn singular_systems_are_refused_near_and_far() {
    let right = column([1.0, 1.0]);
    assert_eq!(
        solve(&DMatrix::zeros(2, 2), &right),
        Err(LinalgError::Singular { reciprocal_condition: 0.0 })
    );
    for exponent in 1..17 {
        let away = 10f64.powi(-exponent);
        let system = matrix([[1.0, 1.0], [1.0, 1.0 + away]]);
        match solve(&system, &(&system * column([3.0, -2.0]))) {
            Ok(Solved { x, condition }) => {
                assert!(exponent <= 13, "{away:e} passed with {condition:e}");
                assert!((x[0] - 3.0).abs() <= 1e-15 * condition && (x[1] + 2.0).abs() <= 1e-15 * condition);
                close(condition, 4.0 / away, 0.2);
            }
            Err(error) => {
                assert!(exponent >= 12, "{away:e} was refused");
                assert!(matches!(error, LinalgError::Singular { .. }), "{error}");
            }
        }
    }
}

#[test]
fn what_is_not_finite_or_does_not_fit_is_refused() {
    let good = matrix([[2.0, 1.0], [1.0, 3.0]]);
    for bad in [f64::NAN, f64::INFINITY] {
        let mut matrix = good.clone();
        matrix[(1, 0)] = bad;
        assert_eq!(solve(&matrix, &column([1.0, 1.0])), Err(LinalgError::NotFinite));
        assert_eq!(least_squares(&matrix, &column([1.0, 1.0])), Err(LinalgError::NotFinite));
        assert_eq!(symmetric_eigen(&matrix), Err(LinalgError::NotFinite));
        assert_eq!(complex_eigenvalues(&matrix), Err(LinalgError::NotFinite));
        assert_eq!(solve(&good, &column([1.0, bad])), Err(LinalgError::NotFinite));
    }
    assert_eq!(solve(&matrix([[1e-200]]), &column([1e200])), Err(LinalgError::NotFinite));
    for (rows, columns) in [(0, 0), (2, 3), (3, 2)] {
        let matrix = DMatrix::zeros(rows, columns);
        assert!(matches!(solve(&matrix, &DVector::zeros(rows)), Err(LinalgError::Shape { .. })));
        assert!(matches!(symmetric_eigen(&matrix), Err(LinalgError::Shape { .. })));
        assert!(matches!(complex_eigenvalues(&matrix), Err(LinalgError::Shape { .. })));
    }
    assert!(matches!(solve(&good, &column([1.0])), Err(LinalgError::Shape { .. })));
    assert!(matches!(least_squares(&DMatrix::zeros(1, 2), &column([1.0])), Err(LinalgError::Shape { .. })));
    let skew = symmetric_eigen(&matrix([[1.0, 2.0], [2.1, 1.0]]));
    assert!(matches!(skew, Err(LinalgError::NotSymmetric { .. })));
}

#[test]
fn line_through_points() {
    // y = 2x + 1 with errors +1, −2, +1, which no straight line can follow: the line stays.
    let (a, b) = (matrix([[0.0, 1.0], [1.0, 1.0], [2.0, 1.0]]), column([2.0, 1.0, 6.0]));
    let fitted = found(least_squares(&a, &b));
    close(fitted.x[0], 2.0, 1e-14);
    close(fitted.x[1], 1.0, 1e-14);
    let dependent = matrix([[1.0, 2.0], [2.0, 4.0], [3.0, 6.0]]);
    assert!(matches!(least_squares(&dependent, &b), Err(LinalgError::Singular { .. })));
}

#[test]
fn chain_of_masses() {
    // Tridiagonal 2, −1: λ_j = 2 − 2 cos(jπ/(n + 1)).
    let n = 12;
    let chain = DMatrix::from_fn(n, n, |i: usize, j: usize| match i.abs_diff(j) {
        0 => 2.0,
        1 => -1.0,
        _ => 0.0,
    });
    let symmetric = found(symmetric_eigen(&chain));
    let general = found(complex_eigenvalues(&chain));
    for (j, (value, complex)) in symmetric.values.iter().zip_eq(&general).enumerate() {
        let expected = 2.0 - 2.0 * (std::f64::consts::PI * (j + 1) as f64 / (n + 1) as f64).cos();
        assert!((value - expected).abs() < 1e-14);
        assert!((complex - Complex::from(expected)).norm() < 1e-13);
    }
}

#[test]
fn matrices_on_which_the_library_stalls() {
    for cycle in [
        vec![1, 2, 3, 0],
        vec![1, 0, 3, 2],
        vec![3, 0, 1, 2],
        vec![1, 2, 0, 4, 5, 3],
        vec![1, 2, 3, 4, 5, 6, 7, 0],
    ] {
        let values = found(complex_eigenvalues(&permutation(&cycle)));
        assert!(values.iter().all(|z| (z.norm() - 1.0).abs() < 1e-12), "{cycle:?}: {values:?}");
    }
    for n in 2..40 {
        let companion = permutation(&(0..n).map(|i| (i + 1) % n).collect::<Vec<_>>());
        let values = found(complex_eigenvalues(&companion));
        for z in values {
            assert!((z.powu(n as u32) - 1.0).norm() < 1e-10, "n = {n}: {z}");
        }
    }
    let zeros = found(complex_eigenvalues(&DMatrix::zeros(3, 3)));
    assert_eq!(zeros, [Complex::from(0.0); 3]);
    let scalar = found(complex_eigenvalues(&matrix([[-7.5]])));
    assert_eq!(scalar, [Complex::from(-7.5)]);
}

#[test]
fn damped_and_gyroscopic_states() {
    // s² + 2ζω s + ω² with ζ = 0.1, ω = 5, and a rotor with G = 3: s = ±i(√(ω² + G²/4) ± G/2).
    let oscillator = matrix([[0.0, 1.0], [-25.0, -1.0]]);
    let values = found(complex_eigenvalues(&oscillator));
    for z in values {
        close(z.norm(), 5.0, 1e-14);
        close(z.re, -0.5, 1e-13);
    }
    let gyroscopic =
        matrix([[0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 0.0, 1.0], [-25.0, 0.0, 0.0, -3.0], [0.0, -25.0, 3.0, 0.0]]);
    let mut speeds: Vec<f64> = found(complex_eigenvalues(&gyroscopic)).iter().map(|z| z.im).collect();
    speeds.sort_by(f64::total_cmp);
    let root = (25.0f64 + 2.25).sqrt();
    for (ours, expected) in speeds.iter().zip_eq([-root - 1.5, -root + 1.5, root - 1.5, root + 1.5]) {
        close(*ours, expected, 1e-13);
    }
}

#[test]
fn eigenvalues_keep_their_size_when_units_do_not() {
    let stiff = matrix([[0.0, 1.0], [-1e16, -1e3]]);
    for z in found(complex_eigenvalues(&stiff)) {
        close(z.norm(), 1e8, 1e-12);
        close(z.re, -500.0, 1e-6);
    }
    let tiny = matrix([[2e-200, 1e-200], [1e-200, 2e-200]]);
    let eigen = found(symmetric_eigen(&tiny));
    close(eigen.values[0], 1e-200, 1e-13);
    close(eigen.values[1], 3e-200, 1e-13);
}

proptest! {
    #[test]
    fn solutions_solve(a in matrices(6, 6), x in matrices(6, 1)) {
        let x = DVector::from_column_slice(x.as_slice());
        if let Ok(solved) = solve(&a, &(&a * &x)) {
            prop_assert!((solved.x - &x).amax() <= 1e-14 * solved.condition);
        }
    }

    #[test]
    fn residual_of_least_squares_is_normal_to_the_columns(a in matrices(9, 4), b in matrices(9, 1)) {
        let b = DVector::from_column_slice(b.as_slice());
        if let Ok(fitted) = least_squares(&a, &b) {
            let residual = &b - &a * &fitted.x;
            prop_assert!((a.transpose() * residual).amax() <= 1e-13 * fitted.condition);
        }
    }

    #[test]
    fn symmetric_eigen_is_an_orthonormal_decomposition(a in matrices(7, 7)) {
        let a = &a + a.transpose();
        let eigen = found(symmetric_eigen(&a));
        let (values, v) = (DMatrix::from_diagonal(&eigen.values), &eigen.vectors);
        prop_assert!((&a - v * values * v.transpose()).amax() <= 1e-13);
        prop_assert!((v.transpose() * v - DMatrix::identity(7, 7)).amax() <= 1e-13);
        prop_assert!(eigen.values.as_slice().is_sorted());
    }

    #[test]
    fn eigenvalues_have_the_trace_and_the_powers_of_the_matrix(a in matrices(7, 7)) {
        let values = found(complex_eigenvalues(&a));
        let cube = &a * &a * &a;
        let sum: Complex<f64> = values.iter().sum();
        let cubes: Complex<f64> = values.iter().map(|z| z.powu(3)).sum();
        prop_assert!((sum - Complex::from(a.trace())).norm() <= 1e-12);
        prop_assert!((cubes - Complex::from(cube.trace())).norm() <= 1e-11);
    }

    #[test]
    fn any_matrix_is_answered_or_refused(entries in prop::collection::vec(any::<f64>(), 16)) {
        let a = DMatrix::from_vec(4, 4, entries);
        let right = DVector::from_element(4, 1.0);
        if let Ok(solved) = solve(&a, &right) {
            prop_assert!(solved.x.iter().all(|x| x.is_finite()) && solved.condition.is_finite());
        }
        if let Ok(values) = complex_eigenvalues(&a) {
            prop_assert!(values.iter().all(|z| z.re.is_finite() && z.im.is_finite()));
        }
        if let Ok(fitted) = least_squares(&a, &right) {
            prop_assert!(fitted.x.iter().all(|x| x.is_finite()));
        }
        let symmetric = DMatrix::from_fn(4, 4, |i, j| a[(i.max(j), i.min(j))]);
        if let Ok(eigen) = symmetric_eigen(&symmetric) {
            prop_assert!(eigen.values.iter().all(|x| x.is_finite()));
        }
    }
}
