//! The motion of a rigid body in space: free, about a fixed point, under torques.

mod inputs;
mod pictures;
mod second_methods;

use std::{
    array,
    f64::consts::{PI, TAU},
};

use dalembert_core::{About, Analysis, Refusal, Text, Worksheet, register};
use dalembert_mechanics::{
    Real, Vector,
    rigid::{
        self,
        simulate::{
            self as follow, Loads, RotatingBody, RotationRun, RotationSample, RotationState, SimulateError,
            WatchedAngles,
        },
    },
};
use dalembert_numerics::ode::OdeError;
use nalgebra::{Quaternion, Rotation3, UnitQuaternion, Vector3};

pub use self::inputs::{
    Attitude, BodyAxis, InertiaPoint, Instant, Moments, Motion, MotionEvent, Pivot, TorqueAxes,
    TorqueHistory, TorqueRow, Velocity,
};
use self::inputs::{MomentsGiven, MotionGiven, PivotGiven};
use crate::{
    shared::differences::second_rate,
    sources::{BRULS, GOLDSTEIN, HAIRER, HAIRER_LUBICH_WANNER},
};

/// Error that each step may add, in parts of a radian and of the largest momentum.
const TOLERANCE: f64 = 1e-13;
/// Part of a radian that a step of a free motion turns by at most.
const RADIANS: f64 = 0.05;
/// Steps before a motion is given up, and those up to which a free motion is followed a second method.
const STEPS: usize = 40_000;
const FREE_STEPS: usize = 200_000;
const CHECKED: f64 = 100.0;
/// Moments of a motion that are shown.
const MOMENTS: usize = 481;

register!(Motion);

