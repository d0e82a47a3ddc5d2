//! Parts that several analyses share: inputs, steps of the working and pictures.

pub mod body_load;
pub mod chain;
pub(crate) mod continuous;
pub mod decay;
pub(crate) mod dry_friction;
pub(crate) mod free_motion;
pub mod inertia;
pub mod jeffcott;
pub(crate) mod letters;
pub mod load;
pub mod main_springs;
pub mod oscillator;
pub mod section;
pub mod spectral_density;
pub mod spring;
pub mod support;
pub mod system;
pub(crate) mod turning;
