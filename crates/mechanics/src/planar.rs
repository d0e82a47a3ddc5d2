//! Plane mechanisms of any shape: rigid bodies, joints, drivers and loads.
//!
//! The positions `q` of a mechanism are the origin and the angle `(x, y, θ)` of each body; the origin of a body is
//! its centre of mass. Joints and drivers are [equations](PlanarJoint) `Φ(q) = 0` between [measures](RelativeCoordinate), so that
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
//!
//! A [`Model`] is a mechanism compiled once and never changed; what is computed with it stands in results and in
//! working data. It answers:
//!
//! - positions: [`Model::initial_guess`], [`Model::assemble`], [`Model::continue_to`];
//! - velocities and accelerations: [`Model::kinematics`], [`Model::mobility`], [`Model::instant_centre`];
//! - inverse dynamics: [`Model::inverse_dynamics`], [`Model::force_on`], [`Model::shaking_force`]; many positions at
//!   once: [`Model::sweep`];
//! - equilibrium: [`Model::equilibria`], [`Model::stiffness`];
//! - forward dynamics: [`Model::forward_dynamics`], [`Model::simulate`].
//!
//! ```
//! use dalembert_mechanics::planar::{
//!     BodyPoint, Driver, Model, PlanarBody, PlanarJoint, PlanarMechanism, RelativeCoordinate,
//! };
//!
//! // A bar of 1 m and 3 kg, turned at 2 rad/s about a pin at its end.
//! let measure = RelativeCoordinate::Angle { of: Some(0), against: None };
//! let mechanism = PlanarMechanism {
//!     bodies: vec![PlanarBody { mass: 3.0, inertia: 0.25 }],
//!     joints: vec![PlanarJoint::Pin { a: BodyPoint::ground([0.0, 0.0]), b: BodyPoint::body(0, [-0.5, 0.0]) }],
//!     drivers: vec![Driver { measure, value: 0.0, velocity: 2.0, acceleration: 0.0 }],
//!     gravity: [0.0, -9.81],
//!     ..PlanarMechanism::default()
//! };
//! let guess = [[0.5, 0.0, 0.0]];
//! let model = Model::new(&mechanism, &guess)?;
//! let (state, dynamics) = model.kinetostatics(&model.assemble(&guess)?)?;
//! let [centripetal, _, _] = state.accelerations[0];
//! assert!((centripetal + 0.5 * 2.0 * 2.0).abs() < 1e-12);
//! assert!((dynamics.efforts[0] - 3.0 * 9.81 * 0.5).abs() < 1e-12);
//! # Ok::<(), dalembert_mechanics::planar::PlanarError>(())
//! ```

mod assembly;
mod continuation;
mod data;
mod elimination;
mod equation;
mod equations_of_motion;
mod equilibrium;
mod events;
mod forward_dynamics;
mod friction;
mod instant_centre;
mod inverse_dynamics;
mod kinematics;
mod layout;
mod load;
mod measure;
mod model;
mod profile;
mod reactions;
mod simulation;
mod sweep;
mod tolerances;
mod trajectory;
mod vectors;

pub use assembly::InitialGuess;
pub use continuation::{ChangePoint, Continuation};
pub use equation::{ConstraintTerm, Driver, Equation, PlanarJoint};
pub use equilibrium::{Equilibrium, Stability, StopPosition, SweepSample};
pub use events::Event;
pub use forward_dynamics::{ForwardDynamics, JointFriction};
pub use friction::Contact;
pub use instant_centre::InstantCentre;
pub use inverse_dynamics::{InverseDynamics, LoadId, LoadPower};
pub use kinematics::Mobility;
pub use load::{Effort, PlanarLoad};
pub use measure::{BodyFrame, BodyPoint, Gradient, Pose, RelativeCoordinate};
pub use model::{Model, PlanarState};
pub use profile::{GenevaWheel, Profile, TransmissionFunction};
pub use sweep::{Sweep, SweepResult};
pub use trajectory::{PlanarRun, Snapshot, Trajectory};

