//! Steady motion of mass and spring with dry friction under a harmonic force, exact.
//!
//! In units of the spring: `x″ + x = s cos(rτ + φ) − f sgn x′`, with `τ = ω_n t`, `r = ω/ω_n`, the static deflection
//! `s = F₀/k` and the offset `f = F/k`. Where the mass never stops within a half cycle the motion is known in closed
//! form (J. P. Den Hartog, *Forced vibrations with combined Coulomb and viscous friction*, Trans. ASME 53, 1931);
//! otherwise it slides and sticks, and is followed piece by piece.

use std::{
    f64::consts::{PI, TAU},
    ops::ControlFlow,
};

use crate::Real;
use dalembert_numerics::roots;

/// Oscillator with Coulomb friction under a harmonic force.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CoulombOscillator {
    /// Frequency ratio `r = ω/ω_n`; positive.
    pub ratio: f64,
    /// Static deflection under the force, `s = F₀/k`, m; positive.
    pub deflection: f64,
    /// Deflection that the spring needs to overcome friction, `f = F/k`, m; positive.
    pub offset: f64,
}

/// A slide between two rests of a motion with stops; times as `τ = ω_n t`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Slide {
    /// Start time.
    pub from: f64,
    /// Start position, m.
    pub start: f64,
    /// Direction of slipping: 1 or −1.
    pub direction: f64,
    /// End time.
    pub until: f64,
    /// End position, m.
    pub end: f64,
}

/// The steady motion.
#[derive(Debug, Clone, PartialEq)]
pub enum CoulombResponse {
    /// The force does not overcome friction.
    Stuck,
    /// At the natural frequency, with more force than friction can take up: the amplitude grows without bound.
    Unbounded,
    /// The mass never rests within a half cycle: amplitude in m, and lag of the motion behind the force in rad.
    Sliding {
        /// Amplitude, m.
        amplitude: f64,
        /// Angle by which the extreme of the motion lags that of the force, rad.
        lag: f64,
    },
    /// The mass rests for a part of each cycle.
    Stopping {
        /// Half the distance between the extremes, m.
        amplitude: f64,
        /// The slides of one cycle, in order.
        slides: Vec<Slide>,
    },
    /// The motion had not become steady within the steps that are granted.
    NotSettled,
}

/// `V = 1/(1 − r²)`, the magnification without damping, with its sign. Den Hartog's response function.
#[inline]
pub fn response_function<S: Real>(ratio: S) -> S {
    S::from(1.0) / (S::from(1.0) - ratio.powi(2))
}

/// `U = tan(π/(2r))/r`, Den Hartog's damping function.
#[inline]
pub fn damping_function<S: Real>(ratio: S) -> S {
    (S::from(PI) / (ratio * 2.0)).tan() / ratio
}

/// Amplitude of the motion without stops: `X = √((F₀V/k)² − (F U/k)²)`, m, from `s = F₀/k` and `f = F/k`.
#[inline]
pub fn sliding_amplitude<S: Real>(deflection: S, offset: S, response: S, damping: S) -> S {
    ((deflection * response).powi(2) - (offset * damping).powi(2)).sqrt()
}

/// Amplitude by equivalent viscous damping: `X = (F₀/k) √(1 − (4F/(πF₀))²)/|1 − r²|`, m.
/// Rao, *Mechanical Vibrations*, 5th ed., §3.8.
#[inline]
pub fn equivalent_amplitude<S: Real>(deflection: S, offset: S, ratio: S) -> S {
    (deflection.powi(2) - (offset * 4.0 / PI).powi(2)).sqrt() / (S::from(1.0) - ratio.powi(2)).abs()
}

/// Coefficient of the viscous damping that takes the same energy in a cycle: `c = 4F/(πωX)`, N·s/m.
/// Rao, *Mechanical Vibrations*, 5th ed., §3.8.
#[inline]
pub fn equivalent_damping<S: Real>(friction: S, frequency: S, amplitude: S) -> S {
    friction * 4.0 / (frequency * amplitude * PI)
}

impl CoulombOscillator {
    /// The steady motion, exact.
    pub fn steady(&self) -> CoulombResponse {
        let Self { ratio: r, deflection: s, offset: f } = *self;
        if s <= f {
            return CoulombResponse::Stuck;
        }
        if r == 1.0 {
            if 4.0 * f < PI * s {
                return CoulombResponse::Unbounded;
            }
        } else if let Some((amplitude, lag)) = self.sliding() {
            return CoulombResponse::Sliding { amplitude, lag };
        }
        self.stopping()
    }

