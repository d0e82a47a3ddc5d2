//! Isolation, absorbers and instruments.

pub mod damped_absorber;
pub mod friction_damper;
pub mod pendulum_absorber;
pub mod vibration_absorber;
pub mod vibration_instrument;
pub mod vibration_isolation;
