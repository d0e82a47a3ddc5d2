//! Definitions, formulas of inputs, questions of the user's own, unknowns, configurations and links: what every problem has
//! beside its inputs.
//!
//! A definition is a named quantity, `nu = 0.3` or `G = E/(2*(1+nu))`; one that no input of its problem rests on may be
//! over answers. An input takes a formula over definitions and other inputs, and over the answers of problems that are
//! linked. A question is a formula over definitions, inputs,
//! answers and steps, and is an answer like any other. An input may be unknown, `?`, where an answer is given in its place.
//! A configuration is the same problem with some inputs changed. They are read into a [`Plan`], which every reading of
//! the problem follows: the worked one records each formula as a step, the plain one does the same operations in the same
//! order.

mod cells;
mod configurations;
mod fields;
mod names;
mod order;
mod plain_reading;
mod questions;
mod reader;
mod rows;
mod scope;
mod solve;
mod typed;
mod unknowns;
mod working;

use std::{
    collections::{BTreeMap, BTreeSet},
    sync::Arc,
};

use dalembert_units::{self as units, Dim, Quantity, Unit, VectorQuantity};

use self::{
    configurations::Replacement,
    names::{Named, Names, Place},
    reader::Reader,
    rows::rows,
};
pub use self::{
    fields::{COMMON_LISTS, own_fields, within_problem},
    unknowns::{Goal, has_unknown, split_tolerance},
};
pub(crate) use self::{
    fields::{are_of_problem, linked_problem, shape_of, with_common, without_linked},
    plain_reading::prepare,
    unknowns::{AXES, GivenAnswer, Tolerance, Unknown, is_unknown, read_vector},
};
use crate::{
    Determined, FieldError, Measure, Number, Plain, Record, Stop, Symbol, Text, Value,
    cell::{CellPlace, HeadingWords, add_fault},
    formula::{Formula, FormulaError, Operand, evaluate, missing, nearest_names, unit_of},
    intern::intern,
};

/// The formulas of a problem, in an order in which each rests on earlier ones.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Plan {
    definitions: Vec<Definition>,
    /// The inputs that have a formula, and those that a formula names.
    inputs: Vec<PlannedInput>,
    questions: Vec<Question>,
    /// The parts of the inputs that configurations replace.
    replacements: Vec<Replacement>,
    order: Vec<Place>,
    /// Definitions that inputs of their own problem rest on, by their places: they take no answers of it.
    before_solution: BTreeSet<usize>,
    /// Definitions, inputs and questions that rest on the solution of a problem: they have no value before.
    after_solution: BTreeSet<Place>,
    /// Definitions and inputs whose formula has its unit.
    with_unit: BTreeSet<Place>,
    /// Meanings of the names in each formula.
    meanings: Arc<BTreeMap<Place, Vec<(String, Option<Named>)>>>,
    /// Unknowns; none once they are found.
    unknowns: Vec<Unknown>,
    /// The answers that they are found from.
    givens: Vec<GivenAnswer>,
    /// Tolerances of inputs and definitions.
    tolerances: Vec<Tolerance>,
    /// The unknowns as they were found.
    determined: Option<Arc<Determined>>,
    names: Arc<Names>,
}

#[derive(Clone, Debug, PartialEq)]
struct Definition {
    scope: usize,
    /// Place in its list, counted from 0.
    row: usize,
    /// Name in its scope.
    name: String,
    formula: Formula,
    unit: Unit,
    si: f64,
}

#[derive(Clone, Debug, PartialEq)]
struct PlannedInput {
    scope: usize,
    /// Path from outside: `fan.mass`, of a configuration `weighted.mass`.
    path: String,
    /// Path within its problem: `mass`.
    inner: String,
    /// Path that an error of its value is reported at.
    error_path: String,
    label: &'static str,
    symbol: Symbol,
    measure: Measure,
    /// Number of components of a vector; 1 of a number.
    components: usize,
    unit: Unit,
    value: Number,
    formula: Option<Formula>,
    /// True of a cell of a table.
    is_cell: bool,
}

