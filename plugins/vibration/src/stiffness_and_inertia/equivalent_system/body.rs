//! Inertia, stiffness and damping of the body about its pivot, its point of contact or its axle, term by term.

use dalembert_core::{Refusal, Text, Worksheet};
use dalembert_mechanics::Real;

use super::{
    AttachedDamperGiven, AttachedSpringGiven, CordMassGiven, EquivalentSystemGiven, LeverBarGiven,
    LeverMassGiven, LeverPositionGiven, RollingSurfaceGiven, TurningBodyGiven,
};
use crate::{
    shared::inertia::{RollingShapeGiven, moment_of_inertia},
    sources::{KELLY, RAO},
};

/// The sums, and the terms that springs and dampers have in them.
pub(super) struct Terms<N> {
    /// Moment of inertia, kg·m².
    pub(super) inertia: N,
    /// Torsional stiffness, N·m/rad: above zero.
    pub(super) stiffness: N,
    /// Torsional damping, N·m·s/rad.
    pub(super) damping: Option<N>,
    /// Part of the stiffness that is of weights.
    pub(super) weights: Option<N>,
    /// Part of each spring.
    pub(super) springs: Vec<N>,
    /// Part of each damper.
    pub(super) dampers: Vec<N>,
}

/// Writes the terms and their sums.
///
/// # Errors
/// Nothing that moves, nothing that brings it back, a position that weights upset.
pub(super) fn terms<W: Worksheet>(
    given: &EquivalentSystemGiven<W>,
    sheet: W,
) -> Result<Terms<W::Num>, Refusal> {
    let (inertia, weights) = match &given.body {
        TurningBodyGiven::Lever { bar, position, masses } => lever(bar, position, masses, sheet),
        TurningBodyGiven::Rolling { mass, radius, shape, surface, masses } => {
            rolling([*mass, *radius], shape, surface, masses, sheet)?
        }
        TurningBodyGiven::Pulley { inertia, masses } => {
            let own = moment_of_inertia(inertia, sheet, "J_p".into());
            (with_cords(own, masses, sheet), None)
        }
    };
    if inertia.value() <= 0.0 {
        return Err(Refusal::because(
            "nothing on the light lever has mass at a distance from the pivot: write a mass, or the mass of the bar",
        ));
    }
    let springs: Vec<W::Num> =
        (1..).zip(&given.springs).map(|(n, spring)| spring_term(n, spring, sheet)).collect();
    let dampers: Vec<W::Num> =
        (1..).zip(&given.dampers).map(|(n, damper)| damper_term(n, damper, sheet)).collect();
    let parts = || springs.iter().copied().chain(weights);
    if parts().next().is_none() {
        return Err(Refusal::because(
            "nothing brings the body back to its position: write a spring, or the weight of a hanging lever",
        ));
    }
    if weights.is_some() && !springs.is_empty() {
        let of_springs = || W::Num::sum(springs.iter().copied());
        sheet.common_error("K_eq", "the moment of the weights neglected", of_springs);
    }
    let stiffness = sheet.step(
        "K_eq",
        "N*m/rad",
        W::Num::sum(parts()),
        (
            "Equivalent torsional stiffness: moment that brings the body back, for each radian",
            KELLY.at("ch. 2"),
        ),
    );
    if stiffness.value() <= 0.0 {
        let held = springs.iter().map(|spring| spring.value()).sum::<f64>();
        return Err(Refusal::because(
            Text::new("the position is unstable: the springs give {held}, and the weights take {taken} from it; write stiffer springs or larger arms")
                .with_quantity("held", held, "N*m/rad")
                .with_quantity("taken", held - stiffness.value(), "N*m/rad"),
        ));
    }
    let damping = (dampers.iter().any(|damper| damper.value() > 0.0)).then(|| {
        let why = (
            "Equivalent torsional damping: moment of the dampers at one radian per second",
            KELLY.at("ch. 2"),
        );
        sheet.step("C_eq", "N*m*s/rad", W::Num::sum(dampers.iter().copied()), why)
    });
    Ok(Terms { inertia, stiffness, damping, weights, springs, dampers })
}

fn lever<W: Worksheet>(
    bar: &LeverBarGiven<W>,
    position: &LeverPositionGiven<W>,
    masses: &[LeverMassGiven<W>],
    sheet: W,
) -> (W::Num, Option<W::Num>) {
    let mut inertias = Vec::new();
    // Mass times distance from the pivot.
    let mut moments = Vec::new();
    match bar {
        LeverBarGiven::Light {} => {}
        LeverBarGiven::Uniform { mass, length, pivot } => {
            let centre = sheet.step(
                "d",
                "m",
                *length / 2.0 - *pivot,
                "Distance of the centre of the bar from the pivot",
            );
            let why = ("Moment of inertia of the bar about the pivot: m L²/12 + m d²", RAO.at("§2.3"));
            let own = *mass * length.powi(2) / 12.0 + *mass * centre.powi(2);
            let about_centre = || *mass * length.powi(2) / 12.0;
            sheet.common_error("J_b", "the parallel-axis term omitted", about_centre);
            let about_end = || *mass * length.powi(2) / 3.0;
            sheet.common_error("J_b", "the moment of inertia about the end of the rod taken", about_end);
            let added = || *mass * length.powi(2) / 3.0 + *mass * centre.powi(2);
            let what = "the parallel-axis term added to the moment of inertia about the end";
            sheet.common_error("J_b", what, added);
            inertias.push(sheet.step("J_b", "kg*m^2", own, why));
            moments.push(*mass * centre);
        }
        LeverBarGiven::Given { inertia, mass, centre } => {
            inertias.push(*inertia);
            moments.push(*mass * *centre);
        }
    }
    for (n, LeverMassGiven { mass, distance, inertia, .. }) in (1..).zip(masses) {
        let carried = *mass * distance.powi(2);
        let own = inertia.map_or(carried, |inertia| inertia + carried);
        let why = Text::new("Moment of inertia of mass {n} about the pivot").with("n", n);
        inertias.push(sheet.step(("J", n), "kg*m^2", own, why));
        moments.push(*mass * *distance);
    }
    let inertia = sheet.step(
        "J_eq",
        "kg*m^2",
        W::Num::sum(inertias),
        ("Equivalent moment of inertia about the pivot", KELLY.at("ch. 2")),
    );
    let of_weights = |gravity: W::Num, why: &'static str| {
        let moment = sheet.step(
            "S",
            "kg*m",
            W::Num::sum(moments.iter().copied()),
            "Sum of the masses times their distances from the pivot",
        );
        sheet.step("K_g", "N*m/rad", moment * gravity, (why, RAO.at("§2.3")))
    };
    let weights = match position {
        LeverPositionGiven::Horizontal {} => None,
        LeverPositionGiven::Hanging { gravity } => {
            Some(of_weights(*gravity, "Moment of the weights for each radian: they bring the lever back"))
        }
        LeverPositionGiven::Standing { gravity } => {
            Some(of_weights(-*gravity, "Moment of the weights for each radian: they upset the lever"))
        }
    };
    (inertia, weights)
}

