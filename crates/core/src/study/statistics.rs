//! Statistics of the answers of a study, from rows in their order.
//!
//! Sums run over blocks of [`BLOCK`] rows, and the blocks are combined in their order (P. Pébay, *Formulas for Robust,
//! One-Pass Parallel Computation of Covariances and Arbitrary-Order Statistical Moments*, Sandia report SAND2008-6212):
//! the statistics are the same to the last bit however many threads or machines computed the rows.

use std::borrow::Cow;

use dalembert_numerics::simd;
use serde::Serialize;

use super::{
    indices::{INDEPENDENT, IndexSums, SobolIndices, TWO_SIDED_95},
    levels::{LevelMean, LevelSums, Levels, share_between},
    rows::Rows,
    sample::{self, RowSample},
    values::{Histogram, Values},
};
use crate::Text;

/// Rows whose sums are taken together.
pub const BLOCK: usize = 4096;
/// Rows up to which the means at levels are those of all rows.
pub const LEVEL_ROWS: u64 = 250_000;
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
    /// Levels of every input, in its unit: the values of a grid, or the middles of intervals of equal probability.
    pub levels: Vec<Vec<f64>>,
    /// Pairs of inputs over which the answers are mapped, by their places.
    pub maps: Vec<[usize; 2]>,
    /// Of each answer, in its unit.
    pub answers: Vec<AnswerStatistics>,
    /// Some points, chosen at random: inputs and answers.
    #[serde(skip)]
    pub sample: Vec<Vec<f64>>,
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
    /// Values of [`PERCENTILES`](super::PERCENTILES).
    pub percentiles: Vec<f64>,
    /// Width of the bins that the percentiles were counted in; 0 where they are exact.
    pub bin_width: f64,
    /// Correlation coefficient with each input; 0 where one of them is constant.
    pub correlations: Vec<f64>,
    /// Main effects: the mean at each level of every input, over at most about [`LEVEL_ROWS`] points.
    pub effects: Vec<Vec<LevelMean>>,
    /// Share of the variance between the levels of each input; of independent inputs about their first-order index.
    pub shares: Vec<f64>,
    /// Of each map, the mean at the levels of both inputs, those of the second one fastest.
    pub maps: Vec<Vec<LevelMean>>,
    /// Sobol' indices, where the plan asks for them.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub sobol_indices: Option<SobolIndices>,
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

/// Statistics of rows that come one after another. Of the points of a base sample of Sobol' indices, the two that are
/// independent are taken; the others are for the indices alone.
#[derive(Clone, Debug)]
pub struct Accumulator {
    inputs: usize,
    limits: Vec<AnswerLimit>,
    levels: Vec<Levels>,
    maps: Vec<[usize; 2]>,
    /// The columns of the present block: inputs, then answers.
    columns: Vec<Vec<f64>>,
    /// Rows of the block that the means at levels are of.
    at_levels: Vec<usize>,
    /// The largest hash of a point that they are of.
    largest_hash: u64,
    /// Number of the first point, counted from 0.
    first: u64,
    points: u64,
    refused: u64,
    first_refusal: Option<(u64, Text)>,
    answers: Vec<AnswerSums>,
    base_sample: Option<BaseSample>,
    sample: RowSample,
}

/// Values of the answers at the points of a base sample, as far as they have come.
#[derive(Clone, Debug)]
struct BaseSample {
    points: usize,
    /// Of each answer.
    values: Vec<Vec<f64>>,
    sums: Vec<IndexSums>,
}

