//! Update of the model: messages in, effects out.
//!
//! A message and a key lead to [`Intent`]s. The files beside this one answer with them and do not call each other:
//! what they want of one another is an intent, and [`carry_out`] is the one place that carries it out.

mod bench;
mod cells;
mod closing;
mod dialog;
mod edit;
mod export;
mod field;
mod files;
mod form;
mod mouse;
mod pane;
mod parts;
mod picker;
mod plans;
mod problems;
mod settings;

use std::path::PathBuf;

use dalembert_core::{Draft, Entry, Text};
use ratatui::crossterm::event::{KeyCode, KeyEvent, KeyModifiers};
use tui_input::{Input, InputRequest};

use crate::{
    dialog::{After, Dialog, Purpose},
    effect::Effect,
    form::{self as inputs, Sign},
    intent::Intent,
    keys::{self, Action, Key, KeyContext},
    model::{Model, Msg, Notice, Screen, gives_way},
    pane::{Pane, Tab, Ui},
    problem::{Freshness, Problem},
    solver::{Job, JobFailure, JobOutcome, Work},
    text_entry::TextEntry,
    view,
};

/// The first effects: a file or an analysis to begin with, if there is one.
pub fn start(model: &mut Model, file: Option<PathBuf>, analysis: Option<&'static Entry>) -> Vec<Effect> {
    picker::begin(model);
    model.picker.typing = true;
    let first = match (file, analysis) {
        (Some(path), _) => Intent::Do(Effect::Open(path)),
        (None, Some(entry)) => Intent::OpenCase(entry, 0),
        (None, None) => Intent::Preview,
    };
    let first = if model.field.is_some() && !matches!(first, Intent::Do(_)) {
        field::begin(model)
    } else {
        vec![first]
    };
    let effects = carry_out(model, first);
    model.translate_for_bench();
    effects
}

/// Changes the model by what happened, and says what is to be done outside of it.
pub fn update(model: &mut Model, msg: Msg) -> Vec<Effect> {
    let intents = take(model, msg);
    let mut effects = carry_out(model, intents);
    model.translate_for_bench();
    // A path is asked for: what is there stands below it.
    if let Some(Dialog::Prompt { purpose, input, names, .. }) = &mut model.dialog
        && purpose.is_path()
        && !names.is_trying()
    {
        effects.extend(names.wanted(input.value()).map(Effect::List));
    }
    effects
}

