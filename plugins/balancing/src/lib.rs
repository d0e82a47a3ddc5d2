//! Analyses of balancing.

pub mod engines_and_linkages;
pub mod field_balancing;
pub mod rigid_rotors;
pub mod shared;

mod sources;

dalembert_core::messages!("../locales/pt-BR.ftl");
