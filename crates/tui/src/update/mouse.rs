//! Mouse actions: nothing that a key cannot do.
//!
//! A click goes to what is clicked, and a second one opens, edits or takes it, as Enter does. The wheel moves what is
//! under the pointer, whatever has the focus. On a plot the curves are read under the pointer, a click sets the cursor, a
//! drag moves it or, where part of the axis is shown, moves that part, and the wheel zooms about the pointer.

use ratatui::{
    crossterm::event::{MouseButton, MouseEvent, MouseEventKind},
    layout::{Position, Rect},
};

use crate::{
    dialog::Dialog,
    intent::Intent,
    keys::{Action, KeyContext},
    layout::Focus,
    model::Model,
    pane::{Content, Gesture, Pane, Tab},
    view::{self, HitTarget},
};

/// Lines of a text that a notch of the wheel moves it by.
const NOTCH: isize = 3;

pub(super) fn happened(model: &mut Model, event: MouseEvent) -> Vec<Intent> {
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
        MouseEventKind::Moved => {
            hover(model, at);
            Vec::new()
        }
        MouseEventKind::ScrollUp => turn(model, at, true),
        MouseEventKind::ScrollDown => turn(model, at, false),
        _ => Vec::new(),
    }
}

fn click(model: &mut Model, spot: HitTarget, at: Position) -> Vec<Intent> {
    let place = model.place();
    match spot {
        HitTarget::Key(action) => vec![Intent::Press(place, action)],
        HitTarget::Offer(offer) => choose(model, offer),
        HitTarget::Below => match model.dialog {
            // A question stays until it is answered.
            Some(Dialog::Choice { .. } | Dialog::Palette { .. }) => vec![Intent::Close],
            _ => Vec::new(),
        },
        HitTarget::Over => Vec::new(),
        HitTarget::Form(line) => field(model, line),
        HitTarget::Pane(tab, inside, None) => {
            if is_touched(model, tab, inside, Gesture::Press, at) {
                model.held = Some(at.x);
            }
            look_at(model, tab)
        }
        HitTarget::Pane(tab, _, Some(part)) => go_to(model, tab, part),
        HitTarget::Part(part) => vec![Intent::ShowPart(part)],
        HitTarget::Tab(tab) => look_at(model, tab),
        HitTarget::Arrow(tab, action) => {
            let mut intents = look_at(model, tab);
            let place = model.bench.as_ref().map_or(KeyContext::Cells, |bench| bench.pane(tab).place());
            intents.push(Intent::Press(place, action));
            intents
        }
        HitTarget::Listing(line) => {
            let Some(line) = line else { return Vec::new() };
            let again = model.picker.case.is_none() && model.picker.chosen == line;
            (model.picker.case, model.picker.chosen) = (None, line);
            vec![if again { Intent::Press(place, Action::Enter) } else { Intent::Preview }]
        }
        HitTarget::Case(case) => {
            let again = model.picker.case.is_some() && model.picker.case == case;
            model.picker.case = case.or(model.picker.case);
            model.picker.typing = false;
            vec![if again { Intent::Press(place, Action::Enter) } else { Intent::Preview }]
        }
    }
}

/// A line of the form: to it, and into it.
fn field(model: &mut Model, line: Option<usize>) -> Vec<Intent> {
    let mut intents = vec![Intent::EndEdit];
    let Some(bench) = &mut model.bench else { return intents };
    let form = &mut bench.problem.inputs.form;
    let here = bench.focus == Focus::Form && line == Some(form.cursor);
    if here && form.edit.is_none() {
        intents.push(Intent::Press(KeyContext::Form, Action::Enter));
    } else if let Some(line) = line.filter(|_| !here) {
        form.keep();
        form.cursor = line;
    }
    bench.focus = Focus::Form;
    intents
}

/// To a pane; what is typed is kept.
fn look_at(model: &mut Model, tab: Tab) -> Vec<Intent> {
    let Some(bench) = &mut model.bench else { return Vec::new() };
    bench.problem.inputs.form.keep();
    bench.focus = Focus::Pane;
    let turn = (bench.tab != tab).then_some(Intent::Turn(tab));
    [Intent::EndEdit].into_iter().chain(turn).collect()
}

