//! Turning points of an output: the zeros of its rate, none missed and each to rounding.

use std::{f64::consts::PI, ops::ControlFlow};

use super::{LoadLaw, Oscillator, OscillatorState, TransientError, TransientOutput};
use dalembert_numerics::roots;

/// The most turning points that are searched for at either end of a piece.
const MOST_TURNS: usize = 200;
/// Samples for each period where turning points have no closed form.
const SAMPLES: f64 = 16.0;
/// The most samples over a piece.
const MOST_SAMPLES: f64 = 1500.0;

impl Oscillator {
    /// Times, from the start of a stretch, at which the rate of the output is zero: all that may be extremes.
    pub(super) fn turning_points(
        self,
        state: OscillatorState,
        law: LoadLaw,
        output: TransientOutput,
        length: f64,
    ) -> Result<Vec<f64>, TransientError> {
        let windows = match law {
            LoadLaw::Line { start, slope } => {
                return self.line_turning_points(state, [start, slope], output, length);
            }
            LoadLaw::Sine { frequency, .. } | LoadLaw::Versine { frequency, .. } => {
                windows(length.min(1e9 / frequency), self.natural.max(frequency))
            }
            LoadLaw::Parabola { .. } => {
                if length.is_infinite() {
                    return Err(TransientError::Unbounded);
                }
                windows(length, self.natural)
            }
            LoadLaw::Decay { rate, .. } | LoadLaw::Rise { rate, .. } => {
                let seen = 10.0 / rate + 16.0 * PI / self.natural;
                windows(length.min(seen), self.natural.max(rate))
            }
        };
        let mut turns = Vec::new();
        for bracket in self.sampled(state, law, output, windows) {
            turns.extend(self.turn(state, law, output, bracket)?);
        }
        Ok(turns)
    }

    /// Zero of the rate of the output between two times, if its sign changes there.
    fn turn(
        self,
        state: OscillatorState,
        law: LoadLaw,
        output: TransientOutput,
        [from, to]: [f64; 2],
    ) -> Result<Option<f64>, TransientError> {
        let rate = |tau: f64| self.rate(self.advance(state, law, tau), law.at(tau), output);
        let (a, b) = (rate(from), rate(to));
        if b == 0.0 {
            return Ok(Some(to));
        }
        if a * b.signum() >= 0.0 {
            return Ok(None);
        }
        match roots::find(rate, [from, to], |_| ControlFlow::Continue(())) {
            Ok(tau) | Err(roots::RootError::Discontinuity { at: tau }) => Ok(Some(tau)),
            Err(err) => Err(err.into()),
        }
    }

    /// Between what an output stays under a straight load: the amplitude of the free motion about its line, or, over a
    /// short piece whose values at both ends are known, how far it may bulge between them.
    pub(super) fn line_bounds(
        self,
        state: OscillatorState,
        [start, slope]: [f64; 2],
        output: TransientOutput,
        length: f64,
        ends: [Option<f64>; 2],
    ) -> [f64; 2] {
        if self.ratio >= 1.0 {
            return [f64::NEG_INFINITY, f64::INFINITY];
        }
        let damped = ((1.0 - self.ratio) * (1.0 + self.ratio)).sqrt();
        let amplitude = |[value, rate]: [f64; 2]| value.hypot((rate + self.ratio * value) / damped);
        let about_line = amplitude(self.about_line(state, [start, slope], output));
        let per_radian = slope / self.natural;
        let first =
            output.displacement * (start - 2.0 * self.ratio * per_radian) + output.velocity * per_radian;
        let last = if slope == 0.0 { first } else { first + output.displacement * slope * length };
        let line = [first.min(last) - about_line, first.max(last) + about_line];
        let [Some(a), Some(b)] = ends else { return line };
        // A function is nowhere farther from its chord than an eighth of the square of the length times its bend.
        let bulge =
            (self.natural * length).powi(2) / 8.0 * amplitude(self.bend(state, [start, slope], output));
        [line[0].max(a.min(b) - bulge), line[1].min(a.max(b) + bulge)]
    }

