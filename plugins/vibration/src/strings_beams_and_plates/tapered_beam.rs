//! A beam whose section varies along it, linearly or by a table, by Rayleigh and Ritz.

use std::cell::OnceCell;

use dalembert_core::{
    About, Analysis, Axis, Cell, Column, Drawing, Exhibit, Inputs, Plot, Refusal, Series, Sketch,
    TableExhibit, Text, Worksheet, register,
};
use dalembert_mechanics::{
    Real,
    beam::{
        tapered::{EndSupport, Tapered},
        varying::{Interpolation, SectionPoint, Varying},
    },
    section,
};

mod model;

use self::model::{VaryingBeam, VaryingMode};

use crate::{
    shared::continuous::{Sampled, draw_support, overtone_errors, shapes_film, shapes_plot},
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

/// A section that changes linearly from the left end to the right one, or from point to point of a table.
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
    /// Table of a rectangle
    RectangleTable {
        /// Points.
        /// From the left end to the right one: distance, width, height.
        #[input(table)]
        points: Vec<RectanglePoint>,
        /// Variation between the points.
        between: TableInterpolation,
    },
    /// Table of a circular section
    RoundTable {
        /// Points.
        /// From the left end to the right one: distance, diameter.
        #[input(table)]
        points: Vec<RoundPoint>,
        /// Variation between the points.
        between: TableInterpolation,
    },
}

/// A section of a table.
#[derive(Clone, Debug, Inputs)]
pub struct RectanglePoint {
    /// Distance from the left end.
    #[input("x", "m", nonnegative)]
    pub distance: f64,
    /// Width.
    #[input("b", "m", positive)]
    pub breadth: f64,
    /// Height.
    #[input("h", "m", positive)]
    pub height: f64,
}

/// A circular section of a table.
#[derive(Clone, Debug, Inputs)]
pub struct RoundPoint {
    /// Distance from the left end.
    #[input("x", "m", nonnegative)]
    pub distance: f64,
    /// Diameter.
    #[input("d", "m", positive)]
    pub diameter: f64,
}

/// Variation of the dimensions between two points of a table.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Inputs)]
pub enum TableInterpolation {
    /// Linear
    Linear,
    /// Exponential
    Exponential,
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

/// More points would be a measured profile, whose frequencies those of some of them give as well.
const MOST_POINTS: usize = 30;

impl Analysis for TaperedBeam {
    const ABOUT: About = About {
        id: "vibration/tapered-beam",
        title: "Bending vibration of tapered beams",
        topic: "Strings, beams and plates",
        summary: "Frequencies and mode shapes of a beam whose width, height or diameter varies linearly, exponentially or by a table, wedges and cones included, by Rayleigh–Ritz with its convergence.",
        main: &["frequency"],
        keywords: "variable section exponential taper table SDLL10 wedge cone triangular plate spring blade rayleigh ritz viga afilada variável \
                   cunha cone triangular pá lâmina",
        sources: &[&RAO, &TIMOSHENKO, &BEER],
        cases: include_str!("../../cases/tapered_beam.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &TaperedBeamGiven<W>, sheet: W) -> Result<(), Refusal> {
        let (area, second_moment, [width, depth]) = self.sections(&given.section, sheet)?;
        let beam = self.model([width.value(), depth.value()])?;
        let unit = sheet.step(
            "Ω",
            "rad/s",
            (given.young * second_moment / (given.density * area * given.length.powi(4))).sqrt(),
            "The frequencies are multiples of √(EI₀/(ρA₀L⁴)), with the section of the left end",
        );
        let wanted = self.modes + beam.rigid_motions();
        let not_found = |_| Refusal::because("the frequencies cannot be found: the taper is too strong");
        let ritz = |terms: usize| beam.ritz(terms, self.modes).map_err(not_found);
        let (lambdas, shapes) = ritz(beam.terms())?;
        let before = ritz(beam.terms() - 3)?.0;
        sheet.keep_going()?;
        let mut first = None;
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
            if n == 1
                && let Some(uniform) = self.uniform_number()
            {
                let words = "the section of the left end taken for the whole beam";
                sheet.common_error(("ω", n), words, || unit * uniform);
                let middle = || unit * uniform * (depth + 1.0) / 2.0;
                sheet.common_error(("ω", n), "the section at the middle taken for the whole beam", middle);
            }
            overtone_errors(n, first, true, sheet);
            let omega =
                sheet.step(("ω", n), "rad/s", number * unit, Text::new("Natural frequency {n}").with("n", n));
            first = first.or(Some(omega));
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
            let ritz = |terms: usize| Some((terms, beam.ritz(terms, self.modes).ok()?.0));
            series.get_or_init(|| beam.convergence_terms(wanted).filter_map(ritz).collect())
        };
        let sampled = || -> Vec<Sampled> {
            let one =
                |(n, shape): (usize, &VaryingMode)| Sampled::new(n, self.length, |xi| shape.deflection(xi));
            (1..).zip(&shapes).map(one).collect()
        };
        sheet.show(|| Exhibit::Drawing(self.drawing(&beam)));
        sheet.show(|| shapes_plot(&sampled()));
        sheet.show(|| shapes_film(&sampled(), self.length, |sketch, width, y| self.ends(sketch, width, y)));
        sheet.show(|| convergence(series(), self.modes, unit.value()));
        sheet.show(|| distance(series(), &lambdas));
        Ok(())
    }
}

impl TaperedBeam {
    fn supports(&self) -> Result<[EndSupport; 2], Refusal> {
        let pointed = match self.section {
            TaperedSection::Rectangle { end_breadth, end_height, .. } => {
                end_breadth == 0.0 || end_height == 0.0
            }
            TaperedSection::Round { end_diameter, .. } => end_diameter == 0.0,
            TaperedSection::RectangleTable { .. } | TaperedSection::RoundTable { .. } => false,
        };
        if pointed && self.right != TaperedSupport::Free {
            return Err(Refusal::because(
                "a right end that tapers to a point or an edge cannot be supported: leave it free, or give it a section",
            ));
        }
        Ok([&self.left, &self.right].map(|support| match support {
            TaperedSupport::Free => EndSupport::Free,
            TaperedSupport::Pinned => EndSupport::Pinned,
            TaperedSupport::Clamped => EndSupport::Clamped,
        }))
    }

