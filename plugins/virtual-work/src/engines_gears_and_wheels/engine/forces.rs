//! Forces along the stroke, in the rod, at the guide and at the crank pin, worked.

use dalembert_core::{Refusal, Worksheet};
use dalembert_mechanics::{
    Real,
    slider_crank::engine::{self as kernel, lateral},
};

use super::{
    Engine, EngineGiven, Orientation, OrientationGiven,
    gas::{self, GasCycle, GasGiven},
    motion::{Lengths, PistonState},
    rod::Masses,
};
use crate::sources::{BEVAN, KHURMI, RIUL};

/// Gravity along the stroke towards the crank, and across it; none where it is nothing.
pub(super) struct GravityField<N> {
    pub along: Option<N>,
    pub across: Option<N>,
}

/// Parameters of the forces.
pub(super) struct EngineProblem<'a, W: Worksheet> {
    pub given: &'a EngineGiven<W>,
    pub lengths: &'a Lengths<W::Num>,
    pub moving: &'a PistonState<W::Num>,
    pub rod: Option<&'a Masses<W::Num>>,
    pub field: &'a GravityField<W::Num>,
}

/// The forces that others need.
pub(super) struct Forces<N> {
    /// The force on the piston, given or found.
    pub pressure: f64,
    pub gas: Option<GasCycle>,
    pub gudgeon: N,
    pub guide: N,
    pub radial: N,
    /// The size of the force at the crank pin.
    pub crank_pin: N,
    pub moment: N,
    /// The part of the moment that comes from inertia.
    pub inertia_moment: Option<N>,
}

pub(super) fn gravity<W: Worksheet>(
    problem: &Engine,
    given: &EngineGiven<W>,
    rod: Option<&Masses<W::Num>>,
    sheet: W,
) -> GravityField<W::Num> {
    let none = GravityField { along: None, across: None };
    if problem.gravity == 0.0 || (problem.reciprocating == 0.0 && rod.is_none()) {
        return none;
    }
    let g = given.gravity;
    match (&problem.orientation, &given.orientation) {
        (Orientation::Vertical, _) => GravityField { along: Some(g), across: None },
        (Orientation::Horizontal, _) => GravityField { along: None, across: Some(g) },
        (_, OrientationGiven::Inclined { angle }) => GravityField {
            along: Some(sheet.step(
                "g_x",
                "m/s^2",
                g * angle.sin(),
                "Gravity along the stroke, towards the crank",
            )),
            across: Some(sheet.step("g_y", "m/s^2", g * angle.cos(), "Gravity transverse to the stroke")),
        },
        _ => none,
    }
}

