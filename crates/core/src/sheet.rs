//! The sheet on which a problem is worked: a [`Worksheet`] that records everything.
//!
//! A [`Term`] is a number that remembers how it was found. The formula that is shown is the one that was
//! evaluated, and its dimensions are followed as it is evaluated.

mod common_errors;
mod early;
mod holding;
mod term;
mod vect;

use std::{cell::RefCell, collections::HashMap, ops::Range};

use dalembert_numerics::intervals::IntervalSet;
use dalembert_numerics::{Real, Vector};
use dalembert_units::{self as units, Dim, Unit};
use nalgebra::Vector3;

pub use self::{term::Term, vect::VectorTerm};
use crate::{
    Answer, CommonError, Exhibit, Locale, Name, ProblemSteps, Reason, Refusal, Sides, Solution, Step, Stop,
    Symbol, Text, Value, Worksheet, derive_support,
    intern::intern,
    mutation::Mutant,
    path::is_within,
    printer,
    solution::AnswerValue,
    trace::{Id, Number, Op, ROUNDING, TraceNode},
    worksheet::InputNumber,
};

/// The largest relative difference of two ways to the same number, where rounding does not explain a larger one.
const AGREEMENT: f64 = 1e-9;

/// Permitted difference of two independent computations of a number, over the first-order bound of their rounding
/// errors: a numerical method has an error of its own, of a few times what the last places of its inputs do.
const WAYS: f64 = 8.0;

/// Records a solve as a [`Solution`].
pub struct Sheet<'a> {
    solution: RefCell<Solution>,
    stop: &'a Stop,
    /// The inputs that formulas needed before the solve, by path.
    lifted: RefCell<HashMap<String, Id>>,
    /// Steps that stand before the solution they are of: it goes on with them where it comes to them.
    early: RefCell<Vec<usize>>,
    /// Common errors of steps that are yet to be written.
    common_errors: RefCell<Vec<(Symbol, CommonError)>>,
    /// The number that is made wrongly.
    mutant: Option<Mutant>,
}

/// Lengths of the lists of a sheet before the solution of one of several problems.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Mark {
    answers: usize,
    checks: usize,
    warnings: usize,
    exhibits: usize,
}

impl<'a> Sheet<'a> {
    /// An empty sheet.
    pub fn new(stop: &'a Stop) -> Self {
        Self {
            solution: RefCell::default(),
            stop,
            lifted: RefCell::default(),
            early: RefCell::default(),
            common_errors: RefCell::default(),
            mutant: None,
        }
    }

    /// An empty sheet on which one number comes out wrong, and everything after it goes on with the wrong number.
    pub fn mutated(stop: &'a Stop, mutant: Mutant) -> Self {
        Self { mutant: Some(mutant), ..Self::new(stop) }
    }

    /// Recorded solution. Refused when a number left the finite range, with the first such number named.
    pub fn into_solution(self) -> Result<Solution, Refusal> {
        let mut solution = self.solution.into_inner();
        let nodes = &solution.trace.nodes;
        let is_own =
            |path: &str, id: Id| matches!(&nodes[id as usize].op, Op::Given { path: own, .. } if own == path);
        let lifted = self.lifted.into_inner().into_iter();
        solution.computed = lifted.filter(|(path, id)| !is_own(path, *id)).collect();
        solution.computed.sort_unstable();
        let wild = solution.steps.iter().find(|step| !solution.trace.node(step.result).number.is_finite());
        if let Some(step) = wild {
            let why = Text::new("these inputs lead to a number that cannot be represented: {symbol}")
                .with("symbol", printer::symbol(&step.symbol));
            return Err(Refusal::NoAnswer(why));
        }
        let wild = |answer: &&Answer| matches!(&answer.value, AnswerValue::List(all) if all.iter().any(|x| !x.is_finite()));
        if let Some(answer) = solution.answers.iter().find(wild) {
            let why = Text::new("these inputs lead to a number that cannot be represented: {symbol}")
                .with("symbol", answer.name);
            return Err(Refusal::NoAnswer(why));
        }
        solution.defects.dedup();
        Ok(solution)
    }

    fn push(&self, number: Number, dim: Dim, op: Op) -> Id {
        let solution = self.solution.borrow();
        let (scale, error) = (solution.trace.scale_of(&op, number), solution.trace.error_of(&op, number));
        drop(solution);
        self.push_rounded(number, dim, op, [scale, error])
    }

