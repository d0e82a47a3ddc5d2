//! Inertia and momentum.

pub mod impact_of_two_bodies;
pub mod impulse;
pub mod mass_properties;
pub mod momentum;
pub mod momentum_of_a_system;
pub mod rate_of_change;
