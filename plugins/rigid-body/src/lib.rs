//! Analyses of rigid bodies in space: angular momentum, its rate of change, and the couples that go with it.

pub mod bodies_on_rotating_shafts;
pub mod free_bodies_and_tops;
pub mod gyroscopes_and_vehicles;
pub mod inertia_and_momentum;
pub mod motion_in_space;
pub mod rolling_bodies;
pub mod shared;

mod sources;

dalembert_core::messages!("../locales/pt-BR.ftl");
