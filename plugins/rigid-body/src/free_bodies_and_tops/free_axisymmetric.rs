//! A body of revolution on which no moment acts.

mod pictures;

use std::f64::consts::TAU;

use dalembert_core::{
    About, Analysis, Axis, Exhibit, Inputs, Plot, Refusal, Series, Text, Worksheet, register,
};
use dalembert_mechanics::{
    Real, Vector,
    rigid::{self, torque_free},
};
use nalgebra::Vector3;

use crate::{
    shared::body::Shape,
    sources::{BEER, GOLDSTEIN},
};

/// The body and how it was thrown.
///
/// The axes x, y and z are fixed in the body at its centre of mass, z along its axis; fixed axes agree with them at the
/// start.
#[derive(Clone, Debug, Inputs)]
pub struct FreeAxisymmetric {
    /// Moments of inertia.
    pub inertia: AxisymmetricInertia,
    /// Given.
    pub motion: FreeMotionInput,
    /// Instant.
    /// If given, the angular velocity and attitude at this time after the start are also calculated.
    #[input("t", "s", nonnegative)]
    pub instant: Option<f64>,
}

/// Moments of inertia about the centre of mass, or their ratio.
#[derive(Clone, Debug, Inputs)]
pub enum AxisymmetricInertia {
    /// Moments of inertia
    Moments {
        /// Moment of inertia about the axis.
        #[input("I_a", "kg*m^2", positive)]
        axial: f64,
        /// Transverse moment of inertia.
        #[input("I_t", "kg*m^2", positive)]
        transverse: f64,
    },
    /// Mass and radii of gyration
    Gyration {
        /// Mass.
        #[input("m", "kg", positive)]
        mass: f64,
        /// Radius of gyration about the axis.
        #[input("k_a", "m", positive)]
        axial: f64,
        /// Transverse radius of gyration.
        #[input("k_t", "m", positive)]
        transverse: f64,
    },
    /// A shape
    /// Its own z axis is the axis of symmetry.
    Shape {
        /// Mass.
        #[input("m", "kg", positive)]
        mass: f64,
        /// Shape.
        shape: Shape,
    },
    /// Their ratio only
    Ratio {
        /// Ratio of axial to transverse moment of inertia.
        /// At most 2, for a thin plate; small for a long rod.
        #[input("r", "1", positive)]
        ratio: f64,
    },
}

/// Known quantity of the motion.
#[derive(Clone, Debug, Inputs)]
pub enum FreeMotionInput {
    /// Angular velocity and its angle to the axis
    Speed {
        /// Angular velocity.
        #[input("ω", "rad/s", positive)]
        speed: f64,
        /// Angle between angular velocity and axis.
        #[input("β", "deg", nonnegative, max = 180)]
        angle: f64,
    },
    /// Components of the angular velocity
    Components {
        /// Angular velocity at the start, body axes.
        #[input("ω₀", "rad/s")]
        velocity: Vector3<f64>,
    },
    /// Angular momentum and its angle to the axis
    Momentum {
        /// Angular momentum about the centre of mass.
        #[input("H_G", "kg*m^2/s", positive)]
        momentum: f64,
        /// Angle between angular momentum and axis.
        #[input("θ", "deg", nonnegative, max = 180)]
        angle: f64,
    },
    /// Precession and angle to the angular momentum
    Precession {
        /// Precession.
        /// About the direction of the angular momentum.
        #[input("φ̇", "rad/s", positive)]
        precession: f64,
        /// Angle between angular momentum and axis.
        #[input("θ", "deg", nonnegative, max = 180)]
        angle: f64,
    },
    /// Spin and angle to the angular momentum
    Spin {
        /// Magnitude of the spin.
        /// About the axis, relative to the precessing frame. Its sense depends on the body.
        #[input("ψ̇_m", "rad/s", positive)]
        spin: f64,
        /// Angle between angular momentum and axis.
        #[input("θ", "deg", nonnegative, below = 90)]
        angle: f64,
    },
}

register!(FreeAxisymmetric);