#[derive(Clone, Debug, PartialEq)]
struct Question {
    scope: usize,
    label: String,
    key: String,
    symbol: Option<String>,
    unit: Option<Unit>,
    formula: Formula,
}

/// A text of an input that is no quantity, and may be a formula.
pub(crate) struct Pending {
    /// The path of the input.
    pub(crate) path: String,
    /// The text.
    pub(crate) text: String,
    /// Reason for which it is no quantity.
    pub(crate) error: FieldError,
    /// The cell of a table that it stands in.
    pub(crate) cell: Option<CellPlace>,
}

/// Reads definitions, formulas and questions, and writes the values of the inputs that have a formula into the record.
pub(crate) fn plan(
    record: &mut Record,
    pending: Vec<Pending>,
    headings: &[(String, HeadingWords)],
    errors: &mut Vec<FieldError>,
) {
    let scopes = scope::scopes(record);
    let is_empty = COMMON_LISTS.iter().all(|list| rows(record, list).is_empty());
    if pending.is_empty() && is_empty && scopes.len() == 1 {
        return;
    }
    let mut reader = Reader::new(Names::of(record, scopes));
    let mut found = Plan::default();
    for scope in 0..reader.names.scopes.len() {
        if reader.names.scopes[scope].problem == scope {
            reader.read(scope, record, &mut found);
        }
    }
    let Reader { names, errors: mut wrong } = reader;
    wrong.extend(headings.iter().filter_map(|(path, heading)| names.in_heading(path, heading)));
    for pending in pending {
        if let Err(error) = found.take(pending, &names, record) {
            add_fault(&mut wrong, error);
        }
    }
    found.names = Arc::new(names);
    wrong.extend(found.uneven());
    if !wrong.is_empty() {
        errors.extend(wrong);
        return;
    }
    found.add_named_inputs();
    let evaluated = found.arrange().and_then(|()| found.renew(record));
    match evaluated {
        Ok(()) => record.plan = Some(Arc::new(found)),
        Err(error) => errors.push(error),
    }
}

/// Returns true if a text has a word that is a name, or a link to a file.
fn mentions(text: &str, scope: usize, names: &Names) -> bool {
    let words = text.split(|c: char| !(c.is_alphanumeric() || matches!(c, '_' | '.' | '[' | ']')));
    text.contains('@') || words.filter(|word| !word.is_empty()).any(|word| names.contains(scope, word))
}

/// The formula that a text was parsed to, if it names something that is there, or calls a function. Otherwise the text
/// keeps its own error, unless a better one is returned.
fn formula_of(
    parsed: Result<Formula, FormulaError>,
    text: &str,
    scope: usize,
    names: &Names,
) -> Result<Formula, Option<FormulaError>> {
    match parsed {
        Ok(formula)
            if formula.calls() || formula.names().iter().any(|(name, _)| names.contains(scope, name)) =>
        {
            Ok(formula)
        }
        Ok(_) if text.contains('@') => {
            let why = "the linked file is not read yet: save this problem beside it".into();
            Err(Some(FormulaError { why, span: None }))
        }
        Ok(formula) => Err(misspelled(&formula, scope, names)),
        Err(wrong) if mentions(text, scope, names) => Err(Some(wrong)),
        Err(_) => Err(None),
    }
}

/// The refusal of a formula with a word that is nearly a name, and no unit.
fn misspelled(formula: &Formula, scope: usize, names: &Names) -> Option<FormulaError> {
    let near = |name: &str| {
        let known = names.known(scope, name);
        (units::unit(name).is_err() && !nearest_names(name, &known).is_empty()).then_some(known)
    };
    formula
        .names()
        .into_iter()
        .find_map(|(name, span)| Some(FormulaError { why: missing(name, &near(name)?), span: Some(span) }))
}

fn field_error(path: &str, error: FormulaError) -> FieldError {
    FieldError { path: path.to_owned(), why: error.why, span: error.span }
}

