//! Reduction of a symmetric matrix to tridiagonal form by Householder reflections, in blocks.
//!
//! The reflections of a block are found on the matrix as it was before the block, which is then updated by one product
//! of matrices: so the matrix is read once for each reflection and written once for each block (J. J. Dongarra, S. J.
//! Hammarling, D. C. Sorensen, *Block reduction of matrices to condensed forms for eigenvalue computations*, J.
//! Comput. Appl. Math. 27, 1989).

use std::ops::Range;

use faer::{
    Accum, ColMut, Conj, MatMut, MatRef, Par,
    dyn_stack::{MemBuffer, MemStack},
    linalg::{
        householder::{
            apply_block_householder_on_the_left_in_place_scratch,
            apply_block_householder_on_the_left_in_place_with_conj, make_householder_in_place,
        },
        matmul::triangular::{self, BlockStructure},
    },
    reborrow::ReborrowMut as _,
};
use nalgebra::{DMatrix, DVector};
use rayon::{
    iter::{IndexedParallelIterator as _, ParallelIterator as _},
    slice::ParallelSliceMut as _,
};

use super::{view, view_mut};
use crate::simd::widest;

/// Reflections of a block: more would take longer to find than they save in the update.
const BLOCK: usize = 16;

/// Reflections that are applied to the eigenvectors at once.
const APPLIED: usize = 32;

/// Columns that a product with a vector takes at once, so that its sums are read and written less often.
const COLUMNS: usize = 4;

/// Entries of which the product with a vector is worth several threads.
const WORTH_THREADS: usize = 40_000;

/// Rows that are taken at once: more than one register has, so that latencies overlap.
const ROWS: usize = 8;

/// `A = Q T Qᵀ` with T tridiagonal.
pub(super) struct Tridiagonal {
    /// The diagonal of T.
    pub(super) diagonal: Vec<f64>,
    /// The entries of T below it, and a zero.
    pub(super) below: Vec<f64>,
    /// Of each reflection `1 − v vᵀ/τ` half of `vᵀ v`.
    taus: Vec<f64>,
    /// The vectors v below the first subdiagonal; there they have 1.
    reflections: DMatrix<f64>,
}

impl Tridiagonal {
    /// The reduction of a symmetric matrix, of which the lower half is read.
    pub(super) fn of(mut a: DMatrix<f64>, par: Par) -> Self {
        let n = a.nrows();
        let count = n - 1;
        let (mut diagonal, mut below, mut taus) = (vec![0.0; n], vec![0.0; n], vec![0.0; count]);
        // The vectors v and w of each reflection of a block, beside each other: after it A is A − V Wᵀ − W Vᵀ.
        let mut panel = vec![0.0; 2 * BLOCK * n];
        // The same with v and w exchanged.
        let mut swapped = panel.clone();
        let mut sums = vec![0.0; par.degree() * n];
        for first in (0..count).step_by(BLOCK) {
            let width = BLOCK.min(count - first);
            panel.fill(0.0);
            for k in 0..width {
                let (column, from) = (first + k, first + k + 1);
                let (known, new) = panel.split_at_mut(2 * k * n);
                let (v, w) = new[..2 * n].split_at_mut(n);
                let changed = &mut a.as_mut_slice()[column * n..][..n];
                update_column(known, n, column, &mut changed[column..]);
                diagonal[column] = changed[column];
                let (head, tail) = changed[from..].split_at_mut(1);
                taus[column] = make_householder_in_place(&mut head[0], ColMut::from_slice_mut(tail)).tau;
                below[column] = head[0];
                let (v, w) = (&mut v[from..], &mut w[from..]);
                v[0] = 1.0;
                v[1..].copy_from_slice(tail);
                symmetric_product(&a, from, v, &mut sums, par);
                for sum in sums.chunks_exact(n) {
                    for (w, sum) in w.iter_mut().zip(sum) {
                        *w += sum;
                    }
                }
                update_product(known, n, from, v, w);
                let per_tau = 1.0 / taus[column];
                let half = 0.5 * per_tau * per_tau * v.iter().zip(&*w).map(|(v, w)| v * w).sum::<f64>();
                for (w, v) in w.iter_mut().zip(&*v) {
                    *w = *w * per_tau - half * v;
                }
            }
            let (end, rest) = (first + width, n - first - width);
            for (pair, swapped) in panel.chunks_exact(2 * n).zip(swapped.chunks_exact_mut(2 * n)) {
                let (v, w) = pair.split_at(n);
                swapped[..n].copy_from_slice(w);
                swapped[n..].copy_from_slice(v);
            }
            let [left, right] = [&panel, &swapped].map(|of| {
                MatRef::from_column_major_slice(&of[..2 * width * n], n, 2 * width).subrows(end, rest)
            });
            let (lower, full) = (BlockStructure::TriangularLower, BlockStructure::Rectangular);
            let a = view_mut(&mut a).submatrix_mut(end, end, rest, rest);
            triangular::matmul(a, lower, Accum::Add, left, full, right.transpose(), full, -1.0, par);
        }
        diagonal[count] = a[(count, count)];
        Self { diagonal, below, taus, reflections: a }
    }

