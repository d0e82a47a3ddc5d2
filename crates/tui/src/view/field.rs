//! Field mode on the screen: the steps, what to do, the lines of the page, and the clock-face of the rotor.

mod page;

use std::cmp::Ordering;

use dalembert_plot::dial::{self, Dial};
use ratatui::{
    buffer::Buffer,
    layout::{Constraint, Layout, Position, Rect},
    text::{Line, Span},
};

use self::page::Page;
use super::{bars, draw_lines};
use crate::{
    bench::Bench,
    field::{self, FieldMode, FieldPage, TypedLine, face},
    glyphs::filter_untrusted,
    layout,
    look::Glyph,
    model::Model,
    text::{shortened, width, wrapped},
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
    let page = Page::of(model, &bench.problem, field, usize::from(text.width));
    let used = page.lines.len() as u16;
    let first = page.first(usize::from(text.height));
    draw_lines(&page.lines, first, text, buffer);
    let picture = picture.unwrap_or_else(|| {
        let used = (used + 1).min(text.height);
        Rect { y: text.y + used, height: text.height - used, ..text }
    });
    draw_faces(model, &faces, picture, buffer);
    // The last row is that of a notice, while there is one.
    let rows = help.height.saturating_sub(u16::from(model.notice.is_some()));
    draw_help(model, bench, field, Rect { height: rows, ..help }, buffer);
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
        let widest = if is_below { inside.width } else { BODY };
        return (Rect { width: inside.width.min(widest), ..inside }, None);
    }
    let picture = if inside.width < BESIDE { SMALL } else { (inside.width * 2 / 5).min(WIDEST) };
    let [text, _, picture] =
        Layout::horizontal([Constraint::Fill(1), Constraint::Length(2), Constraint::Length(picture)])
            .areas(inside);
    (text, Some(picture))
}

/// The steps of the job: those that are done, the one that is shown, those to come; by signs where names have no room.
fn draw_steps(model: &Model, bench: &Bench, field: &FieldMode, area: Rect, buffer: &mut Buffer) {
    let all = field.pages(&bench.problem);
    let at = all.iter().position(|page| *page == field.page).unwrap_or(0);
    let steps = |is_short: bool| -> Vec<Span<'static>> {
        all.iter().enumerate().map(|(n, page)| step(model, *page, n.cmp(&at), is_short)).collect()
    };
    let room = usize::from(area.width).saturating_sub(2);
    let long = steps(false);
    let cells = long.iter().map(|step| width(&step.content) + GAP).sum::<usize>();
    let shown = if cells <= room + GAP { long } else { steps(true) };
    let mut line = Line::default();
    for step in shown {
        line.push_span(step);
        line.push_span(Span::raw(" ".repeat(GAP)));
    }
    buffer.set_line(area.x + 2, area.y, &line, room as u16);
}

/// A step, by its place before, at or after the one that is shown.
fn step(model: &Model, page: FieldPage, place: Ordering, is_short: bool) -> Span<'static> {
    let look = &model.look;
    let name = field::title(page, true).render(&model.locale);
    let done = look.glyph(Glyph::Good);
    match (place, is_short) {
        (Ordering::Equal, _) => Span::styled(format!(" {name} "), look.focus()),
        (Ordering::Less, true) => Span::styled(done, look.good()),
        (Ordering::Less, false) => Span::styled(format!("{done}{name}"), look.good()),
        (Ordering::Greater, true) => Span::styled(look.glyph(Glyph::Hollow), look.dim()),
        (Ordering::Greater, false) => Span::styled(name, look.dim()),
    }
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
