//! Coulomb friction in joints: which slide, which stick, and the friction force of each.
//!
//! A joint that slides has the friction force `μ N` against its sliding, a pin the couple `μ r N`, where N is the force
//! that the joint carries and on which the friction itself has a part. A joint at rest is held by whatever friction
//! that takes, as long as none of the motions that it could begin would go on: each of these, one degree of freedom at
//! a time, is tried with the friction that it would meet. F. Pfeiffer, C. Glocker, *Multibody Dynamics with Unilateral
//! Contacts* (1996), ch. 6.
//!
//! Lengths here are in m and efforts in N throughout: an angle counts times the size of the mechanism, as in its scaled
//! coordinates, and a couple over it. Lists of frictions, contacts and efforts have one entry for each joint with
//! friction, in the order of these loads.

mod sticking;

use nalgebra::DMatrix;

use super::{
    Model, PlanarError, PlanarJoint, PlanarLoad, Pose, RelativeCoordinate,
    measure::{bias, gradient, rate},
    tolerances::{
        FRICTION_MAX_ITERATIONS, FRICTION_STALLED_STEP, FRICTION_STEP, FRICTION_STRICT_ITERATIONS,
        MIN_SIDE_FORCE,
    },
    vectors::{dot, largest},
};
use dalembert_numerics::linalg::Elimination;

/// Friction in a pin, slider or slot.
#[derive(Debug, Clone)]
pub(super) struct FrictionLaw {
    /// The load, by its index.
    pub(super) load: usize,
    /// The joint, by its index.
    pub(super) joint: usize,
    /// The relative coordinate that slides.
    pub(super) measure: RelativeCoordinate,
    /// The friction along the measure over the force that the joint carries: μ, or μ r, m.
    pub(super) limit: f64,
    /// The equations whose multipliers are that force: the second one of a pin alone.
    rows: [usize; 2],
    /// True in a pin.
    pub(super) pin: bool,
}

/// The state of contact of a frictional joint.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Contact {
    /// Sliding.
    Sliding {
        /// 1 where its measure grows, −1 where it shrinks.
        sense: f64,
        /// The sign of the force of a guide: the side on which it bears. 1 for a pin.
        side: f64,
    },
    /// Sticking: its own friction keeps it at rest.
    Sticking,
    /// At rest because other joints stick: its friction is statically indeterminate.
    Indeterminate,
}

impl Model {
    /// The frictions of all joints.
    pub(super) fn frictions(&self) -> Vec<FrictionLaw> {
        let of_load = |(load, this): (usize, &PlanarLoad)| {
            let &PlanarLoad::Friction { joint, coefficient, radius } = this else { return None };
            let (measure, arm, pin) = match self.mechanism.joints[joint] {
                PlanarJoint::Slider { guide, direction, slides: at, .. }
                | PlanarJoint::Slot { guide, direction, pin: at, .. } => {
                    let direction = [direction.cos(), direction.sin()];
                    (RelativeCoordinate::Along { direction, from: guide, to: at }, 1.0, false)
                }
                PlanarJoint::Pin { a, b } => {
                    (RelativeCoordinate::Angle { of: b.on, against: a.on }, radius, true)
                }
                _ => return None,
            };
            let first = self.owners.iter().position(|&owner| owner == joint)?;
            let rows = [first, first + usize::from(pin)];
            Some(FrictionLaw { load, joint, measure, limit: coefficient * arm, rows, pin })
        };
        self.mechanism.loads.iter().enumerate().filter_map(of_load).collect()
    }

    /// The joints with a coefficient of friction above zero.
    pub(super) fn frictional_joints(&self) -> Vec<FrictionLaw> {
        self.frictions().into_iter().filter(|friction| friction.limit > 0.0).collect()
    }

    /// Reports whether a joint has a coefficient of friction above zero.
    pub(super) fn has_friction(&self) -> bool {
        !self.frictional_joints().is_empty()
    }
}

