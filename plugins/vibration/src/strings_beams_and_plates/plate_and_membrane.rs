//! Free vibration of thin plates and of stretched membranes.

mod pictures;

use std::f64::consts::FRAC_PI_2;

use dalembert_core::{
    About, Analysis, Cell, Column, Exhibit, Inputs, Refusal, TableExhibit, Text, Worksheet, register,
};
use dalembert_mechanics::{
    Real,
    beam::dynamic_stiffness::BeamError,
    vibration::plate::{Edge, Levy, Round, rectangular_membrane},
};

use self::pictures::{Figure, Outline as Shown};
use crate::{
    shared::continuous::overtone_errors,
    sources::{ABRAMOWITZ, LEISSA, RAO},
};

/// The body and how many of its frequencies are wanted.
#[derive(Clone, Debug, Inputs)]
pub struct PlateAndMembrane {
    /// Vibrating system.
    pub body: ThinBody,
    /// Number of frequencies.
    #[input(min = 1, max = 12, default = "6")]
    pub modes: usize,
}

/// A thin body.
#[derive(Clone, Debug, Inputs)]
pub enum ThinBody {
    /// Membrane: under tension, without bending stiffness
    Membrane {
        /// Tension.
        /// Force per unit length of the edge.
        #[input("T", "N/m", positive)]
        tension: f64,
        /// Mass of the membrane.
        mass: SurfaceMass,
        /// Outline.
        /// Fixed along the whole edge.
        outline: MembraneOutline,
    },
    /// Thin plate
    Plate {
        /// Young's modulus.
        #[input("E", "Pa", positive)]
        young: f64,
        /// Poisson's ratio.
        #[input("ν", "1", min = 0, max = 0.5, default = "0.3")]
        poisson: f64,
        /// Thickness.
        #[input("h", "m", positive)]
        thickness: f64,
        /// Density.
        #[input("ρ", "kg/m^3", positive)]
        density: f64,
        /// Additional mass per unit area.
        /// Of what lies on the plate and does not stiffen it.
        #[input("μ₊", "kg/m^2", nonnegative)]
        carried: Option<f64>,
        /// Outline and edges.
        outline: PlateOutline,
    },
}

/// Mass of each area of a membrane.
#[derive(Clone, Debug, Inputs)]
pub enum SurfaceMass {
    /// Mass per unit area given
    PerArea {
        /// Mass per unit area.
        #[input("μ", "kg/m^2", positive)]
        mass: f64,
    },
    /// Density and thickness
    Density {
        /// Density.
        #[input("ρ", "kg/m^3", positive)]
        density: f64,
        /// Thickness.
        #[input("h", "m", positive)]
        thickness: f64,
    },
}

/// The edge of a membrane.
#[derive(Clone, Debug, Inputs)]
pub enum MembraneOutline {
    /// Rectangle
    Rectangle {
        /// Length.
        #[input("a", "m", positive)]
        length: f64,
        /// Width.
        #[input("b", "m", positive)]
        breadth: f64,
    },
    /// Circle
    Circle {
        /// Radius.
        #[input("R", "m", positive)]
        radius: f64,
    },
}

/// The edges of a plate.
#[derive(Clone, Debug, Inputs)]
pub enum PlateOutline {
    /// Rectangle with two opposite edges simply supported
    Rectangle {
        /// Length between the two simply supported edges.
        #[input("a", "m", positive)]
        length: f64,
        /// Width between the other two edges.
        #[input("b", "m", positive)]
        breadth: f64,
        /// First of the other two edges.
        first: PlateEdge,
        /// Second of the other two edges.
        second: PlateEdge,
    },
    /// Circle
    Circle {
        /// Radius.
        #[input("R", "m", positive)]
        radius: f64,
        /// Edge.
        edge: PlateEdge,
    },
}

/// Support condition of an edge.
#[derive(Clone, Debug, PartialEq, Inputs)]
pub enum PlateEdge {
    /// Simply supported edge
    Simple,
    /// Clamped edge
    Clamped,
    /// Free edge
    Free,
}

