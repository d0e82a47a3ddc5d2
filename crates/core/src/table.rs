//! Numbers in columns, as they are typed, pasted or stand in a file.
//!
//! One row a line; columns are separated by tabs, semicolons, blanks or commas. A first line of words is a
//! heading and may name the units: `f [Hz]; X [mm]`. Lines that begin with `#` are skipped. The text of a universal
//! file is read too: the first of its functions that fits the columns.

use std::borrow::Cow;

use dalembert_units::{self as units, Kind, Style, Unit};

use crate::{Field, Shape, Text, reading, record::Table, uff};

/// The longest table that is read, in bytes.
const LONGEST_TABLE: usize = 16 << 20;
/// The most faults that are listed.
const MOST_FAULTS: usize = 20;

/// Reads a table, or says what is wrong with each line.
pub(crate) fn read(text: &str, columns: &'static [Field]) -> Result<Table, Vec<Text>> {
    if text.len() > LONGEST_TABLE {
        let why = Text::new("this table has {have} bytes; at most {most} are read");
        return Err(vec![why.with("have", text.len()).with("most", LONGEST_TABLE)]);
    }
    if uff::is_universal(text.as_bytes()) {
        return uff::text_table(text, columns).map_err(|why| vec![why]).and_then(|text| read(&text, columns));
    }
    let mut table = Table { units: columns.iter().map(own_unit).collect(), rows: Vec::new() };
    let mut faults = Vec::new();
    let mut miscounts: Vec<Miscount> = Vec::new();
    let mut heading = None;
    let mut settled = None;
    for (n, line) in text.lines().enumerate() {
        let line = line.trim();
        if line.is_empty() || line.starts_with('#') {
            continue;
        }
        let (cells, separator) = cells(line, columns.len(), settled);
        if table.rows.is_empty() && is_heading(&cells) {
            heading = Some(n + 1);
            read_heading(line, &cells, columns, &mut table.units, &mut faults);
            continue;
        }
        if cells.len() != columns.len() {
            let same = |other: &&mut Miscount| (other.cells, other.separator) == (cells.len(), separator);
            match miscounts.iter_mut().find(same) {
                Some(known) => known.more += 1,
                None => miscounts.push(Miscount { line: n + 1, more: 0, cells: cells.len(), separator }),
            }
            continue;
        }
        match read_row(&cells, columns, &table.units) {
            Ok(row) => {
                table.rows.push(row);
                settled = Some(separator);
            }
            Err(why) => {
                faults.push(Text::new("line {line}: {why}").with("line", n + 1).with_text("why", why));
            }
        }
        if faults.len() >= MOST_FAULTS {
            faults.push("there are more faults; these are the first".into());
            return Err(faults);
        }
    }
    faults.extend(miscounts.iter().take(MOST_FAULTS).map(|miscount| miscount.text(columns)));
    if table.rows.is_empty() && faults.is_empty() {
        let why = match heading {
            Some(line) => Text::new(
                "no row of numbers follows the heading in line {line}; write one row a line: {columns}",
            )
            .with("line", line),
            None => Text::new("the table is empty; write one row a line: {columns}"),
        };
        faults.push(why.with_text("columns", names(columns)));
    }
    if faults.is_empty() { Ok(table) } else { Err(faults) }
}

/// The text that gives a table again: a heading with the units, then the rows.
pub(crate) fn text(table: &Table) -> String {
    let style = Style { digits: 15, ascii: true, ..Style::default() };
    let heading: Vec<String> = table.units.iter().map(|unit| format!("[{}]", unit.ascii())).collect();
    let mut text = heading.join("; ");
    for row in &table.rows {
        let cells: Vec<String> = row
            .iter()
            .zip(&table.units)
            .map(|(si, unit)| units::write_number(unit.value(*si), style))
            .collect();
        text.push('\n');
        text += &cells.join("; ");
    }
    text
}

fn measure(column: &Field) -> Option<crate::Measure> {
    if let Shape::Quantity(measure) = column.shape { Some(measure) } else { None }
}

fn own_unit(column: &Field) -> Unit {
    measure(column).map_or(Unit::ONE, |measure| measure.own_unit())
}

/// What sets columns apart.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Separator {
    Semicolon,
    Tab,
    Blank,
    Comma,
}

impl Separator {
    fn name(self) -> &'static str {
        match self {
            Separator::Semicolon => "semicolons",
            Separator::Tab => "tabulators",
            Separator::Blank => "blanks",
            Separator::Comma => "commas",
        }
    }

    /// The cells of a line. Quotation marks, which programs write round a decimal comma, hold what stands between them
    /// together.
    fn split(self, line: &str) -> Vec<Cow<'_, str>> {
        let between = |separator: char| {
            let mut inside = false;
            let cells = line.split(|character| {
                inside ^= character == '"';
                character == separator && !inside
            });
            cells.map(bare).collect()
        };
        match self {
            Separator::Semicolon => between(';'),
            Separator::Tab => between('\t'),
            Separator::Blank => line.split_whitespace().map(Cow::from).collect(),
            Separator::Comma => between(','),
        }
    }
}

