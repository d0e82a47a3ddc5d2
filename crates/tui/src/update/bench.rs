//! Keys of a problem, wherever on its screen.

use dalembert_core::{Text, UnitSetting};

use super::{parts, with_shown};
use crate::{
    bench::StatementState,
    dialog::{Dialog, Purpose},
    effect::Effect,
    intent::Intent,
    keys::{Action, KeyContext},
    layout::Focus,
    model::Model,
    pane::Tab,
    problem::Freshness,
    view,
};

/// Does what a key means on the screen of a problem; `None` where its place says what it means.
pub(super) fn act(model: &mut Model, place: KeyContext, action: Action) -> Option<Vec<Intent>> {
    let bench = model.bench.as_mut()?;
    Some(match action {
        Action::Save => vec![Intent::Save],
        Action::SaveAs => vec![Intent::AskPath(Purpose::SaveAs)],
        Action::Export => vec![Intent::AskPath(Purpose::Export)],
        Action::ExportSeen => vec![Intent::AskPath(Purpose::ExportSeen)],
        Action::Edit => vec![Intent::EditOutside],
        Action::Blank => vec![Intent::OpenBlank(bench.problem.entry())],
        Action::Rename => {
            vec![Intent::Show(Dialog::prompt(Purpose::Title, bench.problem.document.title.clone()))]
        }
        Action::NextFilePart => parts::turn(model, 1),
        Action::PreviousFilePart => parts::turn(model, -1),
        Action::BeginProblem => {
            vec![Intent::Show(Dialog::prompt_asking(Purpose::LinkedProblem, ""))]
        }
        Action::BeginConfiguration => {
            vec![Intent::Show(Dialog::prompt_asking(Purpose::Configuration, ""))]
        }
        Action::RemovePart => parts::remove(model),
        Action::Tab(number) => {
            let tab = bench.tabs().into_iter().find(|tab| tab.0 + 1 == number);
            match tab {
                Some(tab) => vec![Intent::Turn(tab)],
                None => Intent::say(Text::new("there is no tab {number} now").with("number", number)),
            }
        }
        Action::NextTab => turn(model, 1),
        Action::PreviousTab => turn(model, -1),
        Action::Play | Action::PreviousFrame | Action::NextFrame => animate(model, action),
        Action::Copy => copy(model),
        Action::Pin => pin(model),
        Action::TryByHand => try_by_hand(model),
        Action::NextUnits => next_units(model),
        Action::Undo => changed(bench.problem.inputs.form.undo(), "nothing to undo"),
        Action::Redo => changed(bench.problem.inputs.form.redo(), "nothing to redo"),
        Action::Expand => {
            let has_next = bench.focus == Focus::Pane && view::has_room_for_next(bench, model.size.0);
            (bench.expanded, bench.beside) = match (bench.expanded, bench.beside) {
                (false, _) => (true, false),
                (true, false) if has_next => (true, true),
                _ => (false, false),
            };
            let next = match bench.focus {
                _ if !bench.expanded => return Some(Vec::new()),
                Focus::Form => "maximised; {key} restores all panes",
                Focus::Pane if has_next && !bench.beside => "{key} once more shows the next one beside it",
                Focus::Pane => return Some(Vec::new()),
            };
            vec![Intent::Say(Text::new(next).with("key", model.key(place, action)))]
        }
        Action::Statement => statement(model),
        Action::NextPane | Action::PreviousPane => {
            bench.focus = match bench.focus {
                Focus::Form => Focus::Pane,
                Focus::Pane => Focus::Form,
            };
            Vec::new()
        }
        Action::Back => return back(model, place),
        _ => return None,
    })
}

/// Reads the statement on; at its end it is collapsed, and then expanded from its beginning.
fn statement(model: &mut Model) -> Vec<Intent> {
    let seen = view::seen_of_statement(model);
    let Some((bench, (rows, of))) = model.bench.as_mut().zip(seen) else {
        return Intent::say("this problem has no statement");
    };
    let state = &mut bench.statement;
    *state = match state.first.min(of.saturating_sub(rows)) + rows {
        _ if state.is_folded => StatementState::default(),
        next if next < of => StatementState { first: next.saturating_sub(1).max(state.first + 1), ..*state },
        _ => StatementState { is_folded: true, first: 0 },
    };
    Vec::new()
}

/// One step back: from a running job, from what the pane is at, from an input to the symbol that led there, from a pane
/// that is alone. `None`: to where the place leads back.
fn back(model: &mut Model, place: KeyContext) -> Option<Vec<Intent>> {
    // Where a text is typed the key ends that first.
    if place.is_text() {
        return None;
    }
    let bench = model.bench.as_mut()?;
    if bench.is_working() {
        return Some(stop(model));
    }
    if place == KeyContext::Form && bench.shown().led_to_input() {
        bench.focus = Focus::Pane;
        return Some(Vec::new());
    }
    if place.is_pane() {
        let own = with_shown(model, |pane, problem, ui| pane.act(problem, ui, Action::Back)).flatten();
        if own.is_some() {
            return own;
        }
    }
    // The other panes come back.
    let bench = model.bench.as_mut().filter(|bench| bench.expanded)?;
    (bench.expanded, bench.beside) = (false, false);
    Some(Vec::new())
}

fn changed(changed: bool, nothing: &'static str) -> Vec<Intent> {
    if changed { vec![Intent::Changed] } else { Intent::say(nothing) }
}

/// Gives the problem a title; an empty one takes it away.
pub(super) fn rename(model: &mut Model, title: &str) -> Vec<Intent> {
    let Some(bench) = &mut model.bench else { return Vec::new() };
    title.clone_into(&mut bench.problem.document.title);
    vec![Intent::Keep]
}

