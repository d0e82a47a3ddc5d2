//! Cross-sections: what bending, axial and torsional stiffness need of them.

use std::f64::consts::PI;

use dalembert_core::{Inputs, Point, Refusal, Sketch, Symbol, Worksheet};
use dalembert_mechanics::{Real, section};

use crate::sources::{BEER, COWPER};

/// A section with the same stiffness in every direction.
#[derive(Clone, Debug, Inputs)]
pub enum RoundSection {
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
}

/// The cross-section of a beam.
#[derive(Clone, Debug, Inputs)]
pub enum Section {
    /// Second moment of area given
    Given {
        /// Second moment of area.
        #[input("I", "m^4", positive)]
        second_moment: f64,
    },
    /// Circular or tube
    #[input(flatten)]
    Round(RoundSection),
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
    /// Circular or tube
    #[input(flatten)]
    Round(RoundSection),
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

/// The cross-section of a beam that has mass.
#[derive(Clone, Debug, Inputs)]
pub enum Profile {
    /// Area and second moment given
    Given {
        /// Area of the section.
        #[input("A", "m^2", positive)]
        area: f64,
        /// Second moment of area.
        #[input("I", "m^4", positive)]
        second_moment: f64,
    },
    /// Circular or tube
    #[input(flatten)]
    Round(RoundSection),
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

/// The cross-section of a beam whose own mass may be neglected.
#[derive(Clone, Debug, Inputs)]
pub enum LightProfile {
    /// Second moment of area given
    Given {
        /// Area of the section.
        /// Only for the mass of the beam itself, by its density.
        #[input("A", "m^2", positive)]
        area: Option<f64>,
        /// Second moment of area.
        #[input("I", "m^4", positive)]
        second_moment: f64,
    },
    /// Circular or tube
    #[input(flatten)]
    Round(RoundSection),
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

/// The cross-section of a shaft.
#[derive(Clone, Debug, Inputs)]
pub enum ShaftSection {
    /// Circular or tube
    #[input(flatten)]
    Round(RoundSection),
    /// Torsion constant given
    /// For a circular section, its polar second moment of area; for other sections it is smaller.
    Given {
        /// Torsion constant.
        #[input("I_t", "m^4", positive)]
        torsion_constant: f64,
    },
}

impl<W: Worksheet> RoundSectionGiven<W> {
    /// The area, m².
    pub(crate) fn area(&self) -> W::Num {
        match *self {
            RoundSectionGiven::Round { diameter } => section::round_area(diameter),
            RoundSectionGiven::Tube { outer, inner } => section::tube_area(outer, inner),
        }
    }

    /// The second moment of area, m⁴.
    pub(crate) fn second_moment(&self) -> W::Num {
        match *self {
            RoundSectionGiven::Round { diameter } => section::round_second_moment(diameter),
            RoundSectionGiven::Tube { outer, inner } => section::tube_second_moment(outer, inner),
        }
    }

    /// The polar second moment of area, m⁴, which is also the torsion constant.
    pub(crate) fn polar_moment(&self) -> W::Num {
        match *self {
            RoundSectionGiven::Round { diameter } => section::round_polar_moment(diameter),
            RoundSectionGiven::Tube { outer, inner } => section::tube_polar_moment(outer, inner),
        }
    }

    /// Records the common errors of its area.
    fn area_errors(&self, sheet: W, symbol: Symbol) {
        let RoundSectionGiven::Tube { outer, inner } = *self else { return };
        let square = || section::round_area(outer - inner);
        sheet.common_error(symbol, "the square of the difference of the diameters taken", square);
        let unrolled = || outer * PI * (outer - inner) / 2.0;
        sheet.common_error(symbol, "the wall thickness times the outer circumference taken", unrolled);
    }

