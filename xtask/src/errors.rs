//! `cargo xtask errors`: the table of the corpus of student errors.

use std::path::Path;

use anyhow::Result;

use crate::cargo::{cargo, run};

/// Runs the corpus in a release build and prints its table; `words` are numbers of digits, and `--log` for every miss.
///
/// # Errors
/// What cargo says.
pub fn run_corpus(root: &Path, words: &[&str]) -> Result<()> {
    let build = ["run", "--quiet", "--release", "-p", "dalembert-tests", "--bin", "errors", "--"];
    run(cargo(root).args(build).args(words))
}
