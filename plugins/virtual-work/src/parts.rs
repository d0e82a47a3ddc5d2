//! The parts that a mechanism is described with, and the mechanism that they make.

pub(crate) mod drawing;
mod refusal;

use dalembert_core::{Inputs, Reference, Refusal, Text};
use dalembert_mechanics::planar::{self, Measure, PlanarError, Profile, System};
use nalgebra::Vector3;

/// A rigid body, in axes of its own.
#[derive(Clone, Debug, Inputs)]
pub struct Part {
    /// Name.
    pub name: String,
    /// Mass.
    /// Zero for a body whose weight and inertia do not count.
    #[input("m", "kg", nonnegative, default = "0 kg")]
    pub mass: f64,
    /// Moment of inertia about the mass centre.
    #[input("I_G", "kg*m^2", nonnegative, default = "0 kg*m^2")]
    pub inertia: f64,
    /// Mass centre, in the axes of the body.
    #[input("G", "mm", planar, default = "(0; 0) mm")]
    pub centre: Vector3<f64>,
    /// About at which angle it lies.
    /// Settles on which side a linkage is assembled; the joints correct it.
    #[input("θ_0", "deg", default = "0 deg")]
    pub angle: f64,
}

/// A named point of a body or of the ground.
#[derive(Clone, Debug, Inputs)]
pub struct Spot {
    /// Name.
    pub name: String,
    /// Part that carries it.
    pub on: Carrier,
    /// Place, in the axes of its part.
    #[input("P", "mm", planar)]
    pub at: Vector3<f64>,
}

/// A part of a mechanism.
#[derive(Clone, Debug, Inputs)]
pub enum Carrier {
    /// Ground
    Ground,
    /// Body
    Body {
        /// Body.
        #[input(rows = "bodies")]
        body: Reference,
    },
}

/// A joint, by its name.
#[derive(Clone, Debug, Inputs)]
pub struct Connection {
    /// Name.
    pub name: String,
    /// Kind of joint.
    pub joint: Joint,
}

/// What holds two parts together.
#[derive(Clone, Debug, Inputs)]
pub enum Joint {
    /// Pin
    Pin {
        /// Point.
        #[input(rows = "points")]
        a: Reference,
        /// Point that is pinned to it.
        #[input(rows = "points")]
        b: Reference,
    },
    /// Slider
    Slider {
        /// Point of the guide.
        #[input(rows = "points")]
        guide: Reference,
        /// Direction of the guide, in the axes of its part.
        #[input("φ", "deg", default = "0 deg")]
        direction: f64,
        /// Point that slides along it.
        #[input(rows = "points")]
        slides: Reference,
        /// Angle of the sliding body against the part with the guide.
        #[input("β", "deg", default = "0 deg")]
        angle: f64,
    },
    /// Pin in a straight slot
    Slot {
        /// Point of the slot.
        #[input(rows = "points")]
        guide: Reference,
        /// Direction of the slot, in the axes of its part.
        #[input("φ", "deg", default = "0 deg")]
        direction: f64,
        /// Pin.
        #[input(rows = "points")]
        pin: Reference,
        /// Distance of the pin to the left of the line.
        #[input("e", "mm", default = "0 mm")]
        offset: f64,
    },
    /// Weld
    Weld {
        /// Point.
        #[input(rows = "points")]
        a: Reference,
        /// Point that is fixed to it.
        #[input(rows = "points")]
        b: Reference,
        /// Angle of the second part against the first.
        #[input("β", "deg", default = "0 deg")]
        angle: f64,
    },
    /// Rod with a pin at each end
    Rod {
        /// One end.
        #[input(rows = "points")]
        from: Reference,
        /// Other end.
        #[input(rows = "points")]
        to: Reference,
        /// Length.
        #[input("L", "mm", positive)]
        length: f64,
    },
    /// Gears in mesh
    Gears {
        /// Gear.
        a: Carrier,
        /// Gear that it meshes with.
        b: Carrier,
        /// Part that carries both.
        carrier: Carrier,
        /// Teeth or pitch radius of the first.
        #[input("z_a", "1", positive)]
        size_a: f64,
        /// Teeth or pitch radius of the second.
        #[input("z_b", "1", positive)]
        size_b: f64,
        /// The second has its teeth inside.
        internal: bool,
    },
    /// Wheel that rolls on a line, or pinion on a rack
    Rolling {
        /// Point of the line.
        #[input(rows = "points")]
        guide: Reference,
        /// Direction of the line, in the axes of its part.
        #[input("φ", "deg", default = "0 deg")]
        direction: f64,
        /// Centre of the wheel, to the left of the line.
        #[input(rows = "points")]
        centre: Reference,
        /// Radius.
        #[input("r", "mm", positive)]
        radius: f64,
        /// The wheel is held at this distance by the line alone.
        /// No for a pinion that has a bearing of its own.
        resting: bool,
    },
    /// Cord over pulleys and drums
    Cord {
        /// Straight runs.
        #[input(min = 1)]
        runs: Vec<Run>,
        /// Drums that wind it.
        drums: Vec<Drum>,
    },
    /// Cam: a turning body that moves a point
    Cam {
        /// Body that turns.
        #[input(rows = "bodies")]
        cam: Reference,
        /// Point of the guide of the follower.
        #[input(rows = "points")]
        guide: Reference,
        /// Direction in which the follower is moved, in the axes of the part with the guide.
        #[input("φ", "deg", default = "90 deg")]
        direction: f64,
        /// Point of the follower.
        #[input(rows = "points")]
        follower: Reference,
        /// Lift over the angle of the cam, for one turn.
        #[input(table)]
        lift: Vec<LiftPoint>,
    },
}

