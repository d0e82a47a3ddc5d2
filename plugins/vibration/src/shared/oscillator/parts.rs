//! Body, springs and damping of one degree of freedom that moves along a line or about an axis.

use dalembert_core::{Inputs, Refusal, Text, Worksheet};

use super::{
    Elasticity, ElasticityGiven, GivenDamping, SpringData, SpringDataGiven, Suspension, ViscousDamping,
    ViscousDampingGiven, frequency_and_stiffness, frequency_of, motion::OscillatorMotion, stiffness_of,
    suspension_of,
};
use crate::shared::{
    inertia::{Inertia, TranslatingBody, TranslatingBodyGiven, moment_of_inertia},
    letters::joined,
    spring::{
        self,
        torsional::{self, TorsionalSpring},
    },
};
use crate::sources::RAO;

/// Mass of a translation, or moment of inertia of a rotation.
#[derive(Clone, Debug, Inputs)]
pub enum OscillatingBody {
    /// Translation
    #[input(flatten)]
    Translation(TranslatingBody),
    /// Rotation: moment of inertia
    /// Springs, damping and excitation are then torsional.
    Rotation {
        /// Moment of inertia.
        inertia: Inertia,
    },
}

/// Given quantity of the springs, straight or torsional.
#[derive(Clone, Debug, Inputs)]
pub enum BodySprings {
    /// Translation
    #[input(flatten)]
    Any(Elasticity),
    /// Torsional springs and shafts
    /// For a rotation.
    Torsional {
        /// Torsional springs.
        /// A network: series and parallel groups may be nested.
        springs: TorsionalSpring,
    },
}

/// Stiffness of straight or torsional springs, or what it follows from.
#[derive(Clone, Debug, Inputs)]
pub enum BodyStiffness {
    /// Translation
    #[input(flatten)]
    Straight(SpringData),
    /// Torsional springs and shafts
    /// For a rotation.
    Torsional {
        /// Torsional springs.
        /// A network: series and parallel groups may be nested.
        springs: TorsionalSpring,
    },
}

/// Damping mechanism of a translation or of a rotation.
#[derive(Clone, Debug, Inputs)]
pub enum BodyDamping {
    /// Viscous damper
    #[input(flatten)]
    Viscous(ViscousDamping),
    /// Hysteretic: loss factor given
    /// Complex stiffness k(1 + iη): the energy loss per cycle is independent of frequency.
    LossFactor {
        /// Loss factor.
        #[input("η", "1", nonnegative)]
        loss_factor: f64,
    },
    /// Torsional damping coefficient given
    /// For a rotation.
    Torsional {
        /// Torsional damping coefficient.
        #[input("c_t", "N*m*s/rad", nonnegative)]
        coefficient: f64,
    },
}

impl<W: Worksheet> OscillatingBodyGiven<W> {
    /// The mass, kg, or the moment of inertia, kg·m².
    ///
    /// # Errors
    /// A rolling body without the radius that it needs.
    pub(crate) fn inertia(&self, sheet: W) -> Result<W::Num, Refusal> {
        match self {
            OscillatingBodyGiven::Translation(body) => body.mass(sheet),
            OscillatingBodyGiven::Rotation { inertia } => Ok(moment_of_inertia(inertia, sheet, "J".into())),
        }
    }

    /// The motion that it is of.
    pub(crate) fn motion(&self) -> OscillatorMotion {
        match self {
            OscillatingBodyGiven::Translation(_) => OscillatorMotion::Translation,
            OscillatingBodyGiven::Rotation { .. } => OscillatorMotion::Rotation,
        }
    }

    fn is_rolling(&self) -> bool {
        matches!(self, OscillatingBodyGiven::Translation(TranslatingBodyGiven::Rolling { .. }))
    }
}

