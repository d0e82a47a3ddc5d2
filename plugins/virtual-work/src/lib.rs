//! Analyses by virtual work and virtual power.

pub mod any_mechanism;
pub mod bars_and_levers;
pub mod engines_gears_and_wheels;
pub mod plane_linkages;
pub mod presses_and_lifts;
pub mod shared;

mod sources;

dalembert_core::messages!("../locales/pt-BR.ftl");
