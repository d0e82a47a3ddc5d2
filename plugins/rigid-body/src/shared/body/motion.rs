//! The motion of a body at one moment, as a user gives it.

use dalembert_core::{Ink, Inputs, Refusal, Worksheet};
use dalembert_mechanics::{Real, Vector, rigid};
use nalgebra::Vector3;

use super::{WorkedBody, refused};
use crate::{
    shared::scene::Scene,
    sources::{BEER, MERIAM},
};

/// Angular velocity of a body.
#[derive(Clone, Debug, Inputs)]
pub enum BodyRotation {
    /// Angular velocity
    Vector {
        /// Angular velocity.
        #[input("ω_0", "rad/s", default = "(0; 0; 0) rad/s")]
        omega: Vector3<f64>,
    },
    /// About an axis
    Axis {
        /// Any vector along the axis.
        #[input("e_ω", "1")]
        axis: Vector3<f64>,
        /// Angular speed, positive by the right-hand rule.
        #[input("ω_0", "rad/s")]
        speed: f64,
    },
    /// Two of its points are at rest
    /// It rotates about the line through them: a disc rolling on the floor about a fixed point of its axle.
    RestingPoints {
        /// Position of the first point.
        #[input("r_U", "m", default = "(0; 0; 0) m")]
        first: Vector3<f64>,
        /// Position of the second point.
        #[input("r_V", "m")]
        second: Vector3<f64>,
        /// Any vector along an axis of the body.
        #[input("e_ω", "1")]
        axis: Vector3<f64>,
        /// Component of the angular velocity along it.
        #[input("ω_0", "rad/s")]
        speed: f64,
    },
    /// Angular momentum about the centre of mass
    Momentum {
        /// Angular momentum.
        #[input("H_0", "kg*m^2/s")]
        momentum: Vector3<f64>,
    },
}

/// Given velocity of a body: of its centre of mass or of another point.
#[derive(Clone, Debug, Inputs)]
pub enum BodyVelocity {
    /// Velocity of the centre of mass
    MassCentre {
        /// Velocity of the centre of mass.
        #[input("v_0", "m/s", default = "(0; 0; 0) m/s")]
        velocity: Vector3<f64>,
    },
    /// A point is fixed
    Fixed {
        /// Position of the point.
        #[input("r_F", "m", default = "(0; 0; 0) m")]
        point: Vector3<f64>,
    },
    /// Velocity of a point
    Point {
        /// Position of the point.
        #[input("r_P", "m")]
        point: Vector3<f64>,
        /// Its velocity.
        #[input("v_P", "m/s")]
        velocity: Vector3<f64>,
    },
    /// Carried by an arm rotating about a point
    /// The body rotates freely relative to the arm: only the arm moves its centre of mass.
    Carried {
        /// Position of the point.
        #[input("r_F", "m", default = "(0; 0; 0) m")]
        point: Vector3<f64>,
        /// Angular velocity of the arm.
        #[input("Ω", "rad/s")]
        omega: Vector3<f64>,
    },
    /// Dropped from rest
    Fallen {
        /// Height of the fall.
        #[input("h", "m", nonnegative)]
        height: f64,
        /// Acceleration of gravity.
        #[input("g", "m/s^2", default = "(0; 0; -9.81) m/s^2")]
        gravity: Vector3<f64>,
    },
}

impl BodyRotation {
    /// The angular velocity, written down.
    ///
    /// # Errors
    /// A refusal in words.
    pub(crate) fn work<W: Worksheet>(
        &self,
        given: &BodyRotationGiven<W>,
        body: &WorkedBody<W>,
        sheet: W,
    ) -> Result<W::Vec, Refusal> {
        match (self, given) {
            (BodyRotation::Vector { .. }, BodyRotationGiven::Vector { omega }) => {
                Ok(sheet.step_vector("ω", "rad/s", *omega, "Angular velocity"))
            }
            (BodyRotation::Axis { axis: along, .. }, BodyRotationGiven::Axis { axis, speed }) => {
                directed(*along)?;
                Ok(sheet.step_vector(
                    "ω",
                    "rad/s",
                    *axis * *speed / axis.magnitude(),
                    "Angular velocity, along its axis",
                ))
            }
            (
                BodyRotation::RestingPoints { first: a, second: b, axis: along, .. },
                BodyRotationGiven::RestingPoints { first, second, axis, speed },
            ) => {
                directed(*along)?;
                let (line, along) = (b - a, *along / along.amax());
                if line.dot(along).abs() <= 1e-12 * line.norm() * along.norm() {
                    return Err(Refusal::because(
                        "the line through the two points at rest is at right angles to the axis of the body: an angular velocity along it has no component there; check the points or give the angular velocity itself",
                    ));
                }
                let line = sheet.step_vector(
                    "e_r",
                    "m",
                    *second - *first,
                    "The instantaneous axis: the line through the two points at rest",
                );
                Ok(sheet.step_vector(
                    "ω",
                    "rad/s",
                    line * (*speed * axis.magnitude() / line.dot(*axis)),
                    ("Angular velocity: along the instantaneous axis, with the given component along the axis of the body", BEER.at("§15.6A")),
                ))
            }
            (BodyRotation::Momentum { momentum }, BodyRotationGiven::Momentum { .. }) => {
                let principal =
                    body.properties.check_turnable().map_err(|error| refused(&error, "this body"))?;
                let omega =
                    principal.angular_velocity(*momentum).map_err(|error| refused(&error, "this body"))?;
                Ok(sheet.numerical_vector(
                    "ω",
                    "rad/s",
                    omega,
                    ("Angular velocity from H_G = I ω", MERIAM.at("§7/7")),
                ))
            }
            _ => Err(Refusal::because("the rotation is not defined")),
        }
    }
}

