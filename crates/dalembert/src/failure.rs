//! Failures of the program and their exit codes.

use std::io;

use dalembert_core::Text;
use dalembert_tui::files::FileError;

/// Failure of a command.
#[derive(Debug, thiserror::Error)]
pub(crate) enum Failure {
    /// The input or the usage is wrong: everything that is.
    #[error("{}", .0.iter().map(Text::english).collect::<Vec<_>>().join("; "))]
    Input(Vec<Text>),
    /// The problem file is wrong, as it is shown with its lines.
    #[error("{0}")]
    InFile(String),
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
}
