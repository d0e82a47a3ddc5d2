//! Quick-return mechanisms: a crank drives a slotted lever, which may push a slider.

mod motion;

use std::f64::consts::{PI, TAU};

use dalembert_core::{About, Analysis, Inputs, Refusal, Worksheet, exhibit::Point as At, register};
use dalembert_mechanics::{
    Real, Vector,
    planar::{BodyPoint, PlanarError, PlanarJoint, PlanarLoad, RelativeCoordinate},
};
use nalgebra::Vector3;

use crate::{
    shared::{
        built::{self, Built, Range, Solved, Template, TemplateRange},
        dyad::{self, DyadPin, SliderLine},
        figure, kinematics,
        works::{self, FIVE, FOUR, LinkMass, PointWork, RotatingLinkWork, SIX, TWO, Works, plane, symbol},
    },
    sources::{KHURMI, NORTON, RIUL, SHIGLEY},
};

/// A quick-return mechanism in one position.
///
/// The slotted lever turns about the origin C, the crank about O straight above it; the crank pin A slides along the
/// lever. A crank shorter than the distance of the pivots swings the lever (crank and slotted lever), a longer one
/// turns it round (Whitworth).
#[derive(Clone, Debug, Inputs)]
pub struct QuickReturn {
    /// Length of the crank.
    #[input("r", "mm", positive)]
    pub crank: f64,
    /// Distance between the pivots.
    /// The crank pivot is above the lever pivot.
    #[input("d", "mm", positive)]
    pub frame: f64,
    /// Length of the lever.
    /// From its pivot to its end.
    #[input("L", "mm", positive)]
    pub lever: f64,
    /// Angle of the crank.
    /// From the x axis, counter-clockwise; at 90° the crank points away from the lever's pivot.
    #[input("θ_2", "deg")]
    pub angle: f64,
    /// Output of the lever.
    pub output: LeverOutput,
    /// Find.
    pub unknown: QuickReturnUnknown,
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
    /// Mass of the lever.
    #[input("4")]
    pub lever_mass: Option<LinkMass>,
    /// Acceleration of gravity.
    /// Zero for a mechanism in a horizontal plane.
    #[input("g", "m/s^2", planar, default = "(0; -9.81) m/s^2")]
    pub gravity: Vector3<f64>,
}

/// Output of the lever.
#[derive(Clone, Debug, Inputs)]
pub enum LeverOutput {
    /// A force perpendicular to the lever at its end
    Lever,
    /// A slider through a link: shaper
    Slider {
        /// Length of the link.
        #[input("l", "mm", positive)]
        link: f64,
        /// Height of the slider's line.
        /// Above the pivot of the lever; the slider moves along x.
        #[input("h", "mm")]
        height: f64,
        /// Side of the slider.
        /// Viewed from the end of the lever, along x.
        side: RamSide,
        /// Mass of the link.
        #[input("5")]
        link_mass: Option<LinkMass>,
        /// Mass of the slider.
        #[input("m_6", "kg", nonnegative, default = "0 kg")]
        slider_mass: f64,
    },
}

/// On which side of the end of the lever the slider is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Inputs)]
pub enum RamSide {
    /// Ahead
    Ahead,
    /// Behind
    Behind,
}

/// Unknown of the sum of virtual works.
#[derive(Clone, Debug, Inputs)]
pub enum QuickReturnUnknown {
    /// Torque on the crank
    Torque {
        /// Force on the output.
        /// On the slider along x; on the lever perpendicular to it at its end, counter-clockwise.
        #[input("F", "N")]
        force: f64,
    },
    /// Force on the output
    Force {
        /// Torque on the crank.
        /// Positive counter-clockwise.
        #[input("T_2", "N*m")]
        torque: f64,
    },
}

/// Results in one position.
pub struct QuickReturnPosition<N> {
    lever: RotatingLinkWork<N>,
    reach: N,
    slip: N,
    slip_acceleration: N,
    coriolis: N,
    link: Option<(N, N, N, N)>,
    /// Displacement of the output for a unit turn of the crank.
    shift: N,
    velocity: N,
    acceleration: N,
    torque: N,
    force: N,
}

register!(QuickReturn);

