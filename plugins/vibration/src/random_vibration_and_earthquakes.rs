//! Random vibration and earthquakes.

pub mod random_chain;
pub mod random_load_on_beam;
pub mod random_response;
pub mod response_spectrum;
