//! Shaking forces of reciprocating masses.
//!
//! A piston of mass `m` on a crank of radius `r`, whose rod has the length `l = r/λ`, pushes the frame along its
//! stroke with `m r ω² a(α)`, positive away from the crank, `α` the angle of the crank from the stroke:
//! `a = cos α + A₂ cos 2α + A₄ cos 4α + A₆ cos 6α + …`, with `A₂ ≈ λ` in the motion of two terms.
//! One line of stroke at the angle `ψ` and the crank at `θ + φ` make of every order `h` a forward vector
//! `½ A e^{i[hφ − (h−1)ψ]}` turning at `hω` and a backward one `½ A e^{−i[hφ − (h+1)ψ]}` turning at `−hω`.
//! Den Hartog, *Mechanical Vibrations*, ch. 5.

use std::f64::consts::TAU;

use crate::Real;
use dalembert_numerics::extremes;

/// A piston in an engine.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Piston {
    /// Amplitude of its first order, `m r ω²`, N.
    pub amplitude: f64,
    /// Ratio `λ = r/l`; zero for an infinite rod.
    pub ratio: f64,
    /// Direction of its stroke `ψ`, away from the crank, rad.
    pub line: f64,
    /// Angle of its crank `φ` when the engine stands at `θ = 0`, rad.
    pub throw: f64,
    /// Position along the shaft, m.
    pub position: f64,
}

/// Law of the piston acceleration over `r ω²`: exact, or a series of one or two harmonics.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PistonMotion {
    /// `cos α`.
    OneTerm,
    /// `cos α + λ cos 2α`.
    TwoTerms,
    /// That of a rod of finite length.
    Exact,
}

/// Amplitude of the first order of a piston, `m r ω²`, N.
#[inline]
pub fn primary_amplitude<S: Real>(mass: S, crank: S, speed: S) -> S {
    mass * crank * speed.powi(2)
}

/// Angle of the forward vector of order `h`, `hφ − (h−1)ψ`, rad.
#[inline]
pub fn forward_angle<S: Real>(order: u8, throw: S, line: S) -> S {
    if order == 1 { throw } else { throw * f64::from(order) - line * f64::from(order - 1) }
}

/// Angle of the backward vector of order `h` against its sense of turning, `hφ − (h+1)ψ`, rad.
#[inline]
pub fn backward_angle<S: Real>(order: u8, throw: S, line: S) -> S {
    if order == 1 { throw - line * 2.0 } else { throw * f64::from(order) - line * f64::from(order + 1) }
}

/// Force of a piston on the frame along its stroke over `m r ω²`, from the angle `α` of its crank.
pub fn inertia_force(motion: PistonMotion, ratio: f64, angle: f64) -> f64 {
    match motion {
        PistonMotion::OneTerm => angle.cos(),
        PistonMotion::TwoTerms => angle.cos() + ratio * (2.0 * angle).cos(),
        PistonMotion::Exact => {
            let sine = (ratio * angle.sin()).powi(2);
            let swing = (2.0 * angle).cos() + sine * angle.sin().powi(2);
            angle.cos() + ratio * swing / ((1.0 - sine) * (1.0 - sine).sqrt())
        }
    }
}

/// Amplitudes `A₂`, `A₄`, `A₆` of the exact motion of a piston, by the Fourier integral over a turn, `0 ≤ λ < 1`.
pub fn harmonics(ratio: f64) -> [f64; 3] {
    const POINTS: u32 = 512;
    let mut sums = [0.0; 3];
    for k in 0..POINTS {
        let angle = TAU * f64::from(k) / f64::from(POINTS);
        let force = inertia_force(PistonMotion::Exact, ratio, angle) - angle.cos();
        for (sum, order) in sums.iter_mut().zip([2.0, 4.0, 6.0]) {
            *sum += force * (order * angle).cos();
        }
    }
    sums.map(|sum| 2.0 * sum / f64::from(POINTS))
}

