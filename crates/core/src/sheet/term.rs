//! A number that remembers how it was found.

use std::ops::{Add, Div, Mul, Neg, Sub};

use dalembert_numerics::Real;
use dalembert_units::Dim;

use super::Sheet;
use crate::{
    printer,
    trace::{Function, Id, Number, Op},
};

/// A number on a sheet. A literal needs no sheet until it meets another number.
#[derive(Clone, Copy)]
pub enum Term<'s> {
    /// A number of the formula itself.
    Literal(f64),
    /// A recorded number.
    Node(&'s Sheet<'s>, Id),
}

impl<'s> Term<'s> {
    /// The node of this number on `sheet`; a literal becomes one.
    pub(super) fn on(self, sheet: &'s Sheet<'s>) -> Id {
        match self {
            Term::Literal(value) => sheet.push(Number::Scalar(value), Dim::NONE, Op::Literal),
            Term::Node(_, id) => id,
        }
    }

    /// The node of this number; a literal has none.
    pub(crate) fn node(self) -> Option<Id> {
        if let Term::Node(_, id) = self { Some(id) } else { None }
    }

    pub(super) fn sheet(self) -> Option<&'s Sheet<'s>> {
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
        self.call(Function::Sin, Real::sin(self.value()), Dim::NONE)
    }

    fn cos(self) -> Self {
        self.call(Function::Cos, Real::cos(self.value()), Dim::NONE)
    }

    fn tan(self) -> Self {
        self.call(Function::Tan, self.value().tan(), Dim::NONE)
    }

    fn asin(self) -> Self {
        self.call(Function::Asin, Real::asin(self.value()), Dim::ANGLE)
    }

    fn acos(self) -> Self {
        self.call(Function::Acos, Real::acos(self.value()), Dim::ANGLE)
    }

    fn atan2(self, x: Self) -> Self {
        let dim = |sheet: &Sheet<'_>, a, b| {
            sheet.same_dim(a, b);
            Dim::ANGLE
        };
        self.binary(x, Real::atan2(self.value(), x.value()), dim, Op::Atan2)
    }

    fn exp(self) -> Self {
        self.call(Function::Exp, self.value().exp(), Dim::NONE)
    }

    fn ln(self) -> Self {
        self.call(Function::Ln, Real::ln(self.value()), Dim::NONE)
    }

    fn log10(self) -> Self {
        self.call(Function::Log10, self.value().log10(), Dim::NONE)
    }

    fn sinh(self) -> Self {
        self.call(Function::Sinh, self.value().sinh(), Dim::NONE)
    }

    fn cosh(self) -> Self {
        self.call(Function::Cosh, self.value().cosh(), Dim::NONE)
    }

    fn tanh(self) -> Self {
        self.call(Function::Tanh, self.value().tanh(), Dim::NONE)
    }

    fn pow(self, exponent: Self) -> Self {
        self.binary(exponent, self.value().powf(exponent.value()), Sheet::power_dim, Op::Raised)
    }

    fn min(self, other: Self) -> Self {
        self.binary(other, self.value().min(other.value()), Sheet::same_dim, Op::Min)
    }

    fn max(self, other: Self) -> Self {
        self.binary(other, self.value().max(other.value()), Sheet::same_dim, Op::Max)
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
