//! Free vibration `ẍ + 2ζω_n ẋ + ω_n² x = 0`: one formula for every damping ratio, negative ones included.
//!
//! With `ω_d = ω_n √(1 − ζ²)`, `C(t) = e^(−ζω_n t) cos ω_d t` and `S(t) = e^(−ζω_n t) sin(ω_d t)/ω_d`,
//! `x = x₀ C + (v₀ + ζω_n x₀) S` and `v = v₀ C − (ω_n² x₀ + ζω_n v₀) S`. Above `ζ = 1` the circular functions turn
//! into hyperbolic ones, and at `ζ = 1` `S = t e^(−ω_n t)`: the three regimes of textbooks (Rao, *Mechanical
//! Vibrations*, 5th ed., §2.6) are one function that is smooth through `ζ = 1`.

use std::{f64::consts::PI, ops::ControlFlow};

use dalembert_numerics::roots;

/// A free vibration. Displacements may be lengths or angles.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FreeMotion {
    /// Undamped natural frequency `ω_n`, rad/s; positive.
    pub natural_frequency: f64,
    /// Damping ratio `ζ`; any.
    pub damping_ratio: f64,
    /// Displacement at the start.
    pub displacement: f64,
    /// Velocity at the start.
    pub velocity: f64,
}

impl FreeMotion {
    /// Displacement, velocity and acceleration at a time `t ≥ 0`.
    pub fn state(&self, time: f64) -> [f64; 3] {
        let (w, z, x0, v0) = (self.natural_frequency, self.damping_ratio, self.displacement, self.velocity);
        let (c, s) = self.basis(time);
        let x = x0 * c + (v0 + z * w * x0) * s;
        let v = v0 * c - (w * w * x0 + z * w * v0) * s;
        [x, v, -w * w * x - 2.0 * z * w * v]
    }

    /// Size of the damped frequency, `ω_n √|1 − ζ²|`, rad/s.
    pub fn damped_frequency(&self) -> f64 {
        self.natural_frequency * ((1.0 - self.damping_ratio) * (1.0 + self.damping_ratio)).abs().sqrt()
    }

    /// The first time after the start at which the displacement is zero.
    pub fn first_zero(&self) -> Option<f64> {
        let (w, z) = (self.natural_frequency, self.damping_ratio);
        self.first_zero_of(self.displacement, self.velocity + z * w * self.displacement)
    }

    /// The first time after the start at which the velocity is zero.
    pub fn first_turning(&self) -> Option<f64> {
        let (w, z) = (self.natural_frequency, self.damping_ratio);
        self.first_zero_of(self.velocity, -(w * w * self.displacement + z * w * self.velocity))
    }

    /// The time after which the displacement stays within `±level`; zero where it never leaves it, `None` without
    /// positive damping.
    pub fn settling_time(&self, level: f64) -> Option<f64> {
        if !(self.damping_ratio > 0.0 && level > 0.0) {
            return None;
        }
        let at = |time: f64| self.state(time)[0];
        let first = self.first_turning().unwrap_or(0.0);
        let turned = at(first);
        if turned.abs() <= level {
            return Some(if at(0.0).abs() > level { self.crossing(level, 0.0, first) } else { 0.0 });
        }
        if self.damping_ratio < 1.0 {
            let half = PI / self.damped_frequency();
            let log_decay = self.damping_ratio * self.natural_frequency * half;
            let last = ((turned.abs() / level).ln() / log_decay).floor();
            let from = first + last * half;
            return Some(self.crossing(level, from, from + half));
        }
        let mut step = self.damping_ratio / self.natural_frequency;
        for _ in 0..1100 {
            if at(first + step).abs() < level {
                return Some(self.crossing(level, first, first + step));
            }
            step *= 2.0;
        }
        None
    }

    /// Displacement and velocity by Taylor series of the equation of motion, step by step: a way that knows of no
    /// regimes. `None` where it would take more than 4000 steps.
    pub fn integrated(&self, time: f64) -> Option<[f64; 2]> {
        let (w, z) = (self.natural_frequency, self.damping_ratio);
        let steps = (w * time * (1.0 + 2.0 * z.abs())).ceil().max(1.0);
        if steps.is_nan() || steps > 4000.0 {
            return None;
        }
        let h = time / steps;
        let (mut x, mut v) = (self.displacement, self.velocity);
        let mut step = 0.0;
        while step < steps {
            // Terms x⁽ⁿ⁾hⁿ/n! and x⁽ⁿ⁺¹⁾hⁿ/n!.
            let (mut x_term, mut v_term) = (x, v);
            for n in 1..26 {
                let part = h / f64::from(n);
                (x_term, v_term) = (v_term * part, -(w * w * x_term + 2.0 * z * w * v_term) * part);
                x += x_term;
                v += v_term;
            }
            step += 1.0;
        }
        Some([x, v])
    }

    /// `C(t)` and `S(t)`.
    fn basis(&self, time: f64) -> (f64, f64) {
        let (w, z) = (self.natural_frequency, self.damping_ratio);
        let q = self.damped_frequency();
        let angle = q * time;
        if z.abs() < 1.0 {
            let decay = (-z * w * time).exp();
            (decay * angle.cos(), if angle == 0.0 { decay * time } else { decay * angle.sin() / q })
        } else if angle < 1.0 {
            let decay = (-z * w * time).exp();
            (decay * angle.cosh(), if angle == 0.0 { decay * time } else { decay * angle.sinh() / q })
        } else {
            // Without the cancellation of −ζω_n + ω_n √(ζ² − 1).
            let far = -w * (z + z.signum() * ((z - 1.0) * (z + 1.0)).sqrt());
            let near = w * w / far;
            let (slow, fast) = ((near * time).exp(), (far * time).exp());
            (f64::midpoint(slow, fast), (slow - fast) / (near - far))
        }
    }

    /// The first `t > 0` at which `a C(t) + b S(t)` is zero.
    fn first_zero_of(&self, a: f64, b: f64) -> Option<f64> {
        if a == 0.0 && b == 0.0 {
            return None;
        }
        let q = self.damped_frequency();
        let time = if q == 0.0 {
            -a / b
        } else if self.damping_ratio.abs() < 1.0 {
            // A small angle keeps its digits, as it would not as the rest of a half turn.
            let angle = (-a * q / b).atan();
            if angle > 0.0 { angle / q } else { (angle + PI) / q }
        } else {
            let tanh = -a * q / b;
            if tanh < 1.0 { tanh.atanh() / q } else { return None }
        };
        (time.is_finite() && time > 0.0).then_some(time)
    }

    /// Time at which the motion, monotonic between two times, crosses `±level` on the side it comes from.
    fn crossing(&self, level: f64, from: f64, to: f64) -> f64 {
        let signed = level.copysign(self.state(from)[0]);
        roots::find(|time| self.state(time)[0] - signed, [from, to], |_| ControlFlow::Continue(()))
            .unwrap_or(from)
    }
}
