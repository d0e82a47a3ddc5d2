//! One mass, what carries it and what damps it: the inputs that the steady analyses share.

use dalembert_core::{Inputs, Refusal, Worksheet};
use dalembert_mechanics::{Real, sdof};

pub(crate) mod motion;
pub(crate) mod parts;
pub(crate) mod plots;
pub(crate) mod transient_from_rest;

pub(crate) use crate::shared::inertia::{Mass, MassGiven, given_weight, mass};

use self::motion::OscillatorMotion;
use crate::{
    shared::{
        decay::{Decay, DecayGiven, decrement},
        spring::{Spring, stiffness},
    },
    sources::RAO,
};

/// Stiffness of the springs, or what it follows from without their damping.
#[derive(Clone, Debug, Inputs)]
pub enum SpringData {
    /// Stiffness given
    Stiffness {
        /// Stiffness.
        #[input("k", "N/m", positive)]
        stiffness: f64,
    },
    /// Springs and beams
    Springs {
        /// Springs.
        /// A network: series and parallel groups may be nested.
        springs: Spring,
    },
    /// Static deflection under the weight
    StaticDeflection {
        /// Static deflection.
        #[input("δ_st", "m", positive)]
        deflection: f64,
        /// Gravity.
        #[input("g", "m/s^2", positive, default = "9.81 m/s^2", default_before = "9.80665 m/s^2")]
        gravity: f64,
    },
    /// Natural frequency
    NaturalFrequency {
        /// Natural frequency.
        /// Without damping.
        #[input("ωₙ", "rad/s", positive)]
        frequency: f64,
    },
}

/// Given quantity of the springs.
#[derive(Clone, Debug, Inputs)]
pub enum Elasticity {
    /// Springs alone
    #[input(flatten)]
    Springs(SpringData),
    /// Frequency of the free damped vibration
    DampedFrequency {
        /// Frequency of the free vibration.
        #[input("ω_d", "rad/s", positive)]
        frequency: f64,
    },
}

/// Damping of a viscous damper.
#[derive(Clone, Debug, Inputs)]
pub enum ViscousDamping {
    /// Damping ratio given
    Ratio {
        /// Damping ratio.
        /// Zero for no damping.
        #[input("ζ", "1", nonnegative)]
        ratio: f64,
    },
    /// Damping coefficient given
    Coefficient {
        /// Damping coefficient.
        #[input("c", "N*s/m", nonnegative)]
        coefficient: f64,
    },
    /// From a free decay
    Decay {
        /// Amplitudes.
        amplitudes: Decay,
    },
}

/// Damping mechanism as it is given.
pub(crate) enum GivenDamping<'d, W: Worksheet> {
    /// Damping ratio.
    Ratio(W::Num),
    /// Damping coefficient.
    Coefficient(W::Num),
    /// Loss factor.
    LossFactor(W::Num),
    /// Amplitudes of a free decay.
    Decay(&'d DecayGiven<W>),
}

impl<W: Worksheet> ViscousDampingGiven<W> {
    /// Damping as its given form.
    pub(crate) fn given(&self) -> GivenDamping<'_, W> {
        match self {
            ViscousDampingGiven::Ratio { ratio } => GivenDamping::Ratio(*ratio),
            ViscousDampingGiven::Coefficient { coefficient } => GivenDamping::Coefficient(*coefficient),
            ViscousDampingGiven::Decay { amplitudes } => GivenDamping::Decay(amplitudes),
        }
    }
}

/// Equivalent stiffness and damping of the springs and dampers.
#[derive(Clone, Copy)]
pub(crate) struct Suspension<N> {
    /// Translation or rotation.
    pub(crate) motion: OscillatorMotion,
    /// Natural frequency without damping, rad/s.
    pub(crate) natural: N,
    /// Damping mechanism.
    pub(crate) loss: Loss<N>,
    /// Quantities that depend on the mass; `None` if no mass is given.
    pub(crate) body: Option<MassAndStiffness<N>>,
}

