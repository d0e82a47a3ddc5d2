//! Unknown inputs, tolerances and given answers as they are typed: `? 1 kg .. 100 kg`, `? 2 mm; 3 mm`, `40 kg ± 2 %`,
//! `8.2 Hz ± 0.05`, `minimum`, `< 100 MPa`.

use std::ops::Range;

use dalembert_units::{self as units, Quantity, Unit, VectorQuantity};

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
    /// The values to choose from, in SI, where they are typed: `? 2 mm; 3 mm; 5 mm`.
    pub(crate) choices: Vec<f64>,
    /// True for a component of a vector, which may have either sign.
    pub(crate) is_component: bool,
}

/// A tolerance of an input or a definition: `40 kg ± 2 %`.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Tolerance {
    /// The path of the input, or the name of the definition.
    pub(crate) name: String,
    /// Half the width, as a share of the value or in SI.
    pub(crate) width: Width,
}

/// Half the width of a tolerance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Width {
    /// A share of the value.
    Share(f64),
    /// A difference, in SI.
    Difference(f64),
}

impl Width {
    /// Half the width at a value, in SI.
    pub(crate) fn at(self, si: f64) -> f64 {
        match self {
            Width::Share(share) => share * si.abs(),
            Width::Difference(difference) => difference,
        }
    }
}

/// Requirement of an answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Goal {
    /// Given value.
    Value,
    /// Upper limit.
    AtMost,
    /// Lower limit.
    AtLeast,
    /// Value as small as possible.
    Minimum,
    /// Value as large as possible.
    Maximum,
}

impl Goal {
    /// Returns true if the answer is to be as small or as large as can be.
    pub fn is_extreme(self) -> bool {
        matches!(self, Goal::Minimum | Goal::Maximum)
    }

    /// Returns true if the answer has a limit.
    pub fn is_limit(self) -> bool {
        matches!(self, Goal::AtMost | Goal::AtLeast)
    }
}

/// An answer that something is required of.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct GivenAnswer {
    /// Path of its row: `given[1]`.
    pub(crate) path: String,
    /// Name of the answer or of the question.
    pub(crate) name: String,
    pub(crate) goal: Goal,
    /// Value or limit, in SI; 0 where the answer is to be an extreme.
    pub(crate) si: f64,
    /// The unit it was typed in; that of a pure number where the answer is to be an extreme.
    pub(crate) unit: Unit,
    /// Standard uncertainty, in SI, where one is typed.
    pub(crate) tolerance: Option<f64>,
}

/// Returns true if a text asks for its value to be found.
pub(crate) fn is_unknown(text: &str) -> bool {
    text.trim_start().starts_with('?')
}

/// Returns true if a text asks for its value, or for a component of it, to be found.
pub fn has_unknown(text: &str) -> bool {
    text.contains('?')
}

/// An unknown component in the text of a vector: `? 0 .. 10` of `(? 0 .. 10; 0; 3) m/s`.
struct UnknownComponent<'t> {
    place: Range<usize>,
    axis: usize,
    /// The ends of its range, or one value to begin with, as typed.
    typed: Vec<&'t str>,
}

