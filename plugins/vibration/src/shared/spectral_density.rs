//! Power spectral density of a random excitation: a level over all frequencies, over a band, or a table.

use dalembert_core::{Inputs, Refusal, Worksheet};
use dalembert_mechanics::{
    Real,
    vibration::random::{Closed, Density, DensityError, QuadratureError, Resonance, modal_moment},
};

use crate::sources::RAO;

/// Spectral density of an acceleration, one-sided, over the frequency in Hz.
#[derive(Clone, Debug, Inputs)]
pub enum AccelerationDensity {
    /// White: the same at every frequency
    White {
        /// Level.
        /// One-sided.
        #[input("S", "m^2/s^4/Hz", positive)]
        level: f64,
    },
    /// Level over a band
    Band {
        /// Level.
        /// One-sided.
        #[input("S", "m^2/s^4/Hz", positive)]
        level: f64,
        /// From.
        #[input("f₁", "Hz", nonnegative)]
        from: f64,
        /// To.
        #[input("f₂", "Hz", positive)]
        to: f64,
    },
    /// Table
    /// Zero outside it.
    Table {
        /// Points.
        /// Two rows at the same frequency define a step.
        #[input(table)]
        points: Vec<AccelerationDensityPoint>,
        /// Between the points.
        between: Between,
    },
}

/// Spectral density of a force, one-sided, over the frequency in Hz.
#[derive(Clone, Debug, Inputs)]
pub enum ForceDensity {
    /// White: the same at every frequency
    White {
        /// Level.
        /// One-sided.
        #[input("S", "N^2/Hz", positive)]
        level: f64,
    },
    /// Level over a band
    Band {
        /// Level.
        /// One-sided.
        #[input("S", "N^2/Hz", positive)]
        level: f64,
        /// From.
        #[input("f₁", "Hz", nonnegative)]
        from: f64,
        /// To.
        #[input("f₂", "Hz", positive)]
        to: f64,
    },
    /// Table
    /// Zero outside it.
    Table {
        /// Points.
        /// Two rows at the same frequency define a step.
        #[input(table)]
        points: Vec<ForceDensityPoint>,
        /// Between the points.
        between: Between,
    },
}

/// Spectral density of an angular acceleration, one-sided, over the frequency in Hz.
#[derive(Clone, Debug, Inputs)]
pub enum AngularAccelerationDensity {
    /// White: the same at every frequency
    White {
        /// Level.
        /// One-sided.
        #[input("S", "rad^2/s^4/Hz", positive)]
        level: f64,
    },
    /// Level over a band
    Band {
        /// Level.
        /// One-sided.
        #[input("S", "rad^2/s^4/Hz", positive)]
        level: f64,
        /// From.
        #[input("f₁", "Hz", nonnegative)]
        from: f64,
        /// To.
        #[input("f₂", "Hz", positive)]
        to: f64,
    },
    /// Table
    /// Zero outside it.
    Table {
        /// Points.
        /// Two rows at the same frequency define a step.
        #[input(table)]
        points: Vec<AngularAccelerationPoint>,
        /// Between the points.
        between: Between,
    },
}

/// Spectral density of a torque, one-sided, over the frequency in Hz.
#[derive(Clone, Debug, Inputs)]
pub enum TorqueDensity {
    /// White: the same at every frequency
    White {
        /// Level.
        /// One-sided.
        #[input("S", "N^2*m^2/Hz", positive)]
        level: f64,
    },
    /// Level over a band
    Band {
        /// Level.
        /// One-sided.
        #[input("S", "N^2*m^2/Hz", positive)]
        level: f64,
        /// From.
        #[input("f₁", "Hz", nonnegative)]
        from: f64,
        /// To.
        #[input("f₂", "Hz", positive)]
        to: f64,
    },
    /// Table
    /// Zero outside it.
    Table {
        /// Points.
        /// Two rows at the same frequency define a step.
        #[input(table)]
        points: Vec<TorqueDensityPoint>,
        /// Between the points.
        between: Between,
    },
}

/// Spectral density of a load per unit length, one-sided, over the frequency in Hz.
#[derive(Clone, Debug, Inputs)]
pub enum LineLoadDensity {
    /// White: the same at every frequency
    White {
        /// Level.
        /// One-sided.
        #[input("S", "N^2/m^2/Hz", positive)]
        level: f64,
    },
    /// Level over a band
    Band {
        /// Level.
        /// One-sided.
        #[input("S", "N^2/m^2/Hz", positive)]
        level: f64,
        /// From.
        #[input("f₁", "Hz", nonnegative)]
        from: f64,
        /// To.
        #[input("f₂", "Hz", positive)]
        to: f64,
    },
    /// Table
    /// Zero outside it.
    Table {
        /// Points.
        /// Two rows at the same frequency define a step.
        #[input(table)]
        points: Vec<LineLoadDensityPoint>,
        /// Between the points.
        between: Between,
    },
}

