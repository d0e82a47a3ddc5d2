//! Points that fill the unit cube more evenly than random ones: Latin hypercube and scrambled Sobol' sequence.
//!
//! Every coordinate is a function of its seed, sample and dimension alone, so that a study of any size needs no memory
//! for its points and any thread can begin anywhere.
//!
//! ```
//! use dalembert_numerics::sampling::{latin_hypercube, sobol};
//!
//! // Eight points: in each dimension every eighth of the unit interval holds one of them.
//! for dimension in 0..3 {
//!     let mut of_sobol: Vec<u32> = (0..8).map(|n| (sobol(1, n, dimension) * 8.0) as u32).collect();
//!     let of_latin = |n: u64| (latin_hypercube(1, 8, n, dimension as u64) * 8.0) as u32;
//!     let mut of_latin: Vec<u32> = (0..8).map(of_latin).collect();
//!     of_sobol.sort_unstable();
//!     of_latin.sort_unstable();
//!     assert_eq!(of_sobol, [0, 1, 2, 3, 4, 5, 6, 7]);
//!     assert_eq!(of_latin, [0, 1, 2, 3, 4, 5, 6, 7]);
//! }
//! ```

use std::sync::OnceLock;

use crate::random::{mix, uniform, uniform_bits};

/// The most dimensions of the Sobol' sequence.
pub const SOBOL_DIMENSIONS: usize = DIRECTIONS.len() + 1;
/// The most points of the Sobol' sequence.
pub const SOBOL_POINTS: u64 = 1 << 32;

/// The coordinate of a sample in a Latin hypercube of so many samples: in each dimension every stratum of
/// width `1/samples` holds one sample (M. D. McKay, R. J. Beckman and W. J. Conover, *Technometrics* 21, 1979).
pub fn latin_hypercube(seed: u64, samples: u64, sample: u64, dimension: u64) -> f64 {
    let stratum = permuted(sample, samples, uniform_bits(seed, u64::MAX, dimension));
    (stratum as f64 + uniform(seed, sample, dimension)) / samples as f64
}

/// The place of `at` in a random permutation of `0..count`: a Feistel network of four rounds over the next even number of
/// bits, repeated until the place is in the range.
fn permuted(at: u64, count: u64, key: u64) -> u64 {
    let half = (u64::BITS - count.saturating_sub(1).leading_zeros()).div_ceil(2);
    let low = (1 << half) - 1;
    let mut place = at;
    loop {
        let (mut left, mut right) = (place >> half, place & low);
        for round in 0..4 {
            let turned = mix(right ^ key.rotate_left(16 * round)) & low;
            (left, right) = (right, left ^ turned);
        }
        place = left << half | right;
        if place < count {
            return place;
        }
    }
}

/// The coordinate of a point of the scrambled Sobol' sequence, strictly between 0 and 1.
///
/// Direction numbers of S. Joe and F. Y. Kuo, *SIAM J. Sci. Comput.* 30 (2008), file `new-joe-kuo-6`; scrambled after
/// Owen by the hash of S. Laine and T. Karras (B. Burley, *Practical Hash-based Owen Scrambling*, JCGT 9, 2020). The first
/// `2ⁿ` points hold one in every interval of width `2⁻ⁿ` of each dimension.
///
/// # Panics
/// From [`SOBOL_DIMENSIONS`] or [`SOBOL_POINTS`] on.
pub fn sobol(seed: u64, sample: u64, dimension: usize) -> f64 {
    static NUMBERS: OnceLock<Vec<[u32; 32]>> = OnceLock::new();
    let numbers = &NUMBERS.get_or_init(|| (0..SOBOL_DIMENSIONS).map(direction_numbers).collect())[dimension];
    let mut sample = u32::try_from(sample).expect("fewer points than the sequence has");
    let mut point = 0;
    while sample != 0 {
        point ^= numbers[sample.trailing_zeros() as usize];
        sample &= sample - 1;
    }
    let scrambled = owen_scrambled(point, uniform_bits(seed, 0, dimension as u64) as u32);
    (f64::from(scrambled) + 0.5) / SOBOL_POINTS as f64
}

/// Scrambling of every bit by a hash of the bits above it.
fn owen_scrambled(point: u32, seed: u32) -> u32 {
    let mut bits = point.reverse_bits().wrapping_add(seed);
    for factor in [0x6c50_b47c_u32, 0xb82f_1e52, 0xc7af_e638, 0x8d22_f6e6] {
        bits ^= bits.wrapping_mul(factor);
    }
    bits.reverse_bits()
}

/// The direction numbers of a dimension, by the recurrence of its primitive polynomial.
fn direction_numbers(dimension: usize) -> [u32; 32] {
    let mut numbers = [0; 32];
    let Some((inner, initial)) = dimension.checked_sub(1).map(|at| DIRECTIONS[at]) else {
        // The first dimension is the sequence of van der Corput.
        return std::array::from_fn(|bit| 1 << (31 - bit));
    };
    let degree = initial.len();
    for bit in 0..32 {
        numbers[bit] = match initial.get(bit) {
            Some(first) => first << (31 - bit),
            None => {
                let before = numbers[bit - degree];
                let own = before ^ (before >> degree);
                (1..degree).fold(own, |sum, k| {
                    let coefficient = (inner >> (degree - 1 - k)) & 1;
                    sum ^ (coefficient * numbers[bit - k])
                })
            }
        };
    }
    numbers
}

