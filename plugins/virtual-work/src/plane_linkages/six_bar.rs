//! Six-bar linkages: a four-bar whose rocker or coupler drives a second pair of links.

mod motion;
mod picture;

use dalembert_core::{About, Analysis, Inputs, Refusal, Worksheet, exhibit::Point as At, register};
use dalembert_mechanics::{
    Real, Vector,
    planar::{BodyPoint, PlanarError, PlanarJoint},
};
use nalgebra::Vector3;

use crate::{
    shared::{
        built::{self, Built, Range, Solved, Template, TemplateRange},
        dyad::{self, DyadPin, SliderLine},
        figure,
        linkage::Closing,
        works::{
            self, FIVE, FOUR, LinkMass, PointWork, RotatingLinkWork, SIX, THREE, TWO, Works, plane, symbol,
        },
    },
    sources::{NORTON, RIUL, SHIGLEY},
};

/// A six-bar linkage in one position.
///
/// Crank (2), coupler (3) and rocker (4) are a four-bar: the crank turns about the origin O, the rocker about C on the
/// x axis. From a point D of the rocker (Watt) or of the coupler (Stephenson) link 5 leads to a slider or to a second
/// rocker (6).
#[derive(Clone, Debug, Inputs)]
pub struct SixBar {
    /// Length of the crank.
    #[input("a", "mm", positive)]
    pub crank: f64,
    /// Length of the coupler.
    #[input("b", "mm", positive)]
    pub coupler: f64,
    /// Length of the rocker.
    #[input("c", "mm", positive)]
    pub rocker: f64,
    /// Length of the frame.
    /// Between the fixed pins.
    #[input("d", "mm", positive)]
    pub frame: f64,
    /// Closing of the loop.
    pub closing: Closing,
    /// Angle of the crank.
    #[input("θ_2", "deg")]
    pub angle: f64,
    /// Attachment of the second pair.
    pub attached: Attached,
    /// Length of link 5.
    #[input("l_5", "mm", positive)]
    pub link: f64,
    /// Output of link 5.
    pub output: LinkOutput,
    /// Load on the output.
    /// A force along the line of a slider, or a torque on a second rocker.
    pub load: OutputLoad,
    /// Angular velocity of the crank.
    /// Zero in statics.
    #[input("ω_2", "rad/s", default = "0 rad/s")]
    pub speed: f64,
    /// Angular acceleration of the crank.
    #[input("α_2", "rad/s^2", default = "0 rad/s^2")]
    pub acceleration: f64,
    /// Mass of the crank.
    #[input("2")]
    pub crank_mass: Option<LinkMass>,
    /// Mass of the coupler.
    #[input("3")]
    pub coupler_mass: Option<LinkMass>,
    /// Mass of the rocker.
    #[input("4")]
    pub rocker_mass: Option<LinkMass>,
    /// Mass of link 5.
    #[input("5")]
    pub link_mass: Option<LinkMass>,
    /// Acceleration of gravity.
    /// Zero for a mechanism in a horizontal plane.
    #[input("g", "m/s^2", planar, default = "(0; -9.81) m/s^2")]
    pub gravity: Vector3<f64>,
}

/// The point that the second pair hangs on.
#[derive(Clone, Debug, Inputs)]
pub enum Attached {
    /// On the rocker: Watt
    Rocker {
        /// Distance from the fixed pin, along the rocker.
        #[input("p", "mm")]
        along: f64,
        /// Distance from the line of its pins, to its left.
        #[input("q", "mm", default = "0 mm")]
        across: f64,
    },
    /// On the coupler: Stephenson
    Coupler {
        /// Distance from the crank pin, along the coupler.
        #[input("p", "mm")]
        along: f64,
        /// Distance from the line of its pins, to its left.
        #[input("q", "mm", default = "0 mm")]
        across: f64,
    },
}

