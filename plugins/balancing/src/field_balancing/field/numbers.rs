//! The numbers of a job, judged before anything is computed from them.

use dalembert_core::{Refusal, Text, Worksheet};
use dalembert_mechanics::{
    Real,
    balance::{
        influence::{self, TrialRun},
        spread::{self, Choice, Measurement, ReadingSpread},
    },
};
use dalembert_numerics::linalg;
use nalgebra::{Complex, DMatrix};

use super::{
    Influence, Job,
    readings::{WorkedReading, WorkedRun},
    refusal,
};

/// A trial run counts as without effect when it moved no reading by this many times its uncertainty.
const NO_EFFECT: f64 = 2.0;
/// Below this many times it is doubtful.
const WEAK_EFFECT: f64 = 5.0;
/// Planes whose effects are that parallel are doubtful.
const ALIKE: f64 = 0.98;
/// A trial run that changes every reading by less than this share of it is repeated with more, by the rule of
/// 30 per cent or 30 degrees, which is half of it as a vector.
const LITTLE_CHANGE: f64 = 0.25;
/// The share that a trial weight ought to change a reading by.
const GOOD_CHANGE: f64 = 0.3;
/// A condition number above this is doubtful.
const POOR_CONDITION: f64 = 10.0;

/// A job in numbers, angles in the sense of the weights.
pub(super) struct Numbers {
    pub(super) first: Vec<Complex<f64>>,
    pub(super) runs: Vec<TrialRun>,
    pub(super) stay: bool,
    pub(super) known: bool,
    /// A row for each reading, a column for each plane.
    pub(super) alpha: DMatrix<Complex<f64>>,
}

impl Numbers {
    /// Reads a job; refuses what cannot be balanced and warns of what is doubtful.
    pub(super) fn new<W: Worksheet>(
        job: &Job<W::Num>,
        opposed: bool,
        spread: ReadingSpread,
        sheet: W,
    ) -> Result<Self, Refusal> {
        let reading = |reading: &WorkedReading<W::Num>| vector(reading, opposed);
        let first = initial(job, opposed, sheet)?;
        match &job.influence {
            Influence::NotYet => Err(Refusal::because("there is no trial run yet: make one for each plane")),
            Influence::Known(coefficients) => {
                let alpha = known(coefficients, first.len())?;
                Ok(Self { first, runs: Vec::new(), stay: false, known: true, alpha })
            }
            Influence::Runs { stay, runs } => {
                same_readings(&job.first, runs)?;
                let numbers = |run: &WorkedRun<W::Num>| TrialRun {
                    plane: run.plane,
                    weight: Complex::from_polar(run.mass.value(), run.angle.value()),
                    readings: run.readings.iter().map(reading).collect(),
                };
                let runs: Vec<TrialRun> = runs.iter().map(numbers).collect();
                judge_trials(&first, &runs, *stay, spread, sheet)?;
                let none = DMatrix::zeros(0, 0);
                let alpha = influence::influence_coefficients(&first, &runs, *stay)
                    .map_err(|error| refusal(error, &none))?;
                Ok(Self { first, runs, stay: *stay, known: false, alpha })
            }
        }
    }

    /// The same numbers with every reading over a limit of its own.
    pub(super) fn over(&self, limits: &[f64]) -> Self {
        let divided = |readings: &[Complex<f64>]| -> Vec<Complex<f64>> {
            readings.iter().zip(limits).map(|(reading, limit)| reading / *limit).collect()
        };
        let run = |run: &TrialRun| TrialRun { readings: divided(&run.readings), ..run.clone() };
        let alpha = DMatrix::from_fn(self.alpha.nrows(), self.alpha.ncols(), |row, plane| {
            self.alpha[(row, plane)] / limits[row]
        });
        Self {
            first: divided(&self.first),
            runs: self.runs.iter().map(run).collect(),
            stay: self.stay,
            known: self.known,
            alpha,
        }
    }