    /// The lowest frequency number of a uniform beam on the same supports; `None` for a table, and where nothing holds
    /// the beam in place.
    fn uniform_number(&self) -> Option<f64> {
        if self.table().is_some() {
            return None;
        }
        Some(match (&self.left, &self.right) {
            (TaperedSupport::Clamped, TaperedSupport::Free)
            | (TaperedSupport::Free, TaperedSupport::Clamped) => 3.516_015,
            (TaperedSupport::Pinned, TaperedSupport::Pinned) => std::f64::consts::PI.powi(2),
            (TaperedSupport::Clamped, TaperedSupport::Pinned)
            | (TaperedSupport::Pinned, TaperedSupport::Clamped) => 15.418_206,
            (TaperedSupport::Clamped, TaperedSupport::Clamped) => 22.373_285,
            _ => return None,
        })
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

    /// Length, and the lengths of the sections at both ends.
    fn letters(&self, sketch: &mut Sketch, points: &[(f64, f64, f64)], width: f64) {
        let half = |share: f64| 0.45 * share.min(3.0);
        let (Some(first), Some(last)) = (points.first(), points.last()) else { return };
        let mut across = |name: &'static str, x: f64, y: f64, share: f64, shift: f64| {
            sketch.dimension(name, (x, y - half(share)), (x, y + half(share)), shift);
        };
        match self.section {
            TaperedSection::Rectangle { .. } => {
                across("h₀", 0.0, 0.0, first.2, 2.5);
                across("h_L", width, 0.0, last.2, -2.0);
                if points.iter().any(|point| point.1 != 1.0) {
                    across("b₀", 0.0, -1.8, first.1, 2.5);
                    across("b_L", width, -1.8, last.1, -2.0);
                } else {
                    sketch.label("b₀ = b_L", (0.5 * width, 0.45));
                }
            }
            TaperedSection::Round { .. } => {
                across("d₀", 0.0, 0.0, first.2, 2.5);
                across("d_L", width, 0.0, last.2, -2.0);
            }
            TaperedSection::RectangleTable { .. } | TaperedSection::RoundTable { .. } => {}
        }
        sketch.dimension("L", (0.0, 0.9), (width, 0.9), 0.0);
    }

    /// The beam from the side, and from above where its width changes.
    fn drawing(&self, beam: &VaryingBeam) -> Drawing {
        let width = 6.0;
        let points: Vec<(f64, f64, f64)> = match beam {
            VaryingBeam::Linear(beam) => vec![(0.0, 1.0, 1.0), (1.0, beam.width, beam.depth)],
            VaryingBeam::Table(beam) => {
                beam.points.iter().map(|point| (point.place, point.width, point.depth)).collect()
            }
        };
        let outline = |y: f64, of: &dyn Fn(&(f64, f64, f64)) -> f64| {
            let half = |point: &(f64, f64, f64)| 0.45 * of(point).min(3.0);
            let above = points.iter().map(|point| (point.0 * width, y + half(point)));
            let below = points.iter().rev().map(|point| (point.0 * width, y - half(point)));
            above.chain(below).collect::<Vec<_>>()
        };
        let mut sketch = Sketch::new("The beam and its taper, from the side and from above");
        sketch.body("", outline(0.0, &|point| point.2));
        self.ends(&mut sketch, width, 0.0);
        if points.iter().any(|point| point.1 != 1.0) {
            sketch.body("", outline(-1.8, &|point| point.1));
        }
        self.letters(&mut sketch, &points, width);
        sketch.finish()
    }

