//! Full systems of equations with complex coefficients.

use nalgebra::{Complex, DMatrix};

use super::{LinalgError, MOST_DENSE, SINGULAR, finite, not_above, power_of_two_below, shape};

type Matrix = DMatrix<Complex<f64>>;

/// A factored complex matrix, ready for any number of right sides.
#[derive(Debug, Clone)]
pub struct ComplexLu {
    scaled: Matrix,
    factors: Matrix,
    exchanges: Vec<usize>,
    row_scale: Vec<f64>,
    column_scale: Vec<f64>,
    reciprocal_condition: f64,
}

/// Solves `A X = B` for a square complex `A`, a column of B each.
///
/// # Errors
/// `Shape`; `TooLarge` above [`MOST_DENSE`]; `NotFinite`; `Singular`; `NotConverged`.
pub fn solve_complex(a: &Matrix, b: &Matrix) -> Result<Matrix, LinalgError> {
    ComplexLu::new(a)?.solve(b)
}

impl ComplexLu {
    /// Factors a square matrix, its rows and columns first scaled to comparable size.
    ///
    /// # Errors
    /// `Shape`; `TooLarge` above [`MOST_DENSE`]; `NotFinite`; `Singular`, when fewer than three digits would be right.
    pub fn new(a: &Matrix) -> Result<Self, LinalgError> {
        let n = a.nrows();
        if !a.is_square() || n == 0 {
            return Err(LinalgError::Shape { rows: n, columns: a.ncols(), wanted: "a square matrix" });
        }
        not_above("unknowns of a full matrix", n, MOST_DENSE)?;
        finite(a.iter().flat_map(|entry| [&entry.re, &entry.im]))?;
        let mut scaled = a.clone();
        let row_scale: Vec<f64> = scaled.row_iter().map(|row| reciprocal_size(row.iter())).collect();
        for (mut row, scale) in scaled.row_iter_mut().zip(&row_scale) {
            row.iter_mut().for_each(|entry| *entry *= *scale);
        }
        let column_scale: Vec<f64> =
            scaled.column_iter().map(|column| reciprocal_size(column.iter())).collect();
        for (mut column, scale) in scaled.column_iter_mut().zip(&column_scale) {
            column.iter_mut().for_each(|entry| *entry *= *scale);
        }
        let mut factors = scaled.clone();
        let mut exchanges = Vec::with_capacity(n);
        for pivot in 0..n {
            let size = |row: &usize| factors[(*row, pivot)].norm_sqr();
            let best = (pivot..n).max_by(|p, q| size(p).total_cmp(&size(q))).unwrap_or(pivot);
            if size(&best) == 0.0 {
                return Err(LinalgError::Singular { reciprocal_condition: 0.0 });
            }
            factors.swap_rows(pivot, best);
            exchanges.push(best);
            let reciprocal = factors[(pivot, pivot)].inv();
            for row in pivot + 1..n {
                factors[(row, pivot)] *= reciprocal;
            }
            let (left, right) = factors.as_mut_slice().split_at_mut((pivot + 1) * n);
            let multipliers = &left[pivot * n + pivot + 1..];
            for column in right.chunks_exact_mut(n) {
                let (above, below) = column.split_at_mut(pivot + 1);
                let factor = above[pivot];
                if factor != Complex::ZERO {
                    for (entry, multiplier) in below.iter_mut().zip(multipliers) {
                        *entry -= multiplier * factor;
                    }
                }
            }
        }
        let mut lu = Self { scaled, factors, exchanges, row_scale, column_scale, reciprocal_condition: 1.0 };
        lu.reciprocal_condition = lu.reciprocal_condition();
        if lu.reciprocal_condition.is_nan() || lu.reciprocal_condition < SINGULAR {
            return Err(LinalgError::Singular { reciprocal_condition: lu.reciprocal_condition.max(0.0) });
        }
        Ok(lu)
    }

