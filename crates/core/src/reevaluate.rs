//! The trace of a solution read again with some of its numbers changed: what would have come out.

use dalembert_numerics::Real;

use crate::{
    Solution,
    trace::{Id, Number, Op},
};

/// Another computation of one number of a trace. The last operation takes the place of that of the node; those before it
/// are new nodes behind the trace, numbered on from [`Edit::first_new`].
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Edit {
    /// The node whose number is computed otherwise.
    pub(crate) at: Id,
    /// Operations, each with the number that it has if it is a literal.
    pub(crate) ops: Vec<(Op, Number)>,
}

/// Reads the part of a trace that some numbers were made from again and again, each time with other edits.
pub(crate) struct Reevaluation<'s> {
    solution: &'s Solution,
    /// The nodes that the wanted numbers were made from, in their order.
    used: Vec<Id>,
    /// The same, and those of the common errors that may take their place.
    order: Vec<Id>,
    numbers: Vec<Number>,
}

impl Edit {
    /// Number of the first new node of an edit.
    pub(crate) fn first_new(solution: &Solution) -> Id {
        solution.trace.nodes.len() as Id
    }

    /// Another operation on nodes of the trace.
    pub(crate) fn op(at: Id, op: Op) -> Self {
        Self { at, ops: vec![(op, NONE)] }
    }

    /// Another number.
    pub(crate) fn number(at: Id, number: Number) -> Self {
        Self { at, ops: vec![(Op::Literal, number)] }
    }

    /// The number of the node, and a literal, put together by an operation.
    pub(crate) fn with_literal(
        solution: &Solution,
        at: Id,
        literal: f64,
        op: impl FnOnce(Id, Id) -> Op,
    ) -> Self {
        let first = Self::first_new(solution);
        let own = (solution.trace.node(at).op.clone(), solution.trace.node(at).number);
        let ops = vec![own, (Op::Literal, Number::Scalar(literal)), (op(first, first + 1), NONE)];
        Self { at, ops }
    }

    /// An operation on the number of the node.
    pub(crate) fn then(solution: &Solution, at: Id, op: impl FnOnce(Id) -> Op) -> Self {
        let node = solution.trace.node(at);
        let ops = vec![(node.op.clone(), node.number), (op(Self::first_new(solution)), NONE)];
        Self { at, ops }
    }
}

/// The number of an operation that is yet to be computed.
const NONE: Number = Number::Scalar(f64::NAN);

impl<'s> Reevaluation<'s> {
    /// Ready to read what these numbers were made from.
    pub(crate) fn new(solution: &'s Solution, of: &[Id]) -> Self {
        let used = ancestors(solution, of);
        let is_used = |id: &Id| used.binary_search(id).is_ok();
        let errors = solution.common_errors.iter();
        let errors = errors.filter(|error| is_used(&solution.steps[error.step].result));
        let all: Vec<Id> = used.iter().copied().chain(errors.map(|error| error.formula)).collect();
        let order = ancestors(solution, &all);
        let numbers = solution.trace.nodes.iter().map(|node| node.number).collect();
        Self { solution, used, order, numbers }
    }

    /// Number of the operations that are read.
    pub(crate) fn len(&self) -> usize {
        self.order.len()
    }

    /// True if a number was used on the way to the wanted ones.
    pub(crate) fn uses(&self, id: Id) -> bool {
        self.used.binary_search(&id).is_ok()
    }

    /// The number of a node with these edits. What a numerical method found stays as it is.
    pub(crate) fn with(&mut self, edits: &[&Edit], wanted: &[Option<Id>]) -> Vec<Number> {
        let count = self.solution.trace.nodes.len();
        let first = edits.iter().map(|edit| edit.at).min().unwrap_or(Id::MAX);
        let begin = self.order.partition_point(|id| *id < first);
        for at in begin..self.order.len() {
            let id = self.order[at] as usize;
            self.numbers[id] = match edits.iter().find(|edit| edit.at as usize == id) {
                None => evaluated(self.solution, &self.solution.trace.nodes[id].op, id, &self.numbers),
                Some(edit) => {
                    self.numbers.truncate(count);
                    for (op, number) in &edit.ops {
                        self.numbers.push(*number);
                        let at = self.numbers.len() - 1;
                        self.numbers[at] = evaluated(self.solution, op, at, &self.numbers);
                    }
                    self.numbers[self.numbers.len() - 1]
                }
            };
        }
        let found = wanted.iter().map(|id| id.map_or(NONE, |id| self.numbers[id as usize])).collect();
        for id in &self.order[begin..] {
            self.numbers[*id as usize] = self.solution.trace.node(*id).number;
        }
        found
    }
}

