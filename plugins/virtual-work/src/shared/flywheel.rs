//! Flywheels, and the cycles over which they even out a moment.

use dalembert_core::{Inputs, Worksheet};
use dalembert_mechanics::Real;

/// Strokes of a cycle.
#[derive(Clone, Copy, Debug, Inputs)]
pub enum Strokes {
    /// Four strokes
    Four,
    /// Two strokes
    Two,
}

/// The moment of inertia of a flywheel.
#[derive(Clone, Debug, Inputs)]
pub enum FlywheelInertia {
    /// Mass and radius of gyration
    Gyration {
        /// Mass.
        #[input("m_F", "kg", positive)]
        mass: f64,
        /// Radius of gyration.
        #[input("k_F", "m", positive)]
        radius: f64,
    },
    /// Moment of inertia
    Moment {
        /// Moment of inertia.
        #[input("I_F", "kg*m^2", positive)]
        inertia: f64,
    },
}

impl Strokes {
    /// Turns of the crank in a cycle.
    pub(crate) fn turns(self) -> u8 {
        match self {
            Strokes::Four => 2,
            Strokes::Two => 1,
        }
    }
}

impl<W: Worksheet> FlywheelInertiaGiven<W> {
    /// The moment of inertia, kg·m², as a step where it is found.
    #[inline]
    pub(crate) fn moment(&self, sheet: W) -> W::Num {
        match *self {
            FlywheelInertiaGiven::Moment { inertia } => inertia,
            FlywheelInertiaGiven::Gyration { mass, radius } => {
                sheet.step("I_F", "kg*m^2", mass * radius.powi(2), "Moment of inertia of the flywheel")
            }
        }
    }
}
