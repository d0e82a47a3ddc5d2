//! Inputs of a body in motion, converted for the integration.

use dalembert_core::{Inputs, Refusal};
use dalembert_mechanics::rigid::simulate::{AppliedTorque, History, Loads, RotatingBody, RotationEvent};
use nalgebra::{Matrix3, UnitQuaternion, Vector3};

/// A body that turns, from a start.
///
/// The axes xyz are fixed in the body, with their origin in the point that it turns about; XYZ are fixed, Z
/// points up. Without an attitude both are the same at the start.
#[derive(Clone, Debug, Inputs)]
pub struct Motion {
    /// The body rotates about.
    pub pivot: Pivot,
    /// Moments of inertia.
    pub moments: Moments,
    /// Attitude at the start.
    #[input(default = "aligned")]
    pub attitude: Attitude,
    /// Angular velocity at the start.
    pub velocity: Velocity,
    /// Torques.
    pub torques: Vec<TorqueRow>,
    /// Tracked axis of the body.
    #[input(default = "z")]
    pub axis: BodyAxis,
    /// Duration.
    #[input("t_e", "s", positive, default = "10 s")]
    pub duration: f64,
    /// Early stop condition.
    #[input(default = "nothing")]
    pub end: MotionEvent,
}

/// The point that a body turns about.
#[derive(Clone, Debug, Inputs)]
pub enum Pivot {
    /// Its centre of mass
    /// In free flight, or supported there; the weight has no moment.
    MassCentre,
    /// A fixed point
    FixedPoint {
        /// Mass.
        #[input("m", "kg", positive)]
        mass: f64,
        /// Centre of mass, from the fixed point, in body axes.
        #[input("r_G", "m")]
        centre: Vector3<f64>,
        /// The moments of inertia are about.
        about: InertiaPoint,
        /// Acceleration of gravity, along −Z.
        #[input("g", "m/s^2", nonnegative, default = "9.81 m/s^2")]
        gravity: f64,
    },
    /// The origin of its description
    /// For a body that is defined as a whole.
    Origin {
        /// Acceleration of gravity, along −Z.
        #[input("g", "m/s^2", nonnegative, default = "9.81 m/s^2")]
        gravity: f64,
    },
}

/// A point that moments of inertia are about.
#[derive(Clone, Debug, Inputs)]
pub enum InertiaPoint {
    /// The fixed point
    FixedPoint,
    /// The centre of mass
    MassCentre,
}

/// Moments of inertia in the axes of the body.
#[derive(Clone, Debug, Inputs)]
pub enum Moments {
    /// Principal axes
    Principal {
        /// About x.
        #[input("I_x", "kg*m^2", positive)]
        x: f64,
        /// About y.
        #[input("I_y", "kg*m^2", positive)]
        y: f64,
        /// About z.
        #[input("I_z", "kg*m^2", positive)]
        z: f64,
    },
    /// Body of revolution about z
    Revolution {
        /// About its axis z.
        #[input("I_a", "kg*m^2", positive)]
        axial: f64,
        /// Transverse to its axis.
        #[input("I_t", "kg*m^2", positive)]
        transverse: f64,
    },
    /// Moments and products of inertia
    Tensor {
        /// About x.
        #[input("I_x", "kg*m^2", positive)]
        x: f64,
        /// About y.
        #[input("I_y", "kg*m^2", positive)]
        y: f64,
        /// About z.
        #[input("I_z", "kg*m^2", positive)]
        z: f64,
        /// Product ∫xy dm.
        #[input("I_xy", "kg*m^2", default = "0 kg*m^2")]
        xy: f64,
        /// Product ∫yz dm.
        #[input("I_yz", "kg*m^2", default = "0 kg*m^2")]
        yz: f64,
        /// Product ∫zx dm.
        #[input("I_zx", "kg*m^2", default = "0 kg*m^2")]
        zx: f64,
    },
    /// Body defined as a whole
    /// It rotates about its centre of mass or about the origin of its description.
    Described {
        /// Body.
        body: crate::shared::body::Body,
    },
}

impl Moments {
    /// The letters of what is given along each axis of the body.
    pub(super) fn letters(&self) -> [&'static str; 3] {
        match self {
            Moments::Principal { .. } | Moments::Tensor { .. } => ["I_x", "I_y", "I_z"],
            Moments::Revolution { .. } => ["I_t", "", "I_a"],
            Moments::Described { .. } => ["", "", ""],
        }
    }
}

/// Initial attitude of the body axes.
#[derive(Clone, Debug, Inputs)]
pub enum Attitude {
    /// Aligned with the fixed axes
    Aligned,
    /// Euler angles
    /// Precession about Z, nutation about the new x, spin about the new z.
    Euler {
        /// Precession.
        #[input("φ", "deg", default = "0 deg")]
        precession: f64,
        /// Nutation.
        #[input("θ", "deg")]
        nutation: f64,
        /// Spin.
        #[input("ψ", "deg", default = "0 deg")]
        spin: f64,
    },
    /// Rotated about an axis
    Turned {
        /// Axis, of any length.
        #[input("n", "1")]
        axis: Vector3<f64>,
        /// Angle.
        #[input("β", "deg")]
        angle: f64,
    },
}

