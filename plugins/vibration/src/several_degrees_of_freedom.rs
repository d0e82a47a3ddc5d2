//! Several degrees of freedom.

pub mod coupled_pendulums;
pub mod double_pendulum;
pub mod frequency_response_matrix;
pub mod half_car;
pub mod modal_analysis;
pub mod multi_degree_response;
pub mod numerical_integration;
pub mod rayleigh_damping;
