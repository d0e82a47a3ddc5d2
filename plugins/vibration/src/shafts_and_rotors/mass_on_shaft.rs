//! A mass or flywheel on a light shaft: its longitudinal, transverse and torsional frequencies.

use std::f64::consts::PI;

use dalembert_core::{
    About, Analysis, Cell, Column, Drawing, Exhibit, Ink, Inputs, Refusal, Sketch, TableExhibit, Text,
    Worksheet, register,
};
use dalembert_mechanics::{Real, beam, sdof, section, spring};

use crate::{
    shared::{
        continuous::{ShearModulus, shear_modulus},
        letters::joined,
    },
    sources::{BEER, BEVAN, RAO, SHIGLEY},
};

/// The shaft, and what is fixed to it.
#[derive(Clone, Debug, Inputs)]
pub struct MassOnShaft {
    /// Body.
    pub body: ShaftBody,
    /// Support.
    pub support: ShaftSupport,
    /// Section.
    pub section: RoundSection,
    /// Young's modulus.
    #[input("E", "Pa", positive)]
    pub young: f64,
    /// Rotation of the body.
    /// For the torsional frequency.
    pub torsion: Option<Torsion>,
}

/// The body on the shaft.
#[derive(Clone, Debug, Inputs)]
pub enum ShaftBody {
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
        /// Gravity.
        #[input("g", "m/s^2", positive, default = "9.81 m/s^2")]
        gravity: f64,
    },
}

/// Supports of the shaft, and position of the body.
#[derive(Clone, Debug, Inputs)]
pub enum ShaftSupport {
    /// Fixed at one end, body at the other
    Cantilever {
        /// Length.
        #[input("L", "m", positive)]
        length: f64,
    },
    /// Fixed at both ends
    Clamped {
        /// From one end to the body.
        #[input("a", "m", positive)]
        left: f64,
        /// From the body to the other end.
        #[input("b", "m", positive)]
        right: f64,
    },
    /// Simply supported
    /// Free to turn and to slide: only the transverse frequency exists.
    SimplySupported {
        /// From one support to the body.
        #[input("a", "m", positive)]
        left: f64,
        /// From the body to the other support.
        #[input("b", "m", positive)]
        right: f64,
    },
    /// Fixed at one end, in a bearing at the other
    /// The bearing allows the shaft to rotate and slide.
    ClampedPinned {
        /// From the fixed end to the body.
        #[input("a", "m", positive)]
        left: f64,
        /// From the body to the bearing.
        #[input("b", "m", positive)]
        right: f64,
    },
}

/// The round section of a shaft.
#[derive(Clone, Debug, Inputs)]
pub enum RoundSection {
    /// Solid
    Solid {
        /// Diameter.
        #[input("d", "m", positive)]
        diameter: f64,
    },
    /// Hollow
    Hollow {
        /// Outer diameter.
        #[input("D", "m", positive)]
        outer: f64,
        /// Inner diameter.
        #[input("d", "m", positive)]
        inner: f64,
    },
}

/// Inputs of the torsional frequency.
#[derive(Clone, Debug, Inputs)]
pub struct Torsion {
    /// Radius of gyration of the body.
    /// About the axis of the shaft.
    #[input("κ", "m", positive)]
    pub radius: f64,
    /// Shear modulus.
    pub shear: ShearModulus,
}

register!(MassOnShaft);