impl Plan {
    /// Takes the text of an input for a formula or an unknown. Only what names something that is there, or calls a
    /// function, is taken for a formula; any other text keeps its own error.
    fn take(&mut self, pending: Pending, names: &Names, record: &mut Record) -> Result<(), FieldError> {
        if pending.cell.is_some() {
            return self.take_cell(pending, names, record);
        }
        let Pending { path, text, error, .. } = pending;
        let Some(mut input) = names.input(&path) else { return Err(error) };
        if let Some((measure, len)) = names::vector_at(record, &path).filter(|_| has_unknown(&text)) {
            let (unknowns, vector) =
                read_vector(&text, &path, measure, len).map_err(|why| FieldError::new(&path, why))?;
            (input.unit, input.value) = (vector.unit, Number::Vector(vector.si));
            self.unknowns.extend(unknowns);
            self.inputs.push(input);
            return Ok(());
        }
        let typed = unknowns::read(&text, &path, Some(input.measure));
        if let Some(typed) = typed.map_err(|why| FieldError::new(&path, why))? {
            let quantity = typed.quantity;
            (input.unit, input.value) = (quantity.unit.clone(), Number::Scalar(quantity.si));
            names::write(record, &path, Value::Quantity(quantity));
            self.unknowns.extend(typed.unknown);
            self.tolerances.extend(typed.tolerance);
            self.inputs.push(input);
            return Ok(());
        }
        let parsed = Formula::parse(&text, &|name| names.contains(input.scope, name));
        let formula = formula_of(parsed, &text, input.scope, names);
        let formula = formula.map_err(|wrong| wrong.map_or(error, |wrong| field_error(&path, wrong)))?;
        input.formula = Some(formula);
        self.inputs.push(input);
        Ok(())
    }

    /// Name from outside, unit and value in SI of each definition that is a quantity and no formula: what can be varied.
    pub(crate) fn levers(&self) -> impl Iterator<Item = (String, &Unit, f64)> {
        let levers = self.definitions.iter().filter(|definition| definition.formula.quantity().is_some());
        levers.map(|definition| (self.outside(definition), &definition.unit, definition.si))
    }

    /// Returns true if an input, or the vector that it is a component of, takes its value from a formula.
    pub(crate) fn has_formula(&self, path: &str) -> bool {
        self.planned_input(path).is_some_and(|input| input.formula.is_some())
    }

    /// Returns true if the value of an input or a definition is to be found.
    pub(crate) fn is_unknown(&self, name: &str) -> bool {
        self.unknowns.iter().any(|unknown| unknown.name == name)
    }

    /// The unknowns, and the answers that they are found from.
    pub(crate) fn search(&self) -> Option<(&[Unknown], &[GivenAnswer])> {
        (!self.unknowns.is_empty()).then_some((&self.unknowns, &self.givens))
    }

    /// The requirements of answers.
    pub(crate) fn goals(&self) -> impl Iterator<Item = Goal> {
        self.givens.iter().map(|given| given.goal)
    }

    /// The tolerances of inputs and definitions.
    pub(crate) fn tolerances(&self) -> &[Tolerance] {
        &self.tolerances
    }

    /// The same plan with nothing to be found, what was found being known.
    pub(crate) fn without_unknowns(&self) -> Self {
        Self { unknowns: Vec::new(), givens: Vec::new(), determined: None, ..self.clone() }
    }

    /// Gives every unknown the range that it was searched in, so that a solve with other inputs need not look for it.
    pub(crate) fn keep_ranges(&mut self, determined: &Determined) {
        for (unknown, found) in self.unknowns.iter_mut().zip(&determined.unknowns) {
            if unknown.choices.is_empty() {
                unknown.range = Some(found.range);
            }
        }
    }

    /// Takes the unknowns as they were found.
    pub(crate) fn determine(&mut self, determined: Determined) {
        self.determined = Some(Arc::new(determined));
    }

