//! The help: every key, those of the place where it was asked for first, and of a search those that it finds.

use dalembert_core::Text;
use ratatui::{
    buffer::Buffer,
    layout::{Position, Rect},
    style::Style,
    text::{Line, Span},
    widgets::{Clear, Widget},
};
use tui_input::Input;

use super::{boxed, draw_input, draw_lines, screen_of, scroll_mark, word};
use crate::{
    dialog::Dialog,
    keys::{ALWAYS, Action, Binding, COMMON, KeyContext, PANES, PROBLEM},
    layout,
    look::Glyph,
    model::{Model, Screen},
    text::{padded, width, wrapped},
};

/// Cells for the keys of an action: three of them, with modifiers.
const KEYS: usize = 20;
/// From so many cells on the help stands in two columns.
const TWO_COLUMNS: usize = 110;
/// Cells between two columns.
const GAP: usize = 2;
/// Meanings of the marks of the list.
const MARKS: [(Glyph, &str); 5] = [
    (Glyph::Hollow, "analysis open; exercise opened"),
    (Glyph::Full, "open with unsaved changes"),
    (Glyph::Good, "exercise done; case: all published values agree"),
    (Glyph::Unequal, "a published value is disputed: see Sources"),
    (Glyph::Bad, "a published value disagrees"),
];
/// Notes on typing, below the keys.
const TYPING: [&str; 2] = [
    "A quantity is a number and a unit: 20.3 mm, 1000 rpm, 200 kN/mm^2, 5 kg*mm, 2*pi*50 rad/s, 1/2 in. Comma and point are both decimal marks. A vector: (300; 200) m/s.",
    "Typing a digit on a field replaces its value; the solution follows as you type. a adds a row, also on the heading of a list.",
];

/// Draws the help above the footer; answers where the cursor of its search stands.
pub(super) fn draw(
    model: &Model,
    search: &Input,
    scroll: usize,
    screen: Rect,
    buffer: &mut Buffer,
) -> Option<Position> {
    let area = area_of(screen);
    Clear.render(area, buffer);
    let title = format!(" {} ", word("Keyboard shortcuts", model));
    boxed(&Line::styled(title, model.look.border(true)), true, &model.look, area, buffer);
    let inner = layout::inside(area);
    let [line, rest] = split(inner);
    if search.value().is_empty() {
        let hint = word("type to search", model);
        buffer.set_stringn(line.x + 2, line.y, hint, line.width.saturating_sub(2).into(), model.look.dim());
    }
    let lines = lines(model, search.value(), rest.width.into());
    draw_lines(&lines, scroll, rest, buffer);
    scroll_mark(scroll, rest.height.into(), lines.len(), &model.look, area, buffer);
    draw_input(model, search, "/ ", Style::new(), line, buffer)
}

/// The most that the help can be scrolled.
pub(crate) fn longest_scroll(model: &Model) -> usize {
    let Some(Dialog::Help { search, .. }) = &model.dialog else { return 0 };
    let [_, rest] = split(layout::inside(area_of(screen_of(model))));
    lines(model, search.value(), rest.width.into()).len().saturating_sub(rest.height.into())
}

fn area_of(screen: Rect) -> Rect {
    let [_, _, _, footer] = layout::frame(screen);
    Rect { height: screen.height - footer.height, ..screen }
}

/// The line of the search, and what is below it.
fn split(inner: Rect) -> [Rect; 2] {
    let line = Rect { height: inner.height.min(1), ..inner };
    [line, Rect { y: inner.y + line.height, height: inner.height - line.height, ..inner }]
}

/// A heading and its keys.
struct Section {
    name: String,
    /// Keys and what they do.
    rows: Vec<(String, String)>,
}

/// Lines of the help in so many cells, of what a search finds, in two columns where there is room.
fn lines(model: &Model, search: &str, room: usize) -> Vec<Line<'static>> {
    let words: Vec<String> = search.split_whitespace().map(str::to_lowercase).collect();
    // A section is found by its name too, with all of its keys.
    let is_found = |name: &str, row: &(String, String)| {
        let text = format!("{name} {} {}", row.0, row.1).to_lowercase();
        words.iter().all(|word| text.contains(word))
    };
    let sections = sections(model).into_iter().map(|mut section| {
        section.rows.retain(|row| is_found(&section.name, row));
        section
    });
    let sections: Vec<Section> = sections.filter(|section| !section.rows.is_empty()).collect();
    let is_wide = room >= TWO_COLUMNS;
    let column = if is_wide { (room - GAP) / 2 } else { room };
    let all: Vec<Vec<Line<'static>>> =
        sections.iter().map(|section| lines_of(model, section, column)).collect();
    if all.is_empty() {
        return vec![Line::styled(word("nothing found", model), model.look.dim())];
    }
    let mut lines = if is_wide { side_by_side(&all, column) } else { all.concat() };
    if words.is_empty() {
        lines.extend(notes(model, room));
    }
    lines
}

fn lines_of(model: &Model, section: &Section, room: usize) -> Vec<Line<'static>> {
    let look = &model.look;
    let mut lines = vec![Line::styled(section.name.clone(), look.title())];
    for (keys, name) in &section.rows {
        let keys = padded(keys, KEYS.min(room / 2), look);
        let left = room.saturating_sub(width(&keys) + 3);
        for (n, text) in wrapped(name, left).into_iter().enumerate() {
            let keys = if n == 0 { keys.clone() } else { " ".repeat(width(&keys)) };
            lines.push(Line::from(vec![Span::styled(format!("  {keys} "), look.key()), Span::raw(text)]));
        }
    }
    lines.push(Line::default());
    lines
}

