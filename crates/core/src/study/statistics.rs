//! Statistics of the answers of a study, from rows in their order.
//!
//! Sums run over blocks of [`BLOCK`] rows, and the blocks are combined in their order (P. Pébay, *Formulas for Robust,
//! One-Pass Parallel Computation of Covariances and Arbitrary-Order Statistical Moments*, Sandia report SAND2008-6212):
//! the statistics are the same to the last bit however many threads or machines computed the rows.

use dalembert_numerics::distribution::quantile_of_sorted;
use serde::Serialize;

use crate::{Answer, Axis, Plot, Series, Text, intern::fixed};

/// Rows whose sums are taken together.
pub const BLOCK: usize = 4096;
/// Percentiles of a summary, %.
pub const PERCENTILES: [f64; 7] = [2.5, 5.0, 25.0, 50.0, 75.0, 95.0, 97.5];
/// Rows up to which percentiles are exact.
pub(super) const MOST_EXACT: usize = 10_000_000;
/// Bins of equal width in which values are counted beyond that.
const BINS: usize = 100_000;
/// Bars of a histogram.
const BARS: usize = 24;
/// Standard normal number of a two-sided interval of 95 %.
const TWO_SIDED_95: f64 = 1.959_963_984_540_054;

/// Statistics of all answers.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Summary {
    /// Number of points.
    pub points: u64,
    /// Points without an answer.
    pub refused: u64,
    /// The first of them, counted from 1, and why it is one.
    #[serde(skip)]
    pub first_refusal: Option<(u64, Text)>,
    /// Of each answer, in its unit.
    pub answers: Vec<AnswerStatistics>,
}

/// Statistics of an answer, in its unit, over the points that have it.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct AnswerStatistics {
    /// Points that have this answer.
    pub count: u64,
    /// Mean.
    pub mean: f64,
    /// Standard deviation, over `count − 1`.
    pub deviation: f64,
    /// Skewness: the third central moment over the cube of the standard deviation, both over `count`.
    pub skewness: f64,
    /// Excess kurtosis: the fourth central moment over the square of the variance, less 3.
    pub kurtosis: f64,
    /// Least value.
    pub least: f64,
    /// Largest value.
    pub largest: f64,
    /// Values of [`PERCENTILES`].
    pub percentiles: Vec<f64>,
    /// Width of the bins that the percentiles were counted in; 0 where they are exact.
    pub bin_width: f64,
    /// Correlation coefficient with each input; 0 where one of them is constant.
    pub correlations: Vec<f64>,
    /// Points beyond each limit of this answer.
    pub exceedances: Vec<Exceedance>,
    /// Frequencies.
    pub histogram: Histogram,
}

/// Probability of a limit to be exceeded.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Exceedance {
    /// The limit.
    pub limit: f64,
    /// True if larger values exceed it, false if smaller ones do.
    pub above: bool,
    /// Points that exceed it.
    pub count: u64,
    /// Their share.
    pub probability: f64,
    /// Interval that holds the probability with 95 % confidence (E. B. Wilson, *J. Am. Stat. Assoc.* 22, 1927).
    pub interval: [f64; 2],
}

/// Numbers of values in intervals of equal width.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Histogram {
    /// Beginning of the first interval.
    pub from: f64,
    /// Width of each.
    pub width: f64,
    /// Numbers of values; none where all values are one.
    pub counts: Vec<u64>,
}

/// A limit of an answer, in its unit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AnswerLimit {
    /// Place of the answer.
    pub answer: usize,
    /// The limit.
    pub limit: f64,
    /// True if larger values exceed it.
    pub above: bool,
}

/// Statistics of rows that come one after another.
#[derive(Clone, Debug)]
pub struct Accumulator {
    inputs: usize,
    limits: Vec<AnswerLimit>,
    /// The rows of the present block.
    rows: Vec<f64>,
    points: u64,
    refused: u64,
    first_refusal: Option<(u64, Text)>,
    answers: Vec<AnswerSums>,
}

/// Moments of an answer about its mean, and of its products with the inputs.
#[derive(Clone, Debug, Default)]
struct AnswerSums {
    moments: Moments,
    inputs: Vec<Comoments>,
    exceeded: Vec<u64>,
    values: Values,
}

