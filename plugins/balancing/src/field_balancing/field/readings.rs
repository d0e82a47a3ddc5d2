//! Measured readings, in the unit of the measurement.

use dalembert_core::{Inputs, MeasuredQuantity, Refusal, Symbol, Text, Worksheet};
use dalembert_mechanics::{Real, balance::Phasor};

use crate::{
    shared::{
        reading::{SensorReading, SensorReadingGiven},
        rotor,
    },
    sources::EZ_BALANCE,
};

/// Readings without and with trial weights.
#[derive(Clone, Debug, Inputs)]
pub struct Measurements {
    /// Initial run, without trial weights.
    /// A row for each sensor, and for each speed where there are several.
    #[input("0", min = 1)]
    pub first: Vec<SensorReading>,
    /// Influence of the planes.
    pub influence: InfluenceSource,
    /// Slow-roll readings.
    /// Run-out of the shaft under each sensor, read far below the first critical speed; one for each reading of the initial
    /// run, in the same order. Subtracted as a vector from all readings of that sensor; omit it for sensors on the casing.
    #[input("s")]
    pub slow_roll: Vec<SlowRollReading>,
    /// Check runs.
    /// With the corrections in place, one after another: the last one gives the residual unbalance and the trim.
    pub checks: Vec<CheckRun>,
}

/// A run with the corrections in place.
#[derive(Clone, Debug, Inputs)]
pub struct CheckRun {
    /// Readings.
    /// The same sensors and speeds in the same order as in the initial run.
    #[input("k", min = 1)]
    pub readings: Vec<SensorReading>,
}

/// Reading of a sensor at slow roll.
#[derive(Clone, Debug, Inputs)]
pub struct SlowRollReading {
    /// Amplitude.
    /// Zero for a sensor without run-out.
    #[input("A", "um | mm/s | m/s^2 | 1", nonnegative, kind = "Amplitude|Velocity|Acceleration|Ratio")]
    pub amplitude: MeasuredQuantity,
    /// Phase.
    /// As the instrument shows it.
    #[input("φ", "deg")]
    pub phase: f64,
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
    /// No trial run yet
    /// The initial run is evaluated, and a trial weight proposed.
    NotYet,
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
#[derive(Clone, Copy)]
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
    NotYet,
}

/// All that was measured as numbers of a worksheet.
pub(super) struct Job<N> {
    pub(super) units: Units,
    pub(super) first: Vec<WorkedReading<N>>,
    /// The initial run with the run-out in it, where that is subtracted.
    pub(super) raw: Option<Vec<WorkedReading<N>>>,
    pub(super) influence: Influence<N>,
    pub(super) checks: Vec<Vec<WorkedReading<N>>>,
}

/// The units of readings and coefficients.
#[derive(Clone, Copy)]
pub(super) struct Units {
    pub(super) reading: &'static str,
    pub(super) coefficient: &'static str,
}

impl Measurements {
    /// The measurements as numbers of a worksheet, without run-out.
    ///
    /// # Errors
    /// Slow-roll readings that are not as many as the readings.
    pub(super) fn job<W: Worksheet>(
        &self,
        given: &MeasurementsGiven<W>,
        sheet: W,
    ) -> Result<Job<W::Num>, Refusal> {
        let reading = self.first.first().map_or("1", |reading| reading.amplitude.unit);
        let coefficient = match reading {
            "um" => "um/g",
            "mm/s" => "mm/(s*g)",
            "m/s^2" => "m/(s^2*g)",
            _ => "1/g",
        };
        let run_out = RunOut::of(given, self.first.len())?;
        let mut influence = match (&self.influence, &given.influence) {
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
            (InfluenceSource::NotYet, _) => Influence::NotYet,
            (InfluenceSource::Runs { .. }, _) => Influence::Known(Vec::new()),
        };
        let mut first = readings(&self.first, &given.first);
        let check = |(own, given): (&CheckRun, &CheckRunGiven<W>)| readings(&own.readings, &given.readings);
        let mut checks: Vec<_> = self.checks.iter().zip(&given.checks).map(check).collect();
        let raw = run_out.is_some().then(|| first.clone());
        if let Some(run_out) = run_out {
            for (n, found) in (1..).zip(run_out.taken_from(&mut first, None, reading, sheet)) {
                sheet.answer(("compensated", n), "Reading without run-out", found.amplitude);
                sheet.answer(("compensated_phase", n), "Phase of the reading without run-out", found.phase);
            }
            let mut trials = 0;
            if let Influence::Runs { runs, .. } = &mut influence {
                trials = runs.len();
                for (run, worked) in (1..).zip(runs) {
                    run_out.taken_from(&mut worked.readings, Some(run), reading, sheet);
                }
            }
            for (run, readings) in (trials + 1..).zip(&mut checks) {
                run_out.taken_from(readings, Some(run), reading, sheet);
            }
        }
        Ok(Job { units: Units { reading, coefficient }, first, raw, influence, checks })
    }
}

