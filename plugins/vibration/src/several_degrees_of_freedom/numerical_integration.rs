//! Step-by-step integration of the equations of motion, by the methods of textbooks.

mod again;
mod first_step;
mod methods;

use dalembert_core::{
    About, Analysis, Axis, Cell, Column, Exhibit, Inputs, Name, Plot, Refusal, Series, TableExhibit, Text,
    Worksheet, register,
};
use dalembert_mechanics::{
    Real,
    vibration::{
        poles::Poles,
        response::{ForceSegment, Push, TimeExcitation, TimeResponse},
    },
};
use dalembert_numerics::linalg::LinalgError;
use nalgebra::DVector;

use self::{
    again::{Again, CoordinateAnswers},
    methods::{Equations, Integrated},
};
use crate::{
    shared::system::{
        System, assemble,
        damping::{SystemDamping, in_modes},
        excitation::{BaseAcceleration, Excitation, Force, InitialCondition, Observed, loads},
        modes::{WorkedModes, find, highest_frequency},
        picture,
    },
    sources::{BATHE, CHOPRA, RAO},
};

/// Rows of the table of steps.
const ROWS: usize = 200;
/// Points of the curve of the exact motion.
const POINTS: usize = 400;
/// Largest number of degrees of freedom.
const MOST: usize = 50;

/// The system, its start, the loads on it, and the method.
#[derive(Clone, Debug, Inputs)]
pub struct NumericalIntegration {
    /// System.
    pub system: System,
    /// Damping.
    pub damping: SystemDamping,
    /// Initial conditions.
    /// Coordinates that are not listed start from rest.
    pub start: Vec<InitialCondition>,
    /// Forces.
    /// Read at the ends of the time steps; at a jump, the value of the larger magnitude.
    pub forces: Vec<Force>,
    /// Accelerations of the base.
    /// All coordinates are displacements in its direction, and are then relative to it.
    pub base: Vec<BaseAcceleration>,
    /// Method.
    pub method: IntegrationMethod,
    /// Time step.
    #[input("Δt", "s", positive)]
    pub step: f64,
    /// Number of steps.
    #[input(min = 1, max = 5000)]
    pub count: usize,
    /// Observed coordinates.
    #[input(min = 1)]
    pub observed: Vec<Observed>,
}

/// Method of integration.
#[derive(Clone, Copy, Debug, Inputs)]
pub enum IntegrationMethod {
    /// Central differences
    CentralDifference,
    /// Newmark, average acceleration
    /// The acceleration is constant within a step: γ = 1/2, β = 1/4.
    AverageAcceleration,
    /// Newmark, linear acceleration
    /// The acceleration is linear within a step: γ = 1/2, β = 1/6.
    LinearAcceleration,
    /// Newmark with γ and β
    Newmark {
        /// Gamma.
        #[input("γ", "1", positive, max = 1, default = "0.5")]
        gamma: f64,
        /// Beta.
        #[input("β", "1", positive, max = 1, default = "0.25")]
        beta: f64,
    },
    /// Wilson-θ
    Wilson {
        /// Theta.
        #[input("θ", "1", min = 1, max = 10, default = "1.4")]
        theta: f64,
    },
    /// Houbolt
    /// Its first two steps are central differences.
    Houbolt,
    /// Fourth-order Runge–Kutta
    RungeKutta,
    /// Exact for a piecewise-linear load
    /// The load is linear between the ends of the steps.
    LinearLoad,
}

register!(NumericalIntegration);