/// Does what is intended, one after the other, and what that leads to before the next.
fn carry_out(model: &mut Model, intents: Vec<Intent>) -> Vec<Effect> {
    let mut effects = Vec::new();
    let mut next = intents;
    next.reverse();
    while let Some(intent) = next.pop() {
        let mut more = match intent {
            Intent::Do(effect) => {
                effects.push(effect);
                continue;
            }
            Intent::Say(text) => {
                model.say(text);
                continue;
            }
            Intent::Complain(text) => {
                model.report_error(text);
                continue;
            }
            Intent::Refuse => {
                model.after_save = After::Stay;
                model.report_error("not saved: the program is read-only");
                continue;
            }
            Intent::Show(dialog) => {
                model.dialog = Some(dialog);
                continue;
            }
            Intent::Press(place, action) => act(model, place, action),
            Intent::Key(key) => press(model, key),
            Intent::Changed => changed(model),
            Intent::Keep => keep(model),
            Intent::GoToInput(path) => form::go_to(model, &path),
            Intent::GoToMissing => form::go_to_missing(model),
            Intent::AskUsual(question) => form::ask_usual(model, &question),
            Intent::TakeTable(path, text) => form::take_table(model, &path, text),
            Intent::Import(typed) => form::import(model, &typed),
            Intent::ReplaceTable(field, text) => form::replace_table(model, &field, text),
            Intent::Rename(title) => bench::rename(model, &title),
            Intent::ShowPart(at) => parts::show(model, at),
            Intent::BringResults => parts::bring_results(model),
            Intent::BeginProblem(words) => parts::begin_problem(model, &words),
            Intent::LinkProblem(name, entry) => parts::link_problem(model, &name, entry),
            Intent::BeginConfiguration(name) => parts::begin_configuration(model, &name),
            Intent::Turn(tab) => bench::show_tab(model, tab),
            Intent::TurnTo(name) => bench::show_named(model, name),
            Intent::EndEdit => cells::end_edit(model),
            Intent::GoToPart(part) => pane::go_to_part(model, part),
            Intent::BringIn(part) => pane::bring_in(model, part),
            Intent::Scroll(tab, by) => pane::scroll(model, tab, by),
            Intent::Ask => cells::ask(model),
            Intent::Await(work) => cells::begin_job(model, work),
            Intent::Mark(marker) => pane::mark(model, marker),
            Intent::OpenCase(entry, case) => open_case(model, entry, case, false),
            Intent::OpenExercise(entry, case) => open_case(model, entry, case, true),
            Intent::OpenBlank(entry) => open_blank(model, entry),
            Intent::Open(problem) => problems::open(model, *problem),
            Intent::Replace(problem) => problems::replace(model, *problem),
            Intent::Bring(number) => problems::bring(model, number),
            Intent::NextProblem => problems::next(model),
            Intent::Leave(after) => closing::leave(model, after),
            Intent::SaveThen(after) => closing::save_then(model, after),
            Intent::Discard(after) => closing::discard(model, after),
            Intent::Close => dialog::close(model),
            Intent::Save => files::save(model),
            Intent::SaveAs(path) => files::save_as(model, path),
            Intent::Overwrite(path) => files::overwrite(model, path),
            Intent::AskPath(Purpose::SaveAs) => files::ask_path(model),
            Intent::AskPath(purpose @ (Purpose::SavePlan | Purpose::OpenPlan)) => {
                plans::ask_path(model, purpose)
            }
            Intent::Export(Purpose::SavePlan, path, before) => plans::write(model, path, before),
            Intent::AskPath(purpose) => export::ask_path(model, purpose),
            Intent::Export(purpose, path, before) => export::write(model, purpose, path, before),
            Intent::ReadLinked => files::read_linked(model),
            Intent::FollowLinks => files::follow_links(model),
            Intent::Opened(path, opened) => files::opened(model, path, Ok(opened)),
            Intent::Restore(sessions) => files::restore(model, sessions),
            Intent::EditOutside => edit::begin(model),
            Intent::List => picker::return_to_list(model),
            Intent::Preview => picker::preview(model),
            Intent::Remember(change) => picker::remember(model, change),
            Intent::Reach(progress) => problems::reach(model, progress),
        };
        more.reverse();
        next.append(&mut more);
    }
    effects
}

fn take(model: &mut Model, msg: Msg) -> Vec<Intent> {
    match msg {
        Msg::Key(key) => {
            model.notice = None;
            return press(model, key);
        }
        Msg::Paste(text) => return paste(model, &text),
        Msg::Solved(outcome) => {
            let mut intents = solved(model, outcome);
            intents.push(Intent::Ask);
            return intents;
        }
        Msg::Asked(outcome) => return cells::answered(model, outcome),
        Msg::Mouse(event) => return mouse::happened(model, event),
        Msg::Edited { file, result } => return edit::edited(model, file, result),
        Msg::FileChanged { path, result } => return edit::changed_on_disk(model, &path, result),
        Msg::Saved { path, text, result } => return files::saved(model, &path, text, result),
        Msg::Exported { path, result } => return export::written(&path, result),
        Msg::Opened { path, result } => return files::opened(model, path, result),
        Msg::LinkedRead(problem, links) => return files::linked_read(model, problem, links),
        Msg::PlanSaved { path, text, result } => return plans::saved(model, path, text, result),
        Msg::PlanRead { path, result } => return plans::read(model, path, result),
        Msg::TableRead { field, path, result, sample } => {
            return form::table_read(model, &field, &path, result, sample);
        }
        Msg::Crashed(sessions) => return files::crashed(model, sessions),
        Msg::Faulty(files) => settings::faulty(model, &files),
        Msg::Resize(columns, rows) => model.size = (columns, rows),
        Msg::Progress(percentage) => model.progress = percentage,
        Msg::CheckedCase(id, checked) => {
            if let Some(listing) = model.listings.iter_mut().find(|listing| listing.entry.about.id == id) {
                listing.checked = Some(checked.clone());
            }
            for bench in model.problems_mut().filter(|bench| bench.problem.entry().about.id == id) {
                bench.problem.cases.clone_from(&checked);
            }
        }
        Msg::Tick => {
            for pane in model.bench.iter_mut().flat_map(|bench| &mut bench.panes) {
                if let Some(frame) = pane.frame() {
                    *frame = frame.wrapping_add(1);
                }
            }
        }
        Msg::Listed(folder, found) => {
            if let Some(Dialog::Prompt { names, .. }) = &mut model.dialog {
                names.take(&folder, found);
            }
        }
        Msg::Trouble(error) => model.report_error(error.text()),
        Msg::Notice(text) => model.report_error(Text::new("{text}").with("text", text)),
    }
    Vec::new()
}

