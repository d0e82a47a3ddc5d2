//! Statistics and designs of studies, compared with sums over all rows and with closed forms.

use dalembert_core::Text;
use dalembert_core::study::{Accumulator, AnswerLimit, BLOCK, PERCENTILES};
use dalembert_numerics::random::{normal_pair, uniform};
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
