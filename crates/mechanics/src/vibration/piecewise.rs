//! Undamped free vibration on a spring of two slopes, symmetric about rest: exact, piece by piece.
//!
//! `F(x) = k₁ x` up to the corner `|x| = y`, `F = k₁ y + k₂ (|x| − y)` beyond. `k₁ = 0` is a gap, `k₂ = 0` a spring that
//! saturates, `k₂ > k₁` a stop.

use std::f64::consts::{FRAC_PI_2, TAU};

/// A spring of two slopes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TwoSlopes {
    /// Stiffness `k₁ ≥ 0` up to the corner, N/m.
    pub first: f64,
    /// Displacement at which the stiffness changes, `y > 0`, m.
    pub corner: f64,
    /// Stiffness `k₂ ≥ 0` beyond it, N/m.
    pub second: f64,
}

impl TwoSlopes {
    /// Force that holds the spring at `x`, N.
    pub fn force(&self, x: f64) -> f64 {
        let beyond = (x.abs() - self.corner).max(0.0);
        x.signum() * (self.first * x.abs().min(self.corner) + self.second * beyond)
    }

    /// Energy stored at `x`, J: `½ k₁ x²`, and beyond the corner `½ k₁ y² + k₁ y d + ½ k₂ d²` with `d = |x| − y`.
    pub fn energy(&self, x: f64) -> f64 {
        let (inside, beyond) = (x.abs().min(self.corner), (x.abs() - self.corner).max(0.0));
        (self.first / 2.0 * inside)
            .mul_add(inside, (self.first * self.corner + self.second / 2.0 * beyond) * beyond)
    }

    /// Amplitude at the energy `½ m v² + V`; infinite where no restoring force limits it.
    pub fn amplitude(&self, energy: f64) -> f64 {
        let beyond = energy - self.energy(self.corner);
        if beyond <= 0.0 {
            return if energy == 0.0 { 0.0 } else { (2.0 * energy / self.first).sqrt().min(self.corner) };
        }
        // k₂/2 d² + k₁ y d = rest, solved without cancellation.
        let held = self.first * self.corner;
        self.corner + 2.0 * beyond / (held + held.hypot((2.0 * self.second * beyond).sqrt()))
    }

    /// Period of the free vibration of a mass between `−amplitude` and `amplitude`, s.
    pub fn period(&self, mass: f64, amplitude: f64) -> f64 {
        if amplitude <= self.corner {
            return TAU * (mass / self.first).sqrt();
        }
        4.0 * (self.time_inside(mass, amplitude) + self.time_beyond(mass, amplitude))
    }

    /// Displacement at `time` after passing rest with the speed that leads to `amplitude`, m.
    pub fn displacement(&self, mass: f64, amplitude: f64, time: f64) -> f64 {
        let quarter = self.period(mass, amplitude) / 4.0;
        let phase = (time / quarter).rem_euclid(4.0);
        let sign = if phase < 2.0 { 1.0 } else { -1.0 };
        let phase = phase % 2.0;
        let since = quarter * if phase > 1.0 { 2.0 - phase } else { phase };
        if amplitude <= self.corner {
            return sign * amplitude * (since / quarter * FRAC_PI_2).sin();
        }
        let before = self.time_inside(mass, amplitude);
        if since <= before {
            let speed = (2.0 * self.energy(amplitude) / mass).sqrt();
            let turn = (self.first / mass).sqrt();
            return sign * if turn == 0.0 { speed * since } else { speed / turn * (turn * since).sin() };
        }
        // Counted back from the turning point.
        let left = quarter - since;
        let fallen = if self.second == 0.0 {
            self.first * self.corner / mass * left * left / 2.0
        } else {
            let centre = self.corner - self.first * self.corner / self.second;
            (amplitude - centre) * (1.0 - ((self.second / mass).sqrt() * left).cos())
        };
        sign * (amplitude - fallen)
    }

    /// Time from rest to the corner.
    fn time_inside(&self, mass: f64, amplitude: f64) -> f64 {
        let speed = (2.0 * self.energy(amplitude) / mass).sqrt();
        let turn = (self.first / mass).sqrt();
        if turn == 0.0 { self.corner / speed } else { (turn * self.corner / speed).min(1.0).asin() / turn }
    }

    /// Time from the corner to the turning point.
    fn time_beyond(&self, mass: f64, amplitude: f64) -> f64 {
        let at_corner = (2.0 * (self.energy(amplitude) - self.energy(self.corner)) / mass).max(0.0).sqrt();
        let pull = self.first * self.corner / mass;
        let turn = (self.second / mass).sqrt();
        if turn == 0.0 { at_corner / pull } else { (turn * at_corner).atan2(pull) / turn }
    }
}
