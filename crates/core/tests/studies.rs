//! Statistics and designs of studies, compared with sums over all rows and with closed forms.

use std::f64::consts::PI;

use dalembert_core::Text;
use dalembert_core::study::{Accumulator, AnswerLimit, BLOCK, Estimate, PERCENTILES, SobolIndices};
use dalembert_numerics::{
    random::{normal_pair, uniform},
    sampling::sobol,
};
use itertools::zip_eq;

/// Rows of two inputs and an answer, the answer a little over twice the first input.
fn rows(count: u64) -> Vec<[f64; 3]> {
    let row = |n| {
        let [x, noise] = normal_pair(1, n, 0);
        let other = uniform(2, n, 1);
        [x, other, 1e3 + 2.0 * x + 0.1 * noise]
    };
    (0..count).map(row).collect()
}

fn near(a: f64, b: f64, tolerance: f64, what: &str) {
    assert!((a - b).abs() <= tolerance * b.abs().max(1.0), "{what}: {a} is not {b}");
}

#[test]
fn statistics_are_those_of_all_rows_at_once() {
    let count = 3 * BLOCK as u64 + 17;
    let rows = rows(count);
    let limits = vec![
        AnswerLimit { answer: 0, limit: 1001.0, above: true },
        AnswerLimit { answer: 0, limit: 999.0, above: false },
    ];
    let mut sums = Accumulator::new(2, 1, limits);
    for row in &rows {
        sums.push(&row[..2], &row[2..], None);
    }
    let summary = sums.summary();
    let of = &summary.answers[0];
    let n = count as f64;
    let mean = rows.iter().map(|row| row[2]).sum::<f64>() / n;
    let moment = |power: i32| rows.iter().map(|row| (row[2] - mean).powi(power)).sum::<f64>() / n;
    near(of.mean, mean, 1e-14, "mean");
    near(of.deviation, (moment(2) * n / (n - 1.0)).sqrt(), 1e-12, "standard deviation");
    near(of.skewness, moment(3) / moment(2).powf(1.5), 1e-9, "skewness");
    near(of.kurtosis, moment(4) / moment(2).powi(2) - 3.0, 1e-9, "kurtosis");
    let mut sorted: Vec<f64> = rows.iter().map(|row| row[2]).collect();
    sorted.sort_by(f64::total_cmp);
    for (percent, value) in zip_eq(&PERCENTILES, &of.percentiles) {
        let place = percent / 100.0 * (n - 1.0);
        let (below, above) = (sorted[place.floor() as usize], sorted[place.ceil() as usize]);
        near(*value, below + (above - below) * place.fract(), 1e-15, "percentile");
    }
    let above = rows.iter().filter(|row| row[2] > 1001.0).count() as u64;
    let below = rows.iter().filter(|row| row[2] < 999.0).count() as u64;
    assert_eq!([of.exceedances[0].count, of.exceedances[1].count], [above, below]);
    assert_eq!(of.histogram.counts.iter().sum::<u64>(), count);
    assert_eq!((of.least, of.largest), (sorted[0], sorted[sorted.len() - 1]));
    for input in 0..2 {
        let mean_x = rows.iter().map(|row| row[input]).sum::<f64>() / n;
        let sum = |f: &dyn Fn(&[f64; 3]) -> f64| rows.iter().map(f).sum::<f64>();
        let product = sum(&|row| (row[input] - mean_x) * (row[2] - mean));
        let squares = sum(&|row| (row[input] - mean_x).powi(2)) * sum(&|row| (row[2] - mean).powi(2));
        near(of.correlations[input], product / squares.sqrt(), 1e-12, "correlation");
    }
}

