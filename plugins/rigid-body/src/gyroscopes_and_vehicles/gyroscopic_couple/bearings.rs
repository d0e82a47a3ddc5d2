//! Forces of the two bearings on a rotor.

use dalembert_core::{Refusal, Worksheet};
use dalembert_mechanics::{Real, Vector, rigid::gyroscope};

use super::{
    AxleBearings, AxleBearingsGiven, Bow, CarrierMotion, CarrierMotionGiven, GyroscopicCouple,
    GyroscopicCoupleGiven, LeftOrRight,
};
use crate::sources::MERIAM;

impl GyroscopicCouple {
    /// The forces of the two bearings on the rotor.
    #[expect(clippy::too_many_arguments, reason = "what acts on the rotor is known only here")]
    pub(super) fn bearing_reactions<W: Worksheet>(
        &self,
        bearings: &AxleBearings,
        given: &GyroscopicCoupleGiven<W>,
        given_bearings: &AxleBearingsGiven<W>,
        mass: W::Num,
        axle: W::Vec,
        couple: W::Vec,
        sheet: W,
    ) -> Result<(), Refusal> {
        if matches!(self.motion, CarrierMotion::HeldAtOneEnd { .. }) {
            return Err(Refusal::because(
                "an axle held at one end has no two bearings: leave the bearings out",
            ));
        }
        if matches!(self.motion, CarrierMotion::Gimbal { .. }) {
            return Err(Refusal::because(
                "the bearing forces are found for an axle that lies forward, across or upright, not for a gimbal: leave the bearings out, or give the motion as any angular velocity",
            ));
        }
        if bearings.behind + bearings.ahead <= 0.0 {
            return Err(Refusal::because(
                "bearing B does not lie ahead of bearing A: the sum of their distances from G must be above zero",
            ));
        }
        let spin = self.spin_direction();
        let ahead = spin.map(f64::abs);
        let along = if spin == ahead {
            axle
        } else {
            sheet.step_vector("e", "1", -axle, "Unit vector of the axle from bearing A to bearing B")
        };
        let zero = W::Num::from(0.0);
        let inwards = match (&self.motion, &given.motion) {
            (
                CarrierMotion::SteadyTurn { towards, .. },
                CarrierMotionGiven::SteadyTurn { speed, radius, .. },
            ) => {
                let inwards = mass * speed.powi(2) / *radius;
                if *towards == LeftOrRight::Left { inwards } else { -inwards }
            }
            _ => zero,
        };
        let upwards = match (&self.motion, &given.motion) {
            (
                CarrierMotion::VerticalCurve { bow, .. },
                CarrierMotionGiven::VerticalCurve { speed, radius, .. },
            ) => {
                let normal = speed.powi(2) / *radius;
                if *bow == Bow::Rising {
                    given_bearings.gravity + normal
                } else {
                    given_bearings.gravity - normal
                }
            }
            _ => given_bearings.gravity,
        };
        let upright = ahead.z != 0.0;
        let weight = if upright { zero } else { mass * upwards };
        let inwards = if ahead.y == 0.0 { inwards } else { zero };
        let force = sheet.step_vector(
            "P",
            "N",
            W::Vec::from_components(zero, inwards, weight),
            "Transverse force on the rotor: against the weight, and towards the centre of the curve",
        );
        let front = sheet.step_vector(
            "F_B",
            "N",
            gyroscope::bearing_ahead(force, couple, along, given_bearings.behind, given_bearings.ahead),
            ("Moments about bearing A: the bearing forces produce the couple M about G", MERIAM.at("§7/11")),
        );
        let rear = sheet.step_vector("F_A", "N", force - front, "The forces of both bearings add up to P");
        sheet.answer_vector("bearing_a", "Force of bearing A on the rotor (forward, left, up)", rear);
        sheet.answer_vector("bearing_b", "Force of bearing B on the rotor (forward, left, up)", front);
        if !upright {
            let (behind, ahead) = (given_bearings.behind, given_bearings.ahead);
            let half = || force / W::Num::from(2.0);
            let pair = || couple.cross(along) / (behind + ahead);
            let what = "transverse force divided equally between the bearings";
            sheet.common_error("R_A", what, || (half() - pair()).components()[2]);
            sheet.common_error("R_B", what, || (half() + pair()).components()[2]);
            let share = |of: W::Num| force * (of / (behind + ahead));
            let what = "gyroscopic couple divided by the distance of the bearing from G";
            let at_a = || share(ahead) - couple.cross(along) / behind;
            sheet.common_error("R_A", what, || at_a().components()[2]);
            let at_b = || share(behind) + couple.cross(along) / ahead;
            sheet.common_error("R_B", what, || at_b().components()[2]);
            let rear =
                sheet.step("R_A", "N", rear.components()[2], "Vertical reaction at A, positive upwards");
            let front =
                sheet.step("R_B", "N", front.components()[2], "Vertical reaction at B, positive upwards");
            sheet.answer("vertical_a", "Vertical reaction at A, upwards", rear);
            sheet.answer("vertical_b", "Vertical reaction at B, upwards", front);
        }
        sheet.verify(|| {
            let (rear, front) = (rear.value(), front.value());
            let moment =
                Vector::cross(ahead, front * bearings.ahead - rear * bearings.behind) - couple.value();
            let arm = bearings.ahead.abs() + bearings.behind.abs();
            sheet.check_zero(
                "the moments of the bearing forces about G make up the couple",
                W::Num::from(moment.norm()),
                arm * (rear.norm() + front.norm()) + couple.value().norm(),
            );
        });
        Ok(())
    }
}
