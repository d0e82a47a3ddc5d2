//! The permitted eccentricities of a rotor on a known shaft.

use std::ops::Bound::Included;

use dalembert_core::{Axis, Exhibit, Plot, Refusal, Series, Text, Worksheet};
use dalembert_mechanics::{
    Real, sdof,
    whirl::{self, LimitedBy},
};
use dalembert_numerics::intervals::IntervalSet;

use super::{
    PermittedQuantity, PermittedQuantityGiven, ShaftClearance, ShaftClearanceGiven, damping_ratio, reached,
};
use crate::{shared::jeffcott, sources::RAO};

impl ShaftClearance {
    pub(super) fn eccentricities<W: Worksheet>(
        &self,
        given: &ShaftClearanceGiven<W>,
        sheet: W,
    ) -> Result<(), Refusal> {
        let (
            PermittedQuantity::Eccentricity { speeds: range, shaft },
            PermittedQuantityGiven::Eccentricity { speeds, shaft: shaft_given },
        ) = (&self.sought, &given.sought)
        else {
            return Ok(());
        };
        let speeds = range.widened(speeds, sheet)?;
        let k = jeffcott::stiffness(shaft, shaft_given, sheet);
        let natural = sheet.step(
            "ωₙ",
            "rpm",
            sdof::natural_frequency(k, given.mass),
            ("Critical speed", RAO.at("§9.5")),
        );
        let zeta = damping_ratio(&given.damping, k, given.mass, sheet);
        sheet.answer("critical_speed", "Critical speed", natural);
        let range = speeds.map(Real::value);
        if zeta.is_none() && (range[0]..=range[1]).contains(&natural.value()) {
            sheet.check("critical speed and mass reproduce the stiffness", given.mass * natural.powi(2), k);
            sheet.answer_set(
                "eccentricities",
                "Permitted eccentricities",
                "mm",
                &IntervalSet::none(),
                Vec::new(),
            );
            sheet.warn(|| {
                Text::new(
                    "the critical speed, {speed}, lies within the range and there is no damping: the amplitude grows there without bound for any non-zero eccentricity",
                )
                .with_quantity("speed", natural.value(), "rpm")
            });
            return Ok(());
        }
        let damping = zeta.map_or(0.0, |zeta| sdof::damping_from_ratio(zeta.value(), k.value(), self.mass));
        let (worst, by) = whirl::worst_speed(k.value(), self.mass, damping, range)
            .map_err(|_| Refusal::because("these numbers lead to values outside the representable range"))?;
        let (speed, how) = match (by, zeta) {
            (LimitedBy::LowestSpeed, _) => (speeds[0], "Worst-case speed: the lowest, above the resonance"),
            (LimitedBy::HighestSpeed, _) => (speeds[1], "Worst-case speed: the highest, below the resonance"),
            (LimitedBy::Peak, Some(zeta)) => (
                natural * sdof::unbalance_peak_ratio(zeta),
                "Worst-case speed: the peak of the response, within the range",
            ),
            (LimitedBy::Peak, None) => unreachable!("an undamped peak within the range was answered above"),
        };
        match (by, zeta) {
            (LimitedBy::LowestSpeed, _) => {
                let other = || speeds[1];
                sheet.common_error("ω_w", "the highest speed of the range taken as the worst", other);
            }
            (LimitedBy::HighestSpeed, _) => {
                let other = || speeds[0];
                sheet.common_error("ω_w", "the lowest speed of the range taken as the worst", other);
            }
            (LimitedBy::Peak, Some(zeta)) => {
                let forced = || natural * sdof::magnification_peak_ratio(zeta);
                sheet.common_error("ω_w", "the peak of the response to a constant force used", forced);
            }
            (LimitedBy::Peak, None) => {}
        }
        let speed = sheet.step("ω_w", "rpm", speed, (how, RAO.at("§3.7")));
        let ratio =
            sheet.step("r", "1", sdof::frequency_ratio(speed, natural), "Frequency ratio at this speed");
        let one = W::Num::from(1.0);
        let largest = match zeta {
            Some(zeta) => whirl::eccentricity_from_amplitude(given.clearance, ratio, zeta),
            None => given.clearance * (one - ratio.powi(2)).abs() / ratio.powi(2),
        };
        if let Some(zeta) = zeta {
            let resonance = || given.clearance * zeta * 2.0;
            sheet.common_error("e_R", "the amplitude at r = 1, e/(2ζ), used", resonance);
        }
        let largest = sheet.step(
            "e_R",
            "mm",
            largest,
            ("Eccentricity for which the whirl amplitude at that speed equals the clearance", RAO.at("§9.5")),
        );
        if !largest.value().is_finite() {
            return Err(Refusal::because("these numbers lead to values outside the representable range"));
        }
        sheet.check("the worst-case speed from a comparison of range ends and peak", speed, worst.into());
        let unbalance = sheet.step("U_R", "kg*mm", given.mass * largest, "The corresponding unbalance");
        sheet.verify(|| {
            let amplitude = match zeta {
                Some(zeta) => {
                    let damping = sdof::damping_from_ratio(zeta, k, given.mass);
                    sdof::unbalance_amplitude(unbalance, k, given.mass, damping, speed)
                }
                None => unbalance * speed.powi(2) / (k - given.mass * speed.powi(2)).abs(),
            };
            sheet.check(
                "with that eccentricity the dynamic stiffness gives the clearance",
                amplitude,
                given.clearance,
            );
        });
        let set = IntervalSet::interval(Included(0.0), Included(largest.value()));
        sheet.answer_set(
            "eccentricities",
            "Permitted eccentricities",
            "mm",
            &set,
            vec![reached(by, speed.value())],
        );
        sheet.answer("largest_eccentricity", "Maximum permitted eccentricity", largest);
        sheet.answer("largest_unbalance", "Maximum permitted unbalance", unbalance);
        sheet.answer("worst_speed", "Worst-case speed", speed);
        let (limit, ratio) = (largest.value(), zeta.map_or(0.0, Real::value));
        let natural = natural.value();
        sheet.show(|| {
            let at = |n: u16| {
                let e = 2.0 * limit * f64::from(n) / 100.0;
                (e, whirl::whirl_amplitude(e, worst / natural, ratio))
            };
            let plot = Plot::new(
                "Maximum amplitude in the range of speeds against eccentricity",
                Axis::linear("eccentricity", "mm"),
                Axis::linear("amplitude", "mm"),
                vec![Series::line("X", (0..=100).map(at).collect())],
            );
            let plot = plot.level("clearance", self.clearance).mark("largest", (limit, self.clearance));
            Exhibit::Plot(plot.band("permitted", 0.0, limit, true))
        });
        Ok(())
    }
}
