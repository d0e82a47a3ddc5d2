//! Common errors that an analysis knows of its steps.

use super::{Sheet, Term};
use crate::{CommonError, Symbol, Text};

impl<'s> Sheet<'s> {
    /// Keeps what people compute in place of the next step of a symbol.
    pub(super) fn note_common_error(&'s self, symbol: Symbol, what: Text, wrong: Term<'s>) {
        let formula = wrong.on(self);
        self.common_errors.borrow_mut().push((symbol, CommonError { step: 0, formula, what }));
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
