//! Frequency response of many degrees of freedom: directly, and as sums over modes or poles.

use std::thread;

use faer::{Accum, MatMut, MatRef, Par, linalg::matmul::matmul};
use nalgebra::{Complex, DMatrix, DVector};

use dalembert_numerics::{
    linalg::{self, LinalgError},
    simd::widest,
};

/// So many frequencies are worked at a time: they stay in the nearest cache.
const BLOCK: usize = 256;

/// From so many products on, several threads take less time than one.
const WORTH_THREADS: usize = 20_000_000;

/// Dynamic stiffness `K − ω² M + i ω C`, of mass, damping and stiffness in this order, n by n each.
pub fn dynamic_stiffness([m, c, k]: [&DMatrix<f64>; 3], frequency: f64) -> DMatrix<Complex<f64>> {
    DMatrix::from_fn(k.nrows(), k.ncols(), |i, j| {
        Complex::new(k[(i, j)] - frequency * frequency * m[(i, j)], frequency * c[(i, j)])
    })
}

/// `(K − ω² M + i ω C) X = F`: the complex amplitudes under a harmonic force.
///
/// # Errors
/// `Shape`; `NotFinite`; `Singular` at an undamped natural frequency.
pub fn direct(
    m: &DMatrix<f64>,
    c: &DMatrix<f64>,
    k: &DMatrix<f64>,
    force: &DVector<Complex<f64>>,
    frequency: f64,
) -> Result<DVector<Complex<f64>>, LinalgError> {
    let right = DMatrix::from_column_slice(force.len(), 1, force.as_slice());
    Ok(linalg::solve_complex(&dynamic_stiffness([m, c, k], frequency), &right)?.column(0).into_owned())
}

/// Real and imaginary parts of `Σ rᵣ/(ωᵣ² − ω² + 2iζᵣωᵣω)` at each frequency; `decays` are the 2ζᵣωᵣ.
///
/// A term without damping at its own frequency is infinite: no finite answer is claimed for it.
///
/// # Panics
/// Unless modes and frequencies are as many each time.
pub fn sum_of_modes(
    residues: &[f64],
    squares: &[f64],
    decays: &[f64],
    frequencies: &[f64],
    real: &mut [f64],
    imaginary: &mut [f64],
) {
    assert!(residues.len() == squares.len() && residues.len() == decays.len(), "as many modes each time");
    assert!(
        frequencies.len() == real.len() && frequencies.len() == imaginary.len(),
        "as many frequencies each time"
    );
    widest(
        #[inline(always)]
        || {
            let blocks =
                real.chunks_mut(BLOCK).zip(imaginary.chunks_mut(BLOCK)).zip(frequencies.chunks(BLOCK));
            for ((real, imaginary), frequencies) in blocks {
                real.fill(0.0);
                imaginary.fill(0.0);
                for ((residue, square), decay) in residues.iter().zip(squares).zip(decays) {
                    for ((re, im), w) in real.iter_mut().zip(imaginary.iter_mut()).zip(frequencies) {
                        let (u, v) = (square - w * w, decay * w);
                        let s = residue / (u * u + v * v);
                        *re += u * s;
                        *im -= v * s;
                    }
                }
            }
        },
    );
}

/// Real and imaginary parts of a column of H, all masses under a force on one, at each frequency: columns of
/// `real` and `imaginary`, as many as there are frequencies, `Σ φᵣ φᵣⱼ/(ωᵣ² − ω² + 2iζᵣωᵣω)`.
///
/// # Panics
/// Unless the sizes fit each other.
pub fn column_of_modes(
    shapes: &DMatrix<f64>,
    driven: usize,
    squares: &[f64],
    decays: &[f64],
    frequencies: &[f64],
    real: &mut DMatrix<f64>,
    imaginary: &mut DMatrix<f64>,
) {
    let (n, modes) = shapes.shape();
    assert!(squares.len() == modes && decays.len() == modes && driven < n, "as many modes each time");
    assert!(
        real.shape() == (n, frequencies.len()) && imaginary.shape() == real.shape(),
        "a column for each frequency"
    );
    let residues: Vec<f64> = shapes.row(driven).iter().copied().collect();
    let shapes = MatRef::from_column_major_slice(shapes.as_slice(), n, modes);
    share_out(n * modes, frequencies, real, imaginary, |frequencies, real, imaginary| {
        let (mut re, mut im) = (vec![0.0; modes * BLOCK], vec![0.0; modes * BLOCK]);
        let blocks = real.chunks_mut(n * BLOCK).zip(imaginary.chunks_mut(n * BLOCK));
        for ((real, imaginary), frequencies) in blocks.zip(frequencies.chunks(BLOCK)) {
            widest(
                #[inline(always)]
                || {
                    let lines = re.chunks_exact_mut(modes).zip(im.chunks_exact_mut(modes));
                    for ((re, im), w) in lines.zip(frequencies) {
                        let terms = re.iter_mut().zip(im.iter_mut()).zip(&residues).zip(squares).zip(decays);
                        for ((((re, im), residue), square), decay) in terms {
                            let (u, v) = (square - w * w, decay * w);
                            let s = residue / (u * u + v * v);
                            *re = u * s;
                            *im = -v * s;
                        }
                    }
                },
            );
            for (whole, parts) in [(real, &re), (imaginary, &im)] {
                multiply(shapes, &parts[..modes * frequencies.len()], whole);
            }
        }
    });
}

