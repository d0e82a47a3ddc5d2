//! Time histories of forces and of accelerations of the base, as straight pieces and harmonics.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use dalembert_core::{Inputs, Refusal};
use dalembert_mechanics::vibration::{
    response::{ForceSegment, HarmonicLoad, Push, TimeExcitation},
    transient::{LoadLaw, LoadSegment},
};
use nalgebra::DVector;

use crate::shared::load::{AccelerationPoint, LoadHistory};

/// Time history of a force.
#[derive(Clone, Debug, Inputs)]
pub enum ForceHistory {
    /// Step: constant from its start
    Step {
        /// Force.
        #[input("F", "N")]
        force: f64,
        /// Its start.
        #[input("t_s", "s", nonnegative, default = "0 s")]
        start: f64,
    },
    /// Rectangular pulse
    Pulse {
        /// Force.
        #[input("F", "N")]
        force: f64,
        /// Its start.
        #[input("t_s", "s", nonnegative, default = "0 s")]
        start: f64,
        /// Its duration.
        #[input("t_d", "s", positive)]
        duration: f64,
    },
    /// Half-sine pulse
    HalfSine {
        /// Maximum force.
        #[input("F", "N")]
        force: f64,
        /// Its start.
        #[input("t_s", "s", nonnegative, default = "0 s")]
        start: f64,
        /// Its duration.
        #[input("t_d", "s", positive)]
        duration: f64,
    },
    /// Triangular pulse
    Triangle {
        /// Maximum force.
        #[input("F", "N")]
        force: f64,
        /// Its start.
        #[input("t_s", "s", nonnegative, default = "0 s")]
        start: f64,
        /// Its duration.
        #[input("t_d", "s", positive)]
        duration: f64,
        /// Time from its start to the peak.
        /// At the middle if omitted; 0 for a blast, the duration for a sawtooth.
        #[input("t_p", "s", nonnegative)]
        peak: Option<f64>,
    },
    /// Versed-sine pulse
    VersedSine {
        /// Maximum force.
        #[input("F", "N")]
        force: f64,
        /// Its start.
        #[input("t_s", "s", nonnegative, default = "0 s")]
        start: f64,
        /// Its duration.
        #[input("t_d", "s", positive)]
        duration: f64,
    },
    /// Ramp to a constant force
    Ramp {
        /// Force at its end.
        #[input("F", "N")]
        force: f64,
        /// Rise time.
        #[input("t_r", "s", positive)]
        rise: f64,
    },
    /// Harmonic: F cos(Ωt − φ)
    Harmonic {
        /// Amplitude.
        #[input("F", "N")]
        force: f64,
        /// Frequency.
        #[input("Ω", "rad/s", positive)]
        frequency: f64,
        /// Phase lag; 90° for a sine.
        #[input("φ", "rad", default = "0 deg")]
        lag: f64,
    },
    /// Table: linear between its points, zero before and after
    Table {
        /// Points.
        #[input(table)]
        points: Vec<ForcePoint>,
    },
}

/// A point of the table of a force.
#[derive(Clone, Debug, Inputs)]
pub struct ForcePoint {
    /// Time.
    #[input("t", "s", nonnegative)]
    pub time: f64,
    /// Force.
    #[input("F", "N")]
    pub force: f64,
}

