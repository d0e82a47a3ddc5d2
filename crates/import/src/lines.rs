//! The table that stands in the lines of a text: below what an instrument wrote above it, some of its columns.

use dalembert_core::{Field, Text};

use crate::units_above::{self, UnitsAbove};

/// Separator of the cells of a line.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Separator {
    Blank,
    Byte(u8),
}

/// Separators in the order in which they are tried: a comma is a decimal mark where another one parts the cells.
const SEPARATORS: [Separator; 4] =
    [Separator::Byte(b';'), Separator::Byte(b'\t'), Separator::Blank, Separator::Byte(b',')];

impl Separator {
    /// Cells of a line, without the empty ones at its end; quoted ones may contain the separator.
    fn split(self, line: &str) -> Vec<String> {
        let mut cells: Vec<String> = match self {
            Self::Blank => line.split_whitespace().map(str::to_owned).collect(),
            Self::Byte(delimiter) if !line.contains('"') => {
                line.split(char::from(delimiter)).map(|cell| cell.trim().to_owned()).collect()
            }
            Self::Byte(delimiter) => {
                let mut reader = csv::ReaderBuilder::new()
                    .has_headers(false)
                    .delimiter(delimiter)
                    .from_reader(line.as_bytes());
                let record = reader.records().next().and_then(Result::ok);
                record.iter().flat_map(|record| record.iter().map(|cell| cell.trim().to_owned())).collect()
            }
        };
        while cells.last().is_some_and(String::is_empty) {
            cells.pop();
        }
        cells
    }
}

/// Returns true if a cell begins as a number; with blanks between them, one that ends in a comma is no cell.
fn begins_with_number(cell: &str) -> bool {
    let unsigned = cell.trim_start_matches(['+', '-', '−']);
    unsigned.starts_with(|c: char| c.is_ascii_digit() || c == '.' || c == ',')
}

fn is_remark(line: &str) -> bool {
    line.trim_start().starts_with('#')
}

/// Place of the rows in a text.
#[derive(Debug)]
struct Layout {
    separator: Separator,
    /// Index of the first line of words with one cell a column, above the rows.
    heading: usize,
    /// Index of the first row.
    first: usize,
    /// Number of columns.
    width: usize,
}

impl Layout {
    /// Layout of lines whose last ones are rows of numbers. The separator is the first that gives as many columns as are
    /// wanted, else the one that gives the most.
    fn of(lines: &[&str], chosen: &[usize], wanted: usize) -> Option<Self> {
        let found: Vec<Self> =
            SEPARATORS.iter().filter_map(|separator| Self::with(*separator, lines, chosen)).collect();
        let fits = |layout: &Self| if chosen.is_empty() { layout.width == wanted } else { true };
        let at = found.iter().position(fits);
        let widest = (0..found.len()).max_by_key(|at| (found[*at].width, found.len() - at));
        found.into_iter().nth(at.or(widest)?)
    }

    fn with(separator: Separator, lines: &[&str], chosen: &[usize]) -> Option<Self> {
        let (mut first, mut width) = (None, 0);
        for (at, line) in lines.iter().enumerate().rev() {
            let cells = separator.split(line);
            if cells.is_empty() || is_remark(line) {
                continue;
            }
            let is_one_column = cells.len() == 1 && chosen.is_empty();
            let is_other = first.is_some() && cells.len() != width;
            if is_one_column || is_other || !is_row(&cells, separator, chosen) {
                break;
            }
            (first, width) = (Some(at), cells.len());
        }
        let first = first?;
        let is_heading = |line: &&&str| {
            let cells = separator.split(line);
            let is_complete = cells.len() == width || separator == Separator::Blank && cells.len() > 1;
            !is_remark(line) && is_complete && !cells.iter().any(|cell| begins_with_number(cell))
        };
        let heading = first - lines[..first].iter().rev().take_while(is_heading).count();
        Some(Self { separator, heading, first, width })
    }
}

/// Returns true if cells are a row of numbers, as far as their columns are chosen.
fn is_row(cells: &[String], separator: Separator, chosen: &[usize]) -> bool {
    let is_number = |cell: &String| {
        begins_with_number(cell) && !(separator == Separator::Blank && cell.len() > 1 && cell.ends_with(','))
    };
    match chosen {
        [] => cells.iter().all(is_number),
        chosen => chosen.iter().all(|at| cells.get(at - 1).is_some_and(is_number)),
    }
}