/// The mass and its spring.
#[derive(Clone, Copy)]
pub(crate) struct MassAndStiffness<N> {
    pub(crate) mass: N,
    pub(crate) stiffness: N,
}

/// Damping mechanism.
#[derive(Clone, Copy)]
pub(crate) enum Loss<N> {
    /// A dashpot: its damping ratio, and its coefficient where the mass is known.
    Viscous(N, Option<N>),
    /// The material: its loss factor.
    Hysteretic(N),
}

/// Damping at one frequency, as that of a dashpot.
#[derive(Clone, Copy)]
pub(crate) struct AtFrequency<N> {
    /// Frequency ratio.
    pub(crate) ratio: N,
    /// Damping ratio.
    pub(crate) damping_ratio: N,
    /// Damping coefficient, where the mass is known.
    pub(crate) damping: Option<N>,
}

/// Natural frequency, stiffness and damping, with the steps that lead to them.
///
/// # Errors
/// A mass that is needed and was not given; a free motion that does not oscillate.
pub(crate) fn suspension<W: Worksheet>(
    mass: Option<W::Num>,
    elasticity: &ElasticityGiven<W>,
    damping: &GivenDamping<'_, W>,
    sheet: W,
) -> Result<Suspension<W::Num>, Refusal> {
    suspension_of(OscillatorMotion::Translation, mass, elasticity, damping, sheet)
}

/// The same of a translation or of a rotation: then `mass` is the moment of inertia, kg·m², and stiffness and damping are
/// torsional.
///
/// # Errors
/// Those of [`suspension`].
pub(crate) fn suspension_of<W: Worksheet>(
    motion: OscillatorMotion,
    mass: Option<W::Num>,
    elasticity: &ElasticityGiven<W>,
    damping: &GivenDamping<'_, W>,
    sheet: W,
) -> Result<Suspension<W::Num>, Refusal> {
    let by_decay = match damping {
        GivenDamping::Decay(amplitudes) => Some(decrement(amplitudes, sheet).damping_ratio),
        GivenDamping::Ratio(ratio) => Some(*ratio),
        _ => None,
    };
    let (natural, known_stiffness) = match elasticity {
        ElasticityGiven::Springs(data) => frequency_and_stiffness(data, mass, sheet)?,
        ElasticityGiven::DampedFrequency { frequency } => {
            (undamped(*frequency, by_decay, mass, damping, sheet)?, None)
        }
    };
    let body = mass.map(|mass| {
        let stiffness = known_stiffness.unwrap_or_else(|| stiffness_of(motion, mass, natural, sheet));
        MassAndStiffness { mass, stiffness }
    });
    let loss = match damping {
        GivenDamping::LossFactor(loss_factor) => Loss::Hysteretic(*loss_factor),
        GivenDamping::Coefficient(coefficient) => {
            let MassAndStiffness { mass, stiffness } = body.ok_or_else(|| {
                Refusal::because(
                    "a damping coefficient is not sufficient without the mass: write the mass, or the damping ratio",
                )
            })?;
            let zeta = sheet.step(
                "ζ",
                "1",
                sdof::damping_ratio(*coefficient, stiffness, mass),
                ("Damping ratio: damping over critical damping", RAO.at("§2.6")),
            );
            Loss::Viscous(zeta, Some(*coefficient))
        }
        GivenDamping::Ratio(_) | GivenDamping::Decay(_) => {
            let zeta = by_decay.expect("these give the damping ratio");
            let why = ("Damping coefficient", RAO.at("§2.6"));
            let c = body.map(|body| {
                let c = sdof::damping_from_ratio(zeta, body.stiffness, body.mass);
                let damped = || c * (W::Num::from(1.0) - zeta.powi(2)).sqrt();
                sheet.common_error(
                    motion.damping(),
                    "the damped natural frequency used in the damping coefficient",
                    damped,
                );
                sheet.step(motion.damping(), motion.damping_unit(), c, why)
            });
            Loss::Viscous(zeta, c)
        }
    };
    Ok(Suspension { motion, natural, loss, body })
}

