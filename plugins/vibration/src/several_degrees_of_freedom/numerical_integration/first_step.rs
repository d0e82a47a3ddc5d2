//! The constants of a method and its first step, written out for one degree of freedom.

use dalembert_core::Worksheet;
use dalembert_mechanics::Real;
use nalgebra::DVector;

use super::{
    IntegrationMethodGiven, NumericalIntegration, NumericalIntegrationGiven,
    methods::{Equations, Integrated},
};
use crate::{
    shared::system::{SystemGiven, damping::SystemDampingGiven},
    sources::{BATHE, CHOPRA, RAO},
};

/// One degree of freedom at its start.
struct Oscillator<N> {
    mass: N,
    damping: N,
    stiffness: N,
    displacement: N,
    velocity: N,
    acceleration: N,
    step: N,
    /// Loads at the start and after one step.
    loads: [N; 2],
}

/// Writes the constants of the method and its first step, which is compared with that of the matrices.
pub(super) fn write<W: Worksheet>(
    problem: &NumericalIntegration,
    given: &NumericalIntegrationGiven<W>,
    equations: &Equations<'_>,
    motion: &Integrated,
    sheet: W,
) {
    if let IntegrationMethodGiven::LinearLoad {} = given.method {
        return;
    }
    let oscillator = oscillator(given, equations, sheet);
    let first = match &given.method {
        IntegrationMethodGiven::LinearLoad {} => return,
        IntegrationMethodGiven::CentralDifference {} | IntegrationMethodGiven::Houbolt {} => {
            oscillator.central_difference(sheet)
        }
        IntegrationMethodGiven::AverageAcceleration {} => {
            oscillator.newmark(parameters([0.5, 0.25], sheet), sheet)
        }
        IntegrationMethodGiven::LinearAcceleration {} => {
            oscillator.newmark(parameters([0.5, 1.0 / 6.0], sheet), sheet)
        }
        IntegrationMethodGiven::Newmark { gamma, beta } => oscillator.newmark([*gamma, *beta], sheet),
        IntegrationMethodGiven::Wilson { theta } => oscillator.wilson(*theta, sheet),
        IntegrationMethodGiven::RungeKutta {} => {
            let middle = (equations.load)(problem.step / 2.0)[0];
            oscillator.runge_kutta(middle, sheet)
        }
    };
    sheet.verify(|| {
        let reached = motion.displacements[..2].iter().map(DVector::amax);
        let mut size = reached.fold(f64::MIN_POSITIVE, f64::max);
        let found = [&motion.displacements, &motion.velocities, &motion.accelerations];
        for (worked, found) in first.into_iter().zip(found) {
            let what = "the first step worked out is that of the matrices";
            sheet.check_sum(what, worked, found[1][0].into(), size);
            size /= problem.step;
        }
    });
}

/// γ and β of one of Newmark's methods that has a name of its own.
fn parameters<W: Worksheet>([gamma, beta]: [f64; 2], sheet: W) -> [W::Num; 2] {
    let gamma = sheet.numerical("γ", "1", gamma, ("Parameter gamma of the method", RAO.at("§11.9")));
    [gamma, sheet.numerical("β", "1", beta, "Parameter beta of the method")]
}

