//! Parts that several analyses share: inputs, steps of the working and pictures.

pub mod rotor;
pub(crate) mod views;
