//! The one unknown torque or force of a plane mechanism with known motion, from the sum of all powers.

mod slider_crank;

use dalembert_core::{
    About, Analysis, Cite, Exhibit, Inputs, Reason, Reference, Refusal, TableExhibit, Text, Worksheet,
    exhibit::{Cell, Column},
    register,
};
use dalembert_mechanics::{Real, Vector, work};
use nalgebra::Vector3;

pub use slider_crank::{Geometry, GeometryGiven, GivenSliderCrank, GivenSliderCrankGiven};

use crate::sources::{BEER, RIUL, SHIGLEY};

/// A plane mechanism with one degree of freedom, its motion at one moment, and its loads.
///
/// Vectors have components along x and y; couples and rotations are positive counter-clockwise. For a problem of
/// statics, virtual displacements may stand in place of velocities: only their ratios matter.
#[derive(Clone, Debug, Inputs)]
pub struct VirtualPower {
    /// Find.
    pub unknown: PowerUnknown,
    /// Acceleration of gravity.
    /// Every body has the weight m g at its centre of mass; zero for a mechanism in a horizontal plane.
    #[input("g", "m/s^2", planar, default = "(0; -9.81) m/s^2")]
    pub gravity: Vector3<f64>,
    /// Bodies.
    pub bodies: Vec<MovingBody>,
    /// Forces.
    pub forces: Vec<Force>,
    /// Couples.
    pub couples: Vec<Couple>,
    /// The mechanism is a slider-crank.
    /// The given motion is then checked against loop closure.
    pub slider_crank: Option<GivenSliderCrank>,
}

/// Unknown of the sum of virtual powers.
#[derive(Clone, Debug, Inputs)]
pub enum PowerUnknown {
    /// Driving torque on a link
    DrivingTorque {
        /// Link it acts on.
        link: RotatingLink,
    },
    /// Driving force at a point
    DrivingForce {
        /// Direction of the force.
        /// Any vector along its line; the force is positive in this direction.
        #[input("e", "1", planar)]
        direction: Vector3<f64>,
        /// Point that it acts on.
        point: MovingPoint,
    },
}

/// A link, by its rotation.
#[derive(Clone, Debug, Inputs)]
pub enum RotatingLink {
    /// Rotating at
    Turning {
        /// Angular velocity of the link.
        #[input("ω_T", "rad/s")]
        speed: f64,
    },
    /// One of the bodies
    Body {
        /// Body.
        #[input(rows = "bodies")]
        body: Reference,
    },
}

/// A point, by its velocity.
#[derive(Clone, Debug, Inputs)]
pub enum MovingPoint {
    /// Moving at
    Moving {
        /// Velocity of the point.
        #[input("V", "m/s", planar)]
        velocity: Vector3<f64>,
    },
    /// Centre of mass of a body
    MassCentre {
        /// Body.
        #[input(rows = "bodies")]
        body: Reference,
    },
}

/// A rigid body and its motion.
#[derive(Clone, Debug, Inputs)]
pub struct MovingBody {
    /// Name.
    pub name: String,
    /// Mass.
    #[input("m", "kg", nonnegative)]
    pub mass: f64,
    /// Moment of inertia about the centre of mass.
    #[input("I_G", "kg*m^2", nonnegative, default = "0 kg*m^2")]
    pub inertia: f64,
    /// Velocity of the centre of mass.
    #[input("V_G", "m/s", planar)]
    pub velocity: Vector3<f64>,
    /// Acceleration of the centre of mass.
    #[input("a_G", "m/s^2", planar, default = "(0; 0) m/s^2")]
    pub acceleration: Vector3<f64>,
    /// Angular velocity.
    #[input("ω", "rad/s", default = "0 rad/s")]
    pub angular_velocity: f64,
    /// Angular acceleration.
    #[input("α", "rad/s^2", default = "0 rad/s^2")]
    pub angular_acceleration: f64,
}

/// A force and where it acts.
#[derive(Clone, Debug, Inputs)]
pub struct Force {
    /// Name.
    pub name: String,
    /// Force.
    #[input("F", "N", planar)]
    pub force: Vector3<f64>,
    /// Point that it acts on.
    pub point: MovingPoint,
}

