//! Free vibration with dry friction, and perhaps viscous damping: exact, stroke by stroke.
//!
//! A stroke is the motion from one turning point to the next. In it friction only shifts the position of rest:
//! `m ẍ + c ẋ + k x = ∓F` is a free vibration about `∓F/k` (Rao, *Mechanical Vibrations*, 5th ed., §2.9).

use std::{f64::consts::PI, ops::ControlFlow};

use super::free::FreeMotion;
use dalembert_numerics::roots;

/// A free vibration with friction. All displacements in m (or all in rad).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FrictionDecay {
    /// The motion without friction: natural frequency, damping ratio (not negative), start.
    pub motion: FreeMotion,
    /// Displacement that the spring needs to overcome the friction in motion, `F/k`; positive.
    pub offset: f64,
    /// Displacement up to which friction holds the mass at rest, `F_s/k ≥ F/k`.
    pub hold: f64,
}

/// Final rest of the motion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rest {
    /// Strokes until then, a part of a first one included; infinite where it never stops.
    pub strokes: f64,
    /// Time of rest; `None` where rest is only approached.
    pub time: Option<f64>,
    /// Position of rest.
    pub position: f64,
}

/// A stroke, or the rest.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stroke {
    /// Start time, s.
    pub begun: f64,
    /// The position that friction shifts rest to; the position itself where it rests.
    pub centre: f64,
    /// The motion about `centre` since `begun`; `None` at rest.
    pub motion: Option<FreeMotion>,
}

/// The first stroke, which begins with any velocity.
#[derive(Debug, Clone, Copy)]
struct First {
    motion: FreeMotion,
    centre: f64,
    /// Time and place of its turning point.
    turning: Option<(f64, f64)>,
}

impl FrictionDecay {
    /// The first turning point after the start: time and displacement. `None` where the mass does not move, or
    /// approaches rest without oscillating.
    pub fn first_turning(&self) -> Option<(f64, f64)> {
        self.first()?.turning
    }

    /// Displacement at the turning point `strokes` after one at `from` (both signed):
    /// `|X_j| = q^j |X₀| − (F/k)(1 + q)(1 − q^j)/(1 − q)` with `q = e^(−πζ/√(1 − ζ²))`, which is `|X₀| − 2jF/k`
    /// without viscous damping. It holds until the mass rests.
    pub fn turning(&self, from: f64, strokes: f64) -> f64 {
        if strokes == 0.0 {
            return from;
        }
        let log = self.log_decay();
        let side = if strokes % 2.0 == 0.0 { from.signum() } else { -from.signum() };
        let (kept, sum) = if log == 0.0 {
            (1.0, strokes)
        } else {
            ((-log * strokes).exp(), (-log * strokes).exp_m1() / (-log).exp_m1())
        };
        side * (kept * from.abs() - self.offset * (1.0 + (-log).exp()) * sum)
    }

    /// Position and time of final rest.
    pub fn rest(&self) -> Rest {
        let Some(first) = self.first() else {
            return Rest { strokes: 0.0, time: Some(0.0), position: self.motion.displacement };
        };
        let Some((time, position)) = first.turning else {
            return Rest { strokes: f64::INFINITY, time: None, position: first.centre };
        };
        // A release from rest is a turning point itself.
        let begun = if time > 0.0 { 1.0 } else { 0.0 };
        if position.abs() <= self.hold {
            return Rest { strokes: begun, time: Some(time), position };
        }
        if self.motion.damping_ratio >= 1.0 {
            let position = self.offset.copysign(position);
            return Rest { strokes: f64::INFINITY, time: None, position };
        }
        let strokes = self.strokes_from(position, self.hold);
        Rest {
            strokes: begun + strokes,
            time: Some(time + strokes * self.half_period()),
            position: self.turning(position, strokes),
        }
    }

    /// The stroke at a time `t ≥ 0`, or the rest after the last one.
    pub fn stroke(&self, time: f64) -> Stroke {
        let resting = |begun: f64, position: f64| Stroke { begun, centre: position, motion: None };
        let Some(first) = self.first() else { return resting(0.0, self.motion.displacement) };
        let Some((turned, position)) = first.turning.filter(|(turned, _)| *turned <= time) else {
            return Stroke { begun: 0.0, centre: first.centre, motion: Some(first.motion) };
        };
        if position.abs() <= self.hold {
            return resting(turned, position);
        }
        let (mut begun, mut start) = (turned, position);
        if self.motion.damping_ratio < 1.0 {
            let last = self.strokes_from(position, self.hold);
            let stroke = ((time - turned) / self.half_period()).floor().min(last);
            begun = turned + stroke * self.half_period();
            start = self.turning(position, stroke);
            if stroke >= last {
                return resting(begun, start);
            }
        }
        let centre = self.offset.copysign(start);
        let motion = FreeMotion { displacement: start - centre, velocity: 0.0, ..self.motion };
        Stroke { begun, centre, motion: Some(motion) }
    }

