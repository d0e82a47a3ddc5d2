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

#[cfg(test)]
mod tests {
    use super::*;

    /// The series of the shapes of a rod fixed at one end, until it leaves the wall.
    #[test]
    fn waves_are_the_sum_of_all_shapes() {
        let series = |xi: f64, tau: f64| -> f64 {
            let term = |n: u32| {
                let beta = (f64::from(n) - 0.5) * std::f64::consts::PI;
                2.0 / beta.powi(2) * (beta * xi).sin() * (beta * tau).sin()
            };
            (1..20_000).rev().map(term).sum()
        };
        for xi in [0.0, 0.3, 0.9, 1.0] {
            for tau in [0.1, 0.45, 1.0, 1.3, 1.99] {
                assert!((series(xi, tau) - displacement(xi, tau)).abs() < 3e-5, "{xi} {tau}");
            }
        }
    }
}