/// The unknown components of a vector at a path, and the vector that stands in their place until they are found.
pub(crate) fn read_vector(
    text: &str,
    path: &str,
    measure: Measure,
    len: usize,
) -> Result<(Vec<Unknown>, VectorQuantity), Text> {
    let parts = unknown_components(text)?;
    let own = measure.own_unit();
    // The vector with the first or the last of what was typed for each component in its place.
    let read = |end: fn(&UnknownComponent<'_>) -> String| {
        let with = |unit: &str| {
            let (mut whole, mut at) = (String::new(), 0);
            for part in &parts {
                let value = end(part);
                whole += &text[at..part.place.start];
                match &*value {
                    "" => whole.extend(["1", unit]),
                    // Behind the sign of a term along an axis no other one may stand.
                    value if value.starts_with(['-', '−']) => whole.extend(["(", value, ")"]),
                    value => whole += value,
                }
                at = part.place.end;
            }
            whole += &text[at..];
            units::read_vector(&whole, &own, measure.kind(), len)
        };
        let read = match with("") {
            // Every other component has its unit.
            Err(units::ReadError::MixedComponents { .. }) => with(&format!(" {}", own.ascii())),
            read => read,
        };
        read.map_err(|error| reading::text(&error))
    };
    let low = read(|part| {
        let (first, last) =
            (part.typed.first().copied().unwrap_or(""), part.typed.last().copied().unwrap_or(""));
        // `? 0 .. 10 m/s`
        let unit = if first.contains(char::is_alphabetic) { "" } else { trailing_unit(last) };
        if first == last { first.to_owned() } else { format!("{first} {unit}").trim_end().to_owned() }
    })?;
    let mut vector = read(|part| part.typed.last().copied().unwrap_or("").to_owned())?;
    let mut unknowns = Vec::new();
    for part in &parts {
        let [from, to] = [low.si[part.axis], vector.si[part.axis]];
        let (start, range) = match part.typed.len() {
            0 => (None, None),
            1 => (Some(to), None),
            _ if from < to => (None, Some([from, to])),
            _ => return Err(Text::new("the range of an unknown ascends, as in ? 1 kg .. 100 kg")),
        };
        if range.is_some() {
            vector.si[part.axis] = f64::midpoint(from, to);
        }
        let name = format!("{path}.{}", AXES[part.axis]);
        unknowns.push(Unknown { name, start, range, choices: Vec::new(), is_component: true });
    }
    Ok((unknowns, vector))
}

/// The unit that a quantity ends in, as it is written.
fn trailing_unit(text: &str) -> &str {
    let starts = text.char_indices().filter(|(_, c)| c.is_alphabetic() || matches!(c, '°' | '%'));
    let mut units = starts.map(|(at, _)| &text[at..]);
    units.find(|rest| units::unit(rest).is_ok()).unwrap_or("")
}

/// The names of the components of a vector.
pub(crate) const AXES: [&str; 3] = ["x", "y", "z"];

fn unknown_components(text: &str) -> Result<Vec<UnknownComponent<'_>>, Text> {
    if text.contains(['@', '∠']) {
        return Err(Text::new("an unknown is a component of a vector, as in (?; 0; 3) m/s"));
    }
    let mark = if text.contains(';') { ';' } else { ',' };
    let mut parts = Vec::new();
    let mut at = 0;
    while let Some(start) = text[at..].find('?').map(|found| at + found) {
        let before = text[..start].trim_end();
        if !(before.is_empty() || before.ends_with([mark, '(', '[', '{', '+'])) {
            return Err(Text::new(
                "an unknown component stands alone: write `+ ?` and the sign will be found",
            ));
        }
        let rest = &text[start + 1..];
        let is_lone = |at: usize| {
            let alone = |c: Option<char>| !c.is_some_and(char::is_alphanumeric);
            alone(rest[..at].chars().next_back()) && alone(rest[at + 1..].chars().next())
        };
        let ends =
            |(at, c): &(usize, char)| *c == mark || ")]}".contains(*c) || "ijk".contains(*c) && is_lone(*at);
        let Some((length, end)) = rest.char_indices().find(ends) else {
            return Err(Text::new("name the unknown components of a vector, as in (?; 0; 3) m/s"));
        };
        let axis = "ijk".find(end).unwrap_or_else(|| text[..start].matches(mark).count());
        let is_alone = !"ijk".contains(end) && !text.contains(mark);
        if is_alone || axis >= AXES.len() {
            return Err(Text::new("name the unknown components of a vector, as in (?; 0; 3) m/s"));
        }
        let typed = rest[..length].split("..").map(str::trim).filter(|typed| !typed.is_empty()).collect();
        at = start + 1 + length;
        let kept = rest[..length].trim_end().len();
        parts.push(UnknownComponent { place: start..start + 1 + kept, axis, typed });
    }
    Ok(parts)
}

/// A value that is unknown or has a tolerance, as it is typed.
pub(super) struct TypedValue {
    /// The value, or what stands in its place until it is found.
    pub(super) quantity: Quantity,
    pub(super) unknown: Option<Unknown>,
    pub(super) tolerance: Option<Tolerance>,
}