impl FrictionLaw {
    /// The components of the force that the joint carries.
    fn components(&self, multipliers: &[f64]) -> [f64; 2] {
        let [first, second] = self.rows;
        [multipliers[first], if self.pin { multipliers[second] } else { 0.0 }]
    }
}

/// The response of a mechanism in a position to forces, all scaled.
#[derive(Debug, Clone)]
pub(super) struct ResponseToForce {
    /// The accelerations in the columns of the independent velocities, m/s².
    pub(super) independent: Vec<f64>,
    /// Those of the bodies, by column.
    pub(super) accelerations: Vec<f64>,
    /// The multipliers, by equation.
    pub(super) multipliers: Vec<f64>,
}

/// A mechanism in a position, moving, without the friction of its joints.
pub(super) struct Frictionless<'a> {
    pub(super) model: &'a Model,
    /// Of the bodies and the ground.
    pub(super) poses: &'a [Pose<f64>],
    pub(super) velocities: &'a [[f64; 3]],
    /// The null-space basis of the velocities, scaled.
    pub(super) basis: &'a [Vec<f64>],
    /// The response to its other loads.
    pub(super) response: ResponseToForce,
}

/// The response of the n joints with friction of a mechanism to their friction.
pub(super) struct FrictionResponse<'a> {
    frictions: &'a [FrictionLaw],
    /// The response to the loads but for friction.
    base: ResponseToForce,
    /// The response to 1 N of each friction.
    units: Vec<ResponseToForce>,
    /// The sliding velocities, m/s.
    pub(super) rates: Vec<f64>,
    /// The sliding accelerations without friction, m/s².
    sliding_accelerations: Vec<f64>,
    /// The inverse of the effective mass, n × n, 1/kg: the sliding acceleration of the row by 1 N in the column.
    inverse_mass: DMatrix<f64>,
    /// The force in each joint without friction, N.
    joint_forces: Vec<[f64; 2]>,
    /// The sensitivity of the joint forces: by 1 N of the first index, in the joint of the second.
    joint_force_sensitivities: Vec<Vec<[f64; 2]>>,
    /// The friction over the joint force: `μ` or `μ r / size`.
    limits: Vec<f64>,
    /// The sliding velocity of each joint in each motion of the null-space basis.
    sliding_in_basis: Vec<Vec<f64>>,
}

impl<'a> FrictionResponse<'a> {
    /// Finds the response to a unit of each friction: `act` gives that to generalised forces on the scaled coordinates.
    ///
    /// # Errors
    /// Those of `act`.
    pub(super) fn new(
        frictions: &'a [FrictionLaw],
        frictionless: Frictionless<'_>,
        act: impl Fn(&[f64]) -> Result<ResponseToForce, PlanarError>,
    ) -> Result<Self, PlanarError> {
        let Frictionless { model, poses, velocities, basis, response: base } = frictionless;
        let mut forces = Vec::with_capacity(frictions.len());
        let (mut rates, mut sliding_accelerations) = (Vec::new(), Vec::new());
        for friction in frictions {
            let arm = model.length_of(&friction.measure);
            let gradient = gradient(&friction.measure, poses);
            let mut force = vec![0.0; base.accelerations.len()];
            for (frame, part) in friction.measure.bodies().into_iter().zip([gradient.from, gradient.to]) {
                if let Some(body) = frame {
                    force[3 * body] += arm * part[0];
                    force[3 * body + 1] += arm * part[1];
                    force[3 * body + 2] += arm * part[2] / model.length;
                }
            }
            rates.push(arm * rate(&friction.measure, &gradient, velocities));
            let bias = arm * bias(&friction.measure, poses, velocities);
            sliding_accelerations.push(dot(&force, &base.accelerations) + bias);
            forces.push(force);
        }
        let units = forces.iter().map(|force| act(force)).collect::<Result<Vec<ResponseToForce>, _>>()?;
        let of_each = |multipliers: &[f64]| -> Vec<[f64; 2]> {
            frictions.iter().map(|friction| friction.components(multipliers)).collect()
        };
        Ok(Self {
            frictions,
            rates,
            sliding_accelerations,
            inverse_mass: DMatrix::from_fn(forces.len(), forces.len(), |row, column| {
                dot(&forces[row], &units[column].accelerations)
            }),
            joint_forces: of_each(&base.multipliers),
            joint_force_sensitivities: units.iter().map(|unit| of_each(&unit.multipliers)).collect(),
            limits: frictions
                .iter()
                .map(|friction| friction.limit / model.length_of(&friction.measure))
                .collect(),
            sliding_in_basis: forces
                .iter()
                .map(|force| basis.iter().map(|motion| dot(force, motion)).collect())
                .collect(),
            base,
            units,
        })
    }