/// All forces; nothing where there is neither a load nor a mass.
pub(super) fn forces<W: Worksheet>(
    problem: &Engine,
    at: &EngineProblem<'_, W>,
    kernel: &kernel::EngineCylinder,
    sheet: W,
) -> Result<Option<Forces<W::Num>>, Refusal> {
    let &EngineProblem { given, lengths, moving, rod, field } = at;
    let known = gas::force(&problem.gas, &given.gas, lengths, moving, kernel, sheet)?;
    let sought = match &given.gas {
        GasGiven::Balancing { moment } => Some(*moment),
        _ => None,
    };
    let massless = problem.reciprocating == 0.0 && rod.is_none();
    let friction = given.friction.filter(|force| force.value() != 0.0);
    if known.is_none() && sought.is_none() && massless && friction.is_none() {
        return Ok(None);
    }
    let reciprocating = (problem.reciprocating != 0.0).then_some(given.reciprocating);
    if let (Some(mass), Some(rod)) = (reciprocating, rod) {
        sheet.common_error("M_R", "the whole mass of the rod counted as reciprocating", || mass + rod.mass);
        sheet.common_error("M_R", "a third of the mass of the rod counted as reciprocating", || {
            mass + rod.mass / 3.0
        });
    }
    let mass = match (reciprocating, rod) {
        (Some(mass), Some(rod)) => Some(sheet.step(
            "M_R",
            "kg",
            mass + rod.at_gudgeon,
            "Reciprocating mass, including the rod's equivalent mass at the gudgeon pin",
        )),
        (Some(mass), None) => Some(mass),
        (None, Some(rod)) => Some(rod.at_gudgeon),
        (None, None) => None,
    };
    let resisting = resistances(mass, friction, moving, field, sheet);
    let others = other_moments(at, sheet);
    let (pressure, effort, gas) = match (known, sought) {
        (_, Some(moment)) => {
            let (force, effort) = sought_force(moment, &resisting, &others, moving, sheet)?;
            (Some(force), effort, None)
        }
        (Some((force, gas)), None) => (Some(force), net_effort(Some(force), &resisting, sheet), gas),
        (None, None) => (None, net_effort(None, &resisting, sheet), None),
    };
    sheet.answer("effort", "Net piston effort", effort);
    if let Some(pressure) = pressure {
        sheet.answer("piston_force", "Force on the piston", pressure);
    }
    let gudgeon = gudgeon(at, pressure, effort, friction, sheet);
    let (moment, inertia_moment) = turning_moment(effort, &resisting, &others, moving, sheet);
    let pins = pins(at, effort, mass, moment, sheet);
    if let (Some(pressure), None, None) = (pressure, sought, moving.turning) {
        reversal(at, pressure, reciprocating, friction, kernel, sheet);
    }
    Ok(Some(Forces {
        pressure: pressure.map_or(0.0, Real::value),
        gas,
        gudgeon,
        guide: pins.guide,
        radial: pins.radial,
        crank_pin: pins.size,
        moment,
        inertia_moment,
    }))
}

/// Forces along the stroke other than that of the gas, with their sign in the piston effort.
struct Resistances<N> {
    inertia: Option<N>,
    weight: Option<N>,
    /// And whether it helps: the piston moves away from the crank.
    friction: Option<(N, bool)>,
}

fn resistances<W: Worksheet>(
    mass: Option<W::Num>,
    friction: Option<W::Num>,
    moving: &PistonState<W::Num>,
    field: &GravityField<W::Num>,
    sheet: W,
) -> Resistances<W::Num> {
    let inertia = mass.zip(moving.acceleration).map(|(mass, acceleration)| {
        let why =
            ("Inertia force of the reciprocating masses, opposite to their acceleration", RIUL.at("eq. 5"));
        sheet.step("F_I", "N", mass * acceleration, why)
    });
    if let Some(inertia) = inertia {
        sheet.answer("inertia_force", "Inertia force along the stroke, away from the crank", inertia);
    }
    let weight = mass.zip(field.along).map(|(mass, gravity)| {
        sheet.step("W", "N", mass * gravity, "Weight of the reciprocating masses along the stroke")
    });
    if let Some(weight) = weight {
        sheet.answer("weight", "Weight along the stroke", weight);
    }
    let friction = friction.map(|friction| (friction, moving.arm.value() < 0.0));
    Resistances { inertia, weight, friction }
}

fn net_effort<W: Worksheet>(gas: Option<W::Num>, resisting: &Resistances<W::Num>, sheet: W) -> W::Num {
    let terms =
        [gas.map(helps), resisting.inertia.map(hinders), resisting.weight.map(helps), resisting.friction];
    let why = "Net effort along the stroke, towards the crank";
    sheet.step("F_P", "N", signed(terms), (why, KHURMI.at("ch. 15")))
}

fn helps<N>(force: N) -> (N, bool) {
    (force, true)
}

fn hinders<N>(force: N) -> (N, bool) {
    (force, false)
}

/// The sum of forces that help or hinder.
fn signed<N: Real>(terms: impl IntoIterator<Item = Option<(N, bool)>>) -> N {
    let add = |sum: Option<N>, (force, helps): (N, bool)| {
        Some(match sum {
            None if helps => force,
            None => -force,
            Some(sum) if helps => sum + force,
            Some(sum) => sum - force,
        })
    };
    terms.into_iter().flatten().fold(None, add).unwrap_or_else(|| 0.0.into())
}

