//! The slider-crank, in line or offset: torque or force, motion and reactions.

use dalembert_core::{
    About, Analysis, Ink, Inputs, Refusal, Text, Worksheet, exhibit::Point as At, register,
};
use dalembert_mechanics::{
    Real, Vector,
    planar::{BodyPoint, PlanarError, PlanarJoint, RelativeCoordinate},
    slider_crank as loops,
};
use nalgebra::Vector3;
use std::f64::consts::{FRAC_PI_2, TAU};

use crate::{
    shared::{
        built::{self, Built, Range, Solved, Template, TemplateRange},
        figure,
        kinematics::{self, Kinematics, Motion, slider_acceleration_errors},
        works::{self, FOUR, LinkMass, PointWork, RotatingLinkWork, THREE, TWO, Works, plane, symbol},
    },
    sources::{BEER, NORTON, RIUL, SHIGLEY},
};

/// A slider-crank in one position.
///
/// The bearing of the crank is the origin, the slider moves along x, angles are counter-clockwise. O is the bearing, A
/// the crank pin, B the pin of the slider.
#[derive(Clone, Debug, Inputs)]
pub struct SliderCrank {
    /// Length of the crank.
    #[input("r", "mm", positive)]
    pub crank: f64,
    /// Length of the rod.
    #[input("l", "mm", positive)]
    pub rod: f64,
    /// Offset.
    /// Height of the slider's line above the bearing of the crank.
    #[input("e", "mm", default = "0 mm")]
    pub offset: f64,
    /// Angle of the crank.
    /// From the slider's line, counter-clockwise.
    #[input("θ_2", "deg")]
    pub angle: f64,
    /// Find.
    pub unknown: SliderCrankUnknown,
    /// Force on the crank pin.
    /// It acts on the crank.
    #[input("F_A", "N", planar, default = "(0; 0) N")]
    pub pin_force: Vector3<f64>,
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
    /// Mass of the rod.
    #[input("3")]
    pub rod_mass: Option<LinkMass>,
    /// Mass of the slider.
    #[input("m_4", "kg", nonnegative, default = "0 kg")]
    pub slider_mass: f64,
    /// Acceleration of gravity.
    /// Zero for a mechanism in a horizontal plane.
    #[input("g", "m/s^2", planar, default = "(0; -9.81) m/s^2")]
    pub gravity: Vector3<f64>,
}

/// Unknown of the sum of virtual works.
#[derive(Clone, Debug, Inputs)]
pub enum SliderCrankUnknown {
    /// Torque on the crank
    Torque {
        /// Force on the slider.
        /// Positive away from the bearing of the crank, along x.
        #[input("F_B", "N")]
        force: f64,
    },
    /// Force on the slider
    Force {
        /// Torque on the crank.
        /// Positive counter-clockwise.
        #[input("T_2", "N*m")]
        torque: f64,
    },
}

/// Results in one position.
pub struct SliderCrankPosition<N> {
    rod_angle: N,
    position: N,
    ratio: N,
    shift: N,
    rod_speed: N,
    velocity: N,
    rod_acceleration: N,
    acceleration: N,
    torque: N,
    force: N,
}

register!(SliderCrank);

/// The rod stands across the slider's line below this cosine.
const FLAT: f64 = 1e-7;
/// Crank and rod are in line below this displacement of the slider for a unit turn, in crank lengths.
const DEAD: f64 = 1e-9;

impl Analysis for SliderCrank {
    const ABOUT: About = About {
        id: "virtual-work/slider-crank",
        title: "Slider-crank",
        topic: "Plane linkages",
        summary: "Torque on the crank or force on the slider of a slider-crank, at rest or in motion with masses, by virtual work; motion, transmission angle and reactions.",
        main: &["torque", "force", "slider_velocity", "slider_acceleration"],
        keywords: "cursor manivela biela pistão compressor motor prensa trabalho virtual torque força reações engine piston \
                   connecting rod crank pump compressor virtual work static dynamic offset ângulo de transmissão transmission angle \
                   biela-manivela cursor-manivela slider-crank kinematic analysis análise cinemática do mecanismo",
        sources: &[&RIUL, &BEER, &SHIGLEY, &NORTON],
        cases: include_str!("../../cases/slider_crank.toml"),
    };
    const SIMD: bool = true;

