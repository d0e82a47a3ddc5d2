//! Parts that several analyses share: inputs, steps of the working and pictures.

pub mod crank;
pub mod reading;
pub mod rotor;
pub(crate) mod split;
pub(crate) mod tolerance;
pub(crate) mod views;