    /// The output about the line of a straight load, and its rate: a free vibration.
    fn about_line(
        self,
        state: OscillatorState,
        [start, slope]: [f64; 2],
        output: TransientOutput,
    ) -> [f64; 2] {
        let zeta = self.ratio;
        let (x, u, slope) = (state.displacement, state.velocity / self.natural, slope / self.natural);
        let (x, u) = (x - (start - 2.0 * zeta * slope), u - slope);
        [
            output.displacement * x + output.velocity * u,
            output.displacement * u - output.velocity * (x + 2.0 * zeta * u),
        ]
    }

    /// The rate of the rate of the output under a straight load, and its own rate: a free vibration too.
    fn bend(self, state: OscillatorState, [start, slope]: [f64; 2], output: TransientOutput) -> [f64; 2] {
        let zeta = self.ratio;
        let (x, u, slope) = (state.displacement, state.velocity / self.natural, slope / self.natural);
        let acceleration = start - x - 2.0 * zeta * u;
        let jerk = slope - u - 2.0 * zeta * acceleration;
        let snap = -acceleration - 2.0 * zeta * jerk;
        [
            output.displacement * acceleration + output.velocity * jerk,
            output.displacement * jerk + output.velocity * snap,
        ]
    }

    /// The turning points under a straight load that may be the least or the largest: swings whose bound, the
    /// straight line and the amplitude that is left about it, is within what was found already are passed over.
    fn line_turning_points(
        self,
        state: OscillatorState,
        [start, slope]: [f64; 2],
        output: TransientOutput,
        length: f64,
    ) -> Result<Vec<f64>, TransientError> {
        let zeta = self.ratio;
        let law = LoadLaw::Line { start, slope };
        let points = self.level_points(state, [start, slope], output, length)?;
        let amplitude = if zeta < 1.0 {
            let [value, rate] = self.about_line(state, [start, slope], output);
            value.hypot((rate + zeta * value) / ((1.0 - zeta) * (1.0 + zeta)).sqrt())
        } else {
            f64::INFINITY
        };
        let slope = slope / self.natural;
        let line = |theta: f64| {
            output.displacement * (start + slope * (theta - 2.0 * zeta)) + output.velocity * slope
        };
        let bounds: Vec<[f64; 2]> = points
            .windows(2)
            .map(|pair| {
                let [a, b] = [self.natural * pair[0], self.natural * pair[1]];
                let left = if amplitude.is_finite() { amplitude * (-zeta * a).exp() } else { amplitude };
                let (a, b) = if slope == 0.0 { (line(0.0), line(0.0)) } else { (line(a), line(b)) };
                [a.min(b) - left, a.max(b) + left]
            })
            .collect();
        let mut turns: Vec<f64> = Vec::new();
        for sign in [1.0, -1.0] {
            let bound = |n: usize| if sign > 0.0 { bounds[n][1] } else { -bounds[n][0] };
            let mut order: Vec<usize> = (0..bounds.len()).collect();
            order.sort_by(|&a, &b| bound(b).total_cmp(&bound(a)));
            let mut best = f64::NEG_INFINITY;
            for n in order {
                // What rounding alone tells apart is not higher.
                if bound(n) <= best + 1e-12 * best.abs() {
                    break;
                }
                if let Some(tau) = self.turn(state, law, output, [points[n], points[n + 1]])? {
                    let at = self.advance(state, law, tau);
                    let value =
                        output.displacement * at.displacement + output.velocity * at.velocity / self.natural;
                    best = best.max(sign * value);
                    turns.push(tau);
                }
            }
        }
        turns.sort_by(f64::total_cmp);
        Ok(turns)
    }

    /// The parts of some windows that may hold an extreme: those where the rate changes its sign near the least or the
    /// largest of all samples.
    fn sampled(
        self,
        state: OscillatorState,
        law: LoadLaw,
        output: TransientOutput,
        windows: Vec<Vec<f64>>,
    ) -> Vec<[f64; 2]> {
        let mut found = Vec::new();
        let (mut least, mut largest) = (f64::INFINITY, f64::NEG_INFINITY);
        for window in windows {
            let mut before: Option<(f64, f64, f64)> = None;
            for tau in window {
                let at = self.advance(state, law, tau);
                let value =
                    output.displacement * at.displacement + output.velocity * at.velocity / self.natural;
                let rate = self.rate(at, law.at(tau), output);
                (least, largest) = (least.min(value), largest.max(value));
                if let Some((from, value_before, rate_before)) = before
                    && (rate == 0.0 || rate_before * rate.signum() < 0.0)
                {
                    found.push(([from, tau], value_before.min(value), value_before.max(value)));
                }
                before = Some((tau, value, rate));
            }
        }
        // A sample lies within 2 % of the peak of its swing.
        let margin = 0.1 * (largest - least);
        found.retain(|(_, low, high)| *high >= largest - margin || *low <= least + margin);
        found.into_iter().map(|(bracket, ..)| bracket).collect()
    }

