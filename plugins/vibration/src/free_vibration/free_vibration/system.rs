//! The vibrating system of a free vibration: body, springs, damping and start.

use std::f64::consts::PI;

use dalembert_core::{Inputs, Refusal, Worksheet};
use dalembert_mechanics::{Real, sdof};

use super::{
    damping::{coefficient_of, critical_damping, ratio_of},
    form::Units,
};
use crate::{
    shared::{
        decay::{Decay, decrement},
        inertia::{Inertia, TranslatingBody, moment_of_inertia},
        oscillator::{SpringData, parts::TorsionalElasticity},
    },
    sources::RAO,
};

/// Vibrating system.
#[derive(Clone, Debug, Inputs)]
pub enum Oscillator {
    /// Mass, spring and damper
    Translation {
        /// Mass or weight.
        mass: TranslatingBody,
        /// Springs.
        stiffness: SpringData,
        /// Damping.
        damping: TranslationalDamping,
        /// Initial displacement.
        #[input("x₀", "m", default = "0 mm")]
        displacement: f64,
        /// Initial velocity.
        #[input("v₀", "m/s", default = "0 m/s")]
        velocity: f64,
    },
    /// Inertia, torsion spring and damper
    Rotation {
        /// Moment of inertia.
        inertia: Inertia,
        /// Torsional springs.
        stiffness: TorsionalElasticity,
        /// Damping.
        damping: TorsionalDamping,
        /// Initial angle.
        #[input("θ₀", "rad", default = "0 deg")]
        angle: f64,
        /// Angular velocity at the start.
        #[input("Ω₀", "rad/s", default = "0 rad/s")]
        rate: f64,
    },
    /// Natural frequency and damping ratio given
    Ratios {
        /// Natural frequency without damping.
        #[input("ωₙ", "rad/s", positive)]
        natural_frequency: f64,
        /// Damping ratio.
        /// Zero for no damping; a negative one feeds energy into the motion.
        #[input("ζ", "1")]
        ratio: f64,
        /// Initial displacement.
        #[input("x₀", "m", default = "0 mm")]
        displacement: f64,
        /// Initial velocity.
        #[input("v₀", "m/s", default = "0 m/s")]
        velocity: f64,
    },
}

/// Damping of a mass on a spring.
#[derive(Clone, Debug, Inputs)]
pub enum TranslationalDamping {
    /// Without a coefficient
    #[input(flatten)]
    Any(DampingData),
    /// Damping coefficient given
    Coefficient {
        /// Damping coefficient.
        /// A negative one feeds energy into the motion.
        #[input("c", "N*s/m")]
        coefficient: f64,
    },
}

/// Damping of an inertia on a torsion spring.
#[derive(Clone, Debug, Inputs)]
pub enum TorsionalDamping {
    /// Without a coefficient
    #[input(flatten)]
    Any(DampingData),
    /// Damping coefficient given
    Coefficient {
        /// Torsional damping coefficient.
        /// A negative one feeds energy into the motion.
        #[input("cₜ", "N*m*s/rad")]
        coefficient: f64,
    },
}

/// Damping of any motion, by what it does to it.
#[derive(Clone, Debug, Inputs)]
pub enum DampingData {
    /// Damping ratio given
    Ratio {
        /// Damping ratio.
        /// Zero for no damping; a negative one feeds energy into the motion.
        #[input("ζ", "1")]
        ratio: f64,
    },
    /// Critical
    Critical,
    /// From the overshoot after release from rest
    Overshoot {
        /// Overshoot.
        /// First displacement to the opposite side, as a fraction of the release displacement.
        #[input("s", "%", positive, below = 100)]
        overshoot: f64,
    },
    /// From the settling time of the envelope
    Settling {
        /// Time for the envelope to decay to the settling band.
        #[input("tₛ", "s", positive)]
        time: f64,
    },
    /// From a free decay
    Decay {
        /// Amplitudes.
        amplitudes: Decay,
    },
}

/// The oscillator by its ratios, and its mass and stiffness where they are known.
pub(super) struct FreeOscillator<N> {
    pub(super) natural: N,
    pub(super) zeta: N,
    pub(super) x0: N,
    pub(super) v0: N,
    pub(super) elastic: Option<(N, N)>,
    pub(super) units: Units,
}

