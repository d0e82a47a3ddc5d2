//! Comparisons with a named tolerance.

use itertools::Itertools as _;
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

/// Holds each number to its partner, relative to the largest of all.
#[track_caller]
pub(crate) fn all_close<const N: usize>(ours: [f64; N], expected: [f64; N], relative: f64) {
    let size = ours.iter().chain(&expected).fold(0.0, |size: f64, x| size.max(x.abs()));
    let gap = ours.iter().zip_eq(&expected).fold(0.0, |gap: f64, (p, q)| gap.max((p - q).abs()));
    assert!(gap <= relative * size, "{ours:?} is not {expected:?} to {relative:e}");
}

/// Holds a number to one printed with this many decimals: within half a unit of the last.
#[track_caller]
pub(crate) fn printed(ours: f64, printed: f64, decimals: i32) {
    let half_unit = 0.5 * 10f64.powi(-decimals);
    assert!(
        (ours - printed).abs() <= half_unit * (1.0 + 1e-9),
        "{ours} does not round to {printed} with {decimals} decimals"
    );
}

/// Unwraps, with the error in the message.
#[track_caller]
pub(crate) fn found<T, E: Debug>(result: Result<T, E>) -> T {
    result.expect("there is an answer")
}
