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

/// Displacement at a place `ξ`, 0 to 1 from the loaded end, of a free rod that a constant force pushes from `τ = 0` on;
/// displacements over the velocity behind the first wavefront times the time of a wave along the rod.
///
/// Each round trip of the wave, `τ = 2`, leaves the rod without stress and faster by twice that velocity.
pub fn free_rod_displacement(xi: f64, tau: f64) -> f64 {
    let trips = (tau / 2.0).floor();
    let lapse = tau - 2.0 * trips;
    let before = 2.0 * trips * trips + 2.0 * trips * lapse;
    before + (lapse - xi).max(0.0) + (lapse - (2.0 - xi)).max(0.0)
}

/// The same by modes: the motion as a rigid body, `τ²/2`, and the series `Σ 2/(nπ)² cos nπξ (1 − cos nπτ)` of the
/// free-free modes, whose sums `Σ cos nθ/n²` are parabolas.
pub fn free_rod_modal_displacement(xi: f64, tau: f64) -> f64 {
    use std::f64::consts::{PI, TAU};
    let parabola = |theta: f64| {
        let theta = theta.rem_euclid(TAU);
        PI * PI / 6.0 - PI * theta / 2.0 + theta * theta / 4.0
    };
    let shapes = parabola(PI * xi) - 0.5 * (parabola(PI * (xi + tau)) + parabola(PI * (xi - tau)));
    0.5 * tau * tau + 2.0 / (PI * PI) * shapes
}
