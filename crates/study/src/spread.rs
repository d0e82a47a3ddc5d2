//! Spread of an answer over the tolerances of the inputs, by Monte Carlo.

use dalembert_core::{
    Entry, Locale, Record, Solution, SolveError, Stop,
    sensitivity::Sensitivity,
    study::{Amount, Design, DistributionKind, Study, StudyPlan, Variation},
};

use crate::{StudyError, output::Run};

/// Standard deviations to either side of the mean that hold 95 % of a normal distribution.
const TWO_SIDED_95: f64 = 1.959_963_984_540_054;

/// Difference between the interval of the samples and the root of the sum of squares, as a share of the latter, from which
/// the answer is not linear enough for it.
pub const NONLINEAR: f64 = 0.1;

/// Samples of an answer, in SI. Each input is normal, independent of the others, and within its tolerance with a
/// probability of 95 %.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SampledSpread {
    /// Number of samples.
    pub samples: u64,
    /// Samples without an answer.
    pub refused: u64,
    /// Seed.
    pub seed: u64,
    /// Mean.
    pub mean: f64,
    /// Standard deviation.
    pub deviation: f64,
    /// The interval between the percentiles 2.5 and 97.5.
    pub interval: [f64; 2],
}

impl SampledSpread {
    /// The largest difference between an end of the interval and `value ± √(Σ Δ²)`, as a share of that root.
    pub fn difference(&self, found: &Sensitivity) -> f64 {
        let likely = found.spread.likely;
        let ends = [found.value - likely, found.value + likely];
        let apart = self.interval.iter().zip(ends).map(|(sampled, end)| (sampled - end).abs());
        apart.fold(0.0, f64::max) / likely
    }
}

/// Draws the inputs that have a tolerance; `None` where there is none.
///
/// # Errors
/// An input that cannot be varied; a stop.
pub fn sampled(
    (entry, record): (&Entry, &Record),
    solution: &Solution,
    found: &Sensitivity,
    (samples, seed): (u64, u64),
    (threads, stop): (usize, &Stop),
) -> Result<Option<SampledSpread>, StudyError> {
    let varied = found.influences.iter().filter(|one| one.tolerance > 0.0);
    let vary: Vec<Variation> = varied
        .map(|one| Variation {
            input: Some(one.input.path.clone()),
            distribution: Some(DistributionKind::Normal),
            deviation: Some(Amount::Number(one.tolerance / TWO_SIDED_95 / one.input.unit.factor)),
            ..Variation::default()
        })
        .collect();
    if vary.is_empty() {
        return Ok(None);
    }
    let answers = vec![found.answer.clone()];
    let plan = StudyPlan { answers, samples: Some(samples), seed, vary, ..StudyPlan::default() };
    let no_file = |_: &str| Ok(Vec::new());
    let design = Design::new(&plan, record, &no_file).map_err(SolveError::Fields)?;
    let study = Study::new(entry, record, &plan, design, solution)?;
    let locale = Locale::english();
    let run = Run { study: &study, fingerprint: "", threads, locale: &locale, stop, progress: &|_| {} };
    let summary = run.summarise()?;
    let (Some(answer), Some(of)) = (study.answers.first(), summary.answers.first()) else { return Ok(None) };
    let unit = &answer.unit;
    let (Some(low), Some(high)) = (of.percentiles.first(), of.percentiles.last()) else { return Ok(None) };
    Ok(Some(SampledSpread {
        samples,
        refused: summary.points - of.count,
        seed,
        mean: unit.si(of.mean),
        deviation: of.deviation * unit.factor,
        interval: [unit.si(*low), unit.si(*high)],
    }))
}
