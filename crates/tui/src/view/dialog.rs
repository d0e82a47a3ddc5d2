//! Dialogs over a screen.

mod preview;

use dalembert_core::{Field, Measure, Shape, Text, draft};
use ratatui::{
    buffer::Buffer,
    layout::{Position, Rect},
    style::Style,
    text::{Line, Span},
    widgets::{Clear, Widget},
};
use tui_input::Input;

use super::{HitTarget, bars, boxed, draw_input, draw_lines, help, scroll_mark, word};
use crate::{
    dialog::{Answer, Choice, Dialog, DialogContent, Names, Purpose},
    glyphs::filter_untrusted,
    layout,
    look::Glyph,
    model::Model,
    palette::matching_actions,
    panes,
    text::{fit, shortened, width, wrapped},
};

/// So many actions are offered at once: few, for the sake of slow lines, and always as many rows; more on a screen of so
/// many rows.
const OFFERED: usize = 4;
const OFFERED_ON_A_TALL_SCREEN: (u16, usize) = (36, 10);
/// So many files are shown that may be meant.
const NAMES: usize = 6;
/// A table of so many bytes is read while it is typed.
const READ_AT_ONCE: usize = 100_000;
/// The widest box.
const WIDEST: u16 = 76;

/// Draws a dialog; answers where its cursor stands.
pub(super) fn draw(model: &Model, dialog: &Dialog, screen: Rect, buffer: &mut Buffer) -> Option<Position> {
    let [_, _, _, footer] = layout::frame(screen);
    match dialog {
        Dialog::Help { search, scroll } => {
            bars::footer(model, footer, buffer);
            help::draw(model, search, *scroll, screen, buffer)
        }
        Dialog::Palette { input, chosen } => draw_palette(model, input, *chosen, screen, footer, buffer),
        Dialog::Choice { options, chosen, .. } => {
            let laid = lay_choice(model, options, *chosen, screen);
            laid.draw(model, &word("Choose one", model), buffer);
            bars::footer(model, footer, buffer);
            None
        }
        Dialog::Prompt { purpose, input, error, names, preview } => {
            let title = match purpose {
                Purpose::SaveAs => "Save as",
                Purpose::Export if cfg!(feature = "word") => {
                    "Worked solution (.html, .tex, .typ, .md, .docx, .txt)"
                }
                Purpose::Export => "Worked solution (.html, .tex, .typ, .md, .txt)",
                Purpose::ExportSeen => "Plot or drawing (.svg; a plot also .csv)",
                Purpose::Open => "File to open",
                Purpose::Import => "File of the table (.csv, .xlsx, .uff, .wav, .mat)",
                Purpose::SavePlan => "Study plan to write (.toml)",
                Purpose::OpenPlan => "Study plan to read (.toml)",
                Purpose::Title => "Title of the problem",
                Purpose::LinkedProblem => "Linked problem: a name and an analysis",
                Purpose::Configuration => "Name of the configuration",
            };
            let mut below: Vec<Line<'static>> = error
                .iter()
                .flat_map(|error| {
                    let text = filter_untrusted(&error.render(&model.locale)).into_owned();
                    wrapped(&text, usize::from(box_width(screen)).saturating_sub(4))
                })
                .map(|text| Line::styled(text, model.look.error()))
                .collect();
            let room = usize::from(box_width(screen)).saturating_sub(4);
            if let Some(preview) = preview {
                below.extend(preview::lines(model, preview, room));
            } else if purpose.is_path() {
                let found = found_names(model, names, input.value(), room);
                if found.is_empty() && matches!(purpose, Purpose::Open | Purpose::OpenPlan) && error.is_none()
                {
                    below.push(Line::styled(word("nothing found", model), model.look.dim()));
                }
                below.extend(found);
            }
            let area = centred(screen, 3 + below.len());
            Clear.render(area, buffer);
            framed(model, &word(title, model), area, buffer);
            let inner = layout::inside(area);
            draw_lines(
                &below,
                0,
                Rect { y: inner.y + 1, height: inner.height.saturating_sub(1), ..inner },
                buffer,
            );
            bars::footer(model, footer, buffer);
            let style = if input.is_selected() { model.look.focus() } else { Style::new() };
            draw_input(model, input.input(), "", style, Rect { height: inner.height.min(1), ..inner }, buffer)
        }
        Dialog::Ask { question, answers, chosen } => {
            let laid = lay_question(model, &question.render(&model.locale), answers, *chosen, screen);
            laid.draw(model, "", buffer);
            bars::footer(model, footer, buffer);
            None
        }
        Dialog::Message { title, lines } => {
            let room = usize::from(box_width(screen)).saturating_sub(4);
            let mut shown: Vec<Line<'static>> = wrapped(&title.render(&model.locale), room)
                .into_iter()
                .map(|text| Line::styled(text, model.look.error()))
                .collect();
            shown.extend(lines.iter().flat_map(|line| wrapped(line, room)).map(Line::from));
            draw_box(model, "", &shown, screen, buffer);
            bars::footer(model, footer, buffer);
            None
        }
        Dialog::Sheet(sheet) => {
            Clear.render(screen, buffer);
            let cursor =
                draw_sheet(model, sheet, Rect { height: screen.height.saturating_sub(1), ..screen }, buffer);
            bars::footer(model, footer, buffer);
            Some(cursor)
        }
    }
}