impl Analysis for Motion {
    const ABOUT: About = About {
        id: "rigid-body/motion",
        title: "Motion of a rigid body in space",
        topic: "Motion in space",
        summary: "A body that rotates freely, about a fixed point under gravity, or under torques: attitude and angular velocity over time, with the drift of energy and angular momentum.",
        main: &["omega_body", "omega", "initial_acceleration"],
        keywords: "simulation simulação free body corpo livre fixed point ponto fixo heavy top pião torque torque-free Euler quaternion movimento atitude giroscópio polhode tumbling",
        sources: &[&GOLDSTEIN, &HAIRER_LUBICH_WANNER, &HAIRER, &BRULS],
        cases: include_str!("../../cases/motion.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &MotionGiven<W>, sheet: W) -> Result<(), Refusal> {
        let (body, loads) = (self.body()?, self.loads());
        let from = RotationState { attitude: self.attitude.turned()?, omega_body: self.omega_body()? };
        let energy = self.start(given, sheet, &body, &loads, &from)?;
        sheet.keep_going()?;
        let ends: Vec<follow::RotationEvent> = self.end.end(self.axis).into_iter().collect();
        let cancelled = || sheet.keep_going().is_err();
        let run = RotationRun {
            duration: self.duration,
            tolerance: TOLERANCE,
            samples: MOMENTS,
            ends: &ends,
            most_steps: STEPS,
            cancelled: &cancelled,
        };
        let free = loads.torques.is_empty() && body.arm == Vector3::zeros() && ends.is_empty();
        let watched = Some(WatchedAngles { of: self.axis.vector(), against: Vector3::z() });
        let moved = if free {
            let run = RotationRun { most_steps: FREE_STEPS, ..run };
            follow::simulate_free_watching(&body, &from, RADIANS, &run, watched)
        } else {
            follow::simulate_watching(&body, &from, &loads, &run, watched)
        };
        sheet.keep_going()?;
        let moved = moved.map_err(|error| refusal(&error))?;
        self.finish(sheet, &body, (&loads, &run), &moved, (energy, free));
        if free {
            self.second_method(sheet, &body, &from, &run, &moved);
        }
        if moved.ended.is_none() && !ends.is_empty() {
            sheet.warn(|| "the motion does not come to its end within the duration; make this longer".into());
        }
        self.show(sheet, &body, &moved);
        Ok(())
    }
}

impl Motion {
    /// Momentum, energy and accelerations with which the motion begins.
    fn start<W: Worksheet>(
        &self,
        given: &MotionGiven<W>,
        sheet: W,
        body: &RotatingBody,
        loads: &Loads,
        from: &RotationState,
    ) -> Result<W::Num, Refusal> {
        let omega = sheet.numerical_vector(
            "ω",
            "rad/s",
            from.omega_body,
            "Angular velocity at the start, in body axes",
        );
        let principal = self.principal(given, sheet);
        let momentum = momentum(sheet, body, principal, omega);
        if let PivotGiven::FixedPoint { mass, centre, .. } = given.pivot {
            let what = "kinetic energy of translation added to that of the rotation about the fixed point";
            sheet.common_error("T_0", what, || {
                rigid::rotational_energy(omega, momentum)
                    + mass * omega.cross(centre).magnitude().powi(2) / 2.0
            });
        }
        let kinetic = sheet.step(
            "T_0",
            "J",
            rigid::rotational_energy(omega, momentum),
            ("Kinetic energy of rotation at the start: T = ω · H/2", GOLDSTEIN.at("§5.3")),
        );
        let moment = body.inertia * body.acceleration(from, loads).map_err(|error| refusal(&error))?
            + from.omega_body.cross(body.inertia * from.omega_body);
        let about = sheet.numerical_vector(
            "M",
            "N*m",
            clean(moment, moment.norm()),
            "Moment of weight and torques about the point at the start, in body axes",
        );
        let alpha = principal.map(|moments| euler_acceleration(moments, omega, about));
        let why = (
            "Angular acceleration at the start, from Euler's equations M = J α + ω × (J ω), in body axes",
            GOLDSTEIN.at("§5.5"),
        );
        let alpha = match alpha {
            Some(alpha) => sheet.step_vector("α", "rad/s^2", alpha, why),
            None => {
                let alpha = body.acceleration(from, loads).map_err(|error| refusal(&error))?;
                sheet.numerical_vector("α", "rad/s^2", clean(alpha, alpha.norm()), why)
            }
        };
        sheet.verify(|| {
            let left = body.inertia * alpha.value() + from.omega_body.cross(body.inertia * from.omega_body);
            let size = (body.inertia * alpha.value()).norm() + moment.norm();
            sheet.check_zero("Euler's equations at the start", (left - moment).norm().into(), size);
            let held = body.inertia * from.omega_body;
            let off = (momentum.value() - held).norm();
            let what = "angular momentum at the start from the tensor about the point";
            sheet.check_zero(what, off.into(), body.inertia.amax() * from.omega_body.norm());
        });
        let mut whole = kinetic;
        let weight = match given.pivot {
            PivotGiven::MassCentre {} => None,
            PivotGiven::FixedPoint { mass, centre, gravity, .. } => Some((mass, centre, gravity)),
            PivotGiven::Origin { gravity } => {
                let mass = sheet.numerical("m", "kg", body.mass, "Mass of the body as described");
                let reason = "Centre of mass of the body as described, from its origin";
                let centre = sheet.numerical_vector("r_G", "m", clean(body.arm, body.arm.norm()), reason);
                Some((mass, centre, gravity))
            }
        };
        if let Some((mass, centre, gravity)) = weight {
            let up = from.attitude.inverse() * Vector3::z();
            let up = sheet.numerical_vector(
                "u",
                "1",
                up,
                "The upward vertical at the start, in the axes of the body",
            );
            let what = "the distance of the centre of mass from the fixed point taken as its height";
            sheet.common_error("V_0", what, || mass * gravity * centre.magnitude());
            let potential = sheet.step(
                "V_0",
                "J",
                mass * gravity * centre.dot(up),
                "Potential energy at the start, relative to the level of the fixed point",
            );
            let energy = sheet.step("E", "J", kinetic + potential, "Energy at the start");
            sheet.answer("energy", "Energy at the start", energy);
            whole = energy;
            let acceleration = sheet.step_vector(
                "a_G",
                "m/s^2",
                alpha.cross(centre) + omega.cross(omega.cross(centre)),
                "Acceleration of the centre of mass at the start: α × r + ω × (ω × r), in body axes",
            );
            sheet.answer_vector(
                "initial_acceleration",
                "Acceleration of the centre of mass at the start",
                acceleration,
            );
            sheet.verify(|| {
                let (omega, alpha) = (from.omega_body, alpha.value());
                let place =
                    |t: f64| Rotation3::from_scaled_axis(omega * t + alpha * (t * t / 2.0)) * body.arm;
                let speed = omega.norm() + alpha.norm().sqrt();
                let Some(found) = second_rate(place, TAU / speed) else { return };
                let what = "acceleration of the centre of mass by finite differences of its position";
                let size = speed.powi(2) * body.arm.norm();
                sheet.check_zero(what, (found - acceleration.value()).norm().into(), size);
            });
        } else {
            sheet.answer("energy", "Energy at the start", kinetic);
        }
        sheet.answer_vector("momentum_body", "Angular momentum at the start, body axes", momentum);
        sheet.answer_vector("alpha_body", "Angular acceleration at the start, body axes", alpha);
        Ok(whole)
    }

