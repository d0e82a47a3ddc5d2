//! Stiffnesses that keep the whirl within the clearance over a whole range of speeds.

use std::ops::Bound::{Excluded, Included, Unbounded};

use dalembert_numerics::intervals::IntervalSet;

/// The stiffnesses that keep the rotor clear, and what limits them.
///
/// The forbidden stiffnesses are one gap: from `soft`, or from zero, up to `stiff`.
#[derive(Debug, Clone, PartialEq)]
pub struct PermittedStiffness {
    /// Permitted stiffnesses, N/m, a part of `[0, ∞)`.
    pub set: IntervalSet,
    /// The largest stiffness of the soft branch, where the rotor runs above its critical speed; `None` when
    /// nothing is forbidden or no soft shaft is permitted.
    pub soft: Option<StiffnessLimit>,
    /// The smallest stiffness of the stiff branch, where the rotor runs below its critical speed; `None` when
    /// nothing is forbidden: the clearance is never reached.
    pub stiff: Option<StiffnessLimit>,
}

/// A stiffness at which the amplitude just reaches the clearance.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StiffnessLimit {
    /// The stiffness, N/m.
    pub stiffness: f64,
    /// The speed at which the clearance is reached, rad/s.
    pub speed: f64,
    /// Position of that speed in the range.
    pub by: LimitedBy,
}

/// Position in a range of speeds of the maximum amplitude.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LimitedBy {
    /// At the lowest speed.
    LowestSpeed,
    /// At the highest speed.
    HighestSpeed,
    /// At a resonance peak within the range.
    Peak,
}

/// Data that do not describe a rotor.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum WhirlError {
    /// The mass is not positive and finite.
    #[error("the mass is {0}; it must be positive and finite")]
    Mass(f64),
    /// The stiffness is not zero or positive, or not finite.
    #[error("the stiffness is {0}; it must be zero or positive, and finite")]
    Stiffness(f64),
    /// The unbalance is negative or not finite.
    #[error("the unbalance is {0}; it must be zero or positive, and finite")]
    Unbalance(f64),
    /// The clearance is not positive and finite.
    #[error("the clearance is {0}; it must be positive and finite")]
    Clearance(f64),
    /// The damping is negative or not finite.
    #[error("the damping is {0}; it must be zero or positive, and finite")]
    Damping(f64),
    /// The speeds are negative, not finite or out of order.
    #[error("the speeds are {lowest} to {highest}; they must be zero or positive, finite and ascending")]
    Speeds {
        /// Given lowest speed.
        lowest: f64,
        /// Given highest speed.
        highest: f64,
    },
    /// A limit is too large or too small for a number.
    #[error("a limit of the stiffness is beyond the range of numbers")]
    OutOfRange,
}

/// All stiffnesses `k ≥ 0` for which `X(ω; k) ≤ R` at every speed of a range, with the damping *ratio* fixed, so
/// that `c = 2ζ√(k m)` follows the stiffness.
///
/// Exact: at one speed the forbidden stiffnesses are `q₁ < k/(m ω²) < q₂`, the roots of
/// `q² − 2(1 − 2ζ²)q + 1 − (m e/(m R))² = 0`; over a range of speeds these intervals overlap into one, from `q₁` at
/// the lowest speed to `q₂` at the highest. The height of the peak does not depend on the stiffness here, so it
/// decides only whether anything is forbidden: nothing is while `e/(2ζ√(1 − ζ²)) ≤ R`.
///
/// # Errors
/// [`WhirlError`] names the datum that is out of place.
pub fn permitted_stiffness(
    mass: f64,
    unbalance: f64,
    clearance: f64,
    speeds: [f64; 2],
    damping_ratio: f64,
) -> Result<PermittedStiffness, WhirlError> {
    check(mass, unbalance, clearance, speeds, damping_ratio)?;
    let [lowest, highest] = speeds;
    let Some([lower, upper]) = forbidden_ratios(unbalance / clearance / mass, damping_ratio) else {
        return Ok(nothing_forbidden());
    };
    let soft = StiffnessLimit {
        stiffness: lower * mass * lowest.powi(2),
        speed: lowest,
        by: LimitedBy::LowestSpeed,
    };
    let stiff = StiffnessLimit {
        stiffness: upper * mass * highest.powi(2),
        speed: highest,
        by: LimitedBy::HighestSpeed,
    };
    permitted_outside((lower >= 0.0).then_some(soft), stiff)
}