    /// Refuses planes that the uncertainty cannot tell apart, and warns of those that are nearly so.
    pub(super) fn assess_planes<W: Worksheet>(
        &self,
        condition: f64,
        spread: ReadingSpread,
        sheet: W,
    ) -> Result<(), Refusal> {
        if condition * spread.amplitude.max(spread.phase) > 1.0 {
            return Err(Refusal::because(
                Text::new(
                    "the planes act so alike on the sensors that the uncertainty of the readings, times the condition \
                     number {condition}, is larger than the readings: correct in fewer planes, or add sensors or speeds",
                )
                .with("condition", format!("{condition:.3e}")),
            ));
        }
        if condition > POOR_CONDITION {
            sheet.warn(|| {
                Text::new(
                    "errors of the readings may be amplified {condition} times in the corrections; see the table of planes left out",
                )
                .with("condition", format!("{condition:.1}"))
            });
        }
        let planes = self.alpha.ncols();
        for (one, other) in (0..planes).flat_map(|one| (one + 1..planes).map(move |other| (one, other))) {
            let alike = influence::collinearity(&self.alpha, one, other);
            if alike > ALIKE {
                sheet.warn(|| {
                    Text::new(
                        "planes {one} and {other} act almost alike on the sensors (cosine {cosine}): their corrections may be large and opposite; leave one of them out",
                    )
                    .with("one", one + 1)
                    .with("other", other + 1)
                    .with("cosine", format!("{alike:.4}"))
                });
            }
        }
        Ok(())
    }

    /// The size of what is added up in a reading that remains with weights.
    pub(super) fn reach(&self, row: usize, weights: &[Complex<f64>]) -> f64 {
        let effect =
            |(plane, weight): (usize, &Complex<f64>)| self.alpha[(row, plane)].norm() * weight.norm();
        self.first[row].norm() + weights.iter().enumerate().map(effect).sum::<f64>()
    }

    /// The condition number from the eigenvalues of the normal equations, their columns scaled, and its rounding error:
    /// squares of singular values lose twice the digits. None where none is left.
    pub(super) fn condition_by_eigenvalues(&self, factors: &[f64]) -> Option<(f64, f64)> {
        let (rows, planes) = self.alpha.shape();
        let entry = |row: usize, plane: usize| self.alpha[(row, plane)] * factors[row].sqrt();
        let size = |plane: usize| {
            (0..rows).map(|row| entry(row, plane)).map(|a| a.re.abs().max(a.im.abs())).fold(0.0, f64::max)
        };
        let sizes: Vec<f64> = (0..planes).map(size).collect();
        let products = DMatrix::from_fn(planes, planes, |one, other| {
            let term = |row| (entry(row, one) / sizes[one]).conj() * (entry(row, other) / sizes[other]);
            (0..rows).map(term).sum::<Complex<f64>>()
        });
        // A Hermitian matrix as a symmetric one of twice its size, which has each eigenvalue twice.
        let symmetric = DMatrix::from_fn(2 * planes, 2 * planes, |row, column| {
            let product = products[(row % planes, column % planes)];
            match (row < planes, column < planes) {
                (true, true) | (false, false) => product.re,
                (true, false) => -product.im,
                (false, true) => product.im,
            }
        });
        let values = linalg::symmetric_eigen(&symmetric).ok()?.values;
        let (least, most) = (values.min(), values.max());
        let error = f64::EPSILON * (2 * planes + rows) as f64 * most;
        (least > 100.0 * error).then(|| {
            let condition = (most / least).sqrt();
            (condition, condition * error / least)
        })
    }

    /// The same numbers for sampling.
    pub(super) fn measured<'a>(&'a self, choice: Choice<'a>, spread: ReadingSpread) -> Measurement<'a> {
        let influence = if self.known {
            spread::Influence::Known(&self.alpha)
        } else {
            spread::Influence::Runs(&self.runs, self.stay)
        };
        Measurement { first: &self.first, influence, choice, spread }
    }
}

/// A reading in the sense of the weights.
pub(super) fn vector<N: Real>(reading: &WorkedReading<N>, opposed: bool) -> Complex<f64> {
    let phase = reading.phase.value();
    Complex::from_polar(reading.amplitude.value(), if opposed { -phase } else { phase })
}