    /// The principal moments about the point, where the axes of the body are principal there.
    fn principal<W: Worksheet>(&self, given: &MotionGiven<W>, sheet: W) -> Option<[W::Num; 3]> {
        let moments = match given.moments {
            MomentsGiven::Principal { x, y, z } => [x, y, z],
            MomentsGiven::Revolution { axial, transverse } => [transverse, transverse, axial],
            MomentsGiven::Tensor { .. } | MomentsGiven::Described { .. } => return None,
        };
        let (PivotGiven::FixedPoint { mass, centre, .. }, Pivot::FixedPoint { about, .. }) =
            (&given.pivot, &self.pivot)
        else {
            return Some(moments);
        };
        let off_axes = centre.value().iter().filter(|part| **part != 0.0).count();
        match about {
            InertiaPoint::FixedPoint => Some(moments),
            InertiaPoint::MassCentre if off_axes > 1 => None,
            InertiaPoint::MassCentre => {
                let distance = sheet.step(
                    "d",
                    "m",
                    centre.magnitude(),
                    "Distance of the centre of mass from the fixed point",
                );
                let reason = "Parallel-axis theorem: the moment of inertia about the fixed point is larger by m d² transverse to the line to the centre of mass, and the same along it";
                let symbols = ["J_x", "J_y", "J_z"];
                Some(array::from_fn(|n| {
                    let along = centre.value()[n] != 0.0;
                    let moment =
                        if along { moments[n] } else { rigid::parallel_axis(moments[n], *mass, distance) };
                    sheet.step(symbols[n], "kg*m^2", moment, reason)
                }))
            }
        }
    }

