//! Statistics of balancing in two planes, compared with a loop over samples and with the undisturbed weights.

use dalembert_mechanics::balance::{
    Phasor,
    spread::{SEED, two_plane_statistics},
    two_plane_weights,
};
use dalembert_numerics::random::normal_pair;
use itertools::Itertools as _;

/// Influence coefficients and readings of two planes.
fn rotor() -> ([[Phasor<f64>; 2]; 2], [Phasor<f64>; 2]) {
    let p = |x, y| Phasor { x, y };
    let alpha = [[p(0.8, 0.3), p(0.2, -0.1)], [p(0.15, 0.05), p(0.7, -0.25)]];
    (alpha, [Phasor::polar(4.2, 0.6), Phasor::polar(3.1, -1.9)])
}

#[test]
fn statistics_are_those_of_a_loop_over_samples() {
    const SAMPLES: u64 = 10_001;
    let (alpha, readings) = rotor();
    let [of_alpha, of_readings] = [0.02, 0.05];
    let sizes: Vec<[f64; 2]> = (0..SAMPLES)
        .map(|sample| {
            let normal = |place| {
                let [x, y] = normal_pair(SEED, sample, place);
                Phasor { x, y }
            };
            let scaled = |n: Phasor<f64>, by: f64| Phasor { x: n.x * by, y: n.y * by };
            let coefficient = |row: usize, column: usize| {
                let a = alpha[row][column];
                a.plus(a.times(scaled(normal(1 + 2 * row as u64 + column as u64), of_alpha)))
            };
            let reading = |row: usize| readings[row].plus(scaled(normal(5 + row as u64), of_readings));
            let disturbed = [[coefficient(0, 0), coefficient(0, 1)], [coefficient(1, 0), coefficient(1, 1)]];
            two_plane_weights(disturbed, [reading(0), reading(1)]).map(Phasor::size)
        })
        .collect();
    let found = two_plane_statistics(alpha, readings, [of_alpha, of_readings], SAMPLES as usize, 1);
    for (plane, found) in found.iter().enumerate() {
        let mean = sizes.iter().map(|size| size[plane]).sum::<f64>() / SAMPLES as f64;
        let square = sizes.iter().map(|size| (size[plane] - mean).powi(2)).sum::<f64>() / SAMPLES as f64;
        assert!((found.mean / mean - 1.0).abs() < 1e-12, "{found:?}: {mean}");
        assert!((found.deviation / square.sqrt() - 1.0).abs() < 1e-10, "{found:?}: {}", square.sqrt());
    }
}

#[test]
fn threads_do_not_change_a_bit_and_statistics_are_the_exact_ones() {
    let (alpha, readings) = rotor();
    let run = |samples, threads| two_plane_statistics(alpha, readings, [0.02, 0.05], samples, threads);
    let one = run(100_003, 1);
    for threads in [2, 3, 16] {
        assert_eq!(one, run(100_003, threads));
    }
    // Without disturbance nothing spreads.
    let still = two_plane_statistics(alpha, readings, [0.0, 0.0], 1000, 1);
    let exact = two_plane_weights(alpha, readings);
    for (still, (exact, noisy)) in still.iter().zip_eq(exact.iter().zip_eq(&one)) {
        assert!((still.mean - exact.size()).abs() < 1e-14 && still.deviation < 1e-14);
        assert!((noisy.mean / exact.size() - 1.0).abs() < 2e-3, "{noisy:?} about {}", exact.size());
        // Each of the parts, 2 % of the coefficients and 0.05 of the readings, spreads the size by about 2 %.
        assert!((0.01..0.05).contains(&(noisy.deviation / exact.size())), "{noisy:?}");
    }
}