impl BodyVelocity {
    /// The velocity of the centre of mass, written down.
    ///
    /// # Errors
    /// A refusal in words.
    pub(crate) fn work<W: Worksheet>(
        &self,
        given: &BodyVelocityGiven<W>,
        body: &WorkedBody<W>,
        omega: W::Vec,
        sheet: W,
    ) -> Result<W::Vec, Refusal> {
        Ok(match (self, given) {
            (BodyVelocity::MassCentre { .. }, BodyVelocityGiven::MassCentre { velocity }) => {
                sheet.step_vector("v_G", "m/s", *velocity, "Velocity of the centre of mass")
            }
            (BodyVelocity::Fixed { .. }, BodyVelocityGiven::Fixed { point }) => {
                let arm = sheet.step_vector("ρ", "m", body.centre - *point, "From the fixed point to G");
                sheet.step_vector(
                    "v_G",
                    "m/s",
                    omega.cross(arm),
                    ("Velocity of the centre of mass: G rotates about the fixed point", BEER.at("§15.6B")),
                )
            }
            (BodyVelocity::Point { .. }, BodyVelocityGiven::Point { point, velocity }) => {
                let arm = sheet.step_vector("ρ", "m", body.centre - *point, "From the point to G");
                sheet.step_vector(
                    "v_G",
                    "m/s",
                    rigid::velocity_of_point(*velocity, omega, arm),
                    ("Velocity of the centre of mass, from that of the point", BEER.at("§15.6B")),
                )
            }
            (BodyVelocity::Carried { .. }, BodyVelocityGiven::Carried { point, omega: arm_omega }) => {
                let arm = sheet.step_vector(
                    "ρ",
                    "m",
                    body.centre - *point,
                    "Along the arm, from its fixed point to G",
                );
                sheet.step_vector(
                    "v_G",
                    "m/s",
                    arm_omega.cross(arm),
                    ("Velocity of the centre of mass, which rotates with the arm", BEER.at("§15.6A")),
                )
            }
            (BodyVelocity::Fallen { gravity: down, .. }, BodyVelocityGiven::Fallen { height, gravity }) => {
                directed(*down)?;
                let speed = sheet.step(
                    "v_h",
                    "m/s",
                    (gravity.magnitude() * *height * 2.0).sqrt(),
                    "Speed after the fall, from m g h = m v²/2",
                );
                sheet.step_vector(
                    "v_G",
                    "m/s",
                    *gravity * (speed / gravity.magnitude()),
                    "Velocity of the centre of mass, along gravity",
                )
            }
            _ => return Err(Refusal::because("the motion of the body is not defined")),
        })
    }
}

/// A vector along which something lies has a length.
pub(crate) fn directed(vector: Vector3<f64>) -> Result<(), Refusal> {
    if vector.amax() > 0.0 && vector.iter().all(|x| x.is_finite()) {
        Ok(())
    } else {
        Err(Refusal::because("a direction has no length: write any vector along it, such as (0; 0; 1)"))
    }
}

impl BodyRotation {
    /// The letters of what is given of the rotation, with the points that are named.
    pub(crate) fn label(&self, scene: &mut Scene, at: Vector3<f64>, length: f64) {
        match self {
            BodyRotation::Axis { axis, speed } if *speed != 0.0 => {
                if let Some(along) = axis.try_normalize(0.0) {
                    scene.arrow(at, along * length, Ink::Motion, "ω_0");
                }
            }
            BodyRotation::Vector { omega } => {
                if let Some(along) = omega.try_normalize(0.0) {
                    scene.arrow(at, along * length, Ink::Motion, "ω_0");
                }
            }
            BodyRotation::RestingPoints { first, second, .. } => {
                scene.label(*first, "r_U");
                scene.label(*second, "r_V");
                scene.line([*first, *second], Ink::Faint);
            }
            BodyRotation::Axis { .. } | BodyRotation::Momentum { .. } => {}
        }
    }
}

impl BodyVelocity {
    /// The letters of what is given of the velocity.
    pub(crate) fn label(&self, scene: &mut Scene, at: Vector3<f64>, length: f64) {
        match *self {
            BodyVelocity::MassCentre { velocity } => {
                if let Some(along) = velocity.try_normalize(0.0) {
                    scene.arrow(at, along * length, Ink::Motion, "v_0");
                }
            }
            BodyVelocity::Fixed { point } | BodyVelocity::Carried { point, .. } => {
                // The body reaches to the point that holds it.
                scene.line([point, at], Ink::Body);
                scene.label(point, "r_F");
            }
            BodyVelocity::Point { point, velocity } => {
                scene.label(point, "r_P");
                if let Some(along) = velocity.try_normalize(0.0) {
                    scene.arrow(point, along * length, Ink::Motion, "v_P");
                }
            }
            BodyVelocity::Fallen { .. } => {
                scene.dimension("h", [at, at + Vector3::z() * length], Vector3::zeros());
            }
        }
    }
}
