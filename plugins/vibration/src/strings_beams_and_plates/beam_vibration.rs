//! Bending vibration of a uniform beam on any supports.

use dalembert_core::{
    About, Analysis, Axis, Exhibit, Inputs, Plot, Refusal, Series, Sketch, Text, Worksheet, register,
};
use dalembert_mechanics::{
    Real,
    beam::dynamic_stiffness::{Beam, BeamError, BeamStation},
};

mod drawing;
mod lumped;
mod sprung;

use self::sprung::{SprungBeam, SprungMass, SprungShape};
use crate::{
    shared::{
        continuous::{
            LineMass, Sampled, ShearModulus, draw_support, line_mass, overtone_errors, shapes_film,
            shapes_plot, shear_modulus,
        },
        section::{Profile, RoundSection, profile, shear_coefficient},
        support::{Restraint, Support},
    },
    sources::{BLEVINS, COWPER, RAO, TIMOSHENKO, WITTRICK},
};

/// The beam, what holds it, and what it carries.
#[derive(Clone, Debug, Inputs)]
pub struct BeamVibration {
    /// Length.
    #[input("L", "m", positive)]
    pub length: f64,
    /// Section.
    pub section: Profile,
    /// Young's modulus.
    #[input("E", "Pa", positive)]
    pub young: f64,
    /// Mass of the beam.
    pub mass: LineMass,
    /// Theory.
    pub theory: Theory,
    /// Left end.
    pub left: Support,
    /// Right end.
    pub right: Support,
    /// Axial force.
    /// Tension is positive, compression negative.
    #[input("N", "N")]
    pub axial: Option<f64>,
    /// Elastic foundation.
    /// Ground reaction per unit length of the beam and unit deflection.
    #[input("k_f", "N/m^2", nonnegative)]
    pub foundation: Option<f64>,
    /// Masses, springs and supports along the beam.
    pub attachments: Vec<Attachment>,
    /// Number of frequencies.
    /// Rigid-body motions of an unsupported beam are not included.
    #[input(min = 1, max = 10, default = "4")]
    pub modes: usize,
}

/// Beam theory: with or without shear deformation and rotary inertia.
#[derive(Clone, Debug, Inputs)]
pub enum Theory {
    /// Bending alone (Euler–Bernoulli)
    EulerBernoulli,
    /// Bending, shear and rotary inertia (Timoshenko)
    Timoshenko {
        /// Shear modulus.
        shear: ShearModulus,
        /// Shear coefficient.
        coefficient: ShearCoefficient,
    },
}

/// The shear coefficient of the section.
#[derive(Clone, Debug, Inputs)]
pub enum ShearCoefficient {
    /// Shear coefficient given
    Given {
        /// Shear coefficient.
        #[input("κ", "1", positive, max = 1)]
        coefficient: f64,
    },
    /// Cowper's, for the section
    Cowper {
        /// Poisson's ratio.
        #[input("ν", "1", min = 0, max = 0.5)]
        poisson: f64,
    },
}

/// Body or support at a place of the beam.
#[derive(Clone, Debug, Inputs)]
pub struct Attachment {
    /// Distance from the left end.
    #[input("x", "m", nonnegative)]
    pub distance: f64,
    /// Attached part.
    pub part: AttachedPart,
}

/// Something fixed to the beam.
#[derive(Clone, Debug, Inputs)]
pub enum AttachedPart {
    /// Mass
    Mass {
        /// Mass.
        #[input("m", "kg", positive)]
        mass: f64,
        /// Moment of inertia about its centre.
        #[input("J", "kg*m^2", nonnegative)]
        inertia: Option<f64>,
    },
    /// Spring to the ground
    Spring {
        /// Stiffness.
        #[input("k", "N/m", positive)]
        stiffness: f64,
    },
    /// Rotational spring to the ground
    RotationSpring {
        /// Rotational stiffness.
        #[input("k_t", "N*m/rad", positive)]
        stiffness: f64,
    },
    /// Support that allows rotation of the beam
    Pin,
    /// Mass on a spring
    /// It vibrates on the beam, across it.
    SprungMass {
        /// Mass.
        #[input("m", "kg", positive)]
        mass: f64,
        /// Stiffness of its spring.
        #[input("k", "N/m", positive)]
        stiffness: f64,
    },
}