/// A key: a character where it is text, or else what it means in its place.
fn press(model: &mut Model, key: KeyEvent) -> Vec<Intent> {
    let place = model.place();
    let sign = model.bench.as_mut().and_then(|bench| bench.problem.inputs.form.sign.take());
    // Such a character never is a key: the settings refuse it.
    if let (KeyCode::Char(character), KeyContext::Form, true) =
        (key.code, place, Key::of(key).begins_a_number())
    {
        return begin_number(model, character, sign);
    }
    match model.keys.action(place, key) {
        Some(action @ Action::Nudge(_)) if place == KeyContext::Form => form::nudge(model, key, action),
        Some(action) => act(model, place, action),
        None if keys::is_escape_and(key) && !(place.is_text() && request(key).is_some()) => {
            let second = KeyEvent { modifiers: key.modifiers.difference(KeyModifiers::ALT), ..key };
            vec![Intent::Key(KeyCode::Esc.into()), Intent::Key(second)]
        }
        None => match (place, key.code) {
            (place, KeyCode::Char(character)) if place.has_cells() => {
                cells::begin_by_typing(model, character, request(key))
            }
            (KeyContext::Job, KeyCode::Char(character)) => field::by_digit(model, character),
            (KeyContext::Sheet, _) => {
                dialog::edit_sheet(model, key);
                Vec::new()
            }
            _ if place.is_text() => request(key).map_or_else(Vec::new, |request| type_in(model, &[request])),
            _ => Vec::new(),
        },
    }
}

/// A digit on a field of numbers begins a new text, with the sign that was typed just before.
fn begin_number(model: &mut Model, character: char, sign: Option<Sign>) -> Vec<Intent> {
    let decimal = model.locale.style.decimal;
    let Some(bench) = &mut model.bench else { return Vec::new() };
    if let Some(why) = bench.problem.inputs.form.hindrance() {
        return Intent::say(why);
    }
    if bench.problem.inputs.form.begin_number(character, sign, decimal) {
        vec![Intent::Changed]
    } else {
        form::instead_of_number(model)
    }
}

/// Does what a key of a place means: first what it means everywhere, then in a problem, then in its place.
fn act(model: &mut Model, place: KeyContext, action: Action) -> Vec<Intent> {
    if let Some(intents) = everywhere(model, action) {
        return intents;
    }
    match place {
        KeyContext::Picker | KeyContext::Filter => return picker::act(model, action),
        KeyContext::List | KeyContext::Prompt | KeyContext::Sheet | KeyContext::Help => {
            return dialog::act(model, action);
        }
        KeyContext::Job | KeyContext::JobText => return field::act(model, action),
        _ => {}
    }
    if let Some(intents) = bench::act(model, place, action) {
        return intents;
    }
    match place {
        KeyContext::Form => form::act(model, action),
        KeyContext::Edit => form::act_in_field(model, action),
        KeyContext::Cells | KeyContext::Plan => cells::act(model, action),
        KeyContext::Cell => cells::act_in_cell(model, action),
        _ => pane::act(model, action),
    }
}

