//! The worked reading: definitions and formulas of inputs as steps, each problem and configuration, and the questions.

use std::collections::BTreeMap;

use dalembert_numerics::{Real as _, Vector as _};
use dalembert_units::Unit;

use super::{
    Definition, Plan, PlannedInput,
    names::{Named, Place},
    questions,
    scope::TOP,
    unknowns::AXES,
    working::{Working, entry_of, operand_at},
};
use crate::{
    Entry, FieldPath, Number, ProblemSteps, Record, Refusal, Sheet, SolveError, Symbol, Text, Value,
    VectorTerm, Worksheet,
    formula::{Operand, evaluate, unit_of},
    intern::{intern, unit_text},
    trace::Id,
};

impl Plan {
    /// Solves the problem on a sheet: each formula is a step, each question an answer.
    pub(crate) fn solve(&self, entry: &Entry, record: &Record, sheet: &Sheet<'_>) -> Result<(), SolveError> {
        let scopes = self.names.scopes.len();
        let plan = self.clone();
        let mut working = Working { sheet, entry, record: record.clone(), nodes: BTreeMap::new(), plan };
        for at in 0..self.order.len() {
            let ends = || (sheet.solution().steps.len(), sheet.solution().exhibits.len());
            let (place, start) = (self.order[at], ends());
            working.place(place)?;
            if scopes > 1 {
                let name = self.names.scopes[self.scope_of(place)].name;
                let end = ends();
                let exhibits = start.1..end.1;
                sheet.add_problem_steps(ProblemSteps { name, steps: start.0..end.0, exhibits });
            }
        }
        if entry.is_pictured() {
            sheet.show_first(entry.pictured());
        }
        Ok(())
    }
}