impl Analysis for MassOnShaft {
    const ABOUT: About = About {
        id: "vibration/mass-on-shaft",
        title: "Mass on a shaft",
        topic: "Shafts and rotors",
        summary: "Longitudinal, transverse and torsional natural frequencies of a mass or flywheel on a light shaft.",
        main: &["transverse", "longitudinal", "torsional"],
        keywords: "flywheel longitudinal transverse torsional frequency shaft volante eixo frequência longitudinal \
                   transversal torcional",
        sources: &[&BEVAN, &RAO, &BEER, &SHIGLEY],
        cases: include_str!("../../cases/mass_on_shaft.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &MassOnShaftGiven<W>, sheet: W) -> Result<(), Refusal> {
        if let RoundSection::Hollow { outer, inner } = &self.section
            && inner >= outer
        {
            return Err(Refusal::because(
                "the inner diameter of the tube is not below the outer one: write the larger one as the outer",
            ));
        }
        let mass = match &given.body {
            ShaftBodyGiven::Mass { mass } => *mass,
            ShaftBodyGiven::Weight { weight, gravity } => {
                sheet.step("m", "kg", *weight / *gravity, "Mass of the weight")
            }
        };
        let mut found = Vec::new();
        if let Some(held) = held(&given.support) {
            let area = match &given.section {
                RoundSectionGiven::Solid { diameter } => section::round_area(*diameter),
                RoundSectionGiven::Hollow { outer, inner } => section::tube_area(*outer, *inner),
            };
            if let RoundSectionGiven::Hollow { outer, inner } = &given.section {
                let squared = || section::round_area(*outer - *inner);
                sheet.common_error("A", "the square of the difference of the diameters taken", squared);
            }
            let area = sheet.step("A", "cm^2", area, ("Area of the section", BEER.at("app. A")));
            let k = match held {
                Held::OneSide(length) => spring::axial(given.young, area, length),
                Held::BothSides(left, right) => {
                    spring::axial(given.young, area, left) + spring::axial(given.young, area, right)
                }
            };
            let why = match held {
                Held::OneSide(_) => ("Stiffness along the shaft", RAO.at("§1.7")),
                Held::BothSides(..) => {
                    ("Stiffness along the shaft: both parts have the same deflection", RAO.at("§1.7"))
                }
            };
            if let ShaftSupportGiven::ClampedPinned { left, right } = &given.support {
                let axial = |length: W::Num| spring::axial(given.young, area, length);
                let both = || axial(*left) + axial(*right);
                sheet.common_error("k_l", "the bearing taken to hold the shaft along its axis", both);
                let whole = || axial(*left + *right);
                sheet.common_error("k_l", "the whole length between the supports used", whole);
            }
            let k = sheet.step("k_l", "kN/m", k, why);
            let natural = sheet.step(
                "ω_l",
                "rad/s",
                sdof::natural_frequency(k, mass),
                ("Longitudinal natural frequency", RAO.at("§2.2")),
            );
            if matches!(held, Held::BothSides(..)) {
                sheet.check(
                    "longitudinal stiffness from the elastic energy of the parts of the shaft",
                    given.young * area / held.compliant_length(),
                    k,
                );
            }
            let frequency = sheet.step("f_l", "Hz", natural, COUNTED);
            sheet.answer("longitudinal_stiffness", "Longitudinal stiffness", k);
            sheet.answer("longitudinal", "Longitudinal frequency", frequency);
            sheet.check(
                "longitudinal: maximum kinetic energy = maximum elastic energy of the parts of the shaft",
                mass * frequency.powi(2),
                given.young * area / held.compliant_length(),
            );
            found.push(("longitudinal", frequency.value()));
        }
        found.push(("transverse", transverse(given, mass, sheet).value()));
        if let Some(torsion) = &given.torsion {
            match held(&given.support) {
                Some(held) => found.push(("torsional", torsional(given, torsion, held, mass, sheet).value())),
                None => sheet.warn(|| {
                    Text::new("a simply supported shaft can rotate freely: there is no torsional frequency")
                }),
            }
        }
        sheet.show(|| Exhibit::Drawing(self.drawing()));
        sheet.show(|| Exhibit::Table(summary(&found)));
        Ok(())
    }
}

const COUNTED: &str = "The same frequency in Hz";

/// The parts of a shaft that resist pulling and twisting, by their lengths.
#[derive(Clone, Copy)]
enum Held<N> {
    OneSide(N),
    BothSides(N, N),
}

fn held<W: Worksheet>(support: &ShaftSupportGiven<W>) -> Option<Held<W::Num>> {
    match support {
        ShaftSupportGiven::Cantilever { length } => Some(Held::OneSide(*length)),
        ShaftSupportGiven::ClampedPinned { left, .. } => Some(Held::OneSide(*left)),
        ShaftSupportGiven::Clamped { left, right } => Some(Held::BothSides(*left, *right)),
        ShaftSupportGiven::SimplySupported { .. } => None,
    }
}

impl<N: Real> Held<N> {
    /// The length of one part that would give as much, from the load that each part takes: `Σ share² length`.
    fn compliant_length(self) -> N {
        match self {
            Held::OneSide(length) => length,
            Held::BothSides(left, right) => {
                let span = left + right;
                (right / span).powi(2) * left + (left / span).powi(2) * right
            }
        }
    }
}

/// The transverse frequency.
fn transverse<W: Worksheet>(given: &MassOnShaftGiven<W>, mass: W::Num, sheet: W) -> W::Num {
    let moment = match &given.section {
        RoundSectionGiven::Solid { diameter } => section::round_second_moment(*diameter),
        RoundSectionGiven::Hollow { outer, inner } => section::tube_second_moment(*outer, *inner),
    };
    if let RoundSectionGiven::Hollow { outer, inner } = &given.section {
        let fourth = || section::round_second_moment(*outer - *inner);
        sheet.common_error("I", "the fourth power of the difference of the diameters taken", fourth);
    }
    let moment = sheet.step("I", "cm^4", moment, ("Second moment of area of the section", BEER.at("app. A")));
    let span = |left: W::Num, right: W::Num| sheet.step("l", "m", left + right, "Span");
    let young = given.young;
    // The bending moments under a unit force: at one end, at the force, at the other end.
    let (k, why, moments) = match &given.support {
        ShaftSupportGiven::Cantilever { length } => {
            let k = beam::cantilever(young, moment, *length);
            let zero = *length * 0.0;
            (
                k,
                ("Transverse stiffness at the tip of a cantilever", RAO.at("§1.7")),
                vec![(*length, *length, zero)],
            )
        }
        ShaftSupportGiven::SimplySupported { left, right } => {
            let (l, zero) = (span(*left, *right), *left * 0.0);
            let k = young * moment * l * 3.0 / (left.powi(2) * right.powi(2));
            let top = *left * *right / l;
            (
                k,
                ("Transverse stiffness of a simply supported shaft at the body", BEER.at("app. D")),
                vec![(*left, zero, top), (*right, top, zero)],
            )
        }
        ShaftSupportGiven::Clamped { left, right } => {
            let l = span(*left, *right);
            let k = young * moment * l.powi(3) * 3.0 / (left.powi(3) * right.powi(3));
            let top = left.powi(2) * right.powi(2) * 2.0 / l.powi(3);
            let ends = [*left * right.powi(2), left.powi(2) * *right].map(|part| -part / l.powi(2));
            (
                k,
                ("Transverse stiffness at the body of a shaft fixed at both ends", SHIGLEY.at("table A-9")),
                vec![(*left, ends[0], top), (*right, top, ends[1])],
            )
        }
        ShaftSupportGiven::ClampedPinned { left, right } => {
            let l = span(*left, *right);
            let k = beam::clamped_pinned(young, moment, l, *left);
            let reaction = left.powi(2) * (l * 3.0 - *left) / (l.powi(3) * 2.0);
            (
                k,
                (
                    "Transverse stiffness at the body of a shaft fixed at one end and in a bearing at the other",
                    SHIGLEY.at("table A-9"),
                ),
                vec![
                    (*left, reaction * l - *left, reaction * *right),
                    (*right, reaction * *right, *right * 0.0),
                ],
            )
        }
    };
    transverse_errors(given, moment, sheet);
    let k = sheet.step("k_q", "kN/m", k, why);
    let natural = sheet.step(
        "ω_q",
        "rad/s",
        sdof::natural_frequency(k, mass),
        ("Transverse natural frequency", RAO.at("§2.2")),
    );
    let frequency = sheet.step("f_q", "Hz", natural, COUNTED);
    sheet.verify(|| {
        let squares =
            moments.into_iter().map(|(length, p, q)| length * (p.powi(2) + p * q + q.powi(2)) / 3.0);
        sheet.check(
            "transverse stiffness from the elastic energy of the bending moments",
            young * moment / W::Num::sum(squares.clone().collect::<Vec<_>>()),
            k,
        );
        sheet.check(
            "transverse: maximum kinetic energy = maximum elastic energy of the bending moments",
            mass * frequency.powi(2),
            young * moment / W::Num::sum(squares.collect::<Vec<_>>()),
        );
    });
    sheet.answer("transverse_stiffness", "Transverse stiffness", k);
    sheet.answer("transverse", "Transverse frequency", frequency);
    frequency
}

/// The common errors of the transverse stiffness.
fn transverse_errors<W: Worksheet>(given: &MassOnShaftGiven<W>, moment: W::Num, sheet: W) {
    let young = given.young;
    match &given.support {
        ShaftSupportGiven::Cantilever { length } => {
            let guided = || beam::clamped_guided(young, moment, *length);
            sheet.common_error("k_q", "the stiffness 12EI/L³ of an end that cannot rotate used", guided);
            let spread = || young * moment * 8.0 / length.powi(3);
            sheet.common_error("k_q", "the deflection under a uniformly distributed load used", spread);
        }
        ShaftSupportGiven::SimplySupported { left, right } => {
            let middle = || beam::simply_supported_middle(young, moment, *left + *right);
            sheet.common_error("k_q", "the stiffness for a body at midspan used", middle);
        }
        ShaftSupportGiven::Clamped { left, right } => {
            let middle = || beam::clamped_clamped_middle(young, moment, *left + *right);
            sheet.common_error("k_q", "the stiffness for a body at midspan used", middle);
            let parallel =
                || beam::cantilever(young, moment, *left) + beam::cantilever(young, moment, *right);
            sheet.common_error("k_q", "the two parts taken as cantilevers in parallel", parallel);
        }
        ShaftSupportGiven::ClampedPinned { left, right } => {
            let middle = || beam::clamped_pinned_middle(young, moment, *left + *right);
            sheet.common_error("k_q", "the stiffness for a body at midspan used", middle);
            let alone = || beam::cantilever(young, moment, *left);
            sheet.common_error("k_q", "the bearing left out, the fixed part taken as a cantilever", alone);
        }
    }
}

/// The torsional frequency.
fn torsional<W: Worksheet>(
    given: &MassOnShaftGiven<W>,
    torsion: &TorsionGiven<W>,
    held: Held<W::Num>,
    mass: W::Num,
    sheet: W,
) -> W::Num {
    let polar = match &given.section {
        RoundSectionGiven::Solid { diameter } => section::round_polar_moment(*diameter),
        RoundSectionGiven::Hollow { outer, inner } => section::tube_polar_moment(*outer, *inner),
    };
    if let RoundSectionGiven::Hollow { outer, inner } = &given.section {
        let fourth = || section::round_polar_moment(*outer - *inner);
        sheet.common_error("I_p", "the fourth power of the difference of the diameters taken", fourth);
    }
    let polar =
        sheet.step("I_p", "cm^4", polar, ("Polar second moment of area of the section", BEER.at("app. A")));
    let shear = shear_modulus(&torsion.shear, sheet, "G");
    let k = match held {
        Held::OneSide(length) => spring::torsional(shear, polar, length),
        Held::BothSides(left, right) => {
            spring::torsional(shear, polar, left) + spring::torsional(shear, polar, right)
        }
    };
    let why = match held {
        Held::OneSide(_) => ("Torsional stiffness of the shaft", RAO.at("§1.7")),
        Held::BothSides(..) => {
            ("Torsional stiffness: both parts of the shaft have the same twist", RAO.at("§1.7"))
        }
    };
    if let ShaftSupportGiven::ClampedPinned { left, right } = &given.support {
        let twisted = |length: W::Num| spring::torsional(shear, polar, length);
        let both = || twisted(*left) + twisted(*right);
        sheet.common_error("k_t", "the bearing taken to keep the end of the shaft from rotating", both);
        let whole = || twisted(*left + *right);
        sheet.common_error("k_t", "the whole length between the supports used", whole);
    }
    let k = sheet.step("k_t", "N*m/rad", k, why);
    let inertia = sheet.step(
        "J",
        "kg*m^2",
        mass * torsion.radius.powi(2),
        "Moment of inertia from the radius of gyration",
    );
    let natural = sheet.step(
        "ω_t",
        "rad/s",
        sdof::natural_frequency(k, inertia),
        ("Torsional natural frequency", RAO.at("§2.3")),
    );
    if matches!(held, Held::BothSides(..)) {
        sheet.check(
            "torsional stiffness from the elastic energy of the parts of the shaft",
            shear * polar / held.compliant_length(),
            k,
        );
    }
    let frequency = sheet.step("f_t", "Hz", natural, COUNTED);
    sheet.answer("torsional_stiffness", "Torsional stiffness", k);
    sheet.answer("torsional", "Torsional frequency", frequency);
    sheet.check(
        "torsional: maximum kinetic energy = maximum elastic energy of the parts of the shaft",
        mass * (torsion.radius * frequency).powi(2),
        shear * polar / held.compliant_length(),
    );
    frequency
}

fn summary(found: &[(&'static str, f64)]) -> TableExhibit {
    let column = |heading: &'static str, unit| Column { heading: heading.into(), unit };
    TableExhibit {
        title: "Frequencies of the body on the shaft".into(),
        columns: vec![
            column("motion", ""),
            column("frequency", "Hz"),
            column("per minute", "cpm"),
            column("ω", "rad/s"),
        ],
        rows: found
            .iter()
            .map(|(motion, natural)| {
                vec![(*motion).into(), Cell::Number(*natural), Cell::Number(*natural), Cell::Number(*natural)]
            })
            .collect(),
        foot: Vec::new(),
    }
}

impl MassOnShaft {
    /// The shaft with its body, to scale along its length.
    fn drawing(&self) -> Drawing {
        let (left, right) = match self.support {
            ShaftSupport::Cantilever { length } => (length, 0.0),
            ShaftSupport::Clamped { left, right }
            | ShaftSupport::SimplySupported { left, right }
            | ShaftSupport::ClampedPinned { left, right } => (left, right),
        };
        let scale = 8.0 / (left + right);
        let (at, end) = (left * scale, 8.0f64);
        let mut sketch = Sketch::new("The body on the shaft");
        let half = 0.12;
        sketch.mass("", (0.0, -half), (end.max(at), half));
        match self.support {
            ShaftSupport::SimplySupported { .. } => sketch.pin("", (0.0, 0.0)),
            _ => sketch.ground((0.0, 1.0), (0.0, -1.0)),
        };
        match self.support {
            ShaftSupport::Cantilever { .. } => &mut sketch,
            ShaftSupport::Clamped { .. } => sketch.ground((end, -1.0), (end, 1.0)),
            ShaftSupport::SimplySupported { .. } | ShaftSupport::ClampedPinned { .. } => {
                sketch.pin("", (end, 0.0))
            }
        };
        match self.support {
            ShaftSupport::Cantilever { .. } => sketch.dimension("L", (0.0, -1.2), (at, -1.2), -1.5),
            _ => sketch.dimension("a", (0.0, -1.2), (at, -1.2), -1.5).dimension(
                "b",
                (at, -1.2),
                (end, -1.2),
                -1.5,
            ),
        };
        let mass = match self.body {
            ShaftBody::Mass { .. } => "m",
            ShaftBody::Weight { .. } => "W",
        };
        let letters = joined(&[mass, if self.torsion.is_some() { "κ" } else { "" }]);
        let section = match self.section {
            RoundSection::Solid { .. } => "d",
            RoundSection::Hollow { .. } => "D, d",
        };
        sketch
            .label(section, (0.4 * at, half))
            .mass("", (at - 0.35, -1.2), (at + 0.35, 1.2))
            .label(letters, (at - 0.35, 1.2))
            .motion("y", (at, 1.3), (at, 2.1))
            .motion("u", (at + 0.45, 0.5), (at + 1.25, 0.5));
        if self.torsion.is_some() {
            let turn = |n: i32| {
                let (sin, cos) = (PI * (0.6 + 0.8 * f64::from(n) / 12.0)).sin_cos();
                (0.75 * at + 0.2 * cos, 0.6 * sin)
            };
            sketch.curve((0..12).map(turn).collect::<Vec<_>>(), Ink::Motion).motion("θ", turn(11), turn(12));
        }
        sketch.finish()
    }
}
