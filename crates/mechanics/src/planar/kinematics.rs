//! Constraint residuals `Φ(q, t)` and constraint Jacobian `Φ_q`, and the velocities and accelerations that follow from
//! it: `Φ_q q̇ = −Φ_t`, `Φ_q q̈ = γ`.
//!
//! The order of the computation is in its arguments: positions give the [`Constraints`] and the elimination
//! ([`Model::factored`]), the elimination the velocities, these the accelerations ([`Model::motion_with`]).

use nalgebra::DMatrix;

use super::{
    ConstraintTerm, Model, PlanarError, PlanarState,
    measure::{bias, gradient, poses, rate},
};
use dalembert_numerics::linalg::{Elimination, SparseMatrix};

/// Mobility of a mechanism: the number of its degrees of freedom.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Mobility {
    /// `3 n − m`: three for each body less one for each equation of the joints (Grübler, Kutzbach).
    pub counted: i64,
    /// `3 n − rank Φ_q`: the degrees of freedom in this position.
    pub free: usize,
    /// The joints with equations that follow from others: their reactions are not determined by statics.
    pub redundant: Vec<usize>,
}

/// The constraint equations in a position.
pub(super) struct Constraints {
    /// The constraint residuals `Φ(q, t)`, m or rad.
    pub(super) residuals: Vec<f64>,
    /// The constraint Jacobian `Φ_q` by the scaled coordinates, m × 3n.
    pub(super) jacobian: SparseMatrix,
}

impl Model {
    /// The constraint residuals Φ and their Jacobian Φ_q, with the drivers at their own values.
    pub(super) fn constraints(&self, positions: &[[f64; 3]]) -> Constraints {
        self.constraints_at(positions, &self.driver_values())
    }

    /// The same with the drivers at other values.
    pub(super) fn constraints_at(&self, positions: &[[f64; 3]], driver_values: &[f64]) -> Constraints {
        let poses = poses(positions);
        let mut rows = Vec::with_capacity(self.equations.len());
        let mut residuals = Vec::with_capacity(self.equations.len());
        let of_joints = self.equations[..self.first_driver()].iter();
        let constants = of_joints.map(|equation| equation.constant.unwrap_or(0.0));
        let constants = constants.chain(driver_values.iter().copied());
        for (equation, constant) in self.equations.iter().zip(constants) {
            let (mut left, mut row) = (0.0, Vec::with_capacity(6));
            for term in &equation.terms {
                let gradient = gradient(&term.measure, &poses);
                let [value, rate] = match &term.function {
                    Some(function) => {
                        let [value, rate, _] = function.at(gradient.value);
                        [value, rate]
                    }
                    None => [gradient.value, 1.0],
                };
                left += term.weight * value;
                for (frame, part) in term.measure.bodies().into_iter().zip([gradient.from, gradient.to]) {
                    if let Some(body) = frame {
                        let factor = term.weight * rate;
                        let entries = [factor * part[0], factor * part[1], factor * part[2] / self.length];
                        add(&mut row, 3 * body, entries);
                    }
                }
            }
            residuals.push(left - constant);
            rows.push(row);
        }
        Constraints { residuals, jacobian: SparseMatrix::new(3 * positions.len(), rows) }
    }

    /// The quadratic velocity terms `γ` of the equations: minus the accelerations of their left sides when no body
    /// accelerates.
    pub(super) fn quadratic_velocity_terms(
        &self,
        positions: &[[f64; 3]],
        velocities: &[[f64; 3]],
    ) -> Vec<f64> {
        let poses = poses(positions);
        let of_term = |term: &ConstraintTerm| {
            let bias = bias(&term.measure, &poses, velocities);
            let through = match &term.function {
                Some(function) => {
                    let gradient = gradient(&term.measure, &poses);
                    let rate = rate(&term.measure, &gradient, velocities);
                    let [_, first, second] = function.at(gradient.value);
                    first * bias + second * rate * rate
                }
                None => bias,
            };
            term.weight * through
        };
        self.equations.iter().map(|equation| -equation.terms.iter().map(of_term).sum::<f64>()).collect()
    }

    /// The mobility of the mechanism in a position.
    ///
    /// # Errors
    /// `NotFinite`.
    pub fn mobility(&self, positions: &[[f64; 3]]) -> Result<Mobility, PlanarError> {
        let joints = self.first_driver();
        let elimination = self.eliminated_joints(positions)?;
        let mut redundant: Vec<usize> =
            elimination.dependent_rows().iter().map(|&row| self.owners[row]).collect();
        redundant.sort_unstable();
        redundant.dedup();
        let unknowns = 3 * self.mechanism.bodies.len();
        Ok(Mobility {
            counted: unknowns as i64 - joints as i64,
            free: unknowns - elimination.rank(),
            redundant,
        })
    }

