//! Response from rest to a load that is itself the motion of a linear system: a sine, an exponential.

use super::UnitResponses;

/// An oscillator under a unit load `q` with `(q, p)′ = B (q, p)`, from a given `(q, p)` on.
pub(super) struct LoadedOscillator {
    ratio: f64,
    law: Unit,
}

/// The load, in time counted as `θ = ωₙτ`.
#[derive(Clone, Copy)]
enum Unit {
    /// `sin rθ`.
    Sine(f64),
    /// `cos rθ`.
    Cosine(f64),
    /// `e^(−λθ)`.
    Decay(f64),
}

/// Nearer than this to a resonance the particular solution would lose more than three digits.
const NEAR: f64 = 1e-3;

type Matrix = [[f64; 4]; 4];

impl LoadedOscillator {
    pub(super) fn sine(ratio: f64, frequency: f64) -> Self {
        Self { ratio, law: Unit::Sine(frequency) }
    }

    pub(super) fn cosine(ratio: f64, frequency: f64) -> Self {
        Self { ratio, law: Unit::Cosine(frequency) }
    }

    pub(super) fn decay(ratio: f64, rate: f64) -> Self {
        Self { ratio, law: Unit::Decay(rate) }
    }

    /// Displacement and its rate at `θ`; `unit` holds the unit responses there.
    pub(super) fn response(&self, unit: &UnitResponses, theta: f64) -> [f64; 2] {
        let fastest = match self.law {
            Unit::Sine(frequency) | Unit::Cosine(frequency) => frequency,
            Unit::Decay(rate) => rate,
        };
        if theta * fastest.max(1.0).max(2.0 * self.ratio) < 1.0 {
            return self.short(theta);
        }
        self.particular(unit, theta).unwrap_or_else(|| self.doubled(theta))
    }

    /// Particular solution and the free motion that takes away its start.
    fn particular(&self, unit: &UnitResponses, theta: f64) -> Option<[f64; 2]> {
        let zeta = self.ratio;
        let ([x, rate], [x0, rate0]) = match self.law {
            Unit::Sine(r) | Unit::Cosine(r) => {
                let (detuning, damping) = (1.0 - r * r, 2.0 * zeta * r);
                let size = detuning * detuning + damping * damping;
                if detuning.abs() + damping < NEAR * (1.0 + r * r) {
                    return None;
                }
                let (sin, cos) = (r * theta).sin_cos();
                let (a, b) = match self.law {
                    Unit::Cosine(_) => (damping / size, detuning / size),
                    _ => (detuning / size, -damping / size),
                };
                ([a * sin + b * cos, r * (a * cos - b * sin)], [b, r * a])
            }
            Unit::Decay(rate) => {
                let size = (rate - 2.0 * zeta) * rate + 1.0;
                if size.abs() < NEAR * (1.0 + 2.0 * zeta * rate + rate * rate) {
                    return None;
                }
                let decay = (-rate * theta).exp() / size;
                ([decay, -rate * decay], [1.0 / size, -rate / size])
            }
        };
        Some([
            x - unit.release * x0 - unit.impulse * rate0,
            rate + unit.impulse * x0 - unit.impulse_rate * rate0,
        ])
    }

    /// The power series of the motion, `xₙ₊₂ = qₙ − 2ζxₙ₊₁ − xₙ` in derivatives at the start.
    fn short(&self, theta: f64) -> [f64; 2] {
        // The load and its next derivative.
        let (mut load, mut next) = match self.law {
            Unit::Sine(frequency) => (0.0, frequency),
            Unit::Cosine(_) => (1.0, 0.0),
            Unit::Decay(rate) => (1.0, -rate),
        };
        let (mut now, mut after) = (0.0, 0.0);
        let (mut x, mut rate) = (0.0, 0.0);
        // θⁿ⁺¹/(n + 1)!
        let mut power = theta;
        for n in 0..26 {
            let second = load - 2.0 * self.ratio * after - now;
            rate += second * power;
            power *= theta / f64::from(n + 2);
            x += second * power;
            (now, after) = (after, second);
            (load, next) = match self.law {
                Unit::Sine(frequency) | Unit::Cosine(frequency) => (next, -frequency * frequency * load),
                Unit::Decay(decay) => (next, -decay * next),
            };
        }
        [x, rate]
    }

    /// The exponential of the joint system by a power series and doublings: no resonance, no cancellation.
    fn doubled(&self, theta: f64) -> [f64; 2] {
        let zeta = self.ratio;
        let (system, load): (Matrix, [f64; 2]) = match self.law {
            Unit::Sine(r) | Unit::Cosine(r) => (
                [
                    [0.0, 1.0, 0.0, 0.0],
                    [-1.0, -2.0 * zeta, 1.0, 0.0],
                    [0.0, 0.0, 0.0, r],
                    [0.0, 0.0, -r, 0.0],
                ],
                if matches!(self.law, Unit::Cosine(_)) { [1.0, 0.0] } else { [0.0, 1.0] },
            ),
            Unit::Decay(rate) => (
                [[0.0, 1.0, 0.0, 0.0], [-1.0, -2.0 * zeta, 1.0, 0.0], [0.0, 0.0, -rate, 0.0], [0.0; 4]],
                [1.0, 0.0],
            ),
        };
        let norm = system.iter().flatten().fold(0.0, |norm: f64, entry| norm.max(entry.abs()));
        let doublings = (norm * theta * 4.0).log2().ceil().clamp(0.0, 60.0);
        let step = theta / doublings.exp2();
        let mut sum: Matrix = std::array::from_fn(|i| std::array::from_fn(|j| f64::from(u8::from(i == j))));
        let mut term = sum;
        for n in 1..24 {
            term = times(&term, &system).map(|row| row.map(|entry| entry * step / f64::from(n)));
            for (sum, term) in sum.iter_mut().flatten().zip(term.iter().flatten()) {
                *sum += term;
            }
        }
        for _ in 0..doublings as usize {
            sum = times(&sum, &sum);
        }
        [0, 1].map(|i| sum[i][2] * load[0] + sum[i][3] * load[1])
    }
}

/// Displacement at `θ` under the load `θ²/2` from rest; its rate is the response to the ramp.
pub(super) fn parabola(ratio: f64, unit: &UnitResponses, theta: f64) -> f64 {
    if theta * f64::max(1.0, 2.0 * ratio) >= 1.0 {
        return theta * theta / 2.0 - 2.0 * ratio * (theta - unit.impulse)
            + (4.0 * ratio * ratio - 1.0) * unit.step;
    }
    // Σ cₙθⁿ/n! with c₄ = 1 and cₙ₊₂ = −2ζcₙ₊₁ − cₙ.
    let mut power = theta.powi(4) / 24.0;
    let (mut before, mut now, mut sum) = (0.0, 1.0, 0.0);
    for n in 5..30 {
        sum += now * power;
        power *= theta / f64::from(n);
        (before, now) = (now, -2.0 * ratio * now - before);
    }
    sum
}

fn times(a: &Matrix, b: &Matrix) -> Matrix {
    std::array::from_fn(|i| std::array::from_fn(|j| (0..4).map(|k| a[i][k] * b[k][j]).sum()))
}
