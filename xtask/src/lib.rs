//! The automation of this repository, one file a command. It links no part of the program: what it must know of
//! the program it asks the built binary.

use std::path::{Path, PathBuf};

pub mod bench;
pub mod cluster;
pub mod contact_sheet;
pub mod dialects;
pub mod dist;
pub mod docs;
pub mod errors;
pub mod find;
pub mod first_entry;
pub mod fuzz;
pub mod handbook;
pub mod new_analysis;
pub mod new_plugin;
pub mod papers;
pub mod parquet;
pub mod pictures;
pub mod python;
pub mod soak;
pub mod teaching;
pub mod tidy;
pub mod trust;
pub mod verify;
pub mod words;

mod cargo;
mod names;
mod server;

/// The root of the repository.
pub fn root() -> PathBuf {
    // Of this run: clones that share a target folder share the built program too.
    let manifest =
        std::env::var_os("CARGO_MANIFEST_DIR").unwrap_or_else(|| env!("CARGO_MANIFEST_DIR").into());
    Path::new(&manifest).parent().expect("xtask/ stands in the root of the repository").to_owned()
}
