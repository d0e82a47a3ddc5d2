//! Continuation: a mechanism is moved from one position to another on its branch of assembly.

use super::{PlanarError, System, system::Constraints};
use dalembert_numerics::linalg::Elimination;

/// The largest move of one step, in parts of the size of the mechanism.
pub(super) const STEP: f64 = 0.2;
/// The smallest step, in parts of the whole way: below it the mechanism has come to its end.
const SMALLEST: f64 = 1e-11;
/// Ratio of the last pivot to the first below which accelerations are rounding noise: their errors are divided by the
/// cube of the distance to a change point.
const VAGUE: f64 = 1e-5;
/// Below this part rounding decides on which branch a position lies: no step ends there but the last.
const LOST: f64 = 1e-6;
/// The most steps of one way: some thirty turns of a crank.
const MOST_STEPS: usize = 1_000;
/// A correction above this part of the step is a jump.
pub(super) const JUMP: f64 = 0.1;
/// A correction below this part of the step stays on the smooth path, even where two branches cross.
pub(super) const SMOOTH: f64 = 2e-3;

/// The end of a continuation.
#[derive(Debug, Clone, PartialEq)]
pub struct Continuation {
    /// The positions.
    pub positions: Vec<[f64; 3]>,
    /// The change points passed: singular positions in which two branches of assembly cross.
    pub change_points: Vec<ChangePoint>,
}

/// A change point: a singular position in which two branches of assembly cross.
#[derive(Debug, Clone, PartialEq)]
pub struct ChangePoint {
    /// About where each driver was, m or rad.
    pub values: Vec<f64>,
}

impl System {
    /// Moves the drivers evenly from the values that they have in closed positions to others, by steps so small that
    /// the path of every body can be followed: a prediction with velocity and acceleration, then Newton's method.
    ///
    /// A step that Newton's method would change much, or that would turn the sign of `det Φ_q`, is halved: so a
    /// linkage never flips to its other branch. Where no step leads on, the mechanism has reached its limit.
    ///
    /// Values that differ from those of the positions by rounding alone are reached already.
    ///
    /// # Errors
    /// `Limit` with the last value that can be reached; `TooFar` beyond some thirty turns; as for [`motion`](System::motion) if it cannot even start.
    pub fn continue_to(&self, positions: &[[f64; 3]], values: &[f64]) -> Result<Continuation, PlanarError> {
        let from: Vec<f64> =
            self.mechanism.drivers.iter().map(|driver| self.value(&driver.measure, positions)).collect();
        let way: Vec<f64> = values.iter().zip(&from).map(|(to, from)| to - from).collect();
        if largest(&way) <= 4.0 * f64::EPSILON * self.reach(positions) {
            self.closed_at(positions, values)?;
            return Ok(Continuation { positions: positions.to_vec(), change_points: Vec::new() });
        }
        let still = vec![0.0; way.len()];
        let at =
            |done: f64| -> Vec<f64> { from.iter().zip(&way).map(|(from, way)| from + done * way).collect() };
        let mut here = Continuation { positions: positions.to_vec(), change_points: Vec::new() };
        let mut moving = self.clone();
        let (mut done, mut step, mut steps) = (0.0, 1.0f64, 0);
        while done < 1.0 {
            steps += 1;
            if steps > MOST_STEPS {
                return Err(PlanarError::TooFar { driver: self.leader(&way) });
            }
            let elimination = match moving.factored(&here.positions) {
                Ok(elimination) => elimination,
                Err(error) if done == 0.0 => return Err(error),
                Err(_) => return Err(self.limit(&way, &at(done))),
            };
            let tangent = moving.motion_with(&elimination, &here.positions, &way, &still)?;
            let scaled = |rates: &[[f64; 3]]| -> Vec<f64> {
                rates.iter().flat_map(|[x, y, angle]| [*x, *y, angle * self.length]).collect()
            };
            let (first, mut second) = (scaled(&tangent.velocities), scaled(&tangent.accelerations));
            if elimination.smallest_pivot() < VAGUE {
                second.fill(0.0);
            }
            let (fast, bent) = (largest(&first), largest(&second));
            let rows = kept(&elimination);
            let [sign, _] = self.sign(&here.positions, &rows)?;
            let longest = STEP * self.length / fast;
            let curved = (STEP * self.length / bent).sqrt();
            step = (2.0 * step).min(1.0 - done).min(longest).min(curved);
            loop {
                let end = if step >= 1.0 - done { 1.0 } else { done + step };
                let predicted: Vec<f64> =
                    first.iter().zip(&second).map(|(v, a)| step * v + step * step * a / 2.0).collect();
                let predicted = self.moved(&here.positions, &predicted, 1.0);
                moving.driven_to(&at(end));
                let allowed = JUMP * step * fast;
                if let Some((found, correction)) = moving.corrected(predicted, &rows, allowed) {
                    let [there, apart] = self.sign(&found, &rows)?;
                    let turned = there != sign;
                    let smooth = !turned || correction <= SMOOTH * step * fast || fast == 0.0;
                    if smooth && (apart > LOST || end >= 1.0) {
                        if turned && sign != 0.0 {
                            here.change_points.push(ChangePoint { values: at(f64::midpoint(done, end)) });
                        }
                        here.positions = found;
                        done = end;
                        break;
                    }
                }
                step /= 2.0;
                if step < SMALLEST {
                    return Err(self.limit(&way, &at(done)));
                }
            }
        }
        self.closed_at(&here.positions, values)?;
        Ok(here)
    }

