//! Formats of files, by their first bytes and their names.

use std::path::Path;

use dalembert_core::{Text, uff};

use crate::workbook::Workbook;

/// Extensions of files of numbers.
const EXTENSIONS: [&str; 8] = ["csv", "tsv", "uff", "unv", "wav", "mat", "parquet", "lvm"];
/// Place and text of the mark of a MAT-file: version 5, in one of two orders of bytes.
const MATLAB_MARK: (usize, [&[u8]; 2]) = (124, [&[0, 1, b'I', b'M'], &[1, 0, b'M', b'I']]);

/// Format of a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// Lines of text.
    Text,
    /// Universal file.
    Universal,
    /// Spreadsheet.
    Workbook(Workbook),
    /// Recording.
    Wave,
    /// MAT-file of version 5.
    Matlab,
    /// Apache Parquet.
    Parquet,
}

impl Format {
    /// Format of a file of this name and these bytes.
    ///
    /// # Errors
    /// A known format that is not read, with the program or setting that makes one of it that is.
    pub fn of(path: &Path, bytes: &[u8]) -> Result<Self, Text> {
        let extension = path.extension().and_then(|extension| extension.to_str()).unwrap_or_default();
        let is = |known: &str| extension.eq_ignore_ascii_case(known);
        let has_mark = |at: usize, mark: &[u8]| bytes.get(at..).is_some_and(|rest| rest.starts_with(mark));
        if let Some(kind) = Workbook::of_extension(extension) {
            return Ok(Self::Workbook(kind));
        }
        if has_mark(0, b"\x89HDF\r\n\x1A\n") || has_mark(512, b"\x89HDF\r\n\x1A\n") {
            return Err(
                "this is an HDF5 file, also what MATLAB writes as version 7.3: save it by `save('file.mat', '-v7')`, or as CSV"
                    .into(),
            );
        }
        let (at, marks) = MATLAB_MARK;
        match () {
            () if uff::is_universal(bytes) => Ok(Self::Universal),
            () if marks.iter().any(|mark| has_mark(at, mark)) => Ok(Self::Matlab),
            () if has_mark(0, b"RIFF") && has_mark(8, b"WAVE") => Ok(Self::Wave),
            () if has_mark(0, b"PAR1") || is("parquet") => Ok(Self::Parquet),
            () if is("mat") => {
                Err("this is no MAT-file of version 5: save it by `save('file.mat', '-v7')`, or as CSV"
                    .into())
            }
            () if is("wav") => Err("this is no WAV file of PCM: save the recording as one, or as CSV".into()),
            () if has_mark(0, b"\xD0\xCF\x11\xE0") => {
                Err("this is a workbook of the old format, or another one in its container: save it as .xlsx"
                    .into())
            }
            () if has_mark(0, b"\x1F\x8B") => Err("this file is compressed by gzip: unpack it first".into()),
            () if has_mark(0, b"PK\x03\x04") => {
                Err("this is an archive: unpack it first; a workbook is read by its name, .xlsx or .ods"
                    .into())
            }
            () => Ok(Self::Text),
        }
    }
}

/// Returns true if a file has the extension of a file of numbers.
pub fn holds_data(path: &Path) -> bool {
    let extension = path.extension().and_then(|extension| extension.to_str()).unwrap_or_default();
    EXTENSIONS.iter().any(|known| extension.eq_ignore_ascii_case(known))
        || Workbook::of_extension(extension).is_some()
}
