//! The waves of the textbooks: their pieces, and their Fourier coefficients as the tables give them.

use std::f64::consts::PI;

use dalembert_core::{Inputs, Refusal, Text, Worksheet};
use dalembert_mechanics::{
    Real,
    vibration::periodic::{self, WaveSegment},
};

use crate::{shared::oscillator::motion::OscillatorMotion, sources::RAO};

/// The most points of a table.
const MOST: usize = 400;

/// One period of the wave, of height one.
#[derive(Clone, Debug, Inputs)]
pub enum Waveform {
    /// Square wave
    /// Positive for the first half of the period, equally negative for the second.
    Square,
    /// Triangular wave
    /// Rises from zero, falls as far below it and returns.
    Triangle,
    /// Sawtooth
    /// Rises from zero over the period, then drops at once to zero: a cam.
    Sawtooth,
    /// Half-rectified sine
    /// The positive half of a sine, zero for the second half of the period.
    HalfRectified,
    /// Rectified sine
    /// One arch after another; the period is that of one arch.
    FullRectified,
    /// Rectangular pulses
    /// One for a fraction of the period, zero for the rest.
    Pulse {
        /// Fraction of the period.
        #[input("d", "%", positive, fraction, below = 100)]
        share: f64,
    },
    /// Table
    /// Straight lines from point to point, and from the last to the first of the next period.
    Table {
        /// Points.
        #[input(table)]
        points: Vec<WavePoint>,
    },
}

/// A point of a wave.
#[derive(Clone, Debug, Inputs)]
pub struct WavePoint {
    /// Fraction of the period.
    /// Ascending; two points at the same fraction define a step.
    #[input("s", "%", nonnegative, max = 100)]
    pub share: f64,
    /// Value over the height of the wave.
    #[input("u", "1")]
    pub value: f64,
}

impl Waveform {
    /// The pieces of a period.
    pub(super) fn pieces(&self) -> Result<Vec<WaveSegment>, Refusal> {
        Ok(match self {
            Waveform::Square => periodic::square(),
            Waveform::Triangle => periodic::triangle(),
            Waveform::Sawtooth => periodic::sawtooth(),
            Waveform::HalfRectified => periodic::half_rectified(),
            Waveform::FullRectified => periodic::full_rectified(),
            Waveform::Pulse { share } => periodic::pulse(*share),
            Waveform::Table { points } => {
                if points.len() > MOST {
                    return Err(Refusal::because(
                        Text::new("the table has {count} points; at most {most} can be summed: reduce it")
                            .with("count", points.len())
                            .with("most", MOST),
                    ));
                }
                let points: Vec<(f64, f64)> = points.iter().map(|point| (point.share, point.value)).collect();
                periodic::polygon(&points).ok_or_else(|| {
                    Refusal::because(
                        "the table requires two points or more, with fractions of the period ascending from 0 to 100 %",
                    )
                })?
            }
        })
    }
}

impl<W: Worksheet> WaveformGiven<W> {
    /// Mean of the motion, from the deflection under the height of the wave; `found` is the mean of the pieces.
    pub(super) fn mean(&self, motion: OscillatorMotion, height: W::Num, found: f64, sheet: W) -> W::Num {
        let (value, why) = match self {
            WaveformGiven::Square {} | WaveformGiven::Triangle {} => {
                (W::Num::from(0.0), "Mean of the motion: the wave lies equally above and below zero")
            }
            WaveformGiven::Sawtooth {} => {
                (height / 2.0, "Mean of the motion: the mean of the wave is half its height")
            }
            WaveformGiven::HalfRectified {} => {
                (height / PI, "Mean of the motion: the mean of one half-sine per period is 1/π of its height")
            }
            WaveformGiven::FullRectified {} => {
                (height * 2.0 / PI, "Mean of the motion: the mean of a sine arch is 2/π of its height")
            }
            WaveformGiven::Pulse { share } => (
                height * *share,
                "Mean of the motion: the mean of the pulses is their fraction of the period",
            ),
            WaveformGiven::Table { .. } => {
                let mean =
                    sheet.numerical("u₀", "1", found, "Mean of the wave, integrated segment by segment");
                (height * mean, "Mean of the motion: the static deflection under the mean of the wave")
            }
        };
        sheet.step(motion.of("X₀", "Θ₀"), motion.displacement_unit(), value, (why, RAO.at("§4.2")))
    }

    /// Amplitude of a harmonic of the wave, from its height; `found` is what the pieces say.
    pub(super) fn amplitude(
        &self,
        height: W::Num,
        n: u32,
        found: (f64, f64),
        (symbol, unit): (&'static str, &'static str),
        sheet: W,
    ) -> W::Num {
        let order = f64::from(n);
        let (value, why) = match self {
            WaveformGiven::Square {} => {
                (height * 4.0 / order / PI, "Fourier coefficient of a square wave: 4/(nπ) for odd n")
            }
            WaveformGiven::Triangle {} => (
                height * 8.0 / (order * order) / W::Num::from(PI).powi(2),
                "Fourier coefficient of a triangular wave: 8/(nπ)² for odd n",
            ),
            WaveformGiven::Sawtooth {} => (height / order / PI, "Fourier coefficient of a sawtooth: 1/(nπ)"),
            WaveformGiven::HalfRectified {} if n == 1 => {
                (height / 2.0, "First harmonic of a half-rectified sine: half its height")
            }
            WaveformGiven::HalfRectified {} => (
                height * 2.0 / (order * order - 1.0) / PI,
                "Fourier coefficient of a half-rectified sine: 2/((n² − 1)π) for even n",
            ),
            WaveformGiven::FullRectified {} => (
                height * 4.0 / (4.0 * order * order - 1.0) / PI,
                "Fourier coefficient of a rectified sine: 4/((4n² − 1)π)",
            ),
            WaveformGiven::Pulse { share } => (
                height * 2.0 * (*share * order * PI).sin().abs() / order / PI,
                "Fourier coefficient of rectangular pulses: 2|sin nπd|/(nπ)",
            ),
            WaveformGiven::Table { .. } => {
                let why = ("Cosine coefficient, integrated segment by segment", RAO.at("§1.11"));
                let a = sheet.numerical(("a", n as usize), "1", found.0, why);
                let why = "Sine coefficient, integrated segment by segment";
                let b = sheet.numerical(("b", n as usize), "1", found.1, why);
                (height * (a.powi(2) + b.powi(2)).sqrt(), "Amplitude from the cosine and sine coefficients")
            }
        };
        sheet.step((symbol, n as usize), unit, value, (why, RAO.at("§1.11")))
    }
}
