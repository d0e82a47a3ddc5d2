//! A turning moment over a cycle: its mean, its extremes, and the energy that a flywheel takes up.

use dalembert_numerics::{gauss_legendre as quadrature, roots};

/// Turning moment over a cycle: mean, energy fluctuation, extremes.
#[derive(Debug, Clone, PartialEq)]
pub struct TorqueCycle {
    /// Mean moment, N·m.
    pub mean: f64,
    /// Root mean square, N·m.
    pub rms: f64,
    /// Crank angle, rad, and size of the largest moment.
    pub largest: (f64, f64),
    /// Crank angle, rad, and size of the least moment.
    pub least: (f64, f64),
    /// Work above the mean moment from the start of the cycle, at every angle at which the moment crosses its mean.
    pub crossings: Vec<(f64, f64)>,
    /// Fluctuation of energy: the largest less the least work above the mean moment, J.
    pub fluctuation: f64,
}

/// Parts of a turn that are integrated by themselves.
const PARTS: u32 = 96;

impl TorqueCycle {
    /// Of a moment that is continuous, repeats after `period`, and is smooth between the angles `corners`.
    pub fn of(moment: impl Fn(f64) -> f64, period: f64, corners: &[f64]) -> Self {
        let knots = knots(period, corners);
        let (mut work, mut squares) = (0.0, 0.0);
        for pair in knots.windows(2) {
            work += gauss(&moment, pair[0], pair[1]);
            squares += gauss(|angle| moment(angle).powi(2), pair[0], pair[1]);
        }
        let at: Vec<f64> = knots.iter().map(|angle| moment(*angle)).collect();
        let size = at.iter().fold(0.0f64, |size, value| size.max(value.abs()));
        let mean = clean(work / period, size);
        let (crossings, fluctuation) = crossings(&moment, &knots, &at, mean, size);
        Self {
            mean,
            rms: (squares / period).sqrt(),
            largest: extreme(&moment, &knots, &at, 1.0),
            least: extreme(&moment, &knots, &at, -1.0),
            crossings,
            fluctuation,
        }
    }
}

/// Ends of the parts: equal ones, and the corners.
fn knots(period: f64, corners: &[f64]) -> Vec<f64> {
    let parts = PARTS * (period / std::f64::consts::TAU).ceil().clamp(1.0, 8.0) as u32;
    let mut knots: Vec<f64> = (0..=parts).map(|k| period * f64::from(k) / f64::from(parts)).collect();
    let inside = corners.iter().map(|corner| corner.rem_euclid(period));
    knots.extend(inside.filter(|corner| corner.is_finite()));
    knots.sort_by(f64::total_cmp);
    knots.dedup_by(|b, a| *b - *a < 1e-12 * period);
    // The cycle ends where it began.
    if let Some(last) = knots.last_mut() {
        *last = period;
    }
    knots
}

fn gauss(f: impl Fn(f64) -> f64, from: f64, to: f64) -> f64 {
    (to - from)
        * quadrature::points(1).map(|(part, weight)| weight * f(from + part * (to - from))).sum::<f64>()
}

/// Work above the mean at the crossings, and the range of it.
fn crossings(
    moment: &impl Fn(f64) -> f64,
    knots: &[f64],
    at: &[f64],
    mean: f64,
    size: f64,
) -> (Vec<(f64, f64)>, f64) {
    let over = |angle: f64| moment(angle) - mean;
    let (mut work, mut found) = (0.0, Vec::new());
    for (pair, values) in knots.windows(2).zip(at.windows(2)) {
        let (before, after) = (clean(values[0] - mean, size), clean(values[1] - mean, size));
        if before == 0.0 {
            found.push((pair[0], work));
        } else if before * after < 0.0
            && let Ok(angle) = roots::find(over, [pair[0], pair[1]], |_| std::ops::ControlFlow::Continue(()))
        {
            found.push((angle, work + gauss(over, pair[0], angle)));
        }
        work += gauss(over, pair[0], pair[1]);
    }
    let most = found.iter().map(|(_, work)| *work).fold(f64::NEG_INFINITY, f64::max);
    let least = found.iter().map(|(_, work)| *work).fold(f64::INFINITY, f64::min);
    let range = if most > least { most - least } else { 0.0 };
    (found, range)
}

/// The largest (`sign` 1) or least (`sign` −1) moment: of the knots, and of the places near those that may belong to the
/// highest top where the slope is zero.
fn extreme(moment: &impl Fn(f64) -> f64, knots: &[f64], at: &[f64], sign: f64) -> (f64, f64) {
    let size = at.iter().fold(0.0f64, |size, value| size.max(value.abs()));
    let last = knots.len() - 1;
    let (period, width) = (knots[last], knots[last] / last as f64);
    let step = 0.02 * width;
    let slope = |angle: f64| {
        8.0 * (moment(angle + step) - moment(angle - step))
            - (moment(angle + 2.0 * step) - moment(angle - 2.0 * step))
    };
    let mut best = 0;
    for (k, value) in at.iter().enumerate() {
        if sign * value > sign * at[best] + 1e-9 * size {
            best = k;
        }
    }
    let refined = |knot: usize| {
        let (low, high) = (knots[knot] - width, knots[knot] + width);
        if sign * slope(low) <= 0.0 || sign * slope(high) >= 0.0 {
            return None;
        }
        let angle = roots::find(slope, [low, high], |_| std::ops::ControlFlow::Continue(())).ok()?;
        Some((angle.rem_euclid(period), moment(angle)))
    };
    let mut found = (knots[best], at[best]);
    if let Some(top) = refined(best).filter(|top| sign * top.1 > sign * found.1 + 1e-12 * size) {
        found = top;
    }
    for (knot, value) in at.iter().enumerate().take(last) {
        let beside =
            [at[if knot == 0 { last - 1 } else { knot - 1 }], at[knot + 1]].map(|value| sign * value);
        let here = sign * value;
        // A smooth top is higher than its knot by less than the knot is higher than its lower neighbour.
        let may = here >= beside[0].max(beside[1]) && 2.0 * here - beside[0].min(beside[1]) > sign * found.1;
        if !may || knot == best {
            continue;
        }
        if let Some(top) = refined(knot).filter(|top| sign * top.1 > sign * found.1 + 1e-9 * size) {
            found = top;
        }
    }
    found
}

/// Flushes a number that is rounding noise beside `size` to zero.
fn clean(x: f64, size: f64) -> f64 {
    if x.abs() <= 1e-12 * size { 0.0 } else { x }
}
