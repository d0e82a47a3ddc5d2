//! Torsional springs: what brings a body back that turns about an axis, as one number `k_t`.

use dalembert_core::{Inputs, Reason, Refusal, Worksheet};
use dalembert_mechanics::{Real, beam, section, spring as kernel};

use super::{
    Spring, SpringGiven,
    element::{Build, Element, SpringMotion, symbol},
};
use crate::{
    shared::{
        continuous::{ShearModulus, ShearModulusGiven, shear_modulus},
        section::{Section, SectionGiven, ShaftSection, ShaftSectionGiven, polar_moment, second_moment},
    },
    sources::{BEER, RAO},
};

/// Torsion spring or shaft that restores a rotating body.
#[derive(Clone, Debug, Inputs)]
pub enum TorsionalSpring {
    /// Stiffness given
    Stiffness {
        /// Torsional stiffness.
        #[input("k_t", "N*m/rad", positive)]
        stiffness: f64,
    },
    /// Shaft in torsion
    /// A stepped shaft is a series combination of its segments; two shafts from one disc to two walls are in
    /// parallel.
    Shaft {
        /// Length.
        #[input("L", "m", positive)]
        length: f64,
        /// Shear modulus.
        shear: ShearModulus,
        /// Section.
        section: ShaftSection,
    },
    /// Tapered round shaft in torsion
    TaperedShaft {
        /// Length.
        #[input("L", "m", positive)]
        length: f64,
        /// Shear modulus.
        shear: ShearModulus,
        /// Diameter at one end.
        #[input("d_a", "m", positive)]
        first_diameter: f64,
        /// Diameter at the other end.
        #[input("d_b", "m", positive)]
        second_diameter: f64,
    },
    /// Helical spring twisted about its axis
    Helical {
        /// Young's modulus.
        #[input("E", "Pa", positive)]
        young: f64,
        /// Diameter of the wire.
        #[input("d", "m", positive)]
        wire_diameter: f64,
        /// Mean diameter of the coils.
        #[input("D", "m", positive)]
        coil_diameter: f64,
        /// Active coils.
        #[input("n", "1", positive)]
        coils: f64,
    },
    /// Spiral spring
    Spiral {
        /// Length of the strip.
        #[input("L", "m", positive)]
        length: f64,
        /// Young's modulus.
        #[input("E", "Pa", positive)]
        young: f64,
        /// Section.
        section: Section,
    },
    /// Cantilever, moment at its tip
    Cantilever {
        /// Length.
        #[input("L", "m", positive)]
        length: f64,
        /// Young's modulus.
        #[input("E", "Pa", positive)]
        young: f64,
        /// Section.
        section: Section,
    },
    /// Simply supported beam, moment at one end
    SimplySupported {
        /// Span.
        #[input("L", "m", positive)]
        length: f64,
        /// Young's modulus.
        #[input("E", "Pa", positive)]
        young: f64,
        /// Section.
        section: Section,
    },
    /// Beam clamped at one end, moment at its pinned end
    ClampedPinned {
        /// Span.
        #[input("L", "m", positive)]
        length: f64,
        /// Young's modulus.
        #[input("E", "Pa", positive)]
        young: f64,
        /// Section.
        section: Section,
    },
    /// Linear springs at an arm
    /// Side by side, perpendicular to the arm; small angles.
    Arm {
        /// Arm.
        #[input("r", "m", positive)]
        arm: f64,
        /// Members.
        #[input(min = 1)]
        members: Vec<Spring>,
    },
    /// Pendulum
    /// Any body that hangs from a pivot; small angles.
    Pendulum {
        /// Mass.
        #[input("m", "kg", positive)]
        mass: f64,
        /// From the pivot down to the centre of mass.
        #[input("l", "m", positive)]
        distance: f64,
        /// Gravity.
        #[input("g", "m/s^2", positive, default = "9.81 m/s^2")]
        gravity: f64,
    },
    /// Suspended on parallel wires
    /// Two, three or more wires at the same radius about the centre of mass; small angles.
    Wires {
        /// Suspended mass.
        #[input("m", "kg", positive)]
        mass: f64,
        /// From the axis to the wires.
        #[input("r", "m", positive)]
        radius: f64,
        /// Length of the wires.
        #[input("l", "m", positive)]
        length: f64,
        /// Gravity.
        #[input("g", "m/s^2", positive, default = "9.81 m/s^2")]
        gravity: f64,
    },
    /// Reflected through gears
    /// The members stand side by side on the other shaft.
    Gears {
        /// Speed of the other shaft over that of this one.
        #[input("n", "1", positive)]
        ratio: f64,
        /// Members.
        #[input(min = 1)]
        members: Vec<TorsionalSpring>,
    },
    /// Series: end to end
    /// Every member carries the whole torque.
    Series {
        /// Members.
        #[input(min = 1)]
        members: Vec<TorsionalSpring>,
    },
    /// Parallel: side by side
    /// All members have the same twist.
    Parallel {
        /// Members.
        #[input(min = 1)]
        members: Vec<TorsionalSpring>,
    },
}

