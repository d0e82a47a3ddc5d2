//! Common errors that an analysis knows of its steps.

use super::{Sheet, Term};
use crate::{CommonError, Symbol, Text};

impl<'s> Sheet<'s> {
    /// Keeps an error of the next step of a symbol, unless it gives no number with these inputs.
    pub(super) fn note_common_error(&'s self, symbol: Symbol, what: Text, wrong: impl FnOnce() -> Term<'s>) {
        let before = self.solution.borrow().trace.nodes.len();
        let formula = wrong().on(self);
        if self.node(formula).0.is_finite() {
            self.common_errors.borrow_mut().push((symbol, CommonError { step: 0, formula, what }));
        } else {
            self.solution.borrow_mut().trace.nodes.truncate(before);
        }
    }

    /// Gives the step that was written last the errors that are known of its symbol.
    pub(super) fn settle_common_errors(&self, symbol: Symbol) {
        let mut solution = self.solution.borrow_mut();
        let step = solution.steps.len() - 1;
        for (_, error) in self.common_errors.borrow_mut().extract_if(.., |(of, _)| *of == symbol) {
            solution.common_errors.push(CommonError { step, ..error });
        }
    }
}
