//! The same steps by another form of each method, and the exact motion by Taylor series.

use dalembert_core::{Text, Worksheet};
use dalembert_mechanics::vibration::response::{TimeExcitation, state_by_series};
use dalembert_numerics::linalg::{Elimination, LinalgError};
use nalgebra::{DMatrix, DVector};

use super::{
    IntegrationMethod, NumericalIntegration,
    methods::{Equations, solved},
};

/// Largest number of degrees of freedom that are integrated again.
const MOST: usize = 12;
/// Most steps of the Taylor series.
const LIMIT: usize = 400;

/// Answers of a coordinate.
pub(super) struct CoordinateAnswers<N> {
    /// The coordinate, counted from 1.
    pub(super) coordinate: usize,
    /// After the last step.
    pub(super) displacement: N,
    pub(super) velocity: N,
    pub(super) acceleration: N,
    pub(super) largest: N,
    /// The exact displacement after the last step, and the error.
    pub(super) exact: Option<[N; 2]>,
}

/// The motion by the second form of a method.
pub(super) struct Again {
    displacements: Vec<DVector<f64>>,
    /// Velocity and acceleration after the last step.
    velocity: DVector<f64>,
    acceleration: DVector<f64>,
    /// The exact displacement after the last step.
    exact: Option<DVector<f64>>,
    step: f64,
}

impl Again {
    /// `None` for a large system, or where the form has no solution.
    pub(super) fn of(
        problem: &NumericalIntegration,
        equations: &Equations<'_>,
        excitation: &TimeExcitation,
    ) -> Option<Self> {
        if equations.matrices[0].nrows() > MOST {
            return None;
        }
        let found = match problem.method {
            // Central differences are Newmark's method with β = 0.
            IntegrationMethod::CentralDifference => equations.predicted([0.5, 0.0], equations.count),
            IntegrationMethod::AverageAcceleration => equations.predicted([0.5, 0.25], equations.count),
            IntegrationMethod::LinearAcceleration => equations.predicted([0.5, 1.0 / 6.0], equations.count),
            IntegrationMethod::Newmark { gamma, beta } => equations.predicted([gamma, beta], equations.count),
            IntegrationMethod::Wilson { theta } => equations.beyond(theta),
            IntegrationMethod::Houbolt => equations.by_increments(),
            IntegrationMethod::RungeKutta => equations.by_powers(),
            IntegrationMethod::LinearLoad => equations.by_series(&problem.linear(equations, excitation)),
        };
        let (displacements, velocity, acceleration) = found.ok()?;
        let end = equations.time(equations.count);
        let exact = state_by_series(equations.matrices, excitation, end, LIMIT).ok();
        let exact = exact.map(|[displacements, _]| displacements);
        Some(Self { displacements, velocity, acceleration, exact, step: equations.step })
    }

    fn end(&self) -> &DVector<f64> {
        &self.displacements[self.displacements.len() - 1]
    }

    /// Compares the answers of a coordinate, the exact displacement with a Taylor series.
    pub(super) fn check<W: Worksheet>(&self, answers: &CoordinateAnswers<W::Num>, sheet: W) {
        let (coordinate, at) = (answers.coordinate, answers.coordinate - 1);
        let compare = |what: &'static str, answer: W::Num, other: f64, size: f64| {
            sheet.check_sum(Text::new(what).with("at", coordinate), answer, other.into(), size);
        };
        let end = self.end()[at];
        let size = self.displacements.iter().map(DVector::amax).fold(f64::MIN_POSITIVE, f64::max);
        compare(
            "displacement {at} at the end by another form of the method",
            answers.displacement,
            end,
            size,
        );
        let what = "velocity {at} at the end by another form of the method";
        compare(what, answers.velocity, self.velocity[at], size / self.step);
        let what = "acceleration {at} at the end by another form of the method";
        compare(what, answers.acceleration, self.acceleration[at], size / self.step.powi(2));
        let all = self.displacements.iter().map(|x| x[at]);
        let far = all.fold(0.0f64, |far, x| if x.abs() > far.abs() { x } else { far });
        compare("largest displacement {at} by another form of the method", answers.largest, far, size);
        if let (Some([value, error]), Some(exact)) = (answers.exact, &self.exact) {
            let size = exact.amax().max(self.end().amax()).max(f64::MIN_POSITIVE);
            let what = "exact displacement {at} at the end by Taylor series, step by step";
            compare(what, value, exact[at], size);
            let what = "error {at} from the other form of the method and the Taylor series";
            compare(what, error, end - exact[at], size);
        }
    }
}

/// Displacements after each step, and velocity and acceleration after the last one.
type Motion = Result<(Vec<DVector<f64>>, DVector<f64>, DVector<f64>), LinalgError>;