register!(BeamVibration);

impl Analysis for BeamVibration {
    const ABOUT: About = About {
        id: "vibration/beam-vibration",
        title: "Bending vibration of beams",
        topic: "Strings, beams and plates",
        summary: "Frequencies, mode shapes, nodes and buckling load of a uniform beam (Euler–Bernoulli or Timoshenko) on any supports, with masses, springs, masses on springs, axial force and elastic foundation.",
        main: &["frequency"],
        keywords: "continuous beam natural frequencies mode shapes cantilever tip mass sprung mass oscillator \
                   spring-mass buckling viga frequências naturais modos engastada biapoiada flambagem contínuo \
                   fundação elástica lateral vibration of beams transverse vibration bending vibration vibração \
                   lateral de vigas transversal flexão engastada-livre bi-engastada biengastada",
        sources: &[&RAO, &BLEVINS, &TIMOSHENKO, &COWPER, &WITTRICK],
        cases: include_str!("../../cases/beam_vibration.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &BeamVibrationGiven<W>, sheet: W) -> Result<(), Refusal> {
        let (area, second_moment) = profile(&given.section, 0, sheet)?;
        let line = line_mass(&given.mass, 0, area, sheet);
        let length = given.length;
        let bending = sheet.step("EI", "N*m^2", given.young * second_moment, "Bending stiffness");
        let unit = sheet.step(
            "Ω",
            "rad/s",
            (bending / (line * length.powi(4))).sqrt(),
            ("The frequencies are multiples of √(EI/(m̄L⁴))", RAO.at("§8.5")),
        );
        let Sections { shear, rotary } = theory(given, area, second_moment, bending, sheet)?;
        let axial = given.axial.map(|force| {
            let ratio = force * length.powi(2) / bending;
            sheet.step("n", "1", ratio, ("Axial force over EI/L²", RAO.at("§8.5")))
        });
        let foundation = given.foundation.map(|stiffness| {
            let ratio = stiffness * length.powi(4) / bending;
            sheet.step("κ_f", "1", ratio, "Foundation over EI/L⁴")
        });
        let beam = Beam {
            shear: shear.map_or(0.0, Real::value),
            rotary: rotary.map_or(0.0, Real::value),
            axial: axial.map_or(0.0, Real::value),
            foundation: foundation.map_or(0.0, Real::value),
            stations: self.stations(bending.value(), (line * length).value())?,
        };
        buckling(&beam, bending, length, given.axial, sheet)?;
        let sprung = self.sprung(&beam, bending.value(), (line * length).value())?;
        let whole = SprungBeam { beam: &beam, sprung: &sprung };
        let roots = whole.roots(self.modes).map_err(|err| refusal(&err))?;
        let shapes: Vec<SprungShape> = roots
            .iter()
            .map(|root| whole.shape(*root))
            .collect::<Result<_, _>>()
            .map_err(|err| refusal(&err))?;
        let why = self.equation(&beam);
        let mut first = None;
        for (n, (root, shape)) in (1..).zip(roots.iter().zip(&shapes)) {
            sheet.keep_going()?;
            let cite = if why.1 { RAO.at("§8.5") } else { WITTRICK.at("pp. 263–284") };
            let beta = sheet.numerical(("β", n), "1", *root, (why.0.clone(), cite));
            if n == 1 {
                self.lumped_errors(given, unit, line * length, sheet);
            }
            overtone_errors(n, first, true, sheet);
            let omega = sheet.step(
                ("ω", n),
                "rad/s",
                beta.powi(2) * unit,
                Text::new("Natural frequency {n}").with("n", n),
            );
            first = first.or(Some(omega));
            let frequency = sheet.step(("f", n), "Hz", omega, "In cycles per second");
            sheet.verify(|| {
                if why.1 {
                    let residual = classical(&beam, *root).unwrap_or(f64::NAN);
                    sheet.check_zero(
                        Text::new("root {n} satisfies the frequency equation").with("n", n),
                        W::Num::from(residual),
                        *root,
                    );
                } else if let Some(expected) = pinned(&beam, n)
                    && sprung.is_empty()
                {
                    sheet.check(
                        Text::new("root {n} by the closed form of a beam pinned at both ends").with("n", n),
                        W::Num::from(expected),
                        beta.powi(4),
                    );
                }
                sheet.check(
                    Text::new("mode shape {n}: strain energy over kinetic energy is ω²").with("n", n),
                    bending / (line * length.powi(4)) * whole.quotient(shape),
                    omega.powi(2),
                );
                if let Some(other) = shapes.get(n) {
                    let size =
                        (whole.inertia_product(shape, shape) * whole.inertia_product(other, other)).sqrt();
                    sheet.check_residual(
                        Text::new("mode shapes {n} and {m} are orthogonal").with("n", n).with("m", n + 1),
                        W::Num::from(whole.inertia_product(shape, other)),
                        size,
                        size * (shape.shape.rounding() + other.shape.rounding()),
                    );
                }
            });
            sheet.answer(("frequency", n), "Natural frequency", frequency);
            sheet.answer(("root", n), "Root β with ω = β²√(EI/(m̄L⁴))", beta);
            let nodes: Vec<f64> = shape.shape.nodes().into_iter().map(|xi| xi * self.length).collect();
            if !nodes.is_empty() {
                sheet.answer_list(("nodes", n), "Nodes of mode", "m", &nodes);
            }
            if !sprung.is_empty() {
                sheet.answer_list(("sprung", n), "Masses on springs in mode", "1", &shape.masses);
            }
        }
        self.warnings(&beam, sheet);
        sheet.show(|| frequency_function(&whole, &roots));
        let sampled = || -> Vec<Sampled> {
            let one = |(n, shape): (usize, &SprungShape)| {
                Sampled::new(n, self.length, |xi| shape.shape.state(xi).deflection)
            };
            (1..).zip(&shapes).map(one).collect()
        };
        sheet.show(|| shapes_plot(&sampled()));
        sheet.show(|| Exhibit::Drawing(self.drawing()));
        sheet.show(|| {
            shapes_film(&sampled(), self.length, |sketch, width, y| stations(&whole, sketch, width, y))
        });
        Ok(())
    }
}

impl BeamVibration {
    /// Supports and lumped elements along the beam, in units of the beam.
    fn stations(&self, bending: f64, mass: f64) -> Result<Vec<BeamStation>, Refusal> {
        let length = self.length;
        let end = |at: f64, support: &Support| {
            let Restraint { held, clamped, spring, turning_spring } = support.restraint(length, bending);
            BeamStation { at, held, clamped, spring, turning_spring, ..BeamStation::default() }
        };
        let mut stations = vec![end(0.0, &self.left), end(1.0, &self.right)];
        for attachment in &self.attachments {
            let at = attachment.distance / length;
            if at > 1.0 + 1e-9 {
                return Err(Refusal::because(
                    "an item lies beyond the right end of the beam: write a distance not greater than its length",
                ));
            }
            let near = stations.iter().position(|station| (station.at - at).abs() <= 1e-9);
            let place = near.unwrap_or_else(|| {
                let place = stations.partition_point(|station| station.at < at);
                stations.insert(place, BeamStation { at, ..BeamStation::default() });
                place
            });
            let station = &mut stations[place];
            match attachment.part {
                AttachedPart::Mass { mass: own, inertia } => {
                    station.mass += own / mass;
                    station.inertia += inertia.unwrap_or(0.0) / (mass * length.powi(2));
                }
                AttachedPart::Spring { stiffness } => station.spring += stiffness * length.powi(3) / bending,
                AttachedPart::RotationSpring { stiffness } => {
                    station.turning_spring += stiffness * length / bending;
                }
                AttachedPart::Pin => station.held = true,
                AttachedPart::SprungMass { .. } => {}
            }
        }
        Ok(stations)
    }

