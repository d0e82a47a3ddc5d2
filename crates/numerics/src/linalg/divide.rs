//! Eigenvalues and eigenvectors of a symmetric tridiagonal matrix by divide and conquer.
//!
//! The matrix is a block diagonal one and one of rank one, `ρ z zᵀ`. In the eigenvectors of the two blocks it is a
//! diagonal matrix with a rank-one update, whose eigenvalues are the roots of the secular equation (J. J. M. Cuppen,
//! *Numer. Math.* 36, 1981). Its vectors are those of the update that has exactly the computed roots, so that they are
//! orthogonal (M. Gu, S. C. Eisenstat, *SIAM J. Matrix Anal. Appl.* 16, 1995). The roots are found sixteen at a time.

use faer::{
    Accum, MatMut, Par,
    diag::{DiagMut, DiagRef},
    dyn_stack::{MemBuffer, MemStack},
    linalg::{
        evd::{ComputeEigenvectors, self_adjoint_evd_scratch, tridiagonal_self_adjoint_evd},
        matmul::matmul,
    },
    reborrow::{Reborrow as _, ReborrowMut as _},
};

use super::{LinalgError, largest};
use crate::{
    Real as _,
    simd::{SimdVector, WIDTH, widest},
};

/// Matrices up to this size are not divided.
const UNDIVIDED: usize = 16;

/// The most iterations of a root: it takes about six.
const MOST_ITERATIONS: usize = 64;

/// A residual of the secular equation that is rounding, relative to the sum of the sizes of its terms.
const ROUNDING: f64 = 16.0 * f64::EPSILON;

/// Replaces the diagonal of a tridiagonal matrix by its eigenvalues, ascending, and fills in the vectors; `below` has
/// a zero at its end.
pub(super) fn tridiagonal_eigen(
    diagonal: &mut [f64],
    below: &[f64],
    vectors: MatMut<'_, f64>,
    par: Par,
) -> Result<(), LinalgError> {
    let n = diagonal.len();
    let size = if n > UNDIVIDED { n } else { 0 };
    let mut work = [0, 1].map(|_| faer::Mat::zeros(size, size));
    divide(diagonal, below, vectors, work.each_mut().map(faer::Mat::as_mut), par)
}

/// The same with room for the vectors of the update and for their product with those of the blocks.
fn divide(
    d: &mut [f64],
    below: &[f64],
    mut q: MatMut<'_, f64>,
    [mut s, mut product]: [MatMut<'_, f64>; 2],
    par: Par,
) -> Result<(), LinalgError> {
    let n = d.len();
    if n <= UNDIVIDED {
        return qr_algorithm(d, below, Some(q));
    }
    let half = n / 2;
    let coupling = below[half - 1];
    d[half - 1] -= coupling.abs();
    d[half] -= coupling.abs();
    {
        let (d1, d2) = d.split_at_mut(half);
        let (below1, below2) = below.split_at(half);
        let (q1, _, _, q2) = q.rb_mut().split_at_mut(half, half);
        let (s1, _, _, s2) = s.rb_mut().split_at_mut(half, half);
        let (product1, _, _, product2) = product.rb_mut().split_at_mut(half, half);
        let first = || divide(d1, below1, q1, [s1, product1], par);
        let second = || divide(d2, below2, q2, [s2, product2], par);
        let (first, second) = if par.degree() > 1 { rayon::join(first, second) } else { (first(), second()) };
        first.and(second)?;
    }
    let (q1, _, _, q2) = q.rb().split_at(half, half);
    let z: Vec<f64> =
        q1.row(half - 1).iter().copied().chain(q2.row(0).iter().map(|x| x * coupling.signum())).collect();
    RankOneUpdate::new(d, z, coupling.abs()).solve(d, s.rb_mut());
    let (s1, s2) = s.rb().split_at_row(half);
    let (product1, product2) = product.rb_mut().split_at_row_mut(half);
    matmul(product1, Accum::Replace, q1, s1, 1.0, par);
    matmul(product2, Accum::Replace, q2, s2, 1.0, par);
    q.copy_from(product);
    Ok(())
}

/// The same by the QR algorithm, with vectors if they are wanted.
pub(super) fn qr_algorithm(
    diagonal: &mut [f64],
    below: &[f64],
    vectors: Option<MatMut<'_, f64>>,
) -> Result<(), LinalgError> {
    let wanted = if vectors.is_some() { ComputeEigenvectors::Yes } else { ComputeEigenvectors::No };
    let (known, settings) = (diagonal.to_vec(), <_>::default());
    let scratch = self_adjoint_evd_scratch::<f64>(diagonal.len(), wanted, Par::Seq, settings);
    #[expect(
        clippy::disallowed_methods,
        reason = "finite and scaled, and checked against its equation by the callers"
    )]
    tridiagonal_self_adjoint_evd(
        DiagRef::from_slice(&known),
        DiagRef::from_slice(below),
        DiagMut::from_slice_mut(diagonal),
        vectors,
        Par::Seq,
        MemStack::new(&mut MemBuffer::new(scratch)),
        settings,
    )
    .map_err(|_| LinalgError::NotConverged)
}