register!(PlateAndMembrane);

/// Beyond this ratio of its sides a rectangle is a strip.
const MOST_ASPECT: f64 = 100.0;

impl Analysis for PlateAndMembrane {
    const ABOUT: About = About {
        id: "vibration/plate-and-membrane",
        title: "Vibration of plates and membranes",
        topic: "Strings, beams and plates",
        summary: "Exact frequencies and nodal lines of rectangular and circular membranes, circular plates, and rectangular plates with two opposite edges simply supported.",
        main: &["frequency"],
        keywords: "membrane drum plate circular rectangular Navier Levy Bessel Chladni nodal lines membrana tambor \
                   placa circular retangular linhas nodais chapa",
        sources: &[&LEISSA, &RAO, &ABRAMOWITZ],
        cases: include_str!("../../cases/plate_and_membrane.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &PlateAndMembraneGiven<W>, sheet: W) -> Result<(), Refusal> {
        let figures = match &given.body {
            ThinBodyGiven::Membrane { tension, mass, outline } => {
                let mass = match mass {
                    SurfaceMassGiven::PerArea { mass } => *mass,
                    SurfaceMassGiven::Density { density, thickness } => {
                        let why = "Mass per unit area: density times thickness";
                        sheet.step("μ", "kg/m^2", *density * *thickness, why)
                    }
                };
                let speed = sheet.step(
                    "c",
                    "m/s",
                    (*tension / mass).sqrt(),
                    ("Speed of waves on the membrane", RAO.at("§8.6")),
                );
                match outline {
                    MembraneOutlineGiven::Rectangle { length, breadth } => {
                        self.rectangular_membrane(*length, *breadth, speed, sheet)?
                    }
                    MembraneOutlineGiven::Circle { radius } => {
                        let unit = sheet.step(
                            "Ω",
                            "rad/s",
                            speed / *radius,
                            "The frequencies are multiples of the speed over the radius",
                        );
                        self.round(Round::Membrane, unit, sheet)?
                    }
                }
            }
            ThinBodyGiven::Plate { young, poisson, thickness, density, carried, outline } => {
                let rigidity = sheet.step(
                    "D",
                    "N*m",
                    *young * thickness.powi(3) / ((W::Num::from(1.0) - poisson.powi(2)) * 12.0),
                    ("Bending stiffness of the plate", LEISSA.at("ch. 1")),
                );
                let own = *density * *thickness;
                let (mass, why) = match carried {
                    Some(carried) => {
                        (own + *carried, "Mass per unit area: that of the plate and what it carries")
                    }
                    None => (own, "Mass per unit area: density times thickness"),
                };
                let mass = sheet.step("μ", "kg/m^2", mass, why);
                let side = match outline {
                    PlateOutlineGiven::Rectangle { length, .. } => *length,
                    PlateOutlineGiven::Circle { radius, .. } => *radius,
                };
                let unit = sheet.step(
                    "Ω",
                    "rad/s",
                    (rigidity / mass).sqrt() / side.powi(2),
                    (
                        "The frequencies are multiples of √(D/μ) over the square of the length",
                        LEISSA.at("ch. 1"),
                    ),
                );
                self.thickness_warning(sheet);
                self.plate(*poisson, unit, sheet)?
            }
        };
        sheet.show(|| table(&figures));
        let outline = self.outline();
        sheet.show(|| pictures::outline(self));
        sheet.show(|| pictures::nodal_lines(&figures, outline));
        for figure in figures.iter().take(3) {
            sheet.show(|| pictures::animation(figure, outline));
        }
        Ok(())
    }
}

impl PlateAndMembrane {
    fn rectangular_membrane<W: Worksheet>(
        &self,
        length: W::Num,
        breadth: W::Num,
        speed: W::Num,
        sheet: W,
    ) -> Result<Vec<Figure>, Refusal> {
        let aspect = length.value() / breadth.value();
        strip(aspect)?;
        let (mut figures, mut first) = (Vec::new(), None);
        for (k, [m, n]) in (1..).zip(rectangular_membrane::patterns(aspect, self.modes)) {
            let half = |count: usize, side: W::Num| (W::Num::from(count as f64) / side).powi(2);
            overtone_errors(k, first, false, sheet);
            let omega = sheet.step(
                ("ω", k),
                "rad/s",
                speed * (half(m, length) + half(n, breadth)).sqrt() * std::f64::consts::PI,
                (
                    Text::new("Mode of {m} × {n} half waves along a and b: ω = πc√((m/a)² + (n/b)²)")
                        .with("m", m)
                        .with("n", n),
                    RAO.at("§8.6"),
                ),
            );
            first = first.or(Some(omega));
            let frequency = frequency(k, omega, [m, n], "Half waves along a and along b", sheet);
            sheet.verify(|| {
                let quotient =
                    rectangular_membrane::quotient(m) + rectangular_membrane::quotient(n) * aspect.powi(2);
                sheet.check(
                    Text::new("mode shape {n}: energy of the tension over kinetic energy").with("n", k),
                    W::Num::from(quotient),
                    (omega * length / speed).powi(2),
                );
            });
            figures.push(Figure::sines([m, n], frequency.value()));
        }
        Ok(figures)
    }

