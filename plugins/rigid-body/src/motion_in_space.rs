//! Motion in space.

pub mod attitude;
pub mod attitude_motion;
pub mod motion;
pub mod rotation_chain;
