//! Tables in Apache Parquet, where the program is built with the feature `parquet`.
//!
//! A Parquet file cannot be gone on with once it is broken off, so its rows are first written as CSV, sharded, resumed and
//! merged like any other table; what is whole is then converted.

#[cfg(feature = "parquet")]
mod columns;

use std::path::{Path, PathBuf};

use dalembert_core::Text;
#[cfg(not(feature = "parquet"))]
use dalembert_core::study::DataColumn;

#[cfg(feature = "parquet")]
pub use self::columns::{read, write};
#[cfg(not(feature = "parquet"))]
use crate::StudyError;
#[cfg(not(feature = "parquet"))]
use crate::output::Run;

/// Returns true if a file is Parquet by its name.
pub fn is_parquet(path: &Path) -> bool {
    path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("parquet"))
}

/// The CSV file of the rows of a Parquet table until they are converted: `table.parquet.csv`.
pub fn rows_of(table: &Path) -> PathBuf {
    let mut name = table.as_os_str().to_owned();
    name.push(".csv");
    PathBuf::from(name)
}

/// Checks that this program reads and writes Parquet.
///
/// # Errors
/// The command that builds one which does.
pub fn available() -> Result<(), Text> {
    if cfg!(feature = "parquet") {
        return Ok(());
    }
    Err(dalembert_import::WITHOUT_PARQUET.into())
}

/// The columns of numbers of a Parquet file.
///
/// # Errors
/// Always: this program is built without Parquet.
#[cfg(not(feature = "parquet"))]
pub fn read(_path: &Path) -> Result<Vec<DataColumn>, Text> {
    available().map(|()| Vec::new())
}

/// Converts a table that is whole.
///
/// # Errors
/// Always: this program is built without Parquet.
#[cfg(not(feature = "parquet"))]
pub fn write(_run: &Run<'_>, _table: &Path) -> Result<(), StudyError> {
    available().map_err(StudyError::Unfit)
}
