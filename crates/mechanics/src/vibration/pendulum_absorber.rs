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
