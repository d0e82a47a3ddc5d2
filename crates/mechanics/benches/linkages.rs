//! Benchmark of the motion and the driving torque of a linkage at a million crank angles: the same formulas on SIMD
//! vectors and one angle at a time.
//!
//! Prints `name<TAB>figure<TAB>goal`, a row a line; `cargo xtask bench` makes a table of them.

use std::{array::from_fn, f64::consts::TAU, hint::black_box, time::Instant};

use dalembert_mechanics::{
    Real,
    four_bar::{Branch, FourBar},
    linkage::{LinkMass, PointMotion, ReducedMasses},
    slider_crank::{Branch::Ahead, links},
};
use dalembert_numerics::simd::{Formula, over};

#[path = "yardstick/python.rs"]
mod python;

/// Nanoseconds an angle of numba with the formulas of the same linkage, the mean torque and that of its square.
const YARDSTICKS: [&str; 2] =
    [include_str!("yardstick/slider_crank.py"), include_str!("yardstick/four_bar.py")];

const ANGLES: usize = 1_000_000;
const ROUNDS: usize = 9;
const SPEED: f64 = 30.0;
const ACCELERATION: f64 = 5.0;
const GRAVITY: f64 = 9.81;

fn main() {
    let angles: Vec<f64> = (0..ANGLES).map(|n| TAU * n as f64 / ANGLES as f64).collect();
    let [slider_crank, four_bar] = YARDSTICKS.map(python::figures::<3>);
    compare("slider-crank", &angles, slider_crank, "≤ 6 ms (numba 22.4 ms)", &SliderCrank);
    compare("four-bar", &angles, four_bar, "", &FourBarLinkage);
}

/// Sine and angular velocity of the rod, position, velocity and acceleration of the slider, and the torque.
struct SliderCrank;

impl Formula<6> for SliderCrank {
    #[inline(always)]
    fn at<S: Real>(&self, angle: S) -> [S; 6] {
        let number = S::from;
        let links = links(number(0.05), number(0.2), number(0.0), Ahead, angle);
        let masses = body(1.2, 0.02, 8e-4)
            .reduced(PointMotion::fixed([number(0.0); 2]), links.crank)
            .and(body(0.8, 0.07, 3.5e-3).reduced(links.crank_pin, links.rod))
            .and(ReducedMasses::mass(number(0.5), links.slider));
        let (first, second) = (links.slider.first[0], links.slider.second[0]);
        [
            links.rod.direction[1],
            links.slider.at[0],
            links.rod.first * SPEED,
            first * SPEED,
            first * ACCELERATION + second * (SPEED * SPEED),
            masses.torque(number(SPEED), number(ACCELERATION), number(GRAVITY)) - first * 200.0,
        ]
    }
}

/// Directions, velocities and accelerations of coupler and rocker, and the torque.
struct FourBarLinkage;

impl Formula<9> for FourBarLinkage {
    #[inline(always)]
    fn at<S: Real>(&self, angle: S) -> [S; 9] {
        let number = S::from;
        let linkage =
            FourBar { frame: number(0.30), crank: number(0.10), coupler: number(0.28), rocker: number(0.20) };
        let links = linkage.links(angle, Branch::Open);
        let rod = |mass: f64, length: f64| body(mass, length / 2.0, mass * length * length / 12.0);
        let masses = rod(0.5, 0.10)
            .reduced(PointMotion::fixed([number(0.0); 2]), links.crank)
            .and(rod(1.0, 0.28).reduced(links.crank_pin, links.coupler))
            .and(rod(0.8, 0.20).reduced(linkage.fixed_pin(), links.rocker));
        let (coupler, rocker) = (links.coupler, links.rocker);
        [
            coupler.direction[0],
            coupler.direction[1],
            rocker.direction[0],
            rocker.direction[1],
            coupler.first * SPEED,
            rocker.first * SPEED,
            coupler.first * ACCELERATION + coupler.second * (SPEED * SPEED),
            rocker.first * ACCELERATION + rocker.second * (SPEED * SPEED),
            masses.torque(number(SPEED), number(ACCELERATION), number(GRAVITY)) + rocker.first * 5.0,
        ]
    }
}

/// A link with its centre on its line.
#[inline(always)]
fn body<S: Real>(mass: f64, along: f64, inertia: f64) -> LinkMass<S> {
    LinkMass { mass: S::from(mass), centre: [S::from(along), S::from(0.0)], inertia: S::from(inertia) }
}

/// Both readings of a formula at all angles, whose last number is the torque; how far they are apart.
fn compare<const N: usize>(
    name: &str,
    angles: &[f64],
    yardstick: Option<[f64; 3]>,
    goal: &str,
    formula: &impl Formula<N>,
) {
    let mut columns: [Vec<f64>; N] = from_fn(|_| vec![0.0; ANGLES]);
    let wide = best(|| over(black_box(angles), formula, columns.each_mut().map(Vec::as_mut_slice)));
    let mut single: [Vec<f64>; N] = from_fn(|_| vec![0.0; ANGLES]);
    let scalar = best(|| {
        for (at, angle) in black_box(angles).iter().enumerate() {
            for (column, number) in single.iter_mut().zip(formula.at(*angle)) {
                column[at] = number;
            }
        }
    });
    let mut off: f64 = 0.0;
    for (ours, theirs) in columns.iter().zip(&single) {
        let size = theirs.iter().fold(0.0, |size: f64, x| size.max(x.abs()));
        off = ours.iter().zip(theirs).map(|(a, b)| (a - b).abs() / size).fold(off, f64::max);
    }
    let mut beside = String::new();
    if let Some([theirs, mean, square]) = yardstick {
        let torques = &columns[N - 1];
        let our_mean = torques.iter().sum::<f64>() / ANGLES as f64;
        let our_square = torques.iter().map(|torque| torque * torque).sum::<f64>() / ANGLES as f64;
        assert!((our_mean - mean).abs() < 1e-9 * square.sqrt(), "{our_mean} and {mean} N·m");
        assert!((our_square / square - 1.0).abs() < 1e-9, "{our_square} and {square} N²·m²");
        // An angle in nanoseconds is a million of them in milliseconds.
        beside = format!(" (numba {theirs:.1} ms)");
    }
    println!("{name}, {N} numbers at 1e6 angles, by SIMD\t{wide:.2} ms{beside}\t{goal}");
    println!("{name}, {N} numbers at 1e6 angles, one by one\t{scalar:.2} ms\t");
    println!("{name}, both readings apart, over the largest\t{off:.0e}\t< 1e-13");
}

/// The shortest of some rounds, in milliseconds.
fn best(mut work: impl FnMut()) -> f64 {
    let mut best = f64::INFINITY;
    for _ in 0..ROUNDS {
        let start = Instant::now();
        work();
        best = best.min(start.elapsed().as_secs_f64() * 1e3);
    }
    best
}
