//! `cargo xtask verify`.
use std::path::Path;
use anyhow::Result;
/// How much.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Extent { /// All.
Everything, /// Quick.
Quick }
/// Verifies.
pub fn run(_: &Path, _: Extent) -> Result<()> { Ok(()) }
