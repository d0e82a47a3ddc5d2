//! Points described in place: `crank (15; 0) mm` is a point of the body `crank`, wherever the name of a point may stand.

use crate::{Field, Shape, Variant};

/// The fields of a named point: its name, what carries it, and its position there.
#[derive(Clone, Copy)]
pub(crate) struct PlacedFields {
    pub(crate) fields: &'static [Field],
    /// The fields `name`, `on` and `at`.
    pub(crate) places: [usize; 3],
}

/// Carrier of a point that is described in place.
pub(crate) enum Carrier<'t> {
    /// An alternative that asks for nothing, by its place: the ground.
    Plain(usize),
    /// An alternative whose only input is a reference, by its place, and the name that is referred to: a body.
    Named(usize, &'t str),
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

    /// Carrier that a name stands for: an alternative that asks for nothing, or else a row that one refers to.
    pub(crate) fn carrier<'t>(&self, name: &'t str) -> Option<Carrier<'t>> {
        let carriers = self.carriers();
        if let Some(at) = carriers.iter().position(|one| one.name == name && (one.fields)().is_empty()) {
            return Some(Carrier::Plain(at));
        }
        let refers = |one: &Variant| matches!((one.fields)(), [only] if referred(only).is_some());
        carriers.iter().position(refers).map(|at| Carrier::Named(at, name))
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
