//! Draft of a problem: the texts of its inputs, readable or not.
//!
//! Form, file and command line all make a draft; [`Draft::read`] is the one way from there to a [`Record`],
//! and reports every error at once.

mod references;
mod repairs;

pub(crate) use references::read_references;
pub use repairs::repairs;

use dalembert_units::{self as units, Style};

use crate::{
    Field, FieldError, Measure, Record, Shape, Text, Value,
    cell::{CellFormula, HeadingWords, add_fault, of_line},
    definitions::{self, AXES, Pending, has_unknown, is_unknown},
    gravity, kinds,
    path::{Segment, segments, step, unknown},
    reading, table,
};

/// The longest text of one line that is read, in bytes.
const LONGEST_LINE: usize = 1_000;

/// Texts in the shape of a problem's inputs.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Draft {
    /// Text of one line; a table is one text of several lines.
    Leaf(String),
    /// The fields of a group, in the order of its fields.
    Group(Vec<Draft>),
    /// The chosen alternative, by its place, and the group of its fields.
    OneOf(usize, Box<Draft>),
    /// The items of a list.
    Rows(Vec<Draft>),
    /// An optional input that is left out, or a one-of of which no alternative is chosen yet.
    Absent,
}

impl Draft {
    /// A draft with every default filled in, but for gravity, which is left to the problem; everything else is empty, and
    /// no choice is made.
    pub fn blank(shape: &Shape) -> Draft {
        match shape {
            Shape::Group(fields) => Draft::blank_fields(fields()),
            Shape::Rows { item, min, .. } => Draft::Rows(vec![Draft::blank(item()); *min]),
            Shape::Optional(_) | Shape::OneOf(_) => Draft::Absent,
            _ => Draft::Leaf(String::new()),
        }
    }

    /// An alternative of a one-of, by its place, with its fields blank.
    pub fn alternative(shape: &Shape, at: usize) -> Draft {
        Draft::OneOf(at, Box::new(Draft::blank_fields(shape.fields(Some(at)))))
    }

    /// The same draft with the first alternative where none is chosen: for a form, which shows what it fills in.
    #[must_use]
    pub fn with_first_alternatives(self, shape: &Shape) -> Draft {
        match (shape, self) {
            (Shape::Optional(_), Draft::Absent) => Draft::Absent,
            (Shape::Optional(inner), draft) => draft.with_first_alternatives(inner()),
            (Shape::OneOf(_), Draft::Absent) => Draft::alternative(shape, 0).with_first_alternatives(shape),
            (Shape::OneOf(_), Draft::OneOf(at, fields)) => {
                let fields = match *fields {
                    Draft::Group(drafts) => filled(shape.fields(Some(at)), drafts),
                    other => other,
                };
                Draft::OneOf(at, Box::new(fields))
            }
            (Shape::Group(fields), Draft::Group(drafts)) => filled(fields(), drafts),
            (Shape::Rows { item, .. }, Draft::Rows(rows)) => {
                Draft::Rows(rows.into_iter().map(|row| row.with_first_alternatives(item())).collect())
            }
            (_, draft) => draft,
        }
    }

    /// Number of texts that differ between two drafts of a problem. Another alternative, or another number of rows,
    /// counts for two.
    pub fn apart(&self, other: &Draft) -> usize {
        match (self, other) {
            (Draft::Leaf(a), Draft::Leaf(b)) => usize::from(a != b),
            (Draft::Absent, Draft::Absent) => 0,
            // An optional text is put in or left out.
            (Draft::Leaf(_), Draft::Absent) | (Draft::Absent, Draft::Leaf(_)) => 1,
            (Draft::OneOf(a, fields), Draft::OneOf(b, others)) if a == b => fields.apart(others),
            (Draft::Group(a), Draft::Group(b)) | (Draft::Rows(a), Draft::Rows(b)) if a.len() == b.len() => {
                a.iter().zip(b).map(|(a, b)| a.apart(b)).sum()
            }
            _ => 2,
        }
    }

    /// The numbers that are written without a unit where one is needed, with the unit that they are taken in. Zero is
    /// zero in every unit.
    pub fn without_unit(&self, shape: &Shape) -> Vec<FieldError> {
        let mut found = Vec::new();
        without_unit(self, shape, "", &mut found);
        found
    }