/// Displacements below this part of the crank are those of a dead centre.
const DEAD: f64 = 1e-9;

impl Analysis for QuickReturn {
    const ABOUT: About = About {
        id: "virtual-work/quick-return",
        title: "Quick-return mechanism",
        topic: "Plane linkages",
        summary: "Torque or force, motion with Coriolis acceleration, time ratio and reactions of crank and slotted lever, Whitworth and shaper.",
        main: &["slider_velocity", "torque", "time_ratio", "lever_speed"],
        keywords: "retorno rápido plaina limadora manivela balancim ranhurado Whitworth Coriolis razão de tempos torno \
                   crank and slotted lever shaper quick return time ratio",
        sources: &[&RIUL, &SHIGLEY, &KHURMI, &NORTON],
        cases: include_str!("../../cases/quick_return.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &QuickReturnGiven<W>, sheet: W) -> Result<(), Refusal> {
        let found = self.efforts(given, sheet)?;
        sheet.answer("lever_angle", "Angle of the lever", found.lever.angle);
        sheet.answer("lever_ratio", "Ratio of angular velocities, lever to crank", found.lever.ratio);
        if self.moves() {
            sheet.answer("lever_speed", "Angular velocity of the lever", found.lever.speed);
            let across = sheet.step(
                symbol("v", "t"),
                "m/s",
                found.reach * found.lever.speed,
                "Velocity of the point of the lever that is under the crank pin, across it",
            );
            sheet.answer("lever_point_velocity", "Velocity of the lever under the crank pin", across);
            sheet.verify(|| {
                let (both, pin) = (across.powi(2) + found.slip.powi(2), given.crank * given.speed);
                let what = "velocities along and across the lever make up that of the crank pin";
                sheet.check(what, both, pin.powi(2));
            });
            sheet.answer("slip_velocity", "Velocity of the crank pin along the lever", found.slip);
            sheet.answer(
                "slip_acceleration",
                "Acceleration of the crank pin along the lever",
                found.slip_acceleration,
            );
            sheet.answer("coriolis_acceleration", "Coriolis acceleration of the crank pin", found.coriolis);
            sheet.answer("lever_acceleration", "Angular acceleration of the lever", found.lever.acceleration);
            if found.link.is_some() {
                sheet.answer("slider_velocity", "Velocity of the slider", found.velocity);
                sheet.answer("slider_acceleration", "Acceleration of the slider", found.acceleration);
            }
        }
        if let Some((position, ..)) = found.link {
            sheet.answer("slider_position", "Position of the slider", position);
        }
        match self.unknown {
            QuickReturnUnknown::Torque { .. } => sheet.answer("torque", "Torque on the crank", found.torque),
            QuickReturnUnknown::Force { .. } => sheet.answer("force", "Force on the output", found.force),
        }
        self.times(given, sheet);
        let motions = self.moves().then(|| self.kinematics(given, &found, sheet));
        let (solved, joints) = self.built(&found).map_err(built::refusal)?;
        let forces = joints.map(|joint| solved.reaction(joint));
        works::reaction(
            ["O", "Ox", "Oy"],
            ("crank_bearing_force", "Force in the bearing of the crank"),
            (&solved, joints[0]),
            sheet,
        );
        works::reaction(
            ["C", "Cx", "Cy"],
            ("lever_pivot_force", "Force in the pivot of the lever"),
            (&solved, joints[1]),
            sheet,
        );
        let why = "Force of the lever on the crank pin, perpendicular to the lever, by the same equations";
        let across = sheet.numerical("N", "N", forces[2][0], (why, SHIGLEY.at("ch. 11")));
        sheet.answer("pin_force", "Force of the lever on the crank pin, perpendicular to the lever", across);
        sheet.verify(|| {
            let effort = match (&self.unknown, &self.output) {
                (QuickReturnUnknown::Force { .. }, LeverOutput::Slider { .. }) => found.force,
                _ => found.torque,
            };
            solved.check_effort(0, effort, sheet);
            solved.check_across(joints[2], across, sheet);
            if let Some((of, [a, b])) = &motions {
                of.check(&kinematics::A, *a, &solved, 0, [self.crank, 0.0]);
                of.check(&kinematics::B, *b, &solved, 1, [self.lever, 0.0]);
                self.check_slip(given, &found, sheet);
            }
            let force = found.force.value();
            let outside = match self.output {
                LeverOutput::Lever => built::turned([0.0, force], found.lever.angle.value()),
                LeverOutput::Slider { .. } => [force, solved.reaction(joints[3])[0]],
            };
            works::check_balance(&[forces[0], forces[1], outside], solved.inertia_resultant(), sheet);
        });
        sheet.show(|| solved.works(0));
        self.show(sheet);
        Ok(())
    }
}

impl Template for QuickReturn {
    type Found<N: Real> = QuickReturnPosition<N>;

