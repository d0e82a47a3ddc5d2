//! Random vibration: spectral densities, and mean squares as integrals over frequency.
//!
//! Densities are one-sided and per rad/s: the mean square is `∫₀^∞ S dω`. A density over the frequency in Hz is `2π`
//! times as large, and SI makes no difference between the two. Rao, *Mechanical Vibrations*, 5th ed., ch. 14.

use nalgebra::Complex;

mod quadrature;

pub use quadrature::{QuadratureError, integrate, integrate_about};

/// A density between two frequencies, by its points; zero outside them.
#[derive(Debug, Clone, PartialEq)]
pub struct Density {
    points: Vec<(f64, f64)>,
    logarithmic: bool,
}

/// Reason for which a spectral density cannot be used.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum DensityError {
    /// There are fewer than two points.
    #[error("a spectral density needs at least two points")]
    Few,
    /// The frequencies do not ascend from zero or more; two points at one frequency are a step.
    #[error(
        "the frequencies of a spectral density must be zero or more and ascend, at most two of them equal"
    )]
    Order,
    /// A value is negative or not finite; or zero, or at zero frequency, where logarithms are taken.
    #[error(
        "the values of a spectral density must be zero or more; above zero, as the frequencies, on a log-log line"
    )]
    Value,
}

impl Density {
    /// A density through points `(ω, S)`, straight between them or straight in their logarithms. Two points at one
    /// frequency are a step, at which the second one holds.
    pub fn new(points: Vec<(f64, f64)>, logarithmic: bool) -> Result<Self, DensityError> {
        if points.len() < 2 {
            return Err(DensityError::Few);
        }
        let below = |x: f64| if logarithmic { x <= 0.0 } else { x < 0.0 };
        if points.iter().any(|&(omega, s)| below(s) || below(omega) || !(s + omega).is_finite()) {
            return Err(DensityError::Value);
        }
        let descends = points.windows(2).any(|pair| pair[0].0 > pair[1].0);
        let repeats = points.windows(3).any(|three| three[0].0 == three[2].0);
        if descends || repeats || points[0].0 == points[points.len() - 1].0 {
            return Err(DensityError::Order);
        }
        Ok(Self { points, logarithmic })
    }

    /// The density at a frequency, rad/s.
    pub fn at(&self, omega: f64) -> f64 {
        let after = self.points.partition_point(|point| point.0 <= omega);
        let Some(&(x0, y0)) = after.checked_sub(1).and_then(|n| self.points.get(n)) else { return 0.0 };
        match self.points.get(after) {
            None if omega == x0 => y0,
            None => 0.0,
            Some(&(x1, y1)) if self.logarithmic => {
                y0 * ((omega / x0).ln() / (x1 / x0).ln() * (y1 / y0).ln()).exp()
            }
            Some(&(x1, y1)) => y0 + (y1 - y0) * (omega - x0) / (x1 - x0),
        }
    }

    /// The frequencies of its points, ascending; that of a step once.
    pub fn frequencies(&self) -> impl Iterator<Item = f64> {
        let before = std::iter::once(None).chain(self.points.iter().map(|point| Some(point.0)));
        let points = self.points.iter().map(|point| point.0);
        points.zip(before).filter(|(here, before)| Some(*here) != *before).map(|(here, _)| here)
    }
}

/// A mode: natural frequency in rad/s and damping ratio.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Resonance {
    /// Natural frequency without damping, rad/s.
    pub natural: f64,
    /// Damping ratio.
    pub ratio: f64,
}

impl Resonance {
    /// `1/(ωₙ² − ω² + 2iζωₙω)`, s².
    pub fn receptance(self, omega: f64) -> Complex<f64> {
        let Self { natural, ratio } = self;
        Complex::new((natural - omega) * (natural + omega), 2.0 * ratio * natural * omega).inv()
    }

    /// Frequencies about the resonance at which an integral over it is broken: closer the nearer it is.
    pub fn breaks(self) -> impl Iterator<Item = f64> {
        let width = self.ratio.max(1e-12);
        let steps = (0..24).map(move |n| width * 4f64.powi(n)).take_while(|step| *step < 8.0);
        let steps: Vec<f64> = steps.collect();
        std::iter::once(0.0)
            .chain(steps.into_iter().flat_map(|step| [step, -step]))
            .map(move |step| self.natural * (1.0 + step))
            .filter(|omega| *omega > 0.0)
    }
}

