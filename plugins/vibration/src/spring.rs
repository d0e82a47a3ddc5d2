//! Springs: elastic elements and networks of them, as one number `k`.

use dalembert_core::{Inputs, Refusal, Symbol, Worksheet};
use dalembert_mechanics::{Real, beam, sdof, section as area, spring};

pub(crate) mod shares;
pub(crate) mod sketch;

use crate::{
    section::{Section, SectionGiven, second_moment},
    sources::{BEER, RAO, SHIGLEY},
};

/// What carries the load elastically.
#[derive(Clone, Debug, Inputs)]
pub enum Spring {
    /// Stiffness given
    Stiffness {
        /// Stiffness.
        #[input("k", "N/m", positive)]
        stiffness: f64,
    },
    /// Cantilever
    Cantilever {
        /// Length.
        /// From the clamp to the load; what lies beyond the load bends nothing.
        #[input("L", "m", positive)]
        length: f64,
        /// Young's modulus.
        #[input("E", "Pa", positive)]
        young: f64,
        /// Section.
        section: Section,
    },
    /// Simply supported beam
    SimplySupported {
        /// Span.
        #[input("L", "m", positive)]
        length: f64,
        /// Distance of the load from a support.
        /// The load is at the middle where this is left out.
        #[input("a", "m", positive)]
        distance: Option<f64>,
        /// Young's modulus.
        #[input("E", "Pa", positive)]
        young: f64,
        /// Section.
        section: Section,
    },
    /// Beam clamped at both ends
    Clamped {
        /// Span.
        #[input("L", "m", positive)]
        length: f64,
        /// Distance of the load from a clamp.
        /// The load is at the middle where this is left out.
        #[input("a", "m", positive)]
        distance: Option<f64>,
        /// Young's modulus.
        #[input("E", "Pa", positive)]
        young: f64,
        /// Section.
        section: Section,
    },
    /// Beam clamped at one end and pinned at the other
    ClampedPinned {
        /// Span.
        #[input("L", "m", positive)]
        length: f64,
        /// Distance of the load from the clamp.
        /// The load is at the middle where this is left out.
        #[input("a", "m", positive)]
        distance: Option<f64>,
        /// Young's modulus.
        #[input("E", "Pa", positive)]
        young: f64,
        /// Section.
        section: Section,
    },
    /// Overhang of a simply supported beam
    Overhang {
        /// Span between the supports.
        #[input("L", "m", positive)]
        length: f64,
        /// Overhang.
        /// From the nearer support to the load.
        #[input("a", "m", positive)]
        overhang: f64,
        /// Young's modulus.
        #[input("E", "Pa", positive)]
        young: f64,
        /// Section.
        section: Section,
    },
    /// Column whose end moves sideways without turning
    Column {
        /// Height.
        #[input("L", "m", positive)]
        length: f64,
        /// Young's modulus.
        #[input("E", "Pa", positive)]
        young: f64,
        /// Section.
        section: Section,
    },
    /// Bar pulled along its axis
    Bar {
        /// Length.
        #[input("L", "m", positive)]
        length: f64,
        /// Young's modulus.
        #[input("E", "Pa", positive)]
        young: f64,
        /// Area of the section.
        #[input("A", "m^2", positive)]
        area: f64,
    },
    /// Round torsion bar with a lever
    TorsionBar {
        /// Length.
        #[input("L", "m", positive)]
        length: f64,
        /// Shear modulus.
        #[input("G", "Pa", positive)]
        shear: f64,
        /// Diameter.
        #[input("d", "m", positive)]
        diameter: f64,
        /// Lever.
        /// From the axis of the bar to the load; small angles.
        #[input("a", "m", positive)]
        lever: f64,
    },
    /// Helical spring
    Helical {
        /// Shear modulus.
        #[input("G", "Pa", positive)]
        shear: f64,
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
    /// Known by its deflection under a load
    Deflected {
        /// Load.
        #[input("F₁", "N", positive)]
        load: f64,
        /// Deflection.
        #[input("δ₁", "m", positive)]
        deflection: f64,
    },
    /// Known by the natural frequency of a mass on it
    Tuned {
        /// Mass on the spring.
        #[input("m₁", "kg", positive)]
        mass: f64,
        /// Natural frequency.
        #[input("ω₁", "rad/s", positive)]
        frequency: f64,
    },
    /// Series: end to end
    /// Every member carries the whole force.
    Series {
        /// Members.
        #[input(min = 1)]
        members: Vec<Spring>,
    },
    /// Parallel: side by side
    /// Every member is deflected alike.
    Parallel {
        /// Members.
        #[input(min = 1)]
        members: Vec<Spring>,
    },
}

/// The stiffness `k` of a spring, N/m, with the steps that lead to it.
///
/// # Errors
/// A load outside its beam; a tube without a wall.
#[inline]
pub fn stiffness<W: Worksheet>(given: &SpringGiven<W>, sheet: W) -> Result<W::Num, Refusal> {
    single(given, sheet, &[])
}

/// A spring or a part of a network, with its stiffness.
pub(crate) struct Element<N> {
    /// Its rows in the network, counted from 1: the place of `k₁,₂` is `[1, 2]`.
    pub(crate) place: Vec<usize>,
    /// What it is.
    pub(crate) label: &'static str,
    /// Its stiffness.
    pub(crate) stiffness: N,
    /// How its members hang together.
    pub(crate) joined: Joined<N>,
}

/// How the members of an element hang together.
pub(crate) enum Joined<N> {
    /// It has none.
    Alone,
    /// End to end.
    Series(Vec<Element<N>>),
    /// Side by side.
    Parallel(Vec<Element<N>>),
}

/// The stiffness of a network and of each of its parts, with the steps that lead to them.
///
/// # Errors
/// Those of [`stiffness`].
pub(crate) fn network<W: Worksheet>(
    given: &SpringGiven<W>,
    sheet: W,
    place: &[usize],
) -> Result<Element<W::Num>, Refusal> {
    let inside = |members: &[SpringGiven<W>]| {
        let row = |(n, member): (usize, &SpringGiven<W>)| network(member, sheet, &[place, &[n + 1]].concat());
        members.iter().enumerate().map(row).collect::<Result<Vec<_>, _>>()
    };
    let (stiffness, joined) = match given {
        SpringGiven::Series { members } => {
            let members = inside(members)?;
            let k = spring::series(members.iter().map(|member| member.stiffness));
            let why = ("Springs in series: the deflections add up", RAO.at("§1.7"));
            (sheet.step(symbol("k", place), "kN/m", k, why), Joined::Series(members))
        }
        SpringGiven::Parallel { members } => {
            let members = inside(members)?;
            let k = spring::parallel(members.iter().map(|member| member.stiffness));
            let why = ("Springs in parallel: the forces add up", RAO.at("§1.7"));
            (sheet.step(symbol("k", place), "kN/m", k, why), Joined::Parallel(members))
        }
        element => (single(element, sheet, place)?, Joined::Alone),
    };
    Ok(Element { place: place.to_vec(), label: label(given), stiffness, joined })
}

/// A symbol with the rows of a place.
pub(crate) fn symbol(base: &'static str, place: &[usize]) -> Symbol {
    place.iter().fold(Symbol::from(base), |symbol, row| symbol.row(*row))
}

/// The stiffness alone.
#[inline]
fn single<W: Worksheet>(given: &SpringGiven<W>, sheet: W, place: &[usize]) -> Result<W::Num, Refusal> {
    let moment = |section: &SectionGiven<W>| second_moment(section, sheet, symbol("I", place));
    let (k, why) = match given {
        SpringGiven::Stiffness { stiffness } => return Ok(*stiffness),
        SpringGiven::Cantilever { length, young, section } => (
            beam::cantilever(*young, moment(section)?, *length),
            ("Stiffness of a cantilever under a force at its end", RAO.at("§1.7")),
        ),
        SpringGiven::SimplySupported { length, distance, young, section } => match distance {
            None => (
                beam::simply_supported_middle(*young, moment(section)?, *length),
                ("Stiffness of a simply supported beam at its middle", RAO.at("§1.7")),
            ),
            Some(distance) => {
                within(distance, length)?;
                (
                    beam::simply_supported(*young, moment(section)?, *length, *distance),
                    ("Stiffness of a simply supported beam at the load", BEER.at("app. D")),
                )
            }
        },
        SpringGiven::Clamped { length, distance, young, section } => match distance {
            None => (
                beam::clamped_clamped_middle(*young, moment(section)?, *length),
                ("Stiffness at its middle of a beam clamped at both ends", RAO.at("§1.7")),
            ),
            Some(distance) => {
                within(distance, length)?;
                (
                    beam::clamped_clamped(*young, moment(section)?, *length, *distance),
                    ("Stiffness at the load of a beam clamped at both ends", SHIGLEY.at("table A-9")),
                )
            }
        },
        SpringGiven::ClampedPinned { length, distance, young, section } => match distance {
            None => (
                beam::clamped_pinned_middle(*young, moment(section)?, *length),
                (
                    "Stiffness at its middle of a beam clamped at one end and pinned at the other",
                    SHIGLEY.at("table A-9"),
                ),
            ),
            Some(distance) => {
                within(distance, length)?;
                (
                    beam::clamped_pinned(*young, moment(section)?, *length, *distance),
                    (
                        "Stiffness at the load of a beam clamped at one end and pinned at the other",
                        SHIGLEY.at("table A-9"),
                    ),
                )
            }
        },
        SpringGiven::Overhang { length, overhang, young, section } => (
            beam::overhang(*young, moment(section)?, *length, *overhang),
            ("Stiffness of a beam at the end of its overhang", SHIGLEY.at("table A-9")),
        ),
        SpringGiven::Column { length, young, section } => (
            beam::clamped_guided(*young, moment(section)?, *length),
            ("Stiffness of a column whose end moves sideways without turning", RAO.at("§1.7")),
        ),
        SpringGiven::Bar { length, young, area } => {
            (spring::axial(*young, *area, *length), ("Stiffness of a bar along its axis", RAO.at("§1.7")))
        }
        SpringGiven::TorsionBar { length, shear, diameter, lever } => {
            let polar = sheet.step(
                symbol("J", place),
                "cm^4",
                area::round_polar_moment(*diameter),
                ("Polar second moment of area of a round section", BEER.at("app. A")),
            );
            let torsional = sheet.step(
                symbol("k_t", place),
                "N*m/rad",
                spring::torsional(*shear, polar, *length),
                ("Torsional stiffness of the bar", RAO.at("§1.7")),
            );
            (torsional / lever.powi(2), ("Stiffness at the end of the lever", RAO.at("§1.7")))
        }
        SpringGiven::Helical { shear, wire_diameter, coil_diameter, coils } => (
            spring::helical(*shear, *wire_diameter, *coil_diameter, *coils),
            ("Stiffness of a helical spring", RAO.at("§1.7")),
        ),
        SpringGiven::Deflected { load, deflection } => {
            (*load / *deflection, ("Stiffness: load over deflection", RAO.at("§1.7")))
        }
        SpringGiven::Tuned { mass, frequency } => (
            sdof::stiffness_from_natural_frequency(*mass, *frequency),
            ("Stiffness that gives this mass this natural frequency", RAO.at("§2.2")),
        ),
        SpringGiven::Series { .. } | SpringGiven::Parallel { .. } => {
            return network(given, sheet, place).map(|element| element.stiffness);
        }
    };
    Ok(sheet.step(symbol("k", place), "kN/m", k, why))
}

fn within<N: Real>(distance: &N, length: &N) -> Result<(), Refusal> {
    if distance.value() < length.value() {
        return Ok(());
    }
    Err(Refusal::because(
        "the load stands at or beyond the far support of its beam: write a distance below the span",
    ))
}

/// What an element is, in a word.
fn label<W: Worksheet>(given: &SpringGiven<W>) -> &'static str {
    match given {
        SpringGiven::Cantilever { .. } => "cantilever",
        SpringGiven::SimplySupported { .. } => "simply supported beam",
        SpringGiven::Clamped { .. } => "clamped beam",
        SpringGiven::ClampedPinned { .. } => "clamped and pinned beam",
        SpringGiven::Overhang { .. } => "overhang",
        SpringGiven::Column { .. } => "column",
        SpringGiven::Bar { .. } => "bar",
        SpringGiven::TorsionBar { .. } => "torsion bar",
        SpringGiven::Helical { .. } => "helical spring",
        SpringGiven::Stiffness { .. } | SpringGiven::Deflected { .. } | SpringGiven::Tuned { .. } => "spring",
        SpringGiven::Series { .. } => "in series",
        SpringGiven::Parallel { .. } => "in parallel",
    }
}

