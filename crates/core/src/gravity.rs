//! The gravity of a problem: one, wherever it is asked for.
//!
//! What is left out is what the problem states elsewhere, or else 9.81 m/s², as textbooks have it; 32.2 ft/s² where all
//! lengths, masses and forces of the problem are in US customary units. (The definitions of lbf and kgf have the
//! standard gravity, 9.80665 m/s².)

use std::borrow::Cow;

use dalembert_units::{self as units, Style, Unit};

use crate::{Draft, Field, Record, Shape, Text, Value};

/// The default of every gravity, where units are metric.
pub const METRIC: &str = "9.81 m/s^2";
/// The same where they are US customary.
pub const CUSTOMARY: &str = "32.2 ft/s^2";

/// US customary units of length, mass and force, and what is derived from them.
const CUSTOMARY_UNITS: [&str; 33] = [
    "in", "inch", "inches", "uin", "ft", "foot", "feet", "yd", "mi", "mil", "mils", "thou", "lb", "lbm",
    "lbs", "oz", "slug", "slugs", "slinch", "mph", "lbf", "klbf", "kip", "kips", "ozf", "psi", "kpsi", "ksi",
    "Msi", "psf", "hp", "Btu", "BTU",
];

/// Returns true if a field is the gravity of the problem.
pub fn is_gravity(field: &Field) -> bool {
    let (Shape::Quantity(measure) | Shape::Vector(measure, _)) = field.shape else { return false };
    field.symbol == "g" && measure.unit == "m/s^2" && field.default.is_some()
}

/// Returns true if a value is a default of gravity, along whatever axis.
pub fn is_default(value: &Value) -> bool {
    let si = match value {
        Value::Quantity(quantity) => quantity.si,
        Value::Vector(vector) => vector.si.iter().sum(),
        _ => return false,
    };
    let acceleration = units::unit("m/s^2").expect("an acceleration has a unit");
    let defaults =
        [METRIC, CUSTOMARY].map(|text| units::read_quantity(text, &acceleration, units::Kind::Acceleration));
    defaults.into_iter().flatten().any(|default| default.si == si.abs())
}

/// The draft with the gravity that is left out filled in.
pub(crate) fn filled<'d>(draft: &'d Draft, shape: &Shape) -> Cow<'d, Draft> {
    filled_with(draft, shape, None)
}

/// The gravity that inputs state, as a text.
pub(crate) fn stated(record: &Record) -> Option<String> {
    let mut found = None;
    record.leaves(&mut |_, field, value| {
        if let (true, Value::Quantity(quantity)) = (is_gravity(field), value) {
            let style = Style { digits: 15, ascii: true, ..Style::default() };
            found.get_or_insert_with(|| units::write_quantity(quantity.si, &quantity.unit, style));
        }
    });
    found
}

/// The draft of a part of a problem with the gravity that is left out filled in: the one that the problem states.
pub(crate) fn filled_with<'d>(draft: &'d Draft, shape: &Shape, stated: Option<&'d str>) -> Cow<'d, Draft> {
    let (mut stated, mut missing) = (stated, Vec::new());
    look(draft, shape, (None, String::new()), &mut |path, field, shape, text| {
        let blank = text.trim().is_empty();
        match (field.filter(|field| is_gravity(field)), shape) {
            (Some(field), _) if blank => missing.push((path.to_owned(), field)),
            (Some(_), Shape::Quantity(_)) => stated = stated.or(Some(text)),
            _ => {}
        }
    });
    if missing.is_empty() {
        return Cow::Borrowed(draft);
    }
    let mut systems = Vec::new();
    written(draft, shape, &mut |text, shape| {
        systems.extend(unit_of(text, shape).and_then(|unit| is_customary(&unit)));
    });
    let customary = !systems.is_empty() && !systems.contains(&false);
    let mut draft = draft.clone();
    for (path, field) in missing {
        let default = field.default.unwrap_or(METRIC);
        let default = if customary { in_feet(default) } else { default.to_owned() };
        let text = match (field.shape, stated) {
            (Shape::Quantity(_), Some(stated)) => stated.to_owned(),
            _ => default,
        };
        if let Ok((place, _)) = draft.at_mut(shape, &path) {
            *place = Draft::Leaf(text);
        }
    }
    Cow::Owned(draft)
}

/// Gravity assumed at a path where it is left out.
pub fn of(draft: &Draft, shape: &Shape, path: &str) -> Option<String> {
    match filled(draft, shape).at(shape, path) {
        Ok((Draft::Leaf(text), _)) => Some(text.clone()),
        _ => None,
    }
}

