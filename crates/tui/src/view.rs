//! The screens, drawn from the model alone.

mod arrangement;
mod bars;
mod dialog;
mod field;
mod form;
mod help;
mod picker;
mod tabs;
mod target;

use std::{rc::Rc, time::Duration};

use dalembert_core::Text;
use ratatui::{
    Frame,
    buffer::Buffer,
    layout::{Position, Rect},
    style::{Modifier, Style},
    text::Line,
    widgets::{Block, BorderType, Widget},
};
use tui_input::Input;

use self::arrangement::{Arrangement, Pages, PlacedPane};
pub(crate) use self::{
    arrangement::has_room_for_next,
    help::longest_scroll as longest_scroll_of_help,
    target::{HitTarget, spot},
};
use crate::{
    bench::Bench,
    dialog::Dialog,
    glyphs::filter_untrusted,
    layout::{self, Focus},
    look::{Appearance, Glyph},
    model::Model,
    pane::{Content, Page, Tab, Ui},
    pixels::Picture,
    replay::above_caption,
    text::{draw_lines, width},
};

/// The parts of the screen of a problem.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Areas {
    /// The line at the top.
    pub(crate) title: Rect,
    /// The tabs of problems and configurations; empty where there is one problem alone.
    pub(crate) parts: Rect,
    /// The inputs, where they are seen.
    pub(crate) form: Option<Rect>,
    /// The panes that are seen.
    pub(crate) panes: Vec<PlacedPane>,
    /// Pages of panes that are set already.
    pages: Pages,
    /// The line about the field under the cursor; empty where there is no room.
    pub(crate) help: Rect,
    /// The line of keys.
    pub(crate) footer: Rect,
}

impl Areas {
    /// The area of a pane, where it is seen.
    pub(crate) fn area_of(&self, tab: Tab) -> Option<Rect> {
        self.panes.iter().find(|placed| placed.tab == tab && !placed.is_next).map(|placed| placed.area)
    }
}

/// The least screen that shows more than a name.
const LEAST: (u16, u16) = (16, 4);

/// Draws everything; the pictures in pixels come back. Where something lies over one of them, all are drawn in cells.
pub fn view(model: &Model, frame: &mut Frame<'_>) -> Vec<Picture> {
    let area = above_caption(model, frame.area());
    let buffer = frame.buffer_mut();
    if area.is_empty() {
        return Vec::new();
    }
    if area.width < LEAST.0 || area.height < LEAST.1 {
        buffer.set_stringn(area.x, area.y, "dalembert", area.width.into(), model.look.title());
        return Vec::new();
    }
    let (mut cursor, mut pictures) = draw_screen(model, &model.look, area, buffer);
    if let Some(dialog) = &model.dialog {
        if is_covered(model, dialog, &pictures, area) {
            buffer.reset();
            pictures = draw_screen(model, &Appearance { pixels: None, ..model.look }, area, buffer).1;
        }
        cursor = dialog::draw(model, dialog, area, buffer);
    }
    model.look.ground(buffer);
    if model.look.basic && cursor.is_none() {
        cursor = focused_cell(buffer);
    }
    if let Some(position) = cursor.filter(|position| area.contains(*position)) {
        frame.set_cursor_position(position);
    }
    pictures
}

/// Draws the screen under a dialog.
fn draw_screen(
    model: &Model,
    look: &Appearance,
    area: Rect,
    buffer: &mut Buffer,
) -> (Option<Position>, Vec<Picture>) {
    match model.shown_bench() {
        Some(bench) if bench.field.is_some() => (field::draw(model, bench, area, buffer), Vec::new()),
        Some(bench) => {
            let areas = areas_in(area, model, bench, bench.focus);
            bars::title(model, areas.title, buffer);
            if !areas.parts.is_empty() {
                let bar = tabs::of_parts(model, bench, areas.parts.width);
                buffer.set_line(areas.parts.x, areas.parts.y, &bar.line, areas.parts.width);
            }
            let cursor = areas.form.and_then(|area| form::draw(model, bench, area, buffer));
            let pictures = draw_panes(model, look, bench, &areas, buffer);
            bars::help(model, areas.help, buffer);
            bars::footer_below(model, areas.footer, animation_in(bench, &areas).is_some(), buffer);
            (cursor, pictures)
        }
        None => {
            let [title, body, help, footer] = layout::frame(area);
            bars::title(model, title, buffer);
            let cursor = picker::draw(model, body, buffer);
            bars::help(model, help, buffer);
            bars::footer(model, footer, buffer);
            (cursor, Vec::new())
        }
    }
}

