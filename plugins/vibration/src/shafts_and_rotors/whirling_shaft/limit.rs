//! The speeds that keep the whirl within a limit.

use dalembert_core::{Refusal, Worksheet};
use dalembert_mechanics::Real;

use super::{Rotor, ShaftAxisGiven, WhirlLimitGiven, WhirlingShaft, WhirlingShaftGiven};
use crate::{
    shared::jeffcott::{RotorShaft, RotorShaftGiven, Whirl, permitted_speeds},
    sources::{BEER, RAO},
};

/// Limit as plotted.
pub(super) struct Limited {
    /// The amplitude at the limit, m.
    pub(super) amplitude: f64,
    /// The permitted speeds, rad/s.
    pub(super) permitted: Vec<(f64, f64)>,
}

/// Answers the permitted speeds.
pub(super) fn speeds<W: Worksheet>(
    problem: &WhirlingShaft,
    given: &WhirlingShaftGiven<W>,
    limit: &WhirlLimitGiven<W>,
    rotor: &Rotor<W::Num>,
    sheet: W,
) -> Result<Limited, Refusal> {
    let amplitude = permitted_amplitude(problem, given, limit, rotor, sheet)?;
    sheet.answer("permitted_amplitude", "Permitted whirl amplitude", amplitude);
    let whirl = Whirl {
        natural: rotor.natural,
        eccentricity: rotor.eccentricity,
        damping_ratio: rotor.damping_ratio,
    };
    let permitted = permitted_speeds(&whirl, amplitude, sheet)?;
    Ok(Limited { amplitude: amplitude.value(), permitted })
}

/// The whirl amplitude that a limit leaves.
fn permitted_amplitude<W: Worksheet>(
    problem: &WhirlingShaft,
    given: &WhirlingShaftGiven<W>,
    limit: &WhirlLimitGiven<W>,
    rotor: &Rotor<W::Num>,
    sheet: W,
) -> Result<W::Num, Refusal> {
    match limit {
        WhirlLimitGiven::Amplitude { amplitude } => {
            Ok(sheet.step("A_R", "mm", *amplitude, "Permitted whirl amplitude"))
        }
        WhirlLimitGiven::Force { force } => Ok(sheet.step(
            "A_R",
            "mm",
            *force / rotor.stiffness,
            ("Permitted whirl amplitude: the force of the bent shaft is k A", RAO.at("§9.5")),
        )),
        WhirlLimitGiven::Stress { stress } => {
            let (RotorShaft::Round { mounting, .. }, RotorShaftGiven::Round { length, diameter, young, .. }) =
                (&problem.shaft, &given.shaft)
            else {
                return Err(Refusal::because(
                    "a stress limit needs the dimensions of the shaft: describe the shaft, or give a limit of amplitude or force",
                ));
            };
            let moment = sheet.step(
                "M_R",
                "N*m",
                *stress * diameter.powi(3) * std::f64::consts::PI / 32.0,
                ("Bending moment at the permitted stress", BEER.at("§4.4")),
            );
            let force = sheet.step(
                "F_R",
                "N",
                moment / mounting.largest_moment(W::Num::from(1.0), *length),
                "Force on the rotor that produces this moment",
            );
            sheet.check(
                "stress from the deflection under that force",
                *young * *diameter * (force / rotor.stiffness) * mounting.stress_factor() / length.powi(2),
                *stress,
            );
            let whirl = match &given.axis {
                ShaftAxisGiven::Vertical {} => force,
                ShaftAxisGiven::Horizontal { gravity } => {
                    let weight = given.mass * *gravity;
                    if weight.value() >= force.value() {
                        return Err(Refusal::because(
                            "the weight of the rotor alone bends the shaft beyond the permitted stress: give a higher stress, a thicker shaft or a lighter rotor",
                        ));
                    }
                    sheet.step("F_A", "N", force - weight, "Part available for the whirl, after the weight")
                }
            };
            Ok(sheet.step("A_R", "mm", whirl / rotor.stiffness, "Permitted whirl amplitude"))
        }
    }
}
