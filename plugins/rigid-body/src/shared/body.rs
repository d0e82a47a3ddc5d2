//! Inputs of a rigid body: its parts or its inertia, its rotation, a line in it.

mod alone;
mod common_errors;
mod description;
mod motion;
mod outline;
mod part;
mod shape;
mod working;

use dalembert_core::{Ink, Inputs};
use nalgebra::Vector3;

use crate::shared::scene::Scene;

pub(crate) use description::refused;
pub use description::{
    Amount, AmountGiven, Body, BodyGiven, BodyPart, BodyPartGiven, Presence, ReferencePoint,
    ShapeOrientation, ShapeOrientationGiven, TakenAbout, TakenAboutGiven,
};
pub(crate) use motion::directed;
pub use motion::{BodyRotation, BodyRotationGiven, BodyVelocity, BodyVelocityGiven};
pub use shape::{Shape, ShapeGiven};
pub(crate) use working::{
    AboutPoint, PAIRS, WorkedBody, about_line, about_point, crossed, matrix_times, product_errors,
    projection_error, transferred, transferred_sum,
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

impl BodyLine {
    /// Draws the line beside a point, with the letter of the point that it goes through.
    pub(crate) fn draw(&self, scene: &mut Scene, beside: Vector3<f64>, length: f64) {
        if let Some(along) = self.direction.try_normalize(0.0) {
            let foot = self.through + along * along.dot(&(beside - self.through));
            scene.line([foot - along * length, foot + along * length], Ink::Motion);
        }
        if self.through != Vector3::zeros() {
            scene.label(self.through, "r_B");
        }
    }
}
