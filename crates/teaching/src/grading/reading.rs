//! Reading of a table of answers.

use csv::{ReaderBuilder, StringRecord};
use dalembert_core::{Text, nearest};

/// The most rows that are read.
pub const MOST_ROWS: usize = 50_000;
/// The longest cell that is kept, in bytes.
const LONGEST_CELL: usize = 1_000;
/// Headings of the columns, the student's aside.
const COLUMNS: [&str; 2] = ["answer", "value"];

/// An answer of a student, as it was given.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct AnswerRow {
    /// Id of the student.
    pub student: String,
    /// Name of the answer.
    pub answer: String,
    /// Value with its unit.
    pub value: String,
}

/// Rows of a CSV text with headings: the column of students, `answer` and `value`, in any order, apart by commas,
/// semicolons or tabs. Other columns are left out.
///
/// # Errors
/// What is wrong with the table, and its repair.
pub fn read(text: &str, student: &str) -> Result<Vec<AnswerRow>, Text> {
    let text = text.trim_start_matches('\u{feff}');
    let heading = text.lines().next().unwrap_or_default();
    let delimiter = [b'\t', b';', b','].into_iter().max_by_key(|mark| {
        let count = heading.bytes().filter(|byte| byte == mark).count();
        (count, *mark == b',')
    });
    let mut reader =
        ReaderBuilder::new().delimiter(delimiter.unwrap_or(b',')).flexible(true).from_reader(text.as_bytes());
    let headings = reader.headers().map_err(|error| unreadable(&error))?.clone();
    let column = |name: &str| -> Result<usize, Text> {
        let is_it = |heading: &str| heading.trim().eq_ignore_ascii_case(name);
        headings.iter().position(is_it).ok_or_else(|| missing(name, &headings))
    };
    let student = column(student)?;
    let [answer, value] = COLUMNS.map(column);
    let (answer, value) = (answer?, value?);
    let mut rows = Vec::new();
    for record in reader.records() {
        let record = record.map_err(|error| unreadable(&error))?;
        if record.iter().all(|cell| cell.trim().is_empty()) {
            continue;
        }
        if rows.len() == MOST_ROWS {
            let why = Text::new("more than {most} rows: grade the class in parts");
            return Err(why.with("most", MOST_ROWS));
        }
        let cell = |at: usize| cut(record.get(at).unwrap_or_default().trim());
        rows.push(AnswerRow { student: cell(student), answer: cell(answer), value: cell(value) });
    }
    if rows.is_empty() { Err("there is no row of answers below the headings".into()) } else { Ok(rows) }
}

/// A cell, of which what is too long to be an answer is cut off.
fn cut(cell: &str) -> String {
    let end = (0..=LONGEST_CELL.min(cell.len())).rev().find(|at| cell.is_char_boundary(*at)).unwrap_or(0);
    cell[..end].to_owned()
}

fn missing(name: &str, headings: &StringRecord) -> Text {
    let known: Vec<&str> = headings.iter().map(str::trim).filter(|heading| heading.len() < 100).collect();
    match nearest(name, known.iter().copied()) {
        Some(near) => {
            Text::new("there is no column `{name}`; is it `{near}`?").with("name", name).with("near", near)
        }
        None => Text::new("there is no column `{name}`; the headings are {known}")
            .with("name", name)
            .with("known", known.iter().take(12).copied().collect::<Vec<_>>().join(", ")),
    }
}

fn unreadable(error: &csv::Error) -> Text {
    let line = error.position().map_or(0, csv::Position::line);
    Text::new("line {line} is no row of CSV: {why}").with("line", line).with("why", error)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tables_of_spreadsheets_are_read() {
        let row = |student: &str, answer: &str, value: &str| AnswerRow {
            student: student.into(),
            answer: answer.into(),
            value: value.into(),
        };
        let comma = "student,answer,value\r\n1,amplitude,19.5 mm\r\n\r\n2,amplitude,\"19,5 mm\"\r\n";
        let read_comma = read(comma, "student").unwrap();
        assert_eq!(read_comma, [row("1", "amplitude", "19.5 mm"), row("2", "amplitude", "19,5 mm")]);
        // Semicolons and a byte order mark, as spreadsheets in countries with a decimal comma write them.
        let semicolon = "\u{feff}Value;Note;Matricula;Answer\n19,5 mm;x;1;amplitude\n";
        assert_eq!(read(semicolon, "matricula").unwrap(), [row("1", "amplitude", "19,5 mm")]);
        let short = read("student\tanswer\tvalue\n1\tamplitude\n", "student").unwrap();
        assert_eq!(short, [row("1", "amplitude", "")]);
    }

    #[test]
    fn errors_name_the_column() {
        let of = |text: &str| read(text, "student").unwrap_err().english();
        assert_eq!(of("students,answer,value\n1,a,2\n"), "there is no column `student`; is it `students`?");
        assert!(of("a,b\n").contains("the headings are a, b"));
        assert!(of("student,answer,value\n").contains("no row"));
        let long = "student,answer,value\n".to_owned() + &"1,a,2\n".repeat(MOST_ROWS + 1);
        assert!(of(&long).contains("50000"));
        let cell = format!("student,answer,value\n1,a,{}é\n", "9".repeat(10_000));
        assert_eq!(read(&cell, "student").unwrap()[0].value.len(), LONGEST_CELL);
    }
}
