//! Vibration beyond the closed formulas of [`crate::sdof`]: motion from rest, bands of frequencies, instruments,
//! periodic forces.

pub mod from_rest;
pub mod instrument;
pub mod isolation;
pub mod periodic;
pub mod quadrature;
//! Vibration: motions of one and of many degrees of freedom.

pub mod decay_fit;
pub mod dry_forced;
pub mod free;
pub mod friction;
pub mod jenkins;
