//! Letters of drawings: of rows, and of several inputs at one feature.

use dalembert_core::{Symbol, Text, printer};

/// A letter with the number of its row, as the working writes it: `m₁`.
pub(crate) fn letter_of_row(letter: &'static str, row: usize) -> String {
    printer::symbol(&Symbol::from(letter).row(row))
}

/// Letters of one row, after one another.
pub(crate) fn of_row(of: &[&'static str], row: usize) -> Text {
    Text::verbatim(of.iter().map(|letter| letter_of_row(letter, row)).collect::<Vec<_>>().join(", "))
}

/// Letters after one another; those that are empty are left out.
pub(crate) fn joined(of: &[&str]) -> Text {
    Text::verbatim(of.iter().filter(|one| !one.is_empty()).copied().collect::<Vec<_>>().join(", "))
}
