//! `dalembert` and `dalembert FILE`: the workbench, or a worked solution where there is no terminal.

use std::{path::PathBuf, process::ExitCode};

use dalembert_core::{file, find};
use dalembert_tui::Options;

use crate::{commands::solve::print_worked, console::Console, failure::Failure, problem};

/// The problem that the workbench opens on, and that is printed where there is no terminal, when none is named.
const FIRST: &str = "vibration/rotating-unbalance";

/// Opens the workbench.
pub(crate) fn run(named: Option<&str>, readonly: bool, console: &Console) -> Result<ExitCode, Failure> {
    if !console.interactive {
        return print_worked(&problem::read(named.unwrap_or(FIRST), None, &[], console)?, console);
    }
    let analysis = find(named.unwrap_or(FIRST));
    let path = named.filter(|_| analysis.is_none()).map(PathBuf::from);
    if let Some(named) = named.filter(|named| problem::looks_like_an_id(named))
        && path.as_ref().is_some_and(|path| !path.exists())
    {
        return Err(Failure::input(file::no_such_analysis(named)));
    }
    Ok(dalembert_tui::run(Options {
        file: path,
        analysis,
        language: console.locale.language,
        ascii: console.locale.style.ascii,
        readonly,
    }))
}
