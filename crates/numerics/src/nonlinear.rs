//! Systems of nonlinear equations and nonlinear least squares over the unit cube.
//!
//! ```
//! use dalembert_numerics::nonlinear::levenberg_marquardt;
//!
//! // A circle of radius 1 about the origin and the line y = 2x meet at (1, 2)/√5.
//! let residuals = |x: &[f64]| Some(vec![x[0] * x[0] + x[1] * x[1] - 1.0, x[1] - 2.0 * x[0]]);
//! let found = levenberg_marquardt(residuals, &[0.5, 0.5]).expect("the residuals have values everywhere");
//! assert!((found.x[0] - 1.0 / 5_f64.sqrt()).abs() < 1e-12);
//! assert!((found.x[1] - 2.0 / 5_f64.sqrt()).abs() < 1e-12);
//! ```

use nalgebra::{DMatrix, DVector};

use crate::linalg::least_squares;

/// Minimum of a sum of squares, as found from one start.
#[derive(Clone, Debug, PartialEq)]
pub struct LocalMinimum {
    /// The unknowns, each from 0 to 1.
    pub x: Vec<f64>,
    /// The residuals there.
    pub residuals: Vec<f64>,
}

/// The most iterations from one start.
const ITERATIONS: usize = 100;
/// Step of the differences that make the Jacobian.
const DIFFERENCE: f64 = 1e-6;
/// Damping at which no step helps any more.
const MOST_DAMPING: f64 = 1e12;
/// Step, of the unit cube, that is none.
const SMALLEST_STEP: f64 = 1e-15;
/// Sum of squares of residuals that are zero but for rounding.
const ROUNDING: f64 = 1e-26;
/// Iterations in which the residuals of a square system at least halve on the way to a root.
const PATIENCE: usize = 8;

/// Minimum of `½ Σ rᵢ(x)²` over `0 ≤ xⱼ ≤ 1` near a start: the root of a square system, where there is one near it.
///
/// D. W. Marquardt, *J. SIAM* 11 (1963) 431: the step solves `(JᵀJ + λ diag JᵀJ) δ = −Jᵀr`; λ falls by ten where the sum
/// gets smaller and grows by ten where it does not, or where the function has no value (`None`). The Jacobian is that of
/// one-sided differences, and of central ones where these lead no further. A square system whose residuals do not halve
/// in eight iterations is left: it nears a minimum that is no root. `None` where the start, or its surroundings, have
/// no value.
///
/// The start has a number from 0 to 1 for each unknown; the residuals are of one number and one order at every point.
pub fn levenberg_marquardt(
    mut residuals: impl FnMut(&[f64]) -> Option<Vec<f64>>,
    start: &[f64],
) -> Option<LocalMinimum> {
    let mut x = start.to_vec();
    let mut r = residuals(&x)?;
    let is_square = r.len() == x.len();
    let mut damping = 1e-3;
    let mut central = !is_square;
    let mut milestone = (0, squares(&r));
    for iteration in 0..ITERATIONS {
        if r.iter().all(|r| *r == 0.0) {
            break;
        }
        if is_square && squares(&r) <= milestone.1 / 4.0 {
            milestone = (iteration, squares(&r));
        } else if is_square && iteration - milestone.0 > PATIENCE {
            break;
        }
        let jacobian =
            if central { jacobian(&mut residuals, &x, &r)? } else { one_sided(&mut residuals, &x, &r)? };
        let mut moved = false;
        while damping < MOST_DAMPING {
            let step = step_inside(&jacobian, &r, &x, damping)?;
            let next: Vec<f64> =
                x.iter().zip(step.iter()).map(|(x, step)| (x + step).clamp(0.0, 1.0)).collect();
            if x.iter().zip(&next).all(|(x, next)| (next - x).abs() <= SMALLEST_STEP) {
                break;
            }
            match residuals(&next) {
                Some(found) if squares(&found) < squares(&r) => {
                    (x, r, moved) = (next, found, true);
                    damping = (damping / 10.0).max(1e-15);
                    break;
                }
                _ => damping *= 10.0,
            }
        }
        match (moved, central) {
            (true, _) => {}
            (false, false) if squares(&r) > ROUNDING => (central, damping) = (true, 1e-3),
            (false, _) => break,
        }
    }
    Some(LocalMinimum { x, residuals: r })
}

/// Residuals with one unknown shifted; `None` outside the unit cube.
fn shifted(
    residuals: &mut impl FnMut(&[f64]) -> Option<Vec<f64>>,
    x: &[f64],
    column: usize,
    shift: f64,
) -> Option<Vec<f64>> {
    let mut near = x.to_vec();
    near[column] += shift;
    if (0.0..=1.0).contains(&near[column]) { residuals(&near) } else { None }
}

