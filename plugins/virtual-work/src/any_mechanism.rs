//! Any mechanism.

pub mod equilibrium;
pub mod mechanism;
pub mod motion;
pub mod virtual_power;
