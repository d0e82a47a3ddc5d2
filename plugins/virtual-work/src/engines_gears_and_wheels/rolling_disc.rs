//! A disc that a crank rolls back and forth, against a spring and a damper.

use std::f64::consts::TAU;

use dalembert_core::{
    About, Analysis, Ink, Inputs, Refusal, Text, Worksheet, exhibit::Point as At, register,
};
use dalembert_mechanics::{
    Real,
    planar::{BodyPoint, Effort, PlanarError, PlanarJoint, PlanarLoad, RelativeCoordinate},
    slider_crank as loops,
};

use crate::{
    shared::{
        built::{self, Built, BuiltMass, Link, Range, Solved, Template, TemplateRange},
        figure,
        kinematics::slider_acceleration_errors,
        works::{self, FOUR, PointWork, Works, plane, symbol},
    },
    sources::{NORTON, RIUL, SHIGLEY},
};

/// A disc on a level floor, pushed at its centre by a slider-crank whose bearing is as high as the centre.
///
/// The bearing of the crank is the origin, the centre of the disc moves along x, angles are counter-clockwise.
#[derive(Clone, Debug, Inputs)]
pub struct RollingDisc {
    /// Length of the crank.
    #[input("r", "mm", positive)]
    pub crank: f64,
    /// Length of the rod.
    #[input("l", "mm", positive)]
    pub rod: f64,
    /// Angle of the crank.
    /// From the line of the disc's centre, counter-clockwise.
    #[input("θ_2", "deg")]
    pub angle: f64,
    /// Find.
    pub unknown: RollingDiscUnknown,
    /// Angular velocity of the crank.
    /// Zero in statics.
    #[input("ω_2", "rad/s", default = "0 rad/s")]
    pub speed: f64,
    /// Angular acceleration of the crank.
    #[input("α_2", "rad/s^2", default = "0 rad/s^2")]
    pub acceleration: f64,
    /// Mass of the disc.
    #[input("m", "kg", nonnegative)]
    pub mass: f64,
    /// Radius of the disc.
    #[input("R", "mm", positive)]
    pub radius: f64,
    /// Moment of inertia of the disc.
    pub inertia: RollingInertia,
    /// Spring from a wall to the centre.
    pub spring: Option<WallSpring>,
    /// Damper along the floor.
    #[input("c", "N*s/m", nonnegative, default = "0 N*s/m")]
    pub damping: f64,
    /// Acceleration of gravity.
    #[input("g", "m/s^2", nonnegative, default = "9.81 m/s^2")]
    pub gravity: f64,
}

/// The moment of inertia of what rolls, about its centre.
#[derive(Clone, Debug, Inputs)]
pub enum RollingInertia {
    /// Uniform disc
    Disc,
    /// Thin ring
    Ring,
    /// Radius of gyration given
    Gyration {
        /// Radius of gyration.
        #[input("k_G", "mm", nonnegative)]
        radius: f64,
    },
}

/// A spring between a wall and the centre of the disc.
#[derive(Clone, Debug, Inputs)]
pub struct WallSpring {
    /// Stiffness.
    #[input("k", "N/m", positive)]
    pub stiffness: f64,
    /// Position of the wall.
    /// Along x, from the bearing of the crank; on the side opposite to the travel of the disc.
    #[input("x_w", "mm")]
    pub wall: f64,
    /// Free length.
    #[input("L_0", "mm", nonnegative)]
    pub free: f64,
}

/// Unknown of the sum of virtual works.
#[derive(Clone, Debug, Inputs)]
pub enum RollingDiscUnknown {
    /// Torque on the crank
    Torque {
        /// Force on the centre of the disc.
        /// Along x.
        #[input("F", "N", default = "0 N")]
        force: f64,
    },
    /// Force on the centre of the disc
    Force {
        /// Torque on the crank.
        /// Positive counter-clockwise.
        #[input("T_2", "N*m")]
        torque: f64,
    },
}

/// Results in one position.
pub struct RollingDiscPosition<N> {
    rod_angle: N,
    position: N,
    shift: N,
    velocity: N,
    acceleration: N,
    torque: N,
    force: N,
}

register!(RollingDisc);

/// Below this displacement for a unit turn, in crank lengths, crank and rod are in one line.
const DEAD: f64 = 1e-9;

