//! Equilibrium positions of a mechanism and their stability.

use nalgebra::{DMatrix, DVector};

use super::{
    Load, PlanarError, State, System,
    balance::virtual_power,
    system::{bias, gradient, poses, project},
};
use dalembert_numerics::{linalg, roots};

/// A position in which the drivers need no effort.
#[derive(Debug, Clone, PartialEq)]
pub struct Equilibrium {
    /// The values of the drivers' measures, m or rad.
    pub values: Vec<f64>,
    /// The positions.
    pub positions: Vec<[f64; 3]>,
    /// `∂²V/∂m_i ∂m_j`: how the efforts needed to hold it grow.
    pub stiffness: DMatrix<f64>,
    /// The lowest eigenvalue of the stiffness, with each measure in the scale that makes its diagonal ±1.
    pub lowest: f64,
    /// Stability of the equilibrium.
    pub stability: Stability,
}

/// Stability of an equilibrium.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Stability {
    /// The potential energy has a minimum.
    Stable,
    /// It has none.
    Unstable,
    /// It does not tell, to second order.
    Neutral,
}

/// One position of a mechanism that is moved through a range.
#[derive(Debug, Clone, PartialEq)]
pub struct Sample {
    /// The value of the moved driver, m or rad.
    pub value: f64,
    /// The positions.
    pub positions: Vec<[f64; 3]>,
    /// The effort that holds it there, `dV/dm` where a potential is, N or N m.
    pub effort: f64,
    /// The potential energy, if there is one, J.
    pub potential: Option<f64>,
}

impl System {
    /// The efforts with which the drivers hold the mechanism at rest: `−Σ Q ∂q/∂m`, the Jacobian of the potential
    /// energy. Friction takes no part.
    ///
    /// # Errors
    /// As for [`motion`](System::motion).
    pub fn holding(&self, positions: &[[f64; 3]]) -> Result<Vec<f64>, PlanarError> {
        let coefficients = self.coefficients(&self.factored(positions)?)?;
        let applied = self.applied(positions, &vec![[0.0; 3]; positions.len()]);
        let power = |motion: &[[f64; 3]]| -> f64 {
            applied.iter().map(|(_, parts)| virtual_power(parts, motion)).sum()
        };
        Ok(coefficients.iter().map(|motion| -power(motion)).collect())
    }

    /// Stiffness matrix of the mechanism: derivatives of the holding efforts with respect to the driven coordinates,
    /// `∂²V/∂m_i ∂m_j`; its symmetric part where a load has no potential.
    ///
    /// Along a motion at unit velocity and without acceleration of the drivers the virtual power of an effort Q along
    /// a measure m changes as `Q′ ṁ² + Q m̈`, that of a force at a point as `F · a`.
    ///
    /// # Errors
    /// As for [`motion`](System::motion).
    pub fn stiffness(&self, positions: &[[f64; 3]]) -> Result<DMatrix<f64>, PlanarError> {
        let elimination = self.factored(positions)?;
        let drivers = self.mechanism.drivers.len();
        let along = |moved: &[usize]| -> Result<f64, PlanarError> {
            let mut rates = vec![0.0; drivers];
            for &driver in moved {
                rates[driver] = 1.0;
            }
            let state = self.motion_with(&elimination, positions, &rates, &vec![0.0; drivers])?;
            Ok(-self.change_of_power(&state))
        };
        let own: Vec<f64> = (0..drivers).map(|driver| along(&[driver])).collect::<Result<_, _>>()?;
        let mut stiffness = DMatrix::from_diagonal(&DVector::from_vec(own));
        for row in 0..drivers {
            for column in 0..row {
                let both = along(&[row, column])?;
                let mixed = (both - stiffness[(row, row)] - stiffness[(column, column)]) / 2.0;
                (stiffness[(row, column)], stiffness[(column, row)]) = (mixed, mixed);
            }
        }
        Ok(stiffness)
    }

    /// Rate of change of the power of loads and weights along a quasi-static motion.
    fn change_of_power(&self, state: &State) -> f64 {
        let poses = poses(&state.positions);
        let [gx, gy] = self.mechanism.gravity;
        let bodies = self.mechanism.bodies.iter().zip(&state.accelerations);
        let weights: f64 = bodies.map(|(body, a)| body.mass * (gx * a[0] + gy * a[1])).sum();
        let of_load = |load: &Load| match load {
            Load::Force { at, force, turns_with } => {
                let [_, v, a] = self.point(*at, state);
                let [fx, fy] = turns_with.map_or(*force, |body| poses[body].turned(*force));
                let turning = turns_with.map_or(0.0, |body| state.velocities[body][2]);
                fx * a[0] + fy * a[1] + turning * (fx * v[1] - fy * v[0])
            }
            Load::Effort { measure, effort } => {
                let gradient = gradient(measure, &poses);
                let rate = project(measure, &gradient, &state.velocities);
                let acceleration = project(measure, &gradient, &state.accelerations)
                    + bias(measure, &poses, &state.velocities);
                let [growth, _] = effort.gradient(gradient.value);
                growth * rate * rate + effort.at(gradient.value, 0.0) * acceleration
            }
            Load::Friction { .. } => 0.0,
        };
        weights + self.mechanism.loads.iter().map(of_load).sum::<f64>()
    }

