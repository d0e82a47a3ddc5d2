//! The automation of this repository, one file a command. It links no part of the program: what it must know of
//! the program it asks the built binary.

use std::path::{Path, PathBuf};

pub mod bench;
pub mod docs;
pub mod new_analysis;
pub mod new_plugin;
pub mod pictures;
pub mod tidy;
pub mod verify;

mod cargo;
mod names;

/// The root of the repository.
pub fn root() -> PathBuf {
    let manifest = Path::new(env!("CARGO_MANIFEST_DIR"));
    manifest.parent().expect("xtask/ stands in the root of the repository").to_owned()
}
