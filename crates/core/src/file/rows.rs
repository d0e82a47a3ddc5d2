//! The rows of a table in a file: lines of text, lists of cells, or tables with the names of the columns.

use std::ops::Range;

use toml_edit::{Item, TableLike, Value as Toml};

use super::plain;
use crate::{Field, Text, describe, path};

/// A table as a user types it, of a text, a list of lists, or a list of tables with the names of the columns.
pub(super) fn table_text(
    item: &Item,
    columns: &'static [Field],
) -> Result<String, (Text, Option<Range<usize>>)> {
    let named = |row: &dyn TableLike, span: Option<Range<usize>>| {
        let names = columns.iter().map(|column| column.name);
        if let Some((key, _)) = row.iter().find(|(key, _)| !columns.iter().any(|column| column.name == *key))
        {
            return Err((path::unknown("", key, names).why, span));
        }
        let cell = |column: &Field| match row.get(column.name).and_then(Item::as_value) {
            Some(value) => Ok(plain(value)),
            None => {
                let why =
                    Text::new("this row has no {column}; a row has {columns}").with("column", column.name);
                Err((why.with("columns", names.clone().collect::<Vec<_>>().join(", ")), span.clone()))
            }
        };
        Ok(columns.iter().map(cell).collect::<Result<Vec<_>, _>>()?.join("; "))
    };
    let rows: Result<Vec<String>, _> = match item {
        Item::ArrayOfTables(rows) => rows.iter().map(|row| named(row, row.span())).collect(),
        Item::Value(Toml::Array(rows)) => {
            let row = |row: &Toml| match row {
                Toml::Array(row) => Ok(cells(row)),
                Toml::InlineTable(row) => named(row, row.span()),
                other => Ok(plain(other)),
            };
            rows.iter().map(row).collect()
        }
        Item::Value(value @ (Toml::InlineTable(_) | Toml::Datetime(_))) => {
            return Err((describe::table(columns), value.span()));
        }
        Item::Value(value) => return Ok(plain(value)),
        _ => return Err((describe::table(columns), item.span())),
    };
    Ok(rows?.join("\n"))
}

/// The components of a vector in a list, as they are typed: `(1; 0; 3 m/s)`.
pub(super) fn in_brackets(array: &toml_edit::Array) -> String {
    format!("({})", cells(array))
}

/// The cells of a list, beside each other.
pub(super) fn cells(array: &toml_edit::Array) -> String {
    array.iter().map(plain).collect::<Vec<_>>().join("; ")
}