/// `|Σ γ H|²`, s⁴: the square of the displacement relative to a base over the acceleration of the base, for modes with
/// their shares `γ = Γφ`.
pub fn relative_squared(modes: &[(Resonance, f64)], omega: f64) -> f64 {
    modes.iter().map(|(mode, share)| mode.receptance(omega) * *share).sum::<Complex<f64>>().norm_sqr()
}

/// `|Σ γ(ωₙ² + 2iζωₙω)H|²`: the square of the absolute acceleration over that of the base, in which nothing cancels at
/// high frequencies. The shares of all modes make one.
pub fn absolute_squared(modes: &[(Resonance, f64)], omega: f64) -> f64 {
    let term = |(mode, share): &(Resonance, f64)| {
        let spring = Complex::new(mode.natural * mode.natural, 2.0 * mode.ratio * mode.natural * omega);
        mode.receptance(omega) * spring * *share
    };
    modes.iter().map(term).sum::<Complex<f64>>().norm_sqr()
}

/// A closed form of an integral, with the size of the terms that it is the sum of: what rounding may cost.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Closed {
    /// The integral.
    pub value: f64,
    /// Sum of the sizes of its terms.
    pub scale: f64,
}

/// `Re ∫ ω^m H_r H_s* dω` from `a` to `b` (which may be infinite while `m ≤ 2`), for `m = 0, 2, 4`, by partial
/// fractions: what two modes have in common under white noise. `None` within `1e-4` of critical damping, where two
/// poles meet, and without damping.
pub fn modal_moment(r: Resonance, s: Resonance, power: u8, [a, b]: [f64; 2]) -> Option<Closed> {
    let usable = |mode: Resonance| mode.ratio > 0.0 && (mode.ratio - 1.0).abs() > 1e-4;
    if !usable(r) || !usable(s) || (b.is_infinite() && power > 2) {
        return None;
    }
    // In multiples of the first natural frequency nothing overflows.
    let unit = r.natural;
    let (a, b) = (a / unit, b / unit);
    let poles = |mode: Resonance| {
        let spread = Complex::new((1.0 - mode.ratio) * (1.0 + mode.ratio), 0.0).sqrt();
        [spread, -spread].map(|spread| (spread + Complex::i() * mode.ratio) * (mode.natural / unit))
    };
    let all: Vec<Complex<f64>> =
        poles(r).into_iter().chain(poles(s).into_iter().map(|pole| pole.conj())).collect();
    let mut sum = if power == 4 { b - a } else { 0.0 };
    let mut scale = sum.abs();
    for (n, &pole) in all.iter().enumerate() {
        let others: Complex<f64> =
            all.iter().enumerate().filter(|(m, _)| *m != n).map(|(_, other)| pole - other).product();
        let end = if b.is_infinite() { Complex::new(0.0, 0.0) } else { (b - pole).ln() };
        let term = pole.powu(u32::from(power)) / others * (end - (a - pole).ln());
        sum += term.re;
        scale += term.norm();
    }
    let size = unit.powi(i32::from(power) - 3);
    Some(Closed { value: sum * size, scale: scale * size })
}

/// Mean square of the displacement under a white acceleration of the base or force over mass of density `S`:
/// `π S/(4ζωₙ³)`. Rao, 5th ed., §14.12.
#[inline]
pub fn white_displacement<R: crate::Real>(density: R, natural: R, ratio: R) -> R {
    density * std::f64::consts::PI / (ratio * natural.powi(3) * 4.0)
}

/// Mean square of the velocity under the same: `π S/(4ζωₙ)`.
#[inline]
pub fn white_velocity<R: crate::Real>(density: R, natural: R, ratio: R) -> R {
    density * std::f64::consts::PI / (ratio * natural * 4.0)
}

/// Mean square of the absolute acceleration on a base of white acceleration: `π S ωₙ(1 + 4ζ²)/(4ζ)`.
#[inline]
pub fn white_acceleration<R: crate::Real>(density: R, natural: R, ratio: R) -> R {
    density * std::f64::consts::PI * natural * (ratio.powi(2) * 4.0 + 1.0) / (ratio * 4.0)
}

/// Miles' mean square of the absolute acceleration, `π/2 fₙ Q S(fₙ)` with `Q = 1/(2ζ)` and `S` per Hz; per rad/s,
/// `π ωₙ S/(4ζ)`. J. W. Miles, *J. Aeronautical Sciences* 21 (1954).
#[inline]
pub fn miles<R: crate::Real>(density: R, natural: R, ratio: R) -> R {
    density * std::f64::consts::PI * natural / (ratio * 4.0)
}
