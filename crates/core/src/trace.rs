//! Trace of a solution: the computation of every number, as plain data.

use dalembert_numerics::Real;
use dalembert_units::{Dim, Unit};

/// The place of a node in its [`Trace`].
pub type Id = u32;

/// Every number of a solution, each with the operation that made it; operands stand before results.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Trace {
    /// The nodes.
    pub nodes: Vec<TraceNode>,
}

/// A number and where it came from.
#[derive(Clone, Debug, PartialEq)]
pub struct TraceNode {
    /// Value, in SI.
    pub number: Number,
    /// Dimension.
    pub dim: Dim,
    /// Operation that gave it.
    pub op: Op,
    /// The size of what was added up to make it: what its rounding is measured against.
    pub scale: f64,
    /// The bound of its rounding error, to first order: what the last places of the inputs and of every operation on
    /// the way may change in it, in SI.
    pub error: f64,
}

/// Relative size below which the sum of cancelling terms is rounding noise.
pub const ROUNDING: f64 = 1e-14;

/// A number or a vector, in SI.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Number {
    /// A number.
    Scalar(f64),
    /// Components along `i`, `j` and `k`.
    Vector([f64; 3]),
}

/// Operation that gives a number.
#[derive(Clone, Debug, PartialEq)]
pub enum Op {
    /// A number of the formula itself: the 3 of `3 E I / L³`.
    Literal,
    /// A number with a unit in a formula that a user wrote: the 2 kg of `m + 2 kg`.
    Constant(Unit),
    /// An input, in the unit it was typed in.
    Given {
        /// Symbol in formulas.
        symbol: Symbol,
        /// The unit it was typed in.
        unit: Unit,
        /// Path in the inputs: `masses[1].radius`.
        path: String,
    },
    /// The result of a step, by the step's place in the solution.
    Step(usize),
    /// `a + b`
    Add(Id, Id),
    /// `a − b`
    Sub(Id, Id),
    /// `a b`; also a number times a vector.
    Mul(Id, Id),
    /// `a / b`; also a vector over a number.
    Div(Id, Id),
    /// `−a`
    Neg(Id),
    /// `aⁿ`
    Power(Id, i8),
    /// The `n`th root.
    Root(Id, u8),
    /// `aᵇ` with an exponent that is computed.
    Raised(Id, Id),
    /// The smaller of two.
    Min(Id, Id),
    /// The larger of two.
    Max(Id, Id),
    /// A function of one number.
    Call(Function, Id),
    /// `atan2(y, x)`
    Atan2(Id, Id),
    /// The sum of all.
    Sum(Vec<Id>),
    /// `a · b`
    Dot(Id, Id),
    /// `a × b`
    Cross(Id, Id),
    /// `|a|` of a vector.
    Magnitude(Id),
    /// One component of a vector: 0, 1 or 2.
    Component(Id, u8),
    /// `x i + y j + z k`
    Compose([Id; 3]),
}

/// A function of one number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Function {
    /// `sin`
    Sin,
    /// `cos`
    Cos,
    /// `tan`
    Tan,
    /// `arcsin`
    Asin,
    /// `arccos`
    Acos,
    /// `exp`
    Exp,
    /// `ln`
    Ln,
    /// `log₁₀`
    Log10,
    /// `sinh`
    Sinh,
    /// `cosh`
    Cosh,
    /// `tanh`
    Tanh,
    /// `|x|`
    Abs,
}

impl Function {
    /// The function of a number.
    pub(crate) fn of<N: Real>(self, x: N) -> N {
        match self {
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
}

/// Symbol of a quantity in formulas: its letter, subscript (`r_A`), and rows, counted from 1 (`m₁`).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Symbol {
    /// The symbol without its index.
    pub base: &'static str,
    /// The part of the problem it belongs to; may be empty.
    pub of: &'static str,
    /// The rows, outermost first; 0 where there are no more.
    pub rows: [u16; 3],
}

impl Symbol {
    /// The same symbol in one more row, counted from 1.
    #[must_use]
    pub fn row(mut self, row: usize) -> Self {
        if let Some(free) = self.rows.iter_mut().find(|row| **row == 0) {
            *free = u16::try_from(row).unwrap_or(u16::MAX);
        }
        self
    }
}

impl From<&'static str> for Symbol {
    fn from(base: &'static str) -> Self {
        Self { base, of: "", rows: [0; 3] }
    }
}