    #[inline(always)]
    fn solve<W: Worksheet>(&self, given: &SliderCrankGiven<W>, sheet: W) -> Result<(), Refusal> {
        let found = self.efforts(given, sheet)?;
        let moves = works::moves(given.speed, given.acceleration);
        sheet.answer("rod_angle", "Angle of the connecting rod", found.rod_angle);
        sheet.answer("slider_position", "Position of the slider", found.position);
        if moves {
            sheet.answer("rod_speed", "Angular velocity of the rod", found.rod_speed);
            sheet.answer("slider_velocity", "Velocity of the slider", found.velocity);
            sheet.answer("rod_acceleration", "Angular acceleration of the rod", found.rod_acceleration);
            sheet.answer("slider_acceleration", "Acceleration of the slider", found.acceleration);
        }
        match self.unknown {
            SliderCrankUnknown::Torque { .. } => sheet.answer("torque", "Torque on the crank", found.torque),
            SliderCrankUnknown::Force { .. } => sheet.answer("force", "Force on the slider", found.force),
        }
        sheet.keep_going()?;
        self.transmission(given, found.rod_angle, sheet);
        if found.shift.holds_with(given.crank, |shift, crank| shift.abs() > DEAD * crank) {
            let why = "Ratio of the force on the slider to the force perpendicular to the crank at its pin, T/r, neglecting masses";
            let advantage = given.crank / found.shift.abs();
            let advantage = sheet.step("MA", "1", advantage, (why, SHIGLEY.at("ch. 3")));
            sheet.answer("mechanical_advantage", "Mechanical advantage", advantage);
            sheet.verify(|| {
                let (two, three) = (given.angle, found.rod_angle);
                let arm = given.crank * (two.sin() - two.cos() * three.tan());
                let what = "mechanical advantage by instant centre 24: the crank over the arm that the line of the rod cuts off at the bearing";
                sheet.check(what, advantage * arm.abs(), given.crank);
            });
        }
        sheet.keep_going()?;
        let motions = if moves { Some(self.kinematics(given, &found, sheet)) } else { None };
        sheet.keep_going()?;
        let plain = SliderCrankPosition {
            rod_angle: found.rod_angle.value(),
            position: found.position.value(),
            ratio: found.ratio.value(),
            shift: found.shift.value(),
            rod_speed: found.rod_speed.value(),
            velocity: found.velocity.value(),
            rod_acceleration: found.rod_acceleration.value(),
            acceleration: found.acceleration.value(),
            torque: found.torque.value(),
            force: found.force.value(),
        };
        let (solved, joints) = self.built(&plain).map_err(built::refusal)?;
        let [bearing, guide] = [joints[0], joints[3]].map(|joint| solved.reaction(joint));
        works::reaction(
            ["O", "Ox", "Oy"],
            ("bearing_force", "Force in the bearing of the crank"),
            (&solved, joints[0]),
            sheet,
        );
        let label = "Force in the crank pin";
        works::reaction(["A", "Ax", "Ay"], ("crank_pin_force", label), (&solved, joints[1]), sheet);
        works::reaction(
            ["B", "Bx", "By"],
            ("slider_pin_force", "Force in the pin of the slider"),
            (&solved, joints[2]),
            sheet,
        );
        let why = "Force of the guide on the slider, perpendicular to its line, by the same equations";
        let across = sheet.numerical("N", "N", guide[0], (why, SHIGLEY.at("ch. 11")));
        sheet.answer("guide_force", "Force of the guide on the slider", across);
        sheet.verify(|| {
            let effort = match self.unknown {
                SliderCrankUnknown::Torque { .. } => found.torque,
                SliderCrankUnknown::Force { .. } => found.force,
            };
            solved.check_effort(0, effort, sheet);
            solved.check_across(joints[3], across, sheet);
            if let Some((of, motions)) = &motions {
                of.check_relative(["B", "A", "BA"], *motions);
                of.check(&kinematics::A, motions[1], &solved, 0, [self.crank, 0.0]);
            }
            let outside = [bearing, [plain.force, guide[0]], [self.pin_force.x, self.pin_force.y]];
            works::check_balance(&outside, solved.inertia_resultant(), sheet);
            if moves {
                let (r, l, two, three) = (given.crank, given.rod, given.angle, found.rod_angle);
                let speed = loops::rod_speed(r, l, two, three, given.speed);
                sheet.check(
                    "angular velocity of the rod from the closure of the loop",
                    found.rod_speed,
                    speed,
                );
                sheet.check_zero(
                    "velocity of the slider from the closure of the loop",
                    found.velocity - loops::slider_velocity(r, l, two, three, given.speed, speed),
                    self.crank * self.speed.abs(),
                );
            }
        });
        sheet.show(|| solved.works(0));
        self.show(sheet);
        Ok(())
    }
}

