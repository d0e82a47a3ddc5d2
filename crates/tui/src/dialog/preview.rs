//! A file of a table, as it is understood before it takes the place of what is there.

use dalembert_core::{Field, Text, table::TablePreview};
use dalembert_import::Sample;

/// Rows that are shown.
const ROWS: usize = 5;

/// Reading of a file of a table.
#[derive(Clone, Debug)]
pub struct ImportPreview {
    /// Text that was typed: `@`, the file, and the part behind `#`.
    pub typed: String,
    /// The field of the table.
    pub field: String,
    /// The text to take and how it is understood; `None` where it cannot be read.
    pub read: Option<(String, TablePreview)>,
    /// Columns of the file to choose from.
    pub sample: Sample,
}

impl ImportPreview {
    /// Preview of a text for a table with these columns.
    ///
    /// # Errors
    /// The fault for which no row of the text can be read.
    pub fn of(text: String, columns: &'static [Field]) -> Result<(String, TablePreview), Text> {
        let table = TablePreview::of(&text, columns, ROWS);
        match table.fault {
            Some(fault) if table.count == 0 => Err(fault),
            _ => Ok((text, table)),
        }
    }

    /// The field and the text to take, if this was typed.
    pub fn confirmed(self, typed: &str) -> Option<(String, String)> {
        let is_same = self.typed.trim_start_matches('@').trim() == typed.trim_start_matches('@').trim();
        self.read.filter(|_| is_same).map(|(text, _)| (self.field, text))
    }
}