    fn plate<W: Worksheet>(&self, poisson: W::Num, unit: W::Num, sheet: W) -> Result<Vec<Figure>, Refusal> {
        let ThinBody::Plate { outline, .. } = &self.body else { return Ok(Vec::new()) };
        let poisson = poisson.value();
        match outline {
            PlateOutline::Circle { edge, .. } => {
                if *edge == PlateEdge::Free {
                    sheet.warn(|| {
                        Text::new("the plate can move as a rigid body: its three motions at frequency zero are not counted")
                    });
                }
                self.round(Round::Plate { edge: of(edge), poisson }, unit, sheet)
            }
            PlateOutline::Rectangle { length, breadth, first, second } => {
                let aspect = length / breadth;
                strip(aspect)?;
                let plate = Levy { aspect, sides: [of(first), of(second)], poisson };
                self.rectangle(&plate, unit, sheet)
            }
        }
    }

    /// A rectangular plate with two opposite edges simply supported.
    fn rectangle<W: Worksheet>(&self, plate: &Levy, unit: W::Num, sheet: W) -> Result<Vec<Figure>, Refusal> {
        let modes = plate.modes(self.modes).map_err(|err| refusal(&err))?;
        let (mut figures, mut first) = (Vec::new(), None);
        for (k, mode) in (1..).zip(modes) {
            sheet.keep_going()?;
            let number = sheet.numerical(
                ("Λ", k),
                "1",
                mode.number,
                (
                    Text::new(
                        "Lévy: w = Y(y) sin({m}πx/a) gives an ordinary differential equation for Y, a beam under tension on a foundation; its root {n}, counted exactly",
                    )
                    .with("m", mode.half_waves)
                    .with("n", mode.place),
                    LEISSA.at("§4.2"),
                ),
            );
            if k == 1 {
                let strip = || unit * std::f64::consts::PI.powi(2);
                let words = "the plate taken as a strip of the length a, pinned at its ends";
                sheet.common_error(("ω", k), words, strip);
            }
            overtone_errors(k, first, false, sheet);
            let omega =
                sheet.step(("ω", k), "rad/s", number * unit, Text::new("Natural frequency {n}").with("n", k));
            first = first.or(Some(omega));
            let pattern = [mode.half_waves, mode.place];
            let frequency =
                frequency(k, omega, pattern, "Half waves along a, and number of the shape across", sheet);
            sheet.answer(("number", k), "Frequency number Λ = ωa²√(μ/D)", number);
            sheet.verify(|| {
                sheet.check(
                    Text::new("mode shape {n}: bending and torsion energy over kinetic energy").with("n", k),
                    W::Num::from(mode.rayleigh_quotient(plate.aspect)),
                    number.powi(2),
                );
                if plate.sides == [Edge::Simple; 2] {
                    let [m, n] = pattern.map(|n| n as f64);
                    let exact = std::f64::consts::PI.powi(2) * (m * m + (n * plate.aspect).powi(2));
                    sheet.check(
                        Text::new("root {n} by Navier's double sine: π²(m² + (na/b)²)").with("n", k),
                        W::Num::from(exact),
                        number,
                    );
                }
            });
            figures.push(Figure::levy(mode, frequency.value()));
        }
        Ok(figures)
    }

