//! The turning moment over the cycle.

use std::{f64::consts::TAU, ops::ControlFlow};

use dalembert_core::{Refusal, Worksheet};
use dalembert_mechanics::{
    Real,
    slider_crank::{
        CrankMotion,
        cycle::TorqueCycle,
        engine::{EngineCylinder as Kernel, Forces, PistonFormula, PistonMotion},
        gas::{self, Corners, Diagram},
    },
};
use dalembert_numerics::{differentiation::derivative, gauss_legendre, roots};

use super::{Engine, Gas, forces::EngineProblem, gas::GasCycle, ideal::Indicated};
use crate::shared::flywheel::FlywheelInertiaGiven;

/// The cycle at a steady speed.
pub(super) struct Turned {
    pub cycle: TorqueCycle,
    pub period: f64,
}

/// The forces at a crank angle of a cycle: that of the gas, and all others.
pub(super) fn at(kernel: &Kernel, gas: Option<&GasCycle>, crank: CrankMotion) -> (f64, Forces) {
    let motion = kernel.motion(crank);
    let fraction = motion.displacement / kernel.stroke();
    let force = gas.map_or(0.0, |gas| gas.force(crank.angle, fraction, motion.arm >= 0.0));
    (force, kernel.forces(crank, &motion, force))
}

