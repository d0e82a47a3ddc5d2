//! Velocities and accelerations of the crank pin and the lever of a quick-return mechanism, and of the slip between them.

use dalembert_core::Worksheet;
use dalembert_mechanics::Real;

use super::{QuickReturn, QuickReturnGiven, QuickReturnPosition};
use crate::shared::{
    kinematics::{self, Kinematics, Motion},
    works::{self, RotatingLinkWork},
};

impl QuickReturn {
    /// Velocities and accelerations of the crank pin A and of the end B of the lever, and of the point of the lever under
    /// A.
    pub(super) fn kinematics<W: Worksheet>(
        &self,
        given: &QuickReturnGiven<W>,
        found: &QuickReturnPosition<W::Num>,
        sheet: W,
    ) -> (Kinematics<W>, [Motion<W>; 2]) {
        let crank = RotatingLinkWork::crank(given.angle, given.speed, given.acceleration);
        let of = Kinematics::new(given.speed, given.acceleration, given.crank, sheet);
        let a = of.about(&kinematics::A, crank.reach::<W>(given.crank), crank);
        let under = of.about(&kinematics::A4, found.lever.reach::<W>(found.reach), found.lever);
        let b = of.about(&kinematics::B, found.lever.reach::<W>(given.lever), found.lever);
        sheet.verify(|| {
            let along = works::direction::<W>(found.lever.angle);
            let sliding =
                Kinematics::<W>::sliding(along, found.slip, found.slip_acceleration, found.coriolis);
            of.check_relative(["A", "A4", "s"], [a, under, sliding]);
        });
        (of, [a, b])
    }

    /// The slip from the triangle of the pivots and the crank pin, `ρ² = d² + r² + 2 d r sin θ`, and its derivatives.
    pub(super) fn check_slip<W: Worksheet>(
        &self,
        given: &QuickReturnGiven<W>,
        found: &QuickReturnPosition<W::Num>,
        sheet: W,
    ) {
        let (area, angle) = (given.frame * given.crank, given.angle);
        let first = area * angle.cos() * given.speed;
        let second = area * (angle.cos() * given.acceleration - angle.sin() * given.speed.powi(2));
        let size = self.frame * self.crank * self.speed.abs();
        let what = "slip from the derivative of the triangle of the pivots";
        sheet.check_sum(what, found.reach * found.slip, first, size);
        let what = "Coriolis acceleration from the derivative of the triangle of the pivots";
        let turned = found.lever.speed * 2.0;
        sheet.check_sum(what, found.reach * found.coriolis, turned * first, size * turned.value().abs());
        let what = "acceleration of slip from the second derivative of the triangle of the pivots";
        let scale = self.frame * self.crank * (self.speed.powi(2) + self.acceleration.abs());
        let bent = found.reach * found.slip_acceleration + found.slip.powi(2);
        sheet.check_sum(what, bent, second, scale.max(found.slip.value().powi(2)));
    }
}
