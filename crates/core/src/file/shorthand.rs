//! Shorter forms of lists and of their rows, written in full: rows under their names, `{ A = …, B = … }`; the values of a
//! list in one text, `"A; B"` or `"(40; 30) mm"`; a row by its first inputs in their order, by the value of its only input,
//! or as a point in place.

use toml_edit::{Array, InlineTable, Item, TableLike, Value as Toml};

use crate::{
    Field, Shape,
    placed::{self, PlacedFields},
};

/// A shorter form of a list or of its rows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ShortForm {
    /// The rows under their names.
    ByName,
    /// One text with all values.
    InOneText,
    /// A row as a list of its first inputs.
    RowInOrder,
    /// A row as one value.
    RowOfValue,
}

impl ShortForm {
    /// Those of a list of such rows.
    pub fn of_rows(row: &Shape) -> Vec<Self> {
        let Shape::Group(fields) = row else {
            return if row.is_leaf() { vec![Self::InOneText] } else { Vec::new() };
        };
        let mut forms = vec![Self::RowInOrder];
        if is_named(fields()) {
            forms.push(Self::ByName);
        }
        let is_one_value = matches!(fields(), [only] if only.shape.is_leaf());
        if is_one_value || PlacedFields::of(row).is_some() {
            forms.push(Self::RowOfValue);
        }
        forms
    }
}

/// Returns true if rows of these fields are called by their first one.
fn is_named(fields: &[Field]) -> bool {
    fields.first().is_some_and(|field| field.name == "name")
}

/// An item in full; `None` if it is written so. `shape` is that of the item, which may be a row of a list.
pub(super) fn in_full(item: &Item, shape: &Shape) -> Option<Item> {
    match shape {
        Shape::Rows { item: row, .. } if item.is_table_like() => rows_by_name(item.as_table_like()?, row()),
        Shape::Rows { item: row, .. } if row().is_leaf() => Some(list(values(item.as_str()?))),
        Shape::Group(fields) => match item.as_value()? {
            value if value.is_inline_table() => None,
            Toml::Array(values) => row_in_order(values, fields()),
            value => row_of_value(value, fields(), shape),
        },
        _ => None,
    }
}

/// Rows under their names, as a list of rows with a name.
fn rows_by_name(table: &dyn TableLike, shape: &Shape) -> Option<Item> {
    let Shape::Group(fields) = shape else { return None };
    if !is_named(fields()) {
        return None;
    }
    let mut rows = Array::new();
    for (name, item) in table.iter() {
        let full = match item.as_array() {
            Some(values) => row_in_order(&with_first(name, values), fields()),
            None => in_full(item, shape),
        };
        let mut row = match full.as_ref().unwrap_or(item) {
            Item::Table(table) => table.clone().into_inline_table(),
            other => other.as_inline_table()?.clone(),
        };
        row.insert("name", name.into());
        rows.push_formatted(Toml::InlineTable(row));
    }
    Some(Item::Value(Toml::Array(rows)))
}

/// A row by its first inputs in their order; `None` where there are more values than inputs.
fn row_in_order(values: &Array, fields: &'static [Field]) -> Option<Item> {
    let named = values.iter().zip(fields).map(|(value, field)| (field.name, value.clone()));
    (values.len() <= fields.len()).then(|| Item::Value(Toml::InlineTable(named.collect())))
}

fn with_first(name: &str, values: &Array) -> Array {
    std::iter::once(name.into()).chain(values.iter().cloned()).collect()
}

/// The values of a list that are written in one text. A unit behind a bracket is that of each.
fn values(text: &str) -> Vec<String> {
    let (inside, unit) = match text.trim().strip_prefix('(').and_then(|rest| rest.rsplit_once(')')) {
        Some((inside, unit)) => (inside, unit.trim()),
        None => (text, ""),
    };
    let one = |value: &str| format!("{} {unit}", value.trim()).trim_end().to_owned();
    inside.split(';').map(one).filter(|value| !value.is_empty()).collect()
}

fn list(values: Vec<String>) -> Item {
    Item::Value(Toml::Array(values.into_iter().collect()))
}

/// A row of which a value alone is written: a point in place, or the only input.
fn row_of_value(value: &Toml, fields: &'static [Field], shape: &Shape) -> Option<Item> {
    let mut row = InlineTable::new();
    if let (Some(point), Some(text)) = (PlacedFields::of(shape), value.as_str()) {
        let (carrier, position) = placed::split(text)?;
        let [_, on, at] = point.places.map(|place| fields[place].name);
        if !carrier.is_empty() {
            let variant = &point.carriers()[point.carrier(carrier)?];
            let value = match (variant.fields)() {
                [] => carrier.into(),
                [only, ..] => table_of(variant.name, table_of(only.name, carrier.into())),
            };
            row.insert(on, value);
        }
        row.insert(at, position.into());
    } else {
        let [only] = fields else { return None };
        if !only.shape.is_leaf() {
            return None;
        }
        row.insert(only.name, value.clone());
    }
    Some(Item::Value(Toml::InlineTable(row)))
}

/// A table with one key.
fn table_of(key: &str, value: Toml) -> Toml {
    Toml::InlineTable([(key, value)].into_iter().collect())
}