/// Real and imaginary parts of `Σ rᵣ/(iω − λᵣ)` over all roots, each at each frequency; for damping of any kind.
///
/// Two conjugate roots in a row count as a pair with conjugate residues.
///
/// # Panics
/// Unless roots and frequencies are as many each time.
pub fn sum_of_poles(
    residues: &[Complex<f64>],
    roots: &[Complex<f64>],
    frequencies: &[f64],
    real: &mut [f64],
    imaginary: &mut [f64],
) {
    assert!(residues.len() == roots.len(), "as many roots each time");
    assert!(
        frequencies.len() == real.len() && frequencies.len() == imaginary.len(),
        "as many frequencies each time"
    );
    let terms = terms(roots);
    let weights: Vec<[f64; 2]> = terms.iter().map(|term| term.weights(residues[term.at])).collect();
    widest(
        #[inline(always)]
        || {
            let blocks =
                real.chunks_mut(BLOCK).zip(imaginary.chunks_mut(BLOCK)).zip(frequencies.chunks(BLOCK));
            for ((real, imaginary), frequencies) in blocks {
                real.fill(0.0);
                imaginary.fill(0.0);
                for (term, [even, odd]) in terms.iter().zip(&weights) {
                    for ((re, im), w) in real.iter_mut().zip(imaginary.iter_mut()).zip(frequencies) {
                        let [p, q, r, s] = term.at(*w);
                        *re += even * p - odd * s;
                        *im += even * q + odd * r;
                    }
                }
            }
        },
    );
}

/// A column of H for damping of any kind: `shapes` and `inputs` are those of the poles, `x = Σ s b/(iω − λ)`.
///
/// # Panics
/// Unless the sizes fit each other.
pub fn column_of_poles(
    shapes: &DMatrix<Complex<f64>>,
    inputs: &[Complex<f64>],
    roots: &[Complex<f64>],
    frequencies: &[f64],
    real: &mut DMatrix<f64>,
    imaginary: &mut DMatrix<f64>,
) {
    let (n, poles) = shapes.shape();
    assert!(inputs.len() == poles && roots.len() == poles, "as many roots each time");
    assert!(
        real.shape() == (n, frequencies.len()) && imaginary.shape() == real.shape(),
        "a column for each frequency"
    );
    let terms = terms(roots);
    let count = terms.len();
    let weights = DMatrix::from_fn(n, 2 * count, |row, column| {
        let term = &terms[column % count];
        term.weights(shapes[(row, term.at)] * inputs[term.at])[column / count]
    });
    let weights = MatRef::from_column_major_slice(weights.as_slice(), n, 2 * count);
    share_out(n * 2 * count, frequencies, real, imaginary, |frequencies, real, imaginary| {
        let (mut re, mut im) = (vec![0.0; 2 * count * BLOCK], vec![0.0; 2 * count * BLOCK]);
        let blocks = real.chunks_mut(n * BLOCK).zip(imaginary.chunks_mut(n * BLOCK));
        for ((real, imaginary), frequencies) in blocks.zip(frequencies.chunks(BLOCK)) {
            widest(
                #[inline(always)]
                || {
                    let lines = re.chunks_exact_mut(2 * count).zip(im.chunks_exact_mut(2 * count));
                    for ((re, im), w) in lines.zip(frequencies) {
                        let ((re_even, re_odd), (im_even, im_odd)) =
                            (re.split_at_mut(count), im.split_at_mut(count));
                        let places = re_even.iter_mut().zip(re_odd).zip(im_even).zip(im_odd);
                        for ((((re_even, re_odd), im_even), im_odd), term) in places.zip(&terms) {
                            let [p, q, r, s] = term.at(*w);
                            *re_even = p;
                            *re_odd = -s;
                            *im_even = q;
                            *im_odd = r;
                        }
                    }
                },
            );
            for (whole, parts) in [(real, &re), (imaginary, &im)] {
                multiply(weights, &parts[..2 * count * frequencies.len()], whole);
            }
        }
    });
}

