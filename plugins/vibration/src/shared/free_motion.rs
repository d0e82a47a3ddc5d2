//! A viscously damped oscillator and its free motion in each regime of damping: what transients and random vibration
//! share.

use dalembert_core::{Refusal, Worksheet};
use dalembert_mechanics::{Real, sdof, vibration::transient::closed};

use crate::{
    shared::{
        decay::damped_frequency_error,
        oscillator::{
            ElasticityGiven, Loss, MassAndStiffness, Suspension, ViscousDampingGiven,
            motion::OscillatorMotion,
            parts::{BodyDampingGiven, BodySpringsGiven, OscillatingBodyGiven, suspension_of_body},
            suspension,
        },
    },
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
    /// Translation or rotation.
    pub(crate) motion: OscillatorMotion,
}

/// Writes the numbers of an oscillator.
///
/// # Errors
/// Those of [`suspension`].
pub(crate) fn system<W: Worksheet>(
    mass: Option<W::Num>,
    elasticity: &ElasticityGiven<W>,
    damping: &ViscousDampingGiven<W>,
    sheet: W,
) -> Result<DampedOscillator<W::Num>, Refusal> {
    viscous(suspension(mass, elasticity, &damping.given(), sheet)?)
}

/// The same of a translation or of a rotation.
///
/// # Errors
/// Those of [`suspension_of_body`]; a loss factor.
pub(crate) fn system_of_body<W: Worksheet>(
    motion: OscillatorMotion,
    body: Option<&OscillatingBodyGiven<W>>,
    springs: &BodySpringsGiven<W>,
    damping: &BodyDampingGiven<W>,
    sheet: W,
) -> Result<DampedOscillator<W::Num>, Refusal> {
    viscous(suspension_of_body(motion, body, springs, damping, sheet)?)
}

fn viscous<N>(suspension: Suspension<N>) -> Result<DampedOscillator<N>, Refusal> {
    let Suspension { natural, loss, body, motion } = suspension;
    match loss {
        Loss::Viscous(ratio, _) => Ok(DampedOscillator { natural, ratio, body, motion }),
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
                damped_frequency_error("ω_d", natural, ratio, sheet);
                let why = ("Frequency of the damped motion", RAO.at("§2.6"));
                Regime::Under {
                    damped: sheet.step("ω_d", "rad/s", sdof::damped_frequency(natural, ratio), why),
                }
            }
            _ => {
                let why = ("Slower rate of decay of the overdamped motion", RAO.at("§2.6"));
                let what = "the rate of decay ζωₙ of an underdamped motion used";
                sheet.common_error("s₁", what, || ratio * natural);
                let slow = sheet.step("s₁", "1/s", closed::slow_rate(natural, ratio), why);
                let why = ("Faster decay rate", RAO.at("§2.6"));
                sheet.common_error("s₂", what, || ratio * natural);
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
