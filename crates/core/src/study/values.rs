//! Distribution of the values of an answer: percentiles and frequencies, from values in their order.

use std::collections::BTreeMap;

use dalembert_numerics::{
    distribution::{quantile_of_ranks, ranks_about},
    simd,
};
use serde::Serialize;

use crate::{Answer, Axis, Plot, Series, Text, intern::fixed};

/// Percentiles of a summary, %.
pub const PERCENTILES: [f64; 7] = [2.5, 5.0, 25.0, 50.0, 75.0, 95.0, 97.5];
/// Rows up to which percentiles are exact.
pub(super) const MOST_EXACT: usize = 10_000_000;
/// Bins of equal width in which values are counted beyond that.
const BINS: usize = 100_000;
/// Bars of a histogram.
const BARS: usize = 24;
/// Parts of a bar, which are counted to find the values of a rank.
const PARTS: usize = 64;

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

/// All values up to [`MOST_EXACT`], then their counts in bins.
#[derive(Clone, Debug, Default)]
pub(super) struct Values {
    /// The least and the largest one.
    range: Option<[f64; 2]>,
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

/// Bars of equal width from the least to the largest value, each in [`PARTS`] parts.
struct Bars {
    least: f64,
    parts_per_unit: f64,
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

impl Values {
    pub(super) fn take(&mut self, values: &[f64]) {
        if values.is_empty() {
            return;
        }
        let [mut least, mut largest] = simd::range(values);
        if let Some(before) = self.range {
            [least, largest] = [least.min(before[0]), largest.max(before[1])];
        }
        self.range = Some([least, largest]);
        if self.bins.is_none() && self.exact.len() + values.len() > MOST_EXACT {
            // The ends are those of the values so far, and a tenth of their range beyond.
            let margin = (largest - least) / 10.0;
            let (from, width) = (least - margin, (largest - least + 2.0 * margin) / BINS as f64);
            let mut bins = Bins { from, width, counts: vec![0; BINS] };
            for value in std::mem::take(&mut self.exact) {
                bins.count(value);
            }
            self.bins = Some(bins);
        }
        match &mut self.bins {
            Some(bins) => values.iter().for_each(|value| bins.count(*value)),
            None => self.exact.extend_from_slice(values),
        }
    }

    /// The least and the largest value; zeros where there is none.
    pub(super) fn range(&self) -> [f64; 2] {
        self.range.unwrap_or_default()
    }

    /// Percentiles, the width of the bins that they were counted in, and the histogram.
    pub(super) fn distribution(self) -> (Vec<f64>, f64, Histogram) {
        let [least, largest] = self.range();
        let bars = Bars::new(least, largest);
        let mut counts = vec![0; BARS * PARTS];
        let shares = PERCENTILES.iter().map(|percent| percent / 100.0);
        let (percentiles, bin_width) = match &self.bins {
            None => {
                for value in &self.exact {
                    counts[bars.part(*value)] += 1;
                }
                let ranks = shares.clone().flat_map(|share| ranks_about(self.exact.len(), share));
                let ranked = values_of_ranks(&self.exact, ranks.collect(), &bars, &counts);
                let quantile = |share| {
                    quantile_of_ranks(self.exact.len(), share, |rank| ranked.get(&rank).map_or(0.0, |at| *at))
                };
                (shares.map(quantile).collect(), 0.0)
            }
            Some(bins) => {
                for (at, times) in bins.counts.iter().enumerate() {
                    let middle = (bins.from + (at as f64 + 0.5) * bins.width).clamp(least, largest);
                    counts[bars.part(middle)] += times;
                }
                let percentile = |share| bins.quantile(share).clamp(least, largest);
                (shares.map(percentile).collect(), bins.width)
            }
        };
        let width = (largest - least) / BARS as f64;
        let mut histogram = Histogram { from: least, width, counts: Vec::new() };
        if width > 0.0 {
            histogram.counts = counts.chunks(PARTS).map(|parts| parts.iter().sum()).collect();
        }
        (percentiles, bin_width, histogram)
    }
}

impl Bars {
    fn new(least: f64, largest: f64) -> Self {
        Self { least, parts_per_unit: (BARS * PARTS) as f64 / (largest - least) }
    }

    /// The part that a value lies in; of larger values no smaller one.
    #[inline(always)]
    fn part(&self, value: f64) -> usize {
        (((value - self.least) * self.parts_per_unit) as usize).min(BARS * PARTS - 1)
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

/// The values of these ranks in ascending order, counted from 0. Only the values in the parts that hold such a rank, of
/// which the counts are known, are put in order.
fn values_of_ranks(
    values: &[f64],
    mut ranks: Vec<usize>,
    bars: &Bars,
    counts: &[u64],
) -> BTreeMap<usize, f64> {
    ranks.retain(|rank| *rank < values.len());
    ranks.sort_unstable();
    ranks.dedup();
    let mut left = &ranks[..];
    let mut begin = 0;
    // Of each part that holds ranks: the ranks, counted from its beginning, and its values.
    let mut parts: Vec<Option<(usize, Vec<usize>, Vec<f64>)>> = Vec::with_capacity(counts.len());
    for count in counts {
        let end = begin + *count as usize;
        let (inside, beyond) = left.split_at(left.partition_point(|rank| *rank < end));
        let inside: Vec<usize> = inside.iter().map(|rank| rank - begin).collect();
        parts.push((!inside.is_empty()).then(|| (begin, inside, Vec::with_capacity(*count as usize))));
        (left, begin) = (beyond, end);
    }
    for value in values {
        if let Some((_, _, inside)) = &mut parts[bars.part(*value)] {
            inside.push(*value);
        }
    }
    let mut ranked = BTreeMap::new();
    for (begin, ranks, mut inside) in parts.into_iter().flatten() {
        put_in_order(&mut inside, &ranks);
        ranked.extend(ranks.iter().map(|rank| (begin + rank, inside[*rank])));
    }
    ranked
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
