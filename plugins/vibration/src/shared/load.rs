//! Loads in the course of time: steps, ramps, pulses, tables; what transients and shock spectra share.

use std::f64::consts::{PI, TAU};

use dalembert_core::{Inputs, Refusal};
use dalembert_mechanics::vibration::transient::{
    LoadLaw, LoadSegment, Oscillator, OscillatorState, TransientOutput, UnitResponses,
};
use dalembert_numerics::quadrature::integral;

/// Time history of a load.
#[derive(Clone, Debug, Inputs)]
pub enum LoadHistory {
    /// Step
    /// Applied suddenly and held constant.
    Step,
    /// Ramp, then constant
    /// Rises linearly and then stays constant.
    RampStep {
        /// Rise time.
        #[input("t_r", "s", positive)]
        rise: f64,
    },
    /// Ramp without end
    /// Rises linearly without end.
    Ramp {
        /// Rise time to the full value.
        #[input("t_r", "s", positive)]
        rise: f64,
    },
    /// Exponential
    /// Applied suddenly, it decays as e^(−t/τ).
    Exponential {
        /// Time constant.
        #[input("τ", "s", positive)]
        constant: f64,
    },
    /// Rectangular pulse
    Rectangular {
        /// Duration.
        #[input("t_d", "s", positive)]
        duration: f64,
    },
    /// Triangular pulse
    Triangular {
        /// Duration.
        #[input("t_d", "s", positive)]
        duration: f64,
        /// Time of the peak.
        /// At the middle if omitted; 0 for a blast, the duration for a sawtooth.
        #[input("t_p", "s", nonnegative)]
        peak: Option<f64>,
    },
    /// Half-sine pulse
    HalfSine {
        /// Duration.
        #[input("t_d", "s", positive)]
        duration: f64,
    },
    /// Versed-sine pulse
    /// (1 − cos 2πt/t_d)/2: it begins and ends smoothly.
    VersedSine {
        /// Duration.
        #[input("t_d", "s", positive)]
        duration: f64,
    },
    /// Exponential rise
    /// 1 − e^(−t/τ): it tends to its maximum.
    ExponentialRise {
        /// Time constant.
        #[input("τ", "s", positive)]
        constant: f64,
    },
    /// Parabola over its duration, then zero
    /// a₀ + a₁s + a₂s² with s = t/t_d, in multiples of the maximum: 1, 0, −1 for 1 − s²; 0, 4, −4 for an arch.
    Parabola {
        /// Duration.
        #[input("t_d", "s", positive)]
        duration: f64,
        /// Constant term.
        #[input("a₀", "1", default = "0")]
        constant: f64,
        /// Linear coefficient.
        #[input("a₁", "1", default = "0")]
        linear: f64,
        /// Quadratic coefficient.
        #[input("a₂", "1", default = "0")]
        quadratic: f64,
    },
}

/// A point of an acceleration in time.
#[derive(Clone, Debug, Inputs)]
pub struct AccelerationPoint {
    /// Time.
    #[input("t", "s", nonnegative)]
    pub time: f64,
    /// Acceleration.
    #[input("a", "m/s^2")]
    pub acceleration: f64,
}

/// A load as straight, sinusoidal and exponential pieces, each with a size of one.
pub(crate) struct Pieces {
    /// The pieces.
    pub(crate) pieces: Vec<LoadSegment>,
    /// End of the load, for one that ends.
    pub(crate) end: Option<f64>,
}