    /// The masses on springs, in units of the beam.
    fn sprung(&self, beam: &Beam, bending: f64, mass: f64) -> Result<Vec<SprungMass>, Refusal> {
        let mut all = Vec::new();
        for attachment in &self.attachments {
            let AttachedPart::SprungMass { mass: own, stiffness } = attachment.part else { continue };
            let at = attachment.distance / self.length;
            let near = |station: &BeamStation| (station.at - at).abs() <= 1e-9;
            let station = beam.stations.iter().position(near).expect("each item has a station");
            if beam.stations[station].held {
                return Err(Refusal::because(
                    "a mass on a spring stands on a support of the beam and vibrates alone: remove it",
                ));
            }
            let spring = stiffness * self.length.powi(3) / bending;
            all.push(SprungMass { station, mass: own / mass, spring });
        }
        Ok(all)
    }

    /// The frequency equation in words, and whether it is one of the classical ones.
    fn equation(&self, beam: &Beam) -> (Text, bool) {
        let sprung = |attachment: &Attachment| matches!(attachment.part, AttachedPart::SprungMass { .. });
        if classical(beam, 1.0).is_none() || self.attachments.iter().any(sprung) {
            let text = "Root of the determinant of the exact dynamic stiffness, with the frequencies below it counted";
            return (Text::new(text), false);
        }
        let text = match (&self.left, &self.right) {
            (Support::Free, Support::Free) | (Support::Clamped, Support::Clamped) => {
                "Root of cos β cosh β = 1, the equation of identical ends"
            }
            (Support::Clamped, Support::Free) | (Support::Free, Support::Clamped) => {
                "Root of cos β cosh β = −1, the equation of a cantilever"
            }
            (Support::Pinned, Support::Pinned) | (Support::Guided, Support::Guided) => "Root of sin β = 0",
            (Support::Pinned, Support::Guided) | (Support::Guided, Support::Pinned) => "Root of cos β = 0",
            (Support::Guided, _) | (_, Support::Guided) => {
                "Root of tan β = −tanh β, the equation of a guided end"
            }
            _ => "Root of tan β = tanh β, the equation of a pinned end",
        };
        (Text::new(text), true)
    }

