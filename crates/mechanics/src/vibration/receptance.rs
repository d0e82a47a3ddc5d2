//! Frequency response of many degrees of freedom: directly, and as sums over modes or poles.

use faer::{Accum, MatMut, MatRef, Par, linalg::matmul::matmul, traits::pulp::Arch};
use nalgebra::{Complex, DMatrix, DVector};

use crate::linalg::{self, LinalgError};

/// So many frequencies are worked at a time: they stay in the nearest cache.
const BLOCK: usize = 256;

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
    let dynamic = DMatrix::from_fn(k.nrows(), k.ncols(), |i, j| {
        Complex::new(k[(i, j)] - frequency * frequency * m[(i, j)], frequency * c[(i, j)])
    });
    let right = DMatrix::from_column_slice(force.len(), 1, force.as_slice());
    Ok(linalg::solve_complex(&dynamic, &right)?.column(0).into_owned())
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
    Arch::new().dispatch(
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
    let (mut re, mut im) = (vec![0.0; modes * BLOCK], vec![0.0; modes * BLOCK]);
    let shapes = MatRef::from_column_major_slice(shapes.as_slice(), n, modes);
    let blocks =
        real.as_mut_slice().chunks_mut(n * BLOCK).zip(imaginary.as_mut_slice().chunks_mut(n * BLOCK));
    for ((real, imaginary), frequencies) in blocks.zip(frequencies.chunks(BLOCK)) {
        let here = frequencies.len();
        Arch::new().dispatch(
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
            let whole = MatMut::from_column_major_slice_mut(whole, n, here);
            let parts = MatRef::from_column_major_slice(&parts[..modes * here], modes, here);
            matmul(whole, Accum::Replace, shapes, parts, 1.0, Par::Seq);
        }
    }
}

/// Real and imaginary parts of `Σ rᵣ/(iω − λᵣ)` over all roots, each at each frequency; for damping of any kind.
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
    Arch::new().dispatch(
        #[inline(always)]
        || {
            let blocks =
                real.chunks_mut(BLOCK).zip(imaginary.chunks_mut(BLOCK)).zip(frequencies.chunks(BLOCK));
            for ((real, imaginary), frequencies) in blocks {
                real.fill(0.0);
                imaginary.fill(0.0);
                for (residue, root) in residues.iter().zip(roots) {
                    let (a, b, d, e) = (residue.re, residue.im, -root.re, -root.im);
                    for ((re, im), w) in real.iter_mut().zip(imaginary.iter_mut()).zip(frequencies) {
                        let y = w + e;
                        let s = 1.0 / (d * d + y * y);
                        *re += (a * d + b * y) * s;
                        *im += (b * d - a * y) * s;
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
    let (s_real, s_imaginary) = (shapes.map(|s| s.re), shapes.map(|s| s.im));
    let view = |a: &'_ DMatrix<f64>| faer::Mat::from_fn(n, poles, |row, column| a[(row, column)]);
    let (s_real, s_imaginary) = (view(&s_real), view(&s_imaginary));
    let (mut re, mut im) = (vec![0.0; poles * BLOCK], vec![0.0; poles * BLOCK]);
    let parts_of =
        |of: fn(&Complex<f64>) -> f64, all: &[Complex<f64>]| all.iter().map(of).collect::<Vec<f64>>();
    let (a, b) = (parts_of(|z| z.re, inputs), parts_of(|z| z.im, inputs));
    let (d, e) = (parts_of(|z| -z.re, roots), parts_of(|z| -z.im, roots));
    let blocks =
        real.as_mut_slice().chunks_mut(n * BLOCK).zip(imaginary.as_mut_slice().chunks_mut(n * BLOCK));
    for ((real, imaginary), frequencies) in blocks.zip(frequencies.chunks(BLOCK)) {
        let here = frequencies.len();
        Arch::new().dispatch(
            #[inline(always)]
            || {
                let lines = re.chunks_exact_mut(poles).zip(im.chunks_exact_mut(poles));
                for ((re, im), w) in lines.zip(frequencies) {
                    let terms = re.iter_mut().zip(im.iter_mut()).zip(&a).zip(&b).zip(&d).zip(&e);
                    for (((((re, im), a), b), d), e) in terms {
                        let y = w + e;
                        let s = 1.0 / (d * d + y * y);
                        *re = (a * d + b * y) * s;
                        *im = (b * d - a * y) * s;
                    }
                }
            },
        );
        let part = |parts: &'_ [f64]| {
            MatRef::from_column_major_slice(&parts[..poles * here], poles, here).to_owned()
        };
        let (z_real, z_imaginary) = (part(&re), part(&im));
        let add = |whole: &mut [f64], terms: [(&faer::Mat<f64>, &faer::Mat<f64>, f64); 2]| {
            for (at, (s, z, sign)) in terms.into_iter().enumerate() {
                let accumulate = if at == 0 { Accum::Replace } else { Accum::Add };
                matmul(MatMut::from_column_major_slice_mut(whole, n, here), accumulate, s, z, sign, Par::Seq);
            }
        };
        add(real, [(&s_real, &z_real, 1.0), (&s_imaginary, &z_imaginary, -1.0)]);
        add(imaginary, [(&s_real, &z_imaginary, 1.0), (&s_imaginary, &z_real, 1.0)]);
    }
}
