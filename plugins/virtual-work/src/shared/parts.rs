//! The parts that a mechanism is described with.

mod assembled;
pub(crate) mod closure;
pub(crate) mod drawing;
mod drivers;
mod letters;
mod pinned;
mod refusal;

use dalembert_core::{Inputs, Reference, Text};
use dalembert_mechanics::planar;
use nalgebra::Vector3;

pub(crate) use assembled::{Parts, carried, owners};
pub(crate) use drivers::{Drive, Driven, DrivenGiven};
pub(crate) use pinned::Point;

/// A rigid body, in axes of its own.
#[derive(Clone, Debug, Inputs)]
pub struct Part {
    /// Name.
    /// Without one, a body is called by its pins, as in A–B.
    #[input(default = "")]
    pub name: String,
    /// Pins.
    /// Points through which the body goes: at each it is pinned to the ground or to the other bodies that list the point.
    /// The origin of its axes is the first pin, and x points to the second.
    #[input(rows = "points")]
    pub pins: Vec<Reference>,
    /// Distances of the pins.
    /// AB for two pins; AB, BC and CA for three. Without them the distances are those of the given positions.
    #[input("L", "mm", positive)]
    pub sides: Vec<f64>,
    /// Mass.
    /// Zero for a body whose weight and inertia are neglected.
    #[input("m", "kg", nonnegative, default = "0 kg")]
    pub mass: f64,
    /// Moment of inertia about the centre of mass.
    #[input("I_G", "kg*m^2", nonnegative, default = "0 kg*m^2")]
    pub inertia: f64,
    /// Centre of mass, in the axes of the body.
    #[input("G", "mm", planar, default = "(0; 0) mm")]
    pub centre: Vector3<f64>,
    /// Initial guess of the angle.
    /// Selects the side on which a linkage is assembled; the joints correct the value. The positions of two pins replace it.
    #[input("θ_0", "deg", default = "0 deg")]
    pub angle: f64,
    /// Initial guess of the origin of its axes.
    /// Required where joints and drivers do not determine it, as for a weight at the end of a cord, and to select the
    /// side on which a slider is assembled.
    #[input("O", "mm", planar)]
    pub place: Option<Vector3<f64>>,
}

/// A named point of a body or of the ground, or a pin between bodies.
#[derive(Clone, Debug, Inputs)]
pub struct Spot {
    /// Name.
    pub name: String,
    /// Carried by.
    #[input(default = "pins")]
    pub on: Carrier,
    /// Position.
    /// In the axes of what carries it. That of a pin between bodies is a sketch, in the axes of the ground: it selects the side on which the linkage is
    /// assembled, and the lengths of bodies whose distances are not given.
    #[input("P", "mm", planar)]
    pub at: Vector3<f64>,
}

/// Carrier of a point.
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
    /// Pin between bodies
    /// The bodies that have it among their pins.
    Pins,
}

/// A part of a mechanism.
#[derive(Clone, Debug, Inputs)]
pub enum PartReference {
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
    /// Without one, a joint is called by its points.
    #[input(default = "")]
    pub name: String,
    /// Kind of joint.
    pub joint: Joint,
}

