//! Engines, gears and wheels.

pub mod cam;
pub mod engine;
pub mod epicyclic_train;
pub mod equivalent_rod;
pub mod flywheel;
pub mod geared_drive;
pub mod rolling_disc;