/// Hit target at a place over which the dialog lies.
pub(super) fn spot(model: &Model, dialog: &Dialog, screen: Rect, at: Position) -> HitTarget {
    let [_, _, _, footer] = layout::frame(screen);
    let laid = match dialog {
        Dialog::Choice { options, chosen, .. } => lay_choice(model, options, *chosen, screen),
        Dialog::Ask { question, answers, chosen } => {
            lay_question(model, &question.render(&model.locale), answers, *chosen, screen)
        }
        Dialog::Palette { input, chosen } => {
            let area = palette_area(screen, footer);
            let offers = matching_actions(model, input.value()).len();
            let inside = layout::inside(area);
            let first = chosen.saturating_sub(usize::from(inside.height).saturating_sub(1));
            let row = usize::from(at.y.saturating_sub(inside.y));
            return match area.contains(at) || footer.contains(at) {
                true if inside.contains(at) && first + row < offers => HitTarget::Offer(first + row),
                true => HitTarget::Over,
                false => HitTarget::Below,
            };
        }
        Dialog::Help { .. } | Dialog::Message { .. } | Dialog::Prompt { .. } | Dialog::Sheet(_) => {
            return HitTarget::Over;
        }
    };
    let row = usize::from(at.y.saturating_sub(laid.inside.y));
    match laid.owners.get(laid.first + row) {
        Some(Some(offer)) if laid.inside.contains(at) => HitTarget::Offer(*offer),
        _ if laid.area.contains(at) => HitTarget::Over,
        _ => HitTarget::Below,
    }
}

/// The typed line at the foot of the screen, and what it may mean above it.
fn draw_palette(
    model: &Model,
    input: &Input,
    chosen: usize,
    screen: Rect,
    footer: Rect,
    buffer: &mut Buffer,
) -> Option<Position> {
    let look = &model.look;
    let offers = matching_actions(model, input.value());
    let area = palette_area(screen, footer);
    let rows = usize::from(area.height).saturating_sub(2);
    if rows > 0 {
        Clear.render(area, buffer);
        framed(model, &word("Command palette", model), area, buffer);
        let inner = layout::inside(area);
        if offers.is_empty() {
            buffer.set_string(inner.x, inner.y, word("nothing found", model), look.dim());
        }
        let first = chosen.saturating_sub(rows - 1);
        for ((n, (_, bound)), y) in offers.iter().enumerate().skip(first).zip(inner.y..inner.bottom()) {
            let (pointer, style) =
                if n == chosen { (look.glyph(Glyph::Pointer), look.title()) } else { (" ", Style::new()) };
            let key = bound.keys.first().map_or_else(String::new, |key| key.name(&model.locale));
            let left = usize::from(inner.width).saturating_sub(width(&key) + 4);
            let name = fit(&word(bound.binding.name, model), left, look);
            let line = Line::from(vec![
                Span::styled(format!("{pointer} "), look.border(true)),
                Span::styled(name, style),
                Span::styled(format!("  {key}"), look.dim()),
            ]);
            buffer.set_line(inner.x, y, &line, inner.width);
        }
        scroll_mark(first, rows, offers.len(), look, area, buffer);
    }
    Clear.render(footer, buffer);
    draw_input(model, input, ":", Style::new(), footer, buffer)
}

