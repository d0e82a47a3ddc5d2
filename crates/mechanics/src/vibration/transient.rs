//! Response of one degree of freedom to any load made of straight, parabolic, sinusoidal and exponential pieces, exactly.
//!
//! `ẍ + 2ζωₙẋ + ωₙ²x = ωₙ²q(t)`, where `q` is the displacement that the load would hold statically: `F(t)/k` for a
//! force on the mass, `−ÿ(t)/ωₙ²` for the displacement relative to a base that accelerates by `ÿ(t)`. Over each piece
//! the motion is known in closed form, so that a step of any length has no error but rounding, for every `ζ ≥ 0`
//! (Clough & Penzien, *Dynamics of Structures*, 2nd ed., §7-2; Chopra, *Dynamics of Structures*, §5.2).

use dalembert_numerics::roots;

pub use dalembert_numerics::extremes::{Extreme, Extremes};

pub mod closed;

mod coupled;
mod turning;
mod unit;

pub use unit::UnitResponses;

use coupled::LoadedOscillator;

/// One degree of freedom.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Oscillator {
    /// Natural frequency without damping, rad/s, positive.
    pub natural: f64,
    /// Damping ratio, zero or more.
    pub ratio: f64,
}

/// Displacement and velocity.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct OscillatorState {
    /// Displacement, m.
    pub displacement: f64,
    /// Velocity, m/s.
    pub velocity: f64,
}

/// Law of the load over a piece, as a static displacement in m; `τ` counts from the start of the piece.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum LoadLaw {
    /// `start + slope τ`.
    Line {
        /// Value at the start, m.
        start: f64,
        /// Slope, m/s.
        slope: f64,
    },
    /// `amplitude sin Ωτ`.
    Sine {
        /// Amplitude, m.
        amplitude: f64,
        /// Frequency `Ω`, rad/s.
        frequency: f64,
    },
    /// `amplitude e^(−λτ)`.
    Decay {
        /// Value at the start, m.
        amplitude: f64,
        /// Rate `λ`, 1/s.
        rate: f64,
    },
    /// `size (1 − e^(−λτ))`.
    Rise {
        /// Value that it tends to, m.
        size: f64,
        /// Rate `λ`, 1/s.
        rate: f64,
    },
    /// `size (1 − cos Ωτ)/2`.
    Versine {
        /// Largest value, m.
        size: f64,
        /// Frequency `Ω`, rad/s.
        frequency: f64,
    },
    /// `start + slope τ + bend τ²/2`.
    Parabola {
        /// Value at the start, m.
        start: f64,
        /// Slope at the start, m/s.
        slope: f64,
        /// Rate of the slope, m/s².
        bend: f64,
    },
}

/// A piece of the load: it lasts until the next one begins, the last one for ever.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LoadSegment {
    /// Start time, s.
    pub from: f64,
    /// Law of the load over the piece.
    pub law: LoadLaw,
}

/// Output to examine: `a x + b ẋ/ωₙ`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TransientOutput {
    /// Weight of the displacement.
    pub displacement: f64,
    /// Weight of the velocity over the natural frequency.
    pub velocity: f64,
}

/// Reason for which there is no motion.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum TransientError {
    /// The natural frequency is not positive, the damping ratio negative, or a number is not finite.
    #[error(
        "the natural frequency must be positive, the damping ratio zero or more, and every number finite"
    )]
    Oscillator,
    /// The pieces do not follow one another.
    #[error("the load needs pieces whose starts are zero or later and ascend; one begins at {at} s")]
    Order {
        /// Start of the offending piece, s.
        at: f64,
    },
    /// The largest value does not exist: the load rises without end.
    #[error("the load rises without end, and the motion with it")]
    Unbounded,
    /// A zero of the rate could not be found.
    #[error(transparent)]
    Root(#[from] roots::RootError),
}

/// The motion from time zero on.
#[derive(Debug, Clone, PartialEq)]
pub struct TransientMotion {
    oscillator: Oscillator,
    pieces: Vec<Started>,
}

/// A piece with the state in which it begins.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Started {
    from: f64,
    law: LoadLaw,
    state: OscillatorState,
}

impl TransientOutput {
    /// The displacement.
    pub const DISPLACEMENT: TransientOutput = TransientOutput { displacement: 1.0, velocity: 0.0 };

    /// The force of spring and damper together over the stiffness, `x + 2ζ ẋ/ωₙ`; on a excited base, the absolute
    /// acceleration over `−ωₙ²`.
    pub fn support(ratio: f64) -> TransientOutput {
        TransientOutput { displacement: 1.0, velocity: 2.0 * ratio }
    }
}

impl LoadLaw {
    /// The load `tau` seconds after the start of the piece.
    pub fn at(self, tau: f64) -> f64 {
        match self {
            LoadLaw::Line { start, slope: 0.0 } => start,
            LoadLaw::Line { start, slope } => start + slope * tau,
            LoadLaw::Sine { amplitude, frequency } => amplitude * (frequency * tau).sin(),
            LoadLaw::Decay { amplitude, rate } => amplitude * (-rate * tau).exp(),
            LoadLaw::Rise { size, rate } => -size * (-rate * tau).exp_m1(),
            LoadLaw::Versine { size, frequency } => size * (0.5 * frequency * tau).sin().powi(2),
            LoadLaw::Parabola { start, slope, bend } => start + (slope + 0.5 * bend * tau) * tau,
        }
    }

