//! The undamped absorber: a mass on a spring that holds a machine still at one speed.

use std::f64::consts::TAU;

use dalembert_core::{About, Analysis, Inputs, Refusal, Worksheet, register};
use dalembert_mechanics::Real;

mod design;
mod exhibits;
mod motion;
mod trial;

use self::{
    design::{AbsorberRequirement, main_system},
    motion::AbsorberMotion,
    trial::{KeptOut, TrialBody},
};
use crate::{
    shared::{
        inertia::{self, Inertia},
        main_springs::{MainSprings, MainSpringsGiven},
        oscillator::{Mass, mass},
    },
    sources::{DEN_HARTOG, GROVER, RAO},
};

/// Inputs of a vibration absorber.
#[derive(Clone, Debug, Inputs)]
pub struct VibrationAbsorber {
    /// Main system.
    pub problem: MainSystem,
}

/// Machine or rotor, and its given quantities.
#[derive(Clone, Debug, Inputs)]
pub enum MainSystem {
    /// Machine on springs
    Translation {
        /// Mass of the machine.
        mass: Mass,
        /// Springs of the machine.
        springs: MainSprings,
        /// Speed of the excitation.
        /// The absorber is tuned to it.
        speed: ExcitationSpeed,
        /// Excitation.
        /// For the amplitudes; required for a stroke limit.
        excitation: Option<AbsorberExcitation>,
        /// Absorber.
        absorber: LinearAbsorber,
    },
    /// Rotor on a shaft
    Torsion {
        /// Inertia of the rotor.
        inertia: Inertia,
        /// Shaft.
        shaft: ShaftStiffness,
        /// Speed of the excitation.
        /// The absorber is tuned to it.
        speed: ExcitationSpeed,
        /// Amplitude of the torque.
        /// For the amplitudes; required for a stroke limit.
        #[input("T", "N*m", positive)]
        torque: Option<f64>,
        /// Absorber.
        absorber: TorsionalAbsorber,
        /// Springs between absorber and rotor.
        /// Straight springs arranged along the circumference.
        springs: Option<RingOfSprings>,
    },
    /// From the two resonances with a trial absorber
    Trial {
        /// Trial absorber.
        body: TrialBody,
        /// Natural frequency of the trial absorber.
        /// By itself, on a fixed base: the speed it is tuned to.
        #[input("ω_a", "rad/s", positive)]
        tuned: f64,
        /// Lower resonance measured.
        #[input("Ω₁", "rad/s", positive)]
        lower: f64,
        /// Upper resonance measured.
        #[input("Ω₂", "rad/s", positive)]
        upper: f64,
        /// Speeds without resonance.
        /// Both resonances must lie outside this range, with a new absorber tuned like the trial one.
        kept_out: Option<KeptOut>,
    },
}

/// Data of the shaft.
#[derive(Clone, Debug, Inputs)]
pub enum ShaftStiffness {
    /// Stiffness given
    Stiffness {
        /// Torsional stiffness.
        #[input("k_t", "N*m/rad", positive)]
        stiffness: f64,
    },
    /// Natural frequency given
    NaturalFrequency {
        /// Natural frequency.
        /// Without the absorber.
        #[input("ω_m", "rad/s", positive)]
        frequency: f64,
    },
}

/// The speed of the excitation.
#[derive(Clone, Debug, Inputs)]
pub enum ExcitationSpeed {
    /// Speed given
    Given {
        /// Speed.
        #[input("ω", "rad/s", positive)]
        speed: f64,
    },
    /// As a fraction of the natural frequency
    Ratio {
        /// Speed over the natural frequency of the main system.
        #[input("r", "1", positive, default = "1")]
        ratio: f64,
    },
}

/// Excitation of the machine.
#[derive(Clone, Debug, Inputs)]
pub enum AbsorberExcitation {
    /// Force
    Force {
        /// Amplitude of the force.
        #[input("F₀", "N", positive)]
        force: f64,
    },
    /// Rotating unbalance
    Unbalance {
        /// Unbalance.
        /// The eccentric mass times its eccentricity.
        #[input("m₀e", "kg*m", positive)]
        unbalance: f64,
    },
}