impl<'s> Working<'_, 's> {
    fn place(&mut self, place: Place) -> Result<(), SolveError> {
        match place {
            Place::Solution(scope) => self.solution(scope),
            Place::Question(at) => {
                questions::ask(self, at);
                Ok(())
            }
            Place::Definition(_) | Place::Input(_) => {
                if let Some(node) = self.quantity(place)? {
                    self.nodes.insert(place, node);
                }
                Ok(())
            }
        }
    }

    /// Records a definition or an input that has a formula or is named in one.
    fn quantity(&mut self, place: Place) -> Result<Option<Id>, SolveError> {
        let sheet = self.sheet;
        match (place, self.plan.formula_of(place)) {
            (Place::Definition(at), Some(formula)) if formula.quantity().is_some() => {
                let definition = &self.plan.definitions[at];
                let Definition { name, unit, si, .. } = definition;
                let (symbol, name) = (Symbol::from(intern(name)), self.plan.outside(definition));
                let unknown = self.unknown(&name, symbol, unit, *si);
                let lifted = unknown.or_else(|| sheet.lifted(&name));
                Ok(Some(lifted.unwrap_or_else(|| sheet.lift(&name, symbol, unit, Number::Scalar(*si)))))
            }
            (Place::Input(at), None) => {
                let PlannedInput { path, symbol, unit, value, .. } = &self.plan.inputs[at];
                let unknown = match value {
                    Number::Scalar(si) => self.unknown(path, *symbol, unit, *si),
                    Number::Vector(si) => self.unknown_components(&self.plan.inputs[at], *si),
                };
                let lifted = unknown.or_else(|| sheet.lifted(path));
                Ok(Some(lifted.unwrap_or_else(|| sheet.lift(path, *symbol, unit, *value))))
            }
            (_, Some(_)) => self.formula(place),
            (_, None) => Ok(None),
        }
    }

    /// Records the formula of a definition or an input as a step.
    fn formula(&mut self, place: Place) -> Result<Option<Id>, SolveError> {
        let sheet = self.sheet;
        let Some(formula) = self.plan.formula_of(place).cloned() else { return Ok(None) };
        let formula = &formula;
        let own = self.plan.scope_of(place);
        let scope = |name: &str| match self.plan.find(place, name) {
            Some(Named::Answer(of, name)) if of == own => questions::answered(self, own, &name),
            Some(named) => self.operand(&named),
            None => Ok(None),
        };
        let fail = |error| SolveError::Fields(vec![super::field_error(&self.plan.path_of(place), error)]);
        let known = |name: &str| questions::known(self, self.plan.scope_of_formula(place), name);
        let found = evaluate::<&Sheet<'_>>(formula, &scope, &known, sheet).map_err(fail)?;
        let (number, dim) = match &found {
            Operand::Number(x, dim) if !self.plan.is_vector(place) => (Number::Scalar(x.value()), *dim),
            Operand::Vector(v, dim) if self.plan.is_vector(place) => (Number::Vector(v.value().into()), *dim),
            _ => return Err(SolveError::Fields(vec![self.plan.of_another_kind(place, formula)])),
        };
        if self.plan.after_solution.contains(&place) {
            let unit = unit_of(formula, dim, &|name| self.unit(place, name));
            self.plan.take_value(place, number, unit).map_err(|error| SolveError::Fields(vec![error]))?;
            if let Place::Input(at) = place {
                self.plan.write_input(at, &mut self.record);
            }
        }
        let name = formula.single_name().and_then(|name| self.plan.find(place, name));
        if let (Place::Input(at), Some(named @ (Named::Input(_) | Named::Definition(_)))) = (place, name) {
            // The input is that quantity; there is nothing to work out.
            let node = self.node(&named);
            self.sheet.put_lifted(&self.plan.inputs[at].path, node);
            return Ok(node);
        }
        let (symbol, why) = match place {
            Place::Definition(at) => {
                (Symbol::from(intern(&self.plan.definitions[at].name)), Text::new("Definition"))
            }
            Place::Input(at) => {
                let input = &self.plan.inputs[at];
                let why = match formula.single_name() {
                    Some(name) => Text::new("{input}, from {name}").with("name", name),
                    None => Text::new("{input}, by its formula"),
                };
                (input.symbol, why.with_text("input", input.label))
            }
            Place::Solution(_) | Place::Question(_) => return Ok(None),
        };
        let unit = unit_text(&self.plan.unit(place).unwrap_or(Unit::ONE));
        let written = match found {
            Operand::Number(x, _) => sheet.step(symbol, unit, x, why).node(),
            Operand::Vector(v, _) => sheet.step_vector(symbol, unit, v, why).node(),
            Operand::List(..) => None,
        };
        let Some(id) = written else { return Ok(None) };
        let path = match place {
            Place::Definition(at) => self.plan.outside(&self.plan.definitions[at]),
            Place::Input(at) => self.plan.inputs[at].path.clone(),
            Place::Solution(_) | Place::Question(_) => return Ok(None),
        };
        sheet.lift_formula(&path, id);
        Ok(Some(id))
    }

    /// Writes an unknown that was found down as a step; `None` where there is none of that name.
    fn unknown(&self, name: &str, symbol: Symbol, unit: &Unit, si: f64) -> Option<Id> {
        let determined = self.plan.determined.as_ref()?;
        let id = determined.write(self.sheet, name, (symbol, unit_text(unit)), si)?.node()?;
        self.sheet.lift_formula(name, id);
        Some(id)
    }

    /// Writes the components of a vector that were found down as steps, and the vector of them; `None` where none was.
    fn unknown_components(&self, input: &PlannedInput, si: [f64; 3]) -> Option<Id> {
        let PlannedInput { path, symbol, unit, label, .. } = input;
        let mut is_found = false;
        let components = [0, 1, 2].map(|axis| {
            let symbol = Symbol { of: intern(&joined(symbol.of, AXES[axis])), ..*symbol };
            let found = self.unknown(&format!("{path}.{}", AXES[axis]), symbol, unit, si[axis]);
            is_found |= found.is_some();
            found.map_or_else(|| self.sheet.constant(si[axis], unit), |id| self.sheet.term(id))
        });
        if !is_found {
            return None;
        }
        let [x, y, z] = components;
        let why = Text::new("{input}, with the components found").with_text("input", *label);
        let vector = VectorTerm::from_components(x, y, z);
        let id = self.sheet.step_vector(*symbol, unit_text(unit), vector, why).node()?;
        self.sheet.lift_formula(path, id);
        Some(id)
    }

    /// Solves the problem or the configuration of a scope.
    fn solution(&mut self, scope: usize) -> Result<(), SolveError> {
        let (own, problem) = (&self.plan.names.scopes[scope], self.plan.names.scopes[scope].problem);
        let of = &self.plan.names.scopes[problem];
        let Some(entry) = entry_of(self.entry, of.name) else { return Ok(()) };
        let inputs = self.plan.record_of(scope, &self.record);
        let (name, root) = (own.name, FieldPath::TOP);
        let here = if problem == TOP { root } else { root.field(of.name) };
        let mark = self.sheet.mark();
        let mut before = Vec::new();
        if scope != problem {
            self.sheet.keep_given_inputs();
            for (_, root) in self.plan.names.replaced.iter().filter(|(of, _)| *of == scope) {
                before.extend(self.sheet.take_lifted(&of.outside(root)));
            }
            for input in self.plan.inputs.iter().filter(|input| input.scope == scope) {
                let path = of.outside(&input.inner);
                let node = self.sheet.lifted(&input.path);
                before.push((path.clone(), self.sheet.put_lifted(&path, node)));
            }
        }
        let solved = entry.write(&Value::Group(inputs), &here, self.sheet);
        for (path, node) in before.into_iter().rev() {
            self.sheet.put_lifted(&path, node);
        }
        solved.map_err(|error| of_problem(name, error))?;
        if !name.is_empty() {
            self.sheet.name_problem(name, of.name, mark);
        }
        Ok(())
    }

    /// Value of a name in a formula of a definition or an input.
    pub(super) fn operand(&self, named: &Named) -> Result<Option<Operand<&'s Sheet<'s>>>, Text> {
        let node = match named {
            Named::Answer(scope, name) => return questions::answered_outside(self, *scope, name),
            Named::Question(at) => {
                let question = &self.plan.questions[*at];
                return questions::answered(self, question.scope, &question.key);
            }
            named => self.plan.place(named).and_then(|place| self.nodes.get(&place)),
        };
        Ok(node.map(|id| operand_at(self.sheet, *id)))
    }

    fn unit(&self, place: Place, name: &str) -> Option<Unit> {
        match self.plan.find(place, name)? {
            Named::Answer(scope, name) => questions::unit_at(self, scope, &name),
            Named::Question(at) => {
                let question = &self.plan.questions[at];
                questions::unit_at(self, question.scope, &question.key)
            }
            named => self.plan.place(&named).and_then(|place| self.plan.unit(place)),
        }
    }
}

/// Two indices of a symbol, one behind the other.
fn joined(of: &str, more: &str) -> String {
    if of.is_empty() { more.to_owned() } else { format!("{of},{more}") }
}

/// An error of a problem or a configuration, with its name.
fn of_problem(name: &str, error: SolveError) -> SolveError {
    match error {
        SolveError::Refused(Refusal::NoAnswer(why)) if !name.is_empty() => {
            let why = Text::new("{problem}: {why}").with("problem", name).with_text("why", why);
            Refusal::because(why).into()
        }
        error => error,
    }
}