    /// The same law with its values multiplied by a factor.
    #[must_use]
    pub fn scaled(self, factor: f64) -> Self {
        match self {
            LoadLaw::Line { start, slope } => LoadLaw::Line { start: start * factor, slope: slope * factor },
            LoadLaw::Sine { amplitude, frequency } => {
                LoadLaw::Sine { amplitude: amplitude * factor, frequency }
            }
            LoadLaw::Decay { amplitude, rate } => LoadLaw::Decay { amplitude: amplitude * factor, rate },
            LoadLaw::Rise { size, rate } => LoadLaw::Rise { size: size * factor, rate },
            LoadLaw::Versine { size, frequency } => LoadLaw::Versine { size: size * factor, frequency },
            LoadLaw::Parabola { start, slope, bend } => {
                LoadLaw::Parabola { start: start * factor, slope: slope * factor, bend: bend * factor }
            }
        }
    }

    /// The fastest rate of its waves and exponentials, 1/s; zero for a polynomial.
    pub fn fastest(self) -> f64 {
        match self {
            LoadLaw::Line { .. } | LoadLaw::Parabola { .. } => 0.0,
            LoadLaw::Sine { frequency, .. } | LoadLaw::Versine { frequency, .. } => frequency,
            LoadLaw::Decay { rate, .. } | LoadLaw::Rise { rate, .. } => rate,
        }
    }
}

impl Oscillator {
    /// An oscillator, if its numbers make sense.
    pub fn new(natural: f64, ratio: f64) -> Result<Self, TransientError> {
        if natural > 0.0 && natural.is_finite() && ratio >= 0.0 && ratio.is_finite() {
            Ok(Self { natural, ratio })
        } else {
            Err(TransientError::Oscillator)
        }
    }

    /// The state `tau` seconds on under a load that begins with it.
    pub fn advance(self, state: OscillatorState, law: LoadLaw, tau: f64) -> OscillatorState {
        let theta = self.natural * tau;
        let unit = UnitResponses::at(self.ratio, theta);
        let (x, u) = (state.displacement, state.velocity / self.natural);
        let free = [unit.release * x + unit.impulse * u, unit.release_rate() * x + unit.impulse_rate * u];
        let forced = match law {
            LoadLaw::Line { start, slope: 0.0 } => [unit.step * start, unit.impulse * start],
            LoadLaw::Line { start, slope } => {
                let slope = slope / self.natural;
                [unit.step * start + unit.ramp * slope, unit.impulse * start + unit.step * slope]
            }
            LoadLaw::Sine { amplitude, frequency } => {
                LoadedOscillator::sine(self.ratio, frequency / self.natural)
                    .response(&unit, theta)
                    .map(|y| y * amplitude)
            }
            LoadLaw::Decay { amplitude, rate } => LoadedOscillator::decay(self.ratio, rate / self.natural)
                .response(&unit, theta)
                .map(|y| y * amplitude),
            LoadLaw::Rise { size, rate } => {
                let [x, u] = LoadedOscillator::decay(self.ratio, rate / self.natural).response(&unit, theta);
                [(unit.step - x) * size, (unit.impulse - u) * size]
            }
            LoadLaw::Versine { size, frequency } => {
                let cosine = LoadedOscillator::cosine(self.ratio, frequency / self.natural);
                let [x, u] = cosine.response(&unit, theta);
                [(unit.step - x) * size / 2.0, (unit.impulse - u) * size / 2.0]
            }
            LoadLaw::Parabola { start, slope, bend } => {
                let (slope, bend) = (slope / self.natural, bend / (self.natural * self.natural));
                let bent = coupled::parabola(self.ratio, &unit, theta);
                [
                    unit.step * start + unit.ramp * slope + bent * bend,
                    unit.impulse * start + unit.step * slope + unit.ramp * bend,
                ]
            }
        };
        OscillatorState { displacement: free[0] + forced[0], velocity: (free[1] + forced[1]) * self.natural }
    }
}

impl TransientMotion {
    /// The motion that begins at time zero in a state, under a load; before its first piece the load is zero.
    pub fn new(
        oscillator: Oscillator,
        initial: OscillatorState,
        load: &[LoadSegment],
    ) -> Result<Self, TransientError> {
        let Oscillator { natural, ratio } = oscillator;
        Oscillator::new(natural, ratio)?;
        let nothing = LoadSegment { from: 0.0, law: LoadLaw::Line { start: 0.0, slope: 0.0 } };
        let mut pieces = vec![Started { from: 0.0, law: nothing.law, state: initial }];
        for piece in load {
            let last = pieces.last().expect("there is a first piece");
            if !(piece.from >= last.from && piece.from.is_finite()) {
                return Err(TransientError::Order { at: piece.from });
            }
            let state = if piece.from == last.from {
                last.state
            } else {
                oscillator.advance(last.state, last.law, piece.from - last.from)
            };
            if piece.from == last.from {
                pieces.pop();
            }
            pieces.push(Started { from: piece.from, law: piece.law, state });
        }
        Ok(Self { oscillator, pieces })
    }

