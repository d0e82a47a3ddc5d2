//! Two ways to a number held together, within what rounding explains.

use dalembert_numerics::Real;

use super::{AGREEMENT, Sheet, Term, WAYS};
use crate::{Check, Sides, Text, trace::Id};

impl Sheet<'_> {
    /// Holds a difference to zero beside `scale`, of numbers that rounding alone lets differ by `error`.
    pub(super) fn hold(&self, what: Text, difference: f64, scale: f64, error: f64, sides: Sides) {
        let relative = |x: f64| if x == 0.0 { 0.0 } else { x / scale };
        let residual = relative(difference);
        let limit = AGREEMENT.max(relative(WAYS * error));
        // Multiplied and not divided: beside a scale of zero, rounding alone may differ.
        let passed = scale.is_finite() && difference <= (AGREEMENT * scale).max(WAYS * error);
        self.solution.borrow_mut().checks.push(Check { what, residual, limit, passed, sides });
    }

    pub(super) fn hold_together(&self, what: Text, left: Term<'_>, right: Term<'_>, scale: f64) {
        if let (Term::Node(_, a), Term::Node(_, b)) = (left, right) {
            self.same_dim(a, b);
        }
        let error = self.error_between(left.node(), right.node());
        let sides = Sides::of(left.node(), right.node());
        self.hold(what, (left.value() - right.value()).abs(), scale, error, sides);
    }

    pub(super) fn hold_to_zero(&self, what: Text, residual: Term<'_>, scale: f64, error: f64) {
        let error = error.abs() + self.error_between(residual.node(), None);
        let sides = residual.node().map_or(Sides::Plain, Sides::Residual);
        self.hold(what, residual.value().abs(), scale.abs(), error, sides);
    }

    /// Rounding error of a number, as it is carried along.
    pub(crate) fn error(&self, id: Id) -> f64 {
        self.solution.borrow().trace.node(id).error
    }

    /// Rounding error of the difference of two computations. Of a number from a numerical method, which has no trace,
    /// no more is expected than of the other way: both know their inputs to the last place.
    pub(super) fn error_between(&self, left: Option<Id>, right: Option<Id>) -> f64 {
        [left, right].into_iter().flatten().map(|id| self.error(id)).sum()
    }
}