/// Number, mean and sums of the second to the fourth power of the deviations from it.
#[derive(Clone, Copy, Debug, Default)]
struct Moments {
    count: f64,
    mean: f64,
    powers: [f64; 3],
}

/// Mean of an input, the sum of the squares of its deviations, and that of their products with those of the answer.
#[derive(Clone, Copy, Debug, Default)]
struct Comoments {
    mean: f64,
    square: f64,
    product: f64,
}

/// All values up to [`MOST_EXACT`], then their counts in bins.
#[derive(Clone, Debug, Default)]
struct Values {
    least: Option<f64>,
    largest: Option<f64>,
    exact: Vec<f64>,
    bins: Option<Bins>,
}

/// Counts in bins of equal width; values outside of them are counted at the ends.
#[derive(Clone, Debug)]
struct Bins {
    from: f64,
    width: f64,
    counts: Vec<u64>,
}

impl Accumulator {
    /// Statistics of rows with so many inputs and answers.
    pub fn new(inputs: usize, answers: usize, limits: Vec<AnswerLimit>) -> Self {
        let of = |answer: usize| AnswerSums {
            inputs: vec![Comoments::default(); inputs],
            exceeded: limits.iter().filter(|limit| limit.answer == answer).map(|_| 0).collect(),
            ..AnswerSums::default()
        };
        Self {
            inputs,
            answers: (0..answers).map(of).collect(),
            limits,
            rows: Vec::with_capacity(BLOCK * (inputs + answers)),
            points: 0,
            refused: 0,
            first_refusal: None,
        }
    }

    /// Takes the next row: its inputs, its answers, NaN where there is none, and why the point was refused, if it was.
    pub fn push(&mut self, inputs: &[f64], answers: &[f64], refusal: Option<&Text>) {
        self.rows.extend_from_slice(inputs);
        self.rows.extend_from_slice(answers);
        self.points += 1;
        if let Some(why) = refusal {
            self.refused += 1;
            self.first_refusal.get_or_insert_with(|| (self.points, why.clone()));
        }
        if self.rows.len() == BLOCK * (self.inputs + self.answers.len()) {
            self.take_block();
        }
    }

    /// The statistics of all rows.
    pub fn summary(mut self) -> Summary {
        self.take_block();
        let limits = &self.limits;
        let of = |(at, sums): (usize, AnswerSums)| {
            sums.statistics(limits.iter().filter(|limit| limit.answer == at))
        };
        Summary {
            points: self.points,
            refused: self.refused,
            first_refusal: self.first_refusal,
            answers: self.answers.into_iter().enumerate().map(of).collect(),
        }
    }

    fn take_block(&mut self) {
        let width = self.inputs + self.answers.len();
        for (at, sums) in self.answers.iter_mut().enumerate() {
            let column = self.inputs + at;
            let here = || self.rows.chunks_exact(width).filter(|row| row[column].is_finite());
            let limits = self.limits.iter().filter(|limit| limit.answer == at);
            for (limit, count) in limits.zip(&mut sums.exceeded) {
                *count += here().filter(|row| limit.is_exceeded(row[column])).count() as u64;
            }
            sums.take(here, column);
        }
        self.rows.clear();
    }
}

impl Histogram {
    /// The relative frequencies of an answer as a plot; `None` where all values are one. `si` converts the values that
    /// were counted.
    pub fn plot(&self, answer: &Answer, si: impl Fn(f64) -> f64) -> Option<Plot> {
        let all: u64 = self.counts.iter().sum();
        let place = |n: usize| si(self.from + n as f64 * self.width);
        let mut outline = vec![(place(0), 0.0)];
        for (n, count) in self.counts.iter().enumerate() {
            let share = *count as f64 / all as f64;
            outline.extend([(place(n), share), (place(n + 1), share)]);
        }
        outline.push((place(self.counts.len()), 0.0));
        let title = Text::new("Distribution of {answer}").with_text("answer", answer.title());
        let x = Axis::linear(answer.title(), fixed(&answer.unit));
        let y = Axis::linear("relative frequency", "%");
        (all > 0).then(|| Plot::new(title, x, y, vec![Series::line(answer.title(), outline)]))
    }
}

impl AnswerLimit {
    pub(super) fn is_exceeded(&self, value: f64) -> bool {
        if self.above { value > self.limit } else { value < self.limit }
    }
}