fn oscillator<W: Worksheet>(
    given: &NumericalIntegrationGiven<W>,
    equations: &Equations<'_>,
    sheet: W,
) -> Oscillator<W::Num> {
    let [m, c, k] = equations.matrices;
    let (mass, stiffness) = match &given.system {
        SystemGiven::Chain { masses, wall } if masses.len() == 1 => {
            let wall = wall.as_ref().and_then(|wall| wall.spring);
            let springs: Vec<W::Num> =
                [masses[0].spring, masses[0].ground_spring, wall].into_iter().flatten().collect();
            let stiffness = match springs[..] {
                [only] => only,
                _ => sheet.step("k", "N/m", W::Num::sum(springs), "Stiffness of the springs side by side"),
            };
            (masses[0].mass, stiffness)
        }
        _ => (
            sheet.numerical("m", "kg", m[(0, 0)], "Mass"),
            sheet.numerical("k", "N/m", k[(0, 0)], "Stiffness"),
        ),
    };
    let damping = match &given.damping {
        SystemDampingGiven::Ratio { ratio } => {
            let why = ("Damping coefficient from the damping ratio", RAO.at("§2.6"));
            sheet.step("c", "N*s/m", W::Num::from(2.0) * *ratio * (stiffness * mass).sqrt(), why)
        }
        _ => sheet.numerical("c", "N*s/m", c[(0, 0)], "Damping coefficient"),
    };
    let start = given.start.last();
    let at_rest = |symbol: &'static str, unit, why: &'static str| sheet.numerical(symbol, unit, 0.0, why);
    let displacement = start.map_or_else(
        || at_rest("x_0", "m", "Initial displacement, as none is given"),
        |start| start.displacement,
    );
    let velocity = start
        .map_or_else(|| at_rest("v_0", "m/s", "Initial velocity, as none is given"), |start| start.velocity);
    let load = |n: usize| (equations.load)(equations.step * n as f64)[0];
    let first = sheet.numerical("p_0", "N", load(0), "Load at the start");
    let second = sheet.numerical("p_1", "N", load(1), "Load after one step");
    let acceleration = sheet.step(
        "a_0",
        "m/s^2",
        (first - damping * velocity - stiffness * displacement) / mass,
        ("Initial acceleration, from the equation of motion", RAO.at("§11.3")),
    );
    Oscillator {
        mass,
        damping,
        stiffness,
        displacement,
        velocity,
        acceleration,
        step: given.step,
        loads: [first, second],
    }
}

/// The first step of each method: displacement, velocity and acceleration after it, as far as the method has them.
impl<N: Real> Oscillator<N> {
    fn central_difference<W: Worksheet<Num = N>>(&self, sheet: W) -> Vec<N> {
        let Self { mass: m, damping: c, stiffness: k, step: h, .. } = *self;
        let two = N::from(2.0);
        let before = sheet.step(
            "x_p",
            "m",
            self.displacement - h * self.velocity + h.powi(2) / 2.0 * self.acceleration,
            ("Displacement one step before the start, by Taylor's formula", RAO.at("§11.3")),
        );
        let effective = sheet.step(
            "k_e",
            "N/m",
            m / h.powi(2) + c / (two * h),
            ("Effective stiffness of central differences", CHOPRA.at("§5.3")),
        );
        let a = sheet.step("a_p", "N/m", m / h.powi(2) - c / (two * h), "Factor of the displacement before");
        let b = sheet.step("b_p", "N/m", k - two * m / h.powi(2), "Factor of the present displacement");
        let load = self.loads[0] - a * before - b * self.displacement;
        let load = sheet.step("p_e", "N", load, "Effective load of the first step");
        vec![sheet.step("x_1", "m", load / effective, "Displacement after one step")]
    }

    fn newmark<W: Worksheet<Num = N>>(&self, [gamma, beta]: [N; 2], sheet: W) -> Vec<N> {
        let Self { mass: m, damping: c, stiffness: k, step: h, .. } = *self;
        let (x, v, a, one) = (self.displacement, self.velocity, self.acceleration, N::from(1.0));
        let effective = sheet.step(
            "k_e",
            "N/m",
            k + gamma * c / (beta * h) + m / (beta * h.powi(2)),
            ("Effective stiffness of Newmark's method", CHOPRA.at("§5.4")),
        );
        let inertia = x / (beta * h.powi(2)) + v / (beta * h) + (one / (beta * 2.0) - one) * a;
        let drag =
            gamma * x / (beta * h) + (gamma / beta - one) * v + h / 2.0 * (gamma / beta - N::from(2.0)) * a;
        let load = sheet.step(
            "p_e",
            "N",
            self.loads[1] + m * inertia + c * drag,
            "Effective load of the first step",
        );
        let next = sheet.step("x_1", "m", load / effective, "Displacement after one step");
        let acceleration = sheet.step(
            "a_1",
            "m/s^2",
            (next - x) / (beta * h.powi(2)) - v / (beta * h) - (one / (beta * 2.0) - one) * a,
            "Acceleration after one step",
        );
        let velocity = v + h * ((one - gamma) * a + gamma * acceleration);
        let velocity = sheet.step("v_1", "m/s", velocity, "Velocity after one step");
        vec![next, velocity, acceleration]
    }

