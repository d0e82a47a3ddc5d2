//! A viscously damped oscillator and its free motion in each regime of damping: what transients and random vibration
//! share.

use dalembert_core::{Refusal, Worksheet};
use dalembert_mechanics::{Real, sdof, vibration::transient::closed};

use crate::{
    shared::oscillator::{DampingGiven, ElasticityGiven, Loss, MassAndStiffness, Suspension, suspension},
    sources::RAO,
};

/// A viscously damped oscillator.
#[derive(Clone, Copy)]
pub(crate) struct DampedOscillator<N> {
    /// Natural frequency without damping.
    pub(crate) natural: N,
    /// Damping ratio.
    pub(crate) ratio: N,
    /// Mass and stiffness, where the mass is known.
    pub(crate) body: Option<MassAndStiffness<N>>,
}

/// Writes the numbers of an oscillator.
///
/// # Errors
/// Those of [`suspension`]; a loss factor, which says nothing of a motion that is not harmonic.
pub(crate) fn system<W: Worksheet>(
    mass: Option<W::Num>,
    elasticity: &ElasticityGiven<W>,
    damping: &DampingGiven<W>,
    sheet: W,
) -> Result<DampedOscillator<W::Num>, Refusal> {
    let Suspension { natural, loss, body, .. } = suspension(mass, elasticity, damping, sheet)?;
    match loss {
        Loss::Viscous(ratio, _) => Ok(DampedOscillator { natural, ratio, body }),
        Loss::Hysteretic(_) => Err(Refusal::because(
            "a loss factor describes steady-state vibration at one frequency, not a transient or random motion: give the damping ratio, which for light damping is half the loss factor",
        )),
    }
}

/// Parameters of the closed forms of the free motion.
#[derive(Clone, Copy)]
pub(crate) struct WorkedFreeMotion<N> {
    natural: N,
    ratio: N,
    regime: Regime<N>,
}

/// Damping regime of the free motion.
#[derive(Clone, Copy)]
enum Regime<N> {
    Undamped,
    Under { damped: N },
    Critical,
    Over { slow: N, fast: N },
}

impl<N: Real> WorkedFreeMotion<N> {
    /// Writes the damped frequency, or the rates of decay.
    pub(crate) fn new<W: Worksheet<Num = N>>(system: &DampedOscillator<N>, sheet: W) -> Self {
        let (natural, ratio) = (system.natural, system.ratio);
        let regime = match ratio.value() {
            0.0 => Regime::Undamped,
            1.0 => Regime::Critical,
            below if below < 1.0 => {
                let why = ("Frequency of the damped motion", RAO.at("§2.6"));
                Regime::Under {
                    damped: sheet.step("ω_d", "rad/s", sdof::damped_frequency(natural, ratio), why),
                }
            }
            _ => {
                let why = ("Slower rate of decay of the overdamped motion", RAO.at("§2.6"));
                let slow = sheet.step("s₁", "1/s", closed::slow_rate(natural, ratio), why);
                let why = ("Faster decay rate", RAO.at("§2.6"));
                let fast = sheet.step("s₂", "1/s", closed::fast_rate(natural, ratio), why);
                Regime::Over { slow, fast }
            }
        };
        Self { natural, ratio, regime }
    }

    /// Returns true if there is no damping.
    pub(crate) fn is_undamped(&self) -> bool {
        matches!(self.regime, Regime::Undamped)
    }

    /// The motion some time after release from a unit displacement.
    pub(crate) fn release(&self, time: N) -> N {
        let Self { natural, ratio, regime } = *self;
        match regime {
            Regime::Undamped => closed::release_undamped(natural, time),
            Regime::Under { damped } => closed::release_underdamped(natural, ratio, damped, time),
            Regime::Critical => closed::release_critical(natural, time),
            Regime::Over { slow, fast } => closed::release_overdamped(slow, fast, time),
        }
    }

    /// The motion some time after a unit velocity, in seconds.
    pub(crate) fn impulse(&self, time: N) -> N {
        let Self { natural, ratio, regime } = *self;
        match regime {
            Regime::Undamped => closed::impulse_undamped(natural, time),
            Regime::Under { damped } => closed::impulse_underdamped(natural, ratio, damped, time),
            Regime::Critical => closed::impulse_critical(natural, time),
            Regime::Over { slow, fast } => closed::impulse_overdamped(slow, fast, time),
        }
    }
}