/// Output of link 5.
#[derive(Clone, Debug, Inputs)]
pub enum LinkOutput {
    /// A slider
    Slider {
        /// A point of its line.
        #[input("Q", "mm", planar, default = "(0; 0) mm")]
        through: Vector3<f64>,
        /// Direction of its line.
        /// From the x axis, counter-clockwise; positive direction of the slider.
        #[input("φ", "deg", default = "0 deg")]
        direction: f64,
        /// Side of the slider.
        /// Viewed from the attachment point of the pair, along the line.
        side: SliderSide,
        /// Mass of the slider.
        #[input("m_6", "kg", nonnegative, default = "0 kg")]
        mass: f64,
    },
    /// A second rocker
    Rocker {
        /// Its fixed pin.
        #[input("E", "mm", planar)]
        pivot: Vector3<f64>,
        /// Its length.
        #[input("l_6", "mm", positive)]
        length: f64,
        /// Closing of the loop.
        /// Open: the pin of links 5 and 6 is to the left of the line from D to E.
        closing: Closing,
        /// Mass of the second rocker.
        #[input("6")]
        mass: Option<LinkMass>,
    },
}

/// On which side of the driving point the slider is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Inputs)]
pub enum SliderSide {
    /// Ahead
    Ahead,
    /// Behind
    Behind,
}

/// The load on the output, and what is asked for.
#[derive(Clone, Debug, Inputs)]
pub enum OutputLoad {
    /// Force on the slider
    Force {
        /// Force along its line.
        #[input("F", "N")]
        force: f64,
    },
    /// Torque on the second rocker
    Torque {
        /// Torque, positive counter-clockwise.
        #[input("T_6", "N*m")]
        torque: f64,
    },
    /// Unknown, with a given torque on the crank
    Unknown {
        /// Torque on the crank.
        /// Positive counter-clockwise.
        #[input("T_2", "N*m")]
        torque: f64,
    },
}

/// Results in one position.
pub struct SixBarPosition<N> {
    angles: [N; 4],
    /// Turns of links 3, 4, 5 for a unit turn of the crank.
    ratios: [N; 3],
    /// Angular velocities of links 3, 4, 5.
    speeds: [N; 3],
    /// Angular accelerations of links 3, 4, 5.
    accelerations: [N; 3],
    /// Slider: position, displacement, velocity, acceleration along its line; rocker: angle and its derivatives.
    output: [N; 4],
    torque: N,
    load: N,
    /// D and the pin of links 5 and 6, m.
    pins: [[f64; 2]; 2],
}

register!(SixBar);

/// Below this motion of the output for a unit turn of the crank it turns back.
const DEAD: f64 = 1e-9;

