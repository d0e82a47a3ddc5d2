//! Equilibria of a mechanism and their stability.

use nalgebra::{DMatrix, DVector};

use super::{
    Model, PlanarError, PlanarLoad, PlanarState, RelativeCoordinate,
    inverse_dynamics::virtual_power,
    measure::{bias, gradient, poses, rate},
    tolerances::{
        EQUILIBRIUM_EFFORT, EQUILIBRIUM_MAX_ITERATIONS, EQUILIBRIUM_MAX_STEP, EQUILIBRIUM_STEP,
        NEUTRAL_EIGENVALUE, ZERO_STIFFNESS,
    },
};
use dalembert_numerics::{linalg, roots};

/// A position in which the drivers need no effort.
#[derive(Debug, Clone, PartialEq)]
pub struct Equilibrium {
    /// The values of the drivers' measures, m or rad.
    pub values: Vec<f64>,
    /// The positions.
    pub positions: Vec<[f64; 3]>,
    /// The stiffness `∂²V/∂m_i ∂m_j` in the measures of the drivers: the growth of the holding efforts.
    pub stiffness: DMatrix<f64>,
    /// The lowest eigenvalue of the stiffness, with each measure in the scale that makes its diagonal ±1.
    pub lowest: f64,
    /// The stability that follows.
    pub stability: Stability,
}

/// The stability of an equilibrium.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Stability {
    /// The potential energy has a minimum.
    Stable,
    /// It has no minimum.
    Unstable,
    /// To second order it does not decide.
    Neutral,
}

/// One position of a mechanism that is moved through a range.
#[derive(Debug, Clone, PartialEq)]
pub struct SweepSample {
    /// The value of the moved driver, m or rad.
    pub value: f64,
    /// The positions.
    pub positions: Vec<[f64; 3]>,
    /// The effort that holds it there, `dV/dm` where a potential is, N or N m.
    pub effort: f64,
    /// The potential energy, if there is one, J.
    pub potential: Option<f64>,
}

/// A position of a mechanism with one driver in which a measure has a value.
#[derive(Debug, Clone, PartialEq)]
pub struct StopPosition {
    /// The value of the driver, m or rad.
    pub value: f64,
    /// The positions.
    pub positions: Vec<[f64; 3]>,
    /// The effort `Q = (dV/dm)/(dc/dm)` along the measure c that holds the mechanism there, N or N m.
    pub effort: f64,
}

impl Model {
    /// The efforts with which the drivers hold the mechanism at rest: `−Σ Q ∂q/∂m`, the gradient of the potential
    /// energy, N or N m. Friction is left out.
    ///
    /// # Errors
    /// As for [`kinematics`](Model::kinematics).
    pub fn holding_efforts(&self, positions: &[[f64; 3]]) -> Result<Vec<f64>, PlanarError> {
        let coefficients = self.velocity_coefficients(&self.factored(positions)?)?;
        let applied = self.applied(positions, &vec![[0.0; 3]; positions.len()]);
        let power = |motion: &[[f64; 3]]| -> f64 {
            applied.iter().map(|(_, parts)| virtual_power(parts, motion)).sum()
        };
        Ok(coefficients.iter().map(|motion| -power(motion)).collect())
    }

    /// The stiffness `∂²V/∂m_i ∂m_j` in the measures of the drivers, the growth of the holding efforts; its symmetric
    /// part where a load has no potential.
    ///
    /// Along a motion at unit velocity and without acceleration of the drivers the virtual power of an effort Q along
    /// a measure m changes as `Q′ ṁ² + Q m̈`, that of a force at a point as `F · a`.
    ///
    /// # Errors
    /// As for [`kinematics`](Model::kinematics).
    pub fn stiffness(&self, positions: &[[f64; 3]]) -> Result<DMatrix<f64>, PlanarError> {
        let elimination = self.factored(positions)?;
        let drivers = self.mechanism.drivers.len();
        let curvature = |moved: &[usize]| -> Result<f64, PlanarError> {
            let mut rates = vec![0.0; drivers];
            for &driver in moved {
                rates[driver] = 1.0;
            }
            let state = self.motion_with(&elimination, positions, &rates, &vec![0.0; drivers])?;
            Ok(-self.change_of_power(&state))
        };
        let own: Vec<f64> = (0..drivers).map(|driver| curvature(&[driver])).collect::<Result<_, _>>()?;
        let mut stiffness = DMatrix::from_diagonal(&DVector::from_vec(own));
        for row in 0..drivers {
            for column in 0..row {
                let both = curvature(&[row, column])?;
                let mixed = (both - stiffness[(row, row)] - stiffness[(column, column)]) / 2.0;
                (stiffness[(row, column)], stiffness[(column, row)]) = (mixed, mixed);
            }
        }
        Ok(stiffness)
    }