/// The motion that all inputs are of; `excitation` is the one that the excitation is of, if it is of one only.
///
/// # Errors
/// Inputs of a translation beside those of a rotation; a static deflection of a body that rolls.
pub(crate) fn motion_of<W: Worksheet>(
    body: Option<&OscillatingBodyGiven<W>>,
    springs: &BodySpringsGiven<W>,
    damping: &BodyDampingGiven<W>,
    excitation: Option<OscillatorMotion>,
) -> Result<OscillatorMotion, Refusal> {
    use OscillatorMotion::{Rotation, Translation};
    let deflected = matches!(
        springs,
        BodySpringsGiven::Any(ElasticityGiven::Springs(SpringDataGiven::StaticDeflection { .. }))
    );
    if deflected && body.is_some_and(OscillatingBodyGiven::is_rolling) {
        return Err(rolling_deflection());
    }
    let of_body = body.map(OscillatingBodyGiven::motion);
    let of_springs = match springs {
        BodySpringsGiven::Torsional { .. } => Some(Rotation),
        BodySpringsGiven::Any(
            ElasticityGiven::DampedFrequency { .. }
            | ElasticityGiven::Springs(SpringDataGiven::NaturalFrequency { .. }),
        ) => None,
        BodySpringsGiven::Any(ElasticityGiven::Springs(_)) => Some(Translation),
    };
    let of_damping = match damping {
        BodyDampingGiven::Torsional { .. } => Some(Rotation),
        BodyDampingGiven::Viscous(ViscousDampingGiven::Coefficient { .. }) => Some(Translation),
        BodyDampingGiven::Viscous(_) | BodyDampingGiven::LossFactor { .. } => None,
    };
    one_motion(of_body, &[of_springs, of_damping, excitation])
}

/// The one motion of a body and of all else.
///
/// # Errors
/// Inputs of a translation beside those of a rotation.
pub(crate) fn one_motion(
    of_body: Option<OscillatorMotion>,
    rest: &[Option<OscillatorMotion>],
) -> Result<OscillatorMotion, Refusal> {
    let mut others = rest.iter().flatten().copied();
    let motion = of_body.or_else(|| others.clone().next()).unwrap_or(OscillatorMotion::Translation);
    if others.all(|other| other == motion) {
        return Ok(motion);
    }
    Err(Refusal::because(motion.of(
        "a mass moves along a line: give its springs, its damping coefficient and its excitation for a translation, or choose rotation as the inertia",
        "a moment of inertia rotates: give torsional springs or the natural frequency, the torsional damping coefficient or the damping ratio, and a torque or an angle",
    )))
}

/// Refusal of a static deflection of a body that rolls.
fn rolling_deflection() -> Refusal {
    Refusal::because(
        "the weight of a rolling body does not deflect its springs, and its equivalent mass is not that of its weight: give the stiffness of the springs",
    )
}

impl<W: Worksheet> BodyStiffnessGiven<W> {
    /// The motion that it is of, if it is of one only.
    pub(crate) fn motion(&self) -> Option<OscillatorMotion> {
        match self {
            BodyStiffnessGiven::Torsional { .. } => Some(OscillatorMotion::Rotation),
            BodyStiffnessGiven::Straight(SpringDataGiven::NaturalFrequency { .. }) => None,
            BodyStiffnessGiven::Straight(_) => Some(OscillatorMotion::Translation),
        }
    }

    /// Natural frequency, rad/s, and stiffness, N/m or N·m/rad, with this body.
    ///
    /// # Errors
    /// A spring that is none; a static deflection of a body that rolls.
    pub(crate) fn with_body(
        &self,
        body: &OscillatingBodyGiven<W>,
        inertia: W::Num,
        sheet: W,
    ) -> Result<[W::Num; 2], Refusal> {
        let springs = match self {
            BodyStiffnessGiven::Torsional { springs } => {
                let stiffness = torsional::stiffness(springs, sheet)?;
                return Ok([frequency_of(stiffness, inertia, sheet), stiffness]);
            }
            BodyStiffnessGiven::Straight(springs) => springs,
        };
        if let SpringDataGiven::StaticDeflection { .. } = springs
            && body.is_rolling()
        {
            return Err(rolling_deflection());
        }
        let (natural, known) = frequency_and_stiffness(springs, Some(inertia), sheet)?;
        let stiffness = known.unwrap_or_else(|| stiffness_of(body.motion(), inertia, natural, sheet));
        Ok([natural, stiffness])
    }
}

/// Natural frequency, stiffness and damping of a body, with the steps that lead to them.
///
/// # Errors
/// Those of [`super::suspension`] and of the body.
pub(crate) fn suspension_of_body<W: Worksheet>(
    motion: OscillatorMotion,
    body: Option<&OscillatingBodyGiven<W>>,
    springs: &BodySpringsGiven<W>,
    damping: &BodyDampingGiven<W>,
    sheet: W,
) -> Result<Suspension<W::Num>, Refusal> {
    let inertia = body.map(|body| body.inertia(sheet)).transpose()?;
    let torsional;
    let elasticity = match springs {
        BodySpringsGiven::Any(elasticity) => elasticity,
        BodySpringsGiven::Torsional { springs } => {
            let stiffness = torsional::stiffness(springs, sheet)?;
            torsional = ElasticityGiven::Springs(SpringDataGiven::Stiffness { stiffness });
            &torsional
        }
    };
    let damping = match damping {
        BodyDampingGiven::Viscous(viscous) => viscous.given(),
        BodyDampingGiven::LossFactor { loss_factor } => GivenDamping::LossFactor(*loss_factor),
        BodyDampingGiven::Torsional { coefficient } => GivenDamping::Coefficient(*coefficient),
    };
    suspension_of(motion, inertia, elasticity, &damping, sheet)
}

