//! The equations of motion of a turning body as a problem for an integrator.

use nalgebra::{Matrix3, Quaternion, UnitQuaternion, Vector3};

use super::{
    History, Loads, RotatingBody, RotationEvent, RotationRun, RotationSample, RotationState, SimulateError,
    equal, finite, principal_attitude,
};
use dalembert_numerics::ode::OdeSystem;

/// Attitude of the axes (4), angular momentum in them (3), spin against them; with torques also their work and their
/// impulse (3).
const ALONE: usize = 8;
const WITH_TORQUES: usize = 12;

pub(super) struct RotationSystem<'a> {
    body: &'a RotatingBody,
    loads: &'a Loads,
    tolerance: f64,
    cancelled: &'a dyn Fn() -> bool,
    moments: Vector3<f64>,
    axes: Matrix3<f64>,
    to_body: UnitQuaternion<f64>,
    /// Two moments are equal: the axes do not take part in the spin about the third.
    spinless: bool,
    /// The arm in principal axes, the torques in them or in space.
    arm: Vector3<f64>,
    torques: Vec<Vector3<f64>>,
    /// Sizes of momentum and energy that errors are held against.
    momentum: f64,
    energy: f64,
}

/// A state, read.
struct Read {
    attitude: UnitQuaternion<f64>,
    momentum: Vector3<f64>,
    omega: Vector3<f64>,
    spin: f64,
}

impl<'a> RotationSystem<'a> {
    pub(super) fn new(
        body: &'a RotatingBody,
        start: &RotationState,
        loads: &'a Loads,
        run: &RotationRun<'a>,
    ) -> Result<Self, SimulateError> {
        let (moments, axes) = body.principal()?;
        let torques: Vec<_> = loads
            .torques
            .iter()
            .map(|torque| if torque.in_body { axes.tr_mul(&torque.vector) } else { torque.vector })
            .collect();
        let largest = moments.max();
        let factor = |history: &History| match history {
            History::Table(rows) => rows.iter().fold(0.0, |most, [_, value]| f64::max(most, value.abs())),
            History::Constant | History::Harmonic { .. } => 1.0,
        };
        let pulls = loads.torques.iter().map(|torque| torque.vector.norm() * factor(&torque.history));
        let moment = body.mass * loads.gravity.norm() * body.arm.norm() + pulls.sum::<f64>();
        // Of the start, of a fall by a radian, or of a turn by one in the whole time.
        let momentum = (body.inertia * start.omega_body)
            .norm()
            .max((largest * moment).sqrt())
            .max(largest / run.duration);
        let energy = (momentum * momentum / largest).max(moment);
        if !momentum.is_finite() || !energy.is_finite() {
            return Err(SimulateError::NotFinite);
        }
        Ok(Self {
            body,
            loads,
            tolerance: run.tolerance,
            cancelled: run.cancelled,
            moments,
            axes,
            to_body: principal_attitude(&axes),
            spinless: equal(moments.x, moments.y),
            arm: axes.tr_mul(&body.arm),
            torques,
            momentum,
            energy,
        })
    }

    pub(super) fn state(&self, start: &RotationState) -> Vec<f64> {
        let attitude = start.attitude * self.to_body;
        let momentum = self.moments.component_mul(&self.axes.tr_mul(&start.omega_body));
        let size = if self.loads.torques.is_empty() { ALONE } else { WITH_TORQUES };
        let mut state = vec![0.0; size];
        state[..4].copy_from_slice(attitude.coords.as_slice());
        state[4..7].copy_from_slice(momentum.as_slice());
        state
    }

    /// Times at which the torques have corners.
    pub(super) fn breaks(&self) -> Vec<f64> {
        let of = |history: &History| match history {
            History::Table(rows) => rows.iter().map(|[time, _]| *time).collect(),
            History::Constant | History::Harmonic { .. } => Vec::new(),
        };
        let mut breaks: Vec<f64> = self.loads.torques.iter().flat_map(|torque| of(&torque.history)).collect();
        breaks.sort_by(f64::total_cmp);
        breaks
    }

