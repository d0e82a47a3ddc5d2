//! Shock and impact.

pub mod drop_impact;
pub mod gun_recoil;
pub mod rod_impact;
pub mod rod_under_sudden_force;
pub mod shock_response_spectrum;
pub mod transient_response;
