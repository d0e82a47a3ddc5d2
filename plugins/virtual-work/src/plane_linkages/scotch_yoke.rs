//! The Scotch yoke: a crank pin in the cross slot of a yoke that slides.

use std::f64::consts::{FRAC_PI_2, TAU};

use dalembert_core::{About, Analysis, Ink, Inputs, Refusal, Worksheet, exhibit::Point as At, register};
use dalembert_mechanics::{
    Real,
    planar::{BodyPoint, PlanarError, PlanarJoint, RelativeCoordinate},
};
use nalgebra::Vector3;

use crate::{
    shared::{
        built::{self, Built, Range, Solved, Template, TemplateRange},
        figure,
        kinematics::{self, Kinematics},
        works::{self, FOUR, LinkMass, PointWork, RotatingLinkWork, TWO, Works, plane, symbol},
    },
    sources::{NORTON, RIUL, SHIGLEY},
};

/// A Scotch yoke in one position.
///
/// The crank turns about the origin, the yoke slides along x; angles are counter-clockwise from x.
#[derive(Clone, Debug, Inputs)]
pub struct ScotchYoke {
    /// Length of the crank.
    #[input("r", "mm", positive)]
    pub crank: f64,
    /// Angle of the crank.
    /// From the line of the yoke, counter-clockwise.
    #[input("θ_2", "deg")]
    pub angle: f64,
    /// Find.
    pub unknown: ScotchYokeUnknown,
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
    /// Mass of the yoke.
    #[input("m_4", "kg", nonnegative, default = "0 kg")]
    pub yoke_mass: f64,
    /// Acceleration of gravity.
    /// Zero for a mechanism in a horizontal plane.
    #[input("g", "m/s^2", planar, default = "(0; -9.81) m/s^2")]
    pub gravity: Vector3<f64>,
}

/// Unknown of the sum of virtual works.
#[derive(Clone, Debug, Inputs)]
pub enum ScotchYokeUnknown {
    /// Torque on the crank
    Torque {
        /// Force on the yoke.
        /// Along x.
        #[input("F", "N")]
        force: f64,
    },
    /// Force on the yoke
    Force {
        /// Torque on the crank.
        /// Positive counter-clockwise.
        #[input("T_2", "N*m")]
        torque: f64,
    },
}

/// Results in one position.
pub struct ScotchYokePosition<N> {
    position: N,
    shift: N,
    velocity: N,
    acceleration: N,
    torque: N,
    force: N,
}

register!(ScotchYoke);

/// Below this displacement for a unit turn, in crank lengths, the yoke turns back.
const DEAD: f64 = 1e-9;

impl Analysis for ScotchYoke {
    const ABOUT: About = About {
        id: "virtual-work/scotch-yoke",
        title: "Scotch yoke",
        topic: "Plane linkages",
        summary: "Torque on the crank or force on the yoke of a Scotch yoke, at rest or in motion, by virtual work; harmonic motion and reactions.",
        main: &["torque", "force", "velocity"],
        keywords: "garfo escocês jugo escocês senoidal movimento harmônico manivela cursor ranhurado bomba compressor \
                   scotch yoke donkey crosshead harmonic motion",
        sources: &[&RIUL, &SHIGLEY, &NORTON],
        cases: include_str!("../../cases/scotch_yoke.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &ScotchYokeGiven<W>, sheet: W) -> Result<(), Refusal> {
        let found = self.efforts(given, sheet)?;
        sheet.answer("position", "Position of the yoke", found.position);
        if self.moves() {
            sheet.answer("velocity", "Velocity of the yoke", found.velocity);
            sheet.answer("acceleration", "Acceleration of the yoke", found.acceleration);
        }
        match self.unknown {
            ScotchYokeUnknown::Torque { .. } => sheet.answer("torque", "Torque on the crank", found.torque),
            ScotchYokeUnknown::Force { .. } => sheet.answer("force", "Force on the yoke", found.force),
        }
        let (solved, [bearing, slot, guide]) = self.built(&found).map_err(built::refusal)?;
        let forces = solved.reaction(bearing);
        let label = "Force in the bearing of the crank";
        works::reaction(["O", "Ox", "Oy"], ("bearing_force", label), (&solved, bearing), sheet);
        let why = "Force of the yoke on the crank pin, along x, by the same equations";
        let pin = sheet.numerical("N", "N", -solved.reaction(slot)[0], (why, SHIGLEY.at("ch. 11")));
        sheet.answer("pin_force", "Force of the yoke on the crank pin, along x", pin);
        self.largest(given, sheet);
        if self.moves() {
            self.kinematics(given, &found, &solved, sheet);
        }
        sheet.verify(|| {
            let effort = match self.unknown {
                ScotchYokeUnknown::Torque { .. } => found.torque,
                ScotchYokeUnknown::Force { .. } => found.force,
            };
            solved.check_effort(0, effort, sheet);
            solved.check_across(slot, -pin, sheet);
            if self.moves() {
                let both = found.velocity.powi(2) + (given.speed * found.position).powi(2);
                let what = "position and velocity of the yoke are on the circle of the harmonic motion";
                sheet.check(what, both, (given.crank * given.speed).powi(2));
            }
            let across = solved.reaction(guide)[0];
            works::check_balance(&[forces, [found.force.value(), across]], solved.inertia_resultant(), sheet);
        });
        sheet.show(|| solved.works(0));
        self.show(sheet);
        Ok(())
    }
}

impl Template for ScotchYoke {
    type Found<N: Real> = ScotchYokePosition<N>;

