//! Definitions, questions, given answers and configurations as they are typed, row by row.

use dalembert_units::{self as units, Quantity, Unit};

use super::{
    COMMON_LISTS, Definition, Plan, Question, field_error,
    names::Names,
    rows::{question_key, rows, text_of},
    scope,
    unknowns::{self, Tolerance, Unknown},
};
use crate::{
    Field, FieldError, Record, Symbol, Text, Value,
    ascii::index,
    formula::{Expression, Formula, Function},
};

/// Reader of definitions and questions; what is wrong with them is kept.
pub(super) struct Reader {
    pub(super) names: Names,
    pub(super) errors: Vec<FieldError>,
}

impl Reader {
    pub(super) fn new(names: Names) -> Self {
        Self { names, errors: Vec::new() }
    }

    /// Reads the lists of a problem into a plan.
    pub(super) fn read(&mut self, scope: usize, record: &mut Record, plan: &mut Plan) {
        let own = scope::record_of(record, &self.names.scopes[scope]);
        let [definitions, questions, givens, changes] = COMMON_LISTS.map(|list| rows(own, list).to_vec());
        for (n, row) in definitions.iter().enumerate() {
            plan.definitions.extend(self.definition(
                [scope, n],
                row,
                &mut plan.unknowns,
                &mut plan.tolerances,
            ));
        }
        for (n, row) in questions.iter().enumerate() {
            plan.questions.extend(self.question([scope, n], row, &plan.questions));
        }
        for (n, row) in givens.iter().enumerate() {
            let path = self.names.scopes[scope].outside(&format!("given[{}]", n + 1));
            match unknowns::given(&path, text_of(row, "name"), text_of(row, "value")) {
                Ok(mut given) => {
                    given.name = self.names.scopes[scope].outside(&given.name);
                    plan.givens.push(given);
                }
                Err(error) => self.errors.push(error),
            }
        }
        self.configurations(scope, &changes, record, plan);
    }

    /// The definition in a row, counted from 0.
    fn definition(
        &mut self,
        [scope, n]: [usize; 2],
        row: &Value,
        unknowns: &mut Vec<Unknown>,
        tolerances: &mut Vec<Tolerance>,
    ) -> Option<Definition> {
        let of = self.names.scopes[scope].name;
        let outside = |name: &str| if of.is_empty() { name.to_owned() } else { format!("{of}.{name}") };
        let path = |part: &str| outside(&format!("let[{}].{part}", n + 1));
        let (name, text) = (text_of(row, "name"), text_of(row, "formula"));
        let wrong = if name.is_empty() {
            Some("a name is needed, for example nu".into())
        } else if !is_name(name) {
            Some(
                Text::new("`{name}` is no name: write letters, digits and _, a letter first")
                    .with("name", name),
            )
        } else if Function::of(name).is_some() || matches!(name, "pi" | "π") {
            Some(
                Text::new("`{name}` is the name of a function or a constant: choose another")
                    .with("name", name),
            )
        } else if self.names.is_input_name(scope, name) {
            Some(Text::new("`{name}` is the name of an input: choose another").with("name", name))
        } else if self.names.is_scope_name(scope, name) {
            Some(
                Text::new("`{name}` is the name of a problem or a configuration: choose another")
                    .with("name", name),
            )
        } else if self.names.earlier_definition([scope, n], name) {
            Some(Text::new("`{name}` is defined twice: keep one of the two").with("name", name))
        } else {
            None
        };
        if let Some(why) = wrong {
            self.errors.push(FieldError::new(path("name"), why));
            return None;
        }
        let defined =
            |formula, unit, si| Definition { scope, row: n, name: name.to_owned(), formula, unit, si };
        match unknowns::read(text, &outside(name), None) {
            Ok(None) => {}
            Ok(Some(typed)) => {
                unknowns.extend(typed.unknown);
                tolerances.extend(typed.tolerance);
                let (unit, si) = (typed.quantity.unit.clone(), typed.quantity.si);
                let formula = Formula { root: Expression::Quantity(typed.quantity), text: text.to_owned() };
                return Some(defined(formula, unit, si));
            }
            Err(why) => {
                self.errors.push(FieldError::new(path("formula"), why));
                return None;
            }
        }
        let formula = match quantity_alone(text) {
            Some(quantity) => Formula { root: Expression::Quantity(quantity), text: text.trim().to_owned() },
            None => self.formula(scope, &path("formula"), text)?,
        };
        let (unit, si) =
            formula.quantity().map_or((Unit::ONE, 0.0), |quantity| (quantity.unit.clone(), quantity.si));
        Some(defined(formula, unit, si))
    }

    /// The question in a row, with those before it.
    fn question(&mut self, [scope, n]: [usize; 2], row: &Value, before: &[Question]) -> Option<Question> {
        let of = self.names.scopes[scope].name;
        let path = |part: &str| {
            let path = format!("ask[{}].{part}", n + 1);
            if of.is_empty() { path } else { format!("{of}.{path}") }
        };
        let (label, text) = (text_of(row, "name"), text_of(row, "formula"));
        if label.is_empty() {
            self.errors.push(FieldError::new(path("name"), "a name is needed, for example peak to peak"));
            return None;
        }
        let key = question_key(row);
        if before.iter().any(|question| question.scope == scope && question.key == key) {
            let why =
                Text::new("two questions have the key `{key}`: give one of them another").with("key", &key);
            self.errors.push(FieldError::new(path("name"), why));
            return None;
        }
        let formula = self.formula(scope, &path("formula"), text)?;
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
        Some(Question { scope, label: label.to_owned(), key, symbol, unit, formula })
    }

    fn formula(&mut self, scope: usize, path: &str, text: &str) -> Option<Formula> {
        match Formula::parse(text, &|name| self.names.contains(scope, name)) {
            Ok(formula) => Some(formula),
            Err(error) => {
                self.errors.push(field_error(path, error));
                None
            }
        }
    }
}

/// A text that is a number and a product of units, `3 kg*m^2`, which is no formula even where m is a name. Behind a stroke
/// either may be meant: `9.81 m/s^2*m`.
fn quantity_alone(text: &str) -> Option<Quantity> {
    let number = text.trim_start().trim_start_matches(['-', '−']);
    let is_product = number.starts_with(|c: char| c.is_ascii_digit() || c == '.') && !number.contains('/');
    let unit =
        number.trim_start_matches(|c: char| c.is_ascii_digit() || matches!(c, '.' | 'e' | 'E' | '-' | '+'));
    let is_plain = is_product && units::unit(unit.trim()).is_ok();
    is_plain.then(|| units::read_any(text).ok()).flatten()
}

/// Returns true if a word may name a definition or a configuration.
pub(super) fn is_name(name: &str) -> bool {
    let continues = |c: char| {
        c.is_alphanumeric()
            || matches!(c, '_' | '′')
            || index(c).is_some_and(|plain| plain.is_ascii_alphanumeric())
    };
    name.chars().next().is_some_and(|c| c.is_alphabetic() || c == '_') && name.chars().all(continues)
}

/// Label and symbol of the optional input at a path that is left out.
pub(super) fn field_at(record: &Record, path: &str) -> Option<(&'static str, Symbol)> {
    let mut found: Option<&'static Field> = None;
    record.leaves(&mut |known, field, _| {
        if known == path {
            found = Some(field);
        }
    });
    found.map(|field| (field.label, Symbol::from(field.symbol)))
}
