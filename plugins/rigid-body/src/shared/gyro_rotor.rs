//! The rotor of a gyroscope, as a user describes it.

use dalembert_core::{Inputs, Refusal, Worksheet};
use dalembert_mechanics::{Real, rigid};

use crate::shared::{body::Shape, common_errors, differences::check_disc};

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
    /// Angular momentum
    /// Its inertia and speed need not be known.
    AngularMomentum {
        /// Angular momentum of the spin.
        #[input("h_s", "kg*m^2/s", positive)]
        momentum: f64,
        /// Mass.
        /// Required only for the bearings and the weight.
        #[input("m", "kg", nonnegative)]
        mass: Option<f64>,
    },
}

impl GyroRotor {
    /// The letters of what is given of it.
    pub(crate) fn letters(&self) -> &'static str {
        match self {
            GyroRotor::RadiusOfGyration { .. } => "m, k",
            GyroRotor::Disc { .. } | GyroRotor::Shape { .. } => "m",
            GyroRotor::MomentOfInertia { mass: None, .. } => "I_a",
            GyroRotor::MomentOfInertia { .. } => "m, I_a",
            GyroRotor::AngularMomentum { mass: None, .. } => "h_s",
            GyroRotor::AngularMomentum { .. } => "m, h_s",
        }
    }

    /// The letter of its radius, where one is given.
    pub(crate) fn radius_letter(&self) -> &'static str {
        match self {
            GyroRotor::Disc { .. } => "r",
            _ => "",
        }
    }
}

/// A rotor and its spin.
pub(crate) struct SpinningRotor<N> {
    /// Angular momentum of the spin, kg·m²/s.
    pub momentum: N,
    /// Moment of inertia about the axle where it is known, kg·m².
    pub axial: Option<N>,
    /// Mass where it is known, kg.
    pub mass: Option<N>,
}

impl<W: Worksheet> GyroRotorGiven<W> {
    /// Moment of inertia about a transverse axis through G, kg·m², of a rotor whose shape is known.
    ///
    /// # Errors
    /// As those of its shape.
    pub(crate) fn transverse(&self, sheet: W) -> Result<Option<W::Num>, Refusal> {
        match self {
            GyroRotorGiven::Shape { mass, shape } => shape.transverse(*mass, "I_t", sheet).map(Some),
            _ => Ok(None),
        }
    }

    /// Angular momentum of the spin, and what is known of the inertia.
    ///
    /// # Errors
    /// A shape that is none of revolution about its z axis; a speed that is missing, or given twice.
    pub(crate) fn spinning(&self, spin: Option<W::Num>, sheet: W) -> Result<SpinningRotor<W::Num>, Refusal> {
        let (inertia, mass) = match self {
            GyroRotorGiven::AngularMomentum { momentum, mass } => {
                if spin.is_some() {
                    return Err(Refusal::because(
                        "the angular momentum of the rotor contains its speed: leave the speed out",
                    ));
                }
                return Ok(SpinningRotor { momentum: *momentum, axial: None, mass: *mass });
            }
            GyroRotorGiven::RadiusOfGyration { mass, radius_of_gyration } => {
                let disc = || rigid::disc_axial_inertia(*mass, *radius_of_gyration);
                sheet.common_error("I_a", common_errors::AS_DISC, disc);
                let inertia = sheet.step(
                    "I_a",
                    "kg*m^2",
                    *mass * radius_of_gyration.powi(2),
                    "Moment of inertia about the axle, from the radius of gyration",
                );
                (inertia, Some(*mass))
            }
            GyroRotorGiven::Disc { mass, radius } => {
                common_errors::of_disc("I_a", *mass, *radius, sheet);
                let inertia = sheet.step(
                    "I_a",
                    "kg*m^2",
                    rigid::disc_axial_inertia(*mass, *radius),
                    "Moment of inertia of a disc about its axle",
                );
                check_disc(inertia, *mass, *radius, sheet);
                (inertia, Some(*mass))
            }
            GyroRotorGiven::Shape { mass, shape } => (shape.axial(*mass, sheet)?, Some(*mass)),
            GyroRotorGiven::MomentOfInertia { inertia, mass } => (*inertia, *mass),
        };
        let spin = spin.ok_or_else(|| {
            Refusal::because(
                "the rotor is given by its inertia: write its speed, or give its angular momentum",
            )
        })?;
        if !matches!(self, GyroRotorGiven::MomentOfInertia { .. }) {
            sheet.answer("axial_inertia", "Moment of inertia about the axle", inertia);
        }
        Ok(SpinningRotor { momentum: inertia * spin, axial: Some(inertia), mass })
    }
}