/// Writes the oscillator; `settled` is the fraction of the maximum that counts as settled.
///
/// # Errors
/// A body or a spring that is none; a static deflection of a body that rolls.
pub(super) fn system<W: Worksheet>(
    given: &OscillatorGiven<W>,
    settled: W::Num,
    sheet: W,
) -> Result<FreeOscillator<W::Num>, Refusal> {
    let (natural, zeta, start, elastic, units) = match given {
        OscillatorGiven::Translation { mass, stiffness, damping, displacement, velocity } => {
            let [mass, natural, stiffness] = mass.on_springs(stiffness, sheet)?;
            let damping = match damping {
                TranslationalDampingGiven::Any(data) => KnownDamping::Data(data),
                TranslationalDampingGiven::Coefficient { coefficient } => {
                    KnownDamping::Coefficient(*coefficient)
                }
            };
            let body = (mass, stiffness);
            let zeta = damping_ratio(body, natural, &damping, (settled, Units::TRANSLATION), sheet);
            (natural, zeta, [*displacement, *velocity], Some(body), Units::TRANSLATION)
        }
        OscillatorGiven::Rotation { inertia, stiffness, damping, angle, rate } => {
            let inertia = moment_of_inertia(inertia, sheet, "J".into());
            let [natural, stiffness] = stiffness.frequency_and_stiffness(inertia, sheet)?;
            let damping = match damping {
                TorsionalDampingGiven::Any(data) => KnownDamping::Data(data),
                TorsionalDampingGiven::Coefficient { coefficient } => KnownDamping::Coefficient(*coefficient),
            };
            let body = (inertia, stiffness);
            let zeta = damping_ratio(body, natural, &damping, (settled, Units::ROTATION), sheet);
            (natural, zeta, [*angle, *rate], Some(body), Units::ROTATION)
        }
        OscillatorGiven::Ratios { natural_frequency, ratio, displacement, velocity } => {
            (*natural_frequency, *ratio, [*displacement, *velocity], None, Units::TRANSLATION)
        }
    };
    if let Some((mass, stiffness)) = elastic {
        let is_rotation = units == Units::ROTATION;
        let (name, label) =
            if is_rotation { ("inertia", "Moment of inertia") } else { ("mass", "Moving mass") };
        sheet.answer(name, label, mass);
        sheet.answer("stiffness", if is_rotation { "Torsional stiffness" } else { "Stiffness" }, stiffness);
        let what = "at the natural frequency stiffness and inertia have one impedance, k/ωₙ = mωₙ";
        sheet.check(what, stiffness / natural, natural * mass);
    }
    let [x0, v0] = start;
    Ok(FreeOscillator { natural, zeta, x0, v0, elastic, units })
}

/// Damping of a translation or of a rotation.
enum KnownDamping<'d, W: Worksheet> {
    Data(&'d DampingDataGiven<W>),
    Coefficient(W::Num),
}

/// The damping ratio of a body on its spring, and its coefficient as an answer.
fn damping_ratio<W: Worksheet>(
    (mass, stiffness): (W::Num, W::Num),
    natural: W::Num,
    damping: &KnownDamping<'_, W>,
    (settled, units): (W::Num, Units),
    sheet: W,
) -> W::Num {
    let critical = critical_damping(stiffness, mass, units, sheet);
    let one = W::Num::from(1.0);
    let data = match damping {
        KnownDamping::Data(data) => data,
        KnownDamping::Coefficient(coefficient) => {
            let zeta = ratio_of(*coefficient, critical, stiffness, mass, sheet);
            sheet.answer("damping", "Damping coefficient", *coefficient);
            return zeta;
        }
    };
    let zeta = match data {
        DampingDataGiven::Ratio { ratio } => *ratio,
        DampingDataGiven::Critical {} => sheet.step("ζ", "1", one, "The damping is critical"),
        DampingDataGiven::Overshoot { overshoot } => {
            let decimal = || (one / *overshoot).log10();
            sheet.common_error("Λ", "the logarithm to base 10 used in place of the natural one", decimal);
            let log = sheet.step(
                "Λ",
                "1",
                (one / *overshoot).ln(),
                "Half a cycle reduces the amplitude from 1 to the overshoot: half the logarithmic decrement",
            );
            let whole = || sdof::damping_ratio_from_decrement(log);
            sheet.common_error("ζ", "the overshoot taken as the amplitude after a whole cycle", whole);
            let light = || log / PI;
            sheet.common_error(
                "ζ",
                "the logarithm of the overshoot divided by π, as for light damping",
                light,
            );
            let why = ("Damping ratio from that decrement", RAO.at("§2.6.3"));
            sheet.step("ζ", "1", sdof::damping_ratio_from_decrement(log * 2.0), why)
        }
        DampingDataGiven::Settling { time } => {
            let rule = || W::Num::from(4.0) / (natural * *time);
            sheet.common_error("ζ", "the rule of thumb for the settling time used, 4/(ζωₙ)", rule);
            let decimal = || (one / settled).log10() / (natural * *time);
            sheet.common_error("ζ", "the logarithm to base 10 used in place of the natural one", decimal);
            let why = "The envelope e^(−ζωₙt) has decayed to the settling band";
            sheet.step("ζ", "1", (one / settled).ln() / (natural * *time), why)
        }
        DampingDataGiven::Decay { amplitudes } => decrement(amplitudes, sheet).damping_ratio,
    };
    coefficient_of(zeta, critical, units, sheet);
    zeta
}
