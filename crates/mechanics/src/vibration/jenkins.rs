//! An elastic dry-friction element (Jenkins: a spring in series with a slider) by one harmonic.
//!
//! The element, with stiffness `k_d` and slip force `F_d`, stands beside a spring `k` and a damper `c`. Under
//! `x = X cos ωt` it sticks while `X ≤ x_y = F_d/k_d`. Beyond, its force runs round a parallelogram whose first
//! harmonic is a stiffness `k_j` and a part `h` in quadrature; a motion of one
//! harmonic is then that of a linear oscillator with the stiffness `k + k_j` and the damping force `c ω + h` for each
//! unit of amplitude (harmonic balance).

use std::{f64::consts::PI, ops::ControlFlow};

use crate::Real;
use dalembert_numerics::roots;

/// An oscillator with a Jenkins element, under `F₀ cos ωt`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct JenkinsOscillator {
    /// Mass, kg.
    pub mass: f64,
    /// Viscous damping, N·s/m; may be zero.
    pub damping: f64,
    /// Stiffness beside the element, N/m.
    pub stiffness: f64,
    /// Stiffness of the element, N/m.
    pub element: f64,
    /// Force at which the element slips, N.
    pub slip_force: f64,
    /// Amplitude of the exciting force, N.
    pub force: f64,
}

/// A point of the response curve.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ResponsePoint {
    /// Frequency, rad/s.
    pub frequency: f64,
    /// Amplitude, m.
    pub amplitude: f64,
}

/// Angle over which the element is elastic in each half cycle: `θ = arccos(1 − 2x_y/X)`, rad, for `X ≥ x_y`.
#[inline]
pub fn elastic_angle<S: Real>(slip_displacement: S, amplitude: S) -> S {
    (S::from(1.0) - slip_displacement * 2.0 / amplitude).acos()
}

/// Equivalent stiffness of the slipping element: `k_j = (k_d/π)(θ − sin θ cos θ)`, N/m.
#[inline]
pub fn equivalent_stiffness<S: Real>(element: S, elastic_angle: S) -> S {
    element / PI * (elastic_angle - elastic_angle.sin() * elastic_angle.cos())
}

/// Energy that the slipping element takes in a cycle: the area `4F_d(X − x_y)` of its loop, J.
#[inline]
pub fn loop_area<S: Real>(slip_force: S, amplitude: S, slip_displacement: S) -> S {
    slip_force * 4.0 * (amplitude - slip_displacement)
}

/// The part in quadrature of the first harmonic of a loop of area `W`: `h = W/(πX²)`, N/m.
#[inline]
pub fn quadrature_stiffness<S: Real>(loop_area: S, amplitude: S) -> S {
    loop_area / (amplitude.powi(2) * PI)
}

impl JenkinsOscillator {
    /// Displacement at which the element begins to slip, m.
    pub fn slip_displacement(&self) -> f64 {
        self.slip_force / self.element
    }

    /// Stiffness of spring and element, and the part of the element in quadrature, N/m, at an amplitude.
    pub fn harmonic(&self, amplitude: f64) -> [f64; 2] {
        let slip = self.slip_displacement();
        if amplitude <= slip {
            return [self.stiffness + self.element, 0.0];
        }
        let angle = elastic_angle(slip, amplitude);
        let area = loop_area(self.slip_force, amplitude, slip);
        [self.stiffness + equivalent_stiffness(self.element, angle), quadrature_stiffness(area, amplitude)]
    }

    /// First harmonic of the force of the element by summing over one turn of its loop: `[k_j, h]` in N/m. A second
    /// way to the closed forms, good to about 1e-10.
    pub fn harmonic_by_summation(&self, amplitude: f64) -> [f64; 2] {
        let slip = self.slip_displacement();
        if amplitude <= slip {
            return [self.element, 0.0];
        }
        // On the way down from +X: elastic to θ, then slipping. The way up mirrors it.
        let angle = elastic_angle(slip, amplitude);
        let force = |psi: f64| {
            if psi <= angle {
                self.slip_force - self.element * amplitude * (1.0 - psi.cos())
            } else {
                -self.slip_force
            }
        };
        let panel = |from: f64, to: f64| {
            // Simpson's rule on each smooth part.
            let n = 400u32;
            let h = (to - from) / f64::from(n);
            let mut sums = [0.0; 2];
            for i in 0..=n {
                let weight = if i == 0 || i == n {
                    1.0
                } else if i % 2 == 1 {
                    4.0
                } else {
                    2.0
                };
                // The end of the elastic part belongs to both parts, and the force is continuous there.
                let psi = from + h * f64::from(i);
                let value = force(psi) * weight * h / 3.0;
                sums[0] += value * psi.cos();
                sums[1] -= value * psi.sin();
            }
            sums
        };
        let (elastic, slipping) = (panel(0.0, angle), panel(angle, PI));
        [0, 1].map(|part| 2.0 * (elastic[part] + slipping[part]) / (PI * amplitude))
    }

