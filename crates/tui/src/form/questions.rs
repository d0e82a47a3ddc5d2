//! The usual questions of a problem, asked in its form.

use dalembert_core::{Locale, suggestions::Suggestion};

use super::{Change, Form};

impl Form {
    /// Asks a usual question, in the words of a language; the path of its row.
    pub fn ask_usual(&mut self, question: &Suggestion, locale: &Locale) -> Option<String> {
        let mut row = None;
        self.change(Change::Other, |draft, shape| {
            row = question.ask(draft, shape, locale).ok();
            row.is_some().then_some(())
        });
        row
    }
}