    /// The mechanism in equal steps of its first driver from one value to another; the others are held. It ends
    /// early at a limit position.
    ///
    /// # Errors
    /// As for [`continue_to`](System::continue_to) to the first value.
    pub fn through(
        &self,
        positions: &[[f64; 3]],
        [from, to]: [f64; 2],
        steps: usize,
    ) -> Result<Vec<Sample>, PlanarError> {
        let mut values: Vec<f64> =
            self.mechanism.drivers.iter().map(|driver| self.value(&driver.measure, positions)).collect();
        let mut samples: Vec<Sample> = Vec::with_capacity(steps + 1);
        for step in 0..=steps {
            let value = from + (to - from) * step as f64 / steps.max(1) as f64;
            let last = samples.last().map_or(positions, |sample| &sample.positions).to_vec();
            values[0] = value;
            let there = match self.continue_to(&last, &values) {
                Ok(followed) => followed.positions,
                Err(error) if samples.is_empty() => return Err(error),
                Err(_) => break,
            };
            match self.holding(&there) {
                Ok(efforts) => {
                    let potential = self.potential(&there);
                    samples.push(Sample { value, positions: there, effort: efforts[0], potential });
                }
                // A change point between two others has no effort of its own.
                Err(PlanarError::DeadCentre { .. }) => {}
                Err(error) => return Err(error),
            }
        }
        Ok(samples)
    }

    /// The equilibria of a mechanism with one driver, between samples of [`through`](System::through): one wherever
    /// the holding effort changes its sign.
    ///
    /// # Errors
    /// As for [`continue_to`](System::continue_to).
    pub fn equilibria(&self, samples: &[Sample]) -> Result<Vec<Equilibrium>, PlanarError> {
        let largest = samples.iter().fold(0.0f64, |most, sample| most.max(sample.effort.abs()));
        let mut found = Vec::new();
        for (at, pair) in samples.windows(2).enumerate() {
            let [a, b] = pair else { continue };
            let value = if a.effort == 0.0 {
                a.value
            } else if b.effort == 0.0 {
                // The next pair has it, unless there is none.
                if at + 2 < samples.len() {
                    continue;
                }
                b.value
            } else if a.effort.signum() == b.effort.signum() {
                continue;
            } else {
                let effort = |value: f64| {
                    let there = self.continue_to(&a.positions, &[value]).ok();
                    there.and_then(|there| self.holding(&there.positions).ok()).map_or(f64::NAN, |e| e[0])
                };
                let ends = if a.value < b.value { [a.value, b.value] } else { [b.value, a.value] };
                match roots::find(effort, ends, |_| std::ops::ControlFlow::Continue(())) {
                    Ok(value) => value,
                    Err(_) => continue,
                }
            };
            let positions = self.continue_to(&a.positions, &[value])?.positions;
            found.push(self.judged(vec![value], positions, largest)?);
        }
        Ok(found)
    }

    /// The equilibrium near closed positions, for any number of drivers: Newton's method on the holding efforts, with
    /// steps of at most a fifth of the size of the mechanism.
    ///
    /// # Errors
    /// `NoEquilibrium` if it is not found; as for [`follow`](System::continue_to).
    pub fn equilibrium_near(&self, positions: &[[f64; 3]]) -> Result<Equilibrium, PlanarError> {
        let drivers = &self.mechanism.drivers;
        let mut here = positions.to_vec();
        let largest = self.holding(&here)?.iter().fold(0.0f64, |most, effort| most.max(effort.abs()));
        for _ in 0..100 {
            let values: Vec<f64> = drivers.iter().map(|driver| self.value(&driver.measure, &here)).collect();
            let efforts = DVector::from_vec(self.holding(&here)?);
            let stiffness = self.stiffness(&here)?;
            let Ok(solved) = linalg::solve(&stiffness, &efforts) else {
                return Err(PlanarError::NoEquilibrium);
            };
            let scale = |driver: usize| if drivers[driver].measure.is_angle() { self.length } else { 1.0 };
            let size =
                solved.x.iter().enumerate().fold(0.0f64, |most, (k, x)| most.max((x * scale(k)).abs()));
            let part = f64::min(1.0, 0.2 * self.length / size.max(f64::MIN_POSITIVE));
            let next: Vec<f64> =
                values.iter().zip(solved.x.iter()).map(|(value, x)| value - part * x).collect();
            here = self.continue_to(&here, &next)?.positions;
            if size <= 1e-13 * self.reach(&here) {
                return self.judged(next, here, largest);
            }
        }
        // Rounding may keep the last steps above the strictest measure.
        let efforts = self.holding(&here)?;
        if efforts.iter().all(|effort| effort.abs() <= 1e-9 * largest) {
            let values = drivers.iter().map(|driver| self.value(&driver.measure, &here)).collect();
            return self.judged(values, here, largest);
        }
        Err(PlanarError::NoEquilibrium)
    }

    fn judged(
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
        // What is rounding of the efforts that occur.
        let noise = |k: usize| {
            let step = if self.mechanism.drivers[k].measure.is_angle() { 1.0 } else { self.length };
            stiffness[(k, k)].abs() <= 1e-10 * largest / step
        };
        let stability = if lowest.abs() < 1e-9 || (0..values.len()).any(noise) {
            Stability::Neutral
        } else if lowest > 0.0 {
            Stability::Stable
        } else {
            Stability::Unstable
        };
        Ok(Equilibrium { values, positions, stiffness, lowest, stability })
    }
}