    /// The same mechanism with its drivers at other values, and its positions there, reached by continuation.
    ///
    /// # Errors
    /// As for [`continue_to`](System::continue_to).
    pub fn taken_to(
        mut self,
        positions: &[[f64; 3]],
        values: &[f64],
    ) -> Result<(Self, Vec<[f64; 3]>), PlanarError> {
        let reached = self.continue_to(positions, values)?.positions;
        self.driven_to(values);
        Ok((self, reached))
    }

    fn closed_at(&self, positions: &[[f64; 3]], values: &[f64]) -> Result<(), PlanarError> {
        let mut there = self.clone();
        there.driven_to(values);
        there.closed(positions)
    }

    /// The limit, named by the driver that was to go farthest.
    fn limit(&self, way: &[f64], at: &[f64]) -> PlanarError {
        let driver = self.leader(way);
        PlanarError::Limit { driver, at: at.get(driver).copied().unwrap_or(0.0) }
    }

    /// The driver that is to go farthest.
    fn leader(&self, way: &[f64]) -> usize {
        let extent = |driver: usize| {
            let in_length = if self.mechanism.drivers[driver].measure.is_angle() { self.length } else { 1.0 };
            way[driver].abs() * in_length
        };
        (0..way.len()).max_by(|&a, &b| extent(a).total_cmp(&extent(b))).unwrap_or(0)
    }

    /// The sign of the determinant of some of the equations, and how far they are from depending on each other.
    fn sign(&self, positions: &[[f64; 3]], rows: &[usize]) -> Result<[f64; 2], PlanarError> {
        let elimination = Elimination::new(&self.constraints(positions).jacobian.select_rows(rows))?;
        Ok([elimination.sign(), elimination.smallest_pivot()])
    }

    /// Newton's method on some of the equations; none if it does not converge with corrections below what is
    /// allowed in all.
    fn corrected(
        &self,
        mut positions: Vec<[f64; 3]>,
        rows: &[usize],
        allowed: f64,
    ) -> Option<(Vec<[f64; 3]>, f64)> {
        let (mut total, mut last) = (0.0, f64::INFINITY);
        let rounding = 4.0 * f64::EPSILON * self.reach(&positions);
        for _ in 0..12 {
            let Constraints { residuals, jacobian } = self.constraints(&positions);
            let residuals: Vec<f64> = rows.iter().map(|&row| residuals[row]).collect();
            let is_closed = largest(&residuals) <= 4.0 * rounding;
            let elimination = Elimination::new(&jacobian.select_rows(rows)).ok()?;
            if elimination.rank() < rows.len() {
                return None;
            }
            let change = elimination.solve(&residuals).ok()?;
            positions = self.moved(&positions, &change, -1.0);
            let size = largest(&change);
            total += size;
            if total > allowed.max(16.0 * rounding) {
                return None;
            }
            // At the level of rounding, or no more progress there: near a change point the rounding of the residuals alone makes
            // corrections that are much larger than it.
            if size <= rounding || (size >= last && (is_closed || size <= 1e3 * rounding)) {
                return Some((positions, total));
            }
            last = size;
        }
        None
    }
}

/// The rows of an elimination that are kept, in their order.
fn kept(elimination: &Elimination) -> Vec<usize> {
    let mut rows = elimination.independent_rows().to_vec();
    rows.sort_unstable();
    rows
}

pub(super) fn largest(x: &[f64]) -> f64 {
    x.iter().fold(0.0, |most, x| most.max(x.abs()))
}