    /// Amplitude and lag of the motion without stops, where there is one.
    pub fn sliding(&self) -> Option<(f64, f64)> {
        let Self { ratio: r, deflection: s, offset: f } = *self;
        let (q, u) = (s * response_function(r), damping_function(r));
        let square = q * q - (f * u).powi(2);
        // The turning point must be left at once: the spring and the inertia outweigh friction.
        let x = square.sqrt();
        if !(square > 0.0 && x * r * r >= f) {
            return None;
        }
        // From the extreme +X down to −X, in 0 ≤ τ ≤ π/r, the velocity must stay negative.
        let (phase, tangent) = (self.phase(), r * u);
        let velocity = |tau: f64| f * (tau.sin() - tangent * tau.cos()) - q * r * (r * tau + phase).sin();
        let samples = 96 * (1.0 / r).ceil().min(20.0) as u32;
        let moving = (1..samples).all(|n| velocity(PI / r * f64::from(n) / f64::from(samples)) <= 1e-12 * s);
        moving.then(|| (x, phase.rem_euclid(TAU)))
    }

    /// Displacement of the sliding motion at a part of its half cycle, 0 at `+X` and 1 at `−X`.
    pub fn sliding_at(&self, part: f64) -> f64 {
        let Self { ratio: r, deflection: s, offset: f } = *self;
        let (q, tau) = (s * response_function(r), PI / r * part);
        f * (1.0 - tau.cos() - r * damping_function(r) * tau.sin()) + q * (r * tau + self.phase()).cos()
    }

    /// Angle by which the force is ahead of the extreme `+X` of the sliding motion, rad: `Q cos φ = X` and
    /// `Q sin φ = −f U`, with `Q = s V`.
    fn phase(&self) -> f64 {
        let Self { ratio: r, deflection: s, offset: f } = *self;
        let (q, u) = (s * response_function(r), damping_function(r));
        let sine = -f * u / q;
        sine.atan2((1.0 - sine * sine).max(0.0).sqrt().copysign(q))
    }

    /// Follows the motion with stops until a cycle repeats the one before.
    fn stopping(&self) -> CoulombResponse {
        let Self { ratio: r, deflection: s, offset: f } = *self;
        let force = |tau: f64| s * (r * tau).cos();
        let cycle = TAU / r;
        let mut pieces = 0u32;
        let (mut tau, mut x) = (0.0, 0.0);
        let mut before = [f64::NAN; 2];
        let mut slides: Vec<Slide> = Vec::new();
        for n in 1..=400u32 {
            slides.clear();
            let (mut least, mut most) = (x, x);
            while tau < cycle {
                pieces += 1;
                if pieces > 4000 {
                    return CoulombResponse::NotSettled;
                }
                let pull = force(tau) - x;
                // At rest at (tau, x): does it move on at once, or stay until the force has changed enough?
                let direction = if pull.abs() > f * (1.0 + 1e-12) {
                    pull.signum()
                } else {
                    let Some((leave, direction)) = self.leaves(x, tau) else { return CoulombResponse::Stuck };
                    tau = leave;
                    direction
                };
                if tau >= cycle {
                    break;
                }
                let Some((at, to)) = self.slide(x, tau, direction) else {
                    return CoulombResponse::NotSettled;
                };
                slides.push(Slide { from: tau, start: x, direction, until: at, end: to });
                (tau, x) = (at, to);
                (least, most) = (least.min(x), most.max(x));
            }
            if [least, most].iter().zip(before).all(|(now, then)| (now - then).abs() <= 1e-12 * s) {
                return CoulombResponse::Stopping { amplitude: (most - least) / 2.0, slides };
            }
            before = [least, most];
            // Time is counted from the beginning of the cycle, so that its rounding does not grow.
            tau -= cycle;
            // Close to the largest friction that lets the mass move, a motion gains on its limit by ever smaller shares.
            if n >= 40
                && let Some(steady) = self.two_stops(-least, most)
            {
                return steady;
            }
        }
        CoulombResponse::NotSettled
    }

    /// The motion that rests once at each extreme, a slide's end being the opposite of its start: the fixed point of the
    /// half cycle near its last two extremes, m. `None` where there is no such motion.
    fn two_stops(&self, one: f64, other: f64) -> Option<CoulombResponse> {
        let Self { ratio: r, deflection: s, offset: f } = *self;
        let up = |x: f64| {
            let from = -((f - x) / s).acos() / r;
            let (until, end) = self.slide(-x, from, 1.0)?;
            Some(Slide { from, start: -x, direction: 1.0, until, end })
        };
        let gain = |x: f64| up(x).map_or(f64::NAN, |slide| slide.end - x);
        let [mut low, mut high] = [one.min(other), one.max(other)];
        let mut step = (high - low).max(1e-9 * s);
        while gain(low) < 0.0 {
            low -= step;
            step *= 2.0;
        }
        while gain(high) > 0.0 {
            high += step;
            step *= 2.0;
        }
        let found = roots::find(gain, [low, high], |_| ControlFlow::Continue(())).ok()?;
        let up = up(found)?;
        let half = PI / r;
        let rests = up.until <= up.from + half;
        let down = Slide {
            from: up.from + half,
            start: up.end,
            direction: -1.0,
            until: up.until + half,
            end: -up.end,
        };
        rests.then(|| CoulombResponse::Stopping { amplitude: found, slides: vec![up, down] })
    }

