//! The forces and couples again, piston by piston and mass by mass.

use std::f64::consts::{FRAC_PI_2, TAU};

use dalembert_core::Worksheet;
use dalembert_mechanics::{
    Real,
    balance::reciprocating::{self as engine, Piston, PistonMotion},
};

use super::layout::Placed;

/// The sum of one order of all cylinders, along their strokes, where the order has turned by an angle.
pub(super) fn sum_at<N: Real>(order: u8, cylinders: &[Placed<N>], amounts: &[N], turned: f64) -> [f64; 2] {
    let mut sum = [0.0; 2];
    for (c, amount) in cylinders.iter().zip(amounts) {
        let line = c.line.value();
        let along = amount.value() * (turned + f64::from(order) * (c.throw.value() - line)).cos();
        sum[0] += along * line.cos();
        sum[1] += along * line.sin();
    }
    sum
}

/// The same a quarter of a period apart: two conjugate semidiameters of the ellipse on which the tip of the vector runs.
pub(super) fn semidiameters<N: Real>(order: u8, cylinders: &[Placed<N>], amounts: &[N]) -> [[f64; 2]; 2] {
    [0.0, FRAC_PI_2].map(|turned| sum_at(order, cylinders, amounts, turned))
}

/// The sum along the cranks of what turns with them.
pub(super) fn turning<N: Real>(cylinders: &[Placed<N>], amounts: impl IntoIterator<Item = f64>) -> [f64; 2] {
    let mut sum = [0.0; 2];
    for (c, amount) in cylinders.iter().zip(amounts) {
        sum[0] += amount * c.throw.value().cos();
        sum[1] += amount * c.throw.value().sin();
    }
    sum
}

/// Holds the largest and the least over a turn to two vectors a quarter of a period apart: half of the one and the other
/// turned back by a right angle turns forward, half of the one and the other turned on turns backward.
pub(super) fn semi_axes<W: Worksheet>(
    most: W::Num,
    least: W::Num,
    [a, b]: [[f64; 2]; 2],
    scale: f64,
    sheet: W,
) {
    let forward = f64::midpoint(a[0], b[1]).hypot((a[1] - b[0]) / 2.0);
    let backward = ((a[0] - b[1]) / 2.0).hypot(f64::midpoint(a[1], b[0]));
    let what = "the maximum over a revolution from two vectors a quarter of a period apart";
    sheet.check_sum(what, most, (forward + backward).into(), scale);
    let what = "the minimum over a revolution from two vectors a quarter of a period apart";
    sheet.check_sum(what, least, (forward - backward).abs().into(), scale);
}

/// The vector of an order that turns forward (1) or backward (−1), by the Fourier integral over a turn of the couples
/// of all pistons.
pub(super) fn couple(order: u8, sign: f64, pistons: &[Piston], motion: PistonMotion, about: f64) -> [f64; 2] {
    let points: u32 = if motion == PistonMotion::Exact { 512 } else { 32 };
    let (mut x, mut y) = (0.0, 0.0);
    for k in 0..points {
        let angle = TAU * f64::from(k) / f64::from(points);
        let (_, [a, b]) = engine::shaking(pistons, motion, about, angle);
        let (sine, cosine) = (sign * f64::from(order) * angle).sin_cos();
        x += a * cosine + b * sine;
        y += b * cosine - a * sine;
    }
    [x / f64::from(points), y / f64::from(points)]
}
