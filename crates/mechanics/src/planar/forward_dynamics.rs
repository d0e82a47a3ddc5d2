//! Forward dynamics: the accelerations of a mechanism under its loads.
//!
//! With N a null-space basis of the constraint Jacobian (`Φ_q N = 0`) and `q̈ = a + N s̈`, where the particular
//! solution `a` is any acceleration that joints and drivers allow, virtual power leaves `(Nᵀ M N) s̈ = Nᵀ (Q − M a)`;
//! the multipliers follow from `Φ_qᵀ λ = M q̈ − Q` (E. J. Haug, *Computer-Aided Kinematics and Dynamics of Mechanical
//! Systems* (1989), §6.3 and §7.2).

use nalgebra::{DMatrix, DVector};

use super::{
    Contact, Model, PlanarError, PlanarState, RelativeCoordinate,
    data::Data,
    friction::{FrictionLaw, FrictionResponse, Frictionless, ResponseToForce},
    measure::poses,
    tolerances::{MASSLESS_PIVOT, REST_SPEED},
    vectors::{body_that_moves_most, dot},
};
use dalembert_numerics::linalg::{self, Elimination};

/// The solution of the forward dynamics in a position with given velocities.
#[derive(Debug, Clone, PartialEq)]
pub struct ForwardDynamics {
    /// Positions, velocities and the accelerations under the loads.
    pub state: PlanarState,
    /// The Lagrange multiplier λ of each constraint, in the order of [`Model::equations`]: the force or torque that a
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
    /// The load, by its index.
    pub load: usize,
    /// The state of contact.
    pub contact: Contact,
    /// The friction along the sliding, N, or about the pin, N m: positive when it pushes the relative coordinate to
    /// grow. Statically indeterminate friction is given as zero.
    pub effort: f64,
    /// The sliding velocity, m/s, or that of a pin's turn, rad/s.
    pub sliding: f64,
    /// True for a pin.
    pub pin: bool,
}

