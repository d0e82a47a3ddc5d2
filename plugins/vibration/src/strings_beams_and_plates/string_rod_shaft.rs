//! Strings, rods, shafts and shear beams: bodies of one wave equation.

mod drawing;
mod lumped;

use dalembert_core::{
    About, Analysis, Axis, Exhibit, Inputs, Plot, Refusal, Series, Sketch, Text, Worksheet, register,
};
use dalembert_mechanics::{
    Real,
    section::{shear, torsion},
    vibration::wave,
};

use crate::{
    shared::{
        continuous::{
            LineMass, LineMassGiven, Sampled, ShearModulus, ShearModulusGiven, draw_support, line_mass,
            overtone_errors, shapes_film, shapes_plot, shear_modulus,
        },
        section::RoundSection,
    },
    sources::{BEER, BLEVINS, COWPER, RAO},
};

/// The body, what holds its ends, and how many frequencies are asked for.
#[derive(Clone, Debug, Inputs)]
pub struct StringRodShaft {
    /// Body.
    pub body: WaveCarrier,
    /// Length.
    #[input("L", "m", positive)]
    pub length: f64,
    /// Number of frequencies.
    /// Rigid-body motions of an unsupported body are not included.
    #[input(min = 1, max = 10, default = "3")]
    pub modes: usize,
}

/// Body that carries the waves: string, rod or shaft.
#[derive(Clone, Debug, Inputs)]
pub enum WaveCarrier {
    /// String or cable under tension
    String {
        /// Tension.
        #[input("T", "N", positive)]
        tension: f64,
        /// Mass.
        mass: LineMass,
        /// Area of the section.
        /// Needed with a density only.
        #[input("A", "m^2", positive)]
        area: Option<f64>,
        /// Left end.
        #[input("0")]
        left: BodyEnd,
        /// Right end.
        #[input("L")]
        right: BodyEnd,
    },
    /// Rod along its axis
    Rod {
        /// Young's modulus.
        #[input("E", "Pa", positive)]
        young: f64,
        /// Density.
        #[input("ρ", "kg/m^3", positive)]
        density: f64,
        /// Area of the section.
        /// Needed with a spring or a mass at an end only.
        #[input("A", "m^2", positive)]
        area: Option<f64>,
        /// Left end.
        #[input("0")]
        left: BodyEnd,
        /// Right end.
        #[input("L")]
        right: BodyEnd,
    },
    /// Shaft in torsion
    Shaft {
        /// Shear modulus.
        shear: ShearModulus,
        /// Density.
        #[input("ρ", "kg/m^3", positive)]
        density: f64,
        /// Section.
        section: TorsionSection,
        /// Left end.
        #[input("0")]
        left: TurningEnd,
        /// Right end.
        #[input("L")]
        right: TurningEnd,
    },
    /// Shear beam (no bending)
    /// Short and hollow, so that bending is negligible.
    ShearBeam {
        /// Shear modulus.
        shear: ShearModulus,
        /// Density.
        #[input("ρ", "kg/m^3", positive)]
        density: f64,
        /// Shear coefficient.
        coefficient: ShearCoefficient,
        /// Area of the section.
        /// Needed with a spring or a mass at an end only.
        #[input("A", "m^2", positive)]
        area: Option<f64>,
        /// Left end.
        #[input("0")]
        left: BodyEnd,
        /// Right end.
        #[input("L")]
        right: BodyEnd,
    },
}

/// An end that moves.
#[derive(Clone, Debug, Inputs)]
pub enum BodyEnd {
    /// Fixed
    Fixed,
    /// Free
    Free,
    /// Spring to the ground
    Spring {
        /// Stiffness.
        #[input("k", "N/m", positive)]
        stiffness: f64,
    },
    /// Mass
    Mass {
        /// Mass.
        #[input("m", "kg", positive)]
        mass: f64,
    },
    /// Mass on a spring to the ground
    SpringAndMass {
        /// Stiffness.
        #[input("k", "N/m", positive)]
        stiffness: f64,
        /// Mass.
        #[input("m", "kg", positive)]
        mass: f64,
    },
}

/// An end that turns.
#[derive(Clone, Debug, Inputs)]
pub enum TurningEnd {
    /// Fixed
    Fixed,
    /// Free
    Free,
    /// Torsion spring to the ground
    Spring {
        /// Torsional stiffness.
        #[input("k", "N*m/rad", positive)]
        stiffness: f64,
    },
    /// Disc
    Disc {
        /// Moment of inertia.
        #[input("J", "kg*m^2", positive)]
        inertia: f64,
    },
    /// Disc on a torsional spring to the ground
    SpringAndDisc {
        /// Torsional stiffness.
        #[input("k", "N*m/rad", positive)]
        stiffness: f64,
        /// Moment of inertia.
        #[input("J", "kg*m^2", positive)]
        inertia: f64,
    },
}