/// Moments of an answer about its mean, and of its products with the inputs.
#[derive(Clone, Debug, Default)]
struct AnswerSums {
    moments: Moments,
    inputs: Vec<Comoments>,
    exceeded: Vec<u64>,
    values: Values,
    /// Centre of the sums at levels: the first value.
    centre: Option<f64>,
    effects: Vec<LevelSums>,
    maps: Vec<LevelSums>,
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
            levels: Vec::new(),
            maps: Vec::new(),
            columns: vec![Vec::with_capacity(BLOCK); inputs + answers],
            at_levels: Vec::new(),
            largest_hash: 0,
            first: 0,
            points: 0,
            refused: 0,
            first_refusal: None,
            base_sample: None,
            sample: RowSample::default(),
        }
    }

    /// The same with the means at the levels of every input, and over pairs of inputs; of more than [`LEVEL_ROWS`] of
    /// so many rows these are those of about that number, chosen at random.
    #[must_use]
    pub fn with_levels(mut self, levels: Vec<Levels>, maps: Vec<[usize; 2]>, rows: u64) -> Self {
        let count = |input: usize| levels[input].values.len();
        for sums in &mut self.answers {
            sums.effects = (0..self.inputs).map(|input| LevelSums::new(count(input))).collect();
            sums.maps = maps.iter().map(|[a, b]| LevelSums::new(count(*a) * count(*b))).collect();
        }
        Self { levels, maps, largest_hash: sample::largest_hash(LEVEL_ROWS, rows), ..self }
    }

    /// The same with Sobol' indices from base samples of so many points.
    #[must_use]
    pub fn with_sobol_indices(self, points: usize) -> Self {
        let answers = self.answers.len();
        let base_sample = BaseSample {
            points,
            values: vec![Vec::with_capacity(points); answers],
            sums: vec![IndexSums::new(points.saturating_sub(INDEPENDENT)); answers],
        };
        Self { base_sample: Some(base_sample), ..self }
    }

    /// The same for rows from that point on, counted from 0.
    #[must_use]
    pub fn starting_at(self, first: u64) -> Self {
        Self { first, ..self }
    }

    /// Takes the next row: its inputs, its answers, NaN where there is none, and why the point was refused, if it was.
    pub fn push(&mut self, inputs: &[f64], answers: &[f64], refusal: Option<&Text>) {
        let point = self.first + self.points;
        self.points += 1;
        if let Some(why) = refusal {
            self.refused += 1;
            self.first_refusal.get_or_insert_with(|| (point + 1, why.clone()));
        }
        if let Some(base_sample) = &mut self.base_sample
            && !base_sample.take(point, answers)
        {
            return;
        }
        self.append(point, refusal.is_some(), (inputs, answers));
    }

    /// Takes the next rows.
    pub fn take(&mut self, rows: &Rows) {
        if !rows.refused.is_empty() || self.base_sample.is_some() {
            rows.iter().for_each(|row| self.push(row.inputs, row.answers, row.refusal));
            return;
        }
        let mut from = 0;
        while from < rows.len() {
            let to = rows.len().min(from + BLOCK - self.columns[self.inputs].len());
            let [of_inputs, of_answers] = self.widths().map(|width| from * width..to * width);
            let point = self.first + self.points;
            self.points += (to - from) as u64;
            self.append(point, false, (&rows.inputs[of_inputs], &rows.answers[of_answers]));
            from = to;
        }
    }

    /// Numbers of inputs and answers.
    fn widths(&self) -> [usize; 2] {
        [self.inputs, self.columns.len() - self.inputs]
    }

    /// Appends rows, the first of them of that point, to the present block, which has room for them.
    fn append(&mut self, first: u64, are_refused: bool, (inputs, answers): (&[f64], &[f64])) {
        let [inputs_of_row, answers_of_row] = self.widths();
        let begin = self.columns[self.inputs].len();
        let (of_inputs, of_answers) = self.columns.split_at_mut(inputs_of_row);
        for (columns, numbers) in [(of_inputs, inputs), (of_answers, answers)] {
            let width = columns.len();
            for (at, column) in columns.iter_mut().enumerate() {
                column.extend(numbers.iter().skip(at).step_by(width));
            }
        }
        let end = self.columns[self.inputs].len();
        if !are_refused && !self.levels.is_empty() {
            let mut largest_kept = self.sample.largest_hash();
            for (n, row) in (begin..end).enumerate() {
                let hash = sample::hash(first + n as u64);
                if hash < largest_kept {
                    let inputs = &inputs[n * inputs_of_row..][..inputs_of_row];
                    let answers = &answers[n * answers_of_row..][..answers_of_row];
                    self.sample.take(hash, inputs.iter().chain(answers).copied());
                    largest_kept = self.sample.largest_hash();
                }
                if hash <= self.largest_hash {
                    self.at_levels.push(row);
                }
            }
        }
        if end == BLOCK {
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
        let mut answers: Vec<AnswerStatistics> = self.answers.into_iter().enumerate().map(of).collect();
        let indices = self.base_sample.into_iter().flat_map(|base_sample| base_sample.sums);
        for (answer, sums) in answers.iter_mut().zip(indices) {
            answer.sobol_indices = Some(sums.indices());
        }
        Summary {
            points: self.points,
            refused: self.refused,
            first_refusal: self.first_refusal,
            levels: self.levels.into_iter().map(|levels| levels.values).collect(),
            maps: self.maps,
            answers,
            sample: self.sample.rows(),
        }
    }

    fn take_block(&mut self) {
        let (inputs, answers) = self.columns.split_at(self.inputs);
        let rows = || self.at_levels.iter();
        let level =
            |(input, levels): (&Vec<f64>, &Levels)| rows().map(|row| levels.of(input[*row])).collect();
        let levels: Vec<Vec<usize>> = inputs.iter().zip(&self.levels).map(level).collect();
        for (at, (answer, sums)) in answers.iter().zip(&mut self.answers).enumerate() {
            let of_answer = |column: &Vec<f64>| -> Vec<f64> {
                let kept = column.iter().zip(answer).filter(|(_, answer)| answer.is_finite());
                kept.map(|(value, _)| *value).collect()
            };
            let values = if answer.iter().all(|value| value.is_finite()) {
                sums.take(inputs, answer);
                Cow::Borrowed(answer)
            } else {
                let values = of_answer(answer);
                sums.take(&inputs.iter().map(of_answer).collect::<Vec<_>>(), &values);
                Cow::Owned(values)
            };
            let limits = self.limits.iter().filter(|limit| limit.answer == at);
            for (limit, count) in limits.zip(&mut sums.exceeded) {
                *count += values.iter().filter(|value| limit.is_exceeded(**value)).count() as u64;
            }
            let at_levels = rows().map(|row| answer[*row]).enumerate();
            let values = at_levels.filter(|(_, value)| value.is_finite());
            let Some(centre) = sums.centre.or_else(|| values.clone().next().map(|(_, value)| value)) else {
                continue;
            };
            sums.centre = Some(centre);
            for (levels, effects) in levels.iter().zip(&mut sums.effects) {
                values.clone().for_each(|(row, value)| effects.take(levels[row], value - centre));
            }
            for ([a, b], map) in self.maps.iter().zip(&mut sums.maps) {
                let columns = self.levels[*b].values.len();
                let cell = |row: usize| levels[*a][row] * columns + levels[*b][row];
                values.clone().for_each(|(row, value)| map.take(cell(row), value - centre));
            }
        }
        self.at_levels.clear();
        self.columns.iter_mut().for_each(Vec::clear);
    }
}