/// True if a dialog lies over a cell of a picture.
fn is_covered(model: &Model, dialog: &Dialog, pictures: &[Picture], screen: Rect) -> bool {
    if pictures.is_empty() {
        return false;
    }
    // A sign that nothing draws, but for what holds no text.
    const EMPTY: &str = "\u{E000}";
    let mut under = Buffer::empty(screen);
    under.content.iter_mut().for_each(|cell| _ = cell.set_symbol(EMPTY));
    dialog::draw(model, dialog, screen, &mut under);
    pictures.iter().any(|picture| picture.area.positions().any(|at| under[at].symbol() != EMPTY))
}

/// Draws every pane of what was found.
fn draw_panes(
    model: &Model,
    look: &Appearance,
    bench: &Bench,
    areas: &Areas,
    buffer: &mut Buffer,
) -> Vec<Picture> {
    let mut pictures = Vec::new();
    for placed in &areas.panes {
        let (tab, area) = (placed.tab, placed.area);
        let ui = Ui { look, ..surroundings(model, bench, tab, area) };
        let pane = bench.pane(tab);
        if placed.is_next {
            boxed(&tabs::place_of_next(model, bench, tab), false, ui.look, area, buffer);
            pictures.extend(pane.draw_next(&bench.problem, &ui, ui.area, buffer));
            continue;
        }
        let title = if placed.has_tabs {
            tabs::bar(model, bench, area.width).line
        } else {
            tabs::title(model, bench, tab)
        };
        boxed(&title, ui.focused, ui.look, area, buffer);
        if ui.area.is_empty() {
            continue;
        }
        let page = match areas.pages.get(&(tab.0, ui.area.width)) {
            Some(page) => Rc::clone(page),
            None => Rc::new(pane.page(&bench.problem, &ui, ui.area.width)),
        };
        let (lines, height) = (page.lines.len(), usize::from(ui.area.height));
        let first = ui.scroll.min(lines.saturating_sub(height));
        page.draw(first, ui.area, buffer);
        scroll_mark(first, height, lines, ui.look, area, buffer);
        // A line is left free between the text and what is drawn below it.
        let used = (lines + usize::from(lines > 0)).min(height) as u16;
        let room = Rect { y: ui.area.y + used, height: ui.area.height - used, ..ui.area };
        pictures.extend(pane.draw(&bench.problem, &ui, room, buffer));
    }
    pictures
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

/// The screen, without the caption of a session that is played.
pub(crate) fn screen_of(model: &Model) -> Rect {
    above_caption(model, Rect::new(0, 0, model.size.0, model.size.1))
}

/// The parts of the screen of a problem.
pub(crate) fn areas_of(model: &Model, bench: &Bench, focus: Focus) -> Areas {
    areas_in(screen_of(model), model, bench, focus)
}

fn areas_in(screen: Rect, model: &Model, bench: &Bench, focus: Focus) -> Areas {
    let has_parts = bench.problem.inputs.form.parts().len() > 1;
    let [title, parts, body, help, footer] = layout::bench(screen, has_parts);
    let Arrangement { form, panes, pages } = arrangement::arrange(model, bench, focus, body);
    Areas { title, parts, form, panes, pages, help, footer }
}

/// The pane at a place of the screen, its inside, and the tab whose name stands just there.
fn pane_at(model: &Model, bench: &Bench, areas: &Areas, at: Position) -> Option<(Tab, Rect, Option<Tab>)> {
    let placed = areas.panes.iter().find(|placed| !placed.is_next && placed.area.contains(at))?;
    let title = title_of(placed.area);
    let named = (placed.has_tabs && title.contains(at))
        .then(|| tabs::bar(model, bench, placed.area.width).at(usize::from(at.x - title.x)))
        .flatten();
    Some((placed.tab, layout::inside(placed.area), named))
}

/// The line of the page of a pane that stands at a place of its inside.
fn line_at(model: &Model, bench: &Bench, tab: Tab, inside: Rect, at: Position) -> Option<usize> {
    let lines = page(model, bench, tab, inside.width).lines.len();
    let first = bench.scroll[tab.0].min(lines.saturating_sub(inside.height.into()));
    let line = first + usize::from(at.y.checked_sub(inside.y)?);
    (inside.contains(at) && line < lines).then_some(line)
}

/// The form and the panes on the screen of a problem: name, content and area of each, frame included.
pub fn seen_panes(model: &Model) -> Vec<(&'static str, Content, Rect)> {
    let Some(bench) = model.shown_bench() else { return Vec::new() };
    let areas = areas_of(model, bench, bench.focus);
    let form = areas.form.map(|area| ("Inputs", Content::Cells, area));
    let pane = |placed: &PlacedPane| {
        let pane = bench.pane(placed.tab);
        (pane.name(), pane.content(), placed.area)
    };
    form.into_iter().chain(areas.panes.iter().map(pane)).collect()
}

/// The inside of the pane that is shown, were the keys to act on it.
pub(crate) fn area_of_shown(model: &Model) -> Option<Rect> {
    area_of_pane(model, model.bench.as_ref()?.tab)
}

/// The inside of a pane where it is seen; of the one that is shown, were the keys to act on it.
pub(crate) fn area_of_pane(model: &Model, tab: Tab) -> Option<Rect> {
    let bench = model.bench.as_ref()?;
    let seen = |focus| areas_of(model, bench, focus).area_of(tab);
    let area = if tab == bench.tab { seen(Focus::Pane) } else { seen(bench.focus).or(seen(Focus::Pane)) };
    area.map(layout::inside)
}

/// Rows of the text of the statement that are seen, and all; where the form is not seen, as if it had the keys.
pub(crate) fn seen_of_statement(model: &Model) -> Option<(usize, usize)> {
    let bench = model.shown_bench()?;
    let area = |focus| areas_of(model, bench, focus).form;
    form::seen_of_statement(model, bench, area(bench.focus).or_else(|| area(Focus::Form))?)
}

/// True if a pane of the problem is on the screen.
pub(crate) fn shows(model: &Model, tab: Tab) -> bool {
    model.shown_bench().is_some_and(|bench| areas_of(model, bench, bench.focus).area_of(tab).is_some())
}

/// Duration of each frame of an animation; `None` while none plays on the screen.
pub fn tempo(model: &Model) -> Option<Duration> {
    let (_, frames, period) = animation(model).filter(|_| model.playing && model.dialog.is_none())?;
    Duration::try_from_secs_f64(period / (frames as f64 * model.animation_speed)).ok()
}

/// The animation on the screen: its pane, its frames, and their time.
pub(crate) fn animation(model: &Model) -> Option<(Tab, usize, f64)> {
    let bench = model.shown_bench().filter(|bench| bench.field.is_none())?;
    bench.animated()?;
    animation_in(bench, &areas_of(model, bench, bench.focus))
}

/// The animation in one of these areas.
fn animation_in(bench: &Bench, areas: &Areas) -> Option<(Tab, usize, f64)> {
    let tab = bench.animated().filter(|_| !bench.problem.is_stale())?;
    let (frames, period) = bench.pane(tab).frames(&bench.problem);
    areas.area_of(tab).map(|_| (tab, frames, period))
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
    let width = width(&mark) as u16;
    if width + 4 <= area.width {
        buffer.set_string(area.right() - width - 2, area.bottom() - 1, mark, look.dim());
    }
}

/// A word of the interface in the user's language.
fn word(english: &'static str, model: &Model) -> String {
    Text::from(english).render(&model.locale)
}

/// A line of text with its cursor.
fn draw_input(
    model: &Model,
    input: &Input,
    before: &str,
    style: Style,
    area: Rect,
    buffer: &mut Buffer,
) -> Option<Position> {
    if area.is_empty() {
        return None;
    }
    let offset = width(before);
    let room = usize::from(area.width).saturating_sub(offset + 1);
    let scroll = input.visual_scroll(room);
    let text: String = input.value().chars().skip(scroll).take(room).collect();
    buffer.set_stringn(area.x, area.y, before, area.width.into(), model.look.key());
    buffer.set_stringn(area.x + offset as u16, area.y, filter_untrusted(&text), room, style);
    Some(Position::new(
        area.x + (offset + input.visual_cursor().saturating_sub(scroll).min(room)) as u16,
        area.y,
    ))
}