impl Analysis for SixBar {
    const ABOUT: About = About {
        id: "virtual-work/six-bar",
        title: "Six-bar linkage",
        topic: "Plane linkages",
        summary: "Torque or load of Watt and Stephenson six-bars with a slider or a second rocker, at rest or in motion with masses, by virtual work.",
        main: &["torque", "slider_velocity", "slider_displacement"],
        keywords: "mecanismo de seis barras Watt Stephenson prensa cursor balancim quadrilátero díade press linkage dwell \
                   six-bar four-bar slider dyad",
        sources: &[&RIUL, &SHIGLEY, &NORTON],
        cases: include_str!("../../cases/six_bar.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &SixBarGiven<W>, sheet: W) -> Result<(), Refusal> {
        let found = self.efforts(given, sheet)?;
        sheet.answer("coupler_angle", "Angle of the coupler", found.angles[0]);
        sheet.answer("rocker_angle", "Angle of the rocker", found.angles[1]);
        sheet.answer("link_angle", "Angle of link 5", found.angles[2]);
        sheet.answer("rocker_ratio", "Ratio of angular velocities, rocker to crank", found.ratios[1]);
        if self.moves() {
            let [coupler, rocker, link] = found.speeds;
            sheet.answer("coupler_speed", "Angular velocity of the coupler", coupler);
            sheet.answer("rocker_speed", "Angular velocity of the rocker", rocker);
            sheet.answer("link_speed", "Angular velocity of link 5", link);
            let [coupler, rocker, link] = found.accelerations;
            sheet.answer("coupler_acceleration", "Angular acceleration of the coupler", coupler);
            sheet.answer("rocker_acceleration", "Angular acceleration of the rocker", rocker);
            sheet.answer("link_acceleration", "Angular acceleration of link 5", link);
        }
        let [place, shift, velocity, acceleration] = found.output;
        match self.output {
            LinkOutput::Slider { .. } => {
                sheet.answer("slider_position", "Position of the slider", place);
                sheet.answer(
                    "slider_displacement",
                    "Displacement of the slider per unit rotation of the crank",
                    shift,
                );
                if self.moves() {
                    sheet.answer("slider_velocity", "Velocity of the slider", velocity);
                    sheet.answer("slider_acceleration", "Acceleration of the slider", acceleration);
                }
            }
            LinkOutput::Rocker { .. } => {
                sheet.answer("output_angle", "Angle of the second rocker", place);
                sheet.answer("output_ratio", "Ratio of angular velocities, second rocker to crank", shift);
                if self.moves() {
                    sheet.answer("output_speed", "Angular velocity of the second rocker", velocity);
                    let label = "Angular acceleration of the second rocker";
                    sheet.answer("output_acceleration", label, acceleration);
                }
            }
        }
        match (&self.load, &self.output) {
            (OutputLoad::Unknown { .. }, LinkOutput::Slider { .. }) => {
                sheet.answer("force", "Force on the slider", found.load);
            }
            (OutputLoad::Unknown { .. }, LinkOutput::Rocker { .. }) => {
                sheet.answer("load", "Torque on the second rocker", found.load);
            }
            _ => sheet.answer("torque", "Torque on the crank", found.torque),
        }
        let motions = self.moves().then(|| self.kinematics(given, &found, sheet));
        let plain = found.values();
        let (solved, joints) = self.built(&plain).map_err(built::refusal)?;
        let forces = joints.map(|joint| solved.reaction(joint));
        works::reaction(
            ["O", "Ox", "Oy"],
            ("crank_bearing_force", "Force in the fixed pin of the crank"),
            (&solved, joints[0]),
            sheet,
        );
        works::reaction(
            ["C", "Cx", "Cy"],
            ("rocker_bearing_force", "Force in the fixed pin of the rocker"),
            (&solved, joints[1]),
            sheet,
        );
        works::reaction(
            ["D", "Dx", "Dy"],
            ("driving_pin_force", "Force in the pin of the second pair"),
            (&solved, joints[2]),
            sheet,
        );
        sheet.verify(|| {
            // Known torque and known load: one of them must come out as the effort.
            solved.check_effort(0, found.torque, sheet);
            if let Some((of, motions)) = &motions {
                self.check_motions(of, motions, (&solved, &found));
            }
            let last = match self.output {
                LinkOutput::Slider { direction, .. } => built::turned([plain.load, forces[3][0]], direction),
                LinkOutput::Rocker { .. } => forces[3],
            };
            works::check_balance(&[forces[0], forces[1], last], solved.inertia_resultant(), sheet);
        });
        sheet.show(|| solved.works(0));
        self.show(sheet);
        Ok(())
    }
}

impl Template for SixBar {
    type Found<N: Real> = SixBarPosition<N>;