impl BaseSample {
    /// Takes the answers of the next point; true if it is one of the two that are independent.
    fn take(&mut self, point: u64, answers: &[f64]) -> bool {
        let place = (point % self.points as u64) as usize;
        for ((values, sums), answer) in self.values.iter_mut().zip(&mut self.sums).zip(answers) {
            if place == 0 {
                values.clear();
            }
            values.push(*answer);
            // What began before the first row is not whole.
            if place + 1 == self.points && values.len() == self.points {
                sums.take(values);
            }
        }
        place < INDEPENDENT
    }
}

impl AnswerLimit {
    pub(super) fn is_exceeded(&self, value: f64) -> bool {
        if self.above { value > self.limit } else { value < self.limit }
    }
}

impl AnswerSums {
    /// Takes the values of a block, and the inputs of the same rows.
    fn take(&mut self, inputs: &[Vec<f64>], values: &[f64]) {
        if values.is_empty() {
            return;
        }
        let count = values.len() as f64;
        let mean_of = |column: &[f64]| {
            simd::sums(
                [column],
                #[inline(always)]
                |[x]| [x],
            )[0] / count
        };
        let mean = mean_of(values);
        let powers = simd::sums(
            [values],
            #[inline(always)]
            |[x]| {
                let off = x - mean;
                let square = off * off;
                [square, square * off, square * square]
            },
        );
        let block = Moments { count, mean, powers };
        for (input, sums) in inputs.iter().zip(&mut self.inputs) {
            let mean_input = mean_of(input);
            let [square, product] = simd::sums(
                [input, values],
                #[inline(always)]
                |[x, y]| {
                    let off = x - mean_input;
                    [off * off, off * (y - mean)]
                },
            );
            *sums = sums.and(&self.moments, &Comoments { mean: mean_input, square, product }, &block);
        }
        self.moments = self.moments.and(&block);
        self.values.take(values);
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
        let means = |sums: &[LevelSums]| -> Vec<Vec<LevelMean>> {
            sums.iter().map(|sums| sums.means(self.centre.unwrap_or_default())).collect()
        };
        let (effects, maps) = (means(&self.effects), means(&self.maps));
        let variance = square / (count - 1.0);
        let shares = effects.iter().map(|levels| share_between(levels, variance)).collect();
        let [least, largest] = self.values.range();
        let (percentiles, bin_width, histogram) = self.values.distribution();
        AnswerStatistics {
            count: count as u64,
            mean,
            deviation: or_zero(variance.sqrt()),
            skewness: or_zero(count.sqrt() * cube / square.powf(1.5)),
            kurtosis: or_zero(count * fourth / (square * square) - 3.0),
            least,
            largest,
            percentiles,
            bin_width,
            correlations,
            effects,
            shares,
            maps,
            sobol_indices: None,
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