/// A point of the lift of a cam.
#[derive(Clone, Copy, Debug, Inputs)]
pub struct LiftPoint {
    /// Angle of the cam.
    #[input("θ", "deg")]
    pub angle: f64,
    /// Lift.
    #[input("s", "mm")]
    pub lift: f64,
}

/// A straight run of a cord.
#[derive(Clone, Debug, Inputs)]
pub struct Run {
    /// From.
    #[input(rows = "points")]
    pub from: Reference,
    /// To.
    #[input(rows = "points")]
    pub to: Reference,
}

/// A drum that winds a cord.
#[derive(Clone, Debug, Inputs)]
pub struct Drum {
    /// Part that turns.
    pub of: Carrier,
    /// Part against which it turns.
    pub against: Carrier,
    /// Radius.
    /// Positive if a turn counter-clockwise takes cord up.
    #[input("r", "mm")]
    pub radius: f64,
}

/// What moves or holds the mechanism.
#[derive(Clone, Debug, Inputs)]
pub struct Drive {
    /// Name.
    pub name: String,
    /// What is driven.
    pub what: Driven,
}

/// A measure and its motion.
#[derive(Clone, Debug, Inputs)]
pub enum Driven {
    /// Angle of a body
    Angle {
        /// Body.
        #[input(rows = "bodies")]
        body: Reference,
        /// Part against which it turns.
        against: Carrier,
        /// Angle.
        #[input("θ", "deg")]
        value: f64,
        /// Angular velocity.
        #[input("ω", "rad/s", default = "0 rad/s")]
        velocity: f64,
        /// Angular acceleration.
        #[input("α", "rad/s^2", default = "0 rad/s^2")]
        acceleration: f64,
    },
    /// Position of a point
    Position {
        /// Point from which it is measured.
        #[input(rows = "points")]
        from: Reference,
        /// Point.
        #[input(rows = "points")]
        to: Reference,
        /// Direction in which it is measured, in the axes of the part of the first.
        #[input("φ", "deg", default = "0 deg")]
        direction: f64,
        /// Position.
        #[input("s", "mm")]
        value: f64,
        /// Velocity.
        #[input("v", "m/s", default = "0 m/s")]
        velocity: f64,
        /// Acceleration.
        #[input("a", "m/s^2", default = "0 m/s^2")]
        acceleration: f64,
    },
    /// Distance of two points: a cylinder, a cord that is pulled
    Distance {
        /// From.
        #[input(rows = "points")]
        from: Reference,
        /// To.
        #[input(rows = "points")]
        to: Reference,
        /// Distance.
        #[input("s", "mm", positive)]
        value: f64,
        /// Velocity.
        #[input("v", "m/s", default = "0 m/s")]
        velocity: f64,
        /// Acceleration.
        #[input("a", "m/s^2", default = "0 m/s^2")]
        acceleration: f64,
    },
}

