//! The motion of a rigid body that turns about its centre of mass or about a fixed point, from a start.
//!
//! Axes fixed in the body are turned into those in space by the attitude. Euler's equations are followed in principal
//! axes; for a body with two equal moments in axes that do not take part in its spin, so that the step is as long
//! as the axis moves slowly (H. Goldstein, C. Poole, J. Safko, *Classical Mechanics*, 3rd ed., §5.5 to §5.7).

mod free;
mod machine;

use nalgebra::{DMatrix, Matrix3, UnitQuaternion, Vector3};

pub use self::free::FreeRotation;
use self::machine::RotationSystem;
use dalembert_numerics::{
    extremes::{Extremes, Sampling},
    linalg::symmetric_eigen,
    ode::{self, Integrator, OdeError},
};

/// Reason for which a motion cannot be computed.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum SimulateError {
    /// The inertia is not that of a body.
    #[error("the principal moments of inertia must be finite and positive")]
    Inertia,
    /// A quantity is NaN or infinite, or a duration is not positive.
    #[error("a quantity of the body, of its start or of its torques is not finite")]
    NotFinite,
    /// A step of a free rotation is too long.
    #[error("the body turns by up to {turned} rad in a step; shorten the step to half a radian")]
    Step {
        /// By how much it may turn, rad.
        turned: f64,
    },
    /// The motion ends early.
    #[error(transparent)]
    Motion(#[from] OdeError),
}

/// A body about the point that it turns about: its centre of mass, or a fixed point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RotatingBody {
    /// Mass, kg.
    pub mass: f64,
    /// Inertia tensor about the point in axes fixed in the body, products with a minus sign off the diagonal, kg·m².
    pub inertia: Matrix3<f64>,
    /// From the point to the centre of mass in the same axes, m.
    pub arm: Vector3<f64>,
}

/// Attitude and angular velocity of a body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RotationState {
    /// From the axes of the body to those in space.
    pub attitude: UnitQuaternion<f64>,
    /// Angular velocity in the axes of the body, rad/s.
    pub omega_body: Vector3<f64>,
}

/// A torque of a fixed direction, in space or in the body, that may change with time.
#[derive(Debug, Clone, PartialEq)]
pub struct AppliedTorque {
    /// Torque vector, N·m, multiplied by the factor of its history.
    pub vector: Vector3<f64>,
    /// True if the torque rotates with the body, false if it is fixed in space.
    pub in_body: bool,
    /// Time history of the factor.
    pub history: History,
}

/// A factor that changes with time.
#[derive(Debug, Clone, PartialEq)]
pub enum History {
    /// One at all times.
    Constant,
    /// `sin(Ω t + φ)`.
    Harmonic {
        /// `Ω`, rad/s.
        frequency: f64,
        /// `φ`, rad.
        phase: f64,
    },
    /// Straight lines between times, s, and values, in ascending order; the first and last value go on.
    Table(Vec<[f64; 2]>),
}

/// Torques that act on a body.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Loads {
    /// Acceleration of gravity in space, m/s².
    pub gravity: Vector3<f64>,
    /// Torques about the point.
    pub torques: Vec<AppliedTorque>,
}

/// Terminal event of a motion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum RotationEvent {
    /// The angle between a direction of the body and one in space reaches a value, rad.
    Angle {
        /// In the body.
        of: Vector3<f64>,
        /// In space.
        against: Vector3<f64>,
        /// rad.
        angle: f64,
    },
    /// A component of the angular velocity in the axes of the body changes its sign.
    Reverses(usize),
}

/// Options of an integration: interval, samples, events, and a tolerance in parts of a radian and of the largest
/// quantities.
pub type RotationRun<'a> = ode::Integration<'a, RotationEvent>;

/// A moment of a motion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RotationSample {
    /// s.
    pub time: f64,
    /// Attitude and angular velocity.
    pub turning: RotationState,
    /// Angular velocity in space, rad/s.
    pub omega: Vector3<f64>,
    /// Angular momentum about the point in space, kg·m²/s.
    pub momentum: Vector3<f64>,
    /// Kinetic energy of the turning, J.
    pub kinetic: f64,
    /// Potential energy of the weight above the point, J.
    pub potential: f64,
    /// Work of the torques since the start, J.
    pub work: f64,
    /// Angular impulse of the torques since the start, in space, kg·m²/s.
    pub impulse: Vector3<f64>,
}

/// A motion.
#[derive(Debug, Clone, PartialEq)]
pub struct RigidBodyMotion {
    /// From the start to the end.
    pub samples: Vec<RotationSample>,
    /// The least and the largest angle of the watched directions, rad.
    pub angles: Option<Extremes>,
    /// Index of the event that ended the motion; `None` at the end of the interval.
    pub ended: Option<usize>,
    /// Number of integration steps.
    pub steps: usize,
}

