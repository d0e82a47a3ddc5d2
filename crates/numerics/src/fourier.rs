//! Fourier coefficients of a periodic function from its values at equal intervals.
//!
//! `y(θ) ≈ a₀/2 + Σ (aₙ cos nθ + bₙ sin nθ)`, from the `N` ordinates `y_j = y(2π j/N)`:
//! `aₙ = 2/N Σ y_j cos(2π n j/N)`, `bₙ = 2/N Σ y_j sin(2π n j/N)`; of the last harmonic `n = N/2` of an even number of
//! ordinates half as much, so that all harmonics together pass through the ordinates.
//!
//! ```
//! use std::f64::consts::TAU;
//!
//! use dalembert_numerics::fourier::harmonic;
//!
//! // Twelve ordinates of 3 + 2 cos θ + 0.5 sin 3θ, from θ = 0 on; the mean is half of a₀.
//! let ordinates: Vec<f64> = (0..12)
//!     .map(|j| TAU * f64::from(j) / 12.0)
//!     .map(|angle| 3.0 + 2.0 * angle.cos() + 0.5 * (3.0 * angle).sin())
//!     .collect();
//! for (n, wanted) in [(0, (6.0, 0.0)), (1, (2.0, 0.0)), (2, (0.0, 0.0)), (3, (0.0, 0.5))] {
//!     let (a, b) = harmonic(&ordinates, n);
//!     assert!((a - wanted.0).abs() < 1e-14 && (b - wanted.1).abs() < 1e-14);
//! }
//! ```

use std::f64::consts::TAU;

/// Factor of the sums of harmonic `n` of so many ordinates: `2/N`, of the last one of an even number `1/N`.
pub fn factor(count: usize, n: usize) -> f64 {
    if 2 * n == count { 1.0 / count as f64 } else { 2.0 / count as f64 }
}

/// Cosine and sine of `2π n j/N`, exact at the multiples of a quarter of a turn.
pub fn cosine_and_sine(count: usize, n: usize, j: usize) -> (f64, f64) {
    // Within the turn first: the product loses no digits.
    let place = (n * j) % count;
    match 4 * place {
        0 => (1.0, 0.0),
        quarter if quarter == count => (0.0, 1.0),
        half if half == 2 * count => (-1.0, 0.0),
        three_quarters if three_quarters == 3 * count => (0.0, -1.0),
        _ => {
            let (sin, cos) = (TAU * place as f64 / count as f64).sin_cos();
            (cos, sin)
        }
    }
}

/// The coefficients `(aₙ, bₙ)` of a harmonic, by their sums, from `N` ordinates over one period, the first at `θ = 0`,
/// for `n ≤ N/2`.
pub fn harmonic(ordinates: &[f64], n: usize) -> (f64, f64) {
    let count = ordinates.len();
    let (mut a, mut b) = (0.0, 0.0);
    for (j, y) in ordinates.iter().enumerate() {
        let (cos, sin) = cosine_and_sine(count, n, j);
        a += y * cos;
        b += y * sin;
    }
    (a * factor(count, n), b * factor(count, n))
}

/// The same by a recursion, `s_j = y_j + 2 cos(2π n/N) s_{j−1} − s_{j−2}` (G. Goertzel, *Am. Math. Mon.* 65, 1958).
pub fn harmonic_by_recursion(ordinates: &[f64], n: usize) -> (f64, f64) {
    let (cos, sin) = cosine_and_sine(ordinates.len(), n, 1);
    let (mut last, mut before) = (0.0, 0.0);
    for y in ordinates {
        (last, before) = (y + 2.0 * cos * last - before, last);
    }
    let factor = factor(ordinates.len(), n);
    ((cos * last - before) * factor, -sin * last * factor)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A sum of harmonics at so many places.
    fn ordinates(count: usize, mean: f64, harmonics: &[(usize, f64, f64)]) -> Vec<f64> {
        let at = |j: usize| {
            let angle = TAU * j as f64 / count as f64;
            let term =
                |(n, a, b): &(usize, f64, f64)| a * (*n as f64 * angle).cos() + b * (*n as f64 * angle).sin();
            mean + harmonics.iter().map(term).sum::<f64>()
        };
        (0..count).map(at).collect()
    }

    #[test]
    fn the_coefficients_of_a_sum_of_harmonics_are_found() {
        let harmonics = [(1, 2.0, -1.0), (3, 0.5, 0.25), (6, -0.7, 0.0)];
        for count in [12, 13, 200] {
            let values = ordinates(count, 4.0, &harmonics);
            for n in 1..=6 {
                let (a, b) =
                    harmonics.iter().find(|(m, ..)| *m == n).map_or((0.0, 0.0), |(_, a, b)| (*a, *b));
                for (found_a, found_b) in [harmonic(&values, n), harmonic_by_recursion(&values, n)] {
                    assert!((found_a - a).abs() < 1e-12, "{count} {n}: {found_a}");
                    assert!((found_b - b).abs() < 1e-12, "{count} {n}: {found_b}");
                }
            }
        }
    }

    #[test]
    fn quarters_of_a_turn_are_exact() {
        for (j, exact) in [(1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0)].into_iter().enumerate() {
            assert_eq!(cosine_and_sine(12, 1, 3 * j), exact);
            assert_eq!(cosine_and_sine(12, 3, j), exact);
        }
    }
}
