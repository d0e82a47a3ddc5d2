//! Analyses by virtual work and virtual power.

#[expect(dead_code, reason = "the templates that use it come one by one")]
mod built;
pub mod engine;
pub mod equivalent_rod;
pub mod flywheel;
mod sources;
pub mod virtual_power;

dalembert_core::messages!("../locales/pt-BR.ftl");
