use std::f64::consts::PI;

use dalembert_mechanics::{beam, section};
use dalembert_numerics::linalg;
use nalgebra::{DMatrix, DVector};
use proptest::prelude::*;

use crate::close::{ROUNDING, close, found};

/// `∫ f dx` by Simpson's rule on each of the pieces; exact here, where `f` is a quadratic on each.
fn integral(f: impl Fn(f64) -> f64, pieces: &[f64]) -> f64 {
    pieces
        .windows(2)
        .map(|ends| {
            let (low, high) = (ends[0], ends[1]);
            // A shade inside the piece, since the integrand may jump at its ends.
            let shade = 1e-14 * (high - low);
            let middle = f64::midpoint(low, high);
            (high - low) / 6.0 * (f(low + shade) + 4.0 * f(middle) + f(high - shade))
        })
        .sum()
}

/// Stiffness at the force by virtual work: bending moments of a unit force on a determinate beam, and of unit
/// redundants that close its gaps.
fn by_virtual_work(
    bending: f64,
    pieces: &[f64],
    of_force: impl Fn(f64) -> f64,
    redundants: &[&dyn Fn(f64) -> f64],
) -> f64 {
    let work = |p: &dyn Fn(f64) -> f64, q: &dyn Fn(f64) -> f64| integral(|x| p(x) * q(x) / bending, pieces);
    let n = redundants.len();
    let deflection = work(&of_force, &of_force);
    if n == 0 {
        return 1.0 / deflection;
    }
    let flexibility = DMatrix::from_fn(n, n, |i, j| work(redundants[i], redundants[j]));
    let gaps = DVector::from_fn(n, |i, _| work(redundants[i], &of_force));
    let solved = found(linalg::solve(&flexibility, &(-&gaps)));
    1.0 / (deflection + solved.x.dot(&gaps))
}

const E: f64 = 207e9;
const I: f64 = 3.1e-7;

proptest! {
    #[test]
    fn deflections_by_virtual_work(length in 0.2..5.0, part in 0.05..0.95) {
        let (l, a) = (length, part * length);
        let b = l - a;
        let pieces = [0.0, a, l];
        let cantilever = |x: f64| (a - x).max(0.0);
        let (shear, couple) = (|x: f64| l - x, |_: f64| 1.0);
        let simple = |x: f64| if x < a { b * x / l } else { a * (l - x) / l };

        let way = |of_force: &dyn Fn(f64) -> f64, redundants: &[&dyn Fn(f64) -> f64]| {
            by_virtual_work(E * I, &pieces, of_force, redundants)
        };
        close(beam::cantilever(E, I, a), way(&cantilever, &[]), 1e-11);
        close(beam::simply_supported(E, I, l, a), way(&simple, &[]), 1e-11);
        close(beam::clamped_pinned(E, I, l, a), way(&cantilever, &[&shear]), 1e-8);
        close(beam::clamped_clamped(E, I, l, a), way(&cantilever, &[&shear, &couple]), 1e-7);
    }

    #[test]
    fn overhang_and_guided_end_by_virtual_work(span in 0.2..5.0, part in 0.05..2.0) {
        let over = part * span;
        let moment = |x: f64| if x < span { over * x / span } else { span + over - x };
        let pieces = [0.0, span, span + over];
        close(beam::overhang(E, I, span, over), by_virtual_work(E * I, &pieces, moment, &[]), 1e-11);
        let tip = |x: f64| span - x;
        let guided = by_virtual_work(E * I, &[0.0, span], tip, &[&|_| 1.0]);
        close(beam::clamped_guided(E, I, span), guided, 1e-10);
    }

    #[test]
    fn at_the_middle_the_general_formula_is_the_short_one(l in 0.1..9.0) {
        let a = l / 2.0;
        close(beam::simply_supported(E, I, l, a), beam::simply_supported_middle(E, I, l), ROUNDING);
        close(beam::clamped_clamped(E, I, l, a), beam::clamped_clamped_middle(E, I, l), ROUNDING);
        close(beam::clamped_pinned(E, I, l, a), beam::clamped_pinned_middle(E, I, l), ROUNDING);
    }

    #[test]
    fn sections_by_strips(outer in 0.01..1.0, wall in 0.05..0.95) {
        let inner = outer * wall;
        // Strips across the section; the substitution y = R sin t makes the integrand smooth.
        let strips = |diameter: f64, power: i32| {
            let radius: f64 = diameter / 2.0;
            let n = 200;
            (0..n)
                .map(|i| {
                    let t = -PI / 2.0 + PI * (f64::from(i) + 0.5) / f64::from(n);
                    (radius * t.sin()).powi(power) * 2.0 * (radius * t.cos()).powi(2)
                })
                .sum::<f64>()
                * PI
                / f64::from(n)
        };
        close(section::round_area(outer), strips(outer, 0), ROUNDING);
        close(section::round_second_moment(outer), strips(outer, 2), ROUNDING);
        close(section::tube_area(outer, inner), strips(outer, 0) - strips(inner, 0), 1e-10);
        close(section::tube_second_moment(outer, inner), strips(outer, 2) - strips(inner, 2), 1e-10);
        close(section::round_polar_moment(outer), 2.0 * strips(outer, 2), ROUNDING);
        close(section::tube_polar_moment(outer, inner), 2.0 * section::tube_second_moment(outer, inner), 1e-10);
        close(section::round_diameter(section::round_second_moment(outer)), outer, ROUNDING);
    }
}

#[test]
fn rectangle_by_its_two_halves() {
    // Two halves about their common edge: 2 (b (h/2)³/12 + b h/2 (h/4)²).
    let (b, h): (f64, f64) = (0.04, 0.1);
    let half = section::rectangle_second_moment(b, h / 2.0);
    let area = section::rectangle_area(b, h / 2.0);
    close(section::rectangle_second_moment(b, h), 2.0 * (half + area * (h / 4.0).powi(2)), ROUNDING);
    close(section::rectangle_second_moment(b, h), 0.04 * 0.001 / 12.0, ROUNDING);
}

#[test]
fn stiffer_supports_make_stiffer_beams() {
    for part in [0.1, 0.3, 0.5, 0.7, 0.9] {
        let simple = beam::simply_supported(E, I, 2.0, part * 2.0);
        let propped = beam::clamped_pinned(E, I, 2.0, part * 2.0);
        let clamped = beam::clamped_clamped(E, I, 2.0, part * 2.0);
        assert!(simple < propped && propped < clamped, "at {part} of the length");
    }
}