    /// The texts that give this record again.
    pub fn of_record(record: &Record) -> Draft {
        Draft::Group(record.values.iter().map(of_value).collect())
    }

    /// Reads the draft: the record, or every error. `shape` is that of the whole problem.
    pub fn read(&self, shape: &Shape) -> Result<Record, Vec<FieldError>> {
        let mut faults = Faults::default();
        let filled = gravity::filled(self, shape);
        let Value::Group(mut record) = read(&filled, shape, "", &mut faults) else {
            return Err(vec![FieldError::new("", "a group of inputs is needed")]);
        };
        let Faults { mut errors, pending, headings } = faults;
        definitions::plan(&mut record, pending, &headings, &mut errors);
        read_references(&mut record, "", &mut errors);
        if errors.is_empty() { Ok(record) } else { Err(errors) }
    }

    /// The part at a path such as `masses[1].radius`, and its shape.
    pub fn at(&self, shape: &Shape, path: &str) -> Result<(&Draft, Shape), FieldError> {
        let (mut draft, mut shape) = (self, *shape);
        for segment in segments(path)? {
            shape = shape.present();
            let (at, inner) = step(&shape, &segment, path)?;
            draft = match draft {
                Draft::OneOf(chosen, fields) if *chosen == at => fields,
                Draft::Group(all) | Draft::Rows(all) => all.get(at).ok_or_else(|| no_row(path, all.len()))?,
                _ => {
                    return Err(FieldError::new(
                        path,
                        "is not an input of the problem with its present options",
                    ));
                }
            };
            shape = inner;
        }
        Ok((draft, shape))
    }

    /// The same, to be changed.
    pub fn at_mut(&mut self, shape: &Shape, path: &str) -> Result<(&mut Draft, Shape), FieldError> {
        let (mut draft, mut shape) = (self, *shape);
        for segment in segments(path)? {
            shape = shape.present();
            let (at, inner) = step(&shape, &segment, path)?;
            draft = draft.child_mut(at, path)?;
            shape = inner;
        }
        Ok((draft, shape))
    }

    /// Writes a text at a path, making rows, alternatives and optional inputs on the way as needed.
    ///
    /// At a one-of the text is the name of the alternative; an optional input is left out by an empty text. A component of
    /// a vector is written into the text of the whole.
    pub fn set(&mut self, shape: &Shape, path: &str, text: &str) -> Result<(), FieldError> {
        let (mut draft, mut shape) = (self, *shape);
        for segment in segments(path)? {
            if let (Shape::Optional(inner), Draft::Absent) = (&shape, &*draft) {
                *draft = Draft::blank(inner());
            }
            shape = shape.present();
            if let (Shape::Vector(measure, len), Segment::Name(axis), Draft::Leaf(typed)) =
                (&shape, &segment, &mut *draft)
                && let Some(axis) = AXES.iter().position(|known| known == axis).filter(|axis| axis < len)
            {
                *typed = with_component(typed, (*measure, *len), axis, text)
                    .map_err(|why| FieldError::new(path, why))?;
                return Ok(());
            }
            let (at, inner) = step(&shape, &segment, path)?;
            match (&shape, &mut *draft) {
                (Shape::OneOf(_), Draft::OneOf(chosen, _)) if *chosen == at => {}
                (Shape::OneOf(_), place) => *place = Draft::alternative(&shape, at),
                (Shape::Rows { most, .. }, Draft::Rows(all)) if at == all.len() => {
                    if at >= *most {
                        return Err(FieldError::new(path, too_many_rows(at + 1, *most)));
                    }
                    all.push(Draft::blank(&inner));
                }
                _ => {}
            }
            draft = draft.child_mut(at, path)?;
            shape = inner;
        }
        *draft = written(&shape, text, path)?;
        Ok(())
    }

    fn child_mut(&mut self, at: usize, path: &str) -> Result<&mut Draft, FieldError> {
        match self {
            Draft::OneOf(chosen, fields) if *chosen == at => Ok(fields),
            Draft::Group(all) | Draft::Rows(all) => {
                let rows = all.len();
                all.get_mut(at).ok_or_else(|| no_row(path, rows))
            }
            _ => Err(FieldError::new(path, "is not an input of the problem with its present options")),
        }
    }

