//! Step-by-step methods for `M ẍ + C ẋ + K x = F(t)`.

use dalembert_numerics::linalg::{Elimination, LinalgError};
use nalgebra::{DMatrix, DVector};

use super::IntegrationMethod;

/// Displacements, velocities and accelerations at 0, Δt, 2Δt, …, or what is known of them.
pub(super) struct Integrated {
    pub(super) displacements: Vec<DVector<f64>>,
    pub(super) velocities: Vec<DVector<f64>>,
    pub(super) accelerations: Vec<DVector<f64>>,
}

/// The equations of motion, the time step and the number of steps.
pub(super) struct Equations<'a> {
    /// `M`, `C`, `K`.
    pub(super) matrices: [&'a DMatrix<f64>; 3],
    /// The load at a time.
    pub(super) load: &'a dyn Fn(f64) -> DVector<f64>,
    pub(super) start: [&'a DVector<f64>; 2],
    pub(super) step: f64,
    pub(super) count: usize,
}

pub(super) fn solved(elimination: &Elimination, b: &DVector<f64>) -> Result<DVector<f64>, LinalgError> {
    elimination.solve(b.as_slice()).map(DVector::from_vec)
}

impl Equations<'_> {
    pub(super) fn time(&self, n: usize) -> f64 {
        self.step * n as f64
    }

    /// The load after `n` steps.
    pub(super) fn force(&self, n: usize) -> DVector<f64> {
        (self.load)(self.time(n))
    }

    /// `M ẍ = F − C ẋ − K x`
    fn acceleration(
        &self,
        mass: &Elimination,
        force: &DVector<f64>,
        [x, v]: [&DVector<f64>; 2],
    ) -> Result<DVector<f64>, LinalgError> {
        let [_, c, k] = self.matrices;
        solved(mass, &(force - c * v - k * x))
    }

    fn begun(&self) -> Result<(Integrated, Elimination), LinalgError> {
        let mass = Elimination::new(self.matrices[0])?;
        let [x, v] = self.start;
        let a = self.acceleration(&mass, &self.force(0), [x, v])?;
        let motion = Integrated {
            displacements: vec![x.clone()],
            velocities: vec![v.clone()],
            accelerations: vec![a],
        };
        Ok((motion, mass))
    }

    /// The motion by a method; `None` where the method is exact between the points of the load, which others work out.
    ///
    /// # Errors
    /// A singular mass or effective stiffness.
    pub(super) fn integrate(&self, method: &IntegrationMethod) -> Result<Option<Integrated>, LinalgError> {
        Ok(Some(match method {
            IntegrationMethod::CentralDifference => self.central_difference(self.count)?,
            IntegrationMethod::AverageAcceleration => self.newmark([0.5, 0.25])?,
            IntegrationMethod::LinearAcceleration => self.newmark([0.5, 1.0 / 6.0])?,
            IntegrationMethod::Newmark { gamma, beta } => self.newmark([*gamma, *beta])?,
            IntegrationMethod::Wilson { theta } => self.wilson(*theta)?,
            IntegrationMethod::Houbolt => self.houbolt()?,
            IntegrationMethod::RungeKutta => self.runge_kutta()?,
            IntegrationMethod::LinearLoad => return Ok(None),
        }))
    }

    /// Central differences: velocity and acceleration of a step need the displacement of the next one.
    fn central_difference(&self, count: usize) -> Result<Integrated, LinalgError> {
        let ([m, c, k], h) = (self.matrices, self.step);
        let (mut motion, _) = self.begun()?;
        let [x0, v0] = self.start;
        let effective = Elimination::new(&(m / (h * h) + c / (2.0 * h)))?;
        let (before, now) = (m / (h * h) - c / (2.0 * h), k - m * (2.0 / (h * h)));
        let mut last = x0 - v0 * h + &motion.accelerations[0] * (h * h / 2.0);
        let mut x = x0.clone();
        for n in 0..=count {
            let next = solved(&effective, &(self.force(n) - &before * &last - &now * &x))?;
            if n > 0 {
                motion.velocities.push((&next - &last) / (2.0 * h));
                motion.accelerations.push((&next - &x * 2.0 + &last) / (h * h));
            }
            if n < count {
                motion.displacements.push(next.clone());
            }
            last = std::mem::replace(&mut x, next);
        }
        Ok(motion)
    }

    /// Newmark: the acceleration within a step is described by γ and β.
    fn newmark(&self, [gamma, beta]: [f64; 2]) -> Result<Integrated, LinalgError> {
        let ([m, c, k], h) = (self.matrices, self.step);
        let (mut motion, _) = self.begun()?;
        let effective = Elimination::new(&(m / (beta * h * h) + c * (gamma / (beta * h)) + k))?;
        for n in 0..self.count {
            let (x, v, a) = motion.last();
            let inertia = x / (beta * h * h) + v / (beta * h) + a * (0.5 / beta - 1.0);
            let drag =
                x * (gamma / (beta * h)) + v * (gamma / beta - 1.0) + a * (h / 2.0 * (gamma / beta - 2.0));
            let next = solved(&effective, &(self.force(n + 1) + m * inertia + c * drag))?;
            let acceleration = (&next - x) / (beta * h * h) - v / (beta * h) - a * (0.5 / beta - 1.0);
            let velocity = v + (a * (1.0 - gamma) + &acceleration * gamma) * h;
            motion.push(next, velocity, acceleration);
        }
        Ok(motion)
    }

    /// Wilson: the acceleration is linear up to `t + θ Δt`, where the equation of motion holds.
    fn wilson(&self, theta: f64) -> Result<Integrated, LinalgError> {
        let ([m, c, k], h) = (self.matrices, self.step);
        let (mut motion, _) = self.begun()?;
        let long = theta * h;
        let effective = Elimination::new(&(m * (6.0 / (long * long)) + c * (3.0 / long) + k))?;
        for n in 0..self.count {
            let (x, v, a) = motion.last();
            let (now, then) = (self.force(n), self.force(n + 1));
            let force = &now + (then - &now) * theta;
            let inertia = x * (6.0 / (long * long)) + v * (6.0 / long) + a * 2.0;
            let drag = x * (3.0 / long) + v * 2.0 + a * (long / 2.0);
            let beyond = solved(&effective, &(force + m * inertia + c * drag))?;
            let acceleration = (beyond - x) * (6.0 / (theta * long * long)) - v * (6.0 / (theta * long))
                + a * (1.0 - 3.0 / theta);
            let velocity = v + (a + &acceleration) * (h / 2.0);
            let next = x + v * h + (&acceleration + a * 2.0) * (h * h / 6.0);
            motion.push(next, velocity, acceleration);
        }
        Ok(motion)
    }

    /// Houbolt: a cubic through four displacements; the first two steps are central differences.
    fn houbolt(&self) -> Result<Integrated, LinalgError> {
        let ([m, c, k], h) = (self.matrices, self.step);
        let mut motion = self.central_difference(self.count.min(2))?;
        let effective = Elimination::new(&(m * (2.0 / (h * h)) + c * (11.0 / (6.0 * h)) + k))?;
        for n in 2..self.count {
            let [x2, x1, x] = [n - 2, n - 1, n].map(|at| &motion.displacements[at]);
            let inertia = (x * 5.0 - x1 * 4.0 + x2) / (h * h);
            let drag = (x * 3.0 - x1 * 1.5 + x2 / 3.0) / h;
            let next = solved(&effective, &(self.force(n + 1) + m * &inertia + c * &drag))?;
            let acceleration = &next * (2.0 / (h * h)) - inertia;
            let velocity = &next * (11.0 / (6.0 * h)) - drag;
            motion.push(next, velocity, acceleration);
        }
        Ok(motion)
    }

    /// Runge–Kutta of the fourth order, on displacements and velocities.
    fn runge_kutta(&self) -> Result<Integrated, LinalgError> {
        let (mut motion, mass) = self.begun()?;
        let h = self.step;
        for n in 0..self.count {
            let (x, v, a) = motion.last();
            let middle = (self.load)(self.time(n) + h / 2.0);
            let end = self.force(n + 1);
            let (x2, v2) = (x + v * (h / 2.0), v + a * (h / 2.0));
            let a2 = self.acceleration(&mass, &middle, [&x2, &v2])?;
            let (x3, v3) = (x + &v2 * (h / 2.0), v + &a2 * (h / 2.0));
            let a3 = self.acceleration(&mass, &middle, [&x3, &v3])?;
            let (x4, v4) = (x + &v3 * h, v + &a3 * h);
            let a4 = self.acceleration(&mass, &end, [&x4, &v4])?;
            let next = x + (v + (&v2 + &v3) * 2.0 + &v4) * (h / 6.0);
            let velocity = v + (a + (a2 + a3) * 2.0 + a4) * (h / 6.0);
            let acceleration = self.acceleration(&mass, &end, [&next, &velocity])?;
            motion.push(next, velocity, acceleration);
        }
        Ok(motion)
    }
}

impl Integrated {
    fn at(&self, n: usize) -> (&DVector<f64>, &DVector<f64>, &DVector<f64>) {
        (&self.displacements[n], &self.velocities[n], &self.accelerations[n])
    }

    fn last(&self) -> (&DVector<f64>, &DVector<f64>, &DVector<f64>) {
        self.at(self.displacements.len() - 1)
    }

    fn push(&mut self, displacement: DVector<f64>, velocity: DVector<f64>, acceleration: DVector<f64>) {
        self.displacements.push(displacement);
        self.velocities.push(velocity);
        self.accelerations.push(acceleration);
    }
}
