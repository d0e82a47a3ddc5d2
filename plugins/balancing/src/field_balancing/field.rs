//! Field balancing by influence coefficients: any number of planes, sensors and speeds.

use dalembert_core::{About, Analysis, Inputs, MeasuredQuantity, Refusal, Text, Worksheet, register};
use dalembert_mechanics::{
    Real,
    balance::{
        self,
        influence::{self, InfluenceError},
        minimax::min_max,
        spread::{Choice, ReadingSpread},
    },
};
use dalembert_numerics::linalg::LinalgError;
use nalgebra::{Complex, DMatrix};
use std::f64::consts::PI;

mod checks;
mod initial;
mod limits;
mod numbers;
mod positions;
mod ranges;
mod readings;
mod rotor;
mod show;
mod view;
mod worked;

use self::{
    numbers::Numbers,
    positions::SplitMass,
    ranges::ranges,
    readings::{Influence, Job},
};
pub use self::{
    positions::Positions,
    readings::{CheckRun, InfluenceSource, KnownCoefficient, Measurements, TrialRunInput, TrialWeights},
    rotor::{Requirement, Rotor},
    view::{Rotation, RotorEnd, RotorView, SensorPosition},
};

use crate::{
    shared::rotor::by_pairs,
    sources::{BOYD, BRUEL_KJAER, DARLOW, GOODMAN, ISO_TOLERANCES, RAO, WOWK},
};

/// Runs, conventions, and how the weights are chosen.
#[derive(Clone, Debug, Inputs)]
pub struct Field {
    /// Measured quantity.
    #[input(formerly = "displacement|velocity|acceleration|number")]
    pub measured: Measurements,
    /// Phase.
    /// Phase convention of the instrument; with a strobe and a protractor on the rotor, use lead.
    pub phase: PhaseSense,
    /// Angles of weights.
    /// Measured from the phase reference mark. The positions of the sensors do not matter: their angles cancel.
    pub angles: WeightSense,
    /// Rotor as it is seen.
    /// For the pictures, the high spots and the angles from the mark; the corrections do not depend on it.
    pub view: Option<RotorView>,
    /// Rotor and requirement.
    /// For the trial weight and the tolerance; the corrections do not depend on it.
    pub rotor: Option<Rotor>,
    /// Positions for weights.
    /// If there are holes, bolts or blades, the masses are split between two of them.
    pub positions: Option<Positions>,
    /// Method for the correction masses.
    pub method: Method,
    /// Radius of the weights.
    /// The same for trial weights and corrections; if given, the unbalances are calculated too.
    #[input("r", "mm", positive)]
    pub radius: Option<f64>,
    /// Uncertainty of an amplitude.
    /// Relative standard uncertainty: scatter of repeated runs.
    #[input("u_A", "%", nonnegative, max = 50.0, default = "1 %")]
    pub amplitude_uncertainty: f64,
    /// Uncertainty of a phase.
    /// Standard uncertainty.
    #[input("u_φ", "deg", nonnegative, max = 45.0, default = "1 deg")]
    pub phase_uncertainty: f64,
}

/// The sense in which the instrument counts the phase.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Inputs)]
pub enum PhaseSense {
    /// Lead: it grows when the weight is moved with the rotation
    Lead,
    /// Lag: it grows when the weight is moved against the rotation
    Lag,
}

/// The sense in which the angles of weights are counted.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Inputs)]
pub enum WeightSense {
    /// With the rotation
    With,
    /// Against the rotation
    Against,
}

