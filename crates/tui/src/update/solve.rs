//! The inputs and their solution: solved when they change, kept against a crash, taken when they are solved.

use dalembert_core::{Text, file};
use dalembert_report::show_answer_in;

use super::ask;
use crate::{
    bench::{Bench, State},
    model::{Effect, Model},
    solver::{Job, Outcome, Work},
    tab::Tab,
    view,
};

/// The inputs are others now: they are read, and solved or found wrong; nothing older counts any more.
pub(super) fn changed(model: &mut Model) -> Vec<Effect> {
    let generation = model.next_generation();
    let readonly = model.readonly;
    let Some(bench) = &mut model.bench else { return Vec::new() };
    let mut effects = Vec::new();
    bench.found.failure = None;
    ask::forget(bench);
    match bench.form.draft.read(&bench.entry.shape()) {
        Ok(record) => {
            bench.find_wrong(Vec::new());
            bench.found.state = State::Solving(generation);
            effects.push(Effect::Solve(Job { generation, work: Work::Solve(bench.entry, record) }));
        }
        Err(errors) => {
            bench.find_wrong(errors);
            bench.found.state = State::Unread;
        }
    }
    if !readonly {
        effects.push(kept(bench));
    }
    effects
}

/// Whether a job is under way for the problem.
pub(super) fn is_working(model: &Model) -> bool {
    model.bench.as_ref().is_some_and(Bench::is_working)
}

/// Ends the jobs that are under way.
pub(super) fn stop(model: &mut Model) -> Vec<Effect> {
    let Some(bench) = &mut model.bench else { return Vec::new() };
    let asked = ask::stop(bench);
    if matches!(bench.found.state, State::Solving(_)) {
        bench.found.state = State::Stopped;
        bench.found.hidden |= !bench.is_near_the_solved();
        model.say("solve cancelled; the next change of an input restarts it");
    } else if let Some(tab) = asked {
        let said = Text::new("{tab} cancelled; the next change there restarts it");
        model.say(said.with_text("tab", tab.name()));
    }
    vec![Effect::Cancel]
}

/// What is to be remembered against a crash.
pub(super) fn kept(bench: &Bench) -> Effect {
    if !bench.is_unsaved() {
        return Effect::Forget(bench.number);
    }
    Effect::Keep {
        problem: bench.number,
        original: bench.file.as_ref().map(|file| file.path.clone()),
        text: file::write(&bench.problem(), bench.text()),
    }
}

/// Takes the outcome of the newest job.
pub(super) fn take(bench: &mut Bench, outcome: Outcome) {
    bench.found.state = State::Current;
    (bench.reading.symbol, bench.reading.trail) = (None, Vec::new());
    match outcome.result {
        Ok(mut solution) => {
            for (answer, display) in &bench.show {
                // What a file asks for and cannot be is shown as it would be without.
                let _ = solution.as_mut().map(|solution| show_answer_in(solution, answer, display));
            }
            bench.found.solution = solution.or(bench.found.solution.take());
            bench.found.of = Some(bench.form.draft.clone());
            (bench.found.failure, bench.found.hidden) = (None, false);
        }
        Err(failure) => {
            bench.found.hidden |= !bench.is_near_the_solved();
            bench.found.failure = Some(failure);
        }
    }
    if !bench.tabs().contains(&bench.tab) {
        bench.tab = Tab::Results;
    }
}

/// Tells a warning that a change brought, where the results are not on the screen.
pub(super) fn tell_hidden(model: &mut Model, problem: u64, before: Option<&[Text]>) {
    let Some(bench) = model.shown_bench().filter(|bench| bench.number == problem) else { return };
    if view::shows(model, Tab::Results) {
        return;
    }
    let Some(found) = bench.found.solution.as_ref().filter(|_| bench.reading.revealed.is_none()) else {
        return;
    };
    let is_new = |warning: &&Text| before.is_some_and(|before| !before.contains(warning));
    if let Some(warning) = found.warnings.iter().find(is_new) {
        let said = Text::new("new warning: {warning}").with_text("warning", warning.clone());
        model.complain(said);
    }
}
