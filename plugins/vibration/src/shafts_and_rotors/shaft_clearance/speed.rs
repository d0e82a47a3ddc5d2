//! The permitted speeds of a rotor on a known shaft.

use dalembert_core::{Axis, Exhibit, Plot, Refusal, Series, Worksheet};
use dalembert_mechanics::{Real, sdof, whirl};

use super::{PermittedQuantity, PermittedQuantityGiven, ShaftClearance, ShaftClearanceGiven, damping_ratio};
use crate::{shared::jeffcott, sources::RAO};

impl ShaftClearance {
    pub(super) fn speeds<W: Worksheet>(
        &self,
        given: &ShaftClearanceGiven<W>,
        sheet: W,
    ) -> Result<(), Refusal> {
        let (
            PermittedQuantity::Speed { shaft, .. },
            PermittedQuantityGiven::Speed { unbalance, shaft: shaft_given },
        ) = (&self.sought, &given.sought)
        else {
            return Ok(());
        };
        let eccentricity = sheet.step(
            "e",
            "µm",
            *unbalance / given.mass,
            ("Distance of the centre of mass from the axis", RAO.at("§9.5")),
        );
        let k = jeffcott::stiffness(shaft, shaft_given, sheet);
        let natural = sheet.step(
            "ωₙ",
            "rpm",
            sdof::natural_frequency(k, given.mass),
            ("Critical speed", RAO.at("§9.5")),
        );
        let zeta = damping_ratio(&given.damping, k, given.mass, sheet);
        sheet.answer("critical_speed", "Critical speed", natural);
        sheet.check("critical speed and mass reproduce the stiffness", given.mass * natural.powi(2), k);
        let rotor = jeffcott::Whirl { natural, eccentricity, damping_ratio: zeta };
        let permitted = jeffcott::permitted_speeds(&rotor, given.clearance, sheet)?;
        let (natural, eccentricity, ratio) =
            (natural.value(), eccentricity.value(), zeta.map_or(0.0, Real::value));
        sheet.show(|| {
            let at = |n: u16| {
                let speed = 2.5 * natural * f64::from(n) / 400.0;
                (speed, whirl::whirl_amplitude(eccentricity, speed / natural, ratio))
            };
            let mut plot = Plot::new(
                "Whirl amplitude against speed",
                Axis::linear("speed of the shaft", "rpm"),
                Axis::log("whirl amplitude", "mm"),
                vec![Series::line("X", (1..=400).map(at).collect())],
            )
            .level("clearance", self.clearance);
            for (from, to) in &permitted {
                plot = plot.band("permitted", *from, *to, true);
            }
            Exhibit::Plot(plot)
        });
        Ok(())
    }
}