impl From<(&'static str, usize)> for Symbol {
    fn from((base, row): (&'static str, usize)) -> Self {
        Symbol::from(base).row(row)
    }
}

impl Trace {
    /// The node at `id`.
    pub fn node(&self, id: Id) -> &TraceNode {
        &self.nodes[id as usize]
    }

    /// The number at `id`, with what is rounding alone taken as zero.
    pub fn without_noise(&self, id: Id) -> Number {
        let node = self.node(id);
        node.number.without_noise(ROUNDING * node.scale)
    }

    /// The size of what an operation adds up.
    pub(crate) fn scale_of(&self, op: &Op, number: Number) -> f64 {
        let (scale, size) = (|id: Id| self.node(id).scale, |id: Id| self.node(id).number.size());
        let scale = match *op {
            Op::Add(a, b) | Op::Sub(a, b) | Op::Min(a, b) | Op::Max(a, b) => scale(a).max(scale(b)),
            Op::Mul(a, b) | Op::Dot(a, b) | Op::Cross(a, b) => scale(a) * scale(b),
            Op::Div(a, b) => scale(a) / size(b),
            Op::Neg(a) | Op::Magnitude(a) | Op::Component(a, _) | Op::Call(Function::Abs, a) => scale(a),
            Op::Power(a, n) if n > 0 => scale(a).powi(n.into()),
            Op::Root(a, n) => scale(a).powf(1.0 / f64::from(n)),
            Op::Call(Function::Sin | Function::Cos, _) => 1.0,
            // Through the derivative: an angle of a point near the axis, or of a cosine near one.
            Op::Call(Function::Asin | Function::Acos, a) => {
                scale(a) / ((1.0 - size(a)) * (1.0 + size(a))).sqrt()
            }
            Op::Atan2(y, x) => {
                (size(x) * scale(y) + size(y) * scale(x)) / (size(x).powi(2) + size(y).powi(2))
            }
            Op::Sum(ref all) => all.iter().map(|id| scale(*id)).fold(0.0, f64::max),
            Op::Compose(all) => all.into_iter().map(scale).fold(0.0, f64::max),
            _ => 0.0,
        };
        if scale.is_finite() { scale.max(number.size()) } else { number.size() }
    }

    /// The running error bound of a number: each operand's through the derivative of the operation, and half a unit in
    /// the last place, taken whole, for the operation itself. A root near zero, where the derivative grows without
    /// limit, moves by no more than the root of the error.
    pub(crate) fn error_of(&self, op: &Op, number: Number) -> f64 {
        let (error, size) = (|id: Id| self.node(id).error, |id: Id| self.node(id).number.size());
        let own = f64::EPSILON * number.size();
        let product = |a: Id, b: Id| size(a) * error(b) + size(b) * error(a);
        let carried = match *op {
            Op::Literal | Op::Constant(_) | Op::Given { .. } | Op::Step(_) => 0.0,
            Op::Add(a, b) | Op::Sub(a, b) => error(a) + error(b),
            Op::Min(a, b) | Op::Max(a, b) => error(a).max(error(b)),
            Op::Raised(a, b) => {
                number.size() * (size(b) * error(a) / size(a) + size(a).ln().abs() * error(b))
            }
            Op::Mul(a, b) => product(a, b),
            Op::Dot(a, b) | Op::Cross(a, b) => product(a, b) + f64::EPSILON * size(a) * size(b),
            Op::Div(a, b) => (error(a) + number.size() * error(b)) / size(b),
            Op::Neg(a) | Op::Magnitude(a) | Op::Component(a, _) | Op::Call(Function::Abs, a) => error(a),
            Op::Power(a, n) => f64::from(n).abs() * size(a).powi(i32::from(n) - 1) * error(a),
            Op::Root(a, n) => {
                let n = f64::from(n);
                let smooth = error(a) * number.size().powf(1.0 - n) / n;
                smooth.min(error(a).powf(1.0 / n))
            }
            Op::Call(function, a) => {
                let (x, error) = (size(a), error(a));
                match function {
                    Function::Sin => x.cos().abs() * error,
                    Function::Cos => x.sin().abs() * error,
                    Function::Tan => (1.0 + number.size().powi(2)) * error,
                    Function::Asin | Function::Acos => {
                        (error / (1.0 - x * x).max(0.0).sqrt()).min((2.0 * error).sqrt())
                    }
                    Function::Exp => number.size() * error,
                    Function::Ln => error / x,
                    Function::Log10 => error / x * std::f64::consts::LOG10_E,
                    Function::Sinh => x.cosh() * error,
                    Function::Cosh => x.sinh().abs() * error,
                    Function::Tanh => (1.0 - number.size().powi(2)) * error,
                    Function::Abs => error,
                }
            }
            Op::Atan2(y, x) => (size(x) * error(y) + size(y) * error(x)) / size(x).hypot(size(y)).powi(2),
            Op::Sum(ref all) => all.iter().map(|id| error(*id) + f64::EPSILON * size(*id)).sum(),
            Op::Compose(all) => all.into_iter().map(error).sum(),
        };
        if carried.is_nan() { own } else { own + carried }
    }

    /// The nodes that `id` was made from.
    pub fn operands(&self, id: Id) -> Vec<Id> {
        match &self.node(id).op {
            Op::Literal | Op::Constant(_) | Op::Given { .. } | Op::Step(_) => Vec::new(),
            Op::Add(a, b)
            | Op::Raised(a, b)
            | Op::Min(a, b)
            | Op::Max(a, b)
            | Op::Sub(a, b)
            | Op::Mul(a, b)
            | Op::Div(a, b)
            | Op::Atan2(a, b)
            | Op::Dot(a, b)
            | Op::Cross(a, b) => vec![*a, *b],
            Op::Neg(a)
            | Op::Power(a, _)
            | Op::Root(a, _)
            | Op::Call(_, a)
            | Op::Magnitude(a)
            | Op::Component(a, _) => {
                vec![*a]
            }
            Op::Sum(all) => all.clone(),
            Op::Compose(all) => all.to_vec(),
        }
    }
}

impl Number {
    /// The same number with components no larger than `noise` taken as zero.
    #[must_use]
    pub fn without_noise(self, noise: f64) -> Number {
        let clean = |x: f64| if x.abs() <= noise { 0.0 } else { x };
        match self {
            Number::Scalar(x) => Number::Scalar(clean(x)),
            Number::Vector(v) => Number::Vector(v.map(clean)),
        }
    }

    /// The same number so many times as large.
    pub(crate) fn times(self, factor: f64) -> Number {
        match self {
            Number::Scalar(x) => Number::Scalar(factor * x),
            Number::Vector(v) => Number::Vector(v.map(|x| factor * x)),
        }
    }

    /// The sum of two numbers or of two vectors.
    pub(crate) fn plus(self, other: Number) -> Option<Number> {
        match (self, other) {
            (Number::Scalar(a), Number::Scalar(b)) => Some(Number::Scalar(a + b)),
            (Number::Vector(a), Number::Vector(b)) => Some(Number::Vector([0, 1, 2].map(|n| a[n] + b[n]))),
            _ => None,
        }
    }

    /// Returns true if every component is finite.
    pub fn is_finite(self) -> bool {
        match self {
            Number::Scalar(x) => x.is_finite(),
            Number::Vector(v) => v.iter().all(|x| x.is_finite()),
        }
    }

    /// The number itself, or the magnitude of the vector.
    pub fn size(self) -> f64 {
        match self {
            Number::Scalar(x) => x.abs(),
            Number::Vector([x, y, z]) => x.hypot(y).hypot(z),
        }
    }
}
