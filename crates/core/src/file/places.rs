//! Places in the text of a problem file: ranges of bytes and lines.

use std::ops::Range;

use toml_edit::{Document, Item, Table, Value as Toml};

use super::linked;
use crate::{
    FieldError,
    path::{self, Segment},
};

/// Byte ranges of the fields of errors in the text of a problem file: the value, or the smallest enclosing part.
pub fn locate<'e>(text: &str, errors: impl IntoIterator<Item = &'e FieldError>) -> Vec<Option<Range<usize>>> {
    let document = Document::parse(text).ok();
    let root = document.as_ref().map(Document::as_table);
    let located = |error: &FieldError| {
        let root = root?;
        match linked::place(root, &error.path) {
            Some((problem, path)) => place(problem.get("inputs")?, path),
            None => place(root.get("inputs")?, &error.path),
        }
    };
    errors.into_iter().map(located).collect()
}

/// A part of a document.
enum Part<'d> {
    Item(&'d Item),
    Value(&'d Toml),
    Table(&'d Table),
}

impl<'d> Part<'d> {
    fn span(&self) -> Option<Range<usize>> {
        match self {
            Part::Item(item) => item.span(),
            Part::Value(value) => value.span(),
            Part::Table(table) => table.span(),
        }
    }

    fn field(&self, name: &str) -> Option<Part<'d>> {
        match self {
            Part::Item(item) => item.as_table_like()?.get(name),
            Part::Value(value) => return value.as_inline_table()?.get(name).map(Part::Value),
            Part::Table(table) => table.get(name),
        }
        .map(Part::Item)
    }

    fn row(&self, row: usize) -> Option<Part<'d>> {
        match self {
            Part::Item(Item::ArrayOfTables(tables)) => tables.get(row).map(Part::Table),
            Part::Item(item) => item.as_array().and_then(|rows| rows.get(row)).map(Part::Value),
            Part::Value(value) => value.as_array().and_then(|rows| rows.get(row)).map(Part::Value),
            Part::Table(_) => None,
        }
        .or_else(|| self.named_row(row))
    }

    /// A row of a list whose rows stand under their names.
    fn named_row(&self, row: usize) -> Option<Part<'d>> {
        match self {
            Part::Item(item) => item.as_table_like()?.iter().nth(row).map(|(_, item)| Part::Item(item)),
            Part::Value(value) => {
                value.as_inline_table()?.iter().nth(row).map(|(_, value)| Part::Value(value))
            }
            Part::Table(table) => table.iter().nth(row).map(|(_, item)| Part::Item(item)),
        }
    }
}

fn place(inputs: &Item, path: &str) -> Option<Range<usize>> {
    let mut part = Part::Item(inputs);
    let mut found = part.span();
    for segment in path::segments(path).ok()? {
        let next = match segment {
            Segment::Name(name) => part.field(&name),
            Segment::Row(row) => part.row(row),
        };
        let Some(next) = next else { break };
        found = next.span().or(found);
        part = next;
    }
    found
}

/// The line of a place in a text, counted from 1; a place beyond the end is in the last line.
pub fn line_of(text: &str, at: usize) -> usize {
    text.as_bytes()[..at.min(text.len())].split(|byte| *byte == b'\n').count()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_begin_behind_their_ends() {
        let text = "a\nbc\r\n\nd";
        let lines = [(0, 1), (1, 1), (2, 2), (5, 2), (6, 3), (7, 4), (8, 4), (99, 4)];
        assert_eq!(lines.map(|(at, _)| line_of(text, at)), lines.map(|(_, line)| line));
        assert_eq!(line_of("", 0), 1);
    }
}
