//! Loads on a mechanism besides its weight: forces, force elements along a measure, friction.

use super::{BodyFrame, BodyPoint, Pose, Profile, RelativeCoordinate};
use crate::Real;
use dalembert_numerics::simd::SimdReal;

/// A load.
#[derive(Debug, Clone, PartialEq)]
pub enum PlanarLoad {
    /// A force at a point, in the axes of the ground or turning with a body.
    Force {
        /// The point of application.
        at: BodyPoint,
        /// The components, N.
        force: [f64; 2],
        /// The body in whose axes the components are.
        turns_with: BodyFrame,
    },
    /// An effort along a measure: a force along a length (N) or a couple about an angle (N m), positive when it
    /// pushes the measure to grow. It acts on both bodies of the measure.
    Effort {
        /// The measure along which it acts.
        measure: RelativeCoordinate,
        /// The force law.
        effort: Effort,
    },
    /// Coulomb friction in a joint against its sliding: in a slider or slot `μ |N|` along the line, in a pin the
    /// couple `μ r |F|`.
    Friction {
        /// The joint, counted from 0.
        joint: usize,
        /// Coefficient of friction μ.
        coefficient: f64,
        /// Radius of the pin r, m; of no account in a slider or slot.
        radius: f64,
    },
}

/// The force law of an effort along a measure m, N or N m.
#[derive(Debug, Clone, PartialEq)]
pub enum Effort {
    /// A constant.
    Constant(f64),
    /// `−k (m − m₀)`.
    Spring {
        /// Stiffness k, N/m or N m/rad.
        stiffness: f64,
        /// The measure of the unstretched spring m₀.
        free: f64,
    },
    /// `−c ṁ`.
    Damper {
        /// Coefficient c, N s/m or N m s/rad.
        coefficient: f64,
    },
    /// Gas behind a piston, `A (p₁ (m₁/m)ⁿ − p₀)`, with m the length of the gas column.
    Gas {
        /// Area of the piston A, m².
        area: f64,
        /// Absolute pressure p₁ at the column m₁, Pa.
        pressure: f64,
        /// Column m₁, m.
        column: f64,
        /// Exponent n: 1 hyperbolic, 1.4 adiabatic for air.
        exponent: f64,
        /// Absolute pressure on the other side p₀, Pa.
        ambient: f64,
    },
    /// A table of the measure.
    Table(Profile),
}

impl Effort {
    /// The effort at a value and a velocity of its measure.
    #[inline(always)]
    pub fn at<S: SimdReal>(&self, value: S, velocity: S) -> S {
        match self {
            &Effort::Constant(effort) => S::from(effort),
            &Effort::Spring { stiffness, free } => -((value - free) * stiffness),
            &Effort::Damper { coefficient } => -(velocity * coefficient),
            &Effort::Gas { area, pressure, column, exponent, ambient } => {
                value.each(|value| area * (pressure * (column / value).powf(exponent) - ambient))
            }
            Effort::Table(profile) => value.each(|value| profile.at(value)[0]),
        }
    }

    /// The derivatives with respect to the value and to the velocity.
    pub fn gradient(&self, value: f64) -> [f64; 2] {
        match self {
            Effort::Constant(_) => [0.0, 0.0],
            Effort::Spring { stiffness, .. } => [-stiffness, 0.0],
            Effort::Damper { coefficient } => [0.0, -coefficient],
            &Effort::Gas { area, pressure, column, exponent, .. } => {
                [-(area * pressure * exponent * (column / value).powf(exponent) / value), 0.0]
            }
            Effort::Table(profile) => [profile.at(value)[1], 0.0],
        }
    }

    /// True if it is conservative: it has an [`energy`](Effort::energy).
    pub fn is_stored(&self) -> bool {
        !matches!(self, Effort::Damper { .. })
    }

    /// The energy stored in it, J; none for a damper. A gas and a table are measured from their first point.
    pub fn energy(&self, value: f64) -> Option<f64> {
        match self {
            &Effort::Constant(effort) => Some(-(effort * value)),
            &Effort::Spring { stiffness, free } => Some(stiffness * (value - free).powi(2) / 2.0),
            Effort::Damper { .. } => None,
            &Effort::Gas { area, pressure, column, exponent, ambient } => {
                let ratio = column / value;
                let expansion = if exponent == 1.0 {
                    ratio.ln()
                } else {
                    (ratio.powf(exponent - 1.0) - 1.0) / (exponent - 1.0)
                };
                Some(area * (pressure * column * expansion + ambient * (value - column)))
            }
            Effort::Table(profile) => Some(-profile.integral(value)),
        }
    }
}

/// The force and moment about its body's origin of a force at a point.
#[inline(always)]
pub(super) fn wrench<S: Real>(pose: &Pose<S>, at: [f64; 2], force: [S; 2]) -> [S; 3] {
    let [rx, ry] = pose.turned(at);
    [force[0], force[1], rx * force[1] - ry * force[0]]
}
