//! A vector that remembers how it was found.

use std::ops::{Add, Div, Mul, Neg, Sub};

use dalembert_numerics::{Real, Vector};
use dalembert_units::Dim;
use nalgebra::Vector3;

use super::{Sheet, Term};
use crate::trace::{Id, Number, Op};

/// A vector on a sheet. A constant direction needs no sheet until it meets another number.
#[derive(Clone, Copy)]
pub enum VectorTerm<'s> {
    /// A vector of the formula itself.
    Literal([f64; 3]),
    /// A recorded vector.
    Node(&'s Sheet<'s>, Id),
}

impl<'s> VectorTerm<'s> {
    pub(super) fn on(self, sheet: &'s Sheet<'s>) -> Id {
        match self {
            VectorTerm::Literal(value) => sheet.push(Number::Vector(value), Dim::NONE, Op::Literal),
            VectorTerm::Node(_, id) => id,
        }
    }

    /// The node of this vector; a literal has none.
    pub(crate) fn node(self) -> Option<Id> {
        if let VectorTerm::Node(_, id) = self { Some(id) } else { None }
    }

    pub(super) fn sheet(self) -> Option<&'s Sheet<'s>> {
        if let VectorTerm::Node(sheet, _) = self { Some(sheet) } else { None }
    }

    fn binary(
        self,
        other: VectorTerm<'s>,
        value: Vector3<f64>,
        dim: impl FnOnce(&Sheet<'s>, Id, Id) -> Dim,
        op: impl FnOnce(Id, Id) -> Op,
    ) -> VectorTerm<'s> {
        let Some(sheet) = self.sheet().or(other.sheet()) else { return VectorTerm::Literal(value.into()) };
        let (a, b) = (self.on(sheet), other.on(sheet));
        let dim = dim(sheet, a, b);
        VectorTerm::Node(sheet, sheet.push(Number::Vector(value.into()), dim, op(a, b)))
    }

    /// A scalar made from this vector alone.
    fn scalar(self, value: f64, op: impl FnOnce(Id) -> Op) -> Term<'s> {
        match self {
            VectorTerm::Literal(_) => Term::Literal(value),
            VectorTerm::Node(sheet, id) => {
                let dim = sheet.node(id).1;
                Term::Node(sheet, sheet.push(Number::Scalar(value), dim, op(id)))
            }
        }
    }
}

impl<'s> Add for VectorTerm<'s> {
    type Output = VectorTerm<'s>;
    fn add(self, o: VectorTerm<'s>) -> VectorTerm<'s> {
        self.binary(o, self.value() + o.value(), Sheet::same_dim, Op::Add)
    }
}

impl<'s> Sub for VectorTerm<'s> {
    type Output = VectorTerm<'s>;
    fn sub(self, o: VectorTerm<'s>) -> VectorTerm<'s> {
        self.binary(o, self.value() - o.value(), Sheet::same_dim, Op::Sub)
    }
}

impl<'s> Neg for VectorTerm<'s> {
    type Output = VectorTerm<'s>;
    fn neg(self) -> VectorTerm<'s> {
        let value = -self.value();
        let VectorTerm::Node(sheet, id) = self else { return VectorTerm::Literal(value.into()) };
        let (_, dim) = sheet.node(id);
        VectorTerm::Node(sheet, sheet.push(Number::Vector(value.into()), dim, Op::Neg(id)))
    }
}

impl<'s> Mul<Term<'s>> for VectorTerm<'s> {
    type Output = VectorTerm<'s>;
    fn mul(self, o: Term<'s>) -> VectorTerm<'s> {
        let value = self.value() * o.value();
        let Some(sheet) = self.sheet().or(o.sheet()) else { return VectorTerm::Literal(value.into()) };
        let (vector, scalar) = (self.on(sheet), o.on(sheet));
        let dim = sheet.node(vector).1 * sheet.node(scalar).1;
        VectorTerm::Node(sheet, sheet.push(Number::Vector(value.into()), dim, Op::Mul(scalar, vector)))
    }
}

impl<'s> Div<Term<'s>> for VectorTerm<'s> {
    type Output = VectorTerm<'s>;
    fn div(self, o: Term<'s>) -> VectorTerm<'s> {
        let value = self.value() / o.value();
        let Some(sheet) = self.sheet().or(o.sheet()) else { return VectorTerm::Literal(value.into()) };
        let (vector, scalar) = (self.on(sheet), o.on(sheet));
        let dim = sheet.node(vector).1 / sheet.node(scalar).1;
        VectorTerm::Node(sheet, sheet.push(Number::Vector(value.into()), dim, Op::Div(vector, scalar)))
    }
}

impl<'s> Vector for VectorTerm<'s> {
    type Scalar = Term<'s>;

    fn from_components(x: Term<'s>, y: Term<'s>, z: Term<'s>) -> Self {
        let value = [x.value(), y.value(), z.value()];
        let Some(sheet) = x.sheet().or(y.sheet()).or(z.sheet()) else { return VectorTerm::Literal(value) };
        let ids = [x.on(sheet), y.on(sheet), z.on(sheet)];
        let dim = sheet.common_dim(&ids);
        VectorTerm::Node(sheet, sheet.push(Number::Vector(value), dim, Op::Compose(ids)))
    }

    fn components(self) -> [Term<'s>; 3] {
        let value = self.value();
        [0, 1, 2].map(|axis| self.scalar(value[usize::from(axis)], |id| Op::Component(id, axis)))
    }

    fn value(self) -> Vector3<f64> {
        match self {
            VectorTerm::Literal(value) => value.into(),
            VectorTerm::Node(sheet, id) => match sheet.node(id).0 {
                Number::Vector(value) => value.into(),
                Number::Scalar(_) => unreachable!("a vect is a vector"),
            },
        }
    }

    fn dot(self, o: VectorTerm<'s>) -> Term<'s> {
        let value = Vector::dot(self.value(), o.value());
        let Some(sheet) = self.sheet().or(o.sheet()) else { return Term::Literal(value) };
        let (a, b) = (self.on(sheet), o.on(sheet));
        let dim = sheet.node(a).1 * sheet.node(b).1;
        Term::Node(sheet, sheet.push(Number::Scalar(value), dim, Op::Dot(a, b)))
    }

    fn cross(self, o: VectorTerm<'s>) -> VectorTerm<'s> {
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
            return VectorTerm::Literal(value.into());
        };
        if let [only] = terms[..] {
            return only;
        }
        let ids: Vec<Id> = terms.iter().map(|term| term.on(sheet)).collect();
        let dim = sheet.common_dim(&ids);
        VectorTerm::Node(sheet, sheet.push(Number::Vector(value.into()), dim, Op::Sum(ids)))
    }
}