/// The cross-section of a shaft in torsion.
#[derive(Clone, Debug, Inputs)]
pub enum TorsionSection {
    /// Circular or tube
    #[input(flatten)]
    Round(RoundSection),
    /// Rectangle, free to warp
    Rectangle {
        /// One side.
        #[input("a", "m", positive)]
        breadth: f64,
        /// Other side.
        #[input("b", "m", positive)]
        height: f64,
    },
    /// Torsion constant and polar second moment given
    Given {
        /// Torsion constant.
        /// The torque is G J times the twist per unit length; for a circular section, J is the polar second moment.
        #[input("J", "m^4", positive)]
        torsion: f64,
        /// Polar second moment of area.
        /// The inertia per unit length is ρ times it.
        #[input("I_p", "m^4", positive)]
        polar: f64,
    },
}

/// The shear coefficient of a section.
#[derive(Clone, Debug, Inputs)]
pub enum ShearCoefficient {
    /// Shear coefficient given
    Given {
        /// Shear coefficient.
        #[input("κ", "1", positive, max = 1)]
        coefficient: f64,
    },
    /// Thin-walled square tube
    ThinSquareTube {
        /// Poisson's ratio.
        #[input("ν", "1", min = 0, max = 0.5)]
        poisson: f64,
    },
    /// Thin-walled circular tube
    ThinRoundTube {
        /// Poisson's ratio.
        #[input("ν", "1", min = 0, max = 0.5)]
        poisson: f64,
    },
    /// Rectangle
    Rectangle {
        /// Poisson's ratio.
        #[input("ν", "1", min = 0, max = 0.5)]
        poisson: f64,
    },
    /// Circular
    Round {
        /// Poisson's ratio.
        #[input("ν", "1", min = 0, max = 0.5)]
        poisson: f64,
    },
}

register!(StringRodShaft);

