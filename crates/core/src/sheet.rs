//! The sheet on which a problem is worked: a [`Worksheet`] that records everything.
//!
//! A [`Term`] is a number that remembers how it was found. The formula that is shown is the one that was
//! evaluated, and its dimensions are followed as it is evaluated.

use std::{
    cell::RefCell,
    ops::{Add, Div, Mul, Neg, Sub},
};

use dalembert_mechanics::{Real, Vector, intervals::IntervalSet};
use dalembert_units::{self as units, Dim, Unit};
use nalgebra::Vector3;

use crate::{
    Answer, Check, Exhibit, Locale, Refusal, Solution, Step, Stop, Symbol, Text, Why, Worksheet, printer,
    solution::AnswerValue,
    trace::{Function, Id, Node, Number, Op, ROUNDING},
    worksheet::Given,
};

/// The largest relative difference of two ways to the same number.
const AGREEMENT: f64 = 1e-9;

/// Records a solve as a [`Solution`].
pub struct Sheet<'a> {
    solution: RefCell<Solution>,
    stop: &'a Stop,
}

/// A number on a sheet. A literal needs no sheet until it meets another number.
#[derive(Clone, Copy)]
pub enum Term<'s> {
    /// A number of the formula itself.
    Literal(f64),
    /// A recorded number.
    Node(&'s Sheet<'s>, Id),
}

/// A vector on a sheet. A constant direction needs no sheet until it meets another number.
#[derive(Clone, Copy)]
pub enum Vect<'s> {
    /// A vector of the formula itself.
    Literal([f64; 3]),
    /// A recorded vector.
    Node(&'s Sheet<'s>, Id),
}

impl<'a> Sheet<'a> {
    /// An empty sheet.
    pub fn new(stop: &'a Stop) -> Self {
        Self { solution: RefCell::default(), stop }
    }

    /// What was recorded. Refused when a number left the finite range, with the first such number named.
    pub fn into_solution(self) -> Result<Solution, Refusal> {
        let mut solution = self.solution.into_inner();
        let wild = solution.steps.iter().find(|step| !solution.trace.node(step.result).number.is_finite());
        if let Some(step) = wild {
            let why = Text::new("these inputs lead to a number that cannot be represented: {symbol}")
                .with("symbol", printer::symbol(&step.symbol));
            return Err(Refusal::NoAnswer(why));
        }
        solution.defects.dedup();
        Ok(solution)
    }

    fn push(&self, number: Number, dim: Dim, op: Op) -> Id {
        let scale = self.solution.borrow().trace.scale_of(&op, number);
        self.push_scaled(number, dim, op, scale)
    }

    fn push_scaled(&self, number: Number, dim: Dim, op: Op, scale: f64) -> Id {
        let nodes = &mut self.solution.borrow_mut().trace.nodes;
        let id = Id::try_from(nodes.len())
            .expect("a worked solution has fewer than four thousand million numbers");
        nodes.push(Node { number, dim, op, scale });
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
        why: Why,
    ) -> Id {
        if !unit.dim.agrees(dim) && number.size() != 0.0 {
            let formula = formula.map_or_else(String::new, |id| self.formula(id));
            self.defect(format!(
                "{} = {formula} is in {dim}, not in {}",
                printer::symbol(&symbol),
                unit.pretty()
            ));
        }
        let step = self.solution.borrow().steps.len();
        let scale = formula.map_or(number.size(), |id| self.solution.borrow().trace.node(id).scale);
        let result = self.push_scaled(number, unit.dim, Op::Step(step), scale);
        let step = Step { symbol, unit, formula, result, why: why.reason, cite: why.cite };
        self.solution.borrow_mut().steps.push(step);
        result
    }

    fn named(&self, name: &str, id: Id) -> Option<Unit> {
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

    fn hold(&self, what: Text, difference: f64, scale: f64) {
        let residual = if difference == 0.0 { 0.0 } else { difference / scale };
        let passed = residual <= AGREEMENT;
        self.solution.borrow_mut().checks.push(Check { what, residual, passed });
    }
}

impl<'s> Worksheet for &'s Sheet<'s> {
    type Num = Term<'s>;
    type Vec = Vect<'s>;

