//! The rotor of a gyroscope, as a user describes it.

use dalembert_core::{Inputs, Refusal, Worksheet};
use dalembert_mechanics::{Real, rigid};

use crate::shared::{body::Shape, differences::check_disc};

/// A symmetric rotor.
#[derive(Clone, Debug, Inputs)]
pub enum GyroRotor {
    /// Mass and radius of gyration
    RadiusOfGyration {
        /// Mass.
        #[input("m", "kg", positive)]
        mass: f64,
        /// Radius of gyration about the axle.
        #[input("k", "m", positive)]
        radius_of_gyration: f64,
    },
    /// Thin disc
    Disc {
        /// Mass.
        #[input("m", "kg", positive)]
        mass: f64,
        /// Radius.
        #[input("r", "m", positive)]
        radius: f64,
    },
    /// A shape
    /// Its own z axis along the axle.
    Shape {
        /// Mass.
        #[input("m", "kg", positive)]
        mass: f64,
        /// Shape.
        shape: Shape,
    },
    /// Moment of inertia
    MomentOfInertia {
        /// Moment of inertia about the axle.
        #[input("I_a", "kg*m^2", positive)]
        inertia: f64,
        /// Mass.
        /// Required only for the bearings and the weight.
        #[input("m", "kg", nonnegative)]
        mass: Option<f64>,
    },
}

impl<W: Worksheet> GyroRotorGiven<W> {
    /// Moment of inertia about the axle, and the mass where it is known.
    ///
    /// # Errors
    /// A shape that is none of revolution about its z axis.
    pub(crate) fn inertia(&self, sheet: W) -> Result<(W::Num, Option<W::Num>), Refusal> {
        let (inertia, mass) = match self {
            GyroRotorGiven::RadiusOfGyration { mass, radius_of_gyration } => {
                let inertia = sheet.step(
                    "I_a",
                    "kg*m^2",
                    *mass * radius_of_gyration.powi(2),
                    "Moment of inertia about the axle, from the radius of gyration",
                );
                (inertia, *mass)
            }
            GyroRotorGiven::Disc { mass, radius } => {
                let inertia = sheet.step(
                    "I_a",
                    "kg*m^2",
                    rigid::disc_axial_inertia(*mass, *radius),
                    "Moment of inertia of a disc about its axle",
                );
                check_disc(inertia, *mass, *radius, sheet);
                (inertia, *mass)
            }
            GyroRotorGiven::Shape { mass, shape } => {
                let [axial, _] = shape.axial_and_transverse(*mass, "I_G", sheet)?;
                (axial, *mass)
            }
            GyroRotorGiven::MomentOfInertia { inertia, mass } => return Ok((*inertia, *mass)),
        };
        sheet.answer("axial_inertia", "Moment of inertia about the axle", inertia);
        Ok((inertia, Some(mass)))
    }
}
