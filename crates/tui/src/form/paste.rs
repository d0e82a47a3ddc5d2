//! A block of cells that is pasted on rows, as from a spreadsheet.

use dalembert_core::{Draft, Shape};
use dalembert_units::Decimal;

use super::{Change, Form, FormLine, Role, as_line, lines, row_of, rows_mut, settled};

/// So many rows are filled at once: more numbers than these belong in a table.
const MOST_ROWS: usize = 1_000;

/// Result of pasting a block.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Filled {
    /// Rows that took something.
    pub rows: usize,
    /// True if the first line was a heading, which is skipped.
    pub heading: bool,
    /// Cells that lie right of the last field of their row, and are left out.
    pub cells: usize,
    /// Lines beyond the most rows that are filled at once, which are left out.
    pub lines: usize,
    /// True if anything changed.
    pub changed: bool,
}

impl Form {
    /// Fills rows with the cells of a pasted text: from the field under the cursor down and to the right, on the heading
    /// of a list from its first field. Rows are added as they are needed. `None` where the cursor is in no list, or
    /// what is pasted is one cell for one field.
    pub fn fill(&mut self, pasted: &str, decimal: Decimal) -> Option<Filled> {
        let line = self.line()?;
        let on_list = matches!(line.role, Role::Rows { .. });
        let text = pasted.replace("\r\n", "\n").replace('\r', "\n");
        let text = text.trim_matches('\n');
        if text.trim().is_empty() || !(on_list || text.contains(['\n', '\t'])) {
            return None;
        }
        let (list, first) = match row_of(&line.path) {
            _ if on_list => (line.path.clone(), 0),
            row => row.and_then(|row| Some((row.list, row.at?)))?,
        };
        let all = self.all_lines();
        let column = match all.iter().position(|other| other.path == line.path) {
            Some(at) if !on_list => fields_of(&all[..at], &list, first).len(),
            _ => 0,
        };
        let mut block: Vec<Vec<String>> =
            text.split('\n').map(|line| line.split('\t').map(|cell| as_line(cell).0).collect()).collect();
        let heading = block.len() > 1 && is_heading(&block[0], fields_of(&all, &list, first).get(column..));
        if heading {
            block.remove(0);
        }
        let mut filled =
            Filled { heading, lines: block.len().saturating_sub(MOST_ROWS), ..Filled::default() };
        block.truncate(MOST_ROWS);
        self.left.clear();
        filled.changed = self.change(Change::Other, |draft, shape| {
            let (rows, of) = rows_mut(draft, shape, &list)?;
            let Shape::Rows { item, most, .. } = of else { return None };
            let taken = block.len().min(most.saturating_sub(first));
            filled.lines += block.len() - taken;
            block.truncate(taken);
            while rows.len() < first + block.len() {
                rows.push(Draft::blank(item()).with_first_alternatives(item()));
            }
            let all = lines(shape, draft);
            for (n, cells) in block.iter().enumerate() {
                let fields = fields_of(&all, &list, first + n);
                for (k, cell) in cells.iter().enumerate() {
                    match fields.get(column + k) {
                        Some((path, of)) => {
                            let text = settled(cell.clone(), of, decimal);
                            *draft.at_mut(shape, path).ok()?.0 = Draft::Leaf(text);
                        }
                        // A line may end in separators.
                        None => filled.cells += usize::from(!cell.is_empty()),
                    }
                }
                filled.rows += 1;
            }
            Some(())
        });
        Some(filled)
    }
}

/// The fields of one line of a row, in their order; those of lists within it are not among them.
fn fields_of<'l>(all: &'l [FormLine], list: &str, row: usize) -> Vec<(&'l str, Shape)> {
    let row = format!("{list}[{}]", row + 1);
    let of_row = |line: &'l FormLine| {
        let rest = line.path.strip_prefix(&row)?;
        let own = !rest.contains('[') && (rest.is_empty() || rest.starts_with('.'));
        match line.role {
            Role::Leaf { shape, .. } if own => Some((line.path.as_str(), shape)),
            _ => None,
        }
    };
    all.iter().filter_map(of_row).collect()
}

/// Returns true if cells are the names of columns: none of those above numbers begins with one.
fn is_heading(cells: &[String], fields: Option<&[(&str, Shape)]>) -> bool {
    let takes_numbers = |shape: &Shape| {
        matches!(shape.present(), Shape::Quantity(_) | Shape::Vector(..) | Shape::Count { .. })
    };
    let numbers: Vec<&String> = cells
        .iter()
        .zip(fields.unwrap_or_default())
        .filter(|(cell, (_, shape))| takes_numbers(shape) && !cell.is_empty())
        .map(|(cell, _)| cell)
        .collect();
    let begins = |c: char| c.is_ascii_digit() || "+-−.,(√π".contains(c);
    !numbers.is_empty() && numbers.iter().all(|cell| !cell.starts_with(begins) && !cell.starts_with("pi"))
}
