//! A sheet of a workbook as text.

use std::{collections::BTreeMap, io::Cursor};

use calamine::{Data, Ods, Reader, Xlsx};
use dalembert_core::Text;

use crate::workbook::{SheetPart, Workbook, name_of};

/// The most columns of a table.
const WIDEST: usize = 256;

/// Cells of a sheet by row and column, both counted from 0; empty ones are left out.
type Cells = BTreeMap<u32, BTreeMap<u32, Data>>;

/// A sheet of a workbook as text: one line a row, cells set apart by tabs, numbers with all their digits. Blank lines
/// stand for the rows above, so that line and row have the same number.
///
/// Errors: a file that is no workbook; an unknown sheet; nothing in the chosen part; a date, a time of day, an error or a
/// truth value among the cells, each with its name.
pub(crate) fn spreadsheet(bytes: Vec<u8>, kind: Workbook, part: &SheetPart) -> Result<String, Text> {
    let unreadable = |why: String| Text::new("this spreadsheet cannot be read: {why}").with("why", why);
    match kind {
        Workbook::Xlsx => {
            let mut book = Xlsx::new(Cursor::new(bytes)).map_err(|error| unreadable(error.to_string()))?;
            let names = book.sheet_names();
            chosen(&names, part, |name| of_xlsx(&mut book, name, part).map_err(unreadable))
        }
        Workbook::Ods => {
            let mut book = Ods::new(Cursor::new(bytes)).map_err(|error| unreadable(error.to_string()))?;
            let names = book.sheet_names();
            chosen(&names, part, |name| of_ods(&mut book, name, part).map_err(unreadable))
        }
    }
}

/// Text of the named sheet, or of the first that has numbers in the part.
fn chosen(
    names: &[String],
    part: &SheetPart,
    mut cells_of: impl FnMut(&str) -> Result<Cells, Text>,
) -> Result<String, Text> {
    if let Some(sheet) = &part.sheet {
        let Some(name) = names.iter().find(|name| name.eq_ignore_ascii_case(sheet)) else {
            let have = names.iter().map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", ");
            return Err(Text::new("there is no sheet `{sheet}`; this file has {have}")
                .with("sheet", sheet)
                .with("have", have));
        };
        return written(name, &cells_of(name)?, part);
    }
    let is_number = |value: &Data| matches!(value, Data::Int(_) | Data::Float(_));
    // Numbers with a decimal comma that another language of the program has kept as texts.
    let is_text_of_number =
        |value: &Data| matches!(value, Data::String(text) if text.starts_with(|c: char| c.is_ascii_digit()));
    for is_sought in [&is_number as &dyn Fn(&Data) -> bool, &is_text_of_number] {
        for name in names {
            let cells = cells_of(name)?;
            if cells.values().flat_map(BTreeMap::values).any(is_sought) {
                return written(name, &cells, part);
            }
        }
    }
    Err(Text::new("these cells have no numbers"))
}

/// Cells one after another: a sheet may have one far away from all others.
fn of_xlsx(book: &mut Xlsx<Cursor<Vec<u8>>>, name: &str, part: &SheetPart) -> Result<Cells, String> {
    let mut reader = book.worksheet_cells_reader(name).map_err(|error| error.to_string())?;
    let mut cells = Cells::new();
    while let Some(cell) = reader.next_cell().map_err(|error| error.to_string())? {
        let at = cell.get_position();
        let value = Data::from(cell.get_value().clone());
        keep(&mut cells, part, at, value);
    }
    Ok(cells)
}

fn of_ods(book: &mut Ods<Cursor<Vec<u8>>>, name: &str, part: &SheetPart) -> Result<Cells, String> {
    let range = book.worksheet_range(name).map_err(|error| error.to_string())?;
    let (top, left) = range.start().unwrap_or_default();
    let mut cells = Cells::new();
    for (row, column, value) in range.used_cells() {
        keep(&mut cells, part, (top + row as u32, left + column as u32), value.clone());
    }
    Ok(cells)
}

fn keep(cells: &mut Cells, part: &SheetPart, at: (u32, u32), value: Data) {
    let is_blank =
        matches!(&value, Data::Empty) || matches!(&value, Data::String(text) if text.trim().is_empty());
    if !is_blank && part.contains(at) {
        cells.entry(at.0).or_default().insert(at.1, value);
    }
}

/// Text of cells; the sheet is named below them.
fn written(sheet: &str, cells: &Cells, part: &SheetPart) -> Result<String, Text> {
    let columns = || cells.values().flat_map(BTreeMap::keys).copied();
    let (Some(left), Some(right)) = (columns().min(), columns().max()) else {
        return Err(Text::new("there is nothing in these cells of the sheet `{sheet}`").with("sheet", sheet));
    };
    // A range may reach beyond the last column that has anything.
    let chosen: Vec<u32> = match part.columns.as_slice() {
        [] => (left..=right).collect(),
        ranges => ranges.iter().flat_map(|range| *range.start()..=(*range.end()).min(right)).collect(),
    };
    if chosen.len() > WIDEST {
        let why =
            "the sheet `{sheet}` has cells from {first} to {last}: choose columns, as in `#{sheet}!A:C`";
        return Err(Text::new(why)
            .with("sheet", sheet)
            .with("first", name_of((0, left)))
            .with("last", name_of((0, right))));
    }
    let mut text = String::new();
    let mut next = 0;
    for (&row, values) in cells {
        text.extend((next..row).map(|_| '\n'));
        next = row + 1;
        for (n, &column) in chosen.iter().enumerate() {
            if n > 0 {
                text.push('\t');
            }
            if let Some(value) = values.get(&column) {
                text += &written_cell(value, (row, column), sheet)?;
            }
        }
        text.push('\n');
    }
    Ok(text + &format!("# sheet {sheet}\n"))
}

fn written_cell(value: &Data, at: (u32, u32), sheet: &str) -> Result<String, Text> {
    let refused = |why: &'static str| Err(Text::new(why).with("cell", name_of(at)).with("sheet", sheet));
    match value {
        Data::Int(number) => Ok(number.to_string()),
        Data::Float(number) => Ok(number.to_string()),
        Data::String(text) => Ok(text.split_whitespace().collect::<Vec<_>>().join(" ")),
        Data::Empty => Ok(String::new()),
        Data::DateTime(_) | Data::DateTimeIso(_) | Data::DurationIso(_) => refused(
            "cell {cell} of the sheet `{sheet}` is a date or a time of day: write the time in seconds, as a number",
        ),
        Data::Bool(_) => refused("cell {cell} of the sheet `{sheet}` is true or false: write a number"),
        Data::Error(_) => refused(
            "cell {cell} of the sheet `{sheet}` has an error in place of a number: correct its formula",
        ),
    }
}