impl Template for SliderCrank {
    type Found<N: Real> = SliderCrankPosition<N>;

    #[inline(always)]
    fn efforts<W: Worksheet>(
        &self,
        given: &SliderCrankGiven<W>,
        sheet: W,
    ) -> Result<SliderCrankPosition<W::Num>, Refusal> {
        let (r, l, two) = (given.crank, given.rod, given.angle);
        let bridged = (given.offset - r * two.sin()).abs();
        if bridged.holds_with(l, |bridged, rod| bridged > rod) {
            let bridged = bridged.value();
            return Err(Refusal::because(
                Text::new("at this angle the rod has to span {distance} from the crank pin to the line of the slider: it is {gap} too short")
                    .with_quantity("distance", bridged, "mm")
                    .with_quantity("gap", bridged - self.rod, "mm"),
            ));
        }
        let three = sheet.step(
            symbol("θ", "3"),
            "deg",
            loops::rod_angle(r, l, given.offset, two),
            ("Angle of the rod: r sin θ_2 + l sin θ_3 = e", SHIGLEY.at("ch. 2")),
        );
        if three.cos().holds(|cosine| cosine < FLAT) {
            return Err(Refusal::because(
                "the rod is perpendicular to the line of the slider (limit position): the crank angle does not determine the motion; change it slightly",
            ));
        }
        let position = sheet.step(
            "x_B",
            "mm",
            loops::slider_position(r, l, two, three),
            ("Position of the slider", SHIGLEY.at("ch. 2")),
        );
        let ratio = sheet.step(
            symbol("h", "3"),
            "1",
            -(r * two.cos()) / (l * three.cos()),
            (
                "Virtual rotation of the rod for δθ_2 = 1: r cos θ_2 δθ_2 + l cos θ_3 δθ_3 = 0",
                SHIGLEY.at("ch. 3"),
            ),
        );
        let two_terms = || -(r * (two.sin() + r / l * (two * 2.0).sin() / 2.0));
        sheet.common_error(symbol("u", "B"), "the approximate formula of two terms used", two_terms);
        let shift = sheet.step(
            symbol("u", "B"),
            "mm",
            -(r * two.sin()) - l * three.sin() * ratio,
            (
                "Virtual displacement of the slider for δθ_2 = 1: δx_B = −r sin θ_2 δθ_2 − l sin θ_3 δθ_3",
                BEER.at("§10.1"),
            ),
        );
        let zero = W::Num::from(0.0);
        let moves = works::moves(given.speed, given.acceleration);
        let (mut rod_speed, mut velocity, mut rod_acceleration, mut acceleration) = (zero, zero, zero, zero);
        if moves {
            let (speed, alpha) = (given.speed, given.acceleration);
            rod_speed = sheet.step(symbol("ω", "3"), "rad/s", ratio * speed, "Angular velocity of the rod");
            velocity = sheet.step(symbol("v", "B"), "m/s", shift * speed, "Velocity of the slider");
            rod_acceleration = sheet.step(
                symbol("α", "3"),
                "rad/s^2",
                loops::rod_acceleration(r, l, two, three, speed, rod_speed, alpha),
                ("Angular acceleration of the rod", SHIGLEY.at("ch. 4")),
            );
            slider_acceleration_errors(symbol("a", "B"), [r, l], [two, speed, alpha], sheet);
            sheet.common_error(
                symbol("a", "B"),
                "the normal acceleration r ω² of the crank pin used",
                || -(r * speed.powi(2)),
            );
            acceleration = sheet.step(
                symbol("a", "B"),
                "m/s^2",
                loops::slider_acceleration(r, l, two, three, speed, rod_speed, alpha, rod_acceleration),
                ("Acceleration of the slider", SHIGLEY.at("ch. 4")),
            );
        }
        let crank = RotatingLinkWork::crank(two, given.speed, given.acceleration);
        let rod = RotatingLinkWork { angle: three, ratio, speed: rod_speed, acceleration: rod_acceleration };
        let mut works = Works::new(given.gravity, moves, sheet);
        works.link(TWO, given.crank_mass.as_ref(), r, works::fixed(), crank);
        let pin_matters = given.rod_mass.is_some() || !given.pin_force.is_zero();
        if pin_matters {
            let arm = sheet.step_vector(
                symbol("r", "A"),
                "mm",
                works::direction::<W>(two) * r,
                "From the bearing to the crank pin",
            );
            let pin = works::moving("A", works::fixed(), arm, crank, moves, sheet);
            works.force("A", given.pin_force, pin.shift);
            works.link(THREE, given.rod_mass.as_ref(), l, pin, rod);
        }
        let slider =
            PointWork { shift: plane::<W>(shift, zero), acceleration: plane::<W>(acceleration, zero) };
        works.mass(FOUR, given.slider_mass, slider);
        let (torque, force) = match given.unknown {
            SliderCrankUnknownGiven::Torque { force } => {
                (works.balanced("B", force * shift, "Virtual work of the force on the slider"), force)
            }
            SliderCrankUnknownGiven::Force { torque } => {
                if shift.holds_with(r, |shift, crank| shift.abs() <= DEAD * crank) {
                    return Err(Refusal::because(
                        "crank and rod are collinear (dead centre): no force on the slider can balance a torque; rotate the crank slightly",
                    ));
                }
                works.driving(torque);
                let sum = works.sum();
                let why = "Force, from the principle of virtual work, F_B u_B + ΣδW = 0";
                (torque, sheet.step(symbol("F", "B"), "N", -(sum / shift), (why, RIUL.at("eq. 5"))))
            }
        };
        Ok(SliderCrankPosition {
            rod_angle: three,
            position,
            ratio,
            shift,
            rod_speed,
            velocity,
            rod_acceleration,
            acceleration,
            torque,
            force,
        })
    }
}

