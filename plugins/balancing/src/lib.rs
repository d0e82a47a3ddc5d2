//! Analyses of balancing.

pub mod field;
pub mod known_masses;
pub mod linkage_balance;
pub mod locomotive;
pub mod reciprocating;
pub mod rotor;
pub mod single_plane;
mod sources;
pub mod splitting;
pub mod static_couple;
pub mod tolerance;
pub mod two_plane;
mod views;
pub mod without_phase;

dalembert_core::messages!("../locales/pt-BR.ftl");
