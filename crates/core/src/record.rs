//! Record of the inputs as read: values in SI with the units they were written in.

use std::{
    slice::{ChunksExact, ChunksExactMut},
    sync::Arc,
};

use dalembert_units::{Quantity, Unit, VectorQuantity};

use crate::{Field, Goal, Shape, definitions::Plan, path::Segment};

/// A value of some [`Shape`].
#[derive(Clone, Debug, PartialEq)]
pub enum Value {
    /// A number with a unit.
    Quantity(Quantity),
    /// Components with a unit.
    Vector(VectorQuantity),
    /// Free text.
    Text(String),
    /// Yes or no.
    Flag(bool),
    /// A whole number.
    Count(u64),
    /// The row, counted from 0, that a name refers to.
    Reference {
        /// As it was written.
        name: String,
        /// Index of the row in the list.
        row: usize,
    },
    /// An alternative, by its place, and its fields.
    OneOf {
        /// Index of the alternative.
        variant: usize,
        /// Values of its fields.
        fields: Record,
    },
    /// Fields that belong together.
    Group(Record),
    /// A list.
    Rows(Vec<Value>),
    /// Numbers in columns.
    Table(NumberTable),
    /// Left out.
    Absent,
}

/// Numbers in columns.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct NumberTable {
    /// The units the columns were written in.
    pub units: Vec<Unit>,
    /// The numbers in SI, row after row; shared by the copies of a problem.
    numbers: Arc<Vec<f64>>,
    /// True for each column of numbers whose unit is named neither by the heading nor by a cell, and is assumed.
    pub assumed: Vec<bool>,
}

impl NumberTable {
    /// A table without rows.
    pub fn new(units: Vec<Unit>) -> Self {
        let assumed = vec![false; units.len()];
        Self { units, numbers: Arc::default(), assumed }
    }

    /// The rows, in SI.
    pub fn rows(&self) -> ChunksExact<'_, f64> {
        self.numbers.chunks_exact(self.units.len().max(1))
    }

    /// Returns true if there is no row.
    pub fn is_empty(&self) -> bool {
        self.rows().len() == 0
    }

    /// The rows, to be changed.
    pub fn rows_mut(&mut self) -> ChunksExactMut<'_, f64> {
        Arc::make_mut(&mut self.numbers).chunks_exact_mut(self.units.len().max(1))
    }

    /// Adds a row, a number for each column in SI.
    pub(crate) fn push(&mut self, row: &[f64]) {
        debug_assert_eq!(row.len(), self.units.len());
        Arc::make_mut(&mut self.numbers).extend_from_slice(row);
    }
}

/// The values of a list of fields, in the order of the fields.
#[derive(Clone, Debug)]
pub struct Record {
    /// Fields of the inputs.
    pub fields: &'static [Field],
    /// Values; as many as `fields`.
    pub values: Vec<Value>,
    /// The definitions, formulas and questions of a problem; `None` where it has none, and of nested fields.
    pub(crate) plan: Option<Arc<Plan>>,
}

impl PartialEq for Record {
    fn eq(&self, other: &Self) -> bool {
        std::ptr::eq(self.fields, other.fields) && self.values == other.values && self.plan == other.plan
    }
}

impl Record {
    /// The values of a list of fields.
    pub fn new(fields: &'static [Field], values: Vec<Value>) -> Self {
        Self { fields, values, plan: None }
    }

    /// The requirements of answers that unknowns are found from.
    pub fn goals(&self) -> impl Iterator<Item = Goal> {
        self.plan.iter().flat_map(|plan| plan.goals())
    }

    /// The value of the field of that name.
    pub fn get(&self, name: &str) -> Option<&Value> {
        self.fields.iter().position(|field| field.name == name).map(|at| &self.values[at])
    }

    /// The value of the field of that name, to be changed.
    pub fn get_mut(&mut self, name: &str) -> Option<&mut Value> {
        let at = self.fields.iter().position(|field| field.name == name)?;
        self.values.get_mut(at)
    }

    /// The value that a path leads to, its shape, and the rest of the path behind it: the axis of a vector.
    pub(crate) fn place_mut<'p>(
        &mut self,
        path: &'p [Segment],
    ) -> Option<(&mut Value, Shape, &'p [Segment])> {
        let [Segment::Name(name), rest @ ..] = path else { return None };
        let at = self.fields.iter().position(|field| field.name == name)?;
        let (mut value, mut shape, mut rest) =
            (self.values.get_mut(at)?, self.fields[at].shape.present(), rest);
        loop {
            match (value, shape, rest) {
                (Value::Group(record), _, [_, ..]) => return record.place_mut(rest),
                (Value::OneOf { variant, fields }, Shape::OneOf(all), [Segment::Name(name), inner @ ..]) => {
                    return if all().get(*variant)?.name == name { fields.place_mut(inner) } else { None };
                }
                (Value::Rows(rows), Shape::Rows { item, .. }, [Segment::Row(row), inner @ ..]) => {
                    (value, shape, rest) = (rows.get_mut(*row)?, item().present(), inner);
                }
                found => return Some(found),
            }
        }
    }

    /// Calls `visit` with the path, the field and the value of every leaf, in the order of the form.
    pub fn leaves<'r>(&'r self, visit: &mut impl FnMut(&str, &'static Field, &'r Value)) {
        walk_record(self, "", visit);
    }
}

fn walk_record<'r>(
    record: &'r Record,
    prefix: &str,
    visit: &mut impl FnMut(&str, &'static Field, &'r Value),
) {
    for (field, value) in record.fields.iter().zip(&record.values) {
        let path = if prefix.is_empty() { field.name.to_owned() } else { format!("{prefix}.{}", field.name) };
        walk(field, &field.shape, value, &path, visit);
    }
}

fn walk<'r>(
    field: &'static Field,
    shape: &Shape,
    value: &'r Value,
    path: &str,
    visit: &mut impl FnMut(&str, &'static Field, &'r Value),
) {
    match (shape, value) {
        (Shape::Optional(inner), value) => walk(field, inner(), value, path, visit),
        (_, Value::Group(record)) => walk_record(record, path, visit),
        (Shape::OneOf(variants), Value::OneOf { variant, fields }) => {
            visit(path, field, value);
            walk_record(fields, &format!("{path}.{}", variants()[*variant].name), visit);
        }
        (Shape::Rows { item, .. }, Value::Rows(rows)) => {
            for (n, row) in rows.iter().enumerate() {
                walk(field, item(), row, &format!("{path}[{}]", n + 1), visit);
            }
        }
        _ => visit(path, field, value),
    }
}
