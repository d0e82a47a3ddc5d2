//! The motion of a plane mechanism of any shape under its loads: what nothing drives moves freely.

mod ends;
mod pictures;
mod witness;

use dalembert_core::{About, Analysis, Inputs, Reference, Refusal, Text, Worksheet, register};
use dalembert_mechanics::planar::{
    Contact, Event, ForwardDynamics, JointFriction, Model, PlanarError, PlanarRun, PlanarState,
    RelativeCoordinate, Snapshot, Trajectory,
};
use dalembert_mechanics::{Real, Vector};
use dalembert_numerics::ode::OdeError;
use nalgebra::Vector3;

pub use self::ends::{MechanismEvent, MechanismEventGiven};
use crate::{
    shared::parts::{
        Connection, Drive, Driven, NamedLoad, Part, PartLoad, PartLoadGiven, PartReference, Parts, Spot,
        carried, closure,
    },
    sources::{HAIRER, HAUG, NIKRAVESH, PFEIFFER, RIUL},
};

/// Error that each step may add, in parts of the size of the mechanism and of its fastest velocity: the first that can
/// be held.
const TOLERANCES: [f64; 4] = [1e-11, 1e-10, 1e-9, 1e-8];
/// Steps before a motion is given up: at least the first, of small mechanisms the second over the number of bodies.
const STEPS: usize = 20_000;
const STEPS_OF_BODIES: usize = 1_000_000;
/// Moments of a motion that are shown.
const MOMENTS: usize = 241;
/// An energy balance further off than this part of the energies is warned of.
const DOUBTFUL: f64 = 1e-9;
/// One further off than this part of them has lost more than digits at a singular position: it fails.
const WRONG: f64 = 1e-5;

/// An energy balance off by this many roundings of the stored energy is no doubt.
const ROUNDINGS: f64 = 8.0;

/// A mechanism in the plane, drawn in x and y, and left to its loads; joints with friction stick and slip.
///
/// Each body has axes of its own, in which its points are given; joints bring the points together. Angles and
/// couples are positive counter-clockwise.
#[derive(Clone, Debug, Inputs)]
pub struct Motion {
    /// Bodies.
    #[input(min = 1)]
    pub bodies: Vec<Part>,
    /// Points.
    pub points: Vec<Spot>,
    /// Joints.
    pub joints: Vec<Connection>,
    /// Drivers.
    /// Undriven coordinates move freely; the accelerations of the drivers stay constant.
    pub drivers: Vec<Drive>,
    /// Loads.
    pub loads: Vec<NamedLoad>,
    /// Acceleration of gravity.
    #[input("g", "m/s^2", planar, default = "(0; -9.81) m/s^2")]
    pub gravity: Vector3<f64>,
    /// Start.
    /// Initial positions and velocities; if none are given, at rest at the angles given for the bodies.
    pub starts: Vec<Start>,
    /// Duration.
    #[input("t_e", "s", positive, default = "1 s")]
    pub duration: f64,
    /// What ends the motion before.
    #[input(default = "nothing")]
    pub end: MechanismEvent,
    /// Points whose motion is computed.
    pub watched: Vec<Continuation>,
}

/// A position and a velocity at the start, by a name.
#[derive(Clone, Debug, Inputs)]
pub struct Start {
    /// Name.
    pub name: String,
    /// Given quantity.
    pub what: InitialCoordinate,
}

