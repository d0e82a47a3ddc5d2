//! The open problems: a new one, the next one, one in the place of another.

use dalembert_core::Text;

use super::bench;
use crate::{
    bench::Bench,
    effect::Effect,
    intent::Intent,
    keys::{Action, KeyContext},
    model::{MOST_PROBLEMS, Model, Screen, gives_way},
    problem::{Freshness, Problem},
    remembered::{HistoryChange, Progress},
};

/// Opens a problem beside those that are open, and solves it.
pub(super) fn open(model: &mut Model, mut problem: Problem) -> Vec<Intent> {
    let Some(mut intents) = make_room(model) else {
        return Intent::report_error(
            Text::new("{count} problems are open, the maximum; {key} closes the current one")
                .with("count", MOST_PROBLEMS)
                .with("key", model.key(KeyContext::Form, Action::CloseProblem)),
        );
    };
    problem.number = model.next_generation();
    put_aside(model);
    let id = problem.entry().about.id.to_owned();
    show(model, problem);
    intents.extend([
        Intent::Changed,
        Intent::Reach(Progress::Opened),
        Intent::Remember(HistoryChange::Open(id)),
    ]);
    intents
}

/// Takes the place of the problem that is shown.
pub(super) fn replace(model: &mut Model, mut problem: Problem) -> Vec<Intent> {
    problem.number = model.bench.as_ref().map_or(0, |old| old.problem.number);
    show(model, problem);
    vec![Intent::Changed]
}

fn show(model: &mut Model, problem: Problem) {
    let mut bench = Bench::new(problem, model.marker);
    bench.field = super::field::wanted(model, &bench.problem);
    if bench.problem.document.is_exercise {
        bench.tab =
            bench.all_tabs().find(|tab| bench.pane(*tab).covers_results(&bench.problem)).unwrap_or_default();
    }
    model.bench = Some(bench);
    model.screen = Screen::Bench;
    model.dialog = None;
}

/// Shows an open problem, as it was left.
pub(super) fn bring(model: &mut Model, number: u64) -> Vec<Intent> {
    if let Some(at) = model.others.iter().position(|bench| bench.problem.number == number) {
        let mut bench = model.others.swap_remove(at);
        // What was asked for long ago may have been given up.
        bench.problem.checking = bench.problem.cases.iter().any(|checked| checked.verdicts.is_some());
        put_aside(model);
        model.bench = Some(bench);
    }
    model.screen = Screen::Bench;
    // Only the newest job is worked on: what this one waited for may never come.
    let Some(bench) = &mut model.bench else { return Vec::new() };
    if matches!(bench.problem.found.state, Freshness::Solving(_)) {
        return vec![Intent::ReadLinked, Intent::Changed];
    }
    bench.pending = None;
    // The keys stay where they were when it was left.
    let mut intents = vec![Intent::ReadLinked];
    intents.extend(bench::ask_for_shown(model));
    intents
}

/// Shows the problem that was opened after this one; after the last, the first. From the list, back to this one.
pub(super) fn next(model: &Model) -> Vec<Intent> {
    let all: Vec<u64> = model.problems().iter().map(|bench| bench.problem.number).collect();
    let here = model.bench.as_ref().map(|bench| bench.problem.number);
    let at = all.iter().position(|number| Some(*number) == here).unwrap_or(0);
    match (model.screen, all.len()) {
        (_, 0) => Intent::say("no open problem"),
        (Screen::Bench, 1) => Intent::say("no other open problem"),
        (Screen::Picker, _) => vec![Intent::Bring(all[at])],
        (Screen::Bench, _) => vec![Intent::Bring(all[(at + 1) % all.len()])],
    }
}

/// The case that is shown, as it was published, is worked through so far at least.
pub(super) fn reach(model: &Model, progress: Progress) -> Vec<Intent> {
    let Some(problem) = model.bench.as_ref().map(|bench| &bench.problem) else { return Vec::new() };
    let origin = problem.document.origin.as_ref();
    let Some(case) = origin.filter(|case| case.draft == problem.inputs.form.draft) else {
        return Vec::new();
    };
    let (analysis, case) = (problem.entry().about.id.to_owned(), case.name.clone());
    let progress = progress.max(model.remembered.progress(&analysis, &case));
    vec![Intent::Remember(HistoryChange::Reach { analysis, case, progress })]
}

fn put_aside(model: &mut Model) {
    if let Some(mut bench) = model.bench.take() {
        // What is being typed counts.
        bench.problem.inputs.form.keep();
        model.others.push(bench);
    }
}

/// Room for one problem more: where there is none, the oldest that gives way is closed.
fn make_room(model: &mut Model) -> Option<Vec<Intent>> {
    let all = model.problems();
    if all.len() < MOST_PROBLEMS {
        return Some(Vec::new());
    }
    let number = all.iter().find(|bench| gives_way(bench))?.problem.number;
    model.others.retain(|bench| bench.problem.number != number);
    if model.bench.as_ref().is_some_and(|bench| bench.problem.number == number) {
        model.bench = None;
    }
    Some(vec![Intent::Do(Effect::Forget(number))])
}