    fn efforts<W: Worksheet>(
        &self,
        given: &QuickReturnGiven<W>,
        sheet: W,
    ) -> Result<QuickReturnPosition<W::Num>, Refusal> {
        let moves = self.moves();
        let zero = W::Num::from(0.0);
        let crank = RotatingLinkWork::crank(given.angle, given.speed, given.acceleration);
        let arm = works::direction::<W>(given.angle) * given.crank;
        let arm = sheet.step_vector(symbol("r", "2"), "mm", arm, "Crank, from O to A");
        let pin = works::moving("A", works::fixed(), arm, crank, moves, sheet);
        let from_pivot = plane::<W>(zero, given.frame) + arm;
        let from_pivot = sheet.step_vector(
            symbol("s", "CA"),
            "mm",
            from_pivot,
            "From the pivot of the lever to the crank pin",
        );
        let reach = sheet.step(
            "ρ",
            "mm",
            from_pivot.magnitude(),
            "Distance of the crank pin from the pivot of the lever",
        );
        if reach.value() <= DEAD * self.frame {
            return Err(Refusal::because(
                "the crank pin is at the pivot of the lever: the lever has no direction; turn the crank or change a length",
            ));
        }
        let [x, y, _] = from_pivot.components();
        let angle = sheet.step(symbol("θ", "4"), "deg", y.atan2(x), "Angle of the lever");
        let along = sheet.step_vector("ê", "1", works::direction::<W>(angle), "Unit vector along the lever");
        let across = works::across::<W>(along);
        let why = "Virtual rotation of the lever: it follows the crank pin across its slot";
        let ratio = pin.shift.dot(across) / reach;
        let ratio = sheet.step(symbol("h", "4"), "1", ratio, (why, SHIGLEY.at("ch. 3")));
        let mut lever = RotatingLinkWork { angle, ratio, speed: zero, acceleration: zero };
        let (mut slip, mut slip_acceleration, mut coriolis) = (zero, zero, zero);
        if moves {
            lever.speed =
                sheet.step(symbol("ω", "4"), "rad/s", ratio * given.speed, "Angular velocity of the lever");
            slip = sheet.step(
                symbol("v", "s"),
                "m/s",
                pin.shift.dot(along) * given.speed,
                "Velocity of the crank pin along the slot",
            );
            coriolis = kinematics::coriolis(lever.speed, slip, given.speed, sheet);
            slip_acceleration = sheet.step(
                symbol("a", "s"),
                "m/s^2",
                pin.acceleration.dot(along) + reach * lever.speed.powi(2),
                ("Acceleration of the crank pin along the slot", SHIGLEY.at("ch. 4")),
            );
            let turning = (pin.acceleration.dot(across) - coriolis) / reach;
            let why = ("Angular acceleration of the lever", SHIGLEY.at("ch. 4"));
            lever.acceleration = sheet.step(symbol("α", "4"), "rad/s^2", turning, why);
        }
        let mut works = Works::new(given.gravity, moves, sheet);
        works.link(TWO, given.crank_mass.as_ref(), given.crank, works::fixed(), crank);
        works.link(FOUR, given.lever_mass.as_ref(), given.lever, works::fixed(), lever);
        let (shift, velocity, acceleration, link) = match (&self.output, &given.output) {
            (
                LeverOutput::Slider { side, .. },
                LeverOutputGiven::Slider { link, height, link_mass, slider_mass, .. },
            ) => {
                let arm = sheet.step_vector(
                    symbol("r", "B"),
                    "mm",
                    along * given.lever,
                    "Lever, from C to its end B",
                );
                let end = works::moving("B", works::fixed(), arm, lever, moves, sheet);
                let support = DyadPin { name: "B", at: arm, moving: Some(end) };
                let line = SliderLine {
                    through: plane::<W>(zero, *height),
                    angle: None,
                    along: plane::<W>(1.0.into(), zero),
                    left: plane::<W>(zero, 1.0.into()),
                    behind: *side == RamSide::Behind,
                };
                let slide = dyad::bar_and_slider(
                    "D",
                    FIVE,
                    (support, end),
                    *link,
                    line,
                    moves.then_some(given.speed),
                    sheet,
                )?;
                works.link(FIVE, link_mass.as_ref(), *link, end, slide.bar);
                let moving = PointWork {
                    shift: plane::<W>(slide.shift, zero),
                    acceleration: plane::<W>(slide.acceleration, zero),
                };
                works.mass(SIX, *slider_mass, moving);
                let link = (slide.position, slide.bar.angle, slide.bar.speed, slide.bar.acceleration);
                (slide.shift, slide.velocity, slide.acceleration, Some(link))
            }
            _ => {
                let why = "Virtual displacement of the end of the lever, across it";
                let shift =
                    sheet.step(symbol("u", "B"), "mm", given.lever * ratio, (why, SHIGLEY.at("ch. 3")));
                (shift, zero, zero, None)
            }
        };
        let (torque, force) = match given.unknown {
            QuickReturnUnknownGiven::Torque { force } => {
                (works.balanced("F", force * shift, "Virtual work of the force on the output"), force)
            }
            QuickReturnUnknownGiven::Force { torque } => {
                if shift.value().abs() <= DEAD * self.crank {
                    return Err(Refusal::because(
                        "the output reverses here (dead centre): no force on it can balance a torque on the crank; rotate the crank slightly",
                    ));
                }
                works.driving(torque);
                let why = "Force, from the principle of virtual work, F u + ΣδW = 0";
                (torque, sheet.step("F", "N", -(works.sum() / shift), (why, RIUL.at("eq. 5"))))
            }
        };
        Ok(QuickReturnPosition {
            lever,
            reach,
            slip,
            slip_acceleration,
            coriolis,
            link,
            shift,
            velocity,
            acceleration,
            torque,
            force,
        })
    }
}

impl QuickReturn {
    fn moves(&self) -> bool {
        self.speed != 0.0 || self.acceleration != 0.0
    }

