//! The line of tabs, and the titles of panes that have none.

use std::ops::Range;

use dalembert_units::superscript;
use ratatui::{
    style::{Modifier, Style},
    text::{Line, Span},
};

use super::word;
use crate::{
    bench::Bench,
    form::FilePart,
    glyphs::filter_untrusted,
    layout::Focus,
    look::{Appearance, Glyph},
    model::Model,
    pane::Tab,
    text::width,
};

/// A line of tabs, and what its cells belong to, from left to right.
pub(super) struct Bar<T> {
    pub(super) line: Line<'static>,
    cells: Vec<(Option<T>, usize)>,
}

impl<T: Copy> Bar<T> {
    /// These tabs, of which one may be chosen; where there is no room for all, those around it.
    fn of(tabs: &[(T, String)], chosen: Option<usize>, style: Style, look: &Appearance, room: usize) -> Self {
        let cells =
            |range: Range<usize>| tabs[range].iter().map(|(_, name)| width(name) + 1).sum::<usize>() + 1;
        let (mut first, mut end, middle) = (0, tabs.len(), chosen.unwrap_or(0));
        // Where not all fit, the far ones go first, and arrows report it.
        while cells(first..end) + 2 * usize::from(first > 0 || end < tabs.len()) > room && end - first > 1 {
            if end - 1 > middle && (end - 1 - middle >= middle - first) {
                end -= 1;
            } else {
                first += 1;
            }
        }
        let mut bar = Self { line: Line::default(), cells: Vec::new() };
        bar.push(None, " ".into(), Style::new());
        if first > 0 {
            bar.push(Some(tabs[first - 1].0), format!("{} ", look.glyph(Glyph::Left)), look.dim());
        }
        for (n, (tab, name)) in tabs.iter().enumerate().take(end).skip(first) {
            bar.push(Some(*tab), name.clone(), if Some(n) == chosen { style } else { look.dim() });
            bar.push(None, " ".into(), Style::new());
        }
        if end < tabs.len() {
            bar.push(Some(tabs[end].0), format!("{} ", look.glyph(Glyph::Right)), look.dim());
        }
        bar
    }

    fn push(&mut self, tab: Option<T>, text: String, style: Style) {
        self.cells.push((tab, width(&text)));
        self.line.push_span(Span::styled(text, style));
    }

    /// The tab at a cell of the line.
    pub(super) fn at(&self, mut cell: usize) -> Option<T> {
        for (tab, cells) in &self.cells {
            match cell.checked_sub(*cells) {
                Some(rest) => cell = rest,
                None => return *tab,
            }
        }
        None
    }
}

/// The tabs of the panes with their numbers, the chosen one marked. Where not all names fit, the far ones are numbers
/// alone: none is out of sight.
pub(super) fn bar(model: &Model, bench: &Bench, columns: u16) -> Bar<Tab> {
    let look = &model.look;
    let tabs = bench.tabs();
    let room = usize::from(columns).saturating_sub(4);
    let chosen = tabs.iter().position(|tab| *tab == bench.tab).unwrap_or(0);
    let mut names: Vec<(String, String)> = tabs
        .iter()
        .map(|tab| {
            let name = word(bench.pane(*tab).name(), model);
            let place = place_of_shown(bench, *tab).filter(|_| *tab == bench.tab);
            (number_of(*tab, look), place.map_or(name.clone(), |place| format!("{name} {place}")))
        })
        .collect();
    let cells = |names: &[(String, String)]| {
        names.iter().map(|(number, name)| width(number) + width(name) + 1).sum::<usize>() + 1
    };
    while cells(&names) > room {
        let far = (0..names.len()).filter(|at| *at != chosen && !names[*at].1.is_empty());
        let Some(far) = far.max_by_key(|at| at.abs_diff(chosen)) else { break };
        names[far].1.clear();
    }
    let style = if bench.focus == Focus::Pane {
        look.border(true).patch(look.title()).add_modifier(Modifier::REVERSED)
    } else {
        look.title().add_modifier(Modifier::UNDERLINED)
    };
    let mut bar = Bar { line: Line::default(), cells: Vec::new() };
    bar.push(None, " ".into(), Style::new());
    for (n, (tab, (number, name))) in tabs.into_iter().zip(names).enumerate() {
        bar.push(Some(tab), number, look.key());
        bar.push(Some(tab), name, if n == chosen { style } else { look.dim() });
        bar.push(None, " ".into(), Style::new());
    }
    bar
}

/// The names of the problems and configurations of a file, by their places; those with an error are marked.
pub(super) fn of_parts(model: &Model, bench: &Bench, columns: u16) -> Bar<usize> {
    let (form, look) = (&bench.problem.inputs.form, &model.look);
    let (parts, shown) = (form.parts_at(bench.problem.wrong().map(|error| error.path.as_str())), form.part());
    let name = |(part, is_wrong): &(FilePart, bool)| {
        let title = filter_untrusted(&part.title().render(&model.locale)).replace('\n', " ");
        if *is_wrong { format!("{}{title}", look.glyph(Glyph::Bad)) } else { title }
    };
    let names: Vec<(usize, String)> = parts.iter().map(name).enumerate().collect();
    let chosen = parts.iter().position(|(part, _)| *part == shown);
    let style = look.title().add_modifier(Modifier::UNDERLINED);
    Bar::of(&names, chosen, style, look, columns.into())
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

/// The number of a tab, by which a key leads there; raised, so that it is no part of the name.
fn number_of(tab: Tab, look: &Appearance) -> String {
    let number = tab.0 as i32 + 1;
    if look.ascii { number.to_string() } else { superscript(number) }
}

/// The place of the picture after the one that a pane shows: ` 2/2 `.
pub(super) fn place_of_next(model: &Model, bench: &Bench, tab: Tab) -> Line<'static> {
    let (at, of) = bench.place_of_shown(tab).unwrap_or((1, 1));
    Line::styled(format!(" {}/{of} ", at % of + 1), model.look.dim())
}

/// The place of the picture that a pane shows among several: `1/2`.
fn place_of_shown(bench: &Bench, tab: Tab) -> Option<String> {
    bench.place_of_shown(tab).map(|(place, of)| format!("{place}/{of}"))
}
