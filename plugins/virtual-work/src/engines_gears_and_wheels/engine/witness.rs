//! The same motion and the same forces in a second method.

use dalembert_core::Worksheet;
use dalembert_mechanics::{
    Real,
    slider_crank::{
        Branch, SliderCrank,
        engine::{self as kernel, PistonFormula},
        piston::harmonics,
    },
};
use dalembert_numerics::differentiation::derivative;

use super::{
    Engine, Terms,
    forces::{EngineProblem, Forces},
    motion::{Lengths, PistonState},
};

/// The motion by the closure of the slider-crank, or as a sum of turning vectors.
pub(super) fn motion<W: Worksheet>(
    problem: &Engine,
    lengths: &Lengths<W::Num>,
    moving: &PistonState<W::Num>,
    engine: &kernel::EngineCylinder,
    sheet: W,
) {
    let mechanism =
        SliderCrank { crank: engine.crank, rod: engine.rod, offset: engine.offset, branch: Branch::Ahead };
    let crank = moving.crank();
    let Ok(closed) = mechanism.motion(crank) else { return };
    let what = "obliquity of the rod from the loop closure of the slider-crank";
    sheet.check_sum(what, moving.obliquity, (-closed.rod_angle).into(), 1.0);
    let (Some(speed), Some(velocity), Some(acceleration)) =
        (moving.speed, moving.velocity, moving.acceleration)
    else {
        return;
    };
    let natural = engine.crank * (crank.speed.powi(2) + crank.acceleration.abs());
    match problem.terms {
        Terms::Exact => {
            let scale = engine.crank * speed.value();
            let what = "velocity of the piston from the loop closure of the slider-crank";
            sheet.check_sum(what, velocity, (-closed.slider_velocity).into(), scale);
            let what = "acceleration of the piston from the loop closure of the slider-crank";
            let scale = natural.max(closed.slider_acceleration.abs());
            sheet.check_sum(what, acceleration, (-closed.slider_acceleration).into(), scale);
        }
        Terms::Two => {
            let second = [1.0 / lengths.ratio.value()];
            let turning = (crank.acceleration != 0.0).then_some(crank.acceleration);
            let again = harmonics::acceleration(engine.crank, &second, crank.angle, crank.speed, turning);
            let what = "acceleration of the piston as the sum of its primary and secondary components";
            sheet.check_sum(what, acceleration, again.into(), natural);
        }
        Terms::Harmonics { .. } => {
            let step = 1e-3;
            let displacement = |angle: f64| {
                let at = dalembert_mechanics::slider_crank::CrankMotion { angle, ..crank };
                engine.motion(at).displacement
            };
            let slope = derivative(displacement, crank.angle, step);
            let what = "velocity of the piston as the derivative of its displacement";
            sheet.check_sum(what, velocity, (slope * crank.speed).into(), engine.crank * crank.speed);
        }
    }
}

/// The turning moment from the virtual works of all loads on piston and rod, and the size of what it is added up from;
/// none of a piston with a given acceleration, whose crank does not turn.
pub(super) fn moment<N: Real>(
    moving: &PistonState<N>,
    engine: &kernel::EngineCylinder,
    pressure: f64,
) -> Option<[f64; 2]> {
    if moving.acceleration.is_some() && moving.speed.is_none() {
        return None;
    }
    let crank = moving.crank();
    let motion = engine.motion(crank);
    let moment = engine.moment_by_virtual_work(crank, &motion, pressure);
    let natural = engine.crank * (crank.speed.powi(2) + crank.acceleration.abs())
        + engine.gravity.iter().map(|g| g.abs()).sum::<f64>();
    let masses = (engine.reciprocating + engine.rod_mass) * natural.max(motion.acceleration.abs());
    let size = (pressure.abs() + engine.friction + masses) * (engine.crank + motion.arm.abs());
    let couple = (engine.missing_inertia() * motion.rod_acceleration * motion.turn).abs();
    Some([moment, size + couple])
}

/// Forces by Newton's and Euler's equations, and the inertia moment from the kinetic energy.
pub(super) fn forces<W: Worksheet>(
    problem: &EngineProblem<'_, W>,
    engine: &kernel::EngineCylinder,
    forces: &Forces<W::Num>,
    sheet: W,
) {
    let moving = problem.moving;
    let crank = moving.crank();
    // Of the piston with a given acceleration there is no crank that turns.
    if moving.acceleration.is_some() && moving.speed.is_none() {
        return;
    }
    let size = |forces: &kernel::Forces| {
        let loads = engine.reciprocating + engine.rod_mass;
        let natural = engine.crank * (crank.speed.powi(2) + crank.acceleration.abs())
            + engine.gravity.iter().map(|g| g.abs()).sum::<f64>();
        forces.tangential.abs()
            + forces.radial.abs()
            + forces.guide.abs()
            + forces.effort.abs()
            + loads * natural
    };
    let pressure = forces.pressure;
    if engine.model == PistonFormula::Exact {
        let plain = engine.forces(crank, &engine.motion(crank), pressure);
        let scale = size(&plain) * (1.0 + engine.rod / engine.crank);
        if let Ok(reactions) = engine.reactions(crank, pressure) {
            let what = "turning moment from the Newton–Euler equations of piston and rod";
            sheet.check_sum(what, forces.moment, reactions.moment.into(), scale * engine.crank);
            let what = "thrust on the guide from the Newton–Euler equations";
            sheet.check_sum(what, forces.guide, reactions.guide.into(), scale);
            let what = "load on the gudgeon pin from the Newton–Euler equations";
            sheet.check_sum(what, forces.gudgeon, (-reactions.gudgeon_pin[0]).into(), scale);
            let [x, y] = reactions.crank_pin;
            let radial = -x * crank.angle.cos() - y * crank.angle.sin();
            let what = "radial force at the crank pin from the Newton–Euler equations";
            sheet.check_sum(what, forces.radial, radial.into(), scale);
            let what = "force at the crank pin from the Newton–Euler equations";
            sheet.check_sum(what, forces.crank_pin, x.hypot(y).into(), scale);
        }
        if let (Some(moment), None) = (forces.inertia_moment, moving.turning) {
            let by_energy = engine.inertia_moment_by_energy(crank.angle, crank.speed);
            let what = "moment of the inertia forces as −dE/dθ of the kinetic energy";
            let energy = engine.kinetic_energy(std::f64::consts::FRAC_PI_2, crank.speed)
                + engine.kinetic_energy(0.0, crank.speed);
            sheet.check_sum(what, moment, by_energy.into(), energy.max(scale * engine.crank));
        }
    } else {
        let plain = engine.forces(crank, &engine.motion(crank), pressure);
        let scale = size(&plain);
        let what = "the turning moment in crank axes by the equilibrium of rod and piston";
        sheet.check_sum(what, forces.moment, plain.moment.into(), scale * engine.crank);
        let what = "thrust on the guide by the equilibrium of rod and piston";
        sheet.check_sum(what, forces.guide, plain.guide.into(), scale);
    }
}
