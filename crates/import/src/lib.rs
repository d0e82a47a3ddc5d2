//! The text of a table of numbers from the files of other programs.
//!
//! A table is read from text (`dalembert_core` knows separators, decimal marks and headings with units). [`text`] decodes
//! the bytes of such a file, in whatever encoding it was written; [`chosen`] takes some of its columns; [`spreadsheet`] writes a sheet of a workbook as text,
//! one line a row, so that a message about line 7 is one about row 7.

dalembert_core::messages!("../locales/pt-BR.ftl");

mod columns;
mod encoding;
#[cfg(feature = "spreadsheets")]
mod spreadsheet;
mod workbook;

pub use columns::chosen;
pub use encoding::text;
#[cfg(feature = "spreadsheets")]
pub use spreadsheet::spreadsheet;
pub use workbook::{SheetPart, Workbook};

/// A sheet of a workbook as text.
#[cfg(not(feature = "spreadsheets"))]
pub fn spreadsheet(
    _bytes: Vec<u8>,
    _kind: Workbook,
    _part: &SheetPart,
) -> Result<String, dalembert_core::Text> {
    Err("this build reads no spreadsheets: build it with `--features spreadsheets`, or save the sheet as CSV"
        .into())
}