/// A part of the page of a pane: to it, and into it.
fn go_to(model: &mut Model, tab: Tab, part: usize) -> Vec<Intent> {
    let Some(bench) = &mut model.bench else { return Vec::new() };
    let shown = bench.focus == Focus::Pane && bench.tab == tab;
    let here = shown && bench.cursor(tab).is_some_and(|cursor| *cursor == part);
    match (here, bench.place()) {
        (true, KeyContext::Cell) => Vec::new(),
        (true, place) => vec![Intent::Press(place, Action::Enter)],
        (false, _) => {
            let mut intents = look_at(model, tab);
            intents.push(Intent::GoToPart(part));
            intents
        }
    }
}

/// Chooses what lies over the screen; what is chosen already is taken.
fn choose(model: &mut Model, offer: usize) -> Vec<Intent> {
    let place = model.place();
    match &mut model.dialog {
        Some(Dialog::Palette { chosen, .. } | Dialog::Choice { chosen, .. } | Dialog::Ask { chosen, .. })
            if *chosen != offer =>
        {
            *chosen = offer;
            Vec::new()
        }
        _ => vec![Intent::Press(place, Action::Enter)],
    }
}

/// Lets a pane take what the mouse does on it; whether that means something there.
fn is_touched(model: &mut Model, tab: Tab, inside: Rect, gesture: Gesture, at: Position) -> bool {
    model.with_pane(tab, inside, |pane, problem, ui| pane.mouse(problem, ui, gesture, at)).unwrap_or(false)
}

/// Lets the pane under the pointer read what is there, and the one that it came from forget it.
fn hover(model: &mut Model, at: Position) {
    let over = match view::spot(model, at) {
        Some(HitTarget::Pane(tab, inside, _)) if is_touched(model, tab, inside, Gesture::Hover, at) => {
            Some(tab)
        }
        _ => None,
    };
    let before = std::mem::replace(&mut model.under_pointer, over);
    if let Some(tab) = before.filter(|tab| over != Some(*tab)) {
        is_touched(model, tab, Rect::ZERO, Gesture::Leave, at);
    }
}

/// Moves what is held by the mouse.
fn drag(model: &mut Model, at: Position) {
    let Some(held) = model.held else { return };
    if let Some(HitTarget::Pane(tab, inside, _)) = view::spot(model, at)
        && is_touched(model, tab, inside, Gesture::Drag(held), at)
    {
        model.held = Some(at.x);
    }
}

/// The wheel.
fn turn(model: &mut Model, at: Position, up: bool) -> Vec<Intent> {
    let action = if up { Action::Up } else { Action::Down };
    let by = if up { -NOTCH } else { NOTCH };
    let place = model.place();
    match view::spot(model, at) {
        _ if matches!(model.dialog, Some(Dialog::Help { .. })) => {
            (0..NOTCH).map(|_| Intent::Press(place, action)).collect()
        }
        Some(HitTarget::Offer(_) | HitTarget::Over)
            if matches!(place, KeyContext::List | KeyContext::Prompt) =>
        {
            vec![Intent::Press(place, action)]
        }
        Some(HitTarget::Form(_)) => {
            if let Some(bench) = &mut model.bench {
                bench.problem.inputs.form.keep();
                bench.problem.inputs.form.step(if up { -1 } else { 1 });
            }
            Vec::new()
        }
        Some(HitTarget::Pane(tab, inside, _)) => {
            let gesture = if up { Gesture::WheelUp } else { Gesture::WheelDown };
            if is_touched(model, tab, inside, gesture, at) {
                return Vec::new();
            }
            // A picture that has no other use for the wheel may move.
            let picture = model.bench.as_ref().map(|bench| bench.pane(tab));
            let picture = picture.filter(|pane| pane.content() == Content::Picture).map(Pane::place);
            vec![match picture {
                Some(place) => {
                    Intent::Press(place, if up { Action::PreviousFrame } else { Action::NextFrame })
                }
                None => Intent::Scroll(tab, by),
            }]
        }
        Some(HitTarget::Arrow(tab, _)) => vec![Intent::Scroll(tab, by)],
        Some(HitTarget::Listing(_)) => {
            model.picker.case = None;
            vec![Intent::Press(place, action)]
        }
        Some(HitTarget::Case(_)) => {
            model.go_to_cases();
            let step = model.picker.case.map(|_| Intent::Press(place, action));
            [Intent::Preview].into_iter().chain(step).collect()
        }
        _ => Vec::new(),
    }
}
