//! Plane mechanisms of any shape: rigid bodies, joints, drivers and loads.
//!
//! The positions `q` of a mechanism are the origin and the angle `(x, y, θ)` of each body; the origin of a body is
//! its centre of mass. Joints and drivers are [equations](Joint) `Φ(q) = 0` between [measures](Measure), so that
//!
//! - positions satisfy `Φ(q, t) = 0`, velocities `Φ_q q̇ = −Φ_t`, accelerations `Φ_q q̈ = γ`;
//! - motion and forces satisfy `M q̈ = Q + Φ_qᵀ λ` (Newton and Euler), where the multiplier `λ` of an equation is the
//!   effort that the joint or driver exerts along its measure: a force along a length, a couple about an angle,
//!   positive when it pushes the measure to grow;
//! - for virtual velocities `δq` that the joints allow, `δqᵀ (Q − M q̈) + Σ T δm = 0` over the drivers (virtual
//!   power), which gives the driving efforts `T` without any reaction.
//!
//! P. E. Nikravesh, *Computer-Aided Analysis of Mechanical Systems* (1988), ch. 4, 6 and 8; E. J. Haug,
//! *Computer-Aided Kinematics and Dynamics of Mechanical Systems* (1989), ch. 3 and 6.

mod balance;
mod centre;
mod continuation;
mod equation;
mod equilibrium;
mod forward_dynamics;
mod friction;
mod load;
mod machine;
mod measure;
mod plan;
mod reaction;
mod simulate;
mod sweep;
mod system;
mod vectors;

pub use balance::{Dynamics, LoadId, LoadPower};
pub use centre::InstantCentre;
pub use continuation::{ChangePoint, Continuation};
pub use equation::{Driver, Equation, Joint, Profile, Term};
pub use equilibrium::{Equilibrium, Sample, Stability};
pub use forward_dynamics::{ForwardDynamics, JointFriction};
pub use friction::Contact;
pub use load::{Effort, Load};
pub use measure::{Frame, Gradient, Measure, Point, Pose};
pub use simulate::{End, Run, Snapshot, Trajectory};
pub use sweep::{Sweep, SweepResult};
pub use system::{Mobility, Placed, State, System};

/// A plane mechanism.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Mechanism {
    /// The moving bodies; the ground is none of them.
    pub bodies: Vec<Body>,
    /// Joints between the bodies.
    pub joints: Vec<Joint>,
    /// Drivers, one for each degree of freedom.
    pub drivers: Vec<Driver>,
    /// Loads besides the weights.
    pub loads: Vec<Load>,
    /// Acceleration of gravity, m/s².
    pub gravity: [f64; 2],
}

/// A rigid body. Its origin is its centre of mass.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Body {
    /// Mass, kg; zero for one whose inertia does not count.
    pub mass: f64,
    /// Moment of inertia about the centre of mass, kg m².
    pub inertia: f64,
}

/// Reason for which a mechanism has no answer. Bodies, joints, drivers and loads are counted from 0.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum PlanarError {
    /// A number is not finite, a mass or inertia is negative, or a length that must be positive is not.
    #[error(
        "{what} {index} has a number that it cannot have: every number must be finite and no mass negative"
    )]
    Number {
        /// Body, joint, driver or load.
        what: &'static str,
        /// Index of the joint, driver or load.
        index: usize,
    },
    /// A joint, driver or load names a body that there is not.
    #[error("{what} {index} is attached to body {body}, but there are {bodies} bodies")]
    NoSuchBody {
        /// Joint, driver or load.
        what: &'static str,
        /// Index of the joint, driver or load.
        index: usize,
        /// The body that it names.
        body: usize,
        /// Number of bodies.
        bodies: usize,
    },
    /// The joints cannot all hold at once.
    #[error("the mechanism does not close: joint {joint} stays open by {residual}")]
    DoesNotClose {
        /// The equation with the largest residual: of this joint, or of the driver numbered after the joints.
        joint: usize,
        /// Residual of the constraint, m or rad.
        residual: f64,
    },
    /// Some freedom has no driver.
    #[error("{free} degrees of freedom have no driver")]
    UnderDriven {
        /// Number of remaining degrees of freedom.
        free: usize,
        /// True if Grübler's count of bodies and joints leaves no more than there are drivers: in this position alone
        /// the joints leave more.
        singular: bool,
    },
    /// A driver is not free to move: the joints or the other drivers hold it already.
    #[error("driver {driver} is held already by the joints or by other drivers")]
    OverDriven {
        /// Index of the driver.
        driver: usize,
    },
    /// A driver cannot go on: the mechanism has reached a limit position.
    #[error("driver {driver} cannot pass {at}: the mechanism has reached a limit position")]
    Limit {
        /// Index of the driver.
        driver: usize,
        /// The last value of its measure that can be reached, m or rad.
        at: f64,
    },
    /// A driver is to move so far at once that its way cannot be followed.
    #[error("driver {driver} is to move too far at once; let it go in parts")]
    TooFar {
        /// Index of the driver.
        driver: usize,
    },
    /// In this position the drivers do not determine the motion: a dead centre.
    #[error("driver {driver} cannot move the mechanism from this position, a dead centre")]
    DeadCentre {
        /// A driver that has lost its hold.
        driver: usize,
    },
    /// No position near the drawn one needs no effort.
    #[error("no equilibrium was found near the drawn position")]
    NoEquilibrium,
    /// Friction grows faster than what drives against it: the mechanism locks itself.
    #[error("the friction in joint {joint} finds no balance: the mechanism jams")]
    Jammed {
        /// A joint with friction.
        joint: usize,
    },
    /// A freedom that nothing drives has no inertia: no acceleration balances its loads.
    #[error(
        "body {body} can move freely, but nothing that moves with it has a mass; give it one, or drive it"
    )]
    Massless {
        /// The body that moves most.
        body: usize,
    },
    /// A given velocity contradicts the joints or those given before it.
    #[error("velocity {index} follows from the joints, the drivers and the velocities before it already")]
    Rate {
        /// Index of the joint, driver or load.
        index: usize,
    },
    /// So many joints with friction rest at once that the ways to begin a motion are too many to be tried.
    #[error(
        "load {load} is friction in one of so many joints at rest that what begins to move cannot be found"
    )]
    Sticks {
        /// One of them.
        load: usize,
    },
    /// A motion cannot be followed to its end.
    #[error(transparent)]
    Motion(#[from] dalembert_numerics::ode::OdeError),
    /// A number overflowed on the way.
    #[error("a result is not finite")]
    NotFinite,
}

impl From<dalembert_numerics::linalg::LinalgError> for PlanarError {
    fn from(_: dalembert_numerics::linalg::LinalgError) -> Self {
        PlanarError::NotFinite
    }
}
