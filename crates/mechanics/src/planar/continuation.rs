//! Continuation: a mechanism is moved from one position to another on its branch of assembly.

use super::{
    Model, PlanarError,
    kinematics::Constraints,
    tolerances::{
        CONTINUATION_MAX_ITERATIONS, MAX_CORRECTION, MAX_SMOOTH_CORRECTION, MAX_STEP, MAX_STEPS,
        MIN_PIVOT_OF_ACCELERATIONS, MIN_PIVOT_OF_BRANCH, MIN_STEP, POSITION_ROUNDING,
        ROUNDINGS_OF_CORRECTION, ROUNDINGS_OF_RESIDUAL, ROUNDINGS_OF_STALLED_CORRECTION,
    },
    vectors::largest,
};
use dalembert_numerics::linalg::Elimination;

/// The end of a continuation.
#[derive(Debug, Clone, PartialEq)]
pub struct Continuation {
    /// The positions that were reached.
    pub positions: Vec<[f64; 3]>,
    /// The change points passed: singular positions in which two branches of assembly cross.
    pub change_points: Vec<ChangePoint>,
}

/// A change point: a singular position in which two branches of assembly cross.
#[derive(Debug, Clone, PartialEq)]
pub struct ChangePoint {
    /// The approximate value of each driver, m or rad.
    pub values: Vec<f64>,
}

impl Model {
    /// Moves the drivers evenly from the values that they have in closed positions to others, by steps so small that
    /// the path of every body can be followed: a prediction with velocity and acceleration, then Newton's method.
    ///
    /// A step that Newton's method would change much, or that would turn the sign of `det Φ_q`, is halved: so a
    /// linkage never flips to its other branch. Where no step leads on, the mechanism has reached its limit.
    ///
    /// Values that differ from those of the positions by rounding alone are reached already.
    ///
    /// # Errors
    /// `Limit` with the last value that can be reached; `TooFar` beyond some thirty turns; as for
    /// [`kinematics`](Model::kinematics) if it cannot even start.
    pub fn continue_to(&self, positions: &[[f64; 3]], values: &[f64]) -> Result<Continuation, PlanarError> {
        let from = self.driven_values(positions);
        let path: Vec<f64> = values.iter().zip(&from).map(|(to, from)| to - from).collect();
        if largest(&path) <= POSITION_ROUNDING * self.reach(positions) {
            self.check_closed(positions, values)?;
            return Ok(Continuation { positions: positions.to_vec(), change_points: Vec::new() });
        }
        let no_acceleration = vec![0.0; path.len()];
        let at = |done: f64| -> Vec<f64> {
            from.iter().zip(&path).map(|(from, path)| from + done * path).collect()
        };
        let mut here = Continuation { positions: positions.to_vec(), change_points: Vec::new() };
        let (mut done, mut step, mut steps) = (0.0, 1.0f64, 0);
        while done < 1.0 {
            steps += 1;
            if steps > MAX_STEPS {
                return Err(PlanarError::TooFar { driver: self.farthest_driver(&path) });
            }
            let elimination = match self.factored(&here.positions) {
                Ok(elimination) => elimination,
                Err(error) if done == 0.0 => return Err(error),
                Err(_) => return Err(self.limit(&path, &at(done))),
            };
            let tangent = self.motion_with(&elimination, &here.positions, &path, &no_acceleration)?;
            let scaled = |rates: &[[f64; 3]]| -> Vec<f64> {
                rates.iter().flat_map(|[x, y, angle]| [*x, *y, angle * self.length]).collect()
            };
            let (first, mut second) = (scaled(&tangent.velocities), scaled(&tangent.accelerations));
            if elimination.smallest_pivot() < MIN_PIVOT_OF_ACCELERATIONS {
                second.fill(0.0);
            }
            let (velocity, acceleration) = (largest(&first), largest(&second));
            let rows = independent_rows(&elimination);
            let [sign, _] = self.sign(&here.positions, &rows)?;
            let by_velocity = MAX_STEP * self.length / velocity;
            let by_acceleration = (MAX_STEP * self.length / acceleration).sqrt();
            step = (2.0 * step).min(1.0 - done).min(by_velocity).min(by_acceleration);
            loop {
                let end = if step >= 1.0 - done { 1.0 } else { done + step };
                let predicted: Vec<f64> =
                    first.iter().zip(&second).map(|(v, a)| step * v + step * step * a / 2.0).collect();
                let predicted = self.displaced(&here.positions, &predicted, 1.0);
                let allowed = MAX_CORRECTION * step * velocity;
                if let Some((found, correction)) = self.corrected(predicted, &at(end), &rows, allowed) {
                    let [there, smallest_pivot] = self.sign(&found, &rows)?;
                    let sign_changes = there != sign;
                    let smooth = !sign_changes
                        || correction <= MAX_SMOOTH_CORRECTION * step * velocity
                        || velocity == 0.0;
                    if smooth && (smallest_pivot > MIN_PIVOT_OF_BRANCH || end >= 1.0) {
                        if sign_changes && sign != 0.0 {
                            here.change_points.push(ChangePoint { values: at(f64::midpoint(done, end)) });
                        }
                        here.positions = found;
                        done = end;
                        break;
                    }
                }
                step /= 2.0;
                if step < MIN_STEP {
                    return Err(self.limit(&path, &at(done)));
                }
            }
        }
        self.check_closed(&here.positions, values)?;
        Ok(here)
    }