/// Mean, extremes and fluctuation, where the force of the gas is known all over the cycle.
pub(super) fn cycle<W: Worksheet>(
    problem: &Engine,
    of: &EngineProblem<'_, W>,
    kernel: &Kernel,
    gas: Option<&GasCycle>,
    speed: W::Num,
    sheet: W,
) -> Result<Option<Turned>, Refusal> {
    if gas.is_none() && !matches!(problem.gas, Gas::Nothing) {
        return Ok(None);
    }
    let turns = gas.map_or(1, |gas| gas.diagram.turns());
    let period = TAU * f64::from(turns);
    let steady = |angle: f64| CrankMotion { angle, speed: speed.value(), acceleration: 0.0 };
    let moment = |angle: f64| at(kernel, gas, steady(angle)).1.moment;
    let corners = corners(kernel, gas, turns);
    let cycle = TorqueCycle::of(moment, period, &corners);
    sheet.keep_going()?;
    let size = cycle.largest.1.abs().max(cycle.least.1.abs());
    if !size.is_finite() {
        return Err(Refusal::because(
            "the turning moment over the cycle cannot be represented: check the inputs",
        ));
    }
    let mean = sheet.numerical(
        "T_m",
        "N*m",
        cycle.mean,
        "Mean turning moment at constant speed, integrated over the cycle",
    );
    let most = sheet.numerical("T_max", "N*m", cycle.largest.1, "Maximum turning moment of the cycle");
    let most_at =
        sheet.numerical("θ_max", "deg", cycle.largest.0, "Crank angle at the maximum turning moment");
    let least = sheet.numerical("T_min", "N*m", cycle.least.1, "Minimum turning moment of the cycle");
    let least_at =
        sheet.numerical("θ_min", "deg", cycle.least.0, "Crank angle at the minimum turning moment");
    let rms = sheet.numerical("T_rms", "N*m", cycle.rms, "Root mean square of the turning moment");
    sheet.answer("mean_moment", "Mean turning moment over the cycle", mean);
    sheet.answer("greatest_moment", "Maximum turning moment", most);
    sheet.answer("greatest_moment_angle", "Crank angle at the maximum turning moment", most_at);
    sheet.answer("least_moment", "Minimum turning moment", least);
    sheet.answer("least_moment_angle", "Crank angle at the minimum turning moment", least_at);
    sheet.answer("rms_moment", "Root mean square of the turning moment", rms);
    let power = gas.is_some().then(|| {
        let power = sheet.step("P_m", "kW", mean * speed, "Mean power at this speed");
        sheet.answer("power", "Mean power", power);
        power
    });
    let energy = sheet.numerical(
        "ΔE",
        "J",
        cycle.fluctuation,
        "Fluctuation of energy: work of the moment above its mean, from the minimum to the maximum sum",
    );
    sheet.answer("energy_fluctuation", "Fluctuation of energy", energy);
    if let Some(output) = &of.given.output {
        let inertia = match &output.inertia {
            FlywheelInertiaGiven::Moment { inertia } => *inertia,
            FlywheelInertiaGiven::Gyration { mass, radius } => *mass * radius.powi(2),
        };
        let why = "Coefficient of fluctuation of speed: speed range divided by the mean speed, against a constant resistance";
        let fluctuation = sheet.step("C_s", "1", energy / (inertia * speed.powi(2)), why);
        sheet.answer("speed_fluctuation", "Coefficient of fluctuation of speed", fluctuation);
        sheet.verify(|| {
            let [fast, slow] = [1.0, -1.0].map(|sign| speed * (fluctuation * (sign / 2.0) + 1.0));
            let range = inertia * (fast.powi(2) - slow.powi(2)) / 2.0;
            let what = "the kinetic energies of the flywheel at its maximum and minimum speed differ by the fluctuation";
            sheet.check(what, range, energy);
        });
    }
    sheet.verify(|| {
        let force = |motion: &PistonMotion, angle: f64| {
            let fraction = motion.displacement / kernel.stroke();
            gas.map_or(0.0, |gas| gas.force(angle, fraction, motion.arm >= 0.0))
        };
        let work_at = |angle: f64| {
            let motion = kernel.motion(steady(angle));
            kernel.moment_by_virtual_work(steady(angle), &motion, force(&motion, angle))
        };
        let what = "maximum turning moment from the virtual work at its crank angle";
        sheet.check_sum(what, most, work_at(most_at.value()).into(), size);
        let what = "minimum turning moment from the virtual work at its crank angle";
        sheet.check_sum(what, least, work_at(least_at.value()).into(), size);
        for (found, shown, what) in [
            (cycle.largest.0, most_at, "the turning moment has zero slope at its maximum"),
            (cycle.least.0, least_at, "the turning moment has zero slope at its minimum"),
        ] {
            if is_smooth_top(found, period, &corners) {
                // The extreme was found by differences of the fourth order.
                let error = slope(work_at, found) - rough_slope(work_at, found);
                sheet.check_residual(what, slope(work_at, shown.value()).into(), size, error);
            }
        }
        let [coarse, fine] = [1, 2].map(|parts| mean_square(work_at, period, &corners, 48 * parts).sqrt());
        let what = "root mean square of the turning moment from the virtual work over the cycle";
        sheet.check_residual(what, (rms.value() - fine).into(), size, fine - coarse);
        if kernel.model == PistonFormula::Exact {
            let reaction_at = |angle: f64| {
                let force = force(&kernel.motion(steady(angle)), angle);
                kernel.reactions(steady(angle), force).map_or(f64::NAN, |reactions| reactions.moment)
            };
            let what = "maximum turning moment from the Newton–Euler equations at its crank angle";
            sheet.check_sum(what, most, reaction_at(cycle.largest.0).into(), size);
            let what = "minimum turning moment from the Newton–Euler equations at its crank angle";
            sheet.check_sum(what, least, reaction_at(cycle.least.0).into(), size);
            if gas.is_none() && kernel.friction == 0.0 && kernel.gravity == [0.0; 2] {
                let energies = || cycle.crossings.iter().map(|it| kernel.kinetic_energy(it.0, speed.value()));
                let range =
                    energies().fold(f64::NEG_INFINITY, f64::max) - energies().fold(f64::INFINITY, f64::min);
                let what = "fluctuation of energy as the range of the kinetic energy of piston and rod";
                sheet.check_sum(what, energy, range.max(0.0).into(), size);
            }
        }
        let friction = 2.0 * f64::from(turns) * kernel.stroke() * kernel.friction;
        let done = match (gas, &kernel.model) {
            (None, _) => Some(0.0),
            (Some(gas), PistonFormula::Exact) => work(gas, kernel.stroke()),
            _ => None,
        };
        if let Some(done) = done {
            let what = "mean turning moment from the work of gas and friction per cycle";
            sheet.check_sum(what, mean, ((done - friction) / period).into(), size);
            if let Some(power) = power {
                let rate = speed.value() / period;
                let what = "mean power from the work of gas and friction per cycle and the cycle time";
                sheet.check_sum(what, power, ((done - friction) * rate).into(), size * speed.value());
            }
        }
    });
    Ok(Some(Turned { cycle, period }))
}

/// Step of the derivatives of a moment.
const STEP: f64 = 1e-3;

