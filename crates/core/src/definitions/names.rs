//! The names that formulas of a problem can use: paths and symbols of its inputs, and its definitions.

use dalembert_units::{Quantity, Unit};

use super::PlannedInput;
use crate::{
    Number, Record, Shape, Value, formula::normalised, path::segments, printer, worksheet::FieldPath,
};

/// A definition or an input of a plan, by its place.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Place {
    /// A definition.
    Definition(usize),
    /// An input.
    Input(usize),
}

/// The names of a problem.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Names {
    inputs: Vec<PlannedInput>,
    definitions: Vec<String>,
}

impl Names {
    /// The names of the inputs of the chosen alternatives, and these definitions.
    pub(super) fn of<'n>(record: &Record, definitions: impl Iterator<Item = &'n str>) -> Self {
        let mut inputs = Vec::new();
        collect(record, &FieldPath::TOP, &mut inputs);
        Self { inputs, definitions: definitions.map(str::to_owned).collect() }
    }

    /// Returns true if a word is a name.
    pub(super) fn contains(&self, name: &str) -> bool {
        let wanted = normalised(name);
        self.definitions.iter().any(|definition| normalised(definition) == wanted)
            || self.path_of_input(name).is_some()
    }

    /// Returns true if a word is the path of an input, or the beginning of one.
    pub(super) fn is_input_name(&self, name: &str) -> bool {
        let begins = |path: &str| {
            path.strip_prefix(name).is_some_and(|rest| rest.is_empty() || rest.starts_with(['.', '[']))
        };
        self.inputs.iter().any(|input| begins(&input.path))
    }

    /// True if one of the first `before` definitions has this name.
    pub(super) fn earlier_definition(&self, name: &str, before: usize) -> bool {
        let wanted = normalised(name);
        self.definitions.iter().take(before).any(|definition| normalised(definition) == wanted)
    }

    /// The path of the input that a path or a symbol names; `None` where none or several have the symbol.
    pub(super) fn path_of_input(&self, name: &str) -> Option<String> {
        if let Some(input) = self.inputs.iter().find(|input| input.path == name) {
            return Some(input.path.clone());
        }
        match &self.with_symbol(name)[..] {
            [only] => Some(only.path.clone()),
            _ => None,
        }
    }

    /// The inputs with a symbol.
    pub(super) fn with_symbol(&self, name: &str) -> Vec<&PlannedInput> {
        let wanted = normalised(name);
        let has = |input: &&PlannedInput| {
            !input.symbol.base.is_empty() && normalised(&printer::symbol(&input.symbol)) == wanted
        };
        self.inputs.iter().filter(has).collect()
    }

    /// The input at a path.
    pub(super) fn input(&self, path: &str) -> Option<PlannedInput> {
        self.inputs.iter().find(|input| input.path == path).cloned()
    }
}

/// Every number and vector of a record, with its path and its symbol.
fn collect(record: &Record, field_path: &FieldPath<'_>, found: &mut Vec<PlannedInput>) {
    for (field, value) in record.fields.iter().zip(&record.values) {
        let of = if is_nested(&field.shape) { field.symbol } else { "" };
        let here = field_path.field_of(field.name, of);
        value_of(value, &field.shape, field, &here, found);
    }
}

fn is_nested(shape: &Shape) -> bool {
    match shape {
        Shape::Group(_) | Shape::OneOf(_) => true,
        Shape::Optional(inner) => is_nested(inner()),
        Shape::Rows { item, .. } => is_nested(item()),
        _ => false,
    }
}

fn value_of(
    value: &Value,
    shape: &Shape,
    field: &'static crate::Field,
    field_path: &FieldPath<'_>,
    found: &mut Vec<PlannedInput>,
) {
    let mut push = |measure, unit: &Unit, value| {
        found.push(PlannedInput {
            path: field_path.path(),
            label: field.label,
            symbol: field_path.symbol(field.symbol),
            measure,
            unit: unit.clone(),
            value,
            formula: None,
        });
    };
    match (value, shape.present()) {
        (Value::Quantity(quantity), Shape::Quantity(measure)) => {
            push(measure, &quantity.unit, Number::Scalar(quantity.si));
        }
        (Value::Vector(vector), Shape::Vector(measure, _)) => {
            push(measure, &vector.unit, Number::Vector(vector.si));
        }
        (Value::Group(record), _) => collect(record, field_path, found),
        (Value::OneOf { variant, fields }, Shape::OneOf(variants)) => {
            if let Some(variant) = variants().get(*variant) {
                collect(fields, &field_path.field(variant.name), found);
            }
        }
        (Value::Rows(rows), Shape::Rows { item, .. }) => {
            for (n, row) in rows.iter().enumerate() {
                value_of(row, item(), field, &field_path.row(n), found);
            }
        }
        _ => {}
    }
}

/// The number or vector at a path.
pub(super) fn value_at(record: &mut Record, path: &str) -> Option<Number> {
    match at(record, path)? {
        Value::Quantity(quantity) => Some(Number::Scalar(quantity.si)),
        Value::Vector(vector) => Some(Number::Vector(vector.si)),
        _ => None,
    }
}

/// Writes a quantity at a path.
pub(super) fn write_quantity(record: &mut Record, path: &str, quantity: Quantity) {
    if let Some(place) = at(record, path) {
        *place = Value::Quantity(quantity);
    }
}

fn at<'r>(record: &'r mut Record, path: &str) -> Option<&'r mut Value> {
    let segments = segments(path).ok()?;
    record.place_mut(&segments).filter(|(.., rest)| rest.is_empty()).map(|(value, ..)| value)
}