/// A measure, its value and its velocity.
#[derive(Clone, Debug, Inputs)]
pub enum InitialCoordinate {
    /// Angle of a body
    Angle {
        /// Body.
        #[input(rows = "bodies")]
        body: Reference,
        /// Body relative to which it turns.
        against: PartReference,
        /// Angle.
        #[input("θ_0", "deg", kept_in = "drawn")]
        value: f64,
        /// Angle in the initial configuration.
        /// The drawn position fixes the gear meshing, the rolling of wheels, the cord lengths and the side on which a
        /// linkage is assembled; the mechanism moves from there. If omitted, the mechanism is drawn with the angle above.
        #[input("θ_d", "deg")]
        drawn: Option<f64>,
        /// Angular velocity.
        #[input("ω_0", "rad/s", default = "0 rad/s")]
        velocity: f64,
    },
    /// Position of a point
    Position {
        /// Point from which it is measured.
        #[input(rows = "points")]
        from: Reference,
        /// Point.
        #[input(rows = "points")]
        to: Reference,
        /// Direction of measurement, in the axes of the body of the first point.
        #[input("φ_0", "deg", default = "0 deg")]
        direction: f64,
        /// Position.
        #[input("s_0", "mm", kept_in = "drawn")]
        value: f64,
        /// Position in the initial configuration.
        /// The mechanism is drawn with this value and moves from there. If omitted, it is drawn with the position above.
        #[input("s_d", "mm")]
        drawn: Option<f64>,
        /// Velocity.
        #[input("v_0", "m/s", default = "0 m/s")]
        velocity: f64,
    },
}

/// A point whose motion is asked for.
#[derive(Clone, Debug, Inputs)]
pub struct Continuation {
    /// Point.
    #[input(rows = "points")]
    pub point: Reference,
}

register!(Motion);

impl Analysis for Motion {
    const ABOUT: About = About {
        id: "virtual-work/motion",
        title: "Motion of a plane mechanism under its loads",
        topic: "Any mechanism",
        summary: "Free motion of a plane mechanism of any shape from a start: accelerations by virtual power, joint forces, energy, an animation.",
        main: &["initial_acceleration", "angular_velocity", "velocity"],
        keywords: "movimento mecanismo plano dinâmica direta forward dynamics simulation multibody pendulum pêndulo linkage free motion \
                   energy andrews squeezer livre friction stick slip atrito",
        sources: &[&RIUL, &HAUG, &NIKRAVESH, &HAIRER, &PFEIFFER],
        cases: include_str!("../../cases/motion.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &MotionGiven<W>, sheet: W) -> Result<(), Refusal> {
        // The start is assembled as if it were driven there.
        let held: Vec<Drive> =
            self.drivers.iter().cloned().chain(self.starts.iter().map(Start::held)).collect();
        let mut parts = self.parts(&held)?;
        let (_, rows, positions) = parts.assembled(sheet)?;
        parts.drivers.truncate(self.drivers.len());
        let refuse = |error: PlanarError| parts.refusal(&error, &rows);
        let (mechanism, _) = parts.mechanism()?;
        let system = Model::new(&mechanism, &positions).map_err(refuse)?;
        let rates: Vec<(RelativeCoordinate, f64)> =
            self.starts.iter().map(|start| parts.rate(&start.what)).collect();
        let velocities = system.initial_velocities(&positions, &rates).map_err(refuse)?;
        let solved = system.forward_dynamics(&positions, &velocities).map_err(refuse)?;
        if solved.degrees_of_freedom == 0 {
            return Err(Refusal::because(
                "no free motion remains: the drivers and joints determine everything; remove a driver, or use the plane mechanism",
            ));
        }
        sheet.keep_going()?;
        let ends: Vec<Event> = self.end.end(&parts).into_iter().collect();
        let cancelled = || sheet.keep_going().is_err();
        let run = |tolerance: f64| PlanarRun {
            duration: self.duration,
            tolerance,
            samples: MOMENTS,
            ends: &ends,
            most_steps: STEPS.max(STEPS_OF_BODIES / self.bodies.len()),
            cancelled: &cancelled,
        };
        let follow = |tolerance: f64| system.simulate(&positions, &velocities, &run(tolerance));
        let [mut tolerance, looser @ ..] = TOLERANCES;
        let mut moved = follow(tolerance);
        for looser in looser {
            sheet.keep_going()?;
            if !moved.as_ref().is_err_and(|error| asks_for_a_looser_tolerance(error, self.duration)) {
                break;
            }
            let again = follow(looser);
            if again.is_ok() {
                (tolerance, moved) = (looser, again);
            }
        }
        sheet.keep_going()?;
        let moved = moved.map_err(refuse)?;
        self.end.check_relevance(&moved, &parts.bodies)?;
        let this = Solved {
            parts: &parts,
            rows: &rows,
            system: &system,
            dynamics: &solved,
            moved: &moved,
            tolerance,
        };
        this.loosened(sheet);
        this.start(given, sheet);
        this.finish(self, sheet)?;
        this.show(self, sheet);
        Ok(())
    }
}

/// A motion that was followed.
struct Solved<'a> {
    parts: &'a Parts,
    /// The row of each joint.
    rows: &'a [usize],
    system: &'a Model,
    /// The start.
    dynamics: &'a ForwardDynamics,
    moved: &'a Trajectory,
    /// Error that each step was let add.
    tolerance: f64,
}

