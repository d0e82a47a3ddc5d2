//! Failures of the program and their exit codes.

use std::io;

use dalembert_core::{Arg, Locale, Text};
use dalembert_tui::files::FileError;
use serde_json::{Value as Json, json};

/// Version of the schema of errors: `{"format", "errors": [{"path", "message", "repair", "line"}]}`.
const ERRORS_FORMAT: u32 = 1;

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

/// `{"format", "errors"}`.
pub(crate) fn errors_json(errors: &[RequestError]) -> Json {
    json!({ "format": ERRORS_FORMAT, "errors": errors.iter().map(RequestError::json).collect::<Vec<_>>() })
}

/// Error of a request, for another program.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RequestError {
    /// Path of the input; empty where it is about none.
    pub path: String,
    /// The whole sentence, with value and repair.
    pub message: String,
    /// The name that was probably meant, where there is one.
    pub repair: Option<String>,
    /// Line of the problem file, counted from 1.
    pub line: Option<usize>,
}

impl RequestError {
    fn of(text: &Text, line: Option<usize>, locale: &Locale) -> Self {
        let argument = |name| argument(text, name).map(str::to_owned);
        Self {
            path: argument("path").unwrap_or_default(),
            message: text.render(locale),
            repair: argument("near"),
            line,
        }
    }

    fn json(&self) -> Json {
        let mut error = json!({ "path": self.path, "message": self.message });
        if let Some(repair) = &self.repair {
            error["repair"] = repair.as_str().into();
        }
        if let Some(line) = self.line {
            error["line"] = line.into();
        }
        error
    }
}

/// The argument of a sentence, or of one within it.
fn argument<'t>(text: &'t Text, wanted: &str) -> Option<&'t str> {
    let own = text.args.iter().find_map(|(name, value)| match value {
        Arg::Verbatim(value) if *name == wanted => Some(value.as_str()),
        _ => None,
    });
    own.or_else(|| {
        text.args.iter().find_map(|(_, value)| match value {
            Arg::Text(inner) => argument(inner, wanted),
            _ => None,
        })
    })
}