/// Time history of an acceleration of the base.
#[derive(Clone, Debug, Inputs)]
pub enum AccelerationHistory {
    /// Step: constant from its start
    Step {
        /// Acceleration.
        #[input("a", "m/s^2")]
        acceleration: f64,
        /// Its start.
        #[input("t_s", "s", nonnegative, default = "0 s")]
        start: f64,
    },
    /// Rectangular pulse
    Pulse {
        /// Acceleration.
        #[input("a", "m/s^2")]
        acceleration: f64,
        /// Its start.
        #[input("t_s", "s", nonnegative, default = "0 s")]
        start: f64,
        /// Its duration.
        #[input("t_d", "s", positive)]
        duration: f64,
    },
    /// Half-sine pulse
    HalfSine {
        /// Maximum acceleration.
        #[input("a", "m/s^2")]
        acceleration: f64,
        /// Its start.
        #[input("t_s", "s", nonnegative, default = "0 s")]
        start: f64,
        /// Its duration.
        #[input("t_d", "s", positive)]
        duration: f64,
    },
    /// Triangular pulse
    Triangle {
        /// Maximum acceleration.
        #[input("a", "m/s^2")]
        acceleration: f64,
        /// Its start.
        #[input("t_s", "s", nonnegative, default = "0 s")]
        start: f64,
        /// Its duration.
        #[input("t_d", "s", positive)]
        duration: f64,
        /// Time from its start to the peak.
        /// At the middle if omitted; 0 for a blast, the duration for a sawtooth.
        #[input("t_p", "s", nonnegative)]
        peak: Option<f64>,
    },
    /// Versed-sine pulse
    VersedSine {
        /// Maximum acceleration.
        #[input("a", "m/s^2")]
        acceleration: f64,
        /// Its start.
        #[input("t_s", "s", nonnegative, default = "0 s")]
        start: f64,
        /// Its duration.
        #[input("t_d", "s", positive)]
        duration: f64,
    },
    /// Ramp to a constant force
    Ramp {
        /// Acceleration at its end.
        #[input("a", "m/s^2")]
        acceleration: f64,
        /// Rise time.
        #[input("t_r", "s", positive)]
        rise: f64,
    },
    /// Harmonic: a cos(Ωt − φ)
    Harmonic {
        /// Amplitude.
        #[input("a", "m/s^2")]
        acceleration: f64,
        /// Frequency.
        #[input("Ω", "rad/s", positive)]
        frequency: f64,
        /// Phase lag; 90° for a sine.
        #[input("φ", "rad", default = "0 deg")]
        lag: f64,
    },
    /// Table: linear between its points, zero before and after
    Table {
        /// Points.
        #[input(table)]
        points: Vec<AccelerationPoint>,
    },
}

/// A time history by its size and its course.
pub(crate) enum History {
    /// Straight pieces, each with a size of one.
    Pieces(f64, Vec<ForceSegment>),
    /// `size cos(Ωt − φ)`: size, frequency and lag.
    Harmonic([f64; 3]),
    /// A pulse of harmonics between two times, each by its size, frequency, lag and start, beside straight pieces.
    Pulse(f64, Vec<ForceSegment>, Vec<[f64; 4]>),
}

impl ForceHistory {
    pub(crate) fn history(&self) -> Result<History, Refusal> {
        Ok(match self {
            ForceHistory::Step { force, start } => History::Pieces(*force, step(*start)),
            ForceHistory::Pulse { force, start, duration } => {
                History::Pieces(*force, pulse(*start, *duration))
            }
            ForceHistory::HalfSine { force, start, duration } => {
                History::half_sine(*force, *start, *duration)
            }
            ForceHistory::Triangle { force, start, duration, peak } => {
                History::Pieces(*force, triangle(*start, *duration, *peak)?)
            }
            ForceHistory::VersedSine { force, start, duration } => {
                History::versed_sine(*force, *start, *duration)
            }
            ForceHistory::Ramp { force, rise } => History::Pieces(*force, ramp(*rise)),
            ForceHistory::Harmonic { force, frequency, lag } => History::Harmonic([*force, *frequency, *lag]),
            ForceHistory::Table { points } => {
                History::Pieces(1.0, table(points.iter().map(|point| [point.time, point.force]))?)
            }
        })
    }
}

impl AccelerationHistory {
    pub(crate) fn history(&self) -> Result<History, Refusal> {
        Ok(match self {
            AccelerationHistory::Step { acceleration, start } => History::Pieces(*acceleration, step(*start)),
            AccelerationHistory::Pulse { acceleration, start, duration } => {
                History::Pieces(*acceleration, pulse(*start, *duration))
            }
            AccelerationHistory::HalfSine { acceleration, start, duration } => {
                History::half_sine(*acceleration, *start, *duration)
            }
            AccelerationHistory::Triangle { acceleration, start, duration, peak } => {
                History::Pieces(*acceleration, triangle(*start, *duration, *peak)?)
            }
            AccelerationHistory::VersedSine { acceleration, start, duration } => {
                History::versed_sine(*acceleration, *start, *duration)
            }
            AccelerationHistory::Ramp { acceleration, rise } => History::Pieces(*acceleration, ramp(*rise)),
            AccelerationHistory::Harmonic { acceleration, frequency, lag } => {
                History::Harmonic([*acceleration, *frequency, *lag])
            }
            AccelerationHistory::Table { points } => {
                History::Pieces(1.0, table(points.iter().map(|point| [point.time, point.acceleration]))?)
            }
        })
    }
}