impl Equations<'_> {
    fn at_end(&self, displacements: Vec<DVector<f64>>, velocity: DVector<f64>) -> Motion {
        let [m, c, k] = self.matrices;
        let last = &displacements[displacements.len() - 1];
        let force = self.force(self.count) - c * &velocity - k * last;
        let acceleration = solved(&Elimination::new(m)?, &force)?;
        Ok((displacements, velocity, acceleration))
    }

    /// Newmark's method solved for the acceleration, behind a prediction of displacement and velocity.
    fn predicted(&self, [gamma, beta]: [f64; 2], count: usize) -> Motion {
        let ([m, c, k], h) = (self.matrices, self.step);
        let effective = Elimination::new(&(m + c * (gamma * h) + k * (beta * h * h)))?;
        let [mut x, mut v] = self.start.map(Clone::clone);
        let mut a = solved(&Elimination::new(m)?, &(self.force(0) - c * &v - k * &x))?;
        let mut all = vec![x.clone()];
        for n in 1..=count {
            x += &v * h + &a * (h * h * (0.5 - beta));
            v += &a * (h * (1.0 - gamma));
            a = solved(&effective, &(self.force(n) - c * &v - k * &x))?;
            x += &a * (beta * h * h);
            v += &a * (gamma * h);
            all.push(x.clone());
        }
        Ok((all, v, a))
    }

    /// Wilson's method solved for the acceleration at the end of the extended step.
    fn beyond(&self, theta: f64) -> Motion {
        let ([m, c, k], h) = (self.matrices, self.step);
        let long = theta * h;
        let effective = Elimination::new(&(m + c * (long / 2.0) + k * (long * long / 6.0)))?;
        let [mut x, mut v] = self.start.map(Clone::clone);
        let mut a = solved(&Elimination::new(m)?, &(self.force(0) - c * &v - k * &x))?;
        let mut all = vec![x.clone()];
        for n in 0..self.count {
            let force = self.force(n) * (1.0 - theta) + self.force(n + 1) * theta;
            let rest = c * (&v + &a * (long / 2.0)) + k * (&x + &v * long + &a * (long * long / 3.0));
            let last = solved(&effective, &(force - rest))?;
            let next = &a + (last - &a) / theta;
            x += &v * h + (&next + &a * 2.0) * (h * h / 6.0);
            v += (&a + &next) * (h / 2.0);
            a = next;
            all.push(x.clone());
        }
        Ok((all, v, a))
    }

    /// Houbolt's method solved for the increment of displacement.
    fn by_increments(&self) -> Motion {
        let ([m, c, k], h) = (self.matrices, self.step);
        let (mut all, velocity, acceleration) = self.predicted([0.5, 0.0], self.count.min(2))?;
        if self.count <= 2 {
            return Ok((all, velocity, acceleration));
        }
        let effective = Elimination::new(&(m * (2.0 / (h * h)) + c * (11.0 / (6.0 * h)) + k))?;
        let mut velocity = velocity;
        for n in 2..self.count {
            let (last, before) = (&all[n] - &all[n - 1], &all[n - 1] - &all[n - 2]);
            // d₂ = d − d′ and d₃ = d − 2 d′ + d″ of the increments, the new one and two earlier ones.
            let drag = (&last * (-7.0 / 6.0) + &before / 3.0) / h;
            let inertia = (&last * -3.0 + &before) / (h * h);
            let force = self.force(n + 1) - k * &all[n] - c * &drag - m * inertia;
            let increment = solved(&effective, &force)?;
            velocity = &increment * (11.0 / (6.0 * h)) + drag;
            let next = &all[n] + increment;
            all.push(next);
        }
        self.at_end(all, velocity)
    }

    /// Runge–Kutta's method by polynomials of the state matrix.
    fn by_powers(&self) -> Motion {
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
        let power = matrix * h;
        let (square, cube) = (&power * &power, &power * &power * &power);
        let whole = &one + &power + &square / 2.0 + &cube / 6.0 + &square * &square / 24.0;
        let first = (&one + &power + &square / 2.0 + &cube / 4.0) * (h / 6.0);
        let middle = (&one * 4.0 + &power * 2.0 + &square / 2.0) * (h / 6.0);
        let load = |time: f64| -> Result<DVector<f64>, LinalgError> {
            let over = solved(&mass, &(self.load)(time))?;
            Ok(DVector::from_iterator(2 * size, std::iter::repeat_n(0.0, size).chain(over.iter().copied())))
        };
        let [x, v] = self.start;
        let mut state = DVector::from_iterator(2 * size, x.iter().chain(v.iter()).copied());
        let mut all = vec![x.clone()];
        for n in 0..self.count {
            let [start, half, end] = [self.time(n), self.time(n) + h / 2.0, self.time(n + 1)].map(load);
            state = &whole * state + &first * start? + &middle * half? + end? * (h / 6.0);
            all.push(state.rows(0, size).into_owned());
        }
        let velocity = state.rows(size, size).into_owned();
        self.at_end(all, velocity)
    }

    /// The exact motion under a load that is linear between the ends of the steps, by Taylor series.
    fn by_series(&self, linear: &TimeExcitation) -> Motion {
        let at = |n: usize| state_by_series(self.matrices, linear, self.time(n), LIMIT);
        let states = (0..=self.count).map(at).collect::<Result<Vec<_>, _>>()?;
        let velocity = states[self.count][1].clone();
        self.at_end(states.into_iter().map(|[x, _]| x).collect(), velocity)
    }
}
