//! Configurations as they are typed: the quantities that rows change, and the parts of the inputs that they replace.
//!
//! A quantity that is there takes another value, or a formula. Anything else, another alternative, a count, a vector, a row
//! more, a cell of a table, replaces the smallest part of the inputs that holds it; what the part asks for stands in
//! further rows.

use dalembert_units::{self as units, Quantity, Unit};

use super::{
    Pending, Plan, PlannedInput, field_error, names,
    reader::{Reader, field_at, is_name},
    rows::text_of,
    scope,
};
use crate::{
    Draft, FieldError, FieldPath, Number, Record, Shape, Symbol, Text, Value, draft,
    formula::{Expression, Formula},
    gravity,
    intern::intern,
    own_fields,
    path::{Segment, is_within, segments, step, unknown, unknown_input},
    reading, table,
};

/// A part of the inputs that a configuration replaces.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Replacement {
    pub(super) scope: usize,
    /// Path within the problem.
    pub(super) inner: String,
    pub(super) value: Value,
}

/// A part on its way: the texts of the rows within it.
struct Part {
    /// The configuration.
    scope: usize,
    /// Path within the problem.
    root: String,
    shape: Shape,
    draft: Draft,
    /// The unit of a number alone, of a cell of a table.
    cell: Option<Unit>,
    /// Path within the problem of each row, and its place.
    rows: Vec<(String, usize)>,
}

impl Reader {
    /// Reads the configurations of a problem into a plan.
    pub(super) fn configurations(
        &mut self,
        scope: usize,
        rows: &[Value],
        record: &mut Record,
        plan: &mut Plan,
    ) {
        let mut parts = Vec::new();
        for (n, row) in rows.iter().enumerate() {
            match self.change([scope, n], row, record, &mut parts) {
                Ok(Some(input)) if plan.inputs.iter().any(|other| other.path == input.path) => {
                    self.errors.push(changed_twice(&input.error_path, &input.path));
                }
                Ok(Some(input)) => {
                    self.names.add(input.clone());
                    plan.inputs.push(input);
                }
                Ok(None) => {}
                Err(error) => self.errors.push(error),
            }
        }
        let mut known = Vec::new();
        for part in &parts {
            if !known.contains(&part.scope) {
                known.push(part.scope);
                let of: Vec<&Part> = parts.iter().filter(|other| other.scope == part.scope).collect();
                self.replace(scope, &of, record, plan);
            }
        }
    }

    /// The quantity that a row of a configuration changes, with its formula; `None` where it replaces a part.
    fn change(
        &self,
        [scope, n]: [usize; 2],
        row: &Value,
        record: &mut Record,
        parts: &mut Vec<Part>,
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
        // A configuration that changes nothing yet.
        if inner.is_empty() && text.is_empty() {
            return Ok(None);
        }
        let named = self.names.with_symbol(scope, inner);
        let inner = match &named[..] {
            [only] => only.inner.clone(),
            _ => inner.to_owned(),
        };
        let configuration = of.outside(name);
        let at = self.names.scopes.iter().position(|scope| scope.name == configuration);
        let Some(at) = at.filter(|at| *at != scope) else {
            return fail(
                "name",
                Text::new("`{name}` is the name of a problem: choose another").with("name", name),
            );
        };
        let base = of.outside(&inner);
        let part = parts.iter_mut().find(|part| part.scope == at && is_within(&inner, &part.root));
        let measure = names::measure_at(record, &base).filter(|_| part.is_none());
        let Some(measure) = measure else {
            let own = scope::record_of(record, of);
            let put = put_into_part(part, parts_of(own, &inner), at, &inner, n, text);
            return match put.map_err(|error| FieldError::new(path(error.0), error.1))? {
                Some(new) => {
                    parts.push(new);
                    Ok(None)
                }
                None => Ok(None),
            };
        };
        let one = measure.meant(text);
        let grade = measure.without_letter(text);
        let (formula, unit, si) = match units::read_quantity(grade, &one.own_unit(), one.kind()) {
            Ok(quantity) => {
                if let Some(why) = one.outside(quantity.si, text) {
                    return fail("formula", why);
                }
                let (unit, si) = (quantity.unit.clone(), quantity.si);
                (Formula { root: Expression::Quantity(quantity), text: text.to_owned() }, unit, si)
            }
            Err(error) => match Formula::parse(text, &|name| self.names.contains(scope, name)) {
                Ok(formula) if formula.calls() || !formula.names().is_empty() => {
                    (formula, measure.own_unit(), f64::NAN)
                }
                _ => {
                    let why = reading::text(&error);
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
            components: 1,
            unit,
            value: Number::Scalar(si),
            formula: Some(formula),
            is_cell: false,
        }))
    }

