//! Sparse matrices and their elimination, compared with dense products.

use dalembert_numerics::linalg::{Elimination, SparseMatrix};
use itertools::Itertools as _;
use nalgebra::{DMatrix, DVector};
use proptest::prelude::*;

const ROWS: usize = 7;
const COLUMNS: usize = 9;

/// Matrices with many zeros, of which the last row follows from the first two.
fn dependent() -> impl Strategy<Value = DMatrix<f64>> {
    let entry = prop_oneof![2 => Just(0.0), 1 => -1.0..1.0];
    prop::collection::vec(entry, ROWS * COLUMNS).prop_map(|entries| {
        let mut a = DMatrix::from_vec(ROWS, COLUMNS, entries);
        let sum = a.row(0) * 2.0 - a.row(1);
        a.set_row(ROWS - 1, &sum);
        a
    })
}

fn dense(a: &SparseMatrix) -> DMatrix<f64> {
    let mut full = DMatrix::zeros(a.rows().len(), a.columns());
    for (row, entries) in a.rows().iter().enumerate() {
        for &(column, x) in entries {
            full[(row, column)] += x;
        }
    }
    full
}

proptest! {
    #[test]
    fn sparse_products_and_selections_are_those_of_the_dense_matrix(a in dependent()) {
        let sparse = SparseMatrix::from(&a);
        prop_assert_eq!(&dense(&sparse), &a);
        prop_assert_eq!(dense(&sparse.transpose()), a.transpose());
        let product = &a * a.transpose();
        prop_assert!((dense(&sparse.times_transpose()) - &product).amax() < 1e-13);
        let mut shifted = sparse.times_transpose();
        (0..ROWS).for_each(|row| shifted.add_to_diagonal(row, 3.0));
        prop_assert!((dense(&shifted) - product - DMatrix::identity(ROWS, ROWS) * 3.0).amax() < 1e-13);
        let x = DVector::from_fn(ROWS, |row, _| 1.0 + row as f64);
        let product = DVector::from_vec(sparse.transposed_times(x.as_slice()));
        prop_assert!((product - a.transpose() * x).amax() < 1e-13);
        let (rows, columns) = ([4, 0, 2], [8, 1, 3]);
        let selected = sparse.select_rows(&rows).select_columns(&columns);
        prop_assert_eq!(dense(&selected), a.select_rows(&rows).select_columns(&columns));
    }

    #[test]
    fn elimination_solves_what_is_left_of_dependent_rows(a in dependent()) {
        let elimination = Elimination::of_sparse(&SparseMatrix::from(&a)).expect("it is finite");
        prop_assert!(elimination.rank() < ROWS);
        let kept = a.select_rows(elimination.independent_rows());
        let wanted = DVector::from_fn(COLUMNS, |at, _| 1.0 + at as f64);
        let right = &a * &wanted;
        let x = DVector::from_vec(elimination.solve(right.as_slice()).expect("it is finite"));
        prop_assert!((&a * &x - &right).amax() < 1e-9 * (1.0 + x.amax()));
        for &column in elimination.free_columns() {
            prop_assert_eq!(x[column], 0.0);
        }
        for (motion, &free) in elimination.null_space().expect("it is finite").iter().zip_eq(elimination.free_columns()) {
            let motion = DVector::from_column_slice(motion);
            prop_assert!((&a * &motion).amax() < 1e-9 * motion.amax());
            prop_assert_eq!(motion[free], 1.0);
        }
        // Multipliers: a combination of the kept rows is found again.
        let multipliers = DVector::from_fn(kept.nrows(), |at, _| 1.0 - 0.3 * at as f64);
        let load = kept.transpose() * multipliers;
        let y = DVector::from_vec(elimination.solve_transposed(load.as_slice()).expect("it is finite"));
        prop_assert!((a.transpose() * &y - load).amax() < 1e-9 * (1.0 + y.amax()));
    }
}