impl Analysis for RollingDisc {
    const ABOUT: About = About {
        id: "virtual-work/rolling-disc",
        title: "Rolling disc driven by a crank",
        topic: "Engines, gears and wheels",
        summary: "Torque on a crank that rolls a disc without slip against spring and damper, by virtual work; friction at the floor and the coefficient required.",
        main: &["torque", "force", "acceleration"],
        keywords: "disco rolamento sem escorregamento manivela mola amortecedor atrito cilindro roda rolling without slip \
                   wheel cylinder friction slider-crank",
        sources: &[&RIUL, &SHIGLEY, &NORTON],
        cases: include_str!("../../cases/rolling_disc.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &RollingDiscGiven<W>, sheet: W) -> Result<(), Refusal> {
        let found = self.efforts(given, sheet)?;
        sheet.answer("position", "Position of the centre", found.position);
        if self.moves() {
            sheet.answer("velocity", "Velocity of the centre", found.velocity);
            sheet.answer("acceleration", "Acceleration of the centre", found.acceleration);
        }
        match self.unknown {
            RollingDiscUnknown::Torque { .. } => sheet.answer("torque", "Torque on the crank", found.torque),
            RollingDiscUnknown::Force { .. } => {
                sheet.answer("force", "Force on the centre of the disc", found.force);
            }
        }
        // The disc by itself: moments about its centre, and about the crank pin of the massless rod.
        let (square, _) = self.gyration(given);
        let why = "Friction at the floor turns the disc: R f = I α with α = −a/R, positive along x";
        let grip = -(given.mass * square / given.radius.powi(2) * found.acceleration);
        let friction = sheet.step("f", "N", grip, (why, SHIGLEY.at("ch. 12")));
        sheet.answer("friction", "Friction force of the floor", friction);
        let (solved, joints) = self.built(&found).map_err(built::refusal)?;
        let [bearing, floor, rack] = joints;
        let forces = solved.reaction(bearing);
        let label = "Force in the bearing of the crank";
        works::reaction(["O", "Ox", "Oy"], ("bearing_force", label), (&solved, bearing), sheet);
        let why = "Normal force of the floor, upwards, by the same equations";
        let normal = sheet.numerical("N", "N", solved.reaction(floor)[0], (why, SHIGLEY.at("ch. 11")));
        sheet.answer("normal_force", "Normal force of the floor", normal);
        if normal.value() > 0.0 {
            let needed = friction.abs() / normal;
            sheet.common_error("μ", "the normal force taken as the weight alone", || {
                friction.abs() / (given.mass * given.gravity)
            });
            let needed = sheet.step("μ", "1", needed, "Minimum coefficient of friction to prevent slip");
            sheet.answer("needed_friction", "Minimum coefficient of friction to prevent slip", needed);
            sheet.verify(|| {
                let grip = solved.reaction(rack)[0].abs();
                let size = grip.max(self.mass * found.acceleration.value().abs());
                let what =
                    "friction at the minimum coefficient is the effort that keeps the disc from slipping";
                sheet.check_sum(what, needed * normal, grip.into(), size);
            });
        } else if self.gravity > 0.0 {
            sheet.warn(|| Text::new("the rod lifts the disc off the floor: it cannot roll here"));
        }
        sheet.verify(|| {
            let effort = match self.unknown {
                RollingDiscUnknown::Torque { .. } => found.torque,
                RollingDiscUnknown::Force { .. } => found.force,
            };
            solved.check_effort(0, effort, sheet);
            let grip = -solved.reaction(rack)[0];
            let size = grip.abs().max(self.mass * found.acceleration.value().abs());
            sheet.check_sum(
                "the friction is the effort that keeps the disc from slipping",
                friction,
                (-grip).into(),
                size,
            );
            let along = self.along(&found);
            works::check_balance(
                &[forces, [friction.value() + along + found.force.value(), normal.value()]],
                solved.inertia_resultant(),
                sheet,
            );
        });
        sheet.show(|| solved.works(0));
        self.show(sheet);
        Ok(())
    }
}

impl Template for RollingDisc {
    type Found<N: Real> = RollingDiscPosition<N>;

