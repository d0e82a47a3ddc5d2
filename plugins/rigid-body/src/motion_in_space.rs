//! Motion in space.

pub mod motion;
pub mod rotation_chain;
