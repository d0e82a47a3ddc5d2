//! Inputs of a rigid body: its parts or its inertia, its rotation, a line in it.

mod alone;
mod description;
mod motion;
mod outline;
mod part;
mod shape;
mod working;

use dalembert_core::Inputs;
use nalgebra::Vector3;

pub(crate) use description::refused;
pub use description::{
    Amount, AmountGiven, Body, BodyGiven, BodyPart, BodyPartGiven, Presence, ReferencePoint,
    ShapeOrientation, ShapeOrientationGiven, TakenAbout, TakenAboutGiven,
};
pub(crate) use motion::directed;
pub use motion::{BodyRotation, BodyRotationGiven, BodyVelocity, BodyVelocityGiven};
pub use shape::{Shape, ShapeGiven};
pub(crate) use working::{
    AboutPoint, PAIRS, WorkedBody, about_line, about_point, crossed, matrix_times, transferred,
    transferred_sum,
};

/// A line in the body.
#[derive(Clone, Debug, Inputs)]
pub struct BodyLine {
    /// Position of a point on it.
    #[input("r_B", "m", default = "(0; 0; 0) m")]
    pub through: Vector3<f64>,
    /// Any vector along it.
    #[input("e", "1")]
    pub direction: Vector3<f64>,
}
