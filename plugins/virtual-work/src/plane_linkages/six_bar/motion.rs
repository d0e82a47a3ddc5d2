//! Velocities and accelerations of the pins of a six-bar linkage.

use dalembert_core::Worksheet;
use dalembert_mechanics::Real;

use super::{Attached, AttachedGiven, SixBar, SixBarGiven, SixBarPosition};
use crate::shared::{
    built::Solved,
    kinematics::{self, Kinematics, Motion},
    works::{self, FIVE, FOUR, RotatingLinkWork, THREE},
};

impl SixBar {
    /// Velocities and accelerations of B, of A and of B relative to A, and of the point D.
    pub(super) fn kinematics<W: Worksheet>(
        &self,
        given: &SixBarGiven<W>,
        found: &SixBarPosition<W::Num>,
        sheet: W,
    ) -> (Kinematics<W>, [Motion<W>; 4]) {
        let link = |n: usize| RotatingLinkWork {
            angle: found.angles[n],
            ratio: found.ratios[n],
            speed: found.speeds[n],
            acceleration: found.accelerations[n],
        };
        let (coupler, rocker) = (link(0), link(1));
        let crank = RotatingLinkWork::crank(given.angle, given.speed, given.acceleration);
        let of = Kinematics::new(given.speed, given.acceleration, given.crank, sheet);
        let a = of.about(&kinematics::A, crank.reach::<W>(given.crank), crank);
        let b = of.about(&kinematics::B, rocker.reach::<W>(given.rocker), rocker);
        let ba = of.about(&kinematics::B_RELATIVE_TO_A, coupler.reach::<W>(given.coupler), coupler);
        let (along, across, link, from) = match given.attached {
            AttachedGiven::Rocker { along, across } => (along, across, rocker, None),
            AttachedGiven::Coupler { along, across } => (along, across, coupler, Some(a)),
        };
        let unit = works::direction::<W>(link.angle);
        let mut arm = unit * along;
        if across.value() != 0.0 {
            arm = arm + works::across::<W>(unit) * across;
        }
        let d = of.beyond(&kinematics::D, from, arm, link);
        (of, [b, a, ba, d])
    }

    /// Holds the motions of links and points to those of the mechanism put together.
    pub(super) fn check_motions<W: Worksheet>(
        &self,
        of: &Kinematics<W>,
        &[b, a, ba, d]: &[Motion<W>; 4],
        (solved, found): (&Solved, &SixBarPosition<W::Num>),
    ) {
        of.check_relative(["B", "A", "BA"], [b, a, ba]);
        of.check(&kinematics::A, a, solved, 0, [self.crank, 0.0]);
        of.check(&kinematics::B, b, solved, 2, [self.rocker, 0.0]);
        let (link, at) = match self.attached {
            Attached::Rocker { along, across } => (2, [along, across]),
            Attached::Coupler { along, across } => (1, [along, across]),
        };
        of.check(&kinematics::D, d, solved, link, at);
        of.check_rotation(THREE, (found.speeds[0], found.accelerations[0]), solved, 1);
        of.check_rotation(FOUR, (found.speeds[1], found.accelerations[1]), solved, 2);
        of.check_rotation(FIVE, (found.speeds[2], found.accelerations[2]), solved, 3);
    }
}
