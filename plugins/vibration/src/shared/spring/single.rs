//! The stiffness of single springs.

use dalembert_core::{Reason, Refusal, Worksheet};
use dalembert_mechanics::{Real, beam, sdof, section, spring};

use super::{SpringGiven, symbol};
use crate::{
    shared::{
        continuous::{ShearModulusGiven, shear_modulus},
        section::{SectionGiven, area, polar_moment, second_moment},
    },
    sources::{BEER, RAO, SHIGLEY},
};

/// The stiffness of one element, N/m, with the steps that lead to it.
#[inline]
pub(super) fn stiffness<W: Worksheet>(
    given: &SpringGiven<W>,
    sheet: W,
    place: &[usize],
) -> Result<W::Num, Refusal> {
    let written = |k: W::Num, why: Reason| sheet.step(symbol("k", place), "kN/m", k, why);
    let modulus = |shear: &ShearModulusGiven<W>| shear_modulus(shear, sheet, symbol("G", place));
    let moment = |section: &SectionGiven<W>| second_moment(section, sheet, symbol("I", place));
    let error = |what: &'static str, wrong: &dyn Fn() -> W::Num| {
        sheet.common_error(symbol("k", place), what, wrong);
    };
    let (k, why) = match given {
        SpringGiven::Stiffness { stiffness } => return Ok(*stiffness),
        SpringGiven::Equal { count, stiffness } => {
            error("the springs combined as if in series", &|| *stiffness / *count);
            (*stiffness * *count, ("Equal springs side by side: their stiffnesses add up", RAO.at("§1.7")))
        }
        SpringGiven::Cantilever { length, young, section } => {
            let second = moment(section)?;
            let spread = || *young * second * 8.0 / length.powi(3);
            error("the deflection under a uniformly distributed load used", &spread);
            (
                beam::cantilever(*young, second, *length),
                ("Stiffness of a cantilever under a force at its end", RAO.at("§1.7")),
            )
        }
        SpringGiven::SimplySupported { length, distance, young, section } => match distance {
            None => {
                let second = moment(section)?;
                let spread = || *young * second * 384.0 / (length.powi(3) * 5.0);
                error("the deflection under a uniformly distributed load used", &spread);
                (
                    beam::simply_supported_middle(*young, second, *length),
                    ("Midspan stiffness of a simply supported beam", RAO.at("§1.7")),
                )
            }
            Some(distance) => {
                within(distance, length)?;
                let second = moment(section)?;
                let middle = || beam::simply_supported_middle(*young, second, *length);
                error("the midspan formula used for a load that is elsewhere", &middle);
                (
                    beam::simply_supported(*young, second, *length, *distance),
                    ("Stiffness of a simply supported beam at the load", BEER.at("app. D")),
                )
            }
        },
        SpringGiven::Clamped { length, distance, young, section } => match distance {
            None => {
                let second = moment(section)?;
                let spread = || *young * second * 384.0 / length.powi(3);
                error("the deflection under a uniformly distributed load used", &spread);
                (
                    beam::clamped_clamped_middle(*young, second, *length),
                    ("Midspan stiffness of a beam clamped at both ends", RAO.at("§1.7")),
                )
            }
            Some(distance) => {
                within(distance, length)?;
                let second = moment(section)?;
                let middle = || beam::clamped_clamped_middle(*young, second, *length);
                error("the midspan formula used for a load that is elsewhere", &middle);
                (
                    beam::clamped_clamped(*young, second, *length, *distance),
                    ("Stiffness at the load of a beam clamped at both ends", SHIGLEY.at("table A-9")),
                )
            }
        },
        SpringGiven::ClampedPinned { length, distance, young, section } => match distance {
            None => (
                beam::clamped_pinned_middle(*young, moment(section)?, *length),
                (
                    "Midspan stiffness of a beam clamped at one end and pinned at the other",
                    SHIGLEY.at("table A-9"),
                ),
            ),
            Some(distance) => {
                within(distance, length)?;
                let second = moment(section)?;
                let middle = || beam::clamped_pinned_middle(*young, second, *length);
                error("the midspan formula used for a load that is elsewhere", &middle);
                (
                    beam::clamped_pinned(*young, second, *length, *distance),
                    (
                        "Stiffness at the load of a beam clamped at one end and pinned at the other",
                        SHIGLEY.at("table A-9"),
                    ),
                )
            }
        },
        SpringGiven::Overhang { length, overhang, young, section } => {
            let second = moment(section)?;
            let clamped = || beam::cantilever(*young, second, *overhang);
            error("the overhang taken as a cantilever clamped at its support", &clamped);
            let whole = || beam::cantilever(*young, second, *length + *overhang);
            error("the whole beam taken as a cantilever", &whole);
            (
                beam::overhang(*young, second, *length, *overhang),
                ("Stiffness of a beam at the end of its overhang", SHIGLEY.at("table A-9")),
            )
        }
        SpringGiven::Column { length, young, section } => (
            beam::clamped_guided(*young, moment(section)?, *length),
            ("Stiffness of a fixed–guided column", RAO.at("§1.7")),
        ),
        SpringGiven::Bar { length, young, section } => {
            let area = area(section, sheet, symbol("A", place))?;
            (spring::axial(*young, area, *length), ("Axial stiffness of a bar", RAO.at("§1.7")))
        }
        SpringGiven::TaperedBar { length, young, first_diameter, second_diameter } => {
            let uniform = |diameter: W::Num| spring::axial(*young, section::round_area(diameter), *length);
            let mean = || uniform((*first_diameter + *second_diameter) / 2.0);
            error("the mean diameter used, as for a uniform bar", &mean);
            let mean_area = || (uniform(*first_diameter) + uniform(*second_diameter)) / 2.0;
            error("the mean of the two end areas used, as for a uniform bar", &mean_area);
            let k = spring::tapered_axial(*young, *first_diameter, *second_diameter, *length);
            return Ok(written(k, "Axial stiffness of a tapered round bar".into()));
        }
        SpringGiven::TorsionBar { length, shear, section, lever } => {
            let polar = polar_moment(section, sheet, symbol("I_p", place))?;
            let torsional = sheet.step(
                symbol("k_t", place),
                "N*m/rad",
                spring::torsional(modulus(shear), polar, *length),
                ("Torsional stiffness of the bar", RAO.at("§1.7")),
            );
            (torsional / lever.powi(2), ("Stiffness at the end of the lever", RAO.at("§1.7")))
        }
        SpringGiven::Helical { shear, wire_diameter, coil_diameter, coils } => {
            let shear = modulus(shear);
            let radius = || spring::helical(shear, *wire_diameter, *coil_diameter * 2.0, *coils);
            error("the formula in terms of the coil radius used with the diameter", &radius);
            let inner = || *coil_diameter - *wire_diameter;
            let outer = || spring::helical(shear, *wire_diameter, inner(), *coils);
            error("the mean diameter of the coils taken as the outer one", &outer);
            (
                spring::helical(shear, *wire_diameter, *coil_diameter, *coils),
                ("Stiffness of a helical spring", RAO.at("§1.7")),
            )
        }
        SpringGiven::Deflected { load, deflection } => {
            (*load / *deflection, ("Stiffness: load over deflection", RAO.at("§1.7")))
        }
        SpringGiven::Tuned { mass, frequency } => (
            sdof::stiffness_from_natural_frequency(*mass, *frequency),
            ("Stiffness that gives this mass this natural frequency", RAO.at("§2.2")),
        ),
        SpringGiven::Leaf { young, leaves, breadth, thickness, span } => {
            let second = |depth: W::Num| section::rectangle_second_moment(*breadth, depth);
            let supported = |second: W::Num| beam::simply_supported_middle(*young, second, *span);
            let uniform = || supported(second(*thickness) * *leaves);
            error("the leaves taken as uniform beams, all of the whole span", &uniform);
            let solid = || supported(second(*thickness * *leaves));
            error("the leaves taken as one solid beam of their whole thickness", &solid);
            let k = spring::leaf(*young, *leaves, *breadth, *thickness, *span);
            return Ok(written(k, "Stiffness of a semi-elliptic leaf spring of uniform strength".into()));
        }
        SpringGiven::ShearPad { shear, area, thickness } => {
            let k = spring::shear_pad(modulus(shear), *area, *thickness);
            return Ok(written(k, "Stiffness of a pad in shear".into()));
        }
        SpringGiven::Gas { exponent, pressure, area, volume } => {
            let k = spring::gas(*exponent, *pressure, *area, *volume);
            return Ok(written(k, "Stiffness of a gas behind a piston".into()));
        }
        SpringGiven::TautString { tension, left, right } => {
            let series = || *tension / (*left + *right);
            error("the tension divided by the whole length", &series);
            let middle = || *tension * 4.0 / (*left + *right);
            error("the midspan formula used for a load that is elsewhere", &middle);
            let k = spring::taut_string(*tension, *left, *right);
            return Ok(written(k, "Stiffness of a taut string at the load".into()));
        }
        SpringGiven::Pendulum { mass, length, gravity } => {
            let k = spring::pendulum(*mass, *gravity, *length);
            return Ok(written(k, "The weight is the restoring force of a pendulum".into()));
        }
        SpringGiven::Buoyancy { density, area, gravity } => {
            let k = spring::buoyancy(*density, *gravity, *area);
            return Ok(written(k, "Buoyancy is the restoring force of a floating body".into()));
        }
        SpringGiven::UTube { density, area, gravity } => {
            let one_side = || spring::buoyancy(*density, *gravity, *area);
            error("the level taken to change on one side only", &one_side);
            let k = spring::u_tube(*density, *gravity, *area);
            return Ok(written(k, "The weight of the higher column restores the liquid level".into()));
        }
        SpringGiven::Series { .. }
        | SpringGiven::Parallel { .. }
        | SpringGiven::Lever { .. }
        | SpringGiven::Inclined { .. } => {
            return super::network(given, sheet, place).map(|element| element.stiffness);
        }
    };
    Ok(written(k, why.into()))
}

fn within<N: Real>(distance: &N, length: &N) -> Result<(), Refusal> {
    if distance.value() < length.value() {
        return Ok(());
    }
    Err(Refusal::because(
        "the load acts at or beyond the far support of its beam: write a distance smaller than the span",
    ))
}
