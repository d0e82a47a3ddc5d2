//! `cargo xtask soak perturb`: the perturbation net with many more draws, in an optimised build.

use std::{fs, path::Path};

use anyhow::{Context, Result};

use crate::cargo::{cargo, run as run_command, target};

/// Draws every case of every analysis so many times with its numbers changed at random, and prints what was met.
///
/// # Errors
/// A number of draws that cannot be read; a draw that the test faults.
pub(super) fn soak(root: &Path, draws: &str) -> Result<()> {
    let draws: u64 = draws.parse().with_context(|| format!("`{draws}` is not a number of draws"))?;
    let report = target(root).join("perturbation.txt");
    let test = ["test", "--release", "--package", "dalembert-tests", "--test", "registry"];
    let outcome = run_command(
        cargo(root)
            .args(test)
            .args(["--", "perturbation::"])
            .env("DALEMBERT_DRAWS", draws.to_string())
            .env("DALEMBERT_REPORT", &report),
    );
    if let Ok(text) = fs::read_to_string(&report) {
        print!("{text}");
    }
    outcome
}
