//! Numbers in columns, as they are typed, pasted or stand in a file.
//!
//! One row a line; columns are separated by tabs, semicolons, blanks or commas. Lines of words above the rows are a
//! heading and may name the units: `f [Hz]; X [mm]`. Lines that begin with `#` are skipped, but for the units of such a
//! heading. The text of a universal file is read too: the first of its functions that fits the columns.

mod heading;

use std::borrow::Cow;

use dalembert_units::{self as units, Dim, Kind, Style, Unit};

use self::heading::Heading;
use crate::{
    Field, Shape, Text,
    cell::{CellFormula, CellPlace, HeadingWords, MORE_FAULTS, MOST_FAULTS, of_line},
    reading,
    record::NumberTable,
    uff,
};

/// The longest table that is read, in bytes.
const LONGEST_TABLE: usize = 256 << 20;
/// The most cells that may be formulas.
const MOST_FORMULAS: usize = 1000;

/// A table as it was read; its formulas have no value yet.
pub(crate) struct ReadTable {
    pub(crate) table: NumberTable,
    pub(crate) formulas: Vec<CellFormula>,
    /// The last heading without a unit, which may as well be a row of names.
    pub(crate) words: Option<HeadingWords>,
    /// Faults of its lines.
    pub(crate) faults: Vec<Text>,
}

/// A heading with the names and units of columns: `time [s]; displacement [m]`.
pub fn heading(columns: &'static [Field]) -> String {
    let one = |column: &Field| match own_unit(column).ascii() {
        unit if unit.is_empty() => column.name.to_owned(),
        unit => format!("{} [{unit}]", column.name),
    };
    columns.iter().map(one).collect::<Vec<_>>().join("; ")
}

/// The text of a table with the units of its columns above the first row, where it has numbers alone in a column whose
/// unit was another before, and these units.
pub(crate) fn with_units_of_before(text: &str, columns: &'static [Field]) -> Option<(String, String)> {
    let changed = |column: &Field| column.default_before.is_some();
    let unit =
        |column: &Field, unit: &Unit| column.default_before.map_or_else(|| unit.ascii(), str::to_owned);
    if columns.iter().any(changed) { headed(text, columns, changed, unit) } else { None }
}

/// The same for the columns of several kinds, whose numbers alone are in the unit of the kind at that place.
pub(crate) fn with_units_of_kind(text: &str, columns: &'static [Field], place: usize) -> Option<String> {
    let several = |column: &Field| measure(column).filter(|measure| !measure.others.is_empty());
    let unit = |column: &Field, unit: &Unit| {
        let kind = several(column).and_then(|measure| measure.all().nth(place));
        kind.map_or_else(|| unit.ascii(), |kind| kind.own_unit().ascii())
    };
    headed(text, columns, |column| several(column).is_some(), unit).map(|(text, _)| text)
}

/// The text of a table with the units of its columns above the first row, where numbers alone were read in them.
pub fn with_units(text: &str, columns: &'static [Field]) -> Option<String> {
    headed(text, columns, |_| true, |_, unit| unit.ascii()).map(|(text, _)| text)
}

/// The text of a table with a line of units where one is assumed in a column that asks for it, and these units.
fn headed(
    text: &str,
    columns: &'static [Field],
    asks: impl Fn(&Field) -> bool,
    unit: impl Fn(&Field, &Unit) -> String,
) -> Option<(String, String)> {
    if uff::is_universal(text.as_bytes()) {
        return None;
    }
    let ReadTable { table, faults, .. } = read(text, columns);
    if !faults.is_empty()
        || !table.assumed.iter().zip(columns).any(|(assumed, column)| *assumed && asks(column))
    {
        return None;
    }
    let one = |(column, (own, assumed)): (&Field, (&Unit, &bool))| {
        if *assumed { unit(column, own) } else { own.ascii() }
    };
    let units: Vec<String> = columns.iter().zip(table.units.iter().zip(&table.assumed)).map(one).collect();
    let heading = units.iter().map(|unit| format!("[{unit}]")).collect::<Vec<_>>().join("; ");
    let mut lines: Vec<&str> = text.lines().collect();
    let first = first_row(text, columns)?;
    lines.insert(first, &heading);
    Some((lines.join("\n"), units.join(", ")))
}

/// Rows and units of a table, as its heading and its first row give them.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TableOutline {
    /// Number of rows.
    pub rows: usize,
    /// Units of the columns, beside each other: `Hz, m/N`; empty where the columns are pure numbers.
    pub units: String,
    /// Those that are assumed because neither heading nor cell names them; empty where none is.
    pub assumed: String,
}

