//! Columns of numbers as the text of a table.

use dalembert_core::{Text, study::DataColumn};

use crate::instruments::written;

/// The text of a table: a line with the headings of the columns, then the rows, all digits of each number.
///
/// Errors: columns of different lengths; a number that is not finite.
pub(crate) fn text(columns: &[DataColumn]) -> Result<String, Text> {
    let rows = columns.first().map_or(0, |column| column.numbers.len());
    if let Some(other) = columns.iter().find(|column| column.numbers.len() != rows) {
        let why =
            Text::new("`{first}` has {have} values and `{other}` {others}: choose some of the same length");
        return Err(why
            .with("first", columns[0].heading())
            .with("have", rows)
            .with("other", other.heading())
            .with("others", other.numbers.len()));
    }
    for column in columns {
        if let Some(at) = column.numbers.iter().position(|number| !number.is_finite()) {
            let why = Text::new(
                "value {row} of `{column}` is missing or infinite: leave such rows out of the file",
            );
            return Err(why.with("row", at + 1).with("column", column.heading()));
        }
    }
    let names: Vec<String> = columns.iter().map(|column| name(&column.heading())).collect();
    let mut text = names.join("\t") + "\n";
    for row in 0..rows {
        for (n, column) in columns.iter().enumerate() {
            if n > 0 {
                text.push('\t');
            }
            text += &written(column.numbers[row]);
        }
        text.push('\n');
    }
    Ok(text)
}

/// A name that is read as words: `pi` alone would be a number.
fn name(name: &str) -> String {
    let name = name.replace(['\t', '\n', '\r', '"', ';'], " ");
    let is_number = ["pi", "π", "inf", "nan", "infinity"].iter().any(|word| name.eq_ignore_ascii_case(word));
    if is_number || !name.starts_with(char::is_alphabetic) { format!("column {name}") } else { name }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn column(heading: &str, numbers: &[f64]) -> DataColumn {
        DataColumn { numbers: numbers.to_vec(), ..DataColumn::headed(heading) }
    }

    #[test]
    fn rows_stand_below_the_names() {
        let columns = [column("t [s]", &[0.0, 1e-9]), column("pi", &[0.1, -2.5e8])];
        assert_eq!(text(&columns), Ok("t [s]\tcolumn pi\n0\t0.1\n1e-9\t-2.5e8\n".to_owned()));
    }

    #[test]
    fn rows_that_are_not_whole_are_refused() {
        assert!(text(&[column("t", &[0.0, 1.0]), column("x", &[0.0])]).is_err());
        assert!(text(&[column("t", &[0.0, f64::NAN])]).is_err());
    }
}