/// Joint between two parts.
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
        /// Direction of the guide, in the axes of its body.
        #[input("φ", "deg", default = "0 deg")]
        direction: f64,
        /// Point that slides along it.
        #[input(rows = "points")]
        slides: Reference,
        /// Angle of the sliding body relative to the body with the guide.
        #[input("β", "deg", default = "0 deg")]
        angle: f64,
    },
    /// Pin in a straight slot
    Slot {
        /// Point of the slot.
        #[input(rows = "points")]
        guide: Reference,
        /// Direction of the slot, in the axes of its body.
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
        /// Angle of the second body relative to the first.
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
        a: PartReference,
        /// Gear that it meshes with.
        b: PartReference,
        /// Body that carries both gears.
        #[input(default = "ground")]
        carrier: PartReference,
        /// Teeth or pitch radius of the first.
        #[input("z_a", "1", positive)]
        size_a: f64,
        /// Teeth or pitch radius of the second.
        #[input("z_b", "1", positive)]
        size_b: f64,
        /// The second has internal teeth.
        internal: bool,
    },
    /// Wheel that rolls on a line, or pinion on a rack
    Rolling {
        /// Point of the line.
        #[input(rows = "points")]
        guide: Reference,
        /// Direction of the line, in the axes of its body.
        #[input("φ", "deg", default = "0 deg")]
        direction: f64,
        /// Centre of the wheel, to the left of the line.
        #[input(rows = "points")]
        centre: Reference,
        /// Radius.
        #[input("r", "mm", positive)]
        radius: f64,
        /// The line alone supports the wheel at this distance.
        /// No for a pinion that has a bearing of its own.
        resting: bool,
    },
    /// Cord over pulleys and drums
    Cord {
        /// Straight runs.
        #[input(min = 1)]
        runs: Vec<CordRun>,
        /// Drums that wind the cord.
        drums: Vec<Drum>,
    },
    /// Cam: a rotating body that moves a point
    Cam {
        /// Cam body.
        #[input(rows = "bodies")]
        cam: Reference,
        /// Point of the guide of the follower.
        #[input(rows = "points")]
        guide: Reference,
        /// Direction of motion of the follower, in the axes of the body with the guide.
        #[input("φ", "deg", default = "90 deg")]
        direction: f64,
        /// Point of the follower.
        #[input(rows = "points")]
        follower: Reference,
        /// Lift against the cam angle, over one revolution.
        /// Periodic cubic spline through the rows.
        #[input(table)]
        lift: Vec<LiftPoint>,
    },
    /// Cam of a given contour, with a roller or a flat face on it
    Contour {
        /// Centre of the cam, on the body of the cam.
        #[input(rows = "points")]
        centre: Reference,
        /// Contour: radius against the angle in the axes of the cam, over one revolution.
        /// Periodic cubic spline through the rows.
        #[input(table)]
        contour: Vec<ContourPoint>,
        /// Follower.
        follower: Follower,
    },
    /// Geneva drive: an indexed wheel with dwell
    /// The radius of the pin's circle is the distance of the centres times sin(π/n).
    Geneva {
        /// Body that carries the pin.
        #[input(rows = "bodies")]
        driver: Reference,
        /// Geneva wheel.
        #[input(rows = "bodies")]
        wheel: Reference,
        /// Body that carries both.
        #[input(default = "ground")]
        carrier: PartReference,
        /// Number of slots.
        #[input(min = 3, max = 60)]
        slots: u32,
        /// Direction from the centre of the driver to that of the wheel, in the axes of the carrier.
        #[input("φ", "deg", default = "0 deg")]
        direction: f64,
        /// Angle of the pin, in the axes of the driver.
        #[input("β", "deg", default = "0 deg")]
        pin: f64,
    },
}

/// A point of the contour of a cam.
#[derive(Clone, Copy, Debug, Inputs)]
pub struct ContourPoint {
    /// Angle in the axes of the cam.
    #[input("θ", "deg")]
    pub angle: f64,
    /// Radius.
    #[input("r", "mm", positive)]
    pub radius: f64,
}

/// Follower of a cam.
#[derive(Clone, Debug, Inputs)]
pub enum Follower {
    /// Roller
    Roller {
        /// Centre of the roller.
        #[input(rows = "points")]
        centre: Reference,
        /// Radius of the roller.
        #[input("r_r", "mm", nonnegative)]
        radius: f64,
    },
    /// Flat face
    FlatFace {
        /// Point of the face.
        #[input(rows = "points")]
        point: Reference,
        /// Direction of the normal of the face away from the cam, in the axes of the follower.
        #[input("φ", "deg", default = "90 deg")]
        normal: f64,
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
pub struct CordRun {
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
    /// Rotating body.
    pub of: PartReference,
    /// Body relative to which it turns.
    #[input(default = "ground")]
    pub against: PartReference,
    /// Radius.
    /// Positive if a counter-clockwise rotation winds in the cord.
    #[input("r", "mm")]
    pub radius: f64,
}

/// A load, by its name.
#[derive(Clone, Debug, Inputs)]
pub struct NamedLoad {
    /// Name.
    /// Without one, a load is called by its point, its body or its points.
    #[input(default = "")]
    pub name: String,
    /// Kind of load.
    pub load: PartLoad,
}

/// Load on a mechanism.
#[derive(Clone, Debug, Inputs)]
pub enum PartLoad {
    /// Force at a point
    Force {
        /// Point.
        #[input(rows = "points")]
        at: Reference,
        /// Force.
        #[input("F", "N", planar)]
        force: Vector3<f64>,
        /// Body in whose axes it is given.
        #[input(default = "ground")]
        axes: PartReference,
    },
    /// Couple
    Couple {
        /// Body it acts on.
        on: PartReference,
        /// Body that takes the reaction.
        #[input(default = "ground")]
        against: PartReference,
        /// Moment.
        #[input("M", "N*m")]
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
        /// Rotating body.
        of: PartReference,
        /// Body relative to which it turns.
        against: PartReference,
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

impl PartReference {
    pub(crate) fn frame(&self) -> planar::BodyFrame {
        match self {
            PartReference::Ground => None,
            PartReference::Body { body } => Some(body.0),
        }
    }
}

/// A name that somebody gave, as it is.
pub(crate) fn verbatim(name: impl std::fmt::Display) -> Text {
    Text::new("{given_name}").with("given_name", name)
}
