//! Values of another program in place of typed texts: numbers, lists, tables and groups as JSON.
//!
//! A number alone is in the unit that the form shows for an empty input ([`Measure::own_unit`]), and is no number without
//! a unit: who writes one means that unit.

use dalembert_core::{Draft, Field, FieldError, Measure, Shape, Text, file};
use serde_json::{Map, Value as Json};

/// Writes the text of one input at its path.
pub(crate) type SetText<'s> = dyn FnMut(&mut Draft, &str, &str) -> Result<(), FieldError> + 's;

/// Writes a value at a path by the texts that it stands for; what cannot be written. A list is a whole list: rows that the
/// draft has there are taken out.
pub(crate) fn write(
    draft: &mut Draft,
    shape: &Shape,
    path: &str,
    value: &Json,
    set: &mut SetText<'_>,
) -> Vec<FieldError> {
    let written = match (value, shape_at(draft, shape, path)) {
        (Json::Object(columns), Some(Shape::Table(fields))) => {
            of_columns(columns, fields(), path).and_then(|text| set(draft, path, &text))
        }
        (Json::Array(rows), Some(Shape::Table(fields))) => set(draft, path, &lines(rows, fields())),
        (Json::Array(parts), Some(Shape::Vector(measure, _))) => {
            let parts: Vec<String> = parts.iter().map(|part| text(part, Some(measure))).collect();
            set(draft, path, &format!("({})", parts.join("; ")))
        }
        (Json::Array(rows), Some(Shape::Rows { .. })) => {
            take_out_rows(draft, shape, path);
            let rows = (1..).zip(rows).map(|(n, row)| (format!("{path}[{n}]"), row));
            return rows.flat_map(|(path, row)| write(draft, shape, &path, row, set)).collect();
        }
        (Json::Array(_), _) => Err(FieldError::new(path, "is one value and no list")),
        (Json::Object(fields), inner) => {
            let is_choice = matches!(inner, Some(Shape::OneOf(_)));
            let field = |(name, value): (&String, &Json)| match value {
                // An alternative without inputs.
                Json::Object(none) if is_choice && none.is_empty() => {
                    set(draft, path, name).err().into_iter().collect()
                }
                value => write(draft, shape, &format!("{path}.{name}"), value, set),
            };
            return fields.iter().flat_map(field).collect();
        }
        (Json::Number(number), _) => {
            // A number alone may stand for the only input of an alternative.
            let named = file::named_input(shape, path, &number.to_string());
            let path = named.map_or_else(|| path.to_owned(), |named| named.path);
            let text = match shape_at(draft, shape, &path) {
                Some(Shape::Quantity(measure)) => text(value, Some(measure)),
                Some(Shape::Count { .. }) => whole(number),
                _ => number.to_string(),
            };
            set(draft, &path, &text)
        }
        (value, _) => set(draft, path, &text(value, None)),
    };
    written.err().into_iter().collect()
}

/// The shape at a path, with the alternatives and rows on the way that are still to be made; `None` where there is none.
pub(crate) fn shape_at(draft: &Draft, shape: &Shape, path: &str) -> Option<Shape> {
    if let Ok((_, inner)) = draft.at(shape, path) {
        return Some(inner.present());
    }
    let mut probe = draft.clone();
    // The way is made before a text is refused that does not fit its end.
    let _ = probe.set(shape, path, "");
    probe.at(shape, path).ok().map(|(_, inner)| inner.present())
}

fn take_out_rows(draft: &mut Draft, shape: &Shape, path: &str) {
    // As above: to write makes the way.
    let _ = draft.set(shape, &format!("{path}[1]"), "");
    if let Ok((rows @ Draft::Rows(_), _)) = draft.at_mut(shape, path) {
        *rows = Draft::Rows(Vec::new());
    }
}

/// The text of a single value; a number is in the unit of the measure.
fn text(value: &Json, measure: Option<Measure>) -> String {
    match value {
        Json::String(text) => text.clone(),
        Json::Number(number) => {
            let number = number.to_string();
            let unit = measure.map(|measure| measure.meant(&number).own_unit().ascii());
            format!("{number} {}", unit.unwrap_or_default()).trim_end().to_owned()
        }
        Json::Bool(flag) => if *flag { "yes" } else { "no" }.to_owned(),
        Json::Null | Json::Array(_) | Json::Object(_) => String::new(),
    }
}

/// A whole number, as which other programs write 3.0 too.
fn whole(number: &serde_json::Number) -> String {
    let text = number.to_string();
    text.strip_suffix(".0").map(str::to_owned).unwrap_or(text)
}

/// A table by its rows: lists of cells, objects with the names of the columns, or lines of text.
fn lines(rows: &[Json], columns: &[Field]) -> String {
    let line = |row: &Json| {
        let cells: Vec<String> = match row {
            Json::Array(cells) => cells.iter().map(|cell| text(cell, None)).collect(),
            Json::Object(cells) => columns
                .iter()
                .map(|column| cells.get(column.name).map_or_else(String::new, |cell| text(cell, None)))
                .collect(),
            row => vec![text(row, None)],
        };
        cells.join("; ")
    };
    let has_numbers = |row: &Json| match row {
        Json::Array(cells) => cells.iter().any(Json::is_number),
        Json::Object(cells) => cells.values().any(Json::is_number),
        _ => false,
    };
    // Numbers alone are in the units of the columns, which a heading says.
    let unit = |column: &Field| column.shape.measure().map_or_else(String::new, |one| one.own_unit().ascii());
    let heading = columns.iter().map(|column| format!("[{}]", unit(column))).collect::<Vec<_>>().join("; ");
    let heading = rows.first().is_some_and(has_numbers).then_some(heading);
    heading.into_iter().chain(rows.iter().map(line)).collect::<Vec<_>>().join("\n")
}

/// A table by its columns: a list of cells under the name of each.
fn of_columns(
    cells: &Map<String, Json>,
    columns: &'static [Field],
    path: &str,
) -> Result<String, FieldError> {
    let known = || columns.iter().map(|column| column.name).collect::<Vec<_>>().join(", ");
    let column = |field: &Field| match cells.get(field.name) {
        Some(Json::Array(cells)) => Ok(cells),
        _ => {
            let why =
                Text::new("a list of numbers is needed for each column: {known}").with("known", known());
            Err(FieldError::new(path, why))
        }
    };
    if let Some(name) = cells.keys().find(|name| columns.iter().all(|column| column.name != **name)) {
        let why = Text::new("there is no `{name}`; write one of {known}").with("name", name);
        return Err(FieldError::new(path, why.with("known", known())));
    }
    let all: Vec<&Vec<Json>> = columns.iter().map(column).collect::<Result<_, _>>()?;
    let rows = all.first().map_or(0, |column| column.len());
    if let Some((field, other)) = columns.iter().zip(&all).find(|(_, column)| column.len() != rows) {
        let why = Text::new("column {name} has {have} numbers and the first {want}; give as many in each");
        let why = why.with("name", field.name).with("have", other.len()).with("want", rows);
        return Err(FieldError::new(path, why));
    }
    let row = |n: usize| Json::Array(all.iter().map(|column| column[n].clone()).collect());
    Ok(lines(&(0..rows).map(row).collect::<Vec<_>>(), columns))
}