/// A couple and the link that it acts on.
#[derive(Clone, Debug, Inputs)]
pub struct Couple {
    /// Name.
    pub name: String,
    /// Moment.
    #[input("T", "N*m")]
    pub moment: f64,
    /// Link it acts on.
    pub link: RotatingLink,
}

register!(VirtualPower);

impl Analysis for VirtualPower {
    const ABOUT: About = About {
        id: "virtual-work/virtual-power",
        title: "Virtual power",
        topic: "Any mechanism",
        summary: "Driving torque or force of a plane mechanism with known motion, from the powers of forces, couples, weights and inertia loads.",
        main: &["torque", "force"],
        keywords: "virtual work trabalho virtual potência d'Alembert slider-crank biela manivela cursor torque linkage lever exemplo 1",
        sources: &[&RIUL, &SHIGLEY, &BEER],
        cases: include_str!("../../cases/virtual_power.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &VirtualPowerGiven<W>, sheet: W) -> Result<(), Refusal> {
        let loads = self.powers(given, sheet);
        if loads.is_empty() {
            return Err(Refusal::because(
                "no load is given: write down a force, a couple, or a body with a mass",
            ));
        }
        let sums = sums_by_kind(&loads, sheet);
        let total = match sums[..] {
            [(_, only)] => only,
            _ => sheet.step(
                "ΣP",
                "W",
                Real::sum(sums.iter().map(|(_, sum)| *sum)),
                ("Power of all known loads", RIUL.at("eq. 5")),
            ),
        };
        let (load, rate) = self.unknown_load(given, total, sheet)?;
        match self.unknown {
            PowerUnknown::DrivingTorque { .. } => sheet.answer("torque", "Driving torque", load),
            PowerUnknown::DrivingForce { .. } => sheet.answer("force", "Driving force", load),
        }
        for (kind, sum) in &sums {
            let (name, label) = kind.answer();
            sheet.answer(name, label, *sum);
        }
        sheet.answer("total_power", "Power of all known loads", total);
        if let (Some(mechanism), Some(given_mechanism)) = (&self.slider_crank, &given.slider_crank) {
            let inertia_force_of = |body: Reference| {
                loads.iter().find(|load| load.kind == Kind::InertiaForce && load.row == body.0)
            };
            if let Some(load) = inertia_force_of(mechanism.rod) {
                sheet.answer("rod_inertia_force_power", "Power of the inertia force of the rod", load.power);
            }
            if let Some(load) = inertia_force_of(mechanism.slider) {
                let label = "Power of the inertia force of the slider";
                sheet.answer("slider_inertia_force_power", label, load.power);
            }
            sheet.verify(|| {
                slider_crank::hold_against_closure(self, given, mechanism, given_mechanism, sheet);
            });
        }
        sheet.verify(|| self.check_by_kinetic_energy(given, load * rate, &loads, sheet));
        let unknown = load.value() * rate.value();
        sheet.show(|| Exhibit::Table(self.table_of_powers(&loads, unknown)));
        Ok(())
    }
}

/// The power of one load.
struct Load<N> {
    kind: Kind,
    /// The row of the force, couple or body, counted from 0.
    row: usize,
    power: N,
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Kind {
    Force,
    Couple,
    Weight,
    InertiaForce,
    InertiaCouple,
}

/// A reason that names a load; written only where somebody reads it.
struct Named<'a>(&'static str, &'a str, Cite);

impl From<Named<'_>> for Reason {
    fn from(Named(reason, name, cite): Named<'_>) -> Self {
        Reason { reason: Text::new(reason).with("name", name), cite: Some(cite) }
    }
}

impl Kind {
    const ALL: [Kind; 5] = [Kind::Force, Kind::Couple, Kind::Weight, Kind::InertiaForce, Kind::InertiaCouple];

