//! Balancing by sizes alone: four runs for a plane, seven for two.

use std::f64::consts::FRAC_1_SQRT_2;

use dalembert_core::{
    About, Analysis, Cell, Column, Drawing, Exhibit, Ink, Inputs, MeasuredQuantity, Refusal, Sketch,
    TableExhibit, Text, Worksheet, register,
};
use dalembert_mechanics::{
    Real,
    balance::{
        self,
        influence::{self, InfluenceError},
        without_phase::{TrialEffect, effect},
    },
};
use dalembert_numerics::linalg::LinalgError;
use nalgebra::{Complex, DMatrix};

use crate::{shared::rotor, sources::RAO};

/// Amplitudes without and with a trial weight.
#[derive(Clone, Debug, Inputs)]
pub struct WithoutPhase {
    /// Trial weight.
    /// The same in every run, taken off after each.
    #[input("m", "g", positive)]
    pub trial: f64,
    /// Measured quantity.
    #[input(formerly = "displacement|velocity|acceleration|number")]
    pub measured: Amplitudes,
}

/// Amplitudes without and with the trial weight.
#[derive(Clone, Debug, Inputs)]
pub struct Amplitudes {
    /// Initial run, without the trial weight.
    /// A row for each sensor; as many sensors as planes at least.
    #[input("O", min = 1)]
    pub first: Vec<SensorAmplitude>,
    /// Runs with the trial weight.
    /// At least three angles for each plane.
    #[input(min = 3)]
    pub runs: Vec<AmplitudeRun>,
}

/// Amplitude read by a sensor.
#[derive(Clone, Debug, Inputs)]
pub struct SensorAmplitude {
    /// Amplitude.
    /// A number without a unit stands for divisions or volts.
    #[input("S", "um | mm/s | m/s^2 | 1", nonnegative, kind = "Amplitude|Velocity|Acceleration|Ratio")]
    pub amplitude: MeasuredQuantity,
}

/// A run with the trial weight.
#[derive(Clone, Debug, Inputs)]
pub struct AmplitudeRun {
    /// Plane of the trial weight.
    /// Planes are numbered from 1.
    #[input(min = 1, max = 20)]
    pub plane: usize,
    /// Angle of the trial weight.
    #[input("θ", "deg")]
    pub angle: f64,
    /// Amplitudes.
    /// The same sensors in the same order as in the initial run.
    #[input(min = 1)]
    pub readings: Vec<SensorAmplitude>,
}

register!(WithoutPhase);

/// A run as numbers of a worksheet.
struct Run<N> {
    /// Counted from 0.
    plane: usize,
    angle: N,
    sizes: Vec<N>,
}

/// All amplitudes and their unit.
struct Job<N> {
    unit: &'static str,
    first: Vec<N>,
    runs: Vec<Run<N>>,
}

