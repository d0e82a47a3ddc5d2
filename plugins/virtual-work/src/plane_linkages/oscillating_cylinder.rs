//! The inverted slider-crank: a crank or lever whose pin is pushed by a cylinder that swings about a fixed pin.

use std::f64::consts::{FRAC_PI_2, TAU};

use dalembert_core::{About, Analysis, Inputs, Refusal, Worksheet, exhibit::Point as At, register};
use dalembert_mechanics::{
    Real, Vector,
    planar::{BodyPoint, Effort, PlanarError, PlanarJoint, PlanarLoad, RelativeCoordinate},
};
use nalgebra::Vector3;

use crate::{
    shared::{
        built::{self, Built, BuiltMass, Link, Range, Solved, Template, TemplateRange},
        figure,
        kinematics::{self, Kinematics, Motion},
        works::{self, FOUR, LinkMass, RotatingLinkWork, THREE, TWO, Works, symbol},
    },
    sources::{BEER, NORTON, RIUL, SHIGLEY},
};

/// An inverted slider-crank in one position: steam engine with a swinging cylinder, or a lever moved by a hydraulic
/// cylinder.
///
/// The crank (2) turns about the origin O, the cylinder (4) about its fixed pin C; the piston rod (3) slides in the
/// cylinder and holds the crank pin A. Angles are counter-clockwise from the x axis.
#[derive(Clone, Debug, Inputs)]
pub struct OscillatingCylinder {
    /// Length of the crank.
    #[input("r", "mm", positive)]
    pub crank: f64,
    /// Fixed pin of the cylinder.
    #[input("C", "mm", planar)]
    pub pivot: Vector3<f64>,
    /// Angle of the crank.
    #[input("θ_2", "deg")]
    pub angle: f64,
    /// Find.
    pub unknown: CylinderUnknown,
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
    /// Piston with its rod.
    pub piston: Option<Piston>,
    /// Cylinder.
    pub cylinder: Option<Cylinder>,
    /// Acceleration of gravity.
    /// Zero for a mechanism in a horizontal plane.
    #[input("g", "m/s^2", planar, default = "(0; -9.81) m/s^2")]
    pub gravity: Vector3<f64>,
}

/// A piston with its rod.
#[derive(Clone, Debug, Inputs)]
pub struct Piston {
    /// Mass.
    #[input("m_3", "kg", positive)]
    pub mass: f64,
    /// Distance of its centre of mass from the crank pin.
    /// Towards the fixed pin of the cylinder.
    #[input("ρ_3", "mm", default = "0 mm")]
    pub distance: f64,
    /// Moment of inertia about the centre of mass.
    #[input("I_3", "kg*m^2", nonnegative, default = "0 kg*m^2")]
    pub inertia: f64,
}

/// A cylinder that swings.
#[derive(Clone, Debug, Inputs)]
pub struct Cylinder {
    /// Mass.
    #[input("m_4", "kg", positive)]
    pub mass: f64,
    /// Distance of its centre of mass from its fixed pin.
    /// Towards the crank pin.
    #[input("ρ_4", "mm", default = "0 mm")]
    pub distance: f64,
    /// Moment of inertia about the centre of mass.
    #[input("I_4", "kg*m^2", nonnegative, default = "0 kg*m^2")]
    pub inertia: f64,
}

/// Unknown of the sum of virtual works.
#[derive(Clone, Debug, Inputs)]
pub enum CylinderUnknown {
    /// Torque on the crank, from the force of the cylinder
    Torque {
        /// Force of the cylinder.
        /// Positive when it pushes the crank pin away from the fixed pin of the cylinder.
        #[input("F_c", "N")]
        force: f64,
    },
    /// Torque on the crank, from the pressure in the cylinder
    Pressure {
        /// Pressure relative to the other side of the piston.
        #[input("p", "bar")]
        pressure: f64,
        /// Bore.
        #[input("D", "mm", positive)]
        bore: f64,
    },
    /// Force of the cylinder
    Force {
        /// Torque on the crank.
        /// Positive counter-clockwise.
        #[input("T_2", "N*m", default = "0 N*m")]
        torque: f64,
    },
}