    /// Reads the parts that a configuration replaces, and the inputs in them.
    fn replace(&mut self, scope: usize, parts: &[&Part], record: &Record, plan: &mut Plan) {
        let (of, at) = (self.names.scopes[scope].clone(), parts[0].scope);
        let own = scope::record_of(record, &of);
        let error_of = |error: FieldError| {
            let part = parts.iter().find(|part| is_within(&error.path, &part.root)).unwrap_or(&parts[0]);
            let row = part.rows.iter().find(|(path, _)| *path == error.path);
            let path = |n: usize, field: &str| of.outside(&format!("configuration[{}].{field}", n + 1));
            match row {
                Some((_, n)) => FieldError { path: path(*n, "formula"), ..error },
                None => {
                    let why = Text::new("{path}: {why}").with("path", &error.path);
                    FieldError::new(path(part.rows[0].1, "input"), why.with_text("why", error.why))
                }
            }
        };
        let (mut patched, mut errors, mut pending) = (own.clone(), Vec::new(), Vec::new());
        let gravity = gravity::stated(own);
        for part in parts {
            let value = match &part.cell {
                Some(unit) => part.cell_value(unit).map_err(|error| errors.push(error)).ok(),
                None => {
                    let filled = gravity::filled_with(&part.draft, &part.shape, gravity.as_deref());
                    let (value, wrong, formulas) = draft::read_part(&filled, &part.shape, &part.root);
                    errors.extend(wrong);
                    pending.extend(formulas);
                    Some(value)
                }
            };
            if let Some(value) = value {
                names::replace(&mut patched, &part.root, value);
            }
        }
        let mut unresolved = Vec::new();
        draft::read_references(&mut patched, "", &mut unresolved);
        let is_here = |path: &str| parts.iter().any(|part| is_within(path, &part.root));
        errors.extend(unresolved.into_iter().filter(|error| is_here(&error.path)));
        if !errors.is_empty() {
            self.errors.extend(errors.into_iter().map(error_of));
            return;
        }
        let (root, mut found) = (FieldPath::TOP, Vec::new());
        names::collect(&patched, &root, &mut |field, field_path, measure, unit, value| {
            let inner = field_path.path();
            if is_here(&inner) {
                let symbol = field_path.symbol(field.symbol);
                found.push((inner, field.label, symbol, measure, unit.clone(), value));
            }
        });
        let in_cells = pending.iter().filter(|pending| pending.cell.is_some());
        self.errors.extend(in_cells.map(|pending| error_of(pending.error.clone())));
        let configuration = &self.names.scopes[at];
        let name = of.inside(configuration.name).unwrap_or(configuration.name);
        let mut inputs = Vec::new();
        for (inner, label, symbol, (measure, components), unit, value) in found {
            let typed = pending.iter().find(|pending| pending.path == inner);
            let formula = match (typed, value) {
                (Some(pending), _) => match self.formula_of_part(scope, pending) {
                    Ok(formula) => Some(formula),
                    Err(error) => {
                        self.errors.push(error_of(error));
                        continue;
                    }
                },
                (None, Number::Scalar(si)) => {
                    let text = units::write_quantity(si, &unit, <_>::default());
                    let quantity = Quantity { si, unit: unit.clone(), last_place: 0.0 };
                    Some(Formula { root: Expression::Quantity(quantity), text })
                }
                (None, Number::Vector(_)) => None,
            };
            let row = parts.iter().flat_map(|part| &part.rows).find(|(path, _)| *path == inner);
            let row = row.or_else(|| parts.iter().flat_map(|part| &part.rows).next()).map_or(0, |(_, n)| *n);
            inputs.push(PlannedInput {
                scope: at,
                path: configuration.outside(&inner),
                inner,
                error_path: of.outside(&format!("configuration[{}].formula", row + 1)),
                label,
                symbol: Symbol { of: intern(name), ..symbol },
                measure,
                components,
                unit,
                value,
                formula,
                is_cell: false,
            });
        }
        for input in inputs {
            self.names.add(input.clone());
            plan.inputs.push(input);
        }
        for part in parts {
            let value = match &part.cell {
                Some(unit) => part.cell_value(unit).ok(),
                None => names::value(&mut patched, &part.root),
            };
            if let Some(value) = value {
                self.names.replaced.push((at, part.root.clone()));
                plan.replacements.push(Replacement { scope: at, inner: part.root.clone(), value });
            }
        }
    }

