//! Stiffness and inertia.

pub mod beam_and_springs;
pub mod equivalent_stiffness;
pub mod equivalent_system;
pub mod spring_network;
pub mod swing_test;