/// Moments on the crankshaft that do not come from the piston effort.
struct Moments<N> {
    weight: Option<N>,
    correction: Option<N>,
    turning: Option<N>,
}

impl<N: Real> Moments<N> {
    fn all(&self) -> impl Iterator<Item = N> {
        [self.weight, self.correction, self.turning].into_iter().flatten()
    }
}

fn other_moments<W: Worksheet>(at: &EngineProblem<'_, W>, sheet: W) -> Moments<W::Num> {
    let &EngineProblem { lengths, moving, rod, field, .. } = at;
    let none = Moments { weight: None, correction: None, turning: None };
    let Some(rod) = rod else { return none };
    let (crank, angle) = (lengths.crank, moving.angle);
    let lever = match (field.along, field.across) {
        (Some(along), Some(across)) => Some(along * angle.sin() - across * angle.cos()),
        (Some(along), None) => Some(along * angle.sin()),
        (None, Some(across)) => Some(-(across * angle.cos())),
        (None, None) => None,
    };
    let weight = lever.filter(|_| rod.at_pin.value() != 0.0).map(|lever| {
        let why = "Virtual work of the weight of the rod's share at the crank pin, for δθ";
        sheet.step("T_W", "N*m", rod.at_pin * crank * lever, (why, BEVAN.at("ch. 12")))
    });
    let correction =
        rod.missing.zip(moving.rod_acceleration).zip(moving.turn).map(|((missing, acceleration), turn)| {
            let couple = sheet.step(
                "C",
                "N*m",
                -(missing * acceleration),
                ("Inertia couple that corrects the two masses of the rod", BEVAN.at("ch. 12")),
            );
            sheet.answer("correction_couple", "Correction couple of the rod", couple);
            let why = "Virtual work of the correction couple, for δθ";
            sheet.step("T_C", "N*m", couple * turn, (why, BEVAN.at("ch. 12")))
        });
    let turning = moving.turning.map(|alpha| {
        let why = "Virtual work of the inertia of the rod's share at the crank pin, for δθ";
        sheet.step("T_α", "N*m", -(rod.at_pin * crank.powi(2) * alpha), why)
    });
    Moments { weight, correction, turning }
}

/// The force on the piston that gives a turning moment, and the effort.
fn sought_force<W: Worksheet>(
    moment: W::Num,
    resisting: &Resistances<W::Num>,
    others: &Moments<W::Num>,
    moving: &PistonState<W::Num>,
    sheet: W,
) -> Result<(W::Num, W::Num), Refusal> {
    if moving.arm.value().abs() <= 1e-12 * moving.displacement.value().abs().max(moving.arm.value().abs())
        || moving.arm.value() == 0.0
    {
        return Err(Refusal::because(
            "at a dead centre no force on the piston turns the crank: choose another crank angle",
        ));
    }
    let rest = others.all().fold(moment, |rest, other| rest - other);
    let why = "Virtual work F_P δs + ΣT δθ = M δθ: the effort that produces the turning moment";
    let effort = sheet.step("F_P", "N", rest / moving.arm, (why, RIUL.at("eq. 5")));
    let friction = resisting.friction.map(|(friction, helps)| (friction, !helps));
    let force =
        signed([Some(helps(effort)), resisting.inertia.map(helps), resisting.weight.map(hinders), friction]);
    let force = sheet.step("F_G", "N", force, "Force on the piston, towards the crank");
    Ok((force, effort))
}

/// The load of the piston alone on the gudgeon pin.
fn gudgeon<W: Worksheet>(
    at: &EngineProblem<'_, W>,
    pressure: Option<W::Num>,
    effort: W::Num,
    friction: Option<W::Num>,
    sheet: W,
) -> W::Num {
    let &EngineProblem { given, moving, rod, field, .. } = at;
    if rod.is_none_or(|rod| rod.at_gudgeon.value() == 0.0) {
        return effort;
    }
    let mass = Some(given.reciprocating).filter(|mass| mass.value() != 0.0);
    let load = signed([
        pressure.map(helps),
        mass.zip(moving.acceleration).map(|(mass, acceleration)| hinders(mass * acceleration)),
        mass.zip(field.along).map(|(mass, gravity)| helps(mass * gravity)),
        friction.map(|friction| (friction, moving.arm.value() < 0.0)),
    ]);
    let load = sheet.step(
        "F_K",
        "N",
        load,
        "Load of the piston on the gudgeon pin, without the rod's equivalent mass",
    );
    sheet.answer("gudgeon_load", "Load of the piston on the gudgeon pin, along the stroke", load);
    load
}

