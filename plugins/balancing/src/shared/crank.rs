//! Cranks by their radius or by the stroke.

use dalembert_core::{Inputs, Worksheet};

/// Crank radius or stroke.
#[derive(Clone, Debug, Inputs)]
pub enum Throw {
    /// Crank radius
    Radius {
        /// Crank radius.
        #[input("r", "mm", positive)]
        radius: f64,
    },
    /// Stroke
    Stroke {
        /// Stroke.
        #[input("S", "mm", positive)]
        stroke: f64,
    },
}

impl<W: Worksheet> ThrowGiven<W> {
    /// The crank radius, m, as a step where the stroke is given.
    #[inline]
    pub(crate) fn radius(&self, sheet: W) -> W::Num {
        match *self {
            ThrowGiven::Radius { radius } => radius,
            ThrowGiven::Stroke { stroke } => {
                sheet.step("r", "mm", stroke / 2.0, "The crank radius is half the stroke")
            }
        }
    }
}