    fn given(self, input: Given<'_>, si: f64) -> Term<'s> {
        let (unit, op) = self.input(&input);
        Term::Node(self, self.push(Number::Scalar(si), unit.dim, op))
    }

    fn given_vector(self, input: Given<'_>, si: Vector3<f64>) -> Vect<'s> {
        let (unit, op) = self.input(&input);
        Vect::Node(self, self.push(Number::Vector(si.into()), unit.dim, op))
    }

    fn step(
        self,
        symbol: impl Into<Symbol>,
        unit: &'static str,
        value: Term<'s>,
        why: impl Into<Why>,
    ) -> Term<'s> {
        let id = value.on(self);
        let (number, dim) = self.node(id);
        let unit = self.unit(unit);
        Term::Node(self, self.record(symbol.into(), unit, Some(id), number, dim, why.into()))
    }

    fn step_vector(
        self,
        symbol: impl Into<Symbol>,
        unit: &'static str,
        value: Vect<'s>,
        why: impl Into<Why>,
    ) -> Vect<'s> {
        let id = value.on(self);
        let (number, dim) = self.node(id);
        let unit = self.unit(unit);
        Vect::Node(self, self.record(symbol.into(), unit, Some(id), number, dim, why.into()))
    }

    fn found(self, symbol: impl Into<Symbol>, unit: &'static str, si: f64, how: impl Into<Why>) -> Term<'s> {
        let unit = self.unit(unit);
        let dim = unit.dim;
        Term::Node(self, self.record(symbol.into(), unit, None, Number::Scalar(si), dim, how.into()))
    }

    fn check(self, what: impl Into<Text>, left: Term<'s>, right: Term<'s>) {
        if let (Term::Node(_, a), Term::Node(_, b)) = (left, right) {
            self.same_dim(a, b);
        }
        let (left, right) = (left.value(), right.value());
        self.hold(what.into(), (left - right).abs(), left.abs().max(right.abs()));
    }

    fn check_zero(self, what: impl Into<Text>, residual: Term<'s>, scale: f64) {
        self.hold(what.into(), residual.value().abs(), scale.abs());
    }

    fn check_vector(self, what: impl Into<Text>, left: Vect<'s>, right: Vect<'s>) {
        if let (Vect::Node(_, a), Vect::Node(_, b)) = (left, right) {
            self.same_dim(a, b);
        }
        let (left, right) = (left.value(), right.value());
        self.hold(what.into(), (left - right).norm(), left.norm().max(right.norm()));
    }

    fn answer(self, name: &'static str, label: &'static str, value: Term<'s>) {
        let id = value.on(self);
        let Some(unit) = self.named(name, id) else { return };
        let value = AnswerValue::Number(self.node(id).0, id);
        let noise = ROUNDING * self.solution.borrow().trace.node(id).scale;
        self.solution.borrow_mut().answers.push(Answer { name, label, value, unit, noise });
    }

    fn answer_vector(self, name: &'static str, label: &'static str, value: Vect<'s>) {
        let id = value.on(self);
        let Some(unit) = self.named(name, id) else { return };
        let value = AnswerValue::Number(self.node(id).0, id);
        let noise = ROUNDING * self.solution.borrow().trace.node(id).scale;
        self.solution.borrow_mut().answers.push(Answer { name, label, value, unit, noise });
    }

    fn answer_set(
        self,
        name: &'static str,
        label: &'static str,
        unit: &'static str,
        set: &IntervalSet,
        limits: Vec<Text>,
    ) {
        let unit = self.unit(unit);
        let value = AnswerValue::Set(set.clone(), limits);
        self.solution.borrow_mut().answers.push(Answer { name, label, value, unit, noise: 0.0 });
    }

    fn show(self, exhibit: impl FnOnce() -> Exhibit) {
        let exhibit = exhibit();
        self.solution.borrow_mut().exhibits.push(exhibit);
    }

    fn warn(self, warning: impl FnOnce() -> Text) {
        let warning = warning();
        self.solution.borrow_mut().warnings.push(warning);
    }

    fn keep_going(self) -> Result<(), Refusal> {
        self.stop.check()
    }
}

impl Sheet<'_> {
    fn input(&self, input: &Given<'_>) -> (Unit, Op) {
        let unit = match input.unit {
            Ok(unit) => unit.clone(),
            Err(text) => self.unit(text),
        };
        let op = Op::Given {
            symbol: input.trail.symbol(input.symbol),
            unit: unit.clone(),
            path: input.trail.path(),
        };
        (unit, op)
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

impl<'s> Term<'s> {
    /// The node of this number on `sheet`; a literal becomes one.
    fn on(self, sheet: &'s Sheet<'s>) -> Id {
        match self {
            Term::Literal(value) => sheet.push(Number::Scalar(value), Dim::NONE, Op::Literal),
            Term::Node(_, id) => id,
        }
    }

    fn sheet(self) -> Option<&'s Sheet<'s>> {
        if let Term::Node(sheet, _) = self { Some(sheet) } else { None }
    }

    fn unary(
        self,
        value: f64,
        dim: impl FnOnce(&Sheet<'s>, Dim) -> Dim,
        op: impl FnOnce(Id) -> Op,
    ) -> Term<'s> {
        match self {
            Term::Literal(_) => Term::Literal(value),
            Term::Node(sheet, id) => {
                let dim = dim(sheet, sheet.node(id).1);
                Term::Node(sheet, sheet.push(Number::Scalar(value), dim, op(id)))
            }
        }
    }

    fn binary(
        self,
        other: Term<'s>,
        value: f64,
        dim: impl FnOnce(&Sheet<'s>, Id, Id) -> Dim,
        op: impl FnOnce(Id, Id) -> Op,
    ) -> Term<'s> {
        let Some(sheet) = self.sheet().or(other.sheet()) else { return Term::Literal(value) };
        let (a, b) = (self.on(sheet), other.on(sheet));
        let dim = dim(sheet, a, b);
        Term::Node(sheet, sheet.push(Number::Scalar(value), dim, op(a, b)))
    }

    /// A function of a pure number or an angle.
    fn call(self, function: Function, value: f64, dim: Dim) -> Term<'s> {
        self.unary(
            value,
            |sheet, of| {
                if !of.agrees(Dim::NONE) {
                    sheet.defect(format!("{} of a number in {of}", printer::function(function)));
                }
                dim
            },
            |id| Op::Call(function, id),
        )
    }
}

impl From<f64> for Term<'_> {
    fn from(value: f64) -> Self {
        Term::Literal(value)
    }
}

