//! Position analysis: an initial guess of the positions from angles, and the assembly of the mechanism near a guess.

use super::{
    Equation, Model, PlanarError, PlanarJoint, PlanarMechanism,
    kinematics::Constraints,
    tolerances::{
        ACCEPTED_RESIDUAL, ASSEMBLY_DAMPING, ASSEMBLY_DAMPING_DECREASE, ASSEMBLY_DAMPING_INCREASE,
        ASSEMBLY_MAX_ITERATIONS, ASSEMBLY_MAX_STALLED, ASSEMBLY_PROGRESS, ASSEMBLY_RESIDUAL, GUESS_DISTINCT,
        GUESS_EQUAL_RESIDUAL, GUESS_FAR_SPREADS, GUESS_FREE_COMPONENT, GUESS_MAX_ITERATIONS,
        GUESS_REGULARISATION, GUESS_RESIDUAL, GUESS_SPREAD, GUESS_STEP,
    },
    vectors::largest,
};
use dalembert_numerics::linalg::{Elimination, SparseMatrix};

/// Positions of the bodies before the mechanism is assembled.
#[derive(Debug, Clone, PartialEq)]
pub struct InitialGuess {
    /// `(x, y, θ)` of each body.
    pub positions: Vec<[f64; 3]>,
    /// The bodies whose origin was not given and does not follow from the joints and drivers.
    pub undetermined: Vec<usize>,
    /// The same, but a joint takes its constant term from the guess: a weight on a cord, whose length nobody gives.
    pub assumed: Vec<usize>,
    /// The bodies whose origin was not given, and which the joints let lie at another place as well with the same
    /// angles: a slider at the end of a rod.
    pub ambiguous: Vec<usize>,
}

impl Model {
    /// An initial guess from the angles of the bodies, rad, and the origins of some of them, m: the origins that the
    /// joints require while no body turns, by least squares. Constraints without a constant term of their own are left
    /// out.
    ///
    /// # Errors
    /// As for [`new`](Model::new); `NotFinite`.
    pub fn initial_guess(
        mechanism: &PlanarMechanism,
        angles: &[f64],
        origins: &[Option<[f64; 2]>],
    ) -> Result<InitialGuess, PlanarError> {
        // Not all in one place: distances between coinciding points have no direction. 2.4 rad is the golden angle.
        let on_circle = |(body, &angle): (usize, &f64)| {
            let turn = 2.4 * (body + 1) as f64;
            [turn.cos(), turn.sin(), angle]
        };
        let circle: Vec<[f64; 3]> = angles.iter().enumerate().map(on_circle).collect();
        let model = Self::new(mechanism, &circle)?;
        let spread = |spread: f64| -> Vec<[f64; 3]> {
            let radius = spread * model.length;
            let given = |body: usize| origins.get(body).copied().flatten();
            let place = |(body, [x, y, angle]): (usize, &[f64; 3])| {
                let [x, y] = given(body).unwrap_or([x * radius, y * radius]);
                [x, y, *angle]
            };
            circle.iter().enumerate().map(place).collect()
        };
        let equations: Vec<Equation> = mechanism.joints.iter().flat_map(PlanarJoint::equations).collect();
        let with_constant = (0..equations.len()).filter(|&row| equations[row].constant.is_some());
        let rows: Vec<usize> = with_constant.chain(model.first_driver()..model.equations.len()).collect();
        let columns: Vec<usize> = (0..3 * angles.len()).filter(|column| column % 3 != 2).collect();
        let (positions, residual) = model.fit_origins(spread(GUESS_SPREAD), &rows, &columns)?;
        let (_, jacobian) = model.row_scaled(&positions)?;
        let free =
            Elimination::of_sparse(&jacobian.select_rows(&rows).select_columns(&columns))?.null_space()?;
        let is_open = |body: usize| origins.get(body).is_none_or(Option::is_none);
        let is_free = |body: usize| {
            free.iter().any(|motion| motion[2 * body..][..2].iter().any(|x| x.abs() > GUESS_FREE_COMPONENT))
        };
        let undetermined = (0..angles.len()).filter(|&body| is_free(body) && is_open(body));
        let is_assumed = |body: &usize| {
            let mut open = equations.iter().filter(|equation| equation.constant.is_none());
            open.any(|equation| {
                equation.terms.iter().any(|term| term.measure.bodies().contains(&Some(*body)))
            })
        };
        let (assumed, undetermined): (Vec<usize>, Vec<usize>) = undetermined.partition(is_assumed);
        let mut ambiguous = Vec::new();
        for far in GUESS_FAR_SPREADS {
            let (other, other_residual) = model.fit_origins(spread(far), &rows, &columns)?;
            let is_solution =
                other_residual <= GUESS_EQUAL_RESIDUAL * residual + GUESS_RESIDUAL * model.length;
            let is_elsewhere = |body: &usize| {
                let ([x, y, _], [u, v, _]) = (positions[*body], other[*body]);
                (x - u).hypot(y - v) > GUESS_DISTINCT * model.length
                    && !undetermined.contains(body)
                    && !assumed.contains(body)
                    && is_open(*body)
            };
            ambiguous.extend((0..angles.len()).filter(|body| is_solution && is_elsewhere(body)));
        }
        ambiguous.sort_unstable();
        ambiguous.dedup();
        Ok(InitialGuess { positions, undetermined, assumed, ambiguous })
    }