    /// Time ratio of the forward to the return stroke, and the swing angle of the lever.
    fn times<W: Worksheet>(&self, given: &QuickReturnGiven<W>, sheet: W) {
        if self.crank == self.frame {
            return;
        }
        let swings = self.crank < self.frame;
        let (lean, why) = if swings {
            (
                given.crank / given.frame,
                "The lever is tangent to the crank-pin circle: half its swing, sin ψ = r/d",
            )
        } else {
            (given.frame / given.crank, "The lever is perpendicular to the line of the pivots: sin ψ = d/r")
        };
        let half = sheet.step("ψ", "deg", lean.asin(), (why, KHURMI.at("§5.18")));
        let ratio = (W::Num::from(PI) + half * 2.0) / (W::Num::from(PI) - half * 2.0);
        let why = "Forward over return time at constant speed, from the crank angles between the ends";
        let ratio = sheet.step("Q", "1", ratio, (why, NORTON.at("ch. 3")));
        sheet.answer("time_ratio", "Time ratio, forward over return", ratio);
        sheet.verify(|| {
            // The crank angle of the way forward, less the half turn, is twice that of the ends from the level.
            let past = (ratio / (ratio + 1.0) - 0.5) * PI;
            let (reach, height) = if swings {
                (given.crank, given.frame * past.sin())
            } else {
                (given.frame, given.crank * past.sin())
            };
            let what = if swings {
                "crank and lever are at right angles at the ends of the forward stroke"
            } else {
                "the crank pin is level with the pivot of the lever at the ends of the forward stroke"
            };
            sheet.check_sum(what, height, reach, self.crank.max(self.frame));
        });
        if swings {
            let swing = sheet.step("Δθ_4", "deg", half * 2.0, "Swing of the lever");
            sheet.answer("swing", "Swing of the lever", swing);
            sheet.verify(|| {
                let (r, d) = (self.crank, self.frame);
                // The lever at the crank angle −ψ, where it turns back; on the other side it is the mirror image.
                let height = d - r * r / d;
                let end = height.atan2(r * (height / d).max(0.0).sqrt());
                let what = "swing of the lever between the two positions in which it is tangent to the crank-pin circle";
                sheet.check_sum(what, swing, (PI - 2.0 * end).into(), PI);
            });
        }
    }

