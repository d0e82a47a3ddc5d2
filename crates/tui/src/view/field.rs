//! Field mode on the screen: the steps, what to do, the lines of the page, and the clock-face of the rotor.

use dalembert_core::Text;
use dalembert_plot::dial::{self, Dial};
use ratatui::{
    buffer::Buffer,
    layout::{Constraint, Layout, Position, Rect},
    style::{Modifier, Style},
    text::{Line, Span},
};

use super::{bars, draw_lines};
use crate::{
    bench::Bench,
    field::{self, FieldLine, FieldMode, FieldPage, LineKind, Tone, TypedLine, face},
    glyphs::filter_untrusted,
    layout,
    look::Glyph,
    model::Model,
    problem::Problem,
    text::{fit, padded, shortened, width, wrapped},
};

/// From so many columns on a picture stands beside the lines.
const BESIDE: u16 = 72;
/// From so many columns on a small one does, where lines are short.
const NARROW: u16 = 52;
/// Columns of a small picture.
const SMALL: u16 = 26;
/// Columns of the widest picture beside the lines.
const WIDEST: u16 = 46;
/// The least rows in which a face can be read.
const LEAST_FACE: u16 = 9;
/// The least columns of a face.
const LEAST_WIDTH: u16 = 22;
/// Columns before and after a label.
const AROUND: usize = 4;
/// The fewest columns of the labels.
const LABEL: usize = 10;
/// Cells between two steps.
const GAP: usize = 1;
/// From so many rows on the help has two.
const ROOMY: u16 = 16;
/// Columns of the widest body: longer lines are hard to read.
const BODY: u16 = 100;

/// Draws the screen of a job; answers where the cursor of the text stands.
pub(super) fn draw(model: &Model, bench: &Bench, area: Rect, buffer: &mut Buffer) -> Option<Position> {
    let field = bench.field.as_ref()?;
    let [title, body, help, footer] = layout::frame(area);
    bars::title(model, title, buffer);
    let [steps, _, body, more] = Layout::vertical([
        Constraint::Length(1),
        Constraint::Length(1),
        Constraint::Min(0),
        Constraint::Length(u16::from(area.height >= ROOMY)),
    ])
    .areas(body);
    let help = Rect { y: more.y, height: more.height + help.height, ..help };
    draw_steps(model, bench, field, steps, buffer);
    let is_narrow = area.width < BESIDE + 4;
    let faces = face::faces(&bench.problem, (field.page, field.line), is_narrow, &model.locale);
    let (text, picture) = areas(body, field.page, faces.len());
    let mut page = Page::default();
    page.write(model, bench, field, usize::from(text.width));
    let used = page.lines.len() as u16;
    let first = page.first(usize::from(text.height));
    draw_lines(&page.lines, first, text, buffer);
    let picture = picture.unwrap_or_else(|| {
        let used = (used + 1).min(text.height);
        Rect { y: text.y + used, height: text.height - used, ..text }
    });
    draw_faces(model, &faces, picture, buffer);
    draw_help(model, bench, field, help, buffer);
    bars::footer(model, footer, buffer);
    page.cursor.and_then(|column| {
        let y = text.y + u16::try_from(page.focus.checked_sub(first)?).ok()?;
        Some(Position::new(text.x + column as u16, y)).filter(|at| text.contains(*at))
    })
}

/// The area of the text, and that of a picture beside it, where there is room for one.
fn areas(body: Rect, page: FieldPage, faces: usize) -> (Rect, Option<Rect>) {
    let inside = Rect { x: body.x + 2, width: body.width.saturating_sub(4), ..body };
    // Weights of several planes are shown side by side below what to do.
    let is_below = matches!(page, FieldPage::Correction(_)) && faces > 1;
    let is_small = matches!(page, FieldPage::Instrument | FieldPage::Correction(_)) && inside.width >= NARROW;
    if faces == 0 || is_below || (inside.width < BESIDE && !is_small) {
        return (
            Rect { width: inside.width.min(if is_below { inside.width } else { BODY }), ..inside },
            None,
        );
    }
    let picture = if inside.width < BESIDE { SMALL } else { (inside.width * 2 / 5).min(WIDEST) };
    let [text, _, picture] =
        Layout::horizontal([Constraint::Fill(1), Constraint::Length(2), Constraint::Length(picture)])
            .areas(inside);
    (text, Some(picture))
}