    /// Final state of the motion, and its accuracy.
    fn finish<W: Worksheet>(
        &self,
        sheet: W,
        body: &RotatingBody,
        (loads, run): (&Loads, &RotationRun<'_>),
        moved: &follow::RigidBodyMotion,
        (energy, free): (W::Num, bool),
    ) {
        let last = moved.samples.last().expect("a motion has its start");
        let how = if free {
            (
                Text::new(
                    "The momentum in the body follows Ḣ = H × ω by the Gauss method of order 6, which keeps energy and |H|; the attitude follows by exponentials of the mean angular velocity",
                ),
                HAIRER_LUBICH_WANNER.at("§IV.2.1, §VII.5"),
            )
        } else {
            (
                Text::new(
                    "Attitude (a unit quaternion) and angular momentum are integrated by the Dormand–Prince method of order 8 with step-size control; for a body of revolution, in axes that do not spin with it",
                ),
                HAIRER.at("§II.5"),
            )
        };
        let time = sheet.numerical("t", "s", last.time, how);
        sheet.answer("time", "Time at the end", time);
        let most = |of: fn(&RotationSample) -> Vector3<f64>| {
            moved.samples.iter().map(|sample| of(sample).norm()).fold(0.0, f64::max)
        };
        let fastest = most(|sample| sample.omega);
        let vector = |symbol: &'static str, unit: &'static str, value, reason: &'static str| {
            sheet.numerical_vector(symbol, unit, value, reason)
        };
        let in_body = vector(
            "ω_xyz",
            "rad/s",
            clean(last.turning.omega_body, fastest),
            "Angular velocity at the end, in body axes",
        );
        sheet.answer_vector("omega_body", "Angular velocity at the end, body axes", in_body);
        let in_space = vector(
            "ω_XYZ",
            "rad/s",
            clean(last.omega, fastest),
            "Angular velocity at the end, in the fixed axes",
        );
        sheet.answer_vector("omega", "Angular velocity at the end, fixed axes", in_space);
        let momentum = vector(
            "H_XYZ",
            "kg*m^2/s",
            clean(last.momentum, most(|sample| sample.momentum)),
            "Angular momentum about the point at the end, in the fixed axes",
        );
        sheet.answer_vector("momentum", "Angular momentum at the end, fixed axes", momentum);
        let quaternion = last.turning.attitude.into_inner();
        let scalar = sheet.numerical(
            "q0",
            "1",
            quaternion.w,
            "Attitude at the end as a unit quaternion: its real part",
        );
        sheet.answer("quaternion_real", "Attitude at the end, unit quaternion, real part", scalar);
        let parts =
            vector("q", "1", clean(quaternion.imag(), 1.0), "The other three components of that quaternion");
        sheet.answer_vector("quaternion", "Attitude at the end, unit quaternion, the other parts", parts);
        let integrated = last.turning.attitude * self.axis.vector();
        let axis =
            vector("a", "1", clean(integrated, 1.0), "Direction of the tracked axis of the body at the end");
        sheet.answer_vector("axis", "Direction of the axis at the end", axis);
        if let Some(tilts) = moved.angles {
            let why = "Minimum angle of the axis to the vertical Z over the motion";
            let least = sheet.numerical("θ_min", "deg", clean_angle(tilts.least.value), why);
            sheet.answer("least_tilt", "Minimum angle of the axis to Z", least);
            let why = "Maximum angle of the axis to the vertical Z over the motion";
            let largest = sheet.numerical("θ_max", "deg", clean_angle(tilts.largest.value), why);
            sheet.answer("largest_tilt", "Maximum angle of the axis to Z", largest);
            sheet.verify(|| {
                let axis = self.axis.vector();
                second_methods::tilts(
                    body,
                    loads,
                    run,
                    moved,
                    axis,
                    [(least, tilts.least), (largest, tilts.largest)],
                    sheet,
                );
            });
        }
        let mut centre_shown = None;
        if body.arm != Vector3::zeros() {
            let centre = last.turning.attitude * body.arm;
            let centre = vector(
                "r_Ge",
                "m",
                clean(centre, body.arm.norm()),
                "Centre of mass at the end, from the fixed point",
            );
            sheet.answer_vector("centre", "Centre of mass at the end, fixed axes", centre);
            centre_shown = Some(centre.value());
        }
        let kinetic = sheet.numerical("T", "J", last.kinetic, "Kinetic energy of rotation at the end");
        sheet.answer("kinetic_energy", "Kinetic energy at the end", kinetic);
        sheet.verify(|| {
            let parts = parts.value();
            let attitude = Quaternion::new(scalar.value(), parts.x, parts.y, parts.z);
            sheet.check("the quaternion has unit norm", W::Num::from(attitude.norm()), W::Num::from(1.0));
            let attitude = UnitQuaternion::new_normalize(attitude);
            if let Some(centre) = centre_shown {
                let what = "the centre of mass, rotated from the body axes";
                sheet.check_zero(what, (attitude * body.arm - centre).norm().into(), body.arm.norm());
            }
            if let Some(end) = second_methods::integrated(body, loads, run, moved, time.value()) {
                let what = "the attitude at the end, continued from the previous instant";
                let off = end.attitude.angle_to(&attitude);
                sheet.check_residual(what, off.into(), 1.0, second_methods::INTEGRATION_ERROR);
            }
            let left = last.kinetic + last.potential - last.work;
            let size =
                last.kinetic.abs().max(energy.value().abs()).max(last.potential.abs()).max(last.work.abs());
            let what = "energy at the end, less the work of the torques";
            let lost =
                moved.energy_drift() * moved.samples.iter().map(second_methods::energy).fold(size, f64::max);
            sheet.check_residual(what, (energy.value() - left).into(), size, lost);
            let (turns, spin) = (in_space.value(), in_body.value());
            sheet.check_zero(
                "the angular velocity, rotated from the body axes",
                (attitude * spin - turns).norm().into(),
                fastest,
            );
            let held = momentum.value();
            sheet.check_zero(
                "the angular momentum is R J Rᵀ ω",
                (attitude * (body.inertia * (attitude.inverse() * turns)) - held).norm().into(),
                most(|sample| sample.momentum),
            );
            sheet.check_sum(
                "the kinetic energy is half of ω · H",
                kinetic,
                (turns.dot(held) / 2.0).into(),
                turns.norm() * held.norm(),
            );
            sheet.check_zero(
                "the tracked axis, rotated from the body axes",
                (attitude * self.axis.vector() - axis.value()).norm().into(),
                1.0,
            );
        });
        self.drift(sheet, body, moved);
    }

