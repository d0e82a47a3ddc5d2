//! Tables of numbers among the inputs: their columns, their first rows, and the file that they were read from.

use dalembert_core::{Field, Locale, NumberTable, Shape, Text};
use dalembert_units as units;

use crate::{DocumentTable, ReportedInput, WorkedProblem};

/// The longest table of inputs that is printed in full.
const LONGEST: usize = 60;
/// Rows that are printed of a longer one.
const FIRST_ROWS: usize = 5;
/// Begin of the comment that names the file of a table, behind its rows.
const FILE: &str = "# file: ";

/// The text of a table with the name of the file that it was read from, as a comment behind its rows, where it is no
/// heading and moves no line.
pub fn with_file(text: &str, name: &str) -> String {
    let name: String = name.chars().map(|c| if c.is_control() { ' ' } else { c }).collect();
    format!("{}\n{FILE}{name}", text.trim_end())
}

/// The name of the file that the text of a table was read from, as [`with_file`] has written it.
pub fn file_of(text: &str) -> Option<&str> {
    text.lines().next_back()?.trim().strip_prefix(FILE)
}

/// The rows of a table of inputs, with labels and units of its columns; of a long one the first rows.
pub(crate) fn document_table(
    input: &ReportedInput<'_>,
    table: &NumberTable,
    worked: &WorkedProblem<'_>,
    locale: &Locale,
) -> DocumentTable {
    let fields: &[Field] = match worked.draft.at(&worked.entry.shape(), &input.path) {
        Ok((_, shape)) => match shape.present() {
            Shape::Table(fields) => fields(),
            _ => &[],
        },
        Err(_) => &[],
    };
    let heading = |(n, unit): (usize, &units::Unit)| {
        let label = fields.get(n).map_or_else(String::new, |field| field.title().render(locale));
        let unit = match unit.pretty() {
            none if none.is_empty() => none,
            unit => format!("[{unit}]"),
        };
        format!("{label} {unit}").trim().to_owned()
    };
    let count = table.rows().len();
    let (title, most) = if count <= LONGEST {
        (input.label.clone(), count)
    } else {
        let text = Text::new("{table}, the first {rows} of {count} rows").with("table", &input.label);
        (text.with("rows", FIRST_ROWS).with("count", count).render(locale), FIRST_ROWS)
    };
    let cell = |(si, unit): (&f64, &units::Unit)| units::write_number(unit.value(*si), locale.style);
    let rows = table.rows().take(most).map(|row| row.iter().zip(&table.units).map(cell).collect());
    DocumentTable {
        title,
        columns: table.units.iter().enumerate().map(heading).collect(),
        numeric: vec![true; table.units.len()],
        rows: rows.collect(),
        foot: Vec::new(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_table_keeps_the_name_of_its_file() {
        assert_eq!(file_of(&with_file("0; 1\n1; 2\n", "run.csv")), Some("run.csv"));
        assert_eq!(file_of("0; 1\n# file: old.csv\n1; 2"), None);
        assert_eq!(file_of(""), None);
    }
}
