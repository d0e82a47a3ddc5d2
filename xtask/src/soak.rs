//! `cargo xtask soak`: proofs that take longer than `verify`.

use std::path::Path;

use anyhow::{Result, bail};

mod mutants;

/// Runs the proof of that name.
pub fn run(root: &Path, words: &[&str]) -> Result<()> {
    match words {
        ["mutants"] => mutants::soak(root),
        _ => bail!("`cargo xtask soak mutants`: there is no other soak"),
    }
}