    /// The formula of an input in a part that is replaced.
    fn formula_of_part(&self, scope: usize, pending: &Pending) -> Result<Formula, FieldError> {
        if super::has_unknown(&pending.text) {
            let why = "only an input of the problem itself can be unknown: enter a value here";
            return Err(FieldError::new(&pending.path, why));
        }
        match Formula::parse(&pending.text, &|name| self.names.contains(scope, name)) {
            Ok(formula)
                if formula.calls()
                    || formula.names().iter().any(|(name, _)| self.names.contains(scope, name)) =>
            {
                Ok(formula)
            }
            Err(error) if super::mentions(&pending.text, scope, &self.names) => {
                Err(field_error(&pending.path, error))
            }
            _ => Err(pending.error.clone()),
        }
    }
}

impl Part {
    /// The number of a cell of a table.
    fn cell_value(&self, unit: &Unit) -> Result<Value, FieldError> {
        let Draft::Leaf(text) = &self.draft else { return Err(FieldError::new(&self.root, "is missing")) };
        let kind = self.shape.measure().map_or(units::Kind::Other, |measure| measure.of(unit).kind());
        let read = units::read_quantity(text, unit, kind);
        read.map(Value::Quantity).map_err(|error| FieldError::new(&self.root, reading::text(&error)))
    }

    /// Writes the text of an input of the part.
    fn set(&mut self, inner: &str, text: &str) -> Result<(), FieldError> {
        let rest = inner[self.root.len()..].trim_start_matches('.');
        if rest.is_empty() {
            let chosen = draft::written(&self.shape, text, inner)?;
            // The alternative may be named behind what it holds.
            let is_chosen =
                matches!((&self.draft, &chosen), (Draft::OneOf(a, _), Draft::OneOf(b, _)) if a == b);
            if !is_chosen {
                self.draft = chosen;
            }
            return Ok(());
        }
        self.draft.set(&self.shape, rest, text)
    }
}

/// Puts the text of a row into the part that holds it; the part where it is a new one. An error has the field of the row.
fn put_into_part(
    part: Option<&mut Part>,
    new: Result<Part, FieldError>,
    scope: usize,
    inner: &str,
    n: usize,
    text: &str,
) -> Result<Option<Part>, (&'static str, Text)> {
    let row = (inner.to_owned(), n);
    let set = |part: &mut Part| part.set(inner, text).map_err(|error| ("formula", error.why));
    if let Some(part) = part {
        if part.rows.iter().any(|(path, _)| path == inner) {
            return Err(("input", changed_twice("", inner).why));
        }
        set(part)?;
        part.rows.push(row);
        return Ok(None);
    }
    let mut part = Part { scope, rows: vec![row], ..new.map_err(|error| ("input", error.why))? };
    set(&mut part)?;
    Ok(Some(part))
}

fn changed_twice(path: &str, name: &str) -> FieldError {
    FieldError::new(path, Text::new("`{name}` is changed twice: keep one of the two").with("name", name))
}

