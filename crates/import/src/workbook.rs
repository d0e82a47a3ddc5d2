//! A part of a workbook, as it is named behind `#`.

use std::ops::RangeInclusive;

use dalembert_core::Text;

/// The most columns and rows of a sheet, as in Excel.
const MOST: (u32, u32) = (16_384, 1_048_576);

/// Format of a workbook.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Workbook {
    /// Office Open XML, `.xlsx` or `.xlsm`.
    Xlsx,
    /// OpenDocument, `.ods`.
    Ods,
}

impl Workbook {
    /// Format of a file by its extension.
    pub(crate) fn of_extension(extension: &str) -> Option<Self> {
        match extension.to_ascii_lowercase().as_str() {
            "xlsx" | "xlsm" => Some(Self::Xlsx),
            "ods" => Some(Self::Ods),
            _ => None,
        }
    }
}

/// A sheet and a part of it: `Data!A:C`, `Data!A,C`, `Data!B2:C40`, `A:C` or `Data`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct SheetPart {
    /// Name of the sheet; without one the first that has numbers.
    pub(crate) sheet: Option<String>,
    /// Ranges of columns in their order, counted from 0; without any, all columns.
    pub(crate) columns: Vec<RangeInclusive<u32>>,
    /// Rows, counted from 0.
    pub(crate) rows: RangeInclusive<u32>,
}

impl Default for SheetPart {
    fn default() -> Self {
        Self { sheet: None, columns: Vec::new(), rows: 0..=MOST.1 - 1 }
    }
}

impl SheetPart {
    /// Reads what stands behind `#`. Without `!`, a word is the name of a sheet, and what has a colon is a range.
    pub(crate) fn read(text: &str) -> Result<Self, Text> {
        let text = text.trim();
        let (sheet, ranges) = match text.rsplit_once('!') {
            Some((sheet, ranges)) => (Some(sheet), ranges),
            None if text.contains(':') => (None, text),
            None => (Some(text), ""),
        };
        let sheet =
            sheet.map(|name| name.trim().trim_matches('\'').to_owned()).filter(|name| !name.is_empty());
        let mut part = Self { sheet, ..Self::default() };
        for range in ranges.split(',').filter(|_| !ranges.trim().is_empty()) {
            let (columns, rows) = area(range).ok_or_else(|| {
                Text::new("`{range}` is not a range of cells: write `A:C`, `A,C` or `A2:C40`, with a sheet `Data!A:C`")
                    .with("range", range)
            })?;
            part.columns.push(columns);
            part.rows = rows.unwrap_or(part.rows);
        }
        Ok(part)
    }

    /// True if a cell belongs to it, by its row and column.
    #[cfg(feature = "spreadsheets")]
    pub(crate) fn contains(&self, (row, column): (u32, u32)) -> bool {
        let is_chosen = self.columns.is_empty() || self.columns.iter().any(|range| range.contains(&column));
        is_chosen && self.rows.contains(&row)
    }
}

/// Columns and rows of `A:C`, `B`, `A2:C40` or `A2:C`; without rows, all.
fn area(range: &str) -> Option<(RangeInclusive<u32>, Option<RangeInclusive<u32>>)> {
    let (first, last) = range.split_once(':').unwrap_or((range, range));
    let ((left, top), (right, bottom)) = (corner(first)?, corner(last)?);
    let rows = match (top, bottom) {
        (Some(top), Some(bottom)) => Some(top..=bottom),
        (Some(top), None) => Some(top..=MOST.1 - 1),
        (None, Some(_)) => return None,
        (None, None) => None,
    };
    let is_empty = left > right || rows.as_ref().is_some_and(RangeInclusive::is_empty);
    (!is_empty).then_some((left..=right, rows))
}

/// Column and row of `B`, `B2` or `$B$2`, counted from 0.
fn corner(text: &str) -> Option<(u32, Option<u32>)> {
    let text = text.trim().replace('$', "");
    let letters = text.len() - text.trim_start_matches(|c: char| c.is_ascii_alphabetic()).len();
    let (letters, digits) = text.split_at(letters);
    let column = (1..=3).contains(&letters.len()).then(|| {
        letters
            .bytes()
            .fold(0, |column, letter| 26 * column + u32::from(letter.to_ascii_uppercase() - b'A') + 1)
    })?;
    let row = match digits {
        "" => None,
        digits => Some(digits.parse::<u32>().ok().filter(|row| (1..=MOST.1).contains(row))? - 1),
    };
    (column <= MOST.0).then(|| (column - 1, row))
}

/// Name of a cell, `B7`, from its row and column, counted from 0.
#[cfg(feature = "spreadsheets")]
pub(crate) fn name_of((row, column): (u32, u32)) -> String {
    format!("{}{}", name_of_column(column), row + 1)
}

/// Letters of a column, counted from 0.
pub(crate) fn name_of_column(column: u32) -> String {
    let mut letters = Vec::new();
    let mut left = column + 1;
    while left > 0 {
        letters.push(b'A' + ((left - 1) % 26) as u8);
        left = (left - 1) / 26;
    }
    letters.iter().rev().map(|letter| char::from(*letter)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_are_read_as_spreadsheets_write_them() {
        let part =
            |text: &str| SheetPart::read(text).unwrap_or_else(|why| panic!("{text}: {}", why.english()));
        let named = |sheet: &str| SheetPart { sheet: Some(sheet.to_owned()), ..SheetPart::default() };
        assert_eq!(part("Data"), named("Data"));
        assert_eq!(part("'Run 3'!"), named("Run 3"));
        assert_eq!(part("A:C"), SheetPart { columns: vec![0..=2], ..SheetPart::default() });
        assert_eq!(
            part("Data!$B$2:AA40"),
            SheetPart { columns: vec![1..=26], rows: 1..=39, ..named("Data") }
        );
        assert_eq!(part("Data!C, A:B"), SheetPart { columns: vec![2..=2, 0..=1], ..named("Data") });
        for wrong in ["C:A", "A2:C1", "A0:C4", "Data!A:", "A:XFE", "A:C9", "1:3", "Data!A,,B"] {
            assert!(SheetPart::read(wrong).is_err(), "{wrong}");
        }
    }

    #[cfg(feature = "spreadsheets")]
    #[test]
    fn cells_have_their_names() {
        for (at, name) in [((0, 0), "A1"), ((6, 25), "Z7"), ((6, 26), "AA7"), ((0, 16_383), "XFD1")] {
            assert_eq!(name_of(at), name);
        }
    }
}
