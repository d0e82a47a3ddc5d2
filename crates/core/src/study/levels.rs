//! Levels of inputs, and the means of answers at them: the main effects of the inputs, and maps over two of them.

use dalembert_numerics::distribution::Distribution;
use serde::Serialize;

/// Intervals of equal probability of an input that is drawn.
const INTERVALS: usize = 10;
/// Values of a grid up to which each is a level of its own; more are taken together.
const MOST_LEVELS: u64 = 24;

/// Levels of an input: the values of a grid, or intervals.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Levels {
    /// A value of each level, ascending: its own one, or the middle one of the interval.
    pub values: Vec<f64>,
    /// The ends between them.
    edges: Vec<f64>,
}

/// Mean of an answer over the points of a level, or of a cell of two inputs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct LevelMean {
    /// Number of points that have the answer.
    pub count: u64,
    /// Mean; 0 where there are none.
    pub mean: f64,
}

/// Sums of an answer over the points of each level or cell.
#[derive(Clone, Debug, Default)]
pub(super) struct LevelSums {
    counts: Vec<u64>,
    /// Of the differences from a centre.
    sums: Vec<f64>,
}

impl Levels {
    /// The levels of values of a grid.
    pub(super) fn of_values(values: impl Iterator<Item = f64>) -> Self {
        let mut values: Vec<f64> = values.collect();
        values.sort_by(f64::total_cmp);
        values.dedup();
        Self::of_ascending(values.len() as u64, |at| values[at as usize])
    }

    /// The levels of so many ascending values: one for each, or for as many neighbouring ones as make few of them.
    pub(super) fn of_ascending(count: u64, value: impl Fn(u64) -> f64) -> Self {
        let levels = count.min(MOST_LEVELS);
        let begin = |level: u64| (u128::from(level) * u128::from(count) / u128::from(levels)) as u64;
        let middle = |level: u64| begin(level).midpoint(begin(level + 1) - 1);
        Self {
            values: (0..levels).map(|level| value(middle(level))).collect(),
            edges: (1..levels)
                .map(|level| f64::midpoint(value(begin(level) - 1), value(begin(level))))
                .collect(),
        }
    }

    /// Intervals of equal probability; one that a value with more of it fills has none of its own.
    pub(super) fn of_distribution(distribution: &Distribution) -> Self {
        let at = |tenths: f64| distribution.quantile(tenths / INTERVALS as f64);
        let lower = |n: usize| if n == 0 { f64::NEG_INFINITY } else { at(n as f64) };
        let upper = |n: usize| if n + 1 == INTERVALS { f64::INFINITY } else { at((n + 1) as f64) };
        let own: Vec<usize> = (0..INTERVALS).filter(|n| lower(*n) < upper(*n)).collect();
        Self {
            values: own.iter().map(|n| at(*n as f64 + 0.5)).collect(),
            edges: own.iter().skip(1).map(|n| lower(*n)).collect(),
        }
    }

    /// The level of a value.
    pub(super) fn of(&self, value: f64) -> usize {
        self.edges.iter().map(|edge| usize::from(value >= *edge)).sum()
    }
}

impl LevelSums {
    pub(super) fn new(levels: usize) -> Self {
        Self { counts: vec![0; levels], sums: vec![0.0; levels] }
    }

    /// Takes a value at a level, as its difference from the centre.
    pub(super) fn take(&mut self, level: usize, difference: f64) {
        self.counts[level] += 1;
        self.sums[level] += difference;
    }

    pub(super) fn means(&self, centre: f64) -> Vec<LevelMean> {
        let mean = |(count, sum): (&u64, &f64)| match count {
            0 => LevelMean::default(),
            count => LevelMean { count: *count, mean: centre + sum / *count as f64 },
        };
        self.counts.iter().zip(&self.sums).map(mean).collect()
    }
}

/// Share of the variance of an answer that lies between its means at levels: the square of the correlation ratio, without what levels
/// would have by chance (T. L. Kelley, *Proc. Natl. Acad. Sci.* 21, 1935, 554–559).
pub(super) fn share_between(levels: &[LevelMean], variance: f64) -> f64 {
    let taken = || levels.iter().filter(|level| level.count > 0);
    let count: f64 = taken().map(|level| level.count as f64).sum();
    let mean = taken().map(|level| level.count as f64 * level.mean).sum::<f64>() / count;
    let between: f64 = taken().map(|level| level.count as f64 * (level.mean - mean).powi(2)).sum();
    let all = variance * (count - 1.0);
    let freedom = taken().count() as f64 - 1.0;
    let by_chance = (all - between).max(0.0) * freedom / (count - 1.0 - freedom);
    let share = (between - by_chance) / all;
    if share.is_finite() { share.clamp(0.0, 1.0) } else { 0.0 }
}
