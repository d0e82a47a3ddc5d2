//! A shaft that somebody has in mind: its largest amplitude in the range of speeds.

use dalembert_core::{Refusal, Text, Worksheet};
use dalembert_mechanics::{
    Real, sdof,
    whirl::{self, LimitedBy},
};

use super::{ClearanceDampingGiven, ShaftClearance, ShaftClearanceGiven};
use crate::sources::RAO;

impl ShaftClearance {
    /// Answers the critical speed and the largest amplitude of a shaft.
    pub(super) fn assess<W: Worksheet>(
        &self,
        given: &ShaftClearanceGiven<W>,
        unbalance: W::Num,
        k: W::Num,
        speeds: [W::Num; 2],
        sheet: W,
    ) -> Result<(), Refusal> {
        let natural = sheet.step(
            "ωₙ",
            "rpm",
            sdof::natural_frequency(k, given.mass),
            ("Its critical speed", RAO.at("§9.5")),
        );
        sheet.answer("critical_speed", "Critical speed of the shaft to be checked", natural);
        let damping = match &given.damping {
            ClearanceDampingGiven::Undamped {} => None,
            ClearanceDampingGiven::Ratio { ratio } if ratio.value() == 0.0 => None,
            ClearanceDampingGiven::Ratio { ratio } => Some(sheet.step(
                "c",
                "N*s/m",
                sdof::damping_from_ratio(*ratio, k, given.mass),
                ("Its damping coefficient", RAO.at("§2.6")),
            )),
            ClearanceDampingGiven::Coefficient { coefficient } => {
                Some(*coefficient).filter(|coefficient| coefficient.value() > 0.0)
            }
        };
        let range = [speeds[0].value(), speeds[1].value()];
        let c = damping.map_or(0.0, Real::value);
        let (worst, by) = whirl::worst_speed(k.value(), self.mass, c, range).map_err(|_| {
            Refusal::because("the shaft to be judged leads to values outside the representable range")
        })?;
        let meets_resonance = natural.value() >= range[0] && natural.value() <= range[1];
        if damping.is_none() && meets_resonance {
            sheet.warn(|| {
                Text::new(
                    "the shaft to be judged has its critical speed, {speed}, within the range: without damping \
                     the amplitude grows there without bound",
                )
                .with_quantity("speed", natural.value(), "rpm")
            });
            return Ok(());
        }
        let how = match by {
            LimitedBy::LowestSpeed => "Its worst-case speed: the lowest",
            LimitedBy::HighestSpeed => "Its worst-case speed: the highest",
            LimitedBy::Peak => "Its worst-case speed: the peak of the response, within the range",
        };
        let speed = sheet.numerical("ω_w", "rpm", worst, how);
        let amplitude = match damping {
            Some(c) => sdof::unbalance_amplitude(unbalance, k, given.mass, c, speed),
            None => unbalance * speed.powi(2) / (k - given.mass * speed.powi(2)).abs(),
        };
        let slow = || unbalance * speed.powi(2) / k;
        sheet.common_error("X_w", "the static deflection under the force m₀eω² taken", slow);
        let amplitude = sheet.step("X_w", "mm", amplitude, ("Its maximum amplitude", RAO.at("§3.7")));
        sheet.verify(|| {
            let ratio = speed / natural;
            let magnification = match damping {
                Some(c) => sdof::unbalance_magnification(ratio, c / (given.mass * natural * 2.0)),
                None => ratio.powi(2) / (W::Num::from(1.0) - ratio.powi(2)).abs(),
            };
            sheet.check(
                "maximum amplitude from the magnification against the frequency ratio",
                amplitude,
                unbalance / given.mass * magnification,
            );
        });
        sheet.answer("worst_speed", "Worst-case speed of the shaft to be checked", speed);
        sheet.answer("worst_amplitude", "Maximum amplitude of the shaft to be checked", amplitude);
        if amplitude.value() > self.clearance {
            sheet.warn(|| {
                Text::new("with the shaft to be judged the rotor touches the stator: {amplitude} at {speed}")
                    .with_quantity("amplitude", amplitude.value(), "mm")
                    .with_quantity("speed", worst, "rpm")
            });
        }
        Ok(())
    }
}
