//! Springs of a main system, to which an absorber is attached.

use dalembert_core::Inputs;

/// The springs by their stiffness, or by the natural frequency without the absorber.
#[derive(Clone, Debug, Inputs)]
pub enum MainSprings {
    /// Stiffness given
    Stiffness {
        /// Stiffness.
        #[input("k", "N/m", positive)]
        stiffness: f64,
    },
    /// Natural frequency given
    NaturalFrequency {
        /// Natural frequency.
        /// Without the absorber.
        #[input("ω_m", "rad/s", positive)]
        frequency: f64,
    },
}
