//! Bodies that obey the one-dimensional wave equation: a string under tension, a rod along its axis, a shaft in
//! torsion, a beam that only shears. All is in units of the body: lengths over its length `L`, masses over its whole
//! mass, stiffnesses over `S/L`, where `S` is the tension, `E A`, `G J` or `κ G A`.
//!
//! S. S. Rao, *Mechanical Vibrations*, 5th ed., §§8.2–8.4; R. D. Blevins, *Formulas for Natural Frequency and Mode
//! Shape* (1979), ch. 8.

use std::{f64::consts::PI, ops::ControlFlow};

use dalembert_numerics::{
    gauss_legendre,
    roots::{self, RootError},
};

/// Mass and stiffness at an end of the body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WaveEnd {
    /// Stiffness of a spring to the ground, over `S/L`; infinite for a fixed end.
    pub stiffness: f64,
    /// Mass at the end, over the mass of the body.
    pub mass: f64,
}

/// The shape of a vibration, largest deflection one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WaveShape {
    wave_number: f64,
    phase: f64,
    scale: f64,
}

impl WaveEnd {
    /// An end that does not move.
    pub const FIXED: WaveEnd = WaveEnd { stiffness: f64::INFINITY, mass: 0.0 };
    /// An end that carries nothing.
    pub const FREE: WaveEnd = WaveEnd { stiffness: 0.0, mass: 0.0 };

    /// The angle `θ` of the end, in `[0, π]`: seen from a fixed point of the wave it stands `θ` away. It never falls
    /// with the wave number, which is why the roots can be counted.
    fn angle(self, wave_number: f64) -> f64 {
        if self.stiffness.is_infinite() {
            return 0.0;
        }
        wave_number.atan2(self.stiffness - self.mass * wave_number.powi(2))
    }

    /// The rate of [`angle`](WaveEnd::angle), never negative.
    fn turn(self, wave_number: f64) -> f64 {
        if self.stiffness.is_infinite() {
            return 0.0;
        }
        let inertia = self.mass * wave_number.powi(2);
        (self.stiffness + inertia) / ((self.stiffness - inertia).powi(2) + wave_number.powi(2))
    }

    /// Returns true if the end leaves the body a rigid-body motion.
    fn is_loose(self) -> bool {
        self.stiffness == 0.0
    }
}

/// Motions of the body as a whole at no frequency: one where no end holds it.
pub fn rigid_motions(ends: [WaveEnd; 2]) -> usize {
    usize::from(ends.iter().all(|end| end.is_loose()))
}

/// The first `count` roots `β_n = ω_n L/c` above zero, ascending, each to `1e-13`.
///
/// With the angles of the ends the frequency equation reads `β + θ₀(β) + θ₁(β) = n π`, the left side rising all the
/// way: every `n` has exactly one root, between `(n − 2) π` and `n π`, so that none is missed and none is double.
///
/// # Errors
/// `NotFinite` for data that are not finite numbers, or out of their range; others of [`RootError`].
pub fn roots(ends: [WaveEnd; 2], count: usize) -> Result<Vec<f64>, RootError> {
    let bad = |x: f64| x.is_nan() || x < 0.0;
    if ends.iter().any(|end| bad(end.stiffness) || bad(end.mass) || end.mass.is_infinite()) {
        return Err(RootError::NotFinite { at: 0.0 });
    }
    let rigid = rigid_motions(ends);
    (1..=count)
        .map(|n| {
            let turns = (n + rigid) as f64 * PI;
            let lower = (turns - 2.0 * PI).max(0.0);
            let equation = |beta: f64| {
                if beta == 0.0 {
                    return if rigid == 0 { -turns } else { PI - turns };
                }
                beta + ends[0].angle(beta) + ends[1].angle(beta) - turns
            };
            let root = roots::find(equation, [lower, turns], |_| ControlFlow::Continue(()))?;
            // One step of Newton takes back the width of the bracket.
            let slope = 1.0 + ends[0].turn(root) + ends[1].turn(root);
            Ok(root - equation(root) / slope)
        })
        .collect()
}

/// The frequency function `(g₀ g₁ − β²) sin β + (g₀ + g₁) β cos β` with `g = κ − μ β²` at each end, over a positive
/// number that keeps it of order one.
pub fn characteristic(ends: [WaveEnd; 2], wave_number: f64) -> f64 {
    (wave_number + ends[0].angle(wave_number) + ends[1].angle(wave_number)).sin()
}

/// The shape at a root.
pub fn shape(ends: [WaveEnd; 2], root: f64) -> WaveShape {
    let phase = ends[0].angle(root);
    // The largest of |sin| over the stretch from the one end to the other.
    let (from, to) = (phase, phase + root);
    let passes_a_crest = ((to - PI / 2.0) / PI).floor() >= ((from - PI / 2.0) / PI).ceil();
    let largest = if passes_a_crest { 1.0 } else { from.sin().abs().max(to.sin().abs()) };
    WaveShape { wave_number: root, phase, scale: 1.0 / largest }
}

impl WaveShape {
    /// Deflection at `ξ`, 0 to 1.
    pub fn deflection(&self, xi: f64) -> f64 {
        self.scale * (self.phase + self.wave_number * xi).sin()
    }

    /// Slope `dU/dξ`.
    pub fn slope(&self, xi: f64) -> f64 {
        self.scale * self.wave_number * (self.phase + self.wave_number * xi).cos()
    }

    /// Points between the ends that stay at rest, ascending.
    pub fn nodes(&self) -> Vec<f64> {
        let first = (self.phase / PI).floor() as i64;
        (first..)
            .map(|n| (n as f64 * PI - self.phase) / self.wave_number)
            .skip_while(|xi| *xi <= 1e-9)
            .take_while(|xi| *xi < 1.0 - 1e-9)
            .collect()
    }

    /// Rayleigh's quotient of the shape: twice the largest strain energy over twice the kinetic energy at unit
    /// frequency, by Gauss quadrature. At a root it is `β²`.
    pub fn rayleigh_quotient(&self, ends: [WaveEnd; 2]) -> f64 {
        let panels = 1 + (self.wave_number / 2.0) as usize;
        let strain = gauss_legendre::integral(panels, |xi| self.slope(xi).powi(2));
        let kinetic = gauss_legendre::integral(panels, |xi| self.deflection(xi).powi(2));
        let at = |end: WaveEnd, xi: f64| {
            let square = self.deflection(xi).powi(2);
            let spring = if end.stiffness.is_infinite() { 0.0 } else { end.stiffness * square };
            (spring, end.mass * square)
        };
        let ((k0, m0), (k1, m1)) = (at(ends[0], 0.0), at(ends[1], 1.0));
        (strain + k0 + k1) / (kinetic + m0 + m1)
    }

    /// `∫ U V dξ + Σ μ U V` of two shapes: zero where they belong to different roots.
    pub fn inertia_product(&self, other: &WaveShape, ends: [WaveEnd; 2]) -> f64 {
        let panels = 1 + ((self.wave_number + other.wave_number) / 3.0) as usize;
        let product = |xi: f64| self.deflection(xi) * other.deflection(xi);
        gauss_legendre::integral(panels, product) + ends[0].mass * product(0.0) + ends[1].mass * product(1.0)
    }
}
