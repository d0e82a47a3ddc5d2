//! Absorbers: a second mass on a spring, on a spring and a damper, or in a viscous fluid alone, that takes the
//! vibration of a main system.
//!
//! `μ` is the mass of the absorber over the main mass, `f = ω_a/ω_m` the tuning: natural frequency of the absorber
//! over that of the main system, each by itself; `g = ω/ω_m`. In torsion, moments of inertia stand for masses.
//! Damping of an absorber is written in two ways: `ζ_a = c/(2 m_a ω_a)`, by its own natural frequency, and
//! `γ = c/(2 m_a ω_m) = f ζ_a`, by that of the main system.

mod minimax;

pub use self::minimax::{AbsorberError, LeastPeak, least_peak, least_peak_viscous};
use crate::Real;
use dalembert_numerics::polynomial;

/// Sum of the two resonant ratios `g₁ + g₂ = √((1 + f)² + μf²)`: with `g₁g₂ = f`, from the frequency equation
/// `g⁴ − (1 + (1 + μ)f²)g² + f² = 0`. Rao, *Mechanical Vibrations*, 5th ed., §9.11.
#[inline]
pub fn resonance_sum<S: Real>(tuning: S, mass_ratio: S) -> S {
    ((tuning + 1.0).powi(2) + mass_ratio * tuning.powi(2)).sqrt()
}

/// Difference of the two resonant ratios `g₂ − g₁ = √((1 − f)² + μf²)`, as [`resonance_sum`].
#[inline]
pub fn resonance_difference<S: Real>(tuning: S, mass_ratio: S) -> S {
    ((S::from(1.0) - tuning).powi(2) + mass_ratio * tuning.powi(2)).sqrt()
}

/// Mass ratio that puts a resonance at `p` times the frequency of the absorber: `μ = (1 − p²)(1/(pf)² − 1)`, the
/// frequency equation solved for μ; with `f = 1` it is `(p − 1/p)²`. Negative where no absorber does.
#[inline]
pub fn mass_ratio_of_resonance<S: Real>(p: S, tuning: S) -> S {
    (S::from(1.0) - p.powi(2)) * (S::from(1.0) / (p * tuning).powi(2) - 1.0)
}

/// Mass ratio that puts a resonance at `p` times the frequency of an absorber tuned to the main system:
/// `μ = (p − 1/p)²`.
#[inline]
pub fn mass_ratio_when_tuned<S: Real>(p: S) -> S {
    (p - S::from(1.0) / p).powi(2)
}

/// Mass ratio behind two resonances at `p₁` and `p₂` times the frequency of the absorber:
/// `μ = (1 − p₁²)(p₂² − 1)`, the two frequency equations with `p₁p₂ = 1/f`.
#[inline]
pub fn mass_ratio_of_split<S: Real>(lower: S, upper: S) -> S {
    (S::from(1.0) - lower.powi(2)) * (upper.powi(2) - 1.0)
}

/// Determinant of the dynamic stiffness `(k + k_a − mω²)(k_a − m_aω²) − k_a²`; zero at the two resonances. The main
/// mass moves by `F(k_a − m_aω²)/Δ` and the absorber by `F k_a/Δ`. Rao, 5th ed., §9.11.
#[inline]
pub fn determinant<S: Real>(
    mass: S,
    stiffness: S,
    absorber_mass: S,
    absorber_stiffness: S,
    frequency: S,
) -> S {
    (stiffness + absorber_stiffness - mass * frequency.powi(2))
        * (absorber_stiffness - absorber_mass * frequency.powi(2))
        - absorber_stiffness.powi(2)
}

/// Tuning that raises both fixed points equally: `f = 1/(1 + μ)`. Den Hartog, *Mechanical Vibrations*, 4th ed., §3.3.
#[inline]
pub fn den_hartog_tuning<S: Real>(mass_ratio: S) -> S {
    S::from(1.0) / (mass_ratio + 1.0)
}

/// Damping ratio `ζ_a = c/(2 m_a ω_a) = √(3μ/(8(1 + μ)))` at that tuning: the mean of the squares of the two that
/// make the response level at one fixed point. By the main frequency, `γ = √(3μ/(8(1 + μ)³))`. J. E. Brock, *Journal
/// of Applied Mechanics* 13 (1946), A-284; Den Hartog, 4th ed., §3.3.
#[inline]
pub fn den_hartog_damping<S: Real>(mass_ratio: S) -> S {
    (mass_ratio * 3.0 / ((mass_ratio + 1.0) * 8.0)).sqrt()
}

/// Magnification at both fixed points at that tuning: `√(1 + 2/μ)`. Den Hartog, 4th ed., §3.3.
#[inline]
pub fn fixed_point_height<S: Real>(mass_ratio: S) -> S {
    (S::from(2.0) / mass_ratio + 1.0).sqrt()
}

/// Mean of the squares of the ratios of the two fixed points of any tuning: `(1 + (1 + μ)f²)/(2 + μ)`.
/// Den Hartog, 4th ed., §3.3.
#[inline]
pub fn fixed_points_mean<S: Real>(mass_ratio: S, tuning: S) -> S {
    ((mass_ratio + 1.0) * tuning.powi(2) + 1.0) / (mass_ratio + 2.0)
}