impl SliderCrank {
    fn moves(&self) -> bool {
        self.speed != 0.0 || self.acceleration != 0.0
    }

    /// Velocities and accelerations of the slider's pin B, of the crank pin A and of B relative to A.
    fn kinematics<W: Worksheet>(
        &self,
        given: &SliderCrankGiven<W>,
        found: &SliderCrankPosition<W::Num>,
        sheet: W,
    ) -> (Kinematics<W>, [Motion<W>; 3]) {
        let crank = RotatingLinkWork::crank(given.angle, given.speed, given.acceleration);
        let rod = RotatingLinkWork {
            angle: found.rod_angle,
            ratio: found.ratio,
            speed: found.rod_speed,
            acceleration: found.rod_acceleration,
        };
        let of = Kinematics::new(given.speed, given.acceleration, given.crank, sheet);
        let a = of.about(&kinematics::A, crank.reach::<W>(given.crank), crank);
        let ba = of.about(&kinematics::B_RELATIVE_TO_A, rod.reach::<W>(given.rod), rod);
        let zero = W::Num::from(0.0);
        let b = Motion {
            velocity: plane::<W>(found.velocity, zero),
            acceleration: plane::<W>(found.acceleration, zero),
        };
        (of, [b, a, ba])
    }

    /// Transmission angle of the rod, here and at its worst in a revolution.
    fn transmission<W: Worksheet>(&self, given: &SliderCrankGiven<W>, rod_angle: W::Num, sheet: W) {
        let why = "Transmission angle: the acute angle between the rod and the normal of the slider's line, 90° − |θ_3|";
        let at_crank = || (given.angle - rod_angle).cos().abs().acos();
        sheet.common_error("μ", "the angle between crank and rod taken", at_crank);
        let angle = sheet.step("μ", "deg", rod_angle.sin().abs().acos(), (why, NORTON.at("ch. 3")));
        sheet.answer("transmission_angle", "Transmission angle", angle);
        let (r, l, e) = (given.crank, given.rod, given.offset);
        sheet.verify(|| {
            let bridged = (r * given.angle.sin() - e).abs();
            let what = "the rod at the transmission angle reaches from the crank pin to the slider's line";
            sheet.check_sum(what, l * angle.cos(), bridged, self.crank + self.offset.abs());
        });
        let cosine = (given.crank + given.offset.abs()) / given.rod;
        if cosine.holds(|cosine| cosine <= 1.0) {
            let why = "Minimum transmission angle over a revolution: crank perpendicular to the slider's line, crank pin farthest from it";
            let least = sheet.step(symbol("μ", "min"), "deg", cosine.acos(), (why, NORTON.at("ch. 3")));
            sheet.answer("least_transmission_angle", "Minimum transmission angle over a revolution", least);
            sheet.verify(|| {
                let at = |crank: f64| loops::rod_angle(self.crank, self.rod, self.offset, crank).abs();
                let widest = at(FRAC_PI_2).max(at(-FRAC_PI_2));
                let what = "minimum transmission angle from the maximum inclination of the rod, with the crank perpendicular to the slider's line";
                sheet.check_sum(what, least.cos(), widest.sin().into(), 1.0);
            });
        }
    }