/// The steps of the job: those that are done, the one that is shown, those to come.
fn draw_steps(model: &Model, bench: &Bench, field: &FieldMode, area: Rect, buffer: &mut Buffer) {
    let (look, problem) = (&model.look, &bench.problem);
    let all = field.pages(problem);
    let at = all.iter().position(|page| *page == field.page).unwrap_or(0);
    let names = |is_short: bool| -> Vec<(String, Style)> {
        let one = |(n, page): (usize, &FieldPage)| {
            let name = field::title(*page, true).render(&model.locale);
            let is_done = n < at;
            let mark = if is_done { look.glyph(Glyph::Good) } else { "" };
            match n == at {
                true => (format!(" {name} "), look.focus()),
                false if is_short => (
                    if is_done { look.glyph(Glyph::Good) } else { look.glyph(Glyph::Hollow) }.to_owned(),
                    look.dim(),
                ),
                false => (format!("{mark}{name}"), if is_done { look.good() } else { look.dim() }),
            }
        };
        all.iter().enumerate().map(one).collect()
    };
    let room = usize::from(area.width).saturating_sub(2);
    let cells = |names: &[(String, Style)]| names.iter().map(|(name, _)| width(name) + GAP).sum::<usize>();
    let long = names(false);
    let shown = if cells(&long) <= room + GAP { long } else { names(true) };
    let mut line = Line::default();
    for (name, style) in shown {
        line.push_span(Span::styled(name, style));
        line.push_span(Span::raw(" ".repeat(GAP)));
    }
    buffer.set_line(area.x + 2, area.y, &line, room as u16);
}

/// The text of a page, the line that has the keys, and the column of the cursor in it, where it is one of text.
#[derive(Default)]
struct Page {
    lines: Vec<Line<'static>>,
    focus: usize,
    cursor: Option<usize>,
}

impl Page {
    /// The first line that is shown: the one with the cursor is in sight.
    fn first(&self, height: usize) -> usize {
        (self.focus + 2).saturating_sub(height).min(self.lines.len().saturating_sub(height))
    }

    fn write(&mut self, model: &Model, bench: &Bench, field: &FieldMode, room: usize) {
        let (look, problem, locale) = (&model.look, &bench.problem, &model.locale);
        self.lines.push(Line::styled(field::title(field.page, false).render(locale), look.title()));
        // In little room the picture says it.
        if field.page != FieldPage::Instrument || room >= usize::from(SMALL) + 6 {
            self.words(&field::task(problem, field.page, locale).render(locale), Style::new(), room);
        }
        let remarks = field::remarks(problem, field.page, locale);
        // What to do stands before the lines, what follows from them behind.
        let is_before = |tone: Tone| {
            matches!(tone, Tone::Order | Tone::Detail)
                || tone == Tone::Plain && matches!(field.page, FieldPage::Trial(_))
        };
        let is_report = field.page == FieldPage::Report;
        if is_report {
            self.lines.push(Line::default());
        }
        for (tone, text) in remarks.iter().filter(|(tone, _)| is_before(*tone) || is_report) {
            self.remark(model, *tone, &text.render(locale), room);
        }
        // Where pictures stand below the text, every line counts.
        let is_close = matches!(field.page, FieldPage::Correction(_));
        if !is_close {
            self.lines.push(Line::default());
        }
        let lines = field.lines(problem);
        let label = label_width(model, problem, &lines, room);
        for (n, line) in lines.iter().enumerate() {
            let is_go = |line: &FieldLine| matches!(line.kind, LineKind::Go(_));
            if !is_close && n > 0 && is_go(line) && !is_go(&lines[n - 1]) {
                self.lines.push(Line::default());
            }
            self.line(model, bench, field, (n, line), (label, room));
        }
        let behind: Vec<_> =
            remarks.into_iter().filter(|(tone, _)| !is_before(*tone) && !is_report).collect();
        if !behind.is_empty() {
            self.lines.push(Line::default());
        }
        for (tone, text) in behind {
            self.remark(model, tone, &text.render(locale), room);
        }
    }

    fn words(&mut self, text: &str, style: Style, room: usize) {
        let text = filter_untrusted(text).into_owned();
        self.lines.extend(wrapped(&text, room).into_iter().map(|line| Line::styled(line, style)));
    }