/// Returns true if a motion that failed at this tolerance may succeed with a looser one.
fn asks_for_a_looser_tolerance(error: &PlanarError, duration: f64) -> bool {
    use OdeError::{NotFinite, TooManySteps, TooShort};
    // The length of a step goes with the eighth root of its error.
    let [tightest, .., loosest] = TOLERANCES;
    let longer = (loosest / tightest).powf(1.0 / 8.0);
    match error {
        PlanarError::Motion(NotFinite { .. } | TooShort { .. }) | PlanarError::NotFinite => true,
        PlanarError::Motion(TooManySteps { at, .. }) => at * longer >= duration,
        _ => false,
    }
}

impl Motion {
    fn parts(&self, drivers: &[Drive]) -> Result<Parts, Refusal> {
        let described = (&self.bodies[..], &self.points[..], &self.joints[..]);
        Parts::new(self.gravity, described, drivers, &self.loads)
    }
}

impl Parts {
    fn rate(&self, moving: &InitialCoordinate) -> (RelativeCoordinate, f64) {
        match *moving {
            InitialCoordinate::Angle { body, ref against, velocity, .. } => {
                (RelativeCoordinate::Angle { of: Some(body.0), against: against.frame() }, velocity)
            }
            InitialCoordinate::Position { from, to, direction, velocity, .. } => {
                (self.along(from, to, direction), velocity)
            }
        }
    }
}

impl Start {
    /// The driver that would hold the start.
    fn held(&self) -> Drive {
        let what = match self.what.clone() {
            InitialCoordinate::Angle { body, against, value, drawn, velocity } => {
                Driven::Angle { body, against, value, drawn, velocity, acceleration: 0.0 }
            }
            InitialCoordinate::Position { from, to, direction, value, drawn, velocity } => {
                Driven::Position { from, to, direction, value, drawn, velocity, acceleration: 0.0 }
            }
        };
        Drive { name: self.name.clone(), what }
    }
}