    /// The crank pin.
    fn pin(&self) -> [f64; 2] {
        built::away([0.0; 2], self.crank, self.angle)
    }

    /// The same mechanism put together from its lengths, and its joints: bearing, crank pin, pin of the slider, guide.
    fn built(&self, found: &SliderCrankPosition<f64>) -> Result<(Solved, [usize; 4]), PlanarError> {
        let mut it = Built::new([self.gravity.x, self.gravity.y]);
        let crank =
            it.link("crank", [0.0; 2], self.angle, LinkMass::built(self.crank_mass.as_ref(), self.crank));
        let rod =
            it.link("rod", self.pin(), found.rod_angle, LinkMass::built(self.rod_mass.as_ref(), self.rod));
        let slider =
            it.link("slider", [found.position, self.offset], 0.0, built::BuiltMass::at_pin(self.slider_mass));
        let (start, guide) = (BodyPoint::ground([0.0; 2]), BodyPoint::ground([0.0, self.offset]));
        let joints = [
            it.pin(start, crank.point([0.0; 2])),
            it.pin(crank.point([self.crank, 0.0]), rod.point([0.0; 2])),
            it.pin(rod.point([self.rod, 0.0]), slider.point([0.0; 2])),
            it.join(PlanarJoint::Slider {
                guide,
                direction: 0.0,
                slides: slider.point([0.0; 2]),
                angle: 0.0,
            }),
        ];
        if self.pin_force != Vector3::zeros() {
            let force = [self.pin_force.x, self.pin_force.y];
            it.force("Force on the crank pin", crank.point([self.crank, 0.0]), force);
        }
        match self.unknown {
            SliderCrankUnknown::Torque { force } => {
                if force != 0.0 {
                    it.force("Force on the slider", slider.point([0.0; 2]), [force, 0.0]);
                }
                it.turn(crank, [self.angle, self.speed, self.acceleration]);
            }
            SliderCrankUnknown::Force { torque } => {
                if torque != 0.0 {
                    it.couple("Torque on the crank", crank, torque);
                }
                let along = RelativeCoordinate::Component {
                    direction: [1.0, 0.0],
                    from: start,
                    to: slider.point([0.0; 2]),
                };
                it.drive(along, [found.position, found.velocity, found.acceleration]);
            }
        }
        Ok((it.solve()?, joints))
    }