/// Directions whose angle is watched.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WatchedAngles {
    /// In the body, a unit vector.
    pub of: Vector3<f64>,
    /// In space, a unit vector.
    pub against: Vector3<f64>,
}

impl WatchedAngles {
    /// The angle, which turns where the cosine does, but has a corner where the directions coincide.
    fn look(&self, sample: &RotationSample) -> Sampling {
        let of = sample.turning.attitude * self.of;
        let value = of.cross(&self.against).norm().atan2(of.dot(&self.against));
        let rate = -sample.omega.cross(&of).dot(&self.against);
        Sampling { value, smooth: -of.dot(&self.against), rate }
    }
}

impl RigidBodyMotion {
    /// The largest `|T + V − W − (T₀ + V₀)|` of the motion, over the largest of these energies: zero when exact.
    pub fn energy_drift(&self) -> f64 {
        let left = |sample: &RotationSample| sample.kinetic + sample.potential - sample.work;
        let first = self.samples.first().map_or(0.0, left);
        let off = self.samples.iter().map(|sample| (left(sample) - first).abs());
        let size = |s: &RotationSample| {
            s.kinetic.max((s.potential - self.samples[0].potential).abs()).max(s.work.abs())
        };
        part(off, self.samples.iter().map(size))
    }

    /// The largest change of `H − ∫M dt` over the largest `|H|`: of the whole vector, or along `gravity` where a
    /// weight turns the body too.
    pub fn momentum_drift(&self, gravity: Option<Vector3<f64>>) -> f64 {
        let Some(first) = self.samples.first() else { return 0.0 };
        let along = gravity.and_then(|gravity| gravity.try_normalize(0.0));
        let off = |sample: &RotationSample| {
            let off = sample.momentum - sample.impulse - first.momentum;
            along.map_or(off.norm(), |along| along.dot(&off).abs())
        };
        let size = |sample: &RotationSample| sample.momentum.norm().max(sample.impulse.norm());
        part(self.samples.iter().map(off), self.samples.iter().map(size))
    }
}

impl RotatingBody {
    /// The principal moments of inertia about the point and the principal axes as the columns of a rotation, the odd
    /// one of two equal moments last. Moments count as equal here when they differ by rounding alone: in a long motion
    /// more would be seen.
    ///
    /// # Errors
    /// `NotFinite`, `Inertia`.
    pub fn principal(&self) -> Result<(Vector3<f64>, Matrix3<f64>), SimulateError> {
        if !self.inertia.iter().all(|entry| entry.is_finite()) {
            return Err(SimulateError::NotFinite);
        }
        let diagonal = (0..3).all(|row| (0..row).all(|column| self.inertia[(row, column)] == 0.0));
        let (moments, mut axes) = if diagonal {
            (self.inertia.diagonal(), Matrix3::identity())
        } else {
            let eigen = symmetric_eigen(&DMatrix::from_fn(3, 3, |r, c| self.inertia[(r, c)]))
                .map_err(|_| SimulateError::Inertia)?;
            let axes = Matrix3::from_fn(|r, c| eigen.vectors[(r, c)]);
            (Vector3::from_fn(|n, _| eigen.values[n]), axes)
        };
        if moments.iter().any(|moment| moment.is_nan() || *moment <= 0.0) {
            return Err(SimulateError::Inertia);
        }
        if axes.determinant() < 0.0 {
            axes = -axes;
        }
        let odd = (0..3).find(|odd| equal(moments[(odd + 1) % 3], moments[(odd + 2) % 3])).unwrap_or(2);
        let order = [(odd + 1) % 3, (odd + 2) % 3, odd];
        let columns = order.map(|n| axes.column(n).into_owned());
        Ok((Vector3::from(order.map(|n| moments[n])), Matrix3::from_columns(&columns)))
    }

    /// Angular acceleration in the axes of the body, from Euler's equations `J α = M − ω × Jω`, rad/s².
    ///
    /// # Errors
    /// `Inertia`, `NotFinite`.
    pub fn acceleration(
        &self,
        turning: &RotationState,
        loads: &Loads,
    ) -> Result<Vector3<f64>, SimulateError> {
        let (moments, axes) = self.principal()?;
        let omega = turning.omega_body;
        let moment = loads.moment(self, turning, 0.0) - omega.cross(&(self.inertia * omega));
        let acceleration = axes * (axes.tr_mul(&moment)).component_div(&moments);
        finite(acceleration)
    }
}

