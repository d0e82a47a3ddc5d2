//! The formats of problem files. What an older format leaves unsaid is written out as that format has it, so that the
//! draft, and every file written from it, says the same in the latest one.

use dalembert_units as units;
use toml_edit::{Item, Table};

use super::{FileError, FileNotes, span};
use crate::{Draft, Field, Shape, Text, UnitSetting, draft, gravity, table, unit_system};

/// A format of problem files. A file that names none is of the first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Format {
    /// `format = 1`, or none named.
    First = 1,
    /// `format = 2`: with the defaults of today.
    Second = 2,
}

impl Format {
    /// The one that is written.
    pub const LATEST: Format = Format::Second;

    /// The format that a file names.
    pub(super) fn of(root: &Table) -> Result<Self, FileError> {
        let wrong = |why: Text| FileError { why, span: span(root, "format") };
        match root.get("format").map(Item::as_integer) {
            None | Some(Some(1)) => Ok(Format::First),
            Some(Some(2)) => Ok(Format::Second),
            Some(Some(found)) if found > Format::LATEST as i64 => Err(wrong(
                Text::new(
                    "this file has format {found}; this program reads formats up to {known}: update the program",
                )
                .with("found", found)
                .with("known", Format::LATEST as i64),
            )),
            Some(_) => Err(wrong(
                Text::new("this is not a format; write `format = {known}`")
                    .with("known", Format::LATEST as i64),
            )),
        }
    }

    /// Writes it at the top of a file.
    pub(super) fn write(self, root: &mut Table) {
        if root.get("format").and_then(Item::as_integer) != Some(self as i64) {
            root.insert("format", toml_edit::value(self as i64));
        }
    }
}

/// Fills a field that a file leaves out, in a blank draft of it, with the default of the file's format.
pub(super) fn left_out(draft: &mut Draft, field: &Field, path: &str, reading: &mut FileNotes) {
    if reading.format >= Format::Second {
        return;
    }
    let gravity = field.default.filter(|_| gravity::is_gravity(field));
    if let Some(before) = field.default_before.or(gravity) {
        *draft = draft::written(&field.shape, before, path)
            .expect("the default of a field is one of its alternatives, or a text");
        reading.notes.push(left_out_note(path, before));
    }
    left_out_fields(draft, &field.shape, path, reading);
}

/// The same for each field inside a blank draft of a shape. The first format took the first alternative of a choice that
/// was left out.
pub(super) fn left_out_fields(draft: &mut Draft, shape: &Shape, path: &str, reading: &mut FileNotes) {
    if reading.format >= Format::Second || matches!((shape, &*draft), (Shape::Optional(_), Draft::Absent)) {
        return;
    }
    let shape = &shape.present();
    if let (Shape::OneOf(variants), Draft::Absent) = (shape, &*draft)
        && let Some(first) = variants().first()
    {
        *draft = Draft::alternative(shape, 0);
        reading.notes.push(left_out_note(path, first.name));
    }
    match (shape, draft) {
        (Shape::Group(fields), Draft::Group(drafts)) => {
            for (field, draft) in fields().iter().zip(drafts) {
                left_out(draft, field, &format!("{path}.{}", field.name), reading);
            }
        }
        (Shape::OneOf(variants), Draft::OneOf(at, fields)) => {
            if let Some(variant) = variants().get(*at) {
                let path = format!("{path}.{}", variant.name);
                left_out_fields(fields, &Shape::Group(variant.fields), &path, reading);
            }
        }
        (Shape::Rows { item, .. }, Draft::Rows(rows)) => {
            for (n, row) in rows.iter_mut().enumerate() {
                left_out_fields(row, item(), &format!("{path}[{}]", n + 1), reading);
            }
        }
        _ => {}
    }
}

/// The text of a table of a file, with the units written out in which the file's format reads numbers alone.
pub(super) fn table_text(
    text: String,
    columns: &'static [Field],
    path: &str,
    reading: &mut FileNotes,
) -> String {
    if reading.format >= Format::Second {
        return text;
    }
    match table::with_units_of_before(&text, columns) {
        Some((text, units)) => {
            let note = Text::new(
                "{path}: no unit in the heading; {units} assumed, as in files without `format = 2`",
            );
            reading.notes.push(note.with("path", path).with("units", units));
            text
        }
        None => text,
    }
}

/// The units of a file that names none: those that its inputs show. A file of the first format keeps the units of the
/// analysis, with a note where that is a difference.
pub(super) fn left_out_units(
    format: Format,
    draft: &Draft,
    shape: &Shape,
    notes: &mut Vec<Text>,
) -> UnitSetting {
    if format >= Format::Second || unit_system::found(draft, shape, true).is_none() {
        return UnitSetting::Auto;
    }
    notes.push(left_out_note("units", &UnitSetting::AsTyped.to_string()));
    UnitSetting::AsTyped
}

fn left_out_note(path: &str, value: &str) -> Text {
    Text::new("{path} omitted: {value} assumed, the default of files without `format = 2`")
        .with("path", path)
        .with("value", value)
}

/// A number of a file of the first format, in which a comma before three digits was a decimal mark.
pub(super) fn with_decimal_commas(
    text: String,
    shape: &Shape,
    path: &str,
    reading: &mut FileNotes,
) -> String {
    let is_number = matches!(shape, Shape::Quantity(_) | Shape::Vector(..));
    if reading.format >= Format::Second || !is_number || units::thousands(&text, ',').is_none() {
        return text;
    }
    let pointed = units::with_point(&text).into_owned();
    let note = Text::new("{path} = {text}: read as {value}, as in every file without `format = 2`");
    reading.notes.push(note.with("path", path).with("text", text).with("value", &pointed));
    pointed
}
