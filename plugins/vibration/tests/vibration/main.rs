//! What the parts of the vibration analyses do, held against tables, brute force and what is typed.

#![expect(clippy::unwrap_used, reason = "a test ends where its data fails")]

mod firing_orders;
mod rotors;
mod shaft_clearance;
mod springs;
mod torsional_springs;