    fn efforts<W: Worksheet>(
        &self,
        given: &ScotchYokeGiven<W>,
        sheet: W,
    ) -> Result<ScotchYokePosition<W::Num>, Refusal> {
        let (r, theta) = (given.crank, given.angle);
        let moves = self.moves();
        let why = ("Position of the yoke: that of the crank pin along x", NORTON.at("ch. 3"));
        let position = sheet.step("x", "mm", r * theta.cos(), why);
        let why = "Virtual displacement of the yoke for δθ_2 = 1: δx = −r sin θ_2 δθ_2";
        let shift = sheet.step("u", "mm", -(r * theta.sin()), (why, SHIGLEY.at("ch. 3")));
        let zero = W::Num::from(0.0);
        let (mut velocity, mut acceleration) = (zero, zero);
        if moves {
            velocity = sheet.step("v", "m/s", shift * given.speed, "Velocity of the yoke");
            let value = -(r * given.speed.powi(2) * theta.cos()) - r * given.acceleration * theta.sin();
            acceleration = sheet.step("a", "m/s^2", value, "Acceleration of the yoke");
        }
        let crank = RotatingLinkWork::crank(theta, given.speed, given.acceleration);
        let mut works = Works::new(given.gravity, moves, sheet);
        works.link(TWO, given.crank_mass.as_ref(), r, works::fixed(), crank);
        let yoke = PointWork { shift: plane::<W>(shift, zero), acceleration: plane::<W>(acceleration, zero) };
        works.mass(FOUR, given.yoke_mass, yoke);
        let (torque, force) = match given.unknown {
            ScotchYokeUnknownGiven::Torque { force } => {
                (works.balanced("F", force * shift, "Virtual work of the force on the yoke"), force)
            }
            ScotchYokeUnknownGiven::Force { torque } => {
                if shift.value().abs() <= DEAD * self.crank {
                    return Err(Refusal::because(
                        "the crank lies along the line of the yoke (dead centre): no force on the yoke can balance a torque; rotate the crank slightly",
                    ));
                }
                works.driving(torque);
                let why = "Force, from the principle of virtual work, F u + ΣδW = 0";
                (torque, sheet.step("F", "N", -(works.sum() / shift), (why, RIUL.at("eq. 5"))))
            }
        };
        Ok(ScotchYokePosition { position, shift, velocity, acceleration, torque, force })
    }
}

impl ScotchYoke {
    fn moves(&self) -> bool {
        self.speed != 0.0 || self.acceleration != 0.0
    }