fn rolling<W: Worksheet>(
    [mass, radius]: [W::Num; 2],
    shape: &RollingShapeGiven<W>,
    surface: &RollingSurfaceGiven<W>,
    masses: &[CordMassGiven<W>],
    sheet: W,
) -> Result<(W::Num, Option<W::Num>), Refusal> {
    let own = shape.about_centre([mass, radius], sheet);
    sheet.common_error("J_C", "the moment of inertia about the centre used for a rolling body", || own);
    let translation = || mass * radius.powi(2);
    sheet.common_error("J_C", "the kinetic energy of the rotation neglected", translation);
    let about = sheet.step(
        "J_C",
        "kg*m^2",
        own + mass * radius.powi(2),
        ("Moment of inertia about the point of contact, which is at rest: J_G + m r²", RAO.at("§2.3")),
    );
    let weights = match surface {
        RollingSurfaceGiven::Flat {} => None,
        RollingSurfaceGiven::Trough { radius: large, gravity } => {
            if large.value() <= radius.value() {
                return Err(Refusal::because(
                    "the surface is not wider than the body that rolls in it: write a radius of the surface above that of the body",
                ));
            }
            let why = (
                "The centre moves by r θ on a circle of radius R − r: moment of the weight for each radian",
                RAO.at("§2.3"),
            );
            let pendulum = || mass * *gravity * (*large - radius);
            let what = "the angle of the body taken as that of its centre about the centre of the surface";
            sheet.common_error("K_g", what, pendulum);
            let full = || mass * *gravity * radius.powi(2) / *large;
            let what = "the radius of the surface taken as that of the path of the centre";
            sheet.common_error("K_g", what, full);
            let weight = mass * *gravity * radius.powi(2) / (*large - radius);
            Some(sheet.step("K_g", "N*m/rad", weight, why))
        }
    };
    Ok((with_cords(about, masses, sheet), weights))
}

/// The inertia with that of masses on cords.
fn with_cords<W: Worksheet>(own: W::Num, masses: &[CordMassGiven<W>], sheet: W) -> W::Num {
    let carried = |(n, CordMassGiven { mass, arm, .. }): (usize, &CordMassGiven<W>)| {
        let why = Text::new("Mass {n} moves by l θ: its part in the moment of inertia").with("n", n);
        sheet.step(("J", n), "kg*m^2", *mass * arm.powi(2), why)
    };
    let parts: Vec<W::Num> = (1..).zip(masses).map(carried).collect();
    sheet.step(
        "J_eq",
        "kg*m^2",
        W::Num::sum(std::iter::once(own).chain(parts)),
        ("Equivalent moment of inertia: the kinetic energies add up", KELLY.at("ch. 2")),
    )
}

fn spring_term<W: Worksheet>(n: usize, spring: &AttachedSpringGiven<W>, sheet: W) -> W::Num {
    match spring {
        AttachedSpringGiven::Linear { stiffness, arm, angle } => {
            if let Some(angle) = angle {
                let unsquared = || *stiffness * arm.powi(2) * angle.cos();
                sheet.common_error(("K", n), "the cosine of the inclination not squared", unsquared);
            }
            let (value, why) = match angle {
                None => (
                    *stiffness * arm.powi(2),
                    Text::new("Spring {n}: its end moves by a θ, and its force k a θ has the arm a"),
                ),
                Some(angle) => (
                    *stiffness * (*arm * angle.cos()).powi(2),
                    Text::new("Spring {n}: it stretches by a θ cos α, and its force has the arm a cos α"),
                ),
            };
            sheet.step(("K", n), "N*m/rad", value, why.with("n", n))
        }
        AttachedSpringGiven::Torsional { stiffness } => *stiffness,
    }
}

fn damper_term<W: Worksheet>(n: usize, damper: &AttachedDamperGiven<W>, sheet: W) -> W::Num {
    match damper {
        AttachedDamperGiven::Linear { coefficient, arm } => {
            let why = Text::new("Damper {n}: its end moves at b θ′, and its force c b θ′ has the arm b")
                .with("n", n);
            sheet.step(("C", n), "N*m*s/rad", *coefficient * arm.powi(2), why)
        }
        AttachedDamperGiven::Torsional { coefficient } => *coefficient,
    }
}