/// The angular velocity at the start.
#[derive(Clone, Debug, Inputs)]
pub enum Velocity {
    /// In body axes
    Body {
        /// Angular velocity.
        #[input("ω", "rad/s")]
        omega: Vector3<f64>,
    },
    /// In the fixed axes
    Space {
        /// Angular velocity.
        #[input("ω", "rad/s")]
        omega: Vector3<f64>,
    },
    /// Euler angle rates
    /// For an attitude given by Euler angles.
    Rates {
        /// Precession.
        #[input("φ̇", "rad/s", default = "0 rad/s")]
        precession: f64,
        /// Nutation.
        #[input("θ̇", "rad/s", default = "0 rad/s")]
        nutation: f64,
        /// Spin.
        #[input("ψ̇", "rad/s")]
        spin: f64,
    },
}

/// A torque on the body.
#[derive(Clone, Debug, Inputs)]
pub struct TorqueRow {
    /// Torque about the point of rotation.
    #[input("M", "N*m")]
    pub torque: Vector3<f64>,
    /// Direction fixed in.
    pub carrier: TorqueAxes,
    /// Its time history.
    pub course: TorqueHistory,
}

/// Axes in which a torque keeps its direction.
#[derive(Clone, Debug, Inputs)]
pub enum TorqueAxes {
    /// The body
    Body,
    /// Space
    Space,
}

/// Time history of a torque.
#[derive(Clone, Debug, Inputs)]
pub enum TorqueHistory {
    /// Constant
    Constant,
    /// Harmonic
    /// The torque times sin(Ω t + φ).
    Harmonic {
        /// Angular frequency.
        #[input("Ω", "rad/s", nonnegative)]
        frequency: f64,
        /// Phase.
        #[input("φ", "deg", default = "0 deg")]
        phase: f64,
    },
    /// Table
    /// The torque times a factor, linearly interpolated between the times.
    Table {
        /// Times and factors.
        #[input(table)]
        rows: Vec<Instant>,
    },
}

/// A factor at a time.
#[derive(Clone, Debug, Inputs)]
pub struct Instant {
    /// Time.
    #[input("t", "s")]
    pub time: f64,
    /// Factor.
    #[input("f", "1")]
    pub factor: f64,
}

/// An axis of the body.
#[derive(Clone, Copy, Debug, Inputs)]
pub enum BodyAxis {
    /// z
    Z,
    /// x
    X,
    /// y
    Y,
}

/// Terminal event of a motion.
#[derive(Clone, Debug, Inputs)]
pub enum MotionEvent {
    /// Nothing
    Nothing,
    /// The axis reaches an angle to Z
    Tilt {
        /// Angle to Z.
        #[input("θ_e", "deg", nonnegative, max = 180)]
        angle: f64,
    },
    /// A component of the angular velocity changes its sign
    Reverses {
        /// Component in the axes of the body.
        component: BodyAxis,
    },
}

impl Motion {
    /// The body about the point that it turns about.
    pub(super) fn body(&self) -> Result<RotatingBody, Refusal> {
        let inertia = match self.moments {
            Moments::Principal { x, y, z } => Matrix3::from_diagonal(&Vector3::new(x, y, z)),
            Moments::Revolution { axial, transverse } => {
                Matrix3::from_diagonal(&Vector3::new(transverse, transverse, axial))
            }
            Moments::Tensor { x, y, z, xy, yz, zx } => Matrix3::new(x, -xy, -zx, -xy, y, -yz, -zx, -yz, z),
            Moments::Described { ref body } => {
                let whole = body.properties()?;
                return match self.pivot {
                    Pivot::MassCentre => about_point(0.0, whole.inertia, Vector3::zeros()),
                    Pivot::Origin { .. } => about_point(whole.mass, whole.inertia, whole.centre),
                    Pivot::FixedPoint { .. } => Err(Refusal::because(
                        "a body defined as a whole includes its mass and its centre of mass; let it rotate about the origin of its description, or about its centre of mass",
                    )),
                };
            }
        };
        match self.pivot {
            Pivot::MassCentre => about_point(0.0, inertia, Vector3::zeros()),
            Pivot::FixedPoint { mass, centre, about: InertiaPoint::MassCentre, .. } => {
                about_point(mass, inertia, centre)
            }
            Pivot::FixedPoint { mass, centre, about: InertiaPoint::FixedPoint, .. } => {
                Ok(RotatingBody { mass, inertia, arm: centre })
            }
            Pivot::Origin { .. } => Err(Refusal::because(
                "only a body defined as a whole has an origin; let the body turn about a fixed point and give its mass and centre of mass",
            )),
        }
    }