/// Ends the jobs that are under way.
fn stop(model: &mut Model) -> Vec<Intent> {
    let Some(bench) = &mut model.bench else { return Vec::new() };
    let asked = bench.stop();
    let problem = &mut bench.problem;
    let said = if matches!(problem.found.state, Freshness::Solving(_)) {
        problem.found.state = Freshness::Stopped;
        problem.found.hidden |= !problem.is_near_the_solved();
        Some("solve cancelled; the next change of an input restarts it".into())
    } else {
        let said = Text::new("{tab} cancelled; the next change there restarts it");
        asked.map(|tab| said.with_text("tab", bench.pane(tab).name()))
    };
    said.map(Intent::Say).into_iter().chain([Intent::Do(Effect::Cancel)]).collect()
}

/// Compares with the present result from now on, or no more.
fn pin(model: &mut Model) -> Vec<Intent> {
    let Some(bench) = &mut model.bench else { return Vec::new() };
    let problem = &mut bench.problem;
    if problem.found.pinned.take().is_some() {
        return Intent::say("comparison off");
    }
    if problem.is_stale() || problem.found.solution.is_none() {
        return Intent::say("no result to pin: solve the problem first");
    }
    problem.found.pinned.clone_from(&problem.found.solution);
    let said = Text::new("result pinned: later answers show the difference from it; {key} unpins it");
    Intent::say(said.with("key", model.key(KeyContext::Form, Action::Pin)))
}

/// Shows everything in the next system of units.
fn next_units(model: &mut Model) -> Vec<Intent> {
    let Some(bench) = &mut model.bench else { return Vec::new() };
    let problem = &mut bench.problem;
    problem.document.units = problem.document.units.next();
    problem.document.show_changed = true;
    problem.found.pinned = problem.found.pinned.take().map(|pinned| problem.in_its_units(pinned));
    let said = match problem.document.units {
        UnitSetting::Auto => "units: the system that the inputs show".into(),
        UnitSetting::AsTyped => "units: inputs as typed, answers in those of the analysis".into(),
        UnitSetting::System(system) => Text::new("units: {system}").with("system", system.name(false)),
    };
    vec![Intent::Changed, Intent::Say(said)]
}

/// Covers what was found, or covers it no more.
fn try_by_hand(model: &mut Model) -> Vec<Intent> {
    let Some(bench) = &mut model.bench else { return Vec::new() };
    let covered = bench.problem.found.revealed.is_none();
    bench.problem.found.revealed = covered.then_some(0);
    bench.panes.iter_mut().for_each(|pane| pane.restart());
    if !covered {
        return Intent::say("results shown");
    }
    let said = Text::new("results hidden: {next} in Working reveals the next step, {all} shows all");
    let next = model.keys.anywhere(Action::Reveal).map_or_else(String::new, |key| key.name(&model.locale));
    Intent::say(said.with("next", next).with("all", model.key(KeyContext::Form, Action::TryByHand)))
}

/// Lets the animation on the screen move, holds it, or holds it at a frame beside the one that is shown.
fn animate(model: &mut Model, action: Action) -> Vec<Intent> {
    let Some((tab, frames, _)) = view::animation(model) else {
        return Intent::say("no animation on the screen");
    };
    model.playing = action == Action::Play && !model.playing;
    if let Some(frame) = model.bench.as_mut().and_then(|bench| bench.panes[tab.0].frame()) {
        let by = match action {
            Action::PreviousFrame => frames - 1,
            Action::NextFrame => 1,
            _ => 0,
        };
        *frame = (*frame % frames + by) % frames;
    }
    Vec::new()
}

fn turn(model: &mut Model, by: isize) -> Vec<Intent> {
    let Some(bench) = &model.bench else { return Vec::new() };
    let tabs = bench.tabs();
    let at = tabs.iter().position(|tab| *tab == bench.tab).unwrap_or(0);
    vec![Intent::Turn(tabs[(at as isize + by).rem_euclid(tabs.len() as isize) as usize])]
}

/// Shows the pane of a name from its first line.
pub(super) fn show_named(model: &mut Model, name: &str) -> Vec<Intent> {
    let Some(bench) = &mut model.bench else { return Vec::new() };
    let Some(tab) = bench.tab_named(name) else { return Vec::new() };
    bench.scroll[tab.0] = 0;
    vec![Intent::Turn(tab)]
}

/// Shows a pane, and asks what it needs to be found out first.
pub(super) fn show_tab(model: &mut Model, tab: Tab) -> Vec<Intent> {
    let Some(bench) = &mut model.bench else { return Vec::new() };
    // The keys go where the eye is.
    (bench.tab, bench.focus) = (tab, Focus::Pane);
    ask_for_shown(model)
}

/// Asks what the shown pane needs to be found out.
pub(super) fn ask_for_shown(model: &mut Model) -> Vec<Intent> {
    let Some(bench) = &mut model.bench else { return Vec::new() };
    let tab = bench.tab;
    let pane = &mut bench.panes[tab.0];
    let mut intents = pane.turned_to(&mut bench.problem);
    if !pane.is_answered(&bench.problem) && !bench.waits(tab) {
        intents.push(Intent::Ask);
    }
    intents
}

fn copy(model: &mut Model) -> Vec<Intent> {
    let Some(bench) = &model.bench else { return Vec::new() };
    if bench.problem.is_stale() {
        return Intent::report_error("not copied: the results shown are for other inputs");
    }
    let text = with_shown(model, |pane, problem, ui| pane.copied(problem, ui)).unwrap_or_default();
    if text.trim().is_empty() {
        let said = Text::new("no text to copy here; {key} exports the plot or drawing");
        return Intent::say(said.with("key", model.key(KeyContext::Form, Action::ExportSeen)));
    }
    vec![Intent::Say("copied".into()), Intent::Do(Effect::Copy(text))]
}
