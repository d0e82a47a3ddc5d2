//! Benchmark of a million Monte Carlo samples of two-plane balancing: the formula of the worked solution on SIMD
//! vectors.
//!
//! Prints `name<TAB>figure<TAB>goal`, a row a line; `cargo xtask bench` makes a table of them.

use std::{hint::black_box, thread, time::Instant};

use dalembert_mechanics::balance::{
    Phasor,
    spread::{Statistics, two_plane_statistics},
};

const SAMPLES: usize = 1_000_000;
const ROUNDS: usize = 9;

fn main() {
    let cores = thread::available_parallelism().map_or(1, usize::from);
    let (one, alone) = measure(1);
    let (all, together) = measure(cores);
    assert_eq!(one, all, "the statistics are the same to the last bit on any number of threads");
    println!("two-plane balancing, 1e6 samples, one thread\t{alone:.1} ms\t≤ 40 ms");
    println!("two-plane balancing, 1e6 samples, {cores} threads\t{together:.1} ms\t≤ 40 ms");
    for (plane, statistics) in (1..).zip(one) {
        println!("plane {plane}: mean weight\t{:.6}\t", statistics.mean);
        println!("plane {plane}: standard deviation\t{:.6}\t", statistics.deviation);
    }
}

/// The statistics, and the shortest time of a few rounds, ms.
fn measure(threads: usize) -> ([Statistics; 2], f64) {
    let p = |x, y| Phasor { x, y };
    let alpha = [[p(0.8, 0.3), p(0.2, -0.1)], [p(0.15, 0.05), p(0.7, -0.25)]];
    let readings = [Phasor::polar(4.2, 0.6), Phasor::polar(3.1, -1.9)];
    let mut best = f64::INFINITY;
    let run = || two_plane_statistics(black_box(alpha), black_box(readings), [0.02, 0.05], SAMPLES, threads);
    let statistics = run();
    for _ in 0..ROUNDS {
        let start = Instant::now();
        black_box(run());
        best = best.min(start.elapsed().as_secs_f64() * 1e3);
    }
    (statistics, best)
}
