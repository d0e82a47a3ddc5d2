//! `dalembert completions`

use std::process::ExitCode;

use clap_complete::env::Shells;

use crate::{arguments::Completions, completion::VARIABLE, console::print, failure::Failure};

/// Prints the script by which a shell asks the program for completions.
pub(crate) fn run(completions: &Completions) -> Result<ExitCode, Failure> {
    let name = completions.shell.to_string();
    let shells = Shells::builtins();
    let shell =
        shells.completer(&name).ok_or_else(|| Failure::Fault(format!("no completions for {name}")))?;
    let mut script = Vec::new();
    shell
        .write_registration(VARIABLE, "dalembert", "dalembert", "dalembert", &mut script)
        .map_err(Failure::Output)?;
    print(&String::from_utf8_lossy(&script))?;
    Ok(ExitCode::SUCCESS)
}
