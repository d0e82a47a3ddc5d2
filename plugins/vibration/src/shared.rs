//! Parts that several analyses share: inputs, steps of the working and pictures.

pub mod chain;
pub(crate) mod continuous;
pub mod decay;
pub(crate) mod free_motion;
pub mod inertia;
pub mod jeffcott;
pub mod load;
pub mod oscillator;
pub mod section;
pub mod spectral_density;
pub mod spring;
pub mod system;
