//! Definitions, formulas of inputs, questions of the user's own, and unknowns: what every problem has beside its inputs.
//!
//! A definition is a named quantity, `nu = 0.3` or `G = E/(2*(1+nu))`. An input takes a formula over definitions and
//! other inputs. A question is a formula over definitions, inputs, answers and steps, and is an answer like any other.
//! An input may be unknown, `?`, where an answer is given in its place. They are read into a [`Plan`], which every reading
//! of the problem follows: the worked one records each formula as a step, the plain one does the same operations in the
//! same order.

mod fields;
mod names;
mod plain_reading;
mod questions;
mod reader;
mod typed;
mod unknowns;

use std::{collections::BTreeMap, sync::Arc};

use dalembert_units::{Quantity, Unit};

pub(crate) use self::{
    fields::shape_of,
    plain_reading::prepare,
    questions::ask,
    unknowns::{GivenAnswer, Unknown, is_unknown},
};
use self::{
    names::{Names, Place},
    reader::{Reader, text_of},
};
use crate::{
    Determined, FieldError, Measure, Number, Plain, Record, Refusal, Sheet, Stop, Symbol, Text, Value,
    formula::{Formula, FormulaError, Operand, evaluate, normalised, unit_of},
    intern::intern,
};

/// The formulas of a problem, in an order in which each rests on earlier ones.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Plan {
    definitions: Vec<Definition>,
    /// The inputs that have a formula, and those that a formula names.
    inputs: Vec<PlannedInput>,
    order: Vec<Place>,
    questions: Vec<Question>,
    /// Unknowns; none once they are found.
    unknowns: Vec<Unknown>,
    /// The answers that they are found from.
    givens: Vec<GivenAnswer>,
    /// The unknowns as they were found.
    determined: Option<Arc<Determined>>,
    names: Names,
}

#[derive(Clone, Debug, PartialEq)]
struct Definition {
    name: String,
    formula: Formula,
    unit: Unit,
    si: f64,
}

#[derive(Clone, Debug, PartialEq)]
struct PlannedInput {
    path: String,
    label: &'static str,
    symbol: Symbol,
    measure: Measure,
    unit: Unit,
    value: Number,
    formula: Option<Formula>,
}

#[derive(Clone, Debug, PartialEq)]
struct Question {
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
}

/// Reads definitions, formulas and questions, and writes the values of the inputs that have a formula into the record.
pub(crate) fn plan(record: &mut Record, pending: Vec<Pending>, errors: &mut Vec<FieldError>) {
    let rows = |name: &str| match record.get(name) {
        Some(Value::Rows(rows)) => rows.clone(),
        _ => Vec::new(),
    };
    let (definitions, questions, givens) = (rows("let"), rows("ask"), rows("given"));
    if definitions.is_empty() && questions.is_empty() && givens.is_empty() && pending.is_empty() {
        return;
    }
    let names = Names::of(record, definitions.iter().map(|row| text_of(row, "name")));
    let mut reader = Reader { names: &names, errors: Vec::new() };
    let mut found = Plan {
        definitions: Vec::new(),
        inputs: Vec::new(),
        order: Vec::new(),
        questions: Vec::new(),
        unknowns: Vec::new(),
        givens: Vec::new(),
        determined: None,
        names: Names::default(),
    };
    for (n, row) in definitions.iter().enumerate() {
        found.definitions.extend(reader.definition(n, row, &mut found.unknowns));
    }
    for (n, row) in questions.iter().enumerate() {
        found.questions.extend(reader.question(n, row, &found.questions));
    }
    let mut wrong = reader.errors;
    for (n, row) in givens.iter().enumerate() {
        match unknowns::given(n, text_of(row, "name"), text_of(row, "value")) {
            Ok(given) => found.givens.push(given),
            Err(error) => wrong.push(error),
        }
    }
    // Only what names something that is there is taken for a formula; any other text keeps its own error.
    for Pending { path, text, error } in pending {
        if is_unknown(&text) {
            let input = names.input(&path);
            let read =
                input.map(|input| unknowns::read(&text, &path, Some(input.measure)).map(|of| (input, of)));
            match read {
                Some(Ok((mut input, (unknown, start)))) => {
                    (input.unit, input.value) = (start.unit.clone(), Number::Scalar(start.si));
                    names::write_quantity(record, &path, start);
                    found.unknowns.push(unknown);
                    found.inputs.push(input);
                }
                Some(Err(why)) => wrong.push(FieldError::new(path, why)),
                None => wrong.push(error),
            }
            continue;
        }
        match Formula::parse(&text, &|name| names.contains(name)) {
            Ok(formula) if formula.names().iter().any(|(name, _)| names.contains(name)) => {
                if let Some(mut input) = names.input(&path) {
                    input.formula = Some(formula);
                    found.inputs.push(input);
                    continue;
                }
                wrong.push(error);
            }
            Err(formula) if mentions(&text, &names) => wrong.push(field_error(&path, formula)),
            _ => wrong.push(error),
        }
    }
    wrong.extend(found.uneven());
    if found.definitions.len() < definitions.len() || !wrong.is_empty() {
        errors.extend(wrong);
        return;
    }
    found.names = names;
    found.add_named_inputs();
    let evaluated = found.arrange().and_then(|()| found.renew(record));
    match evaluated {
        Ok(()) => record.plan = Some(Arc::new(found)),
        Err(error) => errors.push(error),
    }
}

