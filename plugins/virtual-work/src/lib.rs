//! Analyses by virtual work and virtual power.

mod sources;
pub mod virtual_power;

dalembert_core::messages!("../locales/pt-BR.ftl");
