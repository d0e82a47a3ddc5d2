//! Tables of numbers from the files of other programs.

use std::path::{Path, PathBuf};

use dalembert_core::Field;
use dalembert_import::Sample;

use super::{FileError, read_bytes};

/// Lines of a sample.
const SAMPLED: usize = 6;

/// Reads the text of a table from a file, or from the part of it that stands behind `#`; see [`dalembert_import::table`].
pub fn read_table(path: &Path, columns: &'static [Field]) -> Result<String, FileError> {
    let (path, part) = parted(path);
    let bytes = bytes_of(&path)?;
    dalembert_import::table(&path, bytes, part.as_deref(), columns)
        .map_err(|why| FileError::NoTable { path, why })
}

/// The same, with the first columns and rows of a file that cannot be read as the table.
pub fn preview_table(path: &Path, columns: &'static [Field]) -> (Result<String, FileError>, Sample) {
    let (path, part) = parted(path);
    let bytes = match bytes_of(&path) {
        Ok(bytes) => bytes,
        Err(error) => return (Err(error), Sample::default()),
    };
    let sample = Sample::of(&path, &bytes, part.as_deref(), SAMPLED);
    let read = dalembert_import::table(&path, bytes, part.as_deref(), columns);
    (read.map_err(|why| FileError::NoTable { path, why }), sample)
}

fn bytes_of(path: &Path) -> Result<Vec<u8>, FileError> {
    read_bytes(path).map_err(|error| match error {
        FileError::TooLarge(path) => FileError::TooLargeForTable(path),
        error => error,
    })
}

/// A path with what stands behind its `#`; a file whose name ends so is itself.
fn parted(path: &Path) -> (PathBuf, Option<String>) {
    match path.to_str().filter(|_| !path.exists()).and_then(|text| text.rsplit_once('#')) {
        Some((name, part)) => (PathBuf::from(name), Some(part.to_owned())),
        None => (path.to_owned(), None),
    }
}
