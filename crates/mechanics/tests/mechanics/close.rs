//! Comparisons of vectors and of printed numbers, beside those that the tests of the numerical methods have.

use itertools::Itertools as _;

#[path = "../../../numerics/tests/numerics/close.rs"]
mod numbers;

pub(crate) use self::numbers::{ROUNDING, close, found};

/// Compares each number with its partner, relative to the largest of all.
#[track_caller]
pub(crate) fn all_close<const N: usize>(ours: [f64; N], expected: [f64; N], relative: f64) {
    let size = ours.iter().chain(&expected).fold(0.0, |size: f64, x| size.max(x.abs()));
    let difference = ours.iter().zip_eq(&expected).fold(0.0, |most: f64, (p, q)| most.max((p - q).abs()));
    assert!(difference <= relative * size, "{ours:?} is not {expected:?} to {relative:e}");
}

/// Compares a number with one printed to this many decimals: within half a unit of the last.
#[track_caller]
pub(crate) fn printed(ours: f64, printed: f64, decimals: i32) {
    let half_unit = 0.5 * 10f64.powi(-decimals);
    assert!(
        (ours - printed).abs() <= half_unit * (1.0 + 1e-9),
        "{ours} does not round to {printed} with {decimals} decimals"
    );
}