    /// The eliminated Jacobian of the joints alone.
    fn eliminated_joints(&self, positions: &[[f64; 3]]) -> Result<Elimination, PlanarError> {
        let joints: Vec<usize> = (0..self.first_driver()).collect();
        Ok(Elimination::of_sparse(&self.constraints(positions).jacobian.select_rows(&joints))?)
    }

    /// The eliminated Jacobian of joints and drivers, ready to be solved for velocities, accelerations and multipliers.
    ///
    /// # Errors
    /// `UnderDriven`, `OverDriven`, `DeadCentre`; `NotFinite`.
    pub(super) fn factored(&self, positions: &[[f64; 3]]) -> Result<Elimination, PlanarError> {
        let jacobian = self.constraints(positions).jacobian;
        let elimination = Elimination::of_sparse(&jacobian)?;
        let unknowns = 3 * self.mechanism.bodies.len();
        let drivers = self.mechanism.drivers.len();
        if elimination.rank() == unknowns && elimination.dependent_rows().is_empty() {
            return Ok(elimination);
        }
        let Mobility { counted, free, .. } = self.mobility(positions)?;
        if elimination.rank() == unknowns && drivers == free {
            return Ok(elimination);
        }
        if drivers < free {
            let singular = counted <= drivers as i64;
            return Err(PlanarError::UnderDriven { free: free - drivers, singular });
        }
        // Of the motions that the joints leave, which driver moves none that the others do not?
        let basis = self.eliminated_joints(positions)?.null_space()?;
        let driven = DMatrix::from_fn(drivers, basis.len().max(1), |driver, column| {
            basis.get(column).map_or(0.0, |motion| {
                let row = &jacobian.rows()[self.first_driver() + driver];
                row.iter().map(|&(column, entry)| entry * motion[column]).sum()
            })
        });
        let dependent = Elimination::new(&driven)?.dependent_rows().first().copied();
        let driver = dependent.unwrap_or(drivers.saturating_sub(1));
        Err(if drivers > free {
            PlanarError::OverDriven { driver }
        } else {
            PlanarError::DeadCentre { driver }
        })
    }

    /// Velocities and accelerations in a closed position, with the velocities and accelerations of the drivers.
    ///
    /// # Errors
    /// `UnderDriven`, `OverDriven`, `DeadCentre`; `NotFinite`.
    pub fn kinematics(&self, positions: &[[f64; 3]]) -> Result<PlanarState, PlanarError> {
        self.driven_motion(&self.factored(positions)?, positions)
    }

    /// The motion that the drivers give, with the Jacobian eliminated in these positions.
    pub(super) fn driven_motion(
        &self,
        elimination: &Elimination,
        positions: &[[f64; 3]],
    ) -> Result<PlanarState, PlanarError> {
        let drivers = &self.mechanism.drivers;
        let rates: Vec<f64> = drivers.iter().map(|driver| driver.velocity).collect();
        let accelerations: Vec<f64> = drivers.iter().map(|driver| driver.acceleration).collect();
        self.motion_with(elimination, positions, &rates, &accelerations)
    }

    /// The same with one velocity and one acceleration for each driver: m/s or rad/s, m/s² or rad/s².
    pub(super) fn motion_with(
        &self,
        elimination: &Elimination,
        positions: &[[f64; 3]],
        driver_rates: &[f64],
        driver_accelerations: &[f64],
    ) -> Result<PlanarState, PlanarError> {
        let mut rhs = vec![0.0; self.first_driver()];
        rhs.extend(driver_rates);
        let velocities = self.unscaled(&elimination.solve(&rhs)?);
        let mut rhs = self.quadratic_velocity_terms(positions, &velocities);
        for (rhs, acceleration) in rhs[self.first_driver()..].iter_mut().zip(driver_accelerations) {
            *rhs += acceleration;
        }
        let accelerations = self.unscaled(&elimination.solve(&rhs)?);
        Ok(PlanarState { positions: positions.to_vec(), velocities, accelerations })
    }

    /// The velocity coefficients `∂q/∂m`, one list of `(x, y, θ)` for each driver: the velocities of the bodies at unit
    /// velocity of the driver, the others held.
    pub(super) fn velocity_coefficients(
        &self,
        elimination: &Elimination,
    ) -> Result<Vec<Vec<[f64; 3]>>, PlanarError> {
        (self.first_driver()..self.equations.len())
            .map(|driver| {
                let mut unit = vec![0.0; self.equations.len()];
                unit[driver] = 1.0;
                Ok(self.unscaled(&elimination.solve(&unit)?))
            })
            .collect()
    }
}

/// Adds entries from a column on to a row of the Jacobian.
fn add(row: &mut Vec<(usize, f64)>, column: usize, entries: [f64; 3]) {
    for (column, entry) in (column..).zip(entries).filter(|(_, entry)| *entry != 0.0) {
        match row.iter_mut().find(|(other, _)| *other == column) {
            Some((_, sum)) => *sum += entry,
            None => row.push((column, entry)),
        }
    }
}
