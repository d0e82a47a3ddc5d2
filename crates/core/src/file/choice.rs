//! The choice of an alternative in a file: by its name, by a table of its inputs, or by a value alone where that can be of
//! one alternative only.

use dalembert_units as units;
use toml_edit::{Item, Value as Toml};

use super::{FileNotes, former, plain};
use crate::{
    Field, Shape, Text, Variant, describe,
    path::{self, Segment, segments, step},
};

/// An input as it is named in full, in place of a shorter or a former name.
#[derive(Clone, Debug)]
pub struct NamedInput {
    /// Full path.
    pub path: String,
    /// Text; a number alone in a former alternative has the unit that it had there.
    pub text: String,
    /// The note for the user.
    pub note: Text,
}

/// Path and text in full of an input that is named through a former alternative, or of a value that stands for the only
/// input of an alternative; `None` if the path is the full one.
pub fn named_input(shape: &Shape, path: &str, text: &str) -> Option<NamedInput> {
    if let Some(former) = former::former_input(shape, path, text) {
        return Some(former);
    }
    let (mut inner, mut within_choice) = (*shape, false);
    for segment in segments(path).ok()? {
        let present = inner.present();
        within_choice = matches!((&present, &segment), (Shape::OneOf(_), Segment::Name(_)));
        inner = step(&present, &segment, path).ok()?.1;
    }
    let full = match inner.present() {
        Shape::OneOf(variants) => {
            let variant = of_quantity(variants(), text).or_else(|| namesake(variants(), path, text))?;
            format!("{path}.{}.{}", variant.name, only_field(variant)?.name)
        }
        Shape::Group(fields) if within_choice => match fields() {
            [only] if only.shape.is_leaf() => format!("{path}.{}", only.name),
            _ => return None,
        },
        _ => return None,
    };
    Some(NamedInput { note: note(path, text, &full), path: full, text: text.to_owned() })
}

fn note(path: &str, text: &str, full: &str) -> Text {
    Text::new("{path} = {text}: read as {full}")
        .with("path", path)
        .with("text", text.trim())
        .with("full", full)
}

/// The alternative that a value alone stands for: the only one that has a single input, of the dimension of the value.
fn of_quantity(variants: &'static [Variant], text: &str) -> Option<&'static Variant> {
    let dim = units::quantity_of(text)?.unit.dim;
    let takes = |variant: &&Variant| match only_field(variant).map(|field| field.shape.present()) {
        Some(Shape::Quantity(measure)) => measure.all().any(|measure| measure.own_unit().dim == dim),
        _ => false,
    };
    let mut found = variants.iter().filter(takes);
    found.next().filter(|_| found.next().is_none())
}

/// The alternative that a text which is no quantity stands for, a formula or an unknown: the only one whose single input
/// has the name of the choice, as a quantity has that alternatives were added to.
fn namesake(variants: &'static [Variant], path: &str, text: &str) -> Option<&'static Variant> {
    let name = path.rsplit('.').next()?;
    if text.trim().is_empty() || path::nearest(text, variants.iter().map(|variant| variant.name)).is_some() {
        return None;
    }
    let takes = |variant: &&Variant| {
        only_field(variant)
            .is_some_and(|field| field.name == name && matches!(field.shape.present(), Shape::Quantity(_)))
    };
    let mut found = variants.iter().filter(takes);
    found.next().filter(|_| found.next().is_none())
}

/// The only input of an alternative, if it is one value.
fn only_field(variant: &Variant) -> Option<&'static Field> {
    match (variant.fields)() {
        [only] if only.shape.is_leaf() => Some(only),
        _ => None,
    }
}

/// The place of the alternative that an item stands for, and the only input that it is the value of: of the alternative
/// that it names, or else of the one that takes such a quantity.
pub(super) fn value_alone<'d>(
    item: &'d Item,
    variants: &'static [Variant],
    path: &str,
    reading: &mut FileNotes,
) -> Option<(usize, &'static Field, &'d Item)> {
    let (at, value) = match item.as_table_like() {
        Some(table) if table.len() == 1 => {
            let (name, value) = table.iter().next()?;
            (variants.iter().position(|variant| variant.name == name)?, value)
        }
        _ => {
            let text = plain(item.as_value().filter(|value| is_one_value(value))?);
            // A name is no quantity: to read it as one would take longer than all the rest.
            if variants.iter().any(|variant| variant.name == text) {
                return None;
            }
            let variant = of_quantity(variants, &text).or_else(|| namesake(variants, path, &text))?;
            (variants.iter().position(|known| known.name == variant.name)?, item)
        }
    };
    let text = plain(value.as_value().filter(|value| is_one_value(value))?);
    let (variant, field) = (&variants[at], only_field(&variants[at])?);
    let was = if std::ptr::eq(value, item) { path.to_owned() } else { format!("{path}.{}", variant.name) };
    reading.notes.push(note(&was, &text, &format!("{path}.{}.{}", variant.name, field.name)));
    Some((at, field, value))
}

fn is_one_value(value: &Toml) -> bool {
    matches!(value, Toml::String(_) | Toml::Integer(_) | Toml::Float(_) | Toml::Boolean(_))
}

/// The refusal of an item that chooses no alternative.
pub(super) fn needed(variants: &'static [Variant]) -> Text {
    Text::new("one alternative is needed here: {known}").with("known", describe::forms_of(variants))
}

/// The refusal of a name that is no alternative, with the nearest one, or all in the form in which they are written.
pub(super) fn unknown(name: &str, variants: &'static [Variant]) -> Text {
    let names = || variants.iter().map(|variant| variant.name);
    if path::nearest(name, names()).is_some() {
        return path::unknown("", name, names()).why;
    }
    if units::quantity_of(name).is_some() {
        return needed(variants);
    }
    Text::new("there is no `{name}`; write one of {known}")
        .with("name", path::shortened(name))
        .with("known", describe::forms_of(variants))
}