    fn blank_fields(fields: &[Field]) -> Draft {
        let blank = |field: &Field| match field.default {
            Some(text) if !gravity::is_gravity(field) => {
                written(&field.shape, text, field.name).unwrap_or_else(|_| Draft::blank(&field.shape))
            }
            _ => Draft::blank(&field.shape),
        };
        Draft::Group(fields.iter().map(blank).collect())
    }
}

/// Reads a part of a problem: its value, errors, and the texts that may be formulas. `path` leads to it.
pub(crate) fn read_part(draft: &Draft, shape: &Shape, path: &str) -> (Value, Vec<FieldError>, Vec<Pending>) {
    let mut faults = Faults::default();
    let value = read(draft, shape, path, &mut faults);
    (value, faults.errors, faults.pending)
}

/// Reads one leaf as it is typed.
pub fn read_leaf(text: &str, shape: &Shape, path: &str) -> Result<Value, Vec<FieldError>> {
    let mut faults = Faults::default();
    let value = leaf(text, shape, path, &mut faults);
    for pending in faults.pending {
        add_fault(&mut faults.errors, pending.error);
    }
    if faults.errors.is_empty() { Ok(value) } else { Err(faults.errors) }
}

/// The text that gives this value again, for a leaf; exact, in ASCII.
pub fn leaf_text(value: &Value) -> String {
    let style = Style { digits: 15, ascii: true, ..Style::default() };
    match value {
        Value::Quantity(quantity) => units::write_quantity(quantity.si, &quantity.unit, style),
        Value::Vector(vector) => units::write_components(&vector.si[..vector.len], &vector.unit, style),
        Value::Text(text) | Value::Reference { name: text, .. } => text.clone(),
        Value::Flag(flag) => if *flag { "yes" } else { "no" }.into(),
        Value::Count(count) => count.to_string(),
        Value::Table(table) => table::text(table),
        Value::Absent | Value::OneOf { .. } | Value::Group(_) | Value::Rows(_) => String::new(),
    }
}

/// The draft that a text makes: of a one-of, the alternative of that name.
pub(crate) fn written(shape: &Shape, text: &str, path: &str) -> Result<Draft, FieldError> {
    match shape {
        Shape::OneOf(variants) => {
            if is_unknown(text) {
                let known = variants().iter().map(|variant| variant.name).collect::<Vec<_>>().join(", ");
                let why = Text::new("a choice cannot be unknown: write one of {known}").with("known", known);
                return Err(FieldError::new(path, why));
            }
            let at = variants().iter().position(|variant| variant.name == text.trim());
            let at =
                at.ok_or_else(|| unknown(path, text.trim(), variants().iter().map(|variant| variant.name)))?;
            Ok(Draft::alternative(shape, at))
        }
        Shape::Optional(_) if text.trim().is_empty() => Ok(Draft::Absent),
        Shape::Optional(inner) => written(inner(), text, path),
        Shape::Group(fields) => Err(several(path, fields())),
        Shape::Rows { item, .. } => match item().present() {
            Shape::Group(fields) => Err(several(&format!("{path}[1]"), fields())),
            _ => {
                let why = Text::new("is a list; name a row, as in {row}").with("row", format!("{path}[1]"));
                Err(FieldError::new(path, why))
            }
        },
        _ => Ok(Draft::Leaf(text.to_owned())),
    }
}

/// The text of a vector with another component at an axis, each with its unit.
fn with_component(
    typed: &str,
    (measure, len): (Measure, usize),
    axis: usize,
    text: &str,
) -> Result<String, Text> {
    let own = measure.own_unit();
    let (si, unit) = if typed.trim().is_empty() {
        ([0.0; 3], own)
    } else {
        let vector = units::read_vector(typed, &own, measure.kind(), len);
        let vector = vector.map_err(|error| reading::text(&error))?;
        (vector.si, vector.unit)
    };
    let style = Style { digits: 15, ascii: true, ..Style::default() };
    let mut parts = si[..len].iter().map(|si| units::write_quantity(*si, &unit, style)).collect::<Vec<_>>();
    let is_bare = !text.contains(char::is_alphabetic) && !is_unknown(text);
    parts[axis] = if is_bare { format!("{} {}", text.trim(), unit.ascii()) } else { text.trim().to_owned() };
    Ok(format!("({})", parts.join("; ")))
}

