//! Measured readings, in the unit of the measurement.

use dalembert_core::{Inputs, MeasuredQuantity, Worksheet};

use crate::shared::reading::{SensorReading, SensorReadingGiven};

/// Readings without and with trial weights.
#[derive(Clone, Debug, Inputs)]
pub struct Measurements {
    /// Initial run, without trial weights.
    /// A row for each sensor, and for each speed where there are several.
    #[input("0", min = 1)]
    pub first: Vec<SensorReading>,
    /// Influence of the planes.
    pub influence: InfluenceSource,
}

/// Influence of the planes on the sensors.
#[derive(Clone, Debug, Inputs)]
pub enum InfluenceSource {
    /// Runs with trial weights
    Runs {
        /// Trial weights.
        after: TrialWeights,
        /// Runs.
        /// At least one for each plane.
        #[input(min = 1)]
        runs: Vec<TrialRunInput>,
    },
    /// Influence coefficients known
    /// The table of an earlier job, for a trim run without trial weights.
    Known {
        /// Coefficients.
        /// A row for each plane and each reading, both numbered from 1.
        #[input(table)]
        coefficients: Vec<KnownCoefficient>,
    },
}

/// Fate of a trial weight after its run: removed or left on.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Inputs)]
pub enum TrialWeights {
    /// Taken off after each run
    TakenOff,
    /// Retained: each run includes all previous trial weights
    Stay,
}

/// A run with a trial weight.
#[derive(Clone, Debug, Inputs)]
pub struct TrialRunInput {
    /// Plane of the trial weight.
    /// Planes are numbered from 1.
    #[input(min = 1, max = 20)]
    pub plane: usize,
    /// Trial weight.
    #[input("m", "g", positive)]
    pub mass: f64,
    /// Angle of the trial weight.
    /// From the reference mark, in the sense of the trial-weight angles.
    #[input("θ", "deg")]
    pub angle: f64,
    /// Readings.
    /// The same sensors and speeds in the same order as in the initial run.
    #[input(min = 1)]
    pub readings: Vec<SensorReading>,
}

/// An influence coefficient.
#[derive(Clone, Debug, Inputs)]
pub struct KnownCoefficient {
    /// Plane.
    #[input("p", "1", positive)]
    pub plane: f64,
    /// Reading.
    #[input("s", "1", positive)]
    pub reading: f64,
    /// Coefficient.
    /// Vibration over weight.
    #[input("α", "um/g | mm/(s*g) | m/(s^2*g) | 1/g", nonnegative)]
    pub size: MeasuredQuantity,
    /// Angle of the coefficient.
    /// Angle of the vibration minus that of the weight, both in the sense of the trial-weight angles.
    #[input("β", "deg")]
    pub angle: f64,
}

/// A reading as numbers of a worksheet.
pub(super) struct WorkedReading<N> {
    pub(super) amplitude: N,
    pub(super) phase: N,
    pub(super) speed: Option<f64>,
}

/// A run as numbers of a worksheet.
pub(super) struct WorkedRun<N> {
    /// Counted from 0.
    pub(super) plane: usize,
    pub(super) mass: N,
    pub(super) angle: N,
    pub(super) readings: Vec<WorkedReading<N>>,
}

/// Source of the influence coefficients: trial runs or known values.
pub(super) enum Influence<N> {
    Runs {
        stay: bool,
        runs: Vec<WorkedRun<N>>,
    },
    /// Plane and reading counted from 1, size, angle.
    Known(Vec<(f64, f64, f64, f64)>),
}

/// All that was measured as numbers of a worksheet.
pub(super) struct Job<N> {
    pub(super) units: Units,
    pub(super) first: Vec<WorkedReading<N>>,
    pub(super) influence: Influence<N>,
}

/// The units of readings and coefficients.
#[derive(Clone, Copy)]
pub(super) struct Units {
    pub(super) reading: &'static str,
    pub(super) coefficient: &'static str,
}

impl Measurements {
    /// The measurements as numbers of a worksheet.
    pub(super) fn job<W: Worksheet>(&self, given: &MeasurementsGiven<W>) -> Job<W::Num> {
        let reading = self.first.first().map_or("1", |reading| reading.amplitude.unit);
        let coefficient = match reading {
            "um" => "um/g",
            "mm/s" => "mm/(s*g)",
            "m/s^2" => "m/(s^2*g)",
            _ => "1/g",
        };
        let influence = match (&self.influence, &given.influence) {
            (InfluenceSource::Runs { after, runs }, InfluenceSourceGiven::Runs { runs: given, .. }) => {
                let run = |(run, given): (&TrialRunInput, &TrialRunInputGiven<W>)| WorkedRun {
                    plane: run.plane - 1,
                    mass: given.mass,
                    angle: given.angle,
                    readings: readings(&run.readings, &given.readings),
                };
                Influence::Runs {
                    stay: *after == TrialWeights::Stay,
                    runs: runs.iter().zip(given).map(run).collect(),
                }
            }
            (InfluenceSource::Known { coefficients }, _) => Influence::Known(
                coefficients.iter().map(|c| (c.plane, c.reading, c.size.si, c.angle)).collect(),
            ),
            (InfluenceSource::Runs { .. }, InfluenceSourceGiven::Known { .. }) => {
                Influence::Known(Vec::new())
            }
        };
        Job { units: Units { reading, coefficient }, first: readings(&self.first, &given.first), influence }
    }
}

fn readings<W: Worksheet>(
    own: &[SensorReading],
    given: &[SensorReadingGiven<W>],
) -> Vec<WorkedReading<W::Num>> {
    let reading = |(own, given): (&SensorReading, &SensorReadingGiven<W>)| WorkedReading {
        amplitude: given.amplitude,
        phase: given.phase,
        speed: own.speed,
    };
    own.iter().zip(given).map(reading).collect()
}
