//! Analyses of balancing.

mod sources;
pub mod two_plane;

dalembert_core::messages!("../locales/pt-BR.ftl");
