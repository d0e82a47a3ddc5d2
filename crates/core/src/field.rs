//! Description of the inputs of a problem, which forms, files and the command line share.

use std::{fmt, ops::Deref};

use crate::{Text, definitions::are_of_problem, intern};
use dalembert_units::{self as units, Dim, Unit};

/// One line of the form, one key of the file, one `--set` of the command line.
#[derive(Clone, Copy, Debug)]
pub struct Field {
    /// The Rust name: the key in files and paths.
    pub name: &'static str,
    /// The first line of its documentation.
    pub label: &'static str,
    /// The rest of its documentation; may be empty.
    pub help: &'static str,
    /// Symbol in formulas; empty if the field appears in none.
    pub symbol: &'static str,
    /// Default text of an empty field; `None` if the field is required.
    pub default: Option<&'static str>,
    /// The default of the first format of problem files, where it was another; of a column of a table, the unit in
    /// which a number alone was read.
    pub default_before: Option<&'static str>,
    /// The optional field beside it that keeps its first value when it is changed alone: a mechanism is drawn with one
    /// value of a driver and moved to others.
    pub kept_in: Option<&'static str>,
    /// The alternatives that stood here in earlier files. What such an alternative holds is read in its place.
    pub former: &'static [&'static str],
    /// Shape of the value.
    pub shape: Shape,
}

/// Shape of the value of a field. Inner shapes are functions so that a type may contain itself.
#[derive(Clone, Copy, Debug)]
pub enum Shape {
    /// A number with a unit.
    Quantity(Measure),
    /// Two or three components with a unit.
    Vector(Measure, usize),
    /// Free text on one line.
    Text,
    /// Yes or no.
    Flag,
    /// A whole number within limits, both included.
    Count {
        /// The least.
        min: u64,
        /// The most.
        max: u64,
    },
    /// One of several alternatives, each with fields of its own (or none: a plain choice).
    OneOf(fn() -> &'static [Variant]),
    /// Fields that belong together.
    Group(Fields),
    /// A list, each item of the same shape.
    Rows {
        /// The shape of an item.
        item: fn() -> &'static Shape,
        /// The least number of items.
        min: usize,
        /// The most: a list that is too long is refused before anything is made of it.
        most: usize,
    },
    /// Numbers in columns with units: typed, pasted or read from a file.
    Table(Fields),
    /// The name (or number) of an item of the top-level list of that name.
    Reference(&'static str),
    /// May be left out.
    Optional(fn() -> &'static Shape),
}

/// A list of fields, called for: of a type, or of problems that are linked when a file is read.
#[derive(Clone, Copy)]
pub struct Fields(pub &'static (dyn Fn() -> &'static [Field] + Sync));

/// The unit, kind and limits of a quantity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measure {
    /// The unit of a number written alone, and of the limits.
    pub unit: &'static str,
    /// The kind, where the unit does not tell it.
    pub kind: Option<units::Kind>,
    /// The least value, in `unit`.
    pub min: FieldLimit,
    /// The largest value, in `unit`.
    pub max: FieldLimit,
    /// The measures of the other kinds that may stand here instead. The unit that is written decides, and is of the same
    /// kind in all such fields of a problem.
    pub others: &'static [Measure],
    /// True if books print the quantity as a number too: below one and alone it is that number, 0.05 and not 0.05 %.
    pub fraction: bool,
    /// True of a balance quality grade, which is written with its letter too: `G 6.3`, `G6.3`.
    pub grade: bool,
}

/// An end of the permitted range.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum FieldLimit {
    /// No limit.
    None,
    /// The value itself is permitted.
    Including(f64),
    /// The value itself is not permitted.
    Excluding(f64),
}

/// The least and the largest permitted value, in SI.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ValueLimits {
    least: f64,
    largest: f64,
}

/// An alternative of a one-of.
#[derive(Clone, Copy, Debug)]
pub struct Variant {
    /// The key in files and paths, in kebab case.
    pub name: &'static str,
    /// The first line of its documentation.
    pub label: &'static str,
    /// The rest of its documentation; may be empty.
    pub help: &'static str,
    /// Input fields of this alternative.
    pub fields: Fields,
    /// The alternatives that stood here instead in earlier files.
    pub former: &'static [&'static str],
}