impl Analysis for StringRodShaft {
    const ABOUT: About = About {
        id: "vibration/string-rod-shaft",
        title: "Strings, rods, shafts and shear beams",
        topic: "Strings, beams and plates",
        summary: "Frequencies, mode shapes and nodes of a string under tension, a rod in axial vibration, a shaft in torsion or a shear beam, with fixed, free, sprung or mass-loaded ends.",
        main: &["frequency"],
        keywords: "continuous wave equation cable guitar drill pipe longitudinal axial torsional corda cabo barra \
                   eixo torção onda contínuo cisalhamento",
        sources: &[&RAO, &BLEVINS, &COWPER],
        cases: include_str!("../../cases/string_rod_shaft.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &StringRodShaftGiven<W>, sheet: W) -> Result<(), Refusal> {
        let body = body(&given.body, given.length, sheet)?;
        let ends = body.ends.map(|end| wave::WaveEnd {
            stiffness: end
                .ratio_of_stiffness
                .map_or(if end.fixed { f64::INFINITY } else { 0.0 }, Real::value),
            mass: end.ratio_of_mass.map_or(0.0, Real::value),
        });
        let roots = wave::roots(ends, self.modes).map_err(|_| {
            Refusal::because(
                "the frequencies cannot be found: the spring or the mass at an end differs too much from that of the body",
            )
        })?;
        sheet.answer("wave_speed", "Wave speed", body.speed);
        let why = equation(ends);
        let shapes: Vec<wave::WaveShape> = roots.iter().map(|root| wave::shape(ends, *root)).collect();
        let mut first = None;
        for (n, (root, shape)) in (1..).zip(roots.iter().zip(&shapes)) {
            sheet.keep_going()?;
            let beta = sheet.numerical(("β", n), "1", *root, (why.clone(), RAO.at("§§8.2–8.4")));
            if n == 1 {
                lumped::errors(&body, given.length, sheet);
            }
            overtone_errors(n, first, false, sheet);
            let omega = sheet.step(
                ("ω", n),
                "rad/s",
                beta * body.speed / given.length,
                Text::new("Natural frequency {n}").with("n", n),
            );
            first = first.or(Some(omega));
            let frequency = sheet.step(("f", n), "Hz", omega, "In cycles per second");
            sheet.verify(|| {
                sheet.check(
                    Text::new("mode shape {n}: strain energy over kinetic energy is ω²").with("n", n),
                    (body.speed / given.length).powi(2) * shape.rayleigh_quotient(ends),
                    omega.powi(2),
                );
                if let Some(other) = shapes.get(n) {
                    let size = shape.inertia_product(shape, ends) * other.inertia_product(other, ends);
                    sheet.check_zero(
                        Text::new("mode shapes {n} and {m} are orthogonal").with("n", n).with("m", n + 1),
                        W::Num::from(shape.inertia_product(other, ends)),
                        size.sqrt(),
                    );
                }
            });
            sheet.answer(("frequency", n), "Natural frequency", frequency);
            sheet.answer(("root", n), "Root β = ωL/c", beta);
            let nodes: Vec<f64> = shape.nodes().into_iter().map(|xi| xi * self.length).collect();
            if !nodes.is_empty() {
                sheet.answer_list(("nodes", n), "Nodes of mode", "m", &nodes);
            }
        }
        if wave::rigid_motions(ends) > 0 {
            sheet.warn(|| {
                Text::new(
                    "the body is unrestrained: its rigid-body motion, at frequency zero, precedes the first frequency, and some books count it as the first mode",
                )
            });
        }
        sheet.show(|| {
            let last = roots.last().copied().unwrap_or_default();
            Exhibit::Plot(frequency_function(ends, last))
        });
        let sampled = || -> Vec<Sampled> {
            (1..)
                .zip(&shapes)
                .map(|(n, shape)| Sampled::new(n, self.length, |xi| shape.deflection(xi)))
                .collect()
        };
        sheet.show(|| shapes_plot(&sampled()));
        sheet.show(|| Exhibit::Drawing(drawing::drawing(self, ends)));
        sheet.show(|| {
            shapes_film(&sampled(), self.length, |sketch, width, y| draw_ends(ends, sketch, width, y))
        });
        Ok(())
    }
}

/// A body of the wave equation.
struct WaveBody<N> {
    speed: N,
    ends: [EndRatios<N>; 2],
}

/// Mass and stiffness at an end, as shares of the body.
#[derive(Clone, Copy)]
struct EndRatios<N> {
    fixed: bool,
    ratio_of_stiffness: Option<N>,
    ratio_of_mass: Option<N>,
}

/// Wave speed and the ratios of the ends.
fn body<W: Worksheet>(
    given: &WaveCarrierGiven<W>,
    length: W::Num,
    sheet: W,
) -> Result<WaveBody<W::Num>, Refusal> {
    let need = |area: Option<W::Num>| {
        area.ok_or_else(|| {
            Refusal::because(
                "the area of the section is needed here: write it, since mass or ends depend on it",
            )
        })
    };
    match given {
        WaveCarrierGiven::String { tension, mass, area, left, right } => {
            let line = match mass {
                LineMassGiven::Density { .. } => line_mass(mass, 0, need(*area)?, sheet),
                // The mass of each length does not ask for the area.
                _ => line_mass(mass, 0, W::Num::from(1.0), sheet),
            };
            let speed = sheet.step(
                "c",
                "m/s",
                (*tension / line).sqrt(),
                ("Wave speed along a string under tension", RAO.at("§8.2")),
            );
            let ends = ends([moving(left), moving(right)], sheet, || {
                let stiffness = sheet.step("S", "N/m", *tension / length, "Stiffness of the string, T/L");
                Ok((stiffness, sheet.step("M", "kg", line * length, "Mass of the string")))
            })?;
            Ok(WaveBody { speed, ends })
        }
        WaveCarrierGiven::Rod { young, density, area, left, right } => {
            let speed = sheet.step(
                "c",
                "m/s",
                (*young / *density).sqrt(),
                ("Wave speed along a rod", RAO.at("§8.3")),
            );
            let ends = ends([moving(left), moving(right)], sheet, || {
                let area = need(*area)?;
                let stiffness = sheet.step("S", "N/m", *young * area / length, "Stiffness of the rod, EA/L");
                Ok((stiffness, sheet.step("M", "kg", *density * area * length, "Mass of the rod")))
            })?;
            Ok(WaveBody { speed, ends })
        }
        WaveCarrierGiven::Shaft { shear, density, section, left, right } => {
            let modulus = shear_modulus(shear, sheet, "G");
            let (torsion, polar) = torsion_section(section, sheet)?;
            let why = ("Torsional wave speed along a shaft", RAO.at("§8.4"));
            if let ShearModulusGiven::Isotropic { young, .. } = shear {
                let along = || (*young / *density).sqrt();
                sheet.common_error("c", "the speed of longitudinal waves, √(E/ρ), used", along);
            }
            if !matches!(section, TorsionSectionGiven::Round(_)) {
                let round = || (modulus / *density).sqrt();
                sheet.common_error("c", "the wave speed of a round shaft, √(G/ρ), used", round);
            }
            let speed = match section {
                TorsionSectionGiven::Round(_) => sheet.step("c", "m/s", (modulus / *density).sqrt(), why),
                _ => sheet.step("c", "m/s", (modulus * torsion / (*density * polar)).sqrt(), why),
            };
            let ends = ends([turning(left), turning(right)], sheet, || {
                let stiffness = modulus * torsion / length;
                let stiffness = sheet.step("S", "N*m/rad", stiffness, "Stiffness of the shaft, GJ/L");
                let inertia = *density * polar * length;
                let inertia = sheet.step("M", "kg*m^2", inertia, "Moment of inertia of the shaft, ρI_pL");
                Ok((stiffness, inertia))
            })?;
            Ok(WaveBody { speed, ends })
        }
        WaveCarrierGiven::ShearBeam { shear, density, coefficient, area, left, right } => {
            let modulus = shear_modulus(shear, sheet, "G");
            let kappa = shear_coefficient(coefficient, sheet);
            let speed = sheet.step(
                "c",
                "m/s",
                (kappa * modulus / *density).sqrt(),
                ("Shear wave speed along the beam", BLEVINS.at("ch. 8")),
            );
            let ends = ends([moving(left), moving(right)], sheet, || {
                let area = need(*area)?;
                let stiffness = kappa * modulus * area / length;
                let stiffness = sheet.step("S", "N/m", stiffness, "Shear stiffness of the beam, κGA/L");
                Ok((stiffness, sheet.step("M", "kg", *density * area * length, "Mass of the beam")))
            })?;
            Ok(WaveBody { speed, ends })
        }
    }
}

/// Mass and stiffness at an end.
#[derive(Clone, Copy)]
struct Carried<N> {
    fixed: bool,
    stiffness: Option<N>,
    mass: Option<N>,
}

fn moving<W: Worksheet>(end: &BodyEndGiven<W>) -> Carried<W::Num> {
    let none = Carried { fixed: false, stiffness: None, mass: None };
    match end {
        BodyEndGiven::Fixed {} => Carried { fixed: true, ..none },
        BodyEndGiven::Free {} => none,
        BodyEndGiven::Spring { stiffness } => Carried { stiffness: Some(*stiffness), ..none },
        BodyEndGiven::Mass { mass } => Carried { mass: Some(*mass), ..none },
        BodyEndGiven::SpringAndMass { stiffness, mass } => {
            Carried { stiffness: Some(*stiffness), mass: Some(*mass), ..none }
        }
    }
}

fn turning<W: Worksheet>(end: &TurningEndGiven<W>) -> Carried<W::Num> {
    let none = Carried { fixed: false, stiffness: None, mass: None };
    match end {
        TurningEndGiven::Fixed {} => Carried { fixed: true, ..none },
        TurningEndGiven::Free {} => none,
        TurningEndGiven::Spring { stiffness } => Carried { stiffness: Some(*stiffness), ..none },
        TurningEndGiven::Disc { inertia } => Carried { mass: Some(*inertia), ..none },
        TurningEndGiven::SpringAndDisc { stiffness, inertia } => {
            Carried { stiffness: Some(*stiffness), mass: Some(*inertia), ..none }
        }
    }
}

/// Springs and masses at the ends, over stiffness and mass of the body, which are only asked for where they are needed.
fn ends<W: Worksheet>(
    ends: [Carried<W::Num>; 2],
    sheet: W,
    whole: impl Fn() -> Result<(W::Num, W::Num), Refusal>,
) -> Result<[EndRatios<W::Num>; 2], Refusal> {
    let plain = ends.iter().all(|end| end.stiffness.is_none() && end.mass.is_none());
    if plain {
        let plain = |end: Carried<W::Num>| EndRatios {
            fixed: end.fixed,
            ratio_of_stiffness: None,
            ratio_of_mass: None,
        };
        return Ok(ends.map(plain));
    }
    let (stiffness, mass) = whole()?;
    let ratios = |end: Carried<W::Num>, kappa, mu| EndRatios {
        fixed: end.fixed,
        ratio_of_stiffness: end.stiffness.map(|k| {
            sheet.step(kappa, "1", k / stiffness, "Spring stiffness over the stiffness of the body")
        }),
        ratio_of_mass: end.mass.map(|m| {
            sheet.step(mu, "1", m / mass, "Attached inertia at the end over the inertia of the body")
        }),
    };
    Ok([ratios(ends[0], "κ₀", "μ₀"), ratios(ends[1], "κ_L", "μ_L")])
}

/// Torsion constant and polar second moment of a section, m⁴.
fn torsion_section<W: Worksheet>(
    given: &TorsionSectionGiven<W>,
    sheet: W,
) -> Result<(W::Num, W::Num), Refusal> {
    match given {
        TorsionSectionGiven::Round(round) => {
            round.check()?;
            let why = (
                "Polar second moment of area, of a round section also the torsion constant",
                BEER.at("app. A"),
            );
            let polar = sheet.step("I_p", "cm^4", round.polar_moment(), why);
            Ok((polar, polar))
        }
        TorsionSectionGiven::Rectangle { breadth, height } => {
            let (a, b) = (*breadth, *height);
            let constant = torsion::rectangle(a.value(), b.value());
            let torsion = sheet.numerical(
                "J",
                "cm^4",
                constant,
                ("Torsion constant of a rectangle, by Saint-Venant's series", BEER.at("ch. 3")),
            );
            let polar = a * b * (a.powi(2) + b.powi(2)) / 12.0;
            let polar = sheet.step("I_p", "cm^4", polar, ("Polar second moment of area", BEER.at("app. A")));
            Ok((torsion, polar))
        }
        TorsionSectionGiven::Given { torsion, polar } => Ok((*torsion, *polar)),
    }
}

fn shear_coefficient<W: Worksheet>(given: &ShearCoefficientGiven<W>, sheet: W) -> W::Num {
    let coefficient = match given {
        ShearCoefficientGiven::Given { coefficient } => return *coefficient,
        ShearCoefficientGiven::ThinSquareTube { poisson } => shear::thin_square_tube(*poisson),
        ShearCoefficientGiven::ThinRoundTube { poisson } => shear::thin_round_tube(*poisson),
        ShearCoefficientGiven::Rectangle { poisson } => shear::rectangle(*poisson),
        ShearCoefficientGiven::Round { poisson } => shear::round(*poisson),
    };
    sheet.step("κ", "1", coefficient, ("Shear coefficient of the section", COWPER.at("pp. 335–340")))
}

/// The frequency equation, in words.
fn equation(ends: [wave::WaveEnd; 2]) -> Text {
    let plain = |end: wave::WaveEnd| end == wave::WaveEnd::FIXED || end == wave::WaveEnd::FREE;
    Text::new(match ends {
        [a, b] if plain(a) && a == b => "Root of sin β = 0, the frequency equation of these ends",
        [a, b] if plain(a) && plain(b) => "Root of cos β = 0, the frequency equation of these ends",
        [wave::WaveEnd::FIXED, _] | [_, wave::WaveEnd::FIXED] => {
            "Root of (κ − μβ²) sin β + β cos β = 0, the frequency equation of these ends"
        }
        _ => {
            "Root of (g₀ g_L − β²) sin β + (g₀ + g_L) β cos β = 0, g = κ − μβ², the frequency equation of these ends"
        }
    })
}

/// The frequency equation over β, with its roots.
fn frequency_function(ends: [wave::WaveEnd; 2], last: f64) -> Plot {
    let end = 1.08 * last;
    let at = |n: u16| {
        let beta = end * f64::from(n) / 400.0;
        (beta, wave::characteristic(ends, beta))
    };
    let roots = wave::roots(ends, 10).unwrap_or_default();
    let roots = roots.into_iter().filter(|root| *root <= end).map(|root| (root, 0.0)).collect();
    Plot::new(
        "Frequency equation",
        Axis::linear("β = ωL/c", "1"),
        Axis::linear("frequency function", "1"),
        vec![Series::line("frequency function", (1..=400).map(at).collect()), Series::dots("roots", roots)],
    )
    .level("zero", 0.0)
}

/// Draws the supports of a body from `(0, y)` to `(width, y)`.
fn draw_ends(ends: [wave::WaveEnd; 2], sketch: &mut Sketch, width: f64, y: f64) {
    for (end, x, left_end) in [(ends[0], 0.0, true), (ends[1], width, false)] {
        if end.stiffness.is_infinite() {
            draw_support(sketch, (true, true), (x, y), left_end);
        } else if end.stiffness > 0.0 {
            sketch.spring("", (x, y - 0.8), (x, y));
        }
        if end.mass > 0.0 {
            sketch.particle("", (x, y));
        }
    }
}
