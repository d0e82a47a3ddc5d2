//! Direction of the axle, and angular velocity of the carrier.

use std::f64::consts::TAU;

use dalembert_core::{Refusal, Worksheet};
use dalembert_mechanics::{Real, Vector};
use nalgebra::Vector3;

use super::{Bow, CarrierMotion, CarrierMotionGiven, GyroscopicCouple, GyroscopicCoupleGiven, LeftOrRight};
use crate::{shared::gyro_rotor::SpinningRotor, sources::KHURMI};

/// A fixed direction as a vector of the worksheet.
fn direction<W: Worksheet>(along: Vector3<f64>) -> W::Vec {
    W::Vec::from_components(along.x.into(), along.y.into(), along.z.into())
}

impl GyroscopicCouple {
    /// The unit vector of the spin: turned with the gimbal where there is one.
    pub(super) fn axle<W: Worksheet>(
        &self,
        given: &GyroscopicCoupleGiven<W>,
        sheet: W,
    ) -> Result<W::Vec, Refusal> {
        const WHY: &str = "Unit vector of the spin: away from the viewer if clockwise, towards the viewer if counter-clockwise";
        let start = direction::<W>(self.spin_direction());
        let CarrierMotionGiven::Gimbal { axis, angle, .. } = &given.motion else {
            return Ok(sheet.step_vector("u", "1", start, WHY));
        };
        if axis.value().norm() == 0.0 {
            return Err(Refusal::because(
                "the axis of the gimbal has no direction: write a vector other than zero",
            ));
        }
        let start = sheet.step_vector("u₀", "1", start, WHY);
        let axis =
            sheet.step_vector("e", "1", *axis / axis.magnitude(), "Unit vector of the axis of the gimbal");
        let (sin, cos) = (angle.sin(), angle.cos());
        let turned =
            start * cos + axis.cross(start) * sin + axis * (axis.dot(start) * (W::Num::from(1.0) - cos));
        let axle = sheet.step_vector(
            "u",
            "1",
            turned,
            "Unit vector of the spin, turned by the gimbal angle about its axis",
        );
        sheet.verify(|| {
            let unit = nalgebra::Unit::new_normalize(axis.value());
            let found = nalgebra::Rotation3::from_axis_angle(&unit, angle.value()) * self.spin_direction();
            let what = "the axle turned by a rotation matrix";
            sheet.check_zero(what, W::Num::from((found - axle.value()).norm()), 1.0);
        });
        Ok(axle)
    }

