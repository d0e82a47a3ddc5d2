//! Analyses of vibration: one degree of freedom, rotating unbalance, whirl, identification.

pub mod beam_and_springs;
pub mod decay;
pub mod frequency_response_identification;
pub mod rotating_unbalance;
pub mod section;
pub mod shaft_clearance;
pub mod spring;

mod sources;

dalembert_core::messages!("../locales/pt-BR.ftl");
