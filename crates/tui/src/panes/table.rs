//! A table of a solution, in aligned columns.

use dalembert_core::{Cell, Column, Locale, TableExhibit};
use dalembert_units::{Style as Digits, Unit, unit, write_number};
use ratatui::{
    style::Style,
    text::{Line, Span},
};
use unicode_width::UnicodeWidthStr;

use super::{
    columns::{Aligned, number, padded, widths},
    wrap,
};
use crate::look::{Glyph, Look};

/// Cells between two columns.
const GAP: usize = 2;

/// The table: its columns side by side as far as the width goes; the others below, after the first column again.
pub fn lines(table: &TableExhibit, look: &Look, locale: &Locale, width: u16) -> Vec<Line<'static>> {
    let width = usize::from(width).max(1);
    let locale = &Locale { style: Digits { ascii: look.ascii, ..locale.style }, ..*locale };
    let title = wrap::words(&table.title.render(locale), width);
    let mut lines: Vec<Line<'static>> =
        title.into_iter().map(|line| Line::styled(line, look.title())).collect();
    let columns: Vec<Written> = table
        .columns
        .iter()
        .enumerate()
        .map(|(n, column)| Written::of(column, n, table, look, locale, width))
        .collect();
    for block in blocks(&columns, width) {
        lines.push(Line::default());
        lines.extend(written(&block, table.rows.len(), look));
    }
    lines
}

/// A column as it is written, every cell as wide as the column.
struct Written {
    heading: String,
    unit: String,
    cells: Vec<String>,
    foot: Option<String>,
    width: usize,
}

impl Written {
    fn of(
        column: &Column,
        n: usize,
        table: &TableExhibit,
        look: &Look,
        locale: &Locale,
        most: usize,
    ) -> Self {
        let unit = unit(column.unit).unwrap_or(Unit::ONE);
        let text = |row: &Vec<Cell>| match row.get(n) {
            None | Some(Cell::Empty) => (String::new(), false),
            Some(Cell::Number(si)) => (write_number(unit.value(*si), locale.style), true),
            Some(Cell::Text(text)) => (text.render(locale), false),
        };
        let rows: Vec<(String, bool)> = table.rows.iter().chain([&table.foot]).map(text).collect();
        let aligned = |(text, is_number): &(String, bool)| is_number.then(|| Aligned::of(text));
        let numbers: Vec<Option<Aligned>> = rows.iter().map(aligned).collect();
        let number_widths = widths(numbers.iter().flatten());
        let shown = if look.ascii { unit.ascii() } else { unit.pretty() };
        let shown = if shown.is_empty() { shown } else { format!("[{shown}]") };
        let heading = column.heading.render(locale);
        let texts = rows.iter().filter(|(_, is_number)| !is_number).map(|(text, _)| text.width());
        let width = texts
            .chain([heading.width(), shown.width(), number_widths.0 + number_widths.1])
            .max()
            .unwrap_or(0);
        let width = width.min(most);
        let has_numbers = numbers.iter().any(Option::is_some);
        let set = |text: &str| {
            let text = look.shortened(text, width);
            let gap = " ".repeat(width - text.width());
            // Headings stand over their numbers, at the right.
            if has_numbers { format!("{gap}{text}") } else { format!("{text}{gap}") }
        };
        let mut cells: Vec<String> = rows
            .iter()
            .zip(&numbers)
            .map(|((text, _), aligned)| match aligned {
                Some(aligned) => set(&number(aligned, number_widths)),
                None => padded(&look.shortened(text, width), width),
            })
            .collect();
        let foot = cells.pop().filter(|_| !table.foot.is_empty());
        Self { heading: set(&heading), unit: set(&shown), cells, foot, width }
    }
}

/// Columns that fit side by side; every block begins with the first column.
fn blocks(columns: &[Written], width: usize) -> Vec<Vec<&Written>> {
    let Some((first, others)) = columns.split_first() else { return Vec::new() };
    let mut blocks = vec![vec![first]];
    let mut used = first.width;
    for column in others {
        let block = blocks.last_mut().filter(|_| used + GAP + column.width <= width);
        match block {
            Some(block) => {
                block.push(column);
                used += GAP + column.width;
            }
            // Where not even two columns fit, the first is not said again.
            None if first.width + GAP + column.width > width => {
                blocks.push(vec![column]);
                used = column.width;
            }
            None => {
                blocks.push(vec![first, column]);
                used = first.width + GAP + column.width;
            }
        }
    }
    blocks
}

fn written(block: &[&Written], rows: usize, look: &Look) -> Vec<Line<'static>> {
    let row = |cell: &dyn Fn(&Written) -> String, style: Style| {
        let cells: Vec<String> = block.iter().map(|column| cell(column)).collect();
        Line::from(Span::styled(cells.join(&" ".repeat(GAP)).trim_end().to_owned(), style))
    };
    let width = block.iter().map(|column| column.width).sum::<usize>() + GAP * (block.len() - 1);
    let rule = || Line::styled(look.glyph(Glyph::Rule).repeat(width), look.dim());
    let mut lines = vec![row(&|column| column.heading.clone(), look.title())];
    if block.iter().any(|column| !column.unit.trim().is_empty()) {
        lines.push(row(&|column| column.unit.clone(), look.dim()));
    }
    lines.push(rule());
    lines.extend((0..rows).map(|n| row(&|column| column.cells[n].clone(), Style::new())));
    if block.iter().any(|column| column.foot.is_some()) {
        lines.push(rule());
        lines.push(row(&|column| column.foot.clone().unwrap_or_default(), look.answer()));
    }
    lines
}