/// A place among the inputs of a problem.
enum Here<'r> {
    Record(&'r Record),
    Value(&'r Value, Shape),
}

/// The smallest part of the inputs of a problem that is another one where the input at a path is.
fn parts_of(own: &Record, path: &str) -> Result<Part, FieldError> {
    let mut here = Here::Record(own);
    let mut root = String::new();
    let part = |root: String, shape: Shape, draft: Draft, cell| Part {
        scope: 0,
        root,
        shape,
        draft,
        cell,
        rows: Vec::new(),
    };
    let segments = segments(path)?;
    for (n, segment) in segments.iter().enumerate() {
        let behind = match segment {
            Segment::Name(name) if root.is_empty() => name.clone(),
            Segment::Name(name) => format!("{root}.{name}"),
            Segment::Row(row) => format!("{root}[{}]", row + 1),
        };
        here = match (here, segment) {
            (Here::Record(record) | Here::Value(Value::Group(record), _), Segment::Name(name)) => {
                let fields = &record.fields[..own_fields(record.fields)];
                let at = fields.iter().position(|field| field.name == name);
                let at = at.ok_or_else(|| unknown_input(path, name, record.fields))?;
                Here::Value(&record.values[at], fields[at].shape)
            }
            (Here::Value(Value::Absent, shape), _) => {
                let shape = shape.present();
                return Ok(part(root, shape, Draft::blank(&shape), None));
            }
            (Here::Value(value, shape), segment) => match (value, shape.present(), segment) {
                (Value::OneOf { variant, fields }, Shape::OneOf(variants), Segment::Name(name)) => {
                    let known = || variants().iter().map(|variant| variant.name);
                    let at = known().position(|known| known == name);
                    let at = at.ok_or_else(|| unknown(path, name, known()))?;
                    if at != *variant {
                        let shape = shape.present();
                        return Ok(part(root, shape, Draft::alternative(&shape, at), None));
                    }
                    Here::Record(fields)
                }
                (Value::Rows(rows), Shape::Rows { item, most, .. }, Segment::Row(row)) => {
                    match rows.get(*row) {
                        Some(value) => Here::Value(value, *item()),
                        None if *row == rows.len() && *row < most => {
                            return Ok(part(behind, *item(), Draft::blank(item()), None));
                        }
                        None => return Err(draft::no_row(path, rows.len())),
                    }
                }
                (vector @ Value::Vector(_), shape @ Shape::Vector(..), Segment::Name(_)) => {
                    return Ok(part(root, shape, Draft::Leaf(draft::leaf_text(vector)), None));
                }
                (Value::Table(numbers), Shape::Table(columns), Segment::Row(row)) => {
                    let Some(Segment::Name(name)) = segments.get(n + 1) else {
                        let why = Text::new("name a cell of the table, as in {example}");
                        let column = columns().first().map_or("", |column| column.name);
                        return Err(FieldError::new(path, why.with("example", format!("{behind}.{column}"))));
                    };
                    let at = columns().iter().position(|column| column.name == name);
                    let at = at.ok_or_else(|| unknown_input(path, name, columns()))?;
                    if *row >= numbers.rows().len() {
                        return Err(draft::no_row(path, numbers.rows().len()));
                    }
                    let unit =
                        numbers.units.get(at).cloned().unwrap_or_else(|| table::own_unit(&columns()[at]));
                    return Ok(part(
                        path.to_owned(),
                        columns()[at].shape,
                        Draft::Leaf(String::new()),
                        Some(unit),
                    ));
                }
                (_, shape, segment) => match step(&shape, segment, path) {
                    Err(error) => return Err(error),
                    Ok(_) => {
                        return Err(FieldError::new(
                            path,
                            "is not an input of the problem with its present options",
                        ));
                    }
                },
            },
            (Here::Record(_), Segment::Row(_)) => {
                return Err(FieldError::new(path, "is not an input of the problem with its present options"));
            }
        };
        root = behind;
    }
    let shape = match here {
        Here::Value(_, shape) => shape.present(),
        // An alternative that is there already.
        Here::Record(_) => {
            return Err(FieldError::new(path, "is chosen already: change the inputs in it"));
        }
    };
    Ok(part(root, shape, Draft::Absent, None))
}