    fn show<W: Worksheet>(&self, sheet: W) {
        let at = |angle: f64| SliderCrank { angle, ..self.clone() };
        let closes = |angle: f64| (self.offset - self.crank * angle.sin()).abs() < self.rod;
        let range = Range::about(self.angle, closes);
        let cycle = TemplateRange::new(range, "angle", at);
        match self.unknown {
            SliderCrankUnknown::Torque { .. } => sheet.show(|| cycle.torque(|found| found.torque)),
            SliderCrankUnknown::Force { .. } => sheet.show(|| {
                cycle.plot(
                    "Force over one revolution",
                    ("Force on the slider", "N"),
                    &[("force", "force", &|found| built::bounded(found.force, found.shift, self.crank))],
                )
            }),
        }
        if self.moves() {
            sheet.show(|| {
                cycle.plot(
                    "Velocity of the slider",
                    ("Velocity of the slider", "m/s"),
                    &[("velocity", "slider_velocity", &|found| found.velocity)],
                )
            });
            sheet.show(|| {
                cycle.plot(
                    "Acceleration of the slider",
                    ("Acceleration of the slider", "m/s^2"),
                    &[("acceleration", "slider_acceleration", &|found| found.acceleration)],
                )
            });
        }
        sheet.show(|| {
            let (low, high) = figure::way(&cycle.curve(|found| found.position));
            built::animation(
                "The slider-crank",
                ("angle", self.angle),
                range,
                self.crank + self.rod,
                |angle, sketch| {
                    let there = at(angle);
                    let found = there.plain()?;
                    let (o, a, b) = ((0.0, 0.0), At::from(there.pin()), (found.position, self.offset));
                    let unit = sketch.symbol();
                    sketch
                        .circle(o, self.crank, Ink::Faint)
                        .axis(o, (6.0 * unit, 0.0))
                        .guide((low - 2.2 * unit, self.offset), (high + 3.0 * unit, self.offset))
                        .slider("", b, 0.0)
                        .link("r", o, a)
                        .link("l", a, b)
                        .pin("O", o)
                        .joint("A", a)
                        .joint("B", b)
                        .angle("θ₂", o, 0.0, angle.rem_euclid(TAU));
                    if self.offset != 0.0 {
                        sketch.dimension("e", (high, 0.0), (high, self.offset), 0.0);
                    }
                    if self.slider_mass != 0.0 {
                        sketch.label("m₄", (b.0, b.1 - 0.6 * unit));
                    }
                    figure::link_mass(sketch, 2, self.crank_mass.as_ref(), (o, a), 2.0);
                    figure::link_mass(sketch, 3, self.rod_mass.as_ref(), (a, b), -2.0);
                    let torque = match self.unknown {
                        SliderCrankUnknown::Force { torque } => torque,
                        SliderCrankUnknown::Torque { .. } => 0.0,
                    };
                    figure::turning(sketch, o, ("ω₂", self.speed), ("T₂", torque));
                    figure::on_slider(sketch, "F_B", b, (found.force, 0.0), 0.8 * self.crank);
                    let pin_force = [self.pin_force.x, self.pin_force.y];
                    built::forces(sketch, &[("F_A", a, pin_force)], self.crank);
                    Some(())
                },
            )
        });
    }
}