impl Analysis for NumericalIntegration {
    const ABOUT: About = About {
        id: "vibration/numerical-integration",
        title: "Numerical integration of the equation of motion",
        topic: "Several degrees of freedom",
        summary: "Response step by step of one or several degrees of freedom by central differences, Newmark, Wilson, Houbolt or Runge–Kutta methods, beside the exact motion, with the critical time step.",
        main: &["final_displacement", "largest", "error"],
        keywords: "time stepping step-by-step direct integration central difference Newmark beta average acceleration \
                   linear acceleration Wilson theta Houbolt Runge-Kutta finite difference interpolation of excitation \
                   stability critical time step integração numérica passo a passo diferenças centrais aceleração \
                   média aceleração linear passo crítico",
        sources: &[&RAO, &CHOPRA, &BATHE],
        cases: include_str!("../../cases/numerical_integration.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &NumericalIntegrationGiven<W>, sheet: W) -> Result<(), Refusal> {
        let system = assemble(&self.system, &given.system, sheet)?;
        if system.size() > MOST {
            let why = Text::new("{have} degrees of freedom: at most {most} are integrated step by step");
            return Err(Refusal::because(why.with("have", system.size()).with("most", MOST)));
        }
        let Self { start, forces, base, observed, .. } = self;
        let excitation = Excitation { start, forces, base, observed }.over(&system.mass)?;
        let found = find(&system, sheet)?;
        let damped =
            in_modes(&self.damping, &given.damping, &system.damping, &system.mass, &found.modes, sheet)?;
        let load = |time: f64| self.load(&excitation, time);
        let equations = Equations {
            matrices: [&system.mass, &damped.physical, &system.stiffness],
            load: &load,
            start: [&excitation.position, &excitation.velocity],
            step: self.step,
            count: self.count,
        };
        let end = self.step * self.count as f64;
        let poles = Poles::new(&found.modes, &damped.matrix, end);
        let momentum = found.modes.shapes.transpose() * &system.mass;
        let motion = match equations.integrate(&self.method).map_err(cannot)? {
            Some(motion) => motion,
            None => {
                let poles = poles.as_ref().map_err(|_| Refusal::because(SHARED))?;
                let linear = self.linear(&equations, &excitation);
                let response = TimeResponse::new(poles, &momentum, &linear);
                self.by_modes(poles, &response, &equations).map_err(cannot)?
            }
        };
        if motion
            .displacements
            .iter()
            .chain(&motion.velocities)
            .any(|state| !state.iter().all(|x| x.is_finite()))
        {
            return Err(Refusal::because(
                "the integration is unstable: the motion grows beyond all numbers; take a shorter time step",
            ));
        }
        if system.size() == 1 {
            first_step::write(self, given, &equations, &motion, sheet);
        }
        let exact_motion = poles.as_ref().ok().map(|poles| TimeResponse::new(poles, &momentum, &excitation));
        let exact = poles.as_ref().ok().zip(exact_motion.as_ref());
        let answered = self.answers(&motion, exact, sheet)?;
        sheet.verify(|| {
            if let Some(again) = Again::of(self, &equations, &excitation) {
                for answers in &answered {
                    again.check(answers, sheet);
                }
            }
        });
        self.stability(&found, given.step, sheet);
        sheet.show(|| Exhibit::Table(self.table(&motion, &equations)));
        sheet.show(|| Exhibit::Plot(self.plot(&motion, exact)));
        sheet.show(|| Exhibit::Drawing(picture::at_rest(&self.system, &loads(&self.forces))));
        Ok(())
    }
}

/// Reason of a system whose exact motion is not found.
const SHARED: &str =
    "two damped modes share one root and one mode shape (critical damping): change a damper by a millionth";

/// Common error of the time step.
const LONGEST_PERIOD: &str = "the longest natural period used in place of the shortest";

fn cannot(_: LinalgError) -> Refusal {
    Refusal::because("the effective stiffness of a step is singular: take another time step")
}

impl NumericalIntegration {
    /// The load at a time; at a jump the value of the larger magnitude.
    fn load(&self, excitation: &TimeExcitation, time: f64) -> DVector<f64> {
        let near = 1e-9 * self.step;
        let mut sum = DVector::zeros(excitation.position.len());
        for push in &excitation.pushes {
            let value = |piece: Option<&ForceSegment>| {
                piece.map_or(0.0, |piece| piece.value + piece.slope * (time - piece.start))
            };
            let before = value(push.pieces.iter().rfind(|piece| piece.start < time - near));
            let after = value(push.pieces.iter().rfind(|piece| piece.start <= time + near));
            sum += &push.force * if before.abs() > after.abs() { before } else { after };
        }
        for harmonic in excitation.harmonics.iter().filter(|harmonic| harmonic.start <= time + near) {
            let angle = harmonic.frequency * (time - harmonic.start) - harmonic.lag;
            // The rounding of a phase of 90° is no load.
            let value = if angle.cos().abs() < 1e-12 { 0.0 } else { angle.cos() };
            sum += &harmonic.force * value;
        }
        sum
    }

    /// The load with straight lines between the ends of the steps, a part for each coordinate.
    fn linear(&self, equations: &Equations<'_>, excitation: &TimeExcitation) -> TimeExcitation {
        let loads: Vec<DVector<f64>> =
            (0..=self.count).map(|n| (equations.load)(self.step * n as f64)).collect();
        let size = excitation.position.len();
        let one = |at: usize| {
            let pieces = loads.windows(2).enumerate().map(|(n, pair)| ForceSegment {
                start: self.step * n as f64,
                value: pair[0][at],
                slope: (pair[1][at] - pair[0][at]) / self.step,
            });
            Push {
                force: DVector::from_fn(size, |row, _| f64::from(u8::from(row == at))),
                pieces: pieces.collect(),
            }
        };
        TimeExcitation {
            position: excitation.position.clone(),
            velocity: excitation.velocity.clone(),
            pushes: (0..size).map(one).collect(),
            harmonics: Vec::new(),
        }
    }