/// The readings of the initial run; warns of those that are 0, and refuses them where all are.
pub(super) fn initial<W: Worksheet>(
    job: &Job<W::Num>,
    opposed: bool,
    sheet: W,
) -> Result<Vec<Complex<f64>>, Refusal> {
    let first: Vec<Complex<f64>> = job.first.iter().map(|reading| vector(reading, opposed)).collect();
    if first.iter().all(|v| v.norm() == 0.0) {
        return Err(Refusal::because(
            "every amplitude of the initial run is 0, so there is nothing to balance; check sensors and filter",
        ));
    }
    for (n, v) in (1..).zip(&first) {
        if v.norm() == 0.0 {
            sheet.warn(|| {
                Text::new("reading {n} of the initial run is 0: is its sensor connected?").with("n", n)
            });
        }
    }
    Ok(first)
}

/// Two planes act alike: which.
pub(super) fn alike(alpha: &DMatrix<Complex<f64>>) -> Refusal {
    let planes = alpha.ncols();
    if let Some(dead) = (0..planes).find(|plane| alpha.column(*plane).iter().all(|a| a.norm() == 0.0)) {
        return Refusal::because(
            Text::new("plane {n} has no influence on any reading; a weight there changes nothing")
                .with("n", dead + 1),
        );
    }
    let pairs = (0..planes).flat_map(|one| (one + 1..planes).map(move |other| (one, other)));
    let worst = pairs
        .map(|(one, other)| (influence::collinearity(alpha, one, other), one, other))
        .max_by(|a, b| a.0.total_cmp(&b.0));
    let (cosine, one, other) = worst.unwrap_or((1.0, 0, 0));
    Refusal::because(
        Text::new(
            "planes {one} and {other} act alike on all sensors (cosine {cosine}), so their corrections cannot be separated; leave one of them out, or add a sensor or a speed with a different response",
        )
        .with("one", one + 1)
        .with("other", other + 1)
        .with("cosine", format!("{cosine:.6}")),
    )
}

/// The table of known coefficients as a matrix.
fn known(rows: &[(f64, f64, f64, f64)], readings: usize) -> Result<DMatrix<Complex<f64>>, Refusal> {
    let whole = |number: f64, most: usize| -> Result<usize, Refusal> {
        if number.fract() == 0.0 && (1.0..=most as f64).contains(&number) {
            Ok(number as usize - 1)
        } else {
            Err(Refusal::because(
                Text::new(
                    "the table of coefficients contains the plane or reading number {number}; use whole numbers from 1 to {most}",
                )
                .with("number", number)
                .with("most", most),
            ))
        }
    };
    let planes = rows.iter().try_fold(0, |most, row| whole(row.0, 20).map(|plane| (plane + 1).max(most)))?;
    let mut alpha = DMatrix::from_element(readings, planes.max(1), None);
    for (plane, reading, size, angle) in rows {
        let place = &mut alpha[(whole(*reading, readings)?, whole(*plane, 20)?)];
        if place.is_some() {
            return Err(Refusal::because(
                Text::new("the coefficient of plane {plane} at reading {reading} appears twice in the table")
                    .with("plane", plane)
                    .with("reading", reading),
            ));
        }
        *place = Some(Complex::from_polar(*size, *angle));
    }
    for plane in 0..alpha.ncols() {
        for reading in 0..readings {
            if alpha[(reading, plane)].is_none() {
                return Err(Refusal::because(
                    Text::new(
                        "the coefficient of plane {plane} at reading {reading} is missing in the table",
                    )
                    .with("plane", plane + 1)
                    .with("reading", reading + 1),
                ));
            }
        }
    }
    Ok(alpha.map(Option::unwrap_or_default))
}