    /// The angular velocity of the carrier, and its size.
    pub(super) fn precession<W: Worksheet>(
        &self,
        given: &GyroscopicCoupleGiven<W>,
        axle: W::Vec,
        rotor: &SpinningRotor<W::Num>,
        sheet: W,
    ) -> Result<(W::Vec, W::Num), Refusal> {
        let largest = |amplitude: W::Num, period: W::Num| {
            let frequency = sheet.step(
                "p",
                "rad/s",
                W::Num::from(TAU) / period,
                "Angular frequency of the harmonic motion",
            );
            let average = || amplitude * 4.0 / period;
            let what = "average angular velocity over a quarter of a period used in place of the maximum";
            sheet.common_error("ω_p", what, average);
            sheet.step(
                "ω_p",
                "rad/s",
                amplitude * frequency,
                ("Maximum angular velocity, in the middle of the oscillation", KHURMI.at("§14.7")),
            )
        };
        let (rate, along, why) = match (&self.motion, &given.motion) {
            (CarrierMotion::AnyPrecession { .. }, CarrierMotionGiven::AnyPrecession { precession }) => {
                let rate = sheet.step(
                    "ω_p",
                    "rad/s",
                    precession.magnitude(),
                    "Magnitude of the angular velocity of the carrier",
                );
                return Ok((*precession, rate));
            }
            (
                CarrierMotion::SteadyTurn { towards, .. },
                CarrierMotionGiven::SteadyTurn { speed, radius, .. },
            ) => {
                let rate = sheet.step(
                    "ω_p",
                    "rad/s",
                    *speed / *radius,
                    ("Angular velocity of the carrier on its curve", KHURMI.at("§14.6")),
                );
                let up = if *towards == LeftOrRight::Left { Vector3::z() } else { -Vector3::z() };
                (
                    rate,
                    up,
                    "Seen from above, a turn to the left is counter-clockwise: Ω points up; to the right, down",
                )
            }
            (
                CarrierMotion::VerticalCurve { bow, .. },
                CarrierMotionGiven::VerticalCurve { speed, radius, .. },
            ) => {
                let rate = sheet.step(
                    "ω_p",
                    "rad/s",
                    *speed / *radius,
                    ("Angular velocity of the carrier on its curve", KHURMI.at("§14.6")),
                );
                (rate, pitch(*bow), PITCH)
            }
            (_, CarrierMotionGiven::Gimbal { rate, axis, .. }) => {
                let vector = sheet.step_vector(
                    "Ω",
                    "rad/s",
                    *axis / axis.magnitude() * *rate,
                    "The axle turns with the gimbal about its axis",
                );
                let obliquity = sheet.step(
                    "θ",
                    "deg",
                    axis.cross(axle).magnitude().atan2(axis.dot(axle)),
                    "Angle between the axis of the gimbal and the axle",
                );
                sheet.answer("obliquity", "Angle of the gimbal axis to the axle", obliquity);
                if self.transverse_inertia.is_none() {
                    let couple = rotor.momentum * *rate * obliquity.sin();
                    sheet.verify(|| {
                        let size = (rotor.momentum * *rate).value();
                        let product = (vector.cross(axle) * rotor.momentum).magnitude();
                        sheet.check_sum("couple of the spin: h_s ω_g sin θ", product, couple, size);
                    });
                }
                return Ok((vector, *rate));
            }
            (CarrierMotion::Pitching { bow, .. }, CarrierMotionGiven::Pitching { rate, .. }) => {
                (*rate, pitch(*bow), PITCH)
            }
            (
                CarrierMotion::HarmonicPitching { bow, .. },
                CarrierMotionGiven::HarmonicPitching { amplitude, period, .. },
            ) => (largest(*amplitude, *period), pitch(*bow), PITCH),
            (CarrierMotion::Rolling { falling, .. }, CarrierMotionGiven::Rolling { rate, .. }) => {
                (*rate, roll(*falling), ROLL)
            }
            (
                CarrierMotion::HarmonicRolling { falling, .. },
                CarrierMotionGiven::HarmonicRolling { amplitude, period, .. },
            ) => (largest(*amplitude, *period), roll(*falling), ROLL),
            (_, CarrierMotionGiven::HeldAtOneEnd { arm, gravity }) => {
                let mass = rotor.mass.ok_or_else(|| {
                    Refusal::because("the weight makes the axle precess: write the mass of the rotor")
                })?;
                if rotor.momentum.value() == 0.0 {
                    return Err(Refusal::because(
                        "a rotor without spin falls and does not precess: write a speed above zero",
                    ));
                }
                if self.spin_direction().z != 0.0 {
                    return Err(Refusal::because(
                        "a vertical axle needs no couple to remain vertical: choose a viewpoint from which the axle is horizontal",
                    ));
                }
                let moment = sheet.step(
                    "M_W",
                    "N*m",
                    mass * *gravity * *arm,
                    "Moment of the weight about the support",
                );
                if let Some(axial) = rotor.axial {
                    let about_support = || moment * axial / (rotor.momentum * (axial + mass * arm.powi(2)));
                    let what = "moment of inertia of the spin transferred to the support by the parallel-axis theorem";
                    sheet.common_error("ω_p", what, about_support);
                }
                let rate = sheet.step(
                    "ω_p",
                    "rad/s",
                    moment / rotor.momentum,
                    ("The couple rotates H at the precession rate: M = I_a ω ω_p", KHURMI.at("§14.3")),
                );
                (rate, Vector3::z(), "The axle precesses about the vertical through its support")
            }
            _ => unreachable!("the given motion is the motion"),
        };
        let vector = sheet.step_vector("Ω", "rad/s", direction::<W>(along) * rate, why);
        Ok((vector, rate))
    }
}

const PITCH: &str = "When the bow rises, Ω points to the right; when it falls, to the left";
const ROLL: &str =
    "When the right-hand side descends, Ω points forward; when the left-hand side descends, backward";

/// Direction of the angular velocity of a pitching carrier.
fn pitch(bow: Bow) -> Vector3<f64> {
    if bow == Bow::Rising { -Vector3::y() } else { Vector3::y() }
}

/// Direction of the angular velocity of a rolling carrier.
fn roll(falling: LeftOrRight) -> Vector3<f64> {
    if falling == LeftOrRight::Right { Vector3::x() } else { -Vector3::x() }
}