/// Area of the matches of the palette.
fn palette_area(screen: Rect, footer: Rect) -> Rect {
    let (tall, more) = OFFERED_ON_A_TALL_SCREEN;
    let matching_actions = if screen.height < tall { OFFERED } else { more };
    let height = matching_actions.min(usize::from(screen.height.saturating_sub(4))) as u16 + 2;
    Rect::new(screen.x, footer.y.saturating_sub(height), screen.width.min(56), height)
}

/// The files that may be meant, a part of them round the one that is tried.
fn found_names(model: &Model, names: &Names, typed: &str, room: usize) -> Vec<Line<'static>> {
    let look = &model.look;
    let (found, at) = names.matching(typed);
    let first = (at.unwrap_or(0) + 1).saturating_sub(NAMES);
    let seen = found.iter().enumerate().skip(first).take(NAMES);
    let mut lines: Vec<Line<'static>> = seen
        .map(|(n, name)| {
            let name = fit(&filter_untrusted(name).replace('\n', "\u{FFFD}"), room, look);
            Line::styled(name, if at == Some(n) { look.focus() } else { look.dim() })
        })
        .collect();
    if found.len() > first + NAMES {
        let more = Text::new("and {more} more").with("more", found.len() - first - NAMES);
        lines.push(Line::styled(more.render(&model.locale), look.dim()));
    }
    lines
}

/// Lines with what may be chosen among them, as they are drawn.
struct Laid {
    lines: Vec<Line<'static>>,
    /// Choice of each line.
    owners: Vec<Option<usize>>,
    /// The first line that is seen.
    first: usize,
    /// All of it, with its frame if it has one.
    area: Rect,
    inside: Rect,
}

impl Laid {
    fn draw(&self, model: &Model, title: &str, buffer: &mut Buffer) {
        Clear.render(self.area, buffer);
        if self.area != self.inside {
            framed(model, title, self.area, buffer);
        }
        draw_lines(&self.lines, self.first, self.inside, buffer);
    }
}