impl<'s> Add for Term<'s> {
    type Output = Term<'s>;
    fn add(self, o: Term<'s>) -> Term<'s> {
        self.binary(o, self.value() + o.value(), Sheet::same_dim, Op::Add)
    }
}

impl<'s> Sub for Term<'s> {
    type Output = Term<'s>;
    fn sub(self, o: Term<'s>) -> Term<'s> {
        self.binary(o, self.value() - o.value(), Sheet::same_dim, Op::Sub)
    }
}

impl<'s> Mul for Term<'s> {
    type Output = Term<'s>;
    fn mul(self, o: Term<'s>) -> Term<'s> {
        self.binary(o, self.value() * o.value(), |sheet, a, b| sheet.node(a).1 * sheet.node(b).1, Op::Mul)
    }
}

impl<'s> Div for Term<'s> {
    type Output = Term<'s>;
    fn div(self, o: Term<'s>) -> Term<'s> {
        self.binary(o, self.value() / o.value(), |sheet, a, b| sheet.node(a).1 / sheet.node(b).1, Op::Div)
    }
}

impl<'s> Neg for Term<'s> {
    type Output = Term<'s>;
    fn neg(self) -> Term<'s> {
        self.unary(-self.value(), |_, dim| dim, Op::Neg)
    }
}

macro_rules! with_literals {
    ($($op:ident $method:ident),*) => {$(
        impl<'s> $op<f64> for Term<'s> {
            type Output = Term<'s>;
            fn $method(self, o: f64) -> Term<'s> {
                $op::$method(self, Term::Literal(o))
            }
        }
    )*};
}
with_literals!(Add add, Sub sub, Mul mul, Div div);

impl Real for Term<'_> {
    fn value(self) -> f64 {
        match self {
            Term::Literal(value) => value,
            Term::Node(sheet, id) => match sheet.node(id).0 {
                Number::Scalar(value) => value,
                Number::Vector(_) => unreachable!("a term is a scalar"),
            },
        }
    }

    fn powi(self, n: i8) -> Self {
        self.unary(self.value().powi(n.into()), |_, dim| dim.powi(n), |id| Op::Power(id, n))
    }

