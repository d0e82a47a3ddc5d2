//! Quantities that may be of one of several kinds: in one problem all are of one.

use dalembert_units::{self as units, Dim, Style};

use crate::{Field, FieldError, Measure, Record, Shape, Text, Value};

/// A field of one of several kinds: its path, its value as it is shown, and the place of its kind.
struct Found {
    path: String,
    shown: String,
    place: usize,
}

/// Every field that is of another kind than the first one.
pub(crate) fn mixed(record: &Record) -> Vec<FieldError> {
    let mut all: Vec<Found> = Vec::new();
    record.leaves(&mut |path, field, value| match value {
        Value::Quantity(quantity) => {
            let shown = || units::write_quantity(quantity.si, &quantity.unit, Style::default());
            all.extend(found(&field.shape, path, quantity.unit.dim, shown));
        }
        Value::Table(table) => {
            let columns: &[Field] = field.shape.present().fields(None);
            for (column, unit) in columns.iter().zip(&table.units) {
                let shown = || format!("[{}]", unit.pretty());
                all.extend(
                    found(&column.shape, path, unit.dim, shown)
                        .map(|found| Found { shown: format!("{} {}", column.name, found.shown), ..found }),
                );
            }
        }
        _ => {}
    });
    let Some((first, others)) = all.split_first() else { return Vec::new() };
    let differing = others.iter().filter(|other| other.place != first.place);
    differing
        .map(|other| {
            let why = Text::new(
                "{shown} is of another kind than {first} = {value}: write all of these in units of one kind",
            );
            let why = why.with("shown", &other.shown).with("first", &first.path).with("value", &first.shown);
            FieldError::new(&other.path, why)
        })
        .collect()
}

fn found(shape: &Shape, path: &str, dim: Dim, shown: impl FnOnce() -> String) -> Option<Found> {
    let measure = shape.measure().filter(|measure| !measure.others.is_empty())?;
    Some(Found { path: path.to_owned(), shown: shown(), place: measure.place(dim)? })
}

/// Reason why a text is of none of the kinds of a field.
pub(crate) fn also(why: Text, measure: Measure) -> Text {
    if measure.others.is_empty() {
        return why;
    }
    Text::new("{why}; units of any of these kinds are accepted: {units}")
        .with_text("why", why)
        .with("units", measure.units_of_kinds(false))
}
