//! Extremes of numbers whose turns are known.

use std::f64::consts::{PI, TAU};

use dalembert_numerics::extremes::{Extremes, Sampling, largest};

use crate::close::{close, found};

#[test]
fn turns_are_found_between_the_examines_a_motion() {
    // e^(−t/10) sin t turns where tan t = 10.
    let mut number = |t: f64| {
        let decay = f64::exp(-t / 10.0);
        Sampling::of(decay * t.sin(), decay * (t.cos() - t.sin() / 10.0))
    };
    let mut seen = Extremes::at(0.0, 0.0);
    for n in 0..20 {
        seen.follow(&mut number, [f64::from(n) * 1.5, f64::from(n + 1) * 1.5]);
    }
    let turn = 10f64.atan();
    close(seen.largest.time, turn, 1e-12);
    close(seen.largest.value, f64::exp(-turn / 10.0) * turn.sin(), 1e-14);
    close(seen.least.time, turn + TAU / 2.0, 1e-12);
}

#[test]
fn a_number_that_turns_twice_between_two_looks_is_examined_again() {
    let mut number = |t: f64| Sampling::of((TAU * t).sin(), TAU * (TAU * t).cos());
    let mut seen = Extremes::at(-0.1, number(-0.1).value);
    seen.follow(&mut number, [-0.1, 0.9]);
    close(seen.largest.value, 1.0, 1e-14);
    close(seen.least.value, -1.0, 1e-14);
}

#[test]
fn the_higher_of_two_tops_is_found_though_a_place_lies_on_the_lower() {
    let number = |t: f64| (2.0 * t).cos() + 1e-4 * t.cos();
    let places: Vec<f64> = (-11..=11).map(|n| PI + 0.3 * f64::from(n)).collect();
    let top = found(largest(number, &places).ok_or("no places"));
    close(top.value, 1.0 + 1e-4, 1e-14);
    assert!(top.time.abs().min((top.time - TAU).abs()) < 1e-6, "{}", top.time);
}
