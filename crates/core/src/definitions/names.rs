//! The names that formulas of a problem can use: paths and symbols of its inputs, its definitions, and behind the name of
//! a linked problem or a configuration those of that one.

use dalembert_units::Unit;

use super::{
    PlannedInput,
    fields::linked_problem,
    rows::{question_key, rows, text_of},
    scope::{self, Scope, TOP},
};
use crate::{
    Field, Measure, Number, Record, Shape, Value,
    formula::normalised,
    path::{Segment, is_within, segments},
    printer,
    worksheet::FieldPath,
};

/// A part of a plan, by its place.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Place {
    /// A definition.
    Definition(usize),
    /// An input.
    Input(usize),
    /// The solution of a problem or a configuration, by its scope.
    Solution(usize),
    /// A question.
    Question(usize),
}

/// Meaning of a name in a formula.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Named {
    /// The input at this path.
    Input(String),
    /// A definition, by its place.
    Definition(usize),
    /// A question of another problem, by its place.
    Question(usize),
    /// An answer or a step of the problem or the configuration of a scope.
    Answer(usize, String),
}

/// The names of a problem.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Names {
    pub(super) scopes: Vec<Scope>,
    inputs: Vec<PlannedInput>,
    /// The symbol of each input, normalised.
    symbols: Vec<String>,
    /// Scope and name of each definition.
    definitions: Vec<(usize, String)>,
    /// Scope, key and label of each question.
    questions: Vec<(usize, [String; 2])>,
    /// Configuration and path of each part of the inputs that it replaces.
    pub(super) replaced: Vec<(usize, String)>,
}

impl Names {
    /// The names of the inputs of the chosen alternatives, of definitions and of questions.
    pub(super) fn of(record: &Record, scopes: Vec<Scope>) -> Self {
        let (mut inputs, mut definitions, mut questions) = (Vec::new(), Vec::new(), Vec::new());
        for (at, scope) in scopes.iter().enumerate().filter(|(at, scope)| scope.problem == *at) {
            let own = scope::record_of(record, scope);
            let root = FieldPath::TOP;
            let here = if at == TOP { root } else { root.field(scope.name) };
            collect(own, &here, &mut |field, field_path, (measure, components), unit, value| {
                let path = field_path.path();
                inputs.push(PlannedInput {
                    scope: at,
                    inner: scope.inside(&path).unwrap_or(&path).to_owned(),
                    error_path: path.clone(),
                    path,
                    label: field.label,
                    symbol: field_path.symbol(field.symbol),
                    measure,
                    components,
                    unit: unit.clone(),
                    value,
                    formula: None,
                    is_cell: false,
                });
            });
            let names = rows(own, "let").iter();
            definitions.extend(names.map(|row| (at, text_of(row, "name").to_owned())));
            let asked = rows(own, "ask").iter();
            questions.extend(asked.map(|row| (at, [question_key(row), text_of(row, "name").to_owned()])));
        }
        let symbols = inputs.iter().map(symbol_of).collect();
        Self { scopes, inputs, symbols, definitions, questions, replaced: Vec::new() }
    }

    /// Adds an input that a configuration changes.
    pub(super) fn add(&mut self, input: PlannedInput) {
        self.symbols.push(symbol_of(&input));
        self.inputs.push(input);
    }

    /// Returns true if a scope is that of an analysis: that of a file of linked problems is not.
    pub(super) fn has_analysis(&self, scope: usize) -> bool {
        scope != TOP || self.scopes.iter().all(|scope| scope.problem == TOP)
    }

    /// Returns true if a word in a formula of a scope is a name.
    pub(super) fn contains(&self, scope: usize, name: &str) -> bool {
        self.find(scope, name).is_some()
    }

    /// Meaning of a name in a formula of a scope; `None` where it is none but of an answer or a step of its own.
    pub(super) fn find(&self, scope: usize, name: &str) -> Option<Named> {
        self.local(scope, name).or_else(|| self.outside(scope, name))
    }

    /// Meaning of a name without a prefix.
    fn local(&self, scope: usize, name: &str) -> Option<Named> {
        let problem = self.scopes[scope].problem;
        let of =
            |scope: usize| self.inputs.iter().find(move |input| input.scope == scope && input.inner == name);
        if let Some(input) = of(scope).or_else(|| of(problem).filter(|_| !self.is_replaced(scope, name))) {
            return Some(Named::Input(input.path.clone()));
        }
        let wanted = normalised(name);
        let definition = |of: usize| {
            let is_it = |(scope, known): &(usize, String)| *scope == of && normalised(known) == wanted;
            self.definitions.iter().position(is_it)
        };
        if let Some(at) = definition(problem).or_else(|| definition(TOP)) {
            return Some(Named::Definition(at));
        }
        match &self.with_symbol(scope, name)[..] {
            [only] => Some(Named::Input(only.path.clone())),
            _ => self.namesake(scope, name),
        }
    }

