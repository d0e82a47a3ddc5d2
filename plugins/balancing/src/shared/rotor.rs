//! Inputs and helpers shared by the analyses of rigid rotors: masses, angles, corrections.

use std::f64::consts::TAU;

use dalembert_core::{Inputs, Symbol, Worksheet};
use dalembert_mechanics::{Real, balance};

use crate::sources::RIUL;

/// A symbol with a row: `m₁`.
pub(crate) fn letter(symbol: &str, row: usize) -> String {
    format!("{symbol}{}", dalembert_units::subscript(row))
}

/// Correction of a rotor, by addition or removal of material.
#[derive(Clone, Debug, Inputs)]
pub enum Correction {
    /// Radius given, mass required
    Radius {
        /// Radius.
        #[input("r_c", "mm", positive)]
        radius: f64,
    },
    /// Mass given, radius required
    Mass {
        /// Mass.
        #[input("m_c", "kg", positive)]
        mass: f64,
    },
    /// Only the mass–radius product is required
    Product,
}

/// Method of correction: material added or removed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Inputs)]
pub enum CorrectionMethod {
    /// Mass is added
    Add,
    /// Mass is removed by drilling
    Drill,
}

/// Direction from which angles are measured.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Inputs)]
pub enum Angles {
    /// From the mark on the rotor
    Absolute,
    /// From one mass to the next
    /// The first counts from the mark.
    Successive,
}

/// Symbols of a correction.
pub(crate) struct Symbols {
    pub size: &'static str,
    pub mass: &'static str,
    pub radius: &'static str,
    pub angle: &'static str,
    pub other_angle: &'static str,
    pub weight: &'static str,
}

/// Answers of a correction, each a key and a label.
pub(crate) struct Keys {
    pub size: (&'static str, &'static str),
    pub mass: (&'static str, &'static str),
    pub radius: (&'static str, &'static str),
    pub angle: (&'static str, &'static str),
    pub other_angle: (&'static str, &'static str),
    pub weight: (&'static str, &'static str),
}

/// Size, angle, mass or radius, and weight of a correction, from its components; row 0 for the only one.
///
/// `scale` is the size of what cancelled in the components: a correction below its rounding is none.
#[expect(
    clippy::too_many_arguments,
    reason = "a correction is its components, its names and what is known of it"
)]
pub(crate) fn correct<W: Worksheet>(
    sheet: W,
    row: usize,
    symbols: &Symbols,
    keys: &Keys,
    (x, y): (W::Num, W::Num),
    known: &CorrectionGiven<W>,
    way: CorrectionMethod,
    gravity: W::Num,
    scale: f64,
) {
    let why = ("Magnitude of the correction", RIUL.at("eq. 16"));
    let size = sheet.step((symbols.size, row), "kg*mm", balance::magnitude(x, y), why);
    sheet.answer((keys.size.0, row), keys.size.1, size);
    if size.value() <= 1e-12 * scale {
        return;
    }
    let (mass, product) = match known {
        CorrectionGiven::Radius { radius } => {
            let why = ("Mass at the given radius", RIUL.at("eq. 17"));
            let mass = sheet.step((symbols.mass, row), "kg", size / *radius, why);
            sheet.answer((keys.mass.0, row), keys.mass.1, mass);
            (Some(mass), mass * *radius)
        }
        CorrectionGiven::Mass { mass } => {
            let radius = sheet.step((symbols.radius, row), "mm", size / *mass, "Radius of the given mass");
            sheet.answer((keys.radius.0, row), keys.radius.1, radius);
            (Some(*mass), *mass * radius)
        }
        CorrectionGiven::Product {} => (None, size),
    };
    let (direction, why) = match way {
        CorrectionMethod::Add => (
            balance::marked_direction(x, y),
            "Angle where the mass is added, in the sense of the angles given",
        ),
        CorrectionMethod::Drill => (
            balance::marked_direction(-x, -y),
            "Angle where the mass is removed, opposite to where it would be added",
        ),
    };
    quadrant_ignored(sheet, (symbols.angle, row), (x, y));
    let angle = sheet.step((symbols.angle, row), "deg", direction, (why, RIUL.at("eq. 19")));
    let other = if angle.value() > 1e-11 { -angle + TAU } else { -angle };
    let other = sheet.step(
        (symbols.other_angle, row),
        "deg",
        other,
        "The same position, measured in the opposite sense",
    );
    sheet.answer((keys.angle.0, row), keys.angle.1, angle);
    sheet.answer((keys.other_angle.0, row), keys.other_angle.1, other);
    sheet.verify(|| {
        let sign = if way == CorrectionMethod::Add { 1.0 } else { -1.0 };
        let along_x = product * angle.cos() * sign;
        let along_y = product * other.sin() * -sign;
        sheet.check_sum("mass, radius and angle make up the component along x", along_x, x, size.value());
        sheet.check_sum("mass, radius and angle make up the component along y", along_y, y, size.value());
    });
    if let Some(mass) = mass {
        let weight = sheet.step((symbols.weight, row), "N", mass * gravity, "Weight of the correction");
        sheet.answer((keys.weight.0, row), keys.weight.1, weight);
    }
}

