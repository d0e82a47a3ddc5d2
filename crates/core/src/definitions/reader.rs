//! Definitions and questions as they are typed, row by row.

use dalembert_units::Unit;

use super::{
    Definition, Question, field_error,
    names::Names,
    unknowns::{self, Unknown, is_unknown},
};
use crate::{
    FieldError, Text, Value,
    ascii::index,
    formula::{Expression, Formula, Function},
};

/// Reader of definitions and questions; what is wrong with them is kept.
pub(super) struct Reader<'n> {
    pub(super) names: &'n Names,
    pub(super) errors: Vec<FieldError>,
}

impl Reader<'_> {
    /// The definition in a row, counted from 0.
    pub(super) fn definition(
        &mut self,
        n: usize,
        row: &Value,
        unknowns: &mut Vec<Unknown>,
    ) -> Option<Definition> {
        let path = |part: &str| format!("let[{}].{part}", n + 1);
        let (name, text) = (text_of(row, "name"), text_of(row, "formula"));
        let begins = name.chars().next().is_some_and(|c| c.is_alphabetic() || c == '_');
        let wrong = if name.is_empty() {
            Some("a name is needed, for example nu".into())
        } else if !begins
            || !name.chars().all(|c| {
                c.is_alphanumeric()
                    || matches!(c, '_' | '′')
                    || index(c).is_some_and(|plain| plain.is_ascii_alphanumeric())
            })
        {
            Some(
                Text::new("`{name}` is no name: write letters, digits and _, a letter first")
                    .with("name", name),
            )
        } else if Function::of(name).is_some() || matches!(name, "pi" | "π") {
            Some(
                Text::new("`{name}` is the name of a function or a constant: choose another")
                    .with("name", name),
            )
        } else if self.names.is_input_name(name) {
            Some(Text::new("`{name}` is the name of an input: choose another").with("name", name))
        } else if self.names.earlier_definition(name, n) {
            Some(Text::new("`{name}` is defined twice: keep one of the two").with("name", name))
        } else {
            None
        };
        if let Some(why) = wrong {
            self.errors.push(FieldError::new(path("name"), why));
            return None;
        }
        if is_unknown(text) {
            return match unknowns::read(text, name, None) {
                Ok((unknown, start)) => {
                    unknowns.push(unknown);
                    let (unit, si) = (start.unit.clone(), start.si);
                    let formula = Formula { root: Expression::Quantity(start), text: text.to_owned() };
                    Some(Definition { name: name.to_owned(), formula, unit, si })
                }
                Err(why) => {
                    self.errors.push(FieldError::new(path("formula"), why));
                    None
                }
            };
        }
        let formula = self.formula(&path("formula"), text)?;
        let (unit, si) =
            formula.quantity().map_or((Unit::ONE, 0.0), |quantity| (quantity.unit.clone(), quantity.si));
        Some(Definition { name: name.to_owned(), formula, unit, si })
    }

    /// The question in a row, with those before it.
    pub(super) fn question(&mut self, n: usize, row: &Value, before: &[Question]) -> Option<Question> {
        let path = |part: &str| format!("ask[{}].{part}", n + 1);
        let (label, text) = (text_of(row, "name"), text_of(row, "formula"));
        if label.is_empty() {
            self.errors.push(FieldError::new(path("name"), "a name is needed, for example peak to peak"));
            return None;
        }
        let key = match text_of(row, "key") {
            "" => key_of(label),
            key => key.to_owned(),
        };
        if before.iter().any(|question| question.key == key) {
            let why =
                Text::new("two questions have the key `{key}`: give one of them another").with("key", &key);
            self.errors.push(FieldError::new(path("name"), why));
            return None;
        }
        let formula = self.formula(&path("formula"), text)?;
        let unit = match text_of(row, "unit") {
            "" => None,
            unit => match dalembert_units::unit(unit) {
                Ok(unit) => Some(unit),
                Err(error) => {
                    self.errors.push(FieldError::new(path("unit"), crate::reading::text(&error)));
                    return None;
                }
            },
        };
        let symbol = Some(text_of(row, "symbol")).filter(|symbol| !symbol.is_empty()).map(str::to_owned);
        Some(Question { label: label.to_owned(), key, symbol, unit, formula })
    }

    fn formula(&mut self, path: &str, text: &str) -> Option<Formula> {
        match Formula::parse(text, &|name| self.names.contains(name)) {
            Ok(formula) => Some(formula),
            Err(error) => {
                self.errors.push(field_error(path, error));
                None
            }
        }
    }
}

/// The key of a question: its words in small letters with `_` between them.
fn key_of(label: &str) -> String {
    let words = label.split(|c: char| !c.is_alphanumeric()).filter(|word| !word.is_empty());
    words.map(str::to_lowercase).collect::<Vec<_>>().join("_")
}

/// Text of a field of a row; empty where it has none.
pub(super) fn text_of<'v>(row: &'v Value, field: &str) -> &'v str {
    match row {
        Value::Group(record) => match record.get(field) {
            Some(Value::Text(text)) => text.trim(),
            _ => "",
        },
        _ => "",
    }
}