    /// The unknowns as they were found.
    pub(crate) fn determined(&self) -> Option<&Arc<Determined>> {
        self.determined.as_ref()
    }

    /// The name of the answer to the question of that key or in those words.
    pub(crate) fn question(&self, name: &str) -> Option<String> {
        let scopes = &self.names.scopes;
        let is_it = |question: &&Question| {
            let scope = &scopes[question.scope];
            scope.inside(name).is_some_and(|name| question.key == name || question.label == name)
        };
        let found = self.questions.iter().find(is_it);
        found.map(|question| scopes[question.scope].outside(&question.key))
    }

    /// The name of a definition from outside.
    fn outside(&self, definition: &Definition) -> String {
        self.names.scopes[definition.scope].outside(&definition.name)
    }

    /// The definition of that name from outside.
    fn definition(&self, name: &str) -> Option<&Definition> {
        self.definitions.iter().find(|definition| self.outside(definition) == name)
    }

    /// Reason for which there are too few given answers, or nothing to be found from them.
    fn uneven(&self) -> Option<FieldError> {
        let (unknowns, givens) = (self.unknowns.len(), self.givens.len());
        if unknowns == 0 && givens > 0 {
            let why = "nothing is unknown: write ? in the input that is to be found from it";
            return Some(FieldError::new(format!("{}.name", self.givens[0].path), why));
        }
        if self.givens.iter().any(|given| given.goal.is_extreme()) {
            return None;
        }
        if let Some(limit) = self.givens.iter().find(|given| given.goal.is_limit()) {
            let why = "a limit alone determines nothing: write minimum or maximum at the answer that is to be least or largest";
            return Some(FieldError::new(format!("{}.value", limit.path), why));
        }
        if let Some(choice) = self.unknowns.iter().find(|unknown| !unknown.choices.is_empty()) {
            let why = "a choice needs an answer that is to be least or largest, as in [given] amplitude = \"minimum\"";
            return Some(FieldError::new(self.error_path(&choice.name), why));
        }
        if unknowns > givens {
            let why = Text::new(
                "more unknowns ({unknowns}) than given answers ({givens}): give another answer, as in [given] natural_frequency = \"8.2 Hz\", or enter a value here",
            );
            let path = self.error_path(&self.unknowns[givens].name);
            return Some(FieldError::new(path, why.with("unknowns", unknowns).with("givens", givens)));
        }
        None
    }