    fn warnings<W: Worksheet>(&self, beam: &Beam, sheet: W) {
        if beam.rigid_motions() > 0 {
            sheet.warn(|| {
                Text::new(
                    "the beam can move as a rigid body: {n} such motions at frequency zero precede the first frequency, and some books count them",
                )
                .with("n", beam.rigid_motions())
            });
        }
        let depth = match self.section {
            Profile::Round(
                RoundSection::Round { diameter: size } | RoundSection::Tube { outer: size, .. },
            ) => size,
            Profile::Rectangle { height, .. } => height,
            Profile::Given { area, second_moment } => (12.0 * second_moment / area).sqrt(),
        };
        if matches!(self.theory, Theory::EulerBernoulli) && depth * 10.0 > self.length {
            sheet.warn(|| {
                Text::new(
                    "the length of the beam is less than ten times its depth: shear and rotary inertia lower its frequencies; choose Timoshenko's theory",
                )
            });
        }
    }
}

/// Section effects of the beam theory: shear flexibility and rotary inertia, as shares of the beam.
struct Sections<N> {
    shear: Option<N>,
    rotary: Option<N>,
}

/// Shear flexibility and rotary inertia, as shares of the beam.
fn theory<W: Worksheet>(
    given: &BeamVibrationGiven<W>,
    area: W::Num,
    second_moment: W::Num,
    bending: W::Num,
    sheet: W,
) -> Result<Sections<W::Num>, Refusal> {
    let TheoryGiven::Timoshenko { shear, coefficient } = &given.theory else {
        return Ok(Sections { shear: None, rotary: None });
    };
    let modulus = shear_modulus(shear, sheet, "G");
    let coefficient = match coefficient {
        ShearCoefficientGiven::Given { coefficient } => *coefficient,
        ShearCoefficientGiven::Cowper { poisson } => shear_coefficient(&given.section, *poisson, sheet)
            .ok_or_else(|| {
                Refusal::because(
                    "Cowper's shear coefficient requires the shape of the section: enter the coefficient, or choose a section by its shape",
                )
            })?,
    };
    let length = given.length;
    let flexibility = bending / (coefficient * modulus * area * length.powi(2));
    let flexibility = sheet.step(
        "s",
        "1",
        flexibility,
        ("Shear flexibility of the beam over its bending flexibility", TIMOSHENKO.at("ch. 5")),
    );
    let rotary = second_moment / (area * length.powi(2));
    let rotary =
        sheet.step("j", "1", rotary, ("Rotary inertia of the sections over m̄L²", TIMOSHENKO.at("ch. 5")));
    Ok(Sections { shear: Some(flexibility), rotary: Some(rotary) })
}

/// The buckling load, where there is an axial force.
fn buckling<W: Worksheet>(
    beam: &Beam,
    bending: W::Num,
    length: W::Num,
    axial: Option<W::Num>,
    sheet: W,
) -> Result<(), Refusal> {
    let Some(force) = axial else { return Ok(()) };
    let Some(load) = beam.buckling_load().map_err(|err| refusal(&err))? else {
        if force.value() < 0.0 {
            return Err(Refusal::because(
                "the beam can move as a rigid body and cannot carry compression: add supports",
            ));
        }
        return Ok(());
    };
    let ratio = sheet.numerical(
        "p",
        "1",
        load,
        "Compression, over EI/L², at which the lowest frequency becomes zero: the beam buckles",
    );
    let pinned = || bending * std::f64::consts::PI.powi(2) / length.powi(2);
    sheet.common_error("N_cr", "Euler's load π²EI/L² of pinned ends used", pinned);
    let critical = sheet.step("N_cr", "kN", ratio * bending / length.powi(2), "Buckling load");
    sheet.answer("buckling_load", "Buckling load", critical);
    sheet.verify(|| {
        let pressed = |by: f64| {
            beam.buckles((critical * length.powi(2) / bending).value() * by).map_err(|err| refusal(&err))
        };
        let holds = matches!((pressed(1.0 - 1e-9), pressed(1.0 + 1e-9)), (Ok(false), Ok(true)));
        sheet.check_zero(
            "just below the buckling load all squares of frequencies are positive, just above it one is not",
            W::Num::from(if holds { 0.0 } else { 1.0 }),
            1.0,
        );
    });
    if -force.value() >= critical.value() {
        let text = Text::new("the beam buckles under this compression: write one below {load}")
            .with_quantity("load", critical.value(), "kN");
        return Err(Refusal::NoAnswer(text));
    }
    if force.value() >= 0.0 {
        return Ok(());
    }
    let share = sheet.step("N/N_cr", "%", -force / critical, "Compression over the buckling load");
    sheet.answer("buckling_share", "Compression over the buckling load", share);
    Ok(())
}

/// The classical frequency equation of a plain Euler–Bernoulli beam, over cosh β where it grows.
fn classical(beam: &Beam, beta: f64) -> Option<f64> {
    const FREE: (bool, bool) = (false, false);
    const PINNED: (bool, bool) = (true, false);
    const GUIDED: (bool, bool) = (false, true);
    const CLAMPED: (bool, bool) = (true, true);
    let plain = |at: &BeamStation| {
        let loaded = at.spring != 0.0 || at.turning_spring != 0.0 || at.mass != 0.0 || at.inertia != 0.0;
        (!loaded).then_some((at.held, at.clamped))
    };
    let [left, right] = beam.stations[..] else { return None };
    if beam.shear != 0.0 || beam.rotary != 0.0 || beam.axial != 0.0 || beam.foundation != 0.0 {
        return None;
    }
    let (sin, cos, tanh, sech) = (beta.sin(), beta.cos(), beta.tanh(), beta.cosh().recip());
    Some(match (plain(&left)?, plain(&right)?) {
        (FREE, FREE) | (CLAMPED, CLAMPED) => cos - sech,
        (FREE, CLAMPED) | (CLAMPED, FREE) => cos + sech,
        (PINNED, PINNED) | (GUIDED, GUIDED) => sin,
        (PINNED, GUIDED) | (GUIDED, PINNED) => cos,
        (GUIDED, _) | (_, GUIDED) => sin + cos * tanh,
        _ => sin - cos * tanh,
    })
}

/// `λ` of the mode with `n` half waves of a beam pinned at both ends without anything along it; `None` for others and
/// where frequencies of shear stand between those of bending.
fn pinned(beam: &Beam, n: usize) -> Option<f64> {
    let [left, right] = beam.stations[..] else { return None };
    let pin = |at: f64| BeamStation { at, held: true, ..BeamStation::default() };
    if left != pin(0.0) || right != pin(1.0) || beam.axial < 0.0 && beam.foundation > 0.0 {
        return None;
    }
    let q = (n as f64 * std::f64::consts::PI).powi(2);
    let still = beam.axial * q + beam.foundation;
    if beam.shear == 0.0 {
        return Some((q * q + still) / (1.0 + beam.rotary * q));
    }
    // s r λ² − (1 + s q + r q (1 + …)) λ + …: its smaller root.
    let (s, r) = (beam.shear, beam.rotary);
    let half = 0.5 * (1.0 + s * q + r * q + s * r * still);
    let product = s * r * (q * q + still * (1.0 + s * q));
    let lambda = (q * q + still * (1.0 + s * q)) / (half + (half * half - product).sqrt());
    (lambda * s * r < 1.0).then_some(lambda)
}

fn refusal(err: &BeamError) -> Refusal {
    Refusal::because(match err {
        BeamError::Buckled => "the beam buckles under its compression: write a smaller one",
        BeamError::TooSlender(_) => {
            "the beam is so slender, so highly tensioned or so heavily loaded that its bending cannot be resolved: treat it as a string or as a rigid body"
        }
        BeamError::OutOfRange | BeamError::NotConverged => {
            "the frequencies cannot be found: masses, springs and forces differ too much from those of the beam"
        }
    })
}

/// The frequency equation over β, with its roots.
fn frequency_function(beam: &SprungBeam<'_>, roots: &[f64]) -> Exhibit {
    let last = 1.05 * roots.last().copied().unwrap_or(1.0);
    let first = 0.02 * last;
    let at = |n: u16| {
        let beta = first + (last - first) * f64::from(n) / 180.0;
        (beta, beam.characteristic(beta).unwrap_or(f64::NAN))
    };
    let roots = roots.iter().map(|root| (*root, 0.0)).collect();
    Exhibit::Plot(
        Plot::new(
            "Frequency equation",
            Axis::linear("β, with ω = β²√(EI/(m̄L⁴))", "1"),
            Axis::linear("frequency function", "1"),
            vec![
                Series::line("frequency function", (0..=180).map(at).collect()),
                Series::dots("roots", roots),
            ],
        )
        .level("zero", 0.0),
    )
}

/// Draws supports and lumped elements along a beam from `(0, y)` to `(width, y)`.
fn stations(beam: &SprungBeam<'_>, sketch: &mut Sketch, width: f64, y: f64) {
    for sprung in beam.sprung {
        let x = beam.beam.stations[sprung.station].at * width;
        sketch.spring("", (x, y), (x, y + 0.6)).particle("", (x, y + 0.6));
    }
    for station in &beam.beam.stations {
        let x = station.at * width;
        draw_support(sketch, (station.held, station.clamped), (x, y), station.at == 0.0);
        if station.spring > 0.0 || station.turning_spring > 0.0 {
            sketch.spring("", (x, y - 0.8), (x, y));
        }
        if station.mass > 0.0 {
            sketch.particle("", (x, y));
        }
    }
}