    fn root(self, n: u8) -> Self {
        let dim = |sheet: &Sheet<'_>, dim: Dim| {
            dim.root(n).unwrap_or_else(|| {
                sheet.defect(format!("a root of order {n} of a number in {dim}"));
                Dim::NONE
            })
        };
        self.unary(Real::root(self.value(), n), dim, |id| Op::Root(id, n))
    }

    fn abs(self) -> Self {
        self.unary(self.value().abs(), |_, dim| dim, |id| Op::Call(Function::Abs, id))
    }

    fn sin(self) -> Self {
        self.call(Function::Sin, self.value().sin(), Dim::NONE)
    }

    fn cos(self) -> Self {
        self.call(Function::Cos, self.value().cos(), Dim::NONE)
    }

    fn tan(self) -> Self {
        self.call(Function::Tan, self.value().tan(), Dim::NONE)
    }

    fn asin(self) -> Self {
        self.call(Function::Asin, self.value().asin(), Dim::ANGLE)
    }

    fn acos(self) -> Self {
        self.call(Function::Acos, self.value().acos(), Dim::ANGLE)
    }

    fn atan2(self, x: Self) -> Self {
        let dim = |sheet: &Sheet<'_>, a, b| {
            sheet.same_dim(a, b);
            Dim::ANGLE
        };
        self.binary(x, self.value().atan2(x.value()), dim, Op::Atan2)
    }

    fn exp(self) -> Self {
        self.call(Function::Exp, self.value().exp(), Dim::NONE)
    }

    fn ln(self) -> Self {
        self.call(Function::Ln, self.value().ln(), Dim::NONE)
    }

    fn sum(terms: impl IntoIterator<Item = Self>) -> Self {
        let terms: Vec<Self> = terms.into_iter().collect();
        let value = Real::sum(terms.iter().map(|term| term.value()));
        let Some(sheet) = terms.iter().find_map(|term| term.sheet()) else { return Term::Literal(value) };
        if let [only] = terms[..] {
            return only;
        }
        let ids: Vec<Id> = terms.iter().map(|term| term.on(sheet)).collect();
        let dim = sheet.common_dim(&ids);
        Term::Node(sheet, sheet.push(Number::Scalar(value), dim, Op::Sum(ids)))
    }
}

impl<'s> Vect<'s> {
    fn on(self, sheet: &'s Sheet<'s>) -> Id {
        match self {
            Vect::Literal(value) => sheet.push(Number::Vector(value), Dim::NONE, Op::Literal),
            Vect::Node(_, id) => id,
        }
    }

    fn sheet(self) -> Option<&'s Sheet<'s>> {
        if let Vect::Node(sheet, _) = self { Some(sheet) } else { None }
    }

    fn binary(
        self,
        other: Vect<'s>,
        value: Vector3<f64>,
        dim: impl FnOnce(&Sheet<'s>, Id, Id) -> Dim,
        op: impl FnOnce(Id, Id) -> Op,
    ) -> Vect<'s> {
        let Some(sheet) = self.sheet().or(other.sheet()) else { return Vect::Literal(value.into()) };
        let (a, b) = (self.on(sheet), other.on(sheet));
        let dim = dim(sheet, a, b);
        Vect::Node(sheet, sheet.push(Number::Vector(value.into()), dim, op(a, b)))
    }

    /// A scalar made from this vector alone.
    fn scalar(self, value: f64, op: impl FnOnce(Id) -> Op) -> Term<'s> {
        match self {
            Vect::Literal(_) => Term::Literal(value),
            Vect::Node(sheet, id) => {
                let dim = sheet.node(id).1;
                Term::Node(sheet, sheet.push(Number::Scalar(value), dim, op(id)))
            }
        }
    }
}

