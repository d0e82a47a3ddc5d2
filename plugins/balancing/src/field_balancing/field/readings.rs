//! Measured readings, in the unit of the measurement.

use dalembert_core::{Inputs, Worksheet};

/// Writes down the inputs of a job whose readings are of one kind; only symbols and units differ.
macro_rules! kind_of_reading {
    ($reading:ident, $run:ident, $influence:ident, $coefficient:ident, $given_reading:ident, $given_run:ident,
     $given_influence:ident,
     $unit:tt, $per:tt, $kind:tt) => {
        /// Reading of a sensor at a speed.
        #[derive(Clone, Debug, Inputs)]
        pub struct $reading {
            /// Amplitude.
            /// Of the component at the speed of rotation; all readings alike, peak, peak to peak or rms.
            #[input("A", $unit, nonnegative, kind = $kind)]
            pub amplitude: f64,
            /// Phase.
            /// As the instrument shows it.
            #[input("φ", "deg")]
            pub phase: f64,
            /// Speed.
            /// Where it is given, every run must have it in the same row.
            #[input("n", "rpm", positive)]
            pub speed: Option<f64>,
        }

        /// A run with a trial weight.
        #[derive(Clone, Debug, Inputs)]
        pub struct $run {
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
            pub readings: Vec<$reading>,
        }

        /// Influence of the correction planes on the sensors.
        #[derive(Clone, Debug, Inputs)]
        pub enum $influence {
            /// Runs with trial weights
            Runs {
                /// Trial weights.
                after: TrialWeights,
                /// Runs.
                /// At least one for each plane.
                #[input(min = 1)]
                runs: Vec<$run>,
            },
            /// Influence coefficients known
            /// The table of an earlier job, for a trim run without trial weights.
            Known {
                /// Coefficients.
                /// A row for each plane and each reading, both numbered from 1.
                #[input(table)]
                coefficients: Vec<$coefficient>,
            },
        }

        /// An influence coefficient.
        #[derive(Clone, Debug, Inputs)]
        pub struct $coefficient {
            /// Plane.
            #[input("p", "1", positive)]
            pub plane: f64,
            /// Reading.
            #[input("s", "1", positive)]
            pub reading: f64,
            /// Coefficient.
            /// Vibration over weight.
            #[input("α", $per, nonnegative)]
            pub size: f64,
            /// Angle of the coefficient.
            /// Angle of the vibration minus that of the weight, both in the sense of the trial-weight angles.
            #[input("β", "deg")]
            pub angle: f64,
        }

        impl $reading {
            fn plain<W: Worksheet>(&self, given: &$given_reading<W>) -> Reading<W::Num> {
                Reading { amplitude: given.amplitude, phase: given.phase, speed: self.speed }
            }
        }

        impl $run {
            fn plain<W: Worksheet>(&self, given: &$given_run<W>) -> Run<W::Num> {
                let readings = self.readings.iter().zip(&given.readings);
                Run {
                    plane: self.plane - 1,
                    mass: given.mass,
                    angle: given.angle,
                    readings: readings.map(|(reading, given)| reading.plain(given)).collect(),
                }
            }
        }

        impl $influence {
            fn plain<W: Worksheet>(&self, given: &$given_influence<W>) -> Influence<W::Num> {
                match (self, given) {
                    ($influence::Runs { after, runs }, $given_influence::Runs { runs: given, .. }) => {
                        Influence::Runs {
                            stay: *after == TrialWeights::Stay,
                            runs: runs.iter().zip(given).map(|(run, given)| run.plain(given)).collect(),
                        }
                    }
                    ($influence::Known { coefficients }, _) => Influence::Known(
                        coefficients.iter().map(|c| (c.plane, c.reading, c.size, c.angle)).collect(),
                    ),
                    ($influence::Runs { .. }, $given_influence::Known { .. }) => Influence::Known(Vec::new()),
                }
            }
        }
    };
}

