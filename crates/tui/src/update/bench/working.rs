//! Keys of the worked solution: steps are revealed, symbols followed.

use dalembert_core::{Text, trace::Op};

use crate::update::scroll::{area, bring_in};
use crate::{
    bench::Focus,
    keys::{self, Action},
    model::Model,
    panes::working::{Place, step_of, symbols},
    tab::Tab,
    view,
};

/// Covers what was found, or covers it no more.
pub(super) fn try_by_hand(model: &mut Model) {
    let Some(bench) = &mut model.bench else { return };
    bench.reading.revealed = match bench.reading.revealed {
        None => Some(0),
        Some(_) => None,
    };
    (bench.reading.symbol, bench.reading.trail) = (None, Vec::new());
    let covered = bench.reading.revealed.is_some();
    let key = |place, action| model.key(place, action);
    let said = if covered {
        Text::new("results hidden: {next} in Working reveals the next step, {all} shows all")
            .with("next", key(keys::Place::Working, Action::Reveal))
            .with("all", key(keys::Place::Form, Action::TryByHand))
    } else {
        "results shown".into()
    };
    model.say(said);
}

/// Whether the key is one of the worked solution of the present inputs.
pub(super) fn act(model: &mut Model, action: Action) -> bool {
    let Some(bench) = &mut model.bench else { return false };
    let Some(solution) = &bench.found.solution else { return false };
    match (action, bench.reading.symbol) {
        (Action::Reveal, _) if bench.reading.revealed.is_some() => {
            let step = bench.reading.steps(solution);
            if bench.reading.reveal(solution) {
                model.say("every step is revealed");
            }
            bring_in(model, step);
        }
        (Action::Left | Action::Right, _) | (Action::Enter, None) => {
            let from = first_seen(model);
            let Some(bench) = &model.bench else { return false };
            let Some(solution) = &bench.found.solution else { return false };
            match bench.reading.beside(solution, from, action != Action::Left) {
                Some(place) => put(model, Some(place)),
                None => model.say("no further symbol"),
            }
        }
        (Action::Enter, Some(place)) => {
            let Some(id) = symbols(solution, place.0).get(place.1).copied() else {
                model.say("this step depends on no other symbol");
                return true;
            };
            if let Some(step) = step_of(solution, id) {
                bench.reading.trail.push(place);
                put(model, Some((step, 0)));
            } else if let Op::Given { path, .. } = &solution.trace.node(id).op {
                bench.form.go_to_nearest(path);
                bench.focus = Focus::Form;
            }
        }
        _ => return false,
    }
    true
}

/// Back to the symbol that was followed here; from the first one, to no symbol at all.
pub(super) fn back(model: &mut Model) {
    let Some(bench) = &mut model.bench else { return };
    let before = bench.reading.trail.pop();
    put(model, before);
}

fn put(model: &mut Model, symbol: Option<Place>) {
    if let Some(bench) = &mut model.bench {
        bench.reading.symbol = symbol;
    }
    if let Some((step, _)) = symbol {
        bring_in(model, step);
    }
}

/// The first step that is seen.
fn first_seen(model: &Model) -> usize {
    let (Some(area), Some(bench)) = (area(model), &model.bench) else { return 0 };
    let page = view::page(model, bench, Tab::Working, area.width);
    let first = bench.scroll[Tab::Working as usize].min(page.lines.len().saturating_sub(area.height.into()));
    page.starts.iter().position(|start| *start >= first).unwrap_or(0)
}
