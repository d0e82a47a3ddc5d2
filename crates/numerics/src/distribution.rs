//! Probability distributions by their quantile functions.

use statrs::distribution::{ContinuousCDF as _, Normal};

/// A distribution of a number.
#[derive(Clone, Debug, PartialEq)]
pub enum Distribution {
    /// The same density between two ends.
    Uniform {
        /// Least value.
        from: f64,
        /// Largest value.
        to: f64,
    },
    /// Normal.
    Normal {
        /// Mean.
        mean: f64,
        /// Standard deviation.
        deviation: f64,
    },
    /// Triangular.
    Triangular {
        /// Least value.
        from: f64,
        /// Most probable value.
        mode: f64,
        /// Largest value.
        to: f64,
    },
    /// Lognormal: the logarithm is normal.
    Lognormal {
        /// Mean of the logarithm.
        mean: f64,
        /// Standard deviation of the logarithm.
        deviation: f64,
    },
    /// Measured values, ascending, with straight lines between them in the cumulative distribution.
    Data(Vec<f64>),
}

impl Distribution {
    /// Uniform between two ends; `None` unless they ascend.
    pub fn uniform(from: f64, to: f64) -> Option<Self> {
        (from < to && (to - from).is_finite()).then_some(Self::Uniform { from, to })
    }

    /// Normal; `None` unless the numbers are finite and the standard deviation above zero.
    pub fn normal(mean: f64, deviation: f64) -> Option<Self> {
        (mean.is_finite() && deviation.is_finite() && deviation > 0.0)
            .then_some(Self::Normal { mean, deviation })
    }

    /// Triangular with its peak between two ends; `None` unless they ascend.
    pub fn triangular(from: f64, mode: f64, to: f64) -> Option<Self> {
        (from < to && (from..=to).contains(&mode) && (to - from).is_finite()).then_some(Self::Triangular {
            from,
            mode,
            to,
        })
    }

    /// Lognormal by the mean `m` and the standard deviation `s` of the number itself, whose logarithm has the variance
    /// `σ² = ln(1 + s²/m²)` and the mean `ln m − σ²/2`; `None` unless both are above zero.
    pub fn lognormal(mean: f64, deviation: f64) -> Option<Self> {
        let variance = (deviation / mean).powi(2).ln_1p();
        (mean > 0.0 && deviation > 0.0 && variance.is_finite() && mean.is_finite())
            .then(|| Self::Lognormal { mean: mean.ln() - variance / 2.0, deviation: variance.sqrt() })
    }

    /// Measured values; `None` unless there are two finite ones.
    pub fn of_data(mut values: Vec<f64>) -> Option<Self> {
        values.sort_by(f64::total_cmp);
        (values.len() >= 2 && values.iter().all(|value| value.is_finite())).then_some(Self::Data(values))
    }

    /// The value below which a share of all lies, for shares strictly between 0 and 1.
    pub fn quantile(&self, share: f64) -> f64 {
        match self {
            Self::Uniform { from, to } => from + (to - from) * share,
            Self::Normal { mean, deviation } => mean + deviation * normal_quantile(share),
            Self::Lognormal { mean, deviation } => (mean + deviation * normal_quantile(share)).exp(),
            Self::Triangular { from, mode, to } => {
                let width = to - from;
                if share * width < mode - from {
                    from + (share * width * (mode - from)).sqrt()
                } else {
                    to - ((1.0 - share) * width * (to - mode)).sqrt()
                }
            }
            Self::Data(values) => quantile_of_sorted(values, share),
        }
    }
}

/// The value below which a share of ascending values lies, with straight lines between them: definition 7 of R. J. Hyndman
/// and Y. Fan, *Am. Stat.* 50 (1996). Of no values 0.
pub fn quantile_of_sorted(values: &[f64], share: f64) -> f64 {
    let place = share * values.len().saturating_sub(1) as f64;
    let below = (place.floor() as usize).min(values.len().saturating_sub(1));
    let Some(low) = values.get(below) else { return 0.0 };
    match values.get(below + 1) {
        Some(high) => low + (high - low) * (place - below as f64),
        None => *low,
    }
}

/// The standard normal number below which a share lies, for shares strictly between 0 and 1.
pub fn normal_quantile(share: f64) -> f64 {
    Normal::standard().inverse_cdf(share)
}

/// The share of standard normal numbers below a number, kept strictly between 0 and 1.
pub fn normal_cumulative(number: f64) -> f64 {
    Normal::standard().cdf(number).clamp(f64::MIN_POSITIVE, 1.0 - f64::EPSILON / 2.0)
}
