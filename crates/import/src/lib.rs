//! The text of a table of numbers from the files of other programs.
//!
//! A table is read from text (`dalembert_core` knows separators, decimal marks and headings with units). [`table`] makes
//! such a text of the bytes of a file, by its [`Format`] and what stands behind the `#` of its name. A line of a text and a
//! row of a spreadsheet keep their numbers, so that a message about line 7 is one about row 7.

dalembert_core::messages!("../locales/pt-BR.ftl");

mod encoding;
mod format;
mod instruments;
mod lines;
#[cfg(feature = "matlab")]
mod mat;
#[cfg(any(feature = "matlab", feature = "wav", feature = "parquet"))]
mod numbers;
#[cfg(feature = "parquet")]
mod parquet;
mod part;
#[cfg(feature = "spreadsheets")]
mod spreadsheet;
mod units_above;
#[cfg(feature = "wav")]
mod wav;
mod workbook;

use std::path::Path;

use dalembert_core::{Field, Text, uff};

pub use crate::format::{Format, holds_data};
#[cfg(feature = "parquet")]
pub use crate::parquet::parquet_columns;
use crate::{part::Part, workbook::SheetPart};

/// The text of a table with these columns from a file of this name and these bytes.
///
/// | file | what is read | `part`, behind `#` |
/// |---|---|---|
/// | text, in UTF-8, UTF-16 or Windows-1252 | the rows below its heading | `1,3`: these columns in this order; `skip=12` |
/// | `.xlsx`, `.ods` | the first sheet that has numbers | `Data!A:C`: a sheet, columns or cells of it |
/// | universal file, dataset 58, in text or binary | the function that fits the columns | `2`, or its name |
/// | WAV | times, and the channel | `2`: this channel |
/// | MAT-file of version 5 | the matrix that fits the columns | `signal`, `signal!1,3`, `t,x` |
/// | Parquet | its columns of numbers | `1,3`, or their names |
///
/// # Errors
/// What cannot be read, with the repair. No error has more of the content than the names to choose from, or the cell that
/// is wrong.
pub fn table(
    path: &Path,
    bytes: Vec<u8>,
    part: Option<&str>,
    columns: &'static [Field],
) -> Result<String, Text> {
    if bytes.iter().all(u8::is_ascii_whitespace) {
        return Err("the file is empty".into());
    }
    let part = part.map_or_else(|| Ok(Part::default()), Part::read)?;
    match Format::of(path, &bytes)? {
        Format::Universal => {
            let part = part.without_skip()?;
            let which = Some(part.choice.as_str()).filter(|choice| !choice.is_empty());
            uff::table(&bytes, columns, which).map_err(|err| err.0)
        }
        Format::Workbook(kind) => {
            let Part { skip, choice } = part;
            let sheet = if choice.is_empty() { SheetPart::default() } else { SheetPart::read(&choice)? };
            let text = spreadsheet(bytes, kind, &sheet)?;
            lines::table(&lines::without_first(&text, skip)?, &[], columns)
        }
        Format::Wave => wave(&bytes, &part.without_skip()?, columns.len()),
        Format::Matlab => matlab(&bytes, &part.without_skip()?, columns.len()),
        Format::Parquet => parquet_table(bytes, &part.without_skip()?, columns.len()),
        Format::Text => {
            let text = lines::without_first(&encoding::text(&bytes)?, part.skip)?;
            let text = instruments::with_times(&text)?.unwrap_or(text);
            lines::table(&text, &part.numbers()?, columns)
        }
    }
}

#[cfg(feature = "spreadsheets")]
use spreadsheet::spreadsheet;
#[cfg(not(feature = "spreadsheets"))]
fn spreadsheet(_bytes: Vec<u8>, _kind: workbook::Workbook, _part: &SheetPart) -> Result<String, Text> {
    Err("this build reads no spreadsheets: build it with `--features spreadsheets`, or save the sheet as CSV"
        .into())
}

#[cfg(feature = "wav")]
use wav::table as wave;
#[cfg(not(feature = "wav"))]
fn wave(_bytes: &[u8], _part: &Part, _wanted: usize) -> Result<String, Text> {
    Err("this build reads no WAV files: build it with `--features wav`, or save the samples as CSV".into())
}

#[cfg(feature = "matlab")]
use mat::table as matlab;
#[cfg(not(feature = "matlab"))]
fn matlab(_bytes: &[u8], _part: &Part, _wanted: usize) -> Result<String, Text> {
    Err("this build reads no MAT-files: build it with `--features matlab`, or save the variables as CSV"
        .into())
}

#[cfg(feature = "parquet")]
use parquet::table as parquet_table;
#[cfg(not(feature = "parquet"))]
fn parquet_table(_bytes: Vec<u8>, _part: &Part, _wanted: usize) -> Result<String, Text> {
    Err(WITHOUT_PARQUET.into())
}

/// Reason for which a program built without Parquet takes no Parquet file.
pub const WITHOUT_PARQUET: &str = "this program is built without Parquet; take a CSV file, or build it with `cargo build --release --features parquet`";

#[cfg(test)]
mod tests;