/// Half the difference of those squares: `√(b² − 2f²/(2 + μ))`, with the mean `b`.
#[inline]
pub fn fixed_points_half_difference<S: Real>(mass_ratio: S, tuning: S, mean: S) -> S {
    (mean.powi(2) - tuning.powi(2) * 2.0 / (mass_ratio + 2.0)).sqrt()
}

/// Magnification at a fixed point, the same for every damping: `1/|1 − (1 + μ)g²|`, that of both masses moving as one.
#[inline]
pub fn magnification_as_one<S: Real>(mass_ratio: S, ratio: S) -> S {
    S::from(1.0) / (S::from(1.0) - (mass_ratio + 1.0) * ratio.powi(2)).abs()
}

/// `γ²` that makes the response of an undamped main system level at its fixed point `u = g²`. `R` is the determinant
/// without damping there.
pub fn level_damping_squared(mass_ratio: f64, tuning: f64, square: f64) -> f64 {
    let (f2, u) = (tuning * tuning, square);
    let sum = 1.0 + (1.0 + mass_ratio) * f2;
    let as_one = 1.0 - (1.0 + mass_ratio) * u;
    let undamped = u * u - sum * u + f2;
    (undamped * (2.0 * u - sum) + (f2 - u) * as_one * as_one) / (4.0 * u * as_one * (1.0 + mass_ratio))
}

/// `s = √(4 + 3μ)`, in which the tuning and damping of least peak are written.
#[inline]
pub fn least_peak_root<S: Real>(mass_ratio: S) -> S {
    (mass_ratio * 3.0 + 4.0).sqrt()
}

/// Tuning of the least peak on an undamped main system, `f = 2/(s − 1) √(6/(3s² + 4s + 4))`, from
/// [`least_peak_root`]. O. Nishihara and T. Asami, *Journal of Vibration and Acoustics* 124 (2002), 576–582, with
/// their common factors taken out.
#[inline]
pub fn least_peak_tuning<S: Real>(root: S) -> S {
    S::from(2.0) / (root - 1.0) * (S::from(6.0) / (root.powi(2) * 3.0 + root * 4.0 + 4.0)).sqrt()
}

/// Damping ratio `ζ_a = c/(2 m_a ω_a)` of the least peak, `¼√(3μ(3s + 2)/((1 + μ)(s + 2)))`. Source as
/// [`least_peak_tuning`].
#[inline]
pub fn least_peak_damping<S: Real>(mass_ratio: S, root: S) -> S {
    (mass_ratio * 3.0 * (root * 3.0 + 2.0) / ((mass_ratio + 1.0) * (root + 2.0))).sqrt() / 4.0
}

/// The least peak of the magnification, `(3s² + 4s + 4)/(3√(μ(s + 2)(3s + 2)))`. Source as [`least_peak_tuning`].
#[inline]
pub fn least_peak_height<S: Real>(mass_ratio: S, root: S) -> S {
    (root.powi(2) * 3.0 + root * 4.0 + 4.0) / ((mass_ratio * (root + 2.0) * (root * 3.0 + 2.0)).sqrt() * 3.0)
}

/// Best damping `γ = c/(2 m_a ω_m) = 1/√(2(1 + μ)(2 + μ))` of an untuned viscous absorber (Houdaille, Lanchester) on
/// an undamped main system. Den Hartog, 4th ed., §3.3.
#[inline]
pub fn viscous_damping<S: Real>(mass_ratio: S) -> S {
    S::from(1.0) / ((mass_ratio + 1.0) * (mass_ratio + 2.0) * 2.0).sqrt()
}

/// Frequency ratio of the fixed point of an untuned viscous absorber, and with the best damping of its peak:
/// `√(2/(2 + μ))`. Den Hartog, 4th ed., §3.3.
#[inline]
pub fn viscous_fixed_point<S: Real>(mass_ratio: S) -> S {
    (S::from(2.0) / (mass_ratio + 2.0)).sqrt()
}

/// Magnification there: `1 + 2/μ`. Den Hartog, 4th ed., §3.3.
#[inline]
pub fn viscous_height<S: Real>(mass_ratio: S) -> S {
    S::from(2.0) / mass_ratio + 1.0
}

/// A main system with a damped absorber, in ratios.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DampedAbsorber {
    /// `μ`.
    pub mass_ratio: f64,
    /// Damping ratio ζ of the main system by itself.
    pub main_damping: f64,
    /// `f`; zero for a viscous absorber without spring.
    pub tuning: f64,
    /// `γ = c/(2 m_a ω_m)`.
    pub damping: f64,
}

/// A largest value of a response, and where it is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Peak {
    /// Frequency ratio `g`.
    pub ratio: f64,
    /// Height.
    pub height: f64,
}