    /// Displacement and velocity at a time, zero or later.
    pub fn at(&self, time: f64) -> OscillatorState {
        let piece = self.piece(time);
        self.oscillator.advance(piece.state, piece.law, time - piece.from)
    }

    /// The load at a time, as a static displacement.
    pub fn load(&self, time: f64) -> f64 {
        let piece = self.piece(time);
        piece.law.at(time - piece.from)
    }

    /// Value of an output at a time.
    pub fn output(&self, output: TransientOutput, time: f64) -> f64 {
        self.value(output, self.at(time))
    }

    /// The least and the largest value of an output between two times; the second may be infinite. Extremes
    /// between the pieces' ends are found where the rate is zero, to `1e-13` of the time.
    pub fn extremes(
        &self,
        output: TransientOutput,
        [from, to]: [f64; 2],
    ) -> Result<Extremes, TransientError> {
        let mut found = Extremes::at(from, self.output(output, from));
        for (n, piece) in self.pieces.iter().enumerate() {
            let end = self.pieces.get(n + 1).map_or(f64::INFINITY, |next| next.from).min(to);
            let start = piece.from.max(from);
            if end <= start {
                continue;
            }
            let (begun, state, law) = match piece.law {
                LoadLaw::Line { start: at, slope } if start > piece.from => {
                    let by = start - piece.from;
                    let law = LoadLaw::Line { start: if slope == 0.0 { at } else { at + slope * by }, slope };
                    (start, self.oscillator.advance(piece.state, piece.law, by), law)
                }
                law => (piece.from, piece.state, law),
            };
            let last = match self.pieces.get(n + 1) {
                Some(next) if next.from == end => Some(next.state),
                _ if end.is_finite() => Some(self.oscillator.advance(state, law, end - begun)),
                _ => None,
            };
            if let LoadLaw::Line { start, slope } = law {
                let ends = [Some(state), last].map(|state| state.map(|state| self.value(output, state)));
                let [low, high] =
                    self.oscillator.line_bounds(state, [start, slope], output, end - begun, ends);
                if low >= found.least.value && high <= found.largest.value {
                    continue;
                }
            }
            for tau in self.oscillator.turning_points(state, law, output, end - begun)? {
                if begun + tau >= start {
                    let value = self.value(output, self.oscillator.advance(state, law, tau));
                    found.note(Extreme { time: begun + tau, value });
                }
            }
            if let Some(last) = last {
                found.note(Extreme { time: end, value: self.value(output, last) });
            }
        }
        Ok(found)
    }

    /// The displacement by Duhamel's integral from rest, by Gauss–Legendre quadrature: a second method to
    /// [`TransientMotion::at`]. `None` where it would take too many points, or the motion does not begin at rest.
    /// Clough & Penzien, 2nd ed., §7-1.
    pub fn duhamel(&self, time: f64) -> Option<f64> {
        let first = self.pieces.first()?.state;
        if first != OscillatorState::default() {
            return None;
        }
        let Oscillator { natural, ratio } = self.oscillator;
        let mut sum = 0.0;
        for (n, piece) in self.pieces.iter().enumerate() {
            let end = self.pieces.get(n + 1).map_or(time, |next| next.from).min(time);
            if end <= piece.from {
                continue;
            }
            let fastest = piece.law.fastest();
            let panels = ((end - piece.from) * (natural * (1.0 + 2.0 * ratio) + fastest)).ceil().max(1.0);
            if panels > 300.0 {
                return None;
            }
            let width = (end - piece.from) / panels;
            for panel in 0..panels as usize {
                let middle = piece.from + width * (panel as f64 + 0.5);
                for (node, weight) in GAUSS_8 {
                    for node in [-node, node] {
                        let at = middle + 0.5 * width * node;
                        let impulse = UnitResponses::at(ratio, natural * (time - at)).impulse;
                        sum += 0.5 * width * weight * natural * impulse * piece.law.at(at - piece.from);
                    }
                }
            }
        }
        Some(sum)
    }

    fn piece(&self, time: f64) -> Started {
        let after = self.pieces.partition_point(|piece| piece.from <= time);
        self.pieces[after.saturating_sub(1)]
    }

    fn value(&self, output: TransientOutput, state: OscillatorState) -> f64 {
        output.displacement * state.displacement + output.velocity * state.velocity / self.oscillator.natural
    }
}

/// Nodes and weights of the Gauss–Legendre rule of eight points, by pairs.
const GAUSS_8: [(f64, f64); 4] = [
    (0.183_434_642_495_649_8, 0.362_683_783_378_362),
    (0.525_532_409_916_329, 0.313_706_645_877_887_27),
    (0.796_666_477_413_626_7, 0.222_381_034_453_374_48),
    (0.960_289_856_497_536_3, 0.101_228_536_290_376_26),
];
