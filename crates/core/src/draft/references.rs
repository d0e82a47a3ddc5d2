//! References of a problem: names of rows of its lists.

use std::collections::{HashMap, HashSet};

use super::{join, read_leaf};
use crate::{
    FieldError, Record, Shape, Text, Value, definitions, kinds,
    path::unknown,
    placed::{self, PlacedFields},
};

/// The most references without a row for which the nearest name is sought.
const MOST_NEAREST: usize = 100;

/// The names of the rows of a top-level list.
pub(crate) struct List {
    pub(crate) field: &'static str,
    /// Those of the rows in their order; a row without a name has an empty one.
    pub(crate) names: Vec<String>,
    /// The first row of each name.
    first: HashMap<String, usize>,
}

impl List {
    /// The first row of a name.
    pub(crate) fn row_of(&self, name: &str) -> Option<usize> {
        self.first.get(name).copied()
    }
}

fn lists(record: &Record) -> Vec<List> {
    let name = |row: &Value| match row {
        Value::Group(record) => match record.get("name") {
            Some(Value::Text(name)) => name.clone(),
            _ => String::new(),
        },
        _ => String::new(),
    };
    let lists = record.fields.iter().zip(&record.values).filter_map(|(field, value)| match value {
        Value::Rows(rows) => {
            let names: Vec<String> = rows.iter().map(name).collect();
            // Of rows of the same name the first stays.
            let first = names.iter().cloned().enumerate().rev().map(|(row, name)| (name, row)).collect();
            Some(List { field: field.name, names, first })
        }
        _ => None,
    });
    lists.collect()
}

/// Finds the rows that references name, and compares what is common to the inputs of a problem; of each of several by
/// itself.
pub(crate) fn read_references(record: &mut Record, path: &str, errors: &mut Vec<FieldError>) {
    let known = lists(record);
    let lists = if place_points(record, &known, path, errors) { lists(record) } else { known };
    let own = definitions::without_linked(record);
    errors.extend(ambiguous(&lists, &own).into_iter().map(|error| within(path, error)));
    if errors.is_empty() {
        errors.extend(kinds::mixed(&own).into_iter().map(|error| within(path, error)));
    }
    resolve_record(record, &lists, path, errors);
    for (field, value) in record.fields.iter().zip(&mut record.values) {
        if let Value::Group(inner) = value
            && definitions::are_of_problem(inner.fields)
        {
            read_references(inner, &join(path, field.name), errors);
        }
    }
}

fn within(path: &str, error: FieldError) -> FieldError {
    FieldError { path: join(path, &error.path), ..error }
}

/// Finds the rows that references name.
fn resolve_record(record: &mut Record, lists: &[List], path: &str, errors: &mut Vec<FieldError>) {
    for (field, value) in record.fields.iter().zip(&mut record.values) {
        if definitions::linked_problem(value).is_none() {
            resolve(value, &field.shape, lists, &join(path, field.name), errors);
        }
    }
}

fn resolve(value: &mut Value, shape: &Shape, lists: &[List], path: &str, errors: &mut Vec<FieldError>) {
    match (value, shape.present()) {
        (Value::Reference { name, row }, Shape::Reference(list)) => {
            match find_row(lists, list, name, errors.len() < MOST_NEAREST) {
                Ok(found) => *row = found,
                // A point described in place has said what is wrong with it.
                Err(_) if name.contains('(') && errors.iter().any(|error| error.path == path) => {}
                Err(why) => errors.push(FieldError::new(path, why)),
            }
        }
        (Value::Group(record), _) => resolve_record(record, lists, path, errors),
        (Value::OneOf { variant, fields }, Shape::OneOf(variants)) => {
            let name = variants().get(*variant).map_or("", |variant| variant.name);
            resolve_record(fields, lists, &join(path, name), errors);
        }
        (Value::Rows(rows), Shape::Rows { item, .. }) => {
            for (n, row) in rows.iter_mut().enumerate() {
                resolve(row, item(), lists, &format!("{path}[{}]", n + 1), errors);
            }
        }
        _ => {}
    }
}

