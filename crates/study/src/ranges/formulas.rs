//! Formulas by which an answer follows from one input, read off the trace of a solution, and their enclosures.

use std::{collections::HashMap, mem::Discriminant};

use dalembert_core::{
    AnswerValue, Number, Solution,
    trace::{Function, Id, Op},
};
use dalembert_numerics::enclosure::{Enclosure, Jet};

/// The part of a trace that an answer was made from.
#[derive(Debug)]
pub(super) struct Formulas {
    solution: Solution,
    /// The nodes that the answer was made from, ascending: the answer is the last one.
    order: Vec<Id>,
    /// Place of each node in `order`.
    place: HashMap<Id, usize>,
    /// The nodes that are the input, or the vector that it is a component of.
    inputs: Vec<(Id, Option<usize>)>,
    values: Vec<Enclosed>,
}

/// An operation of a formula without the numbers that the input changes: formulas with equal operations are the same.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Operation {
    kind: Discriminant<Op>,
    operands: Vec<usize>,
    /// Exponents, components, functions; paths of inputs.
    words: String,
    /// Bits of the numbers that stand in the formula.
    numbers: [u64; 3],
}

impl Operation {
    /// Returns true if it is the same operation, be it on other numbers.
    pub(super) fn has_same_operation(&self, other: &Self) -> bool {
        self.kind == other.kind && self.operands == other.operands && self.words == other.words
    }
}

/// Enclosure of a node.
#[derive(Clone, Copy, Debug)]
enum Enclosed {
    Scalar(Jet),
    Vector([Jet; 3]),
}

impl Formulas {
    /// The formulas of an answer; `None` where it is no number, or was not computed on the sheet.
    pub(super) fn of(solution: Solution, answer: &str, input: &str) -> Option<Self> {
        let AnswerValue::Number(Number::Scalar(_), of) = solution.answer(answer)?.value else { return None };
        let order = solution.ancestors(of);
        let place: HashMap<Id, usize> = order.iter().copied().zip(0..).collect();
        let inputs = order.iter().filter_map(|id| match &solution.trace.node(*id).op {
            Op::Given { path, .. } if path == input => Some((*id, None)),
            Op::Given { path, .. } => {
                let axis = input.strip_prefix(path.as_str())?.strip_prefix('.')?;
                Some((*id, Some(["x", "y", "z"].iter().position(|known| *known == axis)?)))
            }
            _ => None,
        });
        let inputs = inputs.collect();
        Some(Self { solution, order, place, inputs, values: Vec::new() })
    }

    /// Number of operations.
    pub(super) fn len(&self) -> usize {
        self.order.len()
    }

    /// The operations, for a comparison with those at another value of the input.
    pub(super) fn operations(&self) -> Vec<Operation> {
        self.order.iter().map(|id| self.operation(*id)).collect()
    }

    fn operation(&self, id: Id) -> Operation {
        let node = self.solution.trace.node(id);
        let words = match &node.op {
            Op::Given { path, .. } => path.clone(),
            Op::Power(_, n) => n.to_string(),
            Op::Root(_, n) => n.to_string(),
            Op::Component(_, axis) => axis.to_string(),
            Op::Call(function, _) => format!("{function:?}"),
            _ => String::new(),
        };
        let operands: Vec<usize> = self.solution.operands(id).iter().map(|id| self.place[id]).collect();
        let mut numbers = [0; 3];
        // What has no operands is a number: it stays the same, but for the input.
        if operands.is_empty() {
            numbers = match node.number {
                Number::Scalar(x) => [x.to_bits(), 0, 0],
                Number::Vector(v) => v.map(f64::to_bits),
            };
            if let Some((_, axis)) = self.inputs.iter().find(|(input, _)| *input == id) {
                numbers[axis.unwrap_or(0)] = 0;
            }
        }
        Operation { kind: std::mem::discriminant(&node.op), operands, words, numbers }
    }

    /// Enclosure of the answer for every value of the input in an interval, in SI.
    pub(super) fn enclosed(&mut self, range: [f64; 2]) -> Jet {
        let mut values = std::mem::take(&mut self.values);
        values.clear();
        for id in &self.order {
            let value = self.node(*id, range, &values);
            values.push(value);
        }
        let answer = values.last().copied();
        self.values = values;
        match answer {
            Some(Enclosed::Scalar(jet)) => jet,
            _ => UNKNOWN,
        }
    }