/// Results in one position.
pub struct CylinderPosition<N> {
    length: N,
    tilt: N,
    /// Change of the length for a unit turn.
    shift: N,
    speed: N,
    rate: N,
    turning: N,
    lengthening: N,
    coriolis: N,
    torque: N,
    force: N,
}

register!(OscillatingCylinder);

/// Below this part of the crank the cylinder has no length, or crank and cylinder are in one line.
const DEAD: f64 = 1e-9;

impl Analysis for OscillatingCylinder {
    const ABOUT: About = About {
        id: "virtual-work/oscillating-cylinder",
        title: "Inverted slider-crank",
        topic: "Plane linkages",
        summary: "Torque of a crank or lever moved by an oscillating cylinder, or the force of the cylinder, at rest or in motion with masses, by virtual work; reactions.",
        main: &["force", "torque", "rod_velocity"],
        keywords: "rotary engine Gnome cilindro oscilante cilindro hidráulico atuador biela-manivela invertido pistão alavanca caçamba \
                   oscillating cylinder hydraulic actuator inverted slider-crank lever dump boom",
        sources: &[&RIUL, &SHIGLEY, &BEER, &NORTON],
        cases: include_str!("../../cases/oscillating_cylinder.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &OscillatingCylinderGiven<W>, sheet: W) -> Result<(), Refusal> {
        let found = self.efforts(given, sheet)?;
        sheet.answer("length", "Length of the cylinder from pin to pin", found.length);
        sheet.answer("cylinder_angle", "Angle of the cylinder", found.tilt);
        if self.moves() {
            sheet.answer("rod_velocity", "Velocity of the piston in the cylinder", found.rate);
            sheet.answer("cylinder_speed", "Angular velocity of the cylinder", found.speed);
            sheet.answer("rod_acceleration", "Acceleration of the piston in the cylinder", found.lengthening);
            sheet.answer("coriolis_acceleration", "Coriolis acceleration of the piston", found.coriolis);
            sheet.answer("cylinder_acceleration", "Angular acceleration of the cylinder", found.turning);
        }
        match self.unknown {
            CylinderUnknown::Force { .. } => sheet.answer("force", "Force of the cylinder", found.force),
            CylinderUnknown::Torque { .. } => sheet.answer("torque", "Torque on the crank", found.torque),
            CylinderUnknown::Pressure { .. } => {
                sheet.answer("torque", "Torque on the crank", found.torque);
                sheet.answer("cylinder_force", "Force of the cylinder", found.force);
            }
        }
        if found.shift.value().abs() > DEAD * self.crank {
            let why = "Ratio of the force perpendicular to the crank at its pin, T/r, to the force of the cylinder, neglecting masses";
            let advantage = found.shift.abs() / given.crank;
            let advantage = sheet.step("MA", "1", advantage, (why, SHIGLEY.at("ch. 3")));
            sheet.answer("mechanical_advantage", "Mechanical advantage", advantage);
            sheet.verify(|| {
                let sine = (given.angle - found.tilt).sin().abs();
                let what = "mechanical advantage as the sine of the angle between crank and cylinder";
                sheet.check_sum(what, advantage, sine, 1.0);
            });
        }
        sheet.verify(|| self.check_triangle(given, &found, sheet));
        let motions = self.moves().then(|| self.kinematics(given, &found, sheet));
        let plain = self.plain().expect("the same problem has just been solved");
        let (solved, joints) = self.built(&plain).map_err(built::refusal)?;
        let forces = joints.map(|joint| solved.reaction(joint));
        let label = "Force in the bearing of the crank";
        works::reaction(["O", "Ox", "Oy"], ("bearing_force", label), (&solved, joints[0]), sheet);
        let label = "Force in the fixed pin of the cylinder";
        works::reaction(["C", "Cx", "Cy"], ("pivot_force", label), (&solved, joints[1]), sheet);
        let label = "Force in the crank pin";
        works::reaction(["A", "Ax", "Ay"], ("crank_pin_force", label), (&solved, joints[2]), sheet);
        sheet.verify(|| {
            // Known torque and known force: with the one as a load, the other must come out as the effort.
            let effort =
                if let CylinderUnknown::Force { .. } = self.unknown { found.force } else { found.torque };
            solved.check_effort(0, effort, sheet);
            if let Some((of, [a, under])) = &motions {
                of.check(&kinematics::A, *a, &solved, 0, [self.crank, 0.0]);
                of.check(&kinematics::A4, *under, &solved, 2, [plain.length, 0.0]);
            }
            let force = [self.pin_force.x, self.pin_force.y];
            works::check_balance(&[forces[0], forces[1], force], solved.inertia_resultant(), sheet);
        });
        sheet.show(|| solved.works(0));
        self.show(sheet);
        Ok(())
    }
}

impl Template for OscillatingCylinder {
    type Found<N: Real> = CylinderPosition<N>;

