//! Mutants of worked solutions: one number of a formula is made wrongly, and everything after it, what numerical methods make
//! of it included, goes on with the wrong number. What the checks and the published answers notice of them is their strength.

use std::f64::consts::TAU;

use dalembert_numerics::Real;

use crate::trace::{Function, Id, Number, Op, ROUNDING, Trace};

/// The relative error that a check must notice to cover a number: far above the limits of checks, and small enough for
/// the rest of a solve to take the same way.
pub const PERTURBATION: f64 = 1e-6;

/// A number of a trace that is made wrongly.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Mutant {
    /// The node of the number.
    pub at: Id,
    /// The wrong operation.
    pub mutation: Mutation,
}

/// A wrong operation in the place of the right one.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Mutation {
    /// The result of a step is wrong by [`PERTURBATION`].
    Perturbed,
    /// The result of a step has the other sign.
    Negated,
    /// The result of a step is twice as large.
    Doubled,
    /// The result of a step is 2π times as large: revolutions for radians.
    FullTurn,
    /// `a − b` for `a + b`, `a + b` for `a − b`, `a` for `−a`, and the last term of a sum with the other sign.
    Sign,
    /// Cosine for sine, sine for cosine, cotangent for tangent; the same of hyperbolic and inverse functions.
    Cofunction,
    /// The angle of a trigonometric function is taken in degrees, the angle that an inverse one gives as well.
    Degrees,
    /// The operands of `a/b`, `a × b`, `atan2(y, x)` or `aᵇ` are interchanged.
    Transposed,
}

impl Mutation {
    /// Those that stand for the mistakes of a person who writes a formula: all but the smallest.
    pub const ALL: [Mutation; 7] = [
        Mutation::Negated,
        Mutation::Doubled,
        Mutation::FullTurn,
        Mutation::Sign,
        Mutation::Cofunction,
        Mutation::Degrees,
        Mutation::Transposed,
    ];

    /// The name in reports.
    pub const fn name(self) -> &'static str {
        match self {
            Mutation::Perturbed => "perturbed",
            Mutation::Negated => "negated",
            Mutation::Doubled => "doubled",
            Mutation::FullTurn => "times 2π",
            Mutation::Sign => "sign",
            Mutation::Cofunction => "cofunction",
            Mutation::Degrees => "degrees",
            Mutation::Transposed => "transposed",
        }
    }

    /// The wrong number in the place of `right`, which `op` makes of numbers of the trace; `None` where the mutation is of
    /// another operation. `scale` is the size of what was added up to make it.
    pub(crate) fn of(self, trace: &Trace, op: &Op, right: Number, scale: f64) -> Option<Number> {
        let number = |id: Id| trace.node(id).number;
        let scalar = |id: Id| if let Number::Scalar(x) = number(id) { Some(x) } else { None };
        let of_one = |id: Id, of: fn(f64) -> f64| scalar(id).map(|x| Number::Scalar(of(x)));
        let of_two = |a: Id, b: Id, of: fn(f64, f64) -> f64| Some(Number::Scalar(of(scalar(a)?, scalar(b)?)));
        match (self, op) {
            (Mutation::Perturbed, Op::Step(_)) => Some(perturbed(right, scale)),
            (Mutation::Negated, Op::Step(_)) | (Mutation::Transposed, Op::Cross(..)) => {
                Some(right.times(-1.0))
            }
            (Mutation::Doubled, Op::Step(_)) => Some(right.times(2.0)),
            (Mutation::FullTurn, Op::Step(_)) => Some(right.times(TAU)),
            (Mutation::Sign, Op::Add(_, b)) => right.plus(number(*b).times(-2.0)),
            (Mutation::Sign, Op::Sub(_, b)) => right.plus(number(*b).times(2.0)),
            (Mutation::Sign, Op::Neg(a)) => Some(number(*a)),
            (Mutation::Sign, Op::Sum(all)) => right.plus(number(*all.last()?).times(-2.0)),
            (Mutation::Cofunction, Op::Call(function, a)) => of_one(*a, cofunction(*function)?),
            (Mutation::Degrees, Op::Call(Function::Sin, a)) => of_one(*a, |x| x.to_degrees().sin()),
            (Mutation::Degrees, Op::Call(Function::Cos, a)) => of_one(*a, |x| x.to_degrees().cos()),
            (Mutation::Degrees, Op::Call(Function::Tan, a)) => of_one(*a, |x| x.to_degrees().tan()),
            (Mutation::Degrees, Op::Call(Function::Asin | Function::Acos, _) | Op::Atan2(..)) => {
                Some(right.times(1_f64.to_degrees()))
            }
            (Mutation::Transposed, Op::Div(a, b)) => of_two(*a, *b, |a, b| b / a),
            (Mutation::Transposed, Op::Raised(a, b)) => of_two(*a, *b, |a, b| b.powf(a)),
            (Mutation::Transposed, Op::Atan2(y, x)) => of_two(*y, *x, |y, x| Real::atan2(x, y)),
            _ => None,
        }
    }
}

impl Mutant {
    /// The wrong number in the place of the right one of a finished trace; `None` where the mutation is of another operation,
    /// or makes no difference beyond rounding.
    pub fn number(self, trace: &Trace) -> Option<Number> {
        let node = trace.node(self.at);
        let wrong = self.mutation.of(trace, &node.op, node.number, node.scale)?;
        let difference = wrong.plus(node.number.times(-1.0))?.size();
        (difference > ROUNDING * node.scale || difference.is_nan()).then_some(wrong)
    }
}

fn cofunction(function: Function) -> Option<fn(f64) -> f64> {
    Some(match function {
        Function::Sin => f64::cos,
        Function::Cos => f64::sin,
        Function::Tan => |x| x.tan().recip(),
        Function::Asin => f64::acos,
        Function::Acos => f64::asin,
        Function::Sinh => f64::cosh,
        Function::Cosh => f64::sinh,
        Function::Tanh => |x| x.tanh().recip(),
        Function::Exp | Function::Ln | Function::Log10 | Function::Abs => return None,
    })
}

/// The same number, wrong by [`PERTURBATION`]; where it is rounding alone, wrong by as much of `scale`, the size of what was
/// added up to make it.
fn perturbed(number: Number, scale: f64) -> Number {
    let size = number.size();
    let error = PERTURBATION * if size <= ROUNDING * scale { scale } else { size };
    match number {
        Number::Scalar(x) => Number::Scalar(x + error.copysign(x)),
        Number::Vector(v) if size == 0.0 => Number::Vector(v.map(|x| x + error)),
        Number::Vector(_) => number.times(1.0 + error / size),
    }
}