impl Analysis for WithoutPhase {
    const ABOUT: About = About {
        id: "balancing/without-phase",
        title: "Balancing without phase: four and seven runs",
        topic: "Field balancing",
        summary: "Correction masses from amplitudes alone, with a trial weight at three or more angles in each plane, and the consistency of the amplitudes.",
        main: &["correction", "correction_angle"],
        keywords: "balanceamento sem fase quatro corridas quatro medições sete corridas método dos círculos four \
                   run method three circles seven run amplitude only no phase 4-run heavy spot ponto pesado \
                   massa de prova",
        sources: &[&RAO],
        cases: include_str!("../../cases/without_phase.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &WithoutPhaseGiven<W>, sheet: W) -> Result<(), Refusal> {
        let job = self.job(given);
        let planes = job.assess()?;
        let effects = job.effects(planes)?;
        for (plane, sensor, effect) in each(&effects) {
            sheet.check_zero(
                Text::new("no other effect of plane {plane} fits the amplitudes of sensor {sensor} better")
                    .with("plane", plane)
                    .with("sensor", sensor),
                effect.gradient.into(),
                1.0,
            );
        }
        if let ([first], true) = (job.first.as_slice(), planes == 1) {
            circles(given.trial, *first, &job, &effects[0][0], sheet);
        }
        let weights = correct(given.trial, &job, &effects, sheet)?;
        misfit(&job, &effects, sheet);
        sheet.show(|| Exhibit::Table(table(&job, &effects)));
        for (plane, sensor, effect) in each(&effects).take(4) {
            sheet.show(|| Exhibit::Drawing(drawing(&job, plane, sensor, effect)));
        }
        sheet.show(|| Exhibit::Drawing(polar(&weights)));
        Ok(())
    }
}

/// Every effect with the numbers of its plane and sensor, counted from 1.
fn each(effects: &[Vec<TrialEffect>]) -> impl Iterator<Item = (usize, usize, &TrialEffect)> {
    (1..)
        .zip(effects)
        .flat_map(|(plane, of)| (1..).zip(of).map(move |(sensor, effect)| (plane, sensor, effect)))
}

impl WithoutPhase {
    fn job<W: Worksheet>(&self, given: &WithoutPhaseGiven<W>) -> Job<W::Num> {
        let (own, given) = (&self.measured, &given.measured);
        let sizes = |given: &[SensorAmplitudeGiven<W>]| given.iter().map(|size| size.amplitude).collect();
        let run = |(run, given): (&AmplitudeRun, &AmplitudeRunGiven<W>)| Run {
            plane: run.plane - 1,
            angle: given.angle,
            sizes: sizes(&given.readings),
        };
        Job {
            unit: own.first.first().map_or("1", |size| size.amplitude.unit),
            first: sizes(&given.first),
            runs: own.runs.iter().zip(&given.runs).map(run).collect(),
        }
    }
}

impl<N: Real> Job<N> {
    /// Number of correction planes; refuses inputs that cannot be balanced.
    fn assess(&self) -> Result<usize, Refusal> {
        let sensors = self.first.len();
        if let Some(dead) = self.first.iter().position(|size| size.value() == 0.0) {
            return Err(Refusal::because(
                Text::new("the amplitude of sensor {n} in the initial run is 0; without an initial amplitude its effects cannot be compared")
                    .with("n", dead + 1),
            ));
        }
        for (n, run) in (1..).zip(&self.runs) {
            if run.sizes.len() != sensors {
                return Err(Refusal::because(
                    Text::new(
                        "trial run {run} has {have} readings and the initial run {want}; write the same sensors in the same order",
                    )
                    .with("run", n)
                    .with("have", run.sizes.len())
                    .with("want", sensors),
                ));
            }
        }
        let planes = self.runs.iter().map(|run| run.plane + 1).max().unwrap_or(1);
        for plane in 0..planes {
            let runs = self.runs.iter().filter(|run| run.plane == plane).count();
            if runs < 3 {
                return Err(Refusal::because(
                    Text::new("plane {plane} has {runs} runs; amplitudes alone need the trial weight at three angles at least")
                        .with("plane", plane + 1)
                        .with("runs", runs),
                ));
            }
        }
        Ok(planes)
    }

