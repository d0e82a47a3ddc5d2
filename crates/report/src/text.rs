//! A document for a terminal or a printer of fixed pitch.

use dalembert_core::printer::WrittenStep;

use crate::{
    document::{Block, Document, DocumentTable, NamedValue},
    wrap::{columns, formula, padded, sentences},
};

/// The least width that is laid out for.
const NARROWEST: usize = 20;

/// The document in lines of at most `width` columns. A formula breaks before an operator and hangs behind its `=`.
pub fn text(document: &Document, width: usize) -> String {
    let width = width.max(NARROWEST);
    let mut page = Page { lines: Vec::new(), width };
    if !document.title.is_empty() {
        page.sentences(&document.title, 0, 0);
        page.line("=".repeat(columns(&document.title).min(width)));
    }
    for block in &document.blocks {
        page.gap(block);
        match block {
            Block::Heading(heading) => {
                page.sentences(heading, 0, 0);
                page.line("-".repeat(columns(heading).min(width)));
            }
            Block::Subheading(heading) => {
                page.sentences(heading, 0, 0);
                page.line("~".repeat(columns(heading).min(width)));
            }
            Block::Paragraph(words) => page.sentences(words, 0, 0),
            Block::Items(items) => {
                for item in items {
                    page.bullet(item);
                }
            }
            Block::TitleBlock(lines) | Block::Lines(lines) => page.pairs(lines),
            Block::Step(number, step) => page.step(*number, step),
            Block::Table(table) => page.table(table),
            Block::Figure(picture) => page.lines.extend(picture.letters.iter().cloned()),
        }
    }
    let mut text = page.lines.join("\n");
    text.push('\n');
    text
}

struct Page {
    lines: Vec<String>,
    width: usize,
}

impl Page {
    fn line(&mut self, line: impl Into<String>) {
        let line: String = line.into();
        self.lines.push(line.trim_end().to_owned());
    }

    /// A blank line before a block, but not right under a heading.
    fn gap(&mut self, block: &Block) {
        let under_heading = self.lines.len() >= 2 && self.lines.last().is_some_and(|last| is_rule(last));
        let wanted = match block {
            Block::Heading(_)
            | Block::Subheading(_)
            | Block::Paragraph(_)
            | Block::Step(..)
            | Block::Table(_) => !under_heading,
            Block::Figure(picture) => !picture.letters.is_empty(),
            Block::TitleBlock(_) | Block::Lines(_) | Block::Items(_) => false,
        };
        if wanted && !self.lines.is_empty() {
            self.lines.push(String::new());
        }
    }

    fn sentences(&mut self, words: &str, indent: usize, hang: usize) {
        let room = self.width.saturating_sub(indent + hang).max(1);
        for (n, line) in sentences(words, room).into_iter().enumerate() {
            let indent = if n == 0 { indent } else { indent + hang };
            self.line(format!("{}{line}", " ".repeat(indent)));
        }
    }

    fn bullet(&mut self, words: &str) {
        let first = self.lines.len();
        self.sentences(words, 4, 0);
        if let Some(line) = self.lines.get_mut(first) {
            line.replace_range(..4.min(line.len()), "  - ");
        }
    }

    /// Labels, symbols and values in columns; a value without room goes under its label.
    fn pairs(&mut self, lines: &[NamedValue]) {
        let widest = |of: &dyn Fn(&NamedValue) -> usize| lines.iter().map(of).max().unwrap_or(0);
        let most = self.width / 2;
        let label_columns = widest(&|line| match 2 * line.depth + columns(&line.label) {
            label if label <= most && !line.value.is_empty() => label,
            _ => 0,
        });
        let symbol_columns = widest(&|line| columns(&line.symbol));
        for line in lines {
            let indent = 2 + 2 * line.depth;
            let mut head = format!("{}{}", " ".repeat(indent), line.label);
            if line.value.is_empty() {
                self.sentences(&line.label, indent, 2);
                continue;
            }
            if columns(&head) > 2 + label_columns {
                self.sentences(&line.label, indent, 2);
                head.clear();
            }
            let mut head = format!("{}  ", padded(&head, 2 + label_columns));
            if symbol_columns > 0 {
                let blanks = " ".repeat(symbol_columns - columns(&line.symbol));
                head +=
                    &format!("{blanks}{} {} ", line.symbol, if line.symbol.is_empty() { ' ' } else { '=' });
            }
            let value_at = columns(&head);
            for part in sentences(&line.value, self.width.saturating_sub(value_at).max(1)) {
                self.line(format!("{head}{part}"));
                head = " ".repeat(value_at);
            }
        }
    }

