//! Many samples of two-plane balancing at once, on lanes that the compiler turns into vector instructions.
//!
//! The formula is [`two_plane_weights`], the one that the worked solution prints; only its numbers are lanes.

use std::{
    array::from_fn,
    f64::consts::{FRAC_PI_2, LN_2},
    ops::{Add, Div, Mul, Neg, Sub},
    thread,
};

use super::{
    Phasor,
    spread::{bits_at, key},
    two_plane_weights,
};
use crate::Real;

/// How many samples go side by side.
const WIDTH: usize = 8;
/// Samples whose sums are taken together, whatever thread does it: a whole number of lanes.
const BLOCK: usize = 4096;
const SEED: u64 = 0x5eed_ba1a;

/// Numbers side by side. Conditions see the first of them, so only formulas without any may be read with lanes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Lanes(pub [f64; WIDTH]);

/// Mean and standard deviation of the size of the weight in a plane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Statistics {
    /// Mean.
    pub mean: f64,
    /// Standard deviation, over the number of samples.
    pub deviation: f64,
}

/// The sizes of the weights in two planes, where each influence coefficient has an uncertainty in proportion to its
/// size and each reading one of its own: standard deviations of the real and of the imaginary part.
///
/// The same to the last bit on any number of threads.
pub fn two_plane_statistics(
    alpha: [[Phasor<f64>; 2]; 2],
    readings: [Phasor<f64>; 2],
    [of_alpha, of_readings]: [f64; 2],
    samples: usize,
    threads: usize,
) -> [Statistics; 2] {
    let lanes = |p: Phasor<f64>| Phasor { x: Lanes::from(p.x), y: Lanes::from(p.y) };
    let (alpha, readings) = (alpha.map(|row| row.map(lanes)), readings.map(lanes));
    // Deviations are summed about the weights without disturbance, so that nothing cancels.
    let centre = two_plane_weights(alpha, readings).map(Phasor::size);
    let block = |block: usize| -> [f64; 4] {
        let mut sums = [Lanes::from(0.0); 4];
        let end = samples.min((block + 1) * BLOCK);
        for first in (block * BLOCK..end).step_by(WIDTH) {
            let keys = from_fn(|lane| key(SEED, (first + lane) as u64));
            let mut place = 0;
            let mut normal = || {
                place += 1;
                normal_lanes(&keys, place)
            };
            let disturbed = alpha.map(|row| {
                row.map(|a| {
                    let n = normal();
                    a.plus(a.times(Phasor { x: n.x * of_alpha, y: n.y * of_alpha }))
                })
            });
            let read = readings.map(|v| {
                let n = normal();
                v.plus(Phasor { x: n.x * of_readings, y: n.y * of_readings })
            });
            let weights = two_plane_weights(disturbed, read);
            let within = Lanes(from_fn(|lane| if first + lane < end { 1.0 } else { 0.0 }));
            for (plane, weight) in weights.into_iter().enumerate() {
                let off = (weight.size() - centre[plane]) * within;
                sums[2 * plane] = sums[2 * plane] + off;
                sums[2 * plane + 1] = sums[2 * plane + 1] + off * off;
            }
        }
        sums.map(|lanes| lanes.0.iter().sum())
    };
    let mut sums = vec![[0.0; 4]; samples.div_ceil(BLOCK)];
    let share = sums.len().div_ceil(threads.max(1)).max(1);
    thread::scope(|scope| {
        for (n, part) in sums.chunks_mut(share).enumerate() {
            let block = &block;
            let mut work = move || {
                for (place, at) in part.iter_mut().zip(n * share..) {
                    *place = block(at);
                }
            };
            if threads > 1 {
                scope.spawn(work);
            } else {
                work();
            }
        }
    });
    let total: [f64; 4] = from_fn(|at| sums.iter().map(|sums| sums[at]).sum());
    let count = samples.max(1) as f64;
    from_fn(|plane| {
        let (mean, square) = (total[2 * plane] / count, total[2 * plane + 1] / count);
        Statistics { mean: centre[plane].0[0] + mean, deviation: (square - mean * mean).max(0.0).sqrt() }
    })
}

