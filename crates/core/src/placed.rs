//! Points described in place: `crank (15; 0) mm` is a point of the body `crank`, wherever the name of a point may stand.

use crate::{Field, Shape, Variant};

/// The fields of a named point: its name, what carries it, and its position there.
#[derive(Clone, Copy)]
pub(crate) struct PlacedFields {
    pub(crate) fields: &'static [Field],
    /// The fields `name`, `on` and `at`.
    pub(crate) places: [usize; 3],
}

impl PlacedFields {
    /// Those of a shape; `None` unless it is a group of a name, a choice of what carries the point, and a vector.
    pub(crate) fn of(shape: &Shape) -> Option<Self> {
        let Shape::Group(fields) = shape.present() else { return None };
        let fields = fields();
        let place = |name: &str, fits: fn(&Shape) -> bool| {
            fields.iter().position(|field| field.name == name && fits(&field.shape))
        };
        let places = [
            place("name", |shape| matches!(shape, Shape::Text))?,
            place("on", |shape| matches!(shape, Shape::OneOf(_)))?,
            place("at", |shape| matches!(shape, Shape::Vector(..)))?,
        ];
        Some(Self { fields, places })
    }

    /// The alternatives of what carries the point.
    pub(crate) fn carriers(&self) -> &'static [Variant] {
        match self.fields[self.places[1]].shape {
            Shape::OneOf(variants) => variants(),
            _ => &[],
        }
    }

    /// Place of the alternative that a name stands for: one that asks for nothing, as the ground, or else the one whose only
    /// input refers to a row by its name.
    pub(crate) fn carrier(&self, name: &str) -> Option<usize> {
        let carriers = self.carriers();
        let plain = carriers.iter().position(|one| one.name == name && (one.fields)().is_empty());
        let refers = |one: &Variant| matches!((one.fields)(), [only] if referred(only).is_some());
        plain.or_else(|| carriers.iter().position(refers))
    }
}

/// The list that a field refers to.
pub(crate) fn referred(field: &Field) -> Option<&'static str> {
    if let Shape::Reference(list) = field.shape { Some(list) } else { None }
}

/// The two parts of a point described in place: what carries it, which may be empty, and its position in brackets.
pub(crate) fn split(text: &str) -> Option<(&str, &str)> {
    let (carrier, position) = text.split_at(text.find('(')?);
    Some((carrier.trim(), position.trim()))
}