/// Makes a row of each point that is described where the name of a row may stand, as `crank (15; 0) mm`; the row has the
/// description for its name. True if there are such.
fn place_points(record: &mut Record, lists: &[List], path: &str, errors: &mut Vec<FieldError>) -> bool {
    let mut found: Vec<(String, &'static str, String)> = Vec::new();
    record.leaves(&mut |path, field, value| {
        if let (Some(list), Value::Reference { name, .. }) = (refers_to(&field.shape), value)
            && name.contains('(')
            && !found.iter().any(|(_, known, text)| known == &list && text == name)
            && lists.iter().any(|known| known.field == list && known.row_of(name).is_none())
        {
            found.push((path.to_owned(), list, name.clone()));
        }
    });
    let mut placed = false;
    for (at, list, text) in found {
        let Some(place) = record.fields.iter().position(|field| field.name == list) else { continue };
        let Shape::Rows { item, .. } = record.fields[place].shape else { continue };
        let Some(fields) = PlacedFields::of(item()) else { continue };
        let row = placed_row(fields, &text, lists, &join(path, &at));
        match (row, &mut record.values[place]) {
            (Ok(Some(row)), Value::Rows(rows)) => {
                rows.push(row);
                placed = true;
            }
            (Err(why), _) => errors.extend(why),
            _ => {}
        }
    }
    placed
}

/// The row of a point that is described in place; none where nothing is named that carries it.
fn placed_row(
    point: PlacedFields,
    text: &str,
    lists: &[List],
    path: &str,
) -> Result<Option<Value>, Vec<FieldError>> {
    let Some((carrier, position)) = placed::split(text) else { return Ok(None) };
    let Some(variant) = point.carrier(carrier).filter(|_| !carrier.is_empty()) else { return Ok(None) };
    let fields = (point.carriers()[variant].fields)();
    let mut inner = Vec::new();
    if let Some(list) = fields.first().and_then(placed::referred) {
        find_row(lists, list, carrier, true).map_err(|why| vec![FieldError::new(path, why)])?;
        inner.push(Value::Reference { name: carrier.to_owned(), row: usize::MAX });
    }
    let on = Value::OneOf { variant, fields: Record::new(fields, inner) };
    let [name, of, at] = point.places;
    let mut values = vec![Value::Absent; point.fields.len()];
    values[name] = Value::Text(text.to_owned());
    values[of] = on;
    values[at] = read_leaf(position, &point.fields[at].shape, path)?;
    Ok(Some(Value::Group(Record::new(point.fields, values))))
}

/// The row of a top-level list by the text of its field `name`, or by its number; `suggest` seeks the nearest name where
/// there is none.
fn find_row(lists: &[List], list: &str, name: &str, suggest: bool) -> Result<usize, Text> {
    let Some(list) = lists.iter().find(|known| known.field == list) else {
        return Err(Text::new("there are no {list} to name").with("list", list));
    };
    if let Some(row) = list.row_of(name) {
        return Ok(row);
    }
    if let Some(row) = name.parse::<usize>().ok().filter(|row| (1..=list.names.len()).contains(row)) {
        return Ok(row - 1);
    }
    if !suggest {
        return Err(Text::new("there is no `{name}`").with("name", name));
    }
    Err(unknown("", name, list.names.iter().map(String::as_str).filter(|name| !name.is_empty())).why)
}

/// Rows of the same name where an input refers to one of them by it.
fn ambiguous(lists: &[List], record: &Record) -> Vec<FieldError> {
    let mut used: HashSet<(&str, &str)> = HashSet::new();
    record.leaves(&mut |_, field, value| {
        if let (Some(list), Value::Reference { name, .. }) = (refers_to(&field.shape), value) {
            used.insert((list, name));
        }
    });
    let mut errors = Vec::new();
    for list in lists {
        for (row, name) in list.names.iter().enumerate().filter(|(_, name)| !name.is_empty()) {
            let Some(first) = list.row_of(name).filter(|first| *first < row) else { continue };
            if used.contains(&(list.field, name)) {
                let why = Text::new(
                    "row {first} is called `{name}` too, and an input refers to that name: give each its own",
                );
                let why = why.with("first", first + 1).with("name", name);
                errors.push(FieldError::new(format!("{}[{}].name", list.field, row + 1), why));
            }
        }
    }
    errors
}

/// The list that a reference names a row of.
fn refers_to(shape: &Shape) -> Option<&'static str> {
    match shape.present() {
        Shape::Reference(list) => Some(list),
        Shape::Rows { item, .. } => refers_to(item()),
        _ => None,
    }
}
