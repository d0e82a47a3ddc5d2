//! Hit targets of the mouse, asked of the functions that draw them.

use ratatui::layout::{Position, Rect};

use super::{areas_of, bars, dialog, form, line_at, page, pane_at, picker, screen_of, tabs};
use crate::{keys::Action, layout, model::Model, pane::Tab};

/// Cells of the arrow at the left of a line that has two.
const ARROW: u16 = 2;

/// Hit target at a place of the screen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum HitTarget {
    /// A key of the footer.
    Key(Action),
    /// A line of the form, by its number; nothing below the last.
    Form(Option<usize>),
    /// The tab of a problem or a configuration, by its place.
    Part(usize),
    /// The name of a tab.
    Tab(Tab),
    /// A pane, its inside, and which part of its page stands there: a case, an answer, a cell.
    Pane(Tab, Rect, Option<usize>),
    /// An arrow of a pane, beside what it is about.
    Arrow(Tab, Action),
    /// A line of the list of analyses, by its number; nothing between them.
    Listing(Option<usize>),
    /// A published case beside that list.
    Case(Option<usize>),
    /// A line to choose in what lies over the screen.
    Offer(usize),
    /// Dialog over the screen, elsewhere.
    Over,
    /// The screen below it.
    Below,
}

/// Hit target at a place.
pub(crate) fn spot(model: &Model, at: Position) -> Option<HitTarget> {
    let screen = screen_of(model);
    let [_, body, _, footer] = layout::frame(screen);
    if let Some(action) = bars::action_at(model, footer, at) {
        return Some(HitTarget::Key(action));
    }
    if let Some(over) = &model.dialog {
        return Some(dialog::spot(model, over, screen, at));
    }
    let Some(bench) = model.shown_bench() else {
        return body.contains(at).then(|| picker::spot(model, body, at)).flatten();
    };
    if bench.field.is_some() {
        return None;
    }
    let areas = areas_of(model, bench, bench.focus);
    if areas.parts.contains(at) {
        let bar = tabs::of_parts(model, bench, areas.parts.width);
        return bar.at(usize::from(at.x - areas.parts.x)).map(HitTarget::Part);
    }
    if let Some(area) = areas.form.filter(|area| area.contains(at)) {
        return Some(HitTarget::Form(form::line_at(model, bench, area, at)));
    }
    let (tab, inside, named) = pane_at(model, bench, &areas, at)?;
    if let Some(named) = named {
        return Some(HitTarget::Tab(named));
    }
    let line = line_at(model, bench, tab, inside, at);
    if line.is_some_and(|line| bench.pane(tab).has_arrows(line)) {
        let left = at.x < inside.x + ARROW;
        return Some(HitTarget::Arrow(tab, if left { Action::Left } else { Action::Right }));
    }
    let part = line.and_then(|line| page(model, bench, tab, inside.width).part_at(line));
    Some(HitTarget::Pane(tab, inside, part))
}
