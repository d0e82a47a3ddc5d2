//! Drivers of a mechanism: measures and their motion.

use dalembert_core::{Inputs, Reference};

use super::PartReference;

/// Drive of a relative coordinate of the mechanism.
#[derive(Clone, Debug, Inputs)]
pub struct Drive {
    /// Name.
    /// Without one, a driver is called by its body or its points.
    #[input(default = "")]
    pub name: String,
    /// Driven coordinate.
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
        /// Body relative to which it turns.
        #[input(default = "ground")]
        against: PartReference,
        /// Angle.
        #[input("θ", "deg", kept_in = "drawn")]
        value: f64,
        /// Angle in the initial configuration.
        /// The drawn position fixes the gear meshing, the rolling of wheels, the cord lengths and the side on which a
        /// linkage is assembled; the mechanism moves from there. If omitted, the mechanism is drawn with the angle above.
        #[input("θ_d", "deg")]
        drawn: Option<f64>,
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
        /// Direction of measurement, in the axes of the body of the first point.
        #[input("φ_d", "deg", default = "0 deg")]
        direction: f64,
        /// Position.
        #[input("s", "mm", kept_in = "drawn")]
        value: f64,
        /// Position in the initial configuration.
        /// The mechanism is drawn with this value and moves from there. If omitted, it is drawn with the position above.
        #[input("s_d", "mm")]
        drawn: Option<f64>,
        /// Velocity.
        #[input("v", "m/s", default = "0 m/s")]
        velocity: f64,
        /// Acceleration.
        #[input("a", "m/s^2", default = "0 m/s^2")]
        acceleration: f64,
    },
    /// Distance between two points: a cylinder, a cord that is pulled
    Distance {
        /// From.
        #[input(rows = "points")]
        from: Reference,
        /// To.
        #[input(rows = "points")]
        to: Reference,
        /// Distance.
        #[input("s", "mm", positive, kept_in = "drawn")]
        value: f64,
        /// Distance in the initial configuration.
        /// The mechanism is drawn with this value and moves from there. If omitted, it is drawn with the distance above.
        #[input("s_d", "mm", positive)]
        drawn: Option<f64>,
        /// Velocity.
        #[input("v", "m/s", default = "0 m/s")]
        velocity: f64,
        /// Acceleration.
        #[input("a", "m/s^2", default = "0 m/s^2")]
        acceleration: f64,
    },
}

impl Driven {
    /// The value of the measure.
    pub(crate) fn value(&self) -> f64 {
        match *self {
            Driven::Angle { value, .. } | Driven::Position { value, .. } | Driven::Distance { value, .. } => {
                value
            }
        }
    }

    /// The unit of the measure.
    pub(crate) fn unit(&self) -> &'static str {
        match self {
            Driven::Angle { .. } => "deg",
            Driven::Position { .. } | Driven::Distance { .. } => "mm",
        }
    }

    /// The path of its value, from the driver on.
    pub(crate) fn path(&self) -> &'static str {
        match self {
            Driven::Angle { .. } => "what.angle.value",
            Driven::Position { .. } => "what.position.value",
            Driven::Distance { .. } => "what.distance.value",
        }
    }

    /// Value in the initial configuration.
    pub(crate) fn drawn(&self) -> f64 {
        match *self {
            Driven::Angle { drawn, .. } | Driven::Position { drawn, .. } | Driven::Distance { drawn, .. } => {
                drawn.unwrap_or_else(|| self.value())
            }
        }
    }
}
