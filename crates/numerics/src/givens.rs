//! QR factorisation by plane rotations of a small matrix with a known pattern of zeros: factored without any branch, so
//! that several matrices can be taken in the lanes of a SIMD vector.

#![expect(clippy::inline_always, reason = "what is not inlined is not compiled for the widest registers")]

use std::collections::BTreeSet;

use crate::simd::SimdReal;

/// Added to the diagonal before a plane rotation, so that a column of zeros has a direction: its square is above the
/// smallest number, and it changes no number above 10⁻¹³⁴.
const ROTATION_GUARD: f64 = 1e-150;

/// Orders of rows and columns of a square matrix that take few rotations, from the places and columns of the entries of
/// each row: of what is left, the column that the fewest rows have goes first (J. A. George, M. T. Heath, *Linear
/// Algebra and its Applications* 34, 1980). So a loop that depends on another one is separated from it.
pub fn ordering(rows: &[Vec<(usize, usize)>]) -> [Vec<usize>; 2] {
    let mut left: Vec<(usize, BTreeSet<usize>)> =
        rows.iter().map(|row| row.iter().map(|(_, column)| *column).collect()).enumerate().collect();
    let mut columns: Vec<usize> = (0..rows.len()).collect();
    let mut ordered = [Vec::new(), Vec::new()];
    while !left.is_empty() {
        let rows_with = |column: usize| left.iter().filter(|(_, row)| row.contains(&column)).count();
        let next = (0..columns.len()).min_by_key(|&at| rows_with(columns[at])).unwrap_or(0);
        let column = columns.remove(next);
        let first = left.iter().position(|(_, row)| row.contains(&column)).unwrap_or(0);
        let (row, mut entries) = left.remove(first);
        // A rotation leaves in both rows what either had.
        for (_, other) in left.iter_mut().filter(|(_, other)| other.contains(&column)) {
            entries.extend(other.iter());
            other.clone_from(&entries);
            other.remove(&column);
        }
        ordered[0].push(row);
        ordered[1].push(column);
    }
    ordered
}

/// `A = Q R` by plane rotations (Golub and Van Loan, *Matrix Computations*, 4th ed., §5.2.5): stable without a choice
/// of pivots, which would differ from one position to the next.
#[derive(Debug, Clone)]
pub struct GivensQr<S> {
    size: usize,
    /// The rotations, in order: the column, which is the row of its diagonal too, and the row below.
    pairs: Vec<[usize; 2]>,
    /// A by rows, then R.
    r: Vec<S>,
    /// Cosine and sine of each rotation.
    turns: Vec<[S; 2]>,
    /// The diagonals of R that no rotation has made positive.
    signed: Vec<usize>,
}

impl<S: SimdReal> GivensQr<S> {
    /// For matrices whose rows have these columns.
    pub fn new(rows: &[Vec<(usize, usize)>]) -> Self {
        let size = rows.len();
        let zero = S::from(0.0);
        let mut entries = vec![vec![false; size]; size];
        for (entries, row) in entries.iter_mut().zip(rows) {
            for &(_, column) in row {
                entries[column] = true;
            }
        }
        let mut pairs = Vec::new();
        let mut signed = Vec::new();
        for column in 0..size {
            let before = pairs.len();
            for row in column + 1..size {
                if entries[row][column] {
                    pairs.push([column, row]);
                    for other in column + 1..size {
                        let either = entries[column][other] || entries[row][other];
                        (entries[column][other], entries[row][other]) = (either, either);
                    }
                }
            }
            if pairs.len() == before {
                signed.push(column);
            }
        }
        Self { size, turns: vec![[zero; 2]; pairs.len()], pairs, r: vec![zero; size * size], signed }
    }

    /// The matrix, by rows, to be overwritten and factored.
    pub fn entries(&mut self) -> &mut [S] {
        &mut self.r
    }

    /// Factors the matrix in the entries.
    #[inline(always)]
    pub fn factor(&mut self) {
        let n = self.size;
        for (turn, &[column, row]) in self.turns.iter_mut().zip(&self.pairs) {
            let (a, b) = (self.r[column * n + column] + ROTATION_GUARD, self.r[row * n + column]);
            let square = a * a + b * b;
            let short = S::from(1.0) / square.sqrt();
            let (cos, sin) = (a * short, b * short);
            *turn = [cos, sin];
            self.r[column * n + column] = square * short;
            for other in column + 1..n {
                let [p, q] = [self.r[column * n + other], self.r[row * n + other]];
                self.r[column * n + other] = cos * p + sin * q;
                self.r[row * n + other] = cos * q - sin * p;
            }
        }
    }

    /// The product of the diagonals of R whose signs are left open, which has the sign of the determinant, and the
    /// smallest diagonal over the largest: small near a singular position.
    #[inline(always)]
    pub fn determinant(&self) -> [S; 2] {
        let n = self.size;
        let one = S::from(1.0);
        let Some(last) = self.r.last() else { return [one, one] };
        let (mut least, mut most) = (last.abs(), last.abs());
        for row in 0..n - 1 {
            let diagonal = self.r[row * n + row].abs();
            least = least.with(diagonal, f64::min);
            most = most.with(diagonal, f64::max);
        }
        let mut product = one;
        for &row in &self.signed {
            product = product * self.r[row * n + row];
        }
        [product, least / most]
    }

    /// `A x = b` in place.
    #[inline(always)]
    pub fn solve(&self, x: &mut [S]) {
        let n = self.size;
        for ([cos, sin], &[column, row]) in self.turns.iter().zip(&self.pairs) {
            let [p, q] = [x[column], x[row]];
            x[column] = *cos * p + *sin * q;
            x[row] = *cos * q - *sin * p;
        }
        for row in (0..n).rev() {
            let mut sum = x[row];
            for column in row + 1..n {
                sum = sum - self.r[row * n + column] * x[column];
            }
            x[row] = sum / self.r[row * n + row];
        }
    }

    /// `Aᵀ y = g` in place.
    #[inline(always)]
    pub fn solve_transposed(&self, y: &mut [S]) {
        let n = self.size;
        for column in 0..n {
            let mut sum = y[column];
            for row in 0..column {
                sum = sum - self.r[row * n + column] * y[row];
            }
            y[column] = sum / self.r[column * n + column];
        }
        for ([cos, sin], &[column, row]) in self.turns.iter().zip(&self.pairs).rev() {
            let [p, q] = [y[column], y[row]];
            y[column] = *cos * p - *sin * q;
            y[row] = *cos * q + *sin * p;
        }
    }
}
