//! Second methods to the harmonic balance: the work of the spring, and the products of the harmonics.

use std::f64::consts::TAU;

use dalembert_core::Worksheet;
use dalembert_mechanics::{
    Real,
    vibration::duffing::{Duffing, TwoHarmonics},
};
use nalgebra::Complex;

/// The period by harmonic balance: over a cycle of the cosine, inertia does the work of the spring on its amplitude.
pub(super) fn balance_period<W: Worksheet>(oscillator: &Duffing, amplitude: f64, period: W::Num, sheet: W) {
    const SAMPLES: u32 = 64;
    let work = |n: u32| {
        let cosine = (TAU * f64::from(n) / f64::from(SAMPLES)).cos();
        let x = amplitude * cosine;
        (oscillator.stiffness * x + oscillator.cubic * x.powi(3)) * cosine
    };
    let spring = (0..SAMPLES).map(work).sum::<f64>() * 2.0 / f64::from(SAMPLES);
    let size = oscillator.stiffness * amplitude + oscillator.cubic.abs() * amplitude.powi(3);
    sheet.check_sum(
        "virtual work of spring and inertia over a cycle of the cosine, by summation",
        W::Num::from(oscillator.mass * amplitude * (TAU / period.value()).powi(2)),
        W::Num::from(spring),
        size,
    );
}

/// The largest displacement, where the velocity is zero, and the third harmonic, under the cube as its force.
pub(super) fn two_harmonics<W: Worksheet>(
    oscillator: &Duffing,
    [force, frequency]: [f64; 2],
    amplitude: f64,
    both: &TwoHarmonics,
    [largest, third]: [W::Num; 2],
    sheet: W,
) {
    let Duffing { mass, damping, stiffness, cubic } = *oscillator;
    let [a, b, c, d] = both.coefficients;
    let (z1, z3) = (Complex::new(a, -b), Complex::new(c, -d));
    let cube = z1.powi(3) / 4.0 + z3 * (1.5 * z1.norm_sqr() + 0.75 * z3.norm_sqr());
    let held = Complex::new(stiffness - mass * (3.0 * frequency).powi(2), damping * 3.0 * frequency);
    sheet.check_sum(
        "third harmonic: inertia, spring and damper forces balance that of the cubic term, by products of the harmonics",
        W::Num::from(held.norm() * third.value()),
        W::Num::from(cubic.abs() * cube.norm()),
        force.max(stiffness * amplitude).max(cubic.abs() * amplitude.powi(3)),
    );
    let wave = |phase: f64, order: i32| {
        let turned = |n: f64| Complex::from_polar(1.0, n * phase) * Complex::new(0.0, n).powi(order);
        (z1 * turned(1.0) + z3 * turned(3.0)).re
    };
    let places = (0..720u16).map(|n| TAU * f64::from(n) / 720.0);
    let Some(mut top) = places.max_by(|a, b| wave(*a, 0).total_cmp(&wave(*b, 0))) else { return };
    for _ in 0..8 {
        let step = wave(top, 1) / wave(top, 2);
        // A top that is flat is where it was sampled.
        if step.abs() < 0.02 {
            top -= step;
        }
    }
    sheet.check(
        "maximum displacement: where the total velocity of both harmonics is zero",
        largest,
        W::Num::from(wave(top, 0)),
    );
}
