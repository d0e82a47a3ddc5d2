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

fn solved(elimination: &Elimination, b: &DVector<f64>) -> Result<DVector<f64>, LinalgError> {
    elimination.solve(b.as_slice()).map(DVector::from_vec)
}

impl Equations<'_> {
    fn time(&self, n: usize) -> f64 {
        self.step * n as f64
    }

    /// The load after `n` steps.
    fn force(&self, n: usize) -> DVector<f64> {
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

    /// The residual of a method as a recurrence of another form, over the size of the load: of displacements alone for
    /// Newmark's methods, central differences and Houbolt's, of the equation of motion at `t + θ Δt` for Wilson's, and
    /// of powers of the state matrix for Runge–Kutta.
    pub(super) fn residual(&self, method: &IntegrationMethod, motion: &Integrated) -> Option<[f64; 2]> {
        let two_steps = |gamma_beta| Some(self.two_step_residual(gamma_beta, motion));
        match method {
            IntegrationMethod::CentralDifference => two_steps([0.5, 0.0]),
            IntegrationMethod::AverageAcceleration => two_steps([0.5, 0.25]),
            IntegrationMethod::LinearAcceleration => two_steps([0.5, 1.0 / 6.0]),
            IntegrationMethod::Newmark { gamma, beta } => two_steps([*gamma, *beta]),
            IntegrationMethod::Wilson { theta } => Some(self.wilson_residual(*theta, motion)),
            IntegrationMethod::Houbolt => Some(self.houbolt_residual(motion)),
            IntegrationMethod::RungeKutta => self.runge_kutta_residual(motion).ok(),
            IntegrationMethod::LinearLoad => None,
        }
    }

    /// Largest residual and the size of the terms in it.
    fn worst(&self, terms: impl Iterator<Item = [DVector<f64>; 4]>) -> [f64; 2] {
        terms.fold([0.0, f64::MIN_POSITIVE], |[worst, size]: [f64; 2], [inertia, drag, spring, force]| {
            let sizes =
                [&inertia, &drag, &spring, &force].map(DVector::amax).into_iter().fold(size, f64::max);
            [worst.max((inertia + drag + spring - force).amax()), sizes]
        })
    }

    /// Newmark's method as a linear two-step method.
    fn two_step_residual(&self, [gamma, beta]: [f64; 2], motion: &Integrated) -> [f64; 2] {
        let ([m, c, k], h) = (self.matrices, self.step);
        let weights = [0.5 + beta - gamma, 0.5 - 2.0 * beta + gamma, beta];
        self.worst(motion.displacements.windows(3).enumerate().map(|(n, x)| {
            let inertia = (&x[2] - &x[1] * 2.0 + &x[0]) / (h * h);
            let drag = (&x[2] * gamma + &x[1] * (1.0 - 2.0 * gamma) - &x[0] * (1.0 - gamma)) / h;
            let mixed = &x[0] * weights[0] + &x[1] * weights[1] + &x[2] * weights[2];
            let forces = [0, 1, 2].map(|at| self.force(n + at) * weights[at]);
            let force = forces.into_iter().fold(DVector::zeros(m.nrows()), |sum, force| sum + force);
            [m * inertia, c * drag, k * mixed, force]
        }))
    }

    fn houbolt_residual(&self, motion: &Integrated) -> [f64; 2] {
        let ([m, c, k], h) = (self.matrices, self.step);
        self.worst(motion.displacements.windows(4).enumerate().map(|(n, x)| {
            // Derivatives of the cubic through the four points, by differences of growing order.
            let d1 = &x[3] - &x[2];
            let d2 = &x[3] - &x[2] * 2.0 + &x[1];
            let d3 = &x[3] - &x[2] * 3.0 + &x[1] * 3.0 - &x[0];
            let velocity = (d1 + &d2 / 2.0 + &d3 / 3.0) / h;
            let acceleration = (d2 + d3) / (h * h);
            [m * acceleration, c * velocity, k * &x[3], self.force(n + 3)]
        }))
    }

    fn wilson_residual(&self, theta: f64, motion: &Integrated) -> [f64; 2] {
        let ([m, c, k], long) = (self.matrices, theta * self.step);
        self.worst((0..self.count).map(|n| {
            let (x, v, a) = motion.at(n);
            let beyond = a + (&motion.accelerations[n + 1] - a) * theta;
            let velocity = v + (a + &beyond) * (long / 2.0);
            let position = x + v * long + (a * 2.0 + &beyond) * (long * long / 6.0);
            let (now, then) = (self.force(n), self.force(n + 1));
            [m * beyond, c * velocity, k * position, &now + (then - &now) * theta]
        }))
    }

    /// One step is `y + h φ(hA)(A y + b)` with polynomials of the state matrix `A`.
    fn runge_kutta_residual(&self, motion: &Integrated) -> Result<[f64; 2], LinalgError> {
        let ([m, c, k], h) = (self.matrices, self.step);
        let (size, mass) = (m.nrows(), Elimination::new(m)?);
        let over_mass = |a: &DMatrix<f64>| -> Result<DMatrix<f64>, LinalgError> {
            let columns = a.column_iter().map(|column| solved(&mass, &column.into_owned()));
            Ok(DMatrix::from_columns(&columns.collect::<Result<Vec<_>, _>>()?))
        };
        let mut matrix = DMatrix::zeros(2 * size, 2 * size);
        matrix.view_mut((0, size), (size, size)).fill_with_identity();
        matrix.view_mut((size, 0), (size, size)).copy_from(&-over_mass(k)?);
        matrix.view_mut((size, size), (size, size)).copy_from(&-over_mass(c)?);
        let one = DMatrix::<f64>::identity(2 * size, 2 * size);
        let ha = matrix * h;
        let (ha2, ha3) = (&ha * &ha, &ha * &ha * &ha);
        let whole = &one + &ha + &ha2 / 2.0 + &ha3 / 6.0 + &ha2 * &ha2 / 24.0;
        let first = (&one + &ha + &ha2 / 2.0 + &ha3 / 4.0) * (h / 6.0);
        let middle = (&one * 4.0 + &ha * 2.0 + &ha2 / 2.0) * (h / 6.0);
        let state = |n: usize| {
            let (x, v, _) = motion.at(n);
            DVector::from_iterator(2 * size, x.iter().chain(v.iter()).copied())
        };
        let load = |time: f64| -> Result<DVector<f64>, LinalgError> {
            let over = solved(&mass, &(self.load)(time))?;
            Ok(DVector::from_iterator(2 * size, std::iter::repeat_n(0.0, size).chain(over.iter().copied())))
        };
        let [mut worst, mut scale] = [0.0f64, f64::MIN_POSITIVE];
        for n in 0..self.count {
            let [b0, bm, b1] = [self.time(n), self.time(n) + h / 2.0, self.time(n + 1)].map(load);
            let next = &whole * state(n) + &first * b0? + &middle * bm? + b1? * (h / 6.0);
            let weighed = |y: &DVector<f64>| y.rows(0, size).amax().max(h * y.rows(size, size).amax());
            worst = worst.max(weighed(&(&next - state(n + 1))));
            scale = scale.max(weighed(&next));
        }
        Ok([worst, scale])
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
