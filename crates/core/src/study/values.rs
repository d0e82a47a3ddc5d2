//! Distribution of the values of an answer: percentiles and frequencies, from values in their order.

use dalembert_numerics::distribution::quantile_of_sorted;
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
    /// The least one.
    pub(super) least: Option<f64>,
    /// The largest one.
    pub(super) largest: Option<f64>,
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
        let least = values.iter().copied().chain(self.least).reduce(f64::min);
        let largest = values.iter().copied().chain(self.largest).reduce(f64::max);
        (self.least, self.largest) = (least, largest);
        if self.bins.is_none() && self.exact.len() + values.len() > MOST_EXACT {
            // The ends are those of the values so far, and a tenth of their range beyond.
            let (least, largest) = (least.unwrap_or_default(), largest.unwrap_or_default());
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

    /// Percentiles, the width of the bins that they were counted in, and the histogram.
    pub(super) fn distribution(mut self) -> (Vec<f64>, f64, Histogram) {
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
