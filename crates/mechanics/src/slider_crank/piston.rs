//! The motion of a piston as books on engines write it.
//!
//! The crank turns through `θ` from the position in which it points along the stroke at the piston; the rod makes
//! the obliquity `φ = −θ₃` with the stroke, and `n = l/r`. Displacement `s` (from the dead centre away from the
//! crank), velocity and acceleration of the piston are positive towards the crank, so that the piston sets out
//! with a positive acceleration. Lengths in m, angles in rad. Bevan, *The Theory of Machines*, ch. 4 and 12.

use crate::Real;

/// Obliquity of the rod of an in-line engine, `φ = arcsin(sin θ/n)`.
#[inline]
pub fn obliquity<S: Real>(ratio: S, angle: S) -> S {
    (angle.sin() / ratio).asin()
}

/// Obliquity of the rod where the line of stroke passes the crankshaft at the height `e`,
/// `φ = arcsin((r sin θ − e)/l)`.
#[inline]
pub fn obliquity_with_offset<S: Real>(crank: S, rod: S, offset: S, angle: S) -> S {
    ((crank * angle.sin() - offset) / rod).asin()
}

/// Displacement of the piston of an in-line engine, `s = r[(1 − cos θ) + n(1 − cos φ)]`, m, with
/// `1 − cos x = 2 sin²(x/2)`, which keeps its digits near the dead centre.
#[inline]
pub fn displacement<S: Real>(crank: S, ratio: S, angle: S, obliquity: S) -> S {
    crank * 2.0 * ((angle / 2.0).sin().powi(2) + ratio * (obliquity / 2.0).sin().powi(2))
}

/// Distance of the piston from the crankshaft along the stroke, `x = r cos θ + l cos φ`, m.
#[inline]
pub fn position<S: Real>(crank: S, rod: S, angle: S, obliquity: S) -> S {
    crank * angle.cos() + rod * obliquity.cos()
}

/// Largest distance of the piston from the crankshaft along the stroke, `x₀ = √((r + l)² − e²)`, m.
#[inline]
pub fn farthest<S: Real>(crank: S, rod: S, offset: S) -> S {
    ((crank + rod).powi(2) - offset.powi(2)).sqrt()
}

/// Smallest distance of the piston from the crankshaft along the stroke, `x₁ = √((l − r)² − e²)`, m.
#[inline]
pub fn nearest<S: Real>(crank: S, rod: S, offset: S) -> S {
    ((rod - crank).powi(2) - offset.powi(2)).sqrt()
}

/// Way of the piston for the angle of the crank, `h = ds/dθ = r sin(θ + φ)/cos φ`, m: the arm of a force along the
/// stroke about the crankshaft.
#[inline]
pub fn arm<S: Real>(crank: S, angle: S, obliquity: S) -> S {
    crank * (angle + obliquity).sin() / obliquity.cos()
}

/// Turn of the rod for that of the crank, `φ′ = dφ/dθ = r cos θ/(l cos φ)`.
#[inline]
pub fn turn<S: Real>(crank: S, rod: S, angle: S, obliquity: S) -> S {
    crank * angle.cos() / (rod * obliquity.cos())
}

/// Angular acceleration of the rod, `φ̈ = (l ω_r² sin φ − r ω² sin θ + r α cos θ)/(l cos φ)`, rad/s², at the speed
/// `ω_r = φ′ω`; `α` is left out for a steady speed.
#[inline]
pub fn rod_acceleration<S: Real>(
    [crank, rod]: [S; 2],
    [angle, obliquity]: [S; 2],
    [speed, rod_speed]: [S; 2],
    acceleration: Option<S>,
) -> S {
    let steady = rod * rod_speed.powi(2) * obliquity.sin() - crank * speed.powi(2) * angle.sin();
    let all = match acceleration {
        Some(alpha) => steady + crank * alpha * angle.cos(),
        None => steady,
    };
    all / (rod * obliquity.cos())
}

/// Acceleration of the piston, `a = r ω² cos θ + l ω_r² cos φ + l φ̈ sin φ + r α sin θ`, m/s²; `α` is left out for a
/// steady speed.
#[inline]
pub fn acceleration<S: Real>(
    [crank, rod]: [S; 2],
    [angle, obliquity]: [S; 2],
    [speed, rod_speed]: [S; 2],
    rod_acceleration: S,
    acceleration: Option<S>,
) -> S {
    let steady = crank * speed.powi(2) * angle.cos()
        + rod * rod_speed.powi(2) * obliquity.cos()
        + rod * rod_acceleration * obliquity.sin();
    match acceleration {
        Some(alpha) => steady + crank * alpha * angle.sin(),
        None => steady,
    }
}

/// The motion with two terms: the rod's shortening `l(1 − cos φ)` taken as `r sin²θ/(2n)`. In line.
pub mod two_term {
    use crate::Real;

