//! Some columns of a table that stands in a text.

use dalembert_core::Text;

/// Separator of the cells of a line.
#[derive(Clone, Copy, PartialEq)]
enum Separator {
    Blank,
    Byte(u8),
}

impl Separator {
    /// The separator of a text: a semicolon or a tab where most lines have one; a comma where most lines have one and
    /// blanks do not set apart as many columns as are sought.
    fn of(text: &str, last: usize) -> Self {
        let lines = || text.lines().filter(|line| !line.trim().is_empty() && !line.starts_with('#'));
        let is_of_most = |byte: u8| {
            let having = lines().filter(|line| line.as_bytes().contains(&byte)).count();
            having > 0 && 2 * having >= lines().count()
        };
        let is_row = |line: &&str| begins_with_number(line.trim_start());
        let is_complete = |line: &&str| line.split_whitespace().count() >= last;
        let by_blanks = lines().filter(is_row).all(|line| is_complete(&line));
        match () {
            () if is_of_most(b';') => Self::Byte(b';'),
            () if is_of_most(b'\t') => Self::Byte(b'\t'),
            () if is_of_most(b',') && !by_blanks => Self::Byte(b','),
            () => Self::Blank,
        }
    }

    /// Cells of a line; quoted ones may contain the separator.
    fn split(self, line: &str) -> Vec<String> {
        let Self::Byte(delimiter) = self else {
            return line.split_whitespace().map(|cell| cell.trim_end_matches(',').to_owned()).collect();
        };
        let mut reader =
            csv::ReaderBuilder::new().has_headers(false).delimiter(delimiter).from_reader(line.as_bytes());
        let record = reader.records().next().and_then(Result::ok);
        record.iter().flat_map(|record| record.iter().map(|cell| cell.trim().to_owned())).collect()
    }
}

fn begins_with_number(text: &str) -> bool {
    text.starts_with(|c: char| c.is_ascii_digit() || "+-−.".contains(c))
}

/// The columns of these numbers, counted from 1, in their order, set apart by tabs. Lines of words that have not all of
/// them become remarks, so that lines keep their numbers.
///
/// Error: a row of numbers that has not all of them, with its line.
pub fn chosen(text: &str, columns: &[usize]) -> Result<String, Text> {
    let last = columns.iter().copied().max().unwrap_or(1);
    let separator = Separator::of(text, last);
    let mut table = String::new();
    for (n, line) in text.lines().enumerate() {
        let cells = separator.split(line);
        if line.starts_with('#') || cells.is_empty() {
            table += line;
        } else if cells.len() >= last {
            let some: Vec<&str> = columns.iter().map(|at| cells[at - 1].as_str()).collect();
            table += &some.join("\t");
        } else if begins_with_number(&cells[0]) {
            return Err(Text::new("line {line} has {have} columns; column {last} is asked for")
                .with("line", n + 1)
                .with("have", cells.len())
                .with("last", last));
        } else {
            table += "# ";
            table += line;
        }
        table.push('\n');
    }
    Ok(table)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_are_taken_in_their_order() {
        for (text, wanted) in [
            ("Run 3\nt [s];a [g];x [mm]\n0;1,5;2\n0,1;1,6;3\n", "# Run 3\nx [mm]\tt [s]\n2\t0\n3\t0,1\n"),
            ("t\ta\tx\n0\t1.5\t2\n", "x\tt\n2\t0\n"),
            ("t,a,x\n0,1.5,2\n\n1,1.5,4\n", "x\tt\n2\t0\n\n4\t1\n"),
            ("0 1.5 2\n1 1.5 4\n", "2\t0\n4\t1\n"),
            ("0, 1.5, 2\n1, 1.5, 4\n", "2\t0\n4\t1\n"),
            ("\"t, s\",\"a\",\"x, mm\"\n0,1.5,2\n", "x, mm\tt, s\n2\t0\n"),
        ] {
            assert_eq!(chosen(text, &[3, 1]), Ok(wanted.to_owned()), "{text}");
        }
    }

    #[test]
    fn a_row_without_a_column_is_named() {
        let why = chosen("t;x\n0;1\n2\n", &[2]).expect_err("the second row has one");
        assert_eq!(why.english(), "line 3 has 1 columns; column 2 is asked for");
        assert!(chosen("t;x\n0;1\n", &[3]).is_err());
    }
}