    /// The eigenvectors `Q u` of A from those of T, in place.
    pub(super) fn back_transform(&self, u: MatMut<'_, f64>, par: Par) {
        let count = self.taus.len();
        let mut u = u.subrows_mut(1, count);
        let mut memory = MemBuffer::new(apply_block_householder_on_the_left_in_place_scratch::<f64>(
            count,
            APPLIED,
            u.ncols(),
        ));
        for first in (0..count).step_by(APPLIED).rev() {
            let (rows, width) = (count - first, APPLIED.min(count - first));
            let v = view(&self.reflections).submatrix(first + 1, first, rows, width);
            // 1 − V F⁻¹ Vᵀ with F + Fᵀ = Vᵀ V.
            let mut factor =
                DMatrix::from_diagonal(&DVector::from_column_slice(&self.taus[first..first + width]));
            let (top, rest) = v.split_at_row(width);
            let (strict, unit) = (BlockStructure::StrictTriangularUpper, BlockStructure::UnitTriangularLower);
            let (full, unit_above) = (BlockStructure::Rectangular, BlockStructure::UnitTriangularUpper);
            for (accum, v, above, below) in
                [(Accum::Replace, top, unit_above, unit), (Accum::Add, rest, full, full)]
            {
                let factor = view_mut(&mut factor);
                triangular::matmul(factor, strict, accum, v.transpose(), above, v, below, 1.0, par);
            }
            apply_block_householder_on_the_left_in_place_with_conj(
                v,
                view(&factor),
                Conj::No,
                u.rb_mut().subrows_mut(first, rows),
                par,
                MemStack::new(&mut memory),
            );
        }
    }
}

/// Takes from a column, from its diagonal on, what the reflections before it in the block take from it.
fn update_column(panel: &[f64], n: usize, column: usize, changed: &mut [f64]) {
    widest(
        #[inline(always)]
        || {
            for (v, w) in reflections(panel, n, column) {
                subtract([v, w], [w[0], v[0]], changed);
            }
        },
    );
}

/// Takes from the product `A v` of a new reflection, from a row on, what those before it in the block take from A.
fn update_product(panel: &[f64], n: usize, from: usize, new: &[f64], product: &mut [f64]) {
    widest(
        #[inline(always)]
        || {
            for (v, w) in reflections(panel, n, from) {
                let [of_v, of_w] = dot([v, w], new);
                subtract([v, w], [of_w, of_v], product);
            }
        },
    );
}

/// The vectors v and w of the reflections of a block, from a row on.
fn reflections(panel: &[f64], n: usize, from: usize) -> impl Iterator<Item = (&[f64], &[f64])> {
    panel.chunks_exact(2 * n).map(move |pair| (&pair[from..n], &pair[n + from..]))
}

/// Subtracts multiples of two columns.
#[inline(always)]
fn subtract([v, w]: [&[f64]; 2], [of_v, of_w]: [f64; 2], y: &mut [f64]) {
    for ((y, v), w) in y.iter_mut().zip(v).zip(w) {
        *y -= v * of_v + w * of_w;
    }
}

/// The scalar products of two columns with a third.
#[inline(always)]
fn dot(columns: [&[f64]; 2], x: &[f64]) -> [f64; 2] {
    let mut totals = [0.0; 2];
    for k in 0..2 {
        let mut sums = [0.0; 2 * ROWS];
        let (blocks, rest) = x.as_chunks::<{ 2 * ROWS }>();
        let (of_column, of_rest) = columns[k].as_chunks::<{ 2 * ROWS }>();
        for (block, of_column) in blocks.iter().zip(of_column) {
            for row in 0..2 * ROWS {
                sums[row] += block[row] * of_column[row];
            }
        }
        for (x, of_rest) in rest.iter().zip(of_rest) {
            totals[k] += x * of_rest;
        }
        for sum in sums {
            totals[k] += sum;
        }
    }
    totals
}