    /// Velocity and acceleration of the crank pin A, and its sliding in the slot, which is across the line of the yoke.
    fn kinematics<W: Worksheet>(
        &self,
        given: &ScotchYokeGiven<W>,
        found: &ScotchYokePosition<W::Num>,
        solved: &Solved,
        sheet: W,
    ) {
        let crank = RotatingLinkWork::crank(given.angle, given.speed, given.acceleration);
        let of = Kinematics::new(given.speed, given.acceleration, given.crank, sheet);
        let a = of.about(&kinematics::A, crank.reach::<W>(given.crank), crank);
        let [r, theta] = [given.crank, given.angle];
        let why =
            ("Velocity of the crank pin in the slot: the part of its velocity along y", NORTON.at("ch. 6"));
        let slip = sheet.step(symbol("v", "s"), "m/s", r * given.speed * theta.cos(), why);
        sheet.answer("slip_velocity", "Velocity of the crank pin in the slot", slip);
        let value = r * given.acceleration * theta.cos() - r * given.speed.powi(2) * theta.sin();
        let why = "Acceleration of the crank pin in the slot; the yoke does not rotate: there is no Coriolis acceleration";
        let acceleration = sheet.step(symbol("a", "s"), "m/s^2", value, (why, NORTON.at("ch. 7")));
        sheet.answer("slip_acceleration", "Acceleration of the crank pin in the slot", acceleration);
        sheet.verify(|| {
            let zero = W::Num::from(0.0);
            let sliding = Kinematics::<W>::sliding(plane::<W>(zero, 1.0.into()), slip, acceleration, zero);
            let yoke = kinematics::Motion {
                velocity: plane::<W>(found.velocity, zero),
                acceleration: plane::<W>(found.acceleration, zero),
            };
            of.check(&kinematics::A, a, solved, 0, [self.crank, 0.0]);
            of.check_relative(["A", "4", "s"], [a, yoke, sliding]);
        });
    }

    /// The largest torque of a turn: `T = sin θ (r F − m r² ω² cos θ)` has its extremes where
    /// `2 B cos² θ + A cos θ − B = 0`.
    fn largest<W: Worksheet>(&self, given: &ScotchYokeGiven<W>, sheet: W) {
        let ScotchYokeUnknownGiven::Torque { force } = given.unknown else { return };
        let level = self.gravity.x == 0.0 && self.crank_mass.is_none() && self.acceleration == 0.0;
        if !level || force.value() == 0.0 || self.yoke_mass == 0.0 || self.speed == 0.0 {
            return;
        }
        let load = given.crank * force.abs();
        let load = sheet.step("A", "N*m", load, "Amplitude of the torque of the force");
        let inertia = given.yoke_mass * given.crank.powi(2) * given.speed.powi(2);
        let inertia =
            sheet.step("B", "N*m", inertia, "Twice the amplitude of the torque of the inertia force");
        let cosine = ((load.powi(2) + inertia.powi(2) * 8.0).sqrt() - load) / (inertia * 4.0);
        let why =
            "Where sin θ (A + B cos θ) is a maximum: 2B cos² θ + A cos θ − B = 0, in magnitude of the cosine";
        let cosine = sheet.step("c", "1", cosine, why);
        let largest = (W::Num::from(1.0) - cosine.powi(2)).sqrt() * (load + inertia * cosine);
        sheet.common_error(
            symbol("T", "max"),
            "the amplitudes of both torques added, as if reached at one angle",
            || load + inertia / 2.0,
        );
        let largest =
            sheet.step(symbol("T", "max"), "N*m", largest, "Maximum torque over a revolution, in magnitude");
        sheet.answer("largest_torque", "Maximum torque over a revolution, in magnitude", largest);
        sheet.verify(|| {
            let torque =
                |angle: f64| Self { angle, ..self.clone() }.plain().map_or(0.0, |found| found.torque.abs());
            let turn = cosine.value().clamp(-1.0, 1.0).acos();
            let there = torque(turn).max(torque(std::f64::consts::PI - turn));
            let size = load.value() + inertia.value();
            sheet.check_sum(
                "the virtual work at the angle of the maximum torque",
                largest,
                there.into(),
                size,
            );
            const ANGLES: u32 = 60;
            let all = (0..ANGLES).map(|k| torque(f64::from(k) * TAU / f64::from(ANGLES)));
            let over = (all.fold(0.0, f64::max) - largest.value()).max(0.0);
            sheet.check_zero("no torque of the turn is larger", over.into(), size);
        });
    }