/// A load, by its name.
#[derive(Clone, Debug, Inputs)]
pub struct NamedLoad {
    /// Name.
    pub name: String,
    /// Kind of load.
    pub load: Load,
}

/// What acts on a mechanism.
#[derive(Clone, Debug, Inputs)]
pub enum Load {
    /// Force at a point
    Force {
        /// Point.
        #[input(rows = "points")]
        at: Reference,
        /// Force.
        #[input("F", "N", planar)]
        force: Vector3<f64>,
        /// Part in whose axes it is given.
        axes: Carrier,
    },
    /// Couple
    Couple {
        /// Part that it acts on.
        on: Carrier,
        /// Part that it reacts on.
        against: Carrier,
        /// Moment.
        #[input("T", "N*m")]
        moment: f64,
    },
    /// Force between two points
    /// Positive when it pushes them apart.
    Thrust {
        /// From.
        #[input(rows = "points")]
        from: Reference,
        /// To.
        #[input(rows = "points")]
        to: Reference,
        /// Force.
        #[input("F", "N")]
        force: f64,
    },
    /// Spring
    Spring {
        /// From.
        #[input(rows = "points")]
        from: Reference,
        /// To.
        #[input(rows = "points")]
        to: Reference,
        /// Stiffness.
        #[input("k", "N/m", nonnegative)]
        stiffness: f64,
        /// Length of the unstretched spring.
        #[input("L_0", "mm", nonnegative)]
        free: f64,
    },
    /// Torsion spring
    TorsionSpring {
        /// Part that turns.
        of: Carrier,
        /// Part against which it turns.
        against: Carrier,
        /// Stiffness.
        #[input("κ", "N*m/rad", nonnegative)]
        stiffness: f64,
        /// Angle of the untwisted spring.
        #[input("θ_f", "deg", default = "0 deg")]
        free: f64,
    },
    /// Damper
    Damper {
        /// From.
        #[input(rows = "points")]
        from: Reference,
        /// To.
        #[input(rows = "points")]
        to: Reference,
        /// Damping coefficient.
        #[input("c", "N*s/m", nonnegative)]
        coefficient: f64,
    },
    /// Gas between two points
    /// `A (p₁ (L₁/L)ⁿ − p₀)`, pushing them apart.
    Gas {
        /// From.
        #[input(rows = "points")]
        from: Reference,
        /// To.
        #[input(rows = "points")]
        to: Reference,
        /// Area of the piston.
        #[input("A", "mm^2", positive)]
        area: f64,
        /// Absolute pressure at the given length.
        #[input("p_1", "bar", nonnegative)]
        pressure: f64,
        /// Length of the gas column at that pressure.
        #[input("L_1", "mm", positive)]
        column: f64,
        /// Exponent.
        /// 1 for constant temperature, 1.4 for air without heat.
        #[input("n", "1", positive, default = "1.4")]
        exponent: f64,
        /// Absolute pressure outside.
        #[input("p_0", "bar", nonnegative, default = "1.013 bar")]
        ambient: f64,
    },
    /// Friction in a joint
    Friction {
        /// Pin, slider or slot.
        #[input(rows = "joints")]
        joint: Reference,
        /// Coefficient of friction.
        #[input("μ", "1", nonnegative)]
        coefficient: f64,
        /// Radius of the pin.
        #[input("r_p", "mm", nonnegative, default = "0 mm")]
        radius: f64,
    },
}

/// The parts of a mechanism together.
pub(crate) struct Parts<'a> {
    pub(crate) gravity: Vector3<f64>,
    pub(crate) bodies: &'a [Part],
    pub(crate) points: &'a [Spot],
    pub(crate) joints: &'a [Connection],
    pub(crate) drivers: &'a [Drive],
    pub(crate) loads: &'a [NamedLoad],
}

