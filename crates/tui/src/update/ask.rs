//! Keys of what is asked of a problem: the user's own answers, which input matters, studies.

use dalembert_core::{Refusal, SolveError, check::Verdict, is_within, vary};
use dalembert_units::{Decimal, with_point};
use ratatui::crossterm::event::{KeyCode, KeyEvent};
use tui_input::{Input, InputRequest};

use super::{remember_done, request, scroll::bring_in, type_in};
use crate::{
    ask::{self, Question, Reply},
    bench::{Bench, CellOf, Focus, State},
    form,
    keys::Action,
    model::{Effect, Model},
    solver::{Job, Outcome, Work},
    tab::Tab,
};

/// A key on the cells of a tab.
pub(super) fn act(model: &mut Model, action: Action) -> Vec<Effect> {
    match action {
        Action::Up => step(model, -1),
        Action::Down => step(model, 1),
        Action::PageUp => step(model, -10),
        Action::PageDown => step(model, 10),
        Action::First => step(model, isize::MIN),
        Action::Last => step(model, isize::MAX),
        Action::Enter if !begin(model, None) => return choose(model, 1),
        Action::Clear if begin(model, Some(String::new())) => return typed(model),
        Action::Toggle => show_ours(model),
        Action::Left => return choose(model, -1),
        Action::Right => return choose(model, 1),
        Action::Back => {
            if let Some(bench) = &mut model.bench {
                bench.focus = Focus::Form;
            }
        }
        _ => {}
    }
    Vec::new()
}

/// A key while a cell is typed in.
pub(super) fn act_in_cell(model: &mut Model, action: Action) -> Vec<Effect> {
    match action {
        Action::Enter | Action::Back => end_edit(model),
        Action::Down | Action::Up => {
            let effects = end_edit(model);
            step(model, if action == Action::Down { 1 } else { -1 });
            effects
        }
        _ => Vec::new(),
    }
}

/// Ends what is typed in a cell, and keeps it.
pub(super) fn end_edit(model: &mut Model) -> Vec<Effect> {
    let edit = model.bench.as_mut().and_then(|bench| bench.ask.edit.take());
    if edit.is_some() { praise(model) } else { Vec::new() }
}

/// A digit on a cell begins a new text.
pub(super) fn begin_by_typing(model: &mut Model, key: KeyEvent) -> Vec<Effect> {
    let begins = matches!(key.code, KeyCode::Char(c) if c.is_ascii_digit() || matches!(c, '(' | '-' | '−' | '√' | '≤' | '≥'));
    let Some(request @ InputRequest::InsertChar(_)) = request(key).filter(|_| begins) else {
        return Vec::new();
    };
    if begin(model, Some(String::new())) { type_in(model, &[request]) } else { Vec::new() }
}

/// The text of the cell is another now.
pub(super) fn typed(model: &mut Model) -> Vec<Effect> {
    let Some(bench) = &mut model.bench else { return Vec::new() };
    let Some(text) = bench.ask.edit.as_ref().map(|input| input.value().to_owned()) else { return Vec::new() };
    let text = match model.locale.style.decimal {
        Decimal::Comma => with_point(&text).into_owned(),
        Decimal::Point => text,
    };
    match bench.cell() {
        Some(CellOf::Answer(name)) => bench.ask.check.set(&name, text),
        Some(CellOf::Tolerance(path)) => {
            bench.ask.sensitivity.set(&path, text);
            bench.ask.study.found = None;
        }
        Some(CellOf::Study(cell)) => {
            if let Some(names) = bench.subject().map(|subject| subject.names()) {
                bench.ask.study.keep(names);
            }
            bench.ask.study.set(cell, text);
            bench.ask.study.found = None;
        }
        None => {}
    }
    renew(model)
}

/// Asks again what the shown tab is to say of the present inputs.
pub(super) fn renew(model: &mut Model) -> Vec<Effect> {
    match model.shown_bench().and_then(question) {
        Some(question) => begin_job(model, Work::Ask(question)),
        None => Vec::new(),
    }
}

/// Has something done for the shown tab, beside the solver. Only the newest job is worked on: another tab that waits
/// asks again when it is turned to.
pub(super) fn begin_job(model: &mut Model, work: Work) -> Vec<Effect> {
    let generation = model.next_generation();
    let Some(bench) = &mut model.bench else { return Vec::new() };
    if !bench.ask.waits(bench.tab) {
        stop(bench);
    }
    bench.ask.awaited = Some((generation, bench.tab));
    vec![Effect::Ask(Job { generation, work })]
}

