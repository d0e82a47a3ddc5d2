//! QR factorisation by plane rotations, compared with dense products.

use dalembert_numerics::givens::{GivensQr, ordering};
use nalgebra::{DMatrix, DVector};
use proptest::prelude::*;

const SIZE: usize = 6;

/// Matrices with many zeros and a diagonal that keeps them regular, in any order of rows.
fn sparse() -> impl Strategy<Value = DMatrix<f64>> {
    let entry = prop_oneof![2 => Just(0.0), 1 => -1.0..1.0];
    let rows: Vec<usize> = (0..SIZE).collect();
    (prop::collection::vec(entry, SIZE * SIZE), Just(rows).prop_shuffle()).prop_map(|(entries, rows)| {
        DMatrix::from_fn(SIZE, SIZE, |row, column| {
            let large = if rows[row] == column { 8.0 } else { 0.0 };
            entries[row * SIZE + column] + large
        })
    })
}

fn pattern(a: &DMatrix<f64>) -> Vec<Vec<(usize, usize)>> {
    let row =
        |row: usize| (0..SIZE).filter(|&at| a[(row, at)] != 0.0).map(|at| (row * SIZE + at, at)).collect();
    (0..SIZE).map(row).collect()
}

proptest! {
    #[test]
    fn sparse_equations_are_solved_and_the_sign_of_the_determinant_is_kept(a in sparse()) {
        let [rows, columns] = ordering(&pattern(&a));
        let arranged = DMatrix::from_fn(SIZE, SIZE, |i, j| a[(rows[i], columns[j])]);
        let mut qr = GivensQr::new(&pattern(&arranged));
        qr.factor(|place| arranged[(place / SIZE, place % SIZE)]);
        let wanted = DVector::from_fn(SIZE, |i, _| 1.0 + i as f64);
        let mut x: Vec<f64> = (&arranged * &wanted).as_slice().to_vec();
        qr.solve(&mut x);
        prop_assert!((DVector::from_vec(x) - &wanted).amax() < 1e-12);
        let mut y: Vec<f64> = (arranged.transpose() * &wanted).as_slice().to_vec();
        qr.solve_transposed(&mut y);
        prop_assert!((DVector::from_vec(y) - &wanted).amax() < 1e-12);
        let sign = qr.determinant()[0].signum();
        prop_assert_eq!(sign, arranged.determinant().signum());
    }
}