/// The nodes that numbers were made from, in their order.
fn ancestors(solution: &Solution, of: &[Id]) -> Vec<Id> {
    let mut all: Vec<Id> = of.iter().flat_map(|id| solution.ancestors(*id)).collect();
    all.sort_unstable();
    all.dedup();
    all
}

fn evaluated(solution: &Solution, op: &Op, at: usize, numbers: &[Number]) -> Number {
    use Number::{Scalar, Vector};
    let own = numbers[at];
    let of = |id: Id| numbers[id as usize];
    let scalar = |id: Id| if let Scalar(x) = of(id) { x } else { f64::NAN };
    let vector = |id: Id| if let Vector(v) = of(id) { v } else { [f64::NAN; 3] };
    let each = |a: Number, b: Number, by: fn(f64, f64) -> f64| match (a, b) {
        (Scalar(a), Scalar(b)) => Scalar(by(a, b)),
        (Vector(a), Vector(b)) => Vector([0, 1, 2].map(|n| by(a[n], b[n]))),
        _ => Scalar(f64::NAN),
    };
    match op {
        Op::Literal | Op::Constant(_) | Op::Given { .. } => own,
        Op::Step(step) => solution.steps[*step].formula.map_or(own, of),
        Op::Add(a, b) => each(of(*a), of(*b), |a, b| a + b),
        Op::Sub(a, b) => each(of(*a), of(*b), |a, b| a - b),
        Op::Mul(a, b) => match (of(*a), of(*b)) {
            (Scalar(a), Scalar(b)) => Scalar(a * b),
            (Scalar(a), Vector(v)) | (Vector(v), Scalar(a)) => Vector(v.map(|x| a * x)),
            _ => Scalar(f64::NAN),
        },
        Op::Div(a, b) => match of(*a) {
            Scalar(a) => Scalar(a / scalar(*b)),
            Vector(v) => Vector(v.map(|x| x / scalar(*b))),
        },
        Op::Neg(a) => match of(*a) {
            Scalar(a) => Scalar(-a),
            Vector(v) => Vector(v.map(|x| -x)),
        },
        Op::Power(a, n) => Scalar(scalar(*a).powi((*n).into())),
        Op::Root(a, n) => Scalar(Real::root(scalar(*a), *n)),
        Op::Raised(a, b) => Scalar(scalar(*a).powf(scalar(*b))),
        Op::Min(a, b) => Scalar(scalar(*a).min(scalar(*b))),
        Op::Max(a, b) => Scalar(scalar(*a).max(scalar(*b))),
        Op::Call(function, a) => Scalar(function.of(scalar(*a))),
        Op::Atan2(y, x) => Scalar(Real::atan2(scalar(*y), scalar(*x))),
        Op::Sum(all) => {
            let mut all = all.iter().map(|id| of(*id));
            let first = all.next().unwrap_or(Scalar(0.0));
            all.fold(first, |sum, x| each(sum, x, |a, b| a + b))
        }
        Op::Dot(a, b) => {
            let (a, b) = (vector(*a), vector(*b));
            Scalar(a[0] * b[0] + a[1] * b[1] + a[2] * b[2])
        }
        Op::Cross(a, b) => {
            let (a, b) = (vector(*a), vector(*b));
            Vector([a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]])
        }
        Op::Magnitude(a) => Scalar(of(*a).size()),
        Op::Component(a, axis) => Scalar(vector(*a)[usize::from(*axis).min(2)]),
        Op::Compose(all) => Vector(all.map(scalar)),
    }
}
