//! Angular acceleration, and the accelerations of the Euler angles.

use std::f64::consts::TAU;

use dalembert_core::{Inputs, Refusal, Worksheet};
use dalembert_mechanics::{Real, Vector, rigid};
use nalgebra::Vector3;

use crate::{
    shared::attitude::{EulerSequence, along, matrix, row_times},
    sources::BEER,
};

/// Angular acceleration of a body, or accelerations of its Euler angles.
#[derive(Clone, Debug, Inputs)]
pub enum AngularAcceleration {
    /// Angular acceleration in B
    Body {
        /// Angular acceleration, components in B.
        #[input("ω̇", "rad/s^2")]
        alpha: Vector3<f64>,
    },
    /// Angular acceleration in N
    Fixed {
        /// Angular acceleration, components in N.
        #[input("Ω̇_N", "rad/s^2")]
        alpha: Vector3<f64>,
    },
    /// Accelerations of the Euler angles
    /// Of the sequence that is calculated.
    EulerAccelerations {
        /// Acceleration of the first angle.
        #[input("α̈₁", "rad/s^2")]
        first: f64,
        /// Acceleration of the second angle.
        #[input("α̈₂", "rad/s^2")]
        second: f64,
        /// Acceleration of the third angle.
        #[input("α̈₃", "rad/s^2")]
        third: f64,
    },
}

/// The acceleration as given, with the rotation at the instant.
pub(super) struct KnownAcceleration<'a, W: Worksheet> {
    pub given: &'a AngularAccelerationGiven<W>,
    pub rows: [W::Vec; 3],
    pub sequence: EulerSequence,
    /// Euler angles and their axes in B.
    pub angles: [W::Num; 3],
    pub axes: [W::Vec; 3],
    /// Rates of the Euler angles, where they are known.
    pub rates: Option<[W::Num; 3]>,
}

impl<W: Worksheet> KnownAcceleration<'_, W> {
    /// Answers the angular acceleration; `free` says whether the Euler angles have accelerations for each.
    pub(super) fn answer(&self, omega: W::Vec, free: bool, sheet: W) -> Result<(), Refusal> {
        let coupling = self.rates.map(|rates| self.coupling(rates, sheet));
        let alpha = match self.given {
            AngularAccelerationGiven::Body { alpha } => sheet.step_vector(
                "ω̇_B",
                "rad/s^2",
                *alpha * W::Num::from(1.0),
                "Angular acceleration in components in B, as given",
            ),
            AngularAccelerationGiven::Fixed { alpha } => {
                let [x, y, z] = self.rows.map(|row| row.dot(*alpha));
                sheet.step_vector(
                    "ω̇_B",
                    "rad/s^2",
                    W::Vec::from_components(x, y, z),
                    "Angular acceleration in components in B: [BN] times that in N",
                )
            }
            AngularAccelerationGiven::EulerAccelerations { first, second, third } => {
                let Some(coupling) = coupling else {
                    return Err(Refusal::because(
                        "at gimbal lock the angular velocity does not tell the rates of the Euler angles: choose another sequence, or give the angular acceleration",
                    ));
                };
                let [a, b, c] = self.axes;
                sheet.step_vector(
                    "ω̇_B",
                    "rad/s^2",
                    a * *first + b * *second + c * *third + coupling,
                    "Angular acceleration in components in B: each acceleration about its axis, and the turn of the axes",
                )
            }
        };
        let fixed = sheet.step_vector(
            "ω̇_N",
            "rad/s^2",
            row_times(alpha, self.rows),
            "Angular acceleration in components in N: [BN]ᵀ times that in B",
        );
        sheet.answer_vector("angular_acceleration", "Angular acceleration in B", alpha);
        sheet.answer_vector("angular_acceleration_fixed", "Angular acceleration in N", fixed);
        sheet.verify(|| {
            let off = matrix(self.rows) * fixed.value() - alpha.value();
            let size = alpha.value().norm();
            sheet.check_zero(
                "the angular acceleration in B, by [BN] times that in N",
                off.norm().into(),
                size,
            );
        });
        let (Some(rates), Some(coupling), true) = (self.rates, coupling, free) else { return Ok(()) };
        let left = sheet.step_vector(
            "ω̇_e",
            "rad/s^2",
            alpha - coupling,
            "Angular acceleration without the part of the turn of the axes",
        );
        let [a, b, c] = self.axes;
        let triple = a.dot(b.cross(c));
        let why =
            "Acceleration of an Euler angle: what is left, resolved along the axes of the three rotations";
        let [one, two, three] = along(left, self.axes, triple);
        let found = [("θ̈₁", one), ("θ̈₂", two), ("θ̈₃", three)];
        let what = "the angular acceleration projected orthogonally onto the axis of the rotation";
        for (symbol, axis) in [("θ̈₁", a), ("θ̈₃", c)] {
            sheet.common_error(symbol, what, || left.dot(axis));
        }
        let found = found.map(|(symbol, acceleration)| sheet.step(symbol, "rad/s^2", acceleration, why));
        for (n, acceleration) in found.into_iter().enumerate() {
            sheet.answer(("euler_acceleration", n + 1), "Acceleration of the Euler angle", acceleration);
        }
        sheet.verify(|| {
            let [angles, rates, accelerations] = [self.angles, rates, found].map(|all| all.map(Real::value));
            let at = |t: f64| {
                let now = [0, 1, 2].map(|n| angles[n] + rates[n] * t + accelerations[n] * t * t / 2.0);
                let axes = self.sequence.axes_in_body::<Vector3<f64>>(now);
                (0..3).map(|n| axes[n] * (rates[n] + accelerations[n] * t)).sum::<Vector3<f64>>()
            };
            let fast = rates.iter().map(|rate| rate.abs()).sum::<f64>()
                + accelerations.iter().map(|acceleration| acceleration.abs().sqrt()).sum::<f64>()
                + omega.value().norm();
            if fast > 0.0
                && let Ok(other) = rigid::numerical_rate(at, TAU / fast)
            {
                sheet.check_zero(
                    "the angular acceleration by differences of the angular velocity",
                    (other - alpha.value()).norm().into(),
                    fast.powi(2),
                );
            }
        });
        Ok(())
    }

    /// The part of the angular acceleration that is due to the turn of the axes.
    fn coupling(&self, [first, second, third]: [W::Num; 3], sheet: W) -> W::Vec {
        let [a, b, c] = self.axes;
        let (one, two, three) = (a * first, b * second, c * third);
        sheet.step_vector(
            "ω̇_c",
            "rad/s^2",
            one.cross(two) + (one + two).cross(three),
            (
                "Part of the angular acceleration that is due to the turn of the axes: each is turned by the rotations before it",
                BEER.at("§15.5A"),
            ),
        )
    }
}