/// Gives up the job that is under way, and what was found before it; the tab that waited.
pub(super) fn stop(bench: &mut Bench) -> Option<Tab> {
    let (_, tab) = bench.ask.awaited.take()?;
    bench.ask.forget(tab);
    Some(tab)
}

/// The tab is turned to: it asks what it has no answer to. What nobody has chosen there is the input under the cursor
/// of the form, or the first one, and an answer that may change with it.
pub(super) fn turn_to(model: &mut Model) -> Vec<Effect> {
    let Some(bench) = &mut model.bench else { return Vec::new() };
    let tab = bench.tab;
    if let (Some(line), Ok(record)) = (bench.form.line(), bench.form.draft.read(&bench.entry.shape())) {
        let inputs = vary::inputs(&record);
        let here = inputs.iter().find(|input| is_within(&input.path, &line.path)).or(inputs.first());
        let here = here.map_or_else(String::new, |input| input.path.clone());
        let begins = match tab {
            Tab::Sensitivity => Some(&mut bench.ask.sensitivity.begins),
            Tab::Study => Some(&mut bench.ask.study.begins),
            _ => None,
        };
        if begins.is_some_and(|begins| std::mem::replace(begins, here.clone()) != here) {
            bench.ask.forget(tab);
        }
    }
    if bench.ask.is_answered(tab) || bench.ask.waits(tab) { Vec::new() } else { renew(model) }
}

/// Takes what was found.
pub(super) fn take(model: &mut Model, outcome: Outcome) {
    let Some(bench) = &mut model.bench else { return };
    let Some((_, tab)) = bench.ask.awaited.take_if(|(number, _)| *number == outcome.generation) else {
        return;
    };
    match outcome.reply {
        Some(Reply::Slips(slips)) => bench.ask.check.slips = Some(slips),
        Some(Reply::Sensitivity(found)) => bench.ask.sensitivity.found = Some(found),
        Some(Reply::Study(found)) => bench.ask.study.found = Some(*found),
        // A fault of the program: what was asked has no answer.
        None => {
            let failed = SolveError::from(Refusal::because("failed (internal error)"));
            match tab {
                Tab::Sensitivity => bench.ask.sensitivity.found = Some(Err(failed)),
                Tab::Study => bench.ask.study.found = Some(Err(failed)),
                _ => bench.ask.check.slips = Some(Vec::new()),
            }
        }
    }
    // What is said of a wrong answer is read to its end.
    if (tab, bench.tab) == (Tab::Check, Tab::Check) {
        let cursor = bench.ask.check.cursor;
        bring_in(model, cursor);
    }
}

/// The inputs are others: what was found for them counts no more.
pub(super) fn forget(bench: &mut Bench) {
    bench.ask.awaited = None;
    bench.ask.check.praised = false;
    for tab in [Tab::Check, Tab::Sensitivity, Tab::Study] {
        bench.ask.forget(tab);
    }
}

fn question(bench: &Bench) -> Option<Question> {
    if bench.is_stale() || bench.found.state != State::Current {
        return None;
    }
    let solution = bench.found.solution.as_ref()?;
    let record = || bench.form.draft.read(&bench.entry.shape()).ok();
    match bench.tab {
        Tab::Check => {
            let check = &bench.ask.check;
            let is_wrong =
                |(name, _): &(String, String)| check.verdict(solution, name) == Some(Verdict::Wrong);
            if check.slips.is_some() || !check.typed.iter().any(is_wrong) {
                return None;
            }
            Some(Question::Slips {
                entry: bench.entry,
                record: record()?,
                solution: Box::new(solution.clone()),
                typed: check.typed.clone(),
            })
        }
        Tab::Sensitivity => {
            let sensitivity = &bench.ask.sensitivity;
            let (answers, at) = sensitivity.answers(solution);
            Some(Question::Sensitivity {
                entry: bench.entry,
                record: record()?,
                answer: answers.get(at)?.name.to_string(),
                tolerances: sensitivity.widths(&bench.subject()?.inputs),
            })
        }
        Tab::Study => {
            let of = bench.subject()?;
            let plan = bench.ask.study.plan(&of, &bench.ask.sensitivity.widths(&of.inputs)).ok()?;
            Some(Question::Study { entry: bench.entry, record: record()?, plan })
        }
        _ => None,
    }
}

