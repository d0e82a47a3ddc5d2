//! Coulomb friction in joints: which slide, which stick, and the friction force of each.
//!
//! A joint that slides is with friction by `μ N`, a pin by the couple `μ r N`, where N is the force that the joint carries and
//! on which the friction itself has a part. A joint at rest is held by whatever friction that takes, as long as none of
//! the motions that it could begin would go on: each of these, one degree of freedom at a time, is tried with the friction that it
//! would meet. F. Pfeiffer, C. Glocker, *Multibody Dynamics with Unilateral Contacts* (1996), ch. 6.
//!
//! Lengths here are in m and efforts in N throughout: an angle counts times the size of the mechanism, as in its scaled
//! positions, and a couple over it.

mod sticking;

use nalgebra::DMatrix;

use super::{
    Joint, Load, Measure, PlanarError, Pose, System,
    continuation::largest,
    system::{bias, gradient, project},
    vectors::dot,
};
use dalembert_numerics::linalg::Elimination;

/// Rounds of Newton's method for the friction of all sliding joints.
const ROUNDS: usize = 30;
/// Efforts are found to this part of the largest; where rounding does not let them, after some rounds to the second.
const FOUND: f64 = 1e-14;
const SOME: usize = 8;
const ALMOST: f64 = 1e-10;
/// A guide does not turn to its other side for less than this part of the largest force.
const TURNED: f64 = 1e-10;

/// Friction in a pin, slider or slot.
#[derive(Debug, Clone)]
pub(super) struct Friction {
    /// Index of the load.
    pub(super) load: usize,
    /// In which joint.
    pub(super) joint: usize,
    /// Relative coordinate of the sliding.
    pub(super) measure: Measure,
    /// The effort along the measure over the force that the joint carries: μ, or μ r.
    pub(super) limit: f64,
    /// The equations whose multipliers are that force: the second one of a pin alone.
    rows: [usize; 2],
    /// True for a pin.
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

impl System {
    /// The frictions of all joints.
    pub(super) fn frictions(&self) -> Vec<Friction> {
        let of_load = |(load, this): (usize, &Load)| {
            let &Load::Friction { joint, coefficient, radius } = this else { return None };
            let (measure, arm, pin) = match self.mechanism.joints[joint] {
                Joint::Slider { guide, direction, slides: at, .. }
                | Joint::Slot { guide, direction, pin: at, .. } => {
                    let direction = [direction.cos(), direction.sin()];
                    (Measure::Along { direction, from: guide, to: at }, 1.0, false)
                }
                Joint::Pin { a, b } => (Measure::Angle { of: b.on, against: a.on }, radius, true),
                _ => return None,
            };
            let first = self.owners.iter().position(|&owner| owner == joint)?;
            let rows = [first, first + usize::from(pin)];
            Some(Friction { load, joint, measure, limit: coefficient * arm, rows, pin })
        };
        self.mechanism.loads.iter().enumerate().filter_map(of_load).collect()
    }

    /// The joints with a coefficient of friction above zero.
    pub(super) fn frictional_joints(&self) -> Vec<Friction> {
        self.frictions().into_iter().filter(|friction| friction.limit > 0.0).collect()
    }

    /// Friction arm: factor from the coordinate of a friction to a length.
    pub(super) fn arm(&self, friction: &Friction) -> f64 {
        if friction.pin { self.length } else { 1.0 }
    }
}

impl Friction {
    /// The components of the force that the joint carries.
    fn components(&self, multipliers: &[f64]) -> [f64; 2] {
        let [first, second] = self.rows;
        [multipliers[first], if self.pin { multipliers[second] } else { 0.0 }]
    }
}

/// Scaled effect of the loads on a mechanism in one position.
#[derive(Debug, Clone)]
pub(super) struct Effect {
    /// The accelerations of the free velocities.
    pub(super) free: Vec<f64>,
    /// Those of the bodies.
    pub(super) accelerations: Vec<f64>,
    /// The multipliers.
    pub(super) multipliers: Vec<f64>,
}

/// A mechanism in a position, moving, before its joints are with friction.
pub(super) struct Frictionless<'a> {
    pub(super) system: &'a System,
    /// Of the bodies and the ground.
    pub(super) poses: &'a [Pose<f64>],
    pub(super) velocities: &'a [[f64; 3]],
    /// The free motions, scaled.
    pub(super) motions: &'a [Vec<f64>],
    /// Effect of the loads other than friction.
    pub(super) effect: Effect,
}

