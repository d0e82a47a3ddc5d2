//! A rod that strikes a rigid wall with its end `ξ = 0` at the time `τ = 0`: the solution of d'Alembert. Lengths over
//! the length of the rod, time over that of a wave along it, displacements over speed times that time; nothing is
//! pulled by the wall, so that at `τ = 2` the rod leaves it with its speed turned round.
//!
//! S. Timoshenko, *Vibration Problems in Engineering*, 3rd ed., ch. 5.

/// Displacement towards the wall at a place `ξ`, 0 to 1.
pub fn displacement(xi: f64, tau: f64) -> f64 {
    // Every section goes on until the front comes, rests, and goes back behind the front that returns.
    let (stopped, thrown) = (tau.min(xi), (tau - (2.0 - xi)).max(0.0));
    stopped - thrown
}

/// Compressive stress over `ρ c v`: one between the two fronts, zero elsewhere.
pub fn stress(xi: f64, tau: f64) -> f64 {
    if tau >= xi && tau < 2.0 - xi { 1.0 } else { 0.0 }
}