    fn efforts<W: Worksheet>(
        &self,
        given: &RollingDiscGiven<W>,
        sheet: W,
    ) -> Result<RollingDiscPosition<W::Num>, Refusal> {
        let rise = (self.crank * self.angle.sin()).abs();
        if rise > self.rod {
            return Err(Refusal::because(
                Text::new("at this angle the rod has to span {distance} from the crank pin to the line of the slider: it is {gap} too short")
                    .with_quantity("distance", rise, "mm")
                    .with_quantity("gap", rise - self.rod, "mm"),
            ));
        }
        let (r, l, two, zero) = (given.crank, given.rod, given.angle, W::Num::from(0.0));
        let three = (-(r * two.sin()) / l).asin();
        let why = ("Angle of the rod: r sin θ_2 + l sin θ_3 = 0", SHIGLEY.at("ch. 2"));
        let three = sheet.step(symbol("θ", "3"), "deg", three, why);
        if three.value().cos() < 1e-7 {
            return Err(Refusal::because(
                "the rod is perpendicular to the line of the slider (limit position): the crank angle does not determine the motion; change it slightly",
            ));
        }
        let position = loops::slider_position(r, l, two, three);
        let position = sheet.step("x", "mm", position, "Position of the centre of the disc");
        let why = "Virtual displacement of the centre for δθ_2 = 1";
        let shift = -(r * (two - three).sin()) / three.cos();
        sheet.common_error("u", "the obliquity of the rod neglected", || -(r * two.sin()));
        let shift = sheet.step("u", "mm", shift, (why, SHIGLEY.at("ch. 3")));
        let (mut velocity, mut acceleration) = (zero, zero);
        if self.moves() {
            let (speed, alpha) = (given.speed, given.acceleration);
            velocity = sheet.step("v", "m/s", shift * speed, "Velocity of the centre of the disc");
            let turning = loops::rod_speed(r, l, two, three, speed);
            let turning = sheet.step(symbol("ω", "3"), "rad/s", turning, "Angular velocity of the rod");
            let bent = loops::rod_acceleration(r, l, two, three, speed, turning, alpha);
            let why = ("Angular acceleration of the rod", SHIGLEY.at("ch. 4"));
            let bent = sheet.step(symbol("α", "3"), "rad/s^2", bent, why);
            let value = loops::slider_acceleration(r, l, two, three, speed, turning, alpha, bent);
            slider_acceleration_errors("a", [r, l], [two, speed, alpha], sheet);
            acceleration = sheet.step(
                "a",
                "m/s^2",
                value,
                ("Acceleration of the centre of the disc", SHIGLEY.at("ch. 4")),
            );
        }
        let mut works = Works::new(plane::<W>(zero, zero), self.moves(), sheet);
        if let Some(spring) = &given.spring {
            let length = sheet.step("s", "mm", position - spring.wall, "Length of the spring");
            if length.value() <= 0.0 {
                return Err(Refusal::because(
                    "the centre of the disc is not on the far side of the wall: move the wall away from the disc",
                ));
            }
            let why = ("Virtual work of the spring, −k (s − L_0) u", RIUL.at("eq. 1"));
            works.push(symbol("δW", "k"), -(spring.stiffness * (length - spring.free)) * shift, why.0, why.1);
        }
        if self.damping > 0.0 && self.moves() {
            let why = "Virtual work of the damper, −c v u";
            works.push(symbol("δW", "c"), -(given.damping * velocity) * shift, why, RIUL.at("eq. 1"));
        }
        let disc = PointWork { shift: plane::<W>(shift, zero), acceleration: plane::<W>(acceleration, zero) };
        works.mass(FOUR, given.mass, disc);
        let (square, why) = self.gyration(given);
        if self.moves() && square.value() > 0.0 && self.mass > 0.0 {
            let about_contact = || given.mass * (square + given.radius.powi(2));
            sheet.common_error(
                "I",
                "the moment of inertia about the contact point used together with the translation",
                about_contact,
            );
            let inertia = sheet.step("I", "kg*m^2", given.mass * square, why);
            let why = "Virtual work of the inertia couple: the disc turns by −u/R, α = −a/R";
            let work = -(inertia * acceleration * shift) / given.radius.powi(2);
            works.push(symbol("δW_I", "4"), work, why, RIUL.at("eq. 5"));
        }
        let (torque, force) = match given.unknown {
            RollingDiscUnknownGiven::Torque { force } => (
                works.balanced("F", force * shift, "Virtual work of the force on the centre of the disc"),
                force,
            ),
            RollingDiscUnknownGiven::Force { torque } => {
                if shift.value().abs() <= DEAD * self.crank {
                    return Err(Refusal::because(
                        "crank and rod are collinear (dead centre): no force on the disc can balance a torque; rotate the crank slightly",
                    ));
                }
                works.driving(torque);
                let why = "Force, from the principle of virtual work, F u + ΣδW = 0";
                (torque, sheet.step("F", "N", -(works.sum() / shift), (why, RIUL.at("eq. 5"))))
            }
        };
        Ok(RollingDiscPosition { rod_angle: three, position, shift, velocity, acceleration, torque, force })
    }
}

impl RollingDisc {
    fn moves(&self) -> bool {
        self.speed != 0.0 || self.acceleration != 0.0
    }

