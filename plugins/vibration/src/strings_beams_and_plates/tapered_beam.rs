//! A beam whose section changes linearly along it, by Rayleigh and Ritz.

use std::cell::OnceCell;

use dalembert_core::{
    About, Analysis, Axis, Cell, Column, Drawing, Exhibit, Inputs, Plot, Refusal, Series, Sketch,
    TableExhibit, Text, Worksheet, register,
};
use dalembert_mechanics::{
    Real,
    beam::tapered::{self, Ritz, Tapered},
    section,
};

use crate::{
    shared::continuous::{Sampled, draw_support, shapes_film, shapes_plot},
    sources::{BEER, RAO, TIMOSHENKO},
};

/// The beam, its taper and what holds it.
#[derive(Clone, Debug, Inputs)]
pub struct TaperedBeam {
    /// Length.
    #[input("L", "m", positive)]
    pub length: f64,
    /// Section at both ends.
    pub section: TaperedSection,
    /// Young's modulus.
    #[input("E", "Pa", positive)]
    pub young: f64,
    /// Density.
    #[input("ρ", "kg/m^3", positive)]
    pub density: f64,
    /// Left end.
    pub left: TaperedSupport,
    /// Right end.
    pub right: TaperedSupport,
    /// Number of frequencies.
    /// Rigid-body motions of an unsupported beam are not included.
    #[input(min = 1, max = 6, default = "3")]
    pub modes: usize,
}

/// A section that changes linearly from the left end to the right one.
#[derive(Clone, Debug, Inputs)]
pub enum TaperedSection {
    /// Rectangle
    Rectangle {
        /// Width at the left end.
        /// Perpendicular to the plane of bending.
        #[input("b₀", "m", positive)]
        breadth: f64,
        /// Width at the right end.
        /// Zero for a beam that is triangular in plan.
        #[input("b_L", "m", nonnegative)]
        end_breadth: f64,
        /// Height at the left end.
        /// In the plane of bending.
        #[input("h₀", "m", positive)]
        height: f64,
        /// Height at the right end.
        /// Zero for a wedge.
        #[input("h_L", "m", nonnegative)]
        end_height: f64,
    },
    /// Circular
    Round {
        /// Diameter at the left end.
        #[input("d₀", "m", positive)]
        diameter: f64,
        /// Diameter at the right end.
        /// Zero for a cone.
        #[input("d_L", "m", nonnegative)]
        end_diameter: f64,
    },
}

/// Support condition of an end.
#[derive(Clone, Debug, PartialEq, Inputs)]
pub enum TaperedSupport {
    /// Free
    Free,
    /// Pinned
    Pinned,
    /// Clamped
    Clamped,
}

register!(TaperedBeam);

/// Terms of the trial functions that the answers are found with.
const TERMS: usize = 24;