impl DampedAbsorber {
    /// Amplitude of the main mass over its static deflection under the force.
    pub fn magnification(&self, ratio: f64) -> f64 {
        if ratio == 0.0 {
            return 1.0;
        }
        let u = ratio * ratio;
        let above = (self.tuning * self.tuning - u).hypot(2.0 * self.damping * ratio);
        above / self.determinant(ratio)
    }

    /// Amplitude of the absorber relative to the main mass, over the same static deflection.
    pub fn relative_motion(&self, ratio: f64) -> f64 {
        if ratio == 0.0 { 0.0 } else { ratio * ratio / self.determinant(ratio) }
    }

    /// The maxima of [`DampedAbsorber::magnification`] away from rest, by ascending ratio. Empty where the response
    /// only falls, or has no bound.
    pub fn peaks(&self) -> Vec<Peak> {
        let (above, below) = self.polynomials();
        let level = sum(&product(&derivative(&above), &below), &product(&above, &derivative(&below)), -1.0);
        maxima(&level, |ratio| self.magnification(ratio))
    }

    /// The largest peak of the main mass.
    pub fn largest_peak(&self) -> Option<Peak> {
        largest(&self.peaks())
    }

    /// The largest motion of the absorber relative to the main mass over all frequencies.
    pub fn largest_relative_motion(&self) -> Option<Peak> {
        let (_, below) = self.polynomials();
        // u²/D is level where 2D = uD′.
        let shifted: Vec<f64> = derivative(&below).into_iter().chain([0.0]).collect();
        largest(&maxima(&sum(&scaled(&below, 2.0), &shifted, -1.0), |ratio| self.relative_motion(ratio)))
    }

    /// Size of the determinant of the dynamic stiffness, in units of that of both masses at rest.
    fn determinant(&self, ratio: f64) -> f64 {
        let (u, f2) = (ratio * ratio, self.tuning * self.tuning);
        let Self { mass_ratio: mu, main_damping: zeta, damping: gamma, .. } = *self;
        let real = (1.0 - u) * (f2 - u) - 4.0 * zeta * gamma * u - mu * f2 * u;
        let imaginary = 2.0 * ratio * (zeta * (f2 - u) + gamma * (1.0 - (1.0 + mu) * u));
        real.hypot(imaginary)
    }

    /// The square of the magnification as a ratio of polynomials in `u = g²`, highest power first.
    fn polynomials(&self) -> (Vec<f64>, Vec<f64>) {
        let Self { mass_ratio: mu, main_damping: zeta, tuning, damping: gamma } = *self;
        let f2 = tuning * tuning;
        let b = 1.0 + f2 * (1.0 + mu) + 4.0 * zeta * gamma;
        let (a, c) = (zeta * f2 + gamma, zeta + gamma * (1.0 + mu));
        let above = vec![1.0, 4.0 * gamma * gamma - 2.0 * f2, f2 * f2];
        let below = vec![
            1.0,
            4.0 * c * c - 2.0 * b,
            b * b + 2.0 * f2 - 8.0 * a * c,
            4.0 * a * a - 2.0 * b * f2,
            f2 * f2,
        ];
        (above, below)
    }
}

/// The maxima among the points where the response is level: those above both neighbours.
fn maxima(level: &[f64], height: impl Fn(f64) -> f64) -> Vec<Peak> {
    let roots = polynomial::roots(level).unwrap_or_default();
    let real = roots.iter().filter(|u| u.re > 0.0 && u.im.abs() <= 1e-7 * u.re).map(|u| u.re.sqrt());
    let mut points: Vec<Peak> = real.map(|ratio| Peak { ratio, height: height(ratio) }).collect();
    points.insert(0, Peak { ratio: 0.0, height: height(0.0) });
    let end = 1e3 * (1.0 + points[points.len() - 1].ratio);
    points.push(Peak { ratio: end, height: height(end) });
    let tops = points.windows(3).filter(|near| {
        let [before, here, after] = [near[0].height, near[1].height, near[2].height];
        here.is_finite() && here > before && here > after
    });
    tops.map(|near| near[1]).collect()
}

/// The highest peak; of peaks equal to within rounding, as an optimum has them, the first.
fn largest(peaks: &[Peak]) -> Option<Peak> {
    peaks
        .iter()
        .copied()
        .reduce(|best, peak| if peak.height > best.height * (1.0 + 1e-9) { peak } else { best })
}

fn derivative(p: &[f64]) -> Vec<f64> {
    let degree = p.len() - 1;
    p[..degree].iter().enumerate().map(|(n, a)| a * (degree - n) as f64).collect()
}

fn product(p: &[f64], q: &[f64]) -> Vec<f64> {
    let mut all = vec![0.0; p.len() + q.len() - 1];
    for (i, a) in p.iter().enumerate() {
        for (j, b) in q.iter().enumerate() {
            all[i + j] += a * b;
        }
    }
    all
}

fn scaled(p: &[f64], by: f64) -> Vec<f64> {
    p.iter().map(|a| a * by).collect()
}

/// `p + times·q`, of one degree.
fn sum(p: &[f64], q: &[f64], times: f64) -> Vec<f64> {
    p.iter().zip(q).map(|(a, b)| a + times * b).collect()
}