impl LoadHistory {
    /// The pieces of a load of that size.
    ///
    /// # Errors
    /// A peak after the end of its pulse.
    pub(crate) fn pieces(&self, size: f64) -> Result<Pieces, Refusal> {
        let line = |from, start, slope| LoadSegment { from, law: LoadLaw::Line { start, slope } };
        let none = |from| line(from, 0.0, 0.0);
        let (pieces, end) = match *self {
            LoadHistory::Step => (vec![line(0.0, size, 0.0)], None),
            LoadHistory::RampStep { rise } => {
                (vec![line(0.0, 0.0, size / rise), line(rise, size, 0.0)], None)
            }
            LoadHistory::Ramp { rise } => (vec![line(0.0, 0.0, size / rise)], None),
            LoadHistory::Exponential { constant } => (
                vec![LoadSegment {
                    from: 0.0,
                    law: LoadLaw::Decay { amplitude: size, rate: 1.0 / constant },
                }],
                None,
            ),
            LoadHistory::Rectangular { duration } => {
                (vec![line(0.0, size, 0.0), none(duration)], Some(duration))
            }
            LoadHistory::Triangular { duration, peak } => {
                let peak = peak.unwrap_or(duration / 2.0);
                if peak > duration {
                    return Err(Refusal::because(
                        "the peak of the triangle comes after its end: write a time of the peak up to the duration",
                    ));
                }
                let mut pieces = Vec::new();
                if peak > 0.0 {
                    pieces.push(line(0.0, 0.0, size / peak));
                }
                if peak < duration {
                    pieces.push(line(peak, size, -size / (duration - peak)));
                }
                pieces.push(none(duration));
                (pieces, Some(duration))
            }
            LoadHistory::HalfSine { duration } => {
                let law = LoadLaw::Sine { amplitude: size, frequency: PI / duration };
                (vec![LoadSegment { from: 0.0, law }, none(duration)], Some(duration))
            }
            LoadHistory::VersedSine { duration } => {
                let law = LoadLaw::Versine { size, frequency: TAU / duration };
                (vec![LoadSegment { from: 0.0, law }, none(duration)], Some(duration))
            }
            LoadHistory::ExponentialRise { constant } => {
                (vec![LoadSegment { from: 0.0, law: LoadLaw::Rise { size, rate: 1.0 / constant } }], None)
            }
            LoadHistory::Parabola { duration, constant, linear, quadratic } => {
                if [constant, linear, quadratic] == [0.0; 3] {
                    return Err(Refusal::because(
                        "a parabola without coefficients is no load: write at least one of them",
                    ));
                }
                let law = LoadLaw::Parabola {
                    start: size * constant,
                    slope: size * linear / duration,
                    bend: 2.0 * size * quadratic / (duration * duration),
                };
                (vec![LoadSegment { from: 0.0, law }, none(duration)], Some(duration))
            }
        };
        Ok(Pieces { pieces, end })
    }
}

/// The pieces of a table of times and values, straight between its points and zero outside them; two points at one
/// time are a jump.
///
/// # Errors
/// Fewer than two points; times below zero or out of order.
pub(crate) fn table(points: &[(f64, f64)]) -> Result<Pieces, Refusal> {
    let Some(&(last, _)) = points.last() else { return Err(few()) };
    if points.len() < 2 {
        return Err(few());
    }
    if points[0].0 < 0.0 || points.windows(2).any(|pair| pair[1].0 < pair[0].0) {
        return Err(Refusal::because(
            "the times of the table must begin at zero or later and ascend: sort its rows",
        ));
    }
    let mut pieces = Vec::new();
    for pair in points.windows(2) {
        let ((from, start), (to, end)) = (pair[0], pair[1]);
        if to > from {
            pieces
                .push(LoadSegment { from, law: LoadLaw::Line { start, slope: (end - start) / (to - from) } });
        }
    }
    pieces.push(LoadSegment { from: last, law: LoadLaw::Line { start: 0.0, slope: 0.0 } });
    Ok(Pieces { pieces, end: Some(last) })
}

/// Pieces whose values are multiplied by a factor.
pub(crate) fn scaled(pieces: &[LoadSegment], factor: f64) -> Vec<LoadSegment> {
    pieces.iter().map(|piece| LoadSegment { from: piece.from, law: piece.law.scaled(factor) }).collect()
}

fn few() -> Refusal {
    Refusal::because("the table has fewer than two points: write at least its start and its end")
}

/// Output at a time, by the integrals of displacement and velocity over unit impulses (Duhamel), by quadrature: the
/// motion begins in a state under a load of pieces. `None` where too much would have to be added up.
pub(crate) fn by_impulses(
    oscillator: Oscillator,
    begun: OscillatorState,
    pieces: &[LoadSegment],
    output: TransientOutput,
    time: f64,
) -> Option<f64> {
    const MOST: f64 = 2000.0;
    let Oscillator { natural, ratio } = oscillator;
    let weighed = |x: f64, rate: f64| output.displacement * x + output.velocity * rate;
    let unit = UnitResponses::at(ratio, natural * time);
    let (x, rate) = (begun.displacement, begun.velocity / natural);
    let free = [unit.release * x + unit.impulse * rate, unit.release_rate() * x + unit.impulse_rate * rate];
    let (mut sum, mut parts) = (weighed(free[0], free[1]), 0.0);
    for (n, piece) in pieces.iter().enumerate() {
        let end = pieces.get(n + 1).map_or(time, |next| next.from).min(time);
        if end <= piece.from || piece.law == (LoadLaw::Line { start: 0.0, slope: 0.0 }) {
            continue;
        }
        let here = (2.0 * (end - piece.from) * (natural * (1.0 + 2.0 * ratio) + piece.law.fastest()))
            .ceil()
            .max(1.0);
        parts += here;
        if parts.is_nan() || parts > MOST {
            return None;
        }
        let of = |at: f64| {
            let unit = UnitResponses::at(ratio, natural * (time - at));
            weighed(unit.impulse, unit.impulse_rate) * piece.law.at(at - piece.from)
        };
        sum += natural * integral(of, [piece.from, end], here as u32);
    }
    Some(sum)
}