kind_of_reading!(
    DisplacementReading,
    DisplacementRun,
    DisplacementInfluence,
    DisplacementCoefficient,
    DisplacementReadingGiven,
    DisplacementRunGiven,
    DisplacementInfluenceGiven,
    "um",
    "um/g",
    "Amplitude"
);
kind_of_reading!(
    VelocityReading,
    VelocityRun,
    VelocityInfluence,
    VelocityCoefficient,
    VelocityReadingGiven,
    VelocityRunGiven,
    VelocityInfluenceGiven,
    "mm/s",
    "mm/(s*g)",
    "Velocity"
);
kind_of_reading!(
    AccelerationReading,
    AccelerationRun,
    AccelerationInfluence,
    AccelerationCoefficient,
    AccelerationReadingGiven,
    AccelerationRunGiven,
    AccelerationInfluenceGiven,
    "m/s^2",
    "m/(s^2*g)",
    "Acceleration"
);
kind_of_reading!(
    NumberReading,
    NumberRun,
    NumberInfluence,
    NumberCoefficient,
    NumberReadingGiven,
    NumberRunGiven,
    NumberInfluenceGiven,
    "1",
    "1/g",
    "Ratio"
);

/// Measured quantity.
#[derive(Clone, Debug, Inputs)]
pub enum Measured {
    /// Displacement
    Displacement {
        /// Initial run, without trial weights.
        /// A row for each sensor, and for each speed where there are several.
        #[input("0", min = 1)]
        first: Vec<DisplacementReading>,
        /// Influence of the planes.
        influence: DisplacementInfluence,
    },
    /// Velocity
    Velocity {
        /// Initial run, without trial weights.
        /// A row for each sensor, and for each speed where there are several.
        #[input("0", min = 1)]
        first: Vec<VelocityReading>,
        /// Influence of the planes.
        influence: VelocityInfluence,
    },
    /// Acceleration
    Acceleration {
        /// Initial run, without trial weights.
        /// A row for each sensor, and for each speed where there are several.
        #[input("0", min = 1)]
        first: Vec<AccelerationReading>,
        /// Influence of the planes.
        influence: AccelerationInfluence,
    },
    /// Numbers without a unit: divisions, volts
    Number {
        /// Initial run, without trial weights.
        /// A row for each sensor, and for each speed where there are several.
        #[input("0", min = 1)]
        first: Vec<NumberReading>,
        /// Influence of the planes.
        influence: NumberInfluence,
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

/// A reading, whatever its kind.
pub(super) struct Reading<N> {
    pub(super) amplitude: N,
    pub(super) phase: N,
    pub(super) speed: Option<f64>,
}

/// A run, whatever the kind of its readings.
pub(super) struct Run<N> {
    /// Counted from 0.
    pub(super) plane: usize,
    pub(super) mass: N,
    pub(super) angle: N,
    pub(super) readings: Vec<Reading<N>>,
}

/// Source of the influence coefficients: trial runs or known values.
pub(super) enum Influence<N> {
    Runs {
        stay: bool,
        runs: Vec<Run<N>>,
    },
    /// Plane and reading counted from 1, size, angle.
    Known(Vec<(f64, f64, f64, f64)>),
}

/// All that was measured, whatever its kind.
pub(super) struct Job<N> {
    pub(super) units: Units,
    pub(super) first: Vec<Reading<N>>,
    pub(super) influence: Influence<N>,
}

/// The units of readings and coefficients.
#[derive(Clone, Copy)]
pub(super) struct Units {
    pub(super) reading: &'static str,
    pub(super) coefficient: &'static str,
}

impl Measured {
    /// The readings as numbers of a worksheet.
    pub(super) fn plain<W: Worksheet>(&self, given: &MeasuredGiven<W>) -> Option<Job<W::Num>> {
        macro_rules! job {
            ($first:expr, $given_first:expr, $influence:expr, $given_influence:expr, $reading:literal, $per:literal) => {
                Job {
                    units: Units { reading: $reading, coefficient: $per },
                    first: $first
                        .iter()
                        .zip($given_first)
                        .map(|(reading, given)| reading.plain(given))
                        .collect(),
                    influence: $influence.plain($given_influence),
                }
            };
        }
        Some(match (self, given) {
            (
                Measured::Displacement { first, influence },
                MeasuredGiven::Displacement { first: a, influence: b },
            ) => job!(first, a, influence, b, "um", "um/g"),
            (Measured::Velocity { first, influence }, MeasuredGiven::Velocity { first: a, influence: b }) => {
                job!(first, a, influence, b, "mm/s", "mm/(s*g)")
            }
            (
                Measured::Acceleration { first, influence },
                MeasuredGiven::Acceleration { first: a, influence: b },
            ) => job!(first, a, influence, b, "m/s^2", "m/(s^2*g)"),
            (Measured::Number { first, influence }, MeasuredGiven::Number { first: a, influence: b }) => {
                job!(first, a, influence, b, "1", "1/g")
            }
            _ => return None,
        })
    }
}