    /// The effects of the trial weight, by plane and sensor.
    fn effects(&self, planes: usize) -> Result<Vec<Vec<TrialEffect>>, Refusal> {
        let of = |plane: usize, sensor: usize| {
            let first = self.first[sensor].value();
            let runs = self.runs.iter().filter(|run| run.plane == plane);
            let runs: Vec<(f64, f64)> =
                runs.map(|run| (run.angle.value(), run.sizes[sensor].value() / first)).collect();
            effect(&runs).map_err(|error| match error {
                LinalgError::Singular { .. } => Refusal::because(
                    Text::new("the trial weight of plane {plane} was used at fewer than three different angles; distribute them over the full circle")
                        .with("plane", plane + 1),
                ),
                _ => Refusal::because("these amplitudes are beyond the range of numbers that can be balanced"),
            })
        };
        (0..planes).map(|plane| (0..self.first.len()).map(|sensor| of(plane, sensor)).collect()).collect()
    }
}

/// The construction with circles, by its formulas: one plane and one sensor.
fn circles<W: Worksheet>(trial: W::Num, first: W::Num, job: &Job<W::Num>, effect: &TrialEffect, sheet: W) {
    let count = job.runs.len() as f64;
    let angle = |run: &Run<W::Num>| run.angle.value();
    // Cosines and sines of the angles and of twice the angles vanish in the sum where they are spread evenly.
    let even = [1.0, 2.0].iter().all(|times| {
        let sum: Complex<f64> = job.runs.iter().map(|run| Complex::cis(times * angle(run))).sum();
        sum.norm() < 1e-9 * count
    });
    let (x, y, square) = if even {
        let squares = || job.runs.iter().map(|run| run.sizes[0].powi(2));
        let why = "S² = O² + T² + 2 O T cos(θ − ψ): the cosine component T cos ψ";
        let x = W::Num::sum(squares().zip(&job.runs).map(|(s, run)| s * run.angle.cos())) / (first * count);
        let x = sheet.step("T_x", job.unit, x, why);
        let y = W::Num::sum(squares().zip(&job.runs).map(|(s, run)| s * run.angle.sin())) / (first * count);
        let y = sheet.step("T_y", job.unit, y, "The sine component T sin ψ");
        (x, y, W::Num::sum(squares()) / count - first.powi(2))
    } else {
        let size = first.value();
        let why = "S² = O² + T² + 2 O T cos(θ − ψ), linear in T cos ψ, T sin ψ and T²: by least squares";
        let x = sheet.numerical("T_x", job.unit, effect.linear.re * size, why);
        let y = sheet.numerical("T_y", job.unit, -effect.linear.im * size, why);
        let t = sheet.numerical("T_s", job.unit, effect.mean_square.abs().sqrt() * size, why);
        (x, y, if effect.mean_square < 0.0 { -t.powi(2) } else { t.powi(2) })
    };
    sheet.check_zero(
        "effect of the trial weight by linear least squares",
        x - first * effect.linear.re,
        first.value(),
    );
    sheet.common_error("T_p", SINUSOID, || sinusoid(job));
    let by_phase = sheet.step(
        "T_p",
        job.unit,
        balance::magnitude(x, y),
        "Effect of the trial weight from both components",
    );
    rotor::quadrant_ignored(sheet, "ψ", (x, y));
    let unbalance =
        sheet.step("ψ", "deg", balance::marked_direction(x, y), "Angular position of the heavy spot");
    sheet.answer("existing_angle", "Angular position of the heavy spot from both components", unbalance);
    sheet.verify(|| {
        // The effect over the first vibration is z, and ψ turns against its angle.
        let what = "effect of the trial weight towards the initial unbalance, by linear least squares";
        let size = first.value() * (1.0 + effect.linear.norm());
        let (toward, across) = (by_phase * unbalance.cos(), by_phase * unbalance.sin());
        sheet.check_sum(what, toward, first * effect.linear.re, size);
        sheet.check_sum(what, across, first * -effect.linear.im, size);
    });
    let mut by_parts = None;
    if by_phase.value() > 0.0 {
        let mass = sheet.step("m_p", "g", trial * first / by_phase, "Correction mass by the two components");
        sheet.answer("correction_by_parts", "Correction mass by the two components", mass);
        by_parts = Some(mass);
        sheet.verify(|| {
            let size = trial.value() * (1.0 + 1.0 / effect.linear.norm());
            let what = "the effect of the mass by the two components equals the initial vibration";
            sheet.check_sum(what, mass * effect.linear.norm(), trial, size);
        });
    }
    if square.value() > 0.0 {
        sheet.common_error("T_m", MEAN_SQUARED, || by_mean(job, first));
        let size = sheet.step(
            "T_m",
            job.unit,
            square.sqrt(),
            "Effect of the trial weight from the mean square: T² = mean of S² − O²",
        );
        let mass = sheet.step("m_m", "g", trial * first / size, "Correction mass by the mean square");
        sheet.answer("correction_by_mean_square", "Correction mass by the mean square", mass);
        sheet.verify(|| {
            let what = "square of trial weight over correction, by linear least squares of the squares";
            let ratio = (trial / mass).powi(2);
            sheet.check_sum(what, ratio, effect.mean_square.into(), 1.0 + effect.mean_square);
        });
        let apart = (size - by_phase).abs() / size;
        let apart = sheet.step(
            "q",
            "%",
            apart,
            "Difference between the two methods: 0 if the circles intersect in one point",
        );
        sheet.answer("disagreement", "Difference between the two methods", apart);
        if let Some(by_parts) = by_parts {
            // A weight is as much smaller as its effect is larger.
            let of_weights = (mass / by_parts - 1.0).abs();
            let what = "difference between the two correction masses";
            sheet.check_sum(what, apart, of_weights, 1.0 + apart.value());
        }
        if apart.value() > 0.1 {
            sheet.warn(|| {
                Text::new(
                    "the circles do not intersect: two methods for the effect of the trial weight differ by {share} %; repeat the runs at a steady speed",
                )
                .with("share", format!("{:.0}", 100.0 * apart.value()))
            });
        }
    } else {
        sheet.warn(|| {
            "the mean square of the runs does not exceed that of the initial run: no vibration has such amplitudes. Repeat the runs at a steady speed"
                .into()
        });
    }
}

const SINUSOID: &str = "the amplitudes themselves resolved along the angles, in place of their squares";
const MEAN_SQUARED: &str = "the square of the mean amplitude used in place of the mean of the squares";

/// The effect of the trial weight that a sinusoid through the amplitudes has.
fn sinusoid<N: Real>(job: &Job<N>) -> N {
    let part = |of: fn(N) -> N| {
        N::sum(job.runs.iter().map(|run| run.sizes[0] * of(run.angle))) * 2.0 / job.runs.len() as f64
    };
    balance::magnitude(part(N::cos), part(N::sin))
}

/// Mean of the readings of the first sensor with the trial weight.
fn mean_reading<N: Real>(job: &Job<N>) -> N {
    N::sum(job.runs.iter().map(|run| run.sizes[0])) / job.runs.len() as f64
}

/// The effect of the trial weight that the mean amplitude has.
fn by_mean<N: Real>(job: &Job<N>, first: N) -> N {
    (mean_reading(job).powi(2) - first.powi(2)).sqrt()
}

/// The effect of the trial weight by the mean square of the amplitudes.
fn by_squares<N: Real>(job: &Job<N>, first: N) -> N {
    let mean = N::sum(job.runs.iter().map(|run| run.sizes[0].powi(2))) / job.runs.len() as f64;
    (mean - first.powi(2)).sqrt()
}

/// The largest reading of the first sensor with the trial weight.
fn largest_reading<N: Real>(job: &Job<N>) -> N {
    let readings = job.runs.iter().map(|run| run.sizes[0]);
    readings.reduce(Real::max).unwrap_or(0.0.into())
}

/// The weights that take all first vibrations to zero, in units of each.
fn correct<W: Worksheet>(
    trial: W::Num,
    job: &Job<W::Num>,
    effects: &[Vec<TrialEffect>],
    sheet: W,
) -> Result<Vec<Complex<f64>>, Refusal> {
    let sensors = job.first.len();
    let largest = job.first.iter().map(|size| size.value()).fold(0.0, f64::max);
    let share = |sensor: usize| job.first[sensor].value() / largest;
    let alpha =
        DMatrix::from_fn(sensors, effects.len(), |sensor, plane| effects[plane][sensor].best * share(sensor));
    let first: Vec<Complex<f64>> = (0..sensors).map(|sensor| Complex::from(share(sensor))).collect();
    let solved = influence::least_squares(&alpha, &first, &[]).map_err(|error| match error {
        InfluenceError::TooFewReadings { readings, planes } => Refusal::because(
            Text::new(
                "{readings} readings cannot determine the weights of {planes} planes; read more sensors or speeds, or correct in fewer planes",
            )
            .with("readings", readings)
            .with("planes", planes),
        ),
        InfluenceError::Linalg(LinalgError::Singular { .. }) => Refusal::because(
            "the trial weight had no effect, or the planes act alike on all sensors: take a larger trial weight, or leave a plane out",
        ),
        _ => Refusal::because("these amplitudes are beyond the range of numbers that can be balanced"),
    })?;
    let mut weights = Vec::new();
    for (n, weight) in (1..).zip(&solved.weights) {
        let ratio = sheet.numerical(
            ("w", n),
            "1",
            weight.norm(),
            "Correction over trial weight: best fit of the effects to all amplitudes, with the masses that minimise the residual vibration",
        );
        if let ([first], 1) = (job.first.as_slice(), effects.len()) {
            let of = |effect: W::Num| trial * *first / effect;
            sheet.common_error(("m_c", n), SINUSOID, || of(sinusoid(job)));
            sheet.common_error(("m_c", n), MEAN_SQUARED, || of(by_mean(job, *first)));
            let what = "the effect taken as the largest reading less the initial one";
            sheet.common_error(("m_c", n), what, || of(largest_reading(job) - *first));
            let what = "the trial weight scaled by the initial reading over the largest one";
            sheet.common_error(("m_c", n), what, || of(largest_reading(job)));
            let what = "the effect taken as the mean of the readings less the initial one";
            sheet.common_error(("m_c", n), what, || of(mean_reading(job) - *first));
            let what = "the trial weight scaled by its effect over the initial reading";
            sheet.common_error(("m_c", n), what, || trial * by_squares(job, *first) / *first);
        }
        let mass = sheet.step(("m_c", n), "g", ratio * trial, "Correction mass");
        let angle = sheet.numerical(
            ("θ_c", n),
            "deg",
            balance::marked_angle_found(weight.arg()),
            "Angle of the correction, in the convention of the trial weight",
        );
        sheet.answer(("correction", n), "Correction mass in plane", mass);
        sheet.answer(("correction_angle", n), "Angle of the correction in plane", angle);
        weights.push(Complex::from_polar(mass.value() / trial.value(), angle.value()));
    }
    let left = influence::residuals(&alpha, &first, &weights);
    for plane in 0..alpha.ncols() {
        let product: Complex<f64> = alpha.column(plane).iter().zip(&left).map(|(a, r)| a.conj() * r).sum();
        let size: f64 = alpha.column(plane).iter().map(|a| a.norm()).sum();
        sheet.check_zero(
            Text::new("the residual is orthogonal to the influence vector of plane {n}").with("n", plane + 1),
            product.norm().into(),
            size,
        );
    }
    Ok(solved.weights)
}

fn misfit<W: Worksheet>(job: &Job<W::Num>, effects: &[Vec<TrialEffect>], sheet: W) {
    let all = || {
        each(effects).flat_map(|(_, sensor, effect)| {
            let size = job.first[sensor - 1].value();
            effect.left.iter().map(move |left| (left.abs(), left.abs() * size))
        })
    };
    let worst = all().map(|(_, left)| left).fold(0.0, f64::max);
    let largest = job.first.iter().map(|size| size.value()).fold(0.0, f64::max);
    // Amplitudes that agree leave nothing but rounding.
    let worst = if worst < 1e-9 * largest { 0.0 } else { worst };
    let share = all().map(|(share, _)| share).fold(0.0, f64::max);
    let misfit = sheet.numerical(
        "e",
        job.unit,
        worst,
        "Maximum difference between the amplitudes and those calculated from the identified effects",
    );
    sheet.answer("misfit", "Maximum residual of an amplitude", misfit);
    sheet.verify(|| {
        let mut again = 0.0f64;
        for (plane, sensor, effect) in each(effects) {
            let first = job.first[sensor - 1].value();
            for run in job.runs.iter().filter(|run| run.plane + 1 == plane) {
                // The trial weight's effect turns with it.
                let turned = run.angle.value() + effect.best.arg();
                let squared = 1.0 + effect.best.norm_sqr() + 2.0 * effect.best.norm() * turned.cos();
                again = again.max((squared.max(0.0).sqrt() * first - run.sizes[sensor - 1].value()).abs());
            }
        }
        let again = if again < 1e-9 * largest { 0.0 } else { again };
        let reach =
            largest * (1.0 + each(effects).map(|(_, _, effect)| effect.best.norm()).fold(0.0, f64::max));
        let what =
            "maximum residual from the triangles of initial vibration and effect, by the law of cosines";
        sheet.check_sum(what, misfit, again.into(), reach);
    });
    if share > 0.1 {
        sheet.warn(|| {
            Text::new("the amplitudes are inconsistent: one deviates by {share} % of the first; repeat the runs at a steady speed")
                .with("share", format!("{:.0}", 100.0 * share))
        });
    }
}

fn table<N: Real>(job: &Job<N>, effects: &[Vec<TrialEffect>]) -> TableExhibit {
    let column = |heading: &'static str, unit| Column { heading: heading.into(), unit };
    let number = |n: usize| Cell::Text(Text::new(n.to_string()));
    let rows = each(effects).flat_map(|(plane, sensor, effect)| {
        let first = job.first[sensor - 1].value();
        job.runs.iter().filter(move |run| run.plane + 1 == plane).zip(&effect.left).map(move |(run, left)| {
            let size = run.sizes[sensor - 1].value();
            vec![
                number(plane),
                number(sensor),
                run.angle.value().into(),
                size.into(),
                (size + left * first).into(),
            ]
        })
    });
    TableExhibit {
        title: "Amplitudes, measured and fitted".into(),
        columns: vec![
            column("plane", ""),
            column("sensor", ""),
            column("θ", "deg"),
            column("measured", job.unit),
            column("fitted", job.unit),
        ],
        rows: rows.collect(),
        foot: Vec::new(),
    }
}

/// The circles: about a point of the first circle for each angle, with the amplitude of that run; they meet where the
/// effect of the trial weight ends, in the direction of the correction.
fn drawing<N: Real>(job: &Job<N>, plane: usize, sensor: usize, effect: &TrialEffect) -> Drawing {
    let first = job.first[sensor - 1].value();
    let title =
        Text::new("Circles of plane {plane} at sensor {sensor}").with("plane", plane).with("sensor", sensor);
    let mut sketch = Sketch::new(title);
    sketch.circle((0.0, 0.0), 1.0, Ink::Body).label(Text::verbatim(rotor::letter("S_O", sensor)), (0.0, 0.0));
    let of_plane = (1..).zip(&job.runs).filter(|(_, run)| run.plane + 1 == plane);
    for (n, run) in of_plane {
        let size = format!("{},{}", rotor::letter("S", n), dalembert_units::subscript(sensor));
        let name = format!("{size}, {}", rotor::letter("θ", n));
        let (sin, cos) = run.angle.value().sin_cos();
        let radius = run.sizes[sensor - 1].value() / first;
        let outer = ((1.0 + radius) * cos, (1.0 + radius) * sin);
        sketch
            .circle((cos, sin), radius, Ink::Motion)
            .axis((0.0, 0.0), (cos, sin))
            .label(Text::verbatim(name), outer);
    }
    let tip = -effect.best.conj();
    sketch.vector("", (0.0, 0.0), (tip.re, tip.im), Ink::Result).finish()
}

/// The corrections around the shaft, in units of the trial weight.
fn polar(weights: &[Complex<f64>]) -> Drawing {
    let reach = weights.iter().map(|w| w.norm()).fold(1.0, f64::max);
    let mut sketch = Sketch::new("End view of the corrections; circle: trial weight");
    sketch
        .axes((0.0, 0.0), 1.1)
        .circle((0.0, 0.0), 1.0 / reach, Ink::Faint)
        .label("m", (-FRAC_1_SQRT_2 / reach, FRAC_1_SQRT_2 / reach));
    for (n, weight) in (1..).zip(weights) {
        let tip = weight / reach;
        sketch.vector(Text::verbatim(rotor::letter("W", n)), (0.0, 0.0), (tip.re, tip.im), Ink::Result);
    }
    sketch.finish()
}