fn several(path: &str, fields: &[Field]) -> FieldError {
    let names: Vec<String> = fields.iter().map(|field| format!("{path}.{}", field.name)).collect();
    let why = Text::new("holds several inputs; name one of them: {known}");
    FieldError::new(path, why.with("known", names.join(", ")))
}

/// The fields of a group, with the first alternative where none is chosen.
fn filled(fields: &'static [Field], drafts: Vec<Draft>) -> Draft {
    let fields = fields.iter().zip(drafts);
    Draft::Group(fields.map(|(field, draft)| draft.with_first_alternatives(&field.shape)).collect())
}

fn without_unit(draft: &Draft, shape: &Shape, path: &str, found: &mut Vec<FieldError>) {
    match (shape, draft) {
        (Shape::Optional(inner), _) => without_unit(draft, inner(), path, found),
        (Shape::Group(fields), Draft::Group(drafts)) => {
            for (field, draft) in fields().iter().zip(drafts) {
                without_unit(draft, &field.shape, &join(path, field.name), found);
            }
        }
        (Shape::OneOf(variants), Draft::OneOf(at, fields)) => {
            if let Some(variant) = variants().get(*at) {
                without_unit(fields, &Shape::Group(variant.fields), &join(path, variant.name), found);
            }
        }
        (Shape::Rows { item, .. }, Draft::Rows(rows)) => {
            for (n, row) in rows.iter().enumerate() {
                without_unit(row, item(), &format!("{path}[{}]", n + 1), found);
            }
        }
        (Shape::Quantity(measure) | Shape::Vector(measure, _), Draft::Leaf(text)) => {
            let own = measure.meant(text).own_unit();
            if !own.text.is_empty() && is_bare(text, shape) {
                let why = Text::new("no unit; {unit} assumed").with("unit", own.ascii());
                found.push(FieldError::new(path, why));
            }
        }
        _ => {}
    }
}

/// Returns true if a text is a number other than zero, or several, without a unit.
fn is_bare(text: &str, shape: &Shape) -> bool {
    match shape {
        Shape::Vector(_, len) => units::read_vector(text, &units::Unit::ONE, units::Kind::Other, *len)
            .is_ok_and(|vector| vector.unit.text.is_empty() && vector.si != [0.0; 3]),
        _ => units::quantity_of(text).is_some_and(|read| read.unit.text.is_empty() && read.si != 0.0),
    }
}

/// The refusal of a list that is too long.
pub(crate) fn too_many_rows(have: usize, most: usize) -> Text {
    Text::new("{have} rows: at most {most} are accepted here").with("most", most).with("have", have)
}

pub(crate) fn no_row(path: &str, rows: usize) -> FieldError {
    let why = match rows {
        1 => Text::new("there is only one row; the next is {next}"),
        rows => Text::new("there are {rows} rows; the next is {next}").with("rows", rows),
    };
    let why = why.with("next", rows + 1);
    FieldError::new(path, why)
}

fn of_value(value: &Value) -> Draft {
    match value {
        Value::Group(record) => Draft::of_record(record),
        Value::OneOf { variant, fields } => Draft::OneOf(*variant, Box::new(Draft::of_record(fields))),
        Value::Rows(rows) => Draft::Rows(rows.iter().map(of_value).collect()),
        Value::Absent => Draft::Absent,
        leaf => Draft::Leaf(leaf_text(leaf)),
    }
}

/// Faults of the texts of a problem, and texts that may still be formulas.
#[derive(Default)]
struct Faults {
    errors: Vec<FieldError>,
    pending: Vec<Pending>,
    /// The headings of tables that may be rows of names, each with the path of its table.
    headings: Vec<(String, HeadingWords)>,
}