/// Spectral density of a load without correlation between points: one-sided, over the frequency in Hz, for each length.
#[derive(Clone, Debug, Inputs)]
pub enum UncorrelatedDensity {
    /// White: the same at every frequency
    White {
        /// Level.
        /// One-sided.
        #[input("S", "N^2/m/Hz", positive)]
        level: f64,
    },
    /// Level over a band
    Band {
        /// Level.
        /// One-sided.
        #[input("S", "N^2/m/Hz", positive)]
        level: f64,
        /// From.
        #[input("f₁", "Hz", nonnegative)]
        from: f64,
        /// To.
        #[input("f₂", "Hz", positive)]
        to: f64,
    },
}

/// Interpolation of a density between the points of its table.
#[derive(Clone, Debug, Inputs)]
pub enum Between {
    /// Straight lines in a log-log diagram, as in test specifications
    Logarithmic,
    /// Straight lines
    Linear,
}

/// A point of the density of an acceleration.
#[derive(Clone, Debug, Inputs)]
pub struct AccelerationDensityPoint {
    /// Frequency.
    #[input("f", "Hz", nonnegative)]
    pub frequency: f64,
    /// Density.
    #[input("S", "m^2/s^4/Hz", nonnegative)]
    pub density: f64,
}

/// A point of the density of a force.
#[derive(Clone, Debug, Inputs)]
pub struct ForceDensityPoint {
    /// Frequency.
    #[input("f", "Hz", nonnegative)]
    pub frequency: f64,
    /// Density.
    #[input("S", "N^2/Hz", nonnegative)]
    pub density: f64,
}

/// A point of the density of an angular acceleration.
#[derive(Clone, Debug, Inputs)]
pub struct AngularAccelerationPoint {
    /// Frequency.
    #[input("f", "Hz", nonnegative)]
    pub frequency: f64,
    /// Density.
    #[input("S", "rad^2/s^4/Hz", nonnegative)]
    pub density: f64,
}

/// A point of the density of a torque.
#[derive(Clone, Debug, Inputs)]
pub struct TorqueDensityPoint {
    /// Frequency.
    #[input("f", "Hz", nonnegative)]
    pub frequency: f64,
    /// Density.
    #[input("S", "N^2*m^2/Hz", nonnegative)]
    pub density: f64,
}

/// A point of the density of a load per unit length.
#[derive(Clone, Debug, Inputs)]
pub struct LineLoadDensityPoint {
    /// Frequency.
    #[input("f", "Hz", nonnegative)]
    pub frequency: f64,
    /// Density.
    #[input("S", "N^2/m^2/Hz", nonnegative)]
    pub density: f64,
}

/// A density per rad/s.
pub(crate) enum Spectrum {
    /// The same everywhere.
    White(f64),
    /// A level between two frequencies.
    Band(f64, [f64; 2]),
    /// Points.
    Table(Density),
}

impl AccelerationDensity {
    /// The density per rad/s.
    pub(crate) fn spectrum(&self) -> Result<Spectrum, Refusal> {
        match self {
            AccelerationDensity::White { level } => Ok(Spectrum::White(*level)),
            AccelerationDensity::Band { level, from, to } => band(*level, *from, *to),
            AccelerationDensity::Table { points, between } => {
                table(points.iter().map(|point| (point.frequency, point.density)).collect(), between)
            }
        }
    }
}

impl ForceDensity {
    /// The density per rad/s.
    pub(crate) fn spectrum(&self) -> Result<Spectrum, Refusal> {
        match self {
            ForceDensity::White { level } => Ok(Spectrum::White(*level)),
            ForceDensity::Band { level, from, to } => band(*level, *from, *to),
            ForceDensity::Table { points, between } => {
                table(points.iter().map(|point| (point.frequency, point.density)).collect(), between)
            }
        }
    }
}

impl AngularAccelerationDensity {
    /// The density per rad/s.
    pub(crate) fn spectrum(&self) -> Result<Spectrum, Refusal> {
        match self {
            AngularAccelerationDensity::White { level } => Ok(Spectrum::White(*level)),
            AngularAccelerationDensity::Band { level, from, to } => band(*level, *from, *to),
            AngularAccelerationDensity::Table { points, between } => {
                table(points.iter().map(|point| (point.frequency, point.density)).collect(), between)
            }
        }
    }
}

impl TorqueDensity {
    /// The density per rad/s.
    pub(crate) fn spectrum(&self) -> Result<Spectrum, Refusal> {
        match self {
            TorqueDensity::White { level } => Ok(Spectrum::White(*level)),
            TorqueDensity::Band { level, from, to } => band(*level, *from, *to),
            TorqueDensity::Table { points, between } => {
                table(points.iter().map(|point| (point.frequency, point.density)).collect(), between)
            }
        }
    }
}

impl LineLoadDensity {
    /// The density per rad/s.
    pub(crate) fn spectrum(&self) -> Result<Spectrum, Refusal> {
        match self {
            LineLoadDensity::White { level } => Ok(Spectrum::White(*level)),
            LineLoadDensity::Band { level, from, to } => band(*level, *from, *to),
            LineLoadDensity::Table { points, between } => {
                table(points.iter().map(|point| (point.frequency, point.density)).collect(), between)
            }
        }
    }
}