    /// The square of the radius of gyration, and what is said of it.
    fn gyration<W: Worksheet>(&self, given: &RollingDiscGiven<W>) -> (W::Num, &'static str) {
        match given.inertia {
            RollingInertiaGiven::Disc {} => {
                (given.radius.powi(2) / 2.0, "Moment of inertia of a uniform disc")
            }
            RollingInertiaGiven::Ring {} => (given.radius.powi(2), "Moment of inertia of a thin ring"),
            RollingInertiaGiven::Gyration { radius } => {
                (radius.powi(2), "Moment of inertia from the radius of gyration")
            }
        }
    }

    /// Force of spring and damper on the disc along x.
    fn along<N: Real>(&self, found: &RollingDiscPosition<N>) -> f64 {
        let spring = self
            .spring
            .as_ref()
            .map_or(0.0, |spring| -spring.stiffness * (found.position.value() - spring.wall - spring.free));
        spring - self.damping * found.velocity.value()
    }

    fn pin(&self) -> [f64; 2] {
        built::away([0.0; 2], self.crank, self.angle)
    }

    /// The same mechanism put together, and its joints: bearing, floor, rolling.
    fn built<N: Real>(&self, found: &RollingDiscPosition<N>) -> Result<(Solved, [usize; 3]), PlanarError> {
        let square = match self.inertia {
            RollingInertia::Disc => self.radius * self.radius / 2.0,
            RollingInertia::Ring => self.radius * self.radius,
            RollingInertia::Gyration { radius } => radius * radius,
        };
        let mut it = Built::new([0.0, -self.gravity]);
        let crank: Link = it.link("crank", [0.0; 2], self.angle, BuiltMass::default());
        let rod = it.link("rod", self.pin(), found.rod_angle.value(), BuiltMass::default());
        let place = [found.position.value(), 0.0];
        let disc = BuiltMass { inertia: self.mass * square, ..BuiltMass::at_pin(self.mass) };
        let disc = it.link("disc", place, 0.0, disc);
        let (start, floor) = (BodyPoint::ground([0.0; 2]), BodyPoint::ground([0.0, -self.radius]));
        let centre = disc.point([0.0; 2]);
        let bearing = it.pin(start, crank.point([0.0; 2]));
        it.pin(crank.point([self.crank, 0.0]), rod.point([0.0; 2]));
        it.pin(rod.point([self.rod, 0.0]), centre);
        let joints = [
            bearing,
            it.join(PlanarJoint::Slot { guide: floor, direction: 0.0, pin: centre, offset: self.radius }),
            it.join(PlanarJoint::Rack { guide: floor, direction: 0.0, centre, radius: self.radius }),
        ];
        let along = |from: f64| RelativeCoordinate::Component {
            direction: [1.0, 0.0],
            from: BodyPoint::ground([from, 0.0]),
            to: centre,
        };
        if let Some(WallSpring { stiffness, wall, free }) = self.spring {
            let effort = Effort::Spring { stiffness, free };
            it.load("Spring", PlanarLoad::Effort { measure: along(wall), effort });
        }
        if self.damping > 0.0 {
            let effort = Effort::Damper { coefficient: self.damping };
            it.load("Damper", PlanarLoad::Effort { measure: along(0.0), effort });
        }
        match self.unknown {
            RollingDiscUnknown::Torque { force } => {
                if force != 0.0 {
                    it.force("Force on the centre of the disc", centre, [force, 0.0]);
                }
                it.turn(crank, [self.angle, self.speed, self.acceleration]);
            }
            RollingDiscUnknown::Force { torque } => {
                if torque != 0.0 {
                    it.couple("Torque on the crank", crank, torque);
                }
                it.drive(along(0.0), [place[0], found.velocity.value(), found.acceleration.value()]);
            }
        }
        Ok((it.solve()?, joints))
    }

