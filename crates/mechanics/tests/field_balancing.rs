//! Field balancing of simulated rotors.

use dalembert_mechanics::balance::{
    influence::{TrialRun, collinearity, influence_coefficients, least_squares, residuals},
    minimax::min_max,
    spread::{Choice, Influence, Measurement, ReadingSpread, ranges},
    without_phase::effect,
};
use dalembert_numerics::random::{normal_pair, uniform_bits};
use itertools::Itertools as _;
use nalgebra::{Complex, DMatrix};
use proptest::prelude::*;

/// A rotor drawn from a number: influence of each plane on each reading, and unbalance in each plane.
fn rotor(seed: u64, readings: usize, planes: usize) -> (DMatrix<Complex<f64>>, Vec<Complex<f64>>) {
    let number = |place: usize| {
        let [x, y] = normal_pair(seed, 0, place as u64);
        Complex::new(x, y)
    };
    let alpha = DMatrix::from_fn(readings, planes, |row, plane| number(row * planes + plane));
    (alpha, (0..planes).map(|plane| number(readings * planes + plane) * 30.0).collect())
}

/// Readings of the sensors with those weights, `V + α W`.
fn read(alpha: &DMatrix<Complex<f64>>, weights: &[Complex<f64>]) -> Vec<Complex<f64>> {
    residuals(alpha, &vec![Complex::ZERO; alpha.nrows()], weights)
}

/// A run with each trial weight, the ones before taken off or not.
fn runs(alpha: &DMatrix<Complex<f64>>, unbalance: &[Complex<f64>], stay: bool) -> Vec<TrialRun> {
    let mut on = unbalance.to_vec();
    (0..unbalance.len())
        .map(|plane| {
            if !stay {
                on = unbalance.to_vec();
            }
            let weight = Complex::from_polar(10.0, plane as f64);
            on[plane] += weight;
            TrialRun { plane, weight, readings: read(alpha, &on) }
        })
        .collect()
}

/// `|a*·b|/(|a||b|)`, whatever the size and the angle that a weight is counted in.
#[test]
fn collinearity_is_the_cosine_between_the_effects_of_two_planes() {
    let (alpha, _) = rotor(20, 4, 3);
    let product: Complex<f64> = (0..4).map(|row| alpha[(row, 0)].conj() * alpha[(row, 2)]).sum();
    let length = |plane: usize| (0..4).map(|row| alpha[(row, plane)].norm_sqr()).sum::<f64>().sqrt();
    let cosine = product.norm() / (length(0) * length(2));
    let alike = Complex::new(-1.3_f64, 0.6);
    for size in [1.0_f64, 3.7e-5, 2.9e190] {
        let unit = Complex::from_polar(size, 0.7);
        let scaled = DMatrix::from_fn(4, 3, |row, plane| match plane {
            0 => alpha[(row, 0)],
            1 => alpha[(row, 0)] * alike * unit,
            _ => alpha[(row, 2)] * unit,
        });
        for (one, other, expected) in [(0, 2, cosine), (2, 0, cosine), (0, 1, 1.0), (1, 2, cosine)] {
            let found = collinearity(&scaled, one, other);
            assert!((found - expected).abs() < 1e-13, "{one} and {other}: {found} is not {expected}");
        }
    }
}