fn read(draft: &Draft, shape: &Shape, path: &str, faults: &mut Faults) -> Value {
    match (shape, draft) {
        (Shape::Optional(_), Draft::Absent) => Value::Absent,
        (Shape::Optional(inner), Draft::Leaf(text)) if inner().is_leaf() && text.trim().is_empty() => {
            Value::Absent
        }
        (Shape::Optional(inner), _) => read(draft, inner(), path, faults),
        (Shape::Group(fields), Draft::Group(drafts)) => {
            const MISSING: &Draft = &Draft::Leaf(String::new());
            const NO_ROWS: &Draft = &Draft::Rows(Vec::new());
            let fields = fields();
            let values = fields.iter().enumerate().map(|(n, field)| {
                let missing = if matches!(field.shape, Shape::Rows { .. }) { NO_ROWS } else { MISSING };
                read(drafts.get(n).unwrap_or(missing), &field.shape, &join(path, field.name), faults)
            });
            Value::Group(Record::new(fields, values.collect()))
        }
        (Shape::OneOf(variants), _) => {
            let chosen = match draft {
                Draft::OneOf(at, fields) => variants().get(*at).map(|variant| (*at, variant, fields)),
                _ => None,
            };
            let Some((at, variant, fields)) = chosen else {
                let known = variants().iter().map(|variant| variant.name).collect::<Vec<_>>().join(", ");
                faults
                    .errors
                    .push(FieldError::new(path, Text::new("write one of {known}").with("known", known)));
                return Value::Absent;
            };
            match read(fields, &Shape::Group(variant.fields), &join(path, variant.name), faults) {
                Value::Group(fields) => Value::OneOf { variant: at, fields },
                _ => Value::Absent,
            }
        }
        (Shape::Rows { item, min, most }, Draft::Rows(drafts)) => {
            if drafts.len() > *most {
                faults.errors.push(FieldError::new(path, too_many_rows(drafts.len(), *most)));
                return Value::Absent;
            }
            if drafts.len() < *min {
                let why = match min {
                    1 => Text::new("at least one row is needed"),
                    min => Text::new("at least {min} rows are needed; so far: {have}")
                        .with("min", min)
                        .with("have", drafts.len()),
                };
                faults.errors.push(FieldError::new(path, why));
            }
            let rows = drafts.iter().enumerate();
            Value::Rows(
                rows.map(|(n, row)| read(row, item(), &format!("{path}[{}]", n + 1), faults)).collect(),
            )
        }
        (shape, Draft::Leaf(text)) if shape.is_leaf() => leaf(text, shape, path, faults),
        _ => {
            faults.errors.push(FieldError::new(path, "is missing"));
            Value::Absent
        }
    }
}

/// The refusal of a number below one, without a unit, where per cent is asked: books print fractions there, 0.05 for 5 %.
fn fraction(text: &str, quantity: &units::Quantity, shape: &Shape) -> Option<Text> {
    let [first, second] = per_cent(text, quantity, shape)?;
    let why = Text::new("`{text}` without a unit can be read in two ways: write `{first}` or `{second}`");
    Some(why.with("text", text.trim()).with("first", first).with("second", second))
}

/// The two readings of such a number: a fraction, and per cent.
fn per_cent(text: &str, quantity: &units::Quantity, shape: &Shape) -> Option<[String; 2]> {
    if quantity.unit.text != "%" || quantity.si.abs() >= 0.01 || !is_bare(text, shape) {
        return None;
    }
    let style = Style { ascii: true, ..Style::default() };
    Some([quantity.si * 100.0, quantity.si].map(|si| units::write_quantity(si, &quantity.unit, style)))
}