impl<'s> Add for Vect<'s> {
    type Output = Vect<'s>;
    fn add(self, o: Vect<'s>) -> Vect<'s> {
        self.binary(o, self.value() + o.value(), Sheet::same_dim, Op::Add)
    }
}

impl<'s> Sub for Vect<'s> {
    type Output = Vect<'s>;
    fn sub(self, o: Vect<'s>) -> Vect<'s> {
        self.binary(o, self.value() - o.value(), Sheet::same_dim, Op::Sub)
    }
}

impl<'s> Neg for Vect<'s> {
    type Output = Vect<'s>;
    fn neg(self) -> Vect<'s> {
        let value = -self.value();
        let Vect::Node(sheet, id) = self else { return Vect::Literal(value.into()) };
        let (_, dim) = sheet.node(id);
        Vect::Node(sheet, sheet.push(Number::Vector(value.into()), dim, Op::Neg(id)))
    }
}

impl<'s> Mul<Term<'s>> for Vect<'s> {
    type Output = Vect<'s>;
    fn mul(self, o: Term<'s>) -> Vect<'s> {
        let value = self.value() * o.value();
        let Some(sheet) = self.sheet().or(o.sheet()) else { return Vect::Literal(value.into()) };
        let (vector, scalar) = (self.on(sheet), o.on(sheet));
        let dim = sheet.node(vector).1 * sheet.node(scalar).1;
        Vect::Node(sheet, sheet.push(Number::Vector(value.into()), dim, Op::Mul(scalar, vector)))
    }
}

impl<'s> Div<Term<'s>> for Vect<'s> {
    type Output = Vect<'s>;
    fn div(self, o: Term<'s>) -> Vect<'s> {
        let value = self.value() / o.value();
        let Some(sheet) = self.sheet().or(o.sheet()) else { return Vect::Literal(value.into()) };
        let (vector, scalar) = (self.on(sheet), o.on(sheet));
        let dim = sheet.node(vector).1 / sheet.node(scalar).1;
        Vect::Node(sheet, sheet.push(Number::Vector(value.into()), dim, Op::Div(vector, scalar)))
    }
}

impl<'s> Vector for Vect<'s> {
    type Scalar = Term<'s>;

    fn from_components(x: Term<'s>, y: Term<'s>, z: Term<'s>) -> Self {
        let value = [x.value(), y.value(), z.value()];
        let Some(sheet) = x.sheet().or(y.sheet()).or(z.sheet()) else { return Vect::Literal(value) };
        let ids = [x.on(sheet), y.on(sheet), z.on(sheet)];
        let dim = sheet.common_dim(&ids);
        Vect::Node(sheet, sheet.push(Number::Vector(value), dim, Op::Compose(ids)))
    }

    fn components(self) -> [Term<'s>; 3] {
        let value = self.value();
        [0, 1, 2].map(|axis| self.scalar(value[usize::from(axis)], |id| Op::Component(id, axis)))
    }

    fn value(self) -> Vector3<f64> {
        match self {
            Vect::Literal(value) => value.into(),
            Vect::Node(sheet, id) => match sheet.node(id).0 {
                Number::Vector(value) => value.into(),
                Number::Scalar(_) => unreachable!("a vect is a vector"),
            },
        }
    }

    fn dot(self, o: Vect<'s>) -> Term<'s> {
        let value = Vector::dot(self.value(), o.value());
        let Some(sheet) = self.sheet().or(o.sheet()) else { return Term::Literal(value) };
        let (a, b) = (self.on(sheet), o.on(sheet));
        let dim = sheet.node(a).1 * sheet.node(b).1;
        Term::Node(sheet, sheet.push(Number::Scalar(value), dim, Op::Dot(a, b)))
    }

    fn cross(self, o: Vect<'s>) -> Vect<'s> {
        let value = Vector::cross(self.value(), o.value());
        self.binary(o, value, |sheet, a, b| sheet.node(a).1 * sheet.node(b).1, Op::Cross)
    }

    fn magnitude(self) -> Term<'s> {
        self.scalar(self.value().norm(), Op::Magnitude)
    }

    fn sum(terms: impl IntoIterator<Item = Self>) -> Self {
        let terms: Vec<Self> = terms.into_iter().collect();
        let value: Vector3<f64> = Vector::sum(terms.iter().map(|term| term.value()));
        let Some(sheet) = terms.iter().find_map(|term| term.sheet()) else {
            return Vect::Literal(value.into());
        };
        if let [only] = terms[..] {
            return only;
        }
        let ids: Vec<Id> = terms.iter().map(|term| term.on(sheet)).collect();
        let dim = sheet.common_dim(&ids);
        Vect::Node(sheet, sheet.push(Number::Vector(value.into()), dim, Op::Sum(ids)))
    }
}