/// The last centre of this one was once left before its bound was near.
#[test]
fn a_limit_in_three_planes_is_proved_too() {
    let (alpha, unbalance) = rotor(15109276555044017607, 5, 3);
    let first: Vec<Complex<f64>> = read(&alpha, &unbalance)
        .into_iter()
        .enumerate()
        .map(|(n, v)| v + Complex::cis(n as f64) * 9.0)
        .collect();
    let limit = 0.8 * least_squares(&alpha, &first, &[]).unwrap().weights[0].norm();
    let found = min_max(&alpha, &first, Some(limit)).unwrap();
    let size = first.iter().map(|v| v.norm()).fold(0.0, f64::max);
    assert!(found.largest - found.bound <= 1e-9 * size, "{} and {}", found.largest, found.bound);
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(200) })]

    #[test]
    fn trial_runs_recover_the_unbalance(seed: u64, planes in 1usize..6, more in 0usize..5, stay: bool) {
        let (alpha, unbalance) = rotor(seed, planes + more, planes);
        let first = read(&alpha, &unbalance);
        let found = influence_coefficients(&first, &runs(&alpha, &unbalance, stay), stay).unwrap();
        let solved = least_squares(&found, &first, &[]).unwrap();
        let size = unbalance.iter().map(|u| u.norm()).fold(0.0, f64::max);
        for (weight, unbalance) in solved.weights.iter().zip_eq(&unbalance) {
            let off = (weight + unbalance).norm();
            prop_assert!(off <= solved.condition * 1e-10 * size, "{weight} for {unbalance}");
        }
    }

    #[test]
    fn the_largest_reading_is_proved_least(seed: u64, planes in 1usize..4, more in 1usize..8, limited: bool) {
        let (alpha, unbalance) = rotor(seed, planes + more, planes);
        let first: Vec<Complex<f64>> =
            read(&alpha, &unbalance).into_iter().enumerate().map(|(n, v)| v + Complex::cis(n as f64) * 9.0).collect();
        let squares = least_squares(&alpha, &first, &[]).unwrap();
        let limit = limited.then(|| squares.weights[0].norm() * 0.8);
        let found = min_max(&alpha, &first, limit).unwrap();
        let size = first.iter().map(|v| v.norm()).fold(0.0, f64::max);
        // Of one rotor in thousands rounding leaves more than 1e-9 open.
        prop_assert!(found.largest - found.bound <= 1e-7 * size, "{} and {}", found.largest, found.bound);
        if let Some(limit) = limit {
            prop_assert!(found.weights.iter().all(|w| w.norm() <= limit));
        } else {
            let by_squares = squares.residuals.iter().map(|r| r.norm()).fold(0.0, f64::max);
            prop_assert!(found.largest <= by_squares * (1.0 + 1e-9));
        }
    }

    #[test]
    fn sizes_alone_recover_the_effect(seed: u64) {
        let [x, y] = normal_pair(seed, 0, 0);
        let z = Complex::new(x, y);
        let runs: Vec<(f64, f64)> =
            [0.3, 2.2, 4.4].iter().map(|angle| (*angle, (z * Complex::cis(*angle) + 1.0).norm())).collect();
        let found = effect(&runs).unwrap();
        for found in [found.best, found.linear] {
            prop_assert!((found - z).norm() <= 1e-9 * (1.0 + z.norm()));
        }
        prop_assert!((found.mean_square - z.norm_sqr()).abs() <= 1e-9 * (1.0 + z.norm_sqr()));
    }
}

/// Sizes that no effect has exactly: about the best effect the sum of squares of what it leaves is level.
#[test]
fn the_best_effect_leaves_the_least_squares() {
    for (size, angle) in [(0.7, 1.1), (2.4, -2.0), (0.35, 0.4)] {
        let z = Complex::from_polar(size, angle);
        let noise = [(0.3, 1.06), (1.7, 0.93), (3.1, 1.04), (4.0, 0.97), (5.5, 1.08)];
        let runs = noise.map(|(angle, noise)| (angle, noise * (z * Complex::cis(angle) + 1.0).norm()));
        let found = effect(&runs).unwrap();
        let squares = |z: Complex<f64>| -> f64 {
            runs.iter().map(|(angle, size)| ((z * Complex::cis(*angle) + 1.0).norm() - size).powi(2)).sum()
        };
        let left: f64 = found.left.iter().map(|left| left * left).sum();
        assert!(left > 1e-4 && (left - squares(found.best)).abs() < 1e-12 * left);
        let step = 1e-3;
        for toward in [Complex::ONE, Complex::I] {
            let [a, b, c, d] = [-2.0, -1.0, 1.0, 2.0].map(|k| squares(found.best + toward * (k * step)));
            let slope = (a - 8.0 * b + 8.0 * c - d) / (12.0 * step);
            assert!(slope.abs() < 1e-10, "{slope:e} at {} for {z}", found.best);
        }
    }
}