/// Every run has the readings of the first one, at the same speeds.
fn same_readings<N: Real>(first: &[WorkedReading<N>], runs: &[WorkedRun<N>]) -> Result<(), Refusal> {
    for (n, run) in (1..).zip(runs) {
        if run.readings.len() != first.len() {
            return Err(Refusal::because(
                Text::new(
                    "trial run {run} has {have} readings and the initial run {want}; write the same sensors in the same order",
                )
                .with("run", n)
                .with("have", run.readings.len())
                .with("want", first.len()),
            ));
        }
        for (row, (before, now)) in (1..).zip(first.iter().zip(&run.readings)) {
            if let (Some(before), Some(now)) = (before.speed, now.speed)
                && (now - before).abs() > 0.01 * before
            {
                return Err(Refusal::because(
                    Text::new(
                        "reading {row} of trial run {run} was taken at {now} and that of the initial run at {before}; influence coefficients are valid at one speed only: repeat the run at the same speed",
                    )
                    .with("row", row)
                    .with("run", n)
                    .with_quantity("now", now, "rpm")
                    .with_quantity("before", before, "rpm"),
                ));
            }
        }
    }
    Ok(())
}

/// A trial that changed no more than the readings scatter says nothing about its plane.
fn judge_trials<W: Worksheet>(
    first: &[Complex<f64>],
    runs: &[TrialRun],
    stay: bool,
    spread: ReadingSpread,
    sheet: W,
) -> Result<(), Refusal> {
    let mut before = first;
    for (n, run) in (1..).zip(runs) {
        let each = |(now, before): (&Complex<f64>, &Complex<f64>)| {
            let change = (now - before).norm();
            let doubt = spread.amplitude.max(spread.phase) * now.norm().hypot(before.norm());
            if change == 0.0 { 0.0 } else { change / doubt }
        };
        let effect = run.readings.iter().zip(before).map(each).fold(0.0, f64::max);
        if effect == 0.0 {
            return Err(Refusal::because(
                Text::new(
                    "trial run {n} reads the same as the run before the weight was added: the weight had no effect. \
                     Check its mass and plane, or write the readings of that run",
                )
                .with("n", n),
            ));
        }
        if effect < NO_EFFECT {
            return Err(Refusal::because(
                Text::new(
                    "trial run {n} changed the readings by only {effect} times their uncertainty, so nothing is known of \
                     this plane: take a larger trial weight or another angle before the next start",
                )
                .with("n", n)
                .with("effect", format!("{effect:.2}")),
            ));
        }
        if effect < WEAK_EFFECT {
            sheet.warn(|| {
                Text::new(
                    "trial run {n} changed the readings by only {effect} times their uncertainty: a larger trial weight would make the correction more reliable",
                )
                .with("n", n)
                .with("effect", format!("{effect:.2}"))
            });
        }
        let change = change(n, &run.readings, before, sheet);
        if effect >= WEAK_EFFECT && change < LITTLE_CHANGE {
            sheet.warn(|| {
                Text::new("trial weight {n} changed the vibration by only {change} %: repeat the run with about {times} times the mass, or at another angle")
                    .with("n", n)
                    .with("change", format!("{:.0}", 100.0 * change))
                    .with("times", format!("{:.1}", GOOD_CHANGE / change))
            });
        }
        if stay {
            before = &run.readings;
        }
    }
    Ok(())
}

/// The largest change of a reading by a trial weight, as a vector over the reading before it.
fn change<W: Worksheet>(run: usize, now: &[Complex<f64>], before: &[Complex<f64>], sheet: W) -> f64 {
    let pairs = || now.iter().zip(before).filter(|(_, before)| before.norm() > 0.0);
    let largest = pairs().map(|(now, before)| (now - before).norm() / before.norm()).fold(0.0, f64::max);
    let how = "Largest change of a reading by the trial weight, as a vector, over the reading before it";
    let change = sheet.numerical(("ε", run), "%", largest, how);
    sheet.answer(("trial_effect", run), "Change of the vibration by trial weight", change);
    sheet.verify(|| {
        let squared = |(now, before): (&Complex<f64>, &Complex<f64>)| {
            let ratio = now.norm() / before.norm();
            1.0 + ratio * ratio - 2.0 * ratio * (now.arg() - before.arg()).cos()
        };
        let again = pairs().map(squared).fold(0.0, f64::max);
        let scale =
            pairs().map(|(now, before)| (1.0 + now.norm() / before.norm()).powi(2)).fold(0.0, f64::max);
        let what = "square of the change by the law of cosines";
        sheet.check_sum(what, change.powi(2), again.into(), scale);
    });
    largest
}
