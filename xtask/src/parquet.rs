//! `cargo xtask parquet`: the program built with its feature `parquet`, which `verify` leaves out.

use std::path::Path;

use anyhow::Result;

use crate::cargo::{cargo, run as run_command};

/// Lints what the feature adds, and tests tables that are written and read back.
pub fn run(root: &Path) -> Result<()> {
    let packages = ["--package", "dalembert-study", "--package", "dalembert", "--package", "dalembert-tests"];
    let clippy = ["clippy", "--all-targets", "--locked", "--features", "parquet"];
    run_command(cargo(root).args(clippy).args(packages).args(["--", "-D", "warnings"]))?;
    let test = ["test", "--locked", "--package", "dalembert-tests", "--features", "parquet"];
    run_command(cargo(root).args(test).args(["--test", "program", "--", "parquet::", "dialects::"]))
}
