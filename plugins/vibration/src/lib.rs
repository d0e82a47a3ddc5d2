//! Analyses of vibration, from one degree of freedom to rotors by finite elements.

pub mod free_vibration;
pub mod harmonic_excitation;
pub mod isolation_absorbers_and_instruments;
pub mod nonlinear_vibration;
pub mod random_vibration_and_earthquakes;
pub mod several_degrees_of_freedom;
pub mod shafts_and_rotors;
pub mod shared;
pub mod shock_and_impact;
pub mod stiffness_and_inertia;
pub mod strings_beams_and_plates;

mod sources;

dalembert_core::messages!("../locales/pt-BR.ftl");
