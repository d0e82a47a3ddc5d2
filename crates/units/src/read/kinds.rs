//! Comparison of the kind that was read with the kind that was requested.

use std::ops::Range;

use super::{Amount, Hint, QuantityReader, ReadError, WrongKind, scan::Cursor, si};
use crate::{Dim, Kind, Style, Unit, UnitMeaning, table, write_number};

/// Units of mass, force and acceleration in place of those that share their name, with these.
const NAMESAKES: [(&str, &str); 18] = [
    ("lb", "lbf"),
    ("lbs", "lbf"),
    ("lbm", "lbf"),
    ("kg", "kgf"),
    ("g", "g0"),
    ("g", "gf"),
    ("oz", "ozf"),
    ("t", "tf"),
    ("short ton", "short tonf"),
    ("long ton", "long tonf"),
    ("lbf", "lb"),
    ("kgf", "kg"),
    ("gf", "g"),
    ("g0", "g"),
    ("ozf", "oz"),
    ("tf", "t"),
    ("short tonf", "short ton"),
    ("long tonf", "long ton"),
];

/// Compares a reading with the kind and unit of its field. `text` is that of the whole quantity or vector.
pub(super) fn check(
    reading: &QuantityReader,
    text: &str,
    span: Range<usize>,
    default: &Unit,
    kind: Kind,
) -> Result<(), ReadError> {
    compare(reading, text, span, default, kind, false)
}

/// As [`check`], for a component of the vector whose text this is.
pub(super) fn check_component(
    reading: &QuantityReader,
    text: &str,
    span: Range<usize>,
    default: &Unit,
    kind: Kind,
) -> Result<(), ReadError> {
    compare(reading, text, span, default, kind, true)
}

fn compare(
    reading: &QuantityReader,
    text: &str,
    span: Range<usize>,
    default: &Unit,
    kind: Kind,
    component: bool,
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
    if let Some(rate) = reading.combined
        && fits(
            &Unit { dim: Dim { angle: unit.dim.angle.saturating_sub(rate), ..unit.dim }, ..unit.clone() },
            dim,
            kind,
        )
    {
        return Ok(());
    }
    let text = text[span.clone()].to_owned();
    Err(ReadError::WrongKind(Box::new(WrongKind {
        hint: if component {
            hint_for_any(unit, dim, kind, &text)
        } else {
            hint(reading.amount, unit, default, kind, &text)
        },
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

/// The hint for a quantity or a vector, whatever its numbers.
fn hint_for_any(unit: &Unit, dim: Dim, kind: Kind, text: &str) -> Option<Hint> {
    if matches!(unit.sense, UnitMeaning::Peak | UnitMeaning::PeakToPeak | UnitMeaning::Rms)
        && kind != Kind::Amplitude
    {
        return Some(Hint::NoAmplitude);
    }
    let (written, meant) = namesake(&unit.text, |meant| fits(meant, dim, kind))?;
    Some(Hint::Namesake(written, replaced(text, written, meant)))
}

fn hint(amount: Amount, unit: &Unit, default: &Unit, kind: Kind, text: &str) -> Option<Hint> {
    let dim = wanted(default, kind);
    let style = Style { digits: 12, ascii: true, ..Style::default() };
    let value = write_number(si(amount, unit).0, style);
    let number = write_number(unit.value(si(amount, unit).0), style);
    let force = Dim::new(1, 1, -2, 0);
    let symbol = &*unit.text;
    if unit.dim == Dim::MASS && dim == force && matches!(symbol, "kg" | "g" | "t") {
        return Some(Hint::WeightOf(value));
    }
    if let Some(hint) = hint_for_any(unit, dim, kind, text) {
        return Some(hint);
    }
    if unit.sense == UnitMeaning::Energy && kind == Kind::Torque {
        return Some(Hint::TorqueOf(value));
    }
    if kind == Kind::Angle && unit.dim == Dim::NONE {
        return Some(Hint::Slope);
    }
    if unit.dim == Dim::MASS && dim == force {
        return Some(Hint::WeightOf(value));
    }
    if unit.dim == force && dim == Dim::MASS {
        return Some(Hint::MassOf(value));
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
    let repaired = format!("{}/({})", above.trim_end(), below.trim_start());
    let read = super::read(&repaired, 0..repaired.len(), default).ok()?;
    read.unit.is_some_and(|unit| fits(&unit, dim, kind)).then_some(Hint::Reciprocal(repaired))
}

/// A unit of mass, force or acceleration in a unit, and the one of its name that makes it a unit that `fits`.
fn namesake(unit: &str, fits: impl Fn(&Unit) -> bool) -> Option<(&'static str, &'static str)> {
    NAMESAKES.into_iter().find(|(written, meant)| {
        let other = replaced(unit, written, meant);
        other != unit && super::unit(&other).is_ok_and(|unit| fits(&unit))
    })
}

/// Sums of two parts of different dimensions with a unit of mass, force or acceleration replaced by the one that shares
/// its name, so that both parts have one dimension: `5 lbf + 3 lbf` and `5 lb + 3 lb` for `5 lb + 3 lbf`.
pub(super) fn sums([left, right]: [&str; 2], sign: &str, [of_left, of_right]: [Dim; 2]) -> Vec<String> {
    let as_other = |part: &str, wanted: Dim| {
        NAMESAKES.into_iter().find_map(|(written, meant)| {
            let other = replaced(part.trim(), written, meant);
            let read = super::read_any(&other).ok().filter(|_| other != part.trim())?;
            (read.unit.dim == wanted).then_some(other)
        })
    };
    if [left, right].iter().any(|part| part.contains('(')) {
        return Vec::new();
    }
    let with_left = as_other(left, of_right).map(|other| format!("{other} {sign} {}", right.trim()));
    let with_right = as_other(right, of_left).map(|other| format!("{} {sign} {other}", left.trim()));
    with_left.into_iter().chain(with_right).collect()
}

/// A text with a unit, or a name of it, replaced by another unit.
fn replaced(text: &str, written: &str, meant: &str) -> String {
    let (mut out, mut cursor) = (String::with_capacity(text.len()), Cursor::new(text, 0..text.len()));
    while let Some(next) = cursor.peek() {
        match cursor.symbol() {
            Some(symbol) if table::lookup(symbol).is_some_and(|known| known.stands_for == written) => {
                out += meant;
            }
            Some(symbol) => out += symbol,
            None => {
                cursor.advance();
                out.push(next);
            }
        }
    }
    out
}

/// Probable intention behind a unit that has not the dimension wanted: a unit of mass, force or acceleration stands in it
/// in place of the one that shares its name, as in `lb/in` for a stiffness. The text of the hint is the unit meant.
///
/// ```
/// use dalembert_units::{meant_unit, unit};
/// let hint = meant_unit("lb/in", unit("N/m")?.dim).expect("lbf/in is meant");
/// assert_eq!(hint.to_string(), "lb is a mass: write `lbf/in`");
/// # Ok::<(), dalembert_units::ReadError>(())
/// ```
pub fn meant_unit(text: &str, dim: Dim) -> Option<Hint> {
    let (written, meant) = namesake(&super::unit(text).ok()?.text, |unit| unit.dim.agrees(dim))?;
    Some(Hint::Namesake(written, replaced(text, written, meant)))
}
