//! `cargo xtask soak`: proofs that take longer than `verify`.

use std::path::Path;

use anyhow::{Result, bail};

mod mutants;
mod perturb;

/// Runs the proof of that name.
pub fn run(root: &Path, words: &[&str]) -> Result<()> {
    match words {
        ["mutants"] => mutants::soak(root),
        ["perturb", "--draws", draws] => perturb::soak(root, draws),
        _ => bail!(
            "`cargo xtask soak mutants` or `cargo xtask soak perturb --draws N`: there is no other soak"
        ),
    }
}