impl Solved<'_> {
    /// Says that the error which the steps should have held could not be.
    fn loosened<W: Worksheet>(&self, sheet: W) {
        let [wanted, ..] = TOLERANCES;
        if self.tolerance > wanted {
            sheet.warn(|| {
                Text::new("the motion could not be integrated with an error of {wanted} per step: {held} was used, relative to the size of the mechanism and its maximum velocity")
                    .with("wanted", format!("{wanted:e}"))
                    .with("held", format!("{:e}", self.tolerance))
            });
        }
    }

    /// Flushes a value below the error of a step, relative to the largest, to zero.
    fn without_error(&self, value: f64, largest: f64) -> f64 {
        if value.abs() > self.tolerance * largest { value } else { 0.0 }
    }

    /// The accelerations and the forces in the joints with which the motion begins.
    fn start<W: Worksheet>(&self, given: &MotionGiven<W>, sheet: W) {
        let PlanarState { accelerations, .. } = &self.dynamics.state;
        let mut shown = self.dynamics.state.clone();
        let largest = accelerations.iter().fold(0.0f64, |most, a| most.max(a[2].abs()));
        for (row, part) in (1..).zip(&self.parts.bodies) {
            // The method is reported once.
            let reason = if row == 1 {
                "Angular acceleration of {name} at the start: of all accelerations a + N s̈ allowed by the joints, the one with (Nᵀ M N) s̈ = Nᵀ (Q − M a), virtual power in each free motion N"
            } else {
                "Angular acceleration of {name} at the start"
            };
            let acceleration = sheet.numerical(
                ("α0", row),
                "rad/s^2",
                self.without_error(accelerations[row - 1][2], largest),
                (Text::new(reason).with("name", &part.name), HAUG.at("ch. 6")),
            );
            sheet.answer(("initial_acceleration", row), "Angular acceleration at the start", acceleration);
            sheet.row_label(("initial_acceleration", row), &part.name);
            shown.accelerations[row - 1][2] = acceleration.value();
        }
        sheet.verify(|| {
            let errors = [0.0, 0.0, self.tolerance * largest];
            let driving = closure::driving(self.system, &self.dynamics.multipliers);
            closure::check_pins(self.system, &shown, (errors, driving), sheet);
        });
        let mut carried = vec![None; self.parts.joints.len()];
        for (row, connection) in (1..).zip(&self.parts.joints) {
            let reason = if row == 1 {
                "Force that {name} exerts on its second point at the start, from M q̈ = Q + Φ_qᵀ λ"
            } else {
                "Force that {name} exerts on its second point at the start"
            };
            let why = (Text::new(reason).with("name", &connection.name), HAUG.at("ch. 6"));
            match self.carried(row - 1) {
                [Some(x), Some(y)] => {
                    let force = sheet.numerical_vector(("R", row), "N", Vector3::new(x, y, 0.0), why);
                    sheet.answer_vector(("joint_force", row), "Force in the joint at the start", force);
                    sheet.row_label(("joint_force", row), &connection.name);
                    carried[row - 1] = Some(force.magnitude());
                }
                [Some(one), None] | [None, Some(one)] => {
                    let force = sheet.numerical(("R", row), "N", one, why);
                    sheet.answer(
                        ("joint_effort", row),
                        "Force along the line of the joint at the start",
                        force,
                    );
                    sheet.row_label(("joint_effort", row), &connection.name);
                    carried[row - 1] = Some(force.abs());
                }
                [None, None] => {}
            }
        }
        for joint_friction in &self.dynamics.frictions {
            self.joint_friction(joint_friction, &given.loads[joint_friction.load].load, &carried, sheet);
        }
        if self
            .dynamics
            .frictions
            .iter()
            .any(|joint_friction| joint_friction.contact == Contact::Indeterminate)
        {
            sheet.warn(|| {
                Text::new("at the start several joints keep each other at rest: statics alone does not determine how their friction is shared, nor the joint forces")
            });
        }
    }

    /// Answers the friction of a joint at the start, for a given force in the joint of each row.
    fn joint_friction<W: Worksheet>(
        &self,
        joint_friction: &JointFriction,
        given: &PartLoadGiven<W>,
        carried: &[Option<W::Num>],
        sheet: W,
    ) {
        let row = joint_friction.load + 1;
        let NamedLoad { name, load } = &self.parts.loads[joint_friction.load];
        let unit = if joint_friction.pin { "N*m" } else { "N" };
        let why = |reason| (Text::new(reason).with("name", name), PFEIFFER.at("ch. 6"));
        let effort = match (joint_friction.contact, given, load) {
            (Contact::Indeterminate, ..) => return,
            (Contact::Sliding { sense, .. }, PartLoadGiven::Friction { coefficient, radius }, PartLoad::Friction { joint, .. }) => {
                let Some(force) = carried[joint.0] else { return };
                let (most, reason) = if joint_friction.pin {
                    (
                        *coefficient * *radius * force,
                        "{name} at the start: its pin slides, with a friction couple of μ r times the joint force, opposite to the sliding",
                    )
                } else {
                    (
                        *coefficient * force,
                        "{name} at the start: its joint slides, with friction μ times the joint force, opposite to the sliding",
                    )
                };
                let against = if sense > 0.0 { -most } else { most };
                sheet.step(("F", row), unit, against, why(reason))
            }
            _ => sheet.numerical(
                ("F", row),
                unit,
                joint_friction.effort,
                why("{name} at the start, positive in the direction of sliding: its joint sticks, since no possible motion would overcome the friction opposing it"),
            ),
        };
        sheet.answer(("friction", row), "Friction at the start", effort);
        sheet.row_label(("friction", row), name);
        sheet.verify(|| {
            let size = self
                .dynamics
                .frictions
                .iter()
                .fold(0.0f64, |most, joint_friction| most.max(joint_friction.effort.abs()));
            let residual = (effort.value() - joint_friction.effort).into();
            sheet.check_zero("the friction at the onset of motion", residual, size);
        });
    }

    /// Answers the final state of the motion.
    fn finish<W: Worksheet>(&self, problem: &Motion, sheet: W) -> Result<(), Refusal> {
        let last = self.moved.samples.last().expect("a motion has its start");
        let time = sheet.numerical(
            "t",
            "s",
            last.time,
            (
                Text::new("The equations of motion are integrated from the start by the Dormand–Prince method of order 8 with error-controlled steps; after each step the joint constraints are re-imposed"),
                HAIRER.at("§II.5"),
            ),
        );
        sheet.answer("time", "Time at the end", time);
        if self.moved.ended.is_none() && !matches!(problem.end, MechanismEvent::Nothing) {
            sheet.warn(|| {
                Text::new("the end condition of the motion is not reached within the duration; increase the duration")
            });
        }
        let PlanarState { positions, velocities, accelerations } = &last.state;
        let mut shown = last.state.clone();
        let most = |part: fn(&Snapshot) -> &[[f64; 3]]| {
            let turns = self.moved.samples.iter().flat_map(part).map(|of_body| of_body[2].abs());
            turns.fold(0.0, f64::max)
        };
        let turned = most(|moment| &moment.state.positions);
        let (fastest, quickest) =
            (most(|moment| &moment.state.velocities), most(|moment| &moment.state.accelerations));
        for (row, part) in (1..).zip(&self.parts.bodies) {
            let named = |reason: &'static str| Text::new(reason).with("name", &part.name);
            let body = row - 1;
            let angle = sheet.numerical(
                ("θ_e", row),
                "deg",
                self.without_error(positions[body][2], turned),
                named("Angle of {name} at the end"),
            );
            sheet.answer(("angle", row), "Angle of the body", angle);
            sheet.row_label(("angle", row), &part.name);
            let speed = sheet.numerical(
                ("ω_e", row),
                "rad/s",
                self.without_error(velocities[body][2], fastest),
                named("Angular velocity of {name} at the end"),
            );
            sheet.answer(("angular_velocity", row), "Angular velocity of the body", speed);
            sheet.row_label(("angular_velocity", row), &part.name);
            let acceleration = sheet.numerical(
                ("α_e", row),
                "rad/s^2",
                self.without_error(accelerations[body][2], quickest),
                named("Angular acceleration of {name} at the end"),
            );
            sheet.answer(("angular_acceleration", row), "Angular acceleration of the body", acceleration);
            sheet.row_label(("angular_acceleration", row), &part.name);
            for (of_bodies, number) in [
                (&mut shown.positions, angle),
                (&mut shown.velocities, speed),
                (&mut shown.accelerations, acceleration),
            ] {
                of_bodies[body][2] = number.value();
            }
        }
        let errors = [turned, fastest, quickest].map(|most| self.tolerance * most);
        sheet.verify(|| {
            let driving = closure::driving(self.system, &self.dynamics.multipliers);
            closure::check_pins(self.system, &shown, (errors, driving), sheet);
        });
        sheet.verify(|| self.check_time(time.value(), sheet));
        let (size, time) = (self.system.size(), problem.duration);
        for (row, followed) in (1..).zip(&problem.watched) {
            let name = &self.parts.points[followed.point.0].name;
            let [position, velocity, acceleration] =
                self.system.point(self.parts.point(followed.point), &last.state);
            let whole = [position, velocity, acceleration].map(|[x, y]| x.hypot(y));
            let vector = |[x, y]: [f64; 2], least: f64| {
                let clean = |part| self.without_error(part, f64::hypot(x, y).max(least));
                Vector3::new(clean(x), clean(y), 0.0)
            };
            let named = |reason: &'static str| Text::new(reason).with("name", name);
            let at = sheet.numerical_vector(
                ("r_P", row),
                "mm",
                vector(position, size),
                named("Position of {name}"),
            );
            sheet.answer_vector(("position", row), "Position of the point", at);
            sheet.row_label(("position", row), name);
            let velocity = sheet.numerical_vector(
                ("v_P", row),
                "m/s",
                vector(velocity, size / time),
                named("Velocity of {name}"),
            );
            sheet.answer_vector(("velocity", row), "Velocity of the point", velocity);
            sheet.row_label(("velocity", row), name);
            let acceleration = sheet.numerical_vector(
                ("a_P", row),
                "m/s^2",
                vector(acceleration, f64::max(size / (time * time), problem.gravity.norm())),
                named("Acceleration of {name}"),
            );
            sheet.answer_vector(("acceleration", row), "Acceleration of the point", acceleration);
            sheet.row_label(("acceleration", row), name);
            sheet.verify(|| {
                let least = [size, size / time, f64::max(size / (time * time), problem.gravity.norm())];
                let of_point =
                    [0, 1, 2].map(|n| self.tolerance * f64::max(whole[n], least[n]) + errors[n] * size);
                let shown_of_point = [at, velocity, acceleration].map(|of| [of.value().x, of.value().y]);
                let point = (self.parts.point(followed.point), name.as_str());
                closure::check_point(self.system, &shown, point, shown_of_point, of_point, sheet);
            });
        }
        let kinetic =
            sheet.numerical("T", "J", last.kinetic, "Kinetic energy at the end, T = Σ (m v² + I_G ω²)/2");
        sheet.answer("kinetic_energy", "Kinetic energy at the end", kinetic);
        self.balance(kinetic, sheet);
        // A second method to the accelerations at the end: the whole of the equations instead of their plan.
        let whole = self.system.forward_dynamics(positions, velocities);
        let refuse = |error: PlanarError| self.parts.refusal(&error, self.rows);
        let whole = whole.map_err(refuse)?;
        for joint_friction in &whole.frictions {
            self.sliding(joint_friction, &shown, sheet);
        }
        let whole = whole.state.accelerations;
        sheet.verify(|| {
            let size = whole.iter().flatten().fold(0.0f64, |most, a| most.max(a.abs()));
            for (ours, theirs) in shown.accelerations.iter().zip(&whole) {
                sheet.check_residual(
                    "the accelerations at the end from the equations of all bodies",
                    (ours[2] - theirs[2]).into(),
                    size,
                    errors[2],
                );
            }
        });
        Ok(())
    }

    /// Reaction of a joint on its second point at the start: along x and y, or along one line.
    fn carried(&self, row: usize) -> [Option<f64>; 2] {
        let [first, second, _] = carried(self.system, self.rows, row, &self.dynamics.multipliers, 1e-12);
        [first, second]
    }
}
