//! Rolling bodies.

pub mod ball_on_turntable;
pub mod rolling_cone;
pub mod rolling_motion;
pub mod rolling_stability;
pub mod steady_rolling;
