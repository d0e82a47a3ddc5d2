//! The inputs of a problem as lines: what was typed, and what was understood.

use dalembert_core::{
    Draft, Field, Locale, Record, Shape, Solution, Symbol, Text, Value, gravity, has_unknown, own_fields,
    printer, split_tolerance,
};
use dalembert_units::{self as units, Style, Unit, UnitSystem};

/// The digits that an input is shown with: what was typed is not rounded.
const TYPED_DIGITS: u8 = 12;

/// An input, or the heading of the inputs within it.
#[derive(Clone, Debug, PartialEq)]
pub struct ReportedInput<'r> {
    /// Path: `masses[1].radius`.
    pub path: String,
    /// Nesting depth.
    pub depth: usize,
    /// Symbol in formulas; may be empty.
    pub symbol: String,
    /// Label.
    pub label: String,
    /// Text as typed; the name of the alternative for a one-of.
    pub typed: String,
    /// Value as read; `None` for the heading of a row or of a group.
    pub value: Option<&'r Value>,
    /// Value as displayed.
    pub shown: String,
    /// Value, in SI, and unit of an input that a formula gives or that was found.
    pub computed: Option<(f64, Unit)>,
    /// True of definitions, questions and the like, which every problem has.
    pub is_common: bool,
}

/// The inputs in the order of the form. `draft` is what `record` was read from; `solution` has the values of formulas and
/// of unknowns.
pub fn inputs<'r>(
    draft: &Draft,
    record: &'r Record,
    solution: Option<&Solution>,
    locale: &Locale,
) -> Vec<ReportedInput<'r>> {
    let mut found = Vec::new();
    let place = Place { path: String::new(), depth: 0, rows: Vec::new(), locale, solution, is_common: false };
    place.record(Some(draft), record, &mut found);
    found
}

/// Position of a traversal of a record.
struct Place<'l> {
    path: String,
    depth: usize,
    rows: Vec<usize>,
    locale: &'l Locale,
    solution: Option<&'l Solution>,
    is_common: bool,
}

