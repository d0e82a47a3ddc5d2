//! Forward dynamics: the accelerations of a mechanism under its loads.
//!
//! With N a basis of the velocities that joints and drivers leave free (`Φ_q N = 0`) and `q̈ = a + N s̈`, where `a` is
//! any acceleration that joints and drivers allow, virtual power leaves `(Nᵀ M N) s̈ = Nᵀ (Q − M a)`; the multipliers
//! follow from `Φ_qᵀ λ = M q̈ − Q` (E. J. Haug, *Computer-Aided Kinematics and Dynamics of Mechanical Systems* (1989),
//! §6.3 and §7.2).

use nalgebra::{DMatrix, DVector};

use super::{
    Contact, PlanarError, State, System,
    friction::{Effect, Friction, Frictionless, Response},
    machine::{Machine, NOISE},
    measure::Measure,
    system::poses,
    vectors::{body_that_moves_most, dot},
};
use dalembert_numerics::linalg::{self, Elimination};

/// A pivot of the reduced masses below this part of the largest is no inertia.
const MASSLESS: f64 = 1e-13;

/// The solution of the forward dynamics in a position with given velocities.
#[derive(Debug, Clone, PartialEq)]
pub struct ForwardDynamics {
    /// Positions, velocities and the accelerations under the loads.
    pub state: State,
    /// The Lagrange multiplier λ of each constraint, in the order of [`System::equations`]: the force or torque that a
    /// joint or driver exerts along its coordinate.
    pub multipliers: Vec<f64>,
    /// The Coulomb friction of each frictional joint, in the order of these loads.
    pub frictions: Vec<JointFriction>,
    /// Degrees of freedom left by joints and drivers.
    pub degrees_of_freedom: usize,
}

/// The Coulomb friction of a joint.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct JointFriction {
    /// Index of the load.
    pub load: usize,
    /// Contact state of the joint.
    pub contact: Contact,
    /// The friction along its sliding, N, or about its pin, N m: positive when it pushes what slides to grow. For a joint
    /// that rests since others are held it is not determined, and given as zero.
    pub effort: f64,
    /// Sliding velocity, m/s, or for a pin its angular velocity, rad/s.
    pub sliding: f64,
    /// True for a pin.
    pub pin: bool,
}

impl System {
    /// The accelerations of a mechanism under its loads, and the efforts in its joints and drivers, from positions and
    /// velocities that satisfy them. What no driver drives moves freely.
    ///
    /// # Errors
    /// `Massless`, `Jammed`, `Sticks`, `NotFinite`.
    pub fn forward_dynamics(
        &self,
        positions: &[[f64; 3]],
        velocities: &[[f64; 3]],
    ) -> Result<ForwardDynamics, PlanarError> {
        let elimination = Elimination::new(&self.constraints(positions).jacobian)?;
        let (masses, loads) = (self.scaled_masses(), self.scaled_forces(positions, velocities));
        let mut right: Vec<f64> = self.biases(positions, velocities).into_iter().map(|bias| -bias).collect();
        let first = self.first_driver();
        for (right, driver) in right[first..].iter_mut().zip(&self.mechanism.drivers) {
            *right += driver.acceleration;
        }
        let held = elimination.solve(&right)?;
        let motions = elimination.null_space()?;
        let reduced = reduced_masses(&motions, &masses);
        if !motions.is_empty() {
            self.with_mass(&reduced, &motions)?;
        }
        let under = |loads: &[f64], held: Vec<f64>| -> Result<Effect, PlanarError> {
            let inertia_free: Vec<f64> =
                loads.iter().zip(&masses).zip(&held).map(|((load, mass), a)| load - mass * a).collect();
            let driving =
                DVector::from_iterator(motions.len(), motions.iter().map(|n| dot(n, &inertia_free)));
            let mut accelerations = held;
            let free = if motions.is_empty() { driving } else { linalg::solve(&reduced, &driving)?.x };
            for (motion, s) in motions.iter().zip(free.iter()) {
                for (a, n) in accelerations.iter_mut().zip(motion) {
                    *a += n * s;
                }
            }
            let left: Vec<f64> = accelerations
                .iter()
                .zip(&masses)
                .zip(loads)
                .map(|((a, mass), load)| mass * a - load)
                .collect();
            let multipliers = elimination.solve_transposed(&left)?;
            Ok(Effect { free: free.as_slice().to_vec(), accelerations, multipliers })
        };
        let effect = under(&loads, held)?;
        let (effect, frictions) = self.with_friction(positions, velocities, &motions, effect, |force| {
            under(force, vec![0.0; force.len()])
        })?;
        let accelerations = self.unscaled(&effect.accelerations);
        let state = State { positions: positions.to_vec(), velocities: velocities.to_vec(), accelerations };
        Ok(ForwardDynamics {
            state,
            multipliers: effect.multipliers,
            frictions,
            degrees_of_freedom: motions.len(),
        })
    }