    fn node(&self, id: Id, range: [f64; 2], values: &[Enclosed]) -> Enclosed {
        use Enclosed::{Scalar, Vector};
        let node = self.solution.trace.node(id);
        let of = |id: Id| values[self.place[&id]];
        let scalar = |id: Id| if let Scalar(jet) = of(id) { jet } else { UNKNOWN };
        let vector = |id: Id| if let Vector(v) = of(id) { v } else { [UNKNOWN; 3] };
        let each = |a: Enclosed, b: Enclosed, by: fn(Jet, Jet) -> Jet| match (a, b) {
            (Scalar(a), Scalar(b)) => Scalar(by(a, b)),
            (Vector(a), Vector(b)) => Vector([0, 1, 2].map(|n| by(a[n], b[n]))),
            _ => Scalar(UNKNOWN),
        };
        let sum = |terms: [Jet; 3]| terms[0] + terms[1] + terms[2];
        match &node.op {
            Op::Literal | Op::Constant(_) | Op::Given { .. } => self.number(id, range),
            Op::Step(step) => match self.solution.steps[*step].formula {
                Some(formula) => of(formula),
                None => self.number(id, range),
            },
            Op::Add(a, b) => each(of(*a), of(*b), |a, b| a + b),
            Op::Sub(a, b) => each(of(*a), of(*b), |a, b| a - b),
            // A square is never negative, which a product of equals does not show.
            Op::Mul(a, b) if a == b => Scalar(scalar(*a).powi(2)),
            Op::Mul(a, b) => match (of(*a), of(*b)) {
                (Scalar(a), Scalar(b)) => Scalar(a * b),
                (Scalar(a), Vector(v)) | (Vector(v), Scalar(a)) => Vector(v.map(|x| a * x)),
                _ => Scalar(UNKNOWN),
            },
            Op::Div(a, b) => match of(*a) {
                Scalar(a) => Scalar(a / scalar(*b)),
                Vector(v) => Vector(v.map(|x| x / scalar(*b))),
            },
            Op::Neg(a) => match of(*a) {
                Scalar(a) => Scalar(-a),
                Vector(v) => Vector(v.map(|x| -x)),
            },
            Op::Power(a, n) => Scalar(scalar(*a).powi(*n)),
            Op::Root(a, n) => Scalar(scalar(*a).root(*n)),
            Op::Raised(a, b) => Scalar(scalar(*a).pow(scalar(*b))),
            Op::Min(a, b) => Scalar(scalar(*a).min(scalar(*b))),
            Op::Max(a, b) => Scalar(scalar(*a).max(scalar(*b))),
            Op::Call(function, a) => Scalar(call(*function, scalar(*a))),
            Op::Atan2(y, x) => Scalar(scalar(*y).atan2(scalar(*x))),
            Op::Sum(all) => {
                let mut all = all.iter().map(|id| of(*id));
                let first = all.next().unwrap_or(Scalar(Jet::constant(0.0)));
                all.fold(first, |sum, x| each(sum, x, |a, b| a + b))
            }
            Op::Dot(a, b) if a == b => Scalar(sum(vector(*a).map(|x| x.powi(2)))),
            Op::Dot(a, b) => {
                let (a, b) = (vector(*a), vector(*b));
                Scalar(sum([0, 1, 2].map(|n| a[n] * b[n])))
            }
            Op::Cross(a, b) => {
                let (a, b) = (vector(*a), vector(*b));
                let minor = |i: usize, j: usize| a[i] * b[j] - a[j] * b[i];
                Vector([minor(1, 2), minor(2, 0), minor(0, 1)])
            }
            Op::Magnitude(a) => match of(*a) {
                Scalar(a) => Scalar(a.abs()),
                Vector(v) => Scalar(sum(v.map(|x| x.powi(2))).root(2)),
            },
            Op::Component(a, axis) => Scalar(vector(*a)[usize::from(*axis).min(2)]),
            Op::Compose(all) => Vector(all.map(scalar)),
        }
    }

    /// A number that stands in the formula, or the input.
    fn number(&self, id: Id, range: [f64; 2]) -> Enclosed {
        let input = self.inputs.iter().find(|(input, _)| *input == id);
        match (self.solution.trace.node(id).number, input) {
            (Number::Scalar(_), Some(_)) => Enclosed::Scalar(Jet::variable(range)),
            (Number::Scalar(x), None) => Enclosed::Scalar(Jet::constant(x)),
            (Number::Vector(v), input) => {
                let mut all = v.map(Jet::constant);
                if let Some((_, Some(axis))) = input {
                    all[*axis] = Jet::variable(range);
                }
                Enclosed::Vector(all)
            }
        }
    }
}

/// Nothing is known of it.
const UNKNOWN: Jet = Jet { value: Enclosure::UNDEFINED, slope: Enclosure::ALL };

fn call(function: Function, x: Jet) -> Jet {
    match function {
        Function::Sin => x.sin(),
        Function::Cos => x.cos(),
        Function::Tan => x.tan(),
        Function::Asin => x.asin(),
        Function::Acos => x.acos(),
        Function::Exp => x.exp(),
        Function::Ln => x.ln(),
        Function::Log10 => x.log10(),
        Function::Sinh => x.sinh(),
        Function::Cosh => x.cosh(),
        Function::Tanh => x.tanh(),
        Function::Abs => x.abs(),
    }
}
