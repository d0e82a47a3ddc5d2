//! Alternatives of earlier files that are none any more: quantities of several kinds were alternatives, one for each.
//! What such an alternative holds is read in its place, with its unit after every number alone.

use dalembert_units as units;
use toml_edit::{InlineTable, Item, Table, Value as Toml};

use super::{FileNotes, draft_of as read};
use crate::{Draft, Field, Shape, Text, Variant};

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
    let note = Text::new("{was}: read as {now}; the units now say what was measured");
    reading.notes.push(note.with("was", was).with("now", now));
    let outside = reading.kind.replace(place);
    let draft = read(item, shape, now, reading);
    reading.kind = outside;
    draft
}

/// A number alone in a former alternative, with the unit that it had there.
pub(super) fn with_unit(text: String, shape: &Shape, reading: &FileNotes) -> String {
    let (Some(place), Shape::Quantity(measure)) = (reading.kind, shape) else { return text };
    let unit = measure.all().nth(place).filter(|_| !measure.others.is_empty()).map(|kind| kind.own_unit());
    match unit {
        Some(unit)
            if !unit.text.is_empty()
                && units::read_any(&text).is_ok_and(|read| read.unit.text.is_empty()) =>
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