/// The text of a table of these columns, one line for each line of the text.
///
/// Where a heading with one cell a column stands above the last rows, what stands above the heading is made remarks: it is
/// the preamble of an instrument. Units that it names are written into the heading.
///
/// Columns are counted from 1; without any, all are taken.
///
/// Errors: a row that has not all columns; more columns than the table takes; a unit in the preamble that belongs to no
/// column.
pub(crate) fn table(text: &str, columns: &[usize], fields: &'static [Field]) -> Result<String, Text> {
    let lines: Vec<&str> = text.lines().collect();
    let Some(layout) = Layout::of(&lines, columns, fields.len()) else {
        return if columns.is_empty() { Ok(text.to_owned()) } else { chosen(&lines, columns) };
    };
    if columns.is_empty() && layout.width > fields.len() {
        let why = Text::new(
            "the rows have {have} columns and the table {want}: name the columns to take, as in `#{columns}`",
        );
        let first: Vec<String> = (1..=fields.len()).map(|column| column.to_string()).collect();
        let why = why.with("have", layout.width).with("want", fields.len());
        return Err(why.with("columns", first.join(",")));
    }
    heading_fits(&lines, &layout, columns)?;
    marks_agree(&lines, &layout, columns)?;
    let is_row = |line: &&str| is_row(&layout.separator.split(line), layout.separator, columns);
    let has_preamble = layout.heading < layout.first && !lines[..layout.heading].iter().any(is_row);
    let top = if has_preamble { layout.heading } else { 0 };
    let above: Vec<Vec<String>> = lines[..top].iter().map(|line| layout.separator.split(line)).collect();
    let units = units_above::of(&above, layout.width)?;
    let mut table = String::new();
    for (at, line) in lines.iter().enumerate() {
        let cells = || layout.separator.split(line);
        match &units {
            Some(UnitsAbove { line: place, units }) if *place == at => {
                table += &joined(units, columns, layout.width);
            }
            _ if at < top => table += &remark(line),
            _ if is_remark(line) => table += &chosen_remark(line, &layout, columns),
            _ if columns.is_empty() && !line.trim_end().ends_with([';', ',', '\t']) => table += line,
            _ => match cells() {
                cells if cells.is_empty() => {}
                cells if cells.len() >= last_of(columns, layout.width) => {
                    table += &joined(&cells, columns, layout.width);
                }
                cells if begins_with_number(&cells[0]) && !columns.is_empty() => {
                    return Err(too_short(at, cells.len(), columns));
                }
                _ if columns.is_empty() => table += line,
                _ => table += &remark(line),
            },
        }
        table.push('\n');
    }
    Ok(table)
}

/// The text with bare remarks in place of its first lines, so that the others keep their numbers.
///
/// Error: more lines than there are.
pub(crate) fn without_first(text: &str, skip: usize) -> Result<String, Text> {
    if skip == 0 {
        return Ok(text.to_owned());
    }
    let have = text.lines().count();
    if skip >= have {
        let why = Text::new("`skip={skip}` leaves nothing: the file has {have} lines");
        return Err(why.with("skip", skip).with("have", have));
    }
    let lines = text.lines().enumerate().map(|(at, line)| if at < skip { "#" } else { line });
    Ok(lines.collect::<Vec<_>>().join("\n") + "\n")
}

/// Error: words above the rows that cannot be the names of their columns.
fn heading_fits(lines: &[&str], layout: &Layout, chosen: &[usize]) -> Result<(), Text> {
    let above = lines[..layout.first].iter().enumerate().rev().find(|(_, line)| !line.trim().is_empty());
    let Some((at, line)) = above.filter(|(_, line)| !is_remark(line)) else { return Ok(()) };
    let cells = layout.separator.split(line);
    let is_of_words = !cells.iter().any(|cell| begins_with_number(cell));
    if !is_of_words {
        return Ok(());
    }
    if layout.separator == Separator::Byte(b',') && cells.len() > 1 && 2 * cells.len() == layout.width {
        let why = "the rows have twice as many commas as the heading in line {line}: set columns apart by semicolons where a comma is the decimal mark";
        return Err(Text::new(why).with("line", at + 1));
    }
    if layout.separator == Separator::Blank && !chosen.is_empty() && cells.len() != layout.width {
        let why = "the heading in line {line} has {have} words above {want} columns: set its names apart by semicolons or tabs as the rows, or leave it out, as in `#{columns},skip={line}`";
        let columns: Vec<String> = chosen.iter().map(ToString::to_string).collect();
        return Err(Text::new(why)
            .with("line", at + 1)
            .with("have", cells.len())
            .with("want", layout.width)
            .with("columns", columns.join(",")));
    }
    Ok(())
}

