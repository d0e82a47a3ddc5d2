//! Steps that stand before the solution they are of: where it comes to the same step, it goes on with that one.

use super::{Sheet, Term};
use crate::{
    Reason, Symbol, Text,
    trace::{Id, Number},
};

impl<'a> Sheet<'a> {
    /// The result of the same step, where it was written early.
    pub(super) fn early(
        &self,
        symbol: Symbol,
        formula: Option<Id>,
        number: Number,
        why: &Reason,
    ) -> Option<Id> {
        let mut early = self.early.borrow_mut();
        let at = early
            .iter()
            .position(|step| self.is_step(*step, symbol, formula.map(|_| number), &why.reason))?;
        Some(self.solution.borrow().steps[early.remove(at)].result)
    }

    /// Returns true if a step has a symbol, a formula of that value, or none, and a reason.
    fn is_step(&self, step: usize, symbol: Symbol, formula: Option<Number>, why: &Text) -> bool {
        let solution = self.solution.borrow();
        let step = &solution.steps[step];
        let value = step.formula.map(|id| solution.trace.node(id).number);
        step.symbol == symbol && value == formula && step.why == *why
    }

    /// Writes a step of a solution that is written later, and goes on with it there; a step that is there already is not
    /// written again.
    pub(crate) fn step_early(
        &'a self,
        symbol: Symbol,
        formula: Option<Number>,
        why: &Text,
        write: impl FnOnce() -> Term<'a>,
    ) -> Term<'a> {
        let count = self.solution().steps.len();
        if let Some(step) = (0..count).find(|step| self.is_step(*step, symbol, formula, why)) {
            return self.term(self.solution().steps[step].result);
        }
        let result = write();
        self.early.borrow_mut().push(count);
        result
    }
}