impl History {
    /// One half-wave: a sine from its start, and the same again from its end, which takes away the rest of it.
    fn half_sine(size: f64, start: f64, duration: f64) -> Self {
        let sine = |start| [size, PI / duration, FRAC_PI_2, start];
        History::Pulse(size, Vec::new(), vec![sine(start), sine(start + duration)])
    }

    /// `(1 − cos)/2` for one wave: half of a rectangle without half of a cosine, which ends as it began.
    fn versed_sine(size: f64, start: f64, duration: f64) -> Self {
        let cosine = |size: f64, start| [size / 2.0, TAU / duration, 0.0, start];
        History::Pulse(
            size / 2.0,
            pulse(start, duration),
            vec![cosine(-size, start), cosine(size, start + duration)],
        )
    }

    /// Adds it to an excitation, as the forces that `of` makes of its size.
    pub(crate) fn add_to(self, excitation: &mut TimeExcitation, of: impl Fn(f64) -> DVector<f64>) {
        match self {
            History::Pieces(size, pieces) => excitation.pushes.push(Push { force: of(size), pieces }),
            History::Harmonic([size, frequency, lag]) => {
                excitation.harmonics.push(HarmonicLoad { force: of(size), frequency, lag, start: 0.0 });
            }
            History::Pulse(size, pieces, harmonics) => {
                if !pieces.is_empty() {
                    excitation.pushes.push(Push { force: of(size), pieces });
                }
                let waves = harmonics.into_iter();
                excitation.harmonics.extend(waves.map(|[size, frequency, lag, start]| HarmonicLoad {
                    force: of(size),
                    frequency,
                    lag,
                    start,
                }));
            }
        }
    }

    /// Time after which nothing new begins, or six periods of a harmonic.
    pub(crate) fn end(&self) -> f64 {
        match self {
            History::Pieces(_, pieces) => pieces.last().map_or(0.0, |piece| piece.start),
            History::Harmonic([_, frequency, _]) => 6.0 * TAU / frequency,
            History::Pulse(_, _, harmonics) => harmonics.last().map_or(0.0, |wave| wave[3]),
        }
    }
}

fn step(start: f64) -> Vec<ForceSegment> {
    vec![ForceSegment { start, value: 1.0, slope: 0.0 }]
}

fn pulse(start: f64, duration: f64) -> Vec<ForceSegment> {
    vec![
        ForceSegment { start, value: 1.0, slope: 0.0 },
        ForceSegment { start: start + duration, value: 0.0, slope: 0.0 },
    ]
}

/// A triangle; its peak is at the middle if no time from its start is given.
fn triangle(start: f64, duration: f64, peak: Option<f64>) -> Result<Vec<ForceSegment>, Refusal> {
    let pieces = LoadHistory::Triangular { duration, peak }.pieces(1.0)?.pieces;
    let straight = |piece: LoadSegment| match piece.law {
        LoadLaw::Line { start: value, slope } => ForceSegment { start: start + piece.from, value, slope },
        other => ForceSegment { start: start + piece.from, value: other.at(0.0), slope: 0.0 },
    };
    Ok(pieces.into_iter().map(straight).collect())
}

fn ramp(rise: f64) -> Vec<ForceSegment> {
    vec![
        ForceSegment { start: 0.0, value: 0.0, slope: 1.0 / rise },
        ForceSegment { start: rise, value: 1.0, slope: 0.0 },
    ]
}

/// The pieces of a table of times and values.
fn table(points: impl Iterator<Item = [f64; 2]>) -> Result<Vec<ForceSegment>, Refusal> {
    let points: Vec<[f64; 2]> = points.collect();
    if points.windows(2).any(|pair| pair[0][0] > pair[1][0]) {
        return Err(Refusal::because("the times of a force table must not decrease: sort its rows"));
    }
    let rises = points.windows(2).filter(|pair| pair[1][0] > pair[0][0]);
    let mut pieces: Vec<ForceSegment> = rises
        .map(|pair| ForceSegment {
            start: pair[0][0],
            value: pair[0][1],
            slope: (pair[1][1] - pair[0][1]) / (pair[1][0] - pair[0][0]),
        })
        .collect();
    if let Some(last) = points.last() {
        pieces.push(ForceSegment { start: last[0], value: 0.0, slope: 0.0 });
    }
    Ok(pieces)
}
