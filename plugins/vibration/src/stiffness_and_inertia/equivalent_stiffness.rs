//! A network of springs as one spring, and the natural frequency of what it carries.

use std::f64::consts::TAU;

use dalembert_core::{
    About, Analysis, Axis, Drawing, Exhibit, Ink, Inputs, Plot, Refusal, Series, Sketch, Worksheet, register,
};
use dalembert_mechanics::{Real, sdof};

use crate::{
    shared::{
        inertia::{Inertia, moment_of_inertia},
        spring::{
            Spring, SpringGiven, network,
            shares::{Loaded, shares},
            sketch::{self, Suspended},
            torsional::{self, TorsionalSpring, TorsionalSpringGiven},
        },
        turning,
    },
    sources::RAO,
};

/// Springs and what they carry.
#[derive(Clone, Debug, Inputs)]
pub struct EquivalentStiffness {
    /// Motion.
    pub motion: SupportedMotion,
}

/// Type of motion of the body: translation or rotation.
#[derive(Clone, Debug, Inputs)]
pub enum SupportedMotion {
    /// Along a line
    Translation {
        /// Springs.
        /// A network: series and parallel groups may be nested.
        springs: Spring,
        /// Supported body.
        /// If omitted, only the stiffness is found.
        load: Option<SupportedLoad>,
        /// Masses of the springs themselves.
        spring_masses: Vec<SpringMass>,
        /// Gravity.
        /// Between mass and weight.
        #[input("g", "m/s^2", positive, default = "9.81 m/s^2")]
        gravity: f64,
    },
    /// Rotation about an axis
    Rotation {
        /// Torsional springs.
        /// A network: series and parallel groups may be nested.
        springs: TorsionalSpring,
        /// Supported body.
        /// If omitted, only the stiffness is found.
        body: Option<TorsionalBody>,
        /// Moment of inertia of the shaft about its axis.
        /// One third of it rotates with the body; omitted for a light shaft.
        #[input("J_s", "kg*m^2", nonnegative)]
        shaft_inertia: Option<f64>,
    },
    /// Along a line, spring unknown
    /// The stiffness that gives a mass its natural frequency.
    Sought {
        /// Mass.
        #[input("m", "kg", positive)]
        mass: f64,
        /// Natural frequency required.
        #[input("ωₙ", "Hz", positive)]
        natural_frequency: f64,
        /// Gravity.
        /// For the static deflection.
        #[input("g", "m/s^2", positive, default = "9.81 m/s^2")]
        gravity: f64,
    },
}

/// Load on linear springs.
#[derive(Clone, Debug, Inputs)]
pub enum SupportedLoad {
    /// Mass given
    Mass {
        /// Mass.
        #[input("m", "kg", positive)]
        mass: f64,
    },
    /// Weight given
    Weight {
        /// Weight.
        #[input("W", "N", positive)]
        weight: f64,
    },
    /// Unknown mass, natural frequency required
    Frequency {
        /// Natural frequency.
        #[input("ωₙ", "rad/s", positive)]
        natural_frequency: f64,
    },
    /// Unknown mass, static deflection known
    Deflection {
        /// Static deflection.
        #[input("δ", "mm", positive)]
        static_deflection: f64,
    },
}

/// A spring that is not light: what of its mass moves with the load.
#[derive(Clone, Debug, Inputs)]
pub struct SpringMass {
    /// Mass of the spring.
    #[input("m_s", "kg", positive)]
    pub mass: f64,
    /// Kind.
    pub kind: Deflected,
}

/// Type of deflection of a spring, which determines the effective fraction of its own mass.
#[derive(Clone, Debug, Inputs)]
pub enum Deflected {
    /// Helical spring or bar: 1/3
    Axial,
    /// Cantilever, load at its tip: 33/140
    Cantilever,
    /// Simply supported beam, load at midspan: 17/35
    SimplySupported,
    /// Beam clamped at both ends, load at midspan: 13/35
    Clamped,
    /// Given fraction
    Share {
        /// Effective mass fraction.
        #[input("f", "1", nonnegative, max = 1)]
        share: f64,
    },
}

