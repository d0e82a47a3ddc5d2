//! What the mouse does: nothing that a key cannot do.
//!
//! A click goes to what is clicked, and a second one opens, edits or takes it, as Enter does. The wheel moves what is
//! under the pointer, whatever has the focus. On a plot a click sets the cursor, a drag moves it or, where part of the
//! axis is shown, moves that part, and the wheel zooms about the pointer.

use ratatui::{
    crossterm::event::{MouseButton, MouseEvent, MouseEventKind},
    layout::{Position, Rect},
};

use super::{act, ask, bench, dialog, list, picker, scroll};
use crate::{
    bench::{Bench, Focus},
    dialog::Dialog,
    keys::{Action, Place},
    model::{Effect, Model},
    plot,
    tab::Tab,
    view::{self, HitTarget},
};

/// Lines of a text that a notch of the wheel moves it by.
const NOTCH: isize = 3;
/// How much of the axis is left after a notch of the wheel.
const ZOOM: f64 = 0.8;

pub(super) fn happened(model: &mut Model, event: MouseEvent) -> Vec<Effect> {
    let at = Position::new(event.column, event.row);
    match event.kind {
        MouseEventKind::Down(MouseButton::Left) => {
            let spot = view::spot(model, at);
            model.notice = None;
            spot.map_or_else(Vec::new, |spot| click(model, spot, at))
        }
        MouseEventKind::Drag(MouseButton::Left) => {
            drag(model, at);
            Vec::new()
        }
        MouseEventKind::Up(_) => {
            model.held = None;
            Vec::new()
        }
        MouseEventKind::ScrollUp => turn(model, at, true),
        MouseEventKind::ScrollDown => turn(model, at, false),
        _ => Vec::new(),
    }
}

fn click(model: &mut Model, spot: HitTarget, at: Position) -> Vec<Effect> {
    let place = model.place();
    match spot {
        HitTarget::Key(action) => act(model, place, action),
        HitTarget::Offer(offer) => choose(model, offer),
        HitTarget::Below => match model.dialog {
            // A question stays until it is answered.
            Some(Dialog::Choice { .. } | Dialog::Palette { .. }) => dialog::close(model),
            _ => Vec::new(),
        },
        HitTarget::Over => Vec::new(),
        HitTarget::Form(line) => field(model, line),
        HitTarget::Pane(Tab::Plot, inside, _) => {
            let effects = look_at(model, Tab::Plot);
            point(model, inside, at);
            effects
        }
        HitTarget::Pane(tab, _, Some(part)) => go_to(model, tab, part),
        HitTarget::Tab(tab) | HitTarget::Pane(tab, _, None) => look_at(model, tab),
        HitTarget::Arrow(tab, action) => {
            let mut effects = look_at(model, tab);
            effects.extend(act(model, Place::Cells, action));
            effects
        }
        HitTarget::Listing(line) => {
            let Some(line) = line else { return Vec::new() };
            let again = model.picker.case.is_none() && model.picker.chosen == line;
            (model.picker.case, model.picker.chosen) = (None, line);
            if again { act(model, place, Action::Enter) } else { list::preview(model) }
        }
        HitTarget::Case(case) => {
            let again = model.picker.case.is_some() && model.picker.case == case;
            model.picker.case = case.or(model.picker.case);
            if again { act(model, place, Action::Enter) } else { list::preview(model) }
        }
    }
}

/// A line of the form: to it, and into it.
fn field(model: &mut Model, line: Option<usize>) -> Vec<Effect> {
    let effects = ask::end_edit(model);
    let Some(bench) = &mut model.bench else { return effects };
    let Some(line) = line else {
        bench.focus = Focus::Form;
        return effects;
    };
    let here = bench.focus == Focus::Form && bench.form.cursor == line;
    match (here, bench.form.edit.is_some()) {
        (true, true) => effects,
        (true, false) => act(model, Place::Form, Action::Enter),
        (false, _) => {
            bench.form.keep();
            (bench.focus, bench.form.cursor) = (Focus::Form, line);
            effects
        }
    }
}

/// To a tab; what is typed is kept.
fn look_at(model: &mut Model, tab: Tab) -> Vec<Effect> {
    let mut effects = ask::end_edit(model);
    let Some(bench) = &mut model.bench else { return effects };
    bench.form.keep();
    bench.focus = Focus::Pane;
    if bench.tab != tab {
        effects.extend(bench::show_tab(model, tab));
    }
    effects
}

