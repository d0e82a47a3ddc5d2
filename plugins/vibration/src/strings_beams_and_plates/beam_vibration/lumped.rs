//! Common errors of the lowest frequency: the beam taken as a spring.

use dalembert_core::Worksheet;
use dalembert_mechanics::Real;

use super::{AttachedPart, AttachedPartGiven, BeamVibration, BeamVibrationGiven};
use crate::shared::support::Support;

impl BeamVibration {
    /// The common errors of the lowest frequency of a plain beam, perhaps with a mass where it deflects most; `unit` is
    /// `√(EI/(m̄L⁴))` and `own` the mass of the beam.
    pub(super) fn lumped_errors<W: Worksheet>(
        &self,
        given: &BeamVibrationGiven<W>,
        unit: W::Num,
        own: W::Num,
        sheet: W,
    ) {
        // The stiffness at the place that deflects most, over EI/L³.
        let (at, stiffness) = match (&self.left, &self.right) {
            (Support::Clamped, Support::Free) => (1.0, 3.0),
            (Support::Free, Support::Clamped) => (0.0, 3.0),
            (Support::Pinned, Support::Pinned) => (0.5, 48.0),
            (Support::Clamped, Support::Clamped) => (0.5, 192.0),
            (Support::Clamped, Support::Pinned) | (Support::Pinned, Support::Clamped) => (0.5, 768.0 / 7.0),
            _ => return,
        };
        if self.axial.is_some() || self.foundation.is_some() {
            return;
        }
        let lumped = |mass: W::Num| unit * (W::Num::from(stiffness) / mass).sqrt();
        match (&self.attachments[..], &given.attachments[..]) {
            ([], _) => {
                let whole = || lumped(W::Num::from(1.0));
                let words = "the whole mass of the beam lumped where it deflects most";
                sheet.common_error(("ω", 1), words, whole);
            }
            ([attachment], [attached]) => {
                let (AttachedPart::Mass { .. }, AttachedPartGiven::Mass { mass, .. }) =
                    (&attachment.part, &attached.part)
                else {
                    return;
                };
                if (attachment.distance / self.length - at).abs() > 1e-9 {
                    return;
                }
                let whole = || lumped(*mass / own + 1.0);
                sheet.common_error(("ω", 1), "the whole mass of the beam added to that on it", whole);
            }
            _ => {}
        }
    }
}
