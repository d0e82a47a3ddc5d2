//! Analyses of rigid bodies in space: angular momentum, its rate of change, and the couples that go with it.

pub mod body;
pub mod joints;
pub mod rod_on_shaft;
pub mod rotation_chain;
pub mod scene;
mod sources;
pub mod spinning_disc_on_arm;

dalembert_core::messages!("../locales/pt-BR.ftl");