/// The paths of every scalar gravity with the value of the one at `path`; `path` alone where it is none.
pub(crate) fn shared(record: &Record, path: &str) -> Vec<String> {
    let all = scalars(record);
    let value = all.iter().find(|(known, _)| known == path).map(|(_, si)| *si);
    match value {
        Some(value) => all.into_iter().filter(|(_, si)| *si == value).map(|(path, _)| path).collect(),
        None => vec![path.to_owned()],
    }
}

/// The warning that a problem states two.
pub(crate) fn warning(record: &Record) -> Option<Text> {
    let all = scalars(record);
    let (first, value) = all.first()?;
    let (other, second) = all.iter().find(|(_, si)| si != value)?;
    Some(
        Text::new("two values of gravity in one problem: {first} at {path}, {second} at {other}")
            .with_quantity("first", *value, "m/s^2")
            .with_quantity("second", *second, "m/s^2")
            .with("path", first)
            .with("other", other),
    )
}

fn scalars(record: &Record) -> Vec<(String, f64)> {
    let mut found = Vec::new();
    record.leaves(&mut |path, field, value| {
        if let (true, Value::Quantity(quantity)) = (is_gravity(field), value) {
            found.push((path.to_owned(), quantity.si));
        }
    });
    found
}

/// Calls `visit` with each text that somebody wrote, and its shape: gravity is left aside, and so are defaults.
pub(crate) fn written(draft: &Draft, shape: &Shape, visit: &mut impl FnMut(&str, &Shape)) {
    look(draft, shape, (None, String::new()), &mut |_, field, shape, text| {
        let is_default = field.and_then(|field| field.default) == Some(text);
        if !text.trim().is_empty() && !is_default && !field.is_some_and(is_gravity) {
            visit(text, shape);
        }
    });
}

/// The unit that a number or a vector is written in, that of the field where it is written alone; `None` for a formula,
/// and for what cannot be read.
pub(crate) fn unit_of(text: &str, shape: &Shape) -> Option<Unit> {
    match shape {
        Shape::Quantity(measure) => {
            Some(units::read_quantity(text, &measure.own_unit(), measure.kind()).ok()?.unit)
        }
        Shape::Vector(measure, len) => {
            Some(units::read_vector(text, &measure.own_unit(), measure.kind(), *len).ok()?.unit)
        }
        _ => None,
    }
}

/// Returns true if a length, a mass, a force or a quantity derived from them is in US customary units; `None` for any
/// other quantity.
pub(crate) fn is_customary(unit: &Unit) -> Option<bool> {
    let mechanical = unit.dim.length != 0 || unit.dim.mass != 0;
    mechanical.then(|| words(unit).any(is_customary_symbol))
}

/// Returns true for the symbol of a US customary unit.
pub(crate) fn is_customary_symbol(word: &str) -> bool {
    CUSTOMARY_UNITS.contains(&word)
}

/// The symbols that a unit is written with.
pub(crate) fn words(unit: &Unit) -> impl Iterator<Item = &str> {
    unit.text.split(|c: char| !c.is_alphabetic())
}

/// A default, along an axis or not, in US customary units.
pub(crate) fn in_feet(default: &str) -> String {
    default.replace("9.81", "32.2").replace("m/s^2", "ft/s^2")
}

/// Calls `visit` with the path, the field, the shape and the text of every leaf. The items of a list have no field.
fn look<'d>(
    draft: &'d Draft,
    shape: &Shape,
    (field, path): (Option<&'static Field>, String),
    visit: &mut impl FnMut(&str, Option<&'static Field>, &Shape, &'d str),
) {
    let within = |name: &str| if path.is_empty() { name.to_owned() } else { format!("{path}.{name}") };
    match (shape, draft) {
        (Shape::Optional(inner), _) => look(draft, inner(), (field, path), visit),
        (Shape::Group(fields), Draft::Group(drafts)) => {
            for (field, draft) in fields().iter().zip(drafts) {
                look(draft, &field.shape, (Some(field), within(field.name)), visit);
            }
        }
        (Shape::OneOf(variants), Draft::OneOf(at, fields)) => {
            if let Some(variant) = variants().get(*at) {
                look(fields, &Shape::Group(variant.fields), (None, within(variant.name)), visit);
            }
        }
        (Shape::Rows { item, .. }, Draft::Rows(rows)) => {
            for (n, row) in rows.iter().enumerate() {
                look(row, item(), (None, format!("{path}[{}]", n + 1)), visit);
            }
        }
        (_, Draft::Leaf(text)) => visit(&path, field, shape, text),
        _ => {}
    }
}