impl Analysis for FreeAxisymmetric {
    const ABOUT: About = About {
        id: "rigid-body/free-axisymmetric",
        title: "Body of revolution in free motion",
        topic: "Free bodies and tops",
        summary: "Torque-free motion of a body of revolution: precession and spin, direct or retrograde, body and space cones, angular velocity and attitude at an instant.",
        main: &["precession", "nutation", "spin"],
        keywords: "torque-free satellite wobble precession body cone space cone Chandler Euler satélite corpo livre cone precessão retrógrada",
        sources: &[&BEER, &GOLDSTEIN],
        cases: include_str!("../../cases/free_axisymmetric.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &FreeAxisymmetricGiven<W>, sheet: W) -> Result<(), Refusal> {
        let body = AxisymmetricBody::of(&given.inertia, sheet)?;
        if body.ratio.value() > 2.0 * (1.0 + 1e-9) {
            return Err(Refusal::because(
                "no body has a moment about its axis above twice its transverse moment: a thin plate has exactly twice",
            ));
        }
        let ratio = body.ratio;
        let (axial, transverse, start) = velocities(&given.motion, &body, sheet)?;
        if axial.value() == 0.0 && transverse.value() == 0.0 {
            return Err(Refusal::because("the body does not turn: give an angular velocity"));
        }
        let theta = sheet.step(
            "θ",
            "deg",
            torque_free::nutation(ratio, axial, transverse),
            (
                "Angle between the axis and the angular momentum: tan θ = H_t/H_a = ω_t/(r ω_a)",
                BEER.at("§18.3"),
            ),
        );
        let beta = sheet.step(
            "β",
            "deg",
            torque_free::velocity_angle(axial, transverse),
            ("Angle between the axis and the angular velocity", BEER.at("§18.3")),
        );
        sheet.common_error("φ̇", "H_G divided by the moment of inertia about the axis", || {
            torque_free::precession(ratio, axial, transverse) / ratio
        });
        sheet.common_error("φ̇", "the spin used in place of ω_a in the axial component of H_G", || {
            ratio * torque_free::spin(ratio, axial) / theta.cos()
        });
        let precession = sheet.step(
            "φ̇",
            "rad/s",
            torque_free::precession(ratio, axial, transverse),
            ("Precession of the axis about the angular momentum, H_G/I_t", BEER.at("§18.3")),
        );
        let r = ratio.value();
        sheet.common_error("ψ̇", "the whole precession subtracted from ω_a", || axial - precession);
        sheet.common_error("ψ̇", "the difference of the moments of inertia divided by I_a", || {
            torque_free::spin(ratio, axial) / ratio
        });
        let spin = sheet.step(
            "ψ̇",
            "rad/s",
            torque_free::spin(ratio, axial),
            (
                if r < 1.0 {
                    "Spin about the axis. The body is long, r < 1: direct precession, spin and precession have the same sense, and the body cone rolls on the outside of the space cone"
                } else if r > 1.0 {
                    "Spin about the axis. The body is flat, r > 1: retrograde precession, spin and precession have opposite senses, and the body cone rolls around the space cone inside it"
                } else {
                    "Spin about the axis: zero, since with r = 1 all axes are equivalent and the body rotates about its angular momentum"
                },
                BEER.at("§18.3"),
            ),
        );
        let body_cone = sheet.step(
            "γ_b",
            "deg",
            transverse.atan2(axial.abs()),
            "Half-angle of the body cone, traced by the angular velocity about the axis",
        );
        let space_cone = sheet.step(
            "γ_s",
            "deg",
            (beta - theta).abs(),
            "Half-angle of the space cone, traced by the angular velocity about the angular momentum: the angle between the two",
        );
        let wobble = sheet.step(
            "T_φ",
            "s",
            W::Num::from(TAU) / precession,
            "Precession period, seen by a fixed observer",
        );
        sheet.answer("nutation", "Angle between axis and angular momentum", theta);
        sheet.answer("velocity_angle", "Angle between axis and angular velocity", beta);
        sheet.answer("precession", "Precession", precession);
        let label = if r < 1.0 {
            "Spin, in direct precession"
        } else if r > 1.0 {
            "Spin, in retrograde precession"
        } else {
            "Spin"
        };
        sheet.answer("spin", label, spin);
        sheet.answer("body_cone", "Half-angle of the body cone", body_cone);
        sheet.answer(
            "space_cone",
            "Angle between angular velocity and angular momentum, the half-angle of the space cone",
            space_cone,
        );
        sheet.answer("precession_period", "Precession period", wobble);
        sheet.common_error("|ω|", "precession and spin combined as if they were at right angles", || {
            (precession.powi(2) + spin.powi(2)).sqrt()
        });
        let speed = sheet.step(
            "|ω|",
            "rad/s",
            (axial.powi(2) + transverse.powi(2)).sqrt(),
            "Magnitude of the angular velocity",
        );
        sheet.answer("speed", "Angular velocity", speed);
        sheet.verify(|| {
            let size = precession.value() + spin.value().abs();
            sheet.check_zero(
                "precession and spin have no component normal to the angular velocity",
                precession * (theta - beta).sin() - spin * beta.sin(),
                size,
            );
            sheet.check_sum(
                "precession and spin along the angular velocity",
                precession * (theta - beta).cos() + spin * beta.cos(),
                speed,
                size,
            );
            sheet.check_sum(
                "the cones roll on each other without sliding",
                precession * space_cone.sin(),
                spin.abs() * body_cone.sin(),
                size,
            );
        });
        sheet.answer("axial_velocity", "Angular velocity about the axis", axial);
        if spin.value() != 0.0 {
            let around = sheet.step(
                "T_b",
                "s",
                W::Num::from(TAU) / spin.abs(),
                "Period of the angular velocity about the axis, relative to the body",
            );
            let wobbles =
                sheet.step("n", "1", precession / spin, "Precession revolutions per spin revolution");
            sheet.answer("body_period", "Period of the angular velocity about the axis", around);
            sheet.answer("wobbles_per_turn", "Precession revolutions per spin revolution", wobbles);
            sheet.verify(|| {
                // I_t φ̇ cos θ and I_a ω_a are the angular momentum about the axis.
                let of_axis = wobbles * (W::Num::from(1.0) - ratio) * theta.cos();
                let size = r + (wobbles.value() * (1.0 - r)).abs();
                sheet.check_sum("angular momentum about the axis for each spin", of_axis, ratio, size);
            });
        }
        if let Some((axial_moment, transverse_moment)) = body.moments {
            sheet.common_error("H_G", "the axial moment of inertia times the whole angular velocity", || {
                axial_moment * speed
            });
            let momentum = sheet.step(
                "H_G",
                "kg*m^2/s",
                transverse_moment * precession,
                ("Angular momentum about the centre of mass, which is conserved", BEER.at("§18.3")),
            );
            let across =
                sheet.step("H_t", "kg*m^2/s", transverse_moment * transverse, "Its transverse component");
            sheet.answer("transverse_momentum", "Transverse angular momentum", across);
            sheet.common_error("T", "½ I_a ω² taken, with the whole angular velocity", || {
                axial_moment * speed.powi(2) / 2.0
            });
            sheet.common_error("T", "the spin and the precession used as the two components of ω", || {
                (axial_moment * spin.powi(2) + transverse_moment * precession.powi(2)) / 2.0
            });
            let energy = sheet.step(
                "T",
                "J",
                (axial_moment * axial.powi(2) + transverse_moment * transverse.powi(2)) / 2.0,
                "Kinetic energy of rotation, which is also conserved",
            );
            sheet.answer("angular_momentum", "Angular momentum about the centre of mass", momentum);
            sheet.answer("rotational_energy", "Kinetic energy of rotation", energy);
            sheet.check_sum(
                "transverse angular momentum from its magnitude and angle",
                momentum * theta.sin(),
                across,
                momentum.value(),
            );
            sheet.check_sum(
                "angular momentum about the axis from its magnitude and angle",
                momentum * theta.cos(),
                axial_moment * axial,
                momentum.value(),
            );
            sheet.check_sum(
                "twice the energy as angular momentum times angular velocity along it",
                energy * 2.0,
                momentum * speed * space_cone.cos(),
                momentum.value() * speed.value(),
            );
        }
        sheet.verify(|| {
            let zero = W::Num::from(0.0);
            sheet.check_vector(
                "the angular velocity recomposed from precession and spin",
                W::Vec::from_components(precession * theta.sin(), zero, precession * theta.cos() + spin),
                W::Vec::from_components(transverse, zero, axial),
            );
            // Seen from the body ω goes around the axis at −ψ̇.
            let [x, y, z] = start.components();
            let one = W::Num::from(1.0);
            let moment = rigid::euler_moment(
                [one, one, ratio],
                start,
                W::Vec::from_components(spin * y, -(spin * x), zero),
            );
            sheet.check_zero(
                "Euler's equations with zero moment",
                moment.magnitude(),
                x.value().hypot(y.value()) * (z.value().abs() + transverse.value()),
            );
        });
        if let (Some(t), Some(instant)) = (self.instant, given.instant) {
            at_instant(t, instant, ratio, start, precession, spin, sheet);
        }
        let (r, omega) = (ratio.value(), start.value());
        sheet.show(|| Exhibit::Drawing(self.cones_in_section(r, omega)));
        sheet.show(|| pictures::rolling_cones(r, omega));
        sheet.show(|| Exhibit::Plot(components(r, omega)));
        Ok(())
    }
}

/// Parameters of the body in the motion.
struct AxisymmetricBody<N> {
    ratio: N,
    /// About the axis and across it.
    moments: Option<(N, N)>,
}

impl<N: Real> AxisymmetricBody<N> {
    fn of<W: Worksheet<Num = N>>(inertia: &AxisymmetricInertiaGiven<W>, sheet: W) -> Result<Self, Refusal> {
        let (axial, transverse) = match inertia {
            AxisymmetricInertiaGiven::Ratio { ratio } => return Ok(Self { ratio: *ratio, moments: None }),
            AxisymmetricInertiaGiven::Shape { mass, shape } => {
                shape.axial_and_transverse(*mass, "I_t", sheet)?.into()
            }
            AxisymmetricInertiaGiven::Moments { axial, transverse } => (*axial, *transverse),
            AxisymmetricInertiaGiven::Gyration { mass, axial, transverse } => (
                sheet.step(
                    "I_a",
                    "kg*m^2",
                    rigid::moment_by_gyration(*mass, *axial),
                    "Moment of inertia about the axis from its radius of gyration",
                ),
                sheet.step(
                    "I_t",
                    "kg*m^2",
                    rigid::moment_by_gyration(*mass, *transverse),
                    "Transverse moment of inertia from its radius of gyration",
                ),
            ),
        };
        let why = "Ratio of the moments of inertia: above 1 for a flat body, below 1 for a long one";
        let ratio = sheet.step("r", "1", axial / transverse, why);
        Ok(Self { ratio, moments: Some((axial, transverse)) })
    }
}

/// `ω_a`, `ω_t` and the angular velocity at the start in axes of the body.
fn velocities<W: Worksheet>(
    motion: &FreeMotionInputGiven<W>,
    body: &AxisymmetricBody<W::Num>,
    sheet: W,
) -> Result<(W::Num, W::Num, W::Vec), Refusal> {
    const ALONG: &str = "Angular velocity about the axis";
    const ACROSS: &str = "Transverse angular velocity";
    let along = |value, why: &'static str| sheet.step("ω_a", "rad/s", value, why);
    let across = |value, why: &'static str| sheet.step("ω_t", "rad/s", value, why);
    let ratio = body.ratio;
    let (axial, transverse) = match motion {
        FreeMotionInputGiven::Components { velocity } => {
            let [x, y, z] = velocity.components();
            let axial = along(z, ALONG);
            let transverse = across((x.powi(2) + y.powi(2)).sqrt(), ACROSS);
            return Ok((axial, transverse, *velocity));
        }
        FreeMotionInputGiven::Speed { speed, angle } => {
            (along(*speed * angle.cos(), ALONG), across(*speed * angle.sin(), ACROSS))
        }
        FreeMotionInputGiven::Momentum { momentum, angle } => {
            let Some((axial, transverse)) = body.moments else {
                return Err(Refusal::because(
                    "the angular momentum defines the motion only together with the moments of inertia: give them, or the angular velocity",
                ));
            };
            (
                along(*momentum * angle.cos() / axial, "Angular velocity about the axis, H_a/I_a"),
                across(*momentum * angle.sin() / transverse, "Transverse angular velocity, H_t/I_t"),
            )
        }
        FreeMotionInputGiven::Precession { precession, angle } => (
            along(
                *precession * angle.cos() / ratio,
                "Angular velocity about the axis: I_a ω_a = H_G cos θ with H_G = I_t φ̇",
            ),
            across(*precession * angle.sin(), "Transverse angular velocity: the component of the precession"),
        ),
        FreeMotionInputGiven::Spin { spin, angle } => {
            if ratio.value() == 1.0 {
                return Err(Refusal::because(
                    "a body whose moments of inertia are equal does not spin about its axis: give the precession or the angular velocity",
                ));
            }
            let axial = along(
                *spin / (W::Num::from(1.0) - ratio).abs(),
                "Angular velocity about the axis, from ψ̇ = (1 − r) ω_a",
            );
            (axial, across(ratio * axial * angle.tan(), "Transverse angular velocity: tan θ = ω_t/(r ω_a)"))
        }
    };
    Ok((axial, transverse, W::Vec::from_components(transverse, W::Num::from(0.0), axial)))
}

/// Angular velocity and attitude at an instant.
fn at_instant<W: Worksheet>(
    t: f64,
    instant: W::Num,
    ratio: W::Num,
    start: W::Vec,
    precession: W::Num,
    spin: W::Num,
    sheet: W,
) {
    let [x, y, z] = start.components();
    let back = sheet.step(
        "ψ",
        "rad",
        spin * instant,
        "Spin angle; relative to the body the angular velocity rotates backwards by it",
    );
    let velocity = sheet.step_vector(
        "ω",
        "rad/s",
        rigid::to_rotating_axes(rigid::Axis::Z, back, start),
        ("Angular velocity at the instant, body axes", GOLDSTEIN.at("§5-6")),
    );
    sheet.answer_vector("velocity", "Angular velocity at the instant, body axes", velocity);
    let turn = sheet.step("φ", "rad", precession * instant, "Angle of the precession");
    let [along_x, along_y, along_z] = [x, y, ratio * z].map(|part| part / precession);
    let along = sheet.step_vector(
        "h",
        "1",
        W::Vec::from_components(along_x, along_y, along_z),
        "Direction of the angular momentum in the initial axes",
    );
    let [h_x, h_y, h_z] = along.components();
    let (cos_turn, sin_turn) = ((turn / 2.0).cos(), (turn / 2.0).sin());
    let (cos_spin, sin_spin) = ((back / 2.0).cos(), (back / 2.0).sin());
    let parts = [
        cos_turn * cos_spin - h_z * sin_turn * sin_spin,
        sin_turn * (h_x * cos_spin + h_y * sin_spin),
        sin_turn * (h_y * cos_spin - h_x * sin_spin),
        cos_turn * sin_spin + h_z * sin_turn * cos_spin,
    ];
    const WHY: [&str; 4] = [
        "Attitude as a unit quaternion, the product of the rotations φ about h and ψ about the axis: its scalar part",
        "Its component along x",
        "Its component along y",
        "Its component along z",
    ];
    const LABELS: [&str; 4] = [
        "Attitude quaternion, scalar part",
        "Attitude quaternion, x component",
        "Attitude quaternion, y component",
        "Attitude quaternion, z component",
    ];
    let mut shown = [0.0; 4];
    for (n, part) in parts.into_iter().enumerate() {
        let part = sheet.step(("q", n + 1), "1", part, WHY[n]);
        sheet.answer(("quaternion", n + 1), LABELS[n], part);
        shown[n] = part.value();
    }
    sheet.verify(|| {
        // The derivative of R x at the instant is ω × R x, with ω in fixed axes.
        let (r, omega) = (ratio.value(), start.value());
        let side =
            |time: f64| torque_free::axisymmetric_attitude(r, omega, time) * Vector3::new(0.6, 0.0, 0.8);
        let now = torque_free::axisymmetric_attitude(r, omega, t) * velocity.value();
        let period = TAU / (precession.value() + spin.value().abs());
        if let Ok(rate) = rigid::numerical_rate(|time| side(t + time), period) {
            sheet.check_zero(
                "the attitude from its rate: the difference quotient of R compared with ω × R",
                W::Num::from((rate - now.cross(side(t))).norm()),
                omega.norm().max(1e-3 * t / period / period),
            );
        }
        let attitude = torque_free::axisymmetric_attitude(r, omega, t);
        let [w, x, y, z] = shown;
        let by_quaternion = nalgebra::UnitQuaternion::new_unchecked(nalgebra::Quaternion::new(w, x, y, z));
        let gap = attitude * omega - by_quaternion * omega;
        sheet.check_zero("the same rotation by matrices", W::Num::from(gap.norm()), omega.norm());
    });
}

/// Axis and angular velocity from the angular momentum on, towards the axis, rad; the angles of the cones.
fn angles(ratio: f64, omega: Vector3<f64>) -> (f64, f64) {
    let transverse = omega.xy().norm();
    // Drawn with the end of the axis that lies along the angular velocity.
    let axial = omega.z.abs();
    (f64::atan2(transverse, ratio * axial), f64::atan2(transverse, axial))
}

/// Components of the angular velocity in axes of the body.
fn components(ratio: f64, omega: Vector3<f64>) -> Plot {
    let spin = torque_free::spin(ratio, omega.z).abs();
    let period = TAU / if spin > 0.0 { spin } else { omega.norm() };
    let along = |axis: usize| {
        (0..=200)
            .map(|n| 2.0 * period * f64::from(n) / 200.0)
            .map(|t| (t, torque_free::axisymmetric_velocity(ratio, omega, t)[axis]))
            .collect::<Vec<_>>()
    };
    Plot::new(
        "Angular velocity in body axes",
        Axis::linear("time", "s"),
        Axis::linear("angular velocity", "rad/s"),
        [("ω_x", "velocity.x"), ("ω_y", "velocity.y"), ("ω_z", "velocity.z")]
            .into_iter()
            .enumerate()
            .map(|(n, (name, answer))| Series::line(Text::from(name), along(n)).of(answer))
            .collect(),
    )
    .over("instant")
}
