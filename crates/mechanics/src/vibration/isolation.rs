//! Isolation of a machine from its floor, or of an instrument from its base: what stiffness a wanted isolation
//! asks for, and where in a band of speeds it is worst.
//!
//! `r = ω/ω_n`, `ζ` the damping ratio; transmissibility as in [`crate::sdof::transmissibility`].

use crate::{Real, sdof};
use dalembert_numerics::polynomial;

/// Frequency ratio of the largest transmissibility: `r_p = √(2/(1 + √(1 + 8ζ²)))`, which is
/// `√((√(1 + 8ζ²) − 1)/(4ζ²))` without its difference. Rao, *Mechanical Vibrations*, 5th ed., §3.6.
#[inline]
pub fn transmissibility_peak_ratio<S: Real>(damping_ratio: S) -> S {
    (S::from(2.0) / ((damping_ratio.powi(2) * 8.0 + 1.0).sqrt() + 1.0)).sqrt()
}

/// Frequency ratio from which an undamped mount has a transmissibility `T` or less: `r = √(1 + 1/T)`.
/// Rao, 5th ed., §9.10.
#[inline]
pub fn isolating_ratio_undamped<S: Real>(transmissibility: S) -> S {
    (S::from(1.0) + S::from(1.0) / transmissibility).sqrt()
}

/// Half the sum of the roots of `u² − 2bu − (1/T² − 1) = 0` in `u = r²`: `b = 1 − 2ζ² + 2ζ²/T²`, the equation of
/// the frequency ratios at which the transmissibility is `T`.
#[inline]
pub fn isolating_sum<S: Real>(transmissibility: S, damping_ratio: S) -> S {
    S::from(1.0) - damping_ratio.powi(2) * 2.0 + damping_ratio.powi(2) * 2.0 / transmissibility.powi(2)
}

/// Frequency ratio from which a damped mount has a transmissibility `T < 1` or less, from [`isolating_sum`]:
/// `r = √(b + √(b² + 1/T² − 1))`.
#[inline]
pub fn isolating_ratio<S: Real>(transmissibility: S, sum: S) -> S {
    (sum + (sum.powi(2) + S::from(1.0) / transmissibility.powi(2) - 1.0).sqrt()).sqrt()
}

/// Excitation of a machine on its mounts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shaking {
    /// A force of the same amplitude at every speed.
    Force,
    /// An unbalance: a force that grows with the square of the speed.
    Unbalance,
}

/// Frequency ratio in `[lowest, highest]` at which the transmitted force is largest. `None` where it is unbounded:
/// without damping, with the natural frequency inside; or where the numbers leave the finite range.
pub fn worst_transmission(shaking: Shaking, damping_ratio: f64, [lowest, highest]: [f64; 2]) -> Option<f64> {
    let force = |r: f64| {
        let strength = match shaking {
            Shaking::Force => 1.0,
            Shaking::Unbalance => (r / highest).powi(2),
        };
        strength * sdof::transmissibility(r, damping_ratio)
    };
    let inner = match shaking {
        Shaking::Force => vec![transmissibility_peak_ratio(damping_ratio)],
        Shaking::Unbalance => {
            // The slope of u²(1 + au)/((1 − u)² + au) with u = r², a = 4ζ².
            let a = 4.0 * damping_ratio * damping_ratio;
            let slope = [a, 2.0 * a * (a - 2.0), 4.0 * a - 2.0, 2.0];
            let roots = polynomial::roots(&slope).unwrap_or_default();
            roots.iter().filter(|u| u.re > 0.0 && u.im == 0.0).map(|u| u.re.sqrt()).collect()
        }
    };
    worst(force, &inner, [lowest, highest], damping_ratio)
}

/// Frequency ratio in `[lowest, highest]` at which the machine itself moves most. `None` as in
/// [`worst_transmission`].
pub fn worst_motion(shaking: Shaking, damping_ratio: f64, [lowest, highest]: [f64; 2]) -> Option<f64> {
    let square = 1.0 - 2.0 * damping_ratio * damping_ratio;
    let inner = match shaking {
        _ if square <= 0.0 => vec![],
        Shaking::Force => vec![square.sqrt()],
        Shaking::Unbalance => vec![1.0 / square.sqrt()],
    };
    let motion = |r: f64| match shaking {
        Shaking::Force => sdof::magnification(r, damping_ratio),
        Shaking::Unbalance => sdof::unbalance_magnification(r, damping_ratio),
    };
    worst(motion, &inner, [lowest, highest], damping_ratio)
}

fn worst(
    of: impl Fn(f64) -> f64,
    inner: &[f64],
    [lowest, highest]: [f64; 2],
    damping_ratio: f64,
) -> Option<f64> {
    let near_one = 1e-10;
    if damping_ratio == 0.0 && lowest <= 1.0 + near_one && highest >= 1.0 - near_one {
        return None;
    }
    let candidates = inner.iter().copied().filter(|r| *r > lowest && *r < highest).chain([lowest, highest]);
    let worst = candidates.max_by(|p, q| of(*p).total_cmp(&of(*q)))?;
    of(worst).is_finite().then_some(worst)
}