impl Analysis for TaperedBeam {
    const ABOUT: About = About {
        id: "vibration/tapered-beam",
        title: "Bending vibration of tapered beams",
        topic: "Strings, beams and plates",
        summary: "Frequencies and mode shapes of a beam with linearly varying width, height or diameter, including wedges and cones, by Rayleigh–Ritz with its convergence.",
        keywords: "variable section wedge cone triangular plate spring blade rayleigh ritz viga afilada variável \
                   cunha cone triangular pá lâmina",
        sources: &[&RAO, &TIMOSHENKO, &BEER],
        cases: include_str!("../../cases/tapered_beam.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &TaperedBeamGiven<W>, sheet: W) -> Result<(), Refusal> {
        let (area, second_moment, width, depth) = sections(&given.section, sheet);
        let beam = Tapered { width: width.value(), depth: depth.value(), supports: self.supports()? };
        let unit = sheet.step(
            "Ω",
            "rad/s",
            (given.young * second_moment / (given.density * area * given.length.powi(4))).sqrt(),
            "The frequencies are multiples of √(EI₀/(ρA₀L⁴)), with the section of the left end",
        );
        let wanted = self.modes + beam.rigid_motions();
        let not_found = |_| Refusal::because("the frequencies cannot be found: the taper is too strong");
        let ritz = |terms: usize| beam.ritz(terms, self.modes).map_err(not_found);
        let Ritz { lambdas, shapes } = ritz(TERMS)?;
        let before = ritz(TERMS - 3)?.lambdas;
        sheet.keep_going()?;
        for (n, (lambda, shape)) in (1..).zip(lambdas.iter().zip(&shapes)) {
            let settled = (lambda / before[n - 1] - 1.0).abs() < 1e-7;
            if !(*lambda > 0.0 && settled) {
                return Err(Refusal::because(
                    "the frequencies do not converge with more terms: the taper is too strong, choose fewer frequencies",
                ));
            }
            let number = sheet.numerical(
                ("Λ", n),
                "1",
                lambda.sqrt(),
                (
                    "Rayleigh–Ritz with polynomials that satisfy the supports: the minimum of strain energy over kinetic energy, a converged upper bound",
                    RAO.at("§8.8"),
                ),
            );
            let omega =
                sheet.step(("ω", n), "rad/s", number * unit, Text::new("Natural frequency {n}").with("n", n));
            let frequency = sheet.step(("f", n), "Hz", omega, "In cycles per second");
            sheet.verify(|| {
                sheet.check(
                    Text::new("mode shape {n}: the moments of its inertia forces store the same energy")
                        .with("n", n),
                    given.young * second_moment / (given.density * area * given.length.powi(4))
                        * beam.moment_quotient(shape).unwrap_or(f64::NAN),
                    omega.powi(2),
                );
            });
            sheet.answer(("frequency", n), "Natural frequency", frequency);
            sheet.answer(("number", n), "Frequency number Λ = ωL²√(ρA₀/(EI₀))", number);
            let nodes: Vec<f64> = shape.nodes().into_iter().map(|xi| xi * self.length).collect();
            if !nodes.is_empty() {
                sheet.answer_list(("nodes", n), "Nodes of mode", "m", &nodes);
            }
        }
        if beam.rigid_motions() > 0 {
            sheet.warn(|| {
                Text::new(
                    "the beam can move as a rigid body: {n} such motions at frequency zero precede the first frequency, and some books count them",
                )
                .with("n", beam.rigid_motions())
            });
        }
        let series = OnceCell::new();
        let series = || -> &Vec<(usize, Vec<f64>)> {
            let ritz = |terms: usize| Some((terms, beam.ritz(terms, self.modes).ok()?.lambdas));
            series.get_or_init(|| (wanted.max(2)..TERMS).step_by(3).filter_map(ritz).collect())
        };
        sheet.show(|| convergence(series(), self.modes, unit.value()));
        sheet.show(|| distance(series(), &lambdas));
        let sampled = || -> Vec<Sampled> {
            let one = |(n, shape): (usize, &tapered::RitzShape)| {
                Sampled::new(n, self.length, |xi| shape.deflection(xi))
            };
            (1..).zip(&shapes).map(one).collect()
        };
        sheet.show(|| shapes_plot(&sampled()));
        sheet.show(|| shapes_film(&sampled(), self.length, |sketch, width, y| self.ends(sketch, width, y)));
        sheet.show(|| Exhibit::Drawing(self.drawing(&beam)));
        Ok(())
    }
}

impl TaperedBeam {
    fn supports(&self) -> Result<[tapered::EndSupport; 2], Refusal> {
        let pointed = match self.section {
            TaperedSection::Rectangle { end_breadth, end_height, .. } => {
                end_breadth == 0.0 || end_height == 0.0
            }
            TaperedSection::Round { end_diameter, .. } => end_diameter == 0.0,
        };
        if pointed && self.right != TaperedSupport::Free {
            return Err(Refusal::because(
                "a right end that tapers to a point or an edge cannot be supported: leave it free, or give it a section",
            ));
        }
        Ok([&self.left, &self.right].map(|support| match support {
            TaperedSupport::Free => tapered::EndSupport::Free,
            TaperedSupport::Pinned => tapered::EndSupport::Pinned,
            TaperedSupport::Clamped => tapered::EndSupport::Clamped,
        }))
    }