/// A question above its answers. Where there is little room the frame goes first and then the end of the question,
/// since every answer must be seen.
fn lay_question(
    model: &Model,
    question: &str,
    answers: &[(&'static str, Answer)],
    chosen: usize,
    screen: Rect,
) -> Laid {
    let question = filter_untrusted(question);
    let rows = usize::from(screen.height.saturating_sub(1));
    let framed = answers.len() + 4 <= rows;
    let (rows, room) = if framed {
        (rows - 2, usize::from(box_width(screen)).saturating_sub(4))
    } else {
        (rows, usize::from(screen.width))
    };
    let shown: Vec<Line<'static>> = answers
        .iter()
        .enumerate()
        .map(|(n, (name, _))| {
            let name = fit(&word(name, model), room.saturating_sub(4), &model.look);
            option_line(model, &name, n == chosen, true)
        })
        .collect();
    let asked = wrapped(&question, room);
    let gap = usize::from(framed && asked.len() + 1 + answers.len() <= rows);
    let asked = shortened(asked, rows.saturating_sub(answers.len() + gap), room, &model.look);
    let mut lines: Vec<Line<'static>> = asked.into_iter().map(Line::from).collect();
    lines.extend(std::iter::repeat_n(Line::default(), gap));
    let mut owners = vec![None; lines.len()];
    owners.extend((0..answers.len()).map(Some));
    lines.extend(shown);
    if framed {
        let area = box_of("", &lines, screen);
        return Laid { lines, owners, first: 0, area, inside: layout::inside(area) };
    }
    // With no room for all the answers either, the chosen one is among those that are seen.
    let first = (lines.len() - answers.len() + chosen + 1).saturating_sub(rows);
    let area = Rect { height: lines.len().min(rows) as u16, ..screen };
    Laid { lines, owners, first, area, inside: area }
}

fn lay_choice(model: &Model, options: &[Choice], chosen: usize, screen: Rect) -> Laid {
    let look = &model.look;
    let room = usize::from(box_width(screen)).saturating_sub(4);
    let help: Vec<Line<'static>> = options
        .get(chosen)
        .filter(|choice| !choice.help.is_empty())
        .map(|choice| wrapped(&choice.help, room))
        .unwrap_or_default()
        .into_iter()
        .map(|text| Line::styled(text, look.dim()))
        .collect();
    let most = usize::from(screen.height.saturating_sub(4)).saturating_sub(help.len() + 1).max(1);
    let all: Vec<(Option<usize>, Line<'static>)> = options
        .iter()
        .enumerate()
        .flat_map(|(n, choice)| {
            option(model, &choice.label, n == chosen, room).into_iter().map(move |line| (Some(n), line))
        })
        .collect();
    // The last line of the chosen one is seen.
    let end = all.iter().rposition(|(n, _)| *n == Some(chosen)).map_or(0, |at| at + 1);
    let (owners, mut lines): (Vec<Option<usize>>, Vec<Line<'static>>) =
        all.into_iter().skip(end.saturating_sub(most)).take(most).unzip();
    if !help.is_empty() {
        lines.push(Line::default());
        lines.extend(help);
    }
    let area = box_of(&word("Choose one", model), &lines, screen);
    Laid { lines, owners, first: 0, area, inside: layout::inside(area) }
}

fn draw_sheet(model: &Model, sheet: &DialogContent, area: Rect, buffer: &mut Buffer) -> Position {
    let look = &model.look;
    let about = about_table(model, sheet, layout::inside(area));
    framed(model, &about.title, area, buffer);
    let mut inner = layout::inside(area);
    for (lines, at_end) in [(about.head, false), (about.foot, true)] {
        let rows = (lines.len() as u16).min(inner.height.saturating_sub(1));
        let y = if at_end { inner.bottom() - rows } else { inner.y };
        draw_lines(&lines, 0, Rect { y, height: rows, ..inner }, buffer);
        inner =
            Rect { y: if at_end { inner.y } else { inner.y + rows }, height: inner.height - rows, ..inner };
    }
    let height = usize::from(inner.height).max(1);
    let first = sheet.row.saturating_sub(height / 2).min(sheet.lines.len().saturating_sub(height));
    let room = usize::from(inner.width).saturating_sub(1);
    for (y, line) in (inner.y..inner.bottom()).zip(sheet.lines.iter().skip(first)) {
        let seen: String = line.chars().take(room + 1).collect();
        buffer.set_string(inner.x, y, fit(&filter_untrusted(&seen), room, look), Style::new());
    }
    scroll_mark(first, height, sheet.lines.len(), look, area, buffer);
    Position::new(inner.x + sheet.column.min(room) as u16, inner.y + (sheet.row - first) as u16)
}

/// Description of a table that is edited.
#[derive(Default)]
struct AboutTable {
    /// Title, in words.
    title: String,
    /// Meaning, format, and columns with their units.
    head: Vec<Line<'static>>,
    /// Error of the table as it is.
    foot: Vec<Line<'static>>,
}

fn about_table(model: &Model, sheet: &DialogContent, inside: Rect) -> AboutTable {
    let Some(bench) = &model.bench else { return AboutTable::default() };
    let (look, locale, room) = (&model.look, &model.locale, usize::from(inside.width));
    let whole = bench.problem.entry().shape();
    let Ok((_, shape)) = bench.problem.inputs.form.draft.at(&whole, &sheet.path) else {
        return AboutTable::default();
    };
    let columns = shape.present().fields(None);
    let with_units = |column: &Field| {
        let label = Text::from(column.label).render(locale);
        match column.shape.present() {
            Shape::Quantity(measure) => format!("{label} [{}]", unit_of(&measure, look.ascii)),
            _ => label,
        }
    };
    let heading = columns.iter().map(|column| match column.shape.present() {
        Shape::Quantity(measure) => format!("[{}]", unit_of(&measure, true)),
        _ => "[1]".to_owned(),
    });
    let how = Text::new(
        "One row per line; columns separated by semicolons, tabs, spaces or commas. A first line such as {heading} gives the units. @name reads a file.",
    )
    .with("heading", heading.collect::<Vec<_>>().join("; "));
    let help = bench
        .problem
        .inputs
        .form
        .lines()
        .into_iter()
        .find(|line| line.path == sheet.path)
        .map(|line| line.field.help);
    let mut reported = [Text::from(help.unwrap_or_default()), how]
        .iter()
        .filter(|text| !text.is_empty())
        .flat_map(|text| wrapped(&text.render(locale), room))
        .collect::<Vec<_>>();
    let names = wrapped(&columns.iter().map(with_units).collect::<Vec<_>>().join("; "), room);
    // Half of the screen at least is the table's own.
    reported = shortened(reported, (usize::from(inside.height) / 2).saturating_sub(names.len()), room, look);
    let mut head: Vec<Line<'static>> =
        reported.into_iter().map(|text| Line::styled(text, look.dim())).collect();
    head.extend(names.into_iter().map(|text| Line::styled(text, look.title())));
    let text = sheet.text();
    // A table that takes long to read is read when it is kept.
    let is_read = text.len() <= READ_AT_ONCE && !text.trim().is_empty();
    let faults =
        if is_read { draft::read_leaf(&text, &shape, "").err().unwrap_or_default() } else { Vec::new() };
    let foot = faults.first().map_or_else(Vec::new, |fault| {
        shortened(wrapped(&filter_untrusted(&fault.why.render(locale)), room), 2, room, look)
    });
    AboutTable {
        title: panes::label_of(&whole, &sheet.path, locale).unwrap_or_else(|| sheet.path.clone()),
        head,
        foot: foot.into_iter().map(|text| Line::styled(text, look.error())).collect(),
    }
}

/// The unit of a column, or those of its kinds; that of a pure number is 1.
fn unit_of(measure: &Measure, ascii: bool) -> String {
    measure.units_of_kinds(ascii)
}

/// An option in as many lines as it needs.
fn option(model: &Model, name: &str, chosen: bool, room: usize) -> Vec<Line<'static>> {
    let lines = wrapped(name, room.saturating_sub(4)).into_iter().enumerate();
    lines.map(|(n, text)| option_line(model, &text, chosen, n == 0)).collect()
}

fn option_line(model: &Model, text: &str, chosen: bool, is_first: bool) -> Line<'static> {
    let look = &model.look;
    let pointer = if chosen && is_first { look.glyph(Glyph::Pointer) } else { " " };
    let style = if chosen { look.focus() } else { Style::new() };
    Line::from(vec![
        Span::styled(format!("{pointer} "), look.border(true)),
        Span::styled(format!(" {text} "), style),
    ])
}

fn draw_box(model: &Model, title: &str, lines: &[Line<'static>], screen: Rect, buffer: &mut Buffer) {
    let area = box_of(title, lines, screen);
    Clear.render(area, buffer);
    framed(model, title, area, buffer);
    draw_lines(lines, 0, layout::inside(area), buffer);
}

/// The box around lines.
fn box_of(title: &str, lines: &[Line<'static>], screen: Rect) -> Rect {
    let longest = lines.iter().map(Line::width).max().unwrap_or(0).max(width(title) + 4);
    let columns = u16::try_from(longest + 4).unwrap_or(u16::MAX).min(box_width(screen));
    let mut area = centred(screen, lines.len() + 2);
    area.x += (area.width - columns) / 2;
    area.width = columns;
    area
}

fn framed(model: &Model, title: &str, area: Rect, buffer: &mut Buffer) {
    let title = if title.is_empty() { String::new() } else { format!(" {title} ") };
    boxed(&Line::styled(title, model.look.title()), true, &model.look, area, buffer);
}

fn box_width(screen: Rect) -> u16 {
    screen.width.saturating_sub(4).min(WIDEST).max(screen.width.min(16))
}

fn centred(screen: Rect, height: usize) -> Rect {
    let width = box_width(screen);
    let height = u16::try_from(height)
        .unwrap_or(u16::MAX)
        .min(screen.height.saturating_sub(1))
        .max(screen.height.min(3));
    Rect::new(
        screen.x + (screen.width - width) / 2,
        screen.y + screen.height.saturating_sub(height) / 3,
        width,
        height,
    )
}