impl Model {
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
        let elimination = Elimination::of_sparse(&self.constraints(positions).jacobian)?;
        let loads = self.scaled_forces(positions, velocities);
        let mut rhs = self.quadratic_velocity_terms(positions, velocities);
        for (rhs, driver) in rhs[self.first_driver()..].iter_mut().zip(&self.mechanism.drivers) {
            *rhs += driver.acceleration;
        }
        let particular = elimination.solve(&rhs)?;
        let basis = elimination.null_space()?;
        let reduced_mass = reduced_mass(&basis, &self.masses);
        if !basis.is_empty() {
            check_mass(&reduced_mass, &basis)?;
        }
        let under = |loads: &[f64], particular: Vec<f64>| -> Result<ResponseToForce, PlanarError> {
            let inertia_free: Vec<f64> = loads
                .iter()
                .zip(&self.masses)
                .zip(&particular)
                .map(|((load, mass), a)| load - mass * a)
                .collect();
            let reduced = DVector::from_iterator(basis.len(), basis.iter().map(|n| dot(n, &inertia_free)));
            let mut accelerations = particular;
            let independent =
                if basis.is_empty() { reduced } else { linalg::solve(&reduced_mass, &reduced)?.x };
            for (motion, s) in basis.iter().zip(independent.iter()) {
                for (a, n) in accelerations.iter_mut().zip(motion) {
                    *a += n * s;
                }
            }
            let unbalanced: Vec<f64> = accelerations
                .iter()
                .zip(&self.masses)
                .zip(loads)
                .map(|((a, mass), load)| mass * a - load)
                .collect();
            let multipliers = elimination.solve_transposed(&unbalanced)?;
            Ok(ResponseToForce { independent: independent.as_slice().to_vec(), accelerations, multipliers })
        };
        let response = under(&loads, particular)?;
        let (response, frictions) = self.with_friction(positions, velocities, &basis, response, |force| {
            under(force, vec![0.0; force.len()])
        })?;
        let accelerations = self.unscaled(&response.accelerations);
        let state =
            PlanarState { positions: positions.to_vec(), velocities: velocities.to_vec(), accelerations };
        Ok(ForwardDynamics {
            state,
            multipliers: response.multipliers,
            frictions,
            degrees_of_freedom: basis.len(),
        })
    }

    /// The response to the loads with Coulomb friction, from that without.
    fn with_friction(
        &self,
        positions: &[[f64; 3]],
        velocities: &[[f64; 3]],
        basis: &[Vec<f64>],
        response: ResponseToForce,
        act: impl Fn(&[f64]) -> Result<ResponseToForce, PlanarError>,
    ) -> Result<(ResponseToForce, Vec<JointFriction>), PlanarError> {
        let frictions = self.frictional_joints();
        if frictions.is_empty() {
            return Ok((response, Vec::new()));
        }
        let speeds = velocities.iter().flat_map(|[x, y, turn]| [x.abs(), y.abs(), turn.abs() * self.length]);
        let gained = response.independent.iter().map(|a| (a.abs() * self.length).sqrt());
        let max_velocity = speeds.chain(gained).fold(0.0, f64::max);
        let poses = poses(positions);
        let frictionless = Frictionless { model: self, poses: &poses, velocities, basis, response };
        let response = FrictionResponse::new(&frictions, frictionless, act)?;
        let mut contacts = response.contacts(REST_SPEED * max_velocity);
        let efforts = response.settle(&mut contacts, max_velocity, [REST_SPEED; 2])?;
        let of_each = |(row, friction): (usize, &FrictionLaw)| JointFriction {
            load: friction.load,
            contact: contacts[row],
            effort: efforts[row] * self.length_of(&friction.measure),
            sliding: response.rates[row] / self.length_of(&friction.measure),
            pin: friction.pin,
        };
        let joints = frictions.iter().enumerate().map(of_each).collect();
        Ok((response.total(&efforts), joints))
    }

    /// The velocities with which a motion starts: those of the drivers, the given ones of some measures, m/s or rad/s,
    /// and of all such motions the one of least kinetic energy, as impulses along these measures would give it to a
    /// mechanism at rest.
    ///
    /// # Errors
    /// `Rate` for one that contradicts; `Massless`, `NotFinite`.
    pub fn initial_velocities(
        &self,
        positions: &[[f64; 3]],
        rates: &[(RelativeCoordinate, f64)],
    ) -> Result<Vec<[f64; 3]>, PlanarError> {
        let mut data = Data::new(self, positions);
        let at_rest = vec![0.0; data.independent().len()];
        let moving = data.position(0.0, &self.tree_coordinates(positions)).factored().velocities(&at_rest);
        let (driven, basis) = (moving.scaled(), moving.basis());
        let state = |motion: &[f64]| PlanarState {
            positions: positions.to_vec(),
            velocities: self.unscaled(motion),
            accelerations: Vec::new(),
        };
        if basis.is_empty() {
            return if rates.is_empty() {
                Ok(self.unscaled(driven))
            } else {
                Err(PlanarError::Rate { index: 0 })
            };
        }
        // Of s with B s = r, the one of least (v + N s)ᵀ M (v + N s): H s = −Nᵀ M v + Bᵀ μ, as one set of equations.
        let (free, given) = (basis.len(), rates.len());
        let reduced_mass = reduced_mass(basis, &self.masses);
        check_mass(&reduced_mass, basis)?;
        let motions: Vec<PlanarState> = basis.iter().map(|motion| state(motion)).collect();
        let rates_of_basis =
            DMatrix::from_fn(given, free, |row, column| self.rate(&rates[row].0, &motions[column]));
        if let Some(&index) = Elimination::new(&rates_of_basis)?.dependent_rows().iter().max() {
            return Err(PlanarError::Rate { index });
        }
        let driven_state = state(driven);
        let mut all = DMatrix::zeros(free + given, free + given);
        all.view_mut((0, 0), (free, free)).copy_from(&reduced_mass);
        all.view_mut((free, 0), (given, free)).copy_from(&rates_of_basis);
        all.view_mut((0, free), (free, given)).copy_from(&rates_of_basis.transpose());
        let momentum: Vec<f64> = driven.iter().zip(&self.masses).map(|(v, mass)| mass * v).collect();
        let rhs = DVector::from_fn(free + given, |row, _| {
            if row < free {
                -dot(&basis[row], &momentum)
            } else {
                let (measure, rate) = &rates[row - free];
                rate - self.rate(measure, &driven_state)
            }
        });
        let solution = linalg::solve(&all, &rhs)?.x;
        let mut velocities = driven.to_vec();
        for (motion, s) in basis.iter().zip(solution.iter()) {
            for (v, n) in velocities.iter_mut().zip(motion) {
                *v += n * s;
            }
        }
        Ok(self.unscaled(&velocities))
    }

    /// The forces and moments of loads and weights on the scaled coordinates, N, by column.
    fn scaled_forces(&self, positions: &[[f64; 3]], velocities: &[[f64; 3]]) -> Vec<f64> {
        let mut forces = vec![[0.0; 3]; positions.len()];
        self.forces(&poses(positions), velocities, &mut forces);
        forces.iter().flat_map(|[x, y, moment]| [*x, *y, moment / self.length]).collect()
    }
}

/// Refuses an independent motion without inertia.
fn check_mass(reduced_mass: &DMatrix<f64>, basis: &[Vec<f64>]) -> Result<(), PlanarError> {
    let elimination = Elimination::new(reduced_mass)?;
    let dependent = elimination.free_columns().first().copied();
    let weak = if elimination.smallest_pivot() < MASSLESS_PIVOT { dependent.or(Some(0)) } else { dependent };
    match weak {
        Some(motion) => Err(PlanarError::Massless { body: body_that_moves_most(&basis[motion]) }),
        None => Ok(()),
    }
}

/// The reduced mass matrix `Nᵀ M N`, kg, square with a row for each vector of the basis.
fn reduced_mass(basis: &[Vec<f64>], masses: &[f64]) -> DMatrix<f64> {
    DMatrix::from_fn(basis.len(), basis.len(), |row, column| {
        basis[row].iter().zip(&basis[column]).zip(masses).map(|((a, b), mass)| a * mass * b).sum()
    })
}
