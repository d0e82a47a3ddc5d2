//! Tests of the parts of the vibration analyses against tables, brute force and typed values.

#![expect(clippy::unwrap_used, reason = "a test ends where its data fails")]

mod firing_orders;
mod large_systems;
mod rotors;
mod shaft_clearance;
mod springs;
mod torsional_springs;