impl Carrier {
    pub(crate) fn frame(&self) -> planar::Frame {
        match self {
            Carrier::Ground => None,
            Carrier::Body { body } => Some(body.0),
        }
    }
}

impl Parts<'_> {
    /// A point, from the mass centre of its body.
    pub(crate) fn point(&self, reference: Reference) -> planar::Point {
        let spot = &self.points[reference.0];
        let on = spot.on.frame();
        let origin = on.map_or(Vector3::zeros(), |body| self.bodies[body].centre);
        planar::Point { on, at: [spot.at.x - origin.x, spot.at.y - origin.y] }
    }

    pub(crate) fn along(&self, from: Reference, to: Reference, direction: f64) -> Measure {
        let direction = [direction.cos(), direction.sin()];
        Measure::Along { direction, from: self.point(from), to: self.point(to) }
    }

    pub(crate) fn distance(&self, from: Reference, to: Reference) -> Measure {
        Measure::Distance { from: self.point(from), to: self.point(to) }
    }

    /// The mechanism, and the rows of its joints: a joint of the form may stand for two of the mechanism.
    pub(crate) fn mechanism(&self) -> Result<(planar::Mechanism, Vec<usize>), Refusal> {
        let bodies =
            self.bodies.iter().map(|body| planar::Body { mass: body.mass, inertia: body.inertia }).collect();
        let (mut joints, mut rows) = (Vec::new(), Vec::new());
        for (row, connection) in self.joints.iter().enumerate() {
            for joint in self.joint(connection)? {
                joints.push(joint);
                rows.push(row);
            }
        }
        let drivers = self.drivers.iter().map(|drive| self.driver(&drive.what)).collect();
        let loads = self.loads.iter().map(|load| self.load(&load.load, &rows)).collect();
        let gravity = [self.gravity.x, self.gravity.y];
        Ok((planar::Mechanism { bodies, joints, drivers, loads, gravity }, rows))
    }

    fn joint(&self, connection: &Connection) -> Result<Vec<planar::Joint>, Refusal> {
        let point = |reference: &Reference| self.point(*reference);
        Ok(match &connection.joint {
            Joint::Pin { a, b } => vec![planar::Joint::Pin { a: point(a), b: point(b) }],
            Joint::Slider { guide, direction, slides, angle } => vec![planar::Joint::Slider {
                guide: point(guide),
                direction: *direction,
                slides: point(slides),
                angle: *angle,
            }],
            Joint::Slot { guide, direction, pin, offset } => vec![planar::Joint::Slot {
                guide: point(guide),
                direction: *direction,
                pin: point(pin),
                offset: *offset,
            }],
            Joint::Weld { a, b, angle } => {
                vec![planar::Joint::Weld { a: point(a), b: point(b), angle: *angle }]
            }
            Joint::Rod { from, to, length } => {
                vec![planar::Joint::Rod { from: point(from), to: point(to), length: *length }]
            }
            Joint::Gears { a, b, carrier, size_a, size_b, internal } => vec![planar::Joint::Gears {
                a: a.frame(),
                b: b.frame(),
                carrier: carrier.frame(),
                sizes: [*size_a, *size_b],
                internal: *internal,
            }],
            Joint::Rolling { guide, direction, centre, radius, resting } => {
                let (guide, centre) = (point(guide), point(centre));
                let rolling = planar::Joint::Rack { guide, direction: *direction, centre, radius: *radius };
                let held = planar::Joint::Slot { guide, direction: *direction, pin: centre, offset: *radius };
                if *resting { vec![held, rolling] } else { vec![rolling] }
            }
            Joint::Cord { runs, drums } => vec![planar::Joint::Cord {
                runs: runs.iter().map(|run| [point(&run.from), point(&run.to)]).collect(),
                drums: drums
                    .iter()
                    .map(|drum| (drum.of.frame(), drum.against.frame(), drum.radius))
                    .collect(),
            }],
            Joint::Cam { cam, guide, direction, follower, lift } => {
                let points: Vec<[f64; 2]> = lift.iter().map(|point| [point.angle, point.lift]).collect();
                let profile = Profile::through(&points, Some(std::f64::consts::TAU)).ok_or_else(|| {
                    Refusal::because(
                        Text::new("the lift of the cam {name} needs at least three points with rising angles within one turn")
                            .with("name", &connection.name),
                    )
                })?;
                vec![planar::Joint::Cam {
                    follower: self.along(*guide, *follower, *direction),
                    cam: Measure::Angle { of: Some(cam.0), against: None },
                    profile,
                }]
            }
        })
    }

    fn driver(&self, what: &Driven) -> planar::Driver {
        match *what {
            Driven::Angle { body, ref against, value, velocity, acceleration } => {
                let measure = Measure::Angle { of: Some(body.0), against: against.frame() };
                planar::Driver { measure, value, velocity, acceleration }
            }
            Driven::Position { from, to, direction, value, velocity, acceleration } => {
                let measure = self.along(from, to, direction);
                planar::Driver { measure, value, velocity, acceleration }
            }
            Driven::Distance { from, to, value, velocity, acceleration } => {
                planar::Driver { measure: self.distance(from, to), value, velocity, acceleration }
            }
        }
    }

    /// What a load pushes apart or turns; none for a force at a point and for friction.
    pub(crate) fn measure(&self, load: &Load) -> Option<Measure> {
        match load {
            Load::Couple { on: of, against, .. } | Load::TorsionSpring { of, against, .. } => {
                Some(Measure::Angle { of: of.frame(), against: against.frame() })
            }
            Load::Thrust { from, to, .. }
            | Load::Spring { from, to, .. }
            | Load::Damper { from, to, .. }
            | Load::Gas { from, to, .. } => Some(self.distance(*from, *to)),
            Load::Force { .. } | Load::Friction { .. } => None,
        }
    }

    fn load(&self, load: &Load, rows: &[usize]) -> planar::Load {
        use planar::Effort;
        let effort = match *load {
            Load::Force { at, force, ref axes } => {
                let (at, force) = (self.point(at), [force.x, force.y]);
                return planar::Load::Force { at, force, turns_with: axes.frame() };
            }
            Load::Friction { joint, coefficient, radius } => {
                let joint = rows.iter().position(|row| *row == joint.0).unwrap_or(usize::MAX);
                return planar::Load::Friction { joint, coefficient, radius };
            }
            Load::Couple { moment: constant, .. } | Load::Thrust { force: constant, .. } => {
                Effort::Constant(constant)
            }
            Load::Spring { stiffness, free, .. } | Load::TorsionSpring { stiffness, free, .. } => {
                Effort::Spring { stiffness, free }
            }
            Load::Damper { coefficient, .. } => Effort::Damper { coefficient },
            Load::Gas { area, pressure, column, exponent, ambient, .. } => {
                Effort::Gas { area, pressure, column, exponent, ambient }
            }
        };
        let measure = self.measure(load).expect("every load but a force and friction has a measure");
        planar::Load::Effort { measure, effort }
    }

    /// The mechanism, assembled.
    pub(crate) fn assembled(&self) -> Result<(System, Vec<usize>, Vec<[f64; 3]>), Refusal> {
        if self.bodies.is_empty() {
            return Err(Refusal::because("there is no body: write down at least one"));
        }
        let (mechanism, rows) = self.mechanism()?;
        let mut angles: Vec<f64> = self.bodies.iter().map(|body| body.angle).collect();
        for driver in &mechanism.drivers {
            if let Measure::Angle { of: Some(body), against: None } = driver.measure {
                angles[body] = driver.value;
            }
        }
        let refuse = |error: PlanarError| self.refusal(&error, &rows);
        let drawn = System::place(&mechanism, &angles).map_err(refuse)?;
        let system = System::new(&mechanism, &drawn).map_err(refuse)?;
        let positions = system.assemble(&drawn).map_err(refuse)?;
        Ok((system, rows, positions))
    }
}

/// A name that somebody gave, as it is.
pub(crate) fn verbatim(name: impl std::fmt::Display) -> Text {
    Text::new("{given_name}").with("given_name", name)
}