    fn remark(&mut self, model: &Model, tone: Tone, text: &str, room: usize) {
        let look = &model.look;
        let (glyph, style) = match tone {
            Tone::Plain => (None, Style::new()),
            Tone::Order => (Some(Glyph::Pointer), look.answer()),
            Tone::Detail => (None, look.dim()),
            Tone::Good => (Some(Glyph::Good), look.good()),
            Tone::Warning => (Some(Glyph::Warning), look.warning()),
            Tone::Wrong => (Some(Glyph::Bad), look.error()),
        };
        let indent = if tone == Tone::Detail { "  " } else { "" };
        let head = glyph.map_or_else(|| indent.to_owned(), |glyph| format!("{} ", look.glyph(glyph)));
        let hang = width(&head);
        let text = filter_untrusted(text).into_owned();
        for (n, line) in wrapped(&text, room.saturating_sub(hang)).into_iter().enumerate() {
            let before = if n == 0 { head.clone() } else { " ".repeat(hang) };
            self.lines.push(Line::styled(before + &line, style));
        }
    }

    fn line(
        &mut self,
        model: &Model,
        bench: &Bench,
        field: &FieldMode,
        (n, line): (usize, &FieldLine),
        (label, room): (usize, usize),
    ) {
        let (look, problem) = (&model.look, &bench.problem);
        let is_here = n == field.line;
        let pointer = if is_here { look.glyph(Glyph::Pointer) } else { " " };
        let name = line.label.render(&model.locale);
        let mut spans = vec![Span::styled(format!("{pointer} "), look.key())];
        if matches!(line.kind, LineKind::Go(_)) {
            let style = if is_here { look.focus() } else { look.dim() };
            spans.push(Span::styled(format!(" {} ", fit(&name, room.saturating_sub(4), look)), style));
            if is_here {
                self.focus = self.lines.len();
            }
            self.lines.push(Line::from(spans));
            return;
        }
        let style = if is_here { look.title() } else { Style::new() };
        spans.push(Span::styled(padded(&name, label, look), style));
        spans.push(Span::raw("  "));
        let begins = label + AROUND;
        match &line.kind {
            LineKind::Choice(choice, options) => {
                let chosen = field::option(problem, *choice);
                let longest = options.iter().map(|option| width(&option.render(&model.locale))).max();
                let is_wide = begins + longest.unwrap_or(0) + 2 <= room;
                let begins = if is_wide { begins } else { 6 };
                let options = options_of(model, options, chosen, is_here, room.saturating_sub(begins));
                if is_here {
                    self.focus = self.lines.len();
                }
                let mut before = spans;
                for more in options {
                    if !is_wide && !before.is_empty() {
                        self.lines.push(Line::from(std::mem::take(&mut before)));
                    }
                    let mut whole = std::mem::take(&mut before);
                    if whole.is_empty() {
                        whole.push(Span::raw(" ".repeat(begins)));
                    }
                    whole.extend(more.spans);
                    self.lines.push(Line::from(whole));
                }
                return;
            }
            _ if is_here => {
                let text = filter_untrusted(field.input.value()).into_owned();
                let cells = room.saturating_sub(begins);
                let style = if field.input.is_selected() {
                    look.focus()
                } else {
                    look.focus().remove_modifier(Modifier::REVERSED).add_modifier(Modifier::UNDERLINED)
                };
                let shown = fit(&text, cells, look);
                let column = begins + field.input.input().visual_cursor().min(cells.saturating_sub(1));
                (self.focus, self.cursor) = (self.lines.len(), Some(column));
                let blank = " "
                    .repeat(14usize.saturating_sub(width(&shown)).min(cells.saturating_sub(width(&shown))));
                spans.push(Span::styled(shown, style));
                spans.push(Span::styled(blank, Style::new().add_modifier(Modifier::UNDERLINED)));
            }
            _ => {
                let text = field::written(problem, line, model.locale.style);
                let text = filter_untrusted(&text).into_owned();
                let text = if text.is_empty() { look.glyph(Glyph::Dot).to_owned() } else { text };
                spans.push(Span::raw(fit(&text, room.saturating_sub(begins), look)));
            }
        }
        self.lines.push(Line::from(spans));
        if is_here && let Some(fault) = &field.fault {
            let text = fault.render(&model.locale);
            let glyph = look.glyph(Glyph::Bad);
            for text in wrapped(&filter_untrusted(&text), room.saturating_sub(6)) {
                self.lines.push(Line::styled(format!("    {glyph} {text}"), look.error()));
            }
        }
    }
}