/// Natural frequency from the springs without damping; and their stiffness, where it is known before the mass.
///
/// # Errors
/// A mass that is needed and was not given; a spring that is none.
pub(crate) fn frequency_and_stiffness<W: Worksheet>(
    springs: &SpringDataGiven<W>,
    mass: Option<W::Num>,
    sheet: W,
) -> Result<(W::Num, Option<W::Num>), Refusal> {
    let stiffness = match springs {
        SpringDataGiven::Stiffness { stiffness } => *stiffness,
        SpringDataGiven::Springs { springs } => stiffness(springs, sheet)?,
        SpringDataGiven::StaticDeflection { deflection, gravity } => {
            let why = ("Natural frequency, from the weight m g = k δ_st", RAO.at("§2.2"));
            return Ok((sheet.step("ωₙ", "rad/s", (*gravity / *deflection).sqrt(), why), None));
        }
        SpringDataGiven::NaturalFrequency { frequency } => return Ok((*frequency, None)),
    };
    Ok((frequency_of(stiffness, needed(mass)?, sheet), Some(stiffness)))
}

/// The natural frequency, rad/s, of a mass on a spring, or of an inertia on a torsional spring.
pub(crate) fn frequency_of<W: Worksheet>(stiffness: W::Num, mass: W::Num, sheet: W) -> W::Num {
    let why = ("Natural frequency without damping", RAO.at("§2.2"));
    sheet.step("ωₙ", "rad/s", sdof::natural_frequency(stiffness, mass), why)
}

/// The stiffness behind a natural frequency.
pub(crate) fn stiffness_of<W: Worksheet>(
    motion: OscillatorMotion,
    mass: W::Num,
    natural: W::Num,
    sheet: W,
) -> W::Num {
    let words = motion.of(
        "Stiffness that gives the mass this natural frequency",
        "Torsional stiffness that gives the moment of inertia this natural frequency",
    );
    let (symbol, unit) = motion.stiffness();
    let k = sdof::stiffness_from_natural_frequency(mass, natural);
    sheet.step(symbol, unit, k, (words, RAO.at("§2.2")))
}

impl<N: Real> Suspension<N> {
    /// Frequency ratio and damping at a frequency.
    pub(crate) fn at<W: Worksheet<Num = N>>(&self, frequency: N, sheet: W) -> AtFrequency<N> {
        if let Loss::Viscous(zeta, _) = self.loss {
            let damped = || frequency / sdof::damped_frequency(self.natural, zeta);
            sheet.common_error("r", "the damped natural frequency used in the frequency ratio", damped);
        }
        let ratio = sheet.step("r", "1", sdof::frequency_ratio(frequency, self.natural), "Frequency ratio");
        let (damping_ratio, damping) = match self.loss {
            Loss::Viscous(zeta, c) => (zeta, c),
            Loss::Hysteretic(eta) => {
                let c = self.body.map(|body| {
                    let c = eta * body.stiffness / frequency;
                    let why = "Viscous damper with the same energy loss per cycle at this frequency";
                    sheet.common_error(
                        "c_eq",
                        "the natural frequency used in place of that of the excitation",
                        || eta * body.stiffness / self.natural,
                    );
                    sheet.step("c_eq", self.motion.damping_unit(), c, (why, RAO.at("§3.10")))
                });
                let why = "Damping ratio of the viscous damper with the same energy loss per cycle at this frequency";
                sheet.common_error(
                    "ζ_eq",
                    "the relation ζ = η/2, which holds at resonance, used at another frequency",
                    || eta / 2.0,
                );
                (sheet.step("ζ_eq", "1", eta / (ratio * 2.0), (why, RAO.at("§3.10"))), c)
            }
        };
        AtFrequency { ratio, damping_ratio, damping }
    }

    /// Returns true if there is no damping.
    pub(crate) fn is_undamped(&self) -> bool {
        match self.loss {
            Loss::Viscous(zeta, _) => zeta.value() == 0.0,
            Loss::Hysteretic(eta) => eta.value() == 0.0,
        }
    }

