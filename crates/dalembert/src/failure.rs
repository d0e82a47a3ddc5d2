//! Failures of the program and their exit codes.

use std::io;

use dalembert_core::{Locale, Text};
use dalembert_report::{RequestError, errors_json};
use dalembert_tui::files::FileError;
use serde_json::Value as Json;

/// Errors of a file.
#[derive(Clone, Debug)]
pub(crate) struct FileErrors {
    /// The errors as they are shown, with their lines.
    pub(crate) shown: String,
    /// Each error, and the number of its line.
    pub(crate) places: Vec<(Text, Option<usize>)>,
}

/// Failure of a command.
#[derive(Debug, thiserror::Error)]
pub(crate) enum Failure {
    /// The input or the usage is wrong: everything that is.
    #[error("{}", .0.iter().map(Text::english).collect::<Vec<_>>().join("; "))]
    Input(Vec<Text>),
    /// The problem file is wrong, as it is shown with its lines.
    #[error("{}", .0.shown)]
    InFile(FileErrors),
    /// A file cannot be read or written.
    #[error(transparent)]
    File(#[from] FileError),
    /// The problem is well written but has no answer.
    #[error("{}", .0.english())]
    Refused(Text),
    /// A session does not lead where it should.
    #[error("{}", .0.english())]
    Unmet(Text),
    /// An analysis panicked.
    #[error("{0}")]
    Fault(String),
    /// Output error: a result could not be printed.
    #[error(transparent)]
    Output(io::Error),
}

impl Failure {
    /// The input or the usage is wrong in one way.
    pub(crate) fn input(why: impl Into<Text>) -> Self {
        Failure::Input(vec![why.into()])
    }

    /// Every error for another program: the sentence, the path of the input it is about, the name to write instead, and the
    /// line of the file, where there are any.
    pub(crate) fn errors(&self, locale: &Locale) -> Vec<RequestError> {
        let one = |text: &Text| RequestError::of(text, None, locale);
        match self {
            Failure::Input(all) => all.iter().map(one).collect(),
            Failure::InFile(errors) => {
                errors.places.iter().map(|(text, line)| RequestError::of(text, *line, locale)).collect()
            }
            Failure::File(error) => vec![one(&error.text())],
            Failure::Refused(why) => vec![one(&Text::new("no answer: {why}").with_text("why", why.clone()))],
            Failure::Unmet(why) => vec![one(why)],
            Failure::Fault(what) => {
                vec![one(&Text::new("internal error, not caused by your input: {what}").with("what", what))]
            }
            Failure::Output(error) => vec![one(&Text::verbatim(error))],
        }
    }

    /// The same as JSON.
    pub(crate) fn json(&self, locale: &Locale) -> Json {
        errors_json(&self.errors(locale))
    }
}
