//! What the explicit coordinates leave of the equations: a small full matrix, factored without any condition, so
//! that many positions can be taken side by side.

#![expect(clippy::inline_always, reason = "what is not inlined is not compiled for the widest registers")]

use crate::lanes::Numbers;

/// So small that adding it to anything else changes nothing, and its square is still a number.
const NOTHING: f64 = 1e-150;

/// `A = Q R` by plane rotations (Golub and Van Loan, *Matrix Computations*, 4th ed., §5.2.5): stable without a choice
/// of pivots, which would differ from one position to the next.
#[derive(Debug, Clone)]
pub(in super::super) struct Core<S> {
    size: usize,
    /// A by rows, then R.
    r: Vec<S>,
    /// Cosine and sine of each rotation: for each column the rows below it.
    turns: Vec<[S; 2]>,
}

impl<S: Numbers> Core<S> {
    pub(in super::super) fn new(size: usize) -> Self {
        let zero = S::from(0.0);
        Self { size, r: vec![zero; size * size], turns: vec![[zero; 2]; size * size.saturating_sub(1) / 2] }
    }

    /// The matrix, by rows, to be overwritten and factored.
    pub(in super::super) fn entries(&mut self) -> &mut [S] {
        &mut self.r
    }

    #[inline(always)]
    pub(in super::super) fn factor(&mut self) {
        let n = self.size;
        let mut at = 0;
        for column in 0..n {
            for row in column + 1..n {
                let (a, b) = (self.r[column * n + column] + NOTHING, self.r[row * n + column]);
                let long = (a * a + b * b).sqrt();
                let [cos, sin] = [a / long, b / long];
                self.turns[at] = [cos, sin];
                at += 1;
                self.r[column * n + column] = long;
                for other in column + 1..n {
                    let [p, q] = [self.r[column * n + other], self.r[row * n + other]];
                    self.r[column * n + other] = cos * p + sin * q;
                    self.r[row * n + other] = cos * q - sin * p;
                }
            }
        }
    }

    /// The last diagonal of R, which has the sign of the determinant, and the smallest one over the largest: small
    /// near a singular position.
    #[inline(always)]
    pub(in super::super) fn determinant(&self) -> [S; 2] {
        let n = self.size;
        let one = S::from(1.0);
        let Some(last) = self.r.last() else { return [one, one] };
        let (mut least, mut most) = (last.abs(), last.abs());
        for row in 0..n - 1 {
            let diagonal = self.r[row * n + row].abs();
            least = least.with(diagonal, f64::min);
            most = most.with(diagonal, f64::max);
        }
        [*last, least / most]
    }

    /// `A x = b` in place.
    #[inline(always)]
    pub(in super::super) fn solve(&self, x: &mut [S]) {
        let n = self.size;
        let mut at = 0;
        for column in 0..n {
            for row in column + 1..n {
                let [cos, sin] = self.turns[at];
                at += 1;
                let [p, q] = [x[column], x[row]];
                x[column] = cos * p + sin * q;
                x[row] = cos * q - sin * p;
            }
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
    pub(in super::super) fn solve_transposed(&self, y: &mut [S]) {
        let n = self.size;
        for column in 0..n {
            let mut sum = y[column];
            for row in 0..column {
                sum = sum - self.r[row * n + column] * y[row];
            }
            y[column] = sum / self.r[column * n + column];
        }
        let mut at = self.turns.len();
        for column in (0..n).rev() {
            for row in (column + 1..n).rev() {
                at -= 1;
                let [cos, sin] = self.turns[at];
                let [p, q] = [y[column], y[row]];
                y[column] = cos * p - sin * q;
                y[row] = cos * q + sin * p;
            }
        }
    }
}
