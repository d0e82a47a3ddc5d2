//! Crankshafts in torsion: the stiffness of a crank throw, and the sums of the phase vectors of the cylinders.
//!
//! W. Ker Wilson, *Practical Solution of Torsional Vibration Problems*, vol. 1; J. P. Den Hartog, *Mechanical
//! Vibrations*, 4th ed., ch. 5.

use std::f64::consts::PI;

use crate::Real;

/// A crank throw, from the middle of one journal to the middle of the next, m.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CrankThrow<S> {
    /// Length of a journal.
    pub journal_length: S,
    /// Diameter of the journals.
    pub journal_diameter: S,
    /// Bore of the journals, if they have one.
    pub journal_bore: Option<S>,
    /// Length of the crankpin.
    pub pin_length: S,
    /// Diameter of the crankpin.
    pub pin_diameter: S,
    /// Bore of the crankpin, if it has one.
    pub pin_bore: Option<S>,
    /// Thickness of a web, along the shaft.
    pub web_thickness: S,
    /// Width of a web.
    pub web_width: S,
    /// Radius of the crank.
    pub radius: S,
}

/// Contributions of journals, crankpin and webs to `32/(π G)` over a stiffness, 1/m³.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ThrowContributions<S> {
    /// Of the journals.
    pub journal: S,
    /// Of the crankpin.
    pub pin: S,
    /// Of the webs.
    pub webs: S,
}

impl<S: Real> CrankThrow<S> {
    /// Carter's formula: `(Lⱼ + 0.8 t)/(Dⱼ⁴ − dⱼ⁴) + 0.75 L_c/(D_c⁴ − d_c⁴) + 1.5 R/(t W³)`. It fits shafts whose
    /// webs bend more than journals and pins twist.
    #[inline]
    pub fn carter(&self) -> ThrowContributions<S> {
        ThrowContributions {
            journal: (self.journal_length + self.web_thickness * 0.8)
                / fourth_powers(self.journal_diameter, self.journal_bore),
            pin: self.pin_length * 0.75 / fourth_powers(self.pin_diameter, self.pin_bore),
            webs: self.radius * 1.5 / (self.web_thickness * self.web_width.powi(3)),
        }
    }

    /// Ker Wilson's formula: `(Lⱼ + 0.4 Dⱼ)/(Dⱼ⁴ − dⱼ⁴) + (L_c + 0.4 D_c)/(D_c⁴ − d_c⁴) + (R − 0.2 (Dⱼ + D_c))/(t W³)`.
    /// It fits shafts with stiff webs.
    #[inline]
    pub fn ker_wilson(&self) -> ThrowContributions<S> {
        ThrowContributions {
            journal: (self.journal_length + self.journal_diameter * 0.4)
                / fourth_powers(self.journal_diameter, self.journal_bore),
            pin: (self.pin_length + self.pin_diameter * 0.4)
                / fourth_powers(self.pin_diameter, self.pin_bore),
            webs: (self.radius - (self.journal_diameter + self.pin_diameter) * 0.2)
                / (self.web_thickness * self.web_width.powi(3)),
        }
    }
}

impl<S: Real> ThrowContributions<S> {
    /// Torsional stiffness of the throw, `k = π G/(32 Σ)`, N·m/rad.
    #[inline]
    pub fn stiffness(&self, shear: S) -> S {
        shear * PI / ((self.journal + self.pin + self.webs) * 32.0)
    }
}

#[inline]
fn fourth_powers<S: Real>(outer: S, inner: Option<S>) -> S {
    match inner {
        Some(inner) => outer.powi(4) - inner.powi(4),
        None => outer.powi(4),
    }
}

/// The sum of the phase vectors of an order: `Σ β cos nψ` and `Σ β sin nψ`, with the amplitude `β` of the crank of
/// each cylinder and its firing angle `ψ`.
pub fn phase_vectors(order: f64, cylinders: impl IntoIterator<Item = (f64, f64)>) -> [f64; 2] {
    let mut sum = [0.0, 0.0];
    for (amplitude, angle) in cylinders {
        let (sin, cos) = (order * angle).sin_cos();
        sum[0] += amplitude * cos;
        sum[1] += amplitude * sin;
    }
    sum
}

/// Returns true for a major order: all cylinders excite at the same phase of the vibration.
pub fn is_major(order: f64, angles: &[f64]) -> bool {
    let [x, y] = phase_vectors(order, angles.iter().map(|angle| (1.0, *angle)));
    x.hypot(y) > angles.len() as f64 * (1.0 - 1e-9)
}
