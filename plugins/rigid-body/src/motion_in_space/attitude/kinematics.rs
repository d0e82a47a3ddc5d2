//! Rates of the parameters of an attitude, from the angular velocity and back.

use std::f64::consts::TAU;

use dalembert_core::{Inputs, Refusal, Text, Worksheet};
use dalembert_mechanics::{Real, Vector, rigid};
use nalgebra::{Matrix3, Rotation3, Vector3};

use super::acceleration::{AngularAcceleration, KnownAcceleration};
use crate::{
    shared::attitude::{EulerSequence, Representations, along, plain_parameters, row_times},
    sources::SCHAUB,
};

/// Rotation of a body at an instant.
#[derive(Clone, Debug, Inputs)]
pub struct InstantRotation {
    /// Angular velocity, or rates.
    pub velocity: AngularRate,
    /// Angular acceleration.
    /// If given, the accelerations of the Euler angles are also calculated, or it from them.
    pub acceleration: Option<AngularAcceleration>,
}

/// Angular velocity of a body, or rates of its parameters.
#[derive(Clone, Debug, Inputs)]
pub enum AngularRate {
    /// Angular velocity in B
    Body {
        /// Angular velocity, components in B.
        #[input("ω", "rad/s")]
        omega: Vector3<f64>,
    },
    /// Angular velocity in N
    Fixed {
        /// Angular velocity, components in N.
        #[input("Ω_N", "rad/s")]
        omega: Vector3<f64>,
    },
    /// Rates of the Euler angles
    /// Of the sequence that is calculated.
    EulerRates {
        /// Rate of the first angle.
        #[input("α̇₁", "rad/s")]
        first: f64,
        /// Rate of the second angle.
        #[input("α̇₂", "rad/s")]
        second: f64,
        /// Rate of the third angle.
        #[input("α̇₃", "rad/s")]
        third: f64,
    },
    /// Rates of the Euler parameters
    ParameterRates {
        /// Rate of the scalar part.
        #[input("β̇_s", "1/s")]
        scalar: f64,
        /// Rate of the vector part.
        #[input("β̇_v", "1/s")]
        vector: Vector3<f64>,
    },
    /// Rates of modified Rodrigues parameters
    /// Of the set that is no longer than 1.
    ModifiedRates {
        /// Rate of the modified Rodrigues parameters.
        #[input("σ̇_g", "1/s")]
        vector: Vector3<f64>,
    },
}

/// The rotation as given.
pub(super) struct Known<'a, W: Worksheet> {
    /// As plain numbers.
    pub rate: &'a InstantRotation,
    /// As numbers of the worksheet.
    pub given: &'a InstantRotationGiven<W>,
}

/// Triple product of the axes of the three rotations that is none: Euler angles have no rates.
const LOCK: f64 = 1e-9;
/// The rate of the length of a set of Euler parameters, in parts of the rates, that is rounding.
const ROUNDED: f64 = 0.02;

