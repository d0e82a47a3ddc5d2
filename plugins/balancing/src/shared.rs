//! Parts that several analyses share: inputs, steps of the working and pictures.

pub mod crank;
pub mod rotor;
pub(crate) mod views;