fn turning_moment<W: Worksheet>(
    effort: W::Num,
    resisting: &Resistances<W::Num>,
    others: &Moments<W::Num>,
    moving: &PistonState<W::Num>,
    sheet: W,
) -> (W::Num, Option<W::Num>) {
    let alone = others.all().next().is_none();
    let why = ("Virtual work of the piston effort: T δθ = F_P δs", RIUL.at("eqs. 1–5"));
    let moment = if alone {
        sheet.step("T", "N*m", effort * moving.arm, why)
    } else {
        let own = sheet.step("T_P", "N*m", effort * moving.arm, why);
        sheet.answer("effort_moment", "Moment of the piston effort", own);
        if let Some(correction) = others.correction {
            sheet.answer("correction_moment", "Moment of the correction couple", correction);
        }
        if let Some(weight) = others.weight {
            sheet.answer("weight_moment", "Moment of the weight at the crank pin", weight);
        }
        let sum = W::Num::sum(std::iter::once(own).chain(others.all()));
        let why = "The virtual work of all loads equals that of the turning moment";
        sheet.step("T", "N*m", sum, (why, RIUL.at("eq. 5")))
    };
    sheet.answer("turning_moment", "Turning moment on the crankshaft", moment);
    let inertia = resisting.inertia.map(|force| {
        let own = -(force * moving.arm);
        [others.correction, others.turning].into_iter().flatten().fold(own, |sum, part| sum + part)
    });
    (moment, inertia)
}

/// Guide and crank pin.
struct Pins<N> {
    guide: N,
    radial: N,
    size: N,
}

fn pins<W: Worksheet>(
    at: &EngineProblem<'_, W>,
    effort: W::Num,
    mass: Option<W::Num>,
    moment: W::Num,
    sheet: W,
) -> Pins<W::Num> {
    let &EngineProblem { lengths, moving, rod, field, .. } = at;
    let (angle, obliquity) = (moving.angle, moving.obliquity);
    let weight_across = mass.zip(field.across).map(|(mass, gravity)| mass * gravity);
    let cite = KHURMI.at("ch. 15");
    let (guide, tangential, radial) = if let Some(rod) = rod {
        let missing = rod.missing.zip(moving.rod_acceleration);
        let across = match missing {
            Some((missing, acceleration)) => lateral(effort, obliquity, missing * acceleration, lengths.rod),
            None => effort * obliquity.tan(),
        };
        let across = sheet.step(
            "V",
            "N",
            across,
            "Force transverse to the stroke at the gudgeon pin: moments of the rod about the crank pin",
        );
        let guide = guide(across, weight_across, sheet);
        let turned = || rod.at_pin * lengths.crank;
        let tangential = signed([
            Some(helps(effort * angle.sin())),
            Some(helps(across * angle.cos())),
            field.along.map(|gravity| helps(rod.at_pin * gravity * angle.sin())),
            field.across.map(|gravity| hinders(rod.at_pin * gravity * angle.cos())),
            moving.turning.map(|alpha| hinders(turned() * alpha)),
        ]);
        let radial = signed([
            Some(helps(effort * angle.cos())),
            Some(hinders(across * angle.sin())),
            field.along.map(|gravity| helps(rod.at_pin * gravity * angle.cos())),
            field.across.map(|gravity| helps(rod.at_pin * gravity * angle.sin())),
            moving.speed.map(|speed| hinders(turned() * speed.powi(2))),
        ]);
        let why = "Force at the crank pin in the direction of its motion, with the loads of the rod's equivalent mass there";
        let tangential = sheet.step("F_T", "N", tangential, (why, cite));
        let why = "Force at the crank pin towards the crankshaft";
        (guide, tangential, sheet.step("F_R", "N", radial, (why, cite)))
    } else {
        let thrust = sheet.step(
            "F_Q",
            "N",
            effort / obliquity.cos(),
            ("Thrust in the rod, whose component along the stroke is the effort", cite),
        );
        sheet.answer("rod_thrust", "Thrust in the rod", thrust);
        let across = effort * obliquity.tan();
        let guide = match weight_across {
            None => {
                let why = ("Thrust on the guide: the component of the rod's thrust across the stroke", cite);
                let guide = sheet.step("F_N", "N", across, why);
                sheet.answer("guide_thrust", "Thrust on the guide", guide);
                guide
            }
            Some(_) => guide(across, weight_across, sheet),
        };
        let why = ("Force at the crank pin in the direction of its motion", cite);
        let tangential = sheet.step("F_T", "N", thrust * (angle + obliquity).sin(), why);
        let why = ("Thrust on the bearings along the crank, towards the crankshaft", cite);
        (guide, tangential, sheet.step("F_R", "N", thrust * (angle + obliquity).cos(), why))
    };
    sheet.answer("tangential", "Tangential force at the crank pin", tangential);
    sheet.answer("radial", "Radial force at the crank pin, towards the crankshaft", radial);
    let size = (tangential.powi(2) + radial.powi(2)).sqrt();
    let size = sheet.step(
        "F_A",
        "N",
        size,
        "Force at the crank pin; with a balanced crank, also the force on the main bearings",
    );
    sheet.answer("crank_pin", "Force at the crank pin", size);
    sheet.verify(|| {
        let what = "the turning moment is the tangential force times the crank";
        let scale = size.value().max(tangential.value().abs()) * lengths.crank.value();
        sheet.check_zero(what, moment - tangential * lengths.crank, scale);
    });
    Pins { guide, radial, size }
}

