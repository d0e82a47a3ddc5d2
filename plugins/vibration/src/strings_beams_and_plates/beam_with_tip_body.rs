//! A cantilever with masses on rigid arms at its tip: bending, stretching and torsion together.

use dalembert_core::{
    About, Analysis, Cell, Column, Drawing, Exhibit, Ink, Inputs, Refusal, Sketch, TableExhibit, Text,
    Worksheet, register,
};
use dalembert_mechanics::{
    Real, Vector,
    beam::tip_body::{BeamMode, Bending, Cantilever, PointMass},
    section::{self, shear, torsion},
};
use nalgebra::Vector3;

use crate::{
    shared::{continuous::isotropic_shear, letters::of_row, section::RoundSection},
    sources::{BEER, BLEVINS, COWPER, WITTRICK},
};

/// The cantilever and the body at its tip.
#[derive(Clone, Debug, Inputs)]
pub struct BeamWithTipBody {
    /// Length.
    #[input("L", "m", positive)]
    pub length: f64,
    /// Section.
    pub section: TipSection,
    /// Young's modulus.
    #[input("E", "Pa", positive)]
    pub young: f64,
    /// Poisson's ratio.
    #[input("ν", "1", min = 0, max = 0.5)]
    pub poisson: f64,
    /// Density.
    #[input("ρ", "kg/m^3", positive)]
    pub density: f64,
    /// Theory of bending.
    pub theory: BendingTheory,
    /// Masses at the tip.
    /// On rigid arms without mass.
    #[input(min = 1)]
    pub masses: Vec<TipMass>,
    /// Number of frequencies.
    #[input(min = 1, max = 10, default = "6")]
    pub modes: usize,
}

/// The cross-section of a beam that bends in two planes and twists.
#[derive(Clone, Debug, Inputs)]
pub enum TipSection {
    /// Circular or tube
    #[input(flatten)]
    Round(RoundSection),
    /// Rectangle
    Rectangle {
        /// Side along y.
        #[input("b_y", "m", positive)]
        side_y: f64,
        /// Side along z.
        #[input("b_z", "m", positive)]
        side_z: f64,
    },
}

/// Bending theory: with or without shear deformation and rotary inertia.
#[derive(Clone, Debug, PartialEq, Inputs)]
pub enum BendingTheory {
    /// Bending alone (Euler–Bernoulli)
    EulerBernoulli,
    /// Bending, shear and rotary inertia (Timoshenko), with Cowper's shear coefficient
    Timoshenko,
}

/// A mass on a rigid arm.
#[derive(Clone, Debug, Inputs)]
pub struct TipMass {
    /// Mass.
    #[input("m", "kg", positive)]
    pub mass: f64,
    /// Position, from the tip.
    /// x continues along the beam axis, y and z are transverse.
    #[input("r", "m")]
    pub place: Vector3<f64>,
}

register!(BeamWithTipBody);

