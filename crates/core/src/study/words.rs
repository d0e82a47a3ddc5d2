//! Statistics of an answer in words and as a plot.

use super::{AnswerStatistics, PERCENTILES};
use crate::{Answer, Plot, Text, intern::fixed};

impl AnswerStatistics {
    /// Moments and percentiles of an answer that scatters.
    pub fn words(&self, answer: &Answer) -> Vec<Text> {
        let unit = fixed(&answer.unit);
        let shown = |text: Text, name: &'static str, value: f64| {
            text.with_quantity(name, answer.unit.si(value), unit)
        };
        let [low, high] = self.interval();
        let mean = shown(Text::new("mean {mean}, standard deviation {deviation}"), "mean", self.mean);
        let ends = shown(Text::new("95 % interval: {low} to {high}"), "low", low);
        let quartiles =
            shown(Text::new("quartiles {first}, {median}, {third}"), "first", self.percentile(25.0));
        let quartiles = shown(quartiles, "median", self.percentile(50.0));
        let shape = Text::new("skewness {skewness}, excess kurtosis {kurtosis}")
            .with_quantity("skewness", self.skewness, "1")
            .with_quantity("kurtosis", self.kurtosis, "1");
        vec![
            shown(mean, "deviation", self.deviation),
            shown(ends, "high", high),
            shown(quartiles, "third", self.percentile(75.0)),
            self.extent(answer),
            shape,
        ]
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
            let shares = [limit.probability, limit.interval[0], limit.interval[1]];
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