/// Method for the correction masses.
#[derive(Clone, Debug, Inputs)]
pub enum Method {
    /// Least squares of all readings
    LeastSquares,
    /// Least squares with weighting factors
    Weighted {
        /// Factors.
        /// One for each reading of the initial run, in the same order.
        #[input(min = 1)]
        factors: Vec<Factor>,
    },
    /// Minimax: the largest reading is minimised
    MinMax {
        /// Maximum correction mass per plane.
        #[input("m_max", "g", positive)]
        limit: Option<f64>,
    },
    /// Minimax of readings over their limits
    /// For sensors of unequal importance: the reading nearest to its limit, or farthest above it, is minimised.
    Limits {
        /// Limits.
        /// Permissible vibration of each reading of the initial run, in the same order.
        #[input(min = 1)]
        limits: Vec<ReadingLimit>,
        /// Maximum correction mass per plane.
        #[input("m_max", "g", positive)]
        limit: Option<f64>,
    },
}

/// Limit of a reading.
#[derive(Clone, Debug, Inputs)]
pub struct ReadingLimit {
    /// Limit.
    /// In the unit of the readings, peak, peak to peak or rms as these.
    #[input("A_l", "um | mm/s | m/s^2 | 1", positive, kind = "Amplitude|Velocity|Acceleration|Ratio")]
    pub limit: MeasuredQuantity,
}

/// Weighting factor of a reading.
#[derive(Clone, Debug, Inputs)]
pub struct Factor {
    /// Weighting factor.
    #[input("g", "1", positive)]
    pub factor: f64,
}

register!(Field);

/// The weight of a plane on a worksheet.
#[derive(Clone, Copy)]
struct Found<N> {
    mass: N,
    angle: N,
}

