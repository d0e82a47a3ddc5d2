//! Pendulums as absorbers: on a rotor, where the centrifugal field brings them back, and under an oscillating mass.
//!
//! Small motions of `[M₁₁ M₁₂; M₁₂ M₂₂] q″ + diag(K₁₁, K₂₂) q = [F, 0]`, with the body first and the swing second.
//! J. P. Den Hartog, *Mechanical Vibrations*, 4th ed., ch. 5.

use crate::Real;

/// Two coordinates, the body and the swing, coupled by inertia alone.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pair {
    /// Inertia of the body, with all that moves along.
    pub body: f64,
    /// Inertia that couples body and swing.
    pub coupling: f64,
    /// Inertia of the swing.
    pub swing: f64,
    /// Stiffness that holds the body; may be zero.
    pub held: f64,
    /// Stiffness that brings the swing back.
    pub back: f64,
}

impl Pair {
    /// Natural frequencies, ascending, rad/s, the roots of
    /// `(M₁₁ M₂₂ − M₁₂²) λ² − (K₁₁ M₂₂ + K₂₂ M₁₁) λ + K₁₁ K₂₂ = 0`; zero first for a body that nothing holds.
    pub fn frequencies(&self) -> [f64; 2] {
        let a = self.body * self.swing - self.coupling.powi(2);
        let b = self.held * self.swing + self.back * self.body;
        // b² − 4 a c as a sum of squares: no digits are lost where the two are close.
        let apart = (self.held * self.swing - self.back * self.body).powi(2)
            + 4.0 * self.held * self.back * self.coupling.powi(2);
        let larger = b + apart.sqrt();
        [(2.0 * self.held * self.back / larger).sqrt(), (larger / (2.0 * a)).sqrt()]
    }

    /// Steady amplitudes of body and swing under a harmonic load on the body; signs are against the load. Not finite
    /// at a natural frequency.
    pub fn steady(&self, load: f64, frequency: f64) -> [f64; 2] {
        let square = frequency.powi(2);
        let (k, l) = (self.held - self.body * square, self.back - self.swing * square);
        let coupling = self.coupling * square;
        let determinant = k * l - coupling.powi(2);
        [load * l / determinant, load * coupling / determinant]
    }
}

/// Tuned order `n = √(R r/ρ²)`: the frequency of the swing over the speed; distance `R` of the pivot from the shaft,
/// arm `r`, and `ρ²` the inertia of the swing over the mass.
#[inline]
pub fn tuned_order<S: Real>(pivot: S, arm: S, swing: S) -> S {
    (pivot * arm / swing).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A point mass of 0.3 kg at the arm 20 mm, 180 mm off the shaft, on a rotor of 0.5 kg m²; 100 rad/s.
    fn rotor(held: f64) -> Pair {
        let (mass, pivot, arm, speed) = (0.3, 0.18, 0.02, 100.0f64);
        Pair {
            body: 0.5 + mass * (pivot + arm) * (pivot + arm),
            coupling: mass * arm * (pivot + arm),
            swing: mass * arm * arm,
            held,
            back: mass * pivot * arm * speed.powi(2),
        }
    }

    #[test]
    fn order_three() {
        // With the rotor at rest the pendulums swing at three times its speed, 100 rad/s.
        let pair = rotor(0.0);
        assert!(((pair.back / pair.swing).sqrt() - 300.0).abs() < 1e-10);
        assert!((tuned_order(0.18, 0.02, 0.02f64 * 0.02) - 3.0).abs() < 1e-14);
    }

    #[test]
    fn frequencies_make_the_determinant_vanish() {
        for held in [0.0, 100.0, 4.5e4, 1e7] {
            let pair = rotor(held);
            let frequencies = pair.frequencies();
            for frequency in frequencies {
                let square = frequency.powi(2);
                let (k, l) = (pair.held - pair.body * square, pair.back - pair.swing * square);
                let rest = k * l - (pair.coupling * square).powi(2);
                let size = (pair.held + pair.body * square) * (pair.back + pair.swing * square);
                assert!(rest.abs() <= 1e-13 * size, "{held}: {rest} of {size}");
            }
            // The antiresonance parts the two.
            assert!(frequencies[0] < 300.0 && 300.0 < frequencies[1]);
        }
    }

    #[test]
    fn the_body_is_at_rest_at_the_tuned_frequency() {
        let [body, swing] = rotor(4.5e4).steady(12.0, 300.0);
        assert!(body.abs() < 1e-12);
        // The centrifugal force at the arm of the shaft balances the torque.
        let torque = 0.3 * 0.02 * (0.18 + 0.02) * 300.0f64.powi(2) * swing;
        assert!((torque + 12.0).abs() < 1e-9);
    }
}