    /// The response to the loads with Coulomb friction, from that without.
    fn with_friction(
        &self,
        positions: &[[f64; 3]],
        velocities: &[[f64; 3]],
        motions: &[Vec<f64>],
        effect: Effect,
        act: impl Fn(&[f64]) -> Result<Effect, PlanarError>,
    ) -> Result<(Effect, Vec<JointFriction>), PlanarError> {
        let frictions = self.frictional_joints();
        if frictions.is_empty() {
            return Ok((effect, Vec::new()));
        }
        let speeds = velocities.iter().flat_map(|[x, y, turn]| [x.abs(), y.abs(), turn.abs() * self.length]);
        let gained = effect.free.iter().map(|a| (a.abs() * self.length).sqrt());
        let fastest = speeds.chain(gained).fold(0.0, f64::max);
        let poses = poses(positions);
        let frictionless = Frictionless { system: self, poses: &poses, velocities, motions, effect };
        let response = Response::new(&frictions, frictionless, act)?;
        let mut contacts = response.contacts(NOISE * fastest);
        let efforts = response.settle(&mut contacts, fastest, [NOISE; 2])?;
        let of_each = |(row, friction): (usize, &Friction)| JointFriction {
            load: friction.load,
            contact: contacts[row],
            effort: efforts[row] * self.arm(friction),
            sliding: response.rates[row] / self.arm(friction),
            pin: friction.pin,
        };
        let joints = frictions.iter().enumerate().map(of_each).collect();
        Ok((response.effect(&efforts), joints))
    }

    /// The velocities with which a motion starts: those of the drivers, the given ones of some measures, and of all
    /// such motions the one of least kinetic energy, as a blow along these measures would give it to a mechanism at
    /// rest.
    ///
    /// # Errors
    /// `Rate` for one that contradicts; `Massless`, `NotFinite`.
    pub fn starting(
        &self,
        positions: &[[f64; 3]],
        rates: &[(Measure, f64)],
    ) -> Result<Vec<[f64; 3]>, PlanarError> {
        let mut machine = Machine::new(self, positions, 1.0, &|| false);
        let (driven, motions) = machine.degrees_of_freedom();
        let masses = self.scaled_masses();
        let at_rest = |motion: &[f64]| State {
            positions: positions.to_vec(),
            velocities: self.unscaled(motion),
            accelerations: Vec::new(),
        };
        if motions.is_empty() {
            return if rates.is_empty() {
                Ok(self.unscaled(&driven))
            } else {
                Err(PlanarError::Rate { index: 0 })
            };
        }
        // Of s with B s = r, the one of least (v + N s)ᵀ M (v + N s): H s = −Nᵀ M v + Bᵀ μ, as one set of equations.
        let (free, given) = (motions.len(), rates.len());
        let reduced = reduced_masses(&motions, &masses);
        self.with_mass(&reduced, &motions)?;
        let moved: Vec<State> = motions.iter().map(|motion| at_rest(motion)).collect();
        let turns = DMatrix::from_fn(given, free, |row, column| self.rate(&rates[row].0, &moved[column]));
        if let Some(&index) = Elimination::new(&turns)?.dependent_rows().iter().max() {
            return Err(PlanarError::Rate { index });
        }
        let driven_state = at_rest(&driven);
        let mut all = DMatrix::zeros(free + given, free + given);
        all.view_mut((0, 0), (free, free)).copy_from(&reduced);
        all.view_mut((free, 0), (given, free)).copy_from(&turns);
        all.view_mut((0, free), (free, given)).copy_from(&turns.transpose());
        let momentum: Vec<f64> = driven.iter().zip(&masses).map(|(v, mass)| mass * v).collect();
        let right = DVector::from_fn(free + given, |row, _| {
            if row < free {
                -dot(&motions[row], &momentum)
            } else {
                let (measure, rate) = &rates[row - free];
                rate - self.rate(measure, &driven_state)
            }
        });
        let found = linalg::solve(&all, &right)?.x;
        let mut velocities = driven;
        for (motion, s) in motions.iter().zip(found.iter()) {
            for (v, n) in velocities.iter_mut().zip(motion) {
                *v += n * s;
            }
        }
        Ok(self.unscaled(&velocities))
    }

    /// The masses of the scaled positions `(x, y, θ · length)`.
    pub(super) fn scaled_masses(&self) -> Vec<f64> {
        let of_body = |body: &super::Body| [body.mass, body.mass, body.inertia / (self.length * self.length)];
        self.mechanism.bodies.iter().flat_map(of_body).collect()
    }

    fn scaled_forces(&self, positions: &[[f64; 3]], velocities: &[[f64; 3]]) -> Vec<f64> {
        let mut forces = vec![[0.0; 3]; positions.len()];
        self.forces(&poses(positions), velocities, &mut forces);
        forces.iter().flat_map(|[x, y, moment]| [*x, *y, moment / self.length]).collect()
    }

    /// Refuses a free motion without inertia.
    fn with_mass(&self, reduced: &DMatrix<f64>, motions: &[Vec<f64>]) -> Result<(), PlanarError> {
        let elimination = Elimination::new(reduced)?;
        let weak = if elimination.smallest_pivot() < MASSLESS {
            elimination.free_columns().first().copied().or(Some(0))
        } else {
            elimination.free_columns().first().copied()
        };
        match weak {
            Some(motion) => Err(PlanarError::Massless { body: body_that_moves_most(&motions[motion]) }),
            None => Ok(()),
        }
    }
}

fn reduced_masses(motions: &[Vec<f64>], masses: &[f64]) -> DMatrix<f64> {
    DMatrix::from_fn(motions.len(), motions.len(), |row, column| {
        motions[row].iter().zip(&motions[column]).zip(masses).map(|((a, b), mass)| a * mass * b).sum()
    })
}