    /// Distances of the table with width and height, where there is one.
    fn table(&self) -> Option<(Vec<[f64; 3]>, TableInterpolation)> {
        match &self.section {
            TaperedSection::RectangleTable { points, between } => {
                let rows = points.iter().map(|point| [point.distance, point.breadth, point.height]);
                Some((rows.collect(), *between))
            }
            TaperedSection::RoundTable { points, between } => {
                let rows = points.iter().map(|point| [point.distance, point.diameter, point.diameter]);
                Some((rows.collect(), *between))
            }
            TaperedSection::Rectangle { .. } | TaperedSection::Round { .. } => None,
        }
    }

    /// The beam in units of its left end, with the ratios of width and height of the ends.
    fn model(&self, [width, depth]: [f64; 2]) -> Result<VaryingBeam, Refusal> {
        let supports = self.supports()?;
        let Some((rows, between)) = self.table() else {
            return Ok(VaryingBeam::Linear(Tapered { width, depth, supports }));
        };
        let first = rows[0];
        let points = rows.iter().map(|row| SectionPoint {
            place: row[0] / self.length,
            width: row[1] / first[1],
            depth: row[2] / first[2],
        });
        let points: Vec<SectionPoint> = points.collect();
        let between = match between {
            TableInterpolation::Linear => Interpolation::Linear,
            TableInterpolation::Exponential => Interpolation::Exponential,
        };
        Ok(VaryingBeam::Table(Varying { points, between, supports }))
    }

    /// Refuses a table that does not lead from one end of the beam to the other.
    fn check(&self, rows: &[[f64; 3]]) -> Result<(), Refusal> {
        if rows.len() < 2 {
            return Err(Refusal::because(
                "the table has fewer than two points: write at least those of both ends",
            ));
        }
        if rows.len() > MOST_POINTS {
            return Err(Refusal::because("the table has more than 30 points: leave some of them out"));
        }
        if rows.windows(2).any(|pair| pair[1][0] - pair[0][0] < 1e-6 * self.length) {
            return Err(Refusal::because(
                "the distances in the table do not ascend: write each place once, from the left end to the right one",
            ));
        }
        let last = rows[rows.len() - 1][0];
        if rows[0][0].abs() > 1e-9 * self.length || (last / self.length - 1.0).abs() > 1e-9 {
            return Err(Refusal::because(
                "the table does not lead from the left end to the right one: its first distance is 0, its last one the length of the beam",
            ));
        }
        Ok(())
    }

    /// Area and second moment at the left end, and the ratios of width and height of the ends.
    fn sections<W: Worksheet>(
        &self,
        given: &TaperedSectionGiven<W>,
        sheet: W,
    ) -> Result<(W::Num, W::Num, [W::Num; 2]), Refusal> {
        let at_left =
            |symbol: &'static str, value: f64, why: &'static str| sheet.numerical(symbol, "mm", value, why);
        let table = self.table();
        if let Some((rows, _)) = &table {
            self.check(rows)?;
        }
        let one = W::Num::from(1.0);
        let (area, second_moment, ratios) = match (given, table) {
            (TaperedSectionGiven::Rectangle { breadth, end_breadth, height, end_height }, _) => (
                section::rectangle_area(*breadth, *height),
                section::rectangle_second_moment(*breadth, *height),
                [
                    sheet.step(
                        "β_b",
                        "1",
                        *end_breadth / *breadth,
                        "Width of the right end over that of the left",
                    ),
                    sheet.step("β_h", "1", *end_height / *height, "Ratio of right-end to left-end height"),
                ],
            ),
            (TaperedSectionGiven::Round { diameter, end_diameter }, _) => {
                let ratio = *end_diameter / *diameter;
                let ratio = sheet.step("β_d", "1", ratio, "Diameter of the right end over that of the left");
                (section::round_area(*diameter), section::round_second_moment(*diameter), [ratio; 2])
            }
            (TaperedSectionGiven::RectangleTable { .. }, Some((rows, _))) => {
                let breadth = at_left("b₀", rows[0][1], "Width at the left end, of the table");
                let height = at_left("h₀", rows[0][2], "Height at the left end, of the table");
                let area = section::rectangle_area(breadth, height);
                (area, section::rectangle_second_moment(breadth, height), [one; 2])
            }
            (_, Some((rows, _))) => {
                let diameter = at_left("d₀", rows[0][1], "Diameter at the left end, of the table");
                (section::round_area(diameter), section::round_second_moment(diameter), [one; 2])
            }
            (_, None) => unreachable!("what is given is made from the section"),
        };
        let area = sheet.step("A₀", "cm^2", area, ("Area of the left end", BEER.at("app. A")));
        let why = ("Second moment of area of the left end", BEER.at("app. A"));
        let second_moment = sheet.step("I₀", "cm^4", second_moment, why);
        Ok((area, second_moment, ratios))
    }
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