    /// The answers that tell of the oscillator itself.
    pub(crate) fn answer<W: Worksheet<Num = N>>(&self, sheet: W) {
        if let Some(body) = self.body {
            let (name, label) = self.motion.of(("mass", "Mass"), ("inertia", "Moment of inertia"));
            sheet.answer(name, label, body.mass);
            sheet.answer("stiffness", self.motion.of("Stiffness", "Torsional stiffness"), body.stiffness);
        }
        sheet.answer("natural_frequency", "Natural frequency", self.natural);
        if let Loss::Viscous(zeta, c) = self.loss {
            sheet.answer("damping_ratio", "Damping ratio", zeta);
            if let Some(c) = c {
                let label = self.motion.of("Damping coefficient", "Torsional damping coefficient");
                sheet.answer("damping", label, c);
            }
        }
    }
}

impl<N: Real> AtFrequency<N> {
    /// Returns true if the frequency is the natural one, to within rounding.
    pub(crate) fn is_resonance(&self) -> bool {
        is_one(self.ratio.value())
    }
}

/// Resisting force of spring, damper and inertia in a steady motion `X cos(ωt − φ)`, over the stiffness: in phase with
/// the excitation, and a quarter of a cycle ahead of it; and the magnitude of its terms.
pub(crate) fn resisting_force<N: Real>([ratio, zeta]: [N; 2], amplitude: N, lag: N) -> ([N; 2], f64) {
    let (held, damped) = (N::from(1.0) - ratio.powi(2), zeta * ratio * 2.0);
    let size = amplitude.value().abs() * (1.0 + ratio.value().powi(2) + damped.value());
    let in_phase = amplitude * (held * lag.cos() + damped * lag.sin());
    ([in_phase, amplitude * (damped * lag.cos() - held * lag.sin())], size)
}

/// Returns true if a ratio is one, to within the rounding of the units it was typed in.
pub(crate) fn is_one(ratio: f64) -> bool {
    (ratio - 1.0).abs() < 1e-10
}

fn needed<N>(mass: Option<N>) -> Result<N, Refusal> {
    mass.ok_or_else(|| {
        Refusal::because(
            "the natural frequency of these springs needs the mass on them: write the mass, or give the natural \
             frequency or the static deflection",
        )
    })
}

/// The natural frequency behind a damped one.
fn undamped<W: Worksheet>(
    damped: W::Num,
    zeta: Option<W::Num>,
    mass: Option<W::Num>,
    damping: &GivenDamping<'_, W>,
    sheet: W,
) -> Result<W::Num, Refusal> {
    let slower = "The damped frequency is below the natural frequency";
    let value = match (damping, zeta) {
        (_, Some(zeta)) if zeta.value() < 1.0 => sdof::natural_frequency_from_damped(damped, zeta),
        (_, Some(_)) => {
            return Err(Refusal::because(
                "with a damping ratio of 1 or more the free motion does not oscillate: give the natural frequency",
            ));
        }
        (GivenDamping::Coefficient(coefficient), _) => {
            (damped.powi(2) + (*coefficient / (needed(mass)? * 2.0)).powi(2)).sqrt()
        }
        _ => {
            return Err(Refusal::because(
                "hysteretic damping has no damped natural frequency: give the undamped natural frequency",
            ));
        }
    };
    Ok(sheet.step("ωₙ", "rad/s", value, (slower, RAO.at("§2.6"))))
}

impl SpringData {
    /// The letters at the spring.
    pub(crate) fn letters(&self) -> &'static str {
        match self {
            SpringData::Stiffness { .. } | SpringData::Springs { .. } => "k",
            SpringData::StaticDeflection { .. } => "k, δ_st",
            SpringData::NaturalFrequency { .. } => "k, ωₙ",
        }
    }
}

impl Elasticity {
    /// The letters at the spring.
    pub(crate) fn letters(&self) -> &'static str {
        match self {
            Elasticity::Springs(springs) => springs.letters(),
            Elasticity::DampedFrequency { .. } => "k, ω_d",
        }
    }
}