/// Requirement on the absorber of a machine, or its known parameter.
#[derive(Clone, Debug, Inputs)]
pub enum LinearAbsorber {
    /// Limited stroke
    /// The softest and lightest absorber whose mass does not exceed this displacement.
    Stroke {
        /// Maximum amplitude of the absorber.
        #[input("X_s", "m", positive, kind = "Amplitude")]
        stroke: f64,
    },
    /// Resonances kept away from the speed
    Separation {
        /// Minimum separation from the speed, as a fraction of it.
        #[input("s", "%", positive, fraction, below = 100)]
        separation: f64,
    },
    /// Resonances kept out of a range of speeds
    Range {
        /// Range.
        range: KeptOut,
    },
    /// Mass ratio given
    Ratio {
        /// Mass of the absorber over that of the machine.
        #[input("μ", "1", positive)]
        ratio: f64,
    },
    /// Mass given, tuned to the speed
    Mass {
        /// Mass of the absorber.
        #[input("m_a", "kg", positive)]
        mass: f64,
    },
    /// Absorber given
    /// Also for an absorber not tuned to the speed.
    Given {
        /// Mass of the absorber.
        #[input("m_a", "kg", positive)]
        mass: f64,
        /// Stiffness of its spring.
        #[input("k_a", "N/m", positive)]
        stiffness: f64,
    },
}

/// Requirement on the absorber of a rotor, or its known parameter.
#[derive(Clone, Debug, Inputs)]
pub enum TorsionalAbsorber {
    /// Limited stroke
    /// The softest and lightest absorber that does not exceed this rotation.
    Stroke {
        /// Maximum amplitude of the absorber.
        #[input("θ_s", "rad", positive)]
        stroke: f64,
    },
    /// Resonances kept away from the speed
    Separation {
        /// Minimum separation from the speed, as a fraction of it.
        #[input("s", "%", positive, fraction, below = 100)]
        separation: f64,
    },
    /// Resonances kept out of a range of speeds
    Range {
        /// Range.
        range: KeptOut,
    },
    /// Ratio of the inertias given
    Ratio {
        /// Inertia of the absorber over that of the rotor.
        #[input("μ", "1", positive)]
        ratio: f64,
    },
    /// Inertia given, tuned to the speed
    Inertia {
        /// Inertia of the absorber.
        #[input("J_a", "kg*m^2", positive)]
        inertia: f64,
    },
    /// Absorber given
    /// Also for an absorber not tuned to the speed.
    Given {
        /// Inertia of the absorber.
        #[input("J_a", "kg*m^2", positive)]
        inertia: f64,
        /// Torsional stiffness of its springs.
        #[input("k_ta", "N*m/rad", positive)]
        stiffness: f64,
    },
}

/// Springs on a circle.
#[derive(Clone, Debug, Inputs)]
pub struct RingOfSprings {
    /// Number of springs.
    #[input(min = 1, max = 1000, default = "4")]
    pub count: u32,
    /// Radius of the circle.
    #[input("ρ", "m", positive)]
    pub radius: f64,
}

register!(VibrationAbsorber);

