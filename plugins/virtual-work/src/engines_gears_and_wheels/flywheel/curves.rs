//! Torques over the crank angle.

use std::f64::consts::TAU;

use dalembert_core::{Axis, Plot, Refusal, Series};
use dalembert_mechanics::slider_crank::{cycle::TorqueCycle, gas::Diagram as Curve};

use super::TorqueHarmonic;
use crate::shared::flywheel::Strokes;

/// The turning moment less the variation of the load, over a cycle.
pub(super) struct Curved {
    pub cycle: TorqueCycle,
    pub period: f64,
    /// The turning moment itself.
    pub points: Vec<(f64, f64)>,
    /// The load, where it varies.
    pub load: Option<Vec<(f64, f64)>>,
    /// Moments that accelerate the flywheel most and least, with their crank angles.
    pub excess: [(f64, f64); 2],
}

/// A moment over the crank angle.
pub(super) struct Course<'a> {
    pub at: Box<dyn Fn(f64) -> f64 + 'a>,
    pub period: f64,
    pub corners: Vec<f64>,
}

/// The harmonics of a torque, and the cycle after which they repeat.
pub(super) fn harmonics(rows: &[TorqueHarmonic]) -> Result<Course<'_>, Refusal> {
    let at = move |angle: f64| {
        let waves = rows.iter().map(|row| {
            let (sine, cosine) = (row.order * angle).sin_cos();
            row.sine * sine + row.cosine * cosine
        });
        waves.sum()
    };
    Ok(Course { at: Box::new(at), period: period(rows)?, corners: Vec::new() })
}

/// A torque by straight lines between rows, and its mean.
pub(super) fn table(rows: Vec<[f64; 2]>, strokes: Strokes) -> Result<(Course<'static>, f64), Refusal> {
    let turns = strokes.turns();
    let period = TAU * f64::from(turns);
    let span = match rows[..] {
        [first, .., last] => last[0] - first[0],
        _ => f64::INFINITY,
    };
    let ascending = rows.windows(2).all(|pair| pair[0][0] < pair[1][0]);
    if !ascending || span > period * (1.0 + 1e-9) {
        return Err(Refusal::because(
            "the table needs at least two rows in ascending order of crank angle, within one cycle",
        ));
    }
    let corners = rows.iter().map(|row| row[0]).collect();
    let mean = trapezia(&rows, period);
    let curve = Curve::Angle { rows, turns };
    Ok((Course { at: Box::new(move |angle| curve.pressure(angle, 0.0, true)), period, corners }, mean))
}

/// The turning moment, `mean` above its course, less the variation of the load; and what accelerates the flywheel.
pub(super) fn curved<'a>(
    driving: Course<'a>,
    load: Option<Course<'a>>,
    mean: f64,
) -> (Curved, Box<dyn Fn(f64) -> f64 + 'a>) {
    let period = load.as_ref().map_or(driving.period, |load| load.period.max(driving.period));
    let mut corners = Vec::new();
    for course in [Some(&driving), load.as_ref()].into_iter().flatten() {
        let times = (period / course.period).round() as u32;
        let again = (0..times).map(|turn| f64::from(turn) * course.period);
        corners.extend(again.flat_map(|shift| course.corners.iter().map(move |corner| corner + shift)));
    }
    let turned = |angle: f64| mean + (driving.at)(angle);
    let varying = |angle: f64| load.as_ref().map_or(0.0, |load| (load.at)(angle));
    let cycle = TorqueCycle::of(|angle| turned(angle) - varying(angle), period, &corners);
    let angles = || (0..=360).map(|k| period * f64::from(k) / 360.0);
    let points = angles().map(|angle| (angle, turned(angle))).collect();
    let level = cycle.mean;
    let shown = load.is_some().then(|| angles().map(|angle| (angle, level + varying(angle))).collect());
    let excess = [cycle.largest, cycle.least].map(|(angle, moment)| (angle, moment - level));
    let curved = Curved { cycle, period, points, load: shown, excess };
    let Course { at: driving, .. } = driving;
    let load = load.map(|load| load.at);
    let at = move |angle: f64| mean + driving(angle) - load.as_ref().map_or(0.0, |load| load(angle)) - level;
    (curved, Box::new(at))
}

/// The mean of straight lines through the rows, closed over the period.
fn trapezia(rows: &[[f64; 2]], period: f64) -> f64 {
    let inside: f64 =
        rows.windows(2).map(|pair| f64::midpoint(pair[0][1], pair[1][1]) * (pair[1][0] - pair[0][0])).sum();
    let closing = match rows {
        [first, .., last] => f64::midpoint(first[1], last[1]) * (period - (last[0] - first[0])),
        _ => 0.0,
    };
    (inside + closing) / period
}

/// One turn where all orders are whole, two where some are halves.
fn period(rows: &[TorqueHarmonic]) -> Result<f64, Refusal> {
    let whole = |x: f64| (x - x.round()).abs() < 1e-9;
    if rows.is_empty() {
        return Err(Refusal::because(
            "without harmonics the turning moment is its mean: write at least one harmonic",
        ));
    }
    if rows.iter().all(|row| whole(row.order)) {
        Ok(TAU)
    } else if rows.iter().all(|row| whole(2.0 * row.order)) {
        Ok(2.0 * TAU)
    } else {
        Err(Refusal::because(
            "an order is neither an integer nor a half-integer, so the turning moment is not periodic over two revolutions",
        ))
    }
}

pub(super) fn plot(curved: &Curved, mean: f64) -> Plot {
    let cycle = &curved.cycle;
    let level = |angle: f64| match &curved.load {
        Some(load) => {
            let place = (angle / curved.period * 360.0).clamp(0.0, 359.999);
            let (before, part) = (place.floor() as usize, place.fract());
            load[before].1 + part * (load[before + 1].1 - load[before].1)
        }
        None => mean,
    };
    let crossings = cycle.crossings.iter().map(|(angle, _)| (*angle, level(*angle))).collect();
    let mut series = vec![Series::line("turning moment", curved.points.clone())];
    if let Some(load) = &curved.load {
        series.push(Series::line("load torque", load.clone()));
        series.push(Series::dots("crossings", crossings));
    } else {
        series.push(Series::dots("crossings of the mean", crossings));
    }
    Plot::new(
        "Turning moment over the cycle",
        Axis::linear("Crank angle", "deg"),
        Axis::linear("Turning moment", "N*m"),
        series,
    )
    .level("mean", mean)
}
