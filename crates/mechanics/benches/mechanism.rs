//! Benchmark of mechanisms: the positions of driven ones with all reactions, and the forward dynamics of Andrews'
//! squeezing mechanism and of four-bars in a row through their singular positions.
//!
//! Prints `name<TAB>figure<TAB>goal`, a row a line; `cargo xtask bench` makes a table of them.

use std::{hint::black_box, time::Instant};

use dalembert_mechanics::planar::{Model, PlanarRun, RelativeCoordinate, SweepResult, Trajectory};
use models::{
    Driven, andrews, angles_of_drag_links, crank_rocker, drag_links, driven_slider, driven_squeezer,
    four_bars, six_bar,
};

#[path = "../tests/mechanics/models.rs"]
mod models;

#[path = "yardstick/python.rs"]
mod python;

/// Nanoseconds an angle of numba with the formulas of one slider-crank.
const YARDSTICK: &str = include_str!("yardstick/slider_crank.py");

const ROUNDS: usize = 9;

fn main() {
    let rates = [30.0, 5.0];
    let numba = python::figures(YARDSTICK).map_or(String::new(), |[each]| format!("{each:.1} ns"));
    println!("formulas of one slider-crank without reactions, in numba, an angle\t{numba}\t(22.4 ns)");
    for (name, driven, goals) in [
        ("slider-crank", driven_slider(rates), ["≤ 150 ns", "≤ 60 µs"]),
        ("four-bar", crank_rocker(rates), ["≤ 150 ns", "≤ 60 µs"]),
        ("six-bar", six_bar(rates), ["≤ 150 ns", "≤ 60 µs"]),
        ("squeezing mechanism", driven_squeezer(rates), ["", ""]),
    ] {
        for (count, goal) in [(3_600, goals[0]), (360, goals[1])] {
            positions(name, &driven, count, goal);
        }
    }
    chains();
    squeezer(1e-8, 1e-7, "≤ 0.4 ms");
    squeezer(1e-11, 1e-10, "≤ 1 ms");
    for (n, goal) in [(1, "≤ 1 ms"), (10, "≤ 5 ms"), (40, "≤ 15 ms"), (100, "≤ 40 ms")] {
        let tolerance = 4e-7;
        let (time, moved, _) = fall(n, tolerance);
        let error = error(n, &moved);
        // What the problem asks: the top of the first rod to a millimetre.
        assert!(error < 1e-3, "{n} four-bars are {error} m off");
        println!(
            "{n} four-bars in a row, 10 s, 400 outputs, error {error:.0e} in {} steps\t{time:.2} ms\t{goal}",
            moved.steps
        );
    }
    let (time, moved, imbalance) = fall(2, 1e-9);
    println!(
        "2 four-bars, 10 s, 400 outputs, energy to {imbalance:.0e} J in {} steps\t{time:.2} ms\t≤ 10 ms",
        moved.steps
    );
}

/// A turn of the crank in so many positions, with velocities, accelerations and reactions.
fn positions(name: &str, driven: &Driven, count: usize, goal: &str) {
    let (time, gap, _) = swept(driven, count);
    let each = time / count as f64 * 1e3;
    println!("{name}, {count} positions, two ways to {gap:.0e}\t{time:.0} µs, {each:.0} ns each\t{goal}");
}

/// Chains of four-bars, each held against its closed form: the time grows with their number.
fn chains() {
    let [two, hundred] = [2, 100].map(|n| {
        let driven = drag_links(n, [3.0, 0.5]);
        let (time, gap, swept) = swept(&driven, 360);
        let off = turn(&driven, 360).into_iter().enumerate().flat_map(|(at, value)| {
            let angles = angles_of_drag_links(n, value);
            let off = |(body, angle): (usize, f64)| (swept.positions(at)[body][2] - angle).abs();
            angles.into_iter().enumerate().map(off).collect::<Vec<_>>()
        });
        let off = off.fold(0.0, f64::max);
        println!(
            "chain of {n} four-bars, 360 positions, two ways to {gap:.0e}, closed form to {off:.0e} rad\t{time:.0} µs\t"
        );
        assert!(gap < 1e-9 && off < 1e-9, "the chain is not where it should be");
        time
    });
    println!("chain of 100 four-bars, 360 positions, over two\t{:.1}\t≤ 60", hundred / two);
}

/// The values of a turn of the crank.
fn turn((_, drawn): &Driven, count: usize) -> Vec<f64> {
    (0..count).map(|n| drawn[0][2] + std::f64::consts::TAU * n as f64 / count as f64).collect()
}