impl Analysis for Field {
    const ABOUT: About = About {
        id: "balancing/field",
        title: "Field balancing",
        topic: "Field balancing",
        summary: "Correction masses from measured vibrations, by influence coefficients: runs with trial weights, any number of planes, sensors and speeds, with uncertainties.",
        main: &[
            "conformity",
            "correction",
            "correction_angle",
            "trim",
            "trim_angle",
            "trim_correction",
            "trim_correction_angle",
            "trial_mass",
            "largest_residual",
        ],
        keywords: "balanceamento em campo balanceamento no local coeficientes de influência peso de prova massa \
                   de teste influence coefficients trial weight single plane two plane least squares min-max \
                   trim vector fase balancear ventilador exaustor ventoinha rebolo turbina fan balancing blower \
                   in situ on site check run residual unbalance corrida de verificação desbalanceamento residual \
                   heavy spot ponto pesado massa de prova runout batimento",
        sources: &[&RAO, &GOODMAN, &DARLOW, &BOYD, &ISO_TOLERANCES, &WOWK, &BRUEL_KJAER],
        cases: include_str!("../../cases/field.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &FieldGiven<W>, sheet: W) -> Result<(), Refusal> {
        let job = self.measured.job(&given.measured, sheet)?;
        let opposed = (self.phase == PhaseSense::Lag) != (self.angles == WeightSense::Against);
        let spread = ReadingSpread { amplitude: self.amplitude_uncertainty, phase: self.phase_uncertainty };
        let demand = match (&self.rotor, &given.rotor) {
            (Some(rotor), Some(given_rotor)) => Some(rotor::demand(rotor, given_rotor, given.radius, sheet)),
            _ => None,
        };
        if let (Some(view), Some(given)) = (&self.view, &given.view) {
            view::high_spots(view, given, (&job.first, opposed, self.angles), sheet)?;
        }
        if let Influence::NotYet = job.influence {
            return initial::evaluate(self, (&job, opposed), demand.as_ref(), sheet);
        }
        let numbers = Numbers::new(&job, opposed, spread, sheet)?;
        let factors = self.factors(numbers.first.len())?;
        let limits = self.limits(numbers.first.len())?;
        let squares = influence::least_squares(&numbers.alpha, &numbers.first, &factors)
            .map_err(|error| refusal(error, &numbers.alpha))?;
        numbers.assess_planes(squares.condition, spread, sheet)?;

        let corrections = match &self.method {
            Method::MinMax { limit } | Method::Limits { limit, .. } => {
                self.min_max(&numbers, &limits, *limit, sheet)?
            }
            _ => {
                let corrections = match worked::solve(&job, opposed, sheet) {
                    Some(corrections) => corrections,
                    None => self.by_least_squares(&squares, sheet),
                };
                for (n, (found, kernel)) in (1..).zip(corrections.iter().zip(&squares.weights)) {
                    let apart = Complex::from_polar(found.mass.value(), found.angle.value()) - kernel;
                    sheet.check_zero(
                        Text::new("correction mass of plane {n} from all equations simultaneously, by orthogonal factorisation")
                            .with("n", n),
                        apart.norm().into(),
                        squares.weights.iter().map(|w| w.norm()).fold(0.0, f64::max),
                    );
                }
                orthogonal(&numbers.alpha, &squares.residuals, &numbers.first, &factors, sheet);
                corrections
            }
        };
        let weights: Vec<Complex<f64>> =
            corrections.iter().map(|w| Complex::from_polar(w.mass.value(), w.angle.value())).collect();
        self.answers(&corrections, given.radius, &numbers, &factors, sheet);
        if let Some(view) = &given.view {
            for (n, found) in (1..).zip(&corrections) {
                view::from_mark(view, self.angles, (n, found.angle), sheet);
            }
        }
        let added = trim(&numbers, &weights, sheet);
        let checked = checks::assess(
            (&numbers, &factors),
            (&job.checks, opposed, job.units),
            (demand.as_ref(), given.radius),
            sheet,
        )?;
        if let (Some(positions), Some(given)) = (&self.positions, &given.positions) {
            let next = match (checked, added) {
                (Some(checked), _) => (SplitMass::Trim, checked.trim),
                (None, Some(added)) => (SplitMass::Added, added),
                (None, None) => (SplitMass::Correction, corrections),
            };
            positions::split(positions, given, (next.0, &next.1), sheet);
        }
        let left = self.predict(&numbers, &weights, job.units.reading, sheet);
        if let Method::Limits { .. } = self.method {
            limits::nearest(&numbers, &weights, &limits, sheet);
        }
        if numbers.alpha.ncols() > 1 {
            condition(squares.condition, &numbers, &factors, sheet);
        }
        sheet.verify(|| {
            let choice = match self.method {
                Method::MinMax { limit } | Method::Limits { limit, .. } => Choice::MinMax(limit),
                _ => Choice::LeastSquares(&factors),
            };
            ranges((&numbers, &limits), choice, spread, &weights, job.units.reading, sheet);
        });
        show::all(self, (&numbers, &factors), (&weights, &left), job.units, sheet);
        Ok(())
    }
}

impl Field {
    /// A vector on the scale of the weights as it is drawn: as the rotor is seen, or counter-clockwise from the right.
    fn seen(&self, vector: Complex<f64>) -> Complex<f64> {
        self.view.as_ref().map_or(vector, |view| view.seen(self.angles, vector))
    }

    fn factors(&self, readings: usize) -> Result<Vec<f64>, Refusal> {
        match &self.method {
            Method::Weighted { factors } if factors.len() != readings => Err(Refusal::because(
                Text::new(
                    "{have} weighting factors are given and {want} readings in the initial run; enter one for each",
                )
                .with("have", factors.len())
                .with("want", readings),
            )),
            Method::Weighted { factors } => {
                // Only their ratios matter.
                let largest = factors.iter().map(|f| f.factor).fold(0.0, f64::max);
                Ok(factors.iter().map(|f| f.factor / largest).collect())
            }
            _ => Ok(vec![1.0; readings]),
        }
    }

    /// The limits of the readings; all one where none are given.
    fn limits(&self, readings: usize) -> Result<Vec<f64>, Refusal> {
        let Method::Limits { limits, .. } = &self.method else { return Ok(vec![1.0; readings]) };
        if limits.len() != readings {
            return Err(Refusal::because(
                Text::new(
                    "{have} limits are given and {want} readings in the initial run; enter one for each",
                )
                .with("have", limits.len())
                .with("want", readings),
            ));
        }
        Ok(limits.iter().map(|limit| limit.limit.si).collect())
    }