/// `D + ρ z zᵀ`, less what is an eigenvalue already.
struct RankOneUpdate {
    /// The diagonal entries that are left, ascending, and those of z.
    poles: Vec<f64>,
    z: Vec<f64>,
    rho: f64,
    /// Their rows, and those of the entries that are eigenvalues.
    rows: Vec<usize>,
    deflated: Vec<usize>,
    /// Plane rotations before which this holds: rows, cosine and sine.
    rotations: Vec<([usize; 2], [f64; 2])>,
}

/// Roots of the secular equation: each by the pole that is nearest, and the distance from it.
struct Roots {
    origins: Vec<f64>,
    offsets: Vec<f64>,
}

impl RankOneUpdate {
    /// Takes out entries whose part of z, or whose distance to the next one, is rounding (deflation). A pair of which
    /// the latter holds is rotated so that one of them has no part of z.
    fn new(d: &mut [f64], mut z: Vec<f64>, rho: f64) -> Self {
        let mut order: Vec<usize> = (0..d.len()).collect();
        order.sort_by(|&i, &j| d[i].total_cmp(&d[j]));
        let rounding = 8.0 * f64::EPSILON * largest(d).max(rho);
        let (mut rows, mut deflated, mut rotations) = (Vec::new(), Vec::new(), Vec::new());
        let mut last: Option<usize> = None;
        for row in order {
            if rho * z[row].abs() <= rounding {
                deflated.push(row);
                continue;
            }
            if let Some(before) = last {
                let size = z[before].hypot(z[row]);
                let (cos, sin) = (z[row] / size, -z[before] / size);
                if ((d[row] - d[before]) * cos * sin).abs() <= rounding {
                    (z[before], z[row]) = (0.0, size);
                    let [low, high] = [d[before], d[row]];
                    d[before] = low * cos * cos + high * sin * sin;
                    d[row] = low * sin * sin + high * cos * cos;
                    rotations.push(([before, row], [cos, sin]));
                    deflated.push(before);
                } else {
                    rows.push(before);
                }
            }
            last = Some(row);
        }
        rows.extend(last);
        let poles = rows.iter().map(|&row| d[row]).collect();
        let z = rows.iter().map(|&row| z[row]).collect();
        Self { poles, z, rho, rows, deflated, rotations }
    }

