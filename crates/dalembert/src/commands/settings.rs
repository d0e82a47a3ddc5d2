//! `dalembert settings`

use std::process::ExitCode;

use dalembert_tui::settings::default_file;

use crate::{
    console::{Console, print},
    failure::Failure,
};

/// Prints a file of settings that says what can be set and sets nothing.
pub(crate) fn run(console: &Console) -> Result<ExitCode, Failure> {
    print(&console.plain(&default_file(&console.locale)))?;
    Ok(ExitCode::SUCCESS)
}
