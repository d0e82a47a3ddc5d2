//! Parts that several analyses share: inputs, steps of the working and pictures.

pub mod attitude;
pub mod body;
pub(crate) mod common_errors;
pub(crate) mod differences;
pub(crate) mod flat;
pub mod gyro_rotor;
pub(crate) mod inertia;
pub mod joints;
pub mod scene;
pub mod top_body;
pub mod wheel;
