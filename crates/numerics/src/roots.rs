//! Zeros of a function of one number.
//!
//! ```
//! use std::ops::ControlFlow;
//!
//! use dalembert_numerics::roots::{RootError, find};
//!
//! // Kepler's equation E − e sin E = M for e = 0.5 and the M of E = 2.
//! let anomaly = 2.0 - 0.5 * 2_f64.sin();
//! let kepler = |x: f64| x - 0.5 * x.sin() - anomaly;
//! let found = find(kepler, [0.0, 3.0], |_| ControlFlow::Continue(()))?;
//! assert!((found - 2.0).abs() < 1e-12);
//! let refused = find(kepler, [2.5, 3.0], |_| ControlFlow::Continue(()));
//! assert!(matches!(refused, Err(RootError::NotBracketed { .. })));
//! # Ok::<(), RootError>(())
//! ```

use std::ops::ControlFlow;

/// Reason for which no zero is found.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum RootError {
    /// The ends of the range are not two finite numbers in order, or there are too few samples.
    #[error("the range from {from} to {to} is not two finite numbers in ascending order")]
    Range {
        /// Given lower end.
        from: f64,
        /// Given upper end.
        to: f64,
    },
    /// The function has the same sign at both ends.
    #[error("the function has the same sign at {from} and at {to}; choose ends that enclose a zero")]
    NotBracketed {
        /// Lower end.
        from: f64,
        /// Upper end.
        to: f64,
    },
    /// The function is NaN or infinite.
    #[error("the function is not finite at {at}")]
    NotFinite {
        /// Argument at which the function is not finite.
        at: f64,
    },
    /// The function changes its sign by a jump or through a pole, not through zero.
    #[error("the function jumps at {at} and has no zero there")]
    Discontinuity {
        /// Argument at which the iteration ended.
        at: f64,
    },
    /// The iteration reached its limit.
    #[error("the search for a zero did not converge")]
    NotConverged,
    /// The observer asked to stop.
    #[error("the search was stopped")]
    Stopped,
}

/// Relative width of the bracket at which a zero counts as found.
const TOLERANCE: f64 = 1e-13;

/// The zero of a continuous function between two points where its signs differ, to a relative `1e-13`; a zero at
/// the origin, to `1e-30` of the range.
///
/// R. P. Brent, *Algorithms for Minimization without Derivatives* (1973), ch. 4: inverse quadratic and linear
/// interpolation, held by bisection. The observer sees every estimate and may stop the search.
///
/// # Errors
/// All of [`RootError`].
pub fn find(
    mut function: impl FnMut(f64) -> f64,
    [from, to]: [f64; 2],
    mut observer: impl FnMut(f64) -> ControlFlow<()>,
) -> Result<f64, RootError> {
    check_range(from, to)?;
    let mut at = |x: f64| {
        let value = function(x);
        if value.is_finite() { Ok(value) } else { Err(RootError::NotFinite { at: x }) }
    };
    let (mut a, mut b) = (from, to);
    let (mut fa, mut fb) = (at(a)?, at(b)?);
    let ends = fa.abs().max(fb.abs());
    let absolute = 1e-30 * (to - from);
    if fa != 0.0 && fb != 0.0 && fa.signum() == fb.signum() {
        return Err(RootError::NotBracketed { from, to });
    }
    // b is the best estimate, [b, c] the bracket, a the estimate before b.
    let (mut c, mut fc) = (a, fa);
    let (mut step, mut last_step) = (b - a, b - a);
    for _ in 0..1000 {
        if fc.abs() < fb.abs() {
            (a, b, c) = (b, c, b);
            (fa, fb, fc) = (fb, fc, fb);
        }
        if observer(b).is_break() {
            return Err(RootError::Stopped);
        }
        let tolerance = 0.5 * TOLERANCE * b.abs() + absolute;
        let half = (c - b) / 2.0;
        if fb == 0.0 {
            return Ok(b);
        }
        if half.abs() <= tolerance {
            return if fb.abs() <= 1e-6 * ends { Ok(b) } else { Err(RootError::Discontinuity { at: b }) };
        }
        match interpolated([a, b, c], [fa, fb, fc]) {
            Some(guess)
                if last_step.abs() >= tolerance
                    && fa.abs() > fb.abs()
                    && guess * half.signum() > 0.0
                    && guess.abs() < (1.5 * half.abs() - tolerance / 2.0)
                    && guess.abs() < (last_step / 2.0).abs() =>
            {
                (last_step, step) = (step, guess);
            }
            _ => (last_step, step) = (half, half),
        }
        (a, fa) = (b, fb);
        b += if step.abs() > tolerance { step } else { tolerance * half.signum() };
        fb = at(b)?;
        if (fb > 0.0) == (fc > 0.0) {
            (c, fc) = (a, fa);
            (step, last_step) = (b - a, b - a);
        }
    }
    Err(RootError::NotConverged)
}

