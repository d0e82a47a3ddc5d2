//! Inputs that scatter within their tolerances: many problems, drawn at random and solved.

use std::thread;

use dalembert_numerics::{distribution::normal_quantile, random::uniform};

use super::{MOST_SAMPLES, StudyResult, statistics::Accumulator, values::PERCENTILES};
use crate::{
    Answer, Entry, Record, Refusal, SolveError, Stop, Text,
    intern::fixed,
    sensitivity,
    vary::{self, Perturbed, VariedInput},
};

/// Fewer samples than these tell nothing of the ends of an interval.
const FEWEST: usize = 20;

/// Distribution of values within a tolerance.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Distribution {
    /// Everywhere alike.
    #[default]
    Uniform,
    /// Normally; the tolerance is three standard deviations.
    Normal,
}

impl Distribution {
    /// A place within a tolerance below which a share of all lies: from −1 to 1, or normal with a standard deviation of
    /// a third.
    fn within(self, share: f64) -> f64 {
        match self {
            Self::Uniform => 2.0 * share - 1.0,
            Self::Normal => normal_quantile(share) / 3.0,
        }
    }
}

pub(super) fn scatter(
    entry: &Entry,
    record: &Record,
    answer: &Answer,
    (tolerances, usual): (&[(String, f64)], f64),
    distribution: Distribution,
    (samples, seed): (usize, u64),
    stop: &Stop,
) -> Result<StudyResult, SolveError> {
    let again = || Perturbed::new(entry, record, vary::inputs(record), vec![answer.name.to_string()]);
    let with_tolerance = |input: &VariedInput| [input.si, sensitivity::tolerance(input, tolerances, usual)];
    let inputs: Vec<[f64; 2]> = again()?.inputs.iter().map(with_tolerance).collect();
    let inputs = &inputs;
    let point = move |sample: usize| -> Vec<(usize, f64)> {
        let share = |at: usize| uniform(seed, sample as u64, at as u64);
        let drawn = inputs.iter().enumerate();
        drawn.map(|(at, [si, tolerance])| (at, si + tolerance * distribution.within(share(at)))).collect()
    };
    let samples = samples.clamp(FEWEST, MOST_SAMPLES);
    let threads = thread::available_parallelism().map_or(1, usize::from);
    let share = samples.div_ceil(threads);
    // Each thread has its own reading of the problem; a sample is a function of its number, so their order is always the
    // same.
    let solved: Vec<Result<Vec<f64>, SolveError>> = thread::scope(|scope| {
        let threads: Vec<_> = (0..threads)
            .map(|thread| {
                scope.spawn(move || {
                    let mut again = again()?;
                    let own = thread * share..((thread + 1) * share).min(samples);
                    own.map(|sample| Ok(again.with(&point(sample), stop)?[0])).collect()
                })
            })
            .collect();
        let lost = || Err(Refusal::because("the study failed (internal error)").into());
        threads.into_iter().map(|thread| thread.join().unwrap_or_else(|_| lost())).collect()
    });
    let mut values = Vec::new();
    for share in solved {
        values.extend(share?);
    }
    Ok(reported(answer, &values))
}

fn reported(answer: &Answer, values: &[f64]) -> StudyResult {
    let mut sums = Accumulator::new(0, 1, Vec::new());
    let no_answer = Text::default();
    for value in values {
        sums.push(&[], &[*value], Some(&no_answer).filter(|_| !value.is_finite()));
    }
    let summary = sums.summary();
    let of = &summary.answers[0];
    let unit = fixed(&answer.unit);
    let mut remarks = Vec::new();
    let mut plot = None;
    let mut numbers = Vec::new();
    if of.count >= 2 {
        let [low, high] = [0, PERCENTILES.len() - 1].map(|at| of.percentiles[at]);
        numbers = vec![of.mean, of.deviation, low, high];
        remarks.push(
            Text::new("mean {mean}, standard deviation {deviation}")
                .with_quantity("mean", numbers[0], unit)
                .with_quantity("deviation", numbers[1], unit),
        );
        remarks.push(
            Text::new("95 % interval: {low} to {high}")
                .with_quantity("low", numbers[2], unit)
                .with_quantity("high", numbers[3], unit),
        );
        plot = of.histogram.plot(answer, |si| si).map(|plot| plot.band("95 %", numbers[2], numbers[3], true));
    }
    if summary.refused > 0 {
        remarks.push(
            Text::new("{refused} of {all} have no answer")
                .with("refused", summary.refused)
                .with("all", values.len()),
        );
    }
    StudyResult { remarks, plot, numbers }
}
