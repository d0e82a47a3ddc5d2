//! Forces on the bearings and stress in the shaft.

use dalembert_core::Worksheet;
use dalembert_mechanics::Real;

use super::{Rotor, ShaftAxisGiven, ShaftSpeedGiven, WhirlingShaft, WhirlingShaftGiven};
use crate::{
    shared::jeffcott::{Mounting, RotorShaft, RotorShaftGiven},
    sources::{BEER, RAO, SHIGLEY},
};

/// Answers the force that turns with the shaft, the reactions and the bending stress; with the weight where the
/// shaft is horizontal.
pub(super) fn forces<W: Worksheet>(
    problem: &WhirlingShaft,
    given: &WhirlingShaftGiven<W>,
    rotor: &Rotor<W::Num>,
    amplitude: W::Num,
    sheet: W,
) {
    let speed = || match &given.speed {
        ShaftSpeedGiven::Given { speed } => *speed,
        ShaftSpeedGiven::Multiple { ratio } => *ratio * rotor.natural,
    };
    let rigid = || rotor.mass * rotor.eccentricity * speed().powi(2);
    sheet.common_error("F", "the shaft taken as rigid, with the force m e ω²", rigid);
    if let Some(zeta) = rotor.damping_ratio {
        let damped = || {
            let damping = zeta * (speed() / rotor.natural) * 2.0;
            rotor.stiffness * amplitude * (W::Num::from(1.0) + damping.powi(2)).sqrt()
        };
        sheet.common_error("F", "the damping force at the rotor added to the force of the shaft", damped);
    }
    let force = sheet.step(
        "F",
        "N",
        rotor.stiffness * amplitude,
        ("Force of the deflected shaft, which rotates with it", RAO.at("§9.5")),
    );
    sheet.answer("shaft_force", "Total bearing force due to the shaft deflection", force);
    let weight = match &given.axis {
        ShaftAxisGiven::Vertical {} => None,
        ShaftAxisGiven::Horizontal { gravity } => {
            Some(sheet.step("P", "N", given.mass * *gravity, "Weight of the rotor"))
        }
    };
    let largest = weight.map(|weight| {
        let largest = sheet.step(
            "F_v",
            "N",
            force + weight,
            "Maximum force: once per revolution the whirl points down with the weight",
        );
        let sag = sheet.step(
            "δ",
            "mm",
            weight / rotor.stiffness,
            ("Static deflection due to the weight", RAO.at("§2.2")),
        );
        sheet.check(
            "critical speed from the static deflection, √(g/δ)",
            (weight / given.mass / sag).sqrt(),
            rotor.natural,
        );
        sheet.answer("static_deflection", "Static deflection due to the weight", sag);
        sheet.answer("largest_shaft_force", "Maximum total force on the bearings, weight included", largest);
        largest
    });
    let (RotorShaft::Round { mounting, .. }, RotorShaftGiven::Round { length, diameter, young, .. }) =
        (&problem.shaft, &given.shaft)
    else {
        return;
    };
    let total = largest.unwrap_or(force);
    if *mounting == Mounting::ClampedPinned {
        sheet.common_error("R_b", "half of the load taken at each bearing", || total / 2.0);
        sheet.common_error("R_b", "the load on the pinned bearing taken", || total * 5.0 / 16.0);
        let under = || total * *length * 5.0 / 32.0;
        sheet.common_error("M", "the bending moment at the rotor used", under);
        let pinned = || total * *length / 4.0;
        sheet.common_error("M", "the bending moment of a simply supported shaft used", pinned);
    }
    let reaction = sheet.step(
        "R_b",
        "N",
        mounting.largest_reaction(total),
        ("Load on the more heavily loaded bearing", SHIGLEY.at("table A-9")),
    );
    let moment = sheet.step(
        "M",
        "N*m",
        mounting.largest_moment(total, *length),
        ("Maximum bending moment", SHIGLEY.at("table A-9")),
    );
    let stress = sheet.step(
        "σ",
        "MPa",
        moment * 32.0 / (diameter.powi(3) * std::f64::consts::PI),
        ("Maximum bending stress, 32M/(πd³)", BEER.at("§4.4")),
    );
    sheet.verify(|| {
        let deflection = match weight {
            Some(weight) => amplitude + weight / rotor.stiffness,
            None => amplitude,
        };
        sheet.check(
            "bending stress from the deflection alone",
            *young * *diameter * deflection * mounting.stress_factor() / length.powi(2),
            stress,
        );
    });
    sheet.answer("bearing_force", "Maximum force on one bearing", reaction);
    sheet.answer("bending_stress", "Maximum bending stress", stress);
}