    /// The same mechanism put together, and its joints: bearing, slot, guide.
    fn built<N: Real>(&self, found: &ScotchYokePosition<N>) -> Result<(Solved, [usize; 3]), PlanarError> {
        let mut it = Built::new([self.gravity.x, self.gravity.y]);
        let mass = LinkMass::built(self.crank_mass.as_ref(), self.crank);
        let crank = it.link("crank", [0.0; 2], self.angle, mass);
        let place = [found.position.value(), 0.0];
        let yoke = it.link("yoke", place, 0.0, built::BuiltMass::at_pin(self.yoke_mass));
        let (start, middle) = (BodyPoint::ground([0.0; 2]), yoke.point([0.0; 2]));
        let quarter = FRAC_PI_2;
        let pin = crank.point([self.crank, 0.0]);
        let joints = [
            it.pin(start, crank.point([0.0; 2])),
            it.join(PlanarJoint::Slot { guide: middle, direction: quarter, pin, offset: 0.0 }),
            it.join(PlanarJoint::Slider { guide: start, direction: 0.0, slides: middle, angle: 0.0 }),
        ];
        match self.unknown {
            ScotchYokeUnknown::Torque { force } => {
                if force != 0.0 {
                    it.force("Force on the yoke", middle, [force, 0.0]);
                }
                it.turn(crank, [self.angle, self.speed, self.acceleration]);
            }
            ScotchYokeUnknown::Force { torque } => {
                if torque != 0.0 {
                    it.couple("Torque on the crank", crank, torque);
                }
                let along = RelativeCoordinate::Component { direction: [1.0, 0.0], from: start, to: middle };
                it.drive(along, [place[0], found.velocity.value(), found.acceleration.value()]);
            }
        }
        Ok((it.solve()?, joints))
    }

    fn show<W: Worksheet>(&self, sheet: W) {
        let at = |angle: f64| ScotchYoke { angle, ..self.clone() };
        let range = Range::Turn(self.angle);
        let cycle = TemplateRange::new(range, "angle", at);
        match self.unknown {
            ScotchYokeUnknown::Torque { .. } => sheet.show(|| cycle.torque(|found| found.torque)),
            ScotchYokeUnknown::Force { .. } => sheet.show(|| {
                cycle.plot(
                    "Force over one revolution",
                    ("Force on the yoke", "N"),
                    &[("force", "force", &|found| built::bounded(found.force, found.shift, self.crank))],
                )
            }),
        }
        sheet.show(|| {
            built::animation(
                "The Scotch yoke",
                ("angle", self.angle),
                range,
                4.0 * self.crank,
                |angle, sketch| {
                    let there = at(angle);
                    let found = there.plain()?;
                    let (r, x) = (there.crank, found.position);
                    let (o, pin) = ((0.0, 0.0), At::from(built::away([0.0; 2], r, angle)));
                    let (unit, end) = (sketch.symbol(), (x + 2.5 * r, 0.0));
                    let side = |shift: f64, height: f64| (x + shift * unit, height);
                    let high = r + 2.0 * unit;
                    sketch
                        .circle(o, r, Ink::Faint)
                        .bearing("", (2.2 * r, 0.0), 0.0)
                        .bars([
                            side(-1.2, -high),
                            side(1.2, -high),
                            side(1.2, high),
                            side(-1.2, high),
                            side(-1.2, -high),
                        ])
                        .bars([side(1.2, 0.0), end])
                        .axis(o, (6.0 * unit, 0.0))
                        .slider("", pin, FRAC_PI_2)
                        .link("r", o, pin)
                        .pin("O", o)
                        .joint("A", pin)
                        .angle("θ₂", o, 0.0, angle.rem_euclid(TAU));
                    if there.yoke_mass != 0.0 {
                        sketch.label("m₄", side(0.0, high));
                    }
                    figure::link_mass(sketch, 2, there.crank_mass.as_ref(), (o, pin), 2.0);
                    let torque = match there.unknown {
                        ScotchYokeUnknown::Force { torque } => torque,
                        ScotchYokeUnknown::Torque { .. } => 0.0,
                    };
                    figure::turning(sketch, o, ("ω₂", there.speed), ("T₂", torque));
                    let tip = (end.0 - 2.4 * unit, 0.0);
                    figure::on_slider(sketch, "F", tip, (found.force, 0.0), r);
                    Some(())
                },
            )
        });
    }
}
