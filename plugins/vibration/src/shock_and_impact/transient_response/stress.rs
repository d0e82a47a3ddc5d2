//! The bending stress of the beam that carries the mass, at its largest displacement.

use dalembert_core::{Refusal, Symbol, Worksheet};
use dalembert_mechanics::Real;

use crate::{
    shared::{
        oscillator::{ElasticityGiven, SpringDataGiven, parts::BodySpringsGiven},
        section::second_moment,
        spring::SpringGiven,
    },
    sources::BEER,
};

/// Writes the force, the bending moment and the stress.
///
/// # Errors
/// A spring whose bending moment is not known here.
pub(super) fn stress<W: Worksheet>(
    elasticity: &BodySpringsGiven<W>,
    fibre: W::Num,
    stiffness: W::Num,
    largest: W::Num,
    sheet: W,
) -> Result<(), Refusal> {
    let BodySpringsGiven::Any(ElasticityGiven::Springs(SpringDataGiven::Springs { springs: given })) =
        elasticity
    else {
        return Err(unknown());
    };
    let why = "Equivalent static force for the same deflection of the beam";
    let force = sheet.step("Fₘ", "kN", stiffness * largest, why);
    let (moment, section, curvature, why) = match given {
        SpringGiven::Cantilever { length, section, young } => {
            let curvature = largest * 3.0 / length.powi(2) * *young;
            (force * *length, section, curvature, "Bending moment at the clamp")
        }
        SpringGiven::SimplySupported { length, distance: None, section, young } => {
            let curvature = largest * 12.0 / length.powi(2) * *young;
            let why = "Bending moment at midspan, under the mass";
            (force * *length / 4.0, section, curvature, why)
        }
        SpringGiven::SimplySupported { length, distance: Some(distance), section, young } => {
            let curvature = largest * 3.0 / (*distance * (*length - *distance)) * *young;
            let moment = force * *distance * (*length - *distance) / *length;
            (moment, section, curvature, "Bending moment under the mass")
        }
        SpringGiven::Clamped { length, distance: None, section, young } => {
            let curvature = largest * 24.0 / length.powi(2) * *young;
            let why = "Bending moment at midspan and at the clamps";
            (force * *length / 8.0, section, curvature, why)
        }
        _ => return Err(unknown()),
    };
    match given {
        SpringGiven::SimplySupported { length, distance: Some(_), .. } => {
            sheet.common_error("M_b", "the moment of a load at midspan used", || force * *length / 4.0);
        }
        SpringGiven::Clamped { length, .. } => {
            sheet.common_error("M_b", "the moment of a simply supported beam used", || force * *length / 4.0);
        }
        _ => {}
    }
    let moment = sheet.step("M_b", "kN*m", moment, (why, BEER.at("app. D")));
    let second_moment = second_moment(section, sheet, Symbol::from("I_b"))?;
    let why = ("Bending stress at the extreme fibre", BEER.at("§4.4"));
    let stress = sheet.step("σ", "MPa", moment.abs() * fibre / second_moment, why);
    sheet.answer("stress", "Maximum bending stress", stress);
    sheet.check("bending stress by the curvature of the bent beam, E c w″", curvature.abs() * fibre, stress);
    Ok(())
}

fn unknown() -> Refusal {
    Refusal::because(
        "the bending stress is available for a cantilever, a simply supported beam and a clamped beam with the mass at its middle: omit the distance of the extreme fibre for other springs",
    )
}