impl<W: Worksheet> Known<'_, W> {
    /// Answers angular velocity and rates.
    pub(super) fn answer(
        &self,
        (rows, c): ([W::Vec; 3], Matrix3<f64>),
        sequence: EulerSequence,
        (angles, gimbal_lock): ([W::Num; 3], bool),
        representations: &Representations<W>,
        sheet: W,
    ) -> Result<(), Refusal> {
        let axes = sequence.axes_in_body::<W::Vec>(angles);
        let omega = self.angular_velocity(rows, (axes, gimbal_lock), representations, sheet)?;
        let in_fixed = sheet.step_vector(
            "ω_N",
            "rad/s",
            row_times(omega, rows),
            "Angular velocity in components in N: [BN]ᵀ times that in B",
        );
        if let AngularRateGiven::EulerRates { first, second, third } = self.given.velocity {
            sheet.common_error("|ω|", "the axes of the three rates taken as perpendicular", || {
                (first.powi(2) + second.powi(2) + third.powi(2)).sqrt()
            });
            sheet.common_error("|ω|", "the rates of the angles added as numbers", || first + second + third);
        }
        let speed = sheet.step("|ω|", "rad/s", omega.magnitude(), "Its magnitude");
        sheet.answer_vector("angular_velocity", "Angular velocity in B", omega);
        sheet.answer_vector("angular_velocity_fixed", "Angular velocity in N", in_fixed);
        sheet.answer("angular_speed", "Magnitude of the angular velocity", speed);
        let (scalar, vector) = representations.parameters;
        let scalar_rate = sheet.step(
            "β̇₀",
            "1/s",
            -vector.dot(omega) / 2.0,
            ("Rate of the scalar Euler parameter", SCHAUB.at("§3.5")),
        );
        let vector_rate = sheet.step_vector(
            "ε̇",
            "1/s",
            (omega * scalar + vector.cross(omega)) / W::Num::from(2.0),
            ("Rate of the vector part", SCHAUB.at("§3.5")),
        );
        sheet.answer("euler_parameter_rate_scalar", "Rate of β₀", scalar_rate);
        sheet.answer_vector("euler_parameter_rate_vector", "Rates of β₁, β₂, β₃", vector_rate);
        let rodrigues_rate = representations.rodrigues.map(|q| {
            let rate = sheet.step_vector(
                "q̇",
                "1/s",
                (omega + q.cross(omega) + q * q.dot(omega)) / W::Num::from(2.0),
                ("Rate of the Rodrigues parameters", SCHAUB.at("§3.6")),
            );
            sheet.answer_vector("rodrigues_rate", "Rate of the Rodrigues parameters", rate);
            rate
        });
        let sigma = representations.modified;
        let modified_rate = sheet.step_vector(
            "σ̇",
            "1/s",
            (omega * (-sigma.dot(sigma) + 1.0)
                + sigma.cross(omega) * W::Num::from(2.0)
                + sigma * (sigma.dot(omega) * 2.0))
                / W::Num::from(4.0),
            ("Rate of the modified Rodrigues parameters", SCHAUB.at("§3.7")),
        );
        sheet.answer_vector(
            "modified_rodrigues_rate",
            "Rate of modified Rodrigues parameters",
            modified_rate,
        );
        let euler = euler_rates(axes, omega, sequence, sheet);
        if let Some(acceleration) = &self.given.acceleration {
            // At gimbal lock the rates are known only where they are given.
            let rates = match &self.given.velocity {
                AngularRateGiven::EulerRates { first, second, third } => Some([*first, *second, *third]),
                _ => euler,
            };
            let known = KnownAcceleration { given: acceleration, rows, sequence, angles, axes, rates };
            known.answer(omega, euler.is_some(), sheet)?;
        }
        let size = omega.value().norm();
        if size > 0.0 {
            sheet.verify(|| {
                let later = |t: f64| Rotation3::from_scaled_axis(-omega.value() * t).matrix() * c;
                let period = TAU / size;
                let near = |found: (f64, Vector3<f64>)| {
                    // The set that goes on from that at the start.
                    let before = scalar.value() * found.0 + vector.value().dot(found.1);
                    let sign = if before < 0.0 { -1.0 } else { 1.0 };
                    (found.0 * sign, found.1 * sign)
                };
                let at = |t: f64| near(plain_parameters(&later(t)));
                let quotient = |of: &dyn Fn(f64) -> Vector3<f64>| {
                    rigid::numerical_rate(of, period).unwrap_or_else(|_| Vector3::repeat(f64::NAN))
                };
                let off = |what: &'static str, found: Vector3<f64>, rate: Vector3<f64>, scale: f64| {
                    sheet.check_zero(what, (found - rate).norm().into(), scale);
                };
                off(
                    "rates of β₁, β₂, β₃ by differences of the attitude",
                    quotient(&|t| at(t).1),
                    vector_rate.value(),
                    size,
                );
                off(
                    "rate of β₀ by differences of the attitude",
                    quotient(&|t| Vector3::x() * at(t).0),
                    Vector3::x() * scalar_rate.value(),
                    size,
                );
                off(
                    "rate of the modified Rodrigues parameters by differences of the attitude",
                    quotient(&|t| at(t).1 / (1.0 + at(t).0)),
                    modified_rate.value(),
                    size,
                );
                let fixed = quotient(&|t| later(t).transpose() * Vector3::x());
                let [b1, turned] = [Vector3::from(c.row(0).transpose()), in_fixed.value()];
                off("ω × b₁ in N by differences of the attitude", fixed, turned.cross(b1), size);
                sheet.check("the magnitude of ω in N", in_fixed.magnitude(), speed);
                let q = representations.rodrigues.map(|q| (q, 1.0 + q.value().norm_squared()));
                if let (Some((q, scale)), Some(rate)) = (q, rodrigues_rate) {
                    // From q = ε/β₀.
                    let other = (vector_rate.value() - q.value() * scalar_rate.value()) / scalar.value();
                    off(
                        "rate of the Rodrigues parameters from that of ε/β₀",
                        other,
                        rate.value(),
                        size * scale,
                    );
                }
                if let Some(rates) = euler {
                    let plain = rates.map(Real::value);
                    let here = angles.map(Real::value);
                    let step = |t: f64| sequence.product(std::array::from_fn(|n| here[n] + plain[n] * t));
                    let fastest = plain.iter().fold(size, |most, rate| most.max(rate.abs()));
                    let period = TAU / fastest;
                    for n in 0..3 {
                        let what =
                            Text::new("the turn of axis {axis} of B from the rates of the Euler angles")
                                .with("axis", n + 1);
                        let found = rigid::numerical_rate(|t| step(t).row(n).transpose(), period)
                            .unwrap_or_else(|_| Vector3::repeat(f64::NAN));
                        let axis: Vector3<f64> = c.row(n).transpose();
                        sheet.check_zero(what, (found - turned.cross(axis)).norm().into(), fastest);
                    }
                }
            });
        }
        Ok(())
    }

    /// The angular velocity in components in B.
    fn angular_velocity(
        &self,
        rows: [W::Vec; 3],
        (axes, gimbal_lock): ([W::Vec; 3], bool),
        representations: &Representations<W>,
        sheet: W,
    ) -> Result<W::Vec, Refusal> {
        let step = |value: W::Vec, why: &'static str| {
            sheet.step_vector("ω", "rad/s", value, (why, SCHAUB.at("§3.3")))
        };
        Ok(match (&self.rate.velocity, &self.given.velocity) {
            (AngularRate::Body { .. }, AngularRateGiven::Body { omega }) => {
                let one = W::Num::from(1.0);
                sheet.step_vector(
                    "ω_B",
                    "rad/s",
                    *omega * one,
                    "Angular velocity in components in B, as given",
                )
            }
            (AngularRate::Fixed { .. }, AngularRateGiven::Fixed { omega }) => {
                let [x, y, z] = rows.map(|row| row.dot(*omega));
                step(
                    W::Vec::from_components(x, y, z),
                    "Angular velocity in components in B: [BN] times that in N",
                )
            }
            (AngularRate::EulerRates { .. }, AngularRateGiven::EulerRates { first, second, third }) => {
                if gimbal_lock {
                    return Err(Refusal::because(
                        "at gimbal lock the angles of this sequence do not tell the axes of their rates: choose another sequence, or give the angular velocity",
                    ));
                }
                let why = "Angular velocity in components in B: each rate about its axis";
                step(axes[0] * *first + axes[1] * *second + axes[2] * *third, why)
            }
            (
                AngularRate::ParameterRates { scalar: r, vector: rates },
                AngularRateGiven::ParameterRates { scalar: rate, vector: rates_given },
            ) => {
                let (scalar, vector) = representations.parameters;
                let length = scalar.value() * r + vector.value().dot(*rates);
                let size = (r.powi(2) + rates.norm_squared()).sqrt();
                if length.abs() > ROUNDED * size {
                    return Err(Refusal::NoAnswer(
                        Text::new("these rates change the length of the Euler parameters, β₀ β̇₀ + ε · ε̇ = {rate} instead of 0: check them, and whether they belong to the set with β₀ ≥ 0")
                            .with_quantity("rate", length, "1/s"),
                    ));
                }
                let why = "Angular velocity in components in B from the rates of the Euler parameters";
                let value =
                    (*rates_given * scalar - vector * *rate - vector.cross(*rates_given)) * W::Num::from(2.0);
                step(value, why)
            }
            (AngularRate::ModifiedRates { .. }, AngularRateGiven::ModifiedRates { vector }) => {
                let sigma = representations.modified;
                let square = sigma.dot(sigma);
                let factor = W::Num::from(4.0) / (square + 1.0).powi(2);
                let value = *vector * (-square + 1.0) - sigma.cross(*vector) * W::Num::from(2.0)
                    + sigma * (sigma.dot(*vector) * 2.0);
                let why =
                    "Angular velocity in components in B from the rates of the modified Rodrigues parameters";
                step(value * factor, why)
            }
            _ => unreachable!("the inputs are lifted from the rotation"),
        })
    }
}

