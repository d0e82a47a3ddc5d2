//! The table that stands in the lines of a text: below what an instrument wrote above it, some of its columns.

use dalembert_core::{Field, Text};

use crate::units_above::{self, UnitsAbove, bracketed};

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

    /// Cells of a line of names; above columns that blanks set apart, a name may have one.
    fn names(self, line: &str, width: usize) -> Vec<String> {
        let wide: Vec<&str> = line.split("  ").map(str::trim).filter(|cell| !cell.is_empty()).collect();
        if self == Self::Blank && wide.len() == width {
            return wide.into_iter().map(str::to_owned).collect();
        }
        self.split(line)
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
    /// wanted, else the first.
    fn of(lines: &[&str], chosen: &[usize], wanted: usize) -> Option<Self> {
        let mut found: Vec<Self> =
            SEPARATORS.iter().filter_map(|separator| Self::with(*separator, lines, chosen)).collect();
        let fits = |layout: &Self| !chosen.is_empty() || layout.width == wanted;
        let at = found.iter().position(fits).unwrap_or(0);
        (at < found.len()).then(|| found.swap_remove(at))
    }

    fn with(separator: Separator, lines: &[&str], chosen: &[usize]) -> Option<Self> {
        let (mut first, mut width, mut label) = (None, 0, None);
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
            if !cells[0].is_empty() {
                let is_number = begins_with_number(&cells[0]);
                if *label.get_or_insert(is_number) != is_number {
                    break;
                }
            }
            (first, width) = (Some(at), cells.len());
        }
        let first = first?;
        let mut heading = first;
        for (at, line) in lines[..first].iter().enumerate().rev() {
            let cells = separator.names(line, width);
            let is_complete = cells.len() == width || separator == Separator::Blank && cells.len() > 1;
            let has_names =
                !cells.iter().any(|cell| begins_with_number(cell)) && !units_above::is_key(&cells);
            match cells.is_empty() {
                true => {}
                false if !is_remark(line) && is_complete && has_names => heading = at,
                false => break,
            }
        }
        Some(Self { separator, heading, first, width })
    }

    /// Index of the line up to which a preamble reaches: that of the heading, or of the rows below a line that names
    /// their units; 0 where a row of numbers stands above.
    ///
    /// Error: a line just above the rows with numbers in their columns and a word before them, or the reverse.
    fn preamble(&self, lines: &[&str], chosen: &[usize]) -> Result<usize, Text> {
        let last = lines[..self.first]
            .iter()
            .enumerate()
            .rev()
            .find(|(_, line)| !self.separator.split(line).is_empty());
        let Some((at, line)) = last.filter(|(_, line)| !is_remark(line)) else { return Ok(0) };
        let cells = self.separator.split(line);
        if cells.len() == self.width && is_row(&cells, self.separator, chosen) {
            let why = Text::new(
                "line {line} has numbers, but begins as no other row: leave it out with the lines above it, as in `#{columns},skip={line}`",
            );
            let columns: Vec<String> = chosen.iter().map(ToString::to_string).collect();
            return Err(why.with("line", at + 1).with("columns", columns.join(",")));
        }
        let top = if units_above::is_key(&cells) { self.first } else { self.heading };
        let is_word = |cells: &[String]| cells[0].starts_with(char::is_alphabetic);
        let is_row_above = |line: &&str| {
            let cells = self.separator.split(line);
            is_row(&cells, self.separator, chosen) && (!is_word(&cells) || chosen.contains(&1))
        };
        let is_preamble = top < self.first || units_above::is_key(&cells);
        Ok(if is_preamble && !lines[..top].iter().any(is_row_above) { top } else { 0 })
    }
}

