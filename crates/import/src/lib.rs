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
            let last = workbook::name_of_column(columns.len().saturating_sub(1) as u32);
            lines::table(&lines::without_first(&text, skip)?, &[], columns, &format!("A:{last}"))
        }
        Format::Wave => wave(&bytes, &part.without_skip()?, columns.len()),
        Format::Matlab => matlab(&bytes, &part.without_skip()?, columns.len()),
        Format::Parquet => parquet_table(bytes, &part.without_skip()?, columns.len()),
        Format::Text => {
            let text = lines::without_first(&encoding::text(&bytes)?, part.skip)?;
            let text = instruments::with_times(&text)?.unwrap_or(text);
            let first: Vec<String> = (1..=columns.len()).map(|column| column.to_string()).collect();
            lines::table(&text, &part.numbers()?, columns, &first.join(","))
        }
    }
}

/// The first columns and rows of a file, so that some can be chosen.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Sample {
    /// Names of the columns as they are written behind `#`: `1`, `2`, … or `A`, `B`, ….
    pub columns: Vec<String>,
    /// Cells of the heading and of the first rows.
    pub rows: Vec<Vec<String>>,
}

/// Columns of a sample.
const WIDEST_SAMPLE: usize = 8;

impl Sample {
    /// So many lines of a file of this name and these bytes; empty where it has no columns of text to choose from.
    pub fn of(path: &Path, bytes: &[u8], part: Option<&str>, count: usize) -> Self {
        let Ok(part) = part.map_or_else(|| Ok(Part::default()), Part::read) else { return Self::default() };
        let skipped = |text: &str| lines::without_first(text, part.skip).unwrap_or_default();
        let (rows, is_workbook) = match Format::of(path, bytes) {
            Ok(Format::Text) => {
                let text = skipped(&encoding::text(bytes).unwrap_or_default());
                let text = instruments::with_times(&text).ok().flatten().unwrap_or(text);
                (lines::beginning(&text, count), false)
            }
            Ok(Format::Workbook(kind)) => {
                let mut sheet = SheetPart::read(&part.choice).unwrap_or_default();
                sheet.columns = vec![0..=WIDEST_SAMPLE as u32 - 1];
                let text = spreadsheet(bytes.to_vec(), kind, &sheet).unwrap_or_default();
                (lines::beginning(&skipped(&text), count), true)
            }
            _ => (Vec::new(), false),
        };
        let width = rows.iter().map(Vec::len).max().unwrap_or(0).min(WIDEST_SAMPLE);
        let name =
            |n: usize| if is_workbook { workbook::name_of_column(n as u32) } else { (n + 1).to_string() };
        let rows = rows.into_iter().map(|cells| cells.into_iter().take(width).collect()).collect();
        Self { columns: (0..width).map(name).collect(), rows }
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
