//! Bodies on rotating shafts.

pub mod dynamic_equilibrium;
pub mod edge_mill;
pub mod reactions;
pub mod rod_on_shaft;
pub mod spinning_disc_on_arm;
pub mod two_bladed_rotor;