    /// The change of the power of loads and weights along a motion, W/s, as if it were slow.
    fn change_of_power(&self, state: &PlanarState) -> f64 {
        let poses = poses(&state.positions);
        let [gx, gy] = self.mechanism.gravity;
        let bodies = self.mechanism.bodies.iter().zip(&state.accelerations);
        let weights: f64 = bodies.map(|(body, a)| body.mass * (gx * a[0] + gy * a[1])).sum();
        let of_load = |load: &PlanarLoad| match load {
            PlanarLoad::Force { at, force, turns_with } => {
                let [_, v, a] = self.point(*at, state);
                let [fx, fy] = turns_with.map_or(*force, |body| poses[body].turned(*force));
                let turning = turns_with.map_or(0.0, |body| state.velocities[body][2]);
                fx * a[0] + fy * a[1] + turning * (fx * v[1] - fy * v[0])
            }
            PlanarLoad::Effort { measure, effort } => {
                let gradient = gradient(measure, &poses);
                let [speed, tangential] =
                    [&state.velocities, &state.accelerations].map(|motion| rate(measure, &gradient, motion));
                let acceleration = tangential + bias(measure, &poses, &state.velocities);
                let [growth, _] = effort.gradient(gradient.value);
                growth * speed * speed + effort.at(gradient.value, 0.0) * acceleration
            }
            PlanarLoad::Friction { .. } => 0.0,
        };
        weights + self.mechanism.loads.iter().map(of_load).sum::<f64>()
    }

    /// Samples of the mechanism in equal steps of its first driver from one value to another; the others are held. They
    /// end early at a limit position.
    ///
    /// # Errors
    /// As for [`continue_to`](Model::continue_to) to the first value.
    pub fn samples(
        &self,
        positions: &[[f64; 3]],
        [from, to]: [f64; 2],
        steps: usize,
    ) -> Result<Vec<SweepSample>, PlanarError> {
        let mut values = self.driven_values(positions);
        let mut samples: Vec<SweepSample> = Vec::with_capacity(steps + 1);
        for step in 0..=steps {
            let value = from + (to - from) * step as f64 / steps.max(1) as f64;
            let last = samples.last().map_or(positions, |sample| &sample.positions).to_vec();
            values[0] = value;
            let there = match self.continue_to(&last, &values) {
                Ok(followed) => followed.positions,
                Err(error) if samples.is_empty() => return Err(error),
                Err(_) => break,
            };
            match self.holding_efforts(&there) {
                Ok(efforts) => {
                    let potential = self.potential(&there);
                    samples.push(SweepSample { value, positions: there, effort: efforts[0], potential });
                }
                // A change point between two others has no effort of its own.
                Err(PlanarError::DeadCentre { .. }) => {}
                Err(error) => return Err(error),
            }
        }
        Ok(samples)
    }

    /// The equilibria of a mechanism with one driver, between samples of [`samples`](Model::samples): one wherever
    /// the holding effort changes its sign.
    ///
    /// # Errors
    /// As for [`continue_to`](Model::continue_to).
    pub fn equilibria(&self, samples: &[SweepSample]) -> Result<Vec<Equilibrium>, PlanarError> {
        let largest = samples.iter().fold(0.0f64, |most, sample| most.max(sample.effort.abs()));
        let mut found = Vec::new();
        for (at, pair) in samples.windows(2).enumerate() {
            let [a, b] = pair else { continue };
            let value = if a.effort == 0.0 {
                a.value
            } else if b.effort == 0.0 {
                // It begins the next pair, unless there is none.
                if at + 2 < samples.len() {
                    continue;
                }
                b.value
            } else if a.effort.signum() == b.effort.signum() {
                continue;
            } else {
                let effort = |positions: &[[f64; 3]]| self.holding_efforts(positions).ok().map(|e| e[0]);
                match self.zero_between([a, b], effort) {
                    Some(value) => value,
                    None => continue,
                }
            };
            let positions = self.continue_to(&a.positions, &[value])?.positions;
            found.push(self.classified(vec![value], positions, largest)?);
        }
        Ok(found)
    }

    /// The value of the driver between two samples at which a function of the positions is zero.
    fn zero_between(
        &self,
        [a, b]: [&SweepSample; 2],
        function: impl Fn(&[[f64; 3]]) -> Option<f64>,
    ) -> Option<f64> {
        let at = |value: f64| {
            let there = self.continue_to(&a.positions, &[value]).ok();
            there.and_then(|there| function(&there.positions)).unwrap_or(f64::NAN)
        };
        let ends = if a.value < b.value { [a.value, b.value] } else { [b.value, a.value] };
        roots::find(at, ends, |_| std::ops::ControlFlow::Continue(())).ok()
    }

