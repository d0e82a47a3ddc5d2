//! A problem file that is open in a page.

use std::ops::Range;

use dalembert_core::{
    FieldError, Locale, Record, Refusal, Shape, Solution, SolveError, Stop, Text,
    draft::repairs,
    file::{self, ProblemFile},
};
use dalembert_report::{RequestError, WorkedProblem, named_error, show_answers_in, typed};

/// A problem file as read; its inputs may be wrong.
pub(crate) struct Problem {
    pub(crate) file: ProblemFile,
    pub(crate) shape: Shape,
    /// Title, as reports have it.
    title: Text,
    /// Text of the file, which a change is written over.
    text: String,
}

/// A problem with what came of it.
pub(crate) struct SolvedProblem<'p> {
    pub(crate) problem: &'p Problem,
    pub(crate) record: Record,
    notes: Vec<Text>,
    pub(crate) outcome: Result<Solution, Text>,
}

impl Problem {
    /// Reads the text of a problem file that links to no other.
    ///
    /// # Errors
    /// What is wrong with the file, with the lines.
    pub(crate) fn read(text: &str, locale: &Locale) -> Result<Self, Vec<RequestError>> {
        let line = |span: &Range<usize>| file::line_of(text, span.start);
        let file = file::parse(text).map_err(|errors| {
            let errors = errors.iter();
            errors
                .map(|error| RequestError::of(&error.why, error.span.as_ref().map(line), locale))
                .collect::<Vec<_>>()
        })?;
        let (shape, title) = (file.entry.shape(), Text::verbatim(&file.title));
        Ok(Self { file, shape, title, text: text.to_owned() })
    }

    /// Text of the file with the inputs as they are now.
    pub(crate) fn text(&self) -> String {
        file::write(&self.file, &self.text)
    }

    /// Errors of inputs, each with the value that was typed and the texts to write in its place.
    pub(crate) fn errors(&self, errors: &[FieldError], locale: &Locale) -> Vec<RequestError> {
        let locale = &locale.at(self.file.entry.about.id);
        let draft = &self.file.draft;
        errors
            .iter()
            .map(|error| RequestError::of(&named_error(error, draft, &self.shape), None, locale))
            .collect()
    }

    /// Texts to write in place of that at a path, which cannot be read.
    pub(crate) fn repairs(&self, path: &str) -> Vec<String> {
        let draft = &self.file.draft;
        let shape = draft.at(&self.shape, path).map(|(_, shape)| shape);
        shape.map_or_else(|_| Vec::new(), |shape| repairs(&typed(draft, &self.shape, path), &shape))
    }

    /// Solves the problem. A refusal is an outcome.
    ///
    /// # Errors
    /// Inputs that are wrong: all of them.
    pub(crate) fn solve(&self, locale: &Locale) -> Result<SolvedProblem<'_>, Vec<RequestError>> {
        let (entry, draft) = (self.file.entry, &self.file.draft);
        let record = draft.read(&self.shape).map_err(|errors| self.errors(&errors, locale))?;
        let bare = draft.without_unit(&self.shape);
        let bare = bare.iter().map(|error| named_error(error, draft, &self.shape));
        let notes = self.file.notes.iter().cloned().chain(bare).collect();
        let outcome = match entry.solve(&record, &Stop::new()) {
            Ok(solution) => {
                let mut solution = solution.in_units_of(self.file.units, draft, &self.shape);
                show_answers_in(&mut solution, &self.file.show)
                    .map_err(|why| vec![RequestError::of(&why, None, locale)])?;
                Ok(solution)
            }
            Err(SolveError::Fields(errors)) => return Err(self.errors(&errors, locale)),
            Err(SolveError::Refused(Refusal::NoAnswer(why))) => Err(why),
            Err(error @ SolveError::Refused(Refusal::Stopped)) => Err(Text::verbatim(error)),
        };
        Ok(SolvedProblem { problem: self, record, notes, outcome })
    }
}

impl SolvedProblem<'_> {
    /// The same, for a report.
    pub(crate) fn worked(&self) -> WorkedProblem<'_> {
        const NONE: &Text = &Text { template: std::borrow::Cow::Borrowed(""), args: Vec::new() };
        WorkedProblem {
            entry: self.problem.file.entry,
            case: &self.problem.title,
            source: NONE,
            statement: &self.problem.file.statement.text,
            note: NONE,
            notes: &self.notes,
            draft: &self.problem.file.draft,
            record: &self.record,
            outcome: self.outcome.as_ref(),
        }
    }
}
