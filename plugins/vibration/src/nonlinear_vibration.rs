//! Nonlinear vibration.

pub mod duffing_oscillator;
pub mod elastoplastic_spring;
pub mod large_pendulum;
pub mod piecewise_spring;
