//! Quantiles of distributions: published values, and moments of many samples.

use dalembert_numerics::{
    distribution::{Distribution, normal_cumulative, normal_quantile, quantile_of_sorted},
    random::{uniform, uniforms},
};
use itertools::Itertools as _;

fn near(a: f64, b: f64, tolerance: f64) {
    assert!((a - b).abs() <= tolerance * b.abs().max(1e-300), "{a} is not {b}");
}

#[test]
fn normal_quantiles_are_the_published_ones() {
    // M. Abramowitz and I. A. Stegun, table 26.5, with more digits from the inverse of the error function.
    for (share, number) in [
        (0.975, 1.959_963_984_540_054),
        (0.95, 1.644_853_626_951_472_2),
        (0.995, 2.575_829_303_548_900_4),
        (0.999_999, 4.753_424_308_817_087),
    ] {
        near(normal_quantile(share), number, 2e-15);
        // What is left of the digits of a share near 1 is those of its distance from 1.
        near(normal_quantile(1.0 - share), -number, 1e-10);
        near(normal_cumulative(number), share, 1e-15);
    }
    assert!(normal_quantile(0.5).abs() < 1e-15);
    assert!(normal_cumulative(-50.0) > 0.0 && normal_cumulative(50.0) < 1.0);
}

/// Mean and standard deviation of samples with evenly spread shares.
fn moments(distribution: &Distribution) -> (f64, f64) {
    let count = 200_000;
    let values: Vec<f64> =
        (0..count).map(|n| distribution.quantile((f64::from(n) + 0.5) / f64::from(count))).collect();
    let mean = values.iter().sum::<f64>() / f64::from(count);
    let variance = values.iter().map(|value| (value - mean).powi(2)).sum::<f64>() / f64::from(count);
    (mean, variance.sqrt())
}

#[test]
fn moments_are_those_of_the_parameters() {
    let close = |distribution: Option<Distribution>, mean: f64, deviation: f64| {
        let found = moments(&distribution.expect("sound parameters"));
        near(found.0, mean, 1e-4);
        near(found.1, deviation, 1e-3);
    };
    close(Distribution::uniform(2.0, 5.0), 3.5, 3.0 / 12_f64.sqrt());
    close(Distribution::normal(10.0, 0.5), 10.0, 0.5);
    close(Distribution::lognormal(10.0, 3.0), 10.0, 3.0);
    // Mean (a + b + c)/3 and variance (a² + b² + c² − ab − ac − bc)/18.
    close(Distribution::triangular(1.0, 2.0, 6.0), 3.0, (14.0 / 12.0_f64).sqrt());
    close(Distribution::of_data(vec![3.0, 1.0, 2.0]), 2.0, 2.0 / 12_f64.sqrt());
}

#[test]
fn parameters_without_a_distribution_are_refused() {
    assert_eq!(Distribution::uniform(5.0, 2.0), None);
    assert_eq!(Distribution::normal(1.0, 0.0), None);
    assert_eq!(Distribution::normal(f64::NAN, 1.0), None);
    assert_eq!(Distribution::lognormal(-1.0, 1.0), None);
    assert_eq!(Distribution::triangular(1.0, 7.0, 6.0), None);
    assert_eq!(Distribution::of_data(vec![1.0]), None);
    assert_eq!(Distribution::of_data(vec![1.0, f64::INFINITY]), None);
}

#[test]
fn quantiles_of_values_are_on_straight_lines_between_them() {
    let values = [1.0, 2.0, 4.0, 8.0, 16.0];
    for (share, value) in [(0.0, 1.0), (0.25, 2.0), (0.5, 4.0), (0.625, 6.0), (1.0, 16.0)] {
        near(quantile_of_sorted(&values, share), value, 1e-15);
    }
    assert_eq!(quantile_of_sorted(&[], 0.5), 0.0);
}

#[test]
fn uniform_numbers_fill_their_range_evenly() {
    let mut counts = [0_u32; 10];
    for sample in 0..100_000 {
        counts[(uniform(5, sample, 2) * 10.0) as usize] += 1;
    }
    // Each count has a standard deviation of 95.
    assert!(counts.iter().all(|count| count.abs_diff(10_000) < 500), "{counts:?}");
}

#[test]
fn quantiles_of_many_shares_are_those_of_each() {
    let distributions = [
        Distribution::normal(3.0, 0.2),
        Distribution::lognormal(2.0, 0.1),
        Distribution::uniform(-1.0, 4.0),
        Distribution::triangular(-1.0, 0.5, 4.0),
        Distribution::of_data(vec![1.0, 3.0, 4.5]),
    ];
    for count in [0, 1, 15, 16, 300, 1029] {
        let mut shares = vec![0.0; count];
        uniforms(7, 5, 3, &mut shares);
        for (n, share) in shares.iter().enumerate() {
            assert_eq!(share.to_bits(), uniform(7, 5 + n as u64, 3).to_bits());
        }
        // Both tails, their ends and what lies far out in them.
        let far = [0.075, 0.925, 0.5, 1e-3, 1e-9, 1e-12, 1e-300, 1.0 - 1e-16];
        for (n, share) in far.into_iter().enumerate().take(count) {
            shares[n * 7 % count] = share;
        }
        for distribution in distributions.iter().flatten() {
            let mut found = shares.clone();
            distribution.quantiles(&mut found);
            for (share, found) in shares.iter().zip_eq(&found) {
                assert_eq!(
                    found.to_bits(),
                    distribution.quantile(*share).to_bits(),
                    "{distribution:?} at {share:e}"
                );
            }
        }
    }
}