    pub(super) fn loads(&self) -> Loads {
        let gravity = match self.pivot {
            Pivot::MassCentre => Vector3::zeros(),
            Pivot::FixedPoint { gravity, .. } | Pivot::Origin { gravity } => Vector3::z() * -gravity,
        };
        Loads { gravity, torques: self.torques.iter().map(TorqueRow::torque).collect() }
    }

    pub(super) fn omega_body(&self) -> Result<Vector3<f64>, Refusal> {
        Ok(match self.velocity {
            Velocity::Body { omega } => omega,
            Velocity::Space { omega } => self.attitude.turned()?.inverse() * omega,
            Velocity::Rates { precession, nutation, spin } => {
                let Attitude::Euler { nutation: theta, spin: psi, .. } = self.attitude else {
                    return Err(Refusal::because(
                        "the Euler angle rates need an attitude in Euler angles; give it so, or give the angular velocity as a vector",
                    ));
                };
                let ((sin, cos), (sin_spin, cos_spin)) = (theta.sin_cos(), psi.sin_cos());
                Vector3::new(
                    precession * sin * sin_spin + nutation * cos_spin,
                    precession * sin * cos_spin - nutation * sin_spin,
                    precession * cos + spin,
                )
            }
        })
    }
}

impl Attitude {
    /// From the axes of the body to the fixed ones.
    pub(super) fn turned(&self) -> Result<UnitQuaternion<f64>, Refusal> {
        let about = |axis, angle: f64| UnitQuaternion::from_axis_angle(&axis, angle);
        match *self {
            Attitude::Aligned => Ok(UnitQuaternion::identity()),
            Attitude::Euler { precession, nutation, spin } => Ok(about(Vector3::z_axis(), precession)
                * about(Vector3::x_axis(), nutation)
                * about(Vector3::z_axis(), spin)),
            Attitude::Turned { axis, angle } => {
                let largest = axis.amax();
                if largest == 0.0 {
                    return Err(Refusal::because(
                        "the axis of the attitude has no length; give any vector along it",
                    ));
                }
                let unit = nalgebra::Unit::new_normalize(axis / largest);
                Ok(about(unit, angle))
            }
        }
    }
}

impl TorqueRow {
    fn torque(&self) -> AppliedTorque {
        let history = match self.course {
            TorqueHistory::Constant => History::Constant,
            TorqueHistory::Harmonic { frequency, phase } => History::Harmonic { frequency, phase },
            TorqueHistory::Table { ref rows } => {
                let mut rows: Vec<[f64; 2]> = rows.iter().map(|row| [row.time, row.factor]).collect();
                rows.sort_by(|a, b| a[0].total_cmp(&b[0]));
                // Of two factors at one time the later row counts.
                rows.reverse();
                rows.dedup_by(|later, kept| later[0] == kept[0]);
                rows.reverse();
                History::Table(rows)
            }
        };
        AppliedTorque { vector: self.torque, in_body: matches!(self.carrier, TorqueAxes::Body), history }
    }
}

impl BodyAxis {
    /// Index among x, y and z.
    pub(super) fn index(self) -> usize {
        match self {
            BodyAxis::X => 0,
            BodyAxis::Y => 1,
            BodyAxis::Z => 2,
        }
    }

    /// The unit vector along it.
    pub(super) fn vector(self) -> Vector3<f64> {
        Vector3::ith(self.index(), 1.0)
    }

    /// Name of the axis.
    pub(super) fn name(self) -> &'static str {
        match self {
            BodyAxis::X => "x",
            BodyAxis::Y => "y",
            BodyAxis::Z => "z",
        }
    }
}

impl MotionEvent {
    pub(super) fn end(&self, axis: BodyAxis) -> Option<RotationEvent> {
        match *self {
            MotionEvent::Nothing => None,
            MotionEvent::Tilt { angle } => {
                Some(RotationEvent::Angle { of: axis.vector(), against: Vector3::z(), angle })
            }
            MotionEvent::Reverses { component } => Some(RotationEvent::Reverses(component.index())),
        }
    }
}

/// A body about a point, from its inertia about its centre of mass.
fn about_point(mass: f64, about_g: Matrix3<f64>, arm: Vector3<f64>) -> Result<RotatingBody, Refusal> {
    let steiner = (Matrix3::identity() * arm.norm_squared() - arm * arm.transpose()) * mass;
    let inertia = about_g + steiner;
    if inertia.iter().all(|entry| entry.is_finite()) {
        Ok(RotatingBody { mass, inertia, arm })
    } else {
        Err(Refusal::because(
            "the moment of inertia of the mass about the fixed point exceeds the numerical range",
        ))
    }
}