/// Jacobian by differences to one side: above, or below where there is no value.
fn one_sided(
    residuals: &mut impl FnMut(&[f64]) -> Option<Vec<f64>>,
    x: &[f64],
    r: &[f64],
) -> Option<DMatrix<f64>> {
    let mut jacobian = DMatrix::zeros(r.len(), x.len());
    for column in 0..x.len() {
        let mut at = |shift| Some((shifted(residuals, x, column, shift)?, shift));
        let (shifted, shift) = at(DIFFERENCE).or_else(|| at(-DIFFERENCE))?;
        for row in 0..r.len() {
            jacobian[(row, column)] = (shifted[row] - r[row]) / shift;
        }
    }
    Some(jacobian)
}

/// Jacobian `∂rᵢ/∂xⱼ`, a row for each residual and a column for each unknown, by central differences within the unit
/// cube, one-sided at its faces and beside points without a value; `r` are the residuals at `x`. `None` where neither
/// side has a value.
pub fn jacobian(
    residuals: &mut impl FnMut(&[f64]) -> Option<Vec<f64>>,
    x: &[f64],
    r: &[f64],
) -> Option<DMatrix<f64>> {
    let mut jacobian = DMatrix::zeros(r.len(), x.len());
    for column in 0..x.len() {
        let mut at = |shift| shifted(residuals, x, column, shift);
        let (below, above) = (at(-DIFFERENCE), at(DIFFERENCE));
        let width = DIFFERENCE * f64::from(u8::from(below.is_some()) + u8::from(above.is_some()));
        if width == 0.0 {
            return None;
        }
        let (below, above) = (below.as_deref().unwrap_or(r), above.as_deref().unwrap_or(r));
        for row in 0..r.len() {
            jacobian[(row, column)] = (above[row] - below[row]) / width;
        }
    }
    Some(jacobian)
}

/// The step of a damped least-squares problem that leaves no face of the unit cube outwards: unknowns on a face that would
/// are kept there.
fn step_inside(jacobian: &DMatrix<f64>, r: &[f64], x: &[f64], damping: f64) -> Option<DVector<f64>> {
    let mut free = jacobian.clone();
    loop {
        let mut step = damped_step(&free, r, damping)?;
        let leaves = |n: &usize| (x[*n] == 0.0 && step[*n] < 0.0) || (x[*n] == 1.0 && step[*n] > 0.0);
        let kept: Vec<usize> = (0..x.len()).filter(leaves).collect();
        if kept.is_empty() {
            return Some(step);
        }
        for n in kept {
            if free.column(n).amax() == 0.0 {
                step[n] = 0.0;
                return Some(step);
            }
            free.column_mut(n).fill(0.0);
        }
    }
}

/// The step of a damped least-squares problem; columns are scaled by their lengths.
fn damped_step(jacobian: &DMatrix<f64>, r: &[f64], damping: f64) -> Option<DVector<f64>> {
    let (rows, columns) = jacobian.shape();
    let mut matrix = DMatrix::zeros(rows + columns, columns);
    matrix.view_mut((0, 0), (rows, columns)).copy_from(jacobian);
    for column in 0..columns {
        let length = jacobian.column(column).norm();
        matrix[(rows + column, column)] = damping.sqrt() * if length > 0.0 { length } else { 1.0 };
    }
    let right = DVector::from_iterator(rows + columns, r.iter().map(|r| -r).chain((0..columns).map(|_| 0.0)));
    least_squares(&matrix, &right).ok().map(|solved| solved.x)
}

fn squares(r: &[f64]) -> f64 {
    r.iter().map(|r| r * r).sum()
}

/// The point `n`, counted from 1, of the Halton sequence in the unit cube: points that fill it evenly.
///
/// J. H. Halton, *Numer. Math.* 2 (1960) 84: coordinate j is n mirrored at the decimal point in the base of the j-th prime.
///
/// # Panics
/// With more than ten dimensions.
pub fn halton(n: u32, dimensions: usize) -> Vec<f64> {
    const PRIMES: [u32; 10] = [2, 3, 5, 7, 11, 13, 17, 19, 23, 29];
    assert!(dimensions <= PRIMES.len(), "at most ten dimensions");
    let mirrored = |base: u32| {
        let (mut rest, mut place, mut sum) = (n, 1.0, 0.0);
        while rest > 0 {
            place /= f64::from(base);
            sum += place * f64::from(rest % base);
            rest /= base;
        }
        sum
    };
    PRIMES[..dimensions].iter().map(|base| mirrored(*base)).collect()
}
