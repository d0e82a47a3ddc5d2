//! The lines of a page: what to do, what is asked, and what was found.

use dalembert_core::Text;
use ratatui::{
    style::{Modifier, Style},
    text::{Line, Span},
};

use crate::{
    field::{self, Choice, FieldLine, FieldMode, FieldPage, LineKind, Tone},
    glyphs::filter_untrusted,
    look::Glyph,
    model::Model,
    problem::Problem,
    text::{fit, padded, width, wrapped},
};

/// Columns before and after a label.
const AROUND: usize = 4;
/// The fewest columns of the labels.
const LABEL: usize = 10;
/// Columns of a field that is empty.
const BLANK: usize = 14;
/// Columns before options that stand below their label.
const BELOW: usize = 6;
/// In fewer columns the picture says what the sentence does.
const LITTLE: usize = 32;

/// The text of a page, the line that has the keys, and the column of the cursor in it, where it is one of text.
#[derive(Default)]
pub(super) struct Page {
    pub(super) lines: Vec<Line<'static>>,
    pub(super) focus: usize,
    pub(super) cursor: Option<usize>,
}

/// A page in the making.
struct Writer<'a> {
    model: &'a Model,
    problem: &'a Problem,
    field: &'a FieldMode,
    room: usize,
    page: Page,
}

impl Page {
    /// The page that is shown, in lines of so many columns.
    pub(super) fn of(model: &Model, problem: &Problem, field: &FieldMode, room: usize) -> Self {
        let mut writer = Writer { model, problem, field, room, page: Page::default() };
        writer.write();
        writer.page
    }

    /// The first line that is shown: the one that has the keys is in sight.
    pub(super) fn first(&self, height: usize) -> usize {
        (self.focus + 2).saturating_sub(height).min(self.lines.len().saturating_sub(height))
    }
}