/// All stiffnesses `k ≥ 0` for which `X(ω; k) ≤ R` at every speed of a range, with the damping *coefficient* fixed.
///
/// Exact: with `u = m e/R`, at one speed the forbidden stiffnesses lie within `√((u ω²)² − (c ω)²)` of `m ω²`, none
/// below the speed `c/u`. The upper limit grows with the speed. The lower one is least where the peak of the
/// response touches the clearance, at `ω² = c²/(2u²) (1 + m/√(m² − u²))` with `k = c²/(2u²) (m + √(m² − u²))`,
/// or else at the end of the range nearest to that speed.
///
/// # Errors
/// [`WhirlError`] names the datum that is out of place.
pub fn permitted_stiffness_at_damping(
    mass: f64,
    unbalance: f64,
    clearance: f64,
    speeds: [f64; 2],
    damping: f64,
) -> Result<PermittedStiffness, WhirlError> {
    check(mass, unbalance, clearance, speeds, damping)?;
    let [lowest, highest] = speeds;
    let reach = unbalance / clearance;
    if reach * highest <= damping {
        return Ok(nothing_forbidden());
    }
    let half_width =
        |speed: f64| speed * ((reach * speed - damping) * (reach * speed + damping)).max(0.0).sqrt();
    let stiff = StiffnessLimit {
        stiffness: mass * highest.powi(2) + half_width(highest),
        speed: highest,
        by: LimitedBy::HighestSpeed,
    };

    let at_end = |speed: f64, by| {
        // m ω² − √((u ω²)² − (c ω)²) without the cancellation.
        let sum = mass * speed.powi(2) + half_width(speed);
        let stiffness = speed.powi(2)
            * ((mass - reach) * ((mass + reach) * speed.powi(2) / sum) + damping * (damping / sum));
        StiffnessLimit { stiffness, speed, by }
    };
    let soft = if reach >= mass {
        at_end(highest, LimitedBy::HighestSpeed)
    } else {
        let root = mass * ((1.0 - reach / mass) * (1.0 + reach / mass)).sqrt();
        let tangent = damping / reach * (0.5 + mass / (2.0 * root)).sqrt();
        if tangent > highest {
            at_end(highest, LimitedBy::HighestSpeed)
        } else if tangent > lowest {
            StiffnessLimit {
                stiffness: (damping / reach).powi(2) * (mass + root) / 2.0,
                speed: tangent,
                by: LimitedBy::Peak,
            }
        } else if lowest == 0.0 {
            // Undamped from rest: every stiffness but zero meets its resonance.
            StiffnessLimit { stiffness: 0.0, speed: 0.0, by: LimitedBy::LowestSpeed }
        } else {
            at_end(lowest, LimitedBy::LowestSpeed)
        }
    };
    permitted_outside((soft.stiffness >= 0.0).then_some(soft), stiff)
}

/// The speed of a range at which the amplitude of a given rotor is largest, and where in the range it lies.
///
/// The amplitude has one peak at most, at `ω² = 2k²/(2k m − c²)`, and none when `c² ≥ 2k m`; the worst speed is the
/// point of the range nearest to it. An undamped rotor with its critical speed within the range has no finite
/// amplitude there.
///
/// # Errors
/// [`WhirlError`] names the datum that is out of place.
pub fn worst_speed(
    stiffness: f64,
    mass: f64,
    damping: f64,
    speeds: [f64; 2],
) -> Result<(f64, LimitedBy), WhirlError> {
    check(mass, 0.0, 1.0, speeds, damping)?;
    if !(stiffness.is_finite() && stiffness >= 0.0) {
        return Err(WhirlError::Stiffness(stiffness));
    }
    let [lowest, highest] = speeds;
    // The peak is at ω_n/√(1 − 2ζ²); without one the amplitude grows with the speed.
    let spare = 1.0 - damping / stiffness * (damping / mass) / 2.0;
    let peak = if stiffness > 0.0 && spare > 0.0 { (stiffness / mass / spare).sqrt() } else { f64::INFINITY };
    Ok(if peak <= lowest {
        (lowest, LimitedBy::LowestSpeed)
    } else if peak >= highest {
        (highest, LimitedBy::HighestSpeed)
    } else {
        (peak, LimitedBy::Peak)
    })
}