    fn pin(&self) -> [f64; 2] {
        built::away([0.0, self.frame], self.crank, self.angle)
    }

    /// The same mechanism put together from its lengths, and its joints: O, C, slot, and the guide of the slider.
    fn built<N: Real>(&self, found: &QuickReturnPosition<N>) -> Result<(Solved, [usize; 4]), PlanarError> {
        let mut it = Built::new([self.gravity.x, self.gravity.y]);
        let centre = [0.0, self.frame];
        let mass = |mass: &Option<LinkMass>, length: f64| LinkMass::built(mass.as_ref(), length);
        let crank = it.link("crank", centre, self.angle, mass(&self.crank_mass, self.crank));
        let angle = found.lever.angle.value();
        let lever = it.link("lever", [0.0; 2], angle, mass(&self.lever_mass, self.lever));
        let slot = PlanarJoint::Slot {
            guide: lever.point([0.0; 2]),
            direction: 0.0,
            pin: crank.point([self.crank, 0.0]),
            offset: 0.0,
        };
        let mut joints = [
            it.pin(BodyPoint::ground(centre), crank.point([0.0; 2])),
            it.pin(BodyPoint::ground([0.0; 2]), lever.point([0.0; 2])),
            it.join(slot),
            0,
        ];
        let end = lever.point([self.lever, 0.0]);
        let mut slides = None;
        if let (
            LeverOutput::Slider { link, height, link_mass, slider_mass, .. },
            Some((position, tilt, ..)),
        ) = (&self.output, &found.link)
        {
            let at = built::away([0.0; 2], self.lever, angle);
            let bar = it.link("link", at, tilt.value(), mass(link_mass, *link));
            let place = [position.value(), *height];
            let slider = it.link("slider", place, 0.0, built::BuiltMass::at_pin(*slider_mass));
            let (guide, pin) = (BodyPoint::ground([0.0, *height]), slider.point([0.0; 2]));
            it.pin(end, bar.point([0.0; 2]));
            it.pin(bar.point([*link, 0.0]), pin);
            joints[3] = it.join(PlanarJoint::Slider { guide, direction: 0.0, slides: pin, angle: 0.0 });
            let along = RelativeCoordinate::Component { direction: [1.0, 0.0], from: guide, to: pin };
            let motion = [position.value(), found.velocity.value(), found.acceleration.value()];
            slides = Some((pin, along, motion));
        }
        let force = found.force.value();
        let turning = [self.angle, self.speed, self.acceleration];
        match (&self.unknown, slides) {
            (QuickReturnUnknown::Torque { .. }, Some((pin, ..))) => {
                if force != 0.0 {
                    it.force("Force on the output", pin, [force, 0.0]);
                }
                it.turn(crank, turning);
            }
            (QuickReturnUnknown::Force { torque }, Some((_, along, motion))) => {
                if *torque != 0.0 {
                    it.couple("Torque on the crank", crank, *torque);
                }
                it.drive(along, motion);
            }
            // With the force on the lever the torque on the crank must come out, whichever of the two was asked for.
            (_, None) => {
                if force != 0.0 {
                    let across =
                        PlanarLoad::Force { at: end, force: [0.0, force], turns_with: lever.frame() };
                    it.load("Force on the output", across);
                }
                it.turn(crank, turning);
            }
        }
        Ok((it.solve()?, joints))
    }