/// The product of the trailing block of a symmetric matrix, from a row and column on, with a vector: as the sum of
/// columns, one for each thread. The lower half is read.
fn symmetric_product(a: &DMatrix<f64>, from: usize, x: &[f64], parts: &mut [f64], par: Par) {
    let n = a.nrows();
    let (size, degree) = (n - from, par.degree());
    parts.fill(0.0);
    let part = |number: usize| {
        // So many columns that all parts have the same number of entries.
        let share = number as f64 / degree as f64;
        ((1.0 - (1.0 - share).sqrt()) * size as f64) as usize
    };
    let lower = &a.as_slice()[from * n..];
    let each = |(number, sum): (usize, &mut [f64])| {
        widest(
            #[inline(always)]
            || add_symmetric_product(lower, n, part(number)..part(number + 1), x, &mut sum[..size]),
        );
    };
    if degree > 1 && size * size / 2 >= WORTH_THREADS {
        parts.par_chunks_exact_mut(n).enumerate().for_each(each);
    } else {
        parts.chunks_exact_mut(n).enumerate().for_each(each);
    }
}

/// Adds to `y` what columns of the lower half of a symmetric matrix, which begin a row later each, and their mirror
/// images contribute to `A x`.
#[inline(always)]
fn add_symmetric_product(lower: &[f64], n: usize, columns: Range<usize>, x: &[f64], y: &mut [f64]) {
    let size = x.len();
    let column = |at: usize, row: usize| &lower[at * n + (n - size) + row..(at + 1) * n];
    let mut at = columns.start;
    while at < columns.end {
        let count = COLUMNS.min(columns.end - at);
        for one in at..at + count {
            // Of the triangle above the rows that all of the columns have.
            y[one] += column(one, one)[0] * x[one];
            for row in one + 1..at + count {
                let entry = column(one, row)[0];
                y[row] += entry * x[one];
                y[one] += entry * x[row];
            }
        }
        let begin = at + count;
        if count == COLUMNS {
            let of = [column(at, begin), column(at + 1, begin), column(at + 2, begin), column(at + 3, begin)];
            let weights = [x[at], x[at + 1], x[at + 2], x[at + 3]];
            let sums = columns_product(of, weights, &x[begin..], &mut y[begin..]);
            for (y, sum) in y[at..begin].iter_mut().zip(sums) {
                *y += sum;
            }
        } else {
            for one in at..begin {
                let [sum] = columns_product([column(one, begin)], [x[one]], &x[begin..], &mut y[begin..]);
                y[one] += sum;
            }
        }
        at = begin;
    }
}

/// Adds multiples of columns to `y`, and gives their products with `x`.
#[inline(always)]
fn columns_product<const N: usize>(
    columns: [&[f64]; N],
    weights: [f64; N],
    x: &[f64],
    y: &mut [f64],
) -> [f64; N] {
    let (blocks, rest) = (x.len() / ROWS, x.len() % ROWS);
    let mut sums = [[0.0; ROWS]; N];
    // Loops over numbers: the functions of arrays that call a closure are not always inlined.
    let mut of_columns = [[].as_slice(); N];
    for k in 0..N {
        of_columns[k] = &columns[k].as_chunks::<ROWS>().0[..blocks];
    }
    let (of_x, of_y) = (&x.as_chunks::<ROWS>().0[..blocks], &mut y.as_chunks_mut::<ROWS>().0[..blocks]);
    for block in 0..blocks {
        let mut sum = of_y[block];
        for k in 0..N {
            for row in 0..ROWS {
                let entry = of_columns[k][block][row];
                sum[row] += entry * weights[k];
                sums[k][row] += entry * of_x[block][row];
            }
        }
        of_y[block] = sum;
    }
    let mut totals = [0.0; N];
    for k in 0..N {
        totals[k] = sums[k].iter().sum();
        for row in x.len() - rest..x.len() {
            y[row] += columns[k][row] * weights[k];
            totals[k] += columns[k][row] * x[row];
        }
    }
    totals
}