/// A cell without the blanks and the quotation marks round it.
fn bare(cell: &str) -> Cow<'_, str> {
    if cell.contains('"') {
        Cow::from(cell.replace('"', "").trim().to_owned())
    } else {
        Cow::from(cell.trim())
    }
}

/// Lines of one wrong number of columns.
struct Miscount {
    /// The first of them.
    line: usize,
    /// How many more there are.
    more: usize,
    cells: usize,
    separator: Separator,
}

impl Miscount {
    fn text(&self, columns: &'static [Field]) -> Text {
        let why = match self.cells {
            1 => Text::new(
                "there is one column instead of {want}: {columns}; set them apart by semicolons, tabs, blanks or commas",
            ),
            _ => {
                Text::new("there are {have} columns, set apart by {separator}, instead of {want}: {columns}")
                    .with("have", self.cells)
                    .with_text("separator", self.separator.name())
            }
        };
        let why = why.with("want", columns.len()).with_text("columns", names(columns));
        let text = match self.more {
            0 => Text::new("line {line}: {why}"),
            more => Text::new("line {line} and {more} more: {why}").with("more", more),
        };
        text.with("line", self.line).with_text("why", why)
    }
}

/// The names of columns, beside each other.
fn names(columns: &'static [Field]) -> Text {
    let (last, others) = match columns {
        [] => return Text::from(""),
        [others @ .., last] => (last, others),
    };
    others.iter().rev().fold(Text::from(last.label), |after, column| {
        Text::new("{column}; {after}").with_text("column", column.label).with_text("after", after)
    })
}

/// The cells of a line. The separator is that of the rows before where it stands in the line, or else the first of `;`,
/// tab, blank and `,` that gives as many as there are columns; where none does, the one that stands there.
fn cells(line: &str, columns: usize, settled: Option<Separator>) -> (Vec<Cow<'_, str>>, Separator) {
    use Separator::{Blank, Comma, Semicolon, Tab};
    if let Some(separator) = settled
        && separator != Blank
    {
        let cells = separator.split(line);
        if cells.len() > 1 {
            return (cells, separator);
        }
    }
    let fits = |separator: &Separator| separator.split(line).len() == columns;
    let separator = [Semicolon, Tab, Blank, Comma].into_iter().find(fits).unwrap_or_else(|| {
        // `1, 2, 3` is set apart by commas.
        let (words, pieces) = (Blank.split(line), Comma.split(line).len());
        let after_commas = words.iter().rev().skip(1).all(|cell| cell.ends_with(','));
        match line {
            _ if line.contains(';') => Semicolon,
            _ if line.contains('\t') => Tab,
            _ if pieces > 1 && after_commas => Comma,
            _ => Blank,
        }
    });
    (separator.split(line), separator)
}

fn is_heading(cells: &[Cow<'_, str>]) -> bool {
    cells
        .iter()
        .all(|cell| !cell.starts_with(|c: char| c.is_ascii_digit() || matches!(c, '-' | '+' | '.' | '−')))
}

/// The units in brackets of a heading: each of its own cell, where there are as many cells as columns.
fn read_heading(
    line: &str,
    cells: &[Cow<'_, str>],
    columns: &'static [Field],
    found: &mut [Unit],
    faults: &mut Vec<Text>,
) {
    let units: Vec<Option<&str>> = if cells.len() == columns.len() {
        cells.iter().map(|cell| bracketed(cell).pop()).collect()
    } else {
        bracketed(line).into_iter().map(Some).collect()
    };
    for ((text, column), place) in units.into_iter().zip(columns).zip(found) {
        let Some(text) = text else { continue };
        let own = own_unit(column);
        match units::unit(text) {
            Ok(unit) if unit.dim.agrees(own.dim) => *place = unit,
            Ok(_) => {
                let why = match own.pretty() {
                    own if own.is_empty() => {
                        Text::new("the heading gives {unit} for {column}, which has no unit")
                    }
                    own => Text::new("the heading gives {unit} for {column}; write a unit like {own}")
                        .with("own", own),
                };
                faults.push(why.with("unit", text).with_text("column", column.label));
            }
            Err(err) => faults.push(reading::text(&err)),
        }
    }
}

/// What stands in square brackets, or where there are none in round ones: `Re (H) [m/(N*s)]` has one unit.
fn bracketed(text: &str) -> Vec<&str> {
    let (open, close) = if text.contains('[') { ('[', ']') } else { ('(', ')') };
    let (mut found, mut depth, mut start) = (Vec::new(), 0usize, 0);
    for (at, c) in text.char_indices() {
        if c == open {
            if depth == 0 {
                start = at + 1;
            }
            depth += 1;
        } else if c == close && depth > 0 {
            depth -= 1;
            if depth == 0 {
                found.push(&text[start..at]);
            }
        }
    }
    found
}

fn read_row(cells: &[Cow<'_, str>], columns: &'static [Field], found: &[Unit]) -> Result<Vec<f64>, Text> {
    let cell = |((text, column), unit): ((&Cow<'_, str>, &Field), &Unit)| {
        let kind = measure(column).map_or(Kind::Other, |measure| measure.kind());
        units::read_quantity(text, unit, kind).map(|quantity| quantity.si).map_err(|err| reading::text(&err))
    };
    cells.iter().zip(columns).zip(found).map(cell).collect()
}
