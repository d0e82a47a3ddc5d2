//! Inertia and momentum.

pub mod impulse;
pub mod mass_properties;
pub mod momentum;
pub mod rate_of_change;