    pub(super) fn sample(&self, time: f64, state: &[f64]) -> Result<RotationSample, SimulateError> {
        let Read { attitude, momentum, omega, spin } = self.read(state);
        let turned = UnitQuaternion::from_axis_angle(&Vector3::z_axis(), spin);
        let principal = attitude * turned;
        let omega_body = self.axes * (turned.inverse() * omega);
        let centre = principal * self.arm;
        let more = |n: usize| state.get(ALONE + n).copied().unwrap_or(0.0);
        Ok(RotationSample {
            time,
            turning: RotationState {
                attitude: principal * self.to_body.inverse(),
                omega_body: finite(omega_body)?,
            },
            omega: attitude * omega,
            momentum: finite(attitude * momentum)?,
            kinetic: momentum.dot(&omega) / 2.0,
            potential: -self.body.mass * self.loads.gravity.dot(&centre),
            work: more(0),
            impulse: Vector3::new(more(1), more(2), more(3)),
        })
    }

    /// A number that changes its sign when the end is reached.
    pub(super) fn before(&self, end: &RotationEvent, state: &[f64]) -> f64 {
        let Read { attitude, omega, spin, .. } = self.read(state);
        let turned = UnitQuaternion::from_axis_angle(&Vector3::z_axis(), spin);
        match end {
            RotationEvent::Angle { of, against, angle } => {
                let of = attitude * (turned * self.axes.tr_mul(of));
                of.angle(against) - angle
            }
            RotationEvent::Reverses(component) => (self.axes * (turned.inverse() * omega))[*component],
        }
    }

    fn read(&self, state: &[f64]) -> Read {
        let attitude = Quaternion::new(state[3], state[0], state[1], state[2]);
        let momentum = Vector3::new(state[4], state[5], state[6]);
        Read {
            // Within the error of a step of one: no root is needed.
            attitude: UnitQuaternion::new_unchecked(attitude * (1.5 - 0.5 * attitude.norm_squared())),
            momentum,
            omega: momentum.component_div(&self.moments),
            spin: state[7],
        }
    }
}

impl OdeSystem for RotationSystem<'_> {
    fn rates(&mut self, time: f64, state: &[f64], rates: &mut [f64]) {
        let Read { attitude, momentum, omega, spin } = self.read(state);
        // The body against the axes that the state is written in.
        let (sin, cos) = if self.spinless { spin.sin_cos() } else { (0.0, 1.0) };
        let turn = |v: Vector3<f64>| Vector3::new(v.x * cos - v.y * sin, v.x * sin + v.y * cos, v.z);
        let back = attitude.inverse();
        let weight = back * (self.loads.gravity * self.body.mass);
        let mut moment = turn(self.arm).cross(&weight);
        if !self.torques.is_empty() {
            let mut all = Vector3::zeros();
            for (torque, vector) in self.loads.torques.iter().zip(&self.torques) {
                let vector = vector * torque.history.at(time);
                all += if torque.in_body { turn(vector) } else { back * vector };
            }
            moment += all;
            rates[ALONE] = all.dot(&omega);
            rates[ALONE + 1..].copy_from_slice((attitude * all).as_slice());
        }
        let axes = if self.spinless { Vector3::new(omega.x, omega.y, 0.0) } else { omega };
        let turned = attitude.into_inner() * Quaternion::from_parts(0.0, axes * 0.5);
        rates[..4].copy_from_slice(turned.coords.as_slice());
        let change = moment + momentum.cross(&axes);
        rates[4..7].copy_from_slice(change.as_slice());
        rates[7] = omega.z - axes.z;
    }

    fn allowed(&mut self, _: &[f64], _: &[f64], allowed: &mut [f64]) {
        for (n, allowed) in allowed.iter_mut().enumerate() {
            *allowed = self.tolerance
                * match n {
                    0..4 | 7 => 1.0,
                    ALONE => self.energy,
                    _ => self.momentum,
                };
        }
    }

    fn settle(&mut self, _: f64, state: &mut [f64]) -> bool {
        let square: f64 = state[..4].iter().map(|x| x * x).sum();
        let good = square > 0.25 && square < 4.0;
        let size = square.sqrt();
        state[..4].iter_mut().for_each(|x| *x /= size);
        good
    }

    fn stopped(&self) -> bool {
        (self.cancelled)()
    }
}