/// Of jobs that were really measured with that uncertainty, 95 of 100 have the truth within their ranges.
#[test]
fn ranges_cover_the_truth_as_often_as_they_claim() {
    let spread = ReadingSpread { amplitude: 0.005, phase: 0.008 };
    let mut jobs = 0;
    let mut covered = [0; 4];
    for job in 0..1500 {
        let (alpha, unbalance) = rotor(job, 3, 2);
        // What the field would not balance from these trial weights is left out.
        let exact = read(&alpha, &unbalance);
        if least_squares(&alpha, &exact, &[]).unwrap().condition > 4.0
            || unbalance.iter().any(|u| !(10.0..60.0).contains(&u.norm()))
        {
            continue;
        }
        jobs += 1;
        let mut place = 0;
        let mut measure = |readings: Vec<Complex<f64>>| -> Vec<Complex<f64>> {
            let disturb = |v: Complex<f64>| {
                let [a, b] = normal_pair(77, job, place);
                place += 1;
                v * Complex::from_polar(1.0 + spread.amplitude * a, spread.phase * b)
            };
            readings.into_iter().map(disturb).collect()
        };
        let first = measure(read(&alpha, &unbalance));
        let mut trials = runs(&alpha, &unbalance, false);
        for run in &mut trials {
            run.readings = measure(run.readings.clone());
        }
        let found = influence_coefficients(&first, &trials, false).unwrap();
        let weights = least_squares(&found, &first, &[]).unwrap().weights;
        let influence = Influence::Runs(&trials, false);
        let measured = Measurement { first: &first, influence, choice: Choice::LeastSquares(&[]), spread };
        let ranges = ranges(&measured, &weights, 400, 1).unwrap();
        for plane in 0..2 {
            let truth = -unbalance[plane];
            let [low, high] = ranges.sizes[plane];
            covered[plane] += u32::from((low..=high).contains(&truth.norm()));
            let [low, high] = ranges.angles[plane];
            let turn = (truth / weights[plane]).arg() + weights[plane].arg();
            covered[2 + plane] += u32::from((low..=high).contains(&turn));
        }
    }
    for covered in covered {
        let share = f64::from(covered) / f64::from(jobs);
        println!("{share} of {jobs}");
        // Three standard deviations of the count, and what 400 samples leave open.
        assert!((0.92..=0.98).contains(&share), "{share} of the jobs are covered");
    }
}

/// A plane that needs next to nothing: noise makes weights of any angle, and the range begins at none.
#[test]
fn every_range_holds_the_weight_that_it_is_about() {
    let mut lost = 0;
    for job in 0..100 {
        let (alpha, mut unbalance) = rotor(job, 3, 2);
        unbalance[1] *= 1e-4;
        let first = read(&alpha, &unbalance);
        let influence = Influence::Known(&alpha);
        let spread = ReadingSpread { amplitude: 0.02, phase: 0.03 };
        let measured = Measurement { first: &first, influence, choice: Choice::LeastSquares(&[]), spread };
        let weights = least_squares(&alpha, &first, &[]).unwrap().weights;
        let ranges = ranges(&measured, &weights, 400, 1).unwrap();
        for (plane, weight) in weights.iter().enumerate() {
            let ([low, high], [from, to]) = (ranges.sizes[plane], ranges.angles[plane]);
            assert!((low..=high).contains(&weight.norm()), "job {job}: {} in {low} to {high}", weight.norm());
            assert!((from..=to).contains(&weight.arg()), "job {job}: {} in {from} to {to}", weight.arg());
            if low == 0.0 {
                assert!((to - from - std::f64::consts::TAU).abs() < 1e-12);
                lost += 1;
            }
        }
    }
    assert!(lost >= 90, "{lost} of 100 weights of nothing were distinguished from none");
}

/// The samples are the same to the last bit on any number of threads.
#[test]
fn threads_do_not_change_a_bit() {
    let (alpha, unbalance) = rotor(5, 4, 2);
    let first = read(&alpha, &unbalance);
    let measured = Measurement {
        first: &first,
        influence: Influence::Known(&alpha),
        choice: Choice::LeastSquares(&[]),
        spread: ReadingSpread { amplitude: 0.02, phase: 0.03 },
    };
    let weights: Vec<Complex<f64>> = unbalance.iter().map(|u| -u).collect();
    let one = ranges(&measured, &weights, 1000, 1).unwrap();
    for threads in [2, 3, 7, 64] {
        assert_eq!(one, ranges(&measured, &weights, 1000, threads).unwrap());
    }
    assert_ne!(uniform_bits(1, 2, 3), uniform_bits(1, 3, 2));
}

