//! Comparisons with a named tolerance.

use std::fmt::Debug;

/// Relative rounding error allowed for a short formula.
pub(crate) const ROUNDING: f64 = 1e-12;

/// Holds a number to another, relative to the larger.
#[track_caller]
pub(crate) fn close(ours: f64, expected: f64, relative: f64) {
    let size = ours.abs().max(expected.abs());
    assert!(
        (ours - expected).abs() <= relative * size,
        "{ours:e} is not {expected:e} to {relative:e}, but to {:e}",
        (ours - expected).abs() / size
    );
}

/// Unwraps, with the error in the message.
#[track_caller]
pub(crate) fn found<T, E: Debug>(result: Result<T, E>) -> T {
    result.expect("there is an answer")
}