/// The derivative of a moment.
fn slope(moment: impl Fn(f64) -> f64, angle: f64) -> f64 {
    derivative(moment, angle, STEP)
}

/// The same by differences of the fourth order, over the steps in which an extreme is searched for.
fn rough_slope(moment: impl Fn(f64) -> f64, angle: f64) -> f64 {
    let step = 0.02 * TAU / 96.0;
    let difference = |k: f64| moment(angle + k * step) - moment(angle - k * step);
    (8.0 * difference(1.0) - difference(2.0)) / (12.0 * step)
}

/// Returns true if the moment is smooth about an extreme that was found at a zero of its slope, and not at one of the
/// equal parts of the cycle.
fn is_smooth_top(angle: f64, period: f64, corners: &[f64]) -> bool {
    let part = angle * 96.0 / TAU;
    let far = |corner: &f64| {
        let apart = (angle - corner).rem_euclid(period);
        apart.min(period - apart) > 8.0 * STEP
    };
    (part - part.round()).abs() > 1e-9 && corners.iter().all(far)
}

/// The mean square of a moment over the cycle, by Gauss's rule on so many parts of a turn and between the corners.
fn mean_square(moment: impl Fn(f64) -> f64, period: f64, corners: &[f64], parts: usize) -> f64 {
    let mut ends: Vec<f64> = corners.iter().map(|corner| corner.rem_euclid(period)).collect();
    ends.extend([0.0, period]);
    ends.sort_by(f64::total_cmp);
    let of_pair = |pair: &[f64]| {
        let width = pair[1] - pair[0];
        let panels = (width / TAU * parts as f64).ceil() as usize;
        width * gauss_legendre::integral(panels, |part| moment(pair[0] + part * width).powi(2))
    };
    ends.windows(2).map(of_pair).sum::<f64>() / period
}

/// Work of the gas in a cycle, from its diagram over the stroke.
fn work(gas: &GasCycle, stroke: f64) -> Option<f64> {
    let diagram = match &gas.diagram {
        Indicated::Drawn(diagram) => diagram,
        Indicated::Ideal(cycle) => return Some(cycle.area()[0] * stroke * gas.area),
    };
    let mean = match diagram {
        &Diagram::Expansion { admission, exhaust, cut_off, clearance, exponent } => {
            if (exponent - 1.0).abs() > 1e-6 {
                gas::mean_pressure(admission, cut_off, Some(clearance), exponent, exhaust)
            } else {
                gas::mean_pressure_hyperbolic(admission, cut_off, Some(clearance), exhaust)
            }
        }
        Diagram::Stroke(rows) => {
            let over = |row: &[f64; 3]| row[1] - row[2];
            let inside: f64 = rows
                .windows(2)
                .map(|pair| f64::midpoint(over(&pair[0]), over(&pair[1])) * (pair[1][0] - pair[0][0]))
                .sum();
            let (first, last) = (rows.first()?, rows.last()?);
            inside + over(first) * first[0] + over(last) * (1.0 - last[0])
        }
        Diagram::Angle { .. } => return None,
    };
    Some(mean * stroke * (gas.area + gas.crank_side.unwrap_or(0.0)))
}

/// Crank angles at which the moment has a corner: dead centres, where friction turns, and corners of the diagram.
fn corners(kernel: &Kernel, gas: Option<&GasCycle>, turns: u8) -> Vec<f64> {
    let [outer, inner] = kernel.dead_centres();
    let mut once = vec![outer, inner];
    let mut all = Vec::new();
    if let Some(gas) = gas {
        match gas.diagram.corners() {
            Corners::Angles(angles) => all.extend(angles),
            Corners::Fractions(fractions) => {
                let stroke = kernel.stroke();
                let gone = |angle: f64| {
                    kernel.motion(CrankMotion { angle, speed: 0.0, acceleration: 0.0 }).displacement / stroke
                };
                for fraction in fractions.into_iter().flat_map(|f| [f, 1.0 - f]) {
                    for range in [[outer, inner], [inner, outer + TAU]] {
                        let angle =
                            roots::find(|angle| gone(angle) - fraction, range, |_| ControlFlow::Continue(()));
                        once.extend(angle.ok());
                    }
                }
            }
        }
    }
    for turn in 0..turns {
        all.extend(once.iter().map(|angle| angle + TAU * f64::from(turn)));
    }
    all
}