impl Loads {
    /// The moment about the point in the axes of the body, N·m.
    fn moment(&self, body: &RotatingBody, turning: &RotationState, time: f64) -> Vector3<f64> {
        let to_body = turning.attitude.inverse();
        let weight = body.arm.cross(&(to_body * self.gravity * body.mass));
        self.torques.iter().fold(weight, |sum, torque| {
            let vector = torque.vector * torque.history.at(time);
            sum + if torque.in_body { vector } else { to_body * vector }
        })
    }

    fn finite(&self) -> bool {
        let of = |torque: &AppliedTorque| {
            let history = match &torque.history {
                History::Constant => true,
                History::Harmonic { frequency, phase } => frequency.is_finite() && phase.is_finite(),
                History::Table(rows) => {
                    rows.iter().flatten().all(|x| x.is_finite())
                        && rows.windows(2).all(|pair| pair[0][0] < pair[1][0])
                }
            };
            history && torque.vector.iter().all(|x| x.is_finite())
        };
        self.gravity.iter().all(|x| x.is_finite()) && self.torques.iter().all(of)
    }
}

impl History {
    /// Value of the factor at a time.
    pub fn at(&self, time: f64) -> f64 {
        match self {
            History::Constant => 1.0,
            History::Harmonic { frequency, phase } => (frequency * time + phase).sin(),
            History::Table(rows) => {
                let after = rows.partition_point(|[at, _]| *at <= time);
                match (after.checked_sub(1).map(|before| rows[before]), rows.get(after).copied()) {
                    (Some([t0, f0]), Some([t1, f1])) => f0 + (f1 - f0) * (time - t0) / (t1 - t0),
                    (Some([_, value]), None) | (None, Some([_, value])) => value,
                    (None, None) => 0.0,
                }
            }
        }
    }
}

/// Follows the motion of a body under its loads from a start.
///
/// # Errors
/// `Inertia`, `NotFinite`; `RigidBodyMotion` when it is stopped or asks for too many steps.
pub fn simulate(
    body: &RotatingBody,
    start: &RotationState,
    loads: &Loads,
    run: &RotationRun,
) -> Result<RigidBodyMotion, SimulateError> {
    simulate_watching(body, start, loads, run, None)
}

/// The same, with the extremes of an angle.
///
/// # Errors
/// As [`simulate`].
pub fn simulate_watching(
    body: &RotatingBody,
    start: &RotationState,
    loads: &Loads,
    run: &RotationRun,
    watched: Option<WatchedAngles>,
) -> Result<RigidBodyMotion, SimulateError> {
    /// Examines each step, which is a small part of a turn.
    const LOOKS: u32 = 4;
    let finite = loads.finite()
        && body.mass.is_finite()
        && [body.arm, start.omega_body].iter().flatten().all(|x| x.is_finite())
        && run.duration.is_finite();
    if !finite || run.duration <= 0.0 {
        return Err(SimulateError::NotFinite);
    }
    let mut machine = RotationSystem::new(body, start, loads, run)?;
    let state = machine.state(start);
    let mut integrator =
        Integrator::new(&mut machine, 0.0, &state, run.duration, run.most_steps)?.examined_between();
    let gaps = run.samples.saturating_sub(1).max(1);
    let time_of = |n: usize| if n == gaps { run.duration } else { run.duration * n as f64 / gaps as f64 };
    let mut samples = Vec::with_capacity(run.samples);
    samples.push(machine.sample(0.0, &state)?);
    let mut angles = watched.map(|watched| Extremes::at(0.0, watched.look(&samples[0]).value));
    let breaks = machine.breaks();
    let mut ended = None;
    while integrator.time() < run.duration && ended.is_none() {
        let now = integrator.time();
        let next = breaks.iter().copied().find(|at| *at > now).unwrap_or(run.duration);
        integrator.advance(&mut machine, next.min(run.duration))?;
        let mut until = integrator.time();
        for (index, end) in run.ends.iter().enumerate() {
            let number = |machine: &mut RotationSystem, _: f64, state: &[f64]| machine.before(end, state);
            let zero = integrator.first_zero(&mut machine, number);
            if let Some(time) = zero.filter(|time| *time <= until) {
                (until, ended) = (time, Some(index));
            }
        }
        if let (Some(watched), Some(angles)) = (watched, &mut angles) {
            let before = integrator.before();
            let mut look = |time: f64| {
                let state = integrator.at(&mut machine, time);
                machine.sample(time, &state).map_or(NO_LOOK, |sample| watched.look(&sample))
            };
            let place = |part: u32| {
                if part == LOOKS {
                    until
                } else {
                    before + (until - before) * f64::from(part) / f64::from(LOOKS)
                }
            };
            (0..LOOKS).for_each(|part| angles.follow(&mut look, [place(part), place(part + 1)]));
        }
        while samples.len() <= gaps && time_of(samples.len()) <= until {
            let time = time_of(samples.len());
            let state = integrator.at(&mut machine, time);
            samples.push(machine.sample(time, &state)?);
        }
        if ended.is_some() && samples.last().is_none_or(|last| last.time < until) {
            let state = integrator.at(&mut machine, until);
            samples.push(machine.sample(until, &state)?);
        }
    }
    Ok(RigidBodyMotion { samples, angles, ended, steps: integrator.steps() })
}