/// Independent standard normal numbers, two for each of the samples with those keys.
#[inline]
fn normal_lanes(keys: &[u64; WIDTH], place: u64) -> Phasor<Lanes> {
    let bits = keys.map(|key| bits_at(key, place));
    let radius = Lanes(from_fn(|lane| (-2.0 * ln_unit(bits[lane] >> 32)).sqrt()));
    let (mut x, mut y) = (Lanes::from(0.0), Lanes::from(0.0));
    for lane in 0..WIDTH {
        (x.0[lane], y.0[lane]) = turn(bits[lane]);
    }
    Phasor { x: x * radius, y: y * radius }
}

/// `ln((n + ½)/2³²)` for a number of 32 bits: the series of artanh about the nearest power of two.
#[inline]
fn ln_unit(n: u64) -> f64 {
    const MANTISSA: u64 = (1 << 52) - 1;
    // 2⁵² + n as a number is its bits and those of 2⁵² side by side.
    let whole = f64::from_bits(0x4330_0000_0000_0000 | n) - (4_503_599_627_370_496.0 - 0.5);
    let bits = whole.to_bits();
    let exponent =
        f64::from_bits(0x4330_0000_0000_0000 | (bits >> 52)) - (4_503_599_627_370_496.0 + 1023.0 + 32.0);
    let mantissa = f64::from_bits((bits & MANTISSA) | 0x3ff0_0000_0000_0000);
    let above = mantissa > std::f64::consts::SQRT_2;
    let m = if above { mantissa * 0.5 } else { mantissa };
    let k = if above { exponent + 1.0 } else { exponent };
    let s = (m - 1.0) / (m + 1.0);
    let q = s * s;
    // |s| ≤ 0.1716: the terms left out are below 10⁻⁹, far less than a million samples can tell.
    let series = 1.0 + q * (1.0 / 3.0 + q * (1.0 / 5.0 + q * (1.0 / 7.0 + q * (1.0 / 9.0))));
    k * LN_2 + 2.0 * s * series
}

/// Cosine and sine of a random angle: two bits choose the quarter, thirty the place in it.
#[inline]
fn turn(bits: u64) -> (f64, f64) {
    // 30 bits behind the leading one of a number between 1 and 2.
    let t = f64::from_bits(0x3ff0_0000_0000_0000 | (bits & 0x3fff_ffff) << 22 | 1 << 21) - 1.5;
    let x = t * FRAC_PI_2;
    let q = x * x;
    // |x| ≤ π/4: the terms left out are below 10⁻⁹. Products with reciprocals: a division takes ten times as long.
    let sin = x
        * (1.0
            - q * (1.0 / 6.0)
                * (1.0
                    - q * (1.0 / 20.0)
                        * (1.0 - q * (1.0 / 42.0) * (1.0 - q * (1.0 / 72.0) * (1.0 - q * (1.0 / 110.0))))));
    let cos = 1.0
        - q * (1.0 / 2.0)
            * (1.0
                - q * (1.0 / 12.0)
                    * (1.0 - q * (1.0 / 30.0) * (1.0 - q * (1.0 / 56.0) * (1.0 - q * (1.0 / 90.0)))));
    let (a, b) = if bits & (1 << 30) == 0 { (cos, sin) } else { (-sin, cos) };
    if bits & (1 << 31) == 0 { (a, b) } else { (-a, -b) }
}

impl Lanes {
    #[inline]
    fn map(self, f: impl Fn(f64) -> f64) -> Self {
        Self(self.0.map(f))
    }

    #[inline]
    fn with(self, other: Self, f: impl Fn(f64, f64) -> f64) -> Self {
        Self(from_fn(|lane| f(self.0[lane], other.0[lane])))
    }
}

impl From<f64> for Lanes {
    #[inline]
    fn from(x: f64) -> Self {
        Self([x; WIDTH])
    }
}

macro_rules! lane_by_lane {
    ($($trait:ident $method:ident $op:tt),*) => {$(
        impl $trait for Lanes {
            type Output = Self;
            #[inline]
            fn $method(self, other: Self) -> Self {
                self.with(other, |a, b| a $op b)
            }
        }
        impl $trait<f64> for Lanes {
            type Output = Self;
            #[inline]
            fn $method(self, other: f64) -> Self {
                self.map(|a| a $op other)
            }
        }
    )*};
}

lane_by_lane!(Add add +, Sub sub -, Mul mul *, Div div /);

impl Neg for Lanes {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        self.map(|x| -x)
    }
}