/// Foiles' turbine: four planes, eleven readings.
fn foiles() -> (DMatrix<Complex<f64>>, Vec<Complex<f64>>) {
    let row = |text: &str| -> Vec<Complex<f64>> {
        text.split(' ')
            .map(|entry| {
                let (size, angle) = entry.split_once('@').expect("a weight and its angle");
                let [size, angle]: [f64; 2] = [size, angle].map(|text| text.parse().expect("a number"));
                Complex::from_polar(size, angle.to_radians())
            })
            .collect()
    };
    let rows = [
        "9.8@117 17@124 7.2@114 38.5@77",
        "2.7@43 14.3@317 4.5@213 14.3@270",
        "12.5@323 25@261 15.2@158 30@238",
        "22.4@92 32.6@45 23.3@315 27.8@210",
        "26@94 40.3@9 25@330 34@213",
        "40.3@355 43@144 29.6@61 65.4@322",
        "20.6@339 32.3@152 36.7@41 61.8@322",
        "12.6@226 37.6@52 18.8@153 26@176",
        "13.4@209 26.9@76 47.5@98 71.7@312",
        "13.4@154 22.4@307 52@299 102@165",
        "5.4@24 7.2@199 22.4@2 27.8@99",
    ];
    let entries: Vec<Complex<f64>> = rows.iter().flat_map(|text| row(text)).collect();
    let alpha = DMatrix::from_row_slice(11, 4, &entries);
    let first = row("55@259 45@118 124@21 138@349 107@349 90@280 58@354 108@201 88@190 56@48 73@158");
    (alpha, first)
}

/// Weights up to 3.402.
#[test]
fn a_general_optimiser_finds_the_same_largest_reading() {
    let (alpha, first) = foiles();
    let found = min_max(&alpha, &first, Some(3.402)).unwrap();
    assert!((found.largest - 72.931_083).abs() < 1e-5, "{}", found.largest);
    assert!(found.largest - found.bound <= 1e-9 * 138.0, "{} above {}", found.largest, found.bound);
}

/// The ranges of min-max weights are those of the min-max problem, not of least squares, and hold the weights they stand
/// beside. 300 samples of another program, with 1 % and 1° on readings and coefficients, gave the sizes.
#[test]
fn ranges_belong_to_the_weights_they_stand_beside() {
    let (alpha, first) = foiles();
    let spread = ReadingSpread { amplitude: 0.01, phase: 1f64.to_radians() };
    for limit in [None, Some(3.402)] {
        let weights = min_max(&alpha, &first, limit).unwrap().weights;
        let measured = Measurement {
            first: &first,
            influence: Influence::Known(&alpha),
            choice: Choice::MinMax(limit),
            spread,
        };
        let ranges = ranges(&measured, &weights, 400, 2).unwrap();
        for ((weight, [low, high]), [from, to]) in weights.iter().zip_eq(&ranges.sizes).zip_eq(&ranges.angles)
        {
            assert!(
                *low <= weight.norm() && weight.norm() <= *high,
                "{weight} is not within {low} and {high}"
            );
            assert!(
                *from <= weight.arg() && weight.arg() <= *to,
                "{weight} is not within {from} and {to} rad"
            );
            assert!(to - from < 0.5, "the angle is determined: {from} to {to} rad");
        }
        if limit.is_none() {
            let others = [[4.29, 4.57], [2.73, 3.03], [1.45, 1.66], [1.85, 2.01]];
            for (ours, other) in ranges.sizes.iter().zip_eq(others) {
                let width = other[1] - other[0];
                let near = |end: usize| (ours[end] - other[end]).abs() < 0.3 * width;
                assert!(near(0) && near(1), "{ours:?} is not near {other:?}");
            }
        }
    }
}