    fn efforts<W: Worksheet>(
        &self,
        given: &SixBarGiven<W>,
        sheet: W,
    ) -> Result<SixBarPosition<W::Num>, Refusal> {
        match (&self.load, &self.output) {
            (OutputLoad::Force { .. }, LinkOutput::Rocker { .. }) => {
                return Err(Refusal::because(
                    "the output is a rocker: give its load as a torque on the second rocker",
                ));
            }
            (OutputLoad::Torque { .. }, LinkOutput::Slider { .. }) => {
                return Err(Refusal::because(
                    "the output is a slider: give its load as a force on the slider",
                ));
            }
            _ => {}
        }
        let moves = self.moves();
        let zero = W::Num::from(0.0);
        let crank = RotatingLinkWork::crank(given.angle, given.speed, given.acceleration);
        let arm = works::direction::<W>(given.angle) * given.crank;
        let arm = sheet.step_vector(symbol("r", "2"), "mm", arm, "Crank, from O to A");
        let fixed = plane::<W>(given.frame, zero);
        let pin = works::moving("A", works::fixed(), arm, crank, moves, sheet);
        let supports = [
            DyadPin { name: "A", at: arm, moving: Some(pin) },
            DyadPin { name: "C", at: fixed, moving: None },
        ];
        let lengths = [given.coupler, given.rocker];
        let open = self.closing == Closing::Open;
        let pair = dyad::two_bars("AC", supports, lengths, [THREE, FOUR], open, sheet)?;
        let ratios = pair.turns("h", [Some(pin.shift), None]);
        let [coupler, rocker] = pair.motion(supports, ratios, given.speed, moves);
        let mut works = Works::new(given.gravity, moves, sheet);
        works.link(TWO, given.crank_mass.as_ref(), given.crank, works::fixed(), crank);
        works.link(THREE, given.coupler_mass.as_ref(), given.coupler, pin, coupler);
        works.link(FOUR, given.rocker_mass.as_ref(), given.rocker, works::fixed(), rocker);
        // D, the point that the second pair hangs on.
        let (along, across, link, first, from) = match given.attached {
            AttachedGiven::Rocker { along, across } => (along, across, rocker, works::fixed(), fixed),
            AttachedGiven::Coupler { along, across } => (along, across, coupler, pin, arm),
        };
        let unit = works::direction::<W>(link.angle);
        let mut reach = unit * along;
        if across.value() != 0.0 {
            reach = reach + works::across::<W>(unit) * across;
        }
        let reach = sheet.step_vector(symbol("r", "D"), "mm", reach, "From the first pin of its link to D");
        let place = sheet.step_vector(symbol("s", "D"), "mm", from + reach, "Point D, from the origin");
        let driving = works::moving("D", first, reach, link, moves, sheet);
        let support = DyadPin { name: "D", at: place, moving: Some(driving) };
        let (output, last, angles, end) = match (&self.output, &given.output) {
            (LinkOutput::Slider { side, .. }, LinkOutputGiven::Slider { through, direction, mass, .. }) => {
                let level = direction.value() == 0.0;
                let along = if level {
                    plane::<W>(1.0.into(), zero)
                } else {
                    let why = "Unit vector along the line of the slider";
                    sheet.step_vector("ê", "1", works::direction::<W>(*direction), why)
                };
                let line = SliderLine {
                    through: *through,
                    angle: (!level).then_some(*direction),
                    along,
                    left: if level { plane::<W>(zero, 1.0.into()) } else { works::across::<W>(along) },
                    behind: *side == SliderSide::Behind,
                };
                let pin = (support, driving);
                let slide = dyad::bar_and_slider(
                    "F",
                    FIVE,
                    pin,
                    given.link,
                    line,
                    moves.then_some(given.speed),
                    sheet,
                )?;
                let slider =
                    PointWork { shift: along * slide.shift, acceleration: along * slide.acceleration };
                works.link(FIVE, given.link_mass.as_ref(), given.link, driving, slide.bar);
                works.mass(SIX, *mass, slider);
                let output = [slide.position, slide.shift, slide.velocity, slide.acceleration];
                let end = place.value() + works::direction::<W>(slide.bar.angle).value() * self.link;
                (output, slide.bar, [slide.bar.angle, zero], end)
            }
            (LinkOutput::Rocker { closing, .. }, LinkOutputGiven::Rocker { pivot, length, mass, .. }) => {
                let supports = [support, DyadPin { name: "E", at: *pivot, moving: None }];
                let open = *closing == Closing::Open;
                let second = dyad::two_bars("DE", supports, [given.link, *length], [FIVE, SIX], open, sheet)?;
                let ratios = second.turns("h", [Some(driving.shift), None]);
                let [five, six] = second.motion(supports, ratios, given.speed, moves);
                works.link(FIVE, given.link_mass.as_ref(), given.link, driving, five);
                works.link(SIX, mass.as_ref(), *length, works::fixed(), six);
                let output = [six.angle, six.ratio, six.speed, six.acceleration];
                (output, five, second.angles, second.at.value())
            }
            _ => unreachable!("the given numbers are those of this problem"),
        };
        let (torque, load) = match given.load {
            OutputLoadGiven::Force { force: load } | OutputLoadGiven::Torque { torque: load } => {
                if load.value() != 0.0 {
                    let why = "Virtual work of the load on the output";
                    works.push(symbol("δW", "out"), load * output[1], why, RIUL.at("eq. 1"));
                }
                let why = "Torque: the total virtual work is zero, T_2 δθ_2 + ΣδW = 0";
                (sheet.step(symbol("T", "2"), "N*m", -works.sum(), (why, RIUL.at("eq. 5"))), load)
            }
            OutputLoadGiven::Unknown { torque } => {
                let size = if let LinkOutput::Slider { .. } = self.output { self.crank } else { 1.0 };
                if output[1].value().abs() <= DEAD * size {
                    return Err(Refusal::because(
                        "the output reverses here (dead centre): no load on it can balance a torque on the crank; rotate the crank slightly",
                    ));
                }
                works.driving(torque);
                let load = -(works.sum() / output[1]);
                let why = "Load, from the principle of virtual work";
                let load = match self.output {
                    LinkOutput::Slider { .. } => sheet.step("F", "N", load, (why, RIUL.at("eq. 5"))),
                    LinkOutput::Rocker { .. } => {
                        sheet.step(symbol("T", "6"), "N*m", load, (why, RIUL.at("eq. 5")))
                    }
                };
                (torque, load)
            }
        };
        let place = place.value();
        Ok(SixBarPosition {
            angles: [pair.angles[0], pair.angles[1], angles[0], angles[1]],
            ratios: [ratios[0], ratios[1], last.ratio],
            speeds: [coupler.speed, rocker.speed, last.speed],
            accelerations: [coupler.acceleration, rocker.acceleration, last.acceleration],
            output,
            torque,
            load,
            pins: [[place.x, place.y], [end.x, end.y]],
        })
    }
}

impl<N: Real> SixBarPosition<N> {
    /// The same as plain numbers.
    fn values(&self) -> SixBarPosition<f64> {
        SixBarPosition {
            angles: self.angles.map(Real::value),
            ratios: self.ratios.map(Real::value),
            speeds: self.speeds.map(Real::value),
            accelerations: self.accelerations.map(Real::value),
            output: self.output.map(Real::value),
            torque: self.torque.value(),
            load: self.load.value(),
            pins: self.pins,
        }
    }
}

impl SixBar {
    fn moves(&self) -> bool {
        self.speed != 0.0 || self.acceleration != 0.0
    }

