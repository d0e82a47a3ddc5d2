//! Bending vibration of a beam over several supports, each span with its own section.

use dalembert_core::{
    About, Analysis, Cell, Column, Drawing, Exhibit, Inputs, Refusal, Sketch, TableExhibit, Text, Worksheet,
    register,
};
use dalembert_mechanics::{
    Real,
    beam::dynamic_stiffness::{
        BeamError,
        spans::{Span, SpanJoint, SpanShape, Spans},
    },
};

use crate::{
    shared::{
        continuous::{
            HALF_BEAM, LineMass, Sampled, draw_support, line_mass, overtone_errors, shapes_film, shapes_plot,
        },
        letters::of_row,
        section::{Profile, profile},
        support::{Restraint, Support},
    },
    sources::{BEER, BLEVINS, RAO, WITTRICK},
};

/// The spans from left to right, and what holds the beam between them.
#[derive(Clone, Debug, Inputs)]
pub struct MultiSpanBeam {
    /// Left end.
    pub left: BeamJoint,
    /// Spans.
    /// From left to right, each with the element at its right end.
    #[input(min = 1)]
    pub spans: Vec<BeamSpan>,
    /// Number of frequencies.
    /// Rigid-body motions of an unsupported beam are not included.
    #[input(min = 1, max = 10, default = "4")]
    pub modes: usize,
}

/// A uniform part of the beam.
#[derive(Clone, Debug, Inputs)]
pub struct BeamSpan {
    /// Length.
    #[input("L", "m", positive)]
    pub length: f64,
    /// Section.
    pub section: Profile,
    /// Young's modulus.
    #[input("E", "Pa", positive)]
    pub young: f64,
    /// Mass of the span.
    pub mass: LineMass,
    /// Axial force.
    /// Tension is positive, compression negative.
    #[input("N", "N")]
    pub axial: Option<f64>,
    /// Elastic foundation.
    /// Ground reaction per unit length of the beam and unit deflection.
    #[input("k_f", "N/m^2", nonnegative)]
    pub foundation: Option<f64>,
    /// Right end of the span.
    pub end: BeamJoint,
}

/// Support and lumped elements at an end of a span.
#[derive(Clone, Debug, Inputs)]
pub struct BeamJoint {
    /// Support.
    /// Unsupported joint between two spans: only the section of the beam changes.
    pub support: Support,
    /// Attached mass.
    #[input("m", "kg", nonnegative)]
    pub mass: Option<f64>,
    /// Moment of inertia of the mass about its centre.
    #[input("J", "kg*m^2", nonnegative)]
    pub inertia: Option<f64>,
}

register!(MultiSpanBeam);

/// More spans would be a structure for other methods.
const MOST_SPANS: usize = 40;