fn leaf(text: &str, shape: &Shape, path: &str, faults: &mut Faults) -> Value {
    let mut fail = |why: Text, span| {
        faults.errors.push(FieldError { path: path.into(), why, span });
        Value::Absent
    };
    if !matches!(shape, Shape::Table(_)) {
        if text.len() > LONGEST_LINE {
            let why = Text::new("{have} characters: at most {most} are accepted");
            return fail(why.with("have", text.chars().count()).with("most", LONGEST_LINE), None);
        }
        if let Some(control) = text.chars().find(|c| c.is_control()) {
            let why = Text::new("the character {code} cannot be typed here; remove it");
            return fail(why.with("code", control.escape_unicode()), None);
        }
    }
    let is_text = matches!(shape, Shape::Text | Shape::Table(_));
    if is_unknown(text) && !is_text && !matches!(shape.present(), Shape::Quantity(_) | Shape::Vector(..)) {
        return fail("only a quantity can be unknown: enter a value here".into(), None);
    }
    match shape {
        Shape::Quantity(measure) => {
            let one = measure.meant(text);
            match units::read_quantity(measure.without_letter(text), &one.own_unit(), one.kind()) {
                Ok(quantity) => {
                    match one.outside(quantity.si, text).or_else(|| fraction(text, &quantity, shape)) {
                        Some(why) => fail(why, None),
                        None => Value::Quantity(quantity),
                    }
                }
                Err(err) => {
                    let why = kinds::also(reading::text(&err), *measure);
                    if !text.chars().any(char::is_alphabetic) && !is_unknown(text) {
                        return fail(why, err.span());
                    }
                    let error = FieldError { path: path.into(), why, span: err.span() };
                    faults.pending.push(Pending {
                        path: path.into(),
                        text: text.to_owned(),
                        error,
                        cell: None,
                    });
                    // The value follows, if it is a formula.
                    let unit = one.own_unit();
                    Value::Quantity(units::Quantity { si: f64::NAN, unit, last_place: 0.0 })
                }
            }
        }
        Shape::Vector(measure, len) if has_unknown(text) => {
            match definitions::read_vector(text, path, *measure, *len) {
                Ok((_, vector)) => {
                    let error = FieldError::new(path, "only an input of a problem can be unknown");
                    faults.pending.push(Pending {
                        path: path.into(),
                        text: text.to_owned(),
                        error,
                        cell: None,
                    });
                    Value::Vector(vector)
                }
                Err(why) => fail(why, None),
            }
        }
        Shape::Vector(measure, len) => {
            match units::read_vector(text, &measure.own_unit(), measure.kind(), *len) {
                Ok(vector) => Value::Vector(vector),
                Err(err) if text.chars().any(char::is_alphabetic) => {
                    let error = FieldError { path: path.into(), why: reading::text(&err), span: err.span() };
                    faults.pending.push(Pending {
                        path: path.into(),
                        text: text.to_owned(),
                        error,
                        cell: None,
                    });
                    // The components follow, if it is a formula.
                    let unit = measure.own_unit();
                    Value::Vector(units::VectorQuantity {
                        si: [f64::NAN; 3],
                        len: *len,
                        unit,
                        last_place: 0.0,
                    })
                }
                Err(err) => fail(reading::text(&err), err.span()),
            }
        }
        Shape::Text => Value::Text(text.trim().to_owned()),
        Shape::Flag => match text.trim().to_lowercase().as_str() {
            "yes" | "y" | "true" | "on" | "sim" | "s" => Value::Flag(true),
            "no" | "n" | "false" | "off" | "não" | "nao" => Value::Flag(false),
            other => fail(Text::new("`{text}` is neither yes nor no").with("text", other), None),
        },
        Shape::Count { min, max } => match units::read_count(text) {
            Ok(count) if (*min..=*max).contains(&count) => Value::Count(count),
            Ok(count) => {
                let why = Text::new("{count} is outside the limits; enter an integer from {min} to {max}");
                fail(why.with("count", count).with("min", min).with("max", max), None)
            }
            Err(err) => fail(reading::text(&err), err.span()),
        },
        // Which row it is can only be said when all rows are read.
        Shape::Reference(_) if text.trim().is_empty() => {
            fail("the name of a row is needed here".into(), None)
        }
        Shape::Reference(_) => Value::Reference { name: text.trim().to_owned(), row: usize::MAX },
        Shape::Table(columns) => {
            let read = table::read(text, columns());
            faults.errors.extend(read.faults.into_iter().map(|why| FieldError::new(path, why)));
            for CellFormula { place, text, why } in read.formulas {
                let error = FieldError::new(path, of_line(place.line, why));
                let path = format!("{path}[{}].{}", place.row + 1, columns()[place.column].name);
                faults.pending.push(Pending { path, text, error, cell: Some(place) });
            }
            faults.headings.extend(read.words.map(|words| (path.to_owned(), words)));
            Value::Table(read.table)
        }
        Shape::Optional(inner) => leaf(text, inner(), path, faults),
        Shape::OneOf(_) | Shape::Group(_) | Shape::Rows { .. } => fail("is missing".into(), None),
    }
}

pub(crate) fn join(path: &str, name: &str) -> String {
    if path.is_empty() { name.to_owned() } else { format!("{path}.{name}") }
}