    /// Records the common errors of its second moment of area.
    fn second_moment_errors(&self, sheet: W, symbol: Symbol) {
        let polar = || self.polar_moment();
        sheet.common_error(symbol, "the polar second moment of area used for bending", polar);
        let RoundSectionGiven::Tube { outer, inner } = *self else { return };
        let power = || section::round_second_moment(outer - inner);
        sheet.common_error(symbol, "the fourth power of the difference of the diameters taken", power);
        let thin = || (outer + inner).powi(3) * (outer - inner) * PI / 128.0;
        sheet.common_error(symbol, "the formula of a thin-walled tube used", thin);
    }

    /// Records the common errors of its polar second moment of area.
    fn polar_moment_errors(&self, sheet: W, symbol: Symbol) {
        let bending = || self.second_moment();
        sheet.common_error(symbol, "the second moment of area for bending used in torsion", bending);
        let RoundSectionGiven::Tube { outer, inner } = *self else { return };
        let power = || section::round_polar_moment(outer - inner);
        sheet.common_error(symbol, "the fourth power of the difference of the diameters taken", power);
        let thin = || (outer + inner).powi(3) * (outer - inner) * PI / 64.0;
        sheet.common_error(symbol, "the formula of a thin-walled tube used", thin);
    }

    /// Cowper's shear coefficient; the ratio of the diameters of a tube is written as the step `symbol`.
    pub(crate) fn shear_coefficient(&self, poisson: W::Num, sheet: W, symbol: &'static str) -> W::Num {
        match *self {
            RoundSectionGiven::Round { .. } => section::shear::round(poisson),
            RoundSectionGiven::Tube { outer, inner } => {
                let ratio = sheet.step(symbol, "1", inner / outer, "Ratio of the diameters");
                section::shear::tube(poisson, ratio)
            }
        }
    }

