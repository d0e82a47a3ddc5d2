//! Responses to unit loads, with time counted in radians of the undamped motion: `θ = ωₙτ`.

/// Responses of `x″ + 2ζx′ + x = q` from rest to unit loads, continuous through `ζ = 1`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct UnitResponses {
    /// After release from a unit displacement.
    pub release: f64,
    /// After a unit velocity (an impulse).
    pub impulse: f64,
    /// Rate of the response to the impulse.
    pub impulse_rate: f64,
    /// Under a unit step.
    pub step: f64,
    /// Under a ramp of unit slope.
    pub ramp: f64,
}

/// Below this product of time and fastest rate a power series replaces the closed forms, which would cancel.
const SHORT: f64 = 0.5;

impl UnitResponses {
    /// The responses at `θ = ωₙτ ≥ 0` for a damping ratio, zero or more.
    pub fn at(ratio: f64, theta: f64) -> Self {
        if theta * f64::max(1.0, 2.0 * ratio) < SHORT {
            return Self::short(ratio, theta);
        }
        let (even, impulse) = if ratio < 1.0 {
            let damped = ((1.0 - ratio) * (1.0 + ratio)).sqrt();
            let decay = (-ratio * theta).exp();
            let (sin, cos) = (damped * theta).sin_cos();
            (decay * cos, decay * sin / damped)
        } else {
            let spread = ((ratio - 1.0) * (ratio + 1.0)).sqrt();
            let decay = (-theta / (ratio + spread)).exp();
            let fast = -2.0 * spread * theta;
            let impulse = if fast == 0.0 { theta } else { -fast.exp_m1() / (2.0 * spread) };
            (decay * (1.0 + fast.exp()) / 2.0, decay * impulse)
        };
        let release = even + ratio * impulse;
        let impulse_rate = even - ratio * impulse;
        let step = 1.0 - release;
        Self { release, impulse, impulse_rate, step, ramp: theta - 2.0 * ratio * step - impulse }
    }

    /// Rate of the response to the release.
    pub fn release_rate(&self) -> f64 {
        -self.impulse
    }

    /// The ramp as a power series `Σ cₙθⁿ/n!`, from which the others follow by taking rates.
    fn short(ratio: f64, theta: f64) -> Self {
        let mut sums = [0.0; 4];
        // The power θⁿ⁻³/(n−3)! and its three successors.
        let mut power = 1.0;
        let (mut before, mut now) = (0.0, 1.0);
        for n in 3..26 {
            let n = f64::from(n);
            let mut term = now * power;
            sums[0] += term;
            for (sum, m) in sums[1..].iter_mut().zip([n - 2.0, n - 1.0, n]) {
                term *= theta / m;
                *sum += term;
            }
            power *= theta / (n - 2.0);
            (before, now) = (now, -2.0 * ratio * now - before);
        }
        let [impulse_rate, impulse, step, ramp] = sums;
        Self { release: 1.0 - step, impulse, impulse_rate, step, ramp }
    }
}
