//! The screens, drawn from the model alone.

mod bars;
mod dialog;
mod field;
mod form;
mod picker;
mod tabs;
mod target;

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
    target::{HitTarget, spot},
};
use crate::{
    bench::Bench,
    layout::{self, Areas, Focus},
    look::{Appearance, Glyph},
    model::Model,
    pane::{Column, Page, Tab, Ui},
    text::{self, draw_lines},
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
        Some(bench) if bench.field.is_some() => field::draw(model, bench, area, buffer),
        Some(bench) => {
            let areas = areas_in(area, model, bench, bench.focus);
            bars::title(model, areas.title, buffer);
            if !areas.parts.is_empty() {
                let bar = tabs::of_parts(model, bench, areas.parts.width);
                buffer.set_line(areas.parts.x, areas.parts.y, &bar.line, areas.parts.width);
            }
            let cursor = areas.form.and_then(|area| form::draw(model, bench, area, buffer));
            draw_panes(model, bench, &areas, buffer);
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
        cursor = focused_cell(buffer);
    }
    if let Some(position) = cursor.filter(|position| area.contains(*position)) {
        frame.set_cursor_position(position);
    }
}

/// Draws every pane of what was found.
fn draw_panes(model: &Model, bench: &Bench, areas: &Areas, buffer: &mut Buffer) {
    for (tab, area, named) in panes(model, bench, areas) {
        let title = match named {
            Some(named) => tabs::bar(model, bench, &named, area.width).line,
            None => tabs::title(model, bench, tab),
        };
        let ui = surroundings(model, bench, tab, area);
        boxed(&title, ui.focused, ui.look, area, buffer);
        if ui.area.is_empty() {
            continue;
        }
        let pane = bench.pane(tab);
        let page = pane.page(&bench.problem, &ui, ui.area.width);
        let (lines, height) = (page.lines.len(), usize::from(ui.area.height));
        let first = ui.scroll.min(lines.saturating_sub(height));
        page.draw(first, ui.area, buffer);
        scroll_mark(first, height, lines, ui.look, area, buffer);
        // A line is left free between the text and what is drawn below it.
        let used = (lines + usize::from(lines > 0)).min(height) as u16;
        let room = Rect { y: ui.area.y + used, height: ui.area.height - used, ..ui.area };
        pane.draw(&bench.problem, &ui, room, buffer);
    }
    let pictures = bench.in_column(Column::Pictures);
    let next = areas.pane.and(areas.picture).map(|picture| pictures_in(bench, &pictures, picture)[1]);
    if let (Some(area), Some(first)) = (next.filter(|area| !area.is_empty()), pictures.first()) {
        let (at, of) = bench.place_of_shown(*first).unwrap_or((1, 1));
        let place = format!(" {}/{of} ", at % of + 1);
        boxed(&Line::styled(place, model.look.dim()), false, &model.look, area, buffer);
        let ui = surroundings(model, bench, *first, area);
        bench.pane(*first).draw_next(&bench.problem, &ui, ui.area, buffer);
    }
}

/// The surroundings of a pane in an area of the screen.
fn surroundings<'a>(model: &'a Model, bench: &'a Bench, tab: Tab, area: Rect) -> Ui<'a> {
    let edit = bench.edit.as_ref().filter(|_| bench.tab == tab);
    Ui { edit, ..model.ui(bench, tab, layout::inside(area)) }
}

/// The lines of a pane at some width; a picture has none.
pub(crate) fn page(model: &Model, bench: &Bench, tab: Tab, width: u16) -> Page {
    bench.pane(tab).page(&bench.problem, &surroundings(model, bench, tab, Rect::ZERO), width)
}

/// The parts of the screen of a problem.
pub(crate) fn areas_of(model: &Model, bench: &Bench, focus: Focus) -> Areas {
    areas_in(Rect::new(0, 0, model.size.0, model.size.1), model, bench, focus)
}

fn areas_in(screen: Rect, model: &Model, bench: &Bench, focus: Focus) -> Areas {
    let has_parts = bench.problem.inputs.form.parts().len() > 1;
    layout::bench(screen, focus, bench.expanded || model.look.basic, has_parts)
}

/// The panes that are seen: what each shows, where, and the tabs that are named above it.
fn panes(model: &Model, bench: &Bench, areas: &Areas) -> Vec<(Tab, Rect, Option<Vec<Tab>>)> {
    let Some(pane) = areas.pane else { return Vec::new() };
    let Some(picture) = areas.picture else {
        return vec![(bench.tab, pane, Some(bench.tabs()))];
    };
    // Pictures have a column of their own.
    let pictures = bench.in_column(Column::Pictures);
    let named = Some(bench.tabs().into_iter().filter(|tab| !pictures.contains(tab)).collect());
    let mut panes = if bench.shown().column() == Column::Alone {
        vec![(bench.tab, pane, named)]
    } else {
        let shared = bench.in_column(Column::Shared).into_iter();
        let titles = [named, None];
        let areas = shared_in(model, bench, pane);
        shared.zip(areas).zip(titles).map(|((tab, area), named)| (tab, area, named)).collect()
    };
    let [upper, _, lower] = pictures_in(bench, &pictures, picture);
    let places = [Some(upper), Some(lower).filter(|lower| !lower.is_empty())];
    panes.extend(pictures.into_iter().zip(places).filter_map(|(tab, area)| Some((tab, area?, None))));
    panes
}

