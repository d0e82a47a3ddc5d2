//! Moments of inertia of discs and rotors, as one number `J`.

use dalembert_core::{Inputs, Symbol, Worksheet};
use dalembert_mechanics::Real;

/// The moment of inertia of a rotor about its axis.
#[derive(Clone, Debug, Inputs)]
pub enum RotorInertia {
    /// Moment of inertia given
    Given {
        /// Moment of inertia.
        /// About the axis of rotation.
        #[input("J", "kg*m^2", positive)]
        inertia: f64,
    },
    /// Mass and radius of gyration
    Gyration {
        /// Mass.
        #[input("m", "kg", positive)]
        mass: f64,
        /// Radius of gyration.
        #[input("κ", "m", positive)]
        radius: f64,
    },
    /// Weight times the square of the radius of gyration
    WeightMoment {
        /// Weight times the square of the radius of gyration.
        /// W R² of older books, with the weight as a force: lbf·ft².
        #[input("WR²", "N*m^2", positive)]
        weight_moment: f64,
        /// Gravity.
        #[input("g", "m/s^2", positive, default = "9.81 m/s^2")]
        gravity: f64,
    },
    /// Solid disc
    Disc {
        /// Mass.
        #[input("m", "kg", positive)]
        mass: f64,
        /// Diameter.
        #[input("D", "m", positive)]
        diameter: f64,
    },
}

/// The moment of inertia of a body about its axis of rotation.
#[derive(Clone, Debug, Inputs)]
pub enum Inertia {
    /// Of a rotor
    #[input(flatten)]
    Rotor(RotorInertia),
    /// Ring
    /// All of its mass at one radius.
    Ring {
        /// Mass.
        #[input("m", "kg", positive)]
        mass: f64,
        /// Mean diameter.
        #[input("D", "m", positive)]
        diameter: f64,
    },
}

impl<W: Worksheet> RotorInertiaGiven<W> {
    /// The moment of inertia, kg·m², written as the step `symbol` where it is not given.
    #[inline]
    pub(crate) fn moment(&self, sheet: W, symbol: Symbol) -> W::Num {
        let (inertia, why) = match *self {
            RotorInertiaGiven::Given { inertia } => return inertia,
            RotorInertiaGiven::Gyration { mass, radius } => {
                (mass * radius.powi(2), "Moment of inertia from the radius of gyration")
            }
            RotorInertiaGiven::WeightMoment { weight_moment, gravity } => {
                (weight_moment / gravity, "Moment of inertia: the weight over gravity is the mass")
            }
            RotorInertiaGiven::Disc { mass, diameter } => {
                (mass * diameter.powi(2) / 8.0, "Moment of inertia of a solid disc about its axis")
            }
        };
        sheet.step(symbol, "kg*m^2", inertia, why)
    }
}

/// The moment of inertia, kg·m², written as the step `symbol` where it is not given.
#[inline]
pub fn moment_of_inertia<W: Worksheet>(given: &InertiaGiven<W>, sheet: W, symbol: Symbol) -> W::Num {
    match given {
        InertiaGiven::Rotor(rotor) => rotor.moment(sheet, symbol),
        InertiaGiven::Ring { mass, diameter } => {
            let inertia = *mass * diameter.powi(2) / 4.0;
            sheet.step(symbol, "kg*m^2", inertia, "Moment of inertia of a ring about its axis")
        }
    }
}