    /// Time and direction in which a mass at rest at `x` since `from` begins to slip.
    fn leaves(&self, x: f64, from: f64) -> Option<(f64, f64)> {
        let Self { ratio: r, deflection: s, offset: f } = *self;
        let next = |direction: f64| {
            // s cos rτ − x passes direction·f outward.
            let level = (x + direction * f) / s;
            if level.abs() > 1.0 {
                return None;
            }
            // cos rises through a level at −arccos, falls at +arccos.
            let angle = -direction * level.acos();
            // One that is reached just now is not passed.
            let turns = ((r * from - angle) / TAU - 1e-13).ceil();
            Some(((angle + TAU * turns).max(r * from) / r, direction))
        };
        [next(1.0), next(-1.0)].into_iter().flatten().min_by(|a, b| a.0.total_cmp(&b.0))
    }

    /// Displacement and velocity (over `τ`) in a slide: free vibration about the offset from the start at rest, and the
    /// response to the force, `(cos rt − cos t)/(1 − r²)` and `(sin rt − r sin t)/(1 − r²)` written so that nothing
    /// cancels near resonance.
    pub fn sliding_from(&self, slide: &Slide, tau: f64) -> [f64; 2] {
        let Self { ratio: r, deflection: s, offset: f } = *self;
        let t = tau - slide.from;
        let detuning = 1.0 - r;
        // sin((1 − r)t/2) over (1 − r)/2
        let beat = if detuning == 0.0 { t } else { 2.0 * (detuning * t / 2.0).sin() / detuning };
        let [mean_sine, mean_cosine] = [((1.0 + r) * t / 2.0).sin(), ((1.0 + r) * t / 2.0).cos()];
        let cosine = mean_sine * beat / (1.0 + r);
        let cosine_rate = (mean_cosine * beat + (r * t).sin()) / (1.0 + r);
        let sine = (t.sin() - mean_cosine * beat) / (1.0 + r);
        let sine_rate = r * cosine;
        let [in_phase, quadrature] = [s * (r * slide.from).cos(), -s * (r * slide.from).sin()];
        let centre = -slide.direction * f;
        let away = slide.start - centre;
        [
            centre + away * t.cos() + in_phase * cosine + quadrature * sine,
            in_phase * cosine_rate + quadrature * sine_rate - away * t.sin(),
        ]
    }

    /// Work of the force in a slide over `k`, m², by summation of `s cos rτ` along the way.
    pub fn work(&self, slide: &Slide) -> f64 {
        let power = |tau: f64| self.deflection * (self.ratio * tau).cos() * self.sliding_from(slide, tau)[1];
        simpson(power, slide.from, slide.until)
    }

    /// Work of the force in a cycle of the motion without stops over `k`, m², by summation.
    pub fn sliding_work(&self) -> f64 {
        let Self { ratio: r, deflection: s, offset: f } = *self;
        let (q, u, phase) = (s * response_function(r), damping_function(r), self.phase());
        let velocity = |tau: f64| f * (tau.sin() - r * u * tau.cos()) - q * r * (r * tau + phase).sin();
        2.0 * simpson(|tau| s * (r * tau + phase).cos() * velocity(tau), 0.0, PI / r)
    }

    /// The slide from rest at `(from, x)`: when and where it comes to rest. `None` where it takes too long.
    fn slide(&self, x: f64, from: f64, direction: f64) -> Option<(f64, f64)> {
        let slide = Slide { from, start: x, direction, until: from, end: x };
        let at = |t: f64| self.sliding_from(&slide, from + t);
        let velocity = |t: f64| at(t)[1] * direction;
        let step = 0.05 * 1.0f64.min(1.0 / self.ratio);
        let mut moving = step;
        while velocity(moving) <= 0.0 {
            // Shorter than a step.
            moving /= 2.0;
            if moving < 1e-9 * step {
                return Some((from + moving, x));
            }
        }
        for n in 1..4000u16 {
            let t = step * f64::from(n);
            if t > moving && velocity(t) <= 0.0 {
                let t = roots::find(velocity, [moving, t], |_| ControlFlow::Continue(())).ok()?;
                return Some((from + t, at(t)[0]));
            }
            moving = moving.max(t);
        }
        None
    }
}

/// Simpson's rule with 2000 panels.
fn simpson(function: impl Fn(f64) -> f64, from: f64, to: f64) -> f64 {
    let panels = 2000u32;
    let h = (to - from) / f64::from(panels);
    let weight = |i: u32| {
        if i == 0 || i == panels {
            1.0
        } else if i % 2 == 1 {
            4.0
        } else {
            2.0
        }
    };
    (0..=panels).map(|i| weight(i) * function(from + h * f64::from(i))).sum::<f64>() * h / 3.0
}
