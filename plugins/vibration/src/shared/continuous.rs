//! Inputs and figures shared by continuous bodies: material, section, mass per unit length, mode shapes.

use dalembert_core::{Axis, Exhibit, Ink, Inputs, Plot, Point, Series, Sketch, Symbol, Text, Worksheet};

use crate::sources::BEER;

/// Shear modulus of a material.
#[derive(Clone, Debug, Inputs)]
pub enum ShearModulus {
    /// Shear modulus given
    Given {
        /// Shear modulus.
        #[input("G", "Pa", positive)]
        shear: f64,
    },
    /// From Young's modulus and Poisson's ratio
    Isotropic {
        /// Young's modulus.
        #[input("E", "Pa", positive)]
        young: f64,
        /// Poisson's ratio.
        #[input("ν", "1", min = 0, max = 0.5)]
        poisson: f64,
    },
}

/// Mass of each length of a body.
#[derive(Clone, Debug, Inputs)]
pub enum LineMass {
    /// Density given
    Density {
        /// Density.
        #[input("ρ", "kg/m^3", positive)]
        density: f64,
    },
    /// Mass per unit length given
    PerLength {
        /// Mass per unit length.
        #[input("m̄", "kg/m", positive)]
        mass: f64,
    },
    /// Weight per unit length given
    Weight {
        /// Weight per unit length.
        #[input("w", "N/m", positive)]
        weight: f64,
        /// Gravity.
        #[input("g", "m/s^2", positive, default = "9.81 m/s^2", default_before = "9.80665 m/s^2")]
        gravity: f64,
    },
}

/// The shear modulus, Pa, written as the step `symbol` where it is not given.
#[inline]
pub(crate) fn shear_modulus<W: Worksheet>(
    given: &ShearModulusGiven<W>,
    sheet: W,
    symbol: impl Into<Symbol>,
) -> W::Num {
    match given {
        ShearModulusGiven::Given { shear } => *shear,
        ShearModulusGiven::Isotropic { young, poisson } => isotropic_shear(*young, *poisson, sheet, symbol),
    }
}

/// The shear modulus of an isotropic material, Pa, written as the step `symbol`.
#[inline]
pub(crate) fn isotropic_shear<W: Worksheet>(
    young: W::Num,
    poisson: W::Num,
    sheet: W,
    symbol: impl Into<Symbol>,
) -> W::Num {
    let symbol: Symbol = symbol.into();
    sheet.common_error(symbol, "Young's modulus used as the shear modulus", || young);
    let bulk = || young / ((W::Num::from(1.0) - poisson * 2.0) * 3.0);
    sheet.common_error(symbol, "the bulk modulus, E/(3(1 − 2ν)), used", bulk);
    let modulus = young / ((poisson + 1.0) * 2.0);
    sheet.step(symbol, "GPa", modulus, ("Shear modulus of an isotropic material", BEER.at("ch. 2")))
}

/// The mass of each length, kg/m, of a body with that area; row 0 for the only body.
pub(crate) fn line_mass<W: Worksheet>(
    given: &LineMassGiven<W>,
    row: usize,
    area: W::Num,
    sheet: W,
) -> W::Num {
    let (mass, why) = match given {
        LineMassGiven::PerLength { mass } => return *mass,
        LineMassGiven::Density { density } => (*density * area, "Mass per unit length: density times area"),
        LineMassGiven::Weight { weight, gravity } => {
            (*weight / *gravity, "Mass per unit length: weight over gravity")
        }
    };
    sheet.step(("m̄", row), "kg/m", mass, why)
}

/// The common errors of a higher frequency `("ω", n)`: what people conclude from the first one. `bends` is true for
/// a body with bending stiffness.
pub(crate) fn overtone_errors<W: Worksheet>(n: usize, first: Option<W::Num>, bends: bool, sheet: W) {
    let (Some(first), count) = (first, n as f64) else { return };
    let multiple = || first * count;
    sheet.common_error(("ω", n), "the overtones taken as whole multiples of the first frequency", multiple);
    if bends {
        let square = || first * count.powi(2);
        sheet.common_error(("ω", n), "the frequencies taken in the ratios 1, 4, 9 of pinned ends", square);
    }
}