    /// Refuses a tube without a wall.
    pub(crate) fn check(&self) -> Result<(), Refusal> {
        match self {
            RoundSectionGiven::Tube { outer, inner } if inner.value() >= outer.value() => {
                Err(Refusal::because(
                    "the inner diameter of the tube is not below the outer one: write the larger one as the outer",
                ))
            }
            _ => Ok(()),
        }
    }
}

/// Records the common error of the second moment of area of a rectangle.
fn rectangle_errors<W: Worksheet>([breadth, height]: [W::Num; 2], sheet: W, symbol: Symbol) {
    let about_edge = || breadth * height.powi(3) / 3.0;
    sheet.common_error(symbol, "the second moment of area about the edge taken, b h³/3", about_edge);
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
        SectionGiven::Round(round) => {
            round.check()?;
            let why = match round {
                RoundSectionGiven::Round { .. } => "Second moment of area of a round section",
                RoundSectionGiven::Tube { .. } => "Second moment of area of a tube",
            };
            round.second_moment_errors(sheet, symbol);
            (round.second_moment(), why)
        }
        SectionGiven::Rectangle { breadth, height } => {
            rectangle_errors([*breadth, *height], sheet, symbol);
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
        AxialSectionGiven::Round(round) => {
            round.check()?;
            let why = match round {
                RoundSectionGiven::Round { .. } => "Area of a circular section",
                RoundSectionGiven::Tube { .. } => "Area of a tube",
            };
            round.area_errors(sheet, symbol);
            (round.area(), why)
        }
        AxialSectionGiven::Rectangle { breadth, height } => {
            (section::rectangle_area(*breadth, *height), "Area of a rectangle")
        }
    };
    Ok(sheet.step(symbol, "cm^2", area, why))
}

/// Area, m², and second moment of area, m⁴, of a section; row 0 for the only one.
///
/// # Errors
/// A tube whose inner diameter is not below the outer one.
pub(crate) fn profile<W: Worksheet>(
    given: &ProfileGiven<W>,
    row: usize,
    sheet: W,
) -> Result<(W::Num, W::Num), Refusal> {
    let (area, second_moment) = match given {
        ProfileGiven::Given { area, second_moment } => return Ok((*area, *second_moment)),
        ProfileGiven::Round(round) => {
            round.check()?;
            round.area_errors(sheet, ("A", row).into());
            round.second_moment_errors(sheet, ("I", row).into());
            (round.area(), round.second_moment())
        }
        ProfileGiven::Rectangle { breadth, height } => {
            rectangle_errors([*breadth, *height], sheet, ("I", row).into());
            (section::rectangle_area(*breadth, *height), section::rectangle_second_moment(*breadth, *height))
        }
    };
    let area = sheet.step(("A", row), "cm^2", area, ("Area of the section", BEER.at("app. A")));
    let why = ("Second moment of area", BEER.at("app. A"));
    let second_moment = sheet.step(("I", row), "cm^4", second_moment, why);
    Ok((area, second_moment))
}

/// Area, m², where it is needed and known, and second moment of area, m⁴, of a section.
///
/// # Errors
/// A tube whose inner diameter is not below the outer one.
pub(crate) fn light_profile<W: Worksheet>(
    given: &LightProfileGiven<W>,
    needs_area: bool,
    sheet: W,
) -> Result<(Option<W::Num>, W::Num), Refusal> {
    let (area, second_moment) = match given {
        LightProfileGiven::Given { area, second_moment } => return Ok((*area, *second_moment)),
        LightProfileGiven::Round(round) => {
            round.check()?;
            if needs_area {
                round.area_errors(sheet, "A".into());
            }
            round.second_moment_errors(sheet, "I".into());
            (round.area(), round.second_moment())
        }
        LightProfileGiven::Rectangle { breadth, height } => {
            rectangle_errors([*breadth, *height], sheet, "I".into());
            (section::rectangle_area(*breadth, *height), section::rectangle_second_moment(*breadth, *height))
        }
    };
    let area = needs_area.then(|| sheet.step("A", "cm^2", area, ("Area of the section", BEER.at("app. A"))));
    let why = ("Second moment of area", BEER.at("app. A"));
    Ok((area, sheet.step("I", "cm^4", second_moment, why)))
}

/// Cowper's shear coefficient of a section; `None` for one that is not known by its shape.
pub(crate) fn shear_coefficient<W: Worksheet>(
    given: &ProfileGiven<W>,
    poisson: W::Num,
    sheet: W,
) -> Option<W::Num> {
    let coefficient = match given {
        ProfileGiven::Given { .. } => return None,
        ProfileGiven::Round(round) => round.shear_coefficient(poisson, sheet, "m"),
        ProfileGiven::Rectangle { .. } => section::shear::rectangle(poisson),
    };
    Some(sheet.step("κ", "1", coefficient, ("Shear coefficient of the section", COWPER.at("pp. 335–340"))))
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
    let round = match given {
        ShaftSectionGiven::Given { torsion_constant } => return Ok(*torsion_constant),
        ShaftSectionGiven::Round(round) => round,
    };
    round.check()?;
    let why = match round {
        RoundSectionGiven::Round { .. } => "Polar second moment of area of a round section",
        RoundSectionGiven::Tube { .. } => "Polar second moment of area of a tube",
    };
    round.polar_moment_errors(sheet, symbol);
    Ok(sheet.step(symbol, "cm^4", round.polar_moment(), (why, BEER.at("app. A"))))
}

impl RoundSection {
    /// The letters of its diameters.
    pub(crate) fn letters(&self) -> &'static str {
        match self {
            RoundSection::Round { .. } => "d",
            RoundSection::Tube { .. } => "D, d",
        }
    }
}

impl ShaftSection {
    /// The letters of its lengths, one by one.
    pub(crate) fn each(&self) -> &'static [&'static str] {
        match self {
            ShaftSection::Round(RoundSection::Round { .. }) => &["d"],
            ShaftSection::Round(RoundSection::Tube { .. }) => &["D", "d"],
            ShaftSection::Given { .. } => &["I_t"],
        }
    }

    /// The letters of its lengths.
    pub(crate) fn letters(&self) -> &'static str {
        match self {
            ShaftSection::Round(section) => section.letters(),
            ShaftSection::Given { .. } => "",
        }
    }
}

