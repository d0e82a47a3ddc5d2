//! Vibration of a plane frame of straight members that bend and stretch.

use std::f64::consts::TAU;

use dalembert_core::{
    About, Analysis, Cell, Column, Exhibit, Ink, Inputs, Refusal, Sketch, TableExhibit, Text, Worksheet,
    register,
};
use dalembert_mechanics::{
    Real,
    beam::dynamic_stiffness::{
        BeamError,
        frame::{Frame, FrameJoint, FrameMember, FrameShape},
    },
};

use crate::{
    shared::{
        continuous::{LineMass, line_mass},
        letters::of_row,
        section::{Profile, ProfileGiven, profile},
    },
    sources::{BEER, BLEVINS, TIMOSHENKO, WITTRICK},
};

/// Joints, and the members between them.
#[derive(Clone, Debug, Inputs)]
pub struct PlaneFrame {
    /// Joints.
    /// Numbered in this order.
    #[input(min = 2)]
    pub joints: Vec<PlacedJoint>,
    /// Members.
    #[input(min = 1)]
    pub members: Vec<PlacedMember>,
    /// Theory.
    pub theory: MemberTheory,
    /// Number of frequencies.
    /// Rigid-body motions of an unsupported frame are not included.
    #[input(min = 1, max = 20, default = "4")]
    pub modes: usize,
}

/// A point at which members meet or are supported.
#[derive(Clone, Debug, Inputs)]
pub struct PlacedJoint {
    /// Coordinate x.
    #[input("x", "m")]
    pub x: f64,
    /// Coordinate y.
    #[input("y", "m")]
    pub y: f64,
    /// Support.
    pub support: JointSupport,
    /// Attached mass.
    #[input("m", "kg", nonnegative)]
    pub mass: Option<f64>,
    /// Moment of inertia of the mass about its centre.
    #[input("J", "kg*m^2", nonnegative)]
    pub inertia: Option<f64>,
}

/// The support of a joint.
#[derive(Clone, Debug, Inputs)]
pub enum JointSupport {
    /// Free
    Free,
    /// Pinned
    Pinned,
    /// Clamped
    Clamped,
    /// Roller that moves along x
    RollerX,
    /// Roller that moves along y
    RollerY,
    /// Springs
    Springs {
        /// Stiffness along x.
        #[input("k_x", "N/m", nonnegative)]
        along_x: Option<f64>,
        /// Stiffness along y.
        #[input("k_y", "N/m", nonnegative)]
        along_y: Option<f64>,
        /// Rotational stiffness.
        #[input("k_t", "N*m/rad", nonnegative)]
        rotational: Option<f64>,
    },
}

/// A straight uniform member.
#[derive(Clone, Debug, Inputs)]
pub struct PlacedMember {
    /// First joint.
    #[input(min = 1)]
    pub from: usize,
    /// Second joint.
    #[input(min = 1)]
    pub to: usize,
    /// Section.
    pub section: Profile,
    /// Young's modulus.
    #[input("E", "Pa", positive)]
    pub young: f64,
    /// Mass of the member.
    pub mass: LineMass,
    /// Ends of the member.
    pub ends: MemberEnds,
}

/// Connection of a member to its joints.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Inputs)]
pub enum MemberEnds {
    /// Rigid at both joints
    Rigid,
    /// Hinged at the first joint
    HingedFirst,
    /// Hinged at the second joint
    HingedSecond,
    /// Hinged at both joints
    Hinged,
}

/// Beam theory of the members.
#[derive(Clone, Debug, Inputs)]
pub enum MemberTheory {
    /// Bending alone (Euler–Bernoulli)
    EulerBernoulli,
    /// Bending, shear and rotary inertia (Timoshenko)
    Timoshenko {
        /// Poisson's ratio.
        #[input("ν", "1", min = 0, max = 0.5)]
        poisson: f64,
        /// Shear coefficient.
        #[input("κ", "1", positive, max = 1)]
        coefficient: f64,
    },
}

register!(PlaneFrame);

/// More joints or members would be a structure for other programs.
const MOST: usize = 60;