    /// The contacts by the sliding velocities: up to `rest`, m/s, a joint is at rest.
    pub(super) fn contacts(&self, rest: f64) -> Vec<Contact> {
        let of_rate = |rate: &f64| {
            if rate.abs() <= rest {
                Contact::Indeterminate
            } else {
                Contact::Sliding { sense: rate.signum(), side: 1.0 }
            }
        };
        self.rates.iter().map(of_rate).collect()
    }

    /// The response to all loads, with these frictions, N.
    pub(super) fn total(&self, efforts: &[f64]) -> ResponseToForce {
        let ResponseToForce { mut independent, mut accelerations, mut multipliers } = self.base.clone();
        for (unit, effort) in self.units.iter().zip(efforts) {
            let parts = [
                (&mut independent, &unit.independent),
                (&mut accelerations, &unit.accelerations),
                (&mut multipliers, &unit.multipliers),
            ];
            for (sum, unit) in parts {
                for (sum, unit) in sum.iter_mut().zip(unit) {
                    *sum += effort * unit;
                }
            }
        }
        ResponseToForce { independent, accelerations, multipliers }
    }

    /// The efforts of the frictions along their measures, N: `−μ N` against a sliding, for a joint that sticks what
    /// keeps it at rest. By Newton's method, since the friction has a part in N. None without a balance.
    pub(super) fn efforts(&self, contacts: &[Contact]) -> Option<Vec<f64>> {
        let n = contacts.len();
        let mut efforts = vec![0.0; n];
        for iteration in 0..FRICTION_MAX_ITERATIONS {
            let mut jacobian = DMatrix::identity(n, n);
            let mut residuals = vec![0.0; n];
            for (row, contact) in contacts.iter().enumerate() {
                match contact {
                    Contact::Indeterminate => residuals[row] = efforts[row],
                    Contact::Sticking => {
                        residuals[row] = self.sliding_acceleration(row, &efforts);
                        jacobian.row_mut(row).copy_from(&self.inverse_mass.row(row));
                    }
                    Contact::Sliding { sense, side } => {
                        let [x, y] = self.force(row, &efforts);
                        let carried = if self.frictions[row].pin { x.hypot(y) } else { side * x };
                        let along = if carried == 0.0 { [*side, 0.0] } else { [x / carried, y / carried] };
                        let most = sense * self.limits[row];
                        residuals[row] = efforts[row] + most * carried;
                        for column in 0..n {
                            let [by_x, by_y] = self.joint_force_sensitivities[column][row];
                            jacobian[(row, column)] += most * (along[0] * by_x + along[1] * by_y);
                        }
                    }
                }
            }
            let step = Elimination::new(&jacobian).ok()?.solve(&residuals).ok()?;
            for (effort, step) in efforts.iter_mut().zip(&step) {
                *effort -= step;
            }
            let enough =
                if iteration < FRICTION_STRICT_ITERATIONS { FRICTION_STEP } else { FRICTION_STALLED_STEP };
            if largest(&step) <= enough * largest(&efforts) {
                return Some(efforts);
            }
        }
        None
    }

    /// The efforts, with every guide bearing on the side that its force has.
    pub(super) fn bearing(&self, contacts: &mut [Contact]) -> Option<Vec<f64>> {
        for _ in 0..=contacts.len() + 1 {
            let efforts = self.efforts(contacts)?;
            let mut turned = false;
            for row in 0..contacts.len() {
                let [force, _] = self.force(row, &efforts);
                let pin = self.frictions[row].pin;
                if let Contact::Sliding { side, .. } = &mut contacts[row]
                    && !pin
                    && *side * force < -MIN_SIDE_FORCE * self.largest_force(&efforts)
                {
                    (*side, turned) = (-*side, true);
                }
            }
            if !turned {
                return Some(efforts);
            }
        }
        None
    }

