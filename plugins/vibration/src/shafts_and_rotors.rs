//! Shafts and rotors.

pub mod engine_orders;
pub mod mass_on_shaft;
pub mod overhung_disc;
pub mod rotor_dynamics;
pub mod shaft_clearance;
pub mod shaft_with_discs;
pub mod torsional_train;
pub mod whirling_shaft;
