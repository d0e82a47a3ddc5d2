//! Free vibration.

pub mod bar_on_two_springs;
pub mod coulomb_damping;
pub mod decay_identification;
#[expect(clippy::module_inception, reason = "the analysis has the name of its topic")]
pub mod free_vibration;
pub mod logarithmic_decrement;
pub mod torsional_friction;