    fn show<W: Worksheet>(&self, sheet: W) {
        let at = |angle: f64| QuickReturn { angle, ..self.clone() };
        let range = Range::about(self.angle, |angle| self.reached(angle));
        let cycle = TemplateRange::new(range, "angle", at);
        match self.unknown {
            QuickReturnUnknown::Torque { .. } => sheet.show(|| cycle.torque(|found| found.torque)),
            QuickReturnUnknown::Force { .. } => sheet.show(|| {
                cycle.plot(
                    "Force over one revolution",
                    ("Force on the output", "N"),
                    &[("force", "force", &|found| built::bounded(found.force, found.shift, self.crank))],
                )
            }),
        }
        sheet.show(|| {
            cycle.plot(
                "Velocity ratio",
                ("Ratio of angular velocity to that of the crank", "1"),
                &[("lever", "lever_ratio", &|found| found.lever.ratio)],
            )
        });
        if self.moves() && matches!(self.output, LeverOutput::Slider { .. }) {
            sheet.show(|| {
                cycle.plot(
                    "Velocity of the slider",
                    ("Velocity of the slider", "m/s"),
                    &[("velocity", "slider_velocity", &|found| found.velocity)],
                )
            });
        }
        sheet.show(|| {
            let position = |found: &QuickReturnPosition<f64>| found.link.map_or(f64::INFINITY, |link| link.0);
            let (low, high) = figure::way(&cycle.curve(position));
            built::animation(
                "The quick-return mechanism",
                ("angle", self.angle),
                range,
                self.lever,
                |angle, sketch| {
                    let there = at(angle);
                    let found = there.plain()?;
                    let (o, centre, pin) = ((0.0, 0.0), (0.0, there.frame), At::from(there.pin()));
                    let end = At::from(built::away([0.0; 2], there.lever, found.lever.angle));
                    let unit = sketch.symbol();
                    sketch.dimension("d", o, centre, 6.0);
                    if let (
                        LeverOutput::Slider { height, link_mass, slider_mass, .. },
                        Some((position, ..)),
                    ) = (&there.output, found.link)
                    {
                        let slider = (position, *height);
                        let (from, to) = (low - 3.0 * unit, high + 3.0 * unit);
                        sketch
                            .guide((from, *height), (to, *height))
                            .dimension("h", (from, 0.0), (from, *height), 0.0)
                            .axis(o, (from, 0.0))
                            .slider("", slider, 0.0)
                            .link("l", end, slider);
                        figure::link_mass(sketch, 5, link_mass.as_ref(), (end, slider), 2.0);
                        let mass = if *slider_mass == 0.0 { "" } else { "m₆" };
                        sketch.label(mass, (position, height - 0.6 * unit));
                        sketch.joint("", slider);
                        figure::on_slider(sketch, "F", slider, (found.force, 0.0), 0.4 * there.lever);
                    } else {
                        let force = built::turned([0.0, found.force], found.lever.angle);
                        built::forces(sketch, &[("F", end, force)], 0.5 * there.lever);
                    }
                    sketch
                        .slider("", pin, found.lever.angle)
                        .bars([o, end])
                        .label("L", figure::away(end, -0.2 * there.lever, found.lever.angle))
                        .link("r", centre, pin)
                        .axis(centre, (6.0 * unit, centre.1))
                        .pin("C", o)
                        .pin("O", centre)
                        .joint("A", pin)
                        .joint("B", end)
                        .angle("θ₂", centre, 0.0, angle.rem_euclid(TAU));
                    figure::link_mass(sketch, 2, there.crank_mass.as_ref(), (centre, pin), 2.0);
                    figure::link_mass(sketch, 4, there.lever_mass.as_ref(), (o, end), -3.0);
                    let torque = match there.unknown {
                        QuickReturnUnknown::Force { torque } => torque,
                        QuickReturnUnknown::Torque { .. } => 0.0,
                    };
                    figure::turning(sketch, centre, ("ω₂", there.speed), ("T₂", torque));
                    Some(())
                },
            )
        });
    }

    /// Returns true if the mechanism closes at a crank angle, dead centres included.
    fn reached(&self, angle: f64) -> bool {
        let LeverOutput::Slider { link, height, .. } = self.output else { return true };
        let [x, y] = QuickReturn { angle: angle.rem_euclid(TAU), ..self.clone() }.pin();
        (height - self.lever * y / x.hypot(y)).abs() < link
    }
}