impl Analysis for VibrationAbsorber {
    const ABOUT: About = About {
        id: "vibration/vibration-absorber",
        title: "Undamped vibration absorber",
        topic: "Isolation, absorbers and instruments",
        summary: "Mass and spring of an absorber for a limited stroke or for separated resonances, its two resonances and amplitudes, and a main system from a trial absorber.",
        main: &[
            "absorber_mass",
            "absorber_inertia",
            "absorber_stiffness",
            "main_inertia",
            "main_stiffness",
            "lower_resonance",
            "upper_resonance",
        ],
        keywords: "dynamic vibration absorber Frahm tuned mass neutraliser splitting resonance torsional \
                   absorvedor dinâmico de vibrações neutralizador sintonizado ressonância torcional",
        sources: &[&RAO, &DEN_HARTOG, &GROVER],
        cases: include_str!("../../cases/vibration_absorber.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &VibrationAbsorberGiven<W>, sheet: W) -> Result<(), Refusal> {
        match &given.problem {
            MainSystemGiven::Translation { mass: body, springs, speed, excitation, absorber } => {
                let motion = AbsorberMotion::Translation;
                let mass = mass(body, sheet);
                let (stiffness, natural) = match springs {
                    MainSpringsGiven::Stiffness { stiffness } => (*stiffness, None),
                    MainSpringsGiven::NaturalFrequency { frequency } => {
                        (motion.stiffness(mass, *frequency, sheet), Some(*frequency))
                    }
                };
                let main = main_system(motion, mass, stiffness, natural, speed, sheet);
                let force = match excitation {
                    None => None,
                    Some(AbsorberExcitationGiven::Force { force }) => Some(*force),
                    Some(AbsorberExcitationGiven::Unbalance { unbalance }) => {
                        let why = ("Unbalance force at this speed", RAO.at("§3.7"));
                        Some(sheet.step("F₀", "N", *unbalance * main.speed.powi(2), why))
                    }
                };
                let wanted = match absorber {
                    LinearAbsorberGiven::Stroke { stroke } => AbsorberRequirement::Stroke(*stroke),
                    LinearAbsorberGiven::Separation { separation } => {
                        AbsorberRequirement::Separation(*separation)
                    }
                    LinearAbsorberGiven::Range { range } => {
                        AbsorberRequirement::Range(range.lowest, range.highest)
                    }
                    LinearAbsorberGiven::Ratio { ratio } => AbsorberRequirement::Ratio(*ratio),
                    LinearAbsorberGiven::Mass { mass } => AbsorberRequirement::Mass(*mass),
                    LinearAbsorberGiven::Given { mass, stiffness } => {
                        AbsorberRequirement::Given(*mass, *stiffness)
                    }
                };
                main.absorbed(&wanted, force, sheet)?;
                Ok(())
            }
            MainSystemGiven::Torsion { inertia, shaft, speed, torque, absorber, springs } => {
                let motion = AbsorberMotion::Torsion;
                let inertia = inertia::moment_of_inertia(inertia, sheet, "J".into());
                let (stiffness, natural) = match shaft {
                    ShaftStiffnessGiven::Stiffness { stiffness } => (*stiffness, None),
                    ShaftStiffnessGiven::NaturalFrequency { frequency } => {
                        (motion.stiffness(inertia, *frequency, sheet), Some(*frequency))
                    }
                };
                let main = main_system(motion, inertia, stiffness, natural, speed, sheet);
                let wanted = match absorber {
                    TorsionalAbsorberGiven::Stroke { stroke } => AbsorberRequirement::Stroke(*stroke),
                    TorsionalAbsorberGiven::Separation { separation } => {
                        AbsorberRequirement::Separation(*separation)
                    }
                    TorsionalAbsorberGiven::Range { range } => {
                        AbsorberRequirement::Range(range.lowest, range.highest)
                    }
                    TorsionalAbsorberGiven::Ratio { ratio } => AbsorberRequirement::Ratio(*ratio),
                    TorsionalAbsorberGiven::Inertia { inertia } => AbsorberRequirement::Mass(*inertia),
                    TorsionalAbsorberGiven::Given { inertia, stiffness } => {
                        AbsorberRequirement::Given(*inertia, *stiffness)
                    }
                };
                let stiffness = main.absorbed(&wanted, *torque, sheet)?;
                if let (Some(given), MainSystem::Torsion { springs: Some(springs), .. }) =
                    (springs, &self.problem)
                {
                    let each = stiffness / (given.radius.powi(2) * f64::from(springs.count));
                    let why = "Stiffness of each spring: at radius ρ a rotation θ stretches it by ρθ, and its force acts at ρ";
                    let each = sheet.step("k_s", "N/m", each, why);
                    sheet.answer("stiffness_each", "Stiffness of each spring", each);
                    sheet.verify(|| {
                        let (radius, each) = (given.radius.value(), each.value());
                        // A spring at the angle of its place is pulled across the radius.
                        let moment = |n: u32| {
                            let (sine, cosine) = (TAU * f64::from(n) / f64::from(springs.count)).sin_cos();
                            let arm = [radius * cosine, radius * sine];
                            let force = [-each * radius * sine, each * radius * cosine];
                            arm[0] * force[1] - arm[1] * force[0]
                        };
                        sheet.check(
                            "moment of the springs about the centre for a unit rotation, one by one",
                            stiffness,
                            W::Num::from((0..springs.count).map(moment).sum::<f64>()),
                        );
                    });
                }
                Ok(())
            }
            MainSystemGiven::Trial { body, tuned, lower, upper, kept_out } => {
                trial::solve(body, *tuned, [*lower, *upper], kept_out.as_ref(), sheet)
            }
        }
    }
}
