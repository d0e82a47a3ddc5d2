//! Analyses of vibration: one degree of freedom, rotating unbalance, whirl, identification.

pub mod base_excitation;
pub mod beam_and_springs;
pub mod decay;
pub mod frequency_response_identification;
pub mod harmonic_force;
pub mod harmonic_sum;
pub mod oscillator;
pub mod periodic_excitation;
pub mod rotating_unbalance;
pub mod section;
pub mod shaft_clearance;
pub mod spring;
pub mod vibration_instrument;
pub mod vibration_isolation;

mod sources;

dalembert_core::messages!("../locales/pt-BR.ftl");
