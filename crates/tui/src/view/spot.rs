//! What lies at a place of the screen, for the mouse: asked of the functions that draw it.

use ratatui::layout::{Position, Rect};

use super::{bars, dialog, form, pane, picker};
use crate::{bench::Tab, keys::Action, layout, model::Model};

/// What lies at a place of the screen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Spot {
    /// A key of the footer.
    Key(Action),
    /// A line of the form, by its number; nothing below the last.
    Form(Option<usize>),
    /// The name of a tab.
    Tab(Tab),
    /// A pane, and its inside.
    Pane(Tab, Rect),
    /// A line of the list of analyses, by its number; nothing between them.
    Listing(Option<usize>),
    /// A published case beside that list.
    Case(Option<usize>),
    /// A line to choose in what lies over the screen.
    Offer(usize),
    /// What lies over the screen, elsewhere.
    Over,
    /// The screen below it.
    Below,
}

/// What lies at a place.
pub(crate) fn spot(model: &Model, at: Position) -> Option<Spot> {
    let screen = Rect::new(0, 0, model.size.0, model.size.1);
    let [_, body, _, footer] = layout::frame(screen);
    if let Some(action) = bars::action_at(model, footer, at) {
        return Some(Spot::Key(action));
    }
    if let Some(over) = &model.dialog {
        return Some(dialog::spot(model, over, screen, at));
    }
    let Some(bench) = model.shown_bench() else {
        return body.contains(at).then(|| picker::spot(model, body, at)).flatten();
    };
    let areas = layout::bench(screen, bench.focus, bench.expanded || model.look.basic);
    if let Some(area) = areas.form.filter(|area| area.contains(at)) {
        return Some(Spot::Form(form::line_at(model, bench, area, at)));
    }
    let (tab, inside, named) = pane::pane_at(model, bench, &areas, at)?;
    Some(named.map_or(Spot::Pane(tab, inside), Spot::Tab))
}