/// Columns of the labels of a page: as they need, where the values have room behind them.
fn label_width(model: &Model, problem: &Problem, lines: &[FieldLine], room: usize) -> usize {
    let named = || lines.iter().filter(|line| !matches!(line.kind, LineKind::Go(_)));
    let longest = |text: &dyn Fn(&FieldLine) -> String| named().map(|line| width(&text(line))).max();
    let label = longest(&|line| line.label.render(&model.locale)).unwrap_or(0);
    let value = longest(&|line| field::written(problem, line, model.locale.style)).unwrap_or(0);
    label.min(room.saturating_sub(value + AROUND).max(LABEL))
}

/// The options of a line, by their digits; as many on a row as fit.
fn options_of(
    model: &Model,
    options: &[Text],
    chosen: Option<usize>,
    is_here: bool,
    room: usize,
) -> Vec<Line<'static>> {
    let look = &model.look;
    let names: Vec<String> = options.iter().map(|option| option.render(&model.locale)).collect();
    if !is_here {
        let text = chosen.and_then(|at| names.get(at)).cloned();
        return vec![Line::raw(text.unwrap_or_else(|| look.glyph(Glyph::Dot).to_owned()))];
    }
    let mut rows: Vec<(Line<'static>, usize)> = vec![(Line::default(), 0)];
    for (n, name) in names.into_iter().enumerate() {
        let style = if chosen == Some(n) { look.focus() } else { Style::new() };
        let digit = format!("{} ", n + 1);
        let cells = width(&digit) + width(&name) + 3;
        if rows.last().is_some_and(|(_, used)| *used > 0 && used + cells > room + 2) {
            rows.push((Line::default(), 0));
        }
        let (row, used) = rows.last_mut().expect("there is a row");
        row.push_span(Span::styled(digit, look.key()));
        row.push_span(Span::styled(name, style));
        row.push_span(Span::raw("   "));
        *used += cells;
    }
    rows.into_iter().map(|(row, _)| row).collect()
}

/// Draws what the line under the cursor means, and the reading of what is typed in it.
fn draw_help(model: &Model, bench: &Bench, field: &FieldMode, area: Rect, buffer: &mut Buffer) {
    let Some(line) = field.shown(&bench.problem) else { return };
    let typed = field.input.value();
    let wrong = match TypedLine::read(&bench.problem, &line, typed, model.locale.style) {
        Err(why) if line.is_text() && field.input.is_changed() && !typed.trim().is_empty() => Some(why),
        _ => None,
    };
    let room = usize::from(area.width).saturating_sub(2);
    let (text, style) = match wrong {
        Some(why) => (why.render(&model.locale), model.look.warning()),
        None => (line.help.render(&model.locale), model.look.dim()),
    };
    let lines = shortened(wrapped(&filter_untrusted(&text), room), area.height.into(), room, &model.look);
    for (y, line) in (area.y..area.bottom()).zip(lines) {
        buffer.set_string(area.x + 1, y, line, style);
    }
}

/// Draws the faces, side by side or one above the other, as many as can be read.
fn draw_faces(model: &Model, faces: &[Dial], area: Rect, buffer: &mut Buffer) {
    if faces.is_empty() || area.height < LEAST_FACE || area.width < LEAST_WIDTH {
        return;
    }
    let beside = usize::from(area.width / LEAST_WIDTH).clamp(1, faces.len());
    let above = if beside > 1 { 1 } else { usize::from(area.height / LEAST_FACE).clamp(1, faces.len()) };
    let split = |horizontal: bool, parts: usize| {
        let parts = vec![Constraint::Fill(1); parts];
        if horizontal {
            Layout::horizontal(parts).spacing(2).split(area)
        } else {
            Layout::vertical(parts).split(area)
        }
    };
    let places = if beside > 1 { split(true, beside) } else { split(false, above) };
    for (dial, place) in faces.iter().zip(places.iter()) {
        dial::render(dial, &model.look, *place, buffer);
    }
}