    fn efforts<W: Worksheet>(
        &self,
        given: &OscillatingCylinderGiven<W>,
        sheet: W,
    ) -> Result<CylinderPosition<W::Num>, Refusal> {
        let moves = self.moves();
        let zero = W::Num::from(0.0);
        let crank = RotatingLinkWork::crank(given.angle, given.speed, given.acceleration);
        let arm = works::direction::<W>(given.angle) * given.crank;
        let arm = sheet.step_vector(symbol("r", "2"), "mm", arm, "Crank, from O to A");
        let pin = works::moving("A", works::fixed(), arm, crank, moves, sheet);
        let why = "From the fixed pin of the cylinder to the crank pin";
        let span = sheet.step_vector(symbol("s", "CA"), "mm", arm - given.pivot, why);
        let why = "Length of the cylinder from pin to pin";
        let length = sheet.step("s", "mm", span.magnitude(), why);
        if length.value() <= DEAD * self.crank {
            return Err(Refusal::because(
                "the crank pin is at the fixed pin of the cylinder: the cylinder has no direction; turn the crank or move the pin",
            ));
        }
        let [x, y, _] = span.components();
        let tilt = sheet.step(symbol("θ", "4"), "deg", y.atan2(x), "Angle of the cylinder");
        let along =
            sheet.step_vector("ê", "1", span / length, "Unit vector from the fixed pin to the crank pin");
        let across = works::across::<W>(along);
        let why = ("Virtual change of the length for δθ_2 = 1: δs = ê · δr_A", BEER.at("§10.1"));
        sheet.common_error(
            symbol("u", "s"),
            "the whole displacement of the crank pin taken along the cylinder",
            || pin.shift.magnitude(),
        );
        let shift = sheet.step(symbol("u", "s"), "mm", pin.shift.dot(along), why);
        let why = ("Virtual rotation of the cylinder for δθ_2 = 1", SHIGLEY.at("ch. 3"));
        sheet.common_error(
            symbol("h", "4"),
            "the whole displacement of the crank pin taken across the cylinder",
            || pin.shift.magnitude() / length,
        );
        let ratio = sheet.step(symbol("h", "4"), "1", pin.shift.dot(across) / length, why);
        let (mut rate, mut lengthening, mut coriolis) = (zero, zero, zero);
        let mut swing = RotatingLinkWork { angle: tilt, ratio, speed: zero, acceleration: zero };
        if moves {
            let why = "Velocity of the piston in the cylinder";
            rate = sheet.step(symbol("v", "s"), "m/s", shift * given.speed, why);
            let why = "Angular velocity of the cylinder";
            swing.speed = sheet.step(symbol("ω", "4"), "rad/s", ratio * given.speed, why);
            let value = pin.acceleration.dot(along) + length * swing.speed.powi(2);
            let why = ("Acceleration of the piston in the cylinder", SHIGLEY.at("ch. 4"));
            lengthening = sheet.step(symbol("a", "s"), "m/s^2", value, why);
            coriolis = kinematics::coriolis(swing.speed, rate, given.speed, sheet);
            let value = (pin.acceleration.dot(across) - coriolis) / length;
            let why = ("Angular acceleration of the cylinder, minus the Coriolis term", SHIGLEY.at("ch. 4"));
            swing.acceleration = sheet.step(symbol("α", "4"), "rad/s^2", value, why);
        }
        let mut works = Works::new(given.gravity, moves, sheet);
        works.link(TWO, given.crank_mass.as_ref(), given.crank, works::fixed(), crank);
        works.force("A", given.pin_force, pin.shift);
        if let Some(piston) = &given.piston {
            works.body(THREE, pin, -(along * piston.distance), swing, piston.mass, piston.inertia);
        }
        if let Some(cylinder) = &given.cylinder {
            let arm = along * cylinder.distance;
            works.body(FOUR, works::fixed(), arm, swing, cylinder.mass, cylinder.inertia);
        }
        let (torque, force) = match given.unknown {
            CylinderUnknownGiven::Force { torque } => {
                if shift.value().abs() <= DEAD * self.crank {
                    return Err(Refusal::because(
                        "crank and cylinder are collinear (dead centre): no force of the cylinder can balance a torque; rotate the crank slightly",
                    ));
                }
                works.driving(torque);
                let why = "Force of the cylinder, from the principle of virtual work, F_c u_s + ΣδW = 0";
                let force = -(works.sum() / shift);
                (torque, sheet.step(symbol("F", "c"), "N", force, (why, RIUL.at("eq. 5"))))
            }
            CylinderUnknownGiven::Torque { force } => {
                (works.balanced("c", force * shift, "Virtual work of the force of the cylinder"), force)
            }
            CylinderUnknownGiven::Pressure { pressure, bore } => {
                let force = pressure * bore.powi(2) * std::f64::consts::PI / 4.0;
                let why = "Force of the cylinder: pressure times area of the bore";
                let force = sheet.step(symbol("F", "c"), "N", force, why);
                (works.balanced("c", force * shift, "Virtual work of the force of the cylinder"), force)
            }
        };
        Ok(CylinderPosition {
            length,
            tilt,
            shift,
            speed: swing.speed,
            rate,
            turning: swing.acceleration,
            lengthening,
            coriolis,
            torque,
            force,
        })
    }
}

impl OscillatingCylinder {
    fn moves(&self) -> bool {
        self.speed != 0.0 || self.acceleration != 0.0
    }

