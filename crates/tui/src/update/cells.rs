//! Keys of the cells of a pane, and the jobs that take time there.

use tui_input::InputRequest;

use super::{plans, with_shown};
use crate::{
    ask::Reply,
    bench::Bench,
    dialog::Purpose,
    effect::Effect,
    form::LONGEST,
    intent::Intent,
    keys::Action,
    layout::Focus,
    model::Model,
    solver::{Job, JobOutcome, Work},
    text_entry::TextEntry,
};

/// A key on the cells of a pane.
pub(super) fn act(model: &mut Model, action: Action) -> Vec<Intent> {
    match action {
        Action::Up => step(model, -1),
        Action::Down => step(model, 1),
        Action::PageUp => step(model, -10),
        Action::PageDown => step(model, 10),
        Action::First => step(model, isize::MIN),
        Action::Last => step(model, isize::MAX),
        Action::Enter if begin(model, None) => Vec::new(),
        Action::Enter => own(model, Action::Right),
        Action::Clear if begin(model, Some(String::new())) => typed(model),
        Action::Back => {
            if let Some(bench) = &mut model.bench {
                bench.focus = Focus::Form;
            }
            Vec::new()
        }
        Action::SavePlan => plans::save(model),
        Action::OpenPlan => vec![Intent::AskPath(Purpose::OpenPlan)],
        _ => own(model, action),
    }
}

/// A key while a cell is typed in.
pub(super) fn act_in_cell(model: &mut Model, action: Action) -> Vec<Intent> {
    match action {
        Action::Enter => end_edit(model),
        Action::Back => give_up(model),
        Action::Down | Action::Up => {
            let mut intents = end_edit(model);
            intents.extend(step(model, if action == Action::Down { 1 } else { -1 }));
            intents
        }
        _ => Vec::new(),
    }
}

/// Ends what is typed in a cell, and keeps it.
pub(super) fn end_edit(model: &mut Model) -> Vec<Intent> {
    let edit = model.bench.as_mut().and_then(|bench| bench.edit.take());
    let kept = edit.and_then(|_| with_shown(model, |pane, problem, _| pane.kept(problem)));
    kept.unwrap_or_default()
}

/// Ends what is typed in a cell, which has the text again that it had before.
fn give_up(model: &mut Model) -> Vec<Intent> {
    let Some(edit) = model.bench.as_mut().and_then(|bench| bench.edit.take()) else { return Vec::new() };
    if !edit.is_changed() {
        return Vec::new();
    }
    with_shown(model, |pane, problem, _| pane.typed(problem, edit.original().to_owned()));
    vec![Intent::Ask]
}

/// A digit on a cell begins a new text.
pub(super) fn begin_by_typing(
    model: &mut Model,
    character: char,
    request: Option<InputRequest>,
) -> Vec<Intent> {
    let begins = character.is_ascii_digit() || matches!(character, '(' | '-' | '−' | '√' | '≤' | '≥');
    let Some(request @ InputRequest::InsertChar(_)) = request.filter(|_| begins) else { return Vec::new() };
    if !begin(model, Some(String::new())) {
        return Vec::new();
    }
    if let Some(edit) = model.bench.as_mut().and_then(|bench| bench.edit.as_mut()) {
        edit.handle(request);
    }
    typed(model)
}

/// The text of the cell is another now.
pub(super) fn typed(model: &mut Model) -> Vec<Intent> {
    let edit = model.bench.as_ref().and_then(|bench| bench.edit.as_ref());
    let decimal = model.locale.style.decimal;
    let Some(text) = edit.map(|input| decimal.to_point(input.value())) else { return Vec::new() };
    with_shown(model, |pane, problem, _| pane.typed(problem, text));
    vec![Intent::Ask]
}

/// Asks again what the shown pane is to say of the present inputs; what it asked before is not wanted any more.
pub(super) fn ask(model: &mut Model) -> Vec<Intent> {
    let Some(bench) = model.shown_bench().filter(|bench| !bench.problem.is_stale()) else {
        return Vec::new();
    };
    match bench.shown().question(&bench.problem) {
        Some(question) => vec![Intent::Await(Work::Ask(question))],
        None if bench.waits(bench.tab) => {
            let _ = model.bench.as_mut().and_then(Bench::stop);
            vec![Intent::Do(Effect::Cancel)]
        }
        None => Vec::new(),
    }
}

/// Has something done for the shown pane, beside the solver. Only the newest job is worked on: another pane that waits
/// asks again when it is turned to.
pub(super) fn begin_job(model: &mut Model, work: Work) -> Vec<Intent> {
    let generation = model.next_generation();
    let Some(bench) = &mut model.bench else { return Vec::new() };
    if !bench.waits(bench.tab) {
        bench.stop();
    }
    bench.pending = Some((generation, bench.tab));
    vec![Intent::Do(Effect::Ask(Job { generation, work }))]
}

/// Takes what was found.
pub(super) fn answered(model: &mut Model, outcome: JobOutcome) -> Vec<Intent> {
    let Some(bench) = &mut model.bench else { return Vec::new() };
    let Some((_, tab)) = bench.pending.filter(|(number, _)| *number == outcome.generation) else {
        return Vec::new();
    };
    if !outcome.reply.as_ref().is_some_and(Reply::is_partial) {
        bench.pending = None;
    }
    let intents = bench.panes[tab.0].answered(&mut bench.problem, outcome.reply);
    if tab == bench.tab { intents } else { Vec::new() }
}

/// The shown pane does what a key means.
fn own(model: &mut Model, action: Action) -> Vec<Intent> {
    with_shown(model, |pane, problem, ui| pane.act(problem, ui, action)).flatten().unwrap_or_default()
}

/// Begins to type in the cell under the cursor, in its text or in an empty one.
fn begin(model: &mut Model, text: Option<String>) -> bool {
    let Some(bench) = &mut model.bench else { return false };
    let Some(old) = bench.shown().cell(&bench.problem) else { return false };
    let cut = |text: String| text.chars().take(LONGEST).collect::<String>();
    bench.edit = Some(match text {
        Some(text) => TextEntry::new(cut(text)).begun_from(old),
        None => TextEntry::selected(cut(old)),
    });
    true
}

fn step(model: &mut Model, by: isize) -> Vec<Intent> {
    let Some(bench) = &mut model.bench else { return Vec::new() };
    let last = bench.shown().cells(&bench.problem).saturating_sub(1);
    let Some(cursor) = bench.cursor(bench.tab) else { return Vec::new() };
    *cursor = cursor.saturating_add_signed(by).min(last);
    vec![Intent::BringIn(*cursor)]
}