    /// The eigenvalues, ascending, and the vectors.
    fn solve(mut self, d: &mut [f64], mut s: MatMut<'_, f64>) {
        let n = d.len();
        let roots = self.roots();
        self.recompute_z(&roots);
        let of_roots = roots.origins.iter().zip(&roots.offsets).map(|(origin, offset)| origin + offset);
        let mut values: Vec<(f64, usize)> = of_roots.zip(0..).collect();
        values.extend(self.deflated.iter().map(|&row| (d[row], row + n)));
        values.sort_by(|p, q| p.0.total_cmp(&q.0));
        let mut vector = vec![0.0; self.poles.len()];
        for (column, &(value, number)) in values.iter().enumerate() {
            d[column] = value;
            let s = s
                .rb_mut()
                .col_mut(column)
                .try_as_col_major_mut()
                .expect("columns are contiguous")
                .as_slice_mut();
            s.fill(0.0);
            if number >= n {
                s[number - n] = 1.0;
            } else {
                let size = self.vector(roots.origins[number], roots.offsets[number], &mut vector);
                for (x, &row) in vector.iter().zip(&self.rows) {
                    s[row] = x / size;
                }
            }
            for &([p, q], [cos, sin]) in self.rotations.iter().rev() {
                [s[p], s[q]] = [cos * s[p] - sin * s[q], sin * s[p] + cos * s[q]];
            }
        }
    }

    /// The roots of `1/ρ + Σ zᵢ²/(dᵢ − λ)`: one between each pole and the next, the last one above all of them.
    fn roots(&self) -> Roots {
        let count = self.poles.len();
        let mut roots = Roots { origins: vec![0.0; count], offsets: vec![0.0; count] };
        for first in (0..count).step_by(WIDTH) {
            let [origin, offset] = widest(
                #[inline(always)]
                || self.block(first),
            );
            let width = WIDTH.min(count - first);
            roots.origins[first..first + width].copy_from_slice(&origin.0[..width]);
            roots.offsets[first..first + width].copy_from_slice(&offset.0[..width]);
        }
        roots
    }

    /// Roots from one on, each by its origin and its offset. The function is replaced by one with the two poles beside
    /// a root, whose parts have its slopes: the middle way of R.-C. Li, *Solving secular equations stably and
    /// efficiently* (LAPACK Working Note 89, 1994), within bounds that are halved where it leads out of them.
    #[inline(always)]
    fn block(&self, first: usize) -> [SimdVector; 2] {
        let last = self.poles.len() - 1;
        let per_rho = 1.0 / self.rho;
        let beyond = self.poles[last] + self.rho * self.z.iter().map(|z| z * z).sum::<f64>();
        let left = SimdVector::of(|lane| self.poles[(first + lane).min(last)]);
        let right = SimdVector::of(|lane| self.poles.get(first + lane + 1).copied().unwrap_or(beyond));
        let half = (right - left) * 0.5;
        let mut terms = self.terms(first, left, half);
        let (mut origin, mut offset, mut low, mut high) = (left, half, half * 0.0, half);
        for lane in 0..WIDTH {
            let above = terms[0].0[lane] + terms[2].0[lane] + per_rho < 0.0;
            let is_last = first + lane >= last;
            if above && is_last {
                (low.0[lane], high.0[lane]) = (half.0[lane], 2.0 * half.0[lane]);
            } else if above {
                (origin.0[lane], offset.0[lane]) = (right.0[lane], -half.0[lane]);
                (low.0[lane], high.0[lane]) = (-half.0[lane], 0.0);
            }
        }
        for _ in 0..MOST_ITERATIONS {
            let [psi, psi_slope, phi, phi_slope] = terms;
            let mut moved = false;
            for lane in 0..WIDTH {
                let (psi, phi, now) = (psi.0[lane], phi.0[lane], offset.0[lane]);
                let (of_psi, of_phi) = (psi_slope.0[lane], phi_slope.0[lane]);
                let value = per_rho + psi + phi;
                let (to_left, to_right) =
                    (left.0[lane] - origin.0[lane] - now, right.0[lane] - origin.0[lane] - now);
                let c = value - to_left * of_psi - to_right * of_phi;
                let a = (to_left + to_right) * value - to_left * to_right * (of_psi + of_phi);
                let b = to_left * to_right * value;
                let root = (a * a - 4.0 * b * c).max(0.0).sqrt();
                let step = if a <= 0.0 { (a - root) / (2.0 * c) } else { 2.0 * b / (a + root) };
                high.0[lane] = if value > 0.0 { now } else { high.0[lane] };
                low.0[lane] = if value > 0.0 { low.0[lane] } else { now };
                let middle = 0.5 * (low.0[lane] + high.0[lane]);
                let next =
                    if now + step > low.0[lane] && now + step < high.0[lane] { now + step } else { middle };
                let is_found = value.abs() <= ROUNDING * (per_rho - psi + phi);
                let next = if is_found { now } else { next };
                moved |= next != now;
                offset.0[lane] = next;
            }
            if !moved {
                break;
            }
            terms = self.terms(first, origin, offset);
        }
        [origin, offset]
    }

