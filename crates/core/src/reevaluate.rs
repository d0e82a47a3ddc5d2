//! The trace of a solution read again with some of its numbers changed: what would have come out.

use dalembert_numerics::Real;

use crate::{
    Solution,
    trace::{Id, Number, Op},
};

/// The numbers of the trace with those of `set` in place of its own, and with another operation at one node. What a
/// numerical method found stays as it is.
pub(crate) fn reevaluate(solution: &Solution, set: &[(Id, Number)], op: Option<(Id, &Op)>) -> Vec<Number> {
    let nodes = &solution.trace.nodes;
    let mut numbers: Vec<Number> = nodes.iter().map(|node| node.number).collect();
    let first = set.iter().map(|(id, _)| *id).chain(op.map(|(id, _)| id)).min();
    for at in first.map_or(nodes.len(), |first| first as usize)..nodes.len() {
        let here = set.iter().find(|(id, _)| *id as usize == at);
        numbers[at] = match (here, op) {
            (Some((_, number)), _) => *number,
            (None, Some((id, other))) if id as usize == at => evaluated(solution, other, at, &numbers),
            _ => evaluated(solution, &nodes[at].op, at, &numbers),
        };
    }
    numbers
}

/// The nodes that a number was made from, its own among them, through the steps before.
pub(crate) fn ancestors(solution: &Solution, of: Id) -> Vec<Id> {
    let mut seen = vec![false; solution.trace.nodes.len()];
    let mut open = vec![of];
    while let Some(id) = open.pop() {
        if std::mem::replace(&mut seen[id as usize], true) {
            continue;
        }
        open.extend(solution.trace.operands(id));
        if let Op::Step(step) = solution.trace.node(id).op {
            open.extend(solution.steps[step].formula);
        }
    }
    (0..).zip(seen).filter_map(|(id, seen)| seen.then_some(id)).collect()
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
