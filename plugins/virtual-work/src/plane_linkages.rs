//! Plane linkages.

pub mod five_bar;
pub mod four_bar;
pub mod oscillating_cylinder;
pub mod quick_return;
pub mod scotch_yoke;
pub mod six_bar;
pub mod slider_crank;
