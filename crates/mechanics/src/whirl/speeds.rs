//! The speeds at which the whirl of a given rotor stays within a limit, and the largest unbalance that does so.

use std::ops::Bound::{Excluded, Included, Unbounded};

use super::permitted::{WhirlError, check, forbidden_ratios};
use dalembert_numerics::intervals::IntervalSet;

/// The speeds at which the whirl stays within a limit.
#[derive(Debug, Clone, PartialEq)]
pub struct PermittedSpeeds {
    /// Permitted speeds, rad/s, a part of `[0, ∞)`.
    pub set: IntervalSet,
    /// Below the critical speed: the speed at which the limit is reached; `None` when it never is.
    pub below: Option<f64>,
    /// Above the critical speed: the speed from which the whirl is within the limit again; `None` when the limit is
    /// never reached, and when the rotor never comes back within it, the eccentricity being as large as the limit.
    pub above: Option<f64>,
}

/// All speeds `ω ≥ 0` at which the whirl amplitude is at most `R`: with `μ = e/R` the forbidden ones are
/// `q₁ < ω_n²/ω² < q₂`, the roots of `q² − 2(1 − 2ζ²)q + 1 − μ² = 0`.
///
/// # Errors
/// [`WhirlError`] names the datum that is out of place.
pub fn permitted_speeds(
    natural_frequency: f64,
    eccentricity: f64,
    limit: f64,
    damping_ratio: f64,
) -> Result<PermittedSpeeds, WhirlError> {
    check(1.0, eccentricity, limit, [0.0, natural_frequency], damping_ratio)?;
    let all = IntervalSet::interval(Included(0.0), Unbounded);
    let Some([lower, upper]) = forbidden_ratios(eccentricity / limit, damping_ratio) else {
        return Ok(PermittedSpeeds { set: all, below: None, above: None });
    };
    let below = natural_frequency / upper.sqrt();
    let above = (lower > 0.0).then(|| natural_frequency / lower.sqrt());
    if !(below.is_finite() && above.is_none_or(f64::is_finite)) {
        return Err(WhirlError::OutOfRange);
    }
    let forbidden = IntervalSet::interval(Excluded(below), above.map_or(Unbounded, Excluded));
    Ok(PermittedSpeeds { set: forbidden.complement().intersection(&all), below: Some(below), above })
}
