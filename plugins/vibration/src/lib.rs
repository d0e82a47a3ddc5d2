//! Analyses of vibration: one degree of freedom, rotating unbalance, whirl, identification.

mod rotating_unbalance;
mod sources;

dalembert_core::messages!("../locales/pt-BR.ftl");
