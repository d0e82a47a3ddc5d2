//! Tables of numbers from the files of other programs.

use std::path::{Path, PathBuf};

use dalembert_core::{Field, Text, uff};
use dalembert_import::{SheetPart, Workbook};

use super::{FileError, read_bytes};

/// Endings of the files whose text is a table.
const ENDINGS: [&str; 4] = ["csv", "tsv", "uff", "unv"];

/// Reads the text of a table from a file.
///
/// | file | what is read | `#` behind its name |
/// |---|---|---|
/// | universal file, dataset 58, in text or binary | the first function that fits the columns | `#2`: the second function |
/// | `.xlsx`, `.ods` | the first sheet that is not empty | `#Data!A:C`: a sheet, columns or cells of it |
/// | any other | its text, in UTF-8, UTF-16 or Windows-1252 | `#1,3`: these columns, in this order |
pub fn read_table(path: &Path, columns: &'static [Field]) -> Result<String, FileError> {
    let (path, part) = parted(path);
    let bytes = read_bytes(&path).map_err(|error| match error {
        FileError::TooLarge(path) => FileError::TooLargeForTable(path),
        error => error,
    })?;
    text(&path, bytes, part.as_deref(), columns).map_err(|why| FileError::NoTable { path, why })
}

fn text(path: &Path, bytes: Vec<u8>, part: Option<&str>, columns: &'static [Field]) -> Result<String, Text> {
    if bytes.iter().all(u8::is_ascii_whitespace) {
        return Err("the file is empty".into());
    }
    if let Some(kind) = path.extension().and_then(|ending| Workbook::of_extension(ending.to_str()?)) {
        let part = part.map_or_else(|| Ok(SheetPart::default()), SheetPart::read)?;
        return dalembert_import::spreadsheet(bytes, kind, &part);
    }
    if uff::is_universal(&bytes) {
        let which = part.map(number).transpose()?;
        return uff::table(&bytes, columns, which).map_err(|err| err.0);
    }
    let text = dalembert_import::text(&bytes)?;
    match part {
        Some(part) => {
            let chosen: Vec<usize> = part.split(',').map(number).collect::<Result<_, _>>()?;
            dalembert_import::chosen(&text, &chosen)
        }
        None => Ok(text),
    }
}

/// A number behind `#`, counted from 1.
fn number(text: &str) -> Result<usize, Text> {
    let number = text.trim().parse().ok().filter(|number| *number > 0);
    number.ok_or_else(|| {
        Text::new("`#{part}`: write a number from 1 on, as in `#2` or `#1,3`").with("part", text)
    })
}

/// Returns true if a file has the extension of measured data.
pub fn holds_data(path: &Path) -> bool {
    let ending = path.extension().and_then(|ending| ending.to_str()).unwrap_or_default();
    ENDINGS.iter().any(|known| ending.eq_ignore_ascii_case(known)) || Workbook::of_extension(ending).is_some()
}

/// A path with what stands behind its `#`; a file whose name ends so is itself.
fn parted(path: &Path) -> (PathBuf, Option<String>) {
    match path.to_str().filter(|_| !path.exists()).and_then(|text| text.rsplit_once('#')) {
        Some((name, part)) => (PathBuf::from(name), Some(part.to_owned())),
        None => (path.to_owned(), None),
    }
}
