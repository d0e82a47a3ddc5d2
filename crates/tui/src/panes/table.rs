//! A table of a solution, in aligned columns.

use dalembert_core::{Cell, Column, Locale, TableExhibit};
use dalembert_units::{Unit, unit, write_number};
use ratatui::{
    style::Style,
    text::{Line, Span},
};
use unicode_width::UnicodeWidthStr;

use super::{
    columns::{Aligned, number, padded, widths},
    reasons, wrap,
};
use crate::{
    look::{Appearance, Glyph},
    pane::{Page, Pane, Ui, register_pane},
    problem::Problem,
};

/// The pane of tables.
#[derive(Debug, Default)]
pub struct Table;

register_pane!(Table, 50);

impl Pane for Table {
    fn name(&self) -> &'static str {
        "Table"
    }

    fn is_useful(&self, problem: &Problem) -> bool {
        problem.tables().next().is_some()
    }

    fn page(&self, problem: &Problem, ui: &Ui<'_>, width: u16) -> Page {
        if problem.found.revealed.is_some() {
            return reasons::covered(ui, width);
        }
        if problem.hides_numbers() {
            return Page::of(reasons::why_not(problem, ui, width));
        }
        let mut all = Vec::new();
        for table in problem.tables() {
            if !all.is_empty() {
                all.push(Line::default());
            }
            all.extend(lines(table, ui.look, ui.locale, width));
        }
        match (all.is_empty(), problem.is_stale()) {
            (true, _) => reasons::nothing(problem, ui, width),
            (false, true) => Page::of(reasons::stale(all, ui.look, ui.locale, width)),
            (false, false) => Page::of(all),
        }
    }
}

/// Cells between two columns.
const GAP: usize = 2;

/// The least width of the first column, which names the rows, where its names are longer and the width is scarce.
const NAMES: usize = 12;

/// The table: its columns side by side as far as the width goes; the others below, after the first column again.
/// Where the names of the rows and a column do not fit side by side, heading and names go on below.
pub fn lines(table: &TableExhibit, look: &Appearance, locale: &Locale, width: u16) -> Vec<Line<'static>> {
    let width = usize::from(width).max(1);
    let locale = &locale.ascii(look.ascii);
    let title = wrap::words(&table.title.render(locale), width);
    let mut lines: Vec<Line<'static>> =
        title.into_iter().map(|line| Line::styled(line, look.title())).collect();
    let written_in = |n: usize, most: usize| Written::of(n, table, look, locale, (most, width));
    let names = if table.columns.is_empty() { 0 } else { written_in(0, width).width };
    let share = names.min(NAMES.max(width / 2));
    let beside = width.saturating_sub(share + GAP);
    let others: Vec<Written> = (1..table.columns.len()).map(|n| written_in(n, beside)).collect();
    for block in blocks(&others, share, width) {
        let left = width.saturating_sub(block.iter().map(|column| GAP + column.width).sum());
        // Where numbers leave no room for names, they stand alone.
        let first = (names > 0 && left >= names.min(2)).then(|| written_in(0, left));
        let block: Vec<&Written> = first.iter().chain(block.iter().copied()).collect();
        lines.push(Line::default());
        lines.extend(written(&block, table.rows.len(), look));
    }
    lines
}

/// A column as it is written, every cell as wide as the column.
struct Written {
    heading: Vec<String>,
    unit: String,
    /// The lines of each cell: a text may need several.
    cells: Vec<Vec<String>>,
    foot: Option<Vec<String>>,
    width: usize,
}

impl Written {
    /// In no more than `most` cells where its numbers and unit allow it, in no more than `whole` at all.
    fn of(
        n: usize,
        table: &TableExhibit,
        look: &Appearance,
        locale: &Locale,
        (most, whole): (usize, usize),
    ) -> Self {
        let column: &Column = &table.columns[n];
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
        let shown = unit.shown(look.ascii);
        let shown = if shown.is_empty() { shown } else { format!("[{shown}]") };
        let heading = column.heading.render(locale);
        let texts = rows.iter().filter(|(_, is_number)| !is_number).map(|(text, _)| text.width());
        let least = shown.width().max(number_widths.0 + number_widths.1);
        let width = texts.chain([heading.width(), least]).max().unwrap_or(0);
        let width = width.min(most.max(least)).min(whole);
        let has_numbers = numbers.iter().any(Option::is_some);
        let set = |text: &str| {
            let text = look.shortened(text, width);
            let gap = " ".repeat(width - text.width());
            // Headings stand over their numbers, at the right.
            if has_numbers { format!("{gap}{text}") } else { format!("{text}{gap}") }
        };
        let mut cells: Vec<Vec<String>> = rows
            .iter()
            .zip(&numbers)
            .map(|((text, _), aligned)| match aligned {
                Some(aligned) => vec![set(&number(aligned, number_widths))],
                None => wrap::words(text, width).iter().map(|line| padded(line, width)).collect(),
            })
            .collect();
        let foot = cells.pop().filter(|_| !table.foot.is_empty());
        let heading = wrap::words(&heading, width).iter().map(|line| set(line)).collect();
        Self { heading, unit: set(&shown), cells, foot, width }
    }
}

/// Columns that fit side by side after names of that width; at least one block, at least one column in the others.
fn blocks(columns: &[Written], names: usize, width: usize) -> Vec<Vec<&Written>> {
    let mut blocks = vec![Vec::new()];
    let mut used = names;
    for column in columns {
        match blocks.last_mut() {
            Some(block) if block.is_empty() || used + GAP + column.width <= width => block.push(column),
            _ => {
                blocks.push(vec![column]);
                used = names;
            }
        }
        used += GAP + column.width;
    }
    blocks
}

fn written(block: &[&Written], rows: usize, look: &Appearance) -> Vec<Line<'static>> {
    let row = |cell: &dyn Fn(&Written) -> String, style: Style| {
        let cells: Vec<String> = block.iter().map(|column| cell(column)).collect();
        Line::from(Span::styled(cells.join(&" ".repeat(GAP)).trim_end().to_owned(), style))
    };
    let width = block.iter().map(|column| column.width).sum::<usize>() + GAP * block.len().saturating_sub(1);
    let rule = || Line::styled(look.glyph(Glyph::Rule).repeat(width), look.dim());
    // Headings and cells of several lines end in the same row.
    let level = |cell: &dyn Fn(&Written) -> &[String], style: Style| {
        let high = block.iter().map(|column| cell(column).len()).max().unwrap_or(0);
        let line = move |column: &Written, n: usize, cell: &dyn Fn(&Written) -> &[String]| {
            let own = cell(column);
            let line = (n + own.len()).checked_sub(high).and_then(|n| own.get(n));
            line.cloned().unwrap_or_else(|| " ".repeat(column.width))
        };
        (0..high).map(|n| row(&|column| line(column, n, cell), style)).collect::<Vec<Line>>()
    };
    let mut lines = level(&|column| &column.heading, look.title());
    if block.iter().any(|column| !column.unit.trim().is_empty()) {
        lines.push(row(&|column| column.unit.clone(), look.dim()));
    }
    lines.push(rule());
    lines.extend((0..rows).flat_map(|n| level(&|column| &column.cells[n], Style::new())));
    if block.iter().any(|column| column.foot.is_some()) {
        lines.push(rule());
        lines.extend(level(&|column| column.foot.as_deref().unwrap_or_default(), look.answer()));
    }
    lines
}
