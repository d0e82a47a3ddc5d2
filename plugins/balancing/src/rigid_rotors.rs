//! Rigid rotors.

pub mod known_masses;
pub mod single_plane;
pub mod splitting;
pub mod static_couple;
pub mod tolerance;
pub mod two_plane;