/// Stiffness of torsional springs, or what it follows from.
#[derive(Clone, Debug, Inputs)]
pub enum TorsionalElasticity {
    /// Torsional stiffness given
    Stiffness {
        /// Torsional stiffness.
        #[input("k_t", "N*m/rad", positive)]
        stiffness: f64,
    },
    /// Torsional springs and shafts
    Springs {
        /// Torsional springs.
        /// A network: series and parallel groups may be nested.
        springs: TorsionalSpring,
    },
    /// Natural frequency
    NaturalFrequency {
        /// Natural frequency.
        /// Without damping.
        #[input("ωₙ", "rad/s", positive)]
        frequency: f64,
    },
}

impl<W: Worksheet> TorsionalElasticityGiven<W> {
    /// Natural frequency, rad/s, and torsional stiffness, N·m/rad, with this moment of inertia.
    ///
    /// # Errors
    /// A spring that is none.
    pub(crate) fn frequency_and_stiffness(&self, inertia: W::Num, sheet: W) -> Result<[W::Num; 2], Refusal> {
        let stiffness = match self {
            TorsionalElasticityGiven::Stiffness { stiffness } => *stiffness,
            TorsionalElasticityGiven::Springs { springs } => torsional::stiffness(springs, sheet)?,
            TorsionalElasticityGiven::NaturalFrequency { frequency } => {
                let stiffness = stiffness_of(OscillatorMotion::Rotation, inertia, *frequency, sheet);
                return Ok([*frequency, stiffness]);
            }
        };
        Ok([frequency_of(stiffness, inertia, sheet), stiffness])
    }
}

impl<W: Worksheet> TranslatingBodyGiven<W> {
    /// Mass, kg, natural frequency, rad/s, and stiffness, N/m, on these springs.
    ///
    /// # Errors
    /// A spring that is none; a static deflection of a body that rolls.
    pub(crate) fn on_springs(&self, springs: &SpringDataGiven<W>, sheet: W) -> Result<[W::Num; 3], Refusal> {
        if let (TranslatingBodyGiven::Rolling { .. }, SpringDataGiven::StaticDeflection { .. }) =
            (self, springs)
        {
            return Err(rolling_deflection());
        }
        let mass = self.mass(sheet)?;
        let (natural, known) = frequency_and_stiffness(springs, Some(mass), sheet)?;
        let stiffness =
            known.unwrap_or_else(|| stiffness_of(OscillatorMotion::Translation, mass, natural, sheet));
        Ok([mass, natural, stiffness])
    }
}

impl<W: Worksheet> SpringDataGiven<W> {
    /// The stiffness, N/m, under a mass, written where it is not given.
    ///
    /// # Errors
    /// A spring that is none.
    pub(crate) fn stiffness_under(&self, mass: W::Num, sheet: W) -> Result<W::Num, Refusal> {
        Ok(match self {
            SpringDataGiven::Stiffness { stiffness } => *stiffness,
            SpringDataGiven::Springs { springs } => spring::stiffness(springs, sheet)?,
            SpringDataGiven::StaticDeflection { deflection, gravity } => {
                let why = ("Stiffness from the static deflection: k δ_st = m g", RAO.at("§2.2"));
                sheet.step("k", "N/m", mass * *gravity / *deflection, why)
            }
            SpringDataGiven::NaturalFrequency { frequency } => {
                stiffness_of(OscillatorMotion::Translation, mass, *frequency, sheet)
            }
        })
    }
}

impl OscillatingBody {
    /// The letters at the body.
    pub(crate) fn letters(&self) -> Text {
        match self {
            OscillatingBody::Translation(body) => body.letter().into(),
            OscillatingBody::Rotation { inertia } => joined(inertia.letters()),
        }
    }
}

impl BodySprings {
    /// The letters at the springs.
    pub(crate) fn letters(&self) -> &'static str {
        match self {
            BodySprings::Any(springs) => springs.letters(),
            BodySprings::Torsional { .. } => "k_t",
        }
    }
}

impl BodyStiffness {
    /// The letters at the springs.
    pub(crate) fn letters(&self) -> &'static str {
        match self {
            BodyStiffness::Straight(springs) => springs.letters(),
            BodyStiffness::Torsional { .. } => "k_t",
        }
    }
}
