//! The speeds that keep the whirl of a known rotor within an amplitude.

use std::ops::Bound::{Excluded, Included, Unbounded};

use dalembert_core::{Refusal, Text, Worksheet};
use dalembert_mechanics::{
    Real,
    whirl::{self, PermittedSpeeds},
};
use dalembert_numerics::intervals::{Interval, IntervalSet};

use crate::sources::RAO;

/// Parameters of the whirl of a rotor.
#[derive(Clone, Copy)]
pub(crate) struct Whirl<N> {
    /// Critical speed.
    pub(crate) natural: N,
    /// Distance of the centre of mass from the axis.
    pub(crate) eccentricity: N,
    /// Damping ratio; `None` without damping.
    pub(crate) damping_ratio: Option<N>,
}

/// Answers the speeds whose whirl amplitude is at most `amplitude`, and gives them as pairs of their ends.
pub(crate) fn permitted_speeds<W: Worksheet>(
    whirl: &Whirl<W::Num>,
    amplitude: W::Num,
    sheet: W,
) -> Result<Vec<(f64, f64)>, Refusal> {
    let zeta = whirl.damping_ratio.map_or(0.0, Real::value);
    let [natural, eccentricity] = [whirl.natural, whirl.eccentricity].map(Real::value);
    let permitted = whirl::permitted_speeds(natural, eccentricity, amplitude.value(), zeta)
        .map_err(|_| Refusal::because("the limit leads to values outside the representable range"))?;
    let limits = ends(whirl, amplitude, &permitted, sheet);
    sheet.answer_set("speeds", "Permitted speeds", "rpm", &permitted.set, limits);
    if permitted.below.is_none() {
        sheet.warn(|| {
            Text::new(
                "the limit is not a constraint: with this damping the whirl stays within it at every speed",
            )
        });
    } else if permitted.above.is_none() {
        sheet.warn(|| {
            Text::new(
                "the amplitude does not return within the limit above the critical speed: there it decreases towards the eccentricity, which is not below the limit",
            )
        });
    } else {
        sheet.warn(|| {
            Text::new(
                "above the forbidden range the rotor has passed its critical speed: run through the range quickly",
            )
        });
    }
    Ok(pairs(&permitted.set))
}

/// The intervals of a set as pairs of their ends: zero and infinity where they are unbounded.
pub(crate) fn pairs(set: &IntervalSet) -> Vec<(f64, f64)> {
    let pair = |interval: Interval| {
        let from = match interval.lower {
            Included(x) | Excluded(x) => x,
            Unbounded => 0.0,
        };
        let to = match interval.upper {
            Included(x) | Excluded(x) => x,
            Unbounded => f64::INFINITY,
        };
        (from, to)
    };
    set.intervals().map(pair).collect()
}

/// The ends of the forbidden band, with what limits each end of the permitted set.
fn ends<W: Worksheet>(
    whirl: &Whirl<W::Num>,
    amplitude: W::Num,
    permitted: &PermittedSpeeds,
    sheet: W,
) -> Vec<Text> {
    let Some(lower) = permitted.below else { return Vec::new() };
    let Whirl { eccentricity, natural, damping_ratio } = *whirl;
    let share = damping_ratio.map(|_| {
        sheet.step(
            "µ",
            "1",
            eccentricity / amplitude,
            "Eccentricity as a fraction of the permitted amplitude",
        )
    });
    let hold = |speed: W::Num, kernel: f64| {
        sheet.check(
            "the whirl amplitude at that speed equals the permitted value",
            match damping_ratio {
                Some(zeta) => whirl::whirl_amplitude(eccentricity, speed / natural, zeta),
                None => {
                    let ratio = (speed / natural).powi(2);
                    eccentricity * ratio / (W::Num::from(1.0) - ratio).abs()
                }
            },
            amplitude,
        );
        sheet.check("end of the band from its other formula", speed, kernel.into());
    };
    let below = match (damping_ratio, share) {
        (Some(zeta), Some(share)) => whirl::speed_below(natural, share, zeta),
        _ => whirl::speed_below_undamped(natural, eccentricity, amplitude),
    };
    let one = W::Num::from(1.0);
    let forced = || natural * (one - eccentricity / amplitude).sqrt();
    sheet.common_error("ω₁", "the amplitude under a constant force, e/|1 − r²|, used", forced);
    let below = sheet.step(
        "ω₁",
        "rpm",
        below,
        (
            "Lower limit of the forbidden range: the whirl amplitude reaches the permitted value",
            RAO.at("§9.5"),
        ),
    );
    hold(below, lower);
    sheet.answer("band_begin", "Lower limit of the forbidden range", below);
    let mut limits = vec![Text::new("the limit is reached below the critical speed, {speed}").with_quantity(
        "speed",
        natural.value(),
        "rpm",
    )];
    if let Some(upper) = permitted.above {
        let above = match (damping_ratio, share) {
            (Some(zeta), Some(share)) => whirl::speed_above(natural, share, zeta),
            _ => whirl::speed_above_undamped(natural, eccentricity, amplitude),
        };
        let forced = || natural * (one + eccentricity / amplitude).sqrt();
        sheet.common_error("ω₂", "the amplitude under a constant force, e/|1 − r²|, used", forced);
        let above = sheet.step(
            "ω₂",
            "rpm",
            above,
            (
                "Upper limit of the forbidden range: the whirl amplitude returns to the permitted value",
                RAO.at("§9.5"),
            ),
        );
        hold(above, upper);
        sheet.answer("band_end", "Upper limit of the forbidden range", above);
        limits.push(
            Text::new("above the critical speed, {speed}, the whirl is within the limit again")
                .with_quantity("speed", natural.value(), "rpm"),
        );
    }
    limits
}