    fn wilson<W: Worksheet<Num = N>>(&self, theta: N, sheet: W) -> Vec<N> {
        let Self { mass: m, damping: c, stiffness: k, step: h, .. } = *self;
        let (x, v, a) = (self.displacement, self.velocity, self.acceleration);
        let why = ("Extended time step", RAO.at("§11.8"));
        let long = sheet.step("τ", "s", theta * h, why);
        let effective = sheet.step(
            "k_e",
            "N/m",
            k + c * 3.0 / long + m * 6.0 / long.powi(2),
            ("Effective stiffness of Wilson's method", BATHE.at("§9.2")),
        );
        let force = self.loads[0] + theta * (self.loads[1] - self.loads[0]);
        let force = sheet.step("p_θ", "N", force, "Load at the end of the extended step");
        let inertia = x * 6.0 / long.powi(2) + v * 6.0 / long + a * 2.0;
        let drag = x * 3.0 / long + v * 2.0 + long / 2.0 * a;
        let load = sheet.step("p_e", "N", force + m * inertia + c * drag, "Effective load of the first step");
        let beyond = sheet.step("x_θ", "m", load / effective, "Displacement at the end of the extended step");
        let acceleration = sheet.step(
            "a_1",
            "m/s^2",
            (beyond - x) * 6.0 / (theta * long.powi(2)) - v * 6.0 / (theta * long)
                + (N::from(1.0) - N::from(3.0) / theta) * a,
            "Acceleration after one step",
        );
        let velocity = v + h / 2.0 * (a + acceleration);
        let velocity = sheet.step("v_1", "m/s", velocity, "Velocity after one step");
        let next = x + h * v + h.powi(2) / 6.0 * (acceleration + a * 2.0);
        let next = sheet.step("x_1", "m", next, "Displacement after one step");
        vec![next, velocity, acceleration]
    }

    fn runge_kutta<W: Worksheet<Num = N>>(&self, middle: f64, sheet: W) -> Vec<N> {
        let Self { mass: m, damping: c, stiffness: k, step: h, .. } = *self;
        let (x, v, a) = (self.displacement, self.velocity, self.acceleration);
        let middle = sheet.numerical("p_m", "N", middle, "Load in the middle of the step");
        let slope = |symbol: &'static str, force: N, [x, v]: [N; 2], why: &'static str| {
            sheet.step(symbol, "m/s^2", (force - c * v - k * x) / m, (why, RAO.at("§11.4")))
        };
        let half = h / 2.0;
        let v2 = sheet.step("v_2", "m/s", v + half * a, "Velocity of the second evaluation");
        let a2 = slope("a_2", middle, [x + half * v, v2], "Acceleration of the second evaluation");
        let v3 = sheet.step("v_3", "m/s", v + half * a2, "Velocity of the third evaluation");
        let a3 = slope("a_3", middle, [x + half * v2, v3], "Acceleration of the third evaluation");
        let v4 = sheet.step("v_4", "m/s", v + h * a3, "Velocity of the fourth evaluation");
        let a4 = slope("a_4", self.loads[1], [x + h * v3, v4], "Acceleration of the fourth evaluation");
        let why = ("Velocity after one step", RAO.at("§11.4"));
        let velocity = sheet.step("v_1", "m/s", v + h / 6.0 * (a + a2 * 2.0 + a3 * 2.0 + a4), why);
        let why = "Displacement after one step";
        vec![sheet.step("x_1", "m", x + h / 6.0 * (v + v2 * 2.0 + v3 * 2.0 + v4), why), velocity]
    }
}
