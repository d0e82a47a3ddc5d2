//! Moments of inertia of discs and rotors, as one number `J`.

use dalembert_core::{Inputs, Symbol, Worksheet};
use dalembert_mechanics::Real;

/// The moment of inertia of a body about the axis it turns on.
#[derive(Clone, Debug, Inputs)]
pub enum Inertia {
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

/// The moment of inertia, kg·m², written as the step `symbol` where it is not given.
#[inline]
pub fn moment_of_inertia<W: Worksheet>(given: &InertiaGiven<W>, sheet: W, symbol: Symbol) -> W::Num {
    match given {
        InertiaGiven::Given { inertia } => *inertia,
        InertiaGiven::Gyration { mass, radius } => gyration(*mass, *radius, sheet, symbol),
        InertiaGiven::WeightMoment { weight_moment, gravity } => {
            of_weight_moment(*weight_moment, *gravity, sheet, symbol)
        }
        InertiaGiven::Disc { mass, diameter } => disc(*mass, *diameter, sheet, symbol),
        InertiaGiven::Ring { mass, diameter } => {
            let inertia = *mass * diameter.powi(2) / 4.0;
            sheet.step(symbol, "kg*m^2", inertia, "Moment of inertia of a ring about its axis")
        }
    }
}

/// From mass and radius of gyration.
#[inline]
pub(crate) fn gyration<W: Worksheet>(mass: W::Num, radius: W::Num, sheet: W, symbol: Symbol) -> W::Num {
    sheet.step(symbol, "kg*m^2", mass * radius.powi(2), "Moment of inertia from the radius of gyration")
}

/// Of a solid disc.
#[inline]
pub(crate) fn disc<W: Worksheet>(mass: W::Num, diameter: W::Num, sheet: W, symbol: Symbol) -> W::Num {
    let inertia = mass * diameter.powi(2) / 8.0;
    sheet.step(symbol, "kg*m^2", inertia, "Moment of inertia of a solid disc about its axis")
}

/// From weight times the square of the radius of gyration.
#[inline]
pub(crate) fn of_weight_moment<W: Worksheet>(
    weight_moment: W::Num,
    gravity: W::Num,
    sheet: W,
    symbol: Symbol,
) -> W::Num {
    let why = "Moment of inertia: the weight over gravity is the mass";
    sheet.step(symbol, "kg*m^2", weight_moment / gravity, why)
}
