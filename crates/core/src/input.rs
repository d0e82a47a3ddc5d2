//! The bridge between the struct of a problem and its description: what `#[derive(Inputs)]` writes.

use std::fmt;

use crate::{Shape, Text, Value, Worksheet, worksheet::FieldPath};

/// A struct or enum that a form can fill. Derived.
pub trait Inputs: Sized + Send + 'static {
    /// Shape: a group of fields (struct) or a one-of (enum).
    const SHAPE: Shape;
    /// The same inputs as numbers of a worksheet.
    type Given<W: Worksheet>;

    /// The problem that a value describes. `Err` names what is missing or of another shape; a value that was
    /// read against [`SHAPE`](Inputs::SHAPE) has no such faults.
    fn read(value: &Value, field_path: &FieldPath<'_>, errors: &mut Vec<FieldError>) -> Option<Self>;
    /// The same inputs as numbers of `lift.sheet`.
    fn given<W: Worksheet>(&self, lift: Lift<'_, W>) -> Self::Given<W>;
    /// The number at a place: field indices, row indices, the index of the chosen alternative, vector components.
    fn slot(&mut self, path: &[usize]) -> Option<&mut f64>;

    /// The problem that the value of a whole describes, or everything that is wrong with it.
    fn read_all(value: &Value) -> Result<Self, Vec<FieldError>> {
        let mut errors = Vec::new();
        match Self::read(value, &FieldPath::TOP, &mut errors) {
            Some(problem) if errors.is_empty() => Ok(problem),
            _ => Err(errors),
        }
    }
}

/// Error of an input: its path, and the repair.
#[derive(Clone, Debug, PartialEq)]
pub struct FieldError {
    /// Path of the field: `masses[1].radius`.
    pub path: String,
    /// Description of the error and of its repair.
    pub why: Text,
    /// The bytes of the typed text that are wrong, where they are known.
    pub span: Option<std::ops::Range<usize>>,
}

/// Conversion of inputs to numbers of a worksheet.
#[derive(Clone, Copy)]
pub struct Lift<'t, W> {
    /// The worksheet.
    pub sheet: W,
    /// Value as typed, for its units; `None` where units do not matter.
    pub value: Option<&'t Value>,
    /// Path of the current field.
    pub field_path: &'t FieldPath<'t>,
}

/// A number of one of several kinds: a displacement, a velocity or an acceleration, as the unit says that is written.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MeasuredQuantity {
    /// The value in SI.
    pub si: f64,
    /// Of the units that the field names, the one of the same kind.
    pub unit: &'static str,
}

/// A row of another list, by its place; written as its name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Reference(
    /// The place in the list, counted from 0.
    pub usize,
);

impl FieldError {
    /// An error of the whole field.
    pub fn new(path: impl Into<String>, why: impl Into<Text>) -> Self {
        Self { path: path.into(), why: why.into(), span: None }
    }
}

impl fmt::Display for FieldError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.path, self.why.english())
    }
}

/// Functions that the derived code calls.
#[doc(hidden)]
pub mod derive_support {
    use dalembert_units::{self as units, Unit};
    use nalgebra::Vector3;

    use super::{FieldError, Inputs, Lift, MeasuredQuantity, Reference};
    use crate::{Field, Measure, Record, Shape, Value, Variant, Worksheet, worksheet::InputNumber};

    pub use crate::worksheet::FieldPath;
    pub use dalembert_units::Kind;

    type Errors = Vec<FieldError>;

    fn mismatch<T>(field_path: &FieldPath<'_>, wanted: &'static str, errors: &mut Errors) -> Option<T> {
        errors.push(FieldError::new(field_path.path(), wanted));
        None
    }

    pub fn field(value: &Value, at: usize) -> &Value {
        const ABSENT: &Value = &Value::Absent;
        match value {
            Value::Group(record) | Value::OneOf { fields: record, .. } => {
                record.values.get(at).unwrap_or(ABSENT)
            }
            _ => ABSENT,
        }
    }

    pub fn variant(value: &Value) -> Option<usize> {
        if let Value::OneOf { variant, .. } = value { Some(*variant) } else { None }
    }

