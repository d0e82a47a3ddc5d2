//! `dalembert` and `dalembert FILE`: the workbench, or a worked solution where there is no terminal.

use std::process::ExitCode;

use crate::{commands::solve::print_worked, console::Console, failure::Failure, problem};

/// The problem that stands for all where nobody can pick one.
const FIRST: &str = "vibration/rotating-unbalance";

/// Opens the workbench.
pub(crate) fn run(named: Option<&str>, readonly: bool, console: &Console) -> Result<ExitCode, Failure> {
    let _ = readonly;
    print_worked(&problem::read(named.unwrap_or(FIRST), None, &[], console)?, console)
}
