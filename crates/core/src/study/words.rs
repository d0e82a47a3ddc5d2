//! Statistics of an answer in words and as a plot.

use super::{AnswerStatistics, PERCENTILES};
use crate::{Answer, Plot, Text, intern::fixed};

impl AnswerStatistics {
    /// Mean, standard deviation and interval of an answer that scatters.
    pub fn words(&self, answer: &Answer) -> Vec<Text> {
        let unit = fixed(&answer.unit);
        let [low, high] = self.interval().map(|value| answer.unit.si(value));
        let mean = Text::new("mean {mean}, standard deviation {deviation}")
            .with_quantity("mean", answer.unit.si(self.mean), unit)
            .with_quantity("deviation", answer.unit.si(self.deviation), unit);
        let ends = Text::new("95 % interval: {low} to {high}");
        vec![mean, ends.with_quantity("low", low, unit).with_quantity("high", high, unit)]
    }

    /// Quartiles, extent and shape of the distribution of an answer.
    pub fn details(&self, answer: &Answer) -> Vec<Text> {
        let quartiles = ["first", "median", "third"].into_iter().zip([25.0, 50.0, 75.0]).fold(
            Text::new("quartiles {first}, {median}, {third}"),
            |text, (name, percent)| {
                text.with_quantity(name, answer.unit.si(self.percentile(percent)), fixed(&answer.unit))
            },
        );
        let shape = Text::new("skewness {skewness}, excess kurtosis {kurtosis}")
            .with_quantity("skewness", (1e3 * self.skewness).round() / 1e3, "1")
            .with_quantity("kurtosis", (1e3 * self.kurtosis).round() / 1e3, "1");
        vec![quartiles, self.extent(answer), shape]
    }

    /// Least and largest value of an answer.
    pub fn extent(&self, answer: &Answer) -> Text {
        let unit = fixed(&answer.unit);
        Text::new("minimum {least}, maximum {largest}")
            .with_quantity("least", answer.unit.si(self.least), unit)
            .with_quantity("largest", answer.unit.si(self.largest), unit)
    }

    /// Shares of the points beyond the limits of an answer.
    pub fn words_of_limits(&self, answer: &Answer) -> Vec<Text> {
        let words = |limit: &super::Exceedance| {
            let text = if limit.above {
                "above {limit}: {share}, 95 % interval {low} to {high}"
            } else {
                "below {limit}: {share}, 95 % interval {low} to {high}"
            };
            let shares = [limit.probability, limit.interval[0], limit.interval[1]].map(three_digits);
            ["share", "low", "high"].into_iter().zip(shares).fold(
                Text::new(text).with_quantity("limit", answer.unit.si(limit.limit), fixed(&answer.unit)),
                |text, (name, share)| text.with_quantity(name, share, "%"),
            )
        };
        self.exceedances.iter().map(words).collect()
    }

    /// The relative frequencies of an answer as a plot, with the interval that holds 95 % of the values; `None` where
    /// all values are one.
    pub fn distribution(&self, answer: &Answer) -> Option<Plot> {
        let plot = self.histogram.plot(answer, |value| answer.unit.si(value))?;
        let [low, high] = self.interval().map(|value| answer.unit.si(value));
        Some(plot.band("95 %", low, high, true))
    }

    /// The interval that holds 95 % of the values.
    fn interval(&self) -> [f64; 2] {
        [2.5, 97.5].map(|percent| self.percentile(percent))
    }

    fn percentile(&self, percent: f64) -> f64 {
        let at = PERCENTILES.iter().position(|known| *known == percent);
        at.and_then(|at| self.percentiles.get(at)).copied().unwrap_or(self.mean)
    }
}

/// A share to three significant digits.
fn three_digits(share: f64) -> f64 {
    let unit = 10f64.powf(share.abs().log10().floor() - 2.0);
    if share == 0.0 { 0.0 } else { (share / unit).round() * unit }
}