/// Fills the columns of two matrices, one for each frequency, by whole blocks: each thread its share, if the products
/// of all frequencies are worth it. The same to the last bit on any number of threads.
fn share_out(
    products: usize,
    frequencies: &[f64],
    real: &mut DMatrix<f64>,
    imaginary: &mut DMatrix<f64>,
    fill: impl Fn(&[f64], &mut [f64], &mut [f64]) + Sync,
) {
    let rows = real.nrows();
    let (real, imaginary) = (real.as_mut_slice(), imaginary.as_mut_slice());
    let threads = thread::available_parallelism().map_or(1, usize::from);
    if threads == 1 || products * frequencies.len() < WORTH_THREADS {
        return fill(frequencies, real, imaginary);
    }
    let share = frequencies.len().div_ceil(threads).next_multiple_of(BLOCK);
    let parts = real.chunks_mut(rows * share).zip(imaginary.chunks_mut(rows * share));
    thread::scope(|scope| {
        for ((real, imaginary), frequencies) in parts.zip(frequencies.chunks(share)) {
            let fill = &fill;
            scope.spawn(move || fill(frequencies, real, imaginary));
        }
    });
}

/// `whole = weights parts`, as many columns as there are parts for.
fn multiply(weights: MatRef<'_, f64>, parts: &[f64], whole: &mut [f64]) {
    let (rows, terms) = weights.shape();
    let columns = parts.len() / terms;
    let whole = MatMut::from_column_major_slice_mut(whole, rows, columns);
    let parts = MatRef::from_column_major_slice(parts, terms, columns);
    matmul(whole, Accum::Replace, weights, parts, 1.0, Par::Seq);
}

/// A root, or a pair of conjugate ones, as the part `(even + i odd·m)(g)` of a response, with
/// `g = 1/(constant − square·ω² + iω·linear)`; m is ω for a pair and 1 for a root alone.
#[derive(Clone, Copy)]
struct Term {
    at: usize,
    root: Complex<f64>,
    pair: bool,
    constant: f64,
    square: f64,
    /// The imaginary part of the denominator is `turn·ω + offset`.
    turn: f64,
    offset: f64,
    /// m is `steady + moving·ω`.
    steady: f64,
    moving: f64,
}

impl Term {
    /// Weights of a residue in the two parts.
    fn weights(&self, residue: Complex<f64>) -> [f64; 2] {
        if self.pair {
            // r/(iω − λ) + r̄/(iω − λ̄) = 2(iω Re r − Re(r λ̄))/(|λ|² − ω² − 2iω Re λ)
            [-2.0 * (residue * self.root.conj()).re, 2.0 * residue.re]
        } else {
            [residue.re, residue.im]
        }
    }

    /// Real and imaginary part of g, and both times m.
    #[inline(always)]
    fn at(&self, w: f64) -> [f64; 4] {
        let (u, v) = (self.constant - self.square * w * w, self.turn * w + self.offset);
        let scale = 1.0 / (u * u + v * v);
        let (p, q) = (u * scale, -v * scale);
        let m = self.steady + self.moving * w;
        [p, q, m * p, m * q]
    }
}

fn terms(roots: &[Complex<f64>]) -> Vec<Term> {
    let mut terms = Vec::with_capacity(roots.len());
    let mut at = 0;
    while at < roots.len() {
        let root = roots[at];
        let pair = root.im != 0.0 && roots.get(at + 1).is_some_and(|next| *next == root.conj());
        terms.push(if pair {
            Term {
                at,
                root,
                pair,
                constant: root.norm_sqr(),
                square: 1.0,
                turn: -2.0 * root.re,
                offset: 0.0,
                steady: 0.0,
                moving: 1.0,
            }
        } else {
            Term {
                at,
                root,
                pair,
                constant: -root.re,
                square: 0.0,
                turn: 1.0,
                offset: -root.im,
                steady: 1.0,
                moving: 0.0,
            }
        });
        at += if pair { 2 } else { 1 };
    }
    terms
}