    /// The margins that must stay positive for the contacts to last, each over its size, 2 n + 1 in number: first of
    /// each joint that slides its velocity in its sense, then of each guide its force on its side, and last the reserve
    /// of friction before a joint at rest begins to slide. One that does not apply is 1. `max_velocity` is the size of
    /// velocities, m/s.
    pub(super) fn margins(
        &self,
        contacts: &[Contact],
        efforts: &[f64],
        max_velocity: f64,
        margins: &mut Vec<f64>,
    ) {
        margins.clear();
        for (contact, rate) in contacts.iter().zip(&self.rates) {
            margins.push(if let Contact::Sliding { sense, .. } = contact {
                sense * rate / max_velocity
            } else {
                1.0
            });
        }
        let largest_force = self.largest_force(efforts);
        for (row, contact) in contacts.iter().enumerate() {
            let margin = match contact {
                Contact::Sliding { side, .. } if !self.frictions[row].pin && largest_force > 0.0 => {
                    side * self.force(row, efforts)[0] / largest_force
                }
                _ => 1.0,
            };
            margins.push(margin);
        }
        let size = self.largest_acceleration(efforts);
        let opening = self.opening(contacts).ok().flatten();
        margins.push(opening.map_or(1.0, |(surplus, _)| if size > 0.0 { -surplus / size } else { 1.0 }));
    }

    /// The power of the frictions, W.
    pub(super) fn power(&self, efforts: &[f64]) -> f64 {
        dot(&self.rates, efforts)
    }

    /// Acceleration of a sliding, m/s².
    fn sliding_acceleration(&self, row: usize, efforts: &[f64]) -> f64 {
        self.sliding_accelerations[row]
            + self.inverse_mass.row(row).iter().zip(efforts).map(|(a, f)| a * f).sum::<f64>()
    }

    /// The force in a joint with friction, N.
    fn force(&self, row: usize, efforts: &[f64]) -> [f64; 2] {
        let start = self.joint_forces[row];
        self.joint_force_sensitivities.iter().zip(efforts).fold(start, |[x, y], (by_unit, effort)| {
            [x + effort * by_unit[row][0], y + effort * by_unit[row][1]]
        })
    }

    /// The largest of the forces in the joints with friction and of their parts.
    fn largest_force(&self, efforts: &[f64]) -> f64 {
        let part = |row: usize| {
            let without = self.joint_forces[row];
            let by_friction = self
                .joint_force_sensitivities
                .iter()
                .zip(efforts)
                .map(|(unit, effort)| unit[row].map(|x| x * effort));
            by_friction.chain([without]).flatten().fold(0.0f64, |most, x| most.max(x.abs()))
        };
        (0..efforts.len()).map(part).fold(0.0, f64::max)
    }

    /// The largest acceleration of a sliding, or of a part of it, m/s².
    fn largest_acceleration(&self, efforts: &[f64]) -> f64 {
        let part = |row: usize| {
            let by_friction = self.inverse_mass.row(row);
            let parts =
                by_friction.iter().zip(efforts).map(|(a, f)| a * f).chain([self.sliding_accelerations[row]]);
            parts.fold(0.0f64, |most, x| most.max(x.abs()))
        };
        (0..efforts.len()).map(part).fold(0.0, f64::max)
    }

    /// The error that names the joint with most friction.
    pub(super) fn jammed(&self) -> PlanarError {
        let most =
            |row: &usize| self.limits[*row] * self.joint_forces[*row][0].hypot(self.joint_forces[*row][1]);
        let row = (0..self.frictions.len()).max_by(|a, b| most(a).total_cmp(&most(b))).unwrap_or(0);
        PlanarError::Jammed { joint: self.frictions[row].joint }
    }
}
