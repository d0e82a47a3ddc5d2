//! Drafts written over the items of a file, with comments and order kept.

use toml_edit::{ArrayOfTables, DocumentMut, InlineTable, Item, Table, TableLike, Value as Toml};

use super::{FileNotes, draft_of, former, plain, rows, shorthand};
use crate::{Draft, Shape, table};

pub(super) fn set_text(table: &mut dyn TableLike, key: &str, text: &str) {
    match table.get_mut(key) {
        Some(item) => write_text(item, text),
        None => {
            table.insert(key, Item::Value(text.into()));
        }
    }
}

/// Puts a text in place of a value that says something else, with the comment behind it kept.
fn write_text(item: &mut Item, text: &str) {
    if item.as_value().is_some_and(|value| plain(value) == text) {
        return;
    }
    let mut value: Toml = if text.contains('\n') { text_of_lines(text) } else { text.into() };
    if let Some(old) = item.as_value() {
        *value.decor_mut() = old.decor().clone();
    }
    *item = Item::Value(value);
}

/// A text of several lines, as `"""` lines.
pub(super) fn text_of_lines(text: &str) -> Toml {
    let literal = format!("x = '''\n{text}'''");
    let parsed = if text.contains("'''") { None } else { literal.parse::<DocumentMut>().ok() };
    parsed.and_then(|mut document| document.remove("x")?.into_value().ok()).unwrap_or_else(|| text.into())
}

pub(super) fn write_item(item: &mut Item, draft: &Draft, shape: &Shape) {
    // A shorter form stays where it says the same.
    if let Some(full) = shorthand::in_full(item, shape) {
        if draft_of(&full, shape, "", &mut FileNotes::latest()) == *draft {
            return;
        }
        *item = full;
    }
    match (shape, draft) {
        (Shape::Optional(inner), _) => write_item(item, draft, inner()),
        (Shape::Group(fields), Draft::Group(drafts)) => {
            if item.as_table_like().is_none() {
                *item = Item::Table(Table::new());
            }
            let Some(table) = item.as_table_like_mut() else { return };
            for (field, draft) in fields().iter().zip(drafts) {
                if let Some(item) = table.get_mut(field.name) {
                    former::unwrap(item, field.former);
                }
                match draft {
                    Draft::Absent => {
                        table.remove(field.name);
                    }
                    Draft::Leaf(text) if text.is_empty() && !table.contains_key(field.name) => {}
                    _ => {
                        if !table.contains_key(field.name) {
                            table.insert(field.name, Item::Value("".into()));
                        }
                        if let Some(item) = table.get_mut(field.name) {
                            write_item(item, draft, &field.shape);
                        }
                    }
                }
            }
        }
        (Shape::OneOf(variants), Draft::OneOf(at, fields)) => {
            let Some(variant) = variants().get(*at) else { return };
            if (variant.fields)().is_empty() {
                write_text(item, variant.name);
                return;
            }
            former::rename(item, variant);
            if !item.as_table_like().is_some_and(|table| table.contains_key(variant.name)) {
                let mut table = Table::new();
                table.set_implicit(true);
                table.insert(variant.name, Item::Table(Table::new()));
                *item = Item::Table(table);
            }
            if let Some(inner) = item.as_table_like_mut().and_then(|table| table.get_mut(variant.name)) {
                write_item(inner, fields, &Shape::Group(variant.fields));
            }
        }
        (Shape::Rows { item: inner, .. }, Draft::Rows(rows)) => write_rows(item, rows, inner()),
        (Shape::Table(columns), Draft::Leaf(text)) => {
            write_text(item, &table::with_units(text, columns()).unwrap_or_else(|| text.clone()));
        }
        // The components of a vector may stand in a list.
        (Shape::Vector(..), Draft::Leaf(text))
            if item.as_array().is_some_and(|all| rows::in_brackets(all) == *text) => {}
        (_, Draft::Leaf(text)) => write_text(item, text),
        _ => {}
    }
}

fn write_rows(item: &mut Item, rows: &[Draft], shape: &Shape) {
    if let (Item::Value(Toml::Array(array)), false) = (&mut *item, rows.is_empty()) {
        // A list written on one line stays on one line.
        while array.len() > rows.len() {
            array.remove(array.len() - 1);
        }
        for (n, row) in rows.iter().enumerate() {
            let mut cell = array.get(n).cloned().map_or(Item::None, Item::Value);
            write_item(&mut cell, row, shape);
            let Some(value) = inline(cell) else { continue };
            if n < array.len() {
                array.replace(n, value);
            } else {
                array.push(value);
            }
        }
        return;
    }
    if shape.is_leaf() || rows.is_empty() {
        *item = Item::Value(Toml::Array(toml_edit::Array::new()));
        if !rows.is_empty() {
            write_rows(item, rows, shape);
        }
        return;
    }
    if !item.is_array_of_tables() {
        *item = Item::ArrayOfTables(ArrayOfTables::new());
    }
    let Item::ArrayOfTables(tables) = item else { return };
    while tables.len() > rows.len() {
        tables.remove(tables.len() - 1);
    }
    for (n, row) in rows.iter().enumerate() {
        let mut element = tables.get(n).cloned().map_or_else(|| Item::Table(Table::new()), Item::Table);
        write_item(&mut element, row, shape);
        let table = match element {
            Item::Table(table) => table,
            // An alternative without fields has no table of its own: it is written as its name.
            other => {
                let mut table = Table::new();
                if let Some(name) = other.as_str() {
                    table.insert(name, Item::Value(Toml::InlineTable(InlineTable::new())));
                }
                table
            }
        };
        match tables.get_mut(n) {
            Some(old) => *old = table,
            None => tables.push(table),
        }
    }
}

/// An item as a value on one line.
fn inline(item: Item) -> Option<Toml> {
    match item {
        Item::Value(value) => Some(value),
        Item::Table(table) => Some(Toml::InlineTable(table.into_inline_table())),
        other => other.into_value().ok(),
    }
}