    /// Label of an input, or the name of a definition.
    pub(crate) fn label(&self, name: &str) -> &'static str {
        self.planned_input(name).map_or_else(|| intern(name), |input| input.label)
    }

    /// The input of that path, or that it is a component of.
    fn planned_input(&self, name: &str) -> Option<&PlannedInput> {
        let of = |path: &str| self.inputs.iter().find(|input| input.path == path);
        of(name)
            .or_else(|| of(name.rsplit_once('.')?.0).filter(|input| matches!(input.value, Number::Vector(_))))
    }

    /// The name of the problem or configuration that an input or a definition is of; empty for that of the file itself.
    pub(crate) fn problem_name(&self, name: &str) -> &'static str {
        let of = self.names.scopes.iter().filter(|scope| scope.inside(name).is_some());
        of.max_by_key(|scope| scope.name.len()).map_or("", |scope| scope.name)
    }

    /// The path that an error of an unknown is reported at.
    pub(crate) fn error_path(&self, name: &str) -> String {
        let input =
            || self.planned_input(name).map_or_else(|| name.to_owned(), |input| input.error_path.clone());
        self.definition(name).map_or_else(input, |definition| self.path_of_definition(definition))
    }

    fn path_of_definition(&self, definition: &Definition) -> String {
        self.names.scopes[definition.scope].outside(&format!("let[{}].formula", definition.row + 1))
    }

    /// The definition of that name that can take another value, by its place.
    pub(crate) fn lever(&self, name: &str) -> Option<usize> {
        self.definitions.iter().position(|definition| {
            definition.formula.quantity().is_some() && self.outside(definition) == name
        })
    }

    /// Gives a definition another value.
    pub(crate) fn set(&mut self, definition: usize, si: f64) {
        self.definitions[definition].si = si;
    }

    /// Evaluates every formula, and writes the inputs that have one into the record.
    pub(crate) fn renew(&mut self, record: &mut Record) -> Result<(), FieldError> {
        for input in &mut self.inputs {
            if input.formula.is_none()
                && let Some(value) = names::value_at(record, &input.path)
            {
                input.value = value;
            }
        }
        let stop = Stop::new();
        let plain = Plain::new(&stop);
        for n in 0..self.order.len() {
            let place = self.order[n];
            if !self.after_solution.contains(&place) {
                self.evaluate(place, &plain, &|_| None)?;
            }
        }
        for at in 0..self.inputs.len() {
            if !self.after_solution.contains(&Place::Input(at)) {
                self.write_input(at, record);
            }
        }
        Ok(())
    }

    /// Writes the value of the formula of an input into the record; one of a configuration stands beside it.
    fn write_input(&self, at: usize, record: &mut Record) {
        let input = &self.inputs[at];
        let is_own = self.names.scopes[input.scope].problem == input.scope;
        if is_own && input.formula.is_some() {
            names::write(record, &input.path, value_of(input));
        }
    }

    /// Evaluates a definition or an input on numbers. `answer` gives an answer or a question and its dimension.
    fn evaluate(
        &mut self,
        place: Place,
        plain: &Plain<'_>,
        answer: &dyn Fn(&Named) -> Option<(f64, Dim)>,
    ) -> Result<(), FieldError> {
        let Some(formula) = self.formula_of(place) else { return Ok(()) };
        // A quantity keeps the value it has: as typed, or as a study set it.
        if formula.quantity().is_some() {
            return Ok(());
        }
        let fail = |error| field_error(&self.path_of(place), error);
        let scope = |name: &str| -> Result<Option<Operand<&Plain<'_>>>, Text> {
            Ok(match self.find(place, name) {
                Some(named @ (Named::Answer(..) | Named::Question(_))) => {
                    answer(&named).map(|(si, dim)| Operand::Number(si, dim))
                }
                Some(named) => self.place(&named).map(|place| self.operand(place)),
                None => return self.is_too_early(place, name).map_or(Ok(None), Err),
            })
        };
        let known = |name: &str| self.names.known(self.scope_of_formula(place), name);
        let found = evaluate::<&Plain<'_>>(formula, &scope, &known, plain).map_err(fail)?;
        let (value, dim) = match found {
            Operand::Number(si, dim) if !self.is_vector(place) => (Number::Scalar(si), dim),
            Operand::Vector(si, dim) if self.is_vector(place) => (Number::Vector(si.into()), dim),
            _ => return Err(self.of_another_kind(place, formula)),
        };
        // The unit does not depend on the numbers.
        let unit = self.unit(place).filter(|_| self.with_unit.contains(&place));
        let unit = unit.unwrap_or_else(|| {
            unit_of(formula, dim, &|name| {
                self.find(place, name).and_then(|named| self.place(&named)).and_then(|place| self.unit(place))
            })
        });
        self.take_value(place, value, unit)
    }

    /// The refusal of a name in the formula of an input, or of a definition that it rests on, that is neither an input, a
    /// definition, nor a unit, nor nearly one: it may be that of an answer.
    fn is_too_early(&self, place: Place, name: &str) -> Option<Text> {
        let whole =
            name.rsplit_once(['.', '_']).filter(|(_, axis)| AXES.contains(axis)).map(|(whole, _)| whole);
        let is_there = |name: &str| self.find(place, name).is_some() || units::unit(name).is_ok();
        if is_there(whole.unwrap_or(name))
            || !nearest_names(name, &self.names.known(self.scope_of_formula(place), name)).is_empty()
        {
            return None;
        }
        let why = Text::new(
            "`{name}` is neither an input nor a definition, and no answer of this problem is known before its inputs; to find an input from an answer, write ? in it and the answer under [given]",
        );
        Some(why.with("name", name))
    }

    /// Returns true if a place is an input that is a vector.
    fn is_vector(&self, place: Place) -> bool {
        matches!(place, Place::Input(at) if matches!(self.inputs[at].value, Number::Vector(_)))
    }

    /// The refusal of a formula that is a vector or a list where a number is asked, or the other way round.
    fn of_another_kind(&self, place: Place, formula: &Formula) -> FieldError {
        let why = if self.is_vector(place) {
            Text::new("`{text}` is no vector: write its components, as in (R; 0) or (R; 0; 2*R)")
        } else {
            Text::new("`{text}` is no single number")
        };
        FieldError::new(self.path_of(place), why.with("text", &formula.text))
    }

    /// Takes the value of a formula, within the limits of its field.
    fn take_value(&mut self, place: Place, value: Number, unit: Unit) -> Result<(), FieldError> {
        match place {
            Place::Definition(at) => {
                let Number::Scalar(si) = value else { return Ok(()) };
                let definition = &mut self.definitions[at];
                (definition.unit, definition.si) = (unit, si);
            }
            Place::Input(at) => {
                let input = &self.inputs[at];
                let Some(formula) = &input.formula else { return Ok(()) };
                let own = input.measure.own_unit();
                if !own.dim.agrees(unit.dim) {
                    let why = crate::reading::of_another_dimension(&formula.text, unit.dim, &own);
                    return Err(FieldError::new(self.path_of(place), why));
                }
                // An unknown has no value yet that a limit could be compared with.
                if let Number::Scalar(si) = value
                    && self.unknowns.is_empty()
                    && !input.measure.permits(si)
                {
                    let value = dalembert_units::write_quantity(si, &own, <_>::default());
                    let written = format!("{} = {value}", formula.text);
                    if let Some(why) = input.measure.outside(si, &written) {
                        return Err(FieldError::new(self.path_of(place), why));
                    }
                }
                if let Number::Vector(si) = value
                    && si[input.components..].iter().any(|component| *component != 0.0)
                {
                    let why =
                        Text::new("`{text}` has a component along z: {components} components are asked")
                            .with("text", &formula.text)
                            .with("components", input.components);
                    return Err(FieldError::new(self.path_of(place), why));
                }
                let unit = if unit.dim == own.dim { unit } else { own };
                let input = &mut self.inputs[at];
                (input.unit, input.value) = (unit, value);
            }
            Place::Solution(_) | Place::Question(_) => {}
        }
        self.with_unit.insert(place);
        Ok(())
    }

    fn unit(&self, place: Place) -> Option<Unit> {
        match place {
            Place::Definition(at) => Some(self.definitions[at].unit.clone()),
            Place::Input(at) => Some(self.inputs[at].unit.clone()),
            Place::Solution(_) | Place::Question(_) => None,
        }
    }

    /// A definition or an input as a value in a formula.
    fn operand<'p>(&self, place: Place) -> Operand<&'p Plain<'p>> {
        match place {
            Place::Definition(at) => Operand::Number(self.definitions[at].si, self.definitions[at].unit.dim),
            Place::Input(at) => match self.inputs[at].value {
                Number::Scalar(si) => Operand::Number(si, self.inputs[at].unit.dim),
                Number::Vector(si) => Operand::Vector(si.into(), self.inputs[at].unit.dim),
            },
            Place::Solution(_) | Place::Question(_) => Operand::Number(f64::NAN, Dim::NONE),
        }
    }
}

/// The value of an input, as a record has it.
fn value_of(input: &PlannedInput) -> Value {
    let unit = input.unit.clone();
    match input.value {
        Number::Scalar(si) => Value::Quantity(Quantity { si, unit, last_place: 0.0 }),
        Number::Vector(si) => {
            Value::Vector(VectorQuantity { si, len: input.components, unit, last_place: 0.0 })
        }
    }
}
