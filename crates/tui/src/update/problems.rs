//! The open problems: a new one, the next one, one in the place of another.

use dalembert_core::Text;

use super::{remembering, solve};
use crate::{
    bench::{Bench, State},
    glyphs::filter_untrusted,
    keys::{Action, Place},
    model::{Effect, Model, Screen},
};

/// So many problems are open at once.
const MOST: usize = 9;

/// Opens a problem beside those that are open, and solves it.
pub(super) fn open(model: &mut Model, mut bench: Bench) -> Vec<Effect> {
    let Some(mut effects) = make_room(model) else {
        model.complain(
            Text::new("{count} problems are open, the maximum; {key} closes the current one")
                .with("count", MOST)
                .with("key", model.key(Place::Form, Action::CloseProblem)),
        );
        return Vec::new();
    };
    bench.plot_state.marker = model.marker;
    bench.number = model.next_generation();
    put_aside(model);
    model.bench = Some(bench);
    model.screen = Screen::Bench;
    model.dialog = None;
    effects.extend(solve::changed(model));
    effects.extend(remembering::opened(model));
    effects
}

/// Takes the place of the problem that is shown.
pub(super) fn replace(model: &mut Model, mut bench: Bench) -> Vec<Effect> {
    bench.plot_state.marker = model.marker;
    bench.number = model.bench.as_ref().map_or(0, |old| old.number);
    model.bench = Some(bench);
    model.screen = Screen::Bench;
    model.dialog = None;
    solve::changed(model)
}

/// Shows an open problem, as it was left.
pub(super) fn bring(model: &mut Model, number: u64) -> Vec<Effect> {
    if let Some(at) = model.others.iter().position(|bench| bench.number == number) {
        let mut bench = model.others.swap_remove(at);
        // What was asked for long ago may have been given up.
        bench.judging = bench.cases.iter().any(|judged| judged.verdicts.is_some());
        put_aside(model);
        model.bench = Some(bench);
    }
    model.screen = Screen::Bench;
    // Only the newest job is worked on: what this one waited for may never come.
    let Some(bench) = &mut model.bench else { return Vec::new() };
    if matches!(bench.found.state, State::Solving(_)) {
        return solve::changed(model);
    }
    bench.ask.awaited = None;
    super::ask::turn_to(model)
}

/// Shows the problem that was opened after this one; after the last, the first. From the list, back to this one.
pub(super) fn next(model: &mut Model) -> Vec<Effect> {
    let all: Vec<u64> = model.problems().iter().map(|bench| bench.number).collect();
    let here = model.bench.as_ref().map(|bench| bench.number);
    let at = all.iter().position(|number| Some(*number) == here).unwrap_or(0);
    match (model.screen, all.len()) {
        (_, 0) => model.say("no open problem"),
        (Screen::Bench, 1) => model.say("no other open problem"),
        (Screen::Picker, _) => return bring(model, all[at]),
        (Screen::Bench, _) => return bring(model, all[(at + 1) % all.len()]),
    }
    Vec::new()
}

/// What a problem is called among others: its analysis, and its file or its title.
pub(super) fn name(model: &Model, bench: &Bench) -> String {
    let title = Text::from(bench.entry.about.title).render(&model.locale);
    let file = bench.file.as_ref().and_then(|file| file.path.file_name());
    let own = match file {
        Some(file) => file.to_string_lossy().into_owned(),
        None => bench.title.clone(),
    };
    if own.is_empty() { title } else { format!("{title} ({})", filter_untrusted(&own).replace('\n', " ")) }
}

fn put_aside(model: &mut Model) {
    if let Some(mut bench) = model.bench.take() {
        // What is being typed counts.
        bench.form.keep();
        model.others.push(bench);
    }
}

/// Room for one problem more: where there is none, the oldest that is a published case and nothing else is closed.
fn make_room(model: &mut Model) -> Option<Vec<Effect>> {
    let all = model.problems();
    if all.len() < MOST {
        return Some(Vec::new());
    }
    let untouched = |bench: &&&Bench| !bench.is_unsaved() && bench.file.is_none() && bench.pinned.is_none();
    let number = all.iter().find(untouched)?.number;
    model.others.retain(|bench| bench.number != number);
    if model.bench.as_ref().is_some_and(|bench| bench.number == number) {
        model.bench = None;
    }
    Some(vec![Effect::Forget(number)])
}