    /// The positions between samples of [`samples`](Model::samples) in which a measure has a value, with the effort along
    /// that measure which holds the mechanism there by itself: by virtual work `Q δc = dV`. Left out where the measure
    /// does not change with the driver.
    ///
    /// # Errors
    /// As for [`continue_to`](Model::continue_to).
    pub fn stop_positions(
        &self,
        samples: &[SweepSample],
        measure: &RelativeCoordinate,
        limit: f64,
    ) -> Result<Vec<StopPosition>, PlanarError> {
        let beyond = |positions: &[[f64; 3]]| self.value(measure, positions) - limit;
        let mut found = Vec::new();
        for pair in samples.windows(2) {
            let [a, b] = pair else { continue };
            let ends = [beyond(&a.positions), beyond(&b.positions)];
            if ends[0].signum() == ends[1].signum() && ends[1] != 0.0 || ends[0] == 0.0 && !found.is_empty() {
                continue;
            }
            let Some(value) = self.zero_between([a, b], |positions| Some(beyond(positions))) else {
                continue;
            };
            let positions = self.continue_to(&a.positions, &[value])?.positions;
            let coefficients = self.velocity_coefficients(&self.factored(&positions)?)?;
            let poses = poses(&positions);
            let change = rate(measure, &gradient(measure, &poses), &coefficients[0]);
            let scale = self.length_of(measure) / self.length_of(&self.mechanism.drivers[0].measure);
            if change.abs() * scale > ZERO_STIFFNESS {
                let effort = self.holding_efforts(&positions)?[0] / change;
                found.push(StopPosition { value, positions, effort });
            }
        }
        Ok(found)
    }

    /// The equilibrium near closed positions, for any number of drivers: Newton's method on the holding efforts, with
    /// steps of at most a fifth of the size of the mechanism.
    ///
    /// # Errors
    /// `NoEquilibrium` if it is not found; as for [`continue_to`](Model::continue_to).
    pub fn equilibrium_near(&self, positions: &[[f64; 3]]) -> Result<Equilibrium, PlanarError> {
        let drivers = &self.mechanism.drivers;
        let mut here = positions.to_vec();
        let largest = self.holding_efforts(&here)?.iter().fold(0.0f64, |most, effort| most.max(effort.abs()));
        for _ in 0..EQUILIBRIUM_MAX_ITERATIONS {
            let values = self.driven_values(&here);
            let efforts = DVector::from_vec(self.holding_efforts(&here)?);
            let stiffness = self.stiffness(&here)?;
            let Ok(solved) = linalg::solve(&stiffness, &efforts) else {
                return Err(PlanarError::NoEquilibrium);
            };
            let steps = solved.x.iter().zip(drivers);
            let size = steps
                .map(|(x, driver)| x * self.length_of(&driver.measure))
                .fold(0.0f64, |most, x| most.max(x.abs()));
            let fraction = f64::min(1.0, EQUILIBRIUM_MAX_STEP * self.length / size.max(f64::MIN_POSITIVE));
            let next: Vec<f64> =
                values.iter().zip(solved.x.iter()).map(|(value, x)| value - fraction * x).collect();
            here = self.continue_to(&here, &next)?.positions;
            if size <= EQUILIBRIUM_STEP * self.reach(&here) {
                return self.classified(next, here, largest);
            }
        }
        let efforts = self.holding_efforts(&here)?;
        if efforts.iter().all(|effort| effort.abs() <= EQUILIBRIUM_EFFORT * largest) {
            let values = self.driven_values(&here);
            return self.classified(values, here, largest);
        }
        Err(PlanarError::NoEquilibrium)
    }

    /// The equilibrium in a position, with its stability; `largest` is the largest effort that occurs.
    fn classified(
        &self,
        values: Vec<f64>,
        positions: Vec<[f64; 3]>,
        largest: f64,
    ) -> Result<Equilibrium, PlanarError> {
        let stiffness = self.stiffness(&positions)?;
        let scale: Vec<f64> = (0..values.len())
            .map(|k| if stiffness[(k, k)] == 0.0 { 1.0 } else { stiffness[(k, k)].abs().sqrt() })
            .collect();
        let scaled = DMatrix::from_fn(values.len(), values.len(), |row, column| {
            stiffness[(row, column)] / (scale[row] * scale[column])
        });
        let lowest = linalg::symmetric_eigen(&scaled)?.values[0];
        let is_rounding = |k: usize| {
            let step = if self.mechanism.drivers[k].measure.is_angle() { 1.0 } else { self.length };
            stiffness[(k, k)].abs() <= ZERO_STIFFNESS * largest / step
        };
        let stability = if lowest.abs() < NEUTRAL_EIGENVALUE || (0..values.len()).any(is_rounding) {
            Stability::Neutral
        } else if lowest > 0.0 {
            Stability::Stable
        } else {
            Stability::Unstable
        };
        Ok(Equilibrium { values, positions, stiffness, lowest, stability })
    }
}
