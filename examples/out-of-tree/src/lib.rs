//! The analyses of a laboratory, and their Portuguese.

pub mod torsional_pendulum;

dalembert_core::messages!("../locales/pt-BR.ftl");
