//! Points that fill the unit cube: strata, integrals, and the published beginning of the Sobol' sequence.

use dalembert_numerics::{
    random::uniform,
    sampling::{SOBOL_DIMENSIONS, latin_hypercube, sobol},
};

/// Asserts that each of `count` equal intervals holds one of the numbers.
fn assert_one_in_each(count: usize, numbers: impl Iterator<Item = f64>, what: &str) {
    let mut seen = vec![0; count];
    for number in numbers {
        assert!(number > 0.0 && number < 1.0, "{what}: {number}");
        seen[(number * count as f64) as usize] += 1;
    }
    assert!(seen.iter().all(|count| *count == 1), "{what}: {seen:?}");
}

#[test]
fn a_latin_hypercube_has_one_sample_in_each_stratum() {
    for samples in [1_usize, 2, 3, 7, 64, 100, 1000] {
        for dimension in 0..4 {
            let count = samples as u64;
            let numbers = (0..count).map(|sample| latin_hypercube(7, count, sample, dimension));
            assert_one_in_each(samples, numbers, &format!("{samples} samples, dimension {dimension}"));
        }
    }
}

#[test]
fn the_dimensions_of_a_latin_hypercube_are_shuffled() {
    let count = 1000;
    let mut sum = 0.0;
    for sample in 0..count {
        let [x, y] = [0, 1].map(|dimension| latin_hypercube(7, count, sample, dimension) - 0.5);
        sum += x * y;
    }
    // The correlation of independent numbers has a standard deviation of 1/√1000.
    assert!((12.0 * sum / count as f64).abs() < 0.1, "{sum}");
}

#[test]
fn every_power_of_two_of_sobol_points_fills_each_dimension() {
    for dimension in 0..SOBOL_DIMENSIONS {
        for power in [1, 4, 8, 10] {
            let count = 1_usize << power;
            let numbers = (0..count as u64).map(|sample| sobol(3, sample, dimension));
            assert_one_in_each(count, numbers, &format!("{count} points, dimension {dimension}"));
        }
    }
}

#[test]
fn the_first_two_dimensions_fill_every_elementary_rectangle() {
    // A (0, 2)-sequence in base 2: 256 points, one in each rectangle of area 1/256.
    for split in 0..=8 {
        let (across, up) = (f64::from(1 << split), f64::from(1 << (8 - split)));
        let numbers = (0..256).map(|sample| {
            let [x, y] = [0, 1].map(|dimension| sobol(11, sample, dimension));
            ((x * across).floor() * up + (y * up).floor() + 0.5) / 256.0
        });
        assert_one_in_each(256, numbers, &format!("{across} by {up}"));
    }
}

#[test]
fn integrals_converge_faster_than_with_random_points() {
    // The product of |4x − 2| over six dimensions has the integral 1.
    let product = |coordinate: &dyn Fn(u64, usize) -> f64, count: u64| {
        let one = |sample| {
            (0..6).map(|dimension| (4.0 * coordinate(sample, dimension) - 2.0).abs()).product::<f64>()
        };
        (0..count).map(one).sum::<f64>() / count as f64 - 1.0
    };
    let count = 1 << 14;
    let root_mean_square = |coordinate: &dyn Fn(u64, u64, usize) -> f64| {
        let errors = (0..8).map(|seed| product(&|sample, at| coordinate(seed, sample, at), count).powi(2));
        (errors.sum::<f64>() / 8.0).sqrt()
    };
    let random = root_mean_square(&|seed, sample, at| uniform(seed, sample, at as u64));
    let even = root_mean_square(&sobol);
    assert!(even < random / 5.0, "Sobol' {even:.1e}, random {random:.1e}");
}

#[test]
fn other_seeds_give_other_points() {
    assert_ne!(sobol(1, 5, 3), sobol(2, 5, 3));
    assert_ne!(latin_hypercube(1, 100, 5, 3), latin_hypercube(2, 100, 5, 3));
    assert_ne!(uniform(1, 5, 3), uniform(2, 5, 3));
}
