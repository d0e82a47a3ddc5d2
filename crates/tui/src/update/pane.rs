//! Keys of the shown pane, and the part of it that is seen.

use dalembert_core::Text;

use super::with_shown;
use crate::{
    intent::Intent,
    keys::{Action, KeyContext},
    layout::Focus,
    model::Model,
    pane::Tab,
    plot::Marker,
    view,
};

/// A key on a pane: its own, or one that reads any pane.
pub(super) fn act(model: &mut Model, action: Action) -> Vec<Intent> {
    if let Some(Some(intents)) = with_shown(model, |pane, problem, ui| pane.act(problem, ui, action)) {
        return intents;
    }
    let height = view::area_of_shown(model).map_or(1, |area| isize::from(area.height as i16).max(1));
    let Some(bench) = &mut model.bench else { return Vec::new() };
    let by = match action {
        Action::Up => -1,
        Action::Down => 1,
        Action::PageUp => -height,
        Action::PageDown | Action::Reveal => height,
        Action::First => isize::MIN,
        Action::Last => isize::MAX,
        Action::Back => {
            bench.focus = Focus::Form;
            return Vec::new();
        }
        Action::NextDisplayUnit | Action::NextDigits | Action::Give | Action::UsualQuestions => {
            return Intent::say("the answers are in Results");
        }
        Action::Enter if bench.place() == KeyContext::Pane => {
            let said = Text::new("nothing to open here: {key} loads a case in Sources");
            return Intent::say(said.with("key", model.key(KeyContext::Pane, Action::Enter)));
        }
        _ => return Vec::new(),
    };
    vec![Intent::Scroll(bench.tab, by)]
}

/// Scrolls a pane.
pub(super) fn scroll(model: &mut Model, tab: Tab, by: isize) -> Vec<Intent> {
    let seen = view::area_of_pane(model, tab).zip(model.bench.as_ref());
    let last = seen.map(|(area, bench)| {
        let lines = view::page(model, bench, tab, area.width).lines.len();
        lines.saturating_sub(usize::from(area.height))
    });
    if let Some((bench, last)) = model.bench.as_mut().zip(last) {
        let first = &mut bench.scroll[tab.0];
        *first = (*first).min(last).saturating_add_signed(by).min(last);
    }
    Vec::new()
}

/// Scrolls the shown pane so that one of its parts is seen from its first line.
pub(super) fn bring_in(model: &mut Model, part: usize) -> Vec<Intent> {
    let Some((area, bench)) = view::area_of_shown(model).zip(model.bench.as_ref()) else {
        return Vec::new();
    };
    let tab = bench.tab;
    let page = view::page(model, bench, tab, area.width);
    let height = usize::from(area.height);
    let begin = page.starts.get(part).copied().unwrap_or(0);
    let end = page.starts.get(part + 1).copied().unwrap_or(page.lines.len());
    let now = bench.scroll[tab.0];
    let to = if begin < now || end - begin >= height { begin } else { now.max(end.saturating_sub(height)) };
    if let Some(bench) = &mut model.bench {
        bench.scroll[tab.0] = if part == 0 { 0 } else { to };
    }
    Vec::new()
}

/// The cursor of the shown pane goes to a part of its page.
pub(super) fn go_to_part(model: &mut Model, part: usize) -> Vec<Intent> {
    let Some(bench) = &mut model.bench else { return Vec::new() };
    let Some(cursor) = bench.cursor(bench.tab) else { return Vec::new() };
    *cursor = part;
    vec![Intent::BringIn(part)]
}

/// Curves are drawn with another marker, here and in problems that are opened later.
pub(super) fn mark(model: &mut Model, marker: Marker) -> Vec<Intent> {
    model.marker = marker;
    if let Some(bench) = &mut model.bench {
        bench.marker = marker;
    }
    Vec::new()
}