    /// The sums of `zᵢ²/(dᵢ − λ)` and their slopes over the poles up to each root, then over those beyond it.
    #[inline(always)]
    fn terms(&self, first: usize, origin: SimdVector, offset: SimdVector) -> [SimdVector; 4] {
        let count = self.poles.len();
        let zero = SimdVector::from(0.0);
        let (mut up_to, mut beyond) = ([zero; 2], [zero; 2]);
        let term = |pole: usize| SimdVector::from(self.z[pole]) / ((origin - self.poles[pole]) + offset);
        for pole in 0..first {
            let term = term(pole);
            up_to = [up_to[0] - term * self.z[pole], up_to[1] + term * term];
        }
        let end = (first + WIDTH).min(count);
        for pole in first..end {
            let term = term(pole);
            let mut of = term;
            for lane in 0..WIDTH {
                of.0[lane] = if pole <= first + lane { term.0[lane] } else { 0.0 };
            }
            let rest = term - of;
            up_to = [up_to[0] - of * self.z[pole], up_to[1] + of * of];
            beyond = [beyond[0] - rest * self.z[pole], beyond[1] + rest * rest];
        }
        for pole in end..count {
            let term = term(pole);
            beyond = [beyond[0] - term * self.z[pole], beyond[1] + term * term];
        }
        [up_to[0], up_to[1], beyond[0], beyond[1]]
    }

    /// Makes z that of the update with exactly these roots: `zᵢ² = Π (λⱼ − dᵢ) / (ρ Π (dⱼ − dᵢ))`, up to the factor ρ
    /// (K. Löwner).
    fn recompute_z(&mut self, roots: &Roots) {
        let count = self.poles.len();
        for first in (0..count).step_by(WIDTH) {
            let products = widest(
                #[inline(always)]
                || {
                    let of = SimdVector::of(|lane| self.poles[(first + lane).min(count - 1)]);
                    let mut products = SimdVector::from(1.0);
                    for root in 0..count {
                        let above = (SimdVector::from(roots.origins[root]) - of) + roots.offsets[root];
                        let mut gap = SimdVector::from(self.poles[root]) - of;
                        if root >= first && root < first + WIDTH {
                            gap.0[root - first] = 1.0;
                        }
                        products = products * (above / gap);
                    }
                    products.abs().sqrt()
                },
            );
            for (z, size) in self.z[first..].iter_mut().zip(products.0) {
                *z = size.copysign(*z);
            }
        }
    }

    /// The vector of a root, and its length.
    fn vector(&self, origin: f64, offset: f64, vector: &mut [f64]) -> f64 {
        widest(
            #[inline(always)]
            || {
                for ((x, pole), z) in vector.iter_mut().zip(&self.poles).zip(&self.z) {
                    *x = z / ((pole - origin) - offset);
                }
                let (blocks, rest) = vector.as_chunks::<WIDTH>();
                let mut sums = SimdVector::from(0.0);
                for block in blocks {
                    sums = sums + SimdVector(*block) * SimdVector(*block);
                }
                let rest: f64 = rest.iter().map(|x| x * x).sum();
                (sums.0.iter().sum::<f64>() + rest).sqrt()
            },
        )
    }
}