impl AnswerSums {
    /// Takes the rows of a block that have the answer, in that column.
    fn take<'r, I: Iterator<Item = &'r [f64]>>(&mut self, rows: impl Fn() -> I, column: usize) {
        let count = rows().count() as f64;
        if count == 0.0 {
            return;
        }
        let mean_of = |column: usize| rows().map(|row| row[column]).sum::<f64>() / count;
        let mean = mean_of(column);
        let mut powers = [0.0; 3];
        for row in rows() {
            let off = row[column] - mean;
            let square = off * off;
            powers[0] += square;
            powers[1] += square * off;
            powers[2] += square * square;
            self.values.take(row[column]);
        }
        let block = Moments { count, mean, powers };
        for (input, sums) in self.inputs.iter_mut().enumerate() {
            let mut of_block = Comoments { mean: mean_of(input), ..Comoments::default() };
            for row in rows() {
                let off = row[input] - of_block.mean;
                of_block.square += off * off;
                of_block.product += off * (row[column] - mean);
            }
            *sums = sums.and(&self.moments, &of_block, &block);
        }
        self.moments = self.moments.and(&block);
    }

    fn statistics<'l>(self, limits: impl Iterator<Item = &'l AnswerLimit>) -> AnswerStatistics {
        let Moments { count, mean, powers: [square, cube, fourth] } = self.moments;
        let or_zero = |value: f64| if value.is_finite() { value } else { 0.0 };
        let exceedance = |(limit, exceeded): (&AnswerLimit, u64)| Exceedance {
            limit: limit.limit,
            above: limit.above,
            count: exceeded,
            probability: or_zero(exceeded as f64 / count),
            interval: wilson(exceeded as f64, count),
        };
        let correlation = |input: &Comoments| or_zero(input.product / (input.square * square).sqrt());
        let exceedances = limits.zip(self.exceeded).map(exceedance).collect();
        let correlations = self.inputs.iter().map(correlation).collect();
        let (least, largest) = (self.values.least.unwrap_or(0.0), self.values.largest.unwrap_or(0.0));
        let (percentiles, bin_width, histogram) = self.values.distribution();
        AnswerStatistics {
            count: count as u64,
            mean,
            deviation: or_zero((square / (count - 1.0)).sqrt()),
            skewness: or_zero(count.sqrt() * cube / square.powf(1.5)),
            kurtosis: or_zero(count * fourth / (square * square) - 3.0),
            least,
            largest,
            percentiles,
            bin_width,
            correlations,
            exceedances,
            histogram,
        }
    }
}

impl Moments {
    /// The moments of these values and those of another block.
    fn and(&self, other: &Self) -> Self {
        let (a, b) = (self.count, other.count);
        let count = a + b;
        let off = other.mean - self.mean;
        let [square, cube, fourth] = self.powers;
        let [other_square, other_cube, other_fourth] = other.powers;
        Self {
            count,
            mean: self.mean + off * (b / count),
            powers: [
                square + other_square + off.powi(2) * a * b / count,
                cube + other_cube
                    + off.powi(3) * a * b * (a - b) / count.powi(2)
                    + 3.0 * off * (a * other_square - b * square) / count,
                fourth
                    + other_fourth
                    + off.powi(4) * a * b * (a * a - a * b + b * b) / count.powi(3)
                    + 6.0 * off.powi(2) * (a * a * other_square + b * b * square) / count.powi(2)
                    + 4.0 * off * (a * other_cube - b * cube) / count,
            ],
        }
    }
}

impl Comoments {
    /// The sums of these rows and of another block, with the moments of the answer in both.
    fn and(&self, moments: &Moments, other: &Self, of_block: &Moments) -> Self {
        let (a, b) = (moments.count, of_block.count);
        let count = a + b;
        let off = other.mean - self.mean;
        Self {
            mean: self.mean + off * (b / count),
            square: self.square + other.square + off * off * a * b / count,
            product: self.product + other.product + off * (of_block.mean - moments.mean) * a * b / count,
        }
    }
}