    /// Velocities and accelerations of the crank pin A, and of the point of the cylinder under it.
    fn kinematics<W: Worksheet>(
        &self,
        given: &OscillatingCylinderGiven<W>,
        found: &CylinderPosition<W::Num>,
        sheet: W,
    ) -> (Kinematics<W>, [Motion<W>; 2]) {
        let crank = RotatingLinkWork::crank(given.angle, given.speed, given.acceleration);
        let swing = RotatingLinkWork {
            angle: found.tilt,
            ratio: 0.0.into(),
            speed: found.speed,
            acceleration: found.turning,
        };
        let of = Kinematics::new(given.speed, given.acceleration, given.crank, sheet);
        let a = of.about(&kinematics::A, crank.reach::<W>(given.crank), crank);
        let under = of.about(&kinematics::A4, swing.reach::<W>(found.length), swing);
        sheet.verify(|| {
            let along = works::direction::<W>(found.tilt);
            let sliding = Kinematics::<W>::sliding(along, found.rate, found.lengthening, found.coriolis);
            of.check_relative(["A", "A4", "s"], [a, under, sliding]);
        });
        (of, [a, under])
    }

    /// Angle and motion of the cylinder from the triangle of the pins, `s² = r² + c² − 2 r · c`, and its derivatives.
    fn check_triangle<W: Worksheet>(
        &self,
        given: &OscillatingCylinderGiven<W>,
        found: &CylinderPosition<W::Num>,
        sheet: W,
    ) {
        let (r, two, tilt) = (given.crank, given.angle, found.tilt);
        let [x, y, _] = given.pivot.components();
        let size = self.crank + self.pivot.norm();
        let left = r * (two - tilt).sin();
        let what = "crank pin and fixed pin are at the same distance from a line through the bearing along the cylinder";
        sheet.check_sum(what, left, y * tilt.cos() - x * tilt.sin(), size);
        if !self.moves() {
            return;
        }
        // The products of the crank and of its quarter turn with the way to the fixed pin.
        let (along, across) = (r * (x * two.cos() + y * two.sin()), r * (y * two.cos() - x * two.sin()));
        let (speed, alpha) = (given.speed, given.acceleration);
        let fast = self.crank * self.speed.abs();
        let what = "velocity of the piston from the derivative of the triangle of the pins";
        sheet.check_sum(what, found.length * found.rate, -(across * speed), size * fast);
        let what = "angular velocity of the cylinder from the area that its line sweeps";
        let swept = (r.powi(2) - along) * speed;
        sheet.check_sum(what, found.length.powi(2) * found.speed, swept, size * fast);
        let what = "acceleration of the piston from the second derivative of the triangle of the pins";
        let bent = along * speed.powi(2) - across * alpha;
        let scale = size * self.crank * (self.speed.powi(2) + self.acceleration.abs());
        sheet.check_sum(what, found.length * found.lengthening + found.rate.powi(2), bent, scale);
    }

