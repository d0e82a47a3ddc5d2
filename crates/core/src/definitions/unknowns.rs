//! Unknown inputs and given answers as they are typed: `? 1 kg .. 100 kg`, `8.2 Hz ± 0.05`.

use dalembert_units::{self as units, Quantity, Unit};

use crate::{
    FieldError, FieldLimit, Measure, Plain, Stop, Text,
    formula::{Formula, Operand, evaluate, unit_of},
    reading,
};

/// An input or a definition that is to be found.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Unknown {
    /// The path of the input, or the name of the definition.
    pub(crate) name: String,
    /// The value to begin with, in SI, where one is typed: `? 40 kg`.
    pub(crate) start: Option<f64>,
    /// The range to search, in SI, where one is typed: `? 1 kg .. 100 kg`.
    pub(crate) range: Option<[f64; 2]>,
}

/// An answer whose value is known.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct GivenAnswer {
    /// Path of its row: `given[1]`.
    pub(crate) path: String,
    /// Name of the answer or of the question.
    pub(crate) name: String,
    /// Value, in SI.
    pub(crate) si: f64,
    /// The unit it was typed in.
    pub(crate) unit: Unit,
    /// Standard uncertainty, in SI, where one is typed.
    pub(crate) tolerance: Option<f64>,
}

/// Returns true if a text asks for its value to be found.
pub(crate) fn is_unknown(text: &str) -> bool {
    text.trim_start().starts_with('?')
}

/// An unknown at a name, and the quantity that stands in its place until it is found.
pub(super) fn read(text: &str, name: &str, measure: Option<Measure>) -> Result<(Unknown, Quantity), Text> {
    let typed = text.trim().trim_start_matches('?').trim();
    let (from, to) = match typed.split_once("..") {
        Some((from, to)) => (Some(from.trim()), to.trim()),
        None => (None, typed),
    };
    let measure = measure.map(|measure| measure.meant(to));
    let quantity = |text: &str, own: Option<&Unit>| {
        let read = match (measure, own) {
            (Some(measure), own) => {
                let unit = own.cloned().unwrap_or_else(|| measure.own_unit());
                units::read_quantity(text, &unit, measure.kind())
            }
            (None, Some(unit)) => units::read_quantity(text, unit, units::Kind::of(unit)),
            (None, None) => units::read_any(text),
        };
        let quantity = read.map_err(|error| reading::text(&error))?;
        match measure.and_then(|measure| measure.outside(quantity.si, text)) {
            Some(why) => Err(why),
            None => Ok(quantity),
        }
    };
    let unknown = |start, range| Unknown { name: name.to_owned(), start, range };
    match (from, to) {
        (None, "") => {
            let measure = measure.ok_or("write a range, as in ? 1 kg .. 100 kg: it gives the unit")?;
            let unit = measure.own_unit();
            let si = unit.si(usual(measure));
            Ok((unknown(None, None), Quantity { si, unit, last_place: 0.0 }))
        }
        (None, start) => {
            let start = quantity(start, None)?;
            Ok((unknown(Some(start.si), None), start))
        }
        (Some(from), to) => {
            let to = quantity(to, None)?;
            let from = quantity(from, Some(&to.unit))?;
            if from.si >= to.si {
                return Err(Text::new("the range of an unknown ascends, as in ? 1 kg .. 100 kg"));
            }
            let si = if from.si > 0.0 { (from.si * to.si).sqrt() } else { f64::midpoint(from.si, to.si) };
            Ok((unknown(None, Some([from.si, to.si])), Quantity { si, ..to }))
        }
    }
}

/// A permitted value, in the unit of the field.
fn usual(measure: Measure) -> f64 {
    let unit = measure.own_unit();
    let end = |limit| match limit {
        FieldLimit::None => None,
        FieldLimit::Including(end) | FieldLimit::Excluding(end) => Some(end),
    };
    let (min, max) = (end(measure.min), end(measure.max));
    let middle = min.zip(max).map(|(min, max)| f64::midpoint(min, max));
    let tried = [Some(1.0), middle, min.map(|min| min + 1.0), max.map(|max| max - 1.0)];
    tried.into_iter().flatten().find(|value| measure.outside(unit.si(*value), "").is_none()).unwrap_or(1.0)
}

/// The given answer in the row at a path, by its name and the text of its value.
pub(super) fn given(row: &str, name: &str, text: &str) -> Result<GivenAnswer, FieldError> {
    if name.is_empty() {
        let why = "the name of an answer or a question is needed, for example natural_frequency";
        return Err(FieldError::new(format!("{row}.name"), why));
    }
    let path = format!("{row}.value");
    let plus_minus = ["±", "+/-", "+-"].into_iter().find_map(|sign| text.split_once(sign));
    let (value, tolerance) = plus_minus.map_or((text, None), |(value, tolerance)| (value, Some(tolerance)));
    let (si, unit) = constant(value).map_err(|why| FieldError::new(&path, why))?;
    let tolerance = tolerance.map(|text| -> Result<f64, Text> {
        let (tolerance, of) = constant(text)?;
        let size = match (of.dim == unit.dim, of.dim == units::Dim::NONE) {
            (true, _) => tolerance,
            (false, true) => unit.si(tolerance) - unit.si(0.0),
            (false, false) => {
                return Err(reading::of_another_dimension(text.trim(), of.dim, &unit));
            }
        };
        if size > 0.0 { Ok(size) } else { Err(Text::new("the uncertainty behind ± is above zero")) }
    });
    let tolerance = tolerance.transpose().map_err(|why| FieldError::new(&path, why))?;
    Ok(GivenAnswer { path: row.to_owned(), name: name.to_owned(), si, unit, tolerance })
}

/// The value of a quantity or of an expression without names, in SI, and its unit.
fn constant(text: &str) -> Result<(f64, Unit), Text> {
    if let Ok(quantity) = units::read_any(text) {
        return Ok((quantity.si, quantity.unit));
    }
    let formula = Formula::parse(text, &|_| false).map_err(|error| error.why)?;
    let stop = Stop::new();
    let plain = Plain::new(&stop);
    match evaluate::<&Plain<'_>>(&formula, &|_| Ok(None), &plain).map_err(|error| error.why)? {
        Operand::Number(si, dim) => Ok((si, unit_of(&formula, dim, &|_| None))),
        _ => Err(Text::new("`{text}` is no single number").with("text", text)),
    }
}
