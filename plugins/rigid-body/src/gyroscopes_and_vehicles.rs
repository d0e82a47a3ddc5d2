//! Gyroscopes and vehicles.

pub mod dipping_rail;
pub mod gyrocompass;
pub mod gyroscopic_couple;
pub mod pendulous_gyro;
pub mod turn_indicator;
pub mod two_wheeler_lean;
pub mod wheel_loads;