/// A plane mechanism.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct PlanarMechanism {
    /// The moving bodies; the ground is none of them.
    pub bodies: Vec<PlanarBody>,
    /// The constraints between them.
    pub joints: Vec<PlanarJoint>,
    /// The driving constraints: in kinematics one for each degree of freedom.
    pub drivers: Vec<Driver>,
    /// Forces, force elements and friction.
    pub loads: Vec<PlanarLoad>,
    /// Acceleration of gravity, m/s².
    pub gravity: [f64; 2],
}

/// A rigid body. Its origin is its centre of mass.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct PlanarBody {
    /// Mass, kg; zero for a body whose inertia is neglected.
    pub mass: f64,
    /// Moment of inertia about the centre of mass, kg m².
    pub inertia: f64,
}

/// The error of a mechanism without an answer. Bodies, joints, drivers and loads are counted from 0.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum PlanarError {
    /// A number is not finite, a mass or inertia is negative, or a length that must be positive is not.
    #[error(
        "{what} {index} has a number that it cannot have: every number must be finite and no mass negative"
    )]
    Number {
        /// Body, joint, driver or load.
        what: &'static str,
        /// The index of the body, joint, driver or load.
        index: usize,
    },
    /// A joint, driver or load refers to a body that does not exist.
    #[error("{what} {index} is attached to body {body}, but there are {bodies} bodies")]
    NoSuchBody {
        /// Joint, driver or load.
        what: &'static str,
        /// The index of the body, joint, driver or load.
        index: usize,
        /// The body that it refers to.
        body: usize,
        /// The number of bodies.
        bodies: usize,
    },
    /// The joints cannot all hold at once.
    #[error("the mechanism does not close: joint {joint} stays open by {residual}")]
    DoesNotClose {
        /// The equation with the largest residual: of this joint, or of the driver numbered after the joints.
        joint: usize,
        /// The residual, m or rad.
        residual: f64,
    },
    /// A degree of freedom has no driver.
    #[error("{free} degrees of freedom have no driver")]
    UnderDriven {
        /// The number of these.
        free: usize,
        /// True if Grübler's count of bodies and joints leaves no more than there are drivers: in this position alone
        /// the joints leave more.
        singular: bool,
    },
    /// A driver is not free to move: its measure follows from the joints or the other drivers already.
    #[error("driver {driver} is held already by the joints or by other drivers")]
    OverDriven {
        /// The driver.
        driver: usize,
    },
    /// A driver cannot go on: the mechanism has reached a limit position.
    #[error("driver {driver} cannot pass {at}: the mechanism has reached a limit position")]
    Limit {
        /// The driver.
        driver: usize,
        /// The last value of its measure that can be reached, m or rad.
        at: f64,
    },
    /// A driver is to move so far at once that its path cannot be followed.
    #[error("driver {driver} is to move too far at once; let it go in parts")]
    TooFar {
        /// The driver.
        driver: usize,
    },
    /// In this position the drivers do not determine the motion: a dead centre.
    #[error("driver {driver} cannot move the mechanism from this position, a dead centre")]
    DeadCentre {
        /// A driver at an input singularity.
        driver: usize,
    },
    /// Near the given position no equilibrium was found.
    #[error("no equilibrium was found near the drawn position")]
    NoEquilibrium,
    /// Friction grows faster than the force that drives against it: the mechanism is self-locking.
    #[error("the friction in joint {joint} finds no balance: the mechanism jams")]
    Jammed {
        /// A joint with friction.
        joint: usize,
    },
    /// A degree of freedom without a driver has no inertia: no acceleration balances its loads.
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
        /// The index of the body, joint, driver or load.
        index: usize,
    },
    /// So many joints with friction are at rest at once that the motions that could begin are too many to be tried.
    #[error(
        "load {load} is friction in one of so many joints at rest that what begins to move cannot be found"
    )]
    Sticks {
        /// One of these loads.
        load: usize,
    },
    /// A motion cannot be followed to its end.
    #[error(transparent)]
    Motion(#[from] dalembert_numerics::ode::OdeError),
    /// A number overflowed.
    #[error("a result is not finite")]
    NotFinite,
}

impl From<dalembert_numerics::linalg::LinalgError> for PlanarError {
    fn from(_: dalembert_numerics::linalg::LinalgError) -> Self {
        PlanarError::NotFinite
    }
}