/// Error: a point may set thousands apart, since other numbers have a decimal comma.
fn marks_agree(lines: &[&str], layout: &Layout, columns: &[usize]) -> Result<(), Text> {
    let rows = &lines[layout.first..];
    if layout.separator == Separator::Byte(b',') || !rows.iter().any(|line| line.contains(',')) {
        return Ok(());
    }
    let has_comma = |cell: &str| cell.matches(',').count() == 1 && !cell.contains('.');
    let may_be_thousands = |cell: &str| {
        let mut groups = cell.trim_start_matches(['+', '-', '−']).split('.');
        let first = groups.next().unwrap_or_default();
        let others: Vec<&str> = groups.collect();
        let is_of_digits = |group: &str| group.bytes().all(|byte| byte.is_ascii_digit());
        (1..=3).contains(&first.len())
            && is_of_digits(first)
            && !others.is_empty()
            && others.iter().all(|group| group.len() == 3 && is_of_digits(group))
    };
    let (mut commas, mut thousands) = (false, None);
    for (at, line) in rows.iter().enumerate().filter(|(_, line)| !is_remark(line)) {
        let cells = layout.separator.split(line);
        let read = |n: usize| columns.is_empty() || columns.contains(&(n + 1));
        for (_, cell) in cells.iter().enumerate().filter(|(n, _)| read(*n)) {
            commas = commas || has_comma(cell);
            if thousands.is_none() && may_be_thousands(cell) {
                thousands = Some((layout.first + at + 1, cell.clone()));
            }
        }
        if commas && let Some((line, cell)) = thousands {
            let why = "line {line}: {cell} has a point where other numbers have a decimal comma: save the file without points between thousands";
            return Err(Text::new(why).with("line", line).with("cell", cell));
        }
    }
    Ok(())
}

/// The chosen columns of lines whose end is no row of numbers: what is not read of them is named by the reader of tables.
fn chosen(lines: &[&str], columns: &[usize]) -> Result<String, Text> {
    let last = last_of(columns, 0);
    let has_rows = |separator: &&Separator| {
        lines.iter().any(|line| is_row(&separator.split(line), **separator, columns))
    };
    let separator = *SEPARATORS.iter().find(has_rows).unwrap_or(&Separator::Blank);
    let mut table = String::new();
    for (at, line) in lines.iter().enumerate() {
        let cells = separator.split(line);
        if is_remark(line) || cells.is_empty() {
            table += line;
        } else if cells.len() >= last {
            table += &joined(&cells, columns, last);
        } else if begins_with_number(&cells[0]) {
            return Err(too_short(at, cells.len(), columns));
        } else {
            table += &remark(line);
        }
        table.push('\n');
    }
    Ok(table)
}

fn too_short(at: usize, have: usize, columns: &[usize]) -> Text {
    Text::new("line {line} has {have} columns; column {last} is asked for")
        .with("line", at + 1)
        .with("have", have)
        .with("last", last_of(columns, 0))
}

/// The last of the columns, or of so many where none is chosen.
fn last_of(columns: &[usize], width: usize) -> usize {
    columns.iter().copied().max().unwrap_or(width)
}

/// The chosen cells, set apart by tabs.
fn joined(cells: &[String], columns: &[usize], width: usize) -> String {
    let cell = |at: usize| cells.get(at).map_or("", String::as_str);
    let some: Vec<&str> = match columns {
        [] => (0..width).map(cell).collect(),
        columns => columns.iter().map(|at| cell(at - 1)).collect(),
    };
    some.join("\t")
}

fn remark(line: &str) -> String {
    if line.trim().is_empty() || is_remark(line) { line.to_owned() } else { format!("# {line}") }
}