    /// The same mechanism put together, and its pins O, C, A.
    fn built(&self, found: &CylinderPosition<f64>) -> Result<(Solved, [usize; 3]), PlanarError> {
        let mut it = Built::new([self.gravity.x, self.gravity.y]);
        let (pin, pivot) = (built::away([0.0; 2], self.crank, self.angle), [self.pivot.x, self.pivot.y]);
        let mass = LinkMass::built(self.crank_mass.as_ref(), self.crank);
        let crank: Link = it.link("crank", [0.0; 2], self.angle, mass);
        let piston = self.piston.as_ref().map_or(BuiltMass::default(), |piston| BuiltMass {
            mass: piston.mass,
            centre: [-piston.distance, 0.0],
            inertia: piston.inertia,
        });
        let piston = it.link("piston", pin, found.tilt, piston);
        let cylinder = self.cylinder.as_ref().map_or(BuiltMass::default(), |cylinder| BuiltMass {
            mass: cylinder.mass,
            centre: [cylinder.distance, 0.0],
            inertia: cylinder.inertia,
        });
        let cylinder = it.link("cylinder", pivot, found.tilt, cylinder);
        let (foot, head) = (cylinder.point([0.0; 2]), piston.point([0.0; 2]));
        let joints = [
            it.pin(BodyPoint::ground([0.0; 2]), crank.point([0.0; 2])),
            it.pin(BodyPoint::ground(pivot), foot),
            it.pin(crank.point([self.crank, 0.0]), head),
        ];
        it.join(PlanarJoint::Slider { guide: foot, direction: 0.0, slides: head, angle: 0.0 });
        if self.pin_force != Vector3::zeros() {
            let at = crank.point([self.crank, 0.0]);
            it.force("Force on the crank pin", at, [self.pin_force.x, self.pin_force.y]);
        }
        let length = RelativeCoordinate::Along { direction: [1.0, 0.0], from: foot, to: head };
        if let CylinderUnknown::Force { torque } = self.unknown {
            if torque != 0.0 {
                it.couple("Torque on the crank", crank, torque);
            }
            it.drive(length, [found.length, found.rate, found.lengthening]);
        } else {
            if found.force != 0.0 {
                let effort = Effort::Constant(found.force);
                it.load("Force of the cylinder", PlanarLoad::Effort { measure: length, effort });
            }
            it.turn(crank, [self.angle, self.speed, self.acceleration]);
        }
        Ok((it.solve()?, joints))
    }

