//! Document: content of a report, independent of its format.

use dalembert_core::{Locale, Text, file::TitleBlock, printer::WrittenStep};

use crate::{
    figure::picture::{Picture, PictureElement},
    math::{lowered, raised},
};

/// A text with headings, lists, steps and tables, every word of it in one language.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Document {
    /// Title.
    pub title: String,
    /// Blocks, in reading order.
    pub blocks: Vec<Block>,
}

/// A part of a document.
#[derive(Clone, Debug, PartialEq)]
pub enum Block {
    /// Title block: project, author, date.
    TitleBlock(Vec<NamedValue>),
    /// The heading of what follows.
    Heading(String),
    /// The heading of a part of what stands under a heading.
    Subheading(String),
    /// Sentences.
    Paragraph(String),
    /// Names with values, in columns.
    Lines(Vec<NamedValue>),
    /// Sentences that do not follow from one another.
    Items(Vec<String>),
    /// A step of a worked solution, and its number.
    Step(usize, WrittenStep),
    /// Rows and columns.
    Table(DocumentTable),
    /// A plot or a drawing.
    Figure(Picture),
}

/// A name with a value, within others.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct NamedValue {
    /// Nesting depth.
    pub depth: usize,
    /// Symbol in formulas; may be empty.
    pub symbol: String,
    /// Label.
    pub label: String,
    /// Value; empty for a heading of the lines within.
    pub value: String,
}

/// Rows and columns.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct DocumentTable {
    /// Title; may be empty.
    pub title: String,
    /// The headings.
    pub columns: Vec<String>,
    /// True for each column of numbers, which is aligned right.
    pub numeric: Vec<bool>,
    /// The rows, each as long as `columns`.
    pub rows: Vec<Vec<String>>,
    /// The sums; empty where there are none.
    pub foot: Vec<String>,
}

impl Document {
    /// Pictures of the figures.
    pub fn pictures(&self) -> impl Iterator<Item = &Picture> {
        self.blocks.iter().filter_map(|block| match block {
            Block::Figure(picture) => Some(picture),
            _ => None,
        })
    }

    /// Figures as files: the name of each, which begins with `stem`, and its SVG.
    pub fn figures(&self, stem: &str) -> Vec<(String, String)> {
        self.pictures().enumerate().map(|(n, picture)| (figure_name(stem, n + 1), picture.svg())).collect()
    }

    /// The same document under the title block of a problem file.
    #[must_use]
    pub fn under(mut self, title_block: &TitleBlock, locale: &Locale) -> Self {
        let line = |(label, text): (Text, &str)| NamedValue {
            label: label.render(locale),
            value: text.to_owned(),
            ..NamedValue::default()
        };
        let lines: Vec<NamedValue> = title_block.lines().map(line).collect();
        if !lines.is_empty() {
            self.blocks.insert(0, Block::TitleBlock(lines));
        }
        self
    }

    /// The same document with every text passed through `change`.
    #[must_use]
    pub fn map(self, change: &impl Fn(&str) -> String) -> Self {
        let blocks = self.blocks.into_iter().map(|block| block.map(change)).collect();
        Self { title: change(&self.title), blocks }
    }
}

impl Block {
    fn map(self, change: &impl Fn(&str) -> String) -> Self {
        let all = |texts: Vec<String>| texts.iter().map(|text| change(text)).collect::<Vec<_>>();
        let named = |lines: Vec<NamedValue>| {
            let line = |line: NamedValue| NamedValue {
                depth: line.depth,
                symbol: change(&line.symbol),
                label: change(&line.label),
                value: change(&line.value),
            };
            lines.into_iter().map(line).collect()
        };
        match self {
            Block::Heading(text) => Block::Heading(change(&text)),
            Block::Subheading(text) => Block::Subheading(change(&text)),
            Block::Paragraph(text) => Block::Paragraph(change(&text)),
            Block::Items(items) => Block::Items(all(items)),
            Block::TitleBlock(lines) => Block::TitleBlock(named(lines)),
            Block::Lines(lines) => Block::Lines(named(lines)),
            Block::Step(number, step) => Block::Step(number, step.map(change)),
            Block::Table(table) => Block::Table(DocumentTable {
                title: change(&table.title),
                columns: all(table.columns),
                numeric: table.numeric,
                rows: table.rows.into_iter().map(all).collect(),
                foot: all(table.foot),
            }),
            Block::Figure(mut picture) => {
                picture.title = change(&picture.title);
                picture.letters = all(picture.letters);
                for part in &mut picture.parts {
                    if let PictureElement::Words { text, .. } = part {
                        *text = change(text);
                    }
                }
                Block::Figure(picture)
            }
        }
    }
}

/// True if this line is the heading of those that follow.
pub(crate) fn is_heading(lines: &[NamedValue], at: usize) -> bool {
    lines[at].value.is_empty() && lines.get(at + 1).is_some_and(|next| next.depth > lines[at].depth)
}

/// Rows of a table that is kept on one page.
pub(crate) const SHORT_TABLE: usize = 20;

/// Estimated width of a letter beside that of a digit.
fn breadth(letter: char) -> f64 {
    match letter {
        'm' | 'w' | 'M' | 'W' | '×' | '−' | '+' | '=' | '±' | '≈' | '≤' | '≥' | '→' => 1.7,
        'A'..='Z' | '%' | 'ω' | 'Σ' => 1.4,
        'i' | 'j' | 'l' | '.' | ',' | ':' | ';' | '\'' | '|' => 0.6,
        '⁻' => 1.2,
        _ if lowered(letter).is_some() || raised(letter).is_some() => 0.9,
        _ => 1.0,
    }
}

/// Estimated widths of the columns of a table, in digits: of each the widest cell, and the longest word of its heading; and
/// those that the table has where `room` digits are wider than it is: text is wrapped, numbers are not.
pub(crate) fn column_widths(table: &DocumentTable, room: f64) -> Vec<f64> {
    let letters = |text: &str| text.chars().map(breadth).sum::<f64>();
    let longest_word = |text: &str| text.split_whitespace().map(letters).fold(0.0, f64::max);
    let column = |at: usize| {
        let cells = || table.rows.iter().chain([&table.foot]).filter_map(move |row| row.get(at));
        let heading = table.columns.get(at).map_or("", String::as_str);
        let is_number = table.numeric.get(at) == Some(&true);
        let cell = |of: &dyn Fn(&str) -> f64| cells().map(|cell| of(cell)).fold(0.0, f64::max);
        let least = if is_number { cell(&letters) } else { cell(&longest_word) };
        (least.max(1.08 * longest_word(heading)).max(2.0), cell(&letters).max(letters(heading)).max(2.0))
    };
    let columns: Vec<(f64, f64)> = (0..table.columns.len()).map(column).collect();
    let (least, wanted) =
        columns.iter().fold((0.0, 0.0), |(least, wanted), one| (least + one.0, wanted + one.1));
    if wanted <= room {
        return columns.into_iter().map(|(_, wanted)| wanted).collect();
    }
    // What is left beside the least widths goes to the columns that want more.
    let share = ((room - least) / (wanted - least).max(1.0)).clamp(0.0, 1.0);
    columns.into_iter().map(|(least, wanted)| least + share * (wanted - least)).collect()
}

/// The name of the file of a figure, counted from 1.
pub(crate) fn figure_name(stem: &str, number: usize) -> String {
    format!("{stem}-{number}.svg")
}
