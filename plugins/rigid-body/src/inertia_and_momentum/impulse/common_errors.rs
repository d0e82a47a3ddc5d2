//! Common errors in the steps of an impact.

use dalembert_core::Worksheet;
use dalembert_mechanics::{Real, Vector};

use super::{BodyConstraint, Impulse, free::After};
use crate::shared::body::{WorkedBody, transferred_sum};

/// Records the errors of an inertia with projectiles in the body: `arms` leads from the common centre of mass to the
/// body and to each projectile.
pub(super) fn joined<W: Worksheet>(
    symbol: &'static str,
    own: W::Num,
    arms: &[(W::Num, W::Vec)],
    gain: &dyn Fn(W::Num, W::Vec) -> Option<W::Num>,
    sheet: W,
) {
    let [(_, to_body), projectiles @ ..] = arms else { return };
    sheet.common_error(symbol, "the inertia of the projectiles neglected", || own);
    sheet.common_error(symbol, "the inertia taken about the centre of mass of the body alone", || {
        projectiles.iter().fold(own, |sum, (mass, arm)| transferred_sum(sum, gain(*mass, *arm - *to_body)))
    });
}

impl Impulse {
    /// Records the error of the angular speed of a body that is suddenly held and gets nothing else: by energy.
    pub(super) fn by_energy<W: Worksheet>(
        &self,
        body: &WorkedBody<W>,
        [omega, velocity]: [W::Vec; 2],
        after: &After<W>,
        sheet: W,
    ) {
        let is_held = matches!(self.hold, BodyConstraint::Point { .. } | BodyConstraint::Axis { .. });
        let is_undisturbed =
            self.blows.is_empty() && self.angular_impulses.is_empty() && self.projectiles.is_empty();
        if !(is_held && is_undisturbed) {
            return;
        }
        let doubled = |omega: W::Vec, velocity: W::Vec| {
            body.mass * velocity.dot(velocity) + omega.dot(body.momentum(omega))
        };
        sheet.common_error(
            "ω_1",
            "the kinetic energy taken as conserved as the constraint takes hold",
            || {
                let ratio = doubled(omega, velocity) / doubled(after.omega, after.velocity);
                after.omega.magnitude() * ratio.sqrt()
            },
        );
    }
}
