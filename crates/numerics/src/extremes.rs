//! The least and the largest value of a number that changes with time, from the motion itself: every stretch in which it
//! turns is bracketed, and the turn found to rounding.
//!
//! ```
//! use std::f64::consts::{FRAC_PI_4, SQRT_2};
//!
//! use dalembert_numerics::extremes::{Extremes, Sampling};
//!
//! // Motion after a blow, x = e⁻ᵗ sin t: it turns where tan t = 1, at π/4 for the first time.
//! let mut motion = |t: f64| Sampling::of((-t).exp() * t.sin(), (-t).exp() * (t.cos() - t.sin()));
//! let mut extremes = Extremes::at(0.0, 0.0);
//! for step in 0..10 {
//!     let from = 0.5 * f64::from(step);
//!     extremes.follow(&mut motion, [from, from + 0.5]);
//! }
//! assert!((extremes.largest.time - FRAC_PI_4).abs() < 1e-12);
//! assert!((extremes.largest.value - (-FRAC_PI_4).exp() / SQRT_2).abs() < 1e-15);
//! assert!((extremes.least.time - 5.0 * FRAC_PI_4).abs() < 1e-12);
//! ```

use std::ops::ControlFlow;

use crate::roots;

/// A value and the first time at which it is reached.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Extreme {
    /// Time of the extreme, s.
    pub time: f64,
    /// The value.
    pub value: f64,
}

/// The least and the largest value over a stretch of time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Extremes {
    /// The least.
    pub least: Extreme,
    /// The largest.
    pub largest: Extreme,
}

/// A number at a time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sampling {
    /// Value of the function there.
    pub value: f64,
    /// A smooth number that turns where it does: the number itself, if it is smooth.
    pub smooth: f64,
    /// The rate of the smooth number.
    pub rate: f64,
}

impl Sampling {
    /// A smooth number and its rate.
    pub fn of(value: f64, rate: f64) -> Self {
        Self { value, smooth: value, rate }
    }
}

impl Extremes {
    /// Of one moment.
    pub fn at(time: f64, value: f64) -> Self {
        let first = Extreme { time, value };
        Self { least: first, largest: first }
    }

    /// The one that is farther from zero; the largest where both are as far.
    pub fn farthest(self) -> Extreme {
        let (least, largest) = (self.least.value.abs(), self.largest.value.abs());
        if least > largest * (1.0 + 1e-9) { self.least } else { self.largest }
    }

    /// Takes up another moment.
    pub fn note(&mut self, seen: Extreme) {
        // What rounding alone tells apart is not later and higher.
        let rounding = 1e-12 * self.largest.value.abs().max(self.least.value.abs());
        if seen.value > self.largest.value + rounding {
            self.largest = seen;
        }
        if seen.value < self.least.value - rounding {
            self.least = seen;
        }
    }

    /// Takes up the stretch between two times that are a share of the shortest period apart: its turns and its end.
    pub fn follow(&mut self, number: &mut impl FnMut(f64) -> Sampling, [from, to]: [f64; 2]) {
        let ends = [(from, number(from)), (to, number(to))];
        self.between(number, ends, DEEP);
        self.note(Extreme { time: to, value: ends[1].1.value });
    }

    fn between(&mut self, number: &mut impl FnMut(f64) -> Sampling, ends: [(f64, Sampling); 2], deep: u32) {
        let [(from, a), (to, b)] = ends;
        let step = to - from;
        if a.rate * b.rate < 0.0 {
            let on = |_| ControlFlow::Continue(());
            if let Ok(time) = roots::find(|time| number(time).rate, [from, to], on) {
                self.note(Extreme { time, value: number(time).value });
            }
            return;
        }
        // Where the cubic through both ends turns twice between them, so may the number.
        let (rise, bend) = (b.smooth - a.smooth, (a.rate + b.rate) * step);
        let curve = 3.0 * (bend - 2.0 * rise);
        let part = (3.0 * rise - (2.0 * a.rate + b.rate) * step) / -curve;
        let slope = a.rate * step - curve * part * part;
        // A bulge that rounding may have made is none.
        let bulges = slope.abs() * step > ROUNDING * (a.smooth.abs() + b.smooth.abs());
        if deep > 0 && bulges && part > 0.0 && part < 1.0 && slope * (a.rate + b.rate) < 0.0 {
            let middle = from + part * step;
            if middle > from && middle < to {
                let seen = (middle, number(middle));
                self.between(number, [(from, a), seen], deep - 1);
                self.between(number, [seen, (to, b)], deep - 1);
            }
        }
    }
}

