//! A mass, given as such or by its weight.

use dalembert_core::{Inputs, Worksheet};

/// How heavy a body is.
#[derive(Clone, Debug, Inputs)]
pub enum Mass {
    /// Mass given
    Mass {
        /// Mass.
        #[input("m", "kg", positive)]
        mass: f64,
    },
    /// Weight given
    Weight {
        /// Weight.
        #[input("W", "N", positive)]
        weight: f64,
        /// Gravity.
        #[input("g", "m/s^2", positive, default = "9.80665 m/s^2")]
        gravity: f64,
    },
}

/// The mass, kg, with the step that leads to it from a weight.
#[inline]
pub(crate) fn mass<W: Worksheet>(given: &MassGiven<W>, sheet: W) -> W::Num {
    match given {
        MassGiven::Mass { mass } => *mass,
        MassGiven::Weight { weight, gravity } => {
            sheet.step("m", "kg", *weight / *gravity, "Mass of that weight")
        }
    }
}