impl Values {
    fn take(&mut self, value: f64) {
        self.least = Some(self.least.map_or(value, |least| least.min(value)));
        self.largest = Some(self.largest.map_or(value, |largest| largest.max(value)));
        match &mut self.bins {
            Some(bins) => bins.count(value),
            None if self.exact.len() < MOST_EXACT => self.exact.push(value),
            None => {
                // The ends are those of the values so far, and a tenth of their range beyond.
                let (least, largest) = (self.least.unwrap_or(value), self.largest.unwrap_or(value));
                let margin = (largest - least) / 10.0;
                let mut bins = Bins {
                    from: least - margin,
                    width: (largest - least + 2.0 * margin) / BINS as f64,
                    counts: vec![0; BINS],
                };
                for value in std::mem::take(&mut self.exact) {
                    bins.count(value);
                }
                bins.count(value);
                self.bins = Some(bins);
            }
        }
    }

    /// Percentiles, the width of the bins that they were counted in, and the histogram.
    fn distribution(mut self) -> (Vec<f64>, f64, Histogram) {
        let (least, largest) = (self.least.unwrap_or(0.0), self.largest.unwrap_or(0.0));
        let shares = PERCENTILES.iter().map(|percent| percent / 100.0);
        let width = (largest - least) / BARS as f64;
        let mut histogram = Histogram { from: least, width, counts: Vec::new() };
        if width > 0.0 {
            histogram.counts = vec![0; BARS];
        }
        let mut count = |value: f64, times: u64| {
            if let Some(last) = histogram.counts.len().checked_sub(1) {
                histogram.counts[(((value - least) / width) as usize).min(last)] += times;
            }
        };
        match &self.bins {
            None => {
                self.exact.iter().for_each(|value| count(*value, 1));
                let mut ranks: Vec<usize> =
                    shares.clone().flat_map(|share| ranks_about(&self.exact, share)).collect();
                ranks.sort_unstable();
                ranks.dedup();
                put_in_order(&mut self.exact, &ranks);
                (shares.map(|share| quantile_of_sorted(&self.exact, share)).collect(), 0.0, histogram)
            }
            Some(bins) => {
                for (at, times) in bins.counts.iter().enumerate() {
                    count((bins.from + (at as f64 + 0.5) * bins.width).clamp(least, largest), *times);
                }
                let percentile = |share| bins.quantile(share).clamp(least, largest);
                (shares.map(percentile).collect(), bins.width, histogram)
            }
        }
    }
}

impl Bins {
    fn count(&mut self, value: f64) {
        let at = ((value - self.from) / self.width).max(0.0) as usize;
        self.counts[at.min(BINS - 1)] += 1;
    }

    /// The middle of the bin in which a share of the values is reached.
    fn quantile(&self, share: f64) -> f64 {
        let all: u64 = self.counts.iter().sum();
        let mut left = (share * all.saturating_sub(1) as f64) as u64;
        for (at, count) in self.counts.iter().enumerate() {
            if left < *count {
                return self.from + (at as f64 + 0.5) * self.width;
            }
            left -= count;
        }
        self.from + BINS as f64 * self.width
    }
}

/// The places of the two values that a quantile lies between.
fn ranks_about(values: &[f64], share: f64) -> [usize; 2] {
    let last = values.len().saturating_sub(1);
    let below = (share * last as f64).floor() as usize;
    [below.min(last), (below + 1).min(last)]
}

/// Puts the values of these ascending ranks where they stand in ascending order: all that quantiles need, in less time
/// than sorting.
fn put_in_order(values: &mut [f64], ranks: &[usize]) {
    let Some(&rank) = ranks.get(ranks.len() / 2).filter(|rank| **rank < values.len()) else { return };
    let (below, above) = ranks.split_at(ranks.len() / 2);
    let (smaller, _, larger) = values.select_nth_unstable_by(rank, f64::total_cmp);
    put_in_order(smaller, below);
    let above: Vec<usize> = above[1..].iter().map(|above| above - rank - 1).collect();
    put_in_order(larger, &above);
}

/// Wilson's interval of a probability, from the number of hits of so many trials.
fn wilson(hits: f64, trials: f64) -> [f64; 2] {
    if trials == 0.0 {
        return [0.0, 1.0];
    }
    let (share, z) = (hits / trials, TWO_SIDED_95);
    let scale = 1.0 + z * z / trials;
    let middle = (share + z * z / (2.0 * trials)) / scale;
    let half = z / scale * (share * (1.0 - share) / trials + (z / (2.0 * trials)).powi(2)).sqrt();
    [(middle - half).max(0.0), (middle + half).min(1.0)]
}