/// Maximum number of bisections of an interval in which the function may have two turning points.
const DEEP: u32 = 6;
/// Rounding error of the difference of two neighbouring values, relative to their magnitude.
const ROUNDING: f64 = 1e-13;

/// The largest value of a smooth number, and where it is, from ascending places that are a share of its shortest period
/// apart: about each place that is higher than its neighbours, and may belong to the highest top, the top is found by
/// parabolas held by golden sections (R. P. Brent, *Algorithms for Minimization without Derivatives* (1973), ch. 5).
pub fn largest(mut number: impl FnMut(f64) -> f64, places: &[f64]) -> Option<Extreme> {
    let values: Vec<f64> = places.iter().map(|place| number(*place)).collect();
    largest_about(number, places, &values)
}

/// The same where the values at the places are known, one for each place in their order.
pub fn largest_about(mut number: impl FnMut(f64) -> f64, places: &[f64], values: &[f64]) -> Option<Extreme> {
    let all = places.iter().zip(values).map(|(time, value)| Extreme { time: *time, value: *value });
    let mut best = all.reduce(|best, next| if next.value > best.value { next } else { best })?;
    for n in 1..places.len().saturating_sub(1) {
        let [before, here, after] = [values[n - 1], values[n], values[n + 1]];
        // A smooth top is higher than its place by less than the place is higher than the lower neighbour.
        if here < before || here < after || here + (here - before.min(after)) < best.value {
            continue;
        }
        let top = top(&mut number, [places[n - 1], places[n], places[n + 1]], here);
        if top.value > best.value {
            best = top;
        }
    }
    Some(best)
}

/// The top about a place that is higher than both of its neighbours.
fn top(number: &mut impl FnMut(f64) -> f64, [mut low, place, mut high]: [f64; 3], value: f64) -> Extreme {
    const GOLDEN: f64 = 0.381_966_011_250_105_1;
    const ROUNDS: u32 = 60;
    let tolerance = 1e-9 * (high - low);
    // The best place, the one before it, and the one before that.
    let mut best = (place, value);
    let (mut second, mut third) = (best, best);
    let (mut step, mut last) = (0.0f64, 0.0f64);
    for _ in 0..ROUNDS {
        let middle = f64::midpoint(low, high);
        if (best.0 - middle).abs() <= 2.0 * tolerance - (high - low) / 2.0 {
            break;
        }
        let r = (best.0 - second.0) * (best.1 - third.1);
        let q = (best.0 - third.0) * (best.1 - second.1);
        let (up, down) = ((best.0 - third.0) * q - (best.0 - second.0) * r, 2.0 * (q - r));
        let guess = -up / down;
        let inside = best.0 + guess > low + tolerance && best.0 + guess < high - tolerance;
        if guess.is_finite() && inside && guess.abs() < last.abs() / 2.0 {
            (last, step) = (step, guess);
        } else {
            last = if best.0 < middle { high - best.0 } else { low - best.0 };
            step = GOLDEN * last;
        }
        let place = best.0 + if step.abs() >= tolerance { step } else { tolerance.copysign(step) };
        let next = (place, number(place));
        if next.1 >= best.1 {
            if next.0 < best.0 {
                high = best.0;
            } else {
                low = best.0;
            }
            (third, second, best) = (second, best, next);
        } else {
            if next.0 < best.0 {
                low = next.0;
            } else {
                high = next.0;
            }
            if next.1 >= second.1 || second.0 == best.0 {
                (third, second) = (second, next);
            } else if next.1 >= third.1 || third.0 == best.0 || third.0 == second.0 {
                third = next;
            }
        }
    }
    Extreme { time: best.0, value: best.1 }
}