#[test]
fn points_without_an_answer_are_counted_and_left_out() {
    let mut sums = Accumulator::new(1, 2, Vec::new());
    for n in 0..10_000 {
        let x = f64::from(n);
        let why = Text::new("point {n} is odd").with("n", n);
        match n % 2 {
            0 => sums.push(&[x], &[x, 1.0], None),
            _ => sums.push(&[x], &[f64::NAN, f64::NAN], Some(&why)),
        }
    }
    let summary = sums.summary();
    assert_eq!((summary.points, summary.refused), (10_000, 5_000));
    let first = summary.first_refusal.map(|(point, why)| (point, why.english()));
    assert_eq!(first, Some((2, "point 1 is odd".to_owned())));
    near(summary.answers[0].mean, 4999.0, 1e-14, "mean");
    near(summary.answers[0].correlations[0], 1.0, 1e-12, "correlation");
    // A constant has no spread, no correlation and no bars.
    assert_eq!(summary.answers[1].deviation, 0.0);
    assert_eq!(summary.answers[1].correlations, [0.0]);
    assert!(summary.answers[1].histogram.counts.is_empty());
}

#[test]
fn no_points_have_no_statistics() {
    let summary = Accumulator::new(1, 1, Vec::new()).summary();
    assert_eq!((summary.points, summary.answers[0].count), (0, 0));
    let of = &summary.answers[0];
    assert!([of.mean, of.deviation, of.skewness, of.kurtosis].iter().all(|x| *x == 0.0), "{of:?}");
}

#[test]
fn the_interval_of_a_probability_is_wilsons() {
    // R. G. Newcombe, *Stat. Med.* 17 (1998), table I, method 3: 81 of 263 and 15 of 148.
    for (hits, trials, interval) in [(81, 263, [0.2553, 0.3662]), (15, 148, [0.0624, 0.1605])] {
        let limit = AnswerLimit { answer: 0, limit: 0.5, above: true };
        let mut sums = Accumulator::new(0, 1, vec![limit]);
        for n in 0..trials {
            sums.push(&[], &[f64::from(u8::from(n < hits))], None);
        }
        let of = sums.summary().answers[0].exceedances[0];
        for (found, published) in zip_eq(of.interval, interval) {
            assert!((found - published).abs() < 5e-5, "{found} is not {published}");
        }
    }
}

/// Points of base samples in their order, each input between −π and π: `A`, `B`, and `A` with an input of `B`.
fn base_samples(count: u64, inputs: usize, share: impl Fn(u64, usize) -> f64) -> Vec<Vec<f64>> {
    let mut points = Vec::new();
    for sample in 0..count {
        let half = |other: usize| -> Vec<f64> {
            (0..inputs).map(|input| PI * (2.0 * share(sample, input + other * inputs) - 1.0)).collect()
        };
        let (a, b) = (half(0), half(1));
        points.extend([a.clone(), b.clone()]);
        for input in 0..inputs {
            let mut mixed = a.clone();
            mixed[input] = b[input];
            points.push(mixed);
        }
    }
    points
}

/// T. Ishigami and T. Homma, *Proc. First Int. Symp. Uncertainty Modeling and Analysis*, 1990.
fn ishigami(x: &[f64]) -> f64 {
    x[0].sin() + 7.0 * x[1].sin().powi(2) + 0.1 * x[2].powi(4) * x[0].sin()
}

/// The first-order and total indices of [`ishigami`] in closed form.
fn ishigami_indices() -> [[f64; 2]; 3] {
    let (a, b) = (7.0_f64, 0.1_f64);
    let first = 0.5 * (1.0 + b * PI.powi(4) / 5.0).powi(2);
    let second = a * a / 8.0;
    let both = 8.0 * b * b * PI.powi(8) / 225.0;
    let all = first + second + both;
    [[first, first + both], [second, second], [0.0, both]].map(|of| of.map(|part| part / all))
}

fn indices_of(points: &[Vec<f64>], answer: impl Fn(usize, &[f64]) -> f64) -> SobolIndices {
    let inputs = points[0].len();
    let mut sums = Accumulator::new(inputs, 1, Vec::new()).with_sobol_indices(inputs + 2);
    for (n, point) in points.iter().enumerate() {
        sums.push(point, &[answer(n, point)], None);
    }
    sums.summary().answers.remove(0).sobol_indices.expect("indices were asked for")
}

