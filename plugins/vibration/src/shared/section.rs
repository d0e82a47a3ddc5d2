//! Cross-sections: what bending, axial and torsional stiffness need of them.

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
    /// Circular
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
        /// Width.
        /// Perpendicular to the plane of bending.
        #[input("b", "m", positive)]
        breadth: f64,
        /// Height.
        /// In the plane of bending.
        #[input("h", "m", positive)]
        height: f64,
    },
}

/// The cross-section of a bar pulled along its axis.
#[derive(Clone, Debug, Inputs)]
pub enum AxialSection {
    /// Area given
    Given {
        /// Area of the section.
        #[input("A", "m^2", positive)]
        area: f64,
    },
    /// Circular
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
        /// Width.
        #[input("b", "m", positive)]
        breadth: f64,
        /// Height.
        #[input("h", "m", positive)]
        height: f64,
    },
}

/// The cross-section of a shaft.
#[derive(Clone, Debug, Inputs)]
pub enum ShaftSection {
    /// Circular
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
    /// Torsion constant given
    /// For a circular section, its polar second moment of area; for other sections it is smaller.
    Given {
        /// Torsion constant.
        #[input("I_t", "m^4", positive)]
        torsion_constant: f64,
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
            walled(*outer, *inner)?;
            (section::tube_second_moment(*outer, *inner), "Second moment of area of a tube")
        }
        SectionGiven::Rectangle { breadth, height } => {
            (section::rectangle_second_moment(*breadth, *height), "Second moment of area of a rectangle")
        }
    };
    Ok(sheet.step(symbol, "cm^4", second_moment, (why, BEER.at("app. A"))))
}

/// The area of a section, m², written as the step `symbol` where it is not given.
///
/// # Errors
/// A tube whose inner diameter is not below the outer one.
#[inline]
pub fn area<W: Worksheet>(given: &AxialSectionGiven<W>, sheet: W, symbol: Symbol) -> Result<W::Num, Refusal> {
    let (area, why) = match given {
        AxialSectionGiven::Given { area } => return Ok(*area),
        AxialSectionGiven::Round { diameter } => {
            (section::round_area(*diameter), "Area of a circular section")
        }
        AxialSectionGiven::Tube { outer, inner } => {
            walled(*outer, *inner)?;
            (section::tube_area(*outer, *inner), "Area of a tube")
        }
        AxialSectionGiven::Rectangle { breadth, height } => {
            (section::rectangle_area(*breadth, *height), "Area of a rectangle")
        }
    };
    Ok(sheet.step(symbol, "cm^2", area, why))
}

/// The polar second moment of area of a round section, m⁴, written as the step `symbol`, or the torsion constant.
///
/// # Errors
/// A tube whose inner diameter is not below the outer one.
#[inline]
pub fn polar_moment<W: Worksheet>(
    given: &ShaftSectionGiven<W>,
    sheet: W,
    symbol: Symbol,
) -> Result<W::Num, Refusal> {
    let (polar, why) = match given {
        ShaftSectionGiven::Given { torsion_constant } => return Ok(*torsion_constant),
        ShaftSectionGiven::Round { diameter } => {
            (section::round_polar_moment(*diameter), "Polar second moment of area of a round section")
        }
        ShaftSectionGiven::Tube { outer, inner } => {
            walled(*outer, *inner)?;
            (section::tube_polar_moment(*outer, *inner), "Polar second moment of area of a tube")
        }
    };
    Ok(sheet.step(symbol, "cm^4", polar, (why, BEER.at("app. A"))))
}

fn walled<N: Real>(outer: N, inner: N) -> Result<(), Refusal> {
    if inner.value() < outer.value() {
        return Ok(());
    }
    Err(Refusal::because(
        "the inner diameter of the tube is not below the outer one: write the larger one as the outer",
    ))
}