    /// Drift of energy and angular momentum.
    fn drift<W: Worksheet>(&self, sheet: W, body: &RotatingBody, moved: &follow::RigidBodyMotion) {
        let weight = (body.arm != Vector3::zeros()).then(Vector3::z);
        let (energy, momentum) = (moved.energy_drift(), moved.momentum_drift(weight));
        let bound = sheet.numerical(
            "δ_E",
            "1",
            next_power(energy),
            "Bound on |T + V − W − E₀| over the motion, relative to the maximum energy",
        );
        sheet.answer("energy_drift", "Energy conserved to within", bound);
        let reason = if weight.is_some() {
            "Bound on |H_Z − ∫M_Z dt − H_Z0| over the motion, relative to the maximum |H|: the weight has no moment about the vertical"
        } else {
            "Bound on |H − ∫M dt − H₀| over the motion, relative to the maximum |H|"
        };
        let bound = sheet.numerical("δ_H", "1", next_power(momentum), reason);
        sheet.answer("momentum_drift", "Angular momentum conserved to within", bound);
        if energy.max(momentum) > 1e-9 {
            sheet.warn(|| "energy and angular momentum are not conserved to nine digits: the last digits of the motion are unreliable".into());
        } else {
            sheet.check_zero("the energy balance T + V − W over the motion", energy.into(), 1.0);
            sheet.check_zero("the balance of angular momentum over the motion", momentum.into(), 1.0);
        }
    }