fn estimates(indices: &SobolIndices) -> Vec<[Estimate; 2]> {
    indices.inputs.iter().map(|input| [input.first_order, input.total]).collect()
}

#[test]
fn sobol_indices_are_those_of_the_closed_form() {
    let count = 1 << 14;
    let points = base_samples(count, 3, |sample, dimension| sobol(4, sample, dimension));
    let indices = indices_of(&points, |_, x| ishigami(x));
    assert_eq!((indices.samples, indices.left_out), (count, 0));
    for (found, closed) in zip_eq(estimates(&indices).concat(), ishigami_indices().concat()) {
        // The interval is that of random samples; those of the sequence lie at least five times closer.
        let half = (found.interval[1] - found.interval[0]) / 2.0;
        assert!((found.value - closed).abs() < half / 5.0, "{found:?} is not {closed}");
        assert!(half < 3.0 / (count as f64).sqrt(), "{found:?}");
    }
}

#[test]
fn intervals_of_sobol_indices_hold_the_closed_form_in_95_of_100_cases() {
    let (cases, count) = (400, 1000);
    let mut held = [[0; 2]; 3];
    for seed in 0..cases {
        let points = base_samples(count, 3, |sample, dimension| uniform(seed, sample, dimension as u64));
        let found = estimates(&indices_of(&points, |_, x| ishigami(x)));
        for (held, (found, closed)) in zip_eq(&mut held, zip_eq(found, ishigami_indices())) {
            for (held, (found, closed)) in zip_eq(held, zip_eq(found, closed)) {
                *held += u64::from((found.interval[0]..=found.interval[1]).contains(&closed));
            }
        }
    }
    // Of 400 cases 380 ± 4.4.
    for held in held.concat() {
        assert!((363..=394).contains(&held), "{held} of {cases}");
    }
}

#[test]
fn a_base_sample_with_a_refused_point_is_left_out_of_the_indices() {
    let points = base_samples(2000, 2, |sample, dimension| uniform(1, sample, dimension as u64));
    let answer = |x: &[f64]| x[0] + 2.0 * x[1];
    let refused = |n: usize| n.is_multiple_of(14);
    let left: Vec<Vec<f64>> = points
        .chunks(4)
        .enumerate()
        .filter(|(sample, _)| !(4 * sample..4 * sample + 4).any(refused))
        .flat_map(|(_, points)| points.to_vec())
        .collect();
    let with = indices_of(&points, |n, x| if refused(n) { f64::NAN } else { answer(x) });
    let without = indices_of(&left, |_, x| answer(x));
    assert_eq!(with.left_out, 2000 - without.samples);
    assert_eq!((with.samples, &with.inputs), (without.samples, &without.inputs));
    // A constant has no variance to share out.
    assert_eq!(indices_of(&points, |_, _| 3.7).inputs, []);
}

#[test]
fn statistics_beside_indices_are_those_of_the_independent_points() {
    let points = base_samples(3000, 2, |sample, dimension| uniform(2, sample, dimension as u64));
    let mut sums = Accumulator::new(2, 1, Vec::new()).with_sobol_indices(4);
    let mut independent = Accumulator::new(2, 1, Vec::new());
    for (n, point) in points.iter().enumerate() {
        sums.push(point, &[point[0] * point[1]], None);
        if n % 4 < 2 {
            independent.push(point, &[point[0] * point[1]], None);
        }
    }
    let (sums, independent) = (sums.summary(), independent.summary());
    assert_eq!((sums.points, sums.answers[0].count), (12_000, 6000));
    assert_eq!(sums.answers[0].deviation, independent.answers[0].deviation);
    assert_eq!(sums.answers[0].percentiles, independent.answers[0].percentiles);
    // A part that begins within a base sample leaves that one out.
    let mut part = Accumulator::new(2, 1, Vec::new()).with_sobol_indices(4).starting_at(4098);
    for point in &points[4098..] {
        part.push(point, &[point[0]], None);
    }
    let of = part.summary().answers.remove(0).sobol_indices.expect("indices were asked for");
    assert_eq!((of.samples, of.left_out), (3000 - 1025, 0));
}