    /// The alternatives of a type.
    pub fn variants<T: Inputs>() -> &'static [Variant] {
        if let Shape::OneOf(variants) = T::SHAPE { variants() } else { &[] }
    }

    /// A one-of as the type sees it whose alternatives stand among others from a place on; `None` where another one is
    /// chosen.
    pub fn flattened<T: Inputs>(value: &Value, from: usize) -> Option<Value> {
        let Value::OneOf { variant, fields } = value else { return None };
        let variant = variant.checked_sub(from).filter(|at| *at < variants::<T>().len())?;
        Some(Value::OneOf { variant, fields: fields.clone() })
    }

    /// The number at a path of such a type: of the alternative `first` among all.
    pub fn flattened_slot<'t, T: Inputs>(
        this: &'t mut T,
        first: usize,
        from: usize,
        rest: &[usize],
    ) -> Option<&'t mut f64> {
        let path: Vec<usize> = [first.checked_sub(from)?].iter().chain(rest).copied().collect();
        this.slot(&path)
    }

    pub fn quantity(value: &Value, field_path: &FieldPath<'_>, errors: &mut Errors) -> Option<f64> {
        match value {
            Value::Quantity(quantity) => Some(quantity.si),
            _ => mismatch(field_path, "a quantity is needed here", errors),
        }
    }

    pub fn measured(
        value: &Value,
        measure: Measure,
        field_path: &FieldPath<'_>,
        errors: &mut Errors,
    ) -> Option<MeasuredQuantity> {
        match value {
            Value::Quantity(quantity) => {
                Some(MeasuredQuantity { si: quantity.si, unit: measure.of(&quantity.unit).unit })
            }
            _ => mismatch(field_path, "a quantity is needed here", errors),
        }
    }

    pub fn vector(value: &Value, field_path: &FieldPath<'_>, errors: &mut Errors) -> Option<Vector3<f64>> {
        match value {
            Value::Vector(vector) => Some(Vector3::from(vector.si)),
            _ => mismatch(field_path, "a vector is needed here", errors),
        }
    }

    pub fn text(value: &Value, field_path: &FieldPath<'_>, errors: &mut Errors) -> Option<String> {
        match value {
            Value::Text(text) => Some(text.clone()),
            _ => mismatch(field_path, "a text is needed here", errors),
        }
    }

    pub fn flag(value: &Value, field_path: &FieldPath<'_>, errors: &mut Errors) -> Option<bool> {
        match value {
            Value::Flag(flag) => Some(*flag),
            _ => mismatch(field_path, "yes or no is needed here", errors),
        }
    }

    pub fn count(value: &Value, field_path: &FieldPath<'_>, errors: &mut Errors) -> Option<u64> {
        match value {
            Value::Count(count) => Some(*count),
            _ => mismatch(field_path, "a whole number is needed here", errors),
        }
    }

    pub fn reference(value: &Value, field_path: &FieldPath<'_>, errors: &mut Errors) -> Option<Reference> {
        match value {
            Value::Reference { row, .. } => Some(Reference(*row)),
            _ => mismatch(field_path, "the name of a row is needed here", errors),
        }
    }

    /// Reading function of a value, compiled once for all fields of a type.
    type Read<T> = fn(&Value, &FieldPath<'_>, &mut Errors) -> Option<T>;

    pub fn read_field<T>(
        group: &Value,
        at: usize,
        name: &'static str,
        field_path: &FieldPath<'_>,
        errors: &mut Errors,
        read: Read<T>,
    ) -> Option<T> {
        read(field(group, at), &field_path.field(name), errors)
    }

    pub fn read_optional<T>(
        group: &Value,
        at: usize,
        name: &'static str,
        field_path: &FieldPath<'_>,
        errors: &mut Errors,
        read: Read<T>,
    ) -> Option<Option<T>> {
        match field(group, at) {
            Value::Absent => Some(None),
            value => read(value, &field_path.field(name), errors).map(Some),
        }
    }

    pub fn one_of<T>(field_path: &FieldPath<'_>, errors: &mut Errors) -> Option<T> {
        mismatch(field_path, "one of the alternatives is needed here", errors)
    }

    pub fn optional<T>(
        value: &Value,
        errors: &mut Errors,
        read: impl FnOnce(&Value, &mut Errors) -> Option<T>,
    ) -> Option<Option<T>> {
        if *value == Value::Absent { Some(None) } else { read(value, errors).map(Some) }
    }

    pub fn rows<T>(
        value: &Value,
        field_path: &FieldPath<'_>,
        errors: &mut Errors,
        mut read: impl FnMut(&Value, &FieldPath<'_>, &mut Errors) -> Option<T>,
    ) -> Option<Vec<T>> {
        let Value::Rows(rows) = value else { return mismatch(field_path, "a list is needed here", errors) };
        let all: Vec<T> =
            rows.iter().enumerate().filter_map(|(n, row)| read(row, &field_path.row(n), errors)).collect();
        (all.len() == rows.len()).then_some(all)
    }

    pub fn table<T>(
        value: &Value,
        field_path: &FieldPath<'_>,
        errors: &mut Errors,
        read: impl Fn(&[f64], &[Unit]) -> Option<T>,
    ) -> Option<Vec<T>> {
        match value {
            Value::Table(table) => table.rows().map(|row| read(row, &table.units)).collect(),
            _ => mismatch(field_path, "a table is needed here", errors),
        }
    }

    fn measure_of(shape: &Shape) -> &'static Measure {
        const NONE: &Measure = &Measure::in_unit("1");
        match shape {
            Shape::Optional(inner) => measure_of(inner()),
            Shape::Rows { item, .. } => match item() {
                Shape::Quantity(measure) | Shape::Vector(measure, _) => measure,
                other => measure_of(other),
            },
            _ => NONE,
        }
    }

    /// The measure of a number or a vector, also of an optional one or of the rows of a list.
    pub(crate) fn measure(field: &'static Field) -> &'static Measure {
        match &field.shape {
            Shape::Quantity(measure) | Shape::Vector(measure, _) => measure,
            other => measure_of(other),
        }
    }

    /// A number of a group, `lift` being that of the group.
    #[inline]
    pub fn field_given<W: Worksheet>(
        lift: Lift<'_, W>,
        fields: &'static [Field],
        at: usize,
        si: f64,
    ) -> W::Num {
        let input =
            InputNumber { field: &fields[at], at: Some(at), value: lift.value, field_path: lift.field_path };
        lift.sheet.given(input, si)
    }

    /// A vector of a group, `lift` being that of the group.
    #[inline]
    pub fn field_given_vector<W: Worksheet>(
        lift: Lift<'_, W>,
        fields: &'static [Field],
        at: usize,
        si: Vector3<f64>,
    ) -> W::Vec {
        let input =
            InputNumber { field: &fields[at], at: Some(at), value: lift.value, field_path: lift.field_path };
        lift.sheet.given_vector(input, si)
    }

    /// A number, `lift` being its own.
    #[inline]
    pub fn given<W: Worksheet>(lift: Lift<'_, W>, field: &'static Field, si: f64) -> W::Num {
        lift.sheet.given(InputNumber { field, at: None, value: lift.value, field_path: lift.field_path }, si)
    }

    /// A vector, `lift` being its own.
    #[inline]
    pub fn given_vector<W: Worksheet>(lift: Lift<'_, W>, field: &'static Field, si: Vector3<f64>) -> W::Vec {
        lift.sheet
            .given_vector(InputNumber { field, at: None, value: lift.value, field_path: lift.field_path }, si)
    }

    #[inline]
    pub fn row_value(value: Option<&Value>, row: usize) -> Option<&Value> {
        match value {
            Some(Value::Rows(rows)) => rows.get(row),
            _ => None,
        }
    }

    /// A row of a table as the struct of its columns.
    pub fn table_row<R: Inputs>(numbers: &[f64], units: &[Unit]) -> Option<R> {
        let fields = R::SHAPE.fields(None);
        let quantity = |(si, unit): (&f64, &Unit)| {
            Value::Quantity(units::Quantity { si: *si, unit: unit.clone(), last_place: 0.0 })
        };
        let values = numbers.iter().zip(units).map(quantity).collect();
        R::read(&Value::Group(Record::new(fields, values)), &FieldPath::TOP, &mut Vec::new())
    }
}