/// Rates of the Euler angles; none at gimbal lock.
fn euler_rates<W: Worksheet>(
    [first, second, third]: [W::Vec; 3],
    omega: W::Vec,
    sequence: EulerSequence,
    sheet: W,
) -> Option<[W::Num; 3]> {
    let normal = first.value().dot(second.value().cross(third.value()));
    if normal.abs() <= LOCK {
        sheet.warn(|| {
            Text::new("gimbal lock: the Euler angles of {sequence} have no rates for every angular velocity here; take another sequence")
                .with("sequence", sequence.name())
        });
        return None;
    }
    let triple = sheet.step(
        "D",
        "1",
        first.dot(second.cross(third)),
        "Triple product of the axes of the three rotations: zero at gimbal lock",
    );
    let why = ("Rate of an Euler angle: ω resolved along the axes of the three rotations", SCHAUB.at("§3.3"));
    let what = "the component of ω along the body axis of that rotation taken";
    for (symbol, axis) in ["θ̇₁", "θ̇₂", "θ̇₃"].into_iter().zip(sequence.axes()) {
        sheet.common_error(symbol, what, || omega.components()[axis]);
    }
    let what = "ω projected orthogonally onto the axis of the rotation";
    sheet.common_error("θ̇₁", what, || omega.dot(first));
    let [one, two, three] = along(omega, [first, second, third], triple);
    let rates = [("θ̇₁", one), ("θ̇₂", two), ("θ̇₃", three)];
    let rates = rates.map(|(symbol, rate)| sheet.step(symbol, "rad/s", rate, why));
    for (n, rate) in rates.into_iter().enumerate() {
        sheet.answer(("euler_rate", n + 1), "Rate of the Euler angle", rate);
    }
    Some(rates)
}
