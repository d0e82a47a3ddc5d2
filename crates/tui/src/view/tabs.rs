//! The line of tabs, and the titles of panes that have none.

use ratatui::{
    style::{Modifier, Style},
    text::{Line, Span},
};

use super::word;
use crate::{
    bench::Bench,
    layout::Focus,
    look::{Appearance, Glyph},
    model::Model,
    pane::Tab,
    text::width,
};

/// A line of tabs, and what its cells belong to, from left to right.
pub(super) struct Bar {
    pub(super) line: Line<'static>,
    pub(super) cells: Vec<(Option<Tab>, usize)>,
}

/// The names of these tabs, the chosen one marked; where there is no room for all, those around it.
pub(super) fn bar(model: &Model, bench: &Bench, tabs: &[Tab], columns: u16) -> Bar {
    let names: Vec<String> = tabs
        .iter()
        .map(|tab| match place_of_shown(bench, *tab).filter(|_| *tab == bench.tab) {
            Some(place) => format!("{} {place}", word(bench.pane(*tab).name(), model)),
            None => word(bench.pane(*tab).name(), model),
        })
        .collect();
    let chosen = tabs.iter().position(|tab| *tab == bench.tab).unwrap_or(0);
    let room = usize::from(columns).saturating_sub(4);
    let cells =
        |range: std::ops::Range<usize>| names[range].iter().map(|name| width(name) + 1).sum::<usize>() + 1;
    let (mut first, mut end) = (0, names.len());
    // Where not all fit, the far ones go first, and arrows report it.
    while cells(first..end) + 2 * usize::from(first > 0 || end < names.len()) > room && end - first > 1 {
        if end - 1 > chosen && (end - 1 - chosen >= chosen - first) {
            end -= 1;
        } else {
            first += 1;
        }
    }
    let look = &model.look;
    let focused = bench.focus == Focus::Pane;
    let mut bar = Bar { line: Line::default(), cells: Vec::new() };
    let mut push = |tab: Option<Tab>, text: String, style: Style| {
        bar.cells.push((tab, width(&text)));
        bar.line.push_span(Span::styled(text, style));
    };
    push(None, " ".into(), Style::new());
    if first > 0 {
        push(Some(tabs[first - 1]), format!("{} ", look.glyph(Glyph::Left)), look.dim());
    }
    for (n, name) in names.iter().enumerate().take(end).skip(first) {
        let style = match (tabs[n] == bench.tab, focused) {
            (true, true) => look.border(true).patch(look.title()).add_modifier(Modifier::REVERSED),
            (true, false) => look.title().add_modifier(Modifier::UNDERLINED),
            (false, _) => look.dim(),
        };
        push(Some(tabs[n]), name.clone(), style);
        push(None, " ".into(), Style::new());
    }
    if end < names.len() {
        push(Some(tabs[end]), format!("{} ", look.glyph(Glyph::Right)), look.dim());
    }
    bar
}

/// The name of a tab that has a frame of its own, and which of several it shows.
pub(super) fn title(model: &Model, bench: &Bench, tab: Tab) -> Line<'static> {
    let look: &Appearance = &model.look;
    let focused = bench.focus == Focus::Pane && bench.tab == tab;
    let place = place_of_shown(bench, tab).map_or_else(String::new, |place| format!("{place} "));
    let style = match (focused, bench.tab == tab) {
        (true, _) => look.border(true).patch(look.title()).add_modifier(Modifier::REVERSED),
        (false, true) => look.title().add_modifier(Modifier::UNDERLINED),
        _ => look.dim(),
    };
    Line::from(vec![
        Span::raw(" "),
        Span::styled(word(bench.pane(tab).name(), model), style),
        Span::raw(" "),
        Span::styled(place, look.dim()),
    ])
}

/// The place of the picture that a pane shows among several: `1/2`.
fn place_of_shown(bench: &Bench, tab: Tab) -> Option<String> {
    bench.place_of_shown(tab).map(|(place, of)| format!("{place}/{of}"))
}