    /// The symbol of the sum of powers of this kind, and what it is.
    fn sum(self) -> (&'static str, &'static str) {
        match self {
            Kind::Force => ("ΣP_F", "Power of the forces"),
            Kind::Couple => ("ΣP_T", "Power of the couples"),
            Kind::Weight => ("ΣP_W", "Power of the weights"),
            Kind::InertiaForce => ("ΣP_Fi", "Power of the inertia forces"),
            Kind::InertiaCouple => ("ΣP_Ti", "Power of the inertia couples"),
        }
    }

    /// The name and the label of the answer.
    fn answer(self) -> (&'static str, &'static str) {
        let name = match self {
            Kind::Force => "force_power",
            Kind::Couple => "couple_power",
            Kind::Weight => "weight_power",
            Kind::InertiaForce => "inertia_force_power",
            Kind::InertiaCouple => "inertia_couple_power",
        };
        (name, self.sum().1)
    }
}

/// The sum of the powers of each kind that there is.
fn sums_by_kind<W: Worksheet>(loads: &[Load<W::Num>], sheet: W) -> Vec<(Kind, W::Num)> {
    let sum = |kind: Kind| {
        let powers: Vec<W::Num> =
            loads.iter().filter(|load| load.kind == kind).map(|load| load.power).collect();
        let (symbol, reason) = kind.sum();
        match powers[..] {
            [] => None,
            [only] => Some((kind, only)),
            _ => Some((kind, sheet.step(symbol, "W", Real::sum(powers), reason))),
        }
    };
    Kind::ALL.into_iter().filter_map(sum).collect()
}

impl VirtualPower {
    /// Writes down the power of every known load.
    fn powers<W: Worksheet>(&self, given: &VirtualPowerGiven<W>, sheet: W) -> Vec<Load<W::Num>> {
        let mut loads = Vec::new();
        for (row, (force, this)) in self.forces.iter().zip(&given.forces).enumerate() {
            let velocity = velocity_of(&force.point, &this.point, &given.bodies);
            sheet.common_error(
                ("P_F", row + 1),
                "the magnitudes of force and velocity multiplied, without the angle between them",
                || this.force.magnitude() * velocity.magnitude(),
            );
            let power = sheet.step(
                ("P_F", row + 1),
                "W",
                work::force_power(this.force, velocity),
                Named("Power of the force {name}", &force.name, RIUL.at("eqs. 1, 5")),
            );
            loads.push(Load { kind: Kind::Force, row, power });
        }
        for (row, (couple, this)) in self.couples.iter().zip(&given.couples).enumerate() {
            let power = sheet.step(
                ("P_T", row + 1),
                "W",
                this.moment * speed_of(&couple.link, &this.link, &given.bodies),
                Named("Power of the couple {name}", &couple.name, RIUL.at("eq. 5")),
            );
            loads.push(Load { kind: Kind::Couple, row, power });
        }
        for (row, (body, this)) in self.bodies.iter().zip(&given.bodies).enumerate() {
            if body.mass != 0.0 && self.gravity != Vector3::zeros() {
                let weight = sheet.step_vector(
                    ("W", row + 1),
                    "N",
                    work::weight(this.mass, given.gravity),
                    Named("Weight of {name}", &body.name, RIUL.at("example 1")),
                );
                sheet.common_error(
                    ("P_W", row + 1),
                    "the whole speed used for the weight, not its vertical part",
                    || weight.magnitude() * this.velocity.magnitude(),
                );
                let power = sheet.step(
                    ("P_W", row + 1),
                    "W",
                    work::force_power(weight, this.velocity),
                    Named("Power of the weight of {name}", &body.name, RIUL.at("eq. 5")),
                );
                loads.push(Load { kind: Kind::Weight, row, power });
            }
            if body.mass != 0.0 {
                let force = sheet.step_vector(
                    ("F_in", row + 1),
                    "N",
                    work::inertia_force(this.mass, this.acceleration),
                    Named(
                        "Inertia force of {name}, opposite to the acceleration",
                        &body.name,
                        RIUL.at("eq. 5"),
                    ),
                );
                let power = sheet.step(
                    ("P_Fi", row + 1),
                    "W",
                    work::force_power(force, this.velocity),
                    Named("Power of the inertia force of {name}", &body.name, RIUL.at("eq. 5")),
                );
                loads.push(Load { kind: Kind::InertiaForce, row, power });
            }
            if body.inertia != 0.0 {
                let couple = sheet.step(
                    ("T_in", row + 1),
                    "N*m",
                    -(this.inertia * this.angular_acceleration),
                    Named(
                        "Inertia couple of {name}, opposite to the angular acceleration",
                        &body.name,
                        RIUL.at("eq. 5"),
                    ),
                );
                let power = sheet.step(
                    ("P_Ti", row + 1),
                    "W",
                    couple * this.angular_velocity,
                    Named("Power of the inertia couple of {name}", &body.name, RIUL.at("eq. 5")),
                );
                loads.push(Load { kind: Kind::InertiaCouple, row, power });
            }
        }
        loads
    }

