//! Why the program ends without what was asked for, and the exit status that says so.

use std::{
    io::{self, Write},
    process::ExitCode,
};

use dalembert_core::Text;
use dalembert_tui::files::FileError;

use crate::console::Console;

/// Why there is nothing, or not what was asked for.
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
    /// What was found could not be printed.
    #[error(transparent)]
    Output(io::Error),
}

impl Failure {
    /// The input or the usage is wrong in one way.
    pub(crate) fn input(why: impl Into<Text>) -> Self {
        Failure::Input(vec![why.into()])
    }

    /// Says so on the error stream.
    pub(crate) fn report(&self, console: &Console) -> ExitCode {
        let say = |text: Text| console.plain(&text.render(&console.locale));
        let error = |why: String| say(Text::new("error: {why}").with("why", why));
        let (lines, status) = match self {
            Failure::Input(all) => {
                (all.iter().map(|why| error(why.render(&console.locale))).collect::<Vec<_>>().join("\n"), 2)
            }
            Failure::InFile(shown) => (shown.clone(), 2),
            Failure::File(err) => (error(err.text().render(&console.locale)), 2),
            Failure::Refused(why) => (say(Text::new("no answer: {why}").with_text("why", why.clone())), 1),
            Failure::Unmet(why) => (error(why.render(&console.locale)), 1),
            Failure::Fault(what) => (
                say(Text::new("this is a fault of the program, not of your input: {what}").with("what", what)),
                2,
            ),
            Failure::Output(err) => (error(err.to_string()), 2),
        };
        // Nobody is left to be told when the error stream itself is closed.
        let _ = writeln!(io::stderr(), "{lines}");
        ExitCode::from(status)
    }
}