fn guide<W: Worksheet>(across: W::Num, weight: Option<W::Num>, sheet: W) -> W::Num {
    let guide = match weight {
        Some(weight) => across + weight,
        None => across,
    };
    let guide = sheet.step("F_N", "N", guide, "Thrust on the guide");
    sheet.answer("guide_thrust", "Thrust on the guide", guide);
    guide
}

/// The speed at which the load on the gudgeon pin is zero at this crank angle.
fn reversal<W: Worksheet>(
    at: &EngineProblem<'_, W>,
    pressure: W::Num,
    reciprocating: Option<W::Num>,
    friction: Option<W::Num>,
    kernel: &kernel::EngineCylinder,
    sheet: W,
) {
    let &EngineProblem { moving, field, .. } = at;
    let (Some(mass), Some(speed), Some(acceleration)) = (reciprocating, moving.speed, moving.acceleration)
    else {
        return;
    };
    let steady = signed([
        Some(helps(pressure)),
        field.along.map(|gravity| helps(mass * gravity)),
        friction.map(|friction| (friction, moving.arm.value() < 0.0)),
    ]);
    let share = steady.value() / (mass.value() * acceleration.value());
    if !(share.is_finite() && share > 0.0) {
        return;
    }
    let why = "Speed at which the inertia force, growing with ω², balances all other forces: the load on the gudgeon pin is zero";
    let reversal = speed * (steady / (mass * acceleration)).sqrt();
    let reversal = sheet.step("ω₀", "rpm", reversal, (why, KHURMI.at("ch. 15")));
    sheet.answer("reversal_speed", "Speed at which the load on the gudgeon pin reverses", reversal);
    sheet.verify(|| {
        let crank =
            dalembert_mechanics::slider_crank::CrankMotion { speed: reversal.value(), ..moving.crank() };
        let motion = kernel.motion(crank);
        let load = kernel.forces(crank, &motion, pressure.value()).gudgeon;
        let scale = pressure.value().abs() + (mass.value() * motion.acceleration).abs();
        sheet.check_zero("no load on the gudgeon pin at that speed", load.into(), scale);
    });
}
