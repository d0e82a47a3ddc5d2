//! Inputs that linkages share: the closing of a loop.

use dalembert_core::Inputs;

/// The side on which the loop closes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Inputs)]
pub enum Closing {
    /// Open loop
    Open,
    /// Crossed loop
    Crossed,
}
