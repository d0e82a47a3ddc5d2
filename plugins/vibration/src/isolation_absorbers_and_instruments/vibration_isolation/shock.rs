//! Mounts that take up a shock: the velocity with which the machine arrives becomes travel.

use dalembert_core::{Axis, Exhibit, Inputs, Plot, Refusal, Series, Text, Worksheet};
use dalembert_mechanics::{Real, sdof};
use dalembert_numerics::intervals::IntervalSet;

use super::Mounts;
use crate::sources::RAO;

/// Velocity of arrival, or the drop height that gives it.
#[derive(Clone, Debug, Inputs)]
pub enum Arrival {
    /// With an initial velocity
    Velocity {
        /// Velocity.
        #[input("v₀", "m/s", positive)]
        velocity: f64,
    },
    /// From a height
    Drop {
        /// Height of the fall.
        #[input("h", "m", positive)]
        height: f64,
    },
}

/// Common error of the stiffnesses.
const BOTH_LIMITS: &str = "both limits, of acceleration and of travel, taken as reached";

/// Every stiffness with which acceleration and travel stay within their limits.
pub(super) fn solve<W: Worksheet>(
    mounts: &Mounts<W::Num>,
    arrival: &ArrivalGiven<W>,
    acceleration: W::Num,
    travel: Option<W::Num>,
    sheet: W,
) -> Result<(), Refusal> {
    use std::ops::Bound::{Included, Unbounded};
    let mass = mounts.mass;
    let velocity = match arrival {
        ArrivalGiven::Velocity { velocity } => *velocity,
        ArrivalGiven::Drop { height } => {
            sheet.step("v₀", "m/s", (mounts.gravity * *height * 2.0).sqrt(), "Final velocity of the fall")
        }
    };
    if let Some(travel) = travel {
        let by_travel = || (acceleration / travel).sqrt();
        sheet.common_error("ω_A", BOTH_LIMITS, by_travel);
    }
    let natural = sheet.step(
        "ω_A",
        "rad/s",
        acceleration / velocity,
        (
            "Highest natural frequency: a free vibration that begins with v₀ has the acceleration v₀ωₙ",
            RAO.at("§9.10"),
        ),
    );
    let stiffest =
        sheet.step("k_A", "N/m", mass * natural.powi(2), "Maximum stiffness, from the acceleration");
    let constant = || velocity.powi(2) / (acceleration * 2.0);
    sheet.common_error("x_A", "the deceleration assumed to be constant", constant);
    let least = sheet.step(
        "x_A",
        "mm",
        velocity / natural,
        "Deflection of these mounts, v₀/ωₙ: the minimum possible",
    );
    sheet.check(
        "the kinetic energy on arrival is stored in the springs at the end of the travel",
        stiffest * least.powi(2),
        mass * velocity.powi(2),
    );
    sheet.answer("velocity", "Arrival velocity", velocity);
    sheet.answer("natural_frequency", "Highest natural frequency", natural);
    sheet.answer("stiffness", "Maximum total stiffness of the mounts", stiffest);
    mounts.answer_each(stiffest, sheet);
    sheet.answer("travel", "Deflection of the stiffest mounts", least);
    let softest = travel.map(|travel| {
        let why = "Minimum stiffness, from the travel: ½ k d² = ½ m v₀²";
        let as_force = || mass * acceleration / travel;
        sheet.common_error("k_d", BOTH_LIMITS, as_force);
        let softest = sheet.step("k_d", "N/m", mass * (velocity / travel).powi(2), why);
        sheet.answer("least_stiffness", "Minimum total stiffness of the mounts", softest);
        sheet.check(
            "travel of the softest mounts: the amplitude v₀/ωₙ of the free vibration",
            velocity / sdof::natural_frequency(softest, mass),
            travel,
        );
        softest
    });
    let lower = softest.map_or(0.0, Real::value);
    if !(lower.is_finite() && stiffest.value().is_finite()) {
        return Err(Refusal::because("these numbers lead to values outside the representable range"));
    }
    let from = if softest.is_some() { Included(lower) } else { Unbounded };
    let set = IntervalSet::interval(from, Included(stiffest.value()));
    let mut limits = Vec::new();
    if !set.is_none() {
        if softest.is_some() {
            limits.push(Text::new("travel limit"));
        }
        limits.push(Text::new("acceleration limit"));
    }
    sheet.answer_set("permitted_stiffness", "Permitted total stiffness of the mounts", "N/m", &set, limits);
    if set.is_none() {
        sheet.warn(|| {
            Text::new(
                "no stiffness satisfies both limits: the travel must be at least {travel} with this acceleration",
            )
            .with_quantity("travel", least.value(), "mm")
        });
    }
    let (m, v) = (mass.value(), velocity.value());
    let (top, limit) = (stiffest.value(), acceleration.value());
    sheet.show(|| {
        let at = |n: u16| 2.0 * top * f64::from(n) / 200.0;
        let curve = (0..=200).map(at).map(|k| (k, v * (k / m).sqrt())).collect();
        let plot = Plot::new(
            "Acceleration against stiffness",
            Axis::linear("stiffness", "N/m"),
            Axis::linear("acceleration", "m/s^2"),
            vec![Series::line("A", curve)],
        )
        .level("maximum acceleration", limit);
        Exhibit::Plot(if lower < top { plot.band("permitted", lower, top, true) } else { plot })
    });
    Ok(())
}
