//! The screens, drawn from the model alone.

mod bars;
mod dialog;
mod form;
mod pane;
mod picker;
mod target;
mod text;

use std::time::Duration;

use dalembert_core::Text;
use ratatui::{
    Frame,
    buffer::Buffer,
    layout::{Position, Rect},
    style::Modifier,
    text::Line,
    widgets::{Block, BorderType, Widget},
};

pub(crate) use self::{
    dialog::longest_scroll_of_help,
    pane::{area_of_tab, page},
    target::{HitTarget, spot},
};
use crate::{
    layout,
    look::{Glyph, Look},
    model::Model,
    tab::Tab,
};

/// The least screen that shows more than a name.
const LEAST: (u16, u16) = (16, 4);

/// Draws everything.
pub fn view(model: &Model, frame: &mut Frame<'_>) {
    let area = frame.area();
    let buffer = frame.buffer_mut();
    if area.is_empty() {
        return;
    }
    if area.width < LEAST.0 || area.height < LEAST.1 {
        buffer.set_stringn(area.x, area.y, "dalembert", area.width.into(), model.look.title());
        return;
    }
    let mut cursor = match model.shown_bench() {
        Some(bench) => {
            let areas = layout::bench(area, bench.focus, bench.expanded || model.look.basic);
            bars::title(model, areas.title, buffer);
            let cursor = areas.form.and_then(|area| form::draw(model, bench, area, buffer));
            pane::draw(model, bench, &areas, buffer);
            bars::help(model, areas.help, buffer);
            bars::footer(model, areas.footer, buffer);
            cursor
        }
        None => {
            let [title, body, help, footer] = layout::frame(area);
            bars::title(model, title, buffer);
            let cursor = picker::draw(model, body, buffer);
            bars::help(model, help, buffer);
            bars::footer(model, footer, buffer);
            cursor
        }
    };
    if let Some(dialog) = &model.dialog {
        cursor = dialog::draw(model, dialog, area, buffer);
    }
    model.look.ground(buffer);
    if model.look.basic && cursor.is_none() {
        cursor = focus(buffer);
    }
    if let Some(position) = cursor.filter(|position| area.contains(*position)) {
        frame.set_cursor_position(position);
    }
}

/// Whether a tab of the problem is on the screen.
pub(crate) fn shows(model: &Model, tab: Tab) -> bool {
    let screen = Rect::new(0, 0, model.size.0, model.size.1);
    model.shown_bench().is_some_and(|bench| {
        let areas = layout::bench(screen, bench.focus, bench.expanded || model.look.basic);
        pane::panes(model, bench, &areas).iter().any(|(shown, _, _)| *shown == tab)
    })
}

/// How long each frame of an animation stands; `None` while none moves on the screen.
pub fn tempo(model: &Model) -> Option<Duration> {
    let (frames, period) = animation(model).filter(|_| model.playing && model.dialog.is_none())?;
    Duration::try_from_secs_f64(period / (frames as f64 * model.animation_speed)).ok()
}

/// The frames and the time of what can move on the screen.
pub(crate) fn animation(model: &Model) -> Option<(usize, f64)> {
    let bench = model.shown_bench().filter(|bench| !bench.is_stale())?;
    let animation = bench.sketch()?.frames();
    let area = Rect::new(0, 0, model.size.0, model.size.1);
    let areas = layout::bench(area, bench.focus, bench.expanded || model.look.basic);
    (animation.0 > 1 && pane::shows_drawing(bench, &areas)).then_some(animation)
}

/// Where what has the focus begins: a screen reader follows the cursor.
fn focus(buffer: &Buffer) -> Option<Position> {
    let at = buffer.content.iter().position(|cell| cell.modifier.contains(Modifier::REVERSED))?;
    Some(buffer.pos_of(at).into())
}

/// Where the title of a pane stands.
fn title_of(area: Rect) -> Rect {
    let inset = if layout::framed(area) { 2 } else { 0 };
    Rect {
        x: area.x + inset,
        width: area.width.saturating_sub(2 * inset),
        height: area.height.min(1),
        ..area
    }
}

/// A frame with a title, and what is left inside.
fn boxed(title: &Line<'_>, focused: bool, look: &Look, area: Rect, buffer: &mut Buffer) {
    if layout::framed(area) && !look.basic {
        let kind = if look.ascii { BorderType::Plain } else { BorderType::Rounded };
        Block::bordered().border_type(kind).border_style(look.border(focused)).render(area, buffer);
    }
    let title_area = title_of(area);
    buffer.set_line(title_area.x, title_area.y, title, title_area.width);
}

/// Says at the lower edge of a frame that there are lines above and below.
fn scroll_mark(first: usize, shown: usize, of: usize, look: &Look, area: Rect, buffer: &mut Buffer) {
    if of <= shown || !layout::framed(area) {
        return;
    }
    let up = if first > 0 { look.glyph(Glyph::Up) } else { " " };
    let down = if first + shown < of { look.glyph(Glyph::Down) } else { " " };
    let mark = format!(" {}–{}/{of} {up}{down} ", first + 1, (first + shown).min(of));
    let width = text::width(&mark) as u16;
    if width + 4 <= area.width {
        buffer.set_string(area.right() - width - 2, area.bottom() - 1, mark, look.dim());
    }
}

/// Draws lines from the first that is shown.
fn draw_lines(lines: &[Line<'_>], first: usize, area: Rect, buffer: &mut Buffer) {
    for (y, line) in (area.y..area.bottom()).zip(lines.iter().skip(first)) {
        buffer.set_line(area.x, y, line, area.width);
    }
}

/// A word of the interface in the user's language.
fn word(english: &'static str, model: &Model) -> String {
    Text::from(english).render(&model.locale)
}
