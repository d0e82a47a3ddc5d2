//! Random numbers by their place: each is a function of a seed, a sample and a place in the sample, so that any thread
//! can draw any of them, and in any order.
//!
//! The counter is mixed twice by the finaliser of SplitMix64 (G. L. Steele, D. Lea and C. H. Flood, *Fast Splittable
//! Pseudorandom Number Generators*, OOPSLA 2014).
//!
//! ```
//! use dalembert_numerics::random::{mix, uniform, uniforms};
//!
//! // The first number of SplitMix64 from the state zero.
//! assert_eq!(mix(0x9e37_79b9_7f4a_7c15), 0xe220_a839_7b1d_cdaf);
//! // Samples 100 to 107 of seed 1 at place 3, all at once and one of them alone: the same number.
//! let mut numbers = [0.0; 8];
//! uniforms(1, 100, 3, &mut numbers);
//! assert_eq!(numbers[5], uniform(1, 105, 3));
//! // The mean of many is a half: 0.5 ± 0.0009 is one standard deviation for a hundred thousand.
//! let mean = (0..100_000).map(|sample| uniform(1, sample, 0)).sum::<f64>() / 1e5;
//! assert!((mean - 0.5).abs() < 0.0036);
//! ```

use std::f64::consts::TAU;

use crate::{Real, simd::widest};

/// A random number strictly between 0 and 1 that belongs to this seed, sample and place.
#[inline]
pub fn uniform(seed: u64, sample: u64, place: u64) -> f64 {
    share(uniform_bits(seed, sample, place))
}

/// The [`uniform`] numbers of successive samples at one place.
pub fn uniforms(seed: u64, first: u64, place: u64, numbers: &mut [f64]) {
    widest(
        #[inline(always)]
        || {
            for (sample, number) in (first..).zip(numbers.iter_mut()) {
                *number = share(bits_at(key(seed, sample), place));
            }
        },
    );
}

/// A number strictly between 0 and 1 from the bits.
#[inline(always)]
fn share(bits: u64) -> f64 {
    ((bits >> 11) as f64 + 0.5) / (1_u64 << 53) as f64
}

/// Two independent standard normal numbers that belong to this seed, sample and place.
///
/// Box and Muller, *Ann. Math. Stat.* 29 (1958), over a mixed counter.
pub fn normal_pair(seed: u64, sample: u64, place: u64) -> [f64; 2] {
    let [u, v] = two_uniform(uniform_bits(seed, sample, place));
    normals(u, v)
}

/// 64 random bits that belong to this seed, sample and place.
#[inline]
pub fn uniform_bits(seed: u64, sample: u64, place: u64) -> u64 {
    bits_at(key(seed, sample), place)
}

/// Random key shared by all numbers of a sample.
#[inline(always)]
pub fn key(seed: u64, sample: u64) -> u64 {
    mix(seed ^ sample.wrapping_mul(0x9e37_79b9_7f4a_7c15))
}

/// 64 random bits of the sample with that key.
#[inline(always)]
pub fn bits_at(key: u64, place: u64) -> u64 {
    mix(key ^ place.wrapping_mul(0xd1b5_4a32_d192_ed03))
}

/// Two numbers strictly between 0 and 1 from the halves of the bits.
#[inline(always)]
pub fn two_uniform(bits: u64) -> [f64; 2] {
    // 2⁵² + n as a number is its bits and those of 2⁵² side by side.
    const SIDE: f64 = 4_503_599_627_370_496.0;
    let half = |bits: u64| (f64::from_bits(SIDE.to_bits() | bits) - (SIDE - 0.5)) / 4_294_967_296.0;
    [half(bits >> 32), half(bits & 0xffff_ffff)]
}

/// Two independent standard normal numbers `√(−2 ln u) (cos 2πv, sin 2πv)` from two uniform ones.
#[inline(always)]
pub fn normals<S: Real>(u: S, v: S) -> [S; 2] {
    let radius = (u.ln() * -2.0).sqrt();
    let angle = v * TAU;
    [radius * angle.cos(), radius * angle.sin()]
}

/// The finaliser of SplitMix64: a permutation of the 64-bit numbers.
#[inline(always)]
pub fn mix(mut bits: u64) -> u64 {
    bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    bits ^ (bits >> 31)
}
