//! Analyses of rigid bodies in space: angular momentum, its rate of change, and the couples that go with it.

pub mod body;
mod differences;
pub mod dipping_rail;
pub mod dynamic_equilibrium;
pub mod edge_mill;
pub mod free_axisymmetric;
pub mod free_triaxial;
pub mod gyroscopic_couple;
pub mod heavy_top;
pub mod impulse;
mod inertia;
pub mod joints;
pub mod mass_properties;
pub mod momentum;
pub mod motion;
pub mod rate_of_change;
pub mod reactions;
pub mod rod_on_shaft;
pub mod rolling_cone;
pub mod rolling_motion;
pub mod rolling_stability;
pub mod rotation_chain;
pub mod scene;
mod sources;
pub mod spinning_disc_on_arm;
pub mod steady_rolling;
pub mod top_body;
pub mod top_nutation;
pub mod turn_indicator;
pub mod two_bladed_rotor;
pub mod two_wheeler_lean;
pub mod wheel;
pub mod wheel_loads;

dalembert_core::messages!("../locales/pt-BR.ftl");