    fn by_least_squares<W: Worksheet>(&self, solved: &influence::Weights, sheet: W) -> Vec<Found<W::Num>> {
        let how = match self.method {
            Method::Weighted { .. } => {
                "Correction mass that minimises the weighted sum of squares of all readings"
            }
            _ => "Correction mass that minimises the sum of squares of all readings",
        };
        let found = |(n, weight): (usize, &Complex<f64>)| Found {
            mass: sheet.numerical(("m_c", n), "g", weight.norm(), (how, GOODMAN.at("pp. 273–277"))),
            angle: sheet.numerical(
                ("θ_c", n),
                "deg",
                balance::marked_angle_found(weight.arg()),
                "Its angle from the mark",
            ),
        };
        (1..).zip(&solved.weights).map(found).collect()
    }

    fn min_max<W: Worksheet>(
        &self,
        numbers: &Numbers,
        limits: &[f64],
        limit: Option<f64>,
        sheet: W,
    ) -> Result<Vec<Found<W::Num>>, Refusal> {
        let over = numbers.over(limits);
        let solved =
            min_max(&over.alpha, &over.first, limit).map_err(|error| refusal(error, &numbers.alpha))?;
        let how = match self.method {
            Method::Limits { .. } => {
                "Correction mass that minimises the largest ratio of a reading to its limit, by a second-order-cone barrier method"
            }
            _ => "Correction mass that minimises the largest reading, by a second-order-cone barrier method",
        };
        let how = (how, BOYD.at("§11.6"));
        let found = |(n, weight): (usize, &Complex<f64>)| Found {
            mass: sheet.numerical(("m_c", n), "g", weight.norm(), how),
            angle: sheet.numerical(
                ("θ_c", n),
                "deg",
                balance::marked_angle_found(weight.arg()),
                "Its angle from the mark",
            ),
        };
        let corrections = (1..).zip(&solved.weights).map(found).collect();
        sheet.check_zero(
            "lower bound of the largest reading for the permitted masses, from the multipliers",
            (solved.largest - solved.bound).into(),
            over.first.iter().map(|v| v.norm()).fold(0.0, f64::max),
        );
        Ok(corrections)
    }

    /// Correction and existing unbalance, each with its angle.
    fn answers<W: Worksheet>(
        &self,
        corrections: &[Found<W::Num>],
        radius: Option<W::Num>,
        numbers: &Numbers,
        factors: &[f64],
        sheet: W,
    ) {
        let mut existing = Vec::new();
        let estimated = !matches!(self.method, Method::MinMax { .. } | Method::Limits { .. });
        for (n, found) in (1..).zip(corrections) {
            sheet.answer(("correction", n), "Correction mass in plane", found.mass);
            sheet.answer(("correction_angle", n), "Angle of the correction in plane", found.angle);
            if estimated {
                let angle = found.angle.value();
                let opposite = if angle < PI { found.angle + PI } else { found.angle - PI };
                let angle = sheet.step(
                    ("θ_e", n),
                    "deg",
                    opposite,
                    "The initial unbalance is opposite to the correction",
                );
                sheet.answer(("existing_angle", n), "Angular position of the heavy spot in plane", angle);
                existing.push(Complex::from_polar(found.mass.value(), angle.value()));
            }
            if let Some(radius) = radius {
                let unbalance = sheet.step(
                    ("U", n),
                    "g*mm",
                    found.mass * radius,
                    "Unbalance of the correction: mass times radius",
                );
                sheet.answer(("unbalance", n), "Unbalance of the correction in plane", unbalance);
            }
        }
        if !estimated {
            return;
        }
        sheet.verify(|| {
            // What the existing unbalances do not explain of the first readings is what the corrections leave.
            let weights: Vec<Complex<f64>> = existing.iter().map(|w| -w).collect();
            let left = influence::residuals(&numbers.alpha, &numbers.first, &weights);
            for plane in 0..numbers.alpha.ncols() {
                let product: Complex<f64> = (numbers.alpha.column(plane).iter().zip(&left).zip(factors))
                    .map(|((a, r), g)| a.conj() * r * *g)
                    .sum();
                let size: f64 = (numbers.alpha.column(plane).iter().enumerate().zip(factors))
                    .map(|((row, a), g)| g * a.norm() * numbers.reach(row, &weights))
                    .sum();
                sheet.check_zero(
                    Text::new("residual of the initial-unbalance fit is orthogonal to the influence vector of plane {n}")
                        .with("n", plane + 1),
                    product.norm().into(),
                    size,
                );
            }
        });
    }