    /// `|(K − mω²) + i(cω + h)|`, N/m.
    pub fn dynamic_stiffness(&self, frequency: f64, amplitude: f64) -> f64 {
        let [k, h] = self.harmonic(amplitude);
        (k - self.mass * frequency * frequency).hypot(self.damping * frequency + h)
    }

    /// All amplitudes of the single-harmonic response at a frequency, ascending.
    pub fn amplitudes(&self, frequency: f64) -> Vec<f64> {
        self.amplitudes_where(|amplitude| self.dynamic_stiffness(frequency, amplitude))
    }

    /// The peak of the response over all frequencies; `None` where the force outweighs slip and damping, so that
    /// the amplitude has no bound.
    pub fn peak(&self) -> Option<ResponsePoint> {
        let least = |amplitude: f64| {
            if self.damping == 0.0 {
                // At √(K/m) exactly nothing but the element holds the force.
                return self.harmonic(amplitude)[1];
            }
            let frequency = self.softest_frequency(amplitude);
            self.dynamic_stiffness(frequency, amplitude)
        };
        let amplitude = self.amplitudes_where(least).pop()?;
        Some(ResponsePoint { frequency: self.softest_frequency(amplitude), amplitude })
    }

    /// The frequency at which a motion of that amplitude takes the least force: the root of
    /// `2m²ω³ − 2mKω + c²ω + ch = 0` nearest to `√(K/m)`, or zero where damping leaves none.
    pub fn softest_frequency(&self, amplitude: f64) -> f64 {
        let [k, h] = self.harmonic(amplitude);
        let (m, c) = (self.mass, self.damping);
        let natural = (k / m).sqrt();
        // In units of ω_n: g(y) = y³ − (1 − 2ζ²)y + ζη, ζ = c/(2√(km)), η = h/k.
        let (zeta, eta) = (c / (2.0 * (k * m).sqrt()), h / k);
        let slope_zero = ((1.0 - 2.0 * zeta * zeta) / 3.0).max(0.0).sqrt();
        let g = |y: f64| y * y * y - (1.0 - 2.0 * zeta * zeta) * y + zeta * eta;
        let root = if slope_zero < 1.0 && g(slope_zero) < 0.0 {
            roots::find(g, [slope_zero, 1.0], |_| ControlFlow::Continue(())).unwrap_or(1.0)
        } else {
            0.0
        };
        if c == 0.0 { natural } else { natural * root }
    }

    /// The amplitudes `X` with `X·stiffness(X) = F₀`.
    fn amplitudes_where(&self, stiffness: impl Fn(f64) -> f64) -> Vec<f64> {
        let slip = self.slip_displacement();
        let residual = |amplitude: f64| amplitude * stiffness(amplitude) / self.force - 1.0;
        // Sticking, the response is linear; slipping, it lies above x_y: a scan in equal ratios up to 10⁶ x_y.
        let mut found = Vec::new();
        let stuck = self.force / stiffness(slip);
        if stuck <= slip {
            found.push(stuck);
        }
        let (decades, steps) = (6.0, 240u32);
        let at = |n: u32| slip * 10f64.powf(decades * f64::from(n) / f64::from(steps));
        let mut before = residual(slip);
        for n in 1..=steps {
            let value = residual(at(n));
            if (before > 0.0) != (value > 0.0)
                && let Ok(root) = roots::find(residual, [at(n - 1), at(n)], |_| ControlFlow::Continue(()))
            {
                found.push(root);
            }
            before = value;
        }
        if before < 0.0 {
            // Still short of the force at the end of the scan: far above slip the element is a constant force.
            let mut to = 10.0 * at(steps);
            for _ in 0..280 {
                if residual(to) > 0.0 {
                    let ends = [to / 10.0, to];
                    found.extend(roots::find(residual, ends, |_| ControlFlow::Continue(())).ok());
                    return found;
                }
                to *= 10.0;
            }
            return Vec::new();
        }
        found
    }
}