    fn show<W: Worksheet>(&self, sheet: W) {
        let at = |angle: f64| OscillatingCylinder { angle, ..self.clone() };
        let range = Range::Turn(self.angle);
        let cycle = TemplateRange::new(range, "angle", at);
        sheet.show(|| {
            if let CylinderUnknown::Force { .. } = self.unknown {
                let label = "Force of the cylinder";
                let force =
                    |found: &CylinderPosition<f64>| built::bounded(found.force, found.shift, self.crank);
                cycle.plot("Force over one revolution", (label, "N"), &[(label, "force", &force)])
            } else {
                let label = "Torque on the crank";
                cycle.plot(
                    "Torque over one revolution",
                    (label, "N*m"),
                    &[(label, "torque", &|found| found.torque)],
                )
            }
        });
        sheet.show(|| {
            cycle.plot(
                "Length of the cylinder",
                ("Length of the cylinder from pin to pin", "mm"),
                &[("length", "length", &|found| found.length)],
            )
        });
        sheet.show(|| {
            let shortest =
                cycle.curve(|found| found.length).into_iter().fold(f64::INFINITY, |s, (_, x)| s.min(x));
            let size = 1.5 * (self.crank + self.pivot.x.hypot(self.pivot.y));
            built::animation(
                "The inverted slider-crank",
                ("angle", self.angle),
                range,
                size,
                |angle, sketch| {
                    let there = at(angle);
                    let found = there.plain()?;
                    let (o, pivot) = ((0.0, 0.0), (there.pivot.x, there.pivot.y));
                    let pin = At::from(built::away([0.0; 2], there.crank, angle));
                    let (unit, barrel) = (sketch.symbol(), 0.75 * shortest);
                    sketch
                        .link("r", o, pin)
                        .pin("C", pivot)
                        .cylinder("", pivot, pin, barrel)
                        .pin("O", o)
                        .joint("A", pin)
                        .angle("θ₂", o, 0.0, angle.rem_euclid(TAU));
                    let spot = |along: f64| figure::away(pivot, along, found.tilt);
                    if let Some(piston) = &there.piston {
                        sketch.mass_centre("m₃", spot(found.length - piston.distance));
                    }
                    if let Some(cylinder) = &there.cylinder {
                        sketch.mass_centre("m₄", spot(cylinder.distance));
                    }
                    let torque = match there.unknown {
                        CylinderUnknown::Force { torque } => torque,
                        CylinderUnknown::Torque { .. } | CylinderUnknown::Pressure { .. } => 0.0,
                    };
                    figure::turning(sketch, o, ("ω₂", there.speed), ("T₂", torque));
                    // Both lie on the line of the cylinder: one beside it, the other from outside on its pin.
                    let beside = |along: f64| figure::away(spot(along), 2.5 * unit, found.tilt + FRAC_PI_2);
                    let (low, high) = (beside(0.1 * barrel), beside(0.9 * barrel));
                    if found.force > 0.0 {
                        sketch.force("F_c", low, high);
                    } else if found.force < 0.0 {
                        sketch.force("F_c", high, low);
                    }
                    let size = there.pin_force.norm();
                    if size > 0.0 {
                        let part = 0.4 * there.crank / size;
                        let tail = (pin.0 - part * there.pin_force.x, pin.1 - part * there.pin_force.y);
                        sketch.force("", tail, pin).label("F_A", tail);
                    }
                    Some(())
                },
            )
        });
    }
}