/// Returns true if a text has a word that is a name.
fn mentions(text: &str, names: &Names) -> bool {
    let words = text.split(|c: char| !(c.is_alphanumeric() || matches!(c, '_' | '.' | '[' | ']')));
    words.filter(|word| !word.is_empty()).any(|word| names.contains(word))
}

fn field_error(path: &str, error: FormulaError) -> FieldError {
    FieldError { path: path.to_owned(), why: error.why, span: error.span }
}

impl Plan {
    /// Name, unit and value in SI of each definition that is a quantity and no formula: what can be varied.
    pub(crate) fn levers(&self) -> impl Iterator<Item = (&str, &Unit, f64)> {
        let levers = self.definitions.iter().filter(|definition| definition.formula.quantity().is_some());
        levers.map(|definition| (definition.name.as_str(), &definition.unit, definition.si))
    }

    /// Returns true if an input takes its value from a formula.
    pub(crate) fn has_formula(&self, path: &str) -> bool {
        self.inputs.iter().any(|input| input.path == path && input.formula.is_some())
    }

    /// Returns true if the value of an input or a definition is to be found.
    pub(crate) fn is_unknown(&self, name: &str) -> bool {
        self.unknowns.iter().any(|unknown| unknown.name == name)
    }

    /// The unknowns, and the answers that they are found from.
    pub(crate) fn search(&self) -> Option<(&[Unknown], &[GivenAnswer])> {
        (!self.unknowns.is_empty()).then_some((&self.unknowns, &self.givens))
    }

    /// The same plan with nothing to be found.
    pub(crate) fn without_unknowns(&self) -> Self {
        Self { unknowns: Vec::new(), givens: Vec::new(), ..self.clone() }
    }

