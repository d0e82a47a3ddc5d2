//! Formulas that a user writes over definitions, inputs, answers and steps: `c*(omega*X)^2/2`.
//!
//! sum = product (± product)…, product = signed (× ÷ signed)…, signed = − signed | power,
//! power = atom ^ signed, atom = quantity | π | √ atom | ( sum ) | vector | name | function ( sum, … ),
//! vector = ( sum; sum ) unit | ( sum; sum; sum ) unit. The unit goes with the components that are numbers without one.
//!
//! A word directly behind a number is a unit: `2 kg`. A word behind an operator or a bracket, or at the start, is a
//! name, and a unit only where no name fits. Behind a stroke in a unit stands a unit: `7850 kg/m^3`. A product of units in which a name is visible, as `3 N*m` where m is a mass,
//! is refused with both spellings.

mod evaluate;
mod names;
mod parse;

use std::ops::Range;

use dalembert_units::{Dim, Quantity, Unit};

pub use self::names::normalised;
pub(crate) use self::{
    evaluate::{Operand, evaluate, unit_of},
    names::{missing, nearest_names},
};
use crate::{Plain, Stop, Text};

/// A formula that could be read; its names are still to be looked up.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Formula {
    /// The whole expression.
    pub(crate) root: Expression,
    /// The text as it was typed.
    pub(crate) text: String,
}

/// A formula or a part of one.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Expression {
    /// A number, perhaps with a unit.
    Quantity(Quantity),
    /// The ratio of the circumference of a circle to its diameter.
    Pi,
    /// A name, and where it stands.
    Name(String, Range<usize>),
    /// `−a`
    Negative(Box<Expression>),
    /// An operation on two.
    Binary(Operator, Box<Expression>, Box<Expression>, Range<usize>),
    /// A function of its arguments.
    Call(Function, Vec<Expression>, Range<usize>),
    /// A vector of its components, with the unit behind its brackets.
    Vector(Vec<Expression>, Unit, Range<usize>),
}

/// An operation on two expressions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Operator {
    Add,
    Subtract,
    Multiply,
    Divide,
    Power,
}

/// A function of formulas.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Function {
    Sin,
    Cos,
    Tan,
    Asin,
    Acos,
    Atan,
    Sinh,
    Cosh,
    Tanh,
    Exp,
    Ln,
    Log10,
    Sqrt,
    Cbrt,
    Abs,
    Min,
    Max,
    Hypot,
    Atan2,
    Norm,
    Dot,
    Cross,
    Sum,
    Mean,
    Maximum,
    Minimum,
    Choose,
}

/// Reason for which a formula cannot be read or has no value.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct FormulaError {
    /// The reason and the repair.
    pub(crate) why: Text,
    /// The bytes of the formula that are wrong, where they are known.
    pub(crate) span: Option<Range<usize>>,
}

/// The value of a formula over pure numbers, the named ones given by `names`.
///
/// # Errors
/// What is wrong with the formula, a name without a value, a result that is not finite.
pub fn value_of_numbers(text: &str, names: &dyn Fn(&str) -> Option<f64>) -> Result<f64, Text> {
    let stop = Stop::new();
    let sheet = Plain::<f64>::new(&stop);
    let scope = |name: &str| Ok(names(name).map(|x| Operand::Number(x, Dim::NONE)));
    let root = parse::parse(text, &|name| names(name).is_some()).map_err(|error| error.why)?;
    let formula = Formula { root, text: text.to_owned() };
    match evaluate(&formula, &scope, &|_| Vec::new(), &sheet).map_err(|error| error.why)? {
        Operand::Number(x, _) => Ok(x),
        _ => Err("the formula is no single number".into()),
    }
}