    fn push_rounded(&self, number: Number, dim: Dim, op: Op, [scale, error]: [f64; 2]) -> Id {
        let trace = &mut self.solution.borrow_mut().trace;
        let id = Id::try_from(trace.nodes.len()).expect("a worked solution has fewer than 2³² numbers");
        let wrong = |mutant: Mutant| mutant.mutation.of(trace, &op, number, scale);
        let number = self.mutant.filter(|mutant| mutant.at == id).and_then(wrong).unwrap_or(number);
        trace.nodes.push(TraceNode { number, dim, op, scale, error });
        id
    }

    fn node(&self, id: Id) -> (Number, Dim) {
        let solution = self.solution.borrow();
        let node = solution.trace.node(id);
        (node.number, node.dim)
    }

    fn defect(&self, text: String) {
        self.solution.borrow_mut().defects.push(text);
    }

    fn formula(&self, id: Id) -> String {
        printer::formula(&self.solution.borrow(), id, &Locale::english())
    }

    fn unit(&self, text: &'static str) -> Unit {
        units::unit(text).unwrap_or_else(|err| {
            self.defect(format!("the unit {text}: {err}"));
            Unit::ONE
        })
    }

    /// Records a step and the node that holds its result.
    fn record(
        &self,
        symbol: Symbol,
        unit: Unit,
        formula: Option<Id>,
        number: Number,
        dim: Dim,
        why: Reason,
    ) -> Id {
        if !unit.dim.agrees(dim) && number.size() != 0.0 {
            let formula = formula.map_or_else(String::new, |id| self.formula(id));
            self.defect(format!(
                "{} = {formula} is in {dim}, not in {}",
                printer::symbol(&symbol),
                unit.pretty()
            ));
        }
        if let Some(result) = self.early(symbol, formula, number, &why) {
            return result;
        }
        let step = self.solution.borrow().steps.len();
        let rounded = match formula {
            Some(id) => {
                let solution = self.solution.borrow();
                let node = solution.trace.node(id);
                [node.scale, node.error]
            }
            None => [number.size(), f64::EPSILON * number.size()],
        };
        let result = self.push_rounded(number, unit.dim, Op::Step(step), rounded);
        let step = Step { symbol, unit, formula, result, why: why.reason, cite: why.cite };
        self.solution.borrow_mut().steps.push(step);
        self.settle_common_errors(symbol);
        result
    }

    fn write_step(&self, symbol: Symbol, unit: &'static str, id: Id, why: Reason) -> Id {
        let (number, dim) = self.node(id);
        self.record(symbol, self.unit(unit), Some(id), number, dim, why)
    }

    fn write_numerical(&self, symbol: Symbol, unit: &'static str, number: Number, how: Reason) -> Id {
        let unit = self.unit(unit);
        self.record(symbol, unit.clone(), None, number, unit.dim, how)
    }

    fn named(&self, name: Name, id: Id) -> Option<Unit> {
        let solution = self.solution.borrow();
        match &solution.trace.node(id).op {
            Op::Step(step) => Some(solution.steps[*step].unit.clone()),
            Op::Given { unit, .. } => Some(unit.clone()),
            _ => {
                drop(solution);
                self.defect(format!("the answer {name} is not the result of a step"));
                None
            }
        }
    }

    fn give_number(&self, name: Name, label: &'static str, id: Id) {
        let Some(unit) = self.named(name, id) else { return };
        let (value, noise) = (self.node(id).0, ROUNDING * self.solution.borrow().trace.node(id).scale);
        self.give(Answer::new(name, label, AnswerValue::Number(value, id), unit, noise));
    }

    fn give(&self, answer: Answer) {
        self.solution.borrow_mut().answers.push(answer);
    }
}