impl Real for Lanes {
    #[inline]
    fn value(self) -> f64 {
        self.0[0]
    }
    #[inline]
    fn powi(self, n: i8) -> Self {
        match n {
            2 => self * self,
            _ => self.map(|x| x.powi(n.into())),
        }
    }
    #[inline]
    fn root(self, n: u8) -> Self {
        match n {
            2 => self.map(f64::sqrt),
            _ => self.map(|x| Real::root(x, n)),
        }
    }
    fn abs(self) -> Self {
        self.map(f64::abs)
    }
    fn sin(self) -> Self {
        self.map(f64::sin)
    }
    fn cos(self) -> Self {
        self.map(f64::cos)
    }
    fn tan(self) -> Self {
        self.map(f64::tan)
    }
    fn asin(self) -> Self {
        self.map(f64::asin)
    }
    fn acos(self) -> Self {
        self.map(f64::acos)
    }
    fn atan2(self, x: Self) -> Self {
        self.with(x, f64::atan2)
    }
    fn exp(self) -> Self {
        self.map(f64::exp)
    }
    fn ln(self) -> Self {
        self.map(f64::ln)
    }
    fn sum(terms: impl IntoIterator<Item = Self>) -> Self {
        terms.into_iter().fold(Self::from(0.0), Add::add)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn logarithm_and_turn_are_those_of_the_library() {
        for n in [0u64, 1, 2, 1000, 0x5555_5555, 0x8000_0000, 0xb504_f333, 0xffff_fffe, 0xffff_ffff] {
            let u = (n as f64 + 0.5) / 4_294_967_296.0;
            assert!((ln_unit(n) - u.ln()).abs() <= 1e-9, "{n}");
            let (x, y) = turn(n);
            assert!((x.hypot(y) - 1.0).abs() <= 1e-9, "{n}: {x}, {y}");
            let t = ((n & 0x3fff_ffff) as f64 + 0.5) / 1_073_741_824.0 - 0.5;
            let angle = ((n >> 30) as f64 + t) * FRAC_PI_2;
            assert!((x - angle.cos()).abs() <= 1e-9 && (y - angle.sin()).abs() <= 1e-9, "{n}");
        }
    }

    #[test]
    fn moments_are_those_of_the_normal_distribution() {
        let mut sums = [0.0; 4];
        let count = 200_000u64;
        for first in (0..count).step_by(WIDTH) {
            let keys = from_fn(|lane| key(SEED, first + lane as u64));
            for x in normal_lanes(&keys, 3).x.0 {
                for (n, sum) in (1..).zip(&mut sums) {
                    *sum += x.powi(n);
                }
            }
        }
        let moments = sums.map(|sum| sum / count as f64);
        for (moment, (want, error)) in
            moments.into_iter().zip([(0.0, 1.0), (1.0, 1.42), (0.0, 3.9), (3.0, 9.8)])
        {
            assert!((moment - want).abs() < 4.0 * error / (count as f64).sqrt(), "{moment} for {want}");
        }
    }

    #[test]
    fn threads_do_not_change_a_bit_and_statistics_are_the_exact_ones() {
        let p = |x, y| Phasor { x, y };
        let alpha = [[p(0.8, 0.3), p(0.2, -0.1)], [p(0.15, 0.05), p(0.7, -0.25)]];
        let readings = [Phasor::polar(4.2, 0.6), Phasor::polar(3.1, -1.9)];
        let run = |samples, threads| two_plane_statistics(alpha, readings, [0.02, 0.05], samples, threads);
        let one = run(100_003, 1);
        for threads in [2, 3, 16] {
            assert_eq!(one, run(100_003, threads));
        }
        // Without disturbance nothing spreads.
        let still = two_plane_statistics(alpha, readings, [0.0, 0.0], 1000, 1);
        let exact = two_plane_weights(alpha, readings);
        for (still, (exact, noisy)) in still.iter().zip(exact.iter().zip(&one)) {
            assert!((still.mean - exact.size()).abs() < 1e-14 && still.deviation < 1e-14);
            assert!((noisy.mean / exact.size() - 1.0).abs() < 2e-3, "{noisy:?} about {}", exact.size());
            // Each of the parts, 2 % of the coefficients and 0.05 of the readings, spreads the size by about 2 %.
            assert!((0.01..0.05).contains(&(noisy.deviation / exact.size())), "{noisy:?}");
        }
    }
}