/// A shape for pictures: points from 0 to the length, deflections at most one.
pub(crate) struct Sampled {
    /// Number of the shape, counted from 1.
    pub(crate) number: usize,
    /// Points: position in m, deflection.
    pub(crate) points: Vec<(f64, f64)>,
}

impl Sampled {
    /// A shape at equal steps.
    pub(crate) fn new(number: usize, length: f64, deflection: impl Fn(f64) -> f64) -> Self {
        let parts = 24 + 12 * number;
        let xi = |n: usize| n as f64 / parts as f64;
        Sampled { number, points: (0..=parts).map(|n| (xi(n) * length, deflection(xi(n)))).collect() }
    }
}

/// The shapes over the length.
pub(crate) fn shapes_plot(shapes: &[Sampled]) -> Exhibit {
    let line =
        |shape: &Sampled| Series::line(Text::new("mode {n}").with("n", shape.number), shape.points.clone());
    Exhibit::Plot(
        Plot::new(
            "Mode shapes",
            Axis::linear("distance from the left end", "m"),
            Axis::linear("deflection / maximum deflection", "1"),
            shapes.iter().take(5).map(line).collect(),
        )
        .level("at rest", 0.0),
    )
}

/// The first shapes one above the other, in motion; `ends` draws what holds a body with its left end at a point and
/// its right end at another.
pub(crate) fn shapes_film(shapes: &[Sampled], length: f64, ends: impl Fn(&mut Sketch, f64, f64)) -> Exhibit {
    const FRAMES: u16 = 24;
    let shown = shapes.len().min(4);
    let width = 6.0;
    let frame = |n: u16| {
        let phase = (std::f64::consts::TAU * f64::from(n) / f64::from(FRAMES)).cos();
        let mut sketch = Sketch::default();
        for (at, shape) in shapes.iter().take(shown).enumerate() {
            let y = 2.0 * (shown - 1 - at) as f64;
            let point = |(x, w): &(f64, f64)| (x / length * width, y + 0.7 * w * phase);
            sketch
                .axis((0.0, y), (width, y))
                .curve(shape.points.iter().map(point).collect::<Vec<_>>(), Ink::Motion)
                .label(Text::new("mode {n}").with("n", shape.number), (width + 0.4, y));
            ends(&mut sketch, width, y);
        }
        sketch
    };
    Exhibit::Animation(Sketch::animation("Mode shapes in motion", (0..FRAMES).map(frame), 2.0))
}

/// Half the thickness of a drawn beam.
pub(crate) const HALF_BEAM: f64 = 0.09;

/// A beam of a width from the left end, with its length below.
pub(crate) fn beam(title: &'static str, width: f64) -> Sketch {
    let mut sketch = Sketch::new(title);
    sketch.mass("", (0.0, -HALF_BEAM), (width, HALF_BEAM)).dimension("L", (0.0, -1.2), (width, -1.2), 0.0);
    sketch
}

/// The support of a beam at a point: clamped, pinned, or guided, which holds the slope alone.
pub(crate) fn draw_support(
    sketch: &mut Sketch,
    (held, clamped): (bool, bool),
    (x, y): Point,
    left_end: bool,
) {
    match (held, clamped) {
        (true, true) if left_end => sketch.ground((x, y + 0.5), (x, y - 0.5)),
        (true, true) => sketch.ground((x, y - 0.5), (x, y + 0.5)),
        (true, false) => sketch.pin("", (x, y)),
        (false, true) => sketch.bars([(x, y - 0.5), (x, y + 0.5)]),
        (false, false) => sketch,
    };
}