/// All zeros of a function in a range, ascending, that a scan in equal steps can tell apart: one for each step over
/// which the sign changes. Jumps and poles are left out. A zero where the function only touches zero, or two zeros
/// within one step, are not seen.
///
/// # Errors
/// All of [`RootError`] but `NotBracketed` and `Discontinuity`; `Range` also for no steps.
pub fn find_all(
    mut function: impl FnMut(f64) -> f64,
    [from, to]: [f64; 2],
    steps: usize,
    mut observer: impl FnMut(f64) -> ControlFlow<()>,
) -> Result<Vec<f64>, RootError> {
    check_range(from, to)?;
    if steps == 0 {
        return Err(RootError::Range { from, to });
    }
    let point = |i: usize| {
        let part = i as f64 / steps as f64;
        from * (1.0 - part) + to * part
    };
    let mut zeros = Vec::new();
    let mut before: Option<(f64, f64)> = None;
    for i in 0..=steps {
        let x = point(i);
        let value = function(x);
        if !value.is_finite() {
            return Err(RootError::NotFinite { at: x });
        }
        if observer(x).is_break() {
            return Err(RootError::Stopped);
        }
        if value == 0.0 {
            zeros.push(x);
        } else if let Some((x0, value0)) = before
            && value0 != 0.0
            && (value0 > 0.0) != (value > 0.0)
        {
            match find(&mut function, [x0, x], &mut observer) {
                Ok(zero) => zeros.push(zero),
                Err(RootError::Discontinuity { .. } | RootError::NotFinite { .. }) => {}
                Err(error) => return Err(error),
            }
        }
        before = Some((x, value));
    }
    Ok(zeros)
}

/// The zero of a continuous function between two neighbours of a table of it, points and values; none where both values
/// have the same sign. A value of zero counts as negative, so that a zero on a point of the table is found once.
pub fn crossing(neighbours: &[(f64, f64)], function: impl FnMut(f64) -> f64) -> Option<f64> {
    let [(from, before), (to, after)] = neighbours else { return None };
    if (*before > 0.0) == (*after > 0.0) {
        return None;
    }
    find(function, [*from, *to], |_| ControlFlow::Continue(())).ok()
}

/// The step from `b` to the zero of the interpolation through three points, or through two where they coincide.
fn interpolated([a, b, c]: [f64; 3], [fa, fb, fc]: [f64; 3]) -> Option<f64> {
    let s = fb / fa;
    let (numerator, denominator) = if a == c {
        ((c - b) * s, 1.0 - s)
    } else {
        let (q, r) = (fa / fc, fb / fc);
        (s * ((c - b) * q * (q - r) - (b - a) * (r - 1.0)), -(q - 1.0) * (r - 1.0) * (s - 1.0))
    };
    let step = numerator / denominator;
    step.is_finite().then_some(step)
}

fn check_range(from: f64, to: f64) -> Result<(), RootError> {
    if from.is_finite() && to.is_finite() && (to - from).is_finite() && from < to {
        Ok(())
    } else {
        Err(RootError::Range { from, to })
    }
}