impl Analysis for BeamWithTipBody {
    const ABOUT: About = About {
        id: "vibration/beam-with-tip-body",
        title: "Cantilever with a rigid body at its tip",
        topic: "Strings, beams and plates",
        summary: "Frequencies and coupled motions (bending in two planes, axial, torsion) of a cantilever with masses on rigid arms at its tip.",
        main: &["frequency"],
        keywords: "continuous coupled bending torsion off-centre mass NAFEMS FV4 viga em balanço massa excêntrica \
                   flexão torção acopladas corpo rígido",
        sources: &[&BLEVINS, &WITTRICK, &BEER, &COWPER],
        cases: include_str!("../../cases/beam_with_tip_body.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &BeamWithTipBodyGiven<W>, sheet: W) -> Result<(), Refusal> {
        let timoshenko = self.theory == BendingTheory::Timoshenko;
        let shape = tip_section(&given.section, timoshenko.then_some(given.poisson), sheet)?;
        let length = given.length;
        let shear = isotropic_shear(given.young, given.poisson, sheet, "G");
        let line =
            sheet.step("m̄", "kg/m", given.density * shape.area, "Mass per unit length: density times area");
        let axial = sheet.step("EA", "MN", given.young * shape.area, "Stiffness along the axis");
        let twisting = sheet.step("GJ", "MN*m^2", shear * shape.torsion, "Torsional rigidity");
        let polar = given.density * (shape.moments[0] + shape.moments[1]);
        let polar = sheet.step("ρI_p", "kg*m", polar, "Moment of inertia per unit length about the axis");
        let mut bending = Vec::new();
        for (n, symbol) in [(0, "EI_z"), (1, "EI_y")] {
            let why = ["Bending stiffness in the plane xy", "Bending stiffness in the plane xz"][n];
            let stiffness = sheet.step(symbol, "MN*m^2", given.young * shape.moments[n], why);
            let (mut flexibility, mut rotary) = (0.0, 0.0);
            if let Some(kappa) = shape.shear {
                let s = stiffness / (kappa * shear * shape.area * length.powi(2));
                flexibility = sheet
                    .step(
                        ["s_z", "s_y"][n],
                        "1",
                        s,
                        "Shear flexibility of the beam over its bending flexibility",
                    )
                    .value();
                let j = shape.moments[n] / (shape.area * length.powi(2));
                rotary =
                    sheet.step(["j_z", "j_y"][n], "1", j, "Rotary inertia of the sections over m̄L²").value();
            }
            bending.push(Bending { stiffness: stiffness.value(), shear: flexibility, rotary });
        }
        let total = sheet.step(
            "m",
            "kg",
            W::Num::sum(given.masses.iter().map(|mass| mass.mass)),
            "Mass of the body at the tip",
        );
        let first = W::Vec::sum(given.masses.iter().map(|mass| mass.place * mass.mass));
        let centre = sheet.step_vector(
            "r_G",
            "m",
            first / total,
            "Centre of mass of the body: its offset from the axis couples the motions",
        );
        let beam = Cantilever {
            length: length.value(),
            line_mass: line.value(),
            axial: axial.value(),
            torsion: twisting.value(),
            polar: polar.value(),
            bending: [bending[0], bending[1]],
        };
        let body: Vec<PointMass> = self.masses.iter().map(|mass| (mass.mass, mass.place)).collect();
        sheet.keep_going()?;
        let modes = beam.modes(&body, self.modes).map_err(|_| {
            Refusal::because(
                "the frequencies cannot be found: the body at the tip differs too much from the mass or the size of the beam",
            )
        })?;
        for (n, mode) in (1..).zip(&modes) {
            let omega = sheet.numerical(
                ("ω", n),
                "rad/s",
                mode.frequency,
                (
                    "Root of the determinant of the exact stiffness of the beam at its tip and of the inertia of the \
                     body, with the frequencies below it counted",
                    WITTRICK.at("pp. 263–284"),
                ),
            );
            if n == 1 {
                let softer = || given.young * shape.moments[0].min(shape.moments[1]) * 3.0 / length.powi(3);
                let massless = || (softer() / total).sqrt();
                let words = "the body taken as a point mass at the tip of a beam without mass";
                sheet.common_error(("f", n), words, massless);
                let whole = || (softer() / (total + line * length)).sqrt();
                let words = "the whole mass of the beam added to the body as a point mass at the tip";
                sheet.common_error(("f", n), words, whole);
            }
            let frequency = sheet.step(("f", n), "Hz", omega, "In cycles per second");
            sheet.verify(|| {
                sheet.check_zero(
                    Text::new("vibration {n}: the forces of the beam and of the body at the tip balance")
                        .with("n", n),
                    W::Num::from(beam.left_over(&body, omega.value(), &mode.tip).unwrap_or(f64::NAN)),
                    1.0,
                );
            });
            sheet.answer(("frequency", n), "Natural frequency", frequency);
            let tip: Vec<f64> = mode.tip.iter().copied().map(clean).collect();
            sheet.answer_list(("tip", n), "Motion of the tip (u, θL) in mode", "1", &tip);
        }
        sheet.answer("mass", "Mass of the body", total);
        sheet.answer_vector("centre", "Centre of mass of the body", centre);
        sheet.verify(|| {
            let about = given.masses.iter().map(|mass| (mass.place - centre) * mass.mass);
            let moment = W::Vec::sum(about).magnitude();
            let size = self.masses.iter().map(|mass| mass.mass * mass.place.norm()).sum();
            sheet.check_zero("the moments of the masses about their centre cancel", moment, size);
        });
        sheet.show(|| motions(&modes));
        sheet.show(|| Exhibit::Drawing(self.drawing()));
        Ok(())
    }
}

/// Properties of a section.
struct SectionNumbers<N> {
    area: N,
    /// Second moments for bending in the planes xy and xz.
    moments: [N; 2],
    torsion: N,
    shear: Option<N>,
}

fn tip_section<W: Worksheet>(
    given: &TipSectionGiven<W>,
    poisson: Option<W::Num>,
    sheet: W,
) -> Result<SectionNumbers<W::Num>, Refusal> {
    let area = |area: W::Num| sheet.step("A", "cm^2", area, ("Area of the section", BEER.at("app. A")));
    let moment = |symbol: &'static str, moment: W::Num| {
        sheet.step(symbol, "cm^4", moment, ("Second moment of area", BEER.at("app. A")))
    };
    let kappa = |kappa: W::Num| {
        sheet.step("κ", "1", kappa, ("Shear coefficient of the section", COWPER.at("pp. 335–340")))
    };
    let polar_why =
        ("Polar second moment of area, of a round section also the torsion constant", BEER.at("app. A"));
    Ok(match given {
        TipSectionGiven::Round(round) => {
            round.check()?;
            let area = area(round.area());
            let moment = moment("I", round.second_moment());
            let torsion = sheet.step("J", "cm^4", round.polar_moment(), polar_why);
            let shear = poisson.map(|poisson| kappa(round.shear_coefficient(poisson, sheet, "d/D")));
            SectionNumbers { area, moments: [moment, moment], torsion, shear }
        }
        TipSectionGiven::Rectangle { side_y, side_z } => {
            let area = area(section::rectangle_area(*side_y, *side_z));
            let moments = [
                moment("I_z", section::rectangle_second_moment(*side_z, *side_y)),
                moment("I_y", section::rectangle_second_moment(*side_y, *side_z)),
            ];
            let torsion = sheet.numerical(
                "J",
                "cm^4",
                torsion::rectangle(side_y.value(), side_z.value()),
                ("Torsion constant of a rectangle, by Saint-Venant's series", BEER.at("ch. 3")),
            );
            let shear = poisson.map(|poisson| kappa(shear::rectangle(poisson)));
            SectionNumbers { area, moments, torsion, shear }
        }
    })
}