impl Place<'_> {
    fn record<'r>(&self, draft: Option<&Draft>, record: &'r Record, found: &mut Vec<ReportedInput<'r>>) {
        for (n, (field, value)) in record.fields.iter().zip(&record.values).enumerate() {
            let draft = match draft {
                Some(Draft::Group(all)) => all.get(n),
                _ => None,
            };
            let dot = if self.path.is_empty() { "" } else { "." };
            let mut place = self.within(format!("{}{dot}{}", self.path, field.name), self.depth);
            place.is_common |= n >= own_fields(record.fields);
            place.value(field, &field.shape, draft, value, None, found);
        }
    }

    /// `row` is the number of a row, whose label is that of its list.
    fn value<'r>(
        &self,
        field: &'static Field,
        shape: &Shape,
        draft: Option<&Draft>,
        value: &'r Value,
        row: Option<usize>,
        found: &mut Vec<ReportedInput<'r>>,
    ) {
        let label = field.title().render(self.locale);
        let label = row.map_or_else(|| label.clone(), |row| format!("{label} {row}"));
        let symbol = self.rows.iter().fold(Symbol::from(field.symbol), |symbol, row| symbol.row(*row));
        let symbol = if field.symbol.is_empty() {
            String::new()
        } else {
            printer::symbol_in(&symbol, self.locale.style)
        };
        // What is chosen is no number: the mark of its part, as in "Mass of the rod 3", belongs to the label.
        let (label, symbol) = match shape.present() {
            Shape::OneOf(_) if !symbol.is_empty() => (format!("{label} {symbol}"), String::new()),
            _ => (label, symbol),
        };
        let mut input = ReportedInput {
            path: self.path.clone(),
            depth: self.depth,
            symbol,
            label,
            typed: match draft {
                Some(Draft::Leaf(text)) => text.clone(),
                _ => String::new(),
            },
            value: Some(value),
            shown: String::new(),
            computed: None,
            is_common: self.is_common,
        };
        match (shape, value) {
            (Shape::Optional(inner), value) if *value != Value::Absent => {
                self.value(field, inner(), draft, value, row, found);
            }
            (_, Value::Group(record)) => {
                input.value = None;
                found.push(input);
                self.within(self.path.clone(), self.depth + 1).record(draft, record, found);
            }
            (Shape::OneOf(variants), Value::OneOf { variant, fields }) => {
                let chosen = &variants()[*variant];
                chosen.name.clone_into(&mut input.typed);
                input.shown = Text::from(chosen.label).render(self.locale);
                found.push(input);
                let draft = match draft {
                    Some(Draft::OneOf(_, fields)) => Some(&**fields),
                    _ => None,
                };
                let place = self.within(format!("{}.{}", self.path, chosen.name), self.depth + 1);
                place.record(draft, fields, found);
            }
            (Shape::Rows { item, .. }, Value::Rows(rows)) => {
                for (n, value) in rows.iter().enumerate() {
                    let draft = match draft {
                        Some(Draft::Rows(all)) => all.get(n),
                        _ => None,
                    };
                    let mut place = self.within(format!("{}[{}]", self.path, n + 1), self.depth);
                    place.rows.push(n + 1);
                    place.value(field, item(), draft, value, Some(n + 1), found);
                }
            }
            _ => {
                input.shown = shown(value, self.locale);
                let computed = self.solution.and_then(|solution| solution.computed_input(&self.path));
                if let (Some((si, unit)), Value::Quantity(_)) = (computed, value) {
                    let value = units::write_quantity(si, unit, self.locale.style);
                    input.shown = format!("{} = {value}", input.typed.trim());
                    input.computed = Some((si, unit.clone()));
                }
                if let (None, (_, Some(tolerance))) = (&input.computed, split_tolerance(&input.typed)) {
                    input.shown = format!("{} ± {tolerance}", input.shown);
                }
                // The components that were found stand in the record of the solution.
                if let Value::Vector(_) = value
                    && self.solution.is_some_and(|solution| solution.computed_value(&self.path).is_some())
                {
                    input.shown = format!("{} = {}", input.typed.trim(), input.shown);
                }
                // Without a solution an unknown is what was typed: the value of its record is where a search begins.
                let has_number = matches!(value, Value::Quantity(_) | Value::Vector(_));
                if self.solution.is_none() && has_number && has_unknown(&input.typed) {
                    input.typed.trim().clone_into(&mut input.shown);
                }
                if gravity::is_gravity(field) && input.typed.trim().is_empty() && gravity::is_default(value) {
                    let default = Text::new("{value} (default)").with("value", &input.shown);
                    input.shown = default.render(self.locale);
                }
                found.push(input);
            }
        }
    }

    fn within(&self, path: String, depth: usize) -> Self {
        Self { path, depth, rows: self.rows.clone(), ..*self }
    }
}

fn shown(value: &Value, locale: &Locale) -> String {
    let style = Style { digits: locale.style.digits.max(TYPED_DIGITS), ..locale.style };
    let word = |word: &'static str| Text::from(word).render(locale);
    match value {
        Value::Quantity(quantity) => units::write_quantity(quantity.si, &quantity.unit, style),
        Value::Vector(vector) => units::write_components(&vector.si[..vector.len], &vector.unit, style),
        Value::Text(text) | Value::Reference { name: text, .. } => text.clone(),
        Value::Flag(flag) => word(if *flag { "yes" } else { "no" }),
        Value::Count(count) => count.to_string(),
        Value::Table(table) => Text::new("{count} rows").with("count", table.rows().len()).render(locale),
        Value::Absent => "—".into(),
        Value::OneOf { .. } | Value::Group(_) | Value::Rows(_) => String::new(),
    }
}

/// A value in the unit of a system; `None` where it is in it, and for what has no unit.
pub(crate) fn shown_in(value: &Value, system: UnitSystem, locale: &Locale) -> Option<String> {
    let other = |unit: &Unit| Some(system.unit(unit)).filter(|other| other.text != unit.text);
    match value {
        Value::Quantity(quantity) if quantity.si != 0.0 => {
            Some(units::write_quantity(quantity.si, &other(&quantity.unit)?, locale.style))
        }
        Value::Vector(vector) => {
            let unit = other(&vector.unit)?;
            Some(units::write_components(&vector.si[..vector.len], &unit, locale.style))
        }
        _ => None,
    }
}