    /// Draws the supports of a beam from `(0, y)` to `(width, y)`.
    fn ends(&self, sketch: &mut Sketch, width: f64, y: f64) {
        let held = |support: &TaperedSupport| match support {
            TaperedSupport::Free => (false, false),
            TaperedSupport::Pinned => (true, false),
            TaperedSupport::Clamped => (true, true),
        };
        draw_support(sketch, held(&self.left), (0.0, y), true);
        draw_support(sketch, held(&self.right), (width, y), false);
    }

    /// The beam from the side, and from above where its width changes.
    fn drawing(&self, beam: &Tapered) -> Drawing {
        let width = 6.0;
        let outline = |y: f64, ratio: f64| {
            let (left, right) = (0.45, 0.45 * ratio.min(3.0));
            [(0.0, y - left), (0.0, y + left), (width, y + right), (width, y - right)]
        };
        let mut sketch = Sketch::new("The beam and its taper");
        sketch.body("", outline(0.0, beam.depth)).label("side view", (width, 0.0));
        self.ends(&mut sketch, width, 0.0);
        if beam.width != 1.0 {
            sketch.body("", outline(-1.8, beam.width)).label("top view", (width, -1.8));
        }
        sketch.finish()
    }
}

/// Area and second moment at the left end, and the ratios of width and height of the ends.
fn sections<W: Worksheet>(given: &TaperedSectionGiven<W>, sheet: W) -> (W::Num, W::Num, W::Num, W::Num) {
    let (area, second_moment, width, depth) = match given {
        TaperedSectionGiven::Rectangle { breadth, end_breadth, height, end_height } => (
            section::rectangle_area(*breadth, *height),
            section::rectangle_second_moment(*breadth, *height),
            sheet.step("β_b", "1", *end_breadth / *breadth, "Width of the right end over that of the left"),
            sheet.step("β_h", "1", *end_height / *height, "Ratio of right-end to left-end height"),
        ),
        TaperedSectionGiven::Round { diameter, end_diameter } => {
            let ratio = *end_diameter / *diameter;
            let ratio = sheet.step("β_d", "1", ratio, "Diameter of the right end over that of the left");
            (section::round_area(*diameter), section::round_second_moment(*diameter), ratio, ratio)
        }
    };
    let area = sheet.step("A₀", "cm^2", area, ("Area of the left end", BEER.at("app. A")));
    let second_moment =
        sheet.step("I₀", "cm^4", second_moment, ("Second moment of area of the left end", BEER.at("app. A")));
    (area, second_moment, width, depth)
}

/// The frequencies with more and more terms.
fn convergence(series: &[(usize, Vec<f64>)], modes: usize, unit: f64) -> Exhibit {
    let mut columns = vec![Column { heading: "terms".into(), unit: "1" }];
    columns.extend((1..=modes).map(|n| Column { heading: Text::new("mode {n}").with("n", n), unit: "Hz" }));
    let row = |(terms, lambdas): &(usize, Vec<f64>)| {
        let cell = |n: usize| lambdas.get(n).map_or(Cell::Empty, |lambda| Cell::Number(lambda.sqrt() * unit));
        std::iter::once(Cell::Number(*terms as f64)).chain((0..modes).map(cell)).collect()
    };
    Exhibit::Table(TableExhibit {
        title: "Frequencies with more terms".into(),
        columns,
        rows: series.iter().map(row).collect(),
        foot: Vec::new(),
    })
}

/// Plot of the difference of each frequency from the converged one, without rounding noise.
fn distance(series: &[(usize, Vec<f64>)], settled: &[f64]) -> Exhibit {
    let line = |n: usize| {
        let point = |(terms, lambdas): &(usize, Vec<f64>)| {
            let off = (lambdas.get(n)? / settled[n]).sqrt() - 1.0;
            (off > 1e-12).then_some((*terms as f64, off))
        };
        Series::line(Text::new("mode {n}").with("n", n + 1), series.iter().filter_map(point).collect())
    };
    Exhibit::Plot(Plot::new(
        "Frequency error relative to the converged value",
        Axis::linear("terms", "1"),
        Axis::log("relative distance", "1"),
        (0..settled.len()).map(line).collect(),
    ))
}