    /// A circle: λ is the wave number times the radius.
    fn round<W: Worksheet>(&self, body: Round, unit: W::Num, sheet: W) -> Result<Vec<Figure>, Refusal> {
        let (mut figures, mut first) = (Vec::new(), None);
        let (why, cite) = match body {
            Round::Membrane => ("Zero {s} of the Bessel function J of order {n}", ABRAMOWITZ.at("§9.5")),
            Round::Plate { edge: Edge::Clamped, .. } => (
                "Root {s} of J_n(λ) I_n'(λ) − I_n(λ) J_n'(λ) = 0 for n = {n}: no deflection, no slope at the edge",
                LEISSA.at("ch. 2"),
            ),
            Round::Plate { edge: Edge::Simple, .. } => (
                "Root {s} for n = {n} of the condition that deflection and radial moment vanish at the edge",
                LEISSA.at("ch. 2"),
            ),
            Round::Plate { edge: Edge::Free, .. } => (
                "Root {s} for n = {n} of the condition that radial moment and edge force vanish",
                LEISSA.at("ch. 2"),
            ),
        };
        // The lowest number of a string or a beam as long as the diameter.
        let across = match body {
            Round::Membrane => Some((FRAC_PI_2, "the membrane taken as a string across its diameter")),
            Round::Plate { edge: Edge::Clamped, .. } => Some((5.593_321, AS_BEAM)),
            Round::Plate { edge: Edge::Simple, .. } => Some((FRAC_PI_2.powi(2), AS_BEAM)),
            Round::Plate { edge: Edge::Free, .. } => None,
        };
        for (k, mode) in (1..).zip(body.modes(self.modes)) {
            sheet.keep_going()?;
            let why = Text::new(why).with("s", mode.place).with("n", mode.diameters);
            let root = sheet.numerical(("λ", k), "1", mode.root, (why, cite));
            let reason = Text::new("Natural frequency {n}").with("n", k);
            if let (1, Some((number, words))) = (k, across) {
                sheet.common_error(("ω", k), words, || unit * number);
            }
            overtone_errors(k, first, false, sheet);
            let (number, omega) = match body {
                Round::Membrane => (root, sheet.step(("ω", k), "rad/s", root * unit, reason)),
                Round::Plate { .. } => {
                    let number =
                        sheet.step(("Λ", k), "1", root.powi(2), "Frequency number, the square of the root");
                    (number, sheet.step(("ω", k), "rad/s", number * unit, reason))
                }
            };
            first = first.or(Some(omega));
            let circles = mode.circles();
            let pattern = [mode.diameters, circles.len()];
            let frequency = frequency(k, omega, pattern, "Nodal diameters and nodal circles", sheet);
            let label = match body {
                Round::Membrane => "Zero of the Bessel function, λ = ωR/c",
                Round::Plate { .. } => "Frequency number Λ = ωR²√(μ/D)",
            };
            sheet.answer(("number", k), label, number);
            sheet.verify(|| {
                let text = match body {
                    Round::Membrane => Text::new("mode shape {n}: energy of the tension over kinetic energy"),
                    Round::Plate { .. } => {
                        Text::new("mode shape {n}: bending and torsion energy over kinetic energy")
                    }
                };
                let quotient = W::Num::from(mode.rayleigh_quotient());
                sheet.check(text.with("n", k), quotient, number.powi(2));
                sheet.check_zero(
                    Text::new("root {n} satisfies the frequency equation").with("n", k),
                    W::Num::from(body.residual(mode.diameters, mode.root)),
                    mode.root,
                );
            });
            figures.push(Figure::round(mode, frequency.value()));
        }
        Ok(figures)
    }