/// Chooses another answer, or what stands beside in the cell under the cursor.
fn choose(model: &mut Model, by: isize) -> Vec<Effect> {
    let Some(bench) = &mut model.bench else { return Vec::new() };
    let Some(solution) = &bench.found.solution else { return Vec::new() };
    match bench.tab {
        Tab::Sensitivity => {
            let sensitivity = &mut bench.ask.sensitivity;
            let (answers, at) = sensitivity.answers(solution);
            let at = ask::turned(at, by, answers.len());
            sensitivity.answer = answers.get(at).map(|answer| answer.name.to_string());
            sensitivity.found = None;
        }
        Tab::Study => {
            let Ok(record) = bench.form.draft.read(&bench.entry.shape()) else { return Vec::new() };
            let study = &mut bench.ask.study;
            let subject = study.subject(&record, solution);
            study.choose(study.cell(), by, &subject);
            study.found = None;
        }
        _ => return Vec::new(),
    }
    renew(model)
}

/// Begins to type in the cell under the cursor, in its text or in an empty one.
fn begin(model: &mut Model, text: Option<String>) -> bool {
    let Some(bench) = &mut model.bench else { return false };
    let old = match bench.cell() {
        Some(CellOf::Answer(name)) => bench.ask.check.text(&name).to_owned(),
        Some(CellOf::Tolerance(path)) => bench.ask.sensitivity.text(&path).to_owned(),
        Some(CellOf::Study(cell)) if !cell.is_choice() => bench.ask.study.text(cell).to_owned(),
        _ => return false,
    };
    let text = text.unwrap_or(old);
    bench.ask.edit = Some(Input::new(text.chars().take(form::LONGEST).collect()));
    true
}

fn step(model: &mut Model, by: isize) {
    let Some(bench) = &mut model.bench else { return };
    let (tab, ask) = (bench.tab, &bench.ask);
    let of = match tab {
        Tab::Sensitivity => ask.sensitivity.sorted().len(),
        Tab::Study => ask.study.cells().len(),
        _ => bench.found.solution.as_ref().map_or(0, |solution| solution.answers.len()),
    };
    let Some(cursor) = bench.part_mut(tab) else { return };
    *cursor = cursor.saturating_add_signed(by).min(of.saturating_sub(1));
    let cursor = *cursor;
    bring_in(model, cursor);
}

/// Shows our answer under the cursor, or covers it again.
fn show_ours(model: &mut Model) {
    let Some(bench) = &mut model.bench else { return };
    let Some(name) = answer_under_cursor(bench) else { return };
    let seen = &mut bench.ask.check.seen;
    if !seen.remove(&name) {
        seen.insert(name);
    }
}

fn answer_under_cursor(bench: &Bench) -> Option<String> {
    match bench.cell()? {
        CellOf::Answer(name) => Some(name),
        CellOf::Tolerance(_) | CellOf::Study(_) => None,
    }
}

/// Says once that what is asked for is right, which is remembered of a published case.
fn praise(model: &mut Model) -> Vec<Effect> {
    let Some(bench) = model.bench.as_mut().filter(|bench| bench.tab == Tab::Check) else {
        return Vec::new();
    };
    let Some(solution) = bench.found.solution.as_ref().filter(|_| !bench.is_stale()) else {
        return Vec::new();
    };
    let names: Vec<String> = solution.answers.iter().map(|answer| answer.name.to_string()).collect();
    // Of a published case, what it asks for; of other problems, everything.
    let asked = bench.origin.as_ref().filter(|case| case.draft == bench.form.draft);
    let asked = asked.map(|case| case.expect.iter().map(|one| one.answer.as_str()));
    let wanted: Vec<&str> = match asked {
        Some(asked) => asked.filter(|name| names.iter().any(|known| known == name)).collect(),
        None => names.iter().map(String::as_str).collect(),
    };
    if wanted.is_empty() || !bench.ask.check.is_right(solution, &wanted) {
        return Vec::new();
    }
    if std::mem::replace(&mut bench.ask.check.praised, true) {
        return Vec::new();
    }
    model.say("all required answers are correct");
    remember_done(model)
}
