//! Bodies about an axis, and their motions before and after.

use dalembert_core::{Inputs, Worksheet};
use dalembert_mechanics::{Real, rigid};

use super::{After, Before};
use crate::shared::{common_errors, joints::Named};

/// A body about the axis.
#[derive(Clone, Debug, Inputs)]
pub enum AxisInertia {
    /// Moment of inertia
    MomentOfInertia {
        /// Moment of inertia about the axis.
        #[input("I", "kg*m^2", positive)]
        inertia: f64,
    },
    /// Disc
    /// A solid cylinder, too.
    Disc {
        /// Mass.
        #[input("m", "kg", positive)]
        mass: f64,
        /// Radius.
        #[input("r", "m", positive)]
        radius: f64,
    },
    /// Radius of gyration
    RadiusOfGyration {
        /// Mass.
        #[input("m", "kg", positive)]
        mass: f64,
        /// Radius of gyration about the axis.
        #[input("k", "m", positive)]
        gyration: f64,
    },
    /// Particle
    /// A person, a bob: its own inertia is neglected.
    Particle {
        /// Mass.
        #[input("m", "kg", positive)]
        mass: f64,
        /// Distance from the axis.
        #[input("r", "m", nonnegative)]
        distance: f64,
    },
    /// Body beside the axis
    /// With the parallel-axis theorem.
    Beside {
        /// Moment of inertia about its own parallel axis.
        #[input("I_G", "kg*m^2", positive)]
        inertia: f64,
        /// Mass.
        #[input("m", "kg", positive)]
        mass: f64,
        /// Distance of G from the axis.
        #[input("r", "m", nonnegative)]
        distance: f64,
    },
}

impl AxisInertia {
    /// The letters of what is given.
    pub(super) fn letters(&self) -> &'static [&'static str] {
        match self {
            AxisInertia::MomentOfInertia { .. } => &["I"],
            AxisInertia::Disc { .. } | AxisInertia::Particle { .. } => &["m", "r"],
            AxisInertia::RadiusOfGyration { .. } => &["m", "k"],
            AxisInertia::Beside { .. } => &["I_G", "m", "r"],
        }
    }
}

/// Motion of a body before.
#[derive(Clone, Debug, Inputs)]
pub enum MotionBefore {
    /// It turns about the axis
    Turns {
        /// Body.
        body: AxisInertia,
        /// Angular velocity.
        #[input("ω_0", "rad/s")]
        speed: f64,
    },
    /// It moves in a straight line
    Straight {
        /// Mass.
        #[input("m", "kg", positive)]
        mass: f64,
        /// Speed.
        /// Negative where it passes the axis in the negative sense.
        #[input("v_0", "m/s")]
        speed: f64,
        /// Distance of its path from the axis.
        #[input("b", "m", positive)]
        distance: f64,
    },
}

/// Motion of a body after.
#[derive(Clone, Debug, Inputs)]
pub enum MotionAfter {
    /// Joined, as it is
    /// It turns with the common angular velocity; what came in a straight line, at the distance of its path.
    Joined,
    /// Joined, in another place or shape
    Changed {
        /// Body after.
        #[input("1")]
        body: AxisInertia,
    },
    /// It turns relative to the others
    /// A person who walks, a wheel that is driven.
    Relative {
        /// Body after.
        #[input("1")]
        body: AxisInertia,
        /// Relative angular velocity.
        #[input("ω_r", "rad/s")]
        relative: f64,
    },
    /// It turns at a given angular velocity
    Given {
        /// Body after.
        #[input("1")]
        body: AxisInertia,
        /// Angular velocity.
        #[input("ω_1", "rad/s")]
        speed: f64,
    },
    /// It leaves in a straight line
    Leaves {
        /// Mass.
        #[input("m_1", "kg", positive)]
        mass: f64,
        /// Speed.
        #[input("v_1", "m/s")]
        speed: f64,
        /// Distance of its path from the axis.
        #[input("b_1", "m", nonnegative)]
        distance: f64,
    },
}