    fn outline(&self) -> Shown {
        match &self.body {
            ThinBody::Membrane { outline: MembraneOutline::Rectangle { length, breadth }, .. }
            | ThinBody::Plate { outline: PlateOutline::Rectangle { length, breadth, .. }, .. } => {
                let largest = length.max(*breadth);
                Shown::Rectangle(length / largest, breadth / largest)
            }
            _ => Shown::Circle,
        }
    }

    fn thickness_warning<W: Worksheet>(&self, sheet: W) {
        let ThinBody::Plate { thickness, outline, .. } = &self.body else { return };
        let smallest = match outline {
            PlateOutline::Rectangle { length, breadth, .. } => length.min(*breadth),
            PlateOutline::Circle { radius, .. } => 2.0 * radius,
        };
        if 20.0 * thickness > smallest {
            sheet.warn(|| {
                Text::new(
                    "the plate is thicker than one twentieth of its smaller side: shear and rotary inertia, neglected in thin-plate theory, lower its frequencies",
                )
            });
        }
    }
}

/// Common error of a round plate.
const AS_BEAM: &str = "the plate taken as a beam across its diameter";

/// The frequency in Hz, and the pattern, as answers.
fn frequency<W: Worksheet>(
    k: usize,
    omega: W::Num,
    pattern: [usize; 2],
    label: &'static str,
    sheet: W,
) -> W::Num {
    let frequency = sheet.step(("f", k), "Hz", omega, "In cycles per second");
    sheet.answer(("frequency", k), "Natural frequency", frequency);
    sheet.answer_list(("pattern", k), label, "1", &pattern.map(|count| count as f64));
    frequency
}

fn of(edge: &PlateEdge) -> Edge {
    match edge {
        PlateEdge::Simple => Edge::Simple,
        PlateEdge::Clamped => Edge::Clamped,
        PlateEdge::Free => Edge::Free,
    }
}

/// Refuses a rectangle that is a strip.
fn strip(aspect: f64) -> Result<(), Refusal> {
    if (MOST_ASPECT.recip()..=MOST_ASPECT).contains(&aspect) {
        return Ok(());
    }
    Err(Refusal::because(
        "one side is more than a hundred times the other: treat the strip as a string or as a beam",
    ))
}

fn refusal(err: &BeamError) -> Refusal {
    Refusal::because(match err {
        BeamError::TooSlender(_) => {
            "the mode shapes across the plate are too short for its width: choose fewer frequencies, or analyse the strip as a beam"
        }
        _ => "the frequencies of the plate cannot be found",
    })
}

/// The modes with their patterns and frequencies.
fn table(figures: &[Figure]) -> Exhibit {
    let [first, second]: [Text; 2] = match figures.first() {
        Some(Figure::Round { .. }) => ["nodal diameters".into(), "nodal circles".into()],
        _ => ["half waves along a".into(), "number across".into()],
    };
    let number = |n: usize| Cell::Text(Text::new("{n}").with("n", n));
    let row = |(n, figure): (usize, &Figure)| {
        let [a, b] = figure.pattern();
        vec![number(n), number(a), number(b), Cell::Number(figure.frequency())]
    };
    Exhibit::Table(TableExhibit {
        title: "Frequencies by nodal pattern".into(),
        columns: vec![
            Column { heading: "mode".into(), unit: "" },
            Column { heading: first, unit: "" },
            Column { heading: second, unit: "" },
            Column { heading: "frequency".into(), unit: "Hz" },
        ],
        rows: (1..).zip(figures).map(row).collect(),
        foot: Vec::new(),
    })
}