#[cfg(test)]
mod tests {
    use dalembert_core::{Inputs, Lift, Plain, Stop, Trail};

    use super::*;

    fn stiffness_of(spring: &Spring) -> Result<f64, Refusal> {
        let stop = Stop::new();
        let plain = Plain::new(&stop);
        let given = spring.given(Lift { sheet: &plain, value: None, trail: &Trail::TOP });
        stiffness(&given, &plain)
    }

    fn close(ours: f64, expected: f64) {
        assert!((ours - expected).abs() <= 1e-12 * expected.abs(), "{ours} is not {expected}");
    }

    fn given(stiffness: f64) -> Spring {
        Spring::Stiffness { stiffness }
    }

    fn section() -> Section {
        Section::Rectangle { breadth: 0.04, height: 0.01 }
    }

    /// The three beams whose load may stand anywhere.
    fn beams(distance: Option<f64>) -> [Spring; 3] {
        let (length, young) = (1.2, 210e9);
        [
            Spring::SimplySupported { length, distance, young, section: section() },
            Spring::Clamped { length, distance, young, section: section() },
            Spring::ClampedPinned { length, distance, young, section: section() },
        ]
    }

    #[test]
    fn a_network_is_its_series_and_parallels() {
        let parallel = Spring::Parallel { members: vec![given(1.0), given(2.0)] };
        let network = Spring::Series { members: vec![parallel, given(6.0), given(2.0)] };
        close(stiffness_of(&network).unwrap(), 1.0);
        let one = Spring::Series { members: vec![Spring::Parallel { members: vec![given(7.0)] }] };
        close(stiffness_of(&one).unwrap(), 7.0);
    }

