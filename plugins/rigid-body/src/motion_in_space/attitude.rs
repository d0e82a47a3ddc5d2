//! Attitude of a body in all of its representations, and their rates.

mod acceleration;
mod kinematics;

use dalembert_core::{About, Analysis, Axis, Exhibit, Inputs, Plot, Refusal, Series, Worksheet, register};
use dalembert_mechanics::Vector;
use nalgebra::{Matrix3, Vector3};

use crate::{
    shared::attitude::{
        AttitudeInput, AttitudeInputGiven, EulerSequence, FrameAxes, SingleAttitude, SingleAttitudeGiven,
        answer_representations, frames, matrix, plain_angles, plain_parameters, row_times, rows_of,
    },
    sources::{BEER, SCHAUB, SHUSTER},
};
use kinematics::{InstantRotation, Known};

/// Attitude of a body with axes B relative to axes N.
///
/// `[BN]` changes components in N into components in B: its rows are the unit vectors b₁, b₂, b₃ of B in components in N.
/// Rotations are of the frame, positive by the right-hand rule.
#[derive(Clone, Debug, Inputs)]
pub struct Attitude {
    /// Attitude of B relative to N.
    pub attitude: AttitudeInput,
    /// Euler angles to calculate.
    #[input(default = "zyx")]
    pub sequence: EulerSequence,
    /// Vectors in other axes.
    pub vectors: Vec<TurnedVector>,
    /// Rotation at this instant.
    /// If given, the rates of all parameters are also calculated, or the angular velocity from the rates.
    pub rate: Option<InstantRotation>,
}

/// A vector whose components in the other frame are wanted.
#[derive(Clone, Debug, Inputs)]
pub struct TurnedVector {
    /// Components, in any unit.
    #[input("v", "1")]
    pub components: Vector3<f64>,
    /// Given in the axes.
    pub axes: FrameAxes,
}

register!(Attitude);

impl Analysis for Attitude {
    const ABOUT: About = About {
        id: "rigid-body/attitude",
        title: "Attitude of a body",
        topic: "Motion in space",
        summary: "Direction cosine matrix, Euler angles of any sequence, principal axis and angle, Euler parameters and Rodrigues parameters of an attitude, each from any other; their rates and the angular velocity.",
        main: &["principal_angle", "principal_axis", "angular_velocity", "angular_acceleration"],
        keywords: "attitude orientation rotation matrix direction cosine DCM quaternion Euler angles parameters \
                   yaw pitch roll 3-2-1 3-1-3 principal axis angle Rodrigues Gibbs Cayley MRP CRP shadow set \
                   TRIAD Wahba Davenport gimbal lock atitude orientação matriz de rotação cossenos diretores \
                   quatérnio ângulos de Euler guinada arfagem rolamento eixo principal Tait-Bryan Cardan angles \
                   ângulos de Cardan",
        sources: &[&SCHAUB, &SHUSTER, &BEER],
        cases: include_str!("../../cases/attitude.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &AttitudeGiven<W>, sheet: W) -> Result<(), Refusal> {
        let rows = rows_of(&self.attitude, &given.attitude, sheet)?;
        let representations = answer_representations(rows, self.sequence, sheet);
        self.vectors(given, rows, sheet);
        if let (Some(rate), Some(known)) = (&self.rate, &given.rate) {
            let c = matrix(rows);
            // At gimbal lock only given angles have rates.
            let (angles, gimbal_lock) = match (&self.attitude, &given.attitude) {
                (
                    AttitudeInput::One(SingleAttitude::EulerAngles { sequence, .. }),
                    AttitudeInputGiven::One(SingleAttitudeGiven::EulerAngles {
                        first, second, third, ..
                    }),
                ) if *sequence == self.sequence => ([*first, *second, *third], false),
                _ => (representations.angles.angles, representations.angles.gimbal_lock),
            };
            let known = Known { rate, given: known };
            known.answer((rows, c), self.sequence, (angles, gimbal_lock), &representations, sheet)?;
        }
        let c = matrix(rows);
        sheet.show(|| frames("The frames N and B, and the principal axis", &c, &self.attitude));
        self.show(sheet);
        Ok(())
    }
}

impl Attitude {
    /// Components of the vectors in the other frame.
    fn vectors<W: Worksheet>(&self, given: &AttitudeGiven<W>, rows: [W::Vec; 3], sheet: W) {
        for (n, (vector, this)) in self.vectors.iter().zip(&given.vectors).enumerate() {
            let of = this.components;
            let (symbol, turned, why) = match vector.axes {
                FrameAxes::Fixed => {
                    let [x, y, z] = rows.map(|row| row.dot(of));
                    ("v_B", W::Vec::from_components(x, y, z), "Components in B: [BN] times those in N")
                }
                FrameAxes::Body => {
                    ("v_N", row_times(of, rows), "Components in N: the transpose [BN]ᵀ times those in B")
                }
            };
            let turned = sheet.step_vector((symbol, n + 1), "1", turned, (why, SCHAUB.at("§3.2")));
            sheet.answer_vector(("components", n + 1), "Components in the other axes", turned);
            sheet.verify(|| {
                let c = matrix(rows);
                let rotation = nalgebra::Rotation3::from_matrix_unchecked(c);
                let (plain, found) = (vector.components, turned.value());
                let back = match vector.axes {
                    FrameAxes::Fixed => rotation.inverse_transform_vector(&found) - plain,
                    FrameAxes::Body => rotation.transform_vector(&found) - plain,
                };
                let size = plain.norm();
                sheet.check_zero("the components changed back, less those given", back.norm().into(), size);
            });
        }
    }

