//! Analyses by virtual work and virtual power.

mod built;
mod dyad;
pub mod engine;
pub mod equivalent_rod;
pub mod flywheel;
pub mod four_bar;
pub mod mechanism;
pub mod parts;
pub mod quick_return;
pub mod slider_crank;
mod sources;
pub mod virtual_power;
pub mod works;

dalembert_core::messages!("../locales/pt-BR.ftl");