impl TableOutline {
    /// Outline of the text of a table; `None` where its beginning cannot be read as one, and for a universal file.
    pub fn of(text: &str, columns: &'static [Field]) -> Option<Self> {
        if uff::is_universal(text.as_bytes()) {
            return None;
        }
        let first = first_row(text, columns)?;
        let head: Vec<&str> = text.lines().take(first + 1).collect();
        let ReadTable { table, faults, .. } = read(&head.join("\n"), columns);
        if !faults.is_empty() {
            return None;
        }
        let named = |wanted: &dyn Fn(bool) -> bool| {
            let units = table.units.iter().zip(&table.assumed).filter(|(_, assumed)| wanted(**assumed));
            let units = units.map(|(unit, _)| unit.pretty()).filter(|unit| !unit.is_empty());
            units.collect::<Vec<_>>().join(", ")
        };
        let is_row = |line: &&str| !matches!(line.trim_start().chars().next(), None | Some('#'));
        let rows = text.lines().skip(first).filter(is_row).count();
        Some(Self { rows, units: named(&|_| true), assumed: named(&|assumed| assumed) })
    }

    /// `161 rows · Hz, m/N`, with the units that are assumed.
    pub fn text(&self) -> Text {
        let text = match (&*self.units, &*self.assumed) {
            ("", _) => Text::new("{rows} rows"),
            (_, "") => Text::new("{rows} rows · {units}"),
            (units, assumed) if units == assumed => Text::new("{rows} rows · {units} assumed"),
            _ => Text::new("{rows} rows · {units} ({assumed} assumed)"),
        };
        text.with("rows", self.rows).with("units", &self.units).with("assumed", &self.assumed)
    }
}

/// A column of a table as it is understood.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TableColumn {
    /// Label.
    pub label: &'static str,
    /// Unit; empty for pure numbers.
    pub unit: String,
    /// True if no heading and no cell names the unit.
    pub assumed: bool,
}

/// Columns and first rows of a table, to be looked over before it is taken.
#[derive(Clone, Debug, PartialEq)]
pub struct TablePreview {
    /// Columns.
    pub columns: Vec<TableColumn>,
    /// First rows, in the units of the columns; a cell that is no number is not finite.
    pub rows: Vec<Vec<f64>>,
    /// Number of rows.
    pub count: usize,
    /// The first fault.
    pub fault: Option<Text>,
}

impl TablePreview {
    /// Preview of the text of a table with at most so many rows.
    pub fn of(text: &str, columns: &'static [Field], most: usize) -> Self {
        let ReadTable { table, faults, .. } = read(text, columns);
        let understood = columns.iter().zip(&table.units).zip(&table.assumed);
        let own = |row: &[f64]| row.iter().zip(&table.units).map(|(si, unit)| unit.value(*si)).collect();
        Self {
            columns: understood
                .map(|((column, unit), assumed)| TableColumn {
                    label: column.label,
                    unit: unit.pretty(),
                    assumed: *assumed,
                })
                .collect(),
            rows: table.rows().take(most).map(own).collect(),
            count: table.rows().len(),
            fault: faults.into_iter().next(),
        }
    }
}

/// Index of the first line with a row of numbers.
fn first_row(text: &str, columns: &'static [Field]) -> Option<usize> {
    text.lines().position(|line| {
        let line = line.trim();
        let (cells, _) = cells(line, columns.len(), None);
        !line.is_empty() && !line.starts_with('#') && !is_above(line, &cells, columns)
    })
}

