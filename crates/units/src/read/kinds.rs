//! Whether what was read is of the kind that was asked for.

use std::ops::Range;

use super::{Amount, Hint, ReadError, Reading, WrongKind, si};
use crate::{Dim, Kind, Sense, Style, Unit, write_number};

pub(super) fn check(
    reading: &Reading,
    text: &str,
    span: Range<usize>,
    bare: &Unit,
    kind: Kind,
) -> Result<(), ReadError> {
    let Some(unit) = &reading.unit else {
        return match bare.factor {
            // `pi/2` in a field of degrees is meant in radians.
            factor if reading.pi && factor != 1.0 && bare.dim.angle != 0 => {
                let text = text[span.clone()].to_owned();
                let rate = if bare.dim.time == 0 { "rad" } else { "rad/s" };
                let readings = [format!("({text}) {rate}"), format!("({text}) {}", bare.ascii())];
                Err(ReadError::Ambiguous { text, readings, span })
            }
            _ => Ok(()),
        };
    };
    let dim = wanted(bare, kind);
    if fits(unit, dim, kind) {
        return Ok(());
    }
    let text = text[span.clone()].to_owned();
    Err(ReadError::WrongKind(Box::new(WrongKind {
        hint: hint(reading.amount, unit, dim, kind, &text),
        text,
        unit: unit.clone(),
        kind,
        bare: bare.clone(),
        span,
    })))
}

/// The dimension asked for.
fn wanted(bare: &Unit, kind: Kind) -> Dim {
    match kind {
        Kind::Amplitude | Kind::Other => bare.dim,
        kind => kind.dim().unwrap_or(bare.dim),
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
        Sense::Plain => true,
        Sense::Energy => kind != Kind::Torque,
        Sense::Level => dim == Dim::NONE && kind != Kind::Angle,
        Sense::Peak | Sense::PeakToPeak | Sense::Rms => kind == Kind::Amplitude,
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
    if matches!(unit.sense, Sense::Peak | Sense::PeakToPeak | Sense::Rms) && kind != Kind::Amplitude {
        return Some(Hint::NoAmplitude);
    }
    if unit.sense == Sense::Energy && kind == Kind::Torque {
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
    // `1/0.5 s` is half of what 1/(0.5 s) would be.
    let (above, below) = text.split_once('/')?;
    let reciprocal = unit.dim != Dim::NONE && unit.dim.powi(-1).agrees(dim);
    let once = !below.contains('/');
    (reciprocal && once).then(|| Hint::Reciprocal(format!("{}/({})", above.trim_end(), below.trim_start())))
}