impl<'s> Worksheet for &'s Sheet<'s> {
    type Num = Term<'s>;
    type Vec = VectorTerm<'s>;

    fn given(self, input: InputNumber<'_>, si: f64) -> Term<'s> {
        let (unit, op) = self.input(&input);
        if let Some(id) = self.lifted_before(&op) {
            return Term::Node(self, id);
        }
        Term::Node(self, self.push(Number::Scalar(si), unit.dim, op))
    }

    fn given_vector(self, input: InputNumber<'_>, si: Vector3<f64>) -> VectorTerm<'s> {
        let (unit, op) = self.input(&input);
        if let Some(id) = self.lifted_before(&op) {
            return VectorTerm::Node(self, id);
        }
        VectorTerm::Node(self, self.push(Number::Vector(si.into()), unit.dim, op))
    }

    fn constant(self, si: f64, unit: &Unit) -> Term<'s> {
        Term::Node(self, self.push(Number::Scalar(si), unit.dim, Op::Constant(unit.clone())))
    }

    fn step(
        self,
        symbol: impl Into<Symbol>,
        unit: &'static str,
        value: Term<'s>,
        why: impl Into<Reason>,
    ) -> Term<'s> {
        Term::Node(self, self.write_step(symbol.into(), unit, value.on(self), why.into()))
    }

    fn step_vector(
        self,
        symbol: impl Into<Symbol>,
        unit: &'static str,
        value: VectorTerm<'s>,
        why: impl Into<Reason>,
    ) -> VectorTerm<'s> {
        VectorTerm::Node(self, self.write_step(symbol.into(), unit, value.on(self), why.into()))
    }

    fn numerical(
        self,
        symbol: impl Into<Symbol>,
        unit: &'static str,
        si: f64,
        how: impl Into<Reason>,
    ) -> Term<'s> {
        Term::Node(self, self.write_numerical(symbol.into(), unit, Number::Scalar(si), how.into()))
    }

    fn numerical_within(
        self,
        symbol: impl Into<Symbol>,
        unit: &'static str,
        si: f64,
        error: f64,
        how: impl Into<Reason>,
    ) -> Term<'s> {
        let found = self.numerical(symbol, unit, si, how);
        if let Some(id) = found.node() {
            let node = &mut self.solution.borrow_mut().trace.nodes[id as usize];
            node.error = node.error.max(error.abs());
        }
        found
    }

    fn numerical_vector(
        self,
        symbol: impl Into<Symbol>,
        unit: &'static str,
        si: Vector3<f64>,
        how: impl Into<Reason>,
    ) -> VectorTerm<'s> {
        VectorTerm::Node(
            self,
            self.write_numerical(symbol.into(), unit, Number::Vector(si.into()), how.into()),
        )
    }

    fn common_error(
        self,
        symbol: impl Into<Symbol>,
        what: impl Into<Text>,
        wrong: impl FnOnce() -> Term<'s>,
    ) {
        self.note_common_error(symbol.into(), what.into(), wrong);
    }

    fn check(self, what: impl Into<Text>, left: Term<'s>, right: Term<'s>) {
        let scale = left.value().abs().max(right.value().abs());
        self.hold_together(what.into(), left, right, scale);
    }

    fn check_zero(self, what: impl Into<Text>, residual: Term<'s>, scale: f64) {
        self.hold_to_zero(what.into(), residual, scale, 0.0);
    }

    fn check_sum(self, what: impl Into<Text>, left: Term<'s>, right: Term<'s>, scale: f64) {
        self.hold_together(what.into(), left, right, scale.abs());
    }

    fn check_residual(self, what: impl Into<Text>, residual: Term<'s>, scale: f64, error: f64) {
        self.hold_to_zero(what.into(), residual, scale, error);
    }

    fn check_vector(self, what: impl Into<Text>, left: VectorTerm<'s>, right: VectorTerm<'s>) {
        if let (VectorTerm::Node(_, a), VectorTerm::Node(_, b)) = (left, right) {
            self.same_dim(a, b);
        }
        let error = self.error_between(left.node(), right.node());
        let sides = Sides::of(left.node(), right.node());
        let (left, right) = (left.value(), right.value());
        self.hold(what.into(), (left - right).norm(), left.norm().max(right.norm()), error, sides);
    }

    fn answer(self, name: impl Into<Name>, label: &'static str, value: Term<'s>) {
        let id = value.on(self);
        self.give_number(name.into(), label, id);
    }

    fn answer_vector(self, name: impl Into<Name>, label: &'static str, value: VectorTerm<'s>) {
        let id = value.on(self);
        self.give_number(name.into(), label, id);
    }

    fn answer_list(self, name: impl Into<Name>, label: &'static str, unit: &'static str, numbers: &[f64]) {
        let (name, unit) = (name.into(), self.unit(unit));
        let largest = numbers.iter().fold(0.0f64, |largest, x| largest.max(x.abs()));
        let value = AnswerValue::List(numbers.to_vec());
        self.give(Answer::new(name, label, value, unit, ROUNDING * largest));
    }

    fn answer_set(
        self,
        name: impl Into<Name>,
        label: &'static str,
        unit: &'static str,
        set: &IntervalSet,
        limits: Vec<Text>,
    ) {
        let (name, unit) = (name.into(), self.unit(unit));
        let value = AnswerValue::Set(set.clone(), limits);
        self.give(Answer::new(name, label, value, unit, 0.0));
    }

    fn row_label(self, name: impl Into<Name>, row_label: &str) {
        let name = name.into();
        if let Some(answer) =
            self.solution.borrow_mut().answers.iter_mut().rfind(|answer| answer.name == name)
        {
            row_label.clone_into(&mut answer.row_label);
        }
    }

    fn show(self, exhibit: impl FnOnce() -> Exhibit) {
        let exhibit = exhibit();
        if !matches!(&exhibit, Exhibit::Plot(plot) if plot.is_zero()) {
            self.solution.borrow_mut().exhibits.push(exhibit);
        }
    }

    fn warn(self, warning: impl FnOnce() -> Text) {
        let warning = warning();
        self.solution.borrow_mut().warnings.push(warning);
    }

    fn keep_going(self) -> Result<(), Refusal> {
        self.stop.check()
    }
}