    /// The same mechanism put together from its lengths, and its joints O, C, D and the last one to the frame. The
    /// crank is driven; the load acts on the output.
    fn built(&self, found: &SixBarPosition<f64>) -> Result<(Solved, [usize; 4]), PlanarError> {
        let mut it = Built::new([self.gravity.x, self.gravity.y]);
        let (pin, fixed) = (built::away([0.0; 2], self.crank, self.angle), [self.frame, 0.0]);
        let mass = |mass: &Option<LinkMass>, length: f64| LinkMass::built(mass.as_ref(), length);
        let two = it.link("crank", [0.0; 2], self.angle, mass(&self.crank_mass, self.crank));
        let three = it.link("coupler", pin, found.angles[0], mass(&self.coupler_mass, self.coupler));
        let four = it.link("rocker", fixed, found.angles[1], mass(&self.rocker_mass, self.rocker));
        let [place, end] = found.pins;
        let five = it.link("link 5", place, found.angles[2], mass(&self.link_mass, self.link));
        let driving = match self.attached {
            Attached::Rocker { along, across } => four.point([along, across]),
            Attached::Coupler { along, across } => three.point([along, across]),
        };
        let first = it.pin(BodyPoint::ground([0.0; 2]), two.point([0.0; 2]));
        it.pin(two.point([self.crank, 0.0]), three.point([0.0; 2]));
        it.pin(three.point([self.coupler, 0.0]), four.point([self.rocker, 0.0]));
        let second = it.pin(BodyPoint::ground(fixed), four.point([0.0; 2]));
        let third = it.pin(driving, five.point([0.0; 2]));
        let tip = five.point([self.link, 0.0]);
        let last = match &self.output {
            LinkOutput::Slider { through, direction, mass, .. } => {
                let six = it.link("slider", end, *direction, built::BuiltMass::at_pin(*mass));
                let slides = six.point([0.0; 2]);
                it.pin(tip, slides);
                if found.load != 0.0 {
                    it.force("Load", slides, built::turned([found.load, 0.0], *direction));
                }
                let guide = BodyPoint::ground([through.x, through.y]);
                it.join(PlanarJoint::Slider { guide, direction: *direction, slides, angle: *direction })
            }
            LinkOutput::Rocker { pivot, length, mass: of, .. } => {
                let at = [pivot.x, pivot.y];
                let six = it.link("second rocker", at, found.angles[3], mass(of, *length));
                it.pin(tip, six.point([*length, 0.0]));
                if found.load != 0.0 {
                    it.couple("Load", six, found.load);
                }
                it.pin(BodyPoint::ground(at), six.point([0.0; 2]))
            }
        };
        it.turn(two, [self.angle, self.speed, self.acceleration]);
        Ok((it.solve()?, [first, second, third, last]))
    }