    /// Gives every unknown the range that it was searched in, so that a solve with other inputs need not look for it.
    pub(crate) fn keep_ranges(&mut self, determined: &Determined) {
        for (unknown, found) in self.unknowns.iter_mut().zip(&determined.unknowns) {
            unknown.range = Some(found.range);
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

    /// The key of the question of that key or in those words.
    pub(crate) fn question(&self, name: &str) -> Option<&str> {
        let is_it = |question: &&Question| question.key == name || question.label == name;
        self.questions.iter().find(is_it).map(|question| question.key.as_str())
    }

    /// Reason for which there are too few given answers, or nothing to be found from them.
    fn uneven(&self) -> Option<FieldError> {
        let (unknowns, givens) = (self.unknowns.len(), self.givens.len());
        if unknowns == 0 && givens > 0 {
            let why = "nothing is unknown: write ? in the input that is to be found from it";
            return Some(FieldError::new("given[1].name", why));
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
        self.inputs.iter().find(|input| input.path == name).map_or_else(|| intern(name), |input| input.label)
    }

    /// The path that an error of an unknown is reported at.
    pub(crate) fn error_path(&self, name: &str) -> String {
        match self.definitions.iter().position(|definition| definition.name == name) {
            Some(at) => format!("let[{}].formula", at + 1),
            None => name.to_owned(),
        }
    }

    /// Gives a definition another value; whether there is one of that name that can take it.
    pub(crate) fn set(&mut self, name: &str, si: f64) -> bool {
        let levers = self.definitions.iter_mut().filter(|definition| definition.formula.quantity().is_some());
        match levers.into_iter().find(|definition| definition.name == name) {
            Some(definition) => {
                definition.si = si;
                true
            }
            None => false,
        }
    }

    /// Adds the inputs that formulas name.
    fn add_named_inputs(&mut self) {
        let formulas: Vec<&Formula> = self
            .definitions
            .iter()
            .map(|definition| &definition.formula)
            .chain(self.inputs.iter().filter_map(|input| input.formula.as_ref()))
            .collect();
        let named: Vec<String> = formulas
            .into_iter()
            .flat_map(Formula::names)
            .filter_map(|(name, _)| self.names.path_of_input(name))
            .collect();
        for path in named {
            if self.inputs.iter().all(|input| input.path != path)
                && let Some(input) = self.names.input(&path)
            {
                self.inputs.push(input);
            }
        }
    }

    /// Finds the order of evaluation.
    fn arrange(&mut self) -> Result<(), FieldError> {
        let all: Vec<Place> = (0..self.definitions.len())
            .map(Place::Definition)
            .chain((0..self.inputs.len()).map(Place::Input))
            .collect();
        let (mut order, mut open) = (Vec::new(), Vec::new());
        for place in all {
            self.visit(place, &mut order, &mut open)?;
        }
        self.order = order;
        Ok(())
    }

    fn visit(&self, place: Place, order: &mut Vec<Place>, open: &mut Vec<Place>) -> Result<(), FieldError> {
        if order.contains(&place) {
            return Ok(());
        }
        if let Some(start) = open.iter().position(|before| *before == place) {
            let circle: Vec<&str> =
                open[start..].iter().chain([&place]).map(|place| self.name_of(*place)).collect();
            let why = Text::new("defined in a circle: {circle}").with("circle", circle.join(" → "));
            return Err(FieldError::new(self.path_of(place), why));
        }
        open.push(place);
        for (name, _) in self.formula_of(place).map(Formula::names).unwrap_or_default() {
            if let Some(on) = self.find(name) {
                self.visit(on, order, open)?;
            }
        }
        open.pop();
        order.push(place);
        Ok(())
    }

    /// Meaning of a name in the formula of a definition or an input.
    fn find(&self, name: &str) -> Option<Place> {
        let by_path = |path: &str| self.inputs.iter().position(|input| input.path == path).map(Place::Input);
        if let Some(place) = by_path(name) {
            return Some(place);
        }
        let wanted = normalised(name);
        let definition =
            self.definitions.iter().position(|definition| normalised(&definition.name) == wanted);
        definition.map(Place::Definition).or_else(|| by_path(&self.names.path_of_input(name)?))
    }

    fn formula_of(&self, place: Place) -> Option<&Formula> {
        match place {
            Place::Definition(at) => Some(&self.definitions[at].formula),
            Place::Input(at) => self.inputs[at].formula.as_ref(),
        }
    }

    fn name_of(&self, place: Place) -> &str {
        match place {
            Place::Definition(at) => &self.definitions[at].name,
            Place::Input(at) => &self.inputs[at].path,
        }
    }

    /// The path that an error of a formula is reported at.
    fn path_of(&self, place: Place) -> String {
        match place {
            Place::Definition(at) => format!("let[{}].formula", at + 1),
            Place::Input(at) => self.inputs[at].path.clone(),
        }
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
        self.evaluate(&plain)?;
        for input in self.inputs.iter().filter(|input| input.formula.is_some()) {
            let Number::Scalar(si) = input.value else { continue };
            let quantity = Quantity { si, unit: input.unit.clone(), last_place: 0.0 };
            names::write_quantity(record, &input.path, quantity);
        }
        Ok(())
    }

    /// Evaluates every formula on numbers, in order.
    fn evaluate(&mut self, plain: &Plain<'_>) -> Result<(), FieldError> {
        for n in 0..self.order.len() {
            let place = self.order[n];
            let Some(formula) = self.formula_of(place) else { continue };
            // A quantity keeps the value it has: as typed, or as a study set it.
            if formula.quantity().is_some() {
                continue;
            }
            let fail = |error| field_error(&self.path_of(place), error);
            let scope = |name: &str| Ok(self.find(name).map(|place| self.operand(place)));
            let found = evaluate::<&Plain<'_>>(formula, &scope, plain).map_err(fail)?;
            let Operand::Number(si, dim) = found else {
                let why = Text::new("`{text}` is no single number").with("text", &formula.text);
                return Err(FieldError::new(self.path_of(place), why));
            };
            let unit = unit_of(formula, dim, &|name| self.find(name).map(|place| self.unit(place)));
            match place {
                Place::Definition(at) => {
                    let definition = &mut self.definitions[at];
                    (definition.unit, definition.si) = (unit, si);
                }
                Place::Input(at) => {
                    let input = &self.inputs[at];
                    let own = input.measure.own_unit();
                    if !own.dim.agrees(dim) {
                        let why = crate::reading::of_another_dimension(&formula.text, dim, &own);
                        return Err(FieldError::new(&input.path, why));
                    }
                    let written = format!(
                        "{} = {}",
                        formula.text,
                        dalembert_units::write_quantity(si, &own, <_>::default())
                    );
                    // An unknown has no value yet that a limit could be compared with.
                    let outside = input.measure.outside(si, &written).filter(|_| self.unknowns.is_empty());
                    if let Some(why) = outside {
                        return Err(FieldError::new(&input.path, why));
                    }
                    let unit = if unit.dim == own.dim { unit } else { own };
                    let input = &mut self.inputs[at];
                    (input.unit, input.value) = (unit, Number::Scalar(si));
                }
            }
        }
        Ok(())
    }

    fn unit(&self, place: Place) -> Unit {
        match place {
            Place::Definition(at) => self.definitions[at].unit.clone(),
            Place::Input(at) => self.inputs[at].unit.clone(),
        }
    }

    fn operand<'p>(&self, place: Place) -> Operand<&'p Plain<'p>> {
        match place {
            Place::Definition(at) => Operand::Number(self.definitions[at].si, self.definitions[at].unit.dim),
            Place::Input(at) => match self.inputs[at].value {
                Number::Scalar(si) => Operand::Number(si, self.inputs[at].unit.dim),
                Number::Vector(si) => Operand::Vector(si.into(), self.inputs[at].unit.dim),
            },
        }
    }

    /// Writes definitions and the formulas of inputs down as steps, before the problem itself.
    pub(crate) fn record(&self, sheet: &Sheet<'_>) -> Result<(), Refusal> {
        let mut nodes: BTreeMap<Place, crate::trace::Id> = BTreeMap::new();
        for &place in &self.order {
            let formula = self.formula_of(place);
            let id = match (place, formula) {
                (Place::Definition(at), Some(formula)) if formula.quantity().is_some() => {
                    let Definition { name, unit, si, .. } = &self.definitions[at];
                    let symbol = Symbol::from(intern(name));
                    self.record_unknown(sheet, name, symbol, unit, *si)
                        .unwrap_or_else(|| sheet.lift(name, symbol, unit, Number::Scalar(*si)))
                }
                (Place::Input(at), None) => {
                    let PlannedInput { path, symbol, unit, value, .. } = &self.inputs[at];
                    let unknown = match value {
                        Number::Scalar(si) => self.record_unknown(sheet, path, *symbol, unit, *si),
                        Number::Vector(_) => None,
                    };
                    unknown.unwrap_or_else(|| sheet.lift(path, *symbol, unit, *value))
                }
                (_, Some(formula)) => {
                    let scope = |name: &str| {
                        Ok(self.find(name).and_then(|place| {
                            let id = *nodes.get(&place)?;
                            Some(operand_at(sheet, id))
                        }))
                    };
                    let found = evaluate::<&Sheet<'_>>(formula, &scope, sheet)
                        .map_err(|error| Refusal::NoAnswer(error.why))?;
                    let Operand::Number(value, _) = found else { continue };
                    let (symbol, why) = match place {
                        Place::Definition(at) => {
                            (Symbol::from(intern(&self.definitions[at].name)), Text::new("Definition"))
                        }
                        Place::Input(at) => {
                            let label = self.inputs[at].label;
                            (
                                self.inputs[at].symbol,
                                Text::new("{input}, by its formula").with_text("input", label),
                            )
                        }
                    };
                    let unit = intern(&self.unit(place).ascii());
                    let unit = if unit.is_empty() { "1" } else { unit };
                    let step = crate::Worksheet::step(sheet, symbol, unit, value, why);
                    let Some(id) = step.node() else { continue };
                    if let Place::Input(at) = place {
                        sheet.lift_formula(&self.inputs[at].path, id);
                    }
                    id
                }
                (Place::Definition(_), None) => continue,
            };
            nodes.insert(place, id);
        }
        Ok(())
    }

    /// Writes an unknown that was found down as a step; `None` where there is none of that name.
    fn record_unknown(
        &self,
        sheet: &Sheet<'_>,
        name: &str,
        symbol: Symbol,
        unit: &Unit,
        si: f64,
    ) -> Option<crate::trace::Id> {
        let why = self.determined.as_ref()?.why(name)?;
        let unit = intern(&unit.ascii());
        let unit = if unit.is_empty() { "1" } else { unit };
        let id = crate::Worksheet::numerical(sheet, symbol, unit, si, why).node()?;
        sheet.lift_formula(name, id);
        Some(id)
    }
}

/// A node of the sheet as a value in a formula.
fn operand_at<'s>(sheet: &'s Sheet<'s>, id: crate::trace::Id) -> Operand<&'s Sheet<'s>> {
    let (number, dim) = {
        let solution = sheet.solution();
        let node = solution.trace.node(id);
        (node.number, node.dim)
    };
    match number {
        Number::Scalar(_) => Operand::Number(sheet.term(id), dim),
        Number::Vector(_) => Operand::Vector(sheet.vector_term(id), dim),
    }
}