/// The value at a name where it is unknown or has a tolerance: `? 40 kg`, `40 kg ± 2 %`. `None` for any other text.
pub(super) fn read(text: &str, name: &str, measure: Option<Measure>) -> Result<Option<TypedValue>, Text> {
    let (value, tolerance) = split_tolerance(text);
    let (unknown, quantity) = if is_unknown(value) {
        let (unknown, start) = read_unknown(value, name, measure)?;
        (Some(unknown), start)
    } else if tolerance.is_some() {
        (None, read_value(value, measure.map(|measure| measure.meant(value)), None)?)
    } else {
        return Ok(None);
    };
    let tolerance = tolerance.map(|text| read_tolerance(text, name, &quantity.unit)).transpose()?;
    Ok(Some(TypedValue { quantity, unknown, tolerance }))
}

/// An unknown at a name, and the quantity that stands in its place until it is found.
fn read_unknown(text: &str, name: &str, measure: Option<Measure>) -> Result<(Unknown, Quantity), Text> {
    let typed = text.trim().trim_start_matches('?').trim();
    if typed.contains(';') {
        return read_choices(typed, name, measure);
    }
    let (from, to) = match typed.split_once("..") {
        Some((from, to)) => (Some(from.trim()), to.trim()),
        None => (None, typed),
    };
    let quantity = |text: &str, own: Option<&Unit>| read_value(text, measure.map(|m| m.meant(to)), own);
    let unknown = |start, range| Unknown {
        name: name.to_owned(),
        start,
        range,
        choices: Vec::new(),
        is_component: false,
    };
    match (from, to) {
        (None, "") => {
            let measure = measure.ok_or("write a range, as in ? 1 kg .. 100 kg: it gives the unit")?;
            let unit = measure.own_unit();
            let si = unit.si(usual(measure));
            Ok((unknown(None, None), Quantity { si, unit, last_place: 0.0 }))
        }
        // `? kg`: the unit alone, in which it is shown.
        (None, unit) if units::unit(unit).is_ok() => {
            let text = format!("1 {unit}");
            let error = |error| reading::text(&error);
            let Some(measure) = measure.map(|measure| measure.meant(&text)) else {
                let one = units::read_any(&text).map_err(error)?;
                return Ok((unknown(Some(one.si), None), one));
            };
            let own = measure.own_unit();
            let one = units::read_quantity(&text, &own, measure.kind()).map_err(error)?;
            Ok((unknown(None, None), Quantity { si: own.si(usual(measure)), ..one }))
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

/// A quantity within the limits of a field; a number alone is in the unit `own`, or in that of the field.
fn read_value(text: &str, measure: Option<Measure>, own: Option<&Unit>) -> Result<Quantity, Text> {
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
}

/// The unknown that is one of several values, `2 mm; 3 mm`; a number alone is in the unit of the last one.
fn read_choices(typed: &str, name: &str, measure: Option<Measure>) -> Result<(Unknown, Quantity), Text> {
    let texts: Vec<&str> = typed.split(';').map(str::trim).collect();
    let measure = measure.map(|measure| measure.meant(texts[texts.len() - 1]));
    let last = read_value(texts[texts.len() - 1], measure, None)?;
    let choices: Result<Vec<f64>, Text> =
        texts.iter().map(|text| Ok(read_value(text, measure, Some(&last.unit))?.si)).collect();
    let choices = choices?;
    let first = choices[0];
    let (name, start) = (name.to_owned(), Some(first));
    Ok((Unknown { name, start, range: None, choices, is_component: false }, Quantity { si: first, ..last }))
}

/// The signs between a value and its tolerance.
const PLUS_MINUS: [&str; 3] = ["±", "+/-", "+-"];

/// A text before `±`, and that behind it, where there is one.
pub fn split_tolerance(text: &str) -> (&str, Option<&str>) {
    match PLUS_MINUS.into_iter().find_map(|sign| text.split_once(sign)) {
        Some((value, tolerance)) => (value.trim(), Some(tolerance.trim())),
        None => (text, None),
    }
}

/// The tolerance at a name by its text behind `±`: a share, `2 %`, or a difference; a number alone is in the unit of the
/// value. Of a value in percent, percent is a difference.
fn read_tolerance(text: &str, name: &str, of: &Unit) -> Result<Tolerance, Text> {
    let is_share = text.contains('%') && of.ascii() != "%";
    let (size, width): (f64, fn(f64) -> Width) = if is_share {
        (units::read_any(text).map_err(|error| reading::text(&error))?.si, Width::Share)
    } else {
        (difference(text, of)?, Width::Difference)
    };
    if size > 0.0 {
        Ok(Tolerance { name: name.to_owned(), width: width(size) })
    } else {
        Err(Text::new("the tolerance behind ± is above zero, as in 40 kg ± 2 %"))
    }
}

/// The difference of two values in a unit, in SI, as it is typed; a number alone is in that unit.
fn difference(text: &str, of: &Unit) -> Result<f64, Text> {
    let (size, unit) = constant(text)?;
    match (unit.dim == of.dim, unit.dim == units::Dim::NONE) {
        (_, true) if unit.ascii() == "1" || of.dim != units::Dim::NONE => Ok(of.si(size) - of.si(0.0)),
        (true, _) => Ok(size),
        (false, _) => Err(reading::of_another_dimension(text.trim(), unit.dim, of)),
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
    let (goal, text) = goal(text);
    let given = |si, unit, tolerance| GivenAnswer {
        path: row.to_owned(),
        name: name.to_owned(),
        goal,
        si,
        unit,
        tolerance,
    };
    if goal.is_extreme() {
        return Ok(given(0.0, Unit::ONE, None));
    }
    let (value, tolerance) = split_tolerance(text);
    if tolerance.is_some() && goal.is_limit() {
        return Err(FieldError::new(path, "a limit has no uncertainty: write its value alone"));
    }
    let (si, unit) = constant(value).map_err(|why| FieldError::new(&path, why))?;
    let tolerance = tolerance.map(|text| match difference(text, &unit)? {
        size if size > 0.0 => Ok(size),
        _ => Err(Text::new("the uncertainty behind ± is above zero")),
    });
    let tolerance = tolerance.transpose().map_err(|why| FieldError::new(&path, why))?;
    Ok(given(si, unit, tolerance))
}

/// The requirement that a text begins with, and the rest of it.
fn goal(text: &str) -> (Goal, &str) {
    const SIGNS: [(&str, Goal); 6] = [
        ("<=", Goal::AtMost),
        ("≤", Goal::AtMost),
        ("<", Goal::AtMost),
        (">=", Goal::AtLeast),
        ("≥", Goal::AtLeast),
        (">", Goal::AtLeast),
    ];
    let text = text.trim();
    match text.to_lowercase().as_str() {
        "minimum" | "min" | "mínimo" | "minimo" => (Goal::Minimum, ""),
        "maximum" | "max" | "máximo" | "maximo" => (Goal::Maximum, ""),
        _ => SIGNS
            .into_iter()
            .find_map(|(sign, goal)| Some((goal, text.strip_prefix(sign)?.trim_start())))
            .unwrap_or((Goal::Value, text)),
    }
}

/// The value of a quantity or of an expression without names, in SI, and its unit.
fn constant(text: &str) -> Result<(f64, Unit), Text> {
    if let Ok(quantity) = units::read_any(text) {
        return Ok((quantity.si, quantity.unit));
    }
    let formula = Formula::parse(text, &|_| false).map_err(|error| error.why)?;
    let stop = Stop::new();
    let plain = Plain::new(&stop);
    match evaluate::<&Plain<'_>>(&formula, &|_| Ok(None), &|_| Vec::new(), &plain)
        .map_err(|error| error.why)?
    {
        Operand::Number(si, dim) => Ok((si, unit_of(&formula, dim, &|_| None))),
        _ => Err(Text::new("`{text}` is no single number").with("text", text)),
    }
}