    /// The motion at the ends of the steps, from the modes.
    fn by_modes(
        &self,
        poles: &Poles,
        response: &TimeResponse<'_>,
        equations: &Equations<'_>,
    ) -> Result<Integrated, LinalgError> {
        let [m, c, k] = equations.matrices;
        let size = m.nrows();
        let mut motion =
            Integrated { displacements: Vec::new(), velocities: Vec::new(), accelerations: Vec::new() };
        for n in 0..=self.count {
            let time = self.step * n as f64;
            let state = response.state(time);
            let x = DVector::from_fn(size, |at, _| poles.displacement(at, &state));
            let v = DVector::from_fn(size, |at, _| poles.velocity(at, &state));
            let force = (equations.load)(time) - c * &v - k * &x;
            motion.accelerations.push(dalembert_numerics::linalg::solve(m, &force)?.x);
            motion.displacements.push(x);
            motion.velocities.push(v);
        }
        Ok(motion)
    }

    /// The critical time step, and a warning where the step is longer.
    fn stability<W: Worksheet>(&self, found: &WorkedModes<W::Num>, step: W::Num, sheet: W) {
        let highest = highest_frequency(found, sheet);
        if highest.value() <= 0.0 {
            return;
        }
        let why = ("Time step over the minimum natural period", BATHE.at("§9.4"));
        let lowest = found.frequencies[0];
        if found.frequencies.len() > 1 {
            sheet.common_error("Δt/T", LONGEST_PERIOD, || step * lowest / std::f64::consts::TAU);
        }
        let ratio = sheet.step("Δt/T", "1", step * highest / std::f64::consts::TAU, why);
        sheet.answer("step_ratio", "Time step over the minimum period", ratio);
        let (limit, why) = match self.method {
            IntegrationMethod::CentralDifference => (2.0, "Critical time step of central differences, T/π"),
            IntegrationMethod::LinearAcceleration => {
                (12f64.sqrt(), "Critical time step of the linear acceleration method, √3 T/π")
            }
            IntegrationMethod::Newmark { gamma, beta } if gamma >= 0.5 && 2.0 * beta < gamma => {
                (1.0 / (gamma / 2.0 - beta).sqrt(), "Critical time step of Newmark's method without damping")
            }
            IntegrationMethod::RungeKutta => (
                8f64.sqrt(),
                "Critical time step of the fourth-order Runge–Kutta method without damping, √2 T/π",
            ),
            _ => return,
        };
        if found.frequencies.len() > 1 {
            sheet.common_error("Δt_cr", LONGEST_PERIOD, || W::Num::from(limit) / lowest);
        }
        let tenth = || W::Num::from(std::f64::consts::TAU / 10.0) / highest;
        sheet.common_error("Δt_cr", "a tenth of the period, the rule for accuracy, taken", tenth);
        if !matches!(self.method, IntegrationMethod::CentralDifference) {
            let explicit = || W::Num::from(2.0) / highest;
            sheet.common_error("Δt_cr", "the critical time step of central differences used", explicit);
        }
        let critical = sheet.step("Δt_cr", "s", W::Num::from(limit) / highest, (why, BATHE.at("§9.4")));
        sheet.answer("critical_step", "Critical time step", critical);
        if step.value() > critical.value() {
            sheet.warn(|| {
                Text::new("the time step is longer than the critical one: the integration is unstable, and its results are no motion of this system")
            });
        }
    }