    /// Displacement of the piston, `s = r[(1 − cos θ) + sin²θ/(2n)]`, m, with `1 − cos θ = 2 sin²(θ/2)`.
    #[inline]
    pub fn displacement<S: Real>(crank: S, ratio: S, angle: S) -> S {
        crank * ((angle / 2.0).sin().powi(2) * 2.0 + angle.sin().powi(2) / (ratio * 2.0))
    }

    /// Velocity of the piston, `v = r ω [sin θ + sin 2θ/(2n)]`, m/s.
    #[inline]
    pub fn velocity<S: Real>(crank: S, ratio: S, angle: S, speed: S) -> S {
        crank * speed * (angle.sin() + (angle * 2.0).sin() / (ratio * 2.0))
    }

    /// Acceleration of the piston, `a = r ω² [cos θ + cos 2θ/n] + r α [sin θ + sin 2θ/(2n)]`, m/s².
    #[inline]
    pub fn acceleration<S: Real>(crank: S, ratio: S, angle: S, speed: S, acceleration: Option<S>) -> S {
        let steady = crank * speed.powi(2) * (angle.cos() + (angle * 2.0).cos() / ratio);
        match acceleration {
            Some(alpha) => steady + crank * alpha * (angle.sin() + (angle * 2.0).sin() / (ratio * 2.0)),
            None => steady,
        }
    }

    /// Angular velocity of the rod, `ω_r = ω cos θ/n`, rad/s.
    #[inline]
    pub fn rod_speed<S: Real>(ratio: S, angle: S, speed: S) -> S {
        speed * angle.cos() / ratio
    }

    /// Angular acceleration of the rod, `φ̈ = (α cos θ − ω² sin θ)/n`, rad/s².
    #[inline]
    pub fn rod_acceleration<S: Real>(ratio: S, angle: S, speed: S, acceleration: Option<S>) -> S {
        match acceleration {
            Some(alpha) => (alpha * angle.cos() - speed.powi(2) * angle.sin()) / ratio,
            None => -(speed.powi(2) * angle.sin()) / ratio,
        }
    }

    /// Crank angle at which the acceleration is zero at a steady speed, the root below 180° of
    /// `2 cos²θ + n cos θ − 1 = 0`, rad.
    #[inline]
    pub fn zero_acceleration<S: Real>(ratio: S) -> S {
        (((ratio.powi(2) + 8.0).sqrt() - ratio) / 4.0).acos()
    }
}

/// The motion by its harmonics, in line: `a = r ω² Σ Aₖ cos kθ` with `A₁ = 1` and even orders after it.
///
/// The amplitudes of the even orders come from [`harmonic_by_series`](crate::balance::reciprocating::harmonic_by_series).
pub mod harmonics {
    use crate::Real;

    /// Displacement of the piston, `s = r[(1 − cos θ) + Σ Aₖ (1 − cos kθ)/k²]`, m, with `1 − cos x = 2 sin²(x/2)`;
    /// amplitudes of the orders 2, 4, ….
    #[inline]
    pub fn displacement<S: Real>(crank: S, amplitudes: &[S], angle: S) -> S {
        let first = (angle / 2.0).sin().powi(2);
        let higher =
            amplitudes.iter().zip(orders()).map(|(a, k)| *a * (angle * (k / 2.0)).sin().powi(2) / (k * k));
        crank * 2.0 * S::sum(std::iter::once(first).chain(higher))
    }

    /// Velocity of the piston, `v = r ω [sin θ + Σ Aₖ sin kθ/k]`, m/s.
    #[inline]
    pub fn velocity<S: Real>(crank: S, amplitudes: &[S], angle: S, speed: S) -> S {
        crank * speed * slope(amplitudes, angle)
    }

    /// Acceleration of the piston, `a = r ω² [cos θ + Σ Aₖ cos kθ] + r α [sin θ + Σ Aₖ sin kθ/k]`, m/s².
    #[inline]
    pub fn acceleration<S: Real>(
        crank: S,
        amplitudes: &[S],
        angle: S,
        speed: S,
        acceleration: Option<S>,
    ) -> S {
        let higher = amplitudes.iter().zip(orders()).map(|(a, k)| *a * (angle * k).cos());
        let steady = crank * speed.powi(2) * S::sum(std::iter::once(angle.cos()).chain(higher));
        match acceleration {
            Some(alpha) => steady + crank * alpha * slope(amplitudes, angle),
            None => steady,
        }
    }

    fn slope<S: Real>(amplitudes: &[S], angle: S) -> S {
        let higher = amplitudes.iter().zip(orders()).map(|(a, k)| *a * (angle * k).sin() / k);
        S::sum(std::iter::once(angle.sin()).chain(higher))
    }

    fn orders() -> impl Iterator<Item = f64> {
        (1..).map(|half: u32| 2.0 * f64::from(half))
    }
}