impl BeamWithTipBody {
    /// The beam and its masses in the plane xy.
    fn drawing(&self) -> Drawing {
        let length = 6.0;
        let reach = self.masses.iter().fold(0.0f64, |reach, mass| reach.max(mass.place.amax()));
        let scale = if reach > 0.0 { (2.0 / reach).min(length / self.length * 3.0) } else { 1.0 };
        let mut sketch = Sketch::new("The beam and its body in the plane xy");
        sketch.ground((0.0, 1.0), (0.0, -1.0)).mass("", (0.0, -0.1), (length, 0.1)).dimension(
            "L",
            (0.0, -0.5),
            (length, -0.5),
            -1.0,
        );
        for (n, mass) in (1..).zip(&self.masses) {
            let (x, y) = (length + scale * mass.place.x, scale * mass.place.y);
            sketch
                .axis((length, 0.0), (x, y))
                .vector(of_row(&["r"], n), (length, 0.0), (x, y), Ink::Faint)
                .mass("", (x - 0.2, y - 0.2), (x + 0.2, y + 0.2))
                .label(of_row(&["m"], n), (x, y));
        }
        match &self.section {
            TipSection::Round(section) => section.draw(&mut sketch, (-1.6, 0.0), 0.8),
            TipSection::Rectangle { .. } => {
                sketch.label("b_y, b_z", (0.4 * length, 0.1));
            }
        }
        sketch.finish()
    }
}

/// Flushes the rounding noise of a motion that is absent to zero.
fn clean(share: f64) -> f64 {
    if share.abs() < 1e-9 { 0.0 } else { share }
}

/// The motion of the tip in each vibration.
fn motions(modes: &[BeamMode]) -> Exhibit {
    let column = |heading: &'static str, unit| Column { heading: heading.into(), unit };
    let row = |(n, mode): (usize, &BeamMode)| {
        let mut row = vec![Cell::Number(n as f64), Cell::Number(mode.frequency)];
        row.extend(mode.tip.iter().map(|x| Cell::Number(clean(*x))));
        row
    };
    Exhibit::Table(TableExhibit {
        title: "Motion of the tip".into(),
        columns: vec![
            column("mode", "1"),
            column("frequency", "Hz"),
            column("u_x", "1"),
            column("u_y", "1"),
            column("u_z", "1"),
            column("θ_x L", "1"),
            column("θ_y L", "1"),
            column("θ_z L", "1"),
        ],
        rows: (1..).zip(modes).map(row).collect(),
        foot: Vec::new(),
    })
}