impl Section {
    /// Writes its lengths at a place beside a beam; none of a section that is known by its second moment of area.
    pub(crate) fn label(&self, sketch: &mut Sketch, at: Point) {
        match self {
            Section::Given { .. } => {}
            Section::Round(section) => {
                sketch.label(section.letters(), at);
            }
            Section::Rectangle { .. } => {
                sketch.label("b, h", at);
            }
        }
    }
}

impl Profile {
    /// The letters of what is given, one by one.
    pub(crate) fn letters(&self) -> &'static [&'static str] {
        match self {
            Profile::Given { .. } => &["A", "I"],
            Profile::Round(RoundSection::Round { .. }) => &["d"],
            Profile::Round(RoundSection::Tube { .. }) => &["D", "d"],
            Profile::Rectangle { .. } => &["b", "h"],
        }
    }

    /// The cross-section about a centre, with its lengths.
    pub(crate) fn draw(&self, sketch: &mut Sketch, centre: Point, size: f64) {
        match self {
            Profile::Given { .. } => any_section(sketch, "A, I", centre, size),
            Profile::Round(section) => section.draw(sketch, centre, size),
            Profile::Rectangle { breadth, height } => rectangle(sketch, [*breadth, *height], centre, size),
        }
    }
}

impl LightProfile {
    /// The cross-section about a centre, with its lengths.
    pub(crate) fn draw(&self, sketch: &mut Sketch, centre: Point, size: f64) {
        match self {
            LightProfile::Given { area: None, .. } => any_section(sketch, "I", centre, size),
            LightProfile::Given { .. } => any_section(sketch, "A, I", centre, size),
            LightProfile::Round(section) => section.draw(sketch, centre, size),
            LightProfile::Rectangle { breadth, height } => {
                rectangle(sketch, [*breadth, *height], centre, size);
            }
        }
    }
}

impl RoundSection {
    /// The cross-section about a centre, with its diameters.
    pub(crate) fn draw(&self, sketch: &mut Sketch, (x, y): Point, size: f64) {
        let radius = size / 2.0;
        sketch.disc("", (x, y), radius);
        match self {
            RoundSection::Round { .. } => sketch.dimension("d", (x - radius, y), (x + radius, y), 0.0),
            RoundSection::Tube { outer, inner } => {
                let hole = radius * (inner / outer).min(0.9);
                sketch.disc("", (x, y), hole).dimension("d", (x - hole, y), (x + hole, y), 0.0).dimension(
                    "D",
                    (x - radius, y),
                    (x + radius, y),
                    -5.0,
                )
            }
        };
    }
}

/// A rectangle of a section, at least a fifth of the size thick.
fn rectangle(sketch: &mut Sketch, [breadth, height]: [f64; 2], (x, y): Point, size: f64) {
    let largest = breadth.max(height);
    let [b, h] = [breadth, height].map(|length| (length / largest).max(0.2) * size / 2.0);
    sketch
        .mass("", (x - b, y - h), (x + b, y + h))
        .dimension("b", (x - b, y - h), (x + b, y - h), -1.5)
        .dimension("h", (x + b, y - h), (x + b, y + h), -1.5);
}

/// A section that is known by its numbers alone, drawn as a beam with flanges.
fn any_section(sketch: &mut Sketch, letters: &'static str, (x, y): Point, size: f64) {
    let (wide, high, web, flange) = (0.35 * size, 0.5 * size, 0.08 * size, 0.14 * size);
    let side = |sign: f64| {
        [
            (x + sign * wide, y + high),
            (x + sign * wide, y + high - flange),
            (x + sign * web, y + high - flange),
            (x + sign * web, y - high + flange),
            (x + sign * wide, y - high + flange),
            (x + sign * wide, y - high),
        ]
    };
    let outline: Vec<Point> = side(1.0).into_iter().chain(side(-1.0).into_iter().rev()).collect();
    sketch.body("", outline).label(letters, (x + wide, y));
}
