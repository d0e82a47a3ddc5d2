//! CSV files that a plan names: columns of numbers under headings.

use std::path::Path;

use dalembert_core::{Text, study::DataColumn};

use crate::parquet;

/// Reads the columns of a CSV file whose first line has headings, with the unit in brackets: `mass [kg],speed [rpm]`.
/// Lines that begin with `#` are skipped; columns are separated by commas, or by semicolons where the headings are. Of a
/// Parquet file, which its name says, the columns of numbers.
///
/// # Errors
/// Why the file cannot be read, with the line of a cell that is no number.
pub fn read(path: &Path) -> Result<Vec<DataColumn>, Text> {
    let read = if parquet::is_parquet(path) {
        parquet::read(path)
    } else {
        std::fs::read_to_string(path).map_err(Text::verbatim).and_then(|text| columns(&text))
    };
    read.map_err(|why| Text::new("{file}: {why}").with("file", path.display()).with_text("why", why))
}

/// The columns of a text.
fn columns(text: &str) -> Result<Vec<DataColumn>, Text> {
    let headings = text.lines().find(|line| !line.starts_with('#')).unwrap_or("");
    let is_semicolon = headings.contains(';');
    let mut reader = csv::ReaderBuilder::new()
        .comment(Some(b'#'))
        .delimiter(if is_semicolon { b';' } else { b',' })
        .trim(csv::Trim::All)
        .from_reader(text.as_bytes());
    let broken = |error: csv::Error| Text::verbatim(error);
    let mut columns: Vec<DataColumn> =
        reader.headers().map_err(broken)?.iter().map(DataColumn::headed).collect();
    for record in reader.records() {
        let record = record.map_err(broken)?;
        for (column, cell) in columns.iter_mut().zip(&record) {
            // Where semicolons separate, a comma is the decimal mark.
            let number = if is_semicolon { cell.replace(',', ".") } else { cell.to_owned() };
            let number = number.parse().ok().filter(|number: &f64| number.is_finite()).ok_or_else(|| {
                let line = record.position().map_or(0, csv::Position::line);
                Text::new("line {line}: `{cell}` is not a number").with("line", line).with("cell", cell)
            })?;
            column.numbers.push(number);
        }
    }
    Ok(columns)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn headings_name_inputs_and_units() {
        let read = columns("# measured\nmass [kg],speed [rpm]\n1.5,900\n2,1e3\n").unwrap();
        assert_eq!(read[0], DataColumn { name: "mass".into(), unit: "kg".into(), numbers: vec![1.5, 2.0] });
        assert_eq!(
            read[1],
            DataColumn { name: "speed".into(), unit: "rpm".into(), numbers: vec![900.0, 1000.0] }
        );
        let read = columns("k [N/mm]; m\n1,5; 2\n").unwrap();
        assert_eq!(read[0].numbers, [1.5]);
        assert_eq!(read[1].unit, "");
    }

    #[test]
    fn a_cell_that_is_no_number_is_named_with_its_line() {
        let why = columns("mass\n1\nheavy\n").unwrap_err().english();
        assert_eq!(why, "line 3: `heavy` is not a number");
        assert!(columns("mass,speed\n1\n").is_err(), "a row with a cell too few");
    }
}