/// Response of the sliding velocities of a mechanism to friction.
pub(super) struct Response<'a> {
    frictions: &'a [Friction],
    /// Effect of the loads other than friction, and of 1 N of each friction.
    base: Effect,
    units: Vec<Effect>,
    /// The velocities of the slidings, m/s.
    pub(super) rates: Vec<f64>,
    /// Their accelerations without friction, m/s², and by 1 N of the friction in the column.
    slidings: Vec<f64>,
    yields: DMatrix<f64>,
    /// The force in each joint without friction, and by 1 N of the second friction.
    carried: Vec<[f64; 2]>,
    carries: Vec<Vec<[f64; 2]>>,
    /// `μ` or `μ r / length`.
    limits: Vec<f64>,
    /// Sliding velocity of each joint for unit free motions.
    rows: Vec<Vec<f64>>,
}

impl<'a> Response<'a> {
    /// Asks for what a unit of each friction does: `act` gives the effect of generalised forces on the scaled positions.
    ///
    /// # Errors
    /// Those of `act`.
    pub(super) fn new(
        frictions: &'a [Friction],
        frictionless: Frictionless<'_>,
        act: impl Fn(&[f64]) -> Result<Effect, PlanarError>,
    ) -> Result<Self, PlanarError> {
        let Frictionless { system, poses, velocities, motions, effect: base } = frictionless;
        let mut forces = Vec::with_capacity(frictions.len());
        let (mut rates, mut slidings) = (Vec::new(), Vec::new());
        for friction in frictions {
            let arm = system.arm(friction);
            let gradient = gradient(&friction.measure, poses);
            let mut force = vec![0.0; base.accelerations.len()];
            for (frame, part) in friction.measure.bodies().into_iter().zip([gradient.from, gradient.to]) {
                if let Some(body) = frame {
                    force[3 * body] += arm * part[0];
                    force[3 * body + 1] += arm * part[1];
                    force[3 * body + 2] += arm * part[2] / system.length;
                }
            }
            rates.push(arm * project(&friction.measure, &gradient, velocities));
            let bend = arm * bias(&friction.measure, poses, velocities);
            slidings.push(dot(&force, &base.accelerations) + bend);
            forces.push(force);
        }
        let units = forces.iter().map(|force| act(force)).collect::<Result<Vec<Effect>, _>>()?;
        let of_each = |multipliers: &[f64]| -> Vec<[f64; 2]> {
            frictions.iter().map(|friction| friction.components(multipliers)).collect()
        };
        Ok(Self {
            frictions,
            rates,
            slidings,
            yields: DMatrix::from_fn(forces.len(), forces.len(), |row, column| {
                dot(&forces[row], &units[column].accelerations)
            }),
            carried: of_each(&base.multipliers),
            carries: units.iter().map(|unit| of_each(&unit.multipliers)).collect(),
            limits: frictions.iter().map(|friction| friction.limit / system.arm(friction)).collect(),
            rows: forces
                .iter()
                .map(|force| motions.iter().map(|motion| dot(force, motion)).collect())
                .collect(),
            base,
            units,
        })
    }

    /// Contact states by the sliding velocities: a joint slower than `still`, m/s, sticks.
    pub(super) fn contacts(&self, still: f64) -> Vec<Contact> {
        let of_rate = |rate: &f64| {
            if rate.abs() <= still {
                Contact::Indeterminate
            } else {
                Contact::Sliding { sense: rate.signum(), side: 1.0 }
            }
        };
        self.rates.iter().map(of_rate).collect()
    }

    /// Combined effect of all loads.
    pub(super) fn effect(&self, efforts: &[f64]) -> Effect {
        let Effect { mut free, mut accelerations, mut multipliers } = self.base.clone();
        for (unit, effort) in self.units.iter().zip(efforts) {
            let parts = [
                (&mut free, &unit.free),
                (&mut accelerations, &unit.accelerations),
                (&mut multipliers, &unit.multipliers),
            ];
            for (sum, unit) in parts {
                for (sum, unit) in sum.iter_mut().zip(unit) {
                    *sum += effort * unit;
                }
            }
        }
        Effect { free, accelerations, multipliers }
    }