    /// The model with its drivers at other values, and its positions there, reached by continuation.
    ///
    /// # Errors
    /// As for [`continue_to`](Model::continue_to).
    pub fn with_drivers_at(
        mut self,
        positions: &[[f64; 3]],
        values: &[f64],
    ) -> Result<(Self, Vec<[f64; 3]>), PlanarError> {
        let reached = self.continue_to(positions, values)?.positions;
        let first = self.first_driver();
        let driven = self.equations[first..].iter_mut().zip(&mut self.mechanism.drivers);
        for ((equation, driver), &value) in driven.zip(values) {
            equation.constant = Some(value);
            driver.value = value;
        }
        Ok((self, reached))
    }

    /// The limit, named by the driver that was to go farthest.
    fn limit(&self, path: &[f64], at: &[f64]) -> PlanarError {
        let driver = self.farthest_driver(path);
        PlanarError::Limit { driver, at: at.get(driver).copied().unwrap_or(0.0) }
    }

    /// The driver that is to go farthest.
    fn farthest_driver(&self, path: &[f64]) -> usize {
        let extent =
            |driver: usize| path[driver].abs() * self.length_of(&self.mechanism.drivers[driver].measure);
        (0..path.len()).max_by(|&a, &b| extent(a).total_cmp(&extent(b))).unwrap_or(0)
    }

    /// The sign of the determinant of some of the equations, and their smallest pivot over the largest.
    fn sign(&self, positions: &[[f64; 3]], rows: &[usize]) -> Result<[f64; 2], PlanarError> {
        let elimination = Elimination::of_sparse(&self.constraints(positions).jacobian.select_rows(rows))?;
        Ok([elimination.sign(), elimination.smallest_pivot()])
    }

    /// Newton's method on some of the equations with the drivers at these values: the positions and the sum of the
    /// corrections, m; none if it does not converge with a sum below what is allowed.
    fn corrected(
        &self,
        mut positions: Vec<[f64; 3]>,
        driver_values: &[f64],
        rows: &[usize],
        allowed: f64,
    ) -> Option<(Vec<[f64; 3]>, f64)> {
        let (mut total, mut last) = (0.0, f64::INFINITY);
        let rounding = POSITION_ROUNDING * self.reach(&positions);
        for _ in 0..CONTINUATION_MAX_ITERATIONS {
            let Constraints { residuals, jacobian } = self.constraints_at(&positions, driver_values);
            let residuals: Vec<f64> = rows.iter().map(|&row| residuals[row]).collect();
            let is_closed = largest(&residuals) <= ROUNDINGS_OF_RESIDUAL * rounding;
            let elimination = Elimination::of_sparse(&jacobian.select_rows(rows)).ok()?;
            if elimination.rank() < rows.len() {
                return None;
            }
            let change = elimination.solve(&residuals).ok()?;
            positions = self.displaced(&positions, &change, -1.0);
            let size = largest(&change);
            total += size;
            if total > allowed.max(ROUNDINGS_OF_CORRECTION * rounding) {
                return None;
            }
            // At the level of rounding, or no more progress there.
            let is_stalled =
                size >= last && (is_closed || size <= ROUNDINGS_OF_STALLED_CORRECTION * rounding);
            if size <= rounding || is_stalled {
                return Some((positions, total));
            }
            last = size;
        }
        None
    }
}

/// The independent rows of an elimination, in their order.
fn independent_rows(elimination: &Elimination) -> Vec<usize> {
    let mut rows = elimination.independent_rows().to_vec();
    rows.sort_unstable();
    rows
}