impl Analysis for MultiSpanBeam {
    const ABOUT: About = About {
        id: "vibration/multi-span-beam",
        title: "Beam over several supports",
        topic: "Strings, beams and plates",
        summary: "Exact frequencies, mode shapes and nodes of a continuous beam of several spans, each with its section, axial force and foundation, on pinned, clamped and elastic supports, with masses at the joints; compared with finite elements.",
        main: &["frequency"],
        keywords: "continuous beam multi span stepped supports bridge pipe shaft foundation finite elements viga \
                   contínua vários vãos apoios escalonada ponte tubulação fundação elástica elementos finitos",
        sources: &[&WITTRICK, &BLEVINS, &RAO, &BEER],
        cases: include_str!("../../cases/multi_span_beam.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &MultiSpanBeamGiven<W>, sheet: W) -> Result<(), Refusal> {
        if self.spans.len() > MOST_SPANS {
            return Err(Refusal::because(
                "there are more than 40 spans: join equal adjacent spans with nothing between them",
            ));
        }
        let mut properties = Vec::with_capacity(self.spans.len());
        for (n, span) in (1..).zip(&given.spans) {
            let (area, second_moment) = profile(&span.section, n, sheet)?;
            let bending =
                sheet.step(("EI", n), "N*m^2", span.young * second_moment, "Bending stiffness of the span");
            let line = line_mass(&span.mass, n, area, sheet);
            properties.push((bending, line));
        }
        let length =
            sheet.step("L", "m", Real::sum(given.spans.iter().map(|span| span.length)), "Total length");
        let (bending, line) = properties[0];
        let unit = sheet.step(
            "Ω",
            "rad/s",
            (bending / (line * length.powi(4))).sqrt(),
            "The frequencies are written as multiples of √(EI₁/(m̄₁L⁴)), of the first span and the whole length",
        );
        let numbers: Vec<(f64, f64)> = properties.iter().map(|(b, m)| (b.value(), m.value())).collect();
        let beam = self.beam(&numbers, length.value());
        let roots = beam.roots(self.modes).map_err(|err| refusal(&err))?;
        sheet.keep_going()?;
        let shapes: Vec<SpanShape> = roots
            .iter()
            .map(|root| beam.shape(*root))
            .collect::<Result<_, _>>()
            .map_err(|err| refusal(&err))?;
        sheet.keep_going()?;
        let duplicates = |n: usize| roots.get(n).is_some_and(|next| next / roots[n - 1] < 1.0 + 1e-7);
        if self.spans.len() > 1 {
            let square = std::f64::consts::PI.powi(2);
            let longest = || {
                let all = properties.iter().zip(&given.spans);
                let longest = all.reduce(|a, b| if b.1.length.value() > a.1.length.value() { b } else { a });
                longest.map_or(unit, |((bending, line), span)| {
                    (*bending / (*line * span.length.powi(4))).sqrt() * square
                })
            };
            sheet.common_error(("ω", 1), "the longest span alone taken, pinned at both ends", longest);
            let whole = || unit * square;
            sheet.common_error(("ω", 1), "the supports between the ends left out, both ends pinned", whole);
        }
        let mut first = None;
        for (n, (root, shape)) in (1..).zip(roots.iter().zip(&shapes)) {
            overtone_errors(n, first, true, sheet);
            let beta = sheet.numerical(
                ("β", n),
                "1",
                *root,
                (
                    "Root of the determinant of the exact dynamic stiffness of all spans, with the frequencies \
                     below it counted",
                    WITTRICK.at("pp. 263–284"),
                ),
            );
            let omega = sheet.step(
                ("ω", n),
                "rad/s",
                beta.powi(2) * unit,
                Text::new("Natural frequency {n}").with("n", n),
            );
            first = first.or(Some(omega));
            let frequency = sheet.step(("f", n), "Hz", omega, "In cycles per second");
            sheet.verify(|| {
                sheet.check(
                    Text::new("mode shape {n}: strain energy over kinetic energy is ω²").with("n", n),
                    bending / (line * length.powi(4)) * shape.rayleigh_quotient(),
                    omega.powi(2),
                );
                if let Some(left_over) = equal_spans(&beam, *root) {
                    sheet.check_zero(
                        Text::new("root {n} satisfies the equation of equal spans on pins").with("n", n),
                        W::Num::from(left_over),
                        *root,
                    );
                }
                if let Some(other) = shapes.get(n)
                    && !duplicates(n)
                {
                    let size = shape.inertia_product(shape) * other.inertia_product(other);
                    sheet.check_zero(
                        Text::new("mode shapes {n} and {m} are orthogonal").with("n", n).with("m", n + 1),
                        W::Num::from(shape.inertia_product(other)),
                        size.sqrt(),
                    );
                }
            });
            sheet.answer(("frequency", n), "Natural frequency", frequency);
            sheet.answer(("root", n), "Root β with ω = β²√(EI₁/(m̄₁L⁴)), of the first span", beta);
            let nodes: Vec<f64> = shape.nodes().into_iter().map(|x| x * length.value()).collect();
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
        if (1..roots.len()).any(duplicates) {
            sheet.warn(|| {
                Text::new(
                    "two frequencies coincide: any linear combination of their mode shapes is also a mode shape; one of them is shown",
                )
            });
        }
        sheet.show(|| elements(&beam, &roots, unit.value()));
        let sampled = || -> Vec<Sampled> {
            let one = |(n, shape): (usize, &SpanShape)| {
                let mut sampled =
                    Sampled::new(n + 2 * self.spans.len(), length.value(), |xi| shape.deflection(xi));
                sampled.number = n;
                sampled
            };
            (1..).zip(&shapes).map(one).collect()
        };
        sheet.show(|| shapes_plot(&sampled()));
        sheet.show(|| Exhibit::Drawing(self.drawing(&beam)));
        sheet.show(|| {
            shapes_film(&sampled(), length.value(), |sketch, width, y| joints(&beam, sketch, width, y))
        });
        Ok(())
    }
}

impl MultiSpanBeam {
    /// The spans on their supports, with the letters of each.
    fn drawing(&self, beam: &Spans) -> Drawing {
        const WIDTH: f64 = 8.0;
        let mut sketch = Sketch::new("The spans and their supports");
        sketch.mass("", (0.0, 0.0), (WIDTH, 2.0 * HALF_BEAM));
        joints(beam, &mut sketch, WIDTH, 0.0);
        let mut from = 0.0;
        for ((span, given), row) in beam.spans.iter().zip(&self.spans).zip(1..) {
            let to = from + span.length * WIDTH;
            sketch.dimension(of_row(&["L"], row), (from, -1.5), (to, -1.5), 0.0);
            sketch.label(of_row(given.section.letters(), row), (f64::midpoint(from, to), 2.0 * HALF_BEAM));
            from = to;
        }
        for (joint, (at, row)) in
            [&self.left].into_iter().chain(self.spans.iter().map(|span| &span.end)).zip(ends(beam).zip(0..))
        {
            if joint.mass.is_some() && row > 0 {
                sketch.label(of_row(&["m"], row), (at * WIDTH, 0.3));
            }
        }
        sketch.finish()
    }

    /// The beam with its length, `EI` and `m̄` of the first span as units; `numbers` are those of each span.
    fn beam(&self, numbers: &[(f64, f64)], length: f64) -> Spans {
        let (bending, mass) = numbers[0];
        let span = |(span, (own_bending, own_mass)): (&BeamSpan, &(f64, f64))| Span {
            length: span.length / length,
            bending: own_bending / bending,
            mass: own_mass / mass,
            axial: span.axial.unwrap_or(0.0) * length.powi(2) / bending,
            foundation: span.foundation.unwrap_or(0.0) * length.powi(4) / bending,
        };
        let joint = |joint: &BeamJoint| {
            let Restraint { held, clamped, spring, turning_spring } =
                joint.support.restraint(length, bending);
            SpanJoint {
                held,
                clamped,
                spring,
                turning_spring,
                mass: joint.mass.unwrap_or(0.0) / (mass * length),
                inertia: joint.inertia.unwrap_or(0.0) / (mass * length.powi(3)),
                ..SpanJoint::default()
            }
        };
        let ends = self.spans.iter().map(|span| &span.end);
        Spans {
            spans: self.spans.iter().zip(numbers).map(span).collect(),
            joints: std::iter::once(&self.left).chain(ends).map(joint).collect(),
        }
    }
}

/// Residual of the frequency equation of equal plain spans on pins, the ends both pinned or both clamped: `near + far
/// cos(jπ/N) = 0` for a `j` from 1 to `N − 1`, or that of a span alone.
fn equal_spans(beam: &Spans, root: f64) -> Option<f64> {
    let [first, inner @ .., last] = &beam.joints[..] else { return None };
    let span = &beam.spans[0];
    let pin = SpanJoint { held: true, ..SpanJoint::default() };
    let clamp = SpanJoint { clamped: true, ..pin };
    let same = |other: &Span| {
        Span { length: span.length, ..*other } == *span && (other.length / span.length - 1.0).abs() < 1e-12
    };
    let plain = span.axial == 0.0 && span.foundation == 0.0 && beam.spans.iter().all(same);
    if !plain || first != last || ![pin, clamp].contains(first) || inner.iter().any(|joint| *joint != pin) {
        return None;
    }
    let count = beam.spans.len();
    let beta = root * span.length;
    // Stiffnesses of a span at the end that turns and at the other one, over a common factor.
    let near = beta.sin() - beta.tanh() * beta.cos();
    let far = beta.tanh() - beta.sin() / beta.cosh();
    let chain = (1..count).map(|j| near + far * (j as f64 * std::f64::consts::PI / count as f64).cos());
    let alone = if *first == clamp { beta.cos() - beta.cosh().recip() } else { beta.sin() };
    chain.chain([alone]).min_by(|a, b| a.abs().total_cmp(&b.abs()))
}

fn refusal(err: &BeamError) -> Refusal {
    Refusal::because(match err {
        BeamError::Buckled => "the beam buckles under its compression: write a smaller one",
        BeamError::TooSlender(_) => {
            "a span is so slender, so highly tensioned or so heavily loaded that its bending cannot be resolved: treat it as a string or as a rigid body"
        }
        BeamError::OutOfRange | BeamError::NotConverged => {
            "the frequencies cannot be found: spans, masses, springs and forces differ too much in magnitude"
        }
    })
}

/// The frequencies by finite elements, which come down to the exact ones.
fn elements(beam: &Spans, roots: &[f64], unit: f64) -> Exhibit {
    let mut columns = vec![Column { heading: "elements in each span".into(), unit: "" }];
    let mode = |n: usize| Column { heading: Text::new("mode {n}").with("n", n), unit: "Hz" };
    columns.extend((1..=roots.len()).map(mode));
    let row = |parts: usize| {
        let lambdas = beam.finite_elements(parts, roots.len()).unwrap_or_default();
        let cell = |n: usize| lambdas.get(n).map_or(Cell::Empty, |lambda| Cell::Number(lambda.sqrt() * unit));
        std::iter::once(Cell::Text(Text::new("{n}").with("n", parts)))
            .chain((0..roots.len()).map(cell))
            .collect()
    };
    let exact = std::iter::once(Cell::Text("exact".into()))
        .chain(roots.iter().map(|root| Cell::Number(root.powi(2) * unit)));
    Exhibit::Table(TableExhibit {
        title: "Finite elements: upper bounds of the frequencies".into(),
        columns,
        rows: [2, 4, 8, 16].map(row).into_iter().chain([exact.collect()]).collect(),
        foot: Vec::new(),
    })
}

/// Places of the joints as shares of the whole length.
fn ends(beam: &Spans) -> impl Iterator<Item = f64> {
    let lengths = [0.0].into_iter().chain(beam.spans.iter().map(|span| span.length));
    lengths.scan(0.0, |sum, length| {
        *sum += length;
        Some(*sum)
    })
}

/// Draws the supports along a beam from `(0, y)` to `(width, y)`.
fn joints(beam: &Spans, sketch: &mut Sketch, width: f64, y: f64) {
    let mut place = 0.0;
    for (n, joint) in beam.joints.iter().enumerate() {
        let x = place * width;
        draw_support(sketch, (joint.held, joint.clamped), (x, y), n == 0);
        if joint.spring > 0.0 || joint.turning_spring > 0.0 {
            sketch.spring("", (x, y - 0.8), (x, y));
        }
        if joint.mass > 0.0 {
            sketch.particle("", (x, y));
        }
        place += beam.spans.get(n).map_or(0.0, |span| span.length);
    }
}
