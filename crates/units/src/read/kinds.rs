//! Comparison of the kind that was read with the kind that was requested.

use std::ops::Range;

use super::{Amount, Hint, QuantityReader, ReadError, WrongKind, si};
use crate::{Dim, Kind, Style, Unit, UnitMeaning, table, write_number};

pub(super) fn check(
    reading: &QuantityReader,
    text: &str,
    span: Range<usize>,
    default: &Unit,
    kind: Kind,
) -> Result<(), ReadError> {
    let Some(unit) = &reading.unit else {
        return match default.factor {
            // `pi/2` in a field of degrees is meant in radians.
            factor if reading.pi && factor != 1.0 && default.dim.angle != 0 => {
                let text = text[span.clone()].to_owned();
                let rate = if default.dim.time == 0 { "rad" } else { "rad/s" };
                let readings = [format!("({text}) {rate}"), format!("({text}) {}", default.ascii())];
                Err(ReadError::Ambiguous { text, readings, span })
            }
            _ => Ok(()),
        };
    };
    let dim = wanted(default, kind);
    if fits(unit, dim, kind) {
        return Ok(());
    }
    let text = text[span.clone()].to_owned();
    Err(ReadError::WrongKind(Box::new(WrongKind {
        hint: hint(reading.amount, unit, dim, kind, &text),
        text,
        unit: unit.clone(),
        kind,
        default: default.clone(),
        span,
    })))
}

/// Feet and inches, `3'6"`, where a length is asked for: the marks are those of angles, so they are refused with what to
/// write. The two numbers as they were typed, where a text is these.
pub(super) fn refuse_feet(
    text: &str,
    span: Range<usize>,
    default: &Unit,
    kind: Kind,
) -> Result<(), ReadError> {
    let typed = &text[span.clone()];
    let Some((feet, inches)) = feet_and_inches(typed).filter(|_| wanted(default, kind) == Dim::LENGTH) else {
        return Ok(());
    };
    Err(ReadError::WrongKind(Box::new(WrongKind {
        hint: Some(Hint::Feet(format!("{feet} ft + {inches} in"))),
        text: typed.to_owned(),
        unit: super::unit("'")?,
        kind,
        default: default.clone(),
        span,
    })))
}

fn feet_and_inches(text: &str) -> Option<(&str, &str)> {
    let (feet, rest) = text.split_once(['\'', '′'])?;
    let inches = rest.trim().strip_suffix(['"', '″'])?;
    let is_number = |text: &str| {
        let digit = text.starts_with(|c: char| c.is_ascii_digit());
        digit && text.chars().all(|c| c.is_ascii_digit() || matches!(c, '.' | ',' | '/' | ' '))
    };
    let (feet, inches) = (feet.trim(), inches.trim());
    (is_number(feet) && is_number(inches)).then_some((feet, inches))
}

/// The dimension asked for.
fn wanted(default: &Unit, kind: Kind) -> Dim {
    match kind {
        Kind::Amplitude | Kind::Other => default.dim,
        kind => kind.dim().unwrap_or(default.dim),
    }
}

fn fits(unit: &Unit, dim: Dim, kind: Kind) -> bool {
    let angle = match (unit.dim.angle, dim.angle) {
        (found, wanted) if found == wanted => true,
        (0, _) => true,
        // 3 m × 2 rad/s is a velocity; N·m/rad is no torque, and an angle is no ratio.
        (found, 0) => found > 0 && dim != Dim::NONE,
        _ => false,
    };
    let sense = match unit.sense {
        UnitMeaning::Plain => true,
        UnitMeaning::Energy => kind != Kind::Torque,
        UnitMeaning::Level => dim == Dim::NONE && kind != Kind::Angle,
        UnitMeaning::Peak | UnitMeaning::PeakToPeak | UnitMeaning::Rms => kind == Kind::Amplitude,
    };
    // A percentage of an angle would be read as radians.
    let percent = kind == Kind::Angle && unit.dim == Dim::NONE && unit.factor != 1.0;
    unit.dim.agrees(dim) && angle && sense && !percent
}

fn hint(amount: Amount, unit: &Unit, dim: Dim, kind: Kind, text: &str) -> Option<Hint> {
    let style = Style { digits: 12, ascii: true, ..Style::default() };
    let value = write_number(si(amount, unit).0, style);
    let number = write_number(unit.value(si(amount, unit).0), style);
    let force = Dim::new(1, 1, -2, 0);
    if matches!(unit.sense, UnitMeaning::Peak | UnitMeaning::PeakToPeak | UnitMeaning::Rms)
        && kind != Kind::Amplitude
    {
        return Some(Hint::NoAmplitude);
    }
    if unit.sense == UnitMeaning::Energy && kind == Kind::Torque {
        return Some(Hint::TorqueOf(value));
    }
    if kind == Kind::Angle && unit.dim == Dim::NONE {
        return Some(Hint::Slope);
    }
    let symbol = &*unit.text;
    if unit.dim == Dim::MASS && dim == force {
        return Some(match symbol {
            "lb" | "lbs" | "lbm" => Hint::PoundForce(number),
            _ => Hint::WeightOf(value),
        });
    }
    if unit.dim == force && dim == Dim::MASS {
        return Some(Hint::MassOf(value));
    }
    if symbol == "g" && dim == Dim::new(1, 0, -2, 0) {
        return Some(Hint::StandardGravity(number));
    }
    if dim == Dim::LENGTH && matches!(symbol, "'" | "′" | "\"" | "″") {
        let name = if matches!(symbol, "'" | "′") { "ft" } else { "in" };
        return Some(Hint::Feet(format!("{number} {name}")));
    }
    if let Some(meant) = table::with_one_letter_more(symbol, dim) {
        return Some(Hint::Meant(format!("{number} {meant}")));
    }
    // `1/0.5 s` is half of what 1/(0.5 s) would be.
    let (above, below) = text.split_once('/')?;
    let reciprocal = unit.dim != Dim::NONE && unit.dim.powi(-1).agrees(dim);
    let once = !below.contains('/');
    (reciprocal && once).then(|| Hint::Reciprocal(format!("{}/({})", above.trim_end(), below.trim_start())))
}
