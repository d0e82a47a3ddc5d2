//! A body by its mass or by its weight, with the gravity of the problem.

use dalembert_core::{Inputs, Reason, Symbol, Worksheet};

/// A mass or a weight.
#[derive(Clone, Debug, Inputs)]
pub enum MassOrWeight {
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
    },
}

impl<W: Worksheet> MassOrWeightGiven<W> {
    /// The mass, kg, written as the step `symbol` where the weight is given.
    #[inline]
    pub(crate) fn mass(
        &self,
        gravity: W::Num,
        sheet: W,
        symbol: impl Into<Symbol>,
        why: impl Into<Reason>,
    ) -> W::Num {
        match *self {
            MassOrWeightGiven::Mass { mass } => mass,
            MassOrWeightGiven::Weight { weight } => sheet.step(symbol, "kg", weight / gravity, why),
        }
    }
}