/// Identity of a list of fields or alternatives within a shape. Two shapes with the same children are described once; a
/// type that contains itself meets its own again.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ChildList {
    place: *const (),
    /// Number of fields or alternatives.
    pub parts: usize,
}

impl Field {
    /// Label for display: of a linked problem, its name as it was typed.
    pub fn title(&self) -> Text {
        match &self.shape {
            Shape::Group(fields) if are_of_problem(fields()) => Text::verbatim(self.label),
            _ => Text::from(self.label),
        }
    }
}

impl Deref for Fields {
    type Target = dyn Fn() -> &'static [Field] + Sync;

    fn deref(&self) -> &Self::Target {
        self.0
    }
}

impl fmt::Debug for Fields {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_list().entries(self().iter().map(|field| field.name)).finish()
    }
}

impl ChildList {
    fn of<T>(list: &'static [T]) -> Self {
        Self { place: list.as_ptr().cast(), parts: list.len() }
    }
}

impl ValueLimits {
    /// Returns true if a value, in SI, is finite and within the limits.
    #[inline]
    pub(crate) fn permit(&self, si: f64) -> bool {
        self.least <= si && si <= self.largest
    }
}

impl Measure {
    /// The unit of a number written alone.
    pub fn own_unit(&self) -> Unit {
        intern::unit_of_field(self.unit).clone()
    }

    /// Returns true if a value, in SI, is finite and within the limits.
    pub fn permits(&self, si: f64) -> bool {
        self.limits().permit(si)
    }

    /// Limits with their unit read once, for many values.
    pub(crate) fn limits(&self) -> ValueLimits {
        let unit = intern::unit_of_field(self.unit);
        let least = match self.min {
            FieldLimit::None => f64::MIN,
            FieldLimit::Including(min) => unit.si(min),
            FieldLimit::Excluding(min) => unit.si(min).next_up(),
        };
        let largest = match self.max {
            FieldLimit::None => f64::MAX,
            FieldLimit::Including(max) => unit.si(max),
            FieldLimit::Excluding(max) => unit.si(max).next_down(),
        };
        ValueLimits { least, largest }
    }

    /// Message for a value outside its limits, written as this text; `None` within them.
    pub(crate) fn outside(&self, si: f64, text: &str) -> Option<Text> {
        if self.permits(si) {
            return None;
        }
        let own = self.own_unit();
        let limit =
            |why: &'static str, limit: f64| Text::new(why).with_quantity("limit", own.si(limit), self.unit);
        let is_low = |min: f64| si <= own.si(min);
        let why = match (self.min, self.max) {
            (FieldLimit::Excluding(0.0), _) if is_low(0.0) => {
                Text::new("must be above zero; you wrote {text}")
            }
            (FieldLimit::Including(0.0), _) if is_low(0.0) => {
                Text::new("must not be below zero; you wrote {text}")
            }
            (FieldLimit::Excluding(min), _) if is_low(min) => {
                limit("must be above {limit}; you wrote {text}", min)
            }
            (FieldLimit::Including(min), _) if is_low(min) => {
                limit("must be {limit} or more; you wrote {text}", min)
            }
            (_, FieldLimit::Excluding(max)) if si >= own.si(max) => {
                limit("must be below {limit}; you wrote {text}", max)
            }
            (_, FieldLimit::Including(max)) if si >= own.si(max) => {
                limit("must be {limit} or less; you wrote {text}", max)
            }
            _ => return None,
        };
        Some(why.with("text", text.trim()))
    }

    /// Itself and the others.
    pub fn all(self) -> impl Iterator<Item = Measure> {
        std::iter::once(Measure { others: &[], ..self }).chain(self.others.iter().copied())
    }

    /// The place among [`all`](Measure::all) of the one that a dimension is of.
    pub fn place(self, dim: Dim) -> Option<usize> {
        self.all().position(|measure| measure.own_unit().dim == dim)
    }

    /// The one that a unit is of; the first where it is of none.
    #[must_use]
    pub fn of(self, unit: &Unit) -> Measure {
        if self.others.is_empty() {
            return self;
        }
        self.place(unit.dim).and_then(|place| self.all().nth(place)).unwrap_or(self)
    }

    /// A measure in a unit, without limits.
    pub const fn in_unit(unit: &'static str) -> Self {
        let (min, max) = (FieldLimit::None, FieldLimit::None);
        Measure { unit, kind: None, min, max, others: &[], fraction: false, grade: false }
    }

