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
        ["nets", "--times", times] => nets(root, times),
        ["rotors"] => ignored(root, "vibration", "two_thousand_random_rotors"),
        ["chains"] => ignored(root, "virtual-work", "chains_of_up_to_a_hundred_four_bars"),
        _ => bail!(
            "write `mutants`, `perturb --draws N`, `nets --times N`, `rotors` or `chains` behind `cargo xtask soak`"
        ),
    }
}

/// Runs a test of a family that takes too long for every day, optimised.
fn ignored(root: &Path, family: &str, test: &str) -> Result<()> {
    let folder = root.join("plugins").join(family);
    run_command(cargo(&folder).args(["test", "--release", test, "--", "--ignored", "--nocapture"]))
}

/// The nets over the registry that take samples, with so many times as many, optimised. (Coverage is exhaustive every day.)
fn nets(root: &Path, times: &str) -> Result<()> {
    run_command(
        cargo(root)
            .args(["test", "--release", "--package", "dalembert-tests", "--test", "registry"])
            .args(["--", "--nocapture", "path_independence::", "invariance::"])
            .env("DALEMBERT_TIMES", times),
    )
}
