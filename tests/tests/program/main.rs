//! The program as it is run: the command line, and the workbench in a pseudo-terminal.

mod cli;
mod dialects;
mod faults;
mod field;
mod fuzz;
mod import;
mod json;
mod notes;
mod optimise;
#[cfg(feature = "parquet")]
mod parquet;
mod pixels;
mod plugins;
mod ranges;
mod reliability;
mod replay;
mod sensitivity;
mod study;
mod study_plans;
mod teaching;
mod web;
mod workbench;
mod workflows;

use std::process::{Command, Stdio};

use dalembert_tests::pty;

/// The program without a terminal, in English and with no settings but those of the test.
fn program() -> Command {
    let mut command = Command::new(pty::program());
    command
        .stdin(Stdio::null())
        .env_remove("LC_ALL")
        .env_remove("LC_MESSAGES")
        .env("XDG_CONFIG_HOME", env!("CARGO_TARGET_TMPDIR"))
        .env("LANG", "C.UTF-8");
    command
}
