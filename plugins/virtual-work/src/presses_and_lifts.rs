//! Presses and lifts.

pub mod lazy_tongs;
pub mod rack_press;
pub mod scissor_lift;
pub mod screw_jack;
pub mod toggle_press;
