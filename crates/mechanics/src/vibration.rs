//! Vibration beyond the closed formulas of [`crate::sdof`]: free motion and motion from rest, friction, transients,
//! random excitation, bands of frequencies, instruments, periodic forces, networks, torsional trains, modes of many
//! degrees of freedom.
//!
//! ```
//! use std::f64::consts::PI;
//!
//! use dalembert_mechanics::vibration::modes::{ModesError, natural_modes};
//! use nalgebra::DMatrix;
//!
//! // Three equal masses between four equal springs: ω = 2 √(k/m) sin(nπ/8), and the middle mass rests in the second mode.
//! let masses = DMatrix::from_diagonal_element(3, 3, 2.0);
//! let springs = DMatrix::from_row_slice(3, 3, &[16.0, -8.0, 0.0, -8.0, 16.0, -8.0, 0.0, -8.0, 16.0]);
//! let modes = natural_modes(&masses, &springs)?;
//! for (n, square) in (1..).zip(&modes.squares) {
//!     let frequency = 2.0 * 2.0 * (f64::from(n) * PI / 8.0).sin();
//!     assert!((square.sqrt() - frequency).abs() < 1e-12);
//! }
//! assert!(modes.shapes[(1, 1)].abs() < 1e-12);
//! # Ok::<(), ModesError>(())
//! ```

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