/// The open interval of `k/(m ω²)` in which the amplitude exceeds the clearance, `μ = m e/(m R)`; a lower end below
/// zero means that it reaches down to zero and includes it.
pub(super) fn forbidden_ratios(mu: f64, damping_ratio: f64) -> Option<[f64; 2]> {
    let middle = 1.0 - 2.0 * damping_ratio.powi(2);
    let shift = 2.0 * damping_ratio * (1.0 - damping_ratio.powi(2)).max(0.0).sqrt();
    let squared_width = if damping_ratio < 1.0 {
        (mu - shift) * (mu + shift)
    } else {
        mu.powi(2) + 4.0 * damping_ratio.powi(2) * (damping_ratio.powi(2) - 1.0)
    };
    if squared_width <= 0.0 || (middle <= 0.0 && mu <= 1.0) {
        return None;
    }
    let width = squared_width.sqrt();
    // The product of the roots is 1 − μ²: the small one follows from the large one without cancellation.
    let product = (1.0 - mu) * (1.0 + mu);
    Some(if middle > 0.0 {
        let upper = middle + width;
        [product / upper, upper]
    } else {
        let lower = middle - width;
        [lower, product / lower]
    })
}

fn permitted_outside(
    soft: Option<StiffnessLimit>,
    stiff: StiffnessLimit,
) -> Result<PermittedStiffness, WhirlError> {
    if !(stiff.stiffness.is_finite() && soft.is_none_or(|soft| soft.stiffness.is_finite())) {
        return Err(WhirlError::OutOfRange);
    }
    if stiff.stiffness == 0.0 {
        // The rotor is at rest, or the numbers are too small to tell.
        return if stiff.speed == 0.0 { Ok(nothing_forbidden()) } else { Err(WhirlError::OutOfRange) };
    }
    let lower = soft.map_or(Included(0.0), |soft| Excluded(soft.stiffness));
    let forbidden = IntervalSet::interval(lower, Excluded(stiff.stiffness));
    let set = forbidden.complement().intersection(&nothing_forbidden().set);
    Ok(PermittedStiffness { set, soft, stiff: Some(stiff) })
}

fn nothing_forbidden() -> PermittedStiffness {
    let set = IntervalSet::interval(Included(0.0), Unbounded);
    PermittedStiffness { set, soft: None, stiff: None }
}

pub(super) fn check(
    mass: f64,
    unbalance: f64,
    clearance: f64,
    speeds: [f64; 2],
    damping: f64,
) -> Result<(), WhirlError> {
    let [lowest, highest] = speeds;
    let at_least_zero = |number: f64| number.is_finite() && number >= 0.0;
    if !(mass.is_finite() && mass > 0.0) {
        Err(WhirlError::Mass(mass))
    } else if !at_least_zero(unbalance) {
        Err(WhirlError::Unbalance(unbalance))
    } else if !(clearance.is_finite() && clearance > 0.0) {
        Err(WhirlError::Clearance(clearance))
    } else if !at_least_zero(damping) {
        Err(WhirlError::Damping(damping))
    } else if !(at_least_zero(lowest) && at_least_zero(highest) && lowest <= highest) {
        Err(WhirlError::Speeds { lowest, highest })
    } else if !(unbalance / clearance / mass).powi(2).is_finite()
        || !damping.powi(4).is_finite()
        || !(mass * highest.powi(2)).is_finite()
    {
        Err(WhirlError::OutOfRange)
    } else {
        Ok(())
    }
}