    /// Euler angles over an angle of the attitude.
    fn show<W: Worksheet>(&self, sheet: W) {
        let AttitudeInput::One(one) = &self.attitude else { return };
        use std::f64::consts::TAU;
        let over = |title: &'static str,
                    label: &'static str,
                    input: &'static str,
                    at: &dyn Fn(f64) -> Matrix3<f64>| {
            let mut curves: [Vec<(f64, f64)>; 3] = Default::default();
            for n in 0..=180 {
                let angle = TAU * (f64::from(n) / 180.0 - 0.5);
                let found = plain_angles(self.sequence, &at(angle));
                curves.iter_mut().zip(found.angles).for_each(|(curve, y)| {
                    // A line that jumps from 180° to −180° is broken.
                    if let Some((x, before)) = curve.last().copied()
                        && (before - y).abs() > 0.5 * TAU
                    {
                        curve.push((f64::midpoint(x, angle), f64::INFINITY));
                    }
                    curve.push((angle, if found.gimbal_lock { f64::INFINITY } else { y }));
                });
            }
            let [first, second, third] = curves;
            Exhibit::Plot(
                Plot::new(
                    title,
                    Axis::linear(label, "deg"),
                    Axis::linear("Euler angle", "deg"),
                    vec![
                        Series::line("θ₁", first).of("euler_angle[1]"),
                        Series::line("θ₂", second).of("euler_angle[2]"),
                        Series::line("θ₃", third).of("euler_angle[3]"),
                    ],
                )
                .over(input),
            )
        };
        match *one {
            SingleAttitude::PrincipalRotation { axis, .. } => {
                let axis = nalgebra::Unit::new_normalize(axis);
                sheet.show(|| {
                    over(
                        "Euler angles against the principal angle",
                        "Principal angle",
                        "attitude.principal-rotation.angle",
                        &|angle| *nalgebra::Rotation3::from_axis_angle(&axis, -angle).matrix(),
                    )
                });
            }
            SingleAttitude::EulerAngles { sequence, first, third, .. } if sequence != self.sequence => {
                sheet.show(|| {
                    over(
                        "Euler angles against the second angle given",
                        "Second angle",
                        "attitude.euler-angles.second",
                        &|angle| sequence.product([first, angle, third]),
                    )
                });
            }
            SingleAttitude::EulerAngles { sequence, first, third, .. } => {
                sheet.show(|| {
                    let angle = |second: f64| {
                        let (scalar, vector) = plain_parameters(&sequence.product([first, second, third]));
                        2.0 * vector.norm().atan2(scalar)
                    };
                    let points = (0..=180)
                        .map(|n| TAU * (f64::from(n) / 180.0 - 0.5))
                        .map(|second| (second, angle(second)))
                        .collect();
                    Exhibit::Plot(
                        Plot::new(
                            "Principal angle against the second angle",
                            Axis::linear("Second angle", "deg"),
                            Axis::linear("Principal angle", "deg"),
                            vec![Series::line("Φ", points).of("principal_angle")],
                        )
                        .over("attitude.euler-angles.second"),
                    )
                });
            }
            _ => {}
        }
    }
}