impl Function {
    /// Every function by its names, English first, with the number of arguments.
    const ALL: [(&'static [&'static str], Function, std::ops::RangeInclusive<usize>); 27] = [
        (&["sin", "sen"], Function::Sin, 1..=1),
        (&["cos"], Function::Cos, 1..=1),
        (&["tan", "tg"], Function::Tan, 1..=1),
        (&["asin", "arcsin", "arcsen"], Function::Asin, 1..=1),
        (&["acos", "arccos"], Function::Acos, 1..=1),
        (&["atan", "arctan", "arctg"], Function::Atan, 1..=1),
        (&["sinh", "senh"], Function::Sinh, 1..=1),
        (&["cosh"], Function::Cosh, 1..=1),
        (&["tanh", "tgh"], Function::Tanh, 1..=1),
        (&["exp"], Function::Exp, 1..=1),
        (&["ln"], Function::Ln, 1..=1),
        (&["log10", "log"], Function::Log10, 1..=1),
        (&["sqrt", "raiz"], Function::Sqrt, 1..=1),
        (&["cbrt"], Function::Cbrt, 1..=1),
        (&["abs"], Function::Abs, 1..=1),
        (&["min"], Function::Min, 2..=MOST_ARGUMENTS),
        (&["max"], Function::Max, 2..=MOST_ARGUMENTS),
        (&["hypot"], Function::Hypot, 2..=3),
        (&["atan2"], Function::Atan2, 2..=2),
        (&["norm"], Function::Norm, 1..=1),
        (&["dot"], Function::Dot, 2..=2),
        (&["cross"], Function::Cross, 2..=2),
        (&["sum"], Function::Sum, 1..=MOST_ARGUMENTS),
        (&["mean"], Function::Mean, 1..=MOST_ARGUMENTS),
        (&["maximum"], Function::Maximum, 1..=MOST_ARGUMENTS),
        (&["minimum"], Function::Minimum, 1..=MOST_ARGUMENTS),
        (&["choose", "escolher"], Function::Choose, 2..=MOST_ARGUMENTS),
    ];

    /// The function of a name.
    pub(crate) fn of(name: &str) -> Option<Self> {
        Self::ALL.iter().find(|(names, ..)| names.contains(&name)).map(|(_, function, _)| *function)
    }

    /// The names of all functions, one each.
    pub(crate) fn names() -> impl Iterator<Item = &'static str> {
        Self::ALL.iter().map(|(names, ..)| names[0])
    }

    fn name(self) -> &'static str {
        Self::ALL.iter().find(|(_, function, _)| *function == self).map_or("", |(names, ..)| names[0])
    }

    fn arguments(self) -> std::ops::RangeInclusive<usize> {
        let all = Self::ALL.iter().find(|(_, function, _)| *function == self);
        all.map_or(1..=1, |(.., arguments)| arguments.clone())
    }
}

/// The most arguments of a function.
const MOST_ARGUMENTS: usize = 50;

impl Formula {
    /// Reads a formula. `is_name` tells whether a word is a name that can be seen from here.
    pub(crate) fn parse(text: &str, is_name: &dyn Fn(&str) -> bool) -> Result<Self, FormulaError> {
        Ok(Self { root: parse::parse(text, is_name)?, text: text.trim().to_owned() })
    }

    /// The names in it, in the order they stand, each with its place.
    pub(crate) fn names(&self) -> Vec<(&str, Range<usize>)> {
        let mut found = Vec::new();
        self.root.collect_names(&mut found);
        found
    }

    /// Returns true if it calls a function.
    pub(crate) fn calls(&self) -> bool {
        fn within(expression: &Expression) -> bool {
            match expression {
                Expression::Call(..) => true,
                Expression::Negative(inner) => within(inner),
                Expression::Binary(_, left, right, _) => within(left) || within(right),
                Expression::Vector(components, ..) => components.iter().any(within),
                Expression::Quantity(_) | Expression::Pi | Expression::Name(..) => false,
            }
        }
        within(&self.root)
    }

    /// The name that it is, where it is one alone.
    pub(crate) fn single_name(&self) -> Option<&str> {
        if let Expression::Name(name, _) = &self.root { Some(name) } else { None }
    }

    /// The quantity, where the formula is nothing else.
    pub(crate) fn quantity(&self) -> Option<&Quantity> {
        if let Expression::Quantity(quantity) = &self.root { Some(quantity) } else { None }
    }
}

impl Expression {
    fn collect_names<'f>(&'f self, found: &mut Vec<(&'f str, Range<usize>)>) {
        match self {
            Expression::Quantity(_) | Expression::Pi => {}
            Expression::Name(name, span) => found.push((name, span.clone())),
            Expression::Negative(inner) => inner.collect_names(found),
            Expression::Binary(_, left, right, _) => {
                left.collect_names(found);
                right.collect_names(found);
            }
            Expression::Call(_, arguments, _) | Expression::Vector(arguments, ..) => {
                for argument in arguments {
                    argument.collect_names(found);
                }
            }
        }
    }
}

impl FormulaError {
    fn at(span: Range<usize>, why: impl Into<Text>) -> Self {
        Self { why: why.into(), span: Some(span) }
    }
}