    fn answers<W: Worksheet>(
        &self,
        motion: &Integrated,
        exact: Option<(&Poles, &TimeResponse<'_>)>,
        sheet: W,
    ) -> Result<Vec<CoordinateAnswers<W::Num>>, Refusal> {
        let end = self.step * self.count as f64;
        let exact = exact.map(|(poles, response)| (poles, response.state(end)));
        let mut answered = Vec::with_capacity(self.observed.len());
        for row in &self.observed {
            let (at, coordinate) = (row.coordinate - 1, row.coordinate);
            sheet.keep_going()?;
            let of = |states: &[DVector<f64>]| states.iter().map(|state| state[at]).collect::<Vec<f64>>();
            let (x, v, a) = (of(&motion.displacements), of(&motion.velocities), of(&motion.accelerations));
            let last = |all: &[f64]| all.last().copied().unwrap_or(f64::NAN);
            let why = "Displacement after the last step";
            let displacement = sheet.numerical(("x_e", coordinate), "m", last(&x), (why, RAO.at("ch. 11")));
            sheet.answer(("final_displacement", coordinate), "Displacement at the end", displacement);
            let velocity =
                sheet.numerical(("v_e", coordinate), "m/s", last(&v), "Velocity after the last step");
            sheet.answer(("final_velocity", coordinate), "Velocity at the end", velocity);
            let why = "Acceleration after the last step";
            let acceleration = sheet.numerical(("a_e", coordinate), "m/s^2", last(&a), why);
            sheet.answer(("final_acceleration", coordinate), "Acceleration at the end", acceleration);
            let farthest = x.iter().copied().fold(0.0f64, |far, x| if x.abs() > far.abs() { x } else { far });
            let why = "Displacement farthest from zero at the end of a step";
            let largest = sheet.numerical(("x_m", coordinate), "m", farthest, why);
            sheet.answer(("largest", coordinate), "Largest displacement of all steps", largest);
            let exact = exact.as_ref().map(|(poles, state)| {
                let why = ("Exact displacement at the end, by modal superposition", RAO.at("§6.14"));
                let value = poles.displacement(at, state);
                let value = sheet.numerical(("x_x", coordinate), "m", value, why);
                sheet.answer(("exact", coordinate), "Exact displacement at the end", value);
                let why = "Error of the integration at the end";
                let error = sheet.step(("ε", coordinate), "m", displacement - value, why);
                sheet.answer(("error", coordinate), "Error at the end", error);
                [value, error]
            });
            answered.push(CoordinateAnswers {
                coordinate,
                displacement,
                velocity,
                acceleration,
                largest,
                exact,
            });
            sheet.answer_list(("displacement", coordinate), "Displacement after each step", "m", &x[1..]);
            sheet.answer_list(("velocity", coordinate), "Velocity after each step", "m/s", &v[1..]);
            sheet.answer_list(("acceleration", coordinate), "Acceleration after each step", "m/s^2", &a[1..]);
        }
        Ok(answered)
    }

    fn table(&self, motion: &Integrated, equations: &Equations<'_>) -> TableExhibit {
        let column = |heading: Text, unit| Column { heading, unit };
        let mut columns = vec![column("time".into(), "s")];
        for row in self.observed.iter().take(4) {
            let of = |words: &'static str| Text::new(words).with("at", row.coordinate);
            columns.push(column(of("load {at}"), "N"));
            columns.push(column(of("displacement {at}"), "m"));
            columns.push(column(of("velocity {at}"), "m/s"));
            columns.push(column(of("acceleration {at}"), "m/s^2"));
        }
        let rows = (0..=self.count).take(ROWS).map(|n| {
            let time = self.step * n as f64;
            let load = (equations.load)(time);
            let mut row = vec![Cell::Number(time)];
            for observed in self.observed.iter().take(4) {
                let at = observed.coordinate - 1;
                row.push(Cell::Number(load[at]));
                for states in [&motion.displacements, &motion.velocities, &motion.accelerations] {
                    row.push(Cell::Number(states[n][at]));
                }
            }
            row
        });
        let rows = rows.collect();
        TableExhibit { title: "Motion step by step".into(), columns, rows, foot: Vec::new() }
    }

    fn plot(&self, motion: &Integrated, exact: Option<(&Poles, &TimeResponse<'_>)>) -> Plot {
        let end = self.step * self.count as f64;
        let grid: Vec<f64> = (0..=POINTS).map(|n| end * n as f64 / POINTS as f64).collect();
        let exact = exact.map(|(poles, response)| {
            (poles, grid.iter().map(|time| response.state(*time)).collect::<Vec<_>>())
        });
        let mut series = Vec::new();
        for row in self.observed.iter().take(3) {
            let at = row.coordinate - 1;
            let points = motion.displacements.iter().enumerate();
            let points = points.map(|(n, x)| (self.step * n as f64, x[at])).collect();
            let label = Text::new("coordinate {at}, step by step").with("at", row.coordinate);
            series.push(Series::line(label, points).of(Name::from(("final_displacement", row.coordinate))));
            if let Some((poles, states)) = &exact {
                let points = grid.iter().zip(states);
                let points = points.map(|(time, state)| (*time, poles.displacement(at, state))).collect();
                let label = Text::new("coordinate {at}, exact").with("at", row.coordinate);
                series.push(Series::line(label, points));
            }
        }
        Plot::new(
            "Displacement against time",
            Axis::linear("time", "s"),
            Axis::linear("displacement", "m"),
            series,
        )
    }
}