/// The same amplitude of an even order by its series in `λ`, from the binomial series of the rod's shortening.
pub fn harmonic_by_series(ratio: f64, order: u8) -> f64 {
    let n = f64::from(order / 2);
    // k-th term: C(½, k)(−1)ᵏ λ^{2k−1} · 2(−1)ⁿ C(2k, k−n)/4ᵏ, from k = n on.
    let mut binomial = 1.0;
    let mut k = 0.0;
    while k < n {
        binomial *= -(0.5 - k) / (k + 1.0) * ratio * ratio / 4.0;
        k += 1.0;
    }
    let mut choose = 1.0;
    let mut sum = 0.0;
    for _ in 0..4000 {
        let term = binomial * choose;
        sum += term;
        if term.abs() < 1e-18 * sum.abs() {
            break;
        }
        choose *= (2.0 * k + 1.0) * (2.0 * k + 2.0) / ((k - n + 1.0) * (k + n + 1.0));
        binomial *= -(0.5 - k) / (k + 1.0) * ratio * ratio / 4.0;
        k += 1.0;
    }
    let sign = if order % 4 == 2 { -1.0 } else { 1.0 };
    if ratio == 0.0 { 0.0 } else { 4.0 * n * n * 2.0 * sign * sum / ratio }
}

/// Shaking force and couple about the position `about` of pistons at the engine's angle `θ`, added up one by one:
/// components along and across the engine, N and N·m.
pub fn shaking(pistons: &[Piston], motion: PistonMotion, about: f64, angle: f64) -> ([f64; 2], [f64; 2]) {
    let (mut force, mut couple) = ([0.0; 2], [0.0; 2]);
    for piston in pistons {
        let (sine, cosine) = piston.line.sin_cos();
        let along =
            piston.amplitude * inertia_force(motion, piston.ratio, angle + piston.throw - piston.line);
        for (axis, part) in [cosine, sine].into_iter().enumerate() {
            force[axis] += along * part;
            couple[axis] += along * part * (piston.position - about);
        }
    }
    (force, couple)
}

/// Largest size over a turn of a vector that turns and pulsates: angle and size.
pub fn largest(vector: impl Fn(f64) -> [f64; 2]) -> (f64, f64) {
    let size = |angle: f64| {
        let [x, y] = vector(angle);
        x.hypot(y)
    };
    // One place beyond the turn, so that each has two neighbours.
    let places: Vec<f64> = (0..=361).map(|k| TAU / 360.0 * f64::from(k)).collect();
    extremes::largest(size, &places).map_or((0.0, 0.0), |top| (top.time, top.value))
}

/// The crank angles of engines in line with pistons at `positions` and equal masses, taken from `angles` in the order
/// that has the least primary couple and, among equals, the least secondary one. The first crank keeps the first
/// angle. Factorial time: up to eight cylinders.
pub fn best_order(positions: &[f64], angles: &[f64]) -> Vec<f64> {
    let middle = positions.iter().sum::<f64>() / positions.len().max(1) as f64;
    let arms: Vec<f64> = positions.iter().map(|z| z - middle).collect();
    let reach: f64 = arms.iter().map(|z| z.abs()).sum();
    let mut order: Vec<f64> = angles.to_vec();
    let mut best = (f64::INFINITY, f64::INFINITY, order.clone());
    permute(&mut order, 1, &mut |order| {
        let couple = |h: f64| {
            let part = |of: fn(f64) -> f64| order.iter().zip(&arms).map(|(a, z)| z * of(h * a)).sum::<f64>();
            part(f64::cos).hypot(part(f64::sin))
        };
        let (first, second) = (couple(1.0), couple(2.0));
        let same = (first - best.0).abs() <= 1e-9 * reach;
        if first < best.0 - 1e-9 * reach || (same && second < best.1 - 1e-9 * reach) {
            best = (first, second, order.to_vec());
        }
    });
    best.2
}

fn permute(order: &mut [f64], from: usize, look: &mut impl FnMut(&[f64])) {
    if from >= order.len() {
        look(order);
        return;
    }
    for k in from..order.len() {
        order.swap(from, k);
        permute(order, from + 1, look);
        order.swap(from, k);
    }
}
