//! Parts that several analyses share: inputs, steps of the working and pictures.

pub(crate) mod built;
pub(crate) mod dyad;
pub(crate) mod equilibria;
pub(crate) mod figure;
pub mod flywheel;
pub(crate) mod kinematics;
pub mod linkage;
pub(crate) mod one_degree_of_freedom;
pub mod parts;
pub(crate) mod scissor;
pub mod works;