    /// A free motion followed with steps that only hold the error.
    fn second_method<W: Worksheet>(
        &self,
        sheet: W,
        body: &RotatingBody,
        from: &RotationState,
        run: &RotationRun,
        moved: &follow::RigidBodyMotion,
    ) {
        sheet.verify(|| {
            if from.omega_body.norm() * self.duration > CHECKED {
                return;
            }
            let run = RotationRun { samples: 2, ..*run };
            let end = |omega_body: Vector3<f64>| {
                let from = RotationState { omega_body, ..*from };
                let moved = follow::simulate(body, &from, &Loads::default(), &run).ok()?;
                Some(moved.samples.last()?.turning.attitude)
            };
            // Each radian adds an error of the order of the tolerance, and a rotation about nearly the intermediate axis
            // multiplies it: by as much as another velocity at the start changes the end.
            const CHANGE: f64 = 1e-8;
            let omega = from.omega_body;
            let aside = omega + Vector3::repeat(CHANGE * omega.norm());
            let (Some(last), Some(other), Some(changed)) = (moved.samples.last(), end(omega), end(aside))
            else {
                return;
            };
            sheet.check_residual(
                "the attitude at the end by the Dormand–Prince method",
                last.turning.attitude.angle_to(&other).into(),
                1.0,
                changed.angle_to(&other) / CHANGE * run.tolerance * (omega.norm() * self.duration).max(1.0),
            );
        });
    }
}

/// `H = J ω`, in principal axes where they are known, otherwise with the rows of the tensor.
fn momentum<W: Worksheet>(
    sheet: W,
    body: &RotatingBody,
    principal: Option<[W::Num; 3]>,
    omega: W::Vec,
) -> W::Vec {
    let why = ("Angular momentum about the point at the start: H = J ω", GOLDSTEIN.at("§5.1"));
    if let Some(moments) = principal {
        return sheet.step_vector("H", "kg*m^2/s", rigid::angular_momentum(moments, omega), why);
    }
    let row = |n: usize, symbol: &'static str| {
        let row = clean(body.inertia.row(n).transpose(), body.inertia.amax());
        let reason = "Row of the inertia tensor about the point: J = J_G + m (r² 1 − r rᵀ)";
        sheet.numerical_vector(symbol, "kg*m^2", row, reason)
    };
    let rows = [row(0, "J_1"), row(1, "J_2"), row(2, "J_3")];
    let [x, y, z] = rows.map(|row| row.dot(omega));
    sheet.step_vector("H", "kg*m^2/s", W::Vec::from_components(x, y, z), why)
}

/// `α = J⁻¹ (M − ω × Jω)` in principal axes.
fn euler_acceleration<V: Vector>([x, y, z]: [V::Scalar; 3], omega: V, moment: V) -> V {
    let ([omega_x, omega_y, omega_z], [moment_x, moment_y, moment_z]) =
        (omega.components(), moment.components());
    V::from_components(
        (moment_x + (y - z) * omega_y * omega_z) / x,
        (moment_y + (z - x) * omega_z * omega_x) / y,
        (moment_z + (x - y) * omega_x * omega_y) / z,
    )
}

/// The power of ten that bounds a drift, from 10⁻¹² on: what is less is rounding.
fn next_power(drift: f64) -> f64 {
    10.0_f64.powi((-12..0).find(|power| drift <= 10.0_f64.powi(*power)).unwrap_or(0))
}

/// Flushes components that are rounding noise beside the largest to zero.
fn clean(vector: Vector3<f64>, largest: f64) -> Vector3<f64> {
    vector.map(|x| if x.abs() > 1e-12 * largest { x } else { 0.0 })
}

/// An angle to a direction, without the rounding of one along it.
fn clean_angle(angle: f64) -> f64 {
    const ROUNDING: f64 = 1e-9;
    if angle < ROUNDING {
        0.0
    } else if PI - angle < ROUNDING {
        PI
    } else {
        angle
    }
}

fn refusal(error: &SimulateError) -> Refusal {
    match error {
        SimulateError::Inertia => Refusal::because(
            "these are not the moments of inertia of a body: the principal moments must all be positive; correct the moments or the products of inertia",
        ),
        SimulateError::Motion(OdeError::TooManySteps { .. }) => Refusal::because(
            "the motion requires too many steps: the body makes too many revolutions in this duration; make it shorter",
        ),
        SimulateError::NotFinite | SimulateError::Step { .. } | SimulateError::Motion(_) => Refusal::because(
            "the motion cannot be integrated with these values: they are too large or too small relative to each other",
        ),
    }
}