    /// The efforts of the frictions along their measures, N: `−μ N` against a sliding, whatever holds for a joint that is
    /// held. By Newton's method, since the friction has a part in N. None if they find no balance.
    pub(super) fn efforts(&self, contacts: &[Contact]) -> Option<Vec<f64>> {
        let n = contacts.len();
        let mut efforts = vec![0.0; n];
        for round in 0..ROUNDS {
            let mut jacobian = DMatrix::identity(n, n);
            let mut left = vec![0.0; n];
            for (row, contact) in contacts.iter().enumerate() {
                match contact {
                    Contact::Indeterminate => left[row] = efforts[row],
                    Contact::Sticking => {
                        left[row] = self.sliding(row, &efforts);
                        jacobian.row_mut(row).copy_from(&self.yields.row(row));
                    }
                    Contact::Sliding { sense, side } => {
                        let [x, y] = self.force(row, &efforts);
                        let carried = if self.frictions[row].pin { x.hypot(y) } else { side * x };
                        let along = if carried == 0.0 { [*side, 0.0] } else { [x / carried, y / carried] };
                        let most = sense * self.limits[row];
                        left[row] = efforts[row] + most * carried;
                        for column in 0..n {
                            let [by_x, by_y] = self.carries[column][row];
                            jacobian[(row, column)] += most * (along[0] * by_x + along[1] * by_y);
                        }
                    }
                }
            }
            let step = Elimination::new(&jacobian).ok()?.solve(&left).ok()?;
            for (effort, step) in efforts.iter_mut().zip(&step) {
                *effort -= step;
            }
            let enough = if round < SOME { FOUND } else { ALMOST };
            if largest(&step) <= enough * largest(&efforts) {
                return Some(efforts);
            }
        }
        None
    }

    /// The efforts, with every guide bearing on the side that its force says.
    pub(super) fn bearing(&self, contacts: &mut [Contact]) -> Option<Vec<f64>> {
        for _ in 0..=contacts.len() + 1 {
            let efforts = self.efforts(contacts)?;
            let mut turned = false;
            for row in 0..contacts.len() {
                let [force, _] = self.force(row, &efforts);
                let pin = self.frictions[row].pin;
                if let Contact::Sliding { side, .. } = &mut contacts[row]
                    && !pin
                    && *side * force < -TURNED * self.largest_force(&efforts)
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

    /// Margins within which the motion may go on, each over its scale: first the velocity of each sliding joint in its
    /// sense, then the force of each guide on its side, and last the reserve of friction before a joint at rest begins
    /// to slide. What is not asked is 1. `fastest` is the size of velocities.
    pub(super) fn margins(
        &self,
        contacts: &[Contact],
        efforts: &[f64],
        fastest: f64,
        margins: &mut Vec<f64>,
    ) {
        margins.clear();
        for (contact, rate) in contacts.iter().zip(&self.rates) {
            margins.push(if let Contact::Sliding { sense, .. } = contact {
                sense * rate / fastest
            } else {
                1.0
            });
        }
        let largest_force = self.largest_force(efforts);
        for (row, contact) in contacts.iter().enumerate() {
            let asked = match contact {
                Contact::Sliding { side, .. } if !self.frictions[row].pin && largest_force > 0.0 => {
                    side * self.force(row, efforts)[0] / largest_force
                }
                _ => 1.0,
            };
            margins.push(asked);
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
    fn sliding(&self, row: usize, efforts: &[f64]) -> f64 {
        self.slidings[row] + self.yields.row(row).iter().zip(efforts).map(|(a, f)| a * f).sum::<f64>()
    }

    /// The force in a joint with friction, N.
    fn force(&self, row: usize, efforts: &[f64]) -> [f64; 2] {
        let start = self.carried[row];
        self.carries.iter().zip(efforts).fold(start, |[x, y], (by_unit, effort)| {
            [x + effort * by_unit[row][0], y + effort * by_unit[row][1]]
        })
    }

    /// The largest of the forces in the joints with friction and of their parts.
    fn largest_force(&self, efforts: &[f64]) -> f64 {
        let part = |row: usize| {
            let without = self.carried[row];
            let by_friction =
                self.carries.iter().zip(efforts).map(|(unit, effort)| unit[row].map(|x| x * effort));
            by_friction.chain([without]).flatten().fold(0.0f64, |most, x| most.max(x.abs()))
        };
        (0..efforts.len()).map(part).fold(0.0, f64::max)
    }

    /// The largest acceleration of a sliding, or of a part of it, m/s².
    fn largest_acceleration(&self, efforts: &[f64]) -> f64 {
        let part = |row: usize| {
            let by_friction = self.yields.row(row);
            let parts = by_friction.iter().zip(efforts).map(|(a, f)| a * f).chain([self.slidings[row]]);
            parts.fold(0.0f64, |most, x| most.max(x.abs()))
        };
        (0..efforts.len()).map(part).fold(0.0, f64::max)
    }

    /// Names the joint with most friction.
    pub(super) fn jammed(&self) -> PlanarError {
        let most = |row: &usize| self.limits[*row] * self.carried[*row][0].hypot(self.carried[*row][1]);
        let row = (0..self.frictions.len()).max_by(|a, b| most(a).total_cmp(&most(b))).unwrap_or(0);
        PlanarError::Jammed { joint: self.frictions[row].joint }
    }
}