/// The stiffness `k_t`, N·m/rad, of a torsional spring or of a network, with the steps that lead to it.
///
/// # Errors
/// A load outside its beam; a tube without a wall.
pub fn stiffness<W: Worksheet>(given: &TorsionalSpringGiven<W>, sheet: W) -> Result<W::Num, Refusal> {
    Ok(network(given, sheet, &[])?.stiffness)
}

/// The stiffness of a network of torsional springs and of each of its parts, with the steps that lead to them.
///
/// # Errors
/// A load outside its beam; a tube without a wall.
pub(crate) fn network<W: Worksheet>(
    given: &TorsionalSpringGiven<W>,
    sheet: W,
    place: &[usize],
) -> Result<Element<W::Num>, Refusal> {
    let build = Build { motion: SpringMotion::Rotation, place, label: label(given), sheet };
    let inside = |members: &[TorsionalSpringGiven<W>]| {
        let row = |(n, member): (usize, &TorsionalSpringGiven<W>)| {
            network(member, sheet, &[place, &[n + 1]].concat())
        };
        members.iter().enumerate().map(row).collect::<Result<Vec<_>, _>>()
    };
    match given {
        TorsionalSpringGiven::Series { members } => Ok(build.series(inside(members)?)),
        TorsionalSpringGiven::Parallel { members } => Ok(build.parallel(inside(members)?)),
        TorsionalSpringGiven::Gears { ratio, members } => {
            let members = inside(members)?;
            Ok(build.reflected_stiffness(
                *ratio,
                "Rotation of the other shaft per rotation of this one",
                members,
            ))
        }
        alone => Ok(build.alone(single(alone, sheet, place)?)),
    }
}

