//! `cargo xtask soak`: proofs that take longer than `verify`.

use std::path::Path;

use anyhow::{Result, bail};

use crate::cargo::{cargo, run as run_command};

mod mutants;
mod perturb;

/// Runs the proof of that name.
pub fn run(root: &Path, words: &[&str]) -> Result<()> {
    match words {
        ["mutants"] => mutants::soak(root),
        ["perturb", "--draws", draws] => perturb::soak(root, draws),
        ["rotors"] => ignored(root, "dalembert-vibration", "two_thousand_random_rotors"),
        ["chains"] => ignored(root, "dalembert-virtual-work", "chains_of_up_to_a_hundred_four_bars"),
        _ => bail!("write `mutants`, `perturb --draws N`, `rotors` or `chains` behind `cargo xtask soak`"),
    }
}

/// Runs a test that takes too long for every day, optimised.
fn ignored(root: &Path, package: &str, test: &str) -> Result<()> {
    run_command(cargo(root).args([
        "test",
        "--release",
        "--package",
        package,
        test,
        "--",
        "--ignored",
        "--nocapture",
    ]))
}