/// Sampling of a quantity that is not a number.
const NO_LOOK: Sampling = Sampling { value: f64::NAN, smooth: f64::NAN, rate: f64::NAN };

/// Follows a free motion in steps of about a part of a radian that keep energy and angular momentum.
///
/// # Errors
/// `Inertia`, `NotFinite`, `Step`; `RigidBodyMotion` when it is stopped or asks for too many steps.
pub fn simulate_free(
    body: &RotatingBody,
    start: &RotationState,
    radians: f64,
    run: &RotationRun,
) -> Result<RigidBodyMotion, SimulateError> {
    simulate_free_watching(body, start, radians, run, None)
}

/// The same, with the extremes of an angle.
///
/// # Errors
/// As [`simulate_free`].
pub fn simulate_free_watching(
    body: &RotatingBody,
    start: &RotationState,
    radians: f64,
    run: &RotationRun,
    watched: Option<WatchedAngles>,
) -> Result<RigidBodyMotion, SimulateError> {
    let (moments, axes) = body.principal()?;
    let to_body = principal_attitude(&axes);
    let omega = axes.tr_mul(&start.omega_body);
    let gaps = run.samples.saturating_sub(1).max(1);
    let fastest = moments.component_mul(&omega).norm() / moments.min();
    let wanted = (run.duration / gaps as f64 * fastest / radians).ceil().max(1.0);
    if !wanted.is_finite() || wanted * gaps as f64 > run.most_steps as f64 {
        return Err(OdeError::TooManySteps { at: 0.0, steps: run.most_steps }.into());
    }
    let each = wanted as usize;
    let step = run.duration / (each * gaps) as f64;
    let mut rotation = FreeRotation::new(moments, start.attitude * to_body, omega, step)?;
    let mut samples = Vec::with_capacity(gaps + 1);
    let sampled = |rotation: &FreeRotation, time: f64| {
        let attitude = rotation.attitude();
        RotationSample {
            time,
            turning: RotationState {
                attitude: attitude * to_body.inverse(),
                omega_body: axes * rotation.omega_body(),
            },
            omega: attitude * rotation.omega_body(),
            momentum: rotation.momentum_in_space(),
            kinetic: rotation.energy(),
            potential: 0.0,
            work: 0.0,
            impulse: Vector3::zeros(),
        }
    };
    let mut angles = watched.map(|watched| Extremes::at(0.0, watched.look(&sampled(&rotation, 0.0)).value));
    for n in 0..=gaps {
        if n > 0 {
            if (run.cancelled)() {
                return Err(OdeError::Stopped.into());
            }
            for at in 0..each {
                let before = watched.map(|_| rotation.clone());
                rotation.advance();
                let (Some(watched), Some(angles), Some(before)) = (watched, &mut angles, before) else {
                    continue;
                };
                // Within a step: a shorter one from its begin.
                let begun = ((n - 1) * each + at) as f64 * step;
                let mut look = |time: f64| {
                    let part = time - begun;
                    let within = if part >= step {
                        Ok(rotation.clone())
                    } else if part <= 0.0 {
                        Ok(before.clone())
                    } else {
                        before.after(part)
                    };
                    within.map_or(NO_LOOK, |rotation| watched.look(&sampled(&rotation, time)))
                };
                angles.follow(&mut look, [begun, begun + step]);
            }
        }
        samples.push(sampled(&rotation, run.duration * n as f64 / gaps as f64));
    }
    Ok(RigidBodyMotion { samples, angles, ended: None, steps: each * gaps })
}

/// The rotation whose columns are the principal axes.
fn principal_attitude(axes: &Matrix3<f64>) -> UnitQuaternion<f64> {
    UnitQuaternion::from_rotation_matrix(&nalgebra::Rotation3::from_matrix_unchecked(*axes))
}

/// Returns true if two moments of inertia differ by rounding alone.
fn equal(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-13 * a.abs().max(b.abs())
}

fn part(off: impl Iterator<Item = f64>, size: impl Iterator<Item = f64>) -> f64 {
    let (off, size) = (off.fold(0.0, f64::max), size.fold(0.0, f64::max));
    if size > 0.0 { off / size } else { off }
}

fn finite(vector: Vector3<f64>) -> Result<Vector3<f64>, SimulateError> {
    if vector.iter().all(|x| x.is_finite()) { Ok(vector) } else { Err(SimulateError::NotFinite) }
}