    fn step(&mut self, number: usize, step: &WrittenStep) {
        let source = if step.source.is_empty() { String::new() } else { format!(" [{}]", step.source) };
        let head = format!("{number}. ");
        self.sentences(&format!("{head}{}{source}", step.why), 0, columns(&head));
        let indent = 4;
        let symbol = columns(&step.symbol);
        let sides = [&step.formula, &step.substitution, &step.result];
        for (n, side) in sides.into_iter().filter(|side| !side.is_empty()).enumerate() {
            let head = if n == 0 { step.symbol.clone() } else { " ".repeat(symbol) };
            let head = format!("{}{head} = ", " ".repeat(indent));
            // A hanging line begins with its operator, two columns behind the equals sign.
            let room = self.width.saturating_sub(columns(&head)).max(1);
            for (n, line) in formula(side, room, 2).into_iter().enumerate() {
                let head = if n == 0 { head.clone() } else { " ".repeat(columns(&head) + 2) };
                self.line(format!("{head}{line}"));
            }
        }
        if !step.terms.is_empty() {
            let terms = step.terms.iter().map(|(term, value)| NamedValue {
                depth: 2,
                label: term.clone(),
                value: value.clone(),
                ..NamedValue::default()
            });
            self.pairs(&terms.collect::<Vec<_>>());
        }
    }

    /// A table; columns without room follow under it, behind the first column again.
    fn table(&mut self, table: &DocumentTable) {
        if !table.title.is_empty() {
            self.sentences(&table.title, 0, 0);
        }
        let cells = |at: usize| {
            let rows = table.rows.iter().chain(Some(&table.foot).filter(|foot| !foot.is_empty()));
            rows.map(move |row| row.get(at).map_or(0, |cell| columns(cell)))
        };
        let widths: Vec<usize> = (0..table.columns.len())
            .map(|at| cells(at).max().unwrap_or(0).max(columns(&table.columns[at])))
            .collect();
        let mut next = 0;
        while next < widths.len() {
            let mut shown = if next == 0 { Vec::new() } else { vec![0] };
            let mut used = shown.iter().map(|at| widths[*at] + 2).sum::<usize>();
            while next < widths.len()
                && (used + widths[next] + 2 <= self.width || shown.len() <= usize::from(used > 0))
            {
                used += widths[next] + 2;
                shown.push(next);
                next += 1;
            }
            self.part(table, &widths, &shown);
        }
    }

    fn part(&mut self, table: &DocumentTable, widths: &[usize], shown: &[usize]) {
        let row = |cells: &[String]| -> String {
            let cells = shown.iter().map(|&at| {
                let cell = cells.get(at).map_or("", String::as_str);
                let blanks = " ".repeat(widths[at].saturating_sub(columns(cell)));
                if table.numeric.get(at) == Some(&true) {
                    format!("  {blanks}{cell}")
                } else {
                    format!("  {cell}{blanks}")
                }
            });
            cells.collect()
        };
        let rule =
            shown.iter().map(|at| format!("  {}", "-".repeat(widths[*at]))).collect::<Vec<_>>().concat();
        self.line(row(&table.columns));
        self.line(rule.clone());
        for cells in &table.rows {
            self.line(row(cells));
        }
        if !table.foot.is_empty() {
            self.line(rule);
            self.line(row(&table.foot));
        }
    }
}

fn is_rule(line: &str) -> bool {
    !line.is_empty() && ['-', '=', '~'].iter().any(|rule| line.chars().all(|c| c == *rule))
}
