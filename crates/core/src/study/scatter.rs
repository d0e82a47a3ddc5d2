//! Inputs that scatter within their tolerances: many problems, drawn at random and solved.

use std::{f64::consts::TAU, thread};

use super::{MOST_POINTS, StudyResult};
use crate::{
    Answer, Axis, Entry, Plot, Record, Refusal, Series, SolveError, Stop, Text,
    intern::fixed,
    sensitivity,
    vary::{self, Perturbed, VariedInput},
};

/// Samples are shared out among so many threads.
const THREADS: usize = 2;
/// Bars of the histogram.
const BARS: usize = 24;
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
    let inputs = again()?.inputs;
    let mut random = Random(seed);
    let mut drawn = |input: &VariedInput| {
        input.si + sensitivity::tolerance(input, tolerances, usual) * random.within(distribution)
    };
    let points: Vec<Vec<(usize, f64)>> = (0..samples.clamp(FEWEST, MOST_POINTS))
        .map(|_| inputs.iter().enumerate().map(|(at, input)| (at, drawn(input))).collect())
        .collect();
    let shares = points.chunks(points.len().div_ceil(THREADS));
    // Each thread has its own reading of the problem; the samples are drawn before, so their order is always the same.
    let solved: Vec<Result<Vec<f64>, SolveError>> = thread::scope(|scope| {
        let threads: Vec<_> = shares
            .map(|share| {
                scope.spawn(move || {
                    let mut again = again()?;
                    share.iter().map(|point| Ok(again.with(point, stop)?[0])).collect()
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
    let mut sorted: Vec<f64> = values.iter().copied().filter(|value| value.is_finite()).collect();
    sorted.sort_by(f64::total_cmp);
    let refused = values.len() - sorted.len();
    let unit = fixed(&answer.unit);
    let mut remarks = Vec::new();
    let mut plot = None;
    let mut numbers = Vec::new();
    if sorted.len() >= 2 {
        let count = sorted.len() as f64;
        let mean = sorted.iter().sum::<f64>() / count;
        let deviation = (sorted.iter().map(|x| (x - mean).powi(2)).sum::<f64>() / (count - 1.0)).sqrt();
        let at = |share: f64| sorted[((share * (count - 1.0)).round() as usize).min(sorted.len() - 1)];
        let (low, high) = (at(0.025), at(0.975));
        numbers = vec![mean, deviation, low, high];
        remarks.push(
            Text::new("mean {mean}, standard deviation {deviation}")
                .with_quantity("mean", mean, unit)
                .with_quantity("deviation", deviation, unit),
        );
        remarks.push(
            Text::new("95 % interval: {low} to {high}")
                .with_quantity("low", low, unit)
                .with_quantity("high", high, unit),
        );
        plot = histogram(answer, &sorted, (low, high));
    }
    if refused > 0 {
        remarks.push(
            Text::new("{refused} of {all} have no answer").with("refused", refused).with("all", values.len()),
        );
    }
    StudyResult { remarks, plot, numbers }
}

fn histogram(answer: &Answer, sorted: &[f64], (low, high): (f64, f64)) -> Option<Plot> {
    let (least, most) = (*sorted.first()?, *sorted.last()?);
    let width = (most - least) / BARS as f64;
    if width.is_nan() || width <= 0.0 {
        return None;
    }
    let mut counts = [0_usize; BARS];
    for value in sorted {
        counts[(((value - least) / width) as usize).min(BARS - 1)] += 1;
    }
    let mut outline = vec![(least, 0.0)];
    for (n, count) in counts.into_iter().enumerate() {
        let share = count as f64 / sorted.len() as f64;
        outline.extend([(least + n as f64 * width, share), (least + (n + 1) as f64 * width, share)]);
    }
    outline.push((most, 0.0));
    let title = Text::new("Distribution of {answer}").with_text("answer", answer.title());
    let x = Axis::linear(answer.title(), fixed(&answer.unit));
    let y = Axis::linear("relative frequency", "%");
    let plot = Plot::new(title, x, y, vec![Series::line(answer.title(), outline)]);
    Some(plot.band("95 %", low, high, true))
}

/// SplitMix64 (G. L. Steele, D. Lea, C. H. Flood, *Fast Splittable Pseudorandom Number Generators*, 2014).
struct Random(u64);

impl Random {
    /// Between 0 and 1, never 0.
    fn share(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut bits = self.0;
        bits = (bits ^ (bits >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        bits = (bits ^ (bits >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        bits ^= bits >> 31;
        ((bits >> 11) as f64 + 0.5) / (1_u64 << 53) as f64
    }

    /// A place within a tolerance: from −1 to 1, or normal with a standard deviation of a third.
    fn within(&mut self, distribution: Distribution) -> f64 {
        match distribution {
            Distribution::Uniform => 2.0 * self.share() - 1.0,
            // Box and Muller.
            Distribution::Normal => {
                let (radius, turn) = ((-2.0 * self.share().ln()).sqrt(), TAU * self.share());
                radius * turn.cos() / 3.0
            }
        }
    }
}