/// Slow-roll vectors of the sensors: amplitude and phase.
struct RunOut<N>(Vec<(N, N)>);

impl<N: Real> RunOut<N> {
    fn of<W: Worksheet<Num = N>>(
        given: &MeasurementsGiven<W>,
        readings: usize,
    ) -> Result<Option<Self>, Refusal> {
        let vectors: Vec<_> = given.slow_roll.iter().map(|slow| (slow.amplitude, slow.phase)).collect();
        if vectors.is_empty() {
            return Ok(None);
        }
        if vectors.len() != readings {
            return Err(Refusal::because(
                Text::new(
                    "{have} slow-roll readings are given and {want} readings in the initial run; enter one for each, zero for a sensor without run-out",
                )
                .with("have", vectors.len())
                .with("want", readings),
            ));
        }
        Ok(Some(RunOut(vectors)))
    }

    /// Subtracts the vectors from the readings of a run, the initial one or a numbered one.
    fn taken_from<W: Worksheet<Num = N>>(
        &self,
        readings: &mut [WorkedReading<N>],
        run: Option<usize>,
        unit: &'static str,
        sheet: W,
    ) -> Vec<WorkedReading<N>> {
        for (n, (reading, (amplitude, phase))) in (1..).zip(readings.iter_mut().zip(&self.0)) {
            if amplitude.value() == 0.0 {
                continue;
            }
            let symbol = |base: &'static str| {
                let symbol = Symbol::from(base);
                run.map_or(symbol, |run| symbol.row(run)).row(n)
            };
            let shown = *reading;
            let left = Phasor::polar(shown.amplitude, shown.phase).minus(Phasor::polar(*amplitude, *phase));
            let why =
                ("Reading without run-out: the slow-roll vector is subtracted", EZ_BALANCE.at("p. 4-4"));
            let what = "the slow-roll amplitude subtracted as a number, its phase ignored";
            sheet.common_error(symbol("A_c"), what, || (shown.amplitude - *amplitude).abs());
            reading.amplitude = sheet.step(symbol("A_c"), unit, left.size(), why);
            rotor::quadrant_ignored(sheet, symbol("φ_c"), (left.x, left.y));
            reading.phase =
                sheet.step(symbol("φ_c"), "deg", left.marked_angle(), "Phase of the reading without run-out");
            sheet.verify(|| {
                let size = (shown.amplitude.value() + amplitude.value()).powi(2);
                let between = (shown.phase - *phase).cos();
                sheet.check_sum(
                    "square of the reading without run-out by the law of cosines",
                    reading.amplitude.powi(2),
                    shown.amplitude.powi(2) + amplitude.powi(2)
                        - shown.amplitude * *amplitude * between * 2.0,
                    size,
                );
                sheet.check_sum(
                    "slow-roll vector and the reading without it, across the reading",
                    *amplitude * (*phase - shown.phase).sin(),
                    -(reading.amplitude * (reading.phase - shown.phase).sin()),
                    size.sqrt(),
                );
            });
        }
        readings.to_vec()
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
