//! Field balancing.

pub mod field;
pub mod without_phase;