/// Does what a key means everywhere.
fn everywhere(model: &mut Model, action: Action) -> Option<Vec<Intent>> {
    Some(match action {
        Action::Quit => {
            // What is being typed counts.
            if let Some(bench) = &mut model.bench {
                bench.problem.inputs.form.keep();
            }
            vec![Intent::Close, Intent::Leave(After::Quit)]
        }
        Action::Suspend => vec![Intent::Do(Effect::Suspend)],
        Action::Redraw => vec![Intent::Do(Effect::Redraw)],
        Action::Help if model.dialog.is_none() => vec![Intent::Show(Dialog::help())],
        Action::Palette => vec![Intent::Show(Dialog::palette())],
        Action::Language => {
            model.set_language(model.locale.language.next());
            Vec::new()
        }
        Action::NextProblem => vec![Intent::NextProblem],
        Action::CloseProblem => vec![Intent::Leave(After::Close)],
        Action::FieldMode => field::begin(model),
        Action::Theme => settings::ask_theme(model),
        Action::Mouse => settings::turn_mouse(model),
        Action::Open => vec![Intent::Show(Dialog::prompt(Purpose::Open, String::new()))],
        _ => return None,
    })
}

/// Lets the shown pane do something where it is seen.
fn with_shown<T>(
    model: &mut Model,
    does: impl FnOnce(&mut dyn Pane, &mut Problem, &Ui<'_>) -> T,
) -> Option<T> {
    let tab = model.bench.as_ref()?.tab;
    let area = view::area_of_shown(model).unwrap_or_default();
    model.with_pane(tab, area, does)
}

/// Opens a case of an analysis beside what is open; as an exercise its results are covered.
fn open_case(model: &Model, entry: &'static Entry, case: usize, is_exercise: bool) -> Vec<Intent> {
    let cases = model.cases_of(entry);
    let origin = cases.get(case).map(|checked| checked.case.clone());
    let draft = origin.as_ref().map_or_else(|| Draft::blank(&entry.shape()), |case| case.draft.clone());
    let mut problem = Problem::new(entry, String::new(), draft, cases);
    (problem.case, problem.document.origin) = (case, origin);
    problem.document.is_exercise = is_exercise;
    problem.found.revealed = is_exercise.then_some(0);
    vec![Intent::Open(Box::new(problem))]
}

/// Opens a problem of an analysis with every input empty: in place of one of it that nothing was done to, or else
/// beside what is open.
fn open_blank(model: &Model, entry: &'static Entry) -> Vec<Intent> {
    let shown = model.shown_bench().filter(|bench| bench.problem.entry().about.id == entry.about.id);
    let in_place = shown.is_some_and(gives_way);
    let problem = Problem::new(entry, String::new(), Draft::blank(&entry.shape()), model.cases_of(entry));
    let problem = Box::new(problem);
    let open = if in_place { Intent::Replace(problem) } else { Intent::Open(problem) };
    vec![open, Intent::GoToMissing]
}

/// The inputs are others now: they are read, and solved or found wrong; nothing older counts any more.
fn changed(model: &mut Model) -> Vec<Intent> {
    let generation = model.next_generation();
    let other = model.bench.as_ref().and_then(|bench| bench.problem.other_entry());
    let cases = other.map(|entry| model.cases_of(entry));
    let Some(bench) = &mut model.bench else { return Vec::new() };
    bench.forget();
    let problem = &mut bench.problem;
    if let Some(cases) = cases {
        problem.follow_entry(cases);
    }
    problem.found.failure = None;
    match problem.inputs.form.draft.read(&problem.entry().shape()) {
        Ok(record) => {
            problem.find_wrong(Vec::new());
            problem.found.state = Freshness::Solving(generation);
            let work = Work::Solve(problem.entry(), record);
            vec![Intent::Do(Effect::Solve(Job { generation, work })), Intent::Keep]
        }
        Err(errors) => {
            problem.find_wrong(errors);
            problem.found.state = Freshness::Unread;
            vec![Intent::Keep]
        }
    }
}

/// Keeps the problem against a crash.
fn keep(model: &Model) -> Vec<Intent> {
    let Some(bench) = model.bench.as_ref().filter(|_| !model.readonly) else { return Vec::new() };
    let problem = &bench.problem;
    if !problem.is_unsaved() {
        return vec![Intent::Do(Effect::Forget(problem.number))];
    }
    vec![Intent::Do(Effect::Keep {
        problem: problem.number,
        original: problem.document.file.as_ref().map(|file| file.path.clone()),
        text: problem.as_text(),
    })]
}

/// Takes the outcome of a job: of the newest of a problem, or of what is shown beside the list.
fn solved(model: &mut Model, outcome: JobOutcome) -> Vec<Intent> {
    if let Err(JobFailure::Fault(panic)) = &outcome.result {
        let text = "this analysis failed (internal error); your inputs are kept".into();
        model.notice = Some(Notice { text, detail: panic.clone(), wrong: true });
    }
    let pending = Freshness::Solving(outcome.generation);
    let Some(bench) = model.problems_mut().find(|bench| bench.problem.found.state == pending) else {
        return picker::solved(model, outcome);
    };
    let problem = &mut bench.problem;
    let number = problem.number;
    let before = problem.found.solution.as_ref().map(|solution| solution.warnings.clone());
    problem.found.state = Freshness::Current;
    match outcome.result {
        Ok(solution) => {
            let solution = solution.map(|solution| problem.in_its_units(solution));
            problem.found.solution = solution.or(problem.found.solution.take());
            problem.found.of = Some(problem.inputs.form.draft.clone());
            (problem.found.failure, problem.found.hidden) = (None, false);
        }
        Err(failure) => {
            problem.found.hidden |= !problem.is_near_the_solved();
            problem.found.failure = Some(failure);
        }
    }
    bench.panes.iter_mut().for_each(|pane| pane.restart());
    if !bench.tabs().contains(&bench.tab) {
        bench.tab = Tab::default();
    }
    // Of a part that is new there is something to see now.
    let is_new =
        bench.problem.found.solution.is_some() && bench.problem.inputs.form.part().name != bench.turned_to;
    // A new warning is reported where the results, the first pane, are not on the screen.
    let before = before.filter(|_| !view::shows(model, Tab::default()));
    let shown = model.shown_bench().map(|bench| &bench.problem).filter(|problem| problem.number == number);
    let found = shown.map(|problem| &problem.found).filter(|found| found.revealed.is_none());
    let warnings = found.and_then(|found| found.solution.as_ref()).map_or(&[][..], |found| &found.warnings);
    let new = before.and_then(|before| warnings.iter().find(|warning| !before.contains(warning)).cloned());
    // A page of field mode says it itself.
    let new = new.filter(|_| model.shown_bench().is_none_or(|bench| bench.field.is_none()));
    let said = |warning| Intent::Complain(Text::new("new warning: {warning}").with_text("warning", warning));
    let bring = (is_new && shown.is_some()).then_some(Intent::BringResults);
    new.map(said).into_iter().chain(bring).collect()
}

fn paste(model: &mut Model, text: &str) -> Vec<Intent> {
    if let Some(Dialog::Sheet(sheet)) = &mut model.dialog {
        sheet.insert(text);
        return Vec::new();
    }
    if model.place() == KeyContext::Form {
        return form::paste(model, text);
    }
    if !model.place().is_text() {
        return Vec::new();
    }
    let (line, cut) = inputs::as_line(text);
    if cut {
        model.report_error(form::too_long());
    }
    let requests: Vec<InputRequest> = line.chars().map(InputRequest::InsertChar).collect();
    type_in(model, &requests)
}

/// Types in the text that has the keys.
fn type_in(model: &mut Model, requests: &[InputRequest]) -> Vec<Intent> {
    // Every request is done, whatever those before it changed.
    let handle = |input: &mut Input| {
        let changes = requests.iter().filter_map(|request| input.handle(*request));
        changes.filter(|change| change.value).count() > 0
    };
    let enter = |entry: &mut TextEntry| {
        let is_full =
            entry.value().len() >= inputs::LONGEST && matches!(requests, [InputRequest::InsertChar(_)]);
        !is_full && requests.iter().filter(|request| entry.handle(**request)).count() > 0
    };
    match &mut model.dialog {
        Some(Dialog::Palette { input, chosen: first } | Dialog::Help { search: input, scroll: first }) => {
            if handle(input) {
                *first = 0;
            }
            return Vec::new();
        }
        Some(Dialog::Prompt { input, error, names, preview, .. }) => {
            if enter(input) {
                names.typed();
                (*error, *preview) = (None, None);
            }
            return Vec::new();
        }
        Some(_) => return Vec::new(),
        None => {}
    }
    if model.screen == Screen::Picker {
        let filter = &mut model.picker.filter;
        // Where a search is begun anyway, its key is no part of it.
        let begins = filter.value().is_empty() && matches!(requests, [InputRequest::InsertChar('/')]);
        if begins || !handle(filter) {
            return Vec::new();
        }
        (model.picker.chosen, model.picker.case) = (0, None);
        return vec![Intent::Preview];
    }
    let Some(bench) = &mut model.bench else { return Vec::new() };
    if let Some(field) = &mut bench.field {
        if enter(&mut field.input) {
            field.fault = None;
        }
        return Vec::new();
    }
    if let Some(entry) = &mut bench.edit {
        return if enter(entry) { cells::typed(model) } else { Vec::new() };
    }
    let form = &mut bench.problem.inputs.form;
    if !form.edit.as_mut().is_some_and(|edit| enter(&mut edit.input)) {
        return Vec::new();
    }
    form.typed(model.locale.style.decimal);
    vec![Intent::Changed]
}

/// Editing request of a key in a line of text.
fn request(key: KeyEvent) -> Option<InputRequest> {
    let control = key.modifiers.contains(KeyModifiers::CONTROL);
    let alt = key.modifiers.contains(KeyModifiers::ALT);
    Some(match key.code {
        KeyCode::Char('a') if control => InputRequest::GoToStart,
        KeyCode::Char('e') if control => InputRequest::GoToEnd,
        KeyCode::Char('b') if control => InputRequest::GoToPrevChar,
        KeyCode::Char('f') if control => InputRequest::GoToNextChar,
        KeyCode::Char('d') if control => InputRequest::DeleteNextChar,
        KeyCode::Char('h') if control => InputRequest::DeletePrevChar,
        KeyCode::Char('w') if control => InputRequest::DeletePrevWord,
        KeyCode::Char('u') if control => InputRequest::DeleteFromStart,
        KeyCode::Char('k') if control => InputRequest::DeleteTillEnd,
        KeyCode::Char('y') if control => InputRequest::Yank,
        KeyCode::Char('b') if alt => InputRequest::GoToPrevWord,
        KeyCode::Char('f') if alt => InputRequest::GoToNextWord,
        KeyCode::Char(character) if !control && !alt => InputRequest::InsertChar(character),
        KeyCode::Left if control || alt => InputRequest::GoToPrevWord,
        KeyCode::Right if control || alt => InputRequest::GoToNextWord,
        KeyCode::Left => InputRequest::GoToPrevChar,
        KeyCode::Right => InputRequest::GoToNextChar,
        KeyCode::Home => InputRequest::GoToStart,
        KeyCode::End => InputRequest::GoToEnd,
        KeyCode::Backspace if control || alt => InputRequest::DeletePrevWord,
        KeyCode::Backspace => InputRequest::DeletePrevChar,
        KeyCode::Delete if control => InputRequest::DeleteNextWord,
        KeyCode::Delete => InputRequest::DeleteNextChar,
        _ => return None,
    })
}