    #[test]
    fn a_load_without_a_distance_is_at_the_middle() {
        for (middle, placed) in beams(None).iter().zip(&beams(Some(0.6))) {
            close(stiffness_of(middle).unwrap(), stiffness_of(placed).unwrap());
        }
    }

    #[test]
    fn beams_by_their_tables() {
        // E I = 700 N m²; 48, 192 and 768/7 times E I/L³.
        let [simple, clamped, mixed] = beams(None).map(|beam| stiffness_of(&beam).unwrap());
        close(simple, 48.0 * 700.0 / 1.728);
        close(clamped, 4.0 * simple);
        close(mixed, 16.0 / 7.0 * simple);
    }

    #[test]
    fn a_load_at_the_far_support_is_refused() {
        for beam in beams(Some(1.2)) {
            let refusal = stiffness_of(&beam).unwrap_err().to_string();
            assert!(refusal.contains("write a distance below the span"), "{refusal}");
        }
    }

    #[test]
    fn a_tube_needs_a_wall() {
        let tube = |inner| Spring::Cantilever {
            length: 1.0,
            young: 1.0,
            section: Section::Tube { outer: 0.1, inner },
        };
        assert!(stiffness_of(&tube(0.1)).unwrap_err().to_string().contains("outer"));
        // I = π(D⁴ − d⁴)/64: half the diameter inside takes a sixteenth away.
        let solid = Spring::Cantilever { length: 1.0, young: 1.0, section: Section::Round { diameter: 0.1 } };
        close(stiffness_of(&tube(0.05)).unwrap(), stiffness_of(&solid).unwrap() * 15.0 / 16.0);
    }

    #[test]
    fn a_torsion_bar_is_a_helical_spring_unwound() {
        // A wire of n turns is a torsion bar of length π D n on a lever D/2: k = G d⁴/(8 D³ n).
        let (shear, wire_diameter, coil_diameter, coils) = (80e9, 0.02, 0.2, 5.0);
        let helical = Spring::Helical { shear, wire_diameter, coil_diameter, coils };
        let bar = Spring::TorsionBar {
            length: std::f64::consts::PI * coil_diameter * coils,
            shear,
            diameter: wire_diameter,
            lever: coil_diameter / 2.0,
        };
        close(stiffness_of(&helical).unwrap(), 40e3);
        close(stiffness_of(&bar).unwrap(), 40e3);
    }
}
