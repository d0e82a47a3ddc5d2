//! Definitions, questions, given answers and configurations as they are typed, row by row.

use dalembert_units::{self as units, Unit};

use super::{
    COMMON_LISTS, Definition, Plan, PlannedInput, Question, field_error,
    names::{self, Names},
    rows::{question_key, rows, text_of},
    scope,
    unknowns::{self, Unknown, is_unknown},
};
use crate::{
    Field, FieldError, Number, Record, Symbol, Text, Value,
    ascii::index,
    formula::{Expression, Formula, Function},
    intern::intern,
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
            plan.definitions.extend(self.definition([scope, n], row, &mut plan.unknowns));
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
        for (n, row) in changes.iter().enumerate() {
            match self.change([scope, n], row, record) {
                Ok(None) => {}
                Ok(Some(input)) if plan.inputs.iter().any(|other| other.path == input.path) => {
                    let why = Text::new("`{name}` is changed twice: keep one of the two");
                    self.errors.push(FieldError::new(&input.error_path, why.with("name", &input.path)));
                }
                Ok(Some(input)) => {
                    self.names.add(input.clone());
                    plan.inputs.push(input);
                }
                Err(error) => self.errors.push(error),
            }
        }
    }

    /// The definition in a row, counted from 0.
    fn definition(
        &mut self,
        [scope, n]: [usize; 2],
        row: &Value,
        unknowns: &mut Vec<Unknown>,
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
        if is_unknown(text) {
            return match unknowns::read(text, &outside(name), None) {
                Ok((unknown, start)) => {
                    unknowns.push(unknown);
                    let (unit, si) = (start.unit.clone(), start.si);
                    let formula = Formula { root: Expression::Quantity(start), text: text.to_owned() };
                    Some(defined(formula, unit, si))
                }
                Err(why) => {
                    self.errors.push(FieldError::new(path("formula"), why));
                    None
                }
            };
        }
        let formula = self.formula(scope, &path("formula"), text)?;
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

    /// The input that a row of a configuration changes, with its formula; none where it changes nothing yet.
    fn change(
        &self,
        [scope, n]: [usize; 2],
        row: &Value,
        record: &mut Record,
    ) -> Result<Option<PlannedInput>, FieldError> {
        let of = &self.names.scopes[scope];
        let path = |part: &str| of.outside(&format!("configuration[{}].{part}", n + 1));
        let [name, inner, text] = ["name", "input", "formula"].map(|field| text_of(row, field));
        let fail = |part: &str, why: Text| Err(FieldError::new(path(part), why));
        if !is_name(name) {
            let why = "a name of letters and digits is needed, for example weighted";
            return fail("name", why.into());
        }
        if self.names.is_input_name(scope, name) {
            let why = Text::new("`{name}` is the name of an input: choose another");
            return fail("name", why.with("name", name));
        }
        if inner.is_empty() && text.is_empty() {
            return Ok(None);
        }
        let named = self.names.with_symbol(scope, inner);
        let inner = match &named[..] {
            [only] => only.inner.clone(),
            _ => inner.to_owned(),
        };
        let base = of.outside(&inner);
        let Some(measure) = names::measure_at(record, &base) else {
            let known: Vec<&str> = self.names.inner_paths(scope);
            let why = match crate::nearest(&inner, known.iter().copied()) {
                Some(near) => Text::new("`{name}` is no quantity of this problem; did you mean `{near}`?")
                    .with("near", near),
                None => {
                    Text::new("`{name}` is no quantity of this problem: a configuration changes quantities")
                }
            };
            return fail("input", why.with("name", &inner));
        };
        let configuration = of.outside(name);
        let at = self.names.scopes.iter().position(|scope| scope.name == configuration);
        let Some(at) = at.filter(|at| *at != scope) else {
            return fail(
                "name",
                Text::new("`{name}` is the name of a problem: choose another").with("name", name),
            );
        };
        let one = measure.meant(text);
        let (formula, unit, si) = match units::read_quantity(text, &one.own_unit(), one.kind()) {
            Ok(quantity) => {
                if let Some(why) = one.outside(quantity.si, text) {
                    return fail("formula", why);
                }
                let (unit, si) = (quantity.unit.clone(), quantity.si);
                (Formula { root: Expression::Quantity(quantity), text: text.to_owned() }, unit, si)
            }
            Err(error) => match Formula::parse(text, &|name| self.names.contains(scope, name)) {
                Ok(formula) if !formula.names().is_empty() => (formula, measure.own_unit(), f64::NAN),
                _ => {
                    let why = crate::reading::text(&error);
                    return Err(FieldError { path: path("formula"), why, span: error.span() });
                }
            },
        };
        let input = self.names.input(&base);
        let field =
            input.as_ref().map_or_else(|| field_at(record, &base), |input| Some((input.label, input.symbol)));
        let (label, symbol) = field.unwrap_or((intern(&inner), Symbol::from("")));
        Ok(Some(PlannedInput {
            scope: at,
            path: self.names.scopes[at].outside(&inner),
            inner,
            error_path: path("formula"),
            label,
            symbol: Symbol { of: intern(name), ..symbol },
            measure,
            unit,
            value: Number::Scalar(si),
            formula: Some(formula),
        }))
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

/// Returns true if a word may name a definition or a configuration.
fn is_name(name: &str) -> bool {
    let continues = |c: char| {
        c.is_alphanumeric()
            || matches!(c, '_' | '′')
            || index(c).is_some_and(|plain| plain.is_ascii_alphanumeric())
    };
    name.chars().next().is_some_and(|c| c.is_alphabetic() || c == '_') && name.chars().all(continues)
}

/// Label and symbol of the optional input at a path that is left out.
fn field_at(record: &Record, path: &str) -> Option<(&'static str, Symbol)> {
    let mut found: Option<&'static Field> = None;
    record.leaves(&mut |known, field, _| {
        if known == path {
            found = Some(field);
        }
    });
    found.map(|field| (field.label, Symbol::from(field.symbol)))
}