    /// Predicts the readings of the sensors.
    fn predict<W: Worksheet>(
        &self,
        numbers: &Numbers,
        weights: &[Complex<f64>],
        unit: &'static str,
        sheet: W,
    ) -> Vec<Complex<f64>> {
        let size = numbers.first.iter().map(|v| v.norm()).fold(0.0, f64::max);
        let mut left = influence::residuals(&numbers.alpha, &numbers.first, weights);
        // As many planes as readings leave nothing but rounding.
        left.iter_mut().filter(|r| r.norm() < 1e-9 * size).for_each(|r| *r = Complex::ZERO);
        let sizes: Vec<f64> = left.iter().map(|r| r.norm()).collect();
        let largest = sizes.iter().copied().fold(0.0, f64::max);
        let mean = size * (sizes.iter().map(|r| (r / size).powi(2)).sum::<f64>() / sizes.len() as f64).sqrt();
        let largest = sheet.numerical(
            "r_max",
            unit,
            largest,
            "Maximum predicted residual vibration: initial reading plus influence coefficients times corrections",
        );
        let mean =
            sheet.numerical("r_rms", unit, mean, "Root mean square of all predicted residual readings");
        sheet.answer("largest_residual", "Maximum predicted residual vibration", largest);
        // As many planes as readings leave nothing: one line states it.
        let leaves = left.len() > weights.len();
        if leaves {
            sheet.answer("rms_residual", "RMS of the predicted residual vibration", mean);
        }
        sheet.verify(|| {
            let (mut most, mut sum, mut reach) = (0.0f64, 0.0, 0.0f64);
            for (row, (reading, kept)) in numbers.first.iter().zip(&left).enumerate() {
                let mut vectors = vec![(reading.norm(), reading.arg())];
                for (plane, weight) in weights.iter().enumerate() {
                    let influence = numbers.alpha[(row, plane)];
                    vectors.push((influence.norm() * weight.norm(), influence.arg() + weight.arg()));
                }
                let (squared, scale) = by_pairs(&vectors);
                reach = reach.max(scale);
                if *kept != Complex::ZERO {
                    most = most.max(squared);
                    sum += squared;
                }
            }
            let what = "squares of the predicted readings by the law of cosines over readings and effects";
            sheet.check_sum(what, largest.powi(2), most.into(), reach);
            sheet.check_sum(what, mean.powi(2), (sum / left.len() as f64).into(), reach);
        });
        if leaves {
            sheet.answer_list("residual", "Predicted residual vibration", unit, &sizes);
        }
        left
    }
}

fn refusal(error: InfluenceError, alpha: &DMatrix<Complex<f64>>) -> Refusal {
    match error {
        InfluenceError::TooFewReadings { readings, planes } => Refusal::because(
            Text::new(
                "{readings} readings cannot determine the weights of {planes} planes; read more sensors or speeds, or correct in fewer planes",
            )
            .with("readings", readings)
            .with("planes", planes),
        ),
        InfluenceError::NoTrial { plane } => Refusal::because(
            Text::new("no run has a trial weight in plane {plane}; make one, or number the planes without gaps")
                .with("plane", plane),
        ),
        InfluenceError::Linalg(LinalgError::Singular { .. }) => numbers::alike(alpha),
        InfluenceError::Linalg(_) => {
            Refusal::because("the readings or weights are beyond the range of numbers that can be balanced")
        }
    }
}

/// The residuals of least squares are perpendicular to what every plane can do.
fn orthogonal<W: Worksheet>(
    alpha: &DMatrix<Complex<f64>>,
    left: &[Complex<f64>],
    first: &[Complex<f64>],
    factors: &[f64],
    sheet: W,
) {
    for plane in 0..alpha.ncols() {
        let product = |with: &[Complex<f64>]| -> (Complex<f64>, f64) {
            let terms = || {
                alpha
                    .column(plane)
                    .iter()
                    .zip(with)
                    .zip(factors)
                    .map(|((a, r), g)| a.conj() * r * *g)
                    .collect::<Vec<_>>()
            };
            (terms().iter().sum(), terms().iter().map(|term| term.norm()).sum())
        };
        sheet.check_zero(
            Text::new("the residual is orthogonal to the influence vector of plane {n}").with("n", plane + 1),
            product(left).0.norm().into(),
            product(first).1,
        );
    }
}

/// The weights to add where the trial weights are still on the rotor.
fn trim<W: Worksheet>(numbers: &Numbers, weights: &[Complex<f64>], sheet: W) -> Option<Vec<Found<W::Num>>> {
    if !numbers.stay {
        return None;
    }
    let mut found = Vec::new();
    let mut added = Vec::new();
    for (plane, weight) in weights.iter().enumerate() {
        let on: Complex<f64> =
            numbers.runs.iter().filter(|run| run.plane == plane).map(|run| run.weight).sum();
        let trim = weight - on;
        let n = plane + 1;
        let mass = sheet.numerical(
            ("m_a", n),
            "g",
            trim.norm(),
            "Mass to add with all trial weights retained: the correction minus the trial weights in this plane",
        );
        let angle = sheet.numerical(
            ("θ_a", n),
            "deg",
            balance::marked_angle_found(trim.arg()),
            "Its angle from the mark",
        );
        sheet.answer(("trim", n), "Mass to add with the trial weights retained, plane", mass);
        sheet.answer(("trim_angle", n), "Angle of the mass to add, plane", angle);
        added.push(Complex::from_polar(mass.value(), angle.value()));
        found.push(Found { mass, angle });
    }
    sheet.verify(|| {
        let planes: Vec<usize> = numbers.runs.iter().map(|run| run.plane).collect();
        let alone = planes.iter().enumerate().all(|(n, plane)| !planes[..n].contains(plane));
        // Of planes with one run each the coefficients give the last readings back.
        let Some(last) = numbers.runs.last().filter(|_| alone) else { return };
        let left = influence::residuals(&numbers.alpha, &numbers.first, weights);
        let again = influence::residuals(&numbers.alpha, &last.readings, &added);
        for (row, (left, again)) in left.iter().zip(&again).enumerate() {
            let size = last.readings[row].norm() + numbers.reach(row, weights) + numbers.reach(row, &added);
            let what = "last readings with all trial weights retained, and the masses to add";
            sheet.check_zero(what, (left - again).norm().into(), size);
        }
    });
    Some(found)
}

fn condition<W: Worksheet>(condition: f64, numbers: &Numbers, factors: &[f64], sheet: W) {
    let how =
        "Condition number of the influence coefficients: maximum amplification of errors of the readings";
    let condition = sheet.numerical("κ", "1", condition, how);
    sheet.answer("condition", "Condition number", condition);
    sheet.verify(|| {
        let Some((again, error)) = numbers.condition_by_eigenvalues(factors) else { return };
        let what = "square root of the ratio of the eigenvalues of the normal equations";
        sheet.check_residual(what, condition - again, again, error);
    });
}