/// For each dimension from the second on: the inner coefficients of the primitive polynomial, and the first direction
/// numbers, as many as its degree.
#[rustfmt::skip]
const DIRECTIONS: [(u32, &[u32]); 63] = [
    (0, &[1]),
    (1, &[1, 3]),
    (1, &[1, 3, 1]),
    (2, &[1, 1, 1]),
    (1, &[1, 1, 3, 3]),
    (4, &[1, 3, 5, 13]),
    (2, &[1, 1, 5, 5, 17]),
    (4, &[1, 1, 5, 5, 5]),
    (7, &[1, 1, 7, 11, 19]),
    (11, &[1, 1, 5, 1, 1]),
    (13, &[1, 1, 1, 3, 11]),
    (14, &[1, 3, 5, 5, 31]),
    (1, &[1, 3, 3, 9, 7, 49]),
    (13, &[1, 1, 1, 15, 21, 21]),
    (16, &[1, 3, 1, 13, 27, 49]),
    (19, &[1, 1, 1, 15, 7, 5]),
    (22, &[1, 3, 1, 15, 13, 25]),
    (25, &[1, 1, 5, 5, 19, 61]),
    (1, &[1, 3, 7, 11, 23, 15, 103]),
    (4, &[1, 3, 7, 13, 13, 15, 69]),
    (7, &[1, 1, 3, 13, 7, 35, 63]),
    (8, &[1, 3, 5, 9, 1, 25, 53]),
    (14, &[1, 3, 1, 13, 9, 35, 107]),
    (19, &[1, 3, 1, 5, 27, 61, 31]),
    (21, &[1, 1, 5, 11, 19, 41, 61]),
    (28, &[1, 3, 5, 3, 3, 13, 69]),
    (31, &[1, 1, 7, 13, 1, 19, 1]),
    (32, &[1, 3, 7, 5, 13, 19, 59]),
    (37, &[1, 1, 3, 9, 25, 29, 41]),
    (41, &[1, 3, 5, 13, 23, 1, 55]),
    (42, &[1, 3, 7, 3, 13, 59, 17]),
    (50, &[1, 3, 1, 3, 5, 53, 69]),
    (55, &[1, 1, 5, 5, 23, 33, 13]),
    (56, &[1, 1, 7, 7, 1, 61, 123]),
    (59, &[1, 1, 7, 9, 13, 61, 49]),
    (62, &[1, 3, 3, 5, 3, 55, 33]),
    (14, &[1, 3, 1, 15, 31, 13, 49, 245]),
    (21, &[1, 3, 5, 15, 31, 59, 63, 97]),
    (22, &[1, 3, 1, 11, 11, 11, 77, 249]),
    (38, &[1, 3, 1, 11, 27, 43, 71, 9]),
    (47, &[1, 1, 7, 15, 21, 11, 81, 45]),
    (49, &[1, 3, 7, 3, 25, 31, 65, 79]),
    (50, &[1, 3, 1, 1, 19, 11, 3, 205]),
    (52, &[1, 1, 5, 9, 19, 21, 29, 157]),
    (56, &[1, 3, 7, 11, 1, 33, 89, 185]),
    (67, &[1, 3, 3, 3, 15, 9, 79, 71]),
    (70, &[1, 3, 7, 11, 15, 39, 119, 27]),
    (84, &[1, 1, 3, 1, 11, 31, 97, 225]),
    (97, &[1, 1, 1, 3, 23, 43, 57, 177]),
    (103, &[1, 3, 7, 7, 17, 17, 37, 71]),
    (115, &[1, 3, 1, 5, 27, 63, 123, 213]),
    (122, &[1, 1, 3, 5, 11, 43, 53, 133]),
    (8, &[1, 3, 5, 5, 29, 17, 47, 173, 479]),
    (13, &[1, 3, 3, 11, 3, 1, 109, 9, 69]),
    (16, &[1, 1, 1, 5, 17, 39, 23, 5, 343]),
    (22, &[1, 3, 1, 5, 25, 15, 31, 103, 499]),
    (25, &[1, 1, 1, 11, 11, 17, 63, 105, 183]),
    (44, &[1, 1, 5, 11, 9, 29, 97, 231, 363]),
    (47, &[1, 1, 5, 15, 19, 45, 41, 7, 383]),
    (52, &[1, 3, 7, 7, 31, 19, 83, 137, 221]),
    (55, &[1, 1, 1, 3, 23, 15, 111, 223, 83]),
    (59, &[1, 1, 5, 13, 31, 15, 55, 25, 161]),
    (62, &[1, 1, 3, 13, 25, 47, 39, 87, 257]),
];
