//! Stiffness and inertia.

pub mod beam_and_springs;
pub mod equivalent_stiffness;
pub mod spring_network;
pub mod swing_test;