impl UncorrelatedDensity {
    /// The density per rad/s.
    pub(crate) fn spectrum(&self) -> Result<Spectrum, Refusal> {
        match self {
            UncorrelatedDensity::White { level } => Ok(Spectrum::White(*level)),
            UncorrelatedDensity::Band { level, from, to } => band(*level, *from, *to),
        }
    }
}

impl Spectrum {
    /// The density at a frequency, rad/s.
    pub(crate) fn at(&self, omega: f64) -> f64 {
        match self {
            Spectrum::White(level) => *level,
            Spectrum::Band(level, [from, to]) => {
                if (*from..=*to).contains(&omega) {
                    *level
                } else {
                    0.0
                }
            }
            Spectrum::Table(density) => density.at(omega),
        }
    }

    /// The frequencies at which an integral over it is broken.
    pub(crate) fn ends(&self) -> Vec<f64> {
        match self {
            Spectrum::White(_) => vec![0.0, f64::INFINITY],
            Spectrum::Band(_, ends) => ends.to_vec(),
            Spectrum::Table(density) => density.frequencies().collect(),
        }
    }

    /// The points at which an integral of modal responses over it is broken: its ends, and frequencies about each
    /// resonance.
    pub(crate) fn breaks(&self, modes: impl Iterator<Item = Resonance> + Clone) -> Vec<f64> {
        let mut points = self.ends();
        let (first, last) = (points[0], points[points.len() - 1]);
        let inside = |omega: &f64| *omega > first && *omega < last;
        points.extend(modes.clone().flat_map(Resonance::breaks).filter(inside));
        if last.is_infinite() {
            points.push(40.0 * modes.fold(0.0, |most: f64, mode| most.max(mode.natural)));
        }
        points
    }

    /// `∫ |Σ γ H|² ω^m S dω` in closed form, mode by mode with their cross terms, where the density is a level.
    pub(crate) fn partial_fractions(&self, modes: &[(Resonance, f64)], power: u8) -> Option<Closed> {
        let (level, ends) = match self {
            Spectrum::White(level) => (*level, [0.0, f64::INFINITY]),
            Spectrum::Band(level, ends) => (*level, *ends),
            Spectrum::Table(_) => return None,
        };
        let mut sum = Closed { value: 0.0, scale: 0.0 };
        for (r, r_share) in modes {
            for (s, s_share) in modes {
                let weight = r_share * s_share * level;
                let moment = modal_moment(*r, *s, power, ends)?;
                sum.value += weight * moment.value;
                sum.scale += weight.abs() * moment.scale;
            }
        }
        Some(sum)
    }

    /// Returns true if the spectrum covers a frequency.
    pub(crate) fn reaches(&self, omega: f64) -> bool {
        self.at(omega) > 0.0
    }
}

/// Rate of zero crossings with positive slope, from root mean squares. `moment` gives the spectral moments of the response of
/// order zero and two by another way.
pub(crate) fn zero_crossings<W: Worksheet>(
    [displacement, velocity]: [W::Num; 2],
    moment: impl Fn(u8) -> Option<f64>,
    sheet: W,
) {
    let why = (
        "Mean rate of upward zero crossings, by Rice: the apparent frequency of the motion",
        RAO.at("ch. 14"),
    );
    let rate = sheet.step("ν₀", "Hz", velocity / displacement, why);
    sheet.answer("crossing_rate", "Mean rate of upward zero crossings", rate);
    sheet.verify(|| {
        if let (Some(zeroth), Some(second)) = (moment(0), moment(2)) {
            let what =
                "the square of the zero-crossing rate is the second spectral moment of the response over that of order zero";
            sheet.check(what, (second / zeroth).into(), rate.powi(2));
        }
    });
}

/// The words for an integral that was not found.
pub(crate) fn not_found(_: QuadratureError) -> Refusal {
    Refusal::because(
        "the integral over the frequency was not found: the damping is too small, or the numbers are too large",
    )
}

fn band(level: f64, from: f64, to: f64) -> Result<Spectrum, Refusal> {
    if from < to {
        Ok(Spectrum::Band(level, [from, to]))
    } else {
        Err(Refusal::because("the band ends before it begins: write its lower frequency first"))
    }
}

fn table(points: Vec<(f64, f64)>, between: &Between) -> Result<Spectrum, Refusal> {
    let logarithmic = matches!(between, Between::Logarithmic);
    Density::new(points, logarithmic).map(Spectrum::Table).map_err(|err| match err {
        DensityError::Few => Refusal::because("the table of the density needs at least two points"),
        DensityError::Order => Refusal::because(
            "the frequencies of the density must ascend, with two rows at one frequency for a step: put the rows of the \
             table in order",
        ),
        DensityError::Value => Refusal::because(
            "a log-log line cannot pass through zero: write frequencies and densities above zero, or choose straight \
             lines",
        ),
    })
}