    /// The one that a text is of. A number alone is a number, where one may stand here.
    #[must_use]
    pub fn meant(self, text: &str) -> Measure {
        if self.others.is_empty() && !self.fraction {
            return self;
        }
        let Some(read) = units::quantity_of(text) else { return self };
        if self.fraction && read.unit.text.is_empty() && read.si < 1.0 {
            let own = self.own_unit();
            let scaled = |limit| match limit {
                FieldLimit::None => FieldLimit::None,
                FieldLimit::Including(limit) => FieldLimit::Including(own.si(limit)),
                FieldLimit::Excluding(limit) => FieldLimit::Excluding(own.si(limit)),
            };
            return Measure { unit: "1", min: scaled(self.min), max: scaled(self.max), ..self };
        }
        self.of(&read.unit)
    }

    /// The text without the letter of a grade before a number in the unit of grades: `6.3` of `G 6.3`; any other text as
    /// it is.
    pub(crate) fn without_letter(self, text: &str) -> &str {
        if !self.grade {
            return text;
        }
        let is_grade = |rest: &&str| {
            let is_own = |unit: &Unit| unit.text.is_empty() || unit.ascii() == self.unit;
            rest.starts_with(|c: char| c.is_ascii_digit())
                && units::quantity_of(rest).is_some_and(|read| is_own(&read.unit))
        };
        let behind = text.trim_start().strip_prefix(['G', 'g']).map(str::trim_start);
        behind.filter(is_grade).unwrap_or(text)
    }

    /// The units of all its kinds: `µm | mm/s | 1`.
    pub fn units_of_kinds(self, ascii: bool) -> String {
        let shown = self.all().map(|measure| match measure.own_unit().shown(ascii) {
            unit if unit.is_empty() => "1".to_owned(),
            unit => unit,
        });
        shown.collect::<Vec<_>>().join(" | ")
    }

    /// Units worth offering, its own first. A pure number is offered only where a number written alone is one,
    /// and a level only where a level is asked: elsewhere what is shown would not read back as what it is.
    pub fn units(&self) -> Vec<&'static str> {
        let others = self
            .kind()
            .units()
            .iter()
            .copied()
            .filter(|unit| *unit != self.unit && !["1", "dB"].contains(unit));
        std::iter::once(self.unit).chain(others).collect()
    }

    /// The kind of quantity that is asked for.
    pub fn kind(&self) -> units::Kind {
        self.kind.unwrap_or_else(|| units::Kind::of(&self.own_unit()))
    }
}

impl Shape {
    /// The shape of an optional input that is there; any other shape as it is.
    #[must_use]
    pub fn present(self) -> Shape {
        if let Shape::Optional(inner) = self { inner().present() } else { self }
    }

    /// Measure of a quantity or vector: of an optional one, and of the rows of a list, as well.
    #[must_use]
    pub fn measure(&self) -> Option<Measure> {
        match self {
            Shape::Quantity(measure) | Shape::Vector(measure, _) => Some(*measure),
            Shape::Optional(inner) => inner().measure(),
            Shape::Rows { item, .. } => item().measure(),
            _ => None,
        }
    }

    /// The fields directly inside: of a group, or of the alternative `variant` of a one-of.
    pub fn fields(&self, variant: Option<usize>) -> &'static [Field] {
        match self {
            Shape::Group(fields) | Shape::Table(fields) => fields(),
            Shape::OneOf(variants) => variant.and_then(|n| variants().get(n)).map_or(&[], |v| (v.fields)()),
            _ => &[],
        }
    }

    /// Child list of a group, a table or a one-of.
    pub fn child_list(&self) -> Option<ChildList> {
        match self {
            Shape::Group(fields) | Shape::Table(fields) => Some(ChildList::of(fields())),
            Shape::OneOf(variants) => Some(ChildList::of(variants())),
            _ => None,
        }
    }

    /// Returns true if a value of this shape is one text, shown on one line of a form.
    pub fn is_leaf(&self) -> bool {
        match self {
            Shape::OneOf(_) | Shape::Group(_) | Shape::Rows { .. } => false,
            Shape::Optional(inner) => inner().is_leaf(),
            _ => true,
        }
    }
}
