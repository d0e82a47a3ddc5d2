//! What happens to the model: messages in, effects out.

mod ask;
mod bench;
mod closing;
mod dialog;
mod edit;
mod export;
mod files;
mod list;
mod mouse;
mod picker;
mod problems;
mod remembering;
mod scroll;
mod settings;
mod solve;

use std::path::PathBuf;

use dalembert_core::{Entry, Language, Text, cases};
use ratatui::crossterm::event::{KeyCode, KeyEvent, KeyModifiers};
use tui_input::{Input, InputRequest};

use self::remembering::remember;
pub use self::remembering::remember_done;
use crate::{
    bench::{Bench, State},
    dialog::{After, Dialog, Purpose},
    form,
    keys::{Action, Place},
    model::{Effect, Model, Msg, Notice, Screen},
    panes::sources::CheckedCase,
    solver::{Failure, Outcome},
};

/// The first effects: a file or an analysis to begin with, if there is one.
pub fn start(model: &mut Model, file: Option<PathBuf>, analysis: Option<&'static Entry>) -> Vec<Effect> {
    list::begin(model);
    let effects = match (file, analysis) {
        (Some(path), _) => vec![Effect::Open(path)],
        (None, Some(entry)) => open_case(model, entry, 0),
        (None, None) => list::preview(model),
    };
    model.translate_for_bench();
    effects
}