    /// The only input of the chosen alternative of a choice, if it has the name of the choice: a quantity that alternatives
    /// were added to is still what it was called before.
    fn namesake(&self, scope: usize, name: &str) -> Option<Named> {
        let last = name.rsplit('.').next()?;
        let problem = self.scopes[scope].problem;
        let is_it = |input: &&PlannedInput| {
            let inside = input.inner.strip_prefix(name).and_then(|rest| rest.strip_prefix('.'));
            inside.and_then(|inside| inside.split_once('.')).is_some_and(|(_, field)| field == last)
        };
        let of = |scope: usize| self.inputs.iter().filter(move |input| input.scope == scope).find(is_it);
        let input = of(scope).or_else(|| of(problem).filter(|_| !self.is_replaced(scope, name)))?;
        Some(Named::Input(input.path.clone()))
    }

    /// Returns true if a configuration replaces the input at a path within its problem.
    pub(super) fn is_replaced(&self, scope: usize, inner: &str) -> bool {
        self.replaced.iter().any(|(of, root)| *of == scope && is_within(inner, root))
    }

    /// Meaning of a name behind that of another problem or configuration.
    fn outside(&self, scope: usize, name: &str) -> Option<Named> {
        let name = scope::without_file(name);
        let from = &self.scopes[self.scopes[scope].problem];
        let mut found: Option<(usize, &str)> = None;
        let full = from.outside(&name);
        for (at, other) in self.scopes.iter().enumerate().filter(|(_, other)| !other.name.is_empty()) {
            let whole = other.inside(&name).or_else(|| {
                let rest = other.inside(&full)?;
                name.ends_with(rest).then(|| &name[name.len() - rest.len()..])
            });
            if let Some(rest) = whole
                && at != scope
                && found.is_none_or(|(_, before)| rest.len() < before.len())
            {
                found = Some((at, rest));
            }
        }
        let (at, rest) = found?;
        if let Some(named) = self.local(at, rest) {
            return Some(named);
        }
        Some(match self.question(at, rest) {
            Some(question) => Named::Question(question),
            None => Named::Answer(at, rest.to_owned()),
        })
    }

    /// The question of a scope by its key or its words.
    pub(super) fn question(&self, scope: usize, name: &str) -> Option<usize> {
        self.questions.iter().position(|(of, words)| *of == scope && words.iter().any(|word| word == name))
    }

    /// Returns true if a word is the path of an input of a scope or the beginning of one.
    pub(super) fn is_input_name(&self, scope: usize, name: &str) -> bool {
        let begins = |path: &str| {
            path.strip_prefix(name).is_some_and(|rest| rest.is_empty() || rest.starts_with(['.', '[']))
        };
        self.inputs.iter().any(|input| input.scope == scope && begins(&input.inner))
    }

    /// True if one of the definitions of a scope before the row `n` has this name.
    pub(super) fn earlier_definition(&self, [scope, n]: [usize; 2], name: &str) -> bool {
        let wanted = normalised(name);
        let own = self.definitions.iter().filter(|(of, _)| *of == scope);
        own.take(n).any(|(_, definition)| normalised(definition) == wanted)
    }

    /// The names that a formula of a scope can use in place of a wrong one: paths and symbols of inputs, definitions, and
    /// those of other problems behind their names.
    pub(super) fn known(&self, scope: usize, name: &str) -> Vec<String> {
        let problem = self.scopes[scope].problem;
        let is_own = |of: usize| [scope, problem].contains(&of);
        let mut known = Vec::new();
        if let Some((_, rest)) = name.split_once('.') {
            let others = self.scopes.iter().filter(|other| !other.name.is_empty());
            known.extend(others.map(|other| other.outside(rest)));
        }
        for input in &self.inputs {
            let symbol = printer::symbol(&input.symbol);
            if is_own(input.scope) {
                known.push(input.inner.clone());
                known.extend((!symbol.is_empty()).then_some(symbol));
            } else {
                known.push(input.path.clone());
            }
        }
        let definitions = self.definitions.iter().filter(|(of, _)| is_own(*of) || *of == TOP);
        known.extend(definitions.map(|(_, name)| name.clone()));
        known
    }

    /// Returns true if a word is the name of a definition that formulas of a scope can use.
    pub(super) fn is_definition(&self, scope: usize, name: &str) -> bool {
        matches!(self.local(scope, name), Some(Named::Definition(_)))
    }

    /// The problem that the path of an input is of.
    pub(super) fn scope_of_input(&self, path: &str) -> usize {
        let scopes = self.scopes.iter().enumerate();
        let of = scopes.filter(|(at, scope)| scope.problem == *at && scope.inside(path).is_some());
        of.max_by_key(|(_, scope)| scope.name.len()).map_or(TOP, |(at, _)| at)
    }

    /// Returns true if a word is the name of a problem or a configuration.
    pub(super) fn is_scope_name(&self, scope: usize, name: &str) -> bool {
        let full = self.scopes[scope].outside(name);
        self.scopes.iter().any(|scope| !scope.name.is_empty() && (scope.name == name || scope.name == full))
    }

