//! Nonlinear systems and least squares.

use dalembert_numerics::nonlinear::{halton, levenberg_marquardt};
use itertools::Itertools as _;

#[test]
fn the_root_of_a_system_is_found_from_afar() {
    // Two natural frequencies of a mass m on a spring k, without and with an added mass of 0.5 m0.
    let (m, k) = (0.3f64, 0.7f64);
    let residuals = |x: &[f64]| {
        let of = |m: f64, k: f64| [(k / m).sqrt(), (k / (m + 0.5)).sqrt()];
        let wanted = of(m, k);
        let found = of(x[0], x[1]);
        (x[0] > 0.0).then(|| vec![found[0] / wanted[0] - 1.0, found[1] / wanted[1] - 1.0])
    };
    for n in 1..=32 {
        let found = levenberg_marquardt(residuals, &halton(n, 2)).expect("the start has a value");
        assert!((found.x[0] - m).abs() < 1e-9 && (found.x[1] - k).abs() < 1e-9, "{n}: {:?}", found.x);
    }
}

#[test]
fn least_squares_end_where_the_gradient_vanishes() {
    let points = [(0.0, 0.1), (0.2, 0.31), (0.5, 0.35), (0.9, 0.72)];
    let residuals = |x: &[f64]| Some(points.iter().map(|(t, y)| x[0] + x[1] * t - y).collect::<Vec<f64>>());
    let found = levenberg_marquardt(residuals, &[0.9, 0.1]).expect("defined everywhere");
    let sum: f64 = found.residuals.iter().sum();
    let moment: f64 = found.residuals.iter().zip_eq(points).map(|(r, (t, _))| r * t).sum();
    assert!(sum.abs() < 1e-9 && moment.abs() < 1e-9, "{sum} {moment}");
    assert!(found.residuals.iter().all(|r| r.abs() > 1e-3), "the points do not lie on a line");
}

#[test]
fn a_minimum_outside_ends_on_the_face_and_no_value_at_the_start_is_none() {
    let found = levenberg_marquardt(|x| Some(vec![x[0] + 1.0]), &[0.5]).expect("defined everywhere");
    assert_eq!(found.x, [0.0]);
    assert_eq!(levenberg_marquardt(|_| None, &[0.5]), None);
}

#[test]
fn points_of_the_halton_sequence_are_those_of_its_definition() {
    assert_eq!(halton(1, 2), [0.5, 1.0 / 3.0]);
    assert_eq!(halton(6, 1), [0.375]);
    // Each half of the cube holds half of the points, along every axis.
    for axis in 0..5 {
        let low = (1..=210).filter(|n| halton(*n, 5)[axis] < 0.5).count();
        assert!((100..=110).contains(&low), "{low} of 210 on axis {axis}");
    }
}

#[test]
fn one_unknown_on_a_face_leaves_the_others_free() {
    // The slope of the best line is above 1: at slope 1 the intercept is the mean of what is left.
    let points = [(0.0, 0.1), (0.2, 0.31), (0.5, 0.55), (0.9, 1.02)];
    let residuals = |x: &[f64]| Some(points.iter().map(|(t, y)| x[0] + x[1] * t - y).collect::<Vec<f64>>());
    let found = levenberg_marquardt(residuals, &[0.9, 0.1]).expect("defined everywhere");
    let mean = points.iter().map(|(t, y)| y - t).sum::<f64>() / 4.0;
    assert!(found.x[1] == 1.0 && (found.x[0] - mean).abs() < 1e-7, "{:?}", found.x);
}