    /// The unknown load that brings the sum of the powers to zero, and the velocity along its line.
    fn unknown_load<W: Worksheet>(
        &self,
        given: &VirtualPowerGiven<W>,
        total: W::Num,
        sheet: W,
    ) -> Result<(W::Num, W::Num), Refusal> {
        match (&self.unknown, &given.unknown) {
            (PowerUnknown::DrivingTorque { link }, PowerUnknownGiven::DrivingTorque { link: given_link }) => {
                let speed = speed_of(link, given_link, &given.bodies);
                if speed.value() == 0.0 {
                    return Err(Refusal::because(
                        "the driven link is at rest: its torque has no power, so the sum of powers cannot determine it",
                    ));
                }
                let torque = sheet.step(
                    "T",
                    "N*m",
                    work::unknown_load([total], speed),
                    ("Driving torque, from the principle of virtual power, T ω_T + ΣP = 0", RIUL.at("eq. 5")),
                );
                Ok((torque, speed))
            }
            (
                PowerUnknown::DrivingForce { direction, point },
                PowerUnknownGiven::DrivingForce { direction: given_direction, point: given_point },
            ) => {
                let velocity = velocity_of(point, given_point, &given.bodies);
                if velocity.value() == Vector3::zeros() {
                    return Err(Refusal::because(
                        "the driven point is at rest: its force has no power, so the sum of powers cannot determine it",
                    ));
                }
                if *direction == Vector3::zeros() {
                    return Err(Refusal::because(
                        "the direction of the driving force has no length: write any vector along its line, such as (1; 0)",
                    ));
                }
                let unit = sheet.step_vector(
                    "ê",
                    "1",
                    *given_direction / given_direction.magnitude(),
                    "Unit vector along the driving force",
                );
                sheet.common_error(
                    "v",
                    "the whole speed of the point used, not its part along the force",
                    || velocity.magnitude(),
                );
                let rate = sheet.step(
                    "v",
                    "m/s",
                    unit.dot(velocity),
                    "Velocity of its point along the driving force",
                );
                // Rounding leaves a trace of a right angle between vectors that were typed with a few digits.
                if rate.value().abs() <= 1e-12 * velocity.value().norm() {
                    return Err(Refusal::because(
                        "the driving force is perpendicular to the velocity of its point: it has no power, so the sum of powers cannot determine it",
                    ));
                }
                let force = sheet.step(
                    "F",
                    "N",
                    work::unknown_load([total], rate),
                    ("Driving force, from the principle of virtual power, F v + ΣP = 0", RIUL.at("eq. 5")),
                );
                Ok((force, rate))
            }
            _ => unreachable!("the given numbers are those of this problem"),
        }
    }