impl<W: Worksheet> AxisInertiaGiven<W> {
    fn inertia(&self, symbol: &'static str, name: &str, n: usize, sheet: W) -> W::Num {
        let symbol = (symbol, n + 1);
        match *self {
            AxisInertiaGiven::Disc { mass, radius } => common_errors::of_disc(symbol, mass, radius, sheet),
            AxisInertiaGiven::RadiusOfGyration { mass, gyration } => {
                sheet.common_error(symbol, common_errors::AS_DISC, || {
                    rigid::disc_axial_inertia(mass, gyration)
                });
            }
            _ => {}
        }
        let value = match *self {
            AxisInertiaGiven::MomentOfInertia { inertia } => return inertia,
            AxisInertiaGiven::Disc { mass, radius } => rigid::disc_axial_inertia(mass, radius),
            AxisInertiaGiven::RadiusOfGyration { mass, gyration } => mass * gyration.powi(2),
            AxisInertiaGiven::Particle { mass, distance } => mass * distance.powi(2),
            AxisInertiaGiven::Beside { inertia, mass, distance } => inertia + mass * distance.powi(2),
        };
        let reason = Named("Moment of inertia of {name} about the axis", name, None);
        sheet.step(symbol, "kg*m^2", value, reason)
    }
}

impl<W: Worksheet> MotionBeforeGiven<W> {
    /// The motion, and the moment of inertia that the body keeps.
    pub(super) fn work(
        &self,
        momentum: impl Fn(W::Num) -> W::Num,
        name: &str,
        n: usize,
        sheet: W,
    ) -> (Before<W::Num>, Kept<W::Num>) {
        match self {
            MotionBeforeGiven::Turns { body, speed } => {
                let inertia = body.inertia("I_0", name, n, sheet);
                let before = Before {
                    momentum: momentum(inertia * *speed),
                    energy: inertia * speed.powi(2) / 2.0,
                    turning: (inertia.value() > 0.0).then_some([inertia, *speed]),
                };
                (before, Kept::Inertia(inertia))
            }
            MotionBeforeGiven::Straight { mass, speed, distance } => {
                let before = Before {
                    momentum: momentum(*mass * *speed * *distance),
                    energy: *mass * speed.powi(2) / 2.0,
                    turning: None,
                };
                (before, Kept::Particle { mass: *mass, distance: *distance })
            }
        }
    }
}

/// Inertia that a body brings from before.
#[derive(Clone, Copy)]
pub(super) enum Kept<N> {
    Inertia(N),
    Particle { mass: N, distance: N },
}

impl<W: Worksheet> MotionAfterGiven<W> {
    pub(super) fn work(&self, kept: Kept<W::Num>, name: &str, n: usize, sheet: W) -> After<W::Num> {
        let inertia = |body: &AxisInertiaGiven<W>| body.inertia("I_1", name, n, sheet);
        match self {
            MotionAfterGiven::Joined {} => {
                let inertia = match kept {
                    Kept::Inertia(inertia) => inertia,
                    Kept::Particle { mass, distance } => {
                        let reason = Named("Moment of inertia of {name} about the axis", name, None);
                        sheet.step(("I_1", n + 1), "kg*m^2", mass * distance.powi(2), reason)
                    }
                };
                After::Common { inertia, relative: None }
            }
            MotionAfterGiven::Changed { body } => After::Common { inertia: inertia(body), relative: None },
            MotionAfterGiven::Relative { body, relative } => {
                After::Common { inertia: inertia(body), relative: Some(*relative) }
            }
            MotionAfterGiven::Given { body, speed } => After::Given { inertia: inertia(body), speed: *speed },
            MotionAfterGiven::Leaves { mass, speed, distance } => {
                let reason = Named("Angular momentum of {name} after", name, None);
                let momentum = sheet.step(("H_1", n + 1), "kg*m^2/s", *mass * *speed * *distance, reason);
                After::Leaving { momentum, energy: *mass * speed.powi(2) / 2.0 }
            }
        }
    }
}