/// The stiffness of one element, N·m/rad.
fn single<W: Worksheet>(
    given: &TorsionalSpringGiven<W>,
    sheet: W,
    place: &[usize],
) -> Result<W::Num, Refusal> {
    let modulus = |shear: &ShearModulusGiven<W>| shear_modulus(shear, sheet, symbol("G", place));
    let moment = |section: &SectionGiven<W>| second_moment(section, sheet, symbol("I", place));
    let polar = |section: &ShaftSectionGiven<W>| polar_moment(section, sheet, symbol("I_p", place));
    let error = |what: &'static str, wrong: &dyn Fn() -> W::Num| {
        sheet.common_error(symbol("k_t", place), what, wrong);
    };
    let (k, why): (W::Num, Reason) = match given {
        TorsionalSpringGiven::Stiffness { stiffness } => return Ok(*stiffness),
        TorsionalSpringGiven::Shaft { length, shear, section } => (
            kernel::torsional(modulus(shear), polar(section)?, *length),
            ("Torsional stiffness of a shaft", RAO.at("§1.7")).into(),
        ),
        TorsionalSpringGiven::TaperedShaft { length, shear, first_diameter, second_diameter } => {
            let shear = modulus(shear);
            let ends = [*first_diameter, *second_diameter];
            let uniform = |polar: W::Num| kernel::torsional(shear, polar, *length);
            let mean = || uniform(section::round_polar_moment((ends[0] + ends[1]) / 2.0));
            error("the mean diameter used, as for a uniform shaft", &mean);
            let mean_moment = || uniform(W::Num::sum(ends.map(section::round_polar_moment)) / 2.0);
            error("the mean of the two end polar moments of area used, as for a uniform shaft", &mean_moment);
            (
                kernel::tapered_torsional(shear, *first_diameter, *second_diameter, *length),
                "Torsional stiffness of a tapered round shaft".into(),
            )
        }
        TorsionalSpringGiven::Helical { young, wire_diameter, coil_diameter, coils } => {
            let twisted = || kernel::helical_torsional(*young, *wire_diameter, *coil_diameter, *coils) * 2.0;
            error("the polar second moment of area of the wire used for its bending", &twisted);
            (
                kernel::helical_torsional(*young, *wire_diameter, *coil_diameter, *coils),
                "Twisting a helical spring about its axis bends the wire".into(),
            )
        }
        TorsionalSpringGiven::Spiral { length, young, section } => (
            kernel::spiral(*young, moment(section)?, *length),
            ("Stiffness of a spiral spring", RAO.at("§1.7")).into(),
        ),
        TorsionalSpringGiven::Cantilever { length, young, section } => {
            let second = moment(section)?;
            let force = || beam::cantilever(*young, second, *length) * length.powi(2);
            error("the stiffness against a force at the tip used, times the length squared", &force);
            let slope = || *young * second * 2.0 / *length;
            error("the rotation of the tip under a force used in place of that under a moment", &slope);
            (
                beam::cantilever_tip_rotation(*young, second, *length),
                ("A couple at the tip of a cantilever rotates the tip by M L/(E I)", BEER.at("app. D"))
                    .into(),
            )
        }
        TorsionalSpringGiven::SimplySupported { length, young, section } => {
            let second = moment(section)?;
            let clamped = || beam::clamped_pinned_end_rotation(*young, second, *length);
            error("the far end of the beam taken as clamped", &clamped);
            let far = || *young * second * 6.0 / *length;
            error("the rotation of the far end used", &far);
            (
                beam::simply_supported_end_rotation(*young, second, *length),
                (
                    "A couple at the end of a simply supported beam rotates that end by M L/(3 E I)",
                    BEER.at("app. D"),
                )
                    .into(),
            )
        }
        TorsionalSpringGiven::ClampedPinned { length, young, section } => {
            let second = moment(section)?;
            let pinned = || beam::simply_supported_end_rotation(*young, second, *length);
            error("the far end of the beam taken as pinned", &pinned);
            let free = || beam::cantilever_tip_rotation(*young, second, *length);
            error("the pinned end taken as free", &free);
            (
                beam::clamped_pinned_end_rotation(*young, second, *length),
                "A couple at the pinned end of a beam clamped at the other end rotates the pinned end by M L/(4 E I)".into(),
            )
        }
        TorsionalSpringGiven::Arm { arm, members } => {
            let springs = |(n, member): (usize, &SpringGiven<W>)| {
                super::network(member, sheet, &[place, &[n + 1]].concat()).map(|element| element.stiffness)
            };
            let springs = members.iter().enumerate().map(springs).collect::<Result<Vec<_>, _>>()?;
            if springs.len() > 1 {
                let chained = || arm.powi(2) * kernel::series(springs.iter().copied());
                error("the springs combined as if in series", &chained);
            }
            (
                arm.powi(2) * kernel::parallel(springs),
                ("A rotation θ deflects the springs by r θ, and their force has the arm r", RAO.at("§1.7"))
                    .into(),
            )
        }
        TorsionalSpringGiven::Pendulum { mass, distance, gravity } => (
            kernel::pendulum_torsional(*mass, *gravity, *distance),
            "The weight exerts the restoring moment of a pendulum".into(),
        ),
        TorsionalSpringGiven::Wires { mass, radius, length, gravity } => {
            let hung = || kernel::pendulum_torsional(*mass, *gravity, *length);
            error("the body taken as a pendulum of the length of the wires", &hung);
            (
                kernel::bifilar_stiffness(*mass, *gravity, *radius, *length),
                "The wires lean by r θ/l and their tension, in total the weight, restores the body".into(),
            )
        }
        TorsionalSpringGiven::Gears { .. }
        | TorsionalSpringGiven::Series { .. }
        | TorsionalSpringGiven::Parallel { .. } => {
            return network(given, sheet, place).map(|element| element.stiffness);
        }
    };
    Ok(sheet.step(symbol("k_t", place), "N*m/rad", k, why))
}

/// Name of the type of an element.
fn label<W: Worksheet>(given: &TorsionalSpringGiven<W>) -> &'static str {
    match given {
        TorsionalSpringGiven::Stiffness { .. } => "torsional spring",
        TorsionalSpringGiven::Shaft { .. } => "shaft",
        TorsionalSpringGiven::TaperedShaft { .. } => "tapered shaft",
        TorsionalSpringGiven::Helical { .. } => "helical spring",
        TorsionalSpringGiven::Spiral { .. } => "spiral spring",
        TorsionalSpringGiven::Cantilever { .. } => "cantilever",
        TorsionalSpringGiven::SimplySupported { .. } => "simply supported beam",
        TorsionalSpringGiven::ClampedPinned { .. } => "clamped and pinned beam",
        TorsionalSpringGiven::Arm { .. } => "springs on an arm",
        TorsionalSpringGiven::Pendulum { .. } => "pendulum",
        TorsionalSpringGiven::Wires { .. } => "wire suspension",
        TorsionalSpringGiven::Gears { .. } => "through gears",
        TorsionalSpringGiven::Series { .. } => "in series",
        TorsionalSpringGiven::Parallel { .. } => "in parallel",
    }
}
