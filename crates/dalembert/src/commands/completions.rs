//! `dalembert completions`

use std::process::ExitCode;

use crate::{
    arguments::{self, Completions},
    console::{Console, print},
    failure::Failure,
};

/// Prints the completion script of a shell.
pub(crate) fn run(completions: &Completions, console: &Console) -> Result<ExitCode, Failure> {
    let mut script = Vec::new();
    let mut command = arguments::command(console.locale.language);
    clap_complete::generate(completions.shell, &mut command, "dalembert", &mut script);
    print(&String::from_utf8_lossy(&script))?;
    Ok(ExitCode::SUCCESS)
}