impl Analysis for PlaneFrame {
    const ABOUT: About = About {
        id: "vibration/plane-frame",
        title: "Plane frame",
        topic: "Strings, beams and plates",
        summary: "Exact natural frequencies and mode shapes of a plane frame of straight members in bending and axial vibration, with hinges, masses and supports at its joints; compared with finite elements.",
        main: &["frequency"],
        keywords: "portal frame plane frame L-frame cross structure beams columns joints hinge finite elements dynamic stiffness \
                   NAFEMS FV2 SDLX01 pórtico plano quadro estrutura reticulada barras nós rótula elementos finitos rigidez \
                   dinâmica",
        sources: &[&WITTRICK, &BLEVINS, &TIMOSHENKO, &BEER],
        cases: include_str!("../../cases/plane_frame.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &PlaneFrameGiven<W>, sheet: W) -> Result<(), Refusal> {
        self.check()?;
        let members = given
            .members
            .iter()
            .enumerate()
            .map(|(n, member)| {
                numbers(given, [self.members[n].from, self.members[n].to], n + 1, member, sheet)
            })
            .collect::<Result<Vec<_>, _>>()?;
        let MemberNumbers { length, bending, line, .. } = members[0];
        let unit = sheet.step(
            "Ω",
            "rad/s",
            (bending / (line * length.powi(4))).sqrt(),
            "The frequencies are written as multiples of √(EI₁/(m̄₁L₁⁴)), of the first member",
        );
        let frame = self.frame(&members);
        sheet.keep_going()?;
        let roots = frame.roots(self.modes).map_err(|err| refusal(&err))?;
        sheet.keep_going()?;
        let shapes = frame.shapes(&roots).map_err(|err| refusal(&err))?;
        let rigid = frame.rigid_motions().map_err(|err| refusal(&err))?;
        let equal = |n: usize| roots.get(n).is_some_and(|next| next / roots[n - 1] < 1.0 + 1e-7);
        for (n, (root, shape)) in (1..).zip(roots.iter().zip(&shapes)) {
            let beta = sheet.numerical(
                ("β", n),
                "1",
                *root,
                (
                    "Root of the determinant of the exact dynamic stiffness of all members, with the frequencies below it \
                     counted",
                    WITTRICK.at("pp. 263–284"),
                ),
            );
            let omega = sheet.step(
                ("ω", n),
                "rad/s",
                beta.powi(2) * unit,
                Text::new("Natural frequency {n}").with("n", n),
            );
            let frequency = sheet.step(("f", n), "Hz", omega, "In cycles per second");
            sheet.verify(|| {
                sheet.check(
                    Text::new("mode shape {n}: strain energy over kinetic energy is ω²").with("n", n),
                    unit.powi(2) * shape.rayleigh_quotient(),
                    omega.powi(2),
                );
                if let Some(other) = shapes.get(n)
                    && !equal(n)
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
            sheet.answer(("root", n), "Root β with ω = β²√(EI₁/(m̄₁L₁⁴))", beta);
        }
        if rigid > 0 {
            sheet.warn(|| {
                Text::new(
                    "the frame can move without deformation: {n} such motions at frequency zero precede the first frequency",
                )
                .with("n", rigid)
            });
        }
        if (1..roots.len()).any(equal) {
            sheet.warn(|| {
                Text::new(
                    "some frequencies coincide: any linear combination of their mode shapes is also a mode shape",
                )
            });
        }
        self.slender(&members, sheet);
        if matches!(self.theory, MemberTheory::EulerBernoulli) {
            sheet.show(|| elements(&frame, &roots, unit.value()));
        }
        sheet.show(|| motions(&shapes, self.joints.len()));
        sheet.show(|| Exhibit::Drawing(self.sketch(None).titled("The frame").finish()));
        for (n, shape) in (1..).zip(shapes.iter().take(4)) {
            sheet.show(|| {
                let frame = |at: u16| self.sketch(Some((shape, (TAU * f64::from(at) / 24.0).cos())));
                let title = Text::new("Mode {mode}").with("mode", n);
                Exhibit::Animation(Sketch::animation(title, (0..24).map(frame), 2.0))
            });
        }
        Ok(())
    }
}

/// Properties of a member.
#[derive(Clone, Copy)]
struct MemberNumbers<N> {
    length: N,
    bending: N,
    axial: N,
    line: N,
    /// Shear flexibility and rotary inertia, m².
    sections: Option<[N; 2]>,
    /// Depth of a section of known shape.
    depth: Option<f64>,
}

fn numbers<W: Worksheet>(
    given: &PlaneFrameGiven<W>,
    ends: [usize; 2],
    row: usize,
    member: &PlacedMemberGiven<W>,
    sheet: W,
) -> Result<MemberNumbers<W::Num>, Refusal> {
    let [from, to] = ends.map(|at| &given.joints[at - 1]);
    let length = ((to.x - from.x).powi(2) + (to.y - from.y).powi(2)).sqrt();
    let length = sheet.step(("L", row), "m", length, "Length of the member");
    let (area, second_moment) = profile(&member.section, row, sheet)?;
    let bending =
        sheet.step(("EI", row), "N*m^2", member.young * second_moment, "Bending stiffness of the member");
    let axial = sheet.step(("EA", row), "N", member.young * area, "Axial stiffness of the member");
    let line = line_mass(&member.mass, row, area, sheet);
    let sections = match &given.theory {
        MemberTheoryGiven::EulerBernoulli {} => None,
        MemberTheoryGiven::Timoshenko { poisson, coefficient } => {
            let shear = bending * (*poisson + 1.0) * 2.0 / (*coefficient * axial);
            let why = ("Shear flexibility EI/(κGA) of the member, G = E/(2(1 + ν))", TIMOSHENKO.at("ch. 5"));
            let shear = sheet.step(("s", row), "m^2", shear, why);
            let why = ("Rotary inertia of the sections: radius of gyration squared", TIMOSHENKO.at("ch. 5"));
            Some([shear, sheet.step(("i²", row), "m^2", second_moment / area, why)])
        }
    };
    let depth = match &member.section {
        ProfileGiven::Given { .. } => None,
        _ => Some((second_moment.value() / area.value() * 12.0).sqrt()),
    };
    Ok(MemberNumbers { length, bending, axial, line, sections, depth })
}

impl PlaneFrame {
    fn check(&self) -> Result<(), Refusal> {
        if self.joints.len() > MOST || self.members.len() > MOST {
            return Err(Refusal::because(
                "there are more than 60 joints or members: join members that continue each other, or use a finite element program",
            ));
        }
        for (n, member) in (1..).zip(&self.members) {
            let why = if member.from > self.joints.len() || member.to > self.joints.len() {
                Text::new("member {n} ends at a joint that does not exist: there are {count} joints")
                    .with("count", self.joints.len())
            } else if member.from == member.to {
                Text::new("member {n} begins and ends at the same joint: write two joints")
            } else {
                let [from, to] = [member.from, member.to].map(|at| &self.joints[at - 1]);
                if from.x != to.x || from.y != to.y {
                    continue;
                }
                Text::new("both joints of member {n} have the same coordinates: correct one of them")
            };
            return Err(Refusal::because(why.with("n", n)));
        }
        let used = |at: usize| self.members.iter().any(|member| member.from == at || member.to == at);
        if let Some(alone) = (1..=self.joints.len()).find(|at| !used(*at)) {
            let why = Text::new("no member ends at joint {n}: remove it, or write a member to it");
            return Err(Refusal::because(why.with("n", alone)));
        }
        Ok(())
    }

    /// The frame with length, `EI` and `m̄` of the first member as units.
    fn frame<N: Real>(&self, members: &[MemberNumbers<N>]) -> Frame {
        let first = &members[0];
        let (length, bending, mass) = (first.length.value(), first.bending.value(), first.line.value());
        let joints = self.joints.iter().map(|joint| {
            let springs = match joint.support {
                JointSupport::Springs { along_x, along_y, rotational } => {
                    let k = |stiffness: Option<f64>| stiffness.unwrap_or(0.0) * length.powi(3) / bending;
                    [k(along_x), k(along_y), rotational.unwrap_or(0.0) * length / bending]
                }
                _ => [0.0; 3],
            };
            FrameJoint {
                at: [joint.x / length, joint.y / length],
                held: joint.support.held(),
                springs,
                mass: joint.mass.unwrap_or(0.0) / (mass * length),
                inertia: joint.inertia.unwrap_or(0.0) / (mass * length.powi(3)),
            }
        });
        let members = self.members.iter().zip(members).map(|(member, numbers)| {
            let [shear, rotary] =
                numbers.sections.map_or([0.0; 2], |of| of.map(|x| x.value() / length.powi(2)));
            FrameMember {
                joints: [member.from - 1, member.to - 1],
                hinged: match member.ends {
                    MemberEnds::Rigid => [false, false],
                    MemberEnds::HingedFirst => [true, false],
                    MemberEnds::HingedSecond => [false, true],
                    MemberEnds::Hinged => [true, true],
                },
                bending: numbers.bending.value() / bending,
                axial: numbers.axial.value() * length.powi(2) / bending,
                mass: numbers.line.value() / mass,
                shear,
                rotary,
            }
        });
        Frame { joints: joints.collect(), members: members.collect() }
    }

    /// Warns of members for which shear and rotary inertia count.
    fn slender<W: Worksheet>(&self, members: &[MemberNumbers<W::Num>], sheet: W) {
        let deep = |member: &MemberNumbers<W::Num>| {
            member.depth.is_some_and(|depth| depth * 10.0 > member.length.value())
        };
        if !matches!(self.theory, MemberTheory::EulerBernoulli) {
            return;
        }
        if let Some(n) = members.iter().position(deep) {
            sheet.warn(|| {
                Text::new(
                    "member {n} is less than ten times as long as deep: shear and rotary inertia lower the frequencies; choose Timoshenko's theory",
                )
                .with("n", n + 1)
            });
        }
    }

    /// The frame at rest, or in a phase of a vibration.
    fn sketch(&self, moved: Option<(&FrameShape, f64)>) -> Sketch {
        let span = |of: &dyn Fn(&PlacedJoint) -> f64| {
            let ends = self.joints.iter().map(of);
            ends.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], x| [low.min(x), high.max(x)])
        };
        let ([left, right], [low, high]) = (span(&|joint| joint.x), span(&|joint| joint.y));
        let size = 6.0 / (right - left).max(high - low);
        let mut sketch = Sketch::default();
        let place = |x: f64, y: f64| ((x - left) * size, (y - low) * size);
        for (n, member) in self.members.iter().enumerate() {
            let [from, to] = [member.from, member.to].map(|at| &self.joints[at - 1]);
            let ends = [place(from.x, from.y), place(to.x, to.y)];
            let Some((shape, phase)) = moved else {
                sketch.link(of_row(member.section.letters(), n + 1), ends[0], ends[1]);
                continue;
            };
            sketch.axis(ends[0], ends[1]);
            let point = |at: u8| {
                let share = f64::from(at) / 16.0;
                let [u, v] = shape.displacement(n, share);
                let along = |a: f64, b: f64| a + (b - a) * share;
                let swing = 0.6 * phase;
                (along(ends[0].0, ends[1].0) + swing * u, along(ends[0].1, ends[1].1) + swing * v)
            };
            sketch.curve((0..=16).map(point).collect::<Vec<_>>(), Ink::Motion);
        }
        for (n, joint) in (1..).zip(&self.joints) {
            let at = place(joint.x, joint.y);
            let name = if moved.is_none() { joint_letters(joint, n) } else { Text::new("") };
            match joint.support {
                JointSupport::Free => {}
                JointSupport::Pinned => {
                    sketch.pin("", at);
                }
                JointSupport::Clamped => {
                    sketch.ground((at.0 - 0.4, at.1), (at.0 + 0.4, at.1));
                }
                JointSupport::RollerX | JointSupport::RollerY => {
                    sketch.roller("", at);
                }
                JointSupport::Springs { .. } => {
                    sketch.spring("", (at.0, at.1 - 0.7), at);
                }
            }
            if joint.mass.is_some_and(|mass| mass > 0.0) {
                sketch.particle("", at);
            }
            if moved.is_none() {
                sketch.label(name, at);
            }
        }
        sketch
    }
}

impl JointSupport {
    /// True for displacements along x and y and the rotation that are zero.
    fn held(&self) -> [bool; 3] {
        match self {
            JointSupport::Free | JointSupport::Springs { .. } => [false; 3],
            JointSupport::Pinned => [true, true, false],
            JointSupport::Clamped => [true; 3],
            JointSupport::RollerX => [false, true, false],
            JointSupport::RollerY => [true, false, false],
        }
    }
}

fn refusal(err: &BeamError) -> Refusal {
    Refusal::because(match err {
        BeamError::TooSlender(_) => {
            "a member is so slender, or the frequencies are so high, that its waves cannot be resolved: ask for fewer frequencies"
        }
        BeamError::Buckled | BeamError::OutOfRange | BeamError::NotConverged => {
            "the frequencies of the frame cannot be found: members, masses and springs differ too much in magnitude"
        }
    })
}

/// The frequencies by finite elements, which come down to the exact ones.
fn elements(frame: &Frame, roots: &[f64], unit: f64) -> Exhibit {
    let shown = roots.len().min(8);
    let mut columns = vec![Column { heading: "elements in each member".into(), unit: "" }];
    let mode = |n: usize| Column { heading: Text::new("mode {n}").with("n", n), unit: "Hz" };
    columns.extend((1..=shown).map(mode));
    let row = |parts: usize| {
        let lambdas = frame.finite_elements(parts, shown).unwrap_or_default();
        let cell = |n: usize| lambdas.get(n).map_or(Cell::Empty, |lambda| Cell::Number(lambda.sqrt() * unit));
        std::iter::once(Cell::Text(Text::new("{n}").with("n", parts))).chain((0..shown).map(cell)).collect()
    };
    let exact = std::iter::once(Cell::Text("exact".into()))
        .chain(roots.iter().take(shown).map(|root| Cell::Number(root.powi(2) * unit)));
    Exhibit::Table(TableExhibit {
        title: "Finite elements: upper bounds of the frequencies".into(),
        columns,
        rows: [1, 2, 4].map(row).into_iter().chain([exact.collect()]).collect(),
        foot: Vec::new(),
    })
}

/// The displacements of the joints in each mode.
fn motions(shapes: &[FrameShape], joints: usize) -> Exhibit {
    let mut columns = vec![Column { heading: "joint".into(), unit: "1" }];
    let shown = shapes.len().min(6);
    for n in 1..=shown {
        columns.push(Column { heading: Text::new("u, mode {n}").with("n", n), unit: "1" });
        columns.push(Column { heading: Text::new("v, mode {n}").with("n", n), unit: "1" });
    }
    let clean = |x: f64| Cell::Number(if x.abs() < 1e-9 { 0.0 } else { x });
    let row = |at: usize| {
        let moved = shapes.iter().take(shown).flat_map(|shape| {
            let [u, v, _] = shape.joint(at);
            [clean(u), clean(v)]
        });
        std::iter::once(Cell::Number((at + 1) as f64)).chain(moved).collect()
    };
    Exhibit::Table(TableExhibit {
        title: "Displacements of the joints over the largest of the mode".into(),
        columns,
        rows: (0..joints).map(row).collect(),
        foot: Vec::new(),
    })
}

/// Coordinates of a joint, with the letters of what stands there.
fn joint_letters(joint: &PlacedJoint, row: usize) -> Text {
    let mut letters = vec!["x", "y"];
    if joint.mass.is_some_and(|mass| mass > 0.0) {
        letters.push("m");
    }
    if joint.inertia.is_some_and(|inertia| inertia > 0.0) {
        letters.push("J");
    }
    if let JointSupport::Springs { along_x, along_y, rotational } = joint.support {
        letters.extend(along_x.map(|_| "k_x"));
        letters.extend(along_y.map(|_| "k_y"));
        letters.extend(rotational.map(|_| "k_t"));
    }
    of_row(&letters, row)
}
