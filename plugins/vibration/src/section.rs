//! Cross-sections of beams: what bending stiffness needs of them.

use dalembert_core::{Inputs, Refusal, Symbol, Worksheet};
use dalembert_mechanics::{Real, section};

use crate::sources::BEER;

/// The cross-section of a beam.
#[derive(Clone, Debug, Inputs)]
pub enum Section {
    /// Second moment of area given
    Given {
        /// Second moment of area.
        #[input("I", "m^4", positive)]
        second_moment: f64,
    },
    /// Round
    Round {
        /// Diameter.
        #[input("d", "m", positive)]
        diameter: f64,
    },
    /// Tube
    Tube {
        /// Outer diameter.
        #[input("D", "m", positive)]
        outer: f64,
        /// Inner diameter.
        #[input("d", "m", positive)]
        inner: f64,
    },
    /// Rectangle
    Rectangle {
        /// Breadth.
        /// Across the plane of bending.
        #[input("b", "m", positive)]
        breadth: f64,
        /// Height.
        /// In the plane of bending.
        #[input("h", "m", positive)]
        height: f64,
    },
}

/// The second moment of area of a section, m⁴, written as the step `symbol` where it is not given.
///
/// # Errors
/// A tube whose inner diameter is not below the outer one.
#[inline]
pub fn second_moment<W: Worksheet>(
    given: &SectionGiven<W>,
    sheet: W,
    symbol: Symbol,
) -> Result<W::Num, Refusal> {
    let (second_moment, why) = match given {
        SectionGiven::Given { second_moment } => return Ok(*second_moment),
        SectionGiven::Round { diameter } => {
            (section::round_second_moment(*diameter), "Second moment of area of a round section")
        }
        SectionGiven::Tube { outer, inner } => {
            if inner.value() >= outer.value() {
                return Err(Refusal::because(
                    "the inner diameter of the tube is not below the outer one: write the larger one as the outer",
                ));
            }
            (section::tube_second_moment(*outer, *inner), "Second moment of area of a tube")
        }
        SectionGiven::Rectangle { breadth, height } => {
            (section::rectangle_second_moment(*breadth, *height), "Second moment of area of a rectangle")
        }
    };
    Ok(sheet.step(symbol, "cm^4", second_moment, (why, BEER.at("app. A"))))
}