/// The error of unbalances that are added without their directions.
pub(crate) const AS_NUMBERS: &str = "the products m r added as numbers, their angles ignored";
/// The error of moments that are added so.
pub(crate) const MOMENTS_AS_NUMBERS: &str =
    "the moments of all masses added as numbers, their angles ignored";
/// The error of moments about another point than that asked for.
pub(crate) const ABOUT_THE_ORIGIN: &str = "the moments taken about the origin of the positions";
/// The error of corrections that leave the couple.
pub(crate) const HALF_EACH: &str = "half of the resultant balanced in each plane, the moments ignored";
/// The error of a correction found as if it were the only one.
pub(crate) const WITHOUT_THE_OTHER: &str = "the correction in the other plane left out of the sum of forces";

/// The error of a difference with the wrong sign.
pub(crate) const REVERSED: &str = "the difference of the vectors taken the other way round";

/// Declares what the arctangent alone gives for the direction of a vector, the next step of the symbol.
#[inline(always)]
pub(crate) fn quadrant_ignored<W: Worksheet>(sheet: W, symbol: impl Into<Symbol>, (x, y): (W::Num, W::Num)) {
    let what = "the arctangent of the quotient of the components taken, the quadrant ignored";
    sheet.common_error(symbol, what, || (y / x).atan2(W::Num::from(1.0)));
}

/// Declares the size and the angle of a correction whose components people find by another rule, unless these are only
/// rounding beside `scale`.
#[inline(always)]
pub(crate) fn by_another_rule<W: Worksheet>(
    sheet: W,
    (size, angle): (impl Into<Symbol>, impl Into<Symbol>),
    (way, scale): (CorrectionMethod, f64),
    what: &'static str,
    components: impl FnOnce() -> (W::Num, W::Num),
) {
    sheet.verify(|| {
        let (x, y) = components();
        let found = balance::magnitude(x, y);
        if found.value() <= 1e-9 * scale {
            return;
        }
        sheet.common_error(size, what, || found);
        sheet.common_error(angle, what, || match way {
            CorrectionMethod::Add => balance::marked_direction(x, y),
            CorrectionMethod::Drill => balance::marked_direction(-x, -y),
        });
    });
}

/// Declares what people find for the static part of two vectors, the couple part and the angle of the static one, from
/// sizes and angles alone.
pub(crate) fn parts_of_sizes<W: Worksheet>(
    sheet: W,
    [common, opposite, angle]: [&'static str; 3],
    vectors: impl FnOnce() -> [(W::Num, W::Num); 2],
) {
    sheet.verify(|| {
        let [(one, first), (other, second)] = vectors();
        sheet.common_error(common, "the mean of the two magnitudes taken, their angles ignored", || {
            (one + other) / 2.0
        });
        sheet.common_error(angle, "the mean of the two angles taken", || (first + second) / 2.0);
        if (one.value() - other.value()).abs() > 1e-9 * one.value() {
            let what = "half the difference of the two magnitudes taken, their angles ignored";
            sheet.common_error(opposite, what, || (one - other).abs() / 2.0);
        }
    });
}

/// The square of a resultant by the law of cosines over all pairs of vectors, each a size and an angle, which knows
/// nothing of axes, and the square of the sum of their sizes.
pub(crate) fn by_pairs(vectors: &[(f64, f64)]) -> (f64, f64) {
    let against = |(u, a): &(f64, f64)| vectors.iter().map(|(v, b)| u * v * (a - b).cos()).sum::<f64>();
    (vectors.iter().map(against).sum(), vectors.iter().map(|(u, _)| u.abs()).sum::<f64>().powi(2))
}

/// The size of a resultant of vectors, each a size and an angle, by components along the first of them and across it,
/// and the sum of their sizes.
pub(crate) fn along_first(vectors: &[(f64, f64)]) -> (f64, f64) {
    let from = vectors.first().map_or(0.0, |(_, angle)| *angle);
    let part = |of: fn(f64) -> f64| vectors.iter().map(|(u, a)| u * of(a - from)).sum::<f64>();
    (part(f64::cos).hypot(part(f64::sin)), vectors.iter().map(|(u, _)| u.abs()).sum())
}
