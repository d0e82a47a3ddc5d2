//! One mistake within a step: an edit of the trace.

use super::Change;
use crate::{
    Solution,
    reevaluate::Edit,
    trace::{Id, Number, Op},
};

/// An edit of the trace, how common it is, and what it does.
pub(super) struct Slip {
    pub(super) prior: f64,
    pub(super) change: Change,
    pub(super) edit: Edit,
    /// The term, factor or argument that it is about.
    pub(super) of: Option<Id>,
}

impl Slip {
    pub(super) fn new(prior: f64, change: Change, edit: Edit) -> Self {
        Self { prior, change, edit, of: None }
    }

    pub(super) fn of(self, id: Id) -> Self {
        Self { of: Some(id), ..self }
    }
}

/// The number of an operation that is computed when it is read.
pub(super) const UNKNOWN: Number = Number::Scalar(f64::NAN);

/// The number of a node as it is. The first power of a number is the number; a sum of one vector is the vector.
pub(super) fn alone(id: Id) -> Op {
    Op::Sum(vec![id])
}

/// True for a number that is no vector.
pub(super) fn is_scalar(solution: &Solution, id: Id) -> bool {
    matches!(solution.trace.node(id).number, Number::Scalar(_))
}