/// The areas of the two panes that share the middle column: the first is as high as its lines.
fn shared_in(model: &Model, bench: &Bench, pane: Rect) -> [Rect; 2] {
    let lines = page(model, bench, Tab::default(), layout::inside(pane).width).lines.len();
    layout::stack(pane, lines)
}

/// The areas of the first pane of pictures, of its next picture, and of the second pane.
fn pictures_in(bench: &Bench, panes: &[Tab], picture: Rect) -> [Rect; 3] {
    let count = |at: usize| panes.get(at).map_or(0, |tab| bench.pane(*tab).pictures(&bench.problem));
    layout::pictures(picture, count(0), count(1) > 0)
}

/// The pane at a place of the screen, its inside, and the tab whose name stands just there.
fn pane_at(model: &Model, bench: &Bench, areas: &Areas, at: Position) -> Option<(Tab, Rect, Option<Tab>)> {
    let (tab, area, named) = panes(model, bench, areas).into_iter().find(|(_, area, _)| area.contains(at))?;
    let title = title_of(area);
    let named = named
        .filter(|_| title.contains(at))
        .and_then(|named| tabs::bar(model, bench, &named, area.width).at(usize::from(at.x - title.x)));
    Some((tab, layout::inside(area), named))
}

/// The line of the page of a pane that stands at a place of its inside.
fn line_at(model: &Model, bench: &Bench, tab: Tab, inside: Rect, at: Position) -> Option<usize> {
    let lines = page(model, bench, tab, inside.width).lines.len();
    let first = bench.scroll[tab.0].min(lines.saturating_sub(inside.height.into()));
    let line = first + usize::from(at.y.checked_sub(inside.y)?);
    (inside.contains(at) && line < lines).then_some(line)
}

/// The inside of the pane that is shown, were the keys to act on it.
pub(crate) fn area_of_shown(model: &Model) -> Option<Rect> {
    let bench = model.bench.as_ref()?;
    let areas = areas_of(model, bench, Focus::Pane);
    let pane = areas.pane?;
    let in_column = |column| bench.in_column(column).iter().position(|tab| *tab == bench.tab);
    let area = match (areas.picture, bench.shown().column()) {
        (None, _) | (_, Column::Alone) => pane,
        (Some(_), Column::Shared) => shared_in(model, bench, pane)[in_column(Column::Shared)?.min(1)],
        (Some(picture), Column::Pictures) => {
            let pictures = bench.in_column(Column::Pictures);
            pictures_in(bench, &pictures, picture)[if in_column(Column::Pictures)? == 0 { 0 } else { 2 }]
        }
    };
    Some(layout::inside(area))
}

/// True if a pane of the problem is on the screen.
pub(crate) fn shows(model: &Model, tab: Tab) -> bool {
    model.shown_bench().is_some_and(|bench| {
        let areas = areas_of(model, bench, bench.focus);
        panes(model, bench, &areas).iter().any(|(shown, _, _)| *shown == tab)
    })
}

/// Duration of each frame of an animation; `None` while none plays on the screen.
pub fn tempo(model: &Model) -> Option<Duration> {
    let (_, frames, period) = animation(model).filter(|_| model.playing && model.dialog.is_none())?;
    Duration::try_from_secs_f64(period / (frames as f64 * model.animation_speed)).ok()
}

/// The animation on the screen: its pane, its frames, and their time.
pub(crate) fn animation(model: &Model) -> Option<(Tab, usize, f64)> {
    let bench = model.shown_bench().filter(|bench| !bench.problem.is_stale() && bench.field.is_none())?;
    let tab = bench.animated()?;
    let areas = areas_of(model, bench, bench.focus);
    let is_seen = areas.picture.is_some() || (areas.pane.is_some() && bench.tab == tab);
    let (frames, period) = bench.pane(tab).frames(&bench.problem);
    is_seen.then_some((tab, frames, period))
}

/// Start of the focused item: a screen reader follows the cursor.
fn focused_cell(buffer: &Buffer) -> Option<Position> {
    let at = buffer.content.iter().position(|cell| cell.modifier.contains(Modifier::REVERSED))?;
    Some(buffer.pos_of(at).into())
}

/// Area of the title of a pane.
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
fn boxed(title: &Line<'_>, focused: bool, look: &Appearance, area: Rect, buffer: &mut Buffer) {
    if layout::framed(area) && !look.basic {
        let kind = if look.ascii { BorderType::Plain } else { BorderType::Rounded };
        Block::bordered().border_type(kind).border_style(look.border(focused)).render(area, buffer);
    }
    let title_area = title_of(area);
    buffer.set_line(title_area.x, title_area.y, title, title_area.width);
}

/// Says at the lower edge of a frame that there are lines above and below.
fn scroll_mark(first: usize, shown: usize, of: usize, look: &Appearance, area: Rect, buffer: &mut Buffer) {
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

/// A word of the interface in the user's language.
fn word(english: &'static str, model: &Model) -> String {
    Text::from(english).render(&model.locale)
}
