//! `dalembert field`: a job of balancing in the field, step by step in a terminal.

use std::process::ExitCode;

use dalembert_tui::Options;

use super::workbench::{can_be_recorded, options};
use crate::{
    Set,
    arguments::{Arguments, Field},
    console::Console,
    failure::Failure,
};

/// Opens field mode on a job that is gone on with, or on a blank one.
pub(crate) fn run(
    arguments: &Field,
    all: &Arguments,
    set: Set,
    console: &Console,
) -> Result<ExitCode, Failure> {
    if !console.interactive {
        return Err(Failure::input("field mode needs a terminal; `dalembert solve FILE` prints a job"));
    }
    if let Some(path) = &arguments.record {
        can_be_recorded(path)?;
    }
    let exists = arguments.file.as_ref().is_some_and(|path| path.exists());
    let blank = arguments.file.clone().filter(|_| !exists);
    Ok(dalembert_tui::run(Options {
        file: arguments.file.clone().filter(|_| exists),
        field: Some(blank),
        record: arguments.record.clone(),
        ..options(all, set, console)
    }))
}