    /// The inputs with a symbol.
    pub(super) fn with_symbol(&self, scope: usize, name: &str) -> Vec<&PlannedInput> {
        let wanted = normalised(name);
        if wanted.is_empty() {
            return Vec::new();
        }
        let of = |scope: usize| {
            let all = self.inputs.iter().zip(&self.symbols);
            let own = all.filter(|(input, symbol)| input.scope == scope && **symbol == wanted);
            own.map(|(input, _)| input).collect::<Vec<_>>()
        };
        let mut own = of(scope);
        if own.is_empty() {
            own = of(self.scopes[scope].problem);
            own.retain(|input| !self.is_replaced(scope, &input.inner));
        }
        own
    }

    /// The input at a path.
    pub(super) fn input(&self, path: &str) -> Option<PlannedInput> {
        self.inputs.iter().find(|input| input.path == path).cloned()
    }
}

/// The symbol of an input, normalised; empty where it has none.
fn symbol_of(input: &PlannedInput) -> String {
    if input.symbol.base.is_empty() { String::new() } else { normalised(&printer::symbol(&input.symbol)) }
}

/// Calls `visit` with every number and vector of a record, each with its measure and its number of components.
pub(super) fn collect(
    record: &Record,
    field_path: &FieldPath<'_>,
    visit: &mut dyn FnMut(&'static Field, &FieldPath<'_>, (Measure, usize), &Unit, Number),
) {
    for (field, value) in record.fields.iter().zip(&record.values) {
        let of = if is_nested(&field.shape) { field.symbol } else { "" };
        if linked_problem(value).is_none() {
            value_of(value, &field.shape, field, &field_path.field_of(field.name, of), visit);
        }
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
    field: &'static Field,
    field_path: &FieldPath<'_>,
    visit: &mut dyn FnMut(&'static Field, &FieldPath<'_>, (Measure, usize), &Unit, Number),
) {
    match (value, shape.present()) {
        (Value::Quantity(quantity), Shape::Quantity(measure)) => {
            visit(field, field_path, (measure, 1), &quantity.unit, Number::Scalar(quantity.si));
        }
        (Value::Vector(vector), Shape::Vector(measure, len)) => {
            visit(field, field_path, (measure, len), &vector.unit, Number::Vector(vector.si));
        }
        (Value::Group(record), _) => collect(record, field_path, visit),
        (Value::OneOf { variant, fields }, Shape::OneOf(variants)) => {
            if let Some(variant) = variants().get(*variant) {
                collect(fields, &field_path.field(variant.name), visit);
            }
        }
        (Value::Rows(rows), Shape::Rows { item, .. }) => {
            for (n, row) in rows.iter().enumerate() {
                value_of(row, item(), field, &field_path.row(n), visit);
            }
        }
        _ => {}
    }
}

/// The number or vector at a path.
pub(super) fn value_at(record: &mut Record, path: &str) -> Option<Number> {
    match at(record, path)?.0 {
        Value::Quantity(quantity) => Some(Number::Scalar(quantity.si)),
        Value::Vector(vector) => Some(Number::Vector(vector.si)),
        _ => None,
    }
}

/// The measure of the quantity at a path, an optional one that is left out included.
pub(super) fn measure_at(record: &mut Record, path: &str) -> Option<Measure> {
    match at(record, path)? {
        (Value::Quantity(_) | Value::Absent, Shape::Quantity(measure)) => Some(measure),
        _ => None,
    }
}

/// The measure and the number of components of the vector at a path.
pub(super) fn vector_at(record: &mut Record, path: &str) -> Option<(Measure, usize)> {
    match at(record, path)?.1 {
        Shape::Vector(measure, len) => Some((measure, len)),
        _ => None,
    }
}

/// The value at a path.
pub(super) fn value(record: &mut Record, path: &str) -> Option<Value> {
    at(record, path).map(|(value, _)| value.clone())
}

/// Puts another value at a path, or a row more behind the last one.
pub(super) fn replace(record: &mut Record, path: &str, new: Value) {
    let Ok(segments) = segments(path) else { return };
    if let Some(Segment::Row(row)) = segments.last()
        && let Some((Value::Rows(rows), ..)) = record.place_mut(&segments[..segments.len() - 1])
        && rows.len() == *row
    {
        rows.push(new);
        return;
    }
    write(record, path, new);
}

/// Writes a value at a path, or a number into a cell of a table.
pub(super) fn write(record: &mut Record, path: &str, value: Value) {
    let Ok(segments) = segments(path) else { return };
    match record.place_mut(&segments) {
        Some((place, _, [])) => *place = value,
        Some((Value::Table(table), Shape::Table(columns), [Segment::Row(row), Segment::Name(name)])) => {
            let column = columns().iter().position(|column| column.name == *name);
            let cell = column.and_then(|column| table.rows_mut().nth(*row)?.get_mut(column));
            if let (Some(cell), Value::Quantity(quantity)) = (cell, value) {
                *cell = quantity.si;
            }
        }
        _ => {}
    }
}

fn at<'r>(record: &'r mut Record, path: &str) -> Option<(&'r mut Value, Shape)> {
    let segments = segments(path).ok()?;
    let found = record.place_mut(&segments).filter(|(.., rest)| rest.is_empty());
    found.map(|(value, shape, _)| (value, shape))
}