    /// The rate of an output, over the natural frequency.
    fn rate(self, state: OscillatorState, load: f64, output: TransientOutput) -> f64 {
        let (x, u) = (state.displacement, state.velocity / self.natural);
        output.displacement * u + output.velocity * (load - x - 2.0 * self.ratio * u)
    }

    /// Times between which the rate of an output rises or falls all along under a straight load: its own rate
    /// is a free vibration, whose zeros are known.
    fn level_points(
        self,
        state: OscillatorState,
        [start, slope]: [f64; 2],
        output: TransientOutput,
        length: f64,
    ) -> Result<Vec<f64>, TransientError> {
        let zeta = self.ratio;
        let [value, rate] = self.bend(state, [start, slope], output);
        let endless = length.is_infinite();
        if endless && slope != 0.0 {
            return Err(TransientError::Unbounded);
        }
        let theta_end = self.natural * length;
        let mut points = vec![0.0];
        let leaning = rate + zeta * value;
        if zeta < 1.0 {
            let damped = ((1.0 - zeta) * (1.0 + zeta)).sqrt();
            // value cos + leaning/damped sin = 0
            let first = (-value * damped).atan2(leaning).rem_euclid(PI) / damped;
            let half = PI / damped;
            let all = ((theta_end - first) / half).floor() + 1.0;
            // Under a constant load each swing is smaller than the last, or as large: the first tell.
            let wanted = if slope == 0.0 { 4.0 } else { MOST_TURNS as f64 };
            let swing = |n: f64| first + n * half;
            if all <= 2.0 * wanted || slope == 0.0 {
                let count = all.min(2.0 * wanted).max(0.0) as usize;
                points.extend((0..count).map(|n| swing(n as f64)));
            } else {
                let tail = (0..MOST_TURNS).map(|n| all - MOST_TURNS as f64 + n as f64);
                points.extend((0..MOST_TURNS).map(|n| n as f64).chain(tail).map(swing));
            }
        } else {
            let spread = ((zeta - 1.0) * (zeta + 1.0)).sqrt();
            let tanh = -value / leaning;
            let zero = if spread == 0.0 { tanh } else { (tanh * spread).atanh() / spread };
            if zero.is_finite() && zero > 0.0 {
                points.push(zero);
            }
        }
        let mut points: Vec<f64> = points.into_iter().filter(|theta| *theta < theta_end).collect();
        if endless {
            // The last swing of a motion that dies out without another zero.
            let last = points.last().copied().unwrap_or(0.0);
            let slowest = if zeta > 1.0 { zeta + ((zeta - 1.0) * (zeta + 1.0)).sqrt() } else { 1.0 };
            points.push(last + 40.0 * slowest);
        } else {
            points.push(theta_end);
        }
        Ok(points.into_iter().map(|theta| theta / self.natural).collect())
    }
}

/// Samples over a stretch, enough of them for each period of the fastest motion; over a long one, at its start, about
/// its middle and at its end, where the extremes of a slow load are.
fn windows(length: f64, fastest: f64) -> Vec<Vec<f64>> {
    let parts = (length * fastest * SAMPLES / (2.0 * PI)).ceil().max(SAMPLES);
    if parts <= MOST_SAMPLES {
        return vec![(0..=parts as usize).map(|n| length * n as f64 / parts).collect()];
    }
    let third = MOST_SAMPLES / 3.0;
    let step = 2.0 * PI / (SAMPLES * fastest);
    [0.0, length / 2.0 - step * third / 2.0, length - step * third]
        .into_iter()
        .map(|from| (0..=third as usize).map(|n| from + step * n as f64).collect())
        .collect()
}