impl<'a> Sheet<'a> {
    /// Operations recorded so far.
    pub(crate) fn solution(&self) -> std::cell::Ref<'_, Solution> {
        self.solution.borrow()
    }

    /// The number at a node.
    pub(crate) fn term(&'a self, id: Id) -> Term<'a> {
        Term::Node(self, id)
    }

    /// The vector at a node.
    pub(crate) fn vector_term(&'a self, id: Id) -> VectorTerm<'a> {
        VectorTerm::Node(self, id)
    }

    /// An input or a definition that formulas need before the solve.
    pub(crate) fn lift(&'a self, path: &str, symbol: Symbol, unit: &Unit, number: Number) -> Id {
        let op = Op::Given { symbol, unit: unit.clone(), path: path.to_owned() };
        let id = self.push(number, unit.dim, op);
        self.lifted.borrow_mut().insert(path.to_owned(), id);
        id
    }

    /// The result of a formula takes the place of an input.
    pub(crate) fn lift_formula(&self, path: &str, id: Id) {
        self.lifted.borrow_mut().insert(path.to_owned(), id);
    }

    /// The node that stands for an input or a definition.
    pub(crate) fn lifted(&self, path: &str) -> Option<Id> {
        self.lifted.borrow().get(path).copied()
    }

    /// Marks the answer of that name as one the user asked for, of a problem among several, perhaps in a unit.
    pub(crate) fn mark_asked(&self, name: Name, problem: &'static str, is_unit_asked: bool) {
        if let Some(answer) = self.solution.borrow_mut().answers.iter_mut().find(|answer| answer.name == name)
        {
            (answer.asked, answer.is_main) = (true, true);
            (answer.problem, answer.is_unit_asked) = (problem, is_unit_asked);
        }
    }

    /// Puts another node, or none, in the place of an input; the node that was there.
    pub(crate) fn put_lifted(&self, path: &str, node: Option<Id>) -> Option<Id> {
        let mut lifted = self.lifted.borrow_mut();
        match node {
            Some(node) => lifted.insert(path.to_owned(), node),
            None => lifted.remove(path),
        }
    }

    /// Takes the nodes of all inputs within a path out; each with its path.
    pub(crate) fn take_lifted(&self, within: &str) -> Vec<(String, Option<Id>)> {
        let mut lifted = self.lifted.borrow_mut();
        let paths: Vec<String> = lifted.keys().filter(|path| is_within(path, within)).cloned().collect();
        let mut taken: Vec<_> = paths.into_iter().map(|path| (path.clone(), lifted.remove(&path))).collect();
        taken.sort_unstable();
        taken
    }

    /// Keeps the nodes of all inputs, so that the next solution of the same problem has the same ones.
    pub(crate) fn keep_given_inputs(&self) {
        let solution = self.solution.borrow();
        let mut lifted = self.lifted.borrow_mut();
        for (id, node) in (0..).zip(&solution.trace.nodes) {
            if let Op::Given { path, .. } = &node.op
                && !lifted.contains_key(path)
            {
                lifted.insert(path.clone(), id);
            }
        }
    }

    /// The lengths of its lists now, before the solution of one of several problems.
    pub(crate) fn mark(&self) -> Mark {
        let solution = self.solution.borrow();
        Mark {
            answers: solution.answers.len(),
            checks: solution.checks.len(),
            warnings: solution.warnings.len(),
            exhibits: solution.exhibits.len(),
        }
    }

    /// Puts the main answers of an analysis before its others, of those that its solution has added since.
    pub(crate) fn rank_answers(&self, since: Mark, main: &[&str]) {
        let answers = &mut self.solution.borrow_mut().answers[since.answers..];
        let rank = |answer: &Answer| main.iter().position(|name| *name == answer.name.base);
        for answer in answers.iter_mut() {
            answer.is_main = rank(answer).is_some();
        }
        answers.sort_by_key(|answer| rank(answer).unwrap_or(main.len()));
    }

    /// Writes the name of a problem or a configuration before what its solution has added since; `path` leads to its
    /// inputs.
    pub(crate) fn name_problem(&self, name: &'static str, path: &str, since: Mark) {
        let mut solution = self.solution.borrow_mut();
        for answer in &mut solution.answers[since.answers..] {
            answer.name.base = intern(&format!("{name}.{}", answer.name.base));
            answer.problem = name;
        }
        let named = |text: &Text| {
            Text::new("{problem}: {title}").with("problem", name).with_text("title", text.clone())
        };
        for check in &mut solution.checks[since.checks..] {
            check.what = named(&check.what);
        }
        for warning in &mut solution.warnings[since.warnings..] {
            *warning = named(warning);
        }
        for exhibit in &mut solution.exhibits[since.exhibits..] {
            exhibit.rename(&named, &|answer| format!("{name}.{answer}"), &|input| {
                if path.is_empty() { input.to_owned() } else { format!("{path}.{input}") }
            });
        }
    }

    /// Adds steps to those of a problem among several.
    pub(crate) fn add_problem_steps(&self, more: ProblemSteps) {
        let problems = &mut self.solution.borrow_mut().problems;
        match problems.last_mut() {
            Some(last) if last.name == more.name => {
                (last.steps.end, last.exhibits.end) = (more.steps.end, more.exhibits.end);
            }
            _ if more.steps.is_empty() => {}
            _ => problems.push(more),
        }
    }

    /// Puts the exhibits of a problem before those of the others.
    pub(crate) fn show_first(&self, name: &str) {
        let Solution { exhibits, problems, .. } = &mut *self.solution.borrow_mut();
        let Some(first) = problems.iter().position(|of| of.name == name && !of.exhibits.is_empty()) else {
            return;
        };
        let Range { start, end } = problems[first].exhibits;
        exhibits[..end].rotate_left(start);
        let count = end - start;
        for (n, of) in problems.iter_mut().enumerate() {
            if n == first {
                of.exhibits = 0..count;
            } else if of.exhibits.start < start {
                of.exhibits = of.exhibits.start + count..of.exhibits.end + count;
            }
        }
    }

    fn lifted_before(&self, op: &Op) -> Option<Id> {
        let Op::Given { path, .. } = op else { return None };
        self.lifted(path)
    }

    fn input(&self, input: &InputNumber<'_>) -> (Unit, Op) {
        let (value, field_path) = match input.at {
            Some(at) => (
                input.value.map(|group| derive_support::field(group, at)),
                input.field_path.field(input.field.name),
            ),
            None => (input.value, *input.field_path),
        };
        let unit = match value {
            Some(Value::Quantity(quantity)) => quantity.unit.clone(),
            Some(Value::Vector(vector)) => vector.unit.clone(),
            _ => self.unit(derive_support::measure(input.field).unit),
        };
        let op = Op::Given {
            symbol: field_path.symbol(input.field.symbol),
            unit: unit.clone(),
            path: field_path.path(),
        };
        (unit, op)
    }

    /// The dimension of a power with a computed exponent.
    fn power_dim(&self, base: Id, exponent: Id) -> Dim {
        let (Number::Scalar(exponent), (_, dim)) = (self.node(exponent).0, self.node(base)) else {
            return Dim::NONE;
        };
        dim.powf(exponent).unwrap_or_else(|| {
            self.defect(format!("a number in {dim} to the power {exponent}"));
            Dim::NONE
        })
    }

    /// The dimension of a sum of two.
    fn same_dim(&self, a: Id, b: Id) -> Dim {
        self.common_dim(&[a, b])
    }

    /// The dimension that all have in common; a defect where they have not. A literal zero has every dimension.
    fn common_dim(&self, ids: &[Id]) -> Dim {
        let mut common: Option<(Id, Dim)> = None;
        for &id in ids {
            let (number, dim) = self.node(id);
            let literal = matches!(self.solution.borrow().trace.node(id).op, Op::Literal);
            if literal && number.size() == 0.0 {
                continue;
            }
            match common {
                Some((first, of)) if !of.agrees(dim) => {
                    let (left, right) = (self.formula(first), self.formula(id));
                    self.defect(format!("{left} is in {of}, {right} is in {dim}"));
                }
                // Of dimensions that agree, the one that tells an angle from a bare number says more.
                Some((_, of)) if of != Dim::NONE => {}
                _ => common = Some((id, dim)),
            }
        }
        common.map_or(Dim::NONE, |(_, dim)| dim)
    }
}
