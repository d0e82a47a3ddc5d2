//! Vibration beyond the closed formulas of [`crate::sdof`]: free motion and motion from rest, friction, transients,
//! random excitation, bands of frequencies, instruments, periodic forces, networks, torsional trains, modes of many
//! degrees of freedom.

pub mod absorber;
pub mod base_modes;
pub mod crankshaft;
pub mod decay_fit;
pub mod duffing;
pub mod forced_coulomb;
pub mod free;
pub mod friction;
pub mod impact;
pub mod instrument;
pub mod isolation;
pub mod jenkins;
pub mod lumped;
pub mod modes;
pub mod network;
pub mod pendulum_absorber;
pub mod periodic;
pub mod piecewise;
pub mod plate;
pub mod poles;
pub mod random;
pub mod rayleigh;
pub mod receptance;
pub mod response;
pub mod swing;
pub mod torsional;
pub mod transient;
pub mod transient_from_rest;
pub mod wave;