/// Returns true if cells are a row of numbers, as far as their columns are chosen.
fn is_row(cells: &[String], separator: Separator, chosen: &[usize]) -> bool {
    let is_number = |cell: &String| {
        let is_of_blanks = separator == Separator::Blank && cell.len() > 1 && cell.ends_with(',');
        begins_with_number(cell) && !is_of_blanks && !cell.contains([';', '\t'])
    };
    match chosen {
        [] => cells.iter().any(is_number) && cells.iter().all(|cell| cell.is_empty() || is_number(cell)),
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
/// `example` is a part with as many columns as there are fields.
pub(crate) fn table(
    text: &str,
    columns: &[usize],
    fields: &'static [Field],
    example: &str,
) -> Result<String, Text> {
    let lines: Vec<&str> = text.lines().collect();
    let Some(layout) = Layout::of(&lines, columns, fields.len()) else {
        return if columns.is_empty() { Ok(text.to_owned()) } else { chosen(&lines, columns) };
    };
    heading_fits(&lines, &layout, columns)?;
    if columns.is_empty() && layout.width > fields.len() {
        let why = Text::new(
            "the rows have {have} columns and the table {want}: name the columns to take, as in `#{columns}`",
        );
        let why = why.with("have", layout.width).with("want", fields.len());
        return Err(why.with("columns", example));
    }
    marks_agree(&lines, &layout, columns)?;
    let top = layout.preamble(&lines, columns)?;
    let above: Vec<Vec<String>> = lines[..top].iter().map(|line| layout.separator.split(line)).collect();
    let units = units_above::of(&above, layout.width)?;
    let mut table = String::new();
    if let Some(beside) = units_beside(&lines, &layout, columns)? {
        table += &joined(&beside.units, columns, layout.width);
        table.push('\n');
    }
    for (at, line) in lines.iter().enumerate() {
        let cells = || layout.separator.split(line);
        match &units {
            Some(UnitsAbove { line: place, units }) if *place == at => {
                table += &joined(units, columns, layout.width);
            }
            _ if at < top => table += &remark(line),
            _ if (layout.heading..layout.first).contains(&at) => {
                table += &heading(line, &layout, columns);
            }
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

/// The first so many lines of names and rows, cell by cell; none where no rows are recognised.
pub(crate) fn beginning(text: &str, count: usize) -> Vec<Vec<String>> {
    let lines: Vec<&str> = text.lines().collect();
    let Some(layout) = Layout::of(&lines, &[], 0) else { return Vec::new() };
    let above =
        lines[layout.heading..layout.first].iter().map(|line| layout.separator.names(line, layout.width));
    let rows = lines[layout.first..].iter().map(|line| layout.separator.split(line));
    above.chain(rows).filter(|cells| !cells.is_empty()).take(count).collect()
}

/// A line of names or units with the chosen columns; as it is, where nothing of it changes.
fn heading(line: &str, layout: &Layout, columns: &[usize]) -> String {
    let names = layout.separator.names(line, layout.width);
    let is_wide = layout.separator == Separator::Blank && layout.separator.split(line).len() != names.len();
    let has_words = names.iter().any(|name| units_above::symbol(name).is_some());
    if columns.is_empty() && !is_wide && !has_words && !line.trim_end().ends_with([';', ',', '\t']) {
        return line.to_owned();
    }
    let in_symbols =
        |name: String| if units_above::symbol(&name).is_some() { bracketed(&name) } else { name };
    let names: Vec<String> = names.into_iter().map(in_symbols).collect();
    joined(&names, columns, layout.width.max(names.len()))
}

/// Units of a preamble that stands in columns left of the chosen ones, beside the rows.
fn units_beside(lines: &[&str], layout: &Layout, columns: &[usize]) -> Result<Option<UnitsAbove>, Text> {
    let left = columns.iter().min().map_or(0, |first| first - 1);
    if left < 2 || layout.heading < layout.first {
        return Ok(None);
    }
    let cells = |line: &&str| layout.separator.split(line).into_iter().take(left).collect();
    let beside: Vec<Vec<String>> = lines[layout.first..].iter().map(cells).collect();
    let is_key = |cells: &Vec<String>| cells.first().is_some_and(|key| key.starts_with(char::is_alphabetic));
    let is_blank = |cells: &Vec<String>| cells.iter().all(String::is_empty);
    let keys: Vec<Vec<String>> =
        beside.into_iter().take_while(|cells| is_blank(cells) || is_key(cells)).collect();
    let mut units = units_above::of(&keys, columns.len())?;
    if let Some(found) = &mut units {
        let mut wide = vec![units_above::NONE.to_owned(); layout.width];
        for (at, unit) in columns.iter().zip(&found.units) {
            unit.clone_into(&mut wide[at - 1]);
        }
        found.units = wide;
    }
    Ok(units)
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
    let cells = layout.separator.names(line, layout.width);
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

/// Error: what may set thousands apart would be read as a decimal mark.
///
/// Digits in groups of three are read as decimal places where another number shows that the mark is decimal, as 0,5 does,
/// or semicolons set the columns apart, as they do where the comma is decimal.
fn marks_agree(lines: &[&str], layout: &Layout, columns: &[usize]) -> Result<(), Text> {
    let rows = &lines[layout.first..];
    if !rows.iter().any(|line| line.contains(',')) {
        return Ok(());
    }
    let mut decimals = [layout.separator == Separator::Byte(b';'), false];
    let mut groups: [Option<(usize, String)>; 2] = [None, None];
    for (at, line) in rows.iter().enumerate().filter(|(_, line)| !is_remark(line)) {
        let cells = layout.separator.split(line);
        let is_chosen = |n: usize| columns.is_empty() || columns.contains(&(n + 1));
        for cell in cells.iter().enumerate().filter_map(|(n, cell)| is_chosen(n).then_some(cell)) {
            for (n, mark) in [',', '.'].into_iter().enumerate() {
                match grouping(cell, mark) {
                    Some(true) => _ = groups[n].get_or_insert_with(|| (layout.first + at + 1, cell.clone())),
                    Some(false) => decimals[n] = true,
                    None => {}
                }
            }
        }
    }
    let [commas, points] = groups;
    let refused = |(line, cell): (usize, String), why: &'static str| {
        Err(Text::new(why).with("line", line).with("cell", cell))
    };
    match (commas, points, decimals) {
        (Some(cell), _, [_, true] | [false, _]) => refused(
            cell,
            "line {line}: the comma of {cell} may set thousands apart: save the file without commas between thousands",
        ),
        (_, Some(cell), [true, _]) => refused(
            cell,
            "line {line}: the point of {cell} may set thousands apart, since other numbers have a decimal comma: save the file without points between thousands",
        ),
        _ => Ok(()),
    }
}

/// True if the digits behind a mark are in groups of three, and not below one; `None` where there is no such mark, or
/// another one as well.
fn grouping(cell: &str, mark: char) -> Option<bool> {
    let unsigned = cell.trim_start_matches(['+', '-', '−']);
    let mut parts = unsigned.split(mark);
    let first = parts.next()?;
    let others: Vec<&str> = parts.collect();
    let is_of_digits = |part: &str| part.bytes().all(|byte| byte.is_ascii_digit());
    if others.is_empty() || unsigned.contains(|c| [',', '.'].contains(&c) && c != mark) {
        return None;
    }
    let is_grouped = others.iter().all(|part| part.len() == 3 && is_of_digits(part));
    Some((1..=3).contains(&first.len()) && is_of_digits(first) && !first.starts_with('0') && is_grouped)
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
        table(&text, columns, fields(), "1,2").map_err(|why| why.english())
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
    fn a_decimal_comma_is_shown_by_other_numbers() {
        for text in [
            "t;x\n1,500;1,200\n",
            "t\tx\n0,500\t1,200\n",
            "t,x\n\"0,5\",\"1,200\"\n",
            "t;x\n0.5;1.200\n",
            "t\tx\n1.500\t1.200\n",
        ] {
            assert_eq!(read(text, 0, &[]), Ok(text.to_owned()));
        }
    }

    #[test]
    fn what_cannot_be_assigned_to_columns_is_refused() {
        for (text, columns, words) in [
            ("t;a;x\n0;1;2\n1;2;3\n", &[][..], "name the columns to take, as in `#1,2`"),
            ("t,x\n0,0,1,5\n0,1,2,5\n", &[1, 3], "twice as many commas"),
            ("t / ms x / mm\n0 1\n1 2\n", &[1, 2], "has 6 words above 2 columns"),
            ("t;x\n0,5;1.200\n1,5;2.300\n", &[], "line 2: the point of 1.200 may"),
            ("t,x\n0,\"1,200\"\n1,\"2,300\"\n", &[], "line 2: the comma of 1,200 may"),
            ("t\tx\n0.5\t1,200\n1.5\t2,300\n", &[], "line 2: the comma of 1,200 may"),
        ] {
            let why = read(text, 0, columns).expect_err(text);
            assert!(why.contains(words), "{why}");
        }
    }
}
