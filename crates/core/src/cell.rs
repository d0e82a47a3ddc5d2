//! Cells of tables that may be formulas, and the faults of the lines of a table.

use dalembert_units::Unit;

use crate::{FieldError, Text};

/// Most faults that are listed of one field.
pub(crate) const MOST_FAULTS: usize = 20;
/// Sentence behind them.
pub(crate) const MORE_FAULTS: &str = "there are more faults; these are the first";

/// Place of a cell in a table.
pub(crate) struct CellPlace {
    /// Row and column, counted from 0.
    pub(crate) row: usize,
    pub(crate) column: usize,
    /// Number of its line, from 1.
    pub(crate) line: usize,
    /// Unit of its column.
    pub(crate) unit: Unit,
}

/// A cell that is no number and may be a formula.
pub(crate) struct CellFormula {
    pub(crate) place: CellPlace,
    pub(crate) text: String,
    /// Reason for which it is no number.
    pub(crate) why: Text,
}

/// The words of a heading, one for each column.
pub(crate) struct HeadingWords {
    /// Number of its line, from 1.
    pub(crate) line: usize,
    pub(crate) cells: Vec<String>,
}

/// Adds an error of a field to others; of the same field, only the first ones are listed.
pub(crate) fn add_fault(errors: &mut Vec<FieldError>, error: FieldError) {
    match errors.iter().filter(|other| other.path == error.path).count() {
        0..MOST_FAULTS => errors.push(error),
        MOST_FAULTS => errors.push(FieldError::new(error.path, MORE_FAULTS)),
        _ => {}
    }
}

/// The reason of a line.
pub(crate) fn of_line(line: usize, why: Text) -> Text {
    Text::new("line {line}: {why}").with("line", line).with_text("why", why)
}