    /// Solves for each column of B, with one step of refinement.
    ///
    /// # Errors
    /// `Shape`; `NotFinite`; `NotConverged`.
    pub fn solve(&self, b: &Matrix) -> Result<Matrix, LinalgError> {
        let n = self.factors.nrows();
        if b.nrows() != n {
            return Err(shape(&DMatrix::zeros(b.nrows(), b.ncols()), "as many rows as the matrix has"));
        }
        finite(b.iter().flat_map(|entry| [&entry.re, &entry.im]))?;
        let mut solution = b.clone();
        for mut column in solution.column_iter_mut() {
            let mut right: Vec<Complex<f64>> =
                column.iter().zip(&self.row_scale).map(|(entry, scale)| entry * *scale).collect();
            let given = right.clone();
            self.substitute(&mut right);
            let mut left = self.residual(&given, &right);
            self.substitute(&mut left);
            for (x, correction) in right.iter_mut().zip(&left) {
                *x += correction;
            }
            let size = |vector: &[Complex<f64>]| vector.iter().map(Complex::l1_norm).fold(0.0, f64::max);
            let limit = 1e-13 * (size(&right) * n as f64 + size(&given));
            if size(&self.residual(&given, &right)) > limit {
                return Err(LinalgError::NotConverged);
            }
            for ((entry, x), scale) in column.iter_mut().zip(&right).zip(&self.column_scale) {
                *entry = x * *scale;
            }
        }
        finite(solution.iter().flat_map(|entry| [&entry.re, &entry.im]))?;
        Ok(solution)
    }

    fn residual(&self, b: &[Complex<f64>], x: &[Complex<f64>]) -> Vec<Complex<f64>> {
        let mut left = b.to_vec();
        for (column, x) in self.scaled.column_iter().zip(x) {
            for (left, a) in left.iter_mut().zip(column.iter()) {
                *left -= a * x;
            }
        }
        left
    }

    fn substitute(&self, x: &mut [Complex<f64>]) {
        let n = x.len();
        for (row, other) in self.exchanges.iter().enumerate() {
            x.swap(row, *other);
        }
        for column in 0..n {
            let known = x[column];
            for (x, l) in x[column + 1..].iter_mut().zip(&self.column(column)[column + 1..]) {
                *x -= l * known;
            }
        }
        for column in (0..n).rev() {
            let entries = self.column(column);
            x[column] /= entries[column];
            let known = x[column];
            for (x, u) in x[..column].iter_mut().zip(entries) {
                *x -= u * known;
            }
        }
    }

    /// `A⁻ᴴ x`
    fn substitute_adjoint(&self, x: &mut [Complex<f64>]) {
        let n = x.len();
        for column in 0..n {
            let entries = self.column(column);
            let sum: Complex<f64> = entries[..column].iter().zip(&*x).map(|(u, x)| u.conj() * x).sum();
            x[column] = (x[column] - sum) / entries[column].conj();
        }
        for column in (0..n).rev() {
            let entries = &self.column(column)[column + 1..];
            let sum: Complex<f64> = entries.iter().zip(&x[column + 1..]).map(|(l, x)| l.conj() * x).sum();
            x[column] -= sum;
        }
        for (row, other) in self.exchanges.iter().enumerate().rev() {
            x.swap(row, *other);
        }
    }

    /// `1/(‖A‖₁ ‖A⁻¹‖₁)` by Hager's estimate (Higham, Accuracy and Stability, 2nd ed., §15.3).
    fn reciprocal_condition(&self) -> f64 {
        let n = self.factors.nrows();
        let norm =
            self.scaled.column_iter().map(|column| column.iter().map(|a| a.norm()).sum()).fold(0.0, f64::max);
        let mut x = vec![Complex::new(1.0 / n as f64, 0.0); n];
        let mut inverse: f64 = 0.0;
        for _ in 0..5 {
            self.substitute(&mut x);
            let size = x.iter().map(|entry| entry.norm()).sum();
            if size <= inverse {
                break;
            }
            inverse = size;
            for entry in &mut x {
                let modulus = entry.norm();
                *entry = if modulus > 0.0 { *entry / modulus } else { Complex::ONE };
            }
            self.substitute_adjoint(&mut x);
            let largest = (0..n).max_by(|&p, &q| x[p].norm_sqr().total_cmp(&x[q].norm_sqr())).unwrap_or(0);
            x.fill(Complex::ZERO);
            x[largest] = Complex::ONE;
        }
        1.0 / (norm * inverse)
    }

    fn column(&self, column: usize) -> &[Complex<f64>] {
        let n = self.factors.nrows();
        &self.factors.as_slice()[column * n..(column + 1) * n]
    }
}

fn reciprocal_size<'a>(entries: impl Iterator<Item = &'a Complex<f64>>) -> f64 {
    1.0 / power_of_two_below(entries.map(|entry| entry.re.abs().max(entry.im.abs())).fold(0.0, f64::max))
}