/// A remark, of which a heading has the chosen columns alone.
fn chosen_remark(line: &str, layout: &Layout, columns: &[usize]) -> String {
    let words = line.trim_start().trim_start_matches('#').trim();
    let cells =
        SEPARATORS.iter().map(|separator| separator.split(words)).find(|cells| cells.len() == layout.width);
    match cells {
        Some(cells) if !columns.is_empty() => format!("# {}", joined(&cells, columns, layout.width)),
        _ => line.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tests::fields;

    fn read(text: &str, skip: usize, columns: &[usize]) -> Result<String, String> {
        let text = without_first(text, skip).map_err(|why| why.english())?;
        table(&text, columns, fields()).map_err(|why| why.english())
    }

    #[test]
    fn columns_are_taken_in_their_order() {
        for (text, wanted) in [
            ("Run 3\nt [s];a [g];x [mm]\n0;1,5;2\n0,1;1,6;3\n", "# Run 3\nx [mm]\tt [s]\n2\t0\n3\t0,1\n"),
            ("t\ta\tx\n0\t1.5\t2\n", "x\tt\n2\t0\n"),
            ("t,a,x\n0,1.5,2\n\n1,1.5,4\n", "x\tt\n2\t0\n\n4\t1\n"),
            ("0 1.5 2\n1 1.5 4\n", "2\t0\n4\t1\n"),
            ("0, 1.5, 2\n1, 1.5, 4\n", "2\t0\n4\t1\n"),
            ("\"t, s\",\"a\",\"x, mm\"\n0,1.5,2\n", "x, mm\tt, s\n2\t0\n"),
            ("# t [s], a, x [mm]\n0,1.5,2\n", "# x [mm]\tt [s]\n2\t0\n"),
            ("1;up;2\n3;down;4\n", "2\t1\n4\t3\n"),
        ] {
            assert_eq!(read(text, 0, &[3, 1]), Ok(wanted.to_owned()), "{text}");
        }
    }

    #[test]
    fn a_row_without_a_column_is_named() {
        let why = read("t;x\n0;1\n2\n", 0, &[2]).expect_err("the second row has one");
        assert_eq!(why, "line 3 has 1 columns; column 2 is asked for");
        assert!(read("t;x\n0;1\n", 0, &[3]).is_err());
    }

    #[test]
    fn a_preamble_stands_above_a_heading_with_one_cell_a_column() {
        let text = "Model,DS1\nRecord Length,2500\nSample Interval,4e-6\nt [s],x [mm]\n0,1\n1,2\n";
        let wanted = "# Model,DS1\n# Record Length,2500\n# Sample Interval,4e-6\nt [s],x [mm]\n0,1\n1,2\n";
        assert_eq!(read(text, 0, &[]), Ok(wanted.to_owned()));
        // Without a heading between, and with a row of numbers above it, nothing is taken for a preamble.
        for text in ["Record Length,2500\n0,1\n1,2\n", "2500,4\nt,x\n0,1\n1,2\n"] {
            assert_eq!(read(text, 0, &[]), Ok(text.to_owned()));
        }
    }

    #[test]
    fn units_of_a_preamble_come_into_the_heading() {
        let text = "Horizontal Units,s\nVertical Units,um\nRecord Length,2\nTIME,CH1\n0,1\n1,2\n";
        let wanted = "# Horizontal Units,s\n[s]\t[um]\n# Record Length,2\nTIME,CH1\n0,1\n1,2\n";
        assert_eq!(read(text, 0, &[]), Ok(wanted.to_owned()));
        let why =
            read("Operator;Unit 3\nUnit;um;1\nt;x\n0;1\n1;2\n", 0, &[]).expect_err("one unit, two columns");
        assert!(why.starts_with("line 2 names a unit above the heading"), "{why}");
    }

    #[test]
    fn lines_are_skipped_and_keep_the_numbers_of_the_others() {
        let text = "Record Length,2500\n12,13\n0,1\n1,2\n";
        assert_eq!(read(text, 2, &[]), Ok("#\n#\n0,1\n1,2\n".to_owned()));
        assert_eq!(read(text, 2, &[2, 1]), Ok("#\n#\n1\t0\n2\t1\n".to_owned()));
        assert_eq!(read(text, 4, &[]).expect_err("all"), "`skip=4` leaves nothing: the file has 4 lines");
    }

    #[test]
    fn what_cannot_be_assigned_to_columns_is_refused() {
        for (text, columns, words) in [
            ("t;a;x\n0;1;2\n1;2;3\n", &[][..], "name the columns to take, as in `#1,2`"),
            ("t,x\n0,0,1,5\n0,1,2,5\n", &[1, 3], "twice as many commas"),
            ("t / ms x / mm\n0 1\n1 2\n", &[1, 2], "has 6 words above 2 columns"),
            ("t;x\n0,5;1.200\n1,5;2.300\n", &[], "line 2: 1.200 has a point"),
        ] {
            let why = read(text, 0, columns).expect_err(text);
            assert!(why.contains(words), "{why}");
        }
    }
}