/// Reads a table.
pub(crate) fn read(text: &str, columns: &'static [Field]) -> ReadTable {
    let refused = |why: Text| {
        let table = NumberTable::new(columns.iter().map(own_unit).collect());
        ReadTable { table, formulas: Vec::new(), words: None, faults: vec![why] }
    };
    if text.len() > LONGEST_TABLE {
        let why = Text::new("this table has {have} bytes; at most {most} are read");
        return refused(why.with("have", text.len()).with("most", LONGEST_TABLE));
    }
    if uff::is_universal(text.as_bytes()) {
        return uff::text_table(text, columns).map_or_else(refused, |text| read(&text, columns));
    }
    let mut table = NumberTable::new(columns.iter().map(own_unit).collect());
    let mut row = Vec::with_capacity(columns.len());
    let (mut formulas, mut words_of_heading) = (Vec::new(), None);
    let mut faults = Vec::new();
    let mut miscounts: Vec<Miscount> = Vec::new();
    let (mut headings, mut heading) = (Vec::new(), None);
    let mut named = vec![None; columns.len()];
    let mut settled = None;
    for (n, line) in text.lines().enumerate() {
        let line = line.trim();
        let (words, comment) = (line.trim_start_matches('#'), line.starts_with('#'));
        if words.trim().is_empty() {
            continue;
        }
        let above = Heading { line: n + 1, text: words.trim(), comment };
        if comment {
            headings.extend((table.is_empty()).then_some(above));
            continue;
        }
        let (cells, separator) = cells(line, columns.len(), settled);
        if table.is_empty() && is_above(line, &cells, columns) {
            headings.push(above);
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
        if !headings.is_empty() {
            heading::read(&headings, separator, columns, &mut named, &mut faults);
            let last = headings.drain(..).rfind(|heading| !heading.comment);
            heading = last.map(|heading| heading.line);
            words_of_heading = last.filter(|_| named.iter().all(Option::is_none)).map(|heading| {
                let cells = separator.split(heading.text).into_iter().map(Cow::into_owned).collect();
                HeadingWords { line: heading.line, cells }
            });
            for (unit, named) in table.units.iter_mut().zip(&named) {
                if let Some(named) = named {
                    unit.clone_from(named);
                }
            }
        }
        row.clear();
        let at = table.rows().len();
        for (column, (text, field)) in cells.iter().zip(columns).enumerate() {
            row.push(read_cell(text, field, &table.units[column]).unwrap_or_else(|why| {
                if is_formula(text) && formulas.len() < MOST_FORMULAS {
                    let text = units::with_point(text).into_owned();
                    let unit = table.units[column].clone();
                    let place = CellPlace { row: at, column, line: n + 1, unit };
                    formulas.push(CellFormula { place, text, why });
                } else {
                    faults.push(of_line(n + 1, why));
                }
                f64::NAN
            }));
        }
        for (((cell, si), named), assumed) in cells.iter().zip(&row).zip(&named).zip(&mut table.assumed) {
            *assumed = *assumed || named.is_none() && *si != 0.0 && is_bare(cell);
        }
        table.push(&row);
        settled = Some(separator);
        if faults.len() >= MOST_FAULTS {
            faults.push(MORE_FAULTS.into());
            return ReadTable { table, formulas, words: words_of_heading, faults };
        }
    }
    faults.extend(miscounts.iter().take(MOST_FAULTS).map(|miscount| miscount.text(columns)));
    for (assumed, column) in table.assumed.iter_mut().zip(columns) {
        let own = own_unit(column);
        *assumed &= own.factor != 1.0 || own.dim != Unit::ONE.dim;
    }
    if table.is_empty() && faults.is_empty() {
        let above = headings.iter().rev().find(|heading| !heading.comment).map(|heading| heading.line);
        let why = match above.or(heading) {
            Some(line) => Text::new(
                "no row of numbers follows the heading in line {line}; write one row a line: {columns}",
            )
            .with("line", line),
            None => Text::new("the table is empty; write one row a line: {columns}"),
        };
        faults.push(why.with_text("columns", headings_of(columns)));
    }
    ReadTable { table, formulas, words: words_of_heading, faults }
}

/// The text that gives a table again: a heading with the units, then the rows.
pub(crate) fn text(table: &NumberTable) -> String {
    let style = Style { digits: 15, ascii: true, ..Style::default() };
    let heading: Vec<String> = table.units.iter().map(|unit| format!("[{}]", unit.ascii())).collect();
    let mut text = heading.join("; ");
    for row in table.rows() {
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

/// True if a unit is of a kind that a column takes.
fn takes(column: &Field, fits: impl Fn(Dim) -> bool) -> bool {
    match measure(column) {
        Some(measure) => measure.all().any(|measure| fits(measure.own_unit().dim)),
        None => fits(Unit::ONE.dim),
    }
}

pub(crate) fn own_unit(column: &Field) -> Unit {
    measure(column).map_or(Unit::ONE, |measure| measure.own_unit())
}

/// Column separator.
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
            Separator::Tab => "tabs",
            Separator::Blank => "spaces",
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
    /// Number of further rows of that kind.
    more: usize,
    cells: usize,
    separator: Separator,
}

impl Miscount {
    fn text(&self, columns: &'static [Field]) -> Text {
        let why = match self.cells {
            1 => Text::new(
                "one column instead of {want}: {columns}; separate them by semicolons, tabs, spaces or commas",
            ),
            _ => Text::new("{have} columns separated by {separator} instead of {want}: {columns}")
                .with("have", self.cells)
                .with_text("separator", self.separator.name()),
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

/// The names of columns with their units, beside each other.
fn headings_of(columns: &'static [Field]) -> Text {
    let one = |column: &'static Field| match own_unit(column).pretty() {
        unit if unit.is_empty() => Text::from(column.label),
        unit => Text::new("{column} [{unit}]").with("unit", unit).with_text("column", column.label),
    };
    let (last, others) = match columns {
        [] => return Text::from(""),
        [others @ .., last] => (last, others),
    };
    others.iter().rev().fold(one(last), |after, column| {
        Text::new("{column}; {after}").with_text("column", one(column)).with_text("after", after)
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
    let fits = |separator: &Separator| {
        let cells = separator.split(line);
        // `1, 2` is set apart by commas.
        let is_of_commas = *separator == Blank && cells.iter().rev().skip(1).any(|cell| cell.ends_with(','));
        cells.len() == columns && !is_of_commas
    };
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

/// Returns true if a line is a heading, by its cells or as one of other separators: `Time,Channel 1` has no row of two.
fn is_above(line: &str, cells: &[Cow<'_, str>], columns: &'static [Field]) -> bool {
    let otherwise = |separator: Separator| {
        let cells = separator.split(line);
        cells.len() == columns.len() && is_heading(&cells, columns)
    };
    is_heading(cells, columns)
        || [Separator::Semicolon, Separator::Tab, Separator::Comma].into_iter().any(otherwise)
}

/// Returns true if a line consists of words alone. What stands for a missing number is none.
fn is_heading(cells: &[Cow<'_, str>], columns: &'static [Field]) -> bool {
    let is_number = |cell: &Cow<'_, str>| {
        let text = cell.trim_start_matches(['-', '+', '−']).to_lowercase();
        cell.starts_with(|c: char| c.is_ascii_digit() || matches!(c, '-' | '+' | '.' | '−'))
            || ["nan", "inf", "infinity", "pi"].contains(&text.as_str())
            || ["pi/", "π"].iter().any(|pi| text.starts_with(pi))
            // A product is a formula, where it is not a unit.
            || text.contains('*') && !text.contains('[')
    };
    !cells.iter().any(is_number) || heading::is_of_units(cells, columns)
}

/// Returns true if a cell is a number without a unit.
fn is_bare(cell: &str) -> bool {
    plain_number(cell).is_some()
        || units::read_quantity(&units::with_point(cell), &Unit::ONE, Kind::Other)
            .is_ok_and(|number| number.unit.text.is_empty())
}

/// Returns true if a cell that is no number may be a formula: it has a letter, a bracket or an operator.
fn is_formula(cell: &str) -> bool {
    cell.contains(|c: char| c.is_alphabetic() || "*/^()√".contains(c))
}

/// Reads a cell, in SI. `unit` is that of its column.
fn read_cell(text: &str, column: &Field, unit: &Unit) -> Result<f64, Text> {
    if let Some(number) = plain_number(text) {
        return Ok(unit.si(number));
    }
    if is_of_clock(text) {
        return Err("a date or a time of day: write the time in seconds, as a number".into());
    }
    let kind = measure(column).map_or(Kind::Other, |measure| measure.of(unit).kind());
    // The separator of its columns tells that the comma of a table is a decimal one.
    let read = units::read_quantity(&units::with_point(text), unit, kind);
    read.map(|quantity| quantity.si).map_err(|err| reading::text(&err))
}

/// Returns true if a cell has digits on both sides of a colon.
fn is_of_clock(cell: &str) -> bool {
    let is_digit = |c: Option<char>| c.is_some_and(|c| c.is_ascii_digit());
    cell.match_indices(':')
        .any(|(at, _)| is_digit(cell[..at].chars().next_back()) && is_digit(cell[at + 1..].chars().next()))
}

/// A number of digits, a point and an exponent, as instruments write them, or with the exponent of Fortran, `1.5D+01`;
/// anything else is left to the reader of quantities.
fn plain_number(text: &str) -> Option<f64> {
    let is_plain = |c: u8| c.is_ascii_digit() || matches!(c, b'.' | b'-' | b'+' | b'e' | b'E');
    if let Some((mantissa, exponent)) = text.split_once('D').filter(|(_, rest)| rest.starts_with(['+', '-']))
    {
        return plain_number(&format!("{mantissa}E{exponent}"));
    }
    let number: f64 = text.bytes().all(is_plain).then(|| text.parse().ok())??;
    (number == 0.0 || (1e-290..1e290).contains(&number.abs())).then_some(number)
}