impl Writer<'_> {
    fn write(&mut self) {
        let (page, locale) = (self.field.page, &self.model.locale);
        let title = field::title(page, false).render(locale);
        self.push(Line::styled(title, self.model.look.title()));
        if page != FieldPage::Instrument || self.room >= LITTLE {
            let task = field::task(self.problem, page, locale).render(locale);
            self.page.lines.extend(wrapped(&filter_untrusted(&task), self.room).into_iter().map(Line::from));
        }
        // What to do stands before the lines, what follows from them behind.
        let is_before = |tone: Tone| match tone {
            Tone::Order | Tone::Detail => true,
            Tone::Plain => matches!(page, FieldPage::Trial(_) | FieldPage::Report),
            _ => page == FieldPage::Report,
        };
        let (before, behind): (Vec<_>, Vec<_>) =
            field::remarks(self.problem, page, locale).into_iter().partition(|(tone, _)| is_before(*tone));
        if page == FieldPage::Report {
            self.gap();
        }
        self.remarks(&before);
        // Where pictures stand below the text, every line counts.
        let is_close = matches!(page, FieldPage::Correction(_));
        if !is_close {
            self.gap();
        }
        self.lines(is_close);
        if !behind.is_empty() && !is_close {
            self.gap();
        }
        self.remarks(&behind);
    }

    fn push(&mut self, line: impl Into<Line<'static>>) {
        self.page.lines.push(line.into());
    }

    fn gap(&mut self) {
        self.push(Line::default());
    }

    fn remarks(&mut self, remarks: &[(Tone, Text)]) {
        let look = &self.model.look;
        for (tone, text) in remarks {
            let (head, style) = match tone {
                Tone::Plain => (String::new(), Style::new()),
                Tone::Detail => ("  ".to_owned(), look.dim()),
                Tone::Order => (format!("{} ", look.glyph(Glyph::Bullet)), look.answer()),
                Tone::Good => (format!("{} ", look.glyph(Glyph::Good)), look.good()),
                Tone::Warning => (format!("{} ", look.glyph(Glyph::Warning)), look.warning()),
                Tone::Wrong => (format!("{} ", look.glyph(Glyph::Bad)), look.error()),
            };
            let hang = width(&head);
            let text = filter_untrusted(&text.render(&self.model.locale)).into_owned();
            for (n, line) in wrapped(&text, self.room.saturating_sub(hang)).into_iter().enumerate() {
                let before = if n == 0 { head.clone() } else { " ".repeat(hang) };
                self.push(Line::styled(before + &line, style));
            }
        }
    }

    /// The lines that are asked; the way on stands apart, unless every line counts.
    fn lines(&mut self, is_close: bool) {
        let all = self.field.lines(self.problem);
        let label = self.label_width(&all);
        let is_way_on = |line: &FieldLine| matches!(line.kind, LineKind::Go(_));
        for (n, line) in all.iter().enumerate() {
            if !is_close && n > 0 && is_way_on(line) && !is_way_on(&all[n - 1]) {
                self.gap();
            }
            let is_here = n == self.field.line;
            match &line.kind {
                LineKind::Go(_) => self.way_on(line, is_here),
                LineKind::Choice(choice, options) => self.choice(line, (*choice, options), label, is_here),
                _ if is_here => self.typed(line, label),
                _ => self.answered(line, label),
            }
        }
    }

    /// Columns of the labels: as they need, where the values have room behind them.
    fn label_width(&self, lines: &[FieldLine]) -> usize {
        let named = || lines.iter().filter(|line| !matches!(line.kind, LineKind::Go(_)));
        let label = named().map(|line| width(&line.label.render(&self.model.locale))).max().unwrap_or(0);
        let value = named().map(|line| width(&self.written(line))).max().unwrap_or(0);
        label.min(self.room.saturating_sub(value + AROUND).max(LABEL))
    }

    fn written(&self, line: &FieldLine) -> String {
        let text = field::written(self.problem, line, self.model.locale.style);
        filter_untrusted(&text).into_owned()
    }

    /// The pointer and the label of a line.
    fn head(&self, line: &FieldLine, label: usize, is_here: bool) -> Vec<Span<'static>> {
        let look = &self.model.look;
        let pointer = if is_here { look.glyph(Glyph::Pointer) } else { " " };
        let style = if is_here { look.title() } else { Style::new() };
        let name = line.label.render(&self.model.locale);
        vec![
            Span::styled(format!("{pointer} "), look.key()),
            Span::styled(padded(&name, label, look), style),
            Span::raw("  "),
        ]
    }

    fn way_on(&mut self, line: &FieldLine, is_here: bool) {
        let look = &self.model.look;
        let name = fit(&line.label.render(&self.model.locale), self.room.saturating_sub(AROUND), look);
        let (pointer, style) =
            if is_here { (look.glyph(Glyph::Pointer), look.focus()) } else { (" ", look.dim()) };
        if is_here {
            self.page.focus = self.page.lines.len();
        }
        let spans =
            vec![Span::styled(format!("{pointer} "), look.key()), Span::styled(format!(" {name} "), style)];
        self.push(spans);
    }

    /// A choice: its options behind the label, or below it where they have no room there.
    fn choice(
        &mut self,
        line: &FieldLine,
        (choice, options): (Choice, &[Text]),
        label: usize,
        is_here: bool,
    ) {
        let names: Vec<String> = options.iter().map(|option| option.render(&self.model.locale)).collect();
        let longest = names.iter().map(|name| width(name)).max().unwrap_or(0);
        let behind = label + AROUND;
        let is_behind = behind + longest + 2 <= self.room;
        let begins = if is_behind { behind } else { BELOW };
        let chosen = field::option(self.problem, choice);
        let rows = if is_here {
            self.options(&names, chosen, self.room.saturating_sub(begins))
        } else {
            let text = chosen.and_then(|at| names.get(at)).cloned();
            vec![vec![Span::raw(text.unwrap_or_else(|| self.model.look.glyph(Glyph::Dot).to_owned()))]]
        };
        if is_here {
            self.page.focus = self.page.lines.len();
        }
        let mut head = Some(self.head(line, label, is_here));
        if !is_behind && let Some(head) = head.take() {
            self.push(head);
        }
        for row in rows {
            let before = head.take().unwrap_or_else(|| vec![Span::raw(" ".repeat(begins))]);
            self.push(before.into_iter().chain(row).collect::<Vec<_>>());
        }
        if is_here {
            self.fault();
        }
    }

    /// Options by their digits, as many on a row as fit.
    fn options(&self, names: &[String], chosen: Option<usize>, room: usize) -> Vec<Vec<Span<'static>>> {
        let look = &self.model.look;
        let mut rows: Vec<(Vec<Span<'static>>, usize)> = vec![(Vec::new(), 0)];
        for (n, name) in names.iter().enumerate() {
            let style = if chosen == Some(n) { look.focus() } else { Style::new() };
            let digit = format!("{} ", n + 1);
            let cells = width(&digit) + width(name) + 3;
            if rows.last().is_some_and(|(_, used)| *used > 0 && used + cells > room + 2) {
                rows.push((Vec::new(), 0));
            }
            let (row, used) = rows.last_mut().expect("there is a row");
            row.extend([
                Span::styled(digit, look.key()),
                Span::styled(name.clone(), style),
                Span::raw("   "),
            ]);
            *used += cells;
        }
        rows.into_iter().map(|(row, _)| row).collect()
    }

    /// The line that is typed in, and why its text was not taken.
    fn typed(&mut self, line: &FieldLine, label: usize) {
        let look = &self.model.look;
        let text = filter_untrusted(self.field.input.value()).into_owned();
        let begins = label + AROUND;
        let room = self.room.saturating_sub(begins);
        let shown = fit(&text, room, look);
        let column = begins + self.field.input.input().visual_cursor().min(room.saturating_sub(1));
        (self.page.focus, self.page.cursor) = (self.page.lines.len(), Some(column));
        let underlined = Style::new().add_modifier(Modifier::UNDERLINED);
        // What the first character replaces looks chosen.
        let style = if self.field.input.is_selected() { look.focus() } else { underlined };
        let blank = BLANK.min(room).saturating_sub(width(&shown));
        let mut spans = self.head(line, label, true);
        spans.extend([Span::styled(shown, style), Span::styled(" ".repeat(blank), underlined)]);
        self.push(spans);
        self.fault();
    }

    /// The reason for which the job does not go on from the line of the cursor.
    fn fault(&mut self) {
        let look = &self.model.look;
        let Some(fault) = &self.field.fault else { return };
        let (fault, glyph) = (fault.render(&self.model.locale), look.glyph(Glyph::Bad));
        let rows = wrapped(&filter_untrusted(&fault), self.room.saturating_sub(BELOW));
        for (n, text) in rows.into_iter().enumerate() {
            let mark = if n == 0 { glyph } else { " " };
            self.push(Line::styled(format!("    {mark} {text}"), look.error()));
        }
    }

    fn answered(&mut self, line: &FieldLine, label: usize) {
        let look = &self.model.look;
        let text = self.written(line);
        let text = if text.is_empty() { look.glyph(Glyph::Dot).to_owned() } else { text };
        let mut spans = self.head(line, label, false);
        spans.push(Span::raw(fit(&text, self.room.saturating_sub(label + AROUND), look)));
        self.push(spans);
    }
}
