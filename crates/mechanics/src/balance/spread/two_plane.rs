//! A million samples of balancing in two planes: the formula of the worked solution, [`two_plane_weights`], on lanes.

use std::{array::from_fn, thread};

use crate::{
    Real,
    balance::{Phasor, two_plane_weights},
};
use dalembert_numerics::{
    random::{bits_at, key, normals, two_uniform},
    simd::{SimdVector, WIDTH, widest},
};

/// Samples whose sums are taken together, whatever thread does it: a whole number of lanes.
const BLOCK: usize = 4096;
/// Seed of the normal numbers: sample n takes `normal_pair(SEED, n, place)` at the places 1 to 6, first for the four
/// coefficients by rows, then for the two readings.
pub const SEED: u64 = 0x5eed_ba1a;

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
    spread: [f64; 2],
    samples: usize,
    threads: usize,
) -> [Statistics; 2] {
    let lanes = |p: Phasor<f64>| Phasor { x: SimdVector::from(p.x), y: SimdVector::from(p.y) };
    let job = Job { alpha: alpha.map(|row| row.map(lanes)), readings: readings.map(lanes), spread };
    // Deviations are summed about the weights without disturbance, so that nothing cancels.
    let centre = job.sizes(|| Phasor { x: SimdVector::from(0.0), y: SimdVector::from(0.0) });
    let block = |block: usize| {
        let end = samples.min((block + 1) * BLOCK);
        widest(
            #[inline(always)]
            || job.sums(centre, block * BLOCK..end),
        )
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
        Statistics { mean: centre[plane].value() + mean, deviation: (square - mean * mean).max(0.0).sqrt() }
    })
}

/// Readings to disturb, and their uncertainties.
struct Job {
    alpha: [[Phasor<SimdVector>; 2]; 2],
    readings: [Phasor<SimdVector>; 2],
    spread: [f64; 2],
}

impl Job {
    /// The sizes of the weights under disturbances by such standard normal numbers.
    #[inline(always)]
    fn sizes(&self, mut normal: impl FnMut() -> Phasor<SimdVector>) -> [SimdVector; 2] {
        let [of_alpha, of_readings] = self.spread;
        let (mut alpha, mut readings) = (self.alpha, self.readings);
        for a in alpha.as_flattened_mut() {
            let n = normal();
            *a = a.plus(a.times(Phasor { x: n.x * of_alpha, y: n.y * of_alpha }));
        }
        for v in &mut readings {
            let n = normal();
            *v = v.plus(Phasor { x: n.x * of_readings, y: n.y * of_readings });
        }
        let [first, second] = two_plane_weights(alpha, readings);
        [first.size(), second.size()]
    }

    /// The sums of the deviations of both sizes, and of their squares, over some samples.
    #[inline(always)]
    fn sums(&self, centre: [SimdVector; 2], samples: std::ops::Range<usize>) -> [f64; 4] {
        let mut sums = [SimdVector::from(0.0); 4];
        for first in samples.clone().step_by(WIDTH) {
            let mut keys = [0; WIDTH];
            for (sample, place) in (first..).zip(&mut keys) {
                *place = key(SEED, sample as u64);
            }
            let mut place = 0;
            let sizes = self.sizes(
                #[inline(always)]
                || {
                    place += 1;
                    normal_lanes(&keys, place)
                },
            );
            let within = SimdVector::of(|lane| if first + lane < samples.end { 1.0 } else { 0.0 });
            for (plane, size) in sizes.into_iter().enumerate() {
                let off = (size - centre[plane]) * within;
                sums[2 * plane] = sums[2 * plane] + off;
                sums[2 * plane + 1] = sums[2 * plane + 1] + off * off;
            }
        }
        sums.map(|lanes| lanes.0.iter().sum())
    }
}

/// Independent standard normal numbers, two for each of the samples with those keys.
#[inline(always)]
fn normal_lanes(keys: &[u64; WIDTH], place: u64) -> Phasor<SimdVector> {
    let (mut u, mut v) = ([0.0; WIDTH], [0.0; WIDTH]);
    for lane in 0..WIDTH {
        [u[lane], v[lane]] = two_uniform(bits_at(keys[lane], place));
    }
    let [x, y] = normals(SimdVector(u), SimdVector(v));
    Phasor { x, y }
}