    fn show<W: Worksheet>(&self, sheet: W) {
        let at = |angle: f64| RollingDisc { angle, ..self.clone() };
        let range = Range::about(self.angle, |angle| (self.crank * angle.sin()).abs() < self.rod);
        let cycle = TemplateRange::new(range, "angle", at);
        match self.unknown {
            RollingDiscUnknown::Torque { .. } => sheet.show(|| cycle.torque(|found| found.torque)),
            RollingDiscUnknown::Force { .. } => sheet.show(|| {
                cycle.plot(
                    "Force over one revolution",
                    ("Force on the centre of the disc", "N"),
                    &[("force", "force", &|found| built::bounded(found.force, found.shift, self.crank))],
                )
            }),
        }
        if self.moves() {
            sheet.show(|| {
                cycle.plot(
                    "Velocity of the centre",
                    ("Velocity of the centre", "m/s"),
                    &[("velocity", "velocity", &|found| found.velocity)],
                )
            });
        }
        sheet.show(|| {
            let first = self.crank + self.rod;
            built::animation(
                "The rolling disc",
                ("angle", self.angle),
                range,
                first + self.radius,
                |angle, sketch| {
                    let there = at(angle);
                    let found = there.plain()?;
                    let (centre, radius) = ((found.position, 0.0), there.radius);
                    let (o, a) = ((0.0, 0.0), At::from(there.pin()));
                    // A mark on the rim that turns as the disc rolls.
                    let rim = built::away(centre.into(), radius, -(centre.0 - first) / radius);
                    let reach = there.crank + radius;
                    sketch
                        .ground((there.rod - reach, -radius), (there.rod + reach, -radius))
                        .circle(o, there.crank, Ink::Faint)
                        .disc(if there.mass > 0.0 { "m" } else { "" }, centre, radius)
                        .line("R", centre, rim.into(), Ink::Faint)
                        .link("r", o, a)
                        .link("l", a, centre)
                        .pin("O", o)
                        .joint("A", a)
                        .joint("C", centre)
                        .angle("θ₂", o, 0.0, angle.rem_euclid(TAU));
                    let (unit, high) = (sketch.symbol(), 1.25 * radius);
                    let bracket = (centre.0, high);
                    if let Some(spring) = &there.spring {
                        let wall = (spring.wall, high);
                        let name = if spring.free > 0.0 { "k, L₀" } else { "k" };
                        // Beside the line of the rod, on a bracket of the centre.
                        sketch
                            .bars([centre, bracket])
                            .spring("", wall, bracket)
                            .label(name, (wall.0 + 0.25 * (bracket.0 - wall.0), high - 1.3 * unit))
                            .dimension(
                                "x_w",
                                o,
                                (spring.wall, 0.0),
                                -spring.wall.signum() * (radius / unit + 2.5),
                            )
                            .ground((wall.0, wall.1 + 3.0 * unit), (wall.0, wall.1 - 3.0 * unit));
                    }
                    if there.damping > 0.0 {
                        let side = if there.spring.as_ref().is_some_and(|spring| spring.wall > 0.0) {
                            -1.0
                        } else {
                            1.0
                        };
                        let wall = first + side * (2.2 * radius + there.crank);
                        sketch
                            .damper("c", (wall, 0.0), centre)
                            .ground((wall, -3.0 * side * unit), (wall, 3.0 * side * unit));
                    }
                    let torque = match there.unknown {
                        RollingDiscUnknown::Force { torque } => torque,
                        RollingDiscUnknown::Torque { .. } => 0.0,
                    };
                    figure::turning(sketch, o, ("ω₂", there.speed), ("T₂", torque));
                    built::forces(sketch, &[("F", centre, [found.force, 0.0])], there.crank);
                    Some(())
                },
            )
        });
    }
}
