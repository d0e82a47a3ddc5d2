//! Bessel functions of the first kind, of whole order, and their zeros.
//!
//! Miller's recurrence from high orders down, with the sums that are one and `eˣ` (Abramowitz & Stegun, *Handbook of
//! Mathematical Functions*, §9.12 and 9.6.37).
//!
//! ```
//! use dalembert_numerics::bessel::{j, j_zeros};
//!
//! // A circular membrane of radius a and wave speed c vibrates at ω = 2.4048 c/a and 5.5201 c/a: the zeros of J₀.
//! let zeros = j_zeros(0, 2);
//! assert!((zeros[0] - 2.404_825_557_695_773).abs() < 1e-12);
//! assert!((zeros[1] - 5.520_078_110_286_311).abs() < 1e-12);
//! // J₀ has its extremes where J₁ is zero, the first one at 3.8317.
//! assert!((j(0, j_zeros(1, 1)[0]) + 0.402_759_395_702_553).abs() < 1e-14);
//! ```

use std::ops::ControlFlow;

use crate::roots;

/// Orders and arguments above this are not asked for.
pub const MOST: f64 = 500.0;

/// `J_n(x)` for `x ≥ 0`; NaN for `x < 0` and above twice [`MOST`].
pub fn j(order: usize, x: f64) -> f64 {
    let sum = |here: f64, k: usize| if k.is_multiple_of(2) { 2.0 * here } else { 0.0 };
    downward(order, x, -1.0, sum)
}

/// `e⁻ˣ I_n(x)` for `x ≥ 0`; NaN for `x < 0` and above twice [`MOST`].
pub fn scaled_i(order: usize, x: f64) -> f64 {
    downward(order, x, 1.0, |here, _| 2.0 * here)
}

/// `J_n'(x) = J_{n−1} − n J_n/x`.
pub fn j_slope(order: usize, x: f64) -> f64 {
    if order == 0 { -j(1, x) } else { 0.5 * (j(order - 1, x) - j(order + 1, x)) }
}

/// `e⁻ˣ I_n'(x)`.
pub fn scaled_i_slope(order: usize, x: f64) -> f64 {
    if order == 0 { scaled_i(1, x) } else { 0.5 * (scaled_i(order - 1, x) + scaled_i(order + 1, x)) }
}

/// The first `count` zeros of `J_n` above zero, ascending; fewer where they lie beyond [`MOST`].
pub fn j_zeros(order: usize, count: usize) -> Vec<f64> {
    zeros(|x| j(order, x), order as f64 + 0.5, count)
}

/// The first `count` zeros of a function above `from` that are more than half apart, ascending; fewer where they lie
/// beyond [`MOST`].
pub fn zeros(mut function: impl FnMut(f64) -> f64, from: f64, count: usize) -> Vec<f64> {
    const STEP: f64 = 0.4;
    let mut found = Vec::with_capacity(count);
    let mut x = from;
    let mut before = function(x);
    while found.len() < count && x < MOST {
        let next = x + STEP;
        let here = function(next);
        if (before > 0.0) != (here > 0.0)
            && let Ok(zero) = roots::find(&mut function, [x, next], |_| ControlFlow::Continue(()))
        {
            found.push(zero);
        }
        (x, before) = (next, here);
    }
    found
}

/// `F_n` of `F_{k−1} = 2k F_k/x + sign F_{k+1}`, the sum of whose weighted values is one.
fn downward(order: usize, x: f64, sign: f64, weighted: impl Fn(f64, usize) -> f64) -> f64 {
    const LARGE: f64 = 1e200;
    if x == 0.0 {
        return if order == 0 { 1.0 } else { 0.0 };
    }
    if !(x > 0.0 && x <= 2.0 * MOST) {
        return f64::NAN;
    }
    // High enough for both: the values there are below rounding.
    let top = order.max(x as usize) + 30 + (40.0 * x).sqrt() as usize;
    let (mut above, mut here, mut sum, mut wanted) = (0.0, 1e-200, 0.0, 0.0);
    for k in (0..=top).rev() {
        if k == order {
            wanted = here;
        }
        sum += if k == 0 { here } else { weighted(here, k) };
        let below = 2.0 * k as f64 / x * here + sign * above;
        (above, here) = (here, below);
        if here.abs() > LARGE {
            for value in [&mut above, &mut here, &mut sum, &mut wanted] {
                *value /= LARGE;
            }
        }
    }
    wanted / sum
}

#[cfg(test)]
mod tests {
    use super::*;
    use itertools::Itertools as _;

    /// Abramowitz & Stegun, tables 9.1, 9.5, 9.8 and 9.11.
    #[test]
    fn printed_values() {
        let near = |ours: f64, printed: f64, places: i32| {
            assert!((ours - printed).abs() < 0.51 * 10f64.powi(-places), "{ours} {printed}");
        };
        near(j(0, 1.0), 0.765_197_686_557_967, 15);
        near(j(1, 1.0), 0.440_050_585_7, 10);
        near(j(2, 5.0), 0.046_565_116_3, 10);
        near(j(0, 10.0), -0.245_935_764_451_348, 15);
        near(scaled_i(0, 1.0), 0.465_759_607_6, 10);
        near(scaled_i(1, 1.0), 0.207_910_415_3, 10);
        for (order, printed) in [
            (0, [2.404_825_557_7, 5.520_078_110_3, 8.653_727_912_9]),
            (1, [3.831_705_970_2, 7.015_586_669_8, 10.173_468_135_1]),
            (2, [5.135_622_301_8, 8.417_244_140_4, 11.619_841_172_1]),
        ] {
            for (ours, printed) in j_zeros(order, 3).into_iter().zip_eq(printed) {
                near(ours, printed, 10);
            }
        }
    }

    /// The differential equations, by central differences of the printed slopes, and the slopes themselves.
    #[test]
    fn slopes_and_recurrences_agree() {
        for order in 1..12 {
            for x in [0.3, 2.0, 7.5, 30.0, 120.0] {
                let n = order as f64;
                let other = j(order - 1, x) - n * j(order, x) / x;
                assert!((j_slope(order, x) - other).abs() < 1e-14, "J {order} {x}");
                let other = scaled_i(order - 1, x) - n * scaled_i(order, x) / x;
                assert!((scaled_i_slope(order, x) - other).abs() < 1e-14, "I {order} {x}");
            }
        }
        // J_0² + 2 Σ J_k² = 1.
        for x in [0.5, 9.0, 60.0, 400.0] {
            let squares: f64 = (1..600).map(|n| 2.0 * j(n, x).powi(2)).sum();
            assert!((j(0, x).powi(2) + squares - 1.0).abs() < 1e-12, "{x}");
        }
    }
}