    /// Displacement and velocity at a time `t ≥ 0`.
    pub fn state(&self, time: f64) -> [f64; 2] {
        let stroke = self.stroke(time);
        let Some(motion) = stroke.motion else { return [stroke.centre, 0.0] };
        let [x, v, _] = motion.state(time - stroke.begun);
        [stroke.centre + x, v]
    }

    /// Displacement and velocity by marching: Taylor series of the equation of motion in small steps, with the time
    /// of each turning sought within its step. A second method, which knows nothing of strokes. `None` where it would
    /// take more than 20 000 steps.
    pub fn step_by_step(&self, time: f64) -> Option<[f64; 2]> {
        let (w, z) = (self.motion.natural_frequency, self.motion.damping_ratio);
        let step = 0.5 / (w * (1.0 + 2.0 * z));
        let steps = time / step;
        if steps.is_nan() || steps > 20_000.0 {
            return None;
        }
        let [mut x, mut v] = [self.motion.displacement, self.motion.velocity];
        let mut now = 0.0;
        let mut direction = v.signum();
        if v == 0.0 {
            if x.abs() <= self.hold {
                return Some([x, v]);
            }
            direction = -x.signum();
        }
        while now < time {
            let h = step.min(time - now);
            let centre = -direction * self.offset;
            let from = FreeMotion { displacement: x - centre, velocity: v, ..self.motion };
            let to = |h: f64| from.integrated(h).map_or([f64::NAN; 2], |[y, v]| [centre + y, v]);
            let [there, speed] = to(h);
            if speed * direction >= 0.0 {
                (x, v, now) = (there, speed, now + h);
                continue;
            }
            // It turns within this step.
            let ends = [if v == 0.0 { 1e-9 * h } else { 0.0 }, h];
            let turn = roots::find(|h| to(h)[1], ends, |_| ControlFlow::Continue(())).ok()?;
            x = to(turn)[0];
            v = 0.0;
            now += turn;
            direction = -direction;
            if x.abs() <= self.hold {
                return Some([x, 0.0]);
            }
        }
        Some([x, v])
    }

    /// Strokes from a turning point until a turning point is no farther out than `level`.
    pub fn strokes_from(&self, from: f64, level: f64) -> f64 {
        let beyond = from.abs() - level;
        if beyond <= 0.0 {
            return 0.0;
        }
        let log = self.log_decay();
        let strokes = if log == 0.0 {
            beyond / (2.0 * self.offset)
        } else {
            // |X_j| + C falls by q at each stroke, C = (F/k)(1 + q)/(1 − q).
            let c = self.offset / (log / 2.0).tanh();
            (beyond / (level + c)).ln_1p() / log
        };
        // A turning point on the edge itself is not missed by rounding.
        (strokes * (1.0 - 1e-12)).ceil()
    }

    /// `π/ω_d`, the time of a stroke.
    pub fn half_period(&self) -> f64 {
        PI / self.motion.damped_frequency()
    }

    /// `πζ/√(1 − ζ²)`: what viscous damping takes in a stroke.
    fn log_decay(&self) -> f64 {
        let z = self.motion.damping_ratio;
        PI * z / ((1.0 - z) * (1.0 + z)).sqrt()
    }

    fn first(&self) -> Option<First> {
        let FreeMotion { displacement, velocity, .. } = self.motion;
        if velocity == 0.0 {
            if displacement.abs() <= self.hold {
                return None;
            }
            let centre = self.offset.copysign(displacement);
            let motion = FreeMotion { displacement: displacement - centre, ..self.motion };
            return Some(First { motion, centre, turning: Some((0.0, displacement)) });
        }
        let centre = -self.offset.copysign(velocity);
        let motion = FreeMotion { displacement: displacement - centre, ..self.motion };
        let turning = motion.first_turning().map(|time| (time, centre + motion.state(time)[0]));
        Some(First { motion, centre, turning })
    }
}