    fn show<W: Worksheet>(&self, sheet: W) {
        let at = |angle: f64| SixBar { angle, ..self.clone() };
        let kinematic = |angle: f64| {
            let load = match self.output {
                LinkOutput::Slider { .. } => OutputLoad::Force { force: 0.0 },
                LinkOutput::Rocker { .. } => OutputLoad::Torque { torque: 0.0 },
            };
            SixBar { angle, load, speed: 0.0, acceleration: 0.0, ..self.clone() }.plain().is_some()
        };
        let range = Range::about(self.angle, kinematic);
        let cycle = TemplateRange::new(range, "angle", at);
        if !matches!(self.load, OutputLoad::Unknown { .. }) {
            sheet.show(|| cycle.torque(|found| found.torque));
        }
        sheet.show(|| {
            let (title, label, unit, answer) = match self.output {
                LinkOutput::Slider { .. } => {
                    ("Displacement of the slider", "Position of the slider", "mm", "slider_position")
                }
                LinkOutput::Rocker { .. } => {
                    ("Swing of the second rocker", "Angle of the second rocker", "deg", "output_angle")
                }
            };
            cycle.plot(title, (label, unit), &[("output", answer, &|found| found.output[0])])
        });
        sheet.show(|| {
            let still = self.plain().map_or([0.0; 2], |found| found.pins[1]);
            let way = |found: &SixBarPosition<f64>| {
                let LinkOutput::Slider { direction, .. } = self.output else { return 0.0 };
                let [x, y] = found.pins[1];
                (x - still[0]) * direction.cos() + (y - still[1]) * direction.sin()
            };
            let (low, high) = figure::way(&cycle.curve(way));
            let size = self.frame + self.crank + self.coupler;
            built::animation("The six-bar linkage", ("angle", self.angle), range, size, |angle, sketch| {
                at(angle).draw(At::from(still), (low, high), sketch)
            })
        });
    }
}