/// A part of the page of a tab: to it, and into it.
fn go_to(model: &mut Model, tab: Tab, part: usize) -> Vec<Effect> {
    let Some(bench) = &mut model.bench else { return Vec::new() };
    let shown = bench.focus == Focus::Pane && bench.tab == tab;
    let here = shown && bench.part_mut(tab).is_some_and(|cursor| *cursor == part);
    match (here, bench.place()) {
        (true, Place::Cell) => Vec::new(),
        (true, place) => act(model, place, Action::Enter),
        (false, _) => {
            let effects = look_at(model, tab);
            if let Some(cursor) = model.bench.as_mut().and_then(|bench| bench.part_mut(tab)) {
                *cursor = part;
                scroll::bring_in(model, part);
            }
            effects
        }
    }
}

/// Chooses what lies over the screen; what is chosen already is taken.
fn choose(model: &mut Model, offer: usize) -> Vec<Effect> {
    let place = model.place();
    match &mut model.dialog {
        Some(Dialog::Palette { chosen, .. } | Dialog::Choice { chosen, .. } | Dialog::Ask { chosen, .. })
            if *chosen != offer =>
        {
            *chosen = offer;
            Vec::new()
        }
        _ => act(model, place, Action::Enter),
    }
}

/// Sets the cursor of the plot.
fn point(model: &mut Model, inside: Rect, at: Position) {
    let Some((place, _)) = place_at(model, inside, at.x) else { return };
    if let Some(bench) = &mut model.bench
        && let Some(plot) = Bench::nth(bench.plots(), bench.plot)
    {
        bench.plot_state = bench.plot_state.pointed(plot, place);
        model.held = Some(at.x);
    }
}

/// Moves the cursor of the plot that is held, or the part of the axis that is shown.
fn drag(model: &mut Model, at: Position) {
    let Some(held) = model.held else { return };
    let Some(HitTarget::Pane(Tab::Plot, inside, _)) = view::spot(model, at) else { return };
    let Some((place, cells)) = place_at(model, inside, at.x) else { return };
    let Some(bench) = &mut model.bench else { return };
    let Some(plot) = Bench::nth(bench.plots(), bench.plot) else { return };
    let state: plot::State = bench.plot_state;
    bench.plot_state = if state.view.window.is_some() {
        state.panned(plot, (f64::from(held) - f64::from(at.x)) / f64::from(cells))
    } else {
        state.pointed(plot, place)
    };
    model.held = Some(at.x);
}

/// The wheel.
fn turn(model: &mut Model, at: Position, up: bool) -> Vec<Effect> {
    let action = if up { Action::Up } else { Action::Down };
    let by = if up { -NOTCH } else { NOTCH };
    let place = model.place();
    match view::spot(model, at) {
        _ if matches!(model.dialog, Some(Dialog::Help { .. })) => {
            (0..NOTCH).flat_map(|_| act(model, place, action)).collect()
        }
        Some(HitTarget::Offer(_) | HitTarget::Over) if matches!(place, Place::List | Place::Prompt) => {
            act(model, place, action)
        }
        Some(HitTarget::Form(_)) => {
            if let Some(bench) = &mut model.bench {
                bench.form.keep();
                bench.form.step(if up { -1 } else { 1 });
            }
            Vec::new()
        }
        Some(HitTarget::Pane(Tab::Plot, inside, _)) => {
            let Some((place, _)) = place_at(model, inside, at.x) else { return Vec::new() };
            if let Some(bench) = &mut model.bench
                && let Some(plot) = Bench::nth(bench.plots(), bench.plot)
            {
                let factor = if up { ZOOM } else { 1.0 / ZOOM };
                bench.plot_state = bench.plot_state.zoomed_at(plot, place, factor);
            }
            Vec::new()
        }
        Some(HitTarget::Pane(Tab::Drawing, ..)) => {
            act(model, Place::Drawing, if up { Action::PreviousFrame } else { Action::NextFrame })
        }
        Some(HitTarget::Pane(tab, ..) | HitTarget::Arrow(tab, _)) => {
            let Some(shown) = &mut model.bench else { return Vec::new() };
            let before = std::mem::replace(&mut shown.tab, tab);
            scroll::scroll(model, by);
            if let Some(shown) = &mut model.bench {
                shown.tab = before;
            }
            Vec::new()
        }
        Some(HitTarget::Listing(_)) => {
            model.picker.case = None;
            act(model, place, action)
        }
        Some(HitTarget::Case(_)) => {
            let mut effects = picker::to_cases(model);
            if model.picker.case.is_some() {
                effects.extend(picker::act(model, action));
            }
            effects
        }
        _ => Vec::new(),
    }
}

/// The part of the axis of the shown plot at a column of the screen, and the cells of the whole of it.
fn place_at(model: &Model, inside: Rect, column: u16) -> Option<(f64, u16)> {
    let bench = model.bench.as_ref()?;
    let (plot, _) = bench.shown_plot()?;
    plot::place_at(plot, &bench.plot_state, &model.look, &model.locale, inside, column)
}
