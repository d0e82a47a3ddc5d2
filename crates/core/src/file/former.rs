//! Alternatives of earlier files that are none any more: quantities of several kinds were alternatives, one for each.
//! What such an alternative holds is read in its place, with its unit after every number alone.

use dalembert_units as units;
use toml_edit::{InlineTable, Item, Table, Value as Toml};

use super::{FileNotes, NamedInput, draft_of as read};
use crate::{
    Draft, Field, Shape, Text, Variant,
    path::{Segment, segments, step},
};

/// The place of a name among former alternatives.
pub(super) fn place(former: &[&str], name: &str) -> Option<usize> {
    former.iter().position(|known| *known == name)
}

/// Draft of a field in whose place former alternatives may stand.
pub(super) fn draft_of_field(item: &Item, field: &Field, path: &str, reading: &mut FileNotes) -> Draft {
    let only = item.as_table_like().filter(|table| table.len() == 1).and_then(|table| table.iter().next());
    match only.and_then(|(name, inner)| Some((name, inner, place(field.former, name)?))) {
        Some((name, inner, place)) => {
            draft_of(inner, &field.shape, [&format!("{path}.{name}"), path], place, reading)
        }
        None => read(item, &field.shape, path, reading),
    }
}

/// Draft of the contents of a former alternative.
pub(super) fn draft_of(
    item: &Item,
    shape: &Shape,
    [was, now]: [&str; 2],
    place: usize,
    reading: &mut FileNotes,
) -> Draft {
    reading.notes.push(note(was, now));
    let outside = reading.kind.replace(place);
    let draft = read(item, shape, now, reading);
    reading.kind = outside;
    draft
}

fn note(was: &str, now: &str) -> Text {
    let note = Text::new("{was}: read as {now}; the units now say what was measured");
    note.with("was", was).with("now", now)
}

/// Today's path and text of an input that is named through a former alternative; `None` if the path has none.
pub(super) fn former_input(shape: &Shape, path: &str, text: &str) -> Option<NamedInput> {
    let (mut shape, mut former, mut kind) = (*shape, &[][..], None);
    let mut now = String::new();
    for mut segment in segments(path).ok()? {
        if let Segment::Name(name) = &segment {
            if let Some(at) = place(former, name) {
                (kind, former) = (Some(at), &[]);
                continue;
            }
            if let Shape::OneOf(variants) = shape.present() {
                let renamed =
                    variants().iter().find_map(|variant| Some((variant.name, place(variant.former, name)?)));
                if let Some((name, at)) = renamed {
                    kind = Some(at);
                    segment = Segment::Name(name.to_owned());
                }
            }
        }
        let present = shape.present();
        let (at, inner) = step(&present, &segment, path).ok()?;
        former = if let Shape::Group(fields) = present { fields()[at].former } else { &[] };
        match segment {
            Segment::Name(name) if now.is_empty() => now = name,
            Segment::Name(name) => now = format!("{now}.{name}"),
            Segment::Row(row) => now = format!("{now}[{}]", row + 1),
        }
        shape = inner;
    }
    kind?;
    let text = with_unit(text.to_owned(), &shape.present(), kind);
    Some(NamedInput { note: note(path, &now), path: now, text })
}

/// A number alone in a former alternative, with the unit that it had there.
pub(super) fn with_unit(text: String, shape: &Shape, kind: Option<usize>) -> String {
    let (Some(place), Shape::Quantity(measure)) = (kind, shape) else { return text };
    let unit = measure.all().nth(place).filter(|_| !measure.others.is_empty()).map(|kind| kind.own_unit());
    match unit {
        Some(unit)
            if !unit.text.is_empty()
                && units::quantity_of(&text).is_some_and(|read| read.unit.text.is_empty()) =>
        {
            let number = text.trim();
            if number.parse::<f64>().is_ok() {
                format!("{number} {}", unit.ascii())
            } else {
                format!("({number}) {}", unit.ascii())
            }
        }
        _ => text,
    }
}

/// Puts what a former alternative holds in its place.
pub(super) fn unwrap(item: &mut Item, former: &[&str]) {
    let Some(table) = item.as_table_like_mut() else { return };
    let known = former.iter().find(|name| table.contains_key(name));
    if let Some(inner) = known.and_then(|name| table.remove(name)) {
        *item = inner;
    }
}

/// Gives what a former alternative holds the name of today's.
pub(super) fn rename(item: &mut Item, variant: &Variant) {
    let Some(table) = item.as_table_like_mut() else { return };
    let known = variant.former.iter().find(|name| table.contains_key(name));
    let Some(inner) = known.and_then(|name| table.remove(name)) else { return };
    *item = match inner {
        Item::Value(value) => {
            let mut table = InlineTable::new();
            table.insert(variant.name, value);
            Item::Value(Toml::InlineTable(table))
        }
        inner => {
            let mut table = Table::new();
            table.set_implicit(true);
            table.insert(variant.name, inner);
            Item::Table(table)
        }
    };
}