/// Body on torsion springs.
#[derive(Clone, Debug, Inputs)]
pub enum TorsionalBody {
    /// Moment of inertia known
    Known {
        /// Body.
        inertia: Inertia,
    },
    /// Unknown, natural frequency required
    Frequency {
        /// Natural frequency.
        #[input("ωₙ", "rad/s", positive)]
        natural_frequency: f64,
    },
}

register!(EquivalentStiffness);

impl Analysis for EquivalentStiffness {
    const ABOUT: About = About {
        id: "vibration/equivalent-stiffness",
        title: "Equivalent stiffness",
        topic: "Stiffness and inertia",
        summary: "Equivalent spring of a network of springs, beams or shafts, the load on each of them, and the natural frequency of the mass on them.",
        main: &["stiffness", "torsional_stiffness", "natural_frequency", "frequency"],
        keywords: "series parallel spring network natural frequency static deflection effective mass torsional \
                   pendulum rigidez equivalente molas série paralelo frequência natural deflexão estática \
                   pêndulo de torção buoyancy floating body U-tube manometer empuxo corpo flutuante manômetro \
                   tubo em U",
        sources: &[&RAO],
        cases: include_str!("../../cases/equivalent_stiffness.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &EquivalentStiffnessGiven<W>, sheet: W) -> Result<(), Refusal> {
        match &given.motion {
            SupportedMotionGiven::Translation { springs, load, spring_masses, gravity } => {
                translation(springs, load.as_ref(), spring_masses, *gravity, sheet)?;
            }
            SupportedMotionGiven::Rotation { springs, body, shaft_inertia } => {
                rotation(springs, body.as_ref(), *shaft_inertia, sheet)?;
            }
            SupportedMotionGiven::Sought { mass, natural_frequency, gravity } => {
                sought(*mass, *natural_frequency, *gravity, sheet);
            }
        }
        sheet.show(|| Exhibit::Drawing(self.drawing()));
        Ok(())
    }
}

impl EquivalentStiffness {
    fn drawing(&self) -> Drawing {
        match &self.motion {
            SupportedMotion::Translation { springs, load, .. } => sketched(
                springs,
                load.as_ref().map(|load| match load {
                    SupportedLoad::Mass { .. } => ("m", "x"),
                    SupportedLoad::Weight { .. } => ("W", "x"),
                    SupportedLoad::Frequency { .. } => ("m", "x, ωₙ"),
                    SupportedLoad::Deflection { .. } => ("m", "x, δ"),
                }),
            ),
            SupportedMotion::Rotation { springs, body, .. } => sketched(
                springs,
                body.as_ref().map(|body| match body {
                    TorsionalBody::Known { .. } => ("J", "θ"),
                    TorsionalBody::Frequency { .. } => ("J", "θ, ωₙ"),
                }),
            ),
            SupportedMotion::Sought { .. } => {
                sketched(&Spring::Stiffness { stiffness: 1.0 }, Some(("m", "x, ωₙ")))
            }
        }
    }
}

fn translation<W: Worksheet>(
    springs: &SpringGiven<W>,
    load: Option<&SupportedLoadGiven<W>>,
    spring_masses: &[SpringMassGiven<W>],
    gravity: W::Num,
    sheet: W,
) -> Result<(), Refusal> {
    let whole = network(springs, sheet, &[])?;
    let k = whole.stiffness;
    sheet.answer("stiffness", "Equivalent stiffness", k);
    let Some(load) = load else {
        shares(&whole, sheet, None);
        return Ok(());
    };
    let moving = |(n, spring): (usize, &SpringMassGiven<W>)| {
        let (share, why) = match &spring.kind {
            DeflectedGiven::Axial {} => (
                spring.mass / 3.0,
                "Effective mass of a helical spring or bar: one third of its mass, at the moving end",
            ),
            DeflectedGiven::Cantilever {} => {
                (spring.mass * 33.0 / 140.0, "Effective mass of a cantilever: 33/140 of its mass, at the tip")
            }
            DeflectedGiven::SimplySupported {} => (
                spring.mass * 17.0 / 35.0,
                "Effective mass of a simply supported beam: 17/35 of its mass, at midspan",
            ),
            DeflectedGiven::Clamped {} => (
                spring.mass * 13.0 / 35.0,
                "Effective mass of a beam clamped at both ends: 13/35 of its mass, at midspan",
            ),
            DeflectedGiven::Share { share } => {
                (*share * spring.mass, "Effective mass of the spring, moving with the load")
            }
        };
        if !matches!(spring.kind, DeflectedGiven::Share { .. }) {
            sheet.common_error(("m_e", n + 1), "the whole mass of the spring taken", || spring.mass);
        }
        sheet.step(("m_e", n + 1), "kg", share, (why, RAO.at("§1.8")))
    };
    let moving: Vec<W::Num> = spring_masses.iter().enumerate().map(moving).collect();
    let with_springs = |mass: W::Num| {
        if moving.is_empty() {
            return mass;
        }
        let terms = std::iter::once(mass).chain(moving.iter().copied());
        sheet.common_error("m'", "the masses of the springs neglected", || mass);
        sheet.step(
            "m'",
            "kg",
            W::Num::sum(terms),
            ("Total moving mass: the kinetic energies add up", RAO.at("§1.8")),
        )
    };
    let (mass, natural) = match load {
        SupportedLoadGiven::Frequency { natural_frequency } => {
            let all = sdof::mass_from_natural_frequency(k, *natural_frequency);
            let why = ("Mass that has this natural frequency on the springs", RAO.at("§2.2"));
            let mass = if moving.is_empty() {
                sheet.step("m", "kg", all, why)
            } else {
                let all = sheet.step("m'", "kg", all, why);
                let rest = all - W::Num::sum(moving.iter().copied());
                if rest.value() <= 0.0 {
                    return Err(Refusal::because(
                        "the natural frequency of the springs alone is below the required one: write a lower frequency or lighter springs",
                    ));
                }
                sheet.common_error("m", "the masses of the springs neglected", || all);
                sheet.step(
                    "m",
                    "kg",
                    rest,
                    "Remaining mass of the load, after subtracting the effective mass of the springs",
                )
            };
            (mass, *natural_frequency)
        }
        SupportedLoadGiven::Mass { mass } => (*mass, natural(k, with_springs(*mass), sheet)),
        SupportedLoadGiven::Weight { weight } => {
            let mass = sheet.step("m", "kg", *weight / gravity, "Mass of the weight");
            (mass, natural(k, with_springs(mass), sheet))
        }
        SupportedLoadGiven::Deflection { static_deflection } => {
            let mass = sheet.step(
                "m",
                "kg",
                k * *static_deflection / gravity,
                ("Mass whose weight causes this deflection", RAO.at("§2.2")),
            );
            (mass, natural(k, with_springs(mass), sheet))
        }
    };
    answer_frequency(natural, matches!(load, SupportedLoadGiven::Frequency { .. }), sheet);
    let weight = match load {
        SupportedLoadGiven::Weight { weight } => *weight,
        _ => sheet.step("W", "N", mass * gravity, "Weight of the mass"),
    };
    let deflection = match load {
        SupportedLoadGiven::Deflection { static_deflection } => *static_deflection,
        _ => sheet.step("δ", "mm", weight / k, ("Static deflection under the weight", RAO.at("§2.2"))),
    };
    let moving_in_all = W::Num::sum(std::iter::once(mass).chain(moving.iter().copied()));
    sheet.verify(|| {
        sheet.check(
            "the maximum kinetic energy equals the maximum elastic energy",
            moving_in_all * natural.powi(2),
            k,
        );
        sheet.check(
            "natural frequency from the static deflection, ωₙ² = (g/δ) m/m'",
            (gravity / deflection * mass / moving_in_all).sqrt(),
            natural,
        );
    });
    shares(&whole, sheet, Some(Loaded::AtRest(deflection.value())));
    sheet.answer("mass", "Mass of the load", mass);
    sheet.answer("weight", "Weight of the load", weight);
    sheet.answer("static_deflection", "Static deflection", deflection);
    let springs_share = moving_in_all.value() - mass.value();
    sheet.show(|| {
        let curve = |mass: f64| (k.value() / (mass + springs_share)).sqrt();
        Exhibit::Plot(
            against_load(mass.value(), curve, Axis::linear("mass of the load", "kg"))
                .over("motion.translation.load.mass.mass"),
        )
    });
    Ok(())
}

fn rotation<W: Worksheet>(
    springs: &TorsionalSpringGiven<W>,
    body: Option<&TorsionalBodyGiven<W>>,
    shaft_inertia: Option<W::Num>,
    sheet: W,
) -> Result<(), Refusal> {
    let whole = torsional::network(springs, sheet, &[])?;
    let k = whole.stiffness;
    sheet.answer("torsional_stiffness", "Equivalent torsional stiffness", k);
    let Some(body) = body else {
        shares(&whole, sheet, None);
        return Ok(());
    };
    let shaft = shaft_inertia.filter(|inertia| inertia.value() > 0.0).map(|inertia| {
        sheet.common_error("J_e", "the whole moment of inertia of the shaft taken", || inertia);
        sheet.step(
            "J_e",
            "kg*m^2",
            inertia / 3.0,
            ("Effective inertia of the shaft: one third, at the moving end", RAO.at("§1.8")),
        )
    });
    let (inertia, natural) = match body {
        TorsionalBodyGiven::Frequency { natural_frequency } => {
            let all = sdof::mass_from_natural_frequency(k, *natural_frequency);
            let why = ("Moment of inertia that has this natural frequency on the springs", RAO.at("§2.3"));
            let inertia = match shaft {
                None => sheet.step("J", "kg*m^2", all, why),
                Some(shaft) => {
                    let all = sheet.step("J'", "kg*m^2", all, why);
                    let rest = all - shaft;
                    if rest.value() <= 0.0 {
                        return Err(Refusal::because(
                            "the natural frequency of the shaft alone is below the required one: write a lower frequency or a lighter shaft",
                        ));
                    }
                    sheet.common_error("J", "the moment of inertia of the shaft neglected", || all);
                    sheet.step(
                        "J",
                        "kg*m^2",
                        rest,
                        "Remaining inertia of the body, after subtracting the rotating part of the shaft",
                    )
                }
            };
            (inertia, *natural_frequency)
        }
        TorsionalBodyGiven::Known { inertia } => {
            let inertia = moment_of_inertia(inertia, sheet, "J".into());
            let all = match shaft {
                None => inertia,
                Some(shaft) => {
                    sheet.common_error("J'", "the moment of inertia of the shaft neglected", || inertia);
                    sheet.step(
                        "J'",
                        "kg*m^2",
                        inertia + shaft,
                        ("Total rotating moment of inertia: the kinetic energies add up", RAO.at("§1.8")),
                    )
                }
            };
            (inertia, natural(k, all, sheet))
        }
    };
    answer_frequency(natural, matches!(body, TorsionalBodyGiven::Frequency { .. }), sheet);
    let turning = shaft.map_or(inertia, |shaft| inertia + shaft);
    sheet.verify(|| {
        sheet.check(
            "the maximum kinetic energy equals the maximum elastic energy",
            turning * natural.powi(2),
            k,
        );
    });
    shares(&whole, sheet, None);
    sheet.answer("inertia", "Moment of inertia of the body", inertia);
    let shaft = turning.value() - inertia.value();
    sheet.show(|| {
        let curve = |inertia: f64| (k.value() / (inertia + shaft)).sqrt();
        Exhibit::Plot(
            against_load(inertia.value(), curve, Axis::linear("moment of inertia of the body", "kg*m^2"))
                .over("motion.rotation.body.known.inertia.given.inertia"),
        )
    });
    Ok(())
}

/// The spring for a mass and a natural frequency.
fn sought<W: Worksheet>(mass: W::Num, natural: W::Num, gravity: W::Num, sheet: W) {
    let k = sheet.step(
        "k",
        "kN/m",
        sdof::stiffness_from_natural_frequency(mass, natural),
        ("Stiffness that gives the mass this natural frequency", RAO.at("§2.2")),
    );
    answer_frequency(natural, true, sheet);
    let deflection =
        sheet.step("δ", "mm", mass * gravity / k, ("Static deflection under the weight", RAO.at("§2.2")));
    sheet.verify(|| {
        sheet.check("natural frequency from the static deflection", (gravity / deflection).sqrt(), natural);
    });
    sheet.answer("stiffness", "Stiffness of the spring", k);
    sheet.answer("static_deflection", "Static deflection", deflection);
}

fn natural<W: Worksheet>(k: W::Num, inertia: W::Num, sheet: W) -> W::Num {
    let why = ("Natural frequency without damping", RAO.at("§2.2"));
    sheet.step("ωₙ", "rad/s", sdof::natural_frequency(k, inertia), why)
}

/// Writes and answers the natural frequency in cycles, unless it was given, and its period.
fn answer_frequency<W: Worksheet>(natural: W::Num, given: bool, sheet: W) {
    sheet.answer("natural_frequency", "Natural frequency", natural);
    if !given {
        let frequency = sheet.step("fₙ", "Hz", natural, "The same frequency in Hz");
        sheet.answer("frequency", "Natural frequency in hertz", frequency);
    }
    let period = sheet.step("Tₙ", "s", W::Num::from(TAU) / natural, "Period of the free motion");
    sheet.answer("period", "Period", period);
}

/// The natural frequency over a range about the load.
fn against_load(load: f64, natural: impl Fn(f64) -> f64, x: Axis) -> Plot {
    let at = |n: u16| {
        let part = load * (0.2 + f64::from(n) / 100.0);
        (part, natural(part))
    };
    Plot::new(
        "Natural frequency against the load",
        x,
        Axis::linear("natural frequency", "Hz"),
        vec![Series::line("fₙ", (0..=280).map(at).collect()).of("natural_frequency")],
    )
    .mark("this load", (load, natural(load)))
}

/// The network under its support, with what it carries.
fn sketched<T: Suspended>(springs: &T, carried: Option<(&'static str, &'static str)>) -> Drawing {
    let (width, height) = sketch::size(springs);
    let half = (width / 2.0).max(0.9);
    let mut sketch = Sketch::new("The springs and the body they support");
    let stands = sketch::stands_alone(springs);
    // The force on a beam alone acts near it.
    let height = if stands && carried.is_none() { 0.5 * height } else { height };
    if !stands {
        sketch.ground((half, 0.0), (-half, 0.0));
    }
    sketch::hanging(springs, (0.0, 0.0), height, &[], &mut sketch);
    let low = -height;
    match carried {
        Some(("J", turn)) => {
            turning::disc(&mut sketch, "J", (0.0, low - 0.2));
            turning::turn(&mut sketch, turn, (0.0, low - 0.55), 0.9, Ink::Motion);
            &mut sketch
        }
        Some((mass, motion)) => sketch.mass(mass, (-0.7, low - 0.9), (0.7, low)).motion(
            motion,
            (1.0, low - 0.2),
            (1.0, low - 0.9),
        ),
        None => sketch.force("F", (0.0, low), (0.0, low - 0.5)),
    };
    sketch.finish()
}
