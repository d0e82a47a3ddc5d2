//! Analyses of balancing.

pub mod known_masses;
pub mod rotor;
pub mod single_plane;
mod sources;
pub mod two_plane;
mod views;

dalembert_core::messages!("../locales/pt-BR.ftl");