/// Changes the model by what happened, and says what is to be done outside of it.
pub fn update(model: &mut Model, msg: Msg) -> Vec<Effect> {
    let mut effects = take(model, msg);
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

fn take(model: &mut Model, msg: Msg) -> Vec<Effect> {
    match msg {
        Msg::Key(key) => {
            model.notice = None;
            press(model, key)
        }
        Msg::Paste(text) => paste(model, &text),
        Msg::Resize(columns, rows) => {
            model.size = (columns, rows);
            Vec::new()
        }
        Msg::Solved(outcome) => {
            let mut effects = solved(model, outcome);
            effects.extend(ask::renew(model));
            effects
        }
        Msg::Asked(outcome) => {
            ask::take(model, outcome);
            Vec::new()
        }
        Msg::CheckedCase(id, judged) => {
            if let Some(listing) = model.listings.iter_mut().find(|listing| listing.entry.about.id == id) {
                listing.judged = Some(judged.clone());
            }
            for bench in model.problems_mut().filter(|bench| bench.entry.about.id == id) {
                bench.cases.clone_from(&judged);
            }
            Vec::new()
        }
        Msg::Mouse(event) => mouse::happened(model, event),
        Msg::Edited { file, result } => edit::edited(model, file, result),
        Msg::FileChanged { path, result } => edit::changed_on_disk(model, &path, result),
        Msg::Tick => {
            if let Some(bench) = &mut model.bench {
                bench.frame = bench.frame.wrapping_add(1);
            }
            Vec::new()
        }
        Msg::Saved { path, text, result } => {
            let is_saved = result.is_ok();
            let mut effects = files::saved(model, &path, text, result);
            if is_saved {
                let after = std::mem::take(&mut model.after_save);
                effects.extend(closing::go_on(model, after));
            }
            effects
        }
        Msg::Exported { path, result } => export::written(model, &path, result),
        Msg::Opened { path, result } => files::opened(model, path, result),
        Msg::Listed(folder, found) => {
            if let Some(Dialog::Prompt { names, .. }) = &mut model.dialog {
                names.take(&folder, found);
            }
            Vec::new()
        }
        Msg::TableRead { field, result } => bench::table_read(model, &field, result),
        Msg::Crashed(sessions) => {
            files::crashed(model, sessions);
            Vec::new()
        }
        Msg::Trouble(error) => {
            model.complain(error.text());
            Vec::new()
        }
        Msg::Faulty(files) => {
            settings::faulty(model, &files);
            Vec::new()
        }
        Msg::Notice(text) => {
            model.complain(Text::new("{text}").with("text", text));
            Vec::new()
        }
    }
}

fn press(model: &mut Model, key: KeyEvent) -> Vec<Effect> {
    let place = model.place();
    let sign = model.bench.as_mut().and_then(|bench| bench.form.sign.take());
    match model.keys.action(place, key) {
        Some(action @ Action::Nudge(_)) if place == Place::Form => bench::nudge(model, key, action),
        Some(action) => act(model, place, action),
        None => match place {
            Place::Form => bench::begin_by_typing(model, key, sign),
            Place::Cells => ask::begin_by_typing(model, key),
            Place::Sheet => {
                dialog::edit_sheet(model, key);
                Vec::new()
            }
            Place::Filter | Place::Edit | Place::Prompt | Place::Cell => match request(key) {
                Some(request) => type_in(model, &[request]),
                None => Vec::new(),
            },
            _ => Vec::new(),
        },
    }
}

/// Does what a key of a place means.
fn act(model: &mut Model, place: Place, action: Action) -> Vec<Effect> {
    match action {
        Action::Quit => return quit(model),
        Action::Suspend => return vec![Effect::Suspend],
        Action::Redraw => return vec![Effect::Redraw],
        Action::Help if model.dialog.is_none() => model.dialog = Some(Dialog::Help { scroll: 0 }),
        Action::Palette => model.dialog = Some(Dialog::palette()),
        Action::Language => model.speak(match model.locale.language {
            Language::English => Language::Portuguese,
            Language::Portuguese => Language::English,
        }),
        Action::NextProblem => return problems::next(model),
        Action::CloseProblem => return closing::leave(model, After::Close),
        Action::Theme => settings::ask_theme(model),
        Action::Mouse => return settings::turn_mouse(model),
        Action::Open => {
            model.dialog = Some(Dialog::prompt(Purpose::Open, String::new()));
        }
        _ => {
            return match place {
                Place::Picker | Place::Filter => picker::act(model, action),
                Place::List | Place::Prompt | Place::Sheet | Place::Help => dialog::act(model, action),
                _ => bench::act(model, place, action),
            };
        }
    }
    Vec::new()
}

/// Ends the program, or asks what becomes of unsaved work.
fn quit(model: &mut Model) -> Vec<Effect> {
    // What is being typed counts.
    let mut effects = dialog::close(model);
    if let Some(bench) = &mut model.bench {
        bench.form.keep();
    }
    effects.extend(closing::leave(model, After::Quit));
    effects
}

/// Opens a case of an analysis beside what is open.
fn open_case(model: &mut Model, entry: &'static Entry, case: usize) -> Vec<Effect> {
    let cases = judged_later(model, entry);
    let origin = cases.get(case).map(|judged| judged.case.clone());
    let draft = match &origin {
        Some(case) => case.draft.clone(),
        None => dalembert_core::Draft::blank(&entry.shape()),
    };
    let mut bench = Bench::new(entry, String::new(), draft, cases);
    bench.case = case;
    bench.origin = origin;
    problems::open(model, bench)
}

/// The cases of an analysis, compared with what was printed if they were before.
fn judged_later(model: &Model, entry: &'static Entry) -> Vec<CheckedCase> {
    let known = model.listings.iter().find(|listing| listing.entry.about.id == entry.about.id);
    if let Some(judged) = known.and_then(|listing| listing.judged.clone()) {
        return judged;
    }
    let cases =
        known.map_or_else(|| cases::cases(entry).unwrap_or_default(), |listing| listing.cases().to_vec());
    cases.into_iter().map(|case| CheckedCase { case, verdicts: None }).collect()
}

fn solved(model: &mut Model, outcome: Outcome) -> Vec<Effect> {
    if let Err(Failure::Fault(panic)) = &outcome.result {
        let text = "this analysis failed (internal error); your inputs are kept".into();
        model.notice = Some(Notice { text, detail: panic.clone(), wrong: true });
    }
    let awaited = State::Solving(outcome.generation);
    let mut solved = model.problems_mut().find(|bench| bench.found.state == awaited);
    if let Some(bench) = &mut solved {
        let before = bench.found.solution.as_ref().map(|solution| solution.warnings.clone());
        solve::take(bench, outcome);
        let number = bench.number;
        solve::tell_hidden(model, number, before.as_deref());
        return Vec::new();
    }
    if let Some(preview) = &mut model.picker.preview
        && preview.generation == outcome.generation
    {
        preview.solution = outcome.result.ok().flatten();
        return list::judge(model);
    }
    Vec::new()
}

fn paste(model: &mut Model, text: &str) -> Vec<Effect> {
    if let Some(Dialog::Sheet(sheet)) = &mut model.dialog {
        sheet.insert(text);
        return Vec::new();
    }
    if model.place() == Place::Form {
        return bench::paste(model, text);
    }
    if !model.place().is_text() {
        return Vec::new();
    }
    let (line, cut) = form::as_line(text);
    if cut {
        model.complain(too_long());
    }
    let requests: Vec<InputRequest> = line.chars().map(InputRequest::InsertChar).collect();
    type_in(model, &requests)
}

fn too_long() -> Text {
    Text::new("pasted text truncated: a line takes at most {most} characters").with("most", form::LONGEST)
}

/// Types in the text that has the keys.
fn type_in(model: &mut Model, requests: &[InputRequest]) -> Vec<Effect> {
    let handle = |input: &mut Input| {
        let mut changed = false;
        for request in requests {
            changed |= input.handle(*request).is_some_and(|state| state.value);
        }
        changed
    };
    let in_cell = model.place() == Place::Cell;
    match &mut model.dialog {
        Some(Dialog::Palette { input, chosen }) => {
            if handle(input) {
                *chosen = 0;
            }
        }
        Some(Dialog::Prompt { input, proposed, error, names, .. }) => {
            if std::mem::take(proposed) && matches!(requests, [InputRequest::InsertChar(_), ..]) {
                input.reset();
            }
            if handle(input) {
                names.typed();
                *error = None;
            }
        }
        Some(_) => {}
        None if model.screen == Screen::Picker => {
            if handle(&mut model.picker.filter) {
                model.picker.chosen = 0;
                model.picker.case = None;
                return list::preview(model);
            }
        }
        None if in_cell => {
            if let Some(edit) = model.bench.as_mut().and_then(|bench| bench.ask.edit.as_mut())
                && (edit.value().len() < form::LONGEST || !matches!(requests, [InputRequest::InsertChar(_)]))
                && handle(edit)
            {
                return ask::typed(model);
            }
        }
        None => {
            if let Some(bench) = &mut model.bench
                && let Some(edit) = &mut bench.form.edit
                && (edit.input.value().len() < form::LONGEST
                    || !matches!(requests, [InputRequest::InsertChar(_)]))
                && handle(&mut edit.input)
            {
                bench.form.typed(model.locale.style.decimal);
                return solve::changed(model);
            }
        }
    }
    Vec::new()
}

/// What a key means in a line of text.
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