/// A turn of the crank in so many positions: the median time, µs, the largest difference of the driving torque by virtual
/// power and by Newton and Euler over the largest torque, and the positions.
fn swept(driven: &Driven, count: usize) -> (f64, f64, SweepResult) {
    let (system, drawn) = driven;
    let values = turn(driven, count);
    let mut sweep = system.sweep(drawn, 0).expect("the crank drives the mechanism");
    let mut swept = SweepResult::default();
    let rounds = 40_000 / count + 3;
    let mut times: Vec<f64> = (0..rounds)
        .map(|_| {
            let start = Instant::now();
            sweep.over(&values, &mut swept).expect("the crank turns");
            start.elapsed().as_secs_f64() * 1e6
        })
        .collect();
    times.sort_by(f64::total_cmp);
    let time = times[rounds / 2];
    let driver = system.equations().len() - 1;
    let largest = (0..count).fold(0.0f64, |most, n| most.max(swept.effort(n).abs()));
    let gap =
        (0..count).fold(0.0f64, |most, n| most.max((swept.effort(n) - swept.multipliers(n)[driver]).abs()));
    (time, gap / largest, swept)
}

/// Crank angle of Andrews' mechanism at 0.03 s, by extrapolation in 80-bit arithmetic.
fn squeezer(tolerance: f64, wanted: f64, goal: &str) {
    const REFERENCE: [f64; 3] = [15.8107711951537, 0.0408222401196465, 1.04808074104194];
    let (system, drawn) = andrews();
    let start = system.assemble(&drawn).expect("the mechanism closes");
    let (time, moved) = measure(|| simulate(&system, &start, &[[0.0; 3]; 7], 0.03, tolerance, 2));
    let last = &moved.samples[1].state.positions;
    let errors = [0, 2, 6].iter().zip(REFERENCE).map(|(&body, angle)| (last[body][2] - angle).abs());
    let error = errors.fold(0.0, f64::max);
    let verdict = if error <= wanted { "" } else { ", too much" };
    println!(
        "squeezing mechanism, 0.03 s, error {error:.1e}{verdict} in {} steps\t{time:.2} ms\t{goal}",
        moved.steps
    );
}

fn fall(n: usize, tolerance: f64) -> (f64, Trajectory, f64) {
    let (system, drawn) = four_bars(n);
    let tilting = RelativeCoordinate::Angle { of: Some(0), against: None };
    let velocities = system.initial_velocities(&drawn, &[(tilting, -1.0)]).expect("the rods can tilt");
    let (time, moved) = measure(|| simulate(&system, &drawn, &velocities, 10.0, tolerance, 401));
    let imbalance = moved.imbalance();
    (time, moved, imbalance)
}

fn simulate(
    system: &Model,
    positions: &[[f64; 3]],
    velocities: &[[f64; 3]],
    duration: f64,
    tolerance: f64,
    samples: usize,
) -> Trajectory {
    let run =
        PlanarRun { duration, tolerance, samples, ends: &[], most_steps: 100_000, cancelled: &|| false };
    system.simulate(positions, velocities, &run).expect("the motion goes on to its end")
}

/// The largest error of the top of the first rod: with all rods parallel the row is a pendulum of one degree of freedom,
/// `θ̈ = −c cos θ`, followed here by the method of Runge and Kutta of order 4 with short steps.
fn error(n: usize, moved: &Trajectory) -> f64 {
    let bars = n as f64;
    let c = 9.81 * (f64::midpoint(bars, 1.0) + bars) / ((bars + 1.0) / 3.0 + bars);
    let (mut angle, mut rate) = (std::f64::consts::FRAC_PI_2, -1.0);
    let parts = 1000;
    let mut worst = 0.0f64;
    for pair in moved.samples.windows(2) {
        let h = (pair[1].time - pair[0].time) / f64::from(parts);
        for _ in 0..parts {
            let slope = |angle: f64| -c * f64::cos(angle);
            let (k1, l1) = (rate, slope(angle));
            let (k2, l2) = (rate + h / 2.0 * l1, slope(angle + h / 2.0 * k1));
            let (k3, l3) = (rate + h / 2.0 * l2, slope(angle + h / 2.0 * k2));
            let (k4, l4) = (rate + h * l3, slope(angle + h * k3));
            angle += h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
            rate += h / 6.0 * (l1 + 2.0 * l2 + 2.0 * l3 + l4);
        }
        let top = pair[1].state.positions[0].map(|x| x * 2.0);
        worst = worst.max((top[0] - angle.cos()).hypot(top[1] - angle.sin()));
    }
    worst
}

/// The median time of a few rounds, ms, and what they found.
fn measure<T>(work: impl Fn() -> T) -> (f64, T) {
    let mut times: Vec<f64> = (0..ROUNDS)
        .map(|_| {
            let start = Instant::now();
            black_box(work());
            start.elapsed().as_secs_f64() * 1e3
        })
        .collect();
    times.sort_by(f64::total_cmp);
    (times[ROUNDS / 2], work())
}