    /// Changes the origins until the equations of `rows` hold, by Gauss and Newton; `columns` are those of the origins.
    /// The positions and the norm of the row-scaled residuals, m, before the last step.
    fn fit_origins(
        &self,
        mut positions: Vec<[f64; 3]>,
        rows: &[usize],
        columns: &[usize],
    ) -> Result<(Vec<[f64; 3]>, f64), PlanarError> {
        let mut norm = f64::INFINITY;
        for _ in 0..GUESS_MAX_ITERATIONS {
            let (residuals, jacobian) = self.row_scaled(&positions)?;
            let jacobian = jacobian.select_rows(rows).select_columns(columns);
            let residual: Vec<f64> = rows.iter().map(|&row| residuals[row]).collect();
            norm = sum_of_squares(&residual).sqrt();
            let mut normal = jacobian.transpose().times_transpose();
            for at in 0..normal.columns() {
                normal.add_to_diagonal(at, GUESS_REGULARISATION);
            }
            let step = Elimination::of_sparse(&normal)?.solve(&jacobian.transposed_times(&residual))?;
            for (at, step) in positions.iter_mut().zip(step.chunks_exact(2)) {
                (at[0], at[1]) = (at[0] - step[0], at[1] - step[1]);
            }
            if step.iter().all(|step| step.abs() <= GUESS_STEP * self.length) {
                break;
            }
        }
        Ok((positions, norm))
    }

    /// Closes the mechanism near a guess: Newton's method with the smallest change of the positions, damped while it is
    /// far from closed (Levenberg and Marquardt).
    ///
    /// # Errors
    /// `DoesNotClose`, `NotFinite`.
    pub fn assemble(&self, guess: &[[f64; 3]]) -> Result<Vec<[f64; 3]>, PlanarError> {
        let mut positions = guess.to_vec();
        let (mut residuals, mut jacobian) = self.row_scaled(&positions)?;
        let (mut square, mut damping) = (sum_of_squares(&residuals), ASSEMBLY_DAMPING);
        let (mut best, mut stalled) = (f64::INFINITY, 0);
        for _ in 0..ASSEMBLY_MAX_ITERATIONS {
            let largest = largest(&residuals);
            if largest <= ASSEMBLY_RESIDUAL * self.reach(&positions) || stalled > ASSEMBLY_MAX_STALLED {
                break;
            }
            let mut normal = jacobian.times_transpose();
            for at in 0..normal.columns() {
                normal.add_to_diagonal(at, damping * f64::min(1.0, largest / self.length));
            }
            let multipliers = Elimination::of_sparse(&normal)?.solve(&residuals)?;
            let change = jacobian.transposed_times(&multipliers);
            let tried = self.displaced(&positions, &change, -1.0);
            let (new_residuals, new_jacobian) = self.row_scaled(&tried)?;
            let new_square = sum_of_squares(&new_residuals);
            if new_square < square {
                (positions, residuals, jacobian, square) = (tried, new_residuals, new_jacobian, new_square);
                let (factor, least) = ASSEMBLY_DAMPING_DECREASE;
                damping = f64::max(damping * factor, least);
            } else {
                let (factor, least) = ASSEMBLY_DAMPING_INCREASE;
                damping = f64::max(damping * factor, least);
            }
            stalled = if square < ASSEMBLY_PROGRESS * best { 0 } else { stalled + 1 };
            best = best.min(square);
        }
        self.check_closed(&positions, &self.driver_values())?;
        Ok(positions)
    }

    /// Refuses positions in which an equation does not hold with the drivers at these values.
    ///
    /// # Errors
    /// `DoesNotClose`, `NotFinite`.
    pub(super) fn check_closed(
        &self,
        positions: &[[f64; 3]],
        driver_values: &[f64],
    ) -> Result<(), PlanarError> {
        let (residuals, _) = row_scaled(self.constraints_at(positions, driver_values))?;
        let (equation, residual) = residuals.iter().enumerate().fold((0, 0.0f64), |worst, (at, residual)| {
            if residual.abs() > worst.1 { (at, residual.abs()) } else { worst }
        });
        if residual <= ACCEPTED_RESIDUAL * self.reach(positions) {
            Ok(())
        } else {
            Err(PlanarError::DoesNotClose { joint: self.owners[equation], residual })
        }
    }

    /// Residuals and Jacobian with the drivers at their own values, row-scaled.
    fn row_scaled(&self, positions: &[[f64; 3]]) -> Result<(Vec<f64>, SparseMatrix), PlanarError> {
        row_scaled(self.constraints(positions))
    }
}

/// Residuals and Jacobian, each row over its largest entry: residuals in m for every measure.
fn row_scaled(constraints: Constraints) -> Result<(Vec<f64>, SparseMatrix), PlanarError> {
    let Constraints { mut residuals, mut jacobian } = constraints;
    let entries = jacobian.rows().iter().flatten().map(|(_, entry)| entry);
    if residuals.iter().chain(entries).any(|x| !x.is_finite()) {
        return Err(PlanarError::NotFinite);
    }
    for (residual, row) in residuals.iter_mut().zip(jacobian.rows_mut()) {
        let largest = row.iter().fold(0.0f64, |most, (_, entry)| most.max(entry.abs()));
        if largest > 0.0 {
            *residual /= largest;
            for (_, entry) in row {
                *entry /= largest;
            }
        }
    }
    Ok((residuals, jacobian))
}

fn sum_of_squares(x: &[f64]) -> f64 {
    x.iter().map(|x| x * x).sum()
}