/// Sections in two columns of about the same height, one after the other.
fn side_by_side(sections: &[Vec<Line<'static>>], column: usize) -> Vec<Line<'static>> {
    let half = sections.iter().map(Vec::len).sum::<usize>().div_ceil(2);
    let (mut left, mut right) = (Vec::new(), Vec::new());
    for section in sections {
        let side =
            if right.is_empty() && left.len() + section.len() / 2 <= half { &mut left } else { &mut right };
        side.extend(section.iter().cloned());
    }
    (0..left.len().max(right.len()))
        .map(|n| {
            let mut spans = styled(left.get(n));
            let cells: usize = spans.iter().map(Span::width).sum();
            spans.push(Span::raw(" ".repeat((column + GAP).saturating_sub(cells))));
            spans.extend(styled(right.get(n)));
            Line::from(spans)
        })
        .collect()
}

/// The spans of a line, each with the style of the whole.
fn styled(line: Option<&Line<'static>>) -> Vec<Span<'static>> {
    line.map_or_else(Vec::new, |line| {
        line.spans
            .iter()
            .map(|span| Span::styled(span.content.clone(), line.style.patch(span.style)))
            .collect()
    })
}

/// The keys of every place, those of the place where help was asked for first. A key that a user moved in one place alone
/// stands with that place.
fn sections(model: &Model) -> Vec<Section> {
    let screen = model.screen;
    // Keys that several places share are shown once, as they hold in one of them.
    let home = |binding: &Binding| match screen {
        Screen::Picker => KeyContext::Picker,
        Screen::Bench if PANES.contains(binding) => KeyContext::Pane,
        Screen::Bench => KeyContext::Form,
    };
    let here = match (screen, &model.bench) {
        (Screen::Bench, Some(bench)) => bench.place(),
        _ if model.picker.typing => KeyContext::Filter,
        _ => KeyContext::Picker,
    };
    let of_place = |place: KeyContext| {
        let differs = |binding: &&Binding| {
            model.keys.keys_of(place, binding) != model.keys.keys_of(home(binding), binding)
        };
        let own = || place.table().iter().copied().flatten();
        let shared = place.bindings().skip(own().count()).filter(differs);
        section(model, place.name(), place, own().chain(shared))
    };
    let mut all = vec![of_place(here)];
    if screen == Screen::Bench {
        if here.is_pane() {
            all.push(section(model, "In every tab", KeyContext::Pane, PANES.iter()));
        }
        all.push(section(model, "In a problem", KeyContext::Form, PROBLEM.iter()));
    }
    all.push(section(model, "Everywhere", home(&COMMON[0]), COMMON.iter().chain(ALWAYS)));
    let others: Vec<KeyContext> = match screen {
        Screen::Picker => vec![KeyContext::Picker, KeyContext::Filter, KeyContext::Prompt],
        Screen::Bench => {
            let own = model.keys.places().filter(|place| matches!(place, KeyContext::Own(_)));
            let before = [KeyContext::Form, KeyContext::Edit, KeyContext::Pane].into_iter();
            before
                .chain(own)
                .chain([KeyContext::Cells, KeyContext::Plan, KeyContext::Cell, KeyContext::Sheet])
                .collect()
        }
    };
    all.extend(others.into_iter().filter(|place| *place != here).map(of_place));
    if screen == Screen::Bench && !here.is_pane() {
        all.push(section(model, "In every tab", KeyContext::Pane, PANES.iter()));
    }
    all
}

fn section(
    model: &Model,
    name: &'static str,
    place: KeyContext,
    bindings: impl Iterator<Item = &'static Binding>,
) -> Section {
    let row = |binding: &'static Binding| {
        // What has no key is found by its name.
        let keys = match model.keys.keys_of(place, binding) {
            [] => model.key(place, Action::Palette),
            keys => keys.iter().map(|key| key.name(&model.locale)).collect::<Vec<_>>().join("  "),
        };
        (keys, word(binding.name, model))
    };
    // Of nine keys that do alike the first speaks for all.
    let is_listed = |binding: &&'static Binding| match binding.action {
        Action::Tab(2..) => model.keys.keys_of(place, binding) != binding.keys,
        _ => true,
    };
    Section { name: word(name, model), rows: bindings.filter(is_listed).map(row).collect() }
}

/// The marks of the list, and what is to be known of typing.
fn notes(model: &Model, room: usize) -> Vec<Line<'static>> {
    let look = &model.look;
    let say = |text: &'static str| Text::from(text).render(&model.locale);
    let dim = |text: &str| {
        let style = look.dim();
        wrapped(text, room).into_iter().map(|text| Line::styled(text, style)).collect::<Vec<_>>()
    };
    let mut lines = Vec::new();
    if model.screen == Screen::Picker {
        lines.extend(
            MARKS.iter().flat_map(|(glyph, text)| dim(&format!("{} {}", look.glyph(*glyph), say(text)))),
        );
        lines.push(Line::default());
    }
    lines.extend(TYPING.iter().flat_map(|text| dim(&say(text))));
    lines
}