    /// A second method: the power that all applied loads bring in, summed by components, is the rate of the kinetic
    /// energy, `dT/dt = Σ (m a_G · V_G + I_G α ω)`.
    fn check_by_kinetic_energy<W: Worksheet>(
        &self,
        given: &VirtualPowerGiven<W>,
        unknown: W::Num,
        loads: &[Load<W::Num>],
        sheet: W,
    ) {
        let product = |a: W::Vec, b: W::Vec| {
            let ([ax, ay, _], [bx, by, _]) = (a.components(), b.components());
            ax * bx + ay * by
        };
        let mut applied = vec![unknown];
        for (force, this) in self.forces.iter().zip(&given.forces) {
            applied.push(product(this.force, velocity_of(&force.point, &this.point, &given.bodies)));
        }
        for (couple, this) in self.couples.iter().zip(&given.couples) {
            applied.push(this.moment * speed_of(&couple.link, &this.link, &given.bodies));
        }
        let mut energy = Vec::new();
        for this in &given.bodies {
            applied.push(this.mass * product(given.gravity, this.velocity));
            energy.push(this.mass * product(this.acceleration, this.velocity));
            energy.push(this.inertia * this.angular_acceleration * this.angular_velocity);
        }
        let largest = loads.iter().fold(0.0f64, |most, load| most.max(load.power.value().abs()));
        let rate = if energy.is_empty() { W::Num::from(0.0) } else { Real::sum(energy) };
        sheet.check_zero(
            "the power of all applied loads equals the rate of change of the kinetic energy",
            <W::Num as Real>::sum(applied) - rate,
            largest,
        );
    }

    /// Every load with its power, and its share of all the power that is brought in.
    fn table_of_powers<N: Real>(&self, loads: &[Load<N>], unknown: f64) -> TableExhibit {
        let powers = || loads.iter().map(|load| load.power.value()).chain([unknown]);
        let (sum, brought_in) = (powers().sum::<f64>(), powers().filter(|power| *power > 0.0).sum::<f64>());
        let share =
            |power: f64| if brought_in > 0.0 { Cell::Number(power / brought_in) } else { Cell::Empty };
        let row = |name: Text, power: f64| vec![Cell::Text(name), Cell::Number(power), share(power)];
        let known = loads.iter().map(|load| row(self.name_of(load.kind, load.row), load.power.value()));
        let driving = match self.unknown {
            PowerUnknown::DrivingTorque { .. } => Text::from("Driving torque"),
            PowerUnknown::DrivingForce { .. } => Text::from("Driving force"),
        };
        TableExhibit {
            title: "Powers of the loads".into(),
            columns: vec![
                Column { heading: "Load".into(), unit: "" },
                Column { heading: "Power".into(), unit: "W" },
                Column { heading: "Share of the power input".into(), unit: "%" },
            ],
            rows: known.chain([row(driving, unknown)]).collect(),
            foot: vec![
                Cell::Text("Total".into()),
                Cell::Number(if sum.abs() > 1e-12 * brought_in { sum } else { 0.0 }),
                Cell::Empty,
            ],
        }
    }

    fn name_of(&self, kind: Kind, row: usize) -> Text {
        let (words, name) = match kind {
            Kind::Force => (Text::new("Force {name}"), &self.forces[row].name),
            Kind::Couple => (Text::new("Couple {name}"), &self.couples[row].name),
            Kind::Weight => (Text::new("Weight of {name}"), &self.bodies[row].name),
            Kind::InertiaForce => (Text::new("Inertia force of {name}"), &self.bodies[row].name),
            Kind::InertiaCouple => (Text::new("Inertia couple of {name}"), &self.bodies[row].name),
        };
        words.with("name", name)
    }
}

fn velocity_of<W: Worksheet>(
    point: &MovingPoint,
    given: &MovingPointGiven<W>,
    bodies: &[MovingBodyGiven<W>],
) -> W::Vec {
    match (point, given) {
        (_, MovingPointGiven::Moving { velocity }) => *velocity,
        (MovingPoint::MassCentre { body }, MovingPointGiven::MassCentre {}) => bodies[body.0].velocity,
        _ => unreachable!("the given numbers are those of this point"),
    }
}

fn speed_of<W: Worksheet>(
    link: &RotatingLink,
    given: &RotatingLinkGiven<W>,
    bodies: &[MovingBodyGiven<W>],
) -> W::Num {
    match (link, given) {
        (_, RotatingLinkGiven::Turning { speed }) => *speed,
        (RotatingLink::Body { body }, RotatingLinkGiven::Body {}) => bodies[body.0].angular_velocity,
        _ => unreachable!("the given numbers are those of this link"),
    }
}
